/* Network management of a drive: boot-up, states, heartbeats both ways (CiA 301, 7.2.8). */
#include "peer.h"

enum { START = 0x01, STOP = 0x02, PRE_OPERATIONAL = 0x80, RESET_NODE = 0x81, RESET_COMM = 0x82 };

static void transmit_state(drive *const d)
{
    uint8_t const state = (uint8_t)d->nmt;
    drive_transmit(d, 0x700 + d->config.node, &state, 1, d->peer->now);
}

static peer_time producer_period(drive const *const d)
{
    uint32_t const percent = d->config.variation.heartbeat_percent;
    return d->value[O_PRODUCER] * MILLISECOND * (percent == 0 ? 100 : (peer_time)percent) / 100;
}

void nmt_boot(drive *const d, peer_time const delay)
{
    d->nmt = PEER_INITIALISING;
    d->boot_at = d->peer->now + delay;
    d->restart_at = NEVER;
    d->heartbeat_at = NEVER;
    d->burst_at = NEVER;
    d->outgoing = 0;
    d->bus_off = false;
    d->errors = 0;
    for (unsigned i = 0; i < 2; i++) {
        d->consumer[i].expires = NEVER;
    }
    sdo_reset(d);
}

static void start_afresh(drive *const d)
{
    objects_power_on(d);
    cia402_power_on(d);
    nmt_boot(d, d->config.boot_delay);
}

void nmt_power(drive *const d, bool const on)
{
    d->on = on;
    if (on) {
        start_afresh(d);
        return;
    }
    cia402_power_on(d);
    nmt_boot(d, 0);
    d->boot_at = NEVER;
}

static void booted(drive *const d)
{
    peer_variation const *const v = &d->config.variation;
    d->boot_at = NEVER;
    transmit_state(d);
    d->nmt = PEER_PRE_OPERATIONAL;
    nmt_producer_written(d);
    d->burst_at = v->burst_period > 0 ? d->peer->now + v->burst_period : NEVER;
    if (d->restarts > 0) {
        d->restarts--;
        d->restart_at = d->peer->now + v->restart_after;
    }
}

void nmt_producer_written(drive *const d)
{
    d->heartbeat_at = d->value[O_PRODUCER] != 0 ? d->peer->now : NEVER;
}

void nmt_enter(drive *const d, peer_nmt const state)
{
    bool const started = state == PEER_OPERATIONAL && d->nmt != PEER_OPERATIONAL;
    if (state == PEER_STOPPED && d->nmt != PEER_STOPPED) {
        cia402_connection_lost(d, 0);
        sdo_reset(d);
    }
    d->nmt = state;
    d->setpoints_began = false;
    if (started) {
        pdo_start(d);
    }
}

static void reset_communication(drive *const d)
{
    cia402_connection_lost(d, 0);
    d->power.latched = false;
    objects_reset_communication(d);
    nmt_boot(d, d->config.boot_delay);
}

void nmt_command(drive *const d, peer_frame const *const frame)
{
    if (frame->length != 2 || (frame->data[1] != 0 && frame->data[1] != d->config.node)) {
        return;
    }
    switch (frame->data[0]) {
    case START: nmt_enter(d, PEER_OPERATIONAL); break;
    case STOP: nmt_enter(d, PEER_STOPPED); break;
    case PRE_OPERATIONAL: nmt_enter(d, PEER_PRE_OPERATIONAL); break;
    case RESET_NODE: start_afresh(d); break;
    case RESET_COMM: reset_communication(d); break;
    default: break;
    }
}

static uint32_t watched_node(drive const *const d, unsigned const i)
{
    return (uint32_t)(d->value[O_CONSUMER1 + (int)i] >> 16 & 0x7F);
}

static peer_time watched_period(drive const *const d, unsigned const i)
{
    return (d->value[O_CONSUMER1 + (int)i] & 0xFFFF) * MILLISECOND;
}

/* Watching begins with the first heartbeat, and again with the first after a loss. */
void nmt_heartbeat_heard(drive *const d, uint32_t const node)
{
    for (unsigned i = 0; i < 2; i++) {
        if (node == watched_node(d, i) && watched_period(d, i) > 0) {
            d->consumer[i].expires = d->peer->now + watched_period(d, i);
            d->counters.heartbeats++;
            d->counters.last_heartbeat = d->peer->now;
        }
    }
}

static void heartbeat_lost(drive *const d)
{
    static peer_nmt const after[] = {PEER_PRE_OPERATIONAL, PEER_OPERATIONAL, PEER_STOPPED};
    cia402_connection_lost(d, 0x8130);
    int64_t const behaviour = d->value[O_BEHAVIOUR];
    if (behaviour == 2 || (behaviour == 0 && d->nmt == PEER_OPERATIONAL)) {
        d->nmt = after[behaviour];
    }
}

static void burst(drive *const d)
{
    d->power.warning = !d->power.warning && d->config.variation.burst_count > 0;
    for (uint32_t i = 0; i < d->config.variation.burst_count; i++) {
        emergency_send(d, 0xFF01);
    }
    emergency_send(d, 0x0000);
    d->burst_at += d->config.variation.burst_period;
}

static bool due(peer_time *const timer, peer_time const now)
{
    bool const is = *timer <= now;
    if (is) {
        *timer = NEVER;
    }
    return is;
}

void nmt_timers(drive *const d)
{
    peer_time const now = d->peer->now;
    if (due(&d->boot_at, now)) {
        booted(d);
    }
    if (due(&d->restart_at, now)) {
        start_afresh(d);
    }
    if (d->heartbeat_at <= now) {
        transmit_state(d);
        d->heartbeat_at = producer_period(d) > 0 ? now + producer_period(d) : NEVER;
    }
    if (d->burst_at <= now) {
        burst(d);
    }
    for (unsigned i = 0; i < 2; i++) {
        if (due(&d->consumer[i].expires, now)) {
            heartbeat_lost(d);
        }
    }
}

peer_time nmt_next(drive const *const d)
{
    peer_time const timer[] = {d->boot_at,  d->restart_at,          d->heartbeat_at,
                               d->burst_at, d->consumer[0].expires, d->consumer[1].expires};
    peer_time first = NEVER;
    for (size_t i = 0; i < sizeof timer / sizeof timer[0]; i++) {
        first = timer[i] < first ? timer[i] : first;
    }
    return first;
}

peer_nmt peer_nmt_state(peer const *const p, uint32_t const number)
{
    return p->drive[number].nmt;
}
