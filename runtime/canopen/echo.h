/* The master's own frames, which some adapters send back.
 *
 * An adapter that does so echoes every frame that passes, once. While no drive is there that could
 * acknowledge a frame, before all have booted and after a reset, none passes: some wait in the adapter,
 * the others are lost. A frame of a kind that only a master sends is an
 * echo if the same was sent and has not come back yet, and nearly all that was sent so far came back;
 * otherwise there is another master. */
#ifndef TB_ECHO_H
#define TB_ECHO_H

#include <stdbool.h>
#include <stdint.h>

#include "can.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Frames that are remembered: of some cycles, as an adapter takes its time. */
#define TB_ECHO_FRAMES 64u

/** A frame that was sent. */
typedef struct {
    uint16_t id;
    uint8_t length;
    uint8_t returned; /* 1: it came back */
    /* 1: a drive had been heard shortly before; else it stands for all its like that were sent
     * meanwhile, and may come back as often */
    uint8_t passed;
    uint8_t data[8];
} tb_echo_frame;

/** What was sent last to one bus. */
typedef struct {
    tb_echo_frame frames[TB_ECHO_FRAMES]; /* a ring */
    uint8_t first;                        /* the oldest */
    uint8_t count;
    uint8_t losses; /* weight of the frames that did not come back until they were forgotten */
    uint8_t acknowledged; /* frames that may still be sent until a drive has to be heard again */
} tb_echo;

/** Remember a frame that is sent: classic, 11 bits of identifier. */
void tb_echo_keep(tb_echo *echo, const tb_can_frame *frame);

/** A drive was heard: what is sent now passes. */
void tb_echo_hear(tb_echo *echo);

/** Whether a received frame is one of the master's own. */
bool tb_echo_take(tb_echo *echo, const tb_can_frame *frame);

#ifdef __cplusplus
}
#endif

#endif
