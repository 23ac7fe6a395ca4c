/* Regenerate: turnbuckle generate machines/yoon2023.toml --out generated/yoon2023
 * Machine 596562f46df7de34, generator 0.1.0, casadi 3.8.2. Do not edit. */
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
    const real_t t66 = tb_max(t45 - t64, t64 - t65);
    const bool t67 = TB_C(0.0) < t66;
    const real_t t68 = t14 * t59 - t57;
    const real_t t69 = t48 - t14 * t52;
    const real_t t70 = t61 * t68 - t54 * t69;
    const real_t t71 = t54 * t68 + t61 * t69;
    const real_t t72 = TB_EPSILON * TB_C(16.0);
    const real_t t73 = t60 * t68 - t53 * t69;
    const real_t t74 = t58 - t19 * t59;
    const real_t t75 = t19 * t52 - t51;
    const real_t t76 = t61 * t74 - t54 * t75;
    const real_t t77 = t54 * t74 + t61 * t75;
    const real_t t78 = t60 * t74 - t53 * t75;
    const real_t t79 = t44 * TB_C(2.0);
    const real_t t80 = t44 * TB_C(1024.0);
    real_t t81, t82, t83, t84, t85;
    if (t67) {
        const real_t t86 = tb_min(tb_max(t64, TB_C(3.0)), TB_C(10.0));
        const real_t t87 = t86 * (TB_C(1.0) / (t54 * t54 + t61 * t61));
        const real_t t88 = t53 * t61 - t54 * t60;
        const bool t89 = TB_ABS(t88) <= t72;
        const real_t t90 = t62 * t87;
        const real_t t91 = TB_C(1.0) / t88;
        real_t t92, t93, t94;
        if (t89) {
            t92 = -TB_C(1000000000000.0);
            t93 = TB_C(1000000000000.0);
            t94 = TB_C(0.0);
        } else {
            const real_t t95 = (t45 - t90) * t91;
            const real_t t96 = t91 * (t65 - t90);
            t92 = tb_min(t95, t96);
            t93 = tb_max(t95, t96);
            t94 = t79 * TB_ABS(t91);
        }
        const real_t t97 = tb_min(tb_max(TB_C(0.0), t92), t93);
        const real_t t98 = TB_C(0.0) < TB_ABS(t97) ? t97 * (t62 * t91) : TB_C(0.0);
        const real_t t99 = t64 < t86 ? t98 - t87 : t87 - t98;
        const real_t t100 = t92 + t94 < t93 - t94 && t80 < t66 ? t99 : TB_C(0.0);
        t81 = t70 * t87 - t71 * t97;
        t82 = t87 * t76 - t97 * t77;
        t83 = t90 + t88 * t97;
        t84 = t86;
        t85 = TB_C(0.0) < t99 ? t100 : TB_C(0.0);
    } else {
        t81 = t63 * t73;
        t82 = t63 * t78;
        t83 = TB_C(3.0);
        t84 = t64;
        t85 = TB_C(0.0);
    }
    const real_t t101 = tb_max(t45 - t81, t81 - t65);
    const bool t102 = TB_C(0.0) < t101;
    const real_t t103 = t69 * t75 + t68 * t74;
    const real_t t104 = t69 * t74;
    const real_t t105 = t68 * t75;
    real_t t106, t107, t108, t109, t110;
    if (t102) {
        const real_t t111 = tb_min(tb_max(t81, TB_C(3.0)), TB_C(10.0));
        const real_t t112 = t111 * (TB_C(1.0) / (t69 * t69 + t68 * t68));
        const bool t113 = TB_ABS(t71) <= t72;
        const real_t t114 = t70 * t112;
        const real_t t115 = TB_C(1.0) / t71;
        real_t t116, t117, t118;
        if (t113) {
            t116 = -TB_C(1000000000000.0);
            t117 = TB_C(1000000000000.0);
            t118 = TB_C(0.0);
        } else {
            const real_t t119 = (t45 - t114) * t115;
            const real_t t120 = t115 * (t65 - t114);
            t116 = tb_min(t119, t120);
            t117 = tb_max(t119, t120);
            t118 = t79 * TB_ABS(t115);
        }
        const real_t t121 = t60 * t69 + t53 * t68;
        const bool t122 = TB_ABS(t121) <= t72;
        const real_t t123 = t73 * t112;
        const real_t t124 = TB_C(1.0) / t121;
        real_t t125, t126, t127;
        if (t122) {
            t125 = -TB_C(1000000000000.0);
            t126 = TB_C(1000000000000.0);
            t127 = TB_C(0.0);
        } else {
            const real_t t128 = (t45 - t123) * t124;
            const real_t t129 = t124 * (t65 - t123);
            t125 = tb_min(t128, t129);
            t126 = tb_max(t128, t129);
            t127 = t79 * TB_ABS(t124);
        }
        const real_t t130 = tb_min(tb_max(TB_C(0.0), tb_max(t116, t125)), tb_min(t117, t126));
        real_t t131;
        if (TB_C(0.0) < TB_ABS(t130)) {
            const real_t t132 = t70 * t115;
            const real_t t133 = t73 * t124;
            const real_t t134 = TB_C(0.0) < t130 ? (t125 < t116 ? t132 : t133) : (t117 < t126 ?
                t132 : t133);
            t131 = t130 * t134;
        } else {
            t131 = TB_C(0.0);
        }
        const real_t t135 = t81 < t111 ? t131 - t112 : t112 - t131;
        real_t t136;
        if (TB_C(0.0) < t135) {
            const bool t137 = tb_max(t125 + t127, t116 + t118) < tb_min(t126 - t127, t117 -
                t118);
            t136 = t137 && t80 < t101 ? t135 : TB_C(0.0);
        } else {
            t136 = TB_C(0.0);
        }
        t106 = t103 * t112 + (t104 - t105) * t130;
        t107 = t123 + t121 * t130;
        t108 = t114 + t71 * t130;
        t109 = t111;
        t110 = t136;
    } else {
        t106 = t82;
        t107 = t83;
        t108 = t84;
        t109 = t81;
        t110 = t85;
    }
    const real_t t138 = tb_max(t45 - t106, t106 - t65);
    const bool t139 = TB_C(0.0) < t138;
    real_t t140, t141, t142, t143, t144;
    if (t139) {
        const real_t t145 = tb_min(tb_max(t106, TB_C(3.0)), TB_C(10.0));
        const real_t t146 = t145 * (TB_C(1.0) / (t75 * t75 + t74 * t74));
        const real_t t147 = t78 * t146;
        const real_t t148 = t60 * t75 + t53 * t74;
        const real_t t149 = t105 - t104;
        const bool t150 = TB_ABS(t149) <= t72;
        const real_t t151 = t103 * t146;
        const real_t t152 = TB_C(1.0) / t149;
        real_t t153, t154, t155;
        if (t150) {
            t153 = -TB_C(1000000000000.0);
            t154 = TB_C(1000000000000.0);
            t155 = TB_C(0.0);
        } else {
            const real_t t156 = (t45 - t151) * t152;
            const real_t t157 = t152 * (t65 - t151);
            t153 = tb_min(t156, t157);
            t154 = tb_max(t156, t157);
            t155 = t79 * TB_ABS(t152);
        }
        const bool t158 = TB_ABS(t77) <= t72;
        const real_t t159 = t76 * t146;
        const real_t t160 = TB_C(1.0) / t77;
        real_t t161, t162, t163;
        if (t158) {
            t161 = -TB_C(1000000000000.0);
            t162 = TB_C(1000000000000.0);
            t163 = TB_C(0.0);
        } else {
            const real_t t164 = (t45 - t159) * t160;
            const real_t t165 = t160 * (t65 - t159);
            t161 = tb_min(t164, t165);
            t162 = tb_max(t164, t165);
            t163 = t79 * TB_ABS(t160);
        }
        const bool t166 = TB_ABS(t148) <= t72;
        const real_t t167 = TB_C(1.0) / t148;
        real_t t168, t169, t170;
        if (t166) {
            t168 = -TB_C(1000000000000.0);
            t169 = TB_C(1000000000000.0);
            t170 = TB_C(0.0);
        } else {
            const real_t t171 = (t45 - t147) * t167;
            const real_t t172 = t167 * (t65 - t147);
            t168 = tb_min(t171, t172);
            t169 = tb_max(t171, t172);
            t170 = t79 * TB_ABS(t167);
        }
        const real_t t173 = tb_max(t161, t168);
        const real_t t174 = tb_min(t162, t169);
        const real_t t175 = tb_min(tb_max(TB_C(0.0), tb_max(t153, t173)), tb_min(t154, t174));
        real_t t176;
        if (TB_C(0.0) < TB_ABS(t175)) {
            const real_t t177 = t103 * t152;
            const real_t t178 = t76 * t160;
            const real_t t179 = t78 * t167;
            real_t t180;
            if (TB_C(0.0) < t175) {
                t180 = t173 < t153 ? t177 : (t168 < t161 ? t178 : t179);
            } else {
                t180 = t154 < t174 ? t177 : (t162 < t169 ? t178 : t179);
            }
            t176 = t175 * t180;
        } else {
            t176 = TB_C(0.0);
        }
        const real_t t181 = t106 < t145 ? t176 - t146 : t146 - t176;
        real_t t182;
        if (TB_C(0.0) < t181) {
            const real_t t183 = tb_max(tb_max(t168 + t170, t161 + t163), t153 + t155);
            const real_t t184 = tb_min(tb_min(t169 - t170, t162 - t163), t154 - t155);
            t182 = t183 < t184 && t80 < t138 ? t181 : TB_C(0.0);
        } else {
            t182 = TB_C(0.0);
        }
        t140 = t147 + t148 * t175;
        t141 = t159 + t77 * t175;
        t142 = t151 + t149 * t175;
        t143 = t145;
        t144 = t182;
    } else {
        t140 = t107;
        t141 = t108;
        t142 = t109;
        t143 = t106;
        t144 = t110;
    }
    const real_t t185 = tb_min(tb_max(t140, TB_C(3.0)), TB_C(10.0));
    const real_t tension_0 = t30 ? t185 : TB_C(3.0);
    const real_t t186 = tb_min(tb_max(t141, TB_C(3.0)), TB_C(10.0));
    const real_t tension_1 = t30 ? t186 : TB_C(3.0);
    const real_t t187 = tb_min(tb_max(t142, TB_C(3.0)), TB_C(10.0));
    const real_t tension_2 = t30 ? t187 : TB_C(3.0);
    const real_t t188 = tb_min(tb_max(t143, TB_C(3.0)), TB_C(10.0));
    const real_t tension_3 = t30 ? t188 : TB_C(3.0);
    const bool t189 = length_0 < TB_C(0.0001) || length_1 < TB_C(0.0001);
    const bool t190 = t189 || length_2 < TB_C(0.0001) || length_3 < TB_C(0.0001);
    const bool t191 = !(TB_EPSILON * TB_C(4096.0) < t42);
    const real_t t192 = TB_ABS(t2 * t185 + t8 * t186 + t14 * t187 - t19 * t188);
    const real_t t193 = TB_ABS(t6 * t186 - t7 * t185 + t13 * t187 + t18 * t188);
    const bool t194 = tb_max(tb_max(t144, t192), t193) <= t43 * (TB_EPSILON * TB_C(1280.0));
    const bool t195 = !(t31 || t194);
    if (t190) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        return TB_SINGULAR;
    }
    if (t191) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        return TB_SINGULAR;
    }
    if (t195) {
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
            const real_t t81 = t80 * (TB_C(1.0) / (t52 * t52 + t59 * t59));
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
                t85 = tb_min(t88, t89);
                t86 = tb_max(t88, t89);
            }
            const real_t t90 = tb_min(tb_max(TB_C(0.0), t85), t86);
            t76 = t67 * t81 - t68 * t90;
            t77 = t81 * t73 - t90 * t74;
            t78 = t84 + t82 * t90;
            t79 = t80;
        } else {
            t76 = t61 * t70;
            t77 = t61 * t75;
            t78 = TB_C(3.0);
            t79 = t62;
        }
        const bool t91 = TB_C(0.0) < tb_max(t43 - t76, t76 - t63);
        const real_t t92 = t66 * t72 + t65 * t71;
        const real_t t93 = t66 * t71;
        const real_t t94 = t65 * t72;
        real_t t95, t96, t97, t98;
        if (t91) {
            const real_t t99 = tb_min(tb_max(t76, TB_C(3.0)), TB_C(10.0));
            const real_t t100 = t99 * (TB_C(1.0) / (t66 * t66 + t65 * t65));
            const bool t101 = TB_ABS(t68) <= t69;
            const real_t t102 = t67 * t100;
            real_t t103, t104;
            if (t101) {
                t103 = -TB_C(1000000000000.0);
                t104 = TB_C(1000000000000.0);
            } else {
                const real_t t105 = TB_C(1.0) / t68;
                const real_t t106 = (t43 - t102) * t105;
                const real_t t107 = t105 * (t63 - t102);
                t103 = tb_min(t106, t107);
                t104 = tb_max(t106, t107);
            }
            const real_t t108 = t58 * t66 + t51 * t65;
            const bool t109 = TB_ABS(t108) <= t69;
            const real_t t110 = t70 * t100;
            real_t t111, t112;
            if (t109) {
                t111 = -TB_C(1000000000000.0);
                t112 = TB_C(1000000000000.0);
            } else {
                const real_t t113 = TB_C(1.0) / t108;
                const real_t t114 = (t43 - t110) * t113;
                const real_t t115 = t113 * (t63 - t110);
                t111 = tb_min(t114, t115);
                t112 = tb_max(t114, t115);
            }
            const real_t t116 = tb_min(tb_max(TB_C(0.0), tb_max(t103, t111)), tb_min(t104,
                t112));
            t95 = t92 * t100 + (t93 - t94) * t116;
            t96 = t110 + t108 * t116;
            t97 = t102 + t68 * t116;
            t98 = t99;
        } else {
            t95 = t77;
            t96 = t78;
            t97 = t79;
            t98 = t76;
        }
        const bool t117 = TB_C(0.0) < tb_max(t43 - t95, t95 - t63);
        real_t t118, t119, t120, t121;
        if (t117) {
            const real_t t122 = tb_min(tb_max(t95, TB_C(3.0)), TB_C(10.0));
            const real_t t123 = t122 * (TB_C(1.0) / (t72 * t72 + t71 * t71));
            const real_t t124 = t75 * t123;
            const real_t t125 = t58 * t72 + t51 * t71;
            const real_t t126 = t94 - t93;
            const bool t127 = TB_ABS(t126) <= t69;
            const real_t t128 = t92 * t123;
            real_t t129, t130;
            if (t127) {
                t129 = -TB_C(1000000000000.0);
                t130 = TB_C(1000000000000.0);
            } else {
                const real_t t131 = TB_C(1.0) / t126;
                const real_t t132 = (t43 - t128) * t131;
                const real_t t133 = t131 * (t63 - t128);
                t129 = tb_min(t132, t133);
                t130 = tb_max(t132, t133);
            }
            const bool t134 = TB_ABS(t74) <= t69;
            const real_t t135 = t73 * t123;
            real_t t136, t137;
            if (t134) {
                t136 = -TB_C(1000000000000.0);
                t137 = TB_C(1000000000000.0);
            } else {
                const real_t t138 = TB_C(1.0) / t74;
                const real_t t139 = (t43 - t135) * t138;
                const real_t t140 = t138 * (t63 - t135);
                t136 = tb_min(t139, t140);
                t137 = tb_max(t139, t140);
            }
            const bool t141 = TB_ABS(t125) <= t69;
            real_t t142, t143;
            if (t141) {
                t142 = -TB_C(1000000000000.0);
                t143 = TB_C(1000000000000.0);
            } else {
                const real_t t144 = TB_C(1.0) / t125;
                const real_t t145 = (t43 - t124) * t144;
                const real_t t146 = t144 * (t63 - t124);
                t142 = tb_min(t145, t146);
                t143 = tb_max(t145, t146);
            }
            const real_t t147 = tb_max(TB_C(0.0), tb_max(t129, tb_max(t136, t142)));
            const real_t t148 = tb_min(t147, tb_min(t130, tb_min(t137, t143)));
            t118 = t124 + t125 * t148;
            t119 = t135 + t74 * t148;
            t120 = t128 + t126 * t148;
            t121 = t122;
        } else {
            t118 = t96;
            t119 = t97;
            t120 = t98;
            t121 = t95;
        }
        /* T0 */
        const real_t rest_0 = tb_min(tb_max(t118, TB_C(3.0)), TB_C(10.0));
        const real_t rest_1 = tb_min(tb_max(t119, TB_C(3.0)), TB_C(10.0));
        const real_t rest_2 = tb_min(tb_max(t120, TB_C(3.0)), TB_C(10.0));
        const real_t rest_3 = tb_min(tb_max(t121, TB_C(3.0)), TB_C(10.0));
        const real_t t149 = tb_min(tb_min(tb_min(rest_0, rest_1), rest_2), rest_3);
        const real_t t150 = tb_max(tb_max(tb_max(rest_0, rest_1), rest_2), rest_3);
        factor_0 = t149 / t150;
    } else {
        factor_0 = TB_C(0.0);
    }
    const bool t151 = length_0 < TB_C(0.0001) || length_1 < TB_C(0.0001);
    const bool t152 = t151 || length_2 < TB_C(0.0001) || length_3 < TB_C(0.0001);
    const bool t153 = !(TB_EPSILON * TB_C(4096.0) < t41);
    const bool t154 = !t30;
    if (t152) {
        factor[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    if (t153) {
        factor[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    factor[0] = factor_0;
    return t154 ? TB_INFEASIBLE : TB_OK;
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
            const real_t t100 = t99 * (TB_C(1.0) / (t71 * t71 + t78 * t78));
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
                t104 = tb_min(t107, t108);
                t105 = tb_max(t107, t108);
            }
            const real_t t109 = tb_min(tb_max(TB_C(0.0), t104), t105);
            t95 = t86 * t100 - t87 * t109;
            t96 = t100 * t92 - t109 * t93;
            t97 = t103 + t101 * t109;
            t98 = t99;
        } else {
            t95 = t80 * t89;
            t96 = t80 * t94;
            t97 = TB_C(3.0);
            t98 = t81;
        }
        const bool t110 = TB_C(0.0) < tb_max(t62 - t95, t95 - t82);
        const real_t t111 = t85 * t91 + t84 * t90;
        const real_t t112 = t85 * t90;
        const real_t t113 = t84 * t91;
        real_t t114, t115, t116, t117;
        if (t110) {
            const real_t t118 = tb_min(tb_max(t95, TB_C(3.0)), TB_C(10.0));
            const real_t t119 = t118 * (TB_C(1.0) / (t85 * t85 + t84 * t84));
            const bool t120 = TB_ABS(t87) <= t88;
            const real_t t121 = t86 * t119;
            real_t t122, t123;
            if (t120) {
                t122 = -TB_C(1000000000000.0);
                t123 = TB_C(1000000000000.0);
            } else {
                const real_t t124 = TB_C(1.0) / t87;
                const real_t t125 = (t62 - t121) * t124;
                const real_t t126 = t124 * (t82 - t121);
                t122 = tb_min(t125, t126);
                t123 = tb_max(t125, t126);
            }
            const real_t t127 = t77 * t85 + t70 * t84;
            const bool t128 = TB_ABS(t127) <= t88;
            const real_t t129 = t89 * t119;
            real_t t130, t131;
            if (t128) {
                t130 = -TB_C(1000000000000.0);
                t131 = TB_C(1000000000000.0);
            } else {
                const real_t t132 = TB_C(1.0) / t127;
                const real_t t133 = (t62 - t129) * t132;
                const real_t t134 = t132 * (t82 - t129);
                t130 = tb_min(t133, t134);
                t131 = tb_max(t133, t134);
            }
            const real_t t135 = tb_min(tb_max(TB_C(0.0), tb_max(t122, t130)), tb_min(t123,
                t131));
            t114 = t111 * t119 + (t112 - t113) * t135;
            t115 = t129 + t127 * t135;
            t116 = t121 + t87 * t135;
            t117 = t118;
        } else {
            t114 = t96;
            t115 = t97;
            t116 = t98;
            t117 = t95;
        }
        const bool t136 = TB_C(0.0) < tb_max(t62 - t114, t114 - t82);
        real_t t137, t138, t139, t140;
        if (t136) {
            const real_t t141 = tb_min(tb_max(t114, TB_C(3.0)), TB_C(10.0));
            const real_t t142 = t141 * (TB_C(1.0) / (t91 * t91 + t90 * t90));
            const real_t t143 = t94 * t142;
            const real_t t144 = t77 * t91 + t70 * t90;
            const real_t t145 = t113 - t112;
            const bool t146 = TB_ABS(t145) <= t88;
            const real_t t147 = t111 * t142;
            real_t t148, t149;
            if (t146) {
                t148 = -TB_C(1000000000000.0);
                t149 = TB_C(1000000000000.0);
            } else {
                const real_t t150 = TB_C(1.0) / t145;
                const real_t t151 = (t62 - t147) * t150;
                const real_t t152 = t150 * (t82 - t147);
                t148 = tb_min(t151, t152);
                t149 = tb_max(t151, t152);
            }
            const bool t153 = TB_ABS(t93) <= t88;
            const real_t t154 = t92 * t142;
            real_t t155, t156;
            if (t153) {
                t155 = -TB_C(1000000000000.0);
                t156 = TB_C(1000000000000.0);
            } else {
                const real_t t157 = TB_C(1.0) / t93;
                const real_t t158 = (t62 - t154) * t157;
                const real_t t159 = t157 * (t82 - t154);
                t155 = tb_min(t158, t159);
                t156 = tb_max(t158, t159);
            }
            const bool t160 = TB_ABS(t144) <= t88;
            real_t t161, t162;
            if (t160) {
                t161 = -TB_C(1000000000000.0);
                t162 = TB_C(1000000000000.0);
            } else {
                const real_t t163 = TB_C(1.0) / t144;
                const real_t t164 = (t62 - t143) * t163;
                const real_t t165 = t163 * (t82 - t143);
                t161 = tb_min(t164, t165);
                t162 = tb_max(t164, t165);
            }
            const real_t t166 = tb_max(TB_C(0.0), tb_max(t148, tb_max(t155, t161)));
            const real_t t167 = tb_min(t166, tb_min(t149, tb_min(t156, t162)));
            t137 = t143 + t144 * t167;
            t138 = t154 + t93 * t167;
            t139 = t147 + t145 * t167;
            t140 = t141;
        } else {
            t137 = t115;
            t138 = t116;
            t139 = t117;
            t140 = t114;
        }
        /* t_i = T_max - T0_i */
        const real_t margin_0 = TB_C(10.0) - tb_min(tb_max(t137, TB_C(3.0)), TB_C(10.0));
        const real_t margin_1 = TB_C(10.0) - tb_min(tb_max(t138, TB_C(3.0)), TB_C(10.0));
        const real_t t168 = tb_min(margin_0, margin_1);
        const bool t169 = t2 * t15 - t7 * t14 < TB_C(0.0);
        const bool t170 = TB_C(0.0) < t31;
        const real_t t171 = -t36;
        const bool t172 = TB_C(0.0) < t171;
        const bool t173 = (t54 || (TB_C(0.0) <= t16 && t169)) && !((t52 && t170) || (t57 &&
            t172));
        const real_t margin_2 = TB_C(10.0) - tb_min(tb_max(t139, TB_C(3.0)), TB_C(10.0));
        const real_t t174 = tb_min(margin_0, margin_2);
        const real_t t175 = tb_min(t60 ? (t53 ? t9 * t168 : t168) : TB_C(1e+30), t173 ? (t169 ?
            t16 * t174 : t174) : TB_C(1e+30));
        const bool t176 = -(t2 * t22 + t7 * t20) < TB_C(0.0);
        const bool t177 = TB_C(0.0) < t33;
        const bool t178 = TB_C(0.0) < t36;
        const bool t179 = (t57 || (TB_C(0.0) <= t24 && t176)) && !((t52 && t177) || (t54 &&
            t178));
        const real_t margin_3 = TB_C(10.0) - tb_min(tb_max(t140, TB_C(3.0)), TB_C(10.0));
        const real_t t180 = tb_min(margin_0, margin_3);
        const real_t t181 = tb_min(t175, t179 ? (t176 ? t24 * t180 : t180) : TB_C(1e+30));
        const real_t t182 = -t9;
        const bool t183 = TB_C(0.0) < t182;
        const real_t t184 = -t16;
        const bool t185 = TB_C(0.0) < t184;
        const real_t t186 = t23 - t21;
        const bool t187 = TB_C(0.0) < t186;
        const bool t188 = (t183 || (t53 && TB_C(0.0) <= t182)) && !((t170 && t185) || (t177 &&
            t187));
        const real_t t189 = tb_min(margin_1, margin_0);
        const real_t t190 = tb_min(t181, t188 ? (t53 ? -(t9 * t189) : t189) : TB_C(1e+30));
        const bool t191 = t8 * t15 + t6 * t14 < TB_C(0.0);
        const bool t192 = (t170 || (TB_C(0.0) <= t31 && t191)) && !((t54 && t183) || (t172 &&
            t177));
        const real_t t193 = tb_min(margin_1, margin_2);
        const real_t t194 = tb_min(t190, t192 ? (t191 ? t31 * t193 : t193) : TB_C(1e+30));
        const bool t195 = t6 * t20 - t8 * t22 < TB_C(0.0);
        const bool t196 = (t177 || (TB_C(0.0) <= t33 && t195)) && !((t57 && t183) || (t170 &&
            t178));
        const real_t t197 = tb_min(margin_1, margin_3);
        const real_t t198 = tb_min(t194, t196 ? (t195 ? t33 * t197 : t197) : TB_C(1e+30));
        const bool t199 = (t185 || (t169 && TB_C(0.0) <= t184)) && !((t56 && t183) || (t178 &&
            t187));
        const real_t t200 = tb_min(margin_2, margin_0);
        const real_t t201 = t199 ? (t169 ? -(t16 * t200) : t200) : TB_C(1e+30);
        const bool t202 = (t56 || (t191 && TB_C(0.0) <= t55)) && !((t52 && t185) || (t59 &&
            t178));
        const real_t t203 = tb_min(margin_2, margin_1);
        const real_t t204 = t202 ? (t191 ? -(t31 * t203) : t203) : TB_C(1e+30);
        const bool t205 = t14 * t20 - t15 * t22 < TB_C(0.0);
        const bool t206 = (t178 || (TB_C(0.0) <= t36 && t205)) && !((t57 && t185) || (t56 &&
            t177));
        const real_t t207 = tb_min(margin_2, margin_3);
        const real_t t208 = tb_min(tb_min(tb_min(t198, t201), t204), t206 ? (t205 ? t36 * t207
            : t207) : TB_C(1e+30));
        const bool t209 = (t187 || (t176 && TB_C(0.0) <= t186)) && !((t59 && t183) || (t172 &&
            t185));
        const real_t t210 = tb_min(margin_3, margin_0);
        const real_t t211 = t209 ? (t176 ? -(t24 * t210) : t210) : TB_C(1e+30);
        const bool t212 = (t59 || (t195 && TB_C(0.0) <= t58)) && !((t52 && t187) || (t56 &&
            t172));
        const real_t t213 = tb_min(margin_3, margin_1);
        const real_t t214 = t212 ? (t195 ? -(t33 * t213) : t213) : TB_C(1e+30);
        const bool t215 = (t172 || (t205 && TB_C(0.0) <= t171)) && !((t54 && t187) || (t59 &&
            t170));
        const real_t t216 = tb_min(margin_3, margin_2);
        const real_t t217 = t215 ? (t205 ? -(t36 * t216) : t216) : TB_C(1e+30);
        force_0 = tb_min(tb_min(tb_min(t208, t211), t214), t217);
    } else {
        force_0 = TB_C(0.0);
    }
    const bool t218 = length_0 < TB_C(0.0001) || length_1 < TB_C(0.0001);
    const bool t219 = t218 || length_2 < TB_C(0.0001) || length_3 < TB_C(0.0001);
    const bool t220 = !(TB_EPSILON * TB_C(4096.0) < t51);
    const bool t221 = !t40;
    if (t219) {
        force[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    if (t220) {
        force[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    force[0] = force_0;
    return t221 ? TB_INFEASIBLE : TB_OK;
}

