/* Regenerate: turnbuckle generate machines/spidar_g.toml --out <this folder>
 * Machine 4d479a9b3a2bb17c, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_comparison.h"
#include "tb_machine.h"

/* Refuses with a status: pivot is 0; side is 0; moving is 0; push is 0 N. */
static tb_status tb_refuse_kernel_tension_begin(tb_status status, real_t pivot[1],
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
static tb_status tb_kernel_tension_begin(const real_t structure[48], const real_t wrench[6],
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
        return tb_refuse_kernel_tension_begin(TB_OUT_OF_DOMAIN, pivot, side, moving, push);
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
        return tb_refuse_kernel_tension_begin(TB_SINGULAR, pivot, side, moving, push);
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
static tb_status tb_kernel_tension_step(const real_t structure[48], const real_t wrench[6],
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
static tb_status tb_kernel_tension_finish(const real_t structure[48], const real_t wrench[6],
    const real_t pivot[1], const real_t side[8], real_t tension[8])
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
    const real_t t454 = tb_max(tb_max(tb_max(tb_max(t427, t428), t429), t431), t432);
    const real_t t455 = TB_C(128.0) * TB_EPSILON * tb_max(tb_max(tb_max(t454, t433), t435),
        t436);
    const real_t t456 = tb_min(t455 * (TB_C(1.0) / pivot[0]), TB_C(0.008));
    const bool t457 = tb_max(t451, TB_ABS(t453 - t319)) <= t456;
    const bool t458 = !t457;
    const real_t tension_0 = t457 ? t427 : TB_TENSION_MIN;
    const real_t tension_1 = t457 ? t428 : TB_TENSION_MIN;
    const real_t tension_2 = t457 ? t429 : TB_TENSION_MIN;
    const real_t tension_3 = t457 ? t431 : TB_TENSION_MIN;
    const real_t tension_4 = t457 ? t432 : TB_TENSION_MIN;
    const real_t tension_5 = t457 ? t433 : TB_TENSION_MIN;
    const real_t tension_6 = t457 ? t435 : TB_TENSION_MIN;
    const real_t tension_7 = t457 ? t436 : TB_TENSION_MIN;
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    tension[4] = tension_4;
    tension[5] = tension_5;
    tension[6] = tension_6;
    tension[7] = tension_7;
    return t458 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_kernel_tension(const real_t structure[48], const real_t wrench[6],
    real_t tension[8])
{
    real_t pivot[1];
    real_t side[8];
    real_t moving[1];
    real_t push[1];
    real_t done[1] = {TB_C(0.0)};
    tb_status status = tb_kernel_tension_begin(structure, wrench, pivot, side, moving, push);
    for (int steps = 0; steps < 40 && status == TB_OK && !(done[0] > TB_C(0.0)); steps++) {
        status = tb_kernel_tension_step(structure, wrench, side, moving, push, done);
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
        return status;
    }
    return tb_kernel_tension_finish(structure, wrench, pivot, side, tension);
}

/* Before the first subset. */
static tb_status tb_reduced_matrix_tension_begin(const real_t structure[48], const real_t wrench[6],
    real_t weighed[48], real_t rest[6], real_t least[1], real_t best[6], real_t cables[6])
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
        rest[0] = TB_C(0.0);
        rest[1] = TB_C(0.0);
        rest[2] = TB_C(0.0);
        rest[3] = TB_C(0.0);
        rest[4] = TB_C(0.0);
        rest[5] = TB_C(0.0);
        least[0] = TB_C(0.0);
        best[0] = TB_C(0.0);
        best[1] = TB_C(0.0);
        best[2] = TB_C(0.0);
        best[3] = TB_C(0.0);
        best[4] = TB_C(0.0);
        best[5] = TB_C(0.0);
        cables[0] = TB_C(0.0);
        cables[1] = TB_C(0.0);
        cables[2] = TB_C(0.0);
        cables[3] = TB_C(0.0);
        cables[4] = TB_C(0.0);
        cables[5] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
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
    const real_t t0 = structure[3] + (structure[2] + (structure[0] + structure[1]));
    const real_t t1 = structure[6] + (structure[5] + (structure[4] + t0));
    const real_t rest_0 = wrench[0] - TB_TENSION_MIN * (structure[7] + t1);
    const real_t t2 = structure[11] + (structure[10] + (structure[8] + structure[9]));
    const real_t t3 = structure[14] + (structure[13] + (structure[12] + t2));
    const real_t rest_1 = wrench[1] - TB_TENSION_MIN * (structure[15] + t3);
    const real_t t4 = structure[19] + (structure[18] + (structure[16] + structure[17]));
    const real_t t5 = structure[22] + (structure[21] + (structure[20] + t4));
    const real_t rest_2 = wrench[2] - TB_TENSION_MIN * (structure[23] + t5);
    const real_t t6 = structure[27] + (structure[26] + (structure[24] + structure[25]));
    const real_t t7 = structure[30] + (structure[29] + (structure[28] + t6));
    const real_t rest_3 = TB_MOMENT_WEIGHT * (wrench[3] - TB_TENSION_MIN * (structure[31] +
        t7));
    const real_t t8 = structure[35] + (structure[34] + (structure[32] + structure[33]));
    const real_t t9 = structure[38] + (structure[37] + (structure[36] + t8));
    const real_t rest_4 = TB_MOMENT_WEIGHT * (wrench[4] - TB_TENSION_MIN * (structure[39] +
        t9));
    const real_t t10 = structure[43] + (structure[42] + (structure[40] + structure[41]));
    const real_t t11 = structure[46] + (structure[45] + (structure[44] + t10));
    const real_t rest_5 = TB_MOMENT_WEIGHT * (wrench[5] - TB_TENSION_MIN * (structure[47] +
        t11));
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
    rest[0] = rest_0;
    rest[1] = rest_1;
    rest[2] = rest_2;
    rest[3] = rest_3;
    rest[4] = rest_4;
    rest[5] = rest_5;
    least[0] = TB_C(1e+30);
    best[0] = TB_C(0.0);
    best[1] = TB_C(0.0);
    best[2] = TB_C(0.0);
    best[3] = TB_C(0.0);
    best[4] = TB_C(0.0);
    best[5] = TB_C(0.0);
    cables[0] = -TB_C(1.0);
    cables[1] = -TB_C(1.0);
    cables[2] = -TB_C(1.0);
    cables[3] = -TB_C(1.0);
    cables[4] = -TB_C(1.0);
    cables[5] = -TB_C(1.0);
    return TB_OK;
}

/* One subset. */
static tb_status tb_reduced_matrix_tension_visit(const real_t chosen[36], const real_t numbers[6],
    const real_t rest[6], real_t least[1], real_t best[6], real_t cables[6])
{
    const real_t t0 = chosen[0] * chosen[0] + chosen[1] * chosen[1] + chosen[2] * chosen[2];
    const real_t t1 = t0 + chosen[3] * chosen[3] + chosen[4] * chosen[4];
    const real_t t2 = TB_SQRT(t1 + chosen[5] * chosen[5]);
    const real_t t3 = TB_COPYSIGN(t2, chosen[0]);
    const real_t t4 = rest[0] / t3;
    const real_t t5 = chosen[0] + t3;
    const real_t t6 = t5 * chosen[30] + chosen[1] * chosen[31] + chosen[2] * chosen[32];
    const real_t t7 = t6 + chosen[3] * chosen[33] + chosen[4] * chosen[34];
    const real_t t8 = TB_C(1.0) / (t2 * (t2 + TB_ABS(chosen[0])));
    const real_t t9 = (t7 + chosen[5] * chosen[35]) * t8;
    const real_t t10 = chosen[35] - chosen[5] * t9;
    const real_t t11 = t5 * chosen[6] + chosen[1] * chosen[7] + chosen[2] * chosen[8];
    const real_t t12 = t11 + chosen[3] * chosen[9] + chosen[4] * chosen[10];
    const real_t t13 = t8 * (t12 + chosen[5] * chosen[11]);
    const real_t t14 = chosen[7] - chosen[1] * t13;
    const real_t t15 = chosen[8] - chosen[2] * t13;
    const real_t t16 = chosen[9] - chosen[3] * t13;
    const real_t t17 = chosen[10] - chosen[4] * t13;
    const real_t t18 = chosen[11] - chosen[5] * t13;
    const real_t t19 = t14 * t14 + t15 * t15 + t16 * t16 + t17 * t17 + t18 * t18;
    const real_t t20 = TB_SQRT(t19);
    const real_t t21 = TB_COPYSIGN(t20, t14);
    const real_t t22 = t14 + t21;
    const real_t t23 = chosen[31] - chosen[1] * t9;
    const real_t t24 = chosen[32] - chosen[2] * t9;
    const real_t t25 = chosen[33] - chosen[3] * t9;
    const real_t t26 = chosen[34] - chosen[4] * t9;
    const real_t t27 = t22 * t23 + t15 * t24 + t16 * t25 + t17 * t26 + t10 * t18;
    const real_t t28 = TB_C(1.0) / (t20 * (t20 + TB_ABS(t14)));
    const real_t t29 = t27 * t28;
    const real_t t30 = t10 - t18 * t29;
    const real_t t31 = t5 * chosen[12] + chosen[1] * chosen[13] + chosen[2] * chosen[14];
    const real_t t32 = t31 + chosen[3] * chosen[15] + chosen[4] * chosen[16];
    const real_t t33 = t8 * (t32 + chosen[5] * chosen[17]);
    const real_t t34 = chosen[14] - chosen[2] * t33;
    const real_t t35 = chosen[13] - chosen[1] * t33;
    const real_t t36 = chosen[15] - chosen[3] * t33;
    const real_t t37 = chosen[16] - chosen[4] * t33;
    const real_t t38 = chosen[17] - chosen[5] * t33;
    const real_t t39 = t22 * t35 + t15 * t34 + t16 * t36 + t17 * t37 + t18 * t38;
    const real_t t40 = t28 * t39;
    const real_t t41 = t34 - t15 * t40;
    const real_t t42 = t36 - t16 * t40;
    const real_t t43 = t37 - t17 * t40;
    const real_t t44 = t38 - t18 * t40;
    const real_t t45 = TB_SQRT(t41 * t41 + t42 * t42 + t43 * t43 + t44 * t44);
    const real_t t46 = TB_COPYSIGN(t45, t41);
    const real_t t47 = t41 + t46;
    const real_t t48 = t24 - t15 * t29;
    const real_t t49 = t25 - t16 * t29;
    const real_t t50 = t26 - t17 * t29;
    const real_t t51 = TB_C(1.0) / (t45 * (t45 + TB_ABS(t41)));
    const real_t t52 = (t47 * t48 + t42 * t49 + t43 * t50 + t30 * t44) * t51;
    const real_t t53 = t30 - t44 * t52;
    const real_t t54 = t5 * chosen[18] + chosen[1] * chosen[19] + chosen[2] * chosen[20];
    const real_t t55 = t54 + chosen[3] * chosen[21] + chosen[4] * chosen[22];
    const real_t t56 = t8 * (t55 + chosen[5] * chosen[23]);
    const real_t t57 = chosen[21] - chosen[3] * t56;
    const real_t t58 = chosen[19] - chosen[1] * t56;
    const real_t t59 = chosen[20] - chosen[2] * t56;
    const real_t t60 = chosen[22] - chosen[4] * t56;
    const real_t t61 = chosen[23] - chosen[5] * t56;
    const real_t t62 = t22 * t58 + t15 * t59 + t16 * t57 + t17 * t60 + t18 * t61;
    const real_t t63 = t28 * t62;
    const real_t t64 = t57 - t16 * t63;
    const real_t t65 = t59 - t15 * t63;
    const real_t t66 = t60 - t17 * t63;
    const real_t t67 = t61 - t18 * t63;
    const real_t t68 = t51 * (t47 * t65 + t42 * t64 + t43 * t66 + t44 * t67);
    const real_t t69 = t64 - t42 * t68;
    const real_t t70 = t66 - t43 * t68;
    const real_t t71 = t67 - t44 * t68;
    const real_t t72 = TB_SQRT(t69 * t69 + t70 * t70 + t71 * t71);
    const real_t t73 = TB_COPYSIGN(t72, t69);
    const real_t t74 = t69 + t73;
    const real_t t75 = t49 - t42 * t52;
    const real_t t76 = t50 - t43 * t52;
    const real_t t77 = TB_C(1.0) / (t72 * (t72 + TB_ABS(t69)));
    const real_t t78 = (t74 * t75 + t70 * t76 + t53 * t71) * t77;
    const real_t t79 = t53 - t71 * t78;
    const real_t t80 = t5 * chosen[24] + chosen[1] * chosen[25] + chosen[2] * chosen[26];
    const real_t t81 = t80 + chosen[3] * chosen[27] + chosen[4] * chosen[28];
    const real_t t82 = t8 * (t81 + chosen[5] * chosen[29]);
    const real_t t83 = chosen[28] - chosen[4] * t82;
    const real_t t84 = chosen[25] - chosen[1] * t82;
    const real_t t85 = chosen[26] - chosen[2] * t82;
    const real_t t86 = chosen[27] - chosen[3] * t82;
    const real_t t87 = chosen[29] - chosen[5] * t82;
    const real_t t88 = t22 * t84 + t15 * t85 + t16 * t86 + t17 * t83 + t18 * t87;
    const real_t t89 = t28 * t88;
    const real_t t90 = t83 - t17 * t89;
    const real_t t91 = t85 - t15 * t89;
    const real_t t92 = t86 - t16 * t89;
    const real_t t93 = t87 - t18 * t89;
    const real_t t94 = t51 * (t47 * t91 + t42 * t92 + t43 * t90 + t44 * t93);
    const real_t t95 = t90 - t43 * t94;
    const real_t t96 = t92 - t42 * t94;
    const real_t t97 = t93 - t44 * t94;
    const real_t t98 = t77 * (t74 * t96 + t70 * t95 + t71 * t97);
    const real_t t99 = t95 - t70 * t98;
    const real_t t100 = t97 - t71 * t98;
    const real_t t101 = TB_SQRT(t99 * t99 + t100 * t100);
    const real_t t102 = TB_COPYSIGN(t101, t99);
    const real_t t103 = t99 + t102;
    const real_t t104 = t76 - t70 * t78;
    const real_t t105 = TB_C(1.0) / (t101 * (t101 + TB_ABS(t99)));
    const real_t t106 = (t103 * t104 + t79 * t100) * t105;
    const real_t t107 = t79 - t100 * t106;
    const real_t t108 = TB_ABS(t107);
    const real_t t109 = TB_COPYSIGN(t108, t107);
    const real_t t110 = t107 + t109;
    const real_t t111 = (rest[1] + t4 * (chosen[6] - t5 * t13)) / t21;
    const real_t t112 = rest[5] + t4 * (chosen[30] - t5 * t9) + (t23 - t22 * t29) * t111;
    const real_t t113 = rest[2] + t4 * (chosen[12] - t5 * t33) + t111 * (t35 - t22 * t40);
    const real_t t114 = t113 / t46;
    const real_t t115 = rest[3] + t4 * (chosen[18] - t5 * t56) + t111 * (t58 - t22 * t63);
    const real_t t116 = (t115 + t114 * (t65 - t47 * t68)) / t73;
    const real_t t117 = t112 + (t48 - t47 * t52) * t114 + (t75 - t74 * t78) * t116;
    const real_t t118 = rest[4] + t4 * (chosen[24] - t5 * t82) + t111 * (t84 - t22 * t89);
    const real_t t119 = t118 + t114 * (t91 - t47 * t94) + t116 * (t96 - t74 * t98);
    const real_t t120 = t119 / t102;
    const real_t t121 = (t117 + (t104 - t103 * t106) * t120) / t109;
    const real_t t122 = t110 * t121 * (TB_C(1.0) / (t108 * (t108 * TB_C(2.0))));
    const real_t t123 = t110 * t122 - t121;
    const real_t t124 = t105 * (t100 * t123 - t103 * t120);
    const real_t t125 = t123 - t100 * t124;
    const real_t t126 = t120 + t103 * t124;
    const real_t t127 = t77 * (t71 * t125 - (t74 * t116 + t70 * t126));
    const real_t t128 = t125 - t71 * t127;
    const real_t t129 = t116 + t74 * t127;
    const real_t t130 = t126 + t70 * t127;
    const real_t t131 = t44 * t128 - (t47 * t114 + t42 * t129 + t43 * t130);
    const real_t t132 = t51 * t131;
    const real_t t133 = t128 - t44 * t132;
    const real_t t134 = t114 + t47 * t132;
    const real_t t135 = t129 + t42 * t132;
    const real_t t136 = t130 + t43 * t132;
    const real_t t137 = t22 * t111 + t15 * t134 + t16 * t135 + t17 * t136;
    const real_t t138 = t28 * (t18 * t133 - t137);
    const real_t t139 = t133 - t18 * t138;
    const real_t t140 = t111 + t22 * t138;
    const real_t t141 = t134 + t15 * t138;
    const real_t t142 = t135 + t16 * t138;
    const real_t t143 = t4 * t5 + chosen[1] * t140 + chosen[2] * t141 + chosen[3] * t142;
    const real_t t144 = t136 + t17 * t138;
    const real_t t145 = t8 * (chosen[5] * t139 - (t143 + chosen[4] * t144));
    const real_t t146 = t4 + t5 * t145;
    const real_t t147 = -t146;
    const real_t t148 = t140 + chosen[1] * t145;
    const real_t t149 = -t148;
    const real_t t150 = t141 + chosen[2] * t145;
    const real_t t151 = -t150;
    const real_t t152 = t142 + chosen[3] * t145;
    const real_t t153 = -t152;
    const real_t t154 = t144 + chosen[4] * t145;
    const real_t t155 = -t154;
    const real_t t156 = tb_min(tb_min(tb_min(tb_min(t147, t149), t151), t153), t155);
    const real_t t157 = t139 - chosen[5] * t145;
    const real_t t158 = t157 - (t154 + (t152 + (t150 + (t146 + t148))));
    const real_t t159 = TB_C(16.0) * TB_EPSILON * (TB_ABS(t158) + TB_C(4.0));
    const real_t t160 = tb_min(tb_min(TB_ABS(t3), TB_ABS(t21)), TB_ABS(t46));
    const real_t t161 = tb_min(tb_min(tb_min(t160, TB_ABS(t73)), TB_ABS(t102)), TB_ABS(t109));
    const real_t t162 = t161 - tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t163 = TB_C(0.0) <= tb_min(tb_min(t156, t157) + t159, t162);
    const real_t t164 = t163 ? t158 : TB_C(1e+30);
    const bool t165 = t164 < least[0];
    const real_t least_0 = t165 ? t164 : least[0];
    const real_t best_0 = t165 ? t147 : best[0];
    const real_t best_1 = t165 ? t149 : best[1];
    const real_t best_2 = t165 ? t151 : best[2];
    const real_t best_3 = t165 ? t153 : best[3];
    const real_t best_4 = t165 ? t155 : best[4];
    const real_t best_5 = t165 ? t157 : best[5];
    const real_t cables_0 = t165 ? numbers[0] : cables[0];
    const real_t cables_1 = t165 ? numbers[1] : cables[1];
    const real_t cables_2 = t165 ? numbers[2] : cables[2];
    const real_t cables_3 = t165 ? numbers[3] : cables[3];
    const real_t cables_4 = t165 ? numbers[4] : cables[4];
    const real_t cables_5 = t165 ? numbers[5] : cables[5];
    least[0] = least_0;
    best[0] = best_0;
    best[1] = best_1;
    best[2] = best_2;
    best[3] = best_3;
    best[4] = best_4;
    best[5] = best_5;
    cables[0] = cables_0;
    cables[1] = cables_1;
    cables[2] = cables_2;
    cables[3] = cables_3;
    cables[4] = cables_4;
    cables[5] = cables_5;
    return TB_OK;
}

/* After the last subset. */
static tb_status tb_reduced_matrix_tension_finish(const real_t least[1], const real_t best[6],
    const real_t cables[6], real_t tension[8])
{
    const real_t t0 = tb_max(best[0], TB_C(0.0));
    const real_t t1 = tb_max(best[1], TB_C(0.0));
    const real_t t2 = (cables[0] == TB_C(0.0) ? t0 : TB_C(0.0)) + (TB_C(0.0) == cables[1] ? t1
        : TB_C(0.0));
    const real_t t3 = tb_max(best[2], TB_C(0.0));
    const real_t t4 = tb_max(best[3], TB_C(0.0));
    const real_t t5 = t2 + (TB_C(0.0) == cables[2] ? t3 : TB_C(0.0)) + (TB_C(0.0) == cables[3]
        ? t4 : TB_C(0.0));
    const real_t t6 = tb_max(best[4], TB_C(0.0));
    const real_t t7 = tb_max(best[5], TB_C(0.0));
    const real_t t8 = t5 + (TB_C(0.0) == cables[4] ? t6 : TB_C(0.0)) + (TB_C(0.0) == cables[5]
        ? t7 : TB_C(0.0));
    const real_t tension_0 = TB_TENSION_MIN + t8;
    const real_t t9 = (cables[0] == TB_C(1.0) ? t0 : TB_C(0.0)) + (cables[1] == TB_C(1.0) ? t1
        : TB_C(0.0));
    const real_t t10 = t9 + (cables[2] == TB_C(1.0) ? t3 : TB_C(0.0)) + (cables[3] == TB_C(1.0)
        ? t4 : TB_C(0.0));
    const real_t t11 = t10 + (cables[4] == TB_C(1.0) ? t6 : TB_C(0.0)) + (cables[5] ==
        TB_C(1.0) ? t7 : TB_C(0.0));
    const real_t tension_1 = TB_TENSION_MIN + t11;
    const real_t t12 = (cables[0] == TB_C(2.0) ? t0 : TB_C(0.0)) + (cables[1] == TB_C(2.0) ? t1
        : TB_C(0.0));
    const real_t t13 = t12 + (cables[2] == TB_C(2.0) ? t3 : TB_C(0.0)) + (cables[3] ==
        TB_C(2.0) ? t4 : TB_C(0.0));
    const real_t t14 = t13 + (cables[4] == TB_C(2.0) ? t6 : TB_C(0.0)) + (cables[5] ==
        TB_C(2.0) ? t7 : TB_C(0.0));
    const real_t tension_2 = TB_TENSION_MIN + t14;
    const real_t t15 = (cables[0] == TB_C(3.0) ? t0 : TB_C(0.0)) + (cables[1] == TB_C(3.0) ? t1
        : TB_C(0.0));
    const real_t t16 = t15 + (cables[2] == TB_C(3.0) ? t3 : TB_C(0.0)) + (cables[3] ==
        TB_C(3.0) ? t4 : TB_C(0.0));
    const real_t t17 = t16 + (cables[4] == TB_C(3.0) ? t6 : TB_C(0.0)) + (cables[5] ==
        TB_C(3.0) ? t7 : TB_C(0.0));
    const real_t tension_3 = TB_TENSION_MIN + t17;
    const real_t t18 = (cables[0] == TB_C(4.0) ? t0 : TB_C(0.0)) + (cables[1] == TB_C(4.0) ? t1
        : TB_C(0.0));
    const real_t t19 = t18 + (cables[2] == TB_C(4.0) ? t3 : TB_C(0.0)) + (cables[3] ==
        TB_C(4.0) ? t4 : TB_C(0.0));
    const real_t t20 = t19 + (cables[4] == TB_C(4.0) ? t6 : TB_C(0.0)) + (cables[5] ==
        TB_C(4.0) ? t7 : TB_C(0.0));
    const real_t tension_4 = TB_TENSION_MIN + t20;
    const real_t t21 = (cables[0] == TB_C(5.0) ? t0 : TB_C(0.0)) + (cables[1] == TB_C(5.0) ? t1
        : TB_C(0.0));
    const real_t t22 = t21 + (cables[2] == TB_C(5.0) ? t3 : TB_C(0.0)) + (cables[3] ==
        TB_C(5.0) ? t4 : TB_C(0.0));
    const real_t t23 = t22 + (cables[4] == TB_C(5.0) ? t6 : TB_C(0.0)) + (cables[5] ==
        TB_C(5.0) ? t7 : TB_C(0.0));
    const real_t tension_5 = TB_TENSION_MIN + t23;
    const real_t t24 = (cables[0] == TB_C(6.0) ? t0 : TB_C(0.0)) + (cables[1] == TB_C(6.0) ? t1
        : TB_C(0.0));
    const real_t t25 = t24 + (cables[2] == TB_C(6.0) ? t3 : TB_C(0.0)) + (cables[3] ==
        TB_C(6.0) ? t4 : TB_C(0.0));
    const real_t t26 = t25 + (cables[4] == TB_C(6.0) ? t6 : TB_C(0.0)) + (cables[5] ==
        TB_C(6.0) ? t7 : TB_C(0.0));
    const real_t tension_6 = TB_TENSION_MIN + t26;
    const real_t t27 = (cables[0] == TB_C(7.0) ? t0 : TB_C(0.0)) + (cables[1] == TB_C(7.0) ? t1
        : TB_C(0.0));
    const real_t t28 = t27 + (cables[2] == TB_C(7.0) ? t3 : TB_C(0.0)) + (cables[3] ==
        TB_C(7.0) ? t4 : TB_C(0.0));
    const real_t t29 = t28 + (cables[4] == TB_C(7.0) ? t6 : TB_C(0.0)) + (cables[5] ==
        TB_C(7.0) ? t7 : TB_C(0.0));
    const real_t tension_7 = TB_TENSION_MIN + t29;
    const bool t30 = !(least[0] < TB_C(1e+30));
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    tension[4] = tension_4;
    tension[5] = tension_5;
    tension[6] = tension_6;
    tension[7] = tension_7;
    return t30 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_reduced_matrix_tension(const real_t structure[48], const real_t wrench[6],
    real_t tension[8])
{
    static const unsigned char subsets[28][6] = {{0,1,2,3,4,5}, {0,1,2,3,4,6}, {0,1,2,3,4,7},
        {0,1,2,3,5,6}, {0,1,2,3,5,7}, {0,1,2,3,6,7}, {0,1,2,4,5,6}, {0,1,2,4,5,7},
        {0,1,2,4,6,7}, {0,1,2,5,6,7}, {0,1,3,4,5,6}, {0,1,3,4,5,7}, {0,1,3,4,6,7},
        {0,1,3,5,6,7}, {0,1,4,5,6,7}, {0,2,3,4,5,6}, {0,2,3,4,5,7}, {0,2,3,4,6,7},
        {0,2,3,5,6,7}, {0,2,4,5,6,7}, {0,3,4,5,6,7}, {1,2,3,4,5,6}, {1,2,3,4,5,7},
        {1,2,3,4,6,7}, {1,2,3,5,6,7}, {1,2,4,5,6,7}, {1,3,4,5,6,7}, {2,3,4,5,6,7}};
    real_t weighed[48];
    real_t rest[6];
    real_t least[1];
    real_t best[6];
    real_t cables[6];
    const tb_status status = tb_reduced_matrix_tension_begin(structure, wrench, weighed, rest,
        least, best, cables);
    if (status != TB_OK) {
        tension[0] = TB_TENSION_MIN;
        tension[1] = TB_TENSION_MIN;
        tension[2] = TB_TENSION_MIN;
        tension[3] = TB_TENSION_MIN;
        tension[4] = TB_TENSION_MIN;
        tension[5] = TB_TENSION_MIN;
        tension[6] = TB_TENSION_MIN;
        tension[7] = TB_TENSION_MIN;
        return status;
    }
    for (int k = 0; k < 28; k++) {
        real_t chosen[36];
        real_t numbers[6];
        for (int j = 0; j < 6; j++) {
            const int number = subsets[k][j];
            for (int i = 0; i < 6; i++) {
                chosen[6 * i + j] = weighed[8 * i + number];
            }
            numbers[j] = (real_t)number;
        }
        (void)tb_reduced_matrix_tension_visit(chosen, numbers, rest, least, best, cables);
    }
    return tb_reduced_matrix_tension_finish(least, best, cables, tension);
}

/* Refuses with a status: weighed is 0; most is 0; least is 0; size is 0 N. */
static tb_status tb_refuse_largest_tensions_eq12_begin(tb_status status, real_t weighed[48],
    real_t most[8], real_t least[1], real_t size[1])
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
    most[0] = TB_C(0.0);
    most[1] = TB_C(0.0);
    most[2] = TB_C(0.0);
    most[3] = TB_C(0.0);
    most[4] = TB_C(0.0);
    most[5] = TB_C(0.0);
    most[6] = TB_C(0.0);
    most[7] = TB_C(0.0);
    least[0] = TB_C(0.0);
    size[0] = TB_C(0.0);
    return status;
}

/* Before the first subset. */
static tb_status tb_largest_tensions_eq12_begin(const real_t structure[48], const real_t force[1],
    real_t weighed[48], real_t most[8], real_t least[1], real_t size[1])
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
          && force[0] >= TB_C(0.0) && force[0] <= TB_C(8000.0))) {
        return tb_refuse_largest_tensions_eq12_begin(TB_OUT_OF_DOMAIN, weighed, most, least, size);
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
        return tb_refuse_largest_tensions_eq12_begin(TB_SINGULAR, weighed, most, least, size);
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
    most[0] = TB_C(0.0);
    most[1] = TB_C(0.0);
    most[2] = TB_C(0.0);
    most[3] = TB_C(0.0);
    most[4] = TB_C(0.0);
    most[5] = TB_C(0.0);
    most[6] = TB_C(0.0);
    most[7] = TB_C(0.0);
    least[0] = TB_C(1e+30);
    size[0] = force[0];
    return TB_OK;
}

