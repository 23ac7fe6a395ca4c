/* Regenerate: turnbuckle generate machines/spidar_g.toml --out <this folder>
 * Machine 4d479a9b3a2bb17c, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_control.h"
#include "tb_machine.h"

tb_status tb_motor_torques(const real_t tension[8], real_t torque[8])
{
    if (!(TB_ABS(tension[0]) + TB_ABS(tension[1]) + TB_ABS(tension[2]) + TB_ABS(tension[3]) +
              TB_ABS(tension[4]) + TB_ABS(tension[5]) + TB_ABS(tension[6]) + TB_ABS(tension[7])
              <= TB_C(64000.0))) {
        torque[0] = TB_C(0.0);
        torque[1] = TB_C(0.0);
        torque[2] = TB_C(0.0);
        torque[3] = TB_C(0.0);
        torque[4] = TB_C(0.0);
        torque[5] = TB_C(0.0);
        torque[6] = TB_C(0.0);
        torque[7] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t torque_0 = TB_DRUM_RADIUS * tension[0];
    const real_t torque_1 = TB_DRUM_RADIUS * tension[1];
    const real_t torque_2 = TB_DRUM_RADIUS * tension[2];
    const real_t torque_3 = TB_DRUM_RADIUS * tension[3];
    const real_t torque_4 = TB_DRUM_RADIUS * tension[4];
    const real_t torque_5 = TB_DRUM_RADIUS * tension[5];
    const real_t torque_6 = TB_DRUM_RADIUS * tension[6];
    const real_t torque_7 = TB_DRUM_RADIUS * tension[7];
    torque[0] = torque_0;
    torque[1] = torque_1;
    torque[2] = torque_2;
    torque[3] = torque_3;
    torque[4] = torque_4;
    torque[5] = torque_5;
    torque[6] = torque_6;
    torque[7] = torque_7;
    return TB_OK;
}

tb_status tb_wall_force(const real_t pose[6], const real_t velocity[6], real_t force[6])
{
    if (!(pose[0] >= -TB_C(1.2) && pose[0] <= TB_C(1.2)
          && pose[1] >= -TB_C(1.2) && pose[1] <= TB_C(1.2)
          && pose[2] >= -TB_C(1.2) && pose[2] <= TB_C(1.2)
          && pose[3] >= -TB_C(1.5471975511965979) && pose[3] <= TB_C(1.5471975511965979)
          && pose[4] >= -TB_C(1.5471975511965979) && pose[4] <= TB_C(1.5471975511965979)
          && pose[5] >= -TB_C(1.5471975511965979) && pose[5] <= TB_C(1.5471975511965979)
          && TB_ABS(velocity[0]) + TB_ABS(velocity[1]) + TB_ABS(velocity[2]) +
              TB_ABS(velocity[3]) + TB_ABS(velocity[4]) + TB_ABS(velocity[5]) <= TB_C(600.0))) {
        force[0] = TB_C(0.0);
        force[1] = TB_C(0.0);
        force[2] = TB_C(0.0);
        force[3] = TB_C(0.0);
        force[4] = TB_C(0.0);
        force[5] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    force[0] = TB_C(0.0);
    force[1] = TB_C(0.0);
    force[2] = TB_C(0.0);
    force[3] = TB_C(0.0);
    force[4] = TB_C(0.0);
    force[5] = TB_C(0.0);
    return TB_OK;
}

/* Refuses with a status: load is 0.5 N. */
static tb_status tb_refuse_load_tension(tb_status status, real_t load[8])
{
    load[0] = TB_TENSION_MIN;
    load[1] = TB_TENSION_MIN;
    load[2] = TB_TENSION_MIN;
    load[3] = TB_TENSION_MIN;
    load[4] = TB_TENSION_MIN;
    load[5] = TB_TENSION_MIN;
    load[6] = TB_TENSION_MIN;
    load[7] = TB_TENSION_MIN;
    return status;
}

