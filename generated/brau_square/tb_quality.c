/* Regenerate: turnbuckle generate machines/brau_square.toml --out <this folder>
 * Machine 166f8b7fcb339437, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_quality.h"
#include "tb_machine.h"

/* Refuses with a status: tension is 0 N. */
static tb_status tb_refuse_zero_wrench_tension(tb_status status, real_t tension[4])
{
    tension[0] = TB_C(0.0);
    tension[1] = TB_C(0.0);
    tension[2] = TB_C(0.0);
    tension[3] = TB_C(0.0);
    return status;
}

tb_status tb_zero_wrench_tension(const real_t pose[2], const real_t rails[1], real_t tension[4])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0))) {
        return tb_refuse_zero_wrench_tension(TB_OUT_OF_DOMAIN, tension);
    }
    const real_t t0 = pose[0] * pose[0];
    const real_t t1 = pose[1] * pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 + t1);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t t3 = pose[0] * t2;
    const real_t t4 = TB_FRAME - pose[0];
    const real_t t5 = t4 * t4;
    const real_t length_1 = TB_SQRT(t1 + t5);
    const real_t t6 = TB_C(1.0) / length_1;
    const real_t t7 = pose[1] * t6;
    const real_t t8 = pose[1] * t2;
    const real_t t9 = t4 * t6;
    const real_t t10 = TB_ABS(t3 * t7 + t8 * t9);
    const real_t t11 = TB_FRAME - pose[1];
    const real_t t12 = t11 * t11;
    const real_t length_2 = TB_SQRT(t5 + t12);
    const real_t t13 = TB_C(1.0) / length_2;
    const real_t t14 = t4 * t13;
    const real_t t15 = t11 * t13;
    const real_t t16 = TB_ABS(t8 * t14 - t3 * t15);
    const real_t length_3 = TB_SQRT(t0 + t12);
    const real_t t17 = TB_C(1.0) / length_3;
    const real_t t18 = t11 * t17;
    const real_t t19 = pose[0] * t17;
    const real_t t20 = TB_ABS(t3 * t18 + t8 * t19);
    const real_t t21 = TB_C(5.0) * (t14 + (t9 - t3) - t19);
    const real_t t22 = TB_C(5.0) * (t18 + (t15 - (t7 + t8)));
    const real_t t23 = TB_C(5.0) * (t10 + t16 + t20) - TB_ABS(t8 * t21 - t3 * t22);
    const real_t t24 = TB_ABS(t9 * t15 + t7 * t14);
    const real_t t25 = TB_ABS(t9 * t18 - t7 * t19);
    const real_t t26 = TB_C(5.0) * (t10 + t24 + t25) - TB_ABS(t9 * t22 + t7 * t21);
    const real_t t27 = TB_ABS(t14 * t18 + t15 * t19);
    const real_t t28 = TB_C(5.0) * (t16 + t24 + t27) - TB_ABS(t14 * t22 - t15 * t21);
    const real_t t29 = TB_C(5.0) * (t27 + (t20 + t25)) - TB_ABS(t19 * t22 + t18 * t21);
    const bool t30 = TB_C(0.0) <= tb_min(tb_min(tb_min(t23, t26), t28), t29);
    const real_t t31 = TB_SQRT(t3 * t3 + t9 * t9 + t14 * t14 + t19 * t19);
    const real_t t32 = TB_COPYSIGN(t31, -t3);
    const real_t t33 = TB_ABS(t32);
    const real_t t34 = t32 - t3;
    const real_t t35 = TB_C(1.0) / (t31 * (t31 + TB_ABS(t3)));
    const real_t t36 = (t14 * t15 - (t8 * t34 + t7 * t9) - t18 * t19) * t35;
    const real_t t37 = t7 + t9 * t36;
    const real_t t38 = t15 - t14 * t36;
    const real_t t39 = t18 + t19 * t36;
    const real_t t40 = TB_SQRT(t37 * t37 + t38 * t38 + t39 * t39);
    const real_t t41 = TB_COPYSIGN(t40, -t37);
    const real_t t42 = TB_ABS(t41);
    const real_t t43 = TB_C(1.0) / tb_min(t33, t42);
    const real_t t44 = TB_C(30.0) * TB_EPSILON * t43;
    const real_t t45 = t44 + TB_TENSION_MAX;
    const real_t t46 = tb_max(-t44, -t45);
    const bool t47 = TB_C(0.0) < t46;
    const real_t t48 = TB_C(1.0) / (t40 * (t40 + TB_ABS(t37)));
    const real_t t49 = t38 * t48;
    const real_t t50 = t41 - t37;
    const real_t t51 = t49 * t50;
    const real_t t52 = TB_C(1.0) - t38 * t49;
    const real_t t53 = t39 * t49;
    const real_t t54 = t35 * (t14 * t52 - t9 * t51 + t19 * t53);
    const real_t t55 = t51 + t9 * t54;
    const real_t t56 = t39 * t48;
    const real_t t57 = t50 * t56;
    const real_t t58 = t38 * t56;
    const real_t t59 = TB_C(1.0) - t39 * t56;
    const real_t t60 = t35 * (t9 * t57 + t14 * t58 + t19 * t59);
    const real_t t61 = t14 * t60 - t58;
    const real_t t62 = t9 * t60 - t57;
    const real_t t63 = t52 - t14 * t54;
    const real_t t64 = t55 * t61 + t62 * t63;
    const real_t t65 = t34 * t54;
    const real_t t66 = t34 * t60;
    const real_t t67 = TB_EPSILON * TB_C(16.0);
    const real_t t68 = t59 - t19 * t60;
    const real_t t69 = t19 * t54 - t53;
    const real_t t70 = t55 * t68 + t62 * t69;
    const real_t t71 = t44 * TB_C(2.0);
    const real_t t72 = t44 * TB_C(1024.0);
    real_t t73, t74, t75, t76;
    if (t47) {
        const real_t t77 = t62 * t65 - t55 * t66;
        const bool t78 = TB_ABS(t77) <= t67;
        const real_t t79 = TB_C(1.0) / t77;
        const real_t t80 = -(t44 * t79);
        const real_t t81 = t45 * t79;
        const real_t t82 = t78 ? -TB_C(1000000000000.0) : tb_min(t80, t81);
        const real_t t83 = t78 ? TB_C(1000000000000.0) : tb_max(t80, t81);
        const real_t t84 = tb_min(tb_max(TB_C(0.0), t82), t83);
        const real_t t85 = TB_C(0.0) < TB_ABS(t84) ? t84 * (t79 * (t55 * t65 + t62 * t66)) :
            TB_C(0.0);
        const real_t t86 = -t85;
        real_t t87;
        if (TB_C(0.0) < t86) {
            const real_t t88 = t78 ? TB_C(0.0) : t71 * TB_ABS(t79);
            const real_t t89 = t82 + t88 < t83 - t88 && t72 < t46 ? t86 : TB_C(0.0);
            t87 = t89;
        } else {
            t87 = TB_C(0.0);
        }
        t73 = -(t64 * t84);
        t74 = -(t84 * t70);
        t75 = t77 * t84;
        t76 = t87;
    } else {
        t73 = TB_C(0.0);
        t74 = TB_C(0.0);
        t75 = TB_C(0.0);
        t76 = TB_C(0.0);
    }
    const real_t t90 = tb_max(-(t44 + t73), t73 - t45);
    const bool t91 = TB_C(0.0) < t90;
    const real_t t92 = t63 * t69 + t61 * t68;
    const real_t t93 = t63 * t68;
    const real_t t94 = t61 * t69;
    real_t t95, t96, t97, t98, t99;
    if (t91) {
        const real_t t100 = tb_min(tb_max(t73, TB_C(0.0)), TB_TENSION_MAX);
        const real_t t101 = TB_C(1.0) / tb_max(t63 * t63 + t61 * t61, TB_EPSILON);
        const real_t t102 = t100 * t101;
        const bool t103 = TB_ABS(t64) <= t67;
        const real_t t104 = t61 * t62 - t55 * t63;
        const real_t t105 = t102 * t104;
        const real_t t106 = TB_C(1.0) / t64;
        real_t t107, t108;
        if (t103) {
            t107 = -TB_C(1000000000000.0);
            t108 = TB_C(1000000000000.0);
        } else {
            const real_t t109 = -((t44 + t105) * t106);
            const real_t t110 = t106 * (t45 - t105);
            t107 = tb_min(t109, t110);
            t108 = tb_max(t109, t110);
        }
        const real_t t111 = t63 * t66 + t61 * t65;
        const bool t112 = TB_ABS(t111) <= t67;
        const real_t t113 = t61 * t66 - t63 * t65;
        const real_t t114 = t102 * t113;
        const real_t t115 = TB_C(1.0) / t111;
        real_t t116, t117;
        if (t112) {
            t116 = -TB_C(1000000000000.0);
            t117 = TB_C(1000000000000.0);
        } else {
            const real_t t118 = -((t44 + t114) * t115);
            const real_t t119 = t115 * (t45 - t114);
            t116 = tb_min(t118, t119);
            t117 = tb_max(t118, t119);
        }
        const real_t t120 = tb_min(tb_max(TB_C(0.0), tb_max(t107, t116)), tb_min(t108, t117));
        real_t t121;
        if (TB_C(0.0) < TB_ABS(t120)) {
            const real_t t122 = t104 * t106;
            const real_t t123 = t113 * t115;
            const real_t t124 = TB_C(0.0) < t120 ? (t116 < t107 ? t122 : t123) : (t108 < t117 ?
                t122 : t123);
            t121 = t120 * t124;
        } else {
            t121 = TB_C(0.0);
        }
        const real_t t125 = t73 < t100 ? t121 - t102 : t102 - t121;
        real_t t126;
        if (TB_C(0.0) < t125) {
            const real_t t127 = t112 ? TB_C(0.0) : t71 * TB_ABS(t115);
            const real_t t128 = t103 ? TB_C(0.0) : t71 * TB_ABS(t106);
            const bool t129 = tb_max(t116 + t127, t107 + t128) < tb_min(t117 - t127, t108 -
                t128);
            t126 = t129 && t72 < t90 ? t125 : TB_C(0.0);
        } else {
            t126 = TB_C(0.0);
        }
        t95 = t92 * t102 + (t93 - t94) * t120;
        t96 = t114 + t111 * t120;
        t97 = t105 + t64 * t120;
        t98 = t100;
        t99 = t126;
    } else {
        t95 = t74;
        t96 = t75;
        t97 = TB_C(0.0);
        t98 = t73;
        t99 = t76;
    }
    const real_t t130 = tb_max(-(t44 + t95), t95 - t45);
    const bool t131 = TB_C(0.0) < t130;
    real_t t132, t133, t134, t135, t136;
    if (t131) {
        const real_t t137 = t66 * t68 - t65 * t69;
        const real_t t138 = tb_min(tb_max(t95, TB_C(0.0)), TB_TENSION_MAX);
        const real_t t139 = TB_C(1.0) / tb_max(t69 * t69 + t68 * t68, TB_EPSILON);
        const real_t t140 = t138 * t139;
        const real_t t141 = t137 * t140;
        const real_t t142 = t66 * t69 + t65 * t68;
        const real_t t143 = t94 - t93;
        const bool t144 = TB_ABS(t143) <= t67;
        const real_t t145 = t92 * t140;
        const real_t t146 = TB_C(1.0) / t143;
        real_t t147, t148;
        if (t144) {
            t147 = -TB_C(1000000000000.0);
            t148 = TB_C(1000000000000.0);
        } else {
            const real_t t149 = -((t44 + t145) * t146);
            const real_t t150 = t146 * (t45 - t145);
            t147 = tb_min(t149, t150);
            t148 = tb_max(t149, t150);
        }
        const bool t151 = TB_ABS(t70) <= t67;
        const real_t t152 = t62 * t68 - t55 * t69;
        const real_t t153 = t140 * t152;
        const real_t t154 = TB_C(1.0) / t70;
        real_t t155, t156;
        if (t151) {
            t155 = -TB_C(1000000000000.0);
            t156 = TB_C(1000000000000.0);
        } else {
            const real_t t157 = -((t44 + t153) * t154);
            const real_t t158 = t154 * (t45 - t153);
            t155 = tb_min(t157, t158);
            t156 = tb_max(t157, t158);
        }
        const bool t159 = TB_ABS(t142) <= t67;
        const real_t t160 = TB_C(1.0) / t142;
        real_t t161, t162;
        if (t159) {
            t161 = -TB_C(1000000000000.0);
            t162 = TB_C(1000000000000.0);
        } else {
            const real_t t163 = -((t44 + t141) * t160);
            const real_t t164 = t160 * (t45 - t141);
            t161 = tb_min(t163, t164);
            t162 = tb_max(t163, t164);
        }
        const real_t t165 = tb_max(t155, t161);
        const real_t t166 = tb_min(t156, t162);
        const real_t t167 = tb_min(tb_max(TB_C(0.0), tb_max(t147, t165)), tb_min(t148, t166));
        real_t t168;
        if (TB_C(0.0) < TB_ABS(t167)) {
            const real_t t169 = t92 * t146;
            const real_t t170 = t152 * t154;
            const real_t t171 = t137 * t160;
            real_t t172;
            if (TB_C(0.0) < t167) {
                t172 = t165 < t147 ? t169 : (t161 < t155 ? t170 : t171);
            } else {
                t172 = t148 < t166 ? t169 : (t156 < t162 ? t170 : t171);
            }
            t168 = t167 * t172;
        } else {
            t168 = TB_C(0.0);
        }
        const real_t t173 = t95 < t138 ? t168 - t140 : t140 - t168;
        real_t t174;
        if (TB_C(0.0) < t173) {
            const real_t t175 = t159 ? TB_C(0.0) : t71 * TB_ABS(t160);
            const real_t t176 = t151 ? TB_C(0.0) : t71 * TB_ABS(t154);
            const real_t t177 = t144 ? TB_C(0.0) : t71 * TB_ABS(t146);
            const real_t t178 = tb_max(tb_max(t161 + t175, t155 + t176), t147 + t177);
            const real_t t179 = tb_min(tb_min(t162 - t175, t156 - t176), t148 - t177);
            t174 = t178 < t179 && t72 < t130 ? t173 : TB_C(0.0);
        } else {
            t174 = TB_C(0.0);
        }
        t132 = t141 + t142 * t167;
        t133 = t153 + t70 * t167;
        t134 = t145 + t143 * t167;
        t135 = t138;
        t136 = t174;
    } else {
        t132 = t96;
        t133 = t97;
        t134 = t98;
        t135 = t95;
        t136 = t99;
    }
    const real_t t180 = tb_min(tb_max(t132, TB_C(0.0)), TB_TENSION_MAX);
    const real_t tension_0 = t30 ? t180 : TB_C(0.0);
    const real_t t181 = tb_min(tb_max(t133, TB_C(0.0)), TB_TENSION_MAX);
    const real_t tension_1 = t30 ? t181 : TB_C(0.0);
    const real_t t182 = tb_min(tb_max(t134, TB_C(0.0)), TB_TENSION_MAX);
    const real_t tension_2 = t30 ? t182 : TB_C(0.0);
    const real_t t183 = tb_min(tb_max(t135, TB_C(0.0)), TB_TENSION_MAX);
    const real_t tension_3 = t30 ? t183 : TB_C(0.0);
    const bool t184 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t185 = t184 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t186 = !t185;
    const real_t t187 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t188 = !(t187 < t33 && t187 < t42);
    const bool t189 = !t30;
    const real_t t190 = TB_ABS(t9 * t181 - t3 * t180 + t14 * t182 - t19 * t183);
    const real_t t191 = t15 * t182 - (t8 * t180 + t7 * t181) + t18 * t183;
    const bool t192 = tb_max(tb_max(t136, t190), TB_ABS(t191)) <= t43 * (TB_EPSILON *
        TB_C(1280.0));
    const bool t193 = !(t189 || t192);
    if (t186 || t188) {
        return tb_refuse_zero_wrench_tension(TB_SINGULAR, tension);
    }
    if (t193) {
        return tb_refuse_zero_wrench_tension(TB_INACCURATE, tension);
    }
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    return t189 ? TB_INFEASIBLE : TB_OK;
}

