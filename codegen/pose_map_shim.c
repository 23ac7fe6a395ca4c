/* The loop over the poses of a grid that codegen/pose_map.py calls.
 * Runs on a host only; nothing of it goes to a machine. */
#include <math.h>
#include <stddef.h>

#include "tb_control.h"
#include "tb_machine.h"
#include "tb_quality.h"

/* Poses are origin + row * row_step + column * column_step. */
typedef struct {
    size_t columns;
    double origin[TB_DOF];
    double column_step[TB_DOF];
    double row_step[TB_DOF];
} shim_grid;

size_t shim_grid_size(void);
void shim_map(const shim_grid *grid, const double rails[TB_RAIL_SLOTS], const double lag[],
              size_t first_row, size_t rows, real_t margin[], real_t factor[]);

size_t shim_grid_size(void)
{
    return sizeof(shim_grid);
}

static void find_pose(const shim_grid *grid, size_t row, size_t column, double pose[TB_DOF])
{
    for (size_t k = 0; k < TB_DOF; k++) {
        pose[k] = (grid->origin[k] + ((double)row * grid->row_step[k])) +
                  ((double)column * grid->column_step[k]);
    }
}

/* Where the bases are when they follow the platform, but are a lag behind it. */
static tb_status follow(const double pose[TB_DOF], const double lag[TB_DOF],
                        real_t rails[TB_RAIL_SLOTS])
{
#if TB_RAILS > 0
    real_t behind[TB_DOF];
    for (size_t k = 0; k < TB_DOF; k++) {
        behind[k] = (real_t)(pose[k] - lag[k]);
    }
    return tb_base_targets(behind, rails);
#else
    (void)pose;
    (void)lag;
    (void)rails;
    return TB_OK;
#endif
}

/* Bases stay at `rails` where `lag` is NULL. A pose without an answer is NaN in both results. */
void shim_map(const shim_grid *grid, const double rails[TB_RAIL_SLOTS], const double lag[],
              size_t first_row, size_t rows, real_t margin[], real_t factor[])
{
    real_t bases[TB_RAIL_SLOTS];
    for (size_t k = 0; k < TB_RAIL_SLOTS; k++) {
        bases[k] = (real_t)rails[k];
    }
    size_t place = 0;
    for (size_t row = first_row; row < first_row + rows; row++) {
        for (size_t column = 0; column < grid->columns; column++) {
            double exact[TB_DOF];
            real_t pose[TB_DOF];
            real_t force = 0;
            find_pose(grid, row, column, exact);
            for (size_t k = 0; k < TB_DOF; k++) {
                pose[k] = (real_t)exact[k];
            }
            tb_status status = (lag == NULL) ? TB_OK : follow(exact, lag, bases);
            if (status == TB_OK) {
                status = tb_pose_quality(pose, bases, &margin[place], &factor[place], &force);
            }
            if ((status != TB_OK) && (status != TB_INFEASIBLE)) {
                margin[place] = (real_t)NAN;
                factor[place] = (real_t)NAN;
            }
            place++;
        }
    }
}
