/* Regenerate: turnbuckle generate machines/brau_triangle.toml --out <this folder>
 * Machine 62d2624dcb098eaa, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_statics.h"
#include "tb_machine.h"

tb_status tb_wrench(const real_t structure[6], const real_t tension[3], real_t wrench[2])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) <= TB_C(24.0)
          && TB_ABS(tension[0]) + TB_ABS(tension[1]) + TB_ABS(tension[2]) <= TB_C(60000.0))) {
        wrench[0] = TB_C(0.0);
        wrench[1] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = structure[0] * tension[0] + structure[1] * tension[1];
    const real_t wrench_0 = t0 + structure[2] * tension[2];
    const real_t t1 = tension[0] * structure[3] + tension[1] * structure[4];
    const real_t wrench_1 = t1 + tension[2] * structure[5];
    wrench[0] = wrench_0;
    wrench[1] = wrench_1;
    return TB_OK;
}

/* Refuses with a status: share is 0 N. */
static tb_status tb_refuse_wrench_share_eq10(tb_status status, real_t share[3])
{
    share[0] = TB_C(0.0);
    share[1] = TB_C(0.0);
    share[2] = TB_C(0.0);
    return status;
}

tb_status tb_wrench_share_eq10(const real_t pose[2], const real_t rails[1],
    const real_t wrench[2], real_t share[3])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(120000.0))) {
        return tb_refuse_wrench_share_eq10(TB_OUT_OF_DOMAIN, share);
    }
    const real_t t0 = pose[0] * pose[0];
    const real_t t1 = pose[1] * pose[1];
    const real_t t2 = TB_SQRT(t0 + t1);
    const real_t t3 = TB_FRAME_X - pose[0];
    const real_t t4 = t3 * t3;
    const real_t t5 = TB_BASE_3_X - pose[0];
    const real_t t6 = t5 * t5;
    const real_t t7 = t0 + t4 + t6;
    const real_t t8 = TB_C(1.0) / t7;
    const real_t t9 = TB_FRAME_Y - pose[1];
    const real_t t10 = t8 * (pose[0] * pose[1] - pose[1] * t3 + t5 * t9);
    const real_t t11 = t9 * t9;
    const real_t t12 = (wrench[1] - wrench[0] * t10) / (t1 * TB_C(2.0) + t11 - t7 * (t10 *
        t10));
    const real_t t13 = wrench[0] * t8 - t10 * t12;
    const real_t t14 = pose[1] * t12;
    const real_t share_0 = -(t2 * (pose[0] * t13 + t14));
    const real_t t15 = TB_SQRT(t1 + t4);
    const real_t share_1 = t15 * (t3 * t13 - t14);
    const real_t t16 = TB_SQRT(t6 + t11);
    const real_t share_2 = t16 * (t5 * t13 + t9 * t12);
    const bool t17 = TB_C(0.0001) < t2 && TB_C(0.0001) < t15 && TB_C(0.0001) < t16;
    const bool t18 = !t17;
    const real_t t19 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const real_t t20 = TB_C(1.0) / t2;
    const real_t t21 = pose[0] * t20;
    const real_t t22 = TB_C(1.0) / t15;
    const real_t t23 = t3 * t22;
    const real_t t24 = TB_C(1.0) / t16;
    const real_t t25 = t5 * t24;
    const real_t t26 = t21 * t21 + t23 * t23 + t25 * t25;
    const real_t t27 = pose[1] * t20;
    const real_t t28 = pose[1] * t22;
    const real_t t29 = t9 * t24;
    const real_t t30 = (t21 * t27 - t23 * t28 + t25 * t29) / t26;
    const real_t t31 = t27 * t27 + t28 * t28 + t29 * t29 - t26 * (t30 * t30);
    const bool t32 = !(t19 < t26 && t19 < t31);
    if (t18 || t32) {
        return tb_refuse_wrench_share_eq10(TB_SINGULAR, share);
    }
    share[0] = share_0;
    share[1] = share_1;
    share[2] = share_2;
    return TB_OK;
}