/* Refuses with a status: factor is 0. */
static tb_status tb_refuse_tension_factor(tb_status status, real_t factor[1])
{
    factor[0] = TB_C(0.0);
    return status;
}

tb_status tb_tension_factor(const real_t pose[2], const real_t rails[1], real_t factor[1])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0))) {
        return tb_refuse_tension_factor(TB_OUT_OF_DOMAIN, factor);
    }
    const real_t t0 = pose[0] * pose[0];
    const real_t t1 = pose[1] * pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 + t1);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t t3 = pose[0] * t2;
    const real_t t4 = TB_FRAME - pose[0];
    const real_t t5 = t4 * t4;
    const real_t length_1 = TB_SQRT(t1 + t5);
    const real_t t6 = TB_C(1.0) / length_1;
    const real_t t7 = pose[1] * t6;
    const real_t t8 = pose[1] * t2;
    const real_t t9 = t4 * t6;
    const real_t t10 = TB_ABS(t3 * t7 + t8 * t9);
    const real_t t11 = TB_FRAME - pose[1];
    const real_t t12 = t11 * t11;
    const real_t length_2 = TB_SQRT(t5 + t12);
    const real_t t13 = TB_C(1.0) / length_2;
    const real_t t14 = t4 * t13;
    const real_t t15 = t11 * t13;
    const real_t t16 = TB_ABS(t8 * t14 - t3 * t15);
    const real_t length_3 = TB_SQRT(t0 + t12);
    const real_t t17 = TB_C(1.0) / length_3;
    const real_t t18 = t11 * t17;
    const real_t t19 = pose[0] * t17;
    const real_t t20 = TB_ABS(t3 * t18 + t8 * t19);
    const real_t t21 = TB_C(5.0) * (t14 + (t9 - t3) - t19);
    const real_t t22 = TB_C(5.0) * (t18 + (t15 - (t7 + t8)));
    const real_t t23 = TB_C(5.0) * (t10 + t16 + t20) - TB_ABS(t8 * t21 - t3 * t22);
    const real_t t24 = TB_ABS(t9 * t15 + t7 * t14);
    const real_t t25 = TB_ABS(t9 * t18 - t7 * t19);
    const real_t t26 = TB_C(5.0) * (t10 + t24 + t25) - TB_ABS(t9 * t22 + t7 * t21);
    const real_t t27 = TB_ABS(t14 * t18 + t15 * t19);
    const real_t t28 = TB_C(5.0) * (t16 + t24 + t27) - TB_ABS(t14 * t22 - t15 * t21);
    const real_t t29 = TB_C(5.0) * (t27 + (t20 + t25)) - TB_ABS(t19 * t22 + t18 * t21);
    const bool t30 = TB_C(0.0) <= tb_min(tb_min(tb_min(t23, t26), t28), t29);
    const real_t t31 = TB_SQRT(t3 * t3 + t9 * t9 + t14 * t14 + t19 * t19);
    const real_t t32 = TB_COPYSIGN(t31, -t3);
    const real_t t33 = TB_ABS(t32);
    const real_t t34 = t32 - t3;
    const real_t t35 = TB_C(1.0) / (t31 * (t31 + TB_ABS(t3)));
    const real_t t36 = (t14 * t15 - (t8 * t34 + t7 * t9) - t18 * t19) * t35;
    const real_t t37 = t7 + t9 * t36;
    const real_t t38 = t15 - t14 * t36;
    const real_t t39 = t18 + t19 * t36;
    const real_t t40 = TB_SQRT(t37 * t37 + t38 * t38 + t39 * t39);
    const real_t t41 = TB_COPYSIGN(t40, -t37);
    const real_t t42 = TB_ABS(t41);
    const real_t t43 = TB_C(30.0) * TB_EPSILON / tb_min(t33, t42);
    const real_t t44 = t43 + TB_TENSION_MAX;
    const bool t45 = TB_C(0.0) < tb_max(-t43, -t44);
    const real_t t46 = TB_C(1.0) / (t40 * (t40 + TB_ABS(t37)));
    const real_t t47 = t38 * t46;
    const real_t t48 = t41 - t37;
    const real_t t49 = t47 * t48;
    const real_t t50 = TB_C(1.0) - t38 * t47;
    const real_t t51 = t39 * t47;
    const real_t t52 = t35 * (t14 * t50 - t9 * t49 + t19 * t51);
    const real_t t53 = t49 + t9 * t52;
    const real_t t54 = t39 * t46;
    const real_t t55 = t48 * t54;
    const real_t t56 = t38 * t54;
    const real_t t57 = TB_C(1.0) - t39 * t54;
    const real_t t58 = t35 * (t9 * t55 + t14 * t56 + t19 * t57);
    const real_t t59 = t14 * t58 - t56;
    const real_t t60 = t9 * t58 - t55;
    const real_t t61 = t50 - t14 * t52;
    const real_t t62 = t53 * t59 + t60 * t61;
    const real_t t63 = t34 * t52;
    const real_t t64 = t34 * t58;
    const real_t t65 = TB_EPSILON * TB_C(16.0);
    const real_t t66 = t57 - t19 * t58;
    const real_t t67 = t19 * t52 - t51;
    const real_t t68 = t53 * t66 + t60 * t67;
    real_t t69, t70, t71;
    if (t45) {
        const real_t t72 = t60 * t63 - t53 * t64;
        const bool t73 = TB_ABS(t72) <= t65;
        real_t t74, t75;
        if (t73) {
            t74 = -TB_C(1000000000000.0);
            t75 = TB_C(1000000000000.0);
        } else {
            const real_t t76 = TB_C(1.0) / t72;
            const real_t t77 = -(t43 * t76);
            const real_t t78 = t44 * t76;
            t74 = tb_min(t77, t78);
            t75 = tb_max(t77, t78);
        }
        const real_t t79 = tb_min(tb_max(TB_C(0.0), t74), t75);
        t69 = -(t62 * t79);
        t70 = -(t79 * t68);
        t71 = t72 * t79;
    } else {
        t69 = TB_C(0.0);
        t70 = TB_C(0.0);
        t71 = TB_C(0.0);
    }
    const bool t80 = TB_C(0.0) < tb_max(-(t43 + t69), t69 - t44);
    const real_t t81 = t61 * t67 + t59 * t66;
    const real_t t82 = t61 * t66;
    const real_t t83 = t59 * t67;
    real_t t84, t85, t86, t87;
    if (t80) {
        const real_t t88 = tb_min(tb_max(t69, TB_C(0.0)), TB_TENSION_MAX);
        const real_t t89 = TB_C(1.0) / tb_max(t61 * t61 + t59 * t59, TB_EPSILON);
        const real_t t90 = t88 * t89;
        const bool t91 = TB_ABS(t62) <= t65;
        const real_t t92 = t90 * (t59 * t60 - t53 * t61);
        real_t t93, t94;
        if (t91) {
            t93 = -TB_C(1000000000000.0);
            t94 = TB_C(1000000000000.0);
        } else {
            const real_t t95 = TB_C(1.0) / t62;
            const real_t t96 = -((t43 + t92) * t95);
            const real_t t97 = t95 * (t44 - t92);
            t93 = tb_min(t96, t97);
            t94 = tb_max(t96, t97);
        }
        const real_t t98 = t61 * t64 + t59 * t63;
        const bool t99 = TB_ABS(t98) <= t65;
        const real_t t100 = t90 * (t59 * t64 - t61 * t63);
        real_t t101, t102;
        if (t99) {
            t101 = -TB_C(1000000000000.0);
            t102 = TB_C(1000000000000.0);
        } else {
            const real_t t103 = TB_C(1.0) / t98;
            const real_t t104 = -((t43 + t100) * t103);
            const real_t t105 = t103 * (t44 - t100);
            t101 = tb_min(t104, t105);
            t102 = tb_max(t104, t105);
        }
        const real_t t106 = tb_min(tb_max(TB_C(0.0), tb_max(t93, t101)), tb_min(t94, t102));
        t84 = t81 * t90 + (t82 - t83) * t106;
        t85 = t100 + t98 * t106;
        t86 = t92 + t62 * t106;
        t87 = t88;
    } else {
        t84 = t70;
        t85 = t71;
        t86 = TB_C(0.0);
        t87 = t69;
    }
    const bool t107 = TB_C(0.0) < tb_max(-(t43 + t84), t84 - t44);
    real_t t108, t109, t110, t111;
    if (t107) {
        const real_t t112 = tb_min(tb_max(t84, TB_C(0.0)), TB_TENSION_MAX);
        const real_t t113 = TB_C(1.0) / tb_max(t67 * t67 + t66 * t66, TB_EPSILON);
        const real_t t114 = t112 * t113;
        const real_t t115 = (t64 * t66 - t63 * t67) * t114;
        const real_t t116 = t64 * t67 + t63 * t66;
        const real_t t117 = t83 - t82;
        const bool t118 = TB_ABS(t117) <= t65;
        const real_t t119 = t81 * t114;
        real_t t120, t121;
        if (t118) {
            t120 = -TB_C(1000000000000.0);
            t121 = TB_C(1000000000000.0);
        } else {
            const real_t t122 = TB_C(1.0) / t117;
            const real_t t123 = -((t43 + t119) * t122);
            const real_t t124 = t122 * (t44 - t119);
            t120 = tb_min(t123, t124);
            t121 = tb_max(t123, t124);
        }
        const bool t125 = TB_ABS(t68) <= t65;
        const real_t t126 = t114 * (t60 * t66 - t53 * t67);
        real_t t127, t128;
        if (t125) {
            t127 = -TB_C(1000000000000.0);
            t128 = TB_C(1000000000000.0);
        } else {
            const real_t t129 = TB_C(1.0) / t68;
            const real_t t130 = -((t43 + t126) * t129);
            const real_t t131 = t129 * (t44 - t126);
            t127 = tb_min(t130, t131);
            t128 = tb_max(t130, t131);
        }
        const bool t132 = TB_ABS(t116) <= t65;
        real_t t133, t134;
        if (t132) {
            t133 = -TB_C(1000000000000.0);
            t134 = TB_C(1000000000000.0);
        } else {
            const real_t t135 = TB_C(1.0) / t116;
            const real_t t136 = -((t43 + t115) * t135);
            const real_t t137 = t135 * (t44 - t115);
            t133 = tb_min(t136, t137);
            t134 = tb_max(t136, t137);
        }
        const real_t t138 = tb_max(TB_C(0.0), tb_max(t120, tb_max(t127, t133)));
        const real_t t139 = tb_min(t138, tb_min(t121, tb_min(t128, t134)));
        t108 = t115 + t116 * t139;
        t109 = t126 + t68 * t139;
        t110 = t119 + t117 * t139;
        t111 = t112;
    } else {
        t108 = t85;
        t109 = t86;
        t110 = t87;
        t111 = t84;
    }
    /* T0 */
    const real_t rest_0 = tb_min(tb_max(t108, TB_C(0.0)), TB_TENSION_MAX);
    const real_t rest_1 = tb_min(tb_max(t109, TB_C(0.0)), TB_TENSION_MAX);
    const real_t rest_2 = tb_min(tb_max(t110, TB_C(0.0)), TB_TENSION_MAX);
    const real_t rest_3 = tb_min(tb_max(t111, TB_C(0.0)), TB_TENSION_MAX);
    const real_t t140 = tb_max(tb_max(tb_max(rest_0, rest_1), rest_2), rest_3);
    real_t factor_0;
    if (t30) {
        const real_t t141 = tb_min(tb_min(tb_min(rest_0, rest_1), rest_2), rest_3);
        factor_0 = t141 / t140;
    } else {
        factor_0 = TB_C(0.0);
    }
    const bool t142 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t143 = t142 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t144 = !t143;
    const real_t t145 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t146 = !(t145 < t33 && t145 < t42);
    const bool t147 = !(TB_C(0.0) < t140);
    const bool t148 = !t30;
    if (t144 || t146 || t147) {
        return tb_refuse_tension_factor(TB_SINGULAR, factor);
    }
    factor[0] = factor_0;
    return t148 ? TB_INFEASIBLE : TB_OK;
}

