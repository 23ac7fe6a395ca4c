/* Regenerate: turnbuckle generate machines/planar_rigid.toml --out <this folder>
 * Machine 95fa38e7104ced7a, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_kinematics.h"
#include "tb_machine.h"

tb_status tb_base_points(const real_t rails[6], real_t points[12])
{
    if (!(TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) +
              TB_ABS(rails[4]) + TB_ABS(rails[5]) <= TB_C(8.541599999999999))) {
        points[0] = TB_C(0.0);
        points[1] = TB_C(0.0);
        points[2] = TB_C(0.0);
        points[3] = TB_C(0.0);
        points[4] = TB_C(0.0);
        points[5] = TB_C(0.0);
        points[6] = TB_C(0.0);
        points[7] = TB_C(0.0);
        points[8] = TB_C(0.0);
        points[9] = TB_C(0.0);
        points[10] = TB_C(0.0);
        points[11] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    points[0] = rails[0];
    points[1] = TB_C(0.0);
    points[2] = rails[1];
    points[3] = TB_C(0.0);
    points[4] = TB_FRAME_X;
    points[5] = rails[2];
    points[6] = rails[3];
    points[7] = TB_FRAME_Y;
    points[8] = rails[4];
    points[9] = TB_FRAME_Y;
    points[10] = TB_C(0.0);
    points[11] = rails[5];
    return TB_OK;
}

tb_status tb_cable_vectors(const real_t pose[3], const real_t rails[6], real_t vectors[12])
{
    if (!(pose[0] >= -TB_C(1.4236) && pose[0] <= TB_C(1.4236)
          && pose[1] >= -TB_C(1.4236) && pose[1] <= TB_C(1.4236)
          && pose[2] >= -TB_C(1.2853981633974483) && pose[2] <= TB_C(1.2853981633974483)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) +
              TB_ABS(rails[4]) + TB_ABS(rails[5]) <= TB_C(8.541599999999999))) {
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
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = pose[2] * pose[2] * TB_C(0.25);
    const real_t t1 = -TB_C(2.4795962632247972e-27) + t0 * TB_C(3.279889237069838e-30);
    const real_t t2 = -TB_C(8.896791392450574e-22) + t0 * (TB_C(1.6117375710961184e-24) + t0 *
        t1);
    const real_t t3 = -TB_C(1.5619206968586225e-16) + t0 * (TB_C(4.110317623312165e-19) + t0 *
        t2);
    const real_t t4 = -TB_C(1.1470745597729725e-11) + t0 * (TB_C(4.779477332387385e-14) + t0 *
        t3);
    const real_t t5 = -TB_C(2.755731922398589e-07) + t0 * (TB_C(2.08767569878681e-09) + t0 *
        t4);
    const real_t t6 = -TB_C(0.001388888888888889) + t0 * (TB_C(2.48015873015873e-05) + t0 * t5);
    const real_t t7 = -TB_C(0.5) + t0 * (TB_C(0.041666666666666664) + t0 * t6);
    const real_t t8 = TB_C(1.0) + t0 * t7;
    const real_t t9 = TB_C(6.446950284384474e-26) + t0 * -TB_C(9.183689863795546e-29);
    const real_t t10 = TB_C(1.9572941063391263e-20) + t0 * (-TB_C(3.8681701706306835e-23) + t0
        * t9);
    const real_t t11 = TB_C(2.8114572543455206e-15) + t0 * (-TB_C(8.22063524662433e-18) + t0 *
        t10);
    const real_t t12 = TB_C(1.6059043836821613e-10) + t0 * (-TB_C(7.647163731819816e-13) + t0 *
        t11);
    const real_t t13 = TB_C(2.7557319223985893e-06) + t0 * (-TB_C(2.505210838544172e-08) + t0 *
        t12);
    const real_t t14 = TB_C(0.008333333333333333) + t0 * (-TB_C(0.0001984126984126984) + t0 *
        t13);
    const real_t t15 = TB_C(1.0) + t0 * (-TB_C(0.16666666666666666) + t0 * t14);
    const real_t t16 = pose[2] * (t15 * TB_C(0.5));
    const real_t t17 = t8 * t8 - t16 * t16;
    const real_t t18 = -TB_C(0.04) * t17;
    const real_t t19 = t16 * (t8 * TB_C(2.0));
    const real_t t20 = -TB_C(0.025) * t19;
    /* R p_i, from the platform's centre to its anchors */
    const real_t arm_0 = t18 - t20;
    const real_t vectors_0 = rails[0] - (pose[0] + arm_0);
    const real_t t21 = -TB_C(0.04) * t19;
    const real_t t22 = t17 * -TB_C(0.025);
    const real_t arm_1 = t21 + t22;
    const real_t vectors_1 = -(pose[1] + arm_1);
    const real_t t23 = t17 * TB_C(0.04);
    const real_t arm_2 = t23 - t20;
    const real_t vectors_2 = rails[1] - (pose[0] + arm_2);
    const real_t t24 = t19 * TB_C(0.04);
    const real_t arm_3 = t22 + t24;
    const real_t vectors_3 = -(pose[1] + arm_3);
    const real_t arm_4 = t17 * TB_LONGEST_ARM;
    const real_t vectors_4 = TB_FRAME_X - (pose[0] + arm_4);
    const real_t arm_5 = t19 * TB_LONGEST_ARM;
    const real_t vectors_5 = rails[2] - (pose[1] + arm_5);
    const real_t t25 = t19 * TB_C(0.025);
    const real_t arm_6 = t23 - t25;
    const real_t vectors_6 = rails[3] - (pose[0] + arm_6);
    const real_t t26 = t17 * TB_C(0.025);
    const real_t arm_7 = t24 + t26;
    const real_t vectors_7 = TB_FRAME_Y - (pose[1] + arm_7);
    const real_t arm_8 = t18 - t25;
    const real_t vectors_8 = rails[4] - (pose[0] + arm_8);
    const real_t arm_9 = t21 + t26;
    const real_t vectors_9 = TB_FRAME_Y - (pose[1] + arm_9);
    const real_t arm_10 = t17 * TB_ANCHOR_6_X;
    const real_t vectors_10 = -(pose[0] + arm_10);
    const real_t arm_11 = t19 * TB_ANCHOR_6_X;
    const real_t vectors_11 = rails[5] - (pose[1] + arm_11);
    vectors[0] = vectors_0;
    vectors[1] = vectors_1;
    vectors[2] = vectors_2;
    vectors[3] = vectors_3;
    vectors[4] = vectors_4;
    vectors[5] = vectors_5;
    vectors[6] = vectors_6;
    vectors[7] = vectors_7;
    vectors[8] = vectors_8;
    vectors[9] = vectors_9;
    vectors[10] = vectors_10;
    vectors[11] = vectors_11;
    return TB_OK;
}

/* Refuses with a status: length is 0 m. */
static tb_status tb_refuse_cable_lengths(tb_status status, real_t length[6])
{
    length[0] = TB_C(0.0);
    length[1] = TB_C(0.0);
    length[2] = TB_C(0.0);
    length[3] = TB_C(0.0);
    length[4] = TB_C(0.0);
    length[5] = TB_C(0.0);
    return status;
}

tb_status tb_cable_lengths(const real_t pose[3], const real_t rails[6], real_t length[6])
{
    if (!(pose[0] >= -TB_C(1.4236) && pose[0] <= TB_C(1.4236)
          && pose[1] >= -TB_C(1.4236) && pose[1] <= TB_C(1.4236)
          && pose[2] >= -TB_C(1.2853981633974483) && pose[2] <= TB_C(1.2853981633974483)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) +
              TB_ABS(rails[4]) + TB_ABS(rails[5]) <= TB_C(8.541599999999999))) {
        return tb_refuse_cable_lengths(TB_OUT_OF_DOMAIN, length);
    }
    const real_t t0 = pose[2] * pose[2] * TB_C(0.25);
    const real_t t1 = -TB_C(2.4795962632247972e-27) + t0 * TB_C(3.279889237069838e-30);
    const real_t t2 = -TB_C(8.896791392450574e-22) + t0 * (TB_C(1.6117375710961184e-24) + t0 *
        t1);
    const real_t t3 = -TB_C(1.5619206968586225e-16) + t0 * (TB_C(4.110317623312165e-19) + t0 *
        t2);
    const real_t t4 = -TB_C(1.1470745597729725e-11) + t0 * (TB_C(4.779477332387385e-14) + t0 *
        t3);
    const real_t t5 = -TB_C(2.755731922398589e-07) + t0 * (TB_C(2.08767569878681e-09) + t0 *
        t4);
    const real_t t6 = -TB_C(0.001388888888888889) + t0 * (TB_C(2.48015873015873e-05) + t0 * t5);
    const real_t t7 = -TB_C(0.5) + t0 * (TB_C(0.041666666666666664) + t0 * t6);
    const real_t t8 = TB_C(1.0) + t0 * t7;
    const real_t t9 = TB_C(6.446950284384474e-26) + t0 * -TB_C(9.183689863795546e-29);
    const real_t t10 = TB_C(1.9572941063391263e-20) + t0 * (-TB_C(3.8681701706306835e-23) + t0
        * t9);
    const real_t t11 = TB_C(2.8114572543455206e-15) + t0 * (-TB_C(8.22063524662433e-18) + t0 *
        t10);
    const real_t t12 = TB_C(1.6059043836821613e-10) + t0 * (-TB_C(7.647163731819816e-13) + t0 *
        t11);
    const real_t t13 = TB_C(2.7557319223985893e-06) + t0 * (-TB_C(2.505210838544172e-08) + t0 *
        t12);
    const real_t t14 = TB_C(0.008333333333333333) + t0 * (-TB_C(0.0001984126984126984) + t0 *
        t13);
    const real_t t15 = TB_C(1.0) + t0 * (-TB_C(0.16666666666666666) + t0 * t14);
    const real_t t16 = pose[2] * (t15 * TB_C(0.5));
    const real_t t17 = t8 * t8 - t16 * t16;
    const real_t t18 = -TB_C(0.04) * t17;
    const real_t t19 = t16 * (t8 * TB_C(2.0));
    const real_t t20 = -TB_C(0.025) * t19;
    /* R p_i, from the platform's centre to its anchors */
    const real_t arm_0 = t18 - t20;
    const real_t t21 = rails[0] - (pose[0] + arm_0);
    const real_t t22 = -TB_C(0.04) * t19;
    const real_t t23 = t17 * -TB_C(0.025);
    const real_t arm_1 = t22 + t23;
    const real_t t24 = pose[1] + arm_1;
    const real_t length_0 = TB_SQRT(t21 * t21 + t24 * t24);
    const real_t t25 = t17 * TB_C(0.04);
    const real_t arm_2 = t25 - t20;
    const real_t t26 = rails[1] - (pose[0] + arm_2);
    const real_t t27 = t19 * TB_C(0.04);
    const real_t arm_3 = t23 + t27;
    const real_t t28 = pose[1] + arm_3;
    const real_t length_1 = TB_SQRT(t26 * t26 + t28 * t28);
    const real_t arm_4 = t17 * TB_LONGEST_ARM;
    const real_t t29 = TB_FRAME_X - (pose[0] + arm_4);
    const real_t arm_5 = t19 * TB_LONGEST_ARM;
    const real_t t30 = rails[2] - (pose[1] + arm_5);
    const real_t length_2 = TB_SQRT(t29 * t29 + t30 * t30);
    const real_t t31 = t19 * TB_C(0.025);
    const real_t arm_6 = t25 - t31;
    const real_t t32 = rails[3] - (pose[0] + arm_6);
    const real_t t33 = t17 * TB_C(0.025);
    const real_t arm_7 = t27 + t33;
    const real_t t34 = TB_FRAME_Y - (pose[1] + arm_7);
    const real_t length_3 = TB_SQRT(t32 * t32 + t34 * t34);
    const real_t arm_8 = t18 - t31;
    const real_t t35 = rails[4] - (pose[0] + arm_8);
    const real_t arm_9 = t22 + t33;
    const real_t t36 = TB_FRAME_Y - (pose[1] + arm_9);
    const real_t length_4 = TB_SQRT(t35 * t35 + t36 * t36);
    const real_t arm_10 = t17 * TB_ANCHOR_6_X;
    const real_t t37 = pose[0] + arm_10;
    const real_t arm_11 = t19 * TB_ANCHOR_6_X;
    const real_t t38 = rails[5] - (pose[1] + arm_11);
    const real_t length_5 = TB_SQRT(t37 * t37 + t38 * t38);
    const bool t39 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t40 = t39 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t41 = t40 && TB_C(0.0001) < length_4 && TB_C(0.0001) < length_5;
    const bool t42 = !t41;
    if (t42) {
        return tb_refuse_cable_lengths(TB_SINGULAR, length);
    }
    length[0] = length_0;
    length[1] = length_1;
    length[2] = length_2;
    length[3] = length_3;
    length[4] = length_4;
    length[5] = length_5;
    return TB_OK;
}

