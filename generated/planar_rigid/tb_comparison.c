/* Regenerate: turnbuckle generate machines/planar_rigid.toml --out <this folder>
 * Machine 95fa38e7104ced7a, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_comparison.h"
#include "tb_machine.h"

/* Refuses with a status: pivot is 0; side is 0; moving is 0; push is 0 N. */
static tb_status tb_refuse_kernel_tension_begin(tb_status status, real_t pivot[1],
    real_t side[6], real_t moving[1], real_t push[1])
{
    pivot[0] = TB_C(0.0);
    side[0] = TB_C(0.0);
    side[1] = TB_C(0.0);
    side[2] = TB_C(0.0);
    side[3] = TB_C(0.0);
    side[4] = TB_C(0.0);
    side[5] = TB_C(0.0);
    moving[0] = TB_C(0.0);
    push[0] = TB_C(0.0);
    return status;
}

/* All cables are free. */
static tb_status tb_kernel_tension_begin(const real_t structure[18], const real_t wrench[3],
    real_t pivot[1], real_t side[6], real_t moving[1], real_t push[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) + TB_ABS(structure[10]) + TB_ABS(structure[11]) +
              TB_ABS(structure[12]) + TB_ABS(structure[13]) + TB_ABS(structure[14]) +
              TB_ABS(structure[15]) + TB_ABS(structure[16]) + TB_ABS(structure[17]) <=
              TB_C(72.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) + TB_ABS(wrench[2]) <= TB_C(180000.0))) {
        return tb_refuse_kernel_tension_begin(TB_OUT_OF_DOMAIN, pivot, side, moving, push);
    }
    const real_t t0 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t1 = t0 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t2 = t1 + structure[4] * structure[4] + structure[5] * structure[5];
    const real_t t3 = TB_SQRT(t2);
    const real_t t4 = TB_COPYSIGN(t3, structure[0]);
    const real_t t5 = TB_ABS(t4);
    const real_t t6 = structure[0] + t4;
    const real_t t7 = t6 * structure[6] + structure[1] * structure[7] + structure[2] *
        structure[8];
    const real_t t8 = t7 + structure[3] * structure[9] + structure[4] * structure[10];
    const real_t t9 = TB_C(1.0) / (t3 * (t3 + TB_ABS(structure[0])));
    const real_t t10 = (t8 + structure[5] * structure[11]) * t9;
    const real_t t11 = structure[7] - structure[1] * t10;
    const real_t t12 = structure[8] - structure[2] * t10;
    const real_t t13 = structure[9] - structure[3] * t10;
    const real_t t14 = structure[10] - structure[4] * t10;
    const real_t t15 = structure[11] - structure[5] * t10;
    const real_t t16 = t11 * t11 + t12 * t12 + t13 * t13 + t14 * t14 + t15 * t15;
    const real_t t17 = TB_SQRT(t16);
    const real_t t18 = TB_COPYSIGN(t17, t11);
    const real_t t19 = TB_ABS(t18);
    const real_t t20 = TB_MOMENT_WEIGHT * structure[14];
    const real_t t21 = TB_MOMENT_WEIGHT * structure[13];
    const real_t t22 = t6 * (TB_MOMENT_WEIGHT * structure[12]) + structure[1] * t21;
    const real_t t23 = TB_MOMENT_WEIGHT * structure[15];
    const real_t t24 = TB_MOMENT_WEIGHT * structure[16];
    const real_t t25 = t22 + structure[2] * t20 + structure[3] * t23 + structure[4] * t24;
    const real_t t26 = TB_MOMENT_WEIGHT * structure[17];
    const real_t t27 = t9 * (t25 + structure[5] * t26);
    const real_t t28 = t20 - structure[2] * t27;
    const real_t t29 = (t11 + t18) * (t21 - structure[1] * t27) + t12 * t28;
    const real_t t30 = t23 - structure[3] * t27;
    const real_t t31 = t24 - structure[4] * t27;
    const real_t t32 = t26 - structure[5] * t27;
    const real_t t33 = (t29 + t13 * t30 + t14 * t31 + t15 * t32) * (TB_C(1.0) / (t17 * (t17 +
        TB_ABS(t11))));
    const real_t t34 = t28 - t12 * t33;
    const real_t t35 = t30 - t13 * t33;
    const real_t t36 = t31 - t14 * t33;
    const real_t t37 = t32 - t15 * t33;
    const real_t t38 = TB_SQRT(t34 * t34 + t35 * t35 + t36 * t36 + t37 * t37);
    const real_t t39 = TB_ABS(TB_COPYSIGN(t38, t34));
    const real_t pivot_0 = tb_min(tb_min(t5, t19), t39);
    const real_t t40 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const bool t41 = !(t40 < t5 && t40 < t19 && t40 < t39);
    if (t41) {
        return tb_refuse_kernel_tension_begin(TB_SINGULAR, pivot, side, moving, push);
    }
    pivot[0] = pivot_0;
    side[0] = TB_C(0.0);
    side[1] = TB_C(0.0);
    side[2] = TB_C(0.0);
    side[3] = TB_C(0.0);
    side[4] = TB_C(0.0);
    side[5] = TB_C(0.0);
    moving[0] = -TB_C(1.0);
    push[0] = TB_C(0.0);
    return TB_OK;
}

