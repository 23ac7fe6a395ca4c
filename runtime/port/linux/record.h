/* The flight recorder's file. A process of its own, the writer, copies what is recorded to it while the
 * control loop runs, and writes the rest when the program has ended, in whichever way.
 *
 * The recorder is in memory that both share. The control loop makes no system call for its file and never
 * waits for it: it keeps the recorder and stores one number. Not a file that is mapped: the kernel writes
 * such pages back when it pleases and protects them meanwhile, so that the loop's next store would fault
 * and could wait for the disk. The writer is there before the seal and before the real-time priority, and
 * has neither.
 *
 * What is lost: nothing when the program is killed; what was recorded in the last TB_RECORD_INTERVAL when
 * the writer is killed with it; TB_RECORD_SYNC more when power fails. */
#ifndef TB_RECORD_H
#define TB_RECORD_H

#include <stdbool.h>
#include <stdint.h>

#include "atomic_numbers.h"
#include "recorder.h"

#define TB_RECORD_INTERVAL 100 /* ms between two looks of the writer */
#define TB_RECORD_SYNC 10u     /* looks between two times that all is on the disk */

#ifdef __cplusplus
extern "C" {
#endif

/** What the program knows of its record; in memory that it shares with the writer. */
typedef struct {
    const char *path;
    tb_atomic_u64 kept; /* tb_recorder_mark: opened, then in the lower half count */
    int alive;          /* a pipe that closes when the program ends; -1 without a record */
    int answer;         /* a pipe through which the writer tells how it went */
} tb_record;

/** Make the file beside the one that it will replace, and the writer. recorder: in shared memory. path: a
 *  file, or a folder in which the run gets a file of its own name; NULL: nothing will be written. False,
 *  with a message, where it cannot be, or would replace what is no flight recording. */
bool tb_record_open(tb_record *record, const tb_recorder *recorder, const char *path);

/** A cycle was kept. */
void tb_record_tell(tb_record *record, const tb_recorder *recorder);

/** Wait until the recording is written; without any cycle there is none, and the old file stays. False
 *  where it is not whole. */
bool tb_record_close(const tb_record *record);

#ifdef __cplusplus
}
#endif

#endif
