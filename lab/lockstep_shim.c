/* What lab/lockstep.py needs around the runtime to drive it from Python: a machine's master with its
 * buses in memory, frames packed into arrays. Runs on a host only; nothing of it goes to a machine. */
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "can_layout.h"
#include "cycle_layout.h"
#include "loopback.h"
#include "master.h"
#include "network.h"

/** A frame on one of the buses. */
typedef struct {
    uint8_t bus;
    uint8_t length;
    uint16_t id;
    uint8_t data[8];
} shim_frame;

/** What there is to see of a cycle. */
typedef struct {
    uint32_t state;
    uint32_t phase;
    uint32_t cause;
    uint32_t culprit;
    uint32_t index;
    uint32_t subindex;
    uint32_t failure;
    uint32_t detail;
    uint32_t beat;
    int32_t status;
    real_t pose[TB_DOF];
    real_t residual;
    real_t wanted_force[TB_DOF];
    real_t delivered_force[TB_DOF];
    real_t tension[TB_CABLES];
    real_t zeros[TB_CABLES];
    real_t position[TB_DRIVES];
    real_t ordered[TB_DRIVES]; /* N m; m of a drive that follows a position */
    real_t led[TB_RAIL_SLOTS]; /* m, where bases are led to; NaN: nowhere */
    uint32_t power[TB_DRIVES];
} tb_view;

typedef struct {
    tb_loopback buses[TB_BUSES];
    tb_network network;
    tb_master master;
} shim_machine;

extern const tb_layout_row shim_layout[];
extern const uint32_t shim_layout_rows;
size_t shim_machine_size(void);
void shim_start(shim_machine *machine);
void shim_adopt(shim_machine *machine);
size_t shim_sync(shim_machine *machine, shim_frame sent[], size_t room);
size_t shim_run(shim_machine *machine, const tb_wishes *wishes, uint32_t missed, shim_frame sent[],
                size_t room);
size_t shim_give(shim_machine *machine, const shim_frame arrived[], size_t count);
void shim_look(const shim_machine *machine, tb_view *view);
void shim_set_bus(shim_machine *machine, size_t bus, uint32_t state, uint32_t full);

#define SHIM_LAYOUT                                                                                \
    TB_LAYOUT_STRUCT(wishes)                                                                       \
    TB_LAYOUT_NUMBER(wishes, requests)                                                             \
    TB_LAYOUT_NUMBER(wishes, hand_force_fresh)                                                     \
    TB_LAYOUT_NUMBERS(wishes, force)                                                               \
    TB_LAYOUT_NUMBERS(wishes, hand_force)                                                          \
    TB_LAYOUT_STRUCT(view)                                                                         \
    TB_LAYOUT_NUMBER(view, state)                                                                  \
    TB_LAYOUT_NUMBER(view, phase)                                                                  \
    TB_LAYOUT_NUMBER(view, cause)                                                                  \
    TB_LAYOUT_NUMBER(view, culprit)                                                                \
    TB_LAYOUT_NUMBER(view, index)                                                                  \
    TB_LAYOUT_NUMBER(view, subindex)                                                               \
    TB_LAYOUT_NUMBER(view, failure)                                                                \
    TB_LAYOUT_NUMBER(view, detail)                                                                 \
    TB_LAYOUT_NUMBER(view, beat)                                                                   \
    TB_LAYOUT_NUMBER(view, status)                                                                 \
    TB_LAYOUT_NUMBERS(view, pose)                                                                  \
    TB_LAYOUT_NUMBER(view, residual)                                                               \
    TB_LAYOUT_NUMBERS(view, wanted_force)                                                          \
    TB_LAYOUT_NUMBERS(view, delivered_force)                                                       \
    TB_LAYOUT_NUMBERS(view, tension)                                                               \
    TB_LAYOUT_NUMBERS(view, zeros)                                                                 \
    TB_LAYOUT_NUMBERS(view, position)                                                              \
    TB_LAYOUT_NUMBERS(view, ordered)                                                               \
    TB_LAYOUT_NUMBERS(view, led)                                                                   \
    TB_LAYOUT_NUMBERS(view, power)

const tb_layout_row shim_layout[] = {SHIM_LAYOUT TB_ENUMERATIONS_LAYOUT TB_CAN_LAYOUT};

const uint32_t shim_layout_rows = sizeof(shim_layout) / sizeof(shim_layout[0]);

size_t shim_machine_size(void)
{
    return sizeof(shim_machine);
}

void shim_start(shim_machine *machine)
{
    tb_can_port *ports[TB_BUSES];
    for (size_t i = 0; i < TB_BUSES; i++) {
        tb_loopback_open(&machine->buses[i]);
        ports[i] = &machine->buses[i].port;
    }
    tb_network_start(&machine->network, ports);
    tb_master_start(&machine->master, &machine->network.fieldbus);
}

