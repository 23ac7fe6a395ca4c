/* Regenerate: turnbuckle generate machines/brau_tetrahedron.toml --out <this folder>
 * Machine 1c3579fddb96c4cf, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_kinematics.h"
#include "tb_machine.h"

tb_status tb_base_points(const real_t rails[1], real_t points[12])
{
    (void)rails;
    points[0] = TB_C(0.0);
    points[1] = TB_C(0.0);
    points[2] = TB_C(0.0);
    points[3] = TB_FRAME_X;
    points[4] = TB_C(0.0);
    points[5] = TB_C(0.0);
    points[6] = TB_C(0.5);
    points[7] = TB_FRAME_Y;
    points[8] = TB_C(0.0);
    points[9] = TB_C(0.5);
    points[10] = TB_BASE_4_Y;
    points[11] = TB_FRAME_Z;
    return TB_OK;
}

tb_status tb_cable_vectors(const real_t pose[3], const real_t rails[1], real_t vectors[12])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) + TB_ABS(pose[2]) <= TB_C(6.0))) {
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
        vectors[10] = TB_C(0.0);
        vectors[11] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t vectors_0 = -pose[0];
    const real_t vectors_1 = -pose[1];
    const real_t vectors_2 = -pose[2];
    const real_t vectors_3 = TB_FRAME_X - pose[0];
    const real_t vectors_6 = TB_C(0.5) - pose[0];
    const real_t vectors_7 = TB_FRAME_Y - pose[1];
    const real_t vectors_10 = TB_BASE_4_Y - pose[1];
    const real_t vectors_11 = TB_FRAME_Z - pose[2];
    vectors[0] = vectors_0;
    vectors[1] = vectors_1;
    vectors[2] = vectors_2;
    vectors[3] = vectors_3;
    vectors[4] = vectors_1;
    vectors[5] = vectors_2;
    vectors[6] = vectors_6;
    vectors[7] = vectors_7;
    vectors[8] = vectors_2;
    vectors[9] = vectors_6;
    vectors[10] = vectors_10;
    vectors[11] = vectors_11;
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

tb_status tb_cable_lengths(const real_t pose[3], const real_t rails[1], real_t length[4])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) + TB_ABS(pose[2]) <= TB_C(6.0))) {
        return tb_refuse_cable_lengths(TB_OUT_OF_DOMAIN, length);
    }
    const real_t t0 = pose[1] * pose[1];
    const real_t t1 = pose[2] * pose[2];
    const real_t length_0 = TB_SQRT(pose[0] * pose[0] + t0 + t1);
    const real_t t2 = TB_FRAME_X - pose[0];
    const real_t length_1 = TB_SQRT(t1 + (t0 + t2 * t2));
    const real_t t3 = TB_C(0.5) - pose[0];
    const real_t t4 = t3 * t3;
    const real_t t5 = TB_FRAME_Y - pose[1];
    const real_t length_2 = TB_SQRT(t1 + (t4 + t5 * t5));
    const real_t t6 = TB_BASE_4_Y - pose[1];
    const real_t t7 = TB_FRAME_Z - pose[2];
    const real_t length_3 = TB_SQRT(t4 + t6 * t6 + t7 * t7);
    const bool t8 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t9 = t8 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t10 = !t9;
    if (t10) {
        return tb_refuse_cable_lengths(TB_SINGULAR, length);
    }
    length[0] = length_0;
    length[1] = length_1;
    length[2] = length_2;
    length[3] = length_3;
    return TB_OK;
}

/* Refuses with a status: structure is 0. */
static tb_status tb_refuse_structure_matrix(tb_status status, real_t structure[12])
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
    structure[10] = TB_C(0.0);
    structure[11] = TB_C(0.0);
    return status;
}

