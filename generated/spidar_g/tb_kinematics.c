/* Regenerate: turnbuckle generate machines/spidar_g.toml --out <this folder>
 * Machine 4d479a9b3a2bb17c, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_kinematics.h"
#include "tb_machine.h"

tb_status tb_base_points(const real_t rails[1], real_t points[24])
{
    (void)rails;
    points[0] = TB_C(0.0);
    points[1] = TB_C(0.0);
    points[2] = TB_C(0.0);
    points[3] = TB_C(0.0);
    points[4] = TB_C(0.0);
    points[5] = TB_FRAME;
    points[6] = TB_C(0.0);
    points[7] = TB_FRAME;
    points[8] = TB_C(0.0);
    points[9] = TB_C(0.0);
    points[10] = TB_FRAME;
    points[11] = TB_FRAME;
    points[12] = TB_FRAME;
    points[13] = TB_C(0.0);
    points[14] = TB_C(0.0);
    points[15] = TB_FRAME;
    points[16] = TB_C(0.0);
    points[17] = TB_FRAME;
    points[18] = TB_FRAME;
    points[19] = TB_FRAME;
    points[20] = TB_C(0.0);
    points[21] = TB_FRAME;
    points[22] = TB_FRAME;
    points[23] = TB_FRAME;
    return TB_OK;
}

tb_status tb_cable_vectors(const real_t pose[6], const real_t rails[1], real_t vectors[24])
{
    (void)rails;
    if (!(pose[0] >= -TB_C(1.2) && pose[0] <= TB_C(1.2)
          && pose[1] >= -TB_C(1.2) && pose[1] <= TB_C(1.2)
          && pose[2] >= -TB_C(1.2) && pose[2] <= TB_C(1.2)
          && pose[3] >= -TB_C(1.5471975511965979) && pose[3] <= TB_C(1.5471975511965979)
          && pose[4] >= -TB_C(1.5471975511965979) && pose[4] <= TB_C(1.5471975511965979)
          && pose[5] >= -TB_C(1.5471975511965979) && pose[5] <= TB_C(1.5471975511965979))) {
        vectors[0] = TB_C(0.0);
        vectors[1] = TB_C(0.0);
        vectors[2] = TB_C(0.0);
        vectors[3] = TB_C(0.0);
        vectors[4] = TB_C(0.0);
        vectors[5] = TB_C(0.0);
        vectors[6] = TB_C(0.0);
        vectors[7] = TB_C(0.0);
        vectors[8] = TB_C(0.0);
        vectors[9] = TB_C(0.0);
        vectors[10] = TB_C(0.0);
        vectors[11] = TB_C(0.0);
        vectors[12] = TB_C(0.0);
        vectors[13] = TB_C(0.0);
        vectors[14] = TB_C(0.0);
        vectors[15] = TB_C(0.0);
        vectors[16] = TB_C(0.0);
        vectors[17] = TB_C(0.0);
        vectors[18] = TB_C(0.0);
        vectors[19] = TB_C(0.0);
        vectors[20] = TB_C(0.0);
        vectors[21] = TB_C(0.0);
        vectors[22] = TB_C(0.0);
        vectors[23] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = pose[3] * pose[3] + pose[4] * pose[4] + pose[5] * pose[5];
    const real_t t1 = t0 * TB_C(0.25);
    const real_t t2 = TB_C(6.446950284384474e-26) + t1 * -TB_C(9.183689863795546e-29);
    const real_t t3 = TB_C(1.9572941063391263e-20) + t1 * (-TB_C(3.8681701706306835e-23) + t1 *
        t2);
    const real_t t4 = TB_C(2.8114572543455206e-15) + t1 * (-TB_C(8.22063524662433e-18) + t1 *
        t3);
    const real_t t5 = TB_C(1.6059043836821613e-10) + t1 * (-TB_C(7.647163731819816e-13) + t1 *
        t4);
    const real_t t6 = TB_C(2.7557319223985893e-06) + t1 * (-TB_C(2.505210838544172e-08) + t1 *
        t5);
    const real_t t7 = TB_C(0.008333333333333333) + t1 * (-TB_C(0.0001984126984126984) + t1 *
        t6);
    const real_t t8 = TB_C(1.0) + t1 * (-TB_C(0.16666666666666666) + t1 * t7);
    const real_t t9 = t8 * TB_C(0.5);
    const real_t t10 = pose[3] * t9;
    const real_t t11 = pose[4] * t9;
    const real_t t12 = t10 * t11;
    const real_t t13 = -TB_C(2.4795962632247972e-27) + t1 * TB_C(3.279889237069838e-30);
    const real_t t14 = -TB_C(8.896791392450574e-22) + t1 * (TB_C(1.6117375710961184e-24) + t1 *
        t13);
    const real_t t15 = -TB_C(1.5619206968586225e-16) + t1 * (TB_C(4.110317623312165e-19) + t1 *
        t14);
    const real_t t16 = -TB_C(1.1470745597729725e-11) + t1 * (TB_C(4.779477332387385e-14) + t1 *
        t15);
    const real_t t17 = -TB_C(2.755731922398589e-07) + t1 * (TB_C(2.08767569878681e-09) + t1 *
        t16);
    const real_t t18 = -TB_C(0.001388888888888889) + t1 * (TB_C(2.48015873015873e-05) + t1 *
        t17);
    const real_t t19 = -TB_C(0.5) + t1 * (TB_C(0.041666666666666664) + t1 * t18);
    const real_t t20 = TB_C(1.0) + t1 * t19;
    const real_t t21 = pose[5] * t9;
    const real_t t22 = t20 * t21;
    const real_t t23 = t12 - t22;
    const real_t t24 = t10 * t21;
    const real_t t25 = t11 * t20;
    const real_t t26 = t24 + t25;
    const real_t t27 = TB_C(0.08) * t26;
    /* R p_i, from the platform's centre to its anchors */
    const real_t arm_12 = -TB_C(0.12) * t23 + t27;
    const real_t t28 = pose[0] + arm_12;
    const real_t vectors_0 = -t28;
    const real_t t29 = t11 * t11;
    const real_t t30 = t10 * t10;
    const real_t t31 = t21 * t21;
    const real_t t32 = t20 * t20 - (t29 + t30 + t31);
    const real_t t33 = TB_C(2.0) * t29 + t32;
    const real_t t34 = t11 * t21;
    const real_t t35 = t10 * t20;
    const real_t t36 = t34 - t35;
    const real_t t37 = TB_C(0.08) * t36;
    const real_t arm_13 = -TB_C(0.06) * t33 + t37;
    const real_t vectors_1 = -(pose[1] + arm_13);
    const real_t t38 = t34 + t35;
    const real_t t39 = t32 + TB_C(2.0) * t31;
    const real_t t40 = TB_C(0.04) * t39;
    const real_t arm_14 = -TB_C(0.12) * t38 + t40;
    const real_t vectors_2 = -(pose[2] + arm_14);
    const real_t t41 = t32 + TB_C(2.0) * t30;
    const real_t t42 = t26 * -TB_C(0.08);
    const real_t arm_9 = -TB_C(0.06) * t41 + t42;
    const real_t vectors_3 = -(pose[0] + arm_9);
    const real_t t43 = t12 + t22;
    const real_t t44 = t36 * -TB_C(0.08);
    const real_t arm_10 = -TB_C(0.12) * t43 + t44;
    const real_t t45 = pose[1] + arm_10;
    const real_t vectors_4 = -t45;
    const real_t t46 = t24 - t25;
    const real_t t47 = t39 * -TB_C(0.04);
    const real_t arm_11 = -TB_C(0.12) * t46 + t47;
    const real_t vectors_5 = TB_FRAME - (pose[2] + arm_11);
    const real_t arm_18 = t27 + t23 * TB_C(0.12);
    const real_t t48 = pose[0] + arm_18;
    const real_t vectors_6 = -t48;
    const real_t arm_19 = t37 + t33 * TB_C(0.06);
    const real_t vectors_7 = TB_FRAME - (pose[1] + arm_19);
    const real_t arm_20 = t40 + t38 * TB_C(0.12);
    const real_t vectors_8 = -(pose[2] + arm_20);
    const real_t vectors_10 = TB_FRAME - t45;
    const real_t vectors_12 = TB_FRAME - t28;
    const real_t arm_21 = t42 + t41 * TB_C(0.06);
    const real_t vectors_15 = TB_FRAME - (pose[0] + arm_21);
    const real_t arm_22 = t44 + t43 * TB_C(0.12);
    const real_t t49 = pose[1] + arm_22;
    const real_t vectors_16 = -t49;
    const real_t arm_23 = t47 + t46 * TB_C(0.12);
    const real_t vectors_17 = TB_FRAME - (pose[2] + arm_23);
    const real_t vectors_18 = TB_FRAME - t48;
    const real_t vectors_22 = TB_FRAME - t49;
    vectors[0] = vectors_0;
    vectors[1] = vectors_1;
    vectors[2] = vectors_2;
    vectors[3] = vectors_3;
    vectors[4] = vectors_4;
    vectors[5] = vectors_5;
    vectors[6] = vectors_6;
    vectors[7] = vectors_7;
    vectors[8] = vectors_8;
    vectors[9] = vectors_3;
    vectors[10] = vectors_10;
    vectors[11] = vectors_5;
    vectors[12] = vectors_12;
    vectors[13] = vectors_1;
    vectors[14] = vectors_2;
    vectors[15] = vectors_15;
    vectors[16] = vectors_16;
    vectors[17] = vectors_17;
    vectors[18] = vectors_18;
    vectors[19] = vectors_7;
    vectors[20] = vectors_8;
    vectors[21] = vectors_15;
    vectors[22] = vectors_22;
    vectors[23] = vectors_17;
    return TB_OK;
}

/* Refuses with a status: length is 0 m. */
static tb_status tb_refuse_cable_lengths(tb_status status, real_t length[8])
{
    length[0] = TB_C(0.0);
    length[1] = TB_C(0.0);
    length[2] = TB_C(0.0);
    length[3] = TB_C(0.0);
    length[4] = TB_C(0.0);
    length[5] = TB_C(0.0);
    length[6] = TB_C(0.0);
    length[7] = TB_C(0.0);
    return status;
}

tb_status tb_cable_lengths(const real_t pose[6], const real_t rails[1], real_t length[8])
{
    (void)rails;
    if (!(pose[0] >= -TB_C(1.2) && pose[0] <= TB_C(1.2)
          && pose[1] >= -TB_C(1.2) && pose[1] <= TB_C(1.2)
          && pose[2] >= -TB_C(1.2) && pose[2] <= TB_C(1.2)
          && pose[3] >= -TB_C(1.5471975511965979) && pose[3] <= TB_C(1.5471975511965979)
          && pose[4] >= -TB_C(1.5471975511965979) && pose[4] <= TB_C(1.5471975511965979)
          && pose[5] >= -TB_C(1.5471975511965979) && pose[5] <= TB_C(1.5471975511965979))) {
        return tb_refuse_cable_lengths(TB_OUT_OF_DOMAIN, length);
    }
    const real_t t0 = pose[3] * pose[3] + pose[4] * pose[4] + pose[5] * pose[5];
    const real_t t1 = t0 * TB_C(0.25);
    const real_t t2 = TB_C(6.446950284384474e-26) + t1 * -TB_C(9.183689863795546e-29);
    const real_t t3 = TB_C(1.9572941063391263e-20) + t1 * (-TB_C(3.8681701706306835e-23) + t1 *
        t2);
    const real_t t4 = TB_C(2.8114572543455206e-15) + t1 * (-TB_C(8.22063524662433e-18) + t1 *
        t3);
    const real_t t5 = TB_C(1.6059043836821613e-10) + t1 * (-TB_C(7.647163731819816e-13) + t1 *
        t4);
    const real_t t6 = TB_C(2.7557319223985893e-06) + t1 * (-TB_C(2.505210838544172e-08) + t1 *
        t5);
    const real_t t7 = TB_C(0.008333333333333333) + t1 * (-TB_C(0.0001984126984126984) + t1 *
        t6);
    const real_t t8 = TB_C(1.0) + t1 * (-TB_C(0.16666666666666666) + t1 * t7);
    const real_t t9 = t8 * TB_C(0.5);
    const real_t t10 = pose[3] * t9;
    const real_t t11 = pose[4] * t9;
    const real_t t12 = t10 * t11;
    const real_t t13 = -TB_C(2.4795962632247972e-27) + t1 * TB_C(3.279889237069838e-30);
    const real_t t14 = -TB_C(8.896791392450574e-22) + t1 * (TB_C(1.6117375710961184e-24) + t1 *
        t13);
    const real_t t15 = -TB_C(1.5619206968586225e-16) + t1 * (TB_C(4.110317623312165e-19) + t1 *
        t14);
    const real_t t16 = -TB_C(1.1470745597729725e-11) + t1 * (TB_C(4.779477332387385e-14) + t1 *
        t15);
    const real_t t17 = -TB_C(2.755731922398589e-07) + t1 * (TB_C(2.08767569878681e-09) + t1 *
        t16);
    const real_t t18 = -TB_C(0.001388888888888889) + t1 * (TB_C(2.48015873015873e-05) + t1 *
        t17);
    const real_t t19 = -TB_C(0.5) + t1 * (TB_C(0.041666666666666664) + t1 * t18);
    const real_t t20 = TB_C(1.0) + t1 * t19;
    const real_t t21 = pose[5] * t9;
    const real_t t22 = t20 * t21;
    const real_t t23 = t12 - t22;
    const real_t t24 = t10 * t21;
    const real_t t25 = t11 * t20;
    const real_t t26 = t24 + t25;
    const real_t t27 = TB_C(0.08) * t26;
    /* R p_i, from the platform's centre to its anchors */
    const real_t arm_12 = -TB_C(0.12) * t23 + t27;
    const real_t t28 = pose[0] + arm_12;
    const real_t t29 = t11 * t11;
    const real_t t30 = t10 * t10;
    const real_t t31 = t21 * t21;
    const real_t t32 = t20 * t20 - (t29 + t30 + t31);
    const real_t t33 = TB_C(2.0) * t29 + t32;
    const real_t t34 = t11 * t21;
    const real_t t35 = t10 * t20;
    const real_t t36 = t34 - t35;
    const real_t t37 = TB_C(0.08) * t36;
    const real_t arm_13 = -TB_C(0.06) * t33 + t37;
    const real_t t38 = pose[1] + arm_13;
    const real_t t39 = t38 * t38;
    const real_t t40 = t34 + t35;
    const real_t t41 = t32 + TB_C(2.0) * t31;
    const real_t t42 = TB_C(0.04) * t41;
    const real_t arm_14 = -TB_C(0.12) * t40 + t42;
    const real_t t43 = pose[2] + arm_14;
    const real_t t44 = t43 * t43;
    const real_t length_0 = TB_SQRT(t28 * t28 + t39 + t44);
    const real_t t45 = t32 + TB_C(2.0) * t30;
    const real_t t46 = t26 * -TB_C(0.08);
    const real_t arm_9 = -TB_C(0.06) * t45 + t46;
    const real_t t47 = pose[0] + arm_9;
    const real_t t48 = t47 * t47;
    const real_t t49 = t12 + t22;
    const real_t t50 = t36 * -TB_C(0.08);
    const real_t arm_10 = -TB_C(0.12) * t49 + t50;
    const real_t t51 = pose[1] + arm_10;
    const real_t t52 = t24 - t25;
    const real_t t53 = t41 * -TB_C(0.04);
    const real_t arm_11 = -TB_C(0.12) * t52 + t53;
    const real_t t54 = TB_FRAME - (pose[2] + arm_11);
    const real_t t55 = t54 * t54;
    const real_t length_1 = TB_SQRT(t48 + t51 * t51 + t55);
    const real_t arm_18 = t27 + t23 * TB_C(0.12);
    const real_t t56 = pose[0] + arm_18;
    const real_t arm_19 = t37 + t33 * TB_C(0.06);
    const real_t t57 = TB_FRAME - (pose[1] + arm_19);
    const real_t t58 = t57 * t57;
    const real_t arm_20 = t42 + t40 * TB_C(0.12);
    const real_t t59 = pose[2] + arm_20;
    const real_t t60 = t59 * t59;
    const real_t length_2 = TB_SQRT(t56 * t56 + t58 + t60);
    const real_t t61 = TB_FRAME - t51;
    const real_t length_3 = TB_SQRT(t55 + (t48 + t61 * t61));
    const real_t t62 = TB_FRAME - t28;
    const real_t length_4 = TB_SQRT(t44 + (t39 + t62 * t62));
    const real_t arm_21 = t46 + t45 * TB_C(0.06);
    const real_t t63 = TB_FRAME - (pose[0] + arm_21);
    const real_t t64 = t63 * t63;
    const real_t arm_22 = t50 + t49 * TB_C(0.12);
    const real_t t65 = pose[1] + arm_22;
    const real_t arm_23 = t53 + t52 * TB_C(0.12);
    const real_t t66 = TB_FRAME - (pose[2] + arm_23);
    const real_t t67 = t66 * t66;
    const real_t length_5 = TB_SQRT(t64 + t65 * t65 + t67);
    const real_t t68 = TB_FRAME - t56;
    const real_t length_6 = TB_SQRT(t60 + (t58 + t68 * t68));
    const real_t t69 = TB_FRAME - t65;
    const real_t length_7 = TB_SQRT(t67 + (t64 + t69 * t69));
    const bool t70 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t71 = t70 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t72 = t71 && TB_C(0.0001) < length_4 && TB_C(0.0001) < length_5;
    const bool t73 = t72 && TB_C(0.0001) < length_6 && TB_C(0.0001) < length_7;
    const bool t74 = !t73;
    if (t74) {
        return tb_refuse_cable_lengths(TB_SINGULAR, length);
    }
    length[0] = length_0;
    length[1] = length_1;
    length[2] = length_2;
    length[3] = length_3;
    length[4] = length_4;
    length[5] = length_5;
    length[6] = length_6;
    length[7] = length_7;
    return TB_OK;
}

/* Refuses with a status: structure is 0 1, m. */
static tb_status tb_refuse_structure_matrix(tb_status status, real_t structure[48])
{
    structure[0] = TB_C(0.0);
    structure[1] = TB_C(0.0);
    structure[2] = TB_C(0.0);
    structure[3] = TB_C(0.0);
    structure[4] = TB_C(0.0);
    structure[5] = TB_C(0.0);
    structure[6] = TB_C(0.0);
    structure[7] = TB_C(0.0);
    structure[8] = TB_C(0.0);
    structure[9] = TB_C(0.0);
    structure[10] = TB_C(0.0);
    structure[11] = TB_C(0.0);
    structure[12] = TB_C(0.0);
    structure[13] = TB_C(0.0);
    structure[14] = TB_C(0.0);
    structure[15] = TB_C(0.0);
    structure[16] = TB_C(0.0);
    structure[17] = TB_C(0.0);
    structure[18] = TB_C(0.0);
    structure[19] = TB_C(0.0);
    structure[20] = TB_C(0.0);
    structure[21] = TB_C(0.0);
    structure[22] = TB_C(0.0);
    structure[23] = TB_C(0.0);
    structure[24] = TB_C(0.0);
    structure[25] = TB_C(0.0);
    structure[26] = TB_C(0.0);
    structure[27] = TB_C(0.0);
    structure[28] = TB_C(0.0);
    structure[29] = TB_C(0.0);
    structure[30] = TB_C(0.0);
    structure[31] = TB_C(0.0);
    structure[32] = TB_C(0.0);
    structure[33] = TB_C(0.0);
    structure[34] = TB_C(0.0);
    structure[35] = TB_C(0.0);
    structure[36] = TB_C(0.0);
    structure[37] = TB_C(0.0);
    structure[38] = TB_C(0.0);
    structure[39] = TB_C(0.0);
    structure[40] = TB_C(0.0);
    structure[41] = TB_C(0.0);
    structure[42] = TB_C(0.0);
    structure[43] = TB_C(0.0);
    structure[44] = TB_C(0.0);
    structure[45] = TB_C(0.0);
    structure[46] = TB_C(0.0);
    structure[47] = TB_C(0.0);
    return status;
}

