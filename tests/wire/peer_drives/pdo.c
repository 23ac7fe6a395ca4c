/* PDOs of a drive (CiA 301, 7.2.2): parameters, mapping, what goes with SYNC. */
#include "peer.h"

enum { SYNCHRONOUS_MOST = 240, EVENT_LEAST = 254 };
static uint32_t const INVALID = 0x80000000U;
static uint32_t const NO_REMOTE = 0x40000000U;
static uint32_t const EXTENDED = 0x20000000U;

static int rpdo_id(unsigned const n)
{
    return O_RPDO1_ID + RPDO_STRIDE * (int)n;
}
static int rpdo_map(unsigned const n)
{
    return O_RPDO1_MAP + MAP_STRIDE * (int)n;
}
static int tpdo_id(unsigned const n)
{
    return O_TPDO1_ID + TPDO_STRIDE * (int)n;
}
static int tpdo_map(unsigned const n)
{
    return O_TPDO1_MAP + MAP_STRIDE * (int)n;
}

bool pdo_is_parameter(int const slot)
{
    return slot >= O_RPDO1_COUNT && slot <= O_TPDO4_MAP12;
}

static void resolve(drive const *const d, int const map, int *const slots)
{
    int64_t const count = d->value[map];
    for (int k = 0; k < MAPPED; k++) {
        uint32_t const entry = (uint32_t)d->value[map + 1 + k];
        int const slot = object_find((uint16_t)(entry >> 16), (uint8_t)(entry >> 8));
        slots[k] = k < count ? slot : NO_SLOT;
    }
}

void pdo_map_resolve(drive *const d)
{
    for (unsigned n = 0; n < PDOS; n++) {
        resolve(d, rpdo_map(n), d->rpdo_slot[n]);
        resolve(d, tpdo_map(n), d->tpdo_slot[n]);
    }
}

void pdo_reset(drive *const d)
{
    memset(d->rpdo, 0, sizeof d->rpdo);
    memset(d->tpdo, 0, sizeof d->tpdo);
    pdo_map_resolve(d);
}

/* --- what may be written to the parameters --- */

static bool restricted(uint32_t const id)
{
    return id <= 0x001 || (id >= 0x101 && id <= 0x180) || (id >= 0x581 && id <= 0x5FF) ||
           (id >= 0x601 && id <= 0x67F) || id == 0x6E0 || id >= 0x701;
}

static uint32_t check_id(uint32_t const old, uint32_t const wanted, bool const sends)
{
    uint32_t const id = wanted & 0x7FFU;
    bool const valid = (wanted & INVALID) == 0;
    if ((wanted & EXTENDED) != 0 || (sends && (wanted & NO_REMOTE) == 0)) {
        return ABORT_RANGE;
    }
    if (valid && restricted(id)) {
        return ABORT_RANGE;
    }
    if (valid && (old & INVALID) == 0 && (old & 0x7FFU) != id) {
        return ABORT_STATE; /* its identifier stays while a PDO exists */
    }
    return ABORT_NONE;
}

/* 252 and 253, remote requests, are not for this drive either. */
static uint32_t check_type(int64_t const type)
{
    return type <= SYNCHRONOUS_MOST || type >= EVENT_LEAST ? ABORT_NONE : ABORT_RANGE;
}

static uint32_t check_entry(uint32_t const entry, bool const sends, unsigned *const bits)
{
    uint16_t const index = (uint16_t)(entry >> 16);
    int const slot = object_find(index, (uint8_t)(entry >> 8));
    if (slot == NO_SLOT) {
        return object_exists(index) ? ABORT_NO_SUB : ABORT_NO_OBJECT;
    }
    *bits += object_bytes(slot) * 8;
    bool const mappable = objects[slot].access == (sends ? ROM : RWM);
    return mappable && (entry & 0xFFU) == object_bytes(slot) * 8 ? ABORT_NONE : ABORT_NOT_MAPPABLE;
}

static uint32_t check_count(drive const *const d, int const map, int64_t const count,
                            bool const sends)
{
    unsigned bits = 0;
    if (count > MAPPED) {
        return ABORT_MAP_LENGTH;
    }
    for (int k = 0; k < count; k++) {
        uint32_t const abort = check_entry((uint32_t)d->value[map + 1 + k], sends, &bits);
        if (abort != ABORT_NONE) {
            return abort;
        }
    }
    return bits <= 64 ? ABORT_NONE : ABORT_MAP_LENGTH;
}

