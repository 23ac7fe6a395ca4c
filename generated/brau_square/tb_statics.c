/* Regenerate: turnbuckle generate machines/brau_square.toml --out <this folder>
 * Machine 166f8b7fcb339437, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_statics.h"
#include "tb_machine.h"

tb_status tb_wrench(const real_t structure[8], const real_t tension[4], real_t wrench[2])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) <= TB_C(32.0)
          && TB_ABS(tension[0]) + TB_ABS(tension[1]) + TB_ABS(tension[2]) + TB_ABS(tension[3])
              <= TB_C(40000.0))) {
        wrench[0] = TB_C(0.0);
        wrench[1] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = structure[0] * tension[0] + structure[1] * tension[1];
    const real_t wrench_0 = t0 + structure[2] * tension[2] + structure[3] * tension[3];
    const real_t t1 = tension[0] * structure[4] + tension[1] * structure[5];
    const real_t wrench_1 = t1 + tension[2] * structure[6] + tension[3] * structure[7];
    wrench[0] = wrench_0;
    wrench[1] = wrench_1;
    return TB_OK;
}

/* Refuses with a status: share is 0 N. */
static tb_status tb_refuse_wrench_share_eq10(tb_status status, real_t share[4])
{
    share[0] = TB_C(0.0);
    share[1] = TB_C(0.0);
    share[2] = TB_C(0.0);
    share[3] = TB_C(0.0);
    return status;
}

tb_status tb_wrench_share_eq10(const real_t pose[2], const real_t rails[1],
    const real_t wrench[2], real_t share[4])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(80000.0))) {
        return tb_refuse_wrench_share_eq10(TB_OUT_OF_DOMAIN, share);
    }
    const real_t t0 = pose[0] * pose[0];
    const real_t t1 = pose[1] * pose[1];
    const real_t t2 = TB_SQRT(t0 + t1);
    const real_t t3 = TB_FRAME - pose[0];
    const real_t t4 = t3 * t3;
    const real_t t5 = t0 + (t4 + (t0 + t4));
    const real_t t6 = TB_C(1.0) / t5;
    const real_t t7 = TB_FRAME - pose[1];
    const real_t t8 = pose[0] * pose[1] - pose[1] * t3 + t3 * t7 - pose[0] * t7;
    const real_t t9 = t6 * t8;
    const real_t t10 = t7 * t7;
    const real_t t11 = (wrench[1] - wrench[0] * t9) / (t10 + (t1 * TB_C(2.0) + t10) - t5 * (t9
        * t9));
    const real_t t12 = wrench[0] * t6 - t9 * t11;
    const real_t t13 = pose[0] * t12;
    const real_t t14 = pose[1] * t11;
    const real_t share_0 = -(t2 * (t13 + t14));
    const real_t t15 = TB_SQRT(t1 + t4);
    const real_t t16 = t3 * t12;
    const real_t share_1 = t15 * (t16 - t14);
    const real_t t17 = TB_SQRT(t4 + t10);
    const real_t t18 = t7 * t11;
    const real_t share_2 = t17 * (t16 + t18);
    const real_t t19 = TB_SQRT(t0 + t10);
    const real_t share_3 = t19 * (t18 - t13);
    const bool t20 = TB_C(0.0001) < t2 && TB_C(0.0001) < t15 && TB_C(0.0001) < t17;
    const bool t21 = !(t20 && TB_C(0.0001) < t19);
    const real_t t22 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const real_t t23 = TB_C(1.0) / t2;
    const real_t t24 = pose[0] * t23;
    const real_t t25 = TB_C(1.0) / t15;
    const real_t t26 = t3 * t25;
    const real_t t27 = TB_C(1.0) / t17;
    const real_t t28 = t3 * t27;
    const real_t t29 = TB_C(1.0) / t19;
    const real_t t30 = pose[0] * t29;
    const real_t t31 = t24 * t24 + t26 * t26 + t28 * t28 + t30 * t30;
    const real_t t32 = pose[1] * t23;
    const real_t t33 = pose[1] * t25;
    const real_t t34 = t7 * t27;
    const real_t t35 = t7 * t29;
    const real_t t36 = (t24 * t32 - t26 * t33 + t28 * t34 - t30 * t35) / t31;
    const real_t t37 = t32 * t32 + t33 * t33 + t34 * t34 + t35 * t35 - t31 * (t36 * t36);
    const bool t38 = !(t22 < t31 && t22 < t37);
    if (t21 || t38) {
        return tb_refuse_wrench_share_eq10(TB_SINGULAR, share);
    }
    share[0] = share_0;
    share[1] = share_1;
    share[2] = share_2;
    share[3] = share_3;
    return TB_OK;
}

