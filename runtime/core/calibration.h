/* Calibration: the cables' zeros, from measurements alone.
 *
 * A drive knows how much cable it has wound in since power-on, not how long the cable is: length =
 * zero - wound. In every pose the n lengths overdetermine the d coordinates of the platform, so
 * n - d equations a pose are left for the n zeros:
 *
 *   min over zeros z, poses x_k of  sum_k |z - wound_k - l(x_k, s_k)|^2
 *
 * by Gauss-Newton. Every pose is eliminated in its own rows: with the projector P_k on what no pose
 * explains (pose_space.h), (sum_k P_k) dz = -sum_k P_k r_k remains, n x n. One step a call, so that
 * a cycle stays short; no step moves a pose or a zero by more than 0.1 m or 0.1 rad.
 *
 * What is observable. Errors of the measured lengths of standard deviation sigma give the zeros the
 * covariance sigma^2 (sum_k P_k)^-1. `spread` is the worst zero's standard deviation over sigma, and
 * beyond TB_CALIBRATION_SPREAD the answer is TB_CALIBRATION_UNOBSERVABLE. What is not in the model
 * counts as sigma too, which is why a large factor is refused even where the drives count finely.
 * The bound is 8, between what is a sweep and what is not: K measurements that move a platform or
 * its bases by about a in distances of about l give l / (a sqrt(K / 2)); 0.7 to 1.9 in yoon2023, up
 * to 7 where the target is small, and 12 or more for bases that follow the hand with errors of 5 mm.
 *
 * Poses and bases must differ in the right way. Observable: bases that sweep on their own under a
 * platform held still; fixed bases and a platform moved about. Not observable: bases that track the
 * platform; and a free platform under equal tensions, wherever the bases go, when four cables of a
 * plane hold it: it rests where opposite cables are in line, and only the sums of their zeros show.
 * So a sweep with nobody at the handle varies the tensions too. */
#ifndef TB_CALIBRATION_H
#define TB_CALIBRATION_H

#include <stdint.h>

#include "tb_drives.h"
#include "tb_machine.h"
#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Largest standard deviation of a zero, over that of a measured length. */
#define TB_CALIBRATION_SPREAD TB_C(8.0)

/** How far the zeros are. */
typedef enum {
    TB_CALIBRATION_BUSY = 0, /* call again in the next cycle */
    TB_CALIBRATION_DONE,
    TB_CALIBRATION_UNOBSERVABLE, /* the poses do not tell the zeros */
    TB_CALIBRATION_OPEN          /* the lengths of a pose do not close: TB_CLOSURE_LIMIT */
} tb_calibration_progress;

/** The measurements and the estimate. */
typedef struct {
    real_t wound[TB_CALIBRATION_SAMPLES * TB_CABLES];     /* m */
    real_t rails[TB_CALIBRATION_SAMPLES * TB_RAIL_SLOTS]; /* m */
    real_t poses[TB_CALIBRATION_SAMPLES * TB_DOF];
    real_t zeros[TB_CABLES]; /* m; valid when DONE */
    real_t residual;         /* m, norm of what does not close in the worst pose */
    real_t spread;           /* worst standard deviation of a zero, over that of a length */
    uint32_t count;          /* measurements so far */
    uint32_t steps;          /* Gauss-Newton steps so far */
} tb_calibration;

/** Forget everything. */
void tb_calibration_start(tb_calibration *calibration);

/** Keep a measurement: cable wound in [m] (TB_CABLES), rail coordinates [m] (TB_RAIL_SLOTS). Beyond
 *  TB_CALIBRATION_SAMPLES it is ignored, and so is one that is not finite. */
void tb_calibration_add(tb_calibration *calibration, const real_t wound[TB_CABLES],
                        const real_t rails[TB_RAIL_SLOTS]);

/** One step towards the zeros, from the measurements so far. The search begins at TB_START_POSE, or
 *  amid the pulleys where tb_machine.h has none: the platform should be in the target, and about
 *  upright. Everything in `calibration` stays finite. */
tb_calibration_progress tb_calibration_solve(tb_calibration *calibration);

#ifdef __cplusplus
}
#endif

#endif