tb_status tb_structure_matrix(const real_t pose[6], const real_t rails[1], real_t structure[48])
{
    (void)rails;
    if (!(pose[0] >= -TB_C(1.2) && pose[0] <= TB_C(1.2)
          && pose[1] >= -TB_C(1.2) && pose[1] <= TB_C(1.2)
          && pose[2] >= -TB_C(1.2) && pose[2] <= TB_C(1.2)
          && pose[3] >= -TB_C(1.5471975511965979) && pose[3] <= TB_C(1.5471975511965979)
          && pose[4] >= -TB_C(1.5471975511965979) && pose[4] <= TB_C(1.5471975511965979)
          && pose[5] >= -TB_C(1.5471975511965979) && pose[5] <= TB_C(1.5471975511965979))) {
        return tb_refuse_structure_matrix(TB_OUT_OF_DOMAIN, structure);
    }
    const real_t t0 = pose[3] * pose[3] + pose[4] * pose[4] + pose[5] * pose[5];
    const real_t t1 = t0 * TB_C(0.25);
    const real_t t2 = TB_C(6.446950284384474e-26) + t1 * -TB_C(9.183689863795546e-29);
    const real_t t3 = TB_C(1.9572941063391263e-20) + t1 * (-TB_C(3.8681701706306835e-23) + t1 *
        t2);
    const real_t t4 = TB_C(2.8114572543455206e-15) + t1 * (-TB_C(8.22063524662433e-18) + t1 *
        t3);
    const real_t t5 = TB_C(1.6059043836821613e-10) + t1 * (-TB_C(7.647163731819816e-13) + t1 *
        t4);
    const real_t t6 = TB_C(2.7557319223985893e-06) + t1 * (-TB_C(2.505210838544172e-08) + t1 *
        t5);
    const real_t t7 = TB_C(0.008333333333333333) + t1 * (-TB_C(0.0001984126984126984) + t1 *
        t6);
    const real_t t8 = TB_C(1.0) + t1 * (-TB_C(0.16666666666666666) + t1 * t7);
    const real_t t9 = t8 * TB_C(0.5);
    const real_t t10 = pose[3] * t9;
    const real_t t11 = pose[4] * t9;
    const real_t t12 = t10 * t11;
    const real_t t13 = -TB_C(2.4795962632247972e-27) + t1 * TB_C(3.279889237069838e-30);
    const real_t t14 = -TB_C(8.896791392450574e-22) + t1 * (TB_C(1.6117375710961184e-24) + t1 *
        t13);
    const real_t t15 = -TB_C(1.5619206968586225e-16) + t1 * (TB_C(4.110317623312165e-19) + t1 *
        t14);
    const real_t t16 = -TB_C(1.1470745597729725e-11) + t1 * (TB_C(4.779477332387385e-14) + t1 *
        t15);
    const real_t t17 = -TB_C(2.755731922398589e-07) + t1 * (TB_C(2.08767569878681e-09) + t1 *
        t16);
    const real_t t18 = -TB_C(0.001388888888888889) + t1 * (TB_C(2.48015873015873e-05) + t1 *
        t17);
    const real_t t19 = -TB_C(0.5) + t1 * (TB_C(0.041666666666666664) + t1 * t18);
    const real_t t20 = TB_C(1.0) + t1 * t19;
    const real_t t21 = pose[5] * t9;
    const real_t t22 = t20 * t21;
    const real_t t23 = t12 - t22;
    const real_t t24 = t10 * t21;
    const real_t t25 = t11 * t20;
    const real_t t26 = t24 + t25;
    const real_t t27 = TB_C(0.08) * t26;
    /* R p_i, from the platform's centre to its anchors */
    const real_t arm_12 = -TB_C(0.12) * t23 + t27;
    const real_t t28 = pose[0] + arm_12;
    const real_t t29 = t11 * t11;
    const real_t t30 = t10 * t10;
    const real_t t31 = t21 * t21;
    const real_t t32 = t20 * t20 - (t29 + t30 + t31);
    const real_t t33 = TB_C(2.0) * t29 + t32;
    const real_t t34 = t11 * t21;
    const real_t t35 = t10 * t20;
    const real_t t36 = t34 - t35;
    const real_t t37 = TB_C(0.08) * t36;
    const real_t arm_13 = -TB_C(0.06) * t33 + t37;
    const real_t t38 = pose[1] + arm_13;
    const real_t t39 = t38 * t38;
    const real_t t40 = t34 + t35;
    const real_t t41 = t32 + TB_C(2.0) * t31;
    const real_t t42 = TB_C(0.04) * t41;
    const real_t arm_14 = -TB_C(0.12) * t40 + t42;
    const real_t t43 = pose[2] + arm_14;
    const real_t t44 = t43 * t43;
    /* l_i = |b_i - c - R p_i|, Yoon eq. 1 */
    const real_t length_0 = TB_SQRT(t28 * t28 + t39 + t44);
    const real_t t45 = TB_C(1.0) / length_0;
    const real_t t46 = t28 * t45;
    const real_t structure_0 = -t46;
    const real_t t47 = t32 + TB_C(2.0) * t30;
    const real_t t48 = t26 * -TB_C(0.08);
    const real_t arm_9 = -TB_C(0.06) * t47 + t48;
    const real_t t49 = pose[0] + arm_9;
    const real_t t50 = t49 * t49;
    const real_t t51 = t12 + t22;
    const real_t t52 = t36 * -TB_C(0.08);
    const real_t arm_10 = -TB_C(0.12) * t51 + t52;
    const real_t t53 = pose[1] + arm_10;
    const real_t t54 = t24 - t25;
    const real_t t55 = t41 * -TB_C(0.04);
    const real_t arm_11 = -TB_C(0.12) * t54 + t55;
    const real_t t56 = TB_FRAME - (pose[2] + arm_11);
    const real_t t57 = t56 * t56;
    const real_t length_1 = TB_SQRT(t50 + t53 * t53 + t57);
    const real_t t58 = TB_C(1.0) / length_1;
    const real_t t59 = t49 * t58;
    const real_t structure_1 = -t59;
    const real_t arm_18 = t27 + t23 * TB_C(0.12);
    const real_t t60 = pose[0] + arm_18;
    const real_t arm_19 = t37 + t33 * TB_C(0.06);
    const real_t t61 = TB_FRAME - (pose[1] + arm_19);
    const real_t t62 = t61 * t61;
    const real_t arm_20 = t42 + t40 * TB_C(0.12);
    const real_t t63 = pose[2] + arm_20;
    const real_t t64 = t63 * t63;
    const real_t length_2 = TB_SQRT(t60 * t60 + t62 + t64);
    const real_t t65 = TB_C(1.0) / length_2;
    const real_t t66 = t60 * t65;
    const real_t structure_2 = -t66;
    const real_t t67 = TB_FRAME - t53;
    const real_t length_3 = TB_SQRT(t57 + (t50 + t67 * t67));
    const real_t t68 = TB_C(1.0) / length_3;
    const real_t t69 = t49 * t68;
    const real_t structure_3 = -t69;
    const real_t t70 = TB_FRAME - t28;
    const real_t length_4 = TB_SQRT(t44 + (t39 + t70 * t70));
    const real_t t71 = TB_C(1.0) / length_4;
    const real_t structure_4 = t70 * t71;
    const real_t arm_21 = t48 + t47 * TB_C(0.06);
    const real_t t72 = TB_FRAME - (pose[0] + arm_21);
    const real_t t73 = t72 * t72;
    const real_t arm_22 = t52 + t51 * TB_C(0.12);
    const real_t t74 = pose[1] + arm_22;
    const real_t arm_23 = t55 + t54 * TB_C(0.12);
    const real_t t75 = TB_FRAME - (pose[2] + arm_23);
    const real_t t76 = t75 * t75;
    const real_t length_5 = TB_SQRT(t73 + t74 * t74 + t76);
    const real_t t77 = TB_C(1.0) / length_5;
    const real_t structure_5 = t72 * t77;
    const real_t t78 = TB_FRAME - t60;
    const real_t length_6 = TB_SQRT(t64 + (t62 + t78 * t78));
    const real_t t79 = TB_C(1.0) / length_6;
    const real_t structure_6 = t78 * t79;
    const real_t t80 = TB_FRAME - t74;
    const real_t length_7 = TB_SQRT(t76 + (t73 + t80 * t80));
    const real_t t81 = TB_C(1.0) / length_7;
    const real_t structure_7 = t72 * t81;
    const real_t t82 = t38 * t45;
    const real_t structure_8 = -t82;
    const real_t t83 = t53 * t58;
    const real_t structure_9 = -t83;
    const real_t structure_10 = t61 * t65;
    const real_t structure_11 = t67 * t68;
    const real_t t84 = t38 * t71;
    const real_t structure_12 = -t84;
    const real_t t85 = t74 * t77;
    const real_t structure_13 = -t85;
    const real_t structure_14 = t61 * t79;
    const real_t structure_15 = t80 * t81;
    const real_t t86 = t43 * t45;
    const real_t structure_16 = -t86;
    const real_t structure_17 = t56 * t58;
    const real_t t87 = t63 * t65;
    const real_t structure_18 = -t87;
    const real_t structure_19 = t56 * t68;
    const real_t t88 = t43 * t71;
    const real_t structure_20 = -t88;
    const real_t structure_21 = t75 * t77;
    const real_t t89 = t63 * t79;
    const real_t structure_22 = -t89;
    const real_t structure_23 = t75 * t81;
    const real_t structure_24 = arm_14 * t82 - arm_13 * t86;
    const real_t structure_25 = arm_11 * t83 + arm_10 * structure_17;
    const real_t structure_26 = -(arm_20 * structure_10 + arm_19 * t87);
    const real_t structure_27 = arm_10 * structure_19 - arm_11 * structure_11;
    const real_t structure_28 = arm_14 * t84 - arm_13 * t88;
    const real_t structure_29 = arm_23 * t85 + arm_22 * structure_21;
    const real_t structure_30 = -(arm_20 * structure_14 + arm_19 * t89);
    const real_t structure_31 = arm_22 * structure_23 - arm_23 * structure_15;
    const real_t structure_32 = arm_12 * t86 - arm_14 * t46;
    const real_t structure_33 = -(arm_11 * t59 + arm_9 * structure_17);
    const real_t structure_34 = arm_18 * t87 - arm_20 * t66;
    const real_t structure_35 = -(arm_11 * t69 + arm_9 * structure_19);
    const real_t structure_36 = arm_14 * structure_4 + arm_12 * t88;
    const real_t structure_37 = arm_23 * structure_5 - arm_21 * structure_21;
    const real_t structure_38 = arm_20 * structure_6 + arm_18 * t89;
    const real_t structure_39 = arm_23 * structure_7 - arm_21 * structure_23;
    const real_t structure_40 = arm_13 * t46 - arm_12 * t82;
    const real_t structure_41 = arm_10 * t59 - arm_9 * t83;
    const real_t structure_42 = arm_19 * t66 + arm_18 * structure_10;
    const real_t structure_43 = arm_10 * t69 + arm_9 * structure_11;
    const real_t structure_44 = -(arm_13 * structure_4 + arm_12 * t84);
    const real_t structure_45 = -(arm_22 * structure_5 + arm_21 * t85);
    const real_t structure_46 = arm_18 * structure_14 - arm_19 * structure_6;
    const real_t structure_47 = arm_21 * structure_15 - arm_22 * structure_7;
    const bool t90 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t91 = t90 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t92 = t91 && TB_C(0.0001) < length_4 && TB_C(0.0001) < length_5;
    const bool t93 = t92 && TB_C(0.0001) < length_6 && TB_C(0.0001) < length_7;
    const bool t94 = !t93;
    if (t94) {
        return tb_refuse_structure_matrix(TB_SINGULAR, structure);
    }
    structure[0] = structure_0;
    structure[1] = structure_1;
    structure[2] = structure_2;
    structure[3] = structure_3;
    structure[4] = structure_4;
    structure[5] = structure_5;
    structure[6] = structure_6;
    structure[7] = structure_7;
    structure[8] = structure_8;
    structure[9] = structure_9;
    structure[10] = structure_10;
    structure[11] = structure_11;
    structure[12] = structure_12;
    structure[13] = structure_13;
    structure[14] = structure_14;
    structure[15] = structure_15;
    structure[16] = structure_16;
    structure[17] = structure_17;
    structure[18] = structure_18;
    structure[19] = structure_19;
    structure[20] = structure_20;
    structure[21] = structure_21;
    structure[22] = structure_22;
    structure[23] = structure_23;
    structure[24] = structure_24;
    structure[25] = structure_25;
    structure[26] = structure_26;
    structure[27] = structure_27;
    structure[28] = structure_28;
    structure[29] = structure_29;
    structure[30] = structure_30;
    structure[31] = structure_31;
    structure[32] = structure_32;
    structure[33] = structure_33;
    structure[34] = structure_34;
    structure[35] = structure_35;
    structure[36] = structure_36;
    structure[37] = structure_37;
    structure[38] = structure_38;
    structure[39] = structure_39;
    structure[40] = structure_40;
    structure[41] = structure_41;
    structure[42] = structure_42;
    structure[43] = structure_43;
    structure[44] = structure_44;
    structure[45] = structure_45;
    structure[46] = structure_46;
    structure[47] = structure_47;
    return TB_OK;
}

/* Refuses with a status: jacobian is 0 1, m. */
static tb_status tb_refuse_length_jacobian(tb_status status, real_t jacobian[48])
{
    jacobian[0] = TB_C(0.0);
    jacobian[1] = TB_C(0.0);
    jacobian[2] = TB_C(0.0);
    jacobian[3] = TB_C(0.0);
    jacobian[4] = TB_C(0.0);
    jacobian[5] = TB_C(0.0);
    jacobian[6] = TB_C(0.0);
    jacobian[7] = TB_C(0.0);
    jacobian[8] = TB_C(0.0);
    jacobian[9] = TB_C(0.0);
    jacobian[10] = TB_C(0.0);
    jacobian[11] = TB_C(0.0);
    jacobian[12] = TB_C(0.0);
    jacobian[13] = TB_C(0.0);
    jacobian[14] = TB_C(0.0);
    jacobian[15] = TB_C(0.0);
    jacobian[16] = TB_C(0.0);
    jacobian[17] = TB_C(0.0);
    jacobian[18] = TB_C(0.0);
    jacobian[19] = TB_C(0.0);
    jacobian[20] = TB_C(0.0);
    jacobian[21] = TB_C(0.0);
    jacobian[22] = TB_C(0.0);
    jacobian[23] = TB_C(0.0);
    jacobian[24] = TB_C(0.0);
    jacobian[25] = TB_C(0.0);
    jacobian[26] = TB_C(0.0);
    jacobian[27] = TB_C(0.0);
    jacobian[28] = TB_C(0.0);
    jacobian[29] = TB_C(0.0);
    jacobian[30] = TB_C(0.0);
    jacobian[31] = TB_C(0.0);
    jacobian[32] = TB_C(0.0);
    jacobian[33] = TB_C(0.0);
    jacobian[34] = TB_C(0.0);
    jacobian[35] = TB_C(0.0);
    jacobian[36] = TB_C(0.0);
    jacobian[37] = TB_C(0.0);
    jacobian[38] = TB_C(0.0);
    jacobian[39] = TB_C(0.0);
    jacobian[40] = TB_C(0.0);
    jacobian[41] = TB_C(0.0);
    jacobian[42] = TB_C(0.0);
    jacobian[43] = TB_C(0.0);
    jacobian[44] = TB_C(0.0);
    jacobian[45] = TB_C(0.0);
    jacobian[46] = TB_C(0.0);
    jacobian[47] = TB_C(0.0);
    return status;
}

tb_status tb_length_jacobian(const real_t pose[6], const real_t rails[1], real_t jacobian[48])
{
    (void)rails;
    if (!(pose[0] >= -TB_C(1.2) && pose[0] <= TB_C(1.2)
          && pose[1] >= -TB_C(1.2) && pose[1] <= TB_C(1.2)
          && pose[2] >= -TB_C(1.2) && pose[2] <= TB_C(1.2)
          && pose[3] >= -TB_C(1.5471975511965979) && pose[3] <= TB_C(1.5471975511965979)
          && pose[4] >= -TB_C(1.5471975511965979) && pose[4] <= TB_C(1.5471975511965979)
          && pose[5] >= -TB_C(1.5471975511965979) && pose[5] <= TB_C(1.5471975511965979))) {
        return tb_refuse_length_jacobian(TB_OUT_OF_DOMAIN, jacobian);
    }
    const real_t t0 = pose[3] * pose[3] + pose[4] * pose[4] + pose[5] * pose[5];
    const real_t t1 = t0 * TB_C(0.25);
    const real_t t2 = TB_C(6.446950284384474e-26) + t1 * -TB_C(9.183689863795546e-29);
    const real_t t3 = TB_C(1.9572941063391263e-20) + t1 * (-TB_C(3.8681701706306835e-23) + t1 *
        t2);
    const real_t t4 = TB_C(2.8114572543455206e-15) + t1 * (-TB_C(8.22063524662433e-18) + t1 *
        t3);
    const real_t t5 = TB_C(1.6059043836821613e-10) + t1 * (-TB_C(7.647163731819816e-13) + t1 *
        t4);
    const real_t t6 = TB_C(2.7557319223985893e-06) + t1 * (-TB_C(2.505210838544172e-08) + t1 *
        t5);
    const real_t t7 = TB_C(0.008333333333333333) + t1 * (-TB_C(0.0001984126984126984) + t1 *
        t6);
    const real_t t8 = TB_C(1.0) + t1 * (-TB_C(0.16666666666666666) + t1 * t7);
    const real_t t9 = t8 * TB_C(0.5);
    const real_t t10 = pose[3] * t9;
    const real_t t11 = pose[4] * t9;
    const real_t t12 = t10 * t11;
    const real_t t13 = -TB_C(2.4795962632247972e-27) + t1 * TB_C(3.279889237069838e-30);
    const real_t t14 = -TB_C(8.896791392450574e-22) + t1 * (TB_C(1.6117375710961184e-24) + t1 *
        t13);
    const real_t t15 = -TB_C(1.5619206968586225e-16) + t1 * (TB_C(4.110317623312165e-19) + t1 *
        t14);
    const real_t t16 = -TB_C(1.1470745597729725e-11) + t1 * (TB_C(4.779477332387385e-14) + t1 *
        t15);
    const real_t t17 = -TB_C(2.755731922398589e-07) + t1 * (TB_C(2.08767569878681e-09) + t1 *
        t16);
    const real_t t18 = -TB_C(0.001388888888888889) + t1 * (TB_C(2.48015873015873e-05) + t1 *
        t17);
    const real_t t19 = -TB_C(0.5) + t1 * (TB_C(0.041666666666666664) + t1 * t18);
    const real_t t20 = TB_C(1.0) + t1 * t19;
    const real_t t21 = pose[5] * t9;
    const real_t t22 = t20 * t21;
    const real_t t23 = t12 - t22;
    const real_t t24 = t10 * t21;
    const real_t t25 = t11 * t20;
    const real_t t26 = t24 + t25;
    const real_t t27 = TB_C(0.08) * t26;
    /* R p_i, from the platform's centre to its anchors */
    const real_t arm_12 = -TB_C(0.12) * t23 + t27;
    const real_t t28 = pose[0] + arm_12;
    const real_t t29 = t11 * t11;
    const real_t t30 = t10 * t10;
    const real_t t31 = t21 * t21;
    const real_t t32 = t20 * t20 - (t29 + t30 + t31);
    const real_t t33 = TB_C(2.0) * t29 + t32;
    const real_t t34 = t11 * t21;
    const real_t t35 = t10 * t20;
    const real_t t36 = t34 - t35;
    const real_t t37 = TB_C(0.08) * t36;
    const real_t arm_13 = -TB_C(0.06) * t33 + t37;
    const real_t t38 = pose[1] + arm_13;
    const real_t t39 = t38 * t38;
    const real_t t40 = t34 + t35;
    const real_t t41 = t32 + TB_C(2.0) * t31;
    const real_t t42 = TB_C(0.04) * t41;
    const real_t arm_14 = -TB_C(0.12) * t40 + t42;
    const real_t t43 = pose[2] + arm_14;
    const real_t t44 = t43 * t43;
    /* l_i = |b_i - c - R p_i|, Yoon eq. 1 */
    const real_t length_0 = TB_SQRT(t28 * t28 + t39 + t44);
    const real_t t45 = TB_C(1.0) / length_0;
    const real_t jacobian_0 = t28 * t45;
    const real_t jacobian_1 = t38 * t45;
    const real_t jacobian_2 = t43 * t45;
    const real_t t46 = TB_C(2.0) * t43;
    const real_t t47 = TB_C(2.0) * t38;
    const real_t t48 = arm_13 * t46 - arm_14 * t47;
    const real_t t49 = TB_C(1.0) / (TB_C(2.0) * length_0);
    const real_t jacobian_3 = t48 * t49;
    const real_t t50 = TB_C(2.0) * t28;
    const real_t t51 = arm_12 * t46;
    const real_t jacobian_4 = t49 * (arm_14 * t50 - t51);
    const real_t t52 = arm_12 * t47;
    const real_t jacobian_5 = t49 * (t52 - arm_13 * t50);
    const real_t t53 = t32 + TB_C(2.0) * t30;
    const real_t t54 = t26 * -TB_C(0.08);
    const real_t arm_9 = -TB_C(0.06) * t53 + t54;
    const real_t t55 = pose[0] + arm_9;
    const real_t t56 = t55 * t55;
    const real_t t57 = t12 + t22;
    const real_t t58 = t36 * -TB_C(0.08);
    const real_t arm_10 = -TB_C(0.12) * t57 + t58;
    const real_t t59 = pose[1] + arm_10;
    const real_t t60 = t24 - t25;
    const real_t t61 = t41 * -TB_C(0.04);
    const real_t arm_11 = -TB_C(0.12) * t60 + t61;
    const real_t t62 = TB_FRAME - (pose[2] + arm_11);
    const real_t t63 = t62 * t62;
    const real_t length_1 = TB_SQRT(t56 + t59 * t59 + t63);
    const real_t t64 = TB_C(1.0) / length_1;
    const real_t jacobian_6 = t55 * t64;
    const real_t jacobian_7 = t59 * t64;
    const real_t jacobian_8 = -(t62 * t64);
    const real_t t65 = TB_C(2.0) * t59;
    const real_t t66 = TB_C(2.0) * t62;
    const real_t t67 = arm_10 * t66;
    const real_t t68 = TB_C(1.0) / (TB_C(2.0) * length_1);
    const real_t jacobian_9 = -((arm_11 * t65 + t67) * t68);
    const real_t t69 = TB_C(2.0) * t55;
    const real_t t70 = arm_11 * t69 + arm_9 * t66;
    const real_t jacobian_10 = t68 * t70;
    const real_t t71 = arm_10 * t69;
    const real_t jacobian_11 = t68 * (arm_9 * t65 - t71);
    const real_t arm_18 = t27 + t23 * TB_C(0.12);
    const real_t t72 = pose[0] + arm_18;
    const real_t arm_19 = t37 + t33 * TB_C(0.06);
    const real_t t73 = TB_FRAME - (pose[1] + arm_19);
    const real_t t74 = t73 * t73;
    const real_t arm_20 = t42 + t40 * TB_C(0.12);
    const real_t t75 = pose[2] + arm_20;
    const real_t t76 = t75 * t75;
    const real_t length_2 = TB_SQRT(t72 * t72 + t74 + t76);
    const real_t t77 = TB_C(1.0) / length_2;
    const real_t jacobian_12 = t72 * t77;
    const real_t jacobian_13 = -(t73 * t77);
    const real_t jacobian_14 = t75 * t77;
    const real_t t78 = TB_C(2.0) * t73;
    const real_t t79 = TB_C(2.0) * t75;
    const real_t t80 = arm_20 * t78 + arm_19 * t79;
    const real_t t81 = TB_C(1.0) / (TB_C(2.0) * length_2);
    const real_t jacobian_15 = t80 * t81;
    const real_t t82 = TB_C(2.0) * t72;
    const real_t t83 = arm_18 * t79;
    const real_t jacobian_16 = t81 * (arm_20 * t82 - t83);
    const real_t t84 = arm_18 * t78;
    const real_t jacobian_17 = -(t81 * (arm_19 * t82 + t84));
    const real_t t85 = TB_FRAME - t59;
    const real_t length_3 = TB_SQRT(t63 + (t56 + t85 * t85));
    const real_t t86 = TB_C(1.0) / length_3;
    const real_t jacobian_18 = t55 * t86;
    const real_t jacobian_19 = -(t85 * t86);
    const real_t jacobian_20 = -(t62 * t86);
    const real_t t87 = TB_C(2.0) * t85;
    const real_t t88 = TB_C(1.0) / (TB_C(2.0) * length_3);
    const real_t jacobian_21 = (arm_11 * t87 - t67) * t88;
    const real_t jacobian_22 = t70 * t88;
    const real_t jacobian_23 = -(t88 * (t71 + arm_9 * t87));
    const real_t t89 = TB_FRAME - t28;
    const real_t length_4 = TB_SQRT(t44 + (t39 + t89 * t89));
    const real_t t90 = TB_C(1.0) / length_4;
    const real_t jacobian_24 = -(t89 * t90);
    const real_t jacobian_25 = t38 * t90;
    const real_t jacobian_26 = t43 * t90;
    const real_t t91 = TB_C(1.0) / (TB_C(2.0) * length_4);
    const real_t jacobian_27 = t48 * t91;
    const real_t t92 = TB_C(2.0) * t89;
    const real_t jacobian_28 = -(t91 * (t51 + arm_14 * t92));
    const real_t jacobian_29 = t91 * (t52 + arm_13 * t92);
    const real_t arm_21 = t54 + t53 * TB_C(0.06);
    const real_t t93 = TB_FRAME - (pose[0] + arm_21);
    const real_t t94 = t93 * t93;
    const real_t arm_22 = t58 + t57 * TB_C(0.12);
    const real_t t95 = pose[1] + arm_22;
    const real_t arm_23 = t61 + t60 * TB_C(0.12);
    const real_t t96 = TB_FRAME - (pose[2] + arm_23);
    const real_t t97 = t96 * t96;
    const real_t length_5 = TB_SQRT(t94 + t95 * t95 + t97);
    const real_t t98 = TB_C(1.0) / length_5;
    const real_t jacobian_30 = -(t93 * t98);
    const real_t jacobian_31 = t95 * t98;
    const real_t jacobian_32 = -(t96 * t98);
    const real_t t99 = TB_C(2.0) * t95;
    const real_t t100 = TB_C(2.0) * t96;
    const real_t t101 = arm_22 * t100;
    const real_t t102 = TB_C(1.0) / (TB_C(2.0) * length_5);
    const real_t jacobian_33 = -((arm_23 * t99 + t101) * t102);
    const real_t t103 = TB_C(2.0) * t93;
    const real_t t104 = arm_21 * t100 - arm_23 * t103;
    const real_t jacobian_34 = t102 * t104;
    const real_t t105 = arm_22 * t103;
    const real_t jacobian_35 = t102 * (t105 + arm_21 * t99);
    const real_t t106 = TB_FRAME - t72;
    const real_t length_6 = TB_SQRT(t76 + (t74 + t106 * t106));
    const real_t t107 = TB_C(1.0) / length_6;
    const real_t jacobian_36 = -(t106 * t107);
    const real_t jacobian_37 = -(t73 * t107);
    const real_t jacobian_38 = t75 * t107;
    const real_t t108 = TB_C(1.0) / (TB_C(2.0) * length_6);
    const real_t jacobian_39 = t80 * t108;
    const real_t t109 = TB_C(2.0) * t106;
    const real_t jacobian_40 = -(t108 * (t83 + arm_20 * t109));
    const real_t jacobian_41 = t108 * (arm_19 * t109 - t84);
    const real_t t110 = TB_FRAME - t95;
    const real_t length_7 = TB_SQRT(t97 + (t94 + t110 * t110));
    const real_t t111 = TB_C(1.0) / length_7;
    const real_t jacobian_42 = -(t93 * t111);
    const real_t jacobian_43 = -(t110 * t111);
    const real_t jacobian_44 = -(t96 * t111);
    const real_t t112 = TB_C(2.0) * t110;
    const real_t t113 = TB_C(1.0) / (TB_C(2.0) * length_7);
    const real_t jacobian_45 = (arm_23 * t112 - t101) * t113;
    const real_t jacobian_46 = t104 * t113;
    const real_t jacobian_47 = t113 * (t105 - arm_21 * t112);
    const bool t114 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t115 = t114 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t116 = t115 && TB_C(0.0001) < length_4 && TB_C(0.0001) < length_5;
    const bool t117 = t116 && TB_C(0.0001) < length_6 && TB_C(0.0001) < length_7;
    const bool t118 = !t117;
    if (t118) {
        return tb_refuse_length_jacobian(TB_SINGULAR, jacobian);
    }
    jacobian[0] = jacobian_0;
    jacobian[1] = jacobian_1;
    jacobian[2] = jacobian_2;
    jacobian[3] = jacobian_3;
    jacobian[4] = jacobian_4;
    jacobian[5] = jacobian_5;
    jacobian[6] = jacobian_6;
    jacobian[7] = jacobian_7;
    jacobian[8] = jacobian_8;
    jacobian[9] = jacobian_9;
    jacobian[10] = jacobian_10;
    jacobian[11] = jacobian_11;
    jacobian[12] = jacobian_12;
    jacobian[13] = jacobian_13;
    jacobian[14] = jacobian_14;
    jacobian[15] = jacobian_15;
    jacobian[16] = jacobian_16;
    jacobian[17] = jacobian_17;
    jacobian[18] = jacobian_18;
    jacobian[19] = jacobian_19;
    jacobian[20] = jacobian_20;
    jacobian[21] = jacobian_21;
    jacobian[22] = jacobian_22;
    jacobian[23] = jacobian_23;
    jacobian[24] = jacobian_24;
    jacobian[25] = jacobian_25;
    jacobian[26] = jacobian_26;
    jacobian[27] = jacobian_27;
    jacobian[28] = jacobian_28;
    jacobian[29] = jacobian_29;
    jacobian[30] = jacobian_30;
    jacobian[31] = jacobian_31;
    jacobian[32] = jacobian_32;
    jacobian[33] = jacobian_33;
    jacobian[34] = jacobian_34;
    jacobian[35] = jacobian_35;
    jacobian[36] = jacobian_36;
    jacobian[37] = jacobian_37;
    jacobian[38] = jacobian_38;
    jacobian[39] = jacobian_39;
    jacobian[40] = jacobian_40;
    jacobian[41] = jacobian_41;
    jacobian[42] = jacobian_42;
    jacobian[43] = jacobian_43;
    jacobian[44] = jacobian_44;
    jacobian[45] = jacobian_45;
    jacobian[46] = jacobian_46;
    jacobian[47] = jacobian_47;
    return TB_OK;
}

