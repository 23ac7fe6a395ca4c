/* Regenerate: turnbuckle generate machines/brau_five.toml --out <this folder>
 * Machine b614899c8a021831, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_kinematics.h"
#include "tb_machine.h"

tb_status tb_base_points(const real_t rails[1], real_t points[10])
{
    (void)rails;
    points[0] = TB_C(0.0);
    points[1] = TB_FRAME;
    points[2] = TB_C(0.0);
    points[3] = TB_C(0.0);
    points[4] = TB_FRAME;
    points[5] = TB_C(0.0);
    points[6] = TB_FRAME;
    points[7] = TB_FRAME;
    points[8] = TB_BASE_5_X;
    points[9] = TB_FRAME;
    return TB_OK;
}

tb_status tb_cable_vectors(const real_t pose[2], const real_t rails[1], real_t vectors[10])
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
        vectors[8] = TB_C(0.0);
        vectors[9] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t vectors_0 = -pose[0];
    const real_t vectors_1 = TB_FRAME - pose[1];
    const real_t vectors_3 = -pose[1];
    const real_t vectors_4 = TB_FRAME - pose[0];
    const real_t vectors_8 = TB_BASE_5_X - pose[0];
    vectors[0] = vectors_0;
    vectors[1] = vectors_1;
    vectors[2] = vectors_0;
    vectors[3] = vectors_3;
    vectors[4] = vectors_4;
    vectors[5] = vectors_3;
    vectors[6] = vectors_4;
    vectors[7] = vectors_1;
    vectors[8] = vectors_8;
    vectors[9] = vectors_1;
    return TB_OK;
}

/* Refuses with a status: length is 0 m. */
static tb_status tb_refuse_cable_lengths(tb_status status, real_t length[5])
{
    length[0] = TB_C(0.0);
    length[1] = TB_C(0.0);
    length[2] = TB_C(0.0);
    length[3] = TB_C(0.0);
    length[4] = TB_C(0.0);
    return status;
}

tb_status tb_cable_lengths(const real_t pose[2], const real_t rails[1], real_t length[5])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0))) {
        return tb_refuse_cable_lengths(TB_OUT_OF_DOMAIN, length);
    }
    const real_t t0 = pose[0] * pose[0];
    const real_t t1 = TB_FRAME - pose[1];
    const real_t t2 = t1 * t1;
    const real_t length_0 = TB_SQRT(t0 + t2);
    const real_t t3 = pose[1] * pose[1];
    const real_t length_1 = TB_SQRT(t0 + t3);
    const real_t t4 = TB_FRAME - pose[0];
    const real_t t5 = t4 * t4;
    const real_t length_2 = TB_SQRT(t3 + t5);
    const real_t length_3 = TB_SQRT(t2 + t5);
    const real_t t6 = TB_BASE_5_X - pose[0];
    const real_t length_4 = TB_SQRT(t2 + t6 * t6);
    const bool t7 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t8 = t7 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t9 = !(t8 && TB_C(0.0001) < length_4);
    if (t9) {
        return tb_refuse_cable_lengths(TB_SINGULAR, length);
    }
    length[0] = length_0;
    length[1] = length_1;
    length[2] = length_2;
    length[3] = length_3;
    length[4] = length_4;
    return TB_OK;
}

/* Refuses with a status: structure is 0. */
static tb_status tb_refuse_structure_matrix(tb_status status, real_t structure[10])
{
    structure[0] = TB_C(0.0);
    structure[1] = TB_C(0.0);
    structure[2] = TB_C(0.0);
    structure[3] = TB_C(0.0);
    structure[4] = TB_C(0.0);
    structure[5] = TB_C(0.0);
    structure[6] = TB_C(0.0);
    structure[7] = TB_C(0.0);
    structure[8] = TB_C(0.0);
    structure[9] = TB_C(0.0);
    return status;
}

