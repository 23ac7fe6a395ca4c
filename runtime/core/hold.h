/* What states have in common that hold cables and bases without a controller. */
#ifndef TB_HOLD_H
#define TB_HOLD_H

#include "supervisor_memory.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Want a tension [N] of a cable. */
void tb_pull(tb_supervisor *supervisor, size_t cable, real_t tension);

/** Want T_min of every cable. */
void tb_hold_cables(tb_supervisor *supervisor);

/** Want every guided base to go to its target [m] (TB_RAIL_SLOTS) at `speed` [m/s] at most. */
tb_blame tb_guide_bases(tb_supervisor *supervisor, const real_t targets[TB_RAIL_SLOTS],
                        real_t speed);

/** Want every guided base to stay at its reference. */
tb_blame tb_hold_bases(tb_supervisor *supervisor);

#ifdef __cplusplus
}
#endif

#endif
