/* Regenerate: turnbuckle generate machines/yoon2023.toml --out generated/yoon2023
 * Machine 5b63eabb3ab694c0, generator 0.1.0, casadi 3.8.2. Do not edit. */
#include "tb_tension.h"

tb_status tb_least_norm_tension_quick(const real_t structure[8], const real_t wrench[2], real_t
    tension[4], real_t delivered[2], real_t kkt_residual[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) <= TB_C(32.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(80000.0))) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t cross_03 = structure[0] * structure[7] - structure[4] * structure[3];
    /* s_i x W */
    const real_t height_0 = structure[0] * wrench[1] - structure[4] * wrench[0];
    const real_t cross_13 = structure[7] * structure[1] - structure[3] * structure[5];
    const real_t height_1 = wrench[1] * structure[1] - wrench[0] * structure[5];
    const real_t cross_23 = structure[7] * structure[2] - structure[3] * structure[6];
    const real_t height_2 = wrench[1] * structure[2] - wrench[0] * structure[6];
    const real_t t0 = cross_03 * height_0 + cross_13 * height_1 + cross_23 * height_2;
    const real_t cross_01 = structure[0] * structure[5] - structure[4] * structure[1];
    const real_t t1 = cross_01 * cross_01;
    const real_t t2 = cross_23 * cross_23;
    const real_t cross_02 = structure[0] * structure[6] - structure[4] * structure[2];
    const real_t t3 = cross_02 * cross_02;
    const real_t t4 = cross_13 * cross_13;
    const real_t t5 = cross_03 * cross_03;
    const real_t cross_12 = structure[1] * structure[6] - structure[5] * structure[2];
    const real_t t6 = cross_12 * cross_12;
    /* det S S', Cauchy-Binet */
    const real_t determinant = t1 + t2 + (t3 + t4) + (t5 + t6);
    const real_t t7 = TB_C(1.0) / determinant;
    /* the least-norm tensions that exert the wrench */
    const real_t start_3 = t0 * t7;
    const real_t t8 = TB_C(3.0) - start_3;
    const real_t t9 = TB_SQRT(determinant) * TB_C(0.5);
    const real_t t10 = TB_C(1.0) / t9;
    const real_t t11 = TB_C(80.0) * TB_EPSILON * t10;
    const real_t height_3 = structure[3] * wrench[1] - structure[7] * wrench[0];
    const real_t t12 = height_0 * cross_02 + height_1 * cross_12 - cross_23 * height_3;
    const real_t start_2 = t7 * t12;
    const real_t t13 = TB_C(3.0) - start_2;
    const real_t t14 = t13 - t11;
    const real_t t15 = height_0 * cross_01 - height_2 * cross_12 - cross_13 * height_3;
    const real_t start_1 = t7 * t15;
    const real_t t16 = TB_C(3.0) - start_1;
    const real_t t17 = t16 - t11;
    const real_t t18 = cross_02 * cross_12 + cross_03 * cross_13;
    const real_t t19 = height_1 * cross_01 + height_2 * cross_02 + cross_03 * height_3;
    const real_t t20 = t7 * t19;
    const real_t t21 = TB_C(3.0) + t20;
    const real_t t22 = t20 + TB_C(10.0);
    const real_t t23 = tb_min(tb_max(TB_C(0.0), t21), t22);
    const real_t t24 = t23 * (TB_C(1.0) / (t6 + (t2 + t4)));
    const real_t t25 = t18 * t24;
    const real_t t26 = TB_C(10.0) - start_1;
    const real_t t27 = t11 + t26;
    const bool t28 = TB_C(0.0) < tb_max(t17 + t25, -(t25 + t27));
    const real_t t29 = TB_EPSILON * TB_C(16.0);
    const real_t t30 = t21 - t11;
    const real_t t31 = -t25;
    const real_t t32 = t11 + t22;
    const real_t t33 = cross_01 * cross_02 + cross_13 * cross_23;
    const real_t t34 = cross_03 * cross_23 - cross_01 * cross_12;
    const real_t t35 = cross_03 * cross_01 - cross_23 * cross_12;
    const real_t t36 = cross_13 * cross_01 + cross_23 * cross_02;
    real_t t37, t38, t39, t40, t41;
    if (t28) {
        const bool t42 = TB_ABS(cross_23) <= t29;
        const real_t t43 = tb_min(tb_max(t31, t16), t26);
        const real_t t44 = t43 * (TB_C(1.0) / (t3 + (t2 + t5)));
        const real_t t45 = t18 * t44;
        const real_t t46 = TB_C(1.0) / cross_23;
        real_t t47, t48;
        if (t42) {
            t47 = -TB_C(1000000000000.0);
            t48 = TB_C(1000000000000.0);
        } else {
            const real_t t49 = -((t30 + t45) * t46);
            const real_t t50 = -(t46 * (t45 + t32));
            t47 = tb_min(t49, t50);
            t48 = tb_max(t49, t50);
        }
        const real_t t51 = tb_min(tb_max(TB_C(0.0), t47), t48);
        const real_t t52 = determinant * t44;
        const real_t t53 = TB_C(0.0) < TB_ABS(t51) ? t51 * (t18 * t46) : TB_C(0.0);
        const real_t t54 = tb_max(TB_C(0.0), t31 < t43 ? t53 - t52 : t52 - t53);
        t37 = cross_03 * t51 - t44 * t33;
        t38 = -(t44 * t35 + cross_02 * t51);
        t39 = -(t45 + cross_23 * t51);
        t40 = t43;
        t41 = t54;
    } else {
        t37 = -(t24 * t34);
        t38 = t24 * t36;
        t39 = t23;
        t40 = t31;
        t41 = TB_C(0.0);
    }
    const real_t t55 = TB_C(10.0) - start_2;
    const real_t t56 = t11 + t55;
    const bool t57 = TB_C(0.0) < tb_max(t14 - t37, t37 - t56);
    const real_t t58 = cross_03 * cross_02 + cross_13 * cross_12;
    real_t t59, t60, t61, t62, t63;
    if (t57) {
        const bool t64 = TB_ABS(cross_03) <= t29;
        const real_t t65 = tb_min(tb_max(t37, t13), t55);
        const real_t t66 = t65 * (TB_C(1.0) / (t1 + (t4 + t5)));
        const real_t t67 = t33 * t66;
        const real_t t68 = TB_C(1.0) / cross_03;
        real_t t69, t70;
        if (t64) {
            t69 = -TB_C(1000000000000.0);
            t70 = TB_C(1000000000000.0);
        } else {
            const real_t t71 = -((t17 + t67) * t68);
            const real_t t72 = -(t68 * (t27 + t67));
            t69 = tb_min(t71, t72);
            t70 = tb_max(t71, t72);
        }
        const bool t73 = TB_ABS(cross_13) <= t29;
        const real_t t74 = t34 * t66;
        const real_t t75 = TB_C(1.0) / cross_13;
        real_t t76, t77;
        if (t73) {
            t76 = -TB_C(1000000000000.0);
            t77 = TB_C(1000000000000.0);
        } else {
            const real_t t78 = (t30 + t74) * t75;
            const real_t t79 = t75 * (t32 + t74);
            t76 = tb_min(t78, t79);
            t77 = tb_max(t78, t79);
        }
        const real_t t80 = tb_min(tb_max(TB_C(0.0), tb_max(t69, t76)), tb_min(t70, t77));
        const real_t t81 = determinant * t66;
        real_t t82;
        if (TB_C(0.0) < TB_ABS(t80)) {
            const real_t t83 = t33 * t68;
            const real_t t84 = -(t34 * t75);
            const real_t t85 = TB_C(0.0) < t80 ? (t76 < t69 ? t83 : t84) : (t70 < t77 ? t83 :
                t84);
            t82 = t80 * t85;
        } else {
            t82 = TB_C(0.0);
        }
        const real_t t86 = tb_max(TB_C(0.0), t37 < t65 ? t82 - t81 : t81 - t82);
        t59 = cross_01 * t80 - t66 * t58;
        t60 = cross_13 * t80 - t74;
        t61 = -(t67 + cross_03 * t80);
        t62 = t65;
        t63 = t86;
    } else {
        t59 = t38;
        t60 = t39;
        t61 = t40;
        t62 = t37;
        t63 = t41;
    }
    const real_t t87 = TB_C(10.0) - start_3;
    const bool t88 = TB_C(0.0) < tb_max(t8 - t11 - t59, t59 - (t11 + t87));
    real_t t89, t90, t91, t92, t93;
    if (t88) {
        const real_t t94 = tb_min(tb_max(t59, t8), t87);
        const real_t t95 = t94 * (TB_C(1.0) / (t1 + (t3 + t6)));
        const real_t t96 = t36 * t95;
        const bool t97 = TB_ABS(cross_01) <= t29;
        const real_t t98 = t58 * t95;
        const real_t t99 = TB_C(1.0) / cross_01;
        real_t t100, t101;
        if (t97) {
            t100 = -TB_C(1000000000000.0);
            t101 = TB_C(1000000000000.0);
        } else {
            const real_t t102 = -((t14 + t98) * t99);
            const real_t t103 = -(t99 * (t56 + t98));
            t100 = tb_min(t102, t103);
            t101 = tb_max(t102, t103);
        }
        const bool t104 = TB_ABS(cross_02) <= t29;
        const real_t t105 = t35 * t95;
        const real_t t106 = TB_C(1.0) / cross_02;
        real_t t107, t108;
        if (t104) {
            t107 = -TB_C(1000000000000.0);
            t108 = TB_C(1000000000000.0);
        } else {
            const real_t t109 = (t17 + t105) * t106;
            const real_t t110 = t106 * (t27 + t105);
            t107 = tb_min(t109, t110);
            t108 = tb_max(t109, t110);
        }
        const bool t111 = TB_ABS(cross_12) <= t29;
        const real_t t112 = TB_C(1.0) / cross_12;
        real_t t113, t114;
        if (t111) {
            t113 = -TB_C(1000000000000.0);
            t114 = TB_C(1000000000000.0);
        } else {
            const real_t t115 = -((t30 - t96) * t112);
            const real_t t116 = -(t112 * (t32 - t96));
            t113 = tb_min(t115, t116);
            t114 = tb_max(t115, t116);
        }
        const real_t t117 = tb_max(t107, t113);
        const real_t t118 = tb_min(t108, t114);
        const real_t t119 = tb_min(tb_max(TB_C(0.0), tb_max(t100, t117)), tb_min(t101, t118));
        const real_t t120 = determinant * t95;
        real_t t121;
        if (TB_C(0.0) < TB_ABS(t119)) {
            const real_t t122 = t58 * t99;
            const real_t t123 = -(t35 * t106);
            const real_t t124 = -(t36 * t112);
            real_t t125;
            if (TB_C(0.0) < t119) {
                t125 = t117 < t100 ? t122 : (t113 < t107 ? t123 : t124);
            } else {
                t125 = t101 < t118 ? t122 : (t108 < t114 ? t123 : t124);
            }
            t121 = t119 * t125;
        } else {
            t121 = TB_C(0.0);
        }
        const real_t t126 = tb_max(TB_C(0.0), t59 < t94 ? t121 - t120 : t120 - t121);
        t89 = t96 - cross_12 * t119;
        t90 = cross_02 * t119 - t105;
        t91 = -(t98 + cross_01 * t119);
        t92 = t94;
        t93 = t126;
    } else {
        t89 = t60;
        t90 = t61;
        t91 = t62;
        t92 = t59;
        t93 = t63;
    }
    const real_t tension_0 = tb_min(tb_max(t89 - t20, TB_C(3.0)), TB_C(10.0));
    const real_t tension_1 = tb_min(tb_max(start_1 + t90, TB_C(3.0)), TB_C(10.0));
    const real_t tension_2 = tb_min(tb_max(start_2 + t91, TB_C(3.0)), TB_C(10.0));
    const real_t tension_3 = tb_min(tb_max(start_3 + t92, TB_C(3.0)), TB_C(10.0));
    const real_t t127 = structure[0] * tension_0 + structure[1] * tension_1;
    /* what the tensions exert, S T */
    const real_t delivered_0 = t127 + structure[2] * tension_2 + structure[3] * tension_3;
    const real_t t128 = structure[4] * tension_0 + structure[5] * tension_1;
    const real_t delivered_1 = t128 + structure[6] * tension_2 + structure[7] * tension_3;
    const real_t kkt_residual_0 = tb_max(tb_max(t93, TB_ABS(delivered_0 - wrench[0])),
        TB_ABS(delivered_1 - wrench[1]));
    const bool t129 = !(TB_EPSILON * TB_C(4096.0) < t9);
    const bool t130 = kkt_residual_0 <= t10 * (TB_EPSILON * TB_C(640.0));
    const bool t131 = !t130;
    if (t129) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    if (t131) {
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
    return TB_OK;
}