/* A machine that another build of the runtime started calls this one's functions from now on. */
void shim_adopt(shim_machine *machine)
{
    static shim_machine own;
    shim_start(&own);
    machine->network.fieldbus = own.network.fieldbus;
    for (size_t i = 0; i < TB_BUSES; i++) {
        machine->buses[i].port.driver = own.buses[i].port.driver;
    }
}

/* What the master has sent on all buses since the last time. */
static size_t take_sent(shim_machine *machine, shim_frame sent[], size_t room)
{
    size_t count = 0;
    tb_can_frame frame;
    for (size_t bus = 0; bus < TB_BUSES; bus++) {
        while ((count < room) && (tb_loopback_take(&machine->buses[bus], &frame) == TB_CAN_OK)) {
            shim_frame *const to = &sent[count];
            to->bus = (uint8_t)bus;
            to->length = frame.length;
            to->id = (uint16_t)frame.id;
            for (size_t i = 0; i < sizeof to->data; i++) {
                to->data[i] = frame.data[i];
            }
            count++;
        }
    }
    return count;
}

size_t shim_sync(shim_machine *machine, shim_frame sent[], size_t room)
{
    tb_master_sync(&machine->master);
    return take_sent(machine, sent, room);
}

size_t shim_run(shim_machine *machine, const tb_wishes *wishes, uint32_t missed, shim_frame sent[],
                size_t room)
{
    tb_master_run(&machine->master, wishes, missed);
    return take_sent(machine, sent, room);
}

/* The number of frames for which there was room. */
size_t shim_give(shim_machine *machine, const shim_frame arrived[], size_t count)
{
    size_t taken = 0;
    for (size_t i = 0; i < count; i++) {
        const shim_frame *const from = &arrived[i];
        tb_can_frame frame = {.id = from->id, .length = from->length};
        for (size_t k = 0; k < sizeof from->data; k++) {
            frame.data[k] = from->data[k];
        }
        taken += (tb_loopback_give(&machine->buses[from->bus], &frame) == TB_CAN_OK) ? 1u : 0u;
    }
    return taken;
}

/* In HOME from the first time that bases are guided, until the controller moves them itself in RUN. */
static real_t led_to(const tb_supervisor *supervisor, size_t rail)
{
    bool const by_controller =
        (supervisor->state == TB_STATE_RUN) || (supervisor->phase == TB_PHASE_CLOSE);
    bool const by_guide =
        (supervisor->state == TB_STATE_TENSION) ||
        ((supervisor->state == TB_STATE_HOME) && (supervisor->phase >= TB_PHASE_GATHER));
    if (by_controller) {
        return supervisor->outputs.rail_target[rail];
    }
    return by_guide ? supervisor->guide.reference[rail] : (real_t)NAN;
}

void shim_look(const shim_machine *machine, tb_view *view)
{
    const tb_master *const master = &machine->master;
    const tb_orders *const orders = &master->orders;
    view->state = orders->state;
    view->phase = orders->phase;
    view->cause = orders->cause;
    view->culprit = orders->culprit;
    view->index = orders->index;
    view->subindex = orders->subindex;
    view->failure = orders->failure;
    view->detail = orders->detail;
    view->beat = orders->beat;
    view->status = orders->controller.status;
    view->residual = orders->controller.residual;
    for (size_t i = 0; i < TB_DOF; i++) {
        view->pose[i] = orders->controller.pose[i];
        view->wanted_force[i] = orders->controller.wanted_force[i];
        view->delivered_force[i] = orders->controller.delivered_force[i];
    }
    for (size_t i = 0; i < TB_CABLES; i++) {
        view->tension[i] = orders->controller.tension[i];
        view->zeros[i] = master->supervisor.calibration.zeros[i];
    }
    for (size_t i = 0; i < TB_RAIL_SLOTS; i++) {
        view->led[i] = led_to(&master->supervisor, i);
    }
    for (size_t i = 0; i < TB_DRIVES; i++) {
        const tb_drive_order *const order = &orders->drives[i];
        view->position[i] = master->seen.drives[i].position;
        view->ordered[i] = (tb_drives[i].mode == 1) ? order->position : order->torque;
        view->power[i] = master->seen.drives[i].power;
    }
}

void shim_set_bus(shim_machine *machine, size_t bus, uint32_t state, uint32_t full)
{
    tb_loopback_set_state(&machine->buses[bus], (tb_can_state)state);
    tb_loopback_set_full(&machine->buses[bus], full != 0u);
}
