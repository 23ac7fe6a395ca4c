/* Regenerate: turnbuckle generate machines/brau_tetrahedron.toml --out <this folder>
 * Machine 1c3579fddb96c4cf, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_tension.h"
#include "tb_machine.h"

/* Refuses with a status: pivot is 0; side is 0; moving is 0; push is 0 N. */
static tb_status tb_refuse_least_norm_tension_begin(tb_status status, real_t pivot[1],
    real_t side[4], real_t moving[1], real_t push[1])
{
    pivot[0] = TB_C(0.0);
    side[0] = TB_C(0.0);
    side[1] = TB_C(0.0);
    side[2] = TB_C(0.0);
    side[3] = TB_C(0.0);
    moving[0] = TB_C(0.0);
    push[0] = TB_C(0.0);
    return status;
}

/* All cables are free. */
static tb_status tb_least_norm_tension_begin(const real_t structure[12], const real_t wrench[3],
    real_t pivot[1], real_t side[4], real_t moving[1], real_t push[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) + TB_ABS(structure[10]) + TB_ABS(structure[11]) <= TB_C(48.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) + TB_ABS(wrench[2]) <= TB_C(240000.0))) {
        return tb_refuse_least_norm_tension_begin(TB_OUT_OF_DOMAIN, pivot, side, moving, push);
    }
    const real_t t0 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t1 = t0 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t2 = TB_SQRT(t1);
    const real_t t3 = TB_COPYSIGN(t2, structure[0]);
    const real_t t4 = TB_ABS(t3);
    const real_t t5 = structure[0] + t3;
    const real_t t6 = t5 * structure[4] + structure[1] * structure[5] + structure[2] *
        structure[6];
    const real_t t7 = TB_C(1.0) / (t2 * (t2 + TB_ABS(structure[0])));
    const real_t t8 = (t6 + structure[3] * structure[7]) * t7;
    const real_t t9 = structure[5] - structure[1] * t8;
    const real_t t10 = structure[6] - structure[2] * t8;
    const real_t t11 = structure[7] - structure[3] * t8;
    const real_t t12 = TB_SQRT(t9 * t9 + t10 * t10 + t11 * t11);
    const real_t t13 = TB_COPYSIGN(t12, t9);
    const real_t t14 = TB_ABS(t13);
    const real_t t15 = t5 * structure[8] + structure[1] * structure[9] + structure[2] *
        structure[10];
    const real_t t16 = t7 * (t15 + structure[3] * structure[11]);
    const real_t t17 = structure[10] - structure[2] * t16;
    const real_t t18 = (t9 + t13) * (structure[9] - structure[1] * t16) + t10 * t17;
    const real_t t19 = structure[11] - structure[3] * t16;
    const real_t t20 = (t18 + t11 * t19) / (t12 * (t12 + TB_ABS(t9)));
    const real_t t21 = t17 - t10 * t20;
    const real_t t22 = t19 - t11 * t20;
    const real_t t23 = TB_ABS(TB_COPYSIGN(TB_SQRT(t21 * t21 + t22 * t22), t21));
    const real_t pivot_0 = tb_min(tb_min(t4, t14), t23);
    const real_t t24 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const bool t25 = !(t24 < t4 && t24 < t14 && t24 < t23);
    if (t25) {
        return tb_refuse_least_norm_tension_begin(TB_SINGULAR, pivot, side, moving, push);
    }
    pivot[0] = pivot_0;
    side[0] = TB_C(0.0);
    side[1] = TB_C(0.0);
    side[2] = TB_C(0.0);
    side[3] = TB_C(0.0);
    moving[0] = -TB_C(1.0);
    push[0] = TB_C(0.0);
    return TB_OK;
}

