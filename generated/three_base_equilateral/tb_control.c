/* Regenerate: turnbuckle generate machines/three_base_equilateral.toml --out <this folder>
 * Machine bf852767ce09ae7f, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_control.h"
#include "tb_machine.h"

tb_status tb_motor_torques(const real_t tension[3], real_t torque[3])
{
    if (!(TB_ABS(tension[0]) + TB_ABS(tension[1]) + TB_ABS(tension[2]) <= TB_C(30000.0))) {
        torque[0] = TB_C(0.0);
        torque[1] = TB_C(0.0);
        torque[2] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t torque_0 = TB_DRUM_RADIUS * tension[0];
    const real_t torque_1 = TB_DRUM_RADIUS * tension[1];
    const real_t torque_2 = TB_DRUM_RADIUS * tension[2];
    torque[0] = torque_0;
    torque[1] = torque_1;
    torque[2] = torque_2;
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
static tb_status tb_refuse_load_tension(tb_status status, real_t load[3])
{
    load[0] = TB_TENSION_MIN;
    load[1] = TB_TENSION_MIN;
    load[2] = TB_TENSION_MIN;
    return status;
}

tb_status tb_load_tension(const real_t structure[6], const real_t tension[3],
    const real_t hand_force[2], real_t load[3])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) <= TB_C(24.0)
          && TB_ABS(tension[0]) + TB_ABS(tension[1]) + TB_ABS(tension[2]) <= TB_C(30000.0)
          && TB_ABS(hand_force[0]) + TB_ABS(hand_force[1]) <= TB_C(60000.0))) {
        return tb_refuse_load_tension(TB_OUT_OF_DOMAIN, load);
    }
    const real_t t0 = structure[3] * structure[0] + structure[4] * structure[1];
    const real_t t1 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t2 = t1 + structure[2] * structure[2];
    const real_t t3 = TB_C(1.0) / t2;
    const real_t t4 = (t0 + structure[5] * structure[2]) * t3;
    const real_t t5 = tension[0] * structure[0] + structure[1] * tension[1];
    const real_t t6 = hand_force[0] + (t5 + structure[2] * tension[2]);
    const real_t t7 = tension[0] * structure[3] + structure[4] * tension[1];
    const real_t t8 = t4 * t6 - (hand_force[1] + (t7 + structure[5] * tension[2]));
    const real_t t9 = structure[3] * structure[3] + structure[4] * structure[4];
    const real_t t10 = t9 + structure[5] * structure[5] - t2 * (t4 * t4);
    const real_t t11 = t8 / t10;
    const real_t t12 = t3 * t6 + t4 * t11;
    const real_t load_0 = tension[0] + (structure[3] * t11 - structure[0] * t12);
    const real_t load_1 = tension[1] + (structure[4] * t11 - structure[1] * t12);
    const real_t load_2 = tension[2] + (structure[5] * t11 - structure[2] * t12);
    const real_t t13 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const bool t14 = !(t13 < t2 && t13 < t10);
    if (t14) {
        return tb_refuse_load_tension(TB_SINGULAR, load);
    }
    load[0] = load_0;
    load[1] = load_1;
    load[2] = load_2;
    return TB_OK;
}

tb_status tb_base_targets(const real_t pose[2], real_t target[6])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472))) {
        target[0] = TB_C(0.0);
        target[1] = TB_C(0.0);
        target[2] = TB_C(0.0);
        target[3] = TB_C(0.0);
        target[4] = TB_C(0.0);
        target[5] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t target_0 = tb_min(tb_max(pose[0], TB_C(0.0)), TB_FRAME);
    const real_t t0 = TB_C(0.7499999999999999) * pose[1];
    const real_t t1 = (pose[0] * -TB_C(0.43301270189221946) + t0) * TB_C(1.3333333333333333);
    const real_t target_2 = tb_min(tb_max(t1, TB_C(0.0)), TB_FRAME);
    const real_t t2 = TB_C(0.43301270189221946) * (pose[0] - TB_FRAME);
    const real_t t3 = tb_max(TB_C(1.3333333333333333) * (t0 + t2), TB_C(0.0));
    const real_t target_4 = tb_min(t3, TB_FRAME);
    target[0] = target_0;
    target[1] = TB_C(0.0);
    target[2] = target_2;
    target[3] = TB_C(0.0);
    target[4] = target_4;
    target[5] = TB_C(0.0);
    return TB_OK;
}

tb_status tb_base_pid(const real_t memory[18], const real_t target[6], const real_t measured[6],
    real_t next_memory[18], real_t force[6])
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
    const real_t t8 = target[2] - measured[2];
    const real_t t9 = TB_CONTROL_RATE * (measured[2] - memory[7]) - memory[8];
    const real_t next_memory_8 = memory[8] + TB_RAIL_SPEED_GAIN * t9;
    const real_t t10 = TB_RAIL_STIFFNESS * t8 + memory[6] - TB_RAIL_DAMPING * next_memory_8;
    const bool t11 = (TB_RAIL_FORCE_LIMIT < t10 && TB_C(0.0) < t8) || (t10 <
        -TB_RAIL_FORCE_LIMIT && t8 < TB_C(0.0));
    const real_t next_memory_6 = t11 ? memory[6] : memory[6] + TB_RAIL_INTEGRAL_STEP * t8;
    const real_t t12 = target[3] - measured[3];
    const real_t t13 = TB_CONTROL_RATE * (measured[3] - memory[10]) - memory[11];
    const real_t next_memory_11 = memory[11] + TB_RAIL_SPEED_GAIN * t13;
    const real_t t14 = TB_RAIL_STIFFNESS * t12 + memory[9] - TB_RAIL_DAMPING * next_memory_11;
    const bool t15 = (TB_RAIL_FORCE_LIMIT < t14 && TB_C(0.0) < t12) || (t14 <
        -TB_RAIL_FORCE_LIMIT && t12 < TB_C(0.0));
    const real_t next_memory_9 = t15 ? memory[9] : memory[9] + TB_RAIL_INTEGRAL_STEP * t12;
    const real_t t16 = target[4] - measured[4];
    const real_t t17 = TB_CONTROL_RATE * (measured[4] - memory[13]) - memory[14];
    const real_t next_memory_14 = memory[14] + TB_RAIL_SPEED_GAIN * t17;
    const real_t t18 = TB_RAIL_STIFFNESS * t16 + memory[12] - TB_RAIL_DAMPING * next_memory_14;
    const bool t19 = (TB_RAIL_FORCE_LIMIT < t18 && TB_C(0.0) < t16) || (t18 <
        -TB_RAIL_FORCE_LIMIT && t16 < TB_C(0.0));
    const real_t next_memory_12 = t19 ? memory[12] : memory[12] + TB_RAIL_INTEGRAL_STEP * t16;
    const real_t t20 = target[5] - measured[5];
    const real_t t21 = TB_CONTROL_RATE * (measured[5] - memory[16]) - memory[17];
    const real_t next_memory_17 = memory[17] + TB_RAIL_SPEED_GAIN * t21;
    const real_t t22 = TB_RAIL_STIFFNESS * t20 + memory[15] - TB_RAIL_DAMPING * next_memory_17;
    const bool t23 = (TB_RAIL_FORCE_LIMIT < t22 && TB_C(0.0) < t20) || (t22 <
        -TB_RAIL_FORCE_LIMIT && t20 < TB_C(0.0));
    const real_t next_memory_15 = t23 ? memory[15] : memory[15] + TB_RAIL_INTEGRAL_STEP * t20;
    const real_t force_0 = tb_min(tb_max(t2, -TB_RAIL_FORCE_LIMIT), TB_RAIL_FORCE_LIMIT);
    const real_t force_1 = tb_min(tb_max(t6, -TB_RAIL_FORCE_LIMIT), TB_RAIL_FORCE_LIMIT);
    const real_t force_2 = tb_min(tb_max(t10, -TB_RAIL_FORCE_LIMIT), TB_RAIL_FORCE_LIMIT);
    const real_t force_3 = tb_min(tb_max(t14, -TB_RAIL_FORCE_LIMIT), TB_RAIL_FORCE_LIMIT);
    const real_t force_4 = tb_min(tb_max(t18, -TB_RAIL_FORCE_LIMIT), TB_RAIL_FORCE_LIMIT);
    const real_t force_5 = tb_min(tb_max(t22, -TB_RAIL_FORCE_LIMIT), TB_RAIL_FORCE_LIMIT);
    const bool t24 = TB_ABS(t2) <= TB_C(1000000000.0) && TB_ABS(t6) <= TB_C(1000000000.0);
    const bool t25 = t24 && TB_ABS(t10) <= TB_C(1000000000.0) && TB_ABS(t14) <=
        TB_C(1000000000.0);
    const bool t26 = t25 && TB_ABS(t18) <= TB_C(1000000000.0) && TB_ABS(t22) <=
        TB_C(1000000000.0);
    const bool t27 = !t26;
    if (t27) {
        next_memory[0] = TB_C(0.0);
        next_memory[1] = TB_C(0.0);
        next_memory[2] = TB_C(0.0);
        next_memory[3] = TB_C(0.0);
        next_memory[4] = TB_C(0.0);
        next_memory[5] = TB_C(0.0);
        next_memory[6] = TB_C(0.0);
        next_memory[7] = TB_C(0.0);
        next_memory[8] = TB_C(0.0);
        next_memory[9] = TB_C(0.0);
        next_memory[10] = TB_C(0.0);
        next_memory[11] = TB_C(0.0);
        next_memory[12] = TB_C(0.0);
        next_memory[13] = TB_C(0.0);
        next_memory[14] = TB_C(0.0);
        next_memory[15] = TB_C(0.0);
        next_memory[16] = TB_C(0.0);
        next_memory[17] = TB_C(0.0);
        force[0] = TB_C(0.0);
        force[1] = TB_C(0.0);
        force[2] = TB_C(0.0);
        force[3] = TB_C(0.0);
        force[4] = TB_C(0.0);
        force[5] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    next_memory[0] = next_memory_0;
    next_memory[1] = measured[0];
    next_memory[2] = next_memory_2;
    next_memory[3] = next_memory_3;
    next_memory[4] = measured[1];
    next_memory[5] = next_memory_5;
    next_memory[6] = next_memory_6;
    next_memory[7] = measured[2];
    next_memory[8] = next_memory_8;
    next_memory[9] = next_memory_9;
    next_memory[10] = measured[3];
    next_memory[11] = next_memory_11;
    next_memory[12] = next_memory_12;
    next_memory[13] = measured[4];
    next_memory[14] = next_memory_14;
    next_memory[15] = next_memory_15;
    next_memory[16] = measured[5];
    next_memory[17] = next_memory_17;
    force[0] = force_0;
    force[1] = force_1;
    force[2] = force_2;
    force[3] = force_3;
    force[4] = force_4;
    force[5] = force_5;
    return TB_OK;
}

