#include "loop.h"

#include <stddef.h>

#include "publish.h"
#include "stop.h"
#include "tb_machine.h"

/* A stop takes TB_STOP_CYCLES, and then the drives' time to go off; twice that is too long. */
#define LONGEST_STOP (2u * (uint64_t)(TB_STOP_CYCLES + TB_STATE_TIMEOUT))

/* The grid of the cycles [ns]. */
typedef struct {
    int64_t period;
    int64_t phase;   /* from SYNC to reading the answers */
    int64_t begin;   /* of the cycle that is next */
    uint32_t missed; /* cycles skipped before it */
} tb_grid;

static tb_grid begin_grid(const tb_clock *clock)
{
    tb_grid grid = {
        .period = (int64_t)(((double)TB_PERIOD * (double)TB_SECOND) + 0.5),
        .phase = (int64_t)TB_COMPUTE_PHASE * 1000,
    };
    grid.begin = tb_clock_now(clock) + grid.period;
    return grid;
}

/* Sleep until the next cycle that can still begin in time; the time at which it does. */
static int64_t await_cycle(tb_clock *clock, tb_grid *grid, tb_loop_times *times)
{
    tb_clock_sleep_until(clock, grid->begin);
    int64_t now = tb_clock_now(clock);
    tb_histogram_add(&times->lateness, now - grid->begin);
    grid->missed = 0;
    while (now - grid->begin > grid->period / 4) {
        int64_t const skipped = 1 + ((now - grid->begin - 1) / grid->period);
        grid->missed += (uint32_t)skipped;
        grid->begin += skipped * grid->period;
        tb_clock_sleep_until(clock, grid->begin);
        now = tb_clock_now(clock);
    }
    times->missed += grid->missed;
    times->longest_gap = (grid->missed > times->longest_gap) ? grid->missed : times->longest_gap;
    grid->begin += grid->period;
    return now;
}

static bool is_stop_wished(const tb_loop *loop)
{
    uint64_t const cycles = loop->options->cycles;
    return (tb_stop_wished() > 0) || ((cycles > 0) && (loop->number >= cycles));
}

/* --arm asks until the machine leaves CONFIGURE, and never again: a request is an edge. */
static uint32_t arm_once(tb_loop *loop)
{
    uint8_t const state = loop->master->orders.state;
    loop->armed = loop->armed || (state > TB_STATE_CONFIGURE);
    bool const asks = loop->options->arm && !loop->armed && (state == TB_STATE_CONFIGURE);
    return (asks && ((loop->number % 2u) == 0u)) ? TB_REQUEST_ARM : 0u;
}

static void wish(tb_loop *loop, tb_wishes *wishes)
{
    tb_inbox_read(&loop->inbox, &loop->telemetry->inbox, wishes);
    wishes->requests = tb_reopen(&loop->reopening, loop->master->orders.state, wishes->requests);
    if (is_stop_wished(loop)) {
        wishes->requests = TB_REQUEST_STOP;
        loop->stopping++;
    } else {
        wishes->requests |= arm_once(loop);
    }
}

static void run_cycle(tb_loop *loop, tb_grid *grid)
{
    int64_t const began = await_cycle(loop->clock, grid, &loop->times);
    tb_master_sync(loop->master);
    tb_clock_sleep_until(loop->clock, began + grid->phase);
    if (loop->clock->stopped) {
        return; /* no answers have come, and none will */
    }
    int64_t const woke = tb_clock_now(loop->clock);
    tb_wishes wishes;
    wish(loop, &wishes);
    tb_master_run(loop->master, &wishes, grid->missed);
    tb_record_tell(loop->record, &loop->master->recorder);
    tb_histogram_add(&loop->times.computing, tb_clock_now(loop->clock) - woke);
    tb_publish(loop, began);
    if (loop->master->supervisor.damaged == 0) {
        tb_watchdog_feed(&loop->watchdog);
    }
    loop->number++;
}

static bool is_off(const tb_drive_report *drive)
{
    return (drive->power != TB_POWER_ON) && (drive->power != TB_POWER_ENABLED) &&
           (drive->power != TB_POWER_QUICK_STOP) && (drive->power != TB_POWER_FAULT_REACTION);
}

static bool is_at_rest(const tb_master *master)
{
    uint8_t const state = master->orders.state;
    bool rest = (state <= TB_STATE_CONFIGURE) || (state == TB_STATE_FAULT);
    for (size_t i = 0; i < TB_DRIVES; i++) {
        rest = rest && is_off(&master->seen.drives[i]);
    }
    return rest;
}

tb_end tb_loop_run(tb_loop *loop)
{
    tb_grid grid = begin_grid(loop->clock);
    tb_watchdog_ready(&loop->watchdog);
    while ((loop->stopping == 0) || !is_at_rest(loop->master)) {
        if (tb_stop_wished() > 1) {
            return TB_END_AT_ONCE;
        }
        if (loop->stopping > LONGEST_STOP) {
            return TB_END_NOT_OFF;
        }
        if (loop->clock->stopped) {
            return TB_END_NO_TIME;
        }
        run_cycle(loop, &grid);
    }
    tb_watchdog_stopping(&loop->watchdog);
    return (tb_stop_wished() > 1) ? TB_END_AT_ONCE : TB_END_OFF;
}