/* Refuses with a status: force is 0 N. */
static tb_status tb_refuse_isotropic_force(tb_status status, real_t force[1])
{
    force[0] = TB_C(0.0);
    return status;
}

tb_status tb_isotropic_force(const real_t pose[2], const real_t rails[1], real_t force[1])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0))) {
        return tb_refuse_isotropic_force(TB_OUT_OF_DOMAIN, force);
    }
    const real_t t0 = pose[0] * pose[0];
    const real_t t1 = pose[1] * pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 + t1);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t t3 = pose[0] * t2;
    const real_t t4 = TB_FRAME - pose[0];
    const real_t t5 = t4 * t4;
    const real_t length_1 = TB_SQRT(t1 + t5);
    const real_t t6 = TB_C(1.0) / length_1;
    const real_t t7 = pose[1] * t6;
    const real_t t8 = pose[1] * t2;
    const real_t t9 = t4 * t6;
    const real_t t10 = TB_ABS(t3 * t7 + t8 * t9);
    const real_t t11 = TB_FRAME - pose[1];
    const real_t t12 = t11 * t11;
    const real_t length_2 = TB_SQRT(t5 + t12);
    const real_t t13 = TB_C(1.0) / length_2;
    const real_t t14 = t4 * t13;
    const real_t t15 = t11 * t13;
    const real_t t16 = TB_ABS(t8 * t14 - t3 * t15);
    const real_t length_3 = TB_SQRT(t0 + t12);
    const real_t t17 = TB_C(1.0) / length_3;
    const real_t t18 = t11 * t17;
    const real_t t19 = pose[0] * t17;
    const real_t t20 = TB_ABS(t3 * t18 + t8 * t19);
    const real_t t21 = TB_C(5.0) * (t14 + (t9 - t3) - t19);
    const real_t t22 = TB_C(5.0) * (t18 + (t15 - (t7 + t8)));
    const real_t t23 = TB_C(5.0) * (t10 + t16 + t20) - TB_ABS(t8 * t21 - t3 * t22);
    const real_t t24 = TB_ABS(t9 * t15 + t7 * t14);
    const real_t t25 = TB_ABS(t9 * t18 - t7 * t19);
    const real_t t26 = TB_C(5.0) * (t10 + t24 + t25) - TB_ABS(t9 * t22 + t7 * t21);
    const real_t t27 = TB_ABS(t14 * t18 + t15 * t19);
    const real_t t28 = TB_C(5.0) * (t16 + t24 + t27) - TB_ABS(t14 * t22 - t15 * t21);
    const real_t t29 = TB_C(5.0) * (t27 + (t20 + t25)) - TB_ABS(t19 * t22 + t18 * t21);
    const real_t t30 = tb_min(tb_min(tb_min(t23, t26), t28), t29);
    const real_t force_0 = tb_max(TB_C(0.0), t30);
    const bool t31 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t32 = t31 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t33 = !t32;
    const bool t34 = !(TB_C(0.0) <= t30);
    if (t33) {
        return tb_refuse_isotropic_force(TB_SINGULAR, force);
    }
    force[0] = force_0;
    return t34 ? TB_INFEASIBLE : TB_OK;
}

