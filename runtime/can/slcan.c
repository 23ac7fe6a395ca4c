#define _DEFAULT_SOURCE /* cfmakeraw, flock */

#include "slcan.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

#define CLOSED (-1)
#define ANSWER_TIME 200  /* ms, until an adapter that answers has answered */
#define SILENCE 50       /* ms without a byte: what was under way has arrived */
#define CLOSING_TIME 100 /* ms, until the last line has left */
#define MOST_READS 4u    /* system calls in one receive; more is no traffic, but a broken adapter */

/* Bit rates in the order of their commands S0 to S8. */
static const uint32_t bit_rates[] = {10000,  20000,  50000,  100000, 125000,
                                     250000, 500000, 800000, 1000000};
#define BIT_RATES (sizeof bit_rates / sizeof bit_rates[0])

static const tb_can_statistics nothing_yet = {0};

static tb_slcan *slcan_of(tb_can_port *port)
{
    return (tb_slcan *)(void *)port;
}

/* The device has gone: nothing will come of it until it is opened again. */
static tb_can_result lose_device(tb_slcan *slcan)
{
    slcan->state = TB_CAN_NOT_OPEN;
    return TB_CAN_CLOSED;
}

static bool is_only_busy(int error)
{
    return (error == EAGAIN) || (error == EWOULDBLOCK) || (error == EINTR);
}

/* Write what the kernel takes now; keep the rest of what it began. */
static tb_can_result write_line(tb_slcan *slcan, const char *line, uint8_t length)
{
    ssize_t const written = write(slcan->device, line, length);
    if (written < 0) {
        return is_only_busy(errno) ? TB_CAN_FULL : lose_device(slcan);
    }
    if (written == 0) {
        return TB_CAN_FULL;
    }
    slcan->rest_length = 0;
    for (uint8_t i = (uint8_t)written; i < length; i++) {
        slcan->rest[slcan->rest_length] = line[i];
        slcan->rest_length++;
    }
    return TB_CAN_OK;
}

/* TB_CAN_OK when nothing of an earlier line is left. */
static tb_can_result finish_line(tb_slcan *slcan)
{
    if (slcan->rest_length == 0) {
        return TB_CAN_OK;
    }
    tb_can_result const result = write_line(slcan, slcan->rest, slcan->rest_length);
    return ((result == TB_CAN_OK) && (slcan->rest_length != 0)) ? TB_CAN_FULL : result;
}

static tb_can_result write_whole_line(tb_slcan *slcan, const char *line, uint8_t length)
{
    tb_can_result const finished = finish_line(slcan);
    return (finished == TB_CAN_OK) ? write_line(slcan, line, length) : finished;
}

static tb_can_result send_frame(tb_can_port *port, const tb_can_frame *frame)
{
    tb_slcan *const slcan = slcan_of(port);
    char line[TB_SLCAN_LONGEST_LINE];
    if (slcan->state == TB_CAN_NOT_OPEN) {
        return TB_CAN_CLOSED;
    }
    uint8_t const length = tb_slcan_write(frame, line);
    if (length == 0) {
        return TB_CAN_REFUSED;
    }
    tb_can_result const result = write_whole_line(slcan, line, length);
    if (result == TB_CAN_OK) {
        tb_can_count(&port->statistics.sent, 1);
    } else if (result == TB_CAN_FULL) {
        tb_can_count(&port->statistics.refused, 1);
    }
    return result;
}

/* One question at a time: an adapter that does not know this one is asked once. */
static void ask_for_status(tb_slcan *slcan)
{
    if (!slcan->asked) {
        slcan->asked = write_whole_line(slcan, "F\r", 2) == TB_CAN_OK;
    }
}

static void take_status(tb_slcan *slcan)
{
    tb_can_statistics *const statistics = &slcan->port.statistics;
    uint8_t const status = slcan->reader.status;
    slcan->asked = false;
    if ((status & (TB_SLCAN_RECEIVE_FULL | TB_SLCAN_OVERRUN)) != 0) {
        tb_can_count(&statistics->lost, 1);
    }
    if ((status & TB_SLCAN_BUS_ERROR) != 0) {
        tb_can_count(&statistics->bus_errors, 1);
    }
    slcan->state = TB_CAN_ERROR_ACTIVE;
    if ((status & TB_SLCAN_WARNING) != 0) {
        slcan->state = TB_CAN_ERROR_WARNING;
    }
    if ((status & TB_SLCAN_PASSIVE) != 0) {
        slcan->state = TB_CAN_ERROR_PASSIVE;
    }
}

/* What is no frame: counted, and its consequences drawn. */
static void take_answer(tb_slcan *slcan, tb_slcan_item item)
{
    if (item == TB_SLCAN_MALFORMED) {
        tb_can_count(&slcan->port.statistics.malformed, 1);
    } else if (item == TB_SLCAN_FAILED) {
        tb_can_count(&slcan->port.statistics.refused, 1);
        ask_for_status(slcan);
    } else if (item == TB_SLCAN_STATUS) {
        take_status(slcan);
    }
}

