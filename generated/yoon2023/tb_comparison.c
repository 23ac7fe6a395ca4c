/* Regenerate: turnbuckle generate machines/yoon2023.toml --out <this folder>
 * Machine 499338192b9e5092, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_comparison.h"
#include "tb_machine.h"

/* Refuses with a status: tension is 3 N. */
static tb_status tb_refuse_kernel_tension(tb_status status, real_t tension[4])
{
    tension[0] = TB_TENSION_MIN;
    tension[1] = TB_TENSION_MIN;
    tension[2] = TB_TENSION_MIN;
    tension[3] = TB_TENSION_MIN;
    return status;
}

tb_status tb_kernel_tension(const real_t structure[8], const real_t wrench[2],
    real_t tension[4])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) <= TB_C(32.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(80000.0))) {
        return tb_refuse_kernel_tension(TB_OUT_OF_DOMAIN, tension);
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
    const real_t t23 = t18 - structure[3] * t22;
    const real_t t24 = TB_TENSION_MIN - t23;
    const real_t t25 = TB_TENSION_MIN + (TB_ABS(wrench[0]) + TB_ABS(wrench[1]));
    const real_t t26 = TB_ABS(t3);
    const real_t t27 = TB_ABS(t12);
    const real_t t28 = TB_C(1.0) / tb_min(t26, t27);
    const real_t t29 = TB_C(3.0) * TB_EPSILON * t25 * t28;
    const real_t t30 = t20 - structure[2] * t22;
    const real_t t31 = TB_TENSION_MIN - t30;
    const real_t t32 = t31 - t29;
    const real_t t33 = t19 - structure[1] * t22;
    const real_t t34 = TB_TENSION_MIN - t33;
    const real_t t35 = t34 - t29;
    const real_t t36 = t9 * t16;
    const real_t t37 = TB_C(1.0) - t9 * t36;
    const real_t t38 = t13 * t36;
    const real_t t39 = t10 * t36;
    const real_t t40 = structure[2] * t37 - structure[1] * t38 - structure[3] * t39;
    const real_t t41 = t6 * t40;
    const real_t t42 = t4 * t41;
    const real_t t43 = t38 + structure[1] * t41;
    const real_t t44 = t10 * t16;
    const real_t t45 = TB_C(1.0) - t10 * t44;
    const real_t t46 = t13 * t44;
    const real_t t47 = t9 * t44;
    const real_t t48 = structure[3] * t45 - (structure[1] * t46 + structure[2] * t47);
    const real_t t49 = t6 * t48;
    const real_t t50 = t4 * t49;
    const real_t t51 = t46 + structure[1] * t49;
    const real_t t52 = t42 * t43 + t50 * t51;
    const real_t t53 = t14 + t4 * t22;
    const real_t t54 = TB_TENSION_MIN + t53;
    const real_t t55 = t53 + TB_C(1000000000000.0);
    const real_t t56 = tb_min(tb_max(TB_C(0.0), t54), t55);
    const real_t t57 = t29 < TB_ABS(t56) ? t56 : TB_C(0.0);
    const real_t t58 = t57 / tb_max(t42 * t42 + t50 * t50, TB_EPSILON);
    const real_t t59 = t52 * t58;
    const real_t t60 = TB_C(1000000000000.0) - t33;
    const real_t t61 = t29 + t60;
    const real_t t62 = tb_max(t35 - t59, t59 - t61);
    const bool t63 = TB_C(0.0) < t62;
    const real_t t64 = t47 + structure[2] * t49;
    const real_t t65 = t37 - structure[2] * t41;
    const real_t t66 = t51 * t64 - t43 * t65;
    const real_t t67 = t43 * t64 + t51 * t65;
    const real_t t68 = TB_EPSILON * TB_C(16.0);
    const real_t t69 = t54 - t29;
    const real_t t70 = t29 + t55;
    const real_t t71 = t50 * t64 - t42 * t65;
    const real_t t72 = t39 + structure[3] * t41;
    const real_t t73 = t45 - structure[3] * t49;
    const real_t t74 = t43 * t72 - t51 * t73;
    const real_t t75 = t43 * t73 + t51 * t72;
    const real_t t76 = t42 * t72 - t50 * t73;
    const real_t t77 = t29 * TB_C(2.0);
    const real_t t78 = t29 * TB_C(1024.0);
    real_t t79, t80, t81, t82, t83;
    if (t63) {
        const real_t t84 = tb_min(tb_max(t59, t34), t60);
        const real_t t85 = TB_C(1.0) / tb_max(t43 * t43 + t51 * t51, TB_EPSILON);
        const real_t t86 = t84 * t85;
        const real_t t87 = t43 * t50 - t42 * t51;
        const bool t88 = TB_ABS(t87) <= t68;
        const real_t t89 = t52 * t86;
        const real_t t90 = TB_C(1.0) / t87;
        real_t t91, t92;
        if (t88) {
            t91 = -TB_C(1000000000000.0);
            t92 = TB_C(1000000000000.0);
        } else {
            const real_t t93 = (t69 - t89) * t90;
            const real_t t94 = t90 * (t70 - t89);
            t91 = tb_min(t93, t94);
            t92 = tb_max(t93, t94);
        }
        const real_t t95 = tb_min(tb_max(TB_C(0.0), t91), t92);
        const real_t t96 = TB_C(0.0) < TB_ABS(t95) ? t95 * (t52 * t90) : TB_C(0.0);
        const real_t t97 = t59 < t84 ? t96 - t86 : t86 - t96;
        real_t t98;
        if (TB_C(0.0) < t97) {
            const real_t t99 = t88 ? TB_C(0.0) : t77 * TB_ABS(t90);
            const real_t t100 = t91 + t99 < t92 - t99 && t78 < t62 ? t97 : TB_C(0.0);
            t98 = t100;
        } else {
            t98 = TB_C(0.0);
        }
        t79 = t66 * t86 + t67 * t95;
        t80 = t86 * t74 - t95 * t75;
        t81 = t98;
        t82 = t89 + t87 * t95;
        t83 = t84;
    } else {
        t79 = t58 * t71;
        t80 = t58 * t76;
        t81 = TB_C(0.0);
        t82 = t57;
        t83 = t59;
    }
    const real_t t101 = TB_C(1000000000000.0) - t30;
    const real_t t102 = t29 + t101;
    const real_t t103 = tb_max(t32 - t79, t79 - t102);
    const bool t104 = TB_C(0.0) < t103;
    const real_t t105 = t65 * t73;
    const real_t t106 = t64 * t72;
    const real_t t107 = t65 * t72 + t64 * t73;
    real_t t108, t109, t110, t111, t112;
    if (t104) {
        const bool t113 = TB_ABS(t67) <= t68;
        const real_t t114 = tb_min(tb_max(t79, t31), t101);
        const real_t t115 = TB_C(1.0) / tb_max(t65 * t65 + t64 * t64, TB_EPSILON);
        const real_t t116 = t114 * t115;
        const real_t t117 = t66 * t116;
        const real_t t118 = TB_C(1.0) / t67;
        real_t t119, t120;
        if (t113) {
            t119 = -TB_C(1000000000000.0);
            t120 = TB_C(1000000000000.0);
        } else {
            const real_t t121 = -((t35 - t117) * t118);
            const real_t t122 = -(t118 * (t61 - t117));
            t119 = tb_min(t121, t122);
            t120 = tb_max(t121, t122);
        }
        const real_t t123 = t50 * t65 + t42 * t64;
        const bool t124 = TB_ABS(t123) <= t68;
        const real_t t125 = t71 * t116;
        const real_t t126 = TB_C(1.0) / t123;
        real_t t127, t128;
        if (t124) {
            t127 = -TB_C(1000000000000.0);
            t128 = TB_C(1000000000000.0);
        } else {
            const real_t t129 = -((t69 - t125) * t126);
            const real_t t130 = -(t126 * (t70 - t125));
            t127 = tb_min(t129, t130);
            t128 = tb_max(t129, t130);
        }
        const real_t t131 = tb_min(tb_max(TB_C(0.0), tb_max(t119, t127)), tb_min(t120, t128));
        real_t t132;
        if (TB_C(0.0) < TB_ABS(t131)) {
            const real_t t133 = -(t66 * t118);
            const real_t t134 = -(t71 * t126);
            const real_t t135 = TB_C(0.0) < t131 ? (t127 < t119 ? t133 : t134) : (t120 < t128 ?
                t133 : t134);
            t132 = t131 * t135;
        } else {
            t132 = TB_C(0.0);
        }
        const real_t t136 = t79 < t114 ? t132 - t116 : t116 - t132;
        real_t t137;
        if (TB_C(0.0) < t136) {
            real_t t138;
            if (t124) {
                t138 = TB_C(0.0);
            } else {
                t138 = t77 * TB_ABS(TB_C(1.0) / -t123);
            }
            real_t t139;
            if (t113) {
                t139 = TB_C(0.0);
            } else {
                t139 = t77 * TB_ABS(TB_C(1.0) / -t67);
            }
            const bool t140 = tb_max(t127 + t138, t119 + t139) < tb_min(t128 - t138, t120 -
                t139);
            t137 = t140 && t78 < t103 ? t136 : TB_C(0.0);
        } else {
            t137 = TB_C(0.0);
        }
        t108 = (t105 - t106) * t131 - t116 * t107;
        t109 = t137;
        t110 = t125 - t123 * t131;
        t111 = t117 - t67 * t131;
        t112 = t114;
    } else {
        t108 = t80;
        t109 = t81;
        t110 = t82;
        t111 = t83;
        t112 = t79;
    }
    const real_t t141 = TB_C(1000000000000.0) - t23;
    const real_t t142 = tb_max(t24 - t29 - t108, t108 - (t29 + t141));
    const bool t143 = TB_C(0.0) < t142;
    real_t t144, t145, t146, t147, t148;
    if (t143) {
        const real_t t149 = tb_min(tb_max(t108, t24), t141);
        const real_t t150 = TB_C(1.0) / tb_max(t72 * t72 + t73 * t73, TB_EPSILON);
        const real_t t151 = t149 * t150;
        const real_t t152 = t106 - t105;
        const bool t153 = TB_ABS(t152) <= t68;
        const real_t t154 = t107 * t151;
        const real_t t155 = TB_C(1.0) / t152;
        real_t t156, t157;
        if (t153) {
            t156 = -TB_C(1000000000000.0);
            t157 = TB_C(1000000000000.0);
        } else {
            const real_t t158 = (t32 + t154) * t155;
            const real_t t159 = t155 * (t102 + t154);
            t156 = tb_min(t158, t159);
            t157 = tb_max(t158, t159);
        }
        const bool t160 = TB_ABS(t75) <= t68;
        const real_t t161 = t74 * t151;
        const real_t t162 = TB_C(1.0) / t75;
        real_t t163, t164;
        if (t160) {
            t163 = -TB_C(1000000000000.0);
            t164 = TB_C(1000000000000.0);
        } else {
            const real_t t165 = (t35 - t161) * t162;
            const real_t t166 = t162 * (t61 - t161);
            t163 = tb_min(t165, t166);
            t164 = tb_max(t165, t166);
        }
        const real_t t167 = t50 * t72 + t42 * t73;
        const bool t168 = TB_ABS(t167) <= t68;
        const real_t t169 = t76 * t151;
        const real_t t170 = TB_C(1.0) / t167;
        real_t t171, t172;
        if (t168) {
            t171 = -TB_C(1000000000000.0);
            t172 = TB_C(1000000000000.0);
        } else {
            const real_t t173 = (t69 - t169) * t170;
            const real_t t174 = t170 * (t70 - t169);
            t171 = tb_min(t173, t174);
            t172 = tb_max(t173, t174);
        }
        const real_t t175 = tb_max(t163, t171);
        const real_t t176 = tb_min(t164, t172);
        const real_t t177 = tb_min(tb_max(TB_C(0.0), tb_max(t156, t175)), tb_min(t157, t176));
        real_t t178;
        if (TB_C(0.0) < TB_ABS(t177)) {
            const real_t t179 = -(t107 * t155);
            const real_t t180 = t74 * t162;
            const real_t t181 = t76 * t170;
            real_t t182;
            if (TB_C(0.0) < t177) {
                t182 = t175 < t156 ? t179 : (t171 < t163 ? t180 : t181);
            } else {
                t182 = t157 < t176 ? t179 : (t164 < t172 ? t180 : t181);
            }
            t178 = t177 * t182;
        } else {
            t178 = TB_C(0.0);
        }
        const real_t t183 = t108 < t149 ? t178 - t151 : t151 - t178;
        real_t t184;
        if (TB_C(0.0) < t183) {
            const real_t t185 = t168 ? TB_C(0.0) : t77 * TB_ABS(t170);
            const real_t t186 = t160 ? TB_C(0.0) : t77 * TB_ABS(t162);
            const real_t t187 = t153 ? TB_C(0.0) : t77 * TB_ABS(t155);
            const real_t t188 = tb_max(tb_max(t171 + t185, t163 + t186), t156 + t187);
            const real_t t189 = tb_min(tb_min(t172 - t185, t164 - t186), t157 - t187);
            t184 = t188 < t189 && t78 < t142 ? t183 : TB_C(0.0);
        } else {
            t184 = TB_C(0.0);
        }
        t144 = t184;
        t145 = t169 + t167 * t177;
        t146 = t161 + t75 * t177;
        t147 = t152 * t177 - t154;
        t148 = t149;
    } else {
        t144 = t109;
        t145 = t110;
        t146 = t111;
        t147 = t112;
        t148 = t108;
    }
    const real_t t190 = tb_min(tb_max(t145 - t53, TB_TENSION_MIN), TB_C(1000000000000.0));
    const real_t t191 = tb_min(tb_max(t33 + t146, TB_TENSION_MIN), TB_C(1000000000000.0));
    const real_t t192 = tb_min(tb_max(t30 + t147, TB_TENSION_MIN), TB_C(1000000000000.0));
    const real_t t193 = structure[0] * t190 + structure[1] * t191 + structure[2] * t192;
    const real_t t194 = tb_min(tb_max(t23 + t148, TB_TENSION_MIN), TB_C(1000000000000.0));
    const real_t t195 = tb_max(t144, TB_ABS(t193 + structure[3] * t194 - wrench[0]));
    const real_t t196 = structure[4] * t190 + structure[5] * t191 + structure[6] * t192;
    const real_t t197 = tb_max(t195, TB_ABS(t196 + structure[7] * t194 - wrench[1]));
    const real_t t198 = TB_EPSILON * TB_C(128.0) * tb_max(tb_max(tb_max(t190, t191), t192),
        t194);
    const bool t199 = t197 <= tb_min(t28 * t198, TB_C(0.01));
    const bool t200 = !t199;
    const real_t tension_0 = t199 ? t190 : TB_TENSION_MIN;
    const real_t tension_1 = t199 ? t191 : TB_TENSION_MIN;
    const real_t tension_2 = t199 ? t192 : TB_TENSION_MIN;
    const real_t tension_3 = t199 ? t194 : TB_TENSION_MIN;
    const real_t t201 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t202 = !(t201 < t26 && t201 < t27);
    if (t202) {
        return tb_refuse_kernel_tension(TB_SINGULAR, tension);
    }
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    return t200 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_largest_tensions_eq17(const real_t structure[8], const real_t force[1],
    real_t tension[4])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) <= TB_C(32.0)
          && force[0] >= TB_C(0.0) && force[0] <= TB_C(10000.0))) {
        tension[0] = TB_C(0.0);
        tension[1] = TB_C(0.0);
        tension[2] = TB_C(0.0);
        tension[3] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = TB_C(64.0) * TB_EPSILON;
    const real_t t1 = structure[0] * structure[5];
    const real_t t2 = structure[4] * structure[1];
    const real_t t3 = t1 - t2;
    const bool t4 = t0 < t3;
    const real_t t5 = structure[0] * structure[6];
    const real_t t6 = structure[4] * structure[2];
    const real_t t7 = t5 - t6;
    const bool t8 = t0 < t7;
    const real_t t9 = structure[5] * structure[2];
    const real_t t10 = structure[1] * structure[6];
    const real_t t11 = t9 - t10;
    const bool t12 = t0 < t11;
    const real_t t13 = structure[0] * structure[7];
    const real_t t14 = structure[4] * structure[3];
    const real_t t15 = t13 - t14;
    const bool t16 = t0 < t15;
    const real_t t17 = structure[5] * structure[3];
    const real_t t18 = structure[1] * structure[7];
    const real_t t19 = t17 - t18;
    const bool t20 = t0 < t19;
    const bool t21 = t4 && !((t8 && t12) || (t16 && t20));
    const real_t t22 = t10 - t9;
    const bool t23 = t0 < t22;
    const real_t t24 = structure[6] * structure[3];
    const real_t t25 = structure[2] * structure[7];
    const real_t t26 = t24 - t25;
    const bool t27 = t0 < t26;
    const bool t28 = t8 && !((t4 && t23) || (t16 && t27));
    const real_t t29 = t18 - t17;
    const bool t30 = t0 < t29;
    const real_t t31 = t25 - t24;
    const bool t32 = t0 < t31;
    const bool t33 = t16 && !((t4 && t30) || (t8 && t32));
    const real_t t34 = t2 - t1;
    const bool t35 = t0 < t34;
    const real_t t36 = t6 - t5;
    const bool t37 = t0 < t36;
    const real_t t38 = t14 - t13;
    const bool t39 = t0 < t38;
    const bool t40 = t35 && !((t23 && t37) || (t30 && t39));
    const bool t41 = t23 && !((t8 && t35) || (t27 && t30));
    const bool t42 = t30 && !((t16 && t35) || (t23 && t32));
    const bool t43 = t37 && !((t12 && t35) || (t32 && t39));
    const bool t44 = t12 && !((t4 && t37) || (t20 && t32));
    const bool t45 = t32 && !((t16 && t37) || (t12 && t30));
    const bool t46 = (t21 || t28 || t33) && (t40 || t41 || t42) && (t43 || t44 || t45);
    const bool t47 = t39 && !((t20 && t35) || (t27 && t37));
    const bool t48 = t20 && !((t4 && t39) || (t12 && t27));
    const bool t49 = t27 && !((t8 && t39) || (t20 && t23));
    const bool t50 = t46 && (t47 || t48 || t49);
    real_t tension_0, tension_1, tension_2, tension_3;
    if (t50) {
        const real_t t51 = structure[0] * structure[1] + structure[5] * structure[4];
        const bool t52 = t51 < TB_C(0.0);
        real_t t53;
        if (t21) {
            real_t t54;
            if (t52) {
                t54 = TB_C(1.0) / t3;
            } else {
                t54 = TB_C(1.0);
            }
            t53 = t54;
        } else {
            t53 = TB_C(0.0);
        }
        const real_t t55 = tb_max(TB_C(0.0), t53);
        const real_t t56 = structure[0] * structure[2] + structure[4] * structure[6];
        const bool t57 = t56 < TB_C(0.0);
        real_t t58;
        if (t28) {
            real_t t59;
            if (t57) {
                t59 = TB_C(1.0) / t7;
            } else {
                t59 = TB_C(1.0);
            }
            t58 = t59;
        } else {
            t58 = TB_C(0.0);
        }
        const real_t t60 = structure[0] * structure[3] + structure[4] * structure[7];
        const bool t61 = t60 < TB_C(0.0);
        real_t t62;
        if (t33) {
            real_t t63;
            if (t61) {
                t63 = TB_C(1.0) / t15;
            } else {
                t63 = TB_C(1.0);
            }
            t62 = t63;
        } else {
            t62 = TB_C(0.0);
        }
        real_t t64;
        if (t40) {
            real_t t65;
            if (t52) {
                t65 = TB_C(1.0) / t34;
            } else {
                t65 = TB_C(1.0);
            }
            t64 = t65;
        } else {
            t64 = TB_C(0.0);
        }
        real_t t66;
        if (t43) {
            real_t t67;
            if (t57) {
                t67 = TB_C(1.0) / t36;
            } else {
                t67 = TB_C(1.0);
            }
            t66 = t67;
        } else {
            t66 = TB_C(0.0);
        }
        const real_t t68 = tb_max(tb_max(tb_max(tb_max(t55, t58), t62), t64), t66);
        real_t t69;
        if (t47) {
            real_t t70;
            if (t61) {
                t70 = TB_C(1.0) / t38;
            } else {
                t70 = TB_C(1.0);
            }
            t69 = t70;
        } else {
            t69 = TB_C(0.0);
        }
        const real_t t71 = structure[1] * structure[2] + structure[5] * structure[6];
        const bool t72 = t71 < TB_C(0.0);
        real_t t73;
        if (t41) {
            real_t t74;
            if (t72) {
                t74 = TB_C(1.0) / t22;
            } else {
                t74 = TB_C(1.0);
            }
            t73 = t74;
        } else {
            t73 = TB_C(0.0);
        }
        const real_t t75 = structure[1] * structure[3] + structure[5] * structure[7];
        const bool t76 = t75 < TB_C(0.0);
        real_t t77;
        if (t42) {
            real_t t78;
            if (t76) {
                t78 = TB_C(1.0) / t29;
            } else {
                t78 = TB_C(1.0);
            }
            t77 = t78;
        } else {
            t77 = TB_C(0.0);
        }
        real_t t79;
        if (t44) {
            real_t t80;
            if (t72) {
                t80 = TB_C(1.0) / t11;
            } else {
                t80 = TB_C(1.0);
            }
            t79 = t80;
        } else {
            t79 = TB_C(0.0);
        }
        const real_t t81 = tb_max(tb_max(tb_max(tb_max(t55, t64), t73), t77), t79);
        real_t t82;
        if (t48) {
            real_t t83;
            if (t76) {
                t83 = TB_C(1.0) / t19;
            } else {
                t83 = TB_C(1.0);
            }
            t82 = t83;
        } else {
            t82 = TB_C(0.0);
        }
        const real_t t84 = tb_max(tb_max(tb_max(tb_max(TB_C(0.0), t58), t73), t66), t79);
        const real_t t85 = structure[2] * structure[3] + structure[6] * structure[7];
        const bool t86 = t85 < TB_C(0.0);
        real_t t87;
        if (t45) {
            real_t t88;
            if (t86) {
                t88 = TB_C(1.0) / t31;
            } else {
                t88 = TB_C(1.0);
            }
            t87 = t88;
        } else {
            t87 = TB_C(0.0);
        }
        real_t t89;
        if (t49) {
            real_t t90;
            if (t86) {
                t90 = TB_C(1.0) / t26;
            } else {
                t90 = TB_C(1.0);
            }
            t89 = t90;
        } else {
            t89 = TB_C(0.0);
        }
        const real_t t91 = tb_max(tb_max(tb_max(tb_max(TB_C(0.0), t62), t77), t87), t69);
        tension_0 = force[0] * tb_max(t68, t69);
        tension_1 = force[0] * tb_max(t81, t82);
        tension_2 = force[0] * tb_max(tb_max(t84, t87), t89);
        tension_3 = force[0] * tb_max(tb_max(t91, t82), t89);
    } else {
        tension_0 = TB_C(0.0);
        tension_1 = TB_C(0.0);
        tension_2 = TB_C(0.0);
        tension_3 = TB_C(0.0);
    }
    const bool t92 = !t50;
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    return t92 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_reduced_matrix_tension(const real_t structure[8], const real_t wrench[2],
    real_t tension[4])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) <= TB_C(32.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(80000.0))) {
        tension[0] = TB_TENSION_MIN;
        tension[1] = TB_TENSION_MIN;
        tension[2] = TB_TENSION_MIN;
        tension[3] = TB_TENSION_MIN;
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = structure[4] + structure[5] + structure[6] + structure[7];
    const real_t t1 = wrench[1] - TB_TENSION_MIN * t0;
    const real_t t2 = structure[1] + structure[0] + structure[2] + structure[3];
    const real_t t3 = wrench[0] - TB_TENSION_MIN * t2;
    const real_t t4 = structure[1] * t1 - structure[5] * t3;
    const real_t t5 = structure[5] * structure[0] - structure[1] * structure[4];
    const real_t t6 = TB_C(1.0) / t5;
    const real_t t7 = t4 * t6;
    const real_t t8 = -t7;
    const real_t t9 = t1 * structure[0] - structure[4] * t3;
    const real_t t10 = t6 * t9;
    const real_t t11 = TB_C(16.0) * TB_EPSILON;
    const real_t t12 = t10 - t7;
    const real_t t13 = tb_min(t8, t10) + t11 * (TB_ABS(t12) + TB_C(12.0));
    const real_t t14 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const real_t t15 = TB_C(0.0) <= tb_min(t13, TB_ABS(t5) - t14) ? t12 : TB_C(1e+30);
    const real_t t16 = t1 * structure[2] - structure[6] * t3;
    const real_t t17 = structure[6] * structure[0] - structure[4] * structure[2];
    const real_t t18 = TB_C(1.0) / t17;
    const real_t t19 = t16 * t18;
    const real_t t20 = -t19;
    const real_t t21 = t9 * t18;
    const real_t t22 = t21 - t19;
    const real_t t23 = tb_min(t20, t21) + t11 * (TB_C(12.0) + TB_ABS(t22));
    const real_t t24 = TB_C(0.0) <= tb_min(t23, TB_ABS(t17) - t14) ? t22 : TB_C(1e+30);
    const real_t t25 = t1 * structure[3] - structure[7] * t3;
    const real_t t26 = structure[7] * structure[0] - structure[4] * structure[3];
    const real_t t27 = TB_C(1.0) / t26;
    const real_t t28 = t25 * t27;
    const real_t t29 = -t28;
    const real_t t30 = t9 * t27;
    const real_t t31 = t30 - t28;
    const real_t t32 = tb_min(t29, t30) + t11 * (TB_C(12.0) + TB_ABS(t31));
    const real_t t33 = TB_C(0.0) <= tb_min(t32, TB_ABS(t26) - t14) ? t31 : TB_C(1e+30);
    const real_t t34 = structure[1] * structure[6] - structure[5] * structure[2];
    const real_t t35 = TB_C(1.0) / t34;
    const real_t t36 = t16 * t35;
    const real_t t37 = -t36;
    const real_t t38 = t4 * t35;
    const real_t t39 = t38 - t36;
    const real_t t40 = tb_min(t37, t38) + t11 * (TB_C(12.0) + TB_ABS(t39));
    const real_t t41 = TB_C(0.0) <= tb_min(t40, TB_ABS(t34) - t14) ? t39 : TB_C(1e+30);
    const real_t t42 = structure[1] * structure[7] - structure[5] * structure[3];
    const real_t t43 = TB_C(1.0) / t42;
    const real_t t44 = t25 * t43;
    const real_t t45 = -t44;
    const real_t t46 = t4 * t43;
    const real_t t47 = t46 - t44;
    const real_t t48 = tb_min(t45, t46) + t11 * (TB_C(12.0) + TB_ABS(t47));
    const real_t t49 = TB_C(0.0) <= tb_min(t48, TB_ABS(t42) - t14) ? t47 : TB_C(1e+30);
    const real_t t50 = tb_min(tb_min(tb_min(tb_min(t15, t24), t33), t41), t49);
    const real_t t51 = structure[7] * structure[2] - structure[6] * structure[3];
    const real_t t52 = TB_C(1.0) / t51;
    const real_t t53 = t25 * t52;
    const real_t t54 = -t53;
    const real_t t55 = t16 * t52;
    const real_t t56 = t55 - t53;
    const real_t t57 = tb_min(t54, t55) + t11 * (TB_C(12.0) + TB_ABS(t56));
    const real_t t58 = TB_C(0.0) <= tb_min(t57, TB_ABS(t51) - t14) ? t56 : TB_C(1e+30);
    const bool t59 = tb_min(t50, t58) < TB_C(1e+30);
    real_t tension_0, tension_1, tension_2, tension_3;
    if (t59) {
        const real_t t60 = -t41;
        const real_t t61 = -t49;
        const real_t t62 = tb_max(t60, t61);
        const real_t t63 = -t58;
        const real_t t64 = -t15;
        const real_t t65 = -t24;
        const real_t t66 = tb_max(t64, t65);
        const real_t t67 = -t33;
        const bool t68 = tb_max(t62, t63) <= tb_max(t66, t67);
        real_t t69, t70, t71, t72;
        if (t68) {
            const bool t73 = t67 <= t66;
            const bool t74 = t65 <= t64;
            t69 = t73 ? (t74 ? t8 : t20) : t29;
            t70 = t73 ? (t74 ? t10 : TB_C(0.0)) : TB_C(0.0);
            t71 = t73 ? (t74 ? TB_C(0.0) : t21) : TB_C(0.0);
            t72 = t73 ? TB_C(0.0) : t30;
        } else {
            const bool t75 = t63 <= t62;
            const bool t76 = t61 <= t60;
            t69 = TB_C(0.0);
            t70 = t75 ? (t76 ? t37 : t45) : TB_C(0.0);
            t71 = t75 ? (t76 ? t38 : TB_C(0.0)) : t54;
            t72 = t75 ? (t76 ? TB_C(0.0) : t46) : t55;
        }
        tension_0 = TB_TENSION_MIN + tb_max(t69, TB_C(0.0));
        tension_1 = TB_TENSION_MIN + tb_max(t70, TB_C(0.0));
        tension_2 = TB_TENSION_MIN + tb_max(t71, TB_C(0.0));
        tension_3 = TB_TENSION_MIN + tb_max(t72, TB_C(0.0));
    } else {
        tension_0 = TB_TENSION_MIN;
        tension_1 = TB_TENSION_MIN;
        tension_2 = TB_TENSION_MIN;
        tension_3 = TB_TENSION_MIN;
    }
    const bool t77 = !t59;
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    return t77 ? TB_INFEASIBLE : TB_OK;
}

