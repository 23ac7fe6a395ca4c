/* Regenerate: turnbuckle generate machines/brau_five.toml --out <this folder>
 * Machine b614899c8a021831, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_tension.h"
#include "tb_machine.h"

tb_status tb_served_wrench_scale(const real_t structure[10], const real_t wrench[2],
    real_t served[2], real_t inner[2])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) <= TB_C(40.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(100000.0))) {
        served[0] = TB_C(0.0);
        served[1] = TB_C(0.0);
        inner[0] = TB_C(0.0);
        inner[1] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = structure[5] + structure[6] + structure[7] + structure[8];
    const real_t t1 = TB_C(5.0) * (t0 + structure[9]);
    const real_t t2 = wrench[1] - t1;
    const real_t t3 = structure[0] + structure[1] + structure[2] + structure[3];
    const real_t t4 = TB_C(5.0) * (t3 + structure[4]);
    const real_t t5 = wrench[0] - t4;
    const real_t t6 = structure[0] * t2 - structure[5] * t5;
    const real_t t7 = TB_ABS(t6);
    const real_t t8 = structure[0] * structure[6];
    const real_t t9 = structure[5] * structure[1];
    const real_t t10 = t8 - t9;
    const real_t t11 = TB_ABS(t10);
    const real_t t12 = structure[0] * structure[7];
    const real_t t13 = structure[5] * structure[2];
    const real_t t14 = t12 - t13;
    const real_t t15 = TB_ABS(t14);
    const real_t t16 = structure[0] * structure[8];
    const real_t t17 = structure[5] * structure[3];
    const real_t t18 = t16 - t17;
    const real_t t19 = TB_ABS(t18);
    const real_t t20 = structure[0] * structure[9];
    const real_t t21 = structure[5] * structure[4];
    const real_t t22 = t20 - t21;
    const real_t t23 = TB_ABS(t22);
    /* facets of the feasible wrenches, half distances */
    const real_t facet_0 = TB_C(5.0) * (t11 + t15 + t19 + t23);
    const real_t t24 = t2 * structure[1] - structure[6] * t5;
    const real_t t25 = TB_ABS(t24);
    const real_t t26 = structure[7] * structure[1];
    const real_t t27 = structure[6] * structure[2];
    const real_t t28 = t26 - t27;
    const real_t t29 = TB_ABS(t28);
    const real_t t30 = structure[8] * structure[1];
    const real_t t31 = structure[6] * structure[3];
    const real_t t32 = t30 - t31;
    const real_t t33 = TB_ABS(t32);
    const real_t t34 = structure[9] * structure[1];
    const real_t t35 = structure[6] * structure[4];
    const real_t t36 = t34 - t35;
    const real_t t37 = TB_ABS(t36);
    const real_t facet_1 = TB_C(5.0) * (t11 + t29 + t33 + t37);
    const real_t t38 = t2 * structure[2] - structure[7] * t5;
    const real_t t39 = TB_ABS(t38);
    const real_t t40 = structure[8] * structure[2];
    const real_t t41 = structure[7] * structure[3];
    const real_t t42 = t40 - t41;
    const real_t t43 = TB_ABS(t42);
    const real_t t44 = structure[9] * structure[2];
    const real_t t45 = structure[7] * structure[4];
    const real_t t46 = t44 - t45;
    const real_t t47 = TB_ABS(t46);
    const real_t facet_2 = TB_C(5.0) * (t15 + t29 + t43 + t47);
    const bool t48 = t7 <= facet_0 && t25 <= facet_1 && t39 <= facet_2;
    const real_t t49 = t2 * structure[3] - structure[8] * t5;
    const real_t t50 = TB_ABS(t49);
    const real_t t51 = structure[9] * structure[3];
    const real_t t52 = structure[8] * structure[4];
    const real_t t53 = t51 - t52;
    const real_t t54 = TB_ABS(t53);
    const real_t facet_3 = TB_C(5.0) * (t43 + (t19 + t33) + t54);
    const real_t t55 = t2 * structure[4] - structure[9] * t5;
    const real_t t56 = TB_ABS(t55);
    const real_t facet_4 = TB_C(5.0) * (t54 + (t47 + (t23 + t37)));
    const bool t57 = t48 && t50 <= facet_3 && t56 <= facet_4;
    const bool t58 = !t57;
    real_t served_0, served_1;
    if (t57) {
        served_0 = wrench[0];
        served_1 = wrench[1];
    } else {
        const real_t t59 = TB_C(160.0) * TB_EPSILON;
        const real_t t60 = structure[0] * wrench[1] - structure[5] * wrench[0];
        const bool t61 = t59 < TB_ABS(t60);
        const real_t t62 = structure[0] * t1 - structure[5] * t4;
        real_t t63, t64, t65;
        if (t61) {
            const real_t t66 = TB_C(1.0) / t60;
            const real_t t67 = (t62 - facet_0 - t59) * t66;
            const real_t t68 = t66 * (t59 + (facet_0 + t62));
            t63 = tb_max(t67, t68);
            t64 = tb_min(t67, t68);
            t65 = t66 * (t62 + TB_COPYSIGN(facet_0, t60));
        } else {
            const real_t t69 = facet_0 + t59 < TB_ABS(t62) ? TB_C(1e+30) : TB_C(0.0);
            t63 = TB_C(1.0);
            t64 = t69;
            t65 = TB_C(1.0);
        }
        const real_t t70 = wrench[1] * structure[1] - structure[6] * wrench[0];
        const bool t71 = t59 < TB_ABS(t70);
        const real_t t72 = t1 * structure[1] - structure[6] * t4;
        real_t t73, t74, t75;
        if (t71) {
            const real_t t76 = TB_C(1.0) / t70;
            const real_t t77 = (t72 - facet_1 - t59) * t76;
            const real_t t78 = t76 * (t59 + (facet_1 + t72));
            t73 = tb_max(t77, t78);
            t74 = tb_min(t77, t78);
            t75 = t76 * (t72 + TB_COPYSIGN(facet_1, t70));
        } else {
            const real_t t79 = facet_1 + t59 < TB_ABS(t72) ? TB_C(1e+30) : TB_C(0.0);
            t73 = TB_C(1.0);
            t74 = t79;
            t75 = TB_C(1.0);
        }
        const real_t t80 = wrench[1] * structure[2] - structure[7] * wrench[0];
        const bool t81 = t59 < TB_ABS(t80);
        const real_t t82 = t1 * structure[2] - structure[7] * t4;
        real_t t83, t84, t85;
        if (t81) {
            const real_t t86 = TB_C(1.0) / t80;
            const real_t t87 = (t82 - facet_2 - t59) * t86;
            const real_t t88 = t86 * (t59 + (facet_2 + t82));
            t83 = tb_max(t87, t88);
            t84 = tb_min(t87, t88);
            t85 = t86 * (t82 + TB_COPYSIGN(facet_2, t80));
        } else {
            const real_t t89 = facet_2 + t59 < TB_ABS(t82) ? TB_C(1e+30) : TB_C(0.0);
            t83 = TB_C(1.0);
            t84 = t89;
            t85 = TB_C(1.0);
        }
        const real_t t90 = wrench[1] * structure[3] - structure[8] * wrench[0];
        const bool t91 = t59 < TB_ABS(t90);
        const real_t t92 = t1 * structure[3] - structure[8] * t4;
        real_t t93, t94, t95;
        if (t91) {
            const real_t t96 = TB_C(1.0) / t90;
            const real_t t97 = (t92 - facet_3 - t59) * t96;
            const real_t t98 = t96 * (t59 + (facet_3 + t92));
            t93 = tb_max(t97, t98);
            t94 = tb_min(t97, t98);
            t95 = t96 * (t92 + TB_COPYSIGN(facet_3, t90));
        } else {
            const real_t t99 = facet_3 + t59 < TB_ABS(t92) ? TB_C(1e+30) : TB_C(0.0);
            t93 = TB_C(1.0);
            t94 = t99;
            t95 = TB_C(1.0);
        }
        const real_t t100 = tb_min(tb_min(tb_min(tb_min(TB_C(1.0), t63), t73), t83), t93);
        const real_t t101 = wrench[1] * structure[4] - structure[9] * wrench[0];
        const bool t102 = t59 < TB_ABS(t101);
        const real_t t103 = t1 * structure[4] - structure[9] * t4;
        real_t t104, t105, t106;
        if (t102) {
            const real_t t107 = TB_C(1.0) / t101;
            const real_t t108 = (t103 - facet_4 - t59) * t107;
            const real_t t109 = t107 * (t59 + (facet_4 + t103));
            t104 = tb_max(t108, t109);
            t105 = tb_min(t108, t109);
            t106 = t107 * (t103 + TB_COPYSIGN(facet_4, t101));
        } else {
            const real_t t110 = facet_4 + t59 < TB_ABS(t103) ? TB_C(1e+30) : TB_C(0.0);
            t104 = TB_C(1.0);
            t105 = t110;
            t106 = TB_C(1.0);
        }
        const real_t t111 = tb_max(tb_max(tb_max(tb_max(TB_C(0.0), t64), t74), t84), t94);
        const bool t112 = tb_min(t100, t104) < tb_max(t111, t105);
        real_t t113, t114;
        if (t112) {
            const bool t115 = TB_C(0.0) < t55;
            const real_t t116 = TB_EPSILON * TB_C(16.0);
            const bool t117 = t23 <= t116;
            const real_t t118 = structure[0] * structure[4] + structure[5] * structure[9];
            const bool t119 = TB_C(0.0) < t118;
            const bool t120 = !t117;
            const bool t121 = (t117 && !t119) || (t120 && TB_C(0.0) < t21 - t20);
            const bool t122 = !t115;
            const bool t123 = (t115 && t121) || (t122 && !t121);
            const real_t t124 = structure[0] * TB_TENSION_MAX;
            const bool t125 = t37 <= t116;
            const real_t t126 = structure[1] * structure[4] + structure[6] * structure[9];
            const bool t127 = TB_C(0.0) < t126;
            const bool t128 = !t125;
            const bool t129 = (t125 && !t127) || (t128 && TB_C(0.0) < t35 - t34);
            const bool t130 = (t115 && t129) || (t122 && !t129);
            const real_t t131 = structure[1] * TB_TENSION_MAX;
            const real_t t132 = (t123 ? t124 : TB_C(0.0)) + (t130 ? t131 : TB_C(0.0));
            const bool t133 = t47 <= t116;
            const real_t t134 = structure[2] * structure[4] + structure[7] * structure[9];
            const bool t135 = TB_C(0.0) < t134;
            const bool t136 = !t133;
            const bool t137 = (t133 && !t135) || (t136 && TB_C(0.0) < t45 - t44);
            const bool t138 = (t115 && t137) || (t122 && !t137);
            const real_t t139 = structure[2] * TB_TENSION_MAX;
            const bool t140 = t54 <= t116;
            const real_t t141 = structure[3] * structure[4] + structure[8] * structure[9];
            const bool t142 = TB_C(0.0) < t141;
            const bool t143 = !t140;
            const bool t144 = (t140 && !t142) || (t143 && TB_C(0.0) < t52 - t51);
            const bool t145 = (t115 && t144) || (t122 && !t144);
            const real_t t146 = structure[3] * TB_TENSION_MAX;
            const real_t t147 = t132 + (t138 ? t139 : TB_C(0.0)) + (t145 ? t146 : TB_C(0.0));
            const real_t t148 = structure[5] * TB_TENSION_MAX;
            const real_t t149 = structure[6] * TB_TENSION_MAX;
            const real_t t150 = (t123 ? t148 : TB_C(0.0)) + (t130 ? t149 : TB_C(0.0));
            const real_t t151 = structure[7] * TB_TENSION_MAX;
            const real_t t152 = structure[8] * TB_TENSION_MAX;
            const real_t t153 = t150 + (t138 ? t151 : TB_C(0.0)) + (t145 ? t152 : TB_C(0.0));
            const real_t t154 = structure[4] * (wrench[0] - t147) + structure[9] * (wrench[1] -
                t153);
            const real_t t155 = structure[4] * structure[4] + structure[9] * structure[9];
            const real_t t156 = tb_min(tb_max(t154 * (TB_C(1.0) / t155), TB_C(0.0)),
                TB_TENSION_MAX);
            const real_t t157 = t147 + structure[4] * t156;
            const real_t t158 = t157 - wrench[0];
            const real_t t159 = t153 + structure[9] * t156;
            const real_t t160 = t159 - wrench[1];
            const real_t t161 = facet_4 < t56 ? t158 * t158 + t160 * t160 : TB_C(1e+30);
            const bool t162 = TB_C(0.0) < t49;
            const bool t163 = t19 <= t116;
            const real_t t164 = structure[0] * structure[3] + structure[5] * structure[8];
            const bool t165 = TB_C(0.0) < t164;
            const bool t166 = !t163;
            const bool t167 = (t163 && !t165) || (t166 && TB_C(0.0) < t17 - t16);
            const bool t168 = !t162;
            const bool t169 = (t162 && t167) || (t168 && !t167);
            const bool t170 = t33 <= t116;
            const real_t t171 = structure[1] * structure[3] + structure[6] * structure[8];
            const bool t172 = TB_C(0.0) < t171;
            const bool t173 = !t170;
            const bool t174 = (t170 && !t172) || (t173 && TB_C(0.0) < t31 - t30);
            const bool t175 = (t162 && t174) || (t168 && !t174);
            const real_t t176 = (t169 ? t124 : TB_C(0.0)) + (t175 ? t131 : TB_C(0.0));
            const bool t177 = t43 <= t116;
            const real_t t178 = structure[2] * structure[3] + structure[7] * structure[8];
            const bool t179 = TB_C(0.0) < t178;
            const bool t180 = !t177;
            const bool t181 = (t177 && !t179) || (t180 && TB_C(0.0) < t41 - t40);
            const bool t182 = (t162 && t181) || (t168 && !t181);
            const bool t183 = (t140 && t142) || (t143 && TB_C(0.0) < t53);
            const bool t184 = (t162 && t183) || (t168 && !t183);
            const real_t t185 = structure[4] * TB_TENSION_MAX;
            const real_t t186 = t176 + (t182 ? t139 : TB_C(0.0)) + (t184 ? t185 : TB_C(0.0));
            const real_t t187 = (t169 ? t148 : TB_C(0.0)) + (t175 ? t149 : TB_C(0.0));
            const real_t t188 = structure[9] * TB_TENSION_MAX;
            const real_t t189 = t187 + (t182 ? t151 : TB_C(0.0)) + (t184 ? t188 : TB_C(0.0));
            const real_t t190 = structure[3] * (wrench[0] - t186) + structure[8] * (wrench[1] -
                t189);
            const real_t t191 = structure[3] * structure[3] + structure[8] * structure[8];
            const real_t t192 = tb_min(tb_max(t190 * (TB_C(1.0) / t191), TB_C(0.0)),
                TB_TENSION_MAX);
            const real_t t193 = t186 + structure[3] * t192;
            const real_t t194 = t193 - wrench[0];
            const real_t t195 = t189 + structure[8] * t192;
            const real_t t196 = t195 - wrench[1];
            const real_t t197 = facet_3 < t50 ? t194 * t194 + t196 * t196 : TB_C(1e+30);
            const bool t198 = TB_C(0.0) < t38;
            const bool t199 = t15 <= t116;
            const real_t t200 = structure[0] * structure[2] + structure[5] * structure[7];
            const bool t201 = TB_C(0.0) < t200;
            const bool t202 = !t199;
            const bool t203 = (t199 && !t201) || (t202 && TB_C(0.0) < t13 - t12);
            const bool t204 = !t198;
            const bool t205 = (t198 && t203) || (t204 && !t203);
            const bool t206 = t29 <= t116;
            const real_t t207 = structure[1] * structure[2] + structure[6] * structure[7];
            const bool t208 = TB_C(0.0) < t207;
            const bool t209 = !t206;
            const bool t210 = (t206 && !t208) || (t209 && TB_C(0.0) < t27 - t26);
            const bool t211 = (t198 && t210) || (t204 && !t210);
            const real_t t212 = (t205 ? t124 : TB_C(0.0)) + (t211 ? t131 : TB_C(0.0));
            const bool t213 = (t177 && t179) || (t180 && TB_C(0.0) < t42);
            const bool t214 = (t198 && t213) || (t204 && !t213);
            const bool t215 = (t133 && t135) || (t136 && TB_C(0.0) < t46);
            const bool t216 = (t198 && t215) || (t204 && !t215);
            const real_t t217 = t212 + (t214 ? t146 : TB_C(0.0)) + (t216 ? t185 : TB_C(0.0));
            const real_t t218 = (t205 ? t148 : TB_C(0.0)) + (t211 ? t149 : TB_C(0.0));
            const real_t t219 = t218 + (t214 ? t152 : TB_C(0.0)) + (t216 ? t188 : TB_C(0.0));
            const real_t t220 = structure[2] * (wrench[0] - t217) + structure[7] * (wrench[1] -
                t219);
            const real_t t221 = structure[2] * structure[2] + structure[7] * structure[7];
            const real_t t222 = tb_min(tb_max(t220 * (TB_C(1.0) / t221), TB_C(0.0)),
                TB_TENSION_MAX);
            const real_t t223 = t217 + structure[2] * t222;
            const real_t t224 = t223 - wrench[0];
            const real_t t225 = t219 + structure[7] * t222;
            const real_t t226 = t225 - wrench[1];
            const real_t t227 = facet_2 < t39 ? t224 * t224 + t226 * t226 : TB_C(1e+30);
            const bool t228 = TB_C(0.0) < t24;
            const bool t229 = t11 <= t116;
            const real_t t230 = structure[0] * structure[1] + structure[5] * structure[6];
            const bool t231 = TB_C(0.0) < t230;
            const bool t232 = !t229;
            const bool t233 = (t229 && !t231) || (t232 && TB_C(0.0) < t9 - t8);
            const bool t234 = !t228;
            const bool t235 = (t228 && t233) || (t234 && !t233);
            const bool t236 = (t206 && t208) || (t209 && TB_C(0.0) < t28);
            const bool t237 = (t228 && t236) || (t234 && !t236);
            const real_t t238 = (t235 ? t124 : TB_C(0.0)) + (t237 ? t139 : TB_C(0.0));
            const bool t239 = (t170 && t172) || (t173 && TB_C(0.0) < t32);
            const bool t240 = (t228 && t239) || (t234 && !t239);
            const bool t241 = (t125 && t127) || (t128 && TB_C(0.0) < t36);
            const bool t242 = (t228 && t241) || (t234 && !t241);
            const real_t t243 = t238 + (t240 ? t146 : TB_C(0.0)) + (t242 ? t185 : TB_C(0.0));
            const real_t t244 = (t235 ? t148 : TB_C(0.0)) + (t237 ? t151 : TB_C(0.0));
            const real_t t245 = t244 + (t240 ? t152 : TB_C(0.0)) + (t242 ? t188 : TB_C(0.0));
            const real_t t246 = structure[1] * (wrench[0] - t243) + structure[6] * (wrench[1] -
                t245);
            const real_t t247 = structure[1] * structure[1] + structure[6] * structure[6];
            const real_t t248 = tb_min(tb_max(t246 * (TB_C(1.0) / t247), TB_C(0.0)),
                TB_TENSION_MAX);
            const real_t t249 = t243 + structure[1] * t248;
            const real_t t250 = t249 - wrench[0];
            const real_t t251 = t245 + structure[6] * t248;
            const real_t t252 = t251 - wrench[1];
            const real_t t253 = facet_1 < t25 ? t250 * t250 + t252 * t252 : TB_C(1e+30);
            const bool t254 = TB_C(0.0) < t6;
            const bool t255 = (t229 && t231) || (t232 && TB_C(0.0) < t10);
            const bool t256 = !t254;
            const bool t257 = (t254 && t255) || (t256 && !t255);
            const bool t258 = (t199 && t201) || (t202 && TB_C(0.0) < t14);
            const bool t259 = (t254 && t258) || (t256 && !t258);
            const real_t t260 = (t257 ? t131 : TB_C(0.0)) + (t259 ? t139 : TB_C(0.0));
            const bool t261 = (t163 && t165) || (t166 && TB_C(0.0) < t18);
            const bool t262 = (t254 && t261) || (t256 && !t261);
            const bool t263 = (t117 && t119) || (t120 && TB_C(0.0) < t22);
            const bool t264 = (t254 && t263) || (t256 && !t263);
            const real_t t265 = t260 + (t262 ? t146 : TB_C(0.0)) + (t264 ? t185 : TB_C(0.0));
            const real_t t266 = (t257 ? t149 : TB_C(0.0)) + (t259 ? t151 : TB_C(0.0));
            const real_t t267 = t266 + (t262 ? t152 : TB_C(0.0)) + (t264 ? t188 : TB_C(0.0));
            const real_t t268 = structure[0] * (wrench[0] - t265) + structure[5] * (wrench[1] -
                t267);
            const real_t t269 = structure[0] * structure[0] + structure[5] * structure[5];
            const real_t t270 = tb_min(tb_max(t268 * (TB_C(1.0) / t269), TB_C(0.0)),
                TB_TENSION_MAX);
            const real_t t271 = t265 + structure[0] * t270;
            const real_t t272 = t271 - wrench[0];
            const real_t t273 = t267 + structure[5] * t270;
            const real_t t274 = t273 - wrench[1];
            const real_t t275 = facet_0 < t7 ? t272 * t272 + t274 * t274 : TB_C(1e+30);
            const bool t276 = t275 < TB_C(1e+30);
            const real_t t277 = t276 ? t275 : TB_C(1e+30);
            const bool t278 = t253 < t277;
            const real_t t279 = t278 ? t253 : t277;
            const bool t280 = t227 < t279;
            const real_t t281 = t280 ? t227 : t279;
            const bool t282 = t197 < t281;
            const bool t283 = t161 < (t282 ? t197 : t281);
            real_t t284, t285;
            if (t283) {
                t284 = t157;
                t285 = t159;
            } else {
                real_t t286, t287;
                if (t282) {
                    t286 = t193;
                    t287 = t195;
                } else {
                    real_t t288, t289;
                    if (t280) {
                        t288 = t223;
                        t289 = t225;
                    } else {
                        t288 = t278 ? t249 : (t276 ? t271 : TB_C(0.0));
                        t289 = t278 ? t251 : (t276 ? t273 : TB_C(0.0));
                    }
                    t286 = t288;
                    t287 = t289;
                }
                t284 = t286;
                t285 = t287;
            }
            t113 = t284;
            t114 = t285;
        } else {
            const real_t t290 = tb_min(tb_min(tb_min(tb_min(TB_C(1.0), t65), t75), t85), t95);
            const real_t t291 = tb_max(tb_min(t290, t106), TB_C(0.0));
            t113 = wrench[0] * t291;
            t114 = wrench[1] * t291;
        }
        const real_t t292 = TB_EPSILON * TB_C(32.0);
        served_0 = t113 + t292 * (t4 - t113);
        served_1 = t114 + t292 * (t1 - t114);
    }
    const real_t inner_0 = served_0 + TB_C(3.814697265625e-06) * (t4 - served_0);
    const real_t inner_1 = served_1 + TB_C(3.814697265625e-06) * (t1 - served_1);
    served[0] = served_0;
    served[1] = served_1;
    inner[0] = inner_0;
    inner[1] = inner_1;
    return t58 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_served_wrench_closest(const real_t structure[10], const real_t wrench[2],
    real_t served[2], real_t inner[2])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) <= TB_C(40.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(100000.0))) {
        served[0] = TB_C(0.0);
        served[1] = TB_C(0.0);
        inner[0] = TB_C(0.0);
        inner[1] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = structure[5] + structure[6] + structure[7] + structure[8];
    const real_t t1 = TB_C(5.0) * (t0 + structure[9]);
    const real_t t2 = wrench[1] - t1;
    const real_t t3 = structure[0] + structure[1] + structure[2] + structure[3];
    const real_t t4 = TB_C(5.0) * (t3 + structure[4]);
    const real_t t5 = wrench[0] - t4;
    const real_t t6 = structure[0] * t2 - structure[5] * t5;
    const real_t t7 = TB_ABS(t6);
    const real_t t8 = structure[0] * structure[6];
    const real_t t9 = structure[5] * structure[1];
    const real_t t10 = t8 - t9;
    const real_t t11 = TB_ABS(t10);
    const real_t t12 = structure[0] * structure[7];
    const real_t t13 = structure[5] * structure[2];
    const real_t t14 = t12 - t13;
    const real_t t15 = TB_ABS(t14);
    const real_t t16 = structure[0] * structure[8];
    const real_t t17 = structure[5] * structure[3];
    const real_t t18 = t16 - t17;
    const real_t t19 = TB_ABS(t18);
    const real_t t20 = structure[0] * structure[9];
    const real_t t21 = structure[5] * structure[4];
    const real_t t22 = t20 - t21;
    const real_t t23 = TB_ABS(t22);
    /* facets of the feasible wrenches, half distances */
    const real_t facet_0 = TB_C(5.0) * (t11 + t15 + t19 + t23);
    const real_t t24 = t2 * structure[1] - structure[6] * t5;
    const real_t t25 = TB_ABS(t24);
    const real_t t26 = structure[7] * structure[1];
    const real_t t27 = structure[6] * structure[2];
    const real_t t28 = t26 - t27;
    const real_t t29 = TB_ABS(t28);
    const real_t t30 = structure[8] * structure[1];
    const real_t t31 = structure[6] * structure[3];
    const real_t t32 = t30 - t31;
    const real_t t33 = TB_ABS(t32);
    const real_t t34 = structure[9] * structure[1];
    const real_t t35 = structure[6] * structure[4];
    const real_t t36 = t34 - t35;
    const real_t t37 = TB_ABS(t36);
    const real_t facet_1 = TB_C(5.0) * (t11 + t29 + t33 + t37);
    const real_t t38 = t2 * structure[2] - structure[7] * t5;
    const real_t t39 = TB_ABS(t38);
    const real_t t40 = structure[8] * structure[2];
    const real_t t41 = structure[7] * structure[3];
    const real_t t42 = t40 - t41;
    const real_t t43 = TB_ABS(t42);
    const real_t t44 = structure[9] * structure[2];
    const real_t t45 = structure[7] * structure[4];
    const real_t t46 = t44 - t45;
    const real_t t47 = TB_ABS(t46);
    const real_t facet_2 = TB_C(5.0) * (t15 + t29 + t43 + t47);
    const bool t48 = t7 <= facet_0 && t25 <= facet_1 && t39 <= facet_2;
    const real_t t49 = t2 * structure[3] - structure[8] * t5;
    const real_t t50 = TB_ABS(t49);
    const real_t t51 = structure[9] * structure[3];
    const real_t t52 = structure[8] * structure[4];
    const real_t t53 = t51 - t52;
    const real_t t54 = TB_ABS(t53);
    const real_t facet_3 = TB_C(5.0) * (t43 + (t19 + t33) + t54);
    const real_t t55 = t2 * structure[4] - structure[9] * t5;
    const real_t t56 = TB_ABS(t55);
    const real_t facet_4 = TB_C(5.0) * (t54 + (t47 + (t23 + t37)));
    const bool t57 = t48 && t50 <= facet_3 && t56 <= facet_4;
    const bool t58 = !t57;
    real_t served_0, served_1;
    if (t57) {
        served_0 = wrench[0];
        served_1 = wrench[1];
    } else {
        const bool t59 = TB_C(0.0) < t55;
        const real_t t60 = TB_C(16.0) * TB_EPSILON;
        const bool t61 = t23 <= t60;
        const real_t t62 = structure[0] * structure[4] + structure[5] * structure[9];
        const bool t63 = TB_C(0.0) < t62;
        const bool t64 = !t61;
        const bool t65 = (t61 && !t63) || (t64 && TB_C(0.0) < t21 - t20);
        const bool t66 = !t59;
        const bool t67 = (t59 && t65) || (t66 && !t65);
        const real_t t68 = structure[0] * TB_TENSION_MAX;
        const bool t69 = t37 <= t60;
        const real_t t70 = structure[1] * structure[4] + structure[6] * structure[9];
        const bool t71 = TB_C(0.0) < t70;
        const bool t72 = !t69;
        const bool t73 = (t69 && !t71) || (t72 && TB_C(0.0) < t35 - t34);
        const bool t74 = (t59 && t73) || (t66 && !t73);
        const real_t t75 = structure[1] * TB_TENSION_MAX;
        const real_t t76 = (t67 ? t68 : TB_C(0.0)) + (t74 ? t75 : TB_C(0.0));
        const bool t77 = t47 <= t60;
        const real_t t78 = structure[2] * structure[4] + structure[7] * structure[9];
        const bool t79 = TB_C(0.0) < t78;
        const bool t80 = !t77;
        const bool t81 = (t77 && !t79) || (t80 && TB_C(0.0) < t45 - t44);
        const bool t82 = (t59 && t81) || (t66 && !t81);
        const real_t t83 = structure[2] * TB_TENSION_MAX;
        const bool t84 = t54 <= t60;
        const real_t t85 = structure[3] * structure[4] + structure[8] * structure[9];
        const bool t86 = TB_C(0.0) < t85;
        const bool t87 = !t84;
        const bool t88 = (t84 && !t86) || (t87 && TB_C(0.0) < t52 - t51);
        const bool t89 = (t59 && t88) || (t66 && !t88);
        const real_t t90 = structure[3] * TB_TENSION_MAX;
        const real_t t91 = t76 + (t82 ? t83 : TB_C(0.0)) + (t89 ? t90 : TB_C(0.0));
        const real_t t92 = structure[5] * TB_TENSION_MAX;
        const real_t t93 = structure[6] * TB_TENSION_MAX;
        const real_t t94 = (t67 ? t92 : TB_C(0.0)) + (t74 ? t93 : TB_C(0.0));
        const real_t t95 = structure[7] * TB_TENSION_MAX;
        const real_t t96 = structure[8] * TB_TENSION_MAX;
        const real_t t97 = t94 + (t82 ? t95 : TB_C(0.0)) + (t89 ? t96 : TB_C(0.0));
        const real_t t98 = structure[4] * (wrench[0] - t91) + structure[9] * (wrench[1] - t97);
        const real_t t99 = structure[4] * structure[4] + structure[9] * structure[9];
        const real_t t100 = tb_min(tb_max(t98 * (TB_C(1.0) / t99), TB_C(0.0)), TB_TENSION_MAX);
        const real_t t101 = t91 + structure[4] * t100;
        const real_t t102 = t101 - wrench[0];
        const real_t t103 = t97 + structure[9] * t100;
        const real_t t104 = t103 - wrench[1];
        const real_t t105 = facet_4 < t56 ? t102 * t102 + t104 * t104 : TB_C(1e+30);
        const bool t106 = TB_C(0.0) < t49;
        const bool t107 = t19 <= t60;
        const real_t t108 = structure[0] * structure[3] + structure[5] * structure[8];
        const bool t109 = TB_C(0.0) < t108;
        const bool t110 = !t107;
        const bool t111 = (t107 && !t109) || (t110 && TB_C(0.0) < t17 - t16);
        const bool t112 = !t106;
        const bool t113 = (t106 && t111) || (t112 && !t111);
        const bool t114 = t33 <= t60;
        const real_t t115 = structure[1] * structure[3] + structure[6] * structure[8];
        const bool t116 = TB_C(0.0) < t115;
        const bool t117 = !t114;
        const bool t118 = (t114 && !t116) || (t117 && TB_C(0.0) < t31 - t30);
        const bool t119 = (t106 && t118) || (t112 && !t118);
        const real_t t120 = (t113 ? t68 : TB_C(0.0)) + (t119 ? t75 : TB_C(0.0));
        const bool t121 = t43 <= t60;
        const real_t t122 = structure[2] * structure[3] + structure[7] * structure[8];
        const bool t123 = TB_C(0.0) < t122;
        const bool t124 = !t121;
        const bool t125 = (t121 && !t123) || (t124 && TB_C(0.0) < t41 - t40);
        const bool t126 = (t106 && t125) || (t112 && !t125);
        const bool t127 = (t84 && t86) || (t87 && TB_C(0.0) < t53);
        const bool t128 = (t106 && t127) || (t112 && !t127);
        const real_t t129 = structure[4] * TB_TENSION_MAX;
        const real_t t130 = t120 + (t126 ? t83 : TB_C(0.0)) + (t128 ? t129 : TB_C(0.0));
        const real_t t131 = (t113 ? t92 : TB_C(0.0)) + (t119 ? t93 : TB_C(0.0));
        const real_t t132 = structure[9] * TB_TENSION_MAX;
        const real_t t133 = t131 + (t126 ? t95 : TB_C(0.0)) + (t128 ? t132 : TB_C(0.0));
        const real_t t134 = structure[3] * (wrench[0] - t130) + structure[8] * (wrench[1] -
            t133);
        const real_t t135 = structure[3] * structure[3] + structure[8] * structure[8];
        const real_t t136 = tb_min(tb_max(t134 * (TB_C(1.0) / t135), TB_C(0.0)),
            TB_TENSION_MAX);
        const real_t t137 = t130 + structure[3] * t136;
        const real_t t138 = t137 - wrench[0];
        const real_t t139 = t133 + structure[8] * t136;
        const real_t t140 = t139 - wrench[1];
        const real_t t141 = facet_3 < t50 ? t138 * t138 + t140 * t140 : TB_C(1e+30);
        const bool t142 = TB_C(0.0) < t38;
        const bool t143 = t15 <= t60;
        const real_t t144 = structure[0] * structure[2] + structure[5] * structure[7];
        const bool t145 = TB_C(0.0) < t144;
        const bool t146 = !t143;
        const bool t147 = (t143 && !t145) || (t146 && TB_C(0.0) < t13 - t12);
        const bool t148 = !t142;
        const bool t149 = (t142 && t147) || (t148 && !t147);
        const bool t150 = t29 <= t60;
        const real_t t151 = structure[1] * structure[2] + structure[6] * structure[7];
        const bool t152 = TB_C(0.0) < t151;
        const bool t153 = !t150;
        const bool t154 = (t150 && !t152) || (t153 && TB_C(0.0) < t27 - t26);
        const bool t155 = (t142 && t154) || (t148 && !t154);
        const real_t t156 = (t149 ? t68 : TB_C(0.0)) + (t155 ? t75 : TB_C(0.0));
        const bool t157 = (t121 && t123) || (t124 && TB_C(0.0) < t42);
        const bool t158 = (t142 && t157) || (t148 && !t157);
        const bool t159 = (t77 && t79) || (t80 && TB_C(0.0) < t46);
        const bool t160 = (t142 && t159) || (t148 && !t159);
        const real_t t161 = t156 + (t158 ? t90 : TB_C(0.0)) + (t160 ? t129 : TB_C(0.0));
        const real_t t162 = (t149 ? t92 : TB_C(0.0)) + (t155 ? t93 : TB_C(0.0));
        const real_t t163 = t162 + (t158 ? t96 : TB_C(0.0)) + (t160 ? t132 : TB_C(0.0));
        const real_t t164 = structure[2] * (wrench[0] - t161) + structure[7] * (wrench[1] -
            t163);
        const real_t t165 = structure[2] * structure[2] + structure[7] * structure[7];
        const real_t t166 = tb_min(tb_max(t164 * (TB_C(1.0) / t165), TB_C(0.0)),
            TB_TENSION_MAX);
        const real_t t167 = t161 + structure[2] * t166;
        const real_t t168 = t167 - wrench[0];
        const real_t t169 = t163 + structure[7] * t166;
        const real_t t170 = t169 - wrench[1];
        const real_t t171 = facet_2 < t39 ? t168 * t168 + t170 * t170 : TB_C(1e+30);
        const bool t172 = TB_C(0.0) < t24;
        const bool t173 = t11 <= t60;
        const real_t t174 = structure[0] * structure[1] + structure[5] * structure[6];
        const bool t175 = TB_C(0.0) < t174;
        const bool t176 = !t173;
        const bool t177 = (t173 && !t175) || (t176 && TB_C(0.0) < t9 - t8);
        const bool t178 = !t172;
        const bool t179 = (t172 && t177) || (t178 && !t177);
        const bool t180 = (t150 && t152) || (t153 && TB_C(0.0) < t28);
        const bool t181 = (t172 && t180) || (t178 && !t180);
        const real_t t182 = (t179 ? t68 : TB_C(0.0)) + (t181 ? t83 : TB_C(0.0));
        const bool t183 = (t114 && t116) || (t117 && TB_C(0.0) < t32);
        const bool t184 = (t172 && t183) || (t178 && !t183);
        const bool t185 = (t69 && t71) || (t72 && TB_C(0.0) < t36);
        const bool t186 = (t172 && t185) || (t178 && !t185);
        const real_t t187 = t182 + (t184 ? t90 : TB_C(0.0)) + (t186 ? t129 : TB_C(0.0));
        const real_t t188 = (t179 ? t92 : TB_C(0.0)) + (t181 ? t95 : TB_C(0.0));
        const real_t t189 = t188 + (t184 ? t96 : TB_C(0.0)) + (t186 ? t132 : TB_C(0.0));
        const real_t t190 = structure[1] * (wrench[0] - t187) + structure[6] * (wrench[1] -
            t189);
        const real_t t191 = structure[1] * structure[1] + structure[6] * structure[6];
        const real_t t192 = tb_min(tb_max(t190 * (TB_C(1.0) / t191), TB_C(0.0)),
            TB_TENSION_MAX);
        const real_t t193 = t187 + structure[1] * t192;
        const real_t t194 = t193 - wrench[0];
        const real_t t195 = t189 + structure[6] * t192;
        const real_t t196 = t195 - wrench[1];
        const real_t t197 = facet_1 < t25 ? t194 * t194 + t196 * t196 : TB_C(1e+30);
        const bool t198 = TB_C(0.0) < t6;
        const bool t199 = (t173 && t175) || (t176 && TB_C(0.0) < t10);
        const bool t200 = !t198;
        const bool t201 = (t198 && t199) || (t200 && !t199);
        const bool t202 = (t143 && t145) || (t146 && TB_C(0.0) < t14);
        const bool t203 = (t198 && t202) || (t200 && !t202);
        const real_t t204 = (t201 ? t75 : TB_C(0.0)) + (t203 ? t83 : TB_C(0.0));
        const bool t205 = (t107 && t109) || (t110 && TB_C(0.0) < t18);
        const bool t206 = (t198 && t205) || (t200 && !t205);
        const bool t207 = (t61 && t63) || (t64 && TB_C(0.0) < t22);
        const bool t208 = (t198 && t207) || (t200 && !t207);
        const real_t t209 = t204 + (t206 ? t90 : TB_C(0.0)) + (t208 ? t129 : TB_C(0.0));
        const real_t t210 = (t201 ? t93 : TB_C(0.0)) + (t203 ? t95 : TB_C(0.0));
        const real_t t211 = t210 + (t206 ? t96 : TB_C(0.0)) + (t208 ? t132 : TB_C(0.0));
        const real_t t212 = structure[0] * (wrench[0] - t209) + structure[5] * (wrench[1] -
            t211);
        const real_t t213 = structure[0] * structure[0] + structure[5] * structure[5];
        const real_t t214 = tb_min(tb_max(t212 * (TB_C(1.0) / t213), TB_C(0.0)),
            TB_TENSION_MAX);
        const real_t t215 = t209 + structure[0] * t214;
        const real_t t216 = t215 - wrench[0];
        const real_t t217 = t211 + structure[5] * t214;
        const real_t t218 = t217 - wrench[1];
        const real_t t219 = facet_0 < t7 ? t216 * t216 + t218 * t218 : TB_C(1e+30);
        const bool t220 = t219 < TB_C(1e+30);
        const real_t t221 = t220 ? t219 : TB_C(1e+30);
        const bool t222 = t197 < t221;
        const real_t t223 = t222 ? t197 : t221;
        const bool t224 = t171 < t223;
        const real_t t225 = t224 ? t171 : t223;
        const bool t226 = t141 < t225;
        const bool t227 = t105 < (t226 ? t141 : t225);
        real_t t228, t229;
        if (t227) {
            t228 = t101;
            t229 = t103;
        } else {
            real_t t230, t231;
            if (t226) {
                t230 = t137;
                t231 = t139;
            } else {
                real_t t232, t233;
                if (t224) {
                    t232 = t167;
                    t233 = t169;
                } else {
                    t232 = t222 ? t193 : (t220 ? t215 : TB_C(0.0));
                    t233 = t222 ? t195 : (t220 ? t217 : TB_C(0.0));
                }
                t230 = t232;
                t231 = t233;
            }
            t228 = t230;
            t229 = t231;
        }
        const real_t t234 = TB_EPSILON * TB_C(32.0);
        served_0 = t228 + t234 * (t4 - t228);
        served_1 = t229 + t234 * (t1 - t229);
    }
    const real_t inner_0 = served_0 + TB_C(3.814697265625e-06) * (t4 - served_0);
    const real_t inner_1 = served_1 + TB_C(3.814697265625e-06) * (t1 - served_1);
    served[0] = served_0;
    served[1] = served_1;
    inner[0] = inner_0;
    inner[1] = inner_1;
    return t58 ? TB_INFEASIBLE : TB_OK;
}

