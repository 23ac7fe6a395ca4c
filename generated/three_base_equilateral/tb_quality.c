/* Regenerate: turnbuckle generate machines/three_base_equilateral.toml --out <this folder>
 * Machine bf852767ce09ae7f, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_quality.h"
#include "tb_machine.h"

/* Refuses with a status: tension is 3 N. */
static tb_status tb_refuse_zero_wrench_tension(tb_status status, real_t tension[3])
{
    tension[0] = TB_TENSION_MIN;
    tension[1] = TB_TENSION_MIN;
    tension[2] = TB_TENSION_MIN;
    return status;
}

tb_status tb_zero_wrench_tension(const real_t pose[2], const real_t rails[6], real_t tension[3])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) +
              TB_ABS(rails[4]) + TB_ABS(rails[5]) <= TB_C(8.541599999999999))) {
        return tb_refuse_zero_wrench_tension(TB_OUT_OF_DOMAIN, tension);
    }
    const real_t t0 = rails[0] - pose[0];
    const real_t t1 = TB_FRAME - rails[1] - pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 * t0 + t1 * t1);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t t3 = t0 * t2;
    const real_t t4 = rails[2] - pose[1];
    const real_t t5 = rails[3] - pose[0];
    const real_t length_1 = TB_SQRT(t5 * t5 + t4 * t4);
    const real_t t6 = TB_C(1.0) / length_1;
    const real_t t7 = t4 * t6;
    const real_t t8 = t1 * t2;
    const real_t t9 = t5 * t6;
    const real_t t10 = TB_ABS(t3 * t7 - t8 * t9);
    const real_t t11 = rails[4] - pose[1];
    const real_t t12 = TB_FRAME - rails[5] - pose[0];
    const real_t length_2 = TB_SQRT(t12 * t12 + t11 * t11);
    const real_t t13 = TB_C(1.0) / length_2;
    const real_t t14 = t11 * t13;
    const real_t t15 = t12 * t13;
    const real_t t16 = TB_ABS(t3 * t14 - t8 * t15);
    const real_t t17 = TB_TENSION_MIDDLE * (t14 + (t7 + t8));
    const real_t t18 = TB_TENSION_MIDDLE * (t15 + (t3 + t9));
    const real_t t19 = TB_TENSION_HALF_RANGE * (t10 + t16) - TB_ABS(t3 * t17 - t8 * t18);
    const real_t t20 = TB_ABS(t9 * t14 - t7 * t15);
    const real_t t21 = TB_TENSION_HALF_RANGE * (t10 + t20) - TB_ABS(t9 * t17 - t7 * t18);
    const real_t t22 = TB_TENSION_HALF_RANGE * (t16 + t20) - TB_ABS(t15 * t17 - t14 * t18);
    const bool t23 = TB_C(0.0) <= tb_min(tb_min(t19, t21), t22);
    const bool t24 = !t23;
    const real_t t25 = TB_SQRT(t3 * t3 + t9 * t9 + t15 * t15);
    const real_t t26 = TB_COPYSIGN(t25, t3);
    const real_t t27 = t3 + t26;
    const real_t t28 = TB_C(1.0) / (t25 * (t25 + TB_ABS(t3)));
    const real_t t29 = (t8 * t27 + t7 * t9 + t14 * t15) * t28;
    const real_t t30 = t14 - t15 * t29;
    const real_t t31 = t7 - t9 * t29;
    const real_t t32 = TB_SQRT(t31 * t31 + t30 * t30);
    const real_t t33 = t30 / (t32 * (t32 + TB_ABS(t31)));
    const real_t t34 = TB_C(1.0) - t30 * t33;
    const real_t t35 = TB_COPYSIGN(t32, t31);
    const real_t t36 = t33 * (t31 + t35);
    const real_t t37 = t28 * (t15 * t34 - t9 * t36);
    const real_t t38 = t27 * t37;
    const real_t t39 = TB_C(16.0) * TB_EPSILON;
    const bool t40 = TB_ABS(t38) <= t39;
    const real_t t41 = TB_ABS(t26);
    const real_t t42 = TB_ABS(t35);
    const real_t t43 = TB_C(1.0) / tb_min(t41, t42);
    const real_t t44 = TB_EPSILON * TB_C(30.0) * t43;
    const real_t t45 = TB_TENSION_MIN - t44;
    const real_t t46 = t44 + TB_TENSION_MAX;
    real_t t47, t48;
    if (t40) {
        t47 = -TB_C(1000000000000.0);
        t48 = TB_C(1000000000000.0);
    } else {
        const real_t t49 = TB_C(1.0) / t38;
        const real_t t50 = -(t45 * t49);
        const real_t t51 = -(t49 * t46);
        t47 = tb_min(t50, t51);
        t48 = tb_max(t50, t51);
    }
    const real_t t52 = t36 + t9 * t37;
    const bool t53 = TB_ABS(t52) <= t39;
    real_t t54, t55;
    if (t53) {
        t54 = -TB_C(1000000000000.0);
        t55 = TB_C(1000000000000.0);
    } else {
        const real_t t56 = TB_C(1.0) / t52;
        const real_t t57 = -(t45 * t56);
        const real_t t58 = -(t46 * t56);
        t54 = tb_min(t57, t58);
        t55 = tb_max(t57, t58);
    }
    const real_t t59 = t34 - t15 * t37;
    const bool t60 = TB_ABS(t59) <= t39;
    real_t t61, t62;
    if (t60) {
        t61 = -TB_C(1000000000000.0);
        t62 = TB_C(1000000000000.0);
    } else {
        const real_t t63 = TB_C(1.0) / t59;
        const real_t t64 = t45 * t63;
        const real_t t65 = t46 * t63;
        t61 = tb_min(t64, t65);
        t62 = tb_max(t64, t65);
    }
    const real_t t66 = tb_min(tb_max(TB_C(0.0), tb_max(tb_max(t47, t54), t61)),
        tb_min(tb_min(t48, t55), t62));
    const real_t t67 = tb_min(tb_max(-(t38 * t66), TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t tension_0 = t23 ? t67 : TB_TENSION_MIN;
    const real_t t68 = tb_min(tb_max(-(t52 * t66), TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t tension_1 = t23 ? t68 : TB_TENSION_MIN;
    const real_t t69 = tb_min(tb_max(t59 * t66, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t tension_2 = t23 ? t69 : TB_TENSION_MIN;
    const bool t70 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t71 = !(t70 && TB_C(0.0001) < length_2);
    const real_t t72 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t73 = !(t72 < t41 && t72 < t42);
    const real_t t74 = tb_max(TB_C(0.0), TB_ABS(t3 * t67 + t9 * t68 + t15 * t69));
    const real_t t75 = tb_max(t74, TB_ABS(t8 * t67 + t7 * t68 + t14 * t69));
    const bool t76 = !(t24 || t75 <= t43 * (TB_EPSILON * TB_C(1280.0)));
    if (t71 || t73) {
        return tb_refuse_zero_wrench_tension(TB_SINGULAR, tension);
    }
    if (t76) {
        return tb_refuse_zero_wrench_tension(TB_INACCURATE, tension);
    }
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    return t24 ? TB_INFEASIBLE : TB_OK;
}

/* Refuses with a status: factor is 0. */
static tb_status tb_refuse_tension_factor(tb_status status, real_t factor[1])
{
    factor[0] = TB_C(0.0);
    return status;
}

tb_status tb_tension_factor(const real_t pose[2], const real_t rails[6], real_t factor[1])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) +
              TB_ABS(rails[4]) + TB_ABS(rails[5]) <= TB_C(8.541599999999999))) {
        return tb_refuse_tension_factor(TB_OUT_OF_DOMAIN, factor);
    }
    const real_t t0 = rails[0] - pose[0];
    const real_t t1 = TB_FRAME - rails[1] - pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 * t0 + t1 * t1);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t t3 = t0 * t2;
    const real_t t4 = rails[2] - pose[1];
    const real_t t5 = rails[3] - pose[0];
    const real_t length_1 = TB_SQRT(t5 * t5 + t4 * t4);
    const real_t t6 = TB_C(1.0) / length_1;
    const real_t t7 = t4 * t6;
    const real_t t8 = t1 * t2;
    const real_t t9 = t5 * t6;
    const real_t t10 = TB_ABS(t3 * t7 - t8 * t9);
    const real_t t11 = rails[4] - pose[1];
    const real_t t12 = TB_FRAME - rails[5] - pose[0];
    const real_t length_2 = TB_SQRT(t12 * t12 + t11 * t11);
    const real_t t13 = TB_C(1.0) / length_2;
    const real_t t14 = t11 * t13;
    const real_t t15 = t12 * t13;
    const real_t t16 = TB_ABS(t3 * t14 - t8 * t15);
    const real_t t17 = TB_TENSION_MIDDLE * (t14 + (t7 + t8));
    const real_t t18 = TB_TENSION_MIDDLE * (t15 + (t3 + t9));
    const real_t t19 = TB_TENSION_HALF_RANGE * (t10 + t16) - TB_ABS(t3 * t17 - t8 * t18);
    const real_t t20 = TB_ABS(t9 * t14 - t7 * t15);
    const real_t t21 = TB_TENSION_HALF_RANGE * (t10 + t20) - TB_ABS(t9 * t17 - t7 * t18);
    const real_t t22 = TB_TENSION_HALF_RANGE * (t16 + t20) - TB_ABS(t15 * t17 - t14 * t18);
    const bool t23 = TB_C(0.0) <= tb_min(tb_min(t19, t21), t22);
    const real_t t24 = TB_SQRT(t3 * t3 + t9 * t9 + t15 * t15);
    const real_t t25 = TB_COPYSIGN(t24, t3);
    const real_t t26 = t3 + t25;
    const real_t t27 = TB_C(1.0) / (t24 * (t24 + TB_ABS(t3)));
    const real_t t28 = (t8 * t26 + t7 * t9 + t14 * t15) * t27;
    const real_t t29 = t14 - t15 * t28;
    const real_t t30 = t7 - t9 * t28;
    const real_t t31 = TB_SQRT(t30 * t30 + t29 * t29);
    const real_t t32 = t29 / (t31 * (t31 + TB_ABS(t30)));
    const real_t t33 = TB_C(1.0) - t29 * t32;
    const real_t t34 = TB_COPYSIGN(t31, t30);
    const real_t t35 = t32 * (t30 + t34);
    const real_t t36 = t27 * (t15 * t33 - t9 * t35);
    const real_t t37 = t26 * t36;
    const real_t t38 = TB_C(16.0) * TB_EPSILON;
    const bool t39 = TB_ABS(t37) <= t38;
    const real_t t40 = TB_ABS(t25);
    const real_t t41 = TB_ABS(t34);
    const real_t t42 = TB_EPSILON * TB_C(30.0) / tb_min(t40, t41);
    const real_t t43 = TB_TENSION_MIN - t42;
    const real_t t44 = t42 + TB_TENSION_MAX;
    real_t t45, t46;
    if (t39) {
        t45 = -TB_C(1000000000000.0);
        t46 = TB_C(1000000000000.0);
    } else {
        const real_t t47 = TB_C(1.0) / t37;
        const real_t t48 = -(t43 * t47);
        const real_t t49 = -(t47 * t44);
        t45 = tb_min(t48, t49);
        t46 = tb_max(t48, t49);
    }
    const real_t t50 = t35 + t9 * t36;
    const bool t51 = TB_ABS(t50) <= t38;
    real_t t52, t53;
    if (t51) {
        t52 = -TB_C(1000000000000.0);
        t53 = TB_C(1000000000000.0);
    } else {
        const real_t t54 = TB_C(1.0) / t50;
        const real_t t55 = -(t43 * t54);
        const real_t t56 = -(t44 * t54);
        t52 = tb_min(t55, t56);
        t53 = tb_max(t55, t56);
    }
    const real_t t57 = t33 - t15 * t36;
    const bool t58 = TB_ABS(t57) <= t38;
    real_t t59, t60;
    if (t58) {
        t59 = -TB_C(1000000000000.0);
        t60 = TB_C(1000000000000.0);
    } else {
        const real_t t61 = TB_C(1.0) / t57;
        const real_t t62 = t43 * t61;
        const real_t t63 = t44 * t61;
        t59 = tb_min(t62, t63);
        t60 = tb_max(t62, t63);
    }
    const real_t t64 = tb_min(tb_max(TB_C(0.0), tb_max(tb_max(t45, t52), t59)),
        tb_min(tb_min(t46, t53), t60));
    /* T0 */
    const real_t rest_0 = tb_min(tb_max(-(t37 * t64), TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t rest_1 = tb_min(tb_max(-(t50 * t64), TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t rest_2 = tb_min(tb_max(t57 * t64, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t t65 = tb_max(tb_max(rest_0, rest_1), rest_2);
    real_t factor_0;
    if (t23) {
        factor_0 = tb_min(tb_min(rest_0, rest_1), rest_2) / t65;
    } else {
        factor_0 = TB_C(0.0);
    }
    const bool t66 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t67 = !(t66 && TB_C(0.0001) < length_2);
    const real_t t68 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t69 = !(t68 < t40 && t68 < t41);
    const bool t70 = !(TB_C(0.0) < t65);
    const bool t71 = !t23;
    if (t67 || t69 || t70) {
        return tb_refuse_tension_factor(TB_SINGULAR, factor);
    }
    factor[0] = factor_0;
    return t71 ? TB_INFEASIBLE : TB_OK;
}

/* Refuses with a status: force is 0 N. */
static tb_status tb_refuse_isotropic_force(tb_status status, real_t force[1])
{
    force[0] = TB_C(0.0);
    return status;
}

tb_status tb_isotropic_force(const real_t pose[2], const real_t rails[6], real_t force[1])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) +
              TB_ABS(rails[4]) + TB_ABS(rails[5]) <= TB_C(8.541599999999999))) {
        return tb_refuse_isotropic_force(TB_OUT_OF_DOMAIN, force);
    }
    const real_t t0 = rails[0] - pose[0];
    const real_t t1 = TB_FRAME - rails[1] - pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 * t0 + t1 * t1);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t t3 = t0 * t2;
    const real_t t4 = rails[2] - pose[1];
    const real_t t5 = rails[3] - pose[0];
    const real_t length_1 = TB_SQRT(t5 * t5 + t4 * t4);
    const real_t t6 = TB_C(1.0) / length_1;
    const real_t t7 = t4 * t6;
    const real_t t8 = t1 * t2;
    const real_t t9 = t5 * t6;
    const real_t t10 = TB_ABS(t3 * t7 - t8 * t9);
    const real_t t11 = rails[4] - pose[1];
    const real_t t12 = TB_FRAME - rails[5] - pose[0];
    const real_t length_2 = TB_SQRT(t12 * t12 + t11 * t11);
    const real_t t13 = TB_C(1.0) / length_2;
    const real_t t14 = t11 * t13;
    const real_t t15 = t12 * t13;
    const real_t t16 = TB_ABS(t3 * t14 - t8 * t15);
    const real_t t17 = TB_TENSION_MIDDLE * (t14 + (t7 + t8));
    const real_t t18 = TB_TENSION_MIDDLE * (t15 + (t3 + t9));
    const real_t t19 = TB_TENSION_HALF_RANGE * (t10 + t16) - TB_ABS(t3 * t17 - t8 * t18);
    const real_t t20 = TB_ABS(t9 * t14 - t7 * t15);
    const real_t t21 = TB_TENSION_HALF_RANGE * (t10 + t20) - TB_ABS(t9 * t17 - t7 * t18);
    const real_t t22 = TB_TENSION_HALF_RANGE * (t16 + t20) - TB_ABS(t15 * t17 - t14 * t18);
    const real_t t23 = tb_min(tb_min(t19, t21), t22);
    const real_t force_0 = tb_max(TB_C(0.0), t23);
    const bool t24 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t25 = !(t24 && TB_C(0.0001) < length_2);
    const bool t26 = !(TB_C(0.0) <= t23);
    if (t25) {
        return tb_refuse_isotropic_force(TB_SINGULAR, force);
    }
    force[0] = force_0;
    return t26 ? TB_INFEASIBLE : TB_OK;
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

tb_status tb_pose_quality(const real_t pose[2], const real_t rails[6], real_t margin[1],
    real_t factor[1], real_t force[1])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) +
              TB_ABS(rails[4]) + TB_ABS(rails[5]) <= TB_C(8.541599999999999))) {
        return tb_refuse_pose_quality(TB_OUT_OF_DOMAIN, margin, factor, force);
    }
    const real_t t0 = rails[0] - pose[0];
    const real_t t1 = TB_FRAME - rails[1] - pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 * t0 + t1 * t1);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t t3 = t0 * t2;
    const real_t t4 = rails[2] - pose[1];
    const real_t t5 = rails[3] - pose[0];
    const real_t length_1 = TB_SQRT(t5 * t5 + t4 * t4);
    const real_t t6 = TB_C(1.0) / length_1;
    const real_t t7 = t4 * t6;
    const real_t t8 = t1 * t2;
    const real_t t9 = t5 * t6;
    const real_t t10 = t3 * t7 - t8 * t9;
    const real_t t11 = TB_ABS(t10);
    const real_t t12 = rails[4] - pose[1];
    const real_t t13 = TB_FRAME - rails[5] - pose[0];
    const real_t length_2 = TB_SQRT(t13 * t13 + t12 * t12);
    const real_t t14 = TB_C(1.0) / length_2;
    const real_t t15 = t12 * t14;
    const real_t t16 = t13 * t14;
    const real_t t17 = t3 * t15 - t8 * t16;
    const real_t t18 = TB_ABS(t17);
    const real_t t19 = TB_TENSION_MIDDLE * (t15 + (t7 + t8));
    const real_t t20 = TB_TENSION_MIDDLE * (t16 + (t3 + t9));
    const real_t t21 = t3 * t19 - t8 * t20;
    const real_t t22 = t9 * t15 - t7 * t16;
    const real_t t23 = TB_ABS(t22);
    const real_t t24 = t9 * t19 - t7 * t20;
    const real_t t25 = tb_min(TB_TENSION_HALF_RANGE * (t11 + t18) - TB_ABS(t21),
        TB_TENSION_HALF_RANGE * (t11 + t23) - TB_ABS(t24));
    const real_t t26 = t16 * t19 - t15 * t20;
    const real_t margin_0 = tb_min(t25, TB_TENSION_HALF_RANGE * (t18 + t23) - TB_ABS(t26));
    const bool t27 = TB_C(0.0) <= margin_0;
    real_t factor_0, t28;
    if (t27) {
        const real_t t29 = TB_C(0.46153846153846156) * tb_max(TB_ABS(t20), TB_ABS(t19));
        const real_t t30 = TB_C(120.0) * TB_EPSILON;
        const bool t31 = t29 <= t30;
        real_t t32, t33, t34, t35, t36, t37, t38, t39;
        if (t31) {
            t32 = TB_C(0.0);
            t33 = TB_C(0.0);
            t34 = TB_C(0.0);
            t35 = TB_C(0.0);
            t36 = TB_C(0.0);
            t37 = TB_C(0.0);
            t38 = TB_C(0.0);
            t39 = TB_C(0.0);
        } else {
            const real_t t40 = -(t3 * t20 + t8 * t19);
            const real_t t41 = TB_C(0.0) <= t21 ? t40 : -TB_C(1e+30);
            const real_t t42 = -(t9 * t20 + t7 * t19);
            const real_t t43 = TB_C(0.0) <= t24 ? t42 : -TB_C(1e+30);
            const real_t t44 = -(t16 * t20 + t15 * t19);
            const bool t45 = tb_max(t41, t43) < (TB_C(0.0) <= t26 ? t44 : -TB_C(1e+30));
            const bool t46 = t41 < t43;
            const real_t t47 = t45 ? t16 : (t46 ? t9 : t3);
            const real_t t48 = t45 ? t15 : (t46 ? t7 : t8);
            const real_t t49 = TB_C(0.46153846153846156) * (t19 * t47 - t20 * t48);
            const real_t t50 = t21 < TB_C(0.0) ? t40 : -TB_C(1e+30);
            const real_t t51 = t24 < TB_C(0.0) ? t42 : -TB_C(1e+30);
            const bool t52 = tb_max(t50, t51) < (t26 < TB_C(0.0) ? t44 : -TB_C(1e+30));
            const bool t53 = t50 < t51;
            const real_t t54 = t52 ? t16 : (t53 ? t9 : t3);
            const real_t t55 = t52 ? t15 : (t53 ? t7 : t8);
            const real_t t56 = TB_C(1.0) / (t48 * t54 - t47 * t55);
            const real_t t57 = TB_TENSION_MIN + t49 * t56;
            const real_t t58 = TB_C(0.46153846153846156) * (t19 * t54 - t20 * t55);
            const real_t t59 = TB_TENSION_MIN - t56 * t58;
            const real_t t60 = t56 * (t48 * t57 - t55 * t59);
            const real_t t61 = t56 * (t54 * t59 - t47 * t57);
            t32 = t3 * t60;
            t33 = t8 * t61;
            t34 = t9 * t60;
            t35 = t7 * t61;
            t36 = t16 * t60;
            t37 = t15 * t61;
            t38 = t60;
            t39 = t61;
        }
        const real_t t62 = t32 + t33;
        const real_t t63 = tb_min(tb_max(t62, TB_TENSION_MIN), TB_TENSION_MAX);
        const real_t t64 = t34 + t35;
        const real_t t65 = tb_min(tb_max(t64, TB_TENSION_MIN), TB_TENSION_MAX);
        const real_t t66 = t36 + t37;
        const real_t t67 = tb_min(tb_max(t66, TB_TENSION_MIN), TB_TENSION_MAX);
        const real_t t68 = t3 * t63 + t9 * t65 + t16 * t67;
        const real_t t69 = t8 * t63 + t7 * t65 + t15 * t67;
        const bool t70 = tb_max(TB_ABS(t68), TB_ABS(t69)) - t30 <= TB_C(0.0);
        real_t t71, t72;
        if (t70) {
            const real_t t73 = tb_min(tb_min(t63, t65), t67) / tb_max(tb_max(t63, t65), t67);
            t71 = t73;
            t72 = TB_C(0.0);
        } else {
            const bool t74 = TB_TENSION_MIN < t62 && t62 < TB_TENSION_MAX;
            const real_t t75 = t3 * t3;
            const bool t76 = TB_TENSION_MIN < t64 && t64 < TB_TENSION_MAX;
            const real_t t77 = t9 * t9;
            const real_t t78 = (t74 ? t75 : TB_C(0.0)) + (t76 ? t77 : TB_C(0.0));
            const bool t79 = TB_TENSION_MIN < t66 && t66 < TB_TENSION_MAX;
            const real_t t80 = t16 * t16;
            const real_t t81 = t78 + (t79 ? t80 : TB_C(0.0));
            const real_t t82 = TB_C(1.0) / t81;
            const real_t t83 = t7 * t9;
            const real_t t84 = (t74 ? t3 * t8 : TB_C(0.0)) + (t76 ? t83 : TB_C(0.0));
            const real_t t85 = t15 * t16;
            const real_t t86 = t82 * (t84 + (t79 ? t85 : TB_C(0.0)));
            const real_t t87 = (t74 ? t8 * t8 : TB_C(0.0)) + (t76 ? t7 * t7 : TB_C(0.0));
            const real_t t88 = t87 + (t79 ? t15 * t15 : TB_C(0.0)) - t81 * (t86 * t86);
            const real_t t89 = (t69 - t68 * t86) / t88;
            const real_t t90 = t38 - (t68 * t82 - t86 * t89);
            const real_t t91 = t39 - t89;
            const real_t t92 = tb_min(tb_max(t3 * t90 + t8 * t91, TB_TENSION_MIN),
                TB_TENSION_MAX);
            const real_t t93 = tb_min(tb_max(t9 * t90 + t7 * t91, TB_TENSION_MIN),
                TB_TENSION_MAX);
            const real_t t94 = tb_min(tb_max(t16 * t90 + t15 * t91, TB_TENSION_MIN),
                TB_TENSION_MAX);
            const real_t t95 = tb_max(TB_ABS(t3 * t92 + t9 * t93 + t16 * t94), TB_ABS(t8 * t92
                + t7 * t93 + t15 * t94));
            const bool t96 = t95 - t30 <= TB_C(0.0);
            real_t t97, t98;
            if (t96) {
                const real_t t99 = tb_min(tb_min(t92, t93), t94) / tb_max(tb_max(t92, t93),
                    t94);
                t97 = t99;
                t98 = TB_C(0.0);
            } else {
                const real_t t100 = TB_SQRT(t80 + (t75 + t77));
                const real_t t101 = TB_COPYSIGN(t100, t3);
                const real_t t102 = t3 + t101;
                const real_t t103 = TB_C(1.0) / (t100 * (t100 + TB_ABS(t3)));
                const real_t t104 = (t85 + (t83 + t8 * t102)) * t103;
                const real_t t105 = t15 - t16 * t104;
                const real_t t106 = t7 - t9 * t104;
                const real_t t107 = TB_SQRT(t106 * t106 + t105 * t105);
                const real_t t108 = t105 / (t107 * (t107 + TB_ABS(t106)));
                const real_t t109 = TB_C(1.0) - t105 * t108;
                const real_t t110 = TB_COPYSIGN(t107, t106);
                const real_t t111 = t108 * (t106 + t110);
                const real_t t112 = t103 * (t16 * t109 - t9 * t111);
                const real_t t113 = t102 * t112;
                const real_t t114 = TB_EPSILON * TB_C(16.0);
                const bool t115 = TB_ABS(t113) <= t114;
                const real_t t116 = TB_C(1.0) / tb_min(TB_ABS(t101), TB_ABS(t110));
                const real_t t117 = TB_EPSILON * TB_C(30.0) * t116;
                const real_t t118 = TB_TENSION_MIN - t117;
                const real_t t119 = TB_TENSION_MAX + t117;
                real_t t120, t121;
                if (t115) {
                    t120 = -TB_C(1000000000000.0);
                    t121 = TB_C(1000000000000.0);
                } else {
                    const real_t t122 = TB_C(1.0) / t113;
                    const real_t t123 = -(t118 * t122);
                    const real_t t124 = -(t122 * t119);
                    t120 = tb_min(t123, t124);
                    t121 = tb_max(t123, t124);
                }
                const real_t t125 = t111 + t9 * t112;
                const bool t126 = TB_ABS(t125) <= t114;
                real_t t127, t128;
                if (t126) {
                    t127 = -TB_C(1000000000000.0);
                    t128 = TB_C(1000000000000.0);
                } else {
                    const real_t t129 = TB_C(1.0) / t125;
                    const real_t t130 = -(t118 * t129);
                    const real_t t131 = -(t119 * t129);
                    t127 = tb_min(t130, t131);
                    t128 = tb_max(t130, t131);
                }
                const real_t t132 = t109 - t16 * t112;
                const bool t133 = TB_ABS(t132) <= t114;
                real_t t134, t135;
                if (t133) {
                    t134 = -TB_C(1000000000000.0);
                    t135 = TB_C(1000000000000.0);
                } else {
                    const real_t t136 = TB_C(1.0) / t132;
                    const real_t t137 = t118 * t136;
                    const real_t t138 = t119 * t136;
                    t134 = tb_min(t137, t138);
                    t135 = tb_max(t137, t138);
                }
                const real_t t139 = tb_max(TB_C(0.0), tb_max(tb_max(t120, t127), t134));
                const real_t t140 = tb_min(t139, tb_min(tb_min(t121, t128), t135));
                const real_t t141 = tb_min(tb_max(-(t113 * t140), TB_TENSION_MIN),
                    TB_TENSION_MAX);
                const real_t t142 = tb_min(tb_max(-(t125 * t140), TB_TENSION_MIN),
                    TB_TENSION_MAX);
                const real_t t143 = tb_min(tb_max(t132 * t140, TB_TENSION_MIN), TB_TENSION_MAX);
                const real_t t144 = tb_min(tb_min(t141, t142), t143) / tb_max(tb_max(t141,
                    t142), t143);
                const real_t t145 = tb_max(TB_C(0.0), TB_ABS(t3 * t141 + t9 * t142 + t16 *
                    t143));
                const real_t t146 = tb_max(t145, TB_ABS(t8 * t141 + t7 * t142 + t15 * t143));
                t97 = t144;
                t98 = t146 - t116 * (TB_EPSILON * TB_C(1280.0));
            }
            t71 = t97;
            t72 = t98;
        }
        factor_0 = t71;
        t28 = t72;
    } else {
        factor_0 = TB_C(0.0);
        t28 = TB_C(0.0);
    }
    const real_t force_0 = tb_max(TB_C(0.0), margin_0);
    const bool t147 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t148 = !(t147 && TB_C(0.0001) < length_2);
    const real_t t149 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const real_t t150 = (t10 * t10 + t17 * t17 + t22 * t22) * TB_C(0.6666666666666666);
    const bool t151 = !(t149 * t149 < t150);
    const bool t152 = !(t28 <= TB_C(0.0));
    const bool t153 = !t27;
    if (t148 || t151) {
        return tb_refuse_pose_quality(TB_SINGULAR, margin, factor, force);
    }
    if (t152) {
        return tb_refuse_pose_quality(TB_INACCURATE, margin, factor, force);
    }
    margin[0] = margin_0;
    factor[0] = factor_0;
    force[0] = force_0;
    return t153 ? TB_INFEASIBLE : TB_OK;
}