/* Refuses with a status: most is 0; least is 0; size is 0 N. */
static tb_status tb_refuse_largest_tensions_eq12_begin(tb_status status, real_t most[4],
    real_t least[1], real_t size[1])
{
    most[0] = TB_C(0.0);
    most[1] = TB_C(0.0);
    most[2] = TB_C(0.0);
    most[3] = TB_C(0.0);
    least[0] = TB_C(0.0);
    size[0] = TB_C(0.0);
    return status;
}

/* Before the first subset. */
static tb_status tb_largest_tensions_eq12_begin(const real_t structure[8], const real_t force[1],
    real_t most[4], real_t least[1], real_t size[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) <= TB_C(32.0)
          && force[0] >= TB_C(0.0) && force[0] <= TB_C(10000.0))) {
        return tb_refuse_largest_tensions_eq12_begin(TB_OUT_OF_DOMAIN, most, least, size);
    }
    const real_t t0 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const real_t t1 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t2 = t1 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t3 = TB_SQRT(t2);
    const real_t t4 = TB_COPYSIGN(t3, structure[0]);
    const real_t t5 = (structure[0] + t4) * structure[4] + structure[1] * structure[5];
    const real_t t6 = t5 + structure[2] * structure[6] + structure[3] * structure[7];
    const real_t t7 = t6 * (TB_C(1.0) / (t3 * (t3 + TB_ABS(structure[0]))));
    const real_t t8 = structure[5] - structure[1] * t7;
    const real_t t9 = structure[6] - structure[2] * t7;
    const real_t t10 = structure[7] - structure[3] * t7;
    const real_t t11 = TB_COPYSIGN(TB_SQRT(t8 * t8 + t9 * t9 + t10 * t10), t8);
    const bool t12 = !(t0 < TB_ABS(t4) && t0 < TB_ABS(t11));
    if (t12) {
        return tb_refuse_largest_tensions_eq12_begin(TB_SINGULAR, most, least, size);
    }
    most[0] = TB_C(0.0);
    most[1] = TB_C(0.0);
    most[2] = TB_C(0.0);
    most[3] = TB_C(0.0);
    least[0] = TB_C(1e+30);
    size[0] = force[0];
    return TB_OK;
}

