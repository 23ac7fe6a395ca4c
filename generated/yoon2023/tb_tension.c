/* Regenerate: turnbuckle generate machines/yoon2023.toml --out generated/yoon2023
 * Machine c2e26558649395a1, generator 0.1.0, casadi 3.8.2. Do not edit. */
#include "tb_tension.h"

tb_status tb_least_norm_tension_quick(const real_t structure[8], const real_t wrench[2], real_t
    tension[4], real_t delivered[2], real_t kkt_residual[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) <= TB_C(32.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(80000.0))) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = structure[0] * structure[7] - structure[4] * structure[3];
    const real_t t1 = structure[0] * wrench[1] - structure[4] * wrench[0];
    const real_t t2 = structure[7] * structure[1] - structure[3] * structure[5];
    const real_t t3 = wrench[1] * structure[1] - wrench[0] * structure[5];
    const real_t t4 = structure[7] * structure[2] - structure[3] * structure[6];
    const real_t t5 = wrench[1] * structure[2] - wrench[0] * structure[6];
    const real_t t6 = structure[0] * structure[5] - structure[4] * structure[1];
    const real_t t7 = t6 * t6;
    const real_t t8 = t4 * t4;
    const real_t t9 = structure[0] * structure[6] - structure[4] * structure[2];
    const real_t t10 = t9 * t9;
    const real_t t11 = t2 * t2;
    const real_t t12 = t0 * t0;
    const real_t t13 = structure[1] * structure[6] - structure[5] * structure[2];
    const real_t t14 = t13 * t13;
    const real_t t15 = t7 + t8 + (t10 + t11) + (t12 + t14);
    const real_t t16 = TB_C(1.0) / t15;
    /* T0, the least-norm tensions that exert the wrench */
    const real_t start_3 = (t0 * t1 + t2 * t3 + t4 * t5) * t16;
    const real_t t17 = TB_C(3.0) - start_3;
    const real_t t18 = TB_SQRT(t15) * TB_C(0.5);
    const real_t t19 = TB_C(1.0) / t18;
    const real_t t20 = TB_C(80.0) * TB_EPSILON * t19;
    const real_t t21 = structure[3] * wrench[1] - structure[7] * wrench[0];
    const real_t start_2 = t16 * (t1 * t9 + t3 * t13 - t4 * t21);
    const real_t t22 = TB_C(3.0) - start_2;
    const real_t t23 = t22 - t20;
    const real_t start_1 = t16 * (t1 * t6 - t5 * t13 - t2 * t21);
    const real_t t24 = TB_C(3.0) - start_1;
    const real_t t25 = t24 - t20;
    const real_t t26 = t9 * t13 + t0 * t2;
    const real_t t27 = t16 * (t3 * t6 + t5 * t9 + t0 * t21);
    const real_t t28 = TB_C(3.0) + t27;
    const real_t t29 = t27 + TB_C(10.0);
    const real_t t30 = tb_min(tb_max(TB_C(0.0), t28), t29);
    const real_t t31 = t30 / (t14 + (t8 + t11));
    const real_t t32 = t26 * t31;
    const real_t t33 = TB_C(10.0) - start_1;
    const real_t t34 = t20 + t33;
    const bool t35 = TB_C(0.0) < tb_max(t25 + t32, -(t32 + t34));
    const real_t t36 = TB_EPSILON * TB_C(16.0);
    const real_t t37 = t28 - t20;
    const real_t t38 = -t32;
    const real_t t39 = t20 + t29;
    const real_t t40 = t6 * t9 + t2 * t4;
    const real_t t41 = t0 * t4 - t6 * t13;
    const real_t t42 = t0 * t6 - t4 * t13;
    const real_t t43 = t2 * t6 + t4 * t9;
    real_t t44, t45, t46, t47, t48;
    if (t35) {
        const bool t49 = TB_ABS(t4) <= t36;
        const real_t t50 = tb_min(tb_max(t38, t24), t33);
        const real_t t51 = t50 / (t10 + (t8 + t12));
        const real_t t52 = t26 * t51;
        const real_t t53 = TB_C(1.0) / t4;
        real_t t54, t55;
        if (t49) {
            t54 = -TB_C(1000000000000.0);
            t55 = TB_C(1000000000000.0);
        } else {
            const real_t t56 = -((t37 + t52) * t53);
            const real_t t57 = -(t53 * (t52 + t39));
            const real_t t58 = tb_min(t56, t57);
            const real_t t59 = tb_max(t56, t57);
            t54 = t58;
            t55 = t59;
        }
        const real_t t60 = tb_min(tb_max(TB_C(0.0), t54), t55);
        const real_t t61 = t0 * t60 - t51 * t40;
        const real_t t62 = -(t51 * t42 + t9 * t60);
        const real_t t63 = -(t52 + t4 * t60);
        const real_t t64 = t15 * t51;
        const real_t t65 = TB_C(0.0) < TB_ABS(t60) ? t60 * (t26 * t53) : TB_C(0.0);
        const real_t t66 = tb_max(TB_C(0.0), t38 < t50 ? t65 - t64 : t64 - t65);
        t44 = t61;
        t45 = t62;
        t46 = t63;
        t47 = t50;
        t48 = t66;
    } else {
        const real_t t67 = -(t31 * t41);
        const real_t t68 = t31 * t43;
        t44 = t67;
        t45 = t68;
        t46 = t30;
        t47 = t38;
        t48 = TB_C(0.0);
    }
    const real_t t69 = TB_C(10.0) - start_2;
    const real_t t70 = t20 + t69;
    const bool t71 = TB_C(0.0) < tb_max(t23 - t44, t44 - t70);
    const real_t t72 = t0 * t9 + t2 * t13;
    real_t t73, t74, t75, t76, t77;
    if (t71) {
        const bool t78 = TB_ABS(t0) <= t36;
        const real_t t79 = tb_min(tb_max(t44, t22), t69);
        const real_t t80 = t79 / (t7 + (t11 + t12));
        const real_t t81 = t40 * t80;
        const real_t t82 = TB_C(1.0) / t0;
        real_t t83, t84;
        if (t78) {
            t83 = -TB_C(1000000000000.0);
            t84 = TB_C(1000000000000.0);
        } else {
            const real_t t85 = -((t25 + t81) * t82);
            const real_t t86 = -(t82 * (t34 + t81));
            const real_t t87 = tb_min(t85, t86);
            const real_t t88 = tb_max(t85, t86);
            t83 = t87;
            t84 = t88;
        }
        const bool t89 = TB_ABS(t2) <= t36;
        const real_t t90 = t41 * t80;
        const real_t t91 = TB_C(1.0) / t2;
        real_t t92, t93;
        if (t89) {
            t92 = -TB_C(1000000000000.0);
            t93 = TB_C(1000000000000.0);
        } else {
            const real_t t94 = (t37 + t90) * t91;
            const real_t t95 = t91 * (t39 + t90);
            const real_t t96 = tb_min(t94, t95);
            const real_t t97 = tb_max(t94, t95);
            t92 = t96;
            t93 = t97;
        }
        const real_t t98 = tb_min(tb_max(TB_C(0.0), tb_max(t83, t92)), tb_min(t84, t93));
        const real_t t99 = t6 * t98 - t80 * t72;
        const real_t t100 = t2 * t98 - t90;
        const real_t t101 = -(t81 + t0 * t98);
        const real_t t102 = t15 * t80;
        real_t t103;
        if (TB_C(0.0) < TB_ABS(t98)) {
            const real_t t104 = t40 * t82;
            const real_t t105 = -(t41 * t91);
            const real_t t106 = TB_C(0.0) < t98 ? (t92 < t83 ? t104 : t105) : (t84 < t93 ? t104
                : t105);
            const real_t t107 = t98 * t106;
            t103 = t107;
        } else {
            t103 = TB_C(0.0);
        }
        const real_t t108 = tb_max(TB_C(0.0), t44 < t79 ? t103 - t102 : t102 - t103);
        t73 = t99;
        t74 = t100;
        t75 = t101;
        t76 = t79;
        t77 = t108;
    } else {
        t73 = t45;
        t74 = t46;
        t75 = t47;
        t76 = t44;
        t77 = t48;
    }
    const real_t t109 = TB_C(10.0) - start_3;
    const bool t110 = TB_C(0.0) < tb_max(t17 - t20 - t73, t73 - (t20 + t109));
    real_t t111, t112, t113, t114, t115;
    if (t110) {
        const real_t t116 = tb_min(tb_max(t73, t17), t109);
        const real_t t117 = t116 / (t7 + (t10 + t14));
        const real_t t118 = t43 * t117;
        const bool t119 = TB_ABS(t6) <= t36;
        const real_t t120 = t72 * t117;
        const real_t t121 = TB_C(1.0) / t6;
        real_t t122, t123;
        if (t119) {
            t122 = -TB_C(1000000000000.0);
            t123 = TB_C(1000000000000.0);
        } else {
            const real_t t124 = -((t23 + t120) * t121);
            const real_t t125 = -(t121 * (t70 + t120));
            const real_t t126 = tb_min(t124, t125);
            const real_t t127 = tb_max(t124, t125);
            t122 = t126;
            t123 = t127;
        }
        const bool t128 = TB_ABS(t9) <= t36;
        const real_t t129 = t42 * t117;
        const real_t t130 = TB_C(1.0) / t9;
        real_t t131, t132;
        if (t128) {
            t131 = -TB_C(1000000000000.0);
            t132 = TB_C(1000000000000.0);
        } else {
            const real_t t133 = (t25 + t129) * t130;
            const real_t t134 = t130 * (t34 + t129);
            const real_t t135 = tb_min(t133, t134);
            const real_t t136 = tb_max(t133, t134);
            t131 = t135;
            t132 = t136;
        }
        const bool t137 = TB_ABS(t13) <= t36;
        const real_t t138 = TB_C(1.0) / t13;
        real_t t139, t140;
        if (t137) {
            t139 = -TB_C(1000000000000.0);
            t140 = TB_C(1000000000000.0);
        } else {
            const real_t t141 = -((t37 - t118) * t138);
            const real_t t142 = -(t138 * (t39 - t118));
            const real_t t143 = tb_min(t141, t142);
            const real_t t144 = tb_max(t141, t142);
            t139 = t143;
            t140 = t144;
        }
        const real_t t145 = tb_max(t131, t139);
        const real_t t146 = tb_min(t132, t140);
        const real_t t147 = tb_min(tb_max(TB_C(0.0), tb_max(t122, t145)), tb_min(t123, t146));
        const real_t t148 = t118 - t13 * t147;
        const real_t t149 = t9 * t147 - t129;
        const real_t t150 = -(t120 + t6 * t147);
        const real_t t151 = t15 * t117;
        real_t t152;
        if (TB_C(0.0) < TB_ABS(t147)) {
            const real_t t153 = t72 * t121;
            const real_t t154 = -(t42 * t130);
            const real_t t155 = -(t43 * t138);
            real_t t156;
            if (TB_C(0.0) < t147) {
                const real_t t157 = t145 < t122 ? t153 : (t139 < t131 ? t154 : t155);
                t156 = t157;
            } else {
                const real_t t158 = t123 < t146 ? t153 : (t132 < t140 ? t154 : t155);
                t156 = t158;
            }
            const real_t t159 = t147 * t156;
            t152 = t159;
        } else {
            t152 = TB_C(0.0);
        }
        const real_t t160 = tb_max(TB_C(0.0), t73 < t116 ? t152 - t151 : t151 - t152);
        t111 = t148;
        t112 = t149;
        t113 = t150;
        t114 = t116;
        t115 = t160;
    } else {
        t111 = t74;
        t112 = t75;
        t113 = t76;
        t114 = t73;
        t115 = t77;
    }
    const real_t tension_0 = tb_min(tb_max(t111 - t27, TB_C(3.0)), TB_C(10.0));
    const real_t tension_1 = tb_min(tb_max(start_1 + t112, TB_C(3.0)), TB_C(10.0));
    const real_t tension_2 = tb_min(tb_max(start_2 + t113, TB_C(3.0)), TB_C(10.0));
    const real_t tension_3 = tb_min(tb_max(start_3 + t114, TB_C(3.0)), TB_C(10.0));
    const real_t t161 = structure[0] * tension_0 + structure[1] * tension_1;
    /* what the tensions exert, S T */
    const real_t delivered_0 = t161 + structure[2] * tension_2 + structure[3] * tension_3;
    const real_t t162 = structure[4] * tension_0 + structure[5] * tension_1;
    const real_t delivered_1 = t162 + structure[6] * tension_2 + structure[7] * tension_3;
    const real_t kkt_residual_0 = tb_max(tb_max(t115, TB_ABS(delivered_0 - wrench[0])),
        TB_ABS(delivered_1 - wrench[1]));
    const bool t163 = !(TB_EPSILON * TB_C(4096.0) < t18);
    const bool t164 = kkt_residual_0 <= t19 * (TB_EPSILON * TB_C(640.0));
    const bool t165 = !t164;
    if (t163) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    if (t165) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return TB_INACCURATE;
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

