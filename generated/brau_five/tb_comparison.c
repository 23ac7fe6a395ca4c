/* Regenerate: turnbuckle generate machines/brau_five.toml --out <this folder>
 * Machine b614899c8a021831, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_comparison.h"
#include "tb_machine.h"

tb_status tb_largest_tensions_eq17(const real_t structure[10], const real_t force[1],
    real_t tension[5])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) <= TB_C(40.0)
          && force[0] >= TB_C(0.0) && force[0] <= TB_C(10000.0))) {
        tension[0] = TB_C(0.0);
        tension[1] = TB_C(0.0);
        tension[2] = TB_C(0.0);
        tension[3] = TB_C(0.0);
        tension[4] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = TB_C(64.0) * TB_EPSILON;
    const real_t t1 = structure[0] * structure[6];
    const real_t t2 = structure[5] * structure[1];
    const real_t t3 = t1 - t2;
    const bool t4 = t0 < t3;
    const real_t t5 = structure[0] * structure[7];
    const real_t t6 = structure[5] * structure[2];
    const real_t t7 = t5 - t6;
    const bool t8 = t0 < t7;
    const real_t t9 = structure[6] * structure[2];
    const real_t t10 = structure[1] * structure[7];
    const real_t t11 = t9 - t10;
    const bool t12 = t0 < t11;
    const real_t t13 = structure[0] * structure[8];
    const real_t t14 = structure[5] * structure[3];
    const real_t t15 = t13 - t14;
    const bool t16 = t0 < t15;
    const real_t t17 = structure[6] * structure[3];
    const real_t t18 = structure[1] * structure[8];
    const real_t t19 = t17 - t18;
    const bool t20 = t0 < t19;
    const real_t t21 = structure[0] * structure[9];
    const real_t t22 = structure[5] * structure[4];
    const real_t t23 = t21 - t22;
    const bool t24 = t0 < t23;
    const real_t t25 = structure[6] * structure[4];
    const real_t t26 = structure[1] * structure[9];
    const real_t t27 = t25 - t26;
    const bool t28 = t0 < t27;
    const bool t29 = t4 && !((t8 && t12) || (t16 && t20) || (t24 && t28));
    const real_t t30 = t10 - t9;
    const bool t31 = t0 < t30;
    const real_t t32 = structure[7] * structure[3];
    const real_t t33 = structure[2] * structure[8];
    const real_t t34 = t32 - t33;
    const bool t35 = t0 < t34;
    const real_t t36 = structure[7] * structure[4];
    const real_t t37 = structure[2] * structure[9];
    const real_t t38 = t36 - t37;
    const bool t39 = t0 < t38;
    const bool t40 = t8 && !((t4 && t31) || (t16 && t35) || (t24 && t39));
    const real_t t41 = t18 - t17;
    const bool t42 = t0 < t41;
    const real_t t43 = t33 - t32;
    const bool t44 = t0 < t43;
    const real_t t45 = structure[8] * structure[4];
    const real_t t46 = structure[3] * structure[9];
    const real_t t47 = t45 - t46;
    const bool t48 = t0 < t47;
    const bool t49 = t16 && !((t4 && t42) || (t8 && t44) || (t24 && t48));
    const real_t t50 = t26 - t25;
    const bool t51 = t0 < t50;
    const real_t t52 = t37 - t36;
    const bool t53 = t0 < t52;
    const real_t t54 = t46 - t45;
    const bool t55 = t0 < t54;
    const bool t56 = t24 && !((t4 && t51) || (t8 && t53) || (t16 && t55));
    const real_t t57 = t2 - t1;
    const bool t58 = t0 < t57;
    const real_t t59 = t6 - t5;
    const bool t60 = t0 < t59;
    const real_t t61 = t14 - t13;
    const bool t62 = t0 < t61;
    const real_t t63 = t22 - t21;
    const bool t64 = t0 < t63;
    const bool t65 = t58 && !((t31 && t60) || (t42 && t62) || (t51 && t64));
    const bool t66 = t31 && !((t8 && t58) || (t35 && t42) || (t39 && t51));
    const bool t67 = t42 && !((t16 && t58) || (t31 && t44) || (t48 && t51));
    const bool t68 = t51 && !((t24 && t58) || (t31 && t53) || (t42 && t55));
    const bool t69 = (t29 || t40 || t49 || t56) && (t65 || t66 || t67 || t68);
    const bool t70 = t60 && !((t12 && t58) || (t44 && t62) || (t53 && t64));
    const bool t71 = t12 && !((t4 && t60) || (t20 && t44) || (t28 && t53));
    const bool t72 = t44 && !((t16 && t60) || (t12 && t42) || (t48 && t53));
    const bool t73 = t53 && !((t24 && t60) || (t12 && t51) || (t44 && t55));
    const bool t74 = t62 && !((t20 && t58) || (t35 && t60) || (t55 && t64));
    const bool t75 = t20 && !((t4 && t62) || (t12 && t35) || (t28 && t55));
    const bool t76 = t35 && !((t8 && t62) || (t20 && t31) || (t39 && t55));
    const bool t77 = t55 && !((t24 && t62) || (t20 && t51) || (t35 && t53));
    const bool t78 = t69 && (t70 || t71 || t72 || t73) && (t74 || t75 || t76 || t77);
    const bool t79 = t64 && !((t28 && t58) || (t39 && t60) || (t48 && t62));
    const bool t80 = t28 && !((t4 && t64) || (t12 && t39) || (t20 && t48));
    const bool t81 = t39 && !((t8 && t64) || (t28 && t31) || (t35 && t48));
    const bool t82 = t48 && !((t16 && t64) || (t28 && t42) || (t39 && t44));
    const bool t83 = t78 && (t79 || t80 || t81 || t82);
    real_t tension_0, tension_1, tension_2, tension_3, tension_4;
    if (t83) {
        const real_t t84 = structure[0] * structure[1] + structure[6] * structure[5];
        const bool t85 = t84 < TB_C(0.0);
        real_t t86;
        if (t29) {
            real_t t87;
            if (t85) {
                t87 = TB_C(1.0) / t3;
            } else {
                t87 = TB_C(1.0);
            }
            t86 = t87;
        } else {
            t86 = TB_C(0.0);
        }
        const real_t t88 = tb_max(TB_C(0.0), t86);
        const real_t t89 = structure[0] * structure[2] + structure[5] * structure[7];
        const bool t90 = t89 < TB_C(0.0);
        real_t t91;
        if (t40) {
            real_t t92;
            if (t90) {
                t92 = TB_C(1.0) / t7;
            } else {
                t92 = TB_C(1.0);
            }
            t91 = t92;
        } else {
            t91 = TB_C(0.0);
        }
        const real_t t93 = structure[0] * structure[3] + structure[5] * structure[8];
        const bool t94 = t93 < TB_C(0.0);
        real_t t95;
        if (t49) {
            real_t t96;
            if (t94) {
                t96 = TB_C(1.0) / t15;
            } else {
                t96 = TB_C(1.0);
            }
            t95 = t96;
        } else {
            t95 = TB_C(0.0);
        }
        const real_t t97 = structure[0] * structure[4] + structure[5] * structure[9];
        const bool t98 = t97 < TB_C(0.0);
        real_t t99;
        if (t56) {
            real_t t100;
            if (t98) {
                t100 = TB_C(1.0) / t23;
            } else {
                t100 = TB_C(1.0);
            }
            t99 = t100;
        } else {
            t99 = TB_C(0.0);
        }
        real_t t101;
        if (t65) {
            real_t t102;
            if (t85) {
                t102 = TB_C(1.0) / t57;
            } else {
                t102 = TB_C(1.0);
            }
            t101 = t102;
        } else {
            t101 = TB_C(0.0);
        }
        const real_t t103 = tb_max(tb_max(tb_max(tb_max(t88, t91), t95), t99), t101);
        real_t t104;
        if (t70) {
            real_t t105;
            if (t90) {
                t105 = TB_C(1.0) / t59;
            } else {
                t105 = TB_C(1.0);
            }
            t104 = t105;
        } else {
            t104 = TB_C(0.0);
        }
        real_t t106;
        if (t74) {
            real_t t107;
            if (t94) {
                t107 = TB_C(1.0) / t61;
            } else {
                t107 = TB_C(1.0);
            }
            t106 = t107;
        } else {
            t106 = TB_C(0.0);
        }
        real_t t108;
        if (t79) {
            real_t t109;
            if (t98) {
                t109 = TB_C(1.0) / t63;
            } else {
                t109 = TB_C(1.0);
            }
            t108 = t109;
        } else {
            t108 = TB_C(0.0);
        }
        const real_t t110 = force[0] * tb_max(tb_max(tb_max(t103, t104), t106), t108);
        const real_t t111 = structure[1] * structure[2] + structure[6] * structure[7];
        const bool t112 = t111 < TB_C(0.0);
        real_t t113;
        if (t66) {
            real_t t114;
            if (t112) {
                t114 = TB_C(1.0) / t30;
            } else {
                t114 = TB_C(1.0);
            }
            t113 = t114;
        } else {
            t113 = TB_C(0.0);
        }
        const real_t t115 = structure[1] * structure[3] + structure[6] * structure[8];
        const bool t116 = t115 < TB_C(0.0);
        real_t t117;
        if (t67) {
            real_t t118;
            if (t116) {
                t118 = TB_C(1.0) / t41;
            } else {
                t118 = TB_C(1.0);
            }
            t117 = t118;
        } else {
            t117 = TB_C(0.0);
        }
        const real_t t119 = structure[1] * structure[4] + structure[6] * structure[9];
        const bool t120 = t119 < TB_C(0.0);
        real_t t121;
        if (t68) {
            real_t t122;
            if (t120) {
                t122 = TB_C(1.0) / t50;
            } else {
                t122 = TB_C(1.0);
            }
            t121 = t122;
        } else {
            t121 = TB_C(0.0);
        }
        const real_t t123 = tb_max(tb_max(tb_max(tb_max(t88, t101), t113), t117), t121);
        real_t t124;
        if (t71) {
            real_t t125;
            if (t112) {
                t125 = TB_C(1.0) / t11;
            } else {
                t125 = TB_C(1.0);
            }
            t124 = t125;
        } else {
            t124 = TB_C(0.0);
        }
        real_t t126;
        if (t75) {
            real_t t127;
            if (t116) {
                t127 = TB_C(1.0) / t19;
            } else {
                t127 = TB_C(1.0);
            }
            t126 = t127;
        } else {
            t126 = TB_C(0.0);
        }
        real_t t128;
        if (t80) {
            real_t t129;
            if (t120) {
                t129 = TB_C(1.0) / t27;
            } else {
                t129 = TB_C(1.0);
            }
            t128 = t129;
        } else {
            t128 = TB_C(0.0);
        }
        const real_t t130 = force[0] * tb_max(tb_max(tb_max(t123, t124), t126), t128);
        const real_t t131 = tb_max(tb_max(tb_max(TB_C(0.0), t91), t113), t104);
        const real_t t132 = structure[2] * structure[3] + structure[7] * structure[8];
        const bool t133 = t132 < TB_C(0.0);
        real_t t134;
        if (t72) {
            real_t t135;
            if (t133) {
                t135 = TB_C(1.0) / t43;
            } else {
                t135 = TB_C(1.0);
            }
            t134 = t135;
        } else {
            t134 = TB_C(0.0);
        }
        const real_t t136 = structure[2] * structure[4] + structure[7] * structure[9];
        const bool t137 = t136 < TB_C(0.0);
        real_t t138;
        if (t73) {
            real_t t139;
            if (t137) {
                t139 = TB_C(1.0) / t52;
            } else {
                t139 = TB_C(1.0);
            }
            t138 = t139;
        } else {
            t138 = TB_C(0.0);
        }
        real_t t140;
        if (t76) {
            real_t t141;
            if (t133) {
                t141 = TB_C(1.0) / t34;
            } else {
                t141 = TB_C(1.0);
            }
            t140 = t141;
        } else {
            t140 = TB_C(0.0);
        }
        const real_t t142 = tb_max(tb_max(tb_max(tb_max(t131, t124), t134), t138), t140);
        real_t t143;
        if (t81) {
            real_t t144;
            if (t137) {
                t144 = TB_C(1.0) / t38;
            } else {
                t144 = TB_C(1.0);
            }
            t143 = t144;
        } else {
            t143 = TB_C(0.0);
        }
        const real_t t145 = tb_max(tb_max(tb_max(TB_C(0.0), t95), t117), t134);
        const real_t t146 = structure[3] * structure[4] + structure[8] * structure[9];
        const bool t147 = t146 < TB_C(0.0);
        real_t t148;
        if (t77) {
            real_t t149;
            if (t147) {
                t149 = TB_C(1.0) / t54;
            } else {
                t149 = TB_C(1.0);
            }
            t148 = t149;
        } else {
            t148 = TB_C(0.0);
        }
        const real_t t150 = tb_max(tb_max(tb_max(tb_max(t145, t106), t126), t140), t148);
        real_t t151;
        if (t82) {
            real_t t152;
            if (t147) {
                t152 = TB_C(1.0) / t47;
            } else {
                t152 = TB_C(1.0);
            }
            t151 = t152;
        } else {
            t151 = TB_C(0.0);
        }
        const real_t t153 = tb_max(tb_max(tb_max(TB_C(0.0), t99), t121), t138);
        const real_t t154 = tb_max(tb_max(tb_max(tb_max(t153, t148), t108), t128), t143);
        tension_0 = t110;
        tension_1 = t130;
        tension_2 = force[0] * tb_max(t142, t143);
        tension_3 = force[0] * tb_max(t150, t151);
        tension_4 = force[0] * tb_max(t154, t151);
    } else {
        tension_0 = TB_C(0.0);
        tension_1 = TB_C(0.0);
        tension_2 = TB_C(0.0);
        tension_3 = TB_C(0.0);
        tension_4 = TB_C(0.0);
    }
    const bool t155 = !t83;
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    tension[4] = tension_4;
    return t155 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_reduced_matrix_tension(const real_t structure[10], const real_t wrench[2],
    real_t tension[5])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) <= TB_C(40.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(100000.0))) {
        tension[0] = TB_C(0.0);
        tension[1] = TB_C(0.0);
        tension[2] = TB_C(0.0);
        tension[3] = TB_C(0.0);
        tension[4] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t t0 = structure[1] * wrench[1] - structure[6] * wrench[0];
    const real_t t1 = structure[6] * structure[0] - structure[1] * structure[5];
    const real_t t2 = TB_C(1.0) / t1;
    const real_t t3 = t0 * t2;
    const real_t t4 = -t3;
    const real_t t5 = wrench[1] * structure[0] - wrench[0] * structure[5];
    const real_t t6 = t2 * t5;
    const real_t t7 = TB_C(16.0) * TB_EPSILON;
    const real_t t8 = t6 - t3;
    const real_t t9 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const real_t t10 = tb_min(tb_min(t4, t6) + t7 * TB_ABS(t8), TB_ABS(t1) - t9);
    const real_t t11 = TB_C(0.0) <= t10 ? t8 : TB_C(1e+30);
    const real_t t12 = wrench[1] * structure[2] - wrench[0] * structure[7];
    const real_t t13 = structure[0] * structure[7] - structure[5] * structure[2];
    const real_t t14 = TB_C(1.0) / t13;
    const real_t t15 = t12 * t14;
    const real_t t16 = -t15;
    const real_t t17 = t5 * t14;
    const real_t t18 = t17 - t15;
    const real_t t19 = tb_min(tb_min(t16, t17) + t7 * TB_ABS(t18), TB_ABS(t13) - t9);
    const real_t t20 = TB_C(0.0) <= t19 ? t18 : TB_C(1e+30);
    const real_t t21 = wrench[1] * structure[3] - wrench[0] * structure[8];
    const real_t t22 = structure[0] * structure[8] - structure[5] * structure[3];
    const real_t t23 = TB_C(1.0) / t22;
    const real_t t24 = t21 * t23;
    const real_t t25 = -t24;
    const real_t t26 = t5 * t23;
    const real_t t27 = t26 - t24;
    const real_t t28 = tb_min(tb_min(t25, t26) + t7 * TB_ABS(t27), TB_ABS(t22) - t9);
    const real_t t29 = TB_C(0.0) <= t28 ? t27 : TB_C(1e+30);
    const real_t t30 = wrench[1] * structure[4] - wrench[0] * structure[9];
    const real_t t31 = structure[0] * structure[9] - structure[5] * structure[4];
    const real_t t32 = TB_C(1.0) / t31;
    const real_t t33 = t30 * t32;
    const real_t t34 = -t33;
    const real_t t35 = t5 * t32;
    const real_t t36 = t35 - t33;
    const real_t t37 = tb_min(tb_min(t34, t35) + t7 * TB_ABS(t36), TB_ABS(t31) - t9);
    const real_t t38 = TB_C(0.0) <= t37 ? t36 : TB_C(1e+30);
    const real_t t39 = structure[1] * structure[7] - structure[6] * structure[2];
    const real_t t40 = TB_C(1.0) / t39;
    const real_t t41 = t12 * t40;
    const real_t t42 = -t41;
    const real_t t43 = t0 * t40;
    const real_t t44 = t43 - t41;
    const real_t t45 = tb_min(tb_min(t42, t43) + t7 * TB_ABS(t44), TB_ABS(t39) - t9);
    const real_t t46 = TB_C(0.0) <= t45 ? t44 : TB_C(1e+30);
    const real_t t47 = tb_min(tb_min(tb_min(tb_min(t11, t20), t29), t38), t46);
    const real_t t48 = structure[1] * structure[8] - structure[6] * structure[3];
    const real_t t49 = TB_C(1.0) / t48;
    const real_t t50 = t21 * t49;
    const real_t t51 = -t50;
    const real_t t52 = t0 * t49;
    const real_t t53 = t52 - t50;
    const real_t t54 = tb_min(tb_min(t51, t52) + t7 * TB_ABS(t53), TB_ABS(t48) - t9);
    const real_t t55 = TB_C(0.0) <= t54 ? t53 : TB_C(1e+30);
    const real_t t56 = structure[1] * structure[9] - structure[6] * structure[4];
    const real_t t57 = TB_C(1.0) / t56;
    const real_t t58 = t30 * t57;
    const real_t t59 = -t58;
    const real_t t60 = t0 * t57;
    const real_t t61 = t60 - t58;
    const real_t t62 = tb_min(tb_min(t59, t60) + t7 * TB_ABS(t61), TB_ABS(t56) - t9);
    const real_t t63 = TB_C(0.0) <= t62 ? t61 : TB_C(1e+30);
    const real_t t64 = structure[2] * structure[8] - structure[7] * structure[3];
    const real_t t65 = TB_C(1.0) / t64;
    const real_t t66 = t21 * t65;
    const real_t t67 = -t66;
    const real_t t68 = t12 * t65;
    const real_t t69 = t68 - t66;
    const real_t t70 = tb_min(tb_min(t67, t68) + t7 * TB_ABS(t69), TB_ABS(t64) - t9);
    const real_t t71 = TB_C(0.0) <= t70 ? t69 : TB_C(1e+30);
    const real_t t72 = structure[2] * structure[9] - structure[7] * structure[4];
    const real_t t73 = TB_C(1.0) / t72;
    const real_t t74 = t30 * t73;
    const real_t t75 = -t74;
    const real_t t76 = t12 * t73;
    const real_t t77 = t76 - t74;
    const real_t t78 = tb_min(tb_min(t75, t76) + t7 * TB_ABS(t77), TB_ABS(t72) - t9);
    const real_t t79 = TB_C(0.0) <= t78 ? t77 : TB_C(1e+30);
    const real_t t80 = tb_min(tb_min(tb_min(tb_min(t47, t55), t63), t71), t79);
    const real_t t81 = structure[3] * structure[9] - structure[8] * structure[4];
    const real_t t82 = TB_C(1.0) / t81;
    const real_t t83 = t30 * t82;
    const real_t t84 = -t83;
    const real_t t85 = t21 * t82;
    const real_t t86 = t85 - t83;
    const real_t t87 = tb_min(tb_min(t84, t85) + t7 * TB_ABS(t86), TB_ABS(t81) - t9);
    const real_t t88 = TB_C(0.0) <= t87 ? t86 : TB_C(1e+30);
    const bool t89 = tb_min(t80, t88) < TB_C(1e+30);
    real_t tension_0, tension_1, tension_2, tension_3, tension_4;
    if (t89) {
        const real_t t90 = -t55;
        const real_t t91 = -t63;
        const real_t t92 = tb_max(t90, t91);
        const real_t t93 = -t71;
        const real_t t94 = tb_max(t92, t93);
        const real_t t95 = -t79;
        const real_t t96 = -t88;
        const real_t t97 = -t11;
        const real_t t98 = -t20;
        const real_t t99 = tb_max(t97, t98);
        const real_t t100 = -t29;
        const real_t t101 = tb_max(t99, t100);
        const real_t t102 = -t38;
        const real_t t103 = -t46;
        const bool t104 = tb_max(tb_max(t94, t95), t96) <= tb_max(tb_max(t101, t102), t103);
        real_t t105, t106, t107, t108, t109;
        if (t104) {
            const bool t110 = tb_max(t102, t103) <= t101;
            real_t t111, t112, t113, t114, t115;
            if (t110) {
                const bool t116 = t100 <= t99;
                const bool t117 = t98 <= t97;
                t111 = t116 ? (t117 ? t4 : t16) : t25;
                t112 = t116 ? (t117 ? t6 : TB_C(0.0)) : TB_C(0.0);
                t113 = t116 ? (t117 ? TB_C(0.0) : t17) : TB_C(0.0);
                t114 = t116 ? TB_C(0.0) : t26;
                t115 = TB_C(0.0);
            } else {
                const bool t118 = t103 <= t102;
                t111 = t118 ? t34 : TB_C(0.0);
                t112 = t118 ? TB_C(0.0) : t42;
                t113 = t118 ? TB_C(0.0) : t43;
                t114 = TB_C(0.0);
                t115 = t118 ? t35 : TB_C(0.0);
            }
            t105 = t111;
            t106 = t112;
            t107 = t113;
            t108 = t114;
            t109 = t115;
        } else {
            const bool t119 = tb_max(t95, t96) <= t94;
            real_t t120, t121, t122, t123;
            if (t119) {
                const bool t124 = t93 <= t92;
                const bool t125 = t91 <= t90;
                t120 = t124 ? (t125 ? t51 : t59) : TB_C(0.0);
                t121 = t124 ? TB_C(0.0) : t67;
                t122 = t124 ? (t125 ? t52 : TB_C(0.0)) : t68;
                t123 = t124 ? (t125 ? TB_C(0.0) : t60) : TB_C(0.0);
            } else {
                const bool t126 = t96 <= t95;
                t120 = TB_C(0.0);
                t121 = t126 ? t75 : TB_C(0.0);
                t122 = t126 ? TB_C(0.0) : t84;
                t123 = t126 ? t76 : t85;
            }
            t105 = TB_C(0.0);
            t106 = t120;
            t107 = t121;
            t108 = t122;
            t109 = t123;
        }
        tension_0 = tb_max(t105, TB_C(0.0));
        tension_1 = tb_max(t106, TB_C(0.0));
        tension_2 = tb_max(t107, TB_C(0.0));
        tension_3 = tb_max(t108, TB_C(0.0));
        tension_4 = tb_max(t109, TB_C(0.0));
    } else {
        tension_0 = TB_C(0.0);
        tension_1 = TB_C(0.0);
        tension_2 = TB_C(0.0);
        tension_3 = TB_C(0.0);
        tension_4 = TB_C(0.0);
    }
    const bool t127 = !t89;
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    tension[4] = tension_4;
    return t127 ? TB_INFEASIBLE : TB_OK;
}

/* Refuses with a status: pivot is 0; side is 0; moving is 0; push is 0 N. */
static tb_status tb_refuse_kernel_tension_begin(tb_status status, real_t pivot[1],
    real_t side[5], real_t moving[1], real_t push[1])
{
    pivot[0] = TB_C(0.0);
    side[0] = TB_C(0.0);
    side[1] = TB_C(0.0);
    side[2] = TB_C(0.0);
    side[3] = TB_C(0.0);
    side[4] = TB_C(0.0);
    moving[0] = TB_C(0.0);
    push[0] = TB_C(0.0);
    return status;
}

