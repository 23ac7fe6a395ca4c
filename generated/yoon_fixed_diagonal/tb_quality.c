/* Regenerate: turnbuckle generate machines/yoon_fixed_diagonal.toml --out <this folder>
 * Machine 7ea279c692dea1e9, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_quality.h"
#include "tb_machine.h"

/* Refuses with a status: tension is 3 N. */
static tb_status tb_refuse_zero_wrench_tension(tb_status status, real_t tension[4])
{
    tension[0] = TB_TENSION_MIN;
    tension[1] = TB_TENSION_MIN;
    tension[2] = TB_TENSION_MIN;
    tension[3] = TB_TENSION_MIN;
    return status;
}

tb_status tb_zero_wrench_tension(const real_t pose[2], const real_t rails[1], real_t tension[4])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.024))) {
        return tb_refuse_zero_wrench_tension(TB_OUT_OF_DOMAIN, tension);
    }
    const real_t t0 = pose[0] * pose[0];
    const real_t t1 = pose[1] * pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 + t1);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t t3 = pose[0] * t2;
    const real_t t4 = TB_FRAME_X - pose[0];
    const real_t t5 = t4 * t4;
    const real_t length_1 = TB_SQRT(t1 + t5);
    const real_t t6 = TB_C(1.0) / length_1;
    const real_t t7 = pose[1] * t6;
    const real_t t8 = pose[1] * t2;
    const real_t t9 = t4 * t6;
    const real_t t10 = TB_ABS(t3 * t7 + t8 * t9);
    const real_t t11 = TB_FRAME_Y - pose[1];
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
    const real_t t21 = TB_TENSION_MIDDLE * (t14 + (t9 - t3) - t19);
    const real_t t22 = TB_TENSION_MIDDLE * (t18 + (t15 - (t7 + t8)));
    const real_t t23 = TB_TENSION_HALF_RANGE * (t10 + t16 + t20) - TB_ABS(t8 * t21 - t3 * t22);
    const real_t t24 = TB_ABS(t9 * t15 + t7 * t14);
    const real_t t25 = TB_ABS(t9 * t18 - t7 * t19);
    const real_t t26 = TB_TENSION_HALF_RANGE * (t10 + t24 + t25) - TB_ABS(t9 * t22 + t7 * t21);
    const real_t t27 = TB_ABS(t14 * t18 + t15 * t19);
    const real_t t28 = TB_TENSION_HALF_RANGE * (t16 + t24 + t27) - TB_ABS(t14 * t22 - t15 *
        t21);
    const real_t t29 = TB_TENSION_HALF_RANGE * (t27 + (t20 + t25)) - TB_ABS(t19 * t22 + t18 *
        t21);
    const bool t30 = TB_C(0.0) <= tb_min(tb_min(tb_min(t23, t26), t28), t29);
    const bool t31 = !t30;
    const real_t t32 = TB_SQRT(t3 * t3 + t9 * t9 + t14 * t14 + t19 * t19);
    const real_t t33 = TB_COPYSIGN(t32, -t3);
    const real_t t34 = TB_ABS(t33);
    const real_t t35 = t33 - t3;
    const real_t t36 = TB_C(1.0) / (t32 * (t32 + TB_ABS(t3)));
    const real_t t37 = (t14 * t15 - (t8 * t35 + t7 * t9) - t18 * t19) * t36;
    const real_t t38 = t7 + t9 * t37;
    const real_t t39 = t15 - t14 * t37;
    const real_t t40 = t18 + t19 * t37;
    const real_t t41 = TB_SQRT(t38 * t38 + t39 * t39 + t40 * t40);
    const real_t t42 = TB_COPYSIGN(t41, -t38);
    const real_t t43 = TB_ABS(t42);
    const real_t t44 = TB_C(1.0) / tb_min(t34, t43);
    const real_t t45 = TB_C(30.0) * TB_EPSILON * t44;
    const real_t t46 = TB_TENSION_MIN - t45;
    const real_t t47 = TB_C(1.0) / (t41 * (t41 + TB_ABS(t38)));
    const real_t t48 = t39 * t47;
    const real_t t49 = TB_C(1.0) - t39 * t48;
    const real_t t50 = t42 - t38;
    const real_t t51 = t48 * t50;
    const real_t t52 = t40 * t48;
    const real_t t53 = t36 * (t14 * t49 - t9 * t51 + t19 * t52);
    const real_t t54 = t35 * t53;
    const real_t t55 = t51 + t9 * t53;
    const real_t t56 = t40 * t47;
    const real_t t57 = t50 * t56;
    const real_t t58 = t39 * t56;
    const real_t t59 = TB_C(1.0) - t40 * t56;
    const real_t t60 = t36 * (t9 * t57 + t14 * t58 + t19 * t59);
    const real_t t61 = t35 * t60;
    const real_t t62 = t9 * t60 - t57;
    const real_t t63 = t54 * t55 + t61 * t62;
    const real_t t64 = t45 < TB_TENSION_MIN ? TB_TENSION_MIN : TB_C(0.0);
    const real_t t65 = t64 / tb_max(t54 * t54 + t61 * t61, TB_EPSILON);
    const real_t t66 = t63 * t65;
    const real_t t67 = t45 + TB_TENSION_MAX;
    const real_t t68 = tb_max(t46 - t66, t66 - t67);
    const bool t69 = TB_C(0.0) < t68;
    const real_t t70 = t14 * t60 - t58;
    const real_t t71 = t49 - t14 * t53;
    const real_t t72 = t62 * t70 - t55 * t71;
    const real_t t73 = t55 * t70 + t62 * t71;
    const real_t t74 = TB_EPSILON * TB_C(16.0);
    const real_t t75 = t61 * t70 - t54 * t71;
    const real_t t76 = t59 - t19 * t60;
    const real_t t77 = t19 * t53 - t52;
    const real_t t78 = t62 * t76 - t55 * t77;
    const real_t t79 = t55 * t76 + t62 * t77;
    const real_t t80 = t61 * t76 - t54 * t77;
    const real_t t81 = t45 * TB_C(2.0);
    const real_t t82 = t45 * TB_C(1024.0);
    real_t t83, t84, t85, t86, t87;
    if (t69) {
        const real_t t88 = tb_min(tb_max(t66, TB_TENSION_MIN), TB_TENSION_MAX);
        const real_t t89 = TB_C(1.0) / tb_max(t55 * t55 + t62 * t62, TB_EPSILON);
        const real_t t90 = t88 * t89;
        const real_t t91 = t54 * t62 - t55 * t61;
        const bool t92 = TB_ABS(t91) <= t74;
        const real_t t93 = t63 * t90;
        const real_t t94 = TB_C(1.0) / t91;
        real_t t95, t96;
        if (t92) {
            t95 = -TB_C(1000000000000.0);
            t96 = TB_C(1000000000000.0);
        } else {
            const real_t t97 = (t46 - t93) * t94;
            const real_t t98 = t94 * (t67 - t93);
            t95 = tb_min(t97, t98);
            t96 = tb_max(t97, t98);
        }
        const real_t t99 = tb_min(tb_max(TB_C(0.0), t95), t96);
        const real_t t100 = TB_C(0.0) < TB_ABS(t99) ? t99 * (t63 * t94) : TB_C(0.0);
        const real_t t101 = t66 < t88 ? t100 - t90 : t90 - t100;
        real_t t102;
        if (TB_C(0.0) < t101) {
            const real_t t103 = t92 ? TB_C(0.0) : t81 * TB_ABS(t94);
            const real_t t104 = t95 + t103 < t96 - t103 && t82 < t68 ? t101 : TB_C(0.0);
            t102 = t104;
        } else {
            t102 = TB_C(0.0);
        }
        t83 = t72 * t90 - t73 * t99;
        t84 = t90 * t78 - t99 * t79;
        t85 = t93 + t91 * t99;
        t86 = t88;
        t87 = t102;
    } else {
        t83 = t65 * t75;
        t84 = t65 * t80;
        t85 = t64;
        t86 = t66;
        t87 = TB_C(0.0);
    }
    const real_t t105 = tb_max(t46 - t83, t83 - t67);
    const bool t106 = TB_C(0.0) < t105;
    const real_t t107 = t71 * t77 + t70 * t76;
    const real_t t108 = t71 * t76;
    const real_t t109 = t70 * t77;
    real_t t110, t111, t112, t113, t114;
    if (t106) {
        const real_t t115 = tb_min(tb_max(t83, TB_TENSION_MIN), TB_TENSION_MAX);
        const real_t t116 = TB_C(1.0) / tb_max(t71 * t71 + t70 * t70, TB_EPSILON);
        const real_t t117 = t115 * t116;
        const bool t118 = TB_ABS(t73) <= t74;
        const real_t t119 = t72 * t117;
        const real_t t120 = TB_C(1.0) / t73;
        real_t t121, t122;
        if (t118) {
            t121 = -TB_C(1000000000000.0);
            t122 = TB_C(1000000000000.0);
        } else {
            const real_t t123 = (t46 - t119) * t120;
            const real_t t124 = t120 * (t67 - t119);
            t121 = tb_min(t123, t124);
            t122 = tb_max(t123, t124);
        }
        const real_t t125 = t61 * t71 + t54 * t70;
        const bool t126 = TB_ABS(t125) <= t74;
        const real_t t127 = t75 * t117;
        const real_t t128 = TB_C(1.0) / t125;
        real_t t129, t130;
        if (t126) {
            t129 = -TB_C(1000000000000.0);
            t130 = TB_C(1000000000000.0);
        } else {
            const real_t t131 = (t46 - t127) * t128;
            const real_t t132 = t128 * (t67 - t127);
            t129 = tb_min(t131, t132);
            t130 = tb_max(t131, t132);
        }
        const real_t t133 = tb_min(tb_max(TB_C(0.0), tb_max(t121, t129)), tb_min(t122, t130));
        real_t t134;
        if (TB_C(0.0) < TB_ABS(t133)) {
            const real_t t135 = t72 * t120;
            const real_t t136 = t75 * t128;
            const real_t t137 = TB_C(0.0) < t133 ? (t129 < t121 ? t135 : t136) : (t122 < t130 ?
                t135 : t136);
            t134 = t133 * t137;
        } else {
            t134 = TB_C(0.0);
        }
        const real_t t138 = t83 < t115 ? t134 - t117 : t117 - t134;
        real_t t139;
        if (TB_C(0.0) < t138) {
            const real_t t140 = t126 ? TB_C(0.0) : t81 * TB_ABS(t128);
            const real_t t141 = t118 ? TB_C(0.0) : t81 * TB_ABS(t120);
            const bool t142 = tb_max(t129 + t140, t121 + t141) < tb_min(t130 - t140, t122 -
                t141);
            t139 = t142 && t82 < t105 ? t138 : TB_C(0.0);
        } else {
            t139 = TB_C(0.0);
        }
        t110 = t107 * t117 + (t108 - t109) * t133;
        t111 = t127 + t125 * t133;
        t112 = t119 + t73 * t133;
        t113 = t115;
        t114 = t139;
    } else {
        t110 = t84;
        t111 = t85;
        t112 = t86;
        t113 = t83;
        t114 = t87;
    }
    const real_t t143 = tb_max(t46 - t110, t110 - t67);
    const bool t144 = TB_C(0.0) < t143;
    real_t t145, t146, t147, t148, t149;
    if (t144) {
        const real_t t150 = tb_min(tb_max(t110, TB_TENSION_MIN), TB_TENSION_MAX);
        const real_t t151 = TB_C(1.0) / tb_max(t77 * t77 + t76 * t76, TB_EPSILON);
        const real_t t152 = t150 * t151;
        const real_t t153 = t80 * t152;
        const real_t t154 = t61 * t77 + t54 * t76;
        const real_t t155 = t109 - t108;
        const bool t156 = TB_ABS(t155) <= t74;
        const real_t t157 = t107 * t152;
        const real_t t158 = TB_C(1.0) / t155;
        real_t t159, t160;
        if (t156) {
            t159 = -TB_C(1000000000000.0);
            t160 = TB_C(1000000000000.0);
        } else {
            const real_t t161 = (t46 - t157) * t158;
            const real_t t162 = t158 * (t67 - t157);
            t159 = tb_min(t161, t162);
            t160 = tb_max(t161, t162);
        }
        const bool t163 = TB_ABS(t79) <= t74;
        const real_t t164 = t78 * t152;
        const real_t t165 = TB_C(1.0) / t79;
        real_t t166, t167;
        if (t163) {
            t166 = -TB_C(1000000000000.0);
            t167 = TB_C(1000000000000.0);
        } else {
            const real_t t168 = (t46 - t164) * t165;
            const real_t t169 = t165 * (t67 - t164);
            t166 = tb_min(t168, t169);
            t167 = tb_max(t168, t169);
        }
        const bool t170 = TB_ABS(t154) <= t74;
        const real_t t171 = TB_C(1.0) / t154;
        real_t t172, t173;
        if (t170) {
            t172 = -TB_C(1000000000000.0);
            t173 = TB_C(1000000000000.0);
        } else {
            const real_t t174 = (t46 - t153) * t171;
            const real_t t175 = t171 * (t67 - t153);
            t172 = tb_min(t174, t175);
            t173 = tb_max(t174, t175);
        }
        const real_t t176 = tb_max(t166, t172);
        const real_t t177 = tb_min(t167, t173);
        const real_t t178 = tb_min(tb_max(TB_C(0.0), tb_max(t159, t176)), tb_min(t160, t177));
        real_t t179;
        if (TB_C(0.0) < TB_ABS(t178)) {
            const real_t t180 = t107 * t158;
            const real_t t181 = t78 * t165;
            const real_t t182 = t80 * t171;
            real_t t183;
            if (TB_C(0.0) < t178) {
                t183 = t176 < t159 ? t180 : (t172 < t166 ? t181 : t182);
            } else {
                t183 = t160 < t177 ? t180 : (t167 < t173 ? t181 : t182);
            }
            t179 = t178 * t183;
        } else {
            t179 = TB_C(0.0);
        }
        const real_t t184 = t110 < t150 ? t179 - t152 : t152 - t179;
        real_t t185;
        if (TB_C(0.0) < t184) {
            const real_t t186 = t170 ? TB_C(0.0) : t81 * TB_ABS(t171);
            const real_t t187 = t163 ? TB_C(0.0) : t81 * TB_ABS(t165);
            const real_t t188 = t156 ? TB_C(0.0) : t81 * TB_ABS(t158);
            const real_t t189 = tb_max(tb_max(t172 + t186, t166 + t187), t159 + t188);
            const real_t t190 = tb_min(tb_min(t173 - t186, t167 - t187), t160 - t188);
            t185 = t189 < t190 && t82 < t143 ? t184 : TB_C(0.0);
        } else {
            t185 = TB_C(0.0);
        }
        t145 = t153 + t154 * t178;
        t146 = t164 + t79 * t178;
        t147 = t157 + t155 * t178;
        t148 = t150;
        t149 = t185;
    } else {
        t145 = t111;
        t146 = t112;
        t147 = t113;
        t148 = t110;
        t149 = t114;
    }
    const real_t t191 = tb_min(tb_max(t145, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t tension_0 = t30 ? t191 : TB_TENSION_MIN;
    const real_t t192 = tb_min(tb_max(t146, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t tension_1 = t30 ? t192 : TB_TENSION_MIN;
    const real_t t193 = tb_min(tb_max(t147, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t tension_2 = t30 ? t193 : TB_TENSION_MIN;
    const real_t t194 = tb_min(tb_max(t148, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t tension_3 = t30 ? t194 : TB_TENSION_MIN;
    const bool t195 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t196 = t195 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t197 = !t196;
    const real_t t198 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t199 = !(t198 < t34 && t198 < t43);
    const real_t t200 = TB_ABS(t9 * t192 - t3 * t191 + t14 * t193 - t19 * t194);
    const real_t t201 = t15 * t193 - (t8 * t191 + t7 * t192) + t18 * t194;
    const bool t202 = tb_max(tb_max(t149, t200), TB_ABS(t201)) <= t44 * (TB_EPSILON *
        TB_C(1280.0));
    const bool t203 = !(t31 || t202);
    if (t197 || t199) {
        return tb_refuse_zero_wrench_tension(TB_SINGULAR, tension);
    }
    if (t203) {
        return tb_refuse_zero_wrench_tension(TB_INACCURATE, tension);
    }
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    return t31 ? TB_INFEASIBLE : TB_OK;
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
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.024))) {
        return tb_refuse_tension_factor(TB_OUT_OF_DOMAIN, factor);
    }
    const real_t t0 = pose[0] * pose[0];
    const real_t t1 = pose[1] * pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 + t1);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t t3 = pose[0] * t2;
    const real_t t4 = TB_FRAME_X - pose[0];
    const real_t t5 = t4 * t4;
    const real_t length_1 = TB_SQRT(t1 + t5);
    const real_t t6 = TB_C(1.0) / length_1;
    const real_t t7 = pose[1] * t6;
    const real_t t8 = pose[1] * t2;
    const real_t t9 = t4 * t6;
    const real_t t10 = TB_ABS(t3 * t7 + t8 * t9);
    const real_t t11 = TB_FRAME_Y - pose[1];
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
    const real_t t21 = TB_TENSION_MIDDLE * (t14 + (t9 - t3) - t19);
    const real_t t22 = TB_TENSION_MIDDLE * (t18 + (t15 - (t7 + t8)));
    const real_t t23 = TB_TENSION_HALF_RANGE * (t10 + t16 + t20) - TB_ABS(t8 * t21 - t3 * t22);
    const real_t t24 = TB_ABS(t9 * t15 + t7 * t14);
    const real_t t25 = TB_ABS(t9 * t18 - t7 * t19);
    const real_t t26 = TB_TENSION_HALF_RANGE * (t10 + t24 + t25) - TB_ABS(t9 * t22 + t7 * t21);
    const real_t t27 = TB_ABS(t14 * t18 + t15 * t19);
    const real_t t28 = TB_TENSION_HALF_RANGE * (t16 + t24 + t27) - TB_ABS(t14 * t22 - t15 *
        t21);
    const real_t t29 = TB_TENSION_HALF_RANGE * (t27 + (t20 + t25)) - TB_ABS(t19 * t22 + t18 *
        t21);
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
    const real_t t44 = TB_TENSION_MIN - t43;
    const real_t t45 = TB_C(1.0) / (t40 * (t40 + TB_ABS(t37)));
    const real_t t46 = t38 * t45;
    const real_t t47 = TB_C(1.0) - t38 * t46;
    const real_t t48 = t41 - t37;
    const real_t t49 = t46 * t48;
    const real_t t50 = t39 * t46;
    const real_t t51 = t35 * (t14 * t47 - t9 * t49 + t19 * t50);
    const real_t t52 = t34 * t51;
    const real_t t53 = t49 + t9 * t51;
    const real_t t54 = t39 * t45;
    const real_t t55 = t48 * t54;
    const real_t t56 = t38 * t54;
    const real_t t57 = TB_C(1.0) - t39 * t54;
    const real_t t58 = t35 * (t9 * t55 + t14 * t56 + t19 * t57);
    const real_t t59 = t34 * t58;
    const real_t t60 = t9 * t58 - t55;
    const real_t t61 = t52 * t53 + t59 * t60;
    const real_t t62 = t43 < TB_TENSION_MIN ? TB_TENSION_MIN : TB_C(0.0);
    const real_t t63 = t62 / tb_max(t52 * t52 + t59 * t59, TB_EPSILON);
    const real_t t64 = t61 * t63;
    const real_t t65 = t43 + TB_TENSION_MAX;
    const bool t66 = TB_C(0.0) < tb_max(t44 - t64, t64 - t65);
    const real_t t67 = t14 * t58 - t56;
    const real_t t68 = t47 - t14 * t51;
    const real_t t69 = t60 * t67 - t53 * t68;
    const real_t t70 = t53 * t67 + t60 * t68;
    const real_t t71 = TB_EPSILON * TB_C(16.0);
    const real_t t72 = t59 * t67 - t52 * t68;
    const real_t t73 = t57 - t19 * t58;
    const real_t t74 = t19 * t51 - t50;
    const real_t t75 = t60 * t73 - t53 * t74;
    const real_t t76 = t53 * t73 + t60 * t74;
    const real_t t77 = t59 * t73 - t52 * t74;
    real_t t78, t79, t80, t81;
    if (t66) {
        const real_t t82 = tb_min(tb_max(t64, TB_TENSION_MIN), TB_TENSION_MAX);
        const real_t t83 = TB_C(1.0) / tb_max(t53 * t53 + t60 * t60, TB_EPSILON);
        const real_t t84 = t82 * t83;
        const real_t t85 = t52 * t60 - t53 * t59;
        const bool t86 = TB_ABS(t85) <= t71;
        const real_t t87 = t61 * t84;
        real_t t88, t89;
        if (t86) {
            t88 = -TB_C(1000000000000.0);
            t89 = TB_C(1000000000000.0);
        } else {
            const real_t t90 = TB_C(1.0) / t85;
            const real_t t91 = (t44 - t87) * t90;
            const real_t t92 = t90 * (t65 - t87);
            t88 = tb_min(t91, t92);
            t89 = tb_max(t91, t92);
        }
        const real_t t93 = tb_min(tb_max(TB_C(0.0), t88), t89);
        t78 = t69 * t84 - t70 * t93;
        t79 = t84 * t75 - t93 * t76;
        t80 = t87 + t85 * t93;
        t81 = t82;
    } else {
        t78 = t63 * t72;
        t79 = t63 * t77;
        t80 = t62;
        t81 = t64;
    }
    const bool t94 = TB_C(0.0) < tb_max(t44 - t78, t78 - t65);
    const real_t t95 = t68 * t74 + t67 * t73;
    const real_t t96 = t68 * t73;
    const real_t t97 = t67 * t74;
    real_t t98, t99, t100, t101;
    if (t94) {
        const real_t t102 = tb_min(tb_max(t78, TB_TENSION_MIN), TB_TENSION_MAX);
        const real_t t103 = TB_C(1.0) / tb_max(t68 * t68 + t67 * t67, TB_EPSILON);
        const real_t t104 = t102 * t103;
        const bool t105 = TB_ABS(t70) <= t71;
        const real_t t106 = t69 * t104;
        real_t t107, t108;
        if (t105) {
            t107 = -TB_C(1000000000000.0);
            t108 = TB_C(1000000000000.0);
        } else {
            const real_t t109 = TB_C(1.0) / t70;
            const real_t t110 = (t44 - t106) * t109;
            const real_t t111 = t109 * (t65 - t106);
            t107 = tb_min(t110, t111);
            t108 = tb_max(t110, t111);
        }
        const real_t t112 = t59 * t68 + t52 * t67;
        const bool t113 = TB_ABS(t112) <= t71;
        const real_t t114 = t72 * t104;
        real_t t115, t116;
        if (t113) {
            t115 = -TB_C(1000000000000.0);
            t116 = TB_C(1000000000000.0);
        } else {
            const real_t t117 = TB_C(1.0) / t112;
            const real_t t118 = (t44 - t114) * t117;
            const real_t t119 = t117 * (t65 - t114);
            t115 = tb_min(t118, t119);
            t116 = tb_max(t118, t119);
        }
        const real_t t120 = tb_min(tb_max(TB_C(0.0), tb_max(t107, t115)), tb_min(t108, t116));
        t98 = t95 * t104 + (t96 - t97) * t120;
        t99 = t114 + t112 * t120;
        t100 = t106 + t70 * t120;
        t101 = t102;
    } else {
        t98 = t79;
        t99 = t80;
        t100 = t81;
        t101 = t78;
    }
    const bool t121 = TB_C(0.0) < tb_max(t44 - t98, t98 - t65);
    real_t t122, t123, t124, t125;
    if (t121) {
        const real_t t126 = tb_min(tb_max(t98, TB_TENSION_MIN), TB_TENSION_MAX);
        const real_t t127 = TB_C(1.0) / tb_max(t74 * t74 + t73 * t73, TB_EPSILON);
        const real_t t128 = t126 * t127;
        const real_t t129 = t77 * t128;
        const real_t t130 = t59 * t74 + t52 * t73;
        const real_t t131 = t97 - t96;
        const bool t132 = TB_ABS(t131) <= t71;
        const real_t t133 = t95 * t128;
        real_t t134, t135;
        if (t132) {
            t134 = -TB_C(1000000000000.0);
            t135 = TB_C(1000000000000.0);
        } else {
            const real_t t136 = TB_C(1.0) / t131;
            const real_t t137 = (t44 - t133) * t136;
            const real_t t138 = t136 * (t65 - t133);
            t134 = tb_min(t137, t138);
            t135 = tb_max(t137, t138);
        }
        const bool t139 = TB_ABS(t76) <= t71;
        const real_t t140 = t75 * t128;
        real_t t141, t142;
        if (t139) {
            t141 = -TB_C(1000000000000.0);
            t142 = TB_C(1000000000000.0);
        } else {
            const real_t t143 = TB_C(1.0) / t76;
            const real_t t144 = (t44 - t140) * t143;
            const real_t t145 = t143 * (t65 - t140);
            t141 = tb_min(t144, t145);
            t142 = tb_max(t144, t145);
        }
        const bool t146 = TB_ABS(t130) <= t71;
        real_t t147, t148;
        if (t146) {
            t147 = -TB_C(1000000000000.0);
            t148 = TB_C(1000000000000.0);
        } else {
            const real_t t149 = TB_C(1.0) / t130;
            const real_t t150 = (t44 - t129) * t149;
            const real_t t151 = t149 * (t65 - t129);
            t147 = tb_min(t150, t151);
            t148 = tb_max(t150, t151);
        }
        const real_t t152 = tb_max(TB_C(0.0), tb_max(t134, tb_max(t141, t147)));
        const real_t t153 = tb_min(t152, tb_min(t135, tb_min(t142, t148)));
        t122 = t129 + t130 * t153;
        t123 = t140 + t76 * t153;
        t124 = t133 + t131 * t153;
        t125 = t126;
    } else {
        t122 = t99;
        t123 = t100;
        t124 = t101;
        t125 = t98;
    }
    /* T0 */
    const real_t rest_0 = tb_min(tb_max(t122, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t rest_1 = tb_min(tb_max(t123, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t rest_2 = tb_min(tb_max(t124, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t rest_3 = tb_min(tb_max(t125, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t t154 = tb_max(tb_max(tb_max(rest_0, rest_1), rest_2), rest_3);
    real_t factor_0;
    if (t30) {
        const real_t t155 = tb_min(tb_min(tb_min(rest_0, rest_1), rest_2), rest_3);
        factor_0 = t155 / t154;
    } else {
        factor_0 = TB_C(0.0);
    }
    const bool t156 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t157 = t156 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t158 = !t157;
    const real_t t159 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t160 = !(t159 < t33 && t159 < t42);
    const bool t161 = !(TB_C(0.0) < t154);
    const bool t162 = !t30;
    if (t158 || t160 || t161) {
        return tb_refuse_tension_factor(TB_SINGULAR, factor);
    }
    factor[0] = factor_0;
    return t162 ? TB_INFEASIBLE : TB_OK;
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
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.024))) {
        return tb_refuse_isotropic_force(TB_OUT_OF_DOMAIN, force);
    }
    const real_t t0 = pose[0] * pose[0];
    const real_t t1 = pose[1] * pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 + t1);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t t3 = pose[0] * t2;
    const real_t t4 = TB_FRAME_X - pose[0];
    const real_t t5 = t4 * t4;
    const real_t length_1 = TB_SQRT(t1 + t5);
    const real_t t6 = TB_C(1.0) / length_1;
    const real_t t7 = pose[1] * t6;
    const real_t t8 = pose[1] * t2;
    const real_t t9 = t4 * t6;
    const real_t t10 = TB_ABS(t3 * t7 + t8 * t9);
    const real_t t11 = TB_FRAME_Y - pose[1];
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
    const real_t t21 = TB_TENSION_MIDDLE * (t14 + (t9 - t3) - t19);
    const real_t t22 = TB_TENSION_MIDDLE * (t18 + (t15 - (t7 + t8)));
    const real_t t23 = TB_TENSION_HALF_RANGE * (t10 + t16 + t20) - TB_ABS(t8 * t21 - t3 * t22);
    const real_t t24 = TB_ABS(t9 * t15 + t7 * t14);
    const real_t t25 = TB_ABS(t9 * t18 - t7 * t19);
    const real_t t26 = TB_TENSION_HALF_RANGE * (t10 + t24 + t25) - TB_ABS(t9 * t22 + t7 * t21);
    const real_t t27 = TB_ABS(t14 * t18 + t15 * t19);
    const real_t t28 = TB_TENSION_HALF_RANGE * (t16 + t24 + t27) - TB_ABS(t14 * t22 - t15 *
        t21);
    const real_t t29 = TB_TENSION_HALF_RANGE * (t27 + (t20 + t25)) - TB_ABS(t19 * t22 + t18 *
        t21);
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
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.024))) {
        return tb_refuse_pose_quality(TB_OUT_OF_DOMAIN, margin, factor, force);
    }
    const real_t t0 = pose[0] * pose[0];
    const real_t t1 = pose[1] * pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 + t1);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t t3 = pose[0] * t2;
    const real_t t4 = TB_FRAME_X - pose[0];
    const real_t t5 = t4 * t4;
    const real_t length_1 = TB_SQRT(t1 + t5);
    const real_t t6 = TB_C(1.0) / length_1;
    const real_t t7 = pose[1] * t6;
    const real_t t8 = pose[1] * t2;
    const real_t t9 = t4 * t6;
    const real_t t10 = t3 * t7 + t8 * t9;
    const real_t t11 = TB_ABS(t10);
    const real_t t12 = TB_FRAME_Y - pose[1];
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
    const real_t t24 = TB_TENSION_MIDDLE * (t15 + (t9 - t3) - t21);
    const real_t t25 = TB_TENSION_MIDDLE * (t20 + (t16 - (t7 + t8)));
    const real_t t26 = t8 * t24 - t3 * t25;
    const real_t t27 = t9 * t16 + t7 * t15;
    const real_t t28 = TB_ABS(t27);
    const real_t t29 = t9 * t20 - t7 * t21;
    const real_t t30 = TB_ABS(t29);
    const real_t t31 = t9 * t25 + t7 * t24;
    const real_t t32 = tb_min(TB_TENSION_HALF_RANGE * (t11 + t18 + t23) - TB_ABS(t26),
        TB_TENSION_HALF_RANGE * (t11 + t28 + t30) - TB_ABS(t31));
    const real_t t33 = t15 * t20 + t16 * t21;
    const real_t t34 = TB_ABS(t33);
    const real_t t35 = t15 * t25 - t16 * t24;
    const real_t t36 = tb_min(t32, TB_TENSION_HALF_RANGE * (t18 + t28 + t34) - TB_ABS(t35));
    const real_t t37 = t21 * t25 + t20 * t24;
    const real_t margin_0 = tb_min(t36, TB_TENSION_HALF_RANGE * (t34 + (t23 + t30)) -
        TB_ABS(t37));
    const bool t38 = TB_C(0.0) <= margin_0;
    real_t factor_0, t39;
    if (t38) {
        const real_t t40 = TB_C(0.46153846153846156) * tb_max(TB_ABS(t24), TB_ABS(t25));
        const real_t t41 = TB_C(120.0) * TB_EPSILON;
        const bool t42 = t40 <= t41;
        const real_t t43 = -t3;
        real_t t44, t45, t46, t47, t48, t49, t50, t51, t52, t53;
        if (t42) {
            t44 = TB_C(0.0);
            t45 = TB_C(0.0);
            t46 = TB_C(0.0);
            t47 = TB_C(0.0);
            t48 = TB_C(0.0);
            t49 = TB_C(0.0);
            t50 = TB_C(0.0);
            t51 = TB_C(0.0);
            t52 = TB_C(0.0);
            t53 = TB_C(0.0);
        } else {
            const real_t t54 = t3 * t24 + t8 * t25;
            const real_t t55 = TB_C(0.0) <= t26 ? t54 : -TB_C(1e+30);
            const real_t t56 = t7 * t25 - t9 * t24;
            const real_t t57 = TB_C(0.0) <= t31 ? t56 : -TB_C(1e+30);
            const real_t t58 = tb_max(t55, t57);
            const real_t t59 = -(t15 * t24 + t16 * t25);
            const real_t t60 = TB_C(0.0) <= t35 ? t59 : -TB_C(1e+30);
            const real_t t61 = -t37;
            const real_t t62 = t21 * t24 - t20 * t25;
            const bool t63 = tb_max(t58, t60) < (TB_C(0.0) <= t61 ? t62 : -TB_C(1e+30));
            const real_t t64 = -t21;
            const real_t t65 = -t7;
            const real_t t66 = -t8;
            real_t t67, t68;
            if (t63) {
                t67 = t64;
                t68 = t20;
            } else {
                const bool t69 = t58 < t60;
                const bool t70 = t55 < t57;
                t67 = t69 ? t15 : (t70 ? t9 : t43);
                t68 = t69 ? t16 : (t70 ? t65 : t66);
            }
            const real_t t71 = TB_C(0.46153846153846156) * (t25 * t67 - t24 * t68);
            const real_t t72 = t26 < TB_C(0.0) ? t54 : -TB_C(1e+30);
            const real_t t73 = t31 < TB_C(0.0) ? t56 : -TB_C(1e+30);
            const real_t t74 = tb_max(t72, t73);
            const real_t t75 = t35 < TB_C(0.0) ? t59 : -TB_C(1e+30);
            const bool t76 = tb_max(t74, t75) < (t61 < TB_C(0.0) ? t62 : -TB_C(1e+30));
            real_t t77, t78;
            if (t76) {
                t77 = t64;
                t78 = t20;
            } else {
                const bool t79 = t74 < t75;
                const bool t80 = t72 < t73;
                t77 = t79 ? t15 : (t80 ? t9 : t43);
                t78 = t79 ? t16 : (t80 ? t65 : t66);
            }
            const real_t t81 = TB_C(1.0) / (t68 * t77 - t67 * t78);
            const real_t t82 = TB_TENSION_MIN + t71 * t81;
            const real_t t83 = TB_C(0.46153846153846156) * (t25 * t77 - t24 * t78);
            const real_t t84 = TB_TENSION_MIN - t81 * t83;
            const real_t t85 = t81 * (t68 * t82 - t78 * t84);
            const real_t t86 = t81 * (t77 * t84 - t67 * t82);
            t44 = t9 * t85;
            t45 = -(t7 * t86);
            t46 = -(t3 * t85);
            t47 = -(t8 * t86);
            t48 = t15 * t85;
            t49 = t16 * t86;
            t50 = -(t21 * t85);
            t51 = t20 * t86;
            t52 = t85;
            t53 = t86;
        }
        const real_t t87 = t44 + t45;
        const real_t t88 = tb_min(tb_max(t87, TB_TENSION_MIN), TB_TENSION_MAX);
        const real_t t89 = t46 + t47;
        const real_t t90 = tb_min(tb_max(t89, TB_TENSION_MIN), TB_TENSION_MAX);
        const real_t t91 = t48 + t49;
        const real_t t92 = tb_min(tb_max(t91, TB_TENSION_MIN), TB_TENSION_MAX);
        const real_t t93 = t50 + t51;
        const real_t t94 = tb_min(tb_max(t93, TB_TENSION_MIN), TB_TENSION_MAX);
        const real_t t95 = t9 * t88 - t3 * t90 + t15 * t92 - t21 * t94;
        const real_t t96 = t16 * t92 - (t8 * t90 + t7 * t88) + t20 * t94;
        const bool t97 = tb_max(TB_ABS(t95), TB_ABS(t96)) - t41 <= TB_C(0.0);
        real_t t98, t99;
        if (t97) {
            const real_t t100 = tb_min(tb_min(tb_min(t90, t88), t92), t94) /
                tb_max(tb_max(tb_max(t90, t88), t92), t94);
            t98 = t100;
            t99 = TB_C(0.0);
        } else {
            const bool t101 = TB_TENSION_MIN < t89 && t89 < TB_TENSION_MAX;
            const real_t t102 = t3 * t3;
            const bool t103 = TB_TENSION_MIN < t87 && t87 < TB_TENSION_MAX;
            const real_t t104 = t9 * t9;
            const real_t t105 = (t101 ? t102 : TB_C(0.0)) + (t103 ? t104 : TB_C(0.0));
            const bool t106 = TB_TENSION_MIN < t91 && t91 < TB_TENSION_MAX;
            const real_t t107 = t15 * t15;
            const bool t108 = TB_TENSION_MIN < t93 && t93 < TB_TENSION_MAX;
            const real_t t109 = t21 * t21;
            const real_t t110 = t105 + (t106 ? t107 : TB_C(0.0)) + (t108 ? t109 : TB_C(0.0));
            const real_t t111 = TB_C(1.0) / t110;
            const real_t t112 = t7 * t9;
            const real_t t113 = (t101 ? t3 * t8 : TB_C(0.0)) + (t103 ? -t112 : TB_C(0.0));
            const real_t t114 = t15 * t16;
            const real_t t115 = t20 * t21;
            const real_t t116 = t113 + (t106 ? t114 : TB_C(0.0)) + (t108 ? -t115 : TB_C(0.0));
            const real_t t117 = t111 * t116;
            const real_t t118 = (t101 ? t8 * t8 : TB_C(0.0)) + (t103 ? t7 * t7 : TB_C(0.0));
            const real_t t119 = t118 + (t106 ? t16 * t16 : TB_C(0.0)) + (t108 ? t20 * t20 :
                TB_C(0.0));
            const real_t t120 = (t96 - t95 * t117) / (t119 - t110 * (t117 * t117));
            const real_t t121 = t52 - (t95 * t111 - t117 * t120);
            const real_t t122 = t53 - t120;
            const real_t t123 = tb_min(tb_max(t9 * t121 - t7 * t122, TB_TENSION_MIN),
                TB_TENSION_MAX);
            const real_t t124 = tb_min(tb_max(-(t3 * t121 + t8 * t122), TB_TENSION_MIN),
                TB_TENSION_MAX);
            const real_t t125 = tb_min(tb_max(t15 * t121 + t16 * t122, TB_TENSION_MIN),
                TB_TENSION_MAX);
            const real_t t126 = tb_min(tb_max(t20 * t122 - t21 * t121, TB_TENSION_MIN),
                TB_TENSION_MAX);
            const real_t t127 = TB_ABS(t9 * t123 - t3 * t124 + t15 * t125 - t21 * t126);
            const real_t t128 = t16 * t125 - (t8 * t124 + t7 * t123) + t20 * t126;
            const bool t129 = tb_max(t127, TB_ABS(t128)) - t41 <= TB_C(0.0);
            real_t t130, t131;
            if (t129) {
                const real_t t132 = tb_min(tb_min(tb_min(t124, t123), t125), t126) /
                    tb_max(tb_max(tb_max(t124, t123), t125), t126);
                t130 = t132;
                t131 = TB_C(0.0);
            } else {
                const real_t t133 = TB_SQRT(t109 + (t107 + (t102 + t104)));
                const real_t t134 = TB_COPYSIGN(t133, t43);
                const real_t t135 = t134 - t3;
                const real_t t136 = TB_C(1.0) / (t133 * (t133 + TB_ABS(t3)));
                const real_t t137 = (t114 - (t112 + t8 * t135) - t115) * t136;
                const real_t t138 = t7 + t9 * t137;
                const real_t t139 = t16 - t15 * t137;
                const real_t t140 = t20 + t21 * t137;
                const real_t t141 = TB_SQRT(t138 * t138 + t139 * t139 + t140 * t140);
                const real_t t142 = TB_COPYSIGN(t141, -t138);
                const real_t t143 = TB_C(1.0) / tb_min(TB_ABS(t134), TB_ABS(t142));
                const real_t t144 = TB_EPSILON * TB_C(30.0) * t143;
                const real_t t145 = TB_TENSION_MIN - t144;
                const real_t t146 = TB_C(1.0) / (t141 * (t141 + TB_ABS(t138)));
                const real_t t147 = t139 * t146;
                const real_t t148 = TB_C(1.0) - t139 * t147;
                const real_t t149 = t142 - t138;
                const real_t t150 = t147 * t149;
                const real_t t151 = t140 * t147;
                const real_t t152 = t136 * (t15 * t148 - t9 * t150 + t21 * t151);
                const real_t t153 = t135 * t152;
                const real_t t154 = t150 + t9 * t152;
                const real_t t155 = t140 * t146;
                const real_t t156 = t149 * t155;
                const real_t t157 = t139 * t155;
                const real_t t158 = TB_C(1.0) - t140 * t155;
                const real_t t159 = t136 * (t9 * t156 + t15 * t157 + t21 * t158);
                const real_t t160 = t135 * t159;
                const real_t t161 = t9 * t159 - t156;
                const real_t t162 = t153 * t154 + t160 * t161;
                const real_t t163 = t144 < TB_TENSION_MIN ? TB_TENSION_MIN : TB_C(0.0);
                const real_t t164 = t163 / tb_max(t153 * t153 + t160 * t160, TB_EPSILON);
                const real_t t165 = t162 * t164;
                const real_t t166 = TB_TENSION_MAX + t144;
                const real_t t167 = tb_max(t145 - t165, t165 - t166);
                const bool t168 = TB_C(0.0) < t167;
                const real_t t169 = t15 * t159 - t157;
                const real_t t170 = t148 - t15 * t152;
                const real_t t171 = t161 * t169 - t154 * t170;
                const real_t t172 = t154 * t169 + t161 * t170;
                const real_t t173 = TB_EPSILON * TB_C(16.0);
                const real_t t174 = t160 * t169 - t153 * t170;
                const real_t t175 = t158 - t21 * t159;
                const real_t t176 = t21 * t152 - t151;
                const real_t t177 = t161 * t175 - t154 * t176;
                const real_t t178 = t154 * t175 + t161 * t176;
                const real_t t179 = t160 * t175 - t153 * t176;
                const real_t t180 = t144 * TB_C(2.0);
                const real_t t181 = t144 * TB_C(1024.0);
                real_t t182, t183, t184, t185, t186;
                if (t168) {
                    const real_t t187 = tb_min(tb_max(t165, TB_TENSION_MIN), TB_TENSION_MAX);
                    const real_t t188 = TB_C(1.0) / tb_max(t154 * t154 + t161 * t161,
                        TB_EPSILON);
                    const real_t t189 = t187 * t188;
                    const real_t t190 = t153 * t161 - t154 * t160;
                    const bool t191 = TB_ABS(t190) <= t173;
                    const real_t t192 = t162 * t189;
                    const real_t t193 = TB_C(1.0) / t190;
                    real_t t194, t195;
                    if (t191) {
                        t194 = -TB_C(1000000000000.0);
                        t195 = TB_C(1000000000000.0);
                    } else {
                        const real_t t196 = (t145 - t192) * t193;
                        const real_t t197 = t193 * (t166 - t192);
                        t194 = tb_min(t196, t197);
                        t195 = tb_max(t196, t197);
                    }
                    const real_t t198 = tb_min(tb_max(TB_C(0.0), t194), t195);
                    const real_t t199 = TB_C(0.0) < TB_ABS(t198) ? t198 * (t162 * t193) :
                        TB_C(0.0);
                    const real_t t200 = t165 < t187 ? t199 - t189 : t189 - t199;
                    real_t t201;
                    if (TB_C(0.0) < t200) {
                        const real_t t202 = t191 ? TB_C(0.0) : t180 * TB_ABS(t193);
                        const real_t t203 = t194 + t202 < t195 - t202 && t181 < t167 ? t200 :
                            TB_C(0.0);
                        t201 = t203;
                    } else {
                        t201 = TB_C(0.0);
                    }
                    t182 = t171 * t189 - t172 * t198;
                    t183 = t189 * t177 - t198 * t178;
                    t184 = t192 + t190 * t198;
                    t185 = t187;
                    t186 = t201;
                } else {
                    t182 = t164 * t174;
                    t183 = t164 * t179;
                    t184 = t163;
                    t185 = t165;
                    t186 = TB_C(0.0);
                }
                const real_t t204 = tb_max(t145 - t182, t182 - t166);
                const bool t205 = TB_C(0.0) < t204;
                const real_t t206 = t170 * t176 + t169 * t175;
                const real_t t207 = t170 * t175;
                const real_t t208 = t169 * t176;
                real_t t209, t210, t211, t212, t213;
                if (t205) {
                    const real_t t214 = tb_min(tb_max(t182, TB_TENSION_MIN), TB_TENSION_MAX);
                    const real_t t215 = TB_C(1.0) / tb_max(t170 * t170 + t169 * t169,
                        TB_EPSILON);
                    const real_t t216 = t214 * t215;
                    const bool t217 = TB_ABS(t172) <= t173;
                    const real_t t218 = t171 * t216;
                    const real_t t219 = TB_C(1.0) / t172;
                    real_t t220, t221;
                    if (t217) {
                        t220 = -TB_C(1000000000000.0);
                        t221 = TB_C(1000000000000.0);
                    } else {
                        const real_t t222 = (t145 - t218) * t219;
                        const real_t t223 = t219 * (t166 - t218);
                        t220 = tb_min(t222, t223);
                        t221 = tb_max(t222, t223);
                    }
                    const real_t t224 = t160 * t170 + t153 * t169;
                    const bool t225 = TB_ABS(t224) <= t173;
                    const real_t t226 = t174 * t216;
                    const real_t t227 = TB_C(1.0) / t224;
                    real_t t228, t229;
                    if (t225) {
                        t228 = -TB_C(1000000000000.0);
                        t229 = TB_C(1000000000000.0);
                    } else {
                        const real_t t230 = (t145 - t226) * t227;
                        const real_t t231 = t227 * (t166 - t226);
                        t228 = tb_min(t230, t231);
                        t229 = tb_max(t230, t231);
                    }
                    const real_t t232 = tb_min(tb_max(TB_C(0.0), tb_max(t220, t228)),
                        tb_min(t221, t229));
                    real_t t233;
                    if (TB_C(0.0) < TB_ABS(t232)) {
                        const real_t t234 = t171 * t219;
                        const real_t t235 = t174 * t227;
                        const real_t t236 = TB_C(0.0) < t232 ? (t228 < t220 ? t234 : t235) :
                            (t221 < t229 ? t234 : t235);
                        t233 = t232 * t236;
                    } else {
                        t233 = TB_C(0.0);
                    }
                    const real_t t237 = t182 < t214 ? t233 - t216 : t216 - t233;
                    real_t t238;
                    if (TB_C(0.0) < t237) {
                        const real_t t239 = t225 ? TB_C(0.0) : t180 * TB_ABS(t227);
                        const real_t t240 = t217 ? TB_C(0.0) : t180 * TB_ABS(t219);
                        const bool t241 = tb_max(t228 + t239, t220 + t240) < tb_min(t229 -
                            t239, t221 - t240);
                        t238 = t241 && t181 < t204 ? t237 : TB_C(0.0);
                    } else {
                        t238 = TB_C(0.0);
                    }
                    t209 = t206 * t216 + (t207 - t208) * t232;
                    t210 = t226 + t224 * t232;
                    t211 = t218 + t172 * t232;
                    t212 = t214;
                    t213 = t238;
                } else {
                    t209 = t183;
                    t210 = t184;
                    t211 = t185;
                    t212 = t182;
                    t213 = t186;
                }
                const real_t t242 = tb_max(t145 - t209, t209 - t166);
                const bool t243 = TB_C(0.0) < t242;
                real_t t244, t245, t246, t247, t248;
                if (t243) {
                    const real_t t249 = tb_min(tb_max(t209, TB_TENSION_MIN), TB_TENSION_MAX);
                    const real_t t250 = TB_C(1.0) / tb_max(t176 * t176 + t175 * t175,
                        TB_EPSILON);
                    const real_t t251 = t249 * t250;
                    const real_t t252 = t179 * t251;
                    const real_t t253 = t160 * t176 + t153 * t175;
                    const real_t t254 = t208 - t207;
                    const bool t255 = TB_ABS(t254) <= t173;
                    const real_t t256 = t206 * t251;
                    const real_t t257 = TB_C(1.0) / t254;
                    real_t t258, t259;
                    if (t255) {
                        t258 = -TB_C(1000000000000.0);
                        t259 = TB_C(1000000000000.0);
                    } else {
                        const real_t t260 = (t145 - t256) * t257;
                        const real_t t261 = t257 * (t166 - t256);
                        t258 = tb_min(t260, t261);
                        t259 = tb_max(t260, t261);
                    }
                    const bool t262 = TB_ABS(t178) <= t173;
                    const real_t t263 = t177 * t251;
                    const real_t t264 = TB_C(1.0) / t178;
                    real_t t265, t266;
                    if (t262) {
                        t265 = -TB_C(1000000000000.0);
                        t266 = TB_C(1000000000000.0);
                    } else {
                        const real_t t267 = (t145 - t263) * t264;
                        const real_t t268 = t264 * (t166 - t263);
                        t265 = tb_min(t267, t268);
                        t266 = tb_max(t267, t268);
                    }
                    const bool t269 = TB_ABS(t253) <= t173;
                    const real_t t270 = TB_C(1.0) / t253;
                    real_t t271, t272;
                    if (t269) {
                        t271 = -TB_C(1000000000000.0);
                        t272 = TB_C(1000000000000.0);
                    } else {
                        const real_t t273 = (t145 - t252) * t270;
                        const real_t t274 = t270 * (t166 - t252);
                        t271 = tb_min(t273, t274);
                        t272 = tb_max(t273, t274);
                    }
                    const real_t t275 = tb_max(t265, t271);
                    const real_t t276 = tb_min(t266, t272);
                    const real_t t277 = tb_min(tb_max(TB_C(0.0), tb_max(t258, t275)),
                        tb_min(t259, t276));
                    real_t t278;
                    if (TB_C(0.0) < TB_ABS(t277)) {
                        const real_t t279 = t206 * t257;
                        const real_t t280 = t177 * t264;
                        const real_t t281 = t179 * t270;
                        real_t t282;
                        if (TB_C(0.0) < t277) {
                            t282 = t275 < t258 ? t279 : (t271 < t265 ? t280 : t281);
                        } else {
                            t282 = t259 < t276 ? t279 : (t266 < t272 ? t280 : t281);
                        }
                        t278 = t277 * t282;
                    } else {
                        t278 = TB_C(0.0);
                    }
                    const real_t t283 = t209 < t249 ? t278 - t251 : t251 - t278;
                    real_t t284;
                    if (TB_C(0.0) < t283) {
                        const real_t t285 = t269 ? TB_C(0.0) : t180 * TB_ABS(t270);
                        const real_t t286 = t262 ? TB_C(0.0) : t180 * TB_ABS(t264);
                        const real_t t287 = t255 ? TB_C(0.0) : t180 * TB_ABS(t257);
                        const real_t t288 = tb_max(tb_max(t271 + t285, t265 + t286), t258 +
                            t287);
                        const real_t t289 = tb_min(tb_min(t272 - t285, t266 - t286), t259 -
                            t287);
                        t284 = t288 < t289 && t181 < t242 ? t283 : TB_C(0.0);
                    } else {
                        t284 = TB_C(0.0);
                    }
                    t244 = t252 + t253 * t277;
                    t245 = t263 + t178 * t277;
                    t246 = t256 + t254 * t277;
                    t247 = t249;
                    t248 = t284;
                } else {
                    t244 = t210;
                    t245 = t211;
                    t246 = t212;
                    t247 = t209;
                    t248 = t213;
                }
                const real_t t290 = tb_min(tb_max(t244, TB_TENSION_MIN), TB_TENSION_MAX);
                const real_t t291 = tb_min(tb_max(t245, TB_TENSION_MIN), TB_TENSION_MAX);
                const real_t t292 = tb_min(tb_max(t246, TB_TENSION_MIN), TB_TENSION_MAX);
                const real_t t293 = tb_min(tb_max(t247, TB_TENSION_MIN), TB_TENSION_MAX);
                const real_t t294 = tb_min(tb_min(tb_min(t290, t291), t292), t293) /
                    tb_max(tb_max(tb_max(t290, t291), t292), t293);
                const real_t t295 = TB_ABS(t9 * t291 - t3 * t290 + t15 * t292 - t21 * t293);
                const real_t t296 = t16 * t292 - (t8 * t290 + t7 * t291) + t20 * t293;
                const real_t t297 = tb_max(tb_max(t248, t295), TB_ABS(t296)) - t143 *
                    (TB_EPSILON * TB_C(1280.0));
                t130 = t294;
                t131 = t297;
            }
            t98 = t130;
            t99 = t131;
        }
        factor_0 = t98;
        t39 = t99;
    } else {
        factor_0 = TB_C(0.0);
        t39 = TB_C(0.0);
    }
    const real_t force_0 = tb_max(TB_C(0.0), margin_0);
    const bool t298 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t299 = t298 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t300 = !t299;
    const real_t t301 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const real_t t302 = t10 * t10 + t17 * t17 + t22 * t22 + t27 * t27 + t29 * t29;
    const bool t303 = !(t301 * t301 < (t302 + t33 * t33) * TB_C(0.5));
    const bool t304 = !(t39 <= TB_C(0.0));
    const bool t305 = !t38;
    if (t300 || t303) {
        return tb_refuse_pose_quality(TB_SINGULAR, margin, factor, force);
    }
    if (t304) {
        return tb_refuse_pose_quality(TB_INACCURATE, margin, factor, force);
    }
    margin[0] = margin_0;
    factor[0] = factor_0;
    force[0] = force_0;
    return t305 ? TB_INFEASIBLE : TB_OK;
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
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.024))) {
        return tb_refuse_isotropic_force_eq17(TB_OUT_OF_DOMAIN, force);
    }
    const real_t t0 = pose[0] * pose[0];
    const real_t t1 = pose[1] * pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 + t1);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t t3 = pose[0] * t2;
    const real_t t4 = TB_FRAME_X - pose[0];
    const real_t t5 = t4 * t4;
    const real_t length_1 = TB_SQRT(t1 + t5);
    const real_t t6 = TB_C(1.0) / length_1;
    const real_t t7 = pose[1] * t6;
    const real_t t8 = pose[1] * t2;
    const real_t t9 = t4 * t6;
    const real_t t10 = t3 * t7 + t8 * t9;
    const real_t t11 = TB_ABS(t10);
    const real_t t12 = TB_FRAME_Y - pose[1];
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
    const real_t t26 = TB_TENSION_MIDDLE * (t15 + (t9 - t3) - t23);
    const real_t t27 = TB_TENSION_MIDDLE * (t22 + (t17 - (t7 + t8)));
    const real_t t28 = TB_TENSION_HALF_RANGE * (t11 + t20 + t25) - TB_ABS(t8 * t26 - t3 * t27);
    const real_t t29 = t9 * t17 + t7 * t15;
    const real_t t30 = TB_ABS(t29);
    const real_t t31 = t9 * t22;
    const real_t t32 = t7 * t23;
    const real_t t33 = t31 - t32;
    const real_t t34 = TB_ABS(t33);
    const real_t t35 = TB_TENSION_HALF_RANGE * (t11 + t30 + t34) - TB_ABS(t9 * t27 + t7 * t26);
    const real_t t36 = t15 * t22 + t17 * t23;
    const real_t t37 = TB_ABS(t36);
    const real_t t38 = TB_TENSION_HALF_RANGE * (t20 + t30 + t37) - TB_ABS(t15 * t27 - t17 *
        t26);
    const real_t t39 = TB_TENSION_HALF_RANGE * (t37 + (t25 + t34)) - TB_ABS(t23 * t27 + t22 *
        t26);
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
        const real_t t64 = TB_TENSION_MIN - t63;
        const real_t t65 = TB_C(1.0) / (t50 * (t50 + TB_ABS(t47)));
        const real_t t66 = t48 * t65;
        const real_t t67 = TB_C(1.0) - t48 * t66;
        const real_t t68 = t51 - t47;
        const real_t t69 = t66 * t68;
        const real_t t70 = t49 * t66;
        const real_t t71 = t45 * (t15 * t67 - t9 * t69 + t23 * t70);
        const real_t t72 = t44 * t71;
        const real_t t73 = t69 + t9 * t71;
        const real_t t74 = t49 * t65;
        const real_t t75 = t68 * t74;
        const real_t t76 = t48 * t74;
        const real_t t77 = TB_C(1.0) - t49 * t74;
        const real_t t78 = t45 * (t9 * t75 + t15 * t76 + t23 * t77);
        const real_t t79 = t44 * t78;
        const real_t t80 = t9 * t78 - t75;
        const real_t t81 = t72 * t73 + t79 * t80;
        const real_t t82 = t63 < TB_TENSION_MIN ? TB_TENSION_MIN : TB_C(0.0);
        const real_t t83 = t82 / tb_max(t72 * t72 + t79 * t79, TB_EPSILON);
        const real_t t84 = t81 * t83;
        const real_t t85 = TB_TENSION_MAX + t63;
        const bool t86 = TB_C(0.0) < tb_max(t64 - t84, t84 - t85);
        const real_t t87 = t15 * t78 - t76;
        const real_t t88 = t67 - t15 * t71;
        const real_t t89 = t80 * t87 - t73 * t88;
        const real_t t90 = t73 * t87 + t80 * t88;
        const real_t t91 = TB_EPSILON * TB_C(16.0);
        const real_t t92 = t79 * t87 - t72 * t88;
        const real_t t93 = t77 - t23 * t78;
        const real_t t94 = t23 * t71 - t70;
        const real_t t95 = t80 * t93 - t73 * t94;
        const real_t t96 = t73 * t93 + t80 * t94;
        const real_t t97 = t79 * t93 - t72 * t94;
        real_t t98, t99, t100, t101;
        if (t86) {
            const real_t t102 = tb_min(tb_max(t84, TB_TENSION_MIN), TB_TENSION_MAX);
            const real_t t103 = TB_C(1.0) / tb_max(t73 * t73 + t80 * t80, TB_EPSILON);
            const real_t t104 = t102 * t103;
            const real_t t105 = t72 * t80 - t73 * t79;
            const bool t106 = TB_ABS(t105) <= t91;
            const real_t t107 = t81 * t104;
            real_t t108, t109;
            if (t106) {
                t108 = -TB_C(1000000000000.0);
                t109 = TB_C(1000000000000.0);
            } else {
                const real_t t110 = TB_C(1.0) / t105;
                const real_t t111 = (t64 - t107) * t110;
                const real_t t112 = t110 * (t85 - t107);
                t108 = tb_min(t111, t112);
                t109 = tb_max(t111, t112);
            }
            const real_t t113 = tb_min(tb_max(TB_C(0.0), t108), t109);
            t98 = t89 * t104 - t90 * t113;
            t99 = t104 * t95 - t113 * t96;
            t100 = t107 + t105 * t113;
            t101 = t102;
        } else {
            t98 = t83 * t92;
            t99 = t83 * t97;
            t100 = t82;
            t101 = t84;
        }
        const bool t114 = TB_C(0.0) < tb_max(t64 - t98, t98 - t85);
        const real_t t115 = t88 * t94 + t87 * t93;
        const real_t t116 = t88 * t93;
        const real_t t117 = t87 * t94;
        real_t t118, t119, t120, t121;
        if (t114) {
            const real_t t122 = tb_min(tb_max(t98, TB_TENSION_MIN), TB_TENSION_MAX);
            const real_t t123 = TB_C(1.0) / tb_max(t88 * t88 + t87 * t87, TB_EPSILON);
            const real_t t124 = t122 * t123;
            const bool t125 = TB_ABS(t90) <= t91;
            const real_t t126 = t89 * t124;
            real_t t127, t128;
            if (t125) {
                t127 = -TB_C(1000000000000.0);
                t128 = TB_C(1000000000000.0);
            } else {
                const real_t t129 = TB_C(1.0) / t90;
                const real_t t130 = (t64 - t126) * t129;
                const real_t t131 = t129 * (t85 - t126);
                t127 = tb_min(t130, t131);
                t128 = tb_max(t130, t131);
            }
            const real_t t132 = t79 * t88 + t72 * t87;
            const bool t133 = TB_ABS(t132) <= t91;
            const real_t t134 = t92 * t124;
            real_t t135, t136;
            if (t133) {
                t135 = -TB_C(1000000000000.0);
                t136 = TB_C(1000000000000.0);
            } else {
                const real_t t137 = TB_C(1.0) / t132;
                const real_t t138 = (t64 - t134) * t137;
                const real_t t139 = t137 * (t85 - t134);
                t135 = tb_min(t138, t139);
                t136 = tb_max(t138, t139);
            }
            const real_t t140 = tb_min(tb_max(TB_C(0.0), tb_max(t127, t135)), tb_min(t128,
                t136));
            t118 = t115 * t124 + (t116 - t117) * t140;
            t119 = t134 + t132 * t140;
            t120 = t126 + t90 * t140;
            t121 = t122;
        } else {
            t118 = t99;
            t119 = t100;
            t120 = t101;
            t121 = t98;
        }
        const bool t141 = TB_C(0.0) < tb_max(t64 - t118, t118 - t85);
        real_t t142, t143, t144, t145;
        if (t141) {
            const real_t t146 = tb_min(tb_max(t118, TB_TENSION_MIN), TB_TENSION_MAX);
            const real_t t147 = TB_C(1.0) / tb_max(t94 * t94 + t93 * t93, TB_EPSILON);
            const real_t t148 = t146 * t147;
            const real_t t149 = t97 * t148;
            const real_t t150 = t79 * t94 + t72 * t93;
            const real_t t151 = t117 - t116;
            const bool t152 = TB_ABS(t151) <= t91;
            const real_t t153 = t115 * t148;
            real_t t154, t155;
            if (t152) {
                t154 = -TB_C(1000000000000.0);
                t155 = TB_C(1000000000000.0);
            } else {
                const real_t t156 = TB_C(1.0) / t151;
                const real_t t157 = (t64 - t153) * t156;
                const real_t t158 = t156 * (t85 - t153);
                t154 = tb_min(t157, t158);
                t155 = tb_max(t157, t158);
            }
            const bool t159 = TB_ABS(t96) <= t91;
            const real_t t160 = t95 * t148;
            real_t t161, t162;
            if (t159) {
                t161 = -TB_C(1000000000000.0);
                t162 = TB_C(1000000000000.0);
            } else {
                const real_t t163 = TB_C(1.0) / t96;
                const real_t t164 = (t64 - t160) * t163;
                const real_t t165 = t163 * (t85 - t160);
                t161 = tb_min(t164, t165);
                t162 = tb_max(t164, t165);
            }
            const bool t166 = TB_ABS(t150) <= t91;
            real_t t167, t168;
            if (t166) {
                t167 = -TB_C(1000000000000.0);
                t168 = TB_C(1000000000000.0);
            } else {
                const real_t t169 = TB_C(1.0) / t150;
                const real_t t170 = (t64 - t149) * t169;
                const real_t t171 = t169 * (t85 - t149);
                t167 = tb_min(t170, t171);
                t168 = tb_max(t170, t171);
            }
            const real_t t172 = tb_max(TB_C(0.0), tb_max(t154, tb_max(t161, t167)));
            const real_t t173 = tb_min(t172, tb_min(t155, tb_min(t162, t168)));
            t142 = t149 + t150 * t173;
            t143 = t160 + t96 * t173;
            t144 = t153 + t151 * t173;
            t145 = t146;
        } else {
            t142 = t119;
            t143 = t120;
            t144 = t121;
            t145 = t118;
        }
        /* t_i = T_max - T0_i */
        const real_t margin_0 = TB_TENSION_MAX - tb_min(tb_max(t142, TB_TENSION_MIN),
            TB_TENSION_MAX);
        const real_t margin_1 = TB_TENSION_MAX - tb_min(tb_max(t143, TB_TENSION_MIN),
            TB_TENSION_MAX);
        const real_t t174 = tb_min(margin_0, margin_1);
        const bool t175 = -(t3 * t15 + t8 * t17) < TB_C(0.0);
        const bool t176 = TB_C(0.0) < t29;
        const real_t t177 = -t36;
        const bool t178 = TB_C(0.0) < t177;
        const bool t179 = (t55 || (TB_C(0.0) <= t19 && t175)) && !((t53 && t176) || (t59 &&
            t178));
        const real_t margin_2 = TB_TENSION_MAX - tb_min(tb_max(t144, TB_TENSION_MIN),
            TB_TENSION_MAX);
        const real_t t180 = tb_min(margin_0, margin_2);
        const real_t t181 = tb_min(t62 ? (t54 ? t10 * t174 : t174) : TB_C(1e+30), t179 ? (t175
            ? t19 * t180 : t180) : TB_C(1e+30));
        const bool t182 = t3 * t23 - t8 * t22 < TB_C(0.0);
        const bool t183 = TB_C(0.0) < t33;
        const bool t184 = TB_C(0.0) < t36;
        const bool t185 = (t59 || (TB_C(0.0) <= t58 && t182)) && !((t53 && t183) || (t55 &&
            t184));
        const real_t margin_3 = TB_TENSION_MAX - tb_min(tb_max(t145, TB_TENSION_MIN),
            TB_TENSION_MAX);
        const real_t t186 = tb_min(margin_0, margin_3);
        const real_t t187 = t185 ? (t182 ? -(t24 * t186) : t186) : TB_C(1e+30);
        const real_t t188 = -t10;
        const bool t189 = TB_C(0.0) < t188;
        const real_t t190 = t18 - t16;
        const bool t191 = TB_C(0.0) < t190;
        const bool t192 = TB_C(0.0) < t24;
        const bool t193 = (t189 || (t54 && TB_C(0.0) <= t188)) && !((t176 && t191) || (t183 &&
            t192));
        const real_t t194 = tb_min(margin_1, margin_0);
        const real_t t195 = t193 ? (t54 ? -(t10 * t194) : t194) : TB_C(1e+30);
        const bool t196 = t9 * t15 - t7 * t17 < TB_C(0.0);
        const bool t197 = (t176 || (TB_C(0.0) <= t29 && t196)) && !((t55 && t189) || (t178 &&
            t183));
        const real_t t198 = tb_min(margin_1, margin_2);
        const real_t t199 = tb_min(tb_min(tb_min(t181, t187), t195), t197 ? (t196 ? t29 * t198
            : t198) : TB_C(1e+30));
        const bool t200 = -(t9 * t23 + t7 * t22) < TB_C(0.0);
        const bool t201 = (t183 || (TB_C(0.0) <= t33 && t200)) && !((t59 && t189) || (t176 &&
            t184));
        const real_t t202 = tb_min(margin_1, margin_3);
        const real_t t203 = tb_min(t199, t201 ? (t200 ? t33 * t202 : t202) : TB_C(1e+30));
        const bool t204 = (t191 || (t175 && TB_C(0.0) <= t190)) && !((t57 && t189) || (t184 &&
            t192));
        const real_t t205 = tb_min(margin_2, margin_0);
        const real_t t206 = t204 ? (t175 ? -(t19 * t205) : t205) : TB_C(1e+30);
        const bool t207 = (t57 || (t196 && TB_C(0.0) <= t56)) && !((t53 && t191) || (t61 &&
            t184));
        const real_t t208 = tb_min(margin_2, margin_1);
        const real_t t209 = t207 ? (t196 ? -(t29 * t208) : t208) : TB_C(1e+30);
        const bool t210 = t17 * t22 - t15 * t23 < TB_C(0.0);
        const bool t211 = (t184 || (TB_C(0.0) <= t36 && t210)) && !((t59 && t191) || (t57 &&
            t183));
        const real_t t212 = tb_min(margin_2, margin_3);
        const real_t t213 = tb_min(tb_min(tb_min(t203, t206), t209), t211 ? (t210 ? t36 * t212
            : t212) : TB_C(1e+30));
        const bool t214 = (t192 || (t182 && TB_C(0.0) <= t24)) && !((t61 && t189) || (t178 &&
            t191));
        const real_t t215 = tb_min(margin_3, margin_0);
        const real_t t216 = tb_min(t213, t214 ? (t182 ? t24 * t215 : t215) : TB_C(1e+30));
        const bool t217 = (t61 || (t200 && TB_C(0.0) <= t60)) && !((t53 && t192) || (t57 &&
            t178));
        const real_t t218 = tb_min(margin_3, margin_1);
        const real_t t219 = t217 ? (t200 ? -(t33 * t218) : t218) : TB_C(1e+30);
        const bool t220 = (t178 || (t210 && TB_C(0.0) <= t177)) && !((t55 && t192) || (t61 &&
            t176));
        const real_t t221 = tb_min(margin_3, margin_2);
        const real_t t222 = t220 ? (t210 ? -(t36 * t221) : t221) : TB_C(1e+30);
        force_0 = tb_min(tb_min(t216, t219), t222);
    } else {
        force_0 = TB_C(0.0);
    }
    const bool t223 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t224 = t223 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t225 = !t224;
    const real_t t226 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t227 = !(t226 < t43 && t226 < t52);
    const bool t228 = !t40;
    if (t225 || t227) {
        return tb_refuse_isotropic_force_eq17(TB_SINGULAR, force);
    }
    force[0] = force_0;
    return t228 ? TB_INFEASIBLE : TB_OK;
}

