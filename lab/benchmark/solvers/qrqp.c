#include "solve_all.h"

#include "qrqp_tension.h"

void solve_all(size_t count, const double structure[], const double wrench[], double tension[],
               int solved[])
{
    const double *arguments[SZ_ARG];
    double *results[SZ_RES];
    casadi_int integers[SZ_IW];
    double work[SZ_W];
    for (size_t i = 0; i < count; i++) {
        arguments[0] = &structure[i * DOF * CABLES];
        arguments[1] = &wrench[i * DOF];
        results[0] = &tension[i * CABLES];
        solved[i] = qrqp_tension(arguments, results, integers, work, 0) == 0;
    }
}
