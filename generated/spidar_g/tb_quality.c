/* Regenerate: turnbuckle generate machines/spidar_g.toml --out <this folder>
 * Machine 4d479a9b3a2bb17c, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_quality.h"
#include "tb_kinematics.h"
#include "tb_tension.h"
#include "tb_machine.h"

/* Before the first subset. */
static tb_status tb_balance_begin(const real_t structure[48], real_t weighed[48], real_t margin[1])
{
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
        margin[0] = TB_C(0.0);
        return TB_SINGULAR;
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
    margin[0] = TB_C(1e+30);
    return TB_OK;
}

/* One subset. */
static tb_status tb_balance_visit(const real_t chosen[30], const real_t numbers[5],
    const real_t weighed[48], real_t margin[1])
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
    real_t margin_0;
    if (t35 && t0 < TB_ABS(t56) && t0 < TB_ABS(t79)) {
        const bool t80 = (numbers[0] == TB_C(0.0)) || (TB_C(0.0) == numbers[1]);
        const bool t81 = t80 || (TB_C(0.0) == numbers[2]) || (TB_C(0.0) == numbers[3]);
        const real_t t82 = t77 / (t78 * (t78 + TB_ABS(t76)));
        const real_t t83 = TB_C(1.0) - t77 * t82;
        const real_t t84 = t82 * (t76 + t79);
        const real_t t85 = t74 * (t54 * t83 - t53 * t84);
        const real_t t86 = t83 - t54 * t85;
        const real_t t87 = t72 * t85;
        const real_t t88 = t84 + t53 * t85;
        const real_t t89 = t50 * (t32 * t86 - (t30 * t87 + t31 * t88));
        const real_t t90 = t86 - t32 * t89;
        const real_t t91 = t46 * t89;
        const real_t t92 = t87 + t30 * t89;
        const real_t t93 = t88 + t31 * t89;
        const real_t t94 = t27 * (t14 * t90 - (t11 * t91 + t12 * t92 + t13 * t93));
        const real_t t95 = t90 - t14 * t94;
        const real_t t96 = t22 * t94;
        const real_t t97 = t91 + t11 * t94;
        const real_t t98 = t92 + t12 * t94;
        const real_t t99 = chosen[5] * t96 + chosen[10] * t97 + chosen[15] * t98;
        const real_t t100 = t93 + t13 * t94;
        const real_t t101 = t8 * (chosen[25] * t95 - (t99 + chosen[20] * t100));
        const real_t t102 = t95 - chosen[25] * t101;
        const real_t t103 = t5 * t101;
        const real_t t104 = t96 + chosen[5] * t101;
        const real_t t105 = t97 + chosen[10] * t101;
        const real_t t106 = t98 + chosen[15] * t101;
        const real_t t107 = t100 + chosen[20] * t101;
        real_t t108;
        if (t81 || (TB_C(0.0) == numbers[4])) {
            t108 = TB_C(0.0);
        } else {
            const real_t t109 = t103 * weighed[0] + t104 * weighed[8] + t105 * weighed[16];
            const real_t t110 = t102 * weighed[40] - (t109 + t106 * weighed[24] + t107 *
                weighed[32]);
            t108 = t110;
        }
        const bool t111 = (TB_C(1.0) == numbers[0]) || (TB_C(1.0) == numbers[1]);
        const bool t112 = t111 || (TB_C(1.0) == numbers[2]) || (TB_C(1.0) == numbers[3]);
        real_t t113;
        if (t112 || (TB_C(1.0) == numbers[4])) {
            t113 = TB_C(0.0);
        } else {
            const real_t t114 = t103 * weighed[1] + t104 * weighed[9] + t105 * weighed[17];
            const real_t t115 = t102 * weighed[41] - (t114 + t106 * weighed[25] + t107 *
                weighed[33]);
            t113 = t115;
        }
        const bool t116 = (numbers[0] == TB_C(2.0)) || (numbers[1] == TB_C(2.0));
        const bool t117 = t116 || (numbers[2] == TB_C(2.0)) || (numbers[3] == TB_C(2.0));
        real_t t118;
        if (t117 || (numbers[4] == TB_C(2.0))) {
            t118 = TB_C(0.0);
        } else {
            const real_t t119 = t103 * weighed[2] + t104 * weighed[10] + t105 * weighed[18];
            const real_t t120 = t102 * weighed[42] - (t119 + t106 * weighed[26] + t107 *
                weighed[34]);
            t118 = t120;
        }
        const bool t121 = (numbers[0] == TB_C(3.0)) || (numbers[1] == TB_C(3.0));
        const bool t122 = t121 || (numbers[2] == TB_C(3.0)) || (numbers[3] == TB_C(3.0));
        real_t t123;
        if (t122 || (numbers[4] == TB_C(3.0))) {
            t123 = TB_C(0.0);
        } else {
            const real_t t124 = t103 * weighed[3] + t104 * weighed[11] + t105 * weighed[19];
            const real_t t125 = t102 * weighed[43] - (t124 + t106 * weighed[27] + t107 *
                weighed[35]);
            t123 = t125;
        }
        const real_t t126 = TB_ABS(t108) + TB_ABS(t113) + TB_ABS(t118) + TB_ABS(t123);
        const bool t127 = (numbers[0] == TB_C(4.0)) || (numbers[1] == TB_C(4.0));
        const bool t128 = t127 || (numbers[2] == TB_C(4.0)) || (numbers[3] == TB_C(4.0));
        real_t t129;
        if (t128 || (numbers[4] == TB_C(4.0))) {
            t129 = TB_C(0.0);
        } else {
            const real_t t130 = t103 * weighed[4] + t104 * weighed[12] + t105 * weighed[20];
            const real_t t131 = t102 * weighed[44] - (t130 + t106 * weighed[28] + t107 *
                weighed[36]);
            t129 = t131;
        }
        const bool t132 = (numbers[0] == TB_C(5.0)) || (numbers[1] == TB_C(5.0));
        const bool t133 = t132 || (numbers[2] == TB_C(5.0)) || (numbers[3] == TB_C(5.0));
        real_t t134;
        if (t133 || (numbers[4] == TB_C(5.0))) {
            t134 = TB_C(0.0);
        } else {
            const real_t t135 = t103 * weighed[5] + t104 * weighed[13] + t105 * weighed[21];
            const real_t t136 = t102 * weighed[45] - (t135 + t106 * weighed[29] + t107 *
                weighed[37]);
            t134 = t136;
        }
        const bool t137 = (numbers[0] == TB_C(6.0)) || (numbers[1] == TB_C(6.0));
        const bool t138 = t137 || (numbers[2] == TB_C(6.0)) || (numbers[3] == TB_C(6.0));
        real_t t139;
        if (t138 || (numbers[4] == TB_C(6.0))) {
            t139 = TB_C(0.0);
        } else {
            const real_t t140 = t103 * weighed[6] + t104 * weighed[14] + t105 * weighed[22];
            const real_t t141 = t102 * weighed[46] - (t140 + t106 * weighed[30] + t107 *
                weighed[38]);
            t139 = t141;
        }
        const real_t t142 = t126 + TB_ABS(t129) + TB_ABS(t134) + TB_ABS(t139);
        const bool t143 = (numbers[0] == TB_C(7.0)) || (numbers[1] == TB_C(7.0));
        const bool t144 = t143 || (numbers[2] == TB_C(7.0)) || (numbers[3] == TB_C(7.0));
        real_t t145;
        if (t144 || (numbers[4] == TB_C(7.0))) {
            t145 = TB_C(0.0);
        } else {
            const real_t t146 = t103 * weighed[7] + t104 * weighed[15] + t105 * weighed[23];
            const real_t t147 = t102 * weighed[47] - (t146 + t106 * weighed[31] + t107 *
                weighed[39]);
            t145 = t147;
        }
        const real_t t148 = t139 + (t134 + (t129 + (t123 + (t118 + (t108 + t113)))));
        const real_t t149 = TB_TENSION_HALF_RANGE * (t142 + TB_ABS(t145)) -
            TB_ABS(TB_TENSION_MIDDLE * (t145 + t148));
        margin_0 = tb_min(margin[0], t149);
    } else {
        margin_0 = margin[0];
    }
    margin[0] = margin_0;
    return TB_OK;
}

