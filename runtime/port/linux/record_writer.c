#define _XOPEN_SOURCE 700
#include "record_writer.h"

#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <stddef.h>
#include <string.h>
#include <unistd.h>

#include "say.h"

/* What the writer remembers. */
typedef struct {
    const tb_record_writer *with;
    tb_recorder_reader reader;
    uint32_t looks; /* since all was on the disk */
    int failure;    /* errno of the first one */
} tb_writing;

/* Signals are for the program; when that ends, so does the writer. A file that may not grow is an error
 * like others. */
static void ignore_signals(void)
{
    static const int ignored[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXFSZ};
    struct sigaction const ignore = {.sa_handler = SIG_IGN};
    for (size_t i = 0; i < sizeof ignored / sizeof ignored[0]; i++) {
        sigaction(ignored[i], &ignore, NULL);
    }
}

/* The first failure is told; after it the rest is tried all the same, as disks get room again. */
static void check(tb_writing *writing, bool done)
{
    if (!done && (writing->failure == 0)) {
        writing->failure = errno;
        tb_say("--record %s: %s; the recording is not whole", writing->with->record->path,
               strerror(errno));
    }
}

static bool write_piece(int descriptor, tb_recorder_piece piece)
{
    const char *const bytes = piece.bytes;
    for (size_t done = 0; done < piece.size;) {
        ssize_t const written =
            pwrite(descriptor, bytes + done, piece.size - done, (off_t)(piece.at + done));
        if ((written < 0) && (errno != EINTR)) {
            return false;
        }
        done += (written < 0) ? 0u : (size_t)written;
    }
    return true;
}

/* Write what was kept since the last time; whether there was anything. */
static bool write_news(tb_writing *writing)
{
    const tb_record *const record = writing->with->record;
    uint64_t const kept = atomic_load_explicit(&record->kept, memory_order_acquire);
    tb_recorder_mark const mark = {(uint32_t)(kept >> 32), (uint32_t)kept};
    bool any = false;
    for (;;) {
        tb_recorder_piece const piece = tb_recorder_read(&writing->reader, mark);
        if (piece.size == 0) {
            return any;
        }
        check(writing, write_piece(writing->with->file->descriptor, piece));
        any = true;
    }
}

static void look(tb_writing *writing)
{
    tb_record_file *const file = writing->with->file;
    bool const any = write_news(writing);
    if (any && !file->placed) {
        check(writing, tb_record_file_place(file));
    }
    writing->looks++;
    if (writing->looks >= TB_RECORD_SYNC) {
        check(writing, fdatasync(file->descriptor) == 0);
        writing->looks = 0;
    }
}

/* Whether the program still runs, after the time between two looks. */
static bool await_look(int alive)
{
    struct pollfd pipe = {.fd = alive};
    int const changed = poll(&pipe, 1, TB_RECORD_INTERVAL);
    return (changed == 0) || ((changed < 0) && (errno == EINTR));
}

/* Mark the file as complete, and give back the room that was not needed. */
static void conclude(tb_writing *writing)
{
    int const descriptor = writing->with->file->descriptor;
    check(writing, write_piece(descriptor, tb_recorder_close(&writing->reader)));
    size_t const size = tb_recording_size(writing->reader.header.segments);
    check(writing, (ftruncate(descriptor, (off_t)size) == 0) && (fdatasync(descriptor) == 0));
}

void tb_record_write(const tb_record_writer *writer)
{
    tb_writing writing = {.with = writer};
    ignore_signals();
    close(STDIN_FILENO);
    close(STDOUT_FILENO);
    tb_recorder_open(&writing.reader, writer->recorder);
    while (await_look(writer->alive)) {
        look(&writing);
    }
    look(&writing); /* what was kept until the program ended */
    if (writer->file->placed) {
        conclude(&writing);
    }
    tb_record_file_drop(writer->file);
    ssize_t const told = write(writer->answer, &writing.failure, sizeof writing.failure);
    _exit((told > 0) ? 0 : 1); /* killed programs are told nothing */
}
