/* A CAN bus behind an adapter on a serial line (slcan_text.h): any that speaks the dialect, no
 * driver in the kernel needed. Linux.
 *
 * A frame is one line, written at once or refused. Should the kernel take only a part of a line,
 * the rest goes before anything else: no broken line is ever on the wire. What the kernel takes
 * cannot be taken back: a USB adapter (cdc-acm) gets at most 16 frames ahead, and a UART should be
 * fast enough for all frames of a cycle. The speed of the line stays as it is set (stty).
 *
 * The dialect has no word for bus-off: it shows as TB_CAN_ERROR_PASSIVE, with frames refused. */
#ifndef TB_SLCAN_H
#define TB_SLCAN_H

#include "can.h"
#include "slcan_text.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TB_SLCAN_READ_AT_ONCE 1024u /* bytes: one system call reads dozens of frames */

/** How far opening is. */
typedef struct {
    uint8_t step;   /* what is being said to the adapter */
    bool said;      /* it was said: the answer is due */
    char rate;      /* digit of the bit rate's command */
    int64_t until;  /* ms, when this step has had its time */
    int64_t silent; /* ms, when the line has been silent for long enough */
} tb_slcan_opening;

/** An adapter. */
typedef struct {
    tb_can_port port;
    tb_can_state state;
    int device;   /* file descriptor of the serial line; below 0: closed */
    bool answers; /* the adapter acknowledged commands. Many do not: then a missing adapter
                     cannot be told from a silent bus */
    bool asked;   /* the adapter's status is on its way */
    tb_slcan_opening opening;
    tb_slcan_reader reader;
    uint16_t next; /* first byte of `bytes` that is not yet read */
    uint16_t end;
    char bytes[TB_SLCAN_READ_AT_ONCE];
    uint8_t rest_length;
    char rest[TB_SLCAN_LONGEST_LINE]; /* end of a line whose beginning is on its way */
} tb_slcan;

/** Open the adapter at `path`, for this program alone, and its bus at `bit_rate` [bit/s]: 10, 20, 50,
 *  100, 125, 250, 500, 800 or 1000 k. Waits for the adapter, at most two seconds.
 *  TB_CAN_OK, or why not: TB_CAN_NO_DEVICE, TB_CAN_NO_PERMISSION, TB_CAN_BUSY, TB_CAN_NOT_CAN (no
 *  serial line), TB_CAN_BIT_RATE, TB_CAN_REFUSED (the adapter does not open its bus) or TB_CAN_CLOSED
 *  (it went away meanwhile). */
tb_can_result tb_slcan_open(tb_slcan *slcan, const char *path, uint32_t bit_rate);

/** The same without waiting: begin, then proceed again and again. TB_CAN_EMPTY: it is under way;
 *  TB_CAN_OK: it is open; else why not, and it is closed. Two seconds at most, however often. */
tb_can_result tb_slcan_begin(tb_slcan *slcan, const char *path, uint32_t bit_rate);
tb_can_result tb_slcan_proceed(tb_slcan *slcan);

#ifdef __cplusplus
}
#endif

#endif