/* All cables are free. */
static tb_status tb_kernel_tension_begin(const real_t structure[10], const real_t wrench[2],
    real_t pivot[1], real_t side[5], real_t moving[1], real_t push[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) <= TB_C(40.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) <= TB_C(100000.0))) {
        return tb_refuse_kernel_tension_begin(TB_OUT_OF_DOMAIN, pivot, side, moving, push);
    }
    const real_t t0 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t1 = t0 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t2 = TB_SQRT(t1 + structure[4] * structure[4]);
    const real_t t3 = TB_COPYSIGN(t2, structure[0]);
    const real_t t4 = TB_ABS(t3);
    const real_t t5 = (structure[0] + t3) * structure[5] + structure[1] * structure[6];
    const real_t t6 = t5 + structure[2] * structure[7] + structure[3] * structure[8];
    const real_t t7 = (t6 + structure[4] * structure[9]) * (TB_C(1.0) / (t2 * (t2 +
        TB_ABS(structure[0]))));
    const real_t t8 = structure[6] - structure[1] * t7;
    const real_t t9 = structure[7] - structure[2] * t7;
    const real_t t10 = structure[8] - structure[3] * t7;
    const real_t t11 = structure[9] - structure[4] * t7;
    const real_t t12 = TB_SQRT(t8 * t8 + t9 * t9 + t10 * t10 + t11 * t11);
    const real_t t13 = TB_ABS(TB_COPYSIGN(t12, t8));
    const real_t pivot_0 = tb_min(t4, t13);
    const real_t t14 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const bool t15 = !(t14 < t4 && t14 < t13);
    if (t15) {
        return tb_refuse_kernel_tension_begin(TB_SINGULAR, pivot, side, moving, push);
    }
    pivot[0] = pivot_0;
    side[0] = TB_C(0.0);
    side[1] = TB_C(0.0);
    side[2] = TB_C(0.0);
    side[3] = TB_C(0.0);
    side[4] = TB_C(0.0);
    moving[0] = -TB_C(1.0);
    push[0] = TB_C(0.0);
    return TB_OK;
}

