/* Regenerate: turnbuckle generate machines/yoon2023.toml --out <this folder>
 * Machine 499338192b9e5092, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
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

tb_status tb_zero_wrench_tension(const real_t pose[2], const real_t rails[4], real_t tension[4])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) <=
              TB_C(5.6944))) {
        return tb_refuse_zero_wrench_tension(TB_OUT_OF_DOMAIN, tension);
    }
    const real_t t0 = rails[0] - pose[0];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 * t0 + pose[1] * pose[1]);
    const real_t t1 = TB_C(1.0) / length_0;
    const real_t t2 = t0 * t1;
    const real_t t3 = rails[1] - pose[1];
    const real_t t4 = TB_FRAME_X - pose[0];
    const real_t length_1 = TB_SQRT(t4 * t4 + t3 * t3);
    const real_t t5 = TB_C(1.0) / length_1;
    const real_t t6 = t3 * t5;
    const real_t t7 = pose[1] * t1;
    const real_t t8 = t4 * t5;
    const real_t t9 = TB_ABS(t2 * t6 + t7 * t8);
    const real_t t10 = TB_FRAME_Y - pose[1];
    const real_t t11 = rails[2] - pose[0];
    const real_t length_2 = TB_SQRT(t11 * t11 + t10 * t10);
    const real_t t12 = TB_C(1.0) / length_2;
    const real_t t13 = t10 * t12;
    const real_t t14 = t11 * t12;
    const real_t t15 = TB_ABS(t2 * t13 + t7 * t14);
    const real_t t16 = rails[3] - pose[1];
    const real_t length_3 = TB_SQRT(pose[0] * pose[0] + t16 * t16);
    const real_t t17 = TB_C(1.0) / length_3;
    const real_t t18 = t16 * t17;
    const real_t t19 = pose[0] * t17;
    const real_t t20 = TB_ABS(t2 * t18 - t7 * t19);
    const real_t t21 = TB_TENSION_MIDDLE * (t18 + (t13 + (t6 - t7)));
    const real_t t22 = TB_TENSION_MIDDLE * (t14 + (t2 + t8) - t19);
    const real_t t23 = TB_TENSION_HALF_RANGE * (t9 + t15 + t20) - TB_ABS(t2 * t21 + t7 * t22);
    const real_t t24 = TB_ABS(t8 * t13 - t6 * t14);
    const real_t t25 = TB_ABS(t8 * t18 + t6 * t19);
    const real_t t26 = TB_TENSION_HALF_RANGE * (t9 + t24 + t25) - TB_ABS(t8 * t21 - t6 * t22);
    const real_t t27 = TB_ABS(t14 * t18 + t13 * t19);
    const real_t t28 = TB_TENSION_HALF_RANGE * (t15 + t24 + t27) - TB_ABS(t14 * t21 - t13 *
        t22);
    const real_t t29 = TB_TENSION_HALF_RANGE * (t27 + (t20 + t25)) - TB_ABS(t19 * t21 + t18 *
        t22);
    const bool t30 = TB_C(0.0) <= tb_min(tb_min(tb_min(t23, t26), t28), t29);
    const bool t31 = !t30;
    const real_t t32 = TB_SQRT(t2 * t2 + t8 * t8 + t14 * t14 + t19 * t19);
    const real_t t33 = TB_COPYSIGN(t32, t2);
    const real_t t34 = TB_ABS(t33);
    const real_t t35 = t2 + t33;
    const real_t t36 = TB_C(1.0) / (t32 * (t32 + TB_ABS(t2)));
    const real_t t37 = (t6 * t8 - t7 * t35 + t13 * t14 - t18 * t19) * t36;
    const real_t t38 = t6 - t8 * t37;
    const real_t t39 = t13 - t14 * t37;
    const real_t t40 = t18 + t19 * t37;
    const real_t t41 = TB_SQRT(t38 * t38 + t39 * t39 + t40 * t40);
    const real_t t42 = TB_COPYSIGN(t41, t38);
    const real_t t43 = TB_ABS(t42);
    const real_t t44 = TB_C(1.0) / tb_min(t34, t43);
    const real_t t45 = TB_C(30.0) * TB_EPSILON * t44;
    const real_t t46 = TB_TENSION_MIN - t45;
    const real_t t47 = TB_C(1.0) / (t41 * (t41 + TB_ABS(t38)));
    const real_t t48 = t39 * t47;
    const real_t t49 = TB_C(1.0) - t39 * t48;
    const real_t t50 = t38 + t42;
    const real_t t51 = t48 * t50;
    const real_t t52 = t40 * t48;
    const real_t t53 = t36 * (t14 * t49 - t8 * t51 + t19 * t52);
    const real_t t54 = t35 * t53;
    const real_t t55 = t51 + t8 * t53;
    const real_t t56 = t40 * t47;
    const real_t t57 = t50 * t56;
    const real_t t58 = t39 * t56;
    const real_t t59 = TB_C(1.0) - t40 * t56;
    const real_t t60 = t36 * (t8 * t57 + t14 * t58 + t19 * t59);
    const real_t t61 = t35 * t60;
    const real_t t62 = t8 * t60 - t57;
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
    const real_t t200 = TB_ABS(t2 * t191 + t8 * t192 + t14 * t193 - t19 * t194);
    const real_t t201 = TB_ABS(t6 * t192 - t7 * t191 + t13 * t193 + t18 * t194);
    const bool t202 = tb_max(tb_max(t149, t200), t201) <= t44 * (TB_EPSILON * TB_C(1280.0));
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

tb_status tb_tension_factor(const real_t pose[2], const real_t rails[4], real_t factor[1])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) <=
              TB_C(5.6944))) {
        return tb_refuse_tension_factor(TB_OUT_OF_DOMAIN, factor);
    }
    const real_t t0 = rails[0] - pose[0];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 * t0 + pose[1] * pose[1]);
    const real_t t1 = TB_C(1.0) / length_0;
    const real_t t2 = t0 * t1;
    const real_t t3 = rails[1] - pose[1];
    const real_t t4 = TB_FRAME_X - pose[0];
    const real_t length_1 = TB_SQRT(t4 * t4 + t3 * t3);
    const real_t t5 = TB_C(1.0) / length_1;
    const real_t t6 = t3 * t5;
    const real_t t7 = pose[1] * t1;
    const real_t t8 = t4 * t5;
    const real_t t9 = TB_ABS(t2 * t6 + t7 * t8);
    const real_t t10 = TB_FRAME_Y - pose[1];
    const real_t t11 = rails[2] - pose[0];
    const real_t length_2 = TB_SQRT(t11 * t11 + t10 * t10);
    const real_t t12 = TB_C(1.0) / length_2;
    const real_t t13 = t10 * t12;
    const real_t t14 = t11 * t12;
    const real_t t15 = TB_ABS(t2 * t13 + t7 * t14);
    const real_t t16 = rails[3] - pose[1];
    const real_t length_3 = TB_SQRT(pose[0] * pose[0] + t16 * t16);
    const real_t t17 = TB_C(1.0) / length_3;
    const real_t t18 = t16 * t17;
    const real_t t19 = pose[0] * t17;
    const real_t t20 = TB_ABS(t2 * t18 - t7 * t19);
    const real_t t21 = TB_TENSION_MIDDLE * (t18 + (t13 + (t6 - t7)));
    const real_t t22 = TB_TENSION_MIDDLE * (t14 + (t2 + t8) - t19);
    const real_t t23 = TB_TENSION_HALF_RANGE * (t9 + t15 + t20) - TB_ABS(t2 * t21 + t7 * t22);
    const real_t t24 = TB_ABS(t8 * t13 - t6 * t14);
    const real_t t25 = TB_ABS(t8 * t18 + t6 * t19);
    const real_t t26 = TB_TENSION_HALF_RANGE * (t9 + t24 + t25) - TB_ABS(t8 * t21 - t6 * t22);
    const real_t t27 = TB_ABS(t14 * t18 + t13 * t19);
    const real_t t28 = TB_TENSION_HALF_RANGE * (t15 + t24 + t27) - TB_ABS(t14 * t21 - t13 *
        t22);
    const real_t t29 = TB_TENSION_HALF_RANGE * (t27 + (t20 + t25)) - TB_ABS(t19 * t21 + t18 *
        t22);
    const bool t30 = TB_C(0.0) <= tb_min(tb_min(tb_min(t23, t26), t28), t29);
    const real_t t31 = TB_SQRT(t2 * t2 + t8 * t8 + t14 * t14 + t19 * t19);
    const real_t t32 = TB_COPYSIGN(t31, t2);
    const real_t t33 = TB_ABS(t32);
    const real_t t34 = t2 + t32;
    const real_t t35 = TB_C(1.0) / (t31 * (t31 + TB_ABS(t2)));
    const real_t t36 = (t6 * t8 - t7 * t34 + t13 * t14 - t18 * t19) * t35;
    const real_t t37 = t6 - t8 * t36;
    const real_t t38 = t13 - t14 * t36;
    const real_t t39 = t18 + t19 * t36;
    const real_t t40 = TB_SQRT(t37 * t37 + t38 * t38 + t39 * t39);
    const real_t t41 = TB_COPYSIGN(t40, t37);
    const real_t t42 = TB_ABS(t41);
    const real_t t43 = TB_C(30.0) * TB_EPSILON / tb_min(t33, t42);
    const real_t t44 = TB_TENSION_MIN - t43;
    const real_t t45 = TB_C(1.0) / (t40 * (t40 + TB_ABS(t37)));
    const real_t t46 = t38 * t45;
    const real_t t47 = TB_C(1.0) - t38 * t46;
    const real_t t48 = t37 + t41;
    const real_t t49 = t46 * t48;
    const real_t t50 = t39 * t46;
    const real_t t51 = t35 * (t14 * t47 - t8 * t49 + t19 * t50);
    const real_t t52 = t34 * t51;
    const real_t t53 = t49 + t8 * t51;
    const real_t t54 = t39 * t45;
    const real_t t55 = t48 * t54;
    const real_t t56 = t38 * t54;
    const real_t t57 = TB_C(1.0) - t39 * t54;
    const real_t t58 = t35 * (t8 * t55 + t14 * t56 + t19 * t57);
    const real_t t59 = t34 * t58;
    const real_t t60 = t8 * t58 - t55;
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

tb_status tb_isotropic_force(const real_t pose[2], const real_t rails[4], real_t force[1])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) <=
              TB_C(5.6944))) {
        return tb_refuse_isotropic_force(TB_OUT_OF_DOMAIN, force);
    }
    const real_t t0 = rails[0] - pose[0];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 * t0 + pose[1] * pose[1]);
    const real_t t1 = TB_C(1.0) / length_0;
    const real_t t2 = t0 * t1;
    const real_t t3 = rails[1] - pose[1];
    const real_t t4 = TB_FRAME_X - pose[0];
    const real_t length_1 = TB_SQRT(t4 * t4 + t3 * t3);
    const real_t t5 = TB_C(1.0) / length_1;
    const real_t t6 = t3 * t5;
    const real_t t7 = pose[1] * t1;
    const real_t t8 = t4 * t5;
    const real_t t9 = TB_ABS(t2 * t6 + t7 * t8);
    const real_t t10 = TB_FRAME_Y - pose[1];
    const real_t t11 = rails[2] - pose[0];
    const real_t length_2 = TB_SQRT(t11 * t11 + t10 * t10);
    const real_t t12 = TB_C(1.0) / length_2;
    const real_t t13 = t10 * t12;
    const real_t t14 = t11 * t12;
    const real_t t15 = TB_ABS(t2 * t13 + t7 * t14);
    const real_t t16 = rails[3] - pose[1];
    const real_t length_3 = TB_SQRT(pose[0] * pose[0] + t16 * t16);
    const real_t t17 = TB_C(1.0) / length_3;
    const real_t t18 = t16 * t17;
    const real_t t19 = pose[0] * t17;
    const real_t t20 = TB_ABS(t2 * t18 - t7 * t19);
    const real_t t21 = TB_TENSION_MIDDLE * (t18 + (t13 + (t6 - t7)));
    const real_t t22 = TB_TENSION_MIDDLE * (t14 + (t2 + t8) - t19);
    const real_t t23 = TB_TENSION_HALF_RANGE * (t9 + t15 + t20) - TB_ABS(t2 * t21 + t7 * t22);
    const real_t t24 = TB_ABS(t8 * t13 - t6 * t14);
    const real_t t25 = TB_ABS(t8 * t18 + t6 * t19);
    const real_t t26 = TB_TENSION_HALF_RANGE * (t9 + t24 + t25) - TB_ABS(t8 * t21 - t6 * t22);
    const real_t t27 = TB_ABS(t14 * t18 + t13 * t19);
    const real_t t28 = TB_TENSION_HALF_RANGE * (t15 + t24 + t27) - TB_ABS(t14 * t21 - t13 *
        t22);
    const real_t t29 = TB_TENSION_HALF_RANGE * (t27 + (t20 + t25)) - TB_ABS(t19 * t21 + t18 *
        t22);
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

tb_status tb_pose_quality(const real_t pose[2], const real_t rails[4], real_t margin[1],
    real_t factor[1], real_t force[1])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) <=
              TB_C(5.6944))) {
        return tb_refuse_pose_quality(TB_OUT_OF_DOMAIN, margin, factor, force);
    }
    const real_t t0 = rails[0] - pose[0];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 * t0 + pose[1] * pose[1]);
    const real_t t1 = TB_C(1.0) / length_0;
    const real_t t2 = t0 * t1;
    const real_t t3 = rails[1] - pose[1];
    const real_t t4 = TB_FRAME_X - pose[0];
    const real_t length_1 = TB_SQRT(t4 * t4 + t3 * t3);
    const real_t t5 = TB_C(1.0) / length_1;
    const real_t t6 = t3 * t5;
    const real_t t7 = pose[1] * t1;
    const real_t t8 = t4 * t5;
    const real_t t9 = t2 * t6 + t7 * t8;
    const real_t t10 = TB_ABS(t9);
    const real_t t11 = TB_FRAME_Y - pose[1];
    const real_t t12 = rails[2] - pose[0];
    const real_t length_2 = TB_SQRT(t12 * t12 + t11 * t11);
    const real_t t13 = TB_C(1.0) / length_2;
    const real_t t14 = t11 * t13;
    const real_t t15 = t12 * t13;
    const real_t t16 = t2 * t14 + t7 * t15;
    const real_t t17 = TB_ABS(t16);
    const real_t t18 = rails[3] - pose[1];
    const real_t length_3 = TB_SQRT(pose[0] * pose[0] + t18 * t18);
    const real_t t19 = TB_C(1.0) / length_3;
    const real_t t20 = t18 * t19;
    const real_t t21 = pose[0] * t19;
    const real_t t22 = t2 * t20 - t7 * t21;
    const real_t t23 = TB_ABS(t22);
    const real_t t24 = TB_TENSION_MIDDLE * (t20 + (t14 + (t6 - t7)));
    const real_t t25 = TB_TENSION_MIDDLE * (t15 + (t2 + t8) - t21);
    const real_t t26 = t2 * t24 + t7 * t25;
    const real_t t27 = t8 * t14 - t6 * t15;
    const real_t t28 = TB_ABS(t27);
    const real_t t29 = t8 * t20 + t6 * t21;
    const real_t t30 = TB_ABS(t29);
    const real_t t31 = t8 * t24 - t6 * t25;
    const real_t t32 = tb_min(TB_TENSION_HALF_RANGE * (t10 + t17 + t23) - TB_ABS(t26),
        TB_TENSION_HALF_RANGE * (t10 + t28 + t30) - TB_ABS(t31));
    const real_t t33 = t15 * t20 + t14 * t21;
    const real_t t34 = TB_ABS(t33);
    const real_t t35 = t15 * t24 - t14 * t25;
    const real_t t36 = tb_min(t32, TB_TENSION_HALF_RANGE * (t17 + t28 + t34) - TB_ABS(t35));
    const real_t t37 = t21 * t24 + t20 * t25;
    const real_t margin_0 = tb_min(t36, TB_TENSION_HALF_RANGE * (t34 + (t23 + t30)) -
        TB_ABS(t37));
    const bool t38 = TB_C(0.0) <= margin_0;
    real_t factor_0, t39;
    if (t38) {
        const real_t t40 = TB_C(0.46153846153846156) * tb_max(TB_ABS(t25), TB_ABS(t24));
        const real_t t41 = TB_C(120.0) * TB_EPSILON;
        const bool t42 = t40 <= t41;
        real_t t43, t44, t45, t46, t47, t48, t49, t50, t51, t52;
        if (t42) {
            t43 = TB_C(0.0);
            t44 = TB_C(0.0);
            t45 = TB_C(0.0);
            t46 = TB_C(0.0);
            t47 = TB_C(0.0);
            t48 = TB_C(0.0);
            t49 = TB_C(0.0);
            t50 = TB_C(0.0);
            t51 = TB_C(0.0);
            t52 = TB_C(0.0);
        } else {
            const real_t t53 = t7 * t24 - t2 * t25;
            const real_t t54 = TB_C(0.0) <= t26 ? t53 : -TB_C(1e+30);
            const real_t t55 = -(t8 * t25 + t6 * t24);
            const real_t t56 = TB_C(0.0) <= t31 ? t55 : -TB_C(1e+30);
            const real_t t57 = tb_max(t54, t56);
            const real_t t58 = -(t15 * t25 + t14 * t24);
            const real_t t59 = TB_C(0.0) <= t35 ? t58 : -TB_C(1e+30);
            const real_t t60 = -t37;
            const real_t t61 = t21 * t25 - t20 * t24;
            const bool t62 = tb_max(t57, t59) < (TB_C(0.0) <= t60 ? t61 : -TB_C(1e+30));
            const real_t t63 = -t21;
            const real_t t64 = -t7;
            real_t t65, t66;
            if (t62) {
                t65 = t63;
                t66 = t20;
            } else {
                const bool t67 = t57 < t59;
                const bool t68 = t54 < t56;
                t65 = t67 ? t15 : (t68 ? t8 : t2);
                t66 = t67 ? t14 : (t68 ? t6 : t64);
            }
            const real_t t69 = TB_C(0.46153846153846156) * (t24 * t65 - t25 * t66);
            const real_t t70 = t26 < TB_C(0.0) ? t53 : -TB_C(1e+30);
            const real_t t71 = t31 < TB_C(0.0) ? t55 : -TB_C(1e+30);
            const real_t t72 = tb_max(t70, t71);
            const real_t t73 = t35 < TB_C(0.0) ? t58 : -TB_C(1e+30);
            const bool t74 = tb_max(t72, t73) < (t60 < TB_C(0.0) ? t61 : -TB_C(1e+30));
            real_t t75, t76;
            if (t74) {
                t75 = t63;
                t76 = t20;
            } else {
                const bool t77 = t72 < t73;
                const bool t78 = t70 < t71;
                t75 = t77 ? t15 : (t78 ? t8 : t2);
                t76 = t77 ? t14 : (t78 ? t6 : t64);
            }
            const real_t t79 = TB_C(1.0) / (t66 * t75 - t65 * t76);
            const real_t t80 = TB_TENSION_MIN + t69 * t79;
            const real_t t81 = TB_C(0.46153846153846156) * (t24 * t75 - t25 * t76);
            const real_t t82 = TB_TENSION_MIN - t79 * t81;
            const real_t t83 = t79 * (t66 * t80 - t76 * t82);
            const real_t t84 = t79 * (t75 * t82 - t65 * t80);
            t43 = t2 * t83;
            t44 = -(t7 * t84);
            t45 = t8 * t83;
            t46 = t6 * t84;
            t47 = t15 * t83;
            t48 = t14 * t84;
            t49 = -(t21 * t83);
            t50 = t20 * t84;
            t51 = t83;
            t52 = t84;
        }
        const real_t t85 = t43 + t44;
        const real_t t86 = tb_min(tb_max(t85, TB_TENSION_MIN), TB_TENSION_MAX);
        const real_t t87 = t45 + t46;
        const real_t t88 = tb_min(tb_max(t87, TB_TENSION_MIN), TB_TENSION_MAX);
        const real_t t89 = t47 + t48;
        const real_t t90 = tb_min(tb_max(t89, TB_TENSION_MIN), TB_TENSION_MAX);
        const real_t t91 = t49 + t50;
        const real_t t92 = tb_min(tb_max(t91, TB_TENSION_MIN), TB_TENSION_MAX);
        const real_t t93 = t2 * t86 + t8 * t88 + t15 * t90 - t21 * t92;
        const real_t t94 = t6 * t88 - t7 * t86 + t14 * t90 + t20 * t92;
        const bool t95 = tb_max(TB_ABS(t93), TB_ABS(t94)) - t41 <= TB_C(0.0);
        real_t t96, t97;
        if (t95) {
            const real_t t98 = tb_min(tb_min(tb_min(t86, t88), t90), t92) /
                tb_max(tb_max(tb_max(t86, t88), t90), t92);
            t96 = t98;
            t97 = TB_C(0.0);
        } else {
            const bool t99 = TB_TENSION_MIN < t85 && t85 < TB_TENSION_MAX;
            const real_t t100 = t2 * t2;
            const bool t101 = TB_TENSION_MIN < t87 && t87 < TB_TENSION_MAX;
            const real_t t102 = t8 * t8;
            const real_t t103 = (t99 ? t100 : TB_C(0.0)) + (t101 ? t102 : TB_C(0.0));
            const bool t104 = TB_TENSION_MIN < t89 && t89 < TB_TENSION_MAX;
            const real_t t105 = t15 * t15;
            const bool t106 = TB_TENSION_MIN < t91 && t91 < TB_TENSION_MAX;
            const real_t t107 = t21 * t21;
            const real_t t108 = t103 + (t104 ? t105 : TB_C(0.0)) + (t106 ? t107 : TB_C(0.0));
            const real_t t109 = TB_C(1.0) / t108;
            const real_t t110 = t6 * t8;
            const real_t t111 = (t99 ? -(t2 * t7) : TB_C(0.0)) + (t101 ? t110 : TB_C(0.0));
            const real_t t112 = t14 * t15;
            const real_t t113 = t20 * t21;
            const real_t t114 = t111 + (t104 ? t112 : TB_C(0.0)) + (t106 ? -t113 : TB_C(0.0));
            const real_t t115 = t109 * t114;
            const real_t t116 = (t99 ? t7 * t7 : TB_C(0.0)) + (t101 ? t6 * t6 : TB_C(0.0));
            const real_t t117 = t116 + (t104 ? t14 * t14 : TB_C(0.0)) + (t106 ? t20 * t20 :
                TB_C(0.0));
            const real_t t118 = (t94 - t93 * t115) / (t117 - t108 * (t115 * t115));
            const real_t t119 = t51 - (t93 * t109 - t115 * t118);
            const real_t t120 = t52 - t118;
            const real_t t121 = tb_min(tb_max(t2 * t119 - t7 * t120, TB_TENSION_MIN),
                TB_TENSION_MAX);
            const real_t t122 = tb_min(tb_max(t8 * t119 + t6 * t120, TB_TENSION_MIN),
                TB_TENSION_MAX);
            const real_t t123 = tb_min(tb_max(t15 * t119 + t14 * t120, TB_TENSION_MIN),
                TB_TENSION_MAX);
            const real_t t124 = tb_min(tb_max(t20 * t120 - t21 * t119, TB_TENSION_MIN),
                TB_TENSION_MAX);
            const real_t t125 = TB_ABS(t2 * t121 + t8 * t122 + t15 * t123 - t21 * t124);
            const real_t t126 = TB_ABS(t6 * t122 - t7 * t121 + t14 * t123 + t20 * t124);
            const bool t127 = tb_max(t125, t126) - t41 <= TB_C(0.0);
            real_t t128, t129;
            if (t127) {
                const real_t t130 = tb_min(tb_min(tb_min(t121, t122), t123), t124) /
                    tb_max(tb_max(tb_max(t121, t122), t123), t124);
                t128 = t130;
                t129 = TB_C(0.0);
            } else {
                const real_t t131 = TB_SQRT(t107 + (t105 + (t100 + t102)));
                const real_t t132 = TB_COPYSIGN(t131, t2);
                const real_t t133 = t2 + t132;
                const real_t t134 = TB_C(1.0) / (t131 * (t131 + TB_ABS(t2)));
                const real_t t135 = (t112 + (t110 - t7 * t133) - t113) * t134;
                const real_t t136 = t6 - t8 * t135;
                const real_t t137 = t14 - t15 * t135;
                const real_t t138 = t20 + t21 * t135;
                const real_t t139 = TB_SQRT(t136 * t136 + t137 * t137 + t138 * t138);
                const real_t t140 = TB_COPYSIGN(t139, t136);
                const real_t t141 = TB_C(1.0) / tb_min(TB_ABS(t132), TB_ABS(t140));
                const real_t t142 = TB_EPSILON * TB_C(30.0) * t141;
                const real_t t143 = TB_TENSION_MIN - t142;
                const real_t t144 = TB_C(1.0) / (t139 * (t139 + TB_ABS(t136)));
                const real_t t145 = t137 * t144;
                const real_t t146 = TB_C(1.0) - t137 * t145;
                const real_t t147 = t136 + t140;
                const real_t t148 = t145 * t147;
                const real_t t149 = t138 * t145;
                const real_t t150 = t134 * (t15 * t146 - t8 * t148 + t21 * t149);
                const real_t t151 = t133 * t150;
                const real_t t152 = t148 + t8 * t150;
                const real_t t153 = t138 * t144;
                const real_t t154 = t147 * t153;
                const real_t t155 = t137 * t153;
                const real_t t156 = TB_C(1.0) - t138 * t153;
                const real_t t157 = t134 * (t8 * t154 + t15 * t155 + t21 * t156);
                const real_t t158 = t133 * t157;
                const real_t t159 = t8 * t157 - t154;
                const real_t t160 = t151 * t152 + t158 * t159;
                const real_t t161 = t142 < TB_TENSION_MIN ? TB_TENSION_MIN : TB_C(0.0);
                const real_t t162 = t161 / tb_max(t151 * t151 + t158 * t158, TB_EPSILON);
                const real_t t163 = t160 * t162;
                const real_t t164 = TB_TENSION_MAX + t142;
                const real_t t165 = tb_max(t143 - t163, t163 - t164);
                const bool t166 = TB_C(0.0) < t165;
                const real_t t167 = t15 * t157 - t155;
                const real_t t168 = t146 - t15 * t150;
                const real_t t169 = t159 * t167 - t152 * t168;
                const real_t t170 = t152 * t167 + t159 * t168;
                const real_t t171 = TB_EPSILON * TB_C(16.0);
                const real_t t172 = t158 * t167 - t151 * t168;
                const real_t t173 = t156 - t21 * t157;
                const real_t t174 = t21 * t150 - t149;
                const real_t t175 = t159 * t173 - t152 * t174;
                const real_t t176 = t152 * t173 + t159 * t174;
                const real_t t177 = t158 * t173 - t151 * t174;
                const real_t t178 = t142 * TB_C(2.0);
                const real_t t179 = t142 * TB_C(1024.0);
                real_t t180, t181, t182, t183, t184;
                if (t166) {
                    const real_t t185 = tb_min(tb_max(t163, TB_TENSION_MIN), TB_TENSION_MAX);
                    const real_t t186 = TB_C(1.0) / tb_max(t152 * t152 + t159 * t159,
                        TB_EPSILON);
                    const real_t t187 = t185 * t186;
                    const real_t t188 = t151 * t159 - t152 * t158;
                    const bool t189 = TB_ABS(t188) <= t171;
                    const real_t t190 = t160 * t187;
                    const real_t t191 = TB_C(1.0) / t188;
                    real_t t192, t193;
                    if (t189) {
                        t192 = -TB_C(1000000000000.0);
                        t193 = TB_C(1000000000000.0);
                    } else {
                        const real_t t194 = (t143 - t190) * t191;
                        const real_t t195 = t191 * (t164 - t190);
                        t192 = tb_min(t194, t195);
                        t193 = tb_max(t194, t195);
                    }
                    const real_t t196 = tb_min(tb_max(TB_C(0.0), t192), t193);
                    const real_t t197 = TB_C(0.0) < TB_ABS(t196) ? t196 * (t160 * t191) :
                        TB_C(0.0);
                    const real_t t198 = t163 < t185 ? t197 - t187 : t187 - t197;
                    real_t t199;
                    if (TB_C(0.0) < t198) {
                        const real_t t200 = t189 ? TB_C(0.0) : t178 * TB_ABS(t191);
                        const real_t t201 = t192 + t200 < t193 - t200 && t179 < t165 ? t198 :
                            TB_C(0.0);
                        t199 = t201;
                    } else {
                        t199 = TB_C(0.0);
                    }
                    t180 = t169 * t187 - t170 * t196;
                    t181 = t187 * t175 - t196 * t176;
                    t182 = t190 + t188 * t196;
                    t183 = t185;
                    t184 = t199;
                } else {
                    t180 = t162 * t172;
                    t181 = t162 * t177;
                    t182 = t161;
                    t183 = t163;
                    t184 = TB_C(0.0);
                }
                const real_t t202 = tb_max(t143 - t180, t180 - t164);
                const bool t203 = TB_C(0.0) < t202;
                const real_t t204 = t168 * t174 + t167 * t173;
                const real_t t205 = t168 * t173;
                const real_t t206 = t167 * t174;
                real_t t207, t208, t209, t210, t211;
                if (t203) {
                    const real_t t212 = tb_min(tb_max(t180, TB_TENSION_MIN), TB_TENSION_MAX);
                    const real_t t213 = TB_C(1.0) / tb_max(t168 * t168 + t167 * t167,
                        TB_EPSILON);
                    const real_t t214 = t212 * t213;
                    const bool t215 = TB_ABS(t170) <= t171;
                    const real_t t216 = t169 * t214;
                    const real_t t217 = TB_C(1.0) / t170;
                    real_t t218, t219;
                    if (t215) {
                        t218 = -TB_C(1000000000000.0);
                        t219 = TB_C(1000000000000.0);
                    } else {
                        const real_t t220 = (t143 - t216) * t217;
                        const real_t t221 = t217 * (t164 - t216);
                        t218 = tb_min(t220, t221);
                        t219 = tb_max(t220, t221);
                    }
                    const real_t t222 = t158 * t168 + t151 * t167;
                    const bool t223 = TB_ABS(t222) <= t171;
                    const real_t t224 = t172 * t214;
                    const real_t t225 = TB_C(1.0) / t222;
                    real_t t226, t227;
                    if (t223) {
                        t226 = -TB_C(1000000000000.0);
                        t227 = TB_C(1000000000000.0);
                    } else {
                        const real_t t228 = (t143 - t224) * t225;
                        const real_t t229 = t225 * (t164 - t224);
                        t226 = tb_min(t228, t229);
                        t227 = tb_max(t228, t229);
                    }
                    const real_t t230 = tb_min(tb_max(TB_C(0.0), tb_max(t218, t226)),
                        tb_min(t219, t227));
                    real_t t231;
                    if (TB_C(0.0) < TB_ABS(t230)) {
                        const real_t t232 = t169 * t217;
                        const real_t t233 = t172 * t225;
                        const real_t t234 = TB_C(0.0) < t230 ? (t226 < t218 ? t232 : t233) :
                            (t219 < t227 ? t232 : t233);
                        t231 = t230 * t234;
                    } else {
                        t231 = TB_C(0.0);
                    }
                    const real_t t235 = t180 < t212 ? t231 - t214 : t214 - t231;
                    real_t t236;
                    if (TB_C(0.0) < t235) {
                        const real_t t237 = t223 ? TB_C(0.0) : t178 * TB_ABS(t225);
                        const real_t t238 = t215 ? TB_C(0.0) : t178 * TB_ABS(t217);
                        const bool t239 = tb_max(t226 + t237, t218 + t238) < tb_min(t227 -
                            t237, t219 - t238);
                        t236 = t239 && t179 < t202 ? t235 : TB_C(0.0);
                    } else {
                        t236 = TB_C(0.0);
                    }
                    t207 = t204 * t214 + (t205 - t206) * t230;
                    t208 = t224 + t222 * t230;
                    t209 = t216 + t170 * t230;
                    t210 = t212;
                    t211 = t236;
                } else {
                    t207 = t181;
                    t208 = t182;
                    t209 = t183;
                    t210 = t180;
                    t211 = t184;
                }
                const real_t t240 = tb_max(t143 - t207, t207 - t164);
                const bool t241 = TB_C(0.0) < t240;
                real_t t242, t243, t244, t245, t246;
                if (t241) {
                    const real_t t247 = tb_min(tb_max(t207, TB_TENSION_MIN), TB_TENSION_MAX);
                    const real_t t248 = TB_C(1.0) / tb_max(t174 * t174 + t173 * t173,
                        TB_EPSILON);
                    const real_t t249 = t247 * t248;
                    const real_t t250 = t177 * t249;
                    const real_t t251 = t158 * t174 + t151 * t173;
                    const real_t t252 = t206 - t205;
                    const bool t253 = TB_ABS(t252) <= t171;
                    const real_t t254 = t204 * t249;
                    const real_t t255 = TB_C(1.0) / t252;
                    real_t t256, t257;
                    if (t253) {
                        t256 = -TB_C(1000000000000.0);
                        t257 = TB_C(1000000000000.0);
                    } else {
                        const real_t t258 = (t143 - t254) * t255;
                        const real_t t259 = t255 * (t164 - t254);
                        t256 = tb_min(t258, t259);
                        t257 = tb_max(t258, t259);
                    }
                    const bool t260 = TB_ABS(t176) <= t171;
                    const real_t t261 = t175 * t249;
                    const real_t t262 = TB_C(1.0) / t176;
                    real_t t263, t264;
                    if (t260) {
                        t263 = -TB_C(1000000000000.0);
                        t264 = TB_C(1000000000000.0);
                    } else {
                        const real_t t265 = (t143 - t261) * t262;
                        const real_t t266 = t262 * (t164 - t261);
                        t263 = tb_min(t265, t266);
                        t264 = tb_max(t265, t266);
                    }
                    const bool t267 = TB_ABS(t251) <= t171;
                    const real_t t268 = TB_C(1.0) / t251;
                    real_t t269, t270;
                    if (t267) {
                        t269 = -TB_C(1000000000000.0);
                        t270 = TB_C(1000000000000.0);
                    } else {
                        const real_t t271 = (t143 - t250) * t268;
                        const real_t t272 = t268 * (t164 - t250);
                        t269 = tb_min(t271, t272);
                        t270 = tb_max(t271, t272);
                    }
                    const real_t t273 = tb_max(t263, t269);
                    const real_t t274 = tb_min(t264, t270);
                    const real_t t275 = tb_min(tb_max(TB_C(0.0), tb_max(t256, t273)),
                        tb_min(t257, t274));
                    real_t t276;
                    if (TB_C(0.0) < TB_ABS(t275)) {
                        const real_t t277 = t204 * t255;
                        const real_t t278 = t175 * t262;
                        const real_t t279 = t177 * t268;
                        real_t t280;
                        if (TB_C(0.0) < t275) {
                            t280 = t273 < t256 ? t277 : (t269 < t263 ? t278 : t279);
                        } else {
                            t280 = t257 < t274 ? t277 : (t264 < t270 ? t278 : t279);
                        }
                        t276 = t275 * t280;
                    } else {
                        t276 = TB_C(0.0);
                    }
                    const real_t t281 = t207 < t247 ? t276 - t249 : t249 - t276;
                    real_t t282;
                    if (TB_C(0.0) < t281) {
                        const real_t t283 = t267 ? TB_C(0.0) : t178 * TB_ABS(t268);
                        const real_t t284 = t260 ? TB_C(0.0) : t178 * TB_ABS(t262);
                        const real_t t285 = t253 ? TB_C(0.0) : t178 * TB_ABS(t255);
                        const real_t t286 = tb_max(tb_max(t269 + t283, t263 + t284), t256 +
                            t285);
                        const real_t t287 = tb_min(tb_min(t270 - t283, t264 - t284), t257 -
                            t285);
                        t282 = t286 < t287 && t179 < t240 ? t281 : TB_C(0.0);
                    } else {
                        t282 = TB_C(0.0);
                    }
                    t242 = t250 + t251 * t275;
                    t243 = t261 + t176 * t275;
                    t244 = t254 + t252 * t275;
                    t245 = t247;
                    t246 = t282;
                } else {
                    t242 = t208;
                    t243 = t209;
                    t244 = t210;
                    t245 = t207;
                    t246 = t211;
                }
                const real_t t288 = tb_min(tb_max(t242, TB_TENSION_MIN), TB_TENSION_MAX);
                const real_t t289 = tb_min(tb_max(t243, TB_TENSION_MIN), TB_TENSION_MAX);
                const real_t t290 = tb_min(tb_max(t244, TB_TENSION_MIN), TB_TENSION_MAX);
                const real_t t291 = tb_min(tb_max(t245, TB_TENSION_MIN), TB_TENSION_MAX);
                const real_t t292 = tb_min(tb_min(tb_min(t288, t289), t290), t291) /
                    tb_max(tb_max(tb_max(t288, t289), t290), t291);
                const real_t t293 = TB_ABS(t2 * t288 + t8 * t289 + t15 * t290 - t21 * t291);
                const real_t t294 = TB_ABS(t6 * t289 - t7 * t288 + t14 * t290 + t20 * t291);
                const real_t t295 = tb_max(tb_max(t246, t293), t294) - t141 * (TB_EPSILON *
                    TB_C(1280.0));
                t128 = t292;
                t129 = t295;
            }
            t96 = t128;
            t97 = t129;
        }
        factor_0 = t96;
        t39 = t97;
    } else {
        factor_0 = TB_C(0.0);
        t39 = TB_C(0.0);
    }
    const real_t force_0 = tb_max(TB_C(0.0), margin_0);
    const bool t296 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t297 = t296 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t298 = !t297;
    const real_t t299 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const real_t t300 = t9 * t9 + t16 * t16 + t22 * t22 + t27 * t27 + t29 * t29;
    const bool t301 = !(t299 * t299 < (t300 + t33 * t33) * TB_C(0.5));
    const bool t302 = !(t39 <= TB_C(0.0));
    const bool t303 = !t38;
    if (t298 || t301) {
        return tb_refuse_pose_quality(TB_SINGULAR, margin, factor, force);
    }
    if (t302) {
        return tb_refuse_pose_quality(TB_INACCURATE, margin, factor, force);
    }
    margin[0] = margin_0;
    factor[0] = factor_0;
    force[0] = force_0;
    return t303 ? TB_INFEASIBLE : TB_OK;
}

/* Refuses with a status: force is 0 N. */
static tb_status tb_refuse_isotropic_force_eq17(tb_status status, real_t force[1])
{
    force[0] = TB_C(0.0);
    return status;
}

