/* Regenerate: turnbuckle generate machines/three_base_equilateral.toml --out <this folder>
 * Machine bf852767ce09ae7f, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_comparison.h"
#include "tb_machine.h"

/* Refuses with a status: tension is 3 N. */
static tb_status tb_refuse_kernel_tension(tb_status status, real_t tension[3])
{
    tension[0] = TB_TENSION_MIN;
    tension[1] = TB_TENSION_MIN;
    tension[2] = TB_TENSION_MIN;
    return status;
}

tb_status tb_kernel_tension(const real_t structure[6], const real_t wrench[2],
    real_t tension[3])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) <= TB_C(24.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(60000.0))) {
        return tb_refuse_kernel_tension(TB_OUT_OF_DOMAIN, tension);
    }
    const real_t t0 = TB_C(64.0) * TB_EPSILON;
    const real_t t1 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t2 = TB_SQRT(t1 + structure[2] * structure[2]);
    const real_t t3 = TB_COPYSIGN(t2, structure[0]);
    const real_t t4 = structure[0] + t3;
    const real_t t5 = t4 * structure[3] + structure[1] * structure[4] + structure[2] *
        structure[5];
    const real_t t6 = TB_C(1.0) / (t2 * (t2 + TB_ABS(structure[0])));
    const real_t t7 = t5 * t6;
    const real_t t8 = structure[5] - structure[2] * t7;
    const real_t t9 = structure[4] - structure[1] * t7;
    const real_t t10 = TB_SQRT(t9 * t9 + t8 * t8);
    const real_t t11 = TB_C(1.0) / (t10 * (t10 + TB_ABS(t9)));
    const real_t t12 = t8 * t11;
    const real_t t13 = TB_C(1.0) - t8 * t12;
    const real_t t14 = TB_COPYSIGN(t10, t9);
    const real_t t15 = t9 + t14;
    const real_t t16 = t12 * t15;
    const real_t t17 = t6 * (structure[2] * t13 - structure[1] * t16);
    const real_t t18 = t4 * t17;
    const real_t t19 = TB_COPYSIGN(TB_C(1.0), -t18);
    const real_t t20 = t18 * t19;
    const real_t t21 = t19 * (t16 + structure[1] * t17);
    const real_t t22 = t19 * (t13 - structure[2] * t17);
    const bool t23 = t0 < -t20 && t0 < -t21 && t0 < t22;
    real_t tension_0, tension_1, tension_2;
    if (t23) {
        const real_t t24 = wrench[0] / t3;
        const real_t t25 = (wrench[1] + t24 * (structure[3] - t4 * t7)) / t14;
        const real_t t26 = t11 * (t15 * t25);
        const real_t t27 = t15 * t26 - t25;
        const real_t t28 = t8 * t26;
        const real_t t29 = structure[1] * t27 - t4 * t24 + structure[2] * t28;
        const real_t t30 = t6 * t29;
        const real_t t31 = t24 + t4 * t30;
        const real_t t32 = t27 - structure[1] * t30;
        const real_t t33 = tb_max(-((t31 + TB_TENSION_MIN) / t20), -((TB_TENSION_MIN - t32) /
            t21));
        const real_t t34 = t28 - structure[2] * t30;
        const real_t t35 = tb_max(t33, (TB_TENSION_MIN - t34) / t22);
        tension_0 = tb_max(-(t31 + t20 * t35), TB_TENSION_MIN);
        tension_1 = tb_max(t32 - t21 * t35, TB_TENSION_MIN);
        tension_2 = tb_max(t34 + t22 * t35, TB_TENSION_MIN);
    } else {
        tension_0 = TB_TENSION_MIN;
        tension_1 = TB_TENSION_MIN;
        tension_2 = TB_TENSION_MIN;
    }
    const bool t36 = !t23;
    const real_t t37 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t38 = !(t37 < TB_ABS(t3) && t37 < TB_ABS(t14));
    if (t38) {
        return tb_refuse_kernel_tension(TB_SINGULAR, tension);
    }
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    return t36 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_largest_tensions_eq17(const real_t structure[6], const real_t force[1],
    real_t tension[3])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) <= TB_C(24.0)
          && force[0] >= TB_C(0.0) && force[0] <= TB_C(10000.0))) {
        tension[0] = TB_C(0.0);
        tension[1] = TB_C(0.0);
        tension[2] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = TB_C(64.0) * TB_EPSILON;
    const real_t t1 = structure[0] * structure[4];
    const real_t t2 = structure[3] * structure[1];
    const real_t t3 = t1 - t2;
    const bool t4 = t0 < t3;
    const real_t t5 = structure[0] * structure[5];
    const real_t t6 = structure[3] * structure[2];
    const real_t t7 = t5 - t6;
    const bool t8 = t0 < t7;
    const real_t t9 = structure[4] * structure[2];
    const real_t t10 = structure[1] * structure[5];
    const real_t t11 = t9 - t10;
    const bool t12 = t0 < t11;
    const bool t13 = t4 && !(t8 && t12);
    const real_t t14 = t10 - t9;
    const bool t15 = t0 < t14;
    const bool t16 = t8 && !(t4 && t15);
    const real_t t17 = t2 - t1;
    const bool t18 = t0 < t17;
    const real_t t19 = t6 - t5;
    const bool t20 = t0 < t19;
    const bool t21 = t18 && !(t15 && t20);
    const bool t22 = t15 && !(t8 && t18);
    const bool t23 = t20 && !(t12 && t18);
    const bool t24 = t12 && !(t4 && t20);
    const bool t25 = (t13 || t16) && (t21 || t22) && (t23 || t24);
    real_t tension_0, tension_1, tension_2;
    if (t25) {
        const real_t t26 = structure[0] * structure[1] + structure[4] * structure[3];
        const bool t27 = t26 < TB_C(0.0);
        real_t t28;
        if (t13) {
            real_t t29;
            if (t27) {
                t29 = TB_C(1.0) / t3;
            } else {
                t29 = TB_C(1.0);
            }
            t28 = t29;
        } else {
            t28 = TB_C(0.0);
        }
        const real_t t30 = tb_max(TB_C(0.0), t28);
        const real_t t31 = structure[0] * structure[2] + structure[3] * structure[5];
        const bool t32 = t31 < TB_C(0.0);
        real_t t33;
        if (t16) {
            real_t t34;
            if (t32) {
                t34 = TB_C(1.0) / t7;
            } else {
                t34 = TB_C(1.0);
            }
            t33 = t34;
        } else {
            t33 = TB_C(0.0);
        }
        real_t t35;
        if (t21) {
            real_t t36;
            if (t27) {
                t36 = TB_C(1.0) / t17;
            } else {
                t36 = TB_C(1.0);
            }
            t35 = t36;
        } else {
            t35 = TB_C(0.0);
        }
        real_t t37;
        if (t23) {
            real_t t38;
            if (t32) {
                t38 = TB_C(1.0) / t19;
            } else {
                t38 = TB_C(1.0);
            }
            t37 = t38;
        } else {
            t37 = TB_C(0.0);
        }
        const real_t t39 = force[0] * tb_max(tb_max(tb_max(t30, t33), t35), t37);
        const real_t t40 = structure[1] * structure[2] + structure[4] * structure[5];
        const bool t41 = t40 < TB_C(0.0);
        real_t t42;
        if (t22) {
            real_t t43;
            if (t41) {
                t43 = TB_C(1.0) / t14;
            } else {
                t43 = TB_C(1.0);
            }
            t42 = t43;
        } else {
            t42 = TB_C(0.0);
        }
        real_t t44;
        if (t24) {
            real_t t45;
            if (t41) {
                t45 = TB_C(1.0) / t11;
            } else {
                t45 = TB_C(1.0);
            }
            t44 = t45;
        } else {
            t44 = TB_C(0.0);
        }
        const real_t t46 = force[0] * tb_max(tb_max(tb_max(t30, t35), t42), t44);
        const real_t t47 = tb_max(tb_max(tb_max(tb_max(TB_C(0.0), t33), t42), t37), t44);
        tension_0 = t39;
        tension_1 = t46;
        tension_2 = force[0] * t47;
    } else {
        tension_0 = TB_C(0.0);
        tension_1 = TB_C(0.0);
        tension_2 = TB_C(0.0);
    }
    const bool t48 = !t25;
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    return t48 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_reduced_matrix_tension(const real_t structure[6], const real_t wrench[2],
    real_t tension[3])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) <= TB_C(24.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(60000.0))) {
        tension[0] = TB_TENSION_MIN;
        tension[1] = TB_TENSION_MIN;
        tension[2] = TB_TENSION_MIN;
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = TB_TENSION_MIN * (structure[3] + structure[4] + structure[5]);
    const real_t t1 = wrench[1] - t0;
    const real_t t2 = TB_TENSION_MIN * (structure[1] + structure[0] + structure[2]);
    const real_t t3 = wrench[0] - t2;
    const real_t t4 = structure[1] * t1 - structure[4] * t3;
    const real_t t5 = structure[4] * structure[0] - structure[1] * structure[3];
    const real_t t6 = TB_C(1.0) / t5;
    const real_t t7 = t4 * t6;
    const real_t t8 = -t7;
    const real_t t9 = t1 * structure[0] - structure[3] * t3;
    const real_t t10 = t6 * t9;
    const real_t t11 = TB_C(16.0) * TB_EPSILON;
    const real_t t12 = t10 - t7;
    const real_t t13 = tb_min(t8, t10) + t11 * (TB_ABS(t12) + TB_C(9.0));
    const real_t t14 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const real_t t15 = TB_C(0.0) <= tb_min(t13, TB_ABS(t5) - t14) ? t12 : TB_C(1e+30);
    const real_t t16 = t1 * structure[2] - structure[5] * t3;
    const real_t t17 = structure[5] * structure[0] - structure[3] * structure[2];
    const real_t t18 = TB_C(1.0) / t17;
    const real_t t19 = t16 * t18;
    const real_t t20 = -t19;
    const real_t t21 = t9 * t18;
    const real_t t22 = t21 - t19;
    const real_t t23 = tb_min(t20, t21) + t11 * (TB_C(9.0) + TB_ABS(t22));
    const real_t t24 = TB_C(0.0) <= tb_min(t23, TB_ABS(t17) - t14) ? t22 : TB_C(1e+30);
    const real_t t25 = structure[1] * structure[5] - structure[4] * structure[2];
    const real_t t26 = TB_C(1.0) / t25;
    const real_t t27 = t16 * t26;
    const real_t t28 = -t27;
    const real_t t29 = t4 * t26;
    const real_t t30 = t29 - t27;
    const real_t t31 = tb_min(t28, t29) + t11 * (TB_C(9.0) + TB_ABS(t30));
    const real_t t32 = TB_C(0.0) <= tb_min(t31, TB_ABS(t25) - t14) ? t30 : TB_C(1e+30);
    const bool t33 = tb_min(tb_min(t15, t24), t32) < TB_C(1e+30);
    real_t tension_0, tension_1, tension_2;
    if (t33) {
        const real_t t34 = -t15;
        const real_t t35 = -t24;
        const bool t36 = -t32 <= tb_max(t34, t35);
        const bool t37 = t35 <= t34;
        const real_t t38 = tb_max(t36 ? (t37 ? t8 : t20) : TB_C(0.0), TB_C(0.0));
        const real_t t39 = tb_max(t36 ? (t37 ? t10 : TB_C(0.0)) : t28, TB_C(0.0));
        const real_t t40 = tb_max(t36 ? (t37 ? TB_C(0.0) : t21) : t29, TB_C(0.0));
        tension_0 = TB_TENSION_MIN + t38;
        tension_1 = TB_TENSION_MIN + t39;
        tension_2 = TB_TENSION_MIN + t40;
    } else {
        tension_0 = TB_TENSION_MIN;
        tension_1 = TB_TENSION_MIN;
        tension_2 = TB_TENSION_MIN;
    }
    const bool t41 = !t33;
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    return t41 ? TB_INFEASIBLE : TB_OK;
}

