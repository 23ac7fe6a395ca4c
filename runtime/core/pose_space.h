/* Pose space: the changes of the n cable lengths that a motion of the platform explains.
 *
 * They are the span of the d columns of dl/dx, kept as orthonormal vectors q (Gram-Schmidt, dl/dx =
 * Q R). What is square to them, n - d directions, no pose explains: there the redundant lengths
 * check each other (watch.h) and tell the cables' zeros (calibration.h). */
#ifndef TB_POSE_SPACE_H
#define TB_POSE_SPACE_H

#include <stdint.h>

#include "tb_machine.h"
#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The pose space at one pose. */
typedef struct {
    real_t basis[TB_DOF * TB_CABLES]; /* row j: vector q_j, zero where the lengths do not tell
                                            motion j from the motions before it */
    real_t triangle[TB_DOF * TB_DOF]; /* R, upper, row by row */
} tb_pose_space;

/** Find the pose space at a pose (TB_DOF) for rail coordinates [m] (TB_RAIL_SLOTS).
 *  Returns the status of tb_length_jacobian; `space` is written only with TB_OK. */
tb_status tb_pose_space_find(tb_pose_space *space, const real_t pose[TB_DOF],
                             const real_t rails[TB_RAIL_SLOTS]);

/** Take from a change of the lengths [m] (TB_CABLES) what a motion of the platform explains.
 *  motion (TB_DOF): that motion, of least squares; [m], and [rad] about fixed axes where it turns. */
void tb_pose_space_take(const tb_pose_space *space, real_t change[TB_CABLES],
                        real_t motion[TB_DOF]);

/** What is left of a unit change of cable i's length: row and column i of I - Q Q' (TB_CABLES). */
void tb_pose_space_unexplained(const tb_pose_space *space, uint32_t cable, real_t left[TB_CABLES]);

#ifdef __cplusplus
}
#endif

#endif
