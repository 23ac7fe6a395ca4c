/* Regenerate: turnbuckle generate machines/planar_rigid.toml --out <this folder>
 * Machine 95fa38e7104ced7a, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_quality.h"
#include "tb_kinematics.h"
#include "tb_tension.h"
#include "tb_machine.h"

/* Before the first subset. */
static tb_status tb_balance_begin(const real_t structure[18], real_t weighed[18], real_t margin[1])
{
    const real_t weighed_12 = TB_MOMENT_WEIGHT * structure[12];
    const real_t weighed_13 = TB_MOMENT_WEIGHT * structure[13];
    const real_t weighed_14 = TB_MOMENT_WEIGHT * structure[14];
    const real_t weighed_15 = TB_MOMENT_WEIGHT * structure[15];
    const real_t weighed_16 = TB_MOMENT_WEIGHT * structure[16];
    const real_t weighed_17 = TB_MOMENT_WEIGHT * structure[17];
    const real_t t0 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const real_t t1 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t2 = t1 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t3 = t2 + structure[4] * structure[4] + structure[5] * structure[5];
    const real_t t4 = TB_SQRT(t3);
    const real_t t5 = TB_COPYSIGN(t4, structure[0]);
    const real_t t6 = structure[0] + t5;
    const real_t t7 = structure[6] * t6 + structure[1] * structure[7] + structure[2] *
        structure[8];
    const real_t t8 = t7 + structure[3] * structure[9] + structure[4] * structure[10];
    const real_t t9 = TB_C(1.0) / (t4 * (t4 + TB_ABS(structure[0])));
    const real_t t10 = (t8 + structure[5] * structure[11]) * t9;
    const real_t t11 = structure[7] - structure[1] * t10;
    const real_t t12 = structure[8] - structure[2] * t10;
    const real_t t13 = structure[9] - structure[3] * t10;
    const real_t t14 = structure[10] - structure[4] * t10;
    const real_t t15 = structure[11] - structure[5] * t10;
    const real_t t16 = t11 * t11 + t12 * t12 + t13 * t13 + t14 * t14 + t15 * t15;
    const real_t t17 = TB_SQRT(t16);
    const real_t t18 = TB_COPYSIGN(t17, t11);
    const real_t t19 = weighed_12 * t6 + structure[1] * weighed_13 + structure[2] * weighed_14;
    const real_t t20 = t19 + structure[3] * weighed_15 + structure[4] * weighed_16;
    const real_t t21 = t9 * (t20 + structure[5] * weighed_17);
    const real_t t22 = weighed_14 - structure[2] * t21;
    const real_t t23 = (t11 + t18) * (weighed_13 - structure[1] * t21) + t12 * t22;
    const real_t t24 = weighed_15 - structure[3] * t21;
    const real_t t25 = weighed_16 - structure[4] * t21;
    const real_t t26 = weighed_17 - structure[5] * t21;
    const real_t t27 = (t23 + t13 * t24 + t14 * t25 + t15 * t26) * (TB_C(1.0) / (t17 * (t17 +
        TB_ABS(t11))));
    const real_t t28 = t22 - t12 * t27;
    const real_t t29 = t24 - t13 * t27;
    const real_t t30 = t25 - t14 * t27;
    const real_t t31 = t26 - t15 * t27;
    const real_t t32 = TB_SQRT(t28 * t28 + t29 * t29 + t30 * t30 + t31 * t31);
    const bool t33 = t0 < TB_ABS(t5) && t0 < TB_ABS(t18) && t0 < TB_ABS(TB_COPYSIGN(t32, t28));
    const bool t34 = !t33;
    if (t34) {
        weighed[0] = TB_C(0.0);
        weighed[1] = TB_C(0.0);
        weighed[2] = TB_C(0.0);
        weighed[3] = TB_C(0.0);
        weighed[4] = TB_C(0.0);
        weighed[5] = TB_C(0.0);
        weighed[6] = TB_C(0.0);
        weighed[7] = TB_C(0.0);
        weighed[8] = TB_C(0.0);
        weighed[9] = TB_C(0.0);
        weighed[10] = TB_C(0.0);
        weighed[11] = TB_C(0.0);
        weighed[12] = TB_C(0.0);
        weighed[13] = TB_C(0.0);
        weighed[14] = TB_C(0.0);
        weighed[15] = TB_C(0.0);
        weighed[16] = TB_C(0.0);
        weighed[17] = TB_C(0.0);
        margin[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    weighed[0] = structure[0];
    weighed[1] = structure[1];
    weighed[2] = structure[2];
    weighed[3] = structure[3];
    weighed[4] = structure[4];
    weighed[5] = structure[5];
    weighed[6] = structure[6];
    weighed[7] = structure[7];
    weighed[8] = structure[8];
    weighed[9] = structure[9];
    weighed[10] = structure[10];
    weighed[11] = structure[11];
    weighed[12] = weighed_12;
    weighed[13] = weighed_13;
    weighed[14] = weighed_14;
    weighed[15] = weighed_15;
    weighed[16] = weighed_16;
    weighed[17] = weighed_17;
    margin[0] = TB_C(1e+30);
    return TB_OK;
}

/* One subset. */
static tb_status tb_balance_visit(const real_t chosen[6], const real_t numbers[2],
    const real_t weighed[18], real_t margin[1])
{
    const real_t t0 = chosen[2] * chosen[5] - chosen[4] * chosen[3];
    const real_t t1 = chosen[4] * chosen[1] - chosen[5] * chosen[0];
    const real_t t2 = chosen[3] * chosen[0] - chosen[2] * chosen[1];
    const real_t t3 = chosen[0] * chosen[0] + chosen[2] * chosen[2] + chosen[4] * chosen[4];
    const real_t t4 = (t0 * chosen[0] + chosen[2] * t1 + chosen[4] * t2) / t3;
    const real_t t5 = t0 - chosen[0] * t4;
    const real_t t6 = t1 - chosen[2] * t4;
    const real_t t7 = t2 - chosen[4] * t4;
    const real_t t8 = TB_SQRT(t5 * t5 + t6 * t6 + t7 * t7);
    real_t margin_0;
    if (TB_C(16.0) * TB_EPSILON < t8) {
        const bool t9 = (numbers[0] == TB_C(0.0)) || (TB_C(0.0) == numbers[1]);
        const real_t t10 = TB_C(1.0) / t8;
        const real_t t11 = t5 * t10;
        const real_t t12 = t6 * t10;
        const real_t t13 = t7 * t10;
        const real_t t14 = t11 * weighed[0] + t12 * weighed[6] + t13 * weighed[12];
        const real_t t15 = t9 ? TB_C(0.0) : t14;
        const bool t16 = (numbers[0] == TB_C(1.0)) || (numbers[1] == TB_C(1.0));
        const real_t t17 = t11 * weighed[1] + t12 * weighed[7] + t13 * weighed[13];
        const real_t t18 = t16 ? TB_C(0.0) : t17;
        const bool t19 = (numbers[0] == TB_C(2.0)) || (numbers[1] == TB_C(2.0));
        const real_t t20 = t11 * weighed[2] + t12 * weighed[8] + t13 * weighed[14];
        const real_t t21 = t19 ? TB_C(0.0) : t20;
        const bool t22 = (numbers[0] == TB_C(3.0)) || (numbers[1] == TB_C(3.0));
        const real_t t23 = t11 * weighed[3] + t12 * weighed[9] + t13 * weighed[15];
        const real_t t24 = t22 ? TB_C(0.0) : t23;
        const real_t t25 = TB_ABS(t15) + TB_ABS(t18) + TB_ABS(t21) + TB_ABS(t24);
        const bool t26 = (numbers[0] == TB_C(4.0)) || (numbers[1] == TB_C(4.0));
        const real_t t27 = t11 * weighed[4] + t12 * weighed[10] + t13 * weighed[16];
        const real_t t28 = t26 ? TB_C(0.0) : t27;
        const bool t29 = (numbers[0] == TB_C(5.0)) || (numbers[1] == TB_C(5.0));
        const real_t t30 = t11 * weighed[5] + t12 * weighed[11] + t13 * weighed[17];
        const real_t t31 = t29 ? TB_C(0.0) : t30;
        const real_t t32 = TB_TENSION_MIDDLE * (t31 + (t28 + (t24 + (t21 + (t15 + t18)))));
        const real_t t33 = TB_TENSION_HALF_RANGE * (t25 + TB_ABS(t28) + TB_ABS(t31)) -
            TB_ABS(t32);
        margin_0 = tb_min(margin[0], t33);
    } else {
        margin_0 = margin[0];
    }
    margin[0] = margin_0;
    return TB_OK;
}

/* After the last subset. */
static tb_status tb_balance_finish(const real_t margin[1], real_t balanced[1], real_t wrench[3])
{
    const bool t0 = TB_C(0.0) <= margin[0];
    const real_t balanced_0 = t0 ? TB_C(1.0) : TB_C(0.0);
    const bool t1 = !t0;
    balanced[0] = balanced_0;
    wrench[0] = TB_C(0.0);
    wrench[1] = TB_C(0.0);
    wrench[2] = TB_C(0.0);
    return t1 ? TB_INFEASIBLE : TB_OK;
}

/* Whether the cables hold the platform at rest. */
static tb_status tb_balance(const real_t structure[18], real_t balanced[1], real_t wrench[3])
{
    static const unsigned char subsets[15][2] = {{0,1}, {0,2}, {0,3}, {0,4}, {0,5}, {1,2},
        {1,3}, {1,4}, {1,5}, {2,3}, {2,4}, {2,5}, {3,4}, {3,5}, {4,5}};
    real_t weighed[18];
    real_t margin[1];
    const tb_status status = tb_balance_begin(structure, weighed, margin);
    if (status != TB_OK) {
        balanced[0] = TB_C(0.0);
        wrench[0] = TB_C(0.0);
        wrench[1] = TB_C(0.0);
        wrench[2] = TB_C(0.0);
        return status;
    }
    for (int k = 0; k < 15; k++) {
        real_t chosen[6];
        real_t numbers[2];
        for (int j = 0; j < 2; j++) {
            const int number = subsets[k][j];
            for (int i = 0; i < 3; i++) {
                chosen[2 * i + j] = weighed[6 * i + number];
            }
            numbers[j] = (real_t)number;
        }
        (void)tb_balance_visit(chosen, numbers, weighed, margin);
    }
    return tb_balance_finish(margin, balanced, wrench);
}

/* Least-norm tensions T0 under zero wrench; T_min in every cable outside the workspace. */
static tb_status tb_tension_at_rest(const real_t balanced[1], const real_t rest[6], real_t tension[6])
{
    const bool t0 = TB_C(0.0) < balanced[0];
    const real_t tension_0 = t0 ? rest[0] : TB_TENSION_MIN;
    const real_t tension_1 = t0 ? rest[1] : TB_TENSION_MIN;
    const real_t tension_2 = t0 ? rest[2] : TB_TENSION_MIN;
    const real_t tension_3 = t0 ? rest[3] : TB_TENSION_MIN;
    const real_t tension_4 = t0 ? rest[4] : TB_TENSION_MIN;
    const real_t tension_5 = t0 ? rest[5] : TB_TENSION_MIN;
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    tension[4] = tension_4;
    tension[5] = tension_5;
    return TB_OK;
}

/* Refuses with a status: tension is 3 N. */
static tb_status tb_refuse_zero_wrench_tension(tb_status status, real_t tension[6])
{
    tension[0] = TB_TENSION_MIN;
    tension[1] = TB_TENSION_MIN;
    tension[2] = TB_TENSION_MIN;
    tension[3] = TB_TENSION_MIN;
    tension[4] = TB_TENSION_MIN;
    tension[5] = TB_TENSION_MIN;
    return status;
}

tb_status tb_zero_wrench_tension(const real_t pose[3], const real_t rails[6], real_t tension[6])
{
    real_t structure[18];
    real_t balanced[1];
    real_t wrench[3];
    real_t rest[6] = {TB_C(0.0)};
    real_t exerted[3] = {TB_C(0.0)};
    real_t residual[1] = {TB_C(0.0)};
    bool infeasible = false;
    tb_status status;
    status = tb_structure_matrix(pose, rails, structure);
    if (status > TB_INFEASIBLE) {
        return tb_refuse_zero_wrench_tension(status, tension);
    }
    status = tb_balance(structure, balanced, wrench);
    if (status > TB_INFEASIBLE) {
        return tb_refuse_zero_wrench_tension(status, tension);
    }
    infeasible = infeasible || status == TB_INFEASIBLE;
    if (balanced[0] > TB_C(0.0)) {
        status = tb_least_norm_tension(structure, wrench, rest, exerted, residual);
        if (status > TB_INFEASIBLE) {
            return tb_refuse_zero_wrench_tension(status, tension);
        }
    }
    status = tb_tension_at_rest(balanced, rest, tension);
    return status == TB_OK && infeasible ? TB_INFEASIBLE : status;
}

/* Tension factor TF = min(T0) / max(T0); 0 outside the zero-wrench workspace. */
static tb_status tb_factor_at_rest(const real_t balanced[1], const real_t rest[6], real_t factor[1])
{
    const bool t0 = TB_C(0.0) < balanced[0];
    real_t factor_0, t1;
    if (t0) {
        const real_t t2 = tb_min(tb_min(tb_min(rest[0], rest[1]), rest[2]), rest[3]);
        const real_t t3 = tb_max(tb_max(tb_max(rest[0], rest[1]), rest[2]), rest[3]);
        const real_t t4 = tb_max(tb_max(t3, rest[4]), rest[5]);
        factor_0 = tb_min(tb_min(t2, rest[4]), rest[5]) / t4;
        t1 = t4;
    } else {
        factor_0 = TB_C(0.0);
        t1 = TB_C(1.0);
    }
    const bool t5 = !(TB_C(0.0) < t1);
    if (t5) {
        factor[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    factor[0] = factor_0;
    return TB_OK;
}

/* Refuses with a status: factor is 0. */
static tb_status tb_refuse_tension_factor(tb_status status, real_t factor[1])
{
    factor[0] = TB_C(0.0);
    return status;
}

tb_status tb_tension_factor(const real_t pose[3], const real_t rails[6], real_t factor[1])
{
    real_t structure[18];
    real_t balanced[1];
    real_t wrench[3];
    real_t rest[6] = {TB_C(0.0)};
    real_t exerted[3] = {TB_C(0.0)};
    real_t residual[1] = {TB_C(0.0)};
    bool infeasible = false;
    tb_status status;
    status = tb_structure_matrix(pose, rails, structure);
    if (status > TB_INFEASIBLE) {
        return tb_refuse_tension_factor(status, factor);
    }
    status = tb_balance(structure, balanced, wrench);
    if (status > TB_INFEASIBLE) {
        return tb_refuse_tension_factor(status, factor);
    }
    infeasible = infeasible || status == TB_INFEASIBLE;
    if (balanced[0] > TB_C(0.0)) {
        status = tb_least_norm_tension(structure, wrench, rest, exerted, residual);
        if (status > TB_INFEASIBLE) {
            return tb_refuse_tension_factor(status, factor);
        }
    }
    status = tb_factor_at_rest(balanced, rest, factor);
    return status == TB_OK && infeasible ? TB_INFEASIBLE : status;
}

/* Before the first subset. */
static tb_status tb_isotropic_begin(const real_t structure[18], real_t weighed[18], real_t margin[1],
    real_t radius[1])
{
    const real_t weighed_12 = TB_MOMENT_WEIGHT * structure[12];
    const real_t weighed_13 = TB_MOMENT_WEIGHT * structure[13];
    const real_t weighed_14 = TB_MOMENT_WEIGHT * structure[14];
    const real_t weighed_15 = TB_MOMENT_WEIGHT * structure[15];
    const real_t weighed_16 = TB_MOMENT_WEIGHT * structure[16];
    const real_t weighed_17 = TB_MOMENT_WEIGHT * structure[17];
    const real_t t0 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const real_t t1 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t2 = t1 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t3 = t2 + structure[4] * structure[4] + structure[5] * structure[5];
    const real_t t4 = TB_SQRT(t3);
    const real_t t5 = TB_COPYSIGN(t4, structure[0]);
    const real_t t6 = structure[0] + t5;
    const real_t t7 = structure[6] * t6 + structure[1] * structure[7] + structure[2] *
        structure[8];
    const real_t t8 = t7 + structure[3] * structure[9] + structure[4] * structure[10];
    const real_t t9 = TB_C(1.0) / (t4 * (t4 + TB_ABS(structure[0])));
    const real_t t10 = (t8 + structure[5] * structure[11]) * t9;
    const real_t t11 = structure[7] - structure[1] * t10;
    const real_t t12 = structure[8] - structure[2] * t10;
    const real_t t13 = structure[9] - structure[3] * t10;
    const real_t t14 = structure[10] - structure[4] * t10;
    const real_t t15 = structure[11] - structure[5] * t10;
    const real_t t16 = t11 * t11 + t12 * t12 + t13 * t13 + t14 * t14 + t15 * t15;
    const real_t t17 = TB_SQRT(t16);
    const real_t t18 = TB_COPYSIGN(t17, t11);
    const real_t t19 = weighed_12 * t6 + structure[1] * weighed_13 + structure[2] * weighed_14;
    const real_t t20 = t19 + structure[3] * weighed_15 + structure[4] * weighed_16;
    const real_t t21 = t9 * (t20 + structure[5] * weighed_17);
    const real_t t22 = weighed_14 - structure[2] * t21;
    const real_t t23 = (t11 + t18) * (weighed_13 - structure[1] * t21) + t12 * t22;
    const real_t t24 = weighed_15 - structure[3] * t21;
    const real_t t25 = weighed_16 - structure[4] * t21;
    const real_t t26 = weighed_17 - structure[5] * t21;
    const real_t t27 = (t23 + t13 * t24 + t14 * t25 + t15 * t26) * (TB_C(1.0) / (t17 * (t17 +
        TB_ABS(t11))));
    const real_t t28 = t22 - t12 * t27;
    const real_t t29 = t24 - t13 * t27;
    const real_t t30 = t25 - t14 * t27;
    const real_t t31 = t26 - t15 * t27;
    const real_t t32 = TB_SQRT(t28 * t28 + t29 * t29 + t30 * t30 + t31 * t31);
    const bool t33 = t0 < TB_ABS(t5) && t0 < TB_ABS(t18) && t0 < TB_ABS(TB_COPYSIGN(t32, t28));
    const bool t34 = !t33;
    if (t34) {
        weighed[0] = TB_C(0.0);
        weighed[1] = TB_C(0.0);
        weighed[2] = TB_C(0.0);
        weighed[3] = TB_C(0.0);
        weighed[4] = TB_C(0.0);
        weighed[5] = TB_C(0.0);
        weighed[6] = TB_C(0.0);
        weighed[7] = TB_C(0.0);
        weighed[8] = TB_C(0.0);
        weighed[9] = TB_C(0.0);
        weighed[10] = TB_C(0.0);
        weighed[11] = TB_C(0.0);
        weighed[12] = TB_C(0.0);
        weighed[13] = TB_C(0.0);
        weighed[14] = TB_C(0.0);
        weighed[15] = TB_C(0.0);
        weighed[16] = TB_C(0.0);
        weighed[17] = TB_C(0.0);
        margin[0] = TB_C(0.0);
        radius[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    weighed[0] = structure[0];
    weighed[1] = structure[1];
    weighed[2] = structure[2];
    weighed[3] = structure[3];
    weighed[4] = structure[4];
    weighed[5] = structure[5];
    weighed[6] = structure[6];
    weighed[7] = structure[7];
    weighed[8] = structure[8];
    weighed[9] = structure[9];
    weighed[10] = structure[10];
    weighed[11] = structure[11];
    weighed[12] = weighed_12;
    weighed[13] = weighed_13;
    weighed[14] = weighed_14;
    weighed[15] = weighed_15;
    weighed[16] = weighed_16;
    weighed[17] = weighed_17;
    margin[0] = TB_C(1e+30);
    radius[0] = TB_C(1e+30);
    return TB_OK;
}

/* One subset. */
static tb_status tb_isotropic_visit(const real_t chosen[6], const real_t numbers[2],
    const real_t weighed[18], real_t margin[1], real_t radius[1])
{
    const real_t t0 = chosen[2] * chosen[5] - chosen[4] * chosen[3];
    const real_t t1 = chosen[4] * chosen[1] - chosen[5] * chosen[0];
    const real_t t2 = chosen[3] * chosen[0] - chosen[2] * chosen[1];
    const real_t t3 = chosen[0] * chosen[0] + chosen[2] * chosen[2] + chosen[4] * chosen[4];
    const real_t t4 = (t0 * chosen[0] + chosen[2] * t1 + chosen[4] * t2) / t3;
    const real_t t5 = t0 - chosen[0] * t4;
    const real_t t6 = t1 - chosen[2] * t4;
    const real_t t7 = t2 - chosen[4] * t4;
    const real_t t8 = TB_SQRT(t5 * t5 + t6 * t6 + t7 * t7);
    const bool t9 = TB_C(16.0) * TB_EPSILON < t8;
    const bool t10 = (numbers[0] == TB_C(0.0)) || (TB_C(0.0) == numbers[1]);
    const real_t t11 = TB_C(1.0) / t8;
    const real_t t12 = t5 * t11;
    const real_t t13 = t6 * t11;
    const real_t t14 = t7 * t11;
    const real_t t15 = t12 * weighed[0] + t13 * weighed[6] + t14 * weighed[12];
    const real_t t16 = t10 ? TB_C(0.0) : t15;
    const bool t17 = (numbers[0] == TB_C(1.0)) || (numbers[1] == TB_C(1.0));
    const real_t t18 = t12 * weighed[1] + t13 * weighed[7] + t14 * weighed[13];
    const real_t t19 = t17 ? TB_C(0.0) : t18;
    const bool t20 = (numbers[0] == TB_C(2.0)) || (numbers[1] == TB_C(2.0));
    const real_t t21 = t12 * weighed[2] + t13 * weighed[8] + t14 * weighed[14];
    const real_t t22 = t20 ? TB_C(0.0) : t21;
    const bool t23 = (numbers[0] == TB_C(3.0)) || (numbers[1] == TB_C(3.0));
    const real_t t24 = t12 * weighed[3] + t13 * weighed[9] + t14 * weighed[15];
    const real_t t25 = t23 ? TB_C(0.0) : t24;
    const real_t t26 = TB_ABS(t16) + TB_ABS(t19) + TB_ABS(t22) + TB_ABS(t25);
    const bool t27 = (numbers[0] == TB_C(4.0)) || (numbers[1] == TB_C(4.0));
    const real_t t28 = t12 * weighed[4] + t13 * weighed[10] + t14 * weighed[16];
    const real_t t29 = t27 ? TB_C(0.0) : t28;
    const bool t30 = (numbers[0] == TB_C(5.0)) || (numbers[1] == TB_C(5.0));
    const real_t t31 = t12 * weighed[5] + t13 * weighed[11] + t14 * weighed[17];
    const real_t t32 = t30 ? TB_C(0.0) : t31;
    const real_t t33 = TB_TENSION_MIDDLE * (t32 + (t29 + (t25 + (t22 + (t16 + t19)))));
    const real_t t34 = TB_TENSION_HALF_RANGE * (t26 + TB_ABS(t29) + TB_ABS(t32)) - TB_ABS(t33);
    const real_t margin_0 = t9 ? tb_min(margin[0], t34) : margin[0];
    const real_t t35 = TB_SQRT(t12 * t12 + t13 * t13);
    real_t radius_0;
    if (t9 && TB_C(1e-06) < t35) {
        radius_0 = tb_min(radius[0], t34 * (TB_C(1.0) / t35));
    } else {
        radius_0 = radius[0];
    }
    margin[0] = margin_0;
    radius[0] = radius_0;
    return TB_OK;
}

/* After the last subset. */
static tb_status tb_isotropic_finish(const real_t margin[1], const real_t radius[1], real_t force[1])
{
    const bool t0 = TB_C(0.0) <= margin[0];
    const real_t force_0 = t0 ? tb_max(radius[0], TB_C(0.0)) : TB_C(0.0);
    const bool t1 = !t0;
    force[0] = force_0;
    return t1 ? TB_INFEASIBLE : TB_OK;
}

/* Isotropic force of a structure matrix. */
static tb_status tb_isotropic(const real_t structure[18], real_t force[1])
{
    static const unsigned char subsets[15][2] = {{0,1}, {0,2}, {0,3}, {0,4}, {0,5}, {1,2},
        {1,3}, {1,4}, {1,5}, {2,3}, {2,4}, {2,5}, {3,4}, {3,5}, {4,5}};
    real_t weighed[18];
    real_t margin[1];
    real_t radius[1];
    const tb_status status = tb_isotropic_begin(structure, weighed, margin, radius);
    if (status != TB_OK) {
        force[0] = TB_C(0.0);
        return status;
    }
    for (int k = 0; k < 15; k++) {
        real_t chosen[6];
        real_t numbers[2];
        for (int j = 0; j < 2; j++) {
            const int number = subsets[k][j];
            for (int i = 0; i < 3; i++) {
                chosen[2 * i + j] = weighed[6 * i + number];
            }
            numbers[j] = (real_t)number;
        }
        (void)tb_isotropic_visit(chosen, numbers, weighed, margin, radius);
    }
    return tb_isotropic_finish(margin, radius, force);
}

tb_status tb_isotropic_force(const real_t pose[3], const real_t rails[6], real_t force[1])
{
    real_t structure[18];
    tb_status status;
    status = tb_structure_matrix(pose, rails, structure);
    if (status > TB_INFEASIBLE) {
        force[0] = TB_C(0.0);
        return status;
    }
    return tb_isotropic(structure, force);
}