/* Refuses with a status: most is 0; least is 0; size is 0 N. */
static tb_status tb_refuse_largest_tensions_eq12_begin(tb_status status, real_t most[3],
    real_t least[1], real_t size[1])
{
    most[0] = TB_C(0.0);
    most[1] = TB_C(0.0);
    most[2] = TB_C(0.0);
    least[0] = TB_C(0.0);
    size[0] = TB_C(0.0);
    return status;
}

/* Before the first subset. */
static tb_status tb_largest_tensions_eq12_begin(const real_t structure[6], const real_t force[1],
    real_t most[3], real_t least[1], real_t size[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) <= TB_C(24.0)
          && force[0] >= TB_C(0.0) && force[0] <= TB_C(10000.0))) {
        return tb_refuse_largest_tensions_eq12_begin(TB_OUT_OF_DOMAIN, most, least, size);
    }
    const real_t t0 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const real_t t1 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t2 = TB_SQRT(t1 + structure[2] * structure[2]);
    const real_t t3 = TB_COPYSIGN(t2, structure[0]);
    const real_t t4 = (structure[0] + t3) * structure[3] + structure[1] * structure[4];
    const real_t t5 = (t4 + structure[2] * structure[5]) / (t2 * (t2 + TB_ABS(structure[0])));
    const real_t t6 = structure[4] - structure[1] * t5;
    const real_t t7 = structure[5] - structure[2] * t5;
    const real_t t8 = TB_ABS(TB_COPYSIGN(TB_SQRT(t6 * t6 + t7 * t7), t6));
    const bool t9 = !(t0 < TB_ABS(t3) && t0 < t8);
    if (t9) {
        return tb_refuse_largest_tensions_eq12_begin(TB_SINGULAR, most, least, size);
    }
    most[0] = TB_C(0.0);
    most[1] = TB_C(0.0);
    most[2] = TB_C(0.0);
    least[0] = TB_C(1e+30);
    size[0] = force[0];
    return TB_OK;
}

