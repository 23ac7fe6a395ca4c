#define _XOPEN_SOURCE 700 /* realpath */
#include "record_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "recorder.h"
#include "say.h"

#define MOST_FRESH 1000u
#define MAGIC_BYTES 8u

/* printf into a path; false with errno where the path is too long. */
static bool print_path(char path[PATH_MAX], const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static bool print_path(char path[PATH_MAX], const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    int const length = vsnprintf(path, PATH_MAX, format, arguments);
    va_end(arguments);
    errno = ENAMETOOLONG;
    return (length >= 0) && (length < PATH_MAX);
}

/* A name in a folder that no other run has: the machine and the time, to the millisecond. */
static bool name_run(char path[PATH_MAX], const char *folder)
{
    struct timespec now;
    struct tm utc;
    char second[32];
    clock_gettime(CLOCK_REALTIME, &now);
    gmtime_r(&now.tv_sec, &utc);
    strftime(second, sizeof second, "%Y%m%dT%H%M%S", &utc);
    return print_path(path, "%s/%s-%s.%03ldZ.dump", folder, TB_MACHINE_NAME, second,
                      now.tv_nsec / 1000000L);
}

/* Whether a file is a flight recording, or empty. */
static bool is_recording(const char *path)
{
    char magic[MAGIC_BYTES];
    int const descriptor = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    ssize_t const got = (descriptor < 0) ? -1 : read(descriptor, magic, sizeof magic);
    if (descriptor >= 0) {
        close(descriptor);
    }
    return (got == 0) || ((got == (ssize_t)sizeof magic) &&
                          (memcmp(magic, TB_RECORDING_MAGIC, sizeof magic) == 0));
}

/* Where the recording goes: a new file, one in a folder, or what is behind a link. False with errno. */
static bool name_file(char path[PATH_MAX], const char *given, const struct stat *found)
{
    if (found == NULL) {
        return print_path(path, "%s", given);
    }
    return S_ISDIR(found->st_mode) ? name_run(path, given) : (realpath(given, path) != NULL);
}

/* False, with a message, where nothing can be or what is there is to stay. */
static bool find_place(tb_record_file *file, const char *path)
{
    struct stat about;
    const struct stat *const found = (stat(path, &about) == 0) ? &about : NULL;
    if (!name_file(file->path, path, found)) {
        tb_say("--record %s: cannot be written: %s", path, strerror(errno));
        return false;
    }
    if ((found != NULL) && !S_ISDIR(about.st_mode) &&
        (!S_ISREG(about.st_mode) || !is_recording(path))) {
        tb_say(
            "--record %s: is no flight recording, and would be replaced; name another file, or a "
            "folder",
            path);
        return false;
    }
    return true;
}

static bool create(tb_record_file *file)
{
    for (unsigned i = 0; i < MOST_FRESH; i++) {
        if (!print_path(file->fresh, "%s.%u", file->path, i)) {
            return false;
        }
        file->descriptor =
            open(file->fresh, O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0644);
        if ((file->descriptor >= 0) || (errno != EEXIST)) {
            break;
        }
    }
    return file->descriptor >= 0;
}

bool tb_record_file_open(tb_record_file *file, const char *path)
{
    *file = (tb_record_file){.descriptor = -1};
    if (!find_place(file, path)) {
        return false;
    }
    if (!create(file)) {
        tb_say("--record %s: cannot be written: %s", path, strerror(errno));
        return false;
    }
    size_t const whole = tb_recording_size(TB_RECORDER_SEGMENTS);
    int const failure = posix_fallocate(file->descriptor, 0, (off_t)whole);
    if (failure != 0) {
        tb_say("--record %s: no room for %zu bytes: %s", path, whole, strerror(failure));
        tb_record_file_drop(file);
        return false;
    }
    return true;
}

/* That a file has a name is on the disk only when its folder is. */
static void sync_folder(const char *path)
{
    char folder[PATH_MAX];
    memcpy(folder, path, sizeof folder);
    char *const slash = strrchr(folder, '/');
    if (slash != NULL) {
        slash[1] = '\0';
    }
    int const descriptor = open((slash == NULL) ? "." : folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor >= 0) {
        (void)fsync(descriptor); /* where a system cannot, the file is there all the same */
        close(descriptor);
    }
}

bool tb_record_file_place(tb_record_file *file)
{
    if ((fdatasync(file->descriptor) != 0) || (rename(file->fresh, file->path) != 0)) {
        return false;
    }
    file->placed = true;
    sync_folder(file->path);
    return true;
}

void tb_record_file_drop(const tb_record_file *file)
{
    if (!file->placed) {
        (void)unlink(file->fresh);
    }
    close(file->descriptor);
}
