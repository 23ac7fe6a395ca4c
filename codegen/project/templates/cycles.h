/* The control cycles of a running machine, read from the file that its program shares.
 *
 * The program waits for nobody: who reads too slowly misses cycles, and is told the newest ones. */
#ifndef CYCLES_H
#define CYCLES_H

#include <stdbool.h>

#include "tb_machine.h"
#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** One cycle; SI units, the sizes and the order of controller.h. */
typedef struct {
    bool works; /* in the state RUN, with a controller step that answered TB_OK */
    real_t pose[TB_DOF];
    real_t velocity[TB_DOF];
    real_t asked_force[TB_DOF];     /* by an application */
    real_t wanted_force[TB_DOF];    /* with that of the machine's walls */
    real_t delivered_force[TB_DOF]; /* what the tensions give */
} cycle;

/** Wait for a program that shares the file `path`. */
bool cycles_open(const char *path);

/** Wait for the next cycle; false when the program has ended. */
bool cycles_next(cycle *next);

#ifdef __cplusplus
}
#endif

#endif
