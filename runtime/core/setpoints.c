#include "setpoints.h"

#include "drive_orders.h"
#include "torque_gate.h"

static const tb_gate_limits torque_limits = {.low = -TB_RAIL_TORQUE_LIMIT,
                                             .high = TB_RAIL_TORQUE_LIMIT,
                                             .step = TB_RAIL_TORQUE_STEP,
                                             .safe = TB_C(0.0),
                                             .rest = TB_C(0.0)};

/* A drive that follows a position rests where it is. */
static tb_gate_limits position_limits(size_t drive, real_t position)
{
    static const real_t lengths[TB_RAIL_SLOTS] = TB_RAIL_LENGTHS;
    real_t const length = lengths[drive - TB_CABLES];
    real_t const here = tb_min(tb_max(position, TB_C(0.0)), length);
    return (tb_gate_limits){.low = TB_C(0.0),
                            .high = length,
                            .step = TB_RAIL_SPEED_LIMIT * TB_PERIOD,
                            .safe = here,
                            .rest = here};
}

static tb_gate_limits limits_of(const tb_supervisor *supervisor, size_t drive)
{
    if (drive < TB_CABLES) {
        return tb_cable_limits;
    }
    if (!tb_follows_position(drive)) {
        return torque_limits;
    }
    return position_limits(drive, tb_measured_position(&supervisor->measurement, drive));
}

/* A drive that may not follow its setpoint is also in one of the faults of faults.c, which stops all
 * drives. */
static tb_permission permission_of(const tb_drive_order *wanted, const tb_drive_report *report,
                                   tb_mode working_mode)
{
    if (report->power != TB_POWER_ENABLED) {
        return TB_PERMIT_NOTHING;
    }
    bool const is_ordered = (wanted->goal == TB_GOAL_ENABLED) && (wanted->mode == working_mode);
    bool const is_ready = (report->mode == working_mode) && (report->missed <= TB_MISSED_LIMIT);
    return (is_ordered && is_ready) ? TB_PERMIT_COMMAND : TB_PERMIT_REST;
}

static void gate_drive(tb_supervisor *supervisor, const tb_observation *seen, size_t index,
                       tb_drive_order *order)
{
    tb_drive_memory *const drive = &supervisor->drives[index];
    tb_gate_limits const limits = limits_of(supervisor, index);
    tb_permission const permission =
        permission_of(&drive->wanted, &seen->drives[index], tb_working_mode(index));
    *order = drive->wanted;
    if (tb_follows_position(index)) {
        (void)tb_gate(&limits, permission, drive->sent, order->position, &drive->sent);
        order->position = drive->sent;
        order->torque = 0;
    } else {
        (void)tb_gate(&limits, permission, drive->sent, order->torque, &drive->sent);
        order->torque = drive->sent;
        order->position = 0;
    }
}

void tb_gate_setpoints(tb_supervisor *supervisor, const tb_observation *seen,
                       tb_drive_order orders[TB_DRIVES])
{
    for (size_t i = 0; i < TB_DRIVES; i++) {
        gate_drive(supervisor, seen, i, &orders[i]);
    }
}

bool tb_are_setpoints_intact(const tb_supervisor *supervisor)
{
    uint32_t flags = TB_GATE_PASSED;
    for (size_t i = 0; i < TB_DRIVES; i++) {
        tb_gate_limits const limits = limits_of(supervisor, i);
        real_t unused;
        flags |= tb_gate(&limits, TB_PERMIT_REST, supervisor->drives[i].sent, 0, &unused);
    }
    return (flags & TB_GATE_BAD_PREVIOUS) == 0;
}
