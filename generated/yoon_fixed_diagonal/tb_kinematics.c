/* Regenerate: turnbuckle generate machines/yoon_fixed_diagonal.toml --out <this folder>
 * Machine 7ea279c692dea1e9, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_kinematics.h"
#include "tb_machine.h"

tb_status tb_base_points(const real_t rails[1], real_t points[8])
{
    (void)rails;
    points[0] = TB_C(0.0);
    points[1] = TB_C(0.0);
    points[2] = TB_FRAME_X;
    points[3] = TB_C(0.0);
    points[4] = TB_FRAME_X;
    points[5] = TB_FRAME_Y;
    points[6] = TB_C(0.0);
    points[7] = TB_FRAME_Y;
    return TB_OK;
}

tb_status tb_cable_vectors(const real_t pose[2], const real_t rails[1], real_t vectors[8])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.024))) {
        vectors[0] = TB_C(0.0);
        vectors[1] = TB_C(0.0);
        vectors[2] = TB_C(0.0);
        vectors[3] = TB_C(0.0);
        vectors[4] = TB_C(0.0);
        vectors[5] = TB_C(0.0);
        vectors[6] = TB_C(0.0);
        vectors[7] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t vectors_0 = -pose[0];
    const real_t vectors_1 = -pose[1];
    const real_t vectors_2 = TB_FRAME_X - pose[0];
    const real_t vectors_5 = TB_FRAME_Y - pose[1];
    vectors[0] = vectors_0;
    vectors[1] = vectors_1;
    vectors[2] = vectors_2;
    vectors[3] = vectors_1;
    vectors[4] = vectors_2;
    vectors[5] = vectors_5;
    vectors[6] = vectors_0;
    vectors[7] = vectors_5;
    return TB_OK;
}

/* Refuses with a status: length is 0 m. */
static tb_status tb_refuse_cable_lengths(tb_status status, real_t length[4])
{
    length[0] = TB_C(0.0);
    length[1] = TB_C(0.0);
    length[2] = TB_C(0.0);
    length[3] = TB_C(0.0);
    return status;
}

tb_status tb_cable_lengths(const real_t pose[2], const real_t rails[1], real_t length[4])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.024))) {
        return tb_refuse_cable_lengths(TB_OUT_OF_DOMAIN, length);
    }
    const real_t t0 = pose[0] * pose[0];
    const real_t t1 = pose[1] * pose[1];
    const real_t length_0 = TB_SQRT(t0 + t1);
    const real_t t2 = TB_FRAME_X - pose[0];
    const real_t t3 = t2 * t2;
    const real_t length_1 = TB_SQRT(t1 + t3);
    const real_t t4 = TB_FRAME_Y - pose[1];
    const real_t t5 = t4 * t4;
    const real_t length_2 = TB_SQRT(t3 + t5);
    const real_t length_3 = TB_SQRT(t0 + t5);
    const bool t6 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t7 = t6 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t8 = !t7;
    if (t8) {
        return tb_refuse_cable_lengths(TB_SINGULAR, length);
    }
    length[0] = length_0;
    length[1] = length_1;
    length[2] = length_2;
    length[3] = length_3;
    return TB_OK;
}

/* Refuses with a status: structure is 0. */
static tb_status tb_refuse_structure_matrix(tb_status status, real_t structure[8])
{
    structure[0] = TB_C(0.0);
    structure[1] = TB_C(0.0);
    structure[2] = TB_C(0.0);
    structure[3] = TB_C(0.0);
    structure[4] = TB_C(0.0);
    structure[5] = TB_C(0.0);
    structure[6] = TB_C(0.0);
    structure[7] = TB_C(0.0);
    return status;
}

