/* The object dictionary: what there is, what may be written, what a reset brings back. */
#include "peer.h"

#define OBJECT(name, index, sub, type, access, factory, ...)                                       \
    {index, sub, type, access, factory, __VA_ARGS__},
object const objects[SLOTS] = {ALL_OBJECTS(OBJECT)};

static char const device_name[] = "Servo drive of the other hand";

static uint32_t key(uint16_t const index, uint8_t const sub)
{
    return (uint32_t)index << 8 | sub;
}

/* The first slot whose key is not below one. */
static int lower_bound(uint32_t const wanted)
{
    int low = 0;
    int high = SLOTS;
    while (low < high) {
        int const middle = low + (high - low) / 2;
        if (key(objects[middle].index, objects[middle].sub) < wanted) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

int object_find(uint16_t const index, uint8_t const sub)
{
    int const slot = lower_bound(key(index, sub));
    bool const found = slot < SLOTS && objects[slot].index == index && objects[slot].sub == sub;
    return found ? slot : NO_SLOT;
}

bool object_exists(uint16_t const index)
{
    int const slot = lower_bound(key(index, 0));
    return slot < SLOTS && objects[slot].index == index;
}

unsigned object_bytes(int const slot)
{
    static uint8_t const bytes[] = {[U8] = 1,
                                    [I8] = 1,
                                    [U16] = 2,
                                    [I16] = 2,
                                    [U32] = 4,
                                    [I32] = 4,
                                    [STRING] = sizeof device_name - 1};
    return bytes[objects[slot].type];
}

char const *object_string(int const slot)
{
    return objects[slot].type == STRING ? device_name : NULL;
}

static void factory_values(drive *const d)
{
    peer_drive const *const c = &d->config;
    int64_t *const v = d->factory;
    for (int slot = 0; slot < SLOTS; slot++) {
        v[slot] = objects[slot].factory;
    }
    v[O_EMERGENCY_ID] = 0x80 + c->node;
    v[O_SDO_REQUEST_ID] = 0x600 + c->node;
    v[O_SDO_ANSWER_ID] = 0x580 + c->node;
    v[O_VENDOR] = c->vendor;
    v[O_PRODUCT] = c->product;
    v[O_REVISION] = c->revision;
    v[O_SERIAL] = c->serial;
    v[O_NODE_ID] = c->node;
    v[O_NOMINAL_CURRENT] = c->nominal_current;
    v[O_CURRENT_LIMIT] = c->current_limit;
    v[O_TORQUE_CONSTANT] = c->torque_constant;
    v[O_PULSES] = c->counts_per_turn / 4;
    for (uint32_t n = 0; n < PDOS; n++) {
        uint32_t const invalid = n == 0 ? 0U : 0x80000000U; /* all RPDOs are valid, one TPDO */
        v[O_RPDO1_ID + RPDO_STRIDE * (int)n] = 0x200U + 0x100U * n + c->node;
        v[O_TPDO1_ID + TPDO_STRIDE * (int)n] = (0x40000180U | invalid) + 0x100U * n + c->node;
    }
}

void objects_begin(drive *const d)
{
    factory_values(d);
    memcpy(d->stored, d->factory, sizeof d->stored);
}

void rated_torque_refresh(drive *const d)
{
    int64_t const truth = d->value[O_NOMINAL_CURRENT] * d->value[O_TORQUE_CONSTANT] / 1000;
    uint32_t const lie = d->config.variation.rated_torque;
    d->value[O_RATED_TORQUE] = lie != 0 ? lie : truth;
}

static void load_stored(drive *const d)
{
    if (d->restore) {
        memcpy(d->stored, d->factory, sizeof d->stored);
        d->restore = false;
    }
}

void objects_power_on(drive *const d)
{
    load_stored(d);
    memcpy(d->value, d->stored, sizeof d->value);
    rated_torque_refresh(d);
    pdo_reset(d);
}

static bool is_communication(int const slot)
{
    return objects[slot].index < 0x2000;
}

void objects_reset_communication(drive *const d)
{
    load_stored(d);
    for (int slot = 0; slot < SLOTS; slot++) {
        bool const history = slot >= O_HISTORY && slot <= O_HISTORY5;
        if (is_communication(slot) && slot != O_ERROR_REGISTER && !history) {
            d->value[slot] = d->stored[slot];
        }
    }
    pdo_reset(d);
}

static int64_t shown(double const value, int64_t const least, int64_t const greatest)
{
    if (value <= (double)least) {
        return least;
    }
    return value >= (double)greatest ? greatest : (int64_t)llround(value);
}

static int64_t per_mille(drive const *const d, double const current)
{
    double const nominal = (double)d->value[O_NOMINAL_CURRENT];
    return nominal > 0 ? shown(1000.0 * current / nominal, INT16_MIN, INT16_MAX) : 0;
}

static double rpm(drive const *const d, double const velocity)
{
    return velocity / counts_per_second(d, 1.0);
}

void objects_refresh(drive *const d)
{
    int64_t *const v = d->value;
    servo const *const s = &d->servo;
    double const counts = servo_counts(d, d->peer->now);
    v[O_STATUSWORD] = cia402_statusword(d);
    v[O_POSITION] = servo_position(d, counts);
    v[O_POSITION_DEMAND] = servo_position(d, s->action == ACT_POSITION ? s->demand : counts);
    v[O_FOLLOWING_ERROR] = (int32_t)(v[O_POSITION_DEMAND] - v[O_POSITION]);
    v[O_VELOCITY_DEMAND] = shown(rpm(d, s->demand_rate), INT32_MIN, INT32_MAX);
    v[O_VELOCITY] = shown(rpm(d, s->velocity), INT32_MIN, INT32_MAX);
    v[O_VELOCITY_AVERAGED] = v[O_VELOCITY];
    v[O_CURRENT_DEMAND] = shown(s->current_demand, INT32_MIN, INT32_MAX);
    v[O_CURRENT_ACTUAL] = shown(s->current, INT32_MIN, INT32_MAX);
    v[O_CURRENT_AVERAGED] = shown(s->current_averaged, INT32_MIN, INT32_MAX);
    v[O_TORQUE] = per_mille(d, s->current);
    v[O_TORQUE_AVERAGED] = per_mille(d, s->current_averaged);
    v[O_I2T_MOTOR] = shown(100.0 * s->heat, 0, UINT16_MAX);
}

static uint32_t save(drive *const d, int64_t const signature)
{
    if (signature != 0x65766173) {
        return ABORT_NOT_STORED;
    }
    for (int slot = 0; slot < SLOTS; slot++) {
        bool const kept = objects[slot].access >= RW && slot != O_CONTROLWORD;
        d->stored[slot] = kept ? d->value[slot] : d->stored[slot];
    }
    return ABORT_NONE;
}

static uint32_t restore(drive *const d, int64_t const signature)
{
    if (signature != 0x64616F6C) {
        return ABORT_NOT_STORED;
    }
    d->restore = true;
    return ABORT_NONE;
}

/* Whether these are modes of an EPOS4, homing methods, quick stop options. */
static bool in_set(int const slot, int64_t const value)
{
    uint32_t const modes = 1U << 1 | 1U << 3 | 1U << 6 | 1U << 8 | 1U << 9 | 1U << 10;
    uint32_t const options = 1U << 0 | 1U << 1 | 1U << 2 | 1U << 5 | 1U << 6;
    static int8_t const methods[] = {-4, -3, -2, -1, 1, 2, 7, 11, 17, 18, 23, 27, 33, 34, 35, 37};
    if (slot == O_MODE) {
        return (modes >> value & 1U) != 0;
    }
    if (slot == O_QUICK_STOP_OPTION) {
        return (options >> value & 1U) != 0;
    }
    bool found = slot != O_HOMING_METHOD;
    for (size_t i = 0; i < sizeof methods; i++) {
        found = found || methods[i] == value;
    }
    return found;
}

static uint32_t may_write(drive const *const d, int const slot, int64_t const value)
{
    object const *const o = &objects[slot];
    if (o->access == RO || o->access == ROM || o->type == STRING) {
        return ABORT_READ_ONLY;
    }
    if (slot == O_HISTORY && value != 0) {
        return ABORT_RANGE;
    }
    if (value > o->greatest) {
        return ABORT_TOO_HIGH;
    }
    if (value < o->least) {
        return ABORT_TOO_LOW;
    }
    if (!in_set(slot, value)) {
        return ABORT_RANGE;
    }
    if (o->access == RWP && cia402_powered(d)) {
        return ABORT_STATE;
    }
    return pdo_is_parameter(slot) ? pdo_check(d, slot, value) : ABORT_NONE;
}

static void written(drive *const d, int const slot)
{
    switch (slot) {
    case O_HISTORY: memset(&d->value[O_HISTORY], 0, 6 * sizeof d->value[0]); break;
    case O_PRODUCER: nmt_producer_written(d); break;
    case O_CONSUMER1:
    case O_CONSUMER2: d->consumer[slot - O_CONSUMER1].expires = NEVER; break;
    case O_NOMINAL_CURRENT:
    case O_TORQUE_CONSTANT: rated_torque_refresh(d); break;
    case O_CONTROLWORD: cia402_controlword(d, (uint16_t)d->value[slot]); break;
    case O_TARGET_POSITION: servo_target(d); break;
    case O_MODE: d->mode_at = d->peer->now + d->config.variation.transition_delay; break;
    default:
        if (pdo_is_parameter(slot)) {
            pdo_map_resolve(d);
        }
    }
}

uint32_t object_write(drive *const d, int const slot, int64_t const value)
{
    uint32_t const abort = may_write(d, slot, value);
    if (abort != ABORT_NONE) {
        return abort;
    }
    if (slot == O_STORE) {
        return save(d, value);
    }
    if (slot == O_RESTORE) {
        return restore(d, value);
    }
    d->value[slot] = value;
    written(d, slot);
    return ABORT_NONE;
}

/* What a PDO brings outside the object's range stays out. */
void object_receive(drive *const d, int const slot, int64_t const value)
{
    (void)object_write(d, slot, value);
}

bool peer_object(peer *const p, uint32_t const number, uint16_t const index, uint8_t const sub,
                 int64_t *const value)
{
    int const slot = object_find(index, sub);
    if (slot == NO_SLOT || objects[slot].type == STRING) {
        return false;
    }
    objects_refresh(&p->drive[number]);
    *value = p->drive[number].value[slot];
    return true;
}
