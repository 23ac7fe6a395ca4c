/* The master's cycles on a board: on a grid of time, and fed to the watchdog. */
#ifndef TB_CYCLES_H
#define TB_CYCLES_H

#include <stdint.h>

#include "master.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A machine that runs on a board. */
typedef struct {
    tb_master master;
    int64_t begin;   /* ns, of the next cycle */
    uint32_t missed; /* cycles that could not begin in time, since the last one */
} tb_cycles;

/** Begin in INIT, one period from now. */
void tb_cycles_start(tb_cycles *cycles, tb_fieldbus *fieldbus);

/** Wait for the next cycle and run it. */
void tb_cycles_run(tb_cycles *cycles);

#ifdef __cplusplus
}
#endif

#endif
