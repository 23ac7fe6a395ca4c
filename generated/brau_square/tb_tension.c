/* Regenerate: turnbuckle generate machines/brau_square.toml --out <this folder>
 * Machine 166f8b7fcb339437, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_tension.h"
#include "tb_machine.h"

/* Refuses with a status: tension is 0 N; delivered is 0 N; kkt_residual is 0 N. */
static tb_status tb_refuse_least_norm_tension_quick(tb_status status, real_t tension[4],
    real_t delivered[2], real_t kkt_residual[1])
{
    tension[0] = TB_C(0.0);
    tension[1] = TB_C(0.0);
    tension[2] = TB_C(0.0);
    tension[3] = TB_C(0.0);
    delivered[0] = TB_C(0.0);
    delivered[1] = TB_C(0.0);
    kkt_residual[0] = TB_C(0.0);
    return status;
}

tb_status tb_least_norm_tension_quick(const real_t structure[8], const real_t wrench[2],
    real_t tension[4], real_t delivered[2], real_t kkt_residual[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) <= TB_C(32.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(80000.0))) {
        return tb_refuse_least_norm_tension_quick(TB_OUT_OF_DOMAIN, tension, delivered, kkt_residual);
    }
    const real_t cross_02 = structure[0] * structure[6] - structure[4] * structure[2];
    /* s_i x W */
    const real_t height_0 = structure[0] * wrench[1] - structure[4] * wrench[0];
    const real_t cross_12 = structure[6] * structure[1] - structure[2] * structure[5];
    const real_t height_1 = wrench[1] * structure[1] - wrench[0] * structure[5];
    const real_t cross_23 = structure[2] * structure[7] - structure[6] * structure[3];
    const real_t height_3 = wrench[1] * structure[3] - wrench[0] * structure[7];
    const real_t t0 = cross_02 * height_0 + cross_12 * height_1 - cross_23 * height_3;
    const real_t cross_01 = structure[0] * structure[5] - structure[4] * structure[1];
    const real_t t1 = cross_01 * cross_01;
    const real_t t2 = cross_23 * cross_23;
    const real_t t3 = cross_02 * cross_02;
    const real_t cross_13 = structure[1] * structure[7] - structure[5] * structure[3];
    const real_t t4 = cross_13 * cross_13;
    const real_t cross_03 = structure[0] * structure[7] - structure[4] * structure[3];
    const real_t t5 = cross_03 * cross_03;
    const real_t t6 = cross_12 * cross_12;
    /* det S S', Cauchy-Binet */
    const real_t determinant = t1 + t2 + (t3 + t4) + (t5 + t6);
    const real_t t7 = TB_C(1.0) / determinant;
    /* the least-norm tensions that exert the wrench */
    const real_t start_2 = t0 * t7;
    const real_t t8 = TB_TENSION_MAX - start_2;
    const real_t t9 = tb_min(tb_max(TB_C(0.0), -start_2), t8);
    const real_t t10 = t1 + (t4 + t5);
    const real_t t11 = TB_C(1.0) / tb_max(t10, TB_EPSILON);
    const real_t t12 = t9 * (t9 * t11);
    const real_t height_2 = structure[2] * wrench[1] - structure[6] * wrench[0];
    const real_t t13 = height_0 * cross_03 + height_1 * cross_13 + cross_23 * height_2;
    const real_t start_3 = t7 * t13;
    const real_t t14 = TB_TENSION_MAX - start_3;
    const real_t t15 = tb_min(tb_max(TB_C(0.0), -start_3), t14);
    const real_t t16 = t1 + (t3 + t6);
    const real_t t17 = TB_C(1.0) / tb_max(t16, TB_EPSILON);
    const real_t t18 = t15 * (t15 * t17);
    const real_t t19 = height_1 * cross_01 + cross_02 * height_2 + height_3 * cross_03;
    const real_t t20 = t7 * t19;
    const real_t t21 = TB_TENSION_MAX + t20;
    const real_t t22 = tb_min(tb_max(TB_C(0.0), t20), t21);
    const real_t t23 = t6 + (t2 + t4);
    const real_t t24 = TB_C(1.0) / tb_max(t23, TB_EPSILON);
    const real_t t25 = t22 * (t22 * t24);
    const real_t t26 = height_0 * cross_01 - cross_12 * height_2 - height_3 * cross_13;
    const real_t start_1 = t7 * t26;
    const real_t t27 = TB_TENSION_MAX - start_1;
    const real_t t28 = tb_min(tb_max(TB_C(0.0), -start_1), t27);
    const real_t t29 = t3 + (t2 + t5);
    const real_t t30 = TB_C(1.0) / tb_max(t29, TB_EPSILON);
    const real_t t31 = t28 * (t28 * t30);
    const bool t32 = tb_max(t12, t18) <= tb_max(t25, t31);
    const real_t t33 = TB_SQRT(determinant * TB_C(0.5));
    const real_t t34 = TB_C(1.0) / t33;
    const real_t t35 = TB_EPSILON * TB_C(120.0) * t34;
    const real_t t36 = TB_EPSILON * TB_C(16.0);
    const real_t t37 = t20 - t35;
    const real_t t38 = t21 + t35;
    const bool t39 = TB_ABS(cross_03) <= t36;
    const real_t t40 = cross_02 * cross_01 + cross_23 * cross_13;
    const real_t t41 = start_2 + t35;
    const real_t t42 = TB_C(1.0) / cross_03;
    const real_t t43 = t8 + t35;
    const bool t44 = TB_ABS(cross_02) <= t36;
    const real_t t45 = cross_01 * cross_03 - cross_12 * cross_23;
    const real_t t46 = start_3 + t35;
    const real_t t47 = TB_C(1.0) / cross_02;
    const real_t t48 = t14 + t35;
    const bool t49 = TB_ABS(cross_13) <= t36;
    const real_t t50 = cross_23 * cross_03 - cross_12 * cross_01;
    const real_t t51 = TB_C(1.0) / cross_13;
    const real_t t52 = start_1 + t35;
    const real_t t53 = t27 + t35;
    const real_t t54 = cross_01 * cross_13 + cross_02 * cross_23;
    const bool t55 = TB_ABS(cross_12) <= t36;
    const real_t t56 = TB_C(1.0) / cross_12;
    real_t t57, t58, t59, t60;
    if (t32) {
        const bool t61 = t31 <= t25;
        const real_t t62 = cross_02 * cross_12 + cross_13 * cross_03;
        const bool t63 = TB_ABS(cross_23) <= t36;
        const real_t t64 = TB_C(1.0) / cross_23;
        real_t t65, t66, t67, t68;
        if (t61) {
            const real_t t69 = t24 * (t35 < TB_ABS(t22) ? t22 : TB_C(0.0));
            const real_t t70 = t69 * t62;
            real_t t71, t72;
            if (t63) {
                t71 = -TB_C(1000000000000.0);
                t72 = TB_C(1000000000000.0);
            } else {
                const real_t t73 = t64 * (t70 - t52);
                const real_t t74 = t64 * (t53 + t70);
                t71 = tb_min(t73, t74);
                t72 = tb_max(t73, t74);
            }
            const real_t t75 = t69 * t50;
            real_t t76, t77;
            if (t49) {
                t76 = -TB_C(1000000000000.0);
                t77 = TB_C(1000000000000.0);
            } else {
                const real_t t78 = -(t51 * (t75 - t41));
                const real_t t79 = -(t51 * (t43 + t75));
                t76 = tb_min(t78, t79);
                t77 = tb_max(t78, t79);
            }
            const real_t t80 = t69 * t54;
            real_t t81, t82;
            if (t55) {
                t81 = -TB_C(1000000000000.0);
                t82 = TB_C(1000000000000.0);
            } else {
                const real_t t83 = -(t56 * (t46 + t80));
                const real_t t84 = t56 * (t48 - t80);
                t81 = tb_min(t83, t84);
                t82 = tb_max(t83, t84);
            }
            const real_t t85 = tb_min(tb_max(TB_C(0.0), tb_max(tb_max(t71, t76), t81)),
                tb_min(tb_min(t72, t77), t82));
            t65 = t23 * t69;
            t66 = cross_23 * t85 - t70;
            t67 = -(t75 + cross_13 * t85);
            t68 = t80 + cross_12 * t85;
        } else {
            const real_t t86 = t30 * (t35 < TB_ABS(t28) ? t28 : TB_C(0.0));
            const real_t t87 = t62 * t86;
            real_t t88, t89;
            if (t63) {
                t88 = -TB_C(1000000000000.0);
                t89 = TB_C(1000000000000.0);
            } else {
                const real_t t90 = -((t87 + t37) * t64);
                const real_t t91 = -(t64 * (t87 + t38));
                t88 = tb_min(t90, t91);
                t89 = tb_max(t90, t91);
            }
            const real_t t92 = t86 * t40;
            real_t t93, t94;
            if (t39) {
                t93 = -TB_C(1000000000000.0);
                t94 = TB_C(1000000000000.0);
            } else {
                const real_t t95 = (t92 - t41) * t42;
                const real_t t96 = t42 * (t92 + t43);
                t93 = tb_min(t95, t96);
                t94 = tb_max(t95, t96);
            }
            const real_t t97 = t86 * t45;
            real_t t98, t99;
            if (t44) {
                t98 = -TB_C(1000000000000.0);
                t99 = TB_C(1000000000000.0);
            } else {
                const real_t t100 = -((t97 - t46) * t47);
                const real_t t101 = -(t47 * (t97 + t48));
                t98 = tb_min(t100, t101);
                t99 = tb_max(t100, t101);
            }
            const real_t t102 = tb_min(tb_max(TB_C(0.0), tb_max(tb_max(t88, t93), t98)),
                tb_min(tb_min(t89, t94), t99));
            t65 = -(t87 + cross_23 * t102);
            t66 = t29 * t86;
            t67 = cross_03 * t102 - t92;
            t68 = -(t97 + cross_02 * t102);
        }
        t57 = t65;
        t58 = t66;
        t59 = t67;
        t60 = t68;
    } else {
        const bool t103 = t18 <= t12;
        const bool t104 = TB_ABS(cross_01) <= t36;
        const real_t t105 = cross_02 * cross_03 + cross_12 * cross_13;
        const real_t t106 = TB_C(1.0) / cross_01;
        real_t t107, t108, t109, t110;
        if (t103) {
            const real_t t111 = t11 * (t35 < TB_ABS(t9) ? t9 : TB_C(0.0));
            const real_t t112 = t50 * t111;
            real_t t113, t114;
            if (t49) {
                t113 = -TB_C(1000000000000.0);
                t114 = TB_C(1000000000000.0);
            } else {
                const real_t t115 = (t37 + t112) * t51;
                const real_t t116 = t51 * (t38 + t112);
                t113 = tb_min(t115, t116);
                t114 = tb_max(t115, t116);
            }
            const real_t t117 = t40 * t111;
            real_t t118, t119;
            if (t39) {
                t118 = -TB_C(1000000000000.0);
                t119 = TB_C(1000000000000.0);
            } else {
                const real_t t120 = -(t42 * (t117 - t52));
                const real_t t121 = -(t42 * (t117 + t53));
                t118 = tb_min(t120, t121);
                t119 = tb_max(t120, t121);
            }
            const real_t t122 = t111 * t105;
            real_t t123, t124;
            if (t104) {
                t123 = -TB_C(1000000000000.0);
                t124 = TB_C(1000000000000.0);
            } else {
                const real_t t125 = (t122 - t46) * t106;
                const real_t t126 = t106 * (t48 + t122);
                t123 = tb_min(t125, t126);
                t124 = tb_max(t125, t126);
            }
            const real_t t127 = tb_max(TB_C(0.0), tb_max(tb_max(t113, t118), t123));
            const real_t t128 = tb_min(t127, tb_min(tb_min(t114, t119), t124));
            t107 = cross_13 * t128 - t112;
            t108 = -(t117 + cross_03 * t128);
            t109 = t10 * t111;
            t110 = cross_01 * t128 - t122;
        } else {
            const real_t t129 = t17 * (t35 < TB_ABS(t15) ? t15 : TB_C(0.0));
            const real_t t130 = t54 * t129;
            real_t t131, t132;
            if (t55) {
                t131 = -TB_C(1000000000000.0);
                t132 = TB_C(1000000000000.0);
            } else {
                const real_t t133 = -((t37 - t130) * t56);
                const real_t t134 = -(t56 * (t38 - t130));
                t131 = tb_min(t133, t134);
                t132 = tb_max(t133, t134);
            }
            const real_t t135 = t45 * t129;
            real_t t136, t137;
            if (t44) {
                t136 = -TB_C(1000000000000.0);
                t137 = TB_C(1000000000000.0);
            } else {
                const real_t t138 = t47 * (t135 - t52);
                const real_t t139 = t47 * (t53 + t135);
                t136 = tb_min(t138, t139);
                t137 = tb_max(t138, t139);
            }
            const real_t t140 = t105 * t129;
            real_t t141, t142;
            if (t104) {
                t141 = -TB_C(1000000000000.0);
                t142 = TB_C(1000000000000.0);
            } else {
                const real_t t143 = -(t106 * (t140 - t41));
                const real_t t144 = -(t106 * (t43 + t140));
                t141 = tb_min(t143, t144);
                t142 = tb_max(t143, t144);
            }
            const real_t t145 = tb_max(TB_C(0.0), tb_max(tb_max(t131, t136), t141));
            const real_t t146 = tb_min(t145, tb_min(tb_min(t132, t137), t142));
            t107 = t130 - cross_12 * t146;
            t108 = cross_02 * t146 - t135;
            t109 = -(t140 + cross_01 * t146);
            t110 = t16 * t129;
        }
        t57 = t107;
        t58 = t108;
        t59 = t109;
        t60 = t110;
    }
    const real_t tension_0 = tb_min(tb_max(t57 - t20, TB_C(0.0)), TB_TENSION_MAX);
    const real_t tension_1 = tb_min(tb_max(start_1 + t58, TB_C(0.0)), TB_TENSION_MAX);
    const real_t tension_2 = tb_min(tb_max(start_2 + t59, TB_C(0.0)), TB_TENSION_MAX);
    const real_t tension_3 = tb_min(tb_max(start_3 + t60, TB_C(0.0)), TB_TENSION_MAX);
    const real_t t147 = structure[0] * tension_0 + structure[1] * tension_1;
    /* what the tensions exert, S T */
    const real_t delivered_0 = t147 + structure[2] * tension_2 + structure[3] * tension_3;
    const real_t t148 = structure[4] * tension_0 + structure[5] * tension_1;
    const real_t delivered_1 = t148 + structure[6] * tension_2 + structure[7] * tension_3;
    const real_t t149 = tb_max(TB_C(0.0), TB_ABS(delivered_0 - wrench[0]));
    const real_t kkt_residual_0 = tb_max(t149, TB_ABS(delivered_1 - wrench[1]));
    const bool t150 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0)) < t33;
    const bool t151 = !t150;
    const real_t t152 = tb_min(t34 * (TB_EPSILON * TB_C(480.0)), TB_C(0.01));
    const bool t153 = !(kkt_residual_0 <= t152);
    if (t151) {
        return tb_refuse_least_norm_tension_quick(TB_SINGULAR, tension, delivered, kkt_residual);
    }
    if (t153) {
        return tb_refuse_least_norm_tension_quick(TB_INACCURATE, tension, delivered, kkt_residual);
    }
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    delivered[0] = delivered_0;
    delivered[1] = delivered_1;
    kkt_residual[0] = kkt_residual_0;
    return TB_OK;
}

