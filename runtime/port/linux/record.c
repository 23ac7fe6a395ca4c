#define _POSIX_C_SOURCE 200809L
#include "record.h"

#include <errno.h>
#include <fcntl.h>
#include <stddef.h>
#include <string.h>
#include <unistd.h>

#include "say.h"

bool tb_record_open(tb_record *record, const char *path)
{
    *record = (tb_record){.path = path, .descriptor = -1};
    if (path == NULL) {
        return true;
    }
    record->descriptor = open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (record->descriptor < 0) {
        tb_say("--record %s: cannot be written: %s", path, strerror(errno));
    }
    return record->descriptor >= 0;
}

static bool write_all(int descriptor, const char *bytes, size_t size)
{
    while (size > 0) {
        ssize_t const written = write(descriptor, bytes, size);
        if ((written < 0) && (errno != EINTR)) {
            return false;
        }
        size_t const done = (written < 0) ? 0u : (size_t)written;
        bytes += done;
        size -= done;
    }
    return true;
}

bool tb_record_write(const tb_record *record, const tb_recorder *recorder)
{
    if (record->descriptor < 0) {
        return true;
    }
    tb_recorder_reader reader;
    tb_recorder_open(&reader, recorder);
    for (;;) {
        tb_recorder_piece const piece = tb_recorder_read(&reader);
        if (piece.size == 0) {
            return true;
        }
        if (!write_all(record->descriptor, piece.bytes, piece.size)) {
            tb_say("--record %s: %s; the recording is not whole", record->path, strerror(errno));
            return false;
        }
    }
}
