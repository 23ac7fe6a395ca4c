#include "network.h"

#include <stdbool.h>
#include <stddef.h>

#include "cob.h"
#include "nmt.h"
#include "sync.h"

/* More than a bus carries in two cycles: a flood of frames cannot hold the loop. */
#define MOST_FRAMES_AT_ONCE 64u
/* More than a port keeps from before the start. */
#define MOST_OLD_FRAMES 1024u

static const tb_bus fresh_bus;

static void count_up(uint8_t *count)
{
    *count = (*count < UINT8_MAX) ? (uint8_t)(*count + 1u) : *count;
}

/* What has come until now is an older story. A port that reads nothing but malformed text answers
 * TB_CAN_EMPTY although more may wait. */
static void take_over(tb_bus *bus, tb_can_port *port)
{
    tb_can_frame old;
    *bus = fresh_bus;
    bus->port = port;
    for (size_t i = 0; i < MOST_OLD_FRAMES; i++) {
        (void)tb_can_receive(port, &old);
    }
    bus->unreadable = port->statistics.malformed;
}

/* ---- Sending ---- */

static bool is_usable(const tb_bus *bus)
{
    tb_can_state const state = tb_can_port_state(bus->port);
    return (state != TB_CAN_BUS_OFF) && (state != TB_CAN_NOT_OPEN);
}

static void send(tb_bus *bus, const tb_can_frame *frame)
{
    if (tb_can_send(bus->port, frame) == TB_CAN_OK) {
        tb_echo_keep(&bus->echo, frame);
    } else {
        count_up(&bus->refused);
    }
}

/* ---- Receiving ---- */

/* The set that holds one function of COB identifiers; sets are joined by `|`. */
#define SET_OF(function) ((uint32_t)1 << ((function) >> TB_COB_NODE_BITS))

static bool is_in(uint32_t set, uint32_t id)
{
    return ((set >> (id >> TB_COB_NODE_BITS)) & 1u) != 0;
}

/* Frames that only a CANopen master sends. */
static bool is_from_a_master(uint32_t id)
{
    uint32_t const functions = SET_OF(TB_COB_RPDO1) | SET_OF(TB_COB_RPDO2) | SET_OF(TB_COB_RPDO3) |
                               SET_OF(TB_COB_RPDO4) | SET_OF(TB_COB_SDO_REQUEST);
    return is_in(functions, id) || (id == TB_COB_NMT) || (id == TB_COB_SYNC) ||
           (id == TB_COB_TIME) || (id == (TB_COB_ERROR_CONTROL + TB_MASTER_NODE));
}

static bool is_from_a_drive(uint32_t id)
{
    uint32_t const functions = SET_OF(TB_COB_EMCY) | SET_OF(TB_COB_TPDO1) | SET_OF(TB_COB_TPDO2) |
                               SET_OF(TB_COB_TPDO3) | SET_OF(TB_COB_TPDO4) |
                               SET_OF(TB_COB_SDO_ANSWER) | SET_OF(TB_COB_ERROR_CONTROL);
    return is_in(functions, id) && ((id & TB_COB_NODE_MASK) != 0);
}

static tb_drive_link *find_link(tb_network *network, size_t bus, uint32_t node)
{
    for (size_t i = 0; i < TB_DRIVES; i++) {
        if ((tb_drives[i].bus == bus) && (tb_drives[i].node == node)) {
            return &network->links[i];
        }
    }
    return NULL;
}

/* A frame that another node of the machine file may send. */
static bool is_from_another_node(size_t bus, uint32_t id)
{
    for (size_t i = 0; i < TB_NODE_FRAMES; i++) {
        if ((tb_node_frames[i].bus == bus) && (tb_node_frames[i].id == id)) {
            return true;
        }
    }
    return false;
}

static void name_stranger(tb_bus *bus, uint32_t who)
{
    bus->stranger = (bus->stranger == 0) ? (uint8_t)who : bus->stranger;
}

static void name_other_master(tb_bus *bus, const tb_can_frame *frame)
{
    if (!tb_echo_take(&bus->echo, frame)) {
        name_stranger(bus, TB_STRANGER_MASTER | (frame->id >> TB_COB_NODE_BITS));
    }
}

static void route(tb_network *network, size_t index, const tb_can_frame *frame, bool in_time)
{
    tb_bus *const bus = &network->buses[index];
    uint32_t const node = frame->id & TB_COB_NODE_MASK;
    tb_drive_link *const link = find_link(network, index, node);
    if ((frame->flags != 0) || (frame->id > TB_COB_LARGEST)) {
        count_up(&bus->malformed);
    } else if (is_from_another_node(index, frame->id)) {
        /* none of the machine's business */
    } else if (is_from_a_master(frame->id)) {
        name_other_master(bus, frame);
    } else if (!is_from_a_drive(frame->id)) {
        count_up(&bus->malformed);
    } else if (link == NULL) {
        name_stranger(bus, node);
    } else if (!tb_drive_link_take(link, frame, in_time)) {
        count_up(&bus->malformed);
    } else {
        tb_echo_hear(&bus->echo);
    }
}

static void drain(tb_network *network, size_t index, bool in_time)
{
    tb_can_frame frame;
    for (size_t i = 0; i < MOST_FRAMES_AT_ONCE; i++) {
        if (tb_can_receive(network->buses[index].port, &frame) != TB_CAN_OK) {
            break;
        }
        route(network, index, &frame, in_time);
    }
}

/* ---- SYNC ---- */

/* Cycles since the last SYNC of a bus. */
static uint8_t age_of_sync(const tb_network *network, size_t bus)
{
    return (uint8_t)(network->cycle % tb_buses[bus].divider);
}