tb_status tb_least_norm_tension(const real_t structure[8], const real_t wrench[2], real_t
    tension[4], real_t delivered[2], real_t kkt_residual[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) <= TB_C(32.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(80000.0))) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t1 = t0 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t2 = TB_SQRT(t1);
    const real_t t3 = TB_COPYSIGN(t2, structure[0]);
    const real_t t4 = structure[0] + t3;
    const real_t t5 = t4 * structure[4] + structure[5] * structure[1] + structure[2] *
        structure[6];
    const real_t t6 = TB_C(1.0) / (t2 * (t2 + TB_ABS(structure[0])));
    const real_t t7 = (t5 + structure[3] * structure[7]) * t6;
    const real_t t8 = structure[5] - structure[1] * t7;
    const real_t t9 = structure[6] - structure[2] * t7;
    const real_t t10 = structure[7] - structure[3] * t7;
    const real_t t11 = TB_SQRT(t8 * t8 + t9 * t9 + t10 * t10);
    const real_t t12 = TB_COPYSIGN(t11, t8);
    const real_t t13 = t8 + t12;
    const real_t t14 = wrench[0] / t3;
    const real_t t15 = (wrench[1] + (structure[4] - t4 * t7) * t14) / t12;
    const real_t t16 = TB_C(1.0) / (t11 * (t11 + TB_ABS(t8)));
    const real_t t17 = t13 * t15 * t16;
    const real_t t18 = t10 * t17;
    const real_t t19 = t13 * t17 - t15;
    const real_t t20 = t9 * t17;
    const real_t t21 = structure[1] * t19 - t4 * t14 + structure[2] * t20;
    const real_t t22 = t6 * (t21 + structure[3] * t18);
    /* the least-norm tensions that exert the wrench */
    const real_t start_3 = t18 - structure[3] * t22;
    const real_t t23 = TB_C(3.0) - start_3;
    const real_t t24 = tb_min(TB_ABS(t3), TB_ABS(t12));
    const real_t t25 = TB_C(1.0) / t24;
    const real_t t26 = TB_C(80.0) * TB_EPSILON * t25;
    const real_t start_2 = t20 - structure[2] * t22;
    const real_t t27 = TB_C(3.0) - start_2;
    const real_t t28 = t27 - t26;
    const real_t start_1 = t19 - structure[1] * t22;
    const real_t t29 = TB_C(3.0) - start_1;
    const real_t t30 = t29 - t26;
    const real_t t31 = t9 * t16;
    const real_t t32 = TB_C(1.0) - t9 * t31;
    const real_t t33 = t13 * t31;
    const real_t t34 = t10 * t31;
    const real_t t35 = structure[2] * t32 - structure[1] * t33 - structure[3] * t34;
    const real_t t36 = t6 * t35;
    const real_t t37 = t4 * t36;
    const real_t t38 = t33 + structure[1] * t36;
    const real_t t39 = t10 * t16;
    const real_t t40 = TB_C(1.0) - t10 * t39;
    const real_t t41 = t13 * t39;
    const real_t t42 = t9 * t39;
    const real_t t43 = structure[3] * t40 - (structure[1] * t41 + structure[2] * t42);
    const real_t t44 = t6 * t43;
    const real_t t45 = t4 * t44;
    const real_t t46 = t41 + structure[1] * t44;
    const real_t t47 = t37 * t38 + t45 * t46;
    const real_t t48 = t14 + t4 * t22;
    const real_t t49 = TB_C(3.0) + t48;
    const real_t t50 = t48 + TB_C(10.0);
    const real_t t51 = tb_min(tb_max(TB_C(0.0), t49), t50);
    const real_t t52 = t51 / (t37 * t37 + t45 * t45);
    const real_t t53 = t47 * t52;
    const real_t t54 = TB_C(10.0) - start_1;
    const real_t t55 = t26 + t54;
    const bool t56 = TB_C(0.0) < tb_max(t30 - t53, t53 - t55);
    const real_t t57 = t42 + structure[2] * t44;
    const real_t t58 = t32 - structure[2] * t36;
    const real_t t59 = t46 * t57 - t38 * t58;
    const real_t t60 = t38 * t57 + t46 * t58;
    const real_t t61 = TB_EPSILON * TB_C(16.0);
    const real_t t62 = t49 - t26;
    const real_t t63 = t26 + t50;
    const real_t t64 = t45 * t57 - t37 * t58;
    const real_t t65 = t34 + structure[3] * t36;
    const real_t t66 = t40 - structure[3] * t44;
    const real_t t67 = t38 * t65 - t46 * t66;
    const real_t t68 = t38 * t66 + t46 * t65;
    const real_t t69 = t37 * t65 - t45 * t66;
    real_t t70, t71, t72, t73, t74;
    if (t56) {
        const real_t t75 = tb_min(tb_max(t53, t29), t54);
        const real_t t76 = t75 * (TB_C(1.0) / (t38 * t38 + t46 * t46));
        const real_t t77 = t38 * t45 - t37 * t46;
        const bool t78 = TB_ABS(t77) <= t61;
        const real_t t79 = t47 * t76;
        const real_t t80 = TB_C(1.0) / t77;
        real_t t81, t82;
        if (t78) {
            t81 = -TB_C(1000000000000.0);
            t82 = TB_C(1000000000000.0);
        } else {
            const real_t t83 = (t62 - t79) * t80;
            const real_t t84 = t80 * (t63 - t79);
            t81 = tb_min(t83, t84);
            t82 = tb_max(t83, t84);
        }
        const real_t t85 = tb_min(tb_max(TB_C(0.0), t81), t82);
        const real_t t86 = TB_C(0.0) < TB_ABS(t85) ? t85 * (t47 * t80) : TB_C(0.0);
        const real_t t87 = tb_max(TB_C(0.0), t53 < t75 ? t86 - t76 : t76 - t86);
        t70 = t59 * t76 + t60 * t85;
        t71 = t76 * t67 - t85 * t68;
        t72 = t79 + t77 * t85;
        t73 = t75;
        t74 = t87;
    } else {
        t70 = t52 * t64;
        t71 = t52 * t69;
        t72 = t51;
        t73 = t53;
        t74 = TB_C(0.0);
    }
    const real_t t88 = TB_C(10.0) - start_2;
    const real_t t89 = t26 + t88;
    const bool t90 = TB_C(0.0) < tb_max(t28 - t70, t70 - t89);
    const real_t t91 = t58 * t66;
    const real_t t92 = t57 * t65;
    const real_t t93 = t58 * t65 + t57 * t66;
    real_t t94, t95, t96, t97, t98;
    if (t90) {
        const bool t99 = TB_ABS(t60) <= t61;
        const real_t t100 = tb_min(tb_max(t70, t27), t88);
        const real_t t101 = t100 * (TB_C(1.0) / (t58 * t58 + t57 * t57));
        const real_t t102 = t59 * t101;
        const real_t t103 = TB_C(1.0) / t60;
        real_t t104, t105;
        if (t99) {
            t104 = -TB_C(1000000000000.0);
            t105 = TB_C(1000000000000.0);
        } else {
            const real_t t106 = -((t30 - t102) * t103);
            const real_t t107 = -(t103 * (t55 - t102));
            t104 = tb_min(t106, t107);
            t105 = tb_max(t106, t107);
        }
        const real_t t108 = t45 * t58 + t37 * t57;
        const bool t109 = TB_ABS(t108) <= t61;
        const real_t t110 = t64 * t101;
        const real_t t111 = TB_C(1.0) / t108;
        real_t t112, t113;
        if (t109) {
            t112 = -TB_C(1000000000000.0);
            t113 = TB_C(1000000000000.0);
        } else {
            const real_t t114 = -((t62 - t110) * t111);
            const real_t t115 = -(t111 * (t63 - t110));
            t112 = tb_min(t114, t115);
            t113 = tb_max(t114, t115);
        }
        const real_t t116 = tb_min(tb_max(TB_C(0.0), tb_max(t104, t112)), tb_min(t105, t113));
        real_t t117;
        if (TB_C(0.0) < TB_ABS(t116)) {
            const real_t t118 = -(t59 * t103);
            const real_t t119 = -(t64 * t111);
            const real_t t120 = TB_C(0.0) < t116 ? (t112 < t104 ? t118 : t119) : (t105 < t113 ?
                t118 : t119);
            t117 = t116 * t120;
        } else {
            t117 = TB_C(0.0);
        }
        const real_t t121 = tb_max(TB_C(0.0), t70 < t100 ? t117 - t101 : t101 - t117);
        t94 = (t91 - t92) * t116 - t101 * t93;
        t95 = t110 - t108 * t116;
        t96 = t102 - t60 * t116;
        t97 = t100;
        t98 = t121;
    } else {
        t94 = t71;
        t95 = t72;
        t96 = t73;
        t97 = t70;
        t98 = t74;
    }
    const real_t t122 = TB_C(10.0) - start_3;
    const bool t123 = TB_C(0.0) < tb_max(t23 - t26 - t94, t94 - (t26 + t122));
    real_t t124, t125, t126, t127, t128;
    if (t123) {
        const real_t t129 = tb_min(tb_max(t94, t23), t122);
        const real_t t130 = t129 * (TB_C(1.0) / (t65 * t65 + t66 * t66));
        const real_t t131 = t69 * t130;
        const real_t t132 = t45 * t65 + t37 * t66;
        const real_t t133 = t92 - t91;
        const bool t134 = TB_ABS(t133) <= t61;
        const real_t t135 = t93 * t130;
        const real_t t136 = TB_C(1.0) / t133;
        real_t t137, t138;
        if (t134) {
            t137 = -TB_C(1000000000000.0);
            t138 = TB_C(1000000000000.0);
        } else {
            const real_t t139 = (t28 + t135) * t136;
            const real_t t140 = t136 * (t89 + t135);
            t137 = tb_min(t139, t140);
            t138 = tb_max(t139, t140);
        }
        const bool t141 = TB_ABS(t68) <= t61;
        const real_t t142 = t67 * t130;
        const real_t t143 = TB_C(1.0) / t68;
        real_t t144, t145;
        if (t141) {
            t144 = -TB_C(1000000000000.0);
            t145 = TB_C(1000000000000.0);
        } else {
            const real_t t146 = (t30 - t142) * t143;
            const real_t t147 = t143 * (t55 - t142);
            t144 = tb_min(t146, t147);
            t145 = tb_max(t146, t147);
        }
        const bool t148 = TB_ABS(t132) <= t61;
        const real_t t149 = TB_C(1.0) / t132;
        real_t t150, t151;
        if (t148) {
            t150 = -TB_C(1000000000000.0);
            t151 = TB_C(1000000000000.0);
        } else {
            const real_t t152 = (t62 - t131) * t149;
            const real_t t153 = t149 * (t63 - t131);
            t150 = tb_min(t152, t153);
            t151 = tb_max(t152, t153);
        }
        const real_t t154 = tb_max(t144, t150);
        const real_t t155 = tb_min(t145, t151);
        const real_t t156 = tb_min(tb_max(TB_C(0.0), tb_max(t137, t154)), tb_min(t138, t155));
        real_t t157;
        if (TB_C(0.0) < TB_ABS(t156)) {
            const real_t t158 = -(t93 * t136);
            const real_t t159 = t67 * t143;
            const real_t t160 = t69 * t149;
            real_t t161;
            if (TB_C(0.0) < t156) {
                t161 = t154 < t137 ? t158 : (t150 < t144 ? t159 : t160);
            } else {
                t161 = t138 < t155 ? t158 : (t145 < t151 ? t159 : t160);
            }
            t157 = t156 * t161;
        } else {
            t157 = TB_C(0.0);
        }
        const real_t t162 = tb_max(TB_C(0.0), t94 < t129 ? t157 - t130 : t130 - t157);
        t124 = t131 + t132 * t156;
        t125 = t142 + t68 * t156;
        t126 = t133 * t156 - t135;
        t127 = t129;
        t128 = t162;
    } else {
        t124 = t95;
        t125 = t96;
        t126 = t97;
        t127 = t94;
        t128 = t98;
    }
    const real_t tension_0 = tb_min(tb_max(t124 - t48, TB_C(3.0)), TB_C(10.0));
    const real_t tension_1 = tb_min(tb_max(start_1 + t125, TB_C(3.0)), TB_C(10.0));
    const real_t tension_2 = tb_min(tb_max(start_2 + t126, TB_C(3.0)), TB_C(10.0));
    const real_t tension_3 = tb_min(tb_max(start_3 + t127, TB_C(3.0)), TB_C(10.0));
    const real_t t163 = structure[0] * tension_0 + structure[1] * tension_1;
    /* what the tensions exert, S T */
    const real_t delivered_0 = t163 + structure[2] * tension_2 + structure[3] * tension_3;
    const real_t t164 = structure[4] * tension_0 + structure[5] * tension_1;
    const real_t delivered_1 = t164 + structure[6] * tension_2 + structure[7] * tension_3;
    const real_t kkt_residual_0 = tb_max(tb_max(t128, TB_ABS(delivered_0 - wrench[0])),
        TB_ABS(delivered_1 - wrench[1]));
    const bool t165 = !(TB_EPSILON * TB_C(4096.0) < t24);
    const bool t166 = kkt_residual_0 <= t25 * (TB_EPSILON * TB_C(640.0));
    const bool t167 = !t166;
    if (t165) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    if (t167) {
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
    return TB_OK;
}

