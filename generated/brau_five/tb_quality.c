/* Regenerate: turnbuckle generate machines/brau_five.toml --out <this folder>
 * Machine b614899c8a021831, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_quality.h"
#include "tb_machine.h"

/* Refuses with a status: force is 0 N. */
static tb_status tb_refuse_isotropic_force(tb_status status, real_t force[1])
{
    force[0] = TB_C(0.0);
    return status;
}

tb_status tb_isotropic_force(const real_t pose[2], const real_t rails[1], real_t force[1])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0))) {
        return tb_refuse_isotropic_force(TB_OUT_OF_DOMAIN, force);
    }
    const real_t t0 = pose[0] * pose[0];
    const real_t t1 = TB_FRAME - pose[1];
    const real_t t2 = t1 * t1;
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 + t2);
    const real_t t3 = TB_C(1.0) / length_0;
    const real_t t4 = pose[0] * t3;
    const real_t t5 = pose[1] * pose[1];
    const real_t length_1 = TB_SQRT(t0 + t5);
    const real_t t6 = TB_C(1.0) / length_1;
    const real_t t7 = pose[1] * t6;
    const real_t t8 = t1 * t3;
    const real_t t9 = pose[0] * t6;
    const real_t t10 = TB_ABS(t4 * t7 + t8 * t9);
    const real_t t11 = TB_FRAME - pose[0];
    const real_t t12 = t11 * t11;
    const real_t length_2 = TB_SQRT(t5 + t12);
    const real_t t13 = TB_C(1.0) / length_2;
    const real_t t14 = pose[1] * t13;
    const real_t t15 = t11 * t13;
    const real_t t16 = TB_ABS(t4 * t14 - t8 * t15);
    const real_t length_3 = TB_SQRT(t2 + t12);
    const real_t t17 = TB_C(1.0) / length_3;
    const real_t t18 = t1 * t17;
    const real_t t19 = t11 * t17;
    const real_t t20 = TB_ABS(t4 * t18 + t8 * t19);
    const real_t t21 = TB_BASE_5_X - pose[0];
    const real_t length_4 = TB_SQRT(t2 + t21 * t21);
    const real_t t22 = TB_C(1.0) / length_4;
    const real_t t23 = t1 * t22;
    const real_t t24 = t21 * t22;
    const real_t t25 = TB_ABS(t4 * t23 + t8 * t24);
    const real_t t26 = TB_C(5.0) * (t23 + (t18 + (t8 - t7 - t14)));
    const real_t t27 = TB_C(5.0) * (t24 + (t19 + (t15 - (t4 + t9))));
    const real_t t28 = TB_C(5.0) * (t10 + t16 + t20 + t25) - TB_ABS(t4 * t26 + t8 * t27);
    const real_t t29 = TB_ABS(t9 * t14 + t7 * t15);
    const real_t t30 = TB_ABS(t7 * t19 - t9 * t18);
    const real_t t31 = TB_ABS(t7 * t24 - t9 * t23);
    const real_t t32 = TB_C(5.0) * (t10 + t29 + t30 + t31) - TB_ABS(t7 * t27 - t9 * t26);
    const real_t t33 = TB_ABS(t15 * t18 + t14 * t19);
    const real_t t34 = TB_ABS(t15 * t23 + t14 * t24);
    const real_t t35 = TB_C(5.0) * (t16 + t29 + t33 + t34) - TB_ABS(t15 * t26 + t14 * t27);
    const real_t t36 = TB_ABS(t19 * t23 - t18 * t24);
    const real_t t37 = TB_C(5.0) * (t33 + (t20 + t30) + t36) - TB_ABS(t19 * t26 - t18 * t27);
    const real_t t38 = TB_C(5.0) * (t36 + (t34 + (t25 + t31))) - TB_ABS(t24 * t26 - t23 * t27);
    const real_t t39 = tb_min(tb_min(tb_min(tb_min(t28, t32), t35), t37), t38);
    const real_t force_0 = tb_max(TB_C(0.0), t39);
    const bool t40 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t41 = t40 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t42 = !(t41 && TB_C(0.0001) < length_4);
    const bool t43 = !(TB_C(0.0) <= t39);
    if (t42) {
        return tb_refuse_isotropic_force(TB_SINGULAR, force);
    }
    force[0] = force_0;
    return t43 ? TB_INFEASIBLE : TB_OK;
}

/* Refuses with a status: margin is 0 N; factor is 0; force is 0 N. */
static tb_status tb_refuse_pose_quality(tb_status status, real_t margin[1], real_t factor[1],
    real_t force[1])
{
    margin[0] = TB_C(0.0);
    factor[0] = TB_C(0.0);
    force[0] = TB_C(0.0);
    return status;
}

tb_status tb_pose_quality(const real_t pose[2], const real_t rails[1], real_t margin[1],
    real_t factor[1], real_t force[1])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0))) {
        return tb_refuse_pose_quality(TB_OUT_OF_DOMAIN, margin, factor, force);
    }
    const real_t t0 = pose[0] * pose[0];
    const real_t t1 = TB_FRAME - pose[1];
    const real_t t2 = t1 * t1;
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 + t2);
    const real_t t3 = TB_C(1.0) / length_0;
    const real_t t4 = pose[0] * t3;
    const real_t t5 = pose[1] * pose[1];
    const real_t length_1 = TB_SQRT(t0 + t5);
    const real_t t6 = TB_C(1.0) / length_1;
    const real_t t7 = pose[1] * t6;
    const real_t t8 = t1 * t3;
    const real_t t9 = pose[0] * t6;
    const real_t t10 = t4 * t7 + t8 * t9;
    const real_t t11 = TB_ABS(t10);
    const real_t t12 = TB_FRAME - pose[0];
    const real_t t13 = t12 * t12;
    const real_t length_2 = TB_SQRT(t5 + t13);
    const real_t t14 = TB_C(1.0) / length_2;
    const real_t t15 = pose[1] * t14;
    const real_t t16 = t12 * t14;
    const real_t t17 = t4 * t15 - t8 * t16;
    const real_t t18 = TB_ABS(t17);
    const real_t length_3 = TB_SQRT(t2 + t13);
    const real_t t19 = TB_C(1.0) / length_3;
    const real_t t20 = t1 * t19;
    const real_t t21 = t12 * t19;
    const real_t t22 = t4 * t20 + t8 * t21;
    const real_t t23 = TB_ABS(t22);
    const real_t t24 = TB_BASE_5_X - pose[0];
    const real_t length_4 = TB_SQRT(t2 + t24 * t24);
    const real_t t25 = TB_C(1.0) / length_4;
    const real_t t26 = t1 * t25;
    const real_t t27 = t24 * t25;
    const real_t t28 = t4 * t26 + t8 * t27;
    const real_t t29 = TB_ABS(t28);
    const real_t t30 = TB_C(5.0) * (t26 + (t20 + (t8 - t7 - t15)));
    const real_t t31 = TB_C(5.0) * (t27 + (t21 + (t16 - (t4 + t9))));
    const real_t t32 = TB_C(5.0) * (t11 + t18 + t23 + t29) - TB_ABS(t4 * t30 + t8 * t31);
    const real_t t33 = t9 * t15 + t7 * t16;
    const real_t t34 = TB_ABS(t33);
    const real_t t35 = t7 * t21 - t9 * t20;
    const real_t t36 = TB_ABS(t35);
    const real_t t37 = t7 * t27 - t9 * t26;
    const real_t t38 = TB_ABS(t37);
    const real_t t39 = TB_C(5.0) * (t11 + t34 + t36 + t38) - TB_ABS(t7 * t31 - t9 * t30);
    const real_t t40 = t16 * t20 + t15 * t21;
    const real_t t41 = TB_ABS(t40);
    const real_t t42 = t16 * t26 + t15 * t27;
    const real_t t43 = TB_ABS(t42);
    const real_t t44 = TB_C(5.0) * (t18 + t34 + t41 + t43) - TB_ABS(t16 * t30 + t15 * t31);
    const real_t t45 = t21 * t26 - t20 * t27;
    const real_t t46 = TB_ABS(t45);
    const real_t t47 = TB_C(5.0) * (t41 + (t23 + t36) + t46) - TB_ABS(t21 * t30 - t20 * t31);
    const real_t t48 = TB_C(5.0) * (t46 + (t43 + (t29 + t38))) - TB_ABS(t27 * t30 - t26 * t31);
    const real_t margin_0 = tb_min(tb_min(tb_min(tb_min(t32, t39), t44), t47), t48);
    const real_t force_0 = tb_max(TB_C(0.0), margin_0);
    const bool t49 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t50 = t49 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t51 = !(t50 && TB_C(0.0001) < length_4);
    const real_t t52 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const real_t t53 = t10 * t10 + t17 * t17 + t22 * t22 + t28 * t28 + t33 * t33;
    const real_t t54 = t53 + t35 * t35 + t37 * t37 + t40 * t40 + t42 * t42;
    const bool t55 = !(t52 * t52 < (t54 + t45 * t45) * TB_C(0.4));
    const bool t56 = !(TB_C(0.0) <= margin_0);
    if (t51 || t55) {
        return tb_refuse_pose_quality(TB_SINGULAR, margin, factor, force);
    }
    if (TB_C(0.0)) {
        return tb_refuse_pose_quality(TB_INACCURATE, margin, factor, force);
    }
    margin[0] = margin_0;
    factor[0] = TB_C(0.0);
    force[0] = force_0;
    return t56 ? TB_INFEASIBLE : TB_OK;
}

/* Refuses with a status: structure is 0; pivot is 0; side is 0; moving is 0; push is 0 N. */
static tb_status tb_refuse_zero_wrench_tension_begin(tb_status status, real_t structure[10],
    real_t pivot[1], real_t side[5], real_t moving[1], real_t push[1])
{
    structure[0] = TB_C(0.0);
    structure[1] = TB_C(0.0);
    structure[2] = TB_C(0.0);
    structure[3] = TB_C(0.0);
    structure[4] = TB_C(0.0);
    structure[5] = TB_C(0.0);
    structure[6] = TB_C(0.0);
    structure[7] = TB_C(0.0);
    structure[8] = TB_C(0.0);
    structure[9] = TB_C(0.0);
    pivot[0] = TB_C(0.0);
    side[0] = TB_C(0.0);
    side[1] = TB_C(0.0);
    side[2] = TB_C(0.0);
    side[3] = TB_C(0.0);
    side[4] = TB_C(0.0);
    moving[0] = TB_C(0.0);
    push[0] = TB_C(0.0);
    return status;
}

/* All cables are free. */
static tb_status tb_zero_wrench_tension_begin(const real_t pose[2], const real_t rails[1],
    real_t structure[10], real_t pivot[1], real_t side[5], real_t moving[1], real_t push[1])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0))) {
        return tb_refuse_zero_wrench_tension_begin(TB_OUT_OF_DOMAIN, structure, pivot, side, moving, push);
    }
    const real_t t0 = pose[0] * pose[0];
    const real_t t1 = TB_FRAME - pose[1];
    const real_t t2 = t1 * t1;
    const real_t t3 = TB_SQRT(t0 + t2);
    const real_t t4 = TB_C(1.0) / t3;
    const real_t t5 = pose[0] * t4;
    const real_t structure_0 = -t5;
    const real_t t6 = pose[1] * pose[1];
    const real_t t7 = TB_SQRT(t0 + t6);
    const real_t t8 = TB_C(1.0) / t7;
    const real_t t9 = pose[0] * t8;
    const real_t structure_1 = -t9;
    const real_t t10 = TB_FRAME - pose[0];
    const real_t t11 = t10 * t10;
    const real_t t12 = TB_SQRT(t6 + t11);
    const real_t t13 = TB_C(1.0) / t12;
    const real_t structure_2 = t10 * t13;
    const real_t t14 = TB_SQRT(t2 + t11);
    const real_t t15 = TB_C(1.0) / t14;
    const real_t structure_3 = t10 * t15;
    const real_t t16 = TB_BASE_5_X - pose[0];
    const real_t t17 = TB_SQRT(t2 + t16 * t16);
    const real_t t18 = TB_C(1.0) / t17;
    const real_t structure_4 = t16 * t18;
    const real_t structure_5 = t1 * t4;
    const real_t t19 = pose[1] * t8;
    const real_t structure_6 = -t19;
    const real_t t20 = pose[1] * t13;
    const real_t structure_7 = -t20;
    const real_t structure_8 = t1 * t15;
    const real_t structure_9 = t1 * t18;
    const real_t t21 = t5 * t5 + t9 * t9 + structure_2 * structure_2 + structure_3 *
        structure_3;
    const real_t t22 = TB_SQRT(t21 + structure_4 * structure_4);
    const real_t t23 = TB_COPYSIGN(t22, structure_0);
    const real_t t24 = TB_ABS(t23);
    const real_t t25 = structure_5 * (t23 - t5) + t9 * t19 - structure_2 * t20;
    const real_t t26 = t25 + structure_3 * structure_8 + structure_4 * structure_9;
    const real_t t27 = t26 * (TB_C(1.0) / (t22 * (t22 + TB_ABS(t5))));
    const real_t t28 = t9 * t27 - t19;
    const real_t t29 = t20 + structure_2 * t27;
    const real_t t30 = structure_8 - structure_3 * t27;
    const real_t t31 = structure_9 - structure_4 * t27;
    const real_t t32 = TB_SQRT(t28 * t28 + t29 * t29 + t30 * t30 + t31 * t31);
    const real_t t33 = TB_ABS(TB_COPYSIGN(t32, t28));
    const real_t pivot_0 = tb_min(t24, t33);
    const bool t34 = TB_C(0.0001) < t3 && TB_C(0.0001) < t7 && TB_C(0.0001) < t12;
    const bool t35 = !(t34 && TB_C(0.0001) < t14 && TB_C(0.0001) < t17);
    const real_t t36 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const bool t37 = !(t36 < t24 && t36 < t33);
    if (t35 || t37) {
        return tb_refuse_zero_wrench_tension_begin(TB_SINGULAR, structure, pivot, side, moving, push);
    }
    structure[0] = structure_0;
    structure[1] = structure_1;
    structure[2] = structure_2;
    structure[3] = structure_3;
    structure[4] = structure_4;
    structure[5] = structure_5;
    structure[6] = structure_6;
    structure[7] = structure_7;
    structure[8] = structure_8;
    structure[9] = structure_9;
    pivot[0] = pivot_0;
    side[0] = TB_C(0.0);
    side[1] = TB_C(0.0);
    side[2] = TB_C(0.0);
    side[3] = TB_C(0.0);
    side[4] = TB_C(0.0);
    moving[0] = -TB_C(1.0);
    push[0] = TB_C(0.0);
    return TB_OK;
}

