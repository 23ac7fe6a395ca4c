/* Regenerate: turnbuckle generate machines/yoon2023.toml --out generated/yoon2023
 * Machine 771308446b34ef3a, generator 0.1.0, casadi 3.8.2. Do not edit. */
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
    const real_t t0 = structure[0] * structure[7];
    const real_t t1 = structure[4] * structure[3];
    const real_t cross_03 = t0 - t1;
    /* s_i x W */
    const real_t height_0 = structure[0] * wrench[1] - structure[4] * wrench[0];
    const real_t cross_13 = structure[7] * structure[1] - structure[3] * structure[5];
    const real_t height_1 = wrench[1] * structure[1] - wrench[0] * structure[5];
    const real_t t2 = structure[7] * structure[2];
    const real_t t3 = structure[3] * structure[6];
    const real_t cross_23 = t2 - t3;
    const real_t height_2 = wrench[1] * structure[2] - wrench[0] * structure[6];
    const real_t t4 = cross_03 * height_0 + cross_13 * height_1 + cross_23 * height_2;
    const real_t t5 = structure[0] * structure[5];
    const real_t t6 = structure[4] * structure[1];
    const real_t cross_01 = t5 - t6;
    const real_t t7 = cross_01 * cross_01;
    const real_t t8 = cross_23 * cross_23;
    const real_t cross_02 = structure[0] * structure[6] - structure[4] * structure[2];
    const real_t t9 = cross_02 * cross_02;
    const real_t t10 = cross_13 * cross_13;
    const real_t t11 = cross_03 * cross_03;
    const real_t t12 = structure[1] * structure[6];
    const real_t t13 = structure[5] * structure[2];
    const real_t cross_12 = t12 - t13;
    const real_t t14 = cross_12 * cross_12;
    /* det S S', Cauchy-Binet */
    const real_t determinant = t7 + t8 + (t9 + t10) + (t11 + t14);
    const real_t t15 = TB_C(1.0) / determinant;
    /* the least-norm tensions that exert the wrench */
    const real_t start_3 = t4 * t15;
    const real_t t16 = TB_C(3.0) - start_3;
    const real_t t17 = TB_SQRT(determinant) * TB_C(0.5);
    const real_t t18 = TB_C(1.0) / t17;
    const real_t t19 = TB_C(320.0) * TB_EPSILON * t18;
    const real_t height_3 = structure[3] * wrench[1] - structure[7] * wrench[0];
    const real_t t20 = height_0 * cross_02 + height_1 * cross_12 - cross_23 * height_3;
    const real_t start_2 = t15 * t20;
    const real_t t21 = TB_C(3.0) - start_2;
    const real_t t22 = t21 - t19;
    const real_t t23 = height_0 * cross_01 - height_2 * cross_12 - cross_13 * height_3;
    const real_t start_1 = t15 * t23;
    const real_t t24 = TB_C(3.0) - start_1;
    const real_t t25 = t24 - t19;
    const real_t t26 = cross_02 * cross_12 + cross_03 * cross_13;
    const real_t t27 = height_1 * cross_01 + height_2 * cross_02 + cross_03 * height_3;
    const real_t t28 = t15 * t27;
    const real_t t29 = TB_C(3.0) + t28;
    const real_t t30 = t28 + TB_C(10.0);
    const real_t t31 = tb_min(tb_max(TB_C(0.0), t29), t30);
    const real_t t32 = TB_C(1.0) / tb_max(t14 + (t8 + t10), TB_C(1e-30));
    const real_t t33 = t31 * t32;
    const real_t t34 = t26 * t33;
    const real_t t35 = TB_C(10.0) - start_1;
    const real_t t36 = t19 + t35;
    const real_t t37 = tb_max(t25 + t34, -(t34 + t36));
    const bool t38 = TB_C(0.0) < t37;
    const real_t t39 = TB_EPSILON * TB_C(16.0);
    const real_t t40 = t29 - t19;
    const real_t t41 = -t34;
    const real_t t42 = t19 + t30;
    const real_t t43 = cross_01 * cross_02 + cross_13 * cross_23;
    const real_t t44 = cross_03 * cross_23 - cross_01 * cross_12;
    const real_t t45 = cross_03 * cross_01 - cross_23 * cross_12;
    const real_t t46 = cross_13 * cross_01 + cross_23 * cross_02;
    const real_t t47 = TB_C(2.0) * t19;
    const real_t t48 = t19 * TB_C(1024.0);
    real_t t49, t50, t51, t52, t53;
    if (t38) {
        const bool t54 = TB_ABS(cross_23) <= t39;
        const real_t t55 = tb_min(tb_max(t41, t24), t35);
        const real_t t56 = t55 * (TB_C(1.0) / tb_max(t9 + (t8 + t11), TB_C(1e-30)));
        const real_t t57 = t26 * t56;
        const real_t t58 = TB_C(1.0) / cross_23;
        real_t t59, t60, t61;
        if (t54) {
            t59 = -TB_C(1000000000000.0);
            t60 = TB_C(1000000000000.0);
            t61 = TB_C(0.0);
        } else {
            const real_t t62 = -((t40 + t57) * t58);
            const real_t t63 = -(t58 * (t57 + t42));
            t59 = tb_min(t62, t63);
            t60 = tb_max(t62, t63);
            t61 = t47 * TB_ABS(TB_C(1.0) / (t3 - t2));
        }
        const real_t t64 = tb_min(tb_max(TB_C(0.0), t59), t60);
        const real_t t65 = determinant * t56;
        const real_t t66 = TB_C(0.0) < TB_ABS(t64) ? t64 * (t26 * t58) : TB_C(0.0);
        const real_t t67 = t41 < t55 ? t66 - t65 : t65 - t66;
        const real_t t68 = t59 + t61 < t60 - t61 && t48 < t37 ? t67 : TB_C(0.0);
        t49 = cross_03 * t64 - t56 * t43;
        t50 = -(t56 * t45 + cross_02 * t64);
        t51 = -(t57 + cross_23 * t64);
        t52 = t55;
        t53 = TB_C(0.0) < t67 ? t68 : TB_C(0.0);
    } else {
        t49 = -(t33 * t44);
        t50 = t33 * t46;
        t51 = t31;
        t52 = t41;
        t53 = TB_C(0.0);
    }
    const real_t t69 = TB_C(10.0) - start_2;
    const real_t t70 = t19 + t69;
    const real_t t71 = tb_max(t22 - t49, t49 - t70);
    const bool t72 = TB_C(0.0) < t71;
    const real_t t73 = cross_03 * cross_02 + cross_13 * cross_12;
    real_t t74, t75, t76, t77, t78;
    if (t72) {
        const bool t79 = TB_ABS(cross_03) <= t39;
        const real_t t80 = tb_min(tb_max(t49, t21), t69);
        const real_t t81 = TB_C(1.0) / tb_max(t7 + (t10 + t11), TB_C(1e-30));
        const real_t t82 = t80 * t81;
        const real_t t83 = t43 * t82;
        const real_t t84 = TB_C(1.0) / cross_03;
        real_t t85, t86, t87;
        if (t79) {
            t85 = -TB_C(1000000000000.0);
            t86 = TB_C(1000000000000.0);
            t87 = TB_C(0.0);
        } else {
            const real_t t88 = -((t25 + t83) * t84);
            const real_t t89 = -(t84 * (t36 + t83));
            t85 = tb_min(t88, t89);
            t86 = tb_max(t88, t89);
            t87 = t47 * TB_ABS(TB_C(1.0) / (t1 - t0));
        }
        const bool t90 = TB_ABS(cross_13) <= t39;
        const real_t t91 = t44 * t82;
        const real_t t92 = TB_C(1.0) / cross_13;
        real_t t93, t94, t95;
        if (t90) {
            t93 = -TB_C(1000000000000.0);
            t94 = TB_C(1000000000000.0);
            t95 = TB_C(0.0);
        } else {
            const real_t t96 = (t40 + t91) * t92;
            const real_t t97 = t92 * (t42 + t91);
            t93 = tb_min(t96, t97);
            t94 = tb_max(t96, t97);
            t95 = t47 * TB_ABS(t92);
        }
        const real_t t98 = tb_min(tb_max(TB_C(0.0), tb_max(t85, t93)), tb_min(t86, t94));
        const real_t t99 = determinant * t82;
        real_t t100;
        if (TB_C(0.0) < TB_ABS(t98)) {
            const real_t t101 = t43 * t84;
            const real_t t102 = -(t44 * t92);
            const real_t t103 = TB_C(0.0) < t98 ? (t93 < t85 ? t101 : t102) : (t86 < t94 ? t101
                : t102);
            t100 = t98 * t103;
        } else {
            t100 = TB_C(0.0);
        }
        const real_t t104 = t49 < t80 ? t100 - t99 : t99 - t100;
        real_t t105;
        if (TB_C(0.0) < t104) {
            const bool t106 = tb_max(t93 + t95, t85 + t87) < tb_min(t94 - t95, t86 - t87);
            t105 = t106 && t48 < t71 ? t104 : TB_C(0.0);
        } else {
            t105 = TB_C(0.0);
        }
        t74 = cross_01 * t98 - t82 * t73;
        t75 = cross_13 * t98 - t91;
        t76 = -(t83 + cross_03 * t98);
        t77 = t80;
        t78 = t105;
    } else {
        t74 = t50;
        t75 = t51;
        t76 = t52;
        t77 = t49;
        t78 = t53;
    }
    const real_t t107 = TB_C(10.0) - start_3;
    const real_t t108 = tb_max(t16 - t19 - t74, t74 - (t19 + t107));
    const bool t109 = TB_C(0.0) < t108;
    real_t t110, t111, t112, t113, t114;
    if (t109) {
        const real_t t115 = tb_min(tb_max(t74, t16), t107);
        const real_t t116 = t115 * (TB_C(1.0) / tb_max(t7 + (t9 + t14), TB_C(1e-30)));
        const real_t t117 = t46 * t116;
        const bool t118 = TB_ABS(cross_01) <= t39;
        const real_t t119 = t73 * t116;
        const real_t t120 = TB_C(1.0) / cross_01;
        real_t t121, t122, t123;
        if (t118) {
            t121 = -TB_C(1000000000000.0);
            t122 = TB_C(1000000000000.0);
            t123 = TB_C(0.0);
        } else {
            const real_t t124 = -((t22 + t119) * t120);
            const real_t t125 = -(t120 * (t70 + t119));
            t121 = tb_min(t124, t125);
            t122 = tb_max(t124, t125);
            t123 = t47 * TB_ABS(TB_C(1.0) / (t6 - t5));
        }
        const bool t126 = TB_ABS(cross_02) <= t39;
        const real_t t127 = t45 * t116;
        const real_t t128 = TB_C(1.0) / cross_02;
        real_t t129, t130, t131;
        if (t126) {
            t129 = -TB_C(1000000000000.0);
            t130 = TB_C(1000000000000.0);
            t131 = TB_C(0.0);
        } else {
            const real_t t132 = (t25 + t127) * t128;
            const real_t t133 = t128 * (t36 + t127);
            t129 = tb_min(t132, t133);
            t130 = tb_max(t132, t133);
            t131 = t47 * TB_ABS(t128);
        }
        const bool t134 = TB_ABS(cross_12) <= t39;
        const real_t t135 = TB_C(1.0) / cross_12;
        real_t t136, t137, t138;
        if (t134) {
            t136 = -TB_C(1000000000000.0);
            t137 = TB_C(1000000000000.0);
            t138 = TB_C(0.0);
        } else {
            const real_t t139 = -((t40 - t117) * t135);
            const real_t t140 = -(t135 * (t42 - t117));
            t136 = tb_min(t139, t140);
            t137 = tb_max(t139, t140);
            t138 = t47 * TB_ABS(TB_C(1.0) / (t13 - t12));
        }
        const real_t t141 = tb_max(t129, t136);
        const real_t t142 = tb_min(t130, t137);
        const real_t t143 = tb_min(tb_max(TB_C(0.0), tb_max(t121, t141)), tb_min(t122, t142));
        const real_t t144 = determinant * t116;
        real_t t145;
        if (TB_C(0.0) < TB_ABS(t143)) {
            const real_t t146 = t73 * t120;
            const real_t t147 = -(t45 * t128);
            const real_t t148 = -(t46 * t135);
            real_t t149;
            if (TB_C(0.0) < t143) {
                t149 = t141 < t121 ? t146 : (t136 < t129 ? t147 : t148);
            } else {
                t149 = t122 < t142 ? t146 : (t130 < t137 ? t147 : t148);
            }
            t145 = t143 * t149;
        } else {
            t145 = TB_C(0.0);
        }
        const real_t t150 = t74 < t115 ? t145 - t144 : t144 - t145;
        real_t t151;
        if (TB_C(0.0) < t150) {
            const real_t t152 = tb_max(tb_max(t136 + t138, t129 + t131), t121 + t123);
            const real_t t153 = tb_min(tb_min(t137 - t138, t130 - t131), t122 - t123);
            t151 = t152 < t153 && t48 < t108 ? t150 : TB_C(0.0);
        } else {
            t151 = TB_C(0.0);
        }
        t110 = t117 - cross_12 * t143;
        t111 = cross_02 * t143 - t127;
        t112 = -(t119 + cross_01 * t143);
        t113 = t115;
        t114 = t151;
    } else {
        t110 = t75;
        t111 = t76;
        t112 = t77;
        t113 = t74;
        t114 = t78;
    }
    const real_t tension_0 = tb_min(tb_max(t110 - t28, TB_C(3.0)), TB_C(10.0));
    const real_t tension_1 = tb_min(tb_max(start_1 + t111, TB_C(3.0)), TB_C(10.0));
    const real_t tension_2 = tb_min(tb_max(start_2 + t112, TB_C(3.0)), TB_C(10.0));
    const real_t tension_3 = tb_min(tb_max(start_3 + t113, TB_C(3.0)), TB_C(10.0));
    const real_t t154 = structure[0] * tension_0 + structure[1] * tension_1;
    /* what the tensions exert, S T */
    const real_t delivered_0 = t154 + structure[2] * tension_2 + structure[3] * tension_3;
    const real_t t155 = structure[4] * tension_0 + structure[5] * tension_1;
    const real_t delivered_1 = t155 + structure[6] * tension_2 + structure[7] * tension_3;
    const real_t kkt_residual_0 = tb_max(tb_max(t114, TB_ABS(delivered_0 - wrench[0])),
        TB_ABS(delivered_1 - wrench[1]));
    const bool t156 = !(TB_EPSILON * TB_C(4096.0) < t17);
    const bool t157 = kkt_residual_0 <= t18 * (TB_EPSILON * TB_C(5120.0));
    const bool t158 = !t157;
    if (t156) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    if (t158) {
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
    const real_t t24 = TB_ABS(t3);
    const real_t t25 = TB_ABS(t12);
    const real_t t26 = TB_C(1.0) / tb_min(t24, t25);
    const real_t t27 = TB_C(80.0) * TB_EPSILON * t26;
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
    const real_t t51 = t49 + TB_C(10.0);
    const real_t t52 = tb_min(tb_max(TB_C(0.0), t50), t51);
    const real_t t53 = t52 / tb_max(t38 * t38 + t46 * t46, TB_C(1e-30));
    const real_t t54 = t48 * t53;
    const real_t t55 = TB_C(10.0) - start_1;
    const real_t t56 = t27 + t55;
    const real_t t57 = tb_max(t31 - t54, t54 - t56);
    const bool t58 = TB_C(0.0) < t57;
    const real_t t59 = t43 + structure[2] * t45;
    const real_t t60 = t33 - structure[2] * t37;
    const real_t t61 = t47 * t59 - t39 * t60;
    const real_t t62 = t39 * t59 + t47 * t60;
    const real_t t63 = TB_EPSILON * TB_C(16.0);
    const real_t t64 = t50 - t27;
    const real_t t65 = t27 + t51;
    const real_t t66 = t46 * t59 - t38 * t60;
    const real_t t67 = t35 + structure[3] * t37;
    const real_t t68 = t41 - structure[3] * t45;
    const real_t t69 = t39 * t67 - t47 * t68;
    const real_t t70 = t39 * t68 + t47 * t67;
    const real_t t71 = t38 * t67 - t46 * t68;
    const real_t t72 = t27 * TB_C(2.0);
    const real_t t73 = t27 * TB_C(1024.0);
    real_t t74, t75, t76, t77, t78;
    if (t58) {
        const real_t t79 = tb_min(tb_max(t54, t30), t55);
        const real_t t80 = TB_C(1.0) / tb_max(t39 * t39 + t47 * t47, TB_C(1e-30));
        const real_t t81 = t79 * t80;
        const real_t t82 = t39 * t46 - t38 * t47;
        const bool t83 = TB_ABS(t82) <= t63;
        const real_t t84 = t48 * t81;
        const real_t t85 = TB_C(1.0) / t82;
        real_t t86, t87, t88;
        if (t83) {
            t86 = -TB_C(1000000000000.0);
            t87 = TB_C(1000000000000.0);
            t88 = TB_C(0.0);
        } else {
            const real_t t89 = (t64 - t84) * t85;
            const real_t t90 = t85 * (t65 - t84);
            t86 = tb_min(t89, t90);
            t87 = tb_max(t89, t90);
            t88 = t72 * TB_ABS(t85);
        }
        const real_t t91 = tb_min(tb_max(TB_C(0.0), t86), t87);
        const real_t t92 = TB_C(0.0) < TB_ABS(t91) ? t91 * (t48 * t85) : TB_C(0.0);
        const real_t t93 = t54 < t79 ? t92 - t81 : t81 - t92;
        const real_t t94 = t86 + t88 < t87 - t88 && t73 < t57 ? t93 : TB_C(0.0);
        t74 = t61 * t81 + t62 * t91;
        t75 = t81 * t69 - t91 * t70;
        t76 = t84 + t82 * t91;
        t77 = t79;
        t78 = TB_C(0.0) < t93 ? t94 : TB_C(0.0);
    } else {
        t74 = t53 * t66;
        t75 = t53 * t71;
        t76 = t52;
        t77 = t54;
        t78 = TB_C(0.0);
    }
    const real_t t95 = TB_C(10.0) - start_2;
    const real_t t96 = t27 + t95;
    const real_t t97 = tb_max(t29 - t74, t74 - t96);
    const bool t98 = TB_C(0.0) < t97;
    const real_t t99 = t60 * t68;
    const real_t t100 = t59 * t67;
    const real_t t101 = t60 * t67 + t59 * t68;
    real_t t102, t103, t104, t105, t106;
    if (t98) {
        const bool t107 = TB_ABS(t62) <= t63;
        const real_t t108 = tb_min(tb_max(t74, t28), t95);
        const real_t t109 = TB_C(1.0) / tb_max(t60 * t60 + t59 * t59, TB_C(1e-30));
        const real_t t110 = t108 * t109;
        const real_t t111 = t61 * t110;
        const real_t t112 = TB_C(1.0) / t62;
        real_t t113, t114, t115;
        if (t107) {
            t113 = -TB_C(1000000000000.0);
            t114 = TB_C(1000000000000.0);
            t115 = TB_C(0.0);
        } else {
            const real_t t116 = -((t31 - t111) * t112);
            const real_t t117 = -(t112 * (t56 - t111));
            t113 = tb_min(t116, t117);
            t114 = tb_max(t116, t117);
            t115 = t72 * TB_ABS(TB_C(1.0) / -t62);
        }
        const real_t t118 = t46 * t60 + t38 * t59;
        const bool t119 = TB_ABS(t118) <= t63;
        const real_t t120 = t66 * t110;
        const real_t t121 = TB_C(1.0) / t118;
        real_t t122, t123, t124;
        if (t119) {
            t122 = -TB_C(1000000000000.0);
            t123 = TB_C(1000000000000.0);
            t124 = TB_C(0.0);
        } else {
            const real_t t125 = -((t64 - t120) * t121);
            const real_t t126 = -(t121 * (t65 - t120));
            t122 = tb_min(t125, t126);
            t123 = tb_max(t125, t126);
            t124 = t72 * TB_ABS(TB_C(1.0) / -t118);
        }
        const real_t t127 = tb_min(tb_max(TB_C(0.0), tb_max(t113, t122)), tb_min(t114, t123));
        real_t t128;
        if (TB_C(0.0) < TB_ABS(t127)) {
            const real_t t129 = -(t61 * t112);
            const real_t t130 = -(t66 * t121);
            const real_t t131 = TB_C(0.0) < t127 ? (t122 < t113 ? t129 : t130) : (t114 < t123 ?
                t129 : t130);
            t128 = t127 * t131;
        } else {
            t128 = TB_C(0.0);
        }
        const real_t t132 = t74 < t108 ? t128 - t110 : t110 - t128;
        real_t t133;
        if (TB_C(0.0) < t132) {
            const bool t134 = tb_max(t122 + t124, t113 + t115) < tb_min(t123 - t124, t114 -
                t115);
            t133 = t134 && t73 < t97 ? t132 : TB_C(0.0);
        } else {
            t133 = TB_C(0.0);
        }
        t102 = (t99 - t100) * t127 - t110 * t101;
        t103 = t120 - t118 * t127;
        t104 = t111 - t62 * t127;
        t105 = t108;
        t106 = t133;
    } else {
        t102 = t75;
        t103 = t76;
        t104 = t77;
        t105 = t74;
        t106 = t78;
    }
    const real_t t135 = TB_C(10.0) - start_3;
    const real_t t136 = tb_max(t23 - t27 - t102, t102 - (t27 + t135));
    const bool t137 = TB_C(0.0) < t136;
    real_t t138, t139, t140, t141, t142;
    if (t137) {
        const real_t t143 = tb_min(tb_max(t102, t23), t135);
        const real_t t144 = TB_C(1.0) / tb_max(t67 * t67 + t68 * t68, TB_C(1e-30));
        const real_t t145 = t143 * t144;
        const real_t t146 = t71 * t145;
        const real_t t147 = t46 * t67 + t38 * t68;
        const real_t t148 = t100 - t99;
        const bool t149 = TB_ABS(t148) <= t63;
        const real_t t150 = t101 * t145;
        const real_t t151 = TB_C(1.0) / t148;
        real_t t152, t153, t154;
        if (t149) {
            t152 = -TB_C(1000000000000.0);
            t153 = TB_C(1000000000000.0);
            t154 = TB_C(0.0);
        } else {
            const real_t t155 = (t29 + t150) * t151;
            const real_t t156 = t151 * (t96 + t150);
            t152 = tb_min(t155, t156);
            t153 = tb_max(t155, t156);
            t154 = t72 * TB_ABS(t151);
        }
        const bool t157 = TB_ABS(t70) <= t63;
        const real_t t158 = t69 * t145;
        const real_t t159 = TB_C(1.0) / t70;
        real_t t160, t161, t162;
        if (t157) {
            t160 = -TB_C(1000000000000.0);
            t161 = TB_C(1000000000000.0);
            t162 = TB_C(0.0);
        } else {
            const real_t t163 = (t31 - t158) * t159;
            const real_t t164 = t159 * (t56 - t158);
            t160 = tb_min(t163, t164);
            t161 = tb_max(t163, t164);
            t162 = t72 * TB_ABS(t159);
        }
        const bool t165 = TB_ABS(t147) <= t63;
        const real_t t166 = TB_C(1.0) / t147;
        real_t t167, t168, t169;
        if (t165) {
            t167 = -TB_C(1000000000000.0);
            t168 = TB_C(1000000000000.0);
            t169 = TB_C(0.0);
        } else {
            const real_t t170 = (t64 - t146) * t166;
            const real_t t171 = t166 * (t65 - t146);
            t167 = tb_min(t170, t171);
            t168 = tb_max(t170, t171);
            t169 = t72 * TB_ABS(t166);
        }
        const real_t t172 = tb_max(t160, t167);
        const real_t t173 = tb_min(t161, t168);
        const real_t t174 = tb_min(tb_max(TB_C(0.0), tb_max(t152, t172)), tb_min(t153, t173));
        real_t t175;
        if (TB_C(0.0) < TB_ABS(t174)) {
            const real_t t176 = -(t101 * t151);
            const real_t t177 = t69 * t159;
            const real_t t178 = t71 * t166;
            real_t t179;
            if (TB_C(0.0) < t174) {
                t179 = t172 < t152 ? t176 : (t167 < t160 ? t177 : t178);
            } else {
                t179 = t153 < t173 ? t176 : (t161 < t168 ? t177 : t178);
            }
            t175 = t174 * t179;
        } else {
            t175 = TB_C(0.0);
        }
        const real_t t180 = t102 < t143 ? t175 - t145 : t145 - t175;
        real_t t181;
        if (TB_C(0.0) < t180) {
            const real_t t182 = tb_max(tb_max(t167 + t169, t160 + t162), t152 + t154);
            const real_t t183 = tb_min(tb_min(t168 - t169, t161 - t162), t153 - t154);
            t181 = t182 < t183 && t73 < t136 ? t180 : TB_C(0.0);
        } else {
            t181 = TB_C(0.0);
        }
        t138 = t146 + t147 * t174;
        t139 = t158 + t70 * t174;
        t140 = t148 * t174 - t150;
        t141 = t143;
        t142 = t181;
    } else {
        t138 = t103;
        t139 = t104;
        t140 = t105;
        t141 = t102;
        t142 = t106;
    }
    const real_t tension_0 = tb_min(tb_max(t138 - t49, TB_C(3.0)), TB_C(10.0));
    const real_t tension_1 = tb_min(tb_max(start_1 + t139, TB_C(3.0)), TB_C(10.0));
    const real_t tension_2 = tb_min(tb_max(start_2 + t140, TB_C(3.0)), TB_C(10.0));
    const real_t tension_3 = tb_min(tb_max(start_3 + t141, TB_C(3.0)), TB_C(10.0));
    const real_t t184 = structure[0] * tension_0 + structure[1] * tension_1;
    /* what the tensions exert, S T */
    const real_t delivered_0 = t184 + structure[2] * tension_2 + structure[3] * tension_3;
    const real_t t185 = structure[4] * tension_0 + structure[5] * tension_1;
    const real_t delivered_1 = t185 + structure[6] * tension_2 + structure[7] * tension_3;
    const real_t kkt_residual_0 = tb_max(tb_max(t142, TB_ABS(delivered_0 - wrench[0])),
        TB_ABS(delivered_1 - wrench[1]));
    const real_t t186 = TB_EPSILON * TB_C(4096.0);
    const bool t187 = !(t186 < t24 && t186 < t25);
    const bool t188 = kkt_residual_0 <= t26 * (TB_EPSILON * TB_C(1280.0));
    const bool t189 = !t188;
    if (t187) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    if (t189) {
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
        const real_t t43 = structure[0] * t1 - structure[4] * t4;
        real_t t44, t45;
        if (t42) {
            const real_t t46 = TB_C(1.0) / t41;
            const real_t t47 = (t43 - facet_0) * t46;
            const real_t t48 = t46 * (facet_0 + t43);
            t44 = tb_max(t47, t48);
            t45 = tb_min(t47, t48);
        } else {
            const real_t t49 = TB_ABS(t43) <= facet_0 ? -TB_C(1e+30) : TB_C(1e+30);
            t44 = TB_C(1e+30);
            t45 = t49;
        }
        const real_t t50 = wrench[1] * structure[1] - structure[5] * wrench[0];
        const bool t51 = TB_C(0.0) < TB_ABS(t50);
        const real_t t52 = t1 * structure[1] - structure[5] * t4;
        real_t t53, t54;
        if (t51) {
            const real_t t55 = TB_C(1.0) / t50;
            const real_t t56 = (t52 - facet_1) * t55;
            const real_t t57 = t55 * (facet_1 + t52);
            t53 = tb_max(t56, t57);
            t54 = tb_min(t56, t57);
        } else {
            const real_t t58 = TB_ABS(t52) <= facet_1 ? -TB_C(1e+30) : TB_C(1e+30);
            t53 = TB_C(1e+30);
            t54 = t58;
        }
        const real_t t59 = wrench[1] * structure[2] - structure[6] * wrench[0];
        const bool t60 = TB_C(0.0) < TB_ABS(t59);
        const real_t t61 = t1 * structure[2] - structure[6] * t4;
        real_t t62, t63;
        if (t60) {
            const real_t t64 = TB_C(1.0) / t59;
            const real_t t65 = (t61 - facet_2) * t64;
            const real_t t66 = t64 * (facet_2 + t61);
            t62 = tb_max(t65, t66);
            t63 = tb_min(t65, t66);
        } else {
            const real_t t67 = TB_ABS(t61) <= facet_2 ? -TB_C(1e+30) : TB_C(1e+30);
            t62 = TB_C(1e+30);
            t63 = t67;
        }
        const real_t t68 = wrench[1] * structure[3] - structure[7] * wrench[0];
        const bool t69 = TB_C(0.0) < TB_ABS(t68);
        const real_t t70 = t1 * structure[3] - structure[7] * t4;
        real_t t71, t72;
        if (t69) {
            const real_t t73 = TB_C(1.0) / t68;
            const real_t t74 = (t70 - facet_3) * t73;
            const real_t t75 = t73 * (facet_3 + t70);
            t71 = tb_max(t74, t75);
            t72 = tb_min(t74, t75);
        } else {
            const real_t t76 = TB_ABS(t70) <= facet_3 ? -TB_C(1e+30) : TB_C(1e+30);
            t71 = TB_C(1e+30);
            t72 = t76;
        }
        const real_t t77 = tb_min(tb_min(tb_min(t44, t53), t62), t71);
        const real_t t78 = tb_min(t77, TB_C(1.0));
        const bool t79 = t78 < tb_max(tb_max(tb_max(t45, t54), t63), t72) || t77 < TB_C(0.0);
        real_t t80, t81;
        if (t79) {
            const bool t82 = TB_C(0.0) < t37;
            const real_t t83 = TB_C(16.0) * TB_EPSILON;
            const bool t84 = t19 <= t83;
            const real_t t85 = structure[0] * structure[3] + structure[4] * structure[7];
            const bool t86 = TB_C(0.0) < t85;
            const bool t87 = !t84;
            const bool t88 = (t84 && !t86) || (t87 && TB_C(0.0) < t17 - t16);
            const bool t89 = !t82;
            const real_t t90 = (t82 && t88) || (t89 && !t88) ? TB_C(10.0) : TB_C(3.0);
            const bool t91 = t29 <= t83;
            const real_t t92 = structure[1] * structure[3] + structure[5] * structure[7];
            const bool t93 = TB_C(0.0) < t92;
            const bool t94 = !t91;
            const bool t95 = (t91 && !t93) || (t94 && TB_C(0.0) < t27 - t26);
            const real_t t96 = (t82 && t95) || (t89 && !t95) ? TB_C(10.0) : TB_C(3.0);
            const bool t97 = t35 <= t83;
            const real_t t98 = structure[2] * structure[3] + structure[6] * structure[7];
            const bool t99 = TB_C(0.0) < t98;
            const bool t100 = !t97;
            const bool t101 = (t97 && !t99) || (t100 && TB_C(0.0) < t33 - t32);
            const real_t t102 = (t82 && t101) || (t89 && !t101) ? TB_C(10.0) : TB_C(3.0);
            const real_t t103 = structure[0] * t90 + structure[1] * t96 + structure[2] * t102;
            const real_t t104 = structure[4] * t90 + structure[5] * t96 + structure[6] * t102;
            const real_t t105 = structure[3] * (wrench[0] - t103) + structure[7] * (wrench[1] -
                t104);
            const real_t t106 = structure[3] * structure[3] + structure[7] * structure[7];
            const real_t t107 = tb_min(tb_max(t105 * (TB_C(1.0) / t106), TB_C(3.0)),
                TB_C(10.0));
            const real_t t108 = t103 + structure[3] * t107;
            const real_t t109 = t108 - wrench[0];
            const real_t t110 = t104 + structure[7] * t107;
            const real_t t111 = t110 - wrench[1];
            const real_t t112 = facet_3 < t38 ? t109 * t109 + t111 * t111 : TB_C(1e+30);
            const bool t113 = TB_C(0.0) < t30;
            const bool t114 = t15 <= t83;
            const real_t t115 = structure[0] * structure[2] + structure[4] * structure[6];
            const bool t116 = TB_C(0.0) < t115;
            const bool t117 = !t114;
            const bool t118 = (t114 && !t116) || (t117 && TB_C(0.0) < t13 - t12);
            const bool t119 = !t113;
            const real_t t120 = (t113 && t118) || (t119 && !t118) ? TB_C(10.0) : TB_C(3.0);
            const bool t121 = t25 <= t83;
            const real_t t122 = structure[1] * structure[2] + structure[5] * structure[6];
            const bool t123 = TB_C(0.0) < t122;
            const bool t124 = !t121;
            const bool t125 = (t121 && !t123) || (t124 && TB_C(0.0) < t23 - t22);
            const real_t t126 = (t113 && t125) || (t119 && !t125) ? TB_C(10.0) : TB_C(3.0);
            const bool t127 = (t97 && t99) || (t100 && TB_C(0.0) < t34);
            const real_t t128 = (t113 && t127) || (t119 && !t127) ? TB_C(10.0) : TB_C(3.0);
            const real_t t129 = structure[0] * t120 + structure[1] * t126 + structure[3] * t128;
            const real_t t130 = structure[4] * t120 + structure[5] * t126 + structure[7] * t128;
            const real_t t131 = structure[2] * (wrench[0] - t129) + structure[6] * (wrench[1] -
                t130);
            const real_t t132 = structure[2] * structure[2] + structure[6] * structure[6];
            const real_t t133 = tb_min(tb_max(t131 * (TB_C(1.0) / t132), TB_C(3.0)),
                TB_C(10.0));
            const real_t t134 = t129 + structure[2] * t133;
            const real_t t135 = t134 - wrench[0];
            const real_t t136 = t130 + structure[6] * t133;
            const real_t t137 = t136 - wrench[1];
            const real_t t138 = facet_2 < t31 ? t135 * t135 + t137 * t137 : TB_C(1e+30);
            const bool t139 = TB_C(0.0) < t20;
            const bool t140 = t11 <= t83;
            const real_t t141 = structure[0] * structure[1] + structure[4] * structure[5];
            const bool t142 = TB_C(0.0) < t141;
            const bool t143 = !t140;
            const bool t144 = (t140 && !t142) || (t143 && TB_C(0.0) < t9 - t8);
            const bool t145 = !t139;
            const real_t t146 = (t139 && t144) || (t145 && !t144) ? TB_C(10.0) : TB_C(3.0);
            const bool t147 = (t121 && t123) || (t124 && TB_C(0.0) < t24);
            const real_t t148 = (t139 && t147) || (t145 && !t147) ? TB_C(10.0) : TB_C(3.0);
            const bool t149 = (t91 && t93) || (t94 && TB_C(0.0) < t28);
            const real_t t150 = (t139 && t149) || (t145 && !t149) ? TB_C(10.0) : TB_C(3.0);
            const real_t t151 = structure[0] * t146 + structure[2] * t148 + structure[3] * t150;
            const real_t t152 = structure[4] * t146 + structure[6] * t148 + structure[7] * t150;
            const real_t t153 = structure[1] * (wrench[0] - t151) + structure[5] * (wrench[1] -
                t152);
            const real_t t154 = structure[1] * structure[1] + structure[5] * structure[5];
            const real_t t155 = tb_min(tb_max(t153 * (TB_C(1.0) / t154), TB_C(3.0)),
                TB_C(10.0));
            const real_t t156 = t151 + structure[1] * t155;
            const real_t t157 = t156 - wrench[0];
            const real_t t158 = t152 + structure[5] * t155;
            const real_t t159 = t158 - wrench[1];
            const real_t t160 = facet_1 < t21 ? t157 * t157 + t159 * t159 : TB_C(1e+30);
            const bool t161 = TB_C(0.0) < t6;
            const bool t162 = (t140 && t142) || (t143 && TB_C(0.0) < t10);
            const bool t163 = !t161;
            const real_t t164 = (t161 && t162) || (t163 && !t162) ? TB_C(10.0) : TB_C(3.0);
            const bool t165 = (t114 && t116) || (t117 && TB_C(0.0) < t14);
            const real_t t166 = (t161 && t165) || (t163 && !t165) ? TB_C(10.0) : TB_C(3.0);
            const bool t167 = (t84 && t86) || (t87 && TB_C(0.0) < t18);
            const real_t t168 = (t161 && t167) || (t163 && !t167) ? TB_C(10.0) : TB_C(3.0);
            const real_t t169 = structure[1] * t164 + structure[2] * t166 + structure[3] * t168;
            const real_t t170 = structure[5] * t164 + structure[6] * t166 + structure[7] * t168;
            const real_t t171 = structure[0] * (wrench[0] - t169) + structure[4] * (wrench[1] -
                t170);
            const real_t t172 = structure[0] * structure[0] + structure[4] * structure[4];
            const real_t t173 = tb_min(tb_max(t171 * (TB_C(1.0) / t172), TB_C(3.0)),
                TB_C(10.0));
            const real_t t174 = t169 + structure[0] * t173;
            const real_t t175 = t174 - wrench[0];
            const real_t t176 = t170 + structure[4] * t173;
            const real_t t177 = t176 - wrench[1];
            const real_t t178 = facet_0 < t7 ? t175 * t175 + t177 * t177 : TB_C(1e+30);
            const bool t179 = t178 < TB_C(1e+30);
            const real_t t180 = t179 ? t178 : TB_C(1e+30);
            const bool t181 = t160 < t180;
            const real_t t182 = t181 ? t160 : t180;
            const bool t183 = t138 < t182;
            real_t t184, t185, t186;
            if (t183) {
                t184 = t138;
                t185 = t134;
                t186 = t136;
            } else {
                t184 = t182;
                t185 = t181 ? t156 : (t179 ? t174 : TB_C(0.0));
                t186 = t181 ? t158 : (t179 ? t176 : TB_C(0.0));
            }
            const bool t187 = t112 < t184;
            t80 = t187 ? t108 : t185;
            t81 = t187 ? t110 : t186;
        } else {
            t80 = wrench[0] * t78;
            t81 = wrench[1] * t78;
        }
        served_0 = t80;
        served_1 = t81;
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
        const real_t t40 = TB_C(16.0) * TB_EPSILON;
        const bool t41 = t17 <= t40;
        const real_t t42 = structure[0] * structure[3] + structure[4] * structure[7];
        const bool t43 = TB_C(0.0) < t42;
        const bool t44 = !t41;
        const bool t45 = (t41 && !t43) || (t44 && TB_C(0.0) < t15 - t14);
        const bool t46 = !t39;
        const real_t t47 = (t39 && t45) || (t46 && !t45) ? TB_C(10.0) : TB_C(3.0);
        const bool t48 = t27 <= t40;
        const real_t t49 = structure[1] * structure[3] + structure[5] * structure[7];
        const bool t50 = TB_C(0.0) < t49;
        const bool t51 = !t48;
        const bool t52 = (t48 && !t50) || (t51 && TB_C(0.0) < t25 - t24);
        const real_t t53 = (t39 && t52) || (t46 && !t52) ? TB_C(10.0) : TB_C(3.0);
        const bool t54 = t33 <= t40;
        const real_t t55 = structure[2] * structure[3] + structure[6] * structure[7];
        const bool t56 = TB_C(0.0) < t55;
        const bool t57 = !t54;
        const bool t58 = (t54 && !t56) || (t57 && TB_C(0.0) < t31 - t30);
        const real_t t59 = (t39 && t58) || (t46 && !t58) ? TB_C(10.0) : TB_C(3.0);
        const real_t t60 = structure[0] * t47 + structure[1] * t53 + structure[2] * t59;
        const real_t t61 = structure[4] * t47 + structure[5] * t53 + structure[6] * t59;
        const real_t t62 = structure[3] * (wrench[0] - t60) + structure[7] * (wrench[1] - t61);
        const real_t t63 = structure[3] * structure[3] + structure[7] * structure[7];
        const real_t t64 = tb_min(tb_max(t62 * (TB_C(1.0) / t63), TB_C(3.0)), TB_C(10.0));
        const real_t t65 = t60 + structure[3] * t64;
        const real_t t66 = t65 - wrench[0];
        const real_t t67 = t61 + structure[7] * t64;
        const real_t t68 = t67 - wrench[1];
        const real_t t69 = facet_3 < t36 ? t66 * t66 + t68 * t68 : TB_C(1e+30);
        const bool t70 = TB_C(0.0) < t28;
        const bool t71 = t13 <= t40;
        const real_t t72 = structure[0] * structure[2] + structure[4] * structure[6];
        const bool t73 = TB_C(0.0) < t72;
        const bool t74 = !t71;
        const bool t75 = (t71 && !t73) || (t74 && TB_C(0.0) < t11 - t10);
        const bool t76 = !t70;
        const real_t t77 = (t70 && t75) || (t76 && !t75) ? TB_C(10.0) : TB_C(3.0);
        const bool t78 = t23 <= t40;
        const real_t t79 = structure[1] * structure[2] + structure[5] * structure[6];
        const bool t80 = TB_C(0.0) < t79;
        const bool t81 = !t78;
        const bool t82 = (t78 && !t80) || (t81 && TB_C(0.0) < t21 - t20);
        const real_t t83 = (t70 && t82) || (t76 && !t82) ? TB_C(10.0) : TB_C(3.0);
        const bool t84 = (t54 && t56) || (t57 && TB_C(0.0) < t32);
        const real_t t85 = (t70 && t84) || (t76 && !t84) ? TB_C(10.0) : TB_C(3.0);
        const real_t t86 = structure[0] * t77 + structure[1] * t83 + structure[3] * t85;
        const real_t t87 = structure[4] * t77 + structure[5] * t83 + structure[7] * t85;
        const real_t t88 = structure[2] * (wrench[0] - t86) + structure[6] * (wrench[1] - t87);
        const real_t t89 = structure[2] * structure[2] + structure[6] * structure[6];
        const real_t t90 = tb_min(tb_max(t88 * (TB_C(1.0) / t89), TB_C(3.0)), TB_C(10.0));
        const real_t t91 = t86 + structure[2] * t90;
        const real_t t92 = t91 - wrench[0];
        const real_t t93 = t87 + structure[6] * t90;
        const real_t t94 = t93 - wrench[1];
        const real_t t95 = facet_2 < t29 ? t92 * t92 + t94 * t94 : TB_C(1e+30);
        const bool t96 = TB_C(0.0) < t18;
        const bool t97 = t9 <= t40;
        const real_t t98 = structure[0] * structure[1] + structure[4] * structure[5];
        const bool t99 = TB_C(0.0) < t98;
        const bool t100 = !t97;
        const bool t101 = (t97 && !t99) || (t100 && TB_C(0.0) < t7 - t6);
        const bool t102 = !t96;
        const real_t t103 = (t96 && t101) || (t102 && !t101) ? TB_C(10.0) : TB_C(3.0);
        const bool t104 = (t78 && t80) || (t81 && TB_C(0.0) < t22);
        const real_t t105 = (t96 && t104) || (t102 && !t104) ? TB_C(10.0) : TB_C(3.0);
        const bool t106 = (t48 && t50) || (t51 && TB_C(0.0) < t26);
        const real_t t107 = (t96 && t106) || (t102 && !t106) ? TB_C(10.0) : TB_C(3.0);
        const real_t t108 = structure[0] * t103 + structure[2] * t105 + structure[3] * t107;
        const real_t t109 = structure[4] * t103 + structure[6] * t105 + structure[7] * t107;
        const real_t t110 = structure[1] * (wrench[0] - t108) + structure[5] * (wrench[1] -
            t109);
        const real_t t111 = structure[1] * structure[1] + structure[5] * structure[5];
        const real_t t112 = tb_min(tb_max(t110 * (TB_C(1.0) / t111), TB_C(3.0)), TB_C(10.0));
        const real_t t113 = t108 + structure[1] * t112;
        const real_t t114 = t113 - wrench[0];
        const real_t t115 = t109 + structure[5] * t112;
        const real_t t116 = t115 - wrench[1];
        const real_t t117 = facet_1 < t19 ? t114 * t114 + t116 * t116 : TB_C(1e+30);
        const bool t118 = TB_C(0.0) < t4;
        const bool t119 = (t97 && t99) || (t100 && TB_C(0.0) < t8);
        const bool t120 = !t118;
        const real_t t121 = (t118 && t119) || (t120 && !t119) ? TB_C(10.0) : TB_C(3.0);
        const bool t122 = (t71 && t73) || (t74 && TB_C(0.0) < t12);
        const real_t t123 = (t118 && t122) || (t120 && !t122) ? TB_C(10.0) : TB_C(3.0);
        const bool t124 = (t41 && t43) || (t44 && TB_C(0.0) < t16);
        const real_t t125 = (t118 && t124) || (t120 && !t124) ? TB_C(10.0) : TB_C(3.0);
        const real_t t126 = structure[1] * t121 + structure[2] * t123 + structure[3] * t125;
        const real_t t127 = structure[5] * t121 + structure[6] * t123 + structure[7] * t125;
        const real_t t128 = structure[0] * (wrench[0] - t126) + structure[4] * (wrench[1] -
            t127);
        const real_t t129 = structure[0] * structure[0] + structure[4] * structure[4];
        const real_t t130 = tb_min(tb_max(t128 * (TB_C(1.0) / t129), TB_C(3.0)), TB_C(10.0));
        const real_t t131 = t126 + structure[0] * t130;
        const real_t t132 = t131 - wrench[0];
        const real_t t133 = t127 + structure[4] * t130;
        const real_t t134 = t133 - wrench[1];
        const real_t t135 = facet_0 < t5 ? t132 * t132 + t134 * t134 : TB_C(1e+30);
        const bool t136 = t135 < TB_C(1e+30);
        const real_t t137 = t136 ? t135 : TB_C(1e+30);
        const bool t138 = t117 < t137;
        const real_t t139 = t138 ? t117 : t137;
        const bool t140 = t95 < t139;
        real_t t141, t142, t143;
        if (t140) {
            t141 = t95;
            t142 = t91;
            t143 = t93;
        } else {
            t141 = t139;
            t142 = t138 ? t113 : (t136 ? t131 : TB_C(0.0));
            t143 = t138 ? t115 : (t136 ? t133 : TB_C(0.0));
        }
        const bool t144 = t69 < t141;
        served_0 = t144 ? t65 : t142;
        served_1 = t144 ? t67 : t143;
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
    const real_t t25 = TB_ABS(t3);
    const real_t t26 = TB_ABS(t12);
    const real_t t27 = TB_C(1.0) / tb_min(t25, t26);
    const real_t t28 = TB_C(8.0) * TB_EPSILON * t24 * t27;
    const real_t start_2 = t20 - structure[2] * t22;
    const real_t t29 = TB_C(3.0) - start_2;
    const real_t t30 = t29 - t28;
    const real_t start_1 = t19 - structure[1] * t22;
    const real_t t31 = TB_C(3.0) - start_1;
    const real_t t32 = t31 - t28;
    const real_t t33 = t9 * t16;
    const real_t t34 = TB_C(1.0) - t9 * t33;
    const real_t t35 = t13 * t33;
    const real_t t36 = t10 * t33;
    const real_t t37 = structure[2] * t34 - structure[1] * t35 - structure[3] * t36;
    const real_t t38 = t6 * t37;
    const real_t t39 = t4 * t38;
    const real_t t40 = t35 + structure[1] * t38;
    const real_t t41 = t10 * t16;
    const real_t t42 = TB_C(1.0) - t10 * t41;
    const real_t t43 = t13 * t41;
    const real_t t44 = t9 * t41;
    const real_t t45 = structure[3] * t42 - (structure[1] * t43 + structure[2] * t44);
    const real_t t46 = t6 * t45;
    const real_t t47 = t4 * t46;
    const real_t t48 = t43 + structure[1] * t46;
    const real_t t49 = t39 * t40 + t47 * t48;
    const real_t t50 = t14 + t4 * t22;
    const real_t t51 = TB_C(3.0) + t50;
    const real_t t52 = t50 + TB_C(1000000000000.0);
    const real_t t53 = tb_min(tb_max(TB_C(0.0), t51), t52);
    const real_t t54 = t53 / tb_max(t39 * t39 + t47 * t47, TB_C(1e-30));
    const real_t t55 = t49 * t54;
    const real_t t56 = TB_C(1000000000000.0) - start_1;
    const real_t t57 = t28 + t56;
    const real_t t58 = tb_max(t32 - t55, t55 - t57);
    const bool t59 = TB_C(0.0) < t58;
    const real_t t60 = t44 + structure[2] * t46;
    const real_t t61 = t34 - structure[2] * t38;
    const real_t t62 = t48 * t60 - t40 * t61;
    const real_t t63 = t40 * t60 + t48 * t61;
    const real_t t64 = TB_EPSILON * TB_C(16.0);
    const real_t t65 = t51 - t28;
    const real_t t66 = t28 + t52;
    const real_t t67 = t47 * t60 - t39 * t61;
    const real_t t68 = t36 + structure[3] * t38;
    const real_t t69 = t42 - structure[3] * t46;
    const real_t t70 = t40 * t68 - t48 * t69;
    const real_t t71 = t40 * t69 + t48 * t68;
    const real_t t72 = t39 * t68 - t47 * t69;
    const real_t t73 = t28 * TB_C(2.0);
    const real_t t74 = t28 * TB_C(1024.0);
    real_t t75, t76, t77, t78, t79;
    if (t59) {
        const real_t t80 = tb_min(tb_max(t55, t31), t56);
        const real_t t81 = TB_C(1.0) / tb_max(t40 * t40 + t48 * t48, TB_C(1e-30));
        const real_t t82 = t80 * t81;
        const real_t t83 = t40 * t47 - t39 * t48;
        const bool t84 = TB_ABS(t83) <= t64;
        const real_t t85 = t49 * t82;
        const real_t t86 = TB_C(1.0) / t83;
        real_t t87, t88, t89;
        if (t84) {
            t87 = -TB_C(1000000000000.0);
            t88 = TB_C(1000000000000.0);
            t89 = TB_C(0.0);
        } else {
            const real_t t90 = (t65 - t85) * t86;
            const real_t t91 = t86 * (t66 - t85);
            t87 = tb_min(t90, t91);
            t88 = tb_max(t90, t91);
            t89 = t73 * TB_ABS(t86);
        }
        const real_t t92 = tb_min(tb_max(TB_C(0.0), t87), t88);
        const real_t t93 = TB_C(0.0) < TB_ABS(t92) ? t92 * (t49 * t86) : TB_C(0.0);
        const real_t t94 = t55 < t80 ? t93 - t82 : t82 - t93;
        const real_t t95 = t87 + t89 < t88 - t89 && t74 < t58 ? t94 : TB_C(0.0);
        t75 = t62 * t82 + t63 * t92;
        t76 = t82 * t70 - t92 * t71;
        t77 = TB_C(0.0) < t94 ? t95 : TB_C(0.0);
        t78 = t85 + t83 * t92;
        t79 = t80;
    } else {
        t75 = t54 * t67;
        t76 = t54 * t72;
        t77 = TB_C(0.0);
        t78 = t53;
        t79 = t55;
    }
    const real_t t96 = TB_C(1000000000000.0) - start_2;
    const real_t t97 = t28 + t96;
    const real_t t98 = tb_max(t30 - t75, t75 - t97);
    const bool t99 = TB_C(0.0) < t98;
    const real_t t100 = t61 * t69;
    const real_t t101 = t60 * t68;
    const real_t t102 = t61 * t68 + t60 * t69;
    real_t t103, t104, t105, t106, t107;
    if (t99) {
        const bool t108 = TB_ABS(t63) <= t64;
        const real_t t109 = tb_min(tb_max(t75, t29), t96);
        const real_t t110 = TB_C(1.0) / tb_max(t61 * t61 + t60 * t60, TB_C(1e-30));
        const real_t t111 = t109 * t110;
        const real_t t112 = t62 * t111;
        const real_t t113 = TB_C(1.0) / t63;
        real_t t114, t115, t116;
        if (t108) {
            t114 = -TB_C(1000000000000.0);
            t115 = TB_C(1000000000000.0);
            t116 = TB_C(0.0);
        } else {
            const real_t t117 = -((t32 - t112) * t113);
            const real_t t118 = -(t113 * (t57 - t112));
            t114 = tb_min(t117, t118);
            t115 = tb_max(t117, t118);
            t116 = t73 * TB_ABS(TB_C(1.0) / -t63);
        }
        const real_t t119 = t47 * t61 + t39 * t60;
        const bool t120 = TB_ABS(t119) <= t64;
        const real_t t121 = t67 * t111;
        const real_t t122 = TB_C(1.0) / t119;
        real_t t123, t124, t125;
        if (t120) {
            t123 = -TB_C(1000000000000.0);
            t124 = TB_C(1000000000000.0);
            t125 = TB_C(0.0);
        } else {
            const real_t t126 = -((t65 - t121) * t122);
            const real_t t127 = -(t122 * (t66 - t121));
            t123 = tb_min(t126, t127);
            t124 = tb_max(t126, t127);
            t125 = t73 * TB_ABS(TB_C(1.0) / -t119);
        }
        const real_t t128 = tb_min(tb_max(TB_C(0.0), tb_max(t114, t123)), tb_min(t115, t124));
        real_t t129;
        if (TB_C(0.0) < TB_ABS(t128)) {
            const real_t t130 = -(t62 * t113);
            const real_t t131 = -(t67 * t122);
            const real_t t132 = TB_C(0.0) < t128 ? (t123 < t114 ? t130 : t131) : (t115 < t124 ?
                t130 : t131);
            t129 = t128 * t132;
        } else {
            t129 = TB_C(0.0);
        }
        const real_t t133 = t75 < t109 ? t129 - t111 : t111 - t129;
        real_t t134;
        if (TB_C(0.0) < t133) {
            const bool t135 = tb_max(t123 + t125, t114 + t116) < tb_min(t124 - t125, t115 -
                t116);
            t134 = t135 && t74 < t98 ? t133 : TB_C(0.0);
        } else {
            t134 = TB_C(0.0);
        }
        t103 = (t100 - t101) * t128 - t111 * t102;
        t104 = t134;
        t105 = t121 - t119 * t128;
        t106 = t112 - t63 * t128;
        t107 = t109;
    } else {
        t103 = t76;
        t104 = t77;
        t105 = t78;
        t106 = t79;
        t107 = t75;
    }
    const real_t t136 = TB_C(1000000000000.0) - start_3;
    const real_t t137 = tb_max(t23 - t28 - t103, t103 - (t28 + t136));
    const bool t138 = TB_C(0.0) < t137;
    real_t t139, t140, t141, t142, t143;
    if (t138) {
        const real_t t144 = tb_min(tb_max(t103, t23), t136);
        const real_t t145 = TB_C(1.0) / tb_max(t68 * t68 + t69 * t69, TB_C(1e-30));
        const real_t t146 = t144 * t145;
        const real_t t147 = t101 - t100;
        const bool t148 = TB_ABS(t147) <= t64;
        const real_t t149 = t102 * t146;
        const real_t t150 = TB_C(1.0) / t147;
        real_t t151, t152, t153;
        if (t148) {
            t151 = -TB_C(1000000000000.0);
            t152 = TB_C(1000000000000.0);
            t153 = TB_C(0.0);
        } else {
            const real_t t154 = (t30 + t149) * t150;
            const real_t t155 = t150 * (t97 + t149);
            t151 = tb_min(t154, t155);
            t152 = tb_max(t154, t155);
            t153 = t73 * TB_ABS(t150);
        }
        const bool t156 = TB_ABS(t71) <= t64;
        const real_t t157 = t70 * t146;
        const real_t t158 = TB_C(1.0) / t71;
        real_t t159, t160, t161;
        if (t156) {
            t159 = -TB_C(1000000000000.0);
            t160 = TB_C(1000000000000.0);
            t161 = TB_C(0.0);
        } else {
            const real_t t162 = (t32 - t157) * t158;
            const real_t t163 = t158 * (t57 - t157);
            t159 = tb_min(t162, t163);
            t160 = tb_max(t162, t163);
            t161 = t73 * TB_ABS(t158);
        }
        const real_t t164 = t47 * t68 + t39 * t69;
        const bool t165 = TB_ABS(t164) <= t64;
        const real_t t166 = t72 * t146;
        const real_t t167 = TB_C(1.0) / t164;
        real_t t168, t169, t170;
        if (t165) {
            t168 = -TB_C(1000000000000.0);
            t169 = TB_C(1000000000000.0);
            t170 = TB_C(0.0);
        } else {
            const real_t t171 = (t65 - t166) * t167;
            const real_t t172 = t167 * (t66 - t166);
            t168 = tb_min(t171, t172);
            t169 = tb_max(t171, t172);
            t170 = t73 * TB_ABS(t167);
        }
        const real_t t173 = tb_max(t159, t168);
        const real_t t174 = tb_min(t160, t169);
        const real_t t175 = tb_min(tb_max(TB_C(0.0), tb_max(t151, t173)), tb_min(t152, t174));
        real_t t176;
        if (TB_C(0.0) < TB_ABS(t175)) {
            const real_t t177 = -(t102 * t150);
            const real_t t178 = t70 * t158;
            const real_t t179 = t72 * t167;
            real_t t180;
            if (TB_C(0.0) < t175) {
                t180 = t173 < t151 ? t177 : (t168 < t159 ? t178 : t179);
            } else {
                t180 = t152 < t174 ? t177 : (t160 < t169 ? t178 : t179);
            }
            t176 = t175 * t180;
        } else {
            t176 = TB_C(0.0);
        }
        const real_t t181 = t103 < t144 ? t176 - t146 : t146 - t176;
        real_t t182;
        if (TB_C(0.0) < t181) {
            const real_t t183 = tb_max(tb_max(t168 + t170, t159 + t161), t151 + t153);
            const real_t t184 = tb_min(tb_min(t169 - t170, t160 - t161), t152 - t153);
            t182 = t183 < t184 && t74 < t137 ? t181 : TB_C(0.0);
        } else {
            t182 = TB_C(0.0);
        }
        t139 = t182;
        t140 = t166 + t164 * t175;
        t141 = t157 + t71 * t175;
        t142 = t147 * t175 - t149;
        t143 = t144;
    } else {
        t139 = t104;
        t140 = t105;
        t141 = t106;
        t142 = t107;
        t143 = t103;
    }
    const real_t t185 = tb_min(tb_max(t140 - t50, TB_C(3.0)), TB_C(1000000000000.0));
    const real_t t186 = tb_min(tb_max(start_1 + t141, TB_C(3.0)), TB_C(1000000000000.0));
    const real_t t187 = tb_min(tb_max(start_2 + t142, TB_C(3.0)), TB_C(1000000000000.0));
    const real_t t188 = structure[0] * t185 + structure[1] * t186 + structure[2] * t187;
    const real_t t189 = tb_min(tb_max(start_3 + t143, TB_C(3.0)), TB_C(1000000000000.0));
    const real_t t190 = tb_max(t139, TB_ABS(t188 + structure[3] * t189 - wrench[0]));
    const real_t t191 = structure[4] * t185 + structure[5] * t186 + structure[6] * t187;
    const real_t t192 = tb_max(t190, TB_ABS(t191 + structure[7] * t189 - wrench[1]));
    const real_t t193 = tb_min(tb_max(tb_max(tb_max(t185, t186), t187), t189), TB_C(1000.0));
    const bool t194 = t192 <= t27 * (TB_EPSILON * TB_C(128.0) * t193);
    real_t tension_0, tension_1, tension_2, tension_3, kkt_residual_0;
    if (t194) {
        tension_0 = tb_min(t185, TB_C(10.0));
        tension_1 = tb_min(t186, TB_C(10.0));
        tension_2 = tb_min(t187, TB_C(10.0));
        tension_3 = tb_min(t189, TB_C(10.0));
        kkt_residual_0 = t192;
    } else {
        tension_0 = TB_C(3.0);
        tension_1 = TB_C(3.0);
        tension_2 = TB_C(3.0);
        tension_3 = TB_C(3.0);
        kkt_residual_0 = TB_C(0.0);
    }
    const bool t195 = !t194;
    const real_t t196 = structure[0] * tension_0 + structure[1] * tension_1;
    /* what the tensions exert, S T */
    const real_t delivered_0 = t196 + structure[2] * tension_2 + structure[3] * tension_3;
    const real_t t197 = structure[4] * tension_0 + structure[5] * tension_1;
    const real_t delivered_1 = t197 + structure[6] * tension_2 + structure[7] * tension_3;
    const real_t t198 = TB_EPSILON * TB_C(4096.0);
    const bool t199 = !(t198 < t25 && t198 < t26);
    const bool t200 = TB_C(10.0) < t185 || TB_C(10.0) < t186 || TB_C(10.0) < t187;
    const bool t201 = t200 || TB_C(10.0) < t189;
    if (t199) {
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
    return (t195 || t201) ? TB_INFEASIBLE : TB_OK;
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