/* After the last subset. */
static tb_status tb_balance_finish(const real_t margin[1], real_t balanced[1], real_t wrench[6])
{
    const bool t0 = TB_C(0.0) <= margin[0];
    const real_t balanced_0 = t0 ? TB_C(1.0) : TB_C(0.0);
    const bool t1 = !t0;
    balanced[0] = balanced_0;
    wrench[0] = TB_C(0.0);
    wrench[1] = TB_C(0.0);
    wrench[2] = TB_C(0.0);
    wrench[3] = TB_C(0.0);
    wrench[4] = TB_C(0.0);
    wrench[5] = TB_C(0.0);
    return t1 ? TB_INFEASIBLE : TB_OK;
}

/* Whether the cables hold the platform at rest. */
static tb_status tb_balance(const real_t structure[48], real_t balanced[1], real_t wrench[6])
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
    real_t margin[1];
    const tb_status status = tb_balance_begin(structure, weighed, margin);
    if (status != TB_OK) {
        balanced[0] = TB_C(0.0);
        wrench[0] = TB_C(0.0);
        wrench[1] = TB_C(0.0);
        wrench[2] = TB_C(0.0);
        wrench[3] = TB_C(0.0);
        wrench[4] = TB_C(0.0);
        wrench[5] = TB_C(0.0);
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
        (void)tb_balance_visit(chosen, numbers, weighed, margin);
    }
    return tb_balance_finish(margin, balanced, wrench);
}

