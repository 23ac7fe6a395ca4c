/* Regenerate: turnbuckle generate machines/yoon_fixed_orthogonal.toml --out <this folder>
 * Machine c858d0533419e597, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_kinematics.h"
#include "tb_machine.h"

tb_status tb_base_points(const real_t rails[1], real_t points[8])
{
    (void)rails;
    points[0] = TB_C(0.253);
    points[1] = TB_C(0.0);
    points[2] = TB_FRAME_X;
    points[3] = TB_C(0.142);
    points[4] = TB_C(0.253);
    points[5] = TB_FRAME_Y;
    points[6] = TB_C(0.0);
    points[7] = TB_C(0.142);
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
    const real_t vectors_0 = TB_C(0.253) - pose[0];
    const real_t vectors_1 = -pose[1];
    const real_t vectors_2 = TB_FRAME_X - pose[0];
    const real_t vectors_3 = TB_C(0.142) - pose[1];
    const real_t vectors_5 = TB_FRAME_Y - pose[1];
    const real_t vectors_6 = -pose[0];
    vectors[0] = vectors_0;
    vectors[1] = vectors_1;
    vectors[2] = vectors_2;
    vectors[3] = vectors_3;
    vectors[4] = vectors_0;
    vectors[5] = vectors_5;
    vectors[6] = vectors_6;
    vectors[7] = vectors_3;
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
    const real_t t0 = TB_C(0.253) - pose[0];
    const real_t t1 = t0 * t0;
    const real_t length_0 = TB_SQRT(t1 + pose[1] * pose[1]);
    const real_t t2 = TB_FRAME_X - pose[0];
    const real_t t3 = TB_C(0.142) - pose[1];
    const real_t t4 = t3 * t3;
    const real_t length_1 = TB_SQRT(t2 * t2 + t4);
    const real_t t5 = TB_FRAME_Y - pose[1];
    const real_t length_2 = TB_SQRT(t1 + t5 * t5);
    const real_t length_3 = TB_SQRT(t4 + pose[0] * pose[0]);
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
    const real_t t0 = TB_C(0.253) - pose[0];
    const real_t t1 = t0 * t0;
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t1 + pose[1] * pose[1]);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t structure_0 = t0 * t2;
    const real_t t3 = TB_FRAME_X - pose[0];
    const real_t t4 = TB_C(0.142) - pose[1];
    const real_t t5 = t4 * t4;
    const real_t length_1 = TB_SQRT(t3 * t3 + t5);
    const real_t t6 = TB_C(1.0) / length_1;
    const real_t structure_1 = t3 * t6;
    const real_t t7 = TB_FRAME_Y - pose[1];
    const real_t length_2 = TB_SQRT(t1 + t7 * t7);
    const real_t t8 = TB_C(1.0) / length_2;
    const real_t structure_2 = t0 * t8;
    const real_t length_3 = TB_SQRT(t5 + pose[0] * pose[0]);
    const real_t t9 = TB_C(1.0) / length_3;
    const real_t structure_3 = -(pose[0] * t9);
    const real_t structure_4 = -(pose[1] * t2);
    const real_t structure_5 = t4 * t6;
    const real_t structure_6 = t7 * t8;
    const real_t structure_7 = t4 * t9;
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
    const real_t t0 = TB_C(0.253) - pose[0];
    const real_t t1 = t0 * t0;
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t1 + pose[1] * pose[1]);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t jacobian_0 = -(t0 * t2);
    const real_t jacobian_1 = pose[1] * t2;
    const real_t t3 = TB_FRAME_X - pose[0];
    const real_t t4 = TB_C(0.142) - pose[1];
    const real_t t5 = t4 * t4;
    const real_t length_1 = TB_SQRT(t3 * t3 + t5);
    const real_t t6 = TB_C(1.0) / length_1;
    const real_t jacobian_2 = -(t3 * t6);
    const real_t jacobian_3 = -(t4 * t6);
    const real_t t7 = TB_FRAME_Y - pose[1];
    const real_t length_2 = TB_SQRT(t1 + t7 * t7);
    const real_t t8 = TB_C(1.0) / length_2;
    const real_t jacobian_4 = -(t0 * t8);
    const real_t jacobian_5 = -(t7 * t8);
    const real_t length_3 = TB_SQRT(t5 + pose[0] * pose[0]);
    const real_t t9 = TB_C(1.0) / length_3;
    const real_t jacobian_6 = pose[0] * t9;
    const real_t jacobian_7 = -(t4 * t9);
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
    const real_t t0 = TB_C(0.253) - pose[0];
    const real_t t1 = t0 * t0;
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t1 + pose[1] * pose[1]);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t t3 = t0 * t2;
    const real_t t4 = TB_FRAME_X - pose[0];
    const real_t t5 = TB_C(0.142) - pose[1];
    const real_t t6 = t5 * t5;
    const real_t length_1 = TB_SQRT(t4 * t4 + t6);
    const real_t t7 = TB_C(1.0) / length_1;
    const real_t t8 = t4 * t7;
    const real_t t9 = TB_FRAME_Y - pose[1];
    const real_t length_2 = TB_SQRT(t1 + t9 * t9);
    const real_t t10 = TB_C(1.0) / length_2;
    const real_t t11 = t0 * t10;
    const real_t t12 = t3 * length_rates[0] + t8 * length_rates[1] + t11 * length_rates[2];
    const real_t length_3 = TB_SQRT(t6 + pose[0] * pose[0]);
    const real_t t13 = TB_C(1.0) / length_3;
    const real_t t14 = pose[0] * t13;
    const real_t t15 = t12 - t14 * length_rates[3];
    const real_t t16 = t3 * t3 + t8 * t8 + t11 * t11 + t14 * t14;
    const real_t t17 = TB_C(1.0) / t16;
    const real_t t18 = t5 * t7;
    const real_t t19 = pose[1] * t2;
    const real_t t20 = t9 * t10;
    const real_t t21 = t5 * t13;
    const real_t t22 = t17 * (t8 * t18 - t3 * t19 + t11 * t20 - t14 * t21);
    const real_t t23 = length_rates[1] * t18 - length_rates[0] * t19 + length_rates[2] * t20;
    const real_t t24 = t19 * t19 + t18 * t18 + t20 * t20 + t21 * t21 - t16 * (t22 * t22);
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
    const real_t t0 = TB_C(0.064009) - lengths[1] * lengths[1];
    const real_t t1 = TB_C(0.020163999999999998) - lengths[0] * lengths[0];
    const real_t t2 = TB_C(0.020163999999999998) - lengths[2] * lengths[2];
    const real_t t3 = TB_C(0.064009) - lengths[3] * lengths[3];
    const real_t t4 = (t0 + t1 + t2 + t3) * TB_C(0.25);
    const real_t t5 = TB_C(0.253) * (t0 - t4) + -TB_C(0.253) * (t3 - t4);
    const real_t t6 = t5 * TB_C(0.5) * TB_C(7.811401521661017);
    /* differences of squared lengths are linear in the pose */
    const real_t start_0 = TB_C(0.253) + t6;
    const real_t t7 = TB_FRAME_X - start_0;
    const real_t t8 = -TB_C(0.142) * (t1 - t4) + TB_C(0.142) * (t2 - t4);
    const real_t t9 = TB_C(0.5) * t8 * TB_C(24.79666732791113);
    const real_t t10 = t9 * t9;
    /* one Gauss-Newton step */
    const real_t distance_1 = TB_SQRT(t7 * t7 + t10);
    const real_t t11 = TB_C(1.0) / distance_1;
    const real_t t12 = t7 * t11;
    const real_t t13 = distance_1 - lengths[1];
    const real_t t14 = t6 * t6;
    const real_t start_1 = TB_C(0.142) + t9;
    const real_t distance_0 = TB_SQRT(t14 + start_1 * start_1);
    const real_t t15 = TB_C(1.0) / distance_0;
    const real_t t16 = t6 * t15;
    const real_t t17 = distance_0 - lengths[0];
    const real_t t18 = TB_FRAME_Y - start_1;
    const real_t distance_2 = TB_SQRT(t14 + t18 * t18);
    const real_t t19 = TB_C(1.0) / distance_2;
    const real_t t20 = t6 * t19;
    const real_t t21 = distance_2 - lengths[2];
    const real_t distance_3 = TB_SQRT(t10 + start_0 * start_0);
    const real_t t22 = TB_C(1.0) / distance_3;
    const real_t t23 = start_0 * t22;
    const real_t t24 = distance_3 - lengths[3];
    const real_t t25 = t12 * t13 - t16 * t17 - t20 * t21 - t23 * t24;
    const real_t t26 = t16 * t16 + t12 * t12 + t20 * t20 + t23 * t23;
    const real_t t27 = TB_C(1.0) / t26;
    const real_t t28 = start_1 * t15;
    const real_t t29 = t9 * t11;
    const real_t t30 = t18 * t19;
    const real_t t31 = t9 * t22;
    const real_t t32 = t27 * (t16 * t28 - t12 * t29 - t20 * t30 + t23 * t31);
    const real_t t33 = t21 * t30 - (t17 * t28 + t13 * t29) - t24 * t31 - t25 * t32;
    const real_t t34 = t28 * t28 + t29 * t29 + t30 * t30 + t31 * t31 - t26 * (t32 * t32);
    const real_t t35 = t33 / t34;
    const real_t pose_0 = start_0 + (t25 * t27 - t32 * t35);
    const real_t pose_1 = start_1 + t35;
    const real_t t36 = TB_C(0.253) - pose_0;
    const real_t t37 = t36 * t36;
    const real_t t38 = TB_SQRT(t37 + pose_1 * pose_1);
    /* what the lengths disagree by: slack, an encoder fault */
    const real_t misfit_0 = lengths[0] - t38;
    const real_t t39 = TB_FRAME_X - pose_0;
    const real_t t40 = TB_C(0.142) - pose_1;
    const real_t t41 = t40 * t40;
    const real_t t42 = TB_SQRT(t39 * t39 + t41);
    const real_t misfit_1 = lengths[1] - t42;
    const real_t t43 = TB_FRAME_Y - pose_1;
    const real_t t44 = TB_SQRT(t37 + t43 * t43);
    const real_t misfit_2 = lengths[2] - t44;
    const real_t t45 = misfit_0 * misfit_0 + misfit_1 * misfit_1 + misfit_2 * misfit_2;
    const real_t t46 = TB_SQRT(t41 + pose_0 * pose_0);
    const real_t misfit_3 = lengths[3] - t46;
    const real_t residual_0 = TB_SQRT(t45 + misfit_3 * misfit_3);
    const real_t t47 = TB_C(0.256036) * tb_max(TB_C(1e-08), TB_C(64.0) * TB_EPSILON);
    const bool t48 = t47 < TB_C(0.128018) && t47 < TB_C(0.040327999999999996);
    const bool t49 = !t48;
    const bool t50 = TB_C(0.0001) < distance_0 && TB_C(0.0001) < distance_1;
    const bool t51 = t50 && TB_C(0.0001) < distance_2 && TB_C(0.0001) < distance_3;
    const bool t52 = t51 && TB_C(0.0001) < t38 && TB_C(0.0001) < t42 && TB_C(0.0001) < t44;
    const bool t53 = !(t52 && TB_C(0.0001) < t46);
    if (t49 || t53) {
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
    const real_t t0 = TB_C(0.064009) - lengths[1] * lengths[1];
    const real_t t1 = TB_C(0.020163999999999998) - lengths[0] * lengths[0];
    const real_t t2 = TB_C(0.020163999999999998) - lengths[2] * lengths[2];
    const real_t t3 = TB_C(0.064009) - lengths[3] * lengths[3];
    const real_t t4 = (t0 + t1 + t2 + t3) * TB_C(0.25);
    const real_t t5 = TB_C(0.253) * (t0 - t4) + -TB_C(0.253) * (t3 - t4);
    const real_t t6 = t5 * TB_C(0.5) * TB_C(7.811401521661017);
    /* differences of squared lengths are linear in the pose */
    const real_t start_0 = TB_C(0.253) + t6;
    const real_t t7 = TB_FRAME_X - start_0;
    const real_t t8 = -TB_C(0.142) * (t1 - t4) + TB_C(0.142) * (t2 - t4);
    const real_t t9 = TB_C(0.5) * t8 * TB_C(24.79666732791113);
    const real_t t10 = t9 * t9;
    /* one Gauss-Newton step */
    const real_t distance_1 = TB_SQRT(t7 * t7 + t10);
    const real_t t11 = TB_C(1.0) / distance_1;
    const real_t t12 = t7 * t11;
    const real_t t13 = distance_1 - lengths[1];
    const real_t t14 = t6 * t6;
    const real_t start_1 = TB_C(0.142) + t9;
    const real_t distance_0 = TB_SQRT(t14 + start_1 * start_1);
    const real_t t15 = TB_C(1.0) / distance_0;
    const real_t t16 = t6 * t15;
    const real_t t17 = distance_0 - lengths[0];
    const real_t t18 = TB_FRAME_Y - start_1;
    const real_t distance_2 = TB_SQRT(t14 + t18 * t18);
    const real_t t19 = TB_C(1.0) / distance_2;
    const real_t t20 = t6 * t19;
    const real_t t21 = distance_2 - lengths[2];
    const real_t distance_3 = TB_SQRT(t10 + start_0 * start_0);
    const real_t t22 = TB_C(1.0) / distance_3;
    const real_t t23 = start_0 * t22;
    const real_t t24 = distance_3 - lengths[3];
    const real_t t25 = t12 * t13 - t16 * t17 - t20 * t21 - t23 * t24;
    const real_t t26 = t16 * t16 + t12 * t12 + t20 * t20 + t23 * t23;
    const real_t t27 = TB_C(1.0) / t26;
    const real_t t28 = start_1 * t15;
    const real_t t29 = t9 * t11;
    const real_t t30 = t18 * t19;
    const real_t t31 = t9 * t22;
    const real_t t32 = t27 * (t16 * t28 - t12 * t29 - t20 * t30 + t23 * t31);
    const real_t t33 = t21 * t30 - (t17 * t28 + t13 * t29) - t24 * t31 - t25 * t32;
    const real_t t34 = t28 * t28 + t29 * t29 + t30 * t30 + t31 * t31 - t26 * (t32 * t32);
    const real_t t35 = t33 / t34;
    const real_t pose_0 = start_0 + (t25 * t27 - t32 * t35);
    const real_t pose_1 = start_1 + t35;
    const real_t t36 = TB_C(0.253) - pose_0;
    const real_t t37 = t36 * t36;
    const real_t t38 = TB_SQRT(t37 + pose_1 * pose_1);
    /* what the lengths disagree by: slack, an encoder fault */
    const real_t misfit_0 = lengths[0] - t38;
    const real_t t39 = TB_FRAME_X - pose_0;
    const real_t t40 = TB_C(0.142) - pose_1;
    const real_t t41 = t40 * t40;
    const real_t t42 = TB_SQRT(t39 * t39 + t41);
    const real_t misfit_1 = lengths[1] - t42;
    const real_t t43 = TB_FRAME_Y - pose_1;
    const real_t t44 = TB_SQRT(t37 + t43 * t43);
    const real_t misfit_2 = lengths[2] - t44;
    const real_t t45 = misfit_0 * misfit_0 + misfit_1 * misfit_1 + misfit_2 * misfit_2;
    const real_t t46 = TB_SQRT(t41 + pose_0 * pose_0);
    const real_t misfit_3 = lengths[3] - t46;
    const real_t residual_0 = TB_SQRT(t45 + misfit_3 * misfit_3);
    const real_t t47 = TB_C(1.0) / t38;
    const real_t structure_0 = t36 * t47;
    const real_t t48 = TB_C(1.0) / t42;
    const real_t structure_1 = t39 * t48;
    const real_t t49 = TB_C(1.0) / t44;
    const real_t structure_2 = t36 * t49;
    const real_t t50 = TB_C(1.0) / t46;
    const real_t t51 = pose_0 * t50;
    const real_t structure_3 = -t51;
    const real_t t52 = pose_1 * t47;
    const real_t structure_4 = -t52;
    const real_t structure_5 = t40 * t48;
    const real_t structure_6 = t43 * t49;
    const real_t structure_7 = t40 * t50;
    const real_t t53 = structure_0 * length_rates[0] + structure_1 * length_rates[1];
    const real_t t54 = t53 + structure_2 * length_rates[2] - t51 * length_rates[3];
    const real_t t55 = structure_0 * structure_0 + structure_1 * structure_1;
    const real_t t56 = t55 + structure_2 * structure_2 + t51 * t51;
    const real_t t57 = TB_C(1.0) / t56;
    const real_t t58 = structure_1 * structure_5 - structure_0 * t52 + structure_2 *
        structure_6;
    const real_t t59 = t57 * (t58 - t51 * structure_7);
    const real_t t60 = structure_5 * length_rates[1] - t52 * length_rates[0];
    const real_t t61 = t60 + structure_6 * length_rates[2] + structure_7 * length_rates[3];
    const real_t t62 = t52 * t52 + structure_5 * structure_5 + structure_6 * structure_6;
    const real_t t63 = t62 + structure_7 * structure_7 - t56 * (t59 * t59);
    const real_t velocity_1 = (t54 * t59 - t61) / t63;
    const real_t velocity_0 = -(t54 * t57 + t59 * velocity_1);
    const real_t t64 = TB_C(0.256036) * tb_max(TB_C(1e-08), TB_C(64.0) * TB_EPSILON);
    const bool t65 = t64 < TB_C(0.128018) && t64 < TB_C(0.040327999999999996);
    const bool t66 = !t65;
    const bool t67 = TB_C(0.0001) < distance_0 && TB_C(0.0001) < distance_1;
    const bool t68 = t67 && TB_C(0.0001) < distance_2 && TB_C(0.0001) < distance_3;
    const bool t69 = t68 && TB_C(0.0001) < t38 && TB_C(0.0001) < t42 && TB_C(0.0001) < t44;
    const bool t70 = !(t69 && TB_C(0.0001) < t46);
    const real_t t71 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t72 = !(t71 < t56 && t71 < t63);
    if (t66 || t70 || t72) {
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

