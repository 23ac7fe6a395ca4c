/* Regenerate: turnbuckle generate machines/yoon2023.toml --out generated/yoon2023
 * Machine 41fbf623dcdce700, generator 0.1.0, casadi 3.8.2. Do not edit. */
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
    const real_t t9 = t2 * t6 + t7 * t8;
    const real_t t10 = TB_C(0.4618) - pose[1];
    const real_t t11 = rails[2] - pose[0];
    const real_t length_2 = TB_SQRT(t11 * t11 + t10 * t10);
    const real_t t12 = TB_C(1.0) / length_2;
    const real_t t13 = t10 * t12;
    const real_t t14 = t11 * t12;
    const real_t t15 = t2 * t13 + t7 * t14;
    const real_t t16 = rails[3] - pose[1];
    const real_t length_3 = TB_SQRT(pose[0] * pose[0] + t16 * t16);
    const real_t t17 = TB_C(1.0) / length_3;
    const real_t t18 = t16 * t17;
    const real_t t19 = pose[0] * t17;
    const real_t t20 = t2 * t18 - t7 * t19;
    const real_t t21 = TB_ABS(t9);
    const real_t t22 = TB_ABS(t15);
    const real_t t23 = TB_ABS(t20);
    const bool t24 = TB_ABS(TB_C(6.5) * (t9 + t15 + t20)) <= TB_C(3.5) * (t21 + t22 + t23);
    const real_t t25 = t8 * t13 - t6 * t14;
    const real_t t26 = t8 * t18 + t6 * t19;
    const real_t t27 = TB_ABS(t25);
    const real_t t28 = TB_ABS(t26);
    const bool t29 = TB_ABS(TB_C(6.5) * (t25 - t9 + t26)) <= TB_C(3.5) * (t21 + t27 + t28);
    const real_t t30 = t14 * t18 + t13 * t19;
    const real_t t31 = TB_ABS(t30);
    const bool t32 = TB_ABS(TB_C(6.5) * (t30 - (t15 + t25))) <= TB_C(3.5) * (t22 + t27 + t31);
    const bool t33 = TB_ABS(TB_C(6.5) * (t30 + (t20 + t26))) <= TB_C(3.5) * (t31 + (t23 + t28));
    const bool t34 = t24 && t29 && t32 && t33;
    const bool t35 = !t34;
    const real_t t36 = TB_SQRT(t2 * t2 + t8 * t8 + t14 * t14 + t19 * t19);
    const real_t t37 = TB_C(0.0) <= t2 ? -t36 : t36;
    const real_t t38 = t2 - t37;
    const real_t t39 = TB_C(1.0) / (t36 * (t36 + TB_ABS(t2)));
    const real_t t40 = (t6 * t8 - t7 * t38 + t13 * t14 - t18 * t19) * t39;
    const real_t t41 = t18 + t19 * t40;
    const real_t t42 = t6 - t8 * t40;
    const real_t t43 = t13 - t14 * t40;
    const real_t t44 = TB_SQRT(t42 * t42 + t43 * t43 + t41 * t41);
    const real_t t45 = TB_C(1.0) / (t44 * (t44 + TB_ABS(t42)));
    const real_t t46 = t41 * t45;
    const real_t t47 = TB_C(0.0) <= t42 ? -t44 : t44;
    const real_t t48 = t42 - t47;
    const real_t t49 = t46 * t48;
    const real_t t50 = t43 * t46;
    const real_t t51 = TB_C(1.0) - t41 * t46;
    const real_t t52 = t39 * (t8 * t49 + t14 * t50 + t19 * t51);
    const real_t t53 = t38 * t52;
    const real_t t54 = t43 * t45;
    const real_t t55 = TB_C(1.0) - t43 * t54;
    const real_t t56 = t48 * t54;
    const real_t t57 = t41 * t54;
    const real_t t58 = t39 * (t14 * t55 - t8 * t56 + t19 * t57);
    const real_t t59 = t19 * t58;
    const real_t t60 = t59 - t57;
    const real_t t61 = t14 * t58;
    const real_t t62 = t55 - t61;
    const real_t t63 = TB_C(160.0) * TB_EPSILON;
    const real_t t64 = TB_C(3.0) - t63;
    const bool t65 = TB_C(0.0) < t64;
    const real_t t66 = t63 + TB_C(10.0);
    const bool t67 = t65 || t66 < TB_C(0.0);
    const real_t t68 = t56 + t8 * t58;
    const real_t t69 = t38 * t58;
    const real_t t70 = (t65 ? TB_C(3.0) : TB_C(10.0)) / (t69 * t69 + t53 * t53);
    const real_t t71 = t69 * t70;
    const real_t t72 = t8 * t52;
    const real_t t73 = t72 - t49;
    const real_t t74 = t53 * t70;
    const real_t t75 = t67 ? t68 * t71 + t73 * t74 : TB_C(0.0);
    const bool t76 = t75 < t64;
    const bool t77 = t76 || t66 < t75;
    const real_t t78 = (t76 ? TB_C(3.0) : TB_C(10.0)) / (t68 * t68 + t73 * t73);
    const real_t t79 = t69 * t73 - t53 * t68;
    const bool t80 = TB_ABS(t79) <= TB_EPSILON;
    const real_t t81 = -t63;
    real_t t82, t83;
    if (t80) {
        t82 = -TB_C(1000000000000.0);
        t83 = TB_C(1000000000000.0);
    } else {
        const real_t t84 = t78 * (t68 * t69 + t53 * t73);
        const real_t t85 = TB_C(3.0) - t84;
        const real_t t86 = TB_C(10.0) - t84;
        const bool t87 = t85 <= t63 && t81 <= t86;
        const real_t t88 = TB_C(1.0) / t79;
        const real_t t89 = t85 * t88;
        const real_t t90 = t86 * t88;
        const real_t t91 = tb_min(t89, t90);
        const real_t t92 = t87 ? tb_min(t91, TB_C(0.0)) : t91;
        const real_t t93 = tb_max(t89, t90);
        const real_t t94 = t87 ? tb_max(t93, TB_C(0.0)) : t93;
        t82 = t92;
        t83 = t94;
    }
    const bool t95 = -TB_C(1000000000000.0) < t82;
    const real_t t96 = tb_max(TB_C(0.0), t95 ? t82 : -TB_C(1000000000000.0));
    const bool t97 = t83 < TB_C(1000000000000.0);
    const real_t t98 = tb_min(t96, t97 ? t83 : TB_C(1000000000000.0));
    const real_t t99 = t77 ? -(t68 * t78 + t73 * t98) : (t67 ? -t71 : TB_C(0.0));
    const real_t t100 = t14 * t52;
    const real_t t101 = t100 - t50;
    const real_t t102 = t77 ? t73 * t78 - t68 * t98 : (t67 ? t74 : TB_C(0.0));
    const real_t t103 = t62 * t99 + t101 * t102;
    const bool t104 = t103 < t64;
    const bool t105 = t104 || t66 < t103;
    const real_t t106 = (t104 ? TB_C(3.0) : TB_C(10.0)) / (t62 * t62 + t101 * t101);
    const real_t t107 = t69 * t101 + t53 * t62;
    const bool t108 = TB_ABS(t107) <= TB_EPSILON;
    real_t t109, t110;
    if (t108) {
        t109 = -TB_C(1000000000000.0);
        t110 = TB_C(1000000000000.0);
    } else {
        const real_t t111 = t106 * (t53 * t101 - t62 * t69);
        const real_t t112 = TB_C(3.0) - t111;
        const real_t t113 = TB_C(10.0) - t111;
        const bool t114 = t112 <= t63 && t81 <= t113;
        const real_t t115 = TB_C(1.0) / t107;
        const real_t t116 = t112 * t115;
        const real_t t117 = t113 * t115;
        const real_t t118 = tb_min(t116, t117);
        const real_t t119 = t114 ? tb_min(t118, TB_C(0.0)) : t118;
        const real_t t120 = tb_max(t116, t117);
        const real_t t121 = t114 ? tb_max(t120, TB_C(0.0)) : t120;
        t109 = t119;
        t110 = t121;
    }
    const bool t122 = -TB_C(1000000000000.0) < t109;
    const real_t t123 = t122 ? t109 : -TB_C(1000000000000.0);
    const real_t t124 = t68 * t101 + t62 * t73;
    const bool t125 = TB_ABS(t124) <= TB_EPSILON;
    real_t t126, t127;
    if (t125) {
        t126 = -TB_C(1000000000000.0);
        t127 = TB_C(1000000000000.0);
    } else {
        const real_t t128 = t106 * (t73 * t101 - t62 * t68);
        const real_t t129 = TB_C(3.0) - t128;
        const real_t t130 = TB_C(10.0) - t128;
        const bool t131 = t129 <= t63 && t81 <= t130;
        const real_t t132 = TB_C(1.0) / t124;
        const real_t t133 = t129 * t132;
        const real_t t134 = t130 * t132;
        const real_t t135 = tb_min(t133, t134);
        const real_t t136 = t131 ? tb_min(t135, TB_C(0.0)) : t135;
        const real_t t137 = tb_max(t133, t134);
        const real_t t138 = t131 ? tb_max(t137, TB_C(0.0)) : t137;
        t126 = t136;
        t127 = t138;
    }
    const bool t139 = t123 < t126;
    const bool t140 = t110 < TB_C(1000000000000.0);
    const real_t t141 = t140 ? t110 : TB_C(1000000000000.0);
    const bool t142 = t127 < t141;
    const real_t t143 = tb_min(tb_max(TB_C(0.0), t139 ? t126 : t123), t142 ? t127 : t141);
    const real_t t144 = t105 ? t62 * t106 - t101 * t143 : t99;
    const real_t t145 = t19 * t52;
    const real_t t146 = t51 - t145;
    const real_t t147 = t105 ? t101 * t106 + t62 * t143 : t102;
    const real_t t148 = t60 * t144 + t146 * t147;
    const bool t149 = t148 < t64;
    const bool t150 = t149 || t66 < t148;
    const real_t t151 = t61 - t55;
    const real_t t152 = -t68;
    const real_t t153 = -t69;
    const real_t t154 = t50 - t100;
    const real_t t155 = t49 - t72;
    const real_t t156 = -t53;
    real_t t157, t158, t159, t160, t161, t162;
    if (t150) {
        const real_t t163 = (t149 ? TB_C(3.0) : TB_C(10.0)) / (t60 * t60 + t146 * t146);
        const real_t t164 = t69 * t146 + t53 * t60;
        const bool t165 = TB_ABS(t164) <= TB_EPSILON;
        real_t t166, t167;
        if (t165) {
            t166 = -TB_C(1000000000000.0);
            t167 = TB_C(1000000000000.0);
        } else {
            const real_t t168 = t163 * (t53 * t146 - t60 * t69);
            const real_t t169 = TB_C(3.0) - t168;
            const real_t t170 = TB_C(10.0) - t168;
            const bool t171 = t169 <= t63 && t81 <= t170;
            const real_t t172 = TB_C(1.0) / t164;
            const real_t t173 = t169 * t172;
            const real_t t174 = t170 * t172;
            const real_t t175 = tb_min(t173, t174);
            const real_t t176 = t171 ? tb_min(t175, TB_C(0.0)) : t175;
            const real_t t177 = tb_max(t173, t174);
            const real_t t178 = t171 ? tb_max(t177, TB_C(0.0)) : t177;
            t166 = t176;
            t167 = t178;
        }
        const bool t179 = -TB_C(1000000000000.0) < t166;
        const real_t t180 = t179 ? t166 : -TB_C(1000000000000.0);
        const real_t t181 = t68 * t146 + t60 * t73;
        const bool t182 = TB_ABS(t181) <= TB_EPSILON;
        real_t t183, t184;
        if (t182) {
            t183 = -TB_C(1000000000000.0);
            t184 = TB_C(1000000000000.0);
        } else {
            const real_t t185 = t163 * (t73 * t146 - t60 * t68);
            const real_t t186 = TB_C(3.0) - t185;
            const real_t t187 = TB_C(10.0) - t185;
            const bool t188 = t186 <= t63 && t81 <= t187;
            const real_t t189 = TB_C(1.0) / t181;
            const real_t t190 = t186 * t189;
            const real_t t191 = t187 * t189;
            const real_t t192 = tb_min(t190, t191);
            const real_t t193 = t188 ? tb_min(t192, TB_C(0.0)) : t192;
            const real_t t194 = tb_max(t190, t191);
            const real_t t195 = t188 ? tb_max(t194, TB_C(0.0)) : t194;
            t183 = t193;
            t184 = t195;
        }
        const bool t196 = t180 < t183;
        const real_t t197 = t196 ? t183 : t180;
        const real_t t198 = t60 * t101 - t62 * t146;
        const bool t199 = TB_ABS(t198) <= TB_EPSILON;
        real_t t200, t201;
        if (t199) {
            t200 = -TB_C(1000000000000.0);
            t201 = TB_C(1000000000000.0);
        } else {
            const real_t t202 = t163 * (t60 * t62 + t101 * t146);
            const real_t t203 = TB_C(3.0) - t202;
            const real_t t204 = TB_C(10.0) - t202;
            const bool t205 = t203 <= t63 && t81 <= t204;
            const real_t t206 = TB_C(1.0) / t198;
            const real_t t207 = t203 * t206;
            const real_t t208 = t204 * t206;
            const real_t t209 = tb_min(t207, t208);
            const real_t t210 = t205 ? tb_min(t209, TB_C(0.0)) : t209;
            const real_t t211 = tb_max(t207, t208);
            const real_t t212 = t205 ? tb_max(t211, TB_C(0.0)) : t211;
            t200 = t210;
            t201 = t212;
        }
        const bool t213 = t197 < t200;
        const bool t214 = t167 < TB_C(1000000000000.0);
        const real_t t215 = t214 ? t167 : TB_C(1000000000000.0);
        const bool t216 = t184 < t215;
        const real_t t217 = t216 ? t184 : t215;
        const bool t218 = t201 < t217;
        const real_t t219 = tb_min(tb_max(TB_C(0.0), t213 ? t200 : t197), t218 ? t201 : t217);
        const real_t t220 = t146 * t163 + t60 * t219;
        const real_t t221 = t60 * t163 - t146 * t219;
        const bool t222 = TB_C(0.0) < t219;
        const bool t223 = TB_C(0.0) < t198;
        const real_t t224 = t223 ? t62 : t151;
        const bool t225 = TB_C(0.0) < t181;
        const real_t t226 = t225 ? t152 : t68;
        const bool t227 = TB_C(0.0) < t164;
        const real_t t228 = t227 ? t153 : t69;
        const real_t t229 = t223 ? t101 : t154;
        const real_t t230 = t225 ? t73 : t155;
        const real_t t231 = t227 ? t53 : t156;
        real_t t232, t233;
        if (t222) {
            real_t t234, t235;
            if (t213) {
                t234 = t224;
                t235 = t229;
            } else {
                const real_t t236 = t196 ? t226 : (t179 ? t228 : TB_C(0.0));
                const real_t t237 = t196 ? t230 : (t179 ? t231 : TB_C(0.0));
                t234 = t236;
                t235 = t237;
            }
            t232 = t234;
            t233 = t235;
        } else {
            const bool t238 = t219 < TB_C(0.0);
            real_t t239, t240;
            if (t238) {
                real_t t241, t242;
                if (t218) {
                    const real_t t243 = -t224;
                    const real_t t244 = -t229;
                    t241 = t243;
                    t242 = t244;
                } else {
                    real_t t245, t246;
                    if (t216) {
                        const real_t t247 = -t226;
                        const real_t t248 = -t230;
                        t245 = t247;
                        t246 = t248;
                    } else {
                        const real_t t249 = t214 ? -t228 : TB_C(0.0);
                        const real_t t250 = t214 ? -t231 : TB_C(0.0);
                        t245 = t249;
                        t246 = t250;
                    }
                    t241 = t245;
                    t242 = t246;
                }
                t239 = t241;
                t240 = t242;
            } else {
                t239 = TB_C(0.0);
                t240 = TB_C(0.0);
            }
            t232 = t239;
            t233 = t240;
        }
        const real_t t251 = t149 ? t146 : t145 - t51;
        const real_t t252 = t149 ? t60 : t57 - t59;
        t157 = t220;
        t158 = t221;
        t159 = t232;
        t160 = t233;
        t161 = t251;
        t162 = t252;
    } else {
        real_t t253, t254, t255, t256;
        if (t105) {
            const bool t257 = TB_C(0.0) < t143;
            const bool t258 = TB_C(0.0) < t124;
            const real_t t259 = t258 ? t152 : t68;
            const bool t260 = TB_C(0.0) < t107;
            const real_t t261 = t260 ? t153 : t69;
            const real_t t262 = t258 ? t73 : t155;
            const real_t t263 = t260 ? t53 : t156;
            real_t t264, t265;
            if (t257) {
                const real_t t266 = t139 ? t259 : (t122 ? t261 : TB_C(0.0));
                const real_t t267 = t139 ? t262 : (t122 ? t263 : TB_C(0.0));
                t264 = t266;
                t265 = t267;
            } else {
                const bool t268 = t143 < TB_C(0.0);
                real_t t269, t270;
                if (t268) {
                    real_t t271, t272;
                    if (t142) {
                        const real_t t273 = -t259;
                        const real_t t274 = -t262;
                        t271 = t273;
                        t272 = t274;
                    } else {
                        const real_t t275 = t140 ? -t261 : TB_C(0.0);
                        const real_t t276 = t140 ? -t263 : TB_C(0.0);
                        t271 = t275;
                        t272 = t276;
                    }
                    t269 = t271;
                    t270 = t272;
                } else {
                    t269 = TB_C(0.0);
                    t270 = TB_C(0.0);
                }
                t264 = t269;
                t265 = t270;
            }
            const real_t t277 = t104 ? t101 : t154;
            const real_t t278 = t104 ? t62 : t151;
            t253 = t264;
            t254 = t265;
            t255 = t277;
            t256 = t278;
        } else {
            real_t t279, t280, t281, t282;
            if (t77) {
                const bool t283 = TB_C(0.0) < t98;
                const bool t284 = TB_C(0.0) < t79;
                const real_t t285 = t284 ? t153 : t69;
                const real_t t286 = t284 ? t53 : t156;
                real_t t287, t288;
                if (t283) {
                    const real_t t289 = t95 ? t285 : TB_C(0.0);
                    const real_t t290 = t95 ? t286 : TB_C(0.0);
                    t287 = t289;
                    t288 = t290;
                } else {
                    const bool t291 = t98 < TB_C(0.0);
                    const real_t t292 = t291 ? (t97 ? -t285 : TB_C(0.0)) : TB_C(0.0);
                    const real_t t293 = t291 ? (t97 ? -t286 : TB_C(0.0)) : TB_C(0.0);
                    t287 = t292;
                    t288 = t293;
                }
                const real_t t294 = t76 ? t73 : t155;
                const real_t t295 = t76 ? t152 : t68;
                t279 = t287;
                t280 = t288;
                t281 = t294;
                t282 = t295;
            } else {
                const real_t t296 = t67 ? (t65 ? t53 : t156) : TB_C(0.0);
                const real_t t297 = t67 ? (t65 ? t153 : t69) : TB_C(0.0);
                t279 = TB_C(0.0);
                t280 = TB_C(0.0);
                t281 = t296;
                t282 = t297;
            }
            t253 = t279;
            t254 = t280;
            t255 = t281;
            t256 = t282;
        }
        t157 = t147;
        t158 = t144;
        t159 = t253;
        t160 = t254;
        t161 = t255;
        t162 = t256;
    }
    const real_t t298 = tb_min(tb_max(t53 * t157 - t69 * t158, TB_C(3.0)), TB_C(10.0));
    const real_t tension_0 = t34 ? t298 : TB_C(3.0);
    const real_t t299 = tb_min(tb_max(t73 * t157 - t68 * t158, TB_C(3.0)), TB_C(10.0));
    const real_t tension_1 = t34 ? t299 : TB_C(3.0);
    const real_t t300 = tb_min(tb_max(t62 * t158 + t101 * t157, TB_C(3.0)), TB_C(10.0));
    const real_t tension_2 = t34 ? t300 : TB_C(3.0);
    const real_t t301 = tb_min(tb_max(t60 * t158 + t146 * t157, TB_C(3.0)), TB_C(10.0));
    const real_t tension_3 = t34 ? t301 : TB_C(3.0);
    const bool t302 = length_0 < TB_C(0.0001) || length_1 < TB_C(0.0001);
    const bool t303 = t302 || length_2 < TB_C(0.0001) || length_3 < TB_C(0.0001);
    const bool t304 = TB_EPSILON * TB_C(4096.0) < tb_min(TB_ABS(t37), TB_ABS(t47));
    const bool t305 = !t304;
    const real_t t306 = t159 * t159 + t160 * t160;
    const real_t t307 = t158 * t161;
    const real_t t308 = t157 * t162;
    const real_t t309 = t162 * t162 + t161 * t161;
    const bool t310 = TB_C(0.0) < t309;
    const real_t t311 = TB_C(1.0) / TB_SQRT(t309);
    real_t t312;
    if (t306 <= TB_C(0.0)) {
        const real_t t313 = tb_max(TB_ABS(t307 - t308), -(t158 * t162 + t157 * t161));
        const real_t t314 = TB_C(0.0) < t313 && t310 ? t313 * t311 : TB_C(0.0);
        t312 = t314;
    } else {
        const real_t t315 = t160 * t162 - t159 * t161 < TB_C(0.0) ? -TB_C(1.0) : TB_C(1.0);
        const real_t t316 = t315 * (t308 - t307);
        const real_t t317 = t310 && TB_C(0.0) < -t316 ? -(t311 * t316) : TB_C(0.0);
        const real_t t318 = t315 * (t158 * t160 - t157 * t159);
        real_t t319;
        if (TB_C(0.0) < -t318 && TB_C(0.0) < t306) {
            const real_t t320 = -(t318 / TB_SQRT(t306));
            t319 = t320;
        } else {
            t319 = TB_C(0.0);
        }
        const real_t t321 = tb_max(t317, t319);
        t312 = t321;
    }
    const real_t t322 = TB_ABS(t2 * t298 + t8 * t299 + t14 * t300 - t19 * t301);
    const real_t t323 = TB_ABS(t6 * t299 - t7 * t298 + t13 * t300 + t18 * t301);
    const bool t324 = tb_max(tb_max(t312, t322), t323) <= TB_EPSILON * TB_C(10240.0);
    const bool t325 = t34 && !t324;
    if (t303) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        return TB_SINGULAR;
    }
    if (t305) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        return TB_SINGULAR;
    }
    if (t325) {
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
    return t35 ? TB_INFEASIBLE : TB_OK;
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
    const real_t t9 = t2 * t6 + t7 * t8;
    const real_t t10 = TB_C(0.4618) - pose[1];
    const real_t t11 = rails[2] - pose[0];
    const real_t length_2 = TB_SQRT(t11 * t11 + t10 * t10);
    const real_t t12 = TB_C(1.0) / length_2;
    const real_t t13 = t10 * t12;
    const real_t t14 = t11 * t12;
    const real_t t15 = t2 * t13 + t7 * t14;
    const real_t t16 = rails[3] - pose[1];
    const real_t length_3 = TB_SQRT(pose[0] * pose[0] + t16 * t16);
    const real_t t17 = TB_C(1.0) / length_3;
    const real_t t18 = t16 * t17;
    const real_t t19 = pose[0] * t17;
    const real_t t20 = t2 * t18 - t7 * t19;
    const real_t t21 = TB_ABS(t9);
    const real_t t22 = TB_ABS(t15);
    const real_t t23 = TB_ABS(t20);
    const bool t24 = TB_ABS(TB_C(6.5) * (t9 + t15 + t20)) <= TB_C(3.5) * (t21 + t22 + t23);
    const real_t t25 = t8 * t13 - t6 * t14;
    const real_t t26 = t8 * t18 + t6 * t19;
    const real_t t27 = TB_ABS(t25);
    const real_t t28 = TB_ABS(t26);
    const bool t29 = TB_ABS(TB_C(6.5) * (t25 - t9 + t26)) <= TB_C(3.5) * (t21 + t27 + t28);
    const real_t t30 = t14 * t18 + t13 * t19;
    const real_t t31 = TB_ABS(t30);
    const bool t32 = TB_ABS(TB_C(6.5) * (t30 - (t15 + t25))) <= TB_C(3.5) * (t22 + t27 + t31);
    const bool t33 = TB_ABS(TB_C(6.5) * (t30 + (t20 + t26))) <= TB_C(3.5) * (t31 + (t23 + t28));
    const bool t34 = t24 && t29 && t32 && t33;
    const real_t t35 = TB_SQRT(t2 * t2 + t8 * t8 + t14 * t14 + t19 * t19);
    const real_t t36 = TB_C(0.0) <= t2 ? -t35 : t35;
    const real_t t37 = t2 - t36;
    const real_t t38 = TB_C(1.0) / (t35 * (t35 + TB_ABS(t2)));
    const real_t t39 = (t6 * t8 - t7 * t37 + t13 * t14 - t18 * t19) * t38;
    const real_t t40 = t18 + t19 * t39;
    const real_t t41 = t6 - t8 * t39;
    const real_t t42 = t13 - t14 * t39;
    const real_t t43 = TB_SQRT(t41 * t41 + t42 * t42 + t40 * t40);
    const real_t t44 = TB_C(0.0) <= t41 ? -t43 : t43;
    real_t factor_0;
    if (t34) {
        const real_t t45 = TB_C(1.0) / (t43 * (t43 + TB_ABS(t41)));
        const real_t t46 = t40 * t45;
        const real_t t47 = t41 - t44;
        const real_t t48 = t46 * t47;
        const real_t t49 = t42 * t46;
        const real_t t50 = TB_C(1.0) - t40 * t46;
        const real_t t51 = t38 * (t8 * t48 + t14 * t49 + t19 * t50);
        const real_t t52 = t37 * t51;
        const real_t t53 = t42 * t45;
        const real_t t54 = TB_C(1.0) - t42 * t53;
        const real_t t55 = t47 * t53;
        const real_t t56 = t40 * t53;
        const real_t t57 = t38 * (t14 * t54 - t8 * t55 + t19 * t56);
        const real_t t58 = t19 * t57 - t56;
        const real_t t59 = t54 - t14 * t57;
        const real_t t60 = TB_C(160.0) * TB_EPSILON;
        const real_t t61 = TB_C(3.0) - t60;
        const bool t62 = TB_C(0.0) < t61;
        const real_t t63 = t60 + TB_C(10.0);
        const bool t64 = t62 || t63 < TB_C(0.0);
        const real_t t65 = t55 + t8 * t57;
        const real_t t66 = t37 * t57;
        const real_t t67 = (t62 ? TB_C(3.0) : TB_C(10.0)) / (t66 * t66 + t52 * t52);
        const real_t t68 = t66 * t67;
        const real_t t69 = t8 * t51 - t48;
        const real_t t70 = t52 * t67;
        const real_t t71 = t64 ? t65 * t68 + t69 * t70 : TB_C(0.0);
        const bool t72 = t71 < t61;
        const bool t73 = t72 || t63 < t71;
        const real_t t74 = -t60;
        real_t t75, t76;
        if (t73) {
            const real_t t77 = (t72 ? TB_C(3.0) : TB_C(10.0)) / (t65 * t65 + t69 * t69);
            const real_t t78 = t66 * t69 - t52 * t65;
            const bool t79 = TB_ABS(t78) <= TB_EPSILON;
            real_t t80, t81;
            if (t79) {
                t80 = -TB_C(1000000000000.0);
                t81 = TB_C(1000000000000.0);
            } else {
                const real_t t82 = t77 * (t65 * t66 + t52 * t69);
                const real_t t83 = TB_C(3.0) - t82;
                const real_t t84 = TB_C(10.0) - t82;
                const bool t85 = t83 <= t60 && t74 <= t84;
                const real_t t86 = TB_C(1.0) / t78;
                const real_t t87 = t83 * t86;
                const real_t t88 = t84 * t86;
                const real_t t89 = tb_min(t87, t88);
                const real_t t90 = t85 ? tb_min(t89, TB_C(0.0)) : t89;
                const real_t t91 = tb_max(t87, t88);
                const real_t t92 = t85 ? tb_max(t91, TB_C(0.0)) : t91;
                t80 = t90;
                t81 = t92;
            }
            const real_t t93 = -TB_C(1000000000000.0) < t80 ? t80 : -TB_C(1000000000000.0);
            const real_t t94 = t81 < TB_C(1000000000000.0) ? t81 : TB_C(1000000000000.0);
            const real_t t95 = tb_min(tb_max(TB_C(0.0), t93), t94);
            const real_t t96 = -(t65 * t77 + t69 * t95);
            const real_t t97 = t69 * t77 - t65 * t95;
            t75 = t96;
            t76 = t97;
        } else {
            const real_t t98 = t64 ? -t68 : TB_C(0.0);
            const real_t t99 = t64 ? t70 : TB_C(0.0);
            t75 = t98;
            t76 = t99;
        }
        const real_t t100 = t14 * t51 - t49;
        const real_t t101 = t59 * t75 + t100 * t76;
        const bool t102 = t101 < t61;
        const bool t103 = t102 || t63 < t101;
        real_t t104, t105;
        if (t103) {
            const real_t t106 = (t102 ? TB_C(3.0) : TB_C(10.0)) / (t59 * t59 + t100 * t100);
            const real_t t107 = t66 * t100 + t52 * t59;
            const bool t108 = TB_ABS(t107) <= TB_EPSILON;
            real_t t109, t110;
            if (t108) {
                t109 = -TB_C(1000000000000.0);
                t110 = TB_C(1000000000000.0);
            } else {
                const real_t t111 = t106 * (t52 * t100 - t59 * t66);
                const real_t t112 = TB_C(3.0) - t111;
                const real_t t113 = TB_C(10.0) - t111;
                const bool t114 = t112 <= t60 && t74 <= t113;
                const real_t t115 = TB_C(1.0) / t107;
                const real_t t116 = t112 * t115;
                const real_t t117 = t113 * t115;
                const real_t t118 = tb_min(t116, t117);
                const real_t t119 = t114 ? tb_min(t118, TB_C(0.0)) : t118;
                const real_t t120 = tb_max(t116, t117);
                const real_t t121 = t114 ? tb_max(t120, TB_C(0.0)) : t120;
                t109 = t119;
                t110 = t121;
            }
            const real_t t122 = -TB_C(1000000000000.0) < t109 ? t109 : -TB_C(1000000000000.0);
            const real_t t123 = t65 * t100 + t59 * t69;
            const bool t124 = TB_ABS(t123) <= TB_EPSILON;
            real_t t125, t126;
            if (t124) {
                t125 = -TB_C(1000000000000.0);
                t126 = TB_C(1000000000000.0);
            } else {
                const real_t t127 = t106 * (t69 * t100 - t59 * t65);
                const real_t t128 = TB_C(3.0) - t127;
                const real_t t129 = TB_C(10.0) - t127;
                const bool t130 = t128 <= t60 && t74 <= t129;
                const real_t t131 = TB_C(1.0) / t123;
                const real_t t132 = t128 * t131;
                const real_t t133 = t129 * t131;
                const real_t t134 = tb_min(t132, t133);
                const real_t t135 = t130 ? tb_min(t134, TB_C(0.0)) : t134;
                const real_t t136 = tb_max(t132, t133);
                const real_t t137 = t130 ? tb_max(t136, TB_C(0.0)) : t136;
                t125 = t135;
                t126 = t137;
            }
            const real_t t138 = t110 < TB_C(1000000000000.0) ? t110 : TB_C(1000000000000.0);
            const real_t t139 = tb_min(tb_max(TB_C(0.0), t122 < t125 ? t125 : t122), t126 <
                t138 ? t126 : t138);
            const real_t t140 = t59 * t106 - t100 * t139;
            const real_t t141 = t100 * t106 + t59 * t139;
            t104 = t140;
            t105 = t141;
        } else {
            t104 = t75;
            t105 = t76;
        }
        const real_t t142 = t50 - t19 * t51;
        const real_t t143 = t58 * t104 + t142 * t105;
        const bool t144 = t143 < t61;
        const bool t145 = t144 || t63 < t143;
        real_t t146, t147;
        if (t145) {
            const real_t t148 = (t144 ? TB_C(3.0) : TB_C(10.0)) / (t58 * t58 + t142 * t142);
            const real_t t149 = t66 * t142 + t52 * t58;
            const bool t150 = TB_ABS(t149) <= TB_EPSILON;
            real_t t151, t152;
            if (t150) {
                t151 = -TB_C(1000000000000.0);
                t152 = TB_C(1000000000000.0);
            } else {
                const real_t t153 = t148 * (t52 * t142 - t58 * t66);
                const real_t t154 = TB_C(3.0) - t153;
                const real_t t155 = TB_C(10.0) - t153;
                const bool t156 = t154 <= t60 && t74 <= t155;
                const real_t t157 = TB_C(1.0) / t149;
                const real_t t158 = t154 * t157;
                const real_t t159 = t155 * t157;
                const real_t t160 = tb_min(t158, t159);
                const real_t t161 = t156 ? tb_min(t160, TB_C(0.0)) : t160;
                const real_t t162 = tb_max(t158, t159);
                const real_t t163 = t156 ? tb_max(t162, TB_C(0.0)) : t162;
                t151 = t161;
                t152 = t163;
            }
            const real_t t164 = -TB_C(1000000000000.0) < t151 ? t151 : -TB_C(1000000000000.0);
            const real_t t165 = t65 * t142 + t58 * t69;
            const bool t166 = TB_ABS(t165) <= TB_EPSILON;
            real_t t167, t168;
            if (t166) {
                t167 = -TB_C(1000000000000.0);
                t168 = TB_C(1000000000000.0);
            } else {
                const real_t t169 = t148 * (t69 * t142 - t58 * t65);
                const real_t t170 = TB_C(3.0) - t169;
                const real_t t171 = TB_C(10.0) - t169;
                const bool t172 = t170 <= t60 && t74 <= t171;
                const real_t t173 = TB_C(1.0) / t165;
                const real_t t174 = t170 * t173;
                const real_t t175 = t171 * t173;
                const real_t t176 = tb_min(t174, t175);
                const real_t t177 = t172 ? tb_min(t176, TB_C(0.0)) : t176;
                const real_t t178 = tb_max(t174, t175);
                const real_t t179 = t172 ? tb_max(t178, TB_C(0.0)) : t178;
                t167 = t177;
                t168 = t179;
            }
            const real_t t180 = t164 < t167 ? t167 : t164;
            const real_t t181 = t58 * t100 - t59 * t142;
            const bool t182 = TB_ABS(t181) <= TB_EPSILON;
            real_t t183, t184;
            if (t182) {
                t183 = -TB_C(1000000000000.0);
                t184 = TB_C(1000000000000.0);
            } else {
                const real_t t185 = t148 * (t58 * t59 + t100 * t142);
                const real_t t186 = TB_C(3.0) - t185;
                const real_t t187 = TB_C(10.0) - t185;
                const bool t188 = t186 <= t60 && t74 <= t187;
                const real_t t189 = TB_C(1.0) / t181;
                const real_t t190 = t186 * t189;
                const real_t t191 = t187 * t189;
                const real_t t192 = tb_min(t190, t191);
                const real_t t193 = t188 ? tb_min(t192, TB_C(0.0)) : t192;
                const real_t t194 = tb_max(t190, t191);
                const real_t t195 = t188 ? tb_max(t194, TB_C(0.0)) : t194;
                t183 = t193;
                t184 = t195;
            }
            const real_t t196 = t152 < TB_C(1000000000000.0) ? t152 : TB_C(1000000000000.0);
            const real_t t197 = t168 < t196 ? t168 : t196;
            const real_t t198 = tb_min(tb_max(TB_C(0.0), t180 < t183 ? t183 : t180), t184 <
                t197 ? t184 : t197);
            const real_t t199 = t142 * t148 + t58 * t198;
            const real_t t200 = t58 * t148 - t142 * t198;
            t146 = t199;
            t147 = t200;
        } else {
            t146 = t105;
            t147 = t104;
        }
        /* T0 */
        const real_t rest_0 = tb_min(tb_max(t52 * t146 - t66 * t147, TB_C(3.0)), TB_C(10.0));
        const real_t rest_1 = tb_min(tb_max(t69 * t146 - t65 * t147, TB_C(3.0)), TB_C(10.0));
        const real_t rest_2 = tb_min(tb_max(t59 * t147 + t100 * t146, TB_C(3.0)), TB_C(10.0));
        const real_t rest_3 = tb_min(tb_max(t58 * t147 + t142 * t146, TB_C(3.0)), TB_C(10.0));
        const real_t t201 = tb_min(tb_min(tb_min(rest_0, rest_1), rest_2), rest_3);
        const real_t t202 = tb_max(tb_max(tb_max(rest_0, rest_1), rest_2), rest_3);
        const real_t t203 = t201 / t202;
        factor_0 = t203;
    } else {
        factor_0 = TB_C(0.0);
    }
    const bool t204 = length_0 < TB_C(0.0001) || length_1 < TB_C(0.0001);
    const bool t205 = t204 || length_2 < TB_C(0.0001) || length_3 < TB_C(0.0001);
    const bool t206 = TB_EPSILON * TB_C(4096.0) < tb_min(TB_ABS(t36), TB_ABS(t44));
    const bool t207 = !t206;
    const bool t208 = !t34;
    if (t205) {
        factor[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    if (t207) {
        factor[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    factor[0] = factor_0;
    return t208 ? TB_INFEASIBLE : TB_OK;
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
    const real_t t21 = pose[0] * t19;
    const real_t t22 = t2 * t20 - t7 * t21;
    const real_t t23 = TB_ABS(t22);
    const real_t t24 = TB_C(3.5) * (t10 + t17 + t23);
    const real_t t25 = TB_ABS(TB_C(6.5) * (t22 + (t9 + t16)));
    const real_t t26 = t8 * t14 - t6 * t15;
    const real_t t27 = TB_ABS(t26);
    const real_t t28 = t8 * t20 + t6 * t21;
    const real_t t29 = TB_ABS(t28);
    const real_t t30 = TB_C(3.5) * (t10 + t27 + t29);
    const real_t t31 = TB_ABS(TB_C(6.5) * (t28 + (t26 - t9)));
    const real_t t32 = t15 * t20 + t14 * t21;
    const real_t t33 = TB_ABS(t32);
    const real_t t34 = TB_C(3.5) * (t17 + t27 + t33);
    const real_t t35 = TB_ABS(TB_C(6.5) * (t32 - (t16 + t26)));
    const real_t t36 = TB_C(3.5) * (t33 + (t23 + t29));
    const real_t t37 = TB_ABS(TB_C(6.5) * (t32 + (t22 + t28)));
    const real_t t38 = tb_min(tb_min(tb_min(t24 - t25, t30 - t31), t34 - t35), t36 - t37);
    const real_t force_0 = tb_max(TB_C(0.0), t38);
    const bool t39 = length_0 < TB_C(0.0001) || length_1 < TB_C(0.0001);
    const bool t40 = t39 || length_2 < TB_C(0.0001) || length_3 < TB_C(0.0001);
    const bool t41 = t25 <= t24 && t31 <= t30 && t35 <= t34 && t37 <= t36;
    const bool t42 = !t41;
    if (t40) {
        force[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    force[0] = force_0;
    return t42 ? TB_INFEASIBLE : TB_OK;
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
    const real_t t10 = TB_C(0.4618) - pose[1];
    const real_t t11 = rails[2] - pose[0];
    const real_t length_2 = TB_SQRT(t11 * t11 + t10 * t10);
    const real_t t12 = TB_C(1.0) / length_2;
    const real_t t13 = t10 * t12;
    const real_t t14 = t11 * t12;
    const real_t t15 = t2 * t13 + t7 * t14;
    const real_t t16 = rails[3] - pose[1];
    const real_t length_3 = TB_SQRT(pose[0] * pose[0] + t16 * t16);
    const real_t t17 = TB_C(1.0) / length_3;
    const real_t t18 = t16 * t17;
    const real_t t19 = t2 * t18;
    const real_t t20 = pose[0] * t17;
    const real_t t21 = t7 * t20;
    const real_t t22 = t19 - t21;
    const real_t t23 = TB_ABS(t9);
    const real_t t24 = TB_ABS(t15);
    const real_t t25 = TB_ABS(t22);
    const bool t26 = TB_ABS(TB_C(6.5) * (t9 + t15 + t22)) <= TB_C(3.5) * (t23 + t24 + t25);
    const real_t t27 = t8 * t13;
    const real_t t28 = t6 * t14;
    const real_t t29 = t27 - t28;
    const real_t t30 = t8 * t18 + t6 * t20;
    const real_t t31 = TB_ABS(t29);
    const real_t t32 = TB_ABS(t30);
    const bool t33 = TB_ABS(TB_C(6.5) * (t29 - t9 + t30)) <= TB_C(3.5) * (t23 + t31 + t32);
    const real_t t34 = t14 * t18 + t13 * t20;
    const real_t t35 = TB_ABS(t34);
    const bool t36 = TB_ABS(TB_C(6.5) * (t34 - (t15 + t29))) <= TB_C(3.5) * (t24 + t31 + t35);
    const bool t37 = TB_ABS(TB_C(6.5) * (t34 + (t22 + t30))) <= TB_C(3.5) * (t35 + (t25 + t32));
    const bool t38 = t26 && t33 && t36 && t37;
    const real_t t39 = TB_SQRT(t2 * t2 + t8 * t8 + t14 * t14 + t20 * t20);
    const real_t t40 = TB_C(0.0) <= t2 ? -t39 : t39;
    const real_t t41 = t2 - t40;
    const real_t t42 = TB_C(1.0) / (t39 * (t39 + TB_ABS(t2)));
    const real_t t43 = (t6 * t8 - t7 * t41 + t13 * t14 - t18 * t20) * t42;
    const real_t t44 = t18 + t20 * t43;
    const real_t t45 = t6 - t8 * t43;
    const real_t t46 = t13 - t14 * t43;
    const real_t t47 = TB_SQRT(t45 * t45 + t46 * t46 + t44 * t44);
    const real_t t48 = TB_C(0.0) <= t45 ? -t47 : t47;
    real_t force_0;
    if (t38) {
        const bool t49 = TB_C(0.0) < t9;
        const bool t50 = t2 * t8 - t6 * t7 < TB_C(0.0);
        const bool t51 = TB_C(0.0) < t15;
        const real_t t52 = t28 - t27;
        const bool t53 = TB_C(0.0) < t52;
        const bool t54 = TB_C(0.0) < t22;
        const real_t t55 = -t30;
        const bool t56 = TB_C(0.0) < t55;
        const bool t57 = (t49 || (TB_C(0.0) <= t9 && t50)) && !((t51 && t53) || (t54 && t56));
        const real_t t58 = TB_C(1.0) / (t47 * (t47 + TB_ABS(t45)));
        const real_t t59 = t44 * t58;
        const real_t t60 = t45 - t48;
        const real_t t61 = t59 * t60;
        const real_t t62 = t46 * t59;
        const real_t t63 = TB_C(1.0) - t44 * t59;
        const real_t t64 = t42 * (t8 * t61 + t14 * t62 + t20 * t63);
        const real_t t65 = t41 * t64;
        const real_t t66 = t46 * t58;
        const real_t t67 = TB_C(1.0) - t46 * t66;
        const real_t t68 = t60 * t66;
        const real_t t69 = t44 * t66;
        const real_t t70 = t42 * (t14 * t67 - t8 * t68 + t20 * t69);
        const real_t t71 = t20 * t70 - t69;
        const real_t t72 = t67 - t14 * t70;
        const real_t t73 = TB_C(160.0) * TB_EPSILON;
        const real_t t74 = TB_C(3.0) - t73;
        const bool t75 = TB_C(0.0) < t74;
        const real_t t76 = TB_C(10.0) + t73;
        const bool t77 = t75 || t76 < TB_C(0.0);
        const real_t t78 = t68 + t8 * t70;
        const real_t t79 = t41 * t70;
        const real_t t80 = (t75 ? TB_C(3.0) : TB_C(10.0)) / (t79 * t79 + t65 * t65);
        const real_t t81 = t79 * t80;
        const real_t t82 = t8 * t64 - t61;
        const real_t t83 = t65 * t80;
        const real_t t84 = t77 ? t78 * t81 + t82 * t83 : TB_C(0.0);
        const bool t85 = t84 < t74;
        const bool t86 = t85 || t76 < t84;
        const real_t t87 = -t73;
        real_t t88, t89;
        if (t86) {
            const real_t t90 = (t85 ? TB_C(3.0) : TB_C(10.0)) / (t78 * t78 + t82 * t82);
            const real_t t91 = t79 * t82 - t65 * t78;
            const bool t92 = TB_ABS(t91) <= TB_EPSILON;
            real_t t93, t94;
            if (t92) {
                t93 = -TB_C(1000000000000.0);
                t94 = TB_C(1000000000000.0);
            } else {
                const real_t t95 = t90 * (t78 * t79 + t65 * t82);
                const real_t t96 = TB_C(3.0) - t95;
                const real_t t97 = TB_C(10.0) - t95;
                const bool t98 = t96 <= t73 && t87 <= t97;
                const real_t t99 = TB_C(1.0) / t91;
                const real_t t100 = t96 * t99;
                const real_t t101 = t97 * t99;
                const real_t t102 = tb_min(t100, t101);
                const real_t t103 = t98 ? tb_min(t102, TB_C(0.0)) : t102;
                const real_t t104 = tb_max(t100, t101);
                const real_t t105 = t98 ? tb_max(t104, TB_C(0.0)) : t104;
                t93 = t103;
                t94 = t105;
            }
            const real_t t106 = -TB_C(1000000000000.0) < t93 ? t93 : -TB_C(1000000000000.0);
            const real_t t107 = t94 < TB_C(1000000000000.0) ? t94 : TB_C(1000000000000.0);
            const real_t t108 = tb_min(tb_max(TB_C(0.0), t106), t107);
            const real_t t109 = -(t78 * t90 + t82 * t108);
            const real_t t110 = t82 * t90 - t78 * t108;
            t88 = t109;
            t89 = t110;
        } else {
            const real_t t111 = t77 ? -t81 : TB_C(0.0);
            const real_t t112 = t77 ? t83 : TB_C(0.0);
            t88 = t111;
            t89 = t112;
        }
        const real_t t113 = t14 * t64 - t62;
        const real_t t114 = t72 * t88 + t113 * t89;
        const bool t115 = t114 < t74;
        const bool t116 = t115 || t76 < t114;
        real_t t117, t118;
        if (t116) {
            const real_t t119 = (t115 ? TB_C(3.0) : TB_C(10.0)) / (t72 * t72 + t113 * t113);
            const real_t t120 = t79 * t113 + t65 * t72;
            const bool t121 = TB_ABS(t120) <= TB_EPSILON;
            real_t t122, t123;
            if (t121) {
                t122 = -TB_C(1000000000000.0);
                t123 = TB_C(1000000000000.0);
            } else {
                const real_t t124 = t119 * (t65 * t113 - t72 * t79);
                const real_t t125 = TB_C(3.0) - t124;
                const real_t t126 = TB_C(10.0) - t124;
                const bool t127 = t125 <= t73 && t87 <= t126;
                const real_t t128 = TB_C(1.0) / t120;
                const real_t t129 = t125 * t128;
                const real_t t130 = t126 * t128;
                const real_t t131 = tb_min(t129, t130);
                const real_t t132 = t127 ? tb_min(t131, TB_C(0.0)) : t131;
                const real_t t133 = tb_max(t129, t130);
                const real_t t134 = t127 ? tb_max(t133, TB_C(0.0)) : t133;
                t122 = t132;
                t123 = t134;
            }
            const real_t t135 = -TB_C(1000000000000.0) < t122 ? t122 : -TB_C(1000000000000.0);
            const real_t t136 = t78 * t113 + t72 * t82;
            const bool t137 = TB_ABS(t136) <= TB_EPSILON;
            real_t t138, t139;
            if (t137) {
                t138 = -TB_C(1000000000000.0);
                t139 = TB_C(1000000000000.0);
            } else {
                const real_t t140 = t119 * (t82 * t113 - t72 * t78);
                const real_t t141 = TB_C(3.0) - t140;
                const real_t t142 = TB_C(10.0) - t140;
                const bool t143 = t141 <= t73 && t87 <= t142;
                const real_t t144 = TB_C(1.0) / t136;
                const real_t t145 = t141 * t144;
                const real_t t146 = t142 * t144;
                const real_t t147 = tb_min(t145, t146);
                const real_t t148 = t143 ? tb_min(t147, TB_C(0.0)) : t147;
                const real_t t149 = tb_max(t145, t146);
                const real_t t150 = t143 ? tb_max(t149, TB_C(0.0)) : t149;
                t138 = t148;
                t139 = t150;
            }
            const real_t t151 = t123 < TB_C(1000000000000.0) ? t123 : TB_C(1000000000000.0);
            const real_t t152 = tb_min(tb_max(TB_C(0.0), t135 < t138 ? t138 : t135), t139 <
                t151 ? t139 : t151);
            const real_t t153 = t72 * t119 - t113 * t152;
            const real_t t154 = t113 * t119 + t72 * t152;
            t117 = t153;
            t118 = t154;
        } else {
            t117 = t88;
            t118 = t89;
        }
        const real_t t155 = t63 - t20 * t64;
        const real_t t156 = t71 * t117 + t155 * t118;
        const bool t157 = t156 < t74;
        const bool t158 = t157 || t76 < t156;
        real_t t159, t160;
        if (t158) {
            const real_t t161 = (t157 ? TB_C(3.0) : TB_C(10.0)) / (t71 * t71 + t155 * t155);
            const real_t t162 = t79 * t155 + t65 * t71;
            const bool t163 = TB_ABS(t162) <= TB_EPSILON;
            real_t t164, t165;
            if (t163) {
                t164 = -TB_C(1000000000000.0);
                t165 = TB_C(1000000000000.0);
            } else {
                const real_t t166 = t161 * (t65 * t155 - t71 * t79);
                const real_t t167 = TB_C(3.0) - t166;
                const real_t t168 = TB_C(10.0) - t166;
                const bool t169 = t167 <= t73 && t87 <= t168;
                const real_t t170 = TB_C(1.0) / t162;
                const real_t t171 = t167 * t170;
                const real_t t172 = t168 * t170;
                const real_t t173 = tb_min(t171, t172);
                const real_t t174 = t169 ? tb_min(t173, TB_C(0.0)) : t173;
                const real_t t175 = tb_max(t171, t172);
                const real_t t176 = t169 ? tb_max(t175, TB_C(0.0)) : t175;
                t164 = t174;
                t165 = t176;
            }
            const real_t t177 = -TB_C(1000000000000.0) < t164 ? t164 : -TB_C(1000000000000.0);
            const real_t t178 = t78 * t155 + t71 * t82;
            const bool t179 = TB_ABS(t178) <= TB_EPSILON;
            real_t t180, t181;
            if (t179) {
                t180 = -TB_C(1000000000000.0);
                t181 = TB_C(1000000000000.0);
            } else {
                const real_t t182 = t161 * (t82 * t155 - t71 * t78);
                const real_t t183 = TB_C(3.0) - t182;
                const real_t t184 = TB_C(10.0) - t182;
                const bool t185 = t183 <= t73 && t87 <= t184;
                const real_t t186 = TB_C(1.0) / t178;
                const real_t t187 = t183 * t186;
                const real_t t188 = t184 * t186;
                const real_t t189 = tb_min(t187, t188);
                const real_t t190 = t185 ? tb_min(t189, TB_C(0.0)) : t189;
                const real_t t191 = tb_max(t187, t188);
                const real_t t192 = t185 ? tb_max(t191, TB_C(0.0)) : t191;
                t180 = t190;
                t181 = t192;
            }
            const real_t t193 = t177 < t180 ? t180 : t177;
            const real_t t194 = t71 * t113 - t72 * t155;
            const bool t195 = TB_ABS(t194) <= TB_EPSILON;
            real_t t196, t197;
            if (t195) {
                t196 = -TB_C(1000000000000.0);
                t197 = TB_C(1000000000000.0);
            } else {
                const real_t t198 = t161 * (t71 * t72 + t113 * t155);
                const real_t t199 = TB_C(3.0) - t198;
                const real_t t200 = TB_C(10.0) - t198;
                const bool t201 = t199 <= t73 && t87 <= t200;
                const real_t t202 = TB_C(1.0) / t194;
                const real_t t203 = t199 * t202;
                const real_t t204 = t200 * t202;
                const real_t t205 = tb_min(t203, t204);
                const real_t t206 = t201 ? tb_min(t205, TB_C(0.0)) : t205;
                const real_t t207 = tb_max(t203, t204);
                const real_t t208 = t201 ? tb_max(t207, TB_C(0.0)) : t207;
                t196 = t206;
                t197 = t208;
            }
            const real_t t209 = t165 < TB_C(1000000000000.0) ? t165 : TB_C(1000000000000.0);
            const real_t t210 = t181 < t209 ? t181 : t209;
            const real_t t211 = tb_min(tb_max(TB_C(0.0), t193 < t196 ? t196 : t193), t197 <
                t210 ? t197 : t210);
            const real_t t212 = t155 * t161 + t71 * t211;
            const real_t t213 = t71 * t161 - t155 * t211;
            t159 = t212;
            t160 = t213;
        } else {
            t159 = t118;
            t160 = t117;
        }
        const real_t t214 = tb_min(tb_max(t65 * t159 - t79 * t160, TB_C(3.0)), TB_C(10.0));
        /* t_i = T_max - T0_i */
        const real_t margin_0 = TB_C(10.0) - t214;
        const real_t t215 = tb_min(tb_max(t82 * t159 - t78 * t160, TB_C(3.0)), TB_C(10.0));
        const real_t margin_1 = TB_C(10.0) - t215;
        const real_t t216 = tb_min(margin_0, margin_1);
        const bool t217 = t2 * t14 - t7 * t13 < TB_C(0.0);
        const bool t218 = TB_C(0.0) < t29;
        const real_t t219 = -t34;
        const bool t220 = TB_C(0.0) < t219;
        const bool t221 = (t51 || (TB_C(0.0) <= t15 && t217)) && !((t49 && t218) || (t54 &&
            t220));
        const real_t t222 = tb_min(tb_max(t72 * t160 + t113 * t159, TB_C(3.0)), TB_C(10.0));
        const real_t margin_2 = TB_C(10.0) - t222;
        const real_t t223 = tb_min(margin_0, margin_2);
        const real_t t224 = tb_min(t57 ? (t50 ? t9 * t216 : t216) : TB_C(1e+30), t221 ? (t217 ?
            t15 * t223 : t223) : TB_C(1e+30));
        const bool t225 = -(t2 * t20 + t7 * t18) < TB_C(0.0);
        const bool t226 = TB_C(0.0) < t30;
        const bool t227 = TB_C(0.0) < t34;
        const bool t228 = (t54 || (TB_C(0.0) <= t22 && t225)) && !((t49 && t226) || (t51 &&
            t227));
        const real_t t229 = tb_min(tb_max(t71 * t160 + t155 * t159, TB_C(3.0)), TB_C(10.0));
        const real_t margin_3 = TB_C(10.0) - t229;
        const real_t t230 = tb_min(margin_0, margin_3);
        const real_t t231 = tb_min(t224, t228 ? (t225 ? t22 * t230 : t230) : TB_C(1e+30));
        const real_t t232 = -t9;
        const bool t233 = TB_C(0.0) < t232;
        const real_t t234 = -t15;
        const bool t235 = TB_C(0.0) < t234;
        const real_t t236 = t21 - t19;
        const bool t237 = TB_C(0.0) < t236;
        const bool t238 = (t233 || (t50 && TB_C(0.0) <= t232)) && !((t218 && t235) || (t226 &&
            t237));
        const real_t t239 = tb_min(margin_1, margin_0);
        const real_t t240 = tb_min(t231, t238 ? (t50 ? -(t9 * t239) : t239) : TB_C(1e+30));
        const bool t241 = t8 * t14 + t6 * t13 < TB_C(0.0);
        const bool t242 = (t218 || (TB_C(0.0) <= t29 && t241)) && !((t51 && t233) || (t220 &&
            t226));
        const real_t t243 = tb_min(margin_1, margin_2);
        const real_t t244 = tb_min(t240, t242 ? (t241 ? t29 * t243 : t243) : TB_C(1e+30));
        const bool t245 = t6 * t18 - t8 * t20 < TB_C(0.0);
        const bool t246 = (t226 || (TB_C(0.0) <= t30 && t245)) && !((t54 && t233) || (t218 &&
            t227));
        const real_t t247 = tb_min(margin_1, margin_3);
        const real_t t248 = tb_min(t244, t246 ? (t245 ? t30 * t247 : t247) : TB_C(1e+30));
        const bool t249 = (t235 || (t217 && TB_C(0.0) <= t234)) && !((t53 && t233) || (t227 &&
            t237));
        const real_t t250 = tb_min(margin_2, margin_0);
        const real_t t251 = t249 ? (t217 ? -(t15 * t250) : t250) : TB_C(1e+30);
        const bool t252 = (t53 || (t241 && TB_C(0.0) <= t52)) && !((t49 && t235) || (t56 &&
            t227));
        const real_t t253 = tb_min(margin_2, margin_1);
        const real_t t254 = t252 ? (t241 ? -(t29 * t253) : t253) : TB_C(1e+30);
        const bool t255 = t13 * t18 - t14 * t20 < TB_C(0.0);
        const bool t256 = (t227 || (TB_C(0.0) <= t34 && t255)) && !((t54 && t235) || (t53 &&
            t226));
        const real_t t257 = tb_min(margin_2, margin_3);
        const real_t t258 = tb_min(tb_min(tb_min(t248, t251), t254), t256 ? (t255 ? t34 * t257
            : t257) : TB_C(1e+30));
        const bool t259 = (t237 || (t225 && TB_C(0.0) <= t236)) && !((t56 && t233) || (t220 &&
            t235));
        const real_t t260 = tb_min(margin_3, margin_0);
        const real_t t261 = t259 ? (t225 ? -(t22 * t260) : t260) : TB_C(1e+30);
        const bool t262 = (t56 || (t245 && TB_C(0.0) <= t55)) && !((t49 && t237) || (t53 &&
            t220));
        const real_t t263 = tb_min(margin_3, margin_1);
        const real_t t264 = t262 ? (t245 ? -(t30 * t263) : t263) : TB_C(1e+30);
        const bool t265 = (t220 || (t255 && TB_C(0.0) <= t219)) && !((t51 && t237) || (t56 &&
            t218));
        const real_t t266 = tb_min(margin_3, margin_2);
        const real_t t267 = t265 ? (t255 ? -(t34 * t266) : t266) : TB_C(1e+30);
        const real_t t268 = tb_min(tb_min(tb_min(t258, t261), t264), t267);
        force_0 = t268;
    } else {
        force_0 = TB_C(0.0);
    }
    const bool t269 = length_0 < TB_C(0.0001) || length_1 < TB_C(0.0001);
    const bool t270 = t269 || length_2 < TB_C(0.0001) || length_3 < TB_C(0.0001);
    const bool t271 = TB_EPSILON * TB_C(4096.0) < tb_min(TB_ABS(t40), TB_ABS(t48));
    const bool t272 = !t271;
    const bool t273 = !t38;
    if (t270) {
        force[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    if (t272) {
        force[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    force[0] = force_0;
    return t273 ? TB_INFEASIBLE : TB_OK;
}

