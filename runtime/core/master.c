#include "master.h"

#include <stddef.h>

static const tb_observation nothing_seen;
static const tb_orders nothing_ordered;

void tb_master_start(tb_master *master, tb_fieldbus *fieldbus)
{
    master->fieldbus = fieldbus;
    master->seen = nothing_seen;
    master->orders = nothing_ordered;
    tb_supervisor_start(&master->supervisor);
    tb_recorder_start(&master->recorder, &master->supervisor);
}

void tb_master_sync(tb_master *master)
{
    master->fieldbus->protocol->sync(master->fieldbus);
}

static void hear(tb_observation *seen, const tb_wishes *wishes, uint32_t missed)
{
    for (size_t i = 0; i < TB_DOF; i++) {
        seen->force[i] = wishes->force[i];
        seen->hand_force[i] = wishes->hand_force[i];
    }
    seen->hand_force_fresh = wishes->hand_force_fresh;
    seen->requests = wishes->requests;
    seen->missed = missed;
}

void tb_master_run(tb_master *master, const tb_wishes *wishes, uint32_t missed)
{
    tb_fieldbus *const fieldbus = master->fieldbus;
    hear(&master->seen, wishes, missed);
    fieldbus->protocol->collect(fieldbus, &master->seen);
    tb_supervisor_step(&master->supervisor, &master->seen, &master->orders);
    tb_recorder_keep(&master->recorder, &master->seen, &master->orders, &master->supervisor);
    fieldbus->protocol->dispatch(fieldbus, &master->orders);
}