/* One subset. */
static tb_status tb_largest_tensions_eq12_visit(const real_t chosen[30], const real_t numbers[5],
    const real_t weighed[48], real_t most[8], real_t least[1])
{
    const real_t t0 = chosen[0] * chosen[0] + chosen[5] * chosen[5] + chosen[10] * chosen[10];
    const real_t t1 = t0 + chosen[15] * chosen[15] + chosen[20] * chosen[20];
    const real_t t2 = TB_SQRT(t1 + chosen[25] * chosen[25]);
    const real_t t3 = TB_COPYSIGN(t2, chosen[0]);
    const real_t t4 = chosen[0] + t3;
    const real_t t5 = t4 * chosen[4] + chosen[5] * chosen[9] + chosen[10] * chosen[14];
    const real_t t6 = t5 + chosen[15] * chosen[19] + chosen[20] * chosen[24];
    const real_t t7 = TB_C(1.0) / (t2 * (t2 + TB_ABS(chosen[0])));
    const real_t t8 = (t6 + chosen[25] * chosen[29]) * t7;
    const real_t t9 = chosen[29] - chosen[25] * t8;
    const real_t t10 = t4 * chosen[1] + chosen[5] * chosen[6] + chosen[10] * chosen[11];
    const real_t t11 = t10 + chosen[15] * chosen[16] + chosen[20] * chosen[21];
    const real_t t12 = t7 * (t11 + chosen[25] * chosen[26]);
    const real_t t13 = chosen[6] - chosen[5] * t12;
    const real_t t14 = chosen[11] - chosen[10] * t12;
    const real_t t15 = chosen[16] - chosen[15] * t12;
    const real_t t16 = chosen[21] - chosen[20] * t12;
    const real_t t17 = chosen[26] - chosen[25] * t12;
    const real_t t18 = t13 * t13 + t14 * t14 + t15 * t15 + t16 * t16 + t17 * t17;
    const real_t t19 = TB_SQRT(t18);
    const real_t t20 = TB_COPYSIGN(t19, t13);
    const real_t t21 = t13 + t20;
    const real_t t22 = chosen[14] - chosen[10] * t8;
    const real_t t23 = chosen[19] - chosen[15] * t8;
    const real_t t24 = t21 * (chosen[9] - chosen[5] * t8) + t14 * t22 + t15 * t23;
    const real_t t25 = chosen[24] - chosen[20] * t8;
    const real_t t26 = TB_C(1.0) / (t19 * (t19 + TB_ABS(t13)));
    const real_t t27 = (t24 + t16 * t25 + t9 * t17) * t26;
    const real_t t28 = t9 - t17 * t27;
    const real_t t29 = t4 * chosen[2] + chosen[5] * chosen[7] + chosen[10] * chosen[12];
    const real_t t30 = t29 + chosen[15] * chosen[17] + chosen[20] * chosen[22];
    const real_t t31 = t7 * (t30 + chosen[25] * chosen[27]);
    const real_t t32 = chosen[12] - chosen[10] * t31;
    const real_t t33 = chosen[17] - chosen[15] * t31;
    const real_t t34 = t21 * (chosen[7] - chosen[5] * t31) + t14 * t32 + t15 * t33;
    const real_t t35 = chosen[22] - chosen[20] * t31;
    const real_t t36 = chosen[27] - chosen[25] * t31;
    const real_t t37 = t26 * (t34 + t16 * t35 + t17 * t36);
    const real_t t38 = t32 - t14 * t37;
    const real_t t39 = t33 - t15 * t37;
    const real_t t40 = t35 - t16 * t37;
    const real_t t41 = t36 - t17 * t37;
    const real_t t42 = TB_SQRT(t38 * t38 + t39 * t39 + t40 * t40 + t41 * t41);
    const real_t t43 = TB_COPYSIGN(t42, t38);
    const real_t t44 = t38 + t43;
    const real_t t45 = t23 - t15 * t27;
    const real_t t46 = t25 - t16 * t27;
    const real_t t47 = t44 * (t22 - t14 * t27) + t39 * t45 + t40 * t46 + t28 * t41;
    const real_t t48 = TB_C(1.0) / (t42 * (t42 + TB_ABS(t38)));
    const real_t t49 = t47 * t48;
    const real_t t50 = t28 - t41 * t49;
    const real_t t51 = t4 * chosen[3] + chosen[5] * chosen[8] + chosen[10] * chosen[13];
    const real_t t52 = t51 + chosen[15] * chosen[18] + chosen[20] * chosen[23];
    const real_t t53 = t7 * (t52 + chosen[25] * chosen[28]);
    const real_t t54 = chosen[18] - chosen[15] * t53;
    const real_t t55 = chosen[13] - chosen[10] * t53;
    const real_t t56 = t21 * (chosen[8] - chosen[5] * t53) + t14 * t55 + t15 * t54;
    const real_t t57 = chosen[23] - chosen[20] * t53;
    const real_t t58 = chosen[28] - chosen[25] * t53;
    const real_t t59 = t26 * (t56 + t16 * t57 + t17 * t58);
    const real_t t60 = t54 - t15 * t59;
    const real_t t61 = t57 - t16 * t59;
    const real_t t62 = t58 - t17 * t59;
    const real_t t63 = t44 * (t55 - t14 * t59) + t39 * t60 + t40 * t61 + t41 * t62;
    const real_t t64 = t48 * t63;
    const real_t t65 = t60 - t39 * t64;
    const real_t t66 = t61 - t40 * t64;
    const real_t t67 = t62 - t41 * t64;
    const real_t t68 = TB_SQRT(t65 * t65 + t66 * t66 + t67 * t67);
    const real_t t69 = TB_COPYSIGN(t68, t65);
    const real_t t70 = t65 + t69;
    const real_t t71 = t46 - t40 * t49;
    const real_t t72 = TB_C(1.0) / (t68 * (t68 + TB_ABS(t65)));
    const real_t t73 = (t70 * (t45 - t39 * t49) + t66 * t71 + t50 * t67) * t72;
    const real_t t74 = t50 - t67 * t73;
    const real_t t75 = t71 - t66 * t73;
    const real_t t76 = TB_SQRT(t75 * t75 + t74 * t74);
    const real_t t77 = t74 / (t76 * (t76 + TB_ABS(t75)));
    const real_t t78 = TB_C(1.0) - t74 * t77;
    const real_t t79 = TB_COPYSIGN(t76, t75);
    const real_t t80 = t77 * (t75 + t79);
    const real_t t81 = t72 * (t67 * t78 - t66 * t80);
    const real_t t82 = t78 - t67 * t81;
    const real_t t83 = t70 * t81;
    const real_t t84 = t80 + t66 * t81;
    const real_t t85 = t48 * (t41 * t82 - (t39 * t83 + t40 * t84));
    const real_t t86 = t82 - t41 * t85;
    const real_t t87 = t44 * t85;
    const real_t t88 = t83 + t39 * t85;
    const real_t t89 = t84 + t40 * t85;
    const real_t t90 = t26 * (t17 * t86 - (t14 * t87 + t15 * t88 + t16 * t89));
    const real_t t91 = t86 - t17 * t90;
    const real_t t92 = t21 * t90;
    const real_t t93 = t87 + t14 * t90;
    const real_t t94 = t88 + t15 * t90;
    const real_t t95 = chosen[5] * t92 + chosen[10] * t93 + chosen[15] * t94;
    const real_t t96 = t89 + t16 * t90;
    const real_t t97 = t7 * (chosen[25] * t91 - (t95 + chosen[20] * t96));
    const real_t t98 = t4 * t97;
    const real_t t99 = t92 + chosen[5] * t97;
    const real_t t100 = t93 + chosen[10] * t97;
    const real_t t101 = TB_SQRT(t98 * t98 + t99 * t99 + t100 * t100);
    const bool t102 = (numbers[0] == TB_C(0.0)) || (TB_C(0.0) == numbers[1]);
    const bool t103 = t102 || (TB_C(0.0) == numbers[2]) || (TB_C(0.0) == numbers[3]);
    const bool t104 = t103 || (TB_C(0.0) == numbers[4]);
    const real_t t105 = t91 - chosen[25] * t97;
    const real_t t106 = t94 + chosen[15] * t97;
    const real_t t107 = t96 + chosen[20] * t97;
    real_t t108, t109;
    if (t104) {
        t108 = TB_C(0.0);
        t109 = TB_C(1e+30);
    } else {
        const real_t t110 = t98 * weighed[0] + t99 * weighed[8] + t100 * weighed[16];
        const real_t t111 = t105 * weighed[40] - (t110 + t106 * weighed[24] + t107 *
            weighed[32]);
        t108 = t111;
        t109 = TB_ABS(t108);
    }
    const real_t most_0 = tb_max(most[0], t101 / t109);
    const bool t112 = (TB_C(1.0) == numbers[0]) || (TB_C(1.0) == numbers[1]);
    const bool t113 = t112 || (TB_C(1.0) == numbers[2]) || (TB_C(1.0) == numbers[3]);
    const bool t114 = t113 || (TB_C(1.0) == numbers[4]);
    real_t t115, t116;
    if (t114) {
        t115 = TB_C(0.0);
        t116 = TB_C(1e+30);
    } else {
        const real_t t117 = t98 * weighed[1] + t99 * weighed[9] + t100 * weighed[17];
        const real_t t118 = t105 * weighed[41] - (t117 + t106 * weighed[25] + t107 *
            weighed[33]);
        t115 = t118;
        t116 = TB_ABS(t115);
    }
    const real_t most_1 = tb_max(most[1], t101 / t116);
    const bool t119 = (numbers[0] == TB_C(2.0)) || (numbers[1] == TB_C(2.0));
    const bool t120 = t119 || (numbers[2] == TB_C(2.0)) || (numbers[3] == TB_C(2.0));
    const bool t121 = t120 || (numbers[4] == TB_C(2.0));
    real_t t122, t123;
    if (t121) {
        t122 = TB_C(0.0);
        t123 = TB_C(1e+30);
    } else {
        const real_t t124 = t98 * weighed[2] + t99 * weighed[10] + t100 * weighed[18];
        const real_t t125 = t105 * weighed[42] - (t124 + t106 * weighed[26] + t107 *
            weighed[34]);
        t122 = t125;
        t123 = TB_ABS(t122);
    }
    const real_t most_2 = tb_max(most[2], t101 / t123);
    const bool t126 = (numbers[0] == TB_C(3.0)) || (numbers[1] == TB_C(3.0));
    const bool t127 = t126 || (numbers[2] == TB_C(3.0)) || (numbers[3] == TB_C(3.0));
    const bool t128 = t127 || (numbers[4] == TB_C(3.0));
    real_t t129, t130;
    if (t128) {
        t129 = TB_C(0.0);
        t130 = TB_C(1e+30);
    } else {
        const real_t t131 = t98 * weighed[3] + t99 * weighed[11] + t100 * weighed[19];
        const real_t t132 = t105 * weighed[43] - (t131 + t106 * weighed[27] + t107 *
            weighed[35]);
        t129 = t132;
        t130 = TB_ABS(t129);
    }
    const real_t most_3 = tb_max(most[3], t101 / t130);
    const bool t133 = (numbers[0] == TB_C(4.0)) || (numbers[1] == TB_C(4.0));
    const bool t134 = t133 || (numbers[2] == TB_C(4.0)) || (numbers[3] == TB_C(4.0));
    const bool t135 = t134 || (numbers[4] == TB_C(4.0));
    real_t t136, t137;
    if (t135) {
        t136 = TB_C(0.0);
        t137 = TB_C(1e+30);
    } else {
        const real_t t138 = t98 * weighed[4] + t99 * weighed[12] + t100 * weighed[20];
        const real_t t139 = t105 * weighed[44] - (t138 + t106 * weighed[28] + t107 *
            weighed[36]);
        t136 = t139;
        t137 = TB_ABS(t136);
    }
    const real_t most_4 = tb_max(most[4], t101 / t137);
    const bool t140 = (numbers[0] == TB_C(5.0)) || (numbers[1] == TB_C(5.0));
    const bool t141 = t140 || (numbers[2] == TB_C(5.0)) || (numbers[3] == TB_C(5.0));
    const bool t142 = t141 || (numbers[4] == TB_C(5.0));
    real_t t143, t144;
    if (t142) {
        t143 = TB_C(0.0);
        t144 = TB_C(1e+30);
    } else {
        const real_t t145 = t98 * weighed[5] + t99 * weighed[13] + t100 * weighed[21];
        const real_t t146 = t105 * weighed[45] - (t145 + t106 * weighed[29] + t107 *
            weighed[37]);
        t143 = t146;
        t144 = TB_ABS(t143);
    }
    const real_t most_5 = tb_max(most[5], t101 / t144);
    const bool t147 = (numbers[0] == TB_C(6.0)) || (numbers[1] == TB_C(6.0));
    const bool t148 = t147 || (numbers[2] == TB_C(6.0)) || (numbers[3] == TB_C(6.0));
    const bool t149 = t148 || (numbers[4] == TB_C(6.0));
    real_t t150, t151;
    if (t149) {
        t150 = TB_C(0.0);
        t151 = TB_C(1e+30);
    } else {
        const real_t t152 = t98 * weighed[6] + t99 * weighed[14] + t100 * weighed[22];
        const real_t t153 = t105 * weighed[46] - (t152 + t106 * weighed[30] + t107 *
            weighed[38]);
        t150 = t153;
        t151 = TB_ABS(t150);
    }
    const real_t most_6 = tb_max(most[6], t101 / t151);
    const bool t154 = (numbers[0] == TB_C(7.0)) || (numbers[1] == TB_C(7.0));
    const bool t155 = t154 || (numbers[2] == TB_C(7.0)) || (numbers[3] == TB_C(7.0));
    const bool t156 = t155 || (numbers[4] == TB_C(7.0));
    real_t t157, t158;
    if (t156) {
        t157 = TB_C(0.0);
        t158 = TB_C(1e+30);
    } else {
        const real_t t159 = t98 * weighed[7] + t99 * weighed[15] + t100 * weighed[23];
        const real_t t160 = t105 * weighed[47] - (t159 + t106 * weighed[31] + t107 *
            weighed[39]);
        t157 = t160;
        t158 = TB_ABS(t157);
    }
    const real_t most_7 = tb_max(most[7], t101 / t158);
    const real_t t161 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const bool t162 = t161 < TB_ABS(t3) && t161 < TB_ABS(t20) && t161 < TB_ABS(t43);
    real_t t163;
    if (t162 && t161 < TB_ABS(t69) && t161 < TB_ABS(t79)) {
        const real_t t164 = tb_min(tb_min(tb_min(tb_min(t109, t116), t123), t130), t137);
        t163 = tb_min(tb_min(tb_min(t164, t144), t151), t158);
    } else {
        t163 = TB_C(0.0);
    }
    const real_t least_0 = tb_min(least[0], t163);
    most[0] = most_0;
    most[1] = most_1;
    most[2] = most_2;
    most[3] = most_3;
    most[4] = most_4;
    most[5] = most_5;
    most[6] = most_6;
    most[7] = most_7;
    least[0] = least_0;
    return TB_OK;
}