tb_status tb_structure_matrix(const real_t pose[2], const real_t rails[1], real_t structure[10])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0))) {
        return tb_refuse_structure_matrix(TB_OUT_OF_DOMAIN, structure);
    }
    const real_t t0 = pose[0] * pose[0];
    const real_t t1 = TB_FRAME - pose[1];
    const real_t t2 = t1 * t1;
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 + t2);
    const real_t t3 = TB_C(1.0) / length_0;
    const real_t structure_0 = -(pose[0] * t3);
    const real_t t4 = pose[1] * pose[1];
    const real_t length_1 = TB_SQRT(t0 + t4);
    const real_t t5 = TB_C(1.0) / length_1;
    const real_t structure_1 = -(pose[0] * t5);
    const real_t t6 = TB_FRAME - pose[0];
    const real_t t7 = t6 * t6;
    const real_t length_2 = TB_SQRT(t4 + t7);
    const real_t t8 = TB_C(1.0) / length_2;
    const real_t structure_2 = t6 * t8;
    const real_t length_3 = TB_SQRT(t2 + t7);
    const real_t t9 = TB_C(1.0) / length_3;
    const real_t structure_3 = t6 * t9;
    const real_t t10 = TB_BASE_5_X - pose[0];
    const real_t length_4 = TB_SQRT(t2 + t10 * t10);
    const real_t t11 = TB_C(1.0) / length_4;
    const real_t structure_4 = t10 * t11;
    const real_t structure_5 = t1 * t3;
    const real_t structure_6 = -(pose[1] * t5);
    const real_t structure_7 = -(pose[1] * t8);
    const real_t structure_8 = t1 * t9;
    const real_t structure_9 = t1 * t11;
    const bool t12 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t13 = t12 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t14 = !(t13 && TB_C(0.0001) < length_4);
    if (t14) {
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
    structure[8] = structure_8;
    structure[9] = structure_9;
    return TB_OK;
}

/* Refuses with a status: jacobian is 0. */
static tb_status tb_refuse_length_jacobian(tb_status status, real_t jacobian[10])
{
    jacobian[0] = TB_C(0.0);
    jacobian[1] = TB_C(0.0);
    jacobian[2] = TB_C(0.0);
    jacobian[3] = TB_C(0.0);
    jacobian[4] = TB_C(0.0);
    jacobian[5] = TB_C(0.0);
    jacobian[6] = TB_C(0.0);
    jacobian[7] = TB_C(0.0);
    jacobian[8] = TB_C(0.0);
    jacobian[9] = TB_C(0.0);
    return status;
}