tb_status tb_load_tension(const real_t structure[48], const real_t tension[8],
    const real_t hand_force[6], real_t load[8])
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
          && TB_ABS(tension[0]) + TB_ABS(tension[1]) + TB_ABS(tension[2]) + TB_ABS(tension[3])
              + TB_ABS(tension[4]) + TB_ABS(tension[5]) + TB_ABS(tension[6]) +
              TB_ABS(tension[7]) <= TB_C(64000.0)
          && TB_ABS(hand_force[0]) + TB_ABS(hand_force[1]) + TB_ABS(hand_force[2]) +
              TB_ABS(hand_force[3]) + TB_ABS(hand_force[4]) + TB_ABS(hand_force[5]) <=
              TB_C(384000.0))) {
        return tb_refuse_load_tension(TB_OUT_OF_DOMAIN, load);
    }
    const real_t t0 = structure[8] * structure[0] + structure[9] * structure[1];
    const real_t t1 = t0 + structure[10] * structure[2] + structure[11] * structure[3];
    const real_t t2 = t1 + structure[12] * structure[4] + structure[13] * structure[5];
    const real_t t3 = t2 + structure[14] * structure[6] + structure[15] * structure[7];
    const real_t t4 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t5 = t4 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t6 = t5 + structure[4] * structure[4] + structure[5] * structure[5];
    const real_t t7 = t6 + structure[6] * structure[6] + structure[7] * structure[7];
    const real_t t8 = TB_C(1.0) / t7;
    const real_t t9 = t3 * t8;
    const real_t t10 = tension[0] * structure[0] + structure[1] * tension[1];
    const real_t t11 = t10 + structure[2] * tension[2] + structure[3] * tension[3];
    const real_t t12 = t11 + structure[4] * tension[4] + structure[5] * tension[5];
    const real_t t13 = t12 + structure[6] * tension[6] + structure[7] * tension[7];
    const real_t t14 = hand_force[0] + t13;
    const real_t t15 = tension[0] * structure[8] + structure[9] * tension[1];
    const real_t t16 = t15 + structure[10] * tension[2] + structure[11] * tension[3];
    const real_t t17 = t16 + structure[12] * tension[4] + structure[13] * tension[5];
    const real_t t18 = t17 + structure[14] * tension[6] + structure[15] * tension[7];
    const real_t t19 = t9 * t14 - (hand_force[1] + t18);
    const real_t t20 = structure[8] * structure[8] + structure[9] * structure[9];
    const real_t t21 = t20 + structure[10] * structure[10] + structure[11] * structure[11];
    const real_t t22 = t21 + structure[12] * structure[12] + structure[13] * structure[13];
    const real_t t23 = t22 + structure[14] * structure[14] + structure[15] * structure[15];
    const real_t t24 = t23 - t7 * (t9 * t9);
    const real_t t25 = TB_C(1.0) / t24;
    const real_t t26 = structure[8] * structure[16] + structure[9] * structure[17];
    const real_t t27 = t26 + structure[10] * structure[18] + structure[11] * structure[19];
    const real_t t28 = t27 + structure[12] * structure[20] + structure[13] * structure[21];
    const real_t t29 = t28 + structure[14] * structure[22] + structure[15] * structure[23];
    const real_t t30 = structure[0] * structure[16] + structure[1] * structure[17];
    const real_t t31 = t30 + structure[2] * structure[18] + structure[3] * structure[19];
    const real_t t32 = t31 + structure[4] * structure[20] + structure[5] * structure[21];
    const real_t t33 = t32 + structure[6] * structure[22] + structure[7] * structure[23];
    const real_t t34 = t8 * t33;
    const real_t t35 = t25 * (t29 - t7 * (t9 * t34));
    const real_t t36 = tension[0] * structure[16] + tension[1] * structure[17];
    const real_t t37 = t36 + tension[2] * structure[18] + tension[3] * structure[19];
    const real_t t38 = t37 + tension[4] * structure[20] + tension[5] * structure[21];
    const real_t t39 = t38 + tension[6] * structure[22] + tension[7] * structure[23];
    const real_t t40 = t14 * t34 - (hand_force[2] + t39) - t19 * t35;
    const real_t t41 = structure[16] * structure[16] + structure[17] * structure[17];
    const real_t t42 = t41 + structure[18] * structure[18] + structure[19] * structure[19];
    const real_t t43 = t42 + structure[20] * structure[20] + structure[21] * structure[21];
    const real_t t44 = t43 + structure[22] * structure[22] + structure[23] * structure[23];
    const real_t t45 = t44 - t7 * (t34 * t34) - t24 * (t35 * t35);
    const real_t t46 = TB_C(1.0) / t45;
    const real_t t47 = structure[24] * TB_MOMENT_WEIGHT;
    const real_t t48 = TB_MOMENT_WEIGHT * structure[25];
    const real_t t49 = TB_MOMENT_WEIGHT * structure[26];
    const real_t t50 = structure[16] * t47 + structure[17] * t48 + structure[18] * t49;
    const real_t t51 = TB_MOMENT_WEIGHT * structure[27];
    const real_t t52 = TB_MOMENT_WEIGHT * structure[28];
    const real_t t53 = TB_MOMENT_WEIGHT * structure[29];
    const real_t t54 = t50 + structure[19] * t51 + structure[20] * t52 + structure[21] * t53;
    const real_t t55 = TB_MOMENT_WEIGHT * structure[30];
    const real_t t56 = TB_MOMENT_WEIGHT * structure[31];
    const real_t t57 = structure[0] * t47 + structure[1] * t48 + structure[2] * t49;
    const real_t t58 = t57 + structure[3] * t51 + structure[4] * t52 + structure[5] * t53;
    const real_t t59 = t8 * (t58 + structure[6] * t55 + structure[7] * t56);
    const real_t t60 = t54 + structure[22] * t55 + structure[23] * t56 - t7 * (t34 * t59);
    const real_t t61 = structure[8] * t47 + structure[9] * t48 + structure[10] * t49;
    const real_t t62 = t61 + structure[11] * t51 + structure[12] * t52 + structure[13] * t53;
    const real_t t63 = t62 + structure[14] * t55 + structure[15] * t56 - t7 * (t9 * t59);
    const real_t t64 = t25 * t63;
    const real_t t65 = t46 * (t60 - t24 * (t35 * t64));
    const real_t t66 = tension[0] * structure[24] + tension[1] * structure[25];
    const real_t t67 = t66 + tension[2] * structure[26] + tension[3] * structure[27];
    const real_t t68 = t67 + tension[4] * structure[28] + tension[5] * structure[29];
    const real_t t69 = t68 + tension[6] * structure[30] + tension[7] * structure[31];
    const real_t t70 = t14 * t59 - TB_MOMENT_WEIGHT * (hand_force[3] + t69);
    const real_t t71 = t70 - t19 * t64 - t40 * t65;
    const real_t t72 = t47 * t47 + t48 * t48 + t49 * t49 + t51 * t51 + t52 * t52;
    const real_t t73 = t72 + t53 * t53 + t55 * t55 + t56 * t56 - t7 * (t59 * t59);
    const real_t t74 = t73 - t24 * (t64 * t64) - t45 * (t65 * t65);
    const real_t t75 = TB_C(1.0) / t74;
    const real_t t76 = TB_MOMENT_WEIGHT * structure[32];
    const real_t t77 = TB_MOMENT_WEIGHT * structure[33];
    const real_t t78 = TB_MOMENT_WEIGHT * structure[34];
    const real_t t79 = TB_MOMENT_WEIGHT * structure[35];
    const real_t t80 = TB_MOMENT_WEIGHT * structure[36];
    const real_t t81 = t47 * t76 + t48 * t77 + t49 * t78 + t51 * t79 + t52 * t80;
    const real_t t82 = TB_MOMENT_WEIGHT * structure[37];
    const real_t t83 = TB_MOMENT_WEIGHT * structure[38];
    const real_t t84 = TB_MOMENT_WEIGHT * structure[39];
    const real_t t85 = structure[0] * t76 + structure[1] * t77 + structure[2] * t78;
    const real_t t86 = t85 + structure[3] * t79 + structure[4] * t80 + structure[5] * t82;
    const real_t t87 = t8 * (t86 + structure[6] * t83 + structure[7] * t84);
    const real_t t88 = t81 + t53 * t82 + t55 * t83 + t56 * t84 - t7 * (t59 * t87);
    const real_t t89 = structure[8] * t76 + structure[9] * t77 + structure[10] * t78;
    const real_t t90 = t89 + structure[11] * t79 + structure[12] * t80 + structure[13] * t82;
    const real_t t91 = t90 + structure[14] * t83 + structure[15] * t84 - t7 * (t9 * t87);
    const real_t t92 = t25 * t91;
    const real_t t93 = structure[16] * t76 + structure[17] * t77 + structure[18] * t78;
    const real_t t94 = t93 + structure[19] * t79 + structure[20] * t80 + structure[21] * t82;
    const real_t t95 = t94 + structure[22] * t83 + structure[23] * t84 - t7 * (t34 * t87);
    const real_t t96 = t46 * (t95 - t24 * (t35 * t92));
    const real_t t97 = t75 * (t88 - t24 * (t64 * t92) - t45 * (t65 * t96));
    const real_t t98 = tension[0] * structure[32] + tension[1] * structure[33];
    const real_t t99 = t98 + tension[2] * structure[34] + tension[3] * structure[35];
    const real_t t100 = t99 + tension[4] * structure[36] + tension[5] * structure[37];
    const real_t t101 = t100 + tension[6] * structure[38] + tension[7] * structure[39];
    const real_t t102 = t14 * t87 - TB_MOMENT_WEIGHT * (hand_force[4] + t101);
    const real_t t103 = t102 - t19 * t92 - t40 * t96 - t71 * t97;
    const real_t t104 = t76 * t76 + t77 * t77 + t78 * t78 + t79 * t79 + t80 * t80;
    const real_t t105 = t104 + t82 * t82 + t83 * t83 + t84 * t84 - t7 * (t87 * t87);
    const real_t t106 = t105 - t24 * (t92 * t92) - t45 * (t96 * t96) - t74 * (t97 * t97);
    const real_t t107 = TB_C(1.0) / t106;
    const real_t t108 = TB_MOMENT_WEIGHT * structure[40];
    const real_t t109 = TB_MOMENT_WEIGHT * structure[41];
    const real_t t110 = TB_MOMENT_WEIGHT * structure[42];
    const real_t t111 = TB_MOMENT_WEIGHT * structure[43];
    const real_t t112 = t76 * t108 + t77 * t109 + t78 * t110 + t79 * t111;
    const real_t t113 = TB_MOMENT_WEIGHT * structure[44];
    const real_t t114 = TB_MOMENT_WEIGHT * structure[45];
    const real_t t115 = TB_MOMENT_WEIGHT * structure[46];
    const real_t t116 = TB_MOMENT_WEIGHT * structure[47];
    const real_t t117 = t112 + t80 * t113 + t82 * t114 + t83 * t115 + t84 * t116;
    const real_t t118 = structure[0] * t108 + structure[1] * t109 + structure[2] * t110;
    const real_t t119 = t118 + structure[3] * t111 + structure[4] * t113 + structure[5] * t114;
    const real_t t120 = t8 * (t119 + structure[6] * t115 + structure[7] * t116);
    const real_t t121 = structure[8] * t108 + structure[9] * t109 + structure[10] * t110;
    const real_t t122 = t121 + structure[11] * t111 + structure[12] * t113;
    const real_t t123 = t122 + structure[13] * t114 + structure[14] * t115;
    const real_t t124 = t25 * (t123 + structure[15] * t116 - t7 * (t9 * t120));
    const real_t t125 = structure[16] * t108 + structure[17] * t109 + structure[18] * t110;
    const real_t t126 = t125 + structure[19] * t111 + structure[20] * t113;
    const real_t t127 = t126 + structure[21] * t114 + structure[22] * t115;
    const real_t t128 = t127 + structure[23] * t116 - t7 * (t34 * t120) - t24 * (t35 * t124);
    const real_t t129 = t46 * t128;
    const real_t t130 = t117 - t7 * (t87 * t120) - t24 * (t92 * t124) - t45 * (t96 * t129);
    const real_t t131 = t47 * t108 + t48 * t109 + t49 * t110 + t51 * t111;
    const real_t t132 = t131 + t52 * t113 + t53 * t114 + t55 * t115 + t56 * t116;
    const real_t t133 = t132 - t7 * (t59 * t120) - t24 * (t64 * t124) - t45 * (t65 * t129);
    const real_t t134 = t75 * t133;
    const real_t t135 = t107 * (t130 - t74 * (t97 * t134));
    const real_t t136 = tension[0] * structure[40] + tension[1] * structure[41];
    const real_t t137 = t136 + tension[2] * structure[42] + tension[3] * structure[43];
    const real_t t138 = t137 + tension[4] * structure[44] + tension[5] * structure[45];
    const real_t t139 = t138 + tension[6] * structure[46] + tension[7] * structure[47];
    const real_t t140 = t14 * t120 - TB_MOMENT_WEIGHT * (hand_force[5] + t139);
    const real_t t141 = t140 - t19 * t124 - t40 * t129 - t71 * t134 - t103 * t135;
    const real_t t142 = t108 * t108 + t109 * t109 + t110 * t110 + t111 * t111;
    const real_t t143 = t142 + t113 * t113 + t114 * t114 + t115 * t115 + t116 * t116;
    const real_t t144 = t143 - t7 * (t120 * t120) - t24 * (t124 * t124) - t45 * (t129 * t129);
    const real_t t145 = t144 - t74 * (t134 * t134) - t106 * (t135 * t135);
    const real_t t146 = t141 / t145;
    const real_t t147 = t103 * t107 - t135 * t146;
    const real_t t148 = t71 * t75 - t97 * t147 - t134 * t146;
    const real_t t149 = t40 * t46 - t65 * t148 - t96 * t147 - t129 * t146;
    const real_t t150 = t19 * t25 - t35 * t149 - t64 * t148 - t92 * t147 - t124 * t146;
    const real_t t151 = t8 * t14 + t9 * t150 + t34 * t149 + t59 * t148 + t87 * t147;
    const real_t t152 = t151 + t120 * t146;
    const real_t t153 = structure[8] * t150 - structure[0] * t152 + structure[16] * t149;
    const real_t load_0 = tension[0] + (t153 + t47 * t148 + t76 * t147 + t108 * t146);
    const real_t t154 = structure[9] * t150 - structure[1] * t152 + structure[17] * t149;
    const real_t load_1 = tension[1] + (t154 + t48 * t148 + t77 * t147 + t109 * t146);
    const real_t t155 = structure[10] * t150 - structure[2] * t152 + structure[18] * t149;
    const real_t load_2 = tension[2] + (t155 + t49 * t148 + t78 * t147 + t110 * t146);
    const real_t t156 = structure[11] * t150 - structure[3] * t152 + structure[19] * t149;
    const real_t load_3 = tension[3] + (t156 + t51 * t148 + t79 * t147 + t111 * t146);
    const real_t t157 = structure[12] * t150 - structure[4] * t152 + structure[20] * t149;
    const real_t load_4 = tension[4] + (t157 + t52 * t148 + t80 * t147 + t113 * t146);
    const real_t t158 = structure[13] * t150 - structure[5] * t152 + structure[21] * t149;
    const real_t load_5 = tension[5] + (t158 + t53 * t148 + t82 * t147 + t114 * t146);
    const real_t t159 = structure[14] * t150 - structure[6] * t152 + structure[22] * t149;
    const real_t load_6 = tension[6] + (t159 + t55 * t148 + t83 * t147 + t115 * t146);
    const real_t t160 = structure[15] * t150 - structure[7] * t152 + structure[23] * t149;
    const real_t load_7 = tension[7] + (t160 + t56 * t148 + t84 * t147 + t116 * t146);
    const real_t t161 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const bool t162 = t161 < t7 && t161 < t24 && t161 < t45 && t161 < t74;
    const bool t163 = !(t162 && t161 < t106 && t161 < t145);
    if (t163) {
        return tb_refuse_load_tension(TB_SINGULAR, load);
    }
    load[0] = load_0;
    load[1] = load_1;
    load[2] = load_2;
    load[3] = load_3;
    load[4] = load_4;
    load[5] = load_5;
    load[6] = load_6;
    load[7] = load_7;
    return TB_OK;
}

