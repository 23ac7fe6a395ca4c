/* Regenerate: turnbuckle generate machines/planar_rigid.toml --out <this folder>
 * Machine 95fa38e7104ced7a, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_statics.h"
#include "tb_machine.h"

tb_status tb_wrench(const real_t structure[18], const real_t tension[6], real_t wrench[3])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) + TB_ABS(structure[10]) + TB_ABS(structure[11]) +
              TB_ABS(structure[12]) + TB_ABS(structure[13]) + TB_ABS(structure[14]) +
              TB_ABS(structure[15]) + TB_ABS(structure[16]) + TB_ABS(structure[17]) <=
              TB_C(72.0)
          && TB_ABS(tension[0]) + TB_ABS(tension[1]) + TB_ABS(tension[2]) + TB_ABS(tension[3])
              + TB_ABS(tension[4]) + TB_ABS(tension[5]) <= TB_C(60000.0))) {
        wrench[0] = TB_C(0.0);
        wrench[1] = TB_C(0.0);
        wrench[2] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = structure[0] * tension[0] + structure[1] * tension[1];
    const real_t t1 = t0 + structure[2] * tension[2] + structure[3] * tension[3];
    const real_t wrench_0 = t1 + structure[4] * tension[4] + structure[5] * tension[5];
    const real_t t2 = tension[0] * structure[6] + tension[1] * structure[7];
    const real_t t3 = t2 + tension[2] * structure[8] + tension[3] * structure[9];
    const real_t wrench_1 = t3 + tension[4] * structure[10] + tension[5] * structure[11];
    const real_t t4 = tension[0] * structure[12] + tension[1] * structure[13];
    const real_t t5 = t4 + tension[2] * structure[14] + tension[3] * structure[15];
    const real_t wrench_2 = t5 + tension[4] * structure[16] + tension[5] * structure[17];
    wrench[0] = wrench_0;
    wrench[1] = wrench_1;
    wrench[2] = wrench_2;
    return TB_OK;
}

/* Refuses with a status: share is 0 N. */
static tb_status tb_refuse_wrench_share_eq10(tb_status status, real_t share[6])
{
    share[0] = TB_C(0.0);
    share[1] = TB_C(0.0);
    share[2] = TB_C(0.0);
    share[3] = TB_C(0.0);
    share[4] = TB_C(0.0);
    share[5] = TB_C(0.0);
    return status;
}

