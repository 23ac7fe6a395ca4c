#include "calibration.h"

#include <stdbool.h>
#include <stddef.h>

#include "pose_space.h"
#include "tb_kinematics.h"

#define STEP_LIMIT TB_C(0.1)  /* m, rad; the fit turns too much beyond to trust its tangent */
#define STEP_SMALL TB_C(1e-5) /* m, rad; the step after it would be a thousand times smaller */
#define STEPS 50              /* from anywhere in the target 4 to 8 are needed, turned 17 */

/* Damping (Levenberg-Marquardt): added to the diagonal of the normal matrix, so that the matrix stays
 * regular, in float too, even where nothing is observable. The least eigenvalue of an observable set
 * is above 1 / 8^2, so the damping is small beside it: the solution stays the same, and each step
 * reduces the error about a hundredfold instead of quadratically. */
#define DAMPING TB_C(0.0001)

#define FARTHEST TB_C(1e6) /* m; no drive counts further, and its square is finite in float */

static const tb_calibration nothing;

/* The n x n equations that are left for the zeros. */
typedef struct {
    real_t matrix[TB_CABLES * TB_CABLES]; /* sum of P_k, then its Cholesky factor (lower) */
    real_t right[TB_CABLES];              /* m, -sum of P_k r_k, then the step of the zeros */
    real_t residual;                      /* m, largest norm of P_k r_k */
    uint32_t lost;                        /* poses that ended where the geometry is singular */
} tb_equations;

static bool is_within(size_t count, const real_t values[], real_t bound)
{
    bool within = true;
    for (size_t i = 0; i < count; i++) {
        within = within && (values[i] >= -bound) && (values[i] <= bound);
    }
    return within;
}

static void copy(size_t count, const real_t from[restrict], real_t to[restrict])
{
    for (size_t i = 0; i < count; i++) {
        to[i] = from[i];
    }
}

static real_t largest(size_t count, const real_t values[], real_t least)
{
    for (size_t i = 0; i < count; i++) {
        least = tb_max(least, TB_ABS(values[i]));
    }
    return least;
}

#ifdef TB_START_POSE

static void find_start(const tb_calibration *calibration, real_t pose[])
{
    static const real_t start[TB_DOF] = TB_START_POSE;
    (void)calibration;
    copy(TB_DOF, start, pose);
}

#else

/* Amid the pulleys of the first measurement. */
static void find_start(const tb_calibration *calibration, real_t pose[])
{
    real_t points[TB_CABLES * TB_DOF];
    (void)tb_base_points(calibration->rails, points);
    for (size_t j = 0; j < TB_DOF; j++) {
        pose[j] = 0;
        for (size_t i = 0; i < TB_CABLES; i++) {
            pose[j] += points[(i * TB_DOF) + j] * (TB_C(1.0) / TB_CABLES);
        }
    }
}

#endif

static void begin(tb_calibration *calibration)
{
    real_t start[TB_DOF];
    real_t lengths[TB_CABLES];
    find_start(calibration, start);
    (void)tb_cable_lengths(start, calibration->rails, lengths);
    for (size_t i = 0; i < TB_CABLES; i++) {
        calibration->zeros[i] = calibration->wound[i] + lengths[i];
    }
    for (size_t k = 0; k < calibration->count; k++) {
        copy(TB_DOF, start, &calibration->poses[k * TB_DOF]);
    }
}

/* The pose space at measurement k, and by how much its lengths miss those of its pose. */
static tb_status find_misfit(const tb_calibration *calibration, size_t k, tb_pose_space *space,
                             real_t misfit[])
{
    const real_t *const pose = &calibration->poses[k * TB_DOF];
    const real_t *const rails = &calibration->rails[k * TB_RAIL_SLOTS];
    real_t lengths[TB_CABLES];
    tb_status status = tb_cable_lengths(pose, rails, lengths);
    if (status == TB_OK) {
        status = tb_pose_space_find(space, pose, rails);
    }
    for (size_t i = 0; i < TB_CABLES; i++) {
        real_t const wound = calibration->wound[(k * TB_CABLES) + i];
        misfit[i] = (calibration->zeros[i] - wound) - lengths[i];
    }
    return status;
}