tb_status tb_least_norm_tension(const real_t structure[8], const real_t wrench[2], real_t
    tension[4], real_t delivered[2], real_t kkt_residual[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) <= TB_C(32.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(80000.0))) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
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
    /* T0, the least-norm tensions that exert the wrench */
    const real_t start_3 = t18 - structure[3] * t22;
    const real_t t23 = TB_C(3.0) - start_3;
    const real_t t24 = tb_min(TB_ABS(t3), TB_ABS(t12));
    const real_t t25 = TB_C(1.0) / t24;
    const real_t t26 = TB_C(80.0) * TB_EPSILON * t25;
    const real_t start_2 = t20 - structure[2] * t22;
    const real_t t27 = TB_C(3.0) - start_2;
    const real_t t28 = t27 - t26;
    const real_t start_1 = t19 - structure[1] * t22;
    const real_t t29 = TB_C(3.0) - start_1;
    const real_t t30 = t29 - t26;
    const real_t t31 = t9 * t16;
    const real_t t32 = TB_C(1.0) - t9 * t31;
    const real_t t33 = t13 * t31;
    const real_t t34 = t10 * t31;
    const real_t t35 = structure[2] * t32 - structure[1] * t33 - structure[3] * t34;
    const real_t t36 = t6 * t35;
    const real_t t37 = t4 * t36;
    const real_t t38 = t33 + structure[1] * t36;
    const real_t t39 = t10 * t16;
    const real_t t40 = TB_C(1.0) - t10 * t39;
    const real_t t41 = t13 * t39;
    const real_t t42 = t9 * t39;
    const real_t t43 = structure[3] * t40 - (structure[1] * t41 + structure[2] * t42);
    const real_t t44 = t6 * t43;
    const real_t t45 = t4 * t44;
    const real_t t46 = t41 + structure[1] * t44;
    const real_t t47 = t37 * t38 + t45 * t46;
    const real_t t48 = t14 + t4 * t22;
    const real_t t49 = TB_C(3.0) + t48;
    const real_t t50 = t48 + TB_C(10.0);
    const real_t t51 = tb_min(tb_max(TB_C(0.0), t49), t50);
    const real_t t52 = t51 / (t37 * t37 + t45 * t45);
    const real_t t53 = t47 * t52;
    const real_t t54 = TB_C(10.0) - start_1;
    const real_t t55 = t26 + t54;
    const bool t56 = TB_C(0.0) < tb_max(t30 - t53, t53 - t55);
    const real_t t57 = t42 + structure[2] * t44;
    const real_t t58 = t32 - structure[2] * t36;
    const real_t t59 = t46 * t57 - t38 * t58;
    const real_t t60 = t38 * t57 + t46 * t58;
    const real_t t61 = TB_EPSILON * TB_C(16.0);
    const real_t t62 = t49 - t26;
    const real_t t63 = t26 + t50;
    const real_t t64 = t45 * t57 - t37 * t58;
    const real_t t65 = t34 + structure[3] * t36;
    const real_t t66 = t40 - structure[3] * t44;
    const real_t t67 = t38 * t65 - t46 * t66;
    const real_t t68 = t38 * t66 + t46 * t65;
    const real_t t69 = t37 * t65 - t45 * t66;
    real_t t70, t71, t72, t73, t74;
    if (t56) {
        const real_t t75 = tb_min(tb_max(t53, t29), t54);
        const real_t t76 = t75 / (t38 * t38 + t46 * t46);
        const real_t t77 = t38 * t45 - t37 * t46;
        const bool t78 = TB_ABS(t77) <= t61;
        const real_t t79 = t47 * t76;
        const real_t t80 = TB_C(1.0) / t77;
        real_t t81, t82;
        if (t78) {
            t81 = -TB_C(1000000000000.0);
            t82 = TB_C(1000000000000.0);
        } else {
            const real_t t83 = (t62 - t79) * t80;
            const real_t t84 = t80 * (t63 - t79);
            const real_t t85 = tb_min(t83, t84);
            const real_t t86 = tb_max(t83, t84);
            t81 = t85;
            t82 = t86;
        }
        const real_t t87 = tb_min(tb_max(TB_C(0.0), t81), t82);
        const real_t t88 = t59 * t76 + t60 * t87;
        const real_t t89 = t76 * t67 - t87 * t68;
        const real_t t90 = t79 + t77 * t87;
        const real_t t91 = TB_C(0.0) < TB_ABS(t87) ? t87 * (t47 * t80) : TB_C(0.0);
        const real_t t92 = tb_max(TB_C(0.0), t53 < t75 ? t91 - t76 : t76 - t91);
        t70 = t88;
        t71 = t89;
        t72 = t90;
        t73 = t75;
        t74 = t92;
    } else {
        const real_t t93 = t52 * t64;
        const real_t t94 = t52 * t69;
        t70 = t93;
        t71 = t94;
        t72 = t51;
        t73 = t53;
        t74 = TB_C(0.0);
    }
    const real_t t95 = TB_C(10.0) - start_2;
    const real_t t96 = t26 + t95;
    const bool t97 = TB_C(0.0) < tb_max(t28 - t70, t70 - t96);
    const real_t t98 = t58 * t66;
    const real_t t99 = t57 * t65;
    const real_t t100 = t58 * t65 + t57 * t66;
    real_t t101, t102, t103, t104, t105;
    if (t97) {
        const bool t106 = TB_ABS(t60) <= t61;
        const real_t t107 = tb_min(tb_max(t70, t27), t95);
        const real_t t108 = t107 / (t58 * t58 + t57 * t57);
        const real_t t109 = t59 * t108;
        const real_t t110 = TB_C(1.0) / t60;
        real_t t111, t112;
        if (t106) {
            t111 = -TB_C(1000000000000.0);
            t112 = TB_C(1000000000000.0);
        } else {
            const real_t t113 = -((t30 - t109) * t110);
            const real_t t114 = -(t110 * (t55 - t109));
            const real_t t115 = tb_min(t113, t114);
            const real_t t116 = tb_max(t113, t114);
            t111 = t115;
            t112 = t116;
        }
        const real_t t117 = t45 * t58 + t37 * t57;
        const bool t118 = TB_ABS(t117) <= t61;
        const real_t t119 = t64 * t108;
        const real_t t120 = TB_C(1.0) / t117;
        real_t t121, t122;
        if (t118) {
            t121 = -TB_C(1000000000000.0);
            t122 = TB_C(1000000000000.0);
        } else {
            const real_t t123 = -((t62 - t119) * t120);
            const real_t t124 = -(t120 * (t63 - t119));
            const real_t t125 = tb_min(t123, t124);
            const real_t t126 = tb_max(t123, t124);
            t121 = t125;
            t122 = t126;
        }
        const real_t t127 = tb_min(tb_max(TB_C(0.0), tb_max(t111, t121)), tb_min(t112, t122));
        const real_t t128 = (t98 - t99) * t127 - t108 * t100;
        const real_t t129 = t119 - t117 * t127;
        const real_t t130 = t109 - t60 * t127;
        real_t t131;
        if (TB_C(0.0) < TB_ABS(t127)) {
            const real_t t132 = -(t59 * t110);
            const real_t t133 = -(t64 * t120);
            const real_t t134 = TB_C(0.0) < t127 ? (t121 < t111 ? t132 : t133) : (t112 < t122 ?
                t132 : t133);
            const real_t t135 = t127 * t134;
            t131 = t135;
        } else {
            t131 = TB_C(0.0);
        }
        const real_t t136 = tb_max(TB_C(0.0), t70 < t107 ? t131 - t108 : t108 - t131);
        t101 = t128;
        t102 = t129;
        t103 = t130;
        t104 = t107;
        t105 = t136;
    } else {
        t101 = t71;
        t102 = t72;
        t103 = t73;
        t104 = t70;
        t105 = t74;
    }
    const real_t t137 = TB_C(10.0) - start_3;
    const bool t138 = TB_C(0.0) < tb_max(t23 - t26 - t101, t101 - (t26 + t137));
    real_t t139, t140, t141, t142, t143;
    if (t138) {
        const real_t t144 = tb_min(tb_max(t101, t23), t137);
        const real_t t145 = t144 / (t65 * t65 + t66 * t66);
        const real_t t146 = t69 * t145;
        const real_t t147 = t45 * t65 + t37 * t66;
        const real_t t148 = t99 - t98;
        const bool t149 = TB_ABS(t148) <= t61;
        const real_t t150 = t100 * t145;
        const real_t t151 = TB_C(1.0) / t148;
        real_t t152, t153;
        if (t149) {
            t152 = -TB_C(1000000000000.0);
            t153 = TB_C(1000000000000.0);
        } else {
            const real_t t154 = (t28 + t150) * t151;
            const real_t t155 = t151 * (t96 + t150);
            const real_t t156 = tb_min(t154, t155);
            const real_t t157 = tb_max(t154, t155);
            t152 = t156;
            t153 = t157;
        }
        const bool t158 = TB_ABS(t68) <= t61;
        const real_t t159 = t67 * t145;
        const real_t t160 = TB_C(1.0) / t68;
        real_t t161, t162;
        if (t158) {
            t161 = -TB_C(1000000000000.0);
            t162 = TB_C(1000000000000.0);
        } else {
            const real_t t163 = (t30 - t159) * t160;
            const real_t t164 = t160 * (t55 - t159);
            const real_t t165 = tb_min(t163, t164);
            const real_t t166 = tb_max(t163, t164);
            t161 = t165;
            t162 = t166;
        }
        const bool t167 = TB_ABS(t147) <= t61;
        const real_t t168 = TB_C(1.0) / t147;
        real_t t169, t170;
        if (t167) {
            t169 = -TB_C(1000000000000.0);
            t170 = TB_C(1000000000000.0);
        } else {
            const real_t t171 = (t62 - t146) * t168;
            const real_t t172 = t168 * (t63 - t146);
            const real_t t173 = tb_min(t171, t172);
            const real_t t174 = tb_max(t171, t172);
            t169 = t173;
            t170 = t174;
        }
        const real_t t175 = tb_max(t161, t169);
        const real_t t176 = tb_min(t162, t170);
        const real_t t177 = tb_min(tb_max(TB_C(0.0), tb_max(t152, t175)), tb_min(t153, t176));
        const real_t t178 = t146 + t147 * t177;
        const real_t t179 = t159 + t68 * t177;
        const real_t t180 = t148 * t177 - t150;
        real_t t181;
        if (TB_C(0.0) < TB_ABS(t177)) {
            const real_t t182 = -(t100 * t151);
            const real_t t183 = t67 * t160;
            const real_t t184 = t69 * t168;
            real_t t185;
            if (TB_C(0.0) < t177) {
                const real_t t186 = t175 < t152 ? t182 : (t169 < t161 ? t183 : t184);
                t185 = t186;
            } else {
                const real_t t187 = t153 < t176 ? t182 : (t162 < t170 ? t183 : t184);
                t185 = t187;
            }
            const real_t t188 = t177 * t185;
            t181 = t188;
        } else {
            t181 = TB_C(0.0);
        }
        const real_t t189 = tb_max(TB_C(0.0), t101 < t144 ? t181 - t145 : t145 - t181);
        t139 = t178;
        t140 = t179;
        t141 = t180;
        t142 = t144;
        t143 = t189;
    } else {
        t139 = t102;
        t140 = t103;
        t141 = t104;
        t142 = t101;
        t143 = t105;
    }
    const real_t tension_0 = tb_min(tb_max(t139 - t48, TB_C(3.0)), TB_C(10.0));
    const real_t tension_1 = tb_min(tb_max(start_1 + t140, TB_C(3.0)), TB_C(10.0));
    const real_t tension_2 = tb_min(tb_max(start_2 + t141, TB_C(3.0)), TB_C(10.0));
    const real_t tension_3 = tb_min(tb_max(start_3 + t142, TB_C(3.0)), TB_C(10.0));
    const real_t t190 = structure[0] * tension_0 + structure[1] * tension_1;
    /* what the tensions exert, S T */
    const real_t delivered_0 = t190 + structure[2] * tension_2 + structure[3] * tension_3;
    const real_t t191 = structure[4] * tension_0 + structure[5] * tension_1;
    const real_t delivered_1 = t191 + structure[6] * tension_2 + structure[7] * tension_3;
    const real_t kkt_residual_0 = tb_max(tb_max(t143, TB_ABS(delivered_0 - wrench[0])),
        TB_ABS(delivered_1 - wrench[1]));
    const bool t192 = !(TB_EPSILON * TB_C(4096.0) < t24);
    const bool t193 = kkt_residual_0 <= t25 * (TB_EPSILON * TB_C(640.0));
    const bool t194 = !t193;
    if (t192) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    if (t194) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return TB_INACCURATE;
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

