/* Regenerate: turnbuckle generate machines/yoon2023.toml --out generated/yoon2023
 * Machine 41fbf623dcdce700, generator 0.1.0, casadi 3.8.2. Do not edit. */
#include "tb_tension.h"

tb_status tb_distribute_tension_scale(const real_t structure[8], const real_t wrench[2], real_t
    tension[4], real_t delivered[2], real_t kkt_residual[1])
{
    if (!(structure[0] >= -TB_C(4.0) && structure[0] <= TB_C(4.0)
          && structure[1] >= -TB_C(4.0) && structure[1] <= TB_C(4.0)
          && structure[2] >= -TB_C(4.0) && structure[2] <= TB_C(4.0)
          && structure[3] >= -TB_C(4.0) && structure[3] <= TB_C(4.0)
          && structure[4] >= -TB_C(4.0) && structure[4] <= TB_C(4.0)
          && structure[5] >= -TB_C(4.0) && structure[5] <= TB_C(4.0)
          && structure[6] >= -TB_C(4.0) && structure[6] <= TB_C(4.0)
          && structure[7] >= -TB_C(4.0) && structure[7] <= TB_C(4.0)
          && wrench[0] >= -TB_C(40000.0) && wrench[0] <= TB_C(40000.0)
          && wrench[1] >= -TB_C(40000.0) && wrench[1] <= TB_C(40000.0))) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = structure[0] * wrench[1] - structure[4] * wrench[0];
    const real_t t1 = structure[0] * structure[5];
    const real_t t2 = structure[4] * structure[1];
    const real_t t3 = t1 - t2;
    const real_t t4 = structure[0] * structure[6];
    const real_t t5 = structure[4] * structure[2];
    const real_t t6 = t4 - t5;
    const real_t t7 = structure[0] * structure[7];
    const real_t t8 = structure[4] * structure[3];
    const real_t t9 = t7 - t8;
    const real_t t10 = TB_C(6.5) * (t3 + t6 + t9);
    const real_t t11 = t0 - t10;
    const real_t t12 = TB_ABS(t11);
    const real_t t13 = TB_ABS(t3);
    const real_t t14 = TB_ABS(t6);
    const real_t t15 = TB_ABS(t9);
    /* facets of the feasible wrenches, half distances */
    const real_t facet_0 = TB_C(3.5) * (t13 + t14 + t15);
    const real_t t16 = wrench[1] * structure[1] - wrench[0] * structure[5];
    const real_t t17 = structure[1] * structure[6];
    const real_t t18 = structure[5] * structure[2];
    const real_t t19 = t17 - t18;
    const real_t t20 = structure[1] * structure[7];
    const real_t t21 = structure[5] * structure[3];
    const real_t t22 = t20 - t21;
    const real_t t23 = TB_C(6.5) * (t19 - t3 + t22);
    const real_t t24 = t16 - t23;
    const real_t t25 = TB_ABS(t24);
    const real_t t26 = TB_ABS(t19);
    const real_t t27 = TB_ABS(t22);
    const real_t facet_1 = TB_C(3.5) * (t13 + t26 + t27);
    const real_t t28 = wrench[1] * structure[2] - wrench[0] * structure[6];
    const real_t t29 = structure[2] * structure[7];
    const real_t t30 = structure[6] * structure[3];
    const real_t t31 = t29 - t30;
    const real_t t32 = TB_C(6.5) * (t31 - (t6 + t19));
    const real_t t33 = t28 - t32;
    const real_t t34 = TB_ABS(t33);
    const real_t t35 = TB_ABS(t31);
    const real_t facet_2 = TB_C(3.5) * (t14 + t26 + t35);
    const bool t36 = t12 <= facet_0 && t25 <= facet_1 && t34 <= facet_2;
    const real_t t37 = wrench[1] * structure[3] - wrench[0] * structure[7];
    const real_t t38 = TB_C(6.5) * (t31 + (t9 + t22));
    const real_t t39 = t37 + t38;
    const real_t t40 = TB_ABS(t39);
    const real_t facet_3 = TB_C(3.5) * (t35 + (t15 + t27));
    const bool t41 = t36 && t40 <= facet_3;
    const bool t42 = !t41;
    const real_t t43 = structure[3] * structure[3];
    const real_t t44 = structure[2] * structure[2];
    const real_t t45 = structure[1] * structure[1];
    const real_t t46 = structure[0] * structure[0];
    /* the wrench that is served */
    real_t served_0, served_1;
    if (t41) {
        served_0 = wrench[0];
        served_1 = wrench[1];
    } else {
        const bool t47 = TB_C(0.0) < TB_ABS(t0);
        real_t t48, t49;
        if (t47) {
            const real_t t50 = TB_C(1.0) / t0;
            const real_t t51 = (t10 - facet_0) * t50;
            const real_t t52 = t50 * (t10 + facet_0);
            const real_t t53 = tb_max(t51, t52);
            const real_t t54 = tb_min(t51, t52);
            t48 = t53;
            t49 = t54;
        } else {
            t48 = TB_C(1e+30);
            t49 = -TB_C(1e+30);
        }
        const bool t55 = TB_C(0.0) < TB_ABS(t16);
        real_t t56, t57;
        if (t55) {
            const real_t t58 = TB_C(1.0) / t16;
            const real_t t59 = (t23 - facet_1) * t58;
            const real_t t60 = t58 * (t23 + facet_1);
            const real_t t61 = tb_max(t59, t60);
            const real_t t62 = tb_min(t59, t60);
            t56 = t61;
            t57 = t62;
        } else {
            t56 = TB_C(1e+30);
            t57 = -TB_C(1e+30);
        }
        const bool t63 = TB_C(0.0) < TB_ABS(t28);
        real_t t64, t65;
        if (t63) {
            const real_t t66 = TB_C(1.0) / t28;
            const real_t t67 = (t32 - facet_2) * t66;
            const real_t t68 = t66 * (t32 + facet_2);
            const real_t t69 = tb_max(t67, t68);
            const real_t t70 = tb_min(t67, t68);
            t64 = t69;
            t65 = t70;
        } else {
            t64 = TB_C(1e+30);
            t65 = -TB_C(1e+30);
        }
        const bool t71 = TB_C(0.0) < TB_ABS(t37);
        real_t t72, t73;
        if (t71) {
            const real_t t74 = TB_C(1.0) / t37;
            const real_t t75 = -((t38 + facet_3) * t74);
            const real_t t76 = t74 * (facet_3 - t38);
            const real_t t77 = tb_max(t75, t76);
            const real_t t78 = tb_min(t75, t76);
            t72 = t77;
            t73 = t78;
        } else {
            t72 = TB_C(1e+30);
            t73 = -TB_C(1e+30);
        }
        const real_t t79 = tb_min(tb_min(tb_min(t48, t56), t64), t72);
        const real_t t80 = tb_min(t79, TB_C(1.0));
        const bool t81 = t80 < tb_max(tb_max(tb_max(t49, t57), t65), t73) || t79 < TB_C(0.0);
        real_t t82, t83;
        if (t81) {
            const bool t84 = TB_C(0.0) < t39;
            const bool t85 = TB_C(0.0) < t8 - t7;
            const bool t86 = !t84;
            const real_t t87 = (t84 && t85) || (t86 && !t85) ? TB_C(10.0) : TB_C(3.0);
            const bool t88 = TB_C(0.0) < t21 - t20;
            const real_t t89 = (t84 && t88) || (t86 && !t88) ? TB_C(10.0) : TB_C(3.0);
            const bool t90 = TB_C(0.0) < t30 - t29;
            const real_t t91 = (t84 && t90) || (t86 && !t90) ? TB_C(10.0) : TB_C(3.0);
            const real_t t92 = structure[0] * t87 + structure[1] * t89 + structure[2] * t91;
            const real_t t93 = structure[4] * t87 + structure[5] * t89 + structure[6] * t91;
            const real_t t94 = structure[3] * (wrench[0] - t92) + structure[7] * (wrench[1] -
                t93);
            const real_t t95 = tb_max(t94 / (t43 + structure[7] * structure[7]), TB_C(3.0));
            const real_t t96 = tb_min(t95, TB_C(10.0));
            const real_t t97 = t92 + structure[3] * t96;
            const real_t t98 = t97 - wrench[0];
            const real_t t99 = t93 + structure[7] * t96;
            const real_t t100 = t99 - wrench[1];
            const real_t t101 = facet_3 < t40 ? t98 * t98 + t100 * t100 : TB_C(1e+30);
            const bool t102 = TB_C(0.0) < t33;
            const bool t103 = TB_C(0.0) < t5 - t4;
            const bool t104 = !t102;
            const real_t t105 = (t102 && t103) || (t104 && !t103) ? TB_C(10.0) : TB_C(3.0);
            const bool t106 = TB_C(0.0) < t18 - t17;
            const real_t t107 = (t102 && t106) || (t104 && !t106) ? TB_C(10.0) : TB_C(3.0);
            const bool t108 = TB_C(0.0) <= t31;
            const real_t t109 = (t102 && t108) || (t104 && !t108) ? TB_C(10.0) : TB_C(3.0);
            const real_t t110 = structure[0] * t105 + structure[1] * t107 + structure[3] * t109;
            const real_t t111 = structure[4] * t105 + structure[5] * t107 + structure[7] * t109;
            const real_t t112 = structure[2] * (wrench[0] - t110) + structure[6] * (wrench[1] -
                t111);
            const real_t t113 = tb_max(t112 / (t44 + structure[6] * structure[6]), TB_C(3.0));
            const real_t t114 = tb_min(t113, TB_C(10.0));
            const real_t t115 = t110 + structure[2] * t114;
            const real_t t116 = t115 - wrench[0];
            const real_t t117 = t111 + structure[6] * t114;
            const real_t t118 = t117 - wrench[1];
            const real_t t119 = facet_2 < t34 ? t116 * t116 + t118 * t118 : TB_C(1e+30);
            const bool t120 = TB_C(0.0) < t24;
            const bool t121 = TB_C(0.0) < t2 - t1;
            const bool t122 = !t120;
            const real_t t123 = (t120 && t121) || (t122 && !t121) ? TB_C(10.0) : TB_C(3.0);
            const bool t124 = TB_C(0.0) <= t19;
            const real_t t125 = (t120 && t124) || (t122 && !t124) ? TB_C(10.0) : TB_C(3.0);
            const bool t126 = TB_C(0.0) <= t22;
            const real_t t127 = (t120 && t126) || (t122 && !t126) ? TB_C(10.0) : TB_C(3.0);
            const real_t t128 = structure[0] * t123 + structure[2] * t125 + structure[3] * t127;
            const real_t t129 = structure[4] * t123 + structure[6] * t125 + structure[7] * t127;
            const real_t t130 = structure[1] * (wrench[0] - t128) + structure[5] * (wrench[1] -
                t129);
            const real_t t131 = tb_max(t130 / (t45 + structure[5] * structure[5]), TB_C(3.0));
            const real_t t132 = tb_min(t131, TB_C(10.0));
            const real_t t133 = t128 + structure[1] * t132;
            const real_t t134 = t133 - wrench[0];
            const real_t t135 = t129 + structure[5] * t132;
            const real_t t136 = t135 - wrench[1];
            const real_t t137 = facet_1 < t25 ? t134 * t134 + t136 * t136 : TB_C(1e+30);
            const bool t138 = TB_C(0.0) < t11;
            const bool t139 = TB_C(0.0) <= t3;
            const bool t140 = !t138;
            const real_t t141 = (t138 && t139) || (t140 && !t139) ? TB_C(10.0) : TB_C(3.0);
            const bool t142 = TB_C(0.0) <= t6;
            const real_t t143 = (t138 && t142) || (t140 && !t142) ? TB_C(10.0) : TB_C(3.0);
            const bool t144 = TB_C(0.0) <= t9;
            const real_t t145 = (t138 && t144) || (t140 && !t144) ? TB_C(10.0) : TB_C(3.0);
            const real_t t146 = structure[1] * t141 + structure[2] * t143 + structure[3] * t145;
            const real_t t147 = structure[5] * t141 + structure[6] * t143 + structure[7] * t145;
            const real_t t148 = structure[0] * (wrench[0] - t146) + structure[4] * (wrench[1] -
                t147);
            const real_t t149 = tb_max(t148 / (t46 + structure[4] * structure[4]), TB_C(3.0));
            const real_t t150 = tb_min(t149, TB_C(10.0));
            const real_t t151 = t146 + structure[0] * t150;
            const real_t t152 = t151 - wrench[0];
            const real_t t153 = t147 + structure[4] * t150;
            const real_t t154 = t153 - wrench[1];
            const real_t t155 = facet_0 < t12 ? t152 * t152 + t154 * t154 : TB_C(1e+30);
            const bool t156 = t155 < TB_C(1e+30);
            const real_t t157 = t156 ? t155 : TB_C(1e+30);
            const bool t158 = t137 < t157;
            const real_t t159 = t158 ? t137 : t157;
            const bool t160 = t119 < t159;
            const bool t161 = t101 < (t160 ? t119 : t159);
            real_t t162, t163;
            if (t161) {
                t162 = t97;
                t163 = t99;
            } else {
                real_t t164, t165;
                if (t160) {
                    t164 = t115;
                    t165 = t117;
                } else {
                    const real_t t166 = t158 ? t133 : (t156 ? t151 : TB_C(0.0));
                    const real_t t167 = t158 ? t135 : (t156 ? t153 : TB_C(0.0));
                    t164 = t166;
                    t165 = t167;
                }
                t162 = t164;
                t163 = t165;
            }
            t82 = t162;
            t83 = t163;
        } else {
            const real_t t168 = wrench[0] * t80;
            const real_t t169 = wrench[1] * t80;
            t82 = t168;
            t83 = t169;
        }
        served_0 = t82;
        served_1 = t83;
    }
    const real_t t170 = TB_SQRT(t43 + (t44 + (t45 + t46)));
    const real_t t171 = TB_C(0.0) <= structure[0] ? -t170 : t170;
    const real_t t172 = served_0 / t171;
    const real_t t173 = structure[0] - t171;
    const real_t t174 = structure[4] * t173 + structure[5] * structure[1];
    const real_t t175 = t174 + structure[6] * structure[2] + structure[7] * structure[3];
    const real_t t176 = TB_C(1.0) / (t170 * (t170 + TB_ABS(structure[0])));
    const real_t t177 = t175 * t176;
    const real_t t178 = structure[5] - structure[1] * t177;
    const real_t t179 = structure[6] - structure[2] * t177;
    const real_t t180 = structure[7] - structure[3] * t177;
    const real_t t181 = TB_SQRT(t178 * t178 + t179 * t179 + t180 * t180);
    const real_t t182 = TB_C(0.0) <= t178 ? -t181 : t181;
    const real_t t183 = (served_1 - t172 * (structure[4] - t173 * t177)) / t182;
    const real_t t184 = t178 - t182;
    const real_t t185 = TB_C(1.0) / (t181 * (t181 + TB_ABS(t178)));
    const real_t t186 = t183 * t184 * t185;
    const real_t t187 = t183 - t184 * t186;
    const real_t t188 = t179 * t186;
    const real_t t189 = t172 * t173 + structure[1] * t187 - structure[2] * t188;
    const real_t t190 = t180 * t186;
    const real_t t191 = t176 * (t189 - structure[3] * t190);
    const real_t t192 = t172 - t173 * t191;
    const real_t t193 = t179 * t185;
    const real_t t194 = TB_C(1.0) - t179 * t193;
    const real_t t195 = t184 * t193;
    const real_t t196 = t180 * t193;
    const real_t t197 = structure[2] * t194 - structure[1] * t195 - structure[3] * t196;
    const real_t t198 = t176 * t197;
    const real_t t199 = t173 * t198;
    const real_t t200 = t180 * t185;
    const real_t t201 = TB_C(1.0) - t180 * t200;
    const real_t t202 = t184 * t200;
    const real_t t203 = t179 * t200;
    const real_t t204 = structure[3] * t201 - (structure[1] * t202 + structure[2] * t203);
    const real_t t205 = t176 * t204;
    const real_t t206 = structure[3] * t205;
    const real_t t207 = t201 - t206;
    const real_t t208 = structure[2] * t198;
    const real_t t209 = t194 - t208;
    const real_t t210 = TB_C(3.0) - t192;
    const real_t t211 = TB_C(160.0) * TB_EPSILON;
    const bool t212 = TB_C(0.0) < t210 - t211;
    const real_t t213 = TB_C(10.0) - t192;
    const bool t214 = t212 || t211 + t213 < TB_C(0.0);
    const real_t t215 = t195 + structure[1] * t198;
    const real_t t216 = t173 * t205;
    const real_t t217 = (t212 ? t210 : t213) / (t199 * t199 + t216 * t216);
    const real_t t218 = t199 * t217;
    const real_t t219 = t202 + structure[1] * t205;
    const real_t t220 = t216 * t217;
    const real_t t221 = t214 ? t215 * t218 + t219 * t220 : TB_C(0.0);
    const real_t t222 = t187 - structure[1] * t191;
    const real_t t223 = TB_C(3.0) - t222;
    const bool t224 = t221 < t223 - t211;
    const real_t t225 = TB_C(10.0) - t222;
    const bool t226 = t224 || t211 + t225 < t221;
    const real_t t227 = t215 * t216 - t199 * t219;
    const bool t228 = TB_ABS(t227) <= TB_EPSILON;
    const real_t t229 = (t224 ? t223 : t225) / (t215 * t215 + t219 * t219);
    const real_t t230 = -t211;
    real_t t231, t232;
    if (t228) {
        t231 = -TB_C(1000000000000.0);
        t232 = TB_C(1000000000000.0);
    } else {
        const real_t t233 = (t199 * t215 + t216 * t219) * t229;
        const real_t t234 = t210 - t233;
        const real_t t235 = t213 - t233;
        const bool t236 = t234 <= t211 && t230 <= t235;
        const real_t t237 = TB_C(1.0) / t227;
        const real_t t238 = t234 * t237;
        const real_t t239 = t235 * t237;
        const real_t t240 = tb_min(t238, t239);
        const real_t t241 = t236 ? tb_min(t240, TB_C(0.0)) : t240;
        const real_t t242 = tb_max(t238, t239);
        const real_t t243 = t236 ? tb_max(t242, TB_C(0.0)) : t242;
        t231 = t241;
        t232 = t243;
    }
    const bool t244 = -TB_C(1000000000000.0) < t231;
    const real_t t245 = tb_max(TB_C(0.0), t244 ? t231 : -TB_C(1000000000000.0));
    const bool t246 = t232 < TB_C(1000000000000.0);
    const real_t t247 = tb_min(t245, t246 ? t232 : TB_C(1000000000000.0));
    const real_t t248 = t226 ? t219 * t247 - t215 * t229 : (t214 ? -t218 : TB_C(0.0));
    const real_t t249 = t203 + structure[2] * t205;
    const real_t t250 = t226 ? -(t219 * t229 + t215 * t247) : (t214 ? -t220 : TB_C(0.0));
    const real_t t251 = t209 * t248 - t249 * t250;
    const real_t t252 = t188 + structure[2] * t191;
    const real_t t253 = TB_C(3.0) + t252;
    const bool t254 = t251 < t253 - t211;
    const real_t t255 = TB_C(10.0) + t252;
    const bool t256 = t254 || t211 + t255 < t251;
    const real_t t257 = t199 * t249 + t209 * t216;
    const bool t258 = TB_ABS(t257) <= TB_EPSILON;
    const real_t t259 = (t254 ? t253 : t255) / (t209 * t209 + t249 * t249);
    real_t t260, t261;
    if (t258) {
        t260 = -TB_C(1000000000000.0);
        t261 = TB_C(1000000000000.0);
    } else {
        const real_t t262 = (t216 * t249 - t199 * t209) * t259;
        const real_t t263 = t210 - t262;
        const real_t t264 = t213 - t262;
        const bool t265 = t263 <= t211 && t230 <= t264;
        const real_t t266 = TB_C(1.0) / t257;
        const real_t t267 = -(t263 * t266);
        const real_t t268 = -(t264 * t266);
        const real_t t269 = tb_min(t267, t268);
        const real_t t270 = t265 ? tb_min(t269, TB_C(0.0)) : t269;
        const real_t t271 = tb_max(t267, t268);
        const real_t t272 = t265 ? tb_max(t271, TB_C(0.0)) : t271;
        t260 = t270;
        t261 = t272;
    }
    const bool t273 = -TB_C(1000000000000.0) < t260;
    const real_t t274 = t273 ? t260 : -TB_C(1000000000000.0);
    const real_t t275 = t215 * t249 + t209 * t219;
    const bool t276 = TB_ABS(t275) <= TB_EPSILON;
    real_t t277, t278;
    if (t276) {
        t277 = -TB_C(1000000000000.0);
        t278 = TB_C(1000000000000.0);
    } else {
        const real_t t279 = t259 * (t219 * t249 - t209 * t215);
        const real_t t280 = t223 - t279;
        const real_t t281 = t225 - t279;
        const bool t282 = t280 <= t211 && t230 <= t281;
        const real_t t283 = TB_C(1.0) / t275;
        const real_t t284 = -(t280 * t283);
        const real_t t285 = -(t281 * t283);
        const real_t t286 = tb_min(t284, t285);
        const real_t t287 = t282 ? tb_min(t286, TB_C(0.0)) : t286;
        const real_t t288 = tb_max(t284, t285);
        const real_t t289 = t282 ? tb_max(t288, TB_C(0.0)) : t288;
        t277 = t287;
        t278 = t289;
    }
    const bool t290 = t274 < t277;
    const bool t291 = t261 < TB_C(1000000000000.0);
    const real_t t292 = t291 ? t261 : TB_C(1000000000000.0);
    const bool t293 = t278 < t292;
    const real_t t294 = tb_min(tb_max(TB_C(0.0), t290 ? t277 : t274), t293 ? t278 : t292);
    const real_t t295 = t256 ? t209 * t294 - t249 * t259 : t250;
    const real_t t296 = t196 + structure[3] * t198;
    const real_t t297 = t256 ? t209 * t259 + t249 * t294 : t248;
    const real_t t298 = t207 * t295 - t296 * t297;
    const real_t t299 = t190 + structure[3] * t191;
    const real_t t300 = TB_C(3.0) + t299;
    const bool t301 = t298 < t300 - t211;
    const real_t t302 = TB_C(10.0) + t299;
    const bool t303 = t301 || t211 + t302 < t298;
    const real_t t304 = t208 - t194;
    const real_t t305 = -t215;
    const real_t t306 = -t199;
    const real_t t307 = -t249;
    const real_t t308 = -t219;
    const real_t t309 = -t216;
    real_t t310, t311, t312, t313, t314, t315;
    if (t303) {
        const real_t t316 = (t301 ? t300 : t302) / (t296 * t296 + t207 * t207);
        const real_t t317 = t199 * t207 + t216 * t296;
        const bool t318 = TB_ABS(t317) <= TB_EPSILON;
        real_t t319, t320;
        if (t318) {
            t319 = -TB_C(1000000000000.0);
            t320 = TB_C(1000000000000.0);
        } else {
            const real_t t321 = t316 * (t199 * t296 - t207 * t216);
            const real_t t322 = t210 - t321;
            const real_t t323 = t213 - t321;
            const bool t324 = t322 <= t211 && t230 <= t323;
            const real_t t325 = TB_C(1.0) / t317;
            const real_t t326 = t322 * t325;
            const real_t t327 = t323 * t325;
            const real_t t328 = tb_min(t326, t327);
            const real_t t329 = t324 ? tb_min(t328, TB_C(0.0)) : t328;
            const real_t t330 = tb_max(t326, t327);
            const real_t t331 = t324 ? tb_max(t330, TB_C(0.0)) : t330;
            t319 = t329;
            t320 = t331;
        }
        const bool t332 = -TB_C(1000000000000.0) < t319;
        const real_t t333 = t332 ? t319 : -TB_C(1000000000000.0);
        const real_t t334 = t207 * t215 + t219 * t296;
        const bool t335 = TB_ABS(t334) <= TB_EPSILON;
        real_t t336, t337;
        if (t335) {
            t336 = -TB_C(1000000000000.0);
            t337 = TB_C(1000000000000.0);
        } else {
            const real_t t338 = t316 * (t215 * t296 - t207 * t219);
            const real_t t339 = t223 - t338;
            const real_t t340 = t225 - t338;
            const bool t341 = t339 <= t211 && t230 <= t340;
            const real_t t342 = TB_C(1.0) / t334;
            const real_t t343 = t339 * t342;
            const real_t t344 = t340 * t342;
            const real_t t345 = tb_min(t343, t344);
            const real_t t346 = t341 ? tb_min(t345, TB_C(0.0)) : t345;
            const real_t t347 = tb_max(t343, t344);
            const real_t t348 = t341 ? tb_max(t347, TB_C(0.0)) : t347;
            t336 = t346;
            t337 = t348;
        }
        const bool t349 = t333 < t336;
        const real_t t350 = t349 ? t336 : t333;
        const real_t t351 = t249 * t296 - t207 * t209;
        const bool t352 = TB_ABS(t351) <= TB_EPSILON;
        real_t t353, t354;
        if (t352) {
            t353 = -TB_C(1000000000000.0);
            t354 = TB_C(1000000000000.0);
        } else {
            const real_t t355 = t316 * (t209 * t296 + t207 * t249);
            const real_t t356 = t253 + t355;
            const real_t t357 = t255 + t355;
            const bool t358 = t356 <= t211 && t230 <= t357;
            const real_t t359 = TB_C(1.0) / t351;
            const real_t t360 = t356 * t359;
            const real_t t361 = t357 * t359;
            const real_t t362 = tb_min(t360, t361);
            const real_t t363 = t358 ? tb_min(t362, TB_C(0.0)) : t362;
            const real_t t364 = tb_max(t360, t361);
            const real_t t365 = t358 ? tb_max(t364, TB_C(0.0)) : t364;
            t353 = t363;
            t354 = t365;
        }
        const bool t366 = t350 < t353;
        const bool t367 = t320 < TB_C(1000000000000.0);
        const real_t t368 = t367 ? t320 : TB_C(1000000000000.0);
        const bool t369 = t337 < t368;
        const real_t t370 = t369 ? t337 : t368;
        const bool t371 = t354 < t370;
        const real_t t372 = tb_min(tb_max(TB_C(0.0), t366 ? t353 : t350), t371 ? t354 : t370);
        const real_t t373 = -(t296 * t316 + t207 * t372);
        const real_t t374 = t207 * t316 - t296 * t372;
        const bool t375 = TB_C(0.0) < t372;
        const bool t376 = TB_C(0.0) < t351;
        const real_t t377 = t376 ? t209 : t304;
        const bool t378 = TB_C(0.0) < t334;
        const real_t t379 = t378 ? t305 : t215;
        const bool t380 = TB_C(0.0) < t317;
        const real_t t381 = t380 ? t306 : t199;
        const real_t t382 = t376 ? t307 : t249;
        const real_t t383 = t378 ? t308 : t219;
        const real_t t384 = t380 ? t309 : t216;
        real_t t385, t386;
        if (t375) {
            real_t t387, t388;
            if (t366) {
                t387 = t377;
                t388 = t382;
            } else {
                const real_t t389 = t349 ? t379 : (t332 ? t381 : TB_C(0.0));
                const real_t t390 = t349 ? t383 : (t332 ? t384 : TB_C(0.0));
                t387 = t389;
                t388 = t390;
            }
            t385 = t387;
            t386 = t388;
        } else {
            const bool t391 = t372 < TB_C(0.0);
            real_t t392, t393;
            if (t391) {
                real_t t394, t395;
                if (t371) {
                    const real_t t396 = -t377;
                    const real_t t397 = -t382;
                    t394 = t396;
                    t395 = t397;
                } else {
                    real_t t398, t399;
                    if (t369) {
                        const real_t t400 = -t379;
                        const real_t t401 = -t383;
                        t398 = t400;
                        t399 = t401;
                    } else {
                        const real_t t402 = t367 ? -t381 : TB_C(0.0);
                        const real_t t403 = t367 ? -t384 : TB_C(0.0);
                        t398 = t402;
                        t399 = t403;
                    }
                    t394 = t398;
                    t395 = t399;
                }
                t392 = t394;
                t393 = t395;
            } else {
                t392 = TB_C(0.0);
                t393 = TB_C(0.0);
            }
            t385 = t392;
            t386 = t393;
        }
        const real_t t404 = t301 ? t207 : t206 - t201;
        const real_t t405 = t301 ? -t296 : t296;
        t310 = t373;
        t311 = t374;
        t312 = t385;
        t313 = t386;
        t314 = t404;
        t315 = t405;
    } else {
        real_t t406, t407, t408, t409;
        if (t256) {
            const bool t410 = TB_C(0.0) < t294;
            const bool t411 = TB_C(0.0) < -t275;
            const real_t t412 = t411 ? t305 : t215;
            const bool t413 = TB_C(0.0) < -t257;
            const real_t t414 = t413 ? t306 : t199;
            const real_t t415 = t411 ? t308 : t219;
            const real_t t416 = t413 ? t309 : t216;
            real_t t417, t418;
            if (t410) {
                const real_t t419 = t290 ? t412 : (t273 ? t414 : TB_C(0.0));
                const real_t t420 = t290 ? t415 : (t273 ? t416 : TB_C(0.0));
                t417 = t419;
                t418 = t420;
            } else {
                const bool t421 = t294 < TB_C(0.0);
                real_t t422, t423;
                if (t421) {
                    real_t t424, t425;
                    if (t293) {
                        const real_t t426 = -t412;
                        const real_t t427 = -t415;
                        t424 = t426;
                        t425 = t427;
                    } else {
                        const real_t t428 = t291 ? -t414 : TB_C(0.0);
                        const real_t t429 = t291 ? -t416 : TB_C(0.0);
                        t424 = t428;
                        t425 = t429;
                    }
                    t422 = t424;
                    t423 = t425;
                } else {
                    t422 = TB_C(0.0);
                    t423 = TB_C(0.0);
                }
                t417 = t422;
                t418 = t423;
            }
            const real_t t430 = t254 ? t307 : t249;
            const real_t t431 = t254 ? t209 : t304;
            t406 = t417;
            t407 = t418;
            t408 = t430;
            t409 = t431;
        } else {
            real_t t432, t433, t434, t435;
            if (t226) {
                const bool t436 = TB_C(0.0) < t247;
                const bool t437 = TB_C(0.0) < t227;
                const real_t t438 = t437 ? t306 : t199;
                const real_t t439 = t437 ? t309 : t216;
                real_t t440, t441;
                if (t436) {
                    const real_t t442 = t244 ? t438 : TB_C(0.0);
                    const real_t t443 = t244 ? t439 : TB_C(0.0);
                    t440 = t442;
                    t441 = t443;
                } else {
                    const bool t444 = t247 < TB_C(0.0);
                    const real_t t445 = t444 ? (t246 ? -t438 : TB_C(0.0)) : TB_C(0.0);
                    const real_t t446 = t444 ? (t246 ? -t439 : TB_C(0.0)) : TB_C(0.0);
                    t440 = t445;
                    t441 = t446;
                }
                const real_t t447 = t224 ? t308 : t219;
                const real_t t448 = t224 ? t305 : t215;
                t432 = t440;
                t433 = t441;
                t434 = t447;
                t435 = t448;
            } else {
                const real_t t449 = t214 ? (t212 ? t309 : t216) : TB_C(0.0);
                const real_t t450 = t214 ? (t212 ? t306 : t199) : TB_C(0.0);
                t432 = TB_C(0.0);
                t433 = TB_C(0.0);
                t434 = t449;
                t435 = t450;
            }
            t406 = t432;
            t407 = t433;
            t408 = t434;
            t409 = t435;
        }
        t310 = t297;
        t311 = t295;
        t312 = t406;
        t313 = t407;
        t314 = t408;
        t315 = t409;
    }
    const real_t t451 = tb_max(t192 - (t199 * t310 + t216 * t311), TB_C(3.0));
    const real_t tension_0 = tb_min(t451, TB_C(10.0));
    const real_t t452 = tb_max(t222 - (t215 * t310 + t219 * t311), TB_C(3.0));
    const real_t tension_1 = tb_min(t452, TB_C(10.0));
    const real_t t453 = tb_max(t209 * t310 - t249 * t311 - t252, TB_C(3.0));
    const real_t tension_2 = tb_min(t453, TB_C(10.0));
    const real_t t454 = tb_max(t207 * t311 - t296 * t310 - t299, TB_C(3.0));
    const real_t tension_3 = tb_min(t454, TB_C(10.0));
    const real_t t455 = structure[0] * tension_0 + structure[1] * tension_1;
    /* what the tensions exert, S T */
    const real_t delivered_0 = t455 + structure[2] * tension_2 + structure[3] * tension_3;
    const real_t t456 = structure[4] * tension_0 + structure[5] * tension_1;
    const real_t delivered_1 = t456 + structure[6] * tension_2 + structure[7] * tension_3;
    const real_t t457 = t312 * t312 + t313 * t313;
    const real_t t458 = t310 * t314;
    const real_t t459 = t311 * t315;
    const real_t t460 = t315 * t315 + t314 * t314;
    const bool t461 = TB_C(0.0) < t460;
    const real_t t462 = TB_C(1.0) / TB_SQRT(t460);
    real_t t463;
    if (t457 <= TB_C(0.0)) {
        const real_t t464 = tb_max(TB_ABS(t458 - t459), -(t310 * t315 + t311 * t314));
        const real_t t465 = TB_C(0.0) < t464 && t461 ? t464 * t462 : TB_C(0.0);
        t463 = t465;
    } else {
        const real_t t466 = t313 * t315 - t312 * t314 < TB_C(0.0) ? -TB_C(1.0) : TB_C(1.0);
        const real_t t467 = t466 * (t459 - t458);
        const real_t t468 = t461 && TB_C(0.0) < -t467 ? -(t462 * t467) : TB_C(0.0);
        const real_t t469 = t466 * (t310 * t313 - t311 * t312);
        real_t t470;
        if (TB_C(0.0) < -t469 && TB_C(0.0) < t457) {
            const real_t t471 = -(t469 / TB_SQRT(t457));
            t470 = t471;
        } else {
            t470 = TB_C(0.0);
        }
        const real_t t472 = tb_max(t468, t470);
        t463 = t472;
    }
    const real_t kkt_residual_0 = tb_max(tb_max(t463, TB_ABS(delivered_0 - served_0)),
        TB_ABS(delivered_1 - served_1));
    const bool t473 = TB_EPSILON * TB_C(4096.0) < tb_min(TB_ABS(t171), TB_ABS(t182));
    const bool t474 = !t473;
    const bool t475 = !(kkt_residual_0 <= TB_EPSILON * TB_C(10240.0));
    if (t474) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    if (t475) {
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
    return t42 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_distribute_tension_closest(const real_t structure[8], const real_t wrench[2],
    real_t tension[4], real_t delivered[2], real_t kkt_residual[1])
{
    if (!(structure[0] >= -TB_C(4.0) && structure[0] <= TB_C(4.0)
          && structure[1] >= -TB_C(4.0) && structure[1] <= TB_C(4.0)
          && structure[2] >= -TB_C(4.0) && structure[2] <= TB_C(4.0)
          && structure[3] >= -TB_C(4.0) && structure[3] <= TB_C(4.0)
          && structure[4] >= -TB_C(4.0) && structure[4] <= TB_C(4.0)
          && structure[5] >= -TB_C(4.0) && structure[5] <= TB_C(4.0)
          && structure[6] >= -TB_C(4.0) && structure[6] <= TB_C(4.0)
          && structure[7] >= -TB_C(4.0) && structure[7] <= TB_C(4.0)
          && wrench[0] >= -TB_C(40000.0) && wrench[0] <= TB_C(40000.0)
          && wrench[1] >= -TB_C(40000.0) && wrench[1] <= TB_C(40000.0))) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = structure[0] * wrench[1] - structure[4] * wrench[0];
    const real_t t1 = structure[0] * structure[5];
    const real_t t2 = structure[4] * structure[1];
    const real_t t3 = t1 - t2;
    const real_t t4 = structure[0] * structure[6];
    const real_t t5 = structure[4] * structure[2];
    const real_t t6 = t4 - t5;
    const real_t t7 = structure[0] * structure[7];
    const real_t t8 = structure[4] * structure[3];
    const real_t t9 = t7 - t8;
    const real_t t10 = t0 - TB_C(6.5) * (t3 + t6 + t9);
    const real_t t11 = TB_ABS(t10);
    const real_t t12 = TB_ABS(t3);
    const real_t t13 = TB_ABS(t6);
    const real_t t14 = TB_ABS(t9);
    /* facets of the feasible wrenches, half distances */
    const real_t facet_0 = TB_C(3.5) * (t12 + t13 + t14);
    const real_t t15 = wrench[1] * structure[1] - wrench[0] * structure[5];
    const real_t t16 = structure[1] * structure[6];
    const real_t t17 = structure[5] * structure[2];
    const real_t t18 = t16 - t17;
    const real_t t19 = structure[1] * structure[7];
    const real_t t20 = structure[5] * structure[3];
    const real_t t21 = t19 - t20;
    const real_t t22 = t15 - TB_C(6.5) * (t18 - t3 + t21);
    const real_t t23 = TB_ABS(t22);
    const real_t t24 = TB_ABS(t18);
    const real_t t25 = TB_ABS(t21);
    const real_t facet_1 = TB_C(3.5) * (t12 + t24 + t25);
    const real_t t26 = wrench[1] * structure[2] - wrench[0] * structure[6];
    const real_t t27 = structure[2] * structure[7];
    const real_t t28 = structure[6] * structure[3];
    const real_t t29 = t27 - t28;
    const real_t t30 = t26 - TB_C(6.5) * (t29 - (t6 + t18));
    const real_t t31 = TB_ABS(t30);
    const real_t t32 = TB_ABS(t29);
    const real_t facet_2 = TB_C(3.5) * (t13 + t24 + t32);
    const bool t33 = t11 <= facet_0 && t23 <= facet_1 && t31 <= facet_2;
    const real_t t34 = wrench[1] * structure[3] - wrench[0] * structure[7];
    const real_t t35 = t34 + TB_C(6.5) * (t29 + (t9 + t21));
    const real_t t36 = TB_ABS(t35);
    const real_t facet_3 = TB_C(3.5) * (t32 + (t14 + t25));
    const bool t37 = t33 && t36 <= facet_3;
    const bool t38 = !t37;
    const real_t t39 = structure[3] * structure[3];
    const real_t t40 = structure[2] * structure[2];
    const real_t t41 = structure[1] * structure[1];
    const real_t t42 = structure[0] * structure[0];
    /* the wrench that is served */
    real_t served_0, served_1;
    if (t37) {
        served_0 = wrench[0];
        served_1 = wrench[1];
    } else {
        const bool t43 = TB_C(0.0) < t35;
        const bool t44 = TB_C(0.0) < t8 - t7;
        const bool t45 = !t43;
        const real_t t46 = (t43 && t44) || (t45 && !t44) ? TB_C(10.0) : TB_C(3.0);
        const bool t47 = TB_C(0.0) < t20 - t19;
        const real_t t48 = (t43 && t47) || (t45 && !t47) ? TB_C(10.0) : TB_C(3.0);
        const bool t49 = TB_C(0.0) < t28 - t27;
        const real_t t50 = (t43 && t49) || (t45 && !t49) ? TB_C(10.0) : TB_C(3.0);
        const real_t t51 = structure[0] * t46 + structure[1] * t48 + structure[2] * t50;
        const real_t t52 = structure[4] * t46 + structure[5] * t48 + structure[6] * t50;
        const real_t t53 = structure[3] * (wrench[0] - t51) + structure[7] * (wrench[1] - t52);
        const real_t t54 = tb_max(t53 / (t39 + structure[7] * structure[7]), TB_C(3.0));
        const real_t t55 = tb_min(t54, TB_C(10.0));
        const real_t t56 = t51 + structure[3] * t55;
        const real_t t57 = t56 - wrench[0];
        const real_t t58 = t52 + structure[7] * t55;
        const real_t t59 = t58 - wrench[1];
        const real_t t60 = facet_3 < t36 ? t57 * t57 + t59 * t59 : TB_C(1e+30);
        const bool t61 = TB_C(0.0) < t30;
        const bool t62 = TB_C(0.0) < t5 - t4;
        const bool t63 = !t61;
        const real_t t64 = (t61 && t62) || (t63 && !t62) ? TB_C(10.0) : TB_C(3.0);
        const bool t65 = TB_C(0.0) < t17 - t16;
        const real_t t66 = (t61 && t65) || (t63 && !t65) ? TB_C(10.0) : TB_C(3.0);
        const bool t67 = TB_C(0.0) <= t29;
        const real_t t68 = (t61 && t67) || (t63 && !t67) ? TB_C(10.0) : TB_C(3.0);
        const real_t t69 = structure[0] * t64 + structure[1] * t66 + structure[3] * t68;
        const real_t t70 = structure[4] * t64 + structure[5] * t66 + structure[7] * t68;
        const real_t t71 = structure[2] * (wrench[0] - t69) + structure[6] * (wrench[1] - t70);
        const real_t t72 = tb_max(t71 / (t40 + structure[6] * structure[6]), TB_C(3.0));
        const real_t t73 = tb_min(t72, TB_C(10.0));
        const real_t t74 = t69 + structure[2] * t73;
        const real_t t75 = t74 - wrench[0];
        const real_t t76 = t70 + structure[6] * t73;
        const real_t t77 = t76 - wrench[1];
        const real_t t78 = facet_2 < t31 ? t75 * t75 + t77 * t77 : TB_C(1e+30);
        const bool t79 = TB_C(0.0) < t22;
        const bool t80 = TB_C(0.0) < t2 - t1;
        const bool t81 = !t79;
        const real_t t82 = (t79 && t80) || (t81 && !t80) ? TB_C(10.0) : TB_C(3.0);
        const bool t83 = TB_C(0.0) <= t18;
        const real_t t84 = (t79 && t83) || (t81 && !t83) ? TB_C(10.0) : TB_C(3.0);
        const bool t85 = TB_C(0.0) <= t21;
        const real_t t86 = (t79 && t85) || (t81 && !t85) ? TB_C(10.0) : TB_C(3.0);
        const real_t t87 = structure[0] * t82 + structure[2] * t84 + structure[3] * t86;
        const real_t t88 = structure[4] * t82 + structure[6] * t84 + structure[7] * t86;
        const real_t t89 = structure[1] * (wrench[0] - t87) + structure[5] * (wrench[1] - t88);
        const real_t t90 = tb_max(t89 / (t41 + structure[5] * structure[5]), TB_C(3.0));
        const real_t t91 = tb_min(t90, TB_C(10.0));
        const real_t t92 = t87 + structure[1] * t91;
        const real_t t93 = t92 - wrench[0];
        const real_t t94 = t88 + structure[5] * t91;
        const real_t t95 = t94 - wrench[1];
        const real_t t96 = facet_1 < t23 ? t93 * t93 + t95 * t95 : TB_C(1e+30);
        const bool t97 = TB_C(0.0) < t10;
        const bool t98 = TB_C(0.0) <= t3;
        const bool t99 = !t97;
        const real_t t100 = (t97 && t98) || (t99 && !t98) ? TB_C(10.0) : TB_C(3.0);
        const bool t101 = TB_C(0.0) <= t6;
        const real_t t102 = (t97 && t101) || (t99 && !t101) ? TB_C(10.0) : TB_C(3.0);
        const bool t103 = TB_C(0.0) <= t9;
        const real_t t104 = (t97 && t103) || (t99 && !t103) ? TB_C(10.0) : TB_C(3.0);
        const real_t t105 = structure[1] * t100 + structure[2] * t102 + structure[3] * t104;
        const real_t t106 = structure[5] * t100 + structure[6] * t102 + structure[7] * t104;
        const real_t t107 = structure[0] * (wrench[0] - t105) + structure[4] * (wrench[1] -
            t106);
        const real_t t108 = tb_max(t107 / (t42 + structure[4] * structure[4]), TB_C(3.0));
        const real_t t109 = tb_min(t108, TB_C(10.0));
        const real_t t110 = t105 + structure[0] * t109;
        const real_t t111 = t110 - wrench[0];
        const real_t t112 = t106 + structure[4] * t109;
        const real_t t113 = t112 - wrench[1];
        const real_t t114 = facet_0 < t11 ? t111 * t111 + t113 * t113 : TB_C(1e+30);
        const bool t115 = t114 < TB_C(1e+30);
        const real_t t116 = t115 ? t114 : TB_C(1e+30);
        const bool t117 = t96 < t116;
        const real_t t118 = t117 ? t96 : t116;
        const bool t119 = t78 < t118;
        const bool t120 = t60 < (t119 ? t78 : t118);
        real_t t121, t122;
        if (t120) {
            t121 = t56;
            t122 = t58;
        } else {
            real_t t123, t124;
            if (t119) {
                t123 = t74;
                t124 = t76;
            } else {
                const real_t t125 = t117 ? t92 : (t115 ? t110 : TB_C(0.0));
                const real_t t126 = t117 ? t94 : (t115 ? t112 : TB_C(0.0));
                t123 = t125;
                t124 = t126;
            }
            t121 = t123;
            t122 = t124;
        }
        served_0 = t121;
        served_1 = t122;
    }
    const real_t t127 = TB_SQRT(t39 + (t40 + (t41 + t42)));
    const real_t t128 = TB_C(0.0) <= structure[0] ? -t127 : t127;
    const real_t t129 = served_0 / t128;
    const real_t t130 = structure[0] - t128;
    const real_t t131 = structure[4] * t130 + structure[5] * structure[1];
    const real_t t132 = t131 + structure[6] * structure[2] + structure[7] * structure[3];
    const real_t t133 = TB_C(1.0) / (t127 * (t127 + TB_ABS(structure[0])));
    const real_t t134 = t132 * t133;
    const real_t t135 = structure[5] - structure[1] * t134;
    const real_t t136 = structure[6] - structure[2] * t134;
    const real_t t137 = structure[7] - structure[3] * t134;
    const real_t t138 = TB_SQRT(t135 * t135 + t136 * t136 + t137 * t137);
    const real_t t139 = TB_C(0.0) <= t135 ? -t138 : t138;
    const real_t t140 = (served_1 - t129 * (structure[4] - t130 * t134)) / t139;
    const real_t t141 = t135 - t139;
    const real_t t142 = TB_C(1.0) / (t138 * (t138 + TB_ABS(t135)));
    const real_t t143 = t140 * t141 * t142;
    const real_t t144 = t140 - t141 * t143;
    const real_t t145 = t136 * t143;
    const real_t t146 = t129 * t130 + structure[1] * t144 - structure[2] * t145;
    const real_t t147 = t137 * t143;
    const real_t t148 = t133 * (t146 - structure[3] * t147);
    const real_t t149 = t129 - t130 * t148;
    const real_t t150 = t136 * t142;
    const real_t t151 = TB_C(1.0) - t136 * t150;
    const real_t t152 = t141 * t150;
    const real_t t153 = t137 * t150;
    const real_t t154 = structure[2] * t151 - structure[1] * t152 - structure[3] * t153;
    const real_t t155 = t133 * t154;
    const real_t t156 = t130 * t155;
    const real_t t157 = t137 * t142;
    const real_t t158 = TB_C(1.0) - t137 * t157;
    const real_t t159 = t141 * t157;
    const real_t t160 = t136 * t157;
    const real_t t161 = structure[3] * t158 - (structure[1] * t159 + structure[2] * t160);
    const real_t t162 = t133 * t161;
    const real_t t163 = structure[3] * t162;
    const real_t t164 = t158 - t163;
    const real_t t165 = structure[2] * t155;
    const real_t t166 = t151 - t165;
    const real_t t167 = TB_C(3.0) - t149;
    const real_t t168 = TB_C(160.0) * TB_EPSILON;
    const bool t169 = TB_C(0.0) < t167 - t168;
    const real_t t170 = TB_C(10.0) - t149;
    const bool t171 = t169 || t168 + t170 < TB_C(0.0);
    const real_t t172 = t152 + structure[1] * t155;
    const real_t t173 = t130 * t162;
    const real_t t174 = (t169 ? t167 : t170) / (t156 * t156 + t173 * t173);
    const real_t t175 = t156 * t174;
    const real_t t176 = t159 + structure[1] * t162;
    const real_t t177 = t173 * t174;
    const real_t t178 = t171 ? t172 * t175 + t176 * t177 : TB_C(0.0);
    const real_t t179 = t144 - structure[1] * t148;
    const real_t t180 = TB_C(3.0) - t179;
    const bool t181 = t178 < t180 - t168;
    const real_t t182 = TB_C(10.0) - t179;
    const bool t183 = t181 || t168 + t182 < t178;
    const real_t t184 = t172 * t173 - t156 * t176;
    const bool t185 = TB_ABS(t184) <= TB_EPSILON;
    const real_t t186 = (t181 ? t180 : t182) / (t172 * t172 + t176 * t176);
    const real_t t187 = -t168;
    real_t t188, t189;
    if (t185) {
        t188 = -TB_C(1000000000000.0);
        t189 = TB_C(1000000000000.0);
    } else {
        const real_t t190 = (t156 * t172 + t173 * t176) * t186;
        const real_t t191 = t167 - t190;
        const real_t t192 = t170 - t190;
        const bool t193 = t191 <= t168 && t187 <= t192;
        const real_t t194 = TB_C(1.0) / t184;
        const real_t t195 = t191 * t194;
        const real_t t196 = t192 * t194;
        const real_t t197 = tb_min(t195, t196);
        const real_t t198 = t193 ? tb_min(t197, TB_C(0.0)) : t197;
        const real_t t199 = tb_max(t195, t196);
        const real_t t200 = t193 ? tb_max(t199, TB_C(0.0)) : t199;
        t188 = t198;
        t189 = t200;
    }
    const bool t201 = -TB_C(1000000000000.0) < t188;
    const real_t t202 = tb_max(TB_C(0.0), t201 ? t188 : -TB_C(1000000000000.0));
    const bool t203 = t189 < TB_C(1000000000000.0);
    const real_t t204 = tb_min(t202, t203 ? t189 : TB_C(1000000000000.0));
    const real_t t205 = t183 ? t176 * t204 - t172 * t186 : (t171 ? -t175 : TB_C(0.0));
    const real_t t206 = t160 + structure[2] * t162;
    const real_t t207 = t183 ? -(t176 * t186 + t172 * t204) : (t171 ? -t177 : TB_C(0.0));
    const real_t t208 = t166 * t205 - t206 * t207;
    const real_t t209 = t145 + structure[2] * t148;
    const real_t t210 = TB_C(3.0) + t209;
    const bool t211 = t208 < t210 - t168;
    const real_t t212 = TB_C(10.0) + t209;
    const bool t213 = t211 || t168 + t212 < t208;
    const real_t t214 = t156 * t206 + t166 * t173;
    const bool t215 = TB_ABS(t214) <= TB_EPSILON;
    const real_t t216 = (t211 ? t210 : t212) / (t166 * t166 + t206 * t206);
    real_t t217, t218;
    if (t215) {
        t217 = -TB_C(1000000000000.0);
        t218 = TB_C(1000000000000.0);
    } else {
        const real_t t219 = (t173 * t206 - t156 * t166) * t216;
        const real_t t220 = t167 - t219;
        const real_t t221 = t170 - t219;
        const bool t222 = t220 <= t168 && t187 <= t221;
        const real_t t223 = TB_C(1.0) / t214;
        const real_t t224 = -(t220 * t223);
        const real_t t225 = -(t221 * t223);
        const real_t t226 = tb_min(t224, t225);
        const real_t t227 = t222 ? tb_min(t226, TB_C(0.0)) : t226;
        const real_t t228 = tb_max(t224, t225);
        const real_t t229 = t222 ? tb_max(t228, TB_C(0.0)) : t228;
        t217 = t227;
        t218 = t229;
    }
    const bool t230 = -TB_C(1000000000000.0) < t217;
    const real_t t231 = t230 ? t217 : -TB_C(1000000000000.0);
    const real_t t232 = t172 * t206 + t166 * t176;
    const bool t233 = TB_ABS(t232) <= TB_EPSILON;
    real_t t234, t235;
    if (t233) {
        t234 = -TB_C(1000000000000.0);
        t235 = TB_C(1000000000000.0);
    } else {
        const real_t t236 = t216 * (t176 * t206 - t166 * t172);
        const real_t t237 = t180 - t236;
        const real_t t238 = t182 - t236;
        const bool t239 = t237 <= t168 && t187 <= t238;
        const real_t t240 = TB_C(1.0) / t232;
        const real_t t241 = -(t237 * t240);
        const real_t t242 = -(t238 * t240);
        const real_t t243 = tb_min(t241, t242);
        const real_t t244 = t239 ? tb_min(t243, TB_C(0.0)) : t243;
        const real_t t245 = tb_max(t241, t242);
        const real_t t246 = t239 ? tb_max(t245, TB_C(0.0)) : t245;
        t234 = t244;
        t235 = t246;
    }
    const bool t247 = t231 < t234;
    const bool t248 = t218 < TB_C(1000000000000.0);
    const real_t t249 = t248 ? t218 : TB_C(1000000000000.0);
    const bool t250 = t235 < t249;
    const real_t t251 = tb_min(tb_max(TB_C(0.0), t247 ? t234 : t231), t250 ? t235 : t249);
    const real_t t252 = t213 ? t166 * t251 - t206 * t216 : t207;
    const real_t t253 = t153 + structure[3] * t155;
    const real_t t254 = t213 ? t166 * t216 + t206 * t251 : t205;
    const real_t t255 = t164 * t252 - t253 * t254;
    const real_t t256 = t147 + structure[3] * t148;
    const real_t t257 = TB_C(3.0) + t256;
    const bool t258 = t255 < t257 - t168;
    const real_t t259 = TB_C(10.0) + t256;
    const bool t260 = t258 || t168 + t259 < t255;
    const real_t t261 = t165 - t151;
    const real_t t262 = -t172;
    const real_t t263 = -t156;
    const real_t t264 = -t206;
    const real_t t265 = -t176;
    const real_t t266 = -t173;
    real_t t267, t268, t269, t270, t271, t272;
    if (t260) {
        const real_t t273 = (t258 ? t257 : t259) / (t253 * t253 + t164 * t164);
        const real_t t274 = t156 * t164 + t173 * t253;
        const bool t275 = TB_ABS(t274) <= TB_EPSILON;
        real_t t276, t277;
        if (t275) {
            t276 = -TB_C(1000000000000.0);
            t277 = TB_C(1000000000000.0);
        } else {
            const real_t t278 = t273 * (t156 * t253 - t164 * t173);
            const real_t t279 = t167 - t278;
            const real_t t280 = t170 - t278;
            const bool t281 = t279 <= t168 && t187 <= t280;
            const real_t t282 = TB_C(1.0) / t274;
            const real_t t283 = t279 * t282;
            const real_t t284 = t280 * t282;
            const real_t t285 = tb_min(t283, t284);
            const real_t t286 = t281 ? tb_min(t285, TB_C(0.0)) : t285;
            const real_t t287 = tb_max(t283, t284);
            const real_t t288 = t281 ? tb_max(t287, TB_C(0.0)) : t287;
            t276 = t286;
            t277 = t288;
        }
        const bool t289 = -TB_C(1000000000000.0) < t276;
        const real_t t290 = t289 ? t276 : -TB_C(1000000000000.0);
        const real_t t291 = t164 * t172 + t176 * t253;
        const bool t292 = TB_ABS(t291) <= TB_EPSILON;
        real_t t293, t294;
        if (t292) {
            t293 = -TB_C(1000000000000.0);
            t294 = TB_C(1000000000000.0);
        } else {
            const real_t t295 = t273 * (t172 * t253 - t164 * t176);
            const real_t t296 = t180 - t295;
            const real_t t297 = t182 - t295;
            const bool t298 = t296 <= t168 && t187 <= t297;
            const real_t t299 = TB_C(1.0) / t291;
            const real_t t300 = t296 * t299;
            const real_t t301 = t297 * t299;
            const real_t t302 = tb_min(t300, t301);
            const real_t t303 = t298 ? tb_min(t302, TB_C(0.0)) : t302;
            const real_t t304 = tb_max(t300, t301);
            const real_t t305 = t298 ? tb_max(t304, TB_C(0.0)) : t304;
            t293 = t303;
            t294 = t305;
        }
        const bool t306 = t290 < t293;
        const real_t t307 = t306 ? t293 : t290;
        const real_t t308 = t206 * t253 - t164 * t166;
        const bool t309 = TB_ABS(t308) <= TB_EPSILON;
        real_t t310, t311;
        if (t309) {
            t310 = -TB_C(1000000000000.0);
            t311 = TB_C(1000000000000.0);
        } else {
            const real_t t312 = t273 * (t166 * t253 + t164 * t206);
            const real_t t313 = t210 + t312;
            const real_t t314 = t212 + t312;
            const bool t315 = t313 <= t168 && t187 <= t314;
            const real_t t316 = TB_C(1.0) / t308;
            const real_t t317 = t313 * t316;
            const real_t t318 = t314 * t316;
            const real_t t319 = tb_min(t317, t318);
            const real_t t320 = t315 ? tb_min(t319, TB_C(0.0)) : t319;
            const real_t t321 = tb_max(t317, t318);
            const real_t t322 = t315 ? tb_max(t321, TB_C(0.0)) : t321;
            t310 = t320;
            t311 = t322;
        }
        const bool t323 = t307 < t310;
        const bool t324 = t277 < TB_C(1000000000000.0);
        const real_t t325 = t324 ? t277 : TB_C(1000000000000.0);
        const bool t326 = t294 < t325;
        const real_t t327 = t326 ? t294 : t325;
        const bool t328 = t311 < t327;
        const real_t t329 = tb_min(tb_max(TB_C(0.0), t323 ? t310 : t307), t328 ? t311 : t327);
        const real_t t330 = -(t253 * t273 + t164 * t329);
        const real_t t331 = t164 * t273 - t253 * t329;
        const bool t332 = TB_C(0.0) < t329;
        const bool t333 = TB_C(0.0) < t308;
        const real_t t334 = t333 ? t166 : t261;
        const bool t335 = TB_C(0.0) < t291;
        const real_t t336 = t335 ? t262 : t172;
        const bool t337 = TB_C(0.0) < t274;
        const real_t t338 = t337 ? t263 : t156;
        const real_t t339 = t333 ? t264 : t206;
        const real_t t340 = t335 ? t265 : t176;
        const real_t t341 = t337 ? t266 : t173;
        real_t t342, t343;
        if (t332) {
            real_t t344, t345;
            if (t323) {
                t344 = t334;
                t345 = t339;
            } else {
                const real_t t346 = t306 ? t336 : (t289 ? t338 : TB_C(0.0));
                const real_t t347 = t306 ? t340 : (t289 ? t341 : TB_C(0.0));
                t344 = t346;
                t345 = t347;
            }
            t342 = t344;
            t343 = t345;
        } else {
            const bool t348 = t329 < TB_C(0.0);
            real_t t349, t350;
            if (t348) {
                real_t t351, t352;
                if (t328) {
                    const real_t t353 = -t334;
                    const real_t t354 = -t339;
                    t351 = t353;
                    t352 = t354;
                } else {
                    real_t t355, t356;
                    if (t326) {
                        const real_t t357 = -t336;
                        const real_t t358 = -t340;
                        t355 = t357;
                        t356 = t358;
                    } else {
                        const real_t t359 = t324 ? -t338 : TB_C(0.0);
                        const real_t t360 = t324 ? -t341 : TB_C(0.0);
                        t355 = t359;
                        t356 = t360;
                    }
                    t351 = t355;
                    t352 = t356;
                }
                t349 = t351;
                t350 = t352;
            } else {
                t349 = TB_C(0.0);
                t350 = TB_C(0.0);
            }
            t342 = t349;
            t343 = t350;
        }
        const real_t t361 = t258 ? t164 : t163 - t158;
        const real_t t362 = t258 ? -t253 : t253;
        t267 = t330;
        t268 = t331;
        t269 = t342;
        t270 = t343;
        t271 = t361;
        t272 = t362;
    } else {
        real_t t363, t364, t365, t366;
        if (t213) {
            const bool t367 = TB_C(0.0) < t251;
            const bool t368 = TB_C(0.0) < -t232;
            const real_t t369 = t368 ? t262 : t172;
            const bool t370 = TB_C(0.0) < -t214;
            const real_t t371 = t370 ? t263 : t156;
            const real_t t372 = t368 ? t265 : t176;
            const real_t t373 = t370 ? t266 : t173;
            real_t t374, t375;
            if (t367) {
                const real_t t376 = t247 ? t369 : (t230 ? t371 : TB_C(0.0));
                const real_t t377 = t247 ? t372 : (t230 ? t373 : TB_C(0.0));
                t374 = t376;
                t375 = t377;
            } else {
                const bool t378 = t251 < TB_C(0.0);
                real_t t379, t380;
                if (t378) {
                    real_t t381, t382;
                    if (t250) {
                        const real_t t383 = -t369;
                        const real_t t384 = -t372;
                        t381 = t383;
                        t382 = t384;
                    } else {
                        const real_t t385 = t248 ? -t371 : TB_C(0.0);
                        const real_t t386 = t248 ? -t373 : TB_C(0.0);
                        t381 = t385;
                        t382 = t386;
                    }
                    t379 = t381;
                    t380 = t382;
                } else {
                    t379 = TB_C(0.0);
                    t380 = TB_C(0.0);
                }
                t374 = t379;
                t375 = t380;
            }
            const real_t t387 = t211 ? t264 : t206;
            const real_t t388 = t211 ? t166 : t261;
            t363 = t374;
            t364 = t375;
            t365 = t387;
            t366 = t388;
        } else {
            real_t t389, t390, t391, t392;
            if (t183) {
                const bool t393 = TB_C(0.0) < t204;
                const bool t394 = TB_C(0.0) < t184;
                const real_t t395 = t394 ? t263 : t156;
                const real_t t396 = t394 ? t266 : t173;
                real_t t397, t398;
                if (t393) {
                    const real_t t399 = t201 ? t395 : TB_C(0.0);
                    const real_t t400 = t201 ? t396 : TB_C(0.0);
                    t397 = t399;
                    t398 = t400;
                } else {
                    const bool t401 = t204 < TB_C(0.0);
                    const real_t t402 = t401 ? (t203 ? -t395 : TB_C(0.0)) : TB_C(0.0);
                    const real_t t403 = t401 ? (t203 ? -t396 : TB_C(0.0)) : TB_C(0.0);
                    t397 = t402;
                    t398 = t403;
                }
                const real_t t404 = t181 ? t265 : t176;
                const real_t t405 = t181 ? t262 : t172;
                t389 = t397;
                t390 = t398;
                t391 = t404;
                t392 = t405;
            } else {
                const real_t t406 = t171 ? (t169 ? t266 : t173) : TB_C(0.0);
                const real_t t407 = t171 ? (t169 ? t263 : t156) : TB_C(0.0);
                t389 = TB_C(0.0);
                t390 = TB_C(0.0);
                t391 = t406;
                t392 = t407;
            }
            t363 = t389;
            t364 = t390;
            t365 = t391;
            t366 = t392;
        }
        t267 = t254;
        t268 = t252;
        t269 = t363;
        t270 = t364;
        t271 = t365;
        t272 = t366;
    }
    const real_t t408 = tb_max(t149 - (t156 * t267 + t173 * t268), TB_C(3.0));
    const real_t tension_0 = tb_min(t408, TB_C(10.0));
    const real_t t409 = tb_max(t179 - (t172 * t267 + t176 * t268), TB_C(3.0));
    const real_t tension_1 = tb_min(t409, TB_C(10.0));
    const real_t t410 = tb_max(t166 * t267 - t206 * t268 - t209, TB_C(3.0));
    const real_t tension_2 = tb_min(t410, TB_C(10.0));
    const real_t t411 = tb_max(t164 * t268 - t253 * t267 - t256, TB_C(3.0));
    const real_t tension_3 = tb_min(t411, TB_C(10.0));
    const real_t t412 = structure[0] * tension_0 + structure[1] * tension_1;
    /* what the tensions exert, S T */
    const real_t delivered_0 = t412 + structure[2] * tension_2 + structure[3] * tension_3;
    const real_t t413 = structure[4] * tension_0 + structure[5] * tension_1;
    const real_t delivered_1 = t413 + structure[6] * tension_2 + structure[7] * tension_3;
    const real_t t414 = t269 * t269 + t270 * t270;
    const real_t t415 = t267 * t271;
    const real_t t416 = t268 * t272;
    const real_t t417 = t272 * t272 + t271 * t271;
    const bool t418 = TB_C(0.0) < t417;
    const real_t t419 = TB_C(1.0) / TB_SQRT(t417);
    real_t t420;
    if (t414 <= TB_C(0.0)) {
        const real_t t421 = tb_max(TB_ABS(t415 - t416), -(t267 * t272 + t268 * t271));
        const real_t t422 = TB_C(0.0) < t421 && t418 ? t421 * t419 : TB_C(0.0);
        t420 = t422;
    } else {
        const real_t t423 = t270 * t272 - t269 * t271 < TB_C(0.0) ? -TB_C(1.0) : TB_C(1.0);
        const real_t t424 = t423 * (t416 - t415);
        const real_t t425 = t418 && TB_C(0.0) < -t424 ? -(t419 * t424) : TB_C(0.0);
        const real_t t426 = t423 * (t267 * t270 - t268 * t269);
        real_t t427;
        if (TB_C(0.0) < -t426 && TB_C(0.0) < t414) {
            const real_t t428 = -(t426 / TB_SQRT(t414));
            t427 = t428;
        } else {
            t427 = TB_C(0.0);
        }
        const real_t t429 = tb_max(t425, t427);
        t420 = t429;
    }
    const real_t kkt_residual_0 = tb_max(tb_max(t420, TB_ABS(delivered_0 - served_0)),
        TB_ABS(delivered_1 - served_1));
    const bool t430 = TB_EPSILON * TB_C(4096.0) < tb_min(TB_ABS(t128), TB_ABS(t139));
    const bool t431 = !t430;
    const bool t432 = !(kkt_residual_0 <= TB_EPSILON * TB_C(10240.0));
    if (t431) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    if (t432) {
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
    return t38 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_distribute_tension_paper(const real_t structure[8], const real_t wrench[2], real_t
    tension[4], real_t delivered[2], real_t kkt_residual[1])
{
    if (!(structure[0] >= -TB_C(4.0) && structure[0] <= TB_C(4.0)
          && structure[1] >= -TB_C(4.0) && structure[1] <= TB_C(4.0)
          && structure[2] >= -TB_C(4.0) && structure[2] <= TB_C(4.0)
          && structure[3] >= -TB_C(4.0) && structure[3] <= TB_C(4.0)
          && structure[4] >= -TB_C(4.0) && structure[4] <= TB_C(4.0)
          && structure[5] >= -TB_C(4.0) && structure[5] <= TB_C(4.0)
          && structure[6] >= -TB_C(4.0) && structure[6] <= TB_C(4.0)
          && structure[7] >= -TB_C(4.0) && structure[7] <= TB_C(4.0)
          && wrench[0] >= -TB_C(40000.0) && wrench[0] <= TB_C(40000.0)
          && wrench[1] >= -TB_C(40000.0) && wrench[1] <= TB_C(40000.0))) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = structure[0] * structure[5];
    const real_t t1 = structure[4] * structure[1];
    const real_t t2 = t0 - t1;
    const real_t t3 = structure[0] * structure[6];
    const real_t t4 = structure[4] * structure[2];
    const real_t t5 = t3 - t4;
    const real_t t6 = structure[0] * structure[7];
    const real_t t7 = structure[4] * structure[3];
    const real_t t8 = t6 - t7;
    const bool t9 = t2 <= TB_C(0.0) && t5 <= TB_C(0.0) && t8 <= TB_C(0.0);
    const real_t t10 = structure[0] * wrench[1] - structure[4] * wrench[0];
    const real_t t11 = t10 - TB_C(3.0) * (t8 + (t2 + t5));
    const bool t12 = TB_C(0.0) <= t2 && TB_C(0.0) <= t5 && TB_C(0.0) <= t8;
    const bool t13 = (t9 && TB_C(0.0) < t11) || (t12 && t11 < TB_C(0.0));
    const real_t t14 = t1 - t0;
    const real_t t15 = structure[1] * structure[6];
    const real_t t16 = structure[5] * structure[2];
    const real_t t17 = t15 - t16;
    const real_t t18 = structure[1] * structure[7];
    const real_t t19 = structure[5] * structure[3];
    const real_t t20 = t18 - t19;
    const bool t21 = t14 <= TB_C(0.0) && t17 <= TB_C(0.0) && t20 <= TB_C(0.0);
    const real_t t22 = structure[1] * wrench[1] - structure[5] * wrench[0];
    const real_t t23 = t22 - TB_C(3.0) * (t20 + (t17 - t2));
    const bool t24 = TB_C(0.0) <= t14 && TB_C(0.0) <= t17 && TB_C(0.0) <= t20;
    const bool t25 = t13 || (t21 && TB_C(0.0) < t23) || (t24 && t23 < TB_C(0.0));
    const real_t t26 = t4 - t3;
    const real_t t27 = t16 - t15;
    const real_t t28 = structure[2] * structure[7];
    const real_t t29 = structure[6] * structure[3];
    const real_t t30 = t28 - t29;
    const bool t31 = t26 <= TB_C(0.0) && t27 <= TB_C(0.0) && t30 <= TB_C(0.0);
    const real_t t32 = structure[2] * wrench[1] - structure[6] * wrench[0];
    const real_t t33 = t32 - TB_C(3.0) * (t30 - (t5 + t17));
    const bool t34 = TB_C(0.0) <= t26 && TB_C(0.0) <= t27 && TB_C(0.0) <= t30;
    const bool t35 = t25 || (t31 && TB_C(0.0) < t33) || (t34 && t33 < TB_C(0.0));
    const real_t t36 = t7 - t6;
    const real_t t37 = t19 - t18;
    const real_t t38 = t29 - t28;
    const bool t39 = t36 <= TB_C(0.0) && t37 <= TB_C(0.0) && t38 <= TB_C(0.0);
    const real_t t40 = structure[3] * wrench[1] - structure[7] * wrench[0];
    const real_t t41 = t40 + TB_C(3.0) * (t30 + (t8 + t20));
    const bool t42 = TB_C(0.0) <= t36 && TB_C(0.0) <= t37 && TB_C(0.0) <= t38;
    const bool t43 = t35 || (t39 && TB_C(0.0) < t41) || (t42 && t41 < TB_C(0.0));
    real_t t44, t45;
    if (t43) {
        const real_t t46 = structure[3] + (structure[2] + (structure[0] + structure[1]));
        const real_t t47 = TB_C(3.0) * t46;
        const real_t t48 = structure[7] + (structure[6] + (structure[5] + structure[4]));
        const real_t t49 = TB_C(3.0) * t48;
        t44 = t47;
        t45 = t49;
    } else {
        t44 = wrench[0];
        t45 = wrench[1];
    }
    const real_t t50 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t51 = t50 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t52 = TB_SQRT(t51);
    const real_t t53 = TB_C(0.0) <= structure[0] ? -t52 : t52;
    const real_t t54 = t44 / t53;
    const real_t t55 = structure[0] - t53;
    const real_t t56 = structure[4] * t55 + structure[5] * structure[1] + structure[6] *
        structure[2];
    const real_t t57 = TB_C(1.0) / (t52 * (t52 + TB_ABS(structure[0])));
    const real_t t58 = (t56 + structure[7] * structure[3]) * t57;
    const real_t t59 = structure[5] - structure[1] * t58;
    const real_t t60 = structure[6] - structure[2] * t58;
    const real_t t61 = structure[7] - structure[3] * t58;
    const real_t t62 = TB_SQRT(t59 * t59 + t60 * t60 + t61 * t61);
    const real_t t63 = TB_C(0.0) <= t59 ? -t62 : t62;
    const real_t t64 = (t45 - t54 * (structure[4] - t55 * t58)) / t63;
    const real_t t65 = t59 - t63;
    const real_t t66 = TB_C(1.0) / (t62 * (t62 + TB_ABS(t59)));
    const real_t t67 = t64 * t65 * t66;
    const real_t t68 = t64 - t65 * t67;
    const real_t t69 = t60 * t67;
    const real_t t70 = t54 * t55 + structure[1] * t68 - structure[2] * t69;
    const real_t t71 = t61 * t67;
    const real_t t72 = t57 * (t70 - structure[3] * t71);
    const real_t t73 = t54 - t55 * t72;
    const real_t t74 = t60 * t66;
    const real_t t75 = TB_C(1.0) - t60 * t74;
    const real_t t76 = t65 * t74;
    const real_t t77 = t61 * t74;
    const real_t t78 = structure[2] * t75 - structure[1] * t76 - structure[3] * t77;
    const real_t t79 = t57 * t78;
    const real_t t80 = t55 * t79;
    const real_t t81 = t61 * t66;
    const real_t t82 = TB_C(1.0) - t61 * t81;
    const real_t t83 = t65 * t81;
    const real_t t84 = t60 * t81;
    const real_t t85 = structure[3] * t82 - (structure[1] * t83 + structure[2] * t84);
    const real_t t86 = t57 * t85;
    const real_t t87 = structure[3] * t86;
    const real_t t88 = t82 - t87;
    const real_t t89 = structure[2] * t79;
    const real_t t90 = t75 - t89;
    const real_t t91 = TB_C(3.0) - t73;
    const real_t t92 = TB_C(3.0) + (TB_ABS(t44) + TB_ABS(t45));
    const real_t t93 = TB_C(16.0) * TB_EPSILON * t92;
    const bool t94 = TB_C(0.0) < t91 - t93;
    const real_t t95 = TB_C(1000000000000.0) - t73;
    const bool t96 = t94 || t93 + t95 < TB_C(0.0);
    const real_t t97 = t76 + structure[1] * t79;
    const real_t t98 = t55 * t86;
    const real_t t99 = (t94 ? t91 : t95) / (t80 * t80 + t98 * t98);
    const real_t t100 = t80 * t99;
    const real_t t101 = t83 + structure[1] * t86;
    const real_t t102 = t98 * t99;
    const real_t t103 = t96 ? t97 * t100 + t101 * t102 : TB_C(0.0);
    const real_t t104 = t68 - structure[1] * t72;
    const real_t t105 = TB_C(3.0) - t104;
    const bool t106 = t103 < t105 - t93;
    const real_t t107 = TB_C(1000000000000.0) - t104;
    const bool t108 = t106 || t93 + t107 < t103;
    const real_t t109 = t97 * t98 - t80 * t101;
    const bool t110 = TB_ABS(t109) <= TB_EPSILON;
    const real_t t111 = (t106 ? t105 : t107) / (t97 * t97 + t101 * t101);
    const real_t t112 = -t93;
    real_t t113, t114;
    if (t110) {
        t113 = -TB_C(1000000000000.0);
        t114 = TB_C(1000000000000.0);
    } else {
        const real_t t115 = (t80 * t97 + t98 * t101) * t111;
        const real_t t116 = t91 - t115;
        const real_t t117 = t95 - t115;
        const bool t118 = t116 <= t93 && t112 <= t117;
        const real_t t119 = TB_C(1.0) / t109;
        const real_t t120 = t116 * t119;
        const real_t t121 = t117 * t119;
        const real_t t122 = tb_min(t120, t121);
        const real_t t123 = t118 ? tb_min(t122, TB_C(0.0)) : t122;
        const real_t t124 = tb_max(t120, t121);
        const real_t t125 = t118 ? tb_max(t124, TB_C(0.0)) : t124;
        t113 = t123;
        t114 = t125;
    }
    const bool t126 = -TB_C(1000000000000.0) < t113;
    const real_t t127 = tb_max(TB_C(0.0), t126 ? t113 : -TB_C(1000000000000.0));
    const bool t128 = t114 < TB_C(1000000000000.0);
    const real_t t129 = tb_min(t127, t128 ? t114 : TB_C(1000000000000.0));
    const real_t t130 = t108 ? t101 * t129 - t97 * t111 : (t96 ? -t100 : TB_C(0.0));
    const real_t t131 = t84 + structure[2] * t86;
    const real_t t132 = t108 ? -(t101 * t111 + t97 * t129) : (t96 ? -t102 : TB_C(0.0));
    const real_t t133 = t90 * t130 - t131 * t132;
    const real_t t134 = t69 + structure[2] * t72;
    const real_t t135 = TB_C(3.0) + t134;
    const bool t136 = t133 < t135 - t93;
    const real_t t137 = TB_C(1000000000000.0) + t134;
    const bool t138 = t136 || t93 + t137 < t133;
    const real_t t139 = t80 * t131 + t90 * t98;
    const bool t140 = TB_ABS(t139) <= TB_EPSILON;
    const real_t t141 = (t136 ? t135 : t137) / (t90 * t90 + t131 * t131);
    real_t t142, t143;
    if (t140) {
        t142 = -TB_C(1000000000000.0);
        t143 = TB_C(1000000000000.0);
    } else {
        const real_t t144 = (t98 * t131 - t80 * t90) * t141;
        const real_t t145 = t91 - t144;
        const real_t t146 = t95 - t144;
        const bool t147 = t145 <= t93 && t112 <= t146;
        const real_t t148 = TB_C(1.0) / t139;
        const real_t t149 = -(t145 * t148);
        const real_t t150 = -(t146 * t148);
        const real_t t151 = tb_min(t149, t150);
        const real_t t152 = t147 ? tb_min(t151, TB_C(0.0)) : t151;
        const real_t t153 = tb_max(t149, t150);
        const real_t t154 = t147 ? tb_max(t153, TB_C(0.0)) : t153;
        t142 = t152;
        t143 = t154;
    }
    const bool t155 = -TB_C(1000000000000.0) < t142;
    const real_t t156 = t155 ? t142 : -TB_C(1000000000000.0);
    const real_t t157 = t97 * t131 + t90 * t101;
    const bool t158 = TB_ABS(t157) <= TB_EPSILON;
    real_t t159, t160;
    if (t158) {
        t159 = -TB_C(1000000000000.0);
        t160 = TB_C(1000000000000.0);
    } else {
        const real_t t161 = t141 * (t101 * t131 - t90 * t97);
        const real_t t162 = t105 - t161;
        const real_t t163 = t107 - t161;
        const bool t164 = t162 <= t93 && t112 <= t163;
        const real_t t165 = TB_C(1.0) / t157;
        const real_t t166 = -(t162 * t165);
        const real_t t167 = -(t163 * t165);
        const real_t t168 = tb_min(t166, t167);
        const real_t t169 = t164 ? tb_min(t168, TB_C(0.0)) : t168;
        const real_t t170 = tb_max(t166, t167);
        const real_t t171 = t164 ? tb_max(t170, TB_C(0.0)) : t170;
        t159 = t169;
        t160 = t171;
    }
    const bool t172 = t156 < t159;
    const bool t173 = t143 < TB_C(1000000000000.0);
    const real_t t174 = t173 ? t143 : TB_C(1000000000000.0);
    const bool t175 = t160 < t174;
    const real_t t176 = tb_min(tb_max(TB_C(0.0), t172 ? t159 : t156), t175 ? t160 : t174);
    const real_t t177 = t138 ? t90 * t176 - t131 * t141 : t132;
    const real_t t178 = t77 + structure[3] * t79;
    const real_t t179 = t138 ? t90 * t141 + t131 * t176 : t130;
    const real_t t180 = t88 * t177 - t178 * t179;
    const real_t t181 = t71 + structure[3] * t72;
    const real_t t182 = TB_C(3.0) + t181;
    const bool t183 = t180 < t182 - t93;
    const real_t t184 = TB_C(1000000000000.0) + t181;
    const bool t185 = t183 || t93 + t184 < t180;
    const real_t t186 = t89 - t75;
    const real_t t187 = -t97;
    const real_t t188 = -t80;
    const real_t t189 = -t131;
    const real_t t190 = -t101;
    const real_t t191 = -t98;
    real_t t192, t193, t194, t195, t196, t197;
    if (t185) {
        const real_t t198 = (t183 ? t182 : t184) / (t178 * t178 + t88 * t88);
        const real_t t199 = t80 * t88 + t98 * t178;
        const bool t200 = TB_ABS(t199) <= TB_EPSILON;
        real_t t201, t202;
        if (t200) {
            t201 = -TB_C(1000000000000.0);
            t202 = TB_C(1000000000000.0);
        } else {
            const real_t t203 = t198 * (t80 * t178 - t88 * t98);
            const real_t t204 = t91 - t203;
            const real_t t205 = t95 - t203;
            const bool t206 = t204 <= t93 && t112 <= t205;
            const real_t t207 = TB_C(1.0) / t199;
            const real_t t208 = t204 * t207;
            const real_t t209 = t205 * t207;
            const real_t t210 = tb_min(t208, t209);
            const real_t t211 = t206 ? tb_min(t210, TB_C(0.0)) : t210;
            const real_t t212 = tb_max(t208, t209);
            const real_t t213 = t206 ? tb_max(t212, TB_C(0.0)) : t212;
            t201 = t211;
            t202 = t213;
        }
        const bool t214 = -TB_C(1000000000000.0) < t201;
        const real_t t215 = t214 ? t201 : -TB_C(1000000000000.0);
        const real_t t216 = t88 * t97 + t101 * t178;
        const bool t217 = TB_ABS(t216) <= TB_EPSILON;
        real_t t218, t219;
        if (t217) {
            t218 = -TB_C(1000000000000.0);
            t219 = TB_C(1000000000000.0);
        } else {
            const real_t t220 = t198 * (t97 * t178 - t88 * t101);
            const real_t t221 = t105 - t220;
            const real_t t222 = t107 - t220;
            const bool t223 = t221 <= t93 && t112 <= t222;
            const real_t t224 = TB_C(1.0) / t216;
            const real_t t225 = t221 * t224;
            const real_t t226 = t222 * t224;
            const real_t t227 = tb_min(t225, t226);
            const real_t t228 = t223 ? tb_min(t227, TB_C(0.0)) : t227;
            const real_t t229 = tb_max(t225, t226);
            const real_t t230 = t223 ? tb_max(t229, TB_C(0.0)) : t229;
            t218 = t228;
            t219 = t230;
        }
        const bool t231 = t215 < t218;
        const real_t t232 = t231 ? t218 : t215;
        const real_t t233 = t131 * t178 - t88 * t90;
        const bool t234 = TB_ABS(t233) <= TB_EPSILON;
        real_t t235, t236;
        if (t234) {
            t235 = -TB_C(1000000000000.0);
            t236 = TB_C(1000000000000.0);
        } else {
            const real_t t237 = t198 * (t90 * t178 + t88 * t131);
            const real_t t238 = t135 + t237;
            const real_t t239 = t137 + t237;
            const bool t240 = t238 <= t93 && t112 <= t239;
            const real_t t241 = TB_C(1.0) / t233;
            const real_t t242 = t238 * t241;
            const real_t t243 = t239 * t241;
            const real_t t244 = tb_min(t242, t243);
            const real_t t245 = t240 ? tb_min(t244, TB_C(0.0)) : t244;
            const real_t t246 = tb_max(t242, t243);
            const real_t t247 = t240 ? tb_max(t246, TB_C(0.0)) : t246;
            t235 = t245;
            t236 = t247;
        }
        const bool t248 = t232 < t235;
        const bool t249 = t202 < TB_C(1000000000000.0);
        const real_t t250 = t249 ? t202 : TB_C(1000000000000.0);
        const bool t251 = t219 < t250;
        const real_t t252 = t251 ? t219 : t250;
        const bool t253 = t236 < t252;
        const real_t t254 = tb_min(tb_max(TB_C(0.0), t248 ? t235 : t232), t253 ? t236 : t252);
        const real_t t255 = -(t178 * t198 + t88 * t254);
        const real_t t256 = t88 * t198 - t178 * t254;
        const bool t257 = TB_C(0.0) < t254;
        const bool t258 = TB_C(0.0) < t233;
        const real_t t259 = t258 ? t90 : t186;
        const bool t260 = TB_C(0.0) < t216;
        const real_t t261 = t260 ? t187 : t97;
        const bool t262 = TB_C(0.0) < t199;
        const real_t t263 = t262 ? t188 : t80;
        const real_t t264 = t258 ? t189 : t131;
        const real_t t265 = t260 ? t190 : t101;
        const real_t t266 = t262 ? t191 : t98;
        real_t t267, t268;
        if (t257) {
            real_t t269, t270;
            if (t248) {
                t269 = t259;
                t270 = t264;
            } else {
                const real_t t271 = t231 ? t261 : (t214 ? t263 : TB_C(0.0));
                const real_t t272 = t231 ? t265 : (t214 ? t266 : TB_C(0.0));
                t269 = t271;
                t270 = t272;
            }
            t267 = t269;
            t268 = t270;
        } else {
            const bool t273 = t254 < TB_C(0.0);
            real_t t274, t275;
            if (t273) {
                real_t t276, t277;
                if (t253) {
                    const real_t t278 = -t259;
                    const real_t t279 = -t264;
                    t276 = t278;
                    t277 = t279;
                } else {
                    real_t t280, t281;
                    if (t251) {
                        const real_t t282 = -t261;
                        const real_t t283 = -t265;
                        t280 = t282;
                        t281 = t283;
                    } else {
                        const real_t t284 = t249 ? -t263 : TB_C(0.0);
                        const real_t t285 = t249 ? -t266 : TB_C(0.0);
                        t280 = t284;
                        t281 = t285;
                    }
                    t276 = t280;
                    t277 = t281;
                }
                t274 = t276;
                t275 = t277;
            } else {
                t274 = TB_C(0.0);
                t275 = TB_C(0.0);
            }
            t267 = t274;
            t268 = t275;
        }
        const real_t t286 = t183 ? t88 : t87 - t82;
        const real_t t287 = t183 ? -t178 : t178;
        t192 = t255;
        t193 = t256;
        t194 = t267;
        t195 = t268;
        t196 = t286;
        t197 = t287;
    } else {
        real_t t288, t289, t290, t291;
        if (t138) {
            const bool t292 = TB_C(0.0) < t176;
            const bool t293 = TB_C(0.0) < -t157;
            const real_t t294 = t293 ? t187 : t97;
            const bool t295 = TB_C(0.0) < -t139;
            const real_t t296 = t295 ? t188 : t80;
            const real_t t297 = t293 ? t190 : t101;
            const real_t t298 = t295 ? t191 : t98;
            real_t t299, t300;
            if (t292) {
                const real_t t301 = t172 ? t294 : (t155 ? t296 : TB_C(0.0));
                const real_t t302 = t172 ? t297 : (t155 ? t298 : TB_C(0.0));
                t299 = t301;
                t300 = t302;
            } else {
                const bool t303 = t176 < TB_C(0.0);
                real_t t304, t305;
                if (t303) {
                    real_t t306, t307;
                    if (t175) {
                        const real_t t308 = -t294;
                        const real_t t309 = -t297;
                        t306 = t308;
                        t307 = t309;
                    } else {
                        const real_t t310 = t173 ? -t296 : TB_C(0.0);
                        const real_t t311 = t173 ? -t298 : TB_C(0.0);
                        t306 = t310;
                        t307 = t311;
                    }
                    t304 = t306;
                    t305 = t307;
                } else {
                    t304 = TB_C(0.0);
                    t305 = TB_C(0.0);
                }
                t299 = t304;
                t300 = t305;
            }
            const real_t t312 = t136 ? t189 : t131;
            const real_t t313 = t136 ? t90 : t186;
            t288 = t299;
            t289 = t300;
            t290 = t312;
            t291 = t313;
        } else {
            real_t t314, t315, t316, t317;
            if (t108) {
                const bool t318 = TB_C(0.0) < t129;
                const bool t319 = TB_C(0.0) < t109;
                const real_t t320 = t319 ? t188 : t80;
                const real_t t321 = t319 ? t191 : t98;
                real_t t322, t323;
                if (t318) {
                    const real_t t324 = t126 ? t320 : TB_C(0.0);
                    const real_t t325 = t126 ? t321 : TB_C(0.0);
                    t322 = t324;
                    t323 = t325;
                } else {
                    const bool t326 = t129 < TB_C(0.0);
                    const real_t t327 = t326 ? (t128 ? -t320 : TB_C(0.0)) : TB_C(0.0);
                    const real_t t328 = t326 ? (t128 ? -t321 : TB_C(0.0)) : TB_C(0.0);
                    t322 = t327;
                    t323 = t328;
                }
                const real_t t329 = t106 ? t190 : t101;
                const real_t t330 = t106 ? t187 : t97;
                t314 = t322;
                t315 = t323;
                t316 = t329;
                t317 = t330;
            } else {
                const real_t t331 = t96 ? (t94 ? t191 : t98) : TB_C(0.0);
                const real_t t332 = t96 ? (t94 ? t188 : t80) : TB_C(0.0);
                t314 = TB_C(0.0);
                t315 = TB_C(0.0);
                t316 = t331;
                t317 = t332;
            }
            t288 = t314;
            t289 = t315;
            t290 = t316;
            t291 = t317;
        }
        t192 = t179;
        t193 = t177;
        t194 = t288;
        t195 = t289;
        t196 = t290;
        t197 = t291;
    }
    const real_t t333 = tb_max(t73 - (t80 * t192 + t98 * t193), TB_C(3.0));
    const real_t t334 = tb_min(t333, TB_C(1000000000000.0));
    const real_t tension_0 = tb_min(t334, TB_C(10.0));
    const real_t t335 = tb_max(t104 - (t97 * t192 + t101 * t193), TB_C(3.0));
    const real_t t336 = tb_min(t335, TB_C(1000000000000.0));
    const real_t tension_1 = tb_min(t336, TB_C(10.0));
    const real_t t337 = tb_max(t90 * t192 - t131 * t193 - t134, TB_C(3.0));
    const real_t t338 = tb_min(t337, TB_C(1000000000000.0));
    const real_t tension_2 = tb_min(t338, TB_C(10.0));
    const real_t t339 = tb_max(t88 * t193 - t178 * t192 - t181, TB_C(3.0));
    const real_t t340 = tb_min(t339, TB_C(1000000000000.0));
    const real_t tension_3 = tb_min(t340, TB_C(10.0));
    const real_t t341 = structure[0] * tension_0 + structure[1] * tension_1;
    const real_t delivered_0 = t341 + structure[2] * tension_2 + structure[3] * tension_3;
    const real_t t342 = structure[4] * tension_0 + structure[5] * tension_1;
    const real_t delivered_1 = t342 + structure[6] * tension_2 + structure[7] * tension_3;
    const real_t t343 = t194 * t194 + t195 * t195;
    const real_t t344 = t192 * t196;
    const real_t t345 = t193 * t197;
    const real_t t346 = t197 * t197 + t196 * t196;
    const bool t347 = TB_C(0.0) < t346;
    const real_t t348 = TB_C(1.0) / TB_SQRT(t346);
    real_t t349;
    if (t343 <= TB_C(0.0)) {
        const real_t t350 = tb_max(TB_ABS(t344 - t345), -(t192 * t197 + t193 * t196));
        const real_t t351 = TB_C(0.0) < t350 && t347 ? t350 * t348 : TB_C(0.0);
        t349 = t351;
    } else {
        const real_t t352 = t195 * t197 - t194 * t196 < TB_C(0.0) ? -TB_C(1.0) : TB_C(1.0);
        const real_t t353 = t352 * (t345 - t344);
        const real_t t354 = t347 && TB_C(0.0) < -t353 ? -(t348 * t353) : TB_C(0.0);
        const real_t t355 = t352 * (t192 * t195 - t193 * t194);
        real_t t356;
        if (TB_C(0.0) < -t355 && TB_C(0.0) < t343) {
            const real_t t357 = -(t355 / TB_SQRT(t343));
            t356 = t357;
        } else {
            t356 = TB_C(0.0);
        }
        const real_t t358 = tb_max(t354, t356);
        t349 = t358;
    }
    const real_t t359 = structure[0] * t334 + structure[1] * t336 + structure[2] * t338;
    const real_t t360 = tb_max(t349, TB_ABS(t359 + structure[3] * t340 - t44));
    const real_t t361 = structure[4] * t334 + structure[5] * t336 + structure[6] * t338;
    const real_t kkt_residual_0 = tb_max(t360, TB_ABS(t361 + structure[7] * t340 - t45));
    const bool t362 = TB_EPSILON * TB_C(4096.0) < tb_min(TB_ABS(t53), TB_ABS(t63));
    const bool t363 = !t362;
    const bool t364 = kkt_residual_0 <= t92 * (TB_EPSILON * TB_C(1024.0));
    const bool t365 = !t364;
    const bool t366 = TB_C(10.0) < t334 || TB_C(10.0) < t336 || TB_C(10.0) < t338;
    const bool t367 = t43 || (t366 || TB_C(10.0) < t340);
    if (t363) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    if (t365) {
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
    return t367 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_distribute_tension(const real_t structure[8], const real_t wrench[2], real_t
    tension[4], real_t delivered[2], real_t kkt_residual[1])
{
    return tb_distribute_tension_scale(structure, wrench, tension, delivered, kkt_residual);
}

