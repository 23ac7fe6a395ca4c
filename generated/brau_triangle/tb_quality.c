/* Regenerate: turnbuckle generate machines/brau_triangle.toml --out <this folder>
 * Machine 62d2624dcb098eaa, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_quality.h"
#include "tb_machine.h"

/* Refuses with a status: tension is 0 N. */
static tb_status tb_refuse_zero_wrench_tension(tb_status status, real_t tension[3])
{
    tension[0] = TB_C(0.0);
    tension[1] = TB_C(0.0);
    tension[2] = TB_C(0.0);
    return status;
}

tb_status tb_zero_wrench_tension(const real_t pose[2], const real_t rails[1], real_t tension[3])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0))) {
        return tb_refuse_zero_wrench_tension(TB_OUT_OF_DOMAIN, tension);
    }
    const real_t t0 = pose[1] * pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(pose[0] * pose[0] + t0);
    const real_t t1 = TB_C(1.0) / length_0;
    const real_t t2 = pose[0] * t1;
    const real_t t3 = TB_FRAME_X - pose[0];
    const real_t length_1 = TB_SQRT(t0 + t3 * t3);
    const real_t t4 = TB_C(1.0) / length_1;
    const real_t t5 = pose[1] * t4;
    const real_t t6 = pose[1] * t1;
    const real_t t7 = t3 * t4;
    const real_t t8 = TB_ABS(t2 * t5 + t6 * t7);
    const real_t t9 = TB_BASE_3_X - pose[0];
    const real_t t10 = TB_FRAME_Y - pose[1];
    const real_t length_2 = TB_SQRT(t9 * t9 + t10 * t10);
    const real_t t11 = TB_C(1.0) / length_2;
    const real_t t12 = t9 * t11;
    const real_t t13 = t10 * t11;
    const real_t t14 = TB_ABS(t6 * t12 - t2 * t13);
    const real_t t15 = TB_C(10.0) * (t12 + (t7 - t2));
    const real_t t16 = TB_C(10.0) * (t13 - (t5 + t6));
    const real_t t17 = TB_C(10.0) * (t8 + t14) - TB_ABS(t6 * t15 - t2 * t16);
    const real_t t18 = TB_ABS(t7 * t13 + t5 * t12);
    const real_t t19 = TB_C(10.0) * (t8 + t18) - TB_ABS(t7 * t16 + t5 * t15);
    const real_t t20 = TB_C(10.0) * (t14 + t18) - TB_ABS(t12 * t16 - t13 * t15);
    const bool t21 = TB_C(0.0) <= tb_min(tb_min(t17, t19), t20);
    const real_t t22 = TB_SQRT(t2 * t2 + t7 * t7 + t12 * t12);
    const real_t t23 = TB_COPYSIGN(t22, -t2);
    const real_t t24 = t23 - t2;
    const real_t t25 = TB_C(1.0) / (t22 * (t22 + TB_ABS(t2)));
    const real_t t26 = (t12 * t13 - (t6 * t24 + t5 * t7)) * t25;
    const real_t t27 = t13 - t12 * t26;
    const real_t t28 = t5 + t7 * t26;
    const real_t t29 = TB_SQRT(t28 * t28 + t27 * t27);
    const real_t t30 = t27 / (t29 * (t29 + TB_ABS(t28)));
    const real_t t31 = TB_C(1.0) - t27 * t30;
    const real_t t32 = TB_COPYSIGN(t29, -t28);
    const real_t t33 = t30 * (t32 - t28);
    const real_t t34 = t25 * (t12 * t31 - t7 * t33);
    const real_t t35 = t24 * t34;
    const real_t t36 = TB_C(16.0) * TB_EPSILON;
    const bool t37 = TB_ABS(t35) <= t36;
    const real_t t38 = TB_ABS(t23);
    const real_t t39 = TB_ABS(t32);
    const real_t t40 = TB_C(1.0) / tb_min(t38, t39);
    const real_t t41 = TB_EPSILON * TB_C(60.0) * t40;
    const real_t t42 = t41 + TB_TENSION_MAX;
    real_t t43, t44;
    if (t37) {
        t43 = -TB_C(1000000000000.0);
        t44 = TB_C(1000000000000.0);
    } else {
        const real_t t45 = TB_C(1.0) / t35;
        const real_t t46 = t41 * t45;
        const real_t t47 = -(t45 * t42);
        t43 = tb_min(t46, t47);
        t44 = tb_max(t46, t47);
    }
    const real_t t48 = t33 + t7 * t34;
    const bool t49 = TB_ABS(t48) <= t36;
    real_t t50, t51;
    if (t49) {
        t50 = -TB_C(1000000000000.0);
        t51 = TB_C(1000000000000.0);
    } else {
        const real_t t52 = TB_C(1.0) / t48;
        const real_t t53 = t41 * t52;
        const real_t t54 = -(t42 * t52);
        t50 = tb_min(t53, t54);
        t51 = tb_max(t53, t54);
    }
    const real_t t55 = t31 - t12 * t34;
    const bool t56 = TB_ABS(t55) <= t36;
    real_t t57, t58;
    if (t56) {
        t57 = -TB_C(1000000000000.0);
        t58 = TB_C(1000000000000.0);
    } else {
        const real_t t59 = TB_C(1.0) / t55;
        const real_t t60 = -(t41 * t59);
        const real_t t61 = t42 * t59;
        t57 = tb_min(t60, t61);
        t58 = tb_max(t60, t61);
    }
    const real_t t62 = tb_min(tb_max(TB_C(0.0), tb_max(tb_max(t43, t50), t57)),
        tb_min(tb_min(t44, t51), t58));
    const real_t t63 = tb_min(tb_max(-(t35 * t62), TB_C(0.0)), TB_TENSION_MAX);
    const real_t tension_0 = t21 ? t63 : TB_C(0.0);
    const real_t t64 = tb_min(tb_max(-(t48 * t62), TB_C(0.0)), TB_TENSION_MAX);
    const real_t tension_1 = t21 ? t64 : TB_C(0.0);
    const real_t t65 = tb_min(tb_max(t55 * t62, TB_C(0.0)), TB_TENSION_MAX);
    const real_t tension_2 = t21 ? t65 : TB_C(0.0);
    const bool t66 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t67 = !(t66 && TB_C(0.0001) < length_2);
    const real_t t68 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t69 = !(t68 < t38 && t68 < t39);
    const bool t70 = !t21;
    const real_t t71 = tb_max(TB_C(0.0), TB_ABS(t7 * t64 - t2 * t63 + t12 * t65));
    const real_t t72 = tb_max(t71, TB_ABS(t13 * t65 - (t6 * t63 + t5 * t64)));
    const bool t73 = !(t70 || t72 <= t40 * (TB_EPSILON * TB_C(2560.0)));
    if (t67 || t69) {
        return tb_refuse_zero_wrench_tension(TB_SINGULAR, tension);
    }
    if (t73) {
        return tb_refuse_zero_wrench_tension(TB_INACCURATE, tension);
    }
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    return t70 ? TB_INFEASIBLE : TB_OK;
}

