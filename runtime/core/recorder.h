/* Flight recorder: the last seconds before a stop, to be run again to the bit.
 *
 * A ring of segments. Each begins with the supervisor's whole memory and goes on with what every
 * cycle saw and ordered; what a cycle orders depends on nothing else, so any segment can be run
 * again from its beginning: turnbuckle replay. When a fault is latched the recorder goes on for half
 * of its length and then holds still, until the fault has been reset: the cause stays in it, however
 * long the machine waits for somebody. A stop that was asked for is none.
 *
 * Pure: no input or output, no heap. A port reads the recording out piece by piece, and writes each
 * to its place in a file: after the last cycle all of them, or ever again those that have come since.
 *
 *   tb_recording_header
 *   tb_layout_row       header.layout_rows rows: the description of everything else (layout.h)
 *   tb_segment          TB_RECORDER_SEGMENTS places, the newest segment in the place of the oldest
 *
 * A segment has a checksum of its own, so that what was written before a failure can be used. All are
 * the C structs of the machine that recorded, with its byte order and its real_t; a reader takes them
 * apart by the names in the description. lab/flight/recording.py is a reader. */
#ifndef TB_RECORDER_H
#define TB_RECORDER_H

#include <stddef.h>
#include <stdint.h>

#include "layout.h"
#include "supervisor.h"
#include "tb_machine.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A port with little memory sets these smaller. A cycle of yoon2023 takes 912 bytes in double, so
 * that 40 segments of 256 cycles, 10.24 s at 1 kHz, take 9.5 MB. */
#ifndef TB_SEGMENT_CYCLES
#define TB_SEGMENT_CYCLES 256u
#endif
#ifndef TB_RECORDER_SEGMENTS
#define TB_RECORDER_SEGMENTS 40u
#endif

#define TB_RECORDING_MAGIC "TBFLIGHT"
#define TB_RECORDING_VERSION 3u
#define TB_RECORDING_BYTE_ORDER 0x01020304u
#define TB_RECORDING_NAME 64 /* bytes, filled up with 0 */

/** What a cycle saw and ordered. */
typedef struct {
    tb_observation seen;
    tb_orders orders;
} tb_recorded_cycle;

/** What is in a segment. */
typedef struct {
    uint64_t first; /* number of the first cycle; skipped ones are not counted */
    uint32_t count; /* cycles */
    uint32_t
        checksum; /* in a file: CRC-32 (as in zip) of memory, cycles, first and count; here 0 */
} tb_segment_head;

/** Cycles without a gap, and the memory that the first one started from. */
typedef struct {
    tb_segment_head head;
    tb_supervisor before;
    tb_recorded_cycle cycles[TB_SEGMENT_CYCLES];
} tb_segment;

/** The recorder. */
typedef struct {
    uint64_t number; /* of the cycle that is next */
    uint32_t opened; /* segments since the start */
    uint32_t since;  /* cycles recorded since a fault was latched */
    tb_segment segments[TB_RECORDER_SEGMENTS];
} tb_recorder;

/** Beginning of a recording. The layout of this struct is part of the version; the layouts of all
 *  others are in the description. */
typedef struct {
    char magic[8];
    uint32_t version;
    uint32_t byte_order;
    uint32_t layout_rows;     /* of the description, which follows the header */
    uint32_t layout_checksum; /* CRC-32 of the description */
    uint32_t head_size;       /* bytes of tb_segment before its cycles */
    uint32_t segment_size;    /* bytes of tb_segment */
    uint32_t segment_cycles;  /* most in a segment */
    uint32_t segments;        /* places in use */
    uint32_t ended;           /* 1: all that was recorded is here; 0 while more may come */
    char machine[TB_RECORDING_NAME];
    char hash[TB_RECORDING_NAME];
} tb_recording_header;

/** The description of what is recorded. */
extern const tb_layout_row tb_recording_layout[];
extern const uint32_t tb_recording_layout_rows;

/** Bytes of a file with so many segments. */
size_t tb_recording_size(uint32_t segments);

/** Forget everything. The next cycle is number 0 and starts from the supervisor's memory as it is. */
void tb_recorder_start(tb_recorder *recorder, const tb_supervisor *supervisor);

/** Keep a cycle: what it saw, what it ordered, and the memory it left. Call it after every
 *  tb_supervisor_step, with nothing between that and the next one that changes the memory. */
void tb_recorder_keep(tb_recorder *recorder, const tb_observation *seen, const tb_orders *orders,
                      const tb_supervisor *supervisor);

/** How far a recorder is: what was recorded up to here does not change until the ring comes round. */
typedef struct {
    uint32_t opened; /* segments since the start */
    uint32_t count;  /* cycles in the newest */
} tb_recorder_mark;

/** How far it is now. */
tb_recorder_mark tb_recorder_now(const tb_recorder *recorder);

/** Reading a recording out. */
typedef struct {
    const tb_recorder *recorder;
    uint32_t segment;  /* that is read, since the start */
    uint32_t cycles;   /* of it that were read */
    uint32_t checksum; /* of its memory and these */
    uint32_t stage;
    uint32_t described; /* 1 once the description was read */
    tb_recording_header header;
    tb_segment_head head;
} tb_recorder_reader;

/** A piece of a recording; it lives until the next one is read. */
typedef struct {
    const void *bytes;
    size_t size; /* 0: there is none left */
    size_t at;   /* where in the file it belongs */
} tb_recorder_piece;

/** Begin to read a recorder out. */
void tb_recorder_open(tb_recorder_reader *reader, const tb_recorder *recorder);

/** The next piece of what was recorded up to a mark and was not read yet, until none is left.
 *  Cycles may be kept meanwhile, by another thread: a segment that the ring overtakes while it is
 *  read has the wrong checksum then. */
tb_recorder_piece tb_recorder_read(tb_recorder_reader *reader, tb_recorder_mark mark);

/** The last piece, after which nothing is to be read: that all is here. */
tb_recorder_piece tb_recorder_close(tb_recorder_reader *reader);

#ifdef __cplusplus
}
#endif

#endif
