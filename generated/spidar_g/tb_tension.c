/* Regenerate: turnbuckle generate machines/spidar_g.toml --out <this folder>
 * Machine 4d479a9b3a2bb17c, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_tension.h"
#include "tb_machine.h"

/* Refuses with a status: pivot is 0; side is 0; moving is 0; push is 0 N. */
static tb_status tb_refuse_least_norm_tension_begin(tb_status status, real_t pivot[1],
    real_t side[8], real_t moving[1], real_t push[1])
{
    pivot[0] = TB_C(0.0);
    side[0] = TB_C(0.0);
    side[1] = TB_C(0.0);
    side[2] = TB_C(0.0);
    side[3] = TB_C(0.0);
    side[4] = TB_C(0.0);
    side[5] = TB_C(0.0);
    side[6] = TB_C(0.0);
    side[7] = TB_C(0.0);
    moving[0] = TB_C(0.0);
    push[0] = TB_C(0.0);
    return status;
}

/* All cables are free. */
static tb_status tb_least_norm_tension_begin(const real_t structure[48], const real_t wrench[6],
    real_t pivot[1], real_t side[8], real_t moving[1], real_t push[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) + TB_ABS(structure[10]) + TB_ABS(structure[11]) +
              TB_ABS(structure[12]) + TB_ABS(structure[13]) + TB_ABS(structure[14]) +
              TB_ABS(structure[15]) + TB_ABS(structure[16]) + TB_ABS(structure[17]) +
              TB_ABS(structure[18]) + TB_ABS(structure[19]) + TB_ABS(structure[20]) +
              TB_ABS(structure[21]) + TB_ABS(structure[22]) + TB_ABS(structure[23]) +
              TB_ABS(structure[24]) + TB_ABS(structure[25]) + TB_ABS(structure[26]) +
              TB_ABS(structure[27]) + TB_ABS(structure[28]) + TB_ABS(structure[29]) +
              TB_ABS(structure[30]) + TB_ABS(structure[31]) + TB_ABS(structure[32]) +
              TB_ABS(structure[33]) + TB_ABS(structure[34]) + TB_ABS(structure[35]) +
              TB_ABS(structure[36]) + TB_ABS(structure[37]) + TB_ABS(structure[38]) +
              TB_ABS(structure[39]) + TB_ABS(structure[40]) + TB_ABS(structure[41]) +
              TB_ABS(structure[42]) + TB_ABS(structure[43]) + TB_ABS(structure[44]) +
              TB_ABS(structure[45]) + TB_ABS(structure[46]) + TB_ABS(structure[47]) <=
              TB_C(192.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) + TB_ABS(wrench[2]) + TB_ABS(wrench[3]) +
              TB_ABS(wrench[4]) + TB_ABS(wrench[5]) <= TB_C(384000.0))) {
        return tb_refuse_least_norm_tension_begin(TB_OUT_OF_DOMAIN, pivot, side, moving, push);
    }
    const real_t t0 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t1 = t0 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t2 = t1 + structure[4] * structure[4] + structure[5] * structure[5];
    const real_t t3 = t2 + structure[6] * structure[6] + structure[7] * structure[7];
    const real_t t4 = TB_SQRT(t3);
    const real_t t5 = TB_COPYSIGN(t4, structure[0]);
    const real_t t6 = TB_ABS(t5);
    const real_t t7 = structure[0] + t5;
    const real_t t8 = t7 * structure[8] + structure[1] * structure[9] + structure[2] *
        structure[10];
    const real_t t9 = t8 + structure[3] * structure[11] + structure[4] * structure[12];
    const real_t t10 = t9 + structure[5] * structure[13] + structure[6] * structure[14];
    const real_t t11 = TB_C(1.0) / (t4 * (t4 + TB_ABS(structure[0])));
    const real_t t12 = (t10 + structure[7] * structure[15]) * t11;
    const real_t t13 = structure[9] - structure[1] * t12;
    const real_t t14 = structure[10] - structure[2] * t12;
    const real_t t15 = structure[11] - structure[3] * t12;
    const real_t t16 = structure[12] - structure[4] * t12;
    const real_t t17 = structure[13] - structure[5] * t12;
    const real_t t18 = t13 * t13 + t14 * t14 + t15 * t15 + t16 * t16 + t17 * t17;
    const real_t t19 = structure[14] - structure[6] * t12;
    const real_t t20 = structure[15] - structure[7] * t12;
    const real_t t21 = TB_SQRT(t18 + t19 * t19 + t20 * t20);
    const real_t t22 = TB_COPYSIGN(t21, t13);
    const real_t t23 = TB_ABS(t22);
    const real_t t24 = t7 * structure[16] + structure[1] * structure[17];
    const real_t t25 = t24 + structure[2] * structure[18] + structure[3] * structure[19];
    const real_t t26 = t25 + structure[4] * structure[20] + structure[5] * structure[21];
    const real_t t27 = t26 + structure[6] * structure[22] + structure[7] * structure[23];
    const real_t t28 = t11 * t27;
    const real_t t29 = structure[18] - structure[2] * t28;
    const real_t t30 = t13 + t22;
    const real_t t31 = t30 * (structure[17] - structure[1] * t28) + t14 * t29;
    const real_t t32 = structure[19] - structure[3] * t28;
    const real_t t33 = structure[20] - structure[4] * t28;
    const real_t t34 = structure[21] - structure[5] * t28;
    const real_t t35 = structure[22] - structure[6] * t28;
    const real_t t36 = t31 + t15 * t32 + t16 * t33 + t17 * t34 + t19 * t35;
    const real_t t37 = structure[23] - structure[7] * t28;
    const real_t t38 = TB_C(1.0) / (t21 * (t21 + TB_ABS(t13)));
    const real_t t39 = (t36 + t20 * t37) * t38;
    const real_t t40 = t29 - t14 * t39;
    const real_t t41 = t32 - t15 * t39;
    const real_t t42 = t33 - t16 * t39;
    const real_t t43 = t34 - t17 * t39;
    const real_t t44 = t35 - t19 * t39;
    const real_t t45 = t40 * t40 + t41 * t41 + t42 * t42 + t43 * t43 + t44 * t44;
    const real_t t46 = t37 - t20 * t39;
    const real_t t47 = TB_SQRT(t45 + t46 * t46);
    const real_t t48 = TB_COPYSIGN(t47, t40);
    const real_t t49 = TB_ABS(t48);
    const real_t t50 = TB_MOMENT_WEIGHT * structure[27];
    const real_t t51 = TB_MOMENT_WEIGHT * structure[25];
    const real_t t52 = t7 * (TB_MOMENT_WEIGHT * structure[24]) + structure[1] * t51;
    const real_t t53 = TB_MOMENT_WEIGHT * structure[26];
    const real_t t54 = TB_MOMENT_WEIGHT * structure[28];
    const real_t t55 = t52 + structure[2] * t53 + structure[3] * t50 + structure[4] * t54;
    const real_t t56 = TB_MOMENT_WEIGHT * structure[29];
    const real_t t57 = TB_MOMENT_WEIGHT * structure[30];
    const real_t t58 = TB_MOMENT_WEIGHT * structure[31];
    const real_t t59 = t55 + structure[5] * t56 + structure[6] * t57 + structure[7] * t58;
    const real_t t60 = t11 * t59;
    const real_t t61 = t50 - structure[3] * t60;
    const real_t t62 = t53 - structure[2] * t60;
    const real_t t63 = t30 * (t51 - structure[1] * t60) + t14 * t62 + t15 * t61;
    const real_t t64 = t54 - structure[4] * t60;
    const real_t t65 = t56 - structure[5] * t60;
    const real_t t66 = t57 - structure[6] * t60;
    const real_t t67 = t58 - structure[7] * t60;
    const real_t t68 = t63 + t16 * t64 + t17 * t65 + t19 * t66 + t20 * t67;
    const real_t t69 = t38 * t68;
    const real_t t70 = t61 - t15 * t69;
    const real_t t71 = t40 + t48;
    const real_t t72 = t64 - t16 * t69;
    const real_t t73 = t65 - t17 * t69;
    const real_t t74 = t71 * (t62 - t14 * t69) + t41 * t70 + t42 * t72 + t43 * t73;
    const real_t t75 = t66 - t19 * t69;
    const real_t t76 = t67 - t20 * t69;
    const real_t t77 = TB_C(1.0) / (t47 * (t47 + TB_ABS(t40)));
    const real_t t78 = (t74 + t44 * t75 + t46 * t76) * t77;
    const real_t t79 = t70 - t41 * t78;
    const real_t t80 = t72 - t42 * t78;
    const real_t t81 = t73 - t43 * t78;
    const real_t t82 = t75 - t44 * t78;
    const real_t t83 = t76 - t46 * t78;
    const real_t t84 = t79 * t79 + t80 * t80 + t81 * t81 + t82 * t82 + t83 * t83;
    const real_t t85 = TB_SQRT(t84);
    const real_t t86 = TB_COPYSIGN(t85, t79);
    const real_t t87 = TB_ABS(t86);
    const real_t t88 = TB_MOMENT_WEIGHT * structure[36];
    const real_t t89 = TB_MOMENT_WEIGHT * structure[33];
    const real_t t90 = t7 * (TB_MOMENT_WEIGHT * structure[32]) + structure[1] * t89;
    const real_t t91 = TB_MOMENT_WEIGHT * structure[34];
    const real_t t92 = TB_MOMENT_WEIGHT * structure[35];
    const real_t t93 = t90 + structure[2] * t91 + structure[3] * t92 + structure[4] * t88;
    const real_t t94 = TB_MOMENT_WEIGHT * structure[37];
    const real_t t95 = TB_MOMENT_WEIGHT * structure[38];
    const real_t t96 = TB_MOMENT_WEIGHT * structure[39];
    const real_t t97 = t93 + structure[5] * t94 + structure[6] * t95 + structure[7] * t96;
    const real_t t98 = t11 * t97;
    const real_t t99 = t88 - structure[4] * t98;
    const real_t t100 = t91 - structure[2] * t98;
    const real_t t101 = t92 - structure[3] * t98;
    const real_t t102 = t30 * (t89 - structure[1] * t98) + t14 * t100 + t15 * t101;
    const real_t t103 = t94 - structure[5] * t98;
    const real_t t104 = t95 - structure[6] * t98;
    const real_t t105 = t96 - structure[7] * t98;
    const real_t t106 = t102 + t16 * t99 + t17 * t103 + t19 * t104 + t20 * t105;
    const real_t t107 = t38 * t106;
    const real_t t108 = t99 - t16 * t107;
    const real_t t109 = t101 - t15 * t107;
    const real_t t110 = t71 * (t100 - t14 * t107) + t41 * t109 + t42 * t108;
    const real_t t111 = t103 - t17 * t107;
    const real_t t112 = t104 - t19 * t107;
    const real_t t113 = t105 - t20 * t107;
    const real_t t114 = t77 * (t110 + t43 * t111 + t44 * t112 + t46 * t113);
    const real_t t115 = t108 - t42 * t114;
    const real_t t116 = t79 + t86;
    const real_t t117 = t111 - t43 * t114;
    const real_t t118 = t116 * (t109 - t41 * t114) + t80 * t115 + t81 * t117;
    const real_t t119 = t112 - t44 * t114;
    const real_t t120 = t113 - t46 * t114;
    const real_t t121 = TB_C(1.0) / (t85 * (t85 + TB_ABS(t79)));
    const real_t t122 = (t118 + t82 * t119 + t83 * t120) * t121;
    const real_t t123 = t115 - t80 * t122;
    const real_t t124 = t117 - t81 * t122;
    const real_t t125 = t119 - t82 * t122;
    const real_t t126 = t120 - t83 * t122;
    const real_t t127 = t123 * t123 + t124 * t124 + t125 * t125 + t126 * t126;
    const real_t t128 = TB_SQRT(t127);
    const real_t t129 = TB_COPYSIGN(t128, t123);
    const real_t t130 = TB_ABS(t129);
    const real_t t131 = tb_min(tb_min(tb_min(tb_min(t6, t23), t49), t87), t130);
    const real_t t132 = TB_MOMENT_WEIGHT * structure[45];
    const real_t t133 = TB_MOMENT_WEIGHT * structure[41];
    const real_t t134 = t7 * (TB_MOMENT_WEIGHT * structure[40]) + structure[1] * t133;
    const real_t t135 = TB_MOMENT_WEIGHT * structure[42];
    const real_t t136 = TB_MOMENT_WEIGHT * structure[43];
    const real_t t137 = TB_MOMENT_WEIGHT * structure[44];
    const real_t t138 = t134 + structure[2] * t135 + structure[3] * t136 + structure[4] * t137;
    const real_t t139 = TB_MOMENT_WEIGHT * structure[46];
    const real_t t140 = TB_MOMENT_WEIGHT * structure[47];
    const real_t t141 = t138 + structure[5] * t132 + structure[6] * t139 + structure[7] * t140;
    const real_t t142 = t11 * t141;
    const real_t t143 = t132 - structure[5] * t142;
    const real_t t144 = t135 - structure[2] * t142;
    const real_t t145 = t136 - structure[3] * t142;
    const real_t t146 = t30 * (t133 - structure[1] * t142) + t14 * t144 + t15 * t145;
    const real_t t147 = t137 - structure[4] * t142;
    const real_t t148 = t139 - structure[6] * t142;
    const real_t t149 = t140 - structure[7] * t142;
    const real_t t150 = t146 + t16 * t147 + t17 * t143 + t19 * t148 + t20 * t149;
    const real_t t151 = t38 * t150;
    const real_t t152 = t143 - t17 * t151;
    const real_t t153 = t145 - t15 * t151;
    const real_t t154 = t147 - t16 * t151;
    const real_t t155 = t71 * (t144 - t14 * t151) + t41 * t153 + t42 * t154;
    const real_t t156 = t148 - t19 * t151;
    const real_t t157 = t149 - t20 * t151;
    const real_t t158 = t77 * (t155 + t43 * t152 + t44 * t156 + t46 * t157);
    const real_t t159 = t152 - t43 * t158;
    const real_t t160 = t154 - t42 * t158;
    const real_t t161 = t116 * (t153 - t41 * t158) + t80 * t160 + t81 * t159;
    const real_t t162 = t156 - t44 * t158;
    const real_t t163 = t157 - t46 * t158;
    const real_t t164 = t121 * (t161 + t82 * t162 + t83 * t163);
    const real_t t165 = t159 - t81 * t164;
    const real_t t166 = (t123 + t129) * (t160 - t80 * t164) + t124 * t165;
    const real_t t167 = t162 - t82 * t164;
    const real_t t168 = t163 - t83 * t164;
    const real_t t169 = (t166 + t125 * t167 + t126 * t168) * (TB_C(1.0) / (t128 * (t128 +
        TB_ABS(t123))));
    const real_t t170 = t165 - t124 * t169;
    const real_t t171 = t167 - t125 * t169;
    const real_t t172 = t168 - t126 * t169;
    const real_t t173 = TB_COPYSIGN(TB_SQRT(t170 * t170 + t171 * t171 + t172 * t172), t170);
    const real_t t174 = TB_ABS(t173);
    const real_t pivot_0 = tb_min(t131, t174);
    const real_t t175 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const bool t176 = t175 < t6 && t175 < t23 && t175 < t49 && t175 < t87;
    const bool t177 = !(t176 && t175 < t130 && t175 < t174);
    if (t177) {
        return tb_refuse_least_norm_tension_begin(TB_SINGULAR, pivot, side, moving, push);
    }
    pivot[0] = pivot_0;
    side[0] = TB_C(0.0);
    side[1] = TB_C(0.0);
    side[2] = TB_C(0.0);
    side[3] = TB_C(0.0);
    side[4] = TB_C(0.0);
    side[5] = TB_C(0.0);
    side[6] = TB_C(0.0);
    side[7] = TB_C(0.0);
    moving[0] = -TB_C(1.0);
    push[0] = TB_C(0.0);
    return TB_OK;
}

/* Moves a cable towards its bounds, until it is held or another one is freed. */
static tb_status tb_least_norm_tension_step(const real_t structure[48], const real_t wrench[6],
    real_t side[8], real_t moving[1], real_t push[1], real_t done[1])
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
    const bool t10 = TB_C(0.0) == side[5];
    const real_t t11 = t10 ? TB_C(1.0) : TB_C(0.0);
    const bool t12 = TB_C(0.0) == side[6];
    const real_t t13 = t12 ? TB_C(1.0) : TB_C(0.0);
    const bool t14 = TB_C(0.0) == side[7];
    const real_t t15 = t14 ? TB_C(1.0) : TB_C(0.0);
    const bool t16 = TB_C(6.0) < t1 + t3 + t5 + t7 + t9 + t11 + t13 + t15;
    const real_t t17 = t0 ? (t0 ? structure[0] * structure[0] : TB_C(0.0)) : TB_C(0.0);
    const real_t t18 = t2 ? (t2 ? structure[1] * structure[1] : TB_C(0.0)) : TB_C(0.0);
    const real_t t19 = t4 ? (t4 ? structure[2] * structure[2] : TB_C(0.0)) : TB_C(0.0);
    const real_t t20 = t6 ? (t6 ? structure[3] * structure[3] : TB_C(0.0)) : TB_C(0.0);
    const real_t t21 = t8 ? (t8 ? structure[4] * structure[4] : TB_C(0.0)) : TB_C(0.0);
    const real_t t22 = t10 ? (t10 ? structure[5] * structure[5] : TB_C(0.0)) : TB_C(0.0);
    const real_t t23 = t12 ? (t12 ? structure[6] * structure[6] : TB_C(0.0)) : TB_C(0.0);
    const real_t t24 = t14 ? (t14 ? structure[7] * structure[7] : TB_C(0.0)) : TB_C(0.0);
    const real_t t25 = TB_SQRT(t17 + t18 + t19 + t20 + t21 + t22 + t23 + t24);
    const real_t t26 = t0 ? structure[0] : TB_C(0.0);
    const real_t t27 = TB_COPYSIGN(t25, t26);
    const real_t t28 = t26 + t27;
    const real_t t29 = t2 ? (t2 ? structure[1] * structure[9] : TB_C(0.0)) : TB_C(0.0);
    const real_t t30 = t4 ? (t4 ? structure[2] * structure[10] : TB_C(0.0)) : TB_C(0.0);
    const real_t t31 = (t0 ? t28 * structure[8] : TB_C(0.0)) + t29 + t30;
    const real_t t32 = t6 ? (t6 ? structure[3] * structure[11] : TB_C(0.0)) : TB_C(0.0);
    const real_t t33 = t8 ? (t8 ? structure[4] * structure[12] : TB_C(0.0)) : TB_C(0.0);
    const real_t t34 = t10 ? (t10 ? structure[5] * structure[13] : TB_C(0.0)) : TB_C(0.0);
    const real_t t35 = t12 ? (t12 ? structure[6] * structure[14] : TB_C(0.0)) : TB_C(0.0);
    const real_t t36 = t14 ? (t14 ? structure[7] * structure[15] : TB_C(0.0)) : TB_C(0.0);
    const real_t t37 = TB_C(1.0) / (t25 * (t25 + TB_ABS(t26)));
    const real_t t38 = (t31 + t32 + t33 + t34 + t35 + t36) * t37;
    const real_t t39 = structure[9] - structure[1] * t38;
    const real_t t40 = structure[10] - structure[2] * t38;
    const real_t t41 = (t2 ? (t2 ? t39 * t39 : TB_C(0.0)) : TB_C(0.0)) + (t4 ? (t4 ? t40 * t40
        : TB_C(0.0)) : TB_C(0.0));
    const real_t t42 = structure[11] - structure[3] * t38;
    const real_t t43 = t41 + (t6 ? (t6 ? t42 * t42 : TB_C(0.0)) : TB_C(0.0));
    const real_t t44 = structure[12] - structure[4] * t38;
    const real_t t45 = t43 + (t8 ? (t8 ? t44 * t44 : TB_C(0.0)) : TB_C(0.0));
    const real_t t46 = structure[13] - structure[5] * t38;
    const real_t t47 = t45 + (t10 ? (t10 ? t46 * t46 : TB_C(0.0)) : TB_C(0.0));
    const real_t t48 = structure[14] - structure[6] * t38;
    const real_t t49 = t47 + (t12 ? (t12 ? t48 * t48 : TB_C(0.0)) : TB_C(0.0));
    const real_t t50 = structure[15] - structure[7] * t38;
    const real_t t51 = t49 + (t14 ? (t14 ? t50 * t50 : TB_C(0.0)) : TB_C(0.0));
    const real_t t52 = TB_SQRT(t51);
    const real_t t53 = t2 ? t39 : TB_C(0.0);
    const real_t t54 = TB_COPYSIGN(t52, t53);
    const real_t t55 = t2 ? (t2 ? structure[1] * structure[17] : TB_C(0.0)) : TB_C(0.0);
    const real_t t56 = t4 ? (t4 ? structure[2] * structure[18] : TB_C(0.0)) : TB_C(0.0);
    const real_t t57 = (t0 ? t28 * structure[16] : TB_C(0.0)) + t55 + t56;
    const real_t t58 = t6 ? (t6 ? structure[3] * structure[19] : TB_C(0.0)) : TB_C(0.0);
    const real_t t59 = t8 ? (t8 ? structure[4] * structure[20] : TB_C(0.0)) : TB_C(0.0);
    const real_t t60 = t10 ? (t10 ? structure[5] * structure[21] : TB_C(0.0)) : TB_C(0.0);
    const real_t t61 = t12 ? (t12 ? structure[6] * structure[22] : TB_C(0.0)) : TB_C(0.0);
    const real_t t62 = t14 ? (t14 ? structure[7] * structure[23] : TB_C(0.0)) : TB_C(0.0);
    const real_t t63 = t37 * (t57 + t58 + t59 + t60 + t61 + t62);
    const real_t t64 = structure[18] - structure[2] * t63;
    const real_t t65 = t53 + t54;
    const real_t t66 = structure[17] - structure[1] * t63;
    const real_t t67 = (t2 ? t65 * t66 : TB_C(0.0)) + (t4 ? (t4 ? t40 * t64 : TB_C(0.0)) :
        TB_C(0.0));
    const real_t t68 = structure[19] - structure[3] * t63;
    const real_t t69 = t67 + (t6 ? (t6 ? t42 * t68 : TB_C(0.0)) : TB_C(0.0));
    const real_t t70 = structure[20] - structure[4] * t63;
    const real_t t71 = t69 + (t8 ? (t8 ? t44 * t70 : TB_C(0.0)) : TB_C(0.0));
    const real_t t72 = structure[21] - structure[5] * t63;
    const real_t t73 = t71 + (t10 ? (t10 ? t46 * t72 : TB_C(0.0)) : TB_C(0.0));
    const real_t t74 = structure[22] - structure[6] * t63;
    const real_t t75 = t73 + (t12 ? (t12 ? t48 * t74 : TB_C(0.0)) : TB_C(0.0));
    const real_t t76 = structure[23] - structure[7] * t63;
    const real_t t77 = t75 + (t14 ? (t14 ? t50 * t76 : TB_C(0.0)) : TB_C(0.0));
    const real_t t78 = TB_C(1.0) / (t52 * (t52 + TB_ABS(t53)));
    const real_t t79 = t77 * t78;
    const real_t t80 = t64 - t40 * t79;
    const real_t t81 = t68 - t42 * t79;
    const real_t t82 = (t4 ? (t4 ? t80 * t80 : TB_C(0.0)) : TB_C(0.0)) + (t6 ? (t6 ? t81 * t81
        : TB_C(0.0)) : TB_C(0.0));
    const real_t t83 = t70 - t44 * t79;
    const real_t t84 = t82 + (t8 ? (t8 ? t83 * t83 : TB_C(0.0)) : TB_C(0.0));
    const real_t t85 = t72 - t46 * t79;
    const real_t t86 = t84 + (t10 ? (t10 ? t85 * t85 : TB_C(0.0)) : TB_C(0.0));
    const real_t t87 = t74 - t48 * t79;
    const real_t t88 = t86 + (t12 ? (t12 ? t87 * t87 : TB_C(0.0)) : TB_C(0.0));
    const real_t t89 = t76 - t50 * t79;
    const real_t t90 = t88 + (t14 ? (t14 ? t89 * t89 : TB_C(0.0)) : TB_C(0.0));
    const real_t t91 = TB_SQRT(t90);
    const real_t t92 = t4 ? t80 : TB_C(0.0);
    const real_t t93 = TB_COPYSIGN(t91, t92);
    const real_t t94 = tb_min(tb_min(TB_ABS(t27), TB_ABS(t54)), TB_ABS(t93));
    const real_t t95 = TB_MOMENT_WEIGHT * structure[27];
    const real_t t96 = TB_MOMENT_WEIGHT * structure[24];
    const real_t t97 = TB_MOMENT_WEIGHT * structure[25];
    const real_t t98 = t2 ? (t2 ? structure[1] * t97 : TB_C(0.0)) : TB_C(0.0);
    const real_t t99 = TB_MOMENT_WEIGHT * structure[26];
    const real_t t100 = t4 ? (t4 ? structure[2] * t99 : TB_C(0.0)) : TB_C(0.0);
    const real_t t101 = t6 ? (t6 ? structure[3] * t95 : TB_C(0.0)) : TB_C(0.0);
    const real_t t102 = TB_MOMENT_WEIGHT * structure[28];
    const real_t t103 = t8 ? (t8 ? structure[4] * t102 : TB_C(0.0)) : TB_C(0.0);
    const real_t t104 = (t0 ? t28 * t96 : TB_C(0.0)) + t98 + t100 + t101 + t103;
    const real_t t105 = TB_MOMENT_WEIGHT * structure[29];
    const real_t t106 = t10 ? (t10 ? structure[5] * t105 : TB_C(0.0)) : TB_C(0.0);
    const real_t t107 = TB_MOMENT_WEIGHT * structure[30];
    const real_t t108 = t12 ? (t12 ? structure[6] * t107 : TB_C(0.0)) : TB_C(0.0);
    const real_t t109 = TB_MOMENT_WEIGHT * structure[31];
    const real_t t110 = t14 ? (t14 ? structure[7] * t109 : TB_C(0.0)) : TB_C(0.0);
    const real_t t111 = t37 * (t104 + t106 + t108 + t110);
    const real_t t112 = t95 - structure[3] * t111;
    const real_t t113 = t97 - structure[1] * t111;
    const real_t t114 = t99 - structure[2] * t111;
    const real_t t115 = (t2 ? t65 * t113 : TB_C(0.0)) + (t4 ? (t4 ? t40 * t114 : TB_C(0.0)) :
        TB_C(0.0));
    const real_t t116 = t115 + (t6 ? (t6 ? t42 * t112 : TB_C(0.0)) : TB_C(0.0));
    const real_t t117 = t102 - structure[4] * t111;
    const real_t t118 = t116 + (t8 ? (t8 ? t44 * t117 : TB_C(0.0)) : TB_C(0.0));
    const real_t t119 = t105 - structure[5] * t111;
    const real_t t120 = t118 + (t10 ? (t10 ? t46 * t119 : TB_C(0.0)) : TB_C(0.0));
    const real_t t121 = t107 - structure[6] * t111;
    const real_t t122 = t120 + (t12 ? (t12 ? t48 * t121 : TB_C(0.0)) : TB_C(0.0));
    const real_t t123 = t109 - structure[7] * t111;
    const real_t t124 = t122 + (t14 ? (t14 ? t50 * t123 : TB_C(0.0)) : TB_C(0.0));
    const real_t t125 = t78 * t124;
    const real_t t126 = t112 - t42 * t125;
    const real_t t127 = t92 + t93;
    const real_t t128 = t114 - t40 * t125;
    const real_t t129 = (t4 ? t127 * t128 : TB_C(0.0)) + (t6 ? (t6 ? t81 * t126 : TB_C(0.0)) :
        TB_C(0.0));
    const real_t t130 = t117 - t44 * t125;
    const real_t t131 = t129 + (t8 ? (t8 ? t83 * t130 : TB_C(0.0)) : TB_C(0.0));
    const real_t t132 = t119 - t46 * t125;
    const real_t t133 = t131 + (t10 ? (t10 ? t85 * t132 : TB_C(0.0)) : TB_C(0.0));
    const real_t t134 = t121 - t48 * t125;
    const real_t t135 = t133 + (t12 ? (t12 ? t87 * t134 : TB_C(0.0)) : TB_C(0.0));
    const real_t t136 = t123 - t50 * t125;
    const real_t t137 = t135 + (t14 ? (t14 ? t89 * t136 : TB_C(0.0)) : TB_C(0.0));
    const real_t t138 = TB_C(1.0) / (t91 * (t91 + TB_ABS(t92)));
    const real_t t139 = t137 * t138;
    const real_t t140 = t126 - t81 * t139;
    const real_t t141 = t130 - t83 * t139;
    const real_t t142 = (t6 ? (t6 ? t140 * t140 : TB_C(0.0)) : TB_C(0.0)) + (t8 ? (t8 ? t141 *
        t141 : TB_C(0.0)) : TB_C(0.0));
    const real_t t143 = t132 - t85 * t139;
    const real_t t144 = t10 ? (t10 ? t143 * t143 : TB_C(0.0)) : TB_C(0.0);
    const real_t t145 = t134 - t87 * t139;
    const real_t t146 = t12 ? (t12 ? t145 * t145 : TB_C(0.0)) : TB_C(0.0);
    const real_t t147 = t136 - t89 * t139;
    const real_t t148 = t14 ? (t14 ? t147 * t147 : TB_C(0.0)) : TB_C(0.0);
    const real_t t149 = TB_SQRT(t142 + t144 + t146 + t148);
    const real_t t150 = t6 ? t140 : TB_C(0.0);
    const real_t t151 = TB_COPYSIGN(t149, t150);
    const real_t t152 = TB_MOMENT_WEIGHT * structure[36];
    const real_t t153 = TB_MOMENT_WEIGHT * structure[32];
    const real_t t154 = TB_MOMENT_WEIGHT * structure[33];
    const real_t t155 = t2 ? (t2 ? structure[1] * t154 : TB_C(0.0)) : TB_C(0.0);
    const real_t t156 = TB_MOMENT_WEIGHT * structure[34];
    const real_t t157 = t4 ? (t4 ? structure[2] * t156 : TB_C(0.0)) : TB_C(0.0);
    const real_t t158 = TB_MOMENT_WEIGHT * structure[35];
    const real_t t159 = t6 ? (t6 ? structure[3] * t158 : TB_C(0.0)) : TB_C(0.0);
    const real_t t160 = (t0 ? t28 * t153 : TB_C(0.0)) + t155 + t157 + t159;
    const real_t t161 = t8 ? (t8 ? structure[4] * t152 : TB_C(0.0)) : TB_C(0.0);
    const real_t t162 = TB_MOMENT_WEIGHT * structure[37];
    const real_t t163 = t10 ? (t10 ? structure[5] * t162 : TB_C(0.0)) : TB_C(0.0);
    const real_t t164 = TB_MOMENT_WEIGHT * structure[38];
    const real_t t165 = t12 ? (t12 ? structure[6] * t164 : TB_C(0.0)) : TB_C(0.0);
    const real_t t166 = TB_MOMENT_WEIGHT * structure[39];
    const real_t t167 = t14 ? (t14 ? structure[7] * t166 : TB_C(0.0)) : TB_C(0.0);
    const real_t t168 = t37 * (t160 + t161 + t163 + t165 + t167);
    const real_t t169 = t152 - structure[4] * t168;
    const real_t t170 = t154 - structure[1] * t168;
    const real_t t171 = t156 - structure[2] * t168;
    const real_t t172 = (t2 ? t65 * t170 : TB_C(0.0)) + (t4 ? (t4 ? t40 * t171 : TB_C(0.0)) :
        TB_C(0.0));
    const real_t t173 = t158 - structure[3] * t168;
    const real_t t174 = t172 + (t6 ? (t6 ? t42 * t173 : TB_C(0.0)) : TB_C(0.0));
    const real_t t175 = t174 + (t8 ? (t8 ? t44 * t169 : TB_C(0.0)) : TB_C(0.0));
    const real_t t176 = t162 - structure[5] * t168;
    const real_t t177 = t175 + (t10 ? (t10 ? t46 * t176 : TB_C(0.0)) : TB_C(0.0));
    const real_t t178 = t164 - structure[6] * t168;
    const real_t t179 = t177 + (t12 ? (t12 ? t48 * t178 : TB_C(0.0)) : TB_C(0.0));
    const real_t t180 = t166 - structure[7] * t168;
    const real_t t181 = t179 + (t14 ? (t14 ? t50 * t180 : TB_C(0.0)) : TB_C(0.0));
    const real_t t182 = t78 * t181;
    const real_t t183 = t169 - t44 * t182;
    const real_t t184 = t171 - t40 * t182;
    const real_t t185 = t173 - t42 * t182;
    const real_t t186 = (t4 ? t127 * t184 : TB_C(0.0)) + (t6 ? (t6 ? t81 * t185 : TB_C(0.0)) :
        TB_C(0.0));
    const real_t t187 = t186 + (t8 ? (t8 ? t83 * t183 : TB_C(0.0)) : TB_C(0.0));
    const real_t t188 = t176 - t46 * t182;
    const real_t t189 = t187 + (t10 ? (t10 ? t85 * t188 : TB_C(0.0)) : TB_C(0.0));
    const real_t t190 = t178 - t48 * t182;
    const real_t t191 = t189 + (t12 ? (t12 ? t87 * t190 : TB_C(0.0)) : TB_C(0.0));
    const real_t t192 = t180 - t50 * t182;
    const real_t t193 = t191 + (t14 ? (t14 ? t89 * t192 : TB_C(0.0)) : TB_C(0.0));
    const real_t t194 = t138 * t193;
    const real_t t195 = t183 - t83 * t194;
    const real_t t196 = t150 + t151;
    const real_t t197 = t185 - t81 * t194;
    const real_t t198 = (t6 ? t196 * t197 : TB_C(0.0)) + (t8 ? (t8 ? t141 * t195 : TB_C(0.0)) :
        TB_C(0.0));
    const real_t t199 = t188 - t85 * t194;
    const real_t t200 = t10 ? (t10 ? t143 * t199 : TB_C(0.0)) : TB_C(0.0);
    const real_t t201 = t190 - t87 * t194;
    const real_t t202 = t12 ? (t12 ? t145 * t201 : TB_C(0.0)) : TB_C(0.0);
    const real_t t203 = t192 - t89 * t194;
    const real_t t204 = t14 ? (t14 ? t147 * t203 : TB_C(0.0)) : TB_C(0.0);
    const real_t t205 = TB_C(1.0) / (t149 * (t149 + TB_ABS(t150)));
    const real_t t206 = (t198 + t200 + t202 + t204) * t205;
    const real_t t207 = t195 - t141 * t206;
    const real_t t208 = t199 - t143 * t206;
    const real_t t209 = t10 ? (t10 ? t208 * t208 : TB_C(0.0)) : TB_C(0.0);
    const real_t t210 = (t8 ? (t8 ? t207 * t207 : TB_C(0.0)) : TB_C(0.0)) + t209;
    const real_t t211 = t201 - t145 * t206;
    const real_t t212 = t12 ? (t12 ? t211 * t211 : TB_C(0.0)) : TB_C(0.0);
    const real_t t213 = t203 - t147 * t206;
    const real_t t214 = t14 ? (t14 ? t213 * t213 : TB_C(0.0)) : TB_C(0.0);
    const real_t t215 = TB_SQRT(t210 + t212 + t214);
    const real_t t216 = t8 ? t207 : TB_C(0.0);
    const real_t t217 = TB_COPYSIGN(t215, t216);
    const real_t t218 = TB_MOMENT_WEIGHT * structure[45];
    const real_t t219 = TB_MOMENT_WEIGHT * structure[40];
    const real_t t220 = TB_MOMENT_WEIGHT * structure[41];
    const real_t t221 = t2 ? (t2 ? structure[1] * t220 : TB_C(0.0)) : TB_C(0.0);
    const real_t t222 = TB_MOMENT_WEIGHT * structure[42];
    const real_t t223 = t4 ? (t4 ? structure[2] * t222 : TB_C(0.0)) : TB_C(0.0);
    const real_t t224 = TB_MOMENT_WEIGHT * structure[43];
    const real_t t225 = t6 ? (t6 ? structure[3] * t224 : TB_C(0.0)) : TB_C(0.0);
    const real_t t226 = (t0 ? t28 * t219 : TB_C(0.0)) + t221 + t223 + t225;
    const real_t t227 = TB_MOMENT_WEIGHT * structure[44];
    const real_t t228 = t8 ? (t8 ? structure[4] * t227 : TB_C(0.0)) : TB_C(0.0);
    const real_t t229 = t10 ? (t10 ? structure[5] * t218 : TB_C(0.0)) : TB_C(0.0);
    const real_t t230 = TB_MOMENT_WEIGHT * structure[46];
    const real_t t231 = t12 ? (t12 ? structure[6] * t230 : TB_C(0.0)) : TB_C(0.0);
    const real_t t232 = TB_MOMENT_WEIGHT * structure[47];
    const real_t t233 = t14 ? (t14 ? structure[7] * t232 : TB_C(0.0)) : TB_C(0.0);
    const real_t t234 = t37 * (t226 + t228 + t229 + t231 + t233);
    const real_t t235 = t218 - structure[5] * t234;
    const real_t t236 = t220 - structure[1] * t234;
    const real_t t237 = t222 - structure[2] * t234;
    const real_t t238 = (t2 ? t65 * t236 : TB_C(0.0)) + (t4 ? (t4 ? t40 * t237 : TB_C(0.0)) :
        TB_C(0.0));
    const real_t t239 = t224 - structure[3] * t234;
    const real_t t240 = t238 + (t6 ? (t6 ? t42 * t239 : TB_C(0.0)) : TB_C(0.0));
    const real_t t241 = t227 - structure[4] * t234;
    const real_t t242 = t240 + (t8 ? (t8 ? t44 * t241 : TB_C(0.0)) : TB_C(0.0));
    const real_t t243 = t242 + (t10 ? (t10 ? t46 * t235 : TB_C(0.0)) : TB_C(0.0));
    const real_t t244 = t230 - structure[6] * t234;
    const real_t t245 = t243 + (t12 ? (t12 ? t48 * t244 : TB_C(0.0)) : TB_C(0.0));
    const real_t t246 = t232 - structure[7] * t234;
    const real_t t247 = t245 + (t14 ? (t14 ? t50 * t246 : TB_C(0.0)) : TB_C(0.0));
    const real_t t248 = t78 * t247;
    const real_t t249 = t235 - t46 * t248;
    const real_t t250 = t237 - t40 * t248;
    const real_t t251 = t239 - t42 * t248;
    const real_t t252 = (t4 ? t127 * t250 : TB_C(0.0)) + (t6 ? (t6 ? t81 * t251 : TB_C(0.0)) :
        TB_C(0.0));
    const real_t t253 = t241 - t44 * t248;
    const real_t t254 = t252 + (t8 ? (t8 ? t83 * t253 : TB_C(0.0)) : TB_C(0.0));
    const real_t t255 = t254 + (t10 ? (t10 ? t85 * t249 : TB_C(0.0)) : TB_C(0.0));
    const real_t t256 = t244 - t48 * t248;
    const real_t t257 = t255 + (t12 ? (t12 ? t87 * t256 : TB_C(0.0)) : TB_C(0.0));
    const real_t t258 = t246 - t50 * t248;
    const real_t t259 = t257 + (t14 ? (t14 ? t89 * t258 : TB_C(0.0)) : TB_C(0.0));
    const real_t t260 = t138 * t259;
    const real_t t261 = t249 - t85 * t260;
    const real_t t262 = t251 - t81 * t260;
    const real_t t263 = t253 - t83 * t260;
    const real_t t264 = (t6 ? t196 * t262 : TB_C(0.0)) + (t8 ? (t8 ? t141 * t263 : TB_C(0.0)) :
        TB_C(0.0));
    const real_t t265 = t10 ? (t10 ? t143 * t261 : TB_C(0.0)) : TB_C(0.0);
    const real_t t266 = t256 - t87 * t260;
    const real_t t267 = t12 ? (t12 ? t145 * t266 : TB_C(0.0)) : TB_C(0.0);
    const real_t t268 = t258 - t89 * t260;
    const real_t t269 = t14 ? (t14 ? t147 * t268 : TB_C(0.0)) : TB_C(0.0);
    const real_t t270 = t205 * (t264 + t265 + t267 + t269);
    const real_t t271 = t261 - t143 * t270;
    const real_t t272 = t216 + t217;
    const real_t t273 = t263 - t141 * t270;
    const real_t t274 = t10 ? (t10 ? t208 * t271 : TB_C(0.0)) : TB_C(0.0);
    const real_t t275 = t266 - t145 * t270;
    const real_t t276 = t12 ? (t12 ? t211 * t275 : TB_C(0.0)) : TB_C(0.0);
    const real_t t277 = t268 - t147 * t270;
    const real_t t278 = t14 ? (t14 ? t213 * t277 : TB_C(0.0)) : TB_C(0.0);
    const real_t t279 = (t8 ? t272 * t273 : TB_C(0.0)) + t274 + t276 + t278;
    const real_t t280 = t279 * (TB_C(1.0) / (t215 * (t215 + TB_ABS(t216))));
    const real_t t281 = t271 - t208 * t280;
    const real_t t282 = t10 ? (t10 ? t281 * t281 : TB_C(0.0)) : TB_C(0.0);
    const real_t t283 = t275 - t211 * t280;
    const real_t t284 = t12 ? (t12 ? t283 * t283 : TB_C(0.0)) : TB_C(0.0);
    const real_t t285 = t277 - t213 * t280;
    const real_t t286 = t14 ? (t14 ? t285 * t285 : TB_C(0.0)) : TB_C(0.0);
    const real_t t287 = TB_COPYSIGN(TB_SQRT(t282 + t284 + t286), t10 ? t281 : TB_C(0.0));
    const real_t t288 = tb_min(tb_min(tb_min(t94, TB_ABS(t151)), TB_ABS(t217)), TB_ABS(t287));
    const real_t t289 = TB_C(64.0) * TB_EPSILON / tb_min(TB_C(1.0), t288);
    const bool t290 = TB_C(0.0) <= moving[0];
    const real_t t291 = TB_C(1.0) / t27;
    const real_t t292 = TB_C(0.0) < side[0] ? TB_TENSION_MAX : (side[0] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t293 = TB_C(0.0) < side[1] ? TB_TENSION_MAX : (side[1] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t294 = TB_C(0.0) < side[2] ? TB_TENSION_MAX : (side[2] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t295 = structure[0] * t292 + structure[1] * t293 + structure[2] * t294;
    const real_t t296 = TB_C(0.0) < side[3] ? TB_TENSION_MAX : (side[3] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t297 = TB_C(0.0) < side[4] ? TB_TENSION_MAX : (side[4] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t298 = TB_C(0.0) < side[5] ? TB_TENSION_MAX : (side[5] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t299 = t295 + structure[3] * t296 + structure[4] * t297 + structure[5] * t298;
    const real_t t300 = TB_C(0.0) < side[6] ? TB_TENSION_MAX : (side[6] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t301 = TB_C(0.0) < side[7] ? TB_TENSION_MAX : (side[7] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t302 = wrench[0] - (t299 + structure[6] * t300 + structure[7] * t301);
    const real_t t303 = t302 * t291;
    const real_t t304 = (t0 ? structure[8] : TB_C(0.0)) - t28 * t38;
    const real_t t305 = TB_C(1.0) / t54;
    const real_t t306 = structure[8] * t292 + structure[9] * t293 + structure[10] * t294;
    const real_t t307 = t306 + structure[11] * t296 + structure[12] * t297;
    const real_t t308 = t307 + structure[13] * t298 + structure[14] * t300;
    const real_t t309 = wrench[1] - (t308 + structure[15] * t301) + t303 * t304;
    const real_t t310 = t309 * t305;
    const real_t t311 = (t2 ? t66 : TB_C(0.0)) - t65 * t79;
    const real_t t312 = TB_C(1.0) / t93;
    const real_t t313 = structure[16] * t292 + structure[17] * t293 + structure[18] * t294;
    const real_t t314 = t313 + structure[19] * t296 + structure[20] * t297;
    const real_t t315 = t314 + structure[21] * t298 + structure[22] * t300;
    const real_t t316 = (t0 ? structure[16] : TB_C(0.0)) - t28 * t63;
    const real_t t317 = wrench[2] - (t315 + structure[23] * t301) + t303 * t316;
    const real_t t318 = (t317 + t310 * t311) * t312;
    const real_t t319 = (t4 ? t128 : TB_C(0.0)) - t127 * t139;
    const real_t t320 = TB_C(1.0) / t151;
    const real_t t321 = t96 * t292 + t97 * t293 + t99 * t294 + t95 * t296;
    const real_t t322 = t321 + t102 * t297 + t105 * t298 + t107 * t300 + t109 * t301;
    const real_t t323 = (t0 ? t96 : TB_C(0.0)) - t28 * t111;
    const real_t t324 = TB_MOMENT_WEIGHT * wrench[3] - t322 + t303 * t323;
    const real_t t325 = (t2 ? t113 : TB_C(0.0)) - t65 * t125;
    const real_t t326 = (t324 + t310 * t325 + t318 * t319) * t320;
    const real_t t327 = (t6 ? t197 : TB_C(0.0)) - t196 * t206;
    const real_t t328 = TB_C(1.0) / t217;
    const real_t t329 = t153 * t292 + t154 * t293 + t156 * t294 + t158 * t296;
    const real_t t330 = t329 + t152 * t297 + t162 * t298 + t164 * t300 + t166 * t301;
    const real_t t331 = (t0 ? t153 : TB_C(0.0)) - t28 * t168;
    const real_t t332 = TB_MOMENT_WEIGHT * wrench[4] - t330 + t303 * t331;
    const real_t t333 = (t2 ? t170 : TB_C(0.0)) - t65 * t182;
    const real_t t334 = (t4 ? t184 : TB_C(0.0)) - t127 * t194;
    const real_t t335 = (t332 + t310 * t333 + t318 * t334 + t326 * t327) * t328;
    const real_t t336 = (t8 ? t273 : TB_C(0.0)) - t272 * t280;
    const real_t t337 = TB_C(1.0) / t287;
    const real_t t338 = t219 * t292 + t220 * t293 + t222 * t294 + t224 * t296;
    const real_t t339 = t338 + t227 * t297 + t218 * t298 + t230 * t300 + t232 * t301;
    const real_t t340 = (t0 ? t219 : TB_C(0.0)) - t28 * t234;
    const real_t t341 = TB_MOMENT_WEIGHT * wrench[5] - t339 + t303 * t340;
    const real_t t342 = (t2 ? t236 : TB_C(0.0)) - t65 * t248;
    const real_t t343 = (t4 ? t250 : TB_C(0.0)) - t127 * t260;
    const real_t t344 = (t6 ? t262 : TB_C(0.0)) - t196 * t270;
    const real_t t345 = t341 + t310 * t342 + t318 * t343 + t326 * t344 + t335 * t336;
    const real_t t346 = t337 * (t345 * t337);
    const real_t t347 = t328 * (t335 + t336 * t346);
    const real_t t348 = t320 * (t326 + t327 * t347 + t344 * t346);
    const real_t t349 = t312 * (t318 + t319 * t348 + t334 * t347 + t343 * t346);
    const real_t t350 = t310 + t311 * t349 + t325 * t348 + t333 * t347 + t342 * t346;
    const real_t t351 = t305 * t350;
    const real_t t352 = t303 + t304 * t351 + t316 * t349 + t323 * t348 + t331 * t347;
    const real_t t353 = t291 * (t352 + t340 * t346);
    const real_t t354 = structure[4] * t353 + structure[12] * t351 + structure[20] * t349;
    const real_t t355 = t354 + t102 * t348 + t152 * t347 + t227 * t346;
    const real_t t356 = TB_C(0.0) < t9 ? tb_max(TB_TENSION_MIN - t355, t355 - TB_TENSION_MAX) :
        -TB_C(1.0);
    const real_t t357 = structure[5] * t353 + structure[13] * t351 + structure[21] * t349;
    const real_t t358 = t357 + t105 * t348 + t162 * t347 + t218 * t346;
    const real_t t359 = TB_C(0.0) < t11 ? tb_max(TB_TENSION_MIN - t358, t358 - TB_TENSION_MAX)
        : -TB_C(1.0);
    const real_t t360 = structure[6] * t353 + structure[14] * t351 + structure[22] * t349;
    const real_t t361 = t360 + t107 * t348 + t164 * t347 + t230 * t346;
    const real_t t362 = TB_C(0.0) < t13 ? tb_max(TB_TENSION_MIN - t361, t361 - TB_TENSION_MAX)
        : -TB_C(1.0);
    const real_t t363 = structure[7] * t353 + structure[15] * t351 + structure[23] * t349;
    const real_t t364 = t363 + t109 * t348 + t166 * t347 + t232 * t346;
    const real_t t365 = TB_C(0.0) < t15 ? tb_max(TB_TENSION_MIN - t364, t364 - TB_TENSION_MAX)
        : -TB_C(1.0);
    const real_t t366 = structure[0] * t353 + structure[8] * t351 + structure[16] * t349;
    const real_t t367 = t366 + t96 * t348 + t153 * t347 + t219 * t346;
    const real_t t368 = TB_C(0.0) < t1 ? tb_max(TB_TENSION_MIN - t367, t367 - TB_TENSION_MAX) :
        -TB_C(1.0);
    const real_t t369 = structure[1] * t353 + structure[9] * t351 + structure[17] * t349;
    const real_t t370 = t369 + t97 * t348 + t154 * t347 + t220 * t346;
    const real_t t371 = TB_C(0.0) < t3 ? tb_max(TB_TENSION_MIN - t370, t370 - TB_TENSION_MAX) :
        -TB_C(1.0);
    const real_t t372 = structure[2] * t353 + structure[10] * t351 + structure[18] * t349;
    const real_t t373 = t372 + t99 * t348 + t156 * t347 + t222 * t346;
    const real_t t374 = TB_C(0.0) < t5 ? tb_max(TB_TENSION_MIN - t373, t373 - TB_TENSION_MAX) :
        -TB_C(1.0);
    const real_t t375 = structure[3] * t353 + structure[11] * t351 + structure[19] * t349;
    const real_t t376 = t375 + t95 * t348 + t158 * t347 + t224 * t346;
    const real_t t377 = TB_C(0.0) < t7 ? tb_max(TB_TENSION_MIN - t376, t376 - TB_TENSION_MAX) :
        -TB_C(1.0);
    real_t t378, t379, t380, t381, t382, t383, t384, t385;
    if (t290) {
        t378 = moving[0] == TB_C(4.0) ? TB_C(1.0) : TB_C(0.0);
        t379 = moving[0] == TB_C(5.0) ? TB_C(1.0) : TB_C(0.0);
        t380 = TB_C(6.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
        t381 = moving[0] == TB_C(7.0) ? TB_C(1.0) : TB_C(0.0);
        t382 = TB_C(0.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
        t383 = TB_C(1.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
        t384 = moving[0] == TB_C(2.0) ? TB_C(1.0) : TB_C(0.0);
        t385 = moving[0] == TB_C(3.0) ? TB_C(1.0) : TB_C(0.0);
    } else {
        t378 = t356;
        t379 = t359;
        t380 = t362;
        t381 = t365;
        t382 = t368;
        t383 = t371;
        t384 = t374;
        t385 = t377;
    }
    const real_t t386 = tb_max(t378, t379);
    const real_t t387 = tb_max(t382, t383);
    const bool t388 = tb_max(tb_max(t386, t380), t381) <= tb_max(tb_max(t387, t384), t385);
    real_t t389, t390, t391, t392, t393, t394, t395, t396;
    if (t388) {
        const bool t397 = tb_max(t384, t385) <= t387;
        real_t t398, t399, t400, t401, t402, t403, t404, t405;
        if (t397) {
            const bool t406 = t383 <= t382;
            t398 = t406 ? TB_C(0.0) : TB_C(1.0);
            t399 = t406 ? structure[0] : structure[1];
            t400 = t406 ? structure[8] : structure[9];
            t401 = t406 ? structure[16] : structure[17];
            t402 = t406 ? t96 : t97;
            t403 = t406 ? t153 : t154;
            t404 = t406 ? t219 : t220;
            t405 = t406 ? t367 : t370;
        } else {
            const bool t407 = t385 <= t384;
            t398 = t407 ? TB_C(2.0) : TB_C(3.0);
            t399 = t407 ? structure[2] : structure[3];
            t400 = t407 ? structure[10] : structure[11];
            t401 = t407 ? structure[18] : structure[19];
            t402 = t407 ? t99 : t95;
            t403 = t407 ? t156 : t158;
            t404 = t407 ? t222 : t224;
            t405 = t407 ? t373 : t376;
        }
        t389 = t398;
        t390 = t399;
        t391 = t400;
        t392 = t401;
        t393 = t402;
        t394 = t403;
        t395 = t404;
        t396 = t405;
    } else {
        const bool t408 = tb_max(t380, t381) <= t386;
        real_t t409, t410, t411, t412, t413, t414, t415, t416;
        if (t408) {
            const bool t417 = t379 <= t378;
            t409 = t417 ? TB_C(4.0) : TB_C(5.0);
            t410 = t417 ? structure[4] : structure[5];
            t411 = t417 ? structure[12] : structure[13];
            t412 = t417 ? structure[20] : structure[21];
            t413 = t417 ? t102 : t105;
            t414 = t417 ? t152 : t162;
            t415 = t417 ? t227 : t218;
            t416 = t417 ? t355 : t358;
        } else {
            const bool t418 = t381 <= t380;
            t409 = t418 ? TB_C(6.0) : TB_C(7.0);
            t410 = t418 ? structure[6] : structure[7];
            t411 = t418 ? structure[14] : structure[15];
            t412 = t418 ? structure[22] : structure[23];
            t413 = t418 ? t107 : t109;
            t414 = t418 ? t164 : t166;
            t415 = t418 ? t230 : t232;
            t416 = t418 ? t361 : t364;
        }
        t389 = t409;
        t390 = t410;
        t391 = t411;
        t392 = t412;
        t393 = t413;
        t394 = t414;
        t395 = t415;
        t396 = t416;
    }
    const real_t t419 = t291 * t390;
    const real_t t420 = t305 * (t391 + t304 * t419);
    const real_t t421 = t312 * (t392 + t316 * t419 + t311 * t420);
    const real_t t422 = t320 * (t393 + t323 * t419 + t325 * t420 + t319 * t421);
    const real_t t423 = t394 + t331 * t419 + t333 * t420 + t334 * t421 + t327 * t422;
    const real_t t424 = t328 * t423;
    const real_t t425 = t395 + t340 * t419 + t342 * t420 + t343 * t421 + t344 * t422;
    const real_t t426 = t337 * (t337 * (t425 + t336 * t424));
    const real_t t427 = t328 * (t424 + t336 * t426);
    const real_t t428 = t320 * (t422 + t327 * t427 + t344 * t426);
    const real_t t429 = t312 * (t421 + t319 * t428 + t334 * t427 + t343 * t426);
    const real_t t430 = t420 + t311 * t429 + t325 * t428 + t333 * t427 + t342 * t426;
    const real_t t431 = t305 * t430;
    const real_t t432 = t419 + t304 * t431 + t316 * t429 + t323 * t428 + t331 * t427;
    const real_t t433 = t291 * (t432 + t340 * t426);
    const real_t t434 = structure[0] * t433 + structure[8] * t431 + structure[16] * t429;
    const real_t t435 = t434 + t96 * t428 + t153 * t427 + t219 * t426;
    const real_t t436 = (TB_C(0.0) == t389 ? TB_C(1.0) : TB_C(0.0)) - t435;
    const real_t t437 = structure[1] * t433 + structure[9] * t431 + structure[17] * t429;
    const real_t t438 = t437 + t97 * t428 + t154 * t427 + t220 * t426;
    const real_t t439 = (TB_C(1.0) == t389 ? TB_C(1.0) : TB_C(0.0)) - t438;
    const real_t t440 = (t0 ? (t0 ? t436 * t436 : TB_C(0.0)) : TB_C(0.0)) + (t2 ? (t2 ? t439 *
        t439 : TB_C(0.0)) : TB_C(0.0));
    const real_t t441 = structure[2] * t433 + structure[10] * t431 + structure[18] * t429;
    const real_t t442 = t441 + t99 * t428 + t156 * t427 + t222 * t426;
    const real_t t443 = (TB_C(2.0) == t389 ? TB_C(1.0) : TB_C(0.0)) - t442;
    const real_t t444 = t440 + (t4 ? (t4 ? t443 * t443 : TB_C(0.0)) : TB_C(0.0));
    const real_t t445 = structure[3] * t433 + structure[11] * t431 + structure[19] * t429;
    const real_t t446 = t445 + t95 * t428 + t158 * t427 + t224 * t426;
    const real_t t447 = (TB_C(3.0) == t389 ? TB_C(1.0) : TB_C(0.0)) - t446;
    const real_t t448 = t444 + (t6 ? (t6 ? t447 * t447 : TB_C(0.0)) : TB_C(0.0));
    const real_t t449 = structure[4] * t433 + structure[12] * t431 + structure[20] * t429;
    const real_t t450 = t449 + t102 * t428 + t152 * t427 + t227 * t426;
    const real_t t451 = (TB_C(4.0) == t389 ? TB_C(1.0) : TB_C(0.0)) - t450;
    const real_t t452 = t448 + (t8 ? (t8 ? t451 * t451 : TB_C(0.0)) : TB_C(0.0));
    const real_t t453 = structure[5] * t433 + structure[13] * t431 + structure[21] * t429;
    const real_t t454 = t453 + t105 * t428 + t162 * t427 + t218 * t426;
    const real_t t455 = (TB_C(5.0) == t389 ? TB_C(1.0) : TB_C(0.0)) - t454;
    const real_t t456 = t10 ? (t10 ? t455 * t455 : TB_C(0.0)) : TB_C(0.0);
    const real_t t457 = structure[6] * t433 + structure[14] * t431 + structure[22] * t429;
    const real_t t458 = t457 + t107 * t428 + t164 * t427 + t230 * t426;
    const real_t t459 = (TB_C(6.0) == t389 ? TB_C(1.0) : TB_C(0.0)) - t458;
    const real_t t460 = t12 ? (t12 ? t459 * t459 : TB_C(0.0)) : TB_C(0.0);
    const real_t t461 = structure[7] * t433 + structure[15] * t431 + structure[23] * t429;
    const real_t t462 = t461 + t109 * t428 + t166 * t427 + t232 * t426;
    const real_t t463 = (TB_C(7.0) == t389 ? TB_C(1.0) : TB_C(0.0)) - t462;
    const real_t t464 = t14 ? (t14 ? t463 * t463 : TB_C(0.0)) : TB_C(0.0);
    const real_t t465 = t452 + t456 + t460 + t464;
    const real_t t466 = t396 + t465 * push[0];
    const bool t467 = t466 < TB_TENSION_MIDDLE;
    real_t t468;
    if (t16 && t289 * t289 < t465) {
        const real_t t469 = tb_max(t467 ? TB_TENSION_MIN - t466 : t466 - TB_TENSION_MAX,
            TB_C(0.0));
        t468 = t469 * (TB_C(1.0) / t465);
    } else {
        t468 = TB_C(1e+30);
    }
    const real_t t470 = t467 ? TB_C(1.0) : -TB_C(1.0);
    const real_t t471 = side[0] * (t435 * t470);
    real_t t472;
    if (t289 < t471) {
        const real_t t473 = tb_max(side[0] * (t367 - t435 * push[0] - t292), TB_C(0.0));
        t472 = t473 / t471;
    } else {
        t472 = TB_C(1e+30);
    }
    const real_t t474 = side[1] * (t438 * t470);
    real_t t475;
    if (t289 < t474) {
        const real_t t476 = tb_max(side[1] * (t370 - t438 * push[0] - t293), TB_C(0.0));
        t475 = t476 / t474;
    } else {
        t475 = TB_C(1e+30);
    }
    const real_t t477 = side[2] * (t442 * t470);
    real_t t478;
    if (t289 < t477) {
        const real_t t479 = tb_max(side[2] * (t373 - t442 * push[0] - t294), TB_C(0.0));
        t478 = t479 / t477;
    } else {
        t478 = TB_C(1e+30);
    }
    const real_t t480 = side[3] * (t446 * t470);
    real_t t481;
    if (t289 < t480) {
        const real_t t482 = tb_max(side[3] * (t376 - t446 * push[0] - t296), TB_C(0.0));
        t481 = t482 / t480;
    } else {
        t481 = TB_C(1e+30);
    }
    const real_t t483 = side[4] * (t450 * t470);
    real_t t484;
    if (t289 < t483) {
        const real_t t485 = tb_max(side[4] * (t355 - t450 * push[0] - t297), TB_C(0.0));
        t484 = t485 / t483;
    } else {
        t484 = TB_C(1e+30);
    }
    const real_t t486 = tb_min(tb_min(tb_min(tb_min(t472, t475), t478), t481), t484);
    const real_t t487 = side[5] * (t454 * t470);
    real_t t488;
    if (t289 < t487) {
        const real_t t489 = tb_max(side[5] * (t358 - t454 * push[0] - t298), TB_C(0.0));
        t488 = t489 / t487;
    } else {
        t488 = TB_C(1e+30);
    }
    const real_t t490 = side[6] * (t458 * t470);
    real_t t491;
    if (t289 < t490) {
        const real_t t492 = tb_max(side[6] * (t361 - t458 * push[0] - t300), TB_C(0.0));
        t491 = t492 / t490;
    } else {
        t491 = TB_C(1e+30);
    }
    const real_t t493 = side[7] * (t462 * t470);
    real_t t494;
    if (t289 < t493) {
        const real_t t495 = tb_max(side[7] * (t364 - t462 * push[0] - t301), TB_C(0.0));
        t494 = t495 / t493;
    } else {
        t494 = TB_C(1e+30);
    }
    const real_t t496 = tb_min(tb_min(tb_min(t486, t488), t491), t494);
    const bool t497 = t468 <= t496;
    const real_t t498 = tb_max(tb_max(tb_max(tb_max(t368, t371), t374), t377), t356);
    const bool t499 = tb_max(tb_max(tb_max(t498, t359), t362), t365) <= t289;
    const bool t500 = (!t290 && t499) || !(tb_min(t468, t496) < TB_C(1e+30));
    const real_t t501 = t497 && !t500 ? t389 : -TB_C(1.0);
    const real_t t502 = -t470;
    real_t t503;
    if (t497 || t500) {
        t503 = -TB_C(1.0);
    } else {
        const real_t t504 = -t484;
        const real_t t505 = -t488;
        const real_t t506 = tb_max(t504, t505);
        const real_t t507 = -t491;
        const real_t t508 = -t494;
        const real_t t509 = -t472;
        const real_t t510 = -t475;
        const real_t t511 = tb_max(t509, t510);
        const real_t t512 = -t478;
        const real_t t513 = -t481;
        const bool t514 = tb_max(tb_max(t506, t507), t508) <= tb_max(tb_max(t511, t512), t513);
        real_t t515;
        if (t514) {
            const real_t t516 = tb_max(t512, t513) <= t511 ? (t510 <= t509 ? TB_C(0.0) :
                TB_C(1.0)) : (t513 <= t512 ? TB_C(2.0) : TB_C(3.0));
            t515 = t516;
        } else {
            const real_t t517 = tb_max(t507, t508) <= t506 ? (t505 <= t504 ? TB_C(4.0) :
                TB_C(5.0)) : (t508 <= t507 ? TB_C(6.0) : TB_C(7.0));
            t515 = t517;
        }
        t503 = t515;
    }
    const real_t side_0 = TB_C(0.0) == t501 ? t502 : (TB_C(0.0) == t503 ? TB_C(0.0) : side[0]);
    const real_t side_1 = TB_C(1.0) == t501 ? t502 : (TB_C(1.0) == t503 ? TB_C(0.0) : side[1]);
    const real_t side_2 = TB_C(2.0) == t501 ? t502 : (TB_C(2.0) == t503 ? TB_C(0.0) : side[2]);
    const real_t side_3 = TB_C(3.0) == t501 ? t502 : (TB_C(3.0) == t503 ? TB_C(0.0) : side[3]);
    const real_t side_4 = TB_C(4.0) == t501 ? t502 : (TB_C(4.0) == t503 ? TB_C(0.0) : side[4]);
    const real_t side_5 = TB_C(5.0) == t501 ? t502 : (TB_C(5.0) == t503 ? TB_C(0.0) : side[5]);
    const real_t side_6 = TB_C(6.0) == t501 ? t502 : (TB_C(6.0) == t503 ? TB_C(0.0) : side[6]);
    const real_t side_7 = TB_C(7.0) == t501 ? t502 : (TB_C(7.0) == t503 ? TB_C(0.0) : side[7]);
    const real_t moving_0 = t497 ? -TB_C(1.0) : t389;
    const real_t push_0 = t497 ? TB_C(0.0) : push[0] + t470 * t496;
    const real_t done_0 = t500 ? TB_C(1.0) : TB_C(0.0);
    side[0] = side_0;
    side[1] = side_1;
    side[2] = side_2;
    side[3] = side_3;
    side[4] = side_4;
    side[5] = side_5;
    side[6] = side_6;
    side[7] = side_7;
    moving[0] = moving_0;
    push[0] = push_0;
    done[0] = done_0;
    return TB_OK;
}

/* The tensions, refined and judged. */
static tb_status tb_least_norm_tension_finish(const real_t structure[48], const real_t wrench[6],
    const real_t pivot[1], const real_t side[8], real_t tension[8], real_t delivered[6],
    real_t kkt_residual[1])
{
    const bool t0 = side[0] == TB_C(0.0);
    const real_t t1 = TB_C(0.0) < side[0] ? TB_TENSION_MAX : (side[0] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t2 = TB_C(0.0) < side[1] ? TB_TENSION_MAX : (side[1] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t3 = TB_C(0.0) < side[2] ? TB_TENSION_MAX : (side[2] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t4 = structure[0] * t1 + structure[1] * t2 + structure[2] * t3;
    const real_t t5 = TB_C(0.0) < side[3] ? TB_TENSION_MAX : (side[3] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t6 = TB_C(0.0) < side[4] ? TB_TENSION_MAX : (side[4] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t7 = TB_C(0.0) < side[5] ? TB_TENSION_MAX : (side[5] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t8 = t4 + structure[3] * t5 + structure[4] * t6 + structure[5] * t7;
    const real_t t9 = TB_C(0.0) < side[6] ? TB_TENSION_MAX : (side[6] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t10 = TB_C(0.0) < side[7] ? TB_TENSION_MAX : (side[7] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t11 = wrench[0] - (t8 + structure[6] * t9 + structure[7] * t10);
    const real_t t12 = t0 ? (t0 ? structure[0] * structure[0] : TB_C(0.0)) : TB_C(0.0);
    const bool t13 = TB_C(0.0) == side[1];
    const real_t t14 = t13 ? (t13 ? structure[1] * structure[1] : TB_C(0.0)) : TB_C(0.0);
    const bool t15 = TB_C(0.0) == side[2];
    const real_t t16 = t15 ? (t15 ? structure[2] * structure[2] : TB_C(0.0)) : TB_C(0.0);
    const bool t17 = TB_C(0.0) == side[3];
    const real_t t18 = t17 ? (t17 ? structure[3] * structure[3] : TB_C(0.0)) : TB_C(0.0);
    const bool t19 = TB_C(0.0) == side[4];
    const real_t t20 = t19 ? (t19 ? structure[4] * structure[4] : TB_C(0.0)) : TB_C(0.0);
    const bool t21 = TB_C(0.0) == side[5];
    const real_t t22 = t21 ? (t21 ? structure[5] * structure[5] : TB_C(0.0)) : TB_C(0.0);
    const bool t23 = TB_C(0.0) == side[6];
    const real_t t24 = t23 ? (t23 ? structure[6] * structure[6] : TB_C(0.0)) : TB_C(0.0);
    const bool t25 = TB_C(0.0) == side[7];
    const real_t t26 = t25 ? (t25 ? structure[7] * structure[7] : TB_C(0.0)) : TB_C(0.0);
    const real_t t27 = TB_SQRT(t12 + t14 + t16 + t18 + t20 + t22 + t24 + t26);
    const real_t t28 = t0 ? structure[0] : TB_C(0.0);
    const real_t t29 = TB_COPYSIGN(t27, t28);
    const real_t t30 = TB_C(1.0) / t29;
    const real_t t31 = t11 * t30;
    const real_t t32 = t28 + t29;
    const real_t t33 = t13 ? (t13 ? structure[1] * structure[9] : TB_C(0.0)) : TB_C(0.0);
    const real_t t34 = t15 ? (t15 ? structure[2] * structure[10] : TB_C(0.0)) : TB_C(0.0);
    const real_t t35 = (t0 ? structure[8] * t32 : TB_C(0.0)) + t33 + t34;
    const real_t t36 = t17 ? (t17 ? structure[3] * structure[11] : TB_C(0.0)) : TB_C(0.0);
    const real_t t37 = t19 ? (t19 ? structure[4] * structure[12] : TB_C(0.0)) : TB_C(0.0);
    const real_t t38 = t21 ? (t21 ? structure[5] * structure[13] : TB_C(0.0)) : TB_C(0.0);
    const real_t t39 = t23 ? (t23 ? structure[6] * structure[14] : TB_C(0.0)) : TB_C(0.0);
    const real_t t40 = t25 ? (t25 ? structure[7] * structure[15] : TB_C(0.0)) : TB_C(0.0);
    const real_t t41 = TB_C(1.0) / (t27 * (t27 + TB_ABS(t28)));
    const real_t t42 = (t35 + t36 + t37 + t38 + t39 + t40) * t41;
    const real_t t43 = (t0 ? structure[8] : TB_C(0.0)) - t32 * t42;
    const real_t t44 = t1 * structure[8] + t2 * structure[9] + t3 * structure[10];
    const real_t t45 = t44 + t5 * structure[11] + t6 * structure[12] + t7 * structure[13];
    const real_t t46 = wrench[1] - (t45 + t9 * structure[14] + t10 * structure[15]);
    const real_t t47 = structure[9] - structure[1] * t42;
    const real_t t48 = structure[10] - structure[2] * t42;
    const real_t t49 = (t13 ? (t13 ? t47 * t47 : TB_C(0.0)) : TB_C(0.0)) + (t15 ? (t15 ? t48 *
        t48 : TB_C(0.0)) : TB_C(0.0));
    const real_t t50 = structure[11] - structure[3] * t42;
    const real_t t51 = t49 + (t17 ? (t17 ? t50 * t50 : TB_C(0.0)) : TB_C(0.0));
    const real_t t52 = structure[12] - structure[4] * t42;
    const real_t t53 = t51 + (t19 ? (t19 ? t52 * t52 : TB_C(0.0)) : TB_C(0.0));
    const real_t t54 = structure[13] - structure[5] * t42;
    const real_t t55 = t53 + (t21 ? (t21 ? t54 * t54 : TB_C(0.0)) : TB_C(0.0));
    const real_t t56 = structure[14] - structure[6] * t42;
    const real_t t57 = t55 + (t23 ? (t23 ? t56 * t56 : TB_C(0.0)) : TB_C(0.0));
    const real_t t58 = structure[15] - structure[7] * t42;
    const real_t t59 = t57 + (t25 ? (t25 ? t58 * t58 : TB_C(0.0)) : TB_C(0.0));
    const real_t t60 = TB_SQRT(t59);
    const real_t t61 = t13 ? t47 : TB_C(0.0);
    const real_t t62 = TB_COPYSIGN(t60, t61);
    const real_t t63 = TB_C(1.0) / t62;
    const real_t t64 = (t46 + t31 * t43) * t63;
    const real_t t65 = t13 ? (t13 ? structure[1] * structure[17] : TB_C(0.0)) : TB_C(0.0);
    const real_t t66 = t15 ? (t15 ? structure[2] * structure[18] : TB_C(0.0)) : TB_C(0.0);
    const real_t t67 = (t0 ? t32 * structure[16] : TB_C(0.0)) + t65 + t66;
    const real_t t68 = t17 ? (t17 ? structure[3] * structure[19] : TB_C(0.0)) : TB_C(0.0);
    const real_t t69 = t19 ? (t19 ? structure[4] * structure[20] : TB_C(0.0)) : TB_C(0.0);
    const real_t t70 = t21 ? (t21 ? structure[5] * structure[21] : TB_C(0.0)) : TB_C(0.0);
    const real_t t71 = t23 ? (t23 ? structure[6] * structure[22] : TB_C(0.0)) : TB_C(0.0);
    const real_t t72 = t25 ? (t25 ? structure[7] * structure[23] : TB_C(0.0)) : TB_C(0.0);
    const real_t t73 = t41 * (t67 + t68 + t69 + t70 + t71 + t72);
    const real_t t74 = structure[17] - structure[1] * t73;
    const real_t t75 = t61 + t62;
    const real_t t76 = structure[18] - structure[2] * t73;
    const real_t t77 = (t13 ? t74 * t75 : TB_C(0.0)) + (t15 ? (t15 ? t48 * t76 : TB_C(0.0)) :
        TB_C(0.0));
    const real_t t78 = structure[19] - structure[3] * t73;
    const real_t t79 = t77 + (t17 ? (t17 ? t50 * t78 : TB_C(0.0)) : TB_C(0.0));
    const real_t t80 = structure[20] - structure[4] * t73;
    const real_t t81 = t79 + (t19 ? (t19 ? t52 * t80 : TB_C(0.0)) : TB_C(0.0));
    const real_t t82 = structure[21] - structure[5] * t73;
    const real_t t83 = t81 + (t21 ? (t21 ? t54 * t82 : TB_C(0.0)) : TB_C(0.0));
    const real_t t84 = structure[22] - structure[6] * t73;
    const real_t t85 = t83 + (t23 ? (t23 ? t56 * t84 : TB_C(0.0)) : TB_C(0.0));
    const real_t t86 = structure[23] - structure[7] * t73;
    const real_t t87 = t85 + (t25 ? (t25 ? t58 * t86 : TB_C(0.0)) : TB_C(0.0));
    const real_t t88 = TB_C(1.0) / (t60 * (t60 + TB_ABS(t61)));
    const real_t t89 = t87 * t88;
    const real_t t90 = (t13 ? t74 : TB_C(0.0)) - t75 * t89;
    const real_t t91 = t1 * structure[16] + t2 * structure[17] + t3 * structure[18];
    const real_t t92 = t91 + t5 * structure[19] + t6 * structure[20] + t7 * structure[21];
    const real_t t93 = wrench[2] - (t92 + t9 * structure[22] + t10 * structure[23]);
    const real_t t94 = (t0 ? structure[16] : TB_C(0.0)) - t32 * t73;
    const real_t t95 = t76 - t48 * t89;
    const real_t t96 = t78 - t50 * t89;
    const real_t t97 = (t15 ? (t15 ? t95 * t95 : TB_C(0.0)) : TB_C(0.0)) + (t17 ? (t17 ? t96 *
        t96 : TB_C(0.0)) : TB_C(0.0));
    const real_t t98 = t80 - t52 * t89;
    const real_t t99 = t97 + (t19 ? (t19 ? t98 * t98 : TB_C(0.0)) : TB_C(0.0));
    const real_t t100 = t82 - t54 * t89;
    const real_t t101 = t21 ? (t21 ? t100 * t100 : TB_C(0.0)) : TB_C(0.0);
    const real_t t102 = t84 - t56 * t89;
    const real_t t103 = t23 ? (t23 ? t102 * t102 : TB_C(0.0)) : TB_C(0.0);
    const real_t t104 = t86 - t58 * t89;
    const real_t t105 = t25 ? (t25 ? t104 * t104 : TB_C(0.0)) : TB_C(0.0);
    const real_t t106 = TB_SQRT(t99 + t101 + t103 + t105);
    const real_t t107 = t15 ? t95 : TB_C(0.0);
    const real_t t108 = TB_COPYSIGN(t106, t107);
    const real_t t109 = TB_C(1.0) / t108;
    const real_t t110 = (t93 + t31 * t94 + t64 * t90) * t109;
    const real_t t111 = TB_MOMENT_WEIGHT * structure[26];
    const real_t t112 = TB_MOMENT_WEIGHT * structure[24];
    const real_t t113 = TB_MOMENT_WEIGHT * structure[25];
    const real_t t114 = t13 ? (t13 ? structure[1] * t113 : TB_C(0.0)) : TB_C(0.0);
    const real_t t115 = t15 ? (t15 ? structure[2] * t111 : TB_C(0.0)) : TB_C(0.0);
    const real_t t116 = TB_MOMENT_WEIGHT * structure[27];
    const real_t t117 = t17 ? (t17 ? structure[3] * t116 : TB_C(0.0)) : TB_C(0.0);
    const real_t t118 = (t0 ? t32 * t112 : TB_C(0.0)) + t114 + t115 + t117;
    const real_t t119 = TB_MOMENT_WEIGHT * structure[28];
    const real_t t120 = t19 ? (t19 ? structure[4] * t119 : TB_C(0.0)) : TB_C(0.0);
    const real_t t121 = TB_MOMENT_WEIGHT * structure[29];
    const real_t t122 = t21 ? (t21 ? structure[5] * t121 : TB_C(0.0)) : TB_C(0.0);
    const real_t t123 = TB_MOMENT_WEIGHT * structure[30];
    const real_t t124 = t23 ? (t23 ? structure[6] * t123 : TB_C(0.0)) : TB_C(0.0);
    const real_t t125 = TB_MOMENT_WEIGHT * structure[31];
    const real_t t126 = t25 ? (t25 ? structure[7] * t125 : TB_C(0.0)) : TB_C(0.0);
    const real_t t127 = t41 * (t118 + t120 + t122 + t124 + t126);
    const real_t t128 = t111 - structure[2] * t127;
    const real_t t129 = t113 - structure[1] * t127;
    const real_t t130 = (t13 ? t75 * t129 : TB_C(0.0)) + (t15 ? (t15 ? t48 * t128 : TB_C(0.0))
        : TB_C(0.0));
    const real_t t131 = t116 - structure[3] * t127;
    const real_t t132 = t130 + (t17 ? (t17 ? t50 * t131 : TB_C(0.0)) : TB_C(0.0));
    const real_t t133 = t119 - structure[4] * t127;
    const real_t t134 = t132 + (t19 ? (t19 ? t52 * t133 : TB_C(0.0)) : TB_C(0.0));
    const real_t t135 = t121 - structure[5] * t127;
    const real_t t136 = t134 + (t21 ? (t21 ? t54 * t135 : TB_C(0.0)) : TB_C(0.0));
    const real_t t137 = t123 - structure[6] * t127;
    const real_t t138 = t136 + (t23 ? (t23 ? t56 * t137 : TB_C(0.0)) : TB_C(0.0));
    const real_t t139 = t125 - structure[7] * t127;
    const real_t t140 = t138 + (t25 ? (t25 ? t58 * t139 : TB_C(0.0)) : TB_C(0.0));
    const real_t t141 = t88 * t140;
    const real_t t142 = t128 - t48 * t141;
    const real_t t143 = t107 + t108;
    const real_t t144 = t131 - t50 * t141;
    const real_t t145 = (t15 ? t142 * t143 : TB_C(0.0)) + (t17 ? (t17 ? t96 * t144 : TB_C(0.0))
        : TB_C(0.0));
    const real_t t146 = t133 - t52 * t141;
    const real_t t147 = t145 + (t19 ? (t19 ? t98 * t146 : TB_C(0.0)) : TB_C(0.0));
    const real_t t148 = t135 - t54 * t141;
    const real_t t149 = t21 ? (t21 ? t100 * t148 : TB_C(0.0)) : TB_C(0.0);
    const real_t t150 = t137 - t56 * t141;
    const real_t t151 = t23 ? (t23 ? t102 * t150 : TB_C(0.0)) : TB_C(0.0);
    const real_t t152 = t139 - t58 * t141;
    const real_t t153 = t25 ? (t25 ? t104 * t152 : TB_C(0.0)) : TB_C(0.0);
    const real_t t154 = TB_C(1.0) / (t106 * (t106 + TB_ABS(t107)));
    const real_t t155 = (t147 + t149 + t151 + t153) * t154;
    const real_t t156 = (t15 ? t142 : TB_C(0.0)) - t143 * t155;
    const real_t t157 = TB_MOMENT_WEIGHT * wrench[3];
    const real_t t158 = t1 * t112 + t2 * t113 + t3 * t111 + t5 * t116 + t6 * t119;
    const real_t t159 = t157 - (t158 + t7 * t121 + t9 * t123 + t10 * t125);
    const real_t t160 = (t0 ? t112 : TB_C(0.0)) - t32 * t127;
    const real_t t161 = (t13 ? t129 : TB_C(0.0)) - t75 * t141;
    const real_t t162 = t144 - t96 * t155;
    const real_t t163 = t17 ? (t17 ? t162 * t162 : TB_C(0.0)) : TB_C(0.0);
    const real_t t164 = t146 - t98 * t155;
    const real_t t165 = t19 ? (t19 ? t164 * t164 : TB_C(0.0)) : TB_C(0.0);
    const real_t t166 = t148 - t100 * t155;
    const real_t t167 = t21 ? (t21 ? t166 * t166 : TB_C(0.0)) : TB_C(0.0);
    const real_t t168 = t150 - t102 * t155;
    const real_t t169 = t23 ? (t23 ? t168 * t168 : TB_C(0.0)) : TB_C(0.0);
    const real_t t170 = t152 - t104 * t155;
    const real_t t171 = t25 ? (t25 ? t170 * t170 : TB_C(0.0)) : TB_C(0.0);
    const real_t t172 = TB_SQRT(t163 + t165 + t167 + t169 + t171);
    const real_t t173 = t17 ? t162 : TB_C(0.0);
    const real_t t174 = TB_COPYSIGN(t172, t173);
    const real_t t175 = TB_C(1.0) / t174;
    const real_t t176 = (t159 + t31 * t160 + t64 * t161 + t110 * t156) * t175;
    const real_t t177 = TB_MOMENT_WEIGHT * structure[35];
    const real_t t178 = TB_MOMENT_WEIGHT * structure[32];
    const real_t t179 = TB_MOMENT_WEIGHT * structure[33];
    const real_t t180 = t13 ? (t13 ? structure[1] * t179 : TB_C(0.0)) : TB_C(0.0);
    const real_t t181 = TB_MOMENT_WEIGHT * structure[34];
    const real_t t182 = t15 ? (t15 ? structure[2] * t181 : TB_C(0.0)) : TB_C(0.0);
    const real_t t183 = t17 ? (t17 ? structure[3] * t177 : TB_C(0.0)) : TB_C(0.0);
    const real_t t184 = (t0 ? t32 * t178 : TB_C(0.0)) + t180 + t182 + t183;
    const real_t t185 = TB_MOMENT_WEIGHT * structure[36];
    const real_t t186 = t19 ? (t19 ? structure[4] * t185 : TB_C(0.0)) : TB_C(0.0);
    const real_t t187 = TB_MOMENT_WEIGHT * structure[37];
    const real_t t188 = t21 ? (t21 ? structure[5] * t187 : TB_C(0.0)) : TB_C(0.0);
    const real_t t189 = TB_MOMENT_WEIGHT * structure[38];
    const real_t t190 = t23 ? (t23 ? structure[6] * t189 : TB_C(0.0)) : TB_C(0.0);
    const real_t t191 = TB_MOMENT_WEIGHT * structure[39];
    const real_t t192 = t25 ? (t25 ? structure[7] * t191 : TB_C(0.0)) : TB_C(0.0);
    const real_t t193 = t41 * (t184 + t186 + t188 + t190 + t192);
    const real_t t194 = t177 - structure[3] * t193;
    const real_t t195 = t179 - structure[1] * t193;
    const real_t t196 = t181 - structure[2] * t193;
    const real_t t197 = (t13 ? t75 * t195 : TB_C(0.0)) + (t15 ? (t15 ? t48 * t196 : TB_C(0.0))
        : TB_C(0.0));
    const real_t t198 = t197 + (t17 ? (t17 ? t50 * t194 : TB_C(0.0)) : TB_C(0.0));
    const real_t t199 = t185 - structure[4] * t193;
    const real_t t200 = t198 + (t19 ? (t19 ? t52 * t199 : TB_C(0.0)) : TB_C(0.0));
    const real_t t201 = t187 - structure[5] * t193;
    const real_t t202 = t200 + (t21 ? (t21 ? t54 * t201 : TB_C(0.0)) : TB_C(0.0));
    const real_t t203 = t189 - structure[6] * t193;
    const real_t t204 = t202 + (t23 ? (t23 ? t56 * t203 : TB_C(0.0)) : TB_C(0.0));
    const real_t t205 = t191 - structure[7] * t193;
    const real_t t206 = t204 + (t25 ? (t25 ? t58 * t205 : TB_C(0.0)) : TB_C(0.0));
    const real_t t207 = t88 * t206;
    const real_t t208 = t194 - t50 * t207;
    const real_t t209 = t196 - t48 * t207;
    const real_t t210 = (t15 ? t143 * t209 : TB_C(0.0)) + (t17 ? (t17 ? t96 * t208 : TB_C(0.0))
        : TB_C(0.0));
    const real_t t211 = t199 - t52 * t207;
    const real_t t212 = t210 + (t19 ? (t19 ? t98 * t211 : TB_C(0.0)) : TB_C(0.0));
    const real_t t213 = t201 - t54 * t207;
    const real_t t214 = t21 ? (t21 ? t100 * t213 : TB_C(0.0)) : TB_C(0.0);
    const real_t t215 = t203 - t56 * t207;
    const real_t t216 = t23 ? (t23 ? t102 * t215 : TB_C(0.0)) : TB_C(0.0);
    const real_t t217 = t205 - t58 * t207;
    const real_t t218 = t25 ? (t25 ? t104 * t217 : TB_C(0.0)) : TB_C(0.0);
    const real_t t219 = t154 * (t212 + t214 + t216 + t218);
    const real_t t220 = t208 - t96 * t219;
    const real_t t221 = t173 + t174;
    const real_t t222 = t211 - t98 * t219;
    const real_t t223 = t19 ? (t19 ? t164 * t222 : TB_C(0.0)) : TB_C(0.0);
    const real_t t224 = t213 - t100 * t219;
    const real_t t225 = t21 ? (t21 ? t166 * t224 : TB_C(0.0)) : TB_C(0.0);
    const real_t t226 = t215 - t102 * t219;
    const real_t t227 = t23 ? (t23 ? t168 * t226 : TB_C(0.0)) : TB_C(0.0);
    const real_t t228 = (t17 ? t220 * t221 : TB_C(0.0)) + t223 + t225 + t227;
    const real_t t229 = t217 - t104 * t219;
    const real_t t230 = t25 ? (t25 ? t170 * t229 : TB_C(0.0)) : TB_C(0.0);
    const real_t t231 = TB_C(1.0) / (t172 * (t172 + TB_ABS(t173)));
    const real_t t232 = (t228 + t230) * t231;
    const real_t t233 = (t17 ? t220 : TB_C(0.0)) - t221 * t232;
    const real_t t234 = TB_MOMENT_WEIGHT * wrench[4];
    const real_t t235 = t1 * t178 + t2 * t179 + t3 * t181 + t5 * t177 + t6 * t185;
    const real_t t236 = t234 - (t235 + t7 * t187 + t9 * t189 + t10 * t191);
    const real_t t237 = (t0 ? t178 : TB_C(0.0)) - t32 * t193;
    const real_t t238 = (t13 ? t195 : TB_C(0.0)) - t75 * t207;
    const real_t t239 = (t15 ? t209 : TB_C(0.0)) - t143 * t219;
    const real_t t240 = t236 + t31 * t237 + t64 * t238 + t110 * t239 + t176 * t233;
    const real_t t241 = t222 - t164 * t232;
    const real_t t242 = t19 ? (t19 ? t241 * t241 : TB_C(0.0)) : TB_C(0.0);
    const real_t t243 = t224 - t166 * t232;
    const real_t t244 = t21 ? (t21 ? t243 * t243 : TB_C(0.0)) : TB_C(0.0);
    const real_t t245 = t226 - t168 * t232;
    const real_t t246 = t23 ? (t23 ? t245 * t245 : TB_C(0.0)) : TB_C(0.0);
    const real_t t247 = t229 - t170 * t232;
    const real_t t248 = t25 ? (t25 ? t247 * t247 : TB_C(0.0)) : TB_C(0.0);
    const real_t t249 = TB_SQRT(t242 + t244 + t246 + t248);
    const real_t t250 = t19 ? t241 : TB_C(0.0);
    const real_t t251 = TB_COPYSIGN(t249, t250);
    const real_t t252 = TB_C(1.0) / t251;
    const real_t t253 = t240 * t252;
    const real_t t254 = TB_MOMENT_WEIGHT * structure[44];
    const real_t t255 = TB_MOMENT_WEIGHT * structure[40];
    const real_t t256 = TB_MOMENT_WEIGHT * structure[41];
    const real_t t257 = t13 ? (t13 ? structure[1] * t256 : TB_C(0.0)) : TB_C(0.0);
    const real_t t258 = TB_MOMENT_WEIGHT * structure[42];
    const real_t t259 = t15 ? (t15 ? structure[2] * t258 : TB_C(0.0)) : TB_C(0.0);
    const real_t t260 = TB_MOMENT_WEIGHT * structure[43];
    const real_t t261 = t17 ? (t17 ? structure[3] * t260 : TB_C(0.0)) : TB_C(0.0);
    const real_t t262 = (t0 ? t32 * t255 : TB_C(0.0)) + t257 + t259 + t261;
    const real_t t263 = t19 ? (t19 ? structure[4] * t254 : TB_C(0.0)) : TB_C(0.0);
    const real_t t264 = TB_MOMENT_WEIGHT * structure[45];
    const real_t t265 = t21 ? (t21 ? structure[5] * t264 : TB_C(0.0)) : TB_C(0.0);
    const real_t t266 = TB_MOMENT_WEIGHT * structure[46];
    const real_t t267 = t23 ? (t23 ? structure[6] * t266 : TB_C(0.0)) : TB_C(0.0);
    const real_t t268 = TB_MOMENT_WEIGHT * structure[47];
    const real_t t269 = t25 ? (t25 ? structure[7] * t268 : TB_C(0.0)) : TB_C(0.0);
    const real_t t270 = t41 * (t262 + t263 + t265 + t267 + t269);
    const real_t t271 = t254 - structure[4] * t270;
    const real_t t272 = t256 - structure[1] * t270;
    const real_t t273 = t258 - structure[2] * t270;
    const real_t t274 = (t13 ? t75 * t272 : TB_C(0.0)) + (t15 ? (t15 ? t48 * t273 : TB_C(0.0))
        : TB_C(0.0));
    const real_t t275 = t260 - structure[3] * t270;
    const real_t t276 = t274 + (t17 ? (t17 ? t50 * t275 : TB_C(0.0)) : TB_C(0.0));
    const real_t t277 = t276 + (t19 ? (t19 ? t52 * t271 : TB_C(0.0)) : TB_C(0.0));
    const real_t t278 = t264 - structure[5] * t270;
    const real_t t279 = t277 + (t21 ? (t21 ? t54 * t278 : TB_C(0.0)) : TB_C(0.0));
    const real_t t280 = t266 - structure[6] * t270;
    const real_t t281 = t279 + (t23 ? (t23 ? t56 * t280 : TB_C(0.0)) : TB_C(0.0));
    const real_t t282 = t268 - structure[7] * t270;
    const real_t t283 = t281 + (t25 ? (t25 ? t58 * t282 : TB_C(0.0)) : TB_C(0.0));
    const real_t t284 = t88 * t283;
    const real_t t285 = t271 - t52 * t284;
    const real_t t286 = t273 - t48 * t284;
    const real_t t287 = t275 - t50 * t284;
    const real_t t288 = (t15 ? t143 * t286 : TB_C(0.0)) + (t17 ? (t17 ? t96 * t287 : TB_C(0.0))
        : TB_C(0.0));
    const real_t t289 = t288 + (t19 ? (t19 ? t98 * t285 : TB_C(0.0)) : TB_C(0.0));
    const real_t t290 = t278 - t54 * t284;
    const real_t t291 = t21 ? (t21 ? t100 * t290 : TB_C(0.0)) : TB_C(0.0);
    const real_t t292 = t280 - t56 * t284;
    const real_t t293 = t23 ? (t23 ? t102 * t292 : TB_C(0.0)) : TB_C(0.0);
    const real_t t294 = t282 - t58 * t284;
    const real_t t295 = t25 ? (t25 ? t104 * t294 : TB_C(0.0)) : TB_C(0.0);
    const real_t t296 = t154 * (t289 + t291 + t293 + t295);
    const real_t t297 = t285 - t98 * t296;
    const real_t t298 = t287 - t96 * t296;
    const real_t t299 = t19 ? (t19 ? t164 * t297 : TB_C(0.0)) : TB_C(0.0);
    const real_t t300 = t290 - t100 * t296;
    const real_t t301 = t21 ? (t21 ? t166 * t300 : TB_C(0.0)) : TB_C(0.0);
    const real_t t302 = t292 - t102 * t296;
    const real_t t303 = t23 ? (t23 ? t168 * t302 : TB_C(0.0)) : TB_C(0.0);
    const real_t t304 = (t17 ? t221 * t298 : TB_C(0.0)) + t299 + t301 + t303;
    const real_t t305 = t294 - t104 * t296;
    const real_t t306 = t25 ? (t25 ? t170 * t305 : TB_C(0.0)) : TB_C(0.0);
    const real_t t307 = t231 * (t304 + t306);
    const real_t t308 = t297 - t164 * t307;
    const real_t t309 = t250 + t251;
    const real_t t310 = t300 - t166 * t307;
    const real_t t311 = t21 ? (t21 ? t243 * t310 : TB_C(0.0)) : TB_C(0.0);
    const real_t t312 = t302 - t168 * t307;
    const real_t t313 = t23 ? (t23 ? t245 * t312 : TB_C(0.0)) : TB_C(0.0);
    const real_t t314 = t305 - t170 * t307;
    const real_t t315 = t25 ? (t25 ? t247 * t314 : TB_C(0.0)) : TB_C(0.0);
    const real_t t316 = (t19 ? t308 * t309 : TB_C(0.0)) + t311 + t313 + t315;
    const real_t t317 = t316 * (TB_C(1.0) / (t249 * (t249 + TB_ABS(t250))));
    const real_t t318 = (t19 ? t308 : TB_C(0.0)) - t309 * t317;
    const real_t t319 = TB_MOMENT_WEIGHT * wrench[5];
    const real_t t320 = t1 * t255 + t2 * t256 + t3 * t258 + t5 * t260 + t6 * t254;
    const real_t t321 = t319 - (t320 + t7 * t264 + t9 * t266 + t10 * t268);
    const real_t t322 = (t0 ? t255 : TB_C(0.0)) - t32 * t270;
    const real_t t323 = (t13 ? t272 : TB_C(0.0)) - t75 * t284;
    const real_t t324 = (t15 ? t286 : TB_C(0.0)) - t143 * t296;
    const real_t t325 = (t17 ? t298 : TB_C(0.0)) - t221 * t307;
    const real_t t326 = t321 + t31 * t322 + t64 * t323 + t110 * t324 + t176 * t325;
    const real_t t327 = t310 - t243 * t317;
    const real_t t328 = t21 ? (t21 ? t327 * t327 : TB_C(0.0)) : TB_C(0.0);
    const real_t t329 = t312 - t245 * t317;
    const real_t t330 = t23 ? (t23 ? t329 * t329 : TB_C(0.0)) : TB_C(0.0);
    const real_t t331 = t314 - t247 * t317;
    const real_t t332 = t25 ? (t25 ? t331 * t331 : TB_C(0.0)) : TB_C(0.0);
    const real_t t333 = TB_COPYSIGN(TB_SQRT(t328 + t330 + t332), t21 ? t327 : TB_C(0.0));
    const real_t t334 = TB_C(1.0) / t333;
    const real_t t335 = t334 * ((t326 + t253 * t318) * t334);
    const real_t t336 = t252 * (t253 + t318 * t335);
    const real_t t337 = t175 * (t176 + t233 * t336 + t325 * t335);
    const real_t t338 = t109 * (t110 + t156 * t337 + t239 * t336 + t324 * t335);
    const real_t t339 = t64 + t90 * t338 + t161 * t337 + t238 * t336 + t323 * t335;
    const real_t t340 = t63 * t339;
    const real_t t341 = t31 + t43 * t340 + t94 * t338 + t160 * t337 + t237 * t336;
    const real_t t342 = t30 * (t341 + t322 * t335);
    const real_t t343 = structure[0] * t342 + structure[8] * t340 + structure[16] * t338;
    const real_t t344 = t343 + t112 * t337 + t178 * t336 + t255 * t335;
    const real_t t345 = structure[1] * t342 + structure[9] * t340 + structure[17] * t338;
    const real_t t346 = t345 + t113 * t337 + t179 * t336 + t256 * t335;
    const real_t t347 = (t0 ? structure[0] * t344 : TB_C(0.0)) + (t13 ? structure[1] * t346 :
        TB_C(0.0));
    const real_t t348 = structure[2] * t342 + structure[10] * t340 + structure[18] * t338;
    const real_t t349 = t348 + t111 * t337 + t181 * t336 + t258 * t335;
    const real_t t350 = structure[3] * t342 + structure[11] * t340 + structure[19] * t338;
    const real_t t351 = t350 + t116 * t337 + t177 * t336 + t260 * t335;
    const real_t t352 = t347 + (t15 ? structure[2] * t349 : TB_C(0.0)) + (t17 ? structure[3] *
        t351 : TB_C(0.0));
    const real_t t353 = structure[4] * t342 + structure[12] * t340 + structure[20] * t338;
    const real_t t354 = t353 + t119 * t337 + t185 * t336 + t254 * t335;
    const real_t t355 = structure[5] * t342 + structure[13] * t340 + structure[21] * t338;
    const real_t t356 = t355 + t121 * t337 + t187 * t336 + t264 * t335;
    const real_t t357 = t352 + (t19 ? structure[4] * t354 : TB_C(0.0)) + (t21 ? structure[5] *
        t356 : TB_C(0.0));
    const real_t t358 = structure[6] * t342 + structure[14] * t340 + structure[22] * t338;
    const real_t t359 = t358 + t123 * t337 + t189 * t336 + t266 * t335;
    const real_t t360 = structure[7] * t342 + structure[15] * t340 + structure[23] * t338;
    const real_t t361 = t360 + t125 * t337 + t191 * t336 + t268 * t335;
    const real_t t362 = t357 + (t23 ? structure[6] * t359 : TB_C(0.0)) + (t25 ? structure[7] *
        t361 : TB_C(0.0));
    const real_t t363 = t30 * (t11 - t362);
    const real_t t364 = (t0 ? structure[8] * t344 : TB_C(0.0)) + (t13 ? structure[9] * t346 :
        TB_C(0.0));
    const real_t t365 = t364 + (t15 ? structure[10] * t349 : TB_C(0.0)) + (t17 ? structure[11]
        * t351 : TB_C(0.0));
    const real_t t366 = t365 + (t19 ? structure[12] * t354 : TB_C(0.0)) + (t21 ? structure[13]
        * t356 : TB_C(0.0));
    const real_t t367 = t366 + (t23 ? structure[14] * t359 : TB_C(0.0)) + (t25 ? structure[15]
        * t361 : TB_C(0.0));
    const real_t t368 = t63 * (t46 - t367 + t43 * t363);
    const real_t t369 = (t0 ? structure[16] * t344 : TB_C(0.0)) + (t13 ? structure[17] * t346 :
        TB_C(0.0));
    const real_t t370 = t369 + (t15 ? structure[18] * t349 : TB_C(0.0)) + (t17 ? structure[19]
        * t351 : TB_C(0.0));
    const real_t t371 = t370 + (t19 ? structure[20] * t354 : TB_C(0.0)) + (t21 ? structure[21]
        * t356 : TB_C(0.0));
    const real_t t372 = t371 + (t23 ? structure[22] * t359 : TB_C(0.0)) + (t25 ? structure[23]
        * t361 : TB_C(0.0));
    const real_t t373 = t109 * (t93 - t372 + t94 * t363 + t90 * t368);
    const real_t t374 = (t0 ? t112 * t344 : TB_C(0.0)) + (t13 ? t113 * t346 : TB_C(0.0));
    const real_t t375 = t374 + (t15 ? t111 * t349 : TB_C(0.0)) + (t17 ? t116 * t351 :
        TB_C(0.0));
    const real_t t376 = t375 + (t19 ? t119 * t354 : TB_C(0.0)) + (t21 ? t121 * t356 :
        TB_C(0.0));
    const real_t t377 = t376 + (t23 ? t123 * t359 : TB_C(0.0)) + (t25 ? t125 * t361 :
        TB_C(0.0));
    const real_t t378 = t159 - t377 + t160 * t363 + t161 * t368 + t156 * t373;
    const real_t t379 = t175 * t378;
    const real_t t380 = (t0 ? t178 * t344 : TB_C(0.0)) + (t13 ? t179 * t346 : TB_C(0.0));
    const real_t t381 = t380 + (t15 ? t181 * t349 : TB_C(0.0)) + (t17 ? t177 * t351 :
        TB_C(0.0));
    const real_t t382 = t381 + (t19 ? t185 * t354 : TB_C(0.0)) + (t21 ? t187 * t356 :
        TB_C(0.0));
    const real_t t383 = t382 + (t23 ? t189 * t359 : TB_C(0.0)) + (t25 ? t191 * t361 :
        TB_C(0.0));
    const real_t t384 = t236 - t383 + t237 * t363 + t238 * t368 + t239 * t373;
    const real_t t385 = t252 * (t384 + t233 * t379);
    const real_t t386 = (t0 ? t255 * t344 : TB_C(0.0)) + (t13 ? t256 * t346 : TB_C(0.0));
    const real_t t387 = t386 + (t15 ? t258 * t349 : TB_C(0.0)) + (t17 ? t260 * t351 :
        TB_C(0.0));
    const real_t t388 = t387 + (t19 ? t254 * t354 : TB_C(0.0)) + (t21 ? t264 * t356 :
        TB_C(0.0));
    const real_t t389 = t388 + (t23 ? t266 * t359 : TB_C(0.0)) + (t25 ? t268 * t361 :
        TB_C(0.0));
    const real_t t390 = t321 - t389 + t322 * t363 + t323 * t368 + t324 * t373;
    const real_t t391 = t334 * (t334 * (t390 + t325 * t379 + t318 * t385));
    const real_t t392 = t252 * (t385 + t318 * t391);
    const real_t t393 = t175 * (t379 + t233 * t392 + t325 * t391);
    const real_t t394 = t109 * (t373 + t156 * t393 + t239 * t392 + t324 * t391);
    const real_t t395 = t368 + t90 * t394 + t161 * t393 + t238 * t392 + t323 * t391;
    const real_t t396 = t63 * t395;
    const real_t t397 = t363 + t43 * t396 + t94 * t394 + t160 * t393 + t237 * t392;
    const real_t t398 = t30 * (t397 + t322 * t391);
    const real_t t399 = structure[0] * t398 + structure[8] * t396 + structure[16] * t394;
    const real_t t400 = t344 + (t399 + t112 * t393 + t178 * t392 + t255 * t391);
    const real_t tension_0 = tb_min(tb_max(t0 ? t400 : t1, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t t401 = structure[1] * t398 + structure[9] * t396 + structure[17] * t394;
    const real_t t402 = t346 + (t401 + t113 * t393 + t179 * t392 + t256 * t391);
    const real_t tension_1 = tb_min(tb_max(t13 ? t402 : t2, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t t403 = structure[2] * t398 + structure[10] * t396 + structure[18] * t394;
    const real_t t404 = t349 + (t403 + t111 * t393 + t181 * t392 + t258 * t391);
    const real_t tension_2 = tb_min(tb_max(t15 ? t404 : t3, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t t405 = structure[3] * t398 + structure[11] * t396 + structure[19] * t394;
    const real_t t406 = t351 + (t405 + t116 * t393 + t177 * t392 + t260 * t391);
    const real_t tension_3 = tb_min(tb_max(t17 ? t406 : t5, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t t407 = structure[4] * t398 + structure[12] * t396 + structure[20] * t394;
    const real_t t408 = t354 + (t407 + t119 * t393 + t185 * t392 + t254 * t391);
    const real_t tension_4 = tb_min(tb_max(t19 ? t408 : t6, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t t409 = structure[5] * t398 + structure[13] * t396 + structure[21] * t394;
    const real_t t410 = t356 + (t409 + t121 * t393 + t187 * t392 + t264 * t391);
    const real_t tension_5 = tb_min(tb_max(t21 ? t410 : t7, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t t411 = structure[6] * t398 + structure[14] * t396 + structure[22] * t394;
    const real_t t412 = t359 + (t411 + t123 * t393 + t189 * t392 + t266 * t391);
    const real_t tension_6 = tb_min(tb_max(t23 ? t412 : t9, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t t413 = structure[7] * t398 + structure[15] * t396 + structure[23] * t394;
    const real_t t414 = t361 + (t413 + t125 * t393 + t191 * t392 + t268 * t391);
    const real_t tension_7 = tb_min(tb_max(t25 ? t414 : t10, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t t415 = structure[0] * tension_0 + structure[1] * tension_1;
    const real_t t416 = t415 + structure[2] * tension_2 + structure[3] * tension_3;
    const real_t t417 = t416 + structure[4] * tension_4 + structure[5] * tension_5;
    const real_t delivered_0 = t417 + structure[6] * tension_6 + structure[7] * tension_7;
    const real_t t418 = structure[8] * tension_0 + structure[9] * tension_1;
    const real_t t419 = t418 + structure[10] * tension_2 + structure[11] * tension_3;
    const real_t t420 = t419 + structure[12] * tension_4 + structure[13] * tension_5;
    const real_t delivered_1 = t420 + structure[14] * tension_6 + structure[15] * tension_7;
    const real_t t421 = structure[16] * tension_0 + structure[17] * tension_1;
    const real_t t422 = t421 + structure[18] * tension_2 + structure[19] * tension_3;
    const real_t t423 = t422 + structure[20] * tension_4 + structure[21] * tension_5;
    const real_t delivered_2 = t423 + structure[22] * tension_6 + structure[23] * tension_7;
    const real_t t424 = structure[24] * tension_0 + structure[25] * tension_1;
    const real_t t425 = t424 + structure[26] * tension_2 + structure[27] * tension_3;
    const real_t t426 = t425 + structure[28] * tension_4 + structure[29] * tension_5;
    const real_t delivered_3 = t426 + structure[30] * tension_6 + structure[31] * tension_7;
    const real_t t427 = structure[32] * tension_0 + structure[33] * tension_1;
    const real_t t428 = t427 + structure[34] * tension_2 + structure[35] * tension_3;
    const real_t t429 = t428 + structure[36] * tension_4 + structure[37] * tension_5;
    const real_t delivered_4 = t429 + structure[38] * tension_6 + structure[39] * tension_7;
    const real_t t430 = structure[40] * tension_0 + structure[41] * tension_1;
    const real_t t431 = t430 + structure[42] * tension_2 + structure[43] * tension_3;
    const real_t t432 = t431 + structure[44] * tension_4 + structure[45] * tension_5;
    const real_t delivered_5 = t432 + structure[46] * tension_6 + structure[47] * tension_7;
    const real_t t433 = tb_max(side[0] * (t1 - t400), side[1] * (t2 - t402));
    const real_t t434 = tb_max(tb_max(t433, side[2] * (t3 - t404)), side[3] * (t5 - t406));
    const real_t t435 = tb_max(tb_max(t434, side[4] * (t6 - t408)), side[5] * (t7 - t410));
    const real_t t436 = tb_max(tb_max(t435, side[6] * (t9 - t412)), side[7] * (t10 - t414));
    const real_t t437 = tb_min(tb_min(TB_ABS(t29), TB_ABS(t62)), TB_ABS(t108));
    const real_t t438 = tb_min(tb_min(tb_min(t437, TB_ABS(t174)), TB_ABS(t251)), TB_ABS(t333));
    const real_t t439 = tb_max(TB_C(0.0), t436) * tb_min(TB_C(1.0), t438);
    const real_t t440 = tb_max(tb_max(TB_ABS(t342), TB_ABS(t340)), TB_ABS(t338));
    const real_t t441 = tb_max(tb_max(tb_max(t440, TB_ABS(t337)), TB_ABS(t336)), TB_ABS(t335));
    const real_t t442 = TB_TENSION_MAX * t439 * (TB_C(1.0) / tb_max(TB_TENSION_MAX, t441));
    const real_t t443 = tb_max(tb_max(t442, TB_ABS(delivered_0 - wrench[0])),
        TB_ABS(delivered_1 - wrench[1]));
    const real_t t444 = t112 * tension_0 + t113 * tension_1 + t111 * tension_2;
    const real_t t445 = t444 + t116 * tension_3 + t119 * tension_4 + t121 * tension_5;
    const real_t t446 = t445 + t123 * tension_6 + t125 * tension_7 - t157;
    const real_t t447 = tb_max(tb_max(t443, TB_ABS(delivered_2 - wrench[2])), TB_ABS(t446));
    const real_t t448 = t178 * tension_0 + t179 * tension_1 + t181 * tension_2;
    const real_t t449 = t448 + t177 * tension_3 + t185 * tension_4 + t187 * tension_5;
    const real_t t450 = t449 + t189 * tension_6 + t191 * tension_7 - t234;
    const real_t t451 = t255 * tension_0 + t256 * tension_1 + t258 * tension_2;
    const real_t t452 = t451 + t260 * tension_3 + t254 * tension_4 + t264 * tension_5;
    const real_t t453 = t452 + t266 * tension_6 + t268 * tension_7 - t319;
    const real_t kkt_residual_0 = tb_max(tb_max(t447, TB_ABS(t450)), TB_ABS(t453));
    const real_t t454 = TB_C(2048.0) * TB_EPSILON / tb_min(TB_C(1.0), pivot[0]);
    const bool t455 = !(kkt_residual_0 <= tb_min(t454, TB_C(0.008)));
    if (t455) {
        tension[0] = TB_TENSION_MIN;
        tension[1] = TB_TENSION_MIN;
        tension[2] = TB_TENSION_MIN;
        tension[3] = TB_TENSION_MIN;
        tension[4] = TB_TENSION_MIN;
        tension[5] = TB_TENSION_MIN;
        tension[6] = TB_TENSION_MIN;
        tension[7] = TB_TENSION_MIN;
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        delivered[2] = TB_C(0.0);
        delivered[3] = TB_C(0.0);
        delivered[4] = TB_C(0.0);
        delivered[5] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return TB_INACCURATE;
    }
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    tension[4] = tension_4;
    tension[5] = tension_5;
    tension[6] = tension_6;
    tension[7] = tension_7;
    delivered[0] = delivered_0;
    delivered[1] = delivered_1;
    delivered[2] = delivered_2;
    delivered[3] = delivered_3;
    delivered[4] = delivered_4;
    delivered[5] = delivered_5;
    kkt_residual[0] = kkt_residual_0;
    return TB_OK;
}

tb_status tb_least_norm_tension(const real_t structure[48], const real_t wrench[6],
    real_t tension[8], real_t delivered[6], real_t kkt_residual[1])
{
    real_t pivot[1];
    real_t side[8];
    real_t moving[1];
    real_t push[1];
    real_t done[1] = {TB_C(0.0)};
    tb_status status = tb_least_norm_tension_begin(structure, wrench, pivot, side, moving,
        push);
    for (int steps = 0; steps < 40 && status == TB_OK && !(done[0] > TB_C(0.0)); steps++) {
        status = tb_least_norm_tension_step(structure, wrench, side, moving, push, done);
    }
    if (status == TB_OK && !(done[0] > TB_C(0.0))) {
        status = TB_INACCURATE;
    }
    if (status != TB_OK) {
        tension[0] = TB_TENSION_MIN;
        tension[1] = TB_TENSION_MIN;
        tension[2] = TB_TENSION_MIN;
        tension[3] = TB_TENSION_MIN;
        tension[4] = TB_TENSION_MIN;
        tension[5] = TB_TENSION_MIN;
        tension[6] = TB_TENSION_MIN;
        tension[7] = TB_TENSION_MIN;
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        delivered[2] = TB_C(0.0);
        delivered[3] = TB_C(0.0);
        delivered[4] = TB_C(0.0);
        delivered[5] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return status;
    }
    return tb_least_norm_tension_finish(structure, wrench, pivot, side, tension, delivered,
        kkt_residual);
}

/* Refuses with a status: pivot is 0; side is 0; moving is 0; push is 0 N. */
static tb_status tb_refuse_distribute_tension_paper_begin(tb_status status, real_t pivot[1],
    real_t side[8], real_t moving[1], real_t push[1])
{
    pivot[0] = TB_C(0.0);
    side[0] = TB_C(0.0);
    side[1] = TB_C(0.0);
    side[2] = TB_C(0.0);
    side[3] = TB_C(0.0);
    side[4] = TB_C(0.0);
    side[5] = TB_C(0.0);
    side[6] = TB_C(0.0);
    side[7] = TB_C(0.0);
    moving[0] = TB_C(0.0);
    push[0] = TB_C(0.0);
    return status;
}

/* All cables are free. */
static tb_status tb_distribute_tension_paper_begin(const real_t structure[48], const real_t wrench[6],
    real_t pivot[1], real_t side[8], real_t moving[1], real_t push[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) + TB_ABS(structure[10]) + TB_ABS(structure[11]) +
              TB_ABS(structure[12]) + TB_ABS(structure[13]) + TB_ABS(structure[14]) +
              TB_ABS(structure[15]) + TB_ABS(structure[16]) + TB_ABS(structure[17]) +
              TB_ABS(structure[18]) + TB_ABS(structure[19]) + TB_ABS(structure[20]) +
              TB_ABS(structure[21]) + TB_ABS(structure[22]) + TB_ABS(structure[23]) +
              TB_ABS(structure[24]) + TB_ABS(structure[25]) + TB_ABS(structure[26]) +
              TB_ABS(structure[27]) + TB_ABS(structure[28]) + TB_ABS(structure[29]) +
              TB_ABS(structure[30]) + TB_ABS(structure[31]) + TB_ABS(structure[32]) +
              TB_ABS(structure[33]) + TB_ABS(structure[34]) + TB_ABS(structure[35]) +
              TB_ABS(structure[36]) + TB_ABS(structure[37]) + TB_ABS(structure[38]) +
              TB_ABS(structure[39]) + TB_ABS(structure[40]) + TB_ABS(structure[41]) +
              TB_ABS(structure[42]) + TB_ABS(structure[43]) + TB_ABS(structure[44]) +
              TB_ABS(structure[45]) + TB_ABS(structure[46]) + TB_ABS(structure[47]) <=
              TB_C(192.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) + TB_ABS(wrench[2]) + TB_ABS(wrench[3]) +
              TB_ABS(wrench[4]) + TB_ABS(wrench[5]) <= TB_C(384000.0))) {
        return tb_refuse_distribute_tension_paper_begin(TB_OUT_OF_DOMAIN, pivot, side, moving, push);
    }
    const real_t t0 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t1 = t0 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t2 = t1 + structure[4] * structure[4] + structure[5] * structure[5];
    const real_t t3 = t2 + structure[6] * structure[6] + structure[7] * structure[7];
    const real_t t4 = TB_SQRT(t3);
    const real_t t5 = TB_COPYSIGN(t4, structure[0]);
    const real_t t6 = TB_ABS(t5);
    const real_t t7 = structure[0] + t5;
    const real_t t8 = t7 * structure[8] + structure[1] * structure[9] + structure[2] *
        structure[10];
    const real_t t9 = t8 + structure[3] * structure[11] + structure[4] * structure[12];
    const real_t t10 = t9 + structure[5] * structure[13] + structure[6] * structure[14];
    const real_t t11 = TB_C(1.0) / (t4 * (t4 + TB_ABS(structure[0])));
    const real_t t12 = (t10 + structure[7] * structure[15]) * t11;
    const real_t t13 = structure[9] - structure[1] * t12;
    const real_t t14 = structure[10] - structure[2] * t12;
    const real_t t15 = structure[11] - structure[3] * t12;
    const real_t t16 = structure[12] - structure[4] * t12;
    const real_t t17 = structure[13] - structure[5] * t12;
    const real_t t18 = t13 * t13 + t14 * t14 + t15 * t15 + t16 * t16 + t17 * t17;
    const real_t t19 = structure[14] - structure[6] * t12;
    const real_t t20 = structure[15] - structure[7] * t12;
    const real_t t21 = TB_SQRT(t18 + t19 * t19 + t20 * t20);
    const real_t t22 = TB_COPYSIGN(t21, t13);
    const real_t t23 = TB_ABS(t22);
    const real_t t24 = t7 * structure[16] + structure[1] * structure[17];
    const real_t t25 = t24 + structure[2] * structure[18] + structure[3] * structure[19];
    const real_t t26 = t25 + structure[4] * structure[20] + structure[5] * structure[21];
    const real_t t27 = t26 + structure[6] * structure[22] + structure[7] * structure[23];
    const real_t t28 = t11 * t27;
    const real_t t29 = structure[18] - structure[2] * t28;
    const real_t t30 = t13 + t22;
    const real_t t31 = t30 * (structure[17] - structure[1] * t28) + t14 * t29;
    const real_t t32 = structure[19] - structure[3] * t28;
    const real_t t33 = structure[20] - structure[4] * t28;
    const real_t t34 = structure[21] - structure[5] * t28;
    const real_t t35 = structure[22] - structure[6] * t28;
    const real_t t36 = t31 + t15 * t32 + t16 * t33 + t17 * t34 + t19 * t35;
    const real_t t37 = structure[23] - structure[7] * t28;
    const real_t t38 = TB_C(1.0) / (t21 * (t21 + TB_ABS(t13)));
    const real_t t39 = (t36 + t20 * t37) * t38;
    const real_t t40 = t29 - t14 * t39;
    const real_t t41 = t32 - t15 * t39;
    const real_t t42 = t33 - t16 * t39;
    const real_t t43 = t34 - t17 * t39;
    const real_t t44 = t35 - t19 * t39;
    const real_t t45 = t40 * t40 + t41 * t41 + t42 * t42 + t43 * t43 + t44 * t44;
    const real_t t46 = t37 - t20 * t39;
    const real_t t47 = TB_SQRT(t45 + t46 * t46);
    const real_t t48 = TB_COPYSIGN(t47, t40);
    const real_t t49 = TB_ABS(t48);
    const real_t t50 = TB_MOMENT_WEIGHT * structure[27];
    const real_t t51 = TB_MOMENT_WEIGHT * structure[25];
    const real_t t52 = t7 * (TB_MOMENT_WEIGHT * structure[24]) + structure[1] * t51;
    const real_t t53 = TB_MOMENT_WEIGHT * structure[26];
    const real_t t54 = TB_MOMENT_WEIGHT * structure[28];
    const real_t t55 = t52 + structure[2] * t53 + structure[3] * t50 + structure[4] * t54;
    const real_t t56 = TB_MOMENT_WEIGHT * structure[29];
    const real_t t57 = TB_MOMENT_WEIGHT * structure[30];
    const real_t t58 = TB_MOMENT_WEIGHT * structure[31];
    const real_t t59 = t55 + structure[5] * t56 + structure[6] * t57 + structure[7] * t58;
    const real_t t60 = t11 * t59;
    const real_t t61 = t50 - structure[3] * t60;
    const real_t t62 = t53 - structure[2] * t60;
    const real_t t63 = t30 * (t51 - structure[1] * t60) + t14 * t62 + t15 * t61;
    const real_t t64 = t54 - structure[4] * t60;
    const real_t t65 = t56 - structure[5] * t60;
    const real_t t66 = t57 - structure[6] * t60;
    const real_t t67 = t58 - structure[7] * t60;
    const real_t t68 = t63 + t16 * t64 + t17 * t65 + t19 * t66 + t20 * t67;
    const real_t t69 = t38 * t68;
    const real_t t70 = t61 - t15 * t69;
    const real_t t71 = t40 + t48;
    const real_t t72 = t64 - t16 * t69;
    const real_t t73 = t65 - t17 * t69;
    const real_t t74 = t71 * (t62 - t14 * t69) + t41 * t70 + t42 * t72 + t43 * t73;
    const real_t t75 = t66 - t19 * t69;
    const real_t t76 = t67 - t20 * t69;
    const real_t t77 = TB_C(1.0) / (t47 * (t47 + TB_ABS(t40)));
    const real_t t78 = (t74 + t44 * t75 + t46 * t76) * t77;
    const real_t t79 = t70 - t41 * t78;
    const real_t t80 = t72 - t42 * t78;
    const real_t t81 = t73 - t43 * t78;
    const real_t t82 = t75 - t44 * t78;
    const real_t t83 = t76 - t46 * t78;
    const real_t t84 = t79 * t79 + t80 * t80 + t81 * t81 + t82 * t82 + t83 * t83;
    const real_t t85 = TB_SQRT(t84);
    const real_t t86 = TB_COPYSIGN(t85, t79);
    const real_t t87 = TB_ABS(t86);
    const real_t t88 = TB_MOMENT_WEIGHT * structure[36];
    const real_t t89 = TB_MOMENT_WEIGHT * structure[33];
    const real_t t90 = t7 * (TB_MOMENT_WEIGHT * structure[32]) + structure[1] * t89;
    const real_t t91 = TB_MOMENT_WEIGHT * structure[34];
    const real_t t92 = TB_MOMENT_WEIGHT * structure[35];
    const real_t t93 = t90 + structure[2] * t91 + structure[3] * t92 + structure[4] * t88;
    const real_t t94 = TB_MOMENT_WEIGHT * structure[37];
    const real_t t95 = TB_MOMENT_WEIGHT * structure[38];
    const real_t t96 = TB_MOMENT_WEIGHT * structure[39];
    const real_t t97 = t93 + structure[5] * t94 + structure[6] * t95 + structure[7] * t96;
    const real_t t98 = t11 * t97;
    const real_t t99 = t88 - structure[4] * t98;
    const real_t t100 = t91 - structure[2] * t98;
    const real_t t101 = t92 - structure[3] * t98;
    const real_t t102 = t30 * (t89 - structure[1] * t98) + t14 * t100 + t15 * t101;
    const real_t t103 = t94 - structure[5] * t98;
    const real_t t104 = t95 - structure[6] * t98;
    const real_t t105 = t96 - structure[7] * t98;
    const real_t t106 = t102 + t16 * t99 + t17 * t103 + t19 * t104 + t20 * t105;
    const real_t t107 = t38 * t106;
    const real_t t108 = t99 - t16 * t107;
    const real_t t109 = t101 - t15 * t107;
    const real_t t110 = t71 * (t100 - t14 * t107) + t41 * t109 + t42 * t108;
    const real_t t111 = t103 - t17 * t107;
    const real_t t112 = t104 - t19 * t107;
    const real_t t113 = t105 - t20 * t107;
    const real_t t114 = t77 * (t110 + t43 * t111 + t44 * t112 + t46 * t113);
    const real_t t115 = t108 - t42 * t114;
    const real_t t116 = t79 + t86;
    const real_t t117 = t111 - t43 * t114;
    const real_t t118 = t116 * (t109 - t41 * t114) + t80 * t115 + t81 * t117;
    const real_t t119 = t112 - t44 * t114;
    const real_t t120 = t113 - t46 * t114;
    const real_t t121 = TB_C(1.0) / (t85 * (t85 + TB_ABS(t79)));
    const real_t t122 = (t118 + t82 * t119 + t83 * t120) * t121;
    const real_t t123 = t115 - t80 * t122;
    const real_t t124 = t117 - t81 * t122;
    const real_t t125 = t119 - t82 * t122;
    const real_t t126 = t120 - t83 * t122;
    const real_t t127 = t123 * t123 + t124 * t124 + t125 * t125 + t126 * t126;
    const real_t t128 = TB_SQRT(t127);
    const real_t t129 = TB_COPYSIGN(t128, t123);
    const real_t t130 = TB_ABS(t129);
    const real_t t131 = tb_min(tb_min(tb_min(tb_min(t6, t23), t49), t87), t130);
    const real_t t132 = TB_MOMENT_WEIGHT * structure[45];
    const real_t t133 = TB_MOMENT_WEIGHT * structure[41];
    const real_t t134 = t7 * (TB_MOMENT_WEIGHT * structure[40]) + structure[1] * t133;
    const real_t t135 = TB_MOMENT_WEIGHT * structure[42];
    const real_t t136 = TB_MOMENT_WEIGHT * structure[43];
    const real_t t137 = TB_MOMENT_WEIGHT * structure[44];
    const real_t t138 = t134 + structure[2] * t135 + structure[3] * t136 + structure[4] * t137;
    const real_t t139 = TB_MOMENT_WEIGHT * structure[46];
    const real_t t140 = TB_MOMENT_WEIGHT * structure[47];
    const real_t t141 = t138 + structure[5] * t132 + structure[6] * t139 + structure[7] * t140;
    const real_t t142 = t11 * t141;
    const real_t t143 = t132 - structure[5] * t142;
    const real_t t144 = t135 - structure[2] * t142;
    const real_t t145 = t136 - structure[3] * t142;
    const real_t t146 = t30 * (t133 - structure[1] * t142) + t14 * t144 + t15 * t145;
    const real_t t147 = t137 - structure[4] * t142;
    const real_t t148 = t139 - structure[6] * t142;
    const real_t t149 = t140 - structure[7] * t142;
    const real_t t150 = t146 + t16 * t147 + t17 * t143 + t19 * t148 + t20 * t149;
    const real_t t151 = t38 * t150;
    const real_t t152 = t143 - t17 * t151;
    const real_t t153 = t145 - t15 * t151;
    const real_t t154 = t147 - t16 * t151;
    const real_t t155 = t71 * (t144 - t14 * t151) + t41 * t153 + t42 * t154;
    const real_t t156 = t148 - t19 * t151;
    const real_t t157 = t149 - t20 * t151;
    const real_t t158 = t77 * (t155 + t43 * t152 + t44 * t156 + t46 * t157);
    const real_t t159 = t152 - t43 * t158;
    const real_t t160 = t154 - t42 * t158;
    const real_t t161 = t116 * (t153 - t41 * t158) + t80 * t160 + t81 * t159;
    const real_t t162 = t156 - t44 * t158;
    const real_t t163 = t157 - t46 * t158;
    const real_t t164 = t121 * (t161 + t82 * t162 + t83 * t163);
    const real_t t165 = t159 - t81 * t164;
    const real_t t166 = (t123 + t129) * (t160 - t80 * t164) + t124 * t165;
    const real_t t167 = t162 - t82 * t164;
    const real_t t168 = t163 - t83 * t164;
    const real_t t169 = (t166 + t125 * t167 + t126 * t168) * (TB_C(1.0) / (t128 * (t128 +
        TB_ABS(t123))));
    const real_t t170 = t165 - t124 * t169;
    const real_t t171 = t167 - t125 * t169;
    const real_t t172 = t168 - t126 * t169;
    const real_t t173 = TB_COPYSIGN(TB_SQRT(t170 * t170 + t171 * t171 + t172 * t172), t170);
    const real_t t174 = TB_ABS(t173);
    const real_t pivot_0 = tb_min(t131, t174);
    const real_t t175 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const bool t176 = t175 < t6 && t175 < t23 && t175 < t49 && t175 < t87;
    const bool t177 = !(t176 && t175 < t130 && t175 < t174);
    if (t177) {
        return tb_refuse_distribute_tension_paper_begin(TB_SINGULAR, pivot, side, moving, push);
    }
    pivot[0] = pivot_0;
    side[0] = TB_C(0.0);
    side[1] = TB_C(0.0);
    side[2] = TB_C(0.0);
    side[3] = TB_C(0.0);
    side[4] = TB_C(0.0);
    side[5] = TB_C(0.0);
    side[6] = TB_C(0.0);
    side[7] = TB_C(0.0);
    moving[0] = -TB_C(1.0);
    push[0] = TB_C(0.0);
    return TB_OK;
}

/* Moves a cable towards its bounds, until it is held or another one is freed. */
static tb_status tb_distribute_tension_paper_step(const real_t structure[48], const real_t wrench[6],
    real_t side[8], real_t moving[1], real_t push[1], real_t done[1])
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
    const bool t10 = TB_C(0.0) == side[5];
    const real_t t11 = t10 ? TB_C(1.0) : TB_C(0.0);
    const bool t12 = TB_C(0.0) == side[6];
    const real_t t13 = t12 ? TB_C(1.0) : TB_C(0.0);
    const bool t14 = TB_C(0.0) == side[7];
    const real_t t15 = t14 ? TB_C(1.0) : TB_C(0.0);
    const bool t16 = TB_C(6.0) < t1 + t3 + t5 + t7 + t9 + t11 + t13 + t15;
    const real_t t17 = t0 ? (t0 ? structure[0] * structure[0] : TB_C(0.0)) : TB_C(0.0);
    const real_t t18 = t2 ? (t2 ? structure[1] * structure[1] : TB_C(0.0)) : TB_C(0.0);
    const real_t t19 = t4 ? (t4 ? structure[2] * structure[2] : TB_C(0.0)) : TB_C(0.0);
    const real_t t20 = t6 ? (t6 ? structure[3] * structure[3] : TB_C(0.0)) : TB_C(0.0);
    const real_t t21 = t8 ? (t8 ? structure[4] * structure[4] : TB_C(0.0)) : TB_C(0.0);
    const real_t t22 = t10 ? (t10 ? structure[5] * structure[5] : TB_C(0.0)) : TB_C(0.0);
    const real_t t23 = t12 ? (t12 ? structure[6] * structure[6] : TB_C(0.0)) : TB_C(0.0);
    const real_t t24 = t14 ? (t14 ? structure[7] * structure[7] : TB_C(0.0)) : TB_C(0.0);
    const real_t t25 = TB_SQRT(t17 + t18 + t19 + t20 + t21 + t22 + t23 + t24);
    const real_t t26 = t0 ? structure[0] : TB_C(0.0);
    const real_t t27 = TB_COPYSIGN(t25, t26);
    const real_t t28 = t26 + t27;
    const real_t t29 = t2 ? (t2 ? structure[1] * structure[9] : TB_C(0.0)) : TB_C(0.0);
    const real_t t30 = t4 ? (t4 ? structure[2] * structure[10] : TB_C(0.0)) : TB_C(0.0);
    const real_t t31 = (t0 ? t28 * structure[8] : TB_C(0.0)) + t29 + t30;
    const real_t t32 = t6 ? (t6 ? structure[3] * structure[11] : TB_C(0.0)) : TB_C(0.0);
    const real_t t33 = t8 ? (t8 ? structure[4] * structure[12] : TB_C(0.0)) : TB_C(0.0);
    const real_t t34 = t10 ? (t10 ? structure[5] * structure[13] : TB_C(0.0)) : TB_C(0.0);
    const real_t t35 = t12 ? (t12 ? structure[6] * structure[14] : TB_C(0.0)) : TB_C(0.0);
    const real_t t36 = t14 ? (t14 ? structure[7] * structure[15] : TB_C(0.0)) : TB_C(0.0);
    const real_t t37 = TB_C(1.0) / (t25 * (t25 + TB_ABS(t26)));
    const real_t t38 = (t31 + t32 + t33 + t34 + t35 + t36) * t37;
    const real_t t39 = structure[9] - structure[1] * t38;
    const real_t t40 = structure[10] - structure[2] * t38;
    const real_t t41 = (t2 ? (t2 ? t39 * t39 : TB_C(0.0)) : TB_C(0.0)) + (t4 ? (t4 ? t40 * t40
        : TB_C(0.0)) : TB_C(0.0));
    const real_t t42 = structure[11] - structure[3] * t38;
    const real_t t43 = t41 + (t6 ? (t6 ? t42 * t42 : TB_C(0.0)) : TB_C(0.0));
    const real_t t44 = structure[12] - structure[4] * t38;
    const real_t t45 = t43 + (t8 ? (t8 ? t44 * t44 : TB_C(0.0)) : TB_C(0.0));
    const real_t t46 = structure[13] - structure[5] * t38;
    const real_t t47 = t45 + (t10 ? (t10 ? t46 * t46 : TB_C(0.0)) : TB_C(0.0));
    const real_t t48 = structure[14] - structure[6] * t38;
    const real_t t49 = t47 + (t12 ? (t12 ? t48 * t48 : TB_C(0.0)) : TB_C(0.0));
    const real_t t50 = structure[15] - structure[7] * t38;
    const real_t t51 = t49 + (t14 ? (t14 ? t50 * t50 : TB_C(0.0)) : TB_C(0.0));
    const real_t t52 = TB_SQRT(t51);
    const real_t t53 = t2 ? t39 : TB_C(0.0);
    const real_t t54 = TB_COPYSIGN(t52, t53);
    const real_t t55 = t2 ? (t2 ? structure[1] * structure[17] : TB_C(0.0)) : TB_C(0.0);
    const real_t t56 = t4 ? (t4 ? structure[2] * structure[18] : TB_C(0.0)) : TB_C(0.0);
    const real_t t57 = (t0 ? t28 * structure[16] : TB_C(0.0)) + t55 + t56;
    const real_t t58 = t6 ? (t6 ? structure[3] * structure[19] : TB_C(0.0)) : TB_C(0.0);
    const real_t t59 = t8 ? (t8 ? structure[4] * structure[20] : TB_C(0.0)) : TB_C(0.0);
    const real_t t60 = t10 ? (t10 ? structure[5] * structure[21] : TB_C(0.0)) : TB_C(0.0);
    const real_t t61 = t12 ? (t12 ? structure[6] * structure[22] : TB_C(0.0)) : TB_C(0.0);
    const real_t t62 = t14 ? (t14 ? structure[7] * structure[23] : TB_C(0.0)) : TB_C(0.0);
    const real_t t63 = t37 * (t57 + t58 + t59 + t60 + t61 + t62);
    const real_t t64 = structure[18] - structure[2] * t63;
    const real_t t65 = t53 + t54;
    const real_t t66 = structure[17] - structure[1] * t63;
    const real_t t67 = (t2 ? t65 * t66 : TB_C(0.0)) + (t4 ? (t4 ? t40 * t64 : TB_C(0.0)) :
        TB_C(0.0));
    const real_t t68 = structure[19] - structure[3] * t63;
    const real_t t69 = t67 + (t6 ? (t6 ? t42 * t68 : TB_C(0.0)) : TB_C(0.0));
    const real_t t70 = structure[20] - structure[4] * t63;
    const real_t t71 = t69 + (t8 ? (t8 ? t44 * t70 : TB_C(0.0)) : TB_C(0.0));
    const real_t t72 = structure[21] - structure[5] * t63;
    const real_t t73 = t71 + (t10 ? (t10 ? t46 * t72 : TB_C(0.0)) : TB_C(0.0));
    const real_t t74 = structure[22] - structure[6] * t63;
    const real_t t75 = t73 + (t12 ? (t12 ? t48 * t74 : TB_C(0.0)) : TB_C(0.0));
    const real_t t76 = structure[23] - structure[7] * t63;
    const real_t t77 = t75 + (t14 ? (t14 ? t50 * t76 : TB_C(0.0)) : TB_C(0.0));
    const real_t t78 = TB_C(1.0) / (t52 * (t52 + TB_ABS(t53)));
    const real_t t79 = t77 * t78;
    const real_t t80 = t64 - t40 * t79;
    const real_t t81 = t68 - t42 * t79;
    const real_t t82 = (t4 ? (t4 ? t80 * t80 : TB_C(0.0)) : TB_C(0.0)) + (t6 ? (t6 ? t81 * t81
        : TB_C(0.0)) : TB_C(0.0));
    const real_t t83 = t70 - t44 * t79;
    const real_t t84 = t82 + (t8 ? (t8 ? t83 * t83 : TB_C(0.0)) : TB_C(0.0));
    const real_t t85 = t72 - t46 * t79;
    const real_t t86 = t84 + (t10 ? (t10 ? t85 * t85 : TB_C(0.0)) : TB_C(0.0));
    const real_t t87 = t74 - t48 * t79;
    const real_t t88 = t86 + (t12 ? (t12 ? t87 * t87 : TB_C(0.0)) : TB_C(0.0));
    const real_t t89 = t76 - t50 * t79;
    const real_t t90 = t88 + (t14 ? (t14 ? t89 * t89 : TB_C(0.0)) : TB_C(0.0));
    const real_t t91 = TB_SQRT(t90);
    const real_t t92 = t4 ? t80 : TB_C(0.0);
    const real_t t93 = TB_COPYSIGN(t91, t92);
    const real_t t94 = tb_min(tb_min(TB_ABS(t27), TB_ABS(t54)), TB_ABS(t93));
    const real_t t95 = TB_MOMENT_WEIGHT * structure[27];
    const real_t t96 = TB_MOMENT_WEIGHT * structure[24];
    const real_t t97 = TB_MOMENT_WEIGHT * structure[25];
    const real_t t98 = t2 ? (t2 ? structure[1] * t97 : TB_C(0.0)) : TB_C(0.0);
    const real_t t99 = TB_MOMENT_WEIGHT * structure[26];
    const real_t t100 = t4 ? (t4 ? structure[2] * t99 : TB_C(0.0)) : TB_C(0.0);
    const real_t t101 = t6 ? (t6 ? structure[3] * t95 : TB_C(0.0)) : TB_C(0.0);
    const real_t t102 = TB_MOMENT_WEIGHT * structure[28];
    const real_t t103 = t8 ? (t8 ? structure[4] * t102 : TB_C(0.0)) : TB_C(0.0);
    const real_t t104 = (t0 ? t28 * t96 : TB_C(0.0)) + t98 + t100 + t101 + t103;
    const real_t t105 = TB_MOMENT_WEIGHT * structure[29];
    const real_t t106 = t10 ? (t10 ? structure[5] * t105 : TB_C(0.0)) : TB_C(0.0);
    const real_t t107 = TB_MOMENT_WEIGHT * structure[30];
    const real_t t108 = t12 ? (t12 ? structure[6] * t107 : TB_C(0.0)) : TB_C(0.0);
    const real_t t109 = TB_MOMENT_WEIGHT * structure[31];
    const real_t t110 = t14 ? (t14 ? structure[7] * t109 : TB_C(0.0)) : TB_C(0.0);
    const real_t t111 = t37 * (t104 + t106 + t108 + t110);
    const real_t t112 = t95 - structure[3] * t111;
    const real_t t113 = t97 - structure[1] * t111;
    const real_t t114 = t99 - structure[2] * t111;
    const real_t t115 = (t2 ? t65 * t113 : TB_C(0.0)) + (t4 ? (t4 ? t40 * t114 : TB_C(0.0)) :
        TB_C(0.0));
    const real_t t116 = t115 + (t6 ? (t6 ? t42 * t112 : TB_C(0.0)) : TB_C(0.0));
    const real_t t117 = t102 - structure[4] * t111;
    const real_t t118 = t116 + (t8 ? (t8 ? t44 * t117 : TB_C(0.0)) : TB_C(0.0));
    const real_t t119 = t105 - structure[5] * t111;
    const real_t t120 = t118 + (t10 ? (t10 ? t46 * t119 : TB_C(0.0)) : TB_C(0.0));
    const real_t t121 = t107 - structure[6] * t111;
    const real_t t122 = t120 + (t12 ? (t12 ? t48 * t121 : TB_C(0.0)) : TB_C(0.0));
    const real_t t123 = t109 - structure[7] * t111;
    const real_t t124 = t122 + (t14 ? (t14 ? t50 * t123 : TB_C(0.0)) : TB_C(0.0));
    const real_t t125 = t78 * t124;
    const real_t t126 = t112 - t42 * t125;
    const real_t t127 = t92 + t93;
    const real_t t128 = t114 - t40 * t125;
    const real_t t129 = (t4 ? t127 * t128 : TB_C(0.0)) + (t6 ? (t6 ? t81 * t126 : TB_C(0.0)) :
        TB_C(0.0));
    const real_t t130 = t117 - t44 * t125;
    const real_t t131 = t129 + (t8 ? (t8 ? t83 * t130 : TB_C(0.0)) : TB_C(0.0));
    const real_t t132 = t119 - t46 * t125;
    const real_t t133 = t131 + (t10 ? (t10 ? t85 * t132 : TB_C(0.0)) : TB_C(0.0));
    const real_t t134 = t121 - t48 * t125;
    const real_t t135 = t133 + (t12 ? (t12 ? t87 * t134 : TB_C(0.0)) : TB_C(0.0));
    const real_t t136 = t123 - t50 * t125;
    const real_t t137 = t135 + (t14 ? (t14 ? t89 * t136 : TB_C(0.0)) : TB_C(0.0));
    const real_t t138 = TB_C(1.0) / (t91 * (t91 + TB_ABS(t92)));
    const real_t t139 = t137 * t138;
    const real_t t140 = t126 - t81 * t139;
    const real_t t141 = t130 - t83 * t139;
    const real_t t142 = (t6 ? (t6 ? t140 * t140 : TB_C(0.0)) : TB_C(0.0)) + (t8 ? (t8 ? t141 *
        t141 : TB_C(0.0)) : TB_C(0.0));
    const real_t t143 = t132 - t85 * t139;
    const real_t t144 = t10 ? (t10 ? t143 * t143 : TB_C(0.0)) : TB_C(0.0);
    const real_t t145 = t134 - t87 * t139;
    const real_t t146 = t12 ? (t12 ? t145 * t145 : TB_C(0.0)) : TB_C(0.0);
    const real_t t147 = t136 - t89 * t139;
    const real_t t148 = t14 ? (t14 ? t147 * t147 : TB_C(0.0)) : TB_C(0.0);
    const real_t t149 = TB_SQRT(t142 + t144 + t146 + t148);
    const real_t t150 = t6 ? t140 : TB_C(0.0);
    const real_t t151 = TB_COPYSIGN(t149, t150);
    const real_t t152 = TB_MOMENT_WEIGHT * structure[36];
    const real_t t153 = TB_MOMENT_WEIGHT * structure[32];
    const real_t t154 = TB_MOMENT_WEIGHT * structure[33];
    const real_t t155 = t2 ? (t2 ? structure[1] * t154 : TB_C(0.0)) : TB_C(0.0);
    const real_t t156 = TB_MOMENT_WEIGHT * structure[34];
    const real_t t157 = t4 ? (t4 ? structure[2] * t156 : TB_C(0.0)) : TB_C(0.0);
    const real_t t158 = TB_MOMENT_WEIGHT * structure[35];
    const real_t t159 = t6 ? (t6 ? structure[3] * t158 : TB_C(0.0)) : TB_C(0.0);
    const real_t t160 = (t0 ? t28 * t153 : TB_C(0.0)) + t155 + t157 + t159;
    const real_t t161 = t8 ? (t8 ? structure[4] * t152 : TB_C(0.0)) : TB_C(0.0);
    const real_t t162 = TB_MOMENT_WEIGHT * structure[37];
    const real_t t163 = t10 ? (t10 ? structure[5] * t162 : TB_C(0.0)) : TB_C(0.0);
    const real_t t164 = TB_MOMENT_WEIGHT * structure[38];
    const real_t t165 = t12 ? (t12 ? structure[6] * t164 : TB_C(0.0)) : TB_C(0.0);
    const real_t t166 = TB_MOMENT_WEIGHT * structure[39];
    const real_t t167 = t14 ? (t14 ? structure[7] * t166 : TB_C(0.0)) : TB_C(0.0);
    const real_t t168 = t37 * (t160 + t161 + t163 + t165 + t167);
    const real_t t169 = t152 - structure[4] * t168;
    const real_t t170 = t154 - structure[1] * t168;
    const real_t t171 = t156 - structure[2] * t168;
    const real_t t172 = (t2 ? t65 * t170 : TB_C(0.0)) + (t4 ? (t4 ? t40 * t171 : TB_C(0.0)) :
        TB_C(0.0));
    const real_t t173 = t158 - structure[3] * t168;
    const real_t t174 = t172 + (t6 ? (t6 ? t42 * t173 : TB_C(0.0)) : TB_C(0.0));
    const real_t t175 = t174 + (t8 ? (t8 ? t44 * t169 : TB_C(0.0)) : TB_C(0.0));
    const real_t t176 = t162 - structure[5] * t168;
    const real_t t177 = t175 + (t10 ? (t10 ? t46 * t176 : TB_C(0.0)) : TB_C(0.0));
    const real_t t178 = t164 - structure[6] * t168;
    const real_t t179 = t177 + (t12 ? (t12 ? t48 * t178 : TB_C(0.0)) : TB_C(0.0));
    const real_t t180 = t166 - structure[7] * t168;
    const real_t t181 = t179 + (t14 ? (t14 ? t50 * t180 : TB_C(0.0)) : TB_C(0.0));
    const real_t t182 = t78 * t181;
    const real_t t183 = t169 - t44 * t182;
    const real_t t184 = t171 - t40 * t182;
    const real_t t185 = t173 - t42 * t182;
    const real_t t186 = (t4 ? t127 * t184 : TB_C(0.0)) + (t6 ? (t6 ? t81 * t185 : TB_C(0.0)) :
        TB_C(0.0));
    const real_t t187 = t186 + (t8 ? (t8 ? t83 * t183 : TB_C(0.0)) : TB_C(0.0));
    const real_t t188 = t176 - t46 * t182;
    const real_t t189 = t187 + (t10 ? (t10 ? t85 * t188 : TB_C(0.0)) : TB_C(0.0));
    const real_t t190 = t178 - t48 * t182;
    const real_t t191 = t189 + (t12 ? (t12 ? t87 * t190 : TB_C(0.0)) : TB_C(0.0));
    const real_t t192 = t180 - t50 * t182;
    const real_t t193 = t191 + (t14 ? (t14 ? t89 * t192 : TB_C(0.0)) : TB_C(0.0));
    const real_t t194 = t138 * t193;
    const real_t t195 = t183 - t83 * t194;
    const real_t t196 = t150 + t151;
    const real_t t197 = t185 - t81 * t194;
    const real_t t198 = (t6 ? t196 * t197 : TB_C(0.0)) + (t8 ? (t8 ? t141 * t195 : TB_C(0.0)) :
        TB_C(0.0));
    const real_t t199 = t188 - t85 * t194;
    const real_t t200 = t10 ? (t10 ? t143 * t199 : TB_C(0.0)) : TB_C(0.0);
    const real_t t201 = t190 - t87 * t194;
    const real_t t202 = t12 ? (t12 ? t145 * t201 : TB_C(0.0)) : TB_C(0.0);
    const real_t t203 = t192 - t89 * t194;
    const real_t t204 = t14 ? (t14 ? t147 * t203 : TB_C(0.0)) : TB_C(0.0);
    const real_t t205 = TB_C(1.0) / (t149 * (t149 + TB_ABS(t150)));
    const real_t t206 = (t198 + t200 + t202 + t204) * t205;
    const real_t t207 = t195 - t141 * t206;
    const real_t t208 = t199 - t143 * t206;
    const real_t t209 = t10 ? (t10 ? t208 * t208 : TB_C(0.0)) : TB_C(0.0);
    const real_t t210 = (t8 ? (t8 ? t207 * t207 : TB_C(0.0)) : TB_C(0.0)) + t209;
    const real_t t211 = t201 - t145 * t206;
    const real_t t212 = t12 ? (t12 ? t211 * t211 : TB_C(0.0)) : TB_C(0.0);
    const real_t t213 = t203 - t147 * t206;
    const real_t t214 = t14 ? (t14 ? t213 * t213 : TB_C(0.0)) : TB_C(0.0);
    const real_t t215 = TB_SQRT(t210 + t212 + t214);
    const real_t t216 = t8 ? t207 : TB_C(0.0);
    const real_t t217 = TB_COPYSIGN(t215, t216);
    const real_t t218 = TB_MOMENT_WEIGHT * structure[45];
    const real_t t219 = TB_MOMENT_WEIGHT * structure[40];
    const real_t t220 = TB_MOMENT_WEIGHT * structure[41];
    const real_t t221 = t2 ? (t2 ? structure[1] * t220 : TB_C(0.0)) : TB_C(0.0);
    const real_t t222 = TB_MOMENT_WEIGHT * structure[42];
    const real_t t223 = t4 ? (t4 ? structure[2] * t222 : TB_C(0.0)) : TB_C(0.0);
    const real_t t224 = TB_MOMENT_WEIGHT * structure[43];
    const real_t t225 = t6 ? (t6 ? structure[3] * t224 : TB_C(0.0)) : TB_C(0.0);
    const real_t t226 = (t0 ? t28 * t219 : TB_C(0.0)) + t221 + t223 + t225;
    const real_t t227 = TB_MOMENT_WEIGHT * structure[44];
    const real_t t228 = t8 ? (t8 ? structure[4] * t227 : TB_C(0.0)) : TB_C(0.0);
    const real_t t229 = t10 ? (t10 ? structure[5] * t218 : TB_C(0.0)) : TB_C(0.0);
    const real_t t230 = TB_MOMENT_WEIGHT * structure[46];
    const real_t t231 = t12 ? (t12 ? structure[6] * t230 : TB_C(0.0)) : TB_C(0.0);
    const real_t t232 = TB_MOMENT_WEIGHT * structure[47];
    const real_t t233 = t14 ? (t14 ? structure[7] * t232 : TB_C(0.0)) : TB_C(0.0);
    const real_t t234 = t37 * (t226 + t228 + t229 + t231 + t233);
    const real_t t235 = t218 - structure[5] * t234;
    const real_t t236 = t220 - structure[1] * t234;
    const real_t t237 = t222 - structure[2] * t234;
    const real_t t238 = (t2 ? t65 * t236 : TB_C(0.0)) + (t4 ? (t4 ? t40 * t237 : TB_C(0.0)) :
        TB_C(0.0));
    const real_t t239 = t224 - structure[3] * t234;
    const real_t t240 = t238 + (t6 ? (t6 ? t42 * t239 : TB_C(0.0)) : TB_C(0.0));
    const real_t t241 = t227 - structure[4] * t234;
    const real_t t242 = t240 + (t8 ? (t8 ? t44 * t241 : TB_C(0.0)) : TB_C(0.0));
    const real_t t243 = t242 + (t10 ? (t10 ? t46 * t235 : TB_C(0.0)) : TB_C(0.0));
    const real_t t244 = t230 - structure[6] * t234;
    const real_t t245 = t243 + (t12 ? (t12 ? t48 * t244 : TB_C(0.0)) : TB_C(0.0));
    const real_t t246 = t232 - structure[7] * t234;
    const real_t t247 = t245 + (t14 ? (t14 ? t50 * t246 : TB_C(0.0)) : TB_C(0.0));
    const real_t t248 = t78 * t247;
    const real_t t249 = t235 - t46 * t248;
    const real_t t250 = t237 - t40 * t248;
    const real_t t251 = t239 - t42 * t248;
    const real_t t252 = (t4 ? t127 * t250 : TB_C(0.0)) + (t6 ? (t6 ? t81 * t251 : TB_C(0.0)) :
        TB_C(0.0));
    const real_t t253 = t241 - t44 * t248;
    const real_t t254 = t252 + (t8 ? (t8 ? t83 * t253 : TB_C(0.0)) : TB_C(0.0));
    const real_t t255 = t254 + (t10 ? (t10 ? t85 * t249 : TB_C(0.0)) : TB_C(0.0));
    const real_t t256 = t244 - t48 * t248;
    const real_t t257 = t255 + (t12 ? (t12 ? t87 * t256 : TB_C(0.0)) : TB_C(0.0));
    const real_t t258 = t246 - t50 * t248;
    const real_t t259 = t257 + (t14 ? (t14 ? t89 * t258 : TB_C(0.0)) : TB_C(0.0));
    const real_t t260 = t138 * t259;
    const real_t t261 = t249 - t85 * t260;
    const real_t t262 = t251 - t81 * t260;
    const real_t t263 = t253 - t83 * t260;
    const real_t t264 = (t6 ? t196 * t262 : TB_C(0.0)) + (t8 ? (t8 ? t141 * t263 : TB_C(0.0)) :
        TB_C(0.0));
    const real_t t265 = t10 ? (t10 ? t143 * t261 : TB_C(0.0)) : TB_C(0.0);
    const real_t t266 = t256 - t87 * t260;
    const real_t t267 = t12 ? (t12 ? t145 * t266 : TB_C(0.0)) : TB_C(0.0);
    const real_t t268 = t258 - t89 * t260;
    const real_t t269 = t14 ? (t14 ? t147 * t268 : TB_C(0.0)) : TB_C(0.0);
    const real_t t270 = t205 * (t264 + t265 + t267 + t269);
    const real_t t271 = t261 - t143 * t270;
    const real_t t272 = t216 + t217;
    const real_t t273 = t263 - t141 * t270;
    const real_t t274 = t10 ? (t10 ? t208 * t271 : TB_C(0.0)) : TB_C(0.0);
    const real_t t275 = t266 - t145 * t270;
    const real_t t276 = t12 ? (t12 ? t211 * t275 : TB_C(0.0)) : TB_C(0.0);
    const real_t t277 = t268 - t147 * t270;
    const real_t t278 = t14 ? (t14 ? t213 * t277 : TB_C(0.0)) : TB_C(0.0);
    const real_t t279 = (t8 ? t272 * t273 : TB_C(0.0)) + t274 + t276 + t278;
    const real_t t280 = t279 * (TB_C(1.0) / (t215 * (t215 + TB_ABS(t216))));
    const real_t t281 = t271 - t208 * t280;
    const real_t t282 = t10 ? (t10 ? t281 * t281 : TB_C(0.0)) : TB_C(0.0);
    const real_t t283 = t275 - t211 * t280;
    const real_t t284 = t12 ? (t12 ? t283 * t283 : TB_C(0.0)) : TB_C(0.0);
    const real_t t285 = t277 - t213 * t280;
    const real_t t286 = t14 ? (t14 ? t285 * t285 : TB_C(0.0)) : TB_C(0.0);
    const real_t t287 = TB_COPYSIGN(TB_SQRT(t282 + t284 + t286), t10 ? t281 : TB_C(0.0));
    const real_t t288 = tb_min(tb_min(tb_min(t94, TB_ABS(t151)), TB_ABS(t217)), TB_ABS(t287));
    const real_t t289 = TB_C(1.0) / tb_min(TB_C(1.0), t288);
    const real_t t290 = TB_C(64.0) * TB_EPSILON * t289;
    const bool t291 = TB_C(0.0) <= moving[0];
    const real_t t292 = TB_C(1.0) / t27;
    const real_t t293 = TB_C(0.0) < side[0] ? TB_C(1000000000000.0) : (side[0] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t294 = TB_C(0.0) < side[1] ? TB_C(1000000000000.0) : (side[1] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t295 = TB_C(0.0) < side[2] ? TB_C(1000000000000.0) : (side[2] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t296 = structure[0] * t293 + structure[1] * t294 + structure[2] * t295;
    const real_t t297 = TB_C(0.0) < side[3] ? TB_C(1000000000000.0) : (side[3] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t298 = TB_C(0.0) < side[4] ? TB_C(1000000000000.0) : (side[4] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t299 = TB_C(0.0) < side[5] ? TB_C(1000000000000.0) : (side[5] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t300 = t296 + structure[3] * t297 + structure[4] * t298 + structure[5] * t299;
    const real_t t301 = TB_C(0.0) < side[6] ? TB_C(1000000000000.0) : (side[6] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t302 = TB_C(0.0) < side[7] ? TB_C(1000000000000.0) : (side[7] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t303 = wrench[0] - (t300 + structure[6] * t301 + structure[7] * t302);
    const real_t t304 = t303 * t292;
    const real_t t305 = (t0 ? structure[8] : TB_C(0.0)) - t28 * t38;
    const real_t t306 = TB_C(1.0) / t54;
    const real_t t307 = structure[8] * t293 + structure[9] * t294 + structure[10] * t295;
    const real_t t308 = t307 + structure[11] * t297 + structure[12] * t298;
    const real_t t309 = t308 + structure[13] * t299 + structure[14] * t301;
    const real_t t310 = wrench[1] - (t309 + structure[15] * t302) + t304 * t305;
    const real_t t311 = t310 * t306;
    const real_t t312 = (t2 ? t66 : TB_C(0.0)) - t65 * t79;
    const real_t t313 = TB_C(1.0) / t93;
    const real_t t314 = structure[16] * t293 + structure[17] * t294 + structure[18] * t295;
    const real_t t315 = t314 + structure[19] * t297 + structure[20] * t298;
    const real_t t316 = t315 + structure[21] * t299 + structure[22] * t301;
    const real_t t317 = (t0 ? structure[16] : TB_C(0.0)) - t28 * t63;
    const real_t t318 = wrench[2] - (t316 + structure[23] * t302) + t304 * t317;
    const real_t t319 = (t318 + t311 * t312) * t313;
    const real_t t320 = (t4 ? t128 : TB_C(0.0)) - t127 * t139;
    const real_t t321 = TB_C(1.0) / t151;
    const real_t t322 = TB_MOMENT_WEIGHT * wrench[3];
    const real_t t323 = t96 * t293 + t97 * t294 + t99 * t295 + t95 * t297;
    const real_t t324 = t323 + t102 * t298 + t105 * t299 + t107 * t301 + t109 * t302;
    const real_t t325 = (t0 ? t96 : TB_C(0.0)) - t28 * t111;
    const real_t t326 = (t2 ? t113 : TB_C(0.0)) - t65 * t125;
    const real_t t327 = t322 - t324 + t304 * t325 + t311 * t326 + t319 * t320;
    const real_t t328 = t327 * t321;
    const real_t t329 = (t6 ? t197 : TB_C(0.0)) - t196 * t206;
    const real_t t330 = TB_C(1.0) / t217;
    const real_t t331 = TB_MOMENT_WEIGHT * wrench[4];
    const real_t t332 = t153 * t293 + t154 * t294 + t156 * t295 + t158 * t297;
    const real_t t333 = t332 + t152 * t298 + t162 * t299 + t164 * t301 + t166 * t302;
    const real_t t334 = (t0 ? t153 : TB_C(0.0)) - t28 * t168;
    const real_t t335 = (t2 ? t170 : TB_C(0.0)) - t65 * t182;
    const real_t t336 = (t4 ? t184 : TB_C(0.0)) - t127 * t194;
    const real_t t337 = t331 - t333 + t304 * t334 + t311 * t335 + t319 * t336;
    const real_t t338 = (t337 + t328 * t329) * t330;
    const real_t t339 = (t8 ? t273 : TB_C(0.0)) - t272 * t280;
    const real_t t340 = TB_C(1.0) / t287;
    const real_t t341 = TB_MOMENT_WEIGHT * wrench[5];
    const real_t t342 = t219 * t293 + t220 * t294 + t222 * t295 + t224 * t297;
    const real_t t343 = t342 + t227 * t298 + t218 * t299 + t230 * t301 + t232 * t302;
    const real_t t344 = (t0 ? t219 : TB_C(0.0)) - t28 * t234;
    const real_t t345 = (t2 ? t236 : TB_C(0.0)) - t65 * t248;
    const real_t t346 = (t4 ? t250 : TB_C(0.0)) - t127 * t260;
    const real_t t347 = t341 - t343 + t304 * t344 + t311 * t345 + t319 * t346;
    const real_t t348 = (t6 ? t262 : TB_C(0.0)) - t196 * t270;
    const real_t t349 = t340 * ((t347 + t328 * t348 + t338 * t339) * t340);
    const real_t t350 = t330 * (t338 + t339 * t349);
    const real_t t351 = t321 * (t328 + t329 * t350 + t348 * t349);
    const real_t t352 = t313 * (t319 + t320 * t351 + t336 * t350 + t346 * t349);
    const real_t t353 = t311 + t312 * t352 + t326 * t351 + t335 * t350 + t345 * t349;
    const real_t t354 = t306 * t353;
    const real_t t355 = t304 + t305 * t354 + t317 * t352 + t325 * t351 + t334 * t350;
    const real_t t356 = t292 * (t355 + t344 * t349);
    const real_t t357 = structure[4] * t356 + structure[12] * t354 + structure[20] * t352;
    const real_t t358 = t357 + t102 * t351 + t152 * t350 + t227 * t349;
    const real_t t359 = tb_max(TB_TENSION_MIN - t358, t358 - TB_C(1000000000000.0));
    const real_t t360 = TB_C(0.0) < t9 ? t359 : -TB_C(1.0);
    const real_t t361 = structure[5] * t356 + structure[13] * t354 + structure[21] * t352;
    const real_t t362 = t361 + t105 * t351 + t162 * t350 + t218 * t349;
    const real_t t363 = tb_max(TB_TENSION_MIN - t362, t362 - TB_C(1000000000000.0));
    const real_t t364 = TB_C(0.0) < t11 ? t363 : -TB_C(1.0);
    const real_t t365 = structure[6] * t356 + structure[14] * t354 + structure[22] * t352;
    const real_t t366 = t365 + t107 * t351 + t164 * t350 + t230 * t349;
    const real_t t367 = tb_max(TB_TENSION_MIN - t366, t366 - TB_C(1000000000000.0));
    const real_t t368 = TB_C(0.0) < t13 ? t367 : -TB_C(1.0);
    const real_t t369 = structure[7] * t356 + structure[15] * t354 + structure[23] * t352;
    const real_t t370 = t369 + t109 * t351 + t166 * t350 + t232 * t349;
    const real_t t371 = tb_max(TB_TENSION_MIN - t370, t370 - TB_C(1000000000000.0));
    const real_t t372 = TB_C(0.0) < t15 ? t371 : -TB_C(1.0);
    const real_t t373 = structure[0] * t356 + structure[8] * t354 + structure[16] * t352;
    const real_t t374 = t373 + t96 * t351 + t153 * t350 + t219 * t349;
    const real_t t375 = tb_max(TB_TENSION_MIN - t374, t374 - TB_C(1000000000000.0));
    const real_t t376 = TB_C(0.0) < t1 ? t375 : -TB_C(1.0);
    const real_t t377 = structure[1] * t356 + structure[9] * t354 + structure[17] * t352;
    const real_t t378 = t377 + t97 * t351 + t154 * t350 + t220 * t349;
    const real_t t379 = tb_max(TB_TENSION_MIN - t378, t378 - TB_C(1000000000000.0));
    const real_t t380 = TB_C(0.0) < t3 ? t379 : -TB_C(1.0);
    const real_t t381 = structure[2] * t356 + structure[10] * t354 + structure[18] * t352;
    const real_t t382 = t381 + t99 * t351 + t156 * t350 + t222 * t349;
    const real_t t383 = tb_max(TB_TENSION_MIN - t382, t382 - TB_C(1000000000000.0));
    const real_t t384 = TB_C(0.0) < t5 ? t383 : -TB_C(1.0);
    const real_t t385 = structure[3] * t356 + structure[11] * t354 + structure[19] * t352;
    const real_t t386 = t385 + t95 * t351 + t158 * t350 + t224 * t349;
    const real_t t387 = tb_max(TB_TENSION_MIN - t386, t386 - TB_C(1000000000000.0));
    const real_t t388 = TB_C(0.0) < t7 ? t387 : -TB_C(1.0);
    real_t t389, t390, t391, t392, t393, t394, t395, t396;
    if (t291) {
        t389 = moving[0] == TB_C(4.0) ? TB_C(1.0) : TB_C(0.0);
        t390 = moving[0] == TB_C(5.0) ? TB_C(1.0) : TB_C(0.0);
        t391 = TB_C(6.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
        t392 = moving[0] == TB_C(7.0) ? TB_C(1.0) : TB_C(0.0);
        t393 = TB_C(0.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
        t394 = TB_C(1.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
        t395 = moving[0] == TB_C(2.0) ? TB_C(1.0) : TB_C(0.0);
        t396 = moving[0] == TB_C(3.0) ? TB_C(1.0) : TB_C(0.0);
    } else {
        t389 = t360;
        t390 = t364;
        t391 = t368;
        t392 = t372;
        t393 = t376;
        t394 = t380;
        t395 = t384;
        t396 = t388;
    }
    const real_t t397 = tb_max(t389, t390);
    const real_t t398 = tb_max(t393, t394);
    const bool t399 = tb_max(tb_max(t397, t391), t392) <= tb_max(tb_max(t398, t395), t396);
    real_t t400, t401, t402, t403, t404, t405, t406, t407;
    if (t399) {
        const bool t408 = tb_max(t395, t396) <= t398;
        real_t t409, t410, t411, t412, t413, t414, t415, t416;
        if (t408) {
            const bool t417 = t394 <= t393;
            t409 = t417 ? TB_C(0.0) : TB_C(1.0);
            t410 = t417 ? structure[0] : structure[1];
            t411 = t417 ? structure[8] : structure[9];
            t412 = t417 ? structure[16] : structure[17];
            t413 = t417 ? t96 : t97;
            t414 = t417 ? t153 : t154;
            t415 = t417 ? t219 : t220;
            t416 = t417 ? t374 : t378;
        } else {
            const bool t418 = t396 <= t395;
            t409 = t418 ? TB_C(2.0) : TB_C(3.0);
            t410 = t418 ? structure[2] : structure[3];
            t411 = t418 ? structure[10] : structure[11];
            t412 = t418 ? structure[18] : structure[19];
            t413 = t418 ? t99 : t95;
            t414 = t418 ? t156 : t158;
            t415 = t418 ? t222 : t224;
            t416 = t418 ? t382 : t386;
        }
        t400 = t409;
        t401 = t410;
        t402 = t411;
        t403 = t412;
        t404 = t413;
        t405 = t414;
        t406 = t415;
        t407 = t416;
    } else {
        const bool t419 = tb_max(t391, t392) <= t397;
        real_t t420, t421, t422, t423, t424, t425, t426, t427;
        if (t419) {
            const bool t428 = t390 <= t389;
            t420 = t428 ? TB_C(4.0) : TB_C(5.0);
            t421 = t428 ? structure[4] : structure[5];
            t422 = t428 ? structure[12] : structure[13];
            t423 = t428 ? structure[20] : structure[21];
            t424 = t428 ? t102 : t105;
            t425 = t428 ? t152 : t162;
            t426 = t428 ? t227 : t218;
            t427 = t428 ? t358 : t362;
        } else {
            const bool t429 = t392 <= t391;
            t420 = t429 ? TB_C(6.0) : TB_C(7.0);
            t421 = t429 ? structure[6] : structure[7];
            t422 = t429 ? structure[14] : structure[15];
            t423 = t429 ? structure[22] : structure[23];
            t424 = t429 ? t107 : t109;
            t425 = t429 ? t164 : t166;
            t426 = t429 ? t230 : t232;
            t427 = t429 ? t366 : t370;
        }
        t400 = t420;
        t401 = t421;
        t402 = t422;
        t403 = t423;
        t404 = t424;
        t405 = t425;
        t406 = t426;
        t407 = t427;
    }
    const real_t t430 = t292 * t401;
    const real_t t431 = t306 * (t402 + t305 * t430);
    const real_t t432 = t313 * (t403 + t317 * t430 + t312 * t431);
    const real_t t433 = t321 * (t404 + t325 * t430 + t326 * t431 + t320 * t432);
    const real_t t434 = t405 + t334 * t430 + t335 * t431 + t336 * t432 + t329 * t433;
    const real_t t435 = t330 * t434;
    const real_t t436 = t406 + t344 * t430 + t345 * t431 + t346 * t432 + t348 * t433;
    const real_t t437 = t340 * (t340 * (t436 + t339 * t435));
    const real_t t438 = t330 * (t435 + t339 * t437);
    const real_t t439 = t321 * (t433 + t329 * t438 + t348 * t437);
    const real_t t440 = t313 * (t432 + t320 * t439 + t336 * t438 + t346 * t437);
    const real_t t441 = t431 + t312 * t440 + t326 * t439 + t335 * t438 + t345 * t437;
    const real_t t442 = t306 * t441;
    const real_t t443 = t430 + t305 * t442 + t317 * t440 + t325 * t439 + t334 * t438;
    const real_t t444 = t292 * (t443 + t344 * t437);
    const real_t t445 = structure[0] * t444 + structure[8] * t442 + structure[16] * t440;
    const real_t t446 = t445 + t96 * t439 + t153 * t438 + t219 * t437;
    const real_t t447 = (TB_C(0.0) == t400 ? TB_C(1.0) : TB_C(0.0)) - t446;
    const real_t t448 = structure[1] * t444 + structure[9] * t442 + structure[17] * t440;
    const real_t t449 = t448 + t97 * t439 + t154 * t438 + t220 * t437;
    const real_t t450 = (TB_C(1.0) == t400 ? TB_C(1.0) : TB_C(0.0)) - t449;
    const real_t t451 = (t0 ? (t0 ? t447 * t447 : TB_C(0.0)) : TB_C(0.0)) + (t2 ? (t2 ? t450 *
        t450 : TB_C(0.0)) : TB_C(0.0));
    const real_t t452 = structure[2] * t444 + structure[10] * t442 + structure[18] * t440;
    const real_t t453 = t452 + t99 * t439 + t156 * t438 + t222 * t437;
    const real_t t454 = (TB_C(2.0) == t400 ? TB_C(1.0) : TB_C(0.0)) - t453;
    const real_t t455 = t451 + (t4 ? (t4 ? t454 * t454 : TB_C(0.0)) : TB_C(0.0));
    const real_t t456 = structure[3] * t444 + structure[11] * t442 + structure[19] * t440;
    const real_t t457 = t456 + t95 * t439 + t158 * t438 + t224 * t437;
    const real_t t458 = (TB_C(3.0) == t400 ? TB_C(1.0) : TB_C(0.0)) - t457;
    const real_t t459 = t455 + (t6 ? (t6 ? t458 * t458 : TB_C(0.0)) : TB_C(0.0));
    const real_t t460 = structure[4] * t444 + structure[12] * t442 + structure[20] * t440;
    const real_t t461 = t460 + t102 * t439 + t152 * t438 + t227 * t437;
    const real_t t462 = (TB_C(4.0) == t400 ? TB_C(1.0) : TB_C(0.0)) - t461;
    const real_t t463 = t459 + (t8 ? (t8 ? t462 * t462 : TB_C(0.0)) : TB_C(0.0));
    const real_t t464 = structure[5] * t444 + structure[13] * t442 + structure[21] * t440;
    const real_t t465 = t464 + t105 * t439 + t162 * t438 + t218 * t437;
    const real_t t466 = (TB_C(5.0) == t400 ? TB_C(1.0) : TB_C(0.0)) - t465;
    const real_t t467 = t10 ? (t10 ? t466 * t466 : TB_C(0.0)) : TB_C(0.0);
    const real_t t468 = structure[6] * t444 + structure[14] * t442 + structure[22] * t440;
    const real_t t469 = t468 + t107 * t439 + t164 * t438 + t230 * t437;
    const real_t t470 = (TB_C(6.0) == t400 ? TB_C(1.0) : TB_C(0.0)) - t469;
    const real_t t471 = t12 ? (t12 ? t470 * t470 : TB_C(0.0)) : TB_C(0.0);
    const real_t t472 = structure[7] * t444 + structure[15] * t442 + structure[23] * t440;
    const real_t t473 = t472 + t109 * t439 + t166 * t438 + t232 * t437;
    const real_t t474 = (TB_C(7.0) == t400 ? TB_C(1.0) : TB_C(0.0)) - t473;
    const real_t t475 = t14 ? (t14 ? t474 * t474 : TB_C(0.0)) : TB_C(0.0);
    const real_t t476 = t463 + t467 + t471 + t475;
    const real_t t477 = t407 + t476 * push[0];
    const bool t478 = t477 < TB_C(500000000000.25);
    real_t t479;
    if (t16 && t290 * t290 < t476) {
        const real_t t480 = t478 ? TB_TENSION_MIN - t477 : t477 - TB_C(1000000000000.0);
        t479 = tb_max(t480, TB_C(0.0)) * (TB_C(1.0) / t476);
    } else {
        t479 = TB_C(1e+30);
    }
    const real_t t481 = t478 ? TB_C(1.0) : -TB_C(1.0);
    const real_t t482 = side[0] * (t446 * t481);
    real_t t483;
    if (t290 < t482) {
        const real_t t484 = tb_max(side[0] * (t374 - t446 * push[0] - t293), TB_C(0.0));
        t483 = t484 / t482;
    } else {
        t483 = TB_C(1e+30);
    }
    const real_t t485 = side[1] * (t449 * t481);
    real_t t486;
    if (t290 < t485) {
        const real_t t487 = tb_max(side[1] * (t378 - t449 * push[0] - t294), TB_C(0.0));
        t486 = t487 / t485;
    } else {
        t486 = TB_C(1e+30);
    }
    const real_t t488 = side[2] * (t453 * t481);
    real_t t489;
    if (t290 < t488) {
        const real_t t490 = tb_max(side[2] * (t382 - t453 * push[0] - t295), TB_C(0.0));
        t489 = t490 / t488;
    } else {
        t489 = TB_C(1e+30);
    }
    const real_t t491 = side[3] * (t457 * t481);
    real_t t492;
    if (t290 < t491) {
        const real_t t493 = tb_max(side[3] * (t386 - t457 * push[0] - t297), TB_C(0.0));
        t492 = t493 / t491;
    } else {
        t492 = TB_C(1e+30);
    }
    const real_t t494 = side[4] * (t461 * t481);
    real_t t495;
    if (t290 < t494) {
        const real_t t496 = tb_max(side[4] * (t358 - t461 * push[0] - t298), TB_C(0.0));
        t495 = t496 / t494;
    } else {
        t495 = TB_C(1e+30);
    }
    const real_t t497 = tb_min(tb_min(tb_min(tb_min(t483, t486), t489), t492), t495);
    const real_t t498 = side[5] * (t465 * t481);
    real_t t499;
    if (t290 < t498) {
        const real_t t500 = tb_max(side[5] * (t362 - t465 * push[0] - t299), TB_C(0.0));
        t499 = t500 / t498;
    } else {
        t499 = TB_C(1e+30);
    }
    const real_t t501 = side[6] * (t469 * t481);
    real_t t502;
    if (t290 < t501) {
        const real_t t503 = tb_max(side[6] * (t366 - t469 * push[0] - t301), TB_C(0.0));
        t502 = t503 / t501;
    } else {
        t502 = TB_C(1e+30);
    }
    const real_t t504 = side[7] * (t473 * t481);
    real_t t505;
    if (t290 < t504) {
        const real_t t506 = tb_max(side[7] * (t370 - t473 * push[0] - t302), TB_C(0.0));
        t505 = t506 / t504;
    } else {
        t505 = TB_C(1e+30);
    }
    const real_t t507 = tb_min(tb_min(tb_min(t497, t499), t502), t505);
    const bool t508 = t479 <= t507;
    const real_t t509 = tb_max(tb_max(tb_max(tb_max(t376, t380), t384), t388), t360);
    const real_t t510 = TB_ABS(wrench[0]) + TB_ABS(wrench[1]) + TB_ABS(wrench[2]);
    const real_t t511 = t510 + TB_ABS(t322) + TB_ABS(t331) + TB_ABS(t341);
    const real_t t512 = t289 * (TB_EPSILON * TB_C(8.0) * (TB_TENSION_MIN + t511));
    const bool t513 = tb_max(tb_max(tb_max(t509, t364), t368), t372) <= t512;
    const bool t514 = (!t291 && t513) || !(tb_min(t479, t507) < TB_C(1e+30));
    const real_t t515 = t508 && !t514 ? t400 : -TB_C(1.0);
    const real_t t516 = -t481;
    real_t t517;
    if (t508 || t514) {
        t517 = -TB_C(1.0);
    } else {
        const real_t t518 = -t495;
        const real_t t519 = -t499;
        const real_t t520 = tb_max(t518, t519);
        const real_t t521 = -t502;
        const real_t t522 = -t505;
        const real_t t523 = -t483;
        const real_t t524 = -t486;
        const real_t t525 = tb_max(t523, t524);
        const real_t t526 = -t489;
        const real_t t527 = -t492;
        const bool t528 = tb_max(tb_max(t520, t521), t522) <= tb_max(tb_max(t525, t526), t527);
        real_t t529;
        if (t528) {
            const real_t t530 = tb_max(t526, t527) <= t525 ? (t524 <= t523 ? TB_C(0.0) :
                TB_C(1.0)) : (t527 <= t526 ? TB_C(2.0) : TB_C(3.0));
            t529 = t530;
        } else {
            const real_t t531 = tb_max(t521, t522) <= t520 ? (t519 <= t518 ? TB_C(4.0) :
                TB_C(5.0)) : (t522 <= t521 ? TB_C(6.0) : TB_C(7.0));
            t529 = t531;
        }
        t517 = t529;
    }
    const real_t side_0 = TB_C(0.0) == t515 ? t516 : (TB_C(0.0) == t517 ? TB_C(0.0) : side[0]);
    const real_t side_1 = TB_C(1.0) == t515 ? t516 : (TB_C(1.0) == t517 ? TB_C(0.0) : side[1]);
    const real_t side_2 = TB_C(2.0) == t515 ? t516 : (TB_C(2.0) == t517 ? TB_C(0.0) : side[2]);
    const real_t side_3 = TB_C(3.0) == t515 ? t516 : (TB_C(3.0) == t517 ? TB_C(0.0) : side[3]);
    const real_t side_4 = TB_C(4.0) == t515 ? t516 : (TB_C(4.0) == t517 ? TB_C(0.0) : side[4]);
    const real_t side_5 = TB_C(5.0) == t515 ? t516 : (TB_C(5.0) == t517 ? TB_C(0.0) : side[5]);
    const real_t side_6 = TB_C(6.0) == t515 ? t516 : (TB_C(6.0) == t517 ? TB_C(0.0) : side[6]);
    const real_t side_7 = TB_C(7.0) == t515 ? t516 : (TB_C(7.0) == t517 ? TB_C(0.0) : side[7]);
    const real_t moving_0 = t508 ? -TB_C(1.0) : t400;
    const real_t push_0 = t508 ? TB_C(0.0) : push[0] + t481 * t507;
    const real_t done_0 = t514 ? TB_C(1.0) : TB_C(0.0);
    side[0] = side_0;
    side[1] = side_1;
    side[2] = side_2;
    side[3] = side_3;
    side[4] = side_4;
    side[5] = side_5;
    side[6] = side_6;
    side[7] = side_7;
    moving[0] = moving_0;
    push[0] = push_0;
    done[0] = done_0;
    return TB_OK;
}

/* The tensions, refined and judged. */
static tb_status tb_distribute_tension_paper_finish(const real_t structure[48], const real_t wrench[6],
    const real_t pivot[1], const real_t side[8], real_t tension[8], real_t delivered[6],
    real_t kkt_residual[1])
{
    const real_t t0 = TB_C(0.0) < side[0] ? TB_C(1000000000000.0) : (side[0] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t1 = TB_C(0.0) < side[1] ? TB_C(1000000000000.0) : (side[1] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t2 = TB_C(0.0) < side[2] ? TB_C(1000000000000.0) : (side[2] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t3 = t0 * structure[0] + structure[1] * t1 + structure[2] * t2;
    const real_t t4 = TB_C(0.0) < side[3] ? TB_C(1000000000000.0) : (side[3] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t5 = TB_C(0.0) < side[4] ? TB_C(1000000000000.0) : (side[4] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t6 = TB_C(0.0) < side[5] ? TB_C(1000000000000.0) : (side[5] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t7 = t3 + structure[3] * t4 + structure[4] * t5 + structure[5] * t6;
    const real_t t8 = TB_C(0.0) < side[6] ? TB_C(1000000000000.0) : (side[6] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t9 = TB_C(0.0) < side[7] ? TB_C(1000000000000.0) : (side[7] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t10 = wrench[0] - (t7 + structure[6] * t8 + structure[7] * t9);
    const bool t11 = TB_C(0.0) == side[0];
    const real_t t12 = t11 ? (t11 ? structure[0] * structure[0] : TB_C(0.0)) : TB_C(0.0);
    const bool t13 = TB_C(0.0) == side[1];
    const real_t t14 = t13 ? (t13 ? structure[1] * structure[1] : TB_C(0.0)) : TB_C(0.0);
    const bool t15 = TB_C(0.0) == side[2];
    const real_t t16 = t15 ? (t15 ? structure[2] * structure[2] : TB_C(0.0)) : TB_C(0.0);
    const bool t17 = TB_C(0.0) == side[3];
    const real_t t18 = t17 ? (t17 ? structure[3] * structure[3] : TB_C(0.0)) : TB_C(0.0);
    const bool t19 = TB_C(0.0) == side[4];
    const real_t t20 = t19 ? (t19 ? structure[4] * structure[4] : TB_C(0.0)) : TB_C(0.0);
    const bool t21 = TB_C(0.0) == side[5];
    const real_t t22 = t21 ? (t21 ? structure[5] * structure[5] : TB_C(0.0)) : TB_C(0.0);
    const bool t23 = TB_C(0.0) == side[6];
    const real_t t24 = t23 ? (t23 ? structure[6] * structure[6] : TB_C(0.0)) : TB_C(0.0);
    const bool t25 = TB_C(0.0) == side[7];
    const real_t t26 = t25 ? (t25 ? structure[7] * structure[7] : TB_C(0.0)) : TB_C(0.0);
    const real_t t27 = TB_SQRT(t12 + t14 + t16 + t18 + t20 + t22 + t24 + t26);
    const real_t t28 = t11 ? structure[0] : TB_C(0.0);
    const real_t t29 = TB_COPYSIGN(t27, t28);
    const real_t t30 = TB_C(1.0) / t29;
    const real_t t31 = t10 * t30;
    const real_t t32 = t28 + t29;
    const real_t t33 = t13 ? (t13 ? structure[1] * structure[9] : TB_C(0.0)) : TB_C(0.0);
    const real_t t34 = t15 ? (t15 ? structure[2] * structure[10] : TB_C(0.0)) : TB_C(0.0);
    const real_t t35 = (t11 ? structure[8] * t32 : TB_C(0.0)) + t33 + t34;
    const real_t t36 = t17 ? (t17 ? structure[3] * structure[11] : TB_C(0.0)) : TB_C(0.0);
    const real_t t37 = t19 ? (t19 ? structure[4] * structure[12] : TB_C(0.0)) : TB_C(0.0);
    const real_t t38 = t21 ? (t21 ? structure[5] * structure[13] : TB_C(0.0)) : TB_C(0.0);
    const real_t t39 = t23 ? (t23 ? structure[6] * structure[14] : TB_C(0.0)) : TB_C(0.0);
    const real_t t40 = t25 ? (t25 ? structure[7] * structure[15] : TB_C(0.0)) : TB_C(0.0);
    const real_t t41 = TB_C(1.0) / (t27 * (t27 + TB_ABS(t28)));
    const real_t t42 = (t35 + t36 + t37 + t38 + t39 + t40) * t41;
    const real_t t43 = (t11 ? structure[8] : TB_C(0.0)) - t32 * t42;
    const real_t t44 = t0 * structure[8] + t1 * structure[9] + t2 * structure[10];
    const real_t t45 = t44 + t4 * structure[11] + t5 * structure[12] + t6 * structure[13];
    const real_t t46 = wrench[1] - (t45 + t8 * structure[14] + t9 * structure[15]);
    const real_t t47 = structure[9] - structure[1] * t42;
    const real_t t48 = structure[10] - structure[2] * t42;
    const real_t t49 = (t13 ? (t13 ? t47 * t47 : TB_C(0.0)) : TB_C(0.0)) + (t15 ? (t15 ? t48 *
        t48 : TB_C(0.0)) : TB_C(0.0));
    const real_t t50 = structure[11] - structure[3] * t42;
    const real_t t51 = t49 + (t17 ? (t17 ? t50 * t50 : TB_C(0.0)) : TB_C(0.0));
    const real_t t52 = structure[12] - structure[4] * t42;
    const real_t t53 = t51 + (t19 ? (t19 ? t52 * t52 : TB_C(0.0)) : TB_C(0.0));
    const real_t t54 = structure[13] - structure[5] * t42;
    const real_t t55 = t53 + (t21 ? (t21 ? t54 * t54 : TB_C(0.0)) : TB_C(0.0));
    const real_t t56 = structure[14] - structure[6] * t42;
    const real_t t57 = t55 + (t23 ? (t23 ? t56 * t56 : TB_C(0.0)) : TB_C(0.0));
    const real_t t58 = structure[15] - structure[7] * t42;
    const real_t t59 = t57 + (t25 ? (t25 ? t58 * t58 : TB_C(0.0)) : TB_C(0.0));
    const real_t t60 = TB_SQRT(t59);
    const real_t t61 = t13 ? t47 : TB_C(0.0);
    const real_t t62 = TB_COPYSIGN(t60, t61);
    const real_t t63 = TB_C(1.0) / t62;
    const real_t t64 = (t46 + t31 * t43) * t63;
    const real_t t65 = t13 ? (t13 ? structure[1] * structure[17] : TB_C(0.0)) : TB_C(0.0);
    const real_t t66 = t15 ? (t15 ? structure[2] * structure[18] : TB_C(0.0)) : TB_C(0.0);
    const real_t t67 = (t11 ? t32 * structure[16] : TB_C(0.0)) + t65 + t66;
    const real_t t68 = t17 ? (t17 ? structure[3] * structure[19] : TB_C(0.0)) : TB_C(0.0);
    const real_t t69 = t19 ? (t19 ? structure[4] * structure[20] : TB_C(0.0)) : TB_C(0.0);
    const real_t t70 = t21 ? (t21 ? structure[5] * structure[21] : TB_C(0.0)) : TB_C(0.0);
    const real_t t71 = t23 ? (t23 ? structure[6] * structure[22] : TB_C(0.0)) : TB_C(0.0);
    const real_t t72 = t25 ? (t25 ? structure[7] * structure[23] : TB_C(0.0)) : TB_C(0.0);
    const real_t t73 = t41 * (t67 + t68 + t69 + t70 + t71 + t72);
    const real_t t74 = structure[17] - structure[1] * t73;
    const real_t t75 = t61 + t62;
    const real_t t76 = structure[18] - structure[2] * t73;
    const real_t t77 = (t13 ? t74 * t75 : TB_C(0.0)) + (t15 ? (t15 ? t48 * t76 : TB_C(0.0)) :
        TB_C(0.0));
    const real_t t78 = structure[19] - structure[3] * t73;
    const real_t t79 = t77 + (t17 ? (t17 ? t50 * t78 : TB_C(0.0)) : TB_C(0.0));
    const real_t t80 = structure[20] - structure[4] * t73;
    const real_t t81 = t79 + (t19 ? (t19 ? t52 * t80 : TB_C(0.0)) : TB_C(0.0));
    const real_t t82 = structure[21] - structure[5] * t73;
    const real_t t83 = t81 + (t21 ? (t21 ? t54 * t82 : TB_C(0.0)) : TB_C(0.0));
    const real_t t84 = structure[22] - structure[6] * t73;
    const real_t t85 = t83 + (t23 ? (t23 ? t56 * t84 : TB_C(0.0)) : TB_C(0.0));
    const real_t t86 = structure[23] - structure[7] * t73;
    const real_t t87 = t85 + (t25 ? (t25 ? t58 * t86 : TB_C(0.0)) : TB_C(0.0));
    const real_t t88 = TB_C(1.0) / (t60 * (t60 + TB_ABS(t61)));
    const real_t t89 = t87 * t88;
    const real_t t90 = (t13 ? t74 : TB_C(0.0)) - t75 * t89;
    const real_t t91 = t0 * structure[16] + t1 * structure[17] + t2 * structure[18];
    const real_t t92 = t91 + t4 * structure[19] + t5 * structure[20] + t6 * structure[21];
    const real_t t93 = wrench[2] - (t92 + t8 * structure[22] + t9 * structure[23]);
    const real_t t94 = (t11 ? structure[16] : TB_C(0.0)) - t32 * t73;
    const real_t t95 = t76 - t48 * t89;
    const real_t t96 = t78 - t50 * t89;
    const real_t t97 = (t15 ? (t15 ? t95 * t95 : TB_C(0.0)) : TB_C(0.0)) + (t17 ? (t17 ? t96 *
        t96 : TB_C(0.0)) : TB_C(0.0));
    const real_t t98 = t80 - t52 * t89;
    const real_t t99 = t97 + (t19 ? (t19 ? t98 * t98 : TB_C(0.0)) : TB_C(0.0));
    const real_t t100 = t82 - t54 * t89;
    const real_t t101 = t21 ? (t21 ? t100 * t100 : TB_C(0.0)) : TB_C(0.0);
    const real_t t102 = t84 - t56 * t89;
    const real_t t103 = t23 ? (t23 ? t102 * t102 : TB_C(0.0)) : TB_C(0.0);
    const real_t t104 = t86 - t58 * t89;
    const real_t t105 = t25 ? (t25 ? t104 * t104 : TB_C(0.0)) : TB_C(0.0);
    const real_t t106 = TB_SQRT(t99 + t101 + t103 + t105);
    const real_t t107 = t15 ? t95 : TB_C(0.0);
    const real_t t108 = TB_COPYSIGN(t106, t107);
    const real_t t109 = TB_C(1.0) / t108;
    const real_t t110 = (t93 + t31 * t94 + t64 * t90) * t109;
    const real_t t111 = TB_MOMENT_WEIGHT * structure[26];
    const real_t t112 = TB_MOMENT_WEIGHT * structure[24];
    const real_t t113 = TB_MOMENT_WEIGHT * structure[25];
    const real_t t114 = t13 ? (t13 ? structure[1] * t113 : TB_C(0.0)) : TB_C(0.0);
    const real_t t115 = t15 ? (t15 ? structure[2] * t111 : TB_C(0.0)) : TB_C(0.0);
    const real_t t116 = TB_MOMENT_WEIGHT * structure[27];
    const real_t t117 = t17 ? (t17 ? structure[3] * t116 : TB_C(0.0)) : TB_C(0.0);
    const real_t t118 = (t11 ? t32 * t112 : TB_C(0.0)) + t114 + t115 + t117;
    const real_t t119 = TB_MOMENT_WEIGHT * structure[28];
    const real_t t120 = t19 ? (t19 ? structure[4] * t119 : TB_C(0.0)) : TB_C(0.0);
    const real_t t121 = TB_MOMENT_WEIGHT * structure[29];
    const real_t t122 = t21 ? (t21 ? structure[5] * t121 : TB_C(0.0)) : TB_C(0.0);
    const real_t t123 = TB_MOMENT_WEIGHT * structure[30];
    const real_t t124 = t23 ? (t23 ? structure[6] * t123 : TB_C(0.0)) : TB_C(0.0);
    const real_t t125 = TB_MOMENT_WEIGHT * structure[31];
    const real_t t126 = t25 ? (t25 ? structure[7] * t125 : TB_C(0.0)) : TB_C(0.0);
    const real_t t127 = t41 * (t118 + t120 + t122 + t124 + t126);
    const real_t t128 = t111 - structure[2] * t127;
    const real_t t129 = t113 - structure[1] * t127;
    const real_t t130 = (t13 ? t75 * t129 : TB_C(0.0)) + (t15 ? (t15 ? t48 * t128 : TB_C(0.0))
        : TB_C(0.0));
    const real_t t131 = t116 - structure[3] * t127;
    const real_t t132 = t130 + (t17 ? (t17 ? t50 * t131 : TB_C(0.0)) : TB_C(0.0));
    const real_t t133 = t119 - structure[4] * t127;
    const real_t t134 = t132 + (t19 ? (t19 ? t52 * t133 : TB_C(0.0)) : TB_C(0.0));
    const real_t t135 = t121 - structure[5] * t127;
    const real_t t136 = t134 + (t21 ? (t21 ? t54 * t135 : TB_C(0.0)) : TB_C(0.0));
    const real_t t137 = t123 - structure[6] * t127;
    const real_t t138 = t136 + (t23 ? (t23 ? t56 * t137 : TB_C(0.0)) : TB_C(0.0));
    const real_t t139 = t125 - structure[7] * t127;
    const real_t t140 = t138 + (t25 ? (t25 ? t58 * t139 : TB_C(0.0)) : TB_C(0.0));
    const real_t t141 = t88 * t140;
    const real_t t142 = t128 - t48 * t141;
    const real_t t143 = t107 + t108;
    const real_t t144 = t131 - t50 * t141;
    const real_t t145 = (t15 ? t142 * t143 : TB_C(0.0)) + (t17 ? (t17 ? t96 * t144 : TB_C(0.0))
        : TB_C(0.0));
    const real_t t146 = t133 - t52 * t141;
    const real_t t147 = t145 + (t19 ? (t19 ? t98 * t146 : TB_C(0.0)) : TB_C(0.0));
    const real_t t148 = t135 - t54 * t141;
    const real_t t149 = t21 ? (t21 ? t100 * t148 : TB_C(0.0)) : TB_C(0.0);
    const real_t t150 = t137 - t56 * t141;
    const real_t t151 = t23 ? (t23 ? t102 * t150 : TB_C(0.0)) : TB_C(0.0);
    const real_t t152 = t139 - t58 * t141;
    const real_t t153 = t25 ? (t25 ? t104 * t152 : TB_C(0.0)) : TB_C(0.0);
    const real_t t154 = TB_C(1.0) / (t106 * (t106 + TB_ABS(t107)));
    const real_t t155 = (t147 + t149 + t151 + t153) * t154;
    const real_t t156 = (t15 ? t142 : TB_C(0.0)) - t143 * t155;
    const real_t t157 = TB_MOMENT_WEIGHT * wrench[3];
    const real_t t158 = t0 * t112 + t1 * t113 + t2 * t111 + t4 * t116 + t5 * t119;
    const real_t t159 = t157 - (t158 + t6 * t121 + t8 * t123 + t9 * t125);
    const real_t t160 = (t11 ? t112 : TB_C(0.0)) - t32 * t127;
    const real_t t161 = (t13 ? t129 : TB_C(0.0)) - t75 * t141;
    const real_t t162 = t144 - t96 * t155;
    const real_t t163 = t17 ? (t17 ? t162 * t162 : TB_C(0.0)) : TB_C(0.0);
    const real_t t164 = t146 - t98 * t155;
    const real_t t165 = t19 ? (t19 ? t164 * t164 : TB_C(0.0)) : TB_C(0.0);
    const real_t t166 = t148 - t100 * t155;
    const real_t t167 = t21 ? (t21 ? t166 * t166 : TB_C(0.0)) : TB_C(0.0);
    const real_t t168 = t150 - t102 * t155;
    const real_t t169 = t23 ? (t23 ? t168 * t168 : TB_C(0.0)) : TB_C(0.0);
    const real_t t170 = t152 - t104 * t155;
    const real_t t171 = t25 ? (t25 ? t170 * t170 : TB_C(0.0)) : TB_C(0.0);
    const real_t t172 = TB_SQRT(t163 + t165 + t167 + t169 + t171);
    const real_t t173 = t17 ? t162 : TB_C(0.0);
    const real_t t174 = TB_COPYSIGN(t172, t173);
    const real_t t175 = TB_C(1.0) / t174;
    const real_t t176 = (t159 + t31 * t160 + t64 * t161 + t110 * t156) * t175;
    const real_t t177 = TB_MOMENT_WEIGHT * structure[35];
    const real_t t178 = TB_MOMENT_WEIGHT * structure[32];
    const real_t t179 = TB_MOMENT_WEIGHT * structure[33];
    const real_t t180 = t13 ? (t13 ? structure[1] * t179 : TB_C(0.0)) : TB_C(0.0);
    const real_t t181 = TB_MOMENT_WEIGHT * structure[34];
    const real_t t182 = t15 ? (t15 ? structure[2] * t181 : TB_C(0.0)) : TB_C(0.0);
    const real_t t183 = t17 ? (t17 ? structure[3] * t177 : TB_C(0.0)) : TB_C(0.0);
    const real_t t184 = (t11 ? t32 * t178 : TB_C(0.0)) + t180 + t182 + t183;
    const real_t t185 = TB_MOMENT_WEIGHT * structure[36];
    const real_t t186 = t19 ? (t19 ? structure[4] * t185 : TB_C(0.0)) : TB_C(0.0);
    const real_t t187 = TB_MOMENT_WEIGHT * structure[37];
    const real_t t188 = t21 ? (t21 ? structure[5] * t187 : TB_C(0.0)) : TB_C(0.0);
    const real_t t189 = TB_MOMENT_WEIGHT * structure[38];
    const real_t t190 = t23 ? (t23 ? structure[6] * t189 : TB_C(0.0)) : TB_C(0.0);
    const real_t t191 = TB_MOMENT_WEIGHT * structure[39];
    const real_t t192 = t25 ? (t25 ? structure[7] * t191 : TB_C(0.0)) : TB_C(0.0);
    const real_t t193 = t41 * (t184 + t186 + t188 + t190 + t192);
    const real_t t194 = t177 - structure[3] * t193;
    const real_t t195 = t179 - structure[1] * t193;
    const real_t t196 = t181 - structure[2] * t193;
    const real_t t197 = (t13 ? t75 * t195 : TB_C(0.0)) + (t15 ? (t15 ? t48 * t196 : TB_C(0.0))
        : TB_C(0.0));
    const real_t t198 = t197 + (t17 ? (t17 ? t50 * t194 : TB_C(0.0)) : TB_C(0.0));
    const real_t t199 = t185 - structure[4] * t193;
    const real_t t200 = t198 + (t19 ? (t19 ? t52 * t199 : TB_C(0.0)) : TB_C(0.0));
    const real_t t201 = t187 - structure[5] * t193;
    const real_t t202 = t200 + (t21 ? (t21 ? t54 * t201 : TB_C(0.0)) : TB_C(0.0));
    const real_t t203 = t189 - structure[6] * t193;
    const real_t t204 = t202 + (t23 ? (t23 ? t56 * t203 : TB_C(0.0)) : TB_C(0.0));
    const real_t t205 = t191 - structure[7] * t193;
    const real_t t206 = t204 + (t25 ? (t25 ? t58 * t205 : TB_C(0.0)) : TB_C(0.0));
    const real_t t207 = t88 * t206;
    const real_t t208 = t194 - t50 * t207;
    const real_t t209 = t196 - t48 * t207;
    const real_t t210 = (t15 ? t143 * t209 : TB_C(0.0)) + (t17 ? (t17 ? t96 * t208 : TB_C(0.0))
        : TB_C(0.0));
    const real_t t211 = t199 - t52 * t207;
    const real_t t212 = t210 + (t19 ? (t19 ? t98 * t211 : TB_C(0.0)) : TB_C(0.0));
    const real_t t213 = t201 - t54 * t207;
    const real_t t214 = t21 ? (t21 ? t100 * t213 : TB_C(0.0)) : TB_C(0.0);
    const real_t t215 = t203 - t56 * t207;
    const real_t t216 = t23 ? (t23 ? t102 * t215 : TB_C(0.0)) : TB_C(0.0);
    const real_t t217 = t205 - t58 * t207;
    const real_t t218 = t25 ? (t25 ? t104 * t217 : TB_C(0.0)) : TB_C(0.0);
    const real_t t219 = t154 * (t212 + t214 + t216 + t218);
    const real_t t220 = t208 - t96 * t219;
    const real_t t221 = t173 + t174;
    const real_t t222 = t211 - t98 * t219;
    const real_t t223 = t19 ? (t19 ? t164 * t222 : TB_C(0.0)) : TB_C(0.0);
    const real_t t224 = t213 - t100 * t219;
    const real_t t225 = t21 ? (t21 ? t166 * t224 : TB_C(0.0)) : TB_C(0.0);
    const real_t t226 = t215 - t102 * t219;
    const real_t t227 = t23 ? (t23 ? t168 * t226 : TB_C(0.0)) : TB_C(0.0);
    const real_t t228 = (t17 ? t220 * t221 : TB_C(0.0)) + t223 + t225 + t227;
    const real_t t229 = t217 - t104 * t219;
    const real_t t230 = t25 ? (t25 ? t170 * t229 : TB_C(0.0)) : TB_C(0.0);
    const real_t t231 = TB_C(1.0) / (t172 * (t172 + TB_ABS(t173)));
    const real_t t232 = (t228 + t230) * t231;
    const real_t t233 = (t17 ? t220 : TB_C(0.0)) - t221 * t232;
    const real_t t234 = TB_MOMENT_WEIGHT * wrench[4];
    const real_t t235 = t0 * t178 + t1 * t179 + t2 * t181 + t4 * t177 + t5 * t185;
    const real_t t236 = t234 - (t235 + t6 * t187 + t8 * t189 + t9 * t191);
    const real_t t237 = (t11 ? t178 : TB_C(0.0)) - t32 * t193;
    const real_t t238 = (t13 ? t195 : TB_C(0.0)) - t75 * t207;
    const real_t t239 = (t15 ? t209 : TB_C(0.0)) - t143 * t219;
    const real_t t240 = t236 + t31 * t237 + t64 * t238 + t110 * t239 + t176 * t233;
    const real_t t241 = t222 - t164 * t232;
    const real_t t242 = t19 ? (t19 ? t241 * t241 : TB_C(0.0)) : TB_C(0.0);
    const real_t t243 = t224 - t166 * t232;
    const real_t t244 = t21 ? (t21 ? t243 * t243 : TB_C(0.0)) : TB_C(0.0);
    const real_t t245 = t226 - t168 * t232;
    const real_t t246 = t23 ? (t23 ? t245 * t245 : TB_C(0.0)) : TB_C(0.0);
    const real_t t247 = t229 - t170 * t232;
    const real_t t248 = t25 ? (t25 ? t247 * t247 : TB_C(0.0)) : TB_C(0.0);
    const real_t t249 = TB_SQRT(t242 + t244 + t246 + t248);
    const real_t t250 = t19 ? t241 : TB_C(0.0);
    const real_t t251 = TB_COPYSIGN(t249, t250);
    const real_t t252 = TB_C(1.0) / t251;
    const real_t t253 = t240 * t252;
    const real_t t254 = TB_MOMENT_WEIGHT * structure[44];
    const real_t t255 = TB_MOMENT_WEIGHT * structure[40];
    const real_t t256 = TB_MOMENT_WEIGHT * structure[41];
    const real_t t257 = t13 ? (t13 ? structure[1] * t256 : TB_C(0.0)) : TB_C(0.0);
    const real_t t258 = TB_MOMENT_WEIGHT * structure[42];
    const real_t t259 = t15 ? (t15 ? structure[2] * t258 : TB_C(0.0)) : TB_C(0.0);
    const real_t t260 = TB_MOMENT_WEIGHT * structure[43];
    const real_t t261 = t17 ? (t17 ? structure[3] * t260 : TB_C(0.0)) : TB_C(0.0);
    const real_t t262 = (t11 ? t32 * t255 : TB_C(0.0)) + t257 + t259 + t261;
    const real_t t263 = t19 ? (t19 ? structure[4] * t254 : TB_C(0.0)) : TB_C(0.0);
    const real_t t264 = TB_MOMENT_WEIGHT * structure[45];
    const real_t t265 = t21 ? (t21 ? structure[5] * t264 : TB_C(0.0)) : TB_C(0.0);
    const real_t t266 = TB_MOMENT_WEIGHT * structure[46];
    const real_t t267 = t23 ? (t23 ? structure[6] * t266 : TB_C(0.0)) : TB_C(0.0);
    const real_t t268 = TB_MOMENT_WEIGHT * structure[47];
    const real_t t269 = t25 ? (t25 ? structure[7] * t268 : TB_C(0.0)) : TB_C(0.0);
    const real_t t270 = t41 * (t262 + t263 + t265 + t267 + t269);
    const real_t t271 = t254 - structure[4] * t270;
    const real_t t272 = t256 - structure[1] * t270;
    const real_t t273 = t258 - structure[2] * t270;
    const real_t t274 = (t13 ? t75 * t272 : TB_C(0.0)) + (t15 ? (t15 ? t48 * t273 : TB_C(0.0))
        : TB_C(0.0));
    const real_t t275 = t260 - structure[3] * t270;
    const real_t t276 = t274 + (t17 ? (t17 ? t50 * t275 : TB_C(0.0)) : TB_C(0.0));
    const real_t t277 = t276 + (t19 ? (t19 ? t52 * t271 : TB_C(0.0)) : TB_C(0.0));
    const real_t t278 = t264 - structure[5] * t270;
    const real_t t279 = t277 + (t21 ? (t21 ? t54 * t278 : TB_C(0.0)) : TB_C(0.0));
    const real_t t280 = t266 - structure[6] * t270;
    const real_t t281 = t279 + (t23 ? (t23 ? t56 * t280 : TB_C(0.0)) : TB_C(0.0));
    const real_t t282 = t268 - structure[7] * t270;
    const real_t t283 = t281 + (t25 ? (t25 ? t58 * t282 : TB_C(0.0)) : TB_C(0.0));
    const real_t t284 = t88 * t283;
    const real_t t285 = t271 - t52 * t284;
    const real_t t286 = t273 - t48 * t284;
    const real_t t287 = t275 - t50 * t284;
    const real_t t288 = (t15 ? t143 * t286 : TB_C(0.0)) + (t17 ? (t17 ? t96 * t287 : TB_C(0.0))
        : TB_C(0.0));
    const real_t t289 = t288 + (t19 ? (t19 ? t98 * t285 : TB_C(0.0)) : TB_C(0.0));
    const real_t t290 = t278 - t54 * t284;
    const real_t t291 = t21 ? (t21 ? t100 * t290 : TB_C(0.0)) : TB_C(0.0);
    const real_t t292 = t280 - t56 * t284;
    const real_t t293 = t23 ? (t23 ? t102 * t292 : TB_C(0.0)) : TB_C(0.0);
    const real_t t294 = t282 - t58 * t284;
    const real_t t295 = t25 ? (t25 ? t104 * t294 : TB_C(0.0)) : TB_C(0.0);
    const real_t t296 = t154 * (t289 + t291 + t293 + t295);
    const real_t t297 = t285 - t98 * t296;
    const real_t t298 = t287 - t96 * t296;
    const real_t t299 = t19 ? (t19 ? t164 * t297 : TB_C(0.0)) : TB_C(0.0);
    const real_t t300 = t290 - t100 * t296;
    const real_t t301 = t21 ? (t21 ? t166 * t300 : TB_C(0.0)) : TB_C(0.0);
    const real_t t302 = t292 - t102 * t296;
    const real_t t303 = t23 ? (t23 ? t168 * t302 : TB_C(0.0)) : TB_C(0.0);
    const real_t t304 = (t17 ? t221 * t298 : TB_C(0.0)) + t299 + t301 + t303;
    const real_t t305 = t294 - t104 * t296;
    const real_t t306 = t25 ? (t25 ? t170 * t305 : TB_C(0.0)) : TB_C(0.0);
    const real_t t307 = t231 * (t304 + t306);
    const real_t t308 = t297 - t164 * t307;
    const real_t t309 = t250 + t251;
    const real_t t310 = t300 - t166 * t307;
    const real_t t311 = t21 ? (t21 ? t243 * t310 : TB_C(0.0)) : TB_C(0.0);
    const real_t t312 = t302 - t168 * t307;
    const real_t t313 = t23 ? (t23 ? t245 * t312 : TB_C(0.0)) : TB_C(0.0);
    const real_t t314 = t305 - t170 * t307;
    const real_t t315 = t25 ? (t25 ? t247 * t314 : TB_C(0.0)) : TB_C(0.0);
    const real_t t316 = (t19 ? t308 * t309 : TB_C(0.0)) + t311 + t313 + t315;
    const real_t t317 = t316 * (TB_C(1.0) / (t249 * (t249 + TB_ABS(t250))));
    const real_t t318 = (t19 ? t308 : TB_C(0.0)) - t309 * t317;
    const real_t t319 = TB_MOMENT_WEIGHT * wrench[5];
    const real_t t320 = t0 * t255 + t1 * t256 + t2 * t258 + t4 * t260 + t5 * t254;
    const real_t t321 = t319 - (t320 + t6 * t264 + t8 * t266 + t9 * t268);
    const real_t t322 = (t11 ? t255 : TB_C(0.0)) - t32 * t270;
    const real_t t323 = (t13 ? t272 : TB_C(0.0)) - t75 * t284;
    const real_t t324 = (t15 ? t286 : TB_C(0.0)) - t143 * t296;
    const real_t t325 = (t17 ? t298 : TB_C(0.0)) - t221 * t307;
    const real_t t326 = t321 + t31 * t322 + t64 * t323 + t110 * t324 + t176 * t325;
    const real_t t327 = t310 - t243 * t317;
    const real_t t328 = t21 ? (t21 ? t327 * t327 : TB_C(0.0)) : TB_C(0.0);
    const real_t t329 = t312 - t245 * t317;
    const real_t t330 = t23 ? (t23 ? t329 * t329 : TB_C(0.0)) : TB_C(0.0);
    const real_t t331 = t314 - t247 * t317;
    const real_t t332 = t25 ? (t25 ? t331 * t331 : TB_C(0.0)) : TB_C(0.0);
    const real_t t333 = TB_COPYSIGN(TB_SQRT(t328 + t330 + t332), t21 ? t327 : TB_C(0.0));
    const real_t t334 = TB_C(1.0) / t333;
    const real_t t335 = t334 * ((t326 + t253 * t318) * t334);
    const real_t t336 = t252 * (t253 + t318 * t335);
    const real_t t337 = t175 * (t176 + t233 * t336 + t325 * t335);
    const real_t t338 = t109 * (t110 + t156 * t337 + t239 * t336 + t324 * t335);
    const real_t t339 = t64 + t90 * t338 + t161 * t337 + t238 * t336 + t323 * t335;
    const real_t t340 = t63 * t339;
    const real_t t341 = t31 + t43 * t340 + t94 * t338 + t160 * t337 + t237 * t336;
    const real_t t342 = t30 * (t341 + t322 * t335);
    const real_t t343 = structure[0] * t342 + structure[8] * t340 + structure[16] * t338;
    const real_t t344 = t343 + t112 * t337 + t178 * t336 + t255 * t335;
    const real_t t345 = structure[1] * t342 + structure[9] * t340 + structure[17] * t338;
    const real_t t346 = t345 + t113 * t337 + t179 * t336 + t256 * t335;
    const real_t t347 = (t11 ? structure[0] * t344 : TB_C(0.0)) + (t13 ? structure[1] * t346 :
        TB_C(0.0));
    const real_t t348 = structure[2] * t342 + structure[10] * t340 + structure[18] * t338;
    const real_t t349 = t348 + t111 * t337 + t181 * t336 + t258 * t335;
    const real_t t350 = structure[3] * t342 + structure[11] * t340 + structure[19] * t338;
    const real_t t351 = t350 + t116 * t337 + t177 * t336 + t260 * t335;
    const real_t t352 = t347 + (t15 ? structure[2] * t349 : TB_C(0.0)) + (t17 ? structure[3] *
        t351 : TB_C(0.0));
    const real_t t353 = structure[4] * t342 + structure[12] * t340 + structure[20] * t338;
    const real_t t354 = t353 + t119 * t337 + t185 * t336 + t254 * t335;
    const real_t t355 = structure[5] * t342 + structure[13] * t340 + structure[21] * t338;
    const real_t t356 = t355 + t121 * t337 + t187 * t336 + t264 * t335;
    const real_t t357 = t352 + (t19 ? structure[4] * t354 : TB_C(0.0)) + (t21 ? structure[5] *
        t356 : TB_C(0.0));
    const real_t t358 = structure[6] * t342 + structure[14] * t340 + structure[22] * t338;
    const real_t t359 = t358 + t123 * t337 + t189 * t336 + t266 * t335;
    const real_t t360 = structure[7] * t342 + structure[15] * t340 + structure[23] * t338;
    const real_t t361 = t360 + t125 * t337 + t191 * t336 + t268 * t335;
    const real_t t362 = t357 + (t23 ? structure[6] * t359 : TB_C(0.0)) + (t25 ? structure[7] *
        t361 : TB_C(0.0));
    const real_t t363 = t30 * (t10 - t362);
    const real_t t364 = (t11 ? structure[8] * t344 : TB_C(0.0)) + (t13 ? structure[9] * t346 :
        TB_C(0.0));
    const real_t t365 = t364 + (t15 ? structure[10] * t349 : TB_C(0.0)) + (t17 ? structure[11]
        * t351 : TB_C(0.0));
    const real_t t366 = t365 + (t19 ? structure[12] * t354 : TB_C(0.0)) + (t21 ? structure[13]
        * t356 : TB_C(0.0));
    const real_t t367 = t366 + (t23 ? structure[14] * t359 : TB_C(0.0)) + (t25 ? structure[15]
        * t361 : TB_C(0.0));
    const real_t t368 = t63 * (t46 - t367 + t43 * t363);
    const real_t t369 = (t11 ? structure[16] * t344 : TB_C(0.0)) + (t13 ? structure[17] * t346
        : TB_C(0.0));
    const real_t t370 = t369 + (t15 ? structure[18] * t349 : TB_C(0.0)) + (t17 ? structure[19]
        * t351 : TB_C(0.0));
    const real_t t371 = t370 + (t19 ? structure[20] * t354 : TB_C(0.0)) + (t21 ? structure[21]
        * t356 : TB_C(0.0));
    const real_t t372 = t371 + (t23 ? structure[22] * t359 : TB_C(0.0)) + (t25 ? structure[23]
        * t361 : TB_C(0.0));
    const real_t t373 = t109 * (t93 - t372 + t94 * t363 + t90 * t368);
    const real_t t374 = (t11 ? t112 * t344 : TB_C(0.0)) + (t13 ? t113 * t346 : TB_C(0.0));
    const real_t t375 = t374 + (t15 ? t111 * t349 : TB_C(0.0)) + (t17 ? t116 * t351 :
        TB_C(0.0));
    const real_t t376 = t375 + (t19 ? t119 * t354 : TB_C(0.0)) + (t21 ? t121 * t356 :
        TB_C(0.0));
    const real_t t377 = t376 + (t23 ? t123 * t359 : TB_C(0.0)) + (t25 ? t125 * t361 :
        TB_C(0.0));
    const real_t t378 = t159 - t377 + t160 * t363 + t161 * t368 + t156 * t373;
    const real_t t379 = t175 * t378;
    const real_t t380 = (t11 ? t178 * t344 : TB_C(0.0)) + (t13 ? t179 * t346 : TB_C(0.0));
    const real_t t381 = t380 + (t15 ? t181 * t349 : TB_C(0.0)) + (t17 ? t177 * t351 :
        TB_C(0.0));
    const real_t t382 = t381 + (t19 ? t185 * t354 : TB_C(0.0)) + (t21 ? t187 * t356 :
        TB_C(0.0));
    const real_t t383 = t382 + (t23 ? t189 * t359 : TB_C(0.0)) + (t25 ? t191 * t361 :
        TB_C(0.0));
    const real_t t384 = t236 - t383 + t237 * t363 + t238 * t368 + t239 * t373;
    const real_t t385 = t252 * (t384 + t233 * t379);
    const real_t t386 = (t11 ? t255 * t344 : TB_C(0.0)) + (t13 ? t256 * t346 : TB_C(0.0));
    const real_t t387 = t386 + (t15 ? t258 * t349 : TB_C(0.0)) + (t17 ? t260 * t351 :
        TB_C(0.0));
    const real_t t388 = t387 + (t19 ? t254 * t354 : TB_C(0.0)) + (t21 ? t264 * t356 :
        TB_C(0.0));
    const real_t t389 = t388 + (t23 ? t266 * t359 : TB_C(0.0)) + (t25 ? t268 * t361 :
        TB_C(0.0));
    const real_t t390 = t321 - t389 + t322 * t363 + t323 * t368 + t324 * t373;
    const real_t t391 = t334 * (t334 * (t390 + t325 * t379 + t318 * t385));
    const real_t t392 = t252 * (t385 + t318 * t391);
    const real_t t393 = t175 * (t379 + t233 * t392 + t325 * t391);
    const real_t t394 = t109 * (t373 + t156 * t393 + t239 * t392 + t324 * t391);
    const real_t t395 = t368 + t90 * t394 + t161 * t393 + t238 * t392 + t323 * t391;
    const real_t t396 = t63 * t395;
    const real_t t397 = t363 + t43 * t396 + t94 * t394 + t160 * t393 + t237 * t392;
    const real_t t398 = t30 * (t397 + t322 * t391);
    const real_t t399 = structure[0] * t398 + structure[8] * t396 + structure[16] * t394;
    const real_t t400 = t344 + (t399 + t112 * t393 + t178 * t392 + t255 * t391);
    const real_t t401 = structure[1] * t398 + structure[9] * t396 + structure[17] * t394;
    const real_t t402 = t346 + (t401 + t113 * t393 + t179 * t392 + t256 * t391);
    const real_t t403 = tb_max(side[0] * (t0 - t400), side[1] * (t1 - t402));
    const real_t t404 = structure[2] * t398 + structure[10] * t396 + structure[18] * t394;
    const real_t t405 = t349 + (t404 + t111 * t393 + t181 * t392 + t258 * t391);
    const real_t t406 = structure[3] * t398 + structure[11] * t396 + structure[19] * t394;
    const real_t t407 = t351 + (t406 + t116 * t393 + t177 * t392 + t260 * t391);
    const real_t t408 = tb_max(tb_max(t403, side[2] * (t2 - t405)), side[3] * (t4 - t407));
    const real_t t409 = structure[4] * t398 + structure[12] * t396 + structure[20] * t394;
    const real_t t410 = t354 + (t409 + t119 * t393 + t185 * t392 + t254 * t391);
    const real_t t411 = structure[5] * t398 + structure[13] * t396 + structure[21] * t394;
    const real_t t412 = t356 + (t411 + t121 * t393 + t187 * t392 + t264 * t391);
    const real_t t413 = tb_max(tb_max(t408, side[4] * (t5 - t410)), side[5] * (t6 - t412));
    const real_t t414 = structure[6] * t398 + structure[14] * t396 + structure[22] * t394;
    const real_t t415 = t359 + (t414 + t123 * t393 + t189 * t392 + t266 * t391);
    const real_t t416 = structure[7] * t398 + structure[15] * t396 + structure[23] * t394;
    const real_t t417 = t361 + (t416 + t125 * t393 + t191 * t392 + t268 * t391);
    const real_t t418 = tb_max(tb_max(t413, side[6] * (t8 - t415)), side[7] * (t9 - t417));
    const real_t t419 = tb_min(tb_min(TB_ABS(t29), TB_ABS(t62)), TB_ABS(t108));
    const real_t t420 = tb_min(tb_min(tb_min(t419, TB_ABS(t174)), TB_ABS(t251)), TB_ABS(t333));
    const real_t t421 = tb_max(TB_C(0.0), t418) * tb_min(TB_C(1.0), t420);
    const real_t t422 = TB_ABS(wrench[0]) + TB_ABS(wrench[1]) + TB_ABS(wrench[2]);
    const real_t t423 = t422 + TB_ABS(t157) + TB_ABS(t234) + TB_ABS(t319);
    const real_t t424 = TB_TENSION_MIN + t423;
    const real_t t425 = tb_max(tb_max(TB_ABS(t342), TB_ABS(t340)), TB_ABS(t338));
    const real_t t426 = tb_max(tb_max(tb_max(t425, TB_ABS(t337)), TB_ABS(t336)), TB_ABS(t335));
    const real_t t427 = tb_min(tb_max(t11 ? t400 : t0, TB_TENSION_MIN), TB_C(1000000000000.0));
    const real_t t428 = tb_min(tb_max(t13 ? t402 : t1, TB_TENSION_MIN), TB_C(1000000000000.0));
    const real_t t429 = tb_min(tb_max(t15 ? t405 : t2, TB_TENSION_MIN), TB_C(1000000000000.0));
    const real_t t430 = structure[0] * t427 + structure[1] * t428 + structure[2] * t429;
    const real_t t431 = tb_min(tb_max(t17 ? t407 : t4, TB_TENSION_MIN), TB_C(1000000000000.0));
    const real_t t432 = tb_min(tb_max(t19 ? t410 : t5, TB_TENSION_MIN), TB_C(1000000000000.0));
    const real_t t433 = tb_min(tb_max(t21 ? t412 : t6, TB_TENSION_MIN), TB_C(1000000000000.0));
    const real_t t434 = t430 + structure[3] * t431 + structure[4] * t432 + structure[5] * t433;
    const real_t t435 = tb_min(tb_max(t23 ? t415 : t8, TB_TENSION_MIN), TB_C(1000000000000.0));
    const real_t t436 = tb_min(tb_max(t25 ? t417 : t9, TB_TENSION_MIN), TB_C(1000000000000.0));
    const real_t t437 = t434 + structure[6] * t435 + structure[7] * t436 - wrench[0];
    const real_t t438 = tb_max(t421 * t424 * (TB_C(1.0) / tb_max(t424, t426)), TB_ABS(t437));
    const real_t t439 = structure[8] * t427 + structure[9] * t428 + structure[10] * t429;
    const real_t t440 = t439 + structure[11] * t431 + structure[12] * t432;
    const real_t t441 = t440 + structure[13] * t433 + structure[14] * t435;
    const real_t t442 = tb_max(t438, TB_ABS(t441 + structure[15] * t436 - wrench[1]));
    const real_t t443 = structure[16] * t427 + structure[17] * t428 + structure[18] * t429;
    const real_t t444 = t443 + structure[19] * t431 + structure[20] * t432;
    const real_t t445 = t444 + structure[21] * t433 + structure[22] * t435;
    const real_t t446 = tb_max(t442, TB_ABS(t445 + structure[23] * t436 - wrench[2]));
    const real_t t447 = t112 * t427 + t113 * t428 + t111 * t429 + t116 * t431;
    const real_t t448 = t447 + t119 * t432 + t121 * t433 + t123 * t435 + t125 * t436;
    const real_t t449 = t178 * t427 + t179 * t428 + t181 * t429 + t177 * t431;
    const real_t t450 = t449 + t185 * t432 + t187 * t433 + t189 * t435 + t191 * t436;
    const real_t t451 = tb_max(tb_max(t446, TB_ABS(t448 - t157)), TB_ABS(t450 - t234));
    const real_t t452 = t255 * t427 + t256 * t428 + t258 * t429 + t260 * t431;
    const real_t t453 = t452 + t254 * t432 + t264 * t433 + t266 * t435 + t268 * t436;
    const real_t t454 = tb_max(t451, TB_ABS(t453 - t319));
    const real_t t455 = tb_max(tb_max(tb_max(tb_max(t427, t428), t429), t431), t432);
    const real_t t456 = TB_C(128.0) * TB_EPSILON * tb_max(tb_max(tb_max(t455, t433), t435),
        t436);
    const real_t t457 = tb_min(t456 * (TB_C(1.0) / pivot[0]), TB_C(0.008));
    const bool t458 = t454 <= t457;
    real_t tension_0, tension_1, tension_2, tension_3, tension_4, tension_5, tension_6,
        tension_7, kkt_residual_0;
    if (t458) {
        tension_0 = tb_min(t427, TB_TENSION_MAX);
        tension_1 = tb_min(t428, TB_TENSION_MAX);
        tension_2 = tb_min(t429, TB_TENSION_MAX);
        tension_3 = tb_min(t431, TB_TENSION_MAX);
        tension_4 = tb_min(t432, TB_TENSION_MAX);
        tension_5 = tb_min(t433, TB_TENSION_MAX);
        tension_6 = tb_min(t435, TB_TENSION_MAX);
        tension_7 = tb_min(t436, TB_TENSION_MAX);
        kkt_residual_0 = t454;
    } else {
        tension_0 = TB_TENSION_MIN;
        tension_1 = TB_TENSION_MIN;
        tension_2 = TB_TENSION_MIN;
        tension_3 = TB_TENSION_MIN;
        tension_4 = TB_TENSION_MIN;
        tension_5 = TB_TENSION_MIN;
        tension_6 = TB_TENSION_MIN;
        tension_7 = TB_TENSION_MIN;
        kkt_residual_0 = TB_C(0.0);
    }
    const bool t459 = !t458;
    const real_t t460 = structure[0] * tension_0 + structure[1] * tension_1;
    const real_t t461 = t460 + structure[2] * tension_2 + structure[3] * tension_3;
    const real_t t462 = t461 + structure[4] * tension_4 + structure[5] * tension_5;
    const real_t delivered_0 = t462 + structure[6] * tension_6 + structure[7] * tension_7;
    const real_t t463 = structure[8] * tension_0 + structure[9] * tension_1;
    const real_t t464 = t463 + structure[10] * tension_2 + structure[11] * tension_3;
    const real_t t465 = t464 + structure[12] * tension_4 + structure[13] * tension_5;
    const real_t delivered_1 = t465 + structure[14] * tension_6 + structure[15] * tension_7;
    const real_t t466 = structure[16] * tension_0 + structure[17] * tension_1;
    const real_t t467 = t466 + structure[18] * tension_2 + structure[19] * tension_3;
    const real_t t468 = t467 + structure[20] * tension_4 + structure[21] * tension_5;
    const real_t delivered_2 = t468 + structure[22] * tension_6 + structure[23] * tension_7;
    const real_t t469 = structure[24] * tension_0 + structure[25] * tension_1;
    const real_t t470 = t469 + structure[26] * tension_2 + structure[27] * tension_3;
    const real_t t471 = t470 + structure[28] * tension_4 + structure[29] * tension_5;
    const real_t delivered_3 = t471 + structure[30] * tension_6 + structure[31] * tension_7;
    const real_t t472 = structure[32] * tension_0 + structure[33] * tension_1;
    const real_t t473 = t472 + structure[34] * tension_2 + structure[35] * tension_3;
    const real_t t474 = t473 + structure[36] * tension_4 + structure[37] * tension_5;
    const real_t delivered_4 = t474 + structure[38] * tension_6 + structure[39] * tension_7;
    const real_t t475 = structure[40] * tension_0 + structure[41] * tension_1;
    const real_t t476 = t475 + structure[42] * tension_2 + structure[43] * tension_3;
    const real_t t477 = t476 + structure[44] * tension_4 + structure[45] * tension_5;
    const real_t delivered_5 = t477 + structure[46] * tension_6 + structure[47] * tension_7;
    const bool t478 = TB_TENSION_MAX < t427 || TB_TENSION_MAX < t428 || TB_TENSION_MAX < t429;
    const bool t479 = t478 || TB_TENSION_MAX < t431 || TB_TENSION_MAX < t432 || TB_TENSION_MAX
        < t433;
    const bool t480 = t479 || TB_TENSION_MAX < t435 || TB_TENSION_MAX < t436;
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    tension[4] = tension_4;
    tension[5] = tension_5;
    tension[6] = tension_6;
    tension[7] = tension_7;
    delivered[0] = delivered_0;
    delivered[1] = delivered_1;
    delivered[2] = delivered_2;
    delivered[3] = delivered_3;
    delivered[4] = delivered_4;
    delivered[5] = delivered_5;
    kkt_residual[0] = kkt_residual_0;
    return (t459 || t480) ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_distribute_tension_paper(const real_t structure[48], const real_t wrench[6],
    real_t tension[8], real_t delivered[6], real_t kkt_residual[1])
{
    real_t pivot[1];
    real_t side[8];
    real_t moving[1];
    real_t push[1];
    real_t done[1] = {TB_C(0.0)};
    tb_status status = tb_distribute_tension_paper_begin(structure, wrench, pivot, side,
        moving, push);
    for (int steps = 0; steps < 40 && status == TB_OK && !(done[0] > TB_C(0.0)); steps++) {
        status = tb_distribute_tension_paper_step(structure, wrench, side, moving, push, done);
    }
    if (status == TB_OK && !(done[0] > TB_C(0.0))) {
        status = TB_INACCURATE;
    }
    if (status != TB_OK) {
        tension[0] = TB_TENSION_MIN;
        tension[1] = TB_TENSION_MIN;
        tension[2] = TB_TENSION_MIN;
        tension[3] = TB_TENSION_MIN;
        tension[4] = TB_TENSION_MIN;
        tension[5] = TB_TENSION_MIN;
        tension[6] = TB_TENSION_MIN;
        tension[7] = TB_TENSION_MIN;
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        delivered[2] = TB_C(0.0);
        delivered[3] = TB_C(0.0);
        delivered[4] = TB_C(0.0);
        delivered[5] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return status;
    }
    return tb_distribute_tension_paper_finish(structure, wrench, pivot, side, tension,
        delivered, kkt_residual);
}

/* One vertex of the feasible wrenches. */
static tb_status tb_served_wrench_closest_begin(const real_t structure[48], const real_t wrench[6],
    real_t points[42], real_t weight[7], real_t used[7], real_t offset[6])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) + TB_ABS(structure[10]) + TB_ABS(structure[11]) +
              TB_ABS(structure[12]) + TB_ABS(structure[13]) + TB_ABS(structure[14]) +
              TB_ABS(structure[15]) + TB_ABS(structure[16]) + TB_ABS(structure[17]) +
              TB_ABS(structure[18]) + TB_ABS(structure[19]) + TB_ABS(structure[20]) +
              TB_ABS(structure[21]) + TB_ABS(structure[22]) + TB_ABS(structure[23]) +
              TB_ABS(structure[24]) + TB_ABS(structure[25]) + TB_ABS(structure[26]) +
              TB_ABS(structure[27]) + TB_ABS(structure[28]) + TB_ABS(structure[29]) +
              TB_ABS(structure[30]) + TB_ABS(structure[31]) + TB_ABS(structure[32]) +
              TB_ABS(structure[33]) + TB_ABS(structure[34]) + TB_ABS(structure[35]) +
              TB_ABS(structure[36]) + TB_ABS(structure[37]) + TB_ABS(structure[38]) +
              TB_ABS(structure[39]) + TB_ABS(structure[40]) + TB_ABS(structure[41]) +
              TB_ABS(structure[42]) + TB_ABS(structure[43]) + TB_ABS(structure[44]) +
              TB_ABS(structure[45]) + TB_ABS(structure[46]) + TB_ABS(structure[47]) <=
              TB_C(192.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) + TB_ABS(wrench[2]) + TB_ABS(wrench[3]) +
              TB_ABS(wrench[4]) + TB_ABS(wrench[5]) <= TB_C(384000.0))) {
        points[0] = TB_C(0.0);
        points[1] = TB_C(0.0);
        points[2] = TB_C(0.0);
        points[3] = TB_C(0.0);
        points[4] = TB_C(0.0);
        points[5] = TB_C(0.0);
        points[6] = TB_C(0.0);
        points[7] = TB_C(0.0);
        points[8] = TB_C(0.0);
        points[9] = TB_C(0.0);
        points[10] = TB_C(0.0);
        points[11] = TB_C(0.0);
        points[12] = TB_C(0.0);
        points[13] = TB_C(0.0);
        points[14] = TB_C(0.0);
        points[15] = TB_C(0.0);
        points[16] = TB_C(0.0);
        points[17] = TB_C(0.0);
        points[18] = TB_C(0.0);
        points[19] = TB_C(0.0);
        points[20] = TB_C(0.0);
        points[21] = TB_C(0.0);
        points[22] = TB_C(0.0);
        points[23] = TB_C(0.0);
        points[24] = TB_C(0.0);
        points[25] = TB_C(0.0);
        points[26] = TB_C(0.0);
        points[27] = TB_C(0.0);
        points[28] = TB_C(0.0);
        points[29] = TB_C(0.0);
        points[30] = TB_C(0.0);
        points[31] = TB_C(0.0);
        points[32] = TB_C(0.0);
        points[33] = TB_C(0.0);
        points[34] = TB_C(0.0);
        points[35] = TB_C(0.0);
        points[36] = TB_C(0.0);
        points[37] = TB_C(0.0);
        points[38] = TB_C(0.0);
        points[39] = TB_C(0.0);
        points[40] = TB_C(0.0);
        points[41] = TB_C(0.0);
        weight[0] = TB_C(0.0);
        weight[1] = TB_C(0.0);
        weight[2] = TB_C(0.0);
        weight[3] = TB_C(0.0);
        weight[4] = TB_C(0.0);
        weight[5] = TB_C(0.0);
        weight[6] = TB_C(0.0);
        used[0] = TB_C(0.0);
        used[1] = TB_C(0.0);
        used[2] = TB_C(0.0);
        used[3] = TB_C(0.0);
        used[4] = TB_C(0.0);
        used[5] = TB_C(0.0);
        used[6] = TB_C(0.0);
        offset[0] = TB_C(0.0);
        offset[1] = TB_C(0.0);
        offset[2] = TB_C(0.0);
        offset[3] = TB_C(0.0);
        offset[4] = TB_C(0.0);
        offset[5] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = structure[0] + structure[1] + structure[2] + structure[3];
    const real_t t1 = t0 + structure[4] + structure[5] + structure[6] + structure[7];
    const real_t t2 = TB_TENSION_MIDDLE * t1 - wrench[0];
    const real_t t3 = structure[8] + structure[9] + structure[10] + structure[11];
    const real_t t4 = t3 + structure[12] + structure[13] + structure[14];
    const real_t t5 = TB_TENSION_MIDDLE * (t4 + structure[15]) - wrench[1];
    const real_t t6 = structure[16] + structure[17] + structure[18] + structure[19];
    const real_t t7 = t6 + structure[20] + structure[21] + structure[22];
    const real_t t8 = TB_TENSION_MIDDLE * (t7 + structure[23]) - wrench[2];
    const real_t t9 = structure[0] * t2 + structure[8] * t5 + structure[16] * t8;
    const real_t t10 = TB_MOMENT_WEIGHT * structure[24];
    const real_t t11 = TB_MOMENT_WEIGHT * structure[25];
    const real_t t12 = TB_MOMENT_WEIGHT * structure[26];
    const real_t t13 = TB_MOMENT_WEIGHT * structure[27];
    const real_t t14 = TB_MOMENT_WEIGHT * structure[28];
    const real_t t15 = TB_MOMENT_WEIGHT * structure[29];
    const real_t t16 = TB_MOMENT_WEIGHT * structure[30];
    const real_t t17 = TB_MOMENT_WEIGHT * structure[31];
    const real_t t18 = TB_TENSION_MIDDLE * (t10 + t11 + t12 + t13 + t14 + t15 + t16 + t17);
    const real_t t19 = TB_MOMENT_WEIGHT * wrench[3];
    const real_t t20 = t18 - t19;
    const real_t t21 = TB_MOMENT_WEIGHT * structure[32];
    const real_t t22 = TB_MOMENT_WEIGHT * structure[33];
    const real_t t23 = TB_MOMENT_WEIGHT * structure[34];
    const real_t t24 = TB_MOMENT_WEIGHT * structure[35];
    const real_t t25 = TB_MOMENT_WEIGHT * structure[36];
    const real_t t26 = TB_MOMENT_WEIGHT * structure[37];
    const real_t t27 = TB_MOMENT_WEIGHT * structure[38];
    const real_t t28 = TB_MOMENT_WEIGHT * structure[39];
    const real_t t29 = TB_TENSION_MIDDLE * (t21 + t22 + t23 + t24 + t25 + t26 + t27 + t28);
    const real_t t30 = TB_MOMENT_WEIGHT * wrench[4];
    const real_t t31 = t29 - t30;
    const real_t t32 = TB_MOMENT_WEIGHT * structure[40];
    const real_t t33 = TB_MOMENT_WEIGHT * structure[41];
    const real_t t34 = TB_MOMENT_WEIGHT * structure[42];
    const real_t t35 = TB_MOMENT_WEIGHT * structure[43];
    const real_t t36 = TB_MOMENT_WEIGHT * structure[44];
    const real_t t37 = TB_MOMENT_WEIGHT * structure[45];
    const real_t t38 = TB_MOMENT_WEIGHT * structure[46];
    const real_t t39 = TB_MOMENT_WEIGHT * structure[47];
    const real_t t40 = TB_TENSION_MIDDLE * (t32 + t33 + t34 + t35 + t36 + t37 + t38 + t39);
    const real_t t41 = TB_MOMENT_WEIGHT * wrench[5];
    const real_t t42 = t40 - t41;
    const bool t43 = t9 + t10 * t20 + t21 * t31 + t32 * t42 < TB_C(0.0);
    const real_t t44 = t43 ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t45 = structure[1] * t2 + structure[9] * t5 + structure[17] * t8;
    const bool t46 = t45 + t11 * t20 + t22 * t31 + t33 * t42 < TB_C(0.0);
    const real_t t47 = t46 ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t48 = structure[2] * t2 + structure[10] * t5 + structure[18] * t8;
    const bool t49 = t48 + t12 * t20 + t23 * t31 + t34 * t42 < TB_C(0.0);
    const real_t t50 = t49 ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t51 = structure[0] * t44 + structure[1] * t47 + structure[2] * t50;
    const real_t t52 = structure[3] * t2 + structure[11] * t5 + structure[19] * t8;
    const bool t53 = t52 + t13 * t20 + t24 * t31 + t35 * t42 < TB_C(0.0);
    const real_t t54 = t53 ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t55 = structure[4] * t2 + structure[12] * t5 + structure[20] * t8;
    const bool t56 = t55 + t14 * t20 + t25 * t31 + t36 * t42 < TB_C(0.0);
    const real_t t57 = t56 ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t58 = structure[5] * t2 + structure[13] * t5 + structure[21] * t8;
    const bool t59 = t58 + t15 * t20 + t26 * t31 + t37 * t42 < TB_C(0.0);
    const real_t t60 = t59 ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t61 = t51 + structure[3] * t54 + structure[4] * t57 + structure[5] * t60;
    const real_t t62 = structure[6] * t2 + structure[14] * t5 + structure[22] * t8;
    const bool t63 = t62 + t16 * t20 + t27 * t31 + t38 * t42 < TB_C(0.0);
    const real_t t64 = t63 ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t65 = structure[7] * t2 + structure[15] * t5 + structure[23] * t8;
    const bool t66 = t65 + t17 * t20 + t28 * t31 + t39 * t42 < TB_C(0.0);
    const real_t t67 = t66 ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t points_0 = t61 + structure[6] * t64 + structure[7] * t67 - wrench[0];
    const real_t t68 = structure[8] * t44 + structure[9] * t47 + structure[10] * t50;
    const real_t t69 = t68 + structure[11] * t54 + structure[12] * t57 + structure[13] * t60;
    const real_t points_1 = t69 + structure[14] * t64 + structure[15] * t67 - wrench[1];
    const real_t t70 = structure[16] * t44 + structure[17] * t47 + structure[18] * t50;
    const real_t t71 = t70 + structure[19] * t54 + structure[20] * t57 + structure[21] * t60;
    const real_t points_2 = t71 + structure[22] * t64 + structure[23] * t67 - wrench[2];
    const real_t t72 = t10 * t44 + t11 * t47 + t12 * t50 + t13 * t54 + t14 * t57;
    const real_t points_3 = t72 + t15 * t60 + t16 * t64 + t17 * t67 - t19;
    const real_t t73 = t21 * t44 + t22 * t47 + t23 * t50 + t24 * t54 + t25 * t57;
    const real_t points_4 = t73 + t26 * t60 + t27 * t64 + t28 * t67 - t30;
    const real_t t74 = t32 * t44 + t33 * t47 + t34 * t50 + t35 * t54 + t36 * t57;
    const real_t points_5 = t74 + t37 * t60 + t38 * t64 + t39 * t67 - t41;
    points[0] = points_0;
    points[1] = points_1;
    points[2] = points_2;
    points[3] = points_3;
    points[4] = points_4;
    points[5] = points_5;
    points[6] = TB_C(0.0);
    points[7] = TB_C(0.0);
    points[8] = TB_C(0.0);
    points[9] = TB_C(0.0);
    points[10] = TB_C(0.0);
    points[11] = TB_C(0.0);
    points[12] = TB_C(0.0);
    points[13] = TB_C(0.0);
    points[14] = TB_C(0.0);
    points[15] = TB_C(0.0);
    points[16] = TB_C(0.0);
    points[17] = TB_C(0.0);
    points[18] = TB_C(0.0);
    points[19] = TB_C(0.0);
    points[20] = TB_C(0.0);
    points[21] = TB_C(0.0);
    points[22] = TB_C(0.0);
    points[23] = TB_C(0.0);
    points[24] = TB_C(0.0);
    points[25] = TB_C(0.0);
    points[26] = TB_C(0.0);
    points[27] = TB_C(0.0);
    points[28] = TB_C(0.0);
    points[29] = TB_C(0.0);
    points[30] = TB_C(0.0);
    points[31] = TB_C(0.0);
    points[32] = TB_C(0.0);
    points[33] = TB_C(0.0);
    points[34] = TB_C(0.0);
    points[35] = TB_C(0.0);
    points[36] = TB_C(0.0);
    points[37] = TB_C(0.0);
    points[38] = TB_C(0.0);
    points[39] = TB_C(0.0);
    points[40] = TB_C(0.0);
    points[41] = TB_C(0.0);
    weight[0] = TB_C(1.0);
    weight[1] = TB_C(0.0);
    weight[2] = TB_C(0.0);
    weight[3] = TB_C(0.0);
    weight[4] = TB_C(0.0);
    weight[5] = TB_C(0.0);
    weight[6] = TB_C(0.0);
    used[0] = TB_C(1.0);
    used[1] = TB_C(0.0);
    used[2] = TB_C(0.0);
    used[3] = TB_C(0.0);
    used[4] = TB_C(0.0);
    used[5] = TB_C(0.0);
    used[6] = TB_C(0.0);
    offset[0] = points_0;
    offset[1] = points_1;
    offset[2] = points_2;
    offset[3] = points_3;
    offset[4] = points_4;
    offset[5] = points_5;
    return TB_OK;
}

/* A vertex of the feasible wrenches joins or is dropped. */
static tb_status tb_served_wrench_closest_step(const real_t structure[48], const real_t wrench[6],
    real_t points[42], real_t weight[7], real_t used[7], real_t offset[6], real_t done[1])
{
    const bool t0 = TB_C(0.0) < used[0];
    const bool t1 = TB_C(0.0) < used[4];
    const real_t t2 = t1 ? weight[4] : -TB_C(1.0);
    const bool t3 = TB_C(0.0) < used[5];
    const real_t t4 = t3 ? weight[5] : -TB_C(1.0);
    const real_t t5 = tb_max(t2, t4);
    const bool t6 = TB_C(0.0) < used[6];
    const real_t t7 = t6 ? weight[6] : -TB_C(1.0);
    const real_t t8 = t0 ? weight[0] : -TB_C(1.0);
    const bool t9 = TB_C(0.0) < used[1];
    const real_t t10 = t9 ? weight[1] : -TB_C(1.0);
    const real_t t11 = tb_max(t8, t10);
    const bool t12 = TB_C(0.0) < used[2];
    const real_t t13 = t12 ? weight[2] : -TB_C(1.0);
    const bool t14 = TB_C(0.0) < used[3];
    const real_t t15 = t14 ? weight[3] : -TB_C(1.0);
    const bool t16 = tb_max(t5, t7) <= tb_max(tb_max(t11, t13), t15);
    real_t t17, t18, t19, t20, t21, t22, t23;
    if (t16) {
        const bool t24 = tb_max(t13, t15) <= t11;
        real_t t25, t26, t27, t28, t29, t30, t31;
        if (t24) {
            const bool t32 = t10 <= t8;
            t25 = t32 ? TB_C(0.0) : TB_C(1.0);
            t26 = t32 ? points[0] : points[6];
            t27 = t32 ? points[1] : points[7];
            t28 = t32 ? points[2] : points[8];
            t29 = t32 ? points[3] : points[9];
            t30 = t32 ? points[4] : points[10];
            t31 = t32 ? points[5] : points[11];
        } else {
            const bool t33 = t15 <= t13;
            t25 = t33 ? TB_C(2.0) : TB_C(3.0);
            t26 = t33 ? points[12] : points[18];
            t27 = t33 ? points[13] : points[19];
            t28 = t33 ? points[14] : points[20];
            t29 = t33 ? points[15] : points[21];
            t30 = t33 ? points[16] : points[22];
            t31 = t33 ? points[17] : points[23];
        }
        t17 = t25;
        t18 = t26;
        t19 = t27;
        t20 = t28;
        t21 = t29;
        t22 = t30;
        t23 = t31;
    } else {
        const bool t34 = t7 <= t5;
        real_t t35, t36, t37, t38, t39, t40, t41;
        if (t34) {
            const bool t42 = t4 <= t2;
            t35 = t42 ? TB_C(4.0) : TB_C(5.0);
            t36 = t42 ? points[24] : points[30];
            t37 = t42 ? points[25] : points[31];
            t38 = t42 ? points[26] : points[32];
            t39 = t42 ? points[27] : points[33];
            t40 = t42 ? points[28] : points[34];
            t41 = t42 ? points[29] : points[35];
        } else {
            t35 = TB_C(6.0);
            t36 = points[36];
            t37 = points[37];
            t38 = points[38];
            t39 = points[39];
            t40 = points[40];
            t41 = points[41];
        }
        t17 = t35;
        t18 = t36;
        t19 = t37;
        t20 = t38;
        t21 = t39;
        t22 = t40;
        t23 = t41;
    }
    const bool t43 = TB_C(0.0) == t17;
    const real_t t44 = used[0] * (points[0] - t18);
    const real_t t45 = used[0] * (points[1] - t19);
    const real_t t46 = used[0] * (points[2] - t20);
    const real_t t47 = used[0] * (points[3] - t21);
    const real_t t48 = used[0] * (points[4] - t22);
    const real_t t49 = t44 * t44 + t45 * t45 + t46 * t46 + t47 * t47 + t48 * t48;
    const real_t t50 = used[0] * (points[5] - t23);
    const real_t t51 = t43 ? TB_C(0.0) : (t43 ? TB_C(0.0) : t49 + t50 * t50);
    const bool t52 = TB_C(0.0) < t51;
    const real_t t53 = TB_SQRT(t51);
    const real_t t54 = TB_C(1.0) / t53;
    const real_t t55 = t44 * t54;
    const real_t t56 = t45 * t54;
    const real_t t57 = t46 * t54;
    const real_t t58 = t47 * t54;
    const real_t t59 = t48 * t54;
    const real_t t60 = t18 * t55 + t19 * t56 + t20 * t57 + t21 * t58 + t22 * t59;
    const real_t t61 = t50 * t54;
    const real_t t62 = t60 + t23 * t61;
    const bool t63 = TB_C(1.0) == t17;
    const real_t t64 = used[1] * (points[6] - t18);
    const real_t t65 = used[1] * (points[7] - t19);
    const real_t t66 = used[1] * (points[8] - t20);
    const real_t t67 = used[1] * (points[9] - t21);
    const real_t t68 = used[1] * (points[10] - t22);
    const real_t t69 = t55 * t64 + t56 * t65 + t57 * t66 + t58 * t67 + t59 * t68;
    const real_t t70 = used[1] * (points[11] - t23);
    const real_t t71 = t69 + t61 * t70;
    const real_t t72 = t63 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t55 * t71 : TB_C(0.0)));
    const real_t t73 = (t63 ? TB_C(0.0) : t64) + (t43 ? TB_C(0.0) : (t52 ? -t72 : TB_C(0.0)));
    const real_t t74 = t63 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t56 * t71 : TB_C(0.0)));
    const real_t t75 = (t63 ? TB_C(0.0) : t65) + (t43 ? TB_C(0.0) : (t52 ? -t74 : TB_C(0.0)));
    const real_t t76 = t63 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t57 * t71 : TB_C(0.0)));
    const real_t t77 = (t63 ? TB_C(0.0) : t66) + (t43 ? TB_C(0.0) : (t52 ? -t76 : TB_C(0.0)));
    const real_t t78 = t63 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t58 * t71 : TB_C(0.0)));
    const real_t t79 = (t63 ? TB_C(0.0) : t67) + (t43 ? TB_C(0.0) : (t52 ? -t78 : TB_C(0.0)));
    const real_t t80 = t63 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t59 * t71 : TB_C(0.0)));
    const real_t t81 = (t63 ? TB_C(0.0) : t68) + (t43 ? TB_C(0.0) : (t52 ? -t80 : TB_C(0.0)));
    const real_t t82 = t73 * t73 + t75 * t75 + t77 * t77 + t79 * t79 + t81 * t81;
    const real_t t83 = t63 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t61 * t71 : TB_C(0.0)));
    const real_t t84 = (t63 ? TB_C(0.0) : t70) + (t43 ? TB_C(0.0) : (t52 ? -t83 : TB_C(0.0)));
    const real_t t85 = t82 + t84 * t84;
    const bool t86 = TB_C(0.0) < t85;
    const real_t t87 = TB_SQRT(t85);
    const real_t t88 = TB_C(1.0) / t87;
    const real_t t89 = t73 * t88;
    const real_t t90 = t75 * t88;
    const real_t t91 = t77 * t88;
    const real_t t92 = t79 * t88;
    const real_t t93 = t81 * t88;
    const real_t t94 = t18 * t89 + t19 * t90 + t20 * t91 + t21 * t92 + t22 * t93;
    const real_t t95 = t84 * t88;
    const bool t96 = TB_C(2.0) == t17;
    const real_t t97 = used[2] * (points[12] - t18);
    const real_t t98 = used[2] * (points[13] - t19);
    const real_t t99 = used[2] * (points[14] - t20);
    const real_t t100 = used[2] * (points[15] - t21);
    const real_t t101 = used[2] * (points[16] - t22);
    const real_t t102 = t55 * t97 + t56 * t98 + t57 * t99 + t58 * t100 + t59 * t101;
    const real_t t103 = used[2] * (points[17] - t23);
    const real_t t104 = t102 + t61 * t103;
    const real_t t105 = t96 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t55 * t104 : TB_C(0.0)));
    const real_t t106 = (t96 ? TB_C(0.0) : t97) + (t43 ? TB_C(0.0) : (t52 ? -t105 : TB_C(0.0)));
    const real_t t107 = t96 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t56 * t104 : TB_C(0.0)));
    const real_t t108 = (t96 ? TB_C(0.0) : t98) + (t43 ? TB_C(0.0) : (t52 ? -t107 : TB_C(0.0)));
    const real_t t109 = t96 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t57 * t104 : TB_C(0.0)));
    const real_t t110 = (t96 ? TB_C(0.0) : t99) + (t43 ? TB_C(0.0) : (t52 ? -t109 : TB_C(0.0)));
    const real_t t111 = t96 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t58 * t104 : TB_C(0.0)));
    const real_t t112 = (t96 ? TB_C(0.0) : t100) + (t43 ? TB_C(0.0) : (t52 ? -t111 :
        TB_C(0.0)));
    const real_t t113 = t89 * t106 + t90 * t108 + t91 * t110 + t92 * t112;
    const real_t t114 = t96 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t59 * t104 : TB_C(0.0)));
    const real_t t115 = (t96 ? TB_C(0.0) : t101) + (t43 ? TB_C(0.0) : (t52 ? -t114 :
        TB_C(0.0)));
    const real_t t116 = t96 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t61 * t104 : TB_C(0.0)));
    const real_t t117 = (t96 ? TB_C(0.0) : t103) + (t43 ? TB_C(0.0) : (t52 ? -t116 :
        TB_C(0.0)));
    const real_t t118 = t113 + t93 * t115 + t95 * t117;
    const real_t t119 = t86 ? -(t86 ? t89 * t118 : TB_C(0.0)) : TB_C(0.0);
    const real_t t120 = t106 + t119;
    const real_t t121 = t86 ? -(t86 ? t90 * t118 : TB_C(0.0)) : TB_C(0.0);
    const real_t t122 = t108 + t121;
    const real_t t123 = t86 ? -(t86 ? t91 * t118 : TB_C(0.0)) : TB_C(0.0);
    const real_t t124 = t110 + t123;
    const real_t t125 = t86 ? -(t86 ? t92 * t118 : TB_C(0.0)) : TB_C(0.0);
    const real_t t126 = t112 + t125;
    const real_t t127 = t120 * t120 + t122 * t122 + t124 * t124 + t126 * t126;
    const real_t t128 = t86 ? -(t86 ? t93 * t118 : TB_C(0.0)) : TB_C(0.0);
    const real_t t129 = t115 + t128;
    const real_t t130 = t86 ? -(t86 ? t95 * t118 : TB_C(0.0)) : TB_C(0.0);
    const real_t t131 = t117 + t130;
    const real_t t132 = t127 + t129 * t129 + t131 * t131;
    const bool t133 = TB_C(0.0) < t132;
    const real_t t134 = TB_SQRT(t132);
    const real_t t135 = TB_C(1.0) / t134;
    const real_t t136 = t120 * t135;
    const real_t t137 = t122 * t135;
    const real_t t138 = t124 * t135;
    const real_t t139 = t126 * t135;
    const real_t t140 = t18 * t136 + t19 * t137 + t20 * t138 + t21 * t139;
    const real_t t141 = t129 * t135;
    const real_t t142 = t131 * t135;
    const bool t143 = TB_C(3.0) == t17;
    const real_t t144 = used[3] * (points[18] - t18);
    const real_t t145 = used[3] * (points[19] - t19);
    const real_t t146 = used[3] * (points[20] - t20);
    const real_t t147 = used[3] * (points[21] - t21);
    const real_t t148 = t55 * t144 + t56 * t145 + t57 * t146 + t58 * t147;
    const real_t t149 = used[3] * (points[22] - t22);
    const real_t t150 = used[3] * (points[23] - t23);
    const real_t t151 = t148 + t59 * t149 + t61 * t150;
    const real_t t152 = t143 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t55 * t151 : TB_C(0.0)));
    const real_t t153 = (t143 ? TB_C(0.0) : t144) + (t43 ? TB_C(0.0) : (t52 ? -t152 :
        TB_C(0.0)));
    const real_t t154 = t143 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t56 * t151 : TB_C(0.0)));
    const real_t t155 = (t143 ? TB_C(0.0) : t145) + (t43 ? TB_C(0.0) : (t52 ? -t154 :
        TB_C(0.0)));
    const real_t t156 = t143 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t57 * t151 : TB_C(0.0)));
    const real_t t157 = (t143 ? TB_C(0.0) : t146) + (t43 ? TB_C(0.0) : (t52 ? -t156 :
        TB_C(0.0)));
    const real_t t158 = t143 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t58 * t151 : TB_C(0.0)));
    const real_t t159 = (t143 ? TB_C(0.0) : t147) + (t43 ? TB_C(0.0) : (t52 ? -t158 :
        TB_C(0.0)));
    const real_t t160 = t89 * t153 + t90 * t155 + t91 * t157 + t92 * t159;
    const real_t t161 = t143 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t59 * t151 : TB_C(0.0)));
    const real_t t162 = (t143 ? TB_C(0.0) : t149) + (t43 ? TB_C(0.0) : (t52 ? -t161 :
        TB_C(0.0)));
    const real_t t163 = t143 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t61 * t151 : TB_C(0.0)));
    const real_t t164 = (t143 ? TB_C(0.0) : t150) + (t43 ? TB_C(0.0) : (t52 ? -t163 :
        TB_C(0.0)));
    const real_t t165 = t160 + t93 * t162 + t95 * t164;
    const real_t t166 = t86 ? -(t86 ? t89 * t165 : TB_C(0.0)) : TB_C(0.0);
    const real_t t167 = t153 + t166;
    const real_t t168 = t86 ? -(t86 ? t90 * t165 : TB_C(0.0)) : TB_C(0.0);
    const real_t t169 = t155 + t168;
    const real_t t170 = t86 ? -(t86 ? t91 * t165 : TB_C(0.0)) : TB_C(0.0);
    const real_t t171 = t157 + t170;
    const real_t t172 = t86 ? -(t86 ? t92 * t165 : TB_C(0.0)) : TB_C(0.0);
    const real_t t173 = t159 + t172;
    const real_t t174 = t136 * t167 + t137 * t169 + t138 * t171 + t139 * t173;
    const real_t t175 = t86 ? -(t86 ? t93 * t165 : TB_C(0.0)) : TB_C(0.0);
    const real_t t176 = t162 + t175;
    const real_t t177 = t86 ? -(t86 ? t95 * t165 : TB_C(0.0)) : TB_C(0.0);
    const real_t t178 = t164 + t177;
    const real_t t179 = t174 + t141 * t176 + t142 * t178;
    const real_t t180 = t133 ? -(t133 ? t136 * t179 : TB_C(0.0)) : TB_C(0.0);
    const real_t t181 = t167 + t180;
    const real_t t182 = t133 ? -(t133 ? t137 * t179 : TB_C(0.0)) : TB_C(0.0);
    const real_t t183 = t169 + t182;
    const real_t t184 = t133 ? -(t133 ? t138 * t179 : TB_C(0.0)) : TB_C(0.0);
    const real_t t185 = t171 + t184;
    const real_t t186 = t133 ? -(t133 ? t139 * t179 : TB_C(0.0)) : TB_C(0.0);
    const real_t t187 = t173 + t186;
    const real_t t188 = t181 * t181 + t183 * t183 + t185 * t185 + t187 * t187;
    const real_t t189 = t133 ? -(t133 ? t141 * t179 : TB_C(0.0)) : TB_C(0.0);
    const real_t t190 = t176 + t189;
    const real_t t191 = t133 ? -(t133 ? t142 * t179 : TB_C(0.0)) : TB_C(0.0);
    const real_t t192 = t178 + t191;
    const real_t t193 = t188 + t190 * t190 + t192 * t192;
    const bool t194 = TB_C(0.0) < t193;
    const real_t t195 = TB_SQRT(t193);
    const real_t t196 = TB_C(1.0) / t195;
    const real_t t197 = t181 * t196;
    const real_t t198 = t183 * t196;
    const real_t t199 = t185 * t196;
    const real_t t200 = t187 * t196;
    const real_t t201 = t18 * t197 + t19 * t198 + t20 * t199 + t21 * t200;
    const real_t t202 = t190 * t196;
    const real_t t203 = t192 * t196;
    const bool t204 = TB_C(4.0) == t17;
    const real_t t205 = used[4] * (points[24] - t18);
    const real_t t206 = used[4] * (points[25] - t19);
    const real_t t207 = used[4] * (points[26] - t20);
    const real_t t208 = used[4] * (points[27] - t21);
    const real_t t209 = t55 * t205 + t56 * t206 + t57 * t207 + t58 * t208;
    const real_t t210 = used[4] * (points[28] - t22);
    const real_t t211 = used[4] * (points[29] - t23);
    const real_t t212 = t209 + t59 * t210 + t61 * t211;
    const real_t t213 = t204 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t55 * t212 : TB_C(0.0)));
    const real_t t214 = (t204 ? TB_C(0.0) : t205) + (t43 ? TB_C(0.0) : (t52 ? -t213 :
        TB_C(0.0)));
    const real_t t215 = t204 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t56 * t212 : TB_C(0.0)));
    const real_t t216 = (t204 ? TB_C(0.0) : t206) + (t43 ? TB_C(0.0) : (t52 ? -t215 :
        TB_C(0.0)));
    const real_t t217 = t204 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t57 * t212 : TB_C(0.0)));
    const real_t t218 = (t204 ? TB_C(0.0) : t207) + (t43 ? TB_C(0.0) : (t52 ? -t217 :
        TB_C(0.0)));
    const real_t t219 = t204 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t58 * t212 : TB_C(0.0)));
    const real_t t220 = (t204 ? TB_C(0.0) : t208) + (t43 ? TB_C(0.0) : (t52 ? -t219 :
        TB_C(0.0)));
    const real_t t221 = t89 * t214 + t90 * t216 + t91 * t218 + t92 * t220;
    const real_t t222 = t204 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t59 * t212 : TB_C(0.0)));
    const real_t t223 = (t204 ? TB_C(0.0) : t210) + (t43 ? TB_C(0.0) : (t52 ? -t222 :
        TB_C(0.0)));
    const real_t t224 = t204 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t61 * t212 : TB_C(0.0)));
    const real_t t225 = (t204 ? TB_C(0.0) : t211) + (t43 ? TB_C(0.0) : (t52 ? -t224 :
        TB_C(0.0)));
    const real_t t226 = t221 + t93 * t223 + t95 * t225;
    const real_t t227 = t86 ? -(t86 ? t89 * t226 : TB_C(0.0)) : TB_C(0.0);
    const real_t t228 = t214 + t227;
    const real_t t229 = t86 ? -(t86 ? t90 * t226 : TB_C(0.0)) : TB_C(0.0);
    const real_t t230 = t216 + t229;
    const real_t t231 = t86 ? -(t86 ? t91 * t226 : TB_C(0.0)) : TB_C(0.0);
    const real_t t232 = t218 + t231;
    const real_t t233 = t86 ? -(t86 ? t92 * t226 : TB_C(0.0)) : TB_C(0.0);
    const real_t t234 = t220 + t233;
    const real_t t235 = t136 * t228 + t137 * t230 + t138 * t232 + t139 * t234;
    const real_t t236 = t86 ? -(t86 ? t93 * t226 : TB_C(0.0)) : TB_C(0.0);
    const real_t t237 = t223 + t236;
    const real_t t238 = t86 ? -(t86 ? t95 * t226 : TB_C(0.0)) : TB_C(0.0);
    const real_t t239 = t225 + t238;
    const real_t t240 = t235 + t141 * t237 + t142 * t239;
    const real_t t241 = t133 ? -(t133 ? t136 * t240 : TB_C(0.0)) : TB_C(0.0);
    const real_t t242 = t228 + t241;
    const real_t t243 = t133 ? -(t133 ? t137 * t240 : TB_C(0.0)) : TB_C(0.0);
    const real_t t244 = t230 + t243;
    const real_t t245 = t133 ? -(t133 ? t138 * t240 : TB_C(0.0)) : TB_C(0.0);
    const real_t t246 = t232 + t245;
    const real_t t247 = t133 ? -(t133 ? t139 * t240 : TB_C(0.0)) : TB_C(0.0);
    const real_t t248 = t234 + t247;
    const real_t t249 = t197 * t242 + t198 * t244 + t199 * t246 + t200 * t248;
    const real_t t250 = t133 ? -(t133 ? t141 * t240 : TB_C(0.0)) : TB_C(0.0);
    const real_t t251 = t237 + t250;
    const real_t t252 = t133 ? -(t133 ? t142 * t240 : TB_C(0.0)) : TB_C(0.0);
    const real_t t253 = t239 + t252;
    const real_t t254 = t249 + t202 * t251 + t203 * t253;
    const real_t t255 = t194 ? -(t194 ? t197 * t254 : TB_C(0.0)) : TB_C(0.0);
    const real_t t256 = t242 + t255;
    const real_t t257 = t194 ? -(t194 ? t198 * t254 : TB_C(0.0)) : TB_C(0.0);
    const real_t t258 = t244 + t257;
    const real_t t259 = t194 ? -(t194 ? t199 * t254 : TB_C(0.0)) : TB_C(0.0);
    const real_t t260 = t246 + t259;
    const real_t t261 = t194 ? -(t194 ? t200 * t254 : TB_C(0.0)) : TB_C(0.0);
    const real_t t262 = t248 + t261;
    const real_t t263 = t256 * t256 + t258 * t258 + t260 * t260 + t262 * t262;
    const real_t t264 = t194 ? -(t194 ? t202 * t254 : TB_C(0.0)) : TB_C(0.0);
    const real_t t265 = t251 + t264;
    const real_t t266 = t194 ? -(t194 ? t203 * t254 : TB_C(0.0)) : TB_C(0.0);
    const real_t t267 = t253 + t266;
    const real_t t268 = t263 + t265 * t265 + t267 * t267;
    const bool t269 = TB_C(0.0) < t268;
    const real_t t270 = TB_SQRT(t268);
    const real_t t271 = TB_C(1.0) / t270;
    const real_t t272 = t256 * t271;
    const real_t t273 = t258 * t271;
    const real_t t274 = t260 * t271;
    const real_t t275 = t262 * t271;
    const real_t t276 = t18 * t272 + t19 * t273 + t20 * t274 + t21 * t275;
    const real_t t277 = t265 * t271;
    const real_t t278 = t267 * t271;
    const bool t279 = TB_C(5.0) == t17;
    const real_t t280 = used[5] * (points[30] - t18);
    const real_t t281 = used[5] * (points[31] - t19);
    const real_t t282 = used[5] * (points[32] - t20);
    const real_t t283 = used[5] * (points[33] - t21);
    const real_t t284 = t55 * t280 + t56 * t281 + t57 * t282 + t58 * t283;
    const real_t t285 = used[5] * (points[34] - t22);
    const real_t t286 = used[5] * (points[35] - t23);
    const real_t t287 = t284 + t59 * t285 + t61 * t286;
    const real_t t288 = t279 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t55 * t287 : TB_C(0.0)));
    const real_t t289 = (t279 ? TB_C(0.0) : t280) + (t43 ? TB_C(0.0) : (t52 ? -t288 :
        TB_C(0.0)));
    const real_t t290 = t279 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t56 * t287 : TB_C(0.0)));
    const real_t t291 = (t279 ? TB_C(0.0) : t281) + (t43 ? TB_C(0.0) : (t52 ? -t290 :
        TB_C(0.0)));
    const real_t t292 = t279 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t57 * t287 : TB_C(0.0)));
    const real_t t293 = (t279 ? TB_C(0.0) : t282) + (t43 ? TB_C(0.0) : (t52 ? -t292 :
        TB_C(0.0)));
    const real_t t294 = t279 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t58 * t287 : TB_C(0.0)));
    const real_t t295 = (t279 ? TB_C(0.0) : t283) + (t43 ? TB_C(0.0) : (t52 ? -t294 :
        TB_C(0.0)));
    const real_t t296 = t89 * t289 + t90 * t291 + t91 * t293 + t92 * t295;
    const real_t t297 = t279 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t59 * t287 : TB_C(0.0)));
    const real_t t298 = (t279 ? TB_C(0.0) : t285) + (t43 ? TB_C(0.0) : (t52 ? -t297 :
        TB_C(0.0)));
    const real_t t299 = t279 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t61 * t287 : TB_C(0.0)));
    const real_t t300 = (t279 ? TB_C(0.0) : t286) + (t43 ? TB_C(0.0) : (t52 ? -t299 :
        TB_C(0.0)));
    const real_t t301 = t296 + t93 * t298 + t95 * t300;
    const real_t t302 = t86 ? -(t86 ? t89 * t301 : TB_C(0.0)) : TB_C(0.0);
    const real_t t303 = t289 + t302;
    const real_t t304 = t86 ? -(t86 ? t90 * t301 : TB_C(0.0)) : TB_C(0.0);
    const real_t t305 = t291 + t304;
    const real_t t306 = t86 ? -(t86 ? t91 * t301 : TB_C(0.0)) : TB_C(0.0);
    const real_t t307 = t293 + t306;
    const real_t t308 = t86 ? -(t86 ? t92 * t301 : TB_C(0.0)) : TB_C(0.0);
    const real_t t309 = t295 + t308;
    const real_t t310 = t136 * t303 + t137 * t305 + t138 * t307 + t139 * t309;
    const real_t t311 = t86 ? -(t86 ? t93 * t301 : TB_C(0.0)) : TB_C(0.0);
    const real_t t312 = t298 + t311;
    const real_t t313 = t86 ? -(t86 ? t95 * t301 : TB_C(0.0)) : TB_C(0.0);
    const real_t t314 = t300 + t313;
    const real_t t315 = t310 + t141 * t312 + t142 * t314;
    const real_t t316 = t133 ? -(t133 ? t136 * t315 : TB_C(0.0)) : TB_C(0.0);
    const real_t t317 = t303 + t316;
    const real_t t318 = t133 ? -(t133 ? t137 * t315 : TB_C(0.0)) : TB_C(0.0);
    const real_t t319 = t305 + t318;
    const real_t t320 = t133 ? -(t133 ? t138 * t315 : TB_C(0.0)) : TB_C(0.0);
    const real_t t321 = t307 + t320;
    const real_t t322 = t133 ? -(t133 ? t139 * t315 : TB_C(0.0)) : TB_C(0.0);
    const real_t t323 = t309 + t322;
    const real_t t324 = t197 * t317 + t198 * t319 + t199 * t321 + t200 * t323;
    const real_t t325 = t133 ? -(t133 ? t141 * t315 : TB_C(0.0)) : TB_C(0.0);
    const real_t t326 = t312 + t325;
    const real_t t327 = t133 ? -(t133 ? t142 * t315 : TB_C(0.0)) : TB_C(0.0);
    const real_t t328 = t314 + t327;
    const real_t t329 = t324 + t202 * t326 + t203 * t328;
    const real_t t330 = t194 ? -(t194 ? t197 * t329 : TB_C(0.0)) : TB_C(0.0);
    const real_t t331 = t317 + t330;
    const real_t t332 = t194 ? -(t194 ? t198 * t329 : TB_C(0.0)) : TB_C(0.0);
    const real_t t333 = t319 + t332;
    const real_t t334 = t194 ? -(t194 ? t199 * t329 : TB_C(0.0)) : TB_C(0.0);
    const real_t t335 = t321 + t334;
    const real_t t336 = t194 ? -(t194 ? t200 * t329 : TB_C(0.0)) : TB_C(0.0);
    const real_t t337 = t323 + t336;
    const real_t t338 = t272 * t331 + t273 * t333 + t274 * t335 + t275 * t337;
    const real_t t339 = t194 ? -(t194 ? t202 * t329 : TB_C(0.0)) : TB_C(0.0);
    const real_t t340 = t326 + t339;
    const real_t t341 = t194 ? -(t194 ? t203 * t329 : TB_C(0.0)) : TB_C(0.0);
    const real_t t342 = t328 + t341;
    const real_t t343 = t338 + t277 * t340 + t278 * t342;
    const real_t t344 = t269 ? -(t269 ? t272 * t343 : TB_C(0.0)) : TB_C(0.0);
    const real_t t345 = t331 + t344;
    const real_t t346 = t269 ? -(t269 ? t273 * t343 : TB_C(0.0)) : TB_C(0.0);
    const real_t t347 = t333 + t346;
    const real_t t348 = t269 ? -(t269 ? t274 * t343 : TB_C(0.0)) : TB_C(0.0);
    const real_t t349 = t335 + t348;
    const real_t t350 = t269 ? -(t269 ? t275 * t343 : TB_C(0.0)) : TB_C(0.0);
    const real_t t351 = t337 + t350;
    const real_t t352 = t345 * t345 + t347 * t347 + t349 * t349 + t351 * t351;
    const real_t t353 = t269 ? -(t269 ? t277 * t343 : TB_C(0.0)) : TB_C(0.0);
    const real_t t354 = t340 + t353;
    const real_t t355 = t269 ? -(t269 ? t278 * t343 : TB_C(0.0)) : TB_C(0.0);
    const real_t t356 = t342 + t355;
    const real_t t357 = t352 + t354 * t354 + t356 * t356;
    const bool t358 = TB_C(0.0) < t357;
    const real_t t359 = TB_SQRT(t357);
    const real_t t360 = TB_C(1.0) / t359;
    const real_t t361 = t345 * t360;
    const real_t t362 = t347 * t360;
    const real_t t363 = t349 * t360;
    const real_t t364 = t351 * t360;
    const real_t t365 = t18 * t361 + t19 * t362 + t20 * t363 + t21 * t364;
    const real_t t366 = t354 * t360;
    const real_t t367 = t356 * t360;
    const bool t368 = TB_C(6.0) == t17;
    const real_t t369 = used[6] * (points[36] - t18);
    const real_t t370 = used[6] * (points[37] - t19);
    const real_t t371 = used[6] * (points[38] - t20);
    const real_t t372 = used[6] * (points[39] - t21);
    const real_t t373 = t55 * t369 + t56 * t370 + t57 * t371 + t58 * t372;
    const real_t t374 = used[6] * (points[40] - t22);
    const real_t t375 = used[6] * (points[41] - t23);
    const real_t t376 = t373 + t59 * t374 + t61 * t375;
    const real_t t377 = t368 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t55 * t376 : TB_C(0.0)));
    const real_t t378 = (t368 ? TB_C(0.0) : t369) + (t43 ? TB_C(0.0) : (t52 ? -t377 :
        TB_C(0.0)));
    const real_t t379 = t368 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t56 * t376 : TB_C(0.0)));
    const real_t t380 = (t368 ? TB_C(0.0) : t370) + (t43 ? TB_C(0.0) : (t52 ? -t379 :
        TB_C(0.0)));
    const real_t t381 = t368 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t57 * t376 : TB_C(0.0)));
    const real_t t382 = (t368 ? TB_C(0.0) : t371) + (t43 ? TB_C(0.0) : (t52 ? -t381 :
        TB_C(0.0)));
    const real_t t383 = t368 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t58 * t376 : TB_C(0.0)));
    const real_t t384 = (t368 ? TB_C(0.0) : t372) + (t43 ? TB_C(0.0) : (t52 ? -t383 :
        TB_C(0.0)));
    const real_t t385 = t89 * t378 + t90 * t380 + t91 * t382 + t92 * t384;
    const real_t t386 = t368 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t59 * t376 : TB_C(0.0)));
    const real_t t387 = (t368 ? TB_C(0.0) : t374) + (t43 ? TB_C(0.0) : (t52 ? -t386 :
        TB_C(0.0)));
    const real_t t388 = t368 ? TB_C(0.0) : (t43 ? TB_C(0.0) : (t52 ? t61 * t376 : TB_C(0.0)));
    const real_t t389 = (t368 ? TB_C(0.0) : t375) + (t43 ? TB_C(0.0) : (t52 ? -t388 :
        TB_C(0.0)));
    const real_t t390 = t385 + t93 * t387 + t95 * t389;
    const real_t t391 = t86 ? -(t86 ? t89 * t390 : TB_C(0.0)) : TB_C(0.0);
    const real_t t392 = t378 + t391;
    const real_t t393 = t86 ? -(t86 ? t90 * t390 : TB_C(0.0)) : TB_C(0.0);
    const real_t t394 = t380 + t393;
    const real_t t395 = t86 ? -(t86 ? t91 * t390 : TB_C(0.0)) : TB_C(0.0);
    const real_t t396 = t382 + t395;
    const real_t t397 = t86 ? -(t86 ? t92 * t390 : TB_C(0.0)) : TB_C(0.0);
    const real_t t398 = t384 + t397;
    const real_t t399 = t136 * t392 + t137 * t394 + t138 * t396 + t139 * t398;
    const real_t t400 = t86 ? -(t86 ? t93 * t390 : TB_C(0.0)) : TB_C(0.0);
    const real_t t401 = t387 + t400;
    const real_t t402 = t86 ? -(t86 ? t95 * t390 : TB_C(0.0)) : TB_C(0.0);
    const real_t t403 = t389 + t402;
    const real_t t404 = t399 + t141 * t401 + t142 * t403;
    const real_t t405 = t133 ? -(t133 ? t136 * t404 : TB_C(0.0)) : TB_C(0.0);
    const real_t t406 = t392 + t405;
    const real_t t407 = t133 ? -(t133 ? t137 * t404 : TB_C(0.0)) : TB_C(0.0);
    const real_t t408 = t394 + t407;
    const real_t t409 = t133 ? -(t133 ? t138 * t404 : TB_C(0.0)) : TB_C(0.0);
    const real_t t410 = t396 + t409;
    const real_t t411 = t133 ? -(t133 ? t139 * t404 : TB_C(0.0)) : TB_C(0.0);
    const real_t t412 = t398 + t411;
    const real_t t413 = t197 * t406 + t198 * t408 + t199 * t410 + t200 * t412;
    const real_t t414 = t133 ? -(t133 ? t141 * t404 : TB_C(0.0)) : TB_C(0.0);
    const real_t t415 = t401 + t414;
    const real_t t416 = t133 ? -(t133 ? t142 * t404 : TB_C(0.0)) : TB_C(0.0);
    const real_t t417 = t403 + t416;
    const real_t t418 = t413 + t202 * t415 + t203 * t417;
    const real_t t419 = t194 ? -(t194 ? t197 * t418 : TB_C(0.0)) : TB_C(0.0);
    const real_t t420 = t406 + t419;
    const real_t t421 = t194 ? -(t194 ? t198 * t418 : TB_C(0.0)) : TB_C(0.0);
    const real_t t422 = t408 + t421;
    const real_t t423 = t194 ? -(t194 ? t199 * t418 : TB_C(0.0)) : TB_C(0.0);
    const real_t t424 = t410 + t423;
    const real_t t425 = t194 ? -(t194 ? t200 * t418 : TB_C(0.0)) : TB_C(0.0);
    const real_t t426 = t412 + t425;
    const real_t t427 = t272 * t420 + t273 * t422 + t274 * t424 + t275 * t426;
    const real_t t428 = t194 ? -(t194 ? t202 * t418 : TB_C(0.0)) : TB_C(0.0);
    const real_t t429 = t415 + t428;
    const real_t t430 = t194 ? -(t194 ? t203 * t418 : TB_C(0.0)) : TB_C(0.0);
    const real_t t431 = t417 + t430;
    const real_t t432 = t427 + t277 * t429 + t278 * t431;
    const real_t t433 = t269 ? -(t269 ? t272 * t432 : TB_C(0.0)) : TB_C(0.0);
    const real_t t434 = t420 + t433;
    const real_t t435 = t269 ? -(t269 ? t273 * t432 : TB_C(0.0)) : TB_C(0.0);
    const real_t t436 = t422 + t435;
    const real_t t437 = t269 ? -(t269 ? t274 * t432 : TB_C(0.0)) : TB_C(0.0);
    const real_t t438 = t424 + t437;
    const real_t t439 = t269 ? -(t269 ? t275 * t432 : TB_C(0.0)) : TB_C(0.0);
    const real_t t440 = t426 + t439;
    const real_t t441 = t361 * t434 + t362 * t436 + t363 * t438 + t364 * t440;
    const real_t t442 = t269 ? -(t269 ? t277 * t432 : TB_C(0.0)) : TB_C(0.0);
    const real_t t443 = t429 + t442;
    const real_t t444 = t269 ? -(t269 ? t278 * t432 : TB_C(0.0)) : TB_C(0.0);
    const real_t t445 = t431 + t444;
    const real_t t446 = t441 + t366 * t443 + t367 * t445;
    const real_t t447 = t358 ? -(t358 ? t361 * t446 : TB_C(0.0)) : TB_C(0.0);
    const real_t t448 = t434 + t447;
    const real_t t449 = t358 ? -(t358 ? t362 * t446 : TB_C(0.0)) : TB_C(0.0);
    const real_t t450 = t436 + t449;
    const real_t t451 = t358 ? -(t358 ? t363 * t446 : TB_C(0.0)) : TB_C(0.0);
    const real_t t452 = t438 + t451;
    const real_t t453 = t358 ? -(t358 ? t364 * t446 : TB_C(0.0)) : TB_C(0.0);
    const real_t t454 = t440 + t453;
    const real_t t455 = t448 * t448 + t450 * t450 + t452 * t452 + t454 * t454;
    const real_t t456 = t358 ? -(t358 ? t366 * t446 : TB_C(0.0)) : TB_C(0.0);
    const real_t t457 = t443 + t456;
    const real_t t458 = t358 ? -(t358 ? t367 * t446 : TB_C(0.0)) : TB_C(0.0);
    const real_t t459 = t445 + t458;
    const real_t t460 = t455 + t457 * t457 + t459 * t459;
    const bool t461 = TB_C(0.0) < t460;
    const real_t t462 = TB_SQRT(t460);
    const real_t t463 = TB_C(1.0) / t462;
    const real_t t464 = t448 * t463;
    const real_t t465 = t450 * t463;
    const real_t t466 = t452 * t463;
    const real_t t467 = t454 * t463;
    const real_t t468 = t18 * t464 + t19 * t465 + t20 * t466 + t21 * t467;
    const real_t t469 = t457 * t463;
    const real_t t470 = t459 * t463;
    const real_t t471 = t461 ? t468 + t22 * t469 + t23 * t470 : TB_C(0.0);
    const real_t t472 = t471 * (TB_C(1.0) / (t461 ? t462 : TB_C(1.0)));
    const real_t t473 = t358 ? t365 + t22 * t366 + t23 * t367 - t446 * t472 : TB_C(0.0);
    const real_t t474 = t473 * (TB_C(1.0) / (t358 ? t359 : TB_C(1.0)));
    const real_t t475 = t276 + t22 * t277 + t23 * t278 - t343 * t474 - t432 * t472;
    const real_t t476 = (t269 ? t475 : TB_C(0.0)) * (TB_C(1.0) / (t269 ? t270 : TB_C(1.0)));
    const real_t t477 = t201 + t22 * t202 + t23 * t203 - t254 * t476 - t329 * t474;
    const real_t t478 = (t194 ? t477 - t418 * t472 : TB_C(0.0)) * (TB_C(1.0) / (t194 ? t195 :
        TB_C(1.0)));
    const real_t t479 = t140 + t22 * t141 + t23 * t142 - t179 * t478 - t240 * t476;
    const real_t t480 = t133 ? t479 - t315 * t474 - t404 * t472 : TB_C(0.0);
    const real_t t481 = t480 * (TB_C(1.0) / (t133 ? t134 : TB_C(1.0)));
    const real_t t482 = t94 + t23 * t95 - t118 * t481 - t165 * t478 - t226 * t476;
    const real_t t483 = t86 ? t482 - t301 * t474 - t390 * t472 : TB_C(0.0);
    const real_t t484 = t483 * (TB_C(1.0) / (t86 ? t87 : TB_C(1.0)));
    const real_t t485 = t43 ? TB_C(0.0) : (t52 ? -(t71 * t484) : TB_C(0.0));
    const real_t t486 = (t43 ? TB_C(0.0) : (t52 ? t62 : TB_C(0.0))) + (t63 ? TB_C(0.0) : t485);
    const real_t t487 = t43 ? TB_C(0.0) : (t52 ? -(t104 * t481) : TB_C(0.0));
    const real_t t488 = t43 ? TB_C(0.0) : (t52 ? -(t151 * t478) : TB_C(0.0));
    const real_t t489 = t486 + (t96 ? TB_C(0.0) : t487) + (t143 ? TB_C(0.0) : t488);
    const real_t t490 = t43 ? TB_C(0.0) : (t52 ? -(t212 * t476) : TB_C(0.0));
    const real_t t491 = t43 ? TB_C(0.0) : (t52 ? -(t287 * t474) : TB_C(0.0));
    const real_t t492 = t489 + (t204 ? TB_C(0.0) : t490) + (t279 ? TB_C(0.0) : t491);
    const real_t t493 = t43 ? TB_C(0.0) : (t52 ? -(t376 * t472) : TB_C(0.0));
    const real_t t494 = (t492 + (t368 ? TB_C(0.0) : t493)) * (TB_C(1.0) / (t52 ? t53 :
        TB_C(1.0)));
    const real_t t495 = t43 ? TB_C(0.0) : -(used[0] * t494);
    const real_t t496 = t63 ? TB_C(0.0) : -(used[1] * t484);
    const real_t t497 = t96 ? TB_C(0.0) : -(used[2] * t481);
    const real_t t498 = t143 ? TB_C(0.0) : -(used[3] * t478);
    const real_t t499 = t204 ? TB_C(0.0) : -(used[4] * t476);
    const real_t t500 = t279 ? TB_C(0.0) : -(used[5] * t474);
    const real_t t501 = t368 ? TB_C(0.0) : -(used[6] * t472);
    const real_t t502 = TB_C(1.0) - (t495 + t496 + t497 + t498 + t499 + t500 + t501);
    const real_t t503 = t43 ? t502 : t495;
    real_t t504;
    if (t0 && t503 <= TB_C(0.0)) {
        t504 = weight[0] / (weight[0] - t503);
    } else {
        t504 = TB_C(1e+30);
    }
    const real_t t505 = t63 ? t502 : t496;
    real_t t506;
    if (t9 && t505 <= TB_C(0.0)) {
        t506 = weight[1] / (weight[1] - t505);
    } else {
        t506 = TB_C(1e+30);
    }
    const real_t t507 = t96 ? t502 : t497;
    real_t t508;
    if (t12 && t507 <= TB_C(0.0)) {
        t508 = weight[2] / (weight[2] - t507);
    } else {
        t508 = TB_C(1e+30);
    }
    const real_t t509 = t143 ? t502 : t498;
    real_t t510;
    if (t14 && t509 <= TB_C(0.0)) {
        t510 = weight[3] / (weight[3] - t509);
    } else {
        t510 = TB_C(1e+30);
    }
    const real_t t511 = t204 ? t502 : t499;
    real_t t512;
    if (t1 && t511 <= TB_C(0.0)) {
        t512 = weight[4] / (weight[4] - t511);
    } else {
        t512 = TB_C(1e+30);
    }
    const real_t t513 = tb_min(tb_min(tb_min(tb_min(t504, t506), t508), t510), t512);
    const real_t t514 = t279 ? t502 : t500;
    real_t t515;
    if (t3 && t514 <= TB_C(0.0)) {
        t515 = weight[5] / (weight[5] - t514);
    } else {
        t515 = TB_C(1e+30);
    }
    const real_t t516 = t368 ? t502 : t501;
    real_t t517;
    if (t6 && t516 <= TB_C(0.0)) {
        t517 = weight[6] / (weight[6] - t516);
    } else {
        t517 = TB_C(1e+30);
    }
    const real_t t518 = tb_min(tb_min(t513, t515), t517);
    const bool t519 = t518 < TB_C(1e+30);
    const real_t t520 = -(t43 ? TB_C(0.0) : (t52 ? t55 * t62 : TB_C(0.0)));
    const real_t t521 = t18 + (t43 ? TB_C(0.0) : (t52 ? t520 : TB_C(0.0)));
    const real_t t522 = -(t43 ? TB_C(0.0) : (t52 ? t56 * t62 : TB_C(0.0)));
    const real_t t523 = t19 + (t43 ? TB_C(0.0) : (t52 ? t522 : TB_C(0.0)));
    const real_t t524 = -(t43 ? TB_C(0.0) : (t52 ? t57 * t62 : TB_C(0.0)));
    const real_t t525 = t20 + (t43 ? TB_C(0.0) : (t52 ? t524 : TB_C(0.0)));
    const real_t t526 = -(t43 ? TB_C(0.0) : (t52 ? t58 * t62 : TB_C(0.0)));
    const real_t t527 = t21 + (t43 ? TB_C(0.0) : (t52 ? t526 : TB_C(0.0)));
    const real_t t528 = t89 * t521 + t90 * t523 + t91 * t525 + t92 * t527;
    const real_t t529 = -(t43 ? TB_C(0.0) : (t52 ? t59 * t62 : TB_C(0.0)));
    const real_t t530 = t22 + (t43 ? TB_C(0.0) : (t52 ? t529 : TB_C(0.0)));
    const real_t t531 = -(t43 ? TB_C(0.0) : (t52 ? t61 * t62 : TB_C(0.0)));
    const real_t t532 = t23 + (t43 ? TB_C(0.0) : (t52 ? t531 : TB_C(0.0)));
    const real_t t533 = t528 + t93 * t530 + t95 * t532;
    const real_t t534 = t86 ? -(t86 ? t89 * t533 : TB_C(0.0)) : TB_C(0.0);
    const real_t t535 = t521 + t534;
    const real_t t536 = t86 ? -(t86 ? t90 * t533 : TB_C(0.0)) : TB_C(0.0);
    const real_t t537 = t523 + t536;
    const real_t t538 = t86 ? -(t86 ? t91 * t533 : TB_C(0.0)) : TB_C(0.0);
    const real_t t539 = t525 + t538;
    const real_t t540 = t86 ? -(t86 ? t92 * t533 : TB_C(0.0)) : TB_C(0.0);
    const real_t t541 = t527 + t540;
    const real_t t542 = t136 * t535 + t137 * t537 + t138 * t539 + t139 * t541;
    const real_t t543 = t86 ? -(t86 ? t93 * t533 : TB_C(0.0)) : TB_C(0.0);
    const real_t t544 = t530 + t543;
    const real_t t545 = t86 ? -(t86 ? t95 * t533 : TB_C(0.0)) : TB_C(0.0);
    const real_t t546 = t532 + t545;
    const real_t t547 = t542 + t141 * t544 + t142 * t546;
    const real_t t548 = t133 ? -(t133 ? t136 * t547 : TB_C(0.0)) : TB_C(0.0);
    const real_t t549 = t535 + t548;
    const real_t t550 = t133 ? -(t133 ? t137 * t547 : TB_C(0.0)) : TB_C(0.0);
    const real_t t551 = t537 + t550;
    const real_t t552 = t133 ? -(t133 ? t138 * t547 : TB_C(0.0)) : TB_C(0.0);
    const real_t t553 = t539 + t552;
    const real_t t554 = t133 ? -(t133 ? t139 * t547 : TB_C(0.0)) : TB_C(0.0);
    const real_t t555 = t541 + t554;
    const real_t t556 = t197 * t549 + t198 * t551 + t199 * t553 + t200 * t555;
    const real_t t557 = t133 ? -(t133 ? t141 * t547 : TB_C(0.0)) : TB_C(0.0);
    const real_t t558 = t544 + t557;
    const real_t t559 = t133 ? -(t133 ? t142 * t547 : TB_C(0.0)) : TB_C(0.0);
    const real_t t560 = t546 + t559;
    const real_t t561 = t556 + t202 * t558 + t203 * t560;
    const real_t t562 = t194 ? -(t194 ? t197 * t561 : TB_C(0.0)) : TB_C(0.0);
    const real_t t563 = t549 + t562;
    const real_t t564 = t194 ? -(t194 ? t198 * t561 : TB_C(0.0)) : TB_C(0.0);
    const real_t t565 = t551 + t564;
    const real_t t566 = t194 ? -(t194 ? t199 * t561 : TB_C(0.0)) : TB_C(0.0);
    const real_t t567 = t553 + t566;
    const real_t t568 = t194 ? -(t194 ? t200 * t561 : TB_C(0.0)) : TB_C(0.0);
    const real_t t569 = t555 + t568;
    const real_t t570 = t272 * t563 + t273 * t565 + t274 * t567 + t275 * t569;
    const real_t t571 = t194 ? -(t194 ? t202 * t561 : TB_C(0.0)) : TB_C(0.0);
    const real_t t572 = t558 + t571;
    const real_t t573 = t194 ? -(t194 ? t203 * t561 : TB_C(0.0)) : TB_C(0.0);
    const real_t t574 = t560 + t573;
    const real_t t575 = t570 + t277 * t572 + t278 * t574;
    const real_t t576 = t269 ? -(t269 ? t272 * t575 : TB_C(0.0)) : TB_C(0.0);
    const real_t t577 = t563 + t576;
    const real_t t578 = t269 ? -(t269 ? t273 * t575 : TB_C(0.0)) : TB_C(0.0);
    const real_t t579 = t565 + t578;
    const real_t t580 = t269 ? -(t269 ? t274 * t575 : TB_C(0.0)) : TB_C(0.0);
    const real_t t581 = t567 + t580;
    const real_t t582 = t269 ? -(t269 ? t275 * t575 : TB_C(0.0)) : TB_C(0.0);
    const real_t t583 = t569 + t582;
    const real_t t584 = t361 * t577 + t362 * t579 + t363 * t581 + t364 * t583;
    const real_t t585 = t269 ? -(t269 ? t277 * t575 : TB_C(0.0)) : TB_C(0.0);
    const real_t t586 = t572 + t585;
    const real_t t587 = t269 ? -(t269 ? t278 * t575 : TB_C(0.0)) : TB_C(0.0);
    const real_t t588 = t574 + t587;
    const real_t t589 = t584 + t366 * t586 + t367 * t588;
    const real_t t590 = t358 ? -(t358 ? t361 * t589 : TB_C(0.0)) : TB_C(0.0);
    const real_t t591 = t577 + t590;
    const real_t t592 = t358 ? -(t358 ? t362 * t589 : TB_C(0.0)) : TB_C(0.0);
    const real_t t593 = t579 + t592;
    const real_t t594 = t358 ? -(t358 ? t363 * t589 : TB_C(0.0)) : TB_C(0.0);
    const real_t t595 = t581 + t594;
    const real_t t596 = t358 ? -(t358 ? t364 * t589 : TB_C(0.0)) : TB_C(0.0);
    const real_t t597 = t583 + t596;
    const real_t t598 = t464 * t591 + t465 * t593 + t466 * t595 + t467 * t597;
    const real_t t599 = t358 ? -(t358 ? t366 * t589 : TB_C(0.0)) : TB_C(0.0);
    const real_t t600 = t586 + t599;
    const real_t t601 = t358 ? -(t358 ? t367 * t589 : TB_C(0.0)) : TB_C(0.0);
    const real_t t602 = t588 + t601;
    const real_t t603 = t598 + t469 * t600 + t470 * t602;
    const real_t t604 = t461 ? -(t461 ? t464 * t603 : TB_C(0.0)) : TB_C(0.0);
    const real_t t605 = t591 + t604;
    const real_t t606 = t461 ? -(t461 ? t465 * t603 : TB_C(0.0)) : TB_C(0.0);
    const real_t t607 = t593 + t606;
    const real_t t608 = t461 ? -(t461 ? t466 * t603 : TB_C(0.0)) : TB_C(0.0);
    const real_t t609 = t595 + t608;
    const real_t t610 = t461 ? -(t461 ? t467 * t603 : TB_C(0.0)) : TB_C(0.0);
    const real_t t611 = t597 + t610;
    const real_t t612 = t55 * t605 + t56 * t607 + t57 * t609 + t58 * t611;
    const real_t t613 = t461 ? -(t461 ? t469 * t603 : TB_C(0.0)) : TB_C(0.0);
    const real_t t614 = t600 + t613;
    const real_t t615 = t461 ? -(t461 ? t470 * t603 : TB_C(0.0)) : TB_C(0.0);
    const real_t t616 = t602 + t615;
    const real_t t617 = t612 + t59 * t614 + t61 * t616;
    const real_t t618 = -(t43 ? TB_C(0.0) : (t52 ? t55 * t617 : TB_C(0.0)));
    const real_t t619 = t605 + (t43 ? TB_C(0.0) : (t52 ? t618 : TB_C(0.0)));
    const real_t t620 = -(t43 ? TB_C(0.0) : (t52 ? t56 * t617 : TB_C(0.0)));
    const real_t t621 = t607 + (t43 ? TB_C(0.0) : (t52 ? t620 : TB_C(0.0)));
    const real_t t622 = -(t43 ? TB_C(0.0) : (t52 ? t57 * t617 : TB_C(0.0)));
    const real_t t623 = t609 + (t43 ? TB_C(0.0) : (t52 ? t622 : TB_C(0.0)));
    const real_t t624 = -(t43 ? TB_C(0.0) : (t52 ? t58 * t617 : TB_C(0.0)));
    const real_t t625 = t611 + (t43 ? TB_C(0.0) : (t52 ? t624 : TB_C(0.0)));
    const real_t t626 = t89 * t619 + t90 * t621 + t91 * t623 + t92 * t625;
    const real_t t627 = -(t43 ? TB_C(0.0) : (t52 ? t59 * t617 : TB_C(0.0)));
    const real_t t628 = t614 + (t43 ? TB_C(0.0) : (t52 ? t627 : TB_C(0.0)));
    const real_t t629 = -(t43 ? TB_C(0.0) : (t52 ? t61 * t617 : TB_C(0.0)));
    const real_t t630 = t616 + (t43 ? TB_C(0.0) : (t52 ? t629 : TB_C(0.0)));
    const real_t t631 = t626 + t93 * t628 + t95 * t630;
    const real_t t632 = t86 ? -(t86 ? t89 * t631 : TB_C(0.0)) : TB_C(0.0);
    const real_t t633 = t619 + t632;
    const real_t t634 = t86 ? -(t86 ? t90 * t631 : TB_C(0.0)) : TB_C(0.0);
    const real_t t635 = t621 + t634;
    const real_t t636 = t86 ? -(t86 ? t91 * t631 : TB_C(0.0)) : TB_C(0.0);
    const real_t t637 = t623 + t636;
    const real_t t638 = t86 ? -(t86 ? t92 * t631 : TB_C(0.0)) : TB_C(0.0);
    const real_t t639 = t625 + t638;
    const real_t t640 = t136 * t633 + t137 * t635 + t138 * t637 + t139 * t639;
    const real_t t641 = t86 ? -(t86 ? t93 * t631 : TB_C(0.0)) : TB_C(0.0);
    const real_t t642 = t628 + t641;
    const real_t t643 = t86 ? -(t86 ? t95 * t631 : TB_C(0.0)) : TB_C(0.0);
    const real_t t644 = t630 + t643;
    const real_t t645 = t640 + t141 * t642 + t142 * t644;
    const real_t t646 = t133 ? -(t133 ? t136 * t645 : TB_C(0.0)) : TB_C(0.0);
    const real_t t647 = t633 + t646;
    const real_t t648 = t133 ? -(t133 ? t137 * t645 : TB_C(0.0)) : TB_C(0.0);
    const real_t t649 = t635 + t648;
    const real_t t650 = t133 ? -(t133 ? t138 * t645 : TB_C(0.0)) : TB_C(0.0);
    const real_t t651 = t637 + t650;
    const real_t t652 = t133 ? -(t133 ? t139 * t645 : TB_C(0.0)) : TB_C(0.0);
    const real_t t653 = t639 + t652;
    const real_t t654 = t197 * t647 + t198 * t649 + t199 * t651 + t200 * t653;
    const real_t t655 = t133 ? -(t133 ? t141 * t645 : TB_C(0.0)) : TB_C(0.0);
    const real_t t656 = t642 + t655;
    const real_t t657 = t133 ? -(t133 ? t142 * t645 : TB_C(0.0)) : TB_C(0.0);
    const real_t t658 = t644 + t657;
    const real_t t659 = t654 + t202 * t656 + t203 * t658;
    const real_t t660 = t194 ? -(t194 ? t197 * t659 : TB_C(0.0)) : TB_C(0.0);
    const real_t t661 = t647 + t660;
    const real_t t662 = t194 ? -(t194 ? t198 * t659 : TB_C(0.0)) : TB_C(0.0);
    const real_t t663 = t649 + t662;
    const real_t t664 = t194 ? -(t194 ? t199 * t659 : TB_C(0.0)) : TB_C(0.0);
    const real_t t665 = t651 + t664;
    const real_t t666 = t194 ? -(t194 ? t200 * t659 : TB_C(0.0)) : TB_C(0.0);
    const real_t t667 = t653 + t666;
    const real_t t668 = t272 * t661 + t273 * t663 + t274 * t665 + t275 * t667;
    const real_t t669 = t194 ? -(t194 ? t202 * t659 : TB_C(0.0)) : TB_C(0.0);
    const real_t t670 = t656 + t669;
    const real_t t671 = t194 ? -(t194 ? t203 * t659 : TB_C(0.0)) : TB_C(0.0);
    const real_t t672 = t658 + t671;
    const real_t t673 = t668 + t277 * t670 + t278 * t672;
    const real_t t674 = t269 ? -(t269 ? t272 * t673 : TB_C(0.0)) : TB_C(0.0);
    const real_t t675 = t661 + t674;
    const real_t t676 = t269 ? -(t269 ? t273 * t673 : TB_C(0.0)) : TB_C(0.0);
    const real_t t677 = t663 + t676;
    const real_t t678 = t269 ? -(t269 ? t274 * t673 : TB_C(0.0)) : TB_C(0.0);
    const real_t t679 = t665 + t678;
    const real_t t680 = t269 ? -(t269 ? t275 * t673 : TB_C(0.0)) : TB_C(0.0);
    const real_t t681 = t667 + t680;
    const real_t t682 = t361 * t675 + t362 * t677 + t363 * t679 + t364 * t681;
    const real_t t683 = t269 ? -(t269 ? t277 * t673 : TB_C(0.0)) : TB_C(0.0);
    const real_t t684 = t670 + t683;
    const real_t t685 = t269 ? -(t269 ? t278 * t673 : TB_C(0.0)) : TB_C(0.0);
    const real_t t686 = t672 + t685;
    const real_t t687 = t682 + t366 * t684 + t367 * t686;
    const real_t t688 = t358 ? -(t358 ? t361 * t687 : TB_C(0.0)) : TB_C(0.0);
    const real_t t689 = t675 + t688;
    const real_t t690 = t358 ? -(t358 ? t362 * t687 : TB_C(0.0)) : TB_C(0.0);
    const real_t t691 = t677 + t690;
    const real_t t692 = t358 ? -(t358 ? t363 * t687 : TB_C(0.0)) : TB_C(0.0);
    const real_t t693 = t679 + t692;
    const real_t t694 = t358 ? -(t358 ? t364 * t687 : TB_C(0.0)) : TB_C(0.0);
    const real_t t695 = t681 + t694;
    const real_t t696 = t464 * t689 + t465 * t691 + t466 * t693 + t467 * t695;
    const real_t t697 = t358 ? -(t358 ? t366 * t687 : TB_C(0.0)) : TB_C(0.0);
    const real_t t698 = t684 + t697;
    const real_t t699 = t358 ? -(t358 ? t367 * t687 : TB_C(0.0)) : TB_C(0.0);
    const real_t t700 = t686 + t699;
    const real_t t701 = t696 + t469 * t698 + t470 * t700;
    const real_t t702 = t461 ? -(t461 ? t464 * t701 : TB_C(0.0)) : TB_C(0.0);
    const real_t offset_0 = t689 + t702;
    const real_t t703 = t461 ? -(t461 ? t465 * t701 : TB_C(0.0)) : TB_C(0.0);
    const real_t offset_1 = t691 + t703;
    const real_t t704 = offset_0 * structure[0] + structure[8] * offset_1;
    const real_t t705 = t461 ? -(t461 ? t466 * t701 : TB_C(0.0)) : TB_C(0.0);
    const real_t offset_2 = t693 + t705;
    const real_t t706 = TB_MOMENT_WEIGHT * structure[24];
    const real_t t707 = t461 ? -(t461 ? t467 * t701 : TB_C(0.0)) : TB_C(0.0);
    const real_t offset_3 = t695 + t707;
    const real_t t708 = t704 + structure[16] * offset_2 + t706 * offset_3;
    const real_t t709 = TB_MOMENT_WEIGHT * structure[32];
    const real_t t710 = t461 ? -(t461 ? t469 * t701 : TB_C(0.0)) : TB_C(0.0);
    const real_t offset_4 = t698 + t710;
    const real_t t711 = TB_MOMENT_WEIGHT * structure[40];
    const real_t t712 = t461 ? -(t461 ? t470 * t701 : TB_C(0.0)) : TB_C(0.0);
    const real_t offset_5 = t700 + t712;
    const bool t713 = t708 + t709 * offset_4 + t711 * offset_5 < TB_C(0.0);
    const real_t t714 = t713 ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t715 = offset_0 * structure[1] + offset_1 * structure[9];
    const real_t t716 = TB_MOMENT_WEIGHT * structure[25];
    const real_t t717 = t715 + offset_2 * structure[17] + offset_3 * t716;
    const real_t t718 = TB_MOMENT_WEIGHT * structure[33];
    const real_t t719 = TB_MOMENT_WEIGHT * structure[41];
    const bool t720 = t717 + offset_4 * t718 + offset_5 * t719 < TB_C(0.0);
    const real_t t721 = t720 ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t722 = offset_0 * structure[2] + offset_1 * structure[10];
    const real_t t723 = TB_MOMENT_WEIGHT * structure[26];
    const real_t t724 = t722 + offset_2 * structure[18] + offset_3 * t723;
    const real_t t725 = TB_MOMENT_WEIGHT * structure[34];
    const real_t t726 = TB_MOMENT_WEIGHT * structure[42];
    const bool t727 = t724 + offset_4 * t725 + offset_5 * t726 < TB_C(0.0);
    const real_t t728 = t727 ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t729 = structure[0] * t714 + structure[1] * t721 + structure[2] * t728;
    const real_t t730 = offset_0 * structure[3] + offset_1 * structure[11];
    const real_t t731 = TB_MOMENT_WEIGHT * structure[27];
    const real_t t732 = t730 + offset_2 * structure[19] + offset_3 * t731;
    const real_t t733 = TB_MOMENT_WEIGHT * structure[35];
    const real_t t734 = TB_MOMENT_WEIGHT * structure[43];
    const bool t735 = t732 + offset_4 * t733 + offset_5 * t734 < TB_C(0.0);
    const real_t t736 = t735 ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t737 = offset_0 * structure[4] + offset_1 * structure[12];
    const real_t t738 = TB_MOMENT_WEIGHT * structure[28];
    const real_t t739 = t737 + offset_2 * structure[20] + offset_3 * t738;
    const real_t t740 = TB_MOMENT_WEIGHT * structure[36];
    const real_t t741 = TB_MOMENT_WEIGHT * structure[44];
    const bool t742 = t739 + offset_4 * t740 + offset_5 * t741 < TB_C(0.0);
    const real_t t743 = t742 ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t744 = offset_0 * structure[5] + offset_1 * structure[13];
    const real_t t745 = TB_MOMENT_WEIGHT * structure[29];
    const real_t t746 = t744 + offset_2 * structure[21] + offset_3 * t745;
    const real_t t747 = TB_MOMENT_WEIGHT * structure[37];
    const real_t t748 = TB_MOMENT_WEIGHT * structure[45];
    const bool t749 = t746 + offset_4 * t747 + offset_5 * t748 < TB_C(0.0);
    const real_t t750 = t749 ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t751 = t729 + structure[3] * t736 + structure[4] * t743 + structure[5] * t750;
    const real_t t752 = offset_0 * structure[6] + offset_1 * structure[14];
    const real_t t753 = TB_MOMENT_WEIGHT * structure[30];
    const real_t t754 = t752 + offset_2 * structure[22] + offset_3 * t753;
    const real_t t755 = TB_MOMENT_WEIGHT * structure[38];
    const real_t t756 = TB_MOMENT_WEIGHT * structure[46];
    const bool t757 = t754 + offset_4 * t755 + offset_5 * t756 < TB_C(0.0);
    const real_t t758 = t757 ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t759 = offset_0 * structure[7] + offset_1 * structure[15];
    const real_t t760 = TB_MOMENT_WEIGHT * structure[31];
    const real_t t761 = t759 + offset_2 * structure[23] + offset_3 * t760;
    const real_t t762 = TB_MOMENT_WEIGHT * structure[39];
    const real_t t763 = TB_MOMENT_WEIGHT * structure[47];
    const bool t764 = t761 + offset_4 * t762 + offset_5 * t763 < TB_C(0.0);
    const real_t t765 = t764 ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t766 = t751 + structure[6] * t758 + structure[7] * t765 - wrench[0];
    const real_t t767 = structure[8] * t714 + structure[9] * t721 + structure[10] * t728;
    const real_t t768 = t767 + structure[11] * t736 + structure[12] * t743;
    const real_t t769 = t768 + structure[13] * t750 + structure[14] * t758;
    const real_t t770 = t769 + structure[15] * t765 - wrench[1];
    const real_t t771 = offset_0 * (offset_0 - t766) + offset_1 * (offset_1 - t770);
    const real_t t772 = structure[16] * t714 + structure[17] * t721 + structure[18] * t728;
    const real_t t773 = t772 + structure[19] * t736 + structure[20] * t743;
    const real_t t774 = t773 + structure[21] * t750 + structure[22] * t758;
    const real_t t775 = t774 + structure[23] * t765 - wrench[2];
    const real_t t776 = t706 * t714 + t716 * t721 + t723 * t728 + t731 * t736;
    const real_t t777 = t776 + t738 * t743 + t745 * t750 + t753 * t758 + t760 * t765;
    const real_t t778 = TB_MOMENT_WEIGHT * wrench[3];
    const real_t t779 = t777 - t778;
    const real_t t780 = t771 + offset_2 * (offset_2 - t775) + offset_3 * (offset_3 - t779);
    const real_t t781 = t709 * t714 + t718 * t721 + t725 * t728 + t733 * t736;
    const real_t t782 = t781 + t740 * t743 + t747 * t750 + t755 * t758 + t762 * t765;
    const real_t t783 = TB_MOMENT_WEIGHT * wrench[4];
    const real_t t784 = t782 - t783;
    const real_t t785 = t711 * t714 + t719 * t721 + t726 * t728 + t734 * t736;
    const real_t t786 = t785 + t741 * t743 + t748 * t750 + t756 * t758 + t763 * t765;
    const real_t t787 = TB_MOMENT_WEIGHT * wrench[5];
    const real_t t788 = t786 - t787;
    const real_t t789 = t780 + offset_4 * (offset_4 - t784) + offset_5 * (offset_5 - t788);
    const real_t t790 = TB_ABS(wrench[0]) + TB_ABS(wrench[1]) + TB_ABS(wrench[2]);
    const real_t t791 = t790 + TB_ABS(t778) + TB_ABS(t783) + TB_ABS(t787);
    const real_t t792 = offset_0 * offset_0 + offset_1 * offset_1 + offset_2 * offset_2;
    const real_t t793 = t792 + offset_3 * offset_3 + offset_4 * offset_4 + offset_5 * offset_5;
    const real_t t794 = TB_SQRT(t793);
    const real_t t795 = TB_C(64.0) * TB_EPSILON * (TB_C(64.0) + t791) * t794;
    const bool t796 = t789 <= t795 || t794 <= TB_EPSILON * TB_C(1024.0);
    const bool t797 = t6 && (t3 && (t1 && (t14 && (t12 && (t0 && t9)))));
    const bool t798 = !t519 && (t796 || t797);
    real_t t799;
    if (t519 || t798) {
        t799 = -TB_C(1.0);
    } else {
        const real_t t800 = t1 ? -TB_C(1.0) : TB_C(3.0);
        const real_t t801 = t3 ? -TB_C(1.0) : TB_C(2.0);
        const real_t t802 = tb_max(t800, t801);
        const real_t t803 = t6 ? -TB_C(1.0) : TB_C(1.0);
        const real_t t804 = t0 ? -TB_C(1.0) : TB_C(7.0);
        const real_t t805 = t9 ? -TB_C(1.0) : TB_C(6.0);
        const real_t t806 = tb_max(t804, t805);
        const real_t t807 = t12 ? -TB_C(1.0) : TB_C(5.0);
        const real_t t808 = t14 ? -TB_C(1.0) : TB_C(4.0);
        const bool t809 = tb_max(t802, t803) <= tb_max(tb_max(t806, t807), t808);
        real_t t810;
        if (t809) {
            const real_t t811 = tb_max(t807, t808) <= t806 ? (t805 <= t804 ? TB_C(0.0) :
                TB_C(1.0)) : (t808 <= t807 ? TB_C(2.0) : TB_C(3.0));
            t810 = t811;
        } else {
            const real_t t812 = t803 <= t802 ? (t801 <= t800 ? TB_C(4.0) : TB_C(5.0)) :
                TB_C(6.0);
            t810 = t812;
        }
        t799 = t810;
    }
    const bool t813 = TB_C(0.0) == t799;
    const real_t points_0 = t813 ? t766 : points[0];
    const real_t points_1 = t813 ? t770 : points[1];
    const real_t points_2 = t813 ? t775 : points[2];
    const real_t points_3 = t813 ? t779 : points[3];
    const real_t points_4 = t813 ? t784 : points[4];
    const real_t points_5 = t813 ? t788 : points[5];
    const bool t814 = TB_C(1.0) == t799;
    const real_t points_6 = t814 ? t766 : points[6];
    const real_t points_7 = t814 ? t770 : points[7];
    const real_t points_8 = t814 ? t775 : points[8];
    const real_t points_9 = t814 ? t779 : points[9];
    const real_t points_10 = t814 ? t784 : points[10];
    const real_t points_11 = t814 ? t788 : points[11];
    const bool t815 = TB_C(2.0) == t799;
    const real_t points_12 = t815 ? t766 : points[12];
    const real_t points_13 = t815 ? t770 : points[13];
    const real_t points_14 = t815 ? t775 : points[14];
    const real_t points_15 = t815 ? t779 : points[15];
    const real_t points_16 = t815 ? t784 : points[16];
    const real_t points_17 = t815 ? t788 : points[17];
    const bool t816 = TB_C(3.0) == t799;
    const real_t points_18 = t816 ? t766 : points[18];
    const real_t points_19 = t816 ? t770 : points[19];
    const real_t points_20 = t816 ? t775 : points[20];
    const real_t points_21 = t816 ? t779 : points[21];
    const real_t points_22 = t816 ? t784 : points[22];
    const real_t points_23 = t816 ? t788 : points[23];
    const bool t817 = TB_C(4.0) == t799;
    const real_t points_24 = t817 ? t766 : points[24];
    const real_t points_25 = t817 ? t770 : points[25];
    const real_t points_26 = t817 ? t775 : points[26];
    const real_t points_27 = t817 ? t779 : points[27];
    const real_t points_28 = t817 ? t784 : points[28];
    const real_t points_29 = t817 ? t788 : points[29];
    const bool t818 = TB_C(5.0) == t799;
    const real_t points_30 = t818 ? t766 : points[30];
    const real_t points_31 = t818 ? t770 : points[31];
    const real_t points_32 = t818 ? t775 : points[32];
    const real_t points_33 = t818 ? t779 : points[33];
    const real_t points_34 = t818 ? t784 : points[34];
    const real_t points_35 = t818 ? t788 : points[35];
    const bool t819 = TB_C(6.0) == t799;
    const real_t points_36 = t819 ? t766 : points[36];
    const real_t points_37 = t819 ? t770 : points[37];
    const real_t points_38 = t819 ? t775 : points[38];
    const real_t points_39 = t819 ? t779 : points[39];
    const real_t points_40 = t819 ? t784 : points[40];
    const real_t points_41 = t819 ? t788 : points[41];
    const real_t t820 = -t512;
    const real_t t821 = -t515;
    const real_t t822 = tb_max(t820, t821);
    const real_t t823 = -t517;
    const real_t t824 = -t504;
    const real_t t825 = -t506;
    const real_t t826 = tb_max(t824, t825);
    const real_t t827 = -t508;
    const real_t t828 = -t510;
    const bool t829 = tb_max(t822, t823) <= tb_max(tb_max(t826, t827), t828);
    real_t t830;
    if (t829) {
        const real_t t831 = tb_max(t827, t828) <= t826 ? (t825 <= t824 ? TB_C(0.0) : TB_C(1.0))
            : (t828 <= t827 ? TB_C(2.0) : TB_C(3.0));
        t830 = t831;
    } else {
        const real_t t832 = t823 <= t822 ? (t821 <= t820 ? TB_C(4.0) : TB_C(5.0)) : TB_C(6.0);
        t830 = t832;
    }
    const real_t t833 = t519 ? t830 : -TB_C(1.0);
    const bool t834 = TB_C(0.0) == t833;
    const real_t t835 = t834 ? TB_C(0.0) : weight[0] + t518 * (t503 - weight[0]);
    const real_t weight_0 = t519 ? t835 : t503;
    const bool t836 = TB_C(1.0) == t833;
    const real_t t837 = t836 ? TB_C(0.0) : weight[1] + t518 * (t505 - weight[1]);
    const real_t weight_1 = t519 ? t837 : t505;
    const bool t838 = TB_C(2.0) == t833;
    const real_t t839 = t838 ? TB_C(0.0) : weight[2] + t518 * (t507 - weight[2]);
    const real_t weight_2 = t519 ? t839 : t507;
    const bool t840 = TB_C(3.0) == t833;
    const real_t t841 = t840 ? TB_C(0.0) : weight[3] + t518 * (t509 - weight[3]);
    const real_t weight_3 = t519 ? t841 : t509;
    const bool t842 = TB_C(4.0) == t833;
    const real_t t843 = t842 ? TB_C(0.0) : weight[4] + t518 * (t511 - weight[4]);
    const real_t weight_4 = t519 ? t843 : t511;
    const bool t844 = TB_C(5.0) == t833;
    const real_t t845 = t844 ? TB_C(0.0) : weight[5] + t518 * (t514 - weight[5]);
    const real_t weight_5 = t519 ? t845 : t514;
    const bool t846 = TB_C(6.0) == t833;
    const real_t t847 = t846 ? TB_C(0.0) : weight[6] + t518 * (t516 - weight[6]);
    const real_t weight_6 = t519 ? t847 : t516;
    const real_t used_0 = t813 ? TB_C(1.0) : (t834 ? TB_C(0.0) : used[0]);
    const real_t used_1 = t814 ? TB_C(1.0) : (t836 ? TB_C(0.0) : used[1]);
    const real_t used_2 = t815 ? TB_C(1.0) : (t838 ? TB_C(0.0) : used[2]);
    const real_t used_3 = t816 ? TB_C(1.0) : (t840 ? TB_C(0.0) : used[3]);
    const real_t used_4 = t817 ? TB_C(1.0) : (t842 ? TB_C(0.0) : used[4]);
    const real_t used_5 = t818 ? TB_C(1.0) : (t844 ? TB_C(0.0) : used[5]);
    const real_t used_6 = t819 ? TB_C(1.0) : (t846 ? TB_C(0.0) : used[6]);
    const real_t done_0 = t798 ? TB_C(1.0) : TB_C(0.0);
    points[0] = points_0;
    points[1] = points_1;
    points[2] = points_2;
    points[3] = points_3;
    points[4] = points_4;
    points[5] = points_5;
    points[6] = points_6;
    points[7] = points_7;
    points[8] = points_8;
    points[9] = points_9;
    points[10] = points_10;
    points[11] = points_11;
    points[12] = points_12;
    points[13] = points_13;
    points[14] = points_14;
    points[15] = points_15;
    points[16] = points_16;
    points[17] = points_17;
    points[18] = points_18;
    points[19] = points_19;
    points[20] = points_20;
    points[21] = points_21;
    points[22] = points_22;
    points[23] = points_23;
    points[24] = points_24;
    points[25] = points_25;
    points[26] = points_26;
    points[27] = points_27;
    points[28] = points_28;
    points[29] = points_29;
    points[30] = points_30;
    points[31] = points_31;
    points[32] = points_32;
    points[33] = points_33;
    points[34] = points_34;
    points[35] = points_35;
    points[36] = points_36;
    points[37] = points_37;
    points[38] = points_38;
    points[39] = points_39;
    points[40] = points_40;
    points[41] = points_41;
    weight[0] = weight_0;
    weight[1] = weight_1;
    weight[2] = weight_2;
    weight[3] = weight_3;
    weight[4] = weight_4;
    weight[5] = weight_5;
    weight[6] = weight_6;
    used[0] = used_0;
    used[1] = used_1;
    used[2] = used_2;
    used[3] = used_3;
    used[4] = used_4;
    used[5] = used_5;
    used[6] = used_6;
    offset[0] = offset_0;
    offset[1] = offset_1;
    offset[2] = offset_2;
    offset[3] = offset_3;
    offset[4] = offset_4;
    offset[5] = offset_5;
    done[0] = done_0;
    return TB_OK;
}

/* The nearest feasible wrench, judged. */
static tb_status tb_served_wrench_closest_finish(const real_t structure[48], const real_t wrench[6],
    const real_t offset[6], real_t served[6], real_t inner[6])
{
    const real_t t0 = offset[0] * offset[0] + offset[1] * offset[1] + offset[2] * offset[2];
    const real_t t1 = t0 + offset[3] * offset[3] + offset[4] * offset[4];
    const real_t t2 = TB_SQRT(t1 + offset[5] * offset[5]);
    const bool t3 = t2 <= TB_C(1024.0) * TB_EPSILON;
    const bool t4 = !t3;
    const real_t t5 = structure[0] + structure[1] + structure[2] + structure[3];
    const real_t t6 = t5 + structure[4] + structure[5] + structure[6] + structure[7];
    const real_t t7 = TB_TENSION_MIDDLE * t6;
    const real_t t8 = structure[8] + structure[9] + structure[10] + structure[11];
    const real_t t9 = t8 + structure[12] + structure[13] + structure[14];
    const real_t t10 = TB_TENSION_MIDDLE * (t9 + structure[15]);
    const real_t t11 = structure[16] + structure[17] + structure[18] + structure[19];
    const real_t t12 = t11 + structure[20] + structure[21] + structure[22];
    const real_t t13 = TB_TENSION_MIDDLE * (t12 + structure[23]);
    const real_t t14 = structure[24] + structure[25] + structure[26] + structure[27];
    const real_t t15 = t14 + structure[28] + structure[29] + structure[30];
    const real_t t16 = TB_TENSION_MIDDLE * (t15 + structure[31]);
    const real_t t17 = structure[32] + structure[33] + structure[34] + structure[35];
    const real_t t18 = t17 + structure[36] + structure[37] + structure[38];
    const real_t t19 = TB_TENSION_MIDDLE * (t18 + structure[39]);
    const real_t t20 = structure[40] + structure[41] + structure[42] + structure[43];
    const real_t t21 = t20 + structure[44] + structure[45] + structure[46];
    const real_t t22 = TB_TENSION_MIDDLE * (t21 + structure[47]);
    real_t served_0, served_1, served_2, served_3, served_4, served_5;
    if (t3) {
        served_0 = wrench[0];
        served_1 = wrench[1];
        served_2 = wrench[2];
        served_3 = wrench[3];
        served_4 = wrench[4];
        served_5 = wrench[5];
    } else {
        const real_t t23 = offset[0] + wrench[0];
        const real_t t24 = TB_EPSILON * TB_C(32.0);
        const real_t t25 = offset[1] + wrench[1];
        const real_t t26 = offset[2] + wrench[2];
        const real_t t27 = wrench[3] + offset[3] * TB_LONGEST_ARM;
        const real_t t28 = wrench[4] + offset[4] * TB_LONGEST_ARM;
        const real_t t29 = wrench[5] + offset[5] * TB_LONGEST_ARM;
        served_0 = t23 + t24 * (t7 - t23);
        served_1 = t25 + t24 * (t10 - t25);
        served_2 = t26 + t24 * (t13 - t26);
        served_3 = t27 + t24 * (t16 - t27);
        served_4 = t28 + t24 * (t19 - t28);
        served_5 = t29 + t24 * (t22 - t29);
    }
    const real_t inner_0 = served_0 + TB_C(3.814697265625e-06) * (t7 - served_0);
    const real_t inner_1 = served_1 + TB_C(3.814697265625e-06) * (t10 - served_1);
    const real_t inner_2 = served_2 + TB_C(3.814697265625e-06) * (t13 - served_2);
    const real_t inner_3 = served_3 + TB_C(3.814697265625e-06) * (t16 - served_3);
    const real_t inner_4 = served_4 + TB_C(3.814697265625e-06) * (t19 - served_4);
    const real_t inner_5 = served_5 + TB_C(3.814697265625e-06) * (t22 - served_5);
    const real_t t30 = offset[0] * structure[0] + offset[1] * structure[8];
    const real_t t31 = TB_MOMENT_WEIGHT * structure[24];
    const real_t t32 = t30 + offset[2] * structure[16] + offset[3] * t31;
    const real_t t33 = TB_MOMENT_WEIGHT * structure[32];
    const real_t t34 = TB_MOMENT_WEIGHT * structure[40];
    const bool t35 = t32 + offset[4] * t33 + offset[5] * t34 < TB_C(0.0);
    const real_t t36 = t35 ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t37 = offset[0] * structure[1] + offset[1] * structure[9];
    const real_t t38 = TB_MOMENT_WEIGHT * structure[25];
    const real_t t39 = t37 + offset[2] * structure[17] + offset[3] * t38;
    const real_t t40 = TB_MOMENT_WEIGHT * structure[33];
    const real_t t41 = TB_MOMENT_WEIGHT * structure[41];
    const bool t42 = t39 + offset[4] * t40 + offset[5] * t41 < TB_C(0.0);
    const real_t t43 = t42 ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t44 = offset[0] * structure[2] + offset[1] * structure[10];
    const real_t t45 = TB_MOMENT_WEIGHT * structure[26];
    const real_t t46 = t44 + offset[2] * structure[18] + offset[3] * t45;
    const real_t t47 = TB_MOMENT_WEIGHT * structure[34];
    const real_t t48 = TB_MOMENT_WEIGHT * structure[42];
    const bool t49 = t46 + offset[4] * t47 + offset[5] * t48 < TB_C(0.0);
    const real_t t50 = t49 ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t51 = structure[0] * t36 + structure[1] * t43 + structure[2] * t50;
    const real_t t52 = offset[0] * structure[3] + offset[1] * structure[11];
    const real_t t53 = TB_MOMENT_WEIGHT * structure[27];
    const real_t t54 = t52 + offset[2] * structure[19] + offset[3] * t53;
    const real_t t55 = TB_MOMENT_WEIGHT * structure[35];
    const real_t t56 = TB_MOMENT_WEIGHT * structure[43];
    const bool t57 = t54 + offset[4] * t55 + offset[5] * t56 < TB_C(0.0);
    const real_t t58 = t57 ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t59 = offset[0] * structure[4] + offset[1] * structure[12];
    const real_t t60 = TB_MOMENT_WEIGHT * structure[28];
    const real_t t61 = t59 + offset[2] * structure[20] + offset[3] * t60;
    const real_t t62 = TB_MOMENT_WEIGHT * structure[36];
    const real_t t63 = TB_MOMENT_WEIGHT * structure[44];
    const bool t64 = t61 + offset[4] * t62 + offset[5] * t63 < TB_C(0.0);
    const real_t t65 = t64 ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t66 = offset[0] * structure[5] + offset[1] * structure[13];
    const real_t t67 = TB_MOMENT_WEIGHT * structure[29];
    const real_t t68 = t66 + offset[2] * structure[21] + offset[3] * t67;
    const real_t t69 = TB_MOMENT_WEIGHT * structure[37];
    const real_t t70 = TB_MOMENT_WEIGHT * structure[45];
    const bool t71 = t68 + offset[4] * t69 + offset[5] * t70 < TB_C(0.0);
    const real_t t72 = t71 ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t73 = t51 + structure[3] * t58 + structure[4] * t65 + structure[5] * t72;
    const real_t t74 = offset[0] * structure[6] + offset[1] * structure[14];
    const real_t t75 = TB_MOMENT_WEIGHT * structure[30];
    const real_t t76 = t74 + offset[2] * structure[22] + offset[3] * t75;
    const real_t t77 = TB_MOMENT_WEIGHT * structure[38];
    const real_t t78 = TB_MOMENT_WEIGHT * structure[46];
    const bool t79 = t76 + offset[4] * t77 + offset[5] * t78 < TB_C(0.0);
    const real_t t80 = t79 ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t81 = offset[0] * structure[7] + offset[1] * structure[15];
    const real_t t82 = TB_MOMENT_WEIGHT * structure[31];
    const real_t t83 = t81 + offset[2] * structure[23] + offset[3] * t82;
    const real_t t84 = TB_MOMENT_WEIGHT * structure[39];
    const real_t t85 = TB_MOMENT_WEIGHT * structure[47];
    const bool t86 = t83 + offset[4] * t84 + offset[5] * t85 < TB_C(0.0);
    const real_t t87 = t86 ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t88 = t73 + structure[6] * t80 + structure[7] * t87 - wrench[0];
    const real_t t89 = structure[8] * t36 + structure[9] * t43 + structure[10] * t50;
    const real_t t90 = t89 + structure[11] * t58 + structure[12] * t65 + structure[13] * t72;
    const real_t t91 = t90 + structure[14] * t80 + structure[15] * t87 - wrench[1];
    const real_t t92 = offset[0] * (offset[0] - t88) + offset[1] * (offset[1] - t91);
    const real_t t93 = structure[16] * t36 + structure[17] * t43 + structure[18] * t50;
    const real_t t94 = t93 + structure[19] * t58 + structure[20] * t65 + structure[21] * t72;
    const real_t t95 = t94 + structure[22] * t80 + structure[23] * t87 - wrench[2];
    const real_t t96 = t31 * t36 + t38 * t43 + t45 * t50 + t53 * t58 + t60 * t65;
    const real_t t97 = wrench[3] * TB_MOMENT_WEIGHT;
    const real_t t98 = offset[3] - (t96 + t67 * t72 + t75 * t80 + t82 * t87 - t97);
    const real_t t99 = t92 + offset[2] * (offset[2] - t95) + offset[3] * t98;
    const real_t t100 = t33 * t36 + t40 * t43 + t47 * t50 + t55 * t58 + t62 * t65;
    const real_t t101 = TB_MOMENT_WEIGHT * wrench[4];
    const real_t t102 = offset[4] - (t100 + t69 * t72 + t77 * t80 + t84 * t87 - t101);
    const real_t t103 = t34 * t36 + t41 * t43 + t48 * t50 + t56 * t58 + t63 * t65;
    const real_t t104 = TB_MOMENT_WEIGHT * wrench[5];
    const real_t t105 = offset[5] - (t103 + t70 * t72 + t78 * t80 + t85 * t87 - t104);
    const real_t t106 = TB_ABS(wrench[0]) + TB_ABS(wrench[1]) + TB_ABS(wrench[2]);
    const real_t t107 = TB_C(64.0) + (t106 + TB_ABS(t97) + TB_ABS(t101) + TB_ABS(t104));
    const bool t108 = t99 + offset[4] * t102 + offset[5] * t105 <= t2 * (TB_EPSILON *
        TB_C(64.0) * t107);
    const bool t109 = !(t3 || t108);
    if (t109) {
        served[0] = TB_C(0.0);
        served[1] = TB_C(0.0);
        served[2] = TB_C(0.0);
        served[3] = TB_C(0.0);
        served[4] = TB_C(0.0);
        served[5] = TB_C(0.0);
        inner[0] = TB_C(0.0);
        inner[1] = TB_C(0.0);
        inner[2] = TB_C(0.0);
        inner[3] = TB_C(0.0);
        inner[4] = TB_C(0.0);
        inner[5] = TB_C(0.0);
        return TB_INACCURATE;
    }
    served[0] = served_0;
    served[1] = served_1;
    served[2] = served_2;
    served[3] = served_3;
    served[4] = served_4;
    served[5] = served_5;
    inner[0] = inner_0;
    inner[1] = inner_1;
    inner[2] = inner_2;
    inner[3] = inner_3;
    inner[4] = inner_4;
    inner[5] = inner_5;
    return t4 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_served_wrench_closest(const real_t structure[48], const real_t wrench[6],
    real_t served[6], real_t inner[6])
{
    real_t points[42];
    real_t weight[7];
    real_t used[7];
    real_t offset[6];
    real_t done[1] = {TB_C(0.0)};
    tb_status status = tb_served_wrench_closest_begin(structure, wrench, points, weight, used,
        offset);
    for (int steps = 0; steps < 280 && status == TB_OK && !(done[0] > TB_C(0.0)); steps++) {
        status = tb_served_wrench_closest_step(structure, wrench, points, weight, used, offset,
            done);
    }
    if (status == TB_OK && !(done[0] > TB_C(0.0))) {
        status = TB_INACCURATE;
    }
    if (status != TB_OK) {
        served[0] = TB_C(0.0);
        served[1] = TB_C(0.0);
        served[2] = TB_C(0.0);
        served[3] = TB_C(0.0);
        served[4] = TB_C(0.0);
        served[5] = TB_C(0.0);
        inner[0] = TB_C(0.0);
        inner[1] = TB_C(0.0);
        inner[2] = TB_C(0.0);
        inner[3] = TB_C(0.0);
        inner[4] = TB_C(0.0);
        inner[5] = TB_C(0.0);
        return status;
    }
    return tb_served_wrench_closest_finish(structure, wrench, offset, served, inner);
}

/* Refuses with a status: weighed is 0; asked is 0 N; inside is 0; largest is 0; first is 0;
 *   last is 0. */
static tb_status tb_refuse_wrench_ray_begin(tb_status status, real_t weighed[48],
    real_t asked[6], real_t inside[1], real_t largest[1], real_t first[1], real_t last[1])
{
    weighed[0] = TB_C(0.0);
    weighed[1] = TB_C(0.0);
    weighed[2] = TB_C(0.0);
    weighed[3] = TB_C(0.0);
    weighed[4] = TB_C(0.0);
    weighed[5] = TB_C(0.0);
    weighed[6] = TB_C(0.0);
    weighed[7] = TB_C(0.0);
    weighed[8] = TB_C(0.0);
    weighed[9] = TB_C(0.0);
    weighed[10] = TB_C(0.0);
    weighed[11] = TB_C(0.0);
    weighed[12] = TB_C(0.0);
    weighed[13] = TB_C(0.0);
    weighed[14] = TB_C(0.0);
    weighed[15] = TB_C(0.0);
    weighed[16] = TB_C(0.0);
    weighed[17] = TB_C(0.0);
    weighed[18] = TB_C(0.0);
    weighed[19] = TB_C(0.0);
    weighed[20] = TB_C(0.0);
    weighed[21] = TB_C(0.0);
    weighed[22] = TB_C(0.0);
    weighed[23] = TB_C(0.0);
    weighed[24] = TB_C(0.0);
    weighed[25] = TB_C(0.0);
    weighed[26] = TB_C(0.0);
    weighed[27] = TB_C(0.0);
    weighed[28] = TB_C(0.0);
    weighed[29] = TB_C(0.0);
    weighed[30] = TB_C(0.0);
    weighed[31] = TB_C(0.0);
    weighed[32] = TB_C(0.0);
    weighed[33] = TB_C(0.0);
    weighed[34] = TB_C(0.0);
    weighed[35] = TB_C(0.0);
    weighed[36] = TB_C(0.0);
    weighed[37] = TB_C(0.0);
    weighed[38] = TB_C(0.0);
    weighed[39] = TB_C(0.0);
    weighed[40] = TB_C(0.0);
    weighed[41] = TB_C(0.0);
    weighed[42] = TB_C(0.0);
    weighed[43] = TB_C(0.0);
    weighed[44] = TB_C(0.0);
    weighed[45] = TB_C(0.0);
    weighed[46] = TB_C(0.0);
    weighed[47] = TB_C(0.0);
    asked[0] = TB_C(0.0);
    asked[1] = TB_C(0.0);
    asked[2] = TB_C(0.0);
    asked[3] = TB_C(0.0);
    asked[4] = TB_C(0.0);
    asked[5] = TB_C(0.0);
    inside[0] = TB_C(0.0);
    largest[0] = TB_C(0.0);
    first[0] = TB_C(0.0);
    last[0] = TB_C(0.0);
    return status;
}

/* Before the first subset. */
static tb_status tb_wrench_ray_begin(const real_t structure[48], const real_t wrench[6],
    real_t weighed[48], real_t asked[6], real_t inside[1], real_t largest[1], real_t first[1],
    real_t last[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) + TB_ABS(structure[10]) + TB_ABS(structure[11]) +
              TB_ABS(structure[12]) + TB_ABS(structure[13]) + TB_ABS(structure[14]) +
              TB_ABS(structure[15]) + TB_ABS(structure[16]) + TB_ABS(structure[17]) +
              TB_ABS(structure[18]) + TB_ABS(structure[19]) + TB_ABS(structure[20]) +
              TB_ABS(structure[21]) + TB_ABS(structure[22]) + TB_ABS(structure[23]) +
              TB_ABS(structure[24]) + TB_ABS(structure[25]) + TB_ABS(structure[26]) +
              TB_ABS(structure[27]) + TB_ABS(structure[28]) + TB_ABS(structure[29]) +
              TB_ABS(structure[30]) + TB_ABS(structure[31]) + TB_ABS(structure[32]) +
              TB_ABS(structure[33]) + TB_ABS(structure[34]) + TB_ABS(structure[35]) +
              TB_ABS(structure[36]) + TB_ABS(structure[37]) + TB_ABS(structure[38]) +
              TB_ABS(structure[39]) + TB_ABS(structure[40]) + TB_ABS(structure[41]) +
              TB_ABS(structure[42]) + TB_ABS(structure[43]) + TB_ABS(structure[44]) +
              TB_ABS(structure[45]) + TB_ABS(structure[46]) + TB_ABS(structure[47]) <=
              TB_C(192.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) + TB_ABS(wrench[2]) + TB_ABS(wrench[3]) +
              TB_ABS(wrench[4]) + TB_ABS(wrench[5]) <= TB_C(384000.0))) {
        return tb_refuse_wrench_ray_begin(TB_OUT_OF_DOMAIN, weighed, asked, inside, largest, first, last);
    }
    const real_t weighed_24 = TB_MOMENT_WEIGHT * structure[24];
    const real_t weighed_25 = TB_MOMENT_WEIGHT * structure[25];
    const real_t weighed_26 = TB_MOMENT_WEIGHT * structure[26];
    const real_t weighed_27 = TB_MOMENT_WEIGHT * structure[27];
    const real_t weighed_28 = TB_MOMENT_WEIGHT * structure[28];
    const real_t weighed_29 = TB_MOMENT_WEIGHT * structure[29];
    const real_t weighed_30 = TB_MOMENT_WEIGHT * structure[30];
    const real_t weighed_31 = TB_MOMENT_WEIGHT * structure[31];
    const real_t weighed_32 = TB_MOMENT_WEIGHT * structure[32];
    const real_t weighed_33 = TB_MOMENT_WEIGHT * structure[33];
    const real_t weighed_34 = TB_MOMENT_WEIGHT * structure[34];
    const real_t weighed_35 = TB_MOMENT_WEIGHT * structure[35];
    const real_t weighed_36 = TB_MOMENT_WEIGHT * structure[36];
    const real_t weighed_37 = TB_MOMENT_WEIGHT * structure[37];
    const real_t weighed_38 = TB_MOMENT_WEIGHT * structure[38];
    const real_t weighed_39 = TB_MOMENT_WEIGHT * structure[39];
    const real_t weighed_40 = TB_MOMENT_WEIGHT * structure[40];
    const real_t weighed_41 = TB_MOMENT_WEIGHT * structure[41];
    const real_t weighed_42 = TB_MOMENT_WEIGHT * structure[42];
    const real_t weighed_43 = TB_MOMENT_WEIGHT * structure[43];
    const real_t weighed_44 = TB_MOMENT_WEIGHT * structure[44];
    const real_t weighed_45 = TB_MOMENT_WEIGHT * structure[45];
    const real_t weighed_46 = TB_MOMENT_WEIGHT * structure[46];
    const real_t weighed_47 = TB_MOMENT_WEIGHT * structure[47];
    const real_t asked_3 = TB_MOMENT_WEIGHT * wrench[3];
    const real_t asked_4 = TB_MOMENT_WEIGHT * wrench[4];
    const real_t asked_5 = TB_MOMENT_WEIGHT * wrench[5];
    const real_t t0 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const real_t t1 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t2 = t1 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t3 = t2 + structure[4] * structure[4] + structure[5] * structure[5];
    const real_t t4 = t3 + structure[6] * structure[6] + structure[7] * structure[7];
    const real_t t5 = TB_SQRT(t4);
    const real_t t6 = TB_COPYSIGN(t5, structure[0]);
    const real_t t7 = structure[0] + t6;
    const real_t t8 = structure[8] * t7 + structure[1] * structure[9] + structure[2] *
        structure[10];
    const real_t t9 = t8 + structure[3] * structure[11] + structure[4] * structure[12];
    const real_t t10 = t9 + structure[5] * structure[13] + structure[6] * structure[14];
    const real_t t11 = TB_C(1.0) / (t5 * (t5 + TB_ABS(structure[0])));
    const real_t t12 = (t10 + structure[7] * structure[15]) * t11;
    const real_t t13 = structure[9] - structure[1] * t12;
    const real_t t14 = structure[10] - structure[2] * t12;
    const real_t t15 = structure[11] - structure[3] * t12;
    const real_t t16 = structure[12] - structure[4] * t12;
    const real_t t17 = structure[13] - structure[5] * t12;
    const real_t t18 = t13 * t13 + t14 * t14 + t15 * t15 + t16 * t16 + t17 * t17;
    const real_t t19 = structure[14] - structure[6] * t12;
    const real_t t20 = structure[15] - structure[7] * t12;
    const real_t t21 = TB_SQRT(t18 + t19 * t19 + t20 * t20);
    const real_t t22 = TB_COPYSIGN(t21, t13);
    const real_t t23 = structure[16] * t7 + structure[1] * structure[17];
    const real_t t24 = t23 + structure[2] * structure[18] + structure[3] * structure[19];
    const real_t t25 = t24 + structure[4] * structure[20] + structure[5] * structure[21];
    const real_t t26 = t25 + structure[6] * structure[22] + structure[7] * structure[23];
    const real_t t27 = t11 * t26;
    const real_t t28 = structure[18] - structure[2] * t27;
    const real_t t29 = t13 + t22;
    const real_t t30 = t29 * (structure[17] - structure[1] * t27) + t14 * t28;
    const real_t t31 = structure[19] - structure[3] * t27;
    const real_t t32 = structure[20] - structure[4] * t27;
    const real_t t33 = structure[21] - structure[5] * t27;
    const real_t t34 = structure[22] - structure[6] * t27;
    const real_t t35 = t30 + t15 * t31 + t16 * t32 + t17 * t33 + t19 * t34;
    const real_t t36 = structure[23] - structure[7] * t27;
    const real_t t37 = TB_C(1.0) / (t21 * (t21 + TB_ABS(t13)));
    const real_t t38 = (t35 + t20 * t36) * t37;
    const real_t t39 = t28 - t14 * t38;
    const real_t t40 = t31 - t15 * t38;
    const real_t t41 = t32 - t16 * t38;
    const real_t t42 = t33 - t17 * t38;
    const real_t t43 = t34 - t19 * t38;
    const real_t t44 = t39 * t39 + t40 * t40 + t41 * t41 + t42 * t42 + t43 * t43;
    const real_t t45 = t36 - t20 * t38;
    const real_t t46 = TB_SQRT(t44 + t45 * t45);
    const real_t t47 = TB_COPYSIGN(t46, t39);
    const bool t48 = t0 < TB_ABS(t6) && t0 < TB_ABS(t22) && t0 < TB_ABS(t47);
    const real_t t49 = weighed_24 * t7 + structure[1] * weighed_25 + structure[2] * weighed_26;
    const real_t t50 = t49 + structure[3] * weighed_27 + structure[4] * weighed_28;
    const real_t t51 = t50 + structure[5] * weighed_29 + structure[6] * weighed_30;
    const real_t t52 = t11 * (t51 + structure[7] * weighed_31);
    const real_t t53 = weighed_27 - structure[3] * t52;
    const real_t t54 = weighed_26 - structure[2] * t52;
    const real_t t55 = t29 * (weighed_25 - structure[1] * t52) + t14 * t54;
    const real_t t56 = weighed_28 - structure[4] * t52;
    const real_t t57 = weighed_29 - structure[5] * t52;
    const real_t t58 = weighed_30 - structure[6] * t52;
    const real_t t59 = t55 + t15 * t53 + t16 * t56 + t17 * t57 + t19 * t58;
    const real_t t60 = weighed_31 - structure[7] * t52;
    const real_t t61 = t37 * (t59 + t20 * t60);
    const real_t t62 = t53 - t15 * t61;
    const real_t t63 = t39 + t47;
    const real_t t64 = t56 - t16 * t61;
    const real_t t65 = t57 - t17 * t61;
    const real_t t66 = t63 * (t54 - t14 * t61) + t40 * t62 + t41 * t64 + t42 * t65;
    const real_t t67 = t58 - t19 * t61;
    const real_t t68 = t60 - t20 * t61;
    const real_t t69 = TB_C(1.0) / (t46 * (t46 + TB_ABS(t39)));
    const real_t t70 = (t66 + t43 * t67 + t45 * t68) * t69;
    const real_t t71 = t62 - t40 * t70;
    const real_t t72 = t64 - t41 * t70;
    const real_t t73 = t65 - t42 * t70;
    const real_t t74 = t67 - t43 * t70;
    const real_t t75 = t68 - t45 * t70;
    const real_t t76 = t71 * t71 + t72 * t72 + t73 * t73 + t74 * t74 + t75 * t75;
    const real_t t77 = TB_SQRT(t76);
    const real_t t78 = TB_COPYSIGN(t77, t71);
    const real_t t79 = weighed_32 * t7 + structure[1] * weighed_33 + structure[2] * weighed_34;
    const real_t t80 = t79 + structure[3] * weighed_35 + structure[4] * weighed_36;
    const real_t t81 = t80 + structure[5] * weighed_37 + structure[6] * weighed_38;
    const real_t t82 = t11 * (t81 + structure[7] * weighed_39);
    const real_t t83 = weighed_36 - structure[4] * t82;
    const real_t t84 = weighed_34 - structure[2] * t82;
    const real_t t85 = t29 * (weighed_33 - structure[1] * t82) + t14 * t84;
    const real_t t86 = weighed_35 - structure[3] * t82;
    const real_t t87 = weighed_37 - structure[5] * t82;
    const real_t t88 = weighed_38 - structure[6] * t82;
    const real_t t89 = t85 + t15 * t86 + t16 * t83 + t17 * t87 + t19 * t88;
    const real_t t90 = weighed_39 - structure[7] * t82;
    const real_t t91 = t37 * (t89 + t20 * t90);
    const real_t t92 = t83 - t16 * t91;
    const real_t t93 = t86 - t15 * t91;
    const real_t t94 = t87 - t17 * t91;
    const real_t t95 = t63 * (t84 - t14 * t91) + t40 * t93 + t41 * t92 + t42 * t94;
    const real_t t96 = t88 - t19 * t91;
    const real_t t97 = t90 - t20 * t91;
    const real_t t98 = t69 * (t95 + t43 * t96 + t45 * t97);
    const real_t t99 = t92 - t41 * t98;
    const real_t t100 = t71 + t78;
    const real_t t101 = t94 - t42 * t98;
    const real_t t102 = t100 * (t93 - t40 * t98) + t72 * t99 + t73 * t101;
    const real_t t103 = t96 - t43 * t98;
    const real_t t104 = t97 - t45 * t98;
    const real_t t105 = TB_C(1.0) / (t77 * (t77 + TB_ABS(t71)));
    const real_t t106 = (t102 + t74 * t103 + t75 * t104) * t105;
    const real_t t107 = t99 - t72 * t106;
    const real_t t108 = t101 - t73 * t106;
    const real_t t109 = t103 - t74 * t106;
    const real_t t110 = t104 - t75 * t106;
    const real_t t111 = t107 * t107 + t108 * t108 + t109 * t109 + t110 * t110;
    const real_t t112 = TB_SQRT(t111);
    const real_t t113 = TB_COPYSIGN(t112, t107);
    const real_t t114 = weighed_40 * t7 + structure[1] * weighed_41 + structure[2] * weighed_42;
    const real_t t115 = t114 + structure[3] * weighed_43 + structure[4] * weighed_44;
    const real_t t116 = t115 + structure[5] * weighed_45 + structure[6] * weighed_46;
    const real_t t117 = t11 * (t116 + structure[7] * weighed_47);
    const real_t t118 = weighed_45 - structure[5] * t117;
    const real_t t119 = weighed_42 - structure[2] * t117;
    const real_t t120 = t29 * (weighed_41 - structure[1] * t117) + t14 * t119;
    const real_t t121 = weighed_43 - structure[3] * t117;
    const real_t t122 = weighed_44 - structure[4] * t117;
    const real_t t123 = weighed_46 - structure[6] * t117;
    const real_t t124 = t120 + t15 * t121 + t16 * t122 + t17 * t118 + t19 * t123;
    const real_t t125 = weighed_47 - structure[7] * t117;
    const real_t t126 = t37 * (t124 + t20 * t125);
    const real_t t127 = t118 - t17 * t126;
    const real_t t128 = t121 - t15 * t126;
    const real_t t129 = t122 - t16 * t126;
    const real_t t130 = t63 * (t119 - t14 * t126) + t40 * t128 + t41 * t129;
    const real_t t131 = t123 - t19 * t126;
    const real_t t132 = t125 - t20 * t126;
    const real_t t133 = t69 * (t130 + t42 * t127 + t43 * t131 + t45 * t132);
    const real_t t134 = t127 - t42 * t133;
    const real_t t135 = t129 - t41 * t133;
    const real_t t136 = t100 * (t128 - t40 * t133) + t72 * t135 + t73 * t134;
    const real_t t137 = t131 - t43 * t133;
    const real_t t138 = t132 - t45 * t133;
    const real_t t139 = t105 * (t136 + t74 * t137 + t75 * t138);
    const real_t t140 = t134 - t73 * t139;
    const real_t t141 = (t107 + t113) * (t135 - t72 * t139) + t108 * t140;
    const real_t t142 = t137 - t74 * t139;
    const real_t t143 = t138 - t75 * t139;
    const real_t t144 = (t141 + t109 * t142 + t110 * t143) * (TB_C(1.0) / (t112 * (t112 +
        TB_ABS(t107))));
    const real_t t145 = t140 - t108 * t144;
    const real_t t146 = t142 - t109 * t144;
    const real_t t147 = t143 - t110 * t144;
    const real_t t148 = TB_COPYSIGN(TB_SQRT(t145 * t145 + t146 * t146 + t147 * t147), t145);
    const bool t149 = t48 && t0 < TB_ABS(t78) && t0 < TB_ABS(t113) && t0 < TB_ABS(t148);
    const bool t150 = !t149;
    if (t150) {
        return tb_refuse_wrench_ray_begin(TB_SINGULAR, weighed, asked, inside, largest, first, last);
    }
    weighed[0] = structure[0];
    weighed[1] = structure[1];
    weighed[2] = structure[2];
    weighed[3] = structure[3];
    weighed[4] = structure[4];
    weighed[5] = structure[5];
    weighed[6] = structure[6];
    weighed[7] = structure[7];
    weighed[8] = structure[8];
    weighed[9] = structure[9];
    weighed[10] = structure[10];
    weighed[11] = structure[11];
    weighed[12] = structure[12];
    weighed[13] = structure[13];
    weighed[14] = structure[14];
    weighed[15] = structure[15];
    weighed[16] = structure[16];
    weighed[17] = structure[17];
    weighed[18] = structure[18];
    weighed[19] = structure[19];
    weighed[20] = structure[20];
    weighed[21] = structure[21];
    weighed[22] = structure[22];
    weighed[23] = structure[23];
    weighed[24] = weighed_24;
    weighed[25] = weighed_25;
    weighed[26] = weighed_26;
    weighed[27] = weighed_27;
    weighed[28] = weighed_28;
    weighed[29] = weighed_29;
    weighed[30] = weighed_30;
    weighed[31] = weighed_31;
    weighed[32] = weighed_32;
    weighed[33] = weighed_33;
    weighed[34] = weighed_34;
    weighed[35] = weighed_35;
    weighed[36] = weighed_36;
    weighed[37] = weighed_37;
    weighed[38] = weighed_38;
    weighed[39] = weighed_39;
    weighed[40] = weighed_40;
    weighed[41] = weighed_41;
    weighed[42] = weighed_42;
    weighed[43] = weighed_43;
    weighed[44] = weighed_44;
    weighed[45] = weighed_45;
    weighed[46] = weighed_46;
    weighed[47] = weighed_47;
    asked[0] = wrench[0];
    asked[1] = wrench[1];
    asked[2] = wrench[2];
    asked[3] = asked_3;
    asked[4] = asked_4;
    asked[5] = asked_5;
    inside[0] = TB_C(1.0);
    largest[0] = TB_C(1.0);
    first[0] = TB_C(0.0);
    last[0] = TB_C(1.0);
    return TB_OK;
}

/* One subset. */
static tb_status tb_wrench_ray_visit(const real_t chosen[30], const real_t numbers[5],
    const real_t weighed[48], const real_t asked[6], real_t inside[1], real_t largest[1],
    real_t first[1], real_t last[1])
{
    const real_t t0 = TB_C(16.0) * TB_EPSILON;
    const real_t t1 = chosen[0] * chosen[0] + chosen[5] * chosen[5] + chosen[10] * chosen[10];
    const real_t t2 = t1 + chosen[15] * chosen[15] + chosen[20] * chosen[20];
    const real_t t3 = TB_SQRT(t2 + chosen[25] * chosen[25]);
    const real_t t4 = TB_COPYSIGN(t3, chosen[0]);
    const real_t t5 = chosen[0] + t4;
    const real_t t6 = t5 * chosen[1] + chosen[5] * chosen[6] + chosen[10] * chosen[11];
    const real_t t7 = t6 + chosen[15] * chosen[16] + chosen[20] * chosen[21];
    const real_t t8 = TB_C(1.0) / (t3 * (t3 + TB_ABS(chosen[0])));
    const real_t t9 = (t7 + chosen[25] * chosen[26]) * t8;
    const real_t t10 = chosen[6] - chosen[5] * t9;
    const real_t t11 = chosen[11] - chosen[10] * t9;
    const real_t t12 = chosen[16] - chosen[15] * t9;
    const real_t t13 = chosen[21] - chosen[20] * t9;
    const real_t t14 = chosen[26] - chosen[25] * t9;
    const real_t t15 = t10 * t10 + t11 * t11 + t12 * t12 + t13 * t13 + t14 * t14;
    const real_t t16 = TB_SQRT(t15);
    const real_t t17 = TB_COPYSIGN(t16, t10);
    const real_t t18 = t5 * chosen[2] + chosen[5] * chosen[7] + chosen[10] * chosen[12];
    const real_t t19 = t18 + chosen[15] * chosen[17] + chosen[20] * chosen[22];
    const real_t t20 = t8 * (t19 + chosen[25] * chosen[27]);
    const real_t t21 = chosen[12] - chosen[10] * t20;
    const real_t t22 = t10 + t17;
    const real_t t23 = chosen[17] - chosen[15] * t20;
    const real_t t24 = t22 * (chosen[7] - chosen[5] * t20) + t11 * t21 + t12 * t23;
    const real_t t25 = chosen[22] - chosen[20] * t20;
    const real_t t26 = chosen[27] - chosen[25] * t20;
    const real_t t27 = TB_C(1.0) / (t16 * (t16 + TB_ABS(t10)));
    const real_t t28 = (t24 + t13 * t25 + t14 * t26) * t27;
    const real_t t29 = t21 - t11 * t28;
    const real_t t30 = t23 - t12 * t28;
    const real_t t31 = t25 - t13 * t28;
    const real_t t32 = t26 - t14 * t28;
    const real_t t33 = TB_SQRT(t29 * t29 + t30 * t30 + t31 * t31 + t32 * t32);
    const real_t t34 = TB_COPYSIGN(t33, t29);
    const bool t35 = t0 < TB_ABS(t4) && t0 < TB_ABS(t17) && t0 < TB_ABS(t34);
    const real_t t36 = t5 * chosen[3] + chosen[5] * chosen[8] + chosen[10] * chosen[13];
    const real_t t37 = t36 + chosen[15] * chosen[18] + chosen[20] * chosen[23];
    const real_t t38 = t8 * (t37 + chosen[25] * chosen[28]);
    const real_t t39 = chosen[18] - chosen[15] * t38;
    const real_t t40 = chosen[13] - chosen[10] * t38;
    const real_t t41 = t22 * (chosen[8] - chosen[5] * t38) + t11 * t40 + t12 * t39;
    const real_t t42 = chosen[23] - chosen[20] * t38;
    const real_t t43 = chosen[28] - chosen[25] * t38;
    const real_t t44 = t27 * (t41 + t13 * t42 + t14 * t43);
    const real_t t45 = t39 - t12 * t44;
    const real_t t46 = t29 + t34;
    const real_t t47 = t42 - t13 * t44;
    const real_t t48 = t43 - t14 * t44;
    const real_t t49 = t46 * (t40 - t11 * t44) + t30 * t45 + t31 * t47 + t32 * t48;
    const real_t t50 = TB_C(1.0) / (t33 * (t33 + TB_ABS(t29)));
    const real_t t51 = t49 * t50;
    const real_t t52 = t45 - t30 * t51;
    const real_t t53 = t47 - t31 * t51;
    const real_t t54 = t48 - t32 * t51;
    const real_t t55 = TB_SQRT(t52 * t52 + t53 * t53 + t54 * t54);
    const real_t t56 = TB_COPYSIGN(t55, t52);
    const real_t t57 = t5 * chosen[4] + chosen[5] * chosen[9] + chosen[10] * chosen[14];
    const real_t t58 = t57 + chosen[15] * chosen[19] + chosen[20] * chosen[24];
    const real_t t59 = t8 * (t58 + chosen[25] * chosen[29]);
    const real_t t60 = chosen[24] - chosen[20] * t59;
    const real_t t61 = chosen[14] - chosen[10] * t59;
    const real_t t62 = chosen[19] - chosen[15] * t59;
    const real_t t63 = t22 * (chosen[9] - chosen[5] * t59) + t11 * t61 + t12 * t62;
    const real_t t64 = chosen[29] - chosen[25] * t59;
    const real_t t65 = t27 * (t63 + t13 * t60 + t14 * t64);
    const real_t t66 = t60 - t13 * t65;
    const real_t t67 = t62 - t12 * t65;
    const real_t t68 = t64 - t14 * t65;
    const real_t t69 = t46 * (t61 - t11 * t65) + t30 * t67 + t31 * t66 + t32 * t68;
    const real_t t70 = t50 * t69;
    const real_t t71 = t66 - t31 * t70;
    const real_t t72 = t52 + t56;
    const real_t t73 = t68 - t32 * t70;
    const real_t t74 = TB_C(1.0) / (t55 * (t55 + TB_ABS(t52)));
    const real_t t75 = (t72 * (t67 - t30 * t70) + t53 * t71 + t54 * t73) * t74;
    const real_t t76 = t71 - t53 * t75;
    const real_t t77 = t73 - t54 * t75;
    const real_t t78 = TB_SQRT(t76 * t76 + t77 * t77);
    const real_t t79 = TB_COPYSIGN(t78, t76);
    const bool t80 = t35 && t0 < TB_ABS(t56) && t0 < TB_ABS(t79);
    const bool t81 = (numbers[0] == TB_C(0.0)) || (TB_C(0.0) == numbers[1]);
    const bool t82 = t81 || (TB_C(0.0) == numbers[2]) || (TB_C(0.0) == numbers[3]);
    const real_t t83 = t77 / (t78 * (t78 + TB_ABS(t76)));
    const real_t t84 = TB_C(1.0) - t77 * t83;
    const real_t t85 = t83 * (t76 + t79);
    const real_t t86 = t74 * (t54 * t84 - t53 * t85);
    const real_t t87 = t84 - t54 * t86;
    const real_t t88 = t72 * t86;
    const real_t t89 = t85 + t53 * t86;
    const real_t t90 = t50 * (t32 * t87 - (t30 * t88 + t31 * t89));
    const real_t t91 = t87 - t32 * t90;
    const real_t t92 = t46 * t90;
    const real_t t93 = t88 + t30 * t90;
    const real_t t94 = t89 + t31 * t90;
    const real_t t95 = t27 * (t14 * t91 - (t11 * t92 + t12 * t93 + t13 * t94));
    const real_t t96 = t91 - t14 * t95;
    const real_t t97 = t22 * t95;
    const real_t t98 = t92 + t11 * t95;
    const real_t t99 = t93 + t12 * t95;
    const real_t t100 = chosen[5] * t97 + chosen[10] * t98 + chosen[15] * t99;
    const real_t t101 = t94 + t13 * t95;
    const real_t t102 = t8 * (chosen[25] * t96 - (t100 + chosen[20] * t101));
    const real_t t103 = t96 - chosen[25] * t102;
    const real_t t104 = t5 * t102;
    const real_t t105 = t97 + chosen[5] * t102;
    const real_t t106 = t98 + chosen[10] * t102;
    const real_t t107 = t99 + chosen[15] * t102;
    const real_t t108 = t101 + chosen[20] * t102;
    real_t t109;
    if (t82 || (TB_C(0.0) == numbers[4])) {
        t109 = TB_C(0.0);
    } else {
        const real_t t110 = t104 * weighed[0] + t105 * weighed[8] + t106 * weighed[16];
        const real_t t111 = t103 * weighed[40] - (t110 + t107 * weighed[24] + t108 *
            weighed[32]);
        t109 = t111;
    }
    const bool t112 = (TB_C(1.0) == numbers[0]) || (TB_C(1.0) == numbers[1]);
    const bool t113 = t112 || (TB_C(1.0) == numbers[2]) || (TB_C(1.0) == numbers[3]);
    real_t t114;
    if (t113 || (TB_C(1.0) == numbers[4])) {
        t114 = TB_C(0.0);
    } else {
        const real_t t115 = t104 * weighed[1] + t105 * weighed[9] + t106 * weighed[17];
        const real_t t116 = t103 * weighed[41] - (t115 + t107 * weighed[25] + t108 *
            weighed[33]);
        t114 = t116;
    }
    const bool t117 = (numbers[0] == TB_C(2.0)) || (numbers[1] == TB_C(2.0));
    const bool t118 = t117 || (numbers[2] == TB_C(2.0)) || (numbers[3] == TB_C(2.0));
    real_t t119;
    if (t118 || (numbers[4] == TB_C(2.0))) {
        t119 = TB_C(0.0);
    } else {
        const real_t t120 = t104 * weighed[2] + t105 * weighed[10] + t106 * weighed[18];
        const real_t t121 = t103 * weighed[42] - (t120 + t107 * weighed[26] + t108 *
            weighed[34]);
        t119 = t121;
    }
    const bool t122 = (numbers[0] == TB_C(3.0)) || (numbers[1] == TB_C(3.0));
    const bool t123 = t122 || (numbers[2] == TB_C(3.0)) || (numbers[3] == TB_C(3.0));
    real_t t124;
    if (t123 || (numbers[4] == TB_C(3.0))) {
        t124 = TB_C(0.0);
    } else {
        const real_t t125 = t104 * weighed[3] + t105 * weighed[11] + t106 * weighed[19];
        const real_t t126 = t103 * weighed[43] - (t125 + t107 * weighed[27] + t108 *
            weighed[35]);
        t124 = t126;
    }
    const real_t t127 = TB_ABS(t109) + TB_ABS(t114) + TB_ABS(t119) + TB_ABS(t124);
    const bool t128 = (numbers[0] == TB_C(4.0)) || (numbers[1] == TB_C(4.0));
    const bool t129 = t128 || (numbers[2] == TB_C(4.0)) || (numbers[3] == TB_C(4.0));
    real_t t130;
    if (t129 || (numbers[4] == TB_C(4.0))) {
        t130 = TB_C(0.0);
    } else {
        const real_t t131 = t104 * weighed[4] + t105 * weighed[12] + t106 * weighed[20];
        const real_t t132 = t103 * weighed[44] - (t131 + t107 * weighed[28] + t108 *
            weighed[36]);
        t130 = t132;
    }
    const bool t133 = (numbers[0] == TB_C(5.0)) || (numbers[1] == TB_C(5.0));
    const bool t134 = t133 || (numbers[2] == TB_C(5.0)) || (numbers[3] == TB_C(5.0));
    real_t t135;
    if (t134 || (numbers[4] == TB_C(5.0))) {
        t135 = TB_C(0.0);
    } else {
        const real_t t136 = t104 * weighed[5] + t105 * weighed[13] + t106 * weighed[21];
        const real_t t137 = t103 * weighed[45] - (t136 + t107 * weighed[29] + t108 *
            weighed[37]);
        t135 = t137;
    }
    const bool t138 = (numbers[0] == TB_C(6.0)) || (numbers[1] == TB_C(6.0));
    const bool t139 = t138 || (numbers[2] == TB_C(6.0)) || (numbers[3] == TB_C(6.0));
    real_t t140;
    if (t139 || (numbers[4] == TB_C(6.0))) {
        t140 = TB_C(0.0);
    } else {
        const real_t t141 = t104 * weighed[6] + t105 * weighed[14] + t106 * weighed[22];
        const real_t t142 = t103 * weighed[46] - (t141 + t107 * weighed[30] + t108 *
            weighed[38]);
        t140 = t142;
    }
    const real_t t143 = t127 + TB_ABS(t130) + TB_ABS(t135) + TB_ABS(t140);
    const bool t144 = (numbers[0] == TB_C(7.0)) || (numbers[1] == TB_C(7.0));
    const bool t145 = t144 || (numbers[2] == TB_C(7.0)) || (numbers[3] == TB_C(7.0));
    real_t t146;
    if (t145 || (numbers[4] == TB_C(7.0))) {
        t146 = TB_C(0.0);
    } else {
        const real_t t147 = t104 * weighed[7] + t105 * weighed[15] + t106 * weighed[23];
        const real_t t148 = t103 * weighed[47] - (t147 + t107 * weighed[31] + t108 *
            weighed[39]);
        t146 = t148;
    }
    const real_t t149 = TB_TENSION_HALF_RANGE * (t143 + TB_ABS(t146));
    const real_t t150 = t104 * asked[0] + t105 * asked[1] + t106 * asked[2];
    const real_t t151 = t103 * asked[5] - (t150 + t107 * asked[3] + t108 * asked[4]);
    const real_t t152 = t140 + (t135 + (t130 + (t124 + (t119 + (t109 + t114)))));
    const real_t t153 = TB_TENSION_MIDDLE * (t146 + t152);
    const real_t inside_0 = t80 && t149 < TB_ABS(t151 - t153) ? TB_C(0.0) : inside[0];
    real_t largest_0, first_0, last_0;
    if (t80) {
        const real_t t154 = TB_EPSILON * TB_C(128.0);
        const bool t155 = t154 < TB_ABS(t151);
        real_t t156, t157, t158;
        if (t155) {
            const real_t t159 = TB_C(1.0) / t151;
            const real_t t160 = t159 * (t153 - t149 - t154);
            const real_t t161 = t159 * (t154 + (t149 + t153));
            t156 = (t153 + TB_COPYSIGN(t149, t151)) * t159;
            t157 = tb_min(t160, t161);
            t158 = tb_max(t160, t161);
        } else {
            const real_t t162 = t149 + t154 < TB_ABS(t153) ? TB_C(1e+30) : TB_C(0.0);
            t156 = TB_C(1.0);
            t157 = t162;
            t158 = TB_C(1.0);
        }
        largest_0 = tb_min(largest[0], t156);
        first_0 = tb_max(first[0], t157);
        last_0 = tb_min(last[0], t158);
    } else {
        largest_0 = largest[0];
        first_0 = first[0];
        last_0 = last[0];
    }
    inside[0] = inside_0;
    largest[0] = largest_0;
    first[0] = first_0;
    last[0] = last_0;
    return TB_OK;
}

/* After the last subset. */
static tb_status tb_wrench_ray_finish(const real_t inside[1], const real_t largest[1],
    const real_t first[1], const real_t last[1], real_t feasible[1], real_t fraction[1],
    real_t missed[1])
{
    const real_t fraction_0 = tb_max(largest[0], TB_C(0.0));
    const real_t missed_0 = inside[0] <= TB_C(0.0) && last[0] < first[0] ? TB_C(1.0) :
        TB_C(0.0);
    feasible[0] = inside[0];
    fraction[0] = fraction_0;
    missed[0] = missed_0;
    return TB_OK;
}

/* How far the ray to a wrench is feasible. */
static tb_status tb_wrench_ray(const real_t structure[48], const real_t wrench[6], real_t feasible[1],
    real_t fraction[1], real_t missed[1])
{
    static const unsigned char subsets[56][5] = {{0,1,2,3,4}, {0,1,2,3,5}, {0,1,2,3,6},
        {0,1,2,3,7}, {0,1,2,4,5}, {0,1,2,4,6}, {0,1,2,4,7}, {0,1,2,5,6}, {0,1,2,5,7},
        {0,1,2,6,7}, {0,1,3,4,5}, {0,1,3,4,6}, {0,1,3,4,7}, {0,1,3,5,6}, {0,1,3,5,7},
        {0,1,3,6,7}, {0,1,4,5,6}, {0,1,4,5,7}, {0,1,4,6,7}, {0,1,5,6,7}, {0,2,3,4,5},
        {0,2,3,4,6}, {0,2,3,4,7}, {0,2,3,5,6}, {0,2,3,5,7}, {0,2,3,6,7}, {0,2,4,5,6},
        {0,2,4,5,7}, {0,2,4,6,7}, {0,2,5,6,7}, {0,3,4,5,6}, {0,3,4,5,7}, {0,3,4,6,7},
        {0,3,5,6,7}, {0,4,5,6,7}, {1,2,3,4,5}, {1,2,3,4,6}, {1,2,3,4,7}, {1,2,3,5,6},
        {1,2,3,5,7}, {1,2,3,6,7}, {1,2,4,5,6}, {1,2,4,5,7}, {1,2,4,6,7}, {1,2,5,6,7},
        {1,3,4,5,6}, {1,3,4,5,7}, {1,3,4,6,7}, {1,3,5,6,7}, {1,4,5,6,7}, {2,3,4,5,6},
        {2,3,4,5,7}, {2,3,4,6,7}, {2,3,5,6,7}, {2,4,5,6,7}, {3,4,5,6,7}};
    real_t weighed[48];
    real_t asked[6];
    real_t inside[1];
    real_t largest[1];
    real_t first[1];
    real_t last[1];
    const tb_status status = tb_wrench_ray_begin(structure, wrench, weighed, asked, inside,
        largest, first, last);
    if (status != TB_OK) {
        feasible[0] = TB_C(0.0);
        fraction[0] = TB_C(0.0);
        missed[0] = TB_C(0.0);
        return status;
    }
    for (int k = 0; k < 56; k++) {
        real_t chosen[30];
        real_t numbers[5];
        for (int j = 0; j < 5; j++) {
            const int number = subsets[k][j];
            for (int i = 0; i < 6; i++) {
                chosen[5 * i + j] = weighed[8 * i + number];
            }
            numbers[j] = (real_t)number;
        }
        (void)tb_wrench_ray_visit(chosen, numbers, weighed, asked, inside, largest, first,
            last);
    }
    return tb_wrench_ray_finish(inside, largest, first, last, feasible, fraction, missed);
}

/* The wrench that is served: an infeasible one keeps its direction and is scaled down to the
 *   largest feasible fraction. */
static tb_status tb_served_fraction(const real_t structure[48], const real_t wrench[6],
    const real_t feasible[1], const real_t fraction[1], const real_t missed[1],
    const real_t closest[6], real_t served[6], real_t inner[6])
{
    const bool t0 = TB_C(0.0) < feasible[0];
    const bool t1 = !t0;
    const real_t t2 = structure[0] + structure[1] + structure[2] + structure[3];
    const real_t t3 = t2 + structure[4] + structure[5] + structure[6] + structure[7];
    const real_t t4 = TB_TENSION_MIDDLE * t3;
    const real_t t5 = structure[8] + structure[9] + structure[10] + structure[11];
    const real_t t6 = t5 + structure[12] + structure[13] + structure[14];
    const real_t t7 = TB_TENSION_MIDDLE * (t6 + structure[15]);
    const real_t t8 = structure[16] + structure[17] + structure[18] + structure[19];
    const real_t t9 = t8 + structure[20] + structure[21] + structure[22];
    const real_t t10 = TB_TENSION_MIDDLE * (t9 + structure[23]);
    const real_t t11 = structure[24] + structure[25] + structure[26] + structure[27];
    const real_t t12 = t11 + structure[28] + structure[29] + structure[30];
    const real_t t13 = TB_TENSION_MIDDLE * (t12 + structure[31]);
    const real_t t14 = structure[32] + structure[33] + structure[34] + structure[35];
    const real_t t15 = t14 + structure[36] + structure[37] + structure[38];
    const real_t t16 = TB_TENSION_MIDDLE * (t15 + structure[39]);
    const real_t t17 = structure[40] + structure[41] + structure[42] + structure[43];
    const real_t t18 = t17 + structure[44] + structure[45] + structure[46];
    const real_t t19 = TB_TENSION_MIDDLE * (t18 + structure[47]);
    real_t served_0, served_1, served_2, served_3, served_4, served_5;
    if (t0) {
        served_0 = wrench[0];
        served_1 = wrench[1];
        served_2 = wrench[2];
        served_3 = wrench[3];
        served_4 = wrench[4];
        served_5 = wrench[5];
    } else {
        const bool t20 = TB_C(0.0) < missed[0];
        const real_t t21 = t20 ? closest[0] : wrench[0] * fraction[0];
        const real_t t22 = TB_C(32.0) * TB_EPSILON;
        const real_t t23 = t20 ? closest[1] : fraction[0] * wrench[1];
        const real_t t24 = t20 ? closest[2] : fraction[0] * wrench[2];
        const real_t t25 = t20 ? closest[3] : fraction[0] * wrench[3];
        const real_t t26 = t20 ? closest[4] : fraction[0] * wrench[4];
        const real_t t27 = t20 ? closest[5] : fraction[0] * wrench[5];
        served_0 = t21 + t22 * (t4 - t21);
        served_1 = t23 + t22 * (t7 - t23);
        served_2 = t24 + t22 * (t10 - t24);
        served_3 = t25 + t22 * (t13 - t25);
        served_4 = t26 + t22 * (t16 - t26);
        served_5 = t27 + t22 * (t19 - t27);
    }
    const real_t inner_0 = served_0 + TB_C(3.814697265625e-06) * (t4 - served_0);
    const real_t inner_1 = served_1 + TB_C(3.814697265625e-06) * (t7 - served_1);
    const real_t inner_2 = served_2 + TB_C(3.814697265625e-06) * (t10 - served_2);
    const real_t inner_3 = served_3 + TB_C(3.814697265625e-06) * (t13 - served_3);
    const real_t inner_4 = served_4 + TB_C(3.814697265625e-06) * (t16 - served_4);
    const real_t inner_5 = served_5 + TB_C(3.814697265625e-06) * (t19 - served_5);
    served[0] = served_0;
    served[1] = served_1;
    served[2] = served_2;
    served[3] = served_3;
    served[4] = served_4;
    served[5] = served_5;
    inner[0] = inner_0;
    inner[1] = inner_1;
    inner[2] = inner_2;
    inner[3] = inner_3;
    inner[4] = inner_4;
    inner[5] = inner_5;
    return t1 ? TB_INFEASIBLE : TB_OK;
}

/* Refuses with a status: served is 0 N; inner is 0 N. */
static tb_status tb_refuse_served_wrench_scale(tb_status status, real_t served[6],
    real_t inner[6])
{
    served[0] = TB_C(0.0);
    served[1] = TB_C(0.0);
    served[2] = TB_C(0.0);
    served[3] = TB_C(0.0);
    served[4] = TB_C(0.0);
    served[5] = TB_C(0.0);
    inner[0] = TB_C(0.0);
    inner[1] = TB_C(0.0);
    inner[2] = TB_C(0.0);
    inner[3] = TB_C(0.0);
    inner[4] = TB_C(0.0);
    inner[5] = TB_C(0.0);
    return status;
}

tb_status tb_served_wrench_scale(const real_t structure[48], const real_t wrench[6],
    real_t served[6], real_t inner[6])
{
    real_t feasible[1];
    real_t fraction[1];
    real_t missed[1];
    real_t closest[6] = {TB_C(0.0)};
    real_t closer[6] = {TB_C(0.0)};
    bool infeasible = false;
    tb_status status;
    status = tb_wrench_ray(structure, wrench, feasible, fraction, missed);
    if (status > TB_INFEASIBLE) {
        return tb_refuse_served_wrench_scale(status, served, inner);
    }
    if (missed[0] > TB_C(0.0)) {
        status = tb_served_wrench_closest(structure, wrench, closest, closer);
        if (status > TB_INFEASIBLE) {
            return tb_refuse_served_wrench_scale(status, served, inner);
        }
        infeasible = infeasible || status == TB_INFEASIBLE;
    }
    status = tb_served_fraction(structure, wrench, feasible, fraction, missed, closest, served,
        inner);
    return status == TB_OK && infeasible ? TB_INFEASIBLE : status;
}

tb_status tb_distribute_tension_scale(const real_t structure[48], const real_t wrench[6],
    real_t tension[8], real_t delivered[6], real_t kkt_residual[1])
{
    tb_status status = tb_least_norm_tension(structure, wrench, tension, delivered,
        kkt_residual);
    if (status != TB_INACCURATE) {
        return status;
    }
    real_t served[6];
    real_t inner[6];
    tb_status verdict = tb_served_wrench_scale(structure, wrench, served, inner);
    if (status == TB_INACCURATE && verdict == TB_INFEASIBLE) {
        status = tb_least_norm_tension(structure, served, tension, delivered, kkt_residual);
    }
    if (status == TB_INACCURATE && verdict <= TB_INFEASIBLE) {
        verdict = TB_INFEASIBLE;
        status = tb_least_norm_tension(structure, inner, tension, delivered, kkt_residual);
    }
    return status == TB_OK ? verdict : status;
}

tb_status tb_distribute_tension_closest(const real_t structure[48], const real_t wrench[6],
    real_t tension[8], real_t delivered[6], real_t kkt_residual[1])
{
    tb_status status = tb_least_norm_tension(structure, wrench, tension, delivered,
        kkt_residual);
    if (status != TB_INACCURATE) {
        return status;
    }
    real_t served[6];
    real_t inner[6];
    tb_status verdict = tb_served_wrench_closest(structure, wrench, served, inner);
    if (status == TB_INACCURATE && verdict == TB_INFEASIBLE) {
        status = tb_least_norm_tension(structure, served, tension, delivered, kkt_residual);
    }
    if (status == TB_INACCURATE && verdict <= TB_INFEASIBLE) {
        verdict = TB_INFEASIBLE;
        status = tb_least_norm_tension(structure, inner, tension, delivered, kkt_residual);
    }
    return status == TB_OK ? verdict : status;
}

tb_status tb_distribute_tension(const real_t structure[48], const real_t wrench[6],
    real_t tension[8], real_t delivered[6], real_t kkt_residual[1])
{
    return tb_distribute_tension_closest(structure, wrench, tension, delivered, kkt_residual);
}