static uint32_t check_map(drive const *const d, int const map, int const id, int const slot,
                          int64_t const value)
{
    bool const sends = map >= O_TPDO1_MAP;
    unsigned bits = 0;
    if ((d->value[id] & INVALID) == 0) {
        return ABORT_STATE; /* a mapping stays while its PDO exists */
    }
    if (slot == map) {
        return check_count(d, map, value, sends);
    }
    if (d->value[map] != 0) {
        return ABORT_COUNT_NOT_ZERO;
    }
    return value == 0 ? ABORT_NONE : check_entry((uint32_t)value, sends, &bits);
}

static uint32_t check_parameter(drive const *const d, int const id, int const slot,
                                int64_t const value, bool const sends)
{
    if (slot == id) {
        return check_id((uint32_t)d->value[id], (uint32_t)value, sends);
    }
    if (slot == id + 1) {
        return check_type(value);
    }
    return (d->value[id] & INVALID) == 0 ? ABORT_STATE : ABORT_NONE; /* the inhibit time */
}

uint32_t pdo_check(drive const *const d, int const slot, int64_t const value)
{
    if (d->nmt == PEER_OPERATIONAL) {
        return ABORT_NMT_STATE;
    }
    unsigned const n = (unsigned)objects[slot].index & 3U;
    switch (objects[slot].index & 0xFFFC) {
    case 0x1400: return check_parameter(d, rpdo_id(n), slot, value, false);
    case 0x1600: return check_map(d, rpdo_map(n), rpdo_id(n), slot, value);
    case 0x1800: return check_parameter(d, tpdo_id(n), slot, value, true);
    default: return check_map(d, tpdo_map(n), tpdo_id(n), slot, value);
    }
}

/* --- receiving --- */

static int64_t signed_value(int const slot, uint32_t const bits)
{
    switch (objects[slot].type) {
    case I8: return (int8_t)bits;
    case I16: return (int16_t)bits;
    case I32: return (int32_t)bits;
    default: return bits;
    }
}

static unsigned mapped_bytes(int const *const slots)
{
    unsigned bytes = 0;
    for (unsigned k = 0; k < MAPPED && slots[k] != NO_SLOT; k++) {
        bytes += object_bytes(slots[k]);
    }
    return bytes;
}

static void apply(drive *const d, unsigned const n)
{
    uint8_t const *from = d->rpdo[n].data;
    d->rpdo[n].fresh = false;
    for (unsigned k = 0; k < MAPPED && d->rpdo_slot[n][k] != NO_SLOT; k++) {
        int const slot = d->rpdo_slot[n][k];
        uint32_t bits = 0;
        for (unsigned i = 0; i < object_bytes(slot); i++) {
            bits |= (uint32_t)*from++ << 8 * i;
        }
        object_receive(d, slot, signed_value(slot, bits));
    }
}

static bool carries_setpoint(int const *const slots)
{
    bool found = false;
    for (unsigned k = 0; k < MAPPED; k++) {
        found = found || slots[k] == O_TARGET_TORQUE || slots[k] == O_TARGET_POSITION;
    }
    return found;
}

static void count_setpoint(drive *const d)
{
    peer_counters *const c = &d->counters;
    c->setpoints++;
    d->setpoints_since_sync++;
    d->setpoints_began = true;
    if (c->last_sync < 0) {
        return;
    }
    peer_time const phase = d->peer->now - c->last_sync;
    peer_time const deadline = d->peer->timing.setpoint_deadline;
    c->latest_setpoint = phase > c->latest_setpoint ? phase : c->latest_setpoint;
    c->late += deadline > 0 && phase > deadline ? 1 : 0;
}

static void receive_one(drive *const d, unsigned const n, peer_frame const *const frame)
{
    if (frame->length < mapped_bytes(d->rpdo_slot[n])) {
        d->counters.short_pdos++;
        cia402_connection_lost(d, 0x8210);
        return;
    }
    pdo *const r = &d->rpdo[n];
    r->fresh = true;
    memcpy(r->data, frame->data, sizeof r->data);
    if (d->value[rpdo_id(n) + 1] > SYNCHRONOUS_MOST) {
        apply(d, n);
    } else if (carries_setpoint(d->rpdo_slot[n])) {
        count_setpoint(d);
    }
}

void pdo_receive(drive *const d, peer_frame const *const frame)
{
    for (unsigned n = 0; d->nmt == PEER_OPERATIONAL && n < PDOS; n++) {
        uint32_t const id = (uint32_t)d->value[rpdo_id(n)];
        if ((id & INVALID) == 0 && (id & 0x7FFU) == frame->id) {
            receive_one(d, n, frame);
        }
    }
}