/* After the last subset. */
static tb_status tb_largest_tensions_eq12_finish(const real_t most[8], const real_t least[1],
    const real_t size[1], real_t tension[8])
{
    const real_t tension_0 = size[0] * most[0];
    const real_t tension_1 = size[0] * most[1];
    const real_t tension_2 = size[0] * most[2];
    const real_t tension_3 = size[0] * most[3];
    const real_t tension_4 = size[0] * most[4];
    const real_t tension_5 = size[0] * most[5];
    const real_t tension_6 = size[0] * most[6];
    const real_t tension_7 = size[0] * most[7];
    const bool t0 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON) < least[0];
    const bool t1 = !t0;
    if (t1) {
        tension[0] = TB_C(0.0);
        tension[1] = TB_C(0.0);
        tension[2] = TB_C(0.0);
        tension[3] = TB_C(0.0);
        tension[4] = TB_C(0.0);
        tension[5] = TB_C(0.0);
        tension[6] = TB_C(0.0);
        tension[7] = TB_C(0.0);
        return TB_SINGULAR;
    }
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    tension[4] = tension_4;
    tension[5] = tension_5;
    tension[6] = tension_6;
    tension[7] = tension_7;
    return TB_OK;
}

tb_status tb_largest_tensions_eq12(const real_t structure[48], const real_t force[1],
    real_t tension[8])
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
    real_t most[8];
    real_t least[1];
    real_t size[1];
    const tb_status status = tb_largest_tensions_eq12_begin(structure, force, weighed, most,
        least, size);
    if (status != TB_OK) {
        tension[0] = TB_C(0.0);
        tension[1] = TB_C(0.0);
        tension[2] = TB_C(0.0);
        tension[3] = TB_C(0.0);
        tension[4] = TB_C(0.0);
        tension[5] = TB_C(0.0);
        tension[6] = TB_C(0.0);
        tension[7] = TB_C(0.0);
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
        (void)tb_largest_tensions_eq12_visit(chosen, numbers, weighed, most, least);
    }
    return tb_largest_tensions_eq12_finish(most, least, size, tension);
}