/* Refuses with a status: margin is 0 N; factor is 0; force is 0 N. */
static tb_status tb_refuse_pose_quality(tb_status status, real_t margin[1], real_t factor[1],
    real_t force[1])
{
    margin[0] = TB_C(0.0);
    factor[0] = TB_C(0.0);
    force[0] = TB_C(0.0);
    return status;
}

tb_status tb_pose_quality(const real_t pose[2], const real_t rails[1], real_t margin[1],
    real_t factor[1], real_t force[1])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0))) {
        return tb_refuse_pose_quality(TB_OUT_OF_DOMAIN, margin, factor, force);
    }
    const real_t t0 = pose[0] * pose[0];
    const real_t t1 = pose[1] * pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 + t1);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t t3 = pose[0] * t2;
    const real_t t4 = TB_FRAME - pose[0];
    const real_t t5 = t4 * t4;
    const real_t length_1 = TB_SQRT(t1 + t5);
    const real_t t6 = TB_C(1.0) / length_1;
    const real_t t7 = pose[1] * t6;
    const real_t t8 = pose[1] * t2;
    const real_t t9 = t4 * t6;
    const real_t t10 = t3 * t7 + t8 * t9;
    const real_t t11 = TB_ABS(t10);
    const real_t t12 = TB_FRAME - pose[1];
    const real_t t13 = t12 * t12;
    const real_t length_2 = TB_SQRT(t5 + t13);
    const real_t t14 = TB_C(1.0) / length_2;
    const real_t t15 = t4 * t14;
    const real_t t16 = t12 * t14;
    const real_t t17 = t8 * t15 - t3 * t16;
    const real_t t18 = TB_ABS(t17);
    const real_t length_3 = TB_SQRT(t0 + t13);
    const real_t t19 = TB_C(1.0) / length_3;
    const real_t t20 = t12 * t19;
    const real_t t21 = pose[0] * t19;
    const real_t t22 = t3 * t20 + t8 * t21;
    const real_t t23 = TB_ABS(t22);
    const real_t t24 = TB_C(5.0) * (t15 + (t9 - t3) - t21);
    const real_t t25 = TB_C(5.0) * (t20 + (t16 - (t7 + t8)));
    const real_t t26 = TB_C(5.0) * (t11 + t18 + t23) - TB_ABS(t8 * t24 - t3 * t25);
    const real_t t27 = t9 * t16 + t7 * t15;
    const real_t t28 = TB_ABS(t27);
    const real_t t29 = t9 * t20 - t7 * t21;
    const real_t t30 = TB_ABS(t29);
    const real_t t31 = TB_C(5.0) * (t11 + t28 + t30) - TB_ABS(t9 * t25 + t7 * t24);
    const real_t t32 = t15 * t20 + t16 * t21;
    const real_t t33 = TB_ABS(t32);
    const real_t t34 = TB_C(5.0) * (t18 + t28 + t33) - TB_ABS(t15 * t25 - t16 * t24);
    const real_t t35 = TB_C(5.0) * (t33 + (t23 + t30)) - TB_ABS(t21 * t25 + t20 * t24);
    const real_t margin_0 = tb_min(tb_min(tb_min(t26, t31), t34), t35);
    const real_t force_0 = tb_max(TB_C(0.0), margin_0);
    const bool t36 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t37 = t36 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t38 = !t37;
    const real_t t39 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const real_t t40 = t10 * t10 + t17 * t17 + t22 * t22 + t27 * t27 + t29 * t29;
    const bool t41 = !(t39 * t39 < (t40 + t32 * t32) * TB_C(0.5));
    const bool t42 = !(TB_C(0.0) <= margin_0);
    if (t38 || t41) {
        return tb_refuse_pose_quality(TB_SINGULAR, margin, factor, force);
    }
    if (TB_C(0.0)) {
        return tb_refuse_pose_quality(TB_INACCURATE, margin, factor, force);
    }
    margin[0] = margin_0;
    factor[0] = TB_C(0.0);
    force[0] = force_0;
    return t42 ? TB_INFEASIBLE : TB_OK;
}