tb_status tb_structure_matrix(const real_t pose[2], const real_t rails[1], real_t structure[8])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.024))) {
        return tb_refuse_structure_matrix(TB_OUT_OF_DOMAIN, structure);
    }
    const real_t t0 = pose[0] * pose[0];
    const real_t t1 = pose[1] * pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 + t1);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t structure_0 = -(pose[0] * t2);
    const real_t t3 = TB_FRAME_X - pose[0];
    const real_t t4 = t3 * t3;
    const real_t length_1 = TB_SQRT(t1 + t4);
    const real_t t5 = TB_C(1.0) / length_1;
    const real_t structure_1 = t3 * t5;
    const real_t t6 = TB_FRAME_Y - pose[1];
    const real_t t7 = t6 * t6;
    const real_t length_2 = TB_SQRT(t4 + t7);
    const real_t t8 = TB_C(1.0) / length_2;
    const real_t structure_2 = t3 * t8;
    const real_t length_3 = TB_SQRT(t0 + t7);
    const real_t t9 = TB_C(1.0) / length_3;
    const real_t structure_3 = -(pose[0] * t9);
    const real_t structure_4 = -(pose[1] * t2);
    const real_t structure_5 = -(pose[1] * t5);
    const real_t structure_6 = t6 * t8;
    const real_t structure_7 = t6 * t9;
    const bool t10 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t11 = t10 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t12 = !t11;
    if (t12) {
        return tb_refuse_structure_matrix(TB_SINGULAR, structure);
    }
    structure[0] = structure_0;
    structure[1] = structure_1;
    structure[2] = structure_2;
    structure[3] = structure_3;
    structure[4] = structure_4;
    structure[5] = structure_5;
    structure[6] = structure_6;
    structure[7] = structure_7;
    return TB_OK;
}

/* Refuses with a status: jacobian is 0. */
static tb_status tb_refuse_length_jacobian(tb_status status, real_t jacobian[8])
{
    jacobian[0] = TB_C(0.0);
    jacobian[1] = TB_C(0.0);
    jacobian[2] = TB_C(0.0);
    jacobian[3] = TB_C(0.0);
    jacobian[4] = TB_C(0.0);
    jacobian[5] = TB_C(0.0);
    jacobian[6] = TB_C(0.0);
    jacobian[7] = TB_C(0.0);
    return status;
}

tb_status tb_length_jacobian(const real_t pose[2], const real_t rails[1], real_t jacobian[8])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.024))) {
        return tb_refuse_length_jacobian(TB_OUT_OF_DOMAIN, jacobian);
    }
    const real_t t0 = pose[0] * pose[0];
    const real_t t1 = pose[1] * pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 + t1);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t jacobian_0 = pose[0] * t2;
    const real_t jacobian_1 = pose[1] * t2;
    const real_t t3 = TB_FRAME_X - pose[0];
    const real_t t4 = t3 * t3;
    const real_t length_1 = TB_SQRT(t1 + t4);
    const real_t t5 = TB_C(1.0) / length_1;
    const real_t jacobian_2 = -(t3 * t5);
    const real_t jacobian_3 = pose[1] * t5;
    const real_t t6 = TB_FRAME_Y - pose[1];
    const real_t t7 = t6 * t6;
    const real_t length_2 = TB_SQRT(t4 + t7);
    const real_t t8 = TB_C(1.0) / length_2;
    const real_t jacobian_4 = -(t3 * t8);
    const real_t jacobian_5 = -(t6 * t8);
    const real_t length_3 = TB_SQRT(t0 + t7);
    const real_t t9 = TB_C(1.0) / length_3;
    const real_t jacobian_6 = pose[0] * t9;
    const real_t jacobian_7 = -(t6 * t9);
    const bool t10 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t11 = t10 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t12 = !t11;
    if (t12) {
        return tb_refuse_length_jacobian(TB_SINGULAR, jacobian);
    }
    jacobian[0] = jacobian_0;
    jacobian[1] = jacobian_1;
    jacobian[2] = jacobian_2;
    jacobian[3] = jacobian_3;
    jacobian[4] = jacobian_4;
    jacobian[5] = jacobian_5;
    jacobian[6] = jacobian_6;
    jacobian[7] = jacobian_7;
    return TB_OK;
}

