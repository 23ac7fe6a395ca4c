#include "guide.h"

#include "tb_control.h"

static const tb_guide nothing;

void tb_guide_start(tb_guide *guide)
{
    *guide = nothing;
}

/* Rows of the memory of tb_base_pid: integral, previous rail coordinate, speed. */
void tb_guide_take(tb_guide *guide, size_t rail, real_t position)
{
    real_t *const row = &guide->base[rail * TB_BASE_MEMORY];
    row[0] = 0;
    row[1] = position;
    row[2] = 0;
    guide->reference[rail] = position;
    guide->lagging[rail] = 0;
    guide->guided[rail] = 1;
}

static void move_reference(real_t *reference, real_t target, real_t step)
{
    *reference += tb_min(tb_max(target - *reference, -step), step);
}

static void count_lag(tb_guide *guide, size_t rail, real_t position)
{
    bool const lags = TB_ABS(position - guide->reference[rail]) > TB_RAIL_LAG_LIMIT;
    uint16_t const count = guide->lagging[rail];
    guide->lagging[rail] = lags ? (uint16_t)(count + 1) : 0;
}

static void move_references(tb_guide *guide, const real_t rails[], const real_t targets[],
                            real_t speed)
{
    for (size_t i = 0; i < TB_RAIL_SLOTS; i++) {
        move_reference(&guide->reference[i], targets[i], speed * TB_PERIOD);
        count_lag(guide, i, rails[i]);
    }
}

#if TB_RAILS > 0

static void follow_references(tb_guide *guide, const real_t rails[], real_t torque[])
{
    (void)tb_base_pid(guide->base, guide->reference, rails, guide->base, torque);
    for (size_t i = 0; i < TB_RAILS; i++) {
        torque[i] *= TB_PINION_RADIUS;
    }
}

#else

static void follow_references(tb_guide *guide, const real_t rails[], real_t torque[])
{
    (void)guide;
    (void)rails;
    torque[0] = 0; /* the slot of an array that nobody fills or reads */
}

#endif

void tb_guide_step(tb_guide *guide, const real_t rails[TB_RAIL_SLOTS],
                   const real_t targets[TB_RAIL_SLOTS], real_t speed, real_t torque[TB_RAIL_SLOTS])
{
    move_references(guide, rails, targets, speed);
    follow_references(guide, rails, torque);
}

bool tb_guide_has_arrived(const tb_guide *guide, const real_t rails[TB_RAIL_SLOTS],
                          const real_t targets[TB_RAIL_SLOTS], real_t distance)
{
    bool arrived = true;
    for (size_t i = 0; i < TB_RAIL_SLOTS; i++) {
        real_t const to_go = TB_ABS(guide->reference[i] - targets[i]);
        bool const near = TB_ABS(rails[i] - targets[i]) <= distance;
        arrived = arrived && near && (to_go <= TB_C(0.1) * distance);
    }
    return arrived;
}

bool tb_guide_has_lost(const tb_guide *guide, size_t *rail)
{
    for (size_t i = 0; i < TB_RAIL_SLOTS; i++) {
        if (guide->lagging[i] > TB_RAIL_LAG_CYCLES) {
            *rail = i;
            return true;
        }
    }
    return false;
}