/* Moves a cable towards its bounds, until it is held or another one is freed. */
static tb_status tb_kernel_tension_step(const real_t structure[10], const real_t wrench[2],
    real_t side[5], real_t moving[1], real_t push[1], real_t done[1])
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
    const real_t t10 = t0 ? (t0 ? structure[0] * structure[0] : TB_C(0.0)) : TB_C(0.0);
    const real_t t11 = t2 ? (t2 ? structure[1] * structure[1] : TB_C(0.0)) : TB_C(0.0);
    const real_t t12 = t4 ? (t4 ? structure[2] * structure[2] : TB_C(0.0)) : TB_C(0.0);
    const real_t t13 = t6 ? (t6 ? structure[3] * structure[3] : TB_C(0.0)) : TB_C(0.0);
    const real_t t14 = t8 ? (t8 ? structure[4] * structure[4] : TB_C(0.0)) : TB_C(0.0);
    const real_t t15 = TB_SQRT(t10 + t11 + t12 + t13 + t14);
    const real_t t16 = t0 ? structure[0] : TB_C(0.0);
    const real_t t17 = TB_COPYSIGN(t15, t16);
    const real_t t18 = t16 + t17;
    const real_t t19 = t2 ? (t2 ? structure[1] * structure[6] : TB_C(0.0)) : TB_C(0.0);
    const real_t t20 = t4 ? (t4 ? structure[2] * structure[7] : TB_C(0.0)) : TB_C(0.0);
    const real_t t21 = (t0 ? t18 * structure[5] : TB_C(0.0)) + t19 + t20;
    const real_t t22 = t6 ? (t6 ? structure[3] * structure[8] : TB_C(0.0)) : TB_C(0.0);
    const real_t t23 = t8 ? (t8 ? structure[4] * structure[9] : TB_C(0.0)) : TB_C(0.0);
    const real_t t24 = (t21 + t22 + t23) * (TB_C(1.0) / (t15 * (t15 + TB_ABS(t16))));
    const real_t t25 = structure[6] - structure[1] * t24;
    const real_t t26 = structure[7] - structure[2] * t24;
    const real_t t27 = (t2 ? (t2 ? t25 * t25 : TB_C(0.0)) : TB_C(0.0)) + (t4 ? (t4 ? t26 * t26
        : TB_C(0.0)) : TB_C(0.0));
    const real_t t28 = structure[8] - structure[3] * t24;
    const real_t t29 = t27 + (t6 ? (t6 ? t28 * t28 : TB_C(0.0)) : TB_C(0.0));
    const real_t t30 = structure[9] - structure[4] * t24;
    const real_t t31 = t29 + (t8 ? (t8 ? t30 * t30 : TB_C(0.0)) : TB_C(0.0));
    const real_t t32 = TB_COPYSIGN(TB_SQRT(t31), t2 ? t25 : TB_C(0.0));
    const real_t t33 = tb_min(TB_C(1.0), tb_min(TB_ABS(t17), TB_ABS(t32)));
    const real_t t34 = TB_C(1.0) / t33;
    const real_t t35 = TB_C(64.0) * TB_EPSILON * t34;
    const bool t36 = TB_C(0.0) <= moving[0];
    const real_t t37 = TB_C(1.0) / t17;
    const bool t38 = TB_C(0.0) < side[0];
    const real_t t39 = t38 ? structure[0] * TB_C(1000000000000.0) : TB_C(0.0);
    const bool t40 = TB_C(0.0) < side[1];
    const real_t t41 = t40 ? structure[1] * TB_C(1000000000000.0) : TB_C(0.0);
    const bool t42 = TB_C(0.0) < side[2];
    const real_t t43 = t42 ? structure[2] * TB_C(1000000000000.0) : TB_C(0.0);
    const bool t44 = TB_C(0.0) < side[3];
    const real_t t45 = t44 ? structure[3] * TB_C(1000000000000.0) : TB_C(0.0);
    const bool t46 = TB_C(0.0) < side[4];
    const real_t t47 = t46 ? structure[4] * TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t48 = (wrench[0] - (t39 + t41 + t43 + t45 + t47)) * t37;
    const real_t t49 = (t0 ? structure[5] : TB_C(0.0)) - t18 * t24;
    const real_t t50 = TB_C(1.0) / t32;
    const real_t t51 = t38 ? structure[5] * TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t52 = t40 ? structure[6] * TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t53 = t42 ? structure[7] * TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t54 = t44 ? structure[8] * TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t55 = t46 ? structure[9] * TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t56 = wrench[1] - (t51 + t52 + t53 + t54 + t55) + t48 * t49;
    const real_t t57 = t50 * (t56 * t50);
    const real_t t58 = t37 * (t48 + t49 * t57);
    const real_t t59 = structure[3] * t58 + structure[8] * t57;
    const real_t t60 = TB_C(0.0) < t7 ? tb_max(-t59, t59 - TB_C(1000000000000.0)) : -TB_C(1.0);
    const real_t t61 = structure[4] * t58 + structure[9] * t57;
    const real_t t62 = TB_C(0.0) < t9 ? tb_max(-t61, t61 - TB_C(1000000000000.0)) : -TB_C(1.0);
    const real_t t63 = structure[0] * t58 + structure[5] * t57;
    const real_t t64 = TB_C(0.0) < t1 ? tb_max(-t63, t63 - TB_C(1000000000000.0)) : -TB_C(1.0);
    const real_t t65 = structure[1] * t58 + structure[6] * t57;
    const real_t t66 = TB_C(0.0) < t3 ? tb_max(-t65, t65 - TB_C(1000000000000.0)) : -TB_C(1.0);
    const real_t t67 = structure[2] * t58 + structure[7] * t57;
    const real_t t68 = TB_C(0.0) < t5 ? tb_max(-t67, t67 - TB_C(1000000000000.0)) : -TB_C(1.0);
    real_t t69, t70, t71, t72, t73;
    if (t36) {
        t69 = moving[0] == TB_C(3.0) ? TB_C(1.0) : TB_C(0.0);
        t70 = moving[0] == TB_C(4.0) ? TB_C(1.0) : TB_C(0.0);
        t71 = TB_C(0.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
        t72 = TB_C(1.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
        t73 = TB_C(2.0) == moving[0] ? TB_C(1.0) : TB_C(0.0);
    } else {
        t69 = t60;
        t70 = t62;
        t71 = t64;
        t72 = t66;
        t73 = t68;
    }
    const real_t t74 = tb_max(t71, t72);
    const bool t75 = tb_max(t69, t70) <= tb_max(t74, t73);
    real_t t76, t77, t78, t79;
    if (t75) {
        const bool t80 = t73 <= t74;
        real_t t81, t82, t83, t84;
        if (t80) {
            const bool t85 = t72 <= t71;
            t81 = t85 ? TB_C(0.0) : TB_C(1.0);
            t82 = t85 ? structure[0] : structure[1];
            t83 = t85 ? structure[5] : structure[6];
            t84 = t85 ? t63 : t65;
        } else {
            t81 = TB_C(2.0);
            t82 = structure[2];
            t83 = structure[7];
            t84 = t67;
        }
        t76 = t81;
        t77 = t82;
        t78 = t83;
        t79 = t84;
    } else {
        const bool t86 = t70 <= t69;
        t76 = t86 ? TB_C(3.0) : TB_C(4.0);
        t77 = t86 ? structure[3] : structure[4];
        t78 = t86 ? structure[8] : structure[9];
        t79 = t86 ? t59 : t61;
    }
    const real_t t87 = t37 * t77;
    const real_t t88 = t50 * (t50 * (t78 + t49 * t87));
    const real_t t89 = t37 * (t87 + t49 * t88);
    const real_t t90 = structure[0] * t89 + structure[5] * t88;
    const real_t t91 = (TB_C(0.0) == t76 ? TB_C(1.0) : TB_C(0.0)) - t90;
    const real_t t92 = structure[1] * t89 + structure[6] * t88;
    const real_t t93 = (TB_C(1.0) == t76 ? TB_C(1.0) : TB_C(0.0)) - t92;
    const real_t t94 = (t0 ? (t0 ? t91 * t91 : TB_C(0.0)) : TB_C(0.0)) + (t2 ? (t2 ? t93 * t93
        : TB_C(0.0)) : TB_C(0.0));
    const real_t t95 = structure[2] * t89 + structure[7] * t88;
    const real_t t96 = (TB_C(2.0) == t76 ? TB_C(1.0) : TB_C(0.0)) - t95;
    const real_t t97 = t94 + (t4 ? (t4 ? t96 * t96 : TB_C(0.0)) : TB_C(0.0));
    const real_t t98 = structure[3] * t89 + structure[8] * t88;
    const real_t t99 = (TB_C(3.0) == t76 ? TB_C(1.0) : TB_C(0.0)) - t98;
    const real_t t100 = t97 + (t6 ? (t6 ? t99 * t99 : TB_C(0.0)) : TB_C(0.0));
    const real_t t101 = structure[4] * t89 + structure[9] * t88;
    const real_t t102 = (TB_C(4.0) == t76 ? TB_C(1.0) : TB_C(0.0)) - t101;
    const real_t t103 = t100 + (t8 ? (t8 ? t102 * t102 : TB_C(0.0)) : TB_C(0.0));
    const bool t104 = TB_C(2.0) < t1 + t3 + t5 + t7 + t9 && t35 * t35 < t103;
    const real_t t105 = t79 + t103 * push[0];
    const bool t106 = t105 < TB_C(500000000000.0);
    real_t t107;
    if (t104) {
        const real_t t108 = tb_max(t106 ? -t105 : t105 - TB_C(1000000000000.0), TB_C(0.0));
        t107 = t108 * (TB_C(1.0) / t103);
    } else {
        t107 = TB_C(1e+30);
    }
    const real_t t109 = t106 ? TB_C(1.0) : -TB_C(1.0);
    const real_t t110 = side[0] * (t90 * t109);
    real_t t111;
    if (t35 < t110) {
        const real_t t112 = t63 - t90 * push[0] - (t38 ? TB_C(1000000000000.0) : TB_C(0.0));
        t111 = tb_max(side[0] * t112, TB_C(0.0)) / t110;
    } else {
        t111 = TB_C(1e+30);
    }
    const real_t t113 = side[1] * (t92 * t109);
    real_t t114;
    if (t35 < t113) {
        const real_t t115 = t65 - t92 * push[0] - (t40 ? TB_C(1000000000000.0) : TB_C(0.0));
        t114 = tb_max(side[1] * t115, TB_C(0.0)) / t113;
    } else {
        t114 = TB_C(1e+30);
    }
    const real_t t116 = side[2] * (t95 * t109);
    real_t t117;
    if (t35 < t116) {
        const real_t t118 = t67 - t95 * push[0] - (t42 ? TB_C(1000000000000.0) : TB_C(0.0));
        t117 = tb_max(side[2] * t118, TB_C(0.0)) / t116;
    } else {
        t117 = TB_C(1e+30);
    }
    const real_t t119 = side[3] * (t98 * t109);
    real_t t120;
    if (t35 < t119) {
        const real_t t121 = t59 - t98 * push[0] - (t44 ? TB_C(1000000000000.0) : TB_C(0.0));
        t120 = tb_max(side[3] * t121, TB_C(0.0)) / t119;
    } else {
        t120 = TB_C(1e+30);
    }
    const real_t t122 = side[4] * (t101 * t109);
    real_t t123;
    if (t35 < t122) {
        const real_t t124 = t61 - t101 * push[0] - (t46 ? TB_C(1000000000000.0) : TB_C(0.0));
        t123 = tb_max(side[4] * t124, TB_C(0.0)) / t122;
    } else {
        t123 = TB_C(1e+30);
    }
    const real_t t125 = tb_min(tb_min(tb_min(tb_min(t111, t114), t117), t120), t123);
    const bool t126 = t107 <= t125;
    const real_t t127 = tb_max(tb_max(tb_max(tb_max(t64, t66), t68), t60), t62);
    const real_t t128 = TB_EPSILON * TB_C(8.0) * (TB_ABS(wrench[0]) + TB_ABS(wrench[1]));
    const bool t129 = (!t36 && t127 <= t34 * t128) || !(tb_min(t107, t125) < TB_C(1e+30));
    const real_t t130 = t126 && !t129 ? t76 : -TB_C(1.0);
    const real_t t131 = -t109;
    real_t t132;
    if (t126 || t129) {
        t132 = -TB_C(1.0);
    } else {
        const real_t t133 = -t120;
        const real_t t134 = -t123;
        const real_t t135 = -t111;
        const real_t t136 = -t114;
        const real_t t137 = tb_max(t135, t136);
        const real_t t138 = -t117;
        real_t t139;
        if (tb_max(t133, t134) <= tb_max(t137, t138)) {
            const real_t t140 = t138 <= t137 ? (t136 <= t135 ? TB_C(0.0) : TB_C(1.0)) :
                TB_C(2.0);
            t139 = t140;
        } else {
            t139 = t134 <= t133 ? TB_C(3.0) : TB_C(4.0);
        }
        t132 = t139;
    }
    const real_t side_0 = TB_C(0.0) == t130 ? t131 : (TB_C(0.0) == t132 ? TB_C(0.0) : side[0]);
    const real_t side_1 = TB_C(1.0) == t130 ? t131 : (TB_C(1.0) == t132 ? TB_C(0.0) : side[1]);
    const real_t side_2 = TB_C(2.0) == t130 ? t131 : (TB_C(2.0) == t132 ? TB_C(0.0) : side[2]);
    const real_t side_3 = TB_C(3.0) == t130 ? t131 : (TB_C(3.0) == t132 ? TB_C(0.0) : side[3]);
    const real_t side_4 = TB_C(4.0) == t130 ? t131 : (TB_C(4.0) == t132 ? TB_C(0.0) : side[4]);
    const real_t moving_0 = t126 ? -TB_C(1.0) : t76;
    const real_t push_0 = t126 ? TB_C(0.0) : push[0] + t109 * t125;
    const real_t done_0 = t129 ? TB_C(1.0) : TB_C(0.0);
    side[0] = side_0;
    side[1] = side_1;
    side[2] = side_2;
    side[3] = side_3;
    side[4] = side_4;
    moving[0] = moving_0;
    push[0] = push_0;
    done[0] = done_0;
    return TB_OK;
}

/* The tensions, refined and judged. */
static tb_status tb_kernel_tension_finish(const real_t structure[10], const real_t wrench[2],
    const real_t pivot[1], const real_t side[5], real_t tension[5])
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
    const bool t9 = TB_C(0.0) < side[4];
    const real_t t10 = t9 ? TB_C(1000000000000.0) * structure[4] : TB_C(0.0);
    const real_t t11 = wrench[0] - (t2 + t4 + t6 + t8 + t10);
    const bool t12 = TB_C(0.0) == side[0];
    const real_t t13 = t12 ? (t12 ? structure[0] * structure[0] : TB_C(0.0)) : TB_C(0.0);
    const bool t14 = TB_C(0.0) == side[1];
    const real_t t15 = t14 ? (t14 ? structure[1] * structure[1] : TB_C(0.0)) : TB_C(0.0);
    const bool t16 = TB_C(0.0) == side[2];
    const real_t t17 = t16 ? (t16 ? structure[2] * structure[2] : TB_C(0.0)) : TB_C(0.0);
    const bool t18 = TB_C(0.0) == side[3];
    const real_t t19 = t18 ? (t18 ? structure[3] * structure[3] : TB_C(0.0)) : TB_C(0.0);
    const bool t20 = TB_C(0.0) == side[4];
    const real_t t21 = t20 ? (t20 ? structure[4] * structure[4] : TB_C(0.0)) : TB_C(0.0);
    const real_t t22 = TB_SQRT(t13 + t15 + t17 + t19 + t21);
    const real_t t23 = t12 ? structure[0] : TB_C(0.0);
    const real_t t24 = TB_COPYSIGN(t22, t23);
    const real_t t25 = TB_C(1.0) / t24;
    const real_t t26 = t11 * t25;
    const real_t t27 = t23 + t24;
    const real_t t28 = t14 ? (t14 ? structure[1] * structure[6] : TB_C(0.0)) : TB_C(0.0);
    const real_t t29 = t16 ? (t16 ? structure[2] * structure[7] : TB_C(0.0)) : TB_C(0.0);
    const real_t t30 = (t12 ? structure[5] * t27 : TB_C(0.0)) + t28 + t29;
    const real_t t31 = t18 ? (t18 ? structure[3] * structure[8] : TB_C(0.0)) : TB_C(0.0);
    const real_t t32 = t20 ? (t20 ? structure[4] * structure[9] : TB_C(0.0)) : TB_C(0.0);
    const real_t t33 = (t30 + t31 + t32) * (TB_C(1.0) / (t22 * (t22 + TB_ABS(t23))));
    const real_t t34 = (t12 ? structure[5] : TB_C(0.0)) - t27 * t33;
    const real_t t35 = t0 ? TB_C(1000000000000.0) * structure[5] : TB_C(0.0);
    const real_t t36 = t3 ? TB_C(1000000000000.0) * structure[6] : TB_C(0.0);
    const real_t t37 = t5 ? TB_C(1000000000000.0) * structure[7] : TB_C(0.0);
    const real_t t38 = t7 ? TB_C(1000000000000.0) * structure[8] : TB_C(0.0);
    const real_t t39 = t9 ? TB_C(1000000000000.0) * structure[9] : TB_C(0.0);
    const real_t t40 = wrench[1] - (t35 + t36 + t37 + t38 + t39);
    const real_t t41 = structure[6] - structure[1] * t33;
    const real_t t42 = structure[7] - structure[2] * t33;
    const real_t t43 = (t14 ? (t14 ? t41 * t41 : TB_C(0.0)) : TB_C(0.0)) + (t16 ? (t16 ? t42 *
        t42 : TB_C(0.0)) : TB_C(0.0));
    const real_t t44 = structure[8] - structure[3] * t33;
    const real_t t45 = t43 + (t18 ? (t18 ? t44 * t44 : TB_C(0.0)) : TB_C(0.0));
    const real_t t46 = structure[9] - structure[4] * t33;
    const real_t t47 = t45 + (t20 ? (t20 ? t46 * t46 : TB_C(0.0)) : TB_C(0.0));
    const real_t t48 = TB_COPYSIGN(TB_SQRT(t47), t14 ? t41 : TB_C(0.0));
    const real_t t49 = TB_C(1.0) / t48;
    const real_t t50 = t49 * ((t40 + t26 * t34) * t49);
    const real_t t51 = t25 * (t26 + t34 * t50);
    const real_t t52 = structure[0] * t51 + structure[5] * t50;
    const real_t t53 = structure[1] * t51 + structure[6] * t50;
    const real_t t54 = (t12 ? structure[0] * t52 : TB_C(0.0)) + (t14 ? structure[1] * t53 :
        TB_C(0.0));
    const real_t t55 = structure[2] * t51 + structure[7] * t50;
    const real_t t56 = structure[3] * t51 + structure[8] * t50;
    const real_t t57 = t54 + (t16 ? structure[2] * t55 : TB_C(0.0)) + (t18 ? structure[3] * t56
        : TB_C(0.0));
    const real_t t58 = structure[4] * t51 + structure[9] * t50;
    const real_t t59 = t11 - (t57 + (t20 ? structure[4] * t58 : TB_C(0.0)));
    const real_t t60 = t25 * t59;
    const real_t t61 = (t12 ? structure[5] * t52 : TB_C(0.0)) + (t14 ? structure[6] * t53 :
        TB_C(0.0));
    const real_t t62 = t61 + (t16 ? structure[7] * t55 : TB_C(0.0)) + (t18 ? structure[8] * t56
        : TB_C(0.0));
    const real_t t63 = t40 - (t62 + (t20 ? structure[9] * t58 : TB_C(0.0)));
    const real_t t64 = t49 * (t49 * (t63 + t34 * t60));
    const real_t t65 = t25 * (t60 + t34 * t64);
    const real_t t66 = t52 + (structure[0] * t65 + structure[5] * t64);
    const real_t t67 = t3 ? TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t68 = t53 + (structure[1] * t65 + structure[6] * t64);
    const real_t t69 = tb_max(side[0] * (t1 - t66), side[1] * (t67 - t68));
    const real_t t70 = t5 ? TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t71 = t55 + (structure[2] * t65 + structure[7] * t64);
    const real_t t72 = t7 ? TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t73 = t56 + (structure[3] * t65 + structure[8] * t64);
    const real_t t74 = tb_max(tb_max(t69, side[2] * (t70 - t71)), side[3] * (t72 - t73));
    const real_t t75 = t9 ? TB_C(1000000000000.0) : TB_C(0.0);
    const real_t t76 = t58 + (structure[4] * t65 + structure[9] * t64);
    const real_t t77 = tb_max(TB_C(0.0), tb_max(t74, side[4] * (t75 - t76)));
    const real_t t78 = tb_min(TB_C(1.0), tb_min(TB_ABS(t24), TB_ABS(t48)));
    const real_t t79 = TB_ABS(wrench[0]) + TB_ABS(wrench[1]);
    const real_t t80 = TB_C(1.0) / tb_max(t79, tb_max(TB_ABS(t51), TB_ABS(t50)));
    const real_t t81 = tb_min(tb_max(t12 ? t66 : t1, TB_C(0.0)), TB_C(1000000000000.0));
    const real_t t82 = tb_min(tb_max(t14 ? t68 : t67, TB_C(0.0)), TB_C(1000000000000.0));
    const real_t t83 = tb_min(tb_max(t16 ? t71 : t70, TB_C(0.0)), TB_C(1000000000000.0));
    const real_t t84 = structure[0] * t81 + structure[1] * t82 + structure[2] * t83;
    const real_t t85 = tb_min(tb_max(t18 ? t73 : t72, TB_C(0.0)), TB_C(1000000000000.0));
    const real_t t86 = tb_min(tb_max(t20 ? t76 : t75, TB_C(0.0)), TB_C(1000000000000.0));
    const real_t t87 = t84 + structure[3] * t85 + structure[4] * t86 - wrench[0];
    const real_t t88 = structure[5] * t81 + structure[6] * t82 + structure[7] * t83;
    const real_t t89 = t88 + structure[8] * t85 + structure[9] * t86 - wrench[1];
    const real_t t90 = tb_max(tb_max(t77 * t78 * t79 * t80, TB_ABS(t87)), TB_ABS(t89));
    const real_t t91 = tb_max(tb_max(tb_max(tb_max(t81, t82), t83), t85), t86);
    const real_t t92 = TB_C(128.0) * TB_EPSILON * t91 * (TB_C(1.0) / pivot[0]);
    const bool t93 = t90 <= tb_min(t92, TB_C(0.01));
    const real_t tension_0 = t93 ? t81 : TB_C(0.0);
    const real_t tension_1 = t93 ? t82 : TB_C(0.0);
    const real_t tension_2 = t93 ? t83 : TB_C(0.0);
    const real_t tension_3 = t93 ? t85 : TB_C(0.0);
    const real_t tension_4 = t93 ? t86 : TB_C(0.0);
    const bool t94 = !t93;
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    tension[4] = tension_4;
    return t94 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_kernel_tension(const real_t structure[10], const real_t wrench[2],
    real_t tension[5])
{
    real_t pivot[1];
    real_t side[5];
    real_t moving[1];
    real_t push[1];
    real_t done[1] = {TB_C(0.0)};
    tb_status status = tb_kernel_tension_begin(structure, wrench, pivot, side, moving, push);
    for (int steps = 0; steps < 25 && status == TB_OK && !(done[0] > TB_C(0.0)); steps++) {
        status = tb_kernel_tension_step(structure, wrench, side, moving, push, done);
    }
    if (status == TB_OK && !(done[0] > TB_C(0.0))) {
        status = TB_INACCURATE;
    }
    if (status != TB_OK) {
        tension[0] = TB_C(0.0);
        tension[1] = TB_C(0.0);
        tension[2] = TB_C(0.0);
        tension[3] = TB_C(0.0);
        tension[4] = TB_C(0.0);
        return status;
    }
    return tb_kernel_tension_finish(structure, wrench, pivot, side, tension);
}

/* Refuses with a status: most is 0; least is 0; size is 0 N. */
static tb_status tb_refuse_largest_tensions_eq12_begin(tb_status status, real_t most[5],
    real_t least[1], real_t size[1])
{
    most[0] = TB_C(0.0);
    most[1] = TB_C(0.0);
    most[2] = TB_C(0.0);
    most[3] = TB_C(0.0);
    most[4] = TB_C(0.0);
    least[0] = TB_C(0.0);
    size[0] = TB_C(0.0);
    return status;
}

/* Before the first subset. */
static tb_status tb_largest_tensions_eq12_begin(const real_t structure[10], const real_t force[1],
    real_t most[5], real_t least[1], real_t size[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) <= TB_C(40.0)
          && force[0] >= TB_C(0.0) && force[0] <= TB_C(10000.0))) {
        return tb_refuse_largest_tensions_eq12_begin(TB_OUT_OF_DOMAIN, most, least, size);
    }
    const real_t t0 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const real_t t1 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t2 = t1 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t3 = TB_SQRT(t2 + structure[4] * structure[4]);
    const real_t t4 = TB_COPYSIGN(t3, structure[0]);
    const real_t t5 = (structure[0] + t4) * structure[5] + structure[1] * structure[6];
    const real_t t6 = t5 + structure[2] * structure[7] + structure[3] * structure[8];
    const real_t t7 = (t6 + structure[4] * structure[9]) * (TB_C(1.0) / (t3 * (t3 +
        TB_ABS(structure[0]))));
    const real_t t8 = structure[6] - structure[1] * t7;
    const real_t t9 = structure[7] - structure[2] * t7;
    const real_t t10 = structure[8] - structure[3] * t7;
    const real_t t11 = structure[9] - structure[4] * t7;
    const real_t t12 = TB_SQRT(t8 * t8 + t9 * t9 + t10 * t10 + t11 * t11);
    const bool t13 = t0 < TB_ABS(t4) && t0 < TB_ABS(TB_COPYSIGN(t12, t8));
    const bool t14 = !t13;
    if (t14) {
        return tb_refuse_largest_tensions_eq12_begin(TB_SINGULAR, most, least, size);
    }
    most[0] = TB_C(0.0);
    most[1] = TB_C(0.0);
    most[2] = TB_C(0.0);
    most[3] = TB_C(0.0);
    most[4] = TB_C(0.0);
    least[0] = TB_C(1e+30);
    size[0] = force[0];
    return TB_OK;
}