tb_status tb_structure_matrix(const real_t pose[3], const real_t rails[1], real_t structure[12])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) + TB_ABS(pose[2]) <= TB_C(6.0))) {
        return tb_refuse_structure_matrix(TB_OUT_OF_DOMAIN, structure);
    }
    const real_t t0 = pose[1] * pose[1];
    const real_t t1 = pose[2] * pose[2];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(pose[0] * pose[0] + t0 + t1);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t structure_0 = -(pose[0] * t2);
    const real_t t3 = TB_FRAME_X - pose[0];
    const real_t length_1 = TB_SQRT(t1 + (t0 + t3 * t3));
    const real_t t4 = TB_C(1.0) / length_1;
    const real_t structure_1 = t3 * t4;
    const real_t t5 = TB_C(0.5) - pose[0];
    const real_t t6 = t5 * t5;
    const real_t t7 = TB_FRAME_Y - pose[1];
    const real_t length_2 = TB_SQRT(t1 + (t6 + t7 * t7));
    const real_t t8 = TB_C(1.0) / length_2;
    const real_t structure_2 = t5 * t8;
    const real_t t9 = TB_BASE_4_Y - pose[1];
    const real_t t10 = TB_FRAME_Z - pose[2];
    const real_t length_3 = TB_SQRT(t6 + t9 * t9 + t10 * t10);
    const real_t t11 = TB_C(1.0) / length_3;
    const real_t structure_3 = t5 * t11;
    const real_t structure_4 = -(pose[1] * t2);
    const real_t structure_5 = -(pose[1] * t4);
    const real_t structure_6 = t7 * t8;
    const real_t structure_7 = t9 * t11;
    const real_t structure_8 = -(pose[2] * t2);
    const real_t structure_9 = -(pose[2] * t4);
    const real_t structure_10 = -(pose[2] * t8);
    const real_t structure_11 = t10 * t11;
    const bool t12 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t13 = t12 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t14 = !t13;
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
    structure[10] = structure_10;
    structure[11] = structure_11;
    return TB_OK;
}

/* Refuses with a status: jacobian is 0. */
static tb_status tb_refuse_length_jacobian(tb_status status, real_t jacobian[12])
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
    jacobian[10] = TB_C(0.0);
    jacobian[11] = TB_C(0.0);
    return status;
}

tb_status tb_length_jacobian(const real_t pose[3], const real_t rails[1], real_t jacobian[12])
{
    (void)rails;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) + TB_ABS(pose[2]) <= TB_C(6.0))) {
        return tb_refuse_length_jacobian(TB_OUT_OF_DOMAIN, jacobian);
    }
    const real_t t0 = pose[1] * pose[1];
    const real_t t1 = pose[2] * pose[2];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(pose[0] * pose[0] + t0 + t1);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t jacobian_0 = pose[0] * t2;
    const real_t jacobian_1 = pose[1] * t2;
    const real_t jacobian_2 = pose[2] * t2;
    const real_t t3 = TB_FRAME_X - pose[0];
    const real_t length_1 = TB_SQRT(t1 + (t0 + t3 * t3));
    const real_t t4 = TB_C(1.0) / length_1;
    const real_t jacobian_3 = -(t3 * t4);
    const real_t jacobian_4 = pose[1] * t4;
    const real_t jacobian_5 = pose[2] * t4;
    const real_t t5 = TB_C(0.5) - pose[0];
    const real_t t6 = t5 * t5;
    const real_t t7 = TB_FRAME_Y - pose[1];
    const real_t length_2 = TB_SQRT(t1 + (t6 + t7 * t7));
    const real_t t8 = TB_C(1.0) / length_2;
    const real_t jacobian_6 = -(t5 * t8);
    const real_t jacobian_7 = -(t7 * t8);
    const real_t jacobian_8 = pose[2] * t8;
    const real_t t9 = TB_BASE_4_Y - pose[1];
    const real_t t10 = TB_FRAME_Z - pose[2];
    const real_t length_3 = TB_SQRT(t6 + t9 * t9 + t10 * t10);
    const real_t t11 = TB_C(1.0) / length_3;
    const real_t jacobian_9 = -(t5 * t11);
    const real_t jacobian_10 = -(t9 * t11);
    const real_t jacobian_11 = -(t10 * t11);
    const bool t12 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t13 = t12 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t14 = !t13;
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
    jacobian[10] = jacobian_10;
    jacobian[11] = jacobian_11;
    return TB_OK;
}

/* Refuses with a status: velocity is 0 m/s. */
static tb_status tb_refuse_task_velocity(tb_status status, real_t velocity[3])
{
    velocity[0] = TB_C(0.0);
    velocity[1] = TB_C(0.0);
    velocity[2] = TB_C(0.0);
    return status;
}