/* One subset. */
static tb_status tb_largest_tensions_eq12_visit(const real_t chosen[2], const real_t numbers[1],
    const real_t structure[8], real_t most[4], real_t least[1])
{
    const bool t0 = numbers[0] == TB_C(0.0);
    const real_t t1 = TB_SQRT(chosen[0] * chosen[0] + chosen[1] * chosen[1]);
    const real_t t2 = TB_C(1.0) / t1;
    const real_t t3 = chosen[0] * t2;
    const real_t t4 = chosen[1] * t2;
    const real_t t5 = t0 ? TB_C(0.0) : t3 * structure[4] - t4 * structure[0];
    const real_t t6 = t0 ? TB_C(1e+30) : TB_ABS(t5);
    const real_t most_0 = tb_max(most[0], TB_C(1.0) / t6);
    const bool t7 = numbers[0] == TB_C(1.0);
    const real_t t8 = t7 ? TB_C(0.0) : t3 * structure[5] - t4 * structure[1];
    const real_t t9 = t7 ? TB_C(1e+30) : TB_ABS(t8);
    const real_t most_1 = tb_max(most[1], TB_C(1.0) / t9);
    const bool t10 = numbers[0] == TB_C(2.0);
    const real_t t11 = t10 ? TB_C(0.0) : t3 * structure[6] - t4 * structure[2];
    const real_t t12 = t10 ? TB_C(1e+30) : TB_ABS(t11);
    const real_t most_2 = tb_max(most[2], TB_C(1.0) / t12);
    const bool t13 = numbers[0] == TB_C(3.0);
    const real_t t14 = t13 ? TB_C(0.0) : t3 * structure[7] - t4 * structure[3];
    const real_t t15 = t13 ? TB_C(1e+30) : TB_ABS(t14);
    const real_t most_3 = tb_max(most[3], TB_C(1.0) / t15);
    const bool t16 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON) < t1;
    const real_t t17 = t16 ? tb_min(tb_min(tb_min(t6, t9), t12), t15) : TB_C(0.0);
    const real_t least_0 = tb_min(least[0], t17);
    most[0] = most_0;
    most[1] = most_1;
    most[2] = most_2;
    most[3] = most_3;
    least[0] = least_0;
    return TB_OK;
}

