/* Regenerate: turnbuckle generate machines/spidar_g.toml --out <this folder>
 * Machine 4d479a9b3a2bb17c, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_statics.h"
#include "tb_machine.h"

tb_status tb_wrench(const real_t structure[48], const real_t tension[8], real_t wrench[6])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) + TB_ABS(structure[10]) + TB_ABS(structure[11]) +
              TB_ABS(structure[12]) + TB_ABS(structure[13]) + TB_ABS(structure[14]) +
              TB_ABS(structure[15]) + TB_ABS(structure[16]) + TB_ABS(structure[17]) +
              TB_ABS(structure[18]) + TB_ABS(structure[19]) + TB_ABS(structure[20]) +
              TB_ABS(structure[21]) + TB_ABS(structure[22]) + TB_ABS(structure[23]) +
              TB_ABS(structure[24]) + TB_ABS(structure[25]) + TB_ABS(structure[26]) +
              TB_ABS(structure[27]) + TB_ABS(structure[28]) + TB_ABS(structure[29]) +
              TB_ABS(structure[30]) + TB_ABS(structure[31]) + TB_ABS(structure[32]) +
              TB_ABS(structure[33]) + TB_ABS(structure[34]) + TB_ABS(structure[35]) +
              TB_ABS(structure[36]) + TB_ABS(structure[37]) + TB_ABS(structure[38]) +
              TB_ABS(structure[39]) + TB_ABS(structure[40]) + TB_ABS(structure[41]) +
              TB_ABS(structure[42]) + TB_ABS(structure[43]) + TB_ABS(structure[44]) +
              TB_ABS(structure[45]) + TB_ABS(structure[46]) + TB_ABS(structure[47]) <=
              TB_C(192.0)
          && TB_ABS(tension[0]) + TB_ABS(tension[1]) + TB_ABS(tension[2]) + TB_ABS(tension[3])
              + TB_ABS(tension[4]) + TB_ABS(tension[5]) + TB_ABS(tension[6]) +
              TB_ABS(tension[7]) <= TB_C(64000.0))) {
        wrench[0] = TB_C(0.0);
        wrench[1] = TB_C(0.0);
        wrench[2] = TB_C(0.0);
        wrench[3] = TB_C(0.0);
        wrench[4] = TB_C(0.0);
        wrench[5] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = structure[0] * tension[0] + structure[1] * tension[1];
    const real_t t1 = t0 + structure[2] * tension[2] + structure[3] * tension[3];
    const real_t t2 = t1 + structure[4] * tension[4] + structure[5] * tension[5];
    const real_t wrench_0 = t2 + structure[6] * tension[6] + structure[7] * tension[7];
    const real_t t3 = tension[0] * structure[8] + tension[1] * structure[9];
    const real_t t4 = t3 + tension[2] * structure[10] + tension[3] * structure[11];
    const real_t t5 = t4 + tension[4] * structure[12] + tension[5] * structure[13];
    const real_t wrench_1 = t5 + tension[6] * structure[14] + tension[7] * structure[15];
    const real_t t6 = tension[0] * structure[16] + tension[1] * structure[17];
    const real_t t7 = t6 + tension[2] * structure[18] + tension[3] * structure[19];
    const real_t t8 = t7 + tension[4] * structure[20] + tension[5] * structure[21];
    const real_t wrench_2 = t8 + tension[6] * structure[22] + tension[7] * structure[23];
    const real_t t9 = tension[0] * structure[24] + tension[1] * structure[25];
    const real_t t10 = t9 + tension[2] * structure[26] + tension[3] * structure[27];
    const real_t t11 = t10 + tension[4] * structure[28] + tension[5] * structure[29];
    const real_t wrench_3 = t11 + tension[6] * structure[30] + tension[7] * structure[31];
    const real_t t12 = tension[0] * structure[32] + tension[1] * structure[33];
    const real_t t13 = t12 + tension[2] * structure[34] + tension[3] * structure[35];
    const real_t t14 = t13 + tension[4] * structure[36] + tension[5] * structure[37];
    const real_t wrench_4 = t14 + tension[6] * structure[38] + tension[7] * structure[39];
    const real_t t15 = tension[0] * structure[40] + tension[1] * structure[41];
    const real_t t16 = t15 + tension[2] * structure[42] + tension[3] * structure[43];
    const real_t t17 = t16 + tension[4] * structure[44] + tension[5] * structure[45];
    const real_t wrench_5 = t17 + tension[6] * structure[46] + tension[7] * structure[47];
    wrench[0] = wrench_0;
    wrench[1] = wrench_1;
    wrench[2] = wrench_2;
    wrench[3] = wrench_3;
    wrench[4] = wrench_4;
    wrench[5] = wrench_5;
    return TB_OK;
}

