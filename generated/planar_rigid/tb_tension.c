/* Regenerate: turnbuckle generate machines/planar_rigid.toml --out <this folder>
 * Machine 95fa38e7104ced7a, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_tension.h"
#include "tb_machine.h"

/* Refuses with a status: pivot is 0; side is 0; moving is 0; push is 0 N. */
static tb_status tb_refuse_least_norm_tension_begin(tb_status status, real_t pivot[1],
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
static tb_status tb_least_norm_tension_begin(const real_t structure[18], const real_t wrench[3],
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
        return tb_refuse_least_norm_tension_begin(TB_OUT_OF_DOMAIN, pivot, side, moving, push);
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
        return tb_refuse_least_norm_tension_begin(TB_SINGULAR, pivot, side, moving, push);
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
static tb_status tb_least_norm_tension_step(const real_t structure[18], const real_t wrench[3],
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
    const real_t t79 = TB_C(0.0) < side[0] ? TB_TENSION_MAX : (side[0] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t80 = TB_C(0.0) < side[1] ? TB_TENSION_MAX : (side[1] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t81 = TB_C(0.0) < side[2] ? TB_TENSION_MAX : (side[2] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t82 = structure[0] * t79 + structure[1] * t80 + structure[2] * t81;
    const real_t t83 = TB_C(0.0) < side[3] ? TB_TENSION_MAX : (side[3] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t84 = TB_C(0.0) < side[4] ? TB_TENSION_MAX : (side[4] < TB_C(0.0) ?
        TB_TENSION_MIN : TB_C(0.0));
    const real_t t85 = TB_C(0.0) < side[5] ? TB_TENSION_MAX : (side[5] < TB_C(0.0) ?
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
    const real_t t95 = t43 * t79 + t44 * t80 + t42 * t81 + t47 * t83 + t49 * t84;
    const real_t t96 = TB_MOMENT_WEIGHT * wrench[2] - (t95 + t52 * t85);
    const real_t t97 = (t0 ? t43 : TB_C(0.0)) - t21 * t54;
    const real_t t98 = t94 * ((t96 + t87 * t97 + t92 * t93) * t94);
    const real_t t99 = t89 * (t92 + t93 * t98);
    const real_t t100 = t78 * (t87 + t88 * t99 + t97 * t98);
    const real_t t101 = structure[3] * t100 + structure[9] * t99 + t47 * t98;
    const real_t t102 = TB_C(0.0) < t7 ? tb_max(TB_TENSION_MIN - t101, t101 - TB_TENSION_MAX) :
        -TB_C(1.0);
    const real_t t103 = structure[4] * t100 + structure[10] * t99 + t49 * t98;
    const real_t t104 = TB_C(0.0) < t9 ? tb_max(TB_TENSION_MIN - t103, t103 - TB_TENSION_MAX) :
        -TB_C(1.0);
    const real_t t105 = structure[5] * t100 + structure[11] * t99 + t52 * t98;
    const real_t t106 = TB_C(0.0) < t11 ? tb_max(TB_TENSION_MIN - t105, t105 - TB_TENSION_MAX)
        : -TB_C(1.0);
    const real_t t107 = structure[0] * t100 + structure[6] * t99 + t43 * t98;
    const real_t t108 = TB_C(0.0) < t1 ? tb_max(TB_TENSION_MIN - t107, t107 - TB_TENSION_MAX) :
        -TB_C(1.0);
    const real_t t109 = structure[1] * t100 + structure[7] * t99 + t44 * t98;
    const real_t t110 = TB_C(0.0) < t3 ? tb_max(TB_TENSION_MIN - t109, t109 - TB_TENSION_MAX) :
        -TB_C(1.0);
    const real_t t111 = structure[2] * t100 + structure[8] * t99 + t42 * t98;
    const real_t t112 = TB_C(0.0) < t5 ? tb_max(TB_TENSION_MIN - t111, t111 - TB_TENSION_MAX) :
        -TB_C(1.0);
    real_t t113, t114, t115, t116, t117, t118;
    if (t77) {
        t113 = TB_C(3.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
        t114 = moving[0] == TB_C(4.0) ? TB_C(1.0) : TB_C(0.0);
        t115 = moving[0] == TB_C(5.0) ? TB_C(1.0) : TB_C(0.0);
        t116 = TB_C(0.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
        t117 = TB_C(1.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
        t118 = moving[0] == TB_C(2.0) ? TB_C(1.0) : TB_C(0.0);
    } else {
        t113 = t102;
        t114 = t104;
        t115 = t106;
        t116 = t108;
        t117 = t110;
        t118 = t112;
    }
    const real_t t119 = tb_max(t113, t114);
    const real_t t120 = tb_max(t116, t117);
    const bool t121 = tb_max(t119, t115) <= tb_max(t120, t118);
    real_t t122, t123, t124, t125, t126;
    if (t121) {
        const bool t127 = t118 <= t120;
        real_t t128, t129, t130, t131, t132;
        if (t127) {
            const bool t133 = t117 <= t116;
            t128 = t133 ? TB_C(0.0) : TB_C(1.0);
            t129 = t133 ? structure[0] : structure[1];
            t130 = t133 ? structure[6] : structure[7];
            t131 = t133 ? t43 : t44;
            t132 = t133 ? t107 : t109;
        } else {
            t128 = TB_C(2.0);
            t129 = structure[2];
            t130 = structure[8];
            t131 = t42;
            t132 = t111;
        }
        t122 = t128;
        t123 = t129;
        t124 = t130;
        t125 = t131;
        t126 = t132;
    } else {
        const bool t134 = t115 <= t119;
        real_t t135, t136, t137, t138, t139;
        if (t134) {
            const bool t140 = t114 <= t113;
            t135 = t140 ? TB_C(3.0) : TB_C(4.0);
            t136 = t140 ? structure[3] : structure[4];
            t137 = t140 ? structure[9] : structure[10];
            t138 = t140 ? t47 : t49;
            t139 = t140 ? t101 : t103;
        } else {
            t135 = TB_C(5.0);
            t136 = structure[5];
            t137 = structure[11];
            t138 = t52;
            t139 = t105;
        }
        t122 = t135;
        t123 = t136;
        t124 = t137;
        t125 = t138;
        t126 = t139;
    }
    const real_t t141 = t78 * t123;
    const real_t t142 = t89 * (t124 + t88 * t141);
    const real_t t143 = t94 * (t94 * (t125 + t97 * t141 + t93 * t142));
    const real_t t144 = t89 * (t142 + t93 * t143);
    const real_t t145 = t78 * (t141 + t88 * t144 + t97 * t143);
    const real_t t146 = structure[0] * t145 + structure[6] * t144 + t43 * t143;
    const real_t t147 = (TB_C(0.0) == t122 ? TB_C(1.0) : TB_C(0.0)) - t146;
    const real_t t148 = structure[1] * t145 + structure[7] * t144 + t44 * t143;
    const real_t t149 = (TB_C(1.0) == t122 ? TB_C(1.0) : TB_C(0.0)) - t148;
    const real_t t150 = (t0 ? (t0 ? t147 * t147 : TB_C(0.0)) : TB_C(0.0)) + (t2 ? (t2 ? t149 *
        t149 : TB_C(0.0)) : TB_C(0.0));
    const real_t t151 = structure[2] * t145 + structure[8] * t144 + t42 * t143;
    const real_t t152 = (TB_C(2.0) == t122 ? TB_C(1.0) : TB_C(0.0)) - t151;
    const real_t t153 = t150 + (t4 ? (t4 ? t152 * t152 : TB_C(0.0)) : TB_C(0.0));
    const real_t t154 = structure[3] * t145 + structure[9] * t144 + t47 * t143;
    const real_t t155 = (TB_C(3.0) == t122 ? TB_C(1.0) : TB_C(0.0)) - t154;
    const real_t t156 = t153 + (t6 ? (t6 ? t155 * t155 : TB_C(0.0)) : TB_C(0.0));
    const real_t t157 = structure[4] * t145 + structure[10] * t144 + t49 * t143;
    const real_t t158 = (TB_C(4.0) == t122 ? TB_C(1.0) : TB_C(0.0)) - t157;
    const real_t t159 = t156 + (t8 ? (t8 ? t158 * t158 : TB_C(0.0)) : TB_C(0.0));
    const real_t t160 = structure[5] * t145 + structure[11] * t144 + t52 * t143;
    const real_t t161 = (TB_C(5.0) == t122 ? TB_C(1.0) : TB_C(0.0)) - t160;
    const real_t t162 = t10 ? (t10 ? t161 * t161 : TB_C(0.0)) : TB_C(0.0);
    const real_t t163 = t159 + t162;
    const bool t164 = TB_C(3.0) < t1 + t3 + t5 + t7 + t9 + t11 && t76 * t76 < t163;
    const real_t t165 = t126 + t163 * push[0];
    const bool t166 = t165 < TB_TENSION_MIDDLE;
    real_t t167;
    if (t164) {
        const real_t t168 = tb_max(t166 ? TB_TENSION_MIN - t165 : t165 - TB_TENSION_MAX,
            TB_C(0.0));
        t167 = t168 * (TB_C(1.0) / t163);
    } else {
        t167 = TB_C(1e+30);
    }
    const real_t t169 = t166 ? TB_C(1.0) : -TB_C(1.0);
    const real_t t170 = side[0] * (t146 * t169);
    real_t t171;
    if (t76 < t170) {
        const real_t t172 = tb_max(side[0] * (t107 - t146 * push[0] - t79), TB_C(0.0));
        t171 = t172 / t170;
    } else {
        t171 = TB_C(1e+30);
    }
    const real_t t173 = side[1] * (t148 * t169);
    real_t t174;
    if (t76 < t173) {
        const real_t t175 = tb_max(side[1] * (t109 - t148 * push[0] - t80), TB_C(0.0));
        t174 = t175 / t173;
    } else {
        t174 = TB_C(1e+30);
    }
    const real_t t176 = side[2] * (t151 * t169);
    real_t t177;
    if (t76 < t176) {
        const real_t t178 = tb_max(side[2] * (t111 - t151 * push[0] - t81), TB_C(0.0));
        t177 = t178 / t176;
    } else {
        t177 = TB_C(1e+30);
    }
    const real_t t179 = side[3] * (t154 * t169);
    real_t t180;
    if (t76 < t179) {
        const real_t t181 = tb_max(side[3] * (t101 - t154 * push[0] - t83), TB_C(0.0));
        t180 = t181 / t179;
    } else {
        t180 = TB_C(1e+30);
    }
    const real_t t182 = side[4] * (t157 * t169);
    real_t t183;
    if (t76 < t182) {
        const real_t t184 = tb_max(side[4] * (t103 - t157 * push[0] - t84), TB_C(0.0));
        t183 = t184 / t182;
    } else {
        t183 = TB_C(1e+30);
    }
    const real_t t185 = tb_min(tb_min(tb_min(tb_min(t171, t174), t177), t180), t183);
    const real_t t186 = side[5] * (t160 * t169);
    real_t t187;
    if (t76 < t186) {
        const real_t t188 = tb_max(side[5] * (t105 - t160 * push[0] - t85), TB_C(0.0));
        t187 = t188 / t186;
    } else {
        t187 = TB_C(1e+30);
    }
    const real_t t189 = tb_min(t185, t187);
    const bool t190 = t167 <= t189;
    const real_t t191 = tb_max(tb_max(tb_max(tb_max(t108, t110), t112), t102), t104);
    const bool t192 = tb_max(t191, t106) <= t75 * (TB_EPSILON * TB_C(80.0));
    const bool t193 = (!t77 && t192) || !(tb_min(t167, t189) < TB_C(1e+30));
    const real_t t194 = t190 && !t193 ? t122 : -TB_C(1.0);
    const real_t t195 = -t169;
    real_t t196;
    if (t190 || t193) {
        t196 = -TB_C(1.0);
    } else {
        const real_t t197 = -t180;
        const real_t t198 = -t183;
        const real_t t199 = tb_max(t197, t198);
        const real_t t200 = -t187;
        const real_t t201 = -t171;
        const real_t t202 = -t174;
        const real_t t203 = tb_max(t201, t202);
        const real_t t204 = -t177;
        real_t t205;
        if (tb_max(t199, t200) <= tb_max(t203, t204)) {
            const real_t t206 = t204 <= t203 ? (t202 <= t201 ? TB_C(0.0) : TB_C(1.0)) :
                TB_C(2.0);
            t205 = t206;
        } else {
            const real_t t207 = t200 <= t199 ? (t198 <= t197 ? TB_C(3.0) : TB_C(4.0)) :
                TB_C(5.0);
            t205 = t207;
        }
        t196 = t205;
    }
    const real_t side_0 = TB_C(0.0) == t194 ? t195 : (TB_C(0.0) == t196 ? TB_C(0.0) : side[0]);
    const real_t side_1 = TB_C(1.0) == t194 ? t195 : (TB_C(1.0) == t196 ? TB_C(0.0) : side[1]);
    const real_t side_2 = TB_C(2.0) == t194 ? t195 : (TB_C(2.0) == t196 ? TB_C(0.0) : side[2]);
    const real_t side_3 = TB_C(3.0) == t194 ? t195 : (TB_C(3.0) == t196 ? TB_C(0.0) : side[3]);
    const real_t side_4 = TB_C(4.0) == t194 ? t195 : (TB_C(4.0) == t196 ? TB_C(0.0) : side[4]);
    const real_t side_5 = TB_C(5.0) == t194 ? t195 : (TB_C(5.0) == t196 ? TB_C(0.0) : side[5]);
    const real_t moving_0 = t190 ? -TB_C(1.0) : t122;
    const real_t push_0 = t190 ? TB_C(0.0) : push[0] + t169 * t189;
    const real_t done_0 = t193 ? TB_C(1.0) : TB_C(0.0);
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
static tb_status tb_least_norm_tension_finish(const real_t structure[18], const real_t wrench[3],
    const real_t pivot[1], const real_t side[6], real_t tension[6], real_t delivered[3],
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
    const real_t t9 = wrench[0] - t8;
    const real_t t10 = t0 ? (t0 ? structure[0] * structure[0] : TB_C(0.0)) : TB_C(0.0);
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
    const real_t t22 = t0 ? structure[0] : TB_C(0.0);
    const real_t t23 = TB_COPYSIGN(t21, t22);
    const real_t t24 = TB_C(1.0) / t23;
    const real_t t25 = t9 * t24;
    const real_t t26 = t22 + t23;
    const real_t t27 = t11 ? (t11 ? structure[1] * structure[7] : TB_C(0.0)) : TB_C(0.0);
    const real_t t28 = t13 ? (t13 ? structure[2] * structure[8] : TB_C(0.0)) : TB_C(0.0);
    const real_t t29 = (t0 ? structure[6] * t26 : TB_C(0.0)) + t27 + t28;
    const real_t t30 = t15 ? (t15 ? structure[3] * structure[9] : TB_C(0.0)) : TB_C(0.0);
    const real_t t31 = t17 ? (t17 ? structure[4] * structure[10] : TB_C(0.0)) : TB_C(0.0);
    const real_t t32 = t19 ? (t19 ? structure[5] * structure[11] : TB_C(0.0)) : TB_C(0.0);
    const real_t t33 = TB_C(1.0) / (t21 * (t21 + TB_ABS(t22)));
    const real_t t34 = (t29 + t30 + t31 + t32) * t33;
    const real_t t35 = (t0 ? structure[6] : TB_C(0.0)) - t26 * t34;
    const real_t t36 = t1 * structure[6] + t2 * structure[7] + t3 * structure[8];
    const real_t t37 = t36 + t5 * structure[9] + t6 * structure[10] + t7 * structure[11];
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
    const real_t t62 = (t0 ? t26 * t54 : TB_C(0.0)) + t55 + t57 + t59 + t61;
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
    const real_t t79 = t1 * t54 + t2 * t53 + t3 * t56 + t5 * t58 + t6 * t60;
    const real_t t80 = t78 - (t79 + t7 * t63);
    const real_t t81 = (t0 ? t54 : TB_C(0.0)) - t26 * t65;
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
    const real_t t96 = (t0 ? structure[0] * t94 : TB_C(0.0)) + (t11 ? structure[1] * t95 :
        TB_C(0.0));
    const real_t t97 = structure[2] * t93 + structure[8] * t92 + t56 * t91;
    const real_t t98 = structure[3] * t93 + structure[9] * t92 + t58 * t91;
    const real_t t99 = t96 + (t13 ? structure[2] * t97 : TB_C(0.0)) + (t15 ? structure[3] * t98
        : TB_C(0.0));
    const real_t t100 = structure[4] * t93 + structure[10] * t92 + t60 * t91;
    const real_t t101 = structure[5] * t93 + structure[11] * t92 + t63 * t91;
    const real_t t102 = t99 + (t17 ? structure[4] * t100 : TB_C(0.0)) + (t19 ? structure[5] *
        t101 : TB_C(0.0));
    const real_t t103 = t24 * (t9 - t102);
    const real_t t104 = (t0 ? structure[6] * t94 : TB_C(0.0)) + (t11 ? structure[7] * t95 :
        TB_C(0.0));
    const real_t t105 = t104 + (t13 ? structure[8] * t97 : TB_C(0.0)) + (t15 ? structure[9] *
        t98 : TB_C(0.0));
    const real_t t106 = t105 + (t17 ? structure[10] * t100 : TB_C(0.0)) + (t19 ? structure[11]
        * t101 : TB_C(0.0));
    const real_t t107 = t51 * (t38 - t106 + t35 * t103);
    const real_t t108 = (t0 ? t54 * t94 : TB_C(0.0)) + (t11 ? t53 * t95 : TB_C(0.0));
    const real_t t109 = t108 + (t13 ? t56 * t97 : TB_C(0.0)) + (t15 ? t58 * t98 : TB_C(0.0));
    const real_t t110 = t109 + (t17 ? t60 * t100 : TB_C(0.0)) + (t19 ? t63 * t101 : TB_C(0.0));
    const real_t t111 = t90 * (t90 * (t80 - t110 + t81 * t103 + t77 * t107));
    const real_t t112 = t51 * (t107 + t77 * t111);
    const real_t t113 = t24 * (t103 + t35 * t112 + t81 * t111);
    const real_t t114 = structure[0] * t113 + structure[6] * t112 + t54 * t111;
    const real_t t115 = t94 + t114;
    const real_t tension_0 = tb_min(tb_max(t0 ? t115 : t1, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t t116 = structure[1] * t113 + structure[7] * t112 + t53 * t111;
    const real_t t117 = t95 + t116;
    const real_t tension_1 = tb_min(tb_max(t11 ? t117 : t2, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t t118 = structure[2] * t113 + structure[8] * t112 + t56 * t111;
    const real_t t119 = t97 + t118;
    const real_t tension_2 = tb_min(tb_max(t13 ? t119 : t3, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t t120 = structure[3] * t113 + structure[9] * t112 + t58 * t111;
    const real_t t121 = t98 + t120;
    const real_t tension_3 = tb_min(tb_max(t15 ? t121 : t5, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t t122 = structure[4] * t113 + structure[10] * t112 + t60 * t111;
    const real_t t123 = t100 + t122;
    const real_t tension_4 = tb_min(tb_max(t17 ? t123 : t6, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t t124 = structure[5] * t113 + structure[11] * t112 + t63 * t111;
    const real_t t125 = t101 + t124;
    const real_t tension_5 = tb_min(tb_max(t19 ? t125 : t7, TB_TENSION_MIN), TB_TENSION_MAX);
    const real_t t126 = structure[0] * tension_0 + structure[1] * tension_1;
    const real_t t127 = t126 + structure[2] * tension_2 + structure[3] * tension_3;
    const real_t delivered_0 = t127 + structure[4] * tension_4 + structure[5] * tension_5;
    const real_t t128 = structure[6] * tension_0 + structure[7] * tension_1;
    const real_t t129 = t128 + structure[8] * tension_2 + structure[9] * tension_3;
    const real_t delivered_1 = t129 + structure[10] * tension_4 + structure[11] * tension_5;
    const real_t t130 = structure[12] * tension_0 + structure[13] * tension_1;
    const real_t t131 = t130 + structure[14] * tension_2 + structure[15] * tension_3;
    const real_t delivered_2 = t131 + structure[16] * tension_4 + structure[17] * tension_5;
    const real_t t132 = tb_max(side[0] * (t1 - t115), side[1] * (t2 - t117));
    const real_t t133 = tb_max(tb_max(t132, side[2] * (t3 - t119)), side[3] * (t5 - t121));
    const real_t t134 = tb_max(tb_max(t133, side[4] * (t6 - t123)), side[5] * (t7 - t125));
    const real_t t135 = tb_min(tb_min(TB_ABS(t23), TB_ABS(t50)), TB_ABS(t89));
    const real_t t136 = tb_max(TB_C(0.0), t134) * tb_min(TB_C(1.0), t135);
    const real_t t137 = tb_max(tb_max(TB_ABS(t93), TB_ABS(t92)), TB_ABS(t91));
    const real_t t138 = TB_TENSION_MAX * t136 * (TB_C(1.0) / tb_max(TB_TENSION_MAX, t137));
    const real_t t139 = tb_max(tb_max(t138, TB_ABS(delivered_0 - wrench[0])),
        TB_ABS(delivered_1 - wrench[1]));
    const real_t t140 = t54 * tension_0 + t53 * tension_1 + t56 * tension_2;
    const real_t t141 = t140 + t58 * tension_3 + t60 * tension_4 + t63 * tension_5;
    const real_t kkt_residual_0 = tb_max(t139, TB_ABS(t141 - t78));
    const real_t t142 = TB_C(1920.0) * TB_EPSILON / tb_min(TB_C(1.0), pivot[0]);
    const bool t143 = !(kkt_residual_0 <= tb_min(t142, TB_C(0.01)));
    if (t143) {
        tension[0] = TB_TENSION_MIN;
        tension[1] = TB_TENSION_MIN;
        tension[2] = TB_TENSION_MIN;
        tension[3] = TB_TENSION_MIN;
        tension[4] = TB_TENSION_MIN;
        tension[5] = TB_TENSION_MIN;
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        delivered[2] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return TB_INACCURATE;
    }
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    tension[4] = tension_4;
    tension[5] = tension_5;
    delivered[0] = delivered_0;
    delivered[1] = delivered_1;
    delivered[2] = delivered_2;
    kkt_residual[0] = kkt_residual_0;
    return TB_OK;
}

tb_status tb_least_norm_tension(const real_t structure[18], const real_t wrench[3],
    real_t tension[6], real_t delivered[3], real_t kkt_residual[1])
{
    real_t pivot[1];
    real_t side[6];
    real_t moving[1];
    real_t push[1];
    real_t done[1] = {TB_C(0.0)};
    tb_status status = tb_least_norm_tension_begin(structure, wrench, pivot, side, moving,
        push);
    for (int steps = 0; steps < 30 && status == TB_OK && !(done[0] > TB_C(0.0)); steps++) {
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
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        delivered[2] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return status;
    }
    return tb_least_norm_tension_finish(structure, wrench, pivot, side, tension, delivered,
        kkt_residual);
}

/* Refuses with a status: pivot is 0; side is 0; moving is 0; push is 0 N. */
static tb_status tb_refuse_distribute_tension_paper_begin(tb_status status, real_t pivot[1],
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
static tb_status tb_distribute_tension_paper_begin(const real_t structure[18], const real_t wrench[3],
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
        return tb_refuse_distribute_tension_paper_begin(TB_OUT_OF_DOMAIN, pivot, side, moving, push);
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
        return tb_refuse_distribute_tension_paper_begin(TB_SINGULAR, pivot, side, moving, push);
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
static tb_status tb_distribute_tension_paper_step(const real_t structure[18], const real_t wrench[3],
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
static tb_status tb_distribute_tension_paper_finish(const real_t structure[18], const real_t wrench[3],
    const real_t pivot[1], const real_t side[6], real_t tension[6], real_t delivered[3],
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
    real_t tension_0, tension_1, tension_2, tension_3, tension_4, tension_5, kkt_residual_0;
    if (t150) {
        tension_0 = tb_min(t134, TB_TENSION_MAX);
        tension_1 = tb_min(t135, TB_TENSION_MAX);
        tension_2 = tb_min(t136, TB_TENSION_MAX);
        tension_3 = tb_min(t138, TB_TENSION_MAX);
        tension_4 = tb_min(t139, TB_TENSION_MAX);
        tension_5 = tb_min(t140, TB_TENSION_MAX);
        kkt_residual_0 = t147;
    } else {
        tension_0 = TB_TENSION_MIN;
        tension_1 = TB_TENSION_MIN;
        tension_2 = TB_TENSION_MIN;
        tension_3 = TB_TENSION_MIN;
        tension_4 = TB_TENSION_MIN;
        tension_5 = TB_TENSION_MIN;
        kkt_residual_0 = TB_C(0.0);
    }
    const bool t151 = !t150;
    const real_t t152 = structure[0] * tension_0 + structure[1] * tension_1;
    const real_t t153 = t152 + structure[2] * tension_2 + structure[3] * tension_3;
    const real_t delivered_0 = t153 + structure[4] * tension_4 + structure[5] * tension_5;
    const real_t t154 = structure[6] * tension_0 + structure[7] * tension_1;
    const real_t t155 = t154 + structure[8] * tension_2 + structure[9] * tension_3;
    const real_t delivered_1 = t155 + structure[10] * tension_4 + structure[11] * tension_5;
    const real_t t156 = structure[12] * tension_0 + structure[13] * tension_1;
    const real_t t157 = t156 + structure[14] * tension_2 + structure[15] * tension_3;
    const real_t delivered_2 = t157 + structure[16] * tension_4 + structure[17] * tension_5;
    const bool t158 = TB_TENSION_MAX < t134 || TB_TENSION_MAX < t135 || TB_TENSION_MAX < t136;
    const bool t159 = t158 || TB_TENSION_MAX < t138 || TB_TENSION_MAX < t139 || TB_TENSION_MAX
        < t140;
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    tension[4] = tension_4;
    tension[5] = tension_5;
    delivered[0] = delivered_0;
    delivered[1] = delivered_1;
    delivered[2] = delivered_2;
    kkt_residual[0] = kkt_residual_0;
    return (t151 || t159) ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_distribute_tension_paper(const real_t structure[18], const real_t wrench[3],
    real_t tension[6], real_t delivered[3], real_t kkt_residual[1])
{
    real_t pivot[1];
    real_t side[6];
    real_t moving[1];
    real_t push[1];
    real_t done[1] = {TB_C(0.0)};
    tb_status status = tb_distribute_tension_paper_begin(structure, wrench, pivot, side,
        moving, push);
    for (int steps = 0; steps < 30 && status == TB_OK && !(done[0] > TB_C(0.0)); steps++) {
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
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        delivered[2] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return status;
    }
    return tb_distribute_tension_paper_finish(structure, wrench, pivot, side, tension,
        delivered, kkt_residual);
}

/* One vertex of the feasible wrenches. */
static tb_status tb_served_wrench_closest_begin(const real_t structure[18], const real_t wrench[3],
    real_t points[12], real_t weight[4], real_t used[4], real_t offset[3])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) + TB_ABS(structure[10]) + TB_ABS(structure[11]) +
              TB_ABS(structure[12]) + TB_ABS(structure[13]) + TB_ABS(structure[14]) +
              TB_ABS(structure[15]) + TB_ABS(structure[16]) + TB_ABS(structure[17]) <=
              TB_C(72.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) + TB_ABS(wrench[2]) <= TB_C(180000.0))) {
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
        weight[0] = TB_C(0.0);
        weight[1] = TB_C(0.0);
        weight[2] = TB_C(0.0);
        weight[3] = TB_C(0.0);
        used[0] = TB_C(0.0);
        used[1] = TB_C(0.0);
        used[2] = TB_C(0.0);
        used[3] = TB_C(0.0);
        offset[0] = TB_C(0.0);
        offset[1] = TB_C(0.0);
        offset[2] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = structure[0] + structure[1] + structure[2] + structure[3];
    const real_t t1 = TB_TENSION_MIDDLE * (t0 + structure[4] + structure[5]) - wrench[0];
    const real_t t2 = structure[6] + structure[7] + structure[8] + structure[9];
    const real_t t3 = TB_TENSION_MIDDLE * (t2 + structure[10] + structure[11]) - wrench[1];
    const real_t t4 = TB_MOMENT_WEIGHT * structure[12];
    const real_t t5 = TB_MOMENT_WEIGHT * structure[13];
    const real_t t6 = TB_MOMENT_WEIGHT * structure[14];
    const real_t t7 = TB_MOMENT_WEIGHT * structure[15];
    const real_t t8 = TB_MOMENT_WEIGHT * structure[16];
    const real_t t9 = TB_MOMENT_WEIGHT * structure[17];
    const real_t t10 = TB_MOMENT_WEIGHT * wrench[2];
    const real_t t11 = TB_TENSION_MIDDLE * (t4 + t5 + t6 + t7 + t8 + t9) - t10;
    const bool t12 = structure[0] * t1 + structure[6] * t3 + t4 * t11 < TB_C(0.0);
    const real_t t13 = t12 ? TB_TENSION_MAX : TB_TENSION_MIN;
    const bool t14 = structure[1] * t1 + structure[7] * t3 + t5 * t11 < TB_C(0.0);
    const real_t t15 = t14 ? TB_TENSION_MAX : TB_TENSION_MIN;
    const bool t16 = structure[2] * t1 + structure[8] * t3 + t6 * t11 < TB_C(0.0);
    const real_t t17 = t16 ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t18 = structure[0] * t13 + structure[1] * t15 + structure[2] * t17;
    const bool t19 = structure[3] * t1 + structure[9] * t3 + t7 * t11 < TB_C(0.0);
    const real_t t20 = t19 ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t21 = structure[4] * t1 + structure[10] * t3 + t8 * t11;
    const real_t t22 = t21 < TB_C(0.0) ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t23 = structure[5] * t1 + structure[11] * t3 + t9 * t11;
    const real_t t24 = t23 < TB_C(0.0) ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t25 = t18 + structure[3] * t20 + structure[4] * t22 + structure[5] * t24;
    const real_t points_0 = t25 - wrench[0];
    const real_t t26 = structure[6] * t13 + structure[7] * t15 + structure[8] * t17;
    const real_t t27 = t26 + structure[9] * t20 + structure[10] * t22 + structure[11] * t24;
    const real_t points_1 = t27 - wrench[1];
    const real_t t28 = t4 * t13 + t5 * t15 + t6 * t17 + t7 * t20 + t8 * t22;
    const real_t points_2 = t28 + t9 * t24 - t10;
    points[0] = points_0;
    points[1] = points_1;
    points[2] = points_2;
    points[3] = TB_C(0.0);
    points[4] = TB_C(0.0);
    points[5] = TB_C(0.0);
    points[6] = TB_C(0.0);
    points[7] = TB_C(0.0);
    points[8] = TB_C(0.0);
    points[9] = TB_C(0.0);
    points[10] = TB_C(0.0);
    points[11] = TB_C(0.0);
    weight[0] = TB_C(1.0);
    weight[1] = TB_C(0.0);
    weight[2] = TB_C(0.0);
    weight[3] = TB_C(0.0);
    used[0] = TB_C(1.0);
    used[1] = TB_C(0.0);
    used[2] = TB_C(0.0);
    used[3] = TB_C(0.0);
    offset[0] = points_0;
    offset[1] = points_1;
    offset[2] = points_2;
    return TB_OK;
}

/* A vertex of the feasible wrenches joins or is dropped. */
static tb_status tb_served_wrench_closest_step(const real_t structure[18], const real_t wrench[3],
    real_t points[12], real_t weight[4], real_t used[4], real_t offset[3], real_t done[1])
{
    const bool t0 = TB_C(0.0) < used[0];
    const bool t1 = TB_C(0.0) < used[2];
    const real_t t2 = t1 ? weight[2] : -TB_C(1.0);
    const bool t3 = TB_C(0.0) < used[3];
    const real_t t4 = t3 ? weight[3] : -TB_C(1.0);
    const real_t t5 = t0 ? weight[0] : -TB_C(1.0);
    const bool t6 = TB_C(0.0) < used[1];
    const real_t t7 = t6 ? weight[1] : -TB_C(1.0);
    const bool t8 = tb_max(t2, t4) <= tb_max(t5, t7);
    real_t t9, t10, t11, t12;
    if (t8) {
        const bool t13 = t7 <= t5;
        t9 = t13 ? TB_C(0.0) : TB_C(1.0);
        t10 = t13 ? points[0] : points[3];
        t11 = t13 ? points[1] : points[4];
        t12 = t13 ? points[2] : points[5];
    } else {
        const bool t14 = t4 <= t2;
        t9 = t14 ? TB_C(2.0) : TB_C(3.0);
        t10 = t14 ? points[6] : points[9];
        t11 = t14 ? points[7] : points[10];
        t12 = t14 ? points[8] : points[11];
    }
    const bool t15 = TB_C(0.0) == t9;
    const real_t t16 = used[0] * (points[0] - t10);
    const real_t t17 = used[0] * (points[1] - t11);
    const real_t t18 = used[0] * (points[2] - t12);
    const real_t t19 = t15 ? TB_C(0.0) : t16 * t16 + t17 * t17 + t18 * t18;
    const real_t t20 = t15 ? TB_C(0.0) : t19;
    const bool t21 = TB_C(0.0) < t20;
    const real_t t22 = TB_SQRT(t20);
    const real_t t23 = TB_C(1.0) / t22;
    const real_t t24 = t16 * t23;
    const real_t t25 = t17 * t23;
    const real_t t26 = t18 * t23;
    const real_t t27 = t10 * t24 + t11 * t25 + t12 * t26;
    const bool t28 = TB_C(1.0) == t9;
    const real_t t29 = used[1] * (points[3] - t10);
    const real_t t30 = used[1] * (points[4] - t11);
    const real_t t31 = used[1] * (points[5] - t12);
    const real_t t32 = t24 * t29 + t25 * t30 + t26 * t31;
    const real_t t33 = t28 ? TB_C(0.0) : (t15 ? TB_C(0.0) : (t21 ? t24 * t32 : TB_C(0.0)));
    const real_t t34 = (t28 ? TB_C(0.0) : t29) + (t15 ? TB_C(0.0) : (t21 ? -t33 : TB_C(0.0)));
    const real_t t35 = t28 ? TB_C(0.0) : (t15 ? TB_C(0.0) : (t21 ? t25 * t32 : TB_C(0.0)));
    const real_t t36 = (t28 ? TB_C(0.0) : t30) + (t15 ? TB_C(0.0) : (t21 ? -t35 : TB_C(0.0)));
    const real_t t37 = t28 ? TB_C(0.0) : (t15 ? TB_C(0.0) : (t21 ? t26 * t32 : TB_C(0.0)));
    const real_t t38 = (t28 ? TB_C(0.0) : t31) + (t15 ? TB_C(0.0) : (t21 ? -t37 : TB_C(0.0)));
    const real_t t39 = t34 * t34 + t36 * t36 + t38 * t38;
    const bool t40 = TB_C(0.0) < t39;
    const real_t t41 = TB_SQRT(t39);
    const real_t t42 = TB_C(1.0) / t41;
    const real_t t43 = t34 * t42;
    const real_t t44 = t36 * t42;
    const real_t t45 = t38 * t42;
    const bool t46 = TB_C(2.0) == t9;
    const real_t t47 = used[2] * (points[6] - t10);
    const real_t t48 = used[2] * (points[7] - t11);
    const real_t t49 = used[2] * (points[8] - t12);
    const real_t t50 = t24 * t47 + t25 * t48 + t26 * t49;
    const real_t t51 = t46 ? TB_C(0.0) : (t15 ? TB_C(0.0) : (t21 ? t24 * t50 : TB_C(0.0)));
    const real_t t52 = (t46 ? TB_C(0.0) : t47) + (t15 ? TB_C(0.0) : (t21 ? -t51 : TB_C(0.0)));
    const real_t t53 = t46 ? TB_C(0.0) : (t15 ? TB_C(0.0) : (t21 ? t25 * t50 : TB_C(0.0)));
    const real_t t54 = (t46 ? TB_C(0.0) : t48) + (t15 ? TB_C(0.0) : (t21 ? -t53 : TB_C(0.0)));
    const real_t t55 = t46 ? TB_C(0.0) : (t15 ? TB_C(0.0) : (t21 ? t26 * t50 : TB_C(0.0)));
    const real_t t56 = (t46 ? TB_C(0.0) : t49) + (t15 ? TB_C(0.0) : (t21 ? -t55 : TB_C(0.0)));
    const real_t t57 = t43 * t52 + t44 * t54 + t45 * t56;
    const real_t t58 = t52 + (t40 ? -(t40 ? t43 * t57 : TB_C(0.0)) : TB_C(0.0));
    const real_t t59 = t54 + (t40 ? -(t40 ? t44 * t57 : TB_C(0.0)) : TB_C(0.0));
    const real_t t60 = t56 + (t40 ? -(t40 ? t45 * t57 : TB_C(0.0)) : TB_C(0.0));
    const real_t t61 = t58 * t58 + t59 * t59 + t60 * t60;
    const bool t62 = TB_C(0.0) < t61;
    const real_t t63 = TB_SQRT(t61);
    const real_t t64 = TB_C(1.0) / t63;
    const real_t t65 = t58 * t64;
    const real_t t66 = t59 * t64;
    const real_t t67 = t60 * t64;
    const bool t68 = TB_C(3.0) == t9;
    const real_t t69 = used[3] * (points[9] - t10);
    const real_t t70 = used[3] * (points[10] - t11);
    const real_t t71 = used[3] * (points[11] - t12);
    const real_t t72 = t24 * t69 + t25 * t70 + t26 * t71;
    const real_t t73 = t68 ? TB_C(0.0) : (t15 ? TB_C(0.0) : (t21 ? t24 * t72 : TB_C(0.0)));
    const real_t t74 = (t68 ? TB_C(0.0) : t69) + (t15 ? TB_C(0.0) : (t21 ? -t73 : TB_C(0.0)));
    const real_t t75 = t68 ? TB_C(0.0) : (t15 ? TB_C(0.0) : (t21 ? t25 * t72 : TB_C(0.0)));
    const real_t t76 = (t68 ? TB_C(0.0) : t70) + (t15 ? TB_C(0.0) : (t21 ? -t75 : TB_C(0.0)));
    const real_t t77 = t68 ? TB_C(0.0) : (t15 ? TB_C(0.0) : (t21 ? t26 * t72 : TB_C(0.0)));
    const real_t t78 = (t68 ? TB_C(0.0) : t71) + (t15 ? TB_C(0.0) : (t21 ? -t77 : TB_C(0.0)));
    const real_t t79 = t43 * t74 + t44 * t76 + t45 * t78;
    const real_t t80 = t74 + (t40 ? -(t40 ? t43 * t79 : TB_C(0.0)) : TB_C(0.0));
    const real_t t81 = t76 + (t40 ? -(t40 ? t44 * t79 : TB_C(0.0)) : TB_C(0.0));
    const real_t t82 = t78 + (t40 ? -(t40 ? t45 * t79 : TB_C(0.0)) : TB_C(0.0));
    const real_t t83 = t65 * t80 + t66 * t81 + t67 * t82;
    const real_t t84 = t80 + (t62 ? -(t62 ? t65 * t83 : TB_C(0.0)) : TB_C(0.0));
    const real_t t85 = t81 + (t62 ? -(t62 ? t66 * t83 : TB_C(0.0)) : TB_C(0.0));
    const real_t t86 = t82 + (t62 ? -(t62 ? t67 * t83 : TB_C(0.0)) : TB_C(0.0));
    const real_t t87 = t84 * t84 + t85 * t85 + t86 * t86;
    const bool t88 = TB_C(0.0) < t87;
    const real_t t89 = TB_SQRT(t87);
    const real_t t90 = TB_C(1.0) / t89;
    const real_t t91 = t84 * t90;
    const real_t t92 = t85 * t90;
    const real_t t93 = t86 * t90;
    const real_t t94 = t88 ? t10 * t91 + t11 * t92 + t12 * t93 : TB_C(0.0);
    const real_t t95 = t94 * (TB_C(1.0) / (t88 ? t89 : TB_C(1.0)));
    const real_t t96 = t62 ? t10 * t65 + t11 * t66 + t12 * t67 - t83 * t95 : TB_C(0.0);
    const real_t t97 = t96 * (TB_C(1.0) / (t62 ? t63 : TB_C(1.0)));
    const real_t t98 = t10 * t43 + t11 * t44 + t12 * t45 - t57 * t97 - t79 * t95;
    const real_t t99 = (t40 ? t98 : TB_C(0.0)) * (TB_C(1.0) / (t40 ? t41 : TB_C(1.0)));
    const real_t t100 = t15 ? TB_C(0.0) : (t21 ? -(t32 * t99) : TB_C(0.0));
    const real_t t101 = (t15 ? TB_C(0.0) : (t21 ? t27 : TB_C(0.0))) + (t28 ? TB_C(0.0) : t100);
    const real_t t102 = t15 ? TB_C(0.0) : (t21 ? -(t50 * t97) : TB_C(0.0));
    const real_t t103 = t15 ? TB_C(0.0) : (t21 ? -(t72 * t95) : TB_C(0.0));
    const real_t t104 = t101 + (t46 ? TB_C(0.0) : t102) + (t68 ? TB_C(0.0) : t103);
    const real_t t105 = used[0] * (t104 * (TB_C(1.0) / (t21 ? t22 : TB_C(1.0))));
    const real_t t106 = t15 ? TB_C(0.0) : -t105;
    const real_t t107 = t28 ? TB_C(0.0) : -(used[1] * t99);
    const real_t t108 = t46 ? TB_C(0.0) : -(used[2] * t97);
    const real_t t109 = t68 ? TB_C(0.0) : -(used[3] * t95);
    const real_t t110 = TB_C(1.0) - (t106 + t107 + t108 + t109);
    const real_t t111 = t15 ? t110 : t106;
    real_t t112;
    if (t0 && t111 <= TB_C(0.0)) {
        t112 = weight[0] / (weight[0] - t111);
    } else {
        t112 = TB_C(1e+30);
    }
    const real_t t113 = t28 ? t110 : t107;
    real_t t114;
    if (t6 && t113 <= TB_C(0.0)) {
        t114 = weight[1] / (weight[1] - t113);
    } else {
        t114 = TB_C(1e+30);
    }
    const real_t t115 = t46 ? t110 : t108;
    real_t t116;
    if (t1 && t115 <= TB_C(0.0)) {
        t116 = weight[2] / (weight[2] - t115);
    } else {
        t116 = TB_C(1e+30);
    }
    const real_t t117 = t68 ? t110 : t109;
    real_t t118;
    if (t3 && t117 <= TB_C(0.0)) {
        t118 = weight[3] / (weight[3] - t117);
    } else {
        t118 = TB_C(1e+30);
    }
    const real_t t119 = tb_min(tb_min(tb_min(t112, t114), t116), t118);
    const bool t120 = t119 < TB_C(1e+30);
    const real_t t121 = -(t15 ? TB_C(0.0) : (t21 ? t24 * t27 : TB_C(0.0)));
    const real_t t122 = t10 + (t15 ? TB_C(0.0) : (t21 ? t121 : TB_C(0.0)));
    const real_t t123 = -(t15 ? TB_C(0.0) : (t21 ? t25 * t27 : TB_C(0.0)));
    const real_t t124 = t11 + (t15 ? TB_C(0.0) : (t21 ? t123 : TB_C(0.0)));
    const real_t t125 = -(t15 ? TB_C(0.0) : (t21 ? t26 * t27 : TB_C(0.0)));
    const real_t t126 = t12 + (t15 ? TB_C(0.0) : (t21 ? t125 : TB_C(0.0)));
    const real_t t127 = t43 * t122 + t44 * t124 + t45 * t126;
    const real_t t128 = t40 ? -(t40 ? t43 * t127 : TB_C(0.0)) : TB_C(0.0);
    const real_t t129 = t122 + t128;
    const real_t t130 = t40 ? -(t40 ? t44 * t127 : TB_C(0.0)) : TB_C(0.0);
    const real_t t131 = t124 + t130;
    const real_t t132 = t40 ? -(t40 ? t45 * t127 : TB_C(0.0)) : TB_C(0.0);
    const real_t t133 = t126 + t132;
    const real_t t134 = t65 * t129 + t66 * t131 + t67 * t133;
    const real_t t135 = t62 ? -(t62 ? t65 * t134 : TB_C(0.0)) : TB_C(0.0);
    const real_t t136 = t129 + t135;
    const real_t t137 = t62 ? -(t62 ? t66 * t134 : TB_C(0.0)) : TB_C(0.0);
    const real_t t138 = t131 + t137;
    const real_t t139 = t62 ? -(t62 ? t67 * t134 : TB_C(0.0)) : TB_C(0.0);
    const real_t t140 = t133 + t139;
    const real_t t141 = t91 * t136 + t92 * t138 + t93 * t140;
    const real_t t142 = t88 ? -(t88 ? t91 * t141 : TB_C(0.0)) : TB_C(0.0);
    const real_t t143 = t136 + t142;
    const real_t t144 = t88 ? -(t88 ? t92 * t141 : TB_C(0.0)) : TB_C(0.0);
    const real_t t145 = t138 + t144;
    const real_t t146 = t88 ? -(t88 ? t93 * t141 : TB_C(0.0)) : TB_C(0.0);
    const real_t t147 = t140 + t146;
    const real_t t148 = t24 * t143 + t25 * t145 + t26 * t147;
    const real_t t149 = -(t15 ? TB_C(0.0) : (t21 ? t24 * t148 : TB_C(0.0)));
    const real_t t150 = t143 + (t15 ? TB_C(0.0) : (t21 ? t149 : TB_C(0.0)));
    const real_t t151 = -(t15 ? TB_C(0.0) : (t21 ? t25 * t148 : TB_C(0.0)));
    const real_t t152 = t145 + (t15 ? TB_C(0.0) : (t21 ? t151 : TB_C(0.0)));
    const real_t t153 = -(t15 ? TB_C(0.0) : (t21 ? t26 * t148 : TB_C(0.0)));
    const real_t t154 = t147 + (t15 ? TB_C(0.0) : (t21 ? t153 : TB_C(0.0)));
    const real_t t155 = t43 * t150 + t44 * t152 + t45 * t154;
    const real_t t156 = t40 ? -(t40 ? t43 * t155 : TB_C(0.0)) : TB_C(0.0);
    const real_t t157 = t150 + t156;
    const real_t t158 = t40 ? -(t40 ? t44 * t155 : TB_C(0.0)) : TB_C(0.0);
    const real_t t159 = t152 + t158;
    const real_t t160 = t40 ? -(t40 ? t45 * t155 : TB_C(0.0)) : TB_C(0.0);
    const real_t t161 = t154 + t160;
    const real_t t162 = t65 * t157 + t66 * t159 + t67 * t161;
    const real_t t163 = t62 ? -(t62 ? t65 * t162 : TB_C(0.0)) : TB_C(0.0);
    const real_t t164 = t157 + t163;
    const real_t t165 = t62 ? -(t62 ? t66 * t162 : TB_C(0.0)) : TB_C(0.0);
    const real_t t166 = t159 + t165;
    const real_t t167 = t62 ? -(t62 ? t67 * t162 : TB_C(0.0)) : TB_C(0.0);
    const real_t t168 = t161 + t167;
    const real_t t169 = t91 * t164 + t92 * t166 + t93 * t168;
    const real_t t170 = t88 ? -(t88 ? t91 * t169 : TB_C(0.0)) : TB_C(0.0);
    const real_t offset_0 = t164 + t170;
    const real_t t171 = t88 ? -(t88 ? t92 * t169 : TB_C(0.0)) : TB_C(0.0);
    const real_t offset_1 = t166 + t171;
    const real_t t172 = offset_0 * structure[0] + structure[6] * offset_1;
    const real_t t173 = TB_MOMENT_WEIGHT * structure[12];
    const real_t t174 = t88 ? -(t88 ? t93 * t169 : TB_C(0.0)) : TB_C(0.0);
    const real_t offset_2 = t168 + t174;
    const real_t t175 = t172 + t173 * offset_2 < TB_C(0.0) ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t176 = offset_0 * structure[1] + offset_1 * structure[7];
    const real_t t177 = TB_MOMENT_WEIGHT * structure[13];
    const real_t t178 = t176 + offset_2 * t177 < TB_C(0.0) ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t179 = offset_0 * structure[2] + offset_1 * structure[8];
    const real_t t180 = TB_MOMENT_WEIGHT * structure[14];
    const real_t t181 = t179 + offset_2 * t180 < TB_C(0.0) ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t182 = structure[0] * t175 + structure[1] * t178 + structure[2] * t181;
    const real_t t183 = offset_0 * structure[3] + offset_1 * structure[9];
    const real_t t184 = TB_MOMENT_WEIGHT * structure[15];
    const real_t t185 = t183 + offset_2 * t184 < TB_C(0.0) ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t186 = offset_0 * structure[4] + offset_1 * structure[10];
    const real_t t187 = TB_MOMENT_WEIGHT * structure[16];
    const real_t t188 = t186 + offset_2 * t187 < TB_C(0.0) ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t189 = offset_0 * structure[5] + offset_1 * structure[11];
    const real_t t190 = TB_MOMENT_WEIGHT * structure[17];
    const real_t t191 = t189 + offset_2 * t190 < TB_C(0.0) ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t192 = t182 + structure[3] * t185 + structure[4] * t188 + structure[5] * t191;
    const real_t t193 = t192 - wrench[0];
    const real_t t194 = structure[6] * t175 + structure[7] * t178 + structure[8] * t181;
    const real_t t195 = t194 + structure[9] * t185 + structure[10] * t188;
    const real_t t196 = t195 + structure[11] * t191 - wrench[1];
    const real_t t197 = offset_0 * (offset_0 - t193) + offset_1 * (offset_1 - t196);
    const real_t t198 = t173 * t175 + t177 * t178 + t180 * t181 + t184 * t185;
    const real_t t199 = TB_MOMENT_WEIGHT * wrench[2];
    const real_t t200 = t198 + t187 * t188 + t190 * t191 - t199;
    const real_t t201 = TB_ABS(wrench[0]) + TB_ABS(wrench[1]) + TB_ABS(t199);
    const real_t t202 = offset_0 * offset_0 + offset_1 * offset_1 + offset_2 * offset_2;
    const real_t t203 = TB_SQRT(t202);
    const real_t t204 = TB_C(64.0) * TB_EPSILON * (TB_C(60.0) + t201) * t203;
    const bool t205 = t197 + offset_2 * (offset_2 - t200) <= t204 || t203 <= TB_EPSILON *
        TB_C(960.0);
    const bool t206 = !t120 && (t205 || (t3 && (t1 && (t0 && t6))));
    real_t t207;
    if (t120 || t206) {
        t207 = -TB_C(1.0);
    } else {
        const real_t t208 = t1 ? -TB_C(1.0) : TB_C(2.0);
        const real_t t209 = t3 ? -TB_C(1.0) : TB_C(1.0);
        const real_t t210 = t0 ? -TB_C(1.0) : TB_C(4.0);
        const real_t t211 = t6 ? -TB_C(1.0) : TB_C(3.0);
        const real_t t212 = tb_max(t208, t209) <= tb_max(t210, t211) ? (t211 <= t210 ?
            TB_C(0.0) : TB_C(1.0)) : (t209 <= t208 ? TB_C(2.0) : TB_C(3.0));
        t207 = t212;
    }
    const bool t213 = TB_C(0.0) == t207;
    const real_t points_0 = t213 ? t193 : points[0];
    const real_t points_1 = t213 ? t196 : points[1];
    const real_t points_2 = t213 ? t200 : points[2];
    const bool t214 = TB_C(1.0) == t207;
    const real_t points_3 = t214 ? t193 : points[3];
    const real_t points_4 = t214 ? t196 : points[4];
    const real_t points_5 = t214 ? t200 : points[5];
    const bool t215 = TB_C(2.0) == t207;
    const real_t points_6 = t215 ? t193 : points[6];
    const real_t points_7 = t215 ? t196 : points[7];
    const real_t points_8 = t215 ? t200 : points[8];
    const bool t216 = TB_C(3.0) == t207;
    const real_t points_9 = t216 ? t193 : points[9];
    const real_t points_10 = t216 ? t196 : points[10];
    const real_t points_11 = t216 ? t200 : points[11];
    const real_t t217 = -t116;
    const real_t t218 = -t118;
    const real_t t219 = -t112;
    const real_t t220 = -t114;
    const real_t t221 = tb_max(t217, t218) <= tb_max(t219, t220) ? (t220 <= t219 ? TB_C(0.0) :
        TB_C(1.0)) : (t218 <= t217 ? TB_C(2.0) : TB_C(3.0));
    const real_t t222 = t120 ? t221 : -TB_C(1.0);
    const bool t223 = TB_C(0.0) == t222;
    const real_t t224 = t223 ? TB_C(0.0) : weight[0] + t119 * (t111 - weight[0]);
    const real_t weight_0 = t120 ? t224 : t111;
    const bool t225 = TB_C(1.0) == t222;
    const real_t t226 = t225 ? TB_C(0.0) : weight[1] + t119 * (t113 - weight[1]);
    const real_t weight_1 = t120 ? t226 : t113;
    const bool t227 = TB_C(2.0) == t222;
    const real_t t228 = t227 ? TB_C(0.0) : weight[2] + t119 * (t115 - weight[2]);
    const real_t weight_2 = t120 ? t228 : t115;
    const bool t229 = TB_C(3.0) == t222;
    const real_t t230 = t229 ? TB_C(0.0) : weight[3] + t119 * (t117 - weight[3]);
    const real_t weight_3 = t120 ? t230 : t117;
    const real_t used_0 = t213 ? TB_C(1.0) : (t223 ? TB_C(0.0) : used[0]);
    const real_t used_1 = t214 ? TB_C(1.0) : (t225 ? TB_C(0.0) : used[1]);
    const real_t used_2 = t215 ? TB_C(1.0) : (t227 ? TB_C(0.0) : used[2]);
    const real_t used_3 = t216 ? TB_C(1.0) : (t229 ? TB_C(0.0) : used[3]);
    const real_t done_0 = t206 ? TB_C(1.0) : TB_C(0.0);
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
    weight[0] = weight_0;
    weight[1] = weight_1;
    weight[2] = weight_2;
    weight[3] = weight_3;
    used[0] = used_0;
    used[1] = used_1;
    used[2] = used_2;
    used[3] = used_3;
    offset[0] = offset_0;
    offset[1] = offset_1;
    offset[2] = offset_2;
    done[0] = done_0;
    return TB_OK;
}

/* The nearest feasible wrench, judged. */
static tb_status tb_served_wrench_closest_finish(const real_t structure[18], const real_t wrench[3],
    const real_t offset[3], real_t served[3], real_t inner[3])
{
    const real_t t0 = offset[0] * offset[0] + offset[1] * offset[1] + offset[2] * offset[2];
    const real_t t1 = TB_SQRT(t0);
    const bool t2 = t1 <= TB_C(960.0) * TB_EPSILON;
    const bool t3 = !t2;
    const real_t t4 = structure[0] + structure[1] + structure[2] + structure[3];
    const real_t t5 = TB_TENSION_MIDDLE * (t4 + structure[4] + structure[5]);
    const real_t t6 = structure[6] + structure[7] + structure[8] + structure[9];
    const real_t t7 = TB_TENSION_MIDDLE * (t6 + structure[10] + structure[11]);
    const real_t t8 = structure[12] + structure[13] + structure[14] + structure[15];
    const real_t t9 = TB_TENSION_MIDDLE * (t8 + structure[16] + structure[17]);
    real_t served_0, served_1, served_2;
    if (t2) {
        served_0 = wrench[0];
        served_1 = wrench[1];
        served_2 = wrench[2];
    } else {
        const real_t t10 = offset[0] + wrench[0];
        const real_t t11 = TB_EPSILON * TB_C(32.0);
        const real_t t12 = offset[1] + wrench[1];
        const real_t t13 = wrench[2] + offset[2] * TB_LEVER;
        served_0 = t10 + t11 * (t5 - t10);
        served_1 = t12 + t11 * (t7 - t12);
        served_2 = t13 + t11 * (t9 - t13);
    }
    const real_t inner_0 = served_0 + TB_C(3.814697265625e-06) * (t5 - served_0);
    const real_t inner_1 = served_1 + TB_C(3.814697265625e-06) * (t7 - served_1);
    const real_t inner_2 = served_2 + TB_C(3.814697265625e-06) * (t9 - served_2);
    const real_t t14 = offset[0] * structure[0] + offset[1] * structure[6];
    const real_t t15 = TB_MOMENT_WEIGHT * structure[12];
    const real_t t16 = t14 + offset[2] * t15 < TB_C(0.0) ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t17 = offset[0] * structure[1] + offset[1] * structure[7];
    const real_t t18 = TB_MOMENT_WEIGHT * structure[13];
    const real_t t19 = t17 + offset[2] * t18 < TB_C(0.0) ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t20 = offset[0] * structure[2] + offset[1] * structure[8];
    const real_t t21 = TB_MOMENT_WEIGHT * structure[14];
    const real_t t22 = t20 + offset[2] * t21 < TB_C(0.0) ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t23 = structure[0] * t16 + structure[1] * t19 + structure[2] * t22;
    const real_t t24 = offset[0] * structure[3] + offset[1] * structure[9];
    const real_t t25 = TB_MOMENT_WEIGHT * structure[15];
    const real_t t26 = t24 + offset[2] * t25 < TB_C(0.0) ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t27 = offset[0] * structure[4] + offset[1] * structure[10];
    const real_t t28 = TB_MOMENT_WEIGHT * structure[16];
    const real_t t29 = t27 + offset[2] * t28 < TB_C(0.0) ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t30 = offset[0] * structure[5] + offset[1] * structure[11];
    const real_t t31 = TB_MOMENT_WEIGHT * structure[17];
    const real_t t32 = t30 + offset[2] * t31 < TB_C(0.0) ? TB_TENSION_MAX : TB_TENSION_MIN;
    const real_t t33 = t23 + structure[3] * t26 + structure[4] * t29 + structure[5] * t32;
    const real_t t34 = structure[6] * t16 + structure[7] * t19 + structure[8] * t22;
    const real_t t35 = t34 + structure[9] * t26 + structure[10] * t29 + structure[11] * t32;
    const real_t t36 = offset[0] * (offset[0] - (t33 - wrench[0])) + offset[1] * (offset[1] -
        (t35 - wrench[1]));
    const real_t t37 = t15 * t16 + t18 * t19 + t21 * t22 + t25 * t26 + t28 * t29;
    const real_t t38 = wrench[2] * TB_MOMENT_WEIGHT;
    const real_t t39 = offset[2] * (offset[2] - (t37 + t31 * t32 - t38));
    const real_t t40 = TB_ABS(wrench[0]) + TB_ABS(wrench[1]) + TB_ABS(t38);
    const real_t t41 = t1 * (TB_EPSILON * TB_C(64.0) * (TB_C(60.0) + t40));
    const bool t42 = !(t2 || t36 + t39 <= t41);
    if (t42) {
        served[0] = TB_C(0.0);
        served[1] = TB_C(0.0);
        served[2] = TB_C(0.0);
        inner[0] = TB_C(0.0);
        inner[1] = TB_C(0.0);
        inner[2] = TB_C(0.0);
        return TB_INACCURATE;
    }
    served[0] = served_0;
    served[1] = served_1;
    served[2] = served_2;
    inner[0] = inner_0;
    inner[1] = inner_1;
    inner[2] = inner_2;
    return t3 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_served_wrench_closest(const real_t structure[18], const real_t wrench[3],
    real_t served[3], real_t inner[3])
{
    real_t points[12];
    real_t weight[4];
    real_t used[4];
    real_t offset[3];
    real_t done[1] = {TB_C(0.0)};
    tb_status status = tb_served_wrench_closest_begin(structure, wrench, points, weight, used,
        offset);
    for (int steps = 0; steps < 160 && status == TB_OK && !(done[0] > TB_C(0.0)); steps++) {
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
        inner[0] = TB_C(0.0);
        inner[1] = TB_C(0.0);
        inner[2] = TB_C(0.0);
        return status;
    }
    return tb_served_wrench_closest_finish(structure, wrench, offset, served, inner);
}

/* Refuses with a status: weighed is 0; asked is 0 N; inside is 0; largest is 0; first is 0;
 *   last is 0. */
static tb_status tb_refuse_wrench_ray_begin(tb_status status, real_t weighed[18],
    real_t asked[3], real_t inside[1], real_t largest[1], real_t first[1], real_t last[1])
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
    asked[0] = TB_C(0.0);
    asked[1] = TB_C(0.0);
    asked[2] = TB_C(0.0);
    inside[0] = TB_C(0.0);
    largest[0] = TB_C(0.0);
    first[0] = TB_C(0.0);
    last[0] = TB_C(0.0);
    return status;
}

/* Before the first subset. */
static tb_status tb_wrench_ray_begin(const real_t structure[18], const real_t wrench[3],
    real_t weighed[18], real_t asked[3], real_t inside[1], real_t largest[1], real_t first[1],
    real_t last[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) + TB_ABS(structure[10]) + TB_ABS(structure[11]) +
              TB_ABS(structure[12]) + TB_ABS(structure[13]) + TB_ABS(structure[14]) +
              TB_ABS(structure[15]) + TB_ABS(structure[16]) + TB_ABS(structure[17]) <=
              TB_C(72.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) + TB_ABS(wrench[2]) <= TB_C(180000.0))) {
        return tb_refuse_wrench_ray_begin(TB_OUT_OF_DOMAIN, weighed, asked, inside, largest, first, last);
    }
    const real_t weighed_12 = TB_MOMENT_WEIGHT * structure[12];
    const real_t weighed_13 = TB_MOMENT_WEIGHT * structure[13];
    const real_t weighed_14 = TB_MOMENT_WEIGHT * structure[14];
    const real_t weighed_15 = TB_MOMENT_WEIGHT * structure[15];
    const real_t weighed_16 = TB_MOMENT_WEIGHT * structure[16];
    const real_t weighed_17 = TB_MOMENT_WEIGHT * structure[17];
    const real_t asked_2 = TB_MOMENT_WEIGHT * wrench[2];
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
    weighed[12] = weighed_12;
    weighed[13] = weighed_13;
    weighed[14] = weighed_14;
    weighed[15] = weighed_15;
    weighed[16] = weighed_16;
    weighed[17] = weighed_17;
    asked[0] = wrench[0];
    asked[1] = wrench[1];
    asked[2] = asked_2;
    inside[0] = TB_C(1.0);
    largest[0] = TB_C(1.0);
    first[0] = TB_C(0.0);
    last[0] = TB_C(1.0);
    return TB_OK;
}

/* One subset. */
static tb_status tb_wrench_ray_visit(const real_t chosen[6], const real_t numbers[2],
    const real_t weighed[18], const real_t asked[3], real_t inside[1], real_t largest[1],
    real_t first[1], real_t last[1])
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
    const bool t9 = TB_C(16.0) * TB_EPSILON < t8;
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
    const real_t t33 = TB_TENSION_HALF_RANGE * (t26 + TB_ABS(t29) + TB_ABS(t32));
    const real_t t34 = t12 * asked[0] + t13 * asked[1] + t14 * asked[2];
    const real_t t35 = TB_TENSION_MIDDLE * (t32 + (t29 + (t25 + (t22 + (t16 + t19)))));
    const real_t inside_0 = t9 && t33 < TB_ABS(t34 - t35) ? TB_C(0.0) : inside[0];
    real_t largest_0, first_0, last_0;
    if (t9) {
        const real_t t36 = TB_EPSILON * TB_C(160.0);
        const bool t37 = t36 < TB_ABS(t34);
        real_t t38, t39, t40;
        if (t37) {
            const real_t t41 = TB_C(1.0) / t34;
            const real_t t42 = t41 * (t35 - t33 - t36);
            const real_t t43 = t41 * (t36 + (t33 + t35));
            t38 = (t35 + TB_COPYSIGN(t33, t34)) * t41;
            t39 = tb_min(t42, t43);
            t40 = tb_max(t42, t43);
        } else {
            const real_t t44 = t33 + t36 < TB_ABS(t35) ? TB_C(1e+30) : TB_C(0.0);
            t38 = TB_C(1.0);
            t39 = t44;
            t40 = TB_C(1.0);
        }
        largest_0 = tb_min(largest[0], t38);
        first_0 = tb_max(first[0], t39);
        last_0 = tb_min(last[0], t40);
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
static tb_status tb_wrench_ray(const real_t structure[18], const real_t wrench[3], real_t feasible[1],
    real_t fraction[1], real_t missed[1])
{
    static const unsigned char subsets[15][2] = {{0,1}, {0,2}, {0,3}, {0,4}, {0,5}, {1,2},
        {1,3}, {1,4}, {1,5}, {2,3}, {2,4}, {2,5}, {3,4}, {3,5}, {4,5}};
    real_t weighed[18];
    real_t asked[3];
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
        (void)tb_wrench_ray_visit(chosen, numbers, weighed, asked, inside, largest, first,
            last);
    }
    return tb_wrench_ray_finish(inside, largest, first, last, feasible, fraction, missed);
}

/* The wrench that is served: an infeasible one keeps its direction and is scaled down to the
 *   largest feasible fraction. */
static tb_status tb_served_fraction(const real_t structure[18], const real_t wrench[3],
    const real_t feasible[1], const real_t fraction[1], const real_t missed[1],
    const real_t closest[3], real_t served[3], real_t inner[3])
{
    const bool t0 = TB_C(0.0) < feasible[0];
    const bool t1 = !t0;
    const real_t t2 = structure[0] + structure[1] + structure[2] + structure[3];
    const real_t t3 = TB_TENSION_MIDDLE * (t2 + structure[4] + structure[5]);
    const real_t t4 = structure[6] + structure[7] + structure[8] + structure[9];
    const real_t t5 = TB_TENSION_MIDDLE * (t4 + structure[10] + structure[11]);
    const real_t t6 = structure[12] + structure[13] + structure[14] + structure[15];
    const real_t t7 = TB_TENSION_MIDDLE * (t6 + structure[16] + structure[17]);
    real_t served_0, served_1, served_2;
    if (t0) {
        served_0 = wrench[0];
        served_1 = wrench[1];
        served_2 = wrench[2];
    } else {
        const bool t8 = TB_C(0.0) < missed[0];
        const real_t t9 = t8 ? closest[0] : wrench[0] * fraction[0];
        const real_t t10 = TB_C(32.0) * TB_EPSILON;
        const real_t t11 = t8 ? closest[1] : fraction[0] * wrench[1];
        const real_t t12 = t8 ? closest[2] : fraction[0] * wrench[2];
        served_0 = t9 + t10 * (t3 - t9);
        served_1 = t11 + t10 * (t5 - t11);
        served_2 = t12 + t10 * (t7 - t12);
    }
    const real_t inner_0 = served_0 + TB_C(3.814697265625e-06) * (t3 - served_0);
    const real_t inner_1 = served_1 + TB_C(3.814697265625e-06) * (t5 - served_1);
    const real_t inner_2 = served_2 + TB_C(3.814697265625e-06) * (t7 - served_2);
    served[0] = served_0;
    served[1] = served_1;
    served[2] = served_2;
    inner[0] = inner_0;
    inner[1] = inner_1;
    inner[2] = inner_2;
    return t1 ? TB_INFEASIBLE : TB_OK;
}

/* Refuses with a status: served is 0 N; inner is 0 N. */
static tb_status tb_refuse_served_wrench_scale(tb_status status, real_t served[3],
    real_t inner[3])
{
    served[0] = TB_C(0.0);
    served[1] = TB_C(0.0);
    served[2] = TB_C(0.0);
    inner[0] = TB_C(0.0);
    inner[1] = TB_C(0.0);
    inner[2] = TB_C(0.0);
    return status;
}

tb_status tb_served_wrench_scale(const real_t structure[18], const real_t wrench[3],
    real_t served[3], real_t inner[3])
{
    real_t feasible[1];
    real_t fraction[1];
    real_t missed[1];
    real_t closest[3] = {TB_C(0.0)};
    real_t closer[3] = {TB_C(0.0)};
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

tb_status tb_distribute_tension_scale(const real_t structure[18], const real_t wrench[3],
    real_t tension[6], real_t delivered[3], real_t kkt_residual[1])
{
    tb_status status = tb_least_norm_tension(structure, wrench, tension, delivered,
        kkt_residual);
    if (status != TB_INACCURATE) {
        return status;
    }
    real_t served[3];
    real_t inner[3];
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

tb_status tb_distribute_tension_closest(const real_t structure[18], const real_t wrench[3],
    real_t tension[6], real_t delivered[3], real_t kkt_residual[1])
{
    tb_status status = tb_least_norm_tension(structure, wrench, tension, delivered,
        kkt_residual);
    if (status != TB_INACCURATE) {
        return status;
    }
    real_t served[3];
    real_t inner[3];
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

tb_status tb_distribute_tension(const real_t structure[18], const real_t wrench[3],
    real_t tension[6], real_t delivered[3], real_t kkt_residual[1])
{
    return tb_distribute_tension_scale(structure, wrench, tension, delivered, kkt_residual);
}