/* After the last subset. */
static tb_status tb_largest_tensions_eq12_finish(const real_t most[4], const real_t least[1],
    const real_t size[1], real_t tension[4])
{
    const real_t tension_0 = size[0] * most[0];
    const real_t tension_1 = size[0] * most[1];
    const real_t tension_2 = size[0] * most[2];
    const real_t tension_3 = size[0] * most[3];
    const bool t0 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON) < least[0];
    const bool t1 = !t0;
    if (t1) {
        tension[0] = TB_C(0.0);
        tension[1] = TB_C(0.0);
        tension[2] = TB_C(0.0);
        tension[3] = TB_C(0.0);
        return TB_SINGULAR;
    }
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    return TB_OK;
}

tb_status tb_largest_tensions_eq12(const real_t structure[8], const real_t force[1],
    real_t tension[4])
{
    static const unsigned char subsets[4][1] = {{0}, {1}, {2}, {3}};
    real_t most[4];
    real_t least[1];
    real_t size[1];
    const tb_status status = tb_largest_tensions_eq12_begin(structure, force, most, least,
        size);
    if (status != TB_OK) {
        tension[0] = TB_C(0.0);
        tension[1] = TB_C(0.0);
        tension[2] = TB_C(0.0);
        tension[3] = TB_C(0.0);
        return status;
    }
    for (int k = 0; k < 4; k++) {
        real_t chosen[2];
        real_t numbers[1];
        for (int j = 0; j < 1; j++) {
            const int number = subsets[k][j];
            for (int i = 0; i < 2; i++) {
                chosen[1 * i + j] = structure[4 * i + number];
            }
            numbers[j] = (real_t)number;
        }
        (void)tb_largest_tensions_eq12_visit(chosen, numbers, structure, most, least);
    }
    return tb_largest_tensions_eq12_finish(most, least, size, tension);
}

