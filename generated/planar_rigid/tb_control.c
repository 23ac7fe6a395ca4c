/* Regenerate: turnbuckle generate machines/planar_rigid.toml --out <this folder>
 * Machine 95fa38e7104ced7a, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_control.h"
#include "tb_machine.h"

tb_status tb_motor_torques(const real_t tension[6], real_t torque[6])
{
    if (!(TB_ABS(tension[0]) + TB_ABS(tension[1]) + TB_ABS(tension[2]) + TB_ABS(tension[3]) +
              TB_ABS(tension[4]) + TB_ABS(tension[5]) <= TB_C(60000.0))) {
        torque[0] = TB_C(0.0);
        torque[1] = TB_C(0.0);
        torque[2] = TB_C(0.0);
        torque[3] = TB_C(0.0);
        torque[4] = TB_C(0.0);
        torque[5] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t torque_0 = TB_DRUM_RADIUS * tension[0];
    const real_t torque_1 = TB_DRUM_RADIUS * tension[1];
    const real_t torque_2 = TB_DRUM_RADIUS * tension[2];
    const real_t torque_3 = TB_DRUM_RADIUS * tension[3];
    const real_t torque_4 = TB_DRUM_RADIUS * tension[4];
    const real_t torque_5 = TB_DRUM_RADIUS * tension[5];
    torque[0] = torque_0;
    torque[1] = torque_1;
    torque[2] = torque_2;
    torque[3] = torque_3;
    torque[4] = torque_4;
    torque[5] = torque_5;
    return TB_OK;
}

tb_status tb_wall_force(const real_t pose[3], const real_t velocity[3], real_t force[3])
{
    if (!(pose[0] >= -TB_C(1.4236) && pose[0] <= TB_C(1.4236)
          && pose[1] >= -TB_C(1.4236) && pose[1] <= TB_C(1.4236)
          && pose[2] >= -TB_C(1.2853981633974483) && pose[2] <= TB_C(1.2853981633974483)
          && TB_ABS(velocity[0]) + TB_ABS(velocity[1]) + TB_ABS(velocity[2]) <= TB_C(300.0))) {
        force[0] = TB_C(0.0);
        force[1] = TB_C(0.0);
        force[2] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    force[0] = TB_C(0.0);
    force[1] = TB_C(0.0);
    force[2] = TB_C(0.0);
    return TB_OK;
}

/* Refuses with a status: load is 3 N. */
static tb_status tb_refuse_load_tension(tb_status status, real_t load[6])
{
    load[0] = TB_TENSION_MIN;
    load[1] = TB_TENSION_MIN;
    load[2] = TB_TENSION_MIN;
    load[3] = TB_TENSION_MIN;
    load[4] = TB_TENSION_MIN;
    load[5] = TB_TENSION_MIN;
    return status;
}