tb_status tb_length_jacobian(const real_t pose[2], const real_t rails[1], real_t jacobian[10])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0))) {
        return tb_refuse_length_jacobian(TB_OUT_OF_DOMAIN, jacobian);
    }
    const real_t t0 = pose[0] * pose[0];
    const real_t t1 = TB_FRAME - pose[1];
    const real_t t2 = t1 * t1;
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 + t2);
    const real_t t3 = TB_C(1.0) / length_0;
    const real_t jacobian_0 = pose[0] * t3;
    const real_t jacobian_1 = -(t1 * t3);
    const real_t t4 = pose[1] * pose[1];
    const real_t length_1 = TB_SQRT(t0 + t4);
    const real_t t5 = TB_C(1.0) / length_1;
    const real_t jacobian_2 = pose[0] * t5;
    const real_t jacobian_3 = pose[1] * t5;
    const real_t t6 = TB_FRAME - pose[0];
    const real_t t7 = t6 * t6;
    const real_t length_2 = TB_SQRT(t4 + t7);
    const real_t t8 = TB_C(1.0) / length_2;
    const real_t jacobian_4 = -(t6 * t8);
    const real_t jacobian_5 = pose[1] * t8;
    const real_t length_3 = TB_SQRT(t2 + t7);
    const real_t t9 = TB_C(1.0) / length_3;
    const real_t jacobian_6 = -(t6 * t9);
    const real_t jacobian_7 = -(t1 * t9);
    const real_t t10 = TB_BASE_5_X - pose[0];
    const real_t length_4 = TB_SQRT(t2 + t10 * t10);
    const real_t t11 = TB_C(1.0) / length_4;
    const real_t jacobian_8 = -(t10 * t11);
    const real_t jacobian_9 = -(t1 * t11);
    const bool t12 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t13 = t12 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t14 = !(t13 && TB_C(0.0001) < length_4);
    if (t14) {
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
    jacobian[8] = jacobian_8;
    jacobian[9] = jacobian_9;
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
    const real_t length_rates[5], const real_t rail_rates[1], real_t velocity[2])
{
    (void)rails;
    (void)rail_rates;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0)
          && TB_ABS(length_rates[0]) + TB_ABS(length_rates[1]) + TB_ABS(length_rates[2]) +
              TB_ABS(length_rates[3]) + TB_ABS(length_rates[4]) <= TB_C(500.0))) {
        return tb_refuse_task_velocity(TB_OUT_OF_DOMAIN, velocity);
    }
    const real_t t0 = TB_FRAME - pose[0];
    const real_t t1 = t0 * t0;
    const real_t t2 = pose[1] * pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_2 = TB_SQRT(t1 + t2);
    const real_t t3 = TB_C(1.0) / length_2;
    const real_t t4 = t0 * t3;
    const real_t t5 = pose[0] * pose[0];
    const real_t t6 = TB_FRAME - pose[1];
    const real_t t7 = t6 * t6;
    const real_t length_0 = TB_SQRT(t5 + t7);
    const real_t t8 = TB_C(1.0) / length_0;
    const real_t t9 = pose[0] * t8;
    const real_t length_1 = TB_SQRT(t2 + t5);
    const real_t t10 = TB_C(1.0) / length_1;
    const real_t t11 = pose[0] * t10;
    const real_t t12 = t4 * length_rates[2] - (t9 * length_rates[0] + t11 * length_rates[1]);
    const real_t length_3 = TB_SQRT(t1 + t7);
    const real_t t13 = TB_C(1.0) / length_3;
    const real_t t14 = t0 * t13;
    const real_t t15 = TB_BASE_5_X - pose[0];
    const real_t length_4 = TB_SQRT(t7 + t15 * t15);
    const real_t t16 = TB_C(1.0) / length_4;
    const real_t t17 = t15 * t16;
    const real_t t18 = t12 + t14 * length_rates[3] + t17 * length_rates[4];
    const real_t t19 = t9 * t9 + t11 * t11 + t4 * t4 + t14 * t14 + t17 * t17;
    const real_t t20 = TB_C(1.0) / t19;
    const real_t t21 = pose[1] * t10;
    const real_t t22 = t6 * t8;
    const real_t t23 = pose[1] * t3;
    const real_t t24 = t6 * t13;
    const real_t t25 = t6 * t16;
    const real_t t26 = t11 * t21 - t9 * t22 - t4 * t23 + t14 * t24 + t17 * t25;
    const real_t t27 = t20 * t26;
    const real_t t28 = length_rates[0] * t22 - length_rates[1] * t21 - length_rates[2] * t23;
    const real_t t29 = t28 + length_rates[3] * t24 + length_rates[4] * t25;
    const real_t t30 = t22 * t22 + t21 * t21 + t23 * t23 + t24 * t24 + t25 * t25;
    const real_t t31 = t30 - t19 * (t27 * t27);
    const real_t velocity_1 = (t18 * t27 - t29) / t31;
    const real_t velocity_0 = -(t18 * t20 + t27 * velocity_1);
    const bool t32 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t33 = t32 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t34 = !(t33 && TB_C(0.0001) < length_4);
    const real_t t35 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const bool t36 = !(t35 < t19 && t35 < t31);
    if (t34 || t36) {
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

tb_status tb_forward_kinematics(const real_t lengths[5], const real_t rails[1], real_t pose[2],
    real_t residual[1])
{
    (void)rails;
    if (!(lengths[0] >= TB_C(0.0) && lengths[0] <= TB_C(8.0)
          && lengths[1] >= TB_C(0.0) && lengths[1] <= TB_C(8.0)
          && lengths[2] >= TB_C(0.0) && lengths[2] <= TB_C(8.0)
          && lengths[3] >= TB_C(0.0) && lengths[3] <= TB_C(8.0)
          && lengths[4] >= TB_C(0.0) && lengths[4] <= TB_C(8.0))) {
        return tb_refuse_forward_kinematics(TB_OUT_OF_DOMAIN, pose, residual);
    }
    const real_t t0 = TB_C(0.41000000000000003) - lengths[0] * lengths[0];
    const real_t t1 = TB_C(0.61) - lengths[1] * lengths[1];
    const real_t t2 = TB_C(0.61) - lengths[2] * lengths[2];
    const real_t t3 = TB_C(0.41000000000000003) - lengths[3] * lengths[3];
    const real_t t4 = TB_C(0.16000000000000003) - lengths[4] * lengths[4];
    const real_t t5 = (t0 + t1 + t2 + t3 + t4) * TB_C(0.2);
    const real_t t6 = t0 - t5;
    const real_t t7 = t1 - t5;
    const real_t t8 = t2 - t5;
    const real_t t9 = -TB_BASE_5_X * t6 + -TB_BASE_5_X * t7 + TB_BASE_5_X * t8;
    const real_t t10 = t3 - t5;
    const real_t t11 = TB_C(0.5) * (t9 + TB_BASE_5_X * t10);
    /* differences of squared lengths are linear in the pose */
    const real_t start_0 = TB_BASE_5_X + t11;
    const real_t t12 = TB_FRAME - start_0;
    const real_t t13 = t12 * t12;
    const real_t t14 = t6 * TB_C(0.4) + t7 * -TB_C(0.6) + t8 * -TB_C(0.6);
    const real_t t15 = TB_C(0.5) * (t14 + t10 * TB_C(0.4) + TB_C(0.4) * (t4 - t5));
    const real_t start_1 = TB_C(0.6) + t15 * TB_C(0.8333333333333333);
    const real_t t16 = start_1 * start_1;
    /* one Gauss-Newton step */
    const real_t distance_2 = TB_SQRT(t13 + t16);
    const real_t t17 = TB_C(1.0) / distance_2;
    const real_t t18 = t12 * t17;
    const real_t t19 = distance_2 - lengths[2];
    const real_t t20 = start_0 * start_0;
    const real_t t21 = TB_FRAME - start_1;
    const real_t t22 = t21 * t21;
    const real_t distance_0 = TB_SQRT(t20 + t22);
    const real_t t23 = TB_C(1.0) / distance_0;
    const real_t t24 = start_0 * t23;
    const real_t t25 = distance_0 - lengths[0];
    const real_t distance_1 = TB_SQRT(t16 + t20);
    const real_t t26 = TB_C(1.0) / distance_1;
    const real_t t27 = start_0 * t26;
    const real_t t28 = distance_1 - lengths[1];
    const real_t distance_3 = TB_SQRT(t13 + t22);
    const real_t t29 = TB_C(1.0) / distance_3;
    const real_t t30 = t12 * t29;
    const real_t t31 = distance_3 - lengths[3];
    const real_t distance_4 = TB_SQRT(t22 + t11 * t11);
    const real_t t32 = TB_C(1.0) / distance_4;
    const real_t t33 = t11 * t32;
    const real_t t34 = distance_4 - lengths[4];
    const real_t t35 = t18 * t19 - (t24 * t25 + t27 * t28) + t30 * t31 - t33 * t34;
    const real_t t36 = t24 * t24 + t27 * t27 + t18 * t18 + t30 * t30 + t33 * t33;
    const real_t t37 = TB_C(1.0) / t36;
    const real_t t38 = start_1 * t26;
    const real_t t39 = t21 * t23;
    const real_t t40 = start_1 * t17;
    const real_t t41 = t21 * t29;
    const real_t t42 = t21 * t32;
    const real_t t43 = t27 * t38 - t24 * t39 - t18 * t40 + t30 * t41 - t33 * t42;
    const real_t t44 = t37 * t43;
    const real_t t45 = t25 * t39 - t28 * t38 - t19 * t40 + t31 * t41 + t34 * t42;
    const real_t t46 = t39 * t39 + t38 * t38 + t40 * t40 + t41 * t41 + t42 * t42;
    const real_t t47 = (t45 - t35 * t44) / (t46 - t36 * (t44 * t44));
    const real_t pose_0 = start_0 + (t35 * t37 - t44 * t47);
    const real_t pose_1 = start_1 + t47;
    const real_t t48 = pose_0 * pose_0;
    const real_t t49 = TB_FRAME - pose_1;
    const real_t t50 = t49 * t49;
    const real_t t51 = TB_SQRT(t48 + t50);
    /* what the lengths disagree by: slack, an encoder fault */
    const real_t misfit_0 = lengths[0] - t51;
    const real_t t52 = pose_1 * pose_1;
    const real_t t53 = TB_SQRT(t48 + t52);
    const real_t misfit_1 = lengths[1] - t53;
    const real_t t54 = TB_FRAME - pose_0;
    const real_t t55 = t54 * t54;
    const real_t t56 = TB_SQRT(t52 + t55);
    const real_t misfit_2 = lengths[2] - t56;
    const real_t t57 = misfit_0 * misfit_0 + misfit_1 * misfit_1 + misfit_2 * misfit_2;
    const real_t t58 = TB_SQRT(t50 + t55);
    const real_t misfit_3 = lengths[3] - t58;
    const real_t t59 = TB_BASE_5_X - pose_0;
    const real_t t60 = TB_SQRT(t50 + t59 * t59);
    const real_t misfit_4 = lengths[4] - t60;
    const real_t residual_0 = TB_SQRT(t57 + misfit_3 * misfit_3 + misfit_4 * misfit_4);
    const real_t t61 = tb_max(TB_C(1e-08), TB_C(64.0) * TB_EPSILON);
    const bool t62 = t61 < TB_C(1.0) && t61 < TB_C(1.2000000000000002);
    const bool t63 = !t62;
    const bool t64 = TB_C(0.0001) < distance_0 && TB_C(0.0001) < distance_1;
    const bool t65 = t64 && TB_C(0.0001) < distance_2 && TB_C(0.0001) < distance_3;
    const bool t66 = t65 && TB_C(0.0001) < distance_4 && TB_C(0.0001) < t51;
    const bool t67 = t66 && TB_C(0.0001) < t53 && TB_C(0.0001) < t56 && TB_C(0.0001) < t58;
    const bool t68 = !(t67 && TB_C(0.0001) < t60);
    if (t63 || t68) {
        return tb_refuse_forward_kinematics(TB_SINGULAR, pose, residual);
    }
    pose[0] = pose_0;
    pose[1] = pose_1;
    residual[0] = residual_0;
    return TB_OK;
}

/* Refuses with a status: pose is 0 m; residual is 0 m; structure is 0; velocity is 0 m/s. */
static tb_status tb_refuse_locate(tb_status status, real_t pose[2], real_t residual[1],
    real_t structure[10], real_t velocity[2])
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
    structure[8] = TB_C(0.0);
    structure[9] = TB_C(0.0);
    velocity[0] = TB_C(0.0);
    velocity[1] = TB_C(0.0);
    return status;
}

