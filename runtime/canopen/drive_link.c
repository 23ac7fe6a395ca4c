#include "drive_link.h"

#include "cia402.h"
#include "cob.h"
#include "little_endian.h"

/* A command acts at the next SYNC and shows after the one after that; one more may get lost. Until
 * then the homing bits are of the run before. */
#define HOMING_ANSWER_SYNCS 3u

static const tb_drive_link unknown;

static uint8_t count_up(uint8_t count)
{
    return (count < UINT8_MAX) ? (uint8_t)(count + 1u) : count;
}

void tb_drive_link_start(tb_drive_link *link, const tb_drive_table *drive)
{
    *link = unknown;
    link->drive = drive;
    tb_heartbeat_start(&link->heartbeat);
    tb_setup_start(&link->setup, drive);
}

/* ---- Messages of the drive ---- */

static void count_status(tb_drive_link *link, bool in_time)
{
    if (link->answered != 0) {
        link->duplicates += (link->duplicates < UINT32_MAX) ? 1 : 0;
    } else if (in_time) {
        link->fresh = 1;
        link->late = 0;
    } else {
        link->late = count_up(link->late);
        link->most_late = (link->late > link->most_late) ? link->late : link->most_late;
    }
    link->answered = 1;
    link->missed = 0;
}

/* From where the drive's position is counted. */
static void take_origin(tb_drive_link *link)
{
    if (link->setup.mode == TB_MODE_HOMING) {
        link->origin = 0;
    } else if (link->has_origin == 0) {
        link->origin = link->status.position;
    } else {
        /* it stays where it is */
    }
    link->has_origin = 1;
}

/* Before it is started a drive has nothing to say by PDO: what comes is of an earlier life. */
static bool take_status(tb_drive_link *link, const tb_can_frame *frame, bool in_time)
{
    if (link->setup.started == 0) {
        return true;
    }
    if (!tb_pdo_take(&link->status, frame)) {
        return false;
    }
    link->power = (uint8_t)tb_cia402_power(link->status.statusword);
    take_origin(link);
    count_status(link, in_time);
    return true;
}

/* A drive that has just booted has forgotten its emergencies. */
static bool take_error_control(tb_drive_link *link, const tb_can_frame *frame)
{
    static const tb_emcy none;
    bool const taken = tb_heartbeat_take(&link->heartbeat, frame);
    if (taken && (link->heartbeat.state == TB_NMT_BOOTED)) {
        link->emergency = none;
        link->booted = 1;
    }
    return taken;
}

bool tb_drive_link_take(tb_drive_link *link, const tb_can_frame *frame, bool in_time)
{
    switch (frame->id & TB_COB_FUNCTION_MASK) {
    case TB_COB_TPDO1:
        return take_status(link, frame, in_time);
    case TB_COB_EMCY:
        return tb_emcy_take(&link->emergency, link->drive->kind, frame);
    case TB_COB_SDO_ANSWER:
        return tb_sdo_take(&link->setup.sdo, frame);
    case TB_COB_ERROR_CONTROL:
        return take_error_control(link, frame);
    default:
        return link->setup.started == 0; /* a PDO that the contract switched off */
    }
}

/* ---- What is missing ---- */

void tb_drive_link_sync(tb_drive_link *link, bool is_synced)
{
    bool const homes = (link->controlword & TB_CONTROL_HOMING_START) != 0;
    if (is_synced) {
        link->answered = 0;
        link->homing_syncs = homes ? count_up(link->homing_syncs) : 0;
    }
}

static void count_missed(tb_drive_link *link)
{
    bool const is_due = (link->setup.operational != 0) && (link->answered == 0);
    link->missed = is_due ? count_up(link->missed) : link->missed;
}

static void forget_status(tb_drive_link *link)
{
    link->power = TB_POWER_UNKNOWN;
    link->has_origin = 0;
    link->origin = 0;
    link->controlword = 0;
    link->missed = 0;
    link->late = 0;
    link->most_late = 0;
}

/* A boot-up message tells that the drive is not operational, even where the heartbeat of a second one
 * with its number came after it. */
static bool is_heard(const tb_drive_link *link)
{
    return (link->booted == 0) && (link->heartbeat.age <= (uint32_t)TB_HEARTBEAT_TIMEOUT) &&
           (link->heartbeat.state == TB_NMT_OPERATIONAL);
}

static bool follows_bus(const tb_drive_link *link)
{
    return (link->setup.operational == 0) || ((link->status.statusword & TB_STATUS_REMOTE) != 0);
}

static tb_silence silence(const tb_drive_link *link)
{
    if (!is_heard(link)) {
        return TB_SILENCE_UNHEARD;
    }
    return follows_bus(link) ? TB_SILENCE_NONE : TB_SILENCE_LOCAL;
}