/* Refuses with a status: velocity is 0 m/s. */
static tb_status tb_refuse_task_velocity(tb_status status, real_t velocity[2])
{
    velocity[0] = TB_C(0.0);
    velocity[1] = TB_C(0.0);
    return status;
}

tb_status tb_task_velocity(const real_t pose[2], const real_t rails[1],
    const real_t length_rates[4], const real_t rail_rates[1], real_t velocity[2])
{
    (void)rails;
    (void)rail_rates;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.024)
          && TB_ABS(length_rates[0]) + TB_ABS(length_rates[1]) + TB_ABS(length_rates[2]) +
              TB_ABS(length_rates[3]) <= TB_C(400.0))) {
        return tb_refuse_task_velocity(TB_OUT_OF_DOMAIN, velocity);
    }
    const real_t t0 = TB_FRAME_X - pose[0];
    const real_t t1 = t0 * t0;
    const real_t t2 = pose[1] * pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_1 = TB_SQRT(t1 + t2);
    const real_t t3 = TB_C(1.0) / length_1;
    const real_t t4 = t0 * t3;
    const real_t t5 = pose[0] * pose[0];
    const real_t length_0 = TB_SQRT(t2 + t5);
    const real_t t6 = TB_C(1.0) / length_0;
    const real_t t7 = pose[0] * t6;
    const real_t t8 = TB_FRAME_Y - pose[1];
    const real_t t9 = t8 * t8;
    const real_t length_2 = TB_SQRT(t1 + t9);
    const real_t t10 = TB_C(1.0) / length_2;
    const real_t t11 = t0 * t10;
    const real_t t12 = t4 * length_rates[1] - t7 * length_rates[0] + t11 * length_rates[2];
    const real_t length_3 = TB_SQRT(t5 + t9);
    const real_t t13 = TB_C(1.0) / length_3;
    const real_t t14 = pose[0] * t13;
    const real_t t15 = t12 - t14 * length_rates[3];
    const real_t t16 = t7 * t7 + t4 * t4 + t11 * t11 + t14 * t14;
    const real_t t17 = TB_C(1.0) / t16;
    const real_t t18 = pose[1] * t6;
    const real_t t19 = pose[1] * t3;
    const real_t t20 = t8 * t10;
    const real_t t21 = t8 * t13;
    const real_t t22 = t17 * (t7 * t18 - t4 * t19 + t11 * t20 - t14 * t21);
    const real_t t23 = length_rates[2] * t20 - (length_rates[0] * t18 + length_rates[1] * t19);
    const real_t t24 = t18 * t18 + t19 * t19 + t20 * t20 + t21 * t21 - t16 * (t22 * t22);
    const real_t velocity_1 = (t15 * t22 - (t23 + length_rates[3] * t21)) / t24;
    const real_t velocity_0 = -(t15 * t17 + t22 * velocity_1);
    const bool t25 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t26 = t25 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t27 = !t26;
    const real_t t28 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const bool t29 = !(t28 < t16 && t28 < t24);
    if (t27 || t29) {
        return tb_refuse_task_velocity(TB_SINGULAR, velocity);
    }
    velocity[0] = velocity_0;
    velocity[1] = velocity_1;
    return TB_OK;
}

/* Refuses with a status: pose is 0 m; residual is 0 m. */
static tb_status tb_refuse_forward_kinematics(tb_status status, real_t pose[2],
    real_t residual[1])
{
    pose[0] = TB_C(0.0);
    pose[1] = TB_C(0.0);
    residual[0] = TB_C(0.0);
    return status;
}

