/* Frames as lines of ASCII: the slcan dialect of adapters on a serial line.
 *
 * A line is a letter, the identifier (3 hexadecimal digits, 8 when extended), the data length code
 * (1 digit) and the data (2 digits a byte), then a carriage return. What is read may also end with
 * a line feed, or with both; digits are read in either case:
 *   t T  classic frame, extended        r R  remote frame, extended; no data
 *   d D  CAN FD frame, extended         b B  the same, with bit rate switch
 * A received line may end with a time stamp of 4 digits, which is not used. Adapters answer a
 * command with an empty line, `z` or `Z` when done, with BEL in place of the carriage return when
 * not, and `F` with two digits of status; some answer nothing, some repeat what they were told.
 * Dialect of Lawicel's CAN232 and CANUSB; FD as in the firmware of CANable 2 and in python-can.
 *
 * No operating system, no heap: also for a serial line of a microcontroller. */
#ifndef TB_SLCAN_TEXT_H
#define TB_SLCAN_TEXT_H

#include "can.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The longest line: letter, identifier, code, data, time stamp, carriage return. */
#define TB_SLCAN_LONGEST_LINE (1u + 8u + 1u + (2u * TB_CAN_MOST_DATA) + 4u + 1u)

/* Bits of an adapter's status. */
#define TB_SLCAN_RECEIVE_FULL ((uint8_t)0x01) /* frames were lost before we read them */
#define TB_SLCAN_SEND_FULL ((uint8_t)0x02)    /* frames were lost before they were on the bus */
#define TB_SLCAN_WARNING ((uint8_t)0x04)      /* an error counter passed 96 */
#define TB_SLCAN_OVERRUN ((uint8_t)0x08)      /* frames were lost by the CAN controller */
#define TB_SLCAN_PASSIVE ((uint8_t)0x20)      /* an error counter passed 127 */
#define TB_SLCAN_BUS_ERROR ((uint8_t)0x80)    /* an error on the bus */

/** What a character completed. */
typedef enum {
    TB_SLCAN_NOTHING = 0, /* the line goes on */
    TB_SLCAN_FRAME,       /* a frame */
    TB_SLCAN_DONE,        /* the adapter has done what it was told */
    TB_SLCAN_FAILED,      /* the adapter has not */
    TB_SLCAN_STATUS,      /* the adapter's status */
    TB_SLCAN_ECHO,        /* a command that the adapter repeats: no answer to it */
    TB_SLCAN_MALFORMED    /* a line that is none of these, or is too long */
} tb_slcan_item;

/** Reads lines, however they are cut into pieces. */
typedef struct {
    char line[TB_SLCAN_LONGEST_LINE]; /* characters of the line that has begun */
    uint8_t length;                   /* how many */
    uint8_t status;                   /* sum of TB_SLCAN_... bits, of the last status read */
    uint16_t skipped;                 /* characters for which there was no room */
} tb_slcan_reader;

/** Write a frame as a line. line: not terminated by 0.
 *  Returns its length, carriage return included; 0 for what is no frame. */
uint8_t tb_slcan_write(const tb_can_frame *frame, char line[TB_SLCAN_LONGEST_LINE]);

/** A reader at the beginning of a line. */
void tb_slcan_start(tb_slcan_reader *reader);

/** Read one more character. A malformed line is skipped to its end.
 *  frame: written, wholly, only when the answer is TB_SLCAN_FRAME. */
tb_slcan_item tb_slcan_read(tb_slcan_reader *reader, char character, tb_can_frame *frame);

#ifdef __cplusplus
}
#endif

#endif
