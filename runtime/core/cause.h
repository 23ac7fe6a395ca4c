/* Why the machine stopped. docs/safety.md has what the machine does for each cause, and the user. */
#ifndef TB_CAUSE_H
#define TB_CAUSE_H

#include <stddef.h>
#include <stdint.h>

#include "causes.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TB_CAUSE_NUMBER(name, culprit, reaction, words, advice) TB_CAUSE_##name,

/** Why the machine stopped: TB_CAUSE_NONE is 0, the others follow as in causes.h. The number in
 *  `culprit` is a drive, a cable or a bus, from 0. */
typedef enum { TB_CAUSES(TB_CAUSE_NUMBER) TB_CAUSE_COUNT } tb_cause;

/** A cause with what is known about it. */
typedef struct {
    uint32_t detail; /* abort code, value found, emergency code, statusword, tb_status or a count */
    uint16_t culprit; /* drive, cable or bus, from 0 */
    uint16_t index;   /* object of TB_CAUSE_DRIVE_DIFFERENT and _SETUP */
    uint8_t subindex;
    uint8_t failure; /* tb_failure of the same */
    uint8_t cause;   /* tb_cause */
} tb_blame;

/** Nothing went wrong. */
static inline tb_blame tb_no_blame(void)
{
    tb_blame const nothing = {0, 0, 0, 0, 0, TB_CAUSE_NONE};
    return nothing;
}

/** Something went wrong: why, with which drive, cable or bus. */
static inline tb_blame tb_blame_for(tb_cause cause, size_t culprit, uint32_t detail)
{
    tb_blame blame = tb_no_blame();
    blame.cause = (uint8_t)cause;
    blame.culprit = (uint16_t)culprit;
    blame.detail = detail;
    return blame;
}

#ifdef __cplusplus
}
#endif

#endif
