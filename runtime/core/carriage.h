/* Carriages: whether they move as their drives push them.
 *
 * A carriage pushed at its drive's limit that does not move is blocked, or its encoder stands still. A
 * carriage that gains speed against its drive's force has an encoder, or a motor, that is the wrong
 * way round: no cable pulls as hard as half of the drive's limit. Either is found while the force acts,
 * long before the carriage is as far from its target, or as fast, as its limits allow. */
#ifndef TB_CARRIAGE_H
#define TB_CARRIAGE_H

#include <stdbool.h>
#include <stdint.h>

#include "cause.h"
#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A push: cycles in a row in which a drive pushes the same way with half of its limit or more. */
typedef struct {
    real_t speed;    /* m/s, when it began */
    real_t low;      /* m, least rail coordinate since the drive is at its limit */
    real_t high;     /* m, greatest of the same */
    uint16_t cycles; /* at the limit */
    uint8_t pushed;  /* 1 during a push */
    uint8_t forward; /* 1 where it pushes towards greater rail coordinates */
} tb_carriage;

/** What a cycle shows of a carriage. */
typedef struct {
    real_t position; /* m */
    real_t speed;    /* m/s */
    real_t torque;   /* N m, of its drive */
} tb_carriage_motion;

/** Forget the push. */
void tb_carriage_rest(tb_carriage *carriage);

/** Whether a drive pushes so hard [N m] that its carriage tells something. */
bool tb_carriage_is_pushed(real_t torque);

/** Look at one cycle in which it does: TB_CAUSE_NONE, TB_CAUSE_BASE_BLOCKED or TB_CAUSE_WRONG_WAY. */
tb_cause tb_carriage_look(tb_carriage *carriage, const tb_carriage_motion *seen);

#ifdef __cplusplus
}
#endif

#endif