tb_status tb_load_tension(const real_t structure[18], const real_t tension[6],
    const real_t hand_force[3], real_t load[6])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) + TB_ABS(structure[10]) + TB_ABS(structure[11]) +
              TB_ABS(structure[12]) + TB_ABS(structure[13]) + TB_ABS(structure[14]) +
              TB_ABS(structure[15]) + TB_ABS(structure[16]) + TB_ABS(structure[17]) <=
              TB_C(72.0)
          && TB_ABS(tension[0]) + TB_ABS(tension[1]) + TB_ABS(tension[2]) + TB_ABS(tension[3])
              + TB_ABS(tension[4]) + TB_ABS(tension[5]) <= TB_C(60000.0)
          && TB_ABS(hand_force[0]) + TB_ABS(hand_force[1]) + TB_ABS(hand_force[2]) <=
              TB_C(180000.0))) {
        return tb_refuse_load_tension(TB_OUT_OF_DOMAIN, load);
    }
    const real_t t0 = structure[6] * structure[0] + structure[7] * structure[1];
    const real_t t1 = t0 + structure[8] * structure[2] + structure[9] * structure[3];
    const real_t t2 = t1 + structure[10] * structure[4] + structure[11] * structure[5];
    const real_t t3 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t4 = t3 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t5 = t4 + structure[4] * structure[4] + structure[5] * structure[5];
    const real_t t6 = TB_C(1.0) / t5;
    const real_t t7 = t2 * t6;
    const real_t t8 = tension[0] * structure[0] + structure[1] * tension[1];
    const real_t t9 = t8 + structure[2] * tension[2] + structure[3] * tension[3];
    const real_t t10 = t9 + structure[4] * tension[4] + structure[5] * tension[5];
    const real_t t11 = hand_force[0] + t10;
    const real_t t12 = tension[0] * structure[6] + structure[7] * tension[1];
    const real_t t13 = t12 + structure[8] * tension[2] + structure[9] * tension[3];
    const real_t t14 = t13 + structure[10] * tension[4] + structure[11] * tension[5];
    const real_t t15 = t7 * t11 - (hand_force[1] + t14);
    const real_t t16 = structure[6] * structure[6] + structure[7] * structure[7];
    const real_t t17 = t16 + structure[8] * structure[8] + structure[9] * structure[9];
    const real_t t18 = t17 + structure[10] * structure[10] + structure[11] * structure[11];
    const real_t t19 = t18 - t5 * (t7 * t7);
    const real_t t20 = TB_C(1.0) / t19;
    const real_t t21 = structure[12] * TB_MOMENT_WEIGHT;
    const real_t t22 = TB_MOMENT_WEIGHT * structure[13];
    const real_t t23 = TB_MOMENT_WEIGHT * structure[14];
    const real_t t24 = structure[6] * t21 + structure[7] * t22 + structure[8] * t23;
    const real_t t25 = TB_MOMENT_WEIGHT * structure[15];
    const real_t t26 = TB_MOMENT_WEIGHT * structure[16];
    const real_t t27 = TB_MOMENT_WEIGHT * structure[17];
    const real_t t28 = t24 + structure[9] * t25 + structure[10] * t26 + structure[11] * t27;
    const real_t t29 = structure[0] * t21 + structure[1] * t22 + structure[2] * t23;
    const real_t t30 = t29 + structure[3] * t25 + structure[4] * t26 + structure[5] * t27;
    const real_t t31 = t6 * t30;
    const real_t t32 = t20 * (t28 - t5 * (t7 * t31));
    const real_t t33 = tension[0] * structure[12] + tension[1] * structure[13];
    const real_t t34 = t33 + tension[2] * structure[14] + tension[3] * structure[15];
    const real_t t35 = t34 + tension[4] * structure[16] + tension[5] * structure[17];
    const real_t t36 = t11 * t31 - TB_MOMENT_WEIGHT * (hand_force[2] + t35);
    const real_t t37 = t21 * t21 + t22 * t22 + t23 * t23 + t25 * t25 + t26 * t26;
    const real_t t38 = t37 + t27 * t27 - t5 * (t31 * t31) - t19 * (t32 * t32);
    const real_t t39 = (t36 - t15 * t32) / t38;
    const real_t t40 = t15 * t20 - t32 * t39;
    const real_t t41 = t6 * t11 + t7 * t40 + t31 * t39;
    const real_t t42 = structure[6] * t40 - structure[0] * t41 + t21 * t39;
    const real_t load_0 = tension[0] + t42;
    const real_t t43 = structure[7] * t40 - structure[1] * t41 + t22 * t39;
    const real_t load_1 = tension[1] + t43;
    const real_t t44 = structure[8] * t40 - structure[2] * t41 + t23 * t39;
    const real_t load_2 = tension[2] + t44;
    const real_t t45 = structure[9] * t40 - structure[3] * t41 + t25 * t39;
    const real_t load_3 = tension[3] + t45;
    const real_t t46 = structure[10] * t40 - structure[4] * t41 + t26 * t39;
    const real_t load_4 = tension[4] + t46;
    const real_t t47 = structure[11] * t40 - structure[5] * t41 + t27 * t39;
    const real_t load_5 = tension[5] + t47;
    const real_t t48 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const bool t49 = !(t48 < t5 && t48 < t19 && t48 < t38);
    if (t49) {
        return tb_refuse_load_tension(TB_SINGULAR, load);
    }
    load[0] = load_0;
    load[1] = load_1;
    load[2] = load_2;
    load[3] = load_3;
    load[4] = load_4;
    load[5] = load_5;
    return TB_OK;
}