tb_status tb_served_wrench_scale(const real_t structure[8], const real_t wrench[2], real_t
    served[2])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) <= TB_C(32.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(80000.0))) {
        served[0] = TB_C(0.0);
        served[1] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = structure[4] + structure[5] + structure[6] + structure[7];
    const real_t t1 = TB_C(6.5) * t0;
    const real_t t2 = wrench[1] - t1;
    const real_t t3 = structure[0] + structure[1] + structure[2] + structure[3];
    const real_t t4 = TB_C(6.5) * t3;
    const real_t t5 = wrench[0] - t4;
    const real_t t6 = structure[0] * t2 - structure[4] * t5;
    const real_t t7 = TB_ABS(t6);
    const real_t t8 = structure[0] * structure[5];
    const real_t t9 = structure[4] * structure[1];
    const real_t t10 = t8 - t9;
    const real_t t11 = TB_ABS(t10);
    const real_t t12 = structure[0] * structure[6];
    const real_t t13 = structure[4] * structure[2];
    const real_t t14 = t12 - t13;
    const real_t t15 = TB_ABS(t14);
    const real_t t16 = structure[0] * structure[7];
    const real_t t17 = structure[4] * structure[3];
    const real_t t18 = t16 - t17;
    const real_t t19 = TB_ABS(t18);
    /* facets of the feasible wrenches, half distances */
    const real_t facet_0 = TB_C(3.5) * (t11 + t15 + t19);
    const real_t t20 = t2 * structure[1] - structure[5] * t5;
    const real_t t21 = TB_ABS(t20);
    const real_t t22 = structure[6] * structure[1];
    const real_t t23 = structure[5] * structure[2];
    const real_t t24 = t22 - t23;
    const real_t t25 = TB_ABS(t24);
    const real_t t26 = structure[7] * structure[1];
    const real_t t27 = structure[5] * structure[3];
    const real_t t28 = t26 - t27;
    const real_t t29 = TB_ABS(t28);
    const real_t facet_1 = TB_C(3.5) * (t11 + t25 + t29);
    const real_t t30 = t2 * structure[2] - structure[6] * t5;
    const real_t t31 = TB_ABS(t30);
    const real_t t32 = structure[7] * structure[2];
    const real_t t33 = structure[6] * structure[3];
    const real_t t34 = t32 - t33;
    const real_t t35 = TB_ABS(t34);
    const real_t facet_2 = TB_C(3.5) * (t15 + t25 + t35);
    const bool t36 = t7 <= facet_0 && t21 <= facet_1 && t31 <= facet_2;
    const real_t t37 = t2 * structure[3] - structure[7] * t5;
    const real_t t38 = TB_ABS(t37);
    const real_t facet_3 = TB_C(3.5) * (t35 + (t19 + t29));
    const bool t39 = t36 && t38 <= facet_3;
    const bool t40 = !t39;
    real_t served_0, served_1;
    if (t39) {
        served_0 = wrench[0];
        served_1 = wrench[1];
    } else {
        const real_t t41 = structure[0] * wrench[1] - structure[4] * wrench[0];
        const bool t42 = TB_C(0.0) < TB_ABS(t41);
        real_t t43, t44;
        if (t42) {
            const real_t t45 = structure[0] * t1 - structure[4] * t4;
            const real_t t46 = TB_C(1.0) / t41;
            const real_t t47 = (t45 - facet_0) * t46;
            const real_t t48 = t46 * (facet_0 + t45);
            t43 = tb_max(t47, t48);
            t44 = tb_min(t47, t48);
        } else {
            t43 = TB_C(1e+30);
            t44 = -TB_C(1e+30);
        }
        const real_t t49 = wrench[1] * structure[1] - structure[5] * wrench[0];
        const bool t50 = TB_C(0.0) < TB_ABS(t49);
        real_t t51, t52;
        if (t50) {
            const real_t t53 = t1 * structure[1] - structure[5] * t4;
            const real_t t54 = TB_C(1.0) / t49;
            const real_t t55 = (t53 - facet_1) * t54;
            const real_t t56 = t54 * (facet_1 + t53);
            t51 = tb_max(t55, t56);
            t52 = tb_min(t55, t56);
        } else {
            t51 = TB_C(1e+30);
            t52 = -TB_C(1e+30);
        }
        const real_t t57 = wrench[1] * structure[2] - structure[6] * wrench[0];
        const bool t58 = TB_C(0.0) < TB_ABS(t57);
        real_t t59, t60;
        if (t58) {
            const real_t t61 = t1 * structure[2] - structure[6] * t4;
            const real_t t62 = TB_C(1.0) / t57;
            const real_t t63 = (t61 - facet_2) * t62;
            const real_t t64 = t62 * (facet_2 + t61);
            t59 = tb_max(t63, t64);
            t60 = tb_min(t63, t64);
        } else {
            t59 = TB_C(1e+30);
            t60 = -TB_C(1e+30);
        }
        const real_t t65 = wrench[1] * structure[3] - structure[7] * wrench[0];
        const bool t66 = TB_C(0.0) < TB_ABS(t65);
        real_t t67, t68;
        if (t66) {
            const real_t t69 = t1 * structure[3] - structure[7] * t4;
            const real_t t70 = TB_C(1.0) / t65;
            const real_t t71 = (t69 - facet_3) * t70;
            const real_t t72 = t70 * (facet_3 + t69);
            t67 = tb_max(t71, t72);
            t68 = tb_min(t71, t72);
        } else {
            t67 = TB_C(1e+30);
            t68 = -TB_C(1e+30);
        }
        const real_t t73 = tb_min(tb_min(tb_min(t43, t51), t59), t67);
        const real_t t74 = tb_min(t73, TB_C(1.0));
        const bool t75 = t74 < tb_max(tb_max(tb_max(t44, t52), t60), t68) || t73 < TB_C(0.0);
        real_t t76, t77;
        if (t75) {
            const bool t78 = TB_C(0.0) < t37;
            const bool t79 = TB_C(0.0) < t17 - t16;
            const bool t80 = !t78;
            const real_t t81 = (t78 && t79) || (t80 && !t79) ? TB_C(10.0) : TB_C(3.0);
            const bool t82 = TB_C(0.0) < t27 - t26;
            const real_t t83 = (t78 && t82) || (t80 && !t82) ? TB_C(10.0) : TB_C(3.0);
            const bool t84 = TB_C(0.0) < t33 - t32;
            const real_t t85 = (t78 && t84) || (t80 && !t84) ? TB_C(10.0) : TB_C(3.0);
            const real_t t86 = structure[0] * t81 + structure[1] * t83 + structure[2] * t85;
            const real_t t87 = structure[4] * t81 + structure[5] * t83 + structure[6] * t85;
            const real_t t88 = structure[3] * (wrench[0] - t86) + structure[7] * (wrench[1] -
                t87);
            const real_t t89 = structure[3] * structure[3] + structure[7] * structure[7];
            const real_t t90 = tb_min(tb_max(t88 * (TB_C(1.0) / t89), TB_C(3.0)), TB_C(10.0));
            const real_t t91 = t86 + structure[3] * t90;
            const real_t t92 = t91 - wrench[0];
            const real_t t93 = t87 + structure[7] * t90;
            const real_t t94 = t93 - wrench[1];
            const real_t t95 = facet_3 < t38 ? t92 * t92 + t94 * t94 : TB_C(1e+30);
            const bool t96 = TB_C(0.0) < t30;
            const bool t97 = TB_C(0.0) < t13 - t12;
            const bool t98 = !t96;
            const real_t t99 = (t96 && t97) || (t98 && !t97) ? TB_C(10.0) : TB_C(3.0);
            const bool t100 = TB_C(0.0) < t23 - t22;
            const real_t t101 = (t96 && t100) || (t98 && !t100) ? TB_C(10.0) : TB_C(3.0);
            const bool t102 = TB_C(0.0) <= t34;
            const real_t t103 = (t96 && t102) || (t98 && !t102) ? TB_C(10.0) : TB_C(3.0);
            const real_t t104 = structure[0] * t99 + structure[1] * t101 + structure[3] * t103;
            const real_t t105 = structure[4] * t99 + structure[5] * t101 + structure[7] * t103;
            const real_t t106 = structure[2] * (wrench[0] - t104) + structure[6] * (wrench[1] -
                t105);
            const real_t t107 = structure[2] * structure[2] + structure[6] * structure[6];
            const real_t t108 = tb_min(tb_max(t106 * (TB_C(1.0) / t107), TB_C(3.0)),
                TB_C(10.0));
            const real_t t109 = t104 + structure[2] * t108;
            const real_t t110 = t109 - wrench[0];
            const real_t t111 = t105 + structure[6] * t108;
            const real_t t112 = t111 - wrench[1];
            const real_t t113 = facet_2 < t31 ? t110 * t110 + t112 * t112 : TB_C(1e+30);
            const bool t114 = TB_C(0.0) < t20;
            const bool t115 = TB_C(0.0) < t9 - t8;
            const bool t116 = !t114;
            const real_t t117 = (t114 && t115) || (t116 && !t115) ? TB_C(10.0) : TB_C(3.0);
            const bool t118 = TB_C(0.0) <= t24;
            const real_t t119 = (t114 && t118) || (t116 && !t118) ? TB_C(10.0) : TB_C(3.0);
            const bool t120 = TB_C(0.0) <= t28;
            const real_t t121 = (t114 && t120) || (t116 && !t120) ? TB_C(10.0) : TB_C(3.0);
            const real_t t122 = structure[0] * t117 + structure[2] * t119 + structure[3] * t121;
            const real_t t123 = structure[4] * t117 + structure[6] * t119 + structure[7] * t121;
            const real_t t124 = structure[1] * (wrench[0] - t122) + structure[5] * (wrench[1] -
                t123);
            const real_t t125 = structure[1] * structure[1] + structure[5] * structure[5];
            const real_t t126 = tb_min(tb_max(t124 * (TB_C(1.0) / t125), TB_C(3.0)),
                TB_C(10.0));
            const real_t t127 = t122 + structure[1] * t126;
            const real_t t128 = t127 - wrench[0];
            const real_t t129 = t123 + structure[5] * t126;
            const real_t t130 = t129 - wrench[1];
            const real_t t131 = facet_1 < t21 ? t128 * t128 + t130 * t130 : TB_C(1e+30);
            const bool t132 = TB_C(0.0) < t6;
            const bool t133 = TB_C(0.0) <= t10;
            const bool t134 = !t132;
            const real_t t135 = (t132 && t133) || (t134 && !t133) ? TB_C(10.0) : TB_C(3.0);
            const bool t136 = TB_C(0.0) <= t14;
            const real_t t137 = (t132 && t136) || (t134 && !t136) ? TB_C(10.0) : TB_C(3.0);
            const bool t138 = TB_C(0.0) <= t18;
            const real_t t139 = (t132 && t138) || (t134 && !t138) ? TB_C(10.0) : TB_C(3.0);
            const real_t t140 = structure[1] * t135 + structure[2] * t137 + structure[3] * t139;
            const real_t t141 = structure[5] * t135 + structure[6] * t137 + structure[7] * t139;
            const real_t t142 = structure[0] * (wrench[0] - t140) + structure[4] * (wrench[1] -
                t141);
            const real_t t143 = structure[0] * structure[0] + structure[4] * structure[4];
            const real_t t144 = tb_min(tb_max(t142 * (TB_C(1.0) / t143), TB_C(3.0)),
                TB_C(10.0));
            const real_t t145 = t140 + structure[0] * t144;
            const real_t t146 = t145 - wrench[0];
            const real_t t147 = t141 + structure[4] * t144;
            const real_t t148 = t147 - wrench[1];
            const real_t t149 = facet_0 < t7 ? t146 * t146 + t148 * t148 : TB_C(1e+30);
            const bool t150 = t149 < TB_C(1e+30);
            const real_t t151 = t150 ? t149 : TB_C(1e+30);
            const bool t152 = t131 < t151;
            const real_t t153 = t152 ? t131 : t151;
            const bool t154 = t113 < t153;
            real_t t155, t156, t157;
            if (t154) {
                t155 = t113;
                t156 = t109;
                t157 = t111;
            } else {
                t155 = t153;
                t156 = t152 ? t127 : (t150 ? t145 : TB_C(0.0));
                t157 = t152 ? t129 : (t150 ? t147 : TB_C(0.0));
            }
            const bool t158 = t95 < t155;
            t76 = t158 ? t91 : t156;
            t77 = t158 ? t93 : t157;
        } else {
            t76 = wrench[0] * t74;
            t77 = wrench[1] * t74;
        }
        served_0 = t76;
        served_1 = t77;
    }
    served[0] = served_0;
    served[1] = served_1;
    return t40 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_served_wrench_closest(const real_t structure[8], const real_t wrench[2], real_t
    served[2])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) <= TB_C(32.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(80000.0))) {
        served[0] = TB_C(0.0);
        served[1] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = structure[4] + structure[5] + structure[6] + structure[7];
    const real_t t1 = wrench[1] - TB_C(6.5) * t0;
    const real_t t2 = structure[0] + structure[1] + structure[2] + structure[3];
    const real_t t3 = wrench[0] - TB_C(6.5) * t2;
    const real_t t4 = structure[0] * t1 - structure[4] * t3;
    const real_t t5 = TB_ABS(t4);
    const real_t t6 = structure[0] * structure[5];
    const real_t t7 = structure[4] * structure[1];
    const real_t t8 = t6 - t7;
    const real_t t9 = TB_ABS(t8);
    const real_t t10 = structure[0] * structure[6];
    const real_t t11 = structure[4] * structure[2];
    const real_t t12 = t10 - t11;
    const real_t t13 = TB_ABS(t12);
    const real_t t14 = structure[0] * structure[7];
    const real_t t15 = structure[4] * structure[3];
    const real_t t16 = t14 - t15;
    const real_t t17 = TB_ABS(t16);
    /* facets of the feasible wrenches, half distances */
    const real_t facet_0 = TB_C(3.5) * (t9 + t13 + t17);
    const real_t t18 = t1 * structure[1] - structure[5] * t3;
    const real_t t19 = TB_ABS(t18);
    const real_t t20 = structure[6] * structure[1];
    const real_t t21 = structure[5] * structure[2];
    const real_t t22 = t20 - t21;
    const real_t t23 = TB_ABS(t22);
    const real_t t24 = structure[7] * structure[1];
    const real_t t25 = structure[5] * structure[3];
    const real_t t26 = t24 - t25;
    const real_t t27 = TB_ABS(t26);
    const real_t facet_1 = TB_C(3.5) * (t9 + t23 + t27);
    const real_t t28 = t1 * structure[2] - structure[6] * t3;
    const real_t t29 = TB_ABS(t28);
    const real_t t30 = structure[7] * structure[2];
    const real_t t31 = structure[6] * structure[3];
    const real_t t32 = t30 - t31;
    const real_t t33 = TB_ABS(t32);
    const real_t facet_2 = TB_C(3.5) * (t13 + t23 + t33);
    const bool t34 = t5 <= facet_0 && t19 <= facet_1 && t29 <= facet_2;
    const real_t t35 = t1 * structure[3] - structure[7] * t3;
    const real_t t36 = TB_ABS(t35);
    const real_t facet_3 = TB_C(3.5) * (t33 + (t17 + t27));
    const bool t37 = t34 && t36 <= facet_3;
    const bool t38 = !t37;
    real_t served_0, served_1;
    if (t37) {
        served_0 = wrench[0];
        served_1 = wrench[1];
    } else {
        const bool t39 = TB_C(0.0) < t35;
        const bool t40 = TB_C(0.0) < t15 - t14;
        const bool t41 = !t39;
        const real_t t42 = (t39 && t40) || (t41 && !t40) ? TB_C(10.0) : TB_C(3.0);
        const bool t43 = TB_C(0.0) < t25 - t24;
        const real_t t44 = (t39 && t43) || (t41 && !t43) ? TB_C(10.0) : TB_C(3.0);
        const bool t45 = TB_C(0.0) < t31 - t30;
        const real_t t46 = (t39 && t45) || (t41 && !t45) ? TB_C(10.0) : TB_C(3.0);
        const real_t t47 = structure[0] * t42 + structure[1] * t44 + structure[2] * t46;
        const real_t t48 = structure[4] * t42 + structure[5] * t44 + structure[6] * t46;
        const real_t t49 = structure[3] * (wrench[0] - t47) + structure[7] * (wrench[1] - t48);
        const real_t t50 = structure[3] * structure[3] + structure[7] * structure[7];
        const real_t t51 = tb_min(tb_max(t49 * (TB_C(1.0) / t50), TB_C(3.0)), TB_C(10.0));
        const real_t t52 = t47 + structure[3] * t51;
        const real_t t53 = t52 - wrench[0];
        const real_t t54 = t48 + structure[7] * t51;
        const real_t t55 = t54 - wrench[1];
        const real_t t56 = facet_3 < t36 ? t53 * t53 + t55 * t55 : TB_C(1e+30);
        const bool t57 = TB_C(0.0) < t28;
        const bool t58 = TB_C(0.0) < t11 - t10;
        const bool t59 = !t57;
        const real_t t60 = (t57 && t58) || (t59 && !t58) ? TB_C(10.0) : TB_C(3.0);
        const bool t61 = TB_C(0.0) < t21 - t20;
        const real_t t62 = (t57 && t61) || (t59 && !t61) ? TB_C(10.0) : TB_C(3.0);
        const bool t63 = TB_C(0.0) <= t32;
        const real_t t64 = (t57 && t63) || (t59 && !t63) ? TB_C(10.0) : TB_C(3.0);
        const real_t t65 = structure[0] * t60 + structure[1] * t62 + structure[3] * t64;
        const real_t t66 = structure[4] * t60 + structure[5] * t62 + structure[7] * t64;
        const real_t t67 = structure[2] * (wrench[0] - t65) + structure[6] * (wrench[1] - t66);
        const real_t t68 = structure[2] * structure[2] + structure[6] * structure[6];
        const real_t t69 = tb_min(tb_max(t67 * (TB_C(1.0) / t68), TB_C(3.0)), TB_C(10.0));
        const real_t t70 = t65 + structure[2] * t69;
        const real_t t71 = t70 - wrench[0];
        const real_t t72 = t66 + structure[6] * t69;
        const real_t t73 = t72 - wrench[1];
        const real_t t74 = facet_2 < t29 ? t71 * t71 + t73 * t73 : TB_C(1e+30);
        const bool t75 = TB_C(0.0) < t18;
        const bool t76 = TB_C(0.0) < t7 - t6;
        const bool t77 = !t75;
        const real_t t78 = (t75 && t76) || (t77 && !t76) ? TB_C(10.0) : TB_C(3.0);
        const bool t79 = TB_C(0.0) <= t22;
        const real_t t80 = (t75 && t79) || (t77 && !t79) ? TB_C(10.0) : TB_C(3.0);
        const bool t81 = TB_C(0.0) <= t26;
        const real_t t82 = (t75 && t81) || (t77 && !t81) ? TB_C(10.0) : TB_C(3.0);
        const real_t t83 = structure[0] * t78 + structure[2] * t80 + structure[3] * t82;
        const real_t t84 = structure[4] * t78 + structure[6] * t80 + structure[7] * t82;
        const real_t t85 = structure[1] * (wrench[0] - t83) + structure[5] * (wrench[1] - t84);
        const real_t t86 = structure[1] * structure[1] + structure[5] * structure[5];
        const real_t t87 = tb_min(tb_max(t85 * (TB_C(1.0) / t86), TB_C(3.0)), TB_C(10.0));
        const real_t t88 = t83 + structure[1] * t87;
        const real_t t89 = t88 - wrench[0];
        const real_t t90 = t84 + structure[5] * t87;
        const real_t t91 = t90 - wrench[1];
        const real_t t92 = facet_1 < t19 ? t89 * t89 + t91 * t91 : TB_C(1e+30);
        const bool t93 = TB_C(0.0) < t4;
        const bool t94 = TB_C(0.0) <= t8;
        const bool t95 = !t93;
        const real_t t96 = (t93 && t94) || (t95 && !t94) ? TB_C(10.0) : TB_C(3.0);
        const bool t97 = TB_C(0.0) <= t12;
        const real_t t98 = (t93 && t97) || (t95 && !t97) ? TB_C(10.0) : TB_C(3.0);
        const bool t99 = TB_C(0.0) <= t16;
        const real_t t100 = (t93 && t99) || (t95 && !t99) ? TB_C(10.0) : TB_C(3.0);
        const real_t t101 = structure[1] * t96 + structure[2] * t98 + structure[3] * t100;
        const real_t t102 = structure[5] * t96 + structure[6] * t98 + structure[7] * t100;
        const real_t t103 = structure[0] * (wrench[0] - t101) + structure[4] * (wrench[1] -
            t102);
        const real_t t104 = structure[0] * structure[0] + structure[4] * structure[4];
        const real_t t105 = tb_min(tb_max(t103 * (TB_C(1.0) / t104), TB_C(3.0)), TB_C(10.0));
        const real_t t106 = t101 + structure[0] * t105;
        const real_t t107 = t106 - wrench[0];
        const real_t t108 = t102 + structure[4] * t105;
        const real_t t109 = t108 - wrench[1];
        const real_t t110 = facet_0 < t5 ? t107 * t107 + t109 * t109 : TB_C(1e+30);
        const bool t111 = t110 < TB_C(1e+30);
        const real_t t112 = t111 ? t110 : TB_C(1e+30);
        const bool t113 = t92 < t112;
        const real_t t114 = t113 ? t92 : t112;
        const bool t115 = t74 < t114;
        real_t t116, t117, t118;
        if (t115) {
            t116 = t74;
            t117 = t70;
            t118 = t72;
        } else {
            t116 = t114;
            t117 = t113 ? t88 : (t111 ? t106 : TB_C(0.0));
            t118 = t113 ? t90 : (t111 ? t108 : TB_C(0.0));
        }
        const bool t119 = t56 < t116;
        served_0 = t119 ? t52 : t117;
        served_1 = t119 ? t54 : t118;
    }
    served[0] = served_0;
    served[1] = served_1;
    return t38 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_distribute_tension_paper(const real_t structure[8], const real_t wrench[2], real_t
    tension[4], real_t delivered[2], real_t kkt_residual[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) <= TB_C(32.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(80000.0))) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t1 = t0 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t2 = TB_SQRT(t1);
    const real_t t3 = TB_COPYSIGN(t2, structure[0]);
    const real_t t4 = structure[0] + t3;
    const real_t t5 = t4 * structure[4] + structure[5] * structure[1] + structure[2] *
        structure[6];
    const real_t t6 = TB_C(1.0) / (t2 * (t2 + TB_ABS(structure[0])));
    const real_t t7 = (t5 + structure[3] * structure[7]) * t6;
    const real_t t8 = structure[5] - structure[1] * t7;
    const real_t t9 = structure[6] - structure[2] * t7;
    const real_t t10 = structure[7] - structure[3] * t7;
    const real_t t11 = TB_SQRT(t8 * t8 + t9 * t9 + t10 * t10);
    const real_t t12 = TB_COPYSIGN(t11, t8);
    const real_t t13 = t8 + t12;
    const real_t t14 = wrench[0] / t3;
    const real_t t15 = (wrench[1] + (structure[4] - t4 * t7) * t14) / t12;
    const real_t t16 = TB_C(1.0) / (t11 * (t11 + TB_ABS(t8)));
    const real_t t17 = t13 * t15 * t16;
    const real_t t18 = t10 * t17;
    const real_t t19 = t13 * t17 - t15;
    const real_t t20 = t9 * t17;
    const real_t t21 = structure[1] * t19 - t4 * t14 + structure[2] * t20;
    const real_t t22 = t6 * (t21 + structure[3] * t18);
    /* the least-norm tensions that exert the wrench */
    const real_t start_3 = t18 - structure[3] * t22;
    const real_t t23 = TB_C(3.0) - start_3;
    const real_t t24 = TB_C(3.0) + (TB_ABS(wrench[0]) + TB_ABS(wrench[1]));
    const real_t t25 = tb_min(TB_ABS(t3), TB_ABS(t12));
    const real_t t26 = TB_C(1.0) / t25;
    const real_t t27 = TB_C(8.0) * TB_EPSILON * t24 * t26;
    const real_t start_2 = t20 - structure[2] * t22;
    const real_t t28 = TB_C(3.0) - start_2;
    const real_t t29 = t28 - t27;
    const real_t start_1 = t19 - structure[1] * t22;
    const real_t t30 = TB_C(3.0) - start_1;
    const real_t t31 = t30 - t27;
    const real_t t32 = t9 * t16;
    const real_t t33 = TB_C(1.0) - t9 * t32;
    const real_t t34 = t13 * t32;
    const real_t t35 = t10 * t32;
    const real_t t36 = structure[2] * t33 - structure[1] * t34 - structure[3] * t35;
    const real_t t37 = t6 * t36;
    const real_t t38 = t4 * t37;
    const real_t t39 = t34 + structure[1] * t37;
    const real_t t40 = t10 * t16;
    const real_t t41 = TB_C(1.0) - t10 * t40;
    const real_t t42 = t13 * t40;
    const real_t t43 = t9 * t40;
    const real_t t44 = structure[3] * t41 - (structure[1] * t42 + structure[2] * t43);
    const real_t t45 = t6 * t44;
    const real_t t46 = t4 * t45;
    const real_t t47 = t42 + structure[1] * t45;
    const real_t t48 = t38 * t39 + t46 * t47;
    const real_t t49 = t14 + t4 * t22;
    const real_t t50 = TB_C(3.0) + t49;
    const real_t t51 = t49 + TB_C(1000000000000.0);
    const real_t t52 = tb_min(tb_max(TB_C(0.0), t50), t51);
    const real_t t53 = t52 / (t38 * t38 + t46 * t46);
    const real_t t54 = t48 * t53;
    const real_t t55 = TB_C(1000000000000.0) - start_1;
    const real_t t56 = t27 + t55;
    const bool t57 = TB_C(0.0) < tb_max(t31 - t54, t54 - t56);
    const real_t t58 = t43 + structure[2] * t45;
    const real_t t59 = t33 - structure[2] * t37;
    const real_t t60 = t47 * t58 - t39 * t59;
    const real_t t61 = t39 * t58 + t47 * t59;
    const real_t t62 = TB_EPSILON * TB_C(16.0);
    const real_t t63 = t50 - t27;
    const real_t t64 = t27 + t51;
    const real_t t65 = t46 * t58 - t38 * t59;
    const real_t t66 = t35 + structure[3] * t37;
    const real_t t67 = t41 - structure[3] * t45;
    const real_t t68 = t39 * t66 - t47 * t67;
    const real_t t69 = t39 * t67 + t47 * t66;
    const real_t t70 = t38 * t66 - t46 * t67;
    real_t t71, t72, t73, t74, t75;
    if (t57) {
        const real_t t76 = tb_min(tb_max(t54, t30), t55);
        const real_t t77 = t76 * (TB_C(1.0) / (t39 * t39 + t47 * t47));
        const real_t t78 = t39 * t46 - t38 * t47;
        const bool t79 = TB_ABS(t78) <= t62;
        const real_t t80 = t48 * t77;
        const real_t t81 = TB_C(1.0) / t78;
        real_t t82, t83;
        if (t79) {
            t82 = -TB_C(1000000000000.0);
            t83 = TB_C(1000000000000.0);
        } else {
            const real_t t84 = (t63 - t80) * t81;
            const real_t t85 = t81 * (t64 - t80);
            t82 = tb_min(t84, t85);
            t83 = tb_max(t84, t85);
        }
        const real_t t86 = tb_min(tb_max(TB_C(0.0), t82), t83);
        const real_t t87 = TB_C(0.0) < TB_ABS(t86) ? t86 * (t48 * t81) : TB_C(0.0);
        const real_t t88 = tb_max(TB_C(0.0), t54 < t76 ? t87 - t77 : t77 - t87);
        t71 = t60 * t77 + t61 * t86;
        t72 = t77 * t68 - t86 * t69;
        t73 = t88;
        t74 = t80 + t78 * t86;
        t75 = t76;
    } else {
        t71 = t53 * t65;
        t72 = t53 * t70;
        t73 = TB_C(0.0);
        t74 = t52;
        t75 = t54;
    }
    const real_t t89 = TB_C(1000000000000.0) - start_2;
    const real_t t90 = t27 + t89;
    const bool t91 = TB_C(0.0) < tb_max(t29 - t71, t71 - t90);
    const real_t t92 = t59 * t67;
    const real_t t93 = t58 * t66;
    const real_t t94 = t59 * t66 + t58 * t67;
    real_t t95, t96, t97, t98, t99;
    if (t91) {
        const bool t100 = TB_ABS(t61) <= t62;
        const real_t t101 = tb_min(tb_max(t71, t28), t89);
        const real_t t102 = t101 * (TB_C(1.0) / (t59 * t59 + t58 * t58));
        const real_t t103 = t60 * t102;
        const real_t t104 = TB_C(1.0) / t61;
        real_t t105, t106;
        if (t100) {
            t105 = -TB_C(1000000000000.0);
            t106 = TB_C(1000000000000.0);
        } else {
            const real_t t107 = -((t31 - t103) * t104);
            const real_t t108 = -(t104 * (t56 - t103));
            t105 = tb_min(t107, t108);
            t106 = tb_max(t107, t108);
        }
        const real_t t109 = t46 * t59 + t38 * t58;
        const bool t110 = TB_ABS(t109) <= t62;
        const real_t t111 = t65 * t102;
        const real_t t112 = TB_C(1.0) / t109;
        real_t t113, t114;
        if (t110) {
            t113 = -TB_C(1000000000000.0);
            t114 = TB_C(1000000000000.0);
        } else {
            const real_t t115 = -((t63 - t111) * t112);
            const real_t t116 = -(t112 * (t64 - t111));
            t113 = tb_min(t115, t116);
            t114 = tb_max(t115, t116);
        }
        const real_t t117 = tb_min(tb_max(TB_C(0.0), tb_max(t105, t113)), tb_min(t106, t114));
        real_t t118;
        if (TB_C(0.0) < TB_ABS(t117)) {
            const real_t t119 = -(t60 * t104);
            const real_t t120 = -(t65 * t112);
            const real_t t121 = TB_C(0.0) < t117 ? (t113 < t105 ? t119 : t120) : (t106 < t114 ?
                t119 : t120);
            t118 = t117 * t121;
        } else {
            t118 = TB_C(0.0);
        }
        const real_t t122 = tb_max(TB_C(0.0), t71 < t101 ? t118 - t102 : t102 - t118);
        t95 = (t92 - t93) * t117 - t102 * t94;
        t96 = t122;
        t97 = t111 - t109 * t117;
        t98 = t103 - t61 * t117;
        t99 = t101;
    } else {
        t95 = t72;
        t96 = t73;
        t97 = t74;
        t98 = t75;
        t99 = t71;
    }
    const real_t t123 = TB_C(1000000000000.0) - start_3;
    const bool t124 = TB_C(0.0) < tb_max(t23 - t27 - t95, t95 - (t27 + t123));
    real_t t125, t126, t127, t128, t129;
    if (t124) {
        const real_t t130 = tb_min(tb_max(t95, t23), t123);
        const real_t t131 = t130 * (TB_C(1.0) / (t66 * t66 + t67 * t67));
        const real_t t132 = t93 - t92;
        const bool t133 = TB_ABS(t132) <= t62;
        const real_t t134 = t94 * t131;
        const real_t t135 = TB_C(1.0) / t132;
        real_t t136, t137;
        if (t133) {
            t136 = -TB_C(1000000000000.0);
            t137 = TB_C(1000000000000.0);
        } else {
            const real_t t138 = (t29 + t134) * t135;
            const real_t t139 = t135 * (t90 + t134);
            t136 = tb_min(t138, t139);
            t137 = tb_max(t138, t139);
        }
        const bool t140 = TB_ABS(t69) <= t62;
        const real_t t141 = t68 * t131;
        const real_t t142 = TB_C(1.0) / t69;
        real_t t143, t144;
        if (t140) {
            t143 = -TB_C(1000000000000.0);
            t144 = TB_C(1000000000000.0);
        } else {
            const real_t t145 = (t31 - t141) * t142;
            const real_t t146 = t142 * (t56 - t141);
            t143 = tb_min(t145, t146);
            t144 = tb_max(t145, t146);
        }
        const real_t t147 = t46 * t66 + t38 * t67;
        const bool t148 = TB_ABS(t147) <= t62;
        const real_t t149 = t70 * t131;
        const real_t t150 = TB_C(1.0) / t147;
        real_t t151, t152;
        if (t148) {
            t151 = -TB_C(1000000000000.0);
            t152 = TB_C(1000000000000.0);
        } else {
            const real_t t153 = (t63 - t149) * t150;
            const real_t t154 = t150 * (t64 - t149);
            t151 = tb_min(t153, t154);
            t152 = tb_max(t153, t154);
        }
        const real_t t155 = tb_max(t143, t151);
        const real_t t156 = tb_min(t144, t152);
        const real_t t157 = tb_min(tb_max(TB_C(0.0), tb_max(t136, t155)), tb_min(t137, t156));
        real_t t158;
        if (TB_C(0.0) < TB_ABS(t157)) {
            const real_t t159 = -(t94 * t135);
            const real_t t160 = t68 * t142;
            const real_t t161 = t70 * t150;
            real_t t162;
            if (TB_C(0.0) < t157) {
                t162 = t155 < t136 ? t159 : (t151 < t143 ? t160 : t161);
            } else {
                t162 = t137 < t156 ? t159 : (t144 < t152 ? t160 : t161);
            }
            t158 = t157 * t162;
        } else {
            t158 = TB_C(0.0);
        }
        const real_t t163 = tb_max(TB_C(0.0), t95 < t130 ? t158 - t131 : t131 - t158);
        t125 = t163;
        t126 = t149 + t147 * t157;
        t127 = t141 + t69 * t157;
        t128 = t132 * t157 - t134;
        t129 = t130;
    } else {
        t125 = t96;
        t126 = t97;
        t127 = t98;
        t128 = t99;
        t129 = t95;
    }
    const real_t t164 = tb_min(tb_max(t126 - t49, TB_C(3.0)), TB_C(1000000000000.0));
    const real_t t165 = tb_min(tb_max(start_1 + t127, TB_C(3.0)), TB_C(1000000000000.0));
    const real_t t166 = tb_min(tb_max(start_2 + t128, TB_C(3.0)), TB_C(1000000000000.0));
    const real_t t167 = structure[0] * t164 + structure[1] * t165 + structure[2] * t166;
    const real_t t168 = tb_min(tb_max(start_3 + t129, TB_C(3.0)), TB_C(1000000000000.0));
    const real_t t169 = tb_max(t125, TB_ABS(t167 + structure[3] * t168 - wrench[0]));
    const real_t t170 = structure[4] * t164 + structure[5] * t165 + structure[6] * t166;
    const real_t t171 = tb_max(t169, TB_ABS(t170 + structure[7] * t168 - wrench[1]));
    const bool t172 = t171 <= t26 * (t24 * (TB_EPSILON * TB_C(64.0)));
    real_t tension_0, tension_1, tension_2, tension_3, kkt_residual_0;
    if (t172) {
        tension_0 = tb_min(t164, TB_C(10.0));
        tension_1 = tb_min(t165, TB_C(10.0));
        tension_2 = tb_min(t166, TB_C(10.0));
        tension_3 = tb_min(t168, TB_C(10.0));
        kkt_residual_0 = t171;
    } else {
        tension_0 = TB_C(3.0);
        tension_1 = TB_C(3.0);
        tension_2 = TB_C(3.0);
        tension_3 = TB_C(3.0);
        kkt_residual_0 = TB_C(0.0);
    }
    const bool t173 = !t172;
    const real_t t174 = structure[0] * tension_0 + structure[1] * tension_1;
    /* what the tensions exert, S T */
    const real_t delivered_0 = t174 + structure[2] * tension_2 + structure[3] * tension_3;
    const real_t t175 = structure[4] * tension_0 + structure[5] * tension_1;
    const real_t delivered_1 = t175 + structure[6] * tension_2 + structure[7] * tension_3;
    const bool t176 = !(TB_EPSILON * TB_C(4096.0) < t25);
    const bool t177 = TB_C(10.0) < t164 || TB_C(10.0) < t165 || TB_C(10.0) < t166;
    const bool t178 = t177 || TB_C(10.0) < t168;
    if (t176) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    delivered[0] = delivered_0;
    delivered[1] = delivered_1;
    kkt_residual[0] = kkt_residual_0;
    return (t173 || t178) ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_distribute_tension_scale(const real_t structure[8], const real_t wrench[2], real_t
    tension[4], real_t delivered[2], real_t kkt_residual[1])
{
    tb_status status = tb_least_norm_tension_quick(structure, wrench, tension, delivered,
        kkt_residual);
    if (status != TB_INACCURATE) {
        return status;
    }
    real_t served[2];
    const tb_status verdict = tb_served_wrench_scale(structure, wrench, served);
    if (status == TB_INACCURATE) {
        status = tb_least_norm_tension_quick(structure, served, tension, delivered,
            kkt_residual);
    }
    if (status == TB_INACCURATE) {
        status = tb_least_norm_tension(structure, served, tension, delivered, kkt_residual);
    }
    return status == TB_OK ? verdict : status;
}

tb_status tb_distribute_tension_closest(const real_t structure[8], const real_t wrench[2],
    real_t tension[4], real_t delivered[2], real_t kkt_residual[1])
{
    tb_status status = tb_least_norm_tension_quick(structure, wrench, tension, delivered,
        kkt_residual);
    if (status != TB_INACCURATE) {
        return status;
    }
    real_t served[2];
    const tb_status verdict = tb_served_wrench_closest(structure, wrench, served);
    if (status == TB_INACCURATE) {
        status = tb_least_norm_tension_quick(structure, served, tension, delivered,
            kkt_residual);
    }
    if (status == TB_INACCURATE) {
        status = tb_least_norm_tension(structure, served, tension, delivered, kkt_residual);
    }
    return status == TB_OK ? verdict : status;
}

tb_status tb_distribute_tension(const real_t structure[8], const real_t wrench[2], real_t
    tension[4], real_t delivered[2], real_t kkt_residual[1])
{
    return tb_distribute_tension_scale(structure, wrench, tension, delivered, kkt_residual);
}