/* One subset. */
static tb_status tb_largest_tensions_eq12_visit(const real_t chosen[2], const real_t numbers[1],
    const real_t structure[10], real_t most[5], real_t least[1])
{
    const bool t0 = numbers[0] == TB_C(0.0);
    const real_t t1 = TB_SQRT(chosen[0] * chosen[0] + chosen[1] * chosen[1]);
    const real_t t2 = TB_C(1.0) / t1;
    const real_t t3 = chosen[0] * t2;
    const real_t t4 = chosen[1] * t2;
    const real_t t5 = t0 ? TB_C(0.0) : t3 * structure[5] - t4 * structure[0];
    const real_t t6 = t0 ? TB_C(1e+30) : TB_ABS(t5);
    const real_t most_0 = tb_max(most[0], TB_C(1.0) / t6);
    const bool t7 = numbers[0] == TB_C(1.0);
    const real_t t8 = t7 ? TB_C(0.0) : t3 * structure[6] - t4 * structure[1];
    const real_t t9 = t7 ? TB_C(1e+30) : TB_ABS(t8);
    const real_t most_1 = tb_max(most[1], TB_C(1.0) / t9);
    const bool t10 = numbers[0] == TB_C(2.0);
    const real_t t11 = t10 ? TB_C(0.0) : t3 * structure[7] - t4 * structure[2];
    const real_t t12 = t10 ? TB_C(1e+30) : TB_ABS(t11);
    const real_t most_2 = tb_max(most[2], TB_C(1.0) / t12);
    const bool t13 = numbers[0] == TB_C(3.0);
    const real_t t14 = t13 ? TB_C(0.0) : t3 * structure[8] - t4 * structure[3];
    const real_t t15 = t13 ? TB_C(1e+30) : TB_ABS(t14);
    const real_t most_3 = tb_max(most[3], TB_C(1.0) / t15);
    const bool t16 = numbers[0] == TB_C(4.0);
    const real_t t17 = t16 ? TB_C(0.0) : t3 * structure[9] - t4 * structure[4];
    const real_t t18 = t16 ? TB_C(1e+30) : TB_ABS(t17);
    const real_t most_4 = tb_max(most[4], TB_C(1.0) / t18);
    const bool t19 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON) < t1;
    real_t t20;
    if (t19) {
        const real_t t21 = tb_min(tb_min(tb_min(tb_min(t6, t9), t12), t15), t18);
        t20 = t21;
    } else {
        t20 = TB_C(0.0);
    }
    const real_t least_0 = tb_min(least[0], t20);
    most[0] = most_0;
    most[1] = most_1;
    most[2] = most_2;
    most[3] = most_3;
    most[4] = most_4;
    least[0] = least_0;
    return TB_OK;
}

