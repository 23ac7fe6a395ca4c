#include "slcan.h"

#include "serial_line.h"
#include "slcan_lines.h"

#define MOST_READS 4u /* system calls in one receive; more is no traffic, but a broken adapter */

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

/* Write what the kernel takes now; keep the rest of what it began. */
static tb_can_result write_now(tb_slcan *slcan, const char *line, uint8_t length)
{
    size_t written = 0;
    tb_can_result const result = tb_serial_write(slcan->device, line, length, &written);
    if (result != TB_CAN_OK) {
        return (result == TB_CAN_CLOSED) ? lose_device(slcan) : result;
    }
    slcan->rest_length = 0;
    for (size_t i = written; i < length; i++) {
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
    tb_can_result const result = write_now(slcan, slcan->rest, slcan->rest_length);
    return ((result == TB_CAN_OK) && (slcan->rest_length != 0)) ? TB_CAN_FULL : result;
}

tb_can_result tb_slcan_write_line(tb_slcan *slcan, const char *line, uint8_t length)
{
    tb_can_result const finished = finish_line(slcan);
    return (finished == TB_CAN_OK) ? write_now(slcan, line, length) : finished;
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
    tb_can_result const result = tb_slcan_write_line(slcan, line, length);
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
        slcan->asked = tb_slcan_write_line(slcan, "F\r", 2) == TB_CAN_OK;
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
    } else {
        /* done, or said again */
    }
}

tb_slcan_item tb_slcan_next_item(tb_slcan *slcan, tb_can_frame *frame)
{
    tb_slcan_item item = TB_SLCAN_NOTHING;
    while ((item == TB_SLCAN_NOTHING) && (slcan->next < slcan->end)) {
        item = tb_slcan_read(&slcan->reader, slcan->bytes[slcan->next], frame);
        slcan->next++;
    }
    return item;
}

tb_can_result tb_slcan_read_bytes(tb_slcan *slcan)
{
    size_t count = 0;
    tb_can_result const result =
        tb_serial_read(slcan->device, slcan->bytes, sizeof slcan->bytes, &count);
    slcan->next = 0;
    slcan->end = (uint16_t)count;
    return (result == TB_CAN_CLOSED) ? lose_device(slcan) : result;
}

/* The next frame among the bytes that are here already. */
static bool next_frame(tb_slcan *slcan, tb_can_frame *frame)
{
    tb_slcan_item item = tb_slcan_next_item(slcan, frame);
    while ((item != TB_SLCAN_FRAME) && (item != TB_SLCAN_NOTHING)) {
        take_answer(slcan, item);
        item = tb_slcan_next_item(slcan, frame);
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
        result = tb_slcan_read_bytes(slcan);
    }
    return (result == TB_CAN_OK) ? TB_CAN_EMPTY : result;
}

static tb_can_state bus_state(tb_can_port *port)
{
    tb_slcan *const slcan = slcan_of(port);
    bool const troubled =
        (slcan->state == TB_CAN_ERROR_WARNING) || (slcan->state == TB_CAN_ERROR_PASSIVE);
    if (troubled) {
        ask_for_status(slcan);
    }
    return slcan->state;
}

static void close_port(tb_can_port *port)
{
    tb_slcan *const slcan = slcan_of(port);
    bool const is_open = slcan->state != TB_CAN_NOT_OPEN;
    if (slcan->device < 0) {
        return;
    }
    if (is_open) {
        (void)tb_slcan_write_line(slcan, "C\r", 2);
    }
    tb_serial_close(slcan->device, is_open);
    slcan->device = TB_SERIAL_CLOSED;
    slcan->state = TB_CAN_NOT_OPEN;
}

static const tb_can_driver driver = {send_frame, receive_frame, bus_state, close_port};

void tb_slcan_forget(tb_slcan *slcan)
{
    slcan->port.driver = &driver;
    slcan->port.statistics = nothing_yet;
    slcan->state = TB_CAN_NOT_OPEN;
    slcan->device = TB_SERIAL_CLOSED;
    slcan->answers = false;
    slcan->asked = false;
    slcan->next = 0;
    slcan->end = 0;
    slcan->rest_length = 0;
    tb_slcan_start(&slcan->reader);
}
