/* The power stage's state machine, controlword and statusword (CiA 402-2, 7.3 and 7.4). */
#include "peer.h"

typedef enum { NONE, SHUTDOWN, SWITCH_ON, ENABLE, DISABLE_VOLTAGE, QUICK_STOP } command;

typedef struct {
    peer_power from;
    command command;
    peer_power to;
    unsigned number;
} transition;

static transition const transitions[] = {
    {PEER_SWITCH_ON_DISABLED, SHUTDOWN, PEER_READY, 2},
    {PEER_READY, SWITCH_ON, PEER_SWITCHED_ON, 3},
    {PEER_READY, ENABLE, PEER_SWITCHED_ON, 3},
    {PEER_SWITCHED_ON, ENABLE, PEER_OPERATION_ENABLED, 4},
    {PEER_OPERATION_ENABLED, SWITCH_ON, PEER_SWITCHED_ON, 5},
    {PEER_SWITCHED_ON, SHUTDOWN, PEER_READY, 6},
    {PEER_READY, DISABLE_VOLTAGE, PEER_SWITCH_ON_DISABLED, 7},
    {PEER_READY, QUICK_STOP, PEER_SWITCH_ON_DISABLED, 7},
    {PEER_OPERATION_ENABLED, SHUTDOWN, PEER_READY, 8},
    {PEER_OPERATION_ENABLED, DISABLE_VOLTAGE, PEER_SWITCH_ON_DISABLED, 9},
    {PEER_SWITCHED_ON, DISABLE_VOLTAGE, PEER_SWITCH_ON_DISABLED, 10},
    {PEER_SWITCHED_ON, QUICK_STOP, PEER_SWITCH_ON_DISABLED, 10},
    {PEER_OPERATION_ENABLED, QUICK_STOP, PEER_QUICK_STOP, 11},
    {PEER_QUICK_STOP, DISABLE_VOLTAGE, PEER_SWITCH_ON_DISABLED, 12},
    {PEER_QUICK_STOP, ENABLE, PEER_OPERATION_ENABLED, 16},
};

enum { FAULT_RESET = 0x80, STAYS_LEAST = 5 };

static command decode(uint16_t const word)
{
    static struct {
        uint16_t mask;
        uint16_t value;
        command command;
    } const patterns[] = {{0x87, 0x06, SHUTDOWN},
                          {0x8F, 0x07, SWITCH_ON},
                          {0x8F, 0x0F, ENABLE},
                          {0x82, 0x00, DISABLE_VOLTAGE},
                          {0x86, 0x02, QUICK_STOP}};
    for (size_t i = 0; i < sizeof patterns / sizeof patterns[0]; i++) {
        if ((word & patterns[i].mask) == patterns[i].value) {
            return patterns[i].command;
        }
    }
    return NONE;
}

bool cia402_powered(drive const *const d)
{
    peer_power const state = d->power.state;
    return state == PEER_SWITCHED_ON || state == PEER_OPERATION_ENABLED ||
           state == PEER_QUICK_STOP || (state == PEER_FAULT_REACTION && d->power.stopping);
}

static void enter(drive *const d, peer_power const state, unsigned const number)
{
    d->power.state = state;
    d->power.stopping = false;
    d->counters.transitions |= 1U << number;
    if (state != PEER_OPERATION_ENABLED) {
        homing_leave(d);
    }
    servo_take(d);
}

/* A ramp to standstill; then a transition. */
static void ramp(drive *const d, int const deceleration, peer_power const after,
                 unsigned const number)
{
    power *const w = &d->power;
    w->stopping = true;
    w->after = after;
    w->number = number;
    w->deceleration = (double)d->value[deceleration];
    homing_leave(d);
    servo_take(d);
    d->servo.demand_rate = d->servo.velocity;
}

static void quick_stop(drive *const d)
{
    enter(d, PEER_QUICK_STOP, 11);
    if (d->value[O_QUICK_STOP_OPTION] == 0) {
        enter(d, PEER_SWITCH_ON_DISABLED, 12);
        return;
    }
    bool const slow = d->value[O_QUICK_STOP_OPTION] == 1 || d->value[O_QUICK_STOP_OPTION] == 5;
    ramp(d, slow ? O_PROFILE_DECELERATION : O_QUICK_STOP_DECELERATION, PEER_SWITCH_ON_DISABLED, 12);
}

static bool ramps_first(drive const *const d, unsigned const number)
{
    return (number == 5 && d->value[O_DISABLE_OPTION] == 1) ||
           (number == 8 && d->value[O_SHUTDOWN_OPTION] == 1);
}