tb_status tb_forward_kinematics(const real_t lengths[4], const real_t rails[1], real_t pose[2],
    real_t residual[1])
{
    (void)rails;
    if (!(lengths[0] >= TB_C(0.0) && lengths[0] <= TB_C(3.16)
          && lengths[1] >= TB_C(0.0) && lengths[1] <= TB_C(3.16)
          && lengths[2] >= TB_C(0.0) && lengths[2] <= TB_C(3.16)
          && lengths[3] >= TB_C(0.0) && lengths[3] <= TB_C(3.16))) {
        return tb_refuse_forward_kinematics(TB_OUT_OF_DOMAIN, pose, residual);
    }
    const real_t t0 = TB_C(0.084173) - lengths[0] * lengths[0];
    const real_t t1 = TB_C(0.084173) - lengths[1] * lengths[1];
    const real_t t2 = TB_C(0.084173) - lengths[2] * lengths[2];
    const real_t t3 = TB_C(0.084173) - lengths[3] * lengths[3];
    const real_t t4 = (t0 + t1 + t2 + t3) * TB_C(0.25);
    const real_t t5 = t0 - t4;
    const real_t t6 = t1 - t4;
    const real_t t7 = t2 - t4;
    const real_t t8 = -TB_C(0.253) * t5 + TB_C(0.253) * t6 + TB_C(0.253) * t7;
    const real_t t9 = t3 - t4;
    const real_t t10 = (t8 + -TB_C(0.253) * t9) * TB_C(0.5) * TB_C(3.9057007608305083);
    /* differences of squared lengths are linear in the pose */
    const real_t start_0 = TB_C(0.253) + t10;
    const real_t t11 = TB_FRAME_X - start_0;
    const real_t t12 = t11 * t11;
    const real_t t13 = t5 * -TB_C(0.142) + t6 * -TB_C(0.142) + t7 * TB_C(0.142);
    const real_t t14 = TB_C(0.5) * (t13 + t9 * TB_C(0.142)) * TB_C(12.398333663955565);
    const real_t start_1 = TB_C(0.142) + t14;
    const real_t t15 = start_1 * start_1;
    /* one Gauss-Newton step */
    const real_t distance_1 = TB_SQRT(t12 + t15);
    const real_t t16 = TB_C(1.0) / distance_1;
    const real_t t17 = t11 * t16;
    const real_t t18 = distance_1 - lengths[1];
    const real_t t19 = start_0 * start_0;
    const real_t distance_0 = TB_SQRT(t15 + t19);
    const real_t t20 = TB_C(1.0) / distance_0;
    const real_t t21 = start_0 * t20;
    const real_t t22 = distance_0 - lengths[0];
    const real_t t23 = TB_FRAME_Y - start_1;
    const real_t t24 = t23 * t23;
    const real_t distance_2 = TB_SQRT(t12 + t24);
    const real_t t25 = TB_C(1.0) / distance_2;
    const real_t t26 = t11 * t25;
    const real_t t27 = distance_2 - lengths[2];
    const real_t distance_3 = TB_SQRT(t19 + t24);
    const real_t t28 = TB_C(1.0) / distance_3;
    const real_t t29 = start_0 * t28;
    const real_t t30 = distance_3 - lengths[3];
    const real_t t31 = t17 * t18 - t21 * t22 + t26 * t27 - t29 * t30;
    const real_t t32 = t21 * t21 + t17 * t17 + t26 * t26 + t29 * t29;
    const real_t t33 = TB_C(1.0) / t32;
    const real_t t34 = start_1 * t20;
    const real_t t35 = start_1 * t16;
    const real_t t36 = t23 * t25;
    const real_t t37 = t23 * t28;
    const real_t t38 = t33 * (t21 * t34 - t17 * t35 + t26 * t36 - t29 * t37);
    const real_t t39 = t27 * t36 - (t22 * t34 + t18 * t35) + t30 * t37 - t31 * t38;
    const real_t t40 = t34 * t34 + t35 * t35 + t36 * t36 + t37 * t37 - t32 * (t38 * t38);
    const real_t t41 = t39 / t40;
    const real_t pose_0 = start_0 + (t31 * t33 - t38 * t41);
    const real_t pose_1 = start_1 + t41;
    const real_t t42 = pose_0 * pose_0;
    const real_t t43 = pose_1 * pose_1;
    const real_t t44 = TB_SQRT(t42 + t43);
    /* what the lengths disagree by: slack, an encoder fault */
    const real_t misfit_0 = lengths[0] - t44;
    const real_t t45 = TB_FRAME_X - pose_0;
    const real_t t46 = t45 * t45;
    const real_t t47 = TB_SQRT(t43 + t46);
    const real_t misfit_1 = lengths[1] - t47;
    const real_t t48 = TB_FRAME_Y - pose_1;
    const real_t t49 = t48 * t48;
    const real_t t50 = TB_SQRT(t46 + t49);
    const real_t misfit_2 = lengths[2] - t50;
    const real_t t51 = misfit_0 * misfit_0 + misfit_1 * misfit_1 + misfit_2 * misfit_2;
    const real_t t52 = TB_SQRT(t42 + t49);
    const real_t misfit_3 = lengths[3] - t52;
    const real_t residual_0 = TB_SQRT(t51 + misfit_3 * misfit_3);
    const real_t t53 = TB_C(0.256036) * tb_max(TB_C(1e-08), TB_C(64.0) * TB_EPSILON);
    const bool t54 = t53 < TB_C(0.256036) && t53 < TB_C(0.08065599999999999);
    const bool t55 = !t54;
    const bool t56 = TB_C(0.0001) < distance_0 && TB_C(0.0001) < distance_1;
    const bool t57 = t56 && TB_C(0.0001) < distance_2 && TB_C(0.0001) < distance_3;
    const bool t58 = t57 && TB_C(0.0001) < t44 && TB_C(0.0001) < t47 && TB_C(0.0001) < t50;
    const bool t59 = !(t58 && TB_C(0.0001) < t52);
    if (t55 || t59) {
        return tb_refuse_forward_kinematics(TB_SINGULAR, pose, residual);
    }
    pose[0] = pose_0;
    pose[1] = pose_1;
    residual[0] = residual_0;
    return TB_OK;
}

