/* Regenerate: turnbuckle generate machines/brau_square.toml --out <this folder>
 * Machine 166f8b7fcb339437, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_comparison.h"
#include "tb_machine.h"

/* Refuses with a status: tension is 0 N. */
static tb_status tb_refuse_kernel_tension(tb_status status, real_t tension[4])
{
    tension[0] = TB_C(0.0);
    tension[1] = TB_C(0.0);
    tension[2] = TB_C(0.0);
    tension[3] = TB_C(0.0);
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
    const real_t t23 = structure[3] * t22;
    const real_t t24 = t18 - t23;
    const real_t t25 = TB_C(3.0) * TB_EPSILON * (TB_ABS(wrench[0]) + TB_ABS(wrench[1]));
    const real_t t26 = TB_ABS(t3);
    const real_t t27 = TB_ABS(t12);
    const real_t t28 = TB_C(1.0) / tb_min(t26, t27);
    const real_t t29 = t25 * t28;
    const real_t t30 = structure[2] * t22;
    const real_t t31 = t20 - t30;
    const real_t t32 = t29 + t31;
    const real_t t33 = structure[1] * t22;
    const real_t t34 = t19 - t33;
    const real_t t35 = t29 + t34;
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
    const real_t t54 = t53 + TB_C(1000000000000.0);
    const real_t t55 = tb_min(tb_max(TB_C(0.0), t53), t54);
    const real_t t56 = t29 < TB_ABS(t55) ? t55 : TB_C(0.0);
    const real_t t57 = t56 / tb_max(t42 * t42 + t50 * t50, TB_EPSILON);
    const real_t t58 = t52 * t57;
    const real_t t59 = TB_C(1000000000000.0) - t34;
    const real_t t60 = t29 + t59;
    const real_t t61 = tb_max(-(t35 + t58), t58 - t60);
    const bool t62 = TB_C(0.0) < t61;
    const real_t t63 = t47 + structure[2] * t49;
    const real_t t64 = t37 - structure[2] * t41;
    const real_t t65 = t51 * t63 - t43 * t64;
    const real_t t66 = t43 * t63 + t51 * t64;
    const real_t t67 = TB_EPSILON * TB_C(16.0);
    const real_t t68 = t53 - t29;
    const real_t t69 = t29 + t54;
    const real_t t70 = t50 * t63 - t42 * t64;
    const real_t t71 = t39 + structure[3] * t41;
    const real_t t72 = t45 - structure[3] * t49;
    const real_t t73 = t43 * t71 - t51 * t72;
    const real_t t74 = t43 * t72 + t51 * t71;
    const real_t t75 = t42 * t71 - t50 * t72;
    const real_t t76 = t29 * TB_C(2.0);
    const real_t t77 = t29 * TB_C(1024.0);
    real_t t78, t79, t80, t81, t82;
    if (t62) {
        const real_t t83 = tb_min(tb_max(t58, t33 - t19), t59);
        const real_t t84 = TB_C(1.0) / tb_max(t43 * t43 + t51 * t51, TB_EPSILON);
        const real_t t85 = t83 * t84;
        const real_t t86 = t43 * t50 - t42 * t51;
        const bool t87 = TB_ABS(t86) <= t67;
        const real_t t88 = t52 * t85;
        const real_t t89 = TB_C(1.0) / t86;
        real_t t90, t91;
        if (t87) {
            t90 = -TB_C(1000000000000.0);
            t91 = TB_C(1000000000000.0);
        } else {
            const real_t t92 = (t68 - t88) * t89;
            const real_t t93 = t89 * (t69 - t88);
            t90 = tb_min(t92, t93);
            t91 = tb_max(t92, t93);
        }
        const real_t t94 = tb_min(tb_max(TB_C(0.0), t90), t91);
        const real_t t95 = TB_C(0.0) < TB_ABS(t94) ? t94 * (t52 * t89) : TB_C(0.0);
        const real_t t96 = t58 < t83 ? t95 - t85 : t85 - t95;
        real_t t97;
        if (TB_C(0.0) < t96) {
            const real_t t98 = t87 ? TB_C(0.0) : t76 * TB_ABS(t89);
            const real_t t99 = t90 + t98 < t91 - t98 && t77 < t61 ? t96 : TB_C(0.0);
            t97 = t99;
        } else {
            t97 = TB_C(0.0);
        }
        t78 = t65 * t85 + t66 * t94;
        t79 = t85 * t73 - t94 * t74;
        t80 = t97;
        t81 = t88 + t86 * t94;
        t82 = t83;
    } else {
        t78 = t57 * t70;
        t79 = t57 * t75;
        t80 = TB_C(0.0);
        t81 = t56;
        t82 = t58;
    }
    const real_t t100 = TB_C(1000000000000.0) - t31;
    const real_t t101 = t29 + t100;
    const real_t t102 = tb_max(-(t32 + t78), t78 - t101);
    const bool t103 = TB_C(0.0) < t102;
    const real_t t104 = t64 * t72;
    const real_t t105 = t63 * t71;
    const real_t t106 = t64 * t71 + t63 * t72;
    real_t t107, t108, t109, t110, t111;
    if (t103) {
        const bool t112 = TB_ABS(t66) <= t67;
        const real_t t113 = tb_min(tb_max(t78, t30 - t20), t100);
        const real_t t114 = TB_C(1.0) / tb_max(t64 * t64 + t63 * t63, TB_EPSILON);
        const real_t t115 = t113 * t114;
        const real_t t116 = t65 * t115;
        const real_t t117 = TB_C(1.0) / t66;
        real_t t118, t119;
        if (t112) {
            t118 = -TB_C(1000000000000.0);
            t119 = TB_C(1000000000000.0);
        } else {
            const real_t t120 = (t35 + t116) * t117;
            const real_t t121 = -(t117 * (t60 - t116));
            t118 = tb_min(t120, t121);
            t119 = tb_max(t120, t121);
        }
        const real_t t122 = t50 * t64 + t42 * t63;
        const bool t123 = TB_ABS(t122) <= t67;
        const real_t t124 = t70 * t115;
        const real_t t125 = TB_C(1.0) / t122;
        real_t t126, t127;
        if (t123) {
            t126 = -TB_C(1000000000000.0);
            t127 = TB_C(1000000000000.0);
        } else {
            const real_t t128 = -((t68 - t124) * t125);
            const real_t t129 = -(t125 * (t69 - t124));
            t126 = tb_min(t128, t129);
            t127 = tb_max(t128, t129);
        }
        const real_t t130 = tb_min(tb_max(TB_C(0.0), tb_max(t118, t126)), tb_min(t119, t127));
        real_t t131;
        if (TB_C(0.0) < TB_ABS(t130)) {
            const real_t t132 = -(t65 * t117);
            const real_t t133 = -(t70 * t125);
            const real_t t134 = TB_C(0.0) < t130 ? (t126 < t118 ? t132 : t133) : (t119 < t127 ?
                t132 : t133);
            t131 = t130 * t134;
        } else {
            t131 = TB_C(0.0);
        }
        const real_t t135 = t78 < t113 ? t131 - t115 : t115 - t131;
        real_t t136;
        if (TB_C(0.0) < t135) {
            real_t t137;
            if (t123) {
                t137 = TB_C(0.0);
            } else {
                t137 = t76 * TB_ABS(TB_C(1.0) / -t122);
            }
            real_t t138;
            if (t112) {
                t138 = TB_C(0.0);
            } else {
                t138 = t76 * TB_ABS(TB_C(1.0) / -t66);
            }
            const bool t139 = tb_max(t126 + t137, t118 + t138) < tb_min(t127 - t137, t119 -
                t138);
            t136 = t139 && t77 < t102 ? t135 : TB_C(0.0);
        } else {
            t136 = TB_C(0.0);
        }
        t107 = (t104 - t105) * t130 - t115 * t106;
        t108 = t136;
        t109 = t124 - t122 * t130;
        t110 = t116 - t66 * t130;
        t111 = t113;
    } else {
        t107 = t79;
        t108 = t80;
        t109 = t81;
        t110 = t82;
        t111 = t78;
    }
    const real_t t140 = TB_C(1000000000000.0) - t24;
    const real_t t141 = tb_max(-(t24 + t29 + t107), t107 - (t29 + t140));
    const bool t142 = TB_C(0.0) < t141;
    real_t t143, t144, t145, t146, t147;
    if (t142) {
        const real_t t148 = tb_min(tb_max(t107, t23 - t18), t140);
        const real_t t149 = TB_C(1.0) / tb_max(t71 * t71 + t72 * t72, TB_EPSILON);
        const real_t t150 = t148 * t149;
        const real_t t151 = t105 - t104;
        const bool t152 = TB_ABS(t151) <= t67;
        const real_t t153 = t106 * t150;
        const real_t t154 = TB_C(1.0) / t151;
        real_t t155, t156;
        if (t152) {
            t155 = -TB_C(1000000000000.0);
            t156 = TB_C(1000000000000.0);
        } else {
            const real_t t157 = (t153 - t32) * t154;
            const real_t t158 = t154 * (t101 + t153);
            t155 = tb_min(t157, t158);
            t156 = tb_max(t157, t158);
        }
        const bool t159 = TB_ABS(t74) <= t67;
        const real_t t160 = t73 * t150;
        const real_t t161 = TB_C(1.0) / t74;
        real_t t162, t163;
        if (t159) {
            t162 = -TB_C(1000000000000.0);
            t163 = TB_C(1000000000000.0);
        } else {
            const real_t t164 = -((t35 + t160) * t161);
            const real_t t165 = t161 * (t60 - t160);
            t162 = tb_min(t164, t165);
            t163 = tb_max(t164, t165);
        }
        const real_t t166 = t50 * t71 + t42 * t72;
        const bool t167 = TB_ABS(t166) <= t67;
        const real_t t168 = t75 * t150;
        const real_t t169 = TB_C(1.0) / t166;
        real_t t170, t171;
        if (t167) {
            t170 = -TB_C(1000000000000.0);
            t171 = TB_C(1000000000000.0);
        } else {
            const real_t t172 = (t68 - t168) * t169;
            const real_t t173 = t169 * (t69 - t168);
            t170 = tb_min(t172, t173);
            t171 = tb_max(t172, t173);
        }
        const real_t t174 = tb_max(t162, t170);
        const real_t t175 = tb_min(t163, t171);
        const real_t t176 = tb_min(tb_max(TB_C(0.0), tb_max(t155, t174)), tb_min(t156, t175));
        real_t t177;
        if (TB_C(0.0) < TB_ABS(t176)) {
            const real_t t178 = -(t106 * t154);
            const real_t t179 = t73 * t161;
            const real_t t180 = t75 * t169;
            real_t t181;
            if (TB_C(0.0) < t176) {
                t181 = t174 < t155 ? t178 : (t170 < t162 ? t179 : t180);
            } else {
                t181 = t156 < t175 ? t178 : (t163 < t171 ? t179 : t180);
            }
            t177 = t176 * t181;
        } else {
            t177 = TB_C(0.0);
        }
        const real_t t182 = t107 < t148 ? t177 - t150 : t150 - t177;
        real_t t183;
        if (TB_C(0.0) < t182) {
            const real_t t184 = t167 ? TB_C(0.0) : t76 * TB_ABS(t169);
            const real_t t185 = t159 ? TB_C(0.0) : t76 * TB_ABS(t161);
            const real_t t186 = t152 ? TB_C(0.0) : t76 * TB_ABS(t154);
            const real_t t187 = tb_max(tb_max(t170 + t184, t162 + t185), t155 + t186);
            const real_t t188 = tb_min(tb_min(t171 - t184, t163 - t185), t156 - t186);
            t183 = t187 < t188 && t77 < t141 ? t182 : TB_C(0.0);
        } else {
            t183 = TB_C(0.0);
        }
        t143 = t183;
        t144 = t168 + t166 * t176;
        t145 = t160 + t74 * t176;
        t146 = t151 * t176 - t153;
        t147 = t148;
    } else {
        t143 = t108;
        t144 = t109;
        t145 = t110;
        t146 = t111;
        t147 = t107;
    }
    const real_t t189 = tb_min(tb_max(t144 - t53, TB_C(0.0)), TB_C(1000000000000.0));
    const real_t t190 = tb_min(tb_max(t34 + t145, TB_C(0.0)), TB_C(1000000000000.0));
    const real_t t191 = tb_min(tb_max(t31 + t146, TB_C(0.0)), TB_C(1000000000000.0));
    const real_t t192 = structure[0] * t189 + structure[1] * t190 + structure[2] * t191;
    const real_t t193 = tb_min(tb_max(t24 + t147, TB_C(0.0)), TB_C(1000000000000.0));
    const real_t t194 = tb_max(t143, TB_ABS(t192 + structure[3] * t193 - wrench[0]));
    const real_t t195 = structure[4] * t189 + structure[5] * t190 + structure[6] * t191;
    const real_t t196 = tb_max(t194, TB_ABS(t195 + structure[7] * t193 - wrench[1]));
    const real_t t197 = TB_EPSILON * TB_C(128.0) * tb_max(tb_max(tb_max(t189, t190), t191),
        t193);
    const bool t198 = t196 <= tb_min(t28 * t197, TB_C(0.01));
    const real_t tension_0 = t198 ? t189 : TB_C(0.0);
    const real_t tension_1 = t198 ? t190 : TB_C(0.0);
    const real_t tension_2 = t198 ? t191 : TB_C(0.0);
    const real_t tension_3 = t198 ? t193 : TB_C(0.0);
    const real_t t199 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t200 = !(t199 < t26 && t199 < t27);
    const bool t201 = !t198;
    if (t200) {
        return tb_refuse_kernel_tension(TB_SINGULAR, tension);
    }
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    return t201 ? TB_INFEASIBLE : TB_OK;
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
        tension[0] = TB_C(0.0);
        tension[1] = TB_C(0.0);
        tension[2] = TB_C(0.0);
        tension[3] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = structure[1] * wrench[1] - structure[5] * wrench[0];
    const real_t t1 = structure[5] * structure[0] - structure[1] * structure[4];
    const real_t t2 = TB_C(1.0) / t1;
    const real_t t3 = t0 * t2;
    const real_t t4 = -t3;
    const real_t t5 = wrench[1] * structure[0] - wrench[0] * structure[4];
    const real_t t6 = t2 * t5;
    const real_t t7 = TB_C(16.0) * TB_EPSILON;
    const real_t t8 = t6 - t3;
    const real_t t9 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const real_t t10 = tb_min(tb_min(t4, t6) + t7 * TB_ABS(t8), TB_ABS(t1) - t9);
    const real_t t11 = TB_C(0.0) <= t10 ? t8 : TB_C(1e+30);
    const real_t t12 = wrench[1] * structure[2] - wrench[0] * structure[6];
    const real_t t13 = structure[0] * structure[6] - structure[4] * structure[2];
    const real_t t14 = TB_C(1.0) / t13;
    const real_t t15 = t12 * t14;
    const real_t t16 = -t15;
    const real_t t17 = t5 * t14;
    const real_t t18 = t17 - t15;
    const real_t t19 = tb_min(tb_min(t16, t17) + t7 * TB_ABS(t18), TB_ABS(t13) - t9);
    const real_t t20 = TB_C(0.0) <= t19 ? t18 : TB_C(1e+30);
    const real_t t21 = wrench[1] * structure[3] - wrench[0] * structure[7];
    const real_t t22 = structure[0] * structure[7] - structure[4] * structure[3];
    const real_t t23 = TB_C(1.0) / t22;
    const real_t t24 = t21 * t23;
    const real_t t25 = -t24;
    const real_t t26 = t5 * t23;
    const real_t t27 = t26 - t24;
    const real_t t28 = tb_min(tb_min(t25, t26) + t7 * TB_ABS(t27), TB_ABS(t22) - t9);
    const real_t t29 = TB_C(0.0) <= t28 ? t27 : TB_C(1e+30);
    const real_t t30 = structure[1] * structure[6] - structure[5] * structure[2];
    const real_t t31 = TB_C(1.0) / t30;
    const real_t t32 = t12 * t31;
    const real_t t33 = -t32;
    const real_t t34 = t0 * t31;
    const real_t t35 = t34 - t32;
    const real_t t36 = tb_min(tb_min(t33, t34) + t7 * TB_ABS(t35), TB_ABS(t30) - t9);
    const real_t t37 = TB_C(0.0) <= t36 ? t35 : TB_C(1e+30);
    const real_t t38 = structure[1] * structure[7] - structure[5] * structure[3];
    const real_t t39 = TB_C(1.0) / t38;
    const real_t t40 = t21 * t39;
    const real_t t41 = -t40;
    const real_t t42 = t0 * t39;
    const real_t t43 = t42 - t40;
    const real_t t44 = tb_min(tb_min(t41, t42) + t7 * TB_ABS(t43), TB_ABS(t38) - t9);
    const real_t t45 = TB_C(0.0) <= t44 ? t43 : TB_C(1e+30);
    const real_t t46 = tb_min(tb_min(tb_min(tb_min(t11, t20), t29), t37), t45);
    const real_t t47 = structure[2] * structure[7] - structure[6] * structure[3];
    const real_t t48 = TB_C(1.0) / t47;
    const real_t t49 = t21 * t48;
    const real_t t50 = -t49;
    const real_t t51 = t12 * t48;
    const real_t t52 = t51 - t49;
    const real_t t53 = tb_min(tb_min(t50, t51) + t7 * TB_ABS(t52), TB_ABS(t47) - t9);
    const real_t t54 = TB_C(0.0) <= t53 ? t52 : TB_C(1e+30);
    const bool t55 = tb_min(t46, t54) < TB_C(1e+30);
    real_t tension_0, tension_1, tension_2, tension_3;
    if (t55) {
        const real_t t56 = -t37;
        const real_t t57 = -t45;
        const real_t t58 = tb_max(t56, t57);
        const real_t t59 = -t54;
        const real_t t60 = -t11;
        const real_t t61 = -t20;
        const real_t t62 = tb_max(t60, t61);
        const real_t t63 = -t29;
        const bool t64 = tb_max(t58, t59) <= tb_max(t62, t63);
        real_t t65, t66, t67, t68;
        if (t64) {
            const bool t69 = t63 <= t62;
            const bool t70 = t61 <= t60;
            t65 = t69 ? (t70 ? t4 : t16) : t25;
            t66 = t69 ? (t70 ? t6 : TB_C(0.0)) : TB_C(0.0);
            t67 = t69 ? (t70 ? TB_C(0.0) : t17) : TB_C(0.0);
            t68 = t69 ? TB_C(0.0) : t26;
        } else {
            const bool t71 = t59 <= t58;
            const bool t72 = t57 <= t56;
            t65 = TB_C(0.0);
            t66 = t71 ? (t72 ? t33 : t41) : TB_C(0.0);
            t67 = t71 ? (t72 ? t34 : TB_C(0.0)) : t50;
            t68 = t71 ? (t72 ? TB_C(0.0) : t42) : t51;
        }
        tension_0 = tb_max(t65, TB_C(0.0));
        tension_1 = tb_max(t66, TB_C(0.0));
        tension_2 = tb_max(t67, TB_C(0.0));
        tension_3 = tb_max(t68, TB_C(0.0));
    } else {
        tension_0 = TB_C(0.0);
        tension_1 = TB_C(0.0);
        tension_2 = TB_C(0.0);
        tension_3 = TB_C(0.0);
    }
    const bool t73 = !t55;
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    return t73 ? TB_INFEASIBLE : TB_OK;
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
    most[0] = TB_C(0.0);
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
        const real_t t12 = t1 < size[0] ? TB_C(1e+30) : TB_C(0.0);
        real_t t13;
        if (t1 < t11) {
            t13 = size[0] / t11;
        } else {
            t13 = t12;
        }
        const real_t t14 = TB_C(0.5) * (t9 - t10);
        real_t t15;
        if (t1 < t14) {
            t15 = size[0] / t14;
        } else {
            t15 = t12;
        }
        most_0 = tb_max(most[0], tb_max(t13, t15));
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

