/* Watch over the cables: what only the whole machine can see, not a single drive.
 *
 * The measured lengths overdetermine the pose; what they disagree by (the closure error e, square to
 * the pose space: pose_space.h) tells a cable that no longer is what its drive measures. With the
 * projector N on what no pose explains, a fault of size delta in cable i alone gives e = delta N_i,
 * so the likeliest cable leaves the least of e unexplained: delta_i = e_i / N_ii. delta > 0: the
 * cable is longer than the platform is far, slack. delta < 0: it was wound in without the platform,
 * broken.
 *
 * A cable is suspected where it leaves at most a quarter of e, and beyond suspicion where it leaves
 * more than half. With one cable more than degrees of freedom all cables explain e alike, and so do
 * opposite cables in one line, as those of bases that follow the hand: then all deltas have one sign,
 * so that it is known whether a cable is slack or broken, and the one is named that moves most as its
 * fault lets it. Where the signs differ, or nobody explains e, the cause is TB_CAUSE_CLOSURE. */
#ifndef TB_WATCH_H
#define TB_WATCH_H

#include <stdint.h>

#include "cause.h"
#include "tb_drives.h"
#include "tb_machine.h"
#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Cycles in a row beyond a limit. */
typedef struct {
    uint16_t open;                   /* closure */
    uint16_t lagging[TB_RAIL_SLOTS]; /* bases behind their targets */
} tb_watch;

/** What the watch found; TB_CAUSE_NONE for nothing. */
typedef struct {
    tb_cause cause;   /* RUNAWAY, CABLE_SLACK, CABLE_BREAK, CLOSURE or BASE_LOST */
    uint16_t culprit; /* cable or drive, from 0; of CLOSURE it says nothing */
} tb_verdict;

/** What it looks at. */
typedef struct {
    const real_t *lengths;      /* m (TB_CABLES), measured */
    const real_t *length_rates; /* m/s (TB_CABLES), filtered */
    const real_t *rails;        /* m (TB_RAIL_SLOTS), measured */
    const real_t *rail_targets; /* m (TB_RAIL_SLOTS) */
    const real_t *pose;         /* (TB_DOF), computed from lengths and rails */
    real_t residual;            /* m, of that pose */
} tb_watched;

void tb_watch_start(tb_watch *watch);

/** Look at one cycle. A value that is not finite counts as beyond its limit.
 *  slack [m] (TB_CABLES): delta of every cable, 0 while the closure holds; always finite. */
tb_verdict tb_watch_cables(tb_watch *watch, const tb_watched *seen, real_t slack[TB_CABLES]);

#ifdef __cplusplus
}
#endif

#endif