/* Read bytes up to the next item: TB_SLCAN_NOTHING when there are no more. */
static tb_slcan_item next_item(tb_slcan *slcan, tb_can_frame *frame)
{
    tb_slcan_item item = TB_SLCAN_NOTHING;
    while ((item == TB_SLCAN_NOTHING) && (slcan->next < slcan->end)) {
        item = tb_slcan_read(&slcan->reader, slcan->bytes[slcan->next], frame);
        slcan->next++;
    }
    return item;
}

static tb_can_result read_bytes(tb_slcan *slcan)
{
    ssize_t const count = read(slcan->device, slcan->bytes, sizeof slcan->bytes);
    slcan->next = 0;
    slcan->end = 0;
    if (count > 0) {
        slcan->end = (uint16_t)count;
        return TB_CAN_OK;
    }
    /* With VMIN = 1 only a line that was hung up reads 0 bytes. */
    return ((count < 0) && is_only_busy(errno)) ? TB_CAN_EMPTY : lose_device(slcan);
}

/* The next frame among the bytes that are here already. */
static bool next_frame(tb_slcan *slcan, tb_can_frame *frame)
{
    tb_slcan_item item = next_item(slcan, frame);
    while ((item != TB_SLCAN_FRAME) && (item != TB_SLCAN_NOTHING)) {
        take_answer(slcan, item);
        item = next_item(slcan, frame);
    }
    return item == TB_SLCAN_FRAME;
}

static tb_can_result receive_frame(tb_can_port *port, tb_can_frame *frame)
{
    tb_slcan *const slcan = slcan_of(port);
    tb_can_result result = (slcan->state == TB_CAN_NOT_OPEN) ? TB_CAN_CLOSED : TB_CAN_OK;
    for (uint8_t reads = 0; (result == TB_CAN_OK) && (reads < MOST_READS); reads++) {
        if (next_frame(slcan, frame)) {
            tb_can_count(&port->statistics.received, 1);
            return TB_CAN_OK;
        }
        result = read_bytes(slcan);
    }
    return (result == TB_CAN_OK) ? TB_CAN_EMPTY : result;
}

static tb_can_state bus_state(tb_can_port *port)
{
    tb_slcan *const slcan = slcan_of(port);
    bool const troubled = (slcan->state == TB_CAN_ERROR_WARNING) ||
                          (slcan->state == TB_CAN_ERROR_PASSIVE);
    if (troubled) {
        ask_for_status(slcan);
    }
    return slcan->state;
}

static int64_t milliseconds(void)
{
    struct timespec now;
    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return ((int64_t)now.tv_sec * 1000) + (now.tv_nsec / 1000000);
}

/* Wait for the device; false when `until` [ms] came first. */
static bool wait_for(const tb_slcan *slcan, short event, int64_t until)
{
    struct pollfd device = {slcan->device, event, 0};
    int64_t const left = until - milliseconds();
    return (left > 0) && (poll(&device, 1, (int)left) > 0);
}

static tb_can_result write_patiently(tb_slcan *slcan, const char *line, uint8_t length)
{
    int64_t const until = milliseconds() + ANSWER_TIME;
    tb_can_result result = write_whole_line(slcan, line, length);
    while ((result == TB_CAN_FULL) && wait_for(slcan, POLLOUT, until)) {
        result = write_whole_line(slcan, line, length);
    }
    return result;
}

/* Skip all that arrives until nothing does. */
static tb_can_result await_silence(tb_slcan *slcan)
{
    int64_t const until = milliseconds() + ANSWER_TIME;
    tb_can_result result = TB_CAN_OK;
    while ((result == TB_CAN_OK) && (milliseconds() < until) &&
           wait_for(slcan, POLLIN, milliseconds() + SILENCE)) {
        result = read_bytes(slcan);
    }
    slcan->next = slcan->end;
    tb_slcan_start(&slcan->reader);
    return (result == TB_CAN_EMPTY) ? TB_CAN_OK : result;
}

/* The answer among the bytes that are here; frames that another node sent are skipped. */
static tb_can_result find_answer(tb_slcan *slcan)
{
    tb_can_frame skipped;
    tb_slcan_item item = next_item(slcan, &skipped);
    while ((item == TB_SLCAN_FRAME) || (item == TB_SLCAN_STATUS) ||
           (item == TB_SLCAN_MALFORMED)) {
        item = next_item(slcan, &skipped);
    }
    if (item == TB_SLCAN_NOTHING) {
        return TB_CAN_EMPTY;
    }
    return (item == TB_SLCAN_DONE) ? TB_CAN_OK : TB_CAN_REFUSED;
}

/* TB_CAN_OK, TB_CAN_REFUSED, or TB_CAN_EMPTY when no answer comes. */
static tb_can_result await_answer(tb_slcan *slcan)
{
    int64_t const until = milliseconds() + ANSWER_TIME;
    tb_can_result result = TB_CAN_EMPTY;
    while ((result == TB_CAN_EMPTY) && wait_for(slcan, POLLIN, until)) {
        result = read_bytes(slcan);
        if (result == TB_CAN_OK) {
            result = find_answer(slcan);
        }
    }
    return result;
}

