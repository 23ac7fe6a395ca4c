/* The process that writes the flight recorder's file, beside the control loop. */
#ifndef TB_RECORD_WRITER_H
#define TB_RECORD_WRITER_H

#include "record.h"
#include "record_file.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What it works with. */
typedef struct {
    const tb_record *record;
    const tb_recorder *recorder;
    tb_record_file *file;
    int alive;  /* closes when the program has ended */
    int answer; /* takes errno of the first failure, 0 for none */
} tb_record_writer;

/** Write until the program has ended, then end this process. */
void tb_record_write(const tb_record_writer *writer);

#ifdef __cplusplus
}
#endif

#endif