/* One subset. */
static tb_status tb_largest_tensions_eq12_visit(const real_t chosen[2], const real_t numbers[1],
    const real_t structure[6], real_t most[3], real_t least[1])
{
    const bool t0 = numbers[0] == TB_C(0.0);
    const real_t t1 = TB_SQRT(chosen[0] * chosen[0] + chosen[1] * chosen[1]);
    const real_t t2 = TB_C(1.0) / t1;
    const real_t t3 = chosen[0] * t2;
    const real_t t4 = chosen[1] * t2;
    const real_t t5 = t0 ? TB_C(0.0) : t3 * structure[3] - t4 * structure[0];
    const real_t t6 = t0 ? TB_C(1e+30) : TB_ABS(t5);
    const real_t most_0 = tb_max(most[0], TB_C(1.0) / t6);
    const bool t7 = numbers[0] == TB_C(1.0);
    const real_t t8 = t7 ? TB_C(0.0) : t3 * structure[4] - t4 * structure[1];
    const real_t t9 = t7 ? TB_C(1e+30) : TB_ABS(t8);
    const real_t most_1 = tb_max(most[1], TB_C(1.0) / t9);
    const bool t10 = numbers[0] == TB_C(2.0);
    const real_t t11 = t10 ? TB_C(0.0) : t3 * structure[5] - t4 * structure[2];
    const real_t t12 = t10 ? TB_C(1e+30) : TB_ABS(t11);
    const real_t most_2 = tb_max(most[2], TB_C(1.0) / t12);
    const bool t13 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON) < t1;
    const real_t least_0 = tb_min(least[0], t13 ? tb_min(tb_min(t6, t9), t12) : TB_C(0.0));
    most[0] = most_0;
    most[1] = most_1;
    most[2] = most_2;
    least[0] = least_0;
    return TB_OK;
}

