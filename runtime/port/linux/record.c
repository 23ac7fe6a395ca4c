#define _GNU_SOURCE /* pipe2 */
#include "record.h"

#include <errno.h>
#include <fcntl.h>
#include <stddef.h>
#include <string.h>
#include <unistd.h>

#include "record_file.h"
#include "record_writer.h"
#include "say.h"

static bool refuse(const char *path, const tb_record_file *file)
{
    tb_say("--record %s: cannot be written: %s", path, strerror(errno));
    tb_record_file_drop(file);
    return false;
}

/* The ends of two pipes that are the writer's. */
typedef struct {
    int alive;
    int answer;
} tb_writer_ends;

static bool connect_writer(tb_record *record, tb_writer_ends *writer)
{
    int alive[2];
    int answer[2];
    if (pipe2(alive, O_CLOEXEC) != 0) {
        return false;
    }
    if (pipe2(answer, O_CLOEXEC) != 0) {
        close(alive[0]);
        close(alive[1]);
        return false;
    }
    record->alive = alive[1];
    record->answer = answer[0];
    *writer = (tb_writer_ends){alive[0], answer[1]};
    return true;
}

bool tb_record_open(tb_record *record, const tb_recorder *recorder, const char *path)
{
    tb_record_file file;
    tb_writer_ends ends;
    *record = (tb_record){.path = path, .alive = -1, .answer = -1};
    if (path == NULL) {
        return true;
    }
    if (!tb_record_file_open(&file, path)) {
        return false;
    }
    if (!connect_writer(record, &ends)) {
        return refuse(path, &file);
    }
    pid_t const child = fork();
    if (child < 0) {
        return refuse(path, &file);
    }
    if (child == 0) {
        close(record->alive);
        close(record->answer);
        tb_record_write(&(tb_record_writer){.record = record,
                                            .recorder = recorder,
                                            .file = &file,
                                            .alive = ends.alive,
                                            .answer = ends.answer});
    }
    close(ends.alive);
    close(ends.answer);
    close(file.descriptor);
    return true;
}

void tb_record_tell(tb_record *record, const tb_recorder *recorder)
{
    tb_recorder_mark const now = tb_recorder_now(recorder);
    uint64_t const kept = ((uint64_t)now.opened << 32) | now.count;
    atomic_store_explicit(&record->kept, kept, memory_order_release);
}

bool tb_record_close(const tb_record *record)
{
    int failure = 0;
    if (record->alive < 0) {
        return true;
    }
    close(record->alive);
    ssize_t got = 0;
    do {
        got = read(record->answer, &failure, sizeof failure);
    } while ((got < 0) && (errno == EINTR));
    close(record->answer);
    if (got != (ssize_t)sizeof failure) {
        tb_say("--record %s: its writer was killed; the last cycles may be missing", record->path);
        return false;
    }
    return failure == 0; /* the writer has told which */
}
