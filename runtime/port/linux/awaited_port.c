#define _POSIX_C_SOURCE 200809L
#include "awaited_port.h"

#include <time.h>

#define NAP 50000L         /* ns, between two looks */
#define MOST_NAPS 6000000u /* five minutes, longer where the computer is busy */

static tb_awaited_port *awaited_of(tb_can_port *port)
{
    return (tb_awaited_port *)(void *)port;
}

static tb_can_result send_frame(tb_can_port *port, const tb_can_frame *frame)
{
    tb_awaited_port *const awaited = awaited_of(port);
    tb_can_result const result = tb_can_send(awaited->line, frame);
    awaited->sent += (result == TB_CAN_OK) ? 1u : 0u;
    return result;
}

static bool is_due(const tb_awaited_port *awaited, tb_can_result result)
{
    return (result == TB_CAN_EMPTY) && (awaited->received < awaited->promised);
}

static tb_can_result look_again(tb_awaited_port *awaited, tb_can_frame *frame)
{
    struct timespec const nap = {.tv_nsec = NAP};
    (void)clock_nanosleep(CLOCK_MONOTONIC, 0, &nap, NULL);
    return tb_can_receive(awaited->line, frame);
}

static tb_can_result receive_frame(tb_can_port *port, tb_can_frame *frame)
{
    tb_awaited_port *const awaited = awaited_of(port);
    tb_can_result result = tb_can_receive(awaited->line, frame);
    for (uint32_t naps = 0; is_due(awaited, result) && (naps < MOST_NAPS); naps++) {
        result = look_again(awaited, frame);
    }
    awaited->deceived = awaited->deceived || is_due(awaited, result);
    if (result == TB_CAN_OK) {
        awaited->received++;
    } else {
        awaited->received = awaited->promised; /* what a device had that has gone, has gone too */
    }
    return result;
}

static tb_can_state bus_state(tb_can_port *port)
{
    return tb_can_port_state(awaited_of(port)->line);
}

static void close_port(tb_can_port *port)
{
    tb_can_close(awaited_of(port)->line);
}

static const tb_can_driver driver = {send_frame, receive_frame, bus_state, close_port};

void tb_awaited_port_start(tb_awaited_port *awaited, tb_can_port *line)
{
    *awaited = (tb_awaited_port){.port = {.driver = &driver}, .line = line};
}
