/* Regenerate: turnbuckle generate machines/yoon_synchronised.toml --out <this folder>
 * Machine 2674137f8fc00ebb, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_control.h"
#include "tb_machine.h"

tb_status tb_motor_torques(const real_t tension[4], real_t torque[4])
{
    if (!(TB_ABS(tension[0]) + TB_ABS(tension[1]) + TB_ABS(tension[2]) + TB_ABS(tension[3]) <=
              TB_C(40000.0))) {
        torque[0] = TB_C(0.0);
        torque[1] = TB_C(0.0);
        torque[2] = TB_C(0.0);
        torque[3] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t torque_0 = TB_DRUM_RADIUS * tension[0];
    const real_t torque_1 = TB_DRUM_RADIUS * tension[1];
    const real_t torque_2 = TB_DRUM_RADIUS * tension[2];
    const real_t torque_3 = TB_DRUM_RADIUS * tension[3];
    torque[0] = torque_0;
    torque[1] = torque_1;
    torque[2] = torque_2;
    torque[3] = torque_3;
    return TB_OK;
}

tb_status tb_wall_force(const real_t pose[2], const real_t velocity[2], real_t force[2])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(velocity[0]) + TB_ABS(velocity[1]) <= TB_C(200.0))) {
        force[0] = TB_C(0.0);
        force[1] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    force[0] = TB_C(0.0);
    force[1] = TB_C(0.0);
    return TB_OK;
}

/* Refuses with a status: load is 3 N. */
static tb_status tb_refuse_load_tension(tb_status status, real_t load[4])
{
    load[0] = TB_TENSION_MIN;
    load[1] = TB_TENSION_MIN;
    load[2] = TB_TENSION_MIN;
    load[3] = TB_TENSION_MIN;
    return status;
}

tb_status tb_load_tension(const real_t structure[8], const real_t tension[4],
    const real_t hand_force[2], real_t load[4])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) <= TB_C(32.0)
          && TB_ABS(tension[0]) + TB_ABS(tension[1]) + TB_ABS(tension[2]) + TB_ABS(tension[3])
              <= TB_C(40000.0)
          && TB_ABS(hand_force[0]) + TB_ABS(hand_force[1]) <= TB_C(80000.0))) {
        return tb_refuse_load_tension(TB_OUT_OF_DOMAIN, load);
    }
    const real_t t0 = structure[4] * structure[0] + structure[5] * structure[1];
    const real_t t1 = t0 + structure[6] * structure[2] + structure[7] * structure[3];
    const real_t t2 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t3 = t2 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t4 = TB_C(1.0) / t3;
    const real_t t5 = t1 * t4;
    const real_t t6 = tension[0] * structure[0] + structure[1] * tension[1];
    const real_t t7 = t6 + structure[2] * tension[2] + structure[3] * tension[3];
    const real_t t8 = hand_force[0] + t7;
    const real_t t9 = tension[0] * structure[4] + structure[5] * tension[1];
    const real_t t10 = t9 + structure[6] * tension[2] + structure[7] * tension[3];
    const real_t t11 = structure[4] * structure[4] + structure[5] * structure[5];
    const real_t t12 = t11 + structure[6] * structure[6] + structure[7] * structure[7];
    const real_t t13 = t12 - t3 * (t5 * t5);
    const real_t t14 = (t5 * t8 - (hand_force[1] + t10)) / t13;
    const real_t t15 = t4 * t8 + t5 * t14;
    const real_t load_0 = tension[0] + (structure[4] * t14 - structure[0] * t15);
    const real_t load_1 = tension[1] + (structure[5] * t14 - structure[1] * t15);
    const real_t load_2 = tension[2] + (structure[6] * t14 - structure[2] * t15);
    const real_t load_3 = tension[3] + (structure[7] * t14 - structure[3] * t15);
    const real_t t16 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const bool t17 = !(t16 < t3 && t16 < t13);
    if (t17) {
        return tb_refuse_load_tension(TB_SINGULAR, load);
    }
    load[0] = load_0;
    load[1] = load_1;
    load[2] = load_2;
    load[3] = load_3;
    return TB_OK;
}

tb_status tb_base_targets(const real_t pose[2], real_t target[2])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472))) {
        target[0] = TB_C(0.0);
        target[1] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t target_0 = tb_min(tb_max(pose[0], TB_C(0.0)), TB_FRAME_X);
    const real_t target_1 = tb_min(tb_max(pose[1], TB_C(0.0)), TB_FRAME_Y);
    target[0] = target_0;
    target[1] = target_1;
    return TB_OK;
}

tb_status tb_base_pid(const real_t memory[6], const real_t target[2], const real_t measured[2],
    real_t next_memory[6], real_t force[2])
{
    const real_t t0 = target[0] - measured[0];
    const real_t t1 = (measured[0] - memory[1]) * TB_CONTROL_RATE - memory[2];
    const real_t next_memory_2 = memory[2] + TB_RAIL_SPEED_GAIN * t1;
    const real_t t2 = TB_RAIL_STIFFNESS * t0 + memory[0] - TB_RAIL_DAMPING * next_memory_2;
    const bool t3 = (TB_RAIL_FORCE_LIMIT < t2 && TB_C(0.0) < t0) || (t2 < -TB_RAIL_FORCE_LIMIT
        && t0 < TB_C(0.0));
    const real_t next_memory_0 = t3 ? memory[0] : memory[0] + t0 * TB_RAIL_INTEGRAL_STEP;
    const real_t t4 = target[1] - measured[1];
    const real_t t5 = TB_CONTROL_RATE * (measured[1] - memory[4]) - memory[5];
    const real_t next_memory_5 = memory[5] + TB_RAIL_SPEED_GAIN * t5;
    const real_t t6 = TB_RAIL_STIFFNESS * t4 + memory[3] - TB_RAIL_DAMPING * next_memory_5;
    const bool t7 = (TB_RAIL_FORCE_LIMIT < t6 && TB_C(0.0) < t4) || (t6 < -TB_RAIL_FORCE_LIMIT
        && t4 < TB_C(0.0));
    const real_t next_memory_3 = t7 ? memory[3] : memory[3] + TB_RAIL_INTEGRAL_STEP * t4;
    const real_t force_0 = tb_min(tb_max(t2, -TB_RAIL_FORCE_LIMIT), TB_RAIL_FORCE_LIMIT);
    const real_t force_1 = tb_min(tb_max(t6, -TB_RAIL_FORCE_LIMIT), TB_RAIL_FORCE_LIMIT);
    const bool t8 = TB_ABS(t2) <= TB_C(1000000000.0) && TB_ABS(t6) <= TB_C(1000000000.0);
    const bool t9 = !t8;
    if (t9) {
        next_memory[0] = TB_C(0.0);
        next_memory[1] = TB_C(0.0);
        next_memory[2] = TB_C(0.0);
        next_memory[3] = TB_C(0.0);
        next_memory[4] = TB_C(0.0);
        next_memory[5] = TB_C(0.0);
        force[0] = TB_C(0.0);
        force[1] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    next_memory[0] = next_memory_0;
    next_memory[1] = measured[0];
    next_memory[2] = next_memory_2;
    next_memory[3] = next_memory_3;
    next_memory[4] = measured[1];
    next_memory[5] = next_memory_5;
    force[0] = force_0;
    force[1] = force_1;
    return TB_OK;
}