/* Refuses with a status: force is 0 N. */
static tb_status tb_refuse_isotropic_force_eq17(tb_status status, real_t force[1])
{
    force[0] = TB_C(0.0);
    return status;
}

tb_status tb_isotropic_force_eq17(const real_t pose[2], const real_t rails[1], real_t force[1])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0))) {
        return tb_refuse_isotropic_force_eq17(TB_OUT_OF_DOMAIN, force);
    }
    const real_t t0 = pose[0] * pose[0];
    const real_t t1 = pose[1] * pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 + t1);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t t3 = pose[0] * t2;
    const real_t t4 = TB_FRAME - pose[0];
    const real_t t5 = t4 * t4;
    const real_t length_1 = TB_SQRT(t1 + t5);
    const real_t t6 = TB_C(1.0) / length_1;
    const real_t t7 = pose[1] * t6;
    const real_t t8 = pose[1] * t2;
    const real_t t9 = t4 * t6;
    const real_t t10 = t3 * t7 + t8 * t9;
    const real_t t11 = TB_ABS(t10);
    const real_t t12 = TB_FRAME - pose[1];
    const real_t t13 = t12 * t12;
    const real_t length_2 = TB_SQRT(t5 + t13);
    const real_t t14 = TB_C(1.0) / length_2;
    const real_t t15 = t4 * t14;
    const real_t t16 = t8 * t15;
    const real_t t17 = t12 * t14;
    const real_t t18 = t3 * t17;
    const real_t t19 = t16 - t18;
    const real_t t20 = TB_ABS(t19);
    const real_t length_3 = TB_SQRT(t0 + t13);
    const real_t t21 = TB_C(1.0) / length_3;
    const real_t t22 = t12 * t21;
    const real_t t23 = pose[0] * t21;
    const real_t t24 = t3 * t22 + t8 * t23;
    const real_t t25 = TB_ABS(t24);
    const real_t t26 = TB_C(5.0) * (t15 + (t9 - t3) - t23);
    const real_t t27 = TB_C(5.0) * (t22 + (t17 - (t7 + t8)));
    const real_t t28 = TB_C(5.0) * (t11 + t20 + t25) - TB_ABS(t8 * t26 - t3 * t27);
    const real_t t29 = t9 * t17 + t7 * t15;
    const real_t t30 = TB_ABS(t29);
    const real_t t31 = t9 * t22;
    const real_t t32 = t7 * t23;
    const real_t t33 = t31 - t32;
    const real_t t34 = TB_ABS(t33);
    const real_t t35 = TB_C(5.0) * (t11 + t30 + t34) - TB_ABS(t9 * t27 + t7 * t26);
    const real_t t36 = t15 * t22 + t17 * t23;
    const real_t t37 = TB_ABS(t36);
    const real_t t38 = TB_C(5.0) * (t20 + t30 + t37) - TB_ABS(t15 * t27 - t17 * t26);
    const real_t t39 = TB_C(5.0) * (t37 + (t25 + t34)) - TB_ABS(t23 * t27 + t22 * t26);
    const bool t40 = TB_C(0.0) <= tb_min(tb_min(tb_min(t28, t35), t38), t39);
    const real_t t41 = TB_SQRT(t3 * t3 + t9 * t9 + t15 * t15 + t23 * t23);
    const real_t t42 = TB_COPYSIGN(t41, -t3);
    const real_t t43 = TB_ABS(t42);
    const real_t t44 = t42 - t3;
    const real_t t45 = TB_C(1.0) / (t41 * (t41 + TB_ABS(t3)));
    const real_t t46 = (t15 * t17 - (t8 * t44 + t7 * t9) - t22 * t23) * t45;
    const real_t t47 = t7 + t9 * t46;
    const real_t t48 = t17 - t15 * t46;
    const real_t t49 = t22 + t23 * t46;
    const real_t t50 = TB_SQRT(t47 * t47 + t48 * t48 + t49 * t49);
    const real_t t51 = TB_COPYSIGN(t50, -t47);
    const real_t t52 = TB_ABS(t51);
    real_t force_0;
    if (t40) {
        const bool t53 = TB_C(0.0) < t10;
        const bool t54 = t7 * t8 - t3 * t9 < TB_C(0.0);
        const bool t55 = TB_C(0.0) < t19;
        const real_t t56 = -t29;
        const bool t57 = TB_C(0.0) < t56;
        const real_t t58 = -t24;
        const bool t59 = TB_C(0.0) < t58;
        const real_t t60 = t32 - t31;
        const bool t61 = TB_C(0.0) < t60;
        const bool t62 = (t53 || (TB_C(0.0) <= t10 && t54)) && !((t55 && t57) || (t59 && t61));
        const real_t t63 = TB_C(30.0) * TB_EPSILON / tb_min(t43, t52);
        const real_t t64 = TB_TENSION_MAX + t63;
        const bool t65 = TB_C(0.0) < tb_max(-t63, -t64);
        const real_t t66 = TB_C(1.0) / (t50 * (t50 + TB_ABS(t47)));
        const real_t t67 = t48 * t66;
        const real_t t68 = t51 - t47;
        const real_t t69 = t67 * t68;
        const real_t t70 = TB_C(1.0) - t48 * t67;
        const real_t t71 = t49 * t67;
        const real_t t72 = t45 * (t15 * t70 - t9 * t69 + t23 * t71);
        const real_t t73 = t69 + t9 * t72;
        const real_t t74 = t49 * t66;
        const real_t t75 = t68 * t74;
        const real_t t76 = t48 * t74;
        const real_t t77 = TB_C(1.0) - t49 * t74;
        const real_t t78 = t45 * (t9 * t75 + t15 * t76 + t23 * t77);
        const real_t t79 = t15 * t78 - t76;
        const real_t t80 = t9 * t78 - t75;
        const real_t t81 = t70 - t15 * t72;
        const real_t t82 = t73 * t79 + t80 * t81;
        const real_t t83 = t44 * t72;
        const real_t t84 = t44 * t78;
        const real_t t85 = TB_EPSILON * TB_C(16.0);
        const real_t t86 = t77 - t23 * t78;
        const real_t t87 = t23 * t72 - t71;
        const real_t t88 = t73 * t86 + t80 * t87;
        real_t t89, t90, t91;
        if (t65) {
            const real_t t92 = t80 * t83 - t73 * t84;
            const bool t93 = TB_ABS(t92) <= t85;
            real_t t94, t95;
            if (t93) {
                t94 = -TB_C(1000000000000.0);
                t95 = TB_C(1000000000000.0);
            } else {
                const real_t t96 = TB_C(1.0) / t92;
                const real_t t97 = -(t63 * t96);
                const real_t t98 = t64 * t96;
                t94 = tb_min(t97, t98);
                t95 = tb_max(t97, t98);
            }
            const real_t t99 = tb_min(tb_max(TB_C(0.0), t94), t95);
            t89 = -(t82 * t99);
            t90 = -(t99 * t88);
            t91 = t92 * t99;
        } else {
            t89 = TB_C(0.0);
            t90 = TB_C(0.0);
            t91 = TB_C(0.0);
        }
        const bool t100 = TB_C(0.0) < tb_max(-(t63 + t89), t89 - t64);
        const real_t t101 = t81 * t87 + t79 * t86;
        const real_t t102 = t81 * t86;
        const real_t t103 = t79 * t87;
        real_t t104, t105, t106, t107;
        if (t100) {
            const real_t t108 = tb_min(tb_max(t89, TB_C(0.0)), TB_TENSION_MAX);
            const real_t t109 = TB_C(1.0) / tb_max(t81 * t81 + t79 * t79, TB_EPSILON);
            const real_t t110 = t108 * t109;
            const bool t111 = TB_ABS(t82) <= t85;
            const real_t t112 = t110 * (t79 * t80 - t73 * t81);
            real_t t113, t114;
            if (t111) {
                t113 = -TB_C(1000000000000.0);
                t114 = TB_C(1000000000000.0);
            } else {
                const real_t t115 = TB_C(1.0) / t82;
                const real_t t116 = -((t63 + t112) * t115);
                const real_t t117 = t115 * (t64 - t112);
                t113 = tb_min(t116, t117);
                t114 = tb_max(t116, t117);
            }
            const real_t t118 = t81 * t84 + t79 * t83;
            const bool t119 = TB_ABS(t118) <= t85;
            const real_t t120 = t110 * (t79 * t84 - t81 * t83);
            real_t t121, t122;
            if (t119) {
                t121 = -TB_C(1000000000000.0);
                t122 = TB_C(1000000000000.0);
            } else {
                const real_t t123 = TB_C(1.0) / t118;
                const real_t t124 = -((t63 + t120) * t123);
                const real_t t125 = t123 * (t64 - t120);
                t121 = tb_min(t124, t125);
                t122 = tb_max(t124, t125);
            }
            const real_t t126 = tb_min(tb_max(TB_C(0.0), tb_max(t113, t121)), tb_min(t114,
                t122));
            t104 = t101 * t110 + (t102 - t103) * t126;
            t105 = t120 + t118 * t126;
            t106 = t112 + t82 * t126;
            t107 = t108;
        } else {
            t104 = t90;
            t105 = t91;
            t106 = TB_C(0.0);
            t107 = t89;
        }
        const bool t127 = TB_C(0.0) < tb_max(-(t63 + t104), t104 - t64);
        real_t t128, t129, t130, t131;
        if (t127) {
            const real_t t132 = tb_min(tb_max(t104, TB_C(0.0)), TB_TENSION_MAX);
            const real_t t133 = TB_C(1.0) / tb_max(t87 * t87 + t86 * t86, TB_EPSILON);
            const real_t t134 = t132 * t133;
            const real_t t135 = (t84 * t86 - t83 * t87) * t134;
            const real_t t136 = t84 * t87 + t83 * t86;
            const real_t t137 = t103 - t102;
            const bool t138 = TB_ABS(t137) <= t85;
            const real_t t139 = t101 * t134;
            real_t t140, t141;
            if (t138) {
                t140 = -TB_C(1000000000000.0);
                t141 = TB_C(1000000000000.0);
            } else {
                const real_t t142 = TB_C(1.0) / t137;
                const real_t t143 = -((t63 + t139) * t142);
                const real_t t144 = t142 * (t64 - t139);
                t140 = tb_min(t143, t144);
                t141 = tb_max(t143, t144);
            }
            const bool t145 = TB_ABS(t88) <= t85;
            const real_t t146 = t134 * (t80 * t86 - t73 * t87);
            real_t t147, t148;
            if (t145) {
                t147 = -TB_C(1000000000000.0);
                t148 = TB_C(1000000000000.0);
            } else {
                const real_t t149 = TB_C(1.0) / t88;
                const real_t t150 = -((t63 + t146) * t149);
                const real_t t151 = t149 * (t64 - t146);
                t147 = tb_min(t150, t151);
                t148 = tb_max(t150, t151);
            }
            const bool t152 = TB_ABS(t136) <= t85;
            real_t t153, t154;
            if (t152) {
                t153 = -TB_C(1000000000000.0);
                t154 = TB_C(1000000000000.0);
            } else {
                const real_t t155 = TB_C(1.0) / t136;
                const real_t t156 = -((t63 + t135) * t155);
                const real_t t157 = t155 * (t64 - t135);
                t153 = tb_min(t156, t157);
                t154 = tb_max(t156, t157);
            }
            const real_t t158 = tb_max(TB_C(0.0), tb_max(t140, tb_max(t147, t153)));
            const real_t t159 = tb_min(t158, tb_min(t141, tb_min(t148, t154)));
            t128 = t135 + t136 * t159;
            t129 = t146 + t88 * t159;
            t130 = t139 + t137 * t159;
            t131 = t132;
        } else {
            t128 = t105;
            t129 = t106;
            t130 = t107;
            t131 = t104;
        }
        /* t_i = T_max - T0_i */
        const real_t margin_0 = TB_TENSION_MAX - tb_min(tb_max(t128, TB_C(0.0)),
            TB_TENSION_MAX);
        const real_t margin_1 = TB_TENSION_MAX - tb_min(tb_max(t129, TB_C(0.0)),
            TB_TENSION_MAX);
        const real_t t160 = tb_min(margin_0, margin_1);
        const bool t161 = -(t3 * t15 + t8 * t17) < TB_C(0.0);
        const bool t162 = TB_C(0.0) < t29;
        const real_t t163 = -t36;
        const bool t164 = TB_C(0.0) < t163;
        const bool t165 = (t55 || (TB_C(0.0) <= t19 && t161)) && !((t53 && t162) || (t59 &&
            t164));
        const real_t margin_2 = TB_TENSION_MAX - tb_min(tb_max(t130, TB_C(0.0)),
            TB_TENSION_MAX);
        const real_t t166 = tb_min(margin_0, margin_2);
        const real_t t167 = tb_min(t62 ? (t54 ? t10 * t160 : t160) : TB_C(1e+30), t165 ? (t161
            ? t19 * t166 : t166) : TB_C(1e+30));
        const bool t168 = t3 * t23 - t8 * t22 < TB_C(0.0);
        const bool t169 = TB_C(0.0) < t33;
        const bool t170 = TB_C(0.0) < t36;
        const bool t171 = (t59 || (TB_C(0.0) <= t58 && t168)) && !((t53 && t169) || (t55 &&
            t170));
        const real_t margin_3 = TB_TENSION_MAX - tb_min(tb_max(t131, TB_C(0.0)),
            TB_TENSION_MAX);
        const real_t t172 = tb_min(margin_0, margin_3);
        const real_t t173 = t171 ? (t168 ? -(t24 * t172) : t172) : TB_C(1e+30);
        const real_t t174 = -t10;
        const bool t175 = TB_C(0.0) < t174;
        const real_t t176 = t18 - t16;
        const bool t177 = TB_C(0.0) < t176;
        const bool t178 = TB_C(0.0) < t24;
        const bool t179 = (t175 || (t54 && TB_C(0.0) <= t174)) && !((t162 && t177) || (t169 &&
            t178));
        const real_t t180 = tb_min(margin_1, margin_0);
        const real_t t181 = t179 ? (t54 ? -(t10 * t180) : t180) : TB_C(1e+30);
        const bool t182 = t9 * t15 - t7 * t17 < TB_C(0.0);
        const bool t183 = (t162 || (TB_C(0.0) <= t29 && t182)) && !((t55 && t175) || (t164 &&
            t169));
        const real_t t184 = tb_min(margin_1, margin_2);
        const real_t t185 = tb_min(tb_min(tb_min(t167, t173), t181), t183 ? (t182 ? t29 * t184
            : t184) : TB_C(1e+30));
        const bool t186 = -(t9 * t23 + t7 * t22) < TB_C(0.0);
        const bool t187 = (t169 || (TB_C(0.0) <= t33 && t186)) && !((t59 && t175) || (t162 &&
            t170));
        const real_t t188 = tb_min(margin_1, margin_3);
        const real_t t189 = tb_min(t185, t187 ? (t186 ? t33 * t188 : t188) : TB_C(1e+30));
        const bool t190 = (t177 || (t161 && TB_C(0.0) <= t176)) && !((t57 && t175) || (t170 &&
            t178));
        const real_t t191 = tb_min(margin_2, margin_0);
        const real_t t192 = t190 ? (t161 ? -(t19 * t191) : t191) : TB_C(1e+30);
        const bool t193 = (t57 || (t182 && TB_C(0.0) <= t56)) && !((t53 && t177) || (t61 &&
            t170));
        const real_t t194 = tb_min(margin_2, margin_1);
        const real_t t195 = t193 ? (t182 ? -(t29 * t194) : t194) : TB_C(1e+30);
        const bool t196 = t17 * t22 - t15 * t23 < TB_C(0.0);
        const bool t197 = (t170 || (TB_C(0.0) <= t36 && t196)) && !((t59 && t177) || (t57 &&
            t169));
        const real_t t198 = tb_min(margin_2, margin_3);
        const real_t t199 = tb_min(tb_min(tb_min(t189, t192), t195), t197 ? (t196 ? t36 * t198
            : t198) : TB_C(1e+30));
        const bool t200 = (t178 || (t168 && TB_C(0.0) <= t24)) && !((t61 && t175) || (t164 &&
            t177));
        const real_t t201 = tb_min(margin_3, margin_0);
        const real_t t202 = tb_min(t199, t200 ? (t168 ? t24 * t201 : t201) : TB_C(1e+30));
        const bool t203 = (t61 || (t186 && TB_C(0.0) <= t60)) && !((t53 && t178) || (t57 &&
            t164));
        const real_t t204 = tb_min(margin_3, margin_1);
        const real_t t205 = t203 ? (t186 ? -(t33 * t204) : t204) : TB_C(1e+30);
        const bool t206 = (t164 || (t196 && TB_C(0.0) <= t163)) && !((t55 && t178) || (t61 &&
            t162));
        const real_t t207 = tb_min(margin_3, margin_2);
        const real_t t208 = t206 ? (t196 ? -(t36 * t207) : t207) : TB_C(1e+30);
        force_0 = tb_min(tb_min(t202, t205), t208);
    } else {
        force_0 = TB_C(0.0);
    }
    const bool t209 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t210 = t209 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t211 = !t210;
    const real_t t212 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t213 = !(t212 < t43 && t212 < t52);
    const bool t214 = !t40;
    if (t211 || t213) {
        return tb_refuse_isotropic_force_eq17(TB_SINGULAR, force);
    }
    force[0] = force_0;
    return t214 ? TB_INFEASIBLE : TB_OK;
}

