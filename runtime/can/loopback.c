#include "loopback.h"

static tb_loopback *loopback_of(tb_can_port *port)
{
    return (tb_loopback *)(void *)port;
}

static bool put(tb_loopback_ring *ring, const tb_can_frame *frame)
{
    if (ring->count == TB_LOOPBACK_DEPTH) {
        return false;
    }
    ring->frames[(ring->first + ring->count) % TB_LOOPBACK_DEPTH] = *frame;
    ring->count++;
    return true;
}

static bool get(tb_loopback_ring *ring, tb_can_frame *frame)
{
    if (ring->count == 0) {
        return false;
    }
    *frame = ring->frames[ring->first];
    ring->first = (ring->first + 1u) % TB_LOOPBACK_DEPTH;
    ring->count--;
    return true;
}

static void drop_all(tb_loopback *loopback)
{
    loopback->sent.first = 0;
    loopback->sent.count = 0;
    loopback->arrived.first = 0;
    loopback->arrived.count = 0;
}

static tb_can_result send_frame(tb_can_port *port, const tb_can_frame *frame)
{
    tb_loopback *const loopback = loopback_of(port);
    if (loopback->state == TB_CAN_NOT_OPEN) {
        return TB_CAN_CLOSED;
    }
    if (!tb_can_is_frame(frame)) {
        return TB_CAN_REFUSED;
    }
    if ((loopback->state == TB_CAN_BUS_OFF) || loopback->full || !put(&loopback->sent, frame)) {
        tb_can_count(&port->statistics.refused, 1);
        return TB_CAN_FULL;
    }
    tb_can_count(&port->statistics.sent, 1);
    return TB_CAN_OK;
}

static tb_can_result receive_frame(tb_can_port *port, tb_can_frame *frame)
{
    tb_loopback *const loopback = loopback_of(port);
    if (loopback->state == TB_CAN_NOT_OPEN) {
        return TB_CAN_CLOSED;
    }
    if (!get(&loopback->arrived, frame)) {
        return TB_CAN_EMPTY;
    }
    tb_can_count(&port->statistics.received, 1);
    return TB_CAN_OK;
}

static tb_can_state bus_state(tb_can_port *port)
{
    return loopback_of(port)->state;
}

static void close_port(tb_can_port *port)
{
    tb_loopback_set_state(loopback_of(port), TB_CAN_NOT_OPEN);
}

static const tb_can_driver driver = {send_frame, receive_frame, bus_state, close_port};
static const tb_can_statistics nothing_yet = {0};

void tb_loopback_open(tb_loopback *loopback)
{
    loopback->port.driver = &driver;
    loopback->port.statistics = nothing_yet;
    loopback->state = TB_CAN_ERROR_ACTIVE;
    loopback->full = false;
    drop_all(loopback);
}

tb_can_result tb_loopback_take(tb_loopback *loopback, tb_can_frame *frame)
{
    return get(&loopback->sent, frame) ? TB_CAN_OK : TB_CAN_EMPTY;
}

tb_can_result tb_loopback_give(tb_loopback *loopback, const tb_can_frame *frame)
{
    if ((loopback->state == TB_CAN_NOT_OPEN) || (loopback->state == TB_CAN_BUS_OFF)) {
        return TB_CAN_CLOSED;
    }
    if (!tb_can_is_frame(frame)) {
        return TB_CAN_REFUSED;
    }
    if (!put(&loopback->arrived, frame)) {
        tb_can_count(&loopback->port.statistics.lost, 1);
        return TB_CAN_FULL;
    }
    return TB_CAN_OK;
}

void tb_loopback_set_state(tb_loopback *loopback, tb_can_state state)
{
    if (loopback->state == TB_CAN_NOT_OPEN) {
        return;
    }
    if ((state == TB_CAN_BUS_OFF) && (loopback->state != TB_CAN_BUS_OFF)) {
        tb_can_count(&loopback->port.statistics.bus_off, 1);
    }
    if (state == TB_CAN_NOT_OPEN) {
        drop_all(loopback);
    }
    loopback->state = state;
}

void tb_loopback_set_full(tb_loopback *loopback, bool full)
{
    loopback->full = full;
}
