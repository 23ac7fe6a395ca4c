/* Regenerate: turnbuckle generate machines/brau_square.toml --out <this folder>
 * Machine 166f8b7fcb339437, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_kinematics.h"
#include "tb_machine.h"

tb_status tb_base_points(const real_t rails[1], real_t points[8])
{
    (void)rails;
    points[0] = TB_C(0.0);
    points[1] = TB_C(0.0);
    points[2] = TB_FRAME;
    points[3] = TB_C(0.0);
    points[4] = TB_FRAME;
    points[5] = TB_FRAME;
    points[6] = TB_C(0.0);
    points[7] = TB_FRAME;
    return TB_OK;
}

tb_status tb_cable_vectors(const real_t pose[2], const real_t rails[1], real_t vectors[8])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0))) {
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
    const real_t vectors_2 = TB_FRAME - pose[0];
    const real_t vectors_5 = TB_FRAME - pose[1];
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
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0))) {
        return tb_refuse_cable_lengths(TB_OUT_OF_DOMAIN, length);
    }
    const real_t t0 = pose[0] * pose[0];
    const real_t t1 = pose[1] * pose[1];
    const real_t length_0 = TB_SQRT(t0 + t1);
    const real_t t2 = TB_FRAME - pose[0];
    const real_t t3 = t2 * t2;
    const real_t length_1 = TB_SQRT(t1 + t3);
    const real_t t4 = TB_FRAME - pose[1];
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
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0))) {
        return tb_refuse_structure_matrix(TB_OUT_OF_DOMAIN, structure);
    }
    const real_t t0 = pose[0] * pose[0];
    const real_t t1 = pose[1] * pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 + t1);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t structure_0 = -(pose[0] * t2);
    const real_t t3 = TB_FRAME - pose[0];
    const real_t t4 = t3 * t3;
    const real_t length_1 = TB_SQRT(t1 + t4);
    const real_t t5 = TB_C(1.0) / length_1;
    const real_t structure_1 = t3 * t5;
    const real_t t6 = TB_FRAME - pose[1];
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
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0))) {
        return tb_refuse_length_jacobian(TB_OUT_OF_DOMAIN, jacobian);
    }
    const real_t t0 = pose[0] * pose[0];
    const real_t t1 = pose[1] * pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 + t1);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t jacobian_0 = pose[0] * t2;
    const real_t jacobian_1 = pose[1] * t2;
    const real_t t3 = TB_FRAME - pose[0];
    const real_t t4 = t3 * t3;
    const real_t length_1 = TB_SQRT(t1 + t4);
    const real_t t5 = TB_C(1.0) / length_1;
    const real_t jacobian_2 = -(t3 * t5);
    const real_t jacobian_3 = pose[1] * t5;
    const real_t t6 = TB_FRAME - pose[1];
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
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0)
          && TB_ABS(length_rates[0]) + TB_ABS(length_rates[1]) + TB_ABS(length_rates[2]) +
              TB_ABS(length_rates[3]) <= TB_C(400.0))) {
        return tb_refuse_task_velocity(TB_OUT_OF_DOMAIN, velocity);
    }
    const real_t t0 = TB_FRAME - pose[0];
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
    const real_t t8 = TB_FRAME - pose[1];
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
    if (!(lengths[0] >= TB_C(0.0) && lengths[0] <= TB_C(8.0)
          && lengths[1] >= TB_C(0.0) && lengths[1] <= TB_C(8.0)
          && lengths[2] >= TB_C(0.0) && lengths[2] <= TB_C(8.0)
          && lengths[3] >= TB_C(0.0) && lengths[3] <= TB_C(8.0))) {
        return tb_refuse_forward_kinematics(TB_OUT_OF_DOMAIN, pose, residual);
    }
    const real_t t0 = TB_C(0.5) - lengths[0] * lengths[0];
    const real_t t1 = TB_C(0.5) - lengths[1] * lengths[1];
    const real_t t2 = TB_C(0.5) - lengths[2] * lengths[2];
    const real_t t3 = TB_C(0.5) - lengths[3] * lengths[3];
    const real_t t4 = (t0 + t1 + t2 + t3) * TB_C(0.25);
    const real_t t5 = -TB_C(0.5) * (t0 - t4);
    const real_t t6 = t1 - t4;
    const real_t t7 = TB_C(0.5) * (t2 - t4);
    const real_t t8 = t3 - t4;
    const real_t t9 = TB_C(0.5) * (t5 + TB_C(0.5) * t6 + t7 + -TB_C(0.5) * t8);
    /* differences of squared lengths are linear in the pose */
    const real_t start_0 = TB_C(0.5) + t9;
    const real_t t10 = TB_FRAME - start_0;
    const real_t t11 = t10 * t10;
    const real_t t12 = TB_C(0.5) * (t7 + (t5 + -TB_C(0.5) * t6) + TB_C(0.5) * t8);
    const real_t start_1 = TB_C(0.5) + t12;
    const real_t t13 = start_1 * start_1;
    /* one Gauss-Newton step */
    const real_t distance_1 = TB_SQRT(t11 + t13);
    const real_t t14 = TB_C(1.0) / distance_1;
    const real_t t15 = t10 * t14;
    const real_t t16 = distance_1 - lengths[1];
    const real_t t17 = start_0 * start_0;
    const real_t distance_0 = TB_SQRT(t13 + t17);
    const real_t t18 = TB_C(1.0) / distance_0;
    const real_t t19 = start_0 * t18;
    const real_t t20 = distance_0 - lengths[0];
    const real_t t21 = TB_FRAME - start_1;
    const real_t t22 = t21 * t21;
    const real_t distance_2 = TB_SQRT(t11 + t22);
    const real_t t23 = TB_C(1.0) / distance_2;
    const real_t t24 = t10 * t23;
    const real_t t25 = distance_2 - lengths[2];
    const real_t distance_3 = TB_SQRT(t17 + t22);
    const real_t t26 = TB_C(1.0) / distance_3;
    const real_t t27 = start_0 * t26;
    const real_t t28 = distance_3 - lengths[3];
    const real_t t29 = t15 * t16 - t19 * t20 + t24 * t25 - t27 * t28;
    const real_t t30 = t19 * t19 + t15 * t15 + t24 * t24 + t27 * t27;
    const real_t t31 = TB_C(1.0) / t30;
    const real_t t32 = start_1 * t18;
    const real_t t33 = start_1 * t14;
    const real_t t34 = t21 * t23;
    const real_t t35 = t21 * t26;
    const real_t t36 = t31 * (t19 * t32 - t15 * t33 + t24 * t34 - t27 * t35);
    const real_t t37 = t25 * t34 - (t20 * t32 + t16 * t33) + t28 * t35 - t29 * t36;
    const real_t t38 = t32 * t32 + t33 * t33 + t34 * t34 + t35 * t35 - t30 * (t36 * t36);
    const real_t t39 = t37 / t38;
    const real_t pose_0 = start_0 + (t29 * t31 - t36 * t39);
    const real_t pose_1 = start_1 + t39;
    const real_t t40 = pose_0 * pose_0;
    const real_t t41 = pose_1 * pose_1;
    const real_t t42 = TB_SQRT(t40 + t41);
    /* what the lengths disagree by: slack, an encoder fault */
    const real_t misfit_0 = lengths[0] - t42;
    const real_t t43 = TB_FRAME - pose_0;
    const real_t t44 = t43 * t43;
    const real_t t45 = TB_SQRT(t41 + t44);
    const real_t misfit_1 = lengths[1] - t45;
    const real_t t46 = TB_FRAME - pose_1;
    const real_t t47 = t46 * t46;
    const real_t t48 = TB_SQRT(t44 + t47);
    const real_t misfit_2 = lengths[2] - t48;
    const real_t t49 = misfit_0 * misfit_0 + misfit_1 * misfit_1 + misfit_2 * misfit_2;
    const real_t t50 = TB_SQRT(t40 + t47);
    const real_t misfit_3 = lengths[3] - t50;
    const real_t residual_0 = TB_SQRT(t49 + misfit_3 * misfit_3);
    const bool t51 = tb_max(TB_C(1e-08), TB_C(64.0) * TB_EPSILON) < TB_C(1.0);
    const bool t52 = !t51;
    const bool t53 = TB_C(0.0001) < distance_0 && TB_C(0.0001) < distance_1;
    const bool t54 = t53 && TB_C(0.0001) < distance_2 && TB_C(0.0001) < distance_3;
    const bool t55 = t54 && TB_C(0.0001) < t42 && TB_C(0.0001) < t45 && TB_C(0.0001) < t48;
    const bool t56 = !(t55 && TB_C(0.0001) < t50);
    if (t52 || t56) {
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
    if (!(lengths[0] >= TB_C(0.0) && lengths[0] <= TB_C(8.0)
          && lengths[1] >= TB_C(0.0) && lengths[1] <= TB_C(8.0)
          && lengths[2] >= TB_C(0.0) && lengths[2] <= TB_C(8.0)
          && lengths[3] >= TB_C(0.0) && lengths[3] <= TB_C(8.0)
          && TB_ABS(length_rates[0]) + TB_ABS(length_rates[1]) + TB_ABS(length_rates[2]) +
              TB_ABS(length_rates[3]) <= TB_C(400.0))) {
        return tb_refuse_locate(TB_OUT_OF_DOMAIN, pose, residual, structure, velocity);
    }
    const real_t t0 = TB_C(0.5) - lengths[0] * lengths[0];
    const real_t t1 = TB_C(0.5) - lengths[1] * lengths[1];
    const real_t t2 = TB_C(0.5) - lengths[2] * lengths[2];
    const real_t t3 = TB_C(0.5) - lengths[3] * lengths[3];
    const real_t t4 = (t0 + t1 + t2 + t3) * TB_C(0.25);
    const real_t t5 = -TB_C(0.5) * (t0 - t4);
    const real_t t6 = t1 - t4;
    const real_t t7 = TB_C(0.5) * (t2 - t4);
    const real_t t8 = t3 - t4;
    const real_t t9 = TB_C(0.5) * (t5 + TB_C(0.5) * t6 + t7 + -TB_C(0.5) * t8);
    /* differences of squared lengths are linear in the pose */
    const real_t start_0 = TB_C(0.5) + t9;
    const real_t t10 = TB_FRAME - start_0;
    const real_t t11 = t10 * t10;
    const real_t t12 = TB_C(0.5) * (t7 + (t5 + -TB_C(0.5) * t6) + TB_C(0.5) * t8);
    const real_t start_1 = TB_C(0.5) + t12;
    const real_t t13 = start_1 * start_1;
    /* one Gauss-Newton step */
    const real_t distance_1 = TB_SQRT(t11 + t13);
    const real_t t14 = TB_C(1.0) / distance_1;
    const real_t t15 = t10 * t14;
    const real_t t16 = distance_1 - lengths[1];
    const real_t t17 = start_0 * start_0;
    const real_t distance_0 = TB_SQRT(t13 + t17);
    const real_t t18 = TB_C(1.0) / distance_0;
    const real_t t19 = start_0 * t18;
    const real_t t20 = distance_0 - lengths[0];
    const real_t t21 = TB_FRAME - start_1;
    const real_t t22 = t21 * t21;
    const real_t distance_2 = TB_SQRT(t11 + t22);
    const real_t t23 = TB_C(1.0) / distance_2;
    const real_t t24 = t10 * t23;
    const real_t t25 = distance_2 - lengths[2];
    const real_t distance_3 = TB_SQRT(t17 + t22);
    const real_t t26 = TB_C(1.0) / distance_3;
    const real_t t27 = start_0 * t26;
    const real_t t28 = distance_3 - lengths[3];
    const real_t t29 = t15 * t16 - t19 * t20 + t24 * t25 - t27 * t28;
    const real_t t30 = t19 * t19 + t15 * t15 + t24 * t24 + t27 * t27;
    const real_t t31 = TB_C(1.0) / t30;
    const real_t t32 = start_1 * t18;
    const real_t t33 = start_1 * t14;
    const real_t t34 = t21 * t23;
    const real_t t35 = t21 * t26;
    const real_t t36 = t31 * (t19 * t32 - t15 * t33 + t24 * t34 - t27 * t35);
    const real_t t37 = t25 * t34 - (t20 * t32 + t16 * t33) + t28 * t35 - t29 * t36;
    const real_t t38 = t32 * t32 + t33 * t33 + t34 * t34 + t35 * t35 - t30 * (t36 * t36);
    const real_t t39 = t37 / t38;
    const real_t pose_0 = start_0 + (t29 * t31 - t36 * t39);
    const real_t pose_1 = start_1 + t39;
    const real_t t40 = pose_0 * pose_0;
    const real_t t41 = pose_1 * pose_1;
    const real_t t42 = TB_SQRT(t40 + t41);
    /* what the lengths disagree by: slack, an encoder fault */
    const real_t misfit_0 = lengths[0] - t42;
    const real_t t43 = TB_FRAME - pose_0;
    const real_t t44 = t43 * t43;
    const real_t t45 = TB_SQRT(t41 + t44);
    const real_t misfit_1 = lengths[1] - t45;
    const real_t t46 = TB_FRAME - pose_1;
    const real_t t47 = t46 * t46;
    const real_t t48 = TB_SQRT(t44 + t47);
    const real_t misfit_2 = lengths[2] - t48;
    const real_t t49 = misfit_0 * misfit_0 + misfit_1 * misfit_1 + misfit_2 * misfit_2;
    const real_t t50 = TB_SQRT(t40 + t47);
    const real_t misfit_3 = lengths[3] - t50;
    const real_t residual_0 = TB_SQRT(t49 + misfit_3 * misfit_3);
    const real_t t51 = TB_C(1.0) / t42;
    const real_t t52 = pose_0 * t51;
    const real_t structure_0 = -t52;
    const real_t t53 = TB_C(1.0) / t45;
    const real_t structure_1 = t43 * t53;
    const real_t t54 = TB_C(1.0) / t48;
    const real_t structure_2 = t43 * t54;
    const real_t t55 = TB_C(1.0) / t50;
    const real_t t56 = pose_0 * t55;
    const real_t structure_3 = -t56;
    const real_t t57 = pose_1 * t51;
    const real_t structure_4 = -t57;
    const real_t t58 = pose_1 * t53;
    const real_t structure_5 = -t58;
    const real_t structure_6 = t46 * t54;
    const real_t structure_7 = t46 * t55;
    const real_t t59 = structure_1 * length_rates[1] - t52 * length_rates[0];
    const real_t t60 = t59 + structure_2 * length_rates[2] - t56 * length_rates[3];
    const real_t t61 = t52 * t52 + structure_1 * structure_1 + structure_2 * structure_2;
    const real_t t62 = t61 + t56 * t56;
    const real_t t63 = TB_C(1.0) / t62;
    const real_t t64 = t52 * t57 - structure_1 * t58 + structure_2 * structure_6;
    const real_t t65 = t63 * (t64 - t56 * structure_7);
    const real_t t66 = structure_6 * length_rates[2] - (t57 * length_rates[0] + t58 *
        length_rates[1]);
    const real_t t67 = t60 * t65 - (t66 + structure_7 * length_rates[3]);
    const real_t t68 = t57 * t57 + t58 * t58 + structure_6 * structure_6;
    const real_t t69 = t68 + structure_7 * structure_7 - t62 * (t65 * t65);
    const real_t velocity_1 = t67 / t69;
    const real_t velocity_0 = -(t60 * t63 + t65 * velocity_1);
    const bool t70 = tb_max(TB_C(1e-08), TB_C(64.0) * TB_EPSILON) < TB_C(1.0);
    const bool t71 = !t70;
    const bool t72 = TB_C(0.0001) < distance_0 && TB_C(0.0001) < distance_1;
    const bool t73 = t72 && TB_C(0.0001) < distance_2 && TB_C(0.0001) < distance_3;
    const bool t74 = t73 && TB_C(0.0001) < t42 && TB_C(0.0001) < t45 && TB_C(0.0001) < t48;
    const bool t75 = !(t74 && TB_C(0.0001) < t50);
    const real_t t76 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t77 = !(t76 < t62 && t76 < t69);
    if (t71 || t75 || t77) {
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

