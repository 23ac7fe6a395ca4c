/* Regenerate: turnbuckle generate machines/yoon2023.toml --out <this folder>
 * Machine 499338192b9e5092, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
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

tb_status tb_wrench_share_eq10(const real_t pose[2], const real_t rails[4],
    const real_t wrench[2], real_t share[4])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) <=
              TB_C(5.6944)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(80000.0))) {
        return tb_refuse_wrench_share_eq10(TB_OUT_OF_DOMAIN, share);
    }
    const real_t t0 = rails[0] - pose[0];
    const real_t t1 = t0 * t0;
    const real_t t2 = pose[1] * pose[1];
    const real_t t3 = TB_SQRT(t1 + t2);
    const real_t t4 = TB_FRAME_X - pose[0];
    const real_t t5 = t4 * t4;
    const real_t t6 = rails[2] - pose[0];
    const real_t t7 = t6 * t6;
    const real_t t8 = pose[0] * pose[0];
    const real_t t9 = t1 + t5 + t7 + t8;
    const real_t t10 = TB_C(1.0) / t9;
    const real_t t11 = rails[1] - pose[1];
    const real_t t12 = TB_FRAME_Y - pose[1];
    const real_t t13 = rails[3] - pose[1];
    const real_t t14 = t4 * t11 - t0 * pose[1] + t6 * t12 - pose[0] * t13;
    const real_t t15 = t10 * t14;
    const real_t t16 = t11 * t11;
    const real_t t17 = t12 * t12;
    const real_t t18 = t13 * t13;
    const real_t t19 = (wrench[1] - wrench[0] * t15) / (t2 + t16 + t17 + t18 - t9 * (t15 *
        t15));
    const real_t t20 = wrench[0] * t10 - t15 * t19;
    const real_t share_0 = t3 * (t0 * t20 - pose[1] * t19);
    const real_t t21 = TB_SQRT(t5 + t16);
    const real_t share_1 = t21 * (t4 * t20 + t11 * t19);
    const real_t t22 = TB_SQRT(t7 + t17);
    const real_t share_2 = t22 * (t6 * t20 + t12 * t19);
    const real_t t23 = TB_SQRT(t8 + t18);
    const real_t share_3 = t23 * (t13 * t19 - pose[0] * t20);
    const bool t24 = TB_C(0.0001) < t3 && TB_C(0.0001) < t21 && TB_C(0.0001) < t22;
    const bool t25 = !(t24 && TB_C(0.0001) < t23);
    const real_t t26 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const real_t t27 = TB_C(1.0) / t3;
    const real_t t28 = t0 * t27;
    const real_t t29 = TB_C(1.0) / t21;
    const real_t t30 = t4 * t29;
    const real_t t31 = TB_C(1.0) / t22;
    const real_t t32 = t6 * t31;
    const real_t t33 = TB_C(1.0) / t23;
    const real_t t34 = pose[0] * t33;
    const real_t t35 = t28 * t28 + t30 * t30 + t32 * t32 + t34 * t34;
    const real_t t36 = pose[1] * t27;
    const real_t t37 = t11 * t29;
    const real_t t38 = t12 * t31;
    const real_t t39 = t13 * t33;
    const real_t t40 = (t30 * t37 - t28 * t36 + t32 * t38 - t34 * t39) / t35;
    const real_t t41 = t36 * t36 + t37 * t37 + t38 * t38 + t39 * t39 - t35 * (t40 * t40);
    const bool t42 = !(t26 < t35 && t26 < t41);
    if (t25 || t42) {
        return tb_refuse_wrench_share_eq10(TB_SINGULAR, share);
    }
    share[0] = share_0;
    share[1] = share_1;
    share[2] = share_2;
    share[3] = share_3;
    return TB_OK;
}

/* Refuses with a status: force is 0 N. */
static tb_status tb_refuse_rail_forces(tb_status status, real_t force[4])
{
    force[0] = TB_C(0.0);
    force[1] = TB_C(0.0);
    force[2] = TB_C(0.0);
    force[3] = TB_C(0.0);
    return status;
}

tb_status tb_rail_forces(const real_t pose[2], const real_t rails[4], const real_t tension[4],
    real_t force[4])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) <=
              TB_C(5.6944)
          && TB_ABS(tension[0]) + TB_ABS(tension[1]) + TB_ABS(tension[2]) + TB_ABS(tension[3])
              <= TB_C(40000.0))) {
        return tb_refuse_rail_forces(TB_OUT_OF_DOMAIN, force);
    }
    const real_t t0 = rails[0] - pose[0];
    const real_t t1 = TB_SQRT(t0 * t0 + pose[1] * pose[1]);
    const real_t force_0 = -(tension[0] * (t0 / t1));
    const real_t t2 = rails[1] - pose[1];
    const real_t t3 = TB_FRAME_X - pose[0];
    const real_t t4 = TB_SQRT(t3 * t3 + t2 * t2);
    const real_t force_1 = -(tension[1] * (t2 / t4));
    const real_t t5 = rails[2] - pose[0];
    const real_t t6 = TB_FRAME_Y - pose[1];
    const real_t t7 = TB_SQRT(t5 * t5 + t6 * t6);
    const real_t force_2 = -(tension[2] * (t5 / t7));
    const real_t t8 = rails[3] - pose[1];
    const real_t t9 = TB_SQRT(pose[0] * pose[0] + t8 * t8);
    const real_t force_3 = -(tension[3] * (t8 / t9));
    const bool t10 = TB_C(0.0001) < t1 && TB_C(0.0001) < t4 && TB_C(0.0001) < t7;
    const bool t11 = !(t10 && TB_C(0.0001) < t9);
    if (t11) {
        return tb_refuse_rail_forces(TB_SINGULAR, force);
    }
    force[0] = force_0;
    force[1] = force_1;
    force[2] = force_2;
    force[3] = force_3;
    return TB_OK;
}

