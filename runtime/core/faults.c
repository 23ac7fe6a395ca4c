#include "faults.h"

#include "drive_orders.h"

/* The measured torque lags behind the commanded torque, and the drive filters the measurement. The two
 * may differ by DEAF_SHARE of the drive's torque limit; a larger difference is a fault after
 * DEAF_CYCLES cycles in a row. */
#define DEAF_SHARE TB_C(0.125)
#define DEAF_CYCLES 100u

#define SOFT false
#define HARD true
#define REACTION(name, culprit, reaction, words, advice) [TB_CAUSE_##name] = reaction,

static const bool hard[] = {TB_CAUSES(REACTION)};

bool tb_is_hard(tb_cause cause)
{
    return (cause < TB_CAUSE_COUNT) && hard[cause];
}

bool tb_is_in_fault(const tb_drive_report *report)
{
    return (report->power == TB_POWER_FAULT) || (report->power == TB_POWER_FAULT_REACTION) ||
           (report->error_class >= TB_ERROR_FAULT);
}

static bool is_silent(const tb_drive_report *report)
{
    return (report->silent != 0) || (report->missed > TB_MISSED_LIMIT);
}

tb_blame tb_blame_silent(const tb_drive_report *report, size_t index)
{
    bool const is_local =
        (report->silent == TB_SILENCE_LOCAL) && (report->missed <= TB_MISSED_LIMIT);
    return is_local ? tb_blame_for(TB_CAUSE_DRIVE_LOCAL, index, report->statusword)
                    : tb_blame_for(TB_CAUSE_DRIVE_SILENT, index, report->missed);
}

/* Out of the ordered power state, or in another mode than the one it works in. */
static bool has_left(const tb_drive_memory *drive, const tb_drive_report *report)
{
    if (report->power == TB_POWER_UNKNOWN) {
        return true;
    }
    if (drive->reached == 0) {
        return false;
    }
    bool const has_power = tb_is_power_of((tb_goal)drive->wanted.goal, (tb_power)report->power);
    bool const follows = drive->wanted.goal == TB_GOAL_ENABLED;
    return !has_power || (follows && (report->mode != drive->wanted.mode));
}

/* A drive that is to switch off gives no torque meanwhile. */
static bool obeys(const tb_drive_memory *drive, const tb_drive_report *report, real_t limit)
{
    bool const works = (drive->reached != 0) && (drive->wanted.goal == TB_GOAL_ENABLED);
    bool const lingers = (drive->wanted.goal == TB_GOAL_OFF) && (report->power == TB_POWER_ENABLED);
    bool const follows = (works || lingers) && (report->mode == TB_MODE_TORQUE);
    return !follows || (TB_ABS(report->torque - drive->sent) <= DEAF_SHARE * limit);
}

static void count_deaf_cycles(tb_supervisor *supervisor, const tb_observation *seen)
{
    for (size_t i = 0; i < TB_DRIVES; i++) {
        tb_drive_memory *const drive = &supervisor->drives[i];
        real_t const limit = (i < TB_CABLES) ? TB_TORQUE_LIMIT : TB_RAIL_TORQUE_LIMIT;
        bool const is_deaf = !obeys(drive, &seen->drives[i], limit);
        drive->deaf = is_deaf ? (uint16_t)(drive->deaf + 1) : 0;
    }
}

static tb_cause find_runaway(const tb_supervisor *supervisor, size_t drive)
{
    real_t const speed = TB_ABS(tb_measured_speed(&supervisor->measurement, drive));
    if (drive < TB_CABLES) {
        return (speed > TB_CABLE_SPEED_LIMIT) ? TB_CAUSE_RUNAWAY : TB_CAUSE_NONE;
    }
    return (speed > TB_RAIL_SPEED_LIMIT) ? TB_CAUSE_BASE_RUNAWAY : TB_CAUSE_NONE;
}