/* After the last subset. */
static tb_status tb_largest_tensions_eq12_finish(const real_t most[3], const real_t least[1],
    const real_t size[1], real_t tension[3])
{
    const real_t tension_0 = size[0] * most[0];
    const real_t tension_1 = size[0] * most[1];
    const real_t tension_2 = size[0] * most[2];
    const bool t0 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON) < least[0];
    const bool t1 = !t0;
    if (t1) {
        tension[0] = TB_C(0.0);
        tension[1] = TB_C(0.0);
        tension[2] = TB_C(0.0);
        return TB_SINGULAR;
    }
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    return TB_OK;
}

tb_status tb_largest_tensions_eq12(const real_t structure[6], const real_t force[1],
    real_t tension[3])
{
    static const unsigned char subsets[3][1] = {{0}, {1}, {2}};
    real_t most[3];
    real_t least[1];
    real_t size[1];
    const tb_status status = tb_largest_tensions_eq12_begin(structure, force, most, least,
        size);
    if (status != TB_OK) {
        tension[0] = TB_C(0.0);
        tension[1] = TB_C(0.0);
        tension[2] = TB_C(0.0);
        return status;
    }
    for (int k = 0; k < 3; k++) {
        real_t chosen[2];
        real_t numbers[1];
        for (int j = 0; j < 1; j++) {
            const int number = subsets[k][j];
            for (int i = 0; i < 2; i++) {
                chosen[1 * i + j] = structure[3 * i + number];
            }
            numbers[j] = (real_t)number;
        }
        (void)tb_largest_tensions_eq12_visit(chosen, numbers, structure, most, least);
    }
    return tb_largest_tensions_eq12_finish(most, least, size, tension);
}

/* Refuses with a status: most is 0 N; size is 0 N. */
static tb_status tb_refuse_largest_tension_begin(tb_status status, real_t most[1],
    real_t size[1])
{
    most[0] = TB_C(0.0);
    size[0] = TB_C(0.0);
    return status;
}