/* Refuses with a status: weighed is 0; most is 0 N; size is 0 N. */
static tb_status tb_refuse_largest_tension_begin(tb_status status, real_t weighed[48],
    real_t most[1], real_t size[1])
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
    most[0] = TB_C(0.0);
    size[0] = TB_C(0.0);
    return status;
}

/* Before the first subset. */
static tb_status tb_largest_tension_begin(const real_t structure[48], const real_t force[1],
    real_t weighed[48], real_t most[1], real_t size[1])
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
          && force[0] >= TB_C(0.0) && force[0] <= TB_C(8000.0))) {
        return tb_refuse_largest_tension_begin(TB_OUT_OF_DOMAIN, weighed, most, size);
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
        return tb_refuse_largest_tension_begin(TB_SINGULAR, weighed, most, size);
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
    most[0] = TB_TENSION_MIN;
    size[0] = force[0];
    return TB_OK;
}

/* One subset. */
static tb_status tb_largest_tension_visit(const real_t chosen[30], const real_t numbers[5],
    const real_t weighed[48], real_t most[1], const real_t size[1])
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
    real_t most_0;
    if (t35 && t0 < TB_ABS(t56) && t0 < TB_ABS(t79)) {
        const real_t t80 = TB_EPSILON * TB_C(64.0);
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
        const real_t t149 = t143 + TB_ABS(t146);
        const real_t t150 = t140 + (t135 + (t130 + (t124 + (t119 + (t109 + t114)))));
        const real_t t151 = t146 + t150;
        const real_t t152 = (t149 + t151) * TB_C(0.5);
        const real_t t153 = size[0] * TB_SQRT(t104 * t104 + t105 * t105 + t106 * t106);
        const real_t t154 = TB_C(0.5) * (t149 - t151);
        const real_t t155 = t153 + TB_TENSION_MIN * t154;
        real_t t156;
        if (t80 < t152) {
            t156 = t155 / t152;
        } else {
            t156 = t80 < t155 ? TB_C(1e+30) : TB_C(0.0);
        }
        const real_t t157 = t153 + TB_TENSION_MIN * t152;
        real_t t158;
        if (t80 < t154) {
            t158 = t157 / t154;
        } else {
            t158 = t80 < t157 ? TB_C(1e+30) : TB_C(0.0);
        }
        most_0 = tb_max(most[0], tb_max(t156, t158));
    } else {
        most_0 = most[0];
    }
    most[0] = most_0;
    return TB_OK;
}

/* After the last subset. */
static tb_status tb_largest_tension_finish(const real_t most[1], real_t tension[1])
{
    const bool t0 = most[0] < TB_C(1e+30);
    const real_t tension_0 = t0 ? most[0] : TB_C(0.0);
    const bool t1 = !t0;
    tension[0] = tension_0;
    return t1 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_largest_tension(const real_t structure[48], const real_t force[1],
    real_t tension[1])
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
    real_t most[1];
    real_t size[1];
    const tb_status status = tb_largest_tension_begin(structure, force, weighed, most, size);
    if (status != TB_OK) {
        tension[0] = TB_C(0.0);
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
        (void)tb_largest_tension_visit(chosen, numbers, weighed, most, size);
    }
    return tb_largest_tension_finish(most, tension);
}