/* Refuses with a status: structure is 0 1, m. */
static tb_status tb_refuse_structure_matrix(tb_status status, real_t structure[18])
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
    return status;
}

tb_status tb_structure_matrix(const real_t pose[3], const real_t rails[6], real_t structure[18])
{
    if (!(pose[0] >= -TB_C(1.4236) && pose[0] <= TB_C(1.4236)
          && pose[1] >= -TB_C(1.4236) && pose[1] <= TB_C(1.4236)
          && pose[2] >= -TB_C(1.2853981633974483) && pose[2] <= TB_C(1.2853981633974483)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) +
              TB_ABS(rails[4]) + TB_ABS(rails[5]) <= TB_C(8.541599999999999))) {
        return tb_refuse_structure_matrix(TB_OUT_OF_DOMAIN, structure);
    }
    const real_t t0 = pose[2] * pose[2] * TB_C(0.25);
    const real_t t1 = -TB_C(2.4795962632247972e-27) + t0 * TB_C(3.279889237069838e-30);
    const real_t t2 = -TB_C(8.896791392450574e-22) + t0 * (TB_C(1.6117375710961184e-24) + t0 *
        t1);
    const real_t t3 = -TB_C(1.5619206968586225e-16) + t0 * (TB_C(4.110317623312165e-19) + t0 *
        t2);
    const real_t t4 = -TB_C(1.1470745597729725e-11) + t0 * (TB_C(4.779477332387385e-14) + t0 *
        t3);
    const real_t t5 = -TB_C(2.755731922398589e-07) + t0 * (TB_C(2.08767569878681e-09) + t0 *
        t4);
    const real_t t6 = -TB_C(0.001388888888888889) + t0 * (TB_C(2.48015873015873e-05) + t0 * t5);
    const real_t t7 = -TB_C(0.5) + t0 * (TB_C(0.041666666666666664) + t0 * t6);
    const real_t t8 = TB_C(1.0) + t0 * t7;
    const real_t t9 = TB_C(6.446950284384474e-26) + t0 * -TB_C(9.183689863795546e-29);
    const real_t t10 = TB_C(1.9572941063391263e-20) + t0 * (-TB_C(3.8681701706306835e-23) + t0
        * t9);
    const real_t t11 = TB_C(2.8114572543455206e-15) + t0 * (-TB_C(8.22063524662433e-18) + t0 *
        t10);
    const real_t t12 = TB_C(1.6059043836821613e-10) + t0 * (-TB_C(7.647163731819816e-13) + t0 *
        t11);
    const real_t t13 = TB_C(2.7557319223985893e-06) + t0 * (-TB_C(2.505210838544172e-08) + t0 *
        t12);
    const real_t t14 = TB_C(0.008333333333333333) + t0 * (-TB_C(0.0001984126984126984) + t0 *
        t13);
    const real_t t15 = TB_C(1.0) + t0 * (-TB_C(0.16666666666666666) + t0 * t14);
    const real_t t16 = pose[2] * (t15 * TB_C(0.5));
    const real_t t17 = t8 * t8 - t16 * t16;
    const real_t t18 = -TB_C(0.04) * t17;
    const real_t t19 = t16 * (t8 * TB_C(2.0));
    const real_t t20 = -TB_C(0.025) * t19;
    /* R p_i, from the platform's centre to its anchors */
    const real_t arm_0 = t18 - t20;
    const real_t t21 = rails[0] - (pose[0] + arm_0);
    const real_t t22 = -TB_C(0.04) * t19;
    const real_t t23 = t17 * -TB_C(0.025);
    const real_t arm_1 = t22 + t23;
    const real_t t24 = pose[1] + arm_1;
    /* l_i = |b_i - c - R p_i|, Yoon eq. 1 */
    const real_t length_0 = TB_SQRT(t21 * t21 + t24 * t24);
    const real_t t25 = TB_C(1.0) / length_0;
    const real_t structure_0 = t21 * t25;
    const real_t t26 = t17 * TB_C(0.04);
    const real_t arm_2 = t26 - t20;
    const real_t t27 = rails[1] - (pose[0] + arm_2);
    const real_t t28 = t19 * TB_C(0.04);
    const real_t arm_3 = t23 + t28;
    const real_t t29 = pose[1] + arm_3;
    const real_t length_1 = TB_SQRT(t27 * t27 + t29 * t29);
    const real_t t30 = TB_C(1.0) / length_1;
    const real_t structure_1 = t27 * t30;
    const real_t arm_4 = t17 * TB_LONGEST_ARM;
    const real_t t31 = TB_FRAME_X - (pose[0] + arm_4);
    const real_t arm_5 = t19 * TB_LONGEST_ARM;
    const real_t t32 = rails[2] - (pose[1] + arm_5);
    const real_t length_2 = TB_SQRT(t31 * t31 + t32 * t32);
    const real_t t33 = TB_C(1.0) / length_2;
    const real_t structure_2 = t31 * t33;
    const real_t t34 = t19 * TB_C(0.025);
    const real_t arm_6 = t26 - t34;
    const real_t t35 = rails[3] - (pose[0] + arm_6);
    const real_t t36 = t17 * TB_C(0.025);
    const real_t arm_7 = t28 + t36;
    const real_t t37 = TB_FRAME_Y - (pose[1] + arm_7);
    const real_t length_3 = TB_SQRT(t35 * t35 + t37 * t37);
    const real_t t38 = TB_C(1.0) / length_3;
    const real_t structure_3 = t35 * t38;
    const real_t arm_8 = t18 - t34;
    const real_t t39 = rails[4] - (pose[0] + arm_8);
    const real_t arm_9 = t22 + t36;
    const real_t t40 = TB_FRAME_Y - (pose[1] + arm_9);
    const real_t length_4 = TB_SQRT(t39 * t39 + t40 * t40);
    const real_t t41 = TB_C(1.0) / length_4;
    const real_t structure_4 = t39 * t41;
    const real_t arm_10 = t17 * TB_ANCHOR_6_X;
    const real_t t42 = pose[0] + arm_10;
    const real_t arm_11 = t19 * TB_ANCHOR_6_X;
    const real_t t43 = rails[5] - (pose[1] + arm_11);
    const real_t length_5 = TB_SQRT(t42 * t42 + t43 * t43);
    const real_t t44 = TB_C(1.0) / length_5;
    const real_t t45 = t42 * t44;
    const real_t structure_5 = -t45;
    const real_t t46 = t24 * t25;
    const real_t structure_6 = -t46;
    const real_t t47 = t29 * t30;
    const real_t structure_7 = -t47;
    const real_t structure_8 = t32 * t33;
    const real_t structure_9 = t37 * t38;
    const real_t structure_10 = t40 * t41;
    const real_t structure_11 = t43 * t44;
    const real_t structure_12 = -(arm_0 * t46 + arm_1 * structure_0);
    const real_t structure_13 = -(arm_2 * t47 + arm_3 * structure_1);
    const real_t structure_14 = arm_4 * structure_8 - arm_5 * structure_2;
    const real_t structure_15 = arm_6 * structure_9 - arm_7 * structure_3;
    const real_t structure_16 = arm_8 * structure_10 - arm_9 * structure_4;
    const real_t structure_17 = arm_10 * structure_11 + arm_11 * t45;
    const bool t48 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t49 = t48 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t50 = t49 && TB_C(0.0001) < length_4 && TB_C(0.0001) < length_5;
    const bool t51 = !t50;
    if (t51) {
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
    return TB_OK;
}

/* Refuses with a status: jacobian is 0 1, m. */
static tb_status tb_refuse_length_jacobian(tb_status status, real_t jacobian[18])
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
    return status;
}