/* Add what measurement k says about the zeros when its own pose has had its share. */
static void add_pose(tb_equations *equations, const tb_pose_space *space, real_t misfit[])
{
    real_t motion[TB_DOF];
    real_t square = 0;
    tb_pose_space_take(space, misfit, motion);
    for (size_t i = 0; i < TB_CABLES; i++) {
        real_t left[TB_CABLES];
        tb_pose_space_unexplained(space, (uint32_t)i, left);
        for (size_t j = 0; j < TB_CABLES; j++) {
            equations->matrix[(i * TB_CABLES) + j] += left[j];
        }
        equations->right[i] -= misfit[i];
        square += misfit[i] * misfit[i];
    }
    equations->residual = tb_max(equations->residual, TB_SQRT(square));
}

static void gather(const tb_calibration *calibration, tb_equations *equations)
{
    static const tb_equations none;
    *equations = none;
    for (size_t i = 0; i < TB_CABLES; i++) {
        equations->matrix[(i * TB_CABLES) + i] = DAMPING;
    }
    for (size_t k = 0; k < calibration->count; k++) {
        tb_pose_space space;
        real_t misfit[TB_CABLES];
        if (find_misfit(calibration, k, &space, misfit) == TB_OK) {
            add_pose(equations, &space, misfit);
        } else {
            equations->lost++;
        }
    }
}

/* Cholesky in place, lower triangle; regular by the damping. */
static void factorise(real_t matrix[])
{
    for (size_t j = 0; j < TB_CABLES; j++) {
        real_t *const row = &matrix[j * TB_CABLES];
        for (size_t k = 0; k < j; k++) {
            row[j] -= row[k] * row[k];
        }
        row[j] = TB_SQRT(tb_max(row[j], DAMPING));
        for (size_t i = j + 1; i < TB_CABLES; i++) {
            real_t *const below = &matrix[i * TB_CABLES];
            for (size_t k = 0; k < j; k++) {
                below[j] -= below[k] * row[k];
            }
            below[j] /= row[j];
        }
    }
}

/* Solve L y = b in place. */
static void solve_forward(const real_t factor[], real_t b[])
{
    for (size_t i = 0; i < TB_CABLES; i++) {
        for (size_t k = 0; k < i; k++) {
            b[i] -= factor[(i * TB_CABLES) + k] * b[k];
        }
        b[i] /= factor[(i * TB_CABLES) + i];
    }
}

/* Solve L' x = y in place. */
static void solve_backward(const real_t factor[], real_t y[])
{
    for (size_t i = TB_CABLES; i-- > 0;) {
        for (size_t k = i + 1; k < TB_CABLES; k++) {
            y[i] -= factor[(k * TB_CABLES) + i] * y[k];
        }
        y[i] /= factor[(i * TB_CABLES) + i];
    }
}

/* The square root of the largest entry on the diagonal of (L L')^-1. */
static real_t find_spread(const real_t factor[])
{
    real_t worst = 0;
    for (size_t i = 0; i < TB_CABLES; i++) {
        real_t column[TB_CABLES] = {0};
        real_t square = 0;
        column[i] = 1;
        solve_forward(factor, column);
        for (size_t k = 0; k < TB_CABLES; k++) {
            square += column[k] * column[k];
        }
        worst = tb_max(worst, square);
    }
    return TB_SQRT(worst);
}

#if (TB_DOF == 6)

/* A pose turns by a vector; the fit moves by a turn about fixed axes. Their rates differ by the
 * inverse of the left Jacobian of SO(3), here to second order: the fit ends at the same place. */
static void turn_motion(const real_t pose[], real_t motion[])
{
    const real_t *const v = &pose[3];
    real_t *const w = &motion[3];
    real_t const once[3] = {(v[1] * w[2]) - (v[2] * w[1]), (v[2] * w[0]) - (v[0] * w[2]),
                            (v[0] * w[1]) - (v[1] * w[0])};
    real_t const twice[3] = {(v[1] * once[2]) - (v[2] * once[1]),
                             (v[2] * once[0]) - (v[0] * once[2]),
                             (v[0] * once[1]) - (v[1] * once[0])};
    for (size_t i = 0; i < 3; i++) {
        w[i] += (twice[i] * (TB_C(1.0) / TB_C(12.0))) - (once[i] * TB_C(0.5));
    }
}

