/* Regenerate: turnbuckle generate machines/brau_five.toml --out <this folder>
 * Machine b614899c8a021831, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_statics.h"
#include "tb_machine.h"

tb_status tb_wrench(const real_t structure[10], const real_t tension[5], real_t wrench[2])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) <= TB_C(40.0)
          && TB_ABS(tension[0]) + TB_ABS(tension[1]) + TB_ABS(tension[2]) + TB_ABS(tension[3])
              + TB_ABS(tension[4]) <= TB_C(50000.0))) {
        wrench[0] = TB_C(0.0);
        wrench[1] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = structure[0] * tension[0] + structure[1] * tension[1];
    const real_t t1 = t0 + structure[2] * tension[2] + structure[3] * tension[3];
    const real_t wrench_0 = t1 + structure[4] * tension[4];
    const real_t t2 = tension[0] * structure[5] + tension[1] * structure[6];
    const real_t t3 = t2 + tension[2] * structure[7] + tension[3] * structure[8];
    const real_t wrench_1 = t3 + tension[4] * structure[9];
    wrench[0] = wrench_0;
    wrench[1] = wrench_1;
    return TB_OK;
}

/* Refuses with a status: share is 0 N. */
static tb_status tb_refuse_wrench_share_eq10(tb_status status, real_t share[5])
{
    share[0] = TB_C(0.0);
    share[1] = TB_C(0.0);
    share[2] = TB_C(0.0);
    share[3] = TB_C(0.0);
    share[4] = TB_C(0.0);
    return status;
}

tb_status tb_wrench_share_eq10(const real_t pose[2], const real_t rails[1],
    const real_t wrench[2], real_t share[5])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(100000.0))) {
        return tb_refuse_wrench_share_eq10(TB_OUT_OF_DOMAIN, share);
    }
    const real_t t0 = pose[0] * pose[0];
    const real_t t1 = TB_FRAME - pose[1];
    const real_t t2 = t1 * t1;
    const real_t t3 = TB_SQRT(t0 + t2);
    const real_t t4 = TB_FRAME - pose[0];
    const real_t t5 = pose[0] * pose[1] - pose[0] * t1 - pose[1] * t4 + t1 * t4;
    const real_t t6 = TB_BASE_5_X - pose[0];
    const real_t t7 = t4 * t4;
    const real_t t8 = t6 * t6;
    const real_t t9 = t7 + (t0 * TB_C(2.0) + t7) + t8;
    const real_t t10 = TB_C(1.0) / t9;
    const real_t t11 = (t5 + t1 * t6) * t10;
    const real_t t12 = pose[1] * pose[1];
    const real_t t13 = t2 + (t2 + (t12 + (t2 + t12))) - t9 * (t11 * t11);
    const real_t t14 = (wrench[1] - t11 * wrench[0]) / t13;
    const real_t t15 = t1 * t14;
    const real_t t16 = t10 * wrench[0] - t11 * t14;
    const real_t t17 = pose[0] * t16;
    const real_t share_0 = t3 * (t15 - t17);
    const real_t t18 = TB_SQRT(t0 + t12);
    const real_t t19 = pose[1] * t14;
    const real_t share_1 = -(t18 * (t17 + t19));
    const real_t t20 = TB_SQRT(t7 + t12);
    const real_t t21 = t4 * t16;
    const real_t share_2 = t20 * (t21 - t19);
    const real_t t22 = TB_SQRT(t2 + t7);
    const real_t share_3 = t22 * (t15 + t21);
    const real_t t23 = TB_SQRT(t2 + t8);
    const real_t share_4 = t23 * (t15 + t6 * t16);
    const bool t24 = TB_C(0.0001) < t3 && TB_C(0.0001) < t18 && TB_C(0.0001) < t20;
    const bool t25 = !(t24 && TB_C(0.0001) < t22 && TB_C(0.0001) < t23);
    const real_t t26 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const real_t t27 = TB_C(1.0) / t3;
    const real_t t28 = pose[0] * t27;
    const real_t t29 = TB_C(1.0) / t18;
    const real_t t30 = pose[0] * t29;
    const real_t t31 = TB_C(1.0) / t20;
    const real_t t32 = t4 * t31;
    const real_t t33 = TB_C(1.0) / t22;
    const real_t t34 = t4 * t33;
    const real_t t35 = TB_C(1.0) / t23;
    const real_t t36 = t6 * t35;
    const real_t t37 = t28 * t28 + t30 * t30 + t32 * t32 + t34 * t34 + t36 * t36;
    const real_t t38 = t1 * t27;
    const real_t t39 = pose[1] * t29;
    const real_t t40 = pose[1] * t31;
    const real_t t41 = t1 * t33;
    const real_t t42 = t1 * t35;
    const real_t t43 = t38 * t38 + t39 * t39 + t40 * t40 + t41 * t41 + t42 * t42;
    const real_t t44 = t30 * t39 - t28 * t38 - t32 * t40 + t34 * t41 + t36 * t42;
    const real_t t45 = t44 / t37;
    const bool t46 = !(t26 < t37 && t26 < t43 - t37 * (t45 * t45));
    if (t25 || t46) {
        return tb_refuse_wrench_share_eq10(TB_SINGULAR, share);
    }
    share[0] = share_0;
    share[1] = share_1;
    share[2] = share_2;
    share[3] = share_3;
    share[4] = share_4;
    return TB_OK;
}