tb_status tb_length_jacobian(const real_t pose[3], const real_t rails[6], real_t jacobian[18])
{
    if (!(pose[0] >= -TB_C(1.4236) && pose[0] <= TB_C(1.4236)
          && pose[1] >= -TB_C(1.4236) && pose[1] <= TB_C(1.4236)
          && pose[2] >= -TB_C(1.2853981633974483) && pose[2] <= TB_C(1.2853981633974483)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) +
              TB_ABS(rails[4]) + TB_ABS(rails[5]) <= TB_C(8.541599999999999))) {
        return tb_refuse_length_jacobian(TB_OUT_OF_DOMAIN, jacobian);
    }
    const real_t t0 = pose[2] * pose[2] * TB_C(0.25);
    const real_t t1 = -TB_C(2.4795962632247972e-27) + t0 * TB_C(3.279889237069838e-30);
    const real_t t2 = -TB_C(8.896791392450574e-22) + t0 * (TB_C(1.6117375710961184e-24) + t0 *
        t1);
    const real_t t3 = -TB_C(1.5619206968586225e-16) + t0 * (TB_C(4.110317623312165e-19) + t0 *
        t2);
    const real_t t4 = -TB_C(1.1470745597729725e-11) + t0 * (TB_C(4.779477332387385e-14) + t0 *
        t3);
    const real_t t5 = -TB_C(2.755731922398589e-07) + t0 * (TB_C(2.08767569878681e-09) + t0 *
        t4);
    const real_t t6 = -TB_C(0.001388888888888889) + t0 * (TB_C(2.48015873015873e-05) + t0 * t5);
    const real_t t7 = -TB_C(0.5) + t0 * (TB_C(0.041666666666666664) + t0 * t6);
    const real_t t8 = TB_C(1.0) + t0 * t7;
    const real_t t9 = TB_C(6.446950284384474e-26) + t0 * -TB_C(9.183689863795546e-29);
    const real_t t10 = TB_C(1.9572941063391263e-20) + t0 * (-TB_C(3.8681701706306835e-23) + t0
        * t9);
    const real_t t11 = TB_C(2.8114572543455206e-15) + t0 * (-TB_C(8.22063524662433e-18) + t0 *
        t10);
    const real_t t12 = TB_C(1.6059043836821613e-10) + t0 * (-TB_C(7.647163731819816e-13) + t0 *
        t11);
    const real_t t13 = TB_C(2.7557319223985893e-06) + t0 * (-TB_C(2.505210838544172e-08) + t0 *
        t12);
    const real_t t14 = TB_C(0.008333333333333333) + t0 * (-TB_C(0.0001984126984126984) + t0 *
        t13);
    const real_t t15 = TB_C(1.0) + t0 * (-TB_C(0.16666666666666666) + t0 * t14);
    const real_t t16 = pose[2] * (t15 * TB_C(0.5));
    const real_t t17 = t8 * t8 - t16 * t16;
    const real_t t18 = -TB_C(0.04) * t17;
    const real_t t19 = t16 * (t8 * TB_C(2.0));
    const real_t t20 = -TB_C(0.025) * t19;
    /* R p_i, from the platform's centre to its anchors */
    const real_t arm_0 = t18 - t20;
    const real_t t21 = rails[0] - (pose[0] + arm_0);
    const real_t t22 = -TB_C(0.04) * t19;
    const real_t t23 = t17 * -TB_C(0.025);
    const real_t arm_1 = t22 + t23;
    const real_t t24 = pose[1] + arm_1;
    /* l_i = |b_i - c - R p_i|, Yoon eq. 1 */
    const real_t length_0 = TB_SQRT(t21 * t21 + t24 * t24);
    const real_t t25 = TB_C(1.0) / length_0;
    const real_t jacobian_0 = -(t21 * t25);
    const real_t jacobian_1 = t24 * t25;
    const real_t t26 = arm_1 * (TB_C(2.0) * t21) + arm_0 * (TB_C(2.0) * t24);
    const real_t jacobian_2 = t26 / (TB_C(2.0) * length_0);
    const real_t t27 = t17 * TB_C(0.04);
    const real_t arm_2 = t27 - t20;
    const real_t t28 = rails[1] - (pose[0] + arm_2);
    const real_t t29 = t19 * TB_C(0.04);
    const real_t arm_3 = t23 + t29;
    const real_t t30 = pose[1] + arm_3;
    const real_t length_1 = TB_SQRT(t28 * t28 + t30 * t30);
    const real_t t31 = TB_C(1.0) / length_1;
    const real_t jacobian_3 = -(t28 * t31);
    const real_t jacobian_4 = t30 * t31;
    const real_t t32 = arm_3 * (TB_C(2.0) * t28) + arm_2 * (TB_C(2.0) * t30);
    const real_t jacobian_5 = t32 / (TB_C(2.0) * length_1);
    const real_t arm_4 = t17 * TB_LONGEST_ARM;
    const real_t t33 = TB_FRAME_X - (pose[0] + arm_4);
    const real_t arm_5 = t19 * TB_LONGEST_ARM;
    const real_t t34 = rails[2] - (pose[1] + arm_5);
    const real_t length_2 = TB_SQRT(t33 * t33 + t34 * t34);
    const real_t t35 = TB_C(1.0) / length_2;
    const real_t jacobian_6 = -(t33 * t35);
    const real_t jacobian_7 = -(t34 * t35);
    const real_t t36 = arm_5 * (TB_C(2.0) * t33) - arm_4 * (TB_C(2.0) * t34);
    const real_t jacobian_8 = t36 / (TB_C(2.0) * length_2);
    const real_t t37 = t19 * TB_C(0.025);
    const real_t arm_6 = t27 - t37;
    const real_t t38 = rails[3] - (pose[0] + arm_6);
    const real_t t39 = t17 * TB_C(0.025);
    const real_t arm_7 = t29 + t39;
    const real_t t40 = TB_FRAME_Y - (pose[1] + arm_7);
    const real_t length_3 = TB_SQRT(t38 * t38 + t40 * t40);
    const real_t t41 = TB_C(1.0) / length_3;
    const real_t jacobian_9 = -(t38 * t41);
    const real_t jacobian_10 = -(t40 * t41);
    const real_t t42 = arm_7 * (TB_C(2.0) * t38) - arm_6 * (TB_C(2.0) * t40);
    const real_t jacobian_11 = t42 / (TB_C(2.0) * length_3);
    const real_t arm_8 = t18 - t37;
    const real_t t43 = rails[4] - (pose[0] + arm_8);
    const real_t arm_9 = t22 + t39;
    const real_t t44 = TB_FRAME_Y - (pose[1] + arm_9);
    const real_t length_4 = TB_SQRT(t43 * t43 + t44 * t44);
    const real_t t45 = TB_C(1.0) / length_4;
    const real_t jacobian_12 = -(t43 * t45);
    const real_t jacobian_13 = -(t44 * t45);
    const real_t t46 = arm_9 * (TB_C(2.0) * t43) - arm_8 * (TB_C(2.0) * t44);
    const real_t jacobian_14 = t46 / (TB_C(2.0) * length_4);
    const real_t arm_10 = t17 * TB_ANCHOR_6_X;
    const real_t t47 = pose[0] + arm_10;
    const real_t arm_11 = t19 * TB_ANCHOR_6_X;
    const real_t t48 = rails[5] - (pose[1] + arm_11);
    const real_t length_5 = TB_SQRT(t47 * t47 + t48 * t48);
    const real_t t49 = TB_C(1.0) / length_5;
    const real_t jacobian_15 = t47 * t49;
    const real_t jacobian_16 = -(t48 * t49);
    const real_t t50 = arm_11 * (TB_C(2.0) * t47) + arm_10 * (TB_C(2.0) * t48);
    const real_t jacobian_17 = -(t50 / (TB_C(2.0) * length_5));
    const bool t51 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t52 = t51 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t53 = t52 && TB_C(0.0001) < length_4 && TB_C(0.0001) < length_5;
    const bool t54 = !t53;
    if (t54) {
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
    return TB_OK;
}

/* Refuses with a status: velocity is 0 m/s, rad/s. */
static tb_status tb_refuse_task_velocity(tb_status status, real_t velocity[3])
{
    velocity[0] = TB_C(0.0);
    velocity[1] = TB_C(0.0);
    velocity[2] = TB_C(0.0);
    return status;
}

tb_status tb_task_velocity(const real_t pose[3], const real_t rails[6],
    const real_t length_rates[6], const real_t rail_rates[6], real_t velocity[3])
{
    if (!(pose[0] >= -TB_C(1.4236) && pose[0] <= TB_C(1.4236)
          && pose[1] >= -TB_C(1.4236) && pose[1] <= TB_C(1.4236)
          && pose[2] >= -TB_C(1.2853981633974483) && pose[2] <= TB_C(1.2853981633974483)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) +
              TB_ABS(rails[4]) + TB_ABS(rails[5]) <= TB_C(8.541599999999999)
          && TB_ABS(length_rates[0]) + TB_ABS(length_rates[1]) + TB_ABS(length_rates[2]) +
              TB_ABS(length_rates[3]) + TB_ABS(length_rates[4]) + TB_ABS(length_rates[5]) <=
              TB_C(600.0)
          && TB_ABS(rail_rates[0]) + TB_ABS(rail_rates[1]) + TB_ABS(rail_rates[2]) +
              TB_ABS(rail_rates[3]) + TB_ABS(rail_rates[4]) + TB_ABS(rail_rates[5]) <=
              TB_C(600.0))) {
        return tb_refuse_task_velocity(TB_OUT_OF_DOMAIN, velocity);
    }
    const real_t t0 = pose[2] * pose[2] * TB_C(0.25);
    const real_t t1 = -TB_C(2.4795962632247972e-27) + t0 * TB_C(3.279889237069838e-30);
    const real_t t2 = -TB_C(8.896791392450574e-22) + t0 * (TB_C(1.6117375710961184e-24) + t0 *
        t1);
    const real_t t3 = -TB_C(1.5619206968586225e-16) + t0 * (TB_C(4.110317623312165e-19) + t0 *
        t2);
    const real_t t4 = -TB_C(1.1470745597729725e-11) + t0 * (TB_C(4.779477332387385e-14) + t0 *
        t3);
    const real_t t5 = -TB_C(2.755731922398589e-07) + t0 * (TB_C(2.08767569878681e-09) + t0 *
        t4);
    const real_t t6 = -TB_C(0.001388888888888889) + t0 * (TB_C(2.48015873015873e-05) + t0 * t5);
    const real_t t7 = -TB_C(0.5) + t0 * (TB_C(0.041666666666666664) + t0 * t6);
    const real_t t8 = TB_C(1.0) + t0 * t7;
    const real_t t9 = TB_C(6.446950284384474e-26) + t0 * -TB_C(9.183689863795546e-29);
    const real_t t10 = TB_C(1.9572941063391263e-20) + t0 * (-TB_C(3.8681701706306835e-23) + t0
        * t9);
    const real_t t11 = TB_C(2.8114572543455206e-15) + t0 * (-TB_C(8.22063524662433e-18) + t0 *
        t10);
    const real_t t12 = TB_C(1.6059043836821613e-10) + t0 * (-TB_C(7.647163731819816e-13) + t0 *
        t11);
    const real_t t13 = TB_C(2.7557319223985893e-06) + t0 * (-TB_C(2.505210838544172e-08) + t0 *
        t12);
    const real_t t14 = TB_C(0.008333333333333333) + t0 * (-TB_C(0.0001984126984126984) + t0 *
        t13);
    const real_t t15 = TB_C(1.0) + t0 * (-TB_C(0.16666666666666666) + t0 * t14);
    const real_t t16 = pose[2] * (t15 * TB_C(0.5));
    const real_t t17 = t8 * t8 - t16 * t16;
    const real_t t18 = -TB_C(0.04) * t17;
    const real_t t19 = t16 * (t8 * TB_C(2.0));
    const real_t t20 = -TB_C(0.025) * t19;
    /* R p_i, from the platform's centre to its anchors */
    const real_t arm_0 = t18 - t20;
    const real_t t21 = rails[0] - (pose[0] + arm_0);
    const real_t t22 = -TB_C(0.04) * t19;
    const real_t t23 = t17 * -TB_C(0.025);
    const real_t arm_1 = t22 + t23;
    const real_t t24 = pose[1] + arm_1;
    /* l_i = |b_i - c - R p_i|, Yoon eq. 1 */
    const real_t length_0 = TB_SQRT(t21 * t21 + t24 * t24);
    const real_t t25 = TB_C(1.0) / length_0;
    const real_t t26 = t21 * t25;
    const real_t t27 = length_rates[0] - t26 * rail_rates[0];
    const real_t t28 = t17 * TB_C(0.04);
    const real_t arm_2 = t28 - t20;
    const real_t t29 = rails[1] - (pose[0] + arm_2);
    const real_t t30 = t19 * TB_C(0.04);
    const real_t arm_3 = t23 + t30;
    const real_t t31 = pose[1] + arm_3;
    const real_t length_1 = TB_SQRT(t29 * t29 + t31 * t31);
    const real_t t32 = TB_C(1.0) / length_1;
    const real_t t33 = t29 * t32;
    const real_t t34 = length_rates[1] - t33 * rail_rates[1];
    const real_t arm_4 = t17 * TB_LONGEST_ARM;
    const real_t t35 = TB_FRAME_X - (pose[0] + arm_4);
    const real_t arm_5 = t19 * TB_LONGEST_ARM;
    const real_t t36 = rails[2] - (pose[1] + arm_5);
    const real_t length_2 = TB_SQRT(t35 * t35 + t36 * t36);
    const real_t t37 = TB_C(1.0) / length_2;
    const real_t t38 = t35 * t37;
    const real_t t39 = t36 * t37;
    const real_t t40 = length_rates[2] - t39 * rail_rates[2];
    const real_t t41 = t19 * TB_C(0.025);
    const real_t arm_6 = t28 - t41;
    const real_t t42 = rails[3] - (pose[0] + arm_6);
    const real_t t43 = t17 * TB_C(0.025);
    const real_t arm_7 = t30 + t43;
    const real_t t44 = TB_FRAME_Y - (pose[1] + arm_7);
    const real_t length_3 = TB_SQRT(t42 * t42 + t44 * t44);
    const real_t t45 = TB_C(1.0) / length_3;
    const real_t t46 = t42 * t45;
    const real_t t47 = length_rates[3] - t46 * rail_rates[3];
    const real_t arm_8 = t18 - t41;
    const real_t t48 = rails[4] - (pose[0] + arm_8);
    const real_t arm_9 = t22 + t43;
    const real_t t49 = TB_FRAME_Y - (pose[1] + arm_9);
    const real_t length_4 = TB_SQRT(t48 * t48 + t49 * t49);
    const real_t t50 = TB_C(1.0) / length_4;
    const real_t t51 = t48 * t50;
    const real_t t52 = length_rates[4] - t51 * rail_rates[4];
    const real_t t53 = t26 * t27 + t33 * t34 + t38 * t40 + t46 * t47 + t51 * t52;
    const real_t arm_10 = t17 * TB_ANCHOR_6_X;
    const real_t t54 = pose[0] + arm_10;
    const real_t arm_11 = t19 * TB_ANCHOR_6_X;
    const real_t t55 = rails[5] - (pose[1] + arm_11);
    const real_t length_5 = TB_SQRT(t54 * t54 + t55 * t55);
    const real_t t56 = TB_C(1.0) / length_5;
    const real_t t57 = t54 * t56;
    const real_t t58 = t55 * t56;
    const real_t t59 = length_rates[5] - t58 * rail_rates[5];
    const real_t t60 = t53 - t57 * t59;
    const real_t t61 = t26 * t26 + t33 * t33 + t38 * t38 + t46 * t46 + t51 * t51;
    const real_t t62 = t61 + t57 * t57;
    const real_t t63 = TB_C(1.0) / t62;
    const real_t t64 = t24 * t25;
    const real_t t65 = t31 * t32;
    const real_t t66 = t44 * t45;
    const real_t t67 = t49 * t50;
    const real_t t68 = t38 * t39 - (t26 * t64 + t33 * t65) + t46 * t66 + t51 * t67;
    const real_t t69 = t63 * (t68 - t57 * t58);
    const real_t t70 = t39 * t40 - (t27 * t64 + t34 * t65) + t47 * t66 + t52 * t67;
    const real_t t71 = t60 * t69 - (t70 + t58 * t59);
    const real_t t72 = t64 * t64 + t65 * t65 + t39 * t39 + t66 * t66 + t67 * t67;
    const real_t t73 = t72 + t58 * t58 - t62 * (t69 * t69);
    const real_t t74 = TB_C(1.0) / t73;
    const real_t t75 = (arm_0 * t64 + arm_1 * t26) * TB_MOMENT_WEIGHT;
    const real_t t76 = TB_MOMENT_WEIGHT * (arm_2 * t65 + arm_3 * t33);
    const real_t t77 = TB_MOMENT_WEIGHT * (arm_4 * t39 - arm_5 * t38);
    const real_t t78 = TB_MOMENT_WEIGHT * (arm_6 * t66 - arm_7 * t46);
    const real_t t79 = TB_MOMENT_WEIGHT * (arm_8 * t67 - arm_9 * t51);
    const real_t t80 = t64 * t75 + t65 * t76 + t39 * t77 + t66 * t78 + t67 * t79;
    const real_t t81 = TB_MOMENT_WEIGHT * (arm_10 * t58 + arm_11 * t57);
    const real_t t82 = t38 * t77 - (t26 * t75 + t33 * t76) + t46 * t78 + t51 * t79;
    const real_t t83 = t63 * (t82 - t57 * t81);
    const real_t t84 = t74 * (t80 + t58 * t81 - t62 * (t69 * t83));
    const real_t t85 = t40 * t77 - (t27 * t75 + t34 * t76) + t47 * t78 + t52 * t79;
    const real_t t86 = t75 * t75 + t76 * t76 + t77 * t77 + t78 * t78 + t79 * t79;
    const real_t t87 = t86 + t81 * t81 - t62 * (t83 * t83) - t73 * (t84 * t84);
    const real_t t88 = (t60 * t83 - (t85 + t59 * t81) - t71 * t84) / t87;
    const real_t velocity_1 = t71 * t74 - t84 * t88;
    const real_t velocity_0 = -(t60 * t63 + t69 * velocity_1 + t83 * t88);
    const real_t velocity_2 = TB_MOMENT_WEIGHT * t88;
    const bool t89 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t90 = t89 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t91 = t90 && TB_C(0.0001) < length_4 && TB_C(0.0001) < length_5;
    const bool t92 = !t91;
    const real_t t93 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const bool t94 = !(t93 < t62 && t93 < t73 && t93 < t87);
    if (t92 || t94) {
        return tb_refuse_task_velocity(TB_SINGULAR, velocity);
    }
    velocity[0] = velocity_0;
    velocity[1] = velocity_1;
    velocity[2] = velocity_2;
    return TB_OK;
}

