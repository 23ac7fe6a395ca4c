#include "kernel.h"

#define CONSTRAINTS (2 * CABLES)
#define ENTRIES (CABLES * REDUNDANCY)
/* 2 n + 2 q + r (r + 5) / 2 with r = min(n, q): from the source of qpgen2_. */
#define WORK ((2 * REDUNDANCY) + (2 * CONSTRAINTS) + (REDUNDANCY * (REDUNDANCY + 5) / 2))

int qpgen2_(double *factor, double *linear, int n, double *x, double *multipliers, double *value,
            double *constraints, double *bounds, int count, int equalities, int *active,
            int *active_count, int *iterations, double *work, int factorized);

/* Constraints C' lambda >= b: the lower bounds first, then the upper ones. quadprog is told that
 * the quadratic form is factorised already, as the identity. */
void solve_all(size_t count, const double structure[], const double wrench[], double tension[],
               int solved[])
{
    double start[CABLES];
    double constraints[2 * ENTRIES];
    double bounds[CONSTRAINTS];
    double lambda[REDUNDANCY];
    double multipliers[CONSTRAINTS];
    double work[WORK];
    double value;
    int active[CONSTRAINTS];
    int active_count;
    int iterations[2];
    for (size_t i = 0; i < count; i++) {
        double factor[REDUNDANCY * REDUNDANCY] = {1.0, 0.0, 0.0, 1.0};
        double linear[REDUNDANCY] = {0.0, 0.0};
        kernel(&structure[i * DOF * CABLES], &wrench[i * DOF], start, constraints);
        for (size_t k = 0; k < ENTRIES; k++) {
            constraints[ENTRIES + k] = -constraints[k];
        }
        for (size_t k = 0; k < CABLES; k++) {
            bounds[k] = TENSION_MIN - start[k];
            bounds[CABLES + k] = start[k] - TENSION_MAX;
        }
        solved[i] =
            qpgen2_(factor, linear, REDUNDANCY, lambda, multipliers, &value, constraints, bounds,
                    CONSTRAINTS, 0, active, &active_count, iterations, work, 1) == 0;
        add_kernel(start, constraints, lambda, &tension[i * CABLES]);
    }
}
