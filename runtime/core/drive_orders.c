#include "drive_orders.h"

static const tb_drive_memory *memory_of(const tb_supervisor *supervisor, size_t drive)
{
    return &supervisor->drives[drive];
}

bool tb_follows_position(size_t drive)
{
    return tb_drives[drive].mode != 0;
}

tb_mode tb_working_mode(size_t drive)
{
    return tb_follows_position(drive) ? TB_MODE_POSITION : TB_MODE_TORQUE;
}

/* An order of this cycle acts at the bus's next SYNC and shows in the answer to the one after that;
 * the first of them may be divider - 1 cycles away. */
static uint8_t cycles_to_show(size_t drive)
{
    uint8_t const divider = tb_buses[tb_drives[drive].bus].divider;
    return (uint8_t)((3 * divider) - 1);
}

void tb_order_goal(tb_supervisor *supervisor, tb_drive_range drives, tb_goal goal)
{
    for (size_t i = drives.first; i < drives.end; i++) {
        tb_drive_memory *const drive = &supervisor->drives[i];
        if (drive->wanted.goal != (uint8_t)goal) {
            drive->wanted.goal = (uint8_t)goal;
            drive->patience = cycles_to_show(i);
            drive->reached = 0;
        }
    }
}

void tb_order_task(tb_supervisor *supervisor, tb_drive_range drives, tb_task task)
{
    for (size_t i = drives.first; i < drives.end; i++) {
        supervisor->drives[i].wanted.task = (uint8_t)task;
    }
}

void tb_order_mode(tb_supervisor *supervisor, size_t drive, tb_mode mode)
{
    supervisor->drives[drive].wanted.mode = (uint8_t)mode;
    supervisor->drives[drive].wanted.task = TB_TASK_MODE;
}

void tb_order_homing(tb_supervisor *supervisor, size_t drive, bool run)
{
    supervisor->drives[drive].wanted.home = run ? 1 : 0;
}

bool tb_is_power_of(tb_goal goal, tb_power power)
{
    if (goal == TB_GOAL_ENABLED) {
        return power == TB_POWER_ENABLED;
    }
    return (power == TB_POWER_NOT_READY) || (power == TB_POWER_OFF) || (power == TB_POWER_READY) ||
           (power == TB_POWER_FAULT);
}

void tb_observe_power(tb_supervisor *supervisor, const tb_observation *seen)
{
    for (size_t i = 0; i < TB_DRIVES; i++) {
        tb_drive_memory *const drive = &supervisor->drives[i];
        if (drive->patience > 0) {
            drive->patience--;
        } else if (tb_is_power_of((tb_goal)drive->wanted.goal, (tb_power)seen->drives[i].power)) {
            drive->reached = 1;
        }
    }
}

bool tb_have_reached(const tb_supervisor *supervisor, tb_drive_range drives)
{
    bool reached = true;
    for (size_t i = drives.first; i < drives.end; i++) {
        reached = reached && (memory_of(supervisor, i)->reached != 0);
    }
    return reached;
}

tb_blame tb_blame_stuck(const tb_supervisor *supervisor, const tb_observation *seen,
                        tb_drive_range drives)
{
    size_t stuck = drives.first;
    while ((stuck + 1 < drives.end) && (memory_of(supervisor, stuck)->reached != 0)) {
        stuck++;
    }
    return tb_blame_for(TB_CAUSE_DRIVE_STUCK, stuck, seen->drives[stuck].statusword);
}

static bool has_done(const tb_drive_order *wanted, const tb_drive_report *report)
{
    bool const in_mode = (wanted->task != TB_TASK_MODE) || (report->mode == wanted->mode);
    return (report->task == wanted->task) && (report->progress == TB_TASK_DONE) && in_mode;
}

bool tb_have_done(const tb_supervisor *supervisor, const tb_observation *seen,
                  tb_drive_range drives)
{
    bool done = true;
    for (size_t i = drives.first; i < drives.end; i++) {
        done = done && has_done(&memory_of(supervisor, i)->wanted, &seen->drives[i]);
    }
    return done;
}

static tb_cause cause_of(tb_task task, tb_failure failure)
{
    if (failure == TB_FAILURE_TWICE) {
        return TB_CAUSE_DRIVE_TWICE;
    }
    if (task == TB_TASK_RESET) {
        return TB_CAUSE_DRIVE_MISSING;
    }
    if (task == TB_TASK_IDENTIFY) {
        return (failure == TB_FAILURE_SILENT) ? TB_CAUSE_DRIVE_MISSING : TB_CAUSE_DRIVE_DIFFERENT;
    }
    return TB_CAUSE_DRIVE_SETUP;
}

static tb_blame blame_task(size_t drive, const tb_drive_report *report)
{
    tb_cause const cause = cause_of((tb_task)report->task, (tb_failure)report->failure);
    tb_blame blame = tb_blame_for(cause, drive, report->detail);
    blame.index = report->index;
    blame.subindex = report->subindex;
    blame.failure = report->failure;
    return blame;
}

tb_blame tb_find_failed_task(const tb_supervisor *supervisor, const tb_observation *seen,
                             tb_drive_range drives)
{
    for (size_t i = drives.first; i < drives.end; i++) {
        const tb_drive_report *const report = &seen->drives[i];
        bool const is_about_it = report->task == memory_of(supervisor, i)->wanted.task;
        if (is_about_it && (report->progress == TB_TASK_FAILED)) {
            return blame_task(i, report);
        }
    }
    return tb_no_blame();
}

/* First of some drives that has not done its task; call it when there is one. */
static size_t first_undone(const tb_supervisor *supervisor, const tb_observation *seen,
                           tb_drive_range drives)
{
    size_t drive = drives.first;
    while ((drive + 1 < drives.end) &&
           tb_have_done(supervisor, seen, (tb_drive_range){drive, drive + 1})) {
        drive++;
    }
    return drive;
}

tb_blame tb_await_mode(const tb_supervisor *supervisor, const tb_observation *seen,
                       tb_drive_range drives, bool *switched)
{
    *switched = tb_have_done(supervisor, seen, drives);
    tb_blame const blame = tb_find_failed_task(supervisor, seen, drives);
    if ((blame.cause == TB_CAUSE_NONE) && !*switched && (supervisor->cycles > TB_STATE_TIMEOUT)) {
        size_t const stuck = first_undone(supervisor, seen, drives);
        return tb_blame_for(TB_CAUSE_DRIVE_STUCK, stuck, seen->drives[stuck].statusword);
    }
    return blame;
}

tb_blame tb_await_power(const tb_supervisor *supervisor, const tb_observation *seen,
                        tb_drive_range drives, bool *reached)
{
    *reached = tb_have_reached(supervisor, drives);
    if (!*reached && (supervisor->cycles > TB_STATE_TIMEOUT)) {
        return tb_blame_stuck(supervisor, seen, drives);
    }
    return tb_no_blame();
}

void tb_power_on(tb_supervisor *supervisor, tb_drive_range drives)
{
    tb_order_task(supervisor, drives, TB_TASK_NONE);
    tb_order_goal(supervisor, drives, TB_GOAL_ENABLED);
}
