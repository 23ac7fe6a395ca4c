/* Regenerate: turnbuckle generate machines/yoon2023.toml --out generated/yoon2023
 * Machine d6d6f47a0d1e2333, generator 0.1.0, casadi 3.8.2. Do not edit. */
#include "tb_statics.h"

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

tb_status tb_rail_forces(const real_t pose[2], const real_t rails[4], const real_t tension[4],
    real_t force[4])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) <=
              TB_C(5.6944)
          && TB_ABS(tension[0]) + TB_ABS(tension[1]) + TB_ABS(tension[2]) + TB_ABS(tension[3])
              <= TB_C(40000.0))) {
        force[0] = TB_C(0.0);
        force[1] = TB_C(0.0);
        force[2] = TB_C(0.0);
        force[3] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = rails[0] - pose[0];
    const real_t t1 = TB_SQRT(t0 * t0 + pose[1] * pose[1]);
    const real_t force_0 = -(tension[0] * (t0 / t1));
    const real_t t2 = rails[1] - pose[1];
    const real_t t3 = TB_C(0.7118) - pose[0];
    const real_t t4 = TB_SQRT(t3 * t3 + t2 * t2);
    const real_t force_1 = -(tension[1] * (t2 / t4));
    const real_t t5 = rails[2] - pose[0];
    const real_t t6 = TB_C(0.4618) - pose[1];
    const real_t t7 = TB_SQRT(t5 * t5 + t6 * t6);
    const real_t force_2 = -(tension[2] * (t5 / t7));
    const real_t t8 = rails[3] - pose[1];
    const real_t t9 = TB_SQRT(pose[0] * pose[0] + t8 * t8);
    const real_t force_3 = -(tension[3] * (t8 / t9));
    const bool t10 = TB_C(0.0001) < t1 && TB_C(0.0001) < t4 && TB_C(0.0001) < t7;
    const bool t11 = !(t10 && TB_C(0.0001) < t9);
    if (t11) {
        force[0] = TB_C(0.0);
        force[1] = TB_C(0.0);
        force[2] = TB_C(0.0);
        force[3] = TB_C(0.0);
        return TB_SINGULAR;
    }
    force[0] = force_0;
    force[1] = force_1;
    force[2] = force_2;
    force[3] = force_3;
    return TB_OK;
}

