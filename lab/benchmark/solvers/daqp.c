#include "solve_all.h"

#include "api.h"
#include "utils.h"

#define CONSTRAINTS (CABLES + DOF)
#define UPDATE (DAQP_UPDATE_M | DAQP_UPDATE_d | DAQP_UPDATE_sense)
#define EQUALITY (DAQP_ACTIVE | DAQP_IMMUTABLE)

static double upper[CONSTRAINTS] = {TENSION_MAX, TENSION_MAX, TENSION_MAX, TENSION_MAX};
static double lower[CONSTRAINTS] = {TENSION_MIN, TENSION_MIN, TENSION_MIN, TENSION_MIN};
static int sense[CONSTRAINTS] = {0, 0, 0, 0, EQUALITY, EQUALITY};
static double matrix[DOF * CABLES];
static DAQPProblem problem = {.n = CABLES,
                              .m = CONSTRAINTS,
                              .ms = CABLES,
                              .A = matrix,
                              .bupper = upper,
                              .blower = lower,
                              .sense = sense};

/* H = NULL and f = NULL is DAQP's form of least norm: nothing to factorise. */
void solve_all(size_t count, const double structure[], const double wrench[], double tension[],
               int solved[])
{
    static DAQPWorkspace workspace;
    double multipliers[CONSTRAINTS];
    for (size_t i = 0; i < count; i++) {
        DAQPResult result = {.x = &tension[i * CABLES], .lam = multipliers};
        for (size_t k = 0; k < DOF * CABLES; k++) {
            matrix[k] = structure[(i * DOF * CABLES) + k];
        }
        for (size_t k = 0; k < DOF; k++) {
            upper[CABLES + k] = wrench[(i * DOF) + k];
            lower[CABLES + k] = wrench[(i * DOF) + k];
        }
        int const ready = (workspace.settings == NULL)
                              ? setup_daqp(&problem, &workspace, NULL)
                              : daqp_update_ldp(UPDATE, &workspace, &problem);
        solved[i] = 0;
        if (ready >= 0) {
            daqp_solve(&result, &workspace);
            solved[i] = result.exitflag == DAQP_EXIT_OPTIMAL;
        }
    }
}
