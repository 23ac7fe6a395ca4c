#include "hold.h"

void tb_pull(tb_supervisor *supervisor, size_t cable, real_t tension)
{
    supervisor->drives[cable].wanted.torque = TB_DRUM_RADIUS * tension;
}

void tb_hold_cables(tb_supervisor *supervisor)
{
    for (size_t i = 0; i < TB_CABLES; i++) {
        tb_pull(supervisor, i, TB_TENSION_MIN);
    }
}

tb_blame tb_guide_bases(tb_supervisor *supervisor, const real_t targets[TB_RAIL_SLOTS],
                        real_t speed)
{
    real_t rails[TB_RAIL_SLOTS];
    real_t torque[TB_RAIL_SLOTS];
    tb_measured_rails(&supervisor->measurement, rails);
    tb_guide_step(&supervisor->guide, rails, targets, speed, torque);
    for (size_t i = TB_CABLES; i < TB_DRIVES; i++) {
        tb_drive_order *const wanted = &supervisor->drives[i].wanted;
        wanted->torque = torque[i - TB_CABLES];
        wanted->position = supervisor->guide.reference[i - TB_CABLES];
    }
    size_t lost = 0;
    return tb_guide_has_lost(&supervisor->guide, &lost)
               ? tb_blame_for(TB_CAUSE_BASE_LOST, TB_CABLES + lost, 0)
               : tb_no_blame();
}

tb_blame tb_hold_bases(tb_supervisor *supervisor)
{
    real_t reference[TB_RAIL_SLOTS];
    for (size_t i = 0; i < TB_RAIL_SLOTS; i++) {
        reference[i] = supervisor->guide.reference[i];
    }
    return tb_guide_bases(supervisor, reference, TB_C(0.0));
}