/* After the last subset. */
static tb_status tb_largest_tensions_eq12_finish(const real_t most[5], const real_t least[1],
    const real_t size[1], real_t tension[5])
{
    const real_t tension_0 = size[0] * most[0];
    const real_t tension_1 = size[0] * most[1];
    const real_t tension_2 = size[0] * most[2];
    const real_t tension_3 = size[0] * most[3];
    const real_t tension_4 = size[0] * most[4];
    const bool t0 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON) < least[0];
    const bool t1 = !t0;
    if (t1) {
        tension[0] = TB_C(0.0);
        tension[1] = TB_C(0.0);
        tension[2] = TB_C(0.0);
        tension[3] = TB_C(0.0);
        tension[4] = TB_C(0.0);
        return TB_SINGULAR;
    }
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    tension[4] = tension_4;
    return TB_OK;
}

tb_status tb_largest_tensions_eq12(const real_t structure[10], const real_t force[1],
    real_t tension[5])
{
    static const unsigned char subsets[5][1] = {{0}, {1}, {2}, {3}, {4}};
    real_t most[5];
    real_t least[1];
    real_t size[1];
    const tb_status status = tb_largest_tensions_eq12_begin(structure, force, most, least,
        size);
    if (status != TB_OK) {
        tension[0] = TB_C(0.0);
        tension[1] = TB_C(0.0);
        tension[2] = TB_C(0.0);
        tension[3] = TB_C(0.0);
        tension[4] = TB_C(0.0);
        return status;
    }
    for (int k = 0; k < 5; k++) {
        real_t chosen[2];
        real_t numbers[1];
        for (int j = 0; j < 1; j++) {
            const int number = subsets[k][j];
            for (int i = 0; i < 2; i++) {
                chosen[1 * i + j] = structure[5 * i + number];
            }
            numbers[j] = (real_t)number;
        }
        (void)tb_largest_tensions_eq12_visit(chosen, numbers, structure, most, least);
    }
    return tb_largest_tensions_eq12_finish(most, least, size, tension);
}