/* Bases that follow a torque are told it, others tell it. */
static tb_cause look_at_carriage(tb_supervisor *supervisor, const tb_drive_report *report,
                                 size_t rail)
{
    size_t const drive = TB_CABLES + rail;
    const tb_drive_memory *const base = &supervisor->drives[drive];
    real_t const torque = tb_follows_position(drive) ? report->torque : base->sent;
    if ((supervisor->guide.guided[rail] == 0) || (base->reached == 0) ||
        !tb_carriage_is_pushed(torque)) {
        tb_carriage_rest(&supervisor->carriages[rail]);
        return TB_CAUSE_NONE;
    }
    tb_carriage_motion const motion = {
        .position = tb_measured_position(&supervisor->measurement, drive),
        .speed = tb_measured_speed(&supervisor->measurement, drive),
        .torque = torque,
    };
    return tb_carriage_look(&supervisor->carriages[rail], &motion);
}

static tb_blame examine_carriages(tb_supervisor *supervisor, const tb_observation *seen)
{
    tb_blame worst = tb_no_blame();
    for (size_t i = TB_CABLES; i < TB_DRIVES; i++) {
        tb_cause const cause = look_at_carriage(supervisor, &seen->drives[i], i - TB_CABLES);
        if ((cause != TB_CAUSE_NONE) && (worst.cause == TB_CAUSE_NONE)) {
            worst = tb_blame_for(cause, i, 0);
        }
    }
    return worst;
}

/* Faults from before are reset once all drives are in service: which of them came first is chance. */
static bool are_faults_reset(const tb_supervisor *supervisor)
{
    return (supervisor->phase == TB_PHASE_START) || (supervisor->phase == TB_PHASE_FAULT_RESET);
}

/* What leaves no time. */
static tb_blame examine_drive(const tb_supervisor *supervisor, const tb_observation *seen,
                              size_t index)
{
    const tb_drive_report *const report = &seen->drives[index];
    if (tb_is_in_fault(report) && !are_faults_reset(supervisor)) {
        return tb_blame_for(TB_CAUSE_DRIVE_FAULT, index, report->error_code);
    }
    if (is_silent(report)) {
        return tb_blame_silent(report, index);
    }
    if (has_left(&supervisor->drives[index], report)) {
        return tb_blame_for(TB_CAUSE_DRIVE_STATE, index, report->statusword);
    }
    if (supervisor->drives[index].deaf > DEAF_CYCLES) {
        return tb_blame_for(TB_CAUSE_DRIVE_DEAF, index, 0);
    }
    if (supervisor->measurement.tracks[index].jumped != 0) {
        return tb_blame_for(TB_CAUSE_ENCODER_JUMP, index, 0);
    }
    return tb_blame_for(find_runaway(supervisor, index), index, 0);
}

static tb_blame examine_drives(const tb_supervisor *supervisor, const tb_observation *seen)
{
    for (size_t i = 0; i < TB_DRIVES; i++) {
        if (supervisor->drives[i].online != 0) {
            tb_blame const blame = examine_drive(supervisor, seen, i);
            if (blame.cause != TB_CAUSE_NONE) {
                return blame;
            }
        }
    }
    return tb_no_blame();
}

static tb_blame find_late_drive(const tb_supervisor *supervisor, const tb_observation *seen)
{
    for (size_t i = 0; i < TB_DRIVES; i++) {
        if ((supervisor->drives[i].online != 0) && (seen->drives[i].late > TB_MISSED_LIMIT)) {
            return tb_blame_for(TB_CAUSE_DRIVE_LATE, i, seen->drives[i].late);
        }
    }
    return tb_no_blame();
}

static tb_blame find_lost_bus(const tb_observation *seen)
{
    for (size_t i = 0; i < TB_BUSES; i++) {
        if (seen->buses[i].state >= TB_BUS_OFF) {
            return tb_blame_for(TB_CAUSE_BUS_OFF, i, seen->buses[i].state);
        }
    }
    return tb_no_blame();
}