/* Moves a cable towards its bounds, until it is held or another one is freed. */
static tb_status tb_kernel_tension_step(const real_t structure[18], const real_t wrench[3],
    real_t side[6], real_t moving[1], real_t push[1], real_t done[1])
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
    const real_t t12 = t0 ? (t0 ? structure[0] * structure[0] : TB_C(0.0)) : TB_C(0.0);
    const real_t t13 = t2 ? (t2 ? structure[1] * structure[1] : TB_C(0.0)) : TB_C(0.0);
    const real_t t14 = t4 ? (t4 ? structure[2] * structure[2] : TB_C(0.0)) : TB_C(0.0);
    const real_t t15 = t6 ? (t6 ? structure[3] * structure[3] : TB_C(0.0)) : TB_C(0.0);
    const real_t t16 = t8 ? (t8 ? structure[4] * structure[4] : TB_C(0.0)) : TB_C(0.0);
    const real_t t17 = t10 ? (t10 ? structure[5] * structure[5] : TB_C(0.0)) : TB_C(0.0);
    const real_t t18 = TB_SQRT(t12 + t13 + t14 + t15 + t16 + t17);
    const real_t t19 = t0 ? structure[0] : TB_C(0.0);
    const real_t t20 = TB_COPYSIGN(t18, t19);
    const real_t t21 = t19 + t20;
    const real_t t22 = t2 ? (t2 ? structure[1] * structure[7] : TB_C(0.0)) : TB_C(0.0);
    const real_t t23 = t4 ? (t4 ? structure[2] * structure[8] : TB_C(0.0)) : TB_C(0.0);
    const real_t t24 = (t0 ? t21 * structure[6] : TB_C(0.0)) + t22 + t23;
    const real_t t25 = t6 ? (t6 ? structure[3] * structure[9] : TB_C(0.0)) : TB_C(0.0);
    const real_t t26 = t8 ? (t8 ? structure[4] * structure[10] : TB_C(0.0)) : TB_C(0.0);
    const real_t t27 = t10 ? (t10 ? structure[5] * structure[11] : TB_C(0.0)) : TB_C(0.0);
    const real_t t28 = TB_C(1.0) / (t18 * (t18 + TB_ABS(t19)));
    const real_t t29 = (t24 + t25 + t26 + t27) * t28;
    const real_t t30 = structure[7] - structure[1] * t29;
    const real_t t31 = structure[8] - structure[2] * t29;
    const real_t t32 = (t2 ? (t2 ? t30 * t30 : TB_C(0.0)) : TB_C(0.0)) + (t4 ? (t4 ? t31 * t31
        : TB_C(0.0)) : TB_C(0.0));
    const real_t t33 = structure[9] - structure[3] * t29;
    const real_t t34 = t32 + (t6 ? (t6 ? t33 * t33 : TB_C(0.0)) : TB_C(0.0));
    const real_t t35 = structure[10] - structure[4] * t29;
    const real_t t36 = t34 + (t8 ? (t8 ? t35 * t35 : TB_C(0.0)) : TB_C(0.0));
    const real_t t37 = structure[11] - structure[5] * t29;
    const real_t t38 = t36 + (t10 ? (t10 ? t37 * t37 : TB_C(0.0)) : TB_C(0.0));
    const real_t t39 = TB_SQRT(t38);
    const real_t t40 = t2 ? t30 : TB_C(0.0);
    const real_t t41 = TB_COPYSIGN(t39, t40);
    const real_t t42 = TB_MOMENT_WEIGHT * structure[14];
    const real_t t43 = TB_MOMENT_WEIGHT * structure[12];
    const real_t t44 = TB_MOMENT_WEIGHT * structure[13];
    const real_t t45 = t2 ? (t2 ? structure[1] * t44 : TB_C(0.0)) : TB_C(0.0);
    const real_t t46 = t4 ? (t4 ? structure[2] * t42 : TB_C(0.0)) : TB_C(0.0);
    const real_t t47 = TB_MOMENT_WEIGHT * structure[15];
    const real_t t48 = t6 ? (t6 ? structure[3] * t47 : TB_C(0.0)) : TB_C(0.0);
    const real_t t49 = TB_MOMENT_WEIGHT * structure[16];
    const real_t t50 = t8 ? (t8 ? structure[4] * t49 : TB_C(0.0)) : TB_C(0.0);
    const real_t t51 = (t0 ? t21 * t43 : TB_C(0.0)) + t45 + t46 + t48 + t50;
    const real_t t52 = TB_MOMENT_WEIGHT * structure[17];
    const real_t t53 = t10 ? (t10 ? structure[5] * t52 : TB_C(0.0)) : TB_C(0.0);
    const real_t t54 = t28 * (t51 + t53);
    const real_t t55 = t42 - structure[2] * t54;
    const real_t t56 = t40 + t41;
    const real_t t57 = t44 - structure[1] * t54;
    const real_t t58 = (t2 ? t56 * t57 : TB_C(0.0)) + (t4 ? (t4 ? t31 * t55 : TB_C(0.0)) :
        TB_C(0.0));
    const real_t t59 = t47 - structure[3] * t54;
    const real_t t60 = t58 + (t6 ? (t6 ? t33 * t59 : TB_C(0.0)) : TB_C(0.0));
    const real_t t61 = t49 - structure[4] * t54;
    const real_t t62 = t60 + (t8 ? (t8 ? t35 * t61 : TB_C(0.0)) : TB_C(0.0));
    const real_t t63 = t52 - structure[5] * t54;
    const real_t t64 = t62 + (t10 ? (t10 ? t37 * t63 : TB_C(0.0)) : TB_C(0.0));
    const real_t t65 = t64 * (TB_C(1.0) / (t39 * (t39 + TB_ABS(t40))));
    const real_t t66 = t55 - t31 * t65;
    const real_t t67 = t59 - t33 * t65;
    const real_t t68 = (t4 ? (t4 ? t66 * t66 : TB_C(0.0)) : TB_C(0.0)) + (t6 ? (t6 ? t67 * t67
        : TB_C(0.0)) : TB_C(0.0));
    const real_t t69 = t61 - t35 * t65;
    const real_t t70 = t68 + (t8 ? (t8 ? t69 * t69 : TB_C(0.0)) : TB_C(0.0));
    const real_t t71 = t63 - t37 * t65;
    const real_t t72 = t70 + (t10 ? (t10 ? t71 * t71 : TB_C(0.0)) : TB_C(0.0));
    const real_t t73 = TB_COPYSIGN(TB_SQRT(t72), t4 ? t66 : TB_C(0.0));
    const real_t t74 = tb_min(tb_min(TB_ABS(t20), TB_ABS(t41)), TB_ABS(t73));
    const real_t t75 = TB_C(1.0) / tb_min(TB_C(1.0), t74);
    const real_t t76 = TB_C(64.0) * TB_EPSILON * t75;
    const bool t77 = TB_C(0.0) <= moving[0];
    const real_t t78 = TB_C(1.0) / t20;
    const real_t t79 = TB_C(0.0) < side[0] ? TB_C(1000000000000.0) : (side[0] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t80 = TB_C(0.0) < side[1] ? TB_C(1000000000000.0) : (side[1] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t81 = TB_C(0.0) < side[2] ? TB_C(1000000000000.0) : (side[2] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t82 = structure[0] * t79 + structure[1] * t80 + structure[2] * t81;
    const real_t t83 = TB_C(0.0) < side[3] ? TB_C(1000000000000.0) : (side[3] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t84 = TB_C(0.0) < side[4] ? TB_C(1000000000000.0) : (side[4] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t85 = TB_C(0.0) < side[5] ? TB_C(1000000000000.0) : (side[5] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t86 = t82 + structure[3] * t83 + structure[4] * t84 + structure[5] * t85;
    const real_t t87 = (wrench[0] - t86) * t78;
    const real_t t88 = (t0 ? structure[6] : TB_C(0.0)) - t21 * t29;
    const real_t t89 = TB_C(1.0) / t41;
    const real_t t90 = structure[6] * t79 + structure[7] * t80 + structure[8] * t81;
    const real_t t91 = t90 + structure[9] * t83 + structure[10] * t84 + structure[11] * t85;
    const real_t t92 = (wrench[1] - t91 + t87 * t88) * t89;
    const real_t t93 = (t2 ? t57 : TB_C(0.0)) - t56 * t65;
    const real_t t94 = TB_C(1.0) / t73;
    const real_t t95 = TB_MOMENT_WEIGHT * wrench[2];
    const real_t t96 = t43 * t79 + t44 * t80 + t42 * t81 + t47 * t83 + t49 * t84;
    const real_t t97 = (t0 ? t43 : TB_C(0.0)) - t21 * t54;
    const real_t t98 = (t95 - (t96 + t52 * t85) + t87 * t97 + t92 * t93) * t94;
    const real_t t99 = t94 * t98;
    const real_t t100 = t89 * (t92 + t93 * t99);
    const real_t t101 = t78 * (t87 + t88 * t100 + t97 * t99);
    const real_t t102 = structure[3] * t101 + structure[9] * t100 + t47 * t99;
    const real_t t103 = tb_max(TB_TENSION_MIN - t102, t102 - TB_C(1000000000000.0));
    const real_t t104 = TB_C(0.0) < t7 ? t103 : -TB_C(1.0);
    const real_t t105 = structure[4] * t101 + structure[10] * t100 + t49 * t99;
    const real_t t106 = tb_max(TB_TENSION_MIN - t105, t105 - TB_C(1000000000000.0));
    const real_t t107 = TB_C(0.0) < t9 ? t106 : -TB_C(1.0);
    const real_t t108 = structure[5] * t101 + structure[11] * t100 + t52 * t99;
    const real_t t109 = tb_max(TB_TENSION_MIN - t108, t108 - TB_C(1000000000000.0));
    const real_t t110 = TB_C(0.0) < t11 ? t109 : -TB_C(1.0);
    const real_t t111 = structure[0] * t101 + structure[6] * t100 + t43 * t99;
    const real_t t112 = tb_max(TB_TENSION_MIN - t111, t111 - TB_C(1000000000000.0));
    const real_t t113 = TB_C(0.0) < t1 ? t112 : -TB_C(1.0);
    const real_t t114 = structure[1] * t101 + structure[7] * t100 + t44 * t99;
    const real_t t115 = tb_max(TB_TENSION_MIN - t114, t114 - TB_C(1000000000000.0));
    const real_t t116 = TB_C(0.0) < t3 ? t115 : -TB_C(1.0);
    const real_t t117 = structure[2] * t101 + structure[8] * t100 + t42 * t99;
    const real_t t118 = tb_max(TB_TENSION_MIN - t117, t117 - TB_C(1000000000000.0));
    const real_t t119 = TB_C(0.0) < t5 ? t118 : -TB_C(1.0);
    real_t t120, t121, t122, t123, t124, t125;
    if (t77) {
        t120 = TB_C(3.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
        t121 = moving[0] == TB_C(4.0) ? TB_C(1.0) : TB_C(0.0);
        t122 = moving[0] == TB_C(5.0) ? TB_C(1.0) : TB_C(0.0);
        t123 = TB_C(0.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
        t124 = TB_C(1.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
        t125 = moving[0] == TB_C(2.0) ? TB_C(1.0) : TB_C(0.0);
    } else {
        t120 = t104;
        t121 = t107;
        t122 = t110;
        t123 = t113;
        t124 = t116;
        t125 = t119;
    }
    const real_t t126 = tb_max(t120, t121);
    const real_t t127 = tb_max(t123, t124);
    const bool t128 = tb_max(t126, t122) <= tb_max(t127, t125);
    real_t t129, t130, t131, t132, t133;
    if (t128) {
        const bool t134 = t125 <= t127;
        real_t t135, t136, t137, t138, t139;
        if (t134) {
            const bool t140 = t124 <= t123;
            t135 = t140 ? TB_C(0.0) : TB_C(1.0);
            t136 = t140 ? structure[0] : structure[1];
            t137 = t140 ? structure[6] : structure[7];
            t138 = t140 ? t43 : t44;
            t139 = t140 ? t111 : t114;
        } else {
            t135 = TB_C(2.0);
            t136 = structure[2];
            t137 = structure[8];
            t138 = t42;
            t139 = t117;
        }
        t129 = t135;
        t130 = t136;
        t131 = t137;
        t132 = t138;
        t133 = t139;
    } else {
        const bool t141 = t122 <= t126;
        real_t t142, t143, t144, t145, t146;
        if (t141) {
            const bool t147 = t121 <= t120;
            t142 = t147 ? TB_C(3.0) : TB_C(4.0);
            t143 = t147 ? structure[3] : structure[4];
            t144 = t147 ? structure[9] : structure[10];
            t145 = t147 ? t47 : t49;
            t146 = t147 ? t102 : t105;
        } else {
            t142 = TB_C(5.0);
            t143 = structure[5];
            t144 = structure[11];
            t145 = t52;
            t146 = t108;
        }
        t129 = t142;
        t130 = t143;
        t131 = t144;
        t132 = t145;
        t133 = t146;
    }
    const real_t t148 = t78 * t130;
    const real_t t149 = t89 * (t131 + t88 * t148);
    const real_t t150 = t94 * (t94 * (t132 + t97 * t148 + t93 * t149));
    const real_t t151 = t89 * (t149 + t93 * t150);
    const real_t t152 = t78 * (t148 + t88 * t151 + t97 * t150);
    const real_t t153 = structure[0] * t152 + structure[6] * t151 + t43 * t150;
    const real_t t154 = (TB_C(0.0) == t129 ? TB_C(1.0) : TB_C(0.0)) - t153;
    const real_t t155 = structure[1] * t152 + structure[7] * t151 + t44 * t150;
    const real_t t156 = (TB_C(1.0) == t129 ? TB_C(1.0) : TB_C(0.0)) - t155;
    const real_t t157 = (t0 ? (t0 ? t154 * t154 : TB_C(0.0)) : TB_C(0.0)) + (t2 ? (t2 ? t156 *
        t156 : TB_C(0.0)) : TB_C(0.0));
    const real_t t158 = structure[2] * t152 + structure[8] * t151 + t42 * t150;
    const real_t t159 = (TB_C(2.0) == t129 ? TB_C(1.0) : TB_C(0.0)) - t158;
    const real_t t160 = t157 + (t4 ? (t4 ? t159 * t159 : TB_C(0.0)) : TB_C(0.0));
    const real_t t161 = structure[3] * t152 + structure[9] * t151 + t47 * t150;
    const real_t t162 = (TB_C(3.0) == t129 ? TB_C(1.0) : TB_C(0.0)) - t161;
    const real_t t163 = t160 + (t6 ? (t6 ? t162 * t162 : TB_C(0.0)) : TB_C(0.0));
    const real_t t164 = structure[4] * t152 + structure[10] * t151 + t49 * t150;
    const real_t t165 = (TB_C(4.0) == t129 ? TB_C(1.0) : TB_C(0.0)) - t164;
    const real_t t166 = t163 + (t8 ? (t8 ? t165 * t165 : TB_C(0.0)) : TB_C(0.0));
    const real_t t167 = structure[5] * t152 + structure[11] * t151 + t52 * t150;
    const real_t t168 = (TB_C(5.0) == t129 ? TB_C(1.0) : TB_C(0.0)) - t167;
    const real_t t169 = t10 ? (t10 ? t168 * t168 : TB_C(0.0)) : TB_C(0.0);
    const real_t t170 = t166 + t169;
    const bool t171 = TB_C(3.0) < t1 + t3 + t5 + t7 + t9 + t11 && t76 * t76 < t170;
    const real_t t172 = t133 + t170 * push[0];
    const bool t173 = t172 < TB_C(500000000001.5);
    real_t t174;
    if (t171) {
        const real_t t175 = t173 ? TB_TENSION_MIN - t172 : t172 - TB_C(1000000000000.0);
        t174 = tb_max(t175, TB_C(0.0)) * (TB_C(1.0) / t170);
    } else {
        t174 = TB_C(1e+30);
    }
    const real_t t176 = t173 ? TB_C(1.0) : -TB_C(1.0);
    const real_t t177 = side[0] * (t153 * t176);
    real_t t178;
    if (t76 < t177) {
        const real_t t179 = tb_max(side[0] * (t111 - t153 * push[0] - t79), TB_C(0.0));
        t178 = t179 / t177;
    } else {
        t178 = TB_C(1e+30);
    }
    const real_t t180 = side[1] * (t155 * t176);
    real_t t181;
    if (t76 < t180) {
        const real_t t182 = tb_max(side[1] * (t114 - t155 * push[0] - t80), TB_C(0.0));
        t181 = t182 / t180;
    } else {
        t181 = TB_C(1e+30);
    }
    const real_t t183 = side[2] * (t158 * t176);
    real_t t184;
    if (t76 < t183) {
        const real_t t185 = tb_max(side[2] * (t117 - t158 * push[0] - t81), TB_C(0.0));
        t184 = t185 / t183;
    } else {
        t184 = TB_C(1e+30);
    }
    const real_t t186 = side[3] * (t161 * t176);
    real_t t187;
    if (t76 < t186) {
        const real_t t188 = tb_max(side[3] * (t102 - t161 * push[0] - t83), TB_C(0.0));
        t187 = t188 / t186;
    } else {
        t187 = TB_C(1e+30);
    }
    const real_t t189 = side[4] * (t164 * t176);
    real_t t190;
    if (t76 < t189) {
        const real_t t191 = tb_max(side[4] * (t105 - t164 * push[0] - t84), TB_C(0.0));
        t190 = t191 / t189;
    } else {
        t190 = TB_C(1e+30);
    }
    const real_t t192 = tb_min(tb_min(tb_min(tb_min(t178, t181), t184), t187), t190);
    const real_t t193 = side[5] * (t167 * t176);
    real_t t194;
    if (t76 < t193) {
        const real_t t195 = tb_max(side[5] * (t108 - t167 * push[0] - t85), TB_C(0.0));
        t194 = t195 / t193;
    } else {
        t194 = TB_C(1e+30);
    }
    const real_t t196 = tb_min(t192, t194);
    const bool t197 = t174 <= t196;
    const real_t t198 = tb_max(tb_max(tb_max(tb_max(t113, t116), t119), t104), t107);
    const real_t t199 = TB_ABS(wrench[0]) + TB_ABS(wrench[1]) + TB_ABS(t95);
    const real_t t200 = t75 * (TB_EPSILON * TB_C(8.0) * (TB_TENSION_MIN + t199));
    const bool t201 = (!t77 && tb_max(t198, t110) <= t200) || !(tb_min(t174, t196) <
        TB_C(1e+30));
    const real_t t202 = t197 && !t201 ? t129 : -TB_C(1.0);
    const real_t t203 = -t176;
    real_t t204;
    if (t197 || t201) {
        t204 = -TB_C(1.0);
    } else {
        const real_t t205 = -t187;
        const real_t t206 = -t190;
        const real_t t207 = tb_max(t205, t206);
        const real_t t208 = -t194;
        const real_t t209 = -t178;
        const real_t t210 = -t181;
        const real_t t211 = tb_max(t209, t210);
        const real_t t212 = -t184;
        real_t t213;
        if (tb_max(t207, t208) <= tb_max(t211, t212)) {
            const real_t t214 = t212 <= t211 ? (t210 <= t209 ? TB_C(0.0) : TB_C(1.0)) :
                TB_C(2.0);
            t213 = t214;
        } else {
            const real_t t215 = t208 <= t207 ? (t206 <= t205 ? TB_C(3.0) : TB_C(4.0)) :
                TB_C(5.0);
            t213 = t215;
        }
        t204 = t213;
    }
    const real_t side_0 = TB_C(0.0) == t202 ? t203 : (TB_C(0.0) == t204 ? TB_C(0.0) : side[0]);
    const real_t side_1 = TB_C(1.0) == t202 ? t203 : (TB_C(1.0) == t204 ? TB_C(0.0) : side[1]);
    const real_t side_2 = TB_C(2.0) == t202 ? t203 : (TB_C(2.0) == t204 ? TB_C(0.0) : side[2]);
    const real_t side_3 = TB_C(3.0) == t202 ? t203 : (TB_C(3.0) == t204 ? TB_C(0.0) : side[3]);
    const real_t side_4 = TB_C(4.0) == t202 ? t203 : (TB_C(4.0) == t204 ? TB_C(0.0) : side[4]);
    const real_t side_5 = TB_C(5.0) == t202 ? t203 : (TB_C(5.0) == t204 ? TB_C(0.0) : side[5]);
    const real_t moving_0 = t197 ? -TB_C(1.0) : t129;
    const real_t push_0 = t197 ? TB_C(0.0) : push[0] + t176 * t196;
    const real_t done_0 = t201 ? TB_C(1.0) : TB_C(0.0);
    side[0] = side_0;
    side[1] = side_1;
    side[2] = side_2;
    side[3] = side_3;
    side[4] = side_4;
    side[5] = side_5;
    moving[0] = moving_0;
    push[0] = push_0;
    done[0] = done_0;
    return TB_OK;
}

/* The tensions, refined and judged. */
static tb_status tb_kernel_tension_finish(const real_t structure[18], const real_t wrench[3],
    const real_t pivot[1], const real_t side[6], real_t tension[6])
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
    const real_t t8 = wrench[0] - t7;
    const bool t9 = TB_C(0.0) == side[0];
    const real_t t10 = t9 ? (t9 ? structure[0] * structure[0] : TB_C(0.0)) : TB_C(0.0);
    const bool t11 = TB_C(0.0) == side[1];
    const real_t t12 = t11 ? (t11 ? structure[1] * structure[1] : TB_C(0.0)) : TB_C(0.0);
    const bool t13 = TB_C(0.0) == side[2];
    const real_t t14 = t13 ? (t13 ? structure[2] * structure[2] : TB_C(0.0)) : TB_C(0.0);
    const bool t15 = TB_C(0.0) == side[3];
    const real_t t16 = t15 ? (t15 ? structure[3] * structure[3] : TB_C(0.0)) : TB_C(0.0);
    const bool t17 = TB_C(0.0) == side[4];
    const real_t t18 = t17 ? (t17 ? structure[4] * structure[4] : TB_C(0.0)) : TB_C(0.0);
    const bool t19 = TB_C(0.0) == side[5];
    const real_t t20 = t19 ? (t19 ? structure[5] * structure[5] : TB_C(0.0)) : TB_C(0.0);
    const real_t t21 = TB_SQRT(t10 + t12 + t14 + t16 + t18 + t20);
    const real_t t22 = t9 ? structure[0] : TB_C(0.0);
    const real_t t23 = TB_COPYSIGN(t21, t22);
    const real_t t24 = TB_C(1.0) / t23;
    const real_t t25 = t8 * t24;
    const real_t t26 = t22 + t23;
    const real_t t27 = t11 ? (t11 ? structure[1] * structure[7] : TB_C(0.0)) : TB_C(0.0);
    const real_t t28 = t13 ? (t13 ? structure[2] * structure[8] : TB_C(0.0)) : TB_C(0.0);
    const real_t t29 = (t9 ? structure[6] * t26 : TB_C(0.0)) + t27 + t28;
    const real_t t30 = t15 ? (t15 ? structure[3] * structure[9] : TB_C(0.0)) : TB_C(0.0);
    const real_t t31 = t17 ? (t17 ? structure[4] * structure[10] : TB_C(0.0)) : TB_C(0.0);
    const real_t t32 = t19 ? (t19 ? structure[5] * structure[11] : TB_C(0.0)) : TB_C(0.0);
    const real_t t33 = TB_C(1.0) / (t21 * (t21 + TB_ABS(t22)));
    const real_t t34 = (t29 + t30 + t31 + t32) * t33;
    const real_t t35 = (t9 ? structure[6] : TB_C(0.0)) - t26 * t34;
    const real_t t36 = t0 * structure[6] + t1 * structure[7] + t2 * structure[8];
    const real_t t37 = t36 + t4 * structure[9] + t5 * structure[10] + t6 * structure[11];
    const real_t t38 = wrench[1] - t37;
    const real_t t39 = structure[7] - structure[1] * t34;
    const real_t t40 = structure[8] - structure[2] * t34;
    const real_t t41 = (t11 ? (t11 ? t39 * t39 : TB_C(0.0)) : TB_C(0.0)) + (t13 ? (t13 ? t40 *
        t40 : TB_C(0.0)) : TB_C(0.0));
    const real_t t42 = structure[9] - structure[3] * t34;
    const real_t t43 = t41 + (t15 ? (t15 ? t42 * t42 : TB_C(0.0)) : TB_C(0.0));
    const real_t t44 = structure[10] - structure[4] * t34;
    const real_t t45 = t43 + (t17 ? (t17 ? t44 * t44 : TB_C(0.0)) : TB_C(0.0));
    const real_t t46 = structure[11] - structure[5] * t34;
    const real_t t47 = t45 + (t19 ? (t19 ? t46 * t46 : TB_C(0.0)) : TB_C(0.0));
    const real_t t48 = TB_SQRT(t47);
    const real_t t49 = t11 ? t39 : TB_C(0.0);
    const real_t t50 = TB_COPYSIGN(t48, t49);
    const real_t t51 = TB_C(1.0) / t50;
    const real_t t52 = (t38 + t25 * t35) * t51;
    const real_t t53 = TB_MOMENT_WEIGHT * structure[13];
    const real_t t54 = TB_MOMENT_WEIGHT * structure[12];
    const real_t t55 = t11 ? (t11 ? structure[1] * t53 : TB_C(0.0)) : TB_C(0.0);
    const real_t t56 = TB_MOMENT_WEIGHT * structure[14];
    const real_t t57 = t13 ? (t13 ? structure[2] * t56 : TB_C(0.0)) : TB_C(0.0);
    const real_t t58 = TB_MOMENT_WEIGHT * structure[15];
    const real_t t59 = t15 ? (t15 ? structure[3] * t58 : TB_C(0.0)) : TB_C(0.0);
    const real_t t60 = TB_MOMENT_WEIGHT * structure[16];
    const real_t t61 = t17 ? (t17 ? structure[4] * t60 : TB_C(0.0)) : TB_C(0.0);
    const real_t t62 = (t9 ? t26 * t54 : TB_C(0.0)) + t55 + t57 + t59 + t61;
    const real_t t63 = TB_MOMENT_WEIGHT * structure[17];
    const real_t t64 = t19 ? (t19 ? structure[5] * t63 : TB_C(0.0)) : TB_C(0.0);
    const real_t t65 = t33 * (t62 + t64);
    const real_t t66 = t53 - structure[1] * t65;
    const real_t t67 = t49 + t50;
    const real_t t68 = t56 - structure[2] * t65;
    const real_t t69 = (t11 ? t66 * t67 : TB_C(0.0)) + (t13 ? (t13 ? t40 * t68 : TB_C(0.0)) :
        TB_C(0.0));
    const real_t t70 = t58 - structure[3] * t65;
    const real_t t71 = t69 + (t15 ? (t15 ? t42 * t70 : TB_C(0.0)) : TB_C(0.0));
    const real_t t72 = t60 - structure[4] * t65;
    const real_t t73 = t71 + (t17 ? (t17 ? t44 * t72 : TB_C(0.0)) : TB_C(0.0));
    const real_t t74 = t63 - structure[5] * t65;
    const real_t t75 = t73 + (t19 ? (t19 ? t46 * t74 : TB_C(0.0)) : TB_C(0.0));
    const real_t t76 = t75 * (TB_C(1.0) / (t48 * (t48 + TB_ABS(t49))));
    const real_t t77 = (t11 ? t66 : TB_C(0.0)) - t67 * t76;
    const real_t t78 = TB_MOMENT_WEIGHT * wrench[2];
    const real_t t79 = t0 * t54 + t1 * t53 + t2 * t56 + t4 * t58 + t5 * t60;
    const real_t t80 = t78 - (t79 + t6 * t63);
    const real_t t81 = (t9 ? t54 : TB_C(0.0)) - t26 * t65;
    const real_t t82 = t68 - t40 * t76;
    const real_t t83 = t70 - t42 * t76;
    const real_t t84 = (t13 ? (t13 ? t82 * t82 : TB_C(0.0)) : TB_C(0.0)) + (t15 ? (t15 ? t83 *
        t83 : TB_C(0.0)) : TB_C(0.0));
    const real_t t85 = t72 - t44 * t76;
    const real_t t86 = t84 + (t17 ? (t17 ? t85 * t85 : TB_C(0.0)) : TB_C(0.0));
    const real_t t87 = t74 - t46 * t76;
    const real_t t88 = t86 + (t19 ? (t19 ? t87 * t87 : TB_C(0.0)) : TB_C(0.0));
    const real_t t89 = TB_COPYSIGN(TB_SQRT(t88), t13 ? t82 : TB_C(0.0));
    const real_t t90 = TB_C(1.0) / t89;
    const real_t t91 = t90 * ((t80 + t25 * t81 + t52 * t77) * t90);
    const real_t t92 = t51 * (t52 + t77 * t91);
    const real_t t93 = t24 * (t25 + t35 * t92 + t81 * t91);
    const real_t t94 = structure[0] * t93 + structure[6] * t92 + t54 * t91;
    const real_t t95 = structure[1] * t93 + structure[7] * t92 + t53 * t91;
    const real_t t96 = (t9 ? structure[0] * t94 : TB_C(0.0)) + (t11 ? structure[1] * t95 :
        TB_C(0.0));
    const real_t t97 = structure[2] * t93 + structure[8] * t92 + t56 * t91;
    const real_t t98 = structure[3] * t93 + structure[9] * t92 + t58 * t91;
    const real_t t99 = t96 + (t13 ? structure[2] * t97 : TB_C(0.0)) + (t15 ? structure[3] * t98
        : TB_C(0.0));
    const real_t t100 = structure[4] * t93 + structure[10] * t92 + t60 * t91;
    const real_t t101 = structure[5] * t93 + structure[11] * t92 + t63 * t91;
    const real_t t102 = t99 + (t17 ? structure[4] * t100 : TB_C(0.0)) + (t19 ? structure[5] *
        t101 : TB_C(0.0));
    const real_t t103 = t24 * (t8 - t102);
    const real_t t104 = (t9 ? structure[6] * t94 : TB_C(0.0)) + (t11 ? structure[7] * t95 :
        TB_C(0.0));
    const real_t t105 = t104 + (t13 ? structure[8] * t97 : TB_C(0.0)) + (t15 ? structure[9] *
        t98 : TB_C(0.0));
    const real_t t106 = t105 + (t17 ? structure[10] * t100 : TB_C(0.0)) + (t19 ? structure[11]
        * t101 : TB_C(0.0));
    const real_t t107 = t51 * (t38 - t106 + t35 * t103);
    const real_t t108 = (t9 ? t54 * t94 : TB_C(0.0)) + (t11 ? t53 * t95 : TB_C(0.0));
    const real_t t109 = t108 + (t13 ? t56 * t97 : TB_C(0.0)) + (t15 ? t58 * t98 : TB_C(0.0));
    const real_t t110 = t109 + (t17 ? t60 * t100 : TB_C(0.0)) + (t19 ? t63 * t101 : TB_C(0.0));
    const real_t t111 = t90 * (t90 * (t80 - t110 + t81 * t103 + t77 * t107));
    const real_t t112 = t51 * (t107 + t77 * t111);
    const real_t t113 = t24 * (t103 + t35 * t112 + t81 * t111);
    const real_t t114 = structure[0] * t113 + structure[6] * t112 + t54 * t111;
    const real_t t115 = t94 + t114;
    const real_t t116 = structure[1] * t113 + structure[7] * t112 + t53 * t111;
    const real_t t117 = t95 + t116;
    const real_t t118 = tb_max(side[0] * (t0 - t115), side[1] * (t1 - t117));
    const real_t t119 = structure[2] * t113 + structure[8] * t112 + t56 * t111;
    const real_t t120 = t97 + t119;
    const real_t t121 = structure[3] * t113 + structure[9] * t112 + t58 * t111;
    const real_t t122 = t98 + t121;
    const real_t t123 = tb_max(tb_max(t118, side[2] * (t2 - t120)), side[3] * (t4 - t122));
    const real_t t124 = structure[4] * t113 + structure[10] * t112 + t60 * t111;
    const real_t t125 = t100 + t124;
    const real_t t126 = structure[5] * t113 + structure[11] * t112 + t63 * t111;
    const real_t t127 = t101 + t126;
    const real_t t128 = tb_max(tb_max(t123, side[4] * (t5 - t125)), side[5] * (t6 - t127));
    const real_t t129 = tb_min(tb_min(TB_ABS(t23), TB_ABS(t50)), TB_ABS(t89));
    const real_t t130 = tb_max(TB_C(0.0), t128) * tb_min(TB_C(1.0), t129);
    const real_t t131 = TB_ABS(wrench[0]) + TB_ABS(wrench[1]) + TB_ABS(t78);
    const real_t t132 = TB_TENSION_MIN + t131;
    const real_t t133 = tb_max(tb_max(TB_ABS(t93), TB_ABS(t92)), TB_ABS(t91));
    const real_t t134 = tb_min(tb_max(t9 ? t115 : t0, TB_TENSION_MIN), TB_C(1000000000000.0));
    const real_t t135 = tb_min(tb_max(t11 ? t117 : t1, TB_TENSION_MIN), TB_C(1000000000000.0));
    const real_t t136 = tb_min(tb_max(t13 ? t120 : t2, TB_TENSION_MIN), TB_C(1000000000000.0));
    const real_t t137 = structure[0] * t134 + structure[1] * t135 + structure[2] * t136;
    const real_t t138 = tb_min(tb_max(t15 ? t122 : t4, TB_TENSION_MIN), TB_C(1000000000000.0));
    const real_t t139 = tb_min(tb_max(t17 ? t125 : t5, TB_TENSION_MIN), TB_C(1000000000000.0));
    const real_t t140 = tb_min(tb_max(t19 ? t127 : t6, TB_TENSION_MIN), TB_C(1000000000000.0));
    const real_t t141 = t137 + structure[3] * t138 + structure[4] * t139 + structure[5] * t140;
    const real_t t142 = tb_max(t130 * t132 * (TB_C(1.0) / tb_max(t132, t133)), TB_ABS(t141 -
        wrench[0]));
    const real_t t143 = structure[6] * t134 + structure[7] * t135 + structure[8] * t136;
    const real_t t144 = t143 + structure[9] * t138 + structure[10] * t139;
    const real_t t145 = tb_max(t142, TB_ABS(t144 + structure[11] * t140 - wrench[1]));
    const real_t t146 = t54 * t134 + t53 * t135 + t56 * t136 + t58 * t138;
    const real_t t147 = tb_max(t145, TB_ABS(t146 + t60 * t139 + t63 * t140 - t78));
    const real_t t148 = tb_max(tb_max(tb_max(tb_max(t134, t135), t136), t138), t139);
    const real_t t149 = TB_C(128.0) * TB_EPSILON * tb_max(t148, t140) * (TB_C(1.0) / pivot[0]);
    const bool t150 = t147 <= tb_min(t149, TB_C(0.01));
    const bool t151 = !t150;
    const real_t tension_0 = t150 ? t134 : TB_TENSION_MIN;
    const real_t tension_1 = t150 ? t135 : TB_TENSION_MIN;
    const real_t tension_2 = t150 ? t136 : TB_TENSION_MIN;
    const real_t tension_3 = t150 ? t138 : TB_TENSION_MIN;
    const real_t tension_4 = t150 ? t139 : TB_TENSION_MIN;
    const real_t tension_5 = t150 ? t140 : TB_TENSION_MIN;
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    tension[4] = tension_4;
    tension[5] = tension_5;
    return t151 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_kernel_tension(const real_t structure[18], const real_t wrench[3],
    real_t tension[6])
{
    real_t pivot[1];
    real_t side[6];
    real_t moving[1];
    real_t push[1];
    real_t done[1] = {TB_C(0.0)};
    tb_status status = tb_kernel_tension_begin(structure, wrench, pivot, side, moving, push);
    for (int steps = 0; steps < 30 && status == TB_OK && !(done[0] > TB_C(0.0)); steps++) {
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
        return status;
    }
    return tb_kernel_tension_finish(structure, wrench, pivot, side, tension);
}

/* Before the first subset. */
static tb_status tb_reduced_matrix_tension_begin(const real_t structure[18], const real_t wrench[3],
    real_t weighed[18], real_t rest[3], real_t least[1], real_t best[3], real_t cables[3])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) + TB_ABS(structure[10]) + TB_ABS(structure[11]) +
              TB_ABS(structure[12]) + TB_ABS(structure[13]) + TB_ABS(structure[14]) +
              TB_ABS(structure[15]) + TB_ABS(structure[16]) + TB_ABS(structure[17]) <=
              TB_C(72.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) + TB_ABS(wrench[2]) <= TB_C(180000.0))) {
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
        rest[0] = TB_C(0.0);
        rest[1] = TB_C(0.0);
        rest[2] = TB_C(0.0);
        least[0] = TB_C(0.0);
        best[0] = TB_C(0.0);
        best[1] = TB_C(0.0);
        best[2] = TB_C(0.0);
        cables[0] = TB_C(0.0);
        cables[1] = TB_C(0.0);
        cables[2] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t weighed_12 = TB_MOMENT_WEIGHT * structure[12];
    const real_t weighed_13 = TB_MOMENT_WEIGHT * structure[13];
    const real_t weighed_14 = TB_MOMENT_WEIGHT * structure[14];
    const real_t weighed_15 = TB_MOMENT_WEIGHT * structure[15];
    const real_t weighed_16 = TB_MOMENT_WEIGHT * structure[16];
    const real_t weighed_17 = TB_MOMENT_WEIGHT * structure[17];
    const real_t t0 = structure[3] + (structure[2] + (structure[0] + structure[1]));
    const real_t rest_0 = wrench[0] - TB_TENSION_MIN * (structure[5] + (structure[4] + t0));
    const real_t t1 = structure[9] + (structure[8] + (structure[6] + structure[7]));
    const real_t t2 = TB_TENSION_MIN * (structure[11] + (structure[10] + t1));
    const real_t rest_1 = wrench[1] - t2;
    const real_t t3 = structure[15] + (structure[14] + (structure[12] + structure[13]));
    const real_t t4 = TB_TENSION_MIN * (structure[17] + (structure[16] + t3));
    const real_t rest_2 = TB_MOMENT_WEIGHT * (wrench[2] - t4);
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
    weighed[12] = weighed_12;
    weighed[13] = weighed_13;
    weighed[14] = weighed_14;
    weighed[15] = weighed_15;
    weighed[16] = weighed_16;
    weighed[17] = weighed_17;
    rest[0] = rest_0;
    rest[1] = rest_1;
    rest[2] = rest_2;
    least[0] = TB_C(1e+30);
    best[0] = TB_C(0.0);
    best[1] = TB_C(0.0);
    best[2] = TB_C(0.0);
    cables[0] = -TB_C(1.0);
    cables[1] = -TB_C(1.0);
    cables[2] = -TB_C(1.0);
    return TB_OK;
}

/* One subset. */
static tb_status tb_reduced_matrix_tension_visit(const real_t chosen[9], const real_t numbers[3],
    const real_t rest[3], real_t least[1], real_t best[3], real_t cables[3])
{
    const real_t t0 = chosen[4] * chosen[8] - chosen[7] * chosen[5];
    const real_t t1 = chosen[7] * chosen[2] - chosen[8] * chosen[1];
    const real_t t2 = chosen[5] * chosen[1] - chosen[4] * chosen[2];
    const real_t t3 = t0 * chosen[0] + t1 * chosen[3] + t2 * chosen[6];
    const real_t t4 = TB_C(1.0) / t3;
    const real_t t5 = (rest[0] * t0 + rest[1] * t1 + rest[2] * t2) * t4;
    const real_t t6 = rest[0] * (chosen[5] * chosen[6] - chosen[8] * chosen[3]);
    const real_t t7 = rest[1] * (chosen[8] * chosen[0] - chosen[2] * chosen[6]);
    const real_t t8 = rest[2] * (chosen[2] * chosen[3] - chosen[5] * chosen[0]);
    const real_t t9 = t4 * (t6 + t7 + t8);
    const real_t t10 = rest[0] * (chosen[7] * chosen[3] - chosen[4] * chosen[6]);
    const real_t t11 = rest[1] * (chosen[1] * chosen[6] - chosen[7] * chosen[0]);
    const real_t t12 = rest[2] * (chosen[4] * chosen[0] - chosen[1] * chosen[3]);
    const real_t t13 = t4 * (t10 + t11 + t12);
    const real_t t14 = t13 + (t5 + t9);
    const real_t t15 = TB_C(16.0) * TB_EPSILON * (TB_ABS(t14) + TB_C(18.0));
    const real_t t16 = TB_ABS(t3) - tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t17 = TB_C(0.0) <= tb_min(tb_min(tb_min(t5, t9), t13) + t15, t16);
    const real_t t18 = t17 ? t14 : TB_C(1e+30);
    const bool t19 = t18 < least[0];
    const real_t least_0 = t19 ? t18 : least[0];
    const real_t best_0 = t19 ? t5 : best[0];
    const real_t best_1 = t19 ? t9 : best[1];
    const real_t best_2 = t19 ? t13 : best[2];
    const real_t cables_0 = t19 ? numbers[0] : cables[0];
    const real_t cables_1 = t19 ? numbers[1] : cables[1];
    const real_t cables_2 = t19 ? numbers[2] : cables[2];
    least[0] = least_0;
    best[0] = best_0;
    best[1] = best_1;
    best[2] = best_2;
    cables[0] = cables_0;
    cables[1] = cables_1;
    cables[2] = cables_2;
    return TB_OK;
}

/* After the last subset. */
static tb_status tb_reduced_matrix_tension_finish(const real_t least[1], const real_t best[3],
    const real_t cables[3], real_t tension[6])
{
    const real_t t0 = tb_max(best[0], TB_C(0.0));
    const real_t t1 = tb_max(best[1], TB_C(0.0));
    const real_t t2 = (cables[0] == TB_C(0.0) ? t0 : TB_C(0.0)) + (TB_C(0.0) == cables[1] ? t1
        : TB_C(0.0));
    const real_t t3 = tb_max(best[2], TB_C(0.0));
    const real_t tension_0 = TB_TENSION_MIN + (t2 + (TB_C(0.0) == cables[2] ? t3 : TB_C(0.0)));
    const real_t t4 = (cables[0] == TB_C(1.0) ? t0 : TB_C(0.0)) + (cables[1] == TB_C(1.0) ? t1
        : TB_C(0.0));
    const real_t tension_1 = TB_TENSION_MIN + (t4 + (cables[2] == TB_C(1.0) ? t3 : TB_C(0.0)));
    const real_t t5 = (cables[0] == TB_C(2.0) ? t0 : TB_C(0.0)) + (cables[1] == TB_C(2.0) ? t1
        : TB_C(0.0));
    const real_t tension_2 = TB_TENSION_MIN + (t5 + (cables[2] == TB_C(2.0) ? t3 : TB_C(0.0)));
    const real_t t6 = (TB_C(3.0) == cables[0] ? t0 : TB_C(0.0)) + (TB_C(3.0) == cables[1] ? t1
        : TB_C(0.0));
    const real_t tension_3 = TB_TENSION_MIN + (t6 + (TB_C(3.0) == cables[2] ? t3 : TB_C(0.0)));
    const real_t t7 = (cables[0] == TB_C(4.0) ? t0 : TB_C(0.0)) + (cables[1] == TB_C(4.0) ? t1
        : TB_C(0.0));
    const real_t tension_4 = TB_TENSION_MIN + (t7 + (cables[2] == TB_C(4.0) ? t3 : TB_C(0.0)));
    const real_t t8 = (cables[0] == TB_C(5.0) ? t0 : TB_C(0.0)) + (cables[1] == TB_C(5.0) ? t1
        : TB_C(0.0));
    const real_t tension_5 = TB_TENSION_MIN + (t8 + (cables[2] == TB_C(5.0) ? t3 : TB_C(0.0)));
    const bool t9 = !(least[0] < TB_C(1e+30));
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    tension[4] = tension_4;
    tension[5] = tension_5;
    return t9 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_reduced_matrix_tension(const real_t structure[18], const real_t wrench[3],
    real_t tension[6])
{
    static const unsigned char subsets[20][3] = {{0,1,2}, {0,1,3}, {0,1,4}, {0,1,5}, {0,2,3},
        {0,2,4}, {0,2,5}, {0,3,4}, {0,3,5}, {0,4,5}, {1,2,3}, {1,2,4}, {1,2,5}, {1,3,4},
        {1,3,5}, {1,4,5}, {2,3,4}, {2,3,5}, {2,4,5}, {3,4,5}};
    real_t weighed[18];
    real_t rest[3];
    real_t least[1];
    real_t best[3];
    real_t cables[3];
    const tb_status status = tb_reduced_matrix_tension_begin(structure, wrench, weighed, rest,
        least, best, cables);
    if (status != TB_OK) {
        tension[0] = TB_TENSION_MIN;
        tension[1] = TB_TENSION_MIN;
        tension[2] = TB_TENSION_MIN;
        tension[3] = TB_TENSION_MIN;
        tension[4] = TB_TENSION_MIN;
        tension[5] = TB_TENSION_MIN;
        return status;
    }
    for (int k = 0; k < 20; k++) {
        real_t chosen[9];
        real_t numbers[3];
        for (int j = 0; j < 3; j++) {
            const int number = subsets[k][j];
            for (int i = 0; i < 3; i++) {
                chosen[3 * i + j] = weighed[6 * i + number];
            }
            numbers[j] = (real_t)number;
        }
        (void)tb_reduced_matrix_tension_visit(chosen, numbers, rest, least, best, cables);
    }
    return tb_reduced_matrix_tension_finish(least, best, cables, tension);
}

/* Refuses with a status: weighed is 0; most is 0; least is 0; size is 0 N. */
static tb_status tb_refuse_largest_tensions_eq12_begin(tb_status status, real_t weighed[18],
    real_t most[6], real_t least[1], real_t size[1])
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
    most[0] = TB_C(0.0);
    most[1] = TB_C(0.0);
    most[2] = TB_C(0.0);
    most[3] = TB_C(0.0);
    most[4] = TB_C(0.0);
    most[5] = TB_C(0.0);
    least[0] = TB_C(0.0);
    size[0] = TB_C(0.0);
    return status;
}

/* Before the first subset. */
static tb_status tb_largest_tensions_eq12_begin(const real_t structure[18], const real_t force[1],
    real_t weighed[18], real_t most[6], real_t least[1], real_t size[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) + TB_ABS(structure[10]) + TB_ABS(structure[11]) +
              TB_ABS(structure[12]) + TB_ABS(structure[13]) + TB_ABS(structure[14]) +
              TB_ABS(structure[15]) + TB_ABS(structure[16]) + TB_ABS(structure[17]) <=
              TB_C(72.0)
          && force[0] >= TB_C(0.0) && force[0] <= TB_C(10000.0))) {
        return tb_refuse_largest_tensions_eq12_begin(TB_OUT_OF_DOMAIN, weighed, most, least, size);
    }
    const real_t weighed_12 = TB_MOMENT_WEIGHT * structure[12];
    const real_t weighed_13 = TB_MOMENT_WEIGHT * structure[13];
    const real_t weighed_14 = TB_MOMENT_WEIGHT * structure[14];
    const real_t weighed_15 = TB_MOMENT_WEIGHT * structure[15];
    const real_t weighed_16 = TB_MOMENT_WEIGHT * structure[16];
    const real_t weighed_17 = TB_MOMENT_WEIGHT * structure[17];
    const real_t t0 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const real_t t1 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t2 = t1 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t3 = t2 + structure[4] * structure[4] + structure[5] * structure[5];
    const real_t t4 = TB_SQRT(t3);
    const real_t t5 = TB_COPYSIGN(t4, structure[0]);
    const real_t t6 = structure[0] + t5;
    const real_t t7 = structure[6] * t6 + structure[1] * structure[7] + structure[2] *
        structure[8];
    const real_t t8 = t7 + structure[3] * structure[9] + structure[4] * structure[10];
    const real_t t9 = TB_C(1.0) / (t4 * (t4 + TB_ABS(structure[0])));
    const real_t t10 = (t8 + structure[5] * structure[11]) * t9;
    const real_t t11 = structure[7] - structure[1] * t10;
    const real_t t12 = structure[8] - structure[2] * t10;
    const real_t t13 = structure[9] - structure[3] * t10;
    const real_t t14 = structure[10] - structure[4] * t10;
    const real_t t15 = structure[11] - structure[5] * t10;
    const real_t t16 = t11 * t11 + t12 * t12 + t13 * t13 + t14 * t14 + t15 * t15;
    const real_t t17 = TB_SQRT(t16);
    const real_t t18 = TB_COPYSIGN(t17, t11);
    const real_t t19 = weighed_12 * t6 + structure[1] * weighed_13 + structure[2] * weighed_14;
    const real_t t20 = t19 + structure[3] * weighed_15 + structure[4] * weighed_16;
    const real_t t21 = t9 * (t20 + structure[5] * weighed_17);
    const real_t t22 = weighed_14 - structure[2] * t21;
    const real_t t23 = (t11 + t18) * (weighed_13 - structure[1] * t21) + t12 * t22;
    const real_t t24 = weighed_15 - structure[3] * t21;
    const real_t t25 = weighed_16 - structure[4] * t21;
    const real_t t26 = weighed_17 - structure[5] * t21;
    const real_t t27 = (t23 + t13 * t24 + t14 * t25 + t15 * t26) * (TB_C(1.0) / (t17 * (t17 +
        TB_ABS(t11))));
    const real_t t28 = t22 - t12 * t27;
    const real_t t29 = t24 - t13 * t27;
    const real_t t30 = t25 - t14 * t27;
    const real_t t31 = t26 - t15 * t27;
    const real_t t32 = TB_SQRT(t28 * t28 + t29 * t29 + t30 * t30 + t31 * t31);
    const bool t33 = t0 < TB_ABS(t5) && t0 < TB_ABS(t18) && t0 < TB_ABS(TB_COPYSIGN(t32, t28));
    const bool t34 = !t33;
    if (t34) {
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
    weighed[12] = weighed_12;
    weighed[13] = weighed_13;
    weighed[14] = weighed_14;
    weighed[15] = weighed_15;
    weighed[16] = weighed_16;
    weighed[17] = weighed_17;
    most[0] = TB_C(0.0);
    most[1] = TB_C(0.0);
    most[2] = TB_C(0.0);
    most[3] = TB_C(0.0);
    most[4] = TB_C(0.0);
    most[5] = TB_C(0.0);
    least[0] = TB_C(1e+30);
    size[0] = force[0];
    return TB_OK;
}

/* One subset. */
static tb_status tb_largest_tensions_eq12_visit(const real_t chosen[6], const real_t numbers[2],
    const real_t weighed[18], real_t most[6], real_t least[1])
{
    const real_t t0 = chosen[2] * chosen[5] - chosen[4] * chosen[3];
    const real_t t1 = chosen[4] * chosen[1] - chosen[5] * chosen[0];
    const real_t t2 = chosen[3] * chosen[0] - chosen[2] * chosen[1];
    const real_t t3 = chosen[0] * chosen[0] + chosen[2] * chosen[2] + chosen[4] * chosen[4];
    const real_t t4 = (t0 * chosen[0] + chosen[2] * t1 + chosen[4] * t2) / t3;
    const real_t t5 = t0 - chosen[0] * t4;
    const real_t t6 = t1 - chosen[2] * t4;
    const real_t t7 = t2 - chosen[4] * t4;
    const real_t t8 = TB_SQRT(t5 * t5 + t6 * t6 + t7 * t7);
    const real_t t9 = TB_C(1.0) / t8;
    const real_t t10 = t5 * t9;
    const real_t t11 = t6 * t9;
    const real_t t12 = TB_SQRT(t10 * t10 + t11 * t11);
    const bool t13 = (numbers[0] == TB_C(0.0)) || (TB_C(0.0) == numbers[1]);
    const real_t t14 = t7 * t9;
    const real_t t15 = t10 * weighed[0] + t11 * weighed[6] + t14 * weighed[12];
    const real_t t16 = t13 ? TB_C(1e+30) : TB_ABS(t13 ? TB_C(0.0) : t15);
    const real_t most_0 = tb_max(most[0], t12 / t16);
    const bool t17 = (TB_C(1.0) == numbers[0]) || (TB_C(1.0) == numbers[1]);
    const real_t t18 = t10 * weighed[1] + t11 * weighed[7] + t14 * weighed[13];
    const real_t t19 = t17 ? TB_C(1e+30) : TB_ABS(t17 ? TB_C(0.0) : t18);
    const real_t most_1 = tb_max(most[1], t12 / t19);
    const bool t20 = (numbers[0] == TB_C(2.0)) || (numbers[1] == TB_C(2.0));
    const real_t t21 = t10 * weighed[2] + t11 * weighed[8] + t14 * weighed[14];
    const real_t t22 = t20 ? TB_C(1e+30) : TB_ABS(t20 ? TB_C(0.0) : t21);
    const real_t most_2 = tb_max(most[2], t12 / t22);
    const bool t23 = (numbers[0] == TB_C(3.0)) || (numbers[1] == TB_C(3.0));
    const real_t t24 = t10 * weighed[3] + t11 * weighed[9] + t14 * weighed[15];
    const real_t t25 = t23 ? TB_C(1e+30) : TB_ABS(t23 ? TB_C(0.0) : t24);
    const real_t most_3 = tb_max(most[3], t12 / t25);
    const bool t26 = (numbers[0] == TB_C(4.0)) || (numbers[1] == TB_C(4.0));
    const real_t t27 = t10 * weighed[4] + t11 * weighed[10] + t14 * weighed[16];
    const real_t t28 = t26 ? TB_C(1e+30) : TB_ABS(t26 ? TB_C(0.0) : t27);
    const real_t most_4 = tb_max(most[4], t12 / t28);
    const bool t29 = (numbers[0] == TB_C(5.0)) || (numbers[1] == TB_C(5.0));
    const real_t t30 = t10 * weighed[5] + t11 * weighed[11] + t14 * weighed[17];
    const real_t t31 = t29 ? TB_C(1e+30) : TB_ABS(t29 ? TB_C(0.0) : t30);
    const real_t most_5 = tb_max(most[5], t12 / t31);
    const bool t32 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON) < t8;
    real_t t33;
    if (t32) {
        const real_t t34 = tb_min(tb_min(tb_min(tb_min(t16, t19), t22), t25), t28);
        t33 = tb_min(t34, t31);
    } else {
        t33 = TB_C(0.0);
    }
    const real_t least_0 = tb_min(least[0], t33);
    most[0] = most_0;
    most[1] = most_1;
    most[2] = most_2;
    most[3] = most_3;
    most[4] = most_4;
    most[5] = most_5;
    least[0] = least_0;
    return TB_OK;
}

/* After the last subset. */
static tb_status tb_largest_tensions_eq12_finish(const real_t most[6], const real_t least[1],
    const real_t size[1], real_t tension[6])
{
    const real_t tension_0 = size[0] * most[0];
    const real_t tension_1 = size[0] * most[1];
    const real_t tension_2 = size[0] * most[2];
    const real_t tension_3 = size[0] * most[3];
    const real_t tension_4 = size[0] * most[4];
    const real_t tension_5 = size[0] * most[5];
    const bool t0 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON) < least[0];
    const bool t1 = !t0;
    if (t1) {
        tension[0] = TB_C(0.0);
        tension[1] = TB_C(0.0);
        tension[2] = TB_C(0.0);
        tension[3] = TB_C(0.0);
        tension[4] = TB_C(0.0);
        tension[5] = TB_C(0.0);
        return TB_SINGULAR;
    }
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    tension[4] = tension_4;
    tension[5] = tension_5;
    return TB_OK;
}

tb_status tb_largest_tensions_eq12(const real_t structure[18], const real_t force[1],
    real_t tension[6])
{
    static const unsigned char subsets[15][2] = {{0,1}, {0,2}, {0,3}, {0,4}, {0,5}, {1,2},
        {1,3}, {1,4}, {1,5}, {2,3}, {2,4}, {2,5}, {3,4}, {3,5}, {4,5}};
    real_t weighed[18];
    real_t most[6];
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
        return status;
    }
    for (int k = 0; k < 15; k++) {
        real_t chosen[6];
        real_t numbers[2];
        for (int j = 0; j < 2; j++) {
            const int number = subsets[k][j];
            for (int i = 0; i < 3; i++) {
                chosen[2 * i + j] = weighed[6 * i + number];
            }
            numbers[j] = (real_t)number;
        }
        (void)tb_largest_tensions_eq12_visit(chosen, numbers, weighed, most, least);
    }
    return tb_largest_tensions_eq12_finish(most, least, size, tension);
}

/* Refuses with a status: weighed is 0; most is 0 N; size is 0 N. */
static tb_status tb_refuse_largest_tension_begin(tb_status status, real_t weighed[18],
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
    most[0] = TB_C(0.0);
    size[0] = TB_C(0.0);
    return status;
}

/* Before the first subset. */
static tb_status tb_largest_tension_begin(const real_t structure[18], const real_t force[1],
    real_t weighed[18], real_t most[1], real_t size[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) + TB_ABS(structure[10]) + TB_ABS(structure[11]) +
              TB_ABS(structure[12]) + TB_ABS(structure[13]) + TB_ABS(structure[14]) +
              TB_ABS(structure[15]) + TB_ABS(structure[16]) + TB_ABS(structure[17]) <=
              TB_C(72.0)
          && force[0] >= TB_C(0.0) && force[0] <= TB_C(10000.0))) {
        return tb_refuse_largest_tension_begin(TB_OUT_OF_DOMAIN, weighed, most, size);
    }
    const real_t weighed_12 = TB_MOMENT_WEIGHT * structure[12];
    const real_t weighed_13 = TB_MOMENT_WEIGHT * structure[13];
    const real_t weighed_14 = TB_MOMENT_WEIGHT * structure[14];
    const real_t weighed_15 = TB_MOMENT_WEIGHT * structure[15];
    const real_t weighed_16 = TB_MOMENT_WEIGHT * structure[16];
    const real_t weighed_17 = TB_MOMENT_WEIGHT * structure[17];
    const real_t t0 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const real_t t1 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t2 = t1 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t3 = t2 + structure[4] * structure[4] + structure[5] * structure[5];
    const real_t t4 = TB_SQRT(t3);
    const real_t t5 = TB_COPYSIGN(t4, structure[0]);
    const real_t t6 = structure[0] + t5;
    const real_t t7 = structure[6] * t6 + structure[1] * structure[7] + structure[2] *
        structure[8];
    const real_t t8 = t7 + structure[3] * structure[9] + structure[4] * structure[10];
    const real_t t9 = TB_C(1.0) / (t4 * (t4 + TB_ABS(structure[0])));
    const real_t t10 = (t8 + structure[5] * structure[11]) * t9;
    const real_t t11 = structure[7] - structure[1] * t10;
    const real_t t12 = structure[8] - structure[2] * t10;
    const real_t t13 = structure[9] - structure[3] * t10;
    const real_t t14 = structure[10] - structure[4] * t10;
    const real_t t15 = structure[11] - structure[5] * t10;
    const real_t t16 = t11 * t11 + t12 * t12 + t13 * t13 + t14 * t14 + t15 * t15;
    const real_t t17 = TB_SQRT(t16);
    const real_t t18 = TB_COPYSIGN(t17, t11);
    const real_t t19 = weighed_12 * t6 + structure[1] * weighed_13 + structure[2] * weighed_14;
    const real_t t20 = t19 + structure[3] * weighed_15 + structure[4] * weighed_16;
    const real_t t21 = t9 * (t20 + structure[5] * weighed_17);
    const real_t t22 = weighed_14 - structure[2] * t21;
    const real_t t23 = (t11 + t18) * (weighed_13 - structure[1] * t21) + t12 * t22;
    const real_t t24 = weighed_15 - structure[3] * t21;
    const real_t t25 = weighed_16 - structure[4] * t21;
    const real_t t26 = weighed_17 - structure[5] * t21;
    const real_t t27 = (t23 + t13 * t24 + t14 * t25 + t15 * t26) * (TB_C(1.0) / (t17 * (t17 +
        TB_ABS(t11))));
    const real_t t28 = t22 - t12 * t27;
    const real_t t29 = t24 - t13 * t27;
    const real_t t30 = t25 - t14 * t27;
    const real_t t31 = t26 - t15 * t27;
    const real_t t32 = TB_SQRT(t28 * t28 + t29 * t29 + t30 * t30 + t31 * t31);
    const bool t33 = t0 < TB_ABS(t5) && t0 < TB_ABS(t18) && t0 < TB_ABS(TB_COPYSIGN(t32, t28));
    const bool t34 = !t33;
    if (t34) {
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
    weighed[12] = weighed_12;
    weighed[13] = weighed_13;
    weighed[14] = weighed_14;
    weighed[15] = weighed_15;
    weighed[16] = weighed_16;
    weighed[17] = weighed_17;
    most[0] = TB_TENSION_MIN;
    size[0] = force[0];
    return TB_OK;
}

