#define _DEFAULT_SOURCE /* cfmakeraw, flock */

#include "serial_line.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

#define CLOSING_TIME 100 /* ms, until the last line has left */
#define MOST_TRIES 8     /* of a call that signals interrupt */

/* ---- Opening ---- */

static tb_can_result why_not_open(int error)
{
    switch (error) {
    case EACCES:
    case EPERM:
        return TB_CAN_NO_PERMISSION;
    case EBUSY:
        return TB_CAN_BUSY;
    case EISDIR:
        return TB_CAN_NOT_CAN;
    default:
        return TB_CAN_NO_DEVICE;
    }
}

/* For this program alone: the lock tells programs that ask, TIOCEXCL refuses the others. */
static tb_can_result claim(int line)
{
    if (isatty(line) == 0) {
        return (errno == EIO) ? TB_CAN_NO_DEVICE : TB_CAN_NOT_CAN;
    }
    if (flock(line, LOCK_EX | LOCK_NB) != 0) {
        return TB_CAN_BUSY;
    }
    return (ioctl(line, TIOCEXCL) == 0) ? TB_CAN_OK : TB_CAN_NO_DEVICE;
}

static tb_can_result make_raw(int line)
{
    struct termios settings;
    if (tcgetattr(line, &settings) != 0) {
        return TB_CAN_NO_DEVICE;
    }
    cfmakeraw(&settings);
    settings.c_cflag |= (tcflag_t)(CLOCAL | CREAD);
    settings.c_cc[VMIN] = 1;
    settings.c_cc[VTIME] = 0;
    return (tcsetattr(line, TCSANOW, &settings) == 0) ? TB_CAN_OK : TB_CAN_NO_DEVICE;
}

static int open_device(const char *path)
{
    int line = TB_SERIAL_CLOSED;
    int tries = 0;
    do {
        line = open(path, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
        tries++;
    } while ((line < 0) && (errno == EINTR) && (tries < MOST_TRIES));
    return line;
}

tb_can_result tb_serial_open(const char *path, int *line)
{
    int const opened = open_device(path);
    *line = TB_SERIAL_CLOSED;
    if (opened < 0) {
        return why_not_open(errno);
    }
    tb_can_result result = claim(opened);
    if (result != TB_CAN_OK) {
        (void)close(opened); /* not ours: another program's TIOCEXCL stays */
        return result;
    }
    result = make_raw(opened);
    if (result != TB_CAN_OK) {
        tb_serial_close(opened, false);
        return result;
    }
    *line = opened;
    return TB_CAN_OK;
}

/* ---- Bytes ---- */

static bool is_only_busy(int error)
{
    return (error == EAGAIN) || (error == EWOULDBLOCK) || (error == EINTR);
}

tb_can_result tb_serial_write(int line, const char *text, size_t length, size_t *written)
{
    ssize_t const done = write(line, text, length);
    *written = (done > 0) ? (size_t)done : 0u;
    if (done < 0) {
        return is_only_busy(errno) ? TB_CAN_FULL : TB_CAN_CLOSED;
    }
    return (done == 0) ? TB_CAN_FULL : TB_CAN_OK;
}

tb_can_result tb_serial_read(int line, char *text, size_t room, size_t *count)
{
    ssize_t const done = read(line, text, room);
    *count = (done > 0) ? (size_t)done : 0u;
    if (done > 0) {
        return TB_CAN_OK;
    }
    /* With VMIN = 1 only a line that was hung up reads 0 bytes. */
    return ((done < 0) && is_only_busy(errno)) ? TB_CAN_EMPTY : TB_CAN_CLOSED;
}

/* ---- Waiting ---- */

int64_t tb_serial_milliseconds(void)
{
    struct timespec now = {0};
    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return ((int64_t)now.tv_sec * 1000) + (now.tv_nsec / 1000000);
}

void tb_serial_await(int line, bool to_write, int milliseconds)
{
    struct pollfd device = {line, to_write ? POLLOUT : POLLIN, 0};
    (void)poll(&device, 1, milliseconds);
}

/* By the sleep that the control loop has too: a sealed program may make no other. */
static void wait_a_millisecond(void)
{
    struct timespec const pause = {.tv_nsec = 1000000};
    (void)clock_nanosleep(CLOCK_MONOTONIC, 0, &pause, NULL);
}

static bool is_left(int line)
{
    int waiting = 0;
    return (ioctl(line, TIOCOUTQ, &waiting) == 0) && (waiting > 0);
}

static void drain(int line)
{
    int64_t const until = tb_serial_milliseconds() + CLOSING_TIME;
    while (is_left(line) && (tb_serial_milliseconds() < until)) {
        wait_a_millisecond();
    }
}

void tb_serial_close(int line, bool patient)
{
    if (patient) {
        drain(line);
    }
    if (is_left(line)) {
        (void)tcflush(line, TCOFLUSH); /* closing the line would wait for it, and for long */
    }
    (void)ioctl(line, TIOCNXCL);
    (void)close(line);
}