/* Refuses with a status: tension is 0 N; delivered is 0 N; kkt_residual is 0 N. */
static tb_status tb_refuse_least_norm_tension(tb_status status, real_t tension[4],
    real_t delivered[2], real_t kkt_residual[1])
{
    tension[0] = TB_C(0.0);
    tension[1] = TB_C(0.0);
    tension[2] = TB_C(0.0);
    tension[3] = TB_C(0.0);
    delivered[0] = TB_C(0.0);
    delivered[1] = TB_C(0.0);
    kkt_residual[0] = TB_C(0.0);
    return status;
}

tb_status tb_least_norm_tension(const real_t structure[8], const real_t wrench[2],
    real_t tension[4], real_t delivered[2], real_t kkt_residual[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) <= TB_C(32.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(80000.0))) {
        return tb_refuse_least_norm_tension(TB_OUT_OF_DOMAIN, tension, delivered, kkt_residual);
    }
    const real_t t0 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t1 = t0 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t2 = TB_SQRT(t1);
    const real_t t3 = TB_COPYSIGN(t2, structure[0]);
    const real_t t4 = structure[0] + t3;
    const real_t t5 = t4 * structure[4] + structure[5] * structure[1] + structure[2] *
        structure[6];
    const real_t t6 = TB_C(1.0) / (t2 * (t2 + TB_ABS(structure[0])));
    const real_t t7 = (t5 + structure[3] * structure[7]) * t6;
    const real_t t8 = structure[5] - structure[1] * t7;
    const real_t t9 = structure[6] - structure[2] * t7;
    const real_t t10 = structure[7] - structure[3] * t7;
    const real_t t11 = TB_SQRT(t8 * t8 + t9 * t9 + t10 * t10);
    const real_t t12 = TB_COPYSIGN(t11, t8);
    const real_t t13 = t8 + t12;
    const real_t t14 = wrench[0] / t3;
    const real_t t15 = (wrench[1] + (structure[4] - t4 * t7) * t14) / t12;
    const real_t t16 = TB_C(1.0) / (t11 * (t11 + TB_ABS(t8)));
    const real_t t17 = t13 * t15 * t16;
    const real_t t18 = t10 * t17;
    const real_t t19 = t13 * t17 - t15;
    const real_t t20 = t9 * t17;
    const real_t t21 = structure[1] * t19 - t4 * t14 + structure[2] * t20;
    const real_t t22 = t6 * (t21 + structure[3] * t18);
    const real_t t23 = structure[3] * t22;
    /* the least-norm tensions that exert the wrench */
    const real_t start_3 = t18 - t23;
    const real_t t24 = TB_ABS(t3);
    const real_t t25 = TB_ABS(t12);
    const real_t t26 = TB_C(1.0) / tb_min(t24, t25);
    const real_t t27 = TB_C(30.0) * TB_EPSILON * t26;
    const real_t t28 = structure[2] * t22;
    const real_t start_2 = t20 - t28;
    const real_t t29 = t27 + start_2;
    const real_t t30 = structure[1] * t22;
    const real_t start_1 = t19 - t30;
    const real_t t31 = t27 + start_1;
    const real_t t32 = t9 * t16;
    const real_t t33 = TB_C(1.0) - t9 * t32;
    const real_t t34 = t13 * t32;
    const real_t t35 = t10 * t32;
    const real_t t36 = structure[2] * t33 - structure[1] * t34 - structure[3] * t35;
    const real_t t37 = t6 * t36;
    const real_t t38 = t4 * t37;
    const real_t t39 = t34 + structure[1] * t37;
    const real_t t40 = t10 * t16;
    const real_t t41 = TB_C(1.0) - t10 * t40;
    const real_t t42 = t13 * t40;
    const real_t t43 = t9 * t40;
    const real_t t44 = structure[3] * t41 - (structure[1] * t42 + structure[2] * t43);
    const real_t t45 = t6 * t44;
    const real_t t46 = t4 * t45;
    const real_t t47 = t42 + structure[1] * t45;
    const real_t t48 = t38 * t39 + t46 * t47;
    const real_t t49 = t14 + t4 * t22;
    const real_t t50 = t49 + TB_TENSION_MAX;
    const real_t t51 = tb_min(tb_max(TB_C(0.0), t49), t50);
    const real_t t52 = t27 < TB_ABS(t51) ? t51 : TB_C(0.0);
    const real_t t53 = t52 / tb_max(t38 * t38 + t46 * t46, TB_EPSILON);
    const real_t t54 = t48 * t53;
    const real_t t55 = TB_TENSION_MAX - start_1;
    const real_t t56 = t27 + t55;
    const real_t t57 = tb_max(-(t31 + t54), t54 - t56);
    const bool t58 = TB_C(0.0) < t57;
    const real_t t59 = t43 + structure[2] * t45;
    const real_t t60 = t33 - structure[2] * t37;
    const real_t t61 = t47 * t59 - t39 * t60;
    const real_t t62 = t39 * t59 + t47 * t60;
    const real_t t63 = TB_EPSILON * TB_C(16.0);
    const real_t t64 = t49 - t27;
    const real_t t65 = t27 + t50;
    const real_t t66 = t46 * t59 - t38 * t60;
    const real_t t67 = t35 + structure[3] * t37;
    const real_t t68 = t41 - structure[3] * t45;
    const real_t t69 = t39 * t67 - t47 * t68;
    const real_t t70 = t39 * t68 + t47 * t67;
    const real_t t71 = t38 * t67 - t46 * t68;
    const real_t t72 = t27 * TB_C(2.0);
    const real_t t73 = t27 * TB_C(1024.0);
    real_t t74, t75, t76, t77, t78;
    if (t58) {
        const real_t t79 = tb_min(tb_max(t54, t30 - t19), t55);
        const real_t t80 = TB_C(1.0) / tb_max(t39 * t39 + t47 * t47, TB_EPSILON);
        const real_t t81 = t79 * t80;
        const real_t t82 = t39 * t46 - t38 * t47;
        const bool t83 = TB_ABS(t82) <= t63;
        const real_t t84 = t48 * t81;
        const real_t t85 = TB_C(1.0) / t82;
        real_t t86, t87;
        if (t83) {
            t86 = -TB_C(1000000000000.0);
            t87 = TB_C(1000000000000.0);
        } else {
            const real_t t88 = (t64 - t84) * t85;
            const real_t t89 = t85 * (t65 - t84);
            t86 = tb_min(t88, t89);
            t87 = tb_max(t88, t89);
        }
        const real_t t90 = tb_min(tb_max(TB_C(0.0), t86), t87);
        const real_t t91 = TB_C(0.0) < TB_ABS(t90) ? t90 * (t48 * t85) : TB_C(0.0);
        const real_t t92 = t54 < t79 ? t91 - t81 : t81 - t91;
        real_t t93;
        if (TB_C(0.0) < t92) {
            const real_t t94 = t83 ? TB_C(0.0) : t72 * TB_ABS(t85);
            const real_t t95 = t86 + t94 < t87 - t94 && t73 < t57 ? t92 : TB_C(0.0);
            t93 = t95;
        } else {
            t93 = TB_C(0.0);
        }
        t74 = t61 * t81 + t62 * t90;
        t75 = t81 * t69 - t90 * t70;
        t76 = t84 + t82 * t90;
        t77 = t79;
        t78 = t93;
    } else {
        t74 = t53 * t66;
        t75 = t53 * t71;
        t76 = t52;
        t77 = t54;
        t78 = TB_C(0.0);
    }
    const real_t t96 = TB_TENSION_MAX - start_2;
    const real_t t97 = t27 + t96;
    const real_t t98 = tb_max(-(t29 + t74), t74 - t97);
    const bool t99 = TB_C(0.0) < t98;
    const real_t t100 = t60 * t68;
    const real_t t101 = t59 * t67;
    const real_t t102 = t60 * t67 + t59 * t68;
    real_t t103, t104, t105, t106, t107;
    if (t99) {
        const bool t108 = TB_ABS(t62) <= t63;
        const real_t t109 = tb_min(tb_max(t74, t28 - t20), t96);
        const real_t t110 = TB_C(1.0) / tb_max(t60 * t60 + t59 * t59, TB_EPSILON);
        const real_t t111 = t109 * t110;
        const real_t t112 = t61 * t111;
        const real_t t113 = TB_C(1.0) / t62;
        real_t t114, t115;
        if (t108) {
            t114 = -TB_C(1000000000000.0);
            t115 = TB_C(1000000000000.0);
        } else {
            const real_t t116 = (t31 + t112) * t113;
            const real_t t117 = -(t113 * (t56 - t112));
            t114 = tb_min(t116, t117);
            t115 = tb_max(t116, t117);
        }
        const real_t t118 = t46 * t60 + t38 * t59;
        const bool t119 = TB_ABS(t118) <= t63;
        const real_t t120 = t66 * t111;
        const real_t t121 = TB_C(1.0) / t118;
        real_t t122, t123;
        if (t119) {
            t122 = -TB_C(1000000000000.0);
            t123 = TB_C(1000000000000.0);
        } else {
            const real_t t124 = -((t64 - t120) * t121);
            const real_t t125 = -(t121 * (t65 - t120));
            t122 = tb_min(t124, t125);
            t123 = tb_max(t124, t125);
        }
        const real_t t126 = tb_min(tb_max(TB_C(0.0), tb_max(t114, t122)), tb_min(t115, t123));
        real_t t127;
        if (TB_C(0.0) < TB_ABS(t126)) {
            const real_t t128 = -(t61 * t113);
            const real_t t129 = -(t66 * t121);
            const real_t t130 = TB_C(0.0) < t126 ? (t122 < t114 ? t128 : t129) : (t115 < t123 ?
                t128 : t129);
            t127 = t126 * t130;
        } else {
            t127 = TB_C(0.0);
        }
        const real_t t131 = t74 < t109 ? t127 - t111 : t111 - t127;
        real_t t132;
        if (TB_C(0.0) < t131) {
            real_t t133;
            if (t119) {
                t133 = TB_C(0.0);
            } else {
                t133 = t72 * TB_ABS(TB_C(1.0) / -t118);
            }
            real_t t134;
            if (t108) {
                t134 = TB_C(0.0);
            } else {
                t134 = t72 * TB_ABS(TB_C(1.0) / -t62);
            }
            const bool t135 = tb_max(t122 + t133, t114 + t134) < tb_min(t123 - t133, t115 -
                t134);
            t132 = t135 && t73 < t98 ? t131 : TB_C(0.0);
        } else {
            t132 = TB_C(0.0);
        }
        t103 = (t100 - t101) * t126 - t111 * t102;
        t104 = t120 - t118 * t126;
        t105 = t112 - t62 * t126;
        t106 = t109;
        t107 = t132;
    } else {
        t103 = t75;
        t104 = t76;
        t105 = t77;
        t106 = t74;
        t107 = t78;
    }
    const real_t t136 = TB_TENSION_MAX - start_3;
    const real_t t137 = tb_max(-(start_3 + t27 + t103), t103 - (t27 + t136));
    const bool t138 = TB_C(0.0) < t137;
    real_t t139, t140, t141, t142, t143;
    if (t138) {
        const real_t t144 = tb_min(tb_max(t103, t23 - t18), t136);
        const real_t t145 = TB_C(1.0) / tb_max(t67 * t67 + t68 * t68, TB_EPSILON);
        const real_t t146 = t144 * t145;
        const real_t t147 = t71 * t146;
        const real_t t148 = t46 * t67 + t38 * t68;
        const real_t t149 = t101 - t100;
        const bool t150 = TB_ABS(t149) <= t63;
        const real_t t151 = t102 * t146;
        const real_t t152 = TB_C(1.0) / t149;
        real_t t153, t154;
        if (t150) {
            t153 = -TB_C(1000000000000.0);
            t154 = TB_C(1000000000000.0);
        } else {
            const real_t t155 = (t151 - t29) * t152;
            const real_t t156 = t152 * (t97 + t151);
            t153 = tb_min(t155, t156);
            t154 = tb_max(t155, t156);
        }
        const bool t157 = TB_ABS(t70) <= t63;
        const real_t t158 = t69 * t146;
        const real_t t159 = TB_C(1.0) / t70;
        real_t t160, t161;
        if (t157) {
            t160 = -TB_C(1000000000000.0);
            t161 = TB_C(1000000000000.0);
        } else {
            const real_t t162 = -((t31 + t158) * t159);
            const real_t t163 = t159 * (t56 - t158);
            t160 = tb_min(t162, t163);
            t161 = tb_max(t162, t163);
        }
        const bool t164 = TB_ABS(t148) <= t63;
        const real_t t165 = TB_C(1.0) / t148;
        real_t t166, t167;
        if (t164) {
            t166 = -TB_C(1000000000000.0);
            t167 = TB_C(1000000000000.0);
        } else {
            const real_t t168 = (t64 - t147) * t165;
            const real_t t169 = t165 * (t65 - t147);
            t166 = tb_min(t168, t169);
            t167 = tb_max(t168, t169);
        }
        const real_t t170 = tb_max(t160, t166);
        const real_t t171 = tb_min(t161, t167);
        const real_t t172 = tb_min(tb_max(TB_C(0.0), tb_max(t153, t170)), tb_min(t154, t171));
        real_t t173;
        if (TB_C(0.0) < TB_ABS(t172)) {
            const real_t t174 = -(t102 * t152);
            const real_t t175 = t69 * t159;
            const real_t t176 = t71 * t165;
            real_t t177;
            if (TB_C(0.0) < t172) {
                t177 = t170 < t153 ? t174 : (t166 < t160 ? t175 : t176);
            } else {
                t177 = t154 < t171 ? t174 : (t161 < t167 ? t175 : t176);
            }
            t173 = t172 * t177;
        } else {
            t173 = TB_C(0.0);
        }
        const real_t t178 = t103 < t144 ? t173 - t146 : t146 - t173;
        real_t t179;
        if (TB_C(0.0) < t178) {
            const real_t t180 = t164 ? TB_C(0.0) : t72 * TB_ABS(t165);
            const real_t t181 = t157 ? TB_C(0.0) : t72 * TB_ABS(t159);
            const real_t t182 = t150 ? TB_C(0.0) : t72 * TB_ABS(t152);
            const real_t t183 = tb_max(tb_max(t166 + t180, t160 + t181), t153 + t182);
            const real_t t184 = tb_min(tb_min(t167 - t180, t161 - t181), t154 - t182);
            t179 = t183 < t184 && t73 < t137 ? t178 : TB_C(0.0);
        } else {
            t179 = TB_C(0.0);
        }
        t139 = t147 + t148 * t172;
        t140 = t158 + t70 * t172;
        t141 = t149 * t172 - t151;
        t142 = t144;
        t143 = t179;
    } else {
        t139 = t104;
        t140 = t105;
        t141 = t106;
        t142 = t103;
        t143 = t107;
    }
    const real_t tension_0 = tb_min(tb_max(t139 - t49, TB_C(0.0)), TB_TENSION_MAX);
    const real_t tension_1 = tb_min(tb_max(start_1 + t140, TB_C(0.0)), TB_TENSION_MAX);
    const real_t tension_2 = tb_min(tb_max(start_2 + t141, TB_C(0.0)), TB_TENSION_MAX);
    const real_t tension_3 = tb_min(tb_max(start_3 + t142, TB_C(0.0)), TB_TENSION_MAX);
    const real_t t185 = structure[0] * tension_0 + structure[1] * tension_1;
    /* what the tensions exert, S T */
    const real_t delivered_0 = t185 + structure[2] * tension_2 + structure[3] * tension_3;
    const real_t t186 = structure[4] * tension_0 + structure[5] * tension_1;
    const real_t delivered_1 = t186 + structure[6] * tension_2 + structure[7] * tension_3;
    const real_t kkt_residual_0 = tb_max(tb_max(t143, TB_ABS(delivered_0 - wrench[0])),
        TB_ABS(delivered_1 - wrench[1]));
    const real_t t187 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t188 = !(t187 < t24 && t187 < t25);
    const real_t t189 = tb_min(t26 * (TB_EPSILON * TB_C(1280.0)), TB_C(0.01));
    const bool t190 = !(kkt_residual_0 <= t189);
    if (t188) {
        return tb_refuse_least_norm_tension(TB_SINGULAR, tension, delivered, kkt_residual);
    }
    if (t190) {
        return tb_refuse_least_norm_tension(TB_INACCURATE, tension, delivered, kkt_residual);
    }
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    delivered[0] = delivered_0;
    delivered[1] = delivered_1;
    kkt_residual[0] = kkt_residual_0;
    return TB_OK;
}

