#include "publish.h"

#include <stddef.h>
#include <string.h>

#include "sentence.h"

static void widen(size_t count, const real_t from[], double to[])
{
    for (size_t i = 0; i < count; i++) {
        to[i] = (double)from[i];
    }
}

static void fill_drive(const tb_drive_report *seen, const tb_drive_order *order,
                       tb_telemetry_drive *drive)
{
    *drive = (tb_telemetry_drive){
        .position = (double)seen->position,
        .torque = (double)seen->torque,
        .ordered_torque = (double)order->torque,
        .statusword = seen->statusword,
        .error_code = seen->error_code,
        .power = seen->power,
        .mode = seen->mode,
        .homing = seen->homing,
        .fresh = seen->fresh,
        .missed = seen->missed,
        .silent = seen->silent,
        .task = seen->task,
        .progress = seen->progress,
        .goal = order->goal,
    };
}

static void fill_controller(const tb_outputs *outputs, tb_telemetry_cycle *cycle)
{
    widen(TB_DOF, outputs->pose, cycle->pose);
    widen(TB_DOF, outputs->velocity, cycle->velocity);
    widen(TB_DOF, outputs->wanted_force, cycle->wanted_force);
    widen(TB_DOF, outputs->delivered_force, cycle->delivered_force);
    widen(TB_CABLES, outputs->tension, cycle->tension);
    widen(TB_RAIL_SLOTS, outputs->rail_target, cycle->rail_target);
    cycle->residual = (double)outputs->residual;
    cycle->status = outputs->status;
}

static void publish_cycle(const tb_loop *loop, int64_t time)
{
    const tb_observation *const seen = &loop->master->seen;
    const tb_orders *const orders = &loop->master->orders;
    tb_telemetry_cycle cycle = {
        .number = loop->number,
        .time = time,
        .missed = seen->missed,
        .requests = seen->requests,
        .state = orders->state,
        .phase = orders->phase,
        .cause = orders->cause,
        .beat = orders->beat,
    };
    fill_controller(&orders->controller, &cycle);
    widen(TB_DOF, seen->force, cycle.force);
    widen(TB_CABLES, orders->slack, cycle.slack);
    for (size_t i = 0; i < TB_DRIVES; i++) {
        fill_drive(&seen->drives[i], &orders->drives[i], &cycle.drives[i]);
    }
    tb_telemetry_append(loop->telemetry, &cycle);
}

static tb_telemetry_bus count_bus(tb_can_port *port, const tb_bus_table *bus)
{
    const tb_can_statistics *const counted = &port->statistics;
    return (tb_telemetry_bus){
        .bits = counted->bits,
        .state = (uint32_t)tb_can_port_state(port),
        .sent = counted->sent,
        .received = counted->received,
        .refused = counted->refused,
        .lost = counted->lost,
        .malformed = counted->malformed,
        .bus_errors = counted->bus_errors,
        .bus_off = counted->bus_off,
        .bit_rate = bus->bit_rate,
        .divider = bus->divider,
    };
}

static void tell_in_words(const tb_loop *loop, tb_telemetry_status *status)
{
    const tb_orders *const orders = &loop->master->orders;
    strncpy(status->doing, tb_sentence_of_state(orders), sizeof status->doing - 1u);
    tb_sentence_of_cause(orders, sizeof status->cause, status->cause);
    tb_reopening_tell(&loop->reopening, sizeof status->cause, status->cause);
}

static void publish_status(const tb_loop *loop)
{
    tb_telemetry_status status = {.published = loop->number + 1u, .times = loop->times};
    for (size_t i = 0; i < TB_BUSES; i++) {
        status.buses[i] = count_bus(loop->ports[i], &tb_buses[i]);
    }
    tell_in_words(loop, &status);
    tb_telemetry_tell(loop->telemetry, &status);
}

void tb_publish(const tb_loop *loop, int64_t time)
{
    publish_cycle(loop, time);
    publish_status(loop);
}
