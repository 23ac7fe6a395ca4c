/* The signature every C solver of the benchmark has. */
#ifndef SOLVE_ALL_H
#define SOLVE_ALL_H

#include <stddef.h>

#define CABLES 4
#define DOF 2

/* structure: count matrices of DOF x CABLES; wrench [N]: count vectors; tension [N]: the answers;
 * solved: 1 where the solver says that it found the optimum. */
void solve_all(size_t count, const double structure[], const double wrench[], double tension[],
               int solved[]);

#endif
