/* Regenerate: turnbuckle generate machines/yoon2023.toml --out generated/yoon2023
 * Machine 596562f46df7de34, generator 0.1.0, casadi 3.8.2. Do not edit. */
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
    const real_t t19 = TB_C(80.0) * TB_EPSILON * t18;
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
    const real_t t32 = t31 * (TB_C(1.0) / (t14 + (t8 + t10)));
    const real_t t33 = t26 * t32;
    const real_t t34 = TB_C(10.0) - start_1;
    const real_t t35 = t19 + t34;
    const real_t t36 = tb_max(t25 + t33, -(t33 + t35));
    const bool t37 = TB_C(0.0) < t36;
    const real_t t38 = TB_EPSILON * TB_C(16.0);
    const real_t t39 = t29 - t19;
    const real_t t40 = -t33;
    const real_t t41 = t19 + t30;
    const real_t t42 = cross_01 * cross_02 + cross_13 * cross_23;
    const real_t t43 = cross_03 * cross_23 - cross_01 * cross_12;
    const real_t t44 = cross_03 * cross_01 - cross_23 * cross_12;
    const real_t t45 = cross_13 * cross_01 + cross_23 * cross_02;
    const real_t t46 = TB_C(2.0) * t19;
    const real_t t47 = t19 * TB_C(1024.0);
    real_t t48, t49, t50, t51, t52;
    if (t37) {
        const bool t53 = TB_ABS(cross_23) <= t38;
        const real_t t54 = tb_min(tb_max(t40, t24), t34);
        const real_t t55 = t54 * (TB_C(1.0) / (t9 + (t8 + t11)));
        const real_t t56 = t26 * t55;
        const real_t t57 = TB_C(1.0) / cross_23;
        real_t t58, t59, t60;
        if (t53) {
            t58 = -TB_C(1000000000000.0);
            t59 = TB_C(1000000000000.0);
            t60 = TB_C(0.0);
        } else {
            const real_t t61 = -((t39 + t56) * t57);
            const real_t t62 = -(t57 * (t56 + t41));
            t58 = tb_min(t61, t62);
            t59 = tb_max(t61, t62);
            t60 = t46 * TB_ABS(TB_C(1.0) / (t3 - t2));
        }
        const real_t t63 = tb_min(tb_max(TB_C(0.0), t58), t59);
        const real_t t64 = determinant * t55;
        const real_t t65 = TB_C(0.0) < TB_ABS(t63) ? t63 * (t26 * t57) : TB_C(0.0);
        const real_t t66 = t40 < t54 ? t65 - t64 : t64 - t65;
        const real_t t67 = t58 + t60 < t59 - t60 && t47 < t36 ? t66 : TB_C(0.0);
        t48 = cross_03 * t63 - t55 * t42;
        t49 = -(t55 * t44 + cross_02 * t63);
        t50 = -(t56 + cross_23 * t63);
        t51 = t54;
        t52 = TB_C(0.0) < t66 ? t67 : TB_C(0.0);
    } else {
        t48 = -(t32 * t43);
        t49 = t32 * t45;
        t50 = t31;
        t51 = t40;
        t52 = TB_C(0.0);
    }
    const real_t t68 = TB_C(10.0) - start_2;
    const real_t t69 = t19 + t68;
    const real_t t70 = tb_max(t22 - t48, t48 - t69);
    const bool t71 = TB_C(0.0) < t70;
    const real_t t72 = cross_03 * cross_02 + cross_13 * cross_12;
    real_t t73, t74, t75, t76, t77;
    if (t71) {
        const bool t78 = TB_ABS(cross_03) <= t38;
        const real_t t79 = tb_min(tb_max(t48, t21), t68);
        const real_t t80 = t79 * (TB_C(1.0) / (t7 + (t10 + t11)));
        const real_t t81 = t42 * t80;
        const real_t t82 = TB_C(1.0) / cross_03;
        real_t t83, t84, t85;
        if (t78) {
            t83 = -TB_C(1000000000000.0);
            t84 = TB_C(1000000000000.0);
            t85 = TB_C(0.0);
        } else {
            const real_t t86 = -((t25 + t81) * t82);
            const real_t t87 = -(t82 * (t35 + t81));
            t83 = tb_min(t86, t87);
            t84 = tb_max(t86, t87);
            t85 = t46 * TB_ABS(TB_C(1.0) / (t1 - t0));
        }
        const bool t88 = TB_ABS(cross_13) <= t38;
        const real_t t89 = t43 * t80;
        const real_t t90 = TB_C(1.0) / cross_13;
        real_t t91, t92, t93;
        if (t88) {
            t91 = -TB_C(1000000000000.0);
            t92 = TB_C(1000000000000.0);
            t93 = TB_C(0.0);
        } else {
            const real_t t94 = (t39 + t89) * t90;
            const real_t t95 = t90 * (t41 + t89);
            t91 = tb_min(t94, t95);
            t92 = tb_max(t94, t95);
            t93 = t46 * TB_ABS(t90);
        }
        const real_t t96 = tb_min(tb_max(TB_C(0.0), tb_max(t83, t91)), tb_min(t84, t92));
        const real_t t97 = determinant * t80;
        real_t t98;
        if (TB_C(0.0) < TB_ABS(t96)) {
            const real_t t99 = t42 * t82;
            const real_t t100 = -(t43 * t90);
            const real_t t101 = TB_C(0.0) < t96 ? (t91 < t83 ? t99 : t100) : (t84 < t92 ? t99 :
                t100);
            t98 = t96 * t101;
        } else {
            t98 = TB_C(0.0);
        }
        const real_t t102 = t48 < t79 ? t98 - t97 : t97 - t98;
        real_t t103;
        if (TB_C(0.0) < t102) {
            const bool t104 = tb_max(t91 + t93, t83 + t85) < tb_min(t92 - t93, t84 - t85);
            t103 = t104 && t47 < t70 ? t102 : TB_C(0.0);
        } else {
            t103 = TB_C(0.0);
        }
        t73 = cross_01 * t96 - t80 * t72;
        t74 = cross_13 * t96 - t89;
        t75 = -(t81 + cross_03 * t96);
        t76 = t79;
        t77 = t103;
    } else {
        t73 = t49;
        t74 = t50;
        t75 = t51;
        t76 = t48;
        t77 = t52;
    }
    const real_t t105 = TB_C(10.0) - start_3;
    const real_t t106 = tb_max(t16 - t19 - t73, t73 - (t19 + t105));
    const bool t107 = TB_C(0.0) < t106;
    real_t t108, t109, t110, t111, t112;
    if (t107) {
        const real_t t113 = tb_min(tb_max(t73, t16), t105);
        const real_t t114 = t113 * (TB_C(1.0) / (t7 + (t9 + t14)));
        const real_t t115 = t45 * t114;
        const bool t116 = TB_ABS(cross_01) <= t38;
        const real_t t117 = t72 * t114;
        const real_t t118 = TB_C(1.0) / cross_01;
        real_t t119, t120, t121;
        if (t116) {
            t119 = -TB_C(1000000000000.0);
            t120 = TB_C(1000000000000.0);
            t121 = TB_C(0.0);
        } else {
            const real_t t122 = -((t22 + t117) * t118);
            const real_t t123 = -(t118 * (t69 + t117));
            t119 = tb_min(t122, t123);
            t120 = tb_max(t122, t123);
            t121 = t46 * TB_ABS(TB_C(1.0) / (t6 - t5));
        }
        const bool t124 = TB_ABS(cross_02) <= t38;
        const real_t t125 = t44 * t114;
        const real_t t126 = TB_C(1.0) / cross_02;
        real_t t127, t128, t129;
        if (t124) {
            t127 = -TB_C(1000000000000.0);
            t128 = TB_C(1000000000000.0);
            t129 = TB_C(0.0);
        } else {
            const real_t t130 = (t25 + t125) * t126;
            const real_t t131 = t126 * (t35 + t125);
            t127 = tb_min(t130, t131);
            t128 = tb_max(t130, t131);
            t129 = t46 * TB_ABS(t126);
        }
        const bool t132 = TB_ABS(cross_12) <= t38;
        const real_t t133 = TB_C(1.0) / cross_12;
        real_t t134, t135, t136;
        if (t132) {
            t134 = -TB_C(1000000000000.0);
            t135 = TB_C(1000000000000.0);
            t136 = TB_C(0.0);
        } else {
            const real_t t137 = -((t39 - t115) * t133);
            const real_t t138 = -(t133 * (t41 - t115));
            t134 = tb_min(t137, t138);
            t135 = tb_max(t137, t138);
            t136 = t46 * TB_ABS(TB_C(1.0) / (t13 - t12));
        }
        const real_t t139 = tb_max(t127, t134);
        const real_t t140 = tb_min(t128, t135);
        const real_t t141 = tb_min(tb_max(TB_C(0.0), tb_max(t119, t139)), tb_min(t120, t140));
        const real_t t142 = determinant * t114;
        real_t t143;
        if (TB_C(0.0) < TB_ABS(t141)) {
            const real_t t144 = t72 * t118;
            const real_t t145 = -(t44 * t126);
            const real_t t146 = -(t45 * t133);
            real_t t147;
            if (TB_C(0.0) < t141) {
                t147 = t139 < t119 ? t144 : (t134 < t127 ? t145 : t146);
            } else {
                t147 = t120 < t140 ? t144 : (t128 < t135 ? t145 : t146);
            }
            t143 = t141 * t147;
        } else {
            t143 = TB_C(0.0);
        }
        const real_t t148 = t73 < t113 ? t143 - t142 : t142 - t143;
        real_t t149;
        if (TB_C(0.0) < t148) {
            const real_t t150 = tb_max(tb_max(t134 + t136, t127 + t129), t119 + t121);
            const real_t t151 = tb_min(tb_min(t135 - t136, t128 - t129), t120 - t121);
            t149 = t150 < t151 && t47 < t106 ? t148 : TB_C(0.0);
        } else {
            t149 = TB_C(0.0);
        }
        t108 = t115 - cross_12 * t141;
        t109 = cross_02 * t141 - t125;
        t110 = -(t117 + cross_01 * t141);
        t111 = t113;
        t112 = t149;
    } else {
        t108 = t74;
        t109 = t75;
        t110 = t76;
        t111 = t73;
        t112 = t77;
    }
    const real_t tension_0 = tb_min(tb_max(t108 - t28, TB_C(3.0)), TB_C(10.0));
    const real_t tension_1 = tb_min(tb_max(start_1 + t109, TB_C(3.0)), TB_C(10.0));
    const real_t tension_2 = tb_min(tb_max(start_2 + t110, TB_C(3.0)), TB_C(10.0));
    const real_t tension_3 = tb_min(tb_max(start_3 + t111, TB_C(3.0)), TB_C(10.0));
    const real_t t152 = structure[0] * tension_0 + structure[1] * tension_1;
    /* what the tensions exert, S T */
    const real_t delivered_0 = t152 + structure[2] * tension_2 + structure[3] * tension_3;
    const real_t t153 = structure[4] * tension_0 + structure[5] * tension_1;
    const real_t delivered_1 = t153 + structure[6] * tension_2 + structure[7] * tension_3;
    const real_t kkt_residual_0 = tb_max(tb_max(t112, TB_ABS(delivered_0 - wrench[0])),
        TB_ABS(delivered_1 - wrench[1]));
    const bool t154 = !(TB_EPSILON * TB_C(4096.0) < t17);
    const bool t155 = kkt_residual_0 <= t18 * (TB_EPSILON * TB_C(1280.0));
    const bool t156 = !t155;
    if (t154) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    if (t156) {
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
    const real_t t56 = tb_max(t30 - t53, t53 - t55);
    const bool t57 = TB_C(0.0) < t56;
    const real_t t58 = t42 + structure[2] * t44;
    const real_t t59 = t32 - structure[2] * t36;
    const real_t t60 = t46 * t58 - t38 * t59;
    const real_t t61 = t38 * t58 + t46 * t59;
    const real_t t62 = TB_EPSILON * TB_C(16.0);
    const real_t t63 = t49 - t26;
    const real_t t64 = t26 + t50;
    const real_t t65 = t45 * t58 - t37 * t59;
    const real_t t66 = t34 + structure[3] * t36;
    const real_t t67 = t40 - structure[3] * t44;
    const real_t t68 = t38 * t66 - t46 * t67;
    const real_t t69 = t38 * t67 + t46 * t66;
    const real_t t70 = t37 * t66 - t45 * t67;
    const real_t t71 = t26 * TB_C(2.0);
    const real_t t72 = t26 * TB_C(1024.0);
    real_t t73, t74, t75, t76, t77;
    if (t57) {
        const real_t t78 = tb_min(tb_max(t53, t29), t54);
        const real_t t79 = t78 * (TB_C(1.0) / (t38 * t38 + t46 * t46));
        const real_t t80 = t38 * t45 - t37 * t46;
        const bool t81 = TB_ABS(t80) <= t62;
        const real_t t82 = t47 * t79;
        const real_t t83 = TB_C(1.0) / t80;
        real_t t84, t85, t86;
        if (t81) {
            t84 = -TB_C(1000000000000.0);
            t85 = TB_C(1000000000000.0);
            t86 = TB_C(0.0);
        } else {
            const real_t t87 = (t63 - t82) * t83;
            const real_t t88 = t83 * (t64 - t82);
            t84 = tb_min(t87, t88);
            t85 = tb_max(t87, t88);
            t86 = t71 * TB_ABS(t83);
        }
        const real_t t89 = tb_min(tb_max(TB_C(0.0), t84), t85);
        const real_t t90 = TB_C(0.0) < TB_ABS(t89) ? t89 * (t47 * t83) : TB_C(0.0);
        const real_t t91 = t53 < t78 ? t90 - t79 : t79 - t90;
        const real_t t92 = t84 + t86 < t85 - t86 && t72 < t56 ? t91 : TB_C(0.0);
        t73 = t60 * t79 + t61 * t89;
        t74 = t79 * t68 - t89 * t69;
        t75 = t82 + t80 * t89;
        t76 = t78;
        t77 = TB_C(0.0) < t91 ? t92 : TB_C(0.0);
    } else {
        t73 = t52 * t65;
        t74 = t52 * t70;
        t75 = t51;
        t76 = t53;
        t77 = TB_C(0.0);
    }
    const real_t t93 = TB_C(10.0) - start_2;
    const real_t t94 = t26 + t93;
    const real_t t95 = tb_max(t28 - t73, t73 - t94);
    const bool t96 = TB_C(0.0) < t95;
    const real_t t97 = t59 * t67;
    const real_t t98 = t58 * t66;
    const real_t t99 = t59 * t66 + t58 * t67;
    real_t t100, t101, t102, t103, t104;
    if (t96) {
        const bool t105 = TB_ABS(t61) <= t62;
        const real_t t106 = tb_min(tb_max(t73, t27), t93);
        const real_t t107 = t106 * (TB_C(1.0) / (t59 * t59 + t58 * t58));
        const real_t t108 = t60 * t107;
        const real_t t109 = TB_C(1.0) / t61;
        real_t t110, t111, t112;
        if (t105) {
            t110 = -TB_C(1000000000000.0);
            t111 = TB_C(1000000000000.0);
            t112 = TB_C(0.0);
        } else {
            const real_t t113 = -((t30 - t108) * t109);
            const real_t t114 = -(t109 * (t55 - t108));
            t110 = tb_min(t113, t114);
            t111 = tb_max(t113, t114);
            t112 = t71 * TB_ABS(TB_C(1.0) / -t61);
        }
        const real_t t115 = t45 * t59 + t37 * t58;
        const bool t116 = TB_ABS(t115) <= t62;
        const real_t t117 = t65 * t107;
        const real_t t118 = TB_C(1.0) / t115;
        real_t t119, t120, t121;
        if (t116) {
            t119 = -TB_C(1000000000000.0);
            t120 = TB_C(1000000000000.0);
            t121 = TB_C(0.0);
        } else {
            const real_t t122 = -((t63 - t117) * t118);
            const real_t t123 = -(t118 * (t64 - t117));
            t119 = tb_min(t122, t123);
            t120 = tb_max(t122, t123);
            t121 = t71 * TB_ABS(TB_C(1.0) / -t115);
        }
        const real_t t124 = tb_min(tb_max(TB_C(0.0), tb_max(t110, t119)), tb_min(t111, t120));
        real_t t125;
        if (TB_C(0.0) < TB_ABS(t124)) {
            const real_t t126 = -(t60 * t109);
            const real_t t127 = -(t65 * t118);
            const real_t t128 = TB_C(0.0) < t124 ? (t119 < t110 ? t126 : t127) : (t111 < t120 ?
                t126 : t127);
            t125 = t124 * t128;
        } else {
            t125 = TB_C(0.0);
        }
        const real_t t129 = t73 < t106 ? t125 - t107 : t107 - t125;
        real_t t130;
        if (TB_C(0.0) < t129) {
            const bool t131 = tb_max(t119 + t121, t110 + t112) < tb_min(t120 - t121, t111 -
                t112);
            t130 = t131 && t72 < t95 ? t129 : TB_C(0.0);
        } else {
            t130 = TB_C(0.0);
        }
        t100 = (t97 - t98) * t124 - t107 * t99;
        t101 = t117 - t115 * t124;
        t102 = t108 - t61 * t124;
        t103 = t106;
        t104 = t130;
    } else {
        t100 = t74;
        t101 = t75;
        t102 = t76;
        t103 = t73;
        t104 = t77;
    }
    const real_t t132 = TB_C(10.0) - start_3;
    const real_t t133 = tb_max(t23 - t26 - t100, t100 - (t26 + t132));
    const bool t134 = TB_C(0.0) < t133;
    real_t t135, t136, t137, t138, t139;
    if (t134) {
        const real_t t140 = tb_min(tb_max(t100, t23), t132);
        const real_t t141 = t140 * (TB_C(1.0) / (t66 * t66 + t67 * t67));
        const real_t t142 = t70 * t141;
        const real_t t143 = t45 * t66 + t37 * t67;
        const real_t t144 = t98 - t97;
        const bool t145 = TB_ABS(t144) <= t62;
        const real_t t146 = t99 * t141;
        const real_t t147 = TB_C(1.0) / t144;
        real_t t148, t149, t150;
        if (t145) {
            t148 = -TB_C(1000000000000.0);
            t149 = TB_C(1000000000000.0);
            t150 = TB_C(0.0);
        } else {
            const real_t t151 = (t28 + t146) * t147;
            const real_t t152 = t147 * (t94 + t146);
            t148 = tb_min(t151, t152);
            t149 = tb_max(t151, t152);
            t150 = t71 * TB_ABS(t147);
        }
        const bool t153 = TB_ABS(t69) <= t62;
        const real_t t154 = t68 * t141;
        const real_t t155 = TB_C(1.0) / t69;
        real_t t156, t157, t158;
        if (t153) {
            t156 = -TB_C(1000000000000.0);
            t157 = TB_C(1000000000000.0);
            t158 = TB_C(0.0);
        } else {
            const real_t t159 = (t30 - t154) * t155;
            const real_t t160 = t155 * (t55 - t154);
            t156 = tb_min(t159, t160);
            t157 = tb_max(t159, t160);
            t158 = t71 * TB_ABS(t155);
        }
        const bool t161 = TB_ABS(t143) <= t62;
        const real_t t162 = TB_C(1.0) / t143;
        real_t t163, t164, t165;
        if (t161) {
            t163 = -TB_C(1000000000000.0);
            t164 = TB_C(1000000000000.0);
            t165 = TB_C(0.0);
        } else {
            const real_t t166 = (t63 - t142) * t162;
            const real_t t167 = t162 * (t64 - t142);
            t163 = tb_min(t166, t167);
            t164 = tb_max(t166, t167);
            t165 = t71 * TB_ABS(t162);
        }
        const real_t t168 = tb_max(t156, t163);
        const real_t t169 = tb_min(t157, t164);
        const real_t t170 = tb_min(tb_max(TB_C(0.0), tb_max(t148, t168)), tb_min(t149, t169));
        real_t t171;
        if (TB_C(0.0) < TB_ABS(t170)) {
            const real_t t172 = -(t99 * t147);
            const real_t t173 = t68 * t155;
            const real_t t174 = t70 * t162;
            real_t t175;
            if (TB_C(0.0) < t170) {
                t175 = t168 < t148 ? t172 : (t163 < t156 ? t173 : t174);
            } else {
                t175 = t149 < t169 ? t172 : (t157 < t164 ? t173 : t174);
            }
            t171 = t170 * t175;
        } else {
            t171 = TB_C(0.0);
        }
        const real_t t176 = t100 < t140 ? t171 - t141 : t141 - t171;
        real_t t177;
        if (TB_C(0.0) < t176) {
            const real_t t178 = tb_max(tb_max(t163 + t165, t156 + t158), t148 + t150);
            const real_t t179 = tb_min(tb_min(t164 - t165, t157 - t158), t149 - t150);
            t177 = t178 < t179 && t72 < t133 ? t176 : TB_C(0.0);
        } else {
            t177 = TB_C(0.0);
        }
        t135 = t142 + t143 * t170;
        t136 = t154 + t69 * t170;
        t137 = t144 * t170 - t146;
        t138 = t140;
        t139 = t177;
    } else {
        t135 = t101;
        t136 = t102;
        t137 = t103;
        t138 = t100;
        t139 = t104;
    }
    const real_t tension_0 = tb_min(tb_max(t135 - t48, TB_C(3.0)), TB_C(10.0));
    const real_t tension_1 = tb_min(tb_max(start_1 + t136, TB_C(3.0)), TB_C(10.0));
    const real_t tension_2 = tb_min(tb_max(start_2 + t137, TB_C(3.0)), TB_C(10.0));
    const real_t tension_3 = tb_min(tb_max(start_3 + t138, TB_C(3.0)), TB_C(10.0));
    const real_t t180 = structure[0] * tension_0 + structure[1] * tension_1;
    /* what the tensions exert, S T */
    const real_t delivered_0 = t180 + structure[2] * tension_2 + structure[3] * tension_3;
    const real_t t181 = structure[4] * tension_0 + structure[5] * tension_1;
    const real_t delivered_1 = t181 + structure[6] * tension_2 + structure[7] * tension_3;
    const real_t kkt_residual_0 = tb_max(tb_max(t139, TB_ABS(delivered_0 - wrench[0])),
        TB_ABS(delivered_1 - wrench[1]));
    const bool t182 = !(TB_EPSILON * TB_C(4096.0) < t24);
    const bool t183 = kkt_residual_0 <= t25 * (TB_EPSILON * TB_C(1280.0));
    const bool t184 = !t183;
    if (t182) {
        tension[0] = TB_C(3.0);
        tension[1] = TB_C(3.0);
        tension[2] = TB_C(3.0);
        tension[3] = TB_C(3.0);
        delivered[0] = TB_C(0.0);
        delivered[1] = TB_C(0.0);
        kkt_residual[0] = TB_C(0.0);
        return TB_SINGULAR;
    }
    if (t184) {
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
            const bool t83 = TB_C(0.0) < t17 - t16;
            const bool t84 = !t82;
            const real_t t85 = (t82 && t83) || (t84 && !t83) ? TB_C(10.0) : TB_C(3.0);
            const bool t86 = TB_C(0.0) < t27 - t26;
            const real_t t87 = (t82 && t86) || (t84 && !t86) ? TB_C(10.0) : TB_C(3.0);
            const bool t88 = TB_C(0.0) < t33 - t32;
            const real_t t89 = (t82 && t88) || (t84 && !t88) ? TB_C(10.0) : TB_C(3.0);
            const real_t t90 = structure[0] * t85 + structure[1] * t87 + structure[2] * t89;
            const real_t t91 = structure[4] * t85 + structure[5] * t87 + structure[6] * t89;
            const real_t t92 = structure[3] * (wrench[0] - t90) + structure[7] * (wrench[1] -
                t91);
            const real_t t93 = structure[3] * structure[3] + structure[7] * structure[7];
            const real_t t94 = tb_min(tb_max(t92 * (TB_C(1.0) / t93), TB_C(3.0)), TB_C(10.0));
            const real_t t95 = t90 + structure[3] * t94;
            const real_t t96 = t95 - wrench[0];
            const real_t t97 = t91 + structure[7] * t94;
            const real_t t98 = t97 - wrench[1];
            const real_t t99 = facet_3 < t38 ? t96 * t96 + t98 * t98 : TB_C(1e+30);
            const bool t100 = TB_C(0.0) < t30;
            const bool t101 = TB_C(0.0) < t13 - t12;
            const bool t102 = !t100;
            const real_t t103 = (t100 && t101) || (t102 && !t101) ? TB_C(10.0) : TB_C(3.0);
            const bool t104 = TB_C(0.0) < t23 - t22;
            const real_t t105 = (t100 && t104) || (t102 && !t104) ? TB_C(10.0) : TB_C(3.0);
            const bool t106 = TB_C(0.0) <= t34;
            const real_t t107 = (t100 && t106) || (t102 && !t106) ? TB_C(10.0) : TB_C(3.0);
            const real_t t108 = structure[0] * t103 + structure[1] * t105 + structure[3] * t107;
            const real_t t109 = structure[4] * t103 + structure[5] * t105 + structure[7] * t107;
            const real_t t110 = structure[2] * (wrench[0] - t108) + structure[6] * (wrench[1] -
                t109);
            const real_t t111 = structure[2] * structure[2] + structure[6] * structure[6];
            const real_t t112 = tb_min(tb_max(t110 * (TB_C(1.0) / t111), TB_C(3.0)),
                TB_C(10.0));
            const real_t t113 = t108 + structure[2] * t112;
            const real_t t114 = t113 - wrench[0];
            const real_t t115 = t109 + structure[6] * t112;
            const real_t t116 = t115 - wrench[1];
            const real_t t117 = facet_2 < t31 ? t114 * t114 + t116 * t116 : TB_C(1e+30);
            const bool t118 = TB_C(0.0) < t20;
            const bool t119 = TB_C(0.0) < t9 - t8;
            const bool t120 = !t118;
            const real_t t121 = (t118 && t119) || (t120 && !t119) ? TB_C(10.0) : TB_C(3.0);
            const bool t122 = TB_C(0.0) <= t24;
            const real_t t123 = (t118 && t122) || (t120 && !t122) ? TB_C(10.0) : TB_C(3.0);
            const bool t124 = TB_C(0.0) <= t28;
            const real_t t125 = (t118 && t124) || (t120 && !t124) ? TB_C(10.0) : TB_C(3.0);
            const real_t t126 = structure[0] * t121 + structure[2] * t123 + structure[3] * t125;
            const real_t t127 = structure[4] * t121 + structure[6] * t123 + structure[7] * t125;
            const real_t t128 = structure[1] * (wrench[0] - t126) + structure[5] * (wrench[1] -
                t127);
            const real_t t129 = structure[1] * structure[1] + structure[5] * structure[5];
            const real_t t130 = tb_min(tb_max(t128 * (TB_C(1.0) / t129), TB_C(3.0)),
                TB_C(10.0));
            const real_t t131 = t126 + structure[1] * t130;
            const real_t t132 = t131 - wrench[0];
            const real_t t133 = t127 + structure[5] * t130;
            const real_t t134 = t133 - wrench[1];
            const real_t t135 = facet_1 < t21 ? t132 * t132 + t134 * t134 : TB_C(1e+30);
            const bool t136 = TB_C(0.0) < t6;
            const bool t137 = TB_C(0.0) <= t10;
            const bool t138 = !t136;
            const real_t t139 = (t136 && t137) || (t138 && !t137) ? TB_C(10.0) : TB_C(3.0);
            const bool t140 = TB_C(0.0) <= t14;
            const real_t t141 = (t136 && t140) || (t138 && !t140) ? TB_C(10.0) : TB_C(3.0);
            const bool t142 = TB_C(0.0) <= t18;
            const real_t t143 = (t136 && t142) || (t138 && !t142) ? TB_C(10.0) : TB_C(3.0);
            const real_t t144 = structure[1] * t139 + structure[2] * t141 + structure[3] * t143;
            const real_t t145 = structure[5] * t139 + structure[6] * t141 + structure[7] * t143;
            const real_t t146 = structure[0] * (wrench[0] - t144) + structure[4] * (wrench[1] -
                t145);
            const real_t t147 = structure[0] * structure[0] + structure[4] * structure[4];
            const real_t t148 = tb_min(tb_max(t146 * (TB_C(1.0) / t147), TB_C(3.0)),
                TB_C(10.0));
            const real_t t149 = t144 + structure[0] * t148;
            const real_t t150 = t149 - wrench[0];
            const real_t t151 = t145 + structure[4] * t148;
            const real_t t152 = t151 - wrench[1];
            const real_t t153 = facet_0 < t7 ? t150 * t150 + t152 * t152 : TB_C(1e+30);
            const bool t154 = t153 < TB_C(1e+30);
            const real_t t155 = t154 ? t153 : TB_C(1e+30);
            const bool t156 = t135 < t155;
            const real_t t157 = t156 ? t135 : t155;
            const bool t158 = t117 < t157;
            real_t t159, t160, t161;
            if (t158) {
                t159 = t117;
                t160 = t113;
                t161 = t115;
            } else {
                t159 = t157;
                t160 = t156 ? t131 : (t154 ? t149 : TB_C(0.0));
                t161 = t156 ? t133 : (t154 ? t151 : TB_C(0.0));
            }
            const bool t162 = t99 < t159;
            t80 = t162 ? t95 : t160;
            t81 = t162 ? t97 : t161;
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
        const real_t t80 = t79 * (TB_C(1.0) / (t39 * t39 + t47 * t47));
        const real_t t81 = t39 * t46 - t38 * t47;
        const bool t82 = TB_ABS(t81) <= t63;
        const real_t t83 = t48 * t80;
        const real_t t84 = TB_C(1.0) / t81;
        real_t t85, t86, t87;
        if (t82) {
            t85 = -TB_C(1000000000000.0);
            t86 = TB_C(1000000000000.0);
            t87 = TB_C(0.0);
        } else {
            const real_t t88 = (t64 - t83) * t84;
            const real_t t89 = t84 * (t65 - t83);
            t85 = tb_min(t88, t89);
            t86 = tb_max(t88, t89);
            t87 = t72 * TB_ABS(t84);
        }
        const real_t t90 = tb_min(tb_max(TB_C(0.0), t85), t86);
        const real_t t91 = TB_C(0.0) < TB_ABS(t90) ? t90 * (t48 * t84) : TB_C(0.0);
        const real_t t92 = t54 < t79 ? t91 - t80 : t80 - t91;
        const real_t t93 = t85 + t87 < t86 - t87 && t73 < t57 ? t92 : TB_C(0.0);
        t74 = t61 * t80 + t62 * t90;
        t75 = t80 * t69 - t90 * t70;
        t76 = TB_C(0.0) < t92 ? t93 : TB_C(0.0);
        t77 = t83 + t81 * t90;
        t78 = t79;
    } else {
        t74 = t53 * t66;
        t75 = t53 * t71;
        t76 = TB_C(0.0);
        t77 = t52;
        t78 = t54;
    }
    const real_t t94 = TB_C(1000000000000.0) - start_2;
    const real_t t95 = t27 + t94;
    const real_t t96 = tb_max(t29 - t74, t74 - t95);
    const bool t97 = TB_C(0.0) < t96;
    const real_t t98 = t60 * t68;
    const real_t t99 = t59 * t67;
    const real_t t100 = t60 * t67 + t59 * t68;
    real_t t101, t102, t103, t104, t105;
    if (t97) {
        const bool t106 = TB_ABS(t62) <= t63;
        const real_t t107 = tb_min(tb_max(t74, t28), t94);
        const real_t t108 = t107 * (TB_C(1.0) / (t60 * t60 + t59 * t59));
        const real_t t109 = t61 * t108;
        const real_t t110 = TB_C(1.0) / t62;
        real_t t111, t112, t113;
        if (t106) {
            t111 = -TB_C(1000000000000.0);
            t112 = TB_C(1000000000000.0);
            t113 = TB_C(0.0);
        } else {
            const real_t t114 = -((t31 - t109) * t110);
            const real_t t115 = -(t110 * (t56 - t109));
            t111 = tb_min(t114, t115);
            t112 = tb_max(t114, t115);
            t113 = t72 * TB_ABS(TB_C(1.0) / -t62);
        }
        const real_t t116 = t46 * t60 + t38 * t59;
        const bool t117 = TB_ABS(t116) <= t63;
        const real_t t118 = t66 * t108;
        const real_t t119 = TB_C(1.0) / t116;
        real_t t120, t121, t122;
        if (t117) {
            t120 = -TB_C(1000000000000.0);
            t121 = TB_C(1000000000000.0);
            t122 = TB_C(0.0);
        } else {
            const real_t t123 = -((t64 - t118) * t119);
            const real_t t124 = -(t119 * (t65 - t118));
            t120 = tb_min(t123, t124);
            t121 = tb_max(t123, t124);
            t122 = t72 * TB_ABS(TB_C(1.0) / -t116);
        }
        const real_t t125 = tb_min(tb_max(TB_C(0.0), tb_max(t111, t120)), tb_min(t112, t121));
        real_t t126;
        if (TB_C(0.0) < TB_ABS(t125)) {
            const real_t t127 = -(t61 * t110);
            const real_t t128 = -(t66 * t119);
            const real_t t129 = TB_C(0.0) < t125 ? (t120 < t111 ? t127 : t128) : (t112 < t121 ?
                t127 : t128);
            t126 = t125 * t129;
        } else {
            t126 = TB_C(0.0);
        }
        const real_t t130 = t74 < t107 ? t126 - t108 : t108 - t126;
        real_t t131;
        if (TB_C(0.0) < t130) {
            const bool t132 = tb_max(t120 + t122, t111 + t113) < tb_min(t121 - t122, t112 -
                t113);
            t131 = t132 && t73 < t96 ? t130 : TB_C(0.0);
        } else {
            t131 = TB_C(0.0);
        }
        t101 = (t98 - t99) * t125 - t108 * t100;
        t102 = t131;
        t103 = t118 - t116 * t125;
        t104 = t109 - t62 * t125;
        t105 = t107;
    } else {
        t101 = t75;
        t102 = t76;
        t103 = t77;
        t104 = t78;
        t105 = t74;
    }
    const real_t t133 = TB_C(1000000000000.0) - start_3;
    const real_t t134 = tb_max(t23 - t27 - t101, t101 - (t27 + t133));
    const bool t135 = TB_C(0.0) < t134;
    real_t t136, t137, t138, t139, t140;
    if (t135) {
        const real_t t141 = tb_min(tb_max(t101, t23), t133);
        const real_t t142 = t141 * (TB_C(1.0) / (t67 * t67 + t68 * t68));
        const real_t t143 = t99 - t98;
        const bool t144 = TB_ABS(t143) <= t63;
        const real_t t145 = t100 * t142;
        const real_t t146 = TB_C(1.0) / t143;
        real_t t147, t148, t149;
        if (t144) {
            t147 = -TB_C(1000000000000.0);
            t148 = TB_C(1000000000000.0);
            t149 = TB_C(0.0);
        } else {
            const real_t t150 = (t29 + t145) * t146;
            const real_t t151 = t146 * (t95 + t145);
            t147 = tb_min(t150, t151);
            t148 = tb_max(t150, t151);
            t149 = t72 * TB_ABS(t146);
        }
        const bool t152 = TB_ABS(t70) <= t63;
        const real_t t153 = t69 * t142;
        const real_t t154 = TB_C(1.0) / t70;
        real_t t155, t156, t157;
        if (t152) {
            t155 = -TB_C(1000000000000.0);
            t156 = TB_C(1000000000000.0);
            t157 = TB_C(0.0);
        } else {
            const real_t t158 = (t31 - t153) * t154;
            const real_t t159 = t154 * (t56 - t153);
            t155 = tb_min(t158, t159);
            t156 = tb_max(t158, t159);
            t157 = t72 * TB_ABS(t154);
        }
        const real_t t160 = t46 * t67 + t38 * t68;
        const bool t161 = TB_ABS(t160) <= t63;
        const real_t t162 = t71 * t142;
        const real_t t163 = TB_C(1.0) / t160;
        real_t t164, t165, t166;
        if (t161) {
            t164 = -TB_C(1000000000000.0);
            t165 = TB_C(1000000000000.0);
            t166 = TB_C(0.0);
        } else {
            const real_t t167 = (t64 - t162) * t163;
            const real_t t168 = t163 * (t65 - t162);
            t164 = tb_min(t167, t168);
            t165 = tb_max(t167, t168);
            t166 = t72 * TB_ABS(t163);
        }
        const real_t t169 = tb_max(t155, t164);
        const real_t t170 = tb_min(t156, t165);
        const real_t t171 = tb_min(tb_max(TB_C(0.0), tb_max(t147, t169)), tb_min(t148, t170));
        real_t t172;
        if (TB_C(0.0) < TB_ABS(t171)) {
            const real_t t173 = -(t100 * t146);
            const real_t t174 = t69 * t154;
            const real_t t175 = t71 * t163;
            real_t t176;
            if (TB_C(0.0) < t171) {
                t176 = t169 < t147 ? t173 : (t164 < t155 ? t174 : t175);
            } else {
                t176 = t148 < t170 ? t173 : (t156 < t165 ? t174 : t175);
            }
            t172 = t171 * t176;
        } else {
            t172 = TB_C(0.0);
        }
        const real_t t177 = t101 < t141 ? t172 - t142 : t142 - t172;
        real_t t178;
        if (TB_C(0.0) < t177) {
            const real_t t179 = tb_max(tb_max(t164 + t166, t155 + t157), t147 + t149);
            const real_t t180 = tb_min(tb_min(t165 - t166, t156 - t157), t148 - t149);
            t178 = t179 < t180 && t73 < t134 ? t177 : TB_C(0.0);
        } else {
            t178 = TB_C(0.0);
        }
        t136 = t178;
        t137 = t162 + t160 * t171;
        t138 = t153 + t70 * t171;
        t139 = t143 * t171 - t145;
        t140 = t141;
    } else {
        t136 = t102;
        t137 = t103;
        t138 = t104;
        t139 = t105;
        t140 = t101;
    }
    const real_t t181 = tb_min(tb_max(t137 - t49, TB_C(3.0)), TB_C(1000000000000.0));
    const real_t t182 = tb_min(tb_max(start_1 + t138, TB_C(3.0)), TB_C(1000000000000.0));
    const real_t t183 = tb_min(tb_max(start_2 + t139, TB_C(3.0)), TB_C(1000000000000.0));
    const real_t t184 = structure[0] * t181 + structure[1] * t182 + structure[2] * t183;
    const real_t t185 = tb_min(tb_max(start_3 + t140, TB_C(3.0)), TB_C(1000000000000.0));
    const real_t t186 = tb_max(t136, TB_ABS(t184 + structure[3] * t185 - wrench[0]));
    const real_t t187 = structure[4] * t181 + structure[5] * t182 + structure[6] * t183;
    const real_t t188 = tb_max(t186, TB_ABS(t187 + structure[7] * t185 - wrench[1]));
    const bool t189 = t188 <= t26 * (t24 * (TB_EPSILON * TB_C(128.0)));
    real_t tension_0, tension_1, tension_2, tension_3, kkt_residual_0;
    if (t189) {
        tension_0 = tb_min(t181, TB_C(10.0));
        tension_1 = tb_min(t182, TB_C(10.0));
        tension_2 = tb_min(t183, TB_C(10.0));
        tension_3 = tb_min(t185, TB_C(10.0));
        kkt_residual_0 = t188;
    } else {
        tension_0 = TB_C(3.0);
        tension_1 = TB_C(3.0);
        tension_2 = TB_C(3.0);
        tension_3 = TB_C(3.0);
        kkt_residual_0 = TB_C(0.0);
    }
    const bool t190 = !t189;
    const real_t t191 = structure[0] * tension_0 + structure[1] * tension_1;
    /* what the tensions exert, S T */
    const real_t delivered_0 = t191 + structure[2] * tension_2 + structure[3] * tension_3;
    const real_t t192 = structure[4] * tension_0 + structure[5] * tension_1;
    const real_t delivered_1 = t192 + structure[6] * tension_2 + structure[7] * tension_3;
    const bool t193 = !(TB_EPSILON * TB_C(4096.0) < t25);
    const bool t194 = TB_C(10.0) < t181 || TB_C(10.0) < t182 || TB_C(10.0) < t183;
    const bool t195 = t194 || TB_C(10.0) < t185;
    if (t193) {
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
    return (t190 || t195) ? TB_INFEASIBLE : TB_OK;
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