/* Refuses with a status: velocity is 0 m/s, rad/s. */
static tb_status tb_refuse_task_velocity(tb_status status, real_t velocity[6])
{
    velocity[0] = TB_C(0.0);
    velocity[1] = TB_C(0.0);
    velocity[2] = TB_C(0.0);
    velocity[3] = TB_C(0.0);
    velocity[4] = TB_C(0.0);
    velocity[5] = TB_C(0.0);
    return status;
}

tb_status tb_task_velocity(const real_t pose[6], const real_t rails[1],
    const real_t length_rates[8], const real_t rail_rates[1], real_t velocity[6])
{
    (void)rails;
    (void)rail_rates;
    if (!(pose[0] >= -TB_C(1.2) && pose[0] <= TB_C(1.2)
          && pose[1] >= -TB_C(1.2) && pose[1] <= TB_C(1.2)
          && pose[2] >= -TB_C(1.2) && pose[2] <= TB_C(1.2)
          && pose[3] >= -TB_C(1.5471975511965979) && pose[3] <= TB_C(1.5471975511965979)
          && pose[4] >= -TB_C(1.5471975511965979) && pose[4] <= TB_C(1.5471975511965979)
          && pose[5] >= -TB_C(1.5471975511965979) && pose[5] <= TB_C(1.5471975511965979)
          && TB_ABS(length_rates[0]) + TB_ABS(length_rates[1]) + TB_ABS(length_rates[2]) +
              TB_ABS(length_rates[3]) + TB_ABS(length_rates[4]) + TB_ABS(length_rates[5]) +
              TB_ABS(length_rates[6]) + TB_ABS(length_rates[7]) <= TB_C(800.0))) {
        return tb_refuse_task_velocity(TB_OUT_OF_DOMAIN, velocity);
    }
    const real_t t0 = pose[3] * pose[3] + pose[4] * pose[4] + pose[5] * pose[5];
    const real_t t1 = t0 * TB_C(0.25);
    const real_t t2 = TB_C(6.446950284384474e-26) + t1 * -TB_C(9.183689863795546e-29);
    const real_t t3 = TB_C(1.9572941063391263e-20) + t1 * (-TB_C(3.8681701706306835e-23) + t1 *
        t2);
    const real_t t4 = TB_C(2.8114572543455206e-15) + t1 * (-TB_C(8.22063524662433e-18) + t1 *
        t3);
    const real_t t5 = TB_C(1.6059043836821613e-10) + t1 * (-TB_C(7.647163731819816e-13) + t1 *
        t4);
    const real_t t6 = TB_C(2.7557319223985893e-06) + t1 * (-TB_C(2.505210838544172e-08) + t1 *
        t5);
    const real_t t7 = TB_C(0.008333333333333333) + t1 * (-TB_C(0.0001984126984126984) + t1 *
        t6);
    const real_t t8 = TB_C(1.0) + t1 * (-TB_C(0.16666666666666666) + t1 * t7);
    const real_t t9 = t8 * TB_C(0.5);
    const real_t t10 = pose[3] * t9;
    const real_t t11 = pose[4] * t9;
    const real_t t12 = t10 * t11;
    const real_t t13 = -TB_C(2.4795962632247972e-27) + t1 * TB_C(3.279889237069838e-30);
    const real_t t14 = -TB_C(8.896791392450574e-22) + t1 * (TB_C(1.6117375710961184e-24) + t1 *
        t13);
    const real_t t15 = -TB_C(1.5619206968586225e-16) + t1 * (TB_C(4.110317623312165e-19) + t1 *
        t14);
    const real_t t16 = -TB_C(1.1470745597729725e-11) + t1 * (TB_C(4.779477332387385e-14) + t1 *
        t15);
    const real_t t17 = -TB_C(2.755731922398589e-07) + t1 * (TB_C(2.08767569878681e-09) + t1 *
        t16);
    const real_t t18 = -TB_C(0.001388888888888889) + t1 * (TB_C(2.48015873015873e-05) + t1 *
        t17);
    const real_t t19 = -TB_C(0.5) + t1 * (TB_C(0.041666666666666664) + t1 * t18);
    const real_t t20 = TB_C(1.0) + t1 * t19;
    const real_t t21 = pose[5] * t9;
    const real_t t22 = t20 * t21;
    const real_t t23 = t12 - t22;
    const real_t t24 = t10 * t21;
    const real_t t25 = t11 * t20;
    const real_t t26 = t24 + t25;
    const real_t t27 = TB_C(0.08) * t26;
    /* R p_i, from the platform's centre to its anchors */
    const real_t arm_12 = -TB_C(0.12) * t23 + t27;
    const real_t t28 = pose[0] + arm_12;
    const real_t t29 = TB_FRAME - t28;
    const real_t t30 = t11 * t11;
    const real_t t31 = t10 * t10;
    const real_t t32 = t21 * t21;
    const real_t t33 = t20 * t20 - (t30 + t31 + t32);
    const real_t t34 = TB_C(2.0) * t30 + t33;
    const real_t t35 = t11 * t21;
    const real_t t36 = t10 * t20;
    const real_t t37 = t35 - t36;
    const real_t t38 = TB_C(0.08) * t37;
    const real_t arm_13 = -TB_C(0.06) * t34 + t38;
    const real_t t39 = pose[1] + arm_13;
    const real_t t40 = t39 * t39;
    const real_t t41 = t35 + t36;
    const real_t t42 = t33 + TB_C(2.0) * t32;
    const real_t t43 = TB_C(0.04) * t42;
    const real_t arm_14 = -TB_C(0.12) * t41 + t43;
    const real_t t44 = pose[2] + arm_14;
    const real_t t45 = t44 * t44;
    /* l_i = |b_i - c - R p_i|, Yoon eq. 1 */
    const real_t length_4 = TB_SQRT(t29 * t29 + t40 + t45);
    const real_t t46 = TB_C(1.0) / length_4;
    const real_t t47 = t29 * t46;
    const real_t length_0 = TB_SQRT(t45 + (t40 + t28 * t28));
    const real_t t48 = TB_C(1.0) / length_0;
    const real_t t49 = t28 * t48;
    const real_t t50 = t33 + TB_C(2.0) * t31;
    const real_t t51 = t26 * -TB_C(0.08);
    const real_t arm_9 = -TB_C(0.06) * t50 + t51;
    const real_t t52 = pose[0] + arm_9;
    const real_t t53 = t52 * t52;
    const real_t t54 = t12 + t22;
    const real_t t55 = t37 * -TB_C(0.08);
    const real_t arm_10 = -TB_C(0.12) * t54 + t55;
    const real_t t56 = pose[1] + arm_10;
    const real_t t57 = t24 - t25;
    const real_t t58 = t42 * -TB_C(0.04);
    const real_t arm_11 = -TB_C(0.12) * t57 + t58;
    const real_t t59 = TB_FRAME - (pose[2] + arm_11);
    const real_t t60 = t59 * t59;
    const real_t length_1 = TB_SQRT(t53 + t56 * t56 + t60);
    const real_t t61 = TB_C(1.0) / length_1;
    const real_t t62 = t52 * t61;
    const real_t arm_18 = t27 + t23 * TB_C(0.12);
    const real_t t63 = pose[0] + arm_18;
    const real_t arm_19 = t38 + t34 * TB_C(0.06);
    const real_t t64 = TB_FRAME - (pose[1] + arm_19);
    const real_t t65 = t64 * t64;
    const real_t arm_20 = t43 + t41 * TB_C(0.12);
    const real_t t66 = pose[2] + arm_20;
    const real_t t67 = t66 * t66;
    const real_t length_2 = TB_SQRT(t63 * t63 + t65 + t67);
    const real_t t68 = TB_C(1.0) / length_2;
    const real_t t69 = t63 * t68;
    const real_t t70 = t49 * length_rates[0] + t62 * length_rates[1] + t69 * length_rates[2];
    const real_t t71 = TB_FRAME - t56;
    const real_t length_3 = TB_SQRT(t60 + (t53 + t71 * t71));
    const real_t t72 = TB_C(1.0) / length_3;
    const real_t t73 = t52 * t72;
    const real_t t74 = t47 * length_rates[4] - (t70 + t73 * length_rates[3]);
    const real_t arm_21 = t51 + t50 * TB_C(0.06);
    const real_t t75 = TB_FRAME - (pose[0] + arm_21);
    const real_t t76 = t75 * t75;
    const real_t arm_22 = t55 + t54 * TB_C(0.12);
    const real_t t77 = pose[1] + arm_22;
    const real_t arm_23 = t58 + t57 * TB_C(0.12);
    const real_t t78 = TB_FRAME - (pose[2] + arm_23);
    const real_t t79 = t78 * t78;
    const real_t length_5 = TB_SQRT(t76 + t77 * t77 + t79);
    const real_t t80 = TB_C(1.0) / length_5;
    const real_t t81 = t75 * t80;
    const real_t t82 = TB_FRAME - t63;
    const real_t length_6 = TB_SQRT(t67 + (t65 + t82 * t82));
    const real_t t83 = TB_C(1.0) / length_6;
    const real_t t84 = t82 * t83;
    const real_t t85 = t74 + t81 * length_rates[5] + t84 * length_rates[6];
    const real_t t86 = TB_FRAME - t77;
    const real_t length_7 = TB_SQRT(t79 + (t76 + t86 * t86));
    const real_t t87 = TB_C(1.0) / length_7;
    const real_t t88 = t75 * t87;
    const real_t t89 = t85 + t88 * length_rates[7];
    const real_t t90 = t49 * t49 + t62 * t62 + t69 * t69 + t73 * t73 + t47 * t47;
    const real_t t91 = t90 + t81 * t81 + t84 * t84 + t88 * t88;
    const real_t t92 = TB_C(1.0) / t91;
    const real_t t93 = t39 * t48;
    const real_t t94 = t56 * t61;
    const real_t t95 = t64 * t68;
    const real_t t96 = t71 * t72;
    const real_t t97 = t39 * t46;
    const real_t t98 = t49 * t93 + t62 * t94 - t69 * t95 - t73 * t96 - t47 * t97;
    const real_t t99 = t77 * t80;
    const real_t t100 = t64 * t83;
    const real_t t101 = t86 * t87;
    const real_t t102 = t92 * (t98 - t81 * t99 + t84 * t100 + t88 * t101);
    const real_t t103 = length_rates[2] * t95 - (length_rates[0] * t93 + length_rates[1] * t94);
    const real_t t104 = t103 + length_rates[3] * t96 - length_rates[4] * t97;
    const real_t t105 = t104 - length_rates[5] * t99 + length_rates[6] * t100;
    const real_t t106 = t89 * t102 - (t105 + length_rates[7] * t101);
    const real_t t107 = t93 * t93 + t94 * t94 + t95 * t95 + t96 * t96 + t97 * t97;
    const real_t t108 = t107 + t99 * t99 + t100 * t100 + t101 * t101 - t91 * (t102 * t102);
    const real_t t109 = TB_C(1.0) / t108;
    const real_t t110 = t44 * t48;
    const real_t t111 = t59 * t61;
    const real_t t112 = t66 * t68;
    const real_t t113 = t59 * t72;
    const real_t t114 = t93 * t110 - t94 * t111 - t95 * t112 + t96 * t113;
    const real_t t115 = t44 * t46;
    const real_t t116 = t78 * t80;
    const real_t t117 = t66 * t83;
    const real_t t118 = t78 * t87;
    const real_t t119 = t114 + t97 * t115 - t99 * t116 - t100 * t117 + t101 * t118;
    const real_t t120 = t49 * t110 - t62 * t111 + t69 * t112 - t73 * t113;
    const real_t t121 = t120 - t47 * t115 + t81 * t116 - t84 * t117 + t88 * t118;
    const real_t t122 = t92 * t121;
    const real_t t123 = t109 * (t119 - t91 * (t102 * t122));
    const real_t t124 = length_rates[1] * t111 - length_rates[0] * t110 - length_rates[2] *
        t112;
    const real_t t125 = t124 + length_rates[3] * t113 - length_rates[4] * t115;
    const real_t t126 = t125 + length_rates[5] * t116 - length_rates[6] * t117;
    const real_t t127 = t89 * t122 - (t126 + length_rates[7] * t118) - t106 * t123;
    const real_t t128 = t110 * t110 + t111 * t111 + t112 * t112 + t113 * t113;
    const real_t t129 = t128 + t115 * t115 + t116 * t116 + t117 * t117 + t118 * t118;
    const real_t t130 = t129 - t91 * (t122 * t122) - t108 * (t123 * t123);
    const real_t t131 = TB_C(1.0) / t130;
    const real_t t132 = (arm_11 * t94 + arm_10 * t111) * TB_MOMENT_WEIGHT;
    const real_t t133 = TB_MOMENT_WEIGHT * (arm_14 * t93 - arm_13 * t110);
    const real_t t134 = TB_MOMENT_WEIGHT * (arm_20 * t95 + arm_19 * t112);
    const real_t t135 = TB_MOMENT_WEIGHT * (arm_10 * t113 - arm_11 * t96);
    const real_t t136 = t111 * t132 - t110 * t133 + t112 * t134 + t113 * t135;
    const real_t t137 = TB_MOMENT_WEIGHT * (arm_14 * t97 - arm_13 * t115);
    const real_t t138 = TB_MOMENT_WEIGHT * (arm_23 * t99 + arm_22 * t116);
    const real_t t139 = TB_MOMENT_WEIGHT * (arm_20 * t100 + arm_19 * t117);
    const real_t t140 = TB_MOMENT_WEIGHT * (arm_22 * t118 - arm_23 * t101);
    const real_t t141 = t136 - t115 * t137 + t116 * t138 + t117 * t139 + t118 * t140;
    const real_t t142 = t69 * t134 - (t49 * t133 + t62 * t132) - t73 * t135;
    const real_t t143 = t142 + t47 * t137 + t81 * t138 - t84 * t139 + t88 * t140;
    const real_t t144 = t92 * t143;
    const real_t t145 = t96 * t135 - (t93 * t133 + t94 * t132 + t95 * t134);
    const real_t t146 = t145 - t97 * t137 - t99 * t138 - t100 * t139 + t101 * t140;
    const real_t t147 = t109 * (t146 - t91 * (t102 * t144));
    const real_t t148 = t141 - t91 * (t122 * t144) - t108 * (t123 * t147);
    const real_t t149 = t131 * t148;
    const real_t t150 = length_rates[0] * t133 + length_rates[1] * t132 - length_rates[2] *
        t134;
    const real_t t151 = t150 + length_rates[3] * t135 + length_rates[4] * t137;
    const real_t t152 = t151 + length_rates[5] * t138 - length_rates[6] * t139;
    const real_t t153 = t89 * t144 - (t152 + length_rates[7] * t140) - t106 * t147;
    const real_t t154 = t153 - t127 * t149;
    const real_t t155 = t133 * t133 + t132 * t132 + t134 * t134 + t135 * t135;
    const real_t t156 = t155 + t137 * t137 + t138 * t138 + t139 * t139 + t140 * t140;
    const real_t t157 = t156 - t91 * (t144 * t144) - t108 * (t147 * t147);
    const real_t t158 = t157 - t130 * (t149 * t149);
    const real_t t159 = TB_C(1.0) / t158;
    const real_t t160 = TB_MOMENT_WEIGHT * (arm_12 * t110 - arm_14 * t49);
    const real_t t161 = TB_MOMENT_WEIGHT * (arm_11 * t62 + arm_9 * t111);
    const real_t t162 = TB_MOMENT_WEIGHT * (arm_18 * t112 - arm_20 * t69);
    const real_t t163 = TB_MOMENT_WEIGHT * (arm_11 * t73 + arm_9 * t113);
    const real_t t164 = t133 * t160 - t132 * t161 - t134 * t162 - t135 * t163;
    const real_t t165 = TB_MOMENT_WEIGHT * (arm_14 * t47 + arm_12 * t115);
    const real_t t166 = TB_MOMENT_WEIGHT * (arm_23 * t81 - arm_21 * t116);
    const real_t t167 = TB_MOMENT_WEIGHT * (arm_20 * t84 + arm_18 * t117);
    const real_t t168 = TB_MOMENT_WEIGHT * (arm_23 * t88 - arm_21 * t118);
    const real_t t169 = t164 + t137 * t165 + t138 * t166 - t139 * t167 + t140 * t168;
    const real_t t170 = t62 * t161 - t49 * t160 - t69 * t162 + t73 * t163;
    const real_t t171 = t170 + t47 * t165 + t81 * t166 + t84 * t167 + t88 * t168;
    const real_t t172 = t92 * t171;
    const real_t t173 = t94 * t161 - t93 * t160 + t95 * t162 - t96 * t163;
    const real_t t174 = t173 - t97 * t165 - t99 * t166 + t100 * t167 + t101 * t168;
    const real_t t175 = t109 * (t174 - t91 * (t102 * t172));
    const real_t t176 = t169 - t91 * (t144 * t172) - t108 * (t147 * t175);
    const real_t t177 = t110 * t160 + t111 * t161 + t112 * t162 + t113 * t163;
    const real_t t178 = t116 * t166 - (t177 + t115 * t165) - t117 * t167 + t118 * t168;
    const real_t t179 = t178 - t91 * (t122 * t172) - t108 * (t123 * t175);
    const real_t t180 = t131 * t179;
    const real_t t181 = t159 * (t176 - t130 * (t149 * t180));
    const real_t t182 = length_rates[0] * t160 - length_rates[1] * t161 + length_rates[2] *
        t162;
    const real_t t183 = t182 - length_rates[3] * t163 + length_rates[4] * t165;
    const real_t t184 = t183 + length_rates[5] * t166 + length_rates[6] * t167;
    const real_t t185 = t89 * t172 - (t184 + length_rates[7] * t168) - t106 * t175;
    const real_t t186 = t185 - t127 * t180 - t154 * t181;
    const real_t t187 = t160 * t160 + t161 * t161 + t162 * t162 + t163 * t163;
    const real_t t188 = t187 + t165 * t165 + t166 * t166 + t167 * t167 + t168 * t168;
    const real_t t189 = t188 - t91 * (t172 * t172) - t108 * (t175 * t175);
    const real_t t190 = t189 - t130 * (t180 * t180) - t158 * (t181 * t181);
    const real_t t191 = TB_C(1.0) / t190;
    const real_t t192 = TB_MOMENT_WEIGHT * (arm_13 * t49 - arm_12 * t93);
    const real_t t193 = TB_MOMENT_WEIGHT * (arm_10 * t62 - arm_9 * t94);
    const real_t t194 = TB_MOMENT_WEIGHT * (arm_19 * t69 + arm_18 * t95);
    const real_t t195 = TB_MOMENT_WEIGHT * (arm_10 * t73 + arm_9 * t96);
    const real_t t196 = t160 * t192 - t161 * t193 + t162 * t194 - t163 * t195;
    const real_t t197 = TB_MOMENT_WEIGHT * (arm_13 * t47 + arm_12 * t97);
    const real_t t198 = TB_MOMENT_WEIGHT * (arm_22 * t81 + arm_21 * t99);
    const real_t t199 = TB_MOMENT_WEIGHT * (arm_18 * t100 - arm_19 * t84);
    const real_t t200 = TB_MOMENT_WEIGHT * (arm_21 * t101 - arm_22 * t88);
    const real_t t201 = t196 - t165 * t197 - t166 * t198 + t167 * t199 + t168 * t200;
    const real_t t202 = t49 * t192 + t62 * t193 + t69 * t194 + t73 * t195;
    const real_t t203 = t84 * t199 - (t202 + t47 * t197 + t81 * t198) + t88 * t200;
    const real_t t204 = t92 * t203;
    const real_t t205 = t95 * t194 - (t93 * t192 + t94 * t193) + t96 * t195;
    const real_t t206 = t205 + t97 * t197 + t99 * t198 + t100 * t199 + t101 * t200;
    const real_t t207 = t109 * (t206 - t91 * (t102 * t204));
    const real_t t208 = t201 - t91 * (t172 * t204) - t108 * (t175 * t207);
    const real_t t209 = t111 * t193 - t110 * t192 - t112 * t194 + t113 * t195;
    const real_t t210 = t209 + t115 * t197 - t116 * t198 - t117 * t199 + t118 * t200;
    const real_t t211 = t210 - t91 * (t122 * t204) - t108 * (t123 * t207);
    const real_t t212 = t131 * t211;
    const real_t t213 = t133 * t192 + t132 * t193 - t134 * t194 + t135 * t195;
    const real_t t214 = t213 - t137 * t197 - t138 * t198 - t139 * t199 + t140 * t200;
    const real_t t215 = t214 - t91 * (t144 * t204) - t108 * (t147 * t207);
    const real_t t216 = t159 * (t215 - t130 * (t149 * t212));
    const real_t t217 = t208 - t130 * (t180 * t212) - t158 * (t181 * t216);
    const real_t t218 = t191 * t217;
    const real_t t219 = length_rates[0] * t192 + length_rates[1] * t193 + length_rates[2] *
        t194;
    const real_t t220 = t219 + length_rates[3] * t195 - length_rates[4] * t197;
    const real_t t221 = t220 - length_rates[5] * t198 + length_rates[6] * t199;
    const real_t t222 = t89 * t204 - (t221 + length_rates[7] * t200) - t106 * t207;
    const real_t t223 = t192 * t192 + t193 * t193 + t194 * t194 + t195 * t195;
    const real_t t224 = t223 + t197 * t197 + t198 * t198 + t199 * t199 + t200 * t200;
    const real_t t225 = t224 - t91 * (t204 * t204) - t108 * (t207 * t207);
    const real_t t226 = t225 - t130 * (t212 * t212) - t158 * (t216 * t216);
    const real_t t227 = t226 - t190 * (t218 * t218);
    const real_t t228 = (t222 - t127 * t212 - t154 * t216 - t186 * t218) / t227;
    const real_t t229 = t186 * t191 - t218 * t228;
    const real_t t230 = t154 * t159 - t181 * t229 - t216 * t228;
    const real_t velocity_2 = t127 * t131 - t149 * t230 - t180 * t229 - t212 * t228;
    const real_t t231 = t106 * t109 - t123 * velocity_2 - t147 * t230 - t175 * t229;
    const real_t velocity_1 = t231 - t207 * t228;
    const real_t t232 = t89 * t92 + t102 * velocity_1 + t122 * velocity_2;
    const real_t velocity_0 = -(t232 + t144 * t230 + t172 * t229 + t204 * t228);
    const real_t velocity_3 = TB_MOMENT_WEIGHT * t230;
    const real_t velocity_4 = TB_MOMENT_WEIGHT * t229;
    const real_t velocity_5 = TB_MOMENT_WEIGHT * t228;
    const bool t233 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t234 = t233 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t235 = t234 && TB_C(0.0001) < length_4 && TB_C(0.0001) < length_5;
    const bool t236 = t235 && TB_C(0.0001) < length_6 && TB_C(0.0001) < length_7;
    const bool t237 = !t236;
    const real_t t238 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const bool t239 = t238 < t91 && t238 < t108 && t238 < t130 && t238 < t158;
    const bool t240 = !(t239 && t238 < t190 && t238 < t227);
    if (t237 || t240) {
        return tb_refuse_task_velocity(TB_SINGULAR, velocity);
    }
    velocity[0] = velocity_0;
    velocity[1] = velocity_1;
    velocity[2] = velocity_2;
    velocity[3] = velocity_3;
    velocity[4] = velocity_4;
    velocity[5] = velocity_5;
    return TB_OK;
}

