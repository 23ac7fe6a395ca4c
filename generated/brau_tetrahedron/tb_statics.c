/* Regenerate: turnbuckle generate machines/brau_tetrahedron.toml --out <this folder>
 * Machine 1c3579fddb96c4cf, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_statics.h"
#include "tb_machine.h"

tb_status tb_wrench(const real_t structure[12], const real_t tension[4], real_t wrench[3])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) + TB_ABS(structure[10]) + TB_ABS(structure[11]) <= TB_C(48.0)
          && TB_ABS(tension[0]) + TB_ABS(tension[1]) + TB_ABS(tension[2]) + TB_ABS(tension[3])
              <= TB_C(80000.0))) {
        wrench[0] = TB_C(0.0);
        wrench[1] = TB_C(0.0);
        wrench[2] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = structure[0] * tension[0] + structure[1] * tension[1];
    const real_t wrench_0 = t0 + structure[2] * tension[2] + structure[3] * tension[3];
    const real_t t1 = tension[0] * structure[4] + tension[1] * structure[5];
    const real_t wrench_1 = t1 + tension[2] * structure[6] + tension[3] * structure[7];
    const real_t t2 = tension[0] * structure[8] + tension[1] * structure[9];
    const real_t wrench_2 = t2 + tension[2] * structure[10] + tension[3] * structure[11];
    wrench[0] = wrench_0;
    wrench[1] = wrench_1;
    wrench[2] = wrench_2;
    return TB_OK;
}

