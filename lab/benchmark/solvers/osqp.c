#include "solve_all.h"

#include "osqp.h"
#include "workspace.h"

#define CONSTRAINTS (CABLES + DOF)
#define ENTRIES ((DOF + 1) * CABLES) /* column by column: DOF of the structure, then a 1 */

void solve_all(size_t count, const double structure[], const double wrench[], double tension[],
               int solved[])
{
    double lower[CONSTRAINTS];
    double upper[CONSTRAINTS];
    double matrix[ENTRIES];
    for (size_t k = 0; k < CONSTRAINTS; k++) {
        lower[k] = TENSION_MIN;
        upper[k] = TENSION_MAX;
    }
    for (size_t i = 0; i < count; i++) {
        for (size_t k = 0; k < DOF; k++) {
            lower[k] = wrench[(i * DOF) + k];
            upper[k] = wrench[(i * DOF) + k];
        }
        for (size_t k = 0; k < CABLES; k++) {
            matrix[(k * (DOF + 1)) + 0] = structure[(((i * CABLES) + k) * DOF) + 0];
            matrix[(k * (DOF + 1)) + 1] = structure[(((i * CABLES) + k) * DOF) + 1];
            matrix[(k * (DOF + 1)) + 2] = 1.0;
        }
        (void)osqp_update_data_mat(&solver, NULL, NULL, 0, matrix, NULL, ENTRIES);
        (void)osqp_update_data_vec(&solver, NULL, lower, upper);
        osqp_cold_start(&solver);
        (void)osqp_solve(&solver);
        solved[i] = solver.info->status_val == OSQP_SOLVED;
        for (size_t k = 0; k < CABLES; k++) {
            tension[(i * CABLES) + k] = solver.solution->x[k];
        }
    }
}