tb_status tb_task_velocity(const real_t pose[3], const real_t rails[1],
    const real_t length_rates[4], const real_t rail_rates[1], real_t velocity[3])
{
    (void)rails;
    (void)rail_rates;
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) + TB_ABS(pose[2]) <= TB_C(6.0)
          && TB_ABS(length_rates[0]) + TB_ABS(length_rates[1]) + TB_ABS(length_rates[2]) +
              TB_ABS(length_rates[3]) <= TB_C(400.0))) {
        return tb_refuse_task_velocity(TB_OUT_OF_DOMAIN, velocity);
    }
    const real_t t0 = TB_FRAME_X - pose[0];
    const real_t t1 = pose[1] * pose[1];
    const real_t t2 = pose[2] * pose[2];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_1 = TB_SQRT(t0 * t0 + t1 + t2);
    const real_t t3 = TB_C(1.0) / length_1;
    const real_t t4 = t0 * t3;
    const real_t length_0 = TB_SQRT(t2 + (t1 + pose[0] * pose[0]));
    const real_t t5 = TB_C(1.0) / length_0;
    const real_t t6 = pose[0] * t5;
    const real_t t7 = TB_C(0.5) - pose[0];
    const real_t t8 = t7 * t7;
    const real_t t9 = TB_FRAME_Y - pose[1];
    const real_t length_2 = TB_SQRT(t2 + (t8 + t9 * t9));
    const real_t t10 = TB_C(1.0) / length_2;
    const real_t t11 = t7 * t10;
    const real_t t12 = t4 * length_rates[1] - t6 * length_rates[0] + t11 * length_rates[2];
    const real_t t13 = TB_BASE_4_Y - pose[1];
    const real_t t14 = TB_FRAME_Z - pose[2];
    const real_t length_3 = TB_SQRT(t8 + t13 * t13 + t14 * t14);
    const real_t t15 = TB_C(1.0) / length_3;
    const real_t t16 = t7 * t15;
    const real_t t17 = t12 + t16 * length_rates[3];
    const real_t t18 = t6 * t6 + t4 * t4 + t11 * t11 + t16 * t16;
    const real_t t19 = TB_C(1.0) / t18;
    const real_t t20 = pose[1] * t5;
    const real_t t21 = pose[1] * t3;
    const real_t t22 = t9 * t10;
    const real_t t23 = t13 * t15;
    const real_t t24 = t19 * (t6 * t20 - t4 * t21 + t11 * t22 + t16 * t23);
    const real_t t25 = length_rates[2] * t22 - (length_rates[0] * t20 + length_rates[1] * t21);
    const real_t t26 = t17 * t24 - (t25 + length_rates[3] * t23);
    const real_t t27 = t20 * t20 + t21 * t21 + t22 * t22 + t23 * t23 - t18 * (t24 * t24);
    const real_t t28 = TB_C(1.0) / t27;
    const real_t t29 = pose[2] * t5;
    const real_t t30 = pose[2] * t3;
    const real_t t31 = pose[2] * t10;
    const real_t t32 = t14 * t15;
    const real_t t33 = t19 * (t6 * t29 - t4 * t30 - t11 * t31 + t16 * t32);
    const real_t t34 = t20 * t29 + t21 * t30 - t22 * t31 + t23 * t32 - t18 * (t24 * t33);
    const real_t t35 = t28 * t34;
    const real_t t36 = length_rates[0] * t29 + length_rates[1] * t30 + length_rates[2] * t31;
    const real_t t37 = t17 * t33 - (length_rates[3] * t32 - t36) - t26 * t35;
    const real_t t38 = t29 * t29 + t30 * t30 + t31 * t31 + t32 * t32 - t18 * (t33 * t33);
    const real_t t39 = t38 - t27 * (t35 * t35);
    const real_t velocity_2 = t37 / t39;
    const real_t velocity_1 = t26 * t28 - t35 * velocity_2;
    const real_t velocity_0 = -(t17 * t19 + t24 * velocity_1 + t33 * velocity_2);
    const bool t40 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t41 = t40 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t42 = !t41;
    const real_t t43 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const bool t44 = !(t43 < t18 && t43 < t27 && t43 < t39);
    if (t42 || t44) {
        return tb_refuse_task_velocity(TB_SINGULAR, velocity);
    }
    velocity[0] = velocity_0;
    velocity[1] = velocity_1;
    velocity[2] = velocity_2;
    return TB_OK;
}

