/* Directions: which way every encoder counts, tried by a small motion at little torque, before the
 * machine does anything that needs to know.
 *
 * A drive pushes for a moment and then for as long less, or the other way: whatever else acts on the
 * cable or carriage in that time takes part in both halves, so the difference of the two changes of
 * speed is the drive's own doing. An encoder that tells it the wrong way round is found. One cable after
 * the other is pulled a little more than T_min, several times, since a hand may be moving the handle; the
 * carriages are pushed all at once, harder until each answers. A cable that a hand holds fast tells
 * nothing: the calibration then shows whether it counts the right way. */
#ifndef TB_DIRECTION_H
#define TB_DIRECTION_H

#include <stdint.h>

#include "tb_drives.h"
#include "tb_types.h"

/** The trial of every drive. */
typedef struct {
    real_t speed[TB_DRIVES];     /* m/s, when the half began that is being tried */
    real_t answer[TB_DRIVES];    /* m/s, speed that pushing made; > 0 the right way */
    uint8_t answered[TB_DRIVES]; /* 1 once that is enough to tell */
} tb_trial;

#endif
