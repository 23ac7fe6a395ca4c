#include "inbox.h"

#include <stddef.h>

/* 1 where the counter moved since the last cycle. */
static uint32_t moved(const tb_atomic_u32 *counter, uint32_t *seen)
{
    uint32_t const now = atomic_load_explicit(counter, memory_order_acquire);
    uint32_t const asked = (now != *seen) ? 1u : 0u;
    *seen = now;
    return asked;
}

/* Take a force that was written since the last cycle. One that is being written right now is not
 * waited for: the next cycle will find it. */
static void refresh(const tb_atomic_u64 *sequence, const double shared[TB_DOF],
                    tb_standing_force *standing)
{
    uint64_t const before = atomic_load_explicit(sequence, memory_order_acquire);
    standing->age += (standing->age < TB_FORCE_CYCLES) ? 1u : 0u;
    if ((before == standing->sequence) || ((before % 2u) != 0u)) {
        return;
    }
    real_t copy[TB_DOF];
    for (size_t i = 0; i < TB_DOF; i++) {
        copy[i] = (real_t)((const volatile double *)shared)[i];
    }
    atomic_thread_fence(memory_order_acquire);
    if (atomic_load_explicit(sequence, memory_order_relaxed) != before) {
        return;
    }
    standing->sequence = before;
    standing->age = 0;
    for (size_t i = 0; i < TB_DOF; i++) {
        standing->value[i] = copy[i];
    }
}

/* Nobody has ever written while the sequence is 0. */
static bool is_fresh(const tb_standing_force *standing)
{
    return (standing->sequence != 0u) && (standing->age < TB_FORCE_CYCLES);
}

static void give(const tb_standing_force *standing, real_t force[TB_DOF])
{
    for (size_t i = 0; i < TB_DOF; i++) {
        force[i] = is_fresh(standing) ? standing->value[i] : TB_C(0.0);
    }
}

void tb_inbox_read(tb_inbox *inbox, const tb_telemetry_inbox *shared, tb_wishes *wishes)
{
    wishes->requests = (moved(&shared->arm, &inbox->arm) * TB_REQUEST_ARM) |
                       (moved(&shared->stop, &inbox->stop) * TB_REQUEST_STOP) |
                       (moved(&shared->reset, &inbox->reset) * TB_REQUEST_RESET);
    refresh(&shared->force_sequence, shared->force, &inbox->force);
    refresh(&shared->hand_sequence, shared->hand_force, &inbox->hand);
    wishes->hand_force_fresh = is_fresh(&inbox->hand) ? 1u : 0u;
    give(&inbox->force, wishes->force);
    give(&inbox->hand, wishes->hand_force);
}