/* Refuses with a status: pose is 0 m; residual is 0 m. */
static tb_status tb_refuse_forward_kinematics(tb_status status, real_t pose[3],
    real_t residual[1])
{
    pose[0] = TB_C(0.0);
    pose[1] = TB_C(0.0);
    pose[2] = TB_C(0.0);
    residual[0] = TB_C(0.0);
    return status;
}

tb_status tb_forward_kinematics(const real_t lengths[4], const real_t rails[1], real_t pose[3],
    real_t residual[1])
{
    (void)rails;
    if (!(lengths[0] >= TB_C(0.0) && lengths[0] <= TB_C(10.730087938848659)
          && lengths[1] >= TB_C(0.0) && lengths[1] <= TB_C(10.730087938848659)
          && lengths[2] >= TB_C(0.0) && lengths[2] <= TB_C(10.730087938848659)
          && lengths[3] >= TB_C(0.0) && lengths[3] <= TB_C(10.730087938848659))) {
        return tb_refuse_forward_kinematics(TB_OUT_OF_DOMAIN, pose, residual);
    }
    const real_t t0 = TB_C(0.375) - lengths[0] * lengths[0];
    const real_t t1 = TB_C(0.375) - lengths[1] * lengths[1];
    const real_t t2 = TB_C(0.375) - lengths[2] * lengths[2];
    const real_t t3 = TB_C(0.37499999999999994) - lengths[3] * lengths[3];
    const real_t t4 = (t0 + t1 + t2 + t3) * TB_C(0.25);
    const real_t t5 = t0 - t4;
    const real_t t6 = t1 - t4;
    const real_t t7 = -TB_C(0.5) * t5 + TB_C(0.5) * t6;
    /* differences of squared lengths are linear in the pose */
    const real_t start_0 = TB_C(0.5) + t7;
    const real_t t8 = TB_C(1.0) - start_0;
    const real_t t9 = t5 * -TB_C(0.28867513459481287) + t6 * -TB_C(0.28867513459481287);
    const real_t t10 = t2 - t4;
    const real_t t11 = t3 - t4;
    const real_t t12 = t9 + TB_C(0.5773502691896257) * t10 + TB_C(5.551115123125783e-17) * t11;
    const real_t t13 = t5 * -TB_C(0.2041241452319315) + t6 * -TB_C(0.2041241452319315);
    const real_t t14 = t13 + t10 * -TB_C(0.2041241452319315) + t11 * TB_C(0.6123724356957945);
    const real_t t15 = TB_C(0.5) * t14 - TB_C(6.798699777552591e-17) * (TB_C(0.5) * t12);
    const real_t t16 = t15 * TB_C(2.0000000000000004);
    const real_t start_1 = TB_C(0.28867513459481287) + (t12 - TB_C(6.798699777552591e-17) *
        t16);
    const real_t t17 = start_1 * start_1;
    const real_t start_2 = t16 + TB_C(0.2041241452319315);
    const real_t t18 = start_2 * start_2;
    /* one Gauss-Newton step */
    const real_t distance_1 = TB_SQRT(t8 * t8 + t17 + t18);
    const real_t t19 = TB_C(1.0) / distance_1;
    const real_t t20 = t8 * t19;
    const real_t t21 = distance_1 - lengths[1];
    const real_t distance_0 = TB_SQRT(t18 + (t17 + start_0 * start_0));
    const real_t t22 = TB_C(1.0) / distance_0;
    const real_t t23 = start_0 * t22;
    const real_t t24 = distance_0 - lengths[0];
    const real_t t25 = t7 * t7;
    const real_t t26 = TB_C(0.8660254037844386) - start_1;
    const real_t distance_2 = TB_SQRT(t18 + (t25 + t26 * t26));
    const real_t t27 = TB_C(1.0) / distance_2;
    const real_t t28 = t7 * t27;
    const real_t t29 = distance_2 - lengths[2];
    const real_t t30 = TB_C(0.2886751345948129) - start_1;
    const real_t t31 = TB_C(0.816496580927726) - start_2;
    const real_t distance_3 = TB_SQRT(t25 + t30 * t30 + t31 * t31);
    const real_t t32 = TB_C(1.0) / distance_3;
    const real_t t33 = t7 * t32;
    const real_t t34 = distance_3 - lengths[3];
    const real_t t35 = t20 * t21 - t23 * t24 - t28 * t29 - t33 * t34;
    const real_t t36 = t23 * t23 + t20 * t20 + t28 * t28 + t33 * t33;
    const real_t t37 = TB_C(1.0) / t36;
    const real_t t38 = start_1 * t22;
    const real_t t39 = start_1 * t19;
    const real_t t40 = t26 * t27;
    const real_t t41 = t30 * t32;
    const real_t t42 = t37 * (t23 * t38 - t20 * t39 - t28 * t40 - t33 * t41);
    const real_t t43 = t29 * t40 - (t24 * t38 + t21 * t39) + t34 * t41 - t35 * t42;
    const real_t t44 = t38 * t38 + t39 * t39 + t40 * t40 + t41 * t41 - t36 * (t42 * t42);
    const real_t t45 = TB_C(1.0) / t44;
    const real_t t46 = start_2 * t22;
    const real_t t47 = start_2 * t19;
    const real_t t48 = start_2 * t27;
    const real_t t49 = t31 * t32;
    const real_t t50 = t37 * (t23 * t46 - t20 * t47 + t28 * t48 - t33 * t49);
    const real_t t51 = t38 * t46 + t39 * t47 - t40 * t48 + t41 * t49 - t36 * (t42 * t50);
    const real_t t52 = t45 * t51;
    const real_t t53 = t34 * t49 - (t24 * t46 + t21 * t47 + t29 * t48) - t35 * t50;
    const real_t t54 = t46 * t46 + t47 * t47 + t48 * t48 + t49 * t49 - t36 * (t50 * t50);
    const real_t t55 = (t53 - t43 * t52) / (t54 - t44 * (t52 * t52));
    const real_t t56 = t43 * t45 - t52 * t55;
    const real_t pose_0 = start_0 + (t35 * t37 - t42 * t56 - t50 * t55);
    const real_t pose_1 = start_1 + t56;
    const real_t pose_2 = start_2 + t55;
    const real_t t57 = pose_1 * pose_1;
    const real_t t58 = pose_2 * pose_2;
    const real_t t59 = TB_SQRT(pose_0 * pose_0 + t57 + t58);
    /* what the lengths disagree by: slack, an encoder fault */
    const real_t misfit_0 = lengths[0] - t59;
    const real_t t60 = TB_C(1.0) - pose_0;
    const real_t t61 = TB_SQRT(t58 + (t57 + t60 * t60));
    const real_t misfit_1 = lengths[1] - t61;
    const real_t t62 = TB_C(0.5) - pose_0;
    const real_t t63 = t62 * t62;
    const real_t t64 = TB_C(0.8660254037844386) - pose_1;
    const real_t t65 = TB_SQRT(t58 + (t63 + t64 * t64));
    const real_t misfit_2 = lengths[2] - t65;
    const real_t t66 = misfit_0 * misfit_0 + misfit_1 * misfit_1 + misfit_2 * misfit_2;
    const real_t t67 = TB_C(0.2886751345948129) - pose_1;
    const real_t t68 = TB_C(0.816496580927726) - pose_2;
    const real_t t69 = TB_SQRT(t63 + t67 * t67 + t68 * t68);
    const real_t misfit_3 = lengths[3] - t69;
    const real_t residual_0 = TB_SQRT(t66 + misfit_3 * misfit_3);
    const real_t t70 = tb_max(TB_C(1e-08), TB_C(64.0) * TB_EPSILON);
    const bool t71 = t70 < TB_C(0.5) && t70 < TB_C(0.49999999999999994);
    const bool t72 = !t71;
    const bool t73 = TB_C(0.0001) < distance_0 && TB_C(0.0001) < distance_1;
    const bool t74 = t73 && TB_C(0.0001) < distance_2 && TB_C(0.0001) < distance_3;
    const bool t75 = t74 && TB_C(0.0001) < t59 && TB_C(0.0001) < t61 && TB_C(0.0001) < t65;
    const bool t76 = !(t75 && TB_C(0.0001) < t69);
    if (t72 || t76) {
        return tb_refuse_forward_kinematics(TB_SINGULAR, pose, residual);
    }
    pose[0] = pose_0;
    pose[1] = pose_1;
    pose[2] = pose_2;
    residual[0] = residual_0;
    return TB_OK;
}