/* Before the first subset. */
static tb_status tb_largest_tension_begin(const real_t structure[6], const real_t force[1],
    real_t most[1], real_t size[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) <= TB_C(24.0)
          && force[0] >= TB_C(0.0) && force[0] <= TB_C(10000.0))) {
        return tb_refuse_largest_tension_begin(TB_OUT_OF_DOMAIN, most, size);
    }
    const real_t t0 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const real_t t1 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t2 = TB_SQRT(t1 + structure[2] * structure[2]);
    const real_t t3 = TB_COPYSIGN(t2, structure[0]);
    const real_t t4 = (structure[0] + t3) * structure[3] + structure[1] * structure[4];
    const real_t t5 = (t4 + structure[2] * structure[5]) / (t2 * (t2 + TB_ABS(structure[0])));
    const real_t t6 = structure[4] - structure[1] * t5;
    const real_t t7 = structure[5] - structure[2] * t5;
    const real_t t8 = TB_ABS(TB_COPYSIGN(TB_SQRT(t6 * t6 + t7 * t7), t6));
    const bool t9 = !(t0 < TB_ABS(t3) && t0 < t8);
    if (t9) {
        return tb_refuse_largest_tension_begin(TB_SINGULAR, most, size);
    }
    most[0] = TB_TENSION_MIN;
    size[0] = force[0];
    return TB_OK;
}

/* One subset. */
static tb_status tb_largest_tension_visit(const real_t chosen[2], const real_t numbers[1],
    const real_t structure[6], real_t most[1], const real_t size[1])
{
    const real_t t0 = TB_SQRT(chosen[0] * chosen[0] + chosen[1] * chosen[1]);
    real_t most_0;
    if (TB_C(16.0) * TB_EPSILON < t0) {
        const real_t t1 = TB_EPSILON * TB_C(64.0);
        const real_t t2 = TB_C(1.0) / t0;
        const real_t t3 = chosen[0] * t2;
        const real_t t4 = chosen[1] * t2;
        const real_t t5 = numbers[0] == TB_C(0.0) ? TB_C(0.0) : t3 * structure[3] - t4 *
            structure[0];
        const real_t t6 = numbers[0] == TB_C(1.0) ? TB_C(0.0) : t3 * structure[4] - t4 *
            structure[1];
        const real_t t7 = numbers[0] == TB_C(2.0) ? TB_C(0.0) : t3 * structure[5] - t4 *
            structure[2];
        const real_t t8 = TB_ABS(t5) + TB_ABS(t6) + TB_ABS(t7);
        const real_t t9 = t7 + (t5 + t6);
        const real_t t10 = (t8 + t9) * TB_C(0.5);
        const real_t t11 = TB_C(0.5) * (t8 - t9);
        const real_t t12 = size[0] + TB_TENSION_MIN * t11;
        real_t t13;
        if (t1 < t10) {
            t13 = t12 / t10;
        } else {
            t13 = t1 < t12 ? TB_C(1e+30) : TB_C(0.0);
        }
        const real_t t14 = size[0] + t10 * TB_TENSION_MIN;
        real_t t15;
        if (t1 < t11) {
            t15 = t14 / t11;
        } else {
            t15 = t1 < t14 ? TB_C(1e+30) : TB_C(0.0);
        }
        most_0 = tb_max(most[0], tb_max(t13, t15));
    } else {
        most_0 = most[0];
    }
    most[0] = most_0;
    return TB_OK;
}

/* After the last subset. */
static tb_status tb_largest_tension_finish(const real_t most[1], real_t tension[1])
{
    const bool t0 = most[0] < TB_C(1e+30);
    const real_t tension_0 = t0 ? most[0] : TB_C(0.0);
    const bool t1 = !t0;
    tension[0] = tension_0;
    return t1 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_largest_tension(const real_t structure[6], const real_t force[1],
    real_t tension[1])
{
    static const unsigned char subsets[3][1] = {{0}, {1}, {2}};
    real_t most[1];
    real_t size[1];
    const tb_status status = tb_largest_tension_begin(structure, force, most, size);
    if (status != TB_OK) {
        tension[0] = TB_C(0.0);
        return status;
    }
    for (int k = 0; k < 3; k++) {
        real_t chosen[2];
        real_t numbers[1];
        for (int j = 0; j < 1; j++) {
            const int number = subsets[k][j];
            for (int i = 0; i < 2; i++) {
                chosen[1 * i + j] = structure[3 * i + number];
            }
            numbers[j] = (real_t)number;
        }
        (void)tb_largest_tension_visit(chosen, numbers, structure, most, size);
    }
    return tb_largest_tension_finish(most, tension);
}

