/* Encoder, current and torque of a motor, and the controllers that make them follow. */
#include "peer.h"

static double const BANDWIDTH = 2.0 * PI * 15.0; /* of the position controller, rad/s */
static double const INTEGRAL = 0.3;              /* of BANDWIDTH cubed */
static double const TRACKING = 2.0 * PI * 80.0;  /* of the velocity estimate, rad/s */
static double const AVERAGING = 0.002;           /* of the current, s */
static double const STANDSTILL = 10.0;           /* rpm: a count or two at 4 kHz */

double counts_per_second(drive const *const d, double const rpm)
{
    return rpm / 60.0 * d->config.counts_per_turn;
}

/* --- shaft and encoder --- */

static double seconds(peer_time const time)
{
    return (double)time / (double)SECOND;
}

static double angle_at(shaft const *const s, peer_time const time)
{
    return s->angle + s->rate * seconds(time - s->at);
}

static double true_counts(drive const *const d, peer_time const time)
{
    return angle_at(&d->shaft, time) / (2.0 * PI) * d->config.counts_per_turn;
}

static double reading(drive const *const d, peer_time const time)
{
    peer_variation const *const v = &d->config.variation;
    encoder_fault const *const e = &d->encoder;
    double const moved = true_counts(d, time) - e->counts;
    switch (v->encoder) {
    case PEER_ENCODER_REVERSED: return e->reading - moved;
    case PEER_ENCODER_FROZEN: return e->reading;
    case PEER_ENCODER_SLIP: return e->reading + moved + v->encoder_value * seconds(time - e->since);
    case PEER_ENCODER_SCALED: return e->reading + moved * v->encoder_value;
    default: return e->reading + moved;
    }
}

/* Whole counts, which do not wrap here. */
double servo_counts(drive const *const d, peer_time const time)
{
    return floor(reading(d, time)) + d->config.initial_count;
}

int32_t servo_position(drive const *const d, double const counts)
{
    return (int32_t)((uint32_t)(int64_t)counts + (uint32_t)d->servo.shift);
}

/* What the encoder says now is where its next fault begins. */
void servo_vary(drive *const d, peer_variation const *const next)
{
    peer_variation const *const old = &d->config.variation;
    peer_time const now = d->peer->now;
    d->encoder = (encoder_fault){true_counts(d, now), reading(d, now), now};
    bool const anew = old->encoder != next->encoder || old->encoder_value != next->encoder_value;
    if (next->encoder == PEER_ENCODER_JUMP && anew) {
        d->encoder.reading += next->encoder_value;
    }
}

static void turn_freely(drive *const d, double const dt)
{
    shaft *const s = &d->shaft;
    peer_drive const *const c = &d->config;
    s->rate += (d->servo.torque - c->friction * s->rate) / c->rotor_inertia * dt;
    s->angle += s->rate * dt;
    s->at = d->peer->now;
    if (c->stop_low == c->stop_high) {
        return;
    }
    if ((s->angle >= c->stop_high && s->rate > 0) || (s->angle <= c->stop_low && s->rate < 0)) {
        s->angle = fmin(fmax(s->angle, c->stop_low), c->stop_high);
        s->rate = 0.0;
    }
}

/* --- what is demanded --- */

static void hold_here(drive *const d)
{
    servo *const s = &d->servo;
    s->demand = s->counts;
    s->demand_rate = s->velocity;
    s->integral = 0.0;
}

static action wanted_action(drive const *const d)
{
    power const *const w = &d->power;
    switch (w->state) {
    case PEER_OPERATION_ENABLED: return d->mode == 10 && !w->stopping ? ACT_TORQUE : ACT_POSITION;
    case PEER_QUICK_STOP: return ACT_POSITION;
    case PEER_FAULT_REACTION: return w->stopping ? ACT_POSITION : ACT_COAST;
    default: return ACT_COAST;
    }
}

static bool follows_targets(drive const *const d)
{
    return d->power.state == PEER_OPERATION_ENABLED && !d->power.stopping && d->mode == 8;
}

/* State or mode changed. */
void servo_take(drive *const d)
{
    servo *const s = &d->servo;
    action const wanted = wanted_action(d);
    if (wanted == ACT_POSITION && s->action != ACT_POSITION) {
        hold_here(d);
    }
    bool const ramps = d->power.stopping;
    s->action = wanted;
    s->steps = 0;
    s->demand_rate = ramps ? s->demand_rate : 0.0;
    servo_target(d);
    servo_output(d, 0.0);
}

/* A target position of CSP: on a straight line there, within the interpolation period. */
void servo_target(drive *const d)
{
    servo *const s = &d->servo;
    if (!follows_targets(d)) {
        return;
    }
    int64_t const target = d->value[O_TARGET_POSITION] + d->value[O_POSITION_OFFSET];
    uint32_t const missing = (uint32_t)target - (uint32_t)servo_position(d, s->demand);
    peer_time const period = d->value[O_INTERPOLATION_PERIOD] * MILLISECOND;
    s->goal = s->demand + (double)(int32_t)missing;
    s->steps = period > SERVO_PERIOD ? (unsigned)(period / SERVO_PERIOD) : 1;
}

static void ramp_down(drive *const d, double const dt)
{
    servo *const s = &d->servo;
    double const most = counts_per_second(d, d->power.deceleration) * dt;
    s->demand_rate -= fmin(fmax(s->demand_rate, -most), most);
    s->demand += s->demand_rate * dt;
}