/* Refuses with a status: pose is 0 m; residual is 0 m; structure is 0; velocity is 0 m/s. */
static tb_status tb_refuse_locate(tb_status status, real_t pose[2], real_t residual[1],
    real_t structure[8], real_t velocity[2])
{
    pose[0] = TB_C(0.0);
    pose[1] = TB_C(0.0);
    residual[0] = TB_C(0.0);
    structure[0] = TB_C(0.0);
    structure[1] = TB_C(0.0);
    structure[2] = TB_C(0.0);
    structure[3] = TB_C(0.0);
    structure[4] = TB_C(0.0);
    structure[5] = TB_C(0.0);
    structure[6] = TB_C(0.0);
    structure[7] = TB_C(0.0);
    velocity[0] = TB_C(0.0);
    velocity[1] = TB_C(0.0);
    return status;
}

tb_status tb_locate(const real_t lengths[4], const real_t rails[1],
    const real_t length_rates[4], const real_t rail_rates[1], real_t pose[2],
    real_t residual[1], real_t structure[8], real_t velocity[2])
{
    (void)rails;
    (void)rail_rates;
    if (!(lengths[0] >= TB_C(0.0) && lengths[0] <= TB_C(3.16)
          && lengths[1] >= TB_C(0.0) && lengths[1] <= TB_C(3.16)
          && lengths[2] >= TB_C(0.0) && lengths[2] <= TB_C(3.16)
          && lengths[3] >= TB_C(0.0) && lengths[3] <= TB_C(3.16)
          && TB_ABS(length_rates[0]) + TB_ABS(length_rates[1]) + TB_ABS(length_rates[2]) +
              TB_ABS(length_rates[3]) <= TB_C(400.0))) {
        return tb_refuse_locate(TB_OUT_OF_DOMAIN, pose, residual, structure, velocity);
    }
    const real_t t0 = TB_C(0.084173) - lengths[0] * lengths[0];
    const real_t t1 = TB_C(0.084173) - lengths[1] * lengths[1];
    const real_t t2 = TB_C(0.084173) - lengths[2] * lengths[2];
    const real_t t3 = TB_C(0.084173) - lengths[3] * lengths[3];
    const real_t t4 = (t0 + t1 + t2 + t3) * TB_C(0.25);
    const real_t t5 = t0 - t4;
    const real_t t6 = t1 - t4;
    const real_t t7 = t2 - t4;
    const real_t t8 = -TB_C(0.253) * t5 + TB_C(0.253) * t6 + TB_C(0.253) * t7;
    const real_t t9 = t3 - t4;
    const real_t t10 = (t8 + -TB_C(0.253) * t9) * TB_C(0.5) * TB_C(3.9057007608305083);
    /* differences of squared lengths are linear in the pose */
    const real_t start_0 = TB_C(0.253) + t10;
    const real_t t11 = TB_FRAME_X - start_0;
    const real_t t12 = t11 * t11;
    const real_t t13 = t5 * -TB_C(0.142) + t6 * -TB_C(0.142) + t7 * TB_C(0.142);
    const real_t t14 = TB_C(0.5) * (t13 + t9 * TB_C(0.142)) * TB_C(12.398333663955565);
    const real_t start_1 = TB_C(0.142) + t14;
    const real_t t15 = start_1 * start_1;
    /* one Gauss-Newton step */
    const real_t distance_1 = TB_SQRT(t12 + t15);
    const real_t t16 = TB_C(1.0) / distance_1;
    const real_t t17 = t11 * t16;
    const real_t t18 = distance_1 - lengths[1];
    const real_t t19 = start_0 * start_0;
    const real_t distance_0 = TB_SQRT(t15 + t19);
    const real_t t20 = TB_C(1.0) / distance_0;
    const real_t t21 = start_0 * t20;
    const real_t t22 = distance_0 - lengths[0];
    const real_t t23 = TB_FRAME_Y - start_1;
    const real_t t24 = t23 * t23;
    const real_t distance_2 = TB_SQRT(t12 + t24);
    const real_t t25 = TB_C(1.0) / distance_2;
    const real_t t26 = t11 * t25;
    const real_t t27 = distance_2 - lengths[2];
    const real_t distance_3 = TB_SQRT(t19 + t24);
    const real_t t28 = TB_C(1.0) / distance_3;
    const real_t t29 = start_0 * t28;
    const real_t t30 = distance_3 - lengths[3];
    const real_t t31 = t17 * t18 - t21 * t22 + t26 * t27 - t29 * t30;
    const real_t t32 = t21 * t21 + t17 * t17 + t26 * t26 + t29 * t29;
    const real_t t33 = TB_C(1.0) / t32;
    const real_t t34 = start_1 * t20;
    const real_t t35 = start_1 * t16;
    const real_t t36 = t23 * t25;
    const real_t t37 = t23 * t28;
    const real_t t38 = t33 * (t21 * t34 - t17 * t35 + t26 * t36 - t29 * t37);
    const real_t t39 = t27 * t36 - (t22 * t34 + t18 * t35) + t30 * t37 - t31 * t38;
    const real_t t40 = t34 * t34 + t35 * t35 + t36 * t36 + t37 * t37 - t32 * (t38 * t38);
    const real_t t41 = t39 / t40;
    const real_t pose_0 = start_0 + (t31 * t33 - t38 * t41);
    const real_t pose_1 = start_1 + t41;
    const real_t t42 = pose_0 * pose_0;
    const real_t t43 = pose_1 * pose_1;
    const real_t t44 = TB_SQRT(t42 + t43);
    /* what the lengths disagree by: slack, an encoder fault */
    const real_t misfit_0 = lengths[0] - t44;
    const real_t t45 = TB_FRAME_X - pose_0;
    const real_t t46 = t45 * t45;
    const real_t t47 = TB_SQRT(t43 + t46);
    const real_t misfit_1 = lengths[1] - t47;
    const real_t t48 = TB_FRAME_Y - pose_1;
    const real_t t49 = t48 * t48;
    const real_t t50 = TB_SQRT(t46 + t49);
    const real_t misfit_2 = lengths[2] - t50;
    const real_t t51 = misfit_0 * misfit_0 + misfit_1 * misfit_1 + misfit_2 * misfit_2;
    const real_t t52 = TB_SQRT(t42 + t49);
    const real_t misfit_3 = lengths[3] - t52;
    const real_t residual_0 = TB_SQRT(t51 + misfit_3 * misfit_3);
    const real_t t53 = TB_C(1.0) / t44;
    const real_t t54 = pose_0 * t53;
    const real_t structure_0 = -t54;
    const real_t t55 = TB_C(1.0) / t47;
    const real_t structure_1 = t45 * t55;
    const real_t t56 = TB_C(1.0) / t50;
    const real_t structure_2 = t45 * t56;
    const real_t t57 = TB_C(1.0) / t52;
    const real_t t58 = pose_0 * t57;
    const real_t structure_3 = -t58;
    const real_t t59 = pose_1 * t53;
    const real_t structure_4 = -t59;
    const real_t t60 = pose_1 * t55;
    const real_t structure_5 = -t60;
    const real_t structure_6 = t48 * t56;
    const real_t structure_7 = t48 * t57;
    const real_t t61 = structure_1 * length_rates[1] - t54 * length_rates[0];
    const real_t t62 = t61 + structure_2 * length_rates[2] - t58 * length_rates[3];
    const real_t t63 = t54 * t54 + structure_1 * structure_1 + structure_2 * structure_2;
    const real_t t64 = t63 + t58 * t58;
    const real_t t65 = TB_C(1.0) / t64;
    const real_t t66 = t54 * t59 - structure_1 * t60 + structure_2 * structure_6;
    const real_t t67 = t65 * (t66 - t58 * structure_7);
    const real_t t68 = structure_6 * length_rates[2] - (t59 * length_rates[0] + t60 *
        length_rates[1]);
    const real_t t69 = t62 * t67 - (t68 + structure_7 * length_rates[3]);
    const real_t t70 = t59 * t59 + t60 * t60 + structure_6 * structure_6;
    const real_t t71 = t70 + structure_7 * structure_7 - t64 * (t67 * t67);
    const real_t velocity_1 = t69 / t71;
    const real_t velocity_0 = -(t62 * t65 + t67 * velocity_1);
    const real_t t72 = TB_C(0.256036) * tb_max(TB_C(1e-08), TB_C(64.0) * TB_EPSILON);
    const bool t73 = t72 < TB_C(0.256036) && t72 < TB_C(0.08065599999999999);
    const bool t74 = !t73;
    const bool t75 = TB_C(0.0001) < distance_0 && TB_C(0.0001) < distance_1;
    const bool t76 = t75 && TB_C(0.0001) < distance_2 && TB_C(0.0001) < distance_3;
    const bool t77 = t76 && TB_C(0.0001) < t44 && TB_C(0.0001) < t47 && TB_C(0.0001) < t50;
    const bool t78 = !(t77 && TB_C(0.0001) < t52);
    const real_t t79 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t80 = !(t79 < t64 && t79 < t71);
    if (t74 || t78 || t80) {
        return tb_refuse_locate(TB_SINGULAR, pose, residual, structure, velocity);
    }
    pose[0] = pose_0;
    pose[1] = pose_1;
    residual[0] = residual_0;
    structure[0] = structure_0;
    structure[1] = structure_1;
    structure[2] = structure_2;
    structure[3] = structure_3;
    structure[4] = structure_4;
    structure[5] = structure_5;
    structure[6] = structure_6;
    structure[7] = structure_7;
    velocity[0] = velocity_0;
    velocity[1] = velocity_1;
    return TB_OK;
}