#else

static void turn_motion(const real_t pose[], real_t motion[])
{
    (void)pose;
    (void)motion;
}

#endif

/* How measurement k's pose moves with the zeros; one that was lost begins again. */
static void find_motion(const tb_calibration *calibration, size_t k, const real_t step[],
                        real_t motion[])
{
    const real_t *const pose = &calibration->poses[k * TB_DOF];
    tb_pose_space space;
    real_t misfit[TB_CABLES];
    if (find_misfit(calibration, k, &space, misfit) == TB_OK) {
        for (size_t i = 0; i < TB_CABLES; i++) {
            misfit[i] += step[i];
        }
        tb_pose_space_take(&space, misfit, motion);
        turn_motion(pose, motion);
    } else {
        find_start(calibration, motion);
        for (size_t j = 0; j < TB_DOF; j++) {
            motion[j] -= pose[j];
        }
    }
}

static void advance(size_t count, real_t share, const real_t step[], real_t values[])
{
    for (size_t i = 0; i < count; i++) {
        values[i] += share * step[i];
    }
}

/* Move zeros and poses, all by the same share of their step; returns the step's largest entry. */
static real_t move(tb_calibration *calibration, const real_t step[])
{
    real_t motions[TB_CALIBRATION_SAMPLES * TB_DOF];
    for (size_t k = 0; k < calibration->count; k++) {
        find_motion(calibration, k, step, &motions[k * TB_DOF]);
    }
    real_t const size =
        largest(calibration->count * TB_DOF, motions, largest(TB_CABLES, step, TB_C(0.0)));
    real_t const share = (size > STEP_LIMIT) ? (STEP_LIMIT / size) : TB_C(1.0);
    advance(TB_CABLES, share, step, calibration->zeros);
    advance(calibration->count * TB_DOF, share, motions, calibration->poses);
    return size;
}

static tb_calibration_progress judge(const tb_calibration *calibration, bool arrived)
{
    if (!arrived && (calibration->steps < STEPS)) {
        return TB_CALIBRATION_BUSY;
    }
    if (!(calibration->spread <= TB_CALIBRATION_SPREAD)) {
        return TB_CALIBRATION_UNOBSERVABLE;
    }
    return (arrived && (calibration->residual <= TB_CLOSURE_LIMIT)) ? TB_CALIBRATION_DONE
                                                                    : TB_CALIBRATION_OPEN;
}

void tb_calibration_start(tb_calibration *calibration)
{
    *calibration = nothing;
}

void tb_calibration_add(tb_calibration *calibration, const real_t wound[TB_CABLES],
                        const real_t rails[TB_RAIL_SLOTS])
{
    size_t const k = calibration->count;
    if ((k < TB_CALIBRATION_SAMPLES) && is_within(TB_CABLES, wound, FARTHEST) &&
        is_within(TB_RAIL_SLOTS, rails, FARTHEST)) {
        copy(TB_CABLES, wound, &calibration->wound[k * TB_CABLES]);
        copy(TB_RAIL_SLOTS, rails, &calibration->rails[k * TB_RAIL_SLOTS]);
        calibration->count++;
    }
}

tb_calibration_progress tb_calibration_solve(tb_calibration *calibration)
{
    tb_equations equations;
    if (calibration->steps == 0) {
        begin(calibration);
    }
    gather(calibration, &equations);
    factorise(equations.matrix);
    solve_forward(equations.matrix, equations.right);
    solve_backward(equations.matrix, equations.right);
    calibration->residual = equations.residual;
    calibration->spread = find_spread(equations.matrix);
    calibration->steps++;
    real_t const size = move(calibration, equations.right);
    return judge(calibration, (equations.lost == 0) && (size <= STEP_SMALL));
}