/* Sum and difference of counts modulo 2^32. */
static int32_t add_counts(int32_t count, int32_t more)
{
    return tb_signed_32((uint32_t)count + (uint32_t)more);
}

static int32_t subtract_counts(int32_t count, int32_t less)
{
    return tb_signed_32((uint32_t)count - (uint32_t)less);
}

static real_t position(const tb_drive_link *link)
{
    int32_t const distance = subtract_counts(link->status.position, link->origin);
    return (real_t)distance * link->drive->metres_per_increment;
}

static tb_homing homing(const tb_drive_link *link)
{
    if (link->homing_syncs == 0) {
        return TB_HOMING_IDLE;
    }
    return (link->homing_syncs < HOMING_ANSWER_SYNCS) ? TB_HOMING_RUNNING
                                                      : tb_cia402_homing(link->status.statusword);
}

static void report_status(const tb_drive_link *link, uint8_t age, tb_drive_report *report)
{
    report->position = position(link);
    report->torque = (real_t)link->status.torque * link->drive->torque_per_unit;
    report->statusword = link->status.statusword;
    report->error_code = link->emergency.code;
    report->error_class = link->emergency.error_class;
    report->power = link->power;
    report->homing = (uint8_t)homing(link);
    report->fresh = link->fresh;
    report->age = age;
    report->missed = link->missed;
    report->late = link->most_late;
    report->silent = (uint8_t)silence(link);
}

static void report_task(const tb_setup *setup, tb_drive_report *report)
{
    report->mode = setup->mode;
    report->task = setup->task;
    report->progress = setup->progress;
    report->failure = setup->failure;
    report->subindex = setup->subindex;
    report->index = setup->index;
    report->detail = setup->detail;
}

void tb_drive_link_report(tb_drive_link *link, uint8_t age, bool is_over, tb_drive_report *report)
{
    if (is_over) {
        count_missed(link);
    }
    if (link->setup.started == 0) {
        forget_status(link);
    }
    tb_heartbeat_tick(&link->heartbeat);
    tb_setup_advance(&link->setup, &link->heartbeat, link->fresh != 0);
    report_status(link, age, report);
    report_task(&link->setup, report);
    link->fresh = 0;
    link->most_late = link->late;
    link->booted = 0;
}

/* ---- Setpoints ---- */

static bool is_number(real_t value)
{
    return (value >= TB_C(0.0)) || (value < TB_C(0.0));
}

/* A number, towards zero and no further from it than the limit. */
static int32_t towards_zero(real_t value, real_t limit)
{
    return (int32_t)tb_min(tb_max(value, -limit), limit);
}

static bool follows(const tb_drive_link *link, const tb_drive_order *order, tb_mode mode)
{
    return (order->goal == TB_GOAL_ENABLED) && (link->setup.mode == mode);
}

static int16_t torque_units(const tb_drive_link *link, const tb_drive_order *order)
{
    real_t const wanted = order->torque * link->drive->units_per_torque;
    real_t const limit = (real_t)link->drive->most_torque_units;
    bool const pulls = follows(link, order, TB_MODE_TORQUE) && is_number(wanted);
    return pulls ? (int16_t)towards_zero(wanted, limit) : 0;
}

/* A drive that is not to move is asked to be where it is. */
static int32_t increments(const tb_drive_link *link, const tb_drive_order *order)
{
    real_t const wanted = order->position * link->drive->increments_per_metre;
    real_t const limit = TB_C(2147483520.0); /* the largest int32_t that is a float */
    bool const moves = follows(link, order, TB_MODE_POSITION) && is_number(wanted);
    return moves ? add_counts(link->origin, towards_zero(wanted, limit)) : link->status.position;
}

bool tb_drive_link_setpoint(tb_drive_link *link, const tb_drive_order *order, tb_can_frame *frame)
{
    uint8_t const node = link->drive->node;
    bool const homes = (order->home != 0) && (link->setup.mode == TB_MODE_HOMING);
    if (link->setup.operational == 0) {
        return false;
    }
    link->controlword = tb_cia402_controlword((tb_power)link->power, (tb_goal)order->goal, homes,
                                              link->controlword);
    *frame = (link->drive->mode == 1)
                 ? tb_pdo_position_frame(node, link->controlword, increments(link, order))
                 : tb_pdo_torque_frame(node, link->controlword, torque_units(link, order));
    return true;
}

bool tb_drive_link_acyclic(tb_drive_link *link, tb_can_frame *frame)
{
    return tb_setup_frame(&link->setup, &link->heartbeat, frame);
}