tb_status tb_served_wrench_scale(const real_t structure[8], const real_t wrench[2],
    real_t served[2], real_t inner[2])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) <= TB_C(32.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(80000.0))) {
        served[0] = TB_C(0.0);
        served[1] = TB_C(0.0);
        inner[0] = TB_C(0.0);
        inner[1] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = structure[4] + structure[5] + structure[6] + structure[7];
    const real_t t1 = TB_C(5.0) * t0;
    const real_t t2 = wrench[1] - t1;
    const real_t t3 = structure[0] + structure[1] + structure[2] + structure[3];
    const real_t t4 = TB_C(5.0) * t3;
    const real_t t5 = wrench[0] - t4;
    const real_t t6 = structure[0] * t2 - structure[4] * t5;
    const real_t t7 = TB_ABS(t6);
    const real_t t8 = structure[0] * structure[5];
    const real_t t9 = structure[4] * structure[1];
    const real_t t10 = t8 - t9;
    const real_t t11 = TB_ABS(t10);
    const real_t t12 = structure[0] * structure[6];
    const real_t t13 = structure[4] * structure[2];
    const real_t t14 = t12 - t13;
    const real_t t15 = TB_ABS(t14);
    const real_t t16 = structure[0] * structure[7];
    const real_t t17 = structure[4] * structure[3];
    const real_t t18 = t16 - t17;
    const real_t t19 = TB_ABS(t18);
    /* facets of the feasible wrenches, half distances */
    const real_t facet_0 = TB_C(5.0) * (t11 + t15 + t19);
    const real_t t20 = t2 * structure[1] - structure[5] * t5;
    const real_t t21 = TB_ABS(t20);
    const real_t t22 = structure[6] * structure[1];
    const real_t t23 = structure[5] * structure[2];
    const real_t t24 = t22 - t23;
    const real_t t25 = TB_ABS(t24);
    const real_t t26 = structure[7] * structure[1];
    const real_t t27 = structure[5] * structure[3];
    const real_t t28 = t26 - t27;
    const real_t t29 = TB_ABS(t28);
    const real_t facet_1 = TB_C(5.0) * (t11 + t25 + t29);
    const real_t t30 = t2 * structure[2] - structure[6] * t5;
    const real_t t31 = TB_ABS(t30);
    const real_t t32 = structure[7] * structure[2];
    const real_t t33 = structure[6] * structure[3];
    const real_t t34 = t32 - t33;
    const real_t t35 = TB_ABS(t34);
    const real_t facet_2 = TB_C(5.0) * (t15 + t25 + t35);
    const bool t36 = t7 <= facet_0 && t21 <= facet_1 && t31 <= facet_2;
    const real_t t37 = t2 * structure[3] - structure[7] * t5;
    const real_t t38 = TB_ABS(t37);
    const real_t facet_3 = TB_C(5.0) * (t35 + (t19 + t29));
    const bool t39 = t36 && t38 <= facet_3;
    const bool t40 = !t39;
    real_t served_0, served_1;
    if (t39) {
        served_0 = wrench[0];
        served_1 = wrench[1];
    } else {
        const real_t t41 = TB_C(160.0) * TB_EPSILON;
        const real_t t42 = structure[0] * wrench[1] - structure[4] * wrench[0];
        const bool t43 = t41 < TB_ABS(t42);
        const real_t t44 = structure[0] * t1 - structure[4] * t4;
        real_t t45, t46, t47;
        if (t43) {
            const real_t t48 = TB_C(1.0) / t42;
            const real_t t49 = (t44 - facet_0 - t41) * t48;
            const real_t t50 = t48 * (t41 + (facet_0 + t44));
            t45 = tb_max(t49, t50);
            t46 = tb_min(t49, t50);
            t47 = t48 * (t44 + TB_COPYSIGN(facet_0, t42));
        } else {
            const real_t t51 = facet_0 + t41 < TB_ABS(t44) ? TB_C(1e+30) : TB_C(0.0);
            t45 = TB_C(1.0);
            t46 = t51;
            t47 = TB_C(1.0);
        }
        const real_t t52 = wrench[1] * structure[1] - structure[5] * wrench[0];
        const bool t53 = t41 < TB_ABS(t52);
        const real_t t54 = t1 * structure[1] - structure[5] * t4;
        real_t t55, t56, t57;
        if (t53) {
            const real_t t58 = TB_C(1.0) / t52;
            const real_t t59 = (t54 - facet_1 - t41) * t58;
            const real_t t60 = t58 * (t41 + (facet_1 + t54));
            t55 = tb_max(t59, t60);
            t56 = tb_min(t59, t60);
            t57 = t58 * (t54 + TB_COPYSIGN(facet_1, t52));
        } else {
            const real_t t61 = facet_1 + t41 < TB_ABS(t54) ? TB_C(1e+30) : TB_C(0.0);
            t55 = TB_C(1.0);
            t56 = t61;
            t57 = TB_C(1.0);
        }
        const real_t t62 = wrench[1] * structure[2] - structure[6] * wrench[0];
        const bool t63 = t41 < TB_ABS(t62);
        const real_t t64 = t1 * structure[2] - structure[6] * t4;
        real_t t65, t66, t67;
        if (t63) {
            const real_t t68 = TB_C(1.0) / t62;
            const real_t t69 = (t64 - facet_2 - t41) * t68;
            const real_t t70 = t68 * (t41 + (facet_2 + t64));
            t65 = tb_max(t69, t70);
            t66 = tb_min(t69, t70);
            t67 = t68 * (t64 + TB_COPYSIGN(facet_2, t62));
        } else {
            const real_t t71 = facet_2 + t41 < TB_ABS(t64) ? TB_C(1e+30) : TB_C(0.0);
            t65 = TB_C(1.0);
            t66 = t71;
            t67 = TB_C(1.0);
        }
        const real_t t72 = wrench[1] * structure[3] - structure[7] * wrench[0];
        const bool t73 = t41 < TB_ABS(t72);
        const real_t t74 = t1 * structure[3] - structure[7] * t4;
        real_t t75, t76, t77;
        if (t73) {
            const real_t t78 = TB_C(1.0) / t72;
            const real_t t79 = (t74 - facet_3 - t41) * t78;
            const real_t t80 = t78 * (t41 + (facet_3 + t74));
            t75 = tb_max(t79, t80);
            t76 = tb_min(t79, t80);
            t77 = t78 * (t74 + TB_COPYSIGN(facet_3, t72));
        } else {
            const real_t t81 = facet_3 + t41 < TB_ABS(t74) ? TB_C(1e+30) : TB_C(0.0);
            t75 = TB_C(1.0);
            t76 = t81;
            t77 = TB_C(1.0);
        }
        const real_t t82 = tb_min(tb_min(tb_min(tb_min(TB_C(1.0), t45), t55), t65), t75);
        const real_t t83 = tb_max(tb_max(tb_max(tb_max(TB_C(0.0), t46), t56), t66), t76);
        const bool t84 = t82 < t83;
        real_t t85, t86;
        if (t84) {
            const bool t87 = TB_C(0.0) < t37;
            const real_t t88 = TB_EPSILON * TB_C(16.0);
            const bool t89 = t19 <= t88;
            const real_t t90 = structure[0] * structure[3] + structure[4] * structure[7];
            const bool t91 = TB_C(0.0) < t90;
            const bool t92 = !t89;
            const bool t93 = (t89 && !t91) || (t92 && TB_C(0.0) < t17 - t16);
            const bool t94 = !t87;
            const bool t95 = (t87 && t93) || (t94 && !t93);
            const real_t t96 = structure[0] * TB_TENSION_MAX;
            const bool t97 = t29 <= t88;
            const real_t t98 = structure[1] * structure[3] + structure[5] * structure[7];
            const bool t99 = TB_C(0.0) < t98;
            const bool t100 = !t97;
            const bool t101 = (t97 && !t99) || (t100 && TB_C(0.0) < t27 - t26);
            const bool t102 = (t87 && t101) || (t94 && !t101);
            const real_t t103 = structure[1] * TB_TENSION_MAX;
            const real_t t104 = (t95 ? t96 : TB_C(0.0)) + (t102 ? t103 : TB_C(0.0));
            const bool t105 = t35 <= t88;
            const real_t t106 = structure[2] * structure[3] + structure[6] * structure[7];
            const bool t107 = TB_C(0.0) < t106;
            const bool t108 = !t105;
            const bool t109 = (t105 && !t107) || (t108 && TB_C(0.0) < t33 - t32);
            const bool t110 = (t87 && t109) || (t94 && !t109);
            const real_t t111 = structure[2] * TB_TENSION_MAX;
            const real_t t112 = t104 + (t110 ? t111 : TB_C(0.0));
            const real_t t113 = structure[4] * TB_TENSION_MAX;
            const real_t t114 = structure[5] * TB_TENSION_MAX;
            const real_t t115 = (t95 ? t113 : TB_C(0.0)) + (t102 ? t114 : TB_C(0.0));
            const real_t t116 = structure[6] * TB_TENSION_MAX;
            const real_t t117 = t115 + (t110 ? t116 : TB_C(0.0));
            const real_t t118 = structure[3] * (wrench[0] - t112) + structure[7] * (wrench[1] -
                t117);
            const real_t t119 = structure[3] * structure[3] + structure[7] * structure[7];
            const real_t t120 = tb_min(tb_max(t118 * (TB_C(1.0) / t119), TB_C(0.0)),
                TB_TENSION_MAX);
            const real_t t121 = t112 + structure[3] * t120;
            const real_t t122 = t121 - wrench[0];
            const real_t t123 = t117 + structure[7] * t120;
            const real_t t124 = t123 - wrench[1];
            const real_t t125 = facet_3 < t38 ? t122 * t122 + t124 * t124 : TB_C(1e+30);
            const bool t126 = TB_C(0.0) < t30;
            const bool t127 = t15 <= t88;
            const real_t t128 = structure[0] * structure[2] + structure[4] * structure[6];
            const bool t129 = TB_C(0.0) < t128;
            const bool t130 = !t127;
            const bool t131 = (t127 && !t129) || (t130 && TB_C(0.0) < t13 - t12);
            const bool t132 = !t126;
            const bool t133 = (t126 && t131) || (t132 && !t131);
            const bool t134 = t25 <= t88;
            const real_t t135 = structure[1] * structure[2] + structure[5] * structure[6];
            const bool t136 = TB_C(0.0) < t135;
            const bool t137 = !t134;
            const bool t138 = (t134 && !t136) || (t137 && TB_C(0.0) < t23 - t22);
            const bool t139 = (t126 && t138) || (t132 && !t138);
            const real_t t140 = (t133 ? t96 : TB_C(0.0)) + (t139 ? t103 : TB_C(0.0));
            const bool t141 = (t105 && t107) || (t108 && TB_C(0.0) < t34);
            const bool t142 = (t126 && t141) || (t132 && !t141);
            const real_t t143 = structure[3] * TB_TENSION_MAX;
            const real_t t144 = t140 + (t142 ? t143 : TB_C(0.0));
            const real_t t145 = (t133 ? t113 : TB_C(0.0)) + (t139 ? t114 : TB_C(0.0));
            const real_t t146 = structure[7] * TB_TENSION_MAX;
            const real_t t147 = t145 + (t142 ? t146 : TB_C(0.0));
            const real_t t148 = structure[2] * (wrench[0] - t144) + structure[6] * (wrench[1] -
                t147);
            const real_t t149 = structure[2] * structure[2] + structure[6] * structure[6];
            const real_t t150 = tb_min(tb_max(t148 * (TB_C(1.0) / t149), TB_C(0.0)),
                TB_TENSION_MAX);
            const real_t t151 = t144 + structure[2] * t150;
            const real_t t152 = t151 - wrench[0];
            const real_t t153 = t147 + structure[6] * t150;
            const real_t t154 = t153 - wrench[1];
            const real_t t155 = facet_2 < t31 ? t152 * t152 + t154 * t154 : TB_C(1e+30);
            const bool t156 = TB_C(0.0) < t20;
            const bool t157 = t11 <= t88;
            const real_t t158 = structure[0] * structure[1] + structure[4] * structure[5];
            const bool t159 = TB_C(0.0) < t158;
            const bool t160 = !t157;
            const bool t161 = (t157 && !t159) || (t160 && TB_C(0.0) < t9 - t8);
            const bool t162 = !t156;
            const bool t163 = (t156 && t161) || (t162 && !t161);
            const bool t164 = (t134 && t136) || (t137 && TB_C(0.0) < t24);
            const bool t165 = (t156 && t164) || (t162 && !t164);
            const real_t t166 = (t163 ? t96 : TB_C(0.0)) + (t165 ? t111 : TB_C(0.0));
            const bool t167 = (t97 && t99) || (t100 && TB_C(0.0) < t28);
            const bool t168 = (t156 && t167) || (t162 && !t167);
            const real_t t169 = t166 + (t168 ? t143 : TB_C(0.0));
            const real_t t170 = (t163 ? t113 : TB_C(0.0)) + (t165 ? t116 : TB_C(0.0));
            const real_t t171 = t170 + (t168 ? t146 : TB_C(0.0));
            const real_t t172 = structure[1] * (wrench[0] - t169) + structure[5] * (wrench[1] -
                t171);
            const real_t t173 = structure[1] * structure[1] + structure[5] * structure[5];
            const real_t t174 = tb_min(tb_max(t172 * (TB_C(1.0) / t173), TB_C(0.0)),
                TB_TENSION_MAX);
            const real_t t175 = t169 + structure[1] * t174;
            const real_t t176 = t175 - wrench[0];
            const real_t t177 = t171 + structure[5] * t174;
            const real_t t178 = t177 - wrench[1];
            const real_t t179 = facet_1 < t21 ? t176 * t176 + t178 * t178 : TB_C(1e+30);
            const bool t180 = TB_C(0.0) < t6;
            const bool t181 = (t157 && t159) || (t160 && TB_C(0.0) < t10);
            const bool t182 = !t180;
            const bool t183 = (t180 && t181) || (t182 && !t181);
            const bool t184 = (t127 && t129) || (t130 && TB_C(0.0) < t14);
            const bool t185 = (t180 && t184) || (t182 && !t184);
            const real_t t186 = (t183 ? t103 : TB_C(0.0)) + (t185 ? t111 : TB_C(0.0));
            const bool t187 = (t89 && t91) || (t92 && TB_C(0.0) < t18);
            const bool t188 = (t180 && t187) || (t182 && !t187);
            const real_t t189 = t186 + (t188 ? t143 : TB_C(0.0));
            const real_t t190 = (t183 ? t114 : TB_C(0.0)) + (t185 ? t116 : TB_C(0.0));
            const real_t t191 = t190 + (t188 ? t146 : TB_C(0.0));
            const real_t t192 = structure[0] * (wrench[0] - t189) + structure[4] * (wrench[1] -
                t191);
            const real_t t193 = structure[0] * structure[0] + structure[4] * structure[4];
            const real_t t194 = tb_min(tb_max(t192 * (TB_C(1.0) / t193), TB_C(0.0)),
                TB_TENSION_MAX);
            const real_t t195 = t189 + structure[0] * t194;
            const real_t t196 = t195 - wrench[0];
            const real_t t197 = t191 + structure[4] * t194;
            const real_t t198 = t197 - wrench[1];
            const real_t t199 = facet_0 < t7 ? t196 * t196 + t198 * t198 : TB_C(1e+30);
            const bool t200 = t199 < TB_C(1e+30);
            const real_t t201 = t200 ? t199 : TB_C(1e+30);
            const bool t202 = t179 < t201;
            const real_t t203 = t202 ? t179 : t201;
            const bool t204 = t155 < t203;
            const bool t205 = t125 < (t204 ? t155 : t203);
            real_t t206, t207;
            if (t205) {
                t206 = t121;
                t207 = t123;
            } else {
                real_t t208, t209;
                if (t204) {
                    t208 = t151;
                    t209 = t153;
                } else {
                    t208 = t202 ? t175 : (t200 ? t195 : TB_C(0.0));
                    t209 = t202 ? t177 : (t200 ? t197 : TB_C(0.0));
                }
                t206 = t208;
                t207 = t209;
            }
            t85 = t206;
            t86 = t207;
        } else {
            const real_t t210 = tb_min(tb_min(tb_min(tb_min(TB_C(1.0), t47), t57), t67), t77);
            const real_t t211 = tb_max(t210, TB_C(0.0));
            t85 = wrench[0] * t211;
            t86 = wrench[1] * t211;
        }
        const real_t t212 = TB_EPSILON * TB_C(32.0);
        served_0 = t85 + t212 * (t4 - t85);
        served_1 = t86 + t212 * (t1 - t86);
    }
    const real_t inner_0 = served_0 + TB_C(3.814697265625e-06) * (t4 - served_0);
    const real_t inner_1 = served_1 + TB_C(3.814697265625e-06) * (t1 - served_1);
    served[0] = served_0;
    served[1] = served_1;
    inner[0] = inner_0;
    inner[1] = inner_1;
    return t40 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_served_wrench_closest(const real_t structure[8], const real_t wrench[2],
    real_t served[2], real_t inner[2])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) <= TB_C(32.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(80000.0))) {
        served[0] = TB_C(0.0);
        served[1] = TB_C(0.0);
        inner[0] = TB_C(0.0);
        inner[1] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = structure[4] + structure[5] + structure[6] + structure[7];
    const real_t t1 = TB_C(5.0) * t0;
    const real_t t2 = wrench[1] - t1;
    const real_t t3 = structure[0] + structure[1] + structure[2] + structure[3];
    const real_t t4 = TB_C(5.0) * t3;
    const real_t t5 = wrench[0] - t4;
    const real_t t6 = structure[0] * t2 - structure[4] * t5;
    const real_t t7 = TB_ABS(t6);
    const real_t t8 = structure[0] * structure[5];
    const real_t t9 = structure[4] * structure[1];
    const real_t t10 = t8 - t9;
    const real_t t11 = TB_ABS(t10);
    const real_t t12 = structure[0] * structure[6];
    const real_t t13 = structure[4] * structure[2];
    const real_t t14 = t12 - t13;
    const real_t t15 = TB_ABS(t14);
    const real_t t16 = structure[0] * structure[7];
    const real_t t17 = structure[4] * structure[3];
    const real_t t18 = t16 - t17;
    const real_t t19 = TB_ABS(t18);
    /* facets of the feasible wrenches, half distances */
    const real_t facet_0 = TB_C(5.0) * (t11 + t15 + t19);
    const real_t t20 = t2 * structure[1] - structure[5] * t5;
    const real_t t21 = TB_ABS(t20);
    const real_t t22 = structure[6] * structure[1];
    const real_t t23 = structure[5] * structure[2];
    const real_t t24 = t22 - t23;
    const real_t t25 = TB_ABS(t24);
    const real_t t26 = structure[7] * structure[1];
    const real_t t27 = structure[5] * structure[3];
    const real_t t28 = t26 - t27;
    const real_t t29 = TB_ABS(t28);
    const real_t facet_1 = TB_C(5.0) * (t11 + t25 + t29);
    const real_t t30 = t2 * structure[2] - structure[6] * t5;
    const real_t t31 = TB_ABS(t30);
    const real_t t32 = structure[7] * structure[2];
    const real_t t33 = structure[6] * structure[3];
    const real_t t34 = t32 - t33;
    const real_t t35 = TB_ABS(t34);
    const real_t facet_2 = TB_C(5.0) * (t15 + t25 + t35);
    const bool t36 = t7 <= facet_0 && t21 <= facet_1 && t31 <= facet_2;
    const real_t t37 = t2 * structure[3] - structure[7] * t5;
    const real_t t38 = TB_ABS(t37);
    const real_t facet_3 = TB_C(5.0) * (t35 + (t19 + t29));
    const bool t39 = t36 && t38 <= facet_3;
    const bool t40 = !t39;
    real_t served_0, served_1;
    if (t39) {
        served_0 = wrench[0];
        served_1 = wrench[1];
    } else {
        const bool t41 = TB_C(0.0) < t37;
        const real_t t42 = TB_C(16.0) * TB_EPSILON;
        const bool t43 = t19 <= t42;
        const real_t t44 = structure[0] * structure[3] + structure[4] * structure[7];
        const bool t45 = TB_C(0.0) < t44;
        const bool t46 = !t43;
        const bool t47 = (t43 && !t45) || (t46 && TB_C(0.0) < t17 - t16);
        const bool t48 = !t41;
        const bool t49 = (t41 && t47) || (t48 && !t47);
        const real_t t50 = structure[0] * TB_TENSION_MAX;
        const bool t51 = t29 <= t42;
        const real_t t52 = structure[1] * structure[3] + structure[5] * structure[7];
        const bool t53 = TB_C(0.0) < t52;
        const bool t54 = !t51;
        const bool t55 = (t51 && !t53) || (t54 && TB_C(0.0) < t27 - t26);
        const bool t56 = (t41 && t55) || (t48 && !t55);
        const real_t t57 = structure[1] * TB_TENSION_MAX;
        const real_t t58 = (t49 ? t50 : TB_C(0.0)) + (t56 ? t57 : TB_C(0.0));
        const bool t59 = t35 <= t42;
        const real_t t60 = structure[2] * structure[3] + structure[6] * structure[7];
        const bool t61 = TB_C(0.0) < t60;
        const bool t62 = !t59;
        const bool t63 = (t59 && !t61) || (t62 && TB_C(0.0) < t33 - t32);
        const bool t64 = (t41 && t63) || (t48 && !t63);
        const real_t t65 = structure[2] * TB_TENSION_MAX;
        const real_t t66 = t58 + (t64 ? t65 : TB_C(0.0));
        const real_t t67 = structure[4] * TB_TENSION_MAX;
        const real_t t68 = structure[5] * TB_TENSION_MAX;
        const real_t t69 = (t49 ? t67 : TB_C(0.0)) + (t56 ? t68 : TB_C(0.0));
        const real_t t70 = structure[6] * TB_TENSION_MAX;
        const real_t t71 = t69 + (t64 ? t70 : TB_C(0.0));
        const real_t t72 = structure[3] * (wrench[0] - t66) + structure[7] * (wrench[1] - t71);
        const real_t t73 = structure[3] * structure[3] + structure[7] * structure[7];
        const real_t t74 = tb_min(tb_max(t72 * (TB_C(1.0) / t73), TB_C(0.0)), TB_TENSION_MAX);
        const real_t t75 = t66 + structure[3] * t74;
        const real_t t76 = t75 - wrench[0];
        const real_t t77 = t71 + structure[7] * t74;
        const real_t t78 = t77 - wrench[1];
        const real_t t79 = facet_3 < t38 ? t76 * t76 + t78 * t78 : TB_C(1e+30);
        const bool t80 = TB_C(0.0) < t30;
        const bool t81 = t15 <= t42;
        const real_t t82 = structure[0] * structure[2] + structure[4] * structure[6];
        const bool t83 = TB_C(0.0) < t82;
        const bool t84 = !t81;
        const bool t85 = (t81 && !t83) || (t84 && TB_C(0.0) < t13 - t12);
        const bool t86 = !t80;
        const bool t87 = (t80 && t85) || (t86 && !t85);
        const bool t88 = t25 <= t42;
        const real_t t89 = structure[1] * structure[2] + structure[5] * structure[6];
        const bool t90 = TB_C(0.0) < t89;
        const bool t91 = !t88;
        const bool t92 = (t88 && !t90) || (t91 && TB_C(0.0) < t23 - t22);
        const bool t93 = (t80 && t92) || (t86 && !t92);
        const real_t t94 = (t87 ? t50 : TB_C(0.0)) + (t93 ? t57 : TB_C(0.0));
        const bool t95 = (t59 && t61) || (t62 && TB_C(0.0) < t34);
        const bool t96 = (t80 && t95) || (t86 && !t95);
        const real_t t97 = structure[3] * TB_TENSION_MAX;
        const real_t t98 = t94 + (t96 ? t97 : TB_C(0.0));
        const real_t t99 = (t87 ? t67 : TB_C(0.0)) + (t93 ? t68 : TB_C(0.0));
        const real_t t100 = structure[7] * TB_TENSION_MAX;
        const real_t t101 = t99 + (t96 ? t100 : TB_C(0.0));
        const real_t t102 = structure[2] * (wrench[0] - t98) + structure[6] * (wrench[1] -
            t101);
        const real_t t103 = structure[2] * structure[2] + structure[6] * structure[6];
        const real_t t104 = tb_min(tb_max(t102 * (TB_C(1.0) / t103), TB_C(0.0)),
            TB_TENSION_MAX);
        const real_t t105 = t98 + structure[2] * t104;
        const real_t t106 = t105 - wrench[0];
        const real_t t107 = t101 + structure[6] * t104;
        const real_t t108 = t107 - wrench[1];
        const real_t t109 = facet_2 < t31 ? t106 * t106 + t108 * t108 : TB_C(1e+30);
        const bool t110 = TB_C(0.0) < t20;
        const bool t111 = t11 <= t42;
        const real_t t112 = structure[0] * structure[1] + structure[4] * structure[5];
        const bool t113 = TB_C(0.0) < t112;
        const bool t114 = !t111;
        const bool t115 = (t111 && !t113) || (t114 && TB_C(0.0) < t9 - t8);
        const bool t116 = !t110;
        const bool t117 = (t110 && t115) || (t116 && !t115);
        const bool t118 = (t88 && t90) || (t91 && TB_C(0.0) < t24);
        const bool t119 = (t110 && t118) || (t116 && !t118);
        const real_t t120 = (t117 ? t50 : TB_C(0.0)) + (t119 ? t65 : TB_C(0.0));
        const bool t121 = (t51 && t53) || (t54 && TB_C(0.0) < t28);
        const bool t122 = (t110 && t121) || (t116 && !t121);
        const real_t t123 = t120 + (t122 ? t97 : TB_C(0.0));
        const real_t t124 = (t117 ? t67 : TB_C(0.0)) + (t119 ? t70 : TB_C(0.0));
        const real_t t125 = t124 + (t122 ? t100 : TB_C(0.0));
        const real_t t126 = structure[1] * (wrench[0] - t123) + structure[5] * (wrench[1] -
            t125);
        const real_t t127 = structure[1] * structure[1] + structure[5] * structure[5];
        const real_t t128 = tb_min(tb_max(t126 * (TB_C(1.0) / t127), TB_C(0.0)),
            TB_TENSION_MAX);
        const real_t t129 = t123 + structure[1] * t128;
        const real_t t130 = t129 - wrench[0];
        const real_t t131 = t125 + structure[5] * t128;
        const real_t t132 = t131 - wrench[1];
        const real_t t133 = facet_1 < t21 ? t130 * t130 + t132 * t132 : TB_C(1e+30);
        const bool t134 = TB_C(0.0) < t6;
        const bool t135 = (t111 && t113) || (t114 && TB_C(0.0) < t10);
        const bool t136 = !t134;
        const bool t137 = (t134 && t135) || (t136 && !t135);
        const bool t138 = (t81 && t83) || (t84 && TB_C(0.0) < t14);
        const bool t139 = (t134 && t138) || (t136 && !t138);
        const real_t t140 = (t137 ? t57 : TB_C(0.0)) + (t139 ? t65 : TB_C(0.0));
        const bool t141 = (t43 && t45) || (t46 && TB_C(0.0) < t18);
        const bool t142 = (t134 && t141) || (t136 && !t141);
        const real_t t143 = t140 + (t142 ? t97 : TB_C(0.0));
        const real_t t144 = (t137 ? t68 : TB_C(0.0)) + (t139 ? t70 : TB_C(0.0));
        const real_t t145 = t144 + (t142 ? t100 : TB_C(0.0));
        const real_t t146 = structure[0] * (wrench[0] - t143) + structure[4] * (wrench[1] -
            t145);
        const real_t t147 = structure[0] * structure[0] + structure[4] * structure[4];
        const real_t t148 = tb_min(tb_max(t146 * (TB_C(1.0) / t147), TB_C(0.0)),
            TB_TENSION_MAX);
        const real_t t149 = t143 + structure[0] * t148;
        const real_t t150 = t149 - wrench[0];
        const real_t t151 = t145 + structure[4] * t148;
        const real_t t152 = t151 - wrench[1];
        const real_t t153 = facet_0 < t7 ? t150 * t150 + t152 * t152 : TB_C(1e+30);
        const bool t154 = t153 < TB_C(1e+30);
        const real_t t155 = t154 ? t153 : TB_C(1e+30);
        const bool t156 = t133 < t155;
        const real_t t157 = t156 ? t133 : t155;
        const bool t158 = t109 < t157;
        const bool t159 = t79 < (t158 ? t109 : t157);
        real_t t160, t161;
        if (t159) {
            t160 = t75;
            t161 = t77;
        } else {
            real_t t162, t163;
            if (t158) {
                t162 = t105;
                t163 = t107;
            } else {
                t162 = t156 ? t129 : (t154 ? t149 : TB_C(0.0));
                t163 = t156 ? t131 : (t154 ? t151 : TB_C(0.0));
            }
            t160 = t162;
            t161 = t163;
        }
        const real_t t164 = TB_EPSILON * TB_C(32.0);
        served_0 = t160 + t164 * (t4 - t160);
        served_1 = t161 + t164 * (t1 - t161);
    }
    const real_t inner_0 = served_0 + TB_C(3.814697265625e-06) * (t4 - served_0);
    const real_t inner_1 = served_1 + TB_C(3.814697265625e-06) * (t1 - served_1);
    served[0] = served_0;
    served[1] = served_1;
    inner[0] = inner_0;
    inner[1] = inner_1;
    return t40 ? TB_INFEASIBLE : TB_OK;
}

