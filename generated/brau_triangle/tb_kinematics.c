/* Regenerate: turnbuckle generate machines/brau_triangle.toml --out <this folder>
 * Machine 62d2624dcb098eaa, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_kinematics.h"
#include "tb_machine.h"

tb_status tb_base_points(const real_t rails[1], real_t points[6])
{
    (void)rails;
    points[0] = TB_C(0.0);
    points[1] = TB_C(0.0);
    points[2] = TB_FRAME_X;
    points[3] = TB_C(0.0);
    points[4] = TB_BASE_3_X;
    points[5] = TB_FRAME_Y;
    return TB_OK;
}

tb_status tb_cable_vectors(const real_t pose[2], const real_t rails[1], real_t vectors[6])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0))) {
        vectors[0] = TB_C(0.0);
        vectors[1] = TB_C(0.0);
        vectors[2] = TB_C(0.0);
        vectors[3] = TB_C(0.0);
        vectors[4] = TB_C(0.0);
        vectors[5] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t vectors_0 = -pose[0];
    const real_t vectors_1 = -pose[1];
    const real_t vectors_2 = TB_FRAME_X - pose[0];
    const real_t vectors_4 = TB_BASE_3_X - pose[0];
    const real_t vectors_5 = TB_FRAME_Y - pose[1];
    vectors[0] = vectors_0;
    vectors[1] = vectors_1;
    vectors[2] = vectors_2;
    vectors[3] = vectors_1;
    vectors[4] = vectors_4;
    vectors[5] = vectors_5;
    return TB_OK;
}

/* Refuses with a status: length is 0 m. */
static tb_status tb_refuse_cable_lengths(tb_status status, real_t length[3])
{
    length[0] = TB_C(0.0);
    length[1] = TB_C(0.0);
    length[2] = TB_C(0.0);
    return status;
}

tb_status tb_cable_lengths(const real_t pose[2], const real_t rails[1], real_t length[3])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0))) {
        return tb_refuse_cable_lengths(TB_OUT_OF_DOMAIN, length);
    }
    const real_t t0 = pose[1] * pose[1];
    const real_t length_0 = TB_SQRT(pose[0] * pose[0] + t0);
    const real_t t1 = TB_FRAME_X - pose[0];
    const real_t length_1 = TB_SQRT(t0 + t1 * t1);
    const real_t t2 = TB_BASE_3_X - pose[0];
    const real_t t3 = TB_FRAME_Y - pose[1];
    const real_t length_2 = TB_SQRT(t2 * t2 + t3 * t3);
    const bool t4 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t5 = !(t4 && TB_C(0.0001) < length_2);
    if (t5) {
        return tb_refuse_cable_lengths(TB_SINGULAR, length);
    }
    length[0] = length_0;
    length[1] = length_1;
    length[2] = length_2;
    return TB_OK;
}

/* Refuses with a status: structure is 0. */
static tb_status tb_refuse_structure_matrix(tb_status status, real_t structure[6])
{
    structure[0] = TB_C(0.0);
    structure[1] = TB_C(0.0);
    structure[2] = TB_C(0.0);
    structure[3] = TB_C(0.0);
    structure[4] = TB_C(0.0);
    structure[5] = TB_C(0.0);
    return status;
}

tb_status tb_structure_matrix(const real_t pose[2], const real_t rails[1], real_t structure[6])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0))) {
        return tb_refuse_structure_matrix(TB_OUT_OF_DOMAIN, structure);
    }
    const real_t t0 = pose[1] * pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(pose[0] * pose[0] + t0);
    const real_t t1 = TB_C(1.0) / length_0;
    const real_t structure_0 = -(pose[0] * t1);
    const real_t t2 = TB_FRAME_X - pose[0];
    const real_t length_1 = TB_SQRT(t0 + t2 * t2);
    const real_t t3 = TB_C(1.0) / length_1;
    const real_t structure_1 = t2 * t3;
    const real_t t4 = TB_BASE_3_X - pose[0];
    const real_t t5 = TB_FRAME_Y - pose[1];
    const real_t length_2 = TB_SQRT(t4 * t4 + t5 * t5);
    const real_t t6 = TB_C(1.0) / length_2;
    const real_t structure_2 = t4 * t6;
    const real_t structure_3 = -(pose[1] * t1);
    const real_t structure_4 = -(pose[1] * t3);
    const real_t structure_5 = t5 * t6;
    const bool t7 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t8 = !(t7 && TB_C(0.0001) < length_2);
    if (t8) {
        return tb_refuse_structure_matrix(TB_SINGULAR, structure);
    }
    structure[0] = structure_0;
    structure[1] = structure_1;
    structure[2] = structure_2;
    structure[3] = structure_3;
    structure[4] = structure_4;
    structure[5] = structure_5;
    return TB_OK;
}