/* Cycles with malformed frames weigh two SYNCs, a clean cycle takes one cycle off: what comes again
 * and again adds up, what comes now and then does not. */
static bool is_corrupt(uint16_t *weight, uint8_t divider, bool malformed)
{
    uint16_t const weight_of_sync = (uint16_t)(2 * divider);
    uint16_t const limit = (uint16_t)(TB_MISSED_LIMIT * weight_of_sync);
    if (malformed) {
        *weight = (uint16_t)(((*weight < limit) ? *weight : limit) + weight_of_sync);
    } else if (*weight > 0) {
        *weight = (uint16_t)(*weight - 1);
    }
    return *weight > limit;
}

static tb_blame examine_bus(tb_supervisor *supervisor, const tb_bus_report *bus, size_t index)
{
    bool const malformed = bus->malformed != 0;
    bool const corrupt =
        is_corrupt(&supervisor->corrupt[index], tb_buses[index].divider, malformed);
    supervisor->spoiled[index] = ((supervisor->spoiled[index] != 0) || malformed) ? 1 : 0;
    if (bus->stranger >= TB_STRANGER_MASTER) {
        return tb_blame_for(TB_CAUSE_OTHER_MASTER, index,
                            (uint32_t)bus->stranger - TB_STRANGER_MASTER);
    }
    if (bus->stranger != 0) {
        return tb_blame_for(TB_CAUSE_STRANGER, index, bus->stranger);
    }
    if (corrupt) {
        return tb_blame_for(TB_CAUSE_BUS_CORRUPT, index, bus->malformed);
    }
    return (bus->refused != 0) ? tb_blame_for(TB_CAUSE_BUS_FULL, index, bus->refused)
                               : tb_no_blame();
}

/* In INIT a bus may be without any drive that takes frames. */
static tb_blame examine_buses(tb_supervisor *supervisor, const tb_observation *seen)
{
    tb_blame worst = tb_no_blame();
    for (size_t i = 0; i < TB_BUSES; i++) {
        tb_blame const blame = examine_bus(supervisor, &seen->buses[i], i);
        bool const counts =
            (supervisor->state != TB_STATE_INIT) || (blame.cause != TB_CAUSE_BUS_FULL);
        worst = (counts && (worst.cause == TB_CAUSE_NONE)) ? blame : worst;
    }
    return worst;
}

/* Nobody looks for faults after SOFT_STOP. */
static bool may_have_torque(const tb_supervisor *supervisor)
{
    return supervisor->state >= TB_STATE_HOME;
}

static tb_blame find_soft_fault(tb_supervisor *supervisor, const tb_observation *seen)
{
    tb_blame blame = examine_buses(supervisor, seen);
    if (blame.cause == TB_CAUSE_NONE) {
        blame = find_late_drive(supervisor, seen);
    }
    if ((blame.cause == TB_CAUSE_NONE) && may_have_torque(supervisor)) {
        if (seen->missed > TB_SKIPPED_LIMIT) {
            blame = tb_blame_for(TB_CAUSE_CYCLES_MISSED, 0, seen->missed);
        } else if ((seen->requests & TB_REQUEST_STOP) != 0) {
            blame = tb_blame_for(TB_CAUSE_REQUESTED, 0, 0);
        }
    }
    return blame;
}

tb_blame tb_find_fault(tb_supervisor *supervisor, const tb_observation *seen)
{
    count_deaf_cycles(supervisor, seen);
    tb_blame const carriage = examine_carriages(supervisor, seen);
    tb_blame blame = find_lost_bus(seen);
    if (blame.cause == TB_CAUSE_NONE) {
        blame = examine_drives(supervisor, seen);
    }
    if (blame.cause == TB_CAUSE_NONE) {
        blame = carriage;
    }
    tb_blame const soft = find_soft_fault(supervisor, seen);
    return (blame.cause == TB_CAUSE_NONE) ? soft : blame;
}