/* Refuses with a status: most is 0 N; size is 0 N. */
static tb_status tb_refuse_largest_tension_begin(tb_status status, real_t most[1],
    real_t size[1])
{
    most[0] = TB_C(0.0);
    size[0] = TB_C(0.0);
    return status;
}

/* Before the first subset. */
static tb_status tb_largest_tension_begin(const real_t structure[10], const real_t force[1],
    real_t most[1], real_t size[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) <= TB_C(40.0)
          && force[0] >= TB_C(0.0) && force[0] <= TB_C(10000.0))) {
        return tb_refuse_largest_tension_begin(TB_OUT_OF_DOMAIN, most, size);
    }
    const real_t t0 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const real_t t1 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t2 = t1 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t3 = TB_SQRT(t2 + structure[4] * structure[4]);
    const real_t t4 = TB_COPYSIGN(t3, structure[0]);
    const real_t t5 = (structure[0] + t4) * structure[5] + structure[1] * structure[6];
    const real_t t6 = t5 + structure[2] * structure[7] + structure[3] * structure[8];
    const real_t t7 = (t6 + structure[4] * structure[9]) * (TB_C(1.0) / (t3 * (t3 +
        TB_ABS(structure[0]))));
    const real_t t8 = structure[6] - structure[1] * t7;
    const real_t t9 = structure[7] - structure[2] * t7;
    const real_t t10 = structure[8] - structure[3] * t7;
    const real_t t11 = structure[9] - structure[4] * t7;
    const real_t t12 = TB_SQRT(t8 * t8 + t9 * t9 + t10 * t10 + t11 * t11);
    const bool t13 = t0 < TB_ABS(t4) && t0 < TB_ABS(TB_COPYSIGN(t12, t8));
    const bool t14 = !t13;
    if (t14) {
        return tb_refuse_largest_tension_begin(TB_SINGULAR, most, size);
    }
    most[0] = TB_C(0.0);
    size[0] = force[0];
    return TB_OK;
}

