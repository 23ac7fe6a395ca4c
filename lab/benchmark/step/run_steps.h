/* The signature that every controller step of the benchmark has. */
#ifndef RUN_STEPS_H
#define RUN_STEPS_H

#include <stddef.h>

#ifndef STEP_REAL
#define STEP_REAL double
#endif

/* Start at the first row of inputs, then run one cycle a row.
 * inputs: lengths, rails, force, hand force; outputs: motor torques [N m], rail forces [N]. */
void run_steps(size_t cycles, const STEP_REAL inputs[], STEP_REAL outputs[]);

#endif