/* Moves a cable towards its bounds, until it is held or another one is freed. */
static tb_status tb_least_norm_tension_step(const real_t structure[12], const real_t wrench[3],
    real_t side[4], real_t moving[1], real_t push[1], real_t done[1])
{
    const bool t0 = side[0] == TB_C(0.0);
    const real_t t1 = t0 ? TB_C(1.0) : TB_C(0.0);
    const bool t2 = TB_C(0.0) == side[1];
    const real_t t3 = t2 ? TB_C(1.0) : TB_C(0.0);
    const bool t4 = TB_C(0.0) == side[2];
    const real_t t5 = t4 ? TB_C(1.0) : TB_C(0.0);
    const bool t6 = TB_C(0.0) == side[3];
    const real_t t7 = t6 ? TB_C(1.0) : TB_C(0.0);
    const real_t t8 = t0 ? (t0 ? structure[0] * structure[0] : TB_C(0.0)) : TB_C(0.0);
    const real_t t9 = t2 ? (t2 ? structure[1] * structure[1] : TB_C(0.0)) : TB_C(0.0);
    const real_t t10 = t4 ? (t4 ? structure[2] * structure[2] : TB_C(0.0)) : TB_C(0.0);
    const real_t t11 = t6 ? (t6 ? structure[3] * structure[3] : TB_C(0.0)) : TB_C(0.0);
    const real_t t12 = TB_SQRT(t8 + t9 + t10 + t11);
    const real_t t13 = t0 ? structure[0] : TB_C(0.0);
    const real_t t14 = TB_COPYSIGN(t12, t13);
    const real_t t15 = t13 + t14;
    const real_t t16 = t2 ? (t2 ? structure[1] * structure[5] : TB_C(0.0)) : TB_C(0.0);
    const real_t t17 = t4 ? (t4 ? structure[2] * structure[6] : TB_C(0.0)) : TB_C(0.0);
    const real_t t18 = (t0 ? t15 * structure[4] : TB_C(0.0)) + t16 + t17;
    const real_t t19 = t6 ? (t6 ? structure[3] * structure[7] : TB_C(0.0)) : TB_C(0.0);
    const real_t t20 = TB_C(1.0) / (t12 * (t12 + TB_ABS(t13)));
    const real_t t21 = (t18 + t19) * t20;
    const real_t t22 = structure[5] - structure[1] * t21;
    const real_t t23 = structure[6] - structure[2] * t21;
    const real_t t24 = (t2 ? (t2 ? t22 * t22 : TB_C(0.0)) : TB_C(0.0)) + (t4 ? (t4 ? t23 * t23
        : TB_C(0.0)) : TB_C(0.0));
    const real_t t25 = structure[7] - structure[3] * t21;
    const real_t t26 = t24 + (t6 ? (t6 ? t25 * t25 : TB_C(0.0)) : TB_C(0.0));
    const real_t t27 = TB_SQRT(t26);
    const real_t t28 = t2 ? t22 : TB_C(0.0);
    const real_t t29 = TB_COPYSIGN(t27, t28);
    const real_t t30 = t2 ? (t2 ? structure[1] * structure[9] : TB_C(0.0)) : TB_C(0.0);
    const real_t t31 = t4 ? (t4 ? structure[2] * structure[10] : TB_C(0.0)) : TB_C(0.0);
    const real_t t32 = (t0 ? t15 * structure[8] : TB_C(0.0)) + t30 + t31;
    const real_t t33 = t6 ? (t6 ? structure[3] * structure[11] : TB_C(0.0)) : TB_C(0.0);
    const real_t t34 = t20 * (t32 + t33);
    const real_t t35 = structure[10] - structure[2] * t34;
    const real_t t36 = t28 + t29;
    const real_t t37 = structure[9] - structure[1] * t34;
    const real_t t38 = (t2 ? t36 * t37 : TB_C(0.0)) + (t4 ? (t4 ? t23 * t35 : TB_C(0.0)) :
        TB_C(0.0));
    const real_t t39 = structure[11] - structure[3] * t34;
    const real_t t40 = t38 + (t6 ? (t6 ? t25 * t39 : TB_C(0.0)) : TB_C(0.0));
    const real_t t41 = t40 / (t27 * (t27 + TB_ABS(t28)));
    const real_t t42 = t35 - t23 * t41;
    const real_t t43 = t39 - t25 * t41;
    const real_t t44 = (t4 ? (t4 ? t42 * t42 : TB_C(0.0)) : TB_C(0.0)) + (t6 ? (t6 ? t43 * t43
        : TB_C(0.0)) : TB_C(0.0));
    const real_t t45 = TB_COPYSIGN(TB_SQRT(t44), t4 ? t42 : TB_C(0.0));
    const real_t t46 = tb_min(tb_min(TB_ABS(t14), TB_ABS(t29)), TB_ABS(t45));
    const real_t t47 = TB_C(1.0) / tb_min(TB_C(1.0), t46);
    const real_t t48 = TB_C(64.0) * TB_EPSILON * t47;
    const bool t49 = TB_C(0.0) <= moving[0];
    const real_t t50 = TB_C(1.0) / t14;
    const bool t51 = TB_C(0.0) < side[0];
    const bool t52 = TB_C(0.0) < side[1];
    const real_t t53 = (t51 ? structure[0] * TB_TENSION_MAX : TB_C(0.0)) + (t52 ? structure[1]
        * TB_TENSION_MAX : TB_C(0.0));
    const bool t54 = TB_C(0.0) < side[2];
    const real_t t55 = t53 + (t54 ? structure[2] * TB_TENSION_MAX : TB_C(0.0));
    const bool t56 = TB_C(0.0) < side[3];
    const real_t t57 = t55 + (t56 ? structure[3] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t58 = (wrench[0] - t57) * t50;
    const real_t t59 = (t0 ? structure[4] : TB_C(0.0)) - t15 * t21;
    const real_t t60 = TB_C(1.0) / t29;
    const real_t t61 = (t51 ? structure[4] * TB_TENSION_MAX : TB_C(0.0)) + (t52 ? structure[5]
        * TB_TENSION_MAX : TB_C(0.0));
    const real_t t62 = t61 + (t54 ? structure[6] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t63 = t62 + (t56 ? structure[7] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t64 = (wrench[1] - t63 + t58 * t59) * t60;
    const real_t t65 = (t2 ? t37 : TB_C(0.0)) - t36 * t41;
    const real_t t66 = TB_C(1.0) / t45;
    const real_t t67 = (t51 ? structure[8] * TB_TENSION_MAX : TB_C(0.0)) + (t52 ? structure[9]
        * TB_TENSION_MAX : TB_C(0.0));
    const real_t t68 = t67 + (t54 ? structure[10] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t69 = t68 + (t56 ? structure[11] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t70 = (t0 ? structure[8] : TB_C(0.0)) - t15 * t34;
    const real_t t71 = t66 * ((wrench[2] - t69 + t58 * t70 + t64 * t65) * t66);
    const real_t t72 = t60 * (t64 + t65 * t71);
    const real_t t73 = t50 * (t58 + t59 * t72 + t70 * t71);
    const real_t t74 = structure[2] * t73 + structure[6] * t72 + structure[10] * t71;
    const real_t t75 = TB_C(0.0) < t5 ? tb_max(-t74, t74 - TB_TENSION_MAX) : -TB_C(1.0);
    const real_t t76 = structure[3] * t73 + structure[7] * t72 + structure[11] * t71;
    const real_t t77 = TB_C(0.0) < t7 ? tb_max(-t76, t76 - TB_TENSION_MAX) : -TB_C(1.0);
    const real_t t78 = structure[0] * t73 + structure[4] * t72 + structure[8] * t71;
    const real_t t79 = TB_C(0.0) < t1 ? tb_max(-t78, t78 - TB_TENSION_MAX) : -TB_C(1.0);
    const real_t t80 = structure[1] * t73 + structure[5] * t72 + structure[9] * t71;
    const real_t t81 = TB_C(0.0) < t3 ? tb_max(-t80, t80 - TB_TENSION_MAX) : -TB_C(1.0);
    real_t t82, t83, t84, t85;
    if (t49) {
        t82 = moving[0] == TB_C(2.0) ? TB_C(1.0) : TB_C(0.0);
        t83 = TB_C(3.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
        t84 = TB_C(0.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
        t85 = TB_C(1.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
    } else {
        t82 = t75;
        t83 = t77;
        t84 = t79;
        t85 = t81;
    }
    const bool t86 = tb_max(t82, t83) <= tb_max(t84, t85);
    real_t t87, t88, t89, t90, t91;
    if (t86) {
        const bool t92 = t85 <= t84;
        t87 = t92 ? TB_C(0.0) : TB_C(1.0);
        t88 = t92 ? structure[0] : structure[1];
        t89 = t92 ? structure[4] : structure[5];
        t90 = t92 ? structure[8] : structure[9];
        t91 = t92 ? t78 : t80;
    } else {
        const bool t93 = t83 <= t82;
        t87 = t93 ? TB_C(2.0) : TB_C(3.0);
        t88 = t93 ? structure[2] : structure[3];
        t89 = t93 ? structure[6] : structure[7];
        t90 = t93 ? structure[10] : structure[11];
        t91 = t93 ? t74 : t76;
    }
    const real_t t94 = t50 * t88;
    const real_t t95 = t60 * (t89 + t59 * t94);
    const real_t t96 = t66 * (t66 * (t90 + t70 * t94 + t65 * t95));
    const real_t t97 = t60 * (t95 + t65 * t96);
    const real_t t98 = t50 * (t94 + t59 * t97 + t70 * t96);
    const real_t t99 = structure[0] * t98 + structure[4] * t97 + structure[8] * t96;
    const real_t t100 = (TB_C(0.0) == t87 ? TB_C(1.0) : TB_C(0.0)) - t99;
    const real_t t101 = structure[1] * t98 + structure[5] * t97 + structure[9] * t96;
    const real_t t102 = (TB_C(1.0) == t87 ? TB_C(1.0) : TB_C(0.0)) - t101;
    const real_t t103 = (t0 ? (t0 ? t100 * t100 : TB_C(0.0)) : TB_C(0.0)) + (t2 ? (t2 ? t102 *
        t102 : TB_C(0.0)) : TB_C(0.0));
    const real_t t104 = structure[2] * t98 + structure[6] * t97 + structure[10] * t96;
    const real_t t105 = (TB_C(2.0) == t87 ? TB_C(1.0) : TB_C(0.0)) - t104;
    const real_t t106 = t103 + (t4 ? (t4 ? t105 * t105 : TB_C(0.0)) : TB_C(0.0));
    const real_t t107 = structure[3] * t98 + structure[7] * t97 + structure[11] * t96;
    const real_t t108 = (TB_C(3.0) == t87 ? TB_C(1.0) : TB_C(0.0)) - t107;
    const real_t t109 = t106 + (t6 ? (t6 ? t108 * t108 : TB_C(0.0)) : TB_C(0.0));
    const bool t110 = TB_C(3.0) < t1 + t3 + t5 + t7 && t48 * t48 < t109;
    const real_t t111 = t91 + t109 * push[0];
    const bool t112 = t111 < TB_C(10.0);
    real_t t113;
    if (t110) {
        const real_t t114 = tb_max(t112 ? -t111 : t111 - TB_TENSION_MAX, TB_C(0.0));
        t113 = t114 * (TB_C(1.0) / t109);
    } else {
        t113 = TB_C(1e+30);
    }
    const real_t t115 = t112 ? TB_C(1.0) : -TB_C(1.0);
    const real_t t116 = side[0] * (t99 * t115);
    real_t t117;
    if (t48 < t116) {
        const real_t t118 = t78 - t99 * push[0] - (t51 ? TB_TENSION_MAX : TB_C(0.0));
        t117 = tb_max(side[0] * t118, TB_C(0.0)) / t116;
    } else {
        t117 = TB_C(1e+30);
    }
    const real_t t119 = side[1] * (t101 * t115);
    real_t t120;
    if (t48 < t119) {
        const real_t t121 = t80 - t101 * push[0] - (t52 ? TB_TENSION_MAX : TB_C(0.0));
        t120 = tb_max(side[1] * t121, TB_C(0.0)) / t119;
    } else {
        t120 = TB_C(1e+30);
    }
    const real_t t122 = side[2] * (t104 * t115);
    real_t t123;
    if (t48 < t122) {
        const real_t t124 = t74 - t104 * push[0] - (t54 ? TB_TENSION_MAX : TB_C(0.0));
        t123 = tb_max(side[2] * t124, TB_C(0.0)) / t122;
    } else {
        t123 = TB_C(1e+30);
    }
    const real_t t125 = side[3] * (t107 * t115);
    real_t t126;
    if (t48 < t125) {
        const real_t t127 = t76 - t107 * push[0] - (t56 ? TB_TENSION_MAX : TB_C(0.0));
        t126 = tb_max(side[3] * t127, TB_C(0.0)) / t125;
    } else {
        t126 = TB_C(1e+30);
    }
    const real_t t128 = tb_min(tb_min(tb_min(t117, t120), t123), t126);
    const bool t129 = t113 <= t128;
    const bool t130 = tb_max(tb_max(tb_max(t79, t81), t75), t77) <= t47 * (TB_EPSILON *
        TB_C(160.0));
    const bool t131 = (!t49 && t130) || !(tb_min(t113, t128) < TB_C(1e+30));
    const real_t t132 = t129 && !t131 ? t87 : -TB_C(1.0);
    const real_t t133 = -t115;
    real_t t134;
    if (t129 || t131) {
        t134 = -TB_C(1.0);
    } else {
        const real_t t135 = -t123;
        const real_t t136 = -t126;
        const real_t t137 = -t117;
        const real_t t138 = -t120;
        const real_t t139 = tb_max(t135, t136) <= tb_max(t137, t138) ? (t138 <= t137 ?
            TB_C(0.0) : TB_C(1.0)) : (t136 <= t135 ? TB_C(2.0) : TB_C(3.0));
        t134 = t139;
    }
    const real_t side_0 = TB_C(0.0) == t132 ? t133 : (TB_C(0.0) == t134 ? TB_C(0.0) : side[0]);
    const real_t side_1 = TB_C(1.0) == t132 ? t133 : (TB_C(1.0) == t134 ? TB_C(0.0) : side[1]);
    const real_t side_2 = TB_C(2.0) == t132 ? t133 : (TB_C(2.0) == t134 ? TB_C(0.0) : side[2]);
    const real_t side_3 = TB_C(3.0) == t132 ? t133 : (TB_C(3.0) == t134 ? TB_C(0.0) : side[3]);
    const real_t moving_0 = t129 ? -TB_C(1.0) : t87;
    const real_t push_0 = t129 ? TB_C(0.0) : push[0] + t115 * t128;
    const real_t done_0 = t131 ? TB_C(1.0) : TB_C(0.0);
    side[0] = side_0;
    side[1] = side_1;
    side[2] = side_2;
    side[3] = side_3;
    moving[0] = moving_0;
    push[0] = push_0;
    done[0] = done_0;
    return TB_OK;
}

/* The tensions, refined and judged. */
static tb_status tb_least_norm_tension_finish(const real_t structure[12], const real_t wrench[3],
    const real_t pivot[1], const real_t side[4], real_t tension[4], real_t delivered[3],
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
    const real_t t8 = wrench[0] - t7;
    const real_t t9 = t0 ? (t0 ? structure[0] * structure[0] : TB_C(0.0)) : TB_C(0.0);
    const bool t10 = TB_C(0.0) == side[1];
    const real_t t11 = t10 ? (t10 ? structure[1] * structure[1] : TB_C(0.0)) : TB_C(0.0);
    const bool t12 = TB_C(0.0) == side[2];
    const real_t t13 = t12 ? (t12 ? structure[2] * structure[2] : TB_C(0.0)) : TB_C(0.0);
    const bool t14 = TB_C(0.0) == side[3];
    const real_t t15 = t14 ? (t14 ? structure[3] * structure[3] : TB_C(0.0)) : TB_C(0.0);
    const real_t t16 = TB_SQRT(t9 + t11 + t13 + t15);
    const real_t t17 = t0 ? structure[0] : TB_C(0.0);
    const real_t t18 = TB_COPYSIGN(t16, t17);
    const real_t t19 = TB_C(1.0) / t18;
    const real_t t20 = t8 * t19;
    const real_t t21 = t17 + t18;
    const real_t t22 = t10 ? (t10 ? structure[1] * structure[5] : TB_C(0.0)) : TB_C(0.0);
    const real_t t23 = t12 ? (t12 ? structure[2] * structure[6] : TB_C(0.0)) : TB_C(0.0);
    const real_t t24 = (t0 ? structure[4] * t21 : TB_C(0.0)) + t22 + t23;
    const real_t t25 = t14 ? (t14 ? structure[3] * structure[7] : TB_C(0.0)) : TB_C(0.0);
    const real_t t26 = TB_C(1.0) / (t16 * (t16 + TB_ABS(t17)));
    const real_t t27 = (t24 + t25) * t26;
    const real_t t28 = (t0 ? structure[4] : TB_C(0.0)) - t21 * t27;
    const real_t t29 = (t1 ? TB_TENSION_MAX * structure[4] : TB_C(0.0)) + (t2 ? TB_TENSION_MAX
        * structure[5] : TB_C(0.0));
    const real_t t30 = t29 + (t4 ? TB_TENSION_MAX * structure[6] : TB_C(0.0));
    const real_t t31 = t30 + (t6 ? TB_TENSION_MAX * structure[7] : TB_C(0.0));
    const real_t t32 = wrench[1] - t31;
    const real_t t33 = structure[5] - structure[1] * t27;
    const real_t t34 = structure[6] - structure[2] * t27;
    const real_t t35 = (t10 ? (t10 ? t33 * t33 : TB_C(0.0)) : TB_C(0.0)) + (t12 ? (t12 ? t34 *
        t34 : TB_C(0.0)) : TB_C(0.0));
    const real_t t36 = structure[7] - structure[3] * t27;
    const real_t t37 = t35 + (t14 ? (t14 ? t36 * t36 : TB_C(0.0)) : TB_C(0.0));
    const real_t t38 = TB_SQRT(t37);
    const real_t t39 = t10 ? t33 : TB_C(0.0);
    const real_t t40 = TB_COPYSIGN(t38, t39);
    const real_t t41 = TB_C(1.0) / t40;
    const real_t t42 = (t32 + t20 * t28) * t41;
    const real_t t43 = t10 ? (t10 ? structure[1] * structure[9] : TB_C(0.0)) : TB_C(0.0);
    const real_t t44 = t12 ? (t12 ? structure[2] * structure[10] : TB_C(0.0)) : TB_C(0.0);
    const real_t t45 = (t0 ? t21 * structure[8] : TB_C(0.0)) + t43 + t44;
    const real_t t46 = t14 ? (t14 ? structure[3] * structure[11] : TB_C(0.0)) : TB_C(0.0);
    const real_t t47 = t26 * (t45 + t46);
    const real_t t48 = structure[9] - structure[1] * t47;
    const real_t t49 = t39 + t40;
    const real_t t50 = structure[10] - structure[2] * t47;
    const real_t t51 = (t10 ? t48 * t49 : TB_C(0.0)) + (t12 ? (t12 ? t34 * t50 : TB_C(0.0)) :
        TB_C(0.0));
    const real_t t52 = structure[11] - structure[3] * t47;
    const real_t t53 = t51 + (t14 ? (t14 ? t36 * t52 : TB_C(0.0)) : TB_C(0.0));
    const real_t t54 = t53 / (t38 * (t38 + TB_ABS(t39)));
    const real_t t55 = (t10 ? t48 : TB_C(0.0)) - t49 * t54;
    const real_t t56 = (t1 ? TB_TENSION_MAX * structure[8] : TB_C(0.0)) + (t2 ? TB_TENSION_MAX
        * structure[9] : TB_C(0.0));
    const real_t t57 = t56 + (t4 ? TB_TENSION_MAX * structure[10] : TB_C(0.0));
    const real_t t58 = t57 + (t6 ? TB_TENSION_MAX * structure[11] : TB_C(0.0));
    const real_t t59 = wrench[2] - t58;
    const real_t t60 = (t0 ? structure[8] : TB_C(0.0)) - t21 * t47;
    const real_t t61 = t50 - t34 * t54;
    const real_t t62 = t52 - t36 * t54;
    const real_t t63 = (t12 ? (t12 ? t61 * t61 : TB_C(0.0)) : TB_C(0.0)) + (t14 ? (t14 ? t62 *
        t62 : TB_C(0.0)) : TB_C(0.0));
    const real_t t64 = TB_COPYSIGN(TB_SQRT(t63), t12 ? t61 : TB_C(0.0));
    const real_t t65 = TB_C(1.0) / t64;
    const real_t t66 = t65 * ((t59 + t20 * t60 + t42 * t55) * t65);
    const real_t t67 = t41 * (t42 + t55 * t66);
    const real_t t68 = t19 * (t20 + t28 * t67 + t60 * t66);
    const real_t t69 = structure[0] * t68 + structure[4] * t67 + structure[8] * t66;
    const real_t t70 = structure[1] * t68 + structure[5] * t67 + structure[9] * t66;
    const real_t t71 = (t0 ? structure[0] * t69 : TB_C(0.0)) + (t10 ? structure[1] * t70 :
        TB_C(0.0));
    const real_t t72 = structure[2] * t68 + structure[6] * t67 + structure[10] * t66;
    const real_t t73 = structure[3] * t68 + structure[7] * t67 + structure[11] * t66;
    const real_t t74 = t71 + (t12 ? structure[2] * t72 : TB_C(0.0)) + (t14 ? structure[3] * t73
        : TB_C(0.0));
    const real_t t75 = t19 * (t8 - t74);
    const real_t t76 = (t0 ? structure[4] * t69 : TB_C(0.0)) + (t10 ? structure[5] * t70 :
        TB_C(0.0));
    const real_t t77 = t76 + (t12 ? structure[6] * t72 : TB_C(0.0)) + (t14 ? structure[7] * t73
        : TB_C(0.0));
    const real_t t78 = t41 * (t32 - t77 + t28 * t75);
    const real_t t79 = (t0 ? structure[8] * t69 : TB_C(0.0)) + (t10 ? structure[9] * t70 :
        TB_C(0.0));
    const real_t t80 = t79 + (t12 ? structure[10] * t72 : TB_C(0.0)) + (t14 ? structure[11] *
        t73 : TB_C(0.0));
    const real_t t81 = t65 * (t65 * (t59 - t80 + t60 * t75 + t55 * t78));
    const real_t t82 = t41 * (t78 + t55 * t81);
    const real_t t83 = t19 * (t75 + t28 * t82 + t60 * t81);
    const real_t t84 = structure[0] * t83 + structure[4] * t82 + structure[8] * t81;
    const real_t t85 = t69 + t84;
    const real_t t86 = t1 ? TB_TENSION_MAX : TB_C(0.0);
    const real_t tension_0 = tb_min(tb_max(t0 ? t85 : t86, TB_C(0.0)), TB_TENSION_MAX);
    const real_t t87 = structure[1] * t83 + structure[5] * t82 + structure[9] * t81;
    const real_t t88 = t70 + t87;
    const real_t t89 = t2 ? TB_TENSION_MAX : TB_C(0.0);
    const real_t tension_1 = tb_min(tb_max(t10 ? t88 : t89, TB_C(0.0)), TB_TENSION_MAX);
    const real_t t90 = structure[2] * t83 + structure[6] * t82 + structure[10] * t81;
    const real_t t91 = t72 + t90;
    const real_t t92 = t4 ? TB_TENSION_MAX : TB_C(0.0);
    const real_t tension_2 = tb_min(tb_max(t12 ? t91 : t92, TB_C(0.0)), TB_TENSION_MAX);
    const real_t t93 = structure[3] * t83 + structure[7] * t82 + structure[11] * t81;
    const real_t t94 = t73 + t93;
    const real_t t95 = t6 ? TB_TENSION_MAX : TB_C(0.0);
    const real_t tension_3 = tb_min(tb_max(t14 ? t94 : t95, TB_C(0.0)), TB_TENSION_MAX);
    const real_t t96 = structure[0] * tension_0 + structure[1] * tension_1;
    const real_t delivered_0 = t96 + structure[2] * tension_2 + structure[3] * tension_3;
    const real_t t97 = structure[4] * tension_0 + structure[5] * tension_1;
    const real_t delivered_1 = t97 + structure[6] * tension_2 + structure[7] * tension_3;
    const real_t t98 = structure[8] * tension_0 + structure[9] * tension_1;
    const real_t delivered_2 = t98 + structure[10] * tension_2 + structure[11] * tension_3;
    const real_t t99 = tb_max(side[0] * (t86 - t85), side[1] * (t89 - t88));
    const real_t t100 = tb_max(tb_max(t99, side[2] * (t92 - t91)), side[3] * (t95 - t94));
    const real_t t101 = tb_min(tb_min(TB_ABS(t18), TB_ABS(t40)), TB_ABS(t64));
    const real_t t102 = tb_max(TB_C(0.0), t100) * tb_min(TB_C(1.0), t101);
    const real_t t103 = tb_max(tb_max(TB_ABS(t68), TB_ABS(t67)), TB_ABS(t66));
    const real_t t104 = TB_TENSION_MAX * t102 * (TB_C(1.0) / tb_max(TB_TENSION_MAX, t103));
    const real_t t105 = tb_max(tb_max(t104, TB_ABS(delivered_0 - wrench[0])),
        TB_ABS(delivered_1 - wrench[1]));
    const real_t kkt_residual_0 = tb_max(t105, TB_ABS(delivered_2 - wrench[2]));
    const real_t t106 = TB_C(2560.0) * TB_EPSILON / tb_min(TB_C(1.0), pivot[0]);
    const bool t107 = !(kkt_residual_0 <= tb_min(t106, TB_C(0.02)));
    if (t107) {
        tension[0] = TB_C(0.0);
        tension[1] = TB_C(0.0);
        tension[2] = TB_C(0.0);
        tension[3] = TB_C(0.0);
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
    delivered[0] = delivered_0;
    delivered[1] = delivered_1;
    delivered[2] = delivered_2;
    kkt_residual[0] = kkt_residual_0;
    return TB_OK;
}

tb_status tb_least_norm_tension(const real_t structure[12], const real_t wrench[3],
    real_t tension[4], real_t delivered[3], real_t kkt_residual[1])
{
    real_t pivot[1];
    real_t side[4];
    real_t moving[1];
    real_t push[1];
    real_t done[1] = {TB_C(0.0)};
    tb_status status = tb_least_norm_tension_begin(structure, wrench, pivot, side, moving,
        push);
    for (int steps = 0; steps < 20 && status == TB_OK && !(done[0] > TB_C(0.0)); steps++) {
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
    real_t side[4], real_t moving[1], real_t push[1])
{
    pivot[0] = TB_C(0.0);
    side[0] = TB_C(0.0);
    side[1] = TB_C(0.0);
    side[2] = TB_C(0.0);
    side[3] = TB_C(0.0);
    moving[0] = TB_C(0.0);
    push[0] = TB_C(0.0);
    return status;
}

/* All cables are free. */
static tb_status tb_distribute_tension_paper_begin(const real_t structure[12], const real_t wrench[3],
    real_t pivot[1], real_t side[4], real_t moving[1], real_t push[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) + TB_ABS(structure[10]) + TB_ABS(structure[11]) <= TB_C(48.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) + TB_ABS(wrench[2]) <= TB_C(240000.0))) {
        return tb_refuse_distribute_tension_paper_begin(TB_OUT_OF_DOMAIN, pivot, side, moving, push);
    }
    const real_t t0 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t1 = t0 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t2 = TB_SQRT(t1);
    const real_t t3 = TB_COPYSIGN(t2, structure[0]);
    const real_t t4 = TB_ABS(t3);
    const real_t t5 = structure[0] + t3;
    const real_t t6 = t5 * structure[4] + structure[1] * structure[5] + structure[2] *
        structure[6];
    const real_t t7 = TB_C(1.0) / (t2 * (t2 + TB_ABS(structure[0])));
    const real_t t8 = (t6 + structure[3] * structure[7]) * t7;
    const real_t t9 = structure[5] - structure[1] * t8;
    const real_t t10 = structure[6] - structure[2] * t8;
    const real_t t11 = structure[7] - structure[3] * t8;
    const real_t t12 = TB_SQRT(t9 * t9 + t10 * t10 + t11 * t11);
    const real_t t13 = TB_COPYSIGN(t12, t9);
    const real_t t14 = TB_ABS(t13);
    const real_t t15 = t5 * structure[8] + structure[1] * structure[9] + structure[2] *
        structure[10];
    const real_t t16 = t7 * (t15 + structure[3] * structure[11]);
    const real_t t17 = structure[10] - structure[2] * t16;
    const real_t t18 = (t9 + t13) * (structure[9] - structure[1] * t16) + t10 * t17;
    const real_t t19 = structure[11] - structure[3] * t16;
    const real_t t20 = (t18 + t11 * t19) / (t12 * (t12 + TB_ABS(t9)));
    const real_t t21 = t17 - t10 * t20;
    const real_t t22 = t19 - t11 * t20;
    const real_t t23 = TB_ABS(TB_COPYSIGN(TB_SQRT(t21 * t21 + t22 * t22), t21));
    const real_t pivot_0 = tb_min(tb_min(t4, t14), t23);
    const real_t t24 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const bool t25 = !(t24 < t4 && t24 < t14 && t24 < t23);
    if (t25) {
        return tb_refuse_distribute_tension_paper_begin(TB_SINGULAR, pivot, side, moving, push);
    }
    pivot[0] = pivot_0;
    side[0] = TB_C(0.0);
    side[1] = TB_C(0.0);
    side[2] = TB_C(0.0);
    side[3] = TB_C(0.0);
    moving[0] = -TB_C(1.0);
    push[0] = TB_C(0.0);
    return TB_OK;
}

/* Moves a cable towards its bounds, until it is held or another one is freed. */
static tb_status tb_distribute_tension_paper_step(const real_t structure[12], const real_t wrench[3],
    real_t side[4], real_t moving[1], real_t push[1], real_t done[1])
{
    const bool t0 = side[0] == TB_C(0.0);
    const real_t t1 = t0 ? TB_C(1.0) : TB_C(0.0);
    const bool t2 = TB_C(0.0) == side[1];
    const real_t t3 = t2 ? TB_C(1.0) : TB_C(0.0);
    const bool t4 = TB_C(0.0) == side[2];
    const real_t t5 = t4 ? TB_C(1.0) : TB_C(0.0);
    const bool t6 = TB_C(0.0) == side[3];
    const real_t t7 = t6 ? TB_C(1.0) : TB_C(0.0);
    const real_t t8 = t0 ? (t0 ? structure[0] * structure[0] : TB_C(0.0)) : TB_C(0.0);
    const real_t t9 = t2 ? (t2 ? structure[1] * structure[1] : TB_C(0.0)) : TB_C(0.0);
    const real_t t10 = t4 ? (t4 ? structure[2] * structure[2] : TB_C(0.0)) : TB_C(0.0);
    const real_t t11 = t6 ? (t6 ? structure[3] * structure[3] : TB_C(0.0)) : TB_C(0.0);
    const real_t t12 = TB_SQRT(t8 + t9 + t10 + t11);
    const real_t t13 = t0 ? structure[0] : TB_C(0.0);
    const real_t t14 = TB_COPYSIGN(t12, t13);
    const real_t t15 = t13 + t14;
    const real_t t16 = t2 ? (t2 ? structure[1] * structure[5] : TB_C(0.0)) : TB_C(0.0);
    const real_t t17 = t4 ? (t4 ? structure[2] * structure[6] : TB_C(0.0)) : TB_C(0.0);
    const real_t t18 = (t0 ? t15 * structure[4] : TB_C(0.0)) + t16 + t17;
    const real_t t19 = t6 ? (t6 ? structure[3] * structure[7] : TB_C(0.0)) : TB_C(0.0);
    const real_t t20 = TB_C(1.0) / (t12 * (t12 + TB_ABS(t13)));
    const real_t t21 = (t18 + t19) * t20;
    const real_t t22 = structure[5] - structure[1] * t21;
    const real_t t23 = structure[6] - structure[2] * t21;
    const real_t t24 = (t2 ? (t2 ? t22 * t22 : TB_C(0.0)) : TB_C(0.0)) + (t4 ? (t4 ? t23 * t23
        : TB_C(0.0)) : TB_C(0.0));
    const real_t t25 = structure[7] - structure[3] * t21;
    const real_t t26 = t24 + (t6 ? (t6 ? t25 * t25 : TB_C(0.0)) : TB_C(0.0));
    const real_t t27 = TB_SQRT(t26);
    const real_t t28 = t2 ? t22 : TB_C(0.0);
    const real_t t29 = TB_COPYSIGN(t27, t28);
    const real_t t30 = t2 ? (t2 ? structure[1] * structure[9] : TB_C(0.0)) : TB_C(0.0);
    const real_t t31 = t4 ? (t4 ? structure[2] * structure[10] : TB_C(0.0)) : TB_C(0.0);
    const real_t t32 = (t0 ? t15 * structure[8] : TB_C(0.0)) + t30 + t31;
    const real_t t33 = t6 ? (t6 ? structure[3] * structure[11] : TB_C(0.0)) : TB_C(0.0);
    const real_t t34 = t20 * (t32 + t33);
    const real_t t35 = structure[10] - structure[2] * t34;
    const real_t t36 = t28 + t29;
    const real_t t37 = structure[9] - structure[1] * t34;
    const real_t t38 = (t2 ? t36 * t37 : TB_C(0.0)) + (t4 ? (t4 ? t23 * t35 : TB_C(0.0)) :
        TB_C(0.0));
    const real_t t39 = structure[11] - structure[3] * t34;
    const real_t t40 = t38 + (t6 ? (t6 ? t25 * t39 : TB_C(0.0)) : TB_C(0.0));
    const real_t t41 = t40 / (t27 * (t27 + TB_ABS(t28)));
    const real_t t42 = t35 - t23 * t41;
    const real_t t43 = t39 - t25 * t41;
    const real_t t44 = (t4 ? (t4 ? t42 * t42 : TB_C(0.0)) : TB_C(0.0)) + (t6 ? (t6 ? t43 * t43
        : TB_C(0.0)) : TB_C(0.0));
    const real_t t45 = TB_COPYSIGN(TB_SQRT(t44), t4 ? t42 : TB_C(0.0));
    const real_t t46 = tb_min(tb_min(TB_ABS(t14), TB_ABS(t29)), TB_ABS(t45));
    const real_t t47 = TB_C(1.0) / tb_min(TB_C(1.0), t46);
    const real_t t48 = TB_C(64.0) * TB_EPSILON * t47;
    const bool t49 = TB_C(0.0) <= moving[0];
    const real_t t50 = TB_C(1.0) / t14;
    const bool t51 = TB_C(0.0) < side[0];
    const real_t t52 = t51 ? structure[0] * TB_C(1000000000000.0) : TB_C(0.0);
    const bool t53 = TB_C(0.0) < side[1];
    const real_t t54 = t53 ? structure[1] * TB_C(1000000000000.0) : TB_C(0.0);
    const bool t55 = TB_C(0.0) < side[2];
    const real_t t56 = t55 ? structure[2] * TB_C(1000000000000.0) : TB_C(0.0);
    const bool t57 = TB_C(0.0) < side[3];
    const real_t t58 = t57 ? structure[3] * TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t59 = (wrench[0] - (t52 + t54 + t56 + t58)) * t50;
    const real_t t60 = (t0 ? structure[4] : TB_C(0.0)) - t15 * t21;
    const real_t t61 = TB_C(1.0) / t29;
    const real_t t62 = t51 ? structure[4] * TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t63 = t53 ? structure[5] * TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t64 = t55 ? structure[6] * TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t65 = t57 ? structure[7] * TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t66 = (wrench[1] - (t62 + t63 + t64 + t65) + t59 * t60) * t61;
    const real_t t67 = (t2 ? t37 : TB_C(0.0)) - t36 * t41;
    const real_t t68 = TB_C(1.0) / t45;
    const real_t t69 = t51 ? structure[8] * TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t70 = t53 ? structure[9] * TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t71 = t55 ? structure[10] * TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t72 = t57 ? structure[11] * TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t73 = (t0 ? structure[8] : TB_C(0.0)) - t15 * t34;
    const real_t t74 = wrench[2] - (t69 + t70 + t71 + t72) + t59 * t73 + t66 * t67;
    const real_t t75 = t68 * (t74 * t68);
    const real_t t76 = t61 * (t66 + t67 * t75);
    const real_t t77 = t50 * (t59 + t60 * t76 + t73 * t75);
    const real_t t78 = structure[2] * t77 + structure[6] * t76 + structure[10] * t75;
    const real_t t79 = TB_C(0.0) < t5 ? tb_max(-t78, t78 - TB_C(1000000000000.0)) : -TB_C(1.0);
    const real_t t80 = structure[3] * t77 + structure[7] * t76 + structure[11] * t75;
    const real_t t81 = TB_C(0.0) < t7 ? tb_max(-t80, t80 - TB_C(1000000000000.0)) : -TB_C(1.0);
    const real_t t82 = structure[0] * t77 + structure[4] * t76 + structure[8] * t75;
    const real_t t83 = TB_C(0.0) < t1 ? tb_max(-t82, t82 - TB_C(1000000000000.0)) : -TB_C(1.0);
    const real_t t84 = structure[1] * t77 + structure[5] * t76 + structure[9] * t75;
    const real_t t85 = TB_C(0.0) < t3 ? tb_max(-t84, t84 - TB_C(1000000000000.0)) : -TB_C(1.0);
    real_t t86, t87, t88, t89;
    if (t49) {
        t86 = moving[0] == TB_C(2.0) ? TB_C(1.0) : TB_C(0.0);
        t87 = TB_C(3.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
        t88 = TB_C(0.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
        t89 = TB_C(1.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
    } else {
        t86 = t79;
        t87 = t81;
        t88 = t83;
        t89 = t85;
    }
    const bool t90 = tb_max(t86, t87) <= tb_max(t88, t89);
    real_t t91, t92, t93, t94, t95;
    if (t90) {
        const bool t96 = t89 <= t88;
        t91 = t96 ? TB_C(0.0) : TB_C(1.0);
        t92 = t96 ? structure[0] : structure[1];
        t93 = t96 ? structure[4] : structure[5];
        t94 = t96 ? structure[8] : structure[9];
        t95 = t96 ? t82 : t84;
    } else {
        const bool t97 = t87 <= t86;
        t91 = t97 ? TB_C(2.0) : TB_C(3.0);
        t92 = t97 ? structure[2] : structure[3];
        t93 = t97 ? structure[6] : structure[7];
        t94 = t97 ? structure[10] : structure[11];
        t95 = t97 ? t78 : t80;
    }
    const real_t t98 = t50 * t92;
    const real_t t99 = t61 * (t93 + t60 * t98);
    const real_t t100 = t68 * (t68 * (t94 + t73 * t98 + t67 * t99));
    const real_t t101 = t61 * (t99 + t67 * t100);
    const real_t t102 = t50 * (t98 + t60 * t101 + t73 * t100);
    const real_t t103 = structure[0] * t102 + structure[4] * t101 + structure[8] * t100;
    const real_t t104 = (TB_C(0.0) == t91 ? TB_C(1.0) : TB_C(0.0)) - t103;
    const real_t t105 = structure[1] * t102 + structure[5] * t101 + structure[9] * t100;
    const real_t t106 = (TB_C(1.0) == t91 ? TB_C(1.0) : TB_C(0.0)) - t105;
    const real_t t107 = (t0 ? (t0 ? t104 * t104 : TB_C(0.0)) : TB_C(0.0)) + (t2 ? (t2 ? t106 *
        t106 : TB_C(0.0)) : TB_C(0.0));
    const real_t t108 = structure[2] * t102 + structure[6] * t101 + structure[10] * t100;
    const real_t t109 = (TB_C(2.0) == t91 ? TB_C(1.0) : TB_C(0.0)) - t108;
    const real_t t110 = t107 + (t4 ? (t4 ? t109 * t109 : TB_C(0.0)) : TB_C(0.0));
    const real_t t111 = structure[3] * t102 + structure[7] * t101 + structure[11] * t100;
    const real_t t112 = (TB_C(3.0) == t91 ? TB_C(1.0) : TB_C(0.0)) - t111;
    const real_t t113 = t110 + (t6 ? (t6 ? t112 * t112 : TB_C(0.0)) : TB_C(0.0));
    const bool t114 = TB_C(3.0) < t1 + t3 + t5 + t7 && t48 * t48 < t113;
    const real_t t115 = t95 + t113 * push[0];
    const bool t116 = t115 < TB_C(500000000000.0);
    real_t t117;
    if (t114) {
        const real_t t118 = tb_max(t116 ? -t115 : t115 - TB_C(1000000000000.0), TB_C(0.0));
        t117 = t118 * (TB_C(1.0) / t113);
    } else {
        t117 = TB_C(1e+30);
    }
    const real_t t119 = t116 ? TB_C(1.0) : -TB_C(1.0);
    const real_t t120 = side[0] * (t103 * t119);
    real_t t121;
    if (t48 < t120) {
        const real_t t122 = t82 - t103 * push[0] - (t51 ? TB_C(1000000000000.0) : TB_C(0.0));
        t121 = tb_max(side[0] * t122, TB_C(0.0)) / t120;
    } else {
        t121 = TB_C(1e+30);
    }
    const real_t t123 = side[1] * (t105 * t119);
    real_t t124;
    if (t48 < t123) {
        const real_t t125 = t84 - t105 * push[0] - (t53 ? TB_C(1000000000000.0) : TB_C(0.0));
        t124 = tb_max(side[1] * t125, TB_C(0.0)) / t123;
    } else {
        t124 = TB_C(1e+30);
    }
    const real_t t126 = side[2] * (t108 * t119);
    real_t t127;
    if (t48 < t126) {
        const real_t t128 = t78 - t108 * push[0] - (t55 ? TB_C(1000000000000.0) : TB_C(0.0));
        t127 = tb_max(side[2] * t128, TB_C(0.0)) / t126;
    } else {
        t127 = TB_C(1e+30);
    }
    const real_t t129 = side[3] * (t111 * t119);
    real_t t130;
    if (t48 < t129) {
        const real_t t131 = t80 - t111 * push[0] - (t57 ? TB_C(1000000000000.0) : TB_C(0.0));
        t130 = tb_max(side[3] * t131, TB_C(0.0)) / t129;
    } else {
        t130 = TB_C(1e+30);
    }
    const real_t t132 = tb_min(tb_min(tb_min(t121, t124), t127), t130);
    const bool t133 = t117 <= t132;
    const real_t t134 = TB_ABS(wrench[0]) + TB_ABS(wrench[1]) + TB_ABS(wrench[2]);
    const bool t135 = tb_max(tb_max(tb_max(t83, t85), t79), t81) <= t47 * (TB_EPSILON *
        TB_C(8.0) * t134);
    const bool t136 = (!t49 && t135) || !(tb_min(t117, t132) < TB_C(1e+30));
    const real_t t137 = t133 && !t136 ? t91 : -TB_C(1.0);
    const real_t t138 = -t119;
    real_t t139;
    if (t133 || t136) {
        t139 = -TB_C(1.0);
    } else {
        const real_t t140 = -t127;
        const real_t t141 = -t130;
        const real_t t142 = -t121;
        const real_t t143 = -t124;
        const real_t t144 = tb_max(t140, t141) <= tb_max(t142, t143) ? (t143 <= t142 ?
            TB_C(0.0) : TB_C(1.0)) : (t141 <= t140 ? TB_C(2.0) : TB_C(3.0));
        t139 = t144;
    }
    const real_t side_0 = TB_C(0.0) == t137 ? t138 : (TB_C(0.0) == t139 ? TB_C(0.0) : side[0]);
    const real_t side_1 = TB_C(1.0) == t137 ? t138 : (TB_C(1.0) == t139 ? TB_C(0.0) : side[1]);
    const real_t side_2 = TB_C(2.0) == t137 ? t138 : (TB_C(2.0) == t139 ? TB_C(0.0) : side[2]);
    const real_t side_3 = TB_C(3.0) == t137 ? t138 : (TB_C(3.0) == t139 ? TB_C(0.0) : side[3]);
    const real_t moving_0 = t133 ? -TB_C(1.0) : t91;
    const real_t push_0 = t133 ? TB_C(0.0) : push[0] + t119 * t132;
    const real_t done_0 = t136 ? TB_C(1.0) : TB_C(0.0);
    side[0] = side_0;
    side[1] = side_1;
    side[2] = side_2;
    side[3] = side_3;
    moving[0] = moving_0;
    push[0] = push_0;
    done[0] = done_0;
    return TB_OK;
}

/* The tensions, refined and judged. */
static tb_status tb_distribute_tension_paper_finish(const real_t structure[12], const real_t wrench[3],
    const real_t pivot[1], const real_t side[4], real_t tension[4], real_t delivered[3],
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
    const real_t t9 = wrench[0] - (t2 + t4 + t6 + t8);
    const bool t10 = TB_C(0.0) == side[0];
    const real_t t11 = t10 ? (t10 ? structure[0] * structure[0] : TB_C(0.0)) : TB_C(0.0);
    const bool t12 = TB_C(0.0) == side[1];
    const real_t t13 = t12 ? (t12 ? structure[1] * structure[1] : TB_C(0.0)) : TB_C(0.0);
    const bool t14 = TB_C(0.0) == side[2];
    const real_t t15 = t14 ? (t14 ? structure[2] * structure[2] : TB_C(0.0)) : TB_C(0.0);
    const bool t16 = TB_C(0.0) == side[3];
    const real_t t17 = t16 ? (t16 ? structure[3] * structure[3] : TB_C(0.0)) : TB_C(0.0);
    const real_t t18 = TB_SQRT(t11 + t13 + t15 + t17);
    const real_t t19 = t10 ? structure[0] : TB_C(0.0);
    const real_t t20 = TB_COPYSIGN(t18, t19);
    const real_t t21 = TB_C(1.0) / t20;
    const real_t t22 = t9 * t21;
    const real_t t23 = t19 + t20;
    const real_t t24 = t12 ? (t12 ? structure[1] * structure[5] : TB_C(0.0)) : TB_C(0.0);
    const real_t t25 = t14 ? (t14 ? structure[2] * structure[6] : TB_C(0.0)) : TB_C(0.0);
    const real_t t26 = (t10 ? structure[4] * t23 : TB_C(0.0)) + t24 + t25;
    const real_t t27 = t16 ? (t16 ? structure[3] * structure[7] : TB_C(0.0)) : TB_C(0.0);
    const real_t t28 = TB_C(1.0) / (t18 * (t18 + TB_ABS(t19)));
    const real_t t29 = (t26 + t27) * t28;
    const real_t t30 = (t10 ? structure[4] : TB_C(0.0)) - t23 * t29;
    const real_t t31 = t0 ? TB_C(1000000000000.0) * structure[4] : TB_C(0.0);
    const real_t t32 = t3 ? TB_C(1000000000000.0) * structure[5] : TB_C(0.0);
    const real_t t33 = t5 ? TB_C(1000000000000.0) * structure[6] : TB_C(0.0);
    const real_t t34 = t7 ? TB_C(1000000000000.0) * structure[7] : TB_C(0.0);
    const real_t t35 = wrench[1] - (t31 + t32 + t33 + t34);
    const real_t t36 = structure[5] - structure[1] * t29;
    const real_t t37 = structure[6] - structure[2] * t29;
    const real_t t38 = (t12 ? (t12 ? t36 * t36 : TB_C(0.0)) : TB_C(0.0)) + (t14 ? (t14 ? t37 *
        t37 : TB_C(0.0)) : TB_C(0.0));
    const real_t t39 = structure[7] - structure[3] * t29;
    const real_t t40 = t38 + (t16 ? (t16 ? t39 * t39 : TB_C(0.0)) : TB_C(0.0));
    const real_t t41 = TB_SQRT(t40);
    const real_t t42 = t12 ? t36 : TB_C(0.0);
    const real_t t43 = TB_COPYSIGN(t41, t42);
    const real_t t44 = TB_C(1.0) / t43;
    const real_t t45 = (t35 + t22 * t30) * t44;
    const real_t t46 = t12 ? (t12 ? structure[1] * structure[9] : TB_C(0.0)) : TB_C(0.0);
    const real_t t47 = t14 ? (t14 ? structure[2] * structure[10] : TB_C(0.0)) : TB_C(0.0);
    const real_t t48 = (t10 ? t23 * structure[8] : TB_C(0.0)) + t46 + t47;
    const real_t t49 = t16 ? (t16 ? structure[3] * structure[11] : TB_C(0.0)) : TB_C(0.0);
    const real_t t50 = t28 * (t48 + t49);
    const real_t t51 = structure[9] - structure[1] * t50;
    const real_t t52 = t42 + t43;
    const real_t t53 = structure[10] - structure[2] * t50;
    const real_t t54 = (t12 ? t51 * t52 : TB_C(0.0)) + (t14 ? (t14 ? t37 * t53 : TB_C(0.0)) :
        TB_C(0.0));
    const real_t t55 = structure[11] - structure[3] * t50;
    const real_t t56 = t54 + (t16 ? (t16 ? t39 * t55 : TB_C(0.0)) : TB_C(0.0));
    const real_t t57 = t56 / (t41 * (t41 + TB_ABS(t42)));
    const real_t t58 = (t12 ? t51 : TB_C(0.0)) - t52 * t57;
    const real_t t59 = t0 ? TB_C(1000000000000.0) * structure[8] : TB_C(0.0);
    const real_t t60 = t3 ? TB_C(1000000000000.0) * structure[9] : TB_C(0.0);
    const real_t t61 = t5 ? TB_C(1000000000000.0) * structure[10] : TB_C(0.0);
    const real_t t62 = t7 ? TB_C(1000000000000.0) * structure[11] : TB_C(0.0);
    const real_t t63 = wrench[2] - (t59 + t60 + t61 + t62);
    const real_t t64 = (t10 ? structure[8] : TB_C(0.0)) - t23 * t50;
    const real_t t65 = t53 - t37 * t57;
    const real_t t66 = t55 - t39 * t57;
    const real_t t67 = (t14 ? (t14 ? t65 * t65 : TB_C(0.0)) : TB_C(0.0)) + (t16 ? (t16 ? t66 *
        t66 : TB_C(0.0)) : TB_C(0.0));
    const real_t t68 = TB_COPYSIGN(TB_SQRT(t67), t14 ? t65 : TB_C(0.0));
    const real_t t69 = TB_C(1.0) / t68;
    const real_t t70 = t69 * ((t63 + t22 * t64 + t45 * t58) * t69);
    const real_t t71 = t44 * (t45 + t58 * t70);
    const real_t t72 = t21 * (t22 + t30 * t71 + t64 * t70);
    const real_t t73 = structure[0] * t72 + structure[4] * t71 + structure[8] * t70;
    const real_t t74 = structure[1] * t72 + structure[5] * t71 + structure[9] * t70;
    const real_t t75 = (t10 ? structure[0] * t73 : TB_C(0.0)) + (t12 ? structure[1] * t74 :
        TB_C(0.0));
    const real_t t76 = structure[2] * t72 + structure[6] * t71 + structure[10] * t70;
    const real_t t77 = structure[3] * t72 + structure[7] * t71 + structure[11] * t70;
    const real_t t78 = t75 + (t14 ? structure[2] * t76 : TB_C(0.0)) + (t16 ? structure[3] * t77
        : TB_C(0.0));
    const real_t t79 = t21 * (t9 - t78);
    const real_t t80 = (t10 ? structure[4] * t73 : TB_C(0.0)) + (t12 ? structure[5] * t74 :
        TB_C(0.0));
    const real_t t81 = t80 + (t14 ? structure[6] * t76 : TB_C(0.0)) + (t16 ? structure[7] * t77
        : TB_C(0.0));
    const real_t t82 = t44 * (t35 - t81 + t30 * t79);
    const real_t t83 = (t10 ? structure[8] * t73 : TB_C(0.0)) + (t12 ? structure[9] * t74 :
        TB_C(0.0));
    const real_t t84 = t83 + (t14 ? structure[10] * t76 : TB_C(0.0)) + (t16 ? structure[11] *
        t77 : TB_C(0.0));
    const real_t t85 = t69 * (t69 * (t63 - t84 + t64 * t79 + t58 * t82));
    const real_t t86 = t44 * (t82 + t58 * t85);
    const real_t t87 = t21 * (t79 + t30 * t86 + t64 * t85);
    const real_t t88 = structure[0] * t87 + structure[4] * t86 + structure[8] * t85;
    const real_t t89 = t73 + t88;
    const real_t t90 = t3 ? TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t91 = structure[1] * t87 + structure[5] * t86 + structure[9] * t85;
    const real_t t92 = t74 + t91;
    const real_t t93 = tb_max(side[0] * (t1 - t89), side[1] * (t90 - t92));
    const real_t t94 = t5 ? TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t95 = structure[2] * t87 + structure[6] * t86 + structure[10] * t85;
    const real_t t96 = t76 + t95;
    const real_t t97 = t7 ? TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t98 = structure[3] * t87 + structure[7] * t86 + structure[11] * t85;
    const real_t t99 = t77 + t98;
    const real_t t100 = tb_max(tb_max(t93, side[2] * (t94 - t96)), side[3] * (t97 - t99));
    const real_t t101 = tb_min(tb_min(TB_ABS(t20), TB_ABS(t43)), TB_ABS(t68));
    const real_t t102 = tb_max(TB_C(0.0), t100) * tb_min(TB_C(1.0), t101);
    const real_t t103 = TB_ABS(wrench[0]) + TB_ABS(wrench[1]) + TB_ABS(wrench[2]);
    const real_t t104 = tb_max(tb_max(TB_ABS(t72), TB_ABS(t71)), TB_ABS(t70));
    const real_t t105 = tb_min(tb_max(t10 ? t89 : t1, TB_C(0.0)), TB_C(1000000000000.0));
    const real_t t106 = tb_min(tb_max(t12 ? t92 : t90, TB_C(0.0)), TB_C(1000000000000.0));
    const real_t t107 = tb_min(tb_max(t14 ? t96 : t94, TB_C(0.0)), TB_C(1000000000000.0));
    const real_t t108 = structure[0] * t105 + structure[1] * t106 + structure[2] * t107;
    const real_t t109 = tb_min(tb_max(t16 ? t99 : t97, TB_C(0.0)), TB_C(1000000000000.0));
    const real_t t110 = tb_max(t102 * t103 * (TB_C(1.0) / tb_max(t103, t104)), TB_ABS(t108 +
        structure[3] * t109 - wrench[0]));
    const real_t t111 = structure[4] * t105 + structure[5] * t106 + structure[6] * t107;
    const real_t t112 = tb_max(t110, TB_ABS(t111 + structure[7] * t109 - wrench[1]));
    const real_t t113 = structure[8] * t105 + structure[9] * t106 + structure[10] * t107;
    const real_t t114 = tb_max(t112, TB_ABS(t113 + structure[11] * t109 - wrench[2]));
    const real_t t115 = TB_C(128.0) * TB_EPSILON * tb_max(tb_max(tb_max(t105, t106), t107),
        t109);
    const real_t t116 = tb_min(t115 * (TB_C(1.0) / pivot[0]), TB_C(0.02));
    const bool t117 = t114 <= t116;
    real_t tension_0, tension_1, tension_2, tension_3, delivered_0, delivered_1, delivered_2,
        kkt_residual_0;
    if (t117) {
        const real_t t118 = tb_min(t105, TB_TENSION_MAX);
        const real_t t119 = tb_min(t106, TB_TENSION_MAX);
        const real_t t120 = tb_min(t107, TB_TENSION_MAX);
        const real_t t121 = tb_min(t109, TB_TENSION_MAX);
        const real_t t122 = structure[0] * t118 + structure[1] * t119 + structure[2] * t120;
        const real_t t123 = structure[4] * t118 + structure[5] * t119 + structure[6] * t120;
        const real_t t124 = structure[8] * t118 + structure[9] * t119 + structure[10] * t120;
        tension_0 = t118;
        tension_1 = t119;
        tension_2 = t120;
        tension_3 = t121;
        delivered_0 = t122 + structure[3] * t121;
        delivered_1 = t123 + structure[7] * t121;
        delivered_2 = t124 + structure[11] * t121;
        kkt_residual_0 = t114;
    } else {
        tension_0 = TB_C(0.0);
        tension_1 = TB_C(0.0);
        tension_2 = TB_C(0.0);
        tension_3 = TB_C(0.0);
        delivered_0 = TB_C(0.0);
        delivered_1 = TB_C(0.0);
        delivered_2 = TB_C(0.0);
        kkt_residual_0 = TB_C(0.0);
    }
    const bool t125 = !t117;
    const bool t126 = TB_TENSION_MAX < t105 || TB_TENSION_MAX < t106 || TB_TENSION_MAX < t107;
    const bool t127 = t126 || TB_TENSION_MAX < t109;
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    delivered[0] = delivered_0;
    delivered[1] = delivered_1;
    delivered[2] = delivered_2;
    kkt_residual[0] = kkt_residual_0;
    return (t125 || t127) ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_distribute_tension_paper(const real_t structure[12], const real_t wrench[3],
    real_t tension[4], real_t delivered[3], real_t kkt_residual[1])
{
    real_t pivot[1];
    real_t side[4];
    real_t moving[1];
    real_t push[1];
    real_t done[1] = {TB_C(0.0)};
    tb_status status = tb_distribute_tension_paper_begin(structure, wrench, pivot, side,
        moving, push);
    for (int steps = 0; steps < 20 && status == TB_OK && !(done[0] > TB_C(0.0)); steps++) {
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
static tb_status tb_served_wrench_closest_begin(const real_t structure[12], const real_t wrench[3],
    real_t points[12], real_t weight[4], real_t used[4], real_t offset[3])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) + TB_ABS(structure[10]) + TB_ABS(structure[11]) <= TB_C(48.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) + TB_ABS(wrench[2]) <= TB_C(240000.0))) {
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
    const real_t t1 = TB_C(10.0) * t0 - wrench[0];
    const real_t t2 = structure[4] + structure[5] + structure[6] + structure[7];
    const real_t t3 = TB_C(10.0) * t2 - wrench[1];
    const real_t t4 = structure[8] + structure[9] + structure[10] + structure[11];
    const real_t t5 = TB_C(10.0) * t4 - wrench[2];
    const real_t t6 = structure[0] * t1 + structure[4] * t3 + structure[8] * t5;
    const bool t7 = t6 < TB_C(0.0);
    const real_t t8 = structure[1] * t1 + structure[5] * t3 + structure[9] * t5;
    const bool t9 = t8 < TB_C(0.0);
    const real_t t10 = (t7 ? structure[0] * TB_TENSION_MAX : TB_C(0.0)) + (t9 ? structure[1] *
        TB_TENSION_MAX : TB_C(0.0));
    const real_t t11 = structure[2] * t1 + structure[6] * t3 + structure[10] * t5;
    const bool t12 = t11 < TB_C(0.0);
    const real_t t13 = t10 + (t12 ? structure[2] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t14 = structure[3] * t1 + structure[7] * t3 + structure[11] * t5;
    const bool t15 = t14 < TB_C(0.0);
    const real_t t16 = t13 + (t15 ? structure[3] * TB_TENSION_MAX : TB_C(0.0));
    const real_t points_0 = t16 - wrench[0];
    const real_t t17 = (t7 ? structure[4] * TB_TENSION_MAX : TB_C(0.0)) + (t9 ? structure[5] *
        TB_TENSION_MAX : TB_C(0.0));
    const real_t t18 = t17 + (t12 ? structure[6] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t19 = t18 + (t15 ? structure[7] * TB_TENSION_MAX : TB_C(0.0));
    const real_t points_1 = t19 - wrench[1];
    const real_t t20 = (t7 ? structure[8] * TB_TENSION_MAX : TB_C(0.0)) + (t9 ? structure[9] *
        TB_TENSION_MAX : TB_C(0.0));
    const real_t t21 = t20 + (t12 ? structure[10] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t22 = t21 + (t15 ? structure[11] * TB_TENSION_MAX : TB_C(0.0));
    const real_t points_2 = t22 - wrench[2];
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
static tb_status tb_served_wrench_closest_step(const real_t structure[12], const real_t wrench[3],
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
    const real_t t172 = offset_0 * structure[0] + structure[4] * offset_1;
    const real_t t173 = t88 ? -(t88 ? t93 * t169 : TB_C(0.0)) : TB_C(0.0);
    const real_t offset_2 = t168 + t173;
    const bool t174 = t172 + structure[8] * offset_2 < TB_C(0.0);
    const real_t t175 = offset_0 * structure[1] + offset_1 * structure[5];
    const bool t176 = t175 + offset_2 * structure[9] < TB_C(0.0);
    const real_t t177 = (t174 ? structure[0] * TB_TENSION_MAX : TB_C(0.0)) + (t176 ?
        TB_TENSION_MAX * structure[1] : TB_C(0.0));
    const real_t t178 = offset_0 * structure[2] + offset_1 * structure[6];
    const bool t179 = t178 + offset_2 * structure[10] < TB_C(0.0);
    const real_t t180 = t177 + (t179 ? TB_TENSION_MAX * structure[2] : TB_C(0.0));
    const real_t t181 = offset_0 * structure[3] + offset_1 * structure[7];
    const bool t182 = t181 + offset_2 * structure[11] < TB_C(0.0);
    const real_t t183 = t180 + (t182 ? TB_TENSION_MAX * structure[3] : TB_C(0.0));
    const real_t t184 = t183 - wrench[0];
    const real_t t185 = (t174 ? structure[4] * TB_TENSION_MAX : TB_C(0.0)) + (t176 ?
        TB_TENSION_MAX * structure[5] : TB_C(0.0));
    const real_t t186 = t185 + (t179 ? TB_TENSION_MAX * structure[6] : TB_C(0.0));
    const real_t t187 = t186 + (t182 ? TB_TENSION_MAX * structure[7] : TB_C(0.0));
    const real_t t188 = t187 - wrench[1];
    const real_t t189 = offset_0 * (offset_0 - t184) + offset_1 * (offset_1 - t188);
    const real_t t190 = (t174 ? structure[8] * TB_TENSION_MAX : TB_C(0.0)) + (t176 ?
        TB_TENSION_MAX * structure[9] : TB_C(0.0));
    const real_t t191 = t190 + (t179 ? TB_TENSION_MAX * structure[10] : TB_C(0.0));
    const real_t t192 = t191 + (t182 ? TB_TENSION_MAX * structure[11] : TB_C(0.0));
    const real_t t193 = t192 - wrench[2];
    const real_t t194 = TB_ABS(wrench[0]) + TB_ABS(wrench[1]) + TB_ABS(wrench[2]);
    const real_t t195 = offset_0 * offset_0 + offset_1 * offset_1 + offset_2 * offset_2;
    const real_t t196 = TB_SQRT(t195);
    const real_t t197 = TB_C(64.0) * TB_EPSILON * (TB_C(80.0) + t194) * t196;
    const bool t198 = t189 + offset_2 * (offset_2 - t193) <= t197 || t196 <= TB_EPSILON *
        TB_C(1280.0);
    const bool t199 = !t120 && (t198 || (t3 && (t1 && (t0 && t6))));
    real_t t200;
    if (t120 || t199) {
        t200 = -TB_C(1.0);
    } else {
        const real_t t201 = t1 ? -TB_C(1.0) : TB_C(2.0);
        const real_t t202 = t3 ? -TB_C(1.0) : TB_C(1.0);
        const real_t t203 = t0 ? -TB_C(1.0) : TB_C(4.0);
        const real_t t204 = t6 ? -TB_C(1.0) : TB_C(3.0);
        const real_t t205 = tb_max(t201, t202) <= tb_max(t203, t204) ? (t204 <= t203 ?
            TB_C(0.0) : TB_C(1.0)) : (t202 <= t201 ? TB_C(2.0) : TB_C(3.0));
        t200 = t205;
    }
    const bool t206 = TB_C(0.0) == t200;
    const real_t points_0 = t206 ? t184 : points[0];
    const real_t points_1 = t206 ? t188 : points[1];
    const real_t points_2 = t206 ? t193 : points[2];
    const bool t207 = TB_C(1.0) == t200;
    const real_t points_3 = t207 ? t184 : points[3];
    const real_t points_4 = t207 ? t188 : points[4];
    const real_t points_5 = t207 ? t193 : points[5];
    const bool t208 = TB_C(2.0) == t200;
    const real_t points_6 = t208 ? t184 : points[6];
    const real_t points_7 = t208 ? t188 : points[7];
    const real_t points_8 = t208 ? t193 : points[8];
    const bool t209 = TB_C(3.0) == t200;
    const real_t points_9 = t209 ? t184 : points[9];
    const real_t points_10 = t209 ? t188 : points[10];
    const real_t points_11 = t209 ? t193 : points[11];
    const real_t t210 = -t116;
    const real_t t211 = -t118;
    const real_t t212 = -t112;
    const real_t t213 = -t114;
    const real_t t214 = tb_max(t210, t211) <= tb_max(t212, t213) ? (t213 <= t212 ? TB_C(0.0) :
        TB_C(1.0)) : (t211 <= t210 ? TB_C(2.0) : TB_C(3.0));
    const real_t t215 = t120 ? t214 : -TB_C(1.0);
    const bool t216 = TB_C(0.0) == t215;
    const real_t t217 = t216 ? TB_C(0.0) : weight[0] + t119 * (t111 - weight[0]);
    const real_t weight_0 = t120 ? t217 : t111;
    const bool t218 = TB_C(1.0) == t215;
    const real_t t219 = t218 ? TB_C(0.0) : weight[1] + t119 * (t113 - weight[1]);
    const real_t weight_1 = t120 ? t219 : t113;
    const bool t220 = TB_C(2.0) == t215;
    const real_t t221 = t220 ? TB_C(0.0) : weight[2] + t119 * (t115 - weight[2]);
    const real_t weight_2 = t120 ? t221 : t115;
    const bool t222 = TB_C(3.0) == t215;
    const real_t t223 = t222 ? TB_C(0.0) : weight[3] + t119 * (t117 - weight[3]);
    const real_t weight_3 = t120 ? t223 : t117;
    const real_t used_0 = t206 ? TB_C(1.0) : (t216 ? TB_C(0.0) : used[0]);
    const real_t used_1 = t207 ? TB_C(1.0) : (t218 ? TB_C(0.0) : used[1]);
    const real_t used_2 = t208 ? TB_C(1.0) : (t220 ? TB_C(0.0) : used[2]);
    const real_t used_3 = t209 ? TB_C(1.0) : (t222 ? TB_C(0.0) : used[3]);
    const real_t done_0 = t199 ? TB_C(1.0) : TB_C(0.0);
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
static tb_status tb_served_wrench_closest_finish(const real_t structure[12], const real_t wrench[3],
    const real_t offset[3], real_t served[3], real_t inner[3])
{
    const real_t t0 = offset[0] * offset[0] + offset[1] * offset[1] + offset[2] * offset[2];
    const real_t t1 = TB_SQRT(t0);
    const bool t2 = t1 <= TB_C(1280.0) * TB_EPSILON;
    const bool t3 = !t2;
    const real_t t4 = structure[0] + structure[1] + structure[2] + structure[3];
    const real_t t5 = TB_C(10.0) * t4;
    const real_t t6 = structure[4] + structure[5] + structure[6] + structure[7];
    const real_t t7 = TB_C(10.0) * t6;
    const real_t t8 = structure[8] + structure[9] + structure[10] + structure[11];
    const real_t t9 = TB_C(10.0) * t8;
    real_t served_0, served_1, served_2;
    if (t2) {
        served_0 = wrench[0];
        served_1 = wrench[1];
        served_2 = wrench[2];
    } else {
        const real_t t10 = offset[0] + wrench[0];
        const real_t t11 = TB_EPSILON * TB_C(32.0);
        const real_t t12 = offset[1] + wrench[1];
        const real_t t13 = offset[2] + wrench[2];
        served_0 = t10 + t11 * (t5 - t10);
        served_1 = t12 + t11 * (t7 - t12);
        served_2 = t13 + t11 * (t9 - t13);
    }
    const real_t inner_0 = served_0 + TB_C(3.814697265625e-06) * (t5 - served_0);
    const real_t inner_1 = served_1 + TB_C(3.814697265625e-06) * (t7 - served_1);
    const real_t inner_2 = served_2 + TB_C(3.814697265625e-06) * (t9 - served_2);
    const real_t t14 = offset[0] * structure[0] + offset[1] * structure[4];
    const bool t15 = t14 + offset[2] * structure[8] < TB_C(0.0);
    const real_t t16 = offset[0] * structure[1] + offset[1] * structure[5];
    const bool t17 = t16 + offset[2] * structure[9] < TB_C(0.0);
    const real_t t18 = (t15 ? structure[0] * TB_TENSION_MAX : TB_C(0.0)) + (t17 ? structure[1]
        * TB_TENSION_MAX : TB_C(0.0));
    const real_t t19 = offset[0] * structure[2] + offset[1] * structure[6];
    const bool t20 = t19 + offset[2] * structure[10] < TB_C(0.0);
    const real_t t21 = t18 + (t20 ? structure[2] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t22 = offset[0] * structure[3] + offset[1] * structure[7];
    const bool t23 = t22 + offset[2] * structure[11] < TB_C(0.0);
    const real_t t24 = t21 + (t23 ? structure[3] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t25 = (t15 ? structure[4] * TB_TENSION_MAX : TB_C(0.0)) + (t17 ? structure[5]
        * TB_TENSION_MAX : TB_C(0.0));
    const real_t t26 = t25 + (t20 ? structure[6] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t27 = t26 + (t23 ? structure[7] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t28 = offset[0] * (offset[0] - (t24 - wrench[0])) + offset[1] * (offset[1] -
        (t27 - wrench[1]));
    const real_t t29 = (t15 ? structure[8] * TB_TENSION_MAX : TB_C(0.0)) + (t17 ? structure[9]
        * TB_TENSION_MAX : TB_C(0.0));
    const real_t t30 = t29 + (t20 ? structure[10] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t31 = t30 + (t23 ? structure[11] * TB_TENSION_MAX : TB_C(0.0));
    const real_t t32 = t28 + offset[2] * (offset[2] - (t31 - wrench[2]));
    const real_t t33 = TB_ABS(wrench[0]) + TB_ABS(wrench[1]) + TB_ABS(wrench[2]);
    const real_t t34 = t1 * (TB_EPSILON * TB_C(64.0) * (TB_C(80.0) + t33));
    const bool t35 = !(t2 || t32 <= t34);
    if (t35) {
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

tb_status tb_served_wrench_closest(const real_t structure[12], const real_t wrench[3],
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

/* Refuses with a status: asked is 0 N; inside is 0; largest is 0; first is 0; last is 0. */
static tb_status tb_refuse_wrench_ray_begin(tb_status status, real_t asked[3], real_t inside[1],
    real_t largest[1], real_t first[1], real_t last[1])
{
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
static tb_status tb_wrench_ray_begin(const real_t structure[12], const real_t wrench[3],
    real_t asked[3], real_t inside[1], real_t largest[1], real_t first[1], real_t last[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) + TB_ABS(structure[10]) + TB_ABS(structure[11]) <= TB_C(48.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) + TB_ABS(wrench[2]) <= TB_C(240000.0))) {
        return tb_refuse_wrench_ray_begin(TB_OUT_OF_DOMAIN, asked, inside, largest, first, last);
    }
    const real_t t0 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const real_t t1 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t2 = t1 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t3 = TB_SQRT(t2);
    const real_t t4 = TB_COPYSIGN(t3, structure[0]);
    const real_t t5 = structure[0] + t4;
    const real_t t6 = t5 * structure[4] + structure[1] * structure[5] + structure[2] *
        structure[6];
    const real_t t7 = TB_C(1.0) / (t3 * (t3 + TB_ABS(structure[0])));
    const real_t t8 = (t6 + structure[3] * structure[7]) * t7;
    const real_t t9 = structure[5] - structure[1] * t8;
    const real_t t10 = structure[6] - structure[2] * t8;
    const real_t t11 = structure[7] - structure[3] * t8;
    const real_t t12 = TB_SQRT(t9 * t9 + t10 * t10 + t11 * t11);
    const real_t t13 = TB_COPYSIGN(t12, t9);
    const real_t t14 = t5 * structure[8] + structure[1] * structure[9] + structure[2] *
        structure[10];
    const real_t t15 = t7 * (t14 + structure[3] * structure[11]);
    const real_t t16 = structure[10] - structure[2] * t15;
    const real_t t17 = (t9 + t13) * (structure[9] - structure[1] * t15) + t10 * t16;
    const real_t t18 = structure[11] - structure[3] * t15;
    const real_t t19 = (t17 + t11 * t18) / (t12 * (t12 + TB_ABS(t9)));
    const real_t t20 = t16 - t10 * t19;
    const real_t t21 = t18 - t11 * t19;
    const real_t t22 = TB_ABS(TB_COPYSIGN(TB_SQRT(t20 * t20 + t21 * t21), t20));
    const bool t23 = !(t0 < TB_ABS(t4) && t0 < TB_ABS(t13) && t0 < t22);
    if (t23) {
        return tb_refuse_wrench_ray_begin(TB_SINGULAR, asked, inside, largest, first, last);
    }
    asked[0] = wrench[0];
    asked[1] = wrench[1];
    asked[2] = wrench[2];
    inside[0] = TB_C(1.0);
    largest[0] = TB_C(1.0);
    first[0] = TB_C(0.0);
    last[0] = TB_C(1.0);
    return TB_OK;
}

/* One subset. */
static tb_status tb_wrench_ray_visit(const real_t chosen[6], const real_t numbers[2],
    const real_t structure[12], const real_t asked[3], real_t inside[1], real_t largest[1],
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
    const real_t t15 = t12 * structure[0] + t13 * structure[4] + t14 * structure[8];
    const real_t t16 = t10 ? TB_C(0.0) : t15;
    const bool t17 = (numbers[0] == TB_C(1.0)) || (numbers[1] == TB_C(1.0));
    const real_t t18 = t12 * structure[1] + t13 * structure[5] + t14 * structure[9];
    const real_t t19 = t17 ? TB_C(0.0) : t18;
    const bool t20 = (numbers[0] == TB_C(2.0)) || (numbers[1] == TB_C(2.0));
    const real_t t21 = t12 * structure[2] + t13 * structure[6] + t14 * structure[10];
    const real_t t22 = t20 ? TB_C(0.0) : t21;
    const bool t23 = (numbers[0] == TB_C(3.0)) || (numbers[1] == TB_C(3.0));
    const real_t t24 = t12 * structure[3] + t13 * structure[7] + t14 * structure[11];
    const real_t t25 = t23 ? TB_C(0.0) : t24;
    const real_t t26 = TB_ABS(t16) + TB_ABS(t19) + TB_ABS(t22) + TB_ABS(t25);
    const real_t t27 = TB_C(10.0) * t26;
    const real_t t28 = t12 * asked[0] + t13 * asked[1] + t14 * asked[2];
    const real_t t29 = TB_C(10.0) * (t25 + (t22 + (t16 + t19)));
    const real_t inside_0 = t9 && t27 < TB_ABS(t28 - t29) ? TB_C(0.0) : inside[0];
    real_t largest_0, first_0, last_0;
    if (t9) {
        const real_t t30 = TB_EPSILON * TB_C(320.0);
        const bool t31 = t30 < TB_ABS(t28);
        real_t t32, t33, t34;
        if (t31) {
            const real_t t35 = TB_C(1.0) / t28;
            const real_t t36 = t35 * (t29 - t27 - t30);
            const real_t t37 = t35 * (t30 + (t27 + t29));
            t32 = (t29 + TB_COPYSIGN(t27, t28)) * t35;
            t33 = tb_min(t36, t37);
            t34 = tb_max(t36, t37);
        } else {
            const real_t t38 = t27 + t30 < TB_ABS(t29) ? TB_C(1e+30) : TB_C(0.0);
            t32 = TB_C(1.0);
            t33 = t38;
            t34 = TB_C(1.0);
        }
        largest_0 = tb_min(largest[0], t32);
        first_0 = tb_max(first[0], t33);
        last_0 = tb_min(last[0], t34);
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
static tb_status tb_wrench_ray(const real_t structure[12], const real_t wrench[3], real_t feasible[1],
    real_t fraction[1], real_t missed[1])
{
    static const unsigned char subsets[6][2] = {{0,1}, {0,2}, {0,3}, {1,2}, {1,3}, {2,3}};
    real_t asked[3];
    real_t inside[1];
    real_t largest[1];
    real_t first[1];
    real_t last[1];
    const tb_status status = tb_wrench_ray_begin(structure, wrench, asked, inside, largest,
        first, last);
    if (status != TB_OK) {
        feasible[0] = TB_C(0.0);
        fraction[0] = TB_C(0.0);
        missed[0] = TB_C(0.0);
        return status;
    }
    for (int k = 0; k < 6; k++) {
        real_t chosen[6];
        real_t numbers[2];
        for (int j = 0; j < 2; j++) {
            const int number = subsets[k][j];
            for (int i = 0; i < 3; i++) {
                chosen[2 * i + j] = structure[4 * i + number];
            }
            numbers[j] = (real_t)number;
        }
        (void)tb_wrench_ray_visit(chosen, numbers, structure, asked, inside, largest, first,
            last);
    }
    return tb_wrench_ray_finish(inside, largest, first, last, feasible, fraction, missed);
}

/* The wrench that is served: an infeasible one keeps its direction and is scaled down to the
 *   largest feasible fraction. */
static tb_status tb_served_fraction(const real_t structure[12], const real_t wrench[3],
    const real_t feasible[1], const real_t fraction[1], const real_t missed[1],
    const real_t closest[3], real_t served[3], real_t inner[3])
{
    const bool t0 = TB_C(0.0) < feasible[0];
    const bool t1 = !t0;
    const real_t t2 = structure[0] + structure[1] + structure[2] + structure[3];
    const real_t t3 = TB_C(10.0) * t2;
    const real_t t4 = structure[4] + structure[5] + structure[6] + structure[7];
    const real_t t5 = TB_C(10.0) * t4;
    const real_t t6 = structure[8] + structure[9] + structure[10] + structure[11];
    const real_t t7 = TB_C(10.0) * t6;
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

tb_status tb_served_wrench_scale(const real_t structure[12], const real_t wrench[3],
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

tb_status tb_distribute_tension_scale(const real_t structure[12], const real_t wrench[3],
    real_t tension[4], real_t delivered[3], real_t kkt_residual[1])
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

tb_status tb_distribute_tension_closest(const real_t structure[12], const real_t wrench[3],
    real_t tension[4], real_t delivered[3], real_t kkt_residual[1])
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

tb_status tb_distribute_tension(const real_t structure[12], const real_t wrench[3],
    real_t tension[4], real_t delivered[3], real_t kkt_residual[1])
{
    return tb_distribute_tension_closest(structure, wrench, tension, delivered, kkt_residual);
}