static bool allowed(drive const *const d, transition const *const t)
{
    power const *const w = &d->power;
    if (t->number == 16) {
        return d->value[O_QUICK_STOP_OPTION] >= STAYS_LEAST;
    }
    bool const ends_at_once = t->command == DISABLE_VOLTAGE || t->command == QUICK_STOP;
    return !w->stopping || ends_at_once;
}

static transition const *asked_for(drive const *const d)
{
    command const wanted = decode(d->power.controlword);
    for (size_t i = 0; i < sizeof transitions / sizeof transitions[0]; i++) {
        transition const *const t = &transitions[i];
        if (t->from == d->power.state && t->command == wanted && allowed(d, t)) {
            return t;
        }
    }
    return NULL;
}

static void take(drive *const d, transition const *const t)
{
    if (t->number == 11) {
        quick_stop(d);
    } else if (ramps_first(d, t->number)) {
        ramp(d, O_PROFILE_DECELERATION, t->to, t->number);
    } else {
        enter(d, t->to, t->number);
    }
}

static void obey(drive *const d)
{
    power *const w = &d->power;
    transition const *const t = w->pending ? asked_for(d) : NULL;
    if (t == NULL) {
        w->pending = w->pending && w->stopping;
        return;
    }
    if (d->peer->now - w->commanded >= d->config.variation.transition_delay) {
        w->commanded = d->peer->now;
        take(d, t);
    }
}

static void reset_fault(drive *const d)
{
    power *const w = &d->power;
    bool const edge = w->reset_edge;
    w->reset_edge = false;
    if (!edge || w->state != PEER_FAULT || w->latched) {
        return;
    }
    d->homing.homed = d->homing.homed && !w->referenced_off;
    w->referenced_off = false;
    enter(d, PEER_SWITCH_ON_DISABLED, 15);
    emergency_cleared(d);
}

static void end_ramp(drive *const d)
{
    power *const w = &d->power;
    bool const stays = w->state == PEER_QUICK_STOP && d->value[O_QUICK_STOP_OPTION] >= STAYS_LEAST;
    if (w->stopping && !stays && servo_standstill(d)) {
        enter(d, w->after, w->number);
    }
}

static void take_mode(drive *const d)
{
    int const wanted = (int)d->value[O_MODE];
    if (wanted != d->mode && d->peer->now >= d->mode_at) {
        homing_leave(d);
        d->mode = wanted;
        servo_take(d);
    }
    int const shown = d->config.variation.mode_display;
    d->value[O_MODE_DISPLAY] = shown != 0 ? shown : d->mode;
}

void cia402_tick(drive *const d)
{
    power *const w = &d->power;
    take_mode(d);
    if (w->state == PEER_NOT_READY) {
        enter(d, PEER_SWITCH_ON_DISABLED, 1);
        return;
    }
    if (w->state == PEER_FAULT_REACTION && !w->stopping) {
        enter(d, PEER_FAULT, 14);
        return;
    }
    end_ramp(d);
    reset_fault(d);
    obey(d);
}

void cia402_controlword(drive *const d, uint16_t const word)
{
    power *const w = &d->power;
    uint16_t const risen = (uint16_t)(word & ~w->controlword);
    if (!w->pending || decode(word) != decode(w->controlword)) {
        w->commanded = d->peer->now;
    }
    w->controlword = word;
    w->pending = true;
    w->reset_edge = w->reset_edge || (risen & FAULT_RESET) != 0;
    bool const homes = d->mode == 6 && w->state == PEER_OPERATION_ENABLED;
    if (homes && (risen & 0x10) != 0) {
        homing_begin(d);
    } else if (homes && (word & 0x110) != 0x010) {
        homing_stop(d);
    }
}

/* FAULT REACTION ACTIVE; with a deceleration's slot, the motor is driven to standstill first. */
static void react(drive *const d, int const deceleration)
{
    power *const w = &d->power;
    bool const driven = w->state == PEER_OPERATION_ENABLED || w->state == PEER_QUICK_STOP;
    if (w->state == PEER_FAULT) {
        return;
    }
    bool const again = w->state == PEER_FAULT_REACTION;
    if (again && (!w->stopping || deceleration != NO_SLOT)) {
        return;
    }
    enter(d, PEER_FAULT_REACTION, 13);
    if (driven && deceleration != NO_SLOT) {
        ramp(d, deceleration, PEER_FAULT, 14);
    }
}

