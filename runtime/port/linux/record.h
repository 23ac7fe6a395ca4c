/* The flight recorder's dump: a file that is opened before the machine moves, and written after it
 * has stopped. */
#ifndef TB_RECORD_H
#define TB_RECORD_H

#include <stdbool.h>

#include "recorder.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Where the recording goes. */
typedef struct {
    const char *path;
    int descriptor; /* -1 for nowhere */
} tb_record;

/** Make the file; no path: nothing will be written. False, with a message, where it cannot be. */
bool tb_record_open(tb_record *record, const char *path);

/** Write the recording. False, with a message, where it is not whole. */
bool tb_record_write(const tb_record *record, const tb_recorder *recorder);

#ifdef __cplusplus
}
#endif

#endif
