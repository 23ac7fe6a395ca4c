/* Regenerate: turnbuckle generate machines/brau_triangle.toml --out <this folder>
 * Machine 62d2624dcb098eaa, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_tension.h"
#include "tb_machine.h"

/* Refuses with a status: tension is 0 N; delivered is 0 N; kkt_residual is 0 N. */
static tb_status tb_refuse_least_norm_tension(tb_status status, real_t tension[3],
    real_t delivered[2], real_t kkt_residual[1])
{
    tension[0] = TB_C(0.0);
    tension[1] = TB_C(0.0);
    tension[2] = TB_C(0.0);
    delivered[0] = TB_C(0.0);
    delivered[1] = TB_C(0.0);
    kkt_residual[0] = TB_C(0.0);
    return status;
}

tb_status tb_least_norm_tension(const real_t structure[6], const real_t wrench[2],
    real_t tension[3], real_t delivered[2], real_t kkt_residual[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) <= TB_C(24.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(120000.0))) {
        return tb_refuse_least_norm_tension(TB_OUT_OF_DOMAIN, tension, delivered, kkt_residual);
    }
    const real_t t0 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t1 = TB_SQRT(t0 + structure[2] * structure[2]);
    const real_t t2 = TB_COPYSIGN(t1, structure[0]);
    const real_t t3 = wrench[0] / t2;
    const real_t t4 = structure[0] + t2;
    const real_t t5 = t4 * structure[3] + structure[1] * structure[4] + structure[2] *
        structure[5];
    const real_t t6 = TB_C(1.0) / (t1 * (t1 + TB_ABS(structure[0])));
    const real_t t7 = t5 * t6;
    const real_t t8 = structure[4] - structure[1] * t7;
    const real_t t9 = structure[5] - structure[2] * t7;
    const real_t t10 = TB_SQRT(t8 * t8 + t9 * t9);
    const real_t t11 = TB_COPYSIGN(t10, t8);
    const real_t t12 = t8 + t11;
    const real_t t13 = (wrench[1] + t3 * (structure[3] - t4 * t7)) / t11;
    const real_t t14 = TB_C(1.0) / (t10 * (t10 + TB_ABS(t8)));
    const real_t t15 = t12 * t13 * t14;
    const real_t t16 = t12 * t15 - t13;
    const real_t t17 = t9 * t15;
    const real_t t18 = structure[1] * t16 - t3 * t4 + structure[2] * t17;
    const real_t t19 = t6 * t18;
    const real_t t20 = t3 + t4 * t19;
    const real_t t21 = t9 * t14;
    const real_t t22 = TB_C(1.0) - t9 * t21;
    const real_t t23 = t12 * t21;
    const real_t t24 = t6 * (structure[2] * t22 - structure[1] * t23);
    const real_t t25 = t4 * t24;
    const real_t t26 = TB_C(16.0) * TB_EPSILON;
    const bool t27 = TB_ABS(t25) <= t26;
    const real_t t28 = TB_ABS(t2);
    const real_t t29 = TB_ABS(t11);
    const real_t t30 = TB_C(1.0) / tb_min(t28, t29);
    const real_t t31 = TB_EPSILON * TB_C(60.0) * t30;
    real_t t32, t33;
    if (t27) {
        t32 = -TB_C(1000000000000.0);
        t33 = TB_C(1000000000000.0);
    } else {
        const real_t t34 = TB_C(1.0) / t25;
        const real_t t35 = -((t20 - t31) * t34);
        const real_t t36 = -(t34 * (t31 + (t20 + TB_TENSION_MAX)));
        t32 = tb_min(t35, t36);
        t33 = tb_max(t35, t36);
    }
    const real_t t37 = t23 + structure[1] * t24;
    const bool t38 = TB_ABS(t37) <= t26;
    /* the least-norm tensions that exert the wrench */
    const real_t start_1 = t16 - structure[1] * t19;
    real_t t39, t40;
    if (t38) {
        t39 = -TB_C(1000000000000.0);
        t40 = TB_C(1000000000000.0);
    } else {
        const real_t t41 = TB_C(1.0) / t37;
        const real_t t42 = (t31 + start_1) * t41;
        const real_t t43 = -(t41 * (t31 + (TB_TENSION_MAX - start_1)));
        t39 = tb_min(t42, t43);
        t40 = tb_max(t42, t43);
    }
    const real_t t44 = t22 - structure[2] * t24;
    const bool t45 = TB_ABS(t44) <= t26;
    const real_t start_2 = t17 - structure[2] * t19;
    real_t t46, t47;
    if (t45) {
        t46 = -TB_C(1000000000000.0);
        t47 = TB_C(1000000000000.0);
    } else {
        const real_t t48 = TB_C(1.0) / t44;
        const real_t t49 = -((t31 + start_2) * t48);
        const real_t t50 = t48 * (t31 + (TB_TENSION_MAX - start_2));
        t46 = tb_min(t49, t50);
        t47 = tb_max(t49, t50);
    }
    const real_t t51 = tb_min(tb_max(TB_C(0.0), tb_max(tb_max(t32, t39), t46)),
        tb_min(tb_min(t33, t40), t47));
    const real_t tension_0 = tb_min(tb_max(-(t20 + t25 * t51), TB_C(0.0)), TB_TENSION_MAX);
    const real_t tension_1 = tb_min(tb_max(start_1 - t37 * t51, TB_C(0.0)), TB_TENSION_MAX);
    const real_t tension_2 = tb_min(tb_max(start_2 + t44 * t51, TB_C(0.0)), TB_TENSION_MAX);
    const real_t t52 = structure[0] * tension_0 + structure[1] * tension_1;
    /* what the tensions exert, S T */
    const real_t delivered_0 = t52 + structure[2] * tension_2;
    const real_t t53 = structure[3] * tension_0 + structure[4] * tension_1;
    const real_t delivered_1 = t53 + structure[5] * tension_2;
    const real_t t54 = tb_max(TB_C(0.0), TB_ABS(delivered_0 - wrench[0]));
    const real_t kkt_residual_0 = tb_max(t54, TB_ABS(delivered_1 - wrench[1]));
    const real_t t55 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t56 = !(t55 < t28 && t55 < t29);
    const real_t t57 = tb_min(t30 * (TB_EPSILON * TB_C(2560.0)), TB_C(0.02));
    const bool t58 = !(kkt_residual_0 <= t57);
    if (t56) {
        return tb_refuse_least_norm_tension(TB_SINGULAR, tension, delivered, kkt_residual);
    }
    if (t58) {
        return tb_refuse_least_norm_tension(TB_INACCURATE, tension, delivered, kkt_residual);
    }
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    delivered[0] = delivered_0;
    delivered[1] = delivered_1;
    kkt_residual[0] = kkt_residual_0;
    return TB_OK;
}