static void interpolate(drive *const d, double const dt)
{
    servo *const s = &d->servo;
    if (s->steps == 0) {
        s->demand_rate = 0.0;
        return;
    }
    double const step = (s->goal - s->demand) / s->steps--;
    s->demand += step;
    s->demand_rate = step / dt;
}

static void next_demand(drive *const d, double const dt)
{
    if (d->servo.action != ACT_POSITION) {
        return;
    }
    if (d->power.stopping) {
        ramp_down(d, dt);
    } else if (follows_targets(d)) {
        interpolate(d, dt);
    } else if (d->mode == 6) {
        homing_tick(d, dt);
    }
}

static void check_following(drive *const d)
{
    int64_t const window = d->value[O_FOLLOWING_WINDOW];
    double const error = fabs(d->servo.demand - d->servo.counts);
    if (follows_targets(d) && window != UINT32_MAX && error > (double)window) {
        emergency_raise(d, 0x8611);
    }
}

bool servo_standstill(drive const *const d)
{
    double const slow = counts_per_second(d, STANDSTILL);
    return d->servo.demand_rate == 0.0 && fabs(d->servo.velocity) <= slow;
}

/* --- current and torque --- */

static double torque_per_current(drive const *const d)
{
    return 1e-9 * d->config.torque_constant; /* N m per mA */
}

static double position_current(drive *const d, double const dt)
{
    servo *const s = &d->servo;
    peer_drive const *const c = &d->config;
    double const inertia = c->tuned_inertia > 0 ? c->tuned_inertia : c->rotor_inertia;
    double const radians = 2.0 * PI / c->counts_per_turn;
    double const error = (s->demand - s->counts) * radians;
    s->integral += s->limited ? 0.0 : error * dt;
    double const rate = (s->demand_rate - s->velocity) * radians;
    double const stiff = BANDWIDTH * (error + INTEGRAL * BANDWIDTH * s->integral);
    return inertia * BANDWIDTH * (stiff + 2.0 * rate) / torque_per_current(d);
}

static double torque_current(drive const *const d)
{
    bool const halt = (d->power.controlword & 0x100) != 0;
    int64_t const sum = d->value[O_TARGET_TORQUE] + d->value[O_TORQUE_OFFSET];
    return halt ? 0.0 : (double)sum / 1000.0 * (double)d->value[O_NOMINAL_CURRENT];
}

static double demanded_current(drive *const d, double const dt)
{
    switch (d->servo.action) {
    case ACT_TORQUE: return torque_current(d);
    case ACT_POSITION: return position_current(d, dt);
    default: return 0.0;
    }
}

static double limited_current(drive *const d, double const wanted)
{
    servo *const s = &d->servo;
    int64_t const limit = d->value[s->heat >= 1.0 ? O_NOMINAL_CURRENT : O_CURRENT_LIMIT];
    double const given = fmin(fmax(wanted, -(double)limit), (double)limit);
    s->limited = given != wanted;
    return given;
}

static double torque_gain(uint32_t const fault)
{
    switch (fault) {
    case PEER_TORQUE_NOT_GIVEN: return 0.0;
    case PEER_TORQUE_DOUBLED: return 2.0;
    default: return 1.0;
    }
}

/* Current and torque as demanded now, and what a fault makes of them. */
void servo_output(drive *const d, double const dt)
{
    servo *const s = &d->servo;
    peer_variation const *const v = &d->config.variation;
    s->current_demand = limited_current(d, demanded_current(d, dt));
    double const given = s->current_demand * torque_gain(v->torque);
    s->current = v->torque_hidden ? s->current_demand : given;
    s->torque = given * torque_per_current(d);
}

static void heat_up(drive *const d, double const dt)
{
    servo *const s = &d->servo;
    double const nominal = fmax((double)d->value[O_NOMINAL_CURRENT], 1.0);
    double const load = s->current / nominal;
    s->heat += (load * load - s->heat) * dt / (0.1 * (double)d->value[O_THERMAL_TIME]);
}

/* The encoder's count and the speed that a tracking loop makes of it. */
static void measure(drive *const d, double const dt)
{
    servo *const s = &d->servo;
    s->counts = servo_counts(d, d->peer->now);
    double const error = s->counts - s->tracked;
    s->velocity += TRACKING * TRACKING * error * dt;
    s->tracked += (s->velocity + 2.0 * TRACKING * error) * dt;
}

void servo_tick(drive *const d, double const dt)
{
    servo *const s = &d->servo;
    if (!d->shaft.coupled) {
        turn_freely(d, dt);
    }
    measure(d, dt);
    next_demand(d, dt);
    check_following(d);
    servo_output(d, dt);
    heat_up(d, dt);
    s->current_averaged += (s->current - s->current_averaged) * dt / AVERAGING;
}

void servo_reset(drive *const d)
{
    double const counts = servo_counts(d, d->peer->now);
    d->servo = (servo){.action = ACT_COAST, .counts = counts, .tracked = counts};
}

/* --- for the owner --- */

double peer_torque(peer const *const p, uint32_t const number)
{
    return p->drive[number].servo.torque;
}

double peer_angle(peer const *const p, uint32_t const number)
{
    return angle_at(&p->drive[number].shaft, p->now);
}

void peer_turn(peer *const p, uint32_t const number, peer_time const time, double const angle)
{
    shaft *const s = &p->drive[number].shaft;
    if (time <= s->at && s->coupled) {
        s->angle = angle; /* corrected */
        return;
    }
    s->rate = s->coupled ? (angle - s->angle) / seconds(time - s->at) : 0.0;
    s->angle = angle;
    s->at = time;
    s->coupled = true;
}