/* Refuses with a status: factor is 0. */
static tb_status tb_refuse_tension_factor(tb_status status, real_t factor[1])
{
    factor[0] = TB_C(0.0);
    return status;
}

tb_status tb_tension_factor(const real_t pose[2], const real_t rails[1], real_t factor[1])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0))) {
        return tb_refuse_tension_factor(TB_OUT_OF_DOMAIN, factor);
    }
    const real_t t0 = pose[1] * pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(pose[0] * pose[0] + t0);
    const real_t t1 = TB_C(1.0) / length_0;
    const real_t t2 = pose[0] * t1;
    const real_t t3 = TB_FRAME_X - pose[0];
    const real_t length_1 = TB_SQRT(t0 + t3 * t3);
    const real_t t4 = TB_C(1.0) / length_1;
    const real_t t5 = pose[1] * t4;
    const real_t t6 = pose[1] * t1;
    const real_t t7 = t3 * t4;
    const real_t t8 = TB_ABS(t2 * t5 + t6 * t7);
    const real_t t9 = TB_BASE_3_X - pose[0];
    const real_t t10 = TB_FRAME_Y - pose[1];
    const real_t length_2 = TB_SQRT(t9 * t9 + t10 * t10);
    const real_t t11 = TB_C(1.0) / length_2;
    const real_t t12 = t9 * t11;
    const real_t t13 = t10 * t11;
    const real_t t14 = TB_ABS(t6 * t12 - t2 * t13);
    const real_t t15 = TB_C(10.0) * (t12 + (t7 - t2));
    const real_t t16 = TB_C(10.0) * (t13 - (t5 + t6));
    const real_t t17 = TB_C(10.0) * (t8 + t14) - TB_ABS(t6 * t15 - t2 * t16);
    const real_t t18 = TB_ABS(t7 * t13 + t5 * t12);
    const real_t t19 = TB_C(10.0) * (t8 + t18) - TB_ABS(t7 * t16 + t5 * t15);
    const real_t t20 = TB_C(10.0) * (t14 + t18) - TB_ABS(t12 * t16 - t13 * t15);
    const bool t21 = TB_C(0.0) <= tb_min(tb_min(t17, t19), t20);
    const real_t t22 = TB_SQRT(t2 * t2 + t7 * t7 + t12 * t12);
    const real_t t23 = TB_COPYSIGN(t22, -t2);
    const real_t t24 = t23 - t2;
    const real_t t25 = TB_C(1.0) / (t22 * (t22 + TB_ABS(t2)));
    const real_t t26 = (t12 * t13 - (t6 * t24 + t5 * t7)) * t25;
    const real_t t27 = t13 - t12 * t26;
    const real_t t28 = t5 + t7 * t26;
    const real_t t29 = TB_SQRT(t28 * t28 + t27 * t27);
    const real_t t30 = t27 / (t29 * (t29 + TB_ABS(t28)));
    const real_t t31 = TB_C(1.0) - t27 * t30;
    const real_t t32 = TB_COPYSIGN(t29, -t28);
    const real_t t33 = t30 * (t32 - t28);
    const real_t t34 = t25 * (t12 * t31 - t7 * t33);
    const real_t t35 = t24 * t34;
    const real_t t36 = TB_C(16.0) * TB_EPSILON;
    const bool t37 = TB_ABS(t35) <= t36;
    const real_t t38 = TB_ABS(t23);
    const real_t t39 = TB_ABS(t32);
    const real_t t40 = TB_EPSILON * TB_C(60.0) / tb_min(t38, t39);
    const real_t t41 = t40 + TB_TENSION_MAX;
    real_t t42, t43;
    if (t37) {
        t42 = -TB_C(1000000000000.0);
        t43 = TB_C(1000000000000.0);
    } else {
        const real_t t44 = TB_C(1.0) / t35;
        const real_t t45 = t40 * t44;
        const real_t t46 = -(t44 * t41);
        t42 = tb_min(t45, t46);
        t43 = tb_max(t45, t46);
    }
    const real_t t47 = t33 + t7 * t34;
    const bool t48 = TB_ABS(t47) <= t36;
    real_t t49, t50;
    if (t48) {
        t49 = -TB_C(1000000000000.0);
        t50 = TB_C(1000000000000.0);
    } else {
        const real_t t51 = TB_C(1.0) / t47;
        const real_t t52 = t40 * t51;
        const real_t t53 = -(t41 * t51);
        t49 = tb_min(t52, t53);
        t50 = tb_max(t52, t53);
    }
    const real_t t54 = t31 - t12 * t34;
    const bool t55 = TB_ABS(t54) <= t36;
    real_t t56, t57;
    if (t55) {
        t56 = -TB_C(1000000000000.0);
        t57 = TB_C(1000000000000.0);
    } else {
        const real_t t58 = TB_C(1.0) / t54;
        const real_t t59 = -(t40 * t58);
        const real_t t60 = t41 * t58;
        t56 = tb_min(t59, t60);
        t57 = tb_max(t59, t60);
    }
    const real_t t61 = tb_min(tb_max(TB_C(0.0), tb_max(tb_max(t42, t49), t56)),
        tb_min(tb_min(t43, t50), t57));
    /* T0 */
    const real_t rest_0 = tb_min(tb_max(-(t35 * t61), TB_C(0.0)), TB_TENSION_MAX);
    const real_t rest_1 = tb_min(tb_max(-(t47 * t61), TB_C(0.0)), TB_TENSION_MAX);
    const real_t rest_2 = tb_min(tb_max(t54 * t61, TB_C(0.0)), TB_TENSION_MAX);
    const real_t t62 = tb_max(tb_max(rest_0, rest_1), rest_2);
    real_t factor_0;
    if (t21) {
        factor_0 = tb_min(tb_min(rest_0, rest_1), rest_2) / t62;
    } else {
        factor_0 = TB_C(0.0);
    }
    const bool t63 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t64 = !(t63 && TB_C(0.0001) < length_2);
    const real_t t65 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t66 = !(t65 < t38 && t65 < t39);
    const bool t67 = !(TB_C(0.0) < t62);
    const bool t68 = !t21;
    if (t64 || t66 || t67) {
        return tb_refuse_tension_factor(TB_SINGULAR, factor);
    }
    factor[0] = factor_0;
    return t68 ? TB_INFEASIBLE : TB_OK;
}

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
    const real_t t0 = pose[1] * pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(pose[0] * pose[0] + t0);
    const real_t t1 = TB_C(1.0) / length_0;
    const real_t t2 = pose[0] * t1;
    const real_t t3 = TB_FRAME_X - pose[0];
    const real_t length_1 = TB_SQRT(t0 + t3 * t3);
    const real_t t4 = TB_C(1.0) / length_1;
    const real_t t5 = pose[1] * t4;
    const real_t t6 = pose[1] * t1;
    const real_t t7 = t3 * t4;
    const real_t t8 = TB_ABS(t2 * t5 + t6 * t7);
    const real_t t9 = TB_BASE_3_X - pose[0];
    const real_t t10 = TB_FRAME_Y - pose[1];
    const real_t length_2 = TB_SQRT(t9 * t9 + t10 * t10);
    const real_t t11 = TB_C(1.0) / length_2;
    const real_t t12 = t9 * t11;
    const real_t t13 = t10 * t11;
    const real_t t14 = TB_ABS(t6 * t12 - t2 * t13);
    const real_t t15 = TB_C(10.0) * (t12 + (t7 - t2));
    const real_t t16 = TB_C(10.0) * (t13 - (t5 + t6));
    const real_t t17 = TB_C(10.0) * (t8 + t14) - TB_ABS(t6 * t15 - t2 * t16);
    const real_t t18 = TB_ABS(t7 * t13 + t5 * t12);
    const real_t t19 = TB_C(10.0) * (t8 + t18) - TB_ABS(t7 * t16 + t5 * t15);
    const real_t t20 = TB_C(10.0) * (t14 + t18) - TB_ABS(t12 * t16 - t13 * t15);
    const real_t t21 = tb_min(tb_min(t17, t19), t20);
    const real_t force_0 = tb_max(TB_C(0.0), t21);
    const bool t22 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t23 = !(t22 && TB_C(0.0001) < length_2);
    const bool t24 = !(TB_C(0.0) <= t21);
    if (t23) {
        return tb_refuse_isotropic_force(TB_SINGULAR, force);
    }
    force[0] = force_0;
    return t24 ? TB_INFEASIBLE : TB_OK;
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
    const real_t t0 = pose[1] * pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(pose[0] * pose[0] + t0);
    const real_t t1 = TB_C(1.0) / length_0;
    const real_t t2 = pose[0] * t1;
    const real_t t3 = TB_FRAME_X - pose[0];
    const real_t length_1 = TB_SQRT(t0 + t3 * t3);
    const real_t t4 = TB_C(1.0) / length_1;
    const real_t t5 = pose[1] * t4;
    const real_t t6 = pose[1] * t1;
    const real_t t7 = t3 * t4;
    const real_t t8 = t2 * t5 + t6 * t7;
    const real_t t9 = TB_ABS(t8);
    const real_t t10 = TB_BASE_3_X - pose[0];
    const real_t t11 = TB_FRAME_Y - pose[1];
    const real_t length_2 = TB_SQRT(t10 * t10 + t11 * t11);
    const real_t t12 = TB_C(1.0) / length_2;
    const real_t t13 = t10 * t12;
    const real_t t14 = t11 * t12;
    const real_t t15 = t6 * t13 - t2 * t14;
    const real_t t16 = TB_ABS(t15);
    const real_t t17 = TB_C(10.0) * (t13 + (t7 - t2));
    const real_t t18 = TB_C(10.0) * (t14 - (t5 + t6));
    const real_t t19 = TB_C(10.0) * (t9 + t16) - TB_ABS(t6 * t17 - t2 * t18);
    const real_t t20 = t7 * t14 + t5 * t13;
    const real_t t21 = TB_ABS(t20);
    const real_t t22 = TB_C(10.0) * (t9 + t21) - TB_ABS(t7 * t18 + t5 * t17);
    const real_t t23 = TB_C(10.0) * (t16 + t21) - TB_ABS(t13 * t18 - t14 * t17);
    const real_t margin_0 = tb_min(tb_min(t19, t22), t23);
    const real_t force_0 = tb_max(TB_C(0.0), margin_0);
    const bool t24 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t25 = !(t24 && TB_C(0.0001) < length_2);
    const real_t t26 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const real_t t27 = (t8 * t8 + t15 * t15 + t20 * t20) * TB_C(0.6666666666666666);
    const bool t28 = !(t26 * t26 < t27);
    const bool t29 = !(TB_C(0.0) <= margin_0);
    if (t25 || t28) {
        return tb_refuse_pose_quality(TB_SINGULAR, margin, factor, force);
    }
    if (TB_C(0.0)) {
        return tb_refuse_pose_quality(TB_INACCURATE, margin, factor, force);
    }
    margin[0] = margin_0;
    factor[0] = TB_C(0.0);
    force[0] = force_0;
    return t29 ? TB_INFEASIBLE : TB_OK;
}

