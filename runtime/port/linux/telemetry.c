#define _GNU_SOURCE /* MAP_POPULATE */
#include "telemetry.h"

#include <errno.h>
#include <fcntl.h>
#include <stddef.h>
#include <string.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "say.h"
#include "tb_machine.h"

#define MOST_NAPS 100u /* ms */

static const tb_telemetry_header blank_header = {
    .version = TB_TELEMETRY_VERSION,
    .bytes = sizeof(tb_telemetry_file),
    .machine = TB_MACHINE_NAME,
    .hash = TB_MACHINE_HASH,
    .dof = TB_DOF,
    .cables = TB_CABLES,
    .rails = TB_RAIL_SLOTS,
    .drives = TB_DRIVES,
    .buses = TB_BUSES,
    .layout_at = offsetof(tb_telemetry_file, layout),
    .status_at = offsetof(tb_telemetry_file, status),
    .cycles_at = offsetof(tb_telemetry_file, cycles),
    .slots = TB_TELEMETRY_CYCLES,
    .inbox_at = offsetof(tb_telemetry_file, inbox),
    .has_rails = (TB_RAILS > 0) ? 1u : 0u,
    .period = (double)TB_PERIOD,
    .tension_min = (double)TB_TENSION_MIN,
    .tension_max = (double)TB_TENSION_MAX,
};

static void copy_name(const char *name, char to[TB_TELEMETRY_NAME])
{
    strncpy(to, name, TB_TELEMETRY_NAME - 1u); /* the rest is 0 already */
}

static void write_header(tb_telemetry_file *file, bool simulated)
{
    tb_telemetry_header *const header = &file->header;
    *header = blank_header;
    header->layout_rows = tb_telemetry_layout_rows;
    memcpy(file->layout, tb_telemetry_layout, tb_telemetry_layout_rows * sizeof(tb_layout_row));
    header->pid = (uint32_t)getpid();
    header->simulated = simulated ? 1u : 0u;
    memcpy(header->edges, tb_histogram_edges, sizeof header->edges);
    for (size_t i = 0; i < TB_DRIVES; i++) {
        copy_name(tb_drives[i].name, header->drive_names[i]);
    }
    for (size_t i = 0; i < TB_BUSES; i++) {
        copy_name(tb_buses[i].name, header->bus_names[i]);
    }
    atomic_thread_fence(memory_order_release);
    memcpy(header->magic, TB_TELEMETRY_MAGIC, sizeof header->magic);
}

static int refuse(const char *path, const char *what, int descriptor)
{
    tb_say("--telemetry %s: %s: %s", path, what, strerror(errno));
    if (descriptor >= 0) {
        close(descriptor);
    }
    return -1;
}

static void say_foreign(const char *path)
{
    tb_say("--telemetry %s: is no telemetry of a turnbuckle program, and would be replaced; name "
           "another "
           "file",
           path);
}

/* A reader finds out whether the file's program still runs by locking the file for a moment: a lock
 * that is held is tried again for MOST_NAPS before another program is reported. */
static bool lock_patiently(int descriptor)
{
    struct timespec const nap = {.tv_nsec = 1000000};
    bool locked = flock(descriptor, LOCK_EX | LOCK_NB) == 0;
    for (uint32_t naps = 0; !locked && (naps < MOST_NAPS); naps++) {
        (void)nanosleep(&nap, NULL);
        locked = flock(descriptor, LOCK_EX | LOCK_NB) == 0;
    }
    return locked;
}

/* Whether a file is telemetry of any version, or empty. */
static bool is_telemetry(int descriptor)
{
    char magic[sizeof(blank_header.magic)];
    ssize_t const got = pread(descriptor, magic, sizeof magic, 0);
    return (got == 0) || ((got == (ssize_t)sizeof magic) &&
                          (memcmp(magic, TB_TELEMETRY_MAGIC, sizeof magic) == 0));
}

/* Whether the old file is telemetry of a program that has ended; a message says what it is else. */
static bool is_left_over(const char *path, int old)
{
    bool const ours = is_telemetry(old);
    bool const free = ours && lock_patiently(old);
    if (!ours) {
        say_foreign(path);
    } else if (!free) {
        tb_say("%s: another program controls this machine; stop it first, or give --telemetry "
               "another file",
               path);
    }
    return free;
}

/* Whether there is no old file, or one that may be replaced; else a message says why not. */
static bool may_replace(const char *path)
{
    struct stat about;
    if (lstat(path, &about) != 0) {
        return true; /* the next open() finds out whether something is wrong */
    }
    if (!S_ISREG(about.st_mode)) {
        say_foreign(path);
        return false;
    }
    int const old = open(path, O_RDWR | O_NOFOLLOW | O_CLOEXEC);
    if (old < 0) {
        refuse(path, "the old file cannot be opened", -1);
        return false;
    }
    bool const left_over = is_left_over(path, old);
    close(old);
    return left_over;
}

/* A new file, not the old one emptied: who still reads that one reads on in peace. The group may
 * write, because the inbox is in it. */
static int create(const char *path)
{
    if ((unlink(path) != 0) && (errno != ENOENT)) {
        return refuse(path, "the old file cannot be replaced", -1);
    }
    int const descriptor = open(path, O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0660);
    if (descriptor < 0) {
        return refuse(path, "cannot be created", -1);
    }
    if (!lock_patiently(descriptor)) {
        return refuse(path, "cannot be locked", descriptor);
    }
    int const failure = posix_fallocate(descriptor, 0, (off_t)sizeof(tb_telemetry_file));
    if (failure != 0) {
        (void)unlink(path);
        errno = failure;
        return refuse(path, "no room", descriptor);
    }
    return descriptor;
}

/* The descriptor stays open as long as the program runs, and the lock with it. */
tb_telemetry_file *tb_telemetry_open(const char *path, bool simulated)
{
    if (!may_replace(path)) {
        return NULL;
    }
    int const descriptor = create(path);
    if (descriptor < 0) {
        return NULL;
    }
    void *const memory = mmap(NULL, sizeof(tb_telemetry_file), PROT_READ | PROT_WRITE,
                              MAP_SHARED | MAP_POPULATE, descriptor, 0);
    if (memory == MAP_FAILED) {
        refuse(path, "cannot be mapped", descriptor);
        return NULL;
    }
    tb_telemetry_file *const file = memory;
    write_header(file, simulated);
    return file;
}

static void copy_behind_sequence(void *to, const void *from, size_t bytes)
{
    size_t const begin = sizeof(uint64_t);
    memcpy((char *)to + begin, (const char *)from + begin, bytes - begin);
}

/* Odd before the first byte changes, even after the last one did: for any reader's processor. */
static void write_whole(tb_atomic_u64 *sequence, uint64_t even, void *to, const void *from,
                        size_t bytes)
{
    atomic_store_explicit(sequence, even - 1u, memory_order_relaxed);
    atomic_thread_fence(memory_order_release);
    copy_behind_sequence(to, from, bytes);
    atomic_store_explicit(sequence, even, memory_order_release);
}

void tb_telemetry_append(tb_telemetry_file *file, const tb_telemetry_cycle *cycle)
{
    tb_telemetry_cycle *const slot = &file->cycles[cycle->number % TB_TELEMETRY_CYCLES];
    write_whole(&slot->sequence, 2u * (cycle->number + 1u), slot, cycle, sizeof *slot);
}

void tb_telemetry_tell(tb_telemetry_file *file, const tb_telemetry_status *status)
{
    write_whole(&file->status.sequence, 2u * (status->published + 1u), &file->status, status,
                sizeof file->status);
}