tb_status tb_served_wrench_scale(const real_t structure[6], const real_t wrench[2],
    real_t served[2], real_t inner[2])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) <= TB_C(24.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(120000.0))) {
        served[0] = TB_C(0.0);
        served[1] = TB_C(0.0);
        inner[0] = TB_C(0.0);
        inner[1] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = TB_C(10.0) * (structure[3] + structure[4] + structure[5]);
    const real_t t1 = wrench[1] - t0;
    const real_t t2 = TB_C(10.0) * (structure[0] + structure[1] + structure[2]);
    const real_t t3 = wrench[0] - t2;
    const real_t t4 = structure[0] * t1 - structure[3] * t3;
    const real_t t5 = TB_ABS(t4);
    const real_t t6 = structure[0] * structure[4];
    const real_t t7 = structure[3] * structure[1];
    const real_t t8 = t6 - t7;
    const real_t t9 = TB_ABS(t8);
    const real_t t10 = structure[0] * structure[5];
    const real_t t11 = structure[3] * structure[2];
    const real_t t12 = t10 - t11;
    const real_t t13 = TB_ABS(t12);
    /* facets of the feasible wrenches, half distances */
    const real_t facet_0 = TB_C(10.0) * (t9 + t13);
    const real_t t14 = t1 * structure[1] - structure[4] * t3;
    const real_t t15 = TB_ABS(t14);
    const real_t t16 = structure[5] * structure[1];
    const real_t t17 = structure[4] * structure[2];
    const real_t t18 = t16 - t17;
    const real_t t19 = TB_ABS(t18);
    const real_t facet_1 = TB_C(10.0) * (t9 + t19);
    const real_t t20 = t1 * structure[2] - structure[5] * t3;
    const real_t t21 = TB_ABS(t20);
    const real_t facet_2 = TB_C(10.0) * (t13 + t19);
    const bool t22 = t5 <= facet_0 && t15 <= facet_1 && t21 <= facet_2;
    const bool t23 = !t22;
    real_t served_0, served_1;
    if (t22) {
        served_0 = wrench[0];
        served_1 = wrench[1];
    } else {
        const real_t t24 = TB_C(320.0) * TB_EPSILON;
        const real_t t25 = structure[0] * wrench[1] - structure[3] * wrench[0];
        const bool t26 = t24 < TB_ABS(t25);
        const real_t t27 = structure[0] * t0 - structure[3] * t2;
        real_t t28, t29, t30;
        if (t26) {
            const real_t t31 = TB_C(1.0) / t25;
            const real_t t32 = (t27 - facet_0 - t24) * t31;
            const real_t t33 = t31 * (t24 + (facet_0 + t27));
            t28 = tb_max(t32, t33);
            t29 = tb_min(t32, t33);
            t30 = t31 * (t27 + TB_COPYSIGN(facet_0, t25));
        } else {
            const real_t t34 = facet_0 + t24 < TB_ABS(t27) ? TB_C(1e+30) : TB_C(0.0);
            t28 = TB_C(1.0);
            t29 = t34;
            t30 = TB_C(1.0);
        }
        const real_t t35 = wrench[1] * structure[1] - structure[4] * wrench[0];
        const bool t36 = t24 < TB_ABS(t35);
        const real_t t37 = t0 * structure[1] - structure[4] * t2;
        real_t t38, t39, t40;
        if (t36) {
            const real_t t41 = TB_C(1.0) / t35;
            const real_t t42 = (t37 - facet_1 - t24) * t41;
            const real_t t43 = t41 * (t24 + (facet_1 + t37));
            t38 = tb_max(t42, t43);
            t39 = tb_min(t42, t43);
            t40 = t41 * (t37 + TB_COPYSIGN(facet_1, t35));
        } else {
            const real_t t44 = facet_1 + t24 < TB_ABS(t37) ? TB_C(1e+30) : TB_C(0.0);
            t38 = TB_C(1.0);
            t39 = t44;
            t40 = TB_C(1.0);
        }
        const real_t t45 = wrench[1] * structure[2] - structure[5] * wrench[0];
        const bool t46 = t24 < TB_ABS(t45);
        const real_t t47 = t0 * structure[2] - structure[5] * t2;
        real_t t48, t49, t50;
        if (t46) {
            const real_t t51 = TB_C(1.0) / t45;
            const real_t t52 = (t47 - facet_2 - t24) * t51;
            const real_t t53 = t51 * (t24 + (facet_2 + t47));
            t48 = tb_max(t52, t53);
            t49 = tb_min(t52, t53);
            t50 = t51 * (t47 + TB_COPYSIGN(facet_2, t45));
        } else {
            const real_t t54 = facet_2 + t24 < TB_ABS(t47) ? TB_C(1e+30) : TB_C(0.0);
            t48 = TB_C(1.0);
            t49 = t54;
            t50 = TB_C(1.0);
        }
        const bool t55 = tb_min(tb_min(tb_min(TB_C(1.0), t28), t38), t48) <
            tb_max(tb_max(tb_max(TB_C(0.0), t29), t39), t49);
        real_t t56, t57;
        if (t55) {
            const bool t58 = TB_C(0.0) < t20;
            const real_t t59 = TB_EPSILON * TB_C(16.0);
            const bool t60 = t13 <= t59;
            const real_t t61 = structure[0] * structure[2] + structure[3] * structure[5];
            const bool t62 = TB_C(0.0) < t61;
            const bool t63 = !t60;
            const bool t64 = (t60 && !t62) || (t63 && TB_C(0.0) < t11 - t10);
            const bool t65 = !t58;
            const bool t66 = (t58 && t64) || (t65 && !t64);
            const real_t t67 = structure[0] * TB_TENSION_MAX;
            const bool t68 = t19 <= t59;
            const real_t t69 = structure[1] * structure[2] + structure[4] * structure[5];
            const bool t70 = TB_C(0.0) < t69;
            const bool t71 = !t68;
            const bool t72 = (t68 && !t70) || (t71 && TB_C(0.0) < t17 - t16);
            const bool t73 = (t58 && t72) || (t65 && !t72);
            const real_t t74 = structure[1] * TB_TENSION_MAX;
            const real_t t75 = (t66 ? t67 : TB_C(0.0)) + (t73 ? t74 : TB_C(0.0));
            const real_t t76 = structure[3] * TB_TENSION_MAX;
            const real_t t77 = structure[4] * TB_TENSION_MAX;
            const real_t t78 = (t66 ? t76 : TB_C(0.0)) + (t73 ? t77 : TB_C(0.0));
            const real_t t79 = structure[2] * (wrench[0] - t75) + structure[5] * (wrench[1] -
                t78);
            const real_t t80 = structure[2] * structure[2] + structure[5] * structure[5];
            const real_t t81 = tb_min(tb_max(t79 * (TB_C(1.0) / t80), TB_C(0.0)),
                TB_TENSION_MAX);
            const real_t t82 = t75 + structure[2] * t81;
            const real_t t83 = t82 - wrench[0];
            const real_t t84 = t78 + structure[5] * t81;
            const real_t t85 = t84 - wrench[1];
            const real_t t86 = facet_2 < t21 ? t83 * t83 + t85 * t85 : TB_C(1e+30);
            const bool t87 = TB_C(0.0) < t14;
            const bool t88 = t9 <= t59;
            const real_t t89 = structure[0] * structure[1] + structure[3] * structure[4];
            const bool t90 = TB_C(0.0) < t89;
            const bool t91 = !t88;
            const bool t92 = (t88 && !t90) || (t91 && TB_C(0.0) < t7 - t6);
            const bool t93 = !t87;
            const bool t94 = (t87 && t92) || (t93 && !t92);
            const bool t95 = (t68 && t70) || (t71 && TB_C(0.0) < t18);
            const bool t96 = (t87 && t95) || (t93 && !t95);
            const real_t t97 = structure[2] * TB_TENSION_MAX;
            const real_t t98 = (t94 ? t67 : TB_C(0.0)) + (t96 ? t97 : TB_C(0.0));
            const real_t t99 = structure[5] * TB_TENSION_MAX;
            const real_t t100 = (t94 ? t76 : TB_C(0.0)) + (t96 ? t99 : TB_C(0.0));
            const real_t t101 = structure[1] * (wrench[0] - t98) + structure[4] * (wrench[1] -
                t100);
            const real_t t102 = structure[1] * structure[1] + structure[4] * structure[4];
            const real_t t103 = tb_min(tb_max(t101 * (TB_C(1.0) / t102), TB_C(0.0)),
                TB_TENSION_MAX);
            const real_t t104 = t98 + structure[1] * t103;
            const real_t t105 = t104 - wrench[0];
            const real_t t106 = t100 + structure[4] * t103;
            const real_t t107 = t106 - wrench[1];
            const real_t t108 = facet_1 < t15 ? t105 * t105 + t107 * t107 : TB_C(1e+30);
            const bool t109 = TB_C(0.0) < t4;
            const bool t110 = (t88 && t90) || (t91 && TB_C(0.0) < t8);
            const bool t111 = !t109;
            const bool t112 = (t109 && t110) || (t111 && !t110);
            const bool t113 = (t60 && t62) || (t63 && TB_C(0.0) < t12);
            const bool t114 = (t109 && t113) || (t111 && !t113);
            const real_t t115 = (t112 ? t74 : TB_C(0.0)) + (t114 ? t97 : TB_C(0.0));
            const real_t t116 = (t112 ? t77 : TB_C(0.0)) + (t114 ? t99 : TB_C(0.0));
            const real_t t117 = structure[0] * (wrench[0] - t115) + structure[3] * (wrench[1] -
                t116);
            const real_t t118 = structure[0] * structure[0] + structure[3] * structure[3];
            const real_t t119 = tb_min(tb_max(t117 * (TB_C(1.0) / t118), TB_C(0.0)),
                TB_TENSION_MAX);
            const real_t t120 = t115 + structure[0] * t119;
            const real_t t121 = t120 - wrench[0];
            const real_t t122 = t116 + structure[3] * t119;
            const real_t t123 = t122 - wrench[1];
            const real_t t124 = facet_0 < t5 ? t121 * t121 + t123 * t123 : TB_C(1e+30);
            const bool t125 = t124 < TB_C(1e+30);
            const real_t t126 = t125 ? t124 : TB_C(1e+30);
            const bool t127 = t108 < t126;
            const bool t128 = t86 < (t127 ? t108 : t126);
            real_t t129, t130;
            if (t128) {
                t129 = t82;
                t130 = t84;
            } else {
                t129 = t127 ? t104 : (t125 ? t120 : TB_C(0.0));
                t130 = t127 ? t106 : (t125 ? t122 : TB_C(0.0));
            }
            t56 = t129;
            t57 = t130;
        } else {
            const real_t t131 = tb_max(tb_min(tb_min(tb_min(TB_C(1.0), t30), t40), t50),
                TB_C(0.0));
            t56 = wrench[0] * t131;
            t57 = wrench[1] * t131;
        }
        const real_t t132 = TB_EPSILON * TB_C(32.0);
        served_0 = t56 + t132 * (t2 - t56);
        served_1 = t57 + t132 * (t0 - t57);
    }
    const real_t inner_0 = served_0 + TB_C(3.814697265625e-06) * (t2 - served_0);
    const real_t inner_1 = served_1 + TB_C(3.814697265625e-06) * (t0 - served_1);
    served[0] = served_0;
    served[1] = served_1;
    inner[0] = inner_0;
    inner[1] = inner_1;
    return t23 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_served_wrench_closest(const real_t structure[6], const real_t wrench[2],
    real_t served[2], real_t inner[2])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) <= TB_C(24.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(120000.0))) {
        served[0] = TB_C(0.0);
        served[1] = TB_C(0.0);
        inner[0] = TB_C(0.0);
        inner[1] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = TB_C(10.0) * (structure[3] + structure[4] + structure[5]);
    const real_t t1 = wrench[1] - t0;
    const real_t t2 = TB_C(10.0) * (structure[0] + structure[1] + structure[2]);
    const real_t t3 = wrench[0] - t2;
    const real_t t4 = structure[0] * t1 - structure[3] * t3;
    const real_t t5 = TB_ABS(t4);
    const real_t t6 = structure[0] * structure[4];
    const real_t t7 = structure[3] * structure[1];
    const real_t t8 = t6 - t7;
    const real_t t9 = TB_ABS(t8);
    const real_t t10 = structure[0] * structure[5];
    const real_t t11 = structure[3] * structure[2];
    const real_t t12 = t10 - t11;
    const real_t t13 = TB_ABS(t12);
    /* facets of the feasible wrenches, half distances */
    const real_t facet_0 = TB_C(10.0) * (t9 + t13);
    const real_t t14 = t1 * structure[1] - structure[4] * t3;
    const real_t t15 = TB_ABS(t14);
    const real_t t16 = structure[5] * structure[1];
    const real_t t17 = structure[4] * structure[2];
    const real_t t18 = t16 - t17;
    const real_t t19 = TB_ABS(t18);
    const real_t facet_1 = TB_C(10.0) * (t9 + t19);
    const real_t t20 = t1 * structure[2] - structure[5] * t3;
    const real_t t21 = TB_ABS(t20);
    const real_t facet_2 = TB_C(10.0) * (t13 + t19);
    const bool t22 = t5 <= facet_0 && t15 <= facet_1 && t21 <= facet_2;
    const bool t23 = !t22;
    real_t served_0, served_1;
    if (t22) {
        served_0 = wrench[0];
        served_1 = wrench[1];
    } else {
        const bool t24 = TB_C(0.0) < t20;
        const real_t t25 = TB_C(16.0) * TB_EPSILON;
        const bool t26 = t13 <= t25;
        const real_t t27 = structure[0] * structure[2] + structure[3] * structure[5];
        const bool t28 = TB_C(0.0) < t27;
        const bool t29 = !t26;
        const bool t30 = (t26 && !t28) || (t29 && TB_C(0.0) < t11 - t10);
        const bool t31 = !t24;
        const bool t32 = (t24 && t30) || (t31 && !t30);
        const real_t t33 = structure[0] * TB_TENSION_MAX;
        const bool t34 = t19 <= t25;
        const real_t t35 = structure[1] * structure[2] + structure[4] * structure[5];
        const bool t36 = TB_C(0.0) < t35;
        const bool t37 = !t34;
        const bool t38 = (t34 && !t36) || (t37 && TB_C(0.0) < t17 - t16);
        const bool t39 = (t24 && t38) || (t31 && !t38);
        const real_t t40 = structure[1] * TB_TENSION_MAX;
        const real_t t41 = (t32 ? t33 : TB_C(0.0)) + (t39 ? t40 : TB_C(0.0));
        const real_t t42 = structure[3] * TB_TENSION_MAX;
        const real_t t43 = structure[4] * TB_TENSION_MAX;
        const real_t t44 = (t32 ? t42 : TB_C(0.0)) + (t39 ? t43 : TB_C(0.0));
        const real_t t45 = structure[2] * (wrench[0] - t41) + structure[5] * (wrench[1] - t44);
        const real_t t46 = structure[2] * structure[2] + structure[5] * structure[5];
        const real_t t47 = tb_min(tb_max(t45 * (TB_C(1.0) / t46), TB_C(0.0)), TB_TENSION_MAX);
        const real_t t48 = t41 + structure[2] * t47;
        const real_t t49 = t48 - wrench[0];
        const real_t t50 = t44 + structure[5] * t47;
        const real_t t51 = t50 - wrench[1];
        const real_t t52 = facet_2 < t21 ? t49 * t49 + t51 * t51 : TB_C(1e+30);
        const bool t53 = TB_C(0.0) < t14;
        const bool t54 = t9 <= t25;
        const real_t t55 = structure[0] * structure[1] + structure[3] * structure[4];
        const bool t56 = TB_C(0.0) < t55;
        const bool t57 = !t54;
        const bool t58 = (t54 && !t56) || (t57 && TB_C(0.0) < t7 - t6);
        const bool t59 = !t53;
        const bool t60 = (t53 && t58) || (t59 && !t58);
        const bool t61 = (t34 && t36) || (t37 && TB_C(0.0) < t18);
        const bool t62 = (t53 && t61) || (t59 && !t61);
        const real_t t63 = structure[2] * TB_TENSION_MAX;
        const real_t t64 = (t60 ? t33 : TB_C(0.0)) + (t62 ? t63 : TB_C(0.0));
        const real_t t65 = structure[5] * TB_TENSION_MAX;
        const real_t t66 = (t60 ? t42 : TB_C(0.0)) + (t62 ? t65 : TB_C(0.0));
        const real_t t67 = structure[1] * (wrench[0] - t64) + structure[4] * (wrench[1] - t66);
        const real_t t68 = structure[1] * structure[1] + structure[4] * structure[4];
        const real_t t69 = tb_min(tb_max(t67 * (TB_C(1.0) / t68), TB_C(0.0)), TB_TENSION_MAX);
        const real_t t70 = t64 + structure[1] * t69;
        const real_t t71 = t70 - wrench[0];
        const real_t t72 = t66 + structure[4] * t69;
        const real_t t73 = t72 - wrench[1];
        const real_t t74 = facet_1 < t15 ? t71 * t71 + t73 * t73 : TB_C(1e+30);
        const bool t75 = TB_C(0.0) < t4;
        const bool t76 = (t54 && t56) || (t57 && TB_C(0.0) < t8);
        const bool t77 = !t75;
        const bool t78 = (t75 && t76) || (t77 && !t76);
        const bool t79 = (t26 && t28) || (t29 && TB_C(0.0) < t12);
        const bool t80 = (t75 && t79) || (t77 && !t79);
        const real_t t81 = (t78 ? t40 : TB_C(0.0)) + (t80 ? t63 : TB_C(0.0));
        const real_t t82 = (t78 ? t43 : TB_C(0.0)) + (t80 ? t65 : TB_C(0.0));
        const real_t t83 = structure[0] * (wrench[0] - t81) + structure[3] * (wrench[1] - t82);
        const real_t t84 = structure[0] * structure[0] + structure[3] * structure[3];
        const real_t t85 = tb_min(tb_max(t83 * (TB_C(1.0) / t84), TB_C(0.0)), TB_TENSION_MAX);
        const real_t t86 = t81 + structure[0] * t85;
        const real_t t87 = t86 - wrench[0];
        const real_t t88 = t82 + structure[3] * t85;
        const real_t t89 = t88 - wrench[1];
        const real_t t90 = facet_0 < t5 ? t87 * t87 + t89 * t89 : TB_C(1e+30);
        const bool t91 = t90 < TB_C(1e+30);
        const real_t t92 = t91 ? t90 : TB_C(1e+30);
        const bool t93 = t74 < t92;
        const bool t94 = t52 < (t93 ? t74 : t92);
        real_t t95, t96;
        if (t94) {
            t95 = t48;
            t96 = t50;
        } else {
            t95 = t93 ? t70 : (t91 ? t86 : TB_C(0.0));
            t96 = t93 ? t72 : (t91 ? t88 : TB_C(0.0));
        }
        const real_t t97 = TB_EPSILON * TB_C(32.0);
        served_0 = t95 + t97 * (t2 - t95);
        served_1 = t96 + t97 * (t0 - t96);
    }
    const real_t inner_0 = served_0 + TB_C(3.814697265625e-06) * (t2 - served_0);
    const real_t inner_1 = served_1 + TB_C(3.814697265625e-06) * (t0 - served_1);
    served[0] = served_0;
    served[1] = served_1;
    inner[0] = inner_0;
    inner[1] = inner_1;
    return t23 ? TB_INFEASIBLE : TB_OK;
}