tb_status tb_isotropic_force_eq17(const real_t pose[2], const real_t rails[4], real_t force[1])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) <=
              TB_C(5.6944))) {
        return tb_refuse_isotropic_force_eq17(TB_OUT_OF_DOMAIN, force);
    }
    const real_t t0 = rails[0] - pose[0];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 * t0 + pose[1] * pose[1]);
    const real_t t1 = TB_C(1.0) / length_0;
    const real_t t2 = t0 * t1;
    const real_t t3 = rails[1] - pose[1];
    const real_t t4 = TB_FRAME_X - pose[0];
    const real_t length_1 = TB_SQRT(t4 * t4 + t3 * t3);
    const real_t t5 = TB_C(1.0) / length_1;
    const real_t t6 = t3 * t5;
    const real_t t7 = pose[1] * t1;
    const real_t t8 = t4 * t5;
    const real_t t9 = t2 * t6 + t7 * t8;
    const real_t t10 = TB_ABS(t9);
    const real_t t11 = TB_FRAME_Y - pose[1];
    const real_t t12 = rails[2] - pose[0];
    const real_t length_2 = TB_SQRT(t12 * t12 + t11 * t11);
    const real_t t13 = TB_C(1.0) / length_2;
    const real_t t14 = t11 * t13;
    const real_t t15 = t12 * t13;
    const real_t t16 = t2 * t14 + t7 * t15;
    const real_t t17 = TB_ABS(t16);
    const real_t t18 = rails[3] - pose[1];
    const real_t length_3 = TB_SQRT(pose[0] * pose[0] + t18 * t18);
    const real_t t19 = TB_C(1.0) / length_3;
    const real_t t20 = t18 * t19;
    const real_t t21 = t2 * t20;
    const real_t t22 = pose[0] * t19;
    const real_t t23 = t7 * t22;
    const real_t t24 = t21 - t23;
    const real_t t25 = TB_ABS(t24);
    const real_t t26 = TB_TENSION_MIDDLE * (t20 + (t14 + (t6 - t7)));
    const real_t t27 = TB_TENSION_MIDDLE * (t15 + (t2 + t8) - t22);
    const real_t t28 = TB_TENSION_HALF_RANGE * (t10 + t17 + t25) - TB_ABS(t2 * t26 + t7 * t27);
    const real_t t29 = t8 * t14;
    const real_t t30 = t6 * t15;
    const real_t t31 = t29 - t30;
    const real_t t32 = TB_ABS(t31);
    const real_t t33 = t8 * t20 + t6 * t22;
    const real_t t34 = TB_ABS(t33);
    const real_t t35 = TB_TENSION_HALF_RANGE * (t10 + t32 + t34) - TB_ABS(t8 * t26 - t6 * t27);
    const real_t t36 = t15 * t20 + t14 * t22;
    const real_t t37 = TB_ABS(t36);
    const real_t t38 = TB_TENSION_HALF_RANGE * (t17 + t32 + t37) - TB_ABS(t15 * t26 - t14 *
        t27);
    const real_t t39 = TB_TENSION_HALF_RANGE * (t37 + (t25 + t34)) - TB_ABS(t22 * t26 + t20 *
        t27);
    const bool t40 = TB_C(0.0) <= tb_min(tb_min(tb_min(t28, t35), t38), t39);
    const real_t t41 = TB_SQRT(t2 * t2 + t8 * t8 + t15 * t15 + t22 * t22);
    const real_t t42 = TB_COPYSIGN(t41, t2);
    const real_t t43 = TB_ABS(t42);
    const real_t t44 = t2 + t42;
    const real_t t45 = TB_C(1.0) / (t41 * (t41 + TB_ABS(t2)));
    const real_t t46 = (t6 * t8 - t7 * t44 + t14 * t15 - t20 * t22) * t45;
    const real_t t47 = t6 - t8 * t46;
    const real_t t48 = t14 - t15 * t46;
    const real_t t49 = t20 + t22 * t46;
    const real_t t50 = TB_SQRT(t47 * t47 + t48 * t48 + t49 * t49);
    const real_t t51 = TB_COPYSIGN(t50, t47);
    const real_t t52 = TB_ABS(t51);
    real_t force_0;
    if (t40) {
        const bool t53 = TB_C(0.0) < t9;
        const bool t54 = t2 * t8 - t6 * t7 < TB_C(0.0);
        const bool t55 = TB_C(0.0) < t16;
        const real_t t56 = t30 - t29;
        const bool t57 = TB_C(0.0) < t56;
        const bool t58 = TB_C(0.0) < t24;
        const real_t t59 = -t33;
        const bool t60 = TB_C(0.0) < t59;
        const bool t61 = (t53 || (TB_C(0.0) <= t9 && t54)) && !((t55 && t57) || (t58 && t60));
        const real_t t62 = TB_C(30.0) * TB_EPSILON / tb_min(t43, t52);
        const real_t t63 = TB_TENSION_MIN - t62;
        const real_t t64 = TB_C(1.0) / (t50 * (t50 + TB_ABS(t47)));
        const real_t t65 = t48 * t64;
        const real_t t66 = TB_C(1.0) - t48 * t65;
        const real_t t67 = t47 + t51;
        const real_t t68 = t65 * t67;
        const real_t t69 = t49 * t65;
        const real_t t70 = t45 * (t15 * t66 - t8 * t68 + t22 * t69);
        const real_t t71 = t44 * t70;
        const real_t t72 = t68 + t8 * t70;
        const real_t t73 = t49 * t64;
        const real_t t74 = t67 * t73;
        const real_t t75 = t48 * t73;
        const real_t t76 = TB_C(1.0) - t49 * t73;
        const real_t t77 = t45 * (t8 * t74 + t15 * t75 + t22 * t76);
        const real_t t78 = t44 * t77;
        const real_t t79 = t8 * t77 - t74;
        const real_t t80 = t71 * t72 + t78 * t79;
        const real_t t81 = t62 < TB_TENSION_MIN ? TB_TENSION_MIN : TB_C(0.0);
        const real_t t82 = t81 / tb_max(t71 * t71 + t78 * t78, TB_EPSILON);
        const real_t t83 = t80 * t82;
        const real_t t84 = TB_TENSION_MAX + t62;
        const bool t85 = TB_C(0.0) < tb_max(t63 - t83, t83 - t84);
        const real_t t86 = t15 * t77 - t75;
        const real_t t87 = t66 - t15 * t70;
        const real_t t88 = t79 * t86 - t72 * t87;
        const real_t t89 = t72 * t86 + t79 * t87;
        const real_t t90 = TB_EPSILON * TB_C(16.0);
        const real_t t91 = t78 * t86 - t71 * t87;
        const real_t t92 = t76 - t22 * t77;
        const real_t t93 = t22 * t70 - t69;
        const real_t t94 = t79 * t92 - t72 * t93;
        const real_t t95 = t72 * t92 + t79 * t93;
        const real_t t96 = t78 * t92 - t71 * t93;
        real_t t97, t98, t99, t100;
        if (t85) {
            const real_t t101 = tb_min(tb_max(t83, TB_TENSION_MIN), TB_TENSION_MAX);
            const real_t t102 = TB_C(1.0) / tb_max(t72 * t72 + t79 * t79, TB_EPSILON);
            const real_t t103 = t101 * t102;
            const real_t t104 = t71 * t79 - t72 * t78;
            const bool t105 = TB_ABS(t104) <= t90;
            const real_t t106 = t80 * t103;
            real_t t107, t108;
            if (t105) {
                t107 = -TB_C(1000000000000.0);
                t108 = TB_C(1000000000000.0);
            } else {
                const real_t t109 = TB_C(1.0) / t104;
                const real_t t110 = (t63 - t106) * t109;
                const real_t t111 = t109 * (t84 - t106);
                t107 = tb_min(t110, t111);
                t108 = tb_max(t110, t111);
            }
            const real_t t112 = tb_min(tb_max(TB_C(0.0), t107), t108);
            t97 = t88 * t103 - t89 * t112;
            t98 = t103 * t94 - t112 * t95;
            t99 = t106 + t104 * t112;
            t100 = t101;
        } else {
            t97 = t82 * t91;
            t98 = t82 * t96;
            t99 = t81;
            t100 = t83;
        }
        const bool t113 = TB_C(0.0) < tb_max(t63 - t97, t97 - t84);
        const real_t t114 = t87 * t93 + t86 * t92;
        const real_t t115 = t87 * t92;
        const real_t t116 = t86 * t93;
        real_t t117, t118, t119, t120;
        if (t113) {
            const real_t t121 = tb_min(tb_max(t97, TB_TENSION_MIN), TB_TENSION_MAX);
            const real_t t122 = TB_C(1.0) / tb_max(t87 * t87 + t86 * t86, TB_EPSILON);
            const real_t t123 = t121 * t122;
            const bool t124 = TB_ABS(t89) <= t90;
            const real_t t125 = t88 * t123;
            real_t t126, t127;
            if (t124) {
                t126 = -TB_C(1000000000000.0);
                t127 = TB_C(1000000000000.0);
            } else {
                const real_t t128 = TB_C(1.0) / t89;
                const real_t t129 = (t63 - t125) * t128;
                const real_t t130 = t128 * (t84 - t125);
                t126 = tb_min(t129, t130);
                t127 = tb_max(t129, t130);
            }
            const real_t t131 = t78 * t87 + t71 * t86;
            const bool t132 = TB_ABS(t131) <= t90;
            const real_t t133 = t91 * t123;
            real_t t134, t135;
            if (t132) {
                t134 = -TB_C(1000000000000.0);
                t135 = TB_C(1000000000000.0);
            } else {
                const real_t t136 = TB_C(1.0) / t131;
                const real_t t137 = (t63 - t133) * t136;
                const real_t t138 = t136 * (t84 - t133);
                t134 = tb_min(t137, t138);
                t135 = tb_max(t137, t138);
            }
            const real_t t139 = tb_min(tb_max(TB_C(0.0), tb_max(t126, t134)), tb_min(t127,
                t135));
            t117 = t114 * t123 + (t115 - t116) * t139;
            t118 = t133 + t131 * t139;
            t119 = t125 + t89 * t139;
            t120 = t121;
        } else {
            t117 = t98;
            t118 = t99;
            t119 = t100;
            t120 = t97;
        }
        const bool t140 = TB_C(0.0) < tb_max(t63 - t117, t117 - t84);
        real_t t141, t142, t143, t144;
        if (t140) {
            const real_t t145 = tb_min(tb_max(t117, TB_TENSION_MIN), TB_TENSION_MAX);
            const real_t t146 = TB_C(1.0) / tb_max(t93 * t93 + t92 * t92, TB_EPSILON);
            const real_t t147 = t145 * t146;
            const real_t t148 = t96 * t147;
            const real_t t149 = t78 * t93 + t71 * t92;
            const real_t t150 = t116 - t115;
            const bool t151 = TB_ABS(t150) <= t90;
            const real_t t152 = t114 * t147;
            real_t t153, t154;
            if (t151) {
                t153 = -TB_C(1000000000000.0);
                t154 = TB_C(1000000000000.0);
            } else {
                const real_t t155 = TB_C(1.0) / t150;
                const real_t t156 = (t63 - t152) * t155;
                const real_t t157 = t155 * (t84 - t152);
                t153 = tb_min(t156, t157);
                t154 = tb_max(t156, t157);
            }
            const bool t158 = TB_ABS(t95) <= t90;
            const real_t t159 = t94 * t147;
            real_t t160, t161;
            if (t158) {
                t160 = -TB_C(1000000000000.0);
                t161 = TB_C(1000000000000.0);
            } else {
                const real_t t162 = TB_C(1.0) / t95;
                const real_t t163 = (t63 - t159) * t162;
                const real_t t164 = t162 * (t84 - t159);
                t160 = tb_min(t163, t164);
                t161 = tb_max(t163, t164);
            }
            const bool t165 = TB_ABS(t149) <= t90;
            real_t t166, t167;
            if (t165) {
                t166 = -TB_C(1000000000000.0);
                t167 = TB_C(1000000000000.0);
            } else {
                const real_t t168 = TB_C(1.0) / t149;
                const real_t t169 = (t63 - t148) * t168;
                const real_t t170 = t168 * (t84 - t148);
                t166 = tb_min(t169, t170);
                t167 = tb_max(t169, t170);
            }
            const real_t t171 = tb_max(TB_C(0.0), tb_max(t153, tb_max(t160, t166)));
            const real_t t172 = tb_min(t171, tb_min(t154, tb_min(t161, t167)));
            t141 = t148 + t149 * t172;
            t142 = t159 + t95 * t172;
            t143 = t152 + t150 * t172;
            t144 = t145;
        } else {
            t141 = t118;
            t142 = t119;
            t143 = t120;
            t144 = t117;
        }
        /* t_i = T_max - T0_i */
        const real_t margin_0 = TB_TENSION_MAX - tb_min(tb_max(t141, TB_TENSION_MIN),
            TB_TENSION_MAX);
        const real_t margin_1 = TB_TENSION_MAX - tb_min(tb_max(t142, TB_TENSION_MIN),
            TB_TENSION_MAX);
        const real_t t173 = tb_min(margin_0, margin_1);
        const bool t174 = t2 * t15 - t7 * t14 < TB_C(0.0);
        const bool t175 = TB_C(0.0) < t31;
        const real_t t176 = -t36;
        const bool t177 = TB_C(0.0) < t176;
        const bool t178 = (t55 || (TB_C(0.0) <= t16 && t174)) && !((t53 && t175) || (t58 &&
            t177));
        const real_t margin_2 = TB_TENSION_MAX - tb_min(tb_max(t143, TB_TENSION_MIN),
            TB_TENSION_MAX);
        const real_t t179 = tb_min(margin_0, margin_2);
        const real_t t180 = tb_min(t61 ? (t54 ? t9 * t173 : t173) : TB_C(1e+30), t178 ? (t174 ?
            t16 * t179 : t179) : TB_C(1e+30));
        const bool t181 = -(t2 * t22 + t7 * t20) < TB_C(0.0);
        const bool t182 = TB_C(0.0) < t33;
        const bool t183 = TB_C(0.0) < t36;
        const bool t184 = (t58 || (TB_C(0.0) <= t24 && t181)) && !((t53 && t182) || (t55 &&
            t183));
        const real_t margin_3 = TB_TENSION_MAX - tb_min(tb_max(t144, TB_TENSION_MIN),
            TB_TENSION_MAX);
        const real_t t185 = tb_min(margin_0, margin_3);
        const real_t t186 = tb_min(t180, t184 ? (t181 ? t24 * t185 : t185) : TB_C(1e+30));
        const real_t t187 = -t9;
        const bool t188 = TB_C(0.0) < t187;
        const real_t t189 = -t16;
        const bool t190 = TB_C(0.0) < t189;
        const real_t t191 = t23 - t21;
        const bool t192 = TB_C(0.0) < t191;
        const bool t193 = (t188 || (t54 && TB_C(0.0) <= t187)) && !((t175 && t190) || (t182 &&
            t192));
        const real_t t194 = tb_min(margin_1, margin_0);
        const real_t t195 = tb_min(t186, t193 ? (t54 ? -(t9 * t194) : t194) : TB_C(1e+30));
        const bool t196 = t8 * t15 + t6 * t14 < TB_C(0.0);
        const bool t197 = (t175 || (TB_C(0.0) <= t31 && t196)) && !((t55 && t188) || (t177 &&
            t182));
        const real_t t198 = tb_min(margin_1, margin_2);
        const real_t t199 = tb_min(t195, t197 ? (t196 ? t31 * t198 : t198) : TB_C(1e+30));
        const bool t200 = t6 * t20 - t8 * t22 < TB_C(0.0);
        const bool t201 = (t182 || (TB_C(0.0) <= t33 && t200)) && !((t58 && t188) || (t175 &&
            t183));
        const real_t t202 = tb_min(margin_1, margin_3);
        const real_t t203 = tb_min(t199, t201 ? (t200 ? t33 * t202 : t202) : TB_C(1e+30));
        const bool t204 = (t190 || (t174 && TB_C(0.0) <= t189)) && !((t57 && t188) || (t183 &&
            t192));
        const real_t t205 = tb_min(margin_2, margin_0);
        const real_t t206 = t204 ? (t174 ? -(t16 * t205) : t205) : TB_C(1e+30);
        const bool t207 = (t57 || (t196 && TB_C(0.0) <= t56)) && !((t53 && t190) || (t60 &&
            t183));
        const real_t t208 = tb_min(margin_2, margin_1);
        const real_t t209 = t207 ? (t196 ? -(t31 * t208) : t208) : TB_C(1e+30);
        const bool t210 = t14 * t20 - t15 * t22 < TB_C(0.0);
        const bool t211 = (t183 || (TB_C(0.0) <= t36 && t210)) && !((t58 && t190) || (t57 &&
            t182));
        const real_t t212 = tb_min(margin_2, margin_3);
        const real_t t213 = tb_min(tb_min(tb_min(t203, t206), t209), t211 ? (t210 ? t36 * t212
            : t212) : TB_C(1e+30));
        const bool t214 = (t192 || (t181 && TB_C(0.0) <= t191)) && !((t60 && t188) || (t177 &&
            t190));
        const real_t t215 = tb_min(margin_3, margin_0);
        const real_t t216 = t214 ? (t181 ? -(t24 * t215) : t215) : TB_C(1e+30);
        const bool t217 = (t60 || (t200 && TB_C(0.0) <= t59)) && !((t53 && t192) || (t57 &&
            t177));
        const real_t t218 = tb_min(margin_3, margin_1);
        const real_t t219 = t217 ? (t200 ? -(t33 * t218) : t218) : TB_C(1e+30);
        const bool t220 = (t177 || (t210 && TB_C(0.0) <= t176)) && !((t55 && t192) || (t60 &&
            t175));
        const real_t t221 = tb_min(margin_3, margin_2);
        const real_t t222 = t220 ? (t210 ? -(t36 * t221) : t221) : TB_C(1e+30);
        force_0 = tb_min(tb_min(tb_min(t213, t216), t219), t222);
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