tb_status tb_base_targets(const real_t pose[3], real_t target[6])
{
    if (!(pose[0] >= -TB_C(1.4236) && pose[0] <= TB_C(1.4236)
          && pose[1] >= -TB_C(1.4236) && pose[1] <= TB_C(1.4236)
          && pose[2] >= -TB_C(1.2853981633974483) && pose[2] <= TB_C(1.2853981633974483))) {
        target[0] = TB_C(0.0);
        target[1] = TB_C(0.0);
        target[2] = TB_C(0.0);
        target[3] = TB_C(0.0);
        target[4] = TB_C(0.0);
        target[5] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = pose[2] * pose[2] * TB_C(0.25);
    const real_t t1 = -TB_C(2.4795962632247972e-27) + t0 * TB_C(3.279889237069838e-30);
    const real_t t2 = -TB_C(8.896791392450574e-22) + t0 * (TB_C(1.6117375710961184e-24) + t0 *
        t1);
    const real_t t3 = -TB_C(1.5619206968586225e-16) + t0 * (TB_C(4.110317623312165e-19) + t0 *
        t2);
    const real_t t4 = -TB_C(1.1470745597729725e-11) + t0 * (TB_C(4.779477332387385e-14) + t0 *
        t3);
    const real_t t5 = -TB_C(2.755731922398589e-07) + t0 * (TB_C(2.08767569878681e-09) + t0 *
        t4);
    const real_t t6 = -TB_C(0.001388888888888889) + t0 * (TB_C(2.48015873015873e-05) + t0 * t5);
    const real_t t7 = -TB_C(0.5) + t0 * (TB_C(0.041666666666666664) + t0 * t6);
    const real_t t8 = TB_C(1.0) + t0 * t7;
    const real_t t9 = TB_C(6.446950284384474e-26) + t0 * -TB_C(9.183689863795546e-29);
    const real_t t10 = TB_C(1.9572941063391263e-20) + t0 * (-TB_C(3.8681701706306835e-23) + t0
        * t9);
    const real_t t11 = TB_C(2.8114572543455206e-15) + t0 * (-TB_C(8.22063524662433e-18) + t0 *
        t10);
    const real_t t12 = TB_C(1.6059043836821613e-10) + t0 * (-TB_C(7.647163731819816e-13) + t0 *
        t11);
    const real_t t13 = TB_C(2.7557319223985893e-06) + t0 * (-TB_C(2.505210838544172e-08) + t0 *
        t12);
    const real_t t14 = TB_C(0.008333333333333333) + t0 * (-TB_C(0.0001984126984126984) + t0 *
        t13);
    const real_t t15 = TB_C(1.0) + t0 * (-TB_C(0.16666666666666666) + t0 * t14);
    const real_t t16 = pose[2] * (t15 * TB_C(0.5));
    const real_t t17 = t8 * t8 - t16 * t16;
    const real_t t18 = -TB_C(0.04) * t17;
    const real_t t19 = t16 * (t8 * TB_C(2.0));
    const real_t t20 = -TB_C(0.025) * t19;
    const real_t target_0 = tb_min(tb_max(pose[0] + (t18 - t20), TB_C(0.0)), TB_FRAME_X);
    const real_t t21 = t17 * TB_C(0.04);
    const real_t target_1 = tb_min(tb_max(pose[0] + (t21 - t20), TB_C(0.0)), TB_FRAME_X);
    const real_t target_2 = tb_min(tb_max(pose[1] + t19 * TB_LONGEST_ARM, TB_C(0.0)),
        TB_FRAME_Y);
    const real_t t22 = t19 * TB_C(0.025);
    const real_t target_3 = tb_min(tb_max(pose[0] + (t21 - t22), TB_C(0.0)), TB_FRAME_X);
    const real_t target_4 = tb_min(tb_max(pose[0] + (t18 - t22), TB_C(0.0)), TB_FRAME_X);
    const real_t target_5 = tb_min(tb_max(pose[1] + t19 * TB_ANCHOR_6_X, TB_C(0.0)),
        TB_FRAME_Y);
    target[0] = target_0;
    target[1] = target_1;
    target[2] = target_2;
    target[3] = target_3;
    target[4] = target_4;
    target[5] = target_5;
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