/* The guess is the first estimate. */
static tb_status tb_forward_kinematics_begin(const real_t guess[6], const real_t lengths[8],
    const real_t rails[1], real_t estimate[6])
{
    (void)rails;
    if (!(guess[0] >= -TB_C(1.2) && guess[0] <= TB_C(1.2)
          && guess[1] >= -TB_C(1.2) && guess[1] <= TB_C(1.2)
          && guess[2] >= -TB_C(1.2) && guess[2] <= TB_C(1.2)
          && guess[3] >= -TB_C(1.5471975511965979) && guess[3] <= TB_C(1.5471975511965979)
          && guess[4] >= -TB_C(1.5471975511965979) && guess[4] <= TB_C(1.5471975511965979)
          && guess[5] >= -TB_C(1.5471975511965979) && guess[5] <= TB_C(1.5471975511965979)
          && lengths[0] >= TB_C(0.0) && lengths[0] <= TB_C(7.199999999999999)
          && lengths[1] >= TB_C(0.0) && lengths[1] <= TB_C(7.199999999999999)
          && lengths[2] >= TB_C(0.0) && lengths[2] <= TB_C(7.199999999999999)
          && lengths[3] >= TB_C(0.0) && lengths[3] <= TB_C(7.199999999999999)
          && lengths[4] >= TB_C(0.0) && lengths[4] <= TB_C(7.199999999999999)
          && lengths[5] >= TB_C(0.0) && lengths[5] <= TB_C(7.199999999999999)
          && lengths[6] >= TB_C(0.0) && lengths[6] <= TB_C(7.199999999999999)
          && lengths[7] >= TB_C(0.0) && lengths[7] <= TB_C(7.199999999999999))) {
        estimate[0] = TB_C(0.0);
        estimate[1] = TB_C(0.0);
        estimate[2] = TB_C(0.0);
        estimate[3] = TB_C(0.0);
        estimate[4] = TB_C(0.0);
        estimate[5] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    estimate[0] = guess[0];
    estimate[1] = guess[1];
    estimate[2] = guess[2];
    estimate[3] = guess[3];
    estimate[4] = guess[4];
    estimate[5] = guess[5];
    return TB_OK;
}

/* Gauss-Newton step on the misfit of the lengths. */
static tb_status tb_forward_kinematics_step(const real_t lengths[8], const real_t rails[1],
    real_t estimate[6], real_t found[1])
{
    (void)rails;
    const real_t t0 = estimate[3] * estimate[3] + estimate[4] * estimate[4];
    const real_t t1 = t0 + estimate[5] * estimate[5];
    const real_t t2 = t1 * TB_C(0.25);
    const real_t t3 = TB_C(6.446950284384474e-26) + t2 * -TB_C(9.183689863795546e-29);
    const real_t t4 = TB_C(1.9572941063391263e-20) + t2 * (-TB_C(3.8681701706306835e-23) + t2 *
        t3);
    const real_t t5 = TB_C(2.8114572543455206e-15) + t2 * (-TB_C(8.22063524662433e-18) + t2 *
        t4);
    const real_t t6 = TB_C(1.6059043836821613e-10) + t2 * (-TB_C(7.647163731819816e-13) + t2 *
        t5);
    const real_t t7 = TB_C(2.7557319223985893e-06) + t2 * (-TB_C(2.505210838544172e-08) + t2 *
        t6);
    const real_t t8 = TB_C(0.008333333333333333) + t2 * (-TB_C(0.0001984126984126984) + t2 *
        t7);
    const real_t t9 = TB_C(1.0) + t2 * (-TB_C(0.16666666666666666) + t2 * t8);
    const real_t t10 = t9 * TB_C(0.5);
    const real_t t11 = estimate[3] * t10;
    const real_t t12 = estimate[4] * t10;
    const real_t t13 = t11 * t12;
    const real_t t14 = -TB_C(2.4795962632247972e-27) + t2 * TB_C(3.279889237069838e-30);
    const real_t t15 = -TB_C(8.896791392450574e-22) + t2 * (TB_C(1.6117375710961184e-24) + t2 *
        t14);
    const real_t t16 = -TB_C(1.5619206968586225e-16) + t2 * (TB_C(4.110317623312165e-19) + t2 *
        t15);
    const real_t t17 = -TB_C(1.1470745597729725e-11) + t2 * (TB_C(4.779477332387385e-14) + t2 *
        t16);
    const real_t t18 = -TB_C(2.755731922398589e-07) + t2 * (TB_C(2.08767569878681e-09) + t2 *
        t17);
    const real_t t19 = -TB_C(0.001388888888888889) + t2 * (TB_C(2.48015873015873e-05) + t2 *
        t18);
    const real_t t20 = -TB_C(0.5) + t2 * (TB_C(0.041666666666666664) + t2 * t19);
    const real_t t21 = TB_C(1.0) + t2 * t20;
    const real_t t22 = estimate[5] * t10;
    const real_t t23 = t21 * t22;
    const real_t t24 = t13 - t23;
    const real_t t25 = t11 * t22;
    const real_t t26 = t12 * t21;
    const real_t t27 = t25 + t26;
    const real_t t28 = TB_C(0.08) * t27;
    const real_t t29 = -TB_C(0.12) * t24 + t28;
    const real_t t30 = estimate[0] + t29;
    const real_t t31 = t12 * t12;
    const real_t t32 = t11 * t11;
    const real_t t33 = t22 * t22;
    const real_t t34 = t21 * t21 - (t31 + t32 + t33);
    const real_t t35 = TB_C(2.0) * t31 + t34;
    const real_t t36 = t12 * t22;
    const real_t t37 = t11 * t21;
    const real_t t38 = t36 - t37;
    const real_t t39 = TB_C(0.08) * t38;
    const real_t t40 = -TB_C(0.06) * t35 + t39;
    const real_t t41 = estimate[1] + t40;
    const real_t t42 = t41 * t41;
    const real_t t43 = t36 + t37;
    const real_t t44 = t34 + TB_C(2.0) * t33;
    const real_t t45 = TB_C(0.04) * t44;
    const real_t t46 = -TB_C(0.12) * t43 + t45;
    const real_t t47 = estimate[2] + t46;
    const real_t t48 = t47 * t47;
    const real_t t49 = TB_SQRT(t30 * t30 + t42 + t48);
    const real_t t50 = TB_C(1.0) / t49;
    const real_t t51 = t30 * t50;
    const real_t t52 = lengths[0] - t49;
    const real_t t53 = t34 + TB_C(2.0) * t32;
    const real_t t54 = t27 * -TB_C(0.08);
    const real_t t55 = -TB_C(0.06) * t53 + t54;
    const real_t t56 = estimate[0] + t55;
    const real_t t57 = t56 * t56;
    const real_t t58 = t13 + t23;
    const real_t t59 = t38 * -TB_C(0.08);
    const real_t t60 = -TB_C(0.12) * t58 + t59;
    const real_t t61 = estimate[1] + t60;
    const real_t t62 = t25 - t26;
    const real_t t63 = t44 * -TB_C(0.04);
    const real_t t64 = -TB_C(0.12) * t62 + t63;
    const real_t t65 = TB_FRAME - (estimate[2] + t64);
    const real_t t66 = t65 * t65;
    const real_t t67 = TB_SQRT(t57 + t61 * t61 + t66);
    const real_t t68 = TB_C(1.0) / t67;
    const real_t t69 = t56 * t68;
    const real_t t70 = lengths[1] - t67;
    const real_t t71 = t28 + t24 * TB_C(0.12);
    const real_t t72 = estimate[0] + t71;
    const real_t t73 = t39 + t35 * TB_C(0.06);
    const real_t t74 = TB_FRAME - (estimate[1] + t73);
    const real_t t75 = t74 * t74;
    const real_t t76 = t45 + t43 * TB_C(0.12);
    const real_t t77 = estimate[2] + t76;
    const real_t t78 = t77 * t77;
    const real_t t79 = TB_SQRT(t72 * t72 + t75 + t78);
    const real_t t80 = TB_C(1.0) / t79;
    const real_t t81 = t72 * t80;
    const real_t t82 = lengths[2] - t79;
    const real_t t83 = TB_FRAME - t61;
    const real_t t84 = TB_SQRT(t66 + (t57 + t83 * t83));
    const real_t t85 = TB_C(1.0) / t84;
    const real_t t86 = t56 * t85;
    const real_t t87 = lengths[3] - t84;
    const real_t t88 = TB_FRAME - t30;
    const real_t t89 = TB_SQRT(t48 + (t42 + t88 * t88));
    const real_t t90 = TB_C(1.0) / t89;
    const real_t t91 = t88 * t90;
    const real_t t92 = lengths[4] - t89;
    const real_t t93 = t51 * t52 + t69 * t70 + t81 * t82 + t86 * t87 - t91 * t92;
    const real_t t94 = t54 + t53 * TB_C(0.06);
    const real_t t95 = TB_FRAME - (estimate[0] + t94);
    const real_t t96 = t95 * t95;
    const real_t t97 = t59 + t58 * TB_C(0.12);
    const real_t t98 = estimate[1] + t97;
    const real_t t99 = t63 + t62 * TB_C(0.12);
    const real_t t100 = TB_FRAME - (estimate[2] + t99);
    const real_t t101 = t100 * t100;
    const real_t t102 = TB_SQRT(t96 + t98 * t98 + t101);
    const real_t t103 = TB_C(1.0) / t102;
    const real_t t104 = t95 * t103;
    const real_t t105 = lengths[5] - t102;
    const real_t t106 = TB_FRAME - t72;
    const real_t t107 = TB_SQRT(t78 + (t75 + t106 * t106));
    const real_t t108 = TB_C(1.0) / t107;
    const real_t t109 = t106 * t108;
    const real_t t110 = lengths[6] - t107;
    const real_t t111 = TB_FRAME - t98;
    const real_t t112 = TB_SQRT(t101 + (t96 + t111 * t111));
    const real_t t113 = TB_C(1.0) / t112;
    const real_t t114 = t95 * t113;
    const real_t t115 = lengths[7] - t112;
    const real_t t116 = t93 - t104 * t105 - t109 * t110 - t114 * t115;
    const real_t t117 = t51 * t51 + t69 * t69 + t81 * t81 + t86 * t86 + t91 * t91;
    const real_t t118 = t117 + t104 * t104 + t109 * t109 + t114 * t114;
    const real_t t119 = TB_C(1.0) / t118;
    const real_t t120 = t41 * t50;
    const real_t t121 = t61 * t68;
    const real_t t122 = t74 * t80;
    const real_t t123 = t83 * t85;
    const real_t t124 = t51 * t120 + t69 * t121 - t81 * t122 - t86 * t123;
    const real_t t125 = t41 * t90;
    const real_t t126 = t98 * t103;
    const real_t t127 = t74 * t108;
    const real_t t128 = t111 * t113;
    const real_t t129 = t124 - t91 * t125 - t104 * t126 + t109 * t127 + t114 * t128;
    const real_t t130 = t119 * t129;
    const real_t t131 = t52 * t120 + t70 * t121 - t82 * t122 - t87 * t123;
    const real_t t132 = t131 + t92 * t125 + t105 * t126 - t110 * t127 - t115 * t128;
    const real_t t133 = t132 - t116 * t130;
    const real_t t134 = t120 * t120 + t121 * t121 + t122 * t122 + t123 * t123;
    const real_t t135 = t134 + t125 * t125 + t126 * t126 + t127 * t127 + t128 * t128;
    const real_t t136 = t135 - t118 * (t130 * t130);
    const real_t t137 = TB_C(1.0) / t136;
    const real_t t138 = t47 * t50;
    const real_t t139 = t65 * t68;
    const real_t t140 = t77 * t80;
    const real_t t141 = t65 * t85;
    const real_t t142 = t120 * t138 - t121 * t139 - t122 * t140 + t123 * t141;
    const real_t t143 = t47 * t90;
    const real_t t144 = t100 * t103;
    const real_t t145 = t77 * t108;
    const real_t t146 = t100 * t113;
    const real_t t147 = t142 + t125 * t143 - t126 * t144 - t127 * t145 + t128 * t146;
    const real_t t148 = t51 * t138 - t69 * t139 + t81 * t140 - t86 * t141;
    const real_t t149 = t148 - t91 * t143 + t104 * t144 - t109 * t145 + t114 * t146;
    const real_t t150 = t119 * t149;
    const real_t t151 = t137 * (t147 - t118 * (t130 * t150));
    const real_t t152 = t52 * t138 - t70 * t139 + t82 * t140 - t87 * t141;
    const real_t t153 = t152 + t92 * t143 - t105 * t144 + t110 * t145 - t115 * t146;
    const real_t t154 = t153 - t116 * t150 - t133 * t151;
    const real_t t155 = t138 * t138 + t139 * t139 + t140 * t140 + t141 * t141;
    const real_t t156 = t155 + t143 * t143 + t144 * t144 + t145 * t145 + t146 * t146;
    const real_t t157 = t156 - t118 * (t150 * t150) - t136 * (t151 * t151);
    const real_t t158 = TB_C(1.0) / t157;
    const real_t t159 = (t64 * t121 + t60 * t139) * TB_MOMENT_WEIGHT;
    const real_t t160 = TB_MOMENT_WEIGHT * (t46 * t120 - t40 * t138);
    const real_t t161 = TB_MOMENT_WEIGHT * (t76 * t122 + t73 * t140);
    const real_t t162 = TB_MOMENT_WEIGHT * (t60 * t141 - t64 * t123);
    const real_t t163 = t139 * t159 - t138 * t160 + t140 * t161 + t141 * t162;
    const real_t t164 = TB_MOMENT_WEIGHT * (t46 * t125 - t40 * t143);
    const real_t t165 = TB_MOMENT_WEIGHT * (t99 * t126 + t97 * t144);
    const real_t t166 = TB_MOMENT_WEIGHT * (t76 * t127 + t73 * t145);
    const real_t t167 = TB_MOMENT_WEIGHT * (t97 * t146 - t99 * t128);
    const real_t t168 = t163 - t143 * t164 + t144 * t165 + t145 * t166 + t146 * t167;
    const real_t t169 = t81 * t161 - (t51 * t160 + t69 * t159) - t86 * t162;
    const real_t t170 = t169 + t91 * t164 + t104 * t165 - t109 * t166 + t114 * t167;
    const real_t t171 = t119 * t170;
    const real_t t172 = t123 * t162 - (t120 * t160 + t121 * t159 + t122 * t161);
    const real_t t173 = t172 - t125 * t164 - t126 * t165 - t127 * t166 + t128 * t167;
    const real_t t174 = t137 * (t173 - t118 * (t130 * t171));
    const real_t t175 = t168 - t118 * (t150 * t171) - t136 * (t151 * t174);
    const real_t t176 = t158 * t175;
    const real_t t177 = t82 * t161 - (t52 * t160 + t70 * t159) - t87 * t162;
    const real_t t178 = t177 - t92 * t164 - t105 * t165 + t110 * t166 - t115 * t167;
    const real_t t179 = t178 - t116 * t171 - t133 * t174 - t154 * t176;
    const real_t t180 = t160 * t160 + t159 * t159 + t161 * t161 + t162 * t162;
    const real_t t181 = t180 + t164 * t164 + t165 * t165 + t166 * t166 + t167 * t167;
    const real_t t182 = t181 - t118 * (t171 * t171) - t136 * (t174 * t174);
    const real_t t183 = t182 - t157 * (t176 * t176);
    const real_t t184 = TB_C(1.0) / t183;
    const real_t t185 = TB_MOMENT_WEIGHT * (t29 * t138 - t46 * t51);
    const real_t t186 = TB_MOMENT_WEIGHT * (t64 * t69 + t55 * t139);
    const real_t t187 = TB_MOMENT_WEIGHT * (t71 * t140 - t76 * t81);
    const real_t t188 = TB_MOMENT_WEIGHT * (t64 * t86 + t55 * t141);
    const real_t t189 = t160 * t185 - t159 * t186 - t161 * t187 - t162 * t188;
    const real_t t190 = TB_MOMENT_WEIGHT * (t46 * t91 + t29 * t143);
    const real_t t191 = TB_MOMENT_WEIGHT * (t99 * t104 - t94 * t144);
    const real_t t192 = TB_MOMENT_WEIGHT * (t76 * t109 + t71 * t145);
    const real_t t193 = TB_MOMENT_WEIGHT * (t99 * t114 - t94 * t146);
    const real_t t194 = t189 + t164 * t190 + t165 * t191 - t166 * t192 + t167 * t193;
    const real_t t195 = t69 * t186 - t51 * t185 - t81 * t187 + t86 * t188;
    const real_t t196 = t195 + t91 * t190 + t104 * t191 + t109 * t192 + t114 * t193;
    const real_t t197 = t119 * t196;
    const real_t t198 = t121 * t186 - t120 * t185 + t122 * t187 - t123 * t188;
    const real_t t199 = t198 - t125 * t190 - t126 * t191 + t127 * t192 + t128 * t193;
    const real_t t200 = t137 * (t199 - t118 * (t130 * t197));
    const real_t t201 = t194 - t118 * (t171 * t197) - t136 * (t174 * t200);
    const real_t t202 = t138 * t185 + t139 * t186 + t140 * t187 + t141 * t188;
    const real_t t203 = t144 * t191 - (t202 + t143 * t190) - t145 * t192 + t146 * t193;
    const real_t t204 = t203 - t118 * (t150 * t197) - t136 * (t151 * t200);
    const real_t t205 = t158 * t204;
    const real_t t206 = t184 * (t201 - t157 * (t176 * t205));
    const real_t t207 = t70 * t186 - t52 * t185 - t82 * t187 + t87 * t188;
    const real_t t208 = t207 - t92 * t190 - t105 * t191 - t110 * t192 - t115 * t193;
    const real_t t209 = t208 - t116 * t197 - t133 * t200 - t154 * t205 - t179 * t206;
    const real_t t210 = t185 * t185 + t186 * t186 + t187 * t187 + t188 * t188;
    const real_t t211 = t210 + t190 * t190 + t191 * t191 + t192 * t192 + t193 * t193;
    const real_t t212 = t211 - t118 * (t197 * t197) - t136 * (t200 * t200);
    const real_t t213 = t212 - t157 * (t205 * t205) - t183 * (t206 * t206);
    const real_t t214 = TB_C(1.0) / t213;
    const real_t t215 = TB_MOMENT_WEIGHT * (t40 * t51 - t29 * t120);
    const real_t t216 = TB_MOMENT_WEIGHT * (t60 * t69 - t55 * t121);
    const real_t t217 = TB_MOMENT_WEIGHT * (t73 * t81 + t71 * t122);
    const real_t t218 = TB_MOMENT_WEIGHT * (t60 * t86 + t55 * t123);
    const real_t t219 = t185 * t215 - t186 * t216 + t187 * t217 - t188 * t218;
    const real_t t220 = TB_MOMENT_WEIGHT * (t40 * t91 + t29 * t125);
    const real_t t221 = TB_MOMENT_WEIGHT * (t97 * t104 + t94 * t126);
    const real_t t222 = TB_MOMENT_WEIGHT * (t71 * t127 - t73 * t109);
    const real_t t223 = TB_MOMENT_WEIGHT * (t94 * t128 - t97 * t114);
    const real_t t224 = t219 - t190 * t220 - t191 * t221 + t192 * t222 + t193 * t223;
    const real_t t225 = t51 * t215 + t69 * t216 + t81 * t217 + t86 * t218;
    const real_t t226 = t109 * t222 - (t225 + t91 * t220 + t104 * t221) + t114 * t223;
    const real_t t227 = t119 * t226;
    const real_t t228 = t122 * t217 - (t120 * t215 + t121 * t216) + t123 * t218;
    const real_t t229 = t228 + t125 * t220 + t126 * t221 + t127 * t222 + t128 * t223;
    const real_t t230 = t137 * (t229 - t118 * (t130 * t227));
    const real_t t231 = t224 - t118 * (t197 * t227) - t136 * (t200 * t230);
    const real_t t232 = t139 * t216 - t138 * t215 - t140 * t217 + t141 * t218;
    const real_t t233 = t232 + t143 * t220 - t144 * t221 - t145 * t222 + t146 * t223;
    const real_t t234 = t233 - t118 * (t150 * t227) - t136 * (t151 * t230);
    const real_t t235 = t158 * t234;
    const real_t t236 = t160 * t215 + t159 * t216 - t161 * t217 + t162 * t218;
    const real_t t237 = t236 - t164 * t220 - t165 * t221 - t166 * t222 + t167 * t223;
    const real_t t238 = t237 - t118 * (t171 * t227) - t136 * (t174 * t230);
    const real_t t239 = t184 * (t238 - t157 * (t176 * t235));
    const real_t t240 = t231 - t157 * (t205 * t235) - t183 * (t206 * t239);
    const real_t t241 = t214 * t240;
    const real_t t242 = t52 * t215 + t70 * t216 + t82 * t217 + t87 * t218;
    const real_t t243 = t92 * t220 - t242 + t105 * t221 - t110 * t222 - t115 * t223;
    const real_t t244 = t243 - t116 * t227 - t133 * t230 - t154 * t235 - t179 * t239;
    const real_t t245 = t215 * t215 + t216 * t216 + t217 * t217 + t218 * t218;
    const real_t t246 = t245 + t220 * t220 + t221 * t221 + t222 * t222 + t223 * t223;
    const real_t t247 = t246 - t118 * (t227 * t227) - t136 * (t230 * t230);
    const real_t t248 = t247 - t157 * (t235 * t235) - t183 * (t239 * t239);
    const real_t t249 = t248 - t213 * (t241 * t241);
    const real_t t250 = (t244 - t209 * t241) / t249;
    const real_t t251 = t209 * t214 - t241 * t250;
    const real_t t252 = t179 * t184 - t206 * t251 - t239 * t250;
    const real_t t253 = t154 * t158 - t176 * t252 - t205 * t251 - t235 * t250;
    const real_t t254 = t133 * t137 - t151 * t253 - t174 * t252 - t200 * t251;
    const real_t t255 = t254 - t230 * t250;
    const real_t t256 = t116 * t119 - t130 * t255 - t150 * t253 - t171 * t252;
    const real_t t257 = t256 - t197 * t251 - t227 * t250;
    const real_t t258 = TB_SQRT(t257 * t257 + t255 * t255 + t253 * t253) *
        TB_C(3.8490017945975055);
    const real_t t259 = TB_SQRT(t252 * t252 + t251 * t251 + t250 * t250) *
        TB_C(27.73500981126146);
    const real_t t260 = tb_min(TB_C(1.0) / tb_max(TB_C(1.0), t258), TB_C(1.0) /
        tb_max(TB_C(1.0), t259));
    const real_t estimate_0 = tb_min(tb_max(estimate[0] + t257 * t260, -TB_C(1.2)), TB_C(1.2));
    const real_t estimate_1 = tb_min(tb_max(estimate[1] + t255 * t260, -TB_C(1.2)), TB_C(1.2));
    const real_t estimate_2 = tb_min(tb_max(estimate[2] + t253 * t260, -TB_C(1.2)), TB_C(1.2));
    const real_t t261 = TB_MOMENT_WEIGHT * (t252 * t260);
    const real_t t262 = TB_MOMENT_WEIGHT * (t250 * t260);
    const real_t t263 = TB_MOMENT_WEIGHT * (t251 * t260);
    const real_t t264 = estimate[4] * t262 - estimate[5] * t263;
    const real_t t265 = (TB_C(1.0) - t21 / t9) * (TB_C(1.0) / tb_max(t1, TB_C(1e-30)));
    const real_t t266 = estimate[3] * t263 - estimate[4] * t261;
    const real_t t267 = estimate[5] * t261 - estimate[3] * t262;
    const real_t t268 = t261 - TB_C(0.5) * t264 + t265 * (estimate[4] * t266 - estimate[5] *
        t267);
    const real_t t269 = tb_max(estimate[3] + t268, -TB_C(1.5471975511965979));
    const real_t estimate_3 = tb_min(t269, TB_C(1.5471975511965979));
    const real_t t270 = t263 - TB_C(0.5) * t267 + t265 * (estimate[5] * t264 - estimate[3] *
        t266);
    const real_t t271 = tb_max(estimate[4] + t270, -TB_C(1.5471975511965979));
    const real_t estimate_4 = tb_min(t271, TB_C(1.5471975511965979));
    const real_t t272 = t262 - TB_C(0.5) * t266 + t265 * (estimate[3] * t267 - estimate[4] *
        t264);
    const real_t t273 = tb_max(estimate[5] + t272, -TB_C(1.5471975511965979));
    const real_t estimate_5 = tb_min(t273, TB_C(1.5471975511965979));
    const real_t t274 = t116 * t257 + t132 * t255 + t153 * t253 + t178 * t252;
    const real_t t275 = TB_C(16.62768775266122) * TB_EPSILON;
    const real_t t276 = t52 * t52 + t70 * t70 + t82 * t82 + t87 * t87 + t92 * t92;
    const real_t t277 = TB_C(1e-18) * (t276 + t105 * t105 + t110 * t110 + t115 * t115);
    const bool t278 = t274 + t208 * t251 + t243 * t250 <= t275 * t275 + t277;
    const real_t found_0 = t278 ? TB_C(1.0) : TB_C(0.0);
    const bool t279 = TB_C(0.0001) < t49 && TB_C(0.0001) < t67 && TB_C(0.0001) < t79;
    const bool t280 = t279 && TB_C(0.0001) < t84 && TB_C(0.0001) < t89 && TB_C(0.0001) < t102;
    const bool t281 = t280 && TB_C(0.0001) < t107 && TB_C(0.0001) < t112;
    const bool t282 = !t281;
    const real_t t283 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t284 = t283 < t118 && t283 < t136 && t283 < t157 && t283 < t183;
    const bool t285 = !(t284 && t283 < t213 && t283 < t249);
    if (t282 || t285) {
        estimate[0] = TB_C(0.0);
        estimate[1] = TB_C(0.0);
        estimate[2] = TB_C(0.0);
        estimate[3] = TB_C(0.0);
        estimate[4] = TB_C(0.0);
        estimate[5] = TB_C(0.0);
        found[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    estimate[0] = estimate_0;
    estimate[1] = estimate_1;
    estimate[2] = estimate_2;
    estimate[3] = estimate_3;
    estimate[4] = estimate_4;
    estimate[5] = estimate_5;
    found[0] = found_0;
    return TB_OK;
}

/* Pose and residual of the last estimate. */
static tb_status tb_forward_kinematics_finish(const real_t lengths[8], const real_t rails[1],
    const real_t estimate[6], real_t pose[6], real_t residual[1])
{
    (void)rails;
    const real_t t0 = estimate[3] * estimate[3] + estimate[4] * estimate[4];
    const real_t t1 = (t0 + estimate[5] * estimate[5]) * TB_C(0.25);
    const real_t t2 = TB_C(6.446950284384474e-26) + t1 * -TB_C(9.183689863795546e-29);
    const real_t t3 = TB_C(1.9572941063391263e-20) + t1 * (-TB_C(3.8681701706306835e-23) + t1 *
        t2);
    const real_t t4 = TB_C(2.8114572543455206e-15) + t1 * (-TB_C(8.22063524662433e-18) + t1 *
        t3);
    const real_t t5 = TB_C(1.6059043836821613e-10) + t1 * (-TB_C(7.647163731819816e-13) + t1 *
        t4);
    const real_t t6 = TB_C(2.7557319223985893e-06) + t1 * (-TB_C(2.505210838544172e-08) + t1 *
        t5);
    const real_t t7 = TB_C(0.008333333333333333) + t1 * (-TB_C(0.0001984126984126984) + t1 *
        t6);
    const real_t t8 = TB_C(1.0) + t1 * (-TB_C(0.16666666666666666) + t1 * t7);
    const real_t t9 = t8 * TB_C(0.5);
    const real_t t10 = estimate[3] * t9;
    const real_t t11 = estimate[4] * t9;
    const real_t t12 = t10 * t11;
    const real_t t13 = -TB_C(2.4795962632247972e-27) + t1 * TB_C(3.279889237069838e-30);
    const real_t t14 = -TB_C(8.896791392450574e-22) + t1 * (TB_C(1.6117375710961184e-24) + t1 *
        t13);
    const real_t t15 = -TB_C(1.5619206968586225e-16) + t1 * (TB_C(4.110317623312165e-19) + t1 *
        t14);
    const real_t t16 = -TB_C(1.1470745597729725e-11) + t1 * (TB_C(4.779477332387385e-14) + t1 *
        t15);
    const real_t t17 = -TB_C(2.755731922398589e-07) + t1 * (TB_C(2.08767569878681e-09) + t1 *
        t16);
    const real_t t18 = -TB_C(0.001388888888888889) + t1 * (TB_C(2.48015873015873e-05) + t1 *
        t17);
    const real_t t19 = -TB_C(0.5) + t1 * (TB_C(0.041666666666666664) + t1 * t18);
    const real_t t20 = TB_C(1.0) + t1 * t19;
    const real_t t21 = estimate[5] * t9;
    const real_t t22 = t20 * t21;
    const real_t t23 = t12 - t22;
    const real_t t24 = t10 * t21;
    const real_t t25 = t11 * t20;
    const real_t t26 = t24 + t25;
    const real_t t27 = TB_C(0.08) * t26;
    const real_t t28 = -TB_C(0.12) * t23 + t27;
    const real_t t29 = estimate[0] + t28;
    const real_t t30 = t11 * t11;
    const real_t t31 = t10 * t10;
    const real_t t32 = t21 * t21;
    const real_t t33 = t20 * t20 - (t30 + t31 + t32);
    const real_t t34 = TB_C(2.0) * t30 + t33;
    const real_t t35 = t11 * t21;
    const real_t t36 = t10 * t20;
    const real_t t37 = t35 - t36;
    const real_t t38 = TB_C(0.08) * t37;
    const real_t t39 = -TB_C(0.06) * t34 + t38;
    const real_t t40 = estimate[1] + t39;
    const real_t t41 = t40 * t40;
    const real_t t42 = t35 + t36;
    const real_t t43 = t33 + TB_C(2.0) * t32;
    const real_t t44 = TB_C(0.04) * t43;
    const real_t t45 = -TB_C(0.12) * t42 + t44;
    const real_t t46 = estimate[2] + t45;
    const real_t t47 = t46 * t46;
    const real_t t48 = TB_SQRT(t29 * t29 + t41 + t47);
    /* what the lengths disagree by: slack, an encoder fault */
    const real_t misfit_0 = lengths[0] - t48;
    const real_t t49 = t33 + TB_C(2.0) * t31;
    const real_t t50 = t26 * -TB_C(0.08);
    const real_t t51 = -TB_C(0.06) * t49 + t50;
    const real_t t52 = estimate[0] + t51;
    const real_t t53 = t52 * t52;
    const real_t t54 = t12 + t22;
    const real_t t55 = t37 * -TB_C(0.08);
    const real_t t56 = -TB_C(0.12) * t54 + t55;
    const real_t t57 = estimate[1] + t56;
    const real_t t58 = t24 - t25;
    const real_t t59 = t43 * -TB_C(0.04);
    const real_t t60 = -TB_C(0.12) * t58 + t59;
    const real_t t61 = TB_FRAME - (estimate[2] + t60);
    const real_t t62 = t61 * t61;
    const real_t t63 = TB_SQRT(t53 + t57 * t57 + t62);
    const real_t misfit_1 = lengths[1] - t63;
    const real_t t64 = t27 + t23 * TB_C(0.12);
    const real_t t65 = estimate[0] + t64;
    const real_t t66 = t38 + t34 * TB_C(0.06);
    const real_t t67 = TB_FRAME - (estimate[1] + t66);
    const real_t t68 = t67 * t67;
    const real_t t69 = t44 + t42 * TB_C(0.12);
    const real_t t70 = estimate[2] + t69;
    const real_t t71 = t70 * t70;
    const real_t t72 = TB_SQRT(t65 * t65 + t68 + t71);
    const real_t misfit_2 = lengths[2] - t72;
    const real_t t73 = misfit_0 * misfit_0 + misfit_1 * misfit_1 + misfit_2 * misfit_2;
    const real_t t74 = TB_FRAME - t57;
    const real_t t75 = TB_SQRT(t62 + (t53 + t74 * t74));
    const real_t misfit_3 = lengths[3] - t75;
    const real_t t76 = TB_FRAME - t29;
    const real_t t77 = TB_SQRT(t47 + (t41 + t76 * t76));
    const real_t misfit_4 = lengths[4] - t77;
    const real_t t78 = t50 + t49 * TB_C(0.06);
    const real_t t79 = TB_FRAME - (estimate[0] + t78);
    const real_t t80 = t79 * t79;
    const real_t t81 = t55 + t54 * TB_C(0.12);
    const real_t t82 = estimate[1] + t81;
    const real_t t83 = t59 + t58 * TB_C(0.12);
    const real_t t84 = TB_FRAME - (estimate[2] + t83);
    const real_t t85 = t84 * t84;
    const real_t t86 = TB_SQRT(t80 + t82 * t82 + t85);
    const real_t misfit_5 = lengths[5] - t86;
    const real_t t87 = t73 + misfit_3 * misfit_3 + misfit_4 * misfit_4 + misfit_5 * misfit_5;
    const real_t t88 = TB_FRAME - t65;
    const real_t t89 = TB_SQRT(t71 + (t68 + t88 * t88));
    const real_t misfit_6 = lengths[6] - t89;
    const real_t t90 = TB_FRAME - t82;
    const real_t t91 = TB_SQRT(t85 + (t80 + t90 * t90));
    const real_t misfit_7 = lengths[7] - t91;
    const real_t residual_0 = TB_SQRT(t87 + misfit_6 * misfit_6 + misfit_7 * misfit_7);
    const bool t92 = TB_C(0.0001) < t48 && TB_C(0.0001) < t63 && TB_C(0.0001) < t72;
    const bool t93 = t92 && TB_C(0.0001) < t75 && TB_C(0.0001) < t77 && TB_C(0.0001) < t86;
    const bool t94 = !(t93 && TB_C(0.0001) < t89 && TB_C(0.0001) < t91);
    const real_t t95 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const real_t t96 = TB_C(1.0) / t48;
    const real_t t97 = t29 * t96;
    const real_t t98 = TB_C(1.0) / t63;
    const real_t t99 = t52 * t98;
    const real_t t100 = TB_C(1.0) / t72;
    const real_t t101 = t65 * t100;
    const real_t t102 = TB_C(1.0) / t75;
    const real_t t103 = t52 * t102;
    const real_t t104 = t97 * t97 + t99 * t99 + t101 * t101 + t103 * t103;
    const real_t t105 = TB_C(1.0) / t77;
    const real_t t106 = t76 * t105;
    const real_t t107 = TB_C(1.0) / t86;
    const real_t t108 = t79 * t107;
    const real_t t109 = TB_C(1.0) / t89;
    const real_t t110 = t88 * t109;
    const real_t t111 = TB_C(1.0) / t91;
    const real_t t112 = t79 * t111;
    const real_t t113 = t104 + t106 * t106 + t108 * t108 + t110 * t110 + t112 * t112;
    const real_t t114 = t40 * t96;
    const real_t t115 = t57 * t98;
    const real_t t116 = t67 * t100;
    const real_t t117 = t74 * t102;
    const real_t t118 = t114 * t114 + t115 * t115 + t116 * t116 + t117 * t117;
    const real_t t119 = t40 * t105;
    const real_t t120 = t82 * t107;
    const real_t t121 = t67 * t109;
    const real_t t122 = t90 * t111;
    const real_t t123 = t118 + t119 * t119 + t120 * t120 + t121 * t121 + t122 * t122;
    const real_t t124 = t97 * t114 + t99 * t115 - t101 * t116 - t103 * t117;
    const real_t t125 = t124 - t106 * t119 - t108 * t120 + t110 * t121 + t112 * t122;
    const real_t t126 = TB_C(1.0) / t113;
    const real_t t127 = t125 * t126;
    const real_t t128 = t123 - t113 * (t127 * t127);
    const real_t t129 = t46 * t96;
    const real_t t130 = t61 * t98;
    const real_t t131 = t70 * t100;
    const real_t t132 = t61 * t102;
    const real_t t133 = t129 * t129 + t130 * t130 + t131 * t131 + t132 * t132;
    const real_t t134 = t46 * t105;
    const real_t t135 = t84 * t107;
    const real_t t136 = t70 * t109;
    const real_t t137 = t84 * t111;
    const real_t t138 = t133 + t134 * t134 + t135 * t135 + t136 * t136 + t137 * t137;
    const real_t t139 = t97 * t129 - t99 * t130 + t101 * t131 - t103 * t132;
    const real_t t140 = t139 - t106 * t134 + t108 * t135 - t110 * t136 + t112 * t137;
    const real_t t141 = t126 * t140;
    const real_t t142 = t114 * t129 - t115 * t130 - t116 * t131 + t117 * t132;
    const real_t t143 = t142 + t119 * t134 - t120 * t135 - t121 * t136 + t122 * t137;
    const real_t t144 = TB_C(1.0) / t128;
    const real_t t145 = (t143 - t113 * (t127 * t141)) * t144;
    const real_t t146 = t138 - t113 * (t141 * t141) - t128 * (t145 * t145);
    const real_t t147 = (t45 * t114 - t39 * t129) * TB_MOMENT_WEIGHT;
    const real_t t148 = TB_MOMENT_WEIGHT * (t60 * t115 + t56 * t130);
    const real_t t149 = TB_MOMENT_WEIGHT * (t69 * t116 + t66 * t131);
    const real_t t150 = TB_MOMENT_WEIGHT * (t56 * t132 - t60 * t117);
    const real_t t151 = t147 * t147 + t148 * t148 + t149 * t149 + t150 * t150;
    const real_t t152 = TB_MOMENT_WEIGHT * (t45 * t119 - t39 * t134);
    const real_t t153 = TB_MOMENT_WEIGHT * (t83 * t120 + t81 * t135);
    const real_t t154 = TB_MOMENT_WEIGHT * (t69 * t121 + t66 * t136);
    const real_t t155 = TB_MOMENT_WEIGHT * (t81 * t137 - t83 * t122);
    const real_t t156 = t151 + t152 * t152 + t153 * t153 + t154 * t154 + t155 * t155;
    const real_t t157 = t101 * t149 - (t97 * t147 + t99 * t148) - t103 * t150;
    const real_t t158 = t157 + t106 * t152 + t108 * t153 - t110 * t154 + t112 * t155;
    const real_t t159 = t126 * t158;
    const real_t t160 = t117 * t150 - (t114 * t147 + t115 * t148 + t116 * t149);
    const real_t t161 = t160 - t119 * t152 - t120 * t153 - t121 * t154 + t122 * t155;
    const real_t t162 = t144 * (t161 - t113 * (t127 * t159));
    const real_t t163 = t156 - t113 * (t159 * t159) - t128 * (t162 * t162);
    const real_t t164 = t130 * t148 - t129 * t147 + t131 * t149 + t132 * t150;
    const real_t t165 = t164 - t134 * t152 + t135 * t153 + t136 * t154 + t137 * t155;
    const real_t t166 = t165 - t113 * (t141 * t159) - t128 * (t145 * t162);
    const real_t t167 = TB_C(1.0) / t146;
    const real_t t168 = t166 * t167;
    const real_t t169 = t163 - t146 * (t168 * t168);
    const bool t170 = t95 < t113 && t95 < t128 && t95 < t146 && t95 < t169;
    const real_t t171 = TB_MOMENT_WEIGHT * (t28 * t129 - t45 * t97);
    const real_t t172 = TB_MOMENT_WEIGHT * (t60 * t99 + t51 * t130);
    const real_t t173 = TB_MOMENT_WEIGHT * (t64 * t131 - t69 * t101);
    const real_t t174 = TB_MOMENT_WEIGHT * (t60 * t103 + t51 * t132);
    const real_t t175 = t171 * t171 + t172 * t172 + t173 * t173 + t174 * t174;
    const real_t t176 = TB_MOMENT_WEIGHT * (t45 * t106 + t28 * t134);
    const real_t t177 = TB_MOMENT_WEIGHT * (t83 * t108 - t78 * t135);
    const real_t t178 = TB_MOMENT_WEIGHT * (t69 * t110 + t64 * t136);
    const real_t t179 = TB_MOMENT_WEIGHT * (t83 * t112 - t78 * t137);
    const real_t t180 = t175 + t176 * t176 + t177 * t177 + t178 * t178 + t179 * t179;
    const real_t t181 = t99 * t172 - t97 * t171 - t101 * t173 + t103 * t174;
    const real_t t182 = t181 + t106 * t176 + t108 * t177 + t110 * t178 + t112 * t179;
    const real_t t183 = t126 * t182;
    const real_t t184 = t115 * t172 - t114 * t171 + t116 * t173 - t117 * t174;
    const real_t t185 = t184 - t119 * t176 - t120 * t177 + t121 * t178 + t122 * t179;
    const real_t t186 = t144 * (t185 - t113 * (t127 * t183));
    const real_t t187 = t180 - t113 * (t183 * t183) - t128 * (t186 * t186);
    const real_t t188 = t129 * t171 + t130 * t172 + t131 * t173 + t132 * t174;
    const real_t t189 = t135 * t177 - (t188 + t134 * t176) - t136 * t178 + t137 * t179;
    const real_t t190 = t189 - t113 * (t141 * t183) - t128 * (t145 * t186);
    const real_t t191 = t167 * t190;
    const real_t t192 = t147 * t171 - t148 * t172 - t149 * t173 - t150 * t174;
    const real_t t193 = t192 + t152 * t176 + t153 * t177 - t154 * t178 + t155 * t179;
    const real_t t194 = t193 - t113 * (t159 * t183) - t128 * (t162 * t186);
    const real_t t195 = TB_C(1.0) / t169;
    const real_t t196 = (t194 - t146 * (t168 * t191)) * t195;
    const real_t t197 = t187 - t146 * (t191 * t191) - t169 * (t196 * t196);
    const real_t t198 = TB_MOMENT_WEIGHT * (t39 * t97 - t28 * t114);
    const real_t t199 = TB_MOMENT_WEIGHT * (t56 * t99 - t51 * t115);
    const real_t t200 = TB_MOMENT_WEIGHT * (t66 * t101 + t64 * t116);
    const real_t t201 = TB_MOMENT_WEIGHT * (t56 * t103 + t51 * t117);
    const real_t t202 = t198 * t198 + t199 * t199 + t200 * t200 + t201 * t201;
    const real_t t203 = TB_MOMENT_WEIGHT * (t39 * t106 + t28 * t119);
    const real_t t204 = TB_MOMENT_WEIGHT * (t81 * t108 + t78 * t120);
    const real_t t205 = TB_MOMENT_WEIGHT * (t64 * t121 - t66 * t110);
    const real_t t206 = TB_MOMENT_WEIGHT * (t78 * t122 - t81 * t112);
    const real_t t207 = t202 + t203 * t203 + t204 * t204 + t205 * t205 + t206 * t206;
    const real_t t208 = t97 * t198 + t99 * t199 + t101 * t200 + t103 * t201;
    const real_t t209 = t110 * t205 - (t208 + t106 * t203 + t108 * t204) + t112 * t206;
    const real_t t210 = t126 * t209;
    const real_t t211 = t116 * t200 - (t114 * t198 + t115 * t199) + t117 * t201;
    const real_t t212 = t211 + t119 * t203 + t120 * t204 + t121 * t205 + t122 * t206;
    const real_t t213 = t144 * (t212 - t113 * (t127 * t210));
    const real_t t214 = t207 - t113 * (t210 * t210) - t128 * (t213 * t213);
    const real_t t215 = t130 * t199 - t129 * t198 - t131 * t200 + t132 * t201;
    const real_t t216 = t215 + t134 * t203 - t135 * t204 - t136 * t205 + t137 * t206;
    const real_t t217 = t216 - t113 * (t141 * t210) - t128 * (t145 * t213);
    const real_t t218 = t167 * t217;
    const real_t t219 = t147 * t198 + t148 * t199 - t149 * t200 + t150 * t201;
    const real_t t220 = t219 - t152 * t203 - t153 * t204 - t154 * t205 + t155 * t206;
    const real_t t221 = t220 - t113 * (t159 * t210) - t128 * (t162 * t213);
    const real_t t222 = t195 * (t221 - t146 * (t168 * t218));
    const real_t t223 = t214 - t146 * (t218 * t218) - t169 * (t222 * t222);
    const real_t t224 = t171 * t198 - t172 * t199 + t173 * t200 - t174 * t201;
    const real_t t225 = t224 - t176 * t203 - t177 * t204 + t178 * t205 + t179 * t206;
    const real_t t226 = t225 - t113 * (t183 * t210) - t128 * (t186 * t213);
    const real_t t227 = t226 - t146 * (t191 * t218) - t169 * (t196 * t222);
    const real_t t228 = t227 / t197;
    const bool t229 = t170 && t95 < t197 && t95 < t223 - t197 * (t228 * t228);
    const bool t230 = !t229;
    if (t94 || t230) {
        pose[0] = TB_C(0.0);
        pose[1] = TB_C(0.0);
        pose[2] = TB_C(0.0);
        pose[3] = TB_C(0.0);
        pose[4] = TB_C(0.0);
        pose[5] = TB_C(0.0);
        residual[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    pose[0] = estimate[0];
    pose[1] = estimate[1];
    pose[2] = estimate[2];
    pose[3] = estimate[3];
    pose[4] = estimate[4];
    pose[5] = estimate[5];
    residual[0] = residual_0;
    return TB_OK;
}

tb_status tb_forward_kinematics(const real_t guess[6], const real_t lengths[8],
    const real_t rails[1], real_t pose[6], real_t residual[1])
{
    real_t estimate[6];
    real_t found[1] = {TB_C(0.0)};
    tb_status status = tb_forward_kinematics_begin(guess, lengths, rails, estimate);
    for (int steps = 0; steps < 16 && status == TB_OK && !(found[0] > TB_C(0.0)); steps++) {
        status = tb_forward_kinematics_step(lengths, rails, estimate, found);
    }
    if (status == TB_OK && !(found[0] > TB_C(0.0))) {
        status = TB_INACCURATE;
    }
    if (status != TB_OK) {
        pose[0] = TB_C(0.0);
        pose[1] = TB_C(0.0);
        pose[2] = TB_C(0.0);
        pose[3] = TB_C(0.0);
        pose[4] = TB_C(0.0);
        pose[5] = TB_C(0.0);
        residual[0] = TB_C(0.0);
        return status;
    }
    return tb_forward_kinematics_finish(lengths, rails, estimate, pose, residual);
}

/* The guess is the first estimate. */
static tb_status tb_locate_begin(const real_t guess[6], const real_t lengths[8], const real_t rails[1],
    const real_t length_rates[8], const real_t rail_rates[1], real_t estimate[6])
{
    (void)rails;
    (void)rail_rates;
    if (!(guess[0] >= -TB_C(1.2) && guess[0] <= TB_C(1.2)
          && guess[1] >= -TB_C(1.2) && guess[1] <= TB_C(1.2)
          && guess[2] >= -TB_C(1.2) && guess[2] <= TB_C(1.2)
          && guess[3] >= -TB_C(1.5471975511965979) && guess[3] <= TB_C(1.5471975511965979)
          && guess[4] >= -TB_C(1.5471975511965979) && guess[4] <= TB_C(1.5471975511965979)
          && guess[5] >= -TB_C(1.5471975511965979) && guess[5] <= TB_C(1.5471975511965979)
          && lengths[0] >= TB_C(0.0) && lengths[0] <= TB_C(7.199999999999999)
          && lengths[1] >= TB_C(0.0) && lengths[1] <= TB_C(7.199999999999999)
          && lengths[2] >= TB_C(0.0) && lengths[2] <= TB_C(7.199999999999999)
          && lengths[3] >= TB_C(0.0) && lengths[3] <= TB_C(7.199999999999999)
          && lengths[4] >= TB_C(0.0) && lengths[4] <= TB_C(7.199999999999999)
          && lengths[5] >= TB_C(0.0) && lengths[5] <= TB_C(7.199999999999999)
          && lengths[6] >= TB_C(0.0) && lengths[6] <= TB_C(7.199999999999999)
          && lengths[7] >= TB_C(0.0) && lengths[7] <= TB_C(7.199999999999999)
          && TB_ABS(length_rates[0]) + TB_ABS(length_rates[1]) + TB_ABS(length_rates[2]) +
              TB_ABS(length_rates[3]) + TB_ABS(length_rates[4]) + TB_ABS(length_rates[5]) +
              TB_ABS(length_rates[6]) + TB_ABS(length_rates[7]) <= TB_C(800.0))) {
        estimate[0] = TB_C(0.0);
        estimate[1] = TB_C(0.0);
        estimate[2] = TB_C(0.0);
        estimate[3] = TB_C(0.0);
        estimate[4] = TB_C(0.0);
        estimate[5] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    estimate[0] = guess[0];
    estimate[1] = guess[1];
    estimate[2] = guess[2];
    estimate[3] = guess[3];
    estimate[4] = guess[4];
    estimate[5] = guess[5];
    return TB_OK;
}

/* Gauss-Newton step on the misfit of the lengths. */
static tb_status tb_locate_step(const real_t lengths[8], const real_t rails[1], real_t estimate[6],
    real_t found[1])
{
    (void)rails;
    const real_t t0 = estimate[3] * estimate[3] + estimate[4] * estimate[4];
    const real_t t1 = t0 + estimate[5] * estimate[5];
    const real_t t2 = t1 * TB_C(0.25);
    const real_t t3 = TB_C(6.446950284384474e-26) + t2 * -TB_C(9.183689863795546e-29);
    const real_t t4 = TB_C(1.9572941063391263e-20) + t2 * (-TB_C(3.8681701706306835e-23) + t2 *
        t3);
    const real_t t5 = TB_C(2.8114572543455206e-15) + t2 * (-TB_C(8.22063524662433e-18) + t2 *
        t4);
    const real_t t6 = TB_C(1.6059043836821613e-10) + t2 * (-TB_C(7.647163731819816e-13) + t2 *
        t5);
    const real_t t7 = TB_C(2.7557319223985893e-06) + t2 * (-TB_C(2.505210838544172e-08) + t2 *
        t6);
    const real_t t8 = TB_C(0.008333333333333333) + t2 * (-TB_C(0.0001984126984126984) + t2 *
        t7);
    const real_t t9 = TB_C(1.0) + t2 * (-TB_C(0.16666666666666666) + t2 * t8);
    const real_t t10 = t9 * TB_C(0.5);
    const real_t t11 = estimate[3] * t10;
    const real_t t12 = estimate[4] * t10;
    const real_t t13 = t11 * t12;
    const real_t t14 = -TB_C(2.4795962632247972e-27) + t2 * TB_C(3.279889237069838e-30);
    const real_t t15 = -TB_C(8.896791392450574e-22) + t2 * (TB_C(1.6117375710961184e-24) + t2 *
        t14);
    const real_t t16 = -TB_C(1.5619206968586225e-16) + t2 * (TB_C(4.110317623312165e-19) + t2 *
        t15);
    const real_t t17 = -TB_C(1.1470745597729725e-11) + t2 * (TB_C(4.779477332387385e-14) + t2 *
        t16);
    const real_t t18 = -TB_C(2.755731922398589e-07) + t2 * (TB_C(2.08767569878681e-09) + t2 *
        t17);
    const real_t t19 = -TB_C(0.001388888888888889) + t2 * (TB_C(2.48015873015873e-05) + t2 *
        t18);
    const real_t t20 = -TB_C(0.5) + t2 * (TB_C(0.041666666666666664) + t2 * t19);
    const real_t t21 = TB_C(1.0) + t2 * t20;
    const real_t t22 = estimate[5] * t10;
    const real_t t23 = t21 * t22;
    const real_t t24 = t13 - t23;
    const real_t t25 = t11 * t22;
    const real_t t26 = t12 * t21;
    const real_t t27 = t25 + t26;
    const real_t t28 = TB_C(0.08) * t27;
    const real_t t29 = -TB_C(0.12) * t24 + t28;
    const real_t t30 = estimate[0] + t29;
    const real_t t31 = t12 * t12;
    const real_t t32 = t11 * t11;
    const real_t t33 = t22 * t22;
    const real_t t34 = t21 * t21 - (t31 + t32 + t33);
    const real_t t35 = TB_C(2.0) * t31 + t34;
    const real_t t36 = t12 * t22;
    const real_t t37 = t11 * t21;
    const real_t t38 = t36 - t37;
    const real_t t39 = TB_C(0.08) * t38;
    const real_t t40 = -TB_C(0.06) * t35 + t39;
    const real_t t41 = estimate[1] + t40;
    const real_t t42 = t41 * t41;
    const real_t t43 = t36 + t37;
    const real_t t44 = t34 + TB_C(2.0) * t33;
    const real_t t45 = TB_C(0.04) * t44;
    const real_t t46 = -TB_C(0.12) * t43 + t45;
    const real_t t47 = estimate[2] + t46;
    const real_t t48 = t47 * t47;
    const real_t t49 = TB_SQRT(t30 * t30 + t42 + t48);
    const real_t t50 = TB_C(1.0) / t49;
    const real_t t51 = t30 * t50;
    const real_t t52 = lengths[0] - t49;
    const real_t t53 = t34 + TB_C(2.0) * t32;
    const real_t t54 = t27 * -TB_C(0.08);
    const real_t t55 = -TB_C(0.06) * t53 + t54;
    const real_t t56 = estimate[0] + t55;
    const real_t t57 = t56 * t56;
    const real_t t58 = t13 + t23;
    const real_t t59 = t38 * -TB_C(0.08);
    const real_t t60 = -TB_C(0.12) * t58 + t59;
    const real_t t61 = estimate[1] + t60;
    const real_t t62 = t25 - t26;
    const real_t t63 = t44 * -TB_C(0.04);
    const real_t t64 = -TB_C(0.12) * t62 + t63;
    const real_t t65 = TB_FRAME - (estimate[2] + t64);
    const real_t t66 = t65 * t65;
    const real_t t67 = TB_SQRT(t57 + t61 * t61 + t66);
    const real_t t68 = TB_C(1.0) / t67;
    const real_t t69 = t56 * t68;
    const real_t t70 = lengths[1] - t67;
    const real_t t71 = t28 + t24 * TB_C(0.12);
    const real_t t72 = estimate[0] + t71;
    const real_t t73 = t39 + t35 * TB_C(0.06);
    const real_t t74 = TB_FRAME - (estimate[1] + t73);
    const real_t t75 = t74 * t74;
    const real_t t76 = t45 + t43 * TB_C(0.12);
    const real_t t77 = estimate[2] + t76;
    const real_t t78 = t77 * t77;
    const real_t t79 = TB_SQRT(t72 * t72 + t75 + t78);
    const real_t t80 = TB_C(1.0) / t79;
    const real_t t81 = t72 * t80;
    const real_t t82 = lengths[2] - t79;
    const real_t t83 = TB_FRAME - t61;
    const real_t t84 = TB_SQRT(t66 + (t57 + t83 * t83));
    const real_t t85 = TB_C(1.0) / t84;
    const real_t t86 = t56 * t85;
    const real_t t87 = lengths[3] - t84;
    const real_t t88 = TB_FRAME - t30;
    const real_t t89 = TB_SQRT(t48 + (t42 + t88 * t88));
    const real_t t90 = TB_C(1.0) / t89;
    const real_t t91 = t88 * t90;
    const real_t t92 = lengths[4] - t89;
    const real_t t93 = t51 * t52 + t69 * t70 + t81 * t82 + t86 * t87 - t91 * t92;
    const real_t t94 = t54 + t53 * TB_C(0.06);
    const real_t t95 = TB_FRAME - (estimate[0] + t94);
    const real_t t96 = t95 * t95;
    const real_t t97 = t59 + t58 * TB_C(0.12);
    const real_t t98 = estimate[1] + t97;
    const real_t t99 = t63 + t62 * TB_C(0.12);
    const real_t t100 = TB_FRAME - (estimate[2] + t99);
    const real_t t101 = t100 * t100;
    const real_t t102 = TB_SQRT(t96 + t98 * t98 + t101);
    const real_t t103 = TB_C(1.0) / t102;
    const real_t t104 = t95 * t103;
    const real_t t105 = lengths[5] - t102;
    const real_t t106 = TB_FRAME - t72;
    const real_t t107 = TB_SQRT(t78 + (t75 + t106 * t106));
    const real_t t108 = TB_C(1.0) / t107;
    const real_t t109 = t106 * t108;
    const real_t t110 = lengths[6] - t107;
    const real_t t111 = TB_FRAME - t98;
    const real_t t112 = TB_SQRT(t101 + (t96 + t111 * t111));
    const real_t t113 = TB_C(1.0) / t112;
    const real_t t114 = t95 * t113;
    const real_t t115 = lengths[7] - t112;
    const real_t t116 = t93 - t104 * t105 - t109 * t110 - t114 * t115;
    const real_t t117 = t51 * t51 + t69 * t69 + t81 * t81 + t86 * t86 + t91 * t91;
    const real_t t118 = t117 + t104 * t104 + t109 * t109 + t114 * t114;
    const real_t t119 = TB_C(1.0) / t118;
    const real_t t120 = t41 * t50;
    const real_t t121 = t61 * t68;
    const real_t t122 = t74 * t80;
    const real_t t123 = t83 * t85;
    const real_t t124 = t51 * t120 + t69 * t121 - t81 * t122 - t86 * t123;
    const real_t t125 = t41 * t90;
    const real_t t126 = t98 * t103;
    const real_t t127 = t74 * t108;
    const real_t t128 = t111 * t113;
    const real_t t129 = t124 - t91 * t125 - t104 * t126 + t109 * t127 + t114 * t128;
    const real_t t130 = t119 * t129;
    const real_t t131 = t52 * t120 + t70 * t121 - t82 * t122 - t87 * t123;
    const real_t t132 = t131 + t92 * t125 + t105 * t126 - t110 * t127 - t115 * t128;
    const real_t t133 = t132 - t116 * t130;
    const real_t t134 = t120 * t120 + t121 * t121 + t122 * t122 + t123 * t123;
    const real_t t135 = t134 + t125 * t125 + t126 * t126 + t127 * t127 + t128 * t128;
    const real_t t136 = t135 - t118 * (t130 * t130);
    const real_t t137 = TB_C(1.0) / t136;
    const real_t t138 = t47 * t50;
    const real_t t139 = t65 * t68;
    const real_t t140 = t77 * t80;
    const real_t t141 = t65 * t85;
    const real_t t142 = t120 * t138 - t121 * t139 - t122 * t140 + t123 * t141;
    const real_t t143 = t47 * t90;
    const real_t t144 = t100 * t103;
    const real_t t145 = t77 * t108;
    const real_t t146 = t100 * t113;
    const real_t t147 = t142 + t125 * t143 - t126 * t144 - t127 * t145 + t128 * t146;
    const real_t t148 = t51 * t138 - t69 * t139 + t81 * t140 - t86 * t141;
    const real_t t149 = t148 - t91 * t143 + t104 * t144 - t109 * t145 + t114 * t146;
    const real_t t150 = t119 * t149;
    const real_t t151 = t137 * (t147 - t118 * (t130 * t150));
    const real_t t152 = t52 * t138 - t70 * t139 + t82 * t140 - t87 * t141;
    const real_t t153 = t152 + t92 * t143 - t105 * t144 + t110 * t145 - t115 * t146;
    const real_t t154 = t153 - t116 * t150 - t133 * t151;
    const real_t t155 = t138 * t138 + t139 * t139 + t140 * t140 + t141 * t141;
    const real_t t156 = t155 + t143 * t143 + t144 * t144 + t145 * t145 + t146 * t146;
    const real_t t157 = t156 - t118 * (t150 * t150) - t136 * (t151 * t151);
    const real_t t158 = TB_C(1.0) / t157;
    const real_t t159 = (t64 * t121 + t60 * t139) * TB_MOMENT_WEIGHT;
    const real_t t160 = TB_MOMENT_WEIGHT * (t46 * t120 - t40 * t138);
    const real_t t161 = TB_MOMENT_WEIGHT * (t76 * t122 + t73 * t140);
    const real_t t162 = TB_MOMENT_WEIGHT * (t60 * t141 - t64 * t123);
    const real_t t163 = t139 * t159 - t138 * t160 + t140 * t161 + t141 * t162;
    const real_t t164 = TB_MOMENT_WEIGHT * (t46 * t125 - t40 * t143);
    const real_t t165 = TB_MOMENT_WEIGHT * (t99 * t126 + t97 * t144);
    const real_t t166 = TB_MOMENT_WEIGHT * (t76 * t127 + t73 * t145);
    const real_t t167 = TB_MOMENT_WEIGHT * (t97 * t146 - t99 * t128);
    const real_t t168 = t163 - t143 * t164 + t144 * t165 + t145 * t166 + t146 * t167;
    const real_t t169 = t81 * t161 - (t51 * t160 + t69 * t159) - t86 * t162;
    const real_t t170 = t169 + t91 * t164 + t104 * t165 - t109 * t166 + t114 * t167;
    const real_t t171 = t119 * t170;
    const real_t t172 = t123 * t162 - (t120 * t160 + t121 * t159 + t122 * t161);
    const real_t t173 = t172 - t125 * t164 - t126 * t165 - t127 * t166 + t128 * t167;
    const real_t t174 = t137 * (t173 - t118 * (t130 * t171));
    const real_t t175 = t168 - t118 * (t150 * t171) - t136 * (t151 * t174);
    const real_t t176 = t158 * t175;
    const real_t t177 = t82 * t161 - (t52 * t160 + t70 * t159) - t87 * t162;
    const real_t t178 = t177 - t92 * t164 - t105 * t165 + t110 * t166 - t115 * t167;
    const real_t t179 = t178 - t116 * t171 - t133 * t174 - t154 * t176;
    const real_t t180 = t160 * t160 + t159 * t159 + t161 * t161 + t162 * t162;
    const real_t t181 = t180 + t164 * t164 + t165 * t165 + t166 * t166 + t167 * t167;
    const real_t t182 = t181 - t118 * (t171 * t171) - t136 * (t174 * t174);
    const real_t t183 = t182 - t157 * (t176 * t176);
    const real_t t184 = TB_C(1.0) / t183;
    const real_t t185 = TB_MOMENT_WEIGHT * (t29 * t138 - t46 * t51);
    const real_t t186 = TB_MOMENT_WEIGHT * (t64 * t69 + t55 * t139);
    const real_t t187 = TB_MOMENT_WEIGHT * (t71 * t140 - t76 * t81);
    const real_t t188 = TB_MOMENT_WEIGHT * (t64 * t86 + t55 * t141);
    const real_t t189 = t160 * t185 - t159 * t186 - t161 * t187 - t162 * t188;
    const real_t t190 = TB_MOMENT_WEIGHT * (t46 * t91 + t29 * t143);
    const real_t t191 = TB_MOMENT_WEIGHT * (t99 * t104 - t94 * t144);
    const real_t t192 = TB_MOMENT_WEIGHT * (t76 * t109 + t71 * t145);
    const real_t t193 = TB_MOMENT_WEIGHT * (t99 * t114 - t94 * t146);
    const real_t t194 = t189 + t164 * t190 + t165 * t191 - t166 * t192 + t167 * t193;
    const real_t t195 = t69 * t186 - t51 * t185 - t81 * t187 + t86 * t188;
    const real_t t196 = t195 + t91 * t190 + t104 * t191 + t109 * t192 + t114 * t193;
    const real_t t197 = t119 * t196;
    const real_t t198 = t121 * t186 - t120 * t185 + t122 * t187 - t123 * t188;
    const real_t t199 = t198 - t125 * t190 - t126 * t191 + t127 * t192 + t128 * t193;
    const real_t t200 = t137 * (t199 - t118 * (t130 * t197));
    const real_t t201 = t194 - t118 * (t171 * t197) - t136 * (t174 * t200);
    const real_t t202 = t138 * t185 + t139 * t186 + t140 * t187 + t141 * t188;
    const real_t t203 = t144 * t191 - (t202 + t143 * t190) - t145 * t192 + t146 * t193;
    const real_t t204 = t203 - t118 * (t150 * t197) - t136 * (t151 * t200);
    const real_t t205 = t158 * t204;
    const real_t t206 = t184 * (t201 - t157 * (t176 * t205));
    const real_t t207 = t70 * t186 - t52 * t185 - t82 * t187 + t87 * t188;
    const real_t t208 = t207 - t92 * t190 - t105 * t191 - t110 * t192 - t115 * t193;
    const real_t t209 = t208 - t116 * t197 - t133 * t200 - t154 * t205 - t179 * t206;
    const real_t t210 = t185 * t185 + t186 * t186 + t187 * t187 + t188 * t188;
    const real_t t211 = t210 + t190 * t190 + t191 * t191 + t192 * t192 + t193 * t193;
    const real_t t212 = t211 - t118 * (t197 * t197) - t136 * (t200 * t200);
    const real_t t213 = t212 - t157 * (t205 * t205) - t183 * (t206 * t206);
    const real_t t214 = TB_C(1.0) / t213;
    const real_t t215 = TB_MOMENT_WEIGHT * (t40 * t51 - t29 * t120);
    const real_t t216 = TB_MOMENT_WEIGHT * (t60 * t69 - t55 * t121);
    const real_t t217 = TB_MOMENT_WEIGHT * (t73 * t81 + t71 * t122);
    const real_t t218 = TB_MOMENT_WEIGHT * (t60 * t86 + t55 * t123);
    const real_t t219 = t185 * t215 - t186 * t216 + t187 * t217 - t188 * t218;
    const real_t t220 = TB_MOMENT_WEIGHT * (t40 * t91 + t29 * t125);
    const real_t t221 = TB_MOMENT_WEIGHT * (t97 * t104 + t94 * t126);
    const real_t t222 = TB_MOMENT_WEIGHT * (t71 * t127 - t73 * t109);
    const real_t t223 = TB_MOMENT_WEIGHT * (t94 * t128 - t97 * t114);
    const real_t t224 = t219 - t190 * t220 - t191 * t221 + t192 * t222 + t193 * t223;
    const real_t t225 = t51 * t215 + t69 * t216 + t81 * t217 + t86 * t218;
    const real_t t226 = t109 * t222 - (t225 + t91 * t220 + t104 * t221) + t114 * t223;
    const real_t t227 = t119 * t226;
    const real_t t228 = t122 * t217 - (t120 * t215 + t121 * t216) + t123 * t218;
    const real_t t229 = t228 + t125 * t220 + t126 * t221 + t127 * t222 + t128 * t223;
    const real_t t230 = t137 * (t229 - t118 * (t130 * t227));
    const real_t t231 = t224 - t118 * (t197 * t227) - t136 * (t200 * t230);
    const real_t t232 = t139 * t216 - t138 * t215 - t140 * t217 + t141 * t218;
    const real_t t233 = t232 + t143 * t220 - t144 * t221 - t145 * t222 + t146 * t223;
    const real_t t234 = t233 - t118 * (t150 * t227) - t136 * (t151 * t230);
    const real_t t235 = t158 * t234;
    const real_t t236 = t160 * t215 + t159 * t216 - t161 * t217 + t162 * t218;
    const real_t t237 = t236 - t164 * t220 - t165 * t221 - t166 * t222 + t167 * t223;
    const real_t t238 = t237 - t118 * (t171 * t227) - t136 * (t174 * t230);
    const real_t t239 = t184 * (t238 - t157 * (t176 * t235));
    const real_t t240 = t231 - t157 * (t205 * t235) - t183 * (t206 * t239);
    const real_t t241 = t214 * t240;
    const real_t t242 = t52 * t215 + t70 * t216 + t82 * t217 + t87 * t218;
    const real_t t243 = t92 * t220 - t242 + t105 * t221 - t110 * t222 - t115 * t223;
    const real_t t244 = t243 - t116 * t227 - t133 * t230 - t154 * t235 - t179 * t239;
    const real_t t245 = t215 * t215 + t216 * t216 + t217 * t217 + t218 * t218;
    const real_t t246 = t245 + t220 * t220 + t221 * t221 + t222 * t222 + t223 * t223;
    const real_t t247 = t246 - t118 * (t227 * t227) - t136 * (t230 * t230);
    const real_t t248 = t247 - t157 * (t235 * t235) - t183 * (t239 * t239);
    const real_t t249 = t248 - t213 * (t241 * t241);
    const real_t t250 = (t244 - t209 * t241) / t249;
    const real_t t251 = t209 * t214 - t241 * t250;
    const real_t t252 = t179 * t184 - t206 * t251 - t239 * t250;
    const real_t t253 = t154 * t158 - t176 * t252 - t205 * t251 - t235 * t250;
    const real_t t254 = t133 * t137 - t151 * t253 - t174 * t252 - t200 * t251;
    const real_t t255 = t254 - t230 * t250;
    const real_t t256 = t116 * t119 - t130 * t255 - t150 * t253 - t171 * t252;
    const real_t t257 = t256 - t197 * t251 - t227 * t250;
    const real_t t258 = TB_SQRT(t257 * t257 + t255 * t255 + t253 * t253) *
        TB_C(3.8490017945975055);
    const real_t t259 = TB_SQRT(t252 * t252 + t251 * t251 + t250 * t250) *
        TB_C(27.73500981126146);
    const real_t t260 = tb_min(TB_C(1.0) / tb_max(TB_C(1.0), t258), TB_C(1.0) /
        tb_max(TB_C(1.0), t259));
    const real_t estimate_0 = tb_min(tb_max(estimate[0] + t257 * t260, -TB_C(1.2)), TB_C(1.2));
    const real_t estimate_1 = tb_min(tb_max(estimate[1] + t255 * t260, -TB_C(1.2)), TB_C(1.2));
    const real_t estimate_2 = tb_min(tb_max(estimate[2] + t253 * t260, -TB_C(1.2)), TB_C(1.2));
    const real_t t261 = TB_MOMENT_WEIGHT * (t252 * t260);
    const real_t t262 = TB_MOMENT_WEIGHT * (t250 * t260);
    const real_t t263 = TB_MOMENT_WEIGHT * (t251 * t260);
    const real_t t264 = estimate[4] * t262 - estimate[5] * t263;
    const real_t t265 = (TB_C(1.0) - t21 / t9) * (TB_C(1.0) / tb_max(t1, TB_C(1e-30)));
    const real_t t266 = estimate[3] * t263 - estimate[4] * t261;
    const real_t t267 = estimate[5] * t261 - estimate[3] * t262;
    const real_t t268 = t261 - TB_C(0.5) * t264 + t265 * (estimate[4] * t266 - estimate[5] *
        t267);
    const real_t t269 = tb_max(estimate[3] + t268, -TB_C(1.5471975511965979));
    const real_t estimate_3 = tb_min(t269, TB_C(1.5471975511965979));
    const real_t t270 = t263 - TB_C(0.5) * t267 + t265 * (estimate[5] * t264 - estimate[3] *
        t266);
    const real_t t271 = tb_max(estimate[4] + t270, -TB_C(1.5471975511965979));
    const real_t estimate_4 = tb_min(t271, TB_C(1.5471975511965979));
    const real_t t272 = t262 - TB_C(0.5) * t266 + t265 * (estimate[3] * t267 - estimate[4] *
        t264);
    const real_t t273 = tb_max(estimate[5] + t272, -TB_C(1.5471975511965979));
    const real_t estimate_5 = tb_min(t273, TB_C(1.5471975511965979));
    const real_t t274 = t116 * t257 + t132 * t255 + t153 * t253 + t178 * t252;
    const real_t t275 = TB_C(16.62768775266122) * TB_EPSILON;
    const real_t t276 = t52 * t52 + t70 * t70 + t82 * t82 + t87 * t87 + t92 * t92;
    const real_t t277 = TB_C(1e-18) * (t276 + t105 * t105 + t110 * t110 + t115 * t115);
    const bool t278 = t274 + t208 * t251 + t243 * t250 <= t275 * t275 + t277;
    const real_t found_0 = t278 ? TB_C(1.0) : TB_C(0.0);
    const bool t279 = TB_C(0.0001) < t49 && TB_C(0.0001) < t67 && TB_C(0.0001) < t79;
    const bool t280 = t279 && TB_C(0.0001) < t84 && TB_C(0.0001) < t89 && TB_C(0.0001) < t102;
    const bool t281 = t280 && TB_C(0.0001) < t107 && TB_C(0.0001) < t112;
    const bool t282 = !t281;
    const real_t t283 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t284 = t283 < t118 && t283 < t136 && t283 < t157 && t283 < t183;
    const bool t285 = !(t284 && t283 < t213 && t283 < t249);
    if (t282 || t285) {
        estimate[0] = TB_C(0.0);
        estimate[1] = TB_C(0.0);
        estimate[2] = TB_C(0.0);
        estimate[3] = TB_C(0.0);
        estimate[4] = TB_C(0.0);
        estimate[5] = TB_C(0.0);
        found[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    estimate[0] = estimate_0;
    estimate[1] = estimate_1;
    estimate[2] = estimate_2;
    estimate[3] = estimate_3;
    estimate[4] = estimate_4;
    estimate[5] = estimate_5;
    found[0] = found_0;
    return TB_OK;
}

/* Everything at the last estimate. */
static tb_status tb_locate_finish(const real_t lengths[8], const real_t rails[1],
    const real_t length_rates[8], const real_t rail_rates[1], const real_t estimate[6],
    real_t pose[6], real_t residual[1], real_t structure[48], real_t velocity[6])
{
    (void)rails;
    (void)rail_rates;
    const real_t t0 = estimate[3] * estimate[3] + estimate[4] * estimate[4];
    const real_t t1 = (t0 + estimate[5] * estimate[5]) * TB_C(0.25);
    const real_t t2 = TB_C(6.446950284384474e-26) + t1 * -TB_C(9.183689863795546e-29);
    const real_t t3 = TB_C(1.9572941063391263e-20) + t1 * (-TB_C(3.8681701706306835e-23) + t1 *
        t2);
    const real_t t4 = TB_C(2.8114572543455206e-15) + t1 * (-TB_C(8.22063524662433e-18) + t1 *
        t3);
    const real_t t5 = TB_C(1.6059043836821613e-10) + t1 * (-TB_C(7.647163731819816e-13) + t1 *
        t4);
    const real_t t6 = TB_C(2.7557319223985893e-06) + t1 * (-TB_C(2.505210838544172e-08) + t1 *
        t5);
    const real_t t7 = TB_C(0.008333333333333333) + t1 * (-TB_C(0.0001984126984126984) + t1 *
        t6);
    const real_t t8 = TB_C(1.0) + t1 * (-TB_C(0.16666666666666666) + t1 * t7);
    const real_t t9 = t8 * TB_C(0.5);
    const real_t t10 = estimate[3] * t9;
    const real_t t11 = estimate[4] * t9;
    const real_t t12 = t10 * t11;
    const real_t t13 = -TB_C(2.4795962632247972e-27) + t1 * TB_C(3.279889237069838e-30);
    const real_t t14 = -TB_C(8.896791392450574e-22) + t1 * (TB_C(1.6117375710961184e-24) + t1 *
        t13);
    const real_t t15 = -TB_C(1.5619206968586225e-16) + t1 * (TB_C(4.110317623312165e-19) + t1 *
        t14);
    const real_t t16 = -TB_C(1.1470745597729725e-11) + t1 * (TB_C(4.779477332387385e-14) + t1 *
        t15);
    const real_t t17 = -TB_C(2.755731922398589e-07) + t1 * (TB_C(2.08767569878681e-09) + t1 *
        t16);
    const real_t t18 = -TB_C(0.001388888888888889) + t1 * (TB_C(2.48015873015873e-05) + t1 *
        t17);
    const real_t t19 = -TB_C(0.5) + t1 * (TB_C(0.041666666666666664) + t1 * t18);
    const real_t t20 = TB_C(1.0) + t1 * t19;
    const real_t t21 = estimate[5] * t9;
    const real_t t22 = t20 * t21;
    const real_t t23 = t12 - t22;
    const real_t t24 = t10 * t21;
    const real_t t25 = t11 * t20;
    const real_t t26 = t24 + t25;
    const real_t t27 = TB_C(0.08) * t26;
    const real_t t28 = -TB_C(0.12) * t23 + t27;
    const real_t t29 = estimate[0] + t28;
    const real_t t30 = t11 * t11;
    const real_t t31 = t10 * t10;
    const real_t t32 = t21 * t21;
    const real_t t33 = t20 * t20 - (t30 + t31 + t32);
    const real_t t34 = TB_C(2.0) * t30 + t33;
    const real_t t35 = t11 * t21;
    const real_t t36 = t10 * t20;
    const real_t t37 = t35 - t36;
    const real_t t38 = TB_C(0.08) * t37;
    const real_t t39 = -TB_C(0.06) * t34 + t38;
    const real_t t40 = estimate[1] + t39;
    const real_t t41 = t40 * t40;
    const real_t t42 = t35 + t36;
    const real_t t43 = t33 + TB_C(2.0) * t32;
    const real_t t44 = TB_C(0.04) * t43;
    const real_t t45 = -TB_C(0.12) * t42 + t44;
    const real_t t46 = estimate[2] + t45;
    const real_t t47 = t46 * t46;
    const real_t t48 = TB_SQRT(t29 * t29 + t41 + t47);
    /* what the lengths disagree by: slack, an encoder fault */
    const real_t misfit_0 = lengths[0] - t48;
    const real_t t49 = t33 + TB_C(2.0) * t31;
    const real_t t50 = t26 * -TB_C(0.08);
    const real_t t51 = -TB_C(0.06) * t49 + t50;
    const real_t t52 = estimate[0] + t51;
    const real_t t53 = t52 * t52;
    const real_t t54 = t12 + t22;
    const real_t t55 = t37 * -TB_C(0.08);
    const real_t t56 = -TB_C(0.12) * t54 + t55;
    const real_t t57 = estimate[1] + t56;
    const real_t t58 = t24 - t25;
    const real_t t59 = t43 * -TB_C(0.04);
    const real_t t60 = -TB_C(0.12) * t58 + t59;
    const real_t t61 = TB_FRAME - (estimate[2] + t60);
    const real_t t62 = t61 * t61;
    const real_t t63 = TB_SQRT(t53 + t57 * t57 + t62);
    const real_t misfit_1 = lengths[1] - t63;
    const real_t t64 = t27 + t23 * TB_C(0.12);
    const real_t t65 = estimate[0] + t64;
    const real_t t66 = t38 + t34 * TB_C(0.06);
    const real_t t67 = TB_FRAME - (estimate[1] + t66);
    const real_t t68 = t67 * t67;
    const real_t t69 = t44 + t42 * TB_C(0.12);
    const real_t t70 = estimate[2] + t69;
    const real_t t71 = t70 * t70;
    const real_t t72 = TB_SQRT(t65 * t65 + t68 + t71);
    const real_t misfit_2 = lengths[2] - t72;
    const real_t t73 = misfit_0 * misfit_0 + misfit_1 * misfit_1 + misfit_2 * misfit_2;
    const real_t t74 = TB_FRAME - t57;
    const real_t t75 = TB_SQRT(t62 + (t53 + t74 * t74));
    const real_t misfit_3 = lengths[3] - t75;
    const real_t t76 = TB_FRAME - t29;
    const real_t t77 = TB_SQRT(t47 + (t41 + t76 * t76));
    const real_t misfit_4 = lengths[4] - t77;
    const real_t t78 = t50 + t49 * TB_C(0.06);
    const real_t t79 = TB_FRAME - (estimate[0] + t78);
    const real_t t80 = t79 * t79;
    const real_t t81 = t55 + t54 * TB_C(0.12);
    const real_t t82 = estimate[1] + t81;
    const real_t t83 = t59 + t58 * TB_C(0.12);
    const real_t t84 = TB_FRAME - (estimate[2] + t83);
    const real_t t85 = t84 * t84;
    const real_t t86 = TB_SQRT(t80 + t82 * t82 + t85);
    const real_t misfit_5 = lengths[5] - t86;
    const real_t t87 = t73 + misfit_3 * misfit_3 + misfit_4 * misfit_4 + misfit_5 * misfit_5;
    const real_t t88 = TB_FRAME - t65;
    const real_t t89 = TB_SQRT(t71 + (t68 + t88 * t88));
    const real_t misfit_6 = lengths[6] - t89;
    const real_t t90 = TB_FRAME - t82;
    const real_t t91 = TB_SQRT(t85 + (t80 + t90 * t90));
    const real_t misfit_7 = lengths[7] - t91;
    const real_t residual_0 = TB_SQRT(t87 + misfit_6 * misfit_6 + misfit_7 * misfit_7);
    const real_t t92 = TB_C(1.0) / t48;
    const real_t t93 = t29 * t92;
    const real_t structure_0 = -t93;
    const real_t t94 = TB_C(1.0) / t63;
    const real_t t95 = t52 * t94;
    const real_t structure_1 = -t95;
    const real_t t96 = TB_C(1.0) / t72;
    const real_t t97 = t65 * t96;
    const real_t structure_2 = -t97;
    const real_t t98 = TB_C(1.0) / t75;
    const real_t t99 = t52 * t98;
    const real_t structure_3 = -t99;
    const real_t t100 = TB_C(1.0) / t77;
    const real_t structure_4 = t76 * t100;
    const real_t t101 = TB_C(1.0) / t86;
    const real_t structure_5 = t79 * t101;
    const real_t t102 = TB_C(1.0) / t89;
    const real_t structure_6 = t88 * t102;
    const real_t t103 = TB_C(1.0) / t91;
    const real_t structure_7 = t79 * t103;
    const real_t t104 = t40 * t92;
    const real_t structure_8 = -t104;
    const real_t t105 = t57 * t94;
    const real_t structure_9 = -t105;
    const real_t structure_10 = t67 * t96;
    const real_t structure_11 = t74 * t98;
    const real_t t106 = t40 * t100;
    const real_t structure_12 = -t106;
    const real_t t107 = t82 * t101;
    const real_t structure_13 = -t107;
    const real_t structure_14 = t67 * t102;
    const real_t structure_15 = t90 * t103;
    const real_t t108 = t46 * t92;
    const real_t structure_16 = -t108;
    const real_t structure_17 = t61 * t94;
    const real_t t109 = t70 * t96;
    const real_t structure_18 = -t109;
    const real_t structure_19 = t61 * t98;
    const real_t t110 = t46 * t100;
    const real_t structure_20 = -t110;
    const real_t structure_21 = t84 * t101;
    const real_t t111 = t70 * t102;
    const real_t structure_22 = -t111;
    const real_t structure_23 = t84 * t103;
    const real_t structure_24 = t45 * t104 - t39 * t108;
    const real_t structure_25 = t60 * t105 + t56 * structure_17;
    const real_t t112 = t69 * structure_10 + t66 * t109;
    const real_t structure_26 = -t112;
    const real_t structure_27 = t56 * structure_19 - t60 * structure_11;
    const real_t structure_28 = t45 * t106 - t39 * t110;
    const real_t structure_29 = t83 * t107 + t81 * structure_21;
    const real_t t113 = t69 * structure_14 + t66 * t111;
    const real_t structure_30 = -t113;
    const real_t structure_31 = t81 * structure_23 - t83 * structure_15;
    const real_t structure_32 = t28 * t108 - t45 * t93;
    const real_t t114 = t60 * t95 + t51 * structure_17;
    const real_t structure_33 = -t114;
    const real_t structure_34 = t64 * t109 - t69 * t97;
    const real_t t115 = t60 * t99 + t51 * structure_19;
    const real_t structure_35 = -t115;
    const real_t structure_36 = t45 * structure_4 + t28 * t110;
    const real_t structure_37 = t83 * structure_5 - t78 * structure_21;
    const real_t structure_38 = t69 * structure_6 + t64 * t111;
    const real_t structure_39 = t83 * structure_7 - t78 * structure_23;
    const real_t structure_40 = t39 * t93 - t28 * t104;
    const real_t structure_41 = t56 * t95 - t51 * t105;
    const real_t structure_42 = t66 * t97 + t64 * structure_10;
    const real_t structure_43 = t56 * t99 + t51 * structure_11;
    const real_t t116 = t39 * structure_4 + t28 * t106;
    const real_t structure_44 = -t116;
    const real_t t117 = t81 * structure_5 + t78 * t107;
    const real_t structure_45 = -t117;
    const real_t structure_46 = t64 * structure_14 - t66 * structure_6;
    const real_t structure_47 = t78 * structure_15 - t81 * structure_7;
    const real_t t118 = t93 * length_rates[0] + t95 * length_rates[1] + t97 * length_rates[2];
    const real_t t119 = structure_4 * length_rates[4] - (t118 + t99 * length_rates[3]);
    const real_t t120 = t119 + structure_5 * length_rates[5] + structure_6 * length_rates[6];
    const real_t t121 = t120 + structure_7 * length_rates[7];
    const real_t t122 = t93 * t93 + t95 * t95 + t97 * t97 + t99 * t99 + structure_4 *
        structure_4;
    const real_t t123 = t122 + structure_5 * structure_5 + structure_6 * structure_6;
    const real_t t124 = t123 + structure_7 * structure_7;
    const real_t t125 = TB_C(1.0) / t124;
    const real_t t126 = t93 * t104 + t95 * t105 - t97 * structure_10 - t99 * structure_11;
    const real_t t127 = t126 - structure_4 * t106 - structure_5 * t107 + structure_6 *
        structure_14;
    const real_t t128 = t125 * (t127 + structure_7 * structure_15);
    const real_t t129 = structure_10 * length_rates[2] - (t104 * length_rates[0] + t105 *
        length_rates[1]);
    const real_t t130 = t129 + structure_11 * length_rates[3] - t106 * length_rates[4];
    const real_t t131 = t130 - t107 * length_rates[5] + structure_14 * length_rates[6];
    const real_t t132 = t121 * t128 - (t131 + structure_15 * length_rates[7]);
    const real_t t133 = t104 * t104 + t105 * t105 + structure_10 * structure_10;
    const real_t t134 = t133 + structure_11 * structure_11 + t106 * t106 + t107 * t107;
    const real_t t135 = t134 + structure_14 * structure_14 + structure_15 * structure_15;
    const real_t t136 = t135 - t124 * (t128 * t128);
    const real_t t137 = TB_C(1.0) / t136;
    const real_t t138 = t104 * t108 - t105 * structure_17 - structure_10 * t109;
    const real_t t139 = t138 + structure_11 * structure_19 + t106 * t110 - t107 * structure_21;
    const real_t t140 = t139 - structure_14 * t111 + structure_15 * structure_23;
    const real_t t141 = t93 * t108 - t95 * structure_17 + t97 * t109 - t99 * structure_19;
    const real_t t142 = t141 - structure_4 * t110 + structure_5 * structure_21;
    const real_t t143 = t142 - structure_6 * t111 + structure_7 * structure_23;
    const real_t t144 = t125 * t143;
    const real_t t145 = t137 * (t140 - t124 * (t128 * t144));
    const real_t t146 = structure_17 * length_rates[1] - t108 * length_rates[0];
    const real_t t147 = t146 - t109 * length_rates[2] + structure_19 * length_rates[3];
    const real_t t148 = t147 - t110 * length_rates[4] + structure_21 * length_rates[5];
    const real_t t149 = t148 - t111 * length_rates[6] + structure_23 * length_rates[7];
    const real_t t150 = t121 * t144 - t149 - t132 * t145;
    const real_t t151 = t108 * t108 + structure_17 * structure_17 + t109 * t109;
    const real_t t152 = t151 + structure_19 * structure_19 + t110 * t110 + structure_21 *
        structure_21;
    const real_t t153 = t152 + t111 * t111 + structure_23 * structure_23 - t124 * (t144 * t144);
    const real_t t154 = t153 - t136 * (t145 * t145);
    const real_t t155 = TB_C(1.0) / t154;
    const real_t t156 = structure_25 * TB_MOMENT_WEIGHT;
    const real_t t157 = structure_24 * TB_MOMENT_WEIGHT;
    const real_t t158 = t112 * TB_MOMENT_WEIGHT;
    const real_t t159 = structure_27 * TB_MOMENT_WEIGHT;
    const real_t t160 = structure_17 * t156 - t108 * t157 + t109 * t158 + structure_19 * t159;
    const real_t t161 = structure_28 * TB_MOMENT_WEIGHT;
    const real_t t162 = structure_29 * TB_MOMENT_WEIGHT;
    const real_t t163 = t113 * TB_MOMENT_WEIGHT;
    const real_t t164 = t160 - t110 * t161 + structure_21 * t162 + t111 * t163;
    const real_t t165 = structure_31 * TB_MOMENT_WEIGHT;
    const real_t t166 = t97 * t158 - (t93 * t157 + t95 * t156) - t99 * t159;
    const real_t t167 = t166 + structure_4 * t161 + structure_5 * t162 - structure_6 * t163;
    const real_t t168 = t125 * (t167 + structure_7 * t165);
    const real_t t169 = t164 + structure_23 * t165 - t124 * (t144 * t168);
    const real_t t170 = structure_11 * t159 - (t104 * t157 + t105 * t156 + structure_10 * t158);
    const real_t t171 = t170 - t106 * t161 - t107 * t162 - structure_14 * t163;
    const real_t t172 = t171 + structure_15 * t165 - t124 * (t128 * t168);
    const real_t t173 = t137 * t172;
    const real_t t174 = t155 * (t169 - t136 * (t145 * t173));
    const real_t t175 = length_rates[0] * t157 + length_rates[1] * t156 - length_rates[2] *
        t158;
    const real_t t176 = t175 + length_rates[3] * t159 + length_rates[4] * t161;
    const real_t t177 = t176 + length_rates[5] * t162 - length_rates[6] * t163;
    const real_t t178 = t121 * t168 - (t177 + length_rates[7] * t165) - t132 * t173;
    const real_t t179 = t178 - t150 * t174;
    const real_t t180 = t157 * t157 + t156 * t156 + t158 * t158 + t159 * t159;
    const real_t t181 = t180 + t161 * t161 + t162 * t162 + t163 * t163 + t165 * t165;
    const real_t t182 = t181 - t124 * (t168 * t168) - t136 * (t173 * t173);
    const real_t t183 = t182 - t154 * (t174 * t174);
    const real_t t184 = TB_C(1.0) / t183;
    const real_t t185 = structure_32 * TB_MOMENT_WEIGHT;
    const real_t t186 = t114 * TB_MOMENT_WEIGHT;
    const real_t t187 = structure_34 * TB_MOMENT_WEIGHT;
    const real_t t188 = t115 * TB_MOMENT_WEIGHT;
    const real_t t189 = t157 * t185 - t156 * t186 - t158 * t187 - t159 * t188;
    const real_t t190 = structure_36 * TB_MOMENT_WEIGHT;
    const real_t t191 = structure_37 * TB_MOMENT_WEIGHT;
    const real_t t192 = structure_38 * TB_MOMENT_WEIGHT;
    const real_t t193 = structure_39 * TB_MOMENT_WEIGHT;
    const real_t t194 = t189 + t161 * t190 + t162 * t191 - t163 * t192 + t165 * t193;
    const real_t t195 = t95 * t186 - t93 * t185 - t97 * t187 + t99 * t188;
    const real_t t196 = t195 + structure_4 * t190 + structure_5 * t191 + structure_6 * t192;
    const real_t t197 = t125 * (t196 + structure_7 * t193);
    const real_t t198 = t105 * t186 - t104 * t185 + structure_10 * t187 - structure_11 * t188;
    const real_t t199 = t198 - t106 * t190 - t107 * t191 + structure_14 * t192;
    const real_t t200 = t199 + structure_15 * t193 - t124 * (t128 * t197);
    const real_t t201 = t137 * t200;
    const real_t t202 = t194 - t124 * (t168 * t197) - t136 * (t173 * t201);
    const real_t t203 = t108 * t185 + structure_17 * t186 + t109 * t187 + structure_19 * t188;
    const real_t t204 = structure_21 * t191 - (t203 + t110 * t190) - t111 * t192;
    const real_t t205 = t204 + structure_23 * t193 - t124 * (t144 * t197);
    const real_t t206 = t155 * (t205 - t136 * (t145 * t201));
    const real_t t207 = t184 * (t202 - t154 * (t174 * t206));
    const real_t t208 = length_rates[0] * t185 - length_rates[1] * t186 + length_rates[2] *
        t187;
    const real_t t209 = t208 - length_rates[3] * t188 + length_rates[4] * t190;
    const real_t t210 = t209 + length_rates[5] * t191 + length_rates[6] * t192;
    const real_t t211 = t121 * t197 - (t210 + length_rates[7] * t193) - t132 * t201;
    const real_t t212 = t211 - t150 * t206 - t179 * t207;
    const real_t t213 = t185 * t185 + t186 * t186 + t187 * t187 + t188 * t188;
    const real_t t214 = t213 + t190 * t190 + t191 * t191 + t192 * t192 + t193 * t193;
    const real_t t215 = t214 - t124 * (t197 * t197) - t136 * (t201 * t201);
    const real_t t216 = t215 - t154 * (t206 * t206) - t183 * (t207 * t207);
    const real_t t217 = TB_C(1.0) / t216;
    const real_t t218 = structure_40 * TB_MOMENT_WEIGHT;
    const real_t t219 = structure_41 * TB_MOMENT_WEIGHT;
    const real_t t220 = structure_42 * TB_MOMENT_WEIGHT;
    const real_t t221 = structure_43 * TB_MOMENT_WEIGHT;
    const real_t t222 = t185 * t218 - t186 * t219 + t187 * t220 - t188 * t221;
    const real_t t223 = t116 * TB_MOMENT_WEIGHT;
    const real_t t224 = t117 * TB_MOMENT_WEIGHT;
    const real_t t225 = structure_46 * TB_MOMENT_WEIGHT;
    const real_t t226 = structure_47 * TB_MOMENT_WEIGHT;
    const real_t t227 = t222 - t190 * t223 - t191 * t224 + t192 * t225 + t193 * t226;
    const real_t t228 = t93 * t218 + t95 * t219 + t97 * t220 + t99 * t221;
    const real_t t229 = structure_6 * t225 - (t228 + structure_4 * t223 + structure_5 * t224);
    const real_t t230 = t125 * (t229 + structure_7 * t226);
    const real_t t231 = structure_10 * t220 - (t104 * t218 + t105 * t219);
    const real_t t232 = t231 + structure_11 * t221 + t106 * t223 + t107 * t224;
    const real_t t233 = t232 + structure_14 * t225 + structure_15 * t226 - t124 * (t128 * t230);
    const real_t t234 = t137 * t233;
    const real_t t235 = t227 - t124 * (t197 * t230) - t136 * (t201 * t234);
    const real_t t236 = structure_17 * t219 - t108 * t218 - t109 * t220 + structure_19 * t221;
    const real_t t237 = t236 + t110 * t223 - structure_21 * t224 - t111 * t225;
    const real_t t238 = t237 + structure_23 * t226 - t124 * (t144 * t230);
    const real_t t239 = t155 * (t238 - t136 * (t145 * t234));
    const real_t t240 = t157 * t218 + t156 * t219 - t158 * t220 + t159 * t221;
    const real_t t241 = t240 - t161 * t223 - t162 * t224 - t163 * t225 + t165 * t226;
    const real_t t242 = t241 - t124 * (t168 * t230) - t136 * (t173 * t234);
    const real_t t243 = t184 * (t242 - t154 * (t174 * t239));
    const real_t t244 = t235 - t154 * (t206 * t239) - t183 * (t207 * t243);
    const real_t t245 = t217 * t244;
    const real_t t246 = length_rates[0] * t218 + length_rates[1] * t219 + length_rates[2] *
        t220;
    const real_t t247 = t246 + length_rates[3] * t221 - length_rates[4] * t223;
    const real_t t248 = t247 - length_rates[5] * t224 + length_rates[6] * t225;
    const real_t t249 = t121 * t230 - (t248 + length_rates[7] * t226) - t132 * t234;
    const real_t t250 = t218 * t218 + t219 * t219 + t220 * t220 + t221 * t221;
    const real_t t251 = t250 + t223 * t223 + t224 * t224 + t225 * t225 + t226 * t226;
    const real_t t252 = t251 - t124 * (t230 * t230) - t136 * (t234 * t234);
    const real_t t253 = t252 - t154 * (t239 * t239) - t183 * (t243 * t243);
    const real_t t254 = t253 - t216 * (t245 * t245);
    const real_t t255 = (t249 - t150 * t239 - t179 * t243 - t212 * t245) / t254;
    const real_t t256 = t212 * t217 - t245 * t255;
    const real_t t257 = t179 * t184 - t207 * t256 - t243 * t255;
    const real_t velocity_2 = t150 * t155 - t174 * t257 - t206 * t256 - t239 * t255;
    const real_t t258 = t132 * t137 - t145 * velocity_2 - t173 * t257 - t201 * t256;
    const real_t velocity_1 = t258 - t234 * t255;
    const real_t t259 = t121 * t125 + t128 * velocity_1 + t144 * velocity_2;
    const real_t velocity_0 = -(t259 + t168 * t257 + t197 * t256 + t230 * t255);
    const real_t velocity_3 = TB_MOMENT_WEIGHT * t257;
    const real_t velocity_4 = TB_MOMENT_WEIGHT * t256;
    const real_t velocity_5 = TB_MOMENT_WEIGHT * t255;
    const bool t260 = TB_C(0.0001) < t48 && TB_C(0.0001) < t63 && TB_C(0.0001) < t72;
    const bool t261 = t260 && TB_C(0.0001) < t75 && TB_C(0.0001) < t77 && TB_C(0.0001) < t86;
    const bool t262 = !(t261 && TB_C(0.0001) < t89 && TB_C(0.0001) < t91);
    const real_t t263 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const bool t264 = t263 < t124 && t263 < t136 && t263 < t154 && t263 < t183;
    const bool t265 = !(t264 && t263 < t216 && t263 < t254);
    if (t262 || t265) {
        pose[0] = TB_C(0.0);
        pose[1] = TB_C(0.0);
        pose[2] = TB_C(0.0);
        pose[3] = TB_C(0.0);
        pose[4] = TB_C(0.0);
        pose[5] = TB_C(0.0);
        residual[0] = TB_C(0.0);
        structure[0] = TB_C(0.0);
        structure[1] = TB_C(0.0);
        structure[2] = TB_C(0.0);
        structure[3] = TB_C(0.0);
        structure[4] = TB_C(0.0);
        structure[5] = TB_C(0.0);
        structure[6] = TB_C(0.0);
        structure[7] = TB_C(0.0);
        structure[8] = TB_C(0.0);
        structure[9] = TB_C(0.0);
        structure[10] = TB_C(0.0);
        structure[11] = TB_C(0.0);
        structure[12] = TB_C(0.0);
        structure[13] = TB_C(0.0);
        structure[14] = TB_C(0.0);
        structure[15] = TB_C(0.0);
        structure[16] = TB_C(0.0);
        structure[17] = TB_C(0.0);
        structure[18] = TB_C(0.0);
        structure[19] = TB_C(0.0);
        structure[20] = TB_C(0.0);
        structure[21] = TB_C(0.0);
        structure[22] = TB_C(0.0);
        structure[23] = TB_C(0.0);
        structure[24] = TB_C(0.0);
        structure[25] = TB_C(0.0);
        structure[26] = TB_C(0.0);
        structure[27] = TB_C(0.0);
        structure[28] = TB_C(0.0);
        structure[29] = TB_C(0.0);
        structure[30] = TB_C(0.0);
        structure[31] = TB_C(0.0);
        structure[32] = TB_C(0.0);
        structure[33] = TB_C(0.0);
        structure[34] = TB_C(0.0);
        structure[35] = TB_C(0.0);
        structure[36] = TB_C(0.0);
        structure[37] = TB_C(0.0);
        structure[38] = TB_C(0.0);
        structure[39] = TB_C(0.0);
        structure[40] = TB_C(0.0);
        structure[41] = TB_C(0.0);
        structure[42] = TB_C(0.0);
        structure[43] = TB_C(0.0);
        structure[44] = TB_C(0.0);
        structure[45] = TB_C(0.0);
        structure[46] = TB_C(0.0);
        structure[47] = TB_C(0.0);
        velocity[0] = TB_C(0.0);
        velocity[1] = TB_C(0.0);
        velocity[2] = TB_C(0.0);
        velocity[3] = TB_C(0.0);
        velocity[4] = TB_C(0.0);
        velocity[5] = TB_C(0.0);
        return TB_SINGULAR;
    }
    pose[0] = estimate[0];
    pose[1] = estimate[1];
    pose[2] = estimate[2];
    pose[3] = estimate[3];
    pose[4] = estimate[4];
    pose[5] = estimate[5];
    residual[0] = residual_0;
    structure[0] = structure_0;
    structure[1] = structure_1;
    structure[2] = structure_2;
    structure[3] = structure_3;
    structure[4] = structure_4;
    structure[5] = structure_5;
    structure[6] = structure_6;
    structure[7] = structure_7;
    structure[8] = structure_8;
    structure[9] = structure_9;
    structure[10] = structure_10;
    structure[11] = structure_11;
    structure[12] = structure_12;
    structure[13] = structure_13;
    structure[14] = structure_14;
    structure[15] = structure_15;
    structure[16] = structure_16;
    structure[17] = structure_17;
    structure[18] = structure_18;
    structure[19] = structure_19;
    structure[20] = structure_20;
    structure[21] = structure_21;
    structure[22] = structure_22;
    structure[23] = structure_23;
    structure[24] = structure_24;
    structure[25] = structure_25;
    structure[26] = structure_26;
    structure[27] = structure_27;
    structure[28] = structure_28;
    structure[29] = structure_29;
    structure[30] = structure_30;
    structure[31] = structure_31;
    structure[32] = structure_32;
    structure[33] = structure_33;
    structure[34] = structure_34;
    structure[35] = structure_35;
    structure[36] = structure_36;
    structure[37] = structure_37;
    structure[38] = structure_38;
    structure[39] = structure_39;
    structure[40] = structure_40;
    structure[41] = structure_41;
    structure[42] = structure_42;
    structure[43] = structure_43;
    structure[44] = structure_44;
    structure[45] = structure_45;
    structure[46] = structure_46;
    structure[47] = structure_47;
    velocity[0] = velocity_0;
    velocity[1] = velocity_1;
    velocity[2] = velocity_2;
    velocity[3] = velocity_3;
    velocity[4] = velocity_4;
    velocity[5] = velocity_5;
    return TB_OK;
}

tb_status tb_locate(const real_t guess[6], const real_t lengths[8], const real_t rails[1],
    const real_t length_rates[8], const real_t rail_rates[1], real_t pose[6],
    real_t residual[1], real_t structure[48], real_t velocity[6])
{
    real_t estimate[6];
    real_t found[1] = {TB_C(0.0)};
    tb_status status = tb_locate_begin(guess, lengths, rails, length_rates, rail_rates,
        estimate);
    for (int steps = 0; steps < 16 && status == TB_OK && !(found[0] > TB_C(0.0)); steps++) {
        status = tb_locate_step(lengths, rails, estimate, found);
    }
    if (status == TB_OK && !(found[0] > TB_C(0.0))) {
        status = TB_INACCURATE;
    }
    if (status != TB_OK) {
        pose[0] = TB_C(0.0);
        pose[1] = TB_C(0.0);
        pose[2] = TB_C(0.0);
        pose[3] = TB_C(0.0);
        pose[4] = TB_C(0.0);
        pose[5] = TB_C(0.0);
        residual[0] = TB_C(0.0);
        structure[0] = TB_C(0.0);
        structure[1] = TB_C(0.0);
        structure[2] = TB_C(0.0);
        structure[3] = TB_C(0.0);
        structure[4] = TB_C(0.0);
        structure[5] = TB_C(0.0);
        structure[6] = TB_C(0.0);
        structure[7] = TB_C(0.0);
        structure[8] = TB_C(0.0);
        structure[9] = TB_C(0.0);
        structure[10] = TB_C(0.0);
        structure[11] = TB_C(0.0);
        structure[12] = TB_C(0.0);
        structure[13] = TB_C(0.0);
        structure[14] = TB_C(0.0);
        structure[15] = TB_C(0.0);
        structure[16] = TB_C(0.0);
        structure[17] = TB_C(0.0);
        structure[18] = TB_C(0.0);
        structure[19] = TB_C(0.0);
        structure[20] = TB_C(0.0);
        structure[21] = TB_C(0.0);
        structure[22] = TB_C(0.0);
        structure[23] = TB_C(0.0);
        structure[24] = TB_C(0.0);
        structure[25] = TB_C(0.0);
        structure[26] = TB_C(0.0);
        structure[27] = TB_C(0.0);
        structure[28] = TB_C(0.0);
        structure[29] = TB_C(0.0);
        structure[30] = TB_C(0.0);
        structure[31] = TB_C(0.0);
        structure[32] = TB_C(0.0);
        structure[33] = TB_C(0.0);
        structure[34] = TB_C(0.0);
        structure[35] = TB_C(0.0);
        structure[36] = TB_C(0.0);
        structure[37] = TB_C(0.0);
        structure[38] = TB_C(0.0);
        structure[39] = TB_C(0.0);
        structure[40] = TB_C(0.0);
        structure[41] = TB_C(0.0);
        structure[42] = TB_C(0.0);
        structure[43] = TB_C(0.0);
        structure[44] = TB_C(0.0);
        structure[45] = TB_C(0.0);
        structure[46] = TB_C(0.0);
        structure[47] = TB_C(0.0);
        velocity[0] = TB_C(0.0);
        velocity[1] = TB_C(0.0);
        velocity[2] = TB_C(0.0);
        velocity[3] = TB_C(0.0);
        velocity[4] = TB_C(0.0);
        velocity[5] = TB_C(0.0);
        return status;
    }
    return tb_locate_finish(lengths, rails, length_rates, rail_rates, estimate, pose, residual,
        structure, velocity);
}

