/* Drives and buses together: how time passes. */
#include "peer.h"

static bool drive_valid(peer_drive const *const c, uint32_t const buses)
{
    return c->bus < buses && c->node >= 1 && c->node <= 127 && c->counts_per_turn >= 4 &&
           c->counts_per_turn % 4 == 0 && c->torque_constant > 0 && c->rotor_inertia > 0.0 &&
           c->boot_delay >= 0;
}

static bool config_valid(peer_config const *const c)
{
    bool valid = c->bus_count <= PEER_BUSES && c->drive_count <= PEER_DRIVES;
    for (uint32_t i = 0; valid && i < c->bus_count; i++) {
        valid = c->buses[i].bit_rate > 0;
    }
    for (uint32_t i = 0; valid && i < c->drive_count; i++) {
        valid = drive_valid(&c->drives[i], c->bus_count);
    }
    return valid;
}

static void begin_bus(peer *const p, bus *const b, peer_bus const *const config)
{
    b->config = *config;
    peer_bus_variation const *const v = &config->variation;
    b->next_time = v->time_period > 0 ? v->time_period : NEVER;
    b->next_foreign = v->foreign_period > 0 ? v->foreign_period : NEVER;
    adapter_begin(p, b);
}

static void begin_drive(peer *const p, uint32_t const number, peer_drive const *const config)
{
    drive *const d = &p->drive[number];
    bus *const b = &p->bus[config->bus];
    d->config = *config;
    d->number = number;
    d->peer = p;
    d->restarts = config->variation.restarts;
    d->counters.last_heartbeat = -1;
    d->counters.last_sync = -1;
    b->drive[b->drives++] = number;
    objects_begin(d);
    nmt_power(d, !config->variation.missing);
}

peer *peer_new(peer_config const *const config)
{
    peer *const p = config_valid(config) ? calloc(1, sizeof *p) : NULL;
    if (p == NULL) {
        return NULL;
    }
    p->timing = config->timing;
    p->random = config->timing.seed;
    p->servo_at = SERVO_PERIOD;
    p->buses = config->bus_count;
    p->drives = config->drive_count;
    for (uint32_t i = 0; i < p->buses; i++) {
        begin_bus(p, &p->bus[i], &config->buses[i]);
    }
    for (uint32_t i = 0; i < p->drives; i++) {
        begin_drive(p, i, &config->drives[i]);
    }
    return p;
}

void peer_free(peer *const p)
{
    free(p);
}

static peer_time drive_next(drive const *const d)
{
    peer_time const timer = nmt_next(d);
    return d->sdo.serve < timer ? d->sdo.serve : timer;
}

static peer_time next_event(peer const *const p)
{
    peer_time next = p->servo_at;
    for (unsigned i = 0; i < p->buses; i++) {
        peer_time const time = bus_next(p, &p->bus[i]);
        next = time < next ? time : next;
    }
    for (unsigned i = 0; i < p->drives; i++) {
        peer_time const time = drive_next(&p->drive[i]);
        next = time < next ? time : next;
    }
    return next;
}

static void tick(peer *const p)
{
    double const dt = (double)SERVO_PERIOD / (double)SECOND;
    p->servo_at += SERVO_PERIOD;
    for (unsigned i = 0; i < p->drives; i++) {
        drive *const d = &p->drive[i];
        if (d->nmt != PEER_INITIALISING) {
            cia402_tick(d);
            pdo_events(d);
        }
        servo_tick(d, dt);
    }
}

static void step(peer *const p, peer_time const time)
{
    p->now = time > p->now ? time : p->now;
    for (unsigned i = 0; i < p->buses; i++) {
        bus_step(p, &p->bus[i]);
    }
    for (unsigned i = 0; i < p->drives; i++) {
        drive *const d = &p->drive[i];
        nmt_timers(d);
        if (d->sdo.serve <= p->now) {
            sdo_serve(d);
        }
    }
    if (p->servo_at <= p->now) {
        tick(p);
    }
}

peer_time peer_run(peer *const p, peer_time const until)
{
    for (peer_time next = next_event(p); next <= until; next = next_event(p)) {
        step(p, next);
    }
    p->now = until > p->now ? until : p->now;
    return p->now;
}

/* When the master has something to fetch, as far as that is known. */
static peer_time next_arrival(peer const *const p)
{
    peer_time first = NEVER;
    for (unsigned i = 0; i < p->buses; i++) {
        bus const *const b = &p->bus[i];
        if (b->count > 0) {
            return p->now;
        }
        if (b->adapter.count > 0 && b->adapter.out[b->adapter.first].ready < first) {
            first = b->adapter.out[b->adapter.first].ready;
        }
    }
    return first;
}

peer_time peer_run_to_arrival(peer *const p, peer_time const until)
{
    peer_time next = next_event(p);
    peer_time arrival = next_arrival(p);
    while (next <= until && next < arrival) {
        step(p, next);
        next = next_event(p);
        arrival = next_arrival(p);
    }
    peer_time const end = arrival < until ? arrival : until;
    p->now = end > p->now ? end : p->now;
    return p->now;
}

void peer_vary(peer *const p, uint32_t const number, peer_variation const *const variation)
{
    drive *const d = &p->drive[number];
    peer_variation const old = d->config.variation;
    servo_vary(d, variation);
    d->config.variation = *variation;
    if (old.restarts != variation->restarts) {
        d->restarts = variation->restarts;
    }
    if (old.burst_period != variation->burst_period && d->nmt != PEER_INITIALISING) {
        d->burst_at = variation->burst_period > 0 ? p->now + variation->burst_period : NEVER;
    }
    if (old.missing != variation->missing) {
        nmt_power(d, !variation->missing);
    }
    rated_torque_refresh(d);
}

void peer_vary_bus(peer *const p, uint32_t const number, peer_bus_variation const *const variation)
{
    bus *const b = &p->bus[number];
    b->config.variation = *variation;
    b->next_time = variation->time_period > 0 ? p->now + variation->time_period : NEVER;
    b->next_foreign = variation->foreign_period > 0 ? p->now + variation->foreign_period : NEVER;
}