/* Refuses with a status: jacobian is 0. */
static tb_status tb_refuse_rail_jacobian(tb_status status, real_t jacobian[36])
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
    return status;
}

tb_status tb_rail_jacobian(const real_t pose[3], const real_t rails[6], real_t jacobian[36])
{
    if (!(pose[0] >= -TB_C(1.4236) && pose[0] <= TB_C(1.4236)
          && pose[1] >= -TB_C(1.4236) && pose[1] <= TB_C(1.4236)
          && pose[2] >= -TB_C(1.2853981633974483) && pose[2] <= TB_C(1.2853981633974483)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) +
              TB_ABS(rails[4]) + TB_ABS(rails[5]) <= TB_C(8.541599999999999))) {
        return tb_refuse_rail_jacobian(TB_OUT_OF_DOMAIN, jacobian);
    }
    const real_t t0 = pose[2] * pose[2] * TB_C(0.25);
    const real_t t1 = -TB_C(2.4795962632247972e-27) + t0 * TB_C(3.279889237069838e-30);
    const real_t t2 = -TB_C(8.896791392450574e-22) + t0 * (TB_C(1.6117375710961184e-24) + t0 *
        t1);
    const real_t t3 = -TB_C(1.5619206968586225e-16) + t0 * (TB_C(4.110317623312165e-19) + t0 *
        t2);
    const real_t t4 = -TB_C(1.1470745597729725e-11) + t0 * (TB_C(4.779477332387385e-14) + t0 *
        t3);
    const real_t t5 = -TB_C(2.755731922398589e-07) + t0 * (TB_C(2.08767569878681e-09) + t0 *
        t4);
    const real_t t6 = -TB_C(0.001388888888888889) + t0 * (TB_C(2.48015873015873e-05) + t0 * t5);
    const real_t t7 = -TB_C(0.5) + t0 * (TB_C(0.041666666666666664) + t0 * t6);
    const real_t t8 = TB_C(1.0) + t0 * t7;
    const real_t t9 = TB_C(6.446950284384474e-26) + t0 * -TB_C(9.183689863795546e-29);
    const real_t t10 = TB_C(1.9572941063391263e-20) + t0 * (-TB_C(3.8681701706306835e-23) + t0
        * t9);
    const real_t t11 = TB_C(2.8114572543455206e-15) + t0 * (-TB_C(8.22063524662433e-18) + t0 *
        t10);
    const real_t t12 = TB_C(1.6059043836821613e-10) + t0 * (-TB_C(7.647163731819816e-13) + t0 *
        t11);
    const real_t t13 = TB_C(2.7557319223985893e-06) + t0 * (-TB_C(2.505210838544172e-08) + t0 *
        t12);
    const real_t t14 = TB_C(0.008333333333333333) + t0 * (-TB_C(0.0001984126984126984) + t0 *
        t13);
    const real_t t15 = TB_C(1.0) + t0 * (-TB_C(0.16666666666666666) + t0 * t14);
    const real_t t16 = pose[2] * (t15 * TB_C(0.5));
    const real_t t17 = t8 * t8 - t16 * t16;
    const real_t t18 = -TB_C(0.04) * t17;
    const real_t t19 = t16 * (t8 * TB_C(2.0));
    const real_t t20 = -TB_C(0.025) * t19;
    /* R p_i, from the platform's centre to its anchors */
    const real_t arm_0 = t18 - t20;
    const real_t t21 = rails[0] - (pose[0] + arm_0);
    const real_t t22 = -TB_C(0.04) * t19;
    const real_t t23 = t17 * -TB_C(0.025);
    const real_t arm_1 = t22 + t23;
    const real_t t24 = pose[1] + arm_1;
    /* l_i = |b_i - c - R p_i|, Yoon eq. 1 */
    const real_t length_0 = TB_SQRT(t21 * t21 + t24 * t24);
    const real_t jacobian_0 = t21 / length_0;
    const real_t t25 = t17 * TB_C(0.04);
    const real_t arm_2 = t25 - t20;
    const real_t t26 = rails[1] - (pose[0] + arm_2);
    const real_t t27 = t19 * TB_C(0.04);
    const real_t arm_3 = t23 + t27;
    const real_t t28 = pose[1] + arm_3;
    const real_t length_1 = TB_SQRT(t26 * t26 + t28 * t28);
    const real_t jacobian_7 = t26 / length_1;
    const real_t arm_5 = t19 * TB_LONGEST_ARM;
    const real_t t29 = rails[2] - (pose[1] + arm_5);
    const real_t arm_4 = t17 * TB_LONGEST_ARM;
    const real_t t30 = TB_FRAME_X - (pose[0] + arm_4);
    const real_t length_2 = TB_SQRT(t30 * t30 + t29 * t29);
    const real_t jacobian_14 = t29 / length_2;
    const real_t t31 = t19 * TB_C(0.025);
    const real_t arm_6 = t25 - t31;
    const real_t t32 = rails[3] - (pose[0] + arm_6);
    const real_t t33 = t17 * TB_C(0.025);
    const real_t arm_7 = t27 + t33;
    const real_t t34 = TB_FRAME_Y - (pose[1] + arm_7);
    const real_t length_3 = TB_SQRT(t32 * t32 + t34 * t34);
    const real_t jacobian_21 = t32 / length_3;
    const real_t arm_8 = t18 - t31;
    const real_t t35 = rails[4] - (pose[0] + arm_8);
    const real_t arm_9 = t22 + t33;
    const real_t t36 = TB_FRAME_Y - (pose[1] + arm_9);
    const real_t length_4 = TB_SQRT(t35 * t35 + t36 * t36);
    const real_t jacobian_28 = t35 / length_4;
    const real_t arm_11 = t19 * TB_ANCHOR_6_X;
    const real_t t37 = rails[5] - (pose[1] + arm_11);
    const real_t arm_10 = t17 * TB_ANCHOR_6_X;
    const real_t t38 = pose[0] + arm_10;
    const real_t length_5 = TB_SQRT(t38 * t38 + t37 * t37);
    const real_t jacobian_35 = t37 / length_5;
    const bool t39 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t40 = t39 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t41 = t40 && TB_C(0.0001) < length_4 && TB_C(0.0001) < length_5;
    const bool t42 = !t41;
    if (t42) {
        return tb_refuse_rail_jacobian(TB_SINGULAR, jacobian);
    }
    jacobian[0] = jacobian_0;
    jacobian[1] = TB_C(0.0);
    jacobian[2] = TB_C(0.0);
    jacobian[3] = TB_C(0.0);
    jacobian[4] = TB_C(0.0);
    jacobian[5] = TB_C(0.0);
    jacobian[6] = TB_C(0.0);
    jacobian[7] = jacobian_7;
    jacobian[8] = TB_C(0.0);
    jacobian[9] = TB_C(0.0);
    jacobian[10] = TB_C(0.0);
    jacobian[11] = TB_C(0.0);
    jacobian[12] = TB_C(0.0);
    jacobian[13] = TB_C(0.0);
    jacobian[14] = jacobian_14;
    jacobian[15] = TB_C(0.0);
    jacobian[16] = TB_C(0.0);
    jacobian[17] = TB_C(0.0);
    jacobian[18] = TB_C(0.0);
    jacobian[19] = TB_C(0.0);
    jacobian[20] = TB_C(0.0);
    jacobian[21] = jacobian_21;
    jacobian[22] = TB_C(0.0);
    jacobian[23] = TB_C(0.0);
    jacobian[24] = TB_C(0.0);
    jacobian[25] = TB_C(0.0);
    jacobian[26] = TB_C(0.0);
    jacobian[27] = TB_C(0.0);
    jacobian[28] = jacobian_28;
    jacobian[29] = TB_C(0.0);
    jacobian[30] = TB_C(0.0);
    jacobian[31] = TB_C(0.0);
    jacobian[32] = TB_C(0.0);
    jacobian[33] = TB_C(0.0);
    jacobian[34] = TB_C(0.0);
    jacobian[35] = jacobian_35;
    return TB_OK;
}