/* Moves a cable towards its bounds, until it is held or another one is freed. */
static tb_status tb_zero_wrench_tension_step(const real_t structure[10], real_t side[5],
    real_t moving[1], real_t push[1], real_t done[1])
{
    const bool t0 = side[0] == TB_C(0.0);
    const real_t t1 = t0 ? TB_C(1.0) : TB_C(0.0);
    const bool t2 = TB_C(0.0) == side[1];
    const real_t t3 = t2 ? TB_C(1.0) : TB_C(0.0);
    const bool t4 = TB_C(0.0) == side[2];
    const real_t t5 = t4 ? TB_C(1.0) : TB_C(0.0);
    const bool t6 = TB_C(0.0) == side[3];
    const real_t t7 = t6 ? TB_C(1.0) : TB_C(0.0);
    const bool t8 = TB_C(0.0) == side[4];
    const real_t t9 = t8 ? TB_C(1.0) : TB_C(0.0);
    const real_t t10 = t0 ? (t0 ? structure[0] * structure[0] : TB_C(0.0)) : TB_C(0.0);
    const real_t t11 = t2 ? (t2 ? structure[1] * structure[1] : TB_C(0.0)) : TB_C(0.0);
    const real_t t12 = t4 ? (t4 ? structure[2] * structure[2] : TB_C(0.0)) : TB_C(0.0);
    const real_t t13 = t6 ? (t6 ? structure[3] * structure[3] : TB_C(0.0)) : TB_C(0.0);
    const real_t t14 = t8 ? (t8 ? structure[4] * structure[4] : TB_C(0.0)) : TB_C(0.0);
    const real_t t15 = TB_SQRT(t10 + t11 + t12 + t13 + t14);
    const real_t t16 = t0 ? structure[0] : TB_C(0.0);
    const real_t t17 = TB_COPYSIGN(t15, t16);
    const real_t t18 = t16 + t17;
    const real_t t19 = t2 ? (t2 ? structure[1] * structure[6] : TB_C(0.0)) : TB_C(0.0);
    const real_t t20 = t4 ? (t4 ? structure[2] * structure[7] : TB_C(0.0)) : TB_C(0.0);
    const real_t t21 = (t0 ? t18 * structure[5] : TB_C(0.0)) + t19 + t20;
    const real_t t22 = t6 ? (t6 ? structure[3] * structure[8] : TB_C(0.0)) : TB_C(0.0);
    const real_t t23 = t8 ? (t8 ? structure[4] * structure[9] : TB_C(0.0)) : TB_C(0.0);
    const real_t t24 = (t21 + t22 + t23) * (TB_C(1.0) / (t15 * (t15 + TB_ABS(t16))));
    const real_t t25 = structure[6] - structure[1] * t24;
    const real_t t26 = structure[7] - structure[2] * t24;
    const real_t t27 = (t2 ? (t2 ? t25 * t25 : TB_C(0.0)) : TB_C(0.0)) + (t4 ? (t4 ? t26 * t26
        : TB_C(0.0)) : TB_C(0.0));
    const real_t t28 = structure[8] - structure[3] * t24;
    const real_t t29 = t27 + (t6 ? (t6 ? t28 * t28 : TB_C(0.0)) : TB_C(0.0));
    const real_t t30 = structure[9] - structure[4] * t24;
    const real_t t31 = t29 + (t8 ? (t8 ? t30 * t30 : TB_C(0.0)) : TB_C(0.0));
    const real_t t32 = TB_COPYSIGN(TB_SQRT(t31), t2 ? t25 : TB_C(0.0));
    const real_t t33 = tb_min(TB_C(1.0), tb_min(TB_ABS(t17), TB_ABS(t32)));
    const real_t t34 = TB_C(1.0) / t33;
    const real_t t35 = TB_C(64.0) * TB_EPSILON * t34;
    const bool t36 = TB_C(0.0) <= moving[0];
    const real_t t37 = TB_C(1.0) / t17;
    const bool t38 = TB_C(0.0) < side[0];
    const bool t39 = TB_C(0.0) < side[1];
    const real_t t40 = (t38 ? structure[0] * TB_TENSION_MAX : TB_C(0.0)) + (t39 ? structure[1]
        * TB_TENSION_MAX : TB_C(0.0));
    const bool t41 = TB_C(0.0) < side[2];
    const real_t t42 = t40 + (t41 ? structure[2] * TB_TENSION_MAX : TB_C(0.0));
    const bool t43 = TB_C(0.0) < side[3];
    const real_t t44 = t42 + (t43 ? structure[3] * TB_TENSION_MAX : TB_C(0.0));
    const bool t45 = TB_C(0.0) < side[4];
    const real_t t46 = t44 + (t45 ? structure[4] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t47 = t46 * t37;
    const real_t t48 = (t0 ? structure[5] : TB_C(0.0)) - t18 * t24;
    const real_t t49 = TB_C(1.0) / t32;
    const real_t t50 = (t38 ? structure[5] * TB_TENSION_MAX : TB_C(0.0)) + (t39 ? structure[6]
        * TB_TENSION_MAX : TB_C(0.0));
    const real_t t51 = t50 + (t41 ? structure[7] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t52 = t51 + (t43 ? structure[8] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t53 = t52 + (t45 ? structure[9] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t54 = t49 * ((t53 + t47 * t48) * t49);
    const real_t t55 = t37 * (t47 + t48 * t54);
    const real_t t56 = structure[3] * t55 + structure[8] * t54;
    const real_t t57 = TB_C(0.0) < t7 ? tb_max(t56, -(TB_TENSION_MAX + t56)) : -TB_C(1.0);
    const real_t t58 = structure[4] * t55 + structure[9] * t54;
    const real_t t59 = TB_C(0.0) < t9 ? tb_max(t58, -(TB_TENSION_MAX + t58)) : -TB_C(1.0);
    const real_t t60 = structure[0] * t55 + structure[5] * t54;
    const real_t t61 = TB_C(0.0) < t1 ? tb_max(t60, -(TB_TENSION_MAX + t60)) : -TB_C(1.0);
    const real_t t62 = structure[1] * t55 + structure[6] * t54;
    const real_t t63 = TB_C(0.0) < t3 ? tb_max(t62, -(TB_TENSION_MAX + t62)) : -TB_C(1.0);
    const real_t t64 = structure[2] * t55 + structure[7] * t54;
    const real_t t65 = TB_C(0.0) < t5 ? tb_max(t64, -(TB_TENSION_MAX + t64)) : -TB_C(1.0);
    real_t t66, t67, t68, t69, t70;
    if (t36) {
        t66 = moving[0] == TB_C(3.0) ? TB_C(1.0) : TB_C(0.0);
        t67 = moving[0] == TB_C(4.0) ? TB_C(1.0) : TB_C(0.0);
        t68 = TB_C(0.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
        t69 = TB_C(1.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
        t70 = TB_C(2.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
    } else {
        t66 = t57;
        t67 = t59;
        t68 = t61;
        t69 = t63;
        t70 = t65;
    }
    const real_t t71 = tb_max(t68, t69);
    const bool t72 = tb_max(t66, t67) <= tb_max(t71, t70);
    real_t t73, t74, t75, t76;
    if (t72) {
        const bool t77 = t70 <= t71;
        real_t t78, t79, t80, t81;
        if (t77) {
            const bool t82 = t69 <= t68;
            t78 = t82 ? TB_C(0.0) : TB_C(1.0);
            t79 = t82 ? structure[0] : structure[1];
            t80 = t82 ? structure[5] : structure[6];
            t81 = t82 ? -t60 : -t62;
        } else {
            t78 = TB_C(2.0);
            t79 = structure[2];
            t80 = structure[7];
            t81 = -t64;
        }
        t73 = t78;
        t74 = t79;
        t75 = t80;
        t76 = t81;
    } else {
        const bool t83 = t67 <= t66;
        t73 = t83 ? TB_C(3.0) : TB_C(4.0);
        t74 = t83 ? structure[3] : structure[4];
        t75 = t83 ? structure[8] : structure[9];
        t76 = t83 ? -t56 : -t58;
    }
    const real_t t84 = t37 * t74;
    const real_t t85 = t49 * (t49 * (t75 + t48 * t84));
    const real_t t86 = t37 * (t84 + t48 * t85);
    const real_t t87 = structure[0] * t86 + structure[5] * t85;
    const real_t t88 = (TB_C(0.0) == t73 ? TB_C(1.0) : TB_C(0.0)) - t87;
    const real_t t89 = structure[1] * t86 + structure[6] * t85;
    const real_t t90 = (TB_C(1.0) == t73 ? TB_C(1.0) : TB_C(0.0)) - t89;
    const real_t t91 = (t0 ? (t0 ? t88 * t88 : TB_C(0.0)) : TB_C(0.0)) + (t2 ? (t2 ? t90 * t90
        : TB_C(0.0)) : TB_C(0.0));
    const real_t t92 = structure[2] * t86 + structure[7] * t85;
    const real_t t93 = (TB_C(2.0) == t73 ? TB_C(1.0) : TB_C(0.0)) - t92;
    const real_t t94 = t91 + (t4 ? (t4 ? t93 * t93 : TB_C(0.0)) : TB_C(0.0));
    const real_t t95 = structure[3] * t86 + structure[8] * t85;
    const real_t t96 = (TB_C(3.0) == t73 ? TB_C(1.0) : TB_C(0.0)) - t95;
    const real_t t97 = t94 + (t6 ? (t6 ? t96 * t96 : TB_C(0.0)) : TB_C(0.0));
    const real_t t98 = structure[4] * t86 + structure[9] * t85;
    const real_t t99 = (TB_C(4.0) == t73 ? TB_C(1.0) : TB_C(0.0)) - t98;
    const real_t t100 = t97 + (t8 ? (t8 ? t99 * t99 : TB_C(0.0)) : TB_C(0.0));
    const bool t101 = TB_C(2.0) < t1 + t3 + t5 + t7 + t9 && t35 * t35 < t100;
    const real_t t102 = t76 + t100 * push[0];
    const bool t103 = t102 < TB_C(5.0);
    real_t t104;
    if (t101) {
        const real_t t105 = tb_max(t103 ? -t102 : t102 - TB_TENSION_MAX, TB_C(0.0));
        t104 = t105 * (TB_C(1.0) / t100);
    } else {
        t104 = TB_C(1e+30);
    }
    const real_t t106 = t103 ? TB_C(1.0) : -TB_C(1.0);
    const real_t t107 = side[0] * (t87 * t106);
    real_t t108;
    if (t35 < t107) {
        const real_t t109 = t60 + t87 * push[0] + (t38 ? TB_TENSION_MAX : TB_C(0.0));
        t108 = tb_max(-(side[0] * t109), TB_C(0.0)) / t107;
    } else {
        t108 = TB_C(1e+30);
    }
    const real_t t110 = side[1] * (t89 * t106);
    real_t t111;
    if (t35 < t110) {
        const real_t t112 = t62 + t89 * push[0] + (t39 ? TB_TENSION_MAX : TB_C(0.0));
        t111 = tb_max(-(side[1] * t112), TB_C(0.0)) / t110;
    } else {
        t111 = TB_C(1e+30);
    }
    const real_t t113 = side[2] * (t92 * t106);
    real_t t114;
    if (t35 < t113) {
        const real_t t115 = t64 + t92 * push[0] + (t41 ? TB_TENSION_MAX : TB_C(0.0));
        t114 = tb_max(-(side[2] * t115), TB_C(0.0)) / t113;
    } else {
        t114 = TB_C(1e+30);
    }
    const real_t t116 = side[3] * (t95 * t106);
    real_t t117;
    if (t35 < t116) {
        const real_t t118 = t56 + t95 * push[0] + (t43 ? TB_TENSION_MAX : TB_C(0.0));
        t117 = tb_max(-(side[3] * t118), TB_C(0.0)) / t116;
    } else {
        t117 = TB_C(1e+30);
    }
    const real_t t119 = side[4] * (t98 * t106);
    real_t t120;
    if (t35 < t119) {
        const real_t t121 = t58 + t98 * push[0] + (t45 ? TB_TENSION_MAX : TB_C(0.0));
        t120 = tb_max(-(side[4] * t121), TB_C(0.0)) / t119;
    } else {
        t120 = TB_C(1e+30);
    }
    const real_t t122 = tb_min(tb_min(tb_min(tb_min(t108, t111), t114), t117), t120);
    const bool t123 = t104 <= t122;
    const real_t t124 = tb_max(tb_max(tb_max(tb_max(t61, t63), t65), t57), t59);
    const bool t125 = (!t36 && t124 <= t34 * (TB_EPSILON * TB_C(80.0))) || !(tb_min(t104, t122)
        < TB_C(1e+30));
    const real_t t126 = t123 && !t125 ? t73 : -TB_C(1.0);
    const real_t t127 = -t106;
    real_t t128;
    if (t123 || t125) {
        t128 = -TB_C(1.0);
    } else {
        const real_t t129 = -t117;
        const real_t t130 = -t120;
        const real_t t131 = -t108;
        const real_t t132 = -t111;
        const real_t t133 = tb_max(t131, t132);
        const real_t t134 = -t114;
        real_t t135;
        if (tb_max(t129, t130) <= tb_max(t133, t134)) {
            const real_t t136 = t134 <= t133 ? (t132 <= t131 ? TB_C(0.0) : TB_C(1.0)) :
                TB_C(2.0);
            t135 = t136;
        } else {
            t135 = t130 <= t129 ? TB_C(3.0) : TB_C(4.0);
        }
        t128 = t135;
    }
    const real_t side_0 = TB_C(0.0) == t126 ? t127 : (TB_C(0.0) == t128 ? TB_C(0.0) : side[0]);
    const real_t side_1 = TB_C(1.0) == t126 ? t127 : (TB_C(1.0) == t128 ? TB_C(0.0) : side[1]);
    const real_t side_2 = TB_C(2.0) == t126 ? t127 : (TB_C(2.0) == t128 ? TB_C(0.0) : side[2]);
    const real_t side_3 = TB_C(3.0) == t126 ? t127 : (TB_C(3.0) == t128 ? TB_C(0.0) : side[3]);
    const real_t side_4 = TB_C(4.0) == t126 ? t127 : (TB_C(4.0) == t128 ? TB_C(0.0) : side[4]);
    const real_t moving_0 = t123 ? -TB_C(1.0) : t73;
    const real_t push_0 = t123 ? TB_C(0.0) : push[0] + t106 * t122;
    const real_t done_0 = t125 ? TB_C(1.0) : TB_C(0.0);
    side[0] = side_0;
    side[1] = side_1;
    side[2] = side_2;
    side[3] = side_3;
    side[4] = side_4;
    moving[0] = moving_0;
    push[0] = push_0;
    done[0] = done_0;
    return TB_OK;
}

/* The tensions, refined and judged. */
static tb_status tb_zero_wrench_tension_finish(const real_t structure[10], const real_t pivot[1],
    const real_t side[5], real_t tension[5])
{
    const real_t t0 = structure[0] * structure[6] - structure[5] * structure[1];
    const real_t t1 = TB_ABS(t0);
    const real_t t2 = structure[0] * structure[7] - structure[5] * structure[2];
    const real_t t3 = TB_ABS(t2);
    const real_t t4 = structure[0] * structure[8] - structure[5] * structure[3];
    const real_t t5 = TB_ABS(t4);
    const real_t t6 = structure[0] * structure[9] - structure[5] * structure[4];
    const real_t t7 = TB_ABS(t6);
    const real_t t8 = structure[8] + (structure[7] + (structure[6] + structure[5]));
    const real_t t9 = TB_C(5.0) * (structure[9] + t8);
    const real_t t10 = structure[3] + (structure[2] + (structure[0] + structure[1]));
    const real_t t11 = TB_C(5.0) * (structure[4] + t10);
    const real_t t12 = TB_C(5.0) * (t1 + t3 + t5 + t7) - TB_ABS(structure[0] * t9 -
        structure[5] * t11);
    const real_t t13 = structure[1] * structure[7] - structure[6] * structure[2];
    const real_t t14 = TB_ABS(t13);
    const real_t t15 = structure[1] * structure[8] - structure[6] * structure[3];
    const real_t t16 = TB_ABS(t15);
    const real_t t17 = structure[1] * structure[9] - structure[6] * structure[4];
    const real_t t18 = TB_ABS(t17);
    const real_t t19 = TB_C(5.0) * (t1 + t14 + t16 + t18) - TB_ABS(structure[1] * t9 -
        structure[6] * t11);
    const real_t t20 = structure[2] * structure[8] - structure[7] * structure[3];
    const real_t t21 = TB_ABS(t20);
    const real_t t22 = structure[2] * structure[9] - structure[7] * structure[4];
    const real_t t23 = TB_ABS(t22);
    const real_t t24 = TB_C(5.0) * (t3 + t14 + t21 + t23) - TB_ABS(structure[2] * t9 -
        structure[7] * t11);
    const real_t t25 = structure[3] * structure[9] - structure[8] * structure[4];
    const real_t t26 = TB_ABS(t25);
    const real_t t27 = TB_C(5.0) * (t21 + (t5 + t16) + t26) - TB_ABS(structure[3] * t9 -
        structure[8] * t11);
    const real_t t28 = TB_C(5.0) * (t26 + (t23 + (t7 + t18))) - TB_ABS(structure[4] * t9 -
        structure[9] * t11);
    const real_t t29 = tb_min(tb_min(tb_min(tb_min(t12, t19), t24), t27), t28);
    const bool t30 = TB_C(0.0) <= t29;
    const bool t31 = TB_C(0.0) == side[0];
    const bool t32 = TB_C(0.0) < side[0];
    const bool t33 = TB_C(0.0) < side[1];
    const real_t t34 = (t32 ? structure[0] * TB_TENSION_MAX : TB_C(0.0)) + (t33 ? structure[1]
        * TB_TENSION_MAX : TB_C(0.0));
    const bool t35 = TB_C(0.0) < side[2];
    const real_t t36 = t34 + (t35 ? structure[2] * TB_TENSION_MAX : TB_C(0.0));
    const bool t37 = TB_C(0.0) < side[3];
    const real_t t38 = t36 + (t37 ? structure[3] * TB_TENSION_MAX : TB_C(0.0));
    const bool t39 = TB_C(0.0) < side[4];
    const real_t t40 = t38 + (t39 ? structure[4] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t41 = t31 ? (t31 ? structure[0] * structure[0] : TB_C(0.0)) : TB_C(0.0);
    const bool t42 = TB_C(0.0) == side[1];
    const real_t t43 = t42 ? (t42 ? structure[1] * structure[1] : TB_C(0.0)) : TB_C(0.0);
    const bool t44 = TB_C(0.0) == side[2];
    const real_t t45 = t44 ? (t44 ? structure[2] * structure[2] : TB_C(0.0)) : TB_C(0.0);
    const bool t46 = TB_C(0.0) == side[3];
    const real_t t47 = t46 ? (t46 ? structure[3] * structure[3] : TB_C(0.0)) : TB_C(0.0);
    const bool t48 = TB_C(0.0) == side[4];
    const real_t t49 = t48 ? (t48 ? structure[4] * structure[4] : TB_C(0.0)) : TB_C(0.0);
    const real_t t50 = TB_SQRT(t41 + t43 + t45 + t47 + t49);
    const real_t t51 = t31 ? structure[0] : TB_C(0.0);
    const real_t t52 = TB_COPYSIGN(t50, t51);
    const real_t t53 = TB_C(1.0) / t52;
    const real_t t54 = t40 * t53;
    const real_t t55 = t51 + t52;
    const real_t t56 = t42 ? (t42 ? structure[6] * structure[1] : TB_C(0.0)) : TB_C(0.0);
    const real_t t57 = t44 ? (t44 ? structure[7] * structure[2] : TB_C(0.0)) : TB_C(0.0);
    const real_t t58 = (t31 ? structure[5] * t55 : TB_C(0.0)) + t56 + t57;
    const real_t t59 = t46 ? (t46 ? structure[8] * structure[3] : TB_C(0.0)) : TB_C(0.0);
    const real_t t60 = t48 ? (t48 ? structure[9] * structure[4] : TB_C(0.0)) : TB_C(0.0);
    const real_t t61 = (t58 + t59 + t60) * (TB_C(1.0) / (t50 * (t50 + TB_ABS(t51))));
    const real_t t62 = (t31 ? structure[5] : TB_C(0.0)) - t55 * t61;
    const real_t t63 = (t32 ? structure[5] * TB_TENSION_MAX : TB_C(0.0)) + (t33 ? structure[6]
        * TB_TENSION_MAX : TB_C(0.0));
    const real_t t64 = t63 + (t35 ? structure[7] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t65 = t64 + (t37 ? structure[8] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t66 = t65 + (t39 ? structure[9] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t67 = structure[6] - structure[1] * t61;
    const real_t t68 = structure[7] - structure[2] * t61;
    const real_t t69 = (t42 ? (t42 ? t67 * t67 : TB_C(0.0)) : TB_C(0.0)) + (t44 ? (t44 ? t68 *
        t68 : TB_C(0.0)) : TB_C(0.0));
    const real_t t70 = structure[8] - structure[3] * t61;
    const real_t t71 = t69 + (t46 ? (t46 ? t70 * t70 : TB_C(0.0)) : TB_C(0.0));
    const real_t t72 = structure[9] - structure[4] * t61;
    const real_t t73 = t71 + (t48 ? (t48 ? t72 * t72 : TB_C(0.0)) : TB_C(0.0));
    const real_t t74 = TB_COPYSIGN(TB_SQRT(t73), t42 ? t67 : TB_C(0.0));
    const real_t t75 = TB_C(1.0) / t74;
    const real_t t76 = t75 * ((t66 + t54 * t62) * t75);
    const real_t t77 = t53 * (t54 + t62 * t76);
    const real_t t78 = structure[0] * t77 + structure[5] * t76;
    const real_t t79 = structure[1] * t77 + structure[6] * t76;
    const real_t t80 = (t31 ? -(structure[0] * t78) : TB_C(0.0)) + (t42 ? -(structure[1] * t79)
        : TB_C(0.0));
    const real_t t81 = structure[2] * t77 + structure[7] * t76;
    const real_t t82 = structure[3] * t77 + structure[8] * t76;
    const real_t t83 = t80 + (t44 ? -(structure[2] * t81) : TB_C(0.0)) + (t46 ? -(structure[3]
        * t82) : TB_C(0.0));
    const real_t t84 = structure[4] * t77 + structure[9] * t76;
    const real_t t85 = t40 + (t83 + (t48 ? -(structure[4] * t84) : TB_C(0.0)));
    const real_t t86 = t53 * t85;
    const real_t t87 = (t31 ? -(structure[5] * t78) : TB_C(0.0)) + (t42 ? -(structure[6] * t79)
        : TB_C(0.0));
    const real_t t88 = t87 + (t44 ? -(structure[7] * t81) : TB_C(0.0)) + (t46 ? -(structure[8]
        * t82) : TB_C(0.0));
    const real_t t89 = t66 + (t88 + (t48 ? -(structure[9] * t84) : TB_C(0.0)));
    const real_t t90 = t75 * (t75 * (t89 + t62 * t86));
    const real_t t91 = t53 * (t86 + t62 * t90);
    const real_t t92 = t78 + (structure[0] * t91 + structure[5] * t90);
    const real_t t93 = t32 ? TB_TENSION_MAX : TB_C(0.0);
    const real_t t94 = tb_min(tb_max(t31 ? -t92 : t93, TB_C(0.0)), TB_TENSION_MAX);
    const real_t tension_0 = t30 ? t94 : TB_C(0.0);
    const real_t t95 = t79 + (structure[1] * t91 + structure[6] * t90);
    const real_t t96 = t33 ? TB_TENSION_MAX : TB_C(0.0);
    const real_t t97 = tb_min(tb_max(t42 ? -t95 : t96, TB_C(0.0)), TB_TENSION_MAX);
    const real_t tension_1 = t30 ? t97 : TB_C(0.0);
    const real_t t98 = t81 + (structure[2] * t91 + structure[7] * t90);
    const real_t t99 = t35 ? TB_TENSION_MAX : TB_C(0.0);
    const real_t t100 = tb_min(tb_max(t44 ? -t98 : t99, TB_C(0.0)), TB_TENSION_MAX);
    const real_t tension_2 = t30 ? t100 : TB_C(0.0);
    const real_t t101 = t82 + (structure[3] * t91 + structure[8] * t90);
    const real_t t102 = t37 ? TB_TENSION_MAX : TB_C(0.0);
    const real_t t103 = tb_min(tb_max(t46 ? -t101 : t102, TB_C(0.0)), TB_TENSION_MAX);
    const real_t tension_3 = t30 ? t103 : TB_C(0.0);
    const real_t t104 = t84 + (structure[4] * t91 + structure[9] * t90);
    const real_t t105 = t39 ? TB_TENSION_MAX : TB_C(0.0);
    const real_t t106 = tb_min(tb_max(t48 ? -t104 : t105, TB_C(0.0)), TB_TENSION_MAX);
    const real_t tension_4 = t30 ? t106 : TB_C(0.0);
    const bool t107 = !t30;
    const real_t t108 = tb_max(side[0] * (t92 + t93), side[1] * (t95 + t96));
    const real_t t109 = tb_max(tb_max(t108, side[2] * (t98 + t99)), side[3] * (t101 + t102));
    const real_t t110 = tb_max(TB_C(0.0), tb_max(t109, side[4] * (t104 + t105)));
    const real_t t111 = tb_min(TB_C(1.0), tb_min(TB_ABS(t52), TB_ABS(t74)));
    const real_t t112 = tb_max(TB_TENSION_MAX, tb_max(TB_ABS(t77), TB_ABS(t76)));
    const real_t t113 = structure[0] * t94 + structure[1] * t97 + structure[2] * t100;
    const real_t t114 = TB_ABS(t113 + structure[3] * t103 + structure[4] * t106);
    const real_t t115 = tb_max(TB_TENSION_MAX * (t110 * t111) * (TB_C(1.0) / t112), t114);
    const real_t t116 = structure[5] * t94 + structure[6] * t97 + structure[7] * t100;
    const real_t t117 = TB_ABS(t116 + structure[8] * t103 + structure[9] * t106);
    const real_t t118 = TB_C(1600.0) * TB_EPSILON / tb_min(TB_C(1.0), pivot[0]);
    const bool t119 = t107 || tb_max(t115, t117) <= tb_min(t118, TB_C(0.01));
    const bool t120 = !t119;
    if (t120) {
        tension[0] = TB_C(0.0);
        tension[1] = TB_C(0.0);
        tension[2] = TB_C(0.0);
        tension[3] = TB_C(0.0);
        tension[4] = TB_C(0.0);
        return TB_INACCURATE;
    }
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    tension[4] = tension_4;
    return t107 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_zero_wrench_tension(const real_t pose[2], const real_t rails[1], real_t tension[5])
{
    real_t structure[10];
    real_t pivot[1];
    real_t side[5];
    real_t moving[1];
    real_t push[1];
    real_t done[1] = {TB_C(0.0)};
    tb_status status = tb_zero_wrench_tension_begin(pose, rails, structure, pivot, side,
        moving, push);
    for (int steps = 0; steps < 25 && status == TB_OK && !(done[0] > TB_C(0.0)); steps++) {
        status = tb_zero_wrench_tension_step(structure, side, moving, push, done);
    }
    if (status == TB_OK && !(done[0] > TB_C(0.0))) {
        status = TB_INACCURATE;
    }
    if (status != TB_OK) {
        tension[0] = TB_C(0.0);
        tension[1] = TB_C(0.0);
        tension[2] = TB_C(0.0);
        tension[3] = TB_C(0.0);
        tension[4] = TB_C(0.0);
        return status;
    }
    return tb_zero_wrench_tension_finish(structure, pivot, side, tension);
}

/* Refuses with a status: structure is 0; pivot is 0; side is 0; moving is 0; push is 0 N. */
static tb_status tb_refuse_tension_factor_begin(tb_status status, real_t structure[10],
    real_t pivot[1], real_t side[5], real_t moving[1], real_t push[1])
{
    structure[0] = TB_C(0.0);
    structure[1] = TB_C(0.0);
    structure[2] = TB_C(0.0);
    structure[3] = TB_C(0.0);
    structure[4] = TB_C(0.0);
    structure[5] = TB_C(0.0);
    structure[6] = TB_C(0.0);
    structure[7] = TB_C(0.0);
    structure[8] = TB_C(0.0);
    structure[9] = TB_C(0.0);
    pivot[0] = TB_C(0.0);
    side[0] = TB_C(0.0);
    side[1] = TB_C(0.0);
    side[2] = TB_C(0.0);
    side[3] = TB_C(0.0);
    side[4] = TB_C(0.0);
    moving[0] = TB_C(0.0);
    push[0] = TB_C(0.0);
    return status;
}

/* All cables are free. */
static tb_status tb_tension_factor_begin(const real_t pose[2], const real_t rails[1],
    real_t structure[10], real_t pivot[1], real_t side[5], real_t moving[1], real_t push[1])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0))) {
        return tb_refuse_tension_factor_begin(TB_OUT_OF_DOMAIN, structure, pivot, side, moving, push);
    }
    const real_t t0 = pose[0] * pose[0];
    const real_t t1 = TB_FRAME - pose[1];
    const real_t t2 = t1 * t1;
    const real_t t3 = TB_SQRT(t0 + t2);
    const real_t t4 = TB_C(1.0) / t3;
    const real_t t5 = pose[0] * t4;
    const real_t structure_0 = -t5;
    const real_t t6 = pose[1] * pose[1];
    const real_t t7 = TB_SQRT(t0 + t6);
    const real_t t8 = TB_C(1.0) / t7;
    const real_t t9 = pose[0] * t8;
    const real_t structure_1 = -t9;
    const real_t t10 = TB_FRAME - pose[0];
    const real_t t11 = t10 * t10;
    const real_t t12 = TB_SQRT(t6 + t11);
    const real_t t13 = TB_C(1.0) / t12;
    const real_t structure_2 = t10 * t13;
    const real_t t14 = TB_SQRT(t2 + t11);
    const real_t t15 = TB_C(1.0) / t14;
    const real_t structure_3 = t10 * t15;
    const real_t t16 = TB_BASE_5_X - pose[0];
    const real_t t17 = TB_SQRT(t2 + t16 * t16);
    const real_t t18 = TB_C(1.0) / t17;
    const real_t structure_4 = t16 * t18;
    const real_t structure_5 = t1 * t4;
    const real_t t19 = pose[1] * t8;
    const real_t structure_6 = -t19;
    const real_t t20 = pose[1] * t13;
    const real_t structure_7 = -t20;
    const real_t structure_8 = t1 * t15;
    const real_t structure_9 = t1 * t18;
    const real_t t21 = t5 * t5 + t9 * t9 + structure_2 * structure_2 + structure_3 *
        structure_3;
    const real_t t22 = TB_SQRT(t21 + structure_4 * structure_4);
    const real_t t23 = TB_COPYSIGN(t22, structure_0);
    const real_t t24 = TB_ABS(t23);
    const real_t t25 = structure_5 * (t23 - t5) + t9 * t19 - structure_2 * t20;
    const real_t t26 = t25 + structure_3 * structure_8 + structure_4 * structure_9;
    const real_t t27 = t26 * (TB_C(1.0) / (t22 * (t22 + TB_ABS(t5))));
    const real_t t28 = t9 * t27 - t19;
    const real_t t29 = t20 + structure_2 * t27;
    const real_t t30 = structure_8 - structure_3 * t27;
    const real_t t31 = structure_9 - structure_4 * t27;
    const real_t t32 = TB_SQRT(t28 * t28 + t29 * t29 + t30 * t30 + t31 * t31);
    const real_t t33 = TB_ABS(TB_COPYSIGN(t32, t28));
    const real_t pivot_0 = tb_min(t24, t33);
    const bool t34 = TB_C(0.0001) < t3 && TB_C(0.0001) < t7 && TB_C(0.0001) < t12;
    const bool t35 = !(t34 && TB_C(0.0001) < t14 && TB_C(0.0001) < t17);
    const real_t t36 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const bool t37 = !(t36 < t24 && t36 < t33);
    if (t35 || t37) {
        return tb_refuse_tension_factor_begin(TB_SINGULAR, structure, pivot, side, moving, push);
    }
    structure[0] = structure_0;
    structure[1] = structure_1;
    structure[2] = structure_2;
    structure[3] = structure_3;
    structure[4] = structure_4;
    structure[5] = structure_5;
    structure[6] = structure_6;
    structure[7] = structure_7;
    structure[8] = structure_8;
    structure[9] = structure_9;
    pivot[0] = pivot_0;
    side[0] = TB_C(0.0);
    side[1] = TB_C(0.0);
    side[2] = TB_C(0.0);
    side[3] = TB_C(0.0);
    side[4] = TB_C(0.0);
    moving[0] = -TB_C(1.0);
    push[0] = TB_C(0.0);
    return TB_OK;
}

/* Moves a cable towards its bounds, until it is held or another one is freed. */
static tb_status tb_tension_factor_step(const real_t structure[10], real_t side[5], real_t moving[1],
    real_t push[1], real_t done[1])
{
    const bool t0 = side[0] == TB_C(0.0);
    const real_t t1 = t0 ? TB_C(1.0) : TB_C(0.0);
    const bool t2 = TB_C(0.0) == side[1];
    const real_t t3 = t2 ? TB_C(1.0) : TB_C(0.0);
    const bool t4 = TB_C(0.0) == side[2];
    const real_t t5 = t4 ? TB_C(1.0) : TB_C(0.0);
    const bool t6 = TB_C(0.0) == side[3];
    const real_t t7 = t6 ? TB_C(1.0) : TB_C(0.0);
    const bool t8 = TB_C(0.0) == side[4];
    const real_t t9 = t8 ? TB_C(1.0) : TB_C(0.0);
    const real_t t10 = t0 ? (t0 ? structure[0] * structure[0] : TB_C(0.0)) : TB_C(0.0);
    const real_t t11 = t2 ? (t2 ? structure[1] * structure[1] : TB_C(0.0)) : TB_C(0.0);
    const real_t t12 = t4 ? (t4 ? structure[2] * structure[2] : TB_C(0.0)) : TB_C(0.0);
    const real_t t13 = t6 ? (t6 ? structure[3] * structure[3] : TB_C(0.0)) : TB_C(0.0);
    const real_t t14 = t8 ? (t8 ? structure[4] * structure[4] : TB_C(0.0)) : TB_C(0.0);
    const real_t t15 = TB_SQRT(t10 + t11 + t12 + t13 + t14);
    const real_t t16 = t0 ? structure[0] : TB_C(0.0);
    const real_t t17 = TB_COPYSIGN(t15, t16);
    const real_t t18 = t16 + t17;
    const real_t t19 = t2 ? (t2 ? structure[1] * structure[6] : TB_C(0.0)) : TB_C(0.0);
    const real_t t20 = t4 ? (t4 ? structure[2] * structure[7] : TB_C(0.0)) : TB_C(0.0);
    const real_t t21 = (t0 ? t18 * structure[5] : TB_C(0.0)) + t19 + t20;
    const real_t t22 = t6 ? (t6 ? structure[3] * structure[8] : TB_C(0.0)) : TB_C(0.0);
    const real_t t23 = t8 ? (t8 ? structure[4] * structure[9] : TB_C(0.0)) : TB_C(0.0);
    const real_t t24 = (t21 + t22 + t23) * (TB_C(1.0) / (t15 * (t15 + TB_ABS(t16))));
    const real_t t25 = structure[6] - structure[1] * t24;
    const real_t t26 = structure[7] - structure[2] * t24;
    const real_t t27 = (t2 ? (t2 ? t25 * t25 : TB_C(0.0)) : TB_C(0.0)) + (t4 ? (t4 ? t26 * t26
        : TB_C(0.0)) : TB_C(0.0));
    const real_t t28 = structure[8] - structure[3] * t24;
    const real_t t29 = t27 + (t6 ? (t6 ? t28 * t28 : TB_C(0.0)) : TB_C(0.0));
    const real_t t30 = structure[9] - structure[4] * t24;
    const real_t t31 = t29 + (t8 ? (t8 ? t30 * t30 : TB_C(0.0)) : TB_C(0.0));
    const real_t t32 = TB_COPYSIGN(TB_SQRT(t31), t2 ? t25 : TB_C(0.0));
    const real_t t33 = tb_min(TB_C(1.0), tb_min(TB_ABS(t17), TB_ABS(t32)));
    const real_t t34 = TB_C(1.0) / t33;
    const real_t t35 = TB_C(64.0) * TB_EPSILON * t34;
    const bool t36 = TB_C(0.0) <= moving[0];
    const real_t t37 = TB_C(1.0) / t17;
    const bool t38 = TB_C(0.0) < side[0];
    const bool t39 = TB_C(0.0) < side[1];
    const real_t t40 = (t38 ? structure[0] * TB_TENSION_MAX : TB_C(0.0)) + (t39 ? structure[1]
        * TB_TENSION_MAX : TB_C(0.0));
    const bool t41 = TB_C(0.0) < side[2];
    const real_t t42 = t40 + (t41 ? structure[2] * TB_TENSION_MAX : TB_C(0.0));
    const bool t43 = TB_C(0.0) < side[3];
    const real_t t44 = t42 + (t43 ? structure[3] * TB_TENSION_MAX : TB_C(0.0));
    const bool t45 = TB_C(0.0) < side[4];
    const real_t t46 = t44 + (t45 ? structure[4] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t47 = t46 * t37;
    const real_t t48 = (t0 ? structure[5] : TB_C(0.0)) - t18 * t24;
    const real_t t49 = TB_C(1.0) / t32;
    const real_t t50 = (t38 ? structure[5] * TB_TENSION_MAX : TB_C(0.0)) + (t39 ? structure[6]
        * TB_TENSION_MAX : TB_C(0.0));
    const real_t t51 = t50 + (t41 ? structure[7] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t52 = t51 + (t43 ? structure[8] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t53 = t52 + (t45 ? structure[9] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t54 = t49 * ((t53 + t47 * t48) * t49);
    const real_t t55 = t37 * (t47 + t48 * t54);
    const real_t t56 = structure[3] * t55 + structure[8] * t54;
    const real_t t57 = TB_C(0.0) < t7 ? tb_max(t56, -(TB_TENSION_MAX + t56)) : -TB_C(1.0);
    const real_t t58 = structure[4] * t55 + structure[9] * t54;
    const real_t t59 = TB_C(0.0) < t9 ? tb_max(t58, -(TB_TENSION_MAX + t58)) : -TB_C(1.0);
    const real_t t60 = structure[0] * t55 + structure[5] * t54;
    const real_t t61 = TB_C(0.0) < t1 ? tb_max(t60, -(TB_TENSION_MAX + t60)) : -TB_C(1.0);
    const real_t t62 = structure[1] * t55 + structure[6] * t54;
    const real_t t63 = TB_C(0.0) < t3 ? tb_max(t62, -(TB_TENSION_MAX + t62)) : -TB_C(1.0);
    const real_t t64 = structure[2] * t55 + structure[7] * t54;
    const real_t t65 = TB_C(0.0) < t5 ? tb_max(t64, -(TB_TENSION_MAX + t64)) : -TB_C(1.0);
    real_t t66, t67, t68, t69, t70;
    if (t36) {
        t66 = moving[0] == TB_C(3.0) ? TB_C(1.0) : TB_C(0.0);
        t67 = moving[0] == TB_C(4.0) ? TB_C(1.0) : TB_C(0.0);
        t68 = TB_C(0.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
        t69 = TB_C(1.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
        t70 = TB_C(2.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
    } else {
        t66 = t57;
        t67 = t59;
        t68 = t61;
        t69 = t63;
        t70 = t65;
    }
    const real_t t71 = tb_max(t68, t69);
    const bool t72 = tb_max(t66, t67) <= tb_max(t71, t70);
    real_t t73, t74, t75, t76;
    if (t72) {
        const bool t77 = t70 <= t71;
        real_t t78, t79, t80, t81;
        if (t77) {
            const bool t82 = t69 <= t68;
            t78 = t82 ? TB_C(0.0) : TB_C(1.0);
            t79 = t82 ? structure[0] : structure[1];
            t80 = t82 ? structure[5] : structure[6];
            t81 = t82 ? -t60 : -t62;
        } else {
            t78 = TB_C(2.0);
            t79 = structure[2];
            t80 = structure[7];
            t81 = -t64;
        }
        t73 = t78;
        t74 = t79;
        t75 = t80;
        t76 = t81;
    } else {
        const bool t83 = t67 <= t66;
        t73 = t83 ? TB_C(3.0) : TB_C(4.0);
        t74 = t83 ? structure[3] : structure[4];
        t75 = t83 ? structure[8] : structure[9];
        t76 = t83 ? -t56 : -t58;
    }
    const real_t t84 = t37 * t74;
    const real_t t85 = t49 * (t49 * (t75 + t48 * t84));
    const real_t t86 = t37 * (t84 + t48 * t85);
    const real_t t87 = structure[0] * t86 + structure[5] * t85;
    const real_t t88 = (TB_C(0.0) == t73 ? TB_C(1.0) : TB_C(0.0)) - t87;
    const real_t t89 = structure[1] * t86 + structure[6] * t85;
    const real_t t90 = (TB_C(1.0) == t73 ? TB_C(1.0) : TB_C(0.0)) - t89;
    const real_t t91 = (t0 ? (t0 ? t88 * t88 : TB_C(0.0)) : TB_C(0.0)) + (t2 ? (t2 ? t90 * t90
        : TB_C(0.0)) : TB_C(0.0));
    const real_t t92 = structure[2] * t86 + structure[7] * t85;
    const real_t t93 = (TB_C(2.0) == t73 ? TB_C(1.0) : TB_C(0.0)) - t92;
    const real_t t94 = t91 + (t4 ? (t4 ? t93 * t93 : TB_C(0.0)) : TB_C(0.0));
    const real_t t95 = structure[3] * t86 + structure[8] * t85;
    const real_t t96 = (TB_C(3.0) == t73 ? TB_C(1.0) : TB_C(0.0)) - t95;
    const real_t t97 = t94 + (t6 ? (t6 ? t96 * t96 : TB_C(0.0)) : TB_C(0.0));
    const real_t t98 = structure[4] * t86 + structure[9] * t85;
    const real_t t99 = (TB_C(4.0) == t73 ? TB_C(1.0) : TB_C(0.0)) - t98;
    const real_t t100 = t97 + (t8 ? (t8 ? t99 * t99 : TB_C(0.0)) : TB_C(0.0));
    const bool t101 = TB_C(2.0) < t1 + t3 + t5 + t7 + t9 && t35 * t35 < t100;
    const real_t t102 = t76 + t100 * push[0];
    const bool t103 = t102 < TB_C(5.0);
    real_t t104;
    if (t101) {
        const real_t t105 = tb_max(t103 ? -t102 : t102 - TB_TENSION_MAX, TB_C(0.0));
        t104 = t105 * (TB_C(1.0) / t100);
    } else {
        t104 = TB_C(1e+30);
    }
    const real_t t106 = t103 ? TB_C(1.0) : -TB_C(1.0);
    const real_t t107 = side[0] * (t87 * t106);
    real_t t108;
    if (t35 < t107) {
        const real_t t109 = t60 + t87 * push[0] + (t38 ? TB_TENSION_MAX : TB_C(0.0));
        t108 = tb_max(-(side[0] * t109), TB_C(0.0)) / t107;
    } else {
        t108 = TB_C(1e+30);
    }
    const real_t t110 = side[1] * (t89 * t106);
    real_t t111;
    if (t35 < t110) {
        const real_t t112 = t62 + t89 * push[0] + (t39 ? TB_TENSION_MAX : TB_C(0.0));
        t111 = tb_max(-(side[1] * t112), TB_C(0.0)) / t110;
    } else {
        t111 = TB_C(1e+30);
    }
    const real_t t113 = side[2] * (t92 * t106);
    real_t t114;
    if (t35 < t113) {
        const real_t t115 = t64 + t92 * push[0] + (t41 ? TB_TENSION_MAX : TB_C(0.0));
        t114 = tb_max(-(side[2] * t115), TB_C(0.0)) / t113;
    } else {
        t114 = TB_C(1e+30);
    }
    const real_t t116 = side[3] * (t95 * t106);
    real_t t117;
    if (t35 < t116) {
        const real_t t118 = t56 + t95 * push[0] + (t43 ? TB_TENSION_MAX : TB_C(0.0));
        t117 = tb_max(-(side[3] * t118), TB_C(0.0)) / t116;
    } else {
        t117 = TB_C(1e+30);
    }
    const real_t t119 = side[4] * (t98 * t106);
    real_t t120;
    if (t35 < t119) {
        const real_t t121 = t58 + t98 * push[0] + (t45 ? TB_TENSION_MAX : TB_C(0.0));
        t120 = tb_max(-(side[4] * t121), TB_C(0.0)) / t119;
    } else {
        t120 = TB_C(1e+30);
    }
    const real_t t122 = tb_min(tb_min(tb_min(tb_min(t108, t111), t114), t117), t120);
    const bool t123 = t104 <= t122;
    const real_t t124 = tb_max(tb_max(tb_max(tb_max(t61, t63), t65), t57), t59);
    const bool t125 = (!t36 && t124 <= t34 * (TB_EPSILON * TB_C(80.0))) || !(tb_min(t104, t122)
        < TB_C(1e+30));
    const real_t t126 = t123 && !t125 ? t73 : -TB_C(1.0);
    const real_t t127 = -t106;
    real_t t128;
    if (t123 || t125) {
        t128 = -TB_C(1.0);
    } else {
        const real_t t129 = -t117;
        const real_t t130 = -t120;
        const real_t t131 = -t108;
        const real_t t132 = -t111;
        const real_t t133 = tb_max(t131, t132);
        const real_t t134 = -t114;
        real_t t135;
        if (tb_max(t129, t130) <= tb_max(t133, t134)) {
            const real_t t136 = t134 <= t133 ? (t132 <= t131 ? TB_C(0.0) : TB_C(1.0)) :
                TB_C(2.0);
            t135 = t136;
        } else {
            t135 = t130 <= t129 ? TB_C(3.0) : TB_C(4.0);
        }
        t128 = t135;
    }
    const real_t side_0 = TB_C(0.0) == t126 ? t127 : (TB_C(0.0) == t128 ? TB_C(0.0) : side[0]);
    const real_t side_1 = TB_C(1.0) == t126 ? t127 : (TB_C(1.0) == t128 ? TB_C(0.0) : side[1]);
    const real_t side_2 = TB_C(2.0) == t126 ? t127 : (TB_C(2.0) == t128 ? TB_C(0.0) : side[2]);
    const real_t side_3 = TB_C(3.0) == t126 ? t127 : (TB_C(3.0) == t128 ? TB_C(0.0) : side[3]);
    const real_t side_4 = TB_C(4.0) == t126 ? t127 : (TB_C(4.0) == t128 ? TB_C(0.0) : side[4]);
    const real_t moving_0 = t123 ? -TB_C(1.0) : t73;
    const real_t push_0 = t123 ? TB_C(0.0) : push[0] + t106 * t122;
    const real_t done_0 = t125 ? TB_C(1.0) : TB_C(0.0);
    side[0] = side_0;
    side[1] = side_1;
    side[2] = side_2;
    side[3] = side_3;
    side[4] = side_4;
    moving[0] = moving_0;
    push[0] = push_0;
    done[0] = done_0;
    return TB_OK;
}

/* The tensions, refined and judged. */
static tb_status tb_tension_factor_finish(const real_t structure[10], const real_t pivot[1],
    const real_t side[5], real_t factor[1])
{
    (void)pivot;
    const real_t t0 = structure[0] * structure[6] - structure[5] * structure[1];
    const real_t t1 = TB_ABS(t0);
    const real_t t2 = structure[0] * structure[7] - structure[5] * structure[2];
    const real_t t3 = TB_ABS(t2);
    const real_t t4 = structure[0] * structure[8] - structure[5] * structure[3];
    const real_t t5 = TB_ABS(t4);
    const real_t t6 = structure[0] * structure[9] - structure[5] * structure[4];
    const real_t t7 = TB_ABS(t6);
    const real_t t8 = structure[8] + (structure[7] + (structure[6] + structure[5]));
    const real_t t9 = TB_C(5.0) * (structure[9] + t8);
    const real_t t10 = structure[3] + (structure[2] + (structure[0] + structure[1]));
    const real_t t11 = TB_C(5.0) * (structure[4] + t10);
    const real_t t12 = TB_C(5.0) * (t1 + t3 + t5 + t7) - TB_ABS(structure[0] * t9 -
        structure[5] * t11);
    const real_t t13 = structure[1] * structure[7] - structure[6] * structure[2];
    const real_t t14 = TB_ABS(t13);
    const real_t t15 = structure[1] * structure[8] - structure[6] * structure[3];
    const real_t t16 = TB_ABS(t15);
    const real_t t17 = structure[1] * structure[9] - structure[6] * structure[4];
    const real_t t18 = TB_ABS(t17);
    const real_t t19 = TB_C(5.0) * (t1 + t14 + t16 + t18) - TB_ABS(structure[1] * t9 -
        structure[6] * t11);
    const real_t t20 = structure[2] * structure[8] - structure[7] * structure[3];
    const real_t t21 = TB_ABS(t20);
    const real_t t22 = structure[2] * structure[9] - structure[7] * structure[4];
    const real_t t23 = TB_ABS(t22);
    const real_t t24 = TB_C(5.0) * (t3 + t14 + t21 + t23) - TB_ABS(structure[2] * t9 -
        structure[7] * t11);
    const real_t t25 = structure[3] * structure[9] - structure[8] * structure[4];
    const real_t t26 = TB_ABS(t25);
    const real_t t27 = TB_C(5.0) * (t21 + (t5 + t16) + t26) - TB_ABS(structure[3] * t9 -
        structure[8] * t11);
    const real_t t28 = TB_C(5.0) * (t26 + (t23 + (t7 + t18))) - TB_ABS(structure[4] * t9 -
        structure[9] * t11);
    const real_t t29 = tb_min(tb_min(tb_min(tb_min(t12, t19), t24), t27), t28);
    const bool t30 = TB_C(0.0) <= t29;
    const bool t31 = TB_C(0.0) == side[0];
    const bool t32 = TB_C(0.0) < side[0];
    const bool t33 = TB_C(0.0) < side[1];
    const real_t t34 = (t32 ? structure[0] * TB_TENSION_MAX : TB_C(0.0)) + (t33 ? structure[1]
        * TB_TENSION_MAX : TB_C(0.0));
    const bool t35 = TB_C(0.0) < side[2];
    const real_t t36 = t34 + (t35 ? structure[2] * TB_TENSION_MAX : TB_C(0.0));
    const bool t37 = TB_C(0.0) < side[3];
    const real_t t38 = t36 + (t37 ? structure[3] * TB_TENSION_MAX : TB_C(0.0));
    const bool t39 = TB_C(0.0) < side[4];
    const real_t t40 = t38 + (t39 ? structure[4] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t41 = t31 ? (t31 ? structure[0] * structure[0] : TB_C(0.0)) : TB_C(0.0);
    const bool t42 = TB_C(0.0) == side[1];
    const real_t t43 = t42 ? (t42 ? structure[1] * structure[1] : TB_C(0.0)) : TB_C(0.0);
    const bool t44 = TB_C(0.0) == side[2];
    const real_t t45 = t44 ? (t44 ? structure[2] * structure[2] : TB_C(0.0)) : TB_C(0.0);
    const bool t46 = TB_C(0.0) == side[3];
    const real_t t47 = t46 ? (t46 ? structure[3] * structure[3] : TB_C(0.0)) : TB_C(0.0);
    const bool t48 = TB_C(0.0) == side[4];
    const real_t t49 = t48 ? (t48 ? structure[4] * structure[4] : TB_C(0.0)) : TB_C(0.0);
    const real_t t50 = TB_SQRT(t41 + t43 + t45 + t47 + t49);
    const real_t t51 = t31 ? structure[0] : TB_C(0.0);
    const real_t t52 = TB_COPYSIGN(t50, t51);
    const real_t t53 = TB_C(1.0) / t52;
    const real_t t54 = t40 * t53;
    const real_t t55 = t51 + t52;
    const real_t t56 = t42 ? (t42 ? structure[6] * structure[1] : TB_C(0.0)) : TB_C(0.0);
    const real_t t57 = t44 ? (t44 ? structure[7] * structure[2] : TB_C(0.0)) : TB_C(0.0);
    const real_t t58 = (t31 ? structure[5] * t55 : TB_C(0.0)) + t56 + t57;
    const real_t t59 = t46 ? (t46 ? structure[8] * structure[3] : TB_C(0.0)) : TB_C(0.0);
    const real_t t60 = t48 ? (t48 ? structure[9] * structure[4] : TB_C(0.0)) : TB_C(0.0);
    const real_t t61 = (t58 + t59 + t60) * (TB_C(1.0) / (t50 * (t50 + TB_ABS(t51))));
    const real_t t62 = (t31 ? structure[5] : TB_C(0.0)) - t55 * t61;
    const real_t t63 = (t32 ? structure[5] * TB_TENSION_MAX : TB_C(0.0)) + (t33 ? structure[6]
        * TB_TENSION_MAX : TB_C(0.0));
    const real_t t64 = t63 + (t35 ? structure[7] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t65 = t64 + (t37 ? structure[8] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t66 = t65 + (t39 ? structure[9] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t67 = structure[6] - structure[1] * t61;
    const real_t t68 = structure[7] - structure[2] * t61;
    const real_t t69 = (t42 ? (t42 ? t67 * t67 : TB_C(0.0)) : TB_C(0.0)) + (t44 ? (t44 ? t68 *
        t68 : TB_C(0.0)) : TB_C(0.0));
    const real_t t70 = structure[8] - structure[3] * t61;
    const real_t t71 = t69 + (t46 ? (t46 ? t70 * t70 : TB_C(0.0)) : TB_C(0.0));
    const real_t t72 = structure[9] - structure[4] * t61;
    const real_t t73 = t71 + (t48 ? (t48 ? t72 * t72 : TB_C(0.0)) : TB_C(0.0));
    const real_t t74 = TB_C(1.0) / TB_COPYSIGN(TB_SQRT(t73), t42 ? t67 : TB_C(0.0));
    const real_t t75 = t74 * ((t66 + t54 * t62) * t74);
    const real_t t76 = t53 * (t54 + t62 * t75);
    const real_t t77 = structure[0] * t76 + structure[5] * t75;
    const real_t t78 = structure[1] * t76 + structure[6] * t75;
    const real_t t79 = (t31 ? -(structure[0] * t77) : TB_C(0.0)) + (t42 ? -(structure[1] * t78)
        : TB_C(0.0));
    const real_t t80 = structure[2] * t76 + structure[7] * t75;
    const real_t t81 = structure[3] * t76 + structure[8] * t75;
    const real_t t82 = t79 + (t44 ? -(structure[2] * t80) : TB_C(0.0)) + (t46 ? -(structure[3]
        * t81) : TB_C(0.0));
    const real_t t83 = structure[4] * t76 + structure[9] * t75;
    const real_t t84 = t40 + (t82 + (t48 ? -(structure[4] * t83) : TB_C(0.0)));
    const real_t t85 = t53 * t84;
    const real_t t86 = (t31 ? -(structure[5] * t77) : TB_C(0.0)) + (t42 ? -(structure[6] * t78)
        : TB_C(0.0));
    const real_t t87 = t86 + (t44 ? -(structure[7] * t80) : TB_C(0.0)) + (t46 ? -(structure[8]
        * t81) : TB_C(0.0));
    const real_t t88 = t66 + (t87 + (t48 ? -(structure[9] * t83) : TB_C(0.0)));
    const real_t t89 = t74 * (t74 * (t88 + t62 * t85));
    const real_t t90 = t53 * (t85 + t62 * t89);
    const real_t t91 = -(t77 + (structure[0] * t90 + structure[5] * t89));
    const real_t t92 = tb_max(t31 ? t91 : (t32 ? TB_TENSION_MAX : TB_C(0.0)), TB_C(0.0));
    const real_t t93 = tb_min(t92, TB_TENSION_MAX);
    const real_t t94 = -(t78 + (structure[1] * t90 + structure[6] * t89));
    const real_t t95 = tb_max(t42 ? t94 : (t33 ? TB_TENSION_MAX : TB_C(0.0)), TB_C(0.0));
    const real_t t96 = tb_min(t95, TB_TENSION_MAX);
    const real_t t97 = -(t80 + (structure[2] * t90 + structure[7] * t89));
    const real_t t98 = tb_max(t44 ? t97 : (t35 ? TB_TENSION_MAX : TB_C(0.0)), TB_C(0.0));
    const real_t t99 = tb_min(t98, TB_TENSION_MAX);
    const real_t t100 = -(t81 + (structure[3] * t90 + structure[8] * t89));
    const real_t t101 = tb_max(t46 ? t100 : (t37 ? TB_TENSION_MAX : TB_C(0.0)), TB_C(0.0));
    const real_t t102 = tb_min(t101, TB_TENSION_MAX);
    const real_t t103 = -(t83 + (structure[4] * t90 + structure[9] * t89));
    const real_t t104 = tb_max(t48 ? t103 : (t39 ? TB_TENSION_MAX : TB_C(0.0)), TB_C(0.0));
    const real_t t105 = tb_min(t104, TB_TENSION_MAX);
    const real_t t106 = tb_max(tb_max(tb_max(tb_max(t93, t96), t99), t102), t105);
    real_t factor_0;
    if (t30) {
        const real_t t107 = tb_min(tb_min(tb_min(tb_min(t93, t96), t99), t102), t105);
        factor_0 = t107 / t106;
    } else {
        factor_0 = TB_C(0.0);
    }
    const bool t108 = !(TB_C(0.0) < t106);
    const bool t109 = !t30;
    if (t108) {
        factor[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    factor[0] = factor_0;
    return t109 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_tension_factor(const real_t pose[2], const real_t rails[1], real_t factor[1])
{
    real_t structure[10];
    real_t pivot[1];
    real_t side[5];
    real_t moving[1];
    real_t push[1];
    real_t done[1] = {TB_C(0.0)};
    tb_status status = tb_tension_factor_begin(pose, rails, structure, pivot, side, moving,
        push);
    for (int steps = 0; steps < 25 && status == TB_OK && !(done[0] > TB_C(0.0)); steps++) {
        status = tb_tension_factor_step(structure, side, moving, push, done);
    }
    if (status == TB_OK && !(done[0] > TB_C(0.0))) {
        status = TB_INACCURATE;
    }
    if (status != TB_OK) {
        factor[0] = TB_C(0.0);
        return status;
    }
    return tb_tension_factor_finish(structure, pivot, side, factor);
}

/* Refuses with a status: structure is 0; pivot is 0; side is 0; moving is 0; push is 0 N. */
static tb_status tb_refuse_isotropic_force_eq17_begin(tb_status status, real_t structure[10],
    real_t pivot[1], real_t side[5], real_t moving[1], real_t push[1])
{
    structure[0] = TB_C(0.0);
    structure[1] = TB_C(0.0);
    structure[2] = TB_C(0.0);
    structure[3] = TB_C(0.0);
    structure[4] = TB_C(0.0);
    structure[5] = TB_C(0.0);
    structure[6] = TB_C(0.0);
    structure[7] = TB_C(0.0);
    structure[8] = TB_C(0.0);
    structure[9] = TB_C(0.0);
    pivot[0] = TB_C(0.0);
    side[0] = TB_C(0.0);
    side[1] = TB_C(0.0);
    side[2] = TB_C(0.0);
    side[3] = TB_C(0.0);
    side[4] = TB_C(0.0);
    moving[0] = TB_C(0.0);
    push[0] = TB_C(0.0);
    return status;
}

/* All cables are free. */
static tb_status tb_isotropic_force_eq17_begin(const real_t pose[2], const real_t rails[1],
    real_t structure[10], real_t pivot[1], real_t side[5], real_t moving[1], real_t push[1])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0))) {
        return tb_refuse_isotropic_force_eq17_begin(TB_OUT_OF_DOMAIN, structure, pivot, side, moving, push);
    }
    const real_t t0 = pose[0] * pose[0];
    const real_t t1 = TB_FRAME - pose[1];
    const real_t t2 = t1 * t1;
    const real_t t3 = TB_SQRT(t0 + t2);
    const real_t t4 = TB_C(1.0) / t3;
    const real_t t5 = pose[0] * t4;
    const real_t structure_0 = -t5;
    const real_t t6 = pose[1] * pose[1];
    const real_t t7 = TB_SQRT(t0 + t6);
    const real_t t8 = TB_C(1.0) / t7;
    const real_t t9 = pose[0] * t8;
    const real_t structure_1 = -t9;
    const real_t t10 = TB_FRAME - pose[0];
    const real_t t11 = t10 * t10;
    const real_t t12 = TB_SQRT(t6 + t11);
    const real_t t13 = TB_C(1.0) / t12;
    const real_t structure_2 = t10 * t13;
    const real_t t14 = TB_SQRT(t2 + t11);
    const real_t t15 = TB_C(1.0) / t14;
    const real_t structure_3 = t10 * t15;
    const real_t t16 = TB_BASE_5_X - pose[0];
    const real_t t17 = TB_SQRT(t2 + t16 * t16);
    const real_t t18 = TB_C(1.0) / t17;
    const real_t structure_4 = t16 * t18;
    const real_t structure_5 = t1 * t4;
    const real_t t19 = pose[1] * t8;
    const real_t structure_6 = -t19;
    const real_t t20 = pose[1] * t13;
    const real_t structure_7 = -t20;
    const real_t structure_8 = t1 * t15;
    const real_t structure_9 = t1 * t18;
    const real_t t21 = t5 * t5 + t9 * t9 + structure_2 * structure_2 + structure_3 *
        structure_3;
    const real_t t22 = TB_SQRT(t21 + structure_4 * structure_4);
    const real_t t23 = TB_COPYSIGN(t22, structure_0);
    const real_t t24 = TB_ABS(t23);
    const real_t t25 = structure_5 * (t23 - t5) + t9 * t19 - structure_2 * t20;
    const real_t t26 = t25 + structure_3 * structure_8 + structure_4 * structure_9;
    const real_t t27 = t26 * (TB_C(1.0) / (t22 * (t22 + TB_ABS(t5))));
    const real_t t28 = t9 * t27 - t19;
    const real_t t29 = t20 + structure_2 * t27;
    const real_t t30 = structure_8 - structure_3 * t27;
    const real_t t31 = structure_9 - structure_4 * t27;
    const real_t t32 = TB_SQRT(t28 * t28 + t29 * t29 + t30 * t30 + t31 * t31);
    const real_t t33 = TB_ABS(TB_COPYSIGN(t32, t28));
    const real_t pivot_0 = tb_min(t24, t33);
    const bool t34 = TB_C(0.0001) < t3 && TB_C(0.0001) < t7 && TB_C(0.0001) < t12;
    const bool t35 = !(t34 && TB_C(0.0001) < t14 && TB_C(0.0001) < t17);
    const real_t t36 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const bool t37 = !(t36 < t24 && t36 < t33);
    if (t35 || t37) {
        return tb_refuse_isotropic_force_eq17_begin(TB_SINGULAR, structure, pivot, side, moving, push);
    }
    structure[0] = structure_0;
    structure[1] = structure_1;
    structure[2] = structure_2;
    structure[3] = structure_3;
    structure[4] = structure_4;
    structure[5] = structure_5;
    structure[6] = structure_6;
    structure[7] = structure_7;
    structure[8] = structure_8;
    structure[9] = structure_9;
    pivot[0] = pivot_0;
    side[0] = TB_C(0.0);
    side[1] = TB_C(0.0);
    side[2] = TB_C(0.0);
    side[3] = TB_C(0.0);
    side[4] = TB_C(0.0);
    moving[0] = -TB_C(1.0);
    push[0] = TB_C(0.0);
    return TB_OK;
}

/* Moves a cable towards its bounds, until it is held or another one is freed. */
static tb_status tb_isotropic_force_eq17_step(const real_t structure[10], real_t side[5],
    real_t moving[1], real_t push[1], real_t done[1])
{
    const bool t0 = side[0] == TB_C(0.0);
    const real_t t1 = t0 ? TB_C(1.0) : TB_C(0.0);
    const bool t2 = TB_C(0.0) == side[1];
    const real_t t3 = t2 ? TB_C(1.0) : TB_C(0.0);
    const bool t4 = TB_C(0.0) == side[2];
    const real_t t5 = t4 ? TB_C(1.0) : TB_C(0.0);
    const bool t6 = TB_C(0.0) == side[3];
    const real_t t7 = t6 ? TB_C(1.0) : TB_C(0.0);
    const bool t8 = TB_C(0.0) == side[4];
    const real_t t9 = t8 ? TB_C(1.0) : TB_C(0.0);
    const real_t t10 = t0 ? (t0 ? structure[0] * structure[0] : TB_C(0.0)) : TB_C(0.0);
    const real_t t11 = t2 ? (t2 ? structure[1] * structure[1] : TB_C(0.0)) : TB_C(0.0);
    const real_t t12 = t4 ? (t4 ? structure[2] * structure[2] : TB_C(0.0)) : TB_C(0.0);
    const real_t t13 = t6 ? (t6 ? structure[3] * structure[3] : TB_C(0.0)) : TB_C(0.0);
    const real_t t14 = t8 ? (t8 ? structure[4] * structure[4] : TB_C(0.0)) : TB_C(0.0);
    const real_t t15 = TB_SQRT(t10 + t11 + t12 + t13 + t14);
    const real_t t16 = t0 ? structure[0] : TB_C(0.0);
    const real_t t17 = TB_COPYSIGN(t15, t16);
    const real_t t18 = t16 + t17;
    const real_t t19 = t2 ? (t2 ? structure[1] * structure[6] : TB_C(0.0)) : TB_C(0.0);
    const real_t t20 = t4 ? (t4 ? structure[2] * structure[7] : TB_C(0.0)) : TB_C(0.0);
    const real_t t21 = (t0 ? t18 * structure[5] : TB_C(0.0)) + t19 + t20;
    const real_t t22 = t6 ? (t6 ? structure[3] * structure[8] : TB_C(0.0)) : TB_C(0.0);
    const real_t t23 = t8 ? (t8 ? structure[4] * structure[9] : TB_C(0.0)) : TB_C(0.0);
    const real_t t24 = (t21 + t22 + t23) * (TB_C(1.0) / (t15 * (t15 + TB_ABS(t16))));
    const real_t t25 = structure[6] - structure[1] * t24;
    const real_t t26 = structure[7] - structure[2] * t24;
    const real_t t27 = (t2 ? (t2 ? t25 * t25 : TB_C(0.0)) : TB_C(0.0)) + (t4 ? (t4 ? t26 * t26
        : TB_C(0.0)) : TB_C(0.0));
    const real_t t28 = structure[8] - structure[3] * t24;
    const real_t t29 = t27 + (t6 ? (t6 ? t28 * t28 : TB_C(0.0)) : TB_C(0.0));
    const real_t t30 = structure[9] - structure[4] * t24;
    const real_t t31 = t29 + (t8 ? (t8 ? t30 * t30 : TB_C(0.0)) : TB_C(0.0));
    const real_t t32 = TB_COPYSIGN(TB_SQRT(t31), t2 ? t25 : TB_C(0.0));
    const real_t t33 = tb_min(TB_C(1.0), tb_min(TB_ABS(t17), TB_ABS(t32)));
    const real_t t34 = TB_C(1.0) / t33;
    const real_t t35 = TB_C(64.0) * TB_EPSILON * t34;
    const bool t36 = TB_C(0.0) <= moving[0];
    const real_t t37 = TB_C(1.0) / t17;
    const bool t38 = TB_C(0.0) < side[0];
    const bool t39 = TB_C(0.0) < side[1];
    const real_t t40 = (t38 ? structure[0] * TB_TENSION_MAX : TB_C(0.0)) + (t39 ? structure[1]
        * TB_TENSION_MAX : TB_C(0.0));
    const bool t41 = TB_C(0.0) < side[2];
    const real_t t42 = t40 + (t41 ? structure[2] * TB_TENSION_MAX : TB_C(0.0));
    const bool t43 = TB_C(0.0) < side[3];
    const real_t t44 = t42 + (t43 ? structure[3] * TB_TENSION_MAX : TB_C(0.0));
    const bool t45 = TB_C(0.0) < side[4];
    const real_t t46 = t44 + (t45 ? structure[4] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t47 = t46 * t37;
    const real_t t48 = (t0 ? structure[5] : TB_C(0.0)) - t18 * t24;
    const real_t t49 = TB_C(1.0) / t32;
    const real_t t50 = (t38 ? structure[5] * TB_TENSION_MAX : TB_C(0.0)) + (t39 ? structure[6]
        * TB_TENSION_MAX : TB_C(0.0));
    const real_t t51 = t50 + (t41 ? structure[7] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t52 = t51 + (t43 ? structure[8] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t53 = t52 + (t45 ? structure[9] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t54 = t49 * ((t53 + t47 * t48) * t49);
    const real_t t55 = t37 * (t47 + t48 * t54);
    const real_t t56 = structure[3] * t55 + structure[8] * t54;
    const real_t t57 = TB_C(0.0) < t7 ? tb_max(t56, -(TB_TENSION_MAX + t56)) : -TB_C(1.0);
    const real_t t58 = structure[4] * t55 + structure[9] * t54;
    const real_t t59 = TB_C(0.0) < t9 ? tb_max(t58, -(TB_TENSION_MAX + t58)) : -TB_C(1.0);
    const real_t t60 = structure[0] * t55 + structure[5] * t54;
    const real_t t61 = TB_C(0.0) < t1 ? tb_max(t60, -(TB_TENSION_MAX + t60)) : -TB_C(1.0);
    const real_t t62 = structure[1] * t55 + structure[6] * t54;
    const real_t t63 = TB_C(0.0) < t3 ? tb_max(t62, -(TB_TENSION_MAX + t62)) : -TB_C(1.0);
    const real_t t64 = structure[2] * t55 + structure[7] * t54;
    const real_t t65 = TB_C(0.0) < t5 ? tb_max(t64, -(TB_TENSION_MAX + t64)) : -TB_C(1.0);
    real_t t66, t67, t68, t69, t70;
    if (t36) {
        t66 = moving[0] == TB_C(3.0) ? TB_C(1.0) : TB_C(0.0);
        t67 = moving[0] == TB_C(4.0) ? TB_C(1.0) : TB_C(0.0);
        t68 = TB_C(0.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
        t69 = TB_C(1.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
        t70 = TB_C(2.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
    } else {
        t66 = t57;
        t67 = t59;
        t68 = t61;
        t69 = t63;
        t70 = t65;
    }
    const real_t t71 = tb_max(t68, t69);
    const bool t72 = tb_max(t66, t67) <= tb_max(t71, t70);
    real_t t73, t74, t75, t76;
    if (t72) {
        const bool t77 = t70 <= t71;
        real_t t78, t79, t80, t81;
        if (t77) {
            const bool t82 = t69 <= t68;
            t78 = t82 ? TB_C(0.0) : TB_C(1.0);
            t79 = t82 ? structure[0] : structure[1];
            t80 = t82 ? structure[5] : structure[6];
            t81 = t82 ? -t60 : -t62;
        } else {
            t78 = TB_C(2.0);
            t79 = structure[2];
            t80 = structure[7];
            t81 = -t64;
        }
        t73 = t78;
        t74 = t79;
        t75 = t80;
        t76 = t81;
    } else {
        const bool t83 = t67 <= t66;
        t73 = t83 ? TB_C(3.0) : TB_C(4.0);
        t74 = t83 ? structure[3] : structure[4];
        t75 = t83 ? structure[8] : structure[9];
        t76 = t83 ? -t56 : -t58;
    }
    const real_t t84 = t37 * t74;
    const real_t t85 = t49 * (t49 * (t75 + t48 * t84));
    const real_t t86 = t37 * (t84 + t48 * t85);
    const real_t t87 = structure[0] * t86 + structure[5] * t85;
    const real_t t88 = (TB_C(0.0) == t73 ? TB_C(1.0) : TB_C(0.0)) - t87;
    const real_t t89 = structure[1] * t86 + structure[6] * t85;
    const real_t t90 = (TB_C(1.0) == t73 ? TB_C(1.0) : TB_C(0.0)) - t89;
    const real_t t91 = (t0 ? (t0 ? t88 * t88 : TB_C(0.0)) : TB_C(0.0)) + (t2 ? (t2 ? t90 * t90
        : TB_C(0.0)) : TB_C(0.0));
    const real_t t92 = structure[2] * t86 + structure[7] * t85;
    const real_t t93 = (TB_C(2.0) == t73 ? TB_C(1.0) : TB_C(0.0)) - t92;
    const real_t t94 = t91 + (t4 ? (t4 ? t93 * t93 : TB_C(0.0)) : TB_C(0.0));
    const real_t t95 = structure[3] * t86 + structure[8] * t85;
    const real_t t96 = (TB_C(3.0) == t73 ? TB_C(1.0) : TB_C(0.0)) - t95;
    const real_t t97 = t94 + (t6 ? (t6 ? t96 * t96 : TB_C(0.0)) : TB_C(0.0));
    const real_t t98 = structure[4] * t86 + structure[9] * t85;
    const real_t t99 = (TB_C(4.0) == t73 ? TB_C(1.0) : TB_C(0.0)) - t98;
    const real_t t100 = t97 + (t8 ? (t8 ? t99 * t99 : TB_C(0.0)) : TB_C(0.0));
    const bool t101 = TB_C(2.0) < t1 + t3 + t5 + t7 + t9 && t35 * t35 < t100;
    const real_t t102 = t76 + t100 * push[0];
    const bool t103 = t102 < TB_C(5.0);
    real_t t104;
    if (t101) {
        const real_t t105 = tb_max(t103 ? -t102 : t102 - TB_TENSION_MAX, TB_C(0.0));
        t104 = t105 * (TB_C(1.0) / t100);
    } else {
        t104 = TB_C(1e+30);
    }
    const real_t t106 = t103 ? TB_C(1.0) : -TB_C(1.0);
    const real_t t107 = side[0] * (t87 * t106);
    real_t t108;
    if (t35 < t107) {
        const real_t t109 = t60 + t87 * push[0] + (t38 ? TB_TENSION_MAX : TB_C(0.0));
        t108 = tb_max(-(side[0] * t109), TB_C(0.0)) / t107;
    } else {
        t108 = TB_C(1e+30);
    }
    const real_t t110 = side[1] * (t89 * t106);
    real_t t111;
    if (t35 < t110) {
        const real_t t112 = t62 + t89 * push[0] + (t39 ? TB_TENSION_MAX : TB_C(0.0));
        t111 = tb_max(-(side[1] * t112), TB_C(0.0)) / t110;
    } else {
        t111 = TB_C(1e+30);
    }
    const real_t t113 = side[2] * (t92 * t106);
    real_t t114;
    if (t35 < t113) {
        const real_t t115 = t64 + t92 * push[0] + (t41 ? TB_TENSION_MAX : TB_C(0.0));
        t114 = tb_max(-(side[2] * t115), TB_C(0.0)) / t113;
    } else {
        t114 = TB_C(1e+30);
    }
    const real_t t116 = side[3] * (t95 * t106);
    real_t t117;
    if (t35 < t116) {
        const real_t t118 = t56 + t95 * push[0] + (t43 ? TB_TENSION_MAX : TB_C(0.0));
        t117 = tb_max(-(side[3] * t118), TB_C(0.0)) / t116;
    } else {
        t117 = TB_C(1e+30);
    }
    const real_t t119 = side[4] * (t98 * t106);
    real_t t120;
    if (t35 < t119) {
        const real_t t121 = t58 + t98 * push[0] + (t45 ? TB_TENSION_MAX : TB_C(0.0));
        t120 = tb_max(-(side[4] * t121), TB_C(0.0)) / t119;
    } else {
        t120 = TB_C(1e+30);
    }
    const real_t t122 = tb_min(tb_min(tb_min(tb_min(t108, t111), t114), t117), t120);
    const bool t123 = t104 <= t122;
    const real_t t124 = tb_max(tb_max(tb_max(tb_max(t61, t63), t65), t57), t59);
    const bool t125 = (!t36 && t124 <= t34 * (TB_EPSILON * TB_C(80.0))) || !(tb_min(t104, t122)
        < TB_C(1e+30));
    const real_t t126 = t123 && !t125 ? t73 : -TB_C(1.0);
    const real_t t127 = -t106;
    real_t t128;
    if (t123 || t125) {
        t128 = -TB_C(1.0);
    } else {
        const real_t t129 = -t117;
        const real_t t130 = -t120;
        const real_t t131 = -t108;
        const real_t t132 = -t111;
        const real_t t133 = tb_max(t131, t132);
        const real_t t134 = -t114;
        real_t t135;
        if (tb_max(t129, t130) <= tb_max(t133, t134)) {
            const real_t t136 = t134 <= t133 ? (t132 <= t131 ? TB_C(0.0) : TB_C(1.0)) :
                TB_C(2.0);
            t135 = t136;
        } else {
            t135 = t130 <= t129 ? TB_C(3.0) : TB_C(4.0);
        }
        t128 = t135;
    }
    const real_t side_0 = TB_C(0.0) == t126 ? t127 : (TB_C(0.0) == t128 ? TB_C(0.0) : side[0]);
    const real_t side_1 = TB_C(1.0) == t126 ? t127 : (TB_C(1.0) == t128 ? TB_C(0.0) : side[1]);
    const real_t side_2 = TB_C(2.0) == t126 ? t127 : (TB_C(2.0) == t128 ? TB_C(0.0) : side[2]);
    const real_t side_3 = TB_C(3.0) == t126 ? t127 : (TB_C(3.0) == t128 ? TB_C(0.0) : side[3]);
    const real_t side_4 = TB_C(4.0) == t126 ? t127 : (TB_C(4.0) == t128 ? TB_C(0.0) : side[4]);
    const real_t moving_0 = t123 ? -TB_C(1.0) : t73;
    const real_t push_0 = t123 ? TB_C(0.0) : push[0] + t106 * t122;
    const real_t done_0 = t125 ? TB_C(1.0) : TB_C(0.0);
    side[0] = side_0;
    side[1] = side_1;
    side[2] = side_2;
    side[3] = side_3;
    side[4] = side_4;
    moving[0] = moving_0;
    push[0] = push_0;
    done[0] = done_0;
    return TB_OK;
}

/* The tensions, refined and judged. */
static tb_status tb_isotropic_force_eq17_finish(const real_t structure[10], const real_t pivot[1],
    const real_t side[5], real_t force[1])
{
    (void)pivot;
    const real_t t0 = structure[0] * structure[6];
    const real_t t1 = structure[5] * structure[1];
    const real_t t2 = t0 - t1;
    const real_t t3 = TB_ABS(t2);
    const real_t t4 = structure[0] * structure[7];
    const real_t t5 = structure[5] * structure[2];
    const real_t t6 = t4 - t5;
    const real_t t7 = TB_ABS(t6);
    const real_t t8 = structure[0] * structure[8];
    const real_t t9 = structure[5] * structure[3];
    const real_t t10 = t8 - t9;
    const real_t t11 = TB_ABS(t10);
    const real_t t12 = structure[0] * structure[9];
    const real_t t13 = structure[5] * structure[4];
    const real_t t14 = t12 - t13;
    const real_t t15 = TB_ABS(t14);
    const real_t t16 = structure[8] + (structure[7] + (structure[6] + structure[5]));
    const real_t t17 = TB_C(5.0) * (structure[9] + t16);
    const real_t t18 = structure[3] + (structure[2] + (structure[0] + structure[1]));
    const real_t t19 = TB_C(5.0) * (structure[4] + t18);
    const real_t t20 = TB_C(5.0) * (t3 + t7 + t11 + t15) - TB_ABS(structure[0] * t17 -
        structure[5] * t19);
    const real_t t21 = structure[1] * structure[7];
    const real_t t22 = structure[6] * structure[2];
    const real_t t23 = t21 - t22;
    const real_t t24 = TB_ABS(t23);
    const real_t t25 = structure[1] * structure[8];
    const real_t t26 = structure[6] * structure[3];
    const real_t t27 = t25 - t26;
    const real_t t28 = TB_ABS(t27);
    const real_t t29 = structure[1] * structure[9];
    const real_t t30 = structure[6] * structure[4];
    const real_t t31 = t29 - t30;
    const real_t t32 = TB_ABS(t31);
    const real_t t33 = TB_C(5.0) * (t3 + t24 + t28 + t32) - TB_ABS(structure[1] * t17 -
        structure[6] * t19);
    const real_t t34 = structure[2] * structure[8];
    const real_t t35 = structure[7] * structure[3];
    const real_t t36 = t34 - t35;
    const real_t t37 = TB_ABS(t36);
    const real_t t38 = structure[2] * structure[9];
    const real_t t39 = structure[7] * structure[4];
    const real_t t40 = t38 - t39;
    const real_t t41 = TB_ABS(t40);
    const real_t t42 = TB_C(5.0) * (t7 + t24 + t37 + t41) - TB_ABS(structure[2] * t17 -
        structure[7] * t19);
    const real_t t43 = structure[3] * structure[9];
    const real_t t44 = structure[8] * structure[4];
    const real_t t45 = t43 - t44;
    const real_t t46 = TB_ABS(t45);
    const real_t t47 = TB_C(5.0) * (t37 + (t11 + t28) + t46) - TB_ABS(structure[3] * t17 -
        structure[8] * t19);
    const real_t t48 = TB_C(5.0) * (t46 + (t41 + (t15 + t32))) - TB_ABS(structure[4] * t17 -
        structure[9] * t19);
    const real_t t49 = tb_min(tb_min(tb_min(tb_min(t20, t33), t42), t47), t48);
    const bool t50 = TB_C(0.0) <= t49;
    real_t force_0;
    if (t50) {
        const bool t51 = TB_C(0.0) < t2;
        const real_t t52 = structure[0] * structure[1] + structure[6] * structure[5];
        const bool t53 = t52 < TB_C(0.0);
        const bool t54 = TB_C(0.0) < t6;
        const real_t t55 = t22 - t21;
        const bool t56 = TB_C(0.0) < t55;
        const bool t57 = TB_C(0.0) < t10;
        const real_t t58 = t26 - t25;
        const bool t59 = TB_C(0.0) < t58;
        const bool t60 = TB_C(0.0) < t14;
        const real_t t61 = t30 - t29;
        const bool t62 = TB_C(0.0) < t61;
        const bool t63 = (t51 || (TB_C(0.0) <= t2 && t53)) && !((t54 && t56) || (t57 && t59) ||
            (t60 && t62));
        const bool t64 = TB_C(0.0) == side[0];
        const bool t65 = TB_C(0.0) < side[0];
        const bool t66 = TB_C(0.0) < side[1];
        const real_t t67 = (t65 ? structure[0] * TB_TENSION_MAX : TB_C(0.0)) + (t66 ?
            structure[1] * TB_TENSION_MAX : TB_C(0.0));
        const bool t68 = TB_C(0.0) < side[2];
        const real_t t69 = t67 + (t68 ? structure[2] * TB_TENSION_MAX : TB_C(0.0));
        const bool t70 = TB_C(0.0) < side[3];
        const real_t t71 = t69 + (t70 ? structure[3] * TB_TENSION_MAX : TB_C(0.0));
        const bool t72 = TB_C(0.0) < side[4];
        const real_t t73 = t71 + (t72 ? structure[4] * TB_TENSION_MAX : TB_C(0.0));
        const real_t t74 = t64 ? (t64 ? structure[0] * structure[0] : TB_C(0.0)) : TB_C(0.0);
        const bool t75 = TB_C(0.0) == side[1];
        const real_t t76 = t75 ? (t75 ? structure[1] * structure[1] : TB_C(0.0)) : TB_C(0.0);
        const bool t77 = TB_C(0.0) == side[2];
        const real_t t78 = t77 ? (t77 ? structure[2] * structure[2] : TB_C(0.0)) : TB_C(0.0);
        const bool t79 = TB_C(0.0) == side[3];
        const real_t t80 = t79 ? (t79 ? structure[3] * structure[3] : TB_C(0.0)) : TB_C(0.0);
        const bool t81 = TB_C(0.0) == side[4];
        const real_t t82 = t81 ? (t81 ? structure[4] * structure[4] : TB_C(0.0)) : TB_C(0.0);
        const real_t t83 = TB_SQRT(t74 + t76 + t78 + t80 + t82);
        const real_t t84 = t64 ? structure[0] : TB_C(0.0);
        const real_t t85 = TB_COPYSIGN(t83, t84);
        const real_t t86 = TB_C(1.0) / t85;
        const real_t t87 = t73 * t86;
        const real_t t88 = t84 + t85;
        const real_t t89 = t75 ? (t75 ? structure[6] * structure[1] : TB_C(0.0)) : TB_C(0.0);
        const real_t t90 = t77 ? (t77 ? structure[7] * structure[2] : TB_C(0.0)) : TB_C(0.0);
        const real_t t91 = (t64 ? structure[5] * t88 : TB_C(0.0)) + t89 + t90;
        const real_t t92 = t79 ? (t79 ? structure[8] * structure[3] : TB_C(0.0)) : TB_C(0.0);
        const real_t t93 = t81 ? (t81 ? structure[9] * structure[4] : TB_C(0.0)) : TB_C(0.0);
        const real_t t94 = (t91 + t92 + t93) * (TB_C(1.0) / (t83 * (t83 + TB_ABS(t84))));
        const real_t t95 = (t64 ? structure[5] : TB_C(0.0)) - t88 * t94;
        const real_t t96 = (t65 ? structure[5] * TB_TENSION_MAX : TB_C(0.0)) + (t66 ?
            structure[6] * TB_TENSION_MAX : TB_C(0.0));
        const real_t t97 = t96 + (t68 ? structure[7] * TB_TENSION_MAX : TB_C(0.0));
        const real_t t98 = t97 + (t70 ? structure[8] * TB_TENSION_MAX : TB_C(0.0));
        const real_t t99 = t98 + (t72 ? structure[9] * TB_TENSION_MAX : TB_C(0.0));
        const real_t t100 = structure[6] - structure[1] * t94;
        const real_t t101 = t75 ? (t75 ? t100 * t100 : TB_C(0.0)) : TB_C(0.0);
        const real_t t102 = structure[7] - structure[2] * t94;
        const real_t t103 = t77 ? (t77 ? t102 * t102 : TB_C(0.0)) : TB_C(0.0);
        const real_t t104 = structure[8] - structure[3] * t94;
        const real_t t105 = t79 ? (t79 ? t104 * t104 : TB_C(0.0)) : TB_C(0.0);
        const real_t t106 = structure[9] - structure[4] * t94;
        const real_t t107 = t81 ? (t81 ? t106 * t106 : TB_C(0.0)) : TB_C(0.0);
        const real_t t108 = TB_COPYSIGN(TB_SQRT(t101 + t103 + t105 + t107), t75 ? t100 :
            TB_C(0.0));
        const real_t t109 = TB_C(1.0) / t108;
        const real_t t110 = t109 * ((t99 + t87 * t95) * t109);
        const real_t t111 = t86 * (t87 + t95 * t110);
        const real_t t112 = structure[0] * t111 + structure[5] * t110;
        const real_t t113 = structure[1] * t111 + structure[6] * t110;
        const real_t t114 = (t64 ? -(structure[0] * t112) : TB_C(0.0)) + (t75 ? -(structure[1]
            * t113) : TB_C(0.0));
        const real_t t115 = structure[2] * t111 + structure[7] * t110;
        const real_t t116 = t114 + (t77 ? -(structure[2] * t115) : TB_C(0.0));
        const real_t t117 = structure[3] * t111 + structure[8] * t110;
        const real_t t118 = t116 + (t79 ? -(structure[3] * t117) : TB_C(0.0));
        const real_t t119 = structure[4] * t111 + structure[9] * t110;
        const real_t t120 = t118 + (t81 ? -(structure[4] * t119) : TB_C(0.0));
        const real_t t121 = t86 * (t73 + t120);
        const real_t t122 = (t64 ? -(structure[5] * t112) : TB_C(0.0)) + (t75 ? -(structure[6]
            * t113) : TB_C(0.0));
        const real_t t123 = t122 + (t77 ? -(structure[7] * t115) : TB_C(0.0));
        const real_t t124 = t123 + (t79 ? -(structure[8] * t117) : TB_C(0.0));
        const real_t t125 = t124 + (t81 ? -(structure[9] * t119) : TB_C(0.0));
        const real_t t126 = t109 * (t109 * (t99 + t125 + t95 * t121));
        const real_t t127 = t86 * (t121 + t95 * t126);
        const real_t t128 = t112 + (structure[0] * t127 + structure[5] * t126);
        const real_t t129 = tb_max(t64 ? -t128 : (t65 ? TB_TENSION_MAX : TB_C(0.0)), TB_C(0.0));
        const real_t t130 = TB_TENSION_MAX - tb_min(t129, TB_TENSION_MAX);
        const real_t t131 = t113 + (structure[1] * t127 + structure[6] * t126);
        const real_t t132 = tb_max(t75 ? -t131 : (t66 ? TB_TENSION_MAX : TB_C(0.0)), TB_C(0.0));
        const real_t t133 = TB_TENSION_MAX - tb_min(t132, TB_TENSION_MAX);
        const real_t t134 = tb_min(t130, t133);
        const real_t t135 = structure[0] * structure[2] + structure[5] * structure[7];
        const bool t136 = t135 < TB_C(0.0);
        const bool t137 = TB_C(0.0) < t23;
        const real_t t138 = t35 - t34;
        const bool t139 = TB_C(0.0) < t138;
        const real_t t140 = t39 - t38;
        const bool t141 = TB_C(0.0) < t140;
        const bool t142 = !((t51 && t137) || (t57 && t139) || (t60 && t141));
        const real_t t143 = t115 + (structure[2] * t127 + structure[7] * t126);
        const real_t t144 = tb_max(t77 ? -t143 : (t68 ? TB_TENSION_MAX : TB_C(0.0)), TB_C(0.0));
        const real_t t145 = TB_TENSION_MAX - tb_min(t144, TB_TENSION_MAX);
        const real_t t146 = tb_min(t130, t145);
        const real_t t147 = (t54 || (TB_C(0.0) <= t6 && t136)) && t142 ? (t136 ? t6 * t146 :
            t146) : TB_C(1e+30);
        const real_t t148 = tb_min(t63 ? (t53 ? t2 * t134 : t134) : TB_C(1e+30), t147);
        const real_t t149 = structure[0] * structure[3] + structure[5] * structure[8];
        const bool t150 = t149 < TB_C(0.0);
        const bool t151 = TB_C(0.0) < t27;
        const bool t152 = TB_C(0.0) < t36;
        const real_t t153 = t44 - t43;
        const bool t154 = TB_C(0.0) < t153;
        const bool t155 = !((t51 && t151) || (t54 && t152) || (t60 && t154));
        const real_t t156 = t117 + (structure[3] * t127 + structure[8] * t126);
        const real_t t157 = tb_max(t79 ? -t156 : (t70 ? TB_TENSION_MAX : TB_C(0.0)), TB_C(0.0));
        const real_t t158 = TB_TENSION_MAX - tb_min(t157, TB_TENSION_MAX);
        const real_t t159 = tb_min(t130, t158);
        const real_t t160 = (t57 || (TB_C(0.0) <= t10 && t150)) && t155 ? (t150 ? t10 * t159 :
            t159) : TB_C(1e+30);
        const real_t t161 = structure[0] * structure[4] + structure[5] * structure[9];
        const bool t162 = t161 < TB_C(0.0);
        const bool t163 = TB_C(0.0) < t31;
        const bool t164 = TB_C(0.0) < t40;
        const bool t165 = TB_C(0.0) < t45;
        const bool t166 = !((t51 && t163) || (t54 && t164) || (t57 && t165));
        const real_t t167 = t119 + (structure[4] * t127 + structure[9] * t126);
        const real_t t168 = tb_max(t81 ? -t167 : (t72 ? TB_TENSION_MAX : TB_C(0.0)), TB_C(0.0));
        const real_t t169 = TB_TENSION_MAX - tb_min(t168, TB_TENSION_MAX);
        const real_t t170 = tb_min(t130, t169);
        const real_t t171 = (t60 || (TB_C(0.0) <= t14 && t162)) && t166 ? (t162 ? t14 * t170 :
            t170) : TB_C(1e+30);
        const real_t t172 = t1 - t0;
        const bool t173 = TB_C(0.0) < t172;
        const real_t t174 = t5 - t4;
        const bool t175 = TB_C(0.0) < t174;
        const real_t t176 = t9 - t8;
        const bool t177 = TB_C(0.0) < t176;
        const real_t t178 = t13 - t12;
        const bool t179 = TB_C(0.0) < t178;
        const bool t180 = (t137 && t175) || (t151 && t177) || (t163 && t179);
        const real_t t181 = tb_min(t133, t130);
        const real_t t182 = (t173 || (t53 && TB_C(0.0) <= t172)) && !t180 ? (t53 ? -(t2 * t181)
            : t181) : TB_C(1e+30);
        const real_t t183 = structure[1] * structure[2] + structure[6] * structure[7];
        const bool t184 = t183 < TB_C(0.0);
        const bool t185 = (t54 && t173) || (t139 && t151) || (t141 && t163);
        const real_t t186 = tb_min(t133, t145);
        const real_t t187 = (t137 || (TB_C(0.0) <= t23 && t184)) && !t185 ? (t184 ? t23 * t186
            : t186) : TB_C(1e+30);
        const real_t t188 = tb_min(tb_min(tb_min(tb_min(t148, t160), t171), t182), t187);
        const real_t t189 = structure[1] * structure[3] + structure[6] * structure[8];
        const bool t190 = t189 < TB_C(0.0);
        const bool t191 = (t57 && t173) || (t137 && t152) || (t154 && t163);
        const real_t t192 = tb_min(t133, t158);
        const real_t t193 = (t151 || (TB_C(0.0) <= t27 && t190)) && !t191 ? (t190 ? t27 * t192
            : t192) : TB_C(1e+30);
        const real_t t194 = structure[1] * structure[4] + structure[6] * structure[9];
        const bool t195 = t194 < TB_C(0.0);
        const bool t196 = (t60 && t173) || (t137 && t164) || (t151 && t165);
        const real_t t197 = tb_min(t133, t169);
        const real_t t198 = (t163 || (TB_C(0.0) <= t31 && t195)) && !t196 ? (t195 ? t31 * t197
            : t197) : TB_C(1e+30);
        const bool t199 = (t56 && t173) || (t152 && t177) || (t164 && t179);
        const real_t t200 = tb_min(t145, t130);
        const real_t t201 = (t175 || (t136 && TB_C(0.0) <= t174)) && !t199 ? (t136 ? -(t6 *
            t200) : t200) : TB_C(1e+30);
        const bool t202 = !((t51 && t175) || (t59 && t152) || (t62 && t164));
        const real_t t203 = tb_min(t145, t133);
        const real_t t204 = (t56 || (t184 && TB_C(0.0) <= t55)) && t202 ? (t184 ? -(t23 * t203)
            : t203) : TB_C(1e+30);
        const real_t t205 = tb_min(tb_min(tb_min(tb_min(t188, t193), t198), t201), t204);
        const real_t t206 = structure[2] * structure[3] + structure[7] * structure[8];
        const bool t207 = t206 < TB_C(0.0);
        const bool t208 = !((t57 && t175) || (t56 && t151) || (t154 && t164));
        const real_t t209 = tb_min(t145, t158);
        const real_t t210 = (t152 || (TB_C(0.0) <= t36 && t207)) && t208 ? (t207 ? t36 * t209 :
            t209) : TB_C(1e+30);
        const real_t t211 = structure[2] * structure[4] + structure[7] * structure[9];
        const bool t212 = t211 < TB_C(0.0);
        const bool t213 = !((t60 && t175) || (t56 && t163) || (t152 && t165));
        const real_t t214 = tb_min(t145, t169);
        const real_t t215 = (t164 || (TB_C(0.0) <= t40 && t212)) && t213 ? (t212 ? t40 * t214 :
            t214) : TB_C(1e+30);
        const bool t216 = (t59 && t173) || (t139 && t175) || (t165 && t179);
        const real_t t217 = tb_min(t158, t130);
        const real_t t218 = (t177 || (t150 && TB_C(0.0) <= t176)) && !t216 ? (t150 ? -(t10 *
            t217) : t217) : TB_C(1e+30);
        const bool t219 = !((t51 && t177) || (t56 && t139) || (t62 && t165));
        const real_t t220 = tb_min(t158, t133);
        const real_t t221 = (t59 || (t190 && TB_C(0.0) <= t58)) && t219 ? (t190 ? -(t27 * t220)
            : t220) : TB_C(1e+30);
        const real_t t222 = tb_min(tb_min(tb_min(tb_min(t205, t210), t215), t218), t221);
        const bool t223 = !((t54 && t177) || (t59 && t137) || (t141 && t165));
        const real_t t224 = tb_min(t158, t145);
        const real_t t225 = (t139 || (t207 && TB_C(0.0) <= t138)) && t223 ? (t207 ? -(t36 *
            t224) : t224) : TB_C(1e+30);
        const real_t t226 = structure[3] * structure[4] + structure[8] * structure[9];
        const bool t227 = t226 < TB_C(0.0);
        const bool t228 = !((t60 && t177) || (t59 && t163) || (t139 && t164));
        const real_t t229 = tb_min(t158, t169);
        const real_t t230 = (t165 || (TB_C(0.0) <= t45 && t227)) && t228 ? (t227 ? t45 * t229 :
            t229) : TB_C(1e+30);
        const bool t231 = (t62 && t173) || (t141 && t175) || (t154 && t177);
        const real_t t232 = tb_min(t169, t130);
        const real_t t233 = (t179 || (t162 && TB_C(0.0) <= t178)) && !t231 ? (t162 ? -(t14 *
            t232) : t232) : TB_C(1e+30);
        const bool t234 = !((t51 && t179) || (t56 && t141) || (t59 && t154));
        const real_t t235 = tb_min(t169, t133);
        const real_t t236 = (t62 || (t195 && TB_C(0.0) <= t61)) && t234 ? (t195 ? -(t31 * t235)
            : t235) : TB_C(1e+30);
        const real_t t237 = tb_min(tb_min(tb_min(tb_min(t222, t225), t230), t233), t236);
        const bool t238 = !((t54 && t179) || (t62 && t137) || (t139 && t154));
        const real_t t239 = tb_min(t169, t145);
        const real_t t240 = (t141 || (t212 && TB_C(0.0) <= t140)) && t238 ? (t212 ? -(t40 *
            t239) : t239) : TB_C(1e+30);
        const bool t241 = !((t57 && t179) || (t62 && t151) || (t141 && t152));
        const real_t t242 = tb_min(t169, t158);
        const real_t t243 = (t154 || (t227 && TB_C(0.0) <= t153)) && t241 ? (t227 ? -(t45 *
            t242) : t242) : TB_C(1e+30);
        force_0 = tb_min(tb_min(t237, t240), t243);
    } else {
        force_0 = TB_C(0.0);
    }
    const bool t244 = !t50;
    force[0] = force_0;
    return t244 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_isotropic_force_eq17(const real_t pose[2], const real_t rails[1], real_t force[1])
{
    real_t structure[10];
    real_t pivot[1];
    real_t side[5];
    real_t moving[1];
    real_t push[1];
    real_t done[1] = {TB_C(0.0)};
    tb_status status = tb_isotropic_force_eq17_begin(pose, rails, structure, pivot, side,
        moving, push);
    for (int steps = 0; steps < 25 && status == TB_OK && !(done[0] > TB_C(0.0)); steps++) {
        status = tb_isotropic_force_eq17_step(structure, side, moving, push, done);
    }
    if (status == TB_OK && !(done[0] > TB_C(0.0))) {
        status = TB_INACCURATE;
    }
    if (status != TB_OK) {
        force[0] = TB_C(0.0);
        return status;
    }
    return tb_isotropic_force_eq17_finish(structure, pivot, side, force);
}

