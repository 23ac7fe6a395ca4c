/* Regenerate: turnbuckle generate machines/yoon2023.toml --out generated/yoon2023
 * Machine 771308446b34ef3a, generator 0.1.0, casadi 3.8.2. Do not edit. */
#include "tb_quality.h"

tb_status tb_zero_wrench_tension(const real_t pose[2], const real_t rails[4], real_t tension[4])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) <=
              TB_C(5.6944))) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = rails[0] - pose[0];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 * t0 + pose[1] * pose[1]);
    const real_t t1 = TB_C(1.0) / length_0;
    const real_t t2 = t0 * t1;
    const real_t t3 = rails[1] - pose[1];
    const real_t t4 = TB_C(0.7118) - pose[0];
    const real_t length_1 = TB_SQRT(t4 * t4 + t3 * t3);
    const real_t t5 = TB_C(1.0) / length_1;
    const real_t t6 = t3 * t5;
    const real_t t7 = pose[1] * t1;
    const real_t t8 = t4 * t5;
    const real_t t9 = TB_ABS(t2 * t6 + t7 * t8);
    const real_t t10 = TB_C(0.4618) - pose[1];
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
    const real_t t21 = TB_C(6.5) * (t18 + (t13 + (t6 - t7)));
    const real_t t22 = TB_C(6.5) * (t14 + (t2 + t8) - t19);
    const real_t t23 = TB_C(3.5) * (t9 + t15 + t20) - TB_ABS(t2 * t21 + t7 * t22);
    const real_t t24 = TB_ABS(t8 * t13 - t6 * t14);
    const real_t t25 = TB_ABS(t8 * t18 + t6 * t19);
    const real_t t26 = TB_C(3.5) * (t9 + t24 + t25) - TB_ABS(t8 * t21 - t6 * t22);
    const real_t t27 = TB_ABS(t14 * t18 + t13 * t19);
    const real_t t28 = TB_C(3.5) * (t15 + t24 + t27) - TB_ABS(t14 * t21 - t13 * t22);
    const real_t t29 = TB_C(3.5) * (t27 + (t20 + t25)) - TB_ABS(t19 * t21 + t18 * t22);
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
    const real_t t45 = TB_C(80.0) * TB_EPSILON * t44;
    const real_t t46 = TB_C(3.0) - t45;
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
    const real_t t64 = TB_C(3.0) / tb_max(t54 * t54 + t61 * t61, TB_C(1e-30));
    const real_t t65 = t63 * t64;
    const real_t t66 = t45 + TB_C(10.0);
    const real_t t67 = tb_max(t46 - t65, t65 - t66);
    const bool t68 = TB_C(0.0) < t67;
    const real_t t69 = t14 * t60 - t58;
    const real_t t70 = t49 - t14 * t53;
    const real_t t71 = t62 * t69 - t55 * t70;
    const real_t t72 = t55 * t69 + t62 * t70;
    const real_t t73 = TB_EPSILON * TB_C(16.0);
    const real_t t74 = t61 * t69 - t54 * t70;
    const real_t t75 = t59 - t19 * t60;
    const real_t t76 = t19 * t53 - t52;
    const real_t t77 = t62 * t75 - t55 * t76;
    const real_t t78 = t55 * t75 + t62 * t76;
    const real_t t79 = t61 * t75 - t54 * t76;
    const real_t t80 = t45 * TB_C(2.0);
    const real_t t81 = t45 * TB_C(1024.0);
    real_t t82, t83, t84, t85, t86;
    if (t68) {
        const real_t t87 = tb_min(tb_max(t65, TB_C(3.0)), TB_C(10.0));
        const real_t t88 = TB_C(1.0) / tb_max(t55 * t55 + t62 * t62, TB_C(1e-30));
        const real_t t89 = t87 * t88;
        const real_t t90 = t54 * t62 - t55 * t61;
        const bool t91 = TB_ABS(t90) <= t73;
        const real_t t92 = t63 * t89;
        const real_t t93 = TB_C(1.0) / t90;
        real_t t94, t95, t96;
        if (t91) {
            t94 = -TB_C(1000000000000.0);
            t95 = TB_C(1000000000000.0);
            t96 = TB_C(0.0);
        } else {
            const real_t t97 = (t46 - t92) * t93;
            const real_t t98 = t93 * (t66 - t92);
            t94 = tb_min(t97, t98);
            t95 = tb_max(t97, t98);
            t96 = t80 * TB_ABS(t93);
        }
        const real_t t99 = tb_min(tb_max(TB_C(0.0), t94), t95);
        const real_t t100 = TB_C(0.0) < TB_ABS(t99) ? t99 * (t63 * t93) : TB_C(0.0);
        const real_t t101 = t65 < t87 ? t100 - t89 : t89 - t100;
        const real_t t102 = t94 + t96 < t95 - t96 && t81 < t67 ? t101 : TB_C(0.0);
        t82 = t71 * t89 - t72 * t99;
        t83 = t89 * t77 - t99 * t78;
        t84 = t92 + t90 * t99;
        t85 = t87;
        t86 = TB_C(0.0) < t101 ? t102 : TB_C(0.0);
    } else {
        t82 = t64 * t74;
        t83 = t64 * t79;
        t84 = TB_C(3.0);
        t85 = t65;
        t86 = TB_C(0.0);
    }
    const real_t t103 = tb_max(t46 - t82, t82 - t66);
    const bool t104 = TB_C(0.0) < t103;
    const real_t t105 = t70 * t76 + t69 * t75;
    const real_t t106 = t70 * t75;
    const real_t t107 = t69 * t76;
    real_t t108, t109, t110, t111, t112;
    if (t104) {
        const real_t t113 = tb_min(tb_max(t82, TB_C(3.0)), TB_C(10.0));
        const real_t t114 = TB_C(1.0) / tb_max(t70 * t70 + t69 * t69, TB_C(1e-30));
        const real_t t115 = t113 * t114;
        const bool t116 = TB_ABS(t72) <= t73;
        const real_t t117 = t71 * t115;
        const real_t t118 = TB_C(1.0) / t72;
        real_t t119, t120, t121;
        if (t116) {
            t119 = -TB_C(1000000000000.0);
            t120 = TB_C(1000000000000.0);
            t121 = TB_C(0.0);
        } else {
            const real_t t122 = (t46 - t117) * t118;
            const real_t t123 = t118 * (t66 - t117);
            t119 = tb_min(t122, t123);
            t120 = tb_max(t122, t123);
            t121 = t80 * TB_ABS(t118);
        }
        const real_t t124 = t61 * t70 + t54 * t69;
        const bool t125 = TB_ABS(t124) <= t73;
        const real_t t126 = t74 * t115;
        const real_t t127 = TB_C(1.0) / t124;
        real_t t128, t129, t130;
        if (t125) {
            t128 = -TB_C(1000000000000.0);
            t129 = TB_C(1000000000000.0);
            t130 = TB_C(0.0);
        } else {
            const real_t t131 = (t46 - t126) * t127;
            const real_t t132 = t127 * (t66 - t126);
            t128 = tb_min(t131, t132);
            t129 = tb_max(t131, t132);
            t130 = t80 * TB_ABS(t127);
        }
        const real_t t133 = tb_min(tb_max(TB_C(0.0), tb_max(t119, t128)), tb_min(t120, t129));
        real_t t134;
        if (TB_C(0.0) < TB_ABS(t133)) {
            const real_t t135 = t71 * t118;
            const real_t t136 = t74 * t127;
            const real_t t137 = TB_C(0.0) < t133 ? (t128 < t119 ? t135 : t136) : (t120 < t129 ?
                t135 : t136);
            t134 = t133 * t137;
        } else {
            t134 = TB_C(0.0);
        }
        const real_t t138 = t82 < t113 ? t134 - t115 : t115 - t134;
        real_t t139;
        if (TB_C(0.0) < t138) {
            const bool t140 = tb_max(t128 + t130, t119 + t121) < tb_min(t129 - t130, t120 -
                t121);
            t139 = t140 && t81 < t103 ? t138 : TB_C(0.0);
        } else {
            t139 = TB_C(0.0);
        }
        t108 = t105 * t115 + (t106 - t107) * t133;
        t109 = t126 + t124 * t133;
        t110 = t117 + t72 * t133;
        t111 = t113;
        t112 = t139;
    } else {
        t108 = t83;
        t109 = t84;
        t110 = t85;
        t111 = t82;
        t112 = t86;
    }
    const real_t t141 = tb_max(t46 - t108, t108 - t66);
    const bool t142 = TB_C(0.0) < t141;
    real_t t143, t144, t145, t146, t147;
    if (t142) {
        const real_t t148 = tb_min(tb_max(t108, TB_C(3.0)), TB_C(10.0));
        const real_t t149 = TB_C(1.0) / tb_max(t76 * t76 + t75 * t75, TB_C(1e-30));
        const real_t t150 = t148 * t149;
        const real_t t151 = t79 * t150;
        const real_t t152 = t61 * t76 + t54 * t75;
        const real_t t153 = t107 - t106;
        const bool t154 = TB_ABS(t153) <= t73;
        const real_t t155 = t105 * t150;
        const real_t t156 = TB_C(1.0) / t153;
        real_t t157, t158, t159;
        if (t154) {
            t157 = -TB_C(1000000000000.0);
            t158 = TB_C(1000000000000.0);
            t159 = TB_C(0.0);
        } else {
            const real_t t160 = (t46 - t155) * t156;
            const real_t t161 = t156 * (t66 - t155);
            t157 = tb_min(t160, t161);
            t158 = tb_max(t160, t161);
            t159 = t80 * TB_ABS(t156);
        }
        const bool t162 = TB_ABS(t78) <= t73;
        const real_t t163 = t77 * t150;
        const real_t t164 = TB_C(1.0) / t78;
        real_t t165, t166, t167;
        if (t162) {
            t165 = -TB_C(1000000000000.0);
            t166 = TB_C(1000000000000.0);
            t167 = TB_C(0.0);
        } else {
            const real_t t168 = (t46 - t163) * t164;
            const real_t t169 = t164 * (t66 - t163);
            t165 = tb_min(t168, t169);
            t166 = tb_max(t168, t169);
            t167 = t80 * TB_ABS(t164);
        }
        const bool t170 = TB_ABS(t152) <= t73;
        const real_t t171 = TB_C(1.0) / t152;
        real_t t172, t173, t174;
        if (t170) {
            t172 = -TB_C(1000000000000.0);
            t173 = TB_C(1000000000000.0);
            t174 = TB_C(0.0);
        } else {
            const real_t t175 = (t46 - t151) * t171;
            const real_t t176 = t171 * (t66 - t151);
            t172 = tb_min(t175, t176);
            t173 = tb_max(t175, t176);
            t174 = t80 * TB_ABS(t171);
        }
        const real_t t177 = tb_max(t165, t172);
        const real_t t178 = tb_min(t166, t173);
        const real_t t179 = tb_min(tb_max(TB_C(0.0), tb_max(t157, t177)), tb_min(t158, t178));
        real_t t180;
        if (TB_C(0.0) < TB_ABS(t179)) {
            const real_t t181 = t105 * t156;
            const real_t t182 = t77 * t164;
            const real_t t183 = t79 * t171;
            real_t t184;
            if (TB_C(0.0) < t179) {
                t184 = t177 < t157 ? t181 : (t172 < t165 ? t182 : t183);
            } else {
                t184 = t158 < t178 ? t181 : (t166 < t173 ? t182 : t183);
            }
            t180 = t179 * t184;
        } else {
            t180 = TB_C(0.0);
        }
        const real_t t185 = t108 < t148 ? t180 - t150 : t150 - t180;
        real_t t186;
        if (TB_C(0.0) < t185) {
            const real_t t187 = tb_max(tb_max(t172 + t174, t165 + t167), t157 + t159);
            const real_t t188 = tb_min(tb_min(t173 - t174, t166 - t167), t158 - t159);
            t186 = t187 < t188 && t81 < t141 ? t185 : TB_C(0.0);
        } else {
            t186 = TB_C(0.0);
        }
        t143 = t151 + t152 * t179;
        t144 = t163 + t78 * t179;
        t145 = t155 + t153 * t179;
        t146 = t148;
        t147 = t186;
    } else {
        t143 = t109;
        t144 = t110;
        t145 = t111;
        t146 = t108;
        t147 = t112;
    }
    const real_t t189 = tb_min(tb_max(t143, TB_C(3.0)), TB_C(10.0));
    const real_t tension_0 = t30 ? t189 : TB_C(3.0);
    const real_t t190 = tb_min(tb_max(t144, TB_C(3.0)), TB_C(10.0));
    const real_t tension_1 = t30 ? t190 : TB_C(3.0);
    const real_t t191 = tb_min(tb_max(t145, TB_C(3.0)), TB_C(10.0));
    const real_t tension_2 = t30 ? t191 : TB_C(3.0);
    const real_t t192 = tb_min(tb_max(t146, TB_C(3.0)), TB_C(10.0));
    const real_t tension_3 = t30 ? t192 : TB_C(3.0);
    const bool t193 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t194 = t193 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t195 = !t194;
    const real_t t196 = TB_EPSILON * TB_C(4096.0);
    const bool t197 = !(t196 < t34 && t196 < t43);
    const real_t t198 = TB_ABS(t2 * t189 + t8 * t190 + t14 * t191 - t19 * t192);
    const real_t t199 = TB_ABS(t6 * t190 - t7 * t189 + t13 * t191 + t18 * t192);
    const bool t200 = tb_max(tb_max(t147, t198), t199) <= t44 * (TB_EPSILON * TB_C(1280.0));
    const bool t201 = !(t31 || t200);
    if (t195) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        return TB_SINGULAR;
    }
    if (t197) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        return TB_SINGULAR;
    }
    if (t201) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        return TB_INACCURATE;
    }
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    return t31 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_tension_factor(const real_t pose[2], const real_t rails[4], real_t factor[1])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) <=
              TB_C(5.6944))) {
        factor[0] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = rails[0] - pose[0];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 * t0 + pose[1] * pose[1]);
    const real_t t1 = TB_C(1.0) / length_0;
    const real_t t2 = t0 * t1;
    const real_t t3 = rails[1] - pose[1];
    const real_t t4 = TB_C(0.7118) - pose[0];
    const real_t length_1 = TB_SQRT(t4 * t4 + t3 * t3);
    const real_t t5 = TB_C(1.0) / length_1;
    const real_t t6 = t3 * t5;
    const real_t t7 = pose[1] * t1;
    const real_t t8 = t4 * t5;
    const real_t t9 = TB_ABS(t2 * t6 + t7 * t8);
    const real_t t10 = TB_C(0.4618) - pose[1];
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
    const real_t t21 = TB_C(6.5) * (t18 + (t13 + (t6 - t7)));
    const real_t t22 = TB_C(6.5) * (t14 + (t2 + t8) - t19);
    const real_t t23 = TB_C(3.5) * (t9 + t15 + t20) - TB_ABS(t2 * t21 + t7 * t22);
    const real_t t24 = TB_ABS(t8 * t13 - t6 * t14);
    const real_t t25 = TB_ABS(t8 * t18 + t6 * t19);
    const real_t t26 = TB_C(3.5) * (t9 + t24 + t25) - TB_ABS(t8 * t21 - t6 * t22);
    const real_t t27 = TB_ABS(t14 * t18 + t13 * t19);
    const real_t t28 = TB_C(3.5) * (t15 + t24 + t27) - TB_ABS(t14 * t21 - t13 * t22);
    const real_t t29 = TB_C(3.5) * (t27 + (t20 + t25)) - TB_ABS(t19 * t21 + t18 * t22);
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
    real_t factor_0;
    if (t30) {
        const real_t t43 = TB_C(80.0) * TB_EPSILON / tb_min(t33, t42);
        const real_t t44 = TB_C(3.0) - t43;
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
        const real_t t62 = TB_C(3.0) / tb_max(t52 * t52 + t59 * t59, TB_C(1e-30));
        const real_t t63 = t61 * t62;
        const real_t t64 = t43 + TB_C(10.0);
        const bool t65 = TB_C(0.0) < tb_max(t44 - t63, t63 - t64);
        const real_t t66 = t14 * t58 - t56;
        const real_t t67 = t47 - t14 * t51;
        const real_t t68 = t60 * t66 - t53 * t67;
        const real_t t69 = t53 * t66 + t60 * t67;
        const real_t t70 = TB_EPSILON * TB_C(16.0);
        const real_t t71 = t59 * t66 - t52 * t67;
        const real_t t72 = t57 - t19 * t58;
        const real_t t73 = t19 * t51 - t50;
        const real_t t74 = t60 * t72 - t53 * t73;
        const real_t t75 = t53 * t72 + t60 * t73;
        const real_t t76 = t59 * t72 - t52 * t73;
        real_t t77, t78, t79, t80;
        if (t65) {
            const real_t t81 = tb_min(tb_max(t63, TB_C(3.0)), TB_C(10.0));
            const real_t t82 = TB_C(1.0) / tb_max(t53 * t53 + t60 * t60, TB_C(1e-30));
            const real_t t83 = t81 * t82;
            const real_t t84 = t52 * t60 - t53 * t59;
            const bool t85 = TB_ABS(t84) <= t70;
            const real_t t86 = t61 * t83;
            real_t t87, t88;
            if (t85) {
                t87 = -TB_C(1000000000000.0);
                t88 = TB_C(1000000000000.0);
            } else {
                const real_t t89 = TB_C(1.0) / t84;
                const real_t t90 = (t44 - t86) * t89;
                const real_t t91 = t89 * (t64 - t86);
                t87 = tb_min(t90, t91);
                t88 = tb_max(t90, t91);
            }
            const real_t t92 = tb_min(tb_max(TB_C(0.0), t87), t88);
            t77 = t68 * t83 - t69 * t92;
            t78 = t83 * t74 - t92 * t75;
            t79 = t86 + t84 * t92;
            t80 = t81;
        } else {
            t77 = t62 * t71;
            t78 = t62 * t76;
            t79 = TB_C(3.0);
            t80 = t63;
        }
        const bool t93 = TB_C(0.0) < tb_max(t44 - t77, t77 - t64);
        const real_t t94 = t67 * t73 + t66 * t72;
        const real_t t95 = t67 * t72;
        const real_t t96 = t66 * t73;
        real_t t97, t98, t99, t100;
        if (t93) {
            const real_t t101 = tb_min(tb_max(t77, TB_C(3.0)), TB_C(10.0));
            const real_t t102 = TB_C(1.0) / tb_max(t67 * t67 + t66 * t66, TB_C(1e-30));
            const real_t t103 = t101 * t102;
            const bool t104 = TB_ABS(t69) <= t70;
            const real_t t105 = t68 * t103;
            real_t t106, t107;
            if (t104) {
                t106 = -TB_C(1000000000000.0);
                t107 = TB_C(1000000000000.0);
            } else {
                const real_t t108 = TB_C(1.0) / t69;
                const real_t t109 = (t44 - t105) * t108;
                const real_t t110 = t108 * (t64 - t105);
                t106 = tb_min(t109, t110);
                t107 = tb_max(t109, t110);
            }
            const real_t t111 = t59 * t67 + t52 * t66;
            const bool t112 = TB_ABS(t111) <= t70;
            const real_t t113 = t71 * t103;
            real_t t114, t115;
            if (t112) {
                t114 = -TB_C(1000000000000.0);
                t115 = TB_C(1000000000000.0);
            } else {
                const real_t t116 = TB_C(1.0) / t111;
                const real_t t117 = (t44 - t113) * t116;
                const real_t t118 = t116 * (t64 - t113);
                t114 = tb_min(t117, t118);
                t115 = tb_max(t117, t118);
            }
            const real_t t119 = tb_min(tb_max(TB_C(0.0), tb_max(t106, t114)), tb_min(t107,
                t115));
            t97 = t94 * t103 + (t95 - t96) * t119;
            t98 = t113 + t111 * t119;
            t99 = t105 + t69 * t119;
            t100 = t101;
        } else {
            t97 = t78;
            t98 = t79;
            t99 = t80;
            t100 = t77;
        }
        const bool t120 = TB_C(0.0) < tb_max(t44 - t97, t97 - t64);
        real_t t121, t122, t123, t124;
        if (t120) {
            const real_t t125 = tb_min(tb_max(t97, TB_C(3.0)), TB_C(10.0));
            const real_t t126 = TB_C(1.0) / tb_max(t73 * t73 + t72 * t72, TB_C(1e-30));
            const real_t t127 = t125 * t126;
            const real_t t128 = t76 * t127;
            const real_t t129 = t59 * t73 + t52 * t72;
            const real_t t130 = t96 - t95;
            const bool t131 = TB_ABS(t130) <= t70;
            const real_t t132 = t94 * t127;
            real_t t133, t134;
            if (t131) {
                t133 = -TB_C(1000000000000.0);
                t134 = TB_C(1000000000000.0);
            } else {
                const real_t t135 = TB_C(1.0) / t130;
                const real_t t136 = (t44 - t132) * t135;
                const real_t t137 = t135 * (t64 - t132);
                t133 = tb_min(t136, t137);
                t134 = tb_max(t136, t137);
            }
            const bool t138 = TB_ABS(t75) <= t70;
            const real_t t139 = t74 * t127;
            real_t t140, t141;
            if (t138) {
                t140 = -TB_C(1000000000000.0);
                t141 = TB_C(1000000000000.0);
            } else {
                const real_t t142 = TB_C(1.0) / t75;
                const real_t t143 = (t44 - t139) * t142;
                const real_t t144 = t142 * (t64 - t139);
                t140 = tb_min(t143, t144);
                t141 = tb_max(t143, t144);
            }
            const bool t145 = TB_ABS(t129) <= t70;
            real_t t146, t147;
            if (t145) {
                t146 = -TB_C(1000000000000.0);
                t147 = TB_C(1000000000000.0);
            } else {
                const real_t t148 = TB_C(1.0) / t129;
                const real_t t149 = (t44 - t128) * t148;
                const real_t t150 = t148 * (t64 - t128);
                t146 = tb_min(t149, t150);
                t147 = tb_max(t149, t150);
            }
            const real_t t151 = tb_max(TB_C(0.0), tb_max(t133, tb_max(t140, t146)));
            const real_t t152 = tb_min(t151, tb_min(t134, tb_min(t141, t147)));
            t121 = t128 + t129 * t152;
            t122 = t139 + t75 * t152;
            t123 = t132 + t130 * t152;
            t124 = t125;
        } else {
            t121 = t98;
            t122 = t99;
            t123 = t100;
            t124 = t97;
        }
        /* T0 */
        const real_t rest_0 = tb_min(tb_max(t121, TB_C(3.0)), TB_C(10.0));
        const real_t rest_1 = tb_min(tb_max(t122, TB_C(3.0)), TB_C(10.0));
        const real_t rest_2 = tb_min(tb_max(t123, TB_C(3.0)), TB_C(10.0));
        const real_t rest_3 = tb_min(tb_max(t124, TB_C(3.0)), TB_C(10.0));
        const real_t t153 = tb_min(tb_min(tb_min(rest_0, rest_1), rest_2), rest_3);
        const real_t t154 = tb_max(tb_max(tb_max(rest_0, rest_1), rest_2), rest_3);
        factor_0 = t153 / t154;
    } else {
        factor_0 = TB_C(0.0);
    }
    const bool t155 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t156 = t155 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t157 = !t156;
    const real_t t158 = TB_EPSILON * TB_C(4096.0);
    const bool t159 = !(t158 < t33 && t158 < t42);
    const bool t160 = !t30;
    if (t157) {
        factor[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    if (t159) {
        factor[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    factor[0] = factor_0;
    return t160 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_isotropic_force(const real_t pose[2], const real_t rails[4], real_t force[1])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) <=
              TB_C(5.6944))) {
        force[0] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = rails[0] - pose[0];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 * t0 + pose[1] * pose[1]);
    const real_t t1 = TB_C(1.0) / length_0;
    const real_t t2 = t0 * t1;
    const real_t t3 = rails[1] - pose[1];
    const real_t t4 = TB_C(0.7118) - pose[0];
    const real_t length_1 = TB_SQRT(t4 * t4 + t3 * t3);
    const real_t t5 = TB_C(1.0) / length_1;
    const real_t t6 = t3 * t5;
    const real_t t7 = pose[1] * t1;
    const real_t t8 = t4 * t5;
    const real_t t9 = TB_ABS(t2 * t6 + t7 * t8);
    const real_t t10 = TB_C(0.4618) - pose[1];
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
    const real_t t21 = TB_C(6.5) * (t18 + (t13 + (t6 - t7)));
    const real_t t22 = TB_C(6.5) * (t14 + (t2 + t8) - t19);
    const real_t t23 = TB_C(3.5) * (t9 + t15 + t20) - TB_ABS(t2 * t21 + t7 * t22);
    const real_t t24 = TB_ABS(t8 * t13 - t6 * t14);
    const real_t t25 = TB_ABS(t8 * t18 + t6 * t19);
    const real_t t26 = TB_C(3.5) * (t9 + t24 + t25) - TB_ABS(t8 * t21 - t6 * t22);
    const real_t t27 = TB_ABS(t14 * t18 + t13 * t19);
    const real_t t28 = TB_C(3.5) * (t15 + t24 + t27) - TB_ABS(t14 * t21 - t13 * t22);
    const real_t t29 = TB_C(3.5) * (t27 + (t20 + t25)) - TB_ABS(t19 * t21 + t18 * t22);
    const real_t t30 = tb_min(tb_min(tb_min(t23, t26), t28), t29);
    const real_t force_0 = tb_max(TB_C(0.0), t30);
    const bool t31 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t32 = t31 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t33 = !t32;
    const bool t34 = !(TB_C(0.0) <= t30);
    if (t33) {
        force[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    force[0] = force_0;
    return t34 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_isotropic_force_eq17(const real_t pose[2], const real_t rails[4], real_t force[1])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) <=
              TB_C(5.6944))) {
        force[0] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = rails[0] - pose[0];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 * t0 + pose[1] * pose[1]);
    const real_t t1 = TB_C(1.0) / length_0;
    const real_t t2 = t0 * t1;
    const real_t t3 = rails[1] - pose[1];
    const real_t t4 = TB_C(0.7118) - pose[0];
    const real_t length_1 = TB_SQRT(t4 * t4 + t3 * t3);
    const real_t t5 = TB_C(1.0) / length_1;
    const real_t t6 = t3 * t5;
    const real_t t7 = pose[1] * t1;
    const real_t t8 = t4 * t5;
    const real_t t9 = t2 * t6 + t7 * t8;
    const real_t t10 = TB_ABS(t9);
    const real_t t11 = TB_C(0.4618) - pose[1];
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
    const real_t t26 = TB_C(6.5) * (t20 + (t14 + (t6 - t7)));
    const real_t t27 = TB_C(6.5) * (t15 + (t2 + t8) - t22);
    const real_t t28 = TB_C(3.5) * (t10 + t17 + t25) - TB_ABS(t2 * t26 + t7 * t27);
    const real_t t29 = t8 * t14;
    const real_t t30 = t6 * t15;
    const real_t t31 = t29 - t30;
    const real_t t32 = TB_ABS(t31);
    const real_t t33 = t8 * t20 + t6 * t22;
    const real_t t34 = TB_ABS(t33);
    const real_t t35 = TB_C(3.5) * (t10 + t32 + t34) - TB_ABS(t8 * t26 - t6 * t27);
    const real_t t36 = t15 * t20 + t14 * t22;
    const real_t t37 = TB_ABS(t36);
    const real_t t38 = TB_C(3.5) * (t17 + t32 + t37) - TB_ABS(t15 * t26 - t14 * t27);
    const real_t t39 = TB_C(3.5) * (t37 + (t25 + t34)) - TB_ABS(t22 * t26 + t20 * t27);
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
        const real_t t62 = TB_C(80.0) * TB_EPSILON / tb_min(t43, t52);
        const real_t t63 = TB_C(3.0) - t62;
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
        const real_t t81 = TB_C(3.0) / tb_max(t71 * t71 + t78 * t78, TB_C(1e-30));
        const real_t t82 = t80 * t81;
        const real_t t83 = TB_C(10.0) + t62;
        const bool t84 = TB_C(0.0) < tb_max(t63 - t82, t82 - t83);
        const real_t t85 = t15 * t77 - t75;
        const real_t t86 = t66 - t15 * t70;
        const real_t t87 = t79 * t85 - t72 * t86;
        const real_t t88 = t72 * t85 + t79 * t86;
        const real_t t89 = TB_EPSILON * TB_C(16.0);
        const real_t t90 = t78 * t85 - t71 * t86;
        const real_t t91 = t76 - t22 * t77;
        const real_t t92 = t22 * t70 - t69;
        const real_t t93 = t79 * t91 - t72 * t92;
        const real_t t94 = t72 * t91 + t79 * t92;
        const real_t t95 = t78 * t91 - t71 * t92;
        real_t t96, t97, t98, t99;
        if (t84) {
            const real_t t100 = tb_min(tb_max(t82, TB_C(3.0)), TB_C(10.0));
            const real_t t101 = TB_C(1.0) / tb_max(t72 * t72 + t79 * t79, TB_C(1e-30));
            const real_t t102 = t100 * t101;
            const real_t t103 = t71 * t79 - t72 * t78;
            const bool t104 = TB_ABS(t103) <= t89;
            const real_t t105 = t80 * t102;
            real_t t106, t107;
            if (t104) {
                t106 = -TB_C(1000000000000.0);
                t107 = TB_C(1000000000000.0);
            } else {
                const real_t t108 = TB_C(1.0) / t103;
                const real_t t109 = (t63 - t105) * t108;
                const real_t t110 = t108 * (t83 - t105);
                t106 = tb_min(t109, t110);
                t107 = tb_max(t109, t110);
            }
            const real_t t111 = tb_min(tb_max(TB_C(0.0), t106), t107);
            t96 = t87 * t102 - t88 * t111;
            t97 = t102 * t93 - t111 * t94;
            t98 = t105 + t103 * t111;
            t99 = t100;
        } else {
            t96 = t81 * t90;
            t97 = t81 * t95;
            t98 = TB_C(3.0);
            t99 = t82;
        }
        const bool t112 = TB_C(0.0) < tb_max(t63 - t96, t96 - t83);
        const real_t t113 = t86 * t92 + t85 * t91;
        const real_t t114 = t86 * t91;
        const real_t t115 = t85 * t92;
        real_t t116, t117, t118, t119;
        if (t112) {
            const real_t t120 = tb_min(tb_max(t96, TB_C(3.0)), TB_C(10.0));
            const real_t t121 = TB_C(1.0) / tb_max(t86 * t86 + t85 * t85, TB_C(1e-30));
            const real_t t122 = t120 * t121;
            const bool t123 = TB_ABS(t88) <= t89;
            const real_t t124 = t87 * t122;
            real_t t125, t126;
            if (t123) {
                t125 = -TB_C(1000000000000.0);
                t126 = TB_C(1000000000000.0);
            } else {
                const real_t t127 = TB_C(1.0) / t88;
                const real_t t128 = (t63 - t124) * t127;
                const real_t t129 = t127 * (t83 - t124);
                t125 = tb_min(t128, t129);
                t126 = tb_max(t128, t129);
            }
            const real_t t130 = t78 * t86 + t71 * t85;
            const bool t131 = TB_ABS(t130) <= t89;
            const real_t t132 = t90 * t122;
            real_t t133, t134;
            if (t131) {
                t133 = -TB_C(1000000000000.0);
                t134 = TB_C(1000000000000.0);
            } else {
                const real_t t135 = TB_C(1.0) / t130;
                const real_t t136 = (t63 - t132) * t135;
                const real_t t137 = t135 * (t83 - t132);
                t133 = tb_min(t136, t137);
                t134 = tb_max(t136, t137);
            }
            const real_t t138 = tb_min(tb_max(TB_C(0.0), tb_max(t125, t133)), tb_min(t126,
                t134));
            t116 = t113 * t122 + (t114 - t115) * t138;
            t117 = t132 + t130 * t138;
            t118 = t124 + t88 * t138;
            t119 = t120;
        } else {
            t116 = t97;
            t117 = t98;
            t118 = t99;
            t119 = t96;
        }
        const bool t139 = TB_C(0.0) < tb_max(t63 - t116, t116 - t83);
        real_t t140, t141, t142, t143;
        if (t139) {
            const real_t t144 = tb_min(tb_max(t116, TB_C(3.0)), TB_C(10.0));
            const real_t t145 = TB_C(1.0) / tb_max(t92 * t92 + t91 * t91, TB_C(1e-30));
            const real_t t146 = t144 * t145;
            const real_t t147 = t95 * t146;
            const real_t t148 = t78 * t92 + t71 * t91;
            const real_t t149 = t115 - t114;
            const bool t150 = TB_ABS(t149) <= t89;
            const real_t t151 = t113 * t146;
            real_t t152, t153;
            if (t150) {
                t152 = -TB_C(1000000000000.0);
                t153 = TB_C(1000000000000.0);
            } else {
                const real_t t154 = TB_C(1.0) / t149;
                const real_t t155 = (t63 - t151) * t154;
                const real_t t156 = t154 * (t83 - t151);
                t152 = tb_min(t155, t156);
                t153 = tb_max(t155, t156);
            }
            const bool t157 = TB_ABS(t94) <= t89;
            const real_t t158 = t93 * t146;
            real_t t159, t160;
            if (t157) {
                t159 = -TB_C(1000000000000.0);
                t160 = TB_C(1000000000000.0);
            } else {
                const real_t t161 = TB_C(1.0) / t94;
                const real_t t162 = (t63 - t158) * t161;
                const real_t t163 = t161 * (t83 - t158);
                t159 = tb_min(t162, t163);
                t160 = tb_max(t162, t163);
            }
            const bool t164 = TB_ABS(t148) <= t89;
            real_t t165, t166;
            if (t164) {
                t165 = -TB_C(1000000000000.0);
                t166 = TB_C(1000000000000.0);
            } else {
                const real_t t167 = TB_C(1.0) / t148;
                const real_t t168 = (t63 - t147) * t167;
                const real_t t169 = t167 * (t83 - t147);
                t165 = tb_min(t168, t169);
                t166 = tb_max(t168, t169);
            }
            const real_t t170 = tb_max(TB_C(0.0), tb_max(t152, tb_max(t159, t165)));
            const real_t t171 = tb_min(t170, tb_min(t153, tb_min(t160, t166)));
            t140 = t147 + t148 * t171;
            t141 = t158 + t94 * t171;
            t142 = t151 + t149 * t171;
            t143 = t144;
        } else {
            t140 = t117;
            t141 = t118;
            t142 = t119;
            t143 = t116;
        }
        /* t_i = T_max - T0_i */
        const real_t margin_0 = TB_C(10.0) - tb_min(tb_max(t140, TB_C(3.0)), TB_C(10.0));
        const real_t margin_1 = TB_C(10.0) - tb_min(tb_max(t141, TB_C(3.0)), TB_C(10.0));
        const real_t t172 = tb_min(margin_0, margin_1);
        const bool t173 = t2 * t15 - t7 * t14 < TB_C(0.0);
        const bool t174 = TB_C(0.0) < t31;
        const real_t t175 = -t36;
        const bool t176 = TB_C(0.0) < t175;
        const bool t177 = (t55 || (TB_C(0.0) <= t16 && t173)) && !((t53 && t174) || (t58 &&
            t176));
        const real_t margin_2 = TB_C(10.0) - tb_min(tb_max(t142, TB_C(3.0)), TB_C(10.0));
        const real_t t178 = tb_min(margin_0, margin_2);
        const real_t t179 = tb_min(t61 ? (t54 ? t9 * t172 : t172) : TB_C(1e+30), t177 ? (t173 ?
            t16 * t178 : t178) : TB_C(1e+30));
        const bool t180 = -(t2 * t22 + t7 * t20) < TB_C(0.0);
        const bool t181 = TB_C(0.0) < t33;
        const bool t182 = TB_C(0.0) < t36;
        const bool t183 = (t58 || (TB_C(0.0) <= t24 && t180)) && !((t53 && t181) || (t55 &&
            t182));
        const real_t margin_3 = TB_C(10.0) - tb_min(tb_max(t143, TB_C(3.0)), TB_C(10.0));
        const real_t t184 = tb_min(margin_0, margin_3);
        const real_t t185 = tb_min(t179, t183 ? (t180 ? t24 * t184 : t184) : TB_C(1e+30));
        const real_t t186 = -t9;
        const bool t187 = TB_C(0.0) < t186;
        const real_t t188 = -t16;
        const bool t189 = TB_C(0.0) < t188;
        const real_t t190 = t23 - t21;
        const bool t191 = TB_C(0.0) < t190;
        const bool t192 = (t187 || (t54 && TB_C(0.0) <= t186)) && !((t174 && t189) || (t181 &&
            t191));
        const real_t t193 = tb_min(margin_1, margin_0);
        const real_t t194 = tb_min(t185, t192 ? (t54 ? -(t9 * t193) : t193) : TB_C(1e+30));
        const bool t195 = t8 * t15 + t6 * t14 < TB_C(0.0);
        const bool t196 = (t174 || (TB_C(0.0) <= t31 && t195)) && !((t55 && t187) || (t176 &&
            t181));
        const real_t t197 = tb_min(margin_1, margin_2);
        const real_t t198 = tb_min(t194, t196 ? (t195 ? t31 * t197 : t197) : TB_C(1e+30));
        const bool t199 = t6 * t20 - t8 * t22 < TB_C(0.0);
        const bool t200 = (t181 || (TB_C(0.0) <= t33 && t199)) && !((t58 && t187) || (t174 &&
            t182));
        const real_t t201 = tb_min(margin_1, margin_3);
        const real_t t202 = tb_min(t198, t200 ? (t199 ? t33 * t201 : t201) : TB_C(1e+30));
        const bool t203 = (t189 || (t173 && TB_C(0.0) <= t188)) && !((t57 && t187) || (t182 &&
            t191));
        const real_t t204 = tb_min(margin_2, margin_0);
        const real_t t205 = t203 ? (t173 ? -(t16 * t204) : t204) : TB_C(1e+30);
        const bool t206 = (t57 || (t195 && TB_C(0.0) <= t56)) && !((t53 && t189) || (t60 &&
            t182));
        const real_t t207 = tb_min(margin_2, margin_1);
        const real_t t208 = t206 ? (t195 ? -(t31 * t207) : t207) : TB_C(1e+30);
        const bool t209 = t14 * t20 - t15 * t22 < TB_C(0.0);
        const bool t210 = (t182 || (TB_C(0.0) <= t36 && t209)) && !((t58 && t189) || (t57 &&
            t181));
        const real_t t211 = tb_min(margin_2, margin_3);
        const real_t t212 = tb_min(tb_min(tb_min(t202, t205), t208), t210 ? (t209 ? t36 * t211
            : t211) : TB_C(1e+30));
        const bool t213 = (t191 || (t180 && TB_C(0.0) <= t190)) && !((t60 && t187) || (t176 &&
            t189));
        const real_t t214 = tb_min(margin_3, margin_0);
        const real_t t215 = t213 ? (t180 ? -(t24 * t214) : t214) : TB_C(1e+30);
        const bool t216 = (t60 || (t199 && TB_C(0.0) <= t59)) && !((t53 && t191) || (t57 &&
            t176));
        const real_t t217 = tb_min(margin_3, margin_1);
        const real_t t218 = t216 ? (t199 ? -(t33 * t217) : t217) : TB_C(1e+30);
        const bool t219 = (t176 || (t209 && TB_C(0.0) <= t175)) && !((t55 && t191) || (t60 &&
            t174));
        const real_t t220 = tb_min(margin_3, margin_2);
        const real_t t221 = t219 ? (t209 ? -(t36 * t220) : t220) : TB_C(1e+30);
        force_0 = tb_min(tb_min(tb_min(t212, t215), t218), t221);
    } else {
        force_0 = TB_C(0.0);
    }
    const bool t222 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t223 = t222 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t224 = !t223;
    const real_t t225 = TB_EPSILON * TB_C(4096.0);
    const bool t226 = !(t225 < t43 && t225 < t52);
    const bool t227 = !t40;
    if (t224) {
        force[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    if (t226) {
        force[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    force[0] = force_0;
    return t227 ? TB_INFEASIBLE : TB_OK;
}