/* Refuses with a status: most is 0 N; size is 0 N. */
static tb_status tb_refuse_largest_tension_begin(tb_status status, real_t most[1],
    real_t size[1])
{
    most[0] = TB_C(0.0);
    size[0] = TB_C(0.0);
    return status;
}

/* Before the first subset. */
static tb_status tb_largest_tension_begin(const real_t structure[8], const real_t force[1],
    real_t most[1], real_t size[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) <= TB_C(32.0)
          && force[0] >= TB_C(0.0) && force[0] <= TB_C(10000.0))) {
        return tb_refuse_largest_tension_begin(TB_OUT_OF_DOMAIN, most, size);
    }
    const real_t t0 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const real_t t1 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t2 = t1 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t3 = TB_SQRT(t2);
    const real_t t4 = TB_COPYSIGN(t3, structure[0]);
    const real_t t5 = (structure[0] + t4) * structure[4] + structure[1] * structure[5];
    const real_t t6 = t5 + structure[2] * structure[6] + structure[3] * structure[7];
    const real_t t7 = t6 * (TB_C(1.0) / (t3 * (t3 + TB_ABS(structure[0]))));
    const real_t t8 = structure[5] - structure[1] * t7;
    const real_t t9 = structure[6] - structure[2] * t7;
    const real_t t10 = structure[7] - structure[3] * t7;
    const real_t t11 = TB_COPYSIGN(TB_SQRT(t8 * t8 + t9 * t9 + t10 * t10), t8);
    const bool t12 = !(t0 < TB_ABS(t4) && t0 < TB_ABS(t11));
    if (t12) {
        return tb_refuse_largest_tension_begin(TB_SINGULAR, most, size);
    }
    most[0] = TB_TENSION_MIN;
    size[0] = force[0];
    return TB_OK;
}