/* Refuses with a status: tension is 0 N; delivered is 0 N; kkt_residual is 0 N. */
static tb_status tb_refuse_distribute_tension_paper(tb_status status, real_t tension[4],
    real_t delivered[2], real_t kkt_residual[1])
{
    tension[0] = TB_C(0.0);
    tension[1] = TB_C(0.0);
    tension[2] = TB_C(0.0);
    tension[3] = TB_C(0.0);
    delivered[0] = TB_C(0.0);
    delivered[1] = TB_C(0.0);
    kkt_residual[0] = TB_C(0.0);
    return status;
}

tb_status tb_distribute_tension_paper(const real_t structure[8], const real_t wrench[2],
    real_t tension[4], real_t delivered[2], real_t kkt_residual[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) <= TB_C(32.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(80000.0))) {
        return tb_refuse_distribute_tension_paper(TB_OUT_OF_DOMAIN, tension, delivered, kkt_residual);
    }
    const real_t t0 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t1 = t0 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t2 = TB_SQRT(t1);
    const real_t t3 = TB_COPYSIGN(t2, structure[0]);
    const real_t t4 = structure[0] + t3;
    const real_t t5 = t4 * structure[4] + structure[5] * structure[1] + structure[2] *
        structure[6];
    const real_t t6 = TB_C(1.0) / (t2 * (t2 + TB_ABS(structure[0])));
    const real_t t7 = (t5 + structure[3] * structure[7]) * t6;
    const real_t t8 = structure[5] - structure[1] * t7;
    const real_t t9 = structure[6] - structure[2] * t7;
    const real_t t10 = structure[7] - structure[3] * t7;
    const real_t t11 = TB_SQRT(t8 * t8 + t9 * t9 + t10 * t10);
    const real_t t12 = TB_COPYSIGN(t11, t8);
    const real_t t13 = t8 + t12;
    const real_t t14 = wrench[0] / t3;
    const real_t t15 = (wrench[1] + (structure[4] - t4 * t7) * t14) / t12;
    const real_t t16 = TB_C(1.0) / (t11 * (t11 + TB_ABS(t8)));
    const real_t t17 = t13 * t15 * t16;
    const real_t t18 = t10 * t17;
    const real_t t19 = t13 * t17 - t15;
    const real_t t20 = t9 * t17;
    const real_t t21 = structure[1] * t19 - t4 * t14 + structure[2] * t20;
    const real_t t22 = t6 * (t21 + structure[3] * t18);
    const real_t t23 = structure[3] * t22;
    /* the least-norm tensions that exert the wrench */
    const real_t start_3 = t18 - t23;
    const real_t t24 = TB_C(3.0) * TB_EPSILON * (TB_ABS(wrench[0]) + TB_ABS(wrench[1]));
    const real_t t25 = TB_ABS(t3);
    const real_t t26 = TB_ABS(t12);
    const real_t t27 = TB_C(1.0) / tb_min(t25, t26);
    const real_t t28 = t24 * t27;
    const real_t t29 = structure[2] * t22;
    const real_t start_2 = t20 - t29;
    const real_t t30 = t28 + start_2;
    const real_t t31 = structure[1] * t22;
    const real_t start_1 = t19 - t31;
    const real_t t32 = t28 + start_1;
    const real_t t33 = t9 * t16;
    const real_t t34 = TB_C(1.0) - t9 * t33;
    const real_t t35 = t13 * t33;
    const real_t t36 = t10 * t33;
    const real_t t37 = structure[2] * t34 - structure[1] * t35 - structure[3] * t36;
    const real_t t38 = t6 * t37;
    const real_t t39 = t4 * t38;
    const real_t t40 = t35 + structure[1] * t38;
    const real_t t41 = t10 * t16;
    const real_t t42 = TB_C(1.0) - t10 * t41;
    const real_t t43 = t13 * t41;
    const real_t t44 = t9 * t41;
    const real_t t45 = structure[3] * t42 - (structure[1] * t43 + structure[2] * t44);
    const real_t t46 = t6 * t45;
    const real_t t47 = t4 * t46;
    const real_t t48 = t43 + structure[1] * t46;
    const real_t t49 = t39 * t40 + t47 * t48;
    const real_t t50 = t14 + t4 * t22;
    const real_t t51 = t50 + TB_C(1000000000000.0);
    const real_t t52 = tb_min(tb_max(TB_C(0.0), t50), t51);
    const real_t t53 = t28 < TB_ABS(t52) ? t52 : TB_C(0.0);
    const real_t t54 = t53 / tb_max(t39 * t39 + t47 * t47, TB_EPSILON);
    const real_t t55 = t49 * t54;
    const real_t t56 = TB_C(1000000000000.0) - start_1;
    const real_t t57 = t28 + t56;
    const real_t t58 = tb_max(-(t32 + t55), t55 - t57);
    const bool t59 = TB_C(0.0) < t58;
    const real_t t60 = t44 + structure[2] * t46;
    const real_t t61 = t34 - structure[2] * t38;
    const real_t t62 = t48 * t60 - t40 * t61;
    const real_t t63 = t40 * t60 + t48 * t61;
    const real_t t64 = TB_EPSILON * TB_C(16.0);
    const real_t t65 = t50 - t28;
    const real_t t66 = t28 + t51;
    const real_t t67 = t47 * t60 - t39 * t61;
    const real_t t68 = t36 + structure[3] * t38;
    const real_t t69 = t42 - structure[3] * t46;
    const real_t t70 = t40 * t68 - t48 * t69;
    const real_t t71 = t40 * t69 + t48 * t68;
    const real_t t72 = t39 * t68 - t47 * t69;
    const real_t t73 = t28 * TB_C(2.0);
    const real_t t74 = t28 * TB_C(1024.0);
    real_t t75, t76, t77, t78, t79;
    if (t59) {
        const real_t t80 = tb_min(tb_max(t55, t31 - t19), t56);
        const real_t t81 = TB_C(1.0) / tb_max(t40 * t40 + t48 * t48, TB_EPSILON);
        const real_t t82 = t80 * t81;
        const real_t t83 = t40 * t47 - t39 * t48;
        const bool t84 = TB_ABS(t83) <= t64;
        const real_t t85 = t49 * t82;
        const real_t t86 = TB_C(1.0) / t83;
        real_t t87, t88;
        if (t84) {
            t87 = -TB_C(1000000000000.0);
            t88 = TB_C(1000000000000.0);
        } else {
            const real_t t89 = (t65 - t85) * t86;
            const real_t t90 = t86 * (t66 - t85);
            t87 = tb_min(t89, t90);
            t88 = tb_max(t89, t90);
        }
        const real_t t91 = tb_min(tb_max(TB_C(0.0), t87), t88);
        const real_t t92 = TB_C(0.0) < TB_ABS(t91) ? t91 * (t49 * t86) : TB_C(0.0);
        const real_t t93 = t55 < t80 ? t92 - t82 : t82 - t92;
        real_t t94;
        if (TB_C(0.0) < t93) {
            const real_t t95 = t84 ? TB_C(0.0) : t73 * TB_ABS(t86);
            const real_t t96 = t87 + t95 < t88 - t95 && t74 < t58 ? t93 : TB_C(0.0);
            t94 = t96;
        } else {
            t94 = TB_C(0.0);
        }
        t75 = t62 * t82 + t63 * t91;
        t76 = t82 * t70 - t91 * t71;
        t77 = t94;
        t78 = t85 + t83 * t91;
        t79 = t80;
    } else {
        t75 = t54 * t67;
        t76 = t54 * t72;
        t77 = TB_C(0.0);
        t78 = t53;
        t79 = t55;
    }
    const real_t t97 = TB_C(1000000000000.0) - start_2;
    const real_t t98 = t28 + t97;
    const real_t t99 = tb_max(-(t30 + t75), t75 - t98);
    const bool t100 = TB_C(0.0) < t99;
    const real_t t101 = t61 * t69;
    const real_t t102 = t60 * t68;
    const real_t t103 = t61 * t68 + t60 * t69;
    real_t t104, t105, t106, t107, t108;
    if (t100) {
        const bool t109 = TB_ABS(t63) <= t64;
        const real_t t110 = tb_min(tb_max(t75, t29 - t20), t97);
        const real_t t111 = TB_C(1.0) / tb_max(t61 * t61 + t60 * t60, TB_EPSILON);
        const real_t t112 = t110 * t111;
        const real_t t113 = t62 * t112;
        const real_t t114 = TB_C(1.0) / t63;
        real_t t115, t116;
        if (t109) {
            t115 = -TB_C(1000000000000.0);
            t116 = TB_C(1000000000000.0);
        } else {
            const real_t t117 = (t32 + t113) * t114;
            const real_t t118 = -(t114 * (t57 - t113));
            t115 = tb_min(t117, t118);
            t116 = tb_max(t117, t118);
        }
        const real_t t119 = t47 * t61 + t39 * t60;
        const bool t120 = TB_ABS(t119) <= t64;
        const real_t t121 = t67 * t112;
        const real_t t122 = TB_C(1.0) / t119;
        real_t t123, t124;
        if (t120) {
            t123 = -TB_C(1000000000000.0);
            t124 = TB_C(1000000000000.0);
        } else {
            const real_t t125 = -((t65 - t121) * t122);
            const real_t t126 = -(t122 * (t66 - t121));
            t123 = tb_min(t125, t126);
            t124 = tb_max(t125, t126);
        }
        const real_t t127 = tb_min(tb_max(TB_C(0.0), tb_max(t115, t123)), tb_min(t116, t124));
        real_t t128;
        if (TB_C(0.0) < TB_ABS(t127)) {
            const real_t t129 = -(t62 * t114);
            const real_t t130 = -(t67 * t122);
            const real_t t131 = TB_C(0.0) < t127 ? (t123 < t115 ? t129 : t130) : (t116 < t124 ?
                t129 : t130);
            t128 = t127 * t131;
        } else {
            t128 = TB_C(0.0);
        }
        const real_t t132 = t75 < t110 ? t128 - t112 : t112 - t128;
        real_t t133;
        if (TB_C(0.0) < t132) {
            real_t t134;
            if (t120) {
                t134 = TB_C(0.0);
            } else {
                t134 = t73 * TB_ABS(TB_C(1.0) / -t119);
            }
            real_t t135;
            if (t109) {
                t135 = TB_C(0.0);
            } else {
                t135 = t73 * TB_ABS(TB_C(1.0) / -t63);
            }
            const bool t136 = tb_max(t123 + t134, t115 + t135) < tb_min(t124 - t134, t116 -
                t135);
            t133 = t136 && t74 < t99 ? t132 : TB_C(0.0);
        } else {
            t133 = TB_C(0.0);
        }
        t104 = (t101 - t102) * t127 - t112 * t103;
        t105 = t133;
        t106 = t121 - t119 * t127;
        t107 = t113 - t63 * t127;
        t108 = t110;
    } else {
        t104 = t76;
        t105 = t77;
        t106 = t78;
        t107 = t79;
        t108 = t75;
    }
    const real_t t137 = TB_C(1000000000000.0) - start_3;
    const real_t t138 = tb_max(-(start_3 + t28 + t104), t104 - (t28 + t137));
    const bool t139 = TB_C(0.0) < t138;
    real_t t140, t141, t142, t143, t144;
    if (t139) {
        const real_t t145 = tb_min(tb_max(t104, t23 - t18), t137);
        const real_t t146 = TB_C(1.0) / tb_max(t68 * t68 + t69 * t69, TB_EPSILON);
        const real_t t147 = t145 * t146;
        const real_t t148 = t102 - t101;
        const bool t149 = TB_ABS(t148) <= t64;
        const real_t t150 = t103 * t147;
        const real_t t151 = TB_C(1.0) / t148;
        real_t t152, t153;
        if (t149) {
            t152 = -TB_C(1000000000000.0);
            t153 = TB_C(1000000000000.0);
        } else {
            const real_t t154 = (t150 - t30) * t151;
            const real_t t155 = t151 * (t98 + t150);
            t152 = tb_min(t154, t155);
            t153 = tb_max(t154, t155);
        }
        const bool t156 = TB_ABS(t71) <= t64;
        const real_t t157 = t70 * t147;
        const real_t t158 = TB_C(1.0) / t71;
        real_t t159, t160;
        if (t156) {
            t159 = -TB_C(1000000000000.0);
            t160 = TB_C(1000000000000.0);
        } else {
            const real_t t161 = -((t32 + t157) * t158);
            const real_t t162 = t158 * (t57 - t157);
            t159 = tb_min(t161, t162);
            t160 = tb_max(t161, t162);
        }
        const real_t t163 = t47 * t68 + t39 * t69;
        const bool t164 = TB_ABS(t163) <= t64;
        const real_t t165 = t72 * t147;
        const real_t t166 = TB_C(1.0) / t163;
        real_t t167, t168;
        if (t164) {
            t167 = -TB_C(1000000000000.0);
            t168 = TB_C(1000000000000.0);
        } else {
            const real_t t169 = (t65 - t165) * t166;
            const real_t t170 = t166 * (t66 - t165);
            t167 = tb_min(t169, t170);
            t168 = tb_max(t169, t170);
        }
        const real_t t171 = tb_max(t159, t167);
        const real_t t172 = tb_min(t160, t168);
        const real_t t173 = tb_min(tb_max(TB_C(0.0), tb_max(t152, t171)), tb_min(t153, t172));
        real_t t174;
        if (TB_C(0.0) < TB_ABS(t173)) {
            const real_t t175 = -(t103 * t151);
            const real_t t176 = t70 * t158;
            const real_t t177 = t72 * t166;
            real_t t178;
            if (TB_C(0.0) < t173) {
                t178 = t171 < t152 ? t175 : (t167 < t159 ? t176 : t177);
            } else {
                t178 = t153 < t172 ? t175 : (t160 < t168 ? t176 : t177);
            }
            t174 = t173 * t178;
        } else {
            t174 = TB_C(0.0);
        }
        const real_t t179 = t104 < t145 ? t174 - t147 : t147 - t174;
        real_t t180;
        if (TB_C(0.0) < t179) {
            const real_t t181 = t164 ? TB_C(0.0) : t73 * TB_ABS(t166);
            const real_t t182 = t156 ? TB_C(0.0) : t73 * TB_ABS(t158);
            const real_t t183 = t149 ? TB_C(0.0) : t73 * TB_ABS(t151);
            const real_t t184 = tb_max(tb_max(t167 + t181, t159 + t182), t152 + t183);
            const real_t t185 = tb_min(tb_min(t168 - t181, t160 - t182), t153 - t183);
            t180 = t184 < t185 && t74 < t138 ? t179 : TB_C(0.0);
        } else {
            t180 = TB_C(0.0);
        }
        t140 = t180;
        t141 = t165 + t163 * t173;
        t142 = t157 + t71 * t173;
        t143 = t148 * t173 - t150;
        t144 = t145;
    } else {
        t140 = t105;
        t141 = t106;
        t142 = t107;
        t143 = t108;
        t144 = t104;
    }
    const real_t t186 = tb_min(tb_max(t141 - t50, TB_C(0.0)), TB_C(1000000000000.0));
    const real_t t187 = tb_min(tb_max(start_1 + t142, TB_C(0.0)), TB_C(1000000000000.0));
    const real_t t188 = tb_min(tb_max(start_2 + t143, TB_C(0.0)), TB_C(1000000000000.0));
    const real_t t189 = structure[0] * t186 + structure[1] * t187 + structure[2] * t188;
    const real_t t190 = tb_min(tb_max(start_3 + t144, TB_C(0.0)), TB_C(1000000000000.0));
    const real_t t191 = tb_max(t140, TB_ABS(t189 + structure[3] * t190 - wrench[0]));
    const real_t t192 = structure[4] * t186 + structure[5] * t187 + structure[6] * t188;
    const real_t t193 = tb_max(t191, TB_ABS(t192 + structure[7] * t190 - wrench[1]));
    const real_t t194 = TB_EPSILON * TB_C(128.0) * tb_max(tb_max(tb_max(t186, t187), t188),
        t190);
    const bool t195 = t193 <= tb_min(t27 * t194, TB_C(0.01));
    /* what the tensions exert, S T */
    real_t tension_0, tension_1, tension_2, tension_3, delivered_0, delivered_1, kkt_residual_0;
    if (t195) {
        const real_t t196 = tb_min(t186, TB_TENSION_MAX);
        const real_t t197 = tb_min(t187, TB_TENSION_MAX);
        const real_t t198 = tb_min(t188, TB_TENSION_MAX);
        const real_t t199 = tb_min(t190, TB_TENSION_MAX);
        const real_t t200 = structure[0] * t196 + structure[1] * t197 + structure[2] * t198;
        const real_t t201 = structure[4] * t196 + structure[5] * t197 + structure[6] * t198;
        tension_0 = t196;
        tension_1 = t197;
        tension_2 = t198;
        tension_3 = t199;
        delivered_0 = t200 + structure[3] * t199;
        delivered_1 = t201 + structure[7] * t199;
        kkt_residual_0 = t193;
    } else {
        tension_0 = TB_C(0.0);
        tension_1 = TB_C(0.0);
        tension_2 = TB_C(0.0);
        tension_3 = TB_C(0.0);
        delivered_0 = TB_C(0.0);
        delivered_1 = TB_C(0.0);
        kkt_residual_0 = TB_C(0.0);
    }
    const real_t t202 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t203 = !(t202 < t25 && t202 < t26);
    const bool t204 = !t195;
    const bool t205 = TB_TENSION_MAX < t186 || TB_TENSION_MAX < t187 || TB_TENSION_MAX < t188;
    const bool t206 = t205 || TB_TENSION_MAX < t190;
    if (t203) {
        return tb_refuse_distribute_tension_paper(TB_SINGULAR, tension, delivered, kkt_residual);
    }
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    delivered[0] = delivered_0;
    delivered[1] = delivered_1;
    kkt_residual[0] = kkt_residual_0;
    return (t204 || t206) ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_distribute_tension_scale(const real_t structure[8], const real_t wrench[2],
    real_t tension[4], real_t delivered[2], real_t kkt_residual[1])
{
    tb_status status = tb_least_norm_tension_quick(structure, wrench, tension, delivered,
        kkt_residual);
    if (status != TB_INACCURATE) {
        return status;
    }
    real_t served[2];
    real_t inner[2];
    tb_status verdict = tb_served_wrench_scale(structure, wrench, served, inner);
    if (status == TB_INACCURATE && verdict == TB_INFEASIBLE) {
        status = tb_least_norm_tension_quick(structure, served, tension, delivered,
            kkt_residual);
    }
    if (status == TB_INACCURATE) {
        status = tb_least_norm_tension(structure, served, tension, delivered, kkt_residual);
    }
    if (status == TB_INACCURATE) {
        verdict = TB_INFEASIBLE;
        status = tb_least_norm_tension_quick(structure, inner, tension, delivered,
            kkt_residual);
    }
    if (status == TB_INACCURATE) {
        verdict = TB_INFEASIBLE;
        status = tb_least_norm_tension(structure, inner, tension, delivered, kkt_residual);
    }
    return status == TB_OK ? verdict : status;
}

