#include "cycles.h"

#include "board.h"

#define PERIOD ((int64_t)(((double)TB_PERIOD * 1e9) + 0.5))       /* ns */
#define COMPUTE_PHASE ((int64_t)TB_COMPUTE_PHASE * (int64_t)1000) /* ns */

void tb_cycles_start(tb_cycles *cycles, tb_fieldbus *fieldbus)
{
    tb_master_start(&cycles->master, fieldbus);
    cycles->begin = tb_board_time() + PERIOD;
    cycles->missed = 0;
}

/* Sleep until the next cycle that can still begin in time; the supervisor judges how many may be left
 * out. */
static void await_cycle(tb_cycles *cycles)
{
    tb_board_sleep_until(cycles->begin);
    int64_t late = tb_board_time() - cycles->begin;
    cycles->missed = 0;
    while (late > PERIOD / 4) {
        int64_t const skipped = 1 + ((late - 1) / PERIOD);
        cycles->missed += (uint32_t)skipped;
        cycles->begin += skipped * PERIOD;
        tb_board_sleep_until(cycles->begin);
        late = tb_board_time() - cycles->begin;
    }
}

void tb_cycles_run(tb_cycles *cycles)
{
    tb_wishes wishes;
    await_cycle(cycles);
    tb_master_sync(&cycles->master);
    tb_board_sleep_until(cycles->begin + COMPUTE_PHASE);
    tb_board_wish(&wishes);
    tb_master_run(&cycles->master, &wishes, cycles->missed);
    tb_board_tell(&cycles->master);
    if (cycles->master.supervisor.damaged == 0) {
        tb_board_feed();
    }
    cycles->begin += PERIOD;
}