/* One subset. */
static tb_status tb_largest_tension_visit(const real_t chosen[2], const real_t numbers[1],
    const real_t structure[8], real_t most[1], const real_t size[1])
{
    const real_t t0 = TB_SQRT(chosen[0] * chosen[0] + chosen[1] * chosen[1]);
    real_t most_0;
    if (TB_C(16.0) * TB_EPSILON < t0) {
        const real_t t1 = TB_EPSILON * TB_C(64.0);
        const real_t t2 = TB_C(1.0) / t0;
        const real_t t3 = chosen[0] * t2;
        const real_t t4 = chosen[1] * t2;
        const real_t t5 = numbers[0] == TB_C(0.0) ? TB_C(0.0) : t3 * structure[4] - t4 *
            structure[0];
        const real_t t6 = numbers[0] == TB_C(1.0) ? TB_C(0.0) : t3 * structure[5] - t4 *
            structure[1];
        const real_t t7 = numbers[0] == TB_C(2.0) ? TB_C(0.0) : t3 * structure[6] - t4 *
            structure[2];
        const real_t t8 = numbers[0] == TB_C(3.0) ? TB_C(0.0) : t3 * structure[7] - t4 *
            structure[3];
        const real_t t9 = TB_ABS(t5) + TB_ABS(t6) + TB_ABS(t7) + TB_ABS(t8);
        const real_t t10 = t8 + (t7 + (t5 + t6));
        const real_t t11 = (t9 + t10) * TB_C(0.5);
        const real_t t12 = TB_C(0.5) * (t9 - t10);
        const real_t t13 = size[0] + TB_TENSION_MIN * t12;
        real_t t14;
        if (t1 < t11) {
            t14 = t13 / t11;
        } else {
            t14 = t1 < t13 ? TB_C(1e+30) : TB_C(0.0);
        }
        const real_t t15 = size[0] + TB_TENSION_MIN * t11;
        real_t t16;
        if (t1 < t12) {
            t16 = t15 / t12;
        } else {
            t16 = t1 < t15 ? TB_C(1e+30) : TB_C(0.0);
        }
        most_0 = tb_max(most[0], tb_max(t14, t16));
    } else {
        most_0 = most[0];
    }
    most[0] = most_0;
    return TB_OK;
}

/* After the last subset. */
static tb_status tb_largest_tension_finish(const real_t most[1], real_t tension[1])
{
    const bool t0 = most[0] < TB_C(1e+30);
    const real_t tension_0 = t0 ? most[0] : TB_C(0.0);
    const bool t1 = !t0;
    tension[0] = tension_0;
    return t1 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_largest_tension(const real_t structure[8], const real_t force[1],
    real_t tension[1])
{
    static const unsigned char subsets[4][1] = {{0}, {1}, {2}, {3}};
    real_t most[1];
    real_t size[1];
    const tb_status status = tb_largest_tension_begin(structure, force, most, size);
    if (status != TB_OK) {
        tension[0] = TB_C(0.0);
        return status;
    }
    for (int k = 0; k < 4; k++) {
        real_t chosen[2];
        real_t numbers[1];
        for (int j = 0; j < 1; j++) {
            const int number = subsets[k][j];
            for (int i = 0; i < 2; i++) {
                chosen[1 * i + j] = structure[4 * i + number];
            }
            numbers[j] = (real_t)number;
        }
        (void)tb_largest_tension_visit(chosen, numbers, structure, most, size);
    }
    return tb_largest_tension_finish(most, tension);
}