/* Refuses with a status: force is 0 N. */
static tb_status tb_refuse_isotropic_force_eq17(tb_status status, real_t force[1])
{
    force[0] = TB_C(0.0);
    return status;
}

tb_status tb_isotropic_force_eq17(const real_t pose[2], const real_t rails[6], real_t force[1])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) +
              TB_ABS(rails[4]) + TB_ABS(rails[5]) <= TB_C(8.541599999999999))) {
        return tb_refuse_isotropic_force_eq17(TB_OUT_OF_DOMAIN, force);
    }
    const real_t t0 = rails[0] - pose[0];
    const real_t t1 = TB_FRAME - rails[1] - pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 * t0 + t1 * t1);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t t3 = t0 * t2;
    const real_t t4 = rails[2] - pose[1];
    const real_t t5 = rails[3] - pose[0];
    const real_t length_1 = TB_SQRT(t5 * t5 + t4 * t4);
    const real_t t6 = TB_C(1.0) / length_1;
    const real_t t7 = t4 * t6;
    const real_t t8 = t3 * t7;
    const real_t t9 = t1 * t2;
    const real_t t10 = t5 * t6;
    const real_t t11 = t9 * t10;
    const real_t t12 = t8 - t11;
    const real_t t13 = TB_ABS(t12);
    const real_t t14 = rails[4] - pose[1];
    const real_t t15 = TB_FRAME - rails[5] - pose[0];
    const real_t length_2 = TB_SQRT(t15 * t15 + t14 * t14);
    const real_t t16 = TB_C(1.0) / length_2;
    const real_t t17 = t14 * t16;
    const real_t t18 = t3 * t17;
    const real_t t19 = t15 * t16;
    const real_t t20 = t9 * t19;
    const real_t t21 = t18 - t20;
    const real_t t22 = TB_ABS(t21);
    const real_t t23 = TB_TENSION_MIDDLE * (t17 + (t7 + t9));
    const real_t t24 = TB_TENSION_MIDDLE * (t19 + (t3 + t10));
    const real_t t25 = TB_TENSION_HALF_RANGE * (t13 + t22) - TB_ABS(t3 * t23 - t9 * t24);
    const real_t t26 = t10 * t17;
    const real_t t27 = t7 * t19;
    const real_t t28 = t26 - t27;
    const real_t t29 = TB_ABS(t28);
    const real_t t30 = TB_TENSION_HALF_RANGE * (t13 + t29) - TB_ABS(t10 * t23 - t7 * t24);
    const real_t t31 = TB_TENSION_HALF_RANGE * (t22 + t29) - TB_ABS(t19 * t23 - t17 * t24);
    const bool t32 = TB_C(0.0) <= tb_min(tb_min(t25, t30), t31);
    const real_t t33 = TB_SQRT(t3 * t3 + t10 * t10 + t19 * t19);
    const real_t t34 = TB_COPYSIGN(t33, t3);
    const real_t t35 = t3 + t34;
    const real_t t36 = TB_C(1.0) / (t33 * (t33 + TB_ABS(t3)));
    const real_t t37 = (t9 * t35 + t7 * t10 + t17 * t19) * t36;
    const real_t t38 = t17 - t19 * t37;
    const real_t t39 = t7 - t10 * t37;
    const real_t t40 = TB_SQRT(t39 * t39 + t38 * t38);
    const real_t t41 = TB_COPYSIGN(t40, t39);
    const real_t t42 = TB_ABS(t34);
    const real_t t43 = TB_ABS(t41);
    real_t force_0;
    if (t32) {
        const bool t44 = TB_C(0.0) < t12;
        const bool t45 = t3 * t10 + t7 * t9 < TB_C(0.0);
        const bool t46 = TB_C(0.0) < t21;
        const real_t t47 = t27 - t26;
        const bool t48 = TB_C(0.0) < t47;
        const bool t49 = (t44 || (TB_C(0.0) <= t12 && t45)) && !(t46 && t48);
        const real_t t50 = t38 / (t40 * (t40 + TB_ABS(t39)));
        const real_t t51 = TB_C(1.0) - t38 * t50;
        const real_t t52 = t50 * (t39 + t41);
        const real_t t53 = t36 * (t19 * t51 - t10 * t52);
        const real_t t54 = t35 * t53;
        const real_t t55 = TB_C(16.0) * TB_EPSILON;
        const bool t56 = TB_ABS(t54) <= t55;
        const real_t t57 = TB_EPSILON * TB_C(30.0) / tb_min(t42, t43);
        const real_t t58 = TB_TENSION_MIN - t57;
        const real_t t59 = TB_TENSION_MAX + t57;
        real_t t60, t61;
        if (t56) {
            t60 = -TB_C(1000000000000.0);
            t61 = TB_C(1000000000000.0);
        } else {
            const real_t t62 = TB_C(1.0) / t54;
            const real_t t63 = -(t58 * t62);
            const real_t t64 = -(t62 * t59);
            t60 = tb_min(t63, t64);
            t61 = tb_max(t63, t64);
        }
        const real_t t65 = t52 + t10 * t53;
        const bool t66 = TB_ABS(t65) <= t55;
        real_t t67, t68;
        if (t66) {
            t67 = -TB_C(1000000000000.0);
            t68 = TB_C(1000000000000.0);
        } else {
            const real_t t69 = TB_C(1.0) / t65;
            const real_t t70 = -(t58 * t69);
            const real_t t71 = -(t59 * t69);
            t67 = tb_min(t70, t71);
            t68 = tb_max(t70, t71);
        }
        const real_t t72 = t51 - t19 * t53;
        const bool t73 = TB_ABS(t72) <= t55;
        real_t t74, t75;
        if (t73) {
            t74 = -TB_C(1000000000000.0);
            t75 = TB_C(1000000000000.0);
        } else {
            const real_t t76 = TB_C(1.0) / t72;
            const real_t t77 = t58 * t76;
            const real_t t78 = t59 * t76;
            t74 = tb_min(t77, t78);
            t75 = tb_max(t77, t78);
        }
        const real_t t79 = tb_min(tb_max(TB_C(0.0), tb_max(tb_max(t60, t67), t74)),
            tb_min(tb_min(t61, t68), t75));
        const real_t t80 = tb_min(tb_max(-(t54 * t79), TB_TENSION_MIN), TB_TENSION_MAX);
        /* t_i = T_max - T0_i */
        const real_t margin_0 = TB_TENSION_MAX - t80;
        const real_t t81 = tb_min(tb_max(-(t65 * t79), TB_TENSION_MIN), TB_TENSION_MAX);
        const real_t margin_1 = TB_TENSION_MAX - t81;
        const real_t t82 = tb_min(margin_0, margin_1);
        const bool t83 = t3 * t19 + t9 * t17 < TB_C(0.0);
        const bool t84 = TB_C(0.0) < t28;
        const bool t85 = (t46 || (TB_C(0.0) <= t21 && t83)) && !(t44 && t84);
        const real_t margin_2 = TB_TENSION_MAX - tb_min(tb_max(t72 * t79, TB_TENSION_MIN),
            TB_TENSION_MAX);
        const real_t t86 = tb_min(margin_0, margin_2);
        const real_t t87 = tb_min(t49 ? (t45 ? t12 * t82 : t82) : TB_C(1e+30), t85 ? (t83 ? t21
            * t86 : t86) : TB_C(1e+30));
        const real_t t88 = t11 - t8;
        const bool t89 = TB_C(0.0) < t88;
        const real_t t90 = t20 - t18;
        const bool t91 = TB_C(0.0) < t90;
        const bool t92 = (t89 || (t45 && TB_C(0.0) <= t88)) && !(t84 && t91);
        const real_t t93 = tb_min(margin_1, margin_0);
        const real_t t94 = tb_min(t87, t92 ? (t45 ? -(t12 * t93) : t93) : TB_C(1e+30));
        const bool t95 = t10 * t19 + t7 * t17 < TB_C(0.0);
        const bool t96 = (t84 || (TB_C(0.0) <= t28 && t95)) && !(t46 && t89);
        const real_t t97 = tb_min(margin_1, margin_2);
        const real_t t98 = tb_min(t94, t96 ? (t95 ? t28 * t97 : t97) : TB_C(1e+30));
        const bool t99 = (t91 || (t83 && TB_C(0.0) <= t90)) && !(t48 && t89);
        const real_t t100 = tb_min(margin_2, margin_0);
        const real_t t101 = tb_min(t98, t99 ? (t83 ? -(t21 * t100) : t100) : TB_C(1e+30));
        const bool t102 = (t48 || (t95 && TB_C(0.0) <= t47)) && !(t44 && t91);
        const real_t t103 = tb_min(margin_2, margin_1);
        const real_t t104 = t102 ? (t95 ? -(t28 * t103) : t103) : TB_C(1e+30);
        force_0 = tb_min(t101, t104);
    } else {
        force_0 = TB_C(0.0);
    }
    const bool t105 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t106 = !(t105 && TB_C(0.0001) < length_2);
    const real_t t107 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t108 = !(t107 < t42 && t107 < t43);
    const bool t109 = !t32;
    if (t106 || t108) {
        return tb_refuse_isotropic_force_eq17(TB_SINGULAR, force);
    }
    force[0] = force_0;
    return t109 ? TB_INFEASIBLE : TB_OK;
}

