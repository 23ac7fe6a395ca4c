/* Regenerate: turnbuckle generate machines/yoon_fixed_orthogonal.toml --out <this folder>
 * Machine c858d0533419e597, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_tension.h"
#include "tb_machine.h"

/* Refuses with a status: tension is 3 N; delivered is 0 N; kkt_residual is 0 N. */
static tb_status tb_refuse_least_norm_tension_quick(tb_status status, real_t tension[4],
    real_t delivered[2], real_t kkt_residual[1])
{
    tension[0] = TB_TENSION_MIN;
    tension[1] = TB_TENSION_MIN;
    tension[2] = TB_TENSION_MIN;
    tension[3] = TB_TENSION_MIN;
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
    const real_t t8 = TB_TENSION_MIN - start_2;
    const real_t t9 = TB_TENSION_MAX - start_2;
    const real_t t10 = tb_min(tb_max(TB_C(0.0), t8), t9);
    const real_t t11 = t1 + (t4 + t5);
    const real_t t12 = TB_C(1.0) / tb_max(t11, TB_EPSILON);
    const real_t t13 = t10 * (t10 * t12);
    const real_t height_2 = structure[2] * wrench[1] - structure[6] * wrench[0];
    const real_t t14 = height_0 * cross_03 + height_1 * cross_13 + cross_23 * height_2;
    const real_t start_3 = t7 * t14;
    const real_t t15 = TB_TENSION_MIN - start_3;
    const real_t t16 = TB_TENSION_MAX - start_3;
    const real_t t17 = tb_min(tb_max(TB_C(0.0), t15), t16);
    const real_t t18 = t1 + (t3 + t6);
    const real_t t19 = TB_C(1.0) / tb_max(t18, TB_EPSILON);
    const real_t t20 = t17 * (t17 * t19);
    const real_t t21 = height_1 * cross_01 + cross_02 * height_2 + height_3 * cross_03;
    const real_t t22 = t7 * t21;
    const real_t t23 = TB_TENSION_MIN + t22;
    const real_t t24 = TB_TENSION_MAX + t22;
    const real_t t25 = tb_min(tb_max(TB_C(0.0), t23), t24);
    const real_t t26 = t6 + (t2 + t4);
    const real_t t27 = TB_C(1.0) / tb_max(t26, TB_EPSILON);
    const real_t t28 = t25 * (t25 * t27);
    const real_t t29 = height_0 * cross_01 - cross_12 * height_2 - height_3 * cross_13;
    const real_t start_1 = t7 * t29;
    const real_t t30 = TB_TENSION_MIN - start_1;
    const real_t t31 = TB_TENSION_MAX - start_1;
    const real_t t32 = tb_min(tb_max(TB_C(0.0), t30), t31);
    const real_t t33 = t3 + (t2 + t5);
    const real_t t34 = TB_C(1.0) / tb_max(t33, TB_EPSILON);
    const real_t t35 = t32 * (t32 * t34);
    const bool t36 = tb_max(t13, t20) <= tb_max(t28, t35);
    const real_t t37 = TB_SQRT(determinant * TB_C(0.5));
    const real_t t38 = TB_C(1.0) / t37;
    const real_t t39 = TB_EPSILON * TB_C(120.0) * t38;
    const real_t t40 = TB_EPSILON * TB_C(16.0);
    const real_t t41 = t23 - t39;
    const real_t t42 = t24 + t39;
    const bool t43 = TB_ABS(cross_03) <= t40;
    const real_t t44 = t8 - t39;
    const real_t t45 = cross_02 * cross_01 + cross_23 * cross_13;
    const real_t t46 = TB_C(1.0) / cross_03;
    const real_t t47 = t9 + t39;
    const bool t48 = TB_ABS(cross_02) <= t40;
    const real_t t49 = t15 - t39;
    const real_t t50 = cross_01 * cross_03 - cross_12 * cross_23;
    const real_t t51 = TB_C(1.0) / cross_02;
    const real_t t52 = t16 + t39;
    const bool t53 = TB_ABS(cross_13) <= t40;
    const real_t t54 = cross_23 * cross_03 - cross_12 * cross_01;
    const real_t t55 = TB_C(1.0) / cross_13;
    const real_t t56 = t30 - t39;
    const real_t t57 = t31 + t39;
    const real_t t58 = cross_01 * cross_13 + cross_02 * cross_23;
    const bool t59 = TB_ABS(cross_12) <= t40;
    const real_t t60 = TB_C(1.0) / cross_12;
    real_t t61, t62, t63, t64;
    if (t36) {
        const bool t65 = t35 <= t28;
        const real_t t66 = cross_02 * cross_12 + cross_13 * cross_03;
        const bool t67 = TB_ABS(cross_23) <= t40;
        const real_t t68 = TB_C(1.0) / cross_23;
        real_t t69, t70, t71, t72;
        if (t65) {
            const real_t t73 = t27 * (t39 < TB_ABS(t25) ? t25 : TB_C(0.0));
            const real_t t74 = t73 * t66;
            real_t t75, t76;
            if (t67) {
                t75 = -TB_C(1000000000000.0);
                t76 = TB_C(1000000000000.0);
            } else {
                const real_t t77 = t68 * (t56 + t74);
                const real_t t78 = t68 * (t57 + t74);
                t75 = tb_min(t77, t78);
                t76 = tb_max(t77, t78);
            }
            const real_t t79 = t73 * t54;
            real_t t80, t81;
            if (t53) {
                t80 = -TB_C(1000000000000.0);
                t81 = TB_C(1000000000000.0);
            } else {
                const real_t t82 = -(t55 * (t44 + t79));
                const real_t t83 = -(t55 * (t47 + t79));
                t80 = tb_min(t82, t83);
                t81 = tb_max(t82, t83);
            }
            const real_t t84 = t73 * t58;
            real_t t85, t86;
            if (t59) {
                t85 = -TB_C(1000000000000.0);
                t86 = TB_C(1000000000000.0);
            } else {
                const real_t t87 = t60 * (t49 - t84);
                const real_t t88 = t60 * (t52 - t84);
                t85 = tb_min(t87, t88);
                t86 = tb_max(t87, t88);
            }
            const real_t t89 = tb_min(tb_max(TB_C(0.0), tb_max(tb_max(t75, t80), t85)),
                tb_min(tb_min(t76, t81), t86));
            t69 = t26 * t73;
            t70 = cross_23 * t89 - t74;
            t71 = -(t79 + cross_13 * t89);
            t72 = t84 + cross_12 * t89;
        } else {
            const real_t t90 = t34 * (t39 < TB_ABS(t32) ? t32 : TB_C(0.0));
            const real_t t91 = t66 * t90;
            real_t t92, t93;
            if (t67) {
                t92 = -TB_C(1000000000000.0);
                t93 = TB_C(1000000000000.0);
            } else {
                const real_t t94 = -((t91 + t41) * t68);
                const real_t t95 = -(t68 * (t91 + t42));
                t92 = tb_min(t94, t95);
                t93 = tb_max(t94, t95);
            }
            const real_t t96 = t90 * t45;
            real_t t97, t98;
            if (t43) {
                t97 = -TB_C(1000000000000.0);
                t98 = TB_C(1000000000000.0);
            } else {
                const real_t t99 = (t44 + t96) * t46;
                const real_t t100 = t46 * (t96 + t47);
                t97 = tb_min(t99, t100);
                t98 = tb_max(t99, t100);
            }
            const real_t t101 = t90 * t50;
            real_t t102, t103;
            if (t48) {
                t102 = -TB_C(1000000000000.0);
                t103 = TB_C(1000000000000.0);
            } else {
                const real_t t104 = -((t49 + t101) * t51);
                const real_t t105 = -(t51 * (t101 + t52));
                t102 = tb_min(t104, t105);
                t103 = tb_max(t104, t105);
            }
            const real_t t106 = tb_max(TB_C(0.0), tb_max(tb_max(t92, t97), t102));
            const real_t t107 = tb_min(t106, tb_min(tb_min(t93, t98), t103));
            t69 = -(t91 + cross_23 * t107);
            t70 = t33 * t90;
            t71 = cross_03 * t107 - t96;
            t72 = -(t101 + cross_02 * t107);
        }
        t61 = t69;
        t62 = t70;
        t63 = t71;
        t64 = t72;
    } else {
        const bool t108 = t20 <= t13;
        const bool t109 = TB_ABS(cross_01) <= t40;
        const real_t t110 = cross_02 * cross_03 + cross_12 * cross_13;
        const real_t t111 = TB_C(1.0) / cross_01;
        real_t t112, t113, t114, t115;
        if (t108) {
            const real_t t116 = t12 * (t39 < TB_ABS(t10) ? t10 : TB_C(0.0));
            const real_t t117 = t54 * t116;
            real_t t118, t119;
            if (t53) {
                t118 = -TB_C(1000000000000.0);
                t119 = TB_C(1000000000000.0);
            } else {
                const real_t t120 = (t41 + t117) * t55;
                const real_t t121 = t55 * (t42 + t117);
                t118 = tb_min(t120, t121);
                t119 = tb_max(t120, t121);
            }
            const real_t t122 = t45 * t116;
            real_t t123, t124;
            if (t43) {
                t123 = -TB_C(1000000000000.0);
                t124 = TB_C(1000000000000.0);
            } else {
                const real_t t125 = -(t46 * (t56 + t122));
                const real_t t126 = -(t46 * (t122 + t57));
                t123 = tb_min(t125, t126);
                t124 = tb_max(t125, t126);
            }
            const real_t t127 = t116 * t110;
            real_t t128, t129;
            if (t109) {
                t128 = -TB_C(1000000000000.0);
                t129 = TB_C(1000000000000.0);
            } else {
                const real_t t130 = (t49 + t127) * t111;
                const real_t t131 = t111 * (t52 + t127);
                t128 = tb_min(t130, t131);
                t129 = tb_max(t130, t131);
            }
            const real_t t132 = tb_max(TB_C(0.0), tb_max(tb_max(t118, t123), t128));
            const real_t t133 = tb_min(t132, tb_min(tb_min(t119, t124), t129));
            t112 = cross_13 * t133 - t117;
            t113 = -(t122 + cross_03 * t133);
            t114 = t11 * t116;
            t115 = cross_01 * t133 - t127;
        } else {
            const real_t t134 = t19 * (t39 < TB_ABS(t17) ? t17 : TB_C(0.0));
            const real_t t135 = t58 * t134;
            real_t t136, t137;
            if (t59) {
                t136 = -TB_C(1000000000000.0);
                t137 = TB_C(1000000000000.0);
            } else {
                const real_t t138 = -((t41 - t135) * t60);
                const real_t t139 = -(t60 * (t42 - t135));
                t136 = tb_min(t138, t139);
                t137 = tb_max(t138, t139);
            }
            const real_t t140 = t50 * t134;
            real_t t141, t142;
            if (t48) {
                t141 = -TB_C(1000000000000.0);
                t142 = TB_C(1000000000000.0);
            } else {
                const real_t t143 = t51 * (t56 + t140);
                const real_t t144 = t51 * (t57 + t140);
                t141 = tb_min(t143, t144);
                t142 = tb_max(t143, t144);
            }
            const real_t t145 = t110 * t134;
            real_t t146, t147;
            if (t109) {
                t146 = -TB_C(1000000000000.0);
                t147 = TB_C(1000000000000.0);
            } else {
                const real_t t148 = -(t111 * (t44 + t145));
                const real_t t149 = -(t111 * (t47 + t145));
                t146 = tb_min(t148, t149);
                t147 = tb_max(t148, t149);
            }
            const real_t t150 = tb_max(TB_C(0.0), tb_max(tb_max(t136, t141), t146));
            const real_t t151 = tb_min(t150, tb_min(tb_min(t137, t142), t147));
            t112 = t135 - cross_12 * t151;
            t113 = cross_02 * t151 - t140;
            t114 = -(t145 + cross_01 * t151);
            t115 = t18 * t134;
        }
        t61 = t112;
        t62 = t113;
        t63 = t114;
        t64 = t115;
    }
    const real_t tension_0 = tb_min(tb_max(t61 - t22, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t tension_1 = tb_min(tb_max(start_1 + t62, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t tension_2 = tb_min(tb_max(start_2 + t63, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t tension_3 = tb_min(tb_max(start_3 + t64, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t t152 = structure[0] * tension_0 + structure[1] * tension_1;
    /* what the tensions exert, S T */
    const real_t delivered_0 = t152 + structure[2] * tension_2 + structure[3] * tension_3;
    const real_t t153 = structure[4] * tension_0 + structure[5] * tension_1;
    const real_t delivered_1 = t153 + structure[6] * tension_2 + structure[7] * tension_3;
    const real_t t154 = tb_max(TB_C(0.0), TB_ABS(delivered_0 - wrench[0]));
    const real_t kkt_residual_0 = tb_max(t154, TB_ABS(delivered_1 - wrench[1]));
    const bool t155 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0)) < t37;
    const bool t156 = !t155;
    const real_t t157 = tb_min(t38 * (TB_EPSILON * TB_C(480.0)), TB_C(0.01));
    const bool t158 = !(kkt_residual_0 <= t157);
    if (t156) {
        return tb_refuse_least_norm_tension_quick(TB_SINGULAR, tension, delivered, kkt_residual);
    }
    if (t158) {
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

/* Refuses with a status: tension is 3 N; delivered is 0 N; kkt_residual is 0 N. */
static tb_status tb_refuse_least_norm_tension(tb_status status, real_t tension[4],
    real_t delivered[2], real_t kkt_residual[1])
{
    tension[0] = TB_TENSION_MIN;
    tension[1] = TB_TENSION_MIN;
    tension[2] = TB_TENSION_MIN;
    tension[3] = TB_TENSION_MIN;
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
    /* the least-norm tensions that exert the wrench */
    const real_t start_3 = t18 - structure[3] * t22;
    const real_t t23 = TB_TENSION_MIN - start_3;
    const real_t t24 = TB_ABS(t3);
    const real_t t25 = TB_ABS(t12);
    const real_t t26 = TB_C(1.0) / tb_min(t24, t25);
    const real_t t27 = TB_C(30.0) * TB_EPSILON * t26;
    const real_t start_2 = t20 - structure[2] * t22;
    const real_t t28 = TB_TENSION_MIN - start_2;
    const real_t t29 = t28 - t27;
    const real_t start_1 = t19 - structure[1] * t22;
    const real_t t30 = TB_TENSION_MIN - start_1;
    const real_t t31 = t30 - t27;
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
    const real_t t50 = TB_TENSION_MIN + t49;
    const real_t t51 = t49 + TB_TENSION_MAX;
    const real_t t52 = tb_min(tb_max(TB_C(0.0), t50), t51);
    const real_t t53 = t27 < TB_ABS(t52) ? t52 : TB_C(0.0);
    const real_t t54 = t53 / tb_max(t38 * t38 + t46 * t46, TB_EPSILON);
    const real_t t55 = t48 * t54;
    const real_t t56 = TB_TENSION_MAX - start_1;
    const real_t t57 = t27 + t56;
    const real_t t58 = tb_max(t31 - t55, t55 - t57);
    const bool t59 = TB_C(0.0) < t58;
    const real_t t60 = t43 + structure[2] * t45;
    const real_t t61 = t33 - structure[2] * t37;
    const real_t t62 = t47 * t60 - t39 * t61;
    const real_t t63 = t39 * t60 + t47 * t61;
    const real_t t64 = TB_EPSILON * TB_C(16.0);
    const real_t t65 = t50 - t27;
    const real_t t66 = t27 + t51;
    const real_t t67 = t46 * t60 - t38 * t61;
    const real_t t68 = t35 + structure[3] * t37;
    const real_t t69 = t41 - structure[3] * t45;
    const real_t t70 = t39 * t68 - t47 * t69;
    const real_t t71 = t39 * t69 + t47 * t68;
    const real_t t72 = t38 * t68 - t46 * t69;
    const real_t t73 = t27 * TB_C(2.0);
    const real_t t74 = t27 * TB_C(1024.0);
    real_t t75, t76, t77, t78, t79;
    if (t59) {
        const real_t t80 = tb_min(tb_max(t55, t30), t56);
        const real_t t81 = TB_C(1.0) / tb_max(t39 * t39 + t47 * t47, TB_EPSILON);
        const real_t t82 = t80 * t81;
        const real_t t83 = t39 * t46 - t38 * t47;
        const bool t84 = TB_ABS(t83) <= t64;
        const real_t t85 = t48 * t82;
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
        const real_t t92 = TB_C(0.0) < TB_ABS(t91) ? t91 * (t48 * t86) : TB_C(0.0);
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
        t77 = t85 + t83 * t91;
        t78 = t80;
        t79 = t94;
    } else {
        t75 = t54 * t67;
        t76 = t54 * t72;
        t77 = t53;
        t78 = t55;
        t79 = TB_C(0.0);
    }
    const real_t t97 = TB_TENSION_MAX - start_2;
    const real_t t98 = t27 + t97;
    const real_t t99 = tb_max(t29 - t75, t75 - t98);
    const bool t100 = TB_C(0.0) < t99;
    const real_t t101 = t61 * t69;
    const real_t t102 = t60 * t68;
    const real_t t103 = t61 * t68 + t60 * t69;
    real_t t104, t105, t106, t107, t108;
    if (t100) {
        const bool t109 = TB_ABS(t63) <= t64;
        const real_t t110 = tb_min(tb_max(t75, t28), t97);
        const real_t t111 = TB_C(1.0) / tb_max(t61 * t61 + t60 * t60, TB_EPSILON);
        const real_t t112 = t110 * t111;
        const real_t t113 = t62 * t112;
        const real_t t114 = TB_C(1.0) / t63;
        real_t t115, t116;
        if (t109) {
            t115 = -TB_C(1000000000000.0);
            t116 = TB_C(1000000000000.0);
        } else {
            const real_t t117 = -((t31 - t113) * t114);
            const real_t t118 = -(t114 * (t57 - t113));
            t115 = tb_min(t117, t118);
            t116 = tb_max(t117, t118);
        }
        const real_t t119 = t46 * t61 + t38 * t60;
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
        t105 = t121 - t119 * t127;
        t106 = t113 - t63 * t127;
        t107 = t110;
        t108 = t133;
    } else {
        t104 = t76;
        t105 = t77;
        t106 = t78;
        t107 = t75;
        t108 = t79;
    }
    const real_t t137 = TB_TENSION_MAX - start_3;
    const real_t t138 = tb_max(t23 - t27 - t104, t104 - (t27 + t137));
    const bool t139 = TB_C(0.0) < t138;
    real_t t140, t141, t142, t143, t144;
    if (t139) {
        const real_t t145 = tb_min(tb_max(t104, t23), t137);
        const real_t t146 = TB_C(1.0) / tb_max(t68 * t68 + t69 * t69, TB_EPSILON);
        const real_t t147 = t145 * t146;
        const real_t t148 = t72 * t147;
        const real_t t149 = t46 * t68 + t38 * t69;
        const real_t t150 = t102 - t101;
        const bool t151 = TB_ABS(t150) <= t64;
        const real_t t152 = t103 * t147;
        const real_t t153 = TB_C(1.0) / t150;
        real_t t154, t155;
        if (t151) {
            t154 = -TB_C(1000000000000.0);
            t155 = TB_C(1000000000000.0);
        } else {
            const real_t t156 = (t29 + t152) * t153;
            const real_t t157 = t153 * (t98 + t152);
            t154 = tb_min(t156, t157);
            t155 = tb_max(t156, t157);
        }
        const bool t158 = TB_ABS(t71) <= t64;
        const real_t t159 = t70 * t147;
        const real_t t160 = TB_C(1.0) / t71;
        real_t t161, t162;
        if (t158) {
            t161 = -TB_C(1000000000000.0);
            t162 = TB_C(1000000000000.0);
        } else {
            const real_t t163 = (t31 - t159) * t160;
            const real_t t164 = t160 * (t57 - t159);
            t161 = tb_min(t163, t164);
            t162 = tb_max(t163, t164);
        }
        const bool t165 = TB_ABS(t149) <= t64;
        const real_t t166 = TB_C(1.0) / t149;
        real_t t167, t168;
        if (t165) {
            t167 = -TB_C(1000000000000.0);
            t168 = TB_C(1000000000000.0);
        } else {
            const real_t t169 = (t65 - t148) * t166;
            const real_t t170 = t166 * (t66 - t148);
            t167 = tb_min(t169, t170);
            t168 = tb_max(t169, t170);
        }
        const real_t t171 = tb_max(t161, t167);
        const real_t t172 = tb_min(t162, t168);
        const real_t t173 = tb_min(tb_max(TB_C(0.0), tb_max(t154, t171)), tb_min(t155, t172));
        real_t t174;
        if (TB_C(0.0) < TB_ABS(t173)) {
            const real_t t175 = -(t103 * t153);
            const real_t t176 = t70 * t160;
            const real_t t177 = t72 * t166;
            real_t t178;
            if (TB_C(0.0) < t173) {
                t178 = t171 < t154 ? t175 : (t167 < t161 ? t176 : t177);
            } else {
                t178 = t155 < t172 ? t175 : (t162 < t168 ? t176 : t177);
            }
            t174 = t173 * t178;
        } else {
            t174 = TB_C(0.0);
        }
        const real_t t179 = t104 < t145 ? t174 - t147 : t147 - t174;
        real_t t180;
        if (TB_C(0.0) < t179) {
            const real_t t181 = t165 ? TB_C(0.0) : t73 * TB_ABS(t166);
            const real_t t182 = t158 ? TB_C(0.0) : t73 * TB_ABS(t160);
            const real_t t183 = t151 ? TB_C(0.0) : t73 * TB_ABS(t153);
            const real_t t184 = tb_max(tb_max(t167 + t181, t161 + t182), t154 + t183);
            const real_t t185 = tb_min(tb_min(t168 - t181, t162 - t182), t155 - t183);
            t180 = t184 < t185 && t74 < t138 ? t179 : TB_C(0.0);
        } else {
            t180 = TB_C(0.0);
        }
        t140 = t148 + t149 * t173;
        t141 = t159 + t71 * t173;
        t142 = t150 * t173 - t152;
        t143 = t145;
        t144 = t180;
    } else {
        t140 = t105;
        t141 = t106;
        t142 = t107;
        t143 = t104;
        t144 = t108;
    }
    const real_t tension_0 = tb_min(tb_max(t140 - t49, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t tension_1 = tb_min(tb_max(start_1 + t141, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t tension_2 = tb_min(tb_max(start_2 + t142, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t tension_3 = tb_min(tb_max(start_3 + t143, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t t186 = structure[0] * tension_0 + structure[1] * tension_1;
    /* what the tensions exert, S T */
    const real_t delivered_0 = t186 + structure[2] * tension_2 + structure[3] * tension_3;
    const real_t t187 = structure[4] * tension_0 + structure[5] * tension_1;
    const real_t delivered_1 = t187 + structure[6] * tension_2 + structure[7] * tension_3;
    const real_t kkt_residual_0 = tb_max(tb_max(t144, TB_ABS(delivered_0 - wrench[0])),
        TB_ABS(delivered_1 - wrench[1]));
    const real_t t188 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t189 = !(t188 < t24 && t188 < t25);
    const real_t t190 = tb_min(t26 * (TB_EPSILON * TB_C(1280.0)), TB_C(0.01));
    const bool t191 = !(kkt_residual_0 <= t190);
    if (t189) {
        return tb_refuse_least_norm_tension(TB_SINGULAR, tension, delivered, kkt_residual);
    }
    if (t191) {
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
    const real_t t1 = TB_TENSION_MIDDLE * t0;
    const real_t t2 = wrench[1] - t1;
    const real_t t3 = structure[0] + structure[1] + structure[2] + structure[3];
    const real_t t4 = TB_TENSION_MIDDLE * t3;
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
    const real_t facet_0 = TB_TENSION_HALF_RANGE * (t11 + t15 + t19);
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
    const real_t facet_1 = TB_TENSION_HALF_RANGE * (t11 + t25 + t29);
    const real_t t30 = t2 * structure[2] - structure[6] * t5;
    const real_t t31 = TB_ABS(t30);
    const real_t t32 = structure[7] * structure[2];
    const real_t t33 = structure[6] * structure[3];
    const real_t t34 = t32 - t33;
    const real_t t35 = TB_ABS(t34);
    const real_t facet_2 = TB_TENSION_HALF_RANGE * (t15 + t25 + t35);
    const bool t36 = t7 <= facet_0 && t21 <= facet_1 && t31 <= facet_2;
    const real_t t37 = t2 * structure[3] - structure[7] * t5;
    const real_t t38 = TB_ABS(t37);
    const real_t facet_3 = TB_TENSION_HALF_RANGE * (t35 + (t19 + t29));
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
            const real_t t95 = (t87 && t93) || (t94 && !t93) ? TB_TENSION_MAX : TB_TENSION_MIN;
            const bool t96 = t29 <= t88;
            const real_t t97 = structure[1] * structure[3] + structure[5] * structure[7];
            const bool t98 = TB_C(0.0) < t97;
            const bool t99 = !t96;
            const bool t100 = (t96 && !t98) || (t99 && TB_C(0.0) < t27 - t26);
            const real_t t101 = (t87 && t100) || (t94 && !t100) ? TB_TENSION_MAX :
                TB_TENSION_MIN;
            const bool t102 = t35 <= t88;
            const real_t t103 = structure[2] * structure[3] + structure[6] * structure[7];
            const bool t104 = TB_C(0.0) < t103;
            const bool t105 = !t102;
            const bool t106 = (t102 && !t104) || (t105 && TB_C(0.0) < t33 - t32);
            const real_t t107 = (t87 && t106) || (t94 && !t106) ? TB_TENSION_MAX :
                TB_TENSION_MIN;
            const real_t t108 = structure[0] * t95 + structure[1] * t101 + structure[2] * t107;
            const real_t t109 = structure[4] * t95 + structure[5] * t101 + structure[6] * t107;
            const real_t t110 = structure[3] * (wrench[0] - t108) + structure[7] * (wrench[1] -
                t109);
            const real_t t111 = structure[3] * structure[3] + structure[7] * structure[7];
            const real_t t112 = tb_min(tb_max(t110 * (TB_C(1.0) / t111), TB_TENSION_MIN),
                TB_TENSION_MAX);
            const real_t t113 = t108 + structure[3] * t112;
            const real_t t114 = t113 - wrench[0];
            const real_t t115 = t109 + structure[7] * t112;
            const real_t t116 = t115 - wrench[1];
            const real_t t117 = facet_3 < t38 ? t114 * t114 + t116 * t116 : TB_C(1e+30);
            const bool t118 = TB_C(0.0) < t30;
            const bool t119 = t15 <= t88;
            const real_t t120 = structure[0] * structure[2] + structure[4] * structure[6];
            const bool t121 = TB_C(0.0) < t120;
            const bool t122 = !t119;
            const bool t123 = (t119 && !t121) || (t122 && TB_C(0.0) < t13 - t12);
            const bool t124 = !t118;
            const real_t t125 = (t118 && t123) || (t124 && !t123) ? TB_TENSION_MAX :
                TB_TENSION_MIN;
            const bool t126 = t25 <= t88;
            const real_t t127 = structure[1] * structure[2] + structure[5] * structure[6];
            const bool t128 = TB_C(0.0) < t127;
            const bool t129 = !t126;
            const bool t130 = (t126 && !t128) || (t129 && TB_C(0.0) < t23 - t22);
            const real_t t131 = (t118 && t130) || (t124 && !t130) ? TB_TENSION_MAX :
                TB_TENSION_MIN;
            const bool t132 = (t102 && t104) || (t105 && TB_C(0.0) < t34);
            const real_t t133 = (t118 && t132) || (t124 && !t132) ? TB_TENSION_MAX :
                TB_TENSION_MIN;
            const real_t t134 = structure[0] * t125 + structure[1] * t131 + structure[3] * t133;
            const real_t t135 = structure[4] * t125 + structure[5] * t131 + structure[7] * t133;
            const real_t t136 = structure[2] * (wrench[0] - t134) + structure[6] * (wrench[1] -
                t135);
            const real_t t137 = structure[2] * structure[2] + structure[6] * structure[6];
            const real_t t138 = tb_min(tb_max(t136 * (TB_C(1.0) / t137), TB_TENSION_MIN),
                TB_TENSION_MAX);
            const real_t t139 = t134 + structure[2] * t138;
            const real_t t140 = t139 - wrench[0];
            const real_t t141 = t135 + structure[6] * t138;
            const real_t t142 = t141 - wrench[1];
            const real_t t143 = facet_2 < t31 ? t140 * t140 + t142 * t142 : TB_C(1e+30);
            const bool t144 = TB_C(0.0) < t20;
            const bool t145 = t11 <= t88;
            const real_t t146 = structure[0] * structure[1] + structure[4] * structure[5];
            const bool t147 = TB_C(0.0) < t146;
            const bool t148 = !t145;
            const bool t149 = (t145 && !t147) || (t148 && TB_C(0.0) < t9 - t8);
            const bool t150 = !t144;
            const real_t t151 = (t144 && t149) || (t150 && !t149) ? TB_TENSION_MAX :
                TB_TENSION_MIN;
            const bool t152 = (t126 && t128) || (t129 && TB_C(0.0) < t24);
            const real_t t153 = (t144 && t152) || (t150 && !t152) ? TB_TENSION_MAX :
                TB_TENSION_MIN;
            const bool t154 = (t96 && t98) || (t99 && TB_C(0.0) < t28);
            const real_t t155 = (t144 && t154) || (t150 && !t154) ? TB_TENSION_MAX :
                TB_TENSION_MIN;
            const real_t t156 = structure[0] * t151 + structure[2] * t153 + structure[3] * t155;
            const real_t t157 = structure[4] * t151 + structure[6] * t153 + structure[7] * t155;
            const real_t t158 = structure[1] * (wrench[0] - t156) + structure[5] * (wrench[1] -
                t157);
            const real_t t159 = structure[1] * structure[1] + structure[5] * structure[5];
            const real_t t160 = tb_min(tb_max(t158 * (TB_C(1.0) / t159), TB_TENSION_MIN),
                TB_TENSION_MAX);
            const real_t t161 = t156 + structure[1] * t160;
            const real_t t162 = t161 - wrench[0];
            const real_t t163 = t157 + structure[5] * t160;
            const real_t t164 = t163 - wrench[1];
            const real_t t165 = facet_1 < t21 ? t162 * t162 + t164 * t164 : TB_C(1e+30);
            const bool t166 = TB_C(0.0) < t6;
            const bool t167 = (t145 && t147) || (t148 && TB_C(0.0) < t10);
            const bool t168 = !t166;
            const real_t t169 = (t166 && t167) || (t168 && !t167) ? TB_TENSION_MAX :
                TB_TENSION_MIN;
            const bool t170 = (t119 && t121) || (t122 && TB_C(0.0) < t14);
            const real_t t171 = (t166 && t170) || (t168 && !t170) ? TB_TENSION_MAX :
                TB_TENSION_MIN;
            const bool t172 = (t89 && t91) || (t92 && TB_C(0.0) < t18);
            const real_t t173 = (t166 && t172) || (t168 && !t172) ? TB_TENSION_MAX :
                TB_TENSION_MIN;
            const real_t t174 = structure[1] * t169 + structure[2] * t171 + structure[3] * t173;
            const real_t t175 = structure[5] * t169 + structure[6] * t171 + structure[7] * t173;
            const real_t t176 = structure[0] * (wrench[0] - t174) + structure[4] * (wrench[1] -
                t175);
            const real_t t177 = structure[0] * structure[0] + structure[4] * structure[4];
            const real_t t178 = tb_min(tb_max(t176 * (TB_C(1.0) / t177), TB_TENSION_MIN),
                TB_TENSION_MAX);
            const real_t t179 = t174 + structure[0] * t178;
            const real_t t180 = t179 - wrench[0];
            const real_t t181 = t175 + structure[4] * t178;
            const real_t t182 = t181 - wrench[1];
            const real_t t183 = facet_0 < t7 ? t180 * t180 + t182 * t182 : TB_C(1e+30);
            const bool t184 = t183 < TB_C(1e+30);
            const real_t t185 = t184 ? t183 : TB_C(1e+30);
            const bool t186 = t165 < t185;
            const real_t t187 = t186 ? t165 : t185;
            const bool t188 = t143 < t187;
            const bool t189 = t117 < (t188 ? t143 : t187);
            real_t t190, t191;
            if (t189) {
                t190 = t113;
                t191 = t115;
            } else {
                real_t t192, t193;
                if (t188) {
                    t192 = t139;
                    t193 = t141;
                } else {
                    t192 = t186 ? t161 : (t184 ? t179 : TB_C(0.0));
                    t193 = t186 ? t163 : (t184 ? t181 : TB_C(0.0));
                }
                t190 = t192;
                t191 = t193;
            }
            t85 = t190;
            t86 = t191;
        } else {
            const real_t t194 = tb_min(tb_min(tb_min(tb_min(TB_C(1.0), t47), t57), t67), t77);
            const real_t t195 = tb_max(t194, TB_C(0.0));
            t85 = wrench[0] * t195;
            t86 = wrench[1] * t195;
        }
        const real_t t196 = TB_EPSILON * TB_C(32.0);
        served_0 = t85 + t196 * (t4 - t85);
        served_1 = t86 + t196 * (t1 - t86);
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
    const real_t t1 = TB_TENSION_MIDDLE * t0;
    const real_t t2 = wrench[1] - t1;
    const real_t t3 = structure[0] + structure[1] + structure[2] + structure[3];
    const real_t t4 = TB_TENSION_MIDDLE * t3;
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
    const real_t facet_0 = TB_TENSION_HALF_RANGE * (t11 + t15 + t19);
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
    const real_t facet_1 = TB_TENSION_HALF_RANGE * (t11 + t25 + t29);
    const real_t t30 = t2 * structure[2] - structure[6] * t5;
    const real_t t31 = TB_ABS(t30);
    const real_t t32 = structure[7] * structure[2];
    const real_t t33 = structure[6] * structure[3];
    const real_t t34 = t32 - t33;
    const real_t t35 = TB_ABS(t34);
    const real_t facet_2 = TB_TENSION_HALF_RANGE * (t15 + t25 + t35);
    const bool t36 = t7 <= facet_0 && t21 <= facet_1 && t31 <= facet_2;
    const real_t t37 = t2 * structure[3] - structure[7] * t5;
    const real_t t38 = TB_ABS(t37);
    const real_t facet_3 = TB_TENSION_HALF_RANGE * (t35 + (t19 + t29));
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
        const real_t t49 = (t41 && t47) || (t48 && !t47) ? TB_TENSION_MAX : TB_TENSION_MIN;
        const bool t50 = t29 <= t42;
        const real_t t51 = structure[1] * structure[3] + structure[5] * structure[7];
        const bool t52 = TB_C(0.0) < t51;
        const bool t53 = !t50;
        const bool t54 = (t50 && !t52) || (t53 && TB_C(0.0) < t27 - t26);
        const real_t t55 = (t41 && t54) || (t48 && !t54) ? TB_TENSION_MAX : TB_TENSION_MIN;
        const bool t56 = t35 <= t42;
        const real_t t57 = structure[2] * structure[3] + structure[6] * structure[7];
        const bool t58 = TB_C(0.0) < t57;
        const bool t59 = !t56;
        const bool t60 = (t56 && !t58) || (t59 && TB_C(0.0) < t33 - t32);
        const real_t t61 = (t41 && t60) || (t48 && !t60) ? TB_TENSION_MAX : TB_TENSION_MIN;
        const real_t t62 = structure[0] * t49 + structure[1] * t55 + structure[2] * t61;
        const real_t t63 = structure[4] * t49 + structure[5] * t55 + structure[6] * t61;
        const real_t t64 = structure[3] * (wrench[0] - t62) + structure[7] * (wrench[1] - t63);
        const real_t t65 = structure[3] * structure[3] + structure[7] * structure[7];
        const real_t t66 = tb_min(tb_max(t64 * (TB_C(1.0) / t65), TB_TENSION_MIN),
            TB_TENSION_MAX);
        const real_t t67 = t62 + structure[3] * t66;
        const real_t t68 = t67 - wrench[0];
        const real_t t69 = t63 + structure[7] * t66;
        const real_t t70 = t69 - wrench[1];
        const real_t t71 = facet_3 < t38 ? t68 * t68 + t70 * t70 : TB_C(1e+30);
        const bool t72 = TB_C(0.0) < t30;
        const bool t73 = t15 <= t42;
        const real_t t74 = structure[0] * structure[2] + structure[4] * structure[6];
        const bool t75 = TB_C(0.0) < t74;
        const bool t76 = !t73;
        const bool t77 = (t73 && !t75) || (t76 && TB_C(0.0) < t13 - t12);
        const bool t78 = !t72;
        const real_t t79 = (t72 && t77) || (t78 && !t77) ? TB_TENSION_MAX : TB_TENSION_MIN;
        const bool t80 = t25 <= t42;
        const real_t t81 = structure[1] * structure[2] + structure[5] * structure[6];
        const bool t82 = TB_C(0.0) < t81;
        const bool t83 = !t80;
        const bool t84 = (t80 && !t82) || (t83 && TB_C(0.0) < t23 - t22);
        const real_t t85 = (t72 && t84) || (t78 && !t84) ? TB_TENSION_MAX : TB_TENSION_MIN;
        const bool t86 = (t56 && t58) || (t59 && TB_C(0.0) < t34);
        const real_t t87 = (t72 && t86) || (t78 && !t86) ? TB_TENSION_MAX : TB_TENSION_MIN;
        const real_t t88 = structure[0] * t79 + structure[1] * t85 + structure[3] * t87;
        const real_t t89 = structure[4] * t79 + structure[5] * t85 + structure[7] * t87;
        const real_t t90 = structure[2] * (wrench[0] - t88) + structure[6] * (wrench[1] - t89);
        const real_t t91 = structure[2] * structure[2] + structure[6] * structure[6];
        const real_t t92 = tb_min(tb_max(t90 * (TB_C(1.0) / t91), TB_TENSION_MIN),
            TB_TENSION_MAX);
        const real_t t93 = t88 + structure[2] * t92;
        const real_t t94 = t93 - wrench[0];
        const real_t t95 = t89 + structure[6] * t92;
        const real_t t96 = t95 - wrench[1];
        const real_t t97 = facet_2 < t31 ? t94 * t94 + t96 * t96 : TB_C(1e+30);
        const bool t98 = TB_C(0.0) < t20;
        const bool t99 = t11 <= t42;
        const real_t t100 = structure[0] * structure[1] + structure[4] * structure[5];
        const bool t101 = TB_C(0.0) < t100;
        const bool t102 = !t99;
        const bool t103 = (t99 && !t101) || (t102 && TB_C(0.0) < t9 - t8);
        const bool t104 = !t98;
        const real_t t105 = (t98 && t103) || (t104 && !t103) ? TB_TENSION_MAX : TB_TENSION_MIN;
        const bool t106 = (t80 && t82) || (t83 && TB_C(0.0) < t24);
        const real_t t107 = (t98 && t106) || (t104 && !t106) ? TB_TENSION_MAX : TB_TENSION_MIN;
        const bool t108 = (t50 && t52) || (t53 && TB_C(0.0) < t28);
        const real_t t109 = (t98 && t108) || (t104 && !t108) ? TB_TENSION_MAX : TB_TENSION_MIN;
        const real_t t110 = structure[0] * t105 + structure[2] * t107 + structure[3] * t109;
        const real_t t111 = structure[4] * t105 + structure[6] * t107 + structure[7] * t109;
        const real_t t112 = structure[1] * (wrench[0] - t110) + structure[5] * (wrench[1] -
            t111);
        const real_t t113 = structure[1] * structure[1] + structure[5] * structure[5];
        const real_t t114 = tb_min(tb_max(t112 * (TB_C(1.0) / t113), TB_TENSION_MIN),
            TB_TENSION_MAX);
        const real_t t115 = t110 + structure[1] * t114;
        const real_t t116 = t115 - wrench[0];
        const real_t t117 = t111 + structure[5] * t114;
        const real_t t118 = t117 - wrench[1];
        const real_t t119 = facet_1 < t21 ? t116 * t116 + t118 * t118 : TB_C(1e+30);
        const bool t120 = TB_C(0.0) < t6;
        const bool t121 = (t99 && t101) || (t102 && TB_C(0.0) < t10);
        const bool t122 = !t120;
        const real_t t123 = (t120 && t121) || (t122 && !t121) ? TB_TENSION_MAX : TB_TENSION_MIN;
        const bool t124 = (t73 && t75) || (t76 && TB_C(0.0) < t14);
        const real_t t125 = (t120 && t124) || (t122 && !t124) ? TB_TENSION_MAX : TB_TENSION_MIN;
        const bool t126 = (t43 && t45) || (t46 && TB_C(0.0) < t18);
        const real_t t127 = (t120 && t126) || (t122 && !t126) ? TB_TENSION_MAX : TB_TENSION_MIN;
        const real_t t128 = structure[1] * t123 + structure[2] * t125 + structure[3] * t127;
        const real_t t129 = structure[5] * t123 + structure[6] * t125 + structure[7] * t127;
        const real_t t130 = structure[0] * (wrench[0] - t128) + structure[4] * (wrench[1] -
            t129);
        const real_t t131 = structure[0] * structure[0] + structure[4] * structure[4];
        const real_t t132 = tb_min(tb_max(t130 * (TB_C(1.0) / t131), TB_TENSION_MIN),
            TB_TENSION_MAX);
        const real_t t133 = t128 + structure[0] * t132;
        const real_t t134 = t133 - wrench[0];
        const real_t t135 = t129 + structure[4] * t132;
        const real_t t136 = t135 - wrench[1];
        const real_t t137 = facet_0 < t7 ? t134 * t134 + t136 * t136 : TB_C(1e+30);
        const bool t138 = t137 < TB_C(1e+30);
        const real_t t139 = t138 ? t137 : TB_C(1e+30);
        const bool t140 = t119 < t139;
        const real_t t141 = t140 ? t119 : t139;
        const bool t142 = t97 < t141;
        const bool t143 = t71 < (t142 ? t97 : t141);
        real_t t144, t145;
        if (t143) {
            t144 = t67;
            t145 = t69;
        } else {
            real_t t146, t147;
            if (t142) {
                t146 = t93;
                t147 = t95;
            } else {
                t146 = t140 ? t115 : (t138 ? t133 : TB_C(0.0));
                t147 = t140 ? t117 : (t138 ? t135 : TB_C(0.0));
            }
            t144 = t146;
            t145 = t147;
        }
        const real_t t148 = TB_EPSILON * TB_C(32.0);
        served_0 = t144 + t148 * (t4 - t144);
        served_1 = t145 + t148 * (t1 - t145);
    }
    const real_t inner_0 = served_0 + TB_C(3.814697265625e-06) * (t4 - served_0);
    const real_t inner_1 = served_1 + TB_C(3.814697265625e-06) * (t1 - served_1);
    served[0] = served_0;
    served[1] = served_1;
    inner[0] = inner_0;
    inner[1] = inner_1;
    return t40 ? TB_INFEASIBLE : TB_OK;
}

/* Refuses with a status: tension is 3 N; delivered is 0 N; kkt_residual is 0 N. */
static tb_status tb_refuse_distribute_tension_paper(tb_status status, real_t tension[4],
    real_t delivered[2], real_t kkt_residual[1])
{
    tension[0] = TB_TENSION_MIN;
    tension[1] = TB_TENSION_MIN;
    tension[2] = TB_TENSION_MIN;
    tension[3] = TB_TENSION_MIN;
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
    /* the least-norm tensions that exert the wrench */
    const real_t start_3 = t18 - structure[3] * t22;
    const real_t t23 = TB_TENSION_MIN - start_3;
    const real_t t24 = TB_TENSION_MIN + (TB_ABS(wrench[0]) + TB_ABS(wrench[1]));
    const real_t t25 = TB_ABS(t3);
    const real_t t26 = TB_ABS(t12);
    const real_t t27 = TB_C(1.0) / tb_min(t25, t26);
    const real_t t28 = TB_C(3.0) * TB_EPSILON * t24 * t27;
    const real_t start_2 = t20 - structure[2] * t22;
    const real_t t29 = TB_TENSION_MIN - start_2;
    const real_t t30 = t29 - t28;
    const real_t start_1 = t19 - structure[1] * t22;
    const real_t t31 = TB_TENSION_MIN - start_1;
    const real_t t32 = t31 - t28;
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
    const real_t t51 = TB_TENSION_MIN + t50;
    const real_t t52 = t50 + TB_C(1000000000000.0);
    const real_t t53 = tb_min(tb_max(TB_C(0.0), t51), t52);
    const real_t t54 = t28 < TB_ABS(t53) ? t53 : TB_C(0.0);
    const real_t t55 = t54 / tb_max(t39 * t39 + t47 * t47, TB_EPSILON);
    const real_t t56 = t49 * t55;
    const real_t t57 = TB_C(1000000000000.0) - start_1;
    const real_t t58 = t28 + t57;
    const real_t t59 = tb_max(t32 - t56, t56 - t58);
    const bool t60 = TB_C(0.0) < t59;
    const real_t t61 = t44 + structure[2] * t46;
    const real_t t62 = t34 - structure[2] * t38;
    const real_t t63 = t48 * t61 - t40 * t62;
    const real_t t64 = t40 * t61 + t48 * t62;
    const real_t t65 = TB_EPSILON * TB_C(16.0);
    const real_t t66 = t51 - t28;
    const real_t t67 = t28 + t52;
    const real_t t68 = t47 * t61 - t39 * t62;
    const real_t t69 = t36 + structure[3] * t38;
    const real_t t70 = t42 - structure[3] * t46;
    const real_t t71 = t40 * t69 - t48 * t70;
    const real_t t72 = t40 * t70 + t48 * t69;
    const real_t t73 = t39 * t69 - t47 * t70;
    const real_t t74 = t28 * TB_C(2.0);
    const real_t t75 = t28 * TB_C(1024.0);
    real_t t76, t77, t78, t79, t80;
    if (t60) {
        const real_t t81 = tb_min(tb_max(t56, t31), t57);
        const real_t t82 = TB_C(1.0) / tb_max(t40 * t40 + t48 * t48, TB_EPSILON);
        const real_t t83 = t81 * t82;
        const real_t t84 = t40 * t47 - t39 * t48;
        const bool t85 = TB_ABS(t84) <= t65;
        const real_t t86 = t49 * t83;
        const real_t t87 = TB_C(1.0) / t84;
        real_t t88, t89;
        if (t85) {
            t88 = -TB_C(1000000000000.0);
            t89 = TB_C(1000000000000.0);
        } else {
            const real_t t90 = (t66 - t86) * t87;
            const real_t t91 = t87 * (t67 - t86);
            t88 = tb_min(t90, t91);
            t89 = tb_max(t90, t91);
        }
        const real_t t92 = tb_min(tb_max(TB_C(0.0), t88), t89);
        const real_t t93 = TB_C(0.0) < TB_ABS(t92) ? t92 * (t49 * t87) : TB_C(0.0);
        const real_t t94 = t56 < t81 ? t93 - t83 : t83 - t93;
        real_t t95;
        if (TB_C(0.0) < t94) {
            const real_t t96 = t85 ? TB_C(0.0) : t74 * TB_ABS(t87);
            const real_t t97 = t88 + t96 < t89 - t96 && t75 < t59 ? t94 : TB_C(0.0);
            t95 = t97;
        } else {
            t95 = TB_C(0.0);
        }
        t76 = t63 * t83 + t64 * t92;
        t77 = t83 * t71 - t92 * t72;
        t78 = t95;
        t79 = t86 + t84 * t92;
        t80 = t81;
    } else {
        t76 = t55 * t68;
        t77 = t55 * t73;
        t78 = TB_C(0.0);
        t79 = t54;
        t80 = t56;
    }
    const real_t t98 = TB_C(1000000000000.0) - start_2;
    const real_t t99 = t28 + t98;
    const real_t t100 = tb_max(t30 - t76, t76 - t99);
    const bool t101 = TB_C(0.0) < t100;
    const real_t t102 = t62 * t70;
    const real_t t103 = t61 * t69;
    const real_t t104 = t62 * t69 + t61 * t70;
    real_t t105, t106, t107, t108, t109;
    if (t101) {
        const bool t110 = TB_ABS(t64) <= t65;
        const real_t t111 = tb_min(tb_max(t76, t29), t98);
        const real_t t112 = TB_C(1.0) / tb_max(t62 * t62 + t61 * t61, TB_EPSILON);
        const real_t t113 = t111 * t112;
        const real_t t114 = t63 * t113;
        const real_t t115 = TB_C(1.0) / t64;
        real_t t116, t117;
        if (t110) {
            t116 = -TB_C(1000000000000.0);
            t117 = TB_C(1000000000000.0);
        } else {
            const real_t t118 = -((t32 - t114) * t115);
            const real_t t119 = -(t115 * (t58 - t114));
            t116 = tb_min(t118, t119);
            t117 = tb_max(t118, t119);
        }
        const real_t t120 = t47 * t62 + t39 * t61;
        const bool t121 = TB_ABS(t120) <= t65;
        const real_t t122 = t68 * t113;
        const real_t t123 = TB_C(1.0) / t120;
        real_t t124, t125;
        if (t121) {
            t124 = -TB_C(1000000000000.0);
            t125 = TB_C(1000000000000.0);
        } else {
            const real_t t126 = -((t66 - t122) * t123);
            const real_t t127 = -(t123 * (t67 - t122));
            t124 = tb_min(t126, t127);
            t125 = tb_max(t126, t127);
        }
        const real_t t128 = tb_min(tb_max(TB_C(0.0), tb_max(t116, t124)), tb_min(t117, t125));
        real_t t129;
        if (TB_C(0.0) < TB_ABS(t128)) {
            const real_t t130 = -(t63 * t115);
            const real_t t131 = -(t68 * t123);
            const real_t t132 = TB_C(0.0) < t128 ? (t124 < t116 ? t130 : t131) : (t117 < t125 ?
                t130 : t131);
            t129 = t128 * t132;
        } else {
            t129 = TB_C(0.0);
        }
        const real_t t133 = t76 < t111 ? t129 - t113 : t113 - t129;
        real_t t134;
        if (TB_C(0.0) < t133) {
            real_t t135;
            if (t121) {
                t135 = TB_C(0.0);
            } else {
                t135 = t74 * TB_ABS(TB_C(1.0) / -t120);
            }
            real_t t136;
            if (t110) {
                t136 = TB_C(0.0);
            } else {
                t136 = t74 * TB_ABS(TB_C(1.0) / -t64);
            }
            const bool t137 = tb_max(t124 + t135, t116 + t136) < tb_min(t125 - t135, t117 -
                t136);
            t134 = t137 && t75 < t100 ? t133 : TB_C(0.0);
        } else {
            t134 = TB_C(0.0);
        }
        t105 = (t102 - t103) * t128 - t113 * t104;
        t106 = t134;
        t107 = t122 - t120 * t128;
        t108 = t114 - t64 * t128;
        t109 = t111;
    } else {
        t105 = t77;
        t106 = t78;
        t107 = t79;
        t108 = t80;
        t109 = t76;
    }
    const real_t t138 = TB_C(1000000000000.0) - start_3;
    const real_t t139 = tb_max(t23 - t28 - t105, t105 - (t28 + t138));
    const bool t140 = TB_C(0.0) < t139;
    real_t t141, t142, t143, t144, t145;
    if (t140) {
        const real_t t146 = tb_min(tb_max(t105, t23), t138);
        const real_t t147 = TB_C(1.0) / tb_max(t69 * t69 + t70 * t70, TB_EPSILON);
        const real_t t148 = t146 * t147;
        const real_t t149 = t103 - t102;
        const bool t150 = TB_ABS(t149) <= t65;
        const real_t t151 = t104 * t148;
        const real_t t152 = TB_C(1.0) / t149;
        real_t t153, t154;
        if (t150) {
            t153 = -TB_C(1000000000000.0);
            t154 = TB_C(1000000000000.0);
        } else {
            const real_t t155 = (t30 + t151) * t152;
            const real_t t156 = t152 * (t99 + t151);
            t153 = tb_min(t155, t156);
            t154 = tb_max(t155, t156);
        }
        const bool t157 = TB_ABS(t72) <= t65;
        const real_t t158 = t71 * t148;
        const real_t t159 = TB_C(1.0) / t72;
        real_t t160, t161;
        if (t157) {
            t160 = -TB_C(1000000000000.0);
            t161 = TB_C(1000000000000.0);
        } else {
            const real_t t162 = (t32 - t158) * t159;
            const real_t t163 = t159 * (t58 - t158);
            t160 = tb_min(t162, t163);
            t161 = tb_max(t162, t163);
        }
        const real_t t164 = t47 * t69 + t39 * t70;
        const bool t165 = TB_ABS(t164) <= t65;
        const real_t t166 = t73 * t148;
        const real_t t167 = TB_C(1.0) / t164;
        real_t t168, t169;
        if (t165) {
            t168 = -TB_C(1000000000000.0);
            t169 = TB_C(1000000000000.0);
        } else {
            const real_t t170 = (t66 - t166) * t167;
            const real_t t171 = t167 * (t67 - t166);
            t168 = tb_min(t170, t171);
            t169 = tb_max(t170, t171);
        }
        const real_t t172 = tb_max(t160, t168);
        const real_t t173 = tb_min(t161, t169);
        const real_t t174 = tb_min(tb_max(TB_C(0.0), tb_max(t153, t172)), tb_min(t154, t173));
        real_t t175;
        if (TB_C(0.0) < TB_ABS(t174)) {
            const real_t t176 = -(t104 * t152);
            const real_t t177 = t71 * t159;
            const real_t t178 = t73 * t167;
            real_t t179;
            if (TB_C(0.0) < t174) {
                t179 = t172 < t153 ? t176 : (t168 < t160 ? t177 : t178);
            } else {
                t179 = t154 < t173 ? t176 : (t161 < t169 ? t177 : t178);
            }
            t175 = t174 * t179;
        } else {
            t175 = TB_C(0.0);
        }
        const real_t t180 = t105 < t146 ? t175 - t148 : t148 - t175;
        real_t t181;
        if (TB_C(0.0) < t180) {
            const real_t t182 = t165 ? TB_C(0.0) : t74 * TB_ABS(t167);
            const real_t t183 = t157 ? TB_C(0.0) : t74 * TB_ABS(t159);
            const real_t t184 = t150 ? TB_C(0.0) : t74 * TB_ABS(t152);
            const real_t t185 = tb_max(tb_max(t168 + t182, t160 + t183), t153 + t184);
            const real_t t186 = tb_min(tb_min(t169 - t182, t161 - t183), t154 - t184);
            t181 = t185 < t186 && t75 < t139 ? t180 : TB_C(0.0);
        } else {
            t181 = TB_C(0.0);
        }
        t141 = t181;
        t142 = t166 + t164 * t174;
        t143 = t158 + t72 * t174;
        t144 = t149 * t174 - t151;
        t145 = t146;
    } else {
        t141 = t106;
        t142 = t107;
        t143 = t108;
        t144 = t109;
        t145 = t105;
    }
    const real_t t187 = tb_min(tb_max(t142 - t50, TB_TENSION_MIN), TB_C(1000000000000.0));
    const real_t t188 = tb_min(tb_max(start_1 + t143, TB_TENSION_MIN), TB_C(1000000000000.0));
    const real_t t189 = tb_min(tb_max(start_2 + t144, TB_TENSION_MIN), TB_C(1000000000000.0));
    const real_t t190 = structure[0] * t187 + structure[1] * t188 + structure[2] * t189;
    const real_t t191 = tb_min(tb_max(start_3 + t145, TB_TENSION_MIN), TB_C(1000000000000.0));
    const real_t t192 = tb_max(t141, TB_ABS(t190 + structure[3] * t191 - wrench[0]));
    const real_t t193 = structure[4] * t187 + structure[5] * t188 + structure[6] * t189;
    const real_t t194 = tb_max(t192, TB_ABS(t193 + structure[7] * t191 - wrench[1]));
    const real_t t195 = TB_EPSILON * TB_C(128.0) * tb_max(tb_max(tb_max(t187, t188), t189),
        t191);
    const bool t196 = t194 <= tb_min(t27 * t195, TB_C(0.01));
    real_t tension_0, tension_1, tension_2, tension_3, kkt_residual_0;
    if (t196) {
        tension_0 = tb_min(t187, TB_TENSION_MAX);
        tension_1 = tb_min(t188, TB_TENSION_MAX);
        tension_2 = tb_min(t189, TB_TENSION_MAX);
        tension_3 = tb_min(t191, TB_TENSION_MAX);
        kkt_residual_0 = t194;
    } else {
        tension_0 = TB_TENSION_MIN;
        tension_1 = TB_TENSION_MIN;
        tension_2 = TB_TENSION_MIN;
        tension_3 = TB_TENSION_MIN;
        kkt_residual_0 = TB_C(0.0);
    }
    const bool t197 = !t196;
    const real_t t198 = structure[0] * tension_0 + structure[1] * tension_1;
    /* what the tensions exert, S T */
    const real_t delivered_0 = t198 + structure[2] * tension_2 + structure[3] * tension_3;
    const real_t t199 = structure[4] * tension_0 + structure[5] * tension_1;
    const real_t delivered_1 = t199 + structure[6] * tension_2 + structure[7] * tension_3;
    const real_t t200 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t201 = !(t200 < t25 && t200 < t26);
    const bool t202 = TB_TENSION_MAX < t187 || TB_TENSION_MAX < t188 || TB_TENSION_MAX < t189;
    const bool t203 = t202 || TB_TENSION_MAX < t191;
    if (t201) {
        return tb_refuse_distribute_tension_paper(TB_SINGULAR, tension, delivered, kkt_residual);
    }
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    delivered[0] = delivered_0;
    delivered[1] = delivered_1;
    kkt_residual[0] = kkt_residual_0;
    return (t197 || t203) ? TB_INFEASIBLE : TB_OK;
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
    return tb_distribute_tension_scale(structure, wrench, tension, delivered, kkt_residual);
}