/* Refuses with a status: tension is 0 N; delivered is 0 N; kkt_residual is 0 N. */
static tb_status tb_refuse_distribute_tension_paper(tb_status status, real_t tension[3],
    real_t delivered[2], real_t kkt_residual[1])
{
    tension[0] = TB_C(0.0);
    tension[1] = TB_C(0.0);
    tension[2] = TB_C(0.0);
    delivered[0] = TB_C(0.0);
    delivered[1] = TB_C(0.0);
    kkt_residual[0] = TB_C(0.0);
    return status;
}

tb_status tb_distribute_tension_paper(const real_t structure[6], const real_t wrench[2],
    real_t tension[3], real_t delivered[2], real_t kkt_residual[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) <= TB_C(24.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(120000.0))) {
        return tb_refuse_distribute_tension_paper(TB_OUT_OF_DOMAIN, tension, delivered, kkt_residual);
    }
    const real_t t0 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t1 = TB_SQRT(t0 + structure[2] * structure[2]);
    const real_t t2 = TB_COPYSIGN(t1, structure[0]);
    const real_t t3 = wrench[0] / t2;
    const real_t t4 = structure[0] + t2;
    const real_t t5 = t4 * structure[3] + structure[1] * structure[4] + structure[2] *
        structure[5];
    const real_t t6 = TB_C(1.0) / (t1 * (t1 + TB_ABS(structure[0])));
    const real_t t7 = t5 * t6;
    const real_t t8 = structure[4] - structure[1] * t7;
    const real_t t9 = structure[5] - structure[2] * t7;
    const real_t t10 = TB_SQRT(t8 * t8 + t9 * t9);
    const real_t t11 = TB_COPYSIGN(t10, t8);
    const real_t t12 = t8 + t11;
    const real_t t13 = (wrench[1] + t3 * (structure[3] - t4 * t7)) / t11;
    const real_t t14 = TB_C(1.0) / (t10 * (t10 + TB_ABS(t8)));
    const real_t t15 = t12 * t13 * t14;
    const real_t t16 = t12 * t15 - t13;
    const real_t t17 = t9 * t15;
    const real_t t18 = structure[1] * t16 - t3 * t4 + structure[2] * t17;
    const real_t t19 = t6 * t18;
    const real_t t20 = t3 + t4 * t19;
    const real_t t21 = t9 * t14;
    const real_t t22 = TB_C(1.0) - t9 * t21;
    const real_t t23 = t12 * t21;
    const real_t t24 = t6 * (structure[2] * t22 - structure[1] * t23);
    const real_t t25 = t4 * t24;
    const real_t t26 = TB_C(16.0) * TB_EPSILON;
    const bool t27 = TB_ABS(t25) <= t26;
    const real_t t28 = TB_EPSILON * TB_C(3.0) * (TB_ABS(wrench[0]) + TB_ABS(wrench[1]));
    const real_t t29 = TB_ABS(t2);
    const real_t t30 = TB_ABS(t11);
    const real_t t31 = TB_C(1.0) / tb_min(t29, t30);
    const real_t t32 = t28 * t31;
    real_t t33, t34;
    if (t27) {
        t33 = -TB_C(1000000000000.0);
        t34 = TB_C(1000000000000.0);
    } else {
        const real_t t35 = TB_C(1.0) / t25;
        const real_t t36 = -((t20 - t32) * t35);
        const real_t t37 = -(t35 * (t32 + (t20 + TB_C(1000000000000.0))));
        t33 = tb_min(t36, t37);
        t34 = tb_max(t36, t37);
    }
    const real_t t38 = t23 + structure[1] * t24;
    const bool t39 = TB_ABS(t38) <= t26;
    /* the least-norm tensions that exert the wrench */
    const real_t start_1 = t16 - structure[1] * t19;
    real_t t40, t41;
    if (t39) {
        t40 = -TB_C(1000000000000.0);
        t41 = TB_C(1000000000000.0);
    } else {
        const real_t t42 = TB_C(1.0) / t38;
        const real_t t43 = (t32 + start_1) * t42;
        const real_t t44 = -(t42 * (t32 + (TB_C(1000000000000.0) - start_1)));
        t40 = tb_min(t43, t44);
        t41 = tb_max(t43, t44);
    }
    const real_t t45 = t22 - structure[2] * t24;
    const bool t46 = TB_ABS(t45) <= t26;
    const real_t start_2 = t17 - structure[2] * t19;
    real_t t47, t48;
    if (t46) {
        t47 = -TB_C(1000000000000.0);
        t48 = TB_C(1000000000000.0);
    } else {
        const real_t t49 = TB_C(1.0) / t45;
        const real_t t50 = -((t32 + start_2) * t49);
        const real_t t51 = t49 * (t32 + (TB_C(1000000000000.0) - start_2));
        t47 = tb_min(t50, t51);
        t48 = tb_max(t50, t51);
    }
    const real_t t52 = tb_min(tb_max(TB_C(0.0), tb_max(tb_max(t33, t40), t47)),
        tb_min(tb_min(t34, t41), t48));
    const real_t t53 = tb_min(tb_max(-(t20 + t25 * t52), TB_C(0.0)), TB_C(1000000000000.0));
    const real_t t54 = tb_min(tb_max(start_1 - t38 * t52, TB_C(0.0)), TB_C(1000000000000.0));
    const real_t t55 = tb_min(tb_max(start_2 + t45 * t52, TB_C(0.0)), TB_C(1000000000000.0));
    const real_t t56 = structure[0] * t53 + structure[1] * t54 + structure[2] * t55;
    const real_t t57 = structure[3] * t53 + structure[4] * t54 + structure[5] * t55;
    const real_t t58 = tb_max(tb_max(TB_C(0.0), TB_ABS(t56 - wrench[0])), TB_ABS(t57 -
        wrench[1]));
    const real_t t59 = TB_EPSILON * TB_C(128.0) * tb_max(tb_max(t53, t54), t55);
    const bool t60 = t58 <= tb_min(t31 * t59, TB_C(0.02));
    /* what the tensions exert, S T */
    real_t tension_0, tension_1, tension_2, delivered_0, delivered_1, kkt_residual_0;
    if (t60) {
        const real_t t61 = tb_min(t53, TB_TENSION_MAX);
        const real_t t62 = tb_min(t54, TB_TENSION_MAX);
        const real_t t63 = tb_min(t55, TB_TENSION_MAX);
        const real_t t64 = structure[0] * t61 + structure[1] * t62 + structure[2] * t63;
        const real_t t65 = structure[3] * t61 + structure[4] * t62 + structure[5] * t63;
        tension_0 = t61;
        tension_1 = t62;
        tension_2 = t63;
        delivered_0 = t64;
        delivered_1 = t65;
        kkt_residual_0 = t58;
    } else {
        tension_0 = TB_C(0.0);
        tension_1 = TB_C(0.0);
        tension_2 = TB_C(0.0);
        delivered_0 = TB_C(0.0);
        delivered_1 = TB_C(0.0);
        kkt_residual_0 = TB_C(0.0);
    }
    const real_t t66 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t67 = !(t66 < t29 && t66 < t30);
    const bool t68 = !t60;
    const bool t69 = TB_TENSION_MAX < t53 || TB_TENSION_MAX < t54 || TB_TENSION_MAX < t55;
    if (t67) {
        return tb_refuse_distribute_tension_paper(TB_SINGULAR, tension, delivered, kkt_residual);
    }
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    delivered[0] = delivered_0;
    delivered[1] = delivered_1;
    kkt_residual[0] = kkt_residual_0;
    return (t68 || t69) ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_distribute_tension_scale(const real_t structure[6], const real_t wrench[2],
    real_t tension[3], real_t delivered[2], real_t kkt_residual[1])
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

tb_status tb_distribute_tension_closest(const real_t structure[6], const real_t wrench[2],
    real_t tension[3], real_t delivered[2], real_t kkt_residual[1])
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

tb_status tb_distribute_tension(const real_t structure[6], const real_t wrench[2],
    real_t tension[3], real_t delivered[2], real_t kkt_residual[1])
{
    return tb_distribute_tension_closest(structure, wrench, tension, delivered, kkt_residual);
}

