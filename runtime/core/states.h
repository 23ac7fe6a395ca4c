/* The states' steps: each runs one cycle of its state, changes what the drives shall do, goes on to
 * the next phase or state by itself, and answers what went wrong, if anything. */
#ifndef TB_STATES_H
#define TB_STATES_H

#include "supervisor_memory.h"

#ifdef __cplusplus
extern "C" {
#endif

/* bring_up.c: INIT, IDENTIFY, CONFIGURE */
tb_blame tb_init(tb_supervisor *supervisor, const tb_observation *seen);
tb_blame tb_identify(tb_supervisor *supervisor, const tb_observation *seen);
tb_blame tb_configure(tb_supervisor *supervisor, const tb_observation *seen);

/* direction.c: HOME, until every encoder's direction is known */
void tb_begin_directions(tb_supervisor *supervisor);
tb_blame tb_try_directions(tb_supervisor *supervisor, const tb_observation *seen);

/* homing.c: HOME, until the bases know where they are */
void tb_begin_home(tb_supervisor *supervisor);
void tb_begin_bases(tb_supervisor *supervisor);
tb_blame tb_home(tb_supervisor *supervisor, const tb_observation *seen);

/* sweep.c: HOME, until the cables' lengths are known */
void tb_begin_sweep(tb_supervisor *supervisor);
tb_blame tb_sweep(tb_supervisor *supervisor);

/* work.c: TENSION, RUN */
void tb_begin_tension(tb_supervisor *supervisor);
tb_blame tb_tension(tb_supervisor *supervisor, const tb_observation *seen);
tb_blame tb_run(tb_supervisor *supervisor, const tb_observation *seen);

/* stopping.c: SOFT_STOP, HARD_STOP, FAULT */
void tb_begin_soft_stop(tb_supervisor *supervisor);
tb_blame tb_soft_stop(tb_supervisor *supervisor, const tb_observation *seen);
void tb_begin_hard_stop(tb_supervisor *supervisor);
void tb_hard_stop(tb_supervisor *supervisor);
void tb_begin_fault(tb_supervisor *supervisor);

#ifdef __cplusplus
}
#endif

#endif