/* Refuses with a status: jacobian is 0. */
static tb_status tb_refuse_length_jacobian(tb_status status, real_t jacobian[6])
{
    jacobian[0] = TB_C(0.0);
    jacobian[1] = TB_C(0.0);
    jacobian[2] = TB_C(0.0);
    jacobian[3] = TB_C(0.0);
    jacobian[4] = TB_C(0.0);
    jacobian[5] = TB_C(0.0);
    return status;
}

tb_status tb_length_jacobian(const real_t pose[2], const real_t rails[1], real_t jacobian[6])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0))) {
        return tb_refuse_length_jacobian(TB_OUT_OF_DOMAIN, jacobian);
    }
    const real_t t0 = pose[1] * pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(pose[0] * pose[0] + t0);
    const real_t t1 = TB_C(1.0) / length_0;
    const real_t jacobian_0 = pose[0] * t1;
    const real_t jacobian_1 = pose[1] * t1;
    const real_t t2 = TB_FRAME_X - pose[0];
    const real_t length_1 = TB_SQRT(t0 + t2 * t2);
    const real_t t3 = TB_C(1.0) / length_1;
    const real_t jacobian_2 = -(t2 * t3);
    const real_t jacobian_3 = pose[1] * t3;
    const real_t t4 = TB_BASE_3_X - pose[0];
    const real_t t5 = TB_FRAME_Y - pose[1];
    const real_t length_2 = TB_SQRT(t4 * t4 + t5 * t5);
    const real_t t6 = TB_C(1.0) / length_2;
    const real_t jacobian_4 = -(t4 * t6);
    const real_t jacobian_5 = -(t5 * t6);
    const bool t7 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t8 = !(t7 && TB_C(0.0001) < length_2);
    if (t8) {
        return tb_refuse_length_jacobian(TB_SINGULAR, jacobian);
    }
    jacobian[0] = jacobian_0;
    jacobian[1] = jacobian_1;
    jacobian[2] = jacobian_2;
    jacobian[3] = jacobian_3;
    jacobian[4] = jacobian_4;
    jacobian[5] = jacobian_5;
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
    const real_t length_rates[3], const real_t rail_rates[1], real_t velocity[2])
{
    (void)rails;
    (void)rail_rates;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(4.0)
          && TB_ABS(length_rates[0]) + TB_ABS(length_rates[1]) + TB_ABS(length_rates[2]) <=
              TB_C(300.0))) {
        return tb_refuse_task_velocity(TB_OUT_OF_DOMAIN, velocity);
    }
    const real_t t0 = TB_FRAME_X - pose[0];
    const real_t t1 = pose[1] * pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_1 = TB_SQRT(t0 * t0 + t1);
    const real_t t2 = TB_C(1.0) / length_1;
    const real_t t3 = t0 * t2;
    const real_t length_0 = TB_SQRT(t1 + pose[0] * pose[0]);
    const real_t t4 = TB_C(1.0) / length_0;
    const real_t t5 = pose[0] * t4;
    const real_t t6 = TB_BASE_3_X - pose[0];
    const real_t t7 = TB_FRAME_Y - pose[1];
    const real_t length_2 = TB_SQRT(t6 * t6 + t7 * t7);
    const real_t t8 = TB_C(1.0) / length_2;
    const real_t t9 = t6 * t8;
    const real_t t10 = t3 * length_rates[1] - t5 * length_rates[0] + t9 * length_rates[2];
    const real_t t11 = t5 * t5 + t3 * t3 + t9 * t9;
    const real_t t12 = TB_C(1.0) / t11;
    const real_t t13 = pose[1] * t4;
    const real_t t14 = pose[1] * t2;
    const real_t t15 = t7 * t8;
    const real_t t16 = t12 * (t5 * t13 - t3 * t14 + t9 * t15);
    const real_t t17 = length_rates[2] * t15 - (length_rates[0] * t13 + length_rates[1] * t14);
    const real_t t18 = t13 * t13 + t14 * t14 + t15 * t15 - t11 * (t16 * t16);
    const real_t velocity_1 = (t10 * t16 - t17) / t18;
    const real_t velocity_0 = -(t10 * t12 + t16 * velocity_1);
    const bool t19 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t20 = !(t19 && TB_C(0.0001) < length_2);
    const real_t t21 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const bool t22 = !(t21 < t11 && t21 < t18);
    if (t20 || t22) {
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

tb_status tb_forward_kinematics(const real_t lengths[3], const real_t rails[1], real_t pose[2],
    real_t residual[1])
{
    (void)rails;
    if (!(lengths[0] >= TB_C(0.0) && lengths[0] <= TB_C(7.464101615137754)
          && lengths[1] >= TB_C(0.0) && lengths[1] <= TB_C(7.464101615137754)
          && lengths[2] >= TB_C(0.0) && lengths[2] <= TB_C(7.464101615137754))) {
        return tb_refuse_forward_kinematics(TB_OUT_OF_DOMAIN, pose, residual);
    }
    const real_t t0 = TB_C(0.3333333333333333) - lengths[0] * lengths[0];
    const real_t t1 = TB_C(0.3333333333333333) - lengths[1] * lengths[1];
    const real_t t2 = TB_C(0.3333333333333333) - lengths[2] * lengths[2];
    const real_t t3 = TB_C(0.3333333333333333) * (t0 + t1 + t2);
    const real_t t4 = t0 - t3;
    const real_t t5 = t1 - t3;
    const real_t t6 = -TB_C(0.5) * t4 + TB_C(0.5) * t5;
    /* differences of squared lengths are linear in the pose */
    const real_t start_0 = TB_C(0.5) + t6;
    const real_t t7 = TB_C(1.0) - start_0;
    const real_t t8 = t4 * -TB_C(0.28867513459481287) + t5 * -TB_C(0.28867513459481287);
    const real_t start_1 = TB_C(0.28867513459481287) + (t8 + TB_C(0.5773502691896257) * (t2 -
        t3));
    const real_t t9 = start_1 * start_1;
    /* one Gauss-Newton step */
    const real_t distance_1 = TB_SQRT(t7 * t7 + t9);
    const real_t t10 = TB_C(1.0) / distance_1;
    const real_t t11 = t7 * t10;
    const real_t t12 = distance_1 - lengths[1];
    const real_t distance_0 = TB_SQRT(t9 + start_0 * start_0);
    const real_t t13 = TB_C(1.0) / distance_0;
    const real_t t14 = start_0 * t13;
    const real_t t15 = distance_0 - lengths[0];
    const real_t t16 = TB_C(0.8660254037844386) - start_1;
    const real_t distance_2 = TB_SQRT(t6 * t6 + t16 * t16);
    const real_t t17 = TB_C(1.0) / distance_2;
    const real_t t18 = t6 * t17;
    const real_t t19 = distance_2 - lengths[2];
    const real_t t20 = t11 * t12 - t14 * t15 - t18 * t19;
    const real_t t21 = t14 * t14 + t11 * t11 + t18 * t18;
    const real_t t22 = TB_C(1.0) / t21;
    const real_t t23 = start_1 * t13;
    const real_t t24 = start_1 * t10;
    const real_t t25 = t16 * t17;
    const real_t t26 = t22 * (t14 * t23 - t11 * t24 - t18 * t25);
    const real_t t27 = t23 * t23 + t24 * t24 + t25 * t25 - t21 * (t26 * t26);
    const real_t t28 = (t19 * t25 - (t15 * t23 + t12 * t24) - t20 * t26) / t27;
    const real_t pose_0 = start_0 + (t20 * t22 - t26 * t28);
    const real_t pose_1 = start_1 + t28;
    const real_t t29 = pose_1 * pose_1;
    const real_t t30 = TB_SQRT(pose_0 * pose_0 + t29);
    /* what the lengths disagree by: slack, an encoder fault */
    const real_t misfit_0 = lengths[0] - t30;
    const real_t t31 = TB_C(1.0) - pose_0;
    const real_t t32 = TB_SQRT(t29 + t31 * t31);
    const real_t misfit_1 = lengths[1] - t32;
    const real_t t33 = TB_C(0.5) - pose_0;
    const real_t t34 = TB_C(0.8660254037844386) - pose_1;
    const real_t t35 = TB_SQRT(t33 * t33 + t34 * t34);
    const real_t misfit_2 = lengths[2] - t35;
    const real_t t36 = misfit_0 * misfit_0 + misfit_1 * misfit_1 + misfit_2 * misfit_2;
    const real_t residual_0 = TB_SQRT(t36);
    const bool t37 = tb_max(TB_C(1e-08), TB_C(64.0) * TB_EPSILON) < TB_C(0.5);
    const bool t38 = !t37;
    const bool t39 = TB_C(0.0001) < distance_0 && TB_C(0.0001) < distance_1;
    const bool t40 = t39 && TB_C(0.0001) < distance_2 && TB_C(0.0001) < t30;
    const bool t41 = !(t40 && TB_C(0.0001) < t32 && TB_C(0.0001) < t35);
    if (t38 || t41) {
        return tb_refuse_forward_kinematics(TB_SINGULAR, pose, residual);
    }
    pose[0] = pose_0;
    pose[1] = pose_1;
    residual[0] = residual_0;
    return TB_OK;
}

/* Refuses with a status: pose is 0 m; residual is 0 m; structure is 0; velocity is 0 m/s. */
static tb_status tb_refuse_locate(tb_status status, real_t pose[2], real_t residual[1],
    real_t structure[6], real_t velocity[2])
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
    velocity[0] = TB_C(0.0);
    velocity[1] = TB_C(0.0);
    return status;
}

