/* Regenerate: turnbuckle generate machines/yoon2023.toml --out generated/yoon2023
 * Machine c2e26558649395a1, generator 0.1.0, casadi 3.8.2. Do not edit. */
#include "tb_quality.h"

tb_status tb_zero_wrench_tension(const real_t pose[2], const real_t rails[4], real_t tension[4])
{
    if (!(pose[0] >= -TB_C(0.7118) && pose[0] <= TB_C(1.4236)
          && pose[1] >= -TB_C(0.4618) && pose[1] <= TB_C(0.9236)
          && rails[0] >= -TB_C(0.7118) && rails[0] <= TB_C(1.4236)
          && rails[1] >= -TB_C(0.4618) && rails[1] <= TB_C(0.9236)
          && rails[2] >= -TB_C(0.7118) && rails[2] <= TB_C(1.4236)
          && rails[3] >= -TB_C(0.4618) && rails[3] <= TB_C(0.9236))) {
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
    const real_t t34 = t2 + t33;
    const real_t t35 = TB_C(1.0) / (t32 * (t32 + TB_ABS(t2)));
    const real_t t36 = (t6 * t8 - t7 * t34 + t13 * t14 - t18 * t19) * t35;
    const real_t t37 = t6 - t8 * t36;
    const real_t t38 = t13 - t14 * t36;
    const real_t t39 = t18 + t19 * t36;
    const real_t t40 = TB_SQRT(t37 * t37 + t38 * t38 + t39 * t39);
    const real_t t41 = TB_COPYSIGN(t40, t37);
    const real_t t42 = tb_min(TB_ABS(t33), TB_ABS(t41));
    const real_t t43 = TB_C(1.0) / t42;
    const real_t t44 = TB_C(80.0) * TB_EPSILON * t43;
    const real_t t45 = TB_C(3.0) - t44;
    const real_t t46 = TB_C(1.0) / (t40 * (t40 + TB_ABS(t37)));
    const real_t t47 = t38 * t46;
    const real_t t48 = TB_C(1.0) - t38 * t47;
    const real_t t49 = t37 + t41;
    const real_t t50 = t47 * t49;
    const real_t t51 = t39 * t47;
    const real_t t52 = t35 * (t14 * t48 - t8 * t50 + t19 * t51);
    const real_t t53 = t34 * t52;
    const real_t t54 = t50 + t8 * t52;
    const real_t t55 = t39 * t46;
    const real_t t56 = t49 * t55;
    const real_t t57 = t38 * t55;
    const real_t t58 = TB_C(1.0) - t39 * t55;
    const real_t t59 = t35 * (t8 * t56 + t14 * t57 + t19 * t58);
    const real_t t60 = t34 * t59;
    const real_t t61 = t8 * t59 - t56;
    const real_t t62 = t53 * t54 + t60 * t61;
    const real_t t63 = TB_C(3.0) / (t53 * t53 + t60 * t60);
    const real_t t64 = t62 * t63;
    const real_t t65 = t44 + TB_C(10.0);
    const bool t66 = TB_C(0.0) < tb_max(t45 - t64, t64 - t65);
    const real_t t67 = t14 * t59 - t57;
    const real_t t68 = t48 - t14 * t52;
    const real_t t69 = t61 * t67 - t54 * t68;
    const real_t t70 = t54 * t67 + t61 * t68;
    const real_t t71 = TB_EPSILON * TB_C(16.0);
    const real_t t72 = t60 * t67 - t53 * t68;
    const real_t t73 = t58 - t19 * t59;
    const real_t t74 = t19 * t52 - t51;
    const real_t t75 = t61 * t73 - t54 * t74;
    const real_t t76 = t54 * t73 + t61 * t74;
    const real_t t77 = t60 * t73 - t53 * t74;
    real_t t78, t79, t80, t81, t82;
    if (t66) {
        const real_t t83 = tb_min(tb_max(t64, TB_C(3.0)), TB_C(10.0));
        const real_t t84 = t83 / (t54 * t54 + t61 * t61);
        const real_t t85 = t53 * t61 - t54 * t60;
        const bool t86 = TB_ABS(t85) <= t71;
        const real_t t87 = t62 * t84;
        const real_t t88 = TB_C(1.0) / t85;
        real_t t89, t90;
        if (t86) {
            t89 = -TB_C(1000000000000.0);
            t90 = TB_C(1000000000000.0);
        } else {
            const real_t t91 = (t45 - t87) * t88;
            const real_t t92 = t88 * (t65 - t87);
            const real_t t93 = tb_min(t91, t92);
            const real_t t94 = tb_max(t91, t92);
            t89 = t93;
            t90 = t94;
        }
        const real_t t95 = tb_min(tb_max(TB_C(0.0), t89), t90);
        const real_t t96 = t69 * t84 - t70 * t95;
        const real_t t97 = t84 * t75 - t95 * t76;
        const real_t t98 = t87 + t85 * t95;
        const real_t t99 = TB_C(0.0) < TB_ABS(t95) ? t95 * (t62 * t88) : TB_C(0.0);
        const real_t t100 = tb_max(TB_C(0.0), t64 < t83 ? t99 - t84 : t84 - t99);
        t78 = t96;
        t79 = t97;
        t80 = t98;
        t81 = t83;
        t82 = t100;
    } else {
        const real_t t101 = t63 * t72;
        const real_t t102 = t63 * t77;
        t78 = t101;
        t79 = t102;
        t80 = TB_C(3.0);
        t81 = t64;
        t82 = TB_C(0.0);
    }
    const bool t103 = TB_C(0.0) < tb_max(t45 - t78, t78 - t65);
    const real_t t104 = t68 * t74 + t67 * t73;
    const real_t t105 = t68 * t73;
    const real_t t106 = t67 * t74;
    real_t t107, t108, t109, t110, t111;
    if (t103) {
        const real_t t112 = tb_min(tb_max(t78, TB_C(3.0)), TB_C(10.0));
        const real_t t113 = t112 / (t68 * t68 + t67 * t67);
        const bool t114 = TB_ABS(t70) <= t71;
        const real_t t115 = t69 * t113;
        const real_t t116 = TB_C(1.0) / t70;
        real_t t117, t118;
        if (t114) {
            t117 = -TB_C(1000000000000.0);
            t118 = TB_C(1000000000000.0);
        } else {
            const real_t t119 = (t45 - t115) * t116;
            const real_t t120 = t116 * (t65 - t115);
            const real_t t121 = tb_min(t119, t120);
            const real_t t122 = tb_max(t119, t120);
            t117 = t121;
            t118 = t122;
        }
        const real_t t123 = t60 * t68 + t53 * t67;
        const bool t124 = TB_ABS(t123) <= t71;
        const real_t t125 = t72 * t113;
        const real_t t126 = TB_C(1.0) / t123;
        real_t t127, t128;
        if (t124) {
            t127 = -TB_C(1000000000000.0);
            t128 = TB_C(1000000000000.0);
        } else {
            const real_t t129 = (t45 - t125) * t126;
            const real_t t130 = t126 * (t65 - t125);
            const real_t t131 = tb_min(t129, t130);
            const real_t t132 = tb_max(t129, t130);
            t127 = t131;
            t128 = t132;
        }
        const real_t t133 = tb_min(tb_max(TB_C(0.0), tb_max(t117, t127)), tb_min(t118, t128));
        const real_t t134 = t104 * t113 + (t105 - t106) * t133;
        const real_t t135 = t125 + t123 * t133;
        const real_t t136 = t115 + t70 * t133;
        real_t t137;
        if (TB_C(0.0) < TB_ABS(t133)) {
            const real_t t138 = t69 * t116;
            const real_t t139 = t72 * t126;
            const real_t t140 = TB_C(0.0) < t133 ? (t127 < t117 ? t138 : t139) : (t118 < t128 ?
                t138 : t139);
            const real_t t141 = t133 * t140;
            t137 = t141;
        } else {
            t137 = TB_C(0.0);
        }
        const real_t t142 = tb_max(TB_C(0.0), t78 < t112 ? t137 - t113 : t113 - t137);
        t107 = t134;
        t108 = t135;
        t109 = t136;
        t110 = t112;
        t111 = t142;
    } else {
        t107 = t79;
        t108 = t80;
        t109 = t81;
        t110 = t78;
        t111 = t82;
    }
    const bool t143 = TB_C(0.0) < tb_max(t45 - t107, t107 - t65);
    real_t t144, t145, t146, t147, t148;
    if (t143) {
        const real_t t149 = tb_min(tb_max(t107, TB_C(3.0)), TB_C(10.0));
        const real_t t150 = t149 / (t74 * t74 + t73 * t73);
        const real_t t151 = t77 * t150;
        const real_t t152 = t60 * t74 + t53 * t73;
        const real_t t153 = t106 - t105;
        const bool t154 = TB_ABS(t153) <= t71;
        const real_t t155 = t104 * t150;
        const real_t t156 = TB_C(1.0) / t153;
        real_t t157, t158;
        if (t154) {
            t157 = -TB_C(1000000000000.0);
            t158 = TB_C(1000000000000.0);
        } else {
            const real_t t159 = (t45 - t155) * t156;
            const real_t t160 = t156 * (t65 - t155);
            const real_t t161 = tb_min(t159, t160);
            const real_t t162 = tb_max(t159, t160);
            t157 = t161;
            t158 = t162;
        }
        const bool t163 = TB_ABS(t76) <= t71;
        const real_t t164 = t75 * t150;
        const real_t t165 = TB_C(1.0) / t76;
        real_t t166, t167;
        if (t163) {
            t166 = -TB_C(1000000000000.0);
            t167 = TB_C(1000000000000.0);
        } else {
            const real_t t168 = (t45 - t164) * t165;
            const real_t t169 = t165 * (t65 - t164);
            const real_t t170 = tb_min(t168, t169);
            const real_t t171 = tb_max(t168, t169);
            t166 = t170;
            t167 = t171;
        }
        const bool t172 = TB_ABS(t152) <= t71;
        const real_t t173 = TB_C(1.0) / t152;
        real_t t174, t175;
        if (t172) {
            t174 = -TB_C(1000000000000.0);
            t175 = TB_C(1000000000000.0);
        } else {
            const real_t t176 = (t45 - t151) * t173;
            const real_t t177 = t173 * (t65 - t151);
            const real_t t178 = tb_min(t176, t177);
            const real_t t179 = tb_max(t176, t177);
            t174 = t178;
            t175 = t179;
        }
        const real_t t180 = tb_max(t166, t174);
        const real_t t181 = tb_min(t167, t175);
        const real_t t182 = tb_min(tb_max(TB_C(0.0), tb_max(t157, t180)), tb_min(t158, t181));
        const real_t t183 = t151 + t152 * t182;
        const real_t t184 = t164 + t76 * t182;
        const real_t t185 = t155 + t153 * t182;
        real_t t186;
        if (TB_C(0.0) < TB_ABS(t182)) {
            const real_t t187 = t104 * t156;
            const real_t t188 = t75 * t165;
            const real_t t189 = t77 * t173;
            real_t t190;
            if (TB_C(0.0) < t182) {
                const real_t t191 = t180 < t157 ? t187 : (t174 < t166 ? t188 : t189);
                t190 = t191;
            } else {
                const real_t t192 = t158 < t181 ? t187 : (t167 < t175 ? t188 : t189);
                t190 = t192;
            }
            const real_t t193 = t182 * t190;
            t186 = t193;
        } else {
            t186 = TB_C(0.0);
        }
        const real_t t194 = tb_max(TB_C(0.0), t107 < t149 ? t186 - t150 : t150 - t186);
        t144 = t183;
        t145 = t184;
        t146 = t185;
        t147 = t149;
        t148 = t194;
    } else {
        t144 = t108;
        t145 = t109;
        t146 = t110;
        t147 = t107;
        t148 = t111;
    }
    const real_t t195 = tb_min(tb_max(t144, TB_C(3.0)), TB_C(10.0));
    const real_t tension_0 = t30 ? t195 : TB_C(3.0);
    const real_t t196 = tb_min(tb_max(t145, TB_C(3.0)), TB_C(10.0));
    const real_t tension_1 = t30 ? t196 : TB_C(3.0);
    const real_t t197 = tb_min(tb_max(t146, TB_C(3.0)), TB_C(10.0));
    const real_t tension_2 = t30 ? t197 : TB_C(3.0);
    const real_t t198 = tb_min(tb_max(t147, TB_C(3.0)), TB_C(10.0));
    const real_t tension_3 = t30 ? t198 : TB_C(3.0);
    const bool t199 = length_0 < TB_C(0.0001) || length_1 < TB_C(0.0001);
    const bool t200 = t199 || length_2 < TB_C(0.0001) || length_3 < TB_C(0.0001);
    const bool t201 = !(TB_EPSILON * TB_C(4096.0) < t42);
    const real_t t202 = TB_ABS(t2 * t195 + t8 * t196 + t14 * t197 - t19 * t198);
    const real_t t203 = TB_ABS(t6 * t196 - t7 * t195 + t13 * t197 + t18 * t198);
    const bool t204 = tb_max(tb_max(t148, t202), t203) <= t43 * (TB_EPSILON * TB_C(640.0));
    const bool t205 = !(t31 || t204);
    if (t200) {
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
        return TB_SINGULAR;
    }
    if (t205) {
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
    if (!(pose[0] >= -TB_C(0.7118) && pose[0] <= TB_C(1.4236)
          && pose[1] >= -TB_C(0.4618) && pose[1] <= TB_C(0.9236)
          && rails[0] >= -TB_C(0.7118) && rails[0] <= TB_C(1.4236)
          && rails[1] >= -TB_C(0.4618) && rails[1] <= TB_C(0.9236)
          && rails[2] >= -TB_C(0.7118) && rails[2] <= TB_C(1.4236)
          && rails[3] >= -TB_C(0.4618) && rails[3] <= TB_C(0.9236))) {
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
    const real_t t33 = t2 + t32;
    const real_t t34 = TB_C(1.0) / (t31 * (t31 + TB_ABS(t2)));
    const real_t t35 = (t6 * t8 - t7 * t33 + t13 * t14 - t18 * t19) * t34;
    const real_t t36 = t6 - t8 * t35;
    const real_t t37 = t13 - t14 * t35;
    const real_t t38 = t18 + t19 * t35;
    const real_t t39 = TB_SQRT(t36 * t36 + t37 * t37 + t38 * t38);
    const real_t t40 = TB_COPYSIGN(t39, t36);
    const real_t t41 = tb_min(TB_ABS(t32), TB_ABS(t40));
    real_t factor_0;
    if (t30) {
        const real_t t42 = TB_C(80.0) * TB_EPSILON / t41;
        const real_t t43 = TB_C(3.0) - t42;
        const real_t t44 = TB_C(1.0) / (t39 * (t39 + TB_ABS(t36)));
        const real_t t45 = t37 * t44;
        const real_t t46 = TB_C(1.0) - t37 * t45;
        const real_t t47 = t36 + t40;
        const real_t t48 = t45 * t47;
        const real_t t49 = t38 * t45;
        const real_t t50 = t34 * (t14 * t46 - t8 * t48 + t19 * t49);
        const real_t t51 = t33 * t50;
        const real_t t52 = t48 + t8 * t50;
        const real_t t53 = t38 * t44;
        const real_t t54 = t47 * t53;
        const real_t t55 = t37 * t53;
        const real_t t56 = TB_C(1.0) - t38 * t53;
        const real_t t57 = t34 * (t8 * t54 + t14 * t55 + t19 * t56);
        const real_t t58 = t33 * t57;
        const real_t t59 = t8 * t57 - t54;
        const real_t t60 = t51 * t52 + t58 * t59;
        const real_t t61 = TB_C(3.0) / (t51 * t51 + t58 * t58);
        const real_t t62 = t60 * t61;
        const real_t t63 = t42 + TB_C(10.0);
        const bool t64 = TB_C(0.0) < tb_max(t43 - t62, t62 - t63);
        const real_t t65 = t14 * t57 - t55;
        const real_t t66 = t46 - t14 * t50;
        const real_t t67 = t59 * t65 - t52 * t66;
        const real_t t68 = t52 * t65 + t59 * t66;
        const real_t t69 = TB_EPSILON * TB_C(16.0);
        const real_t t70 = t58 * t65 - t51 * t66;
        const real_t t71 = t56 - t19 * t57;
        const real_t t72 = t19 * t50 - t49;
        const real_t t73 = t59 * t71 - t52 * t72;
        const real_t t74 = t52 * t71 + t59 * t72;
        const real_t t75 = t58 * t71 - t51 * t72;
        real_t t76, t77, t78, t79;
        if (t64) {
            const real_t t80 = tb_min(tb_max(t62, TB_C(3.0)), TB_C(10.0));
            const real_t t81 = t80 / (t52 * t52 + t59 * t59);
            const real_t t82 = t51 * t59 - t52 * t58;
            const bool t83 = TB_ABS(t82) <= t69;
            const real_t t84 = t60 * t81;
            real_t t85, t86;
            if (t83) {
                t85 = -TB_C(1000000000000.0);
                t86 = TB_C(1000000000000.0);
            } else {
                const real_t t87 = TB_C(1.0) / t82;
                const real_t t88 = (t43 - t84) * t87;
                const real_t t89 = t87 * (t63 - t84);
                const real_t t90 = tb_min(t88, t89);
                const real_t t91 = tb_max(t88, t89);
                t85 = t90;
                t86 = t91;
            }
            const real_t t92 = tb_min(tb_max(TB_C(0.0), t85), t86);
            const real_t t93 = t67 * t81 - t68 * t92;
            const real_t t94 = t81 * t73 - t92 * t74;
            const real_t t95 = t84 + t82 * t92;
            t76 = t93;
            t77 = t94;
            t78 = t95;
            t79 = t80;
        } else {
            const real_t t96 = t61 * t70;
            const real_t t97 = t61 * t75;
            t76 = t96;
            t77 = t97;
            t78 = TB_C(3.0);
            t79 = t62;
        }
        const bool t98 = TB_C(0.0) < tb_max(t43 - t76, t76 - t63);
        const real_t t99 = t66 * t72 + t65 * t71;
        const real_t t100 = t66 * t71;
        const real_t t101 = t65 * t72;
        real_t t102, t103, t104, t105;
        if (t98) {
            const real_t t106 = tb_min(tb_max(t76, TB_C(3.0)), TB_C(10.0));
            const real_t t107 = t106 / (t66 * t66 + t65 * t65);
            const bool t108 = TB_ABS(t68) <= t69;
            const real_t t109 = t67 * t107;
            real_t t110, t111;
            if (t108) {
                t110 = -TB_C(1000000000000.0);
                t111 = TB_C(1000000000000.0);
            } else {
                const real_t t112 = TB_C(1.0) / t68;
                const real_t t113 = (t43 - t109) * t112;
                const real_t t114 = t112 * (t63 - t109);
                const real_t t115 = tb_min(t113, t114);
                const real_t t116 = tb_max(t113, t114);
                t110 = t115;
                t111 = t116;
            }
            const real_t t117 = t58 * t66 + t51 * t65;
            const bool t118 = TB_ABS(t117) <= t69;
            const real_t t119 = t70 * t107;
            real_t t120, t121;
            if (t118) {
                t120 = -TB_C(1000000000000.0);
                t121 = TB_C(1000000000000.0);
            } else {
                const real_t t122 = TB_C(1.0) / t117;
                const real_t t123 = (t43 - t119) * t122;
                const real_t t124 = t122 * (t63 - t119);
                const real_t t125 = tb_min(t123, t124);
                const real_t t126 = tb_max(t123, t124);
                t120 = t125;
                t121 = t126;
            }
            const real_t t127 = tb_min(tb_max(TB_C(0.0), tb_max(t110, t120)), tb_min(t111,
                t121));
            const real_t t128 = t99 * t107 + (t100 - t101) * t127;
            const real_t t129 = t119 + t117 * t127;
            const real_t t130 = t109 + t68 * t127;
            t102 = t128;
            t103 = t129;
            t104 = t130;
            t105 = t106;
        } else {
            t102 = t77;
            t103 = t78;
            t104 = t79;
            t105 = t76;
        }
        const bool t131 = TB_C(0.0) < tb_max(t43 - t102, t102 - t63);
        real_t t132, t133, t134, t135;
        if (t131) {
            const real_t t136 = tb_min(tb_max(t102, TB_C(3.0)), TB_C(10.0));
            const real_t t137 = t136 / (t72 * t72 + t71 * t71);
            const real_t t138 = t75 * t137;
            const real_t t139 = t58 * t72 + t51 * t71;
            const real_t t140 = t101 - t100;
            const bool t141 = TB_ABS(t140) <= t69;
            const real_t t142 = t99 * t137;
            real_t t143, t144;
            if (t141) {
                t143 = -TB_C(1000000000000.0);
                t144 = TB_C(1000000000000.0);
            } else {
                const real_t t145 = TB_C(1.0) / t140;
                const real_t t146 = (t43 - t142) * t145;
                const real_t t147 = t145 * (t63 - t142);
                const real_t t148 = tb_min(t146, t147);
                const real_t t149 = tb_max(t146, t147);
                t143 = t148;
                t144 = t149;
            }
            const bool t150 = TB_ABS(t74) <= t69;
            const real_t t151 = t73 * t137;
            real_t t152, t153;
            if (t150) {
                t152 = -TB_C(1000000000000.0);
                t153 = TB_C(1000000000000.0);
            } else {
                const real_t t154 = TB_C(1.0) / t74;
                const real_t t155 = (t43 - t151) * t154;
                const real_t t156 = t154 * (t63 - t151);
                const real_t t157 = tb_min(t155, t156);
                const real_t t158 = tb_max(t155, t156);
                t152 = t157;
                t153 = t158;
            }
            const bool t159 = TB_ABS(t139) <= t69;
            real_t t160, t161;
            if (t159) {
                t160 = -TB_C(1000000000000.0);
                t161 = TB_C(1000000000000.0);
            } else {
                const real_t t162 = TB_C(1.0) / t139;
                const real_t t163 = (t43 - t138) * t162;
                const real_t t164 = t162 * (t63 - t138);
                const real_t t165 = tb_min(t163, t164);
                const real_t t166 = tb_max(t163, t164);
                t160 = t165;
                t161 = t166;
            }
            const real_t t167 = tb_max(TB_C(0.0), tb_max(t143, tb_max(t152, t160)));
            const real_t t168 = tb_min(t167, tb_min(t144, tb_min(t153, t161)));
            const real_t t169 = t138 + t139 * t168;
            const real_t t170 = t151 + t74 * t168;
            const real_t t171 = t142 + t140 * t168;
            t132 = t169;
            t133 = t170;
            t134 = t171;
            t135 = t136;
        } else {
            t132 = t103;
            t133 = t104;
            t134 = t105;
            t135 = t102;
        }
        /* T0 */
        const real_t rest_0 = tb_min(tb_max(t132, TB_C(3.0)), TB_C(10.0));
        const real_t rest_1 = tb_min(tb_max(t133, TB_C(3.0)), TB_C(10.0));
        const real_t rest_2 = tb_min(tb_max(t134, TB_C(3.0)), TB_C(10.0));
        const real_t rest_3 = tb_min(tb_max(t135, TB_C(3.0)), TB_C(10.0));
        const real_t t172 = tb_min(tb_min(tb_min(rest_0, rest_1), rest_2), rest_3);
        const real_t t173 = tb_max(tb_max(tb_max(rest_0, rest_1), rest_2), rest_3);
        const real_t t174 = t172 / t173;
        factor_0 = t174;
    } else {
        factor_0 = TB_C(0.0);
    }
    const bool t175 = length_0 < TB_C(0.0001) || length_1 < TB_C(0.0001);
    const bool t176 = t175 || length_2 < TB_C(0.0001) || length_3 < TB_C(0.0001);
    const bool t177 = !(TB_EPSILON * TB_C(4096.0) < t41);
    const bool t178 = !t30;
    if (t176) {
        factor[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    if (t177) {
        factor[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    factor[0] = factor_0;
    return t178 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_isotropic_force(const real_t pose[2], const real_t rails[4], real_t force[1])
{
    if (!(pose[0] >= -TB_C(0.7118) && pose[0] <= TB_C(1.4236)
          && pose[1] >= -TB_C(0.4618) && pose[1] <= TB_C(0.9236)
          && rails[0] >= -TB_C(0.7118) && rails[0] <= TB_C(1.4236)
          && rails[1] >= -TB_C(0.4618) && rails[1] <= TB_C(0.9236)
          && rails[2] >= -TB_C(0.7118) && rails[2] <= TB_C(1.4236)
          && rails[3] >= -TB_C(0.4618) && rails[3] <= TB_C(0.9236))) {
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
    const bool t31 = length_0 < TB_C(0.0001) || length_1 < TB_C(0.0001);
    const bool t32 = t31 || length_2 < TB_C(0.0001) || length_3 < TB_C(0.0001);
    const bool t33 = !(TB_C(0.0) <= t30);
    if (t32) {
        force[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    force[0] = force_0;
    return t33 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_isotropic_force_eq17(const real_t pose[2], const real_t rails[4], real_t force[1])
{
    if (!(pose[0] >= -TB_C(0.7118) && pose[0] <= TB_C(1.4236)
          && pose[1] >= -TB_C(0.4618) && pose[1] <= TB_C(0.9236)
          && rails[0] >= -TB_C(0.7118) && rails[0] <= TB_C(1.4236)
          && rails[1] >= -TB_C(0.4618) && rails[1] <= TB_C(0.9236)
          && rails[2] >= -TB_C(0.7118) && rails[2] <= TB_C(1.4236)
          && rails[3] >= -TB_C(0.4618) && rails[3] <= TB_C(0.9236))) {
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
    const real_t t43 = t2 + t42;
    const real_t t44 = TB_C(1.0) / (t41 * (t41 + TB_ABS(t2)));
    const real_t t45 = (t6 * t8 - t7 * t43 + t14 * t15 - t20 * t22) * t44;
    const real_t t46 = t6 - t8 * t45;
    const real_t t47 = t14 - t15 * t45;
    const real_t t48 = t20 + t22 * t45;
    const real_t t49 = TB_SQRT(t46 * t46 + t47 * t47 + t48 * t48);
    const real_t t50 = TB_COPYSIGN(t49, t46);
    const real_t t51 = tb_min(TB_ABS(t42), TB_ABS(t50));
    real_t force_0;
    if (t40) {
        const bool t52 = TB_C(0.0) < t9;
        const bool t53 = t2 * t8 - t6 * t7 < TB_C(0.0);
        const bool t54 = TB_C(0.0) < t16;
        const real_t t55 = t30 - t29;
        const bool t56 = TB_C(0.0) < t55;
        const bool t57 = TB_C(0.0) < t24;
        const real_t t58 = -t33;
        const bool t59 = TB_C(0.0) < t58;
        const bool t60 = (t52 || (TB_C(0.0) <= t9 && t53)) && !((t54 && t56) || (t57 && t59));
        const real_t t61 = TB_C(80.0) * TB_EPSILON / t51;
        const real_t t62 = TB_C(3.0) - t61;
        const real_t t63 = TB_C(1.0) / (t49 * (t49 + TB_ABS(t46)));
        const real_t t64 = t47 * t63;
        const real_t t65 = TB_C(1.0) - t47 * t64;
        const real_t t66 = t46 + t50;
        const real_t t67 = t64 * t66;
        const real_t t68 = t48 * t64;
        const real_t t69 = t44 * (t15 * t65 - t8 * t67 + t22 * t68);
        const real_t t70 = t43 * t69;
        const real_t t71 = t67 + t8 * t69;
        const real_t t72 = t48 * t63;
        const real_t t73 = t66 * t72;
        const real_t t74 = t47 * t72;
        const real_t t75 = TB_C(1.0) - t48 * t72;
        const real_t t76 = t44 * (t8 * t73 + t15 * t74 + t22 * t75);
        const real_t t77 = t43 * t76;
        const real_t t78 = t8 * t76 - t73;
        const real_t t79 = t70 * t71 + t77 * t78;
        const real_t t80 = TB_C(3.0) / (t70 * t70 + t77 * t77);
        const real_t t81 = t79 * t80;
        const real_t t82 = TB_C(10.0) + t61;
        const bool t83 = TB_C(0.0) < tb_max(t62 - t81, t81 - t82);
        const real_t t84 = t15 * t76 - t74;
        const real_t t85 = t65 - t15 * t69;
        const real_t t86 = t78 * t84 - t71 * t85;
        const real_t t87 = t71 * t84 + t78 * t85;
        const real_t t88 = TB_EPSILON * TB_C(16.0);
        const real_t t89 = t77 * t84 - t70 * t85;
        const real_t t90 = t75 - t22 * t76;
        const real_t t91 = t22 * t69 - t68;
        const real_t t92 = t78 * t90 - t71 * t91;
        const real_t t93 = t71 * t90 + t78 * t91;
        const real_t t94 = t77 * t90 - t70 * t91;
        real_t t95, t96, t97, t98;
        if (t83) {
            const real_t t99 = tb_min(tb_max(t81, TB_C(3.0)), TB_C(10.0));
            const real_t t100 = t99 / (t71 * t71 + t78 * t78);
            const real_t t101 = t70 * t78 - t71 * t77;
            const bool t102 = TB_ABS(t101) <= t88;
            const real_t t103 = t79 * t100;
            real_t t104, t105;
            if (t102) {
                t104 = -TB_C(1000000000000.0);
                t105 = TB_C(1000000000000.0);
            } else {
                const real_t t106 = TB_C(1.0) / t101;
                const real_t t107 = (t62 - t103) * t106;
                const real_t t108 = t106 * (t82 - t103);
                const real_t t109 = tb_min(t107, t108);
                const real_t t110 = tb_max(t107, t108);
                t104 = t109;
                t105 = t110;
            }
            const real_t t111 = tb_min(tb_max(TB_C(0.0), t104), t105);
            const real_t t112 = t86 * t100 - t87 * t111;
            const real_t t113 = t100 * t92 - t111 * t93;
            const real_t t114 = t103 + t101 * t111;
            t95 = t112;
            t96 = t113;
            t97 = t114;
            t98 = t99;
        } else {
            const real_t t115 = t80 * t89;
            const real_t t116 = t80 * t94;
            t95 = t115;
            t96 = t116;
            t97 = TB_C(3.0);
            t98 = t81;
        }
        const bool t117 = TB_C(0.0) < tb_max(t62 - t95, t95 - t82);
        const real_t t118 = t85 * t91 + t84 * t90;
        const real_t t119 = t85 * t90;
        const real_t t120 = t84 * t91;
        real_t t121, t122, t123, t124;
        if (t117) {
            const real_t t125 = tb_min(tb_max(t95, TB_C(3.0)), TB_C(10.0));
            const real_t t126 = t125 / (t85 * t85 + t84 * t84);
            const bool t127 = TB_ABS(t87) <= t88;
            const real_t t128 = t86 * t126;
            real_t t129, t130;
            if (t127) {
                t129 = -TB_C(1000000000000.0);
                t130 = TB_C(1000000000000.0);
            } else {
                const real_t t131 = TB_C(1.0) / t87;
                const real_t t132 = (t62 - t128) * t131;
                const real_t t133 = t131 * (t82 - t128);
                const real_t t134 = tb_min(t132, t133);
                const real_t t135 = tb_max(t132, t133);
                t129 = t134;
                t130 = t135;
            }
            const real_t t136 = t77 * t85 + t70 * t84;
            const bool t137 = TB_ABS(t136) <= t88;
            const real_t t138 = t89 * t126;
            real_t t139, t140;
            if (t137) {
                t139 = -TB_C(1000000000000.0);
                t140 = TB_C(1000000000000.0);
            } else {
                const real_t t141 = TB_C(1.0) / t136;
                const real_t t142 = (t62 - t138) * t141;
                const real_t t143 = t141 * (t82 - t138);
                const real_t t144 = tb_min(t142, t143);
                const real_t t145 = tb_max(t142, t143);
                t139 = t144;
                t140 = t145;
            }
            const real_t t146 = tb_min(tb_max(TB_C(0.0), tb_max(t129, t139)), tb_min(t130,
                t140));
            const real_t t147 = t118 * t126 + (t119 - t120) * t146;
            const real_t t148 = t138 + t136 * t146;
            const real_t t149 = t128 + t87 * t146;
            t121 = t147;
            t122 = t148;
            t123 = t149;
            t124 = t125;
        } else {
            t121 = t96;
            t122 = t97;
            t123 = t98;
            t124 = t95;
        }
        const bool t150 = TB_C(0.0) < tb_max(t62 - t121, t121 - t82);
        real_t t151, t152, t153, t154;
        if (t150) {
            const real_t t155 = tb_min(tb_max(t121, TB_C(3.0)), TB_C(10.0));
            const real_t t156 = t155 / (t91 * t91 + t90 * t90);
            const real_t t157 = t94 * t156;
            const real_t t158 = t77 * t91 + t70 * t90;
            const real_t t159 = t120 - t119;
            const bool t160 = TB_ABS(t159) <= t88;
            const real_t t161 = t118 * t156;
            real_t t162, t163;
            if (t160) {
                t162 = -TB_C(1000000000000.0);
                t163 = TB_C(1000000000000.0);
            } else {
                const real_t t164 = TB_C(1.0) / t159;
                const real_t t165 = (t62 - t161) * t164;
                const real_t t166 = t164 * (t82 - t161);
                const real_t t167 = tb_min(t165, t166);
                const real_t t168 = tb_max(t165, t166);
                t162 = t167;
                t163 = t168;
            }
            const bool t169 = TB_ABS(t93) <= t88;
            const real_t t170 = t92 * t156;
            real_t t171, t172;
            if (t169) {
                t171 = -TB_C(1000000000000.0);
                t172 = TB_C(1000000000000.0);
            } else {
                const real_t t173 = TB_C(1.0) / t93;
                const real_t t174 = (t62 - t170) * t173;
                const real_t t175 = t173 * (t82 - t170);
                const real_t t176 = tb_min(t174, t175);
                const real_t t177 = tb_max(t174, t175);
                t171 = t176;
                t172 = t177;
            }
            const bool t178 = TB_ABS(t158) <= t88;
            real_t t179, t180;
            if (t178) {
                t179 = -TB_C(1000000000000.0);
                t180 = TB_C(1000000000000.0);
            } else {
                const real_t t181 = TB_C(1.0) / t158;
                const real_t t182 = (t62 - t157) * t181;
                const real_t t183 = t181 * (t82 - t157);
                const real_t t184 = tb_min(t182, t183);
                const real_t t185 = tb_max(t182, t183);
                t179 = t184;
                t180 = t185;
            }
            const real_t t186 = tb_max(TB_C(0.0), tb_max(t162, tb_max(t171, t179)));
            const real_t t187 = tb_min(t186, tb_min(t163, tb_min(t172, t180)));
            const real_t t188 = t157 + t158 * t187;
            const real_t t189 = t170 + t93 * t187;
            const real_t t190 = t161 + t159 * t187;
            t151 = t188;
            t152 = t189;
            t153 = t190;
            t154 = t155;
        } else {
            t151 = t122;
            t152 = t123;
            t153 = t124;
            t154 = t121;
        }
        /* t_i = T_max - T0_i */
        const real_t margin_0 = TB_C(10.0) - tb_min(tb_max(t151, TB_C(3.0)), TB_C(10.0));
        const real_t margin_1 = TB_C(10.0) - tb_min(tb_max(t152, TB_C(3.0)), TB_C(10.0));
        const real_t t191 = tb_min(margin_0, margin_1);
        const bool t192 = t2 * t15 - t7 * t14 < TB_C(0.0);
        const bool t193 = TB_C(0.0) < t31;
        const real_t t194 = -t36;
        const bool t195 = TB_C(0.0) < t194;
        const bool t196 = (t54 || (TB_C(0.0) <= t16 && t192)) && !((t52 && t193) || (t57 &&
            t195));
        const real_t margin_2 = TB_C(10.0) - tb_min(tb_max(t153, TB_C(3.0)), TB_C(10.0));
        const real_t t197 = tb_min(margin_0, margin_2);
        const real_t t198 = tb_min(t60 ? (t53 ? t9 * t191 : t191) : TB_C(1e+30), t196 ? (t192 ?
            t16 * t197 : t197) : TB_C(1e+30));
        const bool t199 = -(t2 * t22 + t7 * t20) < TB_C(0.0);
        const bool t200 = TB_C(0.0) < t33;
        const bool t201 = TB_C(0.0) < t36;
        const bool t202 = (t57 || (TB_C(0.0) <= t24 && t199)) && !((t52 && t200) || (t54 &&
            t201));
        const real_t margin_3 = TB_C(10.0) - tb_min(tb_max(t154, TB_C(3.0)), TB_C(10.0));
        const real_t t203 = tb_min(margin_0, margin_3);
        const real_t t204 = tb_min(t198, t202 ? (t199 ? t24 * t203 : t203) : TB_C(1e+30));
        const real_t t205 = -t9;
        const bool t206 = TB_C(0.0) < t205;
        const real_t t207 = -t16;
        const bool t208 = TB_C(0.0) < t207;
        const real_t t209 = t23 - t21;
        const bool t210 = TB_C(0.0) < t209;
        const bool t211 = (t206 || (t53 && TB_C(0.0) <= t205)) && !((t193 && t208) || (t200 &&
            t210));
        const real_t t212 = tb_min(margin_1, margin_0);
        const real_t t213 = tb_min(t204, t211 ? (t53 ? -(t9 * t212) : t212) : TB_C(1e+30));
        const bool t214 = t8 * t15 + t6 * t14 < TB_C(0.0);
        const bool t215 = (t193 || (TB_C(0.0) <= t31 && t214)) && !((t54 && t206) || (t195 &&
            t200));
        const real_t t216 = tb_min(margin_1, margin_2);
        const real_t t217 = tb_min(t213, t215 ? (t214 ? t31 * t216 : t216) : TB_C(1e+30));
        const bool t218 = t6 * t20 - t8 * t22 < TB_C(0.0);
        const bool t219 = (t200 || (TB_C(0.0) <= t33 && t218)) && !((t57 && t206) || (t193 &&
            t201));
        const real_t t220 = tb_min(margin_1, margin_3);
        const real_t t221 = tb_min(t217, t219 ? (t218 ? t33 * t220 : t220) : TB_C(1e+30));
        const bool t222 = (t208 || (t192 && TB_C(0.0) <= t207)) && !((t56 && t206) || (t201 &&
            t210));
        const real_t t223 = tb_min(margin_2, margin_0);
        const real_t t224 = t222 ? (t192 ? -(t16 * t223) : t223) : TB_C(1e+30);
        const bool t225 = (t56 || (t214 && TB_C(0.0) <= t55)) && !((t52 && t208) || (t59 &&
            t201));
        const real_t t226 = tb_min(margin_2, margin_1);
        const real_t t227 = t225 ? (t214 ? -(t31 * t226) : t226) : TB_C(1e+30);
        const bool t228 = t14 * t20 - t15 * t22 < TB_C(0.0);
        const bool t229 = (t201 || (TB_C(0.0) <= t36 && t228)) && !((t57 && t208) || (t56 &&
            t200));
        const real_t t230 = tb_min(margin_2, margin_3);
        const real_t t231 = tb_min(tb_min(tb_min(t221, t224), t227), t229 ? (t228 ? t36 * t230
            : t230) : TB_C(1e+30));
        const bool t232 = (t210 || (t199 && TB_C(0.0) <= t209)) && !((t59 && t206) || (t195 &&
            t208));
        const real_t t233 = tb_min(margin_3, margin_0);
        const real_t t234 = t232 ? (t199 ? -(t24 * t233) : t233) : TB_C(1e+30);
        const bool t235 = (t59 || (t218 && TB_C(0.0) <= t58)) && !((t52 && t210) || (t56 &&
            t195));
        const real_t t236 = tb_min(margin_3, margin_1);
        const real_t t237 = t235 ? (t218 ? -(t33 * t236) : t236) : TB_C(1e+30);
        const bool t238 = (t195 || (t228 && TB_C(0.0) <= t194)) && !((t54 && t210) || (t59 &&
            t193));
        const real_t t239 = tb_min(margin_3, margin_2);
        const real_t t240 = t238 ? (t228 ? -(t36 * t239) : t239) : TB_C(1e+30);
        const real_t t241 = tb_min(tb_min(tb_min(t231, t234), t237), t240);
        force_0 = t241;
    } else {
        force_0 = TB_C(0.0);
    }
    const bool t242 = length_0 < TB_C(0.0001) || length_1 < TB_C(0.0001);
    const bool t243 = t242 || length_2 < TB_C(0.0001) || length_3 < TB_C(0.0001);
    const bool t244 = !(TB_EPSILON * TB_C(4096.0) < t51);
    const bool t245 = !t40;
    if (t243) {
        force[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    if (t244) {
        force[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    force[0] = force_0;
    return t245 ? TB_INFEASIBLE : TB_OK;
}

