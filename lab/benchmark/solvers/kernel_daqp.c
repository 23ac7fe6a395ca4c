#include "kernel.h"

#include "api.h"
#include "utils.h"

#define UPDATE (DAQP_UPDATE_M | DAQP_UPDATE_d | DAQP_UPDATE_sense)

static double upper[CABLES];
static double lower[CABLES];
static double basis[CABLES * REDUNDANCY];
static DAQPProblem problem = {
    .n = REDUNDANCY,
    .m = CABLES,
    .ms = 0,
    .A = basis,
    .bupper = upper,
    .blower = lower,
};

/* H = NULL and f = NULL is DAQP's form of least norm: nothing to factorise. */
void solve_all(size_t count, const double structure[], const double wrench[], double tension[],
               int solved[])
{
    static DAQPWorkspace workspace;
    double start[CABLES];
    double lambda[REDUNDANCY];
    double multipliers[CABLES];
    for (size_t i = 0; i < count; i++) {
        DAQPResult result = {.x = lambda, .lam = multipliers};
        kernel(&structure[i * DOF * CABLES], &wrench[i * DOF], start, basis);
        for (size_t k = 0; k < CABLES; k++) {
            lower[k] = TENSION_MIN - start[k];
            upper[k] = TENSION_MAX - start[k];
        }
        int const ready = (workspace.settings == NULL)
                              ? setup_daqp(&problem, &workspace, NULL)
                              : daqp_update_ldp(UPDATE, &workspace, &problem);
        solved[i] = 0;
        if (ready >= 0) {
            daqp_solve(&result, &workspace);
            solved[i] = result.exitflag == DAQP_EXIT_OPTIMAL;
        }
        add_kernel(start, basis, lambda, &tension[i * CABLES]);
    }
}