/* The guess is the first estimate. */
static tb_status tb_forward_kinematics_begin(const real_t guess[3], const real_t lengths[6],
    const real_t rails[6], real_t estimate[3])
{
    if (!(guess[0] >= -TB_C(1.4236) && guess[0] <= TB_C(1.4236)
          && guess[1] >= -TB_C(1.4236) && guess[1] <= TB_C(1.4236)
          && guess[2] >= -TB_C(1.2853981633974483) && guess[2] <= TB_C(1.2853981633974483)
          && lengths[0] >= TB_C(0.0) && lengths[0] <= TB_C(4.6944)
          && lengths[1] >= TB_C(0.0) && lengths[1] <= TB_C(4.6944)
          && lengths[2] >= TB_C(0.0) && lengths[2] <= TB_C(4.6944)
          && lengths[3] >= TB_C(0.0) && lengths[3] <= TB_C(4.6944)
          && lengths[4] >= TB_C(0.0) && lengths[4] <= TB_C(4.6944)
          && lengths[5] >= TB_C(0.0) && lengths[5] <= TB_C(4.6944)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) +
              TB_ABS(rails[4]) + TB_ABS(rails[5]) <= TB_C(8.541599999999999))) {
        estimate[0] = TB_C(0.0);
        estimate[1] = TB_C(0.0);
        estimate[2] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    estimate[0] = guess[0];
    estimate[1] = guess[1];
    estimate[2] = guess[2];
    return TB_OK;
}