/* Refuses with a status: pose is 0 m; residual is 0 m; structure is 0; velocity is 0 m/s. */
static tb_status tb_refuse_locate(tb_status status, real_t pose[3], real_t residual[1],
    real_t structure[12], real_t velocity[3])
{
    pose[0] = TB_C(0.0);
    pose[1] = TB_C(0.0);
    pose[2] = TB_C(0.0);
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
    structure[10] = TB_C(0.0);
    structure[11] = TB_C(0.0);
    velocity[0] = TB_C(0.0);
    velocity[1] = TB_C(0.0);
    velocity[2] = TB_C(0.0);
    return status;
}

tb_status tb_locate(const real_t lengths[4], const real_t rails[1],
    const real_t length_rates[4], const real_t rail_rates[1], real_t pose[3],
    real_t residual[1], real_t structure[12], real_t velocity[3])
{
    (void)rails;
    (void)rail_rates;
    if (!(lengths[0] >= TB_C(0.0) && lengths[0] <= TB_C(10.730087938848659)
          && lengths[1] >= TB_C(0.0) && lengths[1] <= TB_C(10.730087938848659)
          && lengths[2] >= TB_C(0.0) && lengths[2] <= TB_C(10.730087938848659)
          && lengths[3] >= TB_C(0.0) && lengths[3] <= TB_C(10.730087938848659)
          && TB_ABS(length_rates[0]) + TB_ABS(length_rates[1]) + TB_ABS(length_rates[2]) +
              TB_ABS(length_rates[3]) <= TB_C(400.0))) {
        return tb_refuse_locate(TB_OUT_OF_DOMAIN, pose, residual, structure, velocity);
    }
    const real_t t0 = TB_C(0.375) - lengths[0] * lengths[0];
    const real_t t1 = TB_C(0.375) - lengths[1] * lengths[1];
    const real_t t2 = TB_C(0.375) - lengths[2] * lengths[2];
    const real_t t3 = TB_C(0.37499999999999994) - lengths[3] * lengths[3];
    const real_t t4 = (t0 + t1 + t2 + t3) * TB_C(0.25);
    const real_t t5 = t0 - t4;
    const real_t t6 = t1 - t4;
    const real_t t7 = -TB_C(0.5) * t5 + TB_C(0.5) * t6;
    /* differences of squared lengths are linear in the pose */
    const real_t start_0 = TB_C(0.5) + t7;
    const real_t t8 = TB_C(1.0) - start_0;
    const real_t t9 = t5 * -TB_C(0.28867513459481287) + t6 * -TB_C(0.28867513459481287);
    const real_t t10 = t2 - t4;
    const real_t t11 = t3 - t4;
    const real_t t12 = t9 + TB_C(0.5773502691896257) * t10 + TB_C(5.551115123125783e-17) * t11;
    const real_t t13 = t5 * -TB_C(0.2041241452319315) + t6 * -TB_C(0.2041241452319315);
    const real_t t14 = t13 + t10 * -TB_C(0.2041241452319315) + t11 * TB_C(0.6123724356957945);
    const real_t t15 = TB_C(0.5) * t14 - TB_C(6.798699777552591e-17) * (TB_C(0.5) * t12);
    const real_t t16 = t15 * TB_C(2.0000000000000004);
    const real_t start_1 = TB_C(0.28867513459481287) + (t12 - TB_C(6.798699777552591e-17) *
        t16);
    const real_t t17 = start_1 * start_1;
    const real_t start_2 = t16 + TB_C(0.2041241452319315);
    const real_t t18 = start_2 * start_2;
    /* one Gauss-Newton step */
    const real_t distance_1 = TB_SQRT(t8 * t8 + t17 + t18);
    const real_t t19 = TB_C(1.0) / distance_1;
    const real_t t20 = t8 * t19;
    const real_t t21 = distance_1 - lengths[1];
    const real_t distance_0 = TB_SQRT(t18 + (t17 + start_0 * start_0));
    const real_t t22 = TB_C(1.0) / distance_0;
    const real_t t23 = start_0 * t22;
    const real_t t24 = distance_0 - lengths[0];
    const real_t t25 = t7 * t7;
    const real_t t26 = TB_C(0.8660254037844386) - start_1;
    const real_t distance_2 = TB_SQRT(t18 + (t25 + t26 * t26));
    const real_t t27 = TB_C(1.0) / distance_2;
    const real_t t28 = t7 * t27;
    const real_t t29 = distance_2 - lengths[2];
    const real_t t30 = TB_C(0.2886751345948129) - start_1;
    const real_t t31 = TB_C(0.816496580927726) - start_2;
    const real_t distance_3 = TB_SQRT(t25 + t30 * t30 + t31 * t31);
    const real_t t32 = TB_C(1.0) / distance_3;
    const real_t t33 = t7 * t32;
    const real_t t34 = distance_3 - lengths[3];
    const real_t t35 = t20 * t21 - t23 * t24 - t28 * t29 - t33 * t34;
    const real_t t36 = t23 * t23 + t20 * t20 + t28 * t28 + t33 * t33;
    const real_t t37 = TB_C(1.0) / t36;
    const real_t t38 = start_1 * t22;
    const real_t t39 = start_1 * t19;
    const real_t t40 = t26 * t27;
    const real_t t41 = t30 * t32;
    const real_t t42 = t37 * (t23 * t38 - t20 * t39 - t28 * t40 - t33 * t41);
    const real_t t43 = t29 * t40 - (t24 * t38 + t21 * t39) + t34 * t41 - t35 * t42;
    const real_t t44 = t38 * t38 + t39 * t39 + t40 * t40 + t41 * t41 - t36 * (t42 * t42);
    const real_t t45 = TB_C(1.0) / t44;
    const real_t t46 = start_2 * t22;
    const real_t t47 = start_2 * t19;
    const real_t t48 = start_2 * t27;
    const real_t t49 = t31 * t32;
    const real_t t50 = t37 * (t23 * t46 - t20 * t47 + t28 * t48 - t33 * t49);
    const real_t t51 = t38 * t46 + t39 * t47 - t40 * t48 + t41 * t49 - t36 * (t42 * t50);
    const real_t t52 = t45 * t51;
    const real_t t53 = t34 * t49 - (t24 * t46 + t21 * t47 + t29 * t48) - t35 * t50;
    const real_t t54 = t46 * t46 + t47 * t47 + t48 * t48 + t49 * t49 - t36 * (t50 * t50);
    const real_t t55 = (t53 - t43 * t52) / (t54 - t44 * (t52 * t52));
    const real_t t56 = t43 * t45 - t52 * t55;
    const real_t pose_0 = start_0 + (t35 * t37 - t42 * t56 - t50 * t55);
    const real_t pose_1 = start_1 + t56;
    const real_t pose_2 = start_2 + t55;
    const real_t t57 = pose_1 * pose_1;
    const real_t t58 = pose_2 * pose_2;
    const real_t t59 = TB_SQRT(pose_0 * pose_0 + t57 + t58);
    /* what the lengths disagree by: slack, an encoder fault */
    const real_t misfit_0 = lengths[0] - t59;
    const real_t t60 = TB_C(1.0) - pose_0;
    const real_t t61 = TB_SQRT(t58 + (t57 + t60 * t60));
    const real_t misfit_1 = lengths[1] - t61;
    const real_t t62 = TB_C(0.5) - pose_0;
    const real_t t63 = t62 * t62;
    const real_t t64 = TB_C(0.8660254037844386) - pose_1;
    const real_t t65 = TB_SQRT(t58 + (t63 + t64 * t64));
    const real_t misfit_2 = lengths[2] - t65;
    const real_t t66 = misfit_0 * misfit_0 + misfit_1 * misfit_1 + misfit_2 * misfit_2;
    const real_t t67 = TB_C(0.2886751345948129) - pose_1;
    const real_t t68 = TB_C(0.816496580927726) - pose_2;
    const real_t t69 = TB_SQRT(t63 + t67 * t67 + t68 * t68);
    const real_t misfit_3 = lengths[3] - t69;
    const real_t residual_0 = TB_SQRT(t66 + misfit_3 * misfit_3);
    const real_t t70 = TB_C(1.0) / t59;
    const real_t t71 = pose_0 * t70;
    const real_t structure_0 = -t71;
    const real_t t72 = TB_C(1.0) / t61;
    const real_t structure_1 = t60 * t72;
    const real_t t73 = TB_C(1.0) / t65;
    const real_t structure_2 = t62 * t73;
    const real_t t74 = TB_C(1.0) / t69;
    const real_t structure_3 = t62 * t74;
    const real_t t75 = pose_1 * t70;
    const real_t structure_4 = -t75;
    const real_t t76 = pose_1 * t72;
    const real_t structure_5 = -t76;
    const real_t structure_6 = t64 * t73;
    const real_t structure_7 = t67 * t74;
    const real_t t77 = pose_2 * t70;
    const real_t structure_8 = -t77;
    const real_t t78 = pose_2 * t72;
    const real_t structure_9 = -t78;
    const real_t t79 = pose_2 * t73;
    const real_t structure_10 = -t79;
    const real_t structure_11 = t68 * t74;
    const real_t t80 = structure_1 * length_rates[1] - t71 * length_rates[0];
    const real_t t81 = t80 + structure_2 * length_rates[2] + structure_3 * length_rates[3];
    const real_t t82 = t71 * t71 + structure_1 * structure_1 + structure_2 * structure_2;
    const real_t t83 = t82 + structure_3 * structure_3;
    const real_t t84 = TB_C(1.0) / t83;
    const real_t t85 = t71 * t75 - structure_1 * t76 + structure_2 * structure_6;
    const real_t t86 = t84 * (t85 + structure_3 * structure_7);
    const real_t t87 = structure_6 * length_rates[2] - (t75 * length_rates[0] + t76 *
        length_rates[1]);
    const real_t t88 = t81 * t86 - (t87 + structure_7 * length_rates[3]);
    const real_t t89 = t75 * t75 + t76 * t76 + structure_6 * structure_6;
    const real_t t90 = t89 + structure_7 * structure_7 - t83 * (t86 * t86);
    const real_t t91 = TB_C(1.0) / t90;
    const real_t t92 = t75 * t77 + t76 * t78 - structure_6 * t79 + structure_7 * structure_11;
    const real_t t93 = t71 * t77 - structure_1 * t78 - structure_2 * t79;
    const real_t t94 = t84 * (t93 + structure_3 * structure_11);
    const real_t t95 = t91 * (t92 - t83 * (t86 * t94));
    const real_t t96 = t77 * length_rates[0] + t78 * length_rates[1] + t79 * length_rates[2];
    const real_t t97 = t81 * t94 - (structure_11 * length_rates[3] - t96);
    const real_t t98 = t77 * t77 + t78 * t78 + t79 * t79 + structure_11 * structure_11;
    const real_t t99 = t98 - t83 * (t94 * t94) - t90 * (t95 * t95);
    const real_t velocity_2 = (t97 - t88 * t95) / t99;
    const real_t velocity_1 = t88 * t91 - t95 * velocity_2;
    const real_t velocity_0 = -(t81 * t84 + t86 * velocity_1 + t94 * velocity_2);
    const real_t t100 = tb_max(TB_C(1e-08), TB_C(64.0) * TB_EPSILON);
    const bool t101 = t100 < TB_C(0.5) && t100 < TB_C(0.49999999999999994);
    const bool t102 = !t101;
    const bool t103 = TB_C(0.0001) < distance_0 && TB_C(0.0001) < distance_1;
    const bool t104 = t103 && TB_C(0.0001) < distance_2 && TB_C(0.0001) < distance_3;
    const bool t105 = t104 && TB_C(0.0001) < t59 && TB_C(0.0001) < t61 && TB_C(0.0001) < t65;
    const bool t106 = !(t105 && TB_C(0.0001) < t69);
    const real_t t107 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t108 = !(t107 < t83 && t107 < t90 && t107 < t99);
    if (t102 || t106 || t108) {
        return tb_refuse_locate(TB_SINGULAR, pose, residual, structure, velocity);
    }
    pose[0] = pose_0;
    pose[1] = pose_1;
    pose[2] = pose_2;
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
    structure[10] = structure_10;
    structure[11] = structure_11;
    velocity[0] = velocity_0;
    velocity[1] = velocity_1;
    velocity[2] = velocity_2;
    return TB_OK;
}

