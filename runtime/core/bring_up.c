#include "drive_orders.h"
#include "faults.h"
#include "states.h"
#include "transition.h"

/* Most that a drive's task can take: every object is written and read, each time the request waits
 * for its turn, then for its answer; some are repeated; it starts, perhaps twice. A task ends by
 * itself before that; this is for one that does not. */
static uint32_t longest_task(const tb_drive_table *drive)
{
    uint32_t const objects = (uint32_t)drive->identity_count + (uint32_t)drive->contract_count;
    uint32_t const transfers = (2u * objects) + TB_MOST_REPEATS;
    return (transfers * 2u * (uint32_t)TB_ANSWER_TIMEOUT) + (3u * (uint32_t)TB_STATE_TIMEOUT);
}

static tb_blame blame_endless(const tb_supervisor *supervisor, const tb_observation *seen)
{
    for (size_t i = 0; i < TB_DRIVES; i++) {
        bool const done = tb_have_done(supervisor, seen, (tb_drive_range){i, i + 1});
        if (!done && (supervisor->cycles > longest_task(&tb_drives[i]))) {
            tb_blame blame = tb_blame_for(TB_CAUSE_DRIVE_MISSING, i, 0);
            blame.failure = TB_FAILURE_SILENT;
            return blame;
        }
    }
    return tb_no_blame();
}

/* The drives' task in this state: why it failed, else whether all have done it. */
static tb_blame await_task(const tb_supervisor *supervisor, const tb_observation *seen, bool *done)
{
    tb_blame const failed = tb_find_failed_task(supervisor, seen, tb_all_drives);
    *done = tb_have_done(supervisor, seen, tb_all_drives);
    return (failed.cause == TB_CAUSE_NONE) ? blame_endless(supervisor, seen) : failed;
}

/* A drive may well have answered on a bus that delivers what cannot be read. */
static tb_blame suspect_bus(const tb_supervisor *supervisor, tb_blame blame)
{
    uint8_t const bus = tb_drives[blame.culprit].bus;
    if ((blame.cause != TB_CAUSE_DRIVE_MISSING) || (supervisor->spoiled[bus] == 0)) {
        return blame;
    }
    return tb_blame_for(TB_CAUSE_BUS_CORRUPT, bus, 1);
}

tb_blame tb_init(tb_supervisor *supervisor, const tb_observation *seen)
{
    bool done;
    tb_blame const blame = await_task(supervisor, seen, &done);
    if (done) {
        tb_order_task(supervisor, tb_all_drives, TB_TASK_IDENTIFY);
        tb_enter(supervisor, TB_STATE_IDENTIFY, TB_PHASE_NONE);
    }
    return suspect_bus(supervisor, blame);
}

tb_blame tb_identify(tb_supervisor *supervisor, const tb_observation *seen)
{
    bool done;
    tb_blame const blame = await_task(supervisor, seen, &done);
    if (done) {
        tb_order_task(supervisor, tb_all_drives, TB_TASK_CONFIGURE);
        tb_enter(supervisor, TB_STATE_CONFIGURE, TB_PHASE_CONTRACT);
    }
    return suspect_bus(supervisor, blame);
}

static tb_blame write_contract(tb_supervisor *supervisor, const tb_observation *seen)
{
    bool done;
    tb_blame const blame = await_task(supervisor, seen, &done);
    if (done) {
        tb_order_task(supervisor, tb_all_drives, TB_TASK_START);
        tb_enter(supervisor, TB_STATE_CONFIGURE, TB_PHASE_START);
    }
    return blame;
}

/* A drive is judged from its first status message on. */
static bool are_online(tb_supervisor *supervisor, const tb_observation *seen)
{
    bool online = true;
    for (size_t i = 0; i < TB_DRIVES; i++) {
        const tb_drive_report *const report = &seen->drives[i];
        bool const speaks = (report->fresh != 0) && (report->silent == 0);
        supervisor->drives[i].online = supervisor->drives[i].online || speaks;
        online = online && (supervisor->drives[i].online != 0);
    }
    return online;
}

static tb_blame blame_offline(const tb_supervisor *supervisor, const tb_observation *seen)
{
    size_t silent = 0;
    while ((silent + 1 < TB_DRIVES) && (supervisor->drives[silent].online != 0)) {
        silent++;
    }
    return tb_blame_silent(&seen->drives[silent], silent);
}

static tb_blame start_drives(tb_supervisor *supervisor, const tb_observation *seen)
{
    bool done;
    tb_blame blame = await_task(supervisor, seen, &done);
    if (done && are_online(supervisor, seen)) {
        tb_order_task(supervisor, tb_all_drives, TB_TASK_NONE);
        tb_order_goal(supervisor, tb_all_drives, TB_GOAL_FAULT_RESET);
        tb_enter(supervisor, TB_STATE_CONFIGURE, TB_PHASE_FAULT_RESET);
    } else if (done && (supervisor->cycles > TB_STATE_TIMEOUT)) {
        blame = blame_offline(supervisor, seen);
    }
    return blame;
}

static tb_blame find_drive_in_fault(const tb_observation *seen)
{
    for (size_t i = 0; i < TB_DRIVES; i++) {
        if (tb_is_in_fault(&seen->drives[i])) {
            return tb_blame_for(TB_CAUSE_DRIVE_FAULT, i, seen->drives[i].error_code);
        }
    }
    return tb_no_blame();
}

static tb_blame reset_faults(tb_supervisor *supervisor, const tb_observation *seen)
{
    tb_blame const fault = find_drive_in_fault(seen);
    bool const reached = tb_have_reached(supervisor, tb_all_drives);
    if (reached && (fault.cause == TB_CAUSE_NONE)) {
        tb_order_goal(supervisor, tb_all_drives, TB_GOAL_OFF);
        tb_enter(supervisor, TB_STATE_CONFIGURE, TB_PHASE_READY);
    } else if (supervisor->cycles > TB_STATE_TIMEOUT) {
        return (fault.cause == TB_CAUSE_NONE) ? tb_blame_stuck(supervisor, seen, tb_all_drives)
                                              : fault;
    }
    return tb_no_blame();
}

/* The request must appear while everything is ready; one that stood before does not arm. */
static tb_blame await_arm(tb_supervisor *supervisor, const tb_observation *seen)
{
    bool const appeared = (seen->requests & ~supervisor->requests & TB_REQUEST_ARM) != 0;
    bool const stopped = (seen->requests & TB_REQUEST_STOP) != 0;
    if (tb_have_reached(supervisor, tb_all_drives)) {
        if (appeared && !stopped) {
            supervisor->first = tb_no_blame();
            tb_begin_home(supervisor);
        }
    } else if (supervisor->cycles > TB_STATE_TIMEOUT) {
        return tb_blame_stuck(supervisor, seen, tb_all_drives);
    }
    return tb_no_blame();
}

tb_blame tb_configure(tb_supervisor *supervisor, const tb_observation *seen)
{
    switch (supervisor->phase) {
    case TB_PHASE_CONTRACT:
        return write_contract(supervisor, seen);
    case TB_PHASE_START:
        return start_drives(supervisor, seen);
    case TB_PHASE_FAULT_RESET:
        return reset_faults(supervisor, seen);
    default:
        return await_arm(supervisor, seen);
    }
}