/* One subset. */
static tb_status tb_largest_tension_visit(const real_t chosen[2], const real_t numbers[1],
    const real_t structure[10], real_t most[1], const real_t size[1])
{
    const real_t t0 = TB_SQRT(chosen[0] * chosen[0] + chosen[1] * chosen[1]);
    real_t most_0;
    if (TB_C(16.0) * TB_EPSILON < t0) {
        const real_t t1 = TB_EPSILON * TB_C(64.0);
        const real_t t2 = TB_C(1.0) / t0;
        const real_t t3 = chosen[0] * t2;
        const real_t t4 = chosen[1] * t2;
        const real_t t5 = numbers[0] == TB_C(0.0) ? TB_C(0.0) : t3 * structure[5] - t4 *
            structure[0];
        const real_t t6 = numbers[0] == TB_C(1.0) ? TB_C(0.0) : t3 * structure[6] - t4 *
            structure[1];
        const real_t t7 = numbers[0] == TB_C(2.0) ? TB_C(0.0) : t3 * structure[7] - t4 *
            structure[2];
        const real_t t8 = numbers[0] == TB_C(3.0) ? TB_C(0.0) : t3 * structure[8] - t4 *
            structure[3];
        const real_t t9 = TB_ABS(t5) + TB_ABS(t6) + TB_ABS(t7) + TB_ABS(t8);
        const real_t t10 = numbers[0] == TB_C(4.0) ? TB_C(0.0) : t3 * structure[9] - t4 *
            structure[4];
        const real_t t11 = t9 + TB_ABS(t10);
        const real_t t12 = t10 + (t8 + (t7 + (t5 + t6)));
        const real_t t13 = (t11 + t12) * TB_C(0.5);
        const real_t t14 = t1 < size[0] ? TB_C(1e+30) : TB_C(0.0);
        real_t t15;
        if (t1 < t13) {
            t15 = size[0] / t13;
        } else {
            t15 = t14;
        }
        const real_t t16 = TB_C(0.5) * (t11 - t12);
        real_t t17;
        if (t1 < t16) {
            t17 = size[0] / t16;
        } else {
            t17 = t14;
        }
        most_0 = tb_max(most[0], tb_max(t15, t17));
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

tb_status tb_largest_tension(const real_t structure[10], const real_t force[1],
    real_t tension[1])
{
    static const unsigned char subsets[5][1] = {{0}, {1}, {2}, {3}, {4}};
    real_t most[1];
    real_t size[1];
    const tb_status status = tb_largest_tension_begin(structure, force, most, size);
    if (status != TB_OK) {
        tension[0] = TB_C(0.0);
        return status;
    }
    for (int k = 0; k < 5; k++) {
        real_t chosen[2];
        real_t numbers[1];
        for (int j = 0; j < 1; j++) {
            const int number = subsets[k][j];
            for (int i = 0; i < 2; i++) {
                chosen[1 * i + j] = structure[5 * i + number];
            }
            numbers[j] = (real_t)number;
        }
        (void)tb_largest_tension_visit(chosen, numbers, structure, most, size);
    }
    return tb_largest_tension_finish(most, tension);
}