/* Refuses with a status: force is 0 N. */
static tb_status tb_refuse_isotropic_force_eq17(tb_status status, real_t force[1])
{
    force[0] = TB_C(0.0);
    return status;
}

tb_status tb_isotropic_force_eq17(const real_t pose[2], const real_t rails[1], real_t force[1])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0))) {
        return tb_refuse_isotropic_force_eq17(TB_OUT_OF_DOMAIN, force);
    }
    const real_t t0 = pose[1] * pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(pose[0] * pose[0] + t0);
    const real_t t1 = TB_C(1.0) / length_0;
    const real_t t2 = pose[0] * t1;
    const real_t t3 = TB_FRAME_X - pose[0];
    const real_t length_1 = TB_SQRT(t0 + t3 * t3);
    const real_t t4 = TB_C(1.0) / length_1;
    const real_t t5 = pose[1] * t4;
    const real_t t6 = pose[1] * t1;
    const real_t t7 = t3 * t4;
    const real_t t8 = t2 * t5 + t6 * t7;
    const real_t t9 = TB_ABS(t8);
    const real_t t10 = TB_BASE_3_X - pose[0];
    const real_t t11 = TB_FRAME_Y - pose[1];
    const real_t length_2 = TB_SQRT(t10 * t10 + t11 * t11);
    const real_t t12 = TB_C(1.0) / length_2;
    const real_t t13 = t10 * t12;
    const real_t t14 = t6 * t13;
    const real_t t15 = t11 * t12;
    const real_t t16 = t2 * t15;
    const real_t t17 = t14 - t16;
    const real_t t18 = TB_ABS(t17);
    const real_t t19 = TB_C(10.0) * (t13 + (t7 - t2));
    const real_t t20 = TB_C(10.0) * (t15 - (t5 + t6));
    const real_t t21 = TB_C(10.0) * (t9 + t18) - TB_ABS(t6 * t19 - t2 * t20);
    const real_t t22 = t7 * t15 + t5 * t13;
    const real_t t23 = TB_ABS(t22);
    const real_t t24 = TB_C(10.0) * (t9 + t23) - TB_ABS(t7 * t20 + t5 * t19);
    const real_t t25 = TB_C(10.0) * (t18 + t23) - TB_ABS(t13 * t20 - t15 * t19);
    const bool t26 = TB_C(0.0) <= tb_min(tb_min(t21, t24), t25);
    const real_t t27 = TB_SQRT(t2 * t2 + t7 * t7 + t13 * t13);
    const real_t t28 = TB_COPYSIGN(t27, -t2);
    const real_t t29 = t28 - t2;
    const real_t t30 = TB_C(1.0) / (t27 * (t27 + TB_ABS(t2)));
    const real_t t31 = (t13 * t15 - (t6 * t29 + t5 * t7)) * t30;
    const real_t t32 = t15 - t13 * t31;
    const real_t t33 = t5 + t7 * t31;
    const real_t t34 = TB_SQRT(t33 * t33 + t32 * t32);
    const real_t t35 = TB_COPYSIGN(t34, -t33);
    const real_t t36 = TB_ABS(t28);
    const real_t t37 = TB_ABS(t35);
    real_t force_0;
    if (t26) {
        const bool t38 = TB_C(0.0) < t8;
        const bool t39 = t5 * t6 - t2 * t7 < TB_C(0.0);
        const bool t40 = TB_C(0.0) < t17;
        const real_t t41 = -t22;
        const bool t42 = TB_C(0.0) < t41;
        const bool t43 = (t38 || (TB_C(0.0) <= t8 && t39)) && !(t40 && t42);
        const real_t t44 = t32 / (t34 * (t34 + TB_ABS(t33)));
        const real_t t45 = TB_C(1.0) - t32 * t44;
        const real_t t46 = t44 * (t35 - t33);
        const real_t t47 = t30 * (t13 * t45 - t7 * t46);
        const real_t t48 = t29 * t47;
        const real_t t49 = TB_C(16.0) * TB_EPSILON;
        const bool t50 = TB_ABS(t48) <= t49;
        const real_t t51 = TB_EPSILON * TB_C(60.0) / tb_min(t36, t37);
        const real_t t52 = TB_TENSION_MAX + t51;
        real_t t53, t54;
        if (t50) {
            t53 = -TB_C(1000000000000.0);
            t54 = TB_C(1000000000000.0);
        } else {
            const real_t t55 = TB_C(1.0) / t48;
            const real_t t56 = t51 * t55;
            const real_t t57 = -(t55 * t52);
            t53 = tb_min(t56, t57);
            t54 = tb_max(t56, t57);
        }
        const real_t t58 = t46 + t7 * t47;
        const bool t59 = TB_ABS(t58) <= t49;
        real_t t60, t61;
        if (t59) {
            t60 = -TB_C(1000000000000.0);
            t61 = TB_C(1000000000000.0);
        } else {
            const real_t t62 = TB_C(1.0) / t58;
            const real_t t63 = t51 * t62;
            const real_t t64 = -(t52 * t62);
            t60 = tb_min(t63, t64);
            t61 = tb_max(t63, t64);
        }
        const real_t t65 = t45 - t13 * t47;
        const bool t66 = TB_ABS(t65) <= t49;
        real_t t67, t68;
        if (t66) {
            t67 = -TB_C(1000000000000.0);
            t68 = TB_C(1000000000000.0);
        } else {
            const real_t t69 = TB_C(1.0) / t65;
            const real_t t70 = -(t51 * t69);
            const real_t t71 = t52 * t69;
            t67 = tb_min(t70, t71);
            t68 = tb_max(t70, t71);
        }
        const real_t t72 = tb_min(tb_max(TB_C(0.0), tb_max(tb_max(t53, t60), t67)),
            tb_min(tb_min(t54, t61), t68));
        const real_t t73 = tb_min(tb_max(-(t48 * t72), TB_C(0.0)), TB_TENSION_MAX);
        /* t_i = T_max - T0_i */
        const real_t margin_0 = TB_TENSION_MAX - t73;
        const real_t t74 = tb_min(tb_max(-(t58 * t72), TB_C(0.0)), TB_TENSION_MAX);
        const real_t margin_1 = TB_TENSION_MAX - t74;
        const real_t t75 = tb_min(margin_0, margin_1);
        const bool t76 = -(t2 * t13 + t6 * t15) < TB_C(0.0);
        const bool t77 = TB_C(0.0) < t22;
        const bool t78 = (t40 || (TB_C(0.0) <= t17 && t76)) && !(t38 && t77);
        const real_t margin_2 = TB_TENSION_MAX - tb_min(tb_max(t65 * t72, TB_C(0.0)),
            TB_TENSION_MAX);
        const real_t t79 = tb_min(margin_0, margin_2);
        const real_t t80 = tb_min(t43 ? (t39 ? t8 * t75 : t75) : TB_C(1e+30), t78 ? (t76 ? t17
            * t79 : t79) : TB_C(1e+30));
        const real_t t81 = -t8;
        const bool t82 = TB_C(0.0) < t81;
        const real_t t83 = t16 - t14;
        const bool t84 = TB_C(0.0) < t83;
        const bool t85 = (t82 || (t39 && TB_C(0.0) <= t81)) && !(t77 && t84);
        const real_t t86 = tb_min(margin_1, margin_0);
        const real_t t87 = tb_min(t80, t85 ? (t39 ? -(t8 * t86) : t86) : TB_C(1e+30));
        const bool t88 = t7 * t13 - t5 * t15 < TB_C(0.0);
        const bool t89 = (t77 || (TB_C(0.0) <= t22 && t88)) && !(t40 && t82);
        const real_t t90 = tb_min(margin_1, margin_2);
        const real_t t91 = tb_min(t87, t89 ? (t88 ? t22 * t90 : t90) : TB_C(1e+30));
        const bool t92 = (t84 || (t76 && TB_C(0.0) <= t83)) && !(t42 && t82);
        const real_t t93 = tb_min(margin_2, margin_0);
        const real_t t94 = tb_min(t91, t92 ? (t76 ? -(t17 * t93) : t93) : TB_C(1e+30));
        const bool t95 = (t42 || (t88 && TB_C(0.0) <= t41)) && !(t38 && t84);
        const real_t t96 = tb_min(margin_2, margin_1);
        const real_t t97 = tb_min(t94, t95 ? (t88 ? -(t22 * t96) : t96) : TB_C(1e+30));
        force_0 = t97;
    } else {
        force_0 = TB_C(0.0);
    }
    const bool t98 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t99 = !(t98 && TB_C(0.0001) < length_2);
    const real_t t100 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t101 = !(t100 < t36 && t100 < t37);
    const bool t102 = !t26;
    if (t99 || t101) {
        return tb_refuse_isotropic_force_eq17(TB_SINGULAR, force);
    }
    force[0] = force_0;
    return t102 ? TB_INFEASIBLE : TB_OK;
}

