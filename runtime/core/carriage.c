#include "carriage.h"

#include "tb_drives.h"
#include "tb_machine.h"

#define PUSH (TB_RAIL_TORQUE_LIMIT * TB_C(0.5))
/* As much as is left of the limit by what rounding takes away on the bus. */
#define FULL_PUSH (TB_RAIL_TORQUE_LIMIT * TB_C(0.95))
/* Speed gained against the force: more than any encoder's count makes of a carriage that brakes. */
#define GAINED (TB_RAIL_SPEED_LIMIT * TB_C(0.05))

void tb_carriage_rest(tb_carriage *carriage)
{
    carriage->pushed = 0;
}

bool tb_carriage_is_pushed(real_t torque)
{
    return TB_ABS(torque) >= PUSH;
}

static void forget_range(tb_carriage *carriage, real_t position)
{
    carriage->cycles = 0;
    carriage->low = position;
    carriage->high = position;
}

static void begin_push(tb_carriage *carriage, const tb_carriage_motion *seen)
{
    carriage->pushed = 1;
    carriage->forward = (seen->torque > 0) ? 1 : 0;
    carriage->speed = seen->speed;
    forget_range(carriage, seen->position);
}

static bool goes_on(const tb_carriage *carriage, real_t torque)
{
    return (carriage->pushed != 0) && ((carriage->forward != 0) == (torque > 0));
}

static bool gains_against(const tb_carriage *carriage, const tb_carriage_motion *seen)
{
    real_t const way = (carriage->forward != 0) ? TB_C(1.0) : TB_C(-1.0);
    real_t const gained = (seen->speed - carriage->speed) * way;
    return ((seen->speed * way) < 0) && (gained < -GAINED);
}

/* Whether the carriage has stood still for too long under the full force. */
static bool is_blocked(tb_carriage *carriage, const tb_carriage_motion *seen)
{
    if (TB_ABS(seen->torque) < FULL_PUSH) {
        forget_range(carriage, seen->position);
        return false;
    }
    carriage->cycles++;
    carriage->low = tb_min(carriage->low, seen->position);
    carriage->high = tb_max(carriage->high, seen->position);
    if ((carriage->high - carriage->low) >= TB_BLOCKED_TRAVEL) {
        forget_range(carriage, seen->position);
    }
    return carriage->cycles > TB_BLOCKED_CYCLES;
}

tb_cause tb_carriage_look(tb_carriage *carriage, const tb_carriage_motion *seen)
{
    if (!goes_on(carriage, seen->torque)) {
        begin_push(carriage, seen);
    }
    if (gains_against(carriage, seen)) {
        return TB_CAUSE_WRONG_WAY;
    }
    return is_blocked(carriage, seen) ? TB_CAUSE_BASE_BLOCKED : TB_CAUSE_NONE;
}