/* Least-norm tensions T0 under zero wrench; T_min in every cable outside the workspace. */
static tb_status tb_tension_at_rest(const real_t balanced[1], const real_t rest[8], real_t tension[8])
{
    const bool t0 = TB_C(0.0) < balanced[0];
    const real_t tension_0 = t0 ? rest[0] : TB_TENSION_MIN;
    const real_t tension_1 = t0 ? rest[1] : TB_TENSION_MIN;
    const real_t tension_2 = t0 ? rest[2] : TB_TENSION_MIN;
    const real_t tension_3 = t0 ? rest[3] : TB_TENSION_MIN;
    const real_t tension_4 = t0 ? rest[4] : TB_TENSION_MIN;
    const real_t tension_5 = t0 ? rest[5] : TB_TENSION_MIN;
    const real_t tension_6 = t0 ? rest[6] : TB_TENSION_MIN;
    const real_t tension_7 = t0 ? rest[7] : TB_TENSION_MIN;
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

/* Refuses with a status: tension is 0.5 N. */
static tb_status tb_refuse_zero_wrench_tension(tb_status status, real_t tension[8])
{
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

tb_status tb_zero_wrench_tension(const real_t pose[6], const real_t rails[1], real_t tension[8])
{
    real_t structure[48];
    real_t balanced[1];
    real_t wrench[6];
    real_t rest[8] = {TB_C(0.0)};
    real_t exerted[6] = {TB_C(0.0)};
    real_t residual[1] = {TB_C(0.0)};
    bool infeasible = false;
    tb_status status;
    status = tb_structure_matrix(pose, rails, structure);
    if (status > TB_INFEASIBLE) {
        return tb_refuse_zero_wrench_tension(status, tension);
    }
    status = tb_balance(structure, balanced, wrench);
    if (status > TB_INFEASIBLE) {
        return tb_refuse_zero_wrench_tension(status, tension);
    }
    infeasible = infeasible || status == TB_INFEASIBLE;
    if (balanced[0] > TB_C(0.0)) {
        status = tb_least_norm_tension(structure, wrench, rest, exerted, residual);
        if (status > TB_INFEASIBLE) {
            return tb_refuse_zero_wrench_tension(status, tension);
        }
    }
    status = tb_tension_at_rest(balanced, rest, tension);
    return status == TB_OK && infeasible ? TB_INFEASIBLE : status;
}

/* Tension factor TF = min(T0) / max(T0); 0 outside the zero-wrench workspace. */
static tb_status tb_factor_at_rest(const real_t balanced[1], const real_t rest[8], real_t factor[1])
{
    const bool t0 = TB_C(0.0) < balanced[0];
    real_t factor_0, t1;
    if (t0) {
        const real_t t2 = tb_min(tb_min(tb_min(rest[0], rest[1]), rest[2]), rest[3]);
        const real_t t3 = tb_min(tb_min(tb_min(t2, rest[4]), rest[5]), rest[6]);
        const real_t t4 = tb_max(tb_max(tb_max(rest[0], rest[1]), rest[2]), rest[3]);
        const real_t t5 = tb_max(tb_max(tb_max(t4, rest[4]), rest[5]), rest[6]);
        const real_t t6 = tb_max(t5, rest[7]);
        factor_0 = tb_min(t3, rest[7]) / t6;
        t1 = t6;
    } else {
        factor_0 = TB_C(0.0);
        t1 = TB_C(1.0);
    }
    const bool t7 = !(TB_C(0.0) < t1);
    if (t7) {
        factor[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    factor[0] = factor_0;
    return TB_OK;
}

/* Refuses with a status: factor is 0. */
static tb_status tb_refuse_tension_factor(tb_status status, real_t factor[1])
{
    factor[0] = TB_C(0.0);
    return status;
}

tb_status tb_tension_factor(const real_t pose[6], const real_t rails[1], real_t factor[1])
{
    real_t structure[48];
    real_t balanced[1];
    real_t wrench[6];
    real_t rest[8] = {TB_C(0.0)};
    real_t exerted[6] = {TB_C(0.0)};
    real_t residual[1] = {TB_C(0.0)};
    bool infeasible = false;
    tb_status status;
    status = tb_structure_matrix(pose, rails, structure);
    if (status > TB_INFEASIBLE) {
        return tb_refuse_tension_factor(status, factor);
    }
    status = tb_balance(structure, balanced, wrench);
    if (status > TB_INFEASIBLE) {
        return tb_refuse_tension_factor(status, factor);
    }
    infeasible = infeasible || status == TB_INFEASIBLE;
    if (balanced[0] > TB_C(0.0)) {
        status = tb_least_norm_tension(structure, wrench, rest, exerted, residual);
        if (status > TB_INFEASIBLE) {
            return tb_refuse_tension_factor(status, factor);
        }
    }
    status = tb_factor_at_rest(balanced, rest, factor);
    return status == TB_OK && infeasible ? TB_INFEASIBLE : status;
}

/* Before the first subset. */
static tb_status tb_isotropic_begin(const real_t structure[48], real_t weighed[48], real_t margin[1],
    real_t radius[1])
{
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
        margin[0] = TB_C(0.0);
        radius[0] = TB_C(0.0);
        return TB_SINGULAR;
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
    margin[0] = TB_C(1e+30);
    radius[0] = TB_C(1e+30);
    return TB_OK;
}

/* One subset. */
static tb_status tb_isotropic_visit(const real_t chosen[30], const real_t numbers[5],
    const real_t weighed[48], real_t margin[1], real_t radius[1])
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
    const real_t t149 = t140 + (t135 + (t130 + (t124 + (t119 + (t109 + t114)))));
    const real_t t150 = TB_TENSION_HALF_RANGE * (t143 + TB_ABS(t146)) -
        TB_ABS(TB_TENSION_MIDDLE * (t146 + t149));
    const real_t margin_0 = t80 ? tb_min(margin[0], t150) : margin[0];
    const real_t t151 = TB_SQRT(t104 * t104 + t105 * t105 + t106 * t106);
    real_t radius_0;
    if (t80 && TB_C(1e-06) < t151) {
        radius_0 = tb_min(radius[0], t150 * (TB_C(1.0) / t151));
    } else {
        radius_0 = radius[0];
    }
    margin[0] = margin_0;
    radius[0] = radius_0;
    return TB_OK;
}

/* After the last subset. */
static tb_status tb_isotropic_finish(const real_t margin[1], const real_t radius[1], real_t force[1])
{
    const bool t0 = TB_C(0.0) <= margin[0];
    const real_t force_0 = t0 ? tb_max(radius[0], TB_C(0.0)) : TB_C(0.0);
    const bool t1 = !t0;
    force[0] = force_0;
    return t1 ? TB_INFEASIBLE : TB_OK;
}

/* Isotropic force of a structure matrix. */
static tb_status tb_isotropic(const real_t structure[48], real_t force[1])
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
    real_t margin[1];
    real_t radius[1];
    const tb_status status = tb_isotropic_begin(structure, weighed, margin, radius);
    if (status != TB_OK) {
        force[0] = TB_C(0.0);
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
        (void)tb_isotropic_visit(chosen, numbers, weighed, margin, radius);
    }
    return tb_isotropic_finish(margin, radius, force);
}

tb_status tb_isotropic_force(const real_t pose[6], const real_t rails[1], real_t force[1])
{
    real_t structure[48];
    tb_status status;
    status = tb_structure_matrix(pose, rails, structure);
    if (status > TB_INFEASIBLE) {
        force[0] = TB_C(0.0);
        return status;
    }
    return tb_isotropic(structure, force);
}

