/* Guide: moves bases along references of its own, while no controller does.
 *
 * Every base has a reference, which goes to its target no faster than it is told to; a torque drive
 * follows it by the machine's tb_base_pid, a position drive by itself. */
#ifndef TB_GUIDE_H
#define TB_GUIDE_H

#include <stdbool.h>
#include <stddef.h>

#include "controller.h"
#include "tb_drives.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What moves the bases. */
typedef struct {
    real_t reference[TB_RAIL_SLOTS];             /* m */
    real_t base[TB_RAIL_SLOTS * TB_BASE_MEMORY]; /* rows: see tb_base_pid */
    uint16_t lagging[TB_RAIL_SLOTS];             /* cycles in a row too far from the reference */
    uint8_t guided[TB_RAIL_SLOTS];               /* 1 once a base is guided */
} tb_guide;

/** Guide no base. */
void tb_guide_start(tb_guide *guide);

/** From now on guide a base, which is at `position` [m] and rests. */
void tb_guide_take(tb_guide *guide, size_t rail, real_t position);

/** One cycle of all bases, once each is guided. rails, targets [m] (TB_RAIL_SLOTS); speed [m/s]:
 *  largest of the references. torque [N m] (TB_RAIL_SLOTS). */
void tb_guide_step(tb_guide *guide, const real_t rails[TB_RAIL_SLOTS],
                   const real_t targets[TB_RAIL_SLOTS], real_t speed, real_t torque[TB_RAIL_SLOTS]);

/** Whether every base is within `distance` [m] of its target, and its reference has arrived. */
bool tb_guide_has_arrived(const tb_guide *guide, const real_t rails[TB_RAIL_SLOTS],
                          const real_t targets[TB_RAIL_SLOTS], real_t distance);

/** Whether a base has been more than TB_RAIL_LAG_LIMIT off its reference for more than
 *  TB_RAIL_LAG_CYCLES; `rail` is then the first such one, from 0. */
bool tb_guide_has_lost(const tb_guide *guide, size_t *rail);

#ifdef __cplusplus
}
#endif

#endif
