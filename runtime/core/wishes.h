/* What the application and the people at the machine wish in a cycle. */
#ifndef TB_WISHES_H
#define TB_WISHES_H

#include <stdint.h>

#include "tb_machine.h"
#include "tb_types.h"

/** The wishes of one cycle. */
typedef struct {
    uint32_t requests;         /* sum of TB_REQUEST_... */
    uint32_t hand_force_fresh; /* 1 while the force sensor delivers */
    real_t force[TB_DOF];      /* N, of the application; any value, NaN included */
    real_t hand_force[TB_DOF]; /* N, measured; any value */
} tb_wishes;

#endif