tb_status tb_wrench_share_eq10(const real_t pose[3], const real_t rails[6],
    const real_t wrench[3], real_t share[6])
{
    if (!(pose[0] >= -TB_C(1.4236) && pose[0] <= TB_C(1.4236)
          && pose[1] >= -TB_C(1.4236) && pose[1] <= TB_C(1.4236)
          && pose[2] >= -TB_C(1.2853981633974483) && pose[2] <= TB_C(1.2853981633974483)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) +
              TB_ABS(rails[4]) + TB_ABS(rails[5]) <= TB_C(8.541599999999999)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) + TB_ABS(wrench[2]) <= TB_C(180000.0))) {
        return tb_refuse_wrench_share_eq10(TB_OUT_OF_DOMAIN, share);
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
    const real_t t21 = t18 - t20;
    const real_t t22 = rails[0] - (pose[0] + t21);
    const real_t t23 = t22 * t22;
    const real_t t24 = -TB_C(0.04) * t19;
    const real_t t25 = t17 * -TB_C(0.025);
    const real_t t26 = t24 + t25;
    const real_t t27 = pose[1] + t26;
    const real_t t28 = t27 * t27;
    const real_t t29 = TB_SQRT(t23 + t28);
    const real_t t30 = t17 * TB_C(0.04);
    const real_t t31 = t30 - t20;
    const real_t t32 = rails[1] - (pose[0] + t31);
    const real_t t33 = t32 * t32;
    const real_t t34 = t17 * TB_LONGEST_ARM;
    const real_t t35 = TB_FRAME_X - (pose[0] + t34);
    const real_t t36 = t35 * t35;
    const real_t t37 = t19 * TB_C(0.025);
    const real_t t38 = t30 - t37;
    const real_t t39 = rails[3] - (pose[0] + t38);
    const real_t t40 = t39 * t39;
    const real_t t41 = t18 - t37;
    const real_t t42 = rails[4] - (pose[0] + t41);
    const real_t t43 = t42 * t42;
    const real_t t44 = t17 * TB_ANCHOR_6_X;
    const real_t t45 = pose[0] + t44;
    const real_t t46 = t45 * t45;
    const real_t t47 = t23 + t33 + t36 + t40 + t43 + t46;
    const real_t t48 = TB_C(1.0) / t47;
    const real_t t49 = t19 * TB_LONGEST_ARM;
    const real_t t50 = rails[2] - (pose[1] + t49);
    const real_t t51 = t19 * TB_C(0.04);
    const real_t t52 = t25 + t51;
    const real_t t53 = pose[1] + t52;
    const real_t t54 = t17 * TB_C(0.025);
    const real_t t55 = t51 + t54;
    const real_t t56 = TB_FRAME_Y - (pose[1] + t55);
    const real_t t57 = t24 + t54;
    const real_t t58 = TB_FRAME_Y - (pose[1] + t57);
    const real_t t59 = t35 * t50 - (t22 * t27 + t32 * t53) + t39 * t56 + t42 * t58;
    const real_t t60 = t19 * TB_ANCHOR_6_X;
    const real_t t61 = rails[5] - (pose[1] + t60);
    const real_t t62 = t48 * (t59 - t45 * t61);
    const real_t t63 = wrench[1] - wrench[0] * t62;
    const real_t t64 = t53 * t53;
    const real_t t65 = t50 * t50;
    const real_t t66 = t56 * t56;
    const real_t t67 = t58 * t58;
    const real_t t68 = t61 * t61;
    const real_t t69 = t28 + t64 + t65 + t66 + t67 + t68 - t47 * (t62 * t62);
    const real_t t70 = TB_C(1.0) / t69;
    const real_t t71 = TB_C(1.0) / t29;
    const real_t t72 = t27 * t71;
    const real_t t73 = t22 * t71;
    const real_t t74 = (t21 * t72 + t26 * t73) * TB_MOMENT_WEIGHT;
    const real_t t75 = t29 * t74;
    const real_t t76 = TB_SQRT(t33 + t64);
    const real_t t77 = TB_C(1.0) / t76;
    const real_t t78 = t53 * t77;
    const real_t t79 = t32 * t77;
    const real_t t80 = TB_MOMENT_WEIGHT * (t31 * t78 + t52 * t79);
    const real_t t81 = t76 * t80;
    const real_t t82 = TB_SQRT(t36 + t65);
    const real_t t83 = TB_C(1.0) / t82;
    const real_t t84 = t50 * t83;
    const real_t t85 = t35 * t83;
    const real_t t86 = TB_MOMENT_WEIGHT * (t34 * t84 - t49 * t85);
    const real_t t87 = t82 * t86;
    const real_t t88 = TB_SQRT(t40 + t66);
    const real_t t89 = TB_C(1.0) / t88;
    const real_t t90 = t56 * t89;
    const real_t t91 = t39 * t89;
    const real_t t92 = TB_MOMENT_WEIGHT * (t38 * t90 - t55 * t91);
    const real_t t93 = t88 * t92;
    const real_t t94 = TB_SQRT(t43 + t67);
    const real_t t95 = TB_C(1.0) / t94;
    const real_t t96 = t58 * t95;
    const real_t t97 = t42 * t95;
    const real_t t98 = TB_MOMENT_WEIGHT * (t41 * t96 - t57 * t97);
    const real_t t99 = t94 * t98;
    const real_t t100 = t27 * t75 + t53 * t81 + t50 * t87 + t56 * t93 + t58 * t99;
    const real_t t101 = TB_SQRT(t46 + t68);
    const real_t t102 = TB_C(1.0) / t101;
    const real_t t103 = t61 * t102;
    const real_t t104 = t45 * t102;
    const real_t t105 = TB_MOMENT_WEIGHT * (t44 * t103 + t60 * t104);
    const real_t t106 = t101 * t105;
    const real_t t107 = t35 * t87 - (t22 * t75 + t32 * t81) + t39 * t93 + t42 * t99;
    const real_t t108 = t48 * (t107 - t45 * t106);
    const real_t t109 = t70 * (t100 + t61 * t106 - t47 * (t62 * t108));
    const real_t t110 = TB_MOMENT_WEIGHT * wrench[2] - wrench[0] * t108;
    const real_t t111 = t75 * t75 + t81 * t81 + t87 * t87 + t93 * t93 + t99 * t99;
    const real_t t112 = t111 + t106 * t106 - t47 * (t108 * t108) - t69 * (t109 * t109);
    const real_t t113 = (t110 - t63 * t109) / t112;
    const real_t t114 = t63 * t70 - t109 * t113;
    const real_t t115 = wrench[0] * t48 - t62 * t114 - t108 * t113;
    const real_t share_0 = t29 * (t22 * t115 - t27 * t114 - t75 * t113);
    const real_t share_1 = t76 * (t32 * t115 - t53 * t114 - t81 * t113);
    const real_t share_2 = t82 * (t35 * t115 + t50 * t114 + t87 * t113);
    const real_t share_3 = t88 * (t39 * t115 + t56 * t114 + t93 * t113);
    const real_t share_4 = t94 * (t42 * t115 + t58 * t114 + t99 * t113);
    const real_t share_5 = t101 * (t61 * t114 - t45 * t115 + t106 * t113);
    const bool t116 = TB_C(0.0001) < t29 && TB_C(0.0001) < t76 && TB_C(0.0001) < t82;
    const bool t117 = t116 && TB_C(0.0001) < t88 && TB_C(0.0001) < t94 && TB_C(0.0001) < t101;
    const bool t118 = !t117;
    const real_t t119 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const real_t t120 = t73 * t73 + t79 * t79 + t85 * t85 + t91 * t91 + t97 * t97;
    const real_t t121 = t120 + t104 * t104;
    const real_t t122 = t72 * t72 + t78 * t78 + t84 * t84 + t90 * t90 + t96 * t96;
    const real_t t123 = t84 * t85 - (t72 * t73 + t78 * t79) + t90 * t91 + t96 * t97;
    const real_t t124 = TB_C(1.0) / t121;
    const real_t t125 = (t123 - t103 * t104) * t124;
    const real_t t126 = t122 + t103 * t103 - t121 * (t125 * t125);
    const real_t t127 = t74 * t74 + t80 * t80 + t86 * t86 + t92 * t92 + t98 * t98;
    const real_t t128 = t85 * t86 - (t73 * t74 + t79 * t80) + t91 * t92 + t97 * t98;
    const real_t t129 = t124 * (t128 - t104 * t105);
    const real_t t130 = t72 * t74 + t78 * t80 + t84 * t86 + t90 * t92 + t96 * t98;
    const real_t t131 = (t130 + t103 * t105 - t121 * (t125 * t129)) / t126;
    const real_t t132 = t127 + t105 * t105 - t121 * (t129 * t129) - t126 * (t131 * t131);
    const bool t133 = !(t119 < t121 && t119 < t126 && t119 < t132);
    if (t118 || t133) {
        return tb_refuse_wrench_share_eq10(TB_SINGULAR, share);
    }
    share[0] = share_0;
    share[1] = share_1;
    share[2] = share_2;
    share[3] = share_3;
    share[4] = share_4;
    share[5] = share_5;
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

tb_status tb_rail_forces(const real_t pose[3], const real_t rails[6], const real_t tension[6],
    real_t force[6])
{
    if (!(pose[0] >= -TB_C(1.4236) && pose[0] <= TB_C(1.4236)
          && pose[1] >= -TB_C(1.4236) && pose[1] <= TB_C(1.4236)
          && pose[2] >= -TB_C(1.2853981633974483) && pose[2] <= TB_C(1.2853981633974483)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) +
              TB_ABS(rails[4]) + TB_ABS(rails[5]) <= TB_C(8.541599999999999)
          && TB_ABS(tension[0]) + TB_ABS(tension[1]) + TB_ABS(tension[2]) + TB_ABS(tension[3])
              + TB_ABS(tension[4]) + TB_ABS(tension[5]) <= TB_C(60000.0))) {
        return tb_refuse_rail_forces(TB_OUT_OF_DOMAIN, force);
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
    const real_t t21 = rails[0] - (pose[0] + (t18 - t20));
    const real_t t22 = -TB_C(0.04) * t19;
    const real_t t23 = t17 * -TB_C(0.025);
    const real_t t24 = pose[1] + (t22 + t23);
    const real_t t25 = TB_SQRT(t21 * t21 + t24 * t24);
    const real_t force_0 = -(tension[0] * (t21 / t25));
    const real_t t26 = t17 * TB_C(0.04);
    const real_t t27 = rails[1] - (pose[0] + (t26 - t20));
    const real_t t28 = t19 * TB_C(0.04);
    const real_t t29 = pose[1] + (t23 + t28);
    const real_t t30 = TB_SQRT(t27 * t27 + t29 * t29);
    const real_t force_1 = -(tension[1] * (t27 / t30));
    const real_t t31 = rails[2] - (pose[1] + t19 * TB_LONGEST_ARM);
    const real_t t32 = TB_FRAME_X - (pose[0] + t17 * TB_LONGEST_ARM);
    const real_t t33 = TB_SQRT(t32 * t32 + t31 * t31);
    const real_t force_2 = -(tension[2] * (t31 / t33));
    const real_t t34 = t19 * TB_C(0.025);
    const real_t t35 = rails[3] - (pose[0] + (t26 - t34));
    const real_t t36 = t17 * TB_C(0.025);
    const real_t t37 = TB_FRAME_Y - (pose[1] + (t28 + t36));
    const real_t t38 = TB_SQRT(t35 * t35 + t37 * t37);
    const real_t force_3 = -(tension[3] * (t35 / t38));
    const real_t t39 = rails[4] - (pose[0] + (t18 - t34));
    const real_t t40 = TB_FRAME_Y - (pose[1] + (t22 + t36));
    const real_t t41 = TB_SQRT(t39 * t39 + t40 * t40);
    const real_t force_4 = -(tension[4] * (t39 / t41));
    const real_t t42 = rails[5] - (pose[1] + t19 * TB_ANCHOR_6_X);
    const real_t t43 = pose[0] + t17 * TB_ANCHOR_6_X;
    const real_t t44 = TB_SQRT(t43 * t43 + t42 * t42);
    const real_t force_5 = -(tension[5] * (t42 / t44));
    const bool t45 = TB_C(0.0001) < t25 && TB_C(0.0001) < t30 && TB_C(0.0001) < t33;
    const bool t46 = t45 && TB_C(0.0001) < t38 && TB_C(0.0001) < t41 && TB_C(0.0001) < t44;
    const bool t47 = !t46;
    if (t47) {
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

