#include "supervisor.h"

#include "drive_orders.h"
#include "faults.h"
#include "setpoints.h"
#include "states.h"
#include "transition.h"

static const tb_supervisor empty;
static const tb_outputs no_outputs;

void tb_supervisor_start(tb_supervisor *supervisor)
{
    *supervisor = empty;
    tb_order_task(supervisor, tb_all_drives, TB_TASK_RESET);
    tb_enter(supervisor, TB_STATE_INIT, TB_PHASE_NONE);
}

static bool is_intact(const tb_supervisor *supervisor)
{
    uint8_t const complement = (uint8_t)~supervisor->state;
    return (complement == supervisor->complement) && (supervisor->state <= TB_STATE_FAULT) &&
           tb_are_setpoints_intact(supervisor);
}

/* The first fault stands; a stop that was only asked for gives way to it. */
static void latch(tb_blame *first, tb_blame blame)
{
    if ((first->cause == TB_CAUSE_NONE) || (first->cause == TB_CAUSE_REQUESTED)) {
        *first = blame;
    }
}

static bool is_without_torque(tb_state state)
{
    return (state == TB_STATE_INIT) || (state == TB_STATE_IDENTIFY) ||
           (state == TB_STATE_CONFIGURE);
}

static bool is_at_work(tb_state state)
{
    return (state == TB_STATE_HOME) || (state == TB_STATE_TENSION) || (state == TB_STATE_RUN);
}

/* To the stop that a cause asks for; true when that changed the state. HARD_STOP and FAULT find no
 * hard causes. */
static bool react(tb_supervisor *supervisor, tb_blame blame)
{
    tb_state const state = (tb_state)supervisor->state;
    if (blame.cause == TB_CAUSE_NONE) {
        return false;
    }
    latch(&supervisor->first, blame);
    if (is_without_torque(state)) {
        tb_begin_fault(supervisor);
    } else if (tb_is_hard((tb_cause)blame.cause)) {
        tb_begin_hard_stop(supervisor);
    } else if (is_at_work(state)) {
        tb_begin_soft_stop(supervisor);
    } else {
        return false;
    }
    return true;
}

/* Nothing that is remembered can be trusted: no torque, and no heartbeat until the reset. */
static void give_up(tb_supervisor *supervisor)
{
    supervisor->damaged = 1;
    latch(&supervisor->first, tb_blame_for(TB_CAUSE_MEMORY, 0, supervisor->state));
    tb_begin_hard_stop(supervisor);
}

static void await_reset(tb_supervisor *supervisor, const tb_observation *seen)
{
    if ((seen->requests & ~supervisor->requests & TB_REQUEST_RESET) != 0) {
        tb_supervisor_start(supervisor);
    }
}

/* Before a state says what it wants: no torque, and positions as they are. */
static void want_nothing(tb_supervisor *supervisor)
{
    for (size_t i = 0; i < TB_DRIVES; i++) {
        tb_drive_memory *const drive = &supervisor->drives[i];
        drive->wanted.torque = 0;
        drive->wanted.position = drive->sent;
    }
    supervisor->outputs = no_outputs;
    for (size_t i = 0; i < TB_CABLES; i++) {
        supervisor->slack[i] = 0;
    }
}

static tb_blame run_state(tb_supervisor *supervisor, const tb_observation *seen)
{
    want_nothing(supervisor);
    supervisor->cycles++;
    switch (supervisor->state) {
    case TB_STATE_INIT:
        return tb_init(supervisor, seen);
    case TB_STATE_IDENTIFY:
        return tb_identify(supervisor, seen);
    case TB_STATE_CONFIGURE:
        return tb_configure(supervisor, seen);
    case TB_STATE_HOME:
        return tb_home(supervisor, seen);
    case TB_STATE_TENSION:
        return tb_tension(supervisor, seen);
    case TB_STATE_RUN:
        return tb_run(supervisor, seen);
    case TB_STATE_SOFT_STOP:
        return tb_soft_stop(supervisor, seen);
    case TB_STATE_HARD_STOP:
        tb_hard_stop(supervisor);
        return tb_no_blame();
    default:
        await_reset(supervisor, seen);
        return tb_no_blame();
    }
}

static tb_blame find_fault(tb_supervisor *supervisor, const tb_observation *seen)
{
    bool const is_over = supervisor->state >= TB_STATE_HARD_STOP;
    return is_over ? tb_no_blame() : tb_find_fault(supervisor, seen);
}

/* A stop begins in the cycle in which its cause is found, by the state itself or before it. */
static void run_cycle(tb_supervisor *supervisor, const tb_observation *seen)
{
    (void)react(supervisor, find_fault(supervisor, seen));
    if (react(supervisor, run_state(supervisor, seen))) {
        (void)run_state(supervisor, seen);
    }
}

/* A drive that cannot hear that it is to switch off, or does not obey, does so by itself when it
 * misses the heartbeat. */
static bool may_beat(const tb_supervisor *supervisor)
{
    bool const is_over = supervisor->state >= TB_STATE_HARD_STOP;
    bool const obeyed = tb_have_reached(supervisor, tb_all_drives);
    return (supervisor->damaged == 0) && (!is_over || obeyed);
}

static void tell(const tb_supervisor *supervisor, tb_orders *orders)
{
    orders->controller = supervisor->outputs;
    for (size_t i = 0; i < TB_CABLES; i++) {
        orders->slack[i] = supervisor->slack[i];
    }
    orders->beat = may_beat(supervisor) ? 1 : 0;
    orders->state = supervisor->state;
    orders->phase = supervisor->phase;
    orders->cause = supervisor->first.cause;
    orders->culprit = supervisor->first.culprit;
    orders->index = supervisor->first.index;
    orders->subindex = supervisor->first.subindex;
    orders->failure = supervisor->first.failure;
    orders->detail = supervisor->first.detail;
}

/* Until a base is guided nothing depends on where it is: its drive may count from any zero, and takes
 * another one in its homing. Its speed is watched all the same. */
static void measure(tb_supervisor *supervisor, const tb_observation *seen)
{
    tb_measurement_take(&supervisor->measurement, seen->drives, seen->missed);
    for (size_t i = TB_CABLES; i < TB_DRIVES; i++) {
        if (supervisor->guide.guided[i - TB_CABLES] == 0) {
            tb_measurement_rebase(&supervisor->measurement, i, &seen->drives[i]);
        }
    }
}

void tb_supervisor_step(tb_supervisor *supervisor, const tb_observation *seen, tb_orders *orders)
{
    if (!is_intact(supervisor)) {
        give_up(supervisor);
    }
    measure(supervisor, seen);
    tb_observe_power(supervisor, seen);
    run_cycle(supervisor, seen);
    tb_gate_setpoints(supervisor, seen, orders->drives);
    supervisor->requests = seen->requests;
    tell(supervisor, orders);
}