/* --- sending --- */

static uint8_t pack(drive const *const d, unsigned const n, uint8_t *to)
{
    uint8_t bytes = 0;
    for (unsigned k = 0; k < MAPPED && d->tpdo_slot[n][k] != NO_SLOT; k++) {
        int const slot = d->tpdo_slot[n][k];
        for (unsigned i = 0; i < object_bytes(slot); i++, bytes++) {
            *to++ = (uint8_t)((uint64_t)d->value[slot] >> 8 * i);
        }
    }
    return bytes;
}

static void send(drive *const d, unsigned const n, peer_time const delay)
{
    uint8_t data[8] = {0};
    uint8_t const length = pack(d, n, data);
    pdo *const t = &d->tpdo[n];
    t->event = false;
    t->syncs = 0;
    t->length = length;
    memcpy(t->data, data, sizeof t->data);
    drive_transmit(d, (uint32_t)d->value[tpdo_id(n)] & 0x7FFU, data, length, d->peer->now + delay);
}

static bool exists(drive const *const d, unsigned const n)
{
    return (d->value[tpdo_id(n)] & INVALID) == 0 && d->value[tpdo_map(n)] > 0;
}

static bool changed(drive const *const d, unsigned const n)
{
    uint8_t data[8] = {0};
    (void)pack(d, n, data);
    return memcmp(data, d->tpdo[n].data, sizeof data) != 0;
}

static bool due_at_sync(drive *const d, unsigned const n)
{
    int64_t const type = d->value[tpdo_id(n) + 1];
    if (type == 0) {
        return d->tpdo[n].event || changed(d, n);
    }
    return type <= SYNCHRONOUS_MOST && ++d->tpdo[n].syncs >= (unsigned)type;
}

static void answer_sync(drive *const d)
{
    peer_time const bound = d->peer->timing.answer_delay;
    peer_time const together = random_delay(d->peer, bound);
    for (unsigned n = 0; n < PDOS; n++) {
        if (exists(d, n) && due_at_sync(d, n)) {
            bool const own = d->config.variation.any_order;
            send(d, n, own ? random_delay(d->peer, bound) : together);
        }
    }
}

static void count_sync(drive *const d)
{
    peer_counters *const c = &d->counters;
    c->syncs++;
    c->last_sync = d->peer->now;
    c->lost += d->setpoints_began && d->setpoints_since_sync == 0 ? 1 : 0;
    c->doubled += d->setpoints_since_sync > 1 ? 1 : 0;
    d->setpoints_since_sync = 0;
}

/* What is sampled was there before what the RPDOs brought is applied. */
void pdo_sync(drive *const d)
{
    if (d->nmt != PEER_OPERATIONAL) {
        return;
    }
    count_sync(d);
    objects_refresh(d);
    d->toggled = !d->toggled;
    answer_sync(d);
    for (unsigned n = 0; n < PDOS; n++) {
        if (d->rpdo[n].fresh && d->value[rpdo_id(n) + 1] <= SYNCHRONOUS_MOST) {
            apply(d, n);
        }
    }
    servo_output(d, 0.0);
}

void pdo_start(drive *const d)
{
    d->setpoints_since_sync = 0;
    for (unsigned n = 0; n < PDOS; n++) {
        d->rpdo[n].fresh = false;
        d->tpdo[n] = (pdo){.event = true};
    }
}

static peer_time inhibit(drive *const d, unsigned const n)
{
    return d->value[tpdo_id(n) + 2] * 100000 +
           random_delay(d->peer, d->config.variation.inhibit_jitter);
}

/* Event-driven TPDOs: at the start and when what they carry changed. */
void pdo_events(drive *const d)
{
    if (d->nmt != PEER_OPERATIONAL) {
        return;
    }
    bool refreshed = false;
    for (unsigned n = 0; n < PDOS; n++) {
        pdo *const t = &d->tpdo[n];
        bool const by_event = exists(d, n) && d->value[tpdo_id(n) + 1] >= EVENT_LEAST;
        if (!by_event || d->peer->now < t->inhibited) {
            continue;
        }
        if (!refreshed) {
            objects_refresh(d);
            refreshed = true;
        }
        if (t->event || changed(d, n)) {
            send(d, n, 0);
            t->inhibited = d->peer->now + inhibit(d, n);
        }
    }
}

peer_counters peer_counted(peer const *const p, uint32_t const number)
{
    return p->drive[number].counters;
}
