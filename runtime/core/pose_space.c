#include "pose_space.h"

#include <stddef.h>

#include "tb_kinematics.h"

/* A column of dl/dx that keeps no more than this share of its length beside the columns before it
 * tells nothing of its own: 1 mrad from them, and well above what float leaves of parallel ones. */
#define LEAST_SHARE TB_C(0.001)

static real_t dot(const real_t a[], const real_t b[])
{
    real_t sum = 0;
    for (size_t i = 0; i < TB_CABLES; i++) {
        sum += a[i] * b[i];
    }
    return sum;
}

static void add_scaled(real_t factor, const real_t from[], real_t to[])
{
    for (size_t i = 0; i < TB_CABLES; i++) {
        to[i] += factor * from[i];
    }
}

/* Make `column` square to the vectors before it and of length 1, or zero. */
static void append(tb_pose_space *space, size_t j, real_t column[])
{
    real_t *const triangle = space->triangle;
    real_t const before = TB_SQRT(dot(column, column));
    for (size_t i = 0; i < j; i++) {
        const real_t *const q = &space->basis[i * TB_CABLES];
        real_t const share = dot(q, column);
        triangle[(i * TB_DOF) + j] = share;
        add_scaled(-share, q, column);
    }
    real_t const left = TB_SQRT(dot(column, column));
    bool const own = left > (LEAST_SHARE * before);
    triangle[(j * TB_DOF) + j] = own ? left : TB_C(1.0);
    for (size_t i = 0; i < TB_CABLES; i++) {
        space->basis[(j * TB_CABLES) + i] = own ? (column[i] / left) : TB_C(0.0);
    }
}

tb_status tb_pose_space_find(tb_pose_space *space, const real_t pose[TB_DOF],
                             const real_t rails[TB_RAIL_SLOTS])
{
    real_t jacobian[TB_CABLES * TB_DOF];
    tb_status const status = tb_length_jacobian(pose, rails, jacobian);
    for (size_t j = 0; (j < TB_DOF) && (status == TB_OK); j++) {
        real_t column[TB_CABLES];
        for (size_t i = 0; i < TB_CABLES; i++) {
            column[i] = jacobian[(i * TB_DOF) + j];
        }
        append(space, j, column);
    }
    return status;
}

/* R motion = shares, from the last row up. */
static void solve_triangle(const real_t triangle[], real_t motion[])
{
    for (size_t j = TB_DOF; j-- > 0;) {
        for (size_t i = j + 1; i < TB_DOF; i++) {
            motion[j] -= triangle[(j * TB_DOF) + i] * motion[i];
        }
        motion[j] /= triangle[(j * TB_DOF) + j];
    }
}

void tb_pose_space_take(const tb_pose_space *space, real_t change[TB_CABLES], real_t motion[TB_DOF])
{
    for (size_t j = 0; j < TB_DOF; j++) {
        const real_t *const q = &space->basis[j * TB_CABLES];
        motion[j] = dot(q, change);
        add_scaled(-motion[j], q, change);
    }
    solve_triangle(space->triangle, motion);
}

void tb_pose_space_unexplained(const tb_pose_space *space, uint32_t cable, real_t left[TB_CABLES])
{
    for (size_t i = 0; i < TB_CABLES; i++) {
        left[i] = (i == cable) ? TB_C(1.0) : TB_C(0.0);
    }
    for (size_t j = 0; j < TB_DOF; j++) {
        const real_t *const q = &space->basis[j * TB_CABLES];
        add_scaled(-q[cable], q, left);
    }
}
