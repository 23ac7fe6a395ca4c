/* Regenerate: turnbuckle generate machines/yoon_synchronised.toml --out <this folder>
 * Machine 2674137f8fc00ebb, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
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

tb_status tb_wrench_share_eq10(const real_t pose[2], const real_t rails[2],
    const real_t wrench[2], real_t share[4])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) <= TB_C(2.8472)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(80000.0))) {
        return tb_refuse_wrench_share_eq10(TB_OUT_OF_DOMAIN, share);
    }
    const real_t t0 = rails[0] - pose[0];
    const real_t t1 = t0 * t0;
    const real_t t2 = pose[1] * pose[1];
    const real_t t3 = TB_SQRT(t1 + t2);
    const real_t t4 = TB_FRAME_X - pose[0];
    const real_t t5 = t4 * t4;
    const real_t t6 = pose[0] * pose[0];
    const real_t t7 = t1 + (t1 + t5) + t6;
    const real_t t8 = TB_C(1.0) / t7;
    const real_t t9 = rails[1] - pose[1];
    const real_t t10 = TB_FRAME_Y - pose[1];
    const real_t t11 = t8 * (t4 * t9 - t0 * pose[1] + t0 * t10 - pose[0] * t9);
    const real_t t12 = t9 * t9;
    const real_t t13 = t10 * t10;
    const real_t t14 = (wrench[1] - wrench[0] * t11) / (t12 + (t2 + t12 + t13) - t7 * (t11 *
        t11));
    const real_t t15 = wrench[0] * t8 - t11 * t14;
    const real_t t16 = t0 * t15;
    const real_t share_0 = t3 * (t16 - pose[1] * t14);
    const real_t t17 = TB_SQRT(t5 + t12);
    const real_t t18 = t9 * t14;
    const real_t share_1 = t17 * (t4 * t15 + t18);
    const real_t t19 = TB_SQRT(t1 + t13);
    const real_t share_2 = t19 * (t16 + t10 * t14);
    const real_t t20 = TB_SQRT(t6 + t12);
    const real_t share_3 = t20 * (t18 - pose[0] * t15);
    const bool t21 = TB_C(0.0001) < t3 && TB_C(0.0001) < t17 && TB_C(0.0001) < t19;
    const bool t22 = !(t21 && TB_C(0.0001) < t20);
    const real_t t23 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const real_t t24 = TB_C(1.0) / t3;
    const real_t t25 = t0 * t24;
    const real_t t26 = TB_C(1.0) / t17;
    const real_t t27 = t4 * t26;
    const real_t t28 = TB_C(1.0) / t19;
    const real_t t29 = t0 * t28;
    const real_t t30 = TB_C(1.0) / t20;
    const real_t t31 = pose[0] * t30;
    const real_t t32 = t25 * t25 + t27 * t27 + t29 * t29 + t31 * t31;
    const real_t t33 = pose[1] * t24;
    const real_t t34 = t9 * t26;
    const real_t t35 = t10 * t28;
    const real_t t36 = t9 * t30;
    const real_t t37 = (t27 * t34 - t25 * t33 + t29 * t35 - t31 * t36) / t32;
    const real_t t38 = t33 * t33 + t34 * t34 + t35 * t35 + t36 * t36 - t32 * (t37 * t37);
    const bool t39 = !(t23 < t32 && t23 < t38);
    if (t22 || t39) {
        return tb_refuse_wrench_share_eq10(TB_SINGULAR, share);
    }
    share[0] = share_0;
    share[1] = share_1;
    share[2] = share_2;
    share[3] = share_3;
    return TB_OK;
}

/* Refuses with a status: force is 0 N. */
static tb_status tb_refuse_rail_forces(tb_status status, real_t force[2])
{
    force[0] = TB_C(0.0);
    force[1] = TB_C(0.0);
    return status;
}

tb_status tb_rail_forces(const real_t pose[2], const real_t rails[2], const real_t tension[4],
    real_t force[2])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) <= TB_C(2.8472)
          && TB_ABS(tension[0]) + TB_ABS(tension[1]) + TB_ABS(tension[2]) + TB_ABS(tension[3])
              <= TB_C(40000.0))) {
        return tb_refuse_rail_forces(TB_OUT_OF_DOMAIN, force);
    }
    const real_t t0 = rails[0] - pose[0];
    const real_t t1 = t0 * t0;
    const real_t t2 = TB_SQRT(t1 + pose[1] * pose[1]);
    const real_t t3 = TB_FRAME_Y - pose[1];
    const real_t t4 = TB_SQRT(t1 + t3 * t3);
    const real_t force_0 = -(tension[0] * (t0 / t2) + tension[2] * (t0 / t4));
    const real_t t5 = rails[1] - pose[1];
    const real_t t6 = TB_FRAME_X - pose[0];
    const real_t t7 = t5 * t5;
    const real_t t8 = TB_SQRT(t6 * t6 + t7);
    const real_t t9 = TB_SQRT(t7 + pose[0] * pose[0]);
    const real_t force_1 = -(tension[1] * (t5 / t8) + tension[3] * (t5 / t9));
    const bool t10 = TB_C(0.0001) < t2 && TB_C(0.0001) < t8 && TB_C(0.0001) < t4;
    const bool t11 = !(t10 && TB_C(0.0001) < t9);
    if (t11) {
        return tb_refuse_rail_forces(TB_SINGULAR, force);
    }
    force[0] = force_0;
    force[1] = force_1;
    return TB_OK;
}

