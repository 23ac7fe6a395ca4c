/* Homing: against a stop by a current threshold (methods -3, -4), or here (35, 37). */
#include "peer.h"

static double direction(drive const *const d)
{
    return d->value[O_HOMING_METHOD] == -3 ? 1.0 : -1.0;
}

/* The reference is here: on with the move to the home position. */
static void referenced(drive *const d)
{
    servo *const s = &d->servo;
    d->homing.phase = HOMING_MOVE;
    s->demand = s->counts;
    s->demand_rate = 0.0;
    s->integral = 0.0;
    d->homing.target = s->counts + (double)d->value[O_HOME_MOVE];
}

void homing_begin(drive *const d)
{
    d->homing.homed = false;
    switch (d->value[O_HOMING_METHOD]) {
    case -3:
    case -4: d->homing.phase = HOMING_SEEK; break;
    case 35:
    case 37: referenced(d); break;
    default: d->homing.phase = HOMING_FAILED; break;
    }
}

/* The controlword's bit 4 is gone, or it has "halt": what is not done is interrupted. */
void homing_stop(drive *const d)
{
    if (d->homing.phase == HOMING_SEEK || d->homing.phase == HOMING_MOVE) {
        d->homing.phase = HOMING_IDLE;
        d->servo.demand_rate = 0.0;
    }
}

void homing_leave(drive *const d)
{
    if (d->homing.phase != HOMING_DONE || d->mode != 6) {
        d->homing.phase = HOMING_IDLE;
    }
}

static void seek(drive *const d, double const dt)
{
    servo *const s = &d->servo;
    double const speed = counts_per_second(d, (double)d->value[O_HOMING_SPEED]);
    double const most = counts_per_second(d, (double)d->value[O_HOMING_ACCELERATION]) * dt;
    double const missing = direction(d) * speed - s->demand_rate;
    s->demand_rate += fmin(fmax(missing, -most), most);
    s->demand += s->demand_rate * dt;
    if (fabs(s->current_averaged) >= (double)d->value[O_HOME_CURRENT]) {
        referenced(d);
    }
}

static void done(drive *const d)
{
    servo *const s = &d->servo;
    d->homing.phase = HOMING_DONE;
    d->homing.homed = true;
    s->demand_rate = 0.0;
    uint32_t const raw = (uint32_t)(int64_t)d->homing.target;
    s->shift = (int32_t)((uint32_t)d->value[O_HOME_POSITION] - raw);
}

static void move(drive *const d, double const dt)
{
    servo *const s = &d->servo;
    double const speed = counts_per_second(d, (double)d->value[O_HOMING_SPEED]);
    double const missing = d->homing.target - s->demand;
    double const step = fmin(fmax(missing, -speed * dt), speed * dt);
    s->demand += step;
    s->demand_rate = step / dt;
    bool const there = fabs(s->counts - d->homing.target) <= 2.0 || d->value[O_HOME_MOVE] == 0;
    if (s->demand == d->homing.target && there) {
        done(d);
    }
}

void homing_tick(drive *const d, double const dt)
{
    if (d->homing.phase == HOMING_SEEK) {
        seek(d, dt);
    } else if (d->homing.phase == HOMING_MOVE) {
        move(d, dt);
    }
}