tb_status tb_locate(const real_t lengths[5], const real_t rails[1],
    const real_t length_rates[5], const real_t rail_rates[1], real_t pose[2],
    real_t residual[1], real_t structure[10], real_t velocity[2])
{
    (void)rails;
    (void)rail_rates;
    if (!(lengths[0] >= TB_C(0.0) && lengths[0] <= TB_C(8.0)
          && lengths[1] >= TB_C(0.0) && lengths[1] <= TB_C(8.0)
          && lengths[2] >= TB_C(0.0) && lengths[2] <= TB_C(8.0)
          && lengths[3] >= TB_C(0.0) && lengths[3] <= TB_C(8.0)
          && lengths[4] >= TB_C(0.0) && lengths[4] <= TB_C(8.0)
          && TB_ABS(length_rates[0]) + TB_ABS(length_rates[1]) + TB_ABS(length_rates[2]) +
              TB_ABS(length_rates[3]) + TB_ABS(length_rates[4]) <= TB_C(500.0))) {
        return tb_refuse_locate(TB_OUT_OF_DOMAIN, pose, residual, structure, velocity);
    }
    const real_t t0 = TB_C(0.41000000000000003) - lengths[0] * lengths[0];
    const real_t t1 = TB_C(0.61) - lengths[1] * lengths[1];
    const real_t t2 = TB_C(0.61) - lengths[2] * lengths[2];
    const real_t t3 = TB_C(0.41000000000000003) - lengths[3] * lengths[3];
    const real_t t4 = TB_C(0.16000000000000003) - lengths[4] * lengths[4];
    const real_t t5 = (t0 + t1 + t2 + t3 + t4) * TB_C(0.2);
    const real_t t6 = t0 - t5;
    const real_t t7 = t1 - t5;
    const real_t t8 = t2 - t5;
    const real_t t9 = -TB_BASE_5_X * t6 + -TB_BASE_5_X * t7 + TB_BASE_5_X * t8;
    const real_t t10 = t3 - t5;
    const real_t t11 = TB_C(0.5) * (t9 + TB_BASE_5_X * t10);
    /* differences of squared lengths are linear in the pose */
    const real_t start_0 = TB_BASE_5_X + t11;
    const real_t t12 = TB_FRAME - start_0;
    const real_t t13 = t12 * t12;
    const real_t t14 = t6 * TB_C(0.4) + t7 * -TB_C(0.6) + t8 * -TB_C(0.6);
    const real_t t15 = TB_C(0.5) * (t14 + t10 * TB_C(0.4) + TB_C(0.4) * (t4 - t5));
    const real_t start_1 = TB_C(0.6) + t15 * TB_C(0.8333333333333333);
    const real_t t16 = start_1 * start_1;
    /* one Gauss-Newton step */
    const real_t distance_2 = TB_SQRT(t13 + t16);
    const real_t t17 = TB_C(1.0) / distance_2;
    const real_t t18 = t12 * t17;
    const real_t t19 = distance_2 - lengths[2];
    const real_t t20 = start_0 * start_0;
    const real_t t21 = TB_FRAME - start_1;
    const real_t t22 = t21 * t21;
    const real_t distance_0 = TB_SQRT(t20 + t22);
    const real_t t23 = TB_C(1.0) / distance_0;
    const real_t t24 = start_0 * t23;
    const real_t t25 = distance_0 - lengths[0];
    const real_t distance_1 = TB_SQRT(t16 + t20);
    const real_t t26 = TB_C(1.0) / distance_1;
    const real_t t27 = start_0 * t26;
    const real_t t28 = distance_1 - lengths[1];
    const real_t distance_3 = TB_SQRT(t13 + t22);
    const real_t t29 = TB_C(1.0) / distance_3;
    const real_t t30 = t12 * t29;
    const real_t t31 = distance_3 - lengths[3];
    const real_t distance_4 = TB_SQRT(t22 + t11 * t11);
    const real_t t32 = TB_C(1.0) / distance_4;
    const real_t t33 = t11 * t32;
    const real_t t34 = distance_4 - lengths[4];
    const real_t t35 = t18 * t19 - (t24 * t25 + t27 * t28) + t30 * t31 - t33 * t34;
    const real_t t36 = t24 * t24 + t27 * t27 + t18 * t18 + t30 * t30 + t33 * t33;
    const real_t t37 = TB_C(1.0) / t36;
    const real_t t38 = start_1 * t26;
    const real_t t39 = t21 * t23;
    const real_t t40 = start_1 * t17;
    const real_t t41 = t21 * t29;
    const real_t t42 = t21 * t32;
    const real_t t43 = t27 * t38 - t24 * t39 - t18 * t40 + t30 * t41 - t33 * t42;
    const real_t t44 = t37 * t43;
    const real_t t45 = t25 * t39 - t28 * t38 - t19 * t40 + t31 * t41 + t34 * t42;
    const real_t t46 = t39 * t39 + t38 * t38 + t40 * t40 + t41 * t41 + t42 * t42;
    const real_t t47 = (t45 - t35 * t44) / (t46 - t36 * (t44 * t44));
    const real_t pose_0 = start_0 + (t35 * t37 - t44 * t47);
    const real_t pose_1 = start_1 + t47;
    const real_t t48 = pose_0 * pose_0;
    const real_t t49 = TB_FRAME - pose_1;
    const real_t t50 = t49 * t49;
    const real_t t51 = TB_SQRT(t48 + t50);
    /* what the lengths disagree by: slack, an encoder fault */
    const real_t misfit_0 = lengths[0] - t51;
    const real_t t52 = pose_1 * pose_1;
    const real_t t53 = TB_SQRT(t48 + t52);
    const real_t misfit_1 = lengths[1] - t53;
    const real_t t54 = TB_FRAME - pose_0;
    const real_t t55 = t54 * t54;
    const real_t t56 = TB_SQRT(t52 + t55);
    const real_t misfit_2 = lengths[2] - t56;
    const real_t t57 = misfit_0 * misfit_0 + misfit_1 * misfit_1 + misfit_2 * misfit_2;
    const real_t t58 = TB_SQRT(t50 + t55);
    const real_t misfit_3 = lengths[3] - t58;
    const real_t t59 = TB_BASE_5_X - pose_0;
    const real_t t60 = TB_SQRT(t50 + t59 * t59);
    const real_t misfit_4 = lengths[4] - t60;
    const real_t residual_0 = TB_SQRT(t57 + misfit_3 * misfit_3 + misfit_4 * misfit_4);
    const real_t t61 = TB_C(1.0) / t51;
    const real_t t62 = pose_0 * t61;
    const real_t structure_0 = -t62;
    const real_t t63 = TB_C(1.0) / t53;
    const real_t t64 = pose_0 * t63;
    const real_t structure_1 = -t64;
    const real_t t65 = TB_C(1.0) / t56;
    const real_t structure_2 = t54 * t65;
    const real_t t66 = TB_C(1.0) / t58;
    const real_t structure_3 = t54 * t66;
    const real_t t67 = TB_C(1.0) / t60;
    const real_t structure_4 = t59 * t67;
    const real_t structure_5 = t49 * t61;
    const real_t t68 = pose_1 * t63;
    const real_t structure_6 = -t68;
    const real_t t69 = pose_1 * t65;
    const real_t structure_7 = -t69;
    const real_t structure_8 = t49 * t66;
    const real_t structure_9 = t49 * t67;
    const real_t t70 = structure_2 * length_rates[2] - (t62 * length_rates[0] + t64 *
        length_rates[1]);
    const real_t t71 = t70 + structure_3 * length_rates[3] + structure_4 * length_rates[4];
    const real_t t72 = t62 * t62 + t64 * t64 + structure_2 * structure_2;
    const real_t t73 = t72 + structure_3 * structure_3 + structure_4 * structure_4;
    const real_t t74 = TB_C(1.0) / t73;
    const real_t t75 = t64 * t68 - t62 * structure_5 - structure_2 * t69;
    const real_t t76 = t75 + structure_3 * structure_8 + structure_4 * structure_9;
    const real_t t77 = t74 * t76;
    const real_t t78 = structure_5 * length_rates[0] - t68 * length_rates[1];
    const real_t t79 = t78 - t69 * length_rates[2] + structure_8 * length_rates[3];
    const real_t t80 = t71 * t77 - (t79 + structure_9 * length_rates[4]);
    const real_t t81 = structure_5 * structure_5 + t68 * t68 + t69 * t69;
    const real_t t82 = t81 + structure_8 * structure_8 + structure_9 * structure_9;
    const real_t t83 = t82 - t73 * (t77 * t77);
    const real_t velocity_1 = t80 / t83;
    const real_t velocity_0 = -(t71 * t74 + t77 * velocity_1);
    const real_t t84 = tb_max(TB_C(1e-08), TB_C(64.0) * TB_EPSILON);
    const bool t85 = t84 < TB_C(1.0) && t84 < TB_C(1.2000000000000002);
    const bool t86 = !t85;
    const bool t87 = TB_C(0.0001) < distance_0 && TB_C(0.0001) < distance_1;
    const bool t88 = t87 && TB_C(0.0001) < distance_2 && TB_C(0.0001) < distance_3;
    const bool t89 = t88 && TB_C(0.0001) < distance_4 && TB_C(0.0001) < t51;
    const bool t90 = t89 && TB_C(0.0001) < t53 && TB_C(0.0001) < t56 && TB_C(0.0001) < t58;
    const bool t91 = !(t90 && TB_C(0.0001) < t60);
    const real_t t92 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t93 = !(t92 < t73 && t92 < t83);
    if (t86 || t91 || t93) {
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
    structure[8] = structure_8;
    structure[9] = structure_9;
    velocity[0] = velocity_0;
    velocity[1] = velocity_1;
    return TB_OK;
}