/* Refuses with a status: pivot is 0; side is 0; moving is 0; push is 0 N. */
static tb_status tb_refuse_least_norm_tension_begin(tb_status status, real_t pivot[1],
    real_t side[5], real_t moving[1], real_t push[1])
{
    pivot[0] = TB_C(0.0);
    side[0] = TB_C(0.0);
    side[1] = TB_C(0.0);
    side[2] = TB_C(0.0);
    side[3] = TB_C(0.0);
    side[4] = TB_C(0.0);
    moving[0] = TB_C(0.0);
    push[0] = TB_C(0.0);
    return status;
}

/* All cables are free. */
static tb_status tb_least_norm_tension_begin(const real_t structure[10], const real_t wrench[2],
    real_t pivot[1], real_t side[5], real_t moving[1], real_t push[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) <= TB_C(40.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(100000.0))) {
        return tb_refuse_least_norm_tension_begin(TB_OUT_OF_DOMAIN, pivot, side, moving, push);
    }
    const real_t t0 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t1 = t0 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t2 = TB_SQRT(t1 + structure[4] * structure[4]);
    const real_t t3 = TB_COPYSIGN(t2, structure[0]);
    const real_t t4 = TB_ABS(t3);
    const real_t t5 = (structure[0] + t3) * structure[5] + structure[1] * structure[6];
    const real_t t6 = t5 + structure[2] * structure[7] + structure[3] * structure[8];
    const real_t t7 = (t6 + structure[4] * structure[9]) * (TB_C(1.0) / (t2 * (t2 +
        TB_ABS(structure[0]))));
    const real_t t8 = structure[6] - structure[1] * t7;
    const real_t t9 = structure[7] - structure[2] * t7;
    const real_t t10 = structure[8] - structure[3] * t7;
    const real_t t11 = structure[9] - structure[4] * t7;
    const real_t t12 = TB_SQRT(t8 * t8 + t9 * t9 + t10 * t10 + t11 * t11);
    const real_t t13 = TB_ABS(TB_COPYSIGN(t12, t8));
    const real_t pivot_0 = tb_min(t4, t13);
    const real_t t14 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const bool t15 = !(t14 < t4 && t14 < t13);
    if (t15) {
        return tb_refuse_least_norm_tension_begin(TB_SINGULAR, pivot, side, moving, push);
    }
    pivot[0] = pivot_0;
    side[0] = TB_C(0.0);
    side[1] = TB_C(0.0);
    side[2] = TB_C(0.0);
    side[3] = TB_C(0.0);
    side[4] = TB_C(0.0);
    moving[0] = -TB_C(1.0);
    push[0] = TB_C(0.0);
    return TB_OK;
}