tb_status tb_distribute_tension_closest(const real_t structure[8], const real_t wrench[2],
    real_t tension[4], real_t delivered[2], real_t kkt_residual[1])
{
    tb_status status = tb_least_norm_tension_quick(structure, wrench, tension, delivered,
        kkt_residual);
    if (status != TB_INACCURATE) {
        return status;
    }
    real_t served[2];
    real_t inner[2];
    tb_status verdict = tb_served_wrench_closest(structure, wrench, served, inner);
    if (status == TB_INACCURATE && verdict == TB_INFEASIBLE) {
        status = tb_least_norm_tension_quick(structure, served, tension, delivered,
            kkt_residual);
    }
    if (status == TB_INACCURATE) {
        status = tb_least_norm_tension(structure, served, tension, delivered, kkt_residual);
    }
    if (status == TB_INACCURATE) {
        verdict = TB_INFEASIBLE;
        status = tb_least_norm_tension_quick(structure, inner, tension, delivered,
            kkt_residual);
    }
    if (status == TB_INACCURATE) {
        verdict = TB_INFEASIBLE;
        status = tb_least_norm_tension(structure, inner, tension, delivered, kkt_residual);
    }
    return status == TB_OK ? verdict : status;
}

tb_status tb_distribute_tension(const real_t structure[8], const real_t wrench[2],
    real_t tension[4], real_t delivered[2], real_t kkt_residual[1])
{
    return tb_distribute_tension_closest(structure, wrench, tension, delivered, kkt_residual);
}