/* Gauss-Newton step on the misfit of the lengths. */
static tb_status tb_forward_kinematics_step(const real_t lengths[6], const real_t rails[6],
    real_t estimate[3], real_t found[1])
{
    const real_t t0 = estimate[2] * estimate[2] * TB_C(0.25);
    const real_t t1 = -TB_C(2.4795962632247972e-27) + t0 * TB_C(3.279889237069838e-30);
    const real_t t2 = -TB_C(8.896791392450574e-22) + t0 * (TB_C(1.6117375710961184e-24) + t0 *
        t1);
    const real_t t3 = -TB_C(1.5619206968586225e-16) + t0 * (TB_C(4.110317623312165e-19) + t0 *
        t2);
    const real_t t4 = -TB_C(1.1470745597729725e-11) + t0 * (TB_C(4.779477332387385e-14) + t0 *
        t3);
    const real_t t5 = -TB_C(2.755731922398589e-07) + t0 * (TB_C(2.08767569878681e-09) + t0 *
        t4);
    const real_t t6 = -TB_C(0.001388888888888889) + t0 * (TB_C(2.48015873015873e-05) + t0 * t5);
    const real_t t7 = -TB_C(0.5) + t0 * (TB_C(0.041666666666666664) + t0 * t6);
    const real_t t8 = TB_C(1.0) + t0 * t7;
    const real_t t9 = TB_C(6.446950284384474e-26) + t0 * -TB_C(9.183689863795546e-29);
    const real_t t10 = TB_C(1.9572941063391263e-20) + t0 * (-TB_C(3.8681701706306835e-23) + t0
        * t9);
    const real_t t11 = TB_C(2.8114572543455206e-15) + t0 * (-TB_C(8.22063524662433e-18) + t0 *
        t10);
    const real_t t12 = TB_C(1.6059043836821613e-10) + t0 * (-TB_C(7.647163731819816e-13) + t0 *
        t11);
    const real_t t13 = TB_C(2.7557319223985893e-06) + t0 * (-TB_C(2.505210838544172e-08) + t0 *
        t12);
    const real_t t14 = TB_C(0.008333333333333333) + t0 * (-TB_C(0.0001984126984126984) + t0 *
        t13);
    const real_t t15 = TB_C(1.0) + t0 * (-TB_C(0.16666666666666666) + t0 * t14);
    const real_t t16 = estimate[2] * (t15 * TB_C(0.5));
    const real_t t17 = t8 * t8 - t16 * t16;
    const real_t t18 = TB_ANCHOR_6_X * t17;
    const real_t t19 = estimate[0] + t18;
    const real_t t20 = t16 * (t8 * TB_C(2.0));
    const real_t t21 = TB_ANCHOR_6_X * t20;
    const real_t t22 = rails[5] - (estimate[1] + t21);
    const real_t t23 = TB_SQRT(t19 * t19 + t22 * t22);
    const real_t t24 = TB_C(1.0) / t23;
    const real_t t25 = t19 * t24;
    const real_t t26 = lengths[5] - t23;
    const real_t t27 = t17 * -TB_C(0.04);
    const real_t t28 = t20 * -TB_C(0.025);
    const real_t t29 = t27 - t28;
    const real_t t30 = rails[0] - (estimate[0] + t29);
    const real_t t31 = t20 * -TB_C(0.04);
    const real_t t32 = t17 * -TB_C(0.025);
    const real_t t33 = t31 + t32;
    const real_t t34 = estimate[1] + t33;
    const real_t t35 = TB_SQRT(t30 * t30 + t34 * t34);
    const real_t t36 = TB_C(1.0) / t35;
    const real_t t37 = t30 * t36;
    const real_t t38 = lengths[0] - t35;
    const real_t t39 = t17 * TB_C(0.04);
    const real_t t40 = t39 - t28;
    const real_t t41 = rails[1] - (estimate[0] + t40);
    const real_t t42 = t20 * TB_C(0.04);
    const real_t t43 = t32 + t42;
    const real_t t44 = estimate[1] + t43;
    const real_t t45 = TB_SQRT(t41 * t41 + t44 * t44);
    const real_t t46 = TB_C(1.0) / t45;
    const real_t t47 = t41 * t46;
    const real_t t48 = lengths[1] - t45;
    const real_t t49 = t17 * TB_LONGEST_ARM;
    const real_t t50 = TB_FRAME_X - (estimate[0] + t49);
    const real_t t51 = t20 * TB_LONGEST_ARM;
    const real_t t52 = rails[2] - (estimate[1] + t51);
    const real_t t53 = TB_SQRT(t50 * t50 + t52 * t52);
    const real_t t54 = TB_C(1.0) / t53;
    const real_t t55 = t50 * t54;
    const real_t t56 = lengths[2] - t53;
    const real_t t57 = t20 * TB_C(0.025);
    const real_t t58 = t39 - t57;
    const real_t t59 = rails[3] - (estimate[0] + t58);
    const real_t t60 = t17 * TB_C(0.025);
    const real_t t61 = t42 + t60;
    const real_t t62 = TB_FRAME_Y - (estimate[1] + t61);
    const real_t t63 = TB_SQRT(t59 * t59 + t62 * t62);
    const real_t t64 = TB_C(1.0) / t63;
    const real_t t65 = t59 * t64;
    const real_t t66 = lengths[3] - t63;
    const real_t t67 = t27 - t57;
    const real_t t68 = rails[4] - (estimate[0] + t67);
    const real_t t69 = t31 + t60;
    const real_t t70 = TB_FRAME_Y - (estimate[1] + t69);
    const real_t t71 = TB_SQRT(t68 * t68 + t70 * t70);
    const real_t t72 = TB_C(1.0) / t71;
    const real_t t73 = t68 * t72;
    const real_t t74 = lengths[4] - t71;
    const real_t t75 = t37 * t38 + t47 * t48 + t55 * t56 + t65 * t66 + t73 * t74;
    const real_t t76 = t25 * t26 - t75;
    const real_t t77 = t37 * t37 + t47 * t47 + t55 * t55 + t65 * t65 + t73 * t73;
    const real_t t78 = t77 + t25 * t25;
    const real_t t79 = TB_C(1.0) / t78;
    const real_t t80 = t52 * t54;
    const real_t t81 = t34 * t36;
    const real_t t82 = t44 * t46;
    const real_t t83 = t62 * t64;
    const real_t t84 = t70 * t72;
    const real_t t85 = t55 * t80 - (t37 * t81 + t47 * t82) + t65 * t83 + t73 * t84;
    const real_t t86 = t22 * t24;
    const real_t t87 = t79 * (t85 - t25 * t86);
    const real_t t88 = t38 * t81 + t48 * t82 - t56 * t80 - t66 * t83 - t74 * t84;
    const real_t t89 = t88 - t26 * t86;
    const real_t t90 = t89 - t76 * t87;
    const real_t t91 = t81 * t81 + t82 * t82 + t80 * t80 + t83 * t83 + t84 * t84;
    const real_t t92 = t91 + t86 * t86 - t78 * (t87 * t87);
    const real_t t93 = TB_C(1.0) / t92;
    const real_t t94 = (t29 * t81 + t33 * t37) * TB_MOMENT_WEIGHT;
    const real_t t95 = TB_MOMENT_WEIGHT * (t40 * t82 + t43 * t47);
    const real_t t96 = TB_MOMENT_WEIGHT * (t49 * t80 - t51 * t55);
    const real_t t97 = TB_MOMENT_WEIGHT * (t58 * t83 - t61 * t65);
    const real_t t98 = TB_MOMENT_WEIGHT * (t67 * t84 - t69 * t73);
    const real_t t99 = t81 * t94 + t82 * t95 + t80 * t96 + t83 * t97 + t84 * t98;
    const real_t t100 = TB_MOMENT_WEIGHT * (t18 * t86 + t21 * t25);
    const real_t t101 = t55 * t96 - (t37 * t94 + t47 * t95) + t65 * t97 + t73 * t98;
    const real_t t102 = t79 * (t101 - t25 * t100);
    const real_t t103 = t93 * (t99 + t86 * t100 - t78 * (t87 * t102));
    const real_t t104 = t38 * t94 + t48 * t95 - t56 * t96 - t66 * t97 - t74 * t98;
    const real_t t105 = t104 - t26 * t100;
    const real_t t106 = t94 * t94 + t95 * t95 + t96 * t96 + t97 * t97 + t98 * t98;
    const real_t t107 = t106 + t100 * t100 - t78 * (t102 * t102) - t92 * (t103 * t103);
    const real_t t108 = (t105 - t76 * t102 - t90 * t103) / t107;
    const real_t t109 = t90 * t93 - t103 * t108;
    const real_t t110 = t76 * t79 - t87 * t109 - t102 * t108;
    const real_t t111 = TB_SQRT(t110 * t110 + t109 * t109) * TB_C(4.714312097910988);
    const real_t t112 = tb_max(TB_C(1.0), TB_ABS(t108) * TB_C(40.066833797650666));
    const real_t t113 = tb_min(TB_C(1.0) / tb_max(TB_C(1.0), t111), TB_C(1.0) / t112);
    const real_t estimate_0 = tb_min(tb_max(estimate[0] + t110 * t113, -TB_C(1.4236)),
        TB_C(1.4236));
    const real_t estimate_1 = tb_min(tb_max(estimate[1] + t109 * t113, -TB_C(1.4236)),
        TB_C(1.4236));
    const real_t t114 = estimate[2] + TB_MOMENT_WEIGHT * (t108 * t113);
    const real_t estimate_2 = tb_min(tb_max(t114, -TB_C(1.2853981633974483)),
        TB_C(1.2853981633974483));
    const real_t t115 = TB_C(13.575681599094757) * TB_EPSILON;
    const real_t t116 = t38 * t38 + t48 * t48 + t56 * t56 + t66 * t66 + t74 * t74;
    const bool t117 = t76 * t110 + t89 * t109 + t105 * t108 <= t115 * t115 + TB_C(1e-18) *
        (t116 + t26 * t26);
    const real_t found_0 = t117 ? TB_C(1.0) : TB_C(0.0);
    const bool t118 = TB_C(0.0001) < t35 && TB_C(0.0001) < t45 && TB_C(0.0001) < t53;
    const bool t119 = t118 && TB_C(0.0001) < t63 && TB_C(0.0001) < t71 && TB_C(0.0001) < t23;
    const bool t120 = !t119;
    const real_t t121 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t122 = !(t121 < t78 && t121 < t92 && t121 < t107);
    if (t120 || t122) {
        estimate[0] = TB_C(0.0);
        estimate[1] = TB_C(0.0);
        estimate[2] = TB_C(0.0);
        found[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    estimate[0] = estimate_0;
    estimate[1] = estimate_1;
    estimate[2] = estimate_2;
    found[0] = found_0;
    return TB_OK;
}

/* Pose and residual of the last estimate. */
static tb_status tb_forward_kinematics_finish(const real_t lengths[6], const real_t rails[6],
    const real_t estimate[3], real_t pose[3], real_t residual[1])
{
    const real_t t0 = estimate[2] * estimate[2] * TB_C(0.25);
    const real_t t1 = -TB_C(2.4795962632247972e-27) + t0 * TB_C(3.279889237069838e-30);
    const real_t t2 = -TB_C(8.896791392450574e-22) + t0 * (TB_C(1.6117375710961184e-24) + t0 *
        t1);
    const real_t t3 = -TB_C(1.5619206968586225e-16) + t0 * (TB_C(4.110317623312165e-19) + t0 *
        t2);
    const real_t t4 = -TB_C(1.1470745597729725e-11) + t0 * (TB_C(4.779477332387385e-14) + t0 *
        t3);
    const real_t t5 = -TB_C(2.755731922398589e-07) + t0 * (TB_C(2.08767569878681e-09) + t0 *
        t4);
    const real_t t6 = -TB_C(0.001388888888888889) + t0 * (TB_C(2.48015873015873e-05) + t0 * t5);
    const real_t t7 = -TB_C(0.5) + t0 * (TB_C(0.041666666666666664) + t0 * t6);
    const real_t t8 = TB_C(1.0) + t0 * t7;
    const real_t t9 = TB_C(6.446950284384474e-26) + t0 * -TB_C(9.183689863795546e-29);
    const real_t t10 = TB_C(1.9572941063391263e-20) + t0 * (-TB_C(3.8681701706306835e-23) + t0
        * t9);
    const real_t t11 = TB_C(2.8114572543455206e-15) + t0 * (-TB_C(8.22063524662433e-18) + t0 *
        t10);
    const real_t t12 = TB_C(1.6059043836821613e-10) + t0 * (-TB_C(7.647163731819816e-13) + t0 *
        t11);
    const real_t t13 = TB_C(2.7557319223985893e-06) + t0 * (-TB_C(2.505210838544172e-08) + t0 *
        t12);
    const real_t t14 = TB_C(0.008333333333333333) + t0 * (-TB_C(0.0001984126984126984) + t0 *
        t13);
    const real_t t15 = TB_C(1.0) + t0 * (-TB_C(0.16666666666666666) + t0 * t14);
    const real_t t16 = estimate[2] * (t15 * TB_C(0.5));
    const real_t t17 = t8 * t8 - t16 * t16;
    const real_t t18 = -TB_C(0.04) * t17;
    const real_t t19 = t16 * (t8 * TB_C(2.0));
    const real_t t20 = -TB_C(0.025) * t19;
    const real_t t21 = t18 - t20;
    const real_t t22 = rails[0] - (estimate[0] + t21);
    const real_t t23 = -TB_C(0.04) * t19;
    const real_t t24 = t17 * -TB_C(0.025);
    const real_t t25 = t23 + t24;
    const real_t t26 = estimate[1] + t25;
    const real_t t27 = TB_SQRT(t22 * t22 + t26 * t26);
    /* what the lengths disagree by: slack, an encoder fault */
    const real_t misfit_0 = lengths[0] - t27;
    const real_t t28 = t17 * TB_C(0.04);
    const real_t t29 = t28 - t20;
    const real_t t30 = rails[1] - (estimate[0] + t29);
    const real_t t31 = t19 * TB_C(0.04);
    const real_t t32 = t24 + t31;
    const real_t t33 = estimate[1] + t32;
    const real_t t34 = TB_SQRT(t30 * t30 + t33 * t33);
    const real_t misfit_1 = lengths[1] - t34;
    const real_t t35 = t17 * TB_LONGEST_ARM;
    const real_t t36 = TB_FRAME_X - (estimate[0] + t35);
    const real_t t37 = t19 * TB_LONGEST_ARM;
    const real_t t38 = rails[2] - (estimate[1] + t37);
    const real_t t39 = TB_SQRT(t36 * t36 + t38 * t38);
    const real_t misfit_2 = lengths[2] - t39;
    const real_t t40 = misfit_0 * misfit_0 + misfit_1 * misfit_1 + misfit_2 * misfit_2;
    const real_t t41 = t19 * TB_C(0.025);
    const real_t t42 = t28 - t41;
    const real_t t43 = rails[3] - (estimate[0] + t42);
    const real_t t44 = t17 * TB_C(0.025);
    const real_t t45 = t31 + t44;
    const real_t t46 = TB_FRAME_Y - (estimate[1] + t45);
    const real_t t47 = TB_SQRT(t43 * t43 + t46 * t46);
    const real_t misfit_3 = lengths[3] - t47;
    const real_t t48 = t18 - t41;
    const real_t t49 = rails[4] - (estimate[0] + t48);
    const real_t t50 = t23 + t44;
    const real_t t51 = TB_FRAME_Y - (estimate[1] + t50);
    const real_t t52 = TB_SQRT(t49 * t49 + t51 * t51);
    const real_t misfit_4 = lengths[4] - t52;
    const real_t t53 = t17 * TB_ANCHOR_6_X;
    const real_t t54 = estimate[0] + t53;
    const real_t t55 = t19 * TB_ANCHOR_6_X;
    const real_t t56 = rails[5] - (estimate[1] + t55);
    const real_t t57 = TB_SQRT(t54 * t54 + t56 * t56);
    const real_t misfit_5 = lengths[5] - t57;
    const real_t t58 = t40 + misfit_3 * misfit_3 + misfit_4 * misfit_4 + misfit_5 * misfit_5;
    const real_t residual_0 = TB_SQRT(t58);
    const bool t59 = TB_C(0.0001) < t27 && TB_C(0.0001) < t34 && TB_C(0.0001) < t39;
    const bool t60 = t59 && TB_C(0.0001) < t47 && TB_C(0.0001) < t52 && TB_C(0.0001) < t57;
    const bool t61 = !t60;
    const real_t t62 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const real_t t63 = TB_C(1.0) / t27;
    const real_t t64 = t22 * t63;
    const real_t t65 = TB_C(1.0) / t34;
    const real_t t66 = t30 * t65;
    const real_t t67 = TB_C(1.0) / t39;
    const real_t t68 = t36 * t67;
    const real_t t69 = TB_C(1.0) / t47;
    const real_t t70 = t43 * t69;
    const real_t t71 = TB_C(1.0) / t52;
    const real_t t72 = t49 * t71;
    const real_t t73 = t64 * t64 + t66 * t66 + t68 * t68 + t70 * t70 + t72 * t72;
    const real_t t74 = TB_C(1.0) / t57;
    const real_t t75 = t54 * t74;
    const real_t t76 = t73 + t75 * t75;
    const real_t t77 = t26 * t63;
    const real_t t78 = t33 * t65;
    const real_t t79 = t38 * t67;
    const real_t t80 = t46 * t69;
    const real_t t81 = t51 * t71;
    const real_t t82 = t77 * t77 + t78 * t78 + t79 * t79 + t80 * t80 + t81 * t81;
    const real_t t83 = t56 * t74;
    const real_t t84 = t68 * t79 - (t64 * t77 + t66 * t78) + t70 * t80 + t72 * t81;
    const real_t t85 = TB_C(1.0) / t76;
    const real_t t86 = (t84 - t75 * t83) * t85;
    const real_t t87 = t82 + t83 * t83 - t76 * (t86 * t86);
    const real_t t88 = (t21 * t77 + t25 * t64) * TB_MOMENT_WEIGHT;
    const real_t t89 = TB_MOMENT_WEIGHT * (t29 * t78 + t32 * t66);
    const real_t t90 = TB_MOMENT_WEIGHT * (t35 * t79 - t37 * t68);
    const real_t t91 = TB_MOMENT_WEIGHT * (t42 * t80 - t45 * t70);
    const real_t t92 = TB_MOMENT_WEIGHT * (t48 * t81 - t50 * t72);
    const real_t t93 = t88 * t88 + t89 * t89 + t90 * t90 + t91 * t91 + t92 * t92;
    const real_t t94 = TB_MOMENT_WEIGHT * (t53 * t83 + t55 * t75);
    const real_t t95 = t68 * t90 - (t64 * t88 + t66 * t89) + t70 * t91 + t72 * t92;
    const real_t t96 = t85 * (t95 - t75 * t94);
    const real_t t97 = t77 * t88 + t78 * t89 + t79 * t90 + t80 * t91 + t81 * t92;
    const real_t t98 = (t97 + t83 * t94 - t76 * (t86 * t96)) / t87;
    const real_t t99 = t93 + t94 * t94 - t76 * (t96 * t96) - t87 * (t98 * t98);
    const bool t100 = !(t62 < t76 && t62 < t87 && t62 < t99);
    if (t61 || t100) {
        pose[0] = TB_C(0.0);
        pose[1] = TB_C(0.0);
        pose[2] = TB_C(0.0);
        residual[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    pose[0] = estimate[0];
    pose[1] = estimate[1];
    pose[2] = estimate[2];
    residual[0] = residual_0;
    return TB_OK;
}

tb_status tb_forward_kinematics(const real_t guess[3], const real_t lengths[6],
    const real_t rails[6], real_t pose[3], real_t residual[1])
{
    real_t estimate[3];
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
        residual[0] = TB_C(0.0);
        return status;
    }
    return tb_forward_kinematics_finish(lengths, rails, estimate, pose, residual);
}

/* The guess is the first estimate. */
static tb_status tb_locate_begin(const real_t guess[3], const real_t lengths[6], const real_t rails[6],
    const real_t length_rates[6], const real_t rail_rates[6], real_t estimate[3])
{
    if (!(guess[0] >= -TB_C(1.4236) && guess[0] <= TB_C(1.4236)
          && guess[1] >= -TB_C(1.4236) && guess[1] <= TB_C(1.4236)
          && guess[2] >= -TB_C(1.2853981633974483) && guess[2] <= TB_C(1.2853981633974483)
          && lengths[0] >= TB_C(0.0) && lengths[0] <= TB_C(4.6944)
          && lengths[1] >= TB_C(0.0) && lengths[1] <= TB_C(4.6944)
          && lengths[2] >= TB_C(0.0) && lengths[2] <= TB_C(4.6944)
          && lengths[3] >= TB_C(0.0) && lengths[3] <= TB_C(4.6944)
          && lengths[4] >= TB_C(0.0) && lengths[4] <= TB_C(4.6944)
          && lengths[5] >= TB_C(0.0) && lengths[5] <= TB_C(4.6944)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) +
              TB_ABS(rails[4]) + TB_ABS(rails[5]) <= TB_C(8.541599999999999)
          && TB_ABS(length_rates[0]) + TB_ABS(length_rates[1]) + TB_ABS(length_rates[2]) +
              TB_ABS(length_rates[3]) + TB_ABS(length_rates[4]) + TB_ABS(length_rates[5]) <=
              TB_C(600.0)
          && TB_ABS(rail_rates[0]) + TB_ABS(rail_rates[1]) + TB_ABS(rail_rates[2]) +
              TB_ABS(rail_rates[3]) + TB_ABS(rail_rates[4]) + TB_ABS(rail_rates[5]) <=
              TB_C(600.0))) {
        estimate[0] = TB_C(0.0);
        estimate[1] = TB_C(0.0);
        estimate[2] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    estimate[0] = guess[0];
    estimate[1] = guess[1];
    estimate[2] = guess[2];
    return TB_OK;
}

/* Gauss-Newton step on the misfit of the lengths. */
static tb_status tb_locate_step(const real_t lengths[6], const real_t rails[6], real_t estimate[3],
    real_t found[1])
{
    const real_t t0 = estimate[2] * estimate[2] * TB_C(0.25);
    const real_t t1 = -TB_C(2.4795962632247972e-27) + t0 * TB_C(3.279889237069838e-30);
    const real_t t2 = -TB_C(8.896791392450574e-22) + t0 * (TB_C(1.6117375710961184e-24) + t0 *
        t1);
    const real_t t3 = -TB_C(1.5619206968586225e-16) + t0 * (TB_C(4.110317623312165e-19) + t0 *
        t2);
    const real_t t4 = -TB_C(1.1470745597729725e-11) + t0 * (TB_C(4.779477332387385e-14) + t0 *
        t3);
    const real_t t5 = -TB_C(2.755731922398589e-07) + t0 * (TB_C(2.08767569878681e-09) + t0 *
        t4);
    const real_t t6 = -TB_C(0.001388888888888889) + t0 * (TB_C(2.48015873015873e-05) + t0 * t5);
    const real_t t7 = -TB_C(0.5) + t0 * (TB_C(0.041666666666666664) + t0 * t6);
    const real_t t8 = TB_C(1.0) + t0 * t7;
    const real_t t9 = TB_C(6.446950284384474e-26) + t0 * -TB_C(9.183689863795546e-29);
    const real_t t10 = TB_C(1.9572941063391263e-20) + t0 * (-TB_C(3.8681701706306835e-23) + t0
        * t9);
    const real_t t11 = TB_C(2.8114572543455206e-15) + t0 * (-TB_C(8.22063524662433e-18) + t0 *
        t10);
    const real_t t12 = TB_C(1.6059043836821613e-10) + t0 * (-TB_C(7.647163731819816e-13) + t0 *
        t11);
    const real_t t13 = TB_C(2.7557319223985893e-06) + t0 * (-TB_C(2.505210838544172e-08) + t0 *
        t12);
    const real_t t14 = TB_C(0.008333333333333333) + t0 * (-TB_C(0.0001984126984126984) + t0 *
        t13);
    const real_t t15 = TB_C(1.0) + t0 * (-TB_C(0.16666666666666666) + t0 * t14);
    const real_t t16 = estimate[2] * (t15 * TB_C(0.5));
    const real_t t17 = t8 * t8 - t16 * t16;
    const real_t t18 = TB_ANCHOR_6_X * t17;
    const real_t t19 = estimate[0] + t18;
    const real_t t20 = t16 * (t8 * TB_C(2.0));
    const real_t t21 = TB_ANCHOR_6_X * t20;
    const real_t t22 = rails[5] - (estimate[1] + t21);
    const real_t t23 = TB_SQRT(t19 * t19 + t22 * t22);
    const real_t t24 = TB_C(1.0) / t23;
    const real_t t25 = t19 * t24;
    const real_t t26 = lengths[5] - t23;
    const real_t t27 = t17 * -TB_C(0.04);
    const real_t t28 = t20 * -TB_C(0.025);
    const real_t t29 = t27 - t28;
    const real_t t30 = rails[0] - (estimate[0] + t29);
    const real_t t31 = t20 * -TB_C(0.04);
    const real_t t32 = t17 * -TB_C(0.025);
    const real_t t33 = t31 + t32;
    const real_t t34 = estimate[1] + t33;
    const real_t t35 = TB_SQRT(t30 * t30 + t34 * t34);
    const real_t t36 = TB_C(1.0) / t35;
    const real_t t37 = t30 * t36;
    const real_t t38 = lengths[0] - t35;
    const real_t t39 = t17 * TB_C(0.04);
    const real_t t40 = t39 - t28;
    const real_t t41 = rails[1] - (estimate[0] + t40);
    const real_t t42 = t20 * TB_C(0.04);
    const real_t t43 = t32 + t42;
    const real_t t44 = estimate[1] + t43;
    const real_t t45 = TB_SQRT(t41 * t41 + t44 * t44);
    const real_t t46 = TB_C(1.0) / t45;
    const real_t t47 = t41 * t46;
    const real_t t48 = lengths[1] - t45;
    const real_t t49 = t17 * TB_LONGEST_ARM;
    const real_t t50 = TB_FRAME_X - (estimate[0] + t49);
    const real_t t51 = t20 * TB_LONGEST_ARM;
    const real_t t52 = rails[2] - (estimate[1] + t51);
    const real_t t53 = TB_SQRT(t50 * t50 + t52 * t52);
    const real_t t54 = TB_C(1.0) / t53;
    const real_t t55 = t50 * t54;
    const real_t t56 = lengths[2] - t53;
    const real_t t57 = t20 * TB_C(0.025);
    const real_t t58 = t39 - t57;
    const real_t t59 = rails[3] - (estimate[0] + t58);
    const real_t t60 = t17 * TB_C(0.025);
    const real_t t61 = t42 + t60;
    const real_t t62 = TB_FRAME_Y - (estimate[1] + t61);
    const real_t t63 = TB_SQRT(t59 * t59 + t62 * t62);
    const real_t t64 = TB_C(1.0) / t63;
    const real_t t65 = t59 * t64;
    const real_t t66 = lengths[3] - t63;
    const real_t t67 = t27 - t57;
    const real_t t68 = rails[4] - (estimate[0] + t67);
    const real_t t69 = t31 + t60;
    const real_t t70 = TB_FRAME_Y - (estimate[1] + t69);
    const real_t t71 = TB_SQRT(t68 * t68 + t70 * t70);
    const real_t t72 = TB_C(1.0) / t71;
    const real_t t73 = t68 * t72;
    const real_t t74 = lengths[4] - t71;
    const real_t t75 = t37 * t38 + t47 * t48 + t55 * t56 + t65 * t66 + t73 * t74;
    const real_t t76 = t25 * t26 - t75;
    const real_t t77 = t37 * t37 + t47 * t47 + t55 * t55 + t65 * t65 + t73 * t73;
    const real_t t78 = t77 + t25 * t25;
    const real_t t79 = TB_C(1.0) / t78;
    const real_t t80 = t52 * t54;
    const real_t t81 = t34 * t36;
    const real_t t82 = t44 * t46;
    const real_t t83 = t62 * t64;
    const real_t t84 = t70 * t72;
    const real_t t85 = t55 * t80 - (t37 * t81 + t47 * t82) + t65 * t83 + t73 * t84;
    const real_t t86 = t22 * t24;
    const real_t t87 = t79 * (t85 - t25 * t86);
    const real_t t88 = t38 * t81 + t48 * t82 - t56 * t80 - t66 * t83 - t74 * t84;
    const real_t t89 = t88 - t26 * t86;
    const real_t t90 = t89 - t76 * t87;
    const real_t t91 = t81 * t81 + t82 * t82 + t80 * t80 + t83 * t83 + t84 * t84;
    const real_t t92 = t91 + t86 * t86 - t78 * (t87 * t87);
    const real_t t93 = TB_C(1.0) / t92;
    const real_t t94 = (t29 * t81 + t33 * t37) * TB_MOMENT_WEIGHT;
    const real_t t95 = TB_MOMENT_WEIGHT * (t40 * t82 + t43 * t47);
    const real_t t96 = TB_MOMENT_WEIGHT * (t49 * t80 - t51 * t55);
    const real_t t97 = TB_MOMENT_WEIGHT * (t58 * t83 - t61 * t65);
    const real_t t98 = TB_MOMENT_WEIGHT * (t67 * t84 - t69 * t73);
    const real_t t99 = t81 * t94 + t82 * t95 + t80 * t96 + t83 * t97 + t84 * t98;
    const real_t t100 = TB_MOMENT_WEIGHT * (t18 * t86 + t21 * t25);
    const real_t t101 = t55 * t96 - (t37 * t94 + t47 * t95) + t65 * t97 + t73 * t98;
    const real_t t102 = t79 * (t101 - t25 * t100);
    const real_t t103 = t93 * (t99 + t86 * t100 - t78 * (t87 * t102));
    const real_t t104 = t38 * t94 + t48 * t95 - t56 * t96 - t66 * t97 - t74 * t98;
    const real_t t105 = t104 - t26 * t100;
    const real_t t106 = t94 * t94 + t95 * t95 + t96 * t96 + t97 * t97 + t98 * t98;
    const real_t t107 = t106 + t100 * t100 - t78 * (t102 * t102) - t92 * (t103 * t103);
    const real_t t108 = (t105 - t76 * t102 - t90 * t103) / t107;
    const real_t t109 = t90 * t93 - t103 * t108;
    const real_t t110 = t76 * t79 - t87 * t109 - t102 * t108;
    const real_t t111 = TB_SQRT(t110 * t110 + t109 * t109) * TB_C(4.714312097910988);
    const real_t t112 = tb_max(TB_C(1.0), TB_ABS(t108) * TB_C(40.066833797650666));
    const real_t t113 = tb_min(TB_C(1.0) / tb_max(TB_C(1.0), t111), TB_C(1.0) / t112);
    const real_t estimate_0 = tb_min(tb_max(estimate[0] + t110 * t113, -TB_C(1.4236)),
        TB_C(1.4236));
    const real_t estimate_1 = tb_min(tb_max(estimate[1] + t109 * t113, -TB_C(1.4236)),
        TB_C(1.4236));
    const real_t t114 = estimate[2] + TB_MOMENT_WEIGHT * (t108 * t113);
    const real_t estimate_2 = tb_min(tb_max(t114, -TB_C(1.2853981633974483)),
        TB_C(1.2853981633974483));
    const real_t t115 = TB_C(13.575681599094757) * TB_EPSILON;
    const real_t t116 = t38 * t38 + t48 * t48 + t56 * t56 + t66 * t66 + t74 * t74;
    const bool t117 = t76 * t110 + t89 * t109 + t105 * t108 <= t115 * t115 + TB_C(1e-18) *
        (t116 + t26 * t26);
    const real_t found_0 = t117 ? TB_C(1.0) : TB_C(0.0);
    const bool t118 = TB_C(0.0001) < t35 && TB_C(0.0001) < t45 && TB_C(0.0001) < t53;
    const bool t119 = t118 && TB_C(0.0001) < t63 && TB_C(0.0001) < t71 && TB_C(0.0001) < t23;
    const bool t120 = !t119;
    const real_t t121 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t122 = !(t121 < t78 && t121 < t92 && t121 < t107);
    if (t120 || t122) {
        estimate[0] = TB_C(0.0);
        estimate[1] = TB_C(0.0);
        estimate[2] = TB_C(0.0);
        found[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    estimate[0] = estimate_0;
    estimate[1] = estimate_1;
    estimate[2] = estimate_2;
    found[0] = found_0;
    return TB_OK;
}

/* Everything at the last estimate. */
static tb_status tb_locate_finish(const real_t lengths[6], const real_t rails[6],
    const real_t length_rates[6], const real_t rail_rates[6], const real_t estimate[3],
    real_t pose[3], real_t residual[1], real_t structure[18], real_t velocity[3])
{
    const real_t t0 = estimate[2] * estimate[2] * TB_C(0.25);
    const real_t t1 = -TB_C(2.4795962632247972e-27) + t0 * TB_C(3.279889237069838e-30);
    const real_t t2 = -TB_C(8.896791392450574e-22) + t0 * (TB_C(1.6117375710961184e-24) + t0 *
        t1);
    const real_t t3 = -TB_C(1.5619206968586225e-16) + t0 * (TB_C(4.110317623312165e-19) + t0 *
        t2);
    const real_t t4 = -TB_C(1.1470745597729725e-11) + t0 * (TB_C(4.779477332387385e-14) + t0 *
        t3);
    const real_t t5 = -TB_C(2.755731922398589e-07) + t0 * (TB_C(2.08767569878681e-09) + t0 *
        t4);
    const real_t t6 = -TB_C(0.001388888888888889) + t0 * (TB_C(2.48015873015873e-05) + t0 * t5);
    const real_t t7 = -TB_C(0.5) + t0 * (TB_C(0.041666666666666664) + t0 * t6);
    const real_t t8 = TB_C(1.0) + t0 * t7;
    const real_t t9 = TB_C(6.446950284384474e-26) + t0 * -TB_C(9.183689863795546e-29);
    const real_t t10 = TB_C(1.9572941063391263e-20) + t0 * (-TB_C(3.8681701706306835e-23) + t0
        * t9);
    const real_t t11 = TB_C(2.8114572543455206e-15) + t0 * (-TB_C(8.22063524662433e-18) + t0 *
        t10);
    const real_t t12 = TB_C(1.6059043836821613e-10) + t0 * (-TB_C(7.647163731819816e-13) + t0 *
        t11);
    const real_t t13 = TB_C(2.7557319223985893e-06) + t0 * (-TB_C(2.505210838544172e-08) + t0 *
        t12);
    const real_t t14 = TB_C(0.008333333333333333) + t0 * (-TB_C(0.0001984126984126984) + t0 *
        t13);
    const real_t t15 = TB_C(1.0) + t0 * (-TB_C(0.16666666666666666) + t0 * t14);
    const real_t t16 = estimate[2] * (t15 * TB_C(0.5));
    const real_t t17 = t8 * t8 - t16 * t16;
    const real_t t18 = -TB_C(0.04) * t17;
    const real_t t19 = t16 * (t8 * TB_C(2.0));
    const real_t t20 = -TB_C(0.025) * t19;
    const real_t t21 = t18 - t20;
    const real_t t22 = rails[0] - (estimate[0] + t21);
    const real_t t23 = -TB_C(0.04) * t19;
    const real_t t24 = t17 * -TB_C(0.025);
    const real_t t25 = t23 + t24;
    const real_t t26 = estimate[1] + t25;
    const real_t t27 = TB_SQRT(t22 * t22 + t26 * t26);
    /* what the lengths disagree by: slack, an encoder fault */
    const real_t misfit_0 = lengths[0] - t27;
    const real_t t28 = t17 * TB_C(0.04);
    const real_t t29 = t28 - t20;
    const real_t t30 = rails[1] - (estimate[0] + t29);
    const real_t t31 = t19 * TB_C(0.04);
    const real_t t32 = t24 + t31;
    const real_t t33 = estimate[1] + t32;
    const real_t t34 = TB_SQRT(t30 * t30 + t33 * t33);
    const real_t misfit_1 = lengths[1] - t34;
    const real_t t35 = t17 * TB_LONGEST_ARM;
    const real_t t36 = TB_FRAME_X - (estimate[0] + t35);
    const real_t t37 = t19 * TB_LONGEST_ARM;
    const real_t t38 = rails[2] - (estimate[1] + t37);
    const real_t t39 = TB_SQRT(t36 * t36 + t38 * t38);
    const real_t misfit_2 = lengths[2] - t39;
    const real_t t40 = misfit_0 * misfit_0 + misfit_1 * misfit_1 + misfit_2 * misfit_2;
    const real_t t41 = t19 * TB_C(0.025);
    const real_t t42 = t28 - t41;
    const real_t t43 = rails[3] - (estimate[0] + t42);
    const real_t t44 = t17 * TB_C(0.025);
    const real_t t45 = t31 + t44;
    const real_t t46 = TB_FRAME_Y - (estimate[1] + t45);
    const real_t t47 = TB_SQRT(t43 * t43 + t46 * t46);
    const real_t misfit_3 = lengths[3] - t47;
    const real_t t48 = t18 - t41;
    const real_t t49 = rails[4] - (estimate[0] + t48);
    const real_t t50 = t23 + t44;
    const real_t t51 = TB_FRAME_Y - (estimate[1] + t50);
    const real_t t52 = TB_SQRT(t49 * t49 + t51 * t51);
    const real_t misfit_4 = lengths[4] - t52;
    const real_t t53 = t17 * TB_ANCHOR_6_X;
    const real_t t54 = estimate[0] + t53;
    const real_t t55 = t19 * TB_ANCHOR_6_X;
    const real_t t56 = rails[5] - (estimate[1] + t55);
    const real_t t57 = TB_SQRT(t54 * t54 + t56 * t56);
    const real_t misfit_5 = lengths[5] - t57;
    const real_t t58 = t40 + misfit_3 * misfit_3 + misfit_4 * misfit_4 + misfit_5 * misfit_5;
    const real_t residual_0 = TB_SQRT(t58);
    const real_t t59 = TB_C(1.0) / t27;
    const real_t structure_0 = t22 * t59;
    const real_t t60 = TB_C(1.0) / t34;
    const real_t structure_1 = t30 * t60;
    const real_t t61 = TB_C(1.0) / t39;
    const real_t structure_2 = t36 * t61;
    const real_t t62 = TB_C(1.0) / t47;
    const real_t structure_3 = t43 * t62;
    const real_t t63 = TB_C(1.0) / t52;
    const real_t structure_4 = t49 * t63;
    const real_t t64 = TB_C(1.0) / t57;
    const real_t t65 = t54 * t64;
    const real_t structure_5 = -t65;
    const real_t t66 = t26 * t59;
    const real_t structure_6 = -t66;
    const real_t t67 = t33 * t60;
    const real_t structure_7 = -t67;
    const real_t structure_8 = t38 * t61;
    const real_t structure_9 = t46 * t62;
    const real_t structure_10 = t51 * t63;
    const real_t structure_11 = t56 * t64;
    const real_t t68 = t21 * t66 + t25 * structure_0;
    const real_t structure_12 = -t68;
    const real_t t69 = t29 * t67 + t32 * structure_1;
    const real_t structure_13 = -t69;
    const real_t structure_14 = t35 * structure_8 - t37 * structure_2;
    const real_t structure_15 = t42 * structure_9 - t45 * structure_3;
    const real_t structure_16 = t48 * structure_10 - t50 * structure_4;
    const real_t structure_17 = t53 * structure_11 + t55 * t65;
    const real_t t70 = length_rates[0] - structure_0 * rail_rates[0];
    const real_t t71 = length_rates[1] - structure_1 * rail_rates[1];
    const real_t t72 = length_rates[2] - structure_8 * rail_rates[2];
    const real_t t73 = structure_0 * t70 + structure_1 * t71 + structure_2 * t72;
    const real_t t74 = length_rates[3] - structure_3 * rail_rates[3];
    const real_t t75 = length_rates[4] - structure_4 * rail_rates[4];
    const real_t t76 = length_rates[5] - structure_11 * rail_rates[5];
    const real_t t77 = t73 + structure_3 * t74 + structure_4 * t75 - t65 * t76;
    const real_t t78 = structure_0 * structure_0 + structure_1 * structure_1;
    const real_t t79 = t78 + structure_2 * structure_2 + structure_3 * structure_3;
    const real_t t80 = t79 + structure_4 * structure_4 + t65 * t65;
    const real_t t81 = TB_C(1.0) / t80;
    const real_t t82 = structure_2 * structure_8 - (structure_0 * t66 + structure_1 * t67);
    const real_t t83 = t82 + structure_3 * structure_9 + structure_4 * structure_10;
    const real_t t84 = t81 * (t83 - t65 * structure_11);
    const real_t t85 = structure_8 * t72 - (t66 * t70 + t67 * t71) + structure_9 * t74;
    const real_t t86 = t77 * t84 - (t85 + structure_10 * t75 + structure_11 * t76);
    const real_t t87 = t66 * t66 + t67 * t67 + structure_8 * structure_8;
    const real_t t88 = t87 + structure_9 * structure_9 + structure_10 * structure_10;
    const real_t t89 = t88 + structure_11 * structure_11 - t80 * (t84 * t84);
    const real_t t90 = TB_C(1.0) / t89;
    const real_t t91 = t68 * TB_MOMENT_WEIGHT;
    const real_t t92 = t69 * TB_MOMENT_WEIGHT;
    const real_t t93 = structure_14 * TB_MOMENT_WEIGHT;
    const real_t t94 = structure_15 * TB_MOMENT_WEIGHT;
    const real_t t95 = t66 * t91 + t67 * t92 + structure_8 * t93 + structure_9 * t94;
    const real_t t96 = structure_16 * TB_MOMENT_WEIGHT;
    const real_t t97 = structure_17 * TB_MOMENT_WEIGHT;
    const real_t t98 = structure_2 * t93 - (structure_0 * t91 + structure_1 * t92);
    const real_t t99 = t98 + structure_3 * t94 + structure_4 * t96 - t65 * t97;
    const real_t t100 = t81 * t99;
    const real_t t101 = t95 + structure_10 * t96 + structure_11 * t97 - t80 * (t84 * t100);
    const real_t t102 = t90 * t101;
    const real_t t103 = t72 * t93 - (t70 * t91 + t71 * t92) + t74 * t94 + t75 * t96;
    const real_t t104 = t91 * t91 + t92 * t92 + t93 * t93 + t94 * t94 + t96 * t96;
    const real_t t105 = t104 + t97 * t97 - t80 * (t100 * t100) - t89 * (t102 * t102);
    const real_t t106 = (t77 * t100 - (t103 + t76 * t97) - t86 * t102) / t105;
    const real_t velocity_1 = t86 * t90 - t102 * t106;
    const real_t velocity_0 = -(t77 * t81 + t84 * velocity_1 + t100 * t106);
    const real_t velocity_2 = TB_MOMENT_WEIGHT * t106;
    const bool t107 = TB_C(0.0001) < t27 && TB_C(0.0001) < t34 && TB_C(0.0001) < t39;
    const bool t108 = t107 && TB_C(0.0001) < t47 && TB_C(0.0001) < t52 && TB_C(0.0001) < t57;
    const bool t109 = !t108;
    const real_t t110 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const bool t111 = !(t110 < t80 && t110 < t89 && t110 < t105);
    if (t109 || t111) {
        pose[0] = TB_C(0.0);
        pose[1] = TB_C(0.0);
        pose[2] = TB_C(0.0);
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
        velocity[0] = TB_C(0.0);
        velocity[1] = TB_C(0.0);
        velocity[2] = TB_C(0.0);
        return TB_SINGULAR;
    }
    pose[0] = estimate[0];
    pose[1] = estimate[1];
    pose[2] = estimate[2];
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
    velocity[0] = velocity_0;
    velocity[1] = velocity_1;
    velocity[2] = velocity_2;
    return TB_OK;
}

tb_status tb_locate(const real_t guess[3], const real_t lengths[6], const real_t rails[6],
    const real_t length_rates[6], const real_t rail_rates[6], real_t pose[3],
    real_t residual[1], real_t structure[18], real_t velocity[3])
{
    real_t estimate[3];
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
        velocity[0] = TB_C(0.0);
        velocity[1] = TB_C(0.0);
        velocity[2] = TB_C(0.0);
        return status;
    }
    return tb_locate_finish(lengths, rails, length_rates, rail_rates, estimate, pose, residual,
        structure, velocity);
}