static void sync_bus(tb_bus *bus)
{
    tb_can_frame const frame = tb_sync_frame();
    bus->synced = is_usable(bus) ? 1 : 0;
    if (bus->synced != 0) {
        send(bus, &frame);
    }
}

/* A SYNC went out in this cycle. */
static bool is_synced(const tb_network *network, size_t bus)
{
    return (network->buses[bus].synced != 0) && (age_of_sync(network, bus) == 0);
}

static void sync(tb_fieldbus *fieldbus)
{
    tb_network *const network = (tb_network *)fieldbus;
    for (size_t i = 0; i < TB_BUSES; i++) {
        bool const is_due = age_of_sync(network, i) == 0;
        drain(network, i, !is_due);
        if (is_due) {
            sync_bus(&network->buses[i]);
        }
    }
    for (size_t i = 0; i < TB_DRIVES; i++) {
        tb_drive_link_sync(&network->links[i], is_synced(network, tb_drives[i].bus));
    }
}

/* ---- Collect ---- */

static tb_bus_state state_of(tb_can_port *port)
{
    static const tb_bus_state states[] = {
        [TB_CAN_ERROR_ACTIVE] = TB_BUS_ACTIVE,   [TB_CAN_ERROR_WARNING] = TB_BUS_WARNING,
        [TB_CAN_ERROR_PASSIVE] = TB_BUS_PASSIVE, [TB_CAN_BUS_OFF] = TB_BUS_OFF,
        [TB_CAN_NOT_OPEN] = TB_BUS_NOT_OPEN,
    };
    return states[tb_can_port_state(port)];
}

/* What arrived and was no frame: only the port has seen it. */
static void count_unreadable(tb_bus *bus)
{
    uint32_t const until_now = bus->port->statistics.malformed;
    for (uint32_t i = bus->unreadable; (i < until_now) && (bus->malformed < UINT8_MAX); i++) {
        count_up(&bus->malformed);
    }
    bus->unreadable = until_now;
}

static void report_bus(tb_bus *bus, tb_bus_report *report)
{
    count_unreadable(bus);
    report->state = (uint8_t)state_of(bus->port);
    report->refused = bus->refused;
    report->stranger = bus->stranger;
    report->malformed = bus->malformed;
    bus->refused = 0;
    bus->stranger = 0;
    bus->malformed = 0;
}

static void collect(tb_fieldbus *fieldbus, tb_observation *seen)
{
    tb_network *const network = (tb_network *)fieldbus;
    for (size_t i = 0; i < TB_BUSES; i++) {
        drain(network, i, true);
        report_bus(&network->buses[i], &seen->buses[i]);
    }
    for (size_t i = 0; i < TB_DRIVES; i++) {
        size_t const bus = tb_drives[i].bus;
        uint8_t const age = age_of_sync(network, bus);
        bool const is_over = (age + 1) == tb_buses[bus].divider;
        tb_drive_link_report(&network->links[i], age, is_over && (network->buses[bus].synced != 0),
                             &seen->drives[i]);
    }
}

/* ---- Dispatch ---- */

static void send_setpoints(tb_network *network, size_t index, const tb_orders *orders)
{
    tb_can_frame frame;
    for (size_t i = 0; i < TB_DRIVES; i++) {
        if ((tb_drives[i].bus == index) &&
            tb_drive_link_setpoint(&network->links[i], &orders->drives[i], &frame)) {
            send(&network->buses[index], &frame);
        }
    }
}

static void send_heartbeat(const tb_network *network, tb_bus *bus, const tb_orders *orders)
{
    tb_can_frame const frame = tb_heartbeat_frame(TB_MASTER_NODE, TB_NMT_OPERATIONAL);
    if ((orders->beat != 0) && ((network->cycle % (uint32_t)TB_HEARTBEAT_CYCLES) == 0)) {
        send(bus, &frame);
    }
}

/* The drives of a bus take turns; the one after the last served comes first. */
static void send_acyclic(tb_network *network, size_t index)
{
    tb_bus *const bus = &network->buses[index];
    tb_can_frame frame;
    for (size_t i = 1; i <= TB_DRIVES; i++) {
        size_t const drive = (bus->served + i) % TB_DRIVES;
        if ((tb_drives[drive].bus == index) &&
            tb_drive_link_acyclic(&network->links[drive], &frame)) {
            bus->served = (uint8_t)drive;
            send(bus, &frame);
            break;
        }
    }
}

static void dispatch_bus(tb_network *network, size_t index, const tb_orders *orders)
{
    tb_bus *const bus = &network->buses[index];
    if (!is_usable(bus)) {
        return;
    }
    if (is_synced(network, index)) {
        send_setpoints(network, index, orders);
    }
    send_heartbeat(network, bus, orders);
    send_acyclic(network, index);
}

static void dispatch(tb_fieldbus *fieldbus, const tb_orders *orders)
{
    tb_network *const network = (tb_network *)fieldbus;
    for (size_t i = 0; i < TB_DRIVES; i++) {
        tb_drive_order const *const order = &orders->drives[i];
        tb_setup_order(&network->links[i].setup, (tb_task)order->task, (tb_mode)order->mode);
    }
    for (size_t i = 0; i < TB_BUSES; i++) {
        dispatch_bus(network, i, orders);
    }
    network->cycle++;
}

/* ---- The fieldbus ---- */

static const tb_fieldbus_protocol canopen = {sync, collect, dispatch};

void tb_network_start(tb_network *network, tb_can_port *const ports[TB_BUSES])
{
    network->fieldbus.protocol = &canopen;
    network->cycle = 0;
    for (size_t i = 0; i < TB_BUSES; i++) {
        take_over(&network->buses[i], ports[i]);
    }
    for (size_t i = 0; i < TB_DRIVES; i++) {
        tb_drive_link_start(&network->links[i], &tb_drives[i]);
    }
}