/* Send a command and hear what the adapter says; one that says nothing has agreed. */
static tb_can_result command(tb_slcan *slcan, const char *line, uint8_t length)
{
    tb_can_result result = write_patiently(slcan, line, length);
    if (result == TB_CAN_OK) {
        result = await_answer(slcan);
        slcan->answers = slcan->answers || (result == TB_CAN_OK);
    }
    return (result == TB_CAN_EMPTY) ? TB_CAN_OK : result;
}

static tb_can_result set_bit_rate(tb_slcan *slcan, uint32_t bit_rate)
{
    for (uint8_t i = 0; i < BIT_RATES; i++) {
        if (bit_rates[i] == bit_rate) {
            char const line[] = {'S', (char)('0' + i), '\r'};
            tb_can_result const result = command(slcan, line, sizeof line);
            return (result == TB_CAN_REFUSED) ? TB_CAN_BIT_RATE : result;
        }
    }
    return TB_CAN_BIT_RATE;
}

/* The first line ends whatever another program left unfinished; the second closes the bus. */
static tb_can_result open_bus(tb_slcan *slcan, uint32_t bit_rate)
{
    tb_can_result result = write_patiently(slcan, "C\rC\r", 4);
    if (result == TB_CAN_OK) {
        result = await_silence(slcan);
    }
    if (result == TB_CAN_OK) {
        result = set_bit_rate(slcan, bit_rate);
    }
    if (result == TB_CAN_OK) {
        result = command(slcan, "O\r", 2);
    }
    return (result == TB_CAN_FULL) ? TB_CAN_REFUSED : result;
}

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
static tb_can_result claim(int device)
{
    if (isatty(device) == 0) {
        return TB_CAN_NOT_CAN;
    }
    if (flock(device, LOCK_EX | LOCK_NB) != 0) {
        return TB_CAN_BUSY;
    }
    return (ioctl(device, TIOCEXCL) == 0) ? TB_CAN_OK : TB_CAN_NO_DEVICE;
}

/* Bytes as they are, none held back. */
static tb_can_result make_raw(int device)
{
    struct termios line;
    if (tcgetattr(device, &line) != 0) {
        return TB_CAN_NO_DEVICE;
    }
    cfmakeraw(&line);
    line.c_cflag |= (tcflag_t)(CLOCAL | CREAD);
    line.c_cc[VMIN] = 1;
    line.c_cc[VTIME] = 0;
    return (tcsetattr(device, TCSANOW, &line) == 0) ? TB_CAN_OK : TB_CAN_NO_DEVICE;
}

static tb_can_result open_device(tb_slcan *slcan, const char *path)
{
    int const device = open(path, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (device < 0) {
        return why_not_open(errno);
    }
    tb_can_result const result = claim(device);
    if (result != TB_CAN_OK) {
        (void)close(device);
        return result;
    }
    slcan->device = device;
    return make_raw(device);
}

/* What the adapter does not take in time is dropped: closing a line could wait for it for long. */
static void drain(const tb_slcan *slcan)
{
    int64_t const until = milliseconds() + CLOSING_TIME;
    int waiting = 0;
    bool left = (ioctl(slcan->device, TIOCOUTQ, &waiting) == 0) && (waiting > 0);
    while (left && (milliseconds() < until)) {
        (void)poll(NULL, 0, 1);
        left = (ioctl(slcan->device, TIOCOUTQ, &waiting) == 0) && (waiting > 0);
    }
    if (left) {
        (void)tcflush(slcan->device, TCOFLUSH);
    }
}

static void close_port(tb_can_port *port)
{
    tb_slcan *const slcan = slcan_of(port);
    if (slcan->device < 0) {
        return;
    }
    if (slcan->state != TB_CAN_NOT_OPEN) {
        (void)write_whole_line(slcan, "C\r", 2);
        drain(slcan);
        slcan->state = TB_CAN_NOT_OPEN;
    }
    (void)ioctl(slcan->device, TIOCNXCL);
    (void)close(slcan->device);
    slcan->device = CLOSED;
}

static const tb_can_driver driver = {send_frame, receive_frame, bus_state, close_port};

static void forget_all(tb_slcan *slcan)
{
    slcan->port.driver = &driver;
    slcan->port.statistics = nothing_yet;
    slcan->state = TB_CAN_NOT_OPEN;
    slcan->device = CLOSED;
    slcan->answers = false;
    slcan->asked = false;
    slcan->next = 0;
    slcan->end = 0;
    slcan->rest_length = 0;
    tb_slcan_start(&slcan->reader);
}

tb_can_result tb_slcan_open(tb_slcan *slcan, const char *path, uint32_t bit_rate)
{
    forget_all(slcan);
    tb_can_result result = open_device(slcan, path);
    if (result == TB_CAN_OK) {
        result = open_bus(slcan, bit_rate);
    }
    if (result == TB_CAN_OK) {
        slcan->state = TB_CAN_ERROR_ACTIVE;
    } else {
        close_port(&slcan->port);
    }
    return result;
}
