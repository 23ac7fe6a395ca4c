/* Calibration: the cables' zeros, from measurements alone.
 *
 * A drive knows how much cable it has wound in since power-on, not how long the cable is: length =
 * zero - wound. In every pose the n lengths overdetermine the d coordinates of the platform, so
 * n - d equations a pose are left for the n zeros. Poses and bases must differ in the right way: as
 * long as the bases track the platform, zeros and poses cannot be told apart (a rank test sees it).
 * So the bases sweep on their own while the cables hold the platform at T_min, and it may move.
 *
 * min over zeros z, poses x_k of  sum_k |z - wound_k - l(x_k, s_k)|^2, by Gauss-Newton; every pose is
 * eliminated in its own rows, what remains is n x n. One step a call, so that a cycle stays short. */
#ifndef TB_CALIBRATION_H
#define TB_CALIBRATION_H

#include <stdint.h>

#include "tb_drives.h"
#include "tb_machine.h"
#include "tb_types.h"

/** How far the zeros are. */
typedef enum {
    TB_CALIBRATION_BUSY = 0,     /* call again in the next cycle */
    TB_CALIBRATION_DONE,
    TB_CALIBRATION_UNOBSERVABLE, /* the poses do not tell the zeros */
    TB_CALIBRATION_OPEN          /* the lengths do not close: TB_CLOSURE_LIMIT */
} tb_calibration_progress;

/** The measurements and the estimate. */
typedef struct {
    real_t wound[TB_CALIBRATION_SAMPLES * TB_CABLES];     /* m */
    real_t rails[TB_CALIBRATION_SAMPLES * TB_RAIL_SLOTS]; /* m */
    real_t poses[TB_CALIBRATION_SAMPLES * TB_DOF];
    real_t zeros[TB_CABLES]; /* m; valid when DONE */
    real_t residual;         /* m, root mean square of what does not close */
    uint32_t count;          /* measurements so far */
    uint32_t steps;          /* Gauss-Newton steps so far */
} tb_calibration;

/** Forget everything. */
void tb_calibration_start(tb_calibration *calibration);

/** Keep a measurement: cable wound in [m] (TB_CABLES), rail coordinates [m] (TB_RAIL_SLOTS). Beyond
 *  TB_CALIBRATION_SAMPLES it is ignored. */
void tb_calibration_add(tb_calibration *calibration, const real_t wound[TB_CABLES],
                        const real_t rails[TB_RAIL_SLOTS]);

/** One step towards the zeros. The first pose is taken to be near the target's centre. */
tb_calibration_progress tb_calibration_solve(tb_calibration *calibration);

#endif
