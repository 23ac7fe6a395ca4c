/* Brau et al. eqs 3, 4 for one problem: T = start + basis lambda, by Householder reflections.
 * The basis of the kernel is orthonormal, so |T| is least where |lambda| is. */
#ifndef KERNEL_H
#define KERNEL_H

#include <math.h>
#include <stddef.h>

#include "solve_all.h"

#define REDUNDANCY (CABLES - DOF)

/* I - scale v v'; the first entries of v may be zero. */
typedef struct {
    double v[CABLES];
    double scale;
} reflection;

static inline void reflect(const reflection *across, double x[CABLES])
{
    double sum = 0.0;
    for (size_t i = 0; i < CABLES; i++) {
        sum += across->v[i] * x[i];
    }
    for (size_t i = 0; i < CABLES; i++) {
        x[i] -= across->scale * sum * across->v[i];
    }
}

/* What takes the entries of x from `first` on to a single one, in place `first`: *entry. */
static inline reflection reflection_of(const double x[CABLES], size_t first, double *entry)
{
    reflection across = {{0.0}, 0.0};
    double squares = 0.0;
    for (size_t i = first; i < CABLES; i++) {
        across.v[i] = x[i];
        squares += x[i] * x[i];
    }
    *entry = -copysign(sqrt(squares), x[first]);
    across.v[first] -= *entry;
    across.scale = -1.0 / (*entry * across.v[first]);
    return across;
}

/* start [N]: the tensions of least norm that exert the wrench; basis: CABLES x REDUNDANCY. */
static inline void kernel(const double structure[DOF * CABLES], const double wrench[DOF],
                          double start[CABLES], double basis[CABLES * REDUNDANCY])
{
    double second_row[CABLES];
    double pivots[DOF];
    for (size_t i = 0; i < CABLES; i++) {
        second_row[i] = structure[CABLES + i];
    }
    reflection const first = reflection_of(structure, 0, &pivots[0]);
    reflect(&first, second_row);
    reflection const second = reflection_of(second_row, 1, &pivots[1]);

    double columns[1 + REDUNDANCY][CABLES] = {{0.0}, {[2] = 1.0}, {[3] = 1.0}};
    columns[0][0] = wrench[0] / pivots[0];
    columns[0][1] = (wrench[1] - (second_row[0] * columns[0][0])) / pivots[1];
    for (size_t k = 0; k < 1 + REDUNDANCY; k++) {
        reflect(&second, columns[k]);
        reflect(&first, columns[k]);
    }
    for (size_t i = 0; i < CABLES; i++) {
        start[i] = columns[0][i];
        basis[(i * REDUNDANCY) + 0] = columns[1][i];
        basis[(i * REDUNDANCY) + 1] = columns[2][i];
    }
}

/* tension = start + basis lambda [N]. */
static inline void add_kernel(const double start[CABLES], const double basis[CABLES * REDUNDANCY],
                              const double lambda[REDUNDANCY], double tension[CABLES])
{
    for (size_t i = 0; i < CABLES; i++) {
        tension[i] = start[i] + (basis[(i * REDUNDANCY) + 0] * lambda[0]) +
                     (basis[(i * REDUNDANCY) + 1] * lambda[1]);
    }
}

#endif