static int fault_deceleration(drive const *const d)
{
    switch (d->value[O_FAULT_OPTION]) {
    case 1: return O_PROFILE_DECELERATION;
    case 2: return O_QUICK_STOP_DECELERATION;
    default: return NO_SLOT;
    }
}

void cia402_fault(drive *const d, bool const ramp_first)
{
    react(d, ramp_first ? fault_deceleration(d) : NO_SLOT);
}

static void disable_voltage(drive *const d)
{
    for (size_t i = 0; i < sizeof transitions / sizeof transitions[0]; i++) {
        transition const *const t = &transitions[i];
        if (t->from == d->power.state && t->command == DISABLE_VOLTAGE) {
            enter(d, t->to, t->number);
            return;
        }
    }
}

/* Options of 6007 as CiA 402 has them: commands to the state machine. */
static void act_as_commanded(drive *const d)
{
    peer_power const state = d->power.state;
    switch (d->value[O_ABORT_OPTION]) {
    case 1: cia402_fault(d, true); break;
    case 2: disable_voltage(d); break;
    case 3:
        if (state == PEER_OPERATION_ENABLED) {
            quick_stop(d);
        } else if (state != PEER_QUICK_STOP) {
            disable_voltage(d);
        }
        break;
    default: break;
    }
}

/* The same as an EPOS4 has them: the way into FAULT. */
static void act_as_fault(drive *const d)
{
    switch (d->value[O_ABORT_OPTION]) {
    case 1: cia402_fault(d, true); break;
    case 2: react(d, NO_SLOT); break;
    case 3: react(d, O_QUICK_STOP_DECELERATION); break;
    default: break;
    }
}

void cia402_connection_lost(drive *const d, uint16_t const code)
{
    d->power.pending = false;
    if (code != 0) {
        emergency_raise(d, code);
        d->power.latched = d->power.latched || emergency_is_latched(code);
    }
    if (code == 0 || d->config.variation.reaction_is_command) {
        act_as_commanded(d);
    } else {
        act_as_fault(d);
    }
}

void cia402_power_on(drive *const d)
{
    d->power = (power){.state = PEER_NOT_READY};
    d->homing = (homing){.phase = HOMING_IDLE};
    d->mode = (int)d->value[O_MODE];
    d->mode_at = 0;
    d->counters.transitions |= 1U;
    servo_reset(d);
    take_mode(d);
}

static uint16_t homing_bits(drive const *const d)
{
    switch (d->homing.phase) {
    case HOMING_SEEK: return 0x0000;
    case HOMING_MOVE: return 0x1000;
    case HOMING_DONE: return 0x1400;
    case HOMING_FAILED: return (uint16_t)(servo_standstill(d) ? 0x2400 : 0x2000);
    default: return 0x0400;
    }
}

static uint16_t mode_bits(drive const *const d)
{
    bool const driven = d->power.state == PEER_OPERATION_ENABLED && !d->power.stopping;
    if (d->mode == 6) {
        return driven || d->homing.phase == HOMING_DONE ? homing_bits(d) : 0;
    }
    return driven && (d->mode == 8 || d->mode == 10) ? 0x1000 : 0;
}

static uint16_t varied(drive const *const d, uint32_t word)
{
    peer_variation const *const v = &d->config.variation;
    bool const quick_stop_means = (word & 0x4F) != 0x40 && (word & 0x08) == 0 && (word & 0x4F) != 0;
    word |= v->status_set & (quick_stop_means ? ~0x20U : ~0U);
    word ^= d->toggled ? v->status_toggle : 0;
    return (uint16_t)(v->status_forced != 0 ? v->status_forced : word);
}

uint16_t cia402_statusword(drive const *const d)
{
    static uint16_t const pattern[] = {0x00, 0x40, 0x21, 0x23, 0x27, 0x07, 0x0F, 0x08};
    bool const remote = d->nmt == PEER_OPERATIONAL && !d->config.variation.remote_clear;
    uint32_t word = pattern[d->power.state] | mode_bits(d);
    word |= cia402_powered(d) ? 0x0010U : 0;
    word |= d->power.warning ? 0x0080U : 0;
    word |= remote ? 0x0200U : 0;
    word |= d->servo.limited ? 0x0800U : 0;
    word |= d->homing.homed ? 0x8000U : 0;
    return varied(d, word);
}

peer_power peer_power_state(peer const *const p, uint32_t const number)
{
    return p->drive[number].power.state;
}