tb_status tb_served_wrench_scale(const real_t structure[8], const real_t wrench[2], real_t
    served[2])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) <= TB_C(32.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(80000.0))) {
        served[0] = TB_C(0.0);
        served[1] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = structure[4] + structure[5] + structure[6] + structure[7];
    const real_t t1 = TB_C(6.5) * t0;
    const real_t t2 = wrench[1] - t1;
    const real_t t3 = structure[0] + structure[1] + structure[2] + structure[3];
    const real_t t4 = TB_C(6.5) * t3;
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
    const real_t facet_0 = TB_C(3.5) * (t11 + t15 + t19);
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
    const real_t facet_1 = TB_C(3.5) * (t11 + t25 + t29);
    const real_t t30 = t2 * structure[2] - structure[6] * t5;
    const real_t t31 = TB_ABS(t30);
    const real_t t32 = structure[7] * structure[2];
    const real_t t33 = structure[6] * structure[3];
    const real_t t34 = t32 - t33;
    const real_t t35 = TB_ABS(t34);
    const real_t facet_2 = TB_C(3.5) * (t15 + t25 + t35);
    const bool t36 = t7 <= facet_0 && t21 <= facet_1 && t31 <= facet_2;
    const real_t t37 = t2 * structure[3] - structure[7] * t5;
    const real_t t38 = TB_ABS(t37);
    const real_t facet_3 = TB_C(3.5) * (t35 + (t19 + t29));
    const bool t39 = t36 && t38 <= facet_3;
    const bool t40 = !t39;
    real_t served_0, served_1;
    if (t39) {
        served_0 = wrench[0];
        served_1 = wrench[1];
    } else {
        const real_t t41 = structure[0] * wrench[1] - structure[4] * wrench[0];
        const bool t42 = TB_C(0.0) < TB_ABS(t41);
        real_t t43, t44;
        if (t42) {
            const real_t t45 = structure[0] * t1 - structure[4] * t4;
            const real_t t46 = TB_C(1.0) / t41;
            const real_t t47 = (t45 - facet_0) * t46;
            const real_t t48 = t46 * (facet_0 + t45);
            const real_t t49 = tb_max(t47, t48);
            const real_t t50 = tb_min(t47, t48);
            t43 = t49;
            t44 = t50;
        } else {
            t43 = TB_C(1e+30);
            t44 = -TB_C(1e+30);
        }
        const real_t t51 = wrench[1] * structure[1] - structure[5] * wrench[0];
        const bool t52 = TB_C(0.0) < TB_ABS(t51);
        real_t t53, t54;
        if (t52) {
            const real_t t55 = t1 * structure[1] - structure[5] * t4;
            const real_t t56 = TB_C(1.0) / t51;
            const real_t t57 = (t55 - facet_1) * t56;
            const real_t t58 = t56 * (facet_1 + t55);
            const real_t t59 = tb_max(t57, t58);
            const real_t t60 = tb_min(t57, t58);
            t53 = t59;
            t54 = t60;
        } else {
            t53 = TB_C(1e+30);
            t54 = -TB_C(1e+30);
        }
        const real_t t61 = wrench[1] * structure[2] - structure[6] * wrench[0];
        const bool t62 = TB_C(0.0) < TB_ABS(t61);
        real_t t63, t64;
        if (t62) {
            const real_t t65 = t1 * structure[2] - structure[6] * t4;
            const real_t t66 = TB_C(1.0) / t61;
            const real_t t67 = (t65 - facet_2) * t66;
            const real_t t68 = t66 * (facet_2 + t65);
            const real_t t69 = tb_max(t67, t68);
            const real_t t70 = tb_min(t67, t68);
            t63 = t69;
            t64 = t70;
        } else {
            t63 = TB_C(1e+30);
            t64 = -TB_C(1e+30);
        }
        const real_t t71 = wrench[1] * structure[3] - structure[7] * wrench[0];
        const bool t72 = TB_C(0.0) < TB_ABS(t71);
        real_t t73, t74;
        if (t72) {
            const real_t t75 = t1 * structure[3] - structure[7] * t4;
            const real_t t76 = TB_C(1.0) / t71;
            const real_t t77 = (t75 - facet_3) * t76;
            const real_t t78 = t76 * (facet_3 + t75);
            const real_t t79 = tb_max(t77, t78);
            const real_t t80 = tb_min(t77, t78);
            t73 = t79;
            t74 = t80;
        } else {
            t73 = TB_C(1e+30);
            t74 = -TB_C(1e+30);
        }
        const real_t t81 = tb_min(tb_min(tb_min(t43, t53), t63), t73);
        const real_t t82 = tb_min(t81, TB_C(1.0));
        const bool t83 = t82 < tb_max(tb_max(tb_max(t44, t54), t64), t74) || t81 < TB_C(0.0);
        real_t t84, t85;
        if (t83) {
            const bool t86 = TB_C(0.0) < t37;
            const bool t87 = TB_C(0.0) < t17 - t16;
            const bool t88 = !t86;
            const real_t t89 = (t86 && t87) || (t88 && !t87) ? TB_C(10.0) : TB_C(3.0);
            const bool t90 = TB_C(0.0) < t27 - t26;
            const real_t t91 = (t86 && t90) || (t88 && !t90) ? TB_C(10.0) : TB_C(3.0);
            const bool t92 = TB_C(0.0) < t33 - t32;
            const real_t t93 = (t86 && t92) || (t88 && !t92) ? TB_C(10.0) : TB_C(3.0);
            const real_t t94 = structure[0] * t89 + structure[1] * t91 + structure[2] * t93;
            const real_t t95 = structure[4] * t89 + structure[5] * t91 + structure[6] * t93;
            const real_t t96 = structure[3] * (wrench[0] - t94) + structure[7] * (wrench[1] -
                t95);
            const real_t t97 = structure[3] * structure[3] + structure[7] * structure[7];
            const real_t t98 = tb_min(tb_max(t96 / t97, TB_C(3.0)), TB_C(10.0));
            const real_t t99 = t94 + structure[3] * t98;
            const real_t t100 = t99 - wrench[0];
            const real_t t101 = t95 + structure[7] * t98;
            const real_t t102 = t101 - wrench[1];
            const real_t t103 = facet_3 < t38 ? t100 * t100 + t102 * t102 : TB_C(1e+30);
            const bool t104 = TB_C(0.0) < t30;
            const bool t105 = TB_C(0.0) < t13 - t12;
            const bool t106 = !t104;
            const real_t t107 = (t104 && t105) || (t106 && !t105) ? TB_C(10.0) : TB_C(3.0);
            const bool t108 = TB_C(0.0) < t23 - t22;
            const real_t t109 = (t104 && t108) || (t106 && !t108) ? TB_C(10.0) : TB_C(3.0);
            const bool t110 = TB_C(0.0) <= t34;
            const real_t t111 = (t104 && t110) || (t106 && !t110) ? TB_C(10.0) : TB_C(3.0);
            const real_t t112 = structure[0] * t107 + structure[1] * t109 + structure[3] * t111;
            const real_t t113 = structure[4] * t107 + structure[5] * t109 + structure[7] * t111;
            const real_t t114 = structure[2] * (wrench[0] - t112) + structure[6] * (wrench[1] -
                t113);
            const real_t t115 = structure[2] * structure[2] + structure[6] * structure[6];
            const real_t t116 = tb_min(tb_max(t114 / t115, TB_C(3.0)), TB_C(10.0));
            const real_t t117 = t112 + structure[2] * t116;
            const real_t t118 = t117 - wrench[0];
            const real_t t119 = t113 + structure[6] * t116;
            const real_t t120 = t119 - wrench[1];
            const real_t t121 = facet_2 < t31 ? t118 * t118 + t120 * t120 : TB_C(1e+30);
            const bool t122 = TB_C(0.0) < t20;
            const bool t123 = TB_C(0.0) < t9 - t8;
            const bool t124 = !t122;
            const real_t t125 = (t122 && t123) || (t124 && !t123) ? TB_C(10.0) : TB_C(3.0);
            const bool t126 = TB_C(0.0) <= t24;
            const real_t t127 = (t122 && t126) || (t124 && !t126) ? TB_C(10.0) : TB_C(3.0);
            const bool t128 = TB_C(0.0) <= t28;
            const real_t t129 = (t122 && t128) || (t124 && !t128) ? TB_C(10.0) : TB_C(3.0);
            const real_t t130 = structure[0] * t125 + structure[2] * t127 + structure[3] * t129;
            const real_t t131 = structure[4] * t125 + structure[6] * t127 + structure[7] * t129;
            const real_t t132 = structure[1] * (wrench[0] - t130) + structure[5] * (wrench[1] -
                t131);
            const real_t t133 = structure[1] * structure[1] + structure[5] * structure[5];
            const real_t t134 = tb_min(tb_max(t132 / t133, TB_C(3.0)), TB_C(10.0));
            const real_t t135 = t130 + structure[1] * t134;
            const real_t t136 = t135 - wrench[0];
            const real_t t137 = t131 + structure[5] * t134;
            const real_t t138 = t137 - wrench[1];
            const real_t t139 = facet_1 < t21 ? t136 * t136 + t138 * t138 : TB_C(1e+30);
            const bool t140 = TB_C(0.0) < t6;
            const bool t141 = TB_C(0.0) <= t10;
            const bool t142 = !t140;
            const real_t t143 = (t140 && t141) || (t142 && !t141) ? TB_C(10.0) : TB_C(3.0);
            const bool t144 = TB_C(0.0) <= t14;
            const real_t t145 = (t140 && t144) || (t142 && !t144) ? TB_C(10.0) : TB_C(3.0);
            const bool t146 = TB_C(0.0) <= t18;
            const real_t t147 = (t140 && t146) || (t142 && !t146) ? TB_C(10.0) : TB_C(3.0);
            const real_t t148 = structure[1] * t143 + structure[2] * t145 + structure[3] * t147;
            const real_t t149 = structure[5] * t143 + structure[6] * t145 + structure[7] * t147;
            const real_t t150 = structure[0] * (wrench[0] - t148) + structure[4] * (wrench[1] -
                t149);
            const real_t t151 = structure[0] * structure[0] + structure[4] * structure[4];
            const real_t t152 = tb_min(tb_max(t150 / t151, TB_C(3.0)), TB_C(10.0));
            const real_t t153 = t148 + structure[0] * t152;
            const real_t t154 = t153 - wrench[0];
            const real_t t155 = t149 + structure[4] * t152;
            const real_t t156 = t155 - wrench[1];
            const real_t t157 = facet_0 < t7 ? t154 * t154 + t156 * t156 : TB_C(1e+30);
            const bool t158 = t157 < TB_C(1e+30);
            const real_t t159 = t158 ? t157 : TB_C(1e+30);
            const bool t160 = t139 < t159;
            const real_t t161 = t160 ? t139 : t159;
            const bool t162 = t121 < t161;
            real_t t163, t164, t165;
            if (t162) {
                t163 = t121;
                t164 = t117;
                t165 = t119;
            } else {
                const real_t t166 = t160 ? t135 : (t158 ? t153 : TB_C(0.0));
                const real_t t167 = t160 ? t137 : (t158 ? t155 : TB_C(0.0));
                t163 = t161;
                t164 = t166;
                t165 = t167;
            }
            const bool t168 = t103 < t163;
            const real_t t169 = t168 ? t99 : t164;
            const real_t t170 = t168 ? t101 : t165;
            t84 = t169;
            t85 = t170;
        } else {
            const real_t t171 = wrench[0] * t82;
            const real_t t172 = wrench[1] * t82;
            t84 = t171;
            t85 = t172;
        }
        served_0 = t84;
        served_1 = t85;
    }
    served[0] = served_0;
    served[1] = served_1;
    return t40 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_served_wrench_closest(const real_t structure[8], const real_t wrench[2], real_t
    served[2])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) <= TB_C(32.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(80000.0))) {
        served[0] = TB_C(0.0);
        served[1] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = structure[4] + structure[5] + structure[6] + structure[7];
    const real_t t1 = wrench[1] - TB_C(6.5) * t0;
    const real_t t2 = structure[0] + structure[1] + structure[2] + structure[3];
    const real_t t3 = wrench[0] - TB_C(6.5) * t2;
    const real_t t4 = structure[0] * t1 - structure[4] * t3;
    const real_t t5 = TB_ABS(t4);
    const real_t t6 = structure[0] * structure[5];
    const real_t t7 = structure[4] * structure[1];
    const real_t t8 = t6 - t7;
    const real_t t9 = TB_ABS(t8);
    const real_t t10 = structure[0] * structure[6];
    const real_t t11 = structure[4] * structure[2];
    const real_t t12 = t10 - t11;
    const real_t t13 = TB_ABS(t12);
    const real_t t14 = structure[0] * structure[7];
    const real_t t15 = structure[4] * structure[3];
    const real_t t16 = t14 - t15;
    const real_t t17 = TB_ABS(t16);
    /* facets of the feasible wrenches, half distances */
    const real_t facet_0 = TB_C(3.5) * (t9 + t13 + t17);
    const real_t t18 = t1 * structure[1] - structure[5] * t3;
    const real_t t19 = TB_ABS(t18);
    const real_t t20 = structure[6] * structure[1];
    const real_t t21 = structure[5] * structure[2];
    const real_t t22 = t20 - t21;
    const real_t t23 = TB_ABS(t22);
    const real_t t24 = structure[7] * structure[1];
    const real_t t25 = structure[5] * structure[3];
    const real_t t26 = t24 - t25;
    const real_t t27 = TB_ABS(t26);
    const real_t facet_1 = TB_C(3.5) * (t9 + t23 + t27);
    const real_t t28 = t1 * structure[2] - structure[6] * t3;
    const real_t t29 = TB_ABS(t28);
    const real_t t30 = structure[7] * structure[2];
    const real_t t31 = structure[6] * structure[3];
    const real_t t32 = t30 - t31;
    const real_t t33 = TB_ABS(t32);
    const real_t facet_2 = TB_C(3.5) * (t13 + t23 + t33);
    const bool t34 = t5 <= facet_0 && t19 <= facet_1 && t29 <= facet_2;
    const real_t t35 = t1 * structure[3] - structure[7] * t3;
    const real_t t36 = TB_ABS(t35);
    const real_t facet_3 = TB_C(3.5) * (t33 + (t17 + t27));
    const bool t37 = t34 && t36 <= facet_3;
    const bool t38 = !t37;
    real_t served_0, served_1;
    if (t37) {
        served_0 = wrench[0];
        served_1 = wrench[1];
    } else {
        const bool t39 = TB_C(0.0) < t35;
        const bool t40 = TB_C(0.0) < t15 - t14;
        const bool t41 = !t39;
        const real_t t42 = (t39 && t40) || (t41 && !t40) ? TB_C(10.0) : TB_C(3.0);
        const bool t43 = TB_C(0.0) < t25 - t24;
        const real_t t44 = (t39 && t43) || (t41 && !t43) ? TB_C(10.0) : TB_C(3.0);
        const bool t45 = TB_C(0.0) < t31 - t30;
        const real_t t46 = (t39 && t45) || (t41 && !t45) ? TB_C(10.0) : TB_C(3.0);
        const real_t t47 = structure[0] * t42 + structure[1] * t44 + structure[2] * t46;
        const real_t t48 = structure[4] * t42 + structure[5] * t44 + structure[6] * t46;
        const real_t t49 = structure[3] * (wrench[0] - t47) + structure[7] * (wrench[1] - t48);
        const real_t t50 = structure[3] * structure[3] + structure[7] * structure[7];
        const real_t t51 = tb_min(tb_max(t49 / t50, TB_C(3.0)), TB_C(10.0));
        const real_t t52 = t47 + structure[3] * t51;
        const real_t t53 = t52 - wrench[0];
        const real_t t54 = t48 + structure[7] * t51;
        const real_t t55 = t54 - wrench[1];
        const real_t t56 = facet_3 < t36 ? t53 * t53 + t55 * t55 : TB_C(1e+30);
        const bool t57 = TB_C(0.0) < t28;
        const bool t58 = TB_C(0.0) < t11 - t10;
        const bool t59 = !t57;
        const real_t t60 = (t57 && t58) || (t59 && !t58) ? TB_C(10.0) : TB_C(3.0);
        const bool t61 = TB_C(0.0) < t21 - t20;
        const real_t t62 = (t57 && t61) || (t59 && !t61) ? TB_C(10.0) : TB_C(3.0);
        const bool t63 = TB_C(0.0) <= t32;
        const real_t t64 = (t57 && t63) || (t59 && !t63) ? TB_C(10.0) : TB_C(3.0);
        const real_t t65 = structure[0] * t60 + structure[1] * t62 + structure[3] * t64;
        const real_t t66 = structure[4] * t60 + structure[5] * t62 + structure[7] * t64;
        const real_t t67 = structure[2] * (wrench[0] - t65) + structure[6] * (wrench[1] - t66);
        const real_t t68 = structure[2] * structure[2] + structure[6] * structure[6];
        const real_t t69 = tb_min(tb_max(t67 / t68, TB_C(3.0)), TB_C(10.0));
        const real_t t70 = t65 + structure[2] * t69;
        const real_t t71 = t70 - wrench[0];
        const real_t t72 = t66 + structure[6] * t69;
        const real_t t73 = t72 - wrench[1];
        const real_t t74 = facet_2 < t29 ? t71 * t71 + t73 * t73 : TB_C(1e+30);
        const bool t75 = TB_C(0.0) < t18;
        const bool t76 = TB_C(0.0) < t7 - t6;
        const bool t77 = !t75;
        const real_t t78 = (t75 && t76) || (t77 && !t76) ? TB_C(10.0) : TB_C(3.0);
        const bool t79 = TB_C(0.0) <= t22;
        const real_t t80 = (t75 && t79) || (t77 && !t79) ? TB_C(10.0) : TB_C(3.0);
        const bool t81 = TB_C(0.0) <= t26;
        const real_t t82 = (t75 && t81) || (t77 && !t81) ? TB_C(10.0) : TB_C(3.0);
        const real_t t83 = structure[0] * t78 + structure[2] * t80 + structure[3] * t82;
        const real_t t84 = structure[4] * t78 + structure[6] * t80 + structure[7] * t82;
        const real_t t85 = structure[1] * (wrench[0] - t83) + structure[5] * (wrench[1] - t84);
        const real_t t86 = structure[1] * structure[1] + structure[5] * structure[5];
        const real_t t87 = tb_min(tb_max(t85 / t86, TB_C(3.0)), TB_C(10.0));
        const real_t t88 = t83 + structure[1] * t87;
        const real_t t89 = t88 - wrench[0];
        const real_t t90 = t84 + structure[5] * t87;
        const real_t t91 = t90 - wrench[1];
        const real_t t92 = facet_1 < t19 ? t89 * t89 + t91 * t91 : TB_C(1e+30);
        const bool t93 = TB_C(0.0) < t4;
        const bool t94 = TB_C(0.0) <= t8;
        const bool t95 = !t93;
        const real_t t96 = (t93 && t94) || (t95 && !t94) ? TB_C(10.0) : TB_C(3.0);
        const bool t97 = TB_C(0.0) <= t12;
        const real_t t98 = (t93 && t97) || (t95 && !t97) ? TB_C(10.0) : TB_C(3.0);
        const bool t99 = TB_C(0.0) <= t16;
        const real_t t100 = (t93 && t99) || (t95 && !t99) ? TB_C(10.0) : TB_C(3.0);
        const real_t t101 = structure[1] * t96 + structure[2] * t98 + structure[3] * t100;
        const real_t t102 = structure[5] * t96 + structure[6] * t98 + structure[7] * t100;
        const real_t t103 = structure[0] * (wrench[0] - t101) + structure[4] * (wrench[1] -
            t102);
        const real_t t104 = structure[0] * structure[0] + structure[4] * structure[4];
        const real_t t105 = tb_min(tb_max(t103 / t104, TB_C(3.0)), TB_C(10.0));
        const real_t t106 = t101 + structure[0] * t105;
        const real_t t107 = t106 - wrench[0];
        const real_t t108 = t102 + structure[4] * t105;
        const real_t t109 = t108 - wrench[1];
        const real_t t110 = facet_0 < t5 ? t107 * t107 + t109 * t109 : TB_C(1e+30);
        const bool t111 = t110 < TB_C(1e+30);
        const real_t t112 = t111 ? t110 : TB_C(1e+30);
        const bool t113 = t92 < t112;
        const real_t t114 = t113 ? t92 : t112;
        const bool t115 = t74 < t114;
        real_t t116, t117, t118;
        if (t115) {
            t116 = t74;
            t117 = t70;
            t118 = t72;
        } else {
            const real_t t119 = t113 ? t88 : (t111 ? t106 : TB_C(0.0));
            const real_t t120 = t113 ? t90 : (t111 ? t108 : TB_C(0.0));
            t116 = t114;
            t117 = t119;
            t118 = t120;
        }
        const bool t121 = t56 < t116;
        const real_t t122 = t121 ? t52 : t117;
        const real_t t123 = t121 ? t54 : t118;
        served_0 = t122;
        served_1 = t123;
    }
    served[0] = served_0;
    served[1] = served_1;
    return t38 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_distribute_tension_paper(const real_t structure[8], const real_t wrench[2], real_t
    tension[4], real_t delivered[2], real_t kkt_residual[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) <= TB_C(32.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(80000.0))) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
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
    /* T0, the least-norm tensions that exert the wrench */
    const real_t start_3 = t18 - structure[3] * t22;
    const real_t t23 = TB_C(3.0) - start_3;
    const real_t t24 = TB_C(3.0) + (TB_ABS(wrench[0]) + TB_ABS(wrench[1]));
    const real_t t25 = tb_min(TB_ABS(t3), TB_ABS(t12));
    const real_t t26 = TB_C(1.0) / t25;
    const real_t t27 = TB_C(8.0) * TB_EPSILON * t24 * t26;
    const real_t start_2 = t20 - structure[2] * t22;
    const real_t t28 = TB_C(3.0) - start_2;
    const real_t t29 = t28 - t27;
    const real_t start_1 = t19 - structure[1] * t22;
    const real_t t30 = TB_C(3.0) - start_1;
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
    const real_t t50 = TB_C(3.0) + t49;
    const real_t t51 = t49 + TB_C(1000000000000.0);
    const real_t t52 = tb_min(tb_max(TB_C(0.0), t50), t51);
    const real_t t53 = t52 / (t38 * t38 + t46 * t46);
    const real_t t54 = t48 * t53;
    const real_t t55 = TB_C(1000000000000.0) - start_1;
    const real_t t56 = t27 + t55;
    const bool t57 = TB_C(0.0) < tb_max(t31 - t54, t54 - t56);
    const real_t t58 = t43 + structure[2] * t45;
    const real_t t59 = t33 - structure[2] * t37;
    const real_t t60 = t47 * t58 - t39 * t59;
    const real_t t61 = t39 * t58 + t47 * t59;
    const real_t t62 = TB_EPSILON * TB_C(16.0);
    const real_t t63 = t50 - t27;
    const real_t t64 = t27 + t51;
    const real_t t65 = t46 * t58 - t38 * t59;
    const real_t t66 = t35 + structure[3] * t37;
    const real_t t67 = t41 - structure[3] * t45;
    const real_t t68 = t39 * t66 - t47 * t67;
    const real_t t69 = t39 * t67 + t47 * t66;
    const real_t t70 = t38 * t66 - t46 * t67;
    real_t t71, t72, t73, t74, t75;
    if (t57) {
        const real_t t76 = tb_min(tb_max(t54, t30), t55);
        const real_t t77 = t76 / (t39 * t39 + t47 * t47);
        const real_t t78 = t39 * t46 - t38 * t47;
        const bool t79 = TB_ABS(t78) <= t62;
        const real_t t80 = t48 * t77;
        const real_t t81 = TB_C(1.0) / t78;
        real_t t82, t83;
        if (t79) {
            t82 = -TB_C(1000000000000.0);
            t83 = TB_C(1000000000000.0);
        } else {
            const real_t t84 = (t63 - t80) * t81;
            const real_t t85 = t81 * (t64 - t80);
            const real_t t86 = tb_min(t84, t85);
            const real_t t87 = tb_max(t84, t85);
            t82 = t86;
            t83 = t87;
        }
        const real_t t88 = tb_min(tb_max(TB_C(0.0), t82), t83);
        const real_t t89 = t60 * t77 + t61 * t88;
        const real_t t90 = t77 * t68 - t88 * t69;
        const real_t t91 = TB_C(0.0) < TB_ABS(t88) ? t88 * (t48 * t81) : TB_C(0.0);
        const real_t t92 = tb_max(TB_C(0.0), t54 < t76 ? t91 - t77 : t77 - t91);
        const real_t t93 = t80 + t78 * t88;
        t71 = t89;
        t72 = t90;
        t73 = t92;
        t74 = t93;
        t75 = t76;
    } else {
        const real_t t94 = t53 * t65;
        const real_t t95 = t53 * t70;
        t71 = t94;
        t72 = t95;
        t73 = TB_C(0.0);
        t74 = t52;
        t75 = t54;
    }
    const real_t t96 = TB_C(1000000000000.0) - start_2;
    const real_t t97 = t27 + t96;
    const bool t98 = TB_C(0.0) < tb_max(t29 - t71, t71 - t97);
    const real_t t99 = t59 * t67;
    const real_t t100 = t58 * t66;
    const real_t t101 = t59 * t66 + t58 * t67;
    real_t t102, t103, t104, t105, t106;
    if (t98) {
        const bool t107 = TB_ABS(t61) <= t62;
        const real_t t108 = tb_min(tb_max(t71, t28), t96);
        const real_t t109 = t108 / (t59 * t59 + t58 * t58);
        const real_t t110 = t60 * t109;
        const real_t t111 = TB_C(1.0) / t61;
        real_t t112, t113;
        if (t107) {
            t112 = -TB_C(1000000000000.0);
            t113 = TB_C(1000000000000.0);
        } else {
            const real_t t114 = -((t31 - t110) * t111);
            const real_t t115 = -(t111 * (t56 - t110));
            const real_t t116 = tb_min(t114, t115);
            const real_t t117 = tb_max(t114, t115);
            t112 = t116;
            t113 = t117;
        }
        const real_t t118 = t46 * t59 + t38 * t58;
        const bool t119 = TB_ABS(t118) <= t62;
        const real_t t120 = t65 * t109;
        const real_t t121 = TB_C(1.0) / t118;
        real_t t122, t123;
        if (t119) {
            t122 = -TB_C(1000000000000.0);
            t123 = TB_C(1000000000000.0);
        } else {
            const real_t t124 = -((t63 - t120) * t121);
            const real_t t125 = -(t121 * (t64 - t120));
            const real_t t126 = tb_min(t124, t125);
            const real_t t127 = tb_max(t124, t125);
            t122 = t126;
            t123 = t127;
        }
        const real_t t128 = tb_min(tb_max(TB_C(0.0), tb_max(t112, t122)), tb_min(t113, t123));
        const real_t t129 = (t99 - t100) * t128 - t109 * t101;
        real_t t130;
        if (TB_C(0.0) < TB_ABS(t128)) {
            const real_t t131 = -(t60 * t111);
            const real_t t132 = -(t65 * t121);
            const real_t t133 = TB_C(0.0) < t128 ? (t122 < t112 ? t131 : t132) : (t113 < t123 ?
                t131 : t132);
            const real_t t134 = t128 * t133;
            t130 = t134;
        } else {
            t130 = TB_C(0.0);
        }
        const real_t t135 = tb_max(TB_C(0.0), t71 < t108 ? t130 - t109 : t109 - t130);
        const real_t t136 = t120 - t118 * t128;
        const real_t t137 = t110 - t61 * t128;
        t102 = t129;
        t103 = t135;
        t104 = t136;
        t105 = t137;
        t106 = t108;
    } else {
        t102 = t72;
        t103 = t73;
        t104 = t74;
        t105 = t75;
        t106 = t71;
    }
    const real_t t138 = TB_C(1000000000000.0) - start_3;
    const bool t139 = TB_C(0.0) < tb_max(t23 - t27 - t102, t102 - (t27 + t138));
    real_t t140, t141, t142, t143, t144;
    if (t139) {
        const real_t t145 = tb_min(tb_max(t102, t23), t138);
        const real_t t146 = t145 / (t66 * t66 + t67 * t67);
        const real_t t147 = t100 - t99;
        const bool t148 = TB_ABS(t147) <= t62;
        const real_t t149 = t101 * t146;
        const real_t t150 = TB_C(1.0) / t147;
        real_t t151, t152;
        if (t148) {
            t151 = -TB_C(1000000000000.0);
            t152 = TB_C(1000000000000.0);
        } else {
            const real_t t153 = (t29 + t149) * t150;
            const real_t t154 = t150 * (t97 + t149);
            const real_t t155 = tb_min(t153, t154);
            const real_t t156 = tb_max(t153, t154);
            t151 = t155;
            t152 = t156;
        }
        const bool t157 = TB_ABS(t69) <= t62;
        const real_t t158 = t68 * t146;
        const real_t t159 = TB_C(1.0) / t69;
        real_t t160, t161;
        if (t157) {
            t160 = -TB_C(1000000000000.0);
            t161 = TB_C(1000000000000.0);
        } else {
            const real_t t162 = (t31 - t158) * t159;
            const real_t t163 = t159 * (t56 - t158);
            const real_t t164 = tb_min(t162, t163);
            const real_t t165 = tb_max(t162, t163);
            t160 = t164;
            t161 = t165;
        }
        const real_t t166 = t46 * t66 + t38 * t67;
        const bool t167 = TB_ABS(t166) <= t62;
        const real_t t168 = t70 * t146;
        const real_t t169 = TB_C(1.0) / t166;
        real_t t170, t171;
        if (t167) {
            t170 = -TB_C(1000000000000.0);
            t171 = TB_C(1000000000000.0);
        } else {
            const real_t t172 = (t63 - t168) * t169;
            const real_t t173 = t169 * (t64 - t168);
            const real_t t174 = tb_min(t172, t173);
            const real_t t175 = tb_max(t172, t173);
            t170 = t174;
            t171 = t175;
        }
        const real_t t176 = tb_max(t160, t170);
        const real_t t177 = tb_min(t161, t171);
        const real_t t178 = tb_min(tb_max(TB_C(0.0), tb_max(t151, t176)), tb_min(t152, t177));
        real_t t179;
        if (TB_C(0.0) < TB_ABS(t178)) {
            const real_t t180 = -(t101 * t150);
            const real_t t181 = t68 * t159;
            const real_t t182 = t70 * t169;
            real_t t183;
            if (TB_C(0.0) < t178) {
                const real_t t184 = t176 < t151 ? t180 : (t170 < t160 ? t181 : t182);
                t183 = t184;
            } else {
                const real_t t185 = t152 < t177 ? t180 : (t161 < t171 ? t181 : t182);
                t183 = t185;
            }
            const real_t t186 = t178 * t183;
            t179 = t186;
        } else {
            t179 = TB_C(0.0);
        }
        const real_t t187 = tb_max(TB_C(0.0), t102 < t145 ? t179 - t146 : t146 - t179);
        const real_t t188 = t168 + t166 * t178;
        const real_t t189 = t158 + t69 * t178;
        const real_t t190 = t147 * t178 - t149;
        t140 = t187;
        t141 = t188;
        t142 = t189;
        t143 = t190;
        t144 = t145;
    } else {
        t140 = t103;
        t141 = t104;
        t142 = t105;
        t143 = t106;
        t144 = t102;
    }
    const real_t t191 = tb_min(tb_max(t141 - t49, TB_C(3.0)), TB_C(1000000000000.0));
    const real_t t192 = tb_min(tb_max(start_1 + t142, TB_C(3.0)), TB_C(1000000000000.0));
    const real_t t193 = tb_min(tb_max(start_2 + t143, TB_C(3.0)), TB_C(1000000000000.0));
    const real_t t194 = structure[0] * t191 + structure[1] * t192 + structure[2] * t193;
    const real_t t195 = tb_min(tb_max(start_3 + t144, TB_C(3.0)), TB_C(1000000000000.0));
    const real_t t196 = tb_max(t140, TB_ABS(t194 + structure[3] * t195 - wrench[0]));
    const real_t t197 = structure[4] * t191 + structure[5] * t192 + structure[6] * t193;
    const real_t t198 = tb_max(t196, TB_ABS(t197 + structure[7] * t195 - wrench[1]));
    const bool t199 = t198 <= t26 * (t24 * (TB_EPSILON * TB_C(64.0)));
    real_t tension_0, tension_1, tension_2, tension_3, kkt_residual_0;
    if (t199) {
        const real_t t200 = tb_min(t191, TB_C(10.0));
        const real_t t201 = tb_min(t192, TB_C(10.0));
        const real_t t202 = tb_min(t193, TB_C(10.0));
        const real_t t203 = tb_min(t195, TB_C(10.0));
        tension_0 = t200;
        tension_1 = t201;
        tension_2 = t202;
        tension_3 = t203;
        kkt_residual_0 = t198;
    } else {
        tension_0 = TB_C(3.0);
        tension_1 = TB_C(3.0);
        tension_2 = TB_C(3.0);
        tension_3 = TB_C(3.0);
        kkt_residual_0 = TB_C(0.0);
    }
    const real_t t204 = structure[0] * tension_0 + structure[1] * tension_1;
    /* what the tensions exert, S T */
    const real_t delivered_0 = t204 + structure[2] * tension_2 + structure[3] * tension_3;
    const real_t t205 = structure[4] * tension_0 + structure[5] * tension_1;
    const real_t delivered_1 = t205 + structure[6] * tension_2 + structure[7] * tension_3;
    const bool t206 = !(TB_EPSILON * TB_C(4096.0) < t25);
    const bool t207 = TB_C(10.0) < t191 || TB_C(10.0) < t192 || TB_C(10.0) < t193;
    const bool t208 = !t199 || (t207 || TB_C(10.0) < t195);
    if (t206) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    delivered[0] = delivered_0;
    delivered[1] = delivered_1;
    kkt_residual[0] = kkt_residual_0;
    return t208 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_distribute_tension_scale(const real_t structure[8], const real_t wrench[2], real_t
    tension[4], real_t delivered[2], real_t kkt_residual[1])
{
    tb_status status = tb_least_norm_tension_quick(structure, wrench, tension, delivered,
        kkt_residual);
    if (status != TB_INACCURATE) {
        return status;
    }
    real_t served[2];
    const tb_status verdict = tb_served_wrench_scale(structure, wrench, served);
    if (status == TB_INACCURATE) {
        status = tb_least_norm_tension_quick(structure, served, tension, delivered,
            kkt_residual);
    }
    if (status == TB_INACCURATE) {
        status = tb_least_norm_tension(structure, served, tension, delivered, kkt_residual);
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
    const tb_status verdict = tb_served_wrench_closest(structure, wrench, served);
    if (status == TB_INACCURATE) {
        status = tb_least_norm_tension_quick(structure, served, tension, delivered,
            kkt_residual);
    }
    if (status == TB_INACCURATE) {
        status = tb_least_norm_tension(structure, served, tension, delivered, kkt_residual);
    }
    return status == TB_OK ? verdict : status;
}

tb_status tb_distribute_tension(const real_t structure[8], const real_t wrench[2], real_t
    tension[4], real_t delivered[2], real_t kkt_residual[1])
{
    return tb_distribute_tension_scale(structure, wrench, tension, delivered, kkt_residual);
}