/* One subset. */
static tb_status tb_largest_tension_visit(const real_t chosen[6], const real_t numbers[2],
    const real_t weighed[18], real_t most[1], const real_t size[1])
{
    const real_t t0 = chosen[2] * chosen[5] - chosen[4] * chosen[3];
    const real_t t1 = chosen[4] * chosen[1] - chosen[5] * chosen[0];
    const real_t t2 = chosen[3] * chosen[0] - chosen[2] * chosen[1];
    const real_t t3 = chosen[0] * chosen[0] + chosen[2] * chosen[2] + chosen[4] * chosen[4];
    const real_t t4 = (t0 * chosen[0] + chosen[2] * t1 + chosen[4] * t2) / t3;
    const real_t t5 = t0 - chosen[0] * t4;
    const real_t t6 = t1 - chosen[2] * t4;
    const real_t t7 = t2 - chosen[4] * t4;
    const real_t t8 = TB_SQRT(t5 * t5 + t6 * t6 + t7 * t7);
    real_t most_0;
    if (TB_C(16.0) * TB_EPSILON < t8) {
        const real_t t9 = TB_EPSILON * TB_C(64.0);
        const bool t10 = (numbers[0] == TB_C(0.0)) || (TB_C(0.0) == numbers[1]);
        const real_t t11 = TB_C(1.0) / t8;
        const real_t t12 = t5 * t11;
        const real_t t13 = t6 * t11;
        const real_t t14 = t7 * t11;
        const real_t t15 = t12 * weighed[0] + t13 * weighed[6] + t14 * weighed[12];
        const real_t t16 = t10 ? TB_C(0.0) : t15;
        const bool t17 = (numbers[0] == TB_C(1.0)) || (numbers[1] == TB_C(1.0));
        const real_t t18 = t12 * weighed[1] + t13 * weighed[7] + t14 * weighed[13];
        const real_t t19 = t17 ? TB_C(0.0) : t18;
        const bool t20 = (numbers[0] == TB_C(2.0)) || (numbers[1] == TB_C(2.0));
        const real_t t21 = t12 * weighed[2] + t13 * weighed[8] + t14 * weighed[14];
        const real_t t22 = t20 ? TB_C(0.0) : t21;
        const bool t23 = (numbers[0] == TB_C(3.0)) || (numbers[1] == TB_C(3.0));
        const real_t t24 = t12 * weighed[3] + t13 * weighed[9] + t14 * weighed[15];
        const real_t t25 = t23 ? TB_C(0.0) : t24;
        const real_t t26 = TB_ABS(t16) + TB_ABS(t19) + TB_ABS(t22) + TB_ABS(t25);
        const bool t27 = (numbers[0] == TB_C(4.0)) || (numbers[1] == TB_C(4.0));
        const real_t t28 = t12 * weighed[4] + t13 * weighed[10] + t14 * weighed[16];
        const real_t t29 = t27 ? TB_C(0.0) : t28;
        const bool t30 = (numbers[0] == TB_C(5.0)) || (numbers[1] == TB_C(5.0));
        const real_t t31 = t12 * weighed[5] + t13 * weighed[11] + t14 * weighed[17];
        const real_t t32 = t30 ? TB_C(0.0) : t31;
        const real_t t33 = t26 + TB_ABS(t29) + TB_ABS(t32);
        const real_t t34 = t32 + (t29 + (t25 + (t22 + (t16 + t19))));
        const real_t t35 = (t33 + t34) * TB_C(0.5);
        const real_t t36 = size[0] * TB_SQRT(t12 * t12 + t13 * t13);
        const real_t t37 = TB_C(0.5) * (t33 - t34);
        const real_t t38 = t36 + TB_TENSION_MIN * t37;
        real_t t39;
        if (t9 < t35) {
            t39 = t38 / t35;
        } else {
            t39 = t9 < t38 ? TB_C(1e+30) : TB_C(0.0);
        }
        const real_t t40 = t36 + TB_TENSION_MIN * t35;
        real_t t41;
        if (t9 < t37) {
            t41 = t40 / t37;
        } else {
            t41 = t9 < t40 ? TB_C(1e+30) : TB_C(0.0);
        }
        most_0 = tb_max(most[0], tb_max(t39, t41));
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

tb_status tb_largest_tension(const real_t structure[18], const real_t force[1],
    real_t tension[1])
{
    static const unsigned char subsets[15][2] = {{0,1}, {0,2}, {0,3}, {0,4}, {0,5}, {1,2},
        {1,3}, {1,4}, {1,5}, {2,3}, {2,4}, {2,5}, {3,4}, {3,5}, {4,5}};
    real_t weighed[18];
    real_t most[1];
    real_t size[1];
    const tb_status status = tb_largest_tension_begin(structure, force, weighed, most, size);
    if (status != TB_OK) {
        tension[0] = TB_C(0.0);
        return status;
    }
    for (int k = 0; k < 15; k++) {
        real_t chosen[6];
        real_t numbers[2];
        for (int j = 0; j < 2; j++) {
            const int number = subsets[k][j];
            for (int i = 0; i < 3; i++) {
                chosen[2 * i + j] = weighed[6 * i + number];
            }
            numbers[j] = (real_t)number;
        }
        (void)tb_largest_tension_visit(chosen, numbers, weighed, most, size);
    }
    return tb_largest_tension_finish(most, tension);
}