/* Moves a cable towards its bounds, until it is held or another one is freed. */
static tb_status tb_least_norm_tension_step(const real_t structure[10], const real_t wrench[2],
    real_t side[5], real_t moving[1], real_t push[1], real_t done[1])
{
    const bool t0 = side[0] == TB_C(0.0);
    const real_t t1 = t0 ? TB_C(1.0) : TB_C(0.0);
    const bool t2 = TB_C(0.0) == side[1];
    const real_t t3 = t2 ? TB_C(1.0) : TB_C(0.0);
    const bool t4 = TB_C(0.0) == side[2];
    const real_t t5 = t4 ? TB_C(1.0) : TB_C(0.0);
    const bool t6 = TB_C(0.0) == side[3];
    const real_t t7 = t6 ? TB_C(1.0) : TB_C(0.0);
    const bool t8 = TB_C(0.0) == side[4];
    const real_t t9 = t8 ? TB_C(1.0) : TB_C(0.0);
    const real_t t10 = t0 ? (t0 ? structure[0] * structure[0] : TB_C(0.0)) : TB_C(0.0);
    const real_t t11 = t2 ? (t2 ? structure[1] * structure[1] : TB_C(0.0)) : TB_C(0.0);
    const real_t t12 = t4 ? (t4 ? structure[2] * structure[2] : TB_C(0.0)) : TB_C(0.0);
    const real_t t13 = t6 ? (t6 ? structure[3] * structure[3] : TB_C(0.0)) : TB_C(0.0);
    const real_t t14 = t8 ? (t8 ? structure[4] * structure[4] : TB_C(0.0)) : TB_C(0.0);
    const real_t t15 = TB_SQRT(t10 + t11 + t12 + t13 + t14);
    const real_t t16 = t0 ? structure[0] : TB_C(0.0);
    const real_t t17 = TB_COPYSIGN(t15, t16);
    const real_t t18 = t16 + t17;
    const real_t t19 = t2 ? (t2 ? structure[1] * structure[6] : TB_C(0.0)) : TB_C(0.0);
    const real_t t20 = t4 ? (t4 ? structure[2] * structure[7] : TB_C(0.0)) : TB_C(0.0);
    const real_t t21 = (t0 ? t18 * structure[5] : TB_C(0.0)) + t19 + t20;
    const real_t t22 = t6 ? (t6 ? structure[3] * structure[8] : TB_C(0.0)) : TB_C(0.0);
    const real_t t23 = t8 ? (t8 ? structure[4] * structure[9] : TB_C(0.0)) : TB_C(0.0);
    const real_t t24 = (t21 + t22 + t23) * (TB_C(1.0) / (t15 * (t15 + TB_ABS(t16))));
    const real_t t25 = structure[6] - structure[1] * t24;
    const real_t t26 = structure[7] - structure[2] * t24;
    const real_t t27 = (t2 ? (t2 ? t25 * t25 : TB_C(0.0)) : TB_C(0.0)) + (t4 ? (t4 ? t26 * t26
        : TB_C(0.0)) : TB_C(0.0));
    const real_t t28 = structure[8] - structure[3] * t24;
    const real_t t29 = t27 + (t6 ? (t6 ? t28 * t28 : TB_C(0.0)) : TB_C(0.0));
    const real_t t30 = structure[9] - structure[4] * t24;
    const real_t t31 = t29 + (t8 ? (t8 ? t30 * t30 : TB_C(0.0)) : TB_C(0.0));
    const real_t t32 = TB_COPYSIGN(TB_SQRT(t31), t2 ? t25 : TB_C(0.0));
    const real_t t33 = tb_min(TB_C(1.0), tb_min(TB_ABS(t17), TB_ABS(t32)));
    const real_t t34 = TB_C(1.0) / t33;
    const real_t t35 = TB_C(64.0) * TB_EPSILON * t34;
    const bool t36 = TB_C(0.0) <= moving[0];
    const real_t t37 = TB_C(1.0) / t17;
    const bool t38 = TB_C(0.0) < side[0];
    const bool t39 = TB_C(0.0) < side[1];
    const real_t t40 = (t38 ? structure[0] * TB_TENSION_MAX : TB_C(0.0)) + (t39 ? structure[1]
        * TB_TENSION_MAX : TB_C(0.0));
    const bool t41 = TB_C(0.0) < side[2];
    const real_t t42 = t40 + (t41 ? structure[2] * TB_TENSION_MAX : TB_C(0.0));
    const bool t43 = TB_C(0.0) < side[3];
    const real_t t44 = t42 + (t43 ? structure[3] * TB_TENSION_MAX : TB_C(0.0));
    const bool t45 = TB_C(0.0) < side[4];
    const real_t t46 = t44 + (t45 ? structure[4] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t47 = (wrench[0] - t46) * t37;
    const real_t t48 = (t0 ? structure[5] : TB_C(0.0)) - t18 * t24;
    const real_t t49 = TB_C(1.0) / t32;
    const real_t t50 = (t38 ? structure[5] * TB_TENSION_MAX : TB_C(0.0)) + (t39 ? structure[6]
        * TB_TENSION_MAX : TB_C(0.0));
    const real_t t51 = t50 + (t41 ? structure[7] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t52 = t51 + (t43 ? structure[8] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t53 = t52 + (t45 ? structure[9] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t54 = t49 * ((wrench[1] - t53 + t47 * t48) * t49);
    const real_t t55 = t37 * (t47 + t48 * t54);
    const real_t t56 = structure[3] * t55 + structure[8] * t54;
    const real_t t57 = TB_C(0.0) < t7 ? tb_max(-t56, t56 - TB_TENSION_MAX) : -TB_C(1.0);
    const real_t t58 = structure[4] * t55 + structure[9] * t54;
    const real_t t59 = TB_C(0.0) < t9 ? tb_max(-t58, t58 - TB_TENSION_MAX) : -TB_C(1.0);
    const real_t t60 = structure[0] * t55 + structure[5] * t54;
    const real_t t61 = TB_C(0.0) < t1 ? tb_max(-t60, t60 - TB_TENSION_MAX) : -TB_C(1.0);
    const real_t t62 = structure[1] * t55 + structure[6] * t54;
    const real_t t63 = TB_C(0.0) < t3 ? tb_max(-t62, t62 - TB_TENSION_MAX) : -TB_C(1.0);
    const real_t t64 = structure[2] * t55 + structure[7] * t54;
    const real_t t65 = TB_C(0.0) < t5 ? tb_max(-t64, t64 - TB_TENSION_MAX) : -TB_C(1.0);
    real_t t66, t67, t68, t69, t70;
    if (t36) {
        t66 = moving[0] == TB_C(3.0) ? TB_C(1.0) : TB_C(0.0);
        t67 = moving[0] == TB_C(4.0) ? TB_C(1.0) : TB_C(0.0);
        t68 = TB_C(0.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
        t69 = TB_C(1.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
        t70 = TB_C(2.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
    } else {
        t66 = t57;
        t67 = t59;
        t68 = t61;
        t69 = t63;
        t70 = t65;
    }
    const real_t t71 = tb_max(t68, t69);
    const bool t72 = tb_max(t66, t67) <= tb_max(t71, t70);
    real_t t73, t74, t75, t76;
    if (t72) {
        const bool t77 = t70 <= t71;
        real_t t78, t79, t80, t81;
        if (t77) {
            const bool t82 = t69 <= t68;
            t78 = t82 ? TB_C(0.0) : TB_C(1.0);
            t79 = t82 ? structure[0] : structure[1];
            t80 = t82 ? structure[5] : structure[6];
            t81 = t82 ? t60 : t62;
        } else {
            t78 = TB_C(2.0);
            t79 = structure[2];
            t80 = structure[7];
            t81 = t64;
        }
        t73 = t78;
        t74 = t79;
        t75 = t80;
        t76 = t81;
    } else {
        const bool t83 = t67 <= t66;
        t73 = t83 ? TB_C(3.0) : TB_C(4.0);
        t74 = t83 ? structure[3] : structure[4];
        t75 = t83 ? structure[8] : structure[9];
        t76 = t83 ? t56 : t58;
    }
    const real_t t84 = t37 * t74;
    const real_t t85 = t49 * (t49 * (t75 + t48 * t84));
    const real_t t86 = t37 * (t84 + t48 * t85);
    const real_t t87 = structure[0] * t86 + structure[5] * t85;
    const real_t t88 = (TB_C(0.0) == t73 ? TB_C(1.0) : TB_C(0.0)) - t87;
    const real_t t89 = structure[1] * t86 + structure[6] * t85;
    const real_t t90 = (TB_C(1.0) == t73 ? TB_C(1.0) : TB_C(0.0)) - t89;
    const real_t t91 = (t0 ? (t0 ? t88 * t88 : TB_C(0.0)) : TB_C(0.0)) + (t2 ? (t2 ? t90 * t90
        : TB_C(0.0)) : TB_C(0.0));
    const real_t t92 = structure[2] * t86 + structure[7] * t85;
    const real_t t93 = (TB_C(2.0) == t73 ? TB_C(1.0) : TB_C(0.0)) - t92;
    const real_t t94 = t91 + (t4 ? (t4 ? t93 * t93 : TB_C(0.0)) : TB_C(0.0));
    const real_t t95 = structure[3] * t86 + structure[8] * t85;
    const real_t t96 = (TB_C(3.0) == t73 ? TB_C(1.0) : TB_C(0.0)) - t95;
    const real_t t97 = t94 + (t6 ? (t6 ? t96 * t96 : TB_C(0.0)) : TB_C(0.0));
    const real_t t98 = structure[4] * t86 + structure[9] * t85;
    const real_t t99 = (TB_C(4.0) == t73 ? TB_C(1.0) : TB_C(0.0)) - t98;
    const real_t t100 = t97 + (t8 ? (t8 ? t99 * t99 : TB_C(0.0)) : TB_C(0.0));
    const bool t101 = TB_C(2.0) < t1 + t3 + t5 + t7 + t9 && t35 * t35 < t100;
    const real_t t102 = t76 + t100 * push[0];
    const bool t103 = t102 < TB_C(5.0);
    real_t t104;
    if (t101) {
        const real_t t105 = tb_max(t103 ? -t102 : t102 - TB_TENSION_MAX, TB_C(0.0));
        t104 = t105 * (TB_C(1.0) / t100);
    } else {
        t104 = TB_C(1e+30);
    }
    const real_t t106 = t103 ? TB_C(1.0) : -TB_C(1.0);
    const real_t t107 = side[0] * (t87 * t106);
    real_t t108;
    if (t35 < t107) {
        const real_t t109 = t60 - t87 * push[0] - (t38 ? TB_TENSION_MAX : TB_C(0.0));
        t108 = tb_max(side[0] * t109, TB_C(0.0)) / t107;
    } else {
        t108 = TB_C(1e+30);
    }
    const real_t t110 = side[1] * (t89 * t106);
    real_t t111;
    if (t35 < t110) {
        const real_t t112 = t62 - t89 * push[0] - (t39 ? TB_TENSION_MAX : TB_C(0.0));
        t111 = tb_max(side[1] * t112, TB_C(0.0)) / t110;
    } else {
        t111 = TB_C(1e+30);
    }
    const real_t t113 = side[2] * (t92 * t106);
    real_t t114;
    if (t35 < t113) {
        const real_t t115 = t64 - t92 * push[0] - (t41 ? TB_TENSION_MAX : TB_C(0.0));
        t114 = tb_max(side[2] * t115, TB_C(0.0)) / t113;
    } else {
        t114 = TB_C(1e+30);
    }
    const real_t t116 = side[3] * (t95 * t106);
    real_t t117;
    if (t35 < t116) {
        const real_t t118 = t56 - t95 * push[0] - (t43 ? TB_TENSION_MAX : TB_C(0.0));
        t117 = tb_max(side[3] * t118, TB_C(0.0)) / t116;
    } else {
        t117 = TB_C(1e+30);
    }
    const real_t t119 = side[4] * (t98 * t106);
    real_t t120;
    if (t35 < t119) {
        const real_t t121 = t58 - t98 * push[0] - (t45 ? TB_TENSION_MAX : TB_C(0.0));
        t120 = tb_max(side[4] * t121, TB_C(0.0)) / t119;
    } else {
        t120 = TB_C(1e+30);
    }
    const real_t t122 = tb_min(tb_min(tb_min(tb_min(t108, t111), t114), t117), t120);
    const bool t123 = t104 <= t122;
    const real_t t124 = tb_max(tb_max(tb_max(tb_max(t61, t63), t65), t57), t59);
    const bool t125 = (!t36 && t124 <= t34 * (TB_EPSILON * TB_C(80.0))) || !(tb_min(t104, t122)
        < TB_C(1e+30));
    const real_t t126 = t123 && !t125 ? t73 : -TB_C(1.0);
    const real_t t127 = -t106;
    real_t t128;
    if (t123 || t125) {
        t128 = -TB_C(1.0);
    } else {
        const real_t t129 = -t117;
        const real_t t130 = -t120;
        const real_t t131 = -t108;
        const real_t t132 = -t111;
        const real_t t133 = tb_max(t131, t132);
        const real_t t134 = -t114;
        real_t t135;
        if (tb_max(t129, t130) <= tb_max(t133, t134)) {
            const real_t t136 = t134 <= t133 ? (t132 <= t131 ? TB_C(0.0) : TB_C(1.0)) :
                TB_C(2.0);
            t135 = t136;
        } else {
            t135 = t130 <= t129 ? TB_C(3.0) : TB_C(4.0);
        }
        t128 = t135;
    }
    const real_t side_0 = TB_C(0.0) == t126 ? t127 : (TB_C(0.0) == t128 ? TB_C(0.0) : side[0]);
    const real_t side_1 = TB_C(1.0) == t126 ? t127 : (TB_C(1.0) == t128 ? TB_C(0.0) : side[1]);
    const real_t side_2 = TB_C(2.0) == t126 ? t127 : (TB_C(2.0) == t128 ? TB_C(0.0) : side[2]);
    const real_t side_3 = TB_C(3.0) == t126 ? t127 : (TB_C(3.0) == t128 ? TB_C(0.0) : side[3]);
    const real_t side_4 = TB_C(4.0) == t126 ? t127 : (TB_C(4.0) == t128 ? TB_C(0.0) : side[4]);
    const real_t moving_0 = t123 ? -TB_C(1.0) : t73;
    const real_t push_0 = t123 ? TB_C(0.0) : push[0] + t106 * t122;
    const real_t done_0 = t125 ? TB_C(1.0) : TB_C(0.0);
    side[0] = side_0;
    side[1] = side_1;
    side[2] = side_2;
    side[3] = side_3;
    side[4] = side_4;
    moving[0] = moving_0;
    push[0] = push_0;
    done[0] = done_0;
    return TB_OK;
}

/* The tensions, refined and judged. */
static tb_status tb_least_norm_tension_finish(const real_t structure[10], const real_t wrench[2],
    const real_t pivot[1], const real_t side[5], real_t tension[5], real_t delivered[2],
    real_t kkt_residual[1])
{
    const bool t0 = side[0] == TB_C(0.0);
    const bool t1 = TB_C(0.0) < side[0];
    const bool t2 = TB_C(0.0) < side[1];
    const real_t t3 = (t1 ? structure[0] * TB_TENSION_MAX : TB_C(0.0)) + (t2 ? TB_TENSION_MAX *
        structure[1] : TB_C(0.0));
    const bool t4 = TB_C(0.0) < side[2];
    const real_t t5 = t3 + (t4 ? TB_TENSION_MAX * structure[2] : TB_C(0.0));
    const bool t6 = TB_C(0.0) < side[3];
    const real_t t7 = t5 + (t6 ? TB_TENSION_MAX * structure[3] : TB_C(0.0));
    const bool t8 = TB_C(0.0) < side[4];
    const real_t t9 = t7 + (t8 ? TB_TENSION_MAX * structure[4] : TB_C(0.0));
    const real_t t10 = wrench[0] - t9;
    const real_t t11 = t0 ? (t0 ? structure[0] * structure[0] : TB_C(0.0)) : TB_C(0.0);
    const bool t12 = TB_C(0.0) == side[1];
    const real_t t13 = t12 ? (t12 ? structure[1] * structure[1] : TB_C(0.0)) : TB_C(0.0);
    const bool t14 = TB_C(0.0) == side[2];
    const real_t t15 = t14 ? (t14 ? structure[2] * structure[2] : TB_C(0.0)) : TB_C(0.0);
    const bool t16 = TB_C(0.0) == side[3];
    const real_t t17 = t16 ? (t16 ? structure[3] * structure[3] : TB_C(0.0)) : TB_C(0.0);
    const bool t18 = TB_C(0.0) == side[4];
    const real_t t19 = t18 ? (t18 ? structure[4] * structure[4] : TB_C(0.0)) : TB_C(0.0);
    const real_t t20 = TB_SQRT(t11 + t13 + t15 + t17 + t19);
    const real_t t21 = t0 ? structure[0] : TB_C(0.0);
    const real_t t22 = TB_COPYSIGN(t20, t21);
    const real_t t23 = TB_C(1.0) / t22;
    const real_t t24 = t10 * t23;
    const real_t t25 = t21 + t22;
    const real_t t26 = t12 ? (t12 ? structure[1] * structure[6] : TB_C(0.0)) : TB_C(0.0);
    const real_t t27 = t14 ? (t14 ? structure[2] * structure[7] : TB_C(0.0)) : TB_C(0.0);
    const real_t t28 = (t0 ? structure[5] * t25 : TB_C(0.0)) + t26 + t27;
    const real_t t29 = t16 ? (t16 ? structure[3] * structure[8] : TB_C(0.0)) : TB_C(0.0);
    const real_t t30 = t18 ? (t18 ? structure[4] * structure[9] : TB_C(0.0)) : TB_C(0.0);
    const real_t t31 = (t28 + t29 + t30) * (TB_C(1.0) / (t20 * (t20 + TB_ABS(t21))));
    const real_t t32 = (t0 ? structure[5] : TB_C(0.0)) - t25 * t31;
    const real_t t33 = (t1 ? TB_TENSION_MAX * structure[5] : TB_C(0.0)) + (t2 ? TB_TENSION_MAX
        * structure[6] : TB_C(0.0));
    const real_t t34 = t33 + (t4 ? TB_TENSION_MAX * structure[7] : TB_C(0.0));
    const real_t t35 = t34 + (t6 ? TB_TENSION_MAX * structure[8] : TB_C(0.0));
    const real_t t36 = t35 + (t8 ? TB_TENSION_MAX * structure[9] : TB_C(0.0));
    const real_t t37 = wrench[1] - t36;
    const real_t t38 = structure[6] - structure[1] * t31;
    const real_t t39 = structure[7] - structure[2] * t31;
    const real_t t40 = (t12 ? (t12 ? t38 * t38 : TB_C(0.0)) : TB_C(0.0)) + (t14 ? (t14 ? t39 *
        t39 : TB_C(0.0)) : TB_C(0.0));
    const real_t t41 = structure[8] - structure[3] * t31;
    const real_t t42 = t40 + (t16 ? (t16 ? t41 * t41 : TB_C(0.0)) : TB_C(0.0));
    const real_t t43 = structure[9] - structure[4] * t31;
    const real_t t44 = t42 + (t18 ? (t18 ? t43 * t43 : TB_C(0.0)) : TB_C(0.0));
    const real_t t45 = TB_COPYSIGN(TB_SQRT(t44), t12 ? t38 : TB_C(0.0));
    const real_t t46 = TB_C(1.0) / t45;
    const real_t t47 = t46 * ((t37 + t24 * t32) * t46);
    const real_t t48 = t23 * (t24 + t32 * t47);
    const real_t t49 = structure[0] * t48 + structure[5] * t47;
    const real_t t50 = structure[1] * t48 + structure[6] * t47;
    const real_t t51 = (t0 ? structure[0] * t49 : TB_C(0.0)) + (t12 ? structure[1] * t50 :
        TB_C(0.0));
    const real_t t52 = structure[2] * t48 + structure[7] * t47;
    const real_t t53 = structure[3] * t48 + structure[8] * t47;
    const real_t t54 = t51 + (t14 ? structure[2] * t52 : TB_C(0.0)) + (t16 ? structure[3] * t53
        : TB_C(0.0));
    const real_t t55 = structure[4] * t48 + structure[9] * t47;
    const real_t t56 = t10 - (t54 + (t18 ? structure[4] * t55 : TB_C(0.0)));
    const real_t t57 = t23 * t56;
    const real_t t58 = (t0 ? structure[5] * t49 : TB_C(0.0)) + (t12 ? structure[6] * t50 :
        TB_C(0.0));
    const real_t t59 = t58 + (t14 ? structure[7] * t52 : TB_C(0.0)) + (t16 ? structure[8] * t53
        : TB_C(0.0));
    const real_t t60 = t37 - (t59 + (t18 ? structure[9] * t55 : TB_C(0.0)));
    const real_t t61 = t46 * (t46 * (t60 + t32 * t57));
    const real_t t62 = t23 * (t57 + t32 * t61);
    const real_t t63 = t49 + (structure[0] * t62 + structure[5] * t61);
    const real_t t64 = t1 ? TB_TENSION_MAX : TB_C(0.0);
    const real_t tension_0 = tb_min(tb_max(t0 ? t63 : t64, TB_C(0.0)), TB_TENSION_MAX);
    const real_t t65 = t50 + (structure[1] * t62 + structure[6] * t61);
    const real_t t66 = t2 ? TB_TENSION_MAX : TB_C(0.0);
    const real_t tension_1 = tb_min(tb_max(t12 ? t65 : t66, TB_C(0.0)), TB_TENSION_MAX);
    const real_t t67 = t52 + (structure[2] * t62 + structure[7] * t61);
    const real_t t68 = t4 ? TB_TENSION_MAX : TB_C(0.0);
    const real_t tension_2 = tb_min(tb_max(t14 ? t67 : t68, TB_C(0.0)), TB_TENSION_MAX);
    const real_t t69 = t53 + (structure[3] * t62 + structure[8] * t61);
    const real_t t70 = t6 ? TB_TENSION_MAX : TB_C(0.0);
    const real_t tension_3 = tb_min(tb_max(t16 ? t69 : t70, TB_C(0.0)), TB_TENSION_MAX);
    const real_t t71 = t55 + (structure[4] * t62 + structure[9] * t61);
    const real_t t72 = t8 ? TB_TENSION_MAX : TB_C(0.0);
    const real_t tension_4 = tb_min(tb_max(t18 ? t71 : t72, TB_C(0.0)), TB_TENSION_MAX);
    const real_t t73 = structure[0] * tension_0 + structure[1] * tension_1;
    const real_t t74 = t73 + structure[2] * tension_2 + structure[3] * tension_3;
    const real_t delivered_0 = t74 + structure[4] * tension_4;
    const real_t t75 = structure[5] * tension_0 + structure[6] * tension_1;
    const real_t t76 = t75 + structure[7] * tension_2 + structure[8] * tension_3;
    const real_t delivered_1 = t76 + structure[9] * tension_4;
    const real_t t77 = tb_max(side[0] * (t64 - t63), side[1] * (t66 - t65));
    const real_t t78 = tb_max(tb_max(t77, side[2] * (t68 - t67)), side[3] * (t70 - t69));
    const real_t t79 = tb_max(TB_C(0.0), tb_max(t78, side[4] * (t72 - t71)));
    const real_t t80 = tb_min(TB_C(1.0), tb_min(TB_ABS(t22), TB_ABS(t45)));
    const real_t t81 = tb_max(TB_TENSION_MAX, tb_max(TB_ABS(t48), TB_ABS(t47)));
    const real_t t82 = tb_max(TB_TENSION_MAX * (t79 * t80) * (TB_C(1.0) / t81),
        TB_ABS(delivered_0 - wrench[0]));
    const real_t kkt_residual_0 = tb_max(t82, TB_ABS(delivered_1 - wrench[1]));
    const real_t t83 = TB_C(1600.0) * TB_EPSILON / tb_min(TB_C(1.0), pivot[0]);
    const bool t84 = !(kkt_residual_0 <= tb_min(t83, TB_C(0.01)));
    if (t84) {
        tension[0] = TB_C(0.0);
        tension[1] = TB_C(0.0);
        tension[2] = TB_C(0.0);
        tension[3] = TB_C(0.0);
        tension[4] = TB_C(0.0);
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return TB_INACCURATE;
    }
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    tension[4] = tension_4;
    delivered[0] = delivered_0;
    delivered[1] = delivered_1;
    kkt_residual[0] = kkt_residual_0;
    return TB_OK;
}

tb_status tb_least_norm_tension(const real_t structure[10], const real_t wrench[2],
    real_t tension[5], real_t delivered[2], real_t kkt_residual[1])
{
    real_t pivot[1];
    real_t side[5];
    real_t moving[1];
    real_t push[1];
    real_t done[1] = {TB_C(0.0)};
    tb_status status = tb_least_norm_tension_begin(structure, wrench, pivot, side, moving,
        push);
    for (int steps = 0; steps < 25 && status == TB_OK && !(done[0] > TB_C(0.0)); steps++) {
        status = tb_least_norm_tension_step(structure, wrench, side, moving, push, done);
    }
    if (status == TB_OK && !(done[0] > TB_C(0.0))) {
        status = TB_INACCURATE;
    }
    if (status != TB_OK) {
        tension[0] = TB_C(0.0);
        tension[1] = TB_C(0.0);
        tension[2] = TB_C(0.0);
        tension[3] = TB_C(0.0);
        tension[4] = TB_C(0.0);
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return status;
    }
    return tb_least_norm_tension_finish(structure, wrench, pivot, side, tension, delivered,
        kkt_residual);
}

/* Refuses with a status: pivot is 0; side is 0; moving is 0; push is 0 N. */
static tb_status tb_refuse_distribute_tension_paper_begin(tb_status status, real_t pivot[1],
    real_t side[5], real_t moving[1], real_t push[1])
{
    pivot[0] = TB_C(0.0);
    side[0] = TB_C(0.0);
    side[1] = TB_C(0.0);
    side[2] = TB_C(0.0);
    side[3] = TB_C(0.0);
    side[4] = TB_C(0.0);
    moving[0] = TB_C(0.0);
    push[0] = TB_C(0.0);
    return status;
}

/* All cables are free. */
static tb_status tb_distribute_tension_paper_begin(const real_t structure[10], const real_t wrench[2],
    real_t pivot[1], real_t side[5], real_t moving[1], real_t push[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) <= TB_C(40.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(100000.0))) {
        return tb_refuse_distribute_tension_paper_begin(TB_OUT_OF_DOMAIN, pivot, side, moving, push);
    }
    const real_t t0 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t1 = t0 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t2 = TB_SQRT(t1 + structure[4] * structure[4]);
    const real_t t3 = TB_COPYSIGN(t2, structure[0]);
    const real_t t4 = TB_ABS(t3);
    const real_t t5 = (structure[0] + t3) * structure[5] + structure[1] * structure[6];
    const real_t t6 = t5 + structure[2] * structure[7] + structure[3] * structure[8];
    const real_t t7 = (t6 + structure[4] * structure[9]) * (TB_C(1.0) / (t2 * (t2 +
        TB_ABS(structure[0]))));
    const real_t t8 = structure[6] - structure[1] * t7;
    const real_t t9 = structure[7] - structure[2] * t7;
    const real_t t10 = structure[8] - structure[3] * t7;
    const real_t t11 = structure[9] - structure[4] * t7;
    const real_t t12 = TB_SQRT(t8 * t8 + t9 * t9 + t10 * t10 + t11 * t11);
    const real_t t13 = TB_ABS(TB_COPYSIGN(t12, t8));
    const real_t pivot_0 = tb_min(t4, t13);
    const real_t t14 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const bool t15 = !(t14 < t4 && t14 < t13);
    if (t15) {
        return tb_refuse_distribute_tension_paper_begin(TB_SINGULAR, pivot, side, moving, push);
    }
    pivot[0] = pivot_0;
    side[0] = TB_C(0.0);
    side[1] = TB_C(0.0);
    side[2] = TB_C(0.0);
    side[3] = TB_C(0.0);
    side[4] = TB_C(0.0);
    moving[0] = -TB_C(1.0);
    push[0] = TB_C(0.0);
    return TB_OK;
}

/* Moves a cable towards its bounds, until it is held or another one is freed. */
static tb_status tb_distribute_tension_paper_step(const real_t structure[10], const real_t wrench[2],
    real_t side[5], real_t moving[1], real_t push[1], real_t done[1])
{
    const bool t0 = side[0] == TB_C(0.0);
    const real_t t1 = t0 ? TB_C(1.0) : TB_C(0.0);
    const bool t2 = TB_C(0.0) == side[1];
    const real_t t3 = t2 ? TB_C(1.0) : TB_C(0.0);
    const bool t4 = TB_C(0.0) == side[2];
    const real_t t5 = t4 ? TB_C(1.0) : TB_C(0.0);
    const bool t6 = TB_C(0.0) == side[3];
    const real_t t7 = t6 ? TB_C(1.0) : TB_C(0.0);
    const bool t8 = TB_C(0.0) == side[4];
    const real_t t9 = t8 ? TB_C(1.0) : TB_C(0.0);
    const real_t t10 = t0 ? (t0 ? structure[0] * structure[0] : TB_C(0.0)) : TB_C(0.0);
    const real_t t11 = t2 ? (t2 ? structure[1] * structure[1] : TB_C(0.0)) : TB_C(0.0);
    const real_t t12 = t4 ? (t4 ? structure[2] * structure[2] : TB_C(0.0)) : TB_C(0.0);
    const real_t t13 = t6 ? (t6 ? structure[3] * structure[3] : TB_C(0.0)) : TB_C(0.0);
    const real_t t14 = t8 ? (t8 ? structure[4] * structure[4] : TB_C(0.0)) : TB_C(0.0);
    const real_t t15 = TB_SQRT(t10 + t11 + t12 + t13 + t14);
    const real_t t16 = t0 ? structure[0] : TB_C(0.0);
    const real_t t17 = TB_COPYSIGN(t15, t16);
    const real_t t18 = t16 + t17;
    const real_t t19 = t2 ? (t2 ? structure[1] * structure[6] : TB_C(0.0)) : TB_C(0.0);
    const real_t t20 = t4 ? (t4 ? structure[2] * structure[7] : TB_C(0.0)) : TB_C(0.0);
    const real_t t21 = (t0 ? t18 * structure[5] : TB_C(0.0)) + t19 + t20;
    const real_t t22 = t6 ? (t6 ? structure[3] * structure[8] : TB_C(0.0)) : TB_C(0.0);
    const real_t t23 = t8 ? (t8 ? structure[4] * structure[9] : TB_C(0.0)) : TB_C(0.0);
    const real_t t24 = (t21 + t22 + t23) * (TB_C(1.0) / (t15 * (t15 + TB_ABS(t16))));
    const real_t t25 = structure[6] - structure[1] * t24;
    const real_t t26 = structure[7] - structure[2] * t24;
    const real_t t27 = (t2 ? (t2 ? t25 * t25 : TB_C(0.0)) : TB_C(0.0)) + (t4 ? (t4 ? t26 * t26
        : TB_C(0.0)) : TB_C(0.0));
    const real_t t28 = structure[8] - structure[3] * t24;
    const real_t t29 = t27 + (t6 ? (t6 ? t28 * t28 : TB_C(0.0)) : TB_C(0.0));
    const real_t t30 = structure[9] - structure[4] * t24;
    const real_t t31 = t29 + (t8 ? (t8 ? t30 * t30 : TB_C(0.0)) : TB_C(0.0));
    const real_t t32 = TB_COPYSIGN(TB_SQRT(t31), t2 ? t25 : TB_C(0.0));
    const real_t t33 = tb_min(TB_C(1.0), tb_min(TB_ABS(t17), TB_ABS(t32)));
    const real_t t34 = TB_C(1.0) / t33;
    const real_t t35 = TB_C(64.0) * TB_EPSILON * t34;
    const bool t36 = TB_C(0.0) <= moving[0];
    const real_t t37 = TB_C(1.0) / t17;
    const bool t38 = TB_C(0.0) < side[0];
    const real_t t39 = t38 ? structure[0] * TB_C(1000000000000.0) : TB_C(0.0);
    const bool t40 = TB_C(0.0) < side[1];
    const real_t t41 = t40 ? structure[1] * TB_C(1000000000000.0) : TB_C(0.0);
    const bool t42 = TB_C(0.0) < side[2];
    const real_t t43 = t42 ? structure[2] * TB_C(1000000000000.0) : TB_C(0.0);
    const bool t44 = TB_C(0.0) < side[3];
    const real_t t45 = t44 ? structure[3] * TB_C(1000000000000.0) : TB_C(0.0);
    const bool t46 = TB_C(0.0) < side[4];
    const real_t t47 = t46 ? structure[4] * TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t48 = (wrench[0] - (t39 + t41 + t43 + t45 + t47)) * t37;
    const real_t t49 = (t0 ? structure[5] : TB_C(0.0)) - t18 * t24;
    const real_t t50 = TB_C(1.0) / t32;
    const real_t t51 = t38 ? structure[5] * TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t52 = t40 ? structure[6] * TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t53 = t42 ? structure[7] * TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t54 = t44 ? structure[8] * TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t55 = t46 ? structure[9] * TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t56 = wrench[1] - (t51 + t52 + t53 + t54 + t55) + t48 * t49;
    const real_t t57 = t50 * (t56 * t50);
    const real_t t58 = t37 * (t48 + t49 * t57);
    const real_t t59 = structure[3] * t58 + structure[8] * t57;
    const real_t t60 = TB_C(0.0) < t7 ? tb_max(-t59, t59 - TB_C(1000000000000.0)) : -TB_C(1.0);
    const real_t t61 = structure[4] * t58 + structure[9] * t57;
    const real_t t62 = TB_C(0.0) < t9 ? tb_max(-t61, t61 - TB_C(1000000000000.0)) : -TB_C(1.0);
    const real_t t63 = structure[0] * t58 + structure[5] * t57;
    const real_t t64 = TB_C(0.0) < t1 ? tb_max(-t63, t63 - TB_C(1000000000000.0)) : -TB_C(1.0);
    const real_t t65 = structure[1] * t58 + structure[6] * t57;
    const real_t t66 = TB_C(0.0) < t3 ? tb_max(-t65, t65 - TB_C(1000000000000.0)) : -TB_C(1.0);
    const real_t t67 = structure[2] * t58 + structure[7] * t57;
    const real_t t68 = TB_C(0.0) < t5 ? tb_max(-t67, t67 - TB_C(1000000000000.0)) : -TB_C(1.0);
    real_t t69, t70, t71, t72, t73;
    if (t36) {
        t69 = moving[0] == TB_C(3.0) ? TB_C(1.0) : TB_C(0.0);
        t70 = moving[0] == TB_C(4.0) ? TB_C(1.0) : TB_C(0.0);
        t71 = TB_C(0.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
        t72 = TB_C(1.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
        t73 = TB_C(2.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
    } else {
        t69 = t60;
        t70 = t62;
        t71 = t64;
        t72 = t66;
        t73 = t68;
    }
    const real_t t74 = tb_max(t71, t72);
    const bool t75 = tb_max(t69, t70) <= tb_max(t74, t73);
    real_t t76, t77, t78, t79;
    if (t75) {
        const bool t80 = t73 <= t74;
        real_t t81, t82, t83, t84;
        if (t80) {
            const bool t85 = t72 <= t71;
            t81 = t85 ? TB_C(0.0) : TB_C(1.0);
            t82 = t85 ? structure[0] : structure[1];
            t83 = t85 ? structure[5] : structure[6];
            t84 = t85 ? t63 : t65;
        } else {
            t81 = TB_C(2.0);
            t82 = structure[2];
            t83 = structure[7];
            t84 = t67;
        }
        t76 = t81;
        t77 = t82;
        t78 = t83;
        t79 = t84;
    } else {
        const bool t86 = t70 <= t69;
        t76 = t86 ? TB_C(3.0) : TB_C(4.0);
        t77 = t86 ? structure[3] : structure[4];
        t78 = t86 ? structure[8] : structure[9];
        t79 = t86 ? t59 : t61;
    }
    const real_t t87 = t37 * t77;
    const real_t t88 = t50 * (t50 * (t78 + t49 * t87));
    const real_t t89 = t37 * (t87 + t49 * t88);
    const real_t t90 = structure[0] * t89 + structure[5] * t88;
    const real_t t91 = (TB_C(0.0) == t76 ? TB_C(1.0) : TB_C(0.0)) - t90;
    const real_t t92 = structure[1] * t89 + structure[6] * t88;
    const real_t t93 = (TB_C(1.0) == t76 ? TB_C(1.0) : TB_C(0.0)) - t92;
    const real_t t94 = (t0 ? (t0 ? t91 * t91 : TB_C(0.0)) : TB_C(0.0)) + (t2 ? (t2 ? t93 * t93
        : TB_C(0.0)) : TB_C(0.0));
    const real_t t95 = structure[2] * t89 + structure[7] * t88;
    const real_t t96 = (TB_C(2.0) == t76 ? TB_C(1.0) : TB_C(0.0)) - t95;
    const real_t t97 = t94 + (t4 ? (t4 ? t96 * t96 : TB_C(0.0)) : TB_C(0.0));
    const real_t t98 = structure[3] * t89 + structure[8] * t88;
    const real_t t99 = (TB_C(3.0) == t76 ? TB_C(1.0) : TB_C(0.0)) - t98;
    const real_t t100 = t97 + (t6 ? (t6 ? t99 * t99 : TB_C(0.0)) : TB_C(0.0));
    const real_t t101 = structure[4] * t89 + structure[9] * t88;
    const real_t t102 = (TB_C(4.0) == t76 ? TB_C(1.0) : TB_C(0.0)) - t101;
    const real_t t103 = t100 + (t8 ? (t8 ? t102 * t102 : TB_C(0.0)) : TB_C(0.0));
    const bool t104 = TB_C(2.0) < t1 + t3 + t5 + t7 + t9 && t35 * t35 < t103;
    const real_t t105 = t79 + t103 * push[0];
    const bool t106 = t105 < TB_C(500000000000.0);
    real_t t107;
    if (t104) {
        const real_t t108 = tb_max(t106 ? -t105 : t105 - TB_C(1000000000000.0), TB_C(0.0));
        t107 = t108 * (TB_C(1.0) / t103);
    } else {
        t107 = TB_C(1e+30);
    }
    const real_t t109 = t106 ? TB_C(1.0) : -TB_C(1.0);
    const real_t t110 = side[0] * (t90 * t109);
    real_t t111;
    if (t35 < t110) {
        const real_t t112 = t63 - t90 * push[0] - (t38 ? TB_C(1000000000000.0) : TB_C(0.0));
        t111 = tb_max(side[0] * t112, TB_C(0.0)) / t110;
    } else {
        t111 = TB_C(1e+30);
    }
    const real_t t113 = side[1] * (t92 * t109);
    real_t t114;
    if (t35 < t113) {
        const real_t t115 = t65 - t92 * push[0] - (t40 ? TB_C(1000000000000.0) : TB_C(0.0));
        t114 = tb_max(side[1] * t115, TB_C(0.0)) / t113;
    } else {
        t114 = TB_C(1e+30);
    }
    const real_t t116 = side[2] * (t95 * t109);
    real_t t117;
    if (t35 < t116) {
        const real_t t118 = t67 - t95 * push[0] - (t42 ? TB_C(1000000000000.0) : TB_C(0.0));
        t117 = tb_max(side[2] * t118, TB_C(0.0)) / t116;
    } else {
        t117 = TB_C(1e+30);
    }
    const real_t t119 = side[3] * (t98 * t109);
    real_t t120;
    if (t35 < t119) {
        const real_t t121 = t59 - t98 * push[0] - (t44 ? TB_C(1000000000000.0) : TB_C(0.0));
        t120 = tb_max(side[3] * t121, TB_C(0.0)) / t119;
    } else {
        t120 = TB_C(1e+30);
    }
    const real_t t122 = side[4] * (t101 * t109);
    real_t t123;
    if (t35 < t122) {
        const real_t t124 = t61 - t101 * push[0] - (t46 ? TB_C(1000000000000.0) : TB_C(0.0));
        t123 = tb_max(side[4] * t124, TB_C(0.0)) / t122;
    } else {
        t123 = TB_C(1e+30);
    }
    const real_t t125 = tb_min(tb_min(tb_min(tb_min(t111, t114), t117), t120), t123);
    const bool t126 = t107 <= t125;
    const real_t t127 = tb_max(tb_max(tb_max(tb_max(t64, t66), t68), t60), t62);
    const real_t t128 = TB_EPSILON * TB_C(8.0) * (TB_ABS(wrench[0]) + TB_ABS(wrench[1]));
    const bool t129 = (!t36 && t127 <= t34 * t128) || !(tb_min(t107, t125) < TB_C(1e+30));
    const real_t t130 = t126 && !t129 ? t76 : -TB_C(1.0);
    const real_t t131 = -t109;
    real_t t132;
    if (t126 || t129) {
        t132 = -TB_C(1.0);
    } else {
        const real_t t133 = -t120;
        const real_t t134 = -t123;
        const real_t t135 = -t111;
        const real_t t136 = -t114;
        const real_t t137 = tb_max(t135, t136);
        const real_t t138 = -t117;
        real_t t139;
        if (tb_max(t133, t134) <= tb_max(t137, t138)) {
            const real_t t140 = t138 <= t137 ? (t136 <= t135 ? TB_C(0.0) : TB_C(1.0)) :
                TB_C(2.0);
            t139 = t140;
        } else {
            t139 = t134 <= t133 ? TB_C(3.0) : TB_C(4.0);
        }
        t132 = t139;
    }
    const real_t side_0 = TB_C(0.0) == t130 ? t131 : (TB_C(0.0) == t132 ? TB_C(0.0) : side[0]);
    const real_t side_1 = TB_C(1.0) == t130 ? t131 : (TB_C(1.0) == t132 ? TB_C(0.0) : side[1]);
    const real_t side_2 = TB_C(2.0) == t130 ? t131 : (TB_C(2.0) == t132 ? TB_C(0.0) : side[2]);
    const real_t side_3 = TB_C(3.0) == t130 ? t131 : (TB_C(3.0) == t132 ? TB_C(0.0) : side[3]);
    const real_t side_4 = TB_C(4.0) == t130 ? t131 : (TB_C(4.0) == t132 ? TB_C(0.0) : side[4]);
    const real_t moving_0 = t126 ? -TB_C(1.0) : t76;
    const real_t push_0 = t126 ? TB_C(0.0) : push[0] + t109 * t125;
    const real_t done_0 = t129 ? TB_C(1.0) : TB_C(0.0);
    side[0] = side_0;
    side[1] = side_1;
    side[2] = side_2;
    side[3] = side_3;
    side[4] = side_4;
    moving[0] = moving_0;
    push[0] = push_0;
    done[0] = done_0;
    return TB_OK;
}

/* The tensions, refined and judged. */
static tb_status tb_distribute_tension_paper_finish(const real_t structure[10], const real_t wrench[2],
    const real_t pivot[1], const real_t side[5], real_t tension[5], real_t delivered[2],
    real_t kkt_residual[1])
{
    const bool t0 = TB_C(0.0) < side[0];
    const real_t t1 = t0 ? TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t2 = t0 ? TB_C(1000000000000.0) * structure[0] : TB_C(0.0);
    const bool t3 = TB_C(0.0) < side[1];
    const real_t t4 = t3 ? TB_C(1000000000000.0) * structure[1] : TB_C(0.0);
    const bool t5 = TB_C(0.0) < side[2];
    const real_t t6 = t5 ? TB_C(1000000000000.0) * structure[2] : TB_C(0.0);
    const bool t7 = TB_C(0.0) < side[3];
    const real_t t8 = t7 ? TB_C(1000000000000.0) * structure[3] : TB_C(0.0);
    const bool t9 = TB_C(0.0) < side[4];
    const real_t t10 = t9 ? TB_C(1000000000000.0) * structure[4] : TB_C(0.0);
    const real_t t11 = wrench[0] - (t2 + t4 + t6 + t8 + t10);
    const bool t12 = TB_C(0.0) == side[0];
    const real_t t13 = t12 ? (t12 ? structure[0] * structure[0] : TB_C(0.0)) : TB_C(0.0);
    const bool t14 = TB_C(0.0) == side[1];
    const real_t t15 = t14 ? (t14 ? structure[1] * structure[1] : TB_C(0.0)) : TB_C(0.0);
    const bool t16 = TB_C(0.0) == side[2];
    const real_t t17 = t16 ? (t16 ? structure[2] * structure[2] : TB_C(0.0)) : TB_C(0.0);
    const bool t18 = TB_C(0.0) == side[3];
    const real_t t19 = t18 ? (t18 ? structure[3] * structure[3] : TB_C(0.0)) : TB_C(0.0);
    const bool t20 = TB_C(0.0) == side[4];
    const real_t t21 = t20 ? (t20 ? structure[4] * structure[4] : TB_C(0.0)) : TB_C(0.0);
    const real_t t22 = TB_SQRT(t13 + t15 + t17 + t19 + t21);
    const real_t t23 = t12 ? structure[0] : TB_C(0.0);
    const real_t t24 = TB_COPYSIGN(t22, t23);
    const real_t t25 = TB_C(1.0) / t24;
    const real_t t26 = t11 * t25;
    const real_t t27 = t23 + t24;
    const real_t t28 = t14 ? (t14 ? structure[1] * structure[6] : TB_C(0.0)) : TB_C(0.0);
    const real_t t29 = t16 ? (t16 ? structure[2] * structure[7] : TB_C(0.0)) : TB_C(0.0);
    const real_t t30 = (t12 ? structure[5] * t27 : TB_C(0.0)) + t28 + t29;
    const real_t t31 = t18 ? (t18 ? structure[3] * structure[8] : TB_C(0.0)) : TB_C(0.0);
    const real_t t32 = t20 ? (t20 ? structure[4] * structure[9] : TB_C(0.0)) : TB_C(0.0);
    const real_t t33 = (t30 + t31 + t32) * (TB_C(1.0) / (t22 * (t22 + TB_ABS(t23))));
    const real_t t34 = (t12 ? structure[5] : TB_C(0.0)) - t27 * t33;
    const real_t t35 = t0 ? TB_C(1000000000000.0) * structure[5] : TB_C(0.0);
    const real_t t36 = t3 ? TB_C(1000000000000.0) * structure[6] : TB_C(0.0);
    const real_t t37 = t5 ? TB_C(1000000000000.0) * structure[7] : TB_C(0.0);
    const real_t t38 = t7 ? TB_C(1000000000000.0) * structure[8] : TB_C(0.0);
    const real_t t39 = t9 ? TB_C(1000000000000.0) * structure[9] : TB_C(0.0);
    const real_t t40 = wrench[1] - (t35 + t36 + t37 + t38 + t39);
    const real_t t41 = structure[6] - structure[1] * t33;
    const real_t t42 = structure[7] - structure[2] * t33;
    const real_t t43 = (t14 ? (t14 ? t41 * t41 : TB_C(0.0)) : TB_C(0.0)) + (t16 ? (t16 ? t42 *
        t42 : TB_C(0.0)) : TB_C(0.0));
    const real_t t44 = structure[8] - structure[3] * t33;
    const real_t t45 = t43 + (t18 ? (t18 ? t44 * t44 : TB_C(0.0)) : TB_C(0.0));
    const real_t t46 = structure[9] - structure[4] * t33;
    const real_t t47 = t45 + (t20 ? (t20 ? t46 * t46 : TB_C(0.0)) : TB_C(0.0));
    const real_t t48 = TB_COPYSIGN(TB_SQRT(t47), t14 ? t41 : TB_C(0.0));
    const real_t t49 = TB_C(1.0) / t48;
    const real_t t50 = t49 * ((t40 + t26 * t34) * t49);
    const real_t t51 = t25 * (t26 + t34 * t50);
    const real_t t52 = structure[0] * t51 + structure[5] * t50;
    const real_t t53 = structure[1] * t51 + structure[6] * t50;
    const real_t t54 = (t12 ? structure[0] * t52 : TB_C(0.0)) + (t14 ? structure[1] * t53 :
        TB_C(0.0));
    const real_t t55 = structure[2] * t51 + structure[7] * t50;
    const real_t t56 = structure[3] * t51 + structure[8] * t50;
    const real_t t57 = t54 + (t16 ? structure[2] * t55 : TB_C(0.0)) + (t18 ? structure[3] * t56
        : TB_C(0.0));
    const real_t t58 = structure[4] * t51 + structure[9] * t50;
    const real_t t59 = t11 - (t57 + (t20 ? structure[4] * t58 : TB_C(0.0)));
    const real_t t60 = t25 * t59;
    const real_t t61 = (t12 ? structure[5] * t52 : TB_C(0.0)) + (t14 ? structure[6] * t53 :
        TB_C(0.0));
    const real_t t62 = t61 + (t16 ? structure[7] * t55 : TB_C(0.0)) + (t18 ? structure[8] * t56
        : TB_C(0.0));
    const real_t t63 = t40 - (t62 + (t20 ? structure[9] * t58 : TB_C(0.0)));
    const real_t t64 = t49 * (t49 * (t63 + t34 * t60));
    const real_t t65 = t25 * (t60 + t34 * t64);
    const real_t t66 = t52 + (structure[0] * t65 + structure[5] * t64);
    const real_t t67 = t3 ? TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t68 = t53 + (structure[1] * t65 + structure[6] * t64);
    const real_t t69 = tb_max(side[0] * (t1 - t66), side[1] * (t67 - t68));
    const real_t t70 = t5 ? TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t71 = t55 + (structure[2] * t65 + structure[7] * t64);
    const real_t t72 = t7 ? TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t73 = t56 + (structure[3] * t65 + structure[8] * t64);
    const real_t t74 = tb_max(tb_max(t69, side[2] * (t70 - t71)), side[3] * (t72 - t73));
    const real_t t75 = t9 ? TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t76 = t58 + (structure[4] * t65 + structure[9] * t64);
    const real_t t77 = tb_max(TB_C(0.0), tb_max(t74, side[4] * (t75 - t76)));
    const real_t t78 = tb_min(TB_C(1.0), tb_min(TB_ABS(t24), TB_ABS(t48)));
    const real_t t79 = TB_ABS(wrench[0]) + TB_ABS(wrench[1]);
    const real_t t80 = TB_C(1.0) / tb_max(t79, tb_max(TB_ABS(t51), TB_ABS(t50)));
    const real_t t81 = tb_min(tb_max(t12 ? t66 : t1, TB_C(0.0)), TB_C(1000000000000.0));
    const real_t t82 = tb_min(tb_max(t14 ? t68 : t67, TB_C(0.0)), TB_C(1000000000000.0));
    const real_t t83 = tb_min(tb_max(t16 ? t71 : t70, TB_C(0.0)), TB_C(1000000000000.0));
    const real_t t84 = structure[0] * t81 + structure[1] * t82 + structure[2] * t83;
    const real_t t85 = tb_min(tb_max(t18 ? t73 : t72, TB_C(0.0)), TB_C(1000000000000.0));
    const real_t t86 = tb_min(tb_max(t20 ? t76 : t75, TB_C(0.0)), TB_C(1000000000000.0));
    const real_t t87 = t84 + structure[3] * t85 + structure[4] * t86 - wrench[0];
    const real_t t88 = structure[5] * t81 + structure[6] * t82 + structure[7] * t83;
    const real_t t89 = t88 + structure[8] * t85 + structure[9] * t86 - wrench[1];
    const real_t t90 = tb_max(tb_max(t77 * t78 * t79 * t80, TB_ABS(t87)), TB_ABS(t89));
    const real_t t91 = tb_max(tb_max(tb_max(tb_max(t81, t82), t83), t85), t86);
    const real_t t92 = TB_C(128.0) * TB_EPSILON * t91 * (TB_C(1.0) / pivot[0]);
    const bool t93 = t90 <= tb_min(t92, TB_C(0.01));
    real_t tension_0, tension_1, tension_2, tension_3, tension_4, delivered_0, delivered_1,
        kkt_residual_0;
    if (t93) {
        const real_t t94 = tb_min(t81, TB_TENSION_MAX);
        const real_t t95 = tb_min(t82, TB_TENSION_MAX);
        const real_t t96 = tb_min(t83, TB_TENSION_MAX);
        const real_t t97 = tb_min(t85, TB_TENSION_MAX);
        const real_t t98 = tb_min(t86, TB_TENSION_MAX);
        const real_t t99 = structure[0] * t94 + structure[1] * t95 + structure[2] * t96;
        const real_t t100 = structure[5] * t94 + structure[6] * t95 + structure[7] * t96;
        tension_0 = t94;
        tension_1 = t95;
        tension_2 = t96;
        tension_3 = t97;
        tension_4 = t98;
        delivered_0 = t99 + structure[3] * t97 + structure[4] * t98;
        delivered_1 = t100 + structure[8] * t97 + structure[9] * t98;
        kkt_residual_0 = t90;
    } else {
        tension_0 = TB_C(0.0);
        tension_1 = TB_C(0.0);
        tension_2 = TB_C(0.0);
        tension_3 = TB_C(0.0);
        tension_4 = TB_C(0.0);
        delivered_0 = TB_C(0.0);
        delivered_1 = TB_C(0.0);
        kkt_residual_0 = TB_C(0.0);
    }
    const bool t101 = !t93;
    const bool t102 = TB_TENSION_MAX < t81 || TB_TENSION_MAX < t82 || TB_TENSION_MAX < t83;
    const bool t103 = t102 || TB_TENSION_MAX < t85 || TB_TENSION_MAX < t86;
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    tension[4] = tension_4;
    delivered[0] = delivered_0;
    delivered[1] = delivered_1;
    kkt_residual[0] = kkt_residual_0;
    return (t101 || t103) ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_distribute_tension_paper(const real_t structure[10], const real_t wrench[2],
    real_t tension[5], real_t delivered[2], real_t kkt_residual[1])
{
    real_t pivot[1];
    real_t side[5];
    real_t moving[1];
    real_t push[1];
    real_t done[1] = {TB_C(0.0)};
    tb_status status = tb_distribute_tension_paper_begin(structure, wrench, pivot, side,
        moving, push);
    for (int steps = 0; steps < 25 && status == TB_OK && !(done[0] > TB_C(0.0)); steps++) {
        status = tb_distribute_tension_paper_step(structure, wrench, side, moving, push, done);
    }
    if (status == TB_OK && !(done[0] > TB_C(0.0))) {
        status = TB_INACCURATE;
    }
    if (status != TB_OK) {
        tension[0] = TB_C(0.0);
        tension[1] = TB_C(0.0);
        tension[2] = TB_C(0.0);
        tension[3] = TB_C(0.0);
        tension[4] = TB_C(0.0);
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return status;
    }
    return tb_distribute_tension_paper_finish(structure, wrench, pivot, side, tension,
        delivered, kkt_residual);
}

tb_status tb_distribute_tension_scale(const real_t structure[10], const real_t wrench[2],
    real_t tension[5], real_t delivered[2], real_t kkt_residual[1])
{
    tb_status status = tb_least_norm_tension(structure, wrench, tension, delivered,
        kkt_residual);
    if (status != TB_INACCURATE) {
        return status;
    }
    real_t served[2];
    real_t inner[2];
    tb_status verdict = tb_served_wrench_scale(structure, wrench, served, inner);
    if (status == TB_INACCURATE && verdict == TB_INFEASIBLE) {
        status = tb_least_norm_tension(structure, served, tension, delivered, kkt_residual);
    }
    if (status == TB_INACCURATE) {
        verdict = TB_INFEASIBLE;
        status = tb_least_norm_tension(structure, inner, tension, delivered, kkt_residual);
    }
    return status == TB_OK ? verdict : status;
}

tb_status tb_distribute_tension_closest(const real_t structure[10], const real_t wrench[2],
    real_t tension[5], real_t delivered[2], real_t kkt_residual[1])
{
    tb_status status = tb_least_norm_tension(structure, wrench, tension, delivered,
        kkt_residual);
    if (status != TB_INACCURATE) {
        return status;
    }
    real_t served[2];
    real_t inner[2];
    tb_status verdict = tb_served_wrench_closest(structure, wrench, served, inner);
    if (status == TB_INACCURATE && verdict == TB_INFEASIBLE) {
        status = tb_least_norm_tension(structure, served, tension, delivered, kkt_residual);
    }
    if (status == TB_INACCURATE) {
        verdict = TB_INFEASIBLE;
        status = tb_least_norm_tension(structure, inner, tension, delivered, kkt_residual);
    }
    return status == TB_OK ? verdict : status;
}

tb_status tb_distribute_tension(const real_t structure[10], const real_t wrench[2],
    real_t tension[5], real_t delivered[2], real_t kkt_residual[1])
{
    return tb_distribute_tension_closest(structure, wrench, tension, delivered, kkt_residual);
}

