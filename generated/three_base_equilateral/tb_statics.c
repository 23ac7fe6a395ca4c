/* Regenerate: turnbuckle generate machines/three_base_equilateral.toml --out <this folder>
 * Machine bf852767ce09ae7f, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_statics.h"
#include "tb_machine.h"

tb_status tb_wrench(const real_t structure[6], const real_t tension[3], real_t wrench[2])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) <= TB_C(24.0)
          && TB_ABS(tension[0]) + TB_ABS(tension[1]) + TB_ABS(tension[2]) <= TB_C(30000.0))) {
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

tb_status tb_wrench_share_eq10(const real_t pose[2], const real_t rails[6],
    const real_t wrench[2], real_t share[3])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) +
              TB_ABS(rails[4]) + TB_ABS(rails[5]) <= TB_C(8.541599999999999)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(60000.0))) {
        return tb_refuse_wrench_share_eq10(TB_OUT_OF_DOMAIN, share);
    }
    const real_t t0 = rails[0] - pose[0];
    const real_t t1 = t0 * t0;
    const real_t t2 = TB_FRAME - rails[1] - pose[1];
    const real_t t3 = t2 * t2;
    const real_t t4 = TB_SQRT(t1 + t3);
    const real_t t5 = rails[3] - pose[0];
    const real_t t6 = t5 * t5;
    const real_t t7 = TB_FRAME - rails[5] - pose[0];
    const real_t t8 = t7 * t7;
    const real_t t9 = t1 + t6 + t8;
    const real_t t10 = TB_C(1.0) / t9;
    const real_t t11 = rails[2] - pose[1];
    const real_t t12 = rails[4] - pose[1];
    const real_t t13 = t10 * (t0 * t2 + t5 * t11 + t7 * t12);
    const real_t t14 = t11 * t11;
    const real_t t15 = t12 * t12;
    const real_t t16 = (wrench[1] - wrench[0] * t13) / (t3 + t14 + t15 - t9 * (t13 * t13));
    const real_t t17 = wrench[0] * t10 - t13 * t16;
    const real_t share_0 = t4 * (t0 * t17 + t2 * t16);
    const real_t t18 = TB_SQRT(t6 + t14);
    const real_t share_1 = t18 * (t5 * t17 + t11 * t16);
    const real_t t19 = TB_SQRT(t8 + t15);
    const real_t share_2 = t19 * (t7 * t17 + t12 * t16);
    const bool t20 = TB_C(0.0001) < t4 && TB_C(0.0001) < t18 && TB_C(0.0001) < t19;
    const bool t21 = !t20;
    const real_t t22 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const real_t t23 = TB_C(1.0) / t4;
    const real_t t24 = t0 * t23;
    const real_t t25 = TB_C(1.0) / t18;
    const real_t t26 = t5 * t25;
    const real_t t27 = TB_C(1.0) / t19;
    const real_t t28 = t7 * t27;
    const real_t t29 = t24 * t24 + t26 * t26 + t28 * t28;
    const real_t t30 = t2 * t23;
    const real_t t31 = t11 * t25;
    const real_t t32 = t12 * t27;
    const real_t t33 = (t24 * t30 + t26 * t31 + t28 * t32) / t29;
    const real_t t34 = t30 * t30 + t31 * t31 + t32 * t32 - t29 * (t33 * t33);
    const bool t35 = !(t22 < t29 && t22 < t34);
    if (t21 || t35) {
        return tb_refuse_wrench_share_eq10(TB_SINGULAR, share);
    }
    share[0] = share_0;
    share[1] = share_1;
    share[2] = share_2;
    return TB_OK;
}

/* Refuses with a status: force is 0 N. */
static tb_status tb_refuse_rail_forces(tb_status status, real_t force[6])
{
    force[0] = TB_C(0.0);
    force[1] = TB_C(0.0);
    force[2] = TB_C(0.0);
    force[3] = TB_C(0.0);
    force[4] = TB_C(0.0);
    force[5] = TB_C(0.0);
    return status;
}

tb_status tb_rail_forces(const real_t pose[2], const real_t rails[6], const real_t tension[3],
    real_t force[6])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) +
              TB_ABS(rails[4]) + TB_ABS(rails[5]) <= TB_C(8.541599999999999)
          && TB_ABS(tension[0]) + TB_ABS(tension[1]) + TB_ABS(tension[2]) <= TB_C(30000.0))) {
        return tb_refuse_rail_forces(TB_OUT_OF_DOMAIN, force);
    }
    const real_t t0 = rails[0] - pose[0];
    const real_t t1 = TB_FRAME - rails[1] - pose[1];
    const real_t t2 = TB_SQRT(t0 * t0 + t1 * t1);
    const real_t t3 = TB_C(1.0) / t2;
    const real_t force_0 = -(tension[0] * (t0 * t3));
    const real_t force_1 = tension[0] * (t1 * t3);
    const real_t t4 = rails[2] - pose[1];
    const real_t t5 = rails[3] - pose[0];
    const real_t t6 = TB_SQRT(t5 * t5 + t4 * t4);
    const real_t t7 = TB_C(1.0) / t6;
    const real_t force_2 = -(tension[1] * (t4 * t7));
    const real_t force_3 = -(tension[1] * (t5 * t7));
    const real_t t8 = rails[4] - pose[1];
    const real_t t9 = TB_FRAME - rails[5] - pose[0];
    const real_t t10 = TB_SQRT(t9 * t9 + t8 * t8);
    const real_t t11 = TB_C(1.0) / t10;
    const real_t force_4 = -(tension[2] * (t8 * t11));
    const real_t force_5 = tension[2] * (t9 * t11);
    const bool t12 = TB_C(0.0001) < t2 && TB_C(0.0001) < t6 && TB_C(0.0001) < t10;
    const bool t13 = !t12;
    if (t13) {
        return tb_refuse_rail_forces(TB_SINGULAR, force);
    }
    force[0] = force_0;
    force[1] = force_1;
    force[2] = force_2;
    force[3] = force_3;
    force[4] = force_4;
    force[5] = force_5;
    return TB_OK;
}