tb_status tb_locate(const real_t lengths[3], const real_t rails[1],
    const real_t length_rates[3], const real_t rail_rates[1], real_t pose[2],
    real_t residual[1], real_t structure[6], real_t velocity[2])
{
    (void)rails;
    (void)rail_rates;
    if (!(lengths[0] >= TB_C(0.0) && lengths[0] <= TB_C(7.464101615137754)
          && lengths[1] >= TB_C(0.0) && lengths[1] <= TB_C(7.464101615137754)
          && lengths[2] >= TB_C(0.0) && lengths[2] <= TB_C(7.464101615137754)
          && TB_ABS(length_rates[0]) + TB_ABS(length_rates[1]) + TB_ABS(length_rates[2]) <=
              TB_C(300.0))) {
        return tb_refuse_locate(TB_OUT_OF_DOMAIN, pose, residual, structure, velocity);
    }
    const real_t t0 = TB_C(0.3333333333333333) - lengths[0] * lengths[0];
    const real_t t1 = TB_C(0.3333333333333333) - lengths[1] * lengths[1];
    const real_t t2 = TB_C(0.3333333333333333) - lengths[2] * lengths[2];
    const real_t t3 = TB_C(0.3333333333333333) * (t0 + t1 + t2);
    const real_t t4 = t0 - t3;
    const real_t t5 = t1 - t3;
    const real_t t6 = -TB_C(0.5) * t4 + TB_C(0.5) * t5;
    /* differences of squared lengths are linear in the pose */
    const real_t start_0 = TB_C(0.5) + t6;
    const real_t t7 = TB_C(1.0) - start_0;
    const real_t t8 = t4 * -TB_C(0.28867513459481287) + t5 * -TB_C(0.28867513459481287);
    const real_t start_1 = TB_C(0.28867513459481287) + (t8 + TB_C(0.5773502691896257) * (t2 -
        t3));
    const real_t t9 = start_1 * start_1;
    /* one Gauss-Newton step */
    const real_t distance_1 = TB_SQRT(t7 * t7 + t9);
    const real_t t10 = TB_C(1.0) / distance_1;
    const real_t t11 = t7 * t10;
    const real_t t12 = distance_1 - lengths[1];
    const real_t distance_0 = TB_SQRT(t9 + start_0 * start_0);
    const real_t t13 = TB_C(1.0) / distance_0;
    const real_t t14 = start_0 * t13;
    const real_t t15 = distance_0 - lengths[0];
    const real_t t16 = TB_C(0.8660254037844386) - start_1;
    const real_t distance_2 = TB_SQRT(t6 * t6 + t16 * t16);
    const real_t t17 = TB_C(1.0) / distance_2;
    const real_t t18 = t6 * t17;
    const real_t t19 = distance_2 - lengths[2];
    const real_t t20 = t11 * t12 - t14 * t15 - t18 * t19;
    const real_t t21 = t14 * t14 + t11 * t11 + t18 * t18;
    const real_t t22 = TB_C(1.0) / t21;
    const real_t t23 = start_1 * t13;
    const real_t t24 = start_1 * t10;
    const real_t t25 = t16 * t17;
    const real_t t26 = t22 * (t14 * t23 - t11 * t24 - t18 * t25);
    const real_t t27 = t23 * t23 + t24 * t24 + t25 * t25 - t21 * (t26 * t26);
    const real_t t28 = (t19 * t25 - (t15 * t23 + t12 * t24) - t20 * t26) / t27;
    const real_t pose_0 = start_0 + (t20 * t22 - t26 * t28);
    const real_t pose_1 = start_1 + t28;
    const real_t t29 = pose_1 * pose_1;
    const real_t t30 = TB_SQRT(pose_0 * pose_0 + t29);
    /* what the lengths disagree by: slack, an encoder fault */
    const real_t misfit_0 = lengths[0] - t30;
    const real_t t31 = TB_C(1.0) - pose_0;
    const real_t t32 = TB_SQRT(t29 + t31 * t31);
    const real_t misfit_1 = lengths[1] - t32;
    const real_t t33 = TB_C(0.5) - pose_0;
    const real_t t34 = TB_C(0.8660254037844386) - pose_1;
    const real_t t35 = TB_SQRT(t33 * t33 + t34 * t34);
    const real_t misfit_2 = lengths[2] - t35;
    const real_t t36 = misfit_0 * misfit_0 + misfit_1 * misfit_1 + misfit_2 * misfit_2;
    const real_t residual_0 = TB_SQRT(t36);
    const real_t t37 = TB_C(1.0) / t30;
    const real_t t38 = pose_0 * t37;
    const real_t structure_0 = -t38;
    const real_t t39 = TB_C(1.0) / t32;
    const real_t structure_1 = t31 * t39;
    const real_t t40 = TB_C(1.0) / t35;
    const real_t structure_2 = t33 * t40;
    const real_t t41 = pose_1 * t37;
    const real_t structure_3 = -t41;
    const real_t t42 = pose_1 * t39;
    const real_t structure_4 = -t42;
    const real_t structure_5 = t34 * t40;
    const real_t t43 = structure_1 * length_rates[1] - t38 * length_rates[0];
    const real_t t44 = t43 + structure_2 * length_rates[2];
    const real_t t45 = t38 * t38 + structure_1 * structure_1 + structure_2 * structure_2;
    const real_t t46 = TB_C(1.0) / t45;
    const real_t t47 = t38 * t41 - structure_1 * t42 + structure_2 * structure_5;
    const real_t t48 = t46 * t47;
    const real_t t49 = structure_5 * length_rates[2] - (t41 * length_rates[0] + t42 *
        length_rates[1]);
    const real_t t50 = t41 * t41 + t42 * t42 + structure_5 * structure_5;
    const real_t t51 = t50 - t45 * (t48 * t48);
    const real_t velocity_1 = (t44 * t48 - t49) / t51;
    const real_t velocity_0 = -(t44 * t46 + t48 * velocity_1);
    const bool t52 = tb_max(TB_C(1e-08), TB_C(64.0) * TB_EPSILON) < TB_C(0.5);
    const bool t53 = !t52;
    const bool t54 = TB_C(0.0001) < distance_0 && TB_C(0.0001) < distance_1;
    const bool t55 = t54 && TB_C(0.0001) < distance_2 && TB_C(0.0001) < t30;
    const bool t56 = !(t55 && TB_C(0.0001) < t32 && TB_C(0.0001) < t35);
    const real_t t57 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t58 = !(t57 < t45 && t57 < t51);
    if (t53 || t56 || t58) {
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
    velocity[0] = velocity_0;
    velocity[1] = velocity_1;
    return TB_OK;
}

