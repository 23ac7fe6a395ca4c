/* Regenerate: turnbuckle generate machines/yoon_synchronised.toml --out <this folder>
 * Machine 2674137f8fc00ebb, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_kinematics.h"
#include "tb_machine.h"

tb_status tb_base_points(const real_t rails[2], real_t points[8])
{
    if (!(TB_ABS(rails[0]) + TB_ABS(rails[1]) <= TB_C(2.8472))) {
        points[0] = TB_C(0.0);
        points[1] = TB_C(0.0);
        points[2] = TB_C(0.0);
        points[3] = TB_C(0.0);
        points[4] = TB_C(0.0);
        points[5] = TB_C(0.0);
        points[6] = TB_C(0.0);
        points[7] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    points[0] = rails[0];
    points[1] = TB_C(0.0);
    points[2] = TB_FRAME_X;
    points[3] = rails[1];
    points[4] = rails[0];
    points[5] = TB_FRAME_Y;
    points[6] = TB_C(0.0);
    points[7] = rails[1];
    return TB_OK;
}

tb_status tb_cable_vectors(const real_t pose[2], const real_t rails[2], real_t vectors[8])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) <= TB_C(2.8472))) {
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
    const real_t vectors_0 = rails[0] - pose[0];
    const real_t vectors_1 = -pose[1];
    const real_t vectors_2 = TB_FRAME_X - pose[0];
    const real_t vectors_3 = rails[1] - pose[1];
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

tb_status tb_cable_lengths(const real_t pose[2], const real_t rails[2], real_t length[4])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) <= TB_C(2.8472))) {
        return tb_refuse_cable_lengths(TB_OUT_OF_DOMAIN, length);
    }
    const real_t t0 = rails[0] - pose[0];
    const real_t t1 = t0 * t0;
    const real_t length_0 = TB_SQRT(t1 + pose[1] * pose[1]);
    const real_t t2 = TB_FRAME_X - pose[0];
    const real_t t3 = rails[1] - pose[1];
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

tb_status tb_structure_matrix(const real_t pose[2], const real_t rails[2], real_t structure[8])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) <= TB_C(2.8472))) {
        return tb_refuse_structure_matrix(TB_OUT_OF_DOMAIN, structure);
    }
    const real_t t0 = rails[0] - pose[0];
    const real_t t1 = t0 * t0;
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t1 + pose[1] * pose[1]);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t structure_0 = t0 * t2;
    const real_t t3 = TB_FRAME_X - pose[0];
    const real_t t4 = rails[1] - pose[1];
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

tb_status tb_length_jacobian(const real_t pose[2], const real_t rails[2], real_t jacobian[8])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) <= TB_C(2.8472))) {
        return tb_refuse_length_jacobian(TB_OUT_OF_DOMAIN, jacobian);
    }
    const real_t t0 = rails[0] - pose[0];
    const real_t t1 = t0 * t0;
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t1 + pose[1] * pose[1]);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t jacobian_0 = -(t0 * t2);
    const real_t jacobian_1 = pose[1] * t2;
    const real_t t3 = TB_FRAME_X - pose[0];
    const real_t t4 = rails[1] - pose[1];
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

tb_status tb_task_velocity(const real_t pose[2], const real_t rails[2],
    const real_t length_rates[4], const real_t rail_rates[2], real_t velocity[2])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) <= TB_C(2.8472)
          && TB_ABS(length_rates[0]) + TB_ABS(length_rates[1]) + TB_ABS(length_rates[2]) +
              TB_ABS(length_rates[3]) <= TB_C(400.0)
          && TB_ABS(rail_rates[0]) + TB_ABS(rail_rates[1]) <= TB_C(200.0))) {
        return tb_refuse_task_velocity(TB_OUT_OF_DOMAIN, velocity);
    }
    const real_t t0 = rails[0] - pose[0];
    const real_t t1 = t0 * t0;
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t1 + pose[1] * pose[1]);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t t3 = t0 * t2;
    const real_t t4 = length_rates[0] - t3 * rail_rates[0];
    const real_t t5 = TB_FRAME_X - pose[0];
    const real_t t6 = rails[1] - pose[1];
    const real_t t7 = t6 * t6;
    const real_t length_1 = TB_SQRT(t5 * t5 + t7);
    const real_t t8 = TB_C(1.0) / length_1;
    const real_t t9 = t5 * t8;
    const real_t t10 = t6 * t8;
    const real_t t11 = length_rates[1] - t10 * rail_rates[1];
    const real_t t12 = TB_FRAME_Y - pose[1];
    const real_t length_2 = TB_SQRT(t1 + t12 * t12);
    const real_t t13 = TB_C(1.0) / length_2;
    const real_t t14 = t0 * t13;
    const real_t t15 = length_rates[2] - rail_rates[0] * t14;
    const real_t length_3 = TB_SQRT(t7 + pose[0] * pose[0]);
    const real_t t16 = TB_C(1.0) / length_3;
    const real_t t17 = pose[0] * t16;
    const real_t t18 = t6 * t16;
    const real_t t19 = length_rates[3] - rail_rates[1] * t18;
    const real_t t20 = t3 * t4 + t9 * t11 + t14 * t15 - t17 * t19;
    const real_t t21 = t3 * t3 + t9 * t9 + t14 * t14 + t17 * t17;
    const real_t t22 = TB_C(1.0) / t21;
    const real_t t23 = pose[1] * t2;
    const real_t t24 = t12 * t13;
    const real_t t25 = t22 * (t9 * t10 - t3 * t23 + t14 * t24 - t17 * t18);
    const real_t t26 = t20 * t25 - (t10 * t11 - t4 * t23 + t15 * t24 + t18 * t19);
    const real_t t27 = t23 * t23 + t10 * t10 + t24 * t24 + t18 * t18 - t21 * (t25 * t25);
    const real_t velocity_1 = t26 / t27;
    const real_t velocity_0 = -(t20 * t22 + t25 * velocity_1);
    const bool t28 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t29 = t28 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t30 = !t29;
    const real_t t31 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const bool t32 = !(t31 < t21 && t31 < t27);
    if (t30 || t32) {
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

tb_status tb_forward_kinematics(const real_t lengths[4], const real_t rails[2], real_t pose[2],
    real_t residual[1])
{
    if (!(lengths[0] >= TB_C(0.0) && lengths[0] <= TB_C(4.6944)
          && lengths[1] >= TB_C(0.0) && lengths[1] <= TB_C(4.6944)
          && lengths[2] >= TB_C(0.0) && lengths[2] <= TB_C(4.6944)
          && lengths[3] >= TB_C(0.0) && lengths[3] <= TB_C(4.6944)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) <= TB_C(2.8472))) {
        return tb_refuse_forward_kinematics(TB_OUT_OF_DOMAIN, pose, residual);
    }
    const real_t t0 = (rails[0] + (rails[0] + TB_FRAME_X)) * TB_C(0.25);
    const real_t t1 = rails[0] - t0;
    const real_t t2 = t1 * t1;
    const real_t t3 = TB_C(0.25) * (rails[1] + (rails[1] + TB_FRAME_Y));
    const real_t t4 = t3 * t3;
    const real_t t5 = t2 + t4 - lengths[0] * lengths[0];
    const real_t t6 = TB_FRAME_X - t0;
    const real_t t7 = t6 * t6;
    const real_t t8 = rails[1] - t3;
    const real_t t9 = t8 * t8;
    const real_t t10 = t7 + t9 - lengths[1] * lengths[1];
    const real_t t11 = TB_FRAME_Y - t3;
    const real_t t12 = t11 * t11;
    const real_t t13 = t2 + t12 - lengths[2] * lengths[2];
    const real_t t14 = t0 * t0;
    const real_t t15 = t9 + t14 - lengths[3] * lengths[3];
    const real_t t16 = TB_C(0.25) * (t5 + t10 + t13 + t15);
    const real_t t17 = t5 - t16;
    const real_t t18 = t10 - t16;
    const real_t t19 = t13 - t16;
    const real_t t20 = t15 - t16;
    const real_t t21 = (t1 * t17 + t6 * t18 + t1 * t19 - t0 * t20) * TB_C(0.5);
    const real_t t22 = t14 + (t2 + (t2 + t7));
    const real_t t23 = TB_C(1.0) / t22;
    const real_t t24 = t23 * (t6 * t8 - t1 * t3 + t1 * t11 - t0 * t8);
    const real_t t25 = TB_C(0.5) * (t8 * t18 - t3 * t17 + t11 * t19 + t8 * t20);
    const real_t t26 = t9 + (t12 + (t4 + t9)) - t22 * (t24 * t24);
    const real_t t27 = (t25 - t21 * t24) * (TB_C(1.0) / t26);
    /* differences of squared lengths are linear in the pose */
    const real_t start_0 = t0 + (t21 * t23 - t24 * t27);
    const real_t t28 = rails[0] - start_0;
    const real_t t29 = t28 * t28;
    const real_t start_1 = t3 + t27;
    /* one Gauss-Newton step */
    const real_t distance_0 = TB_SQRT(t29 + start_1 * start_1);
    const real_t t30 = TB_C(1.0) / distance_0;
    const real_t t31 = t28 * t30;
    const real_t t32 = distance_0 - lengths[0];
    const real_t t33 = TB_FRAME_X - start_0;
    const real_t t34 = rails[1] - start_1;
    const real_t t35 = t34 * t34;
    const real_t distance_1 = TB_SQRT(t33 * t33 + t35);
    const real_t t36 = TB_C(1.0) / distance_1;
    const real_t t37 = t33 * t36;
    const real_t t38 = distance_1 - lengths[1];
    const real_t t39 = TB_FRAME_Y - start_1;
    const real_t distance_2 = TB_SQRT(t29 + t39 * t39);
    const real_t t40 = TB_C(1.0) / distance_2;
    const real_t t41 = t28 * t40;
    const real_t t42 = distance_2 - lengths[2];
    const real_t distance_3 = TB_SQRT(t35 + start_0 * start_0);
    const real_t t43 = TB_C(1.0) / distance_3;
    const real_t t44 = start_0 * t43;
    const real_t t45 = distance_3 - lengths[3];
    const real_t t46 = t31 * t32 + t37 * t38 + t41 * t42 - t44 * t45;
    const real_t t47 = t31 * t31 + t37 * t37 + t41 * t41 + t44 * t44;
    const real_t t48 = TB_C(1.0) / t47;
    const real_t t49 = t34 * t36;
    const real_t t50 = start_1 * t30;
    const real_t t51 = t39 * t40;
    const real_t t52 = t34 * t43;
    const real_t t53 = t48 * (t37 * t49 - t31 * t50 + t41 * t51 - t44 * t52);
    const real_t t54 = t38 * t49 - t32 * t50 + t42 * t51 + t45 * t52 - t46 * t53;
    const real_t t55 = t50 * t50 + t49 * t49 + t51 * t51 + t52 * t52 - t47 * (t53 * t53);
    const real_t t56 = t54 / t55;
    const real_t pose_0 = start_0 + (t46 * t48 - t53 * t56);
    const real_t pose_1 = start_1 + t56;
    const real_t t57 = rails[0] - pose_0;
    const real_t t58 = t57 * t57;
    const real_t t59 = TB_SQRT(t58 + pose_1 * pose_1);
    /* what the lengths disagree by: slack, an encoder fault */
    const real_t misfit_0 = lengths[0] - t59;
    const real_t t60 = TB_FRAME_X - pose_0;
    const real_t t61 = rails[1] - pose_1;
    const real_t t62 = t61 * t61;
    const real_t t63 = TB_SQRT(t60 * t60 + t62);
    const real_t misfit_1 = lengths[1] - t63;
    const real_t t64 = TB_FRAME_Y - pose_1;
    const real_t t65 = TB_SQRT(t58 + t64 * t64);
    const real_t misfit_2 = lengths[2] - t65;
    const real_t t66 = misfit_0 * misfit_0 + misfit_1 * misfit_1 + misfit_2 * misfit_2;
    const real_t t67 = TB_SQRT(t62 + pose_0 * pose_0);
    const real_t misfit_3 = lengths[3] - t67;
    const real_t residual_0 = TB_SQRT(t66 + misfit_3 * misfit_3);
    const real_t t68 = TB_C(0.50665924) * tb_max(TB_C(1e-08), TB_C(64.0) * TB_EPSILON);
    const bool t69 = !(t68 < t22 && t68 < t26);
    const bool t70 = TB_C(0.0001) < distance_0 && TB_C(0.0001) < distance_1;
    const bool t71 = t70 && TB_C(0.0001) < distance_2 && TB_C(0.0001) < distance_3;
    const bool t72 = t71 && TB_C(0.0001) < t59 && TB_C(0.0001) < t63 && TB_C(0.0001) < t65;
    const bool t73 = !(t72 && TB_C(0.0001) < t67);
    if (t69 || t73) {
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

tb_status tb_locate(const real_t lengths[4], const real_t rails[2],
    const real_t length_rates[4], const real_t rail_rates[2], real_t pose[2],
    real_t residual[1], real_t structure[8], real_t velocity[2])
{
    if (!(lengths[0] >= TB_C(0.0) && lengths[0] <= TB_C(4.6944)
          && lengths[1] >= TB_C(0.0) && lengths[1] <= TB_C(4.6944)
          && lengths[2] >= TB_C(0.0) && lengths[2] <= TB_C(4.6944)
          && lengths[3] >= TB_C(0.0) && lengths[3] <= TB_C(4.6944)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) <= TB_C(2.8472)
          && TB_ABS(length_rates[0]) + TB_ABS(length_rates[1]) + TB_ABS(length_rates[2]) +
              TB_ABS(length_rates[3]) <= TB_C(400.0)
          && TB_ABS(rail_rates[0]) + TB_ABS(rail_rates[1]) <= TB_C(200.0))) {
        return tb_refuse_locate(TB_OUT_OF_DOMAIN, pose, residual, structure, velocity);
    }
    const real_t t0 = (rails[0] + (rails[0] + TB_FRAME_X)) * TB_C(0.25);
    const real_t t1 = rails[0] - t0;
    const real_t t2 = t1 * t1;
    const real_t t3 = TB_C(0.25) * (rails[1] + (rails[1] + TB_FRAME_Y));
    const real_t t4 = t3 * t3;
    const real_t t5 = t2 + t4 - lengths[0] * lengths[0];
    const real_t t6 = TB_FRAME_X - t0;
    const real_t t7 = t6 * t6;
    const real_t t8 = rails[1] - t3;
    const real_t t9 = t8 * t8;
    const real_t t10 = t7 + t9 - lengths[1] * lengths[1];
    const real_t t11 = TB_FRAME_Y - t3;
    const real_t t12 = t11 * t11;
    const real_t t13 = t2 + t12 - lengths[2] * lengths[2];
    const real_t t14 = t0 * t0;
    const real_t t15 = t9 + t14 - lengths[3] * lengths[3];
    const real_t t16 = TB_C(0.25) * (t5 + t10 + t13 + t15);
    const real_t t17 = t5 - t16;
    const real_t t18 = t10 - t16;
    const real_t t19 = t13 - t16;
    const real_t t20 = t15 - t16;
    const real_t t21 = (t1 * t17 + t6 * t18 + t1 * t19 - t0 * t20) * TB_C(0.5);
    const real_t t22 = t14 + (t2 + (t2 + t7));
    const real_t t23 = TB_C(1.0) / t22;
    const real_t t24 = t23 * (t6 * t8 - t1 * t3 + t1 * t11 - t0 * t8);
    const real_t t25 = TB_C(0.5) * (t8 * t18 - t3 * t17 + t11 * t19 + t8 * t20);
    const real_t t26 = t9 + (t12 + (t4 + t9)) - t22 * (t24 * t24);
    const real_t t27 = (t25 - t21 * t24) * (TB_C(1.0) / t26);
    /* differences of squared lengths are linear in the pose */
    const real_t start_0 = t0 + (t21 * t23 - t24 * t27);
    const real_t t28 = rails[0] - start_0;
    const real_t t29 = t28 * t28;
    const real_t start_1 = t3 + t27;
    /* one Gauss-Newton step */
    const real_t distance_0 = TB_SQRT(t29 + start_1 * start_1);
    const real_t t30 = TB_C(1.0) / distance_0;
    const real_t t31 = t28 * t30;
    const real_t t32 = distance_0 - lengths[0];
    const real_t t33 = TB_FRAME_X - start_0;
    const real_t t34 = rails[1] - start_1;
    const real_t t35 = t34 * t34;
    const real_t distance_1 = TB_SQRT(t33 * t33 + t35);
    const real_t t36 = TB_C(1.0) / distance_1;
    const real_t t37 = t33 * t36;
    const real_t t38 = distance_1 - lengths[1];
    const real_t t39 = TB_FRAME_Y - start_1;
    const real_t distance_2 = TB_SQRT(t29 + t39 * t39);
    const real_t t40 = TB_C(1.0) / distance_2;
    const real_t t41 = t28 * t40;
    const real_t t42 = distance_2 - lengths[2];
    const real_t distance_3 = TB_SQRT(t35 + start_0 * start_0);
    const real_t t43 = TB_C(1.0) / distance_3;
    const real_t t44 = start_0 * t43;
    const real_t t45 = distance_3 - lengths[3];
    const real_t t46 = t31 * t32 + t37 * t38 + t41 * t42 - t44 * t45;
    const real_t t47 = t31 * t31 + t37 * t37 + t41 * t41 + t44 * t44;
    const real_t t48 = TB_C(1.0) / t47;
    const real_t t49 = t34 * t36;
    const real_t t50 = start_1 * t30;
    const real_t t51 = t39 * t40;
    const real_t t52 = t34 * t43;
    const real_t t53 = t48 * (t37 * t49 - t31 * t50 + t41 * t51 - t44 * t52);
    const real_t t54 = t38 * t49 - t32 * t50 + t42 * t51 + t45 * t52 - t46 * t53;
    const real_t t55 = t50 * t50 + t49 * t49 + t51 * t51 + t52 * t52 - t47 * (t53 * t53);
    const real_t t56 = t54 / t55;
    const real_t pose_0 = start_0 + (t46 * t48 - t53 * t56);
    const real_t pose_1 = start_1 + t56;
    const real_t t57 = rails[0] - pose_0;
    const real_t t58 = t57 * t57;
    const real_t t59 = TB_SQRT(t58 + pose_1 * pose_1);
    /* what the lengths disagree by: slack, an encoder fault */
    const real_t misfit_0 = lengths[0] - t59;
    const real_t t60 = TB_FRAME_X - pose_0;
    const real_t t61 = rails[1] - pose_1;
    const real_t t62 = t61 * t61;
    const real_t t63 = TB_SQRT(t60 * t60 + t62);
    const real_t misfit_1 = lengths[1] - t63;
    const real_t t64 = TB_FRAME_Y - pose_1;
    const real_t t65 = TB_SQRT(t58 + t64 * t64);
    const real_t misfit_2 = lengths[2] - t65;
    const real_t t66 = misfit_0 * misfit_0 + misfit_1 * misfit_1 + misfit_2 * misfit_2;
    const real_t t67 = TB_SQRT(t62 + pose_0 * pose_0);
    const real_t misfit_3 = lengths[3] - t67;
    const real_t residual_0 = TB_SQRT(t66 + misfit_3 * misfit_3);
    const real_t t68 = TB_C(1.0) / t59;
    const real_t structure_0 = t57 * t68;
    const real_t t69 = TB_C(1.0) / t63;
    const real_t structure_1 = t60 * t69;
    const real_t t70 = TB_C(1.0) / t65;
    const real_t structure_2 = t57 * t70;
    const real_t t71 = TB_C(1.0) / t67;
    const real_t t72 = pose_0 * t71;
    const real_t structure_3 = -t72;
    const real_t t73 = pose_1 * t68;
    const real_t structure_4 = -t73;
    const real_t structure_5 = t61 * t69;
    const real_t structure_6 = t64 * t70;
    const real_t structure_7 = t61 * t71;
    const real_t t74 = length_rates[0] - structure_0 * rail_rates[0];
    const real_t t75 = length_rates[1] - structure_5 * rail_rates[1];
    const real_t t76 = length_rates[2] - structure_2 * rail_rates[0];
    const real_t t77 = structure_0 * t74 + structure_1 * t75 + structure_2 * t76;
    const real_t t78 = length_rates[3] - structure_7 * rail_rates[1];
    const real_t t79 = t77 - t72 * t78;
    const real_t t80 = structure_0 * structure_0 + structure_1 * structure_1;
    const real_t t81 = t80 + structure_2 * structure_2 + t72 * t72;
    const real_t t82 = TB_C(1.0) / t81;
    const real_t t83 = structure_1 * structure_5 - structure_0 * t73 + structure_2 *
        structure_6;
    const real_t t84 = t82 * (t83 - t72 * structure_7);
    const real_t t85 = structure_5 * t75 - t73 * t74 + structure_6 * t76;
    const real_t t86 = t73 * t73 + structure_5 * structure_5 + structure_6 * structure_6;
    const real_t t87 = t86 + structure_7 * structure_7 - t81 * (t84 * t84);
    const real_t velocity_1 = (t79 * t84 - (t85 + structure_7 * t78)) / t87;
    const real_t velocity_0 = -(t79 * t82 + t84 * velocity_1);
    const real_t t88 = TB_C(0.50665924) * tb_max(TB_C(1e-08), TB_C(64.0) * TB_EPSILON);
    const bool t89 = !(t88 < t22 && t88 < t26);
    const bool t90 = TB_C(0.0001) < distance_0 && TB_C(0.0001) < distance_1;
    const bool t91 = t90 && TB_C(0.0001) < distance_2 && TB_C(0.0001) < distance_3;
    const bool t92 = t91 && TB_C(0.0001) < t59 && TB_C(0.0001) < t63 && TB_C(0.0001) < t65;
    const bool t93 = !(t92 && TB_C(0.0001) < t67);
    const real_t t94 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t95 = !(t94 < t81 && t94 < t87);
    if (t89 || t93 || t95) {
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

/* Refuses with a status: jacobian is 0. */
static tb_status tb_refuse_rail_jacobian(tb_status status, real_t jacobian[8])
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

tb_status tb_rail_jacobian(const real_t pose[2], const real_t rails[2], real_t jacobian[8])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) <= TB_C(2.8472))) {
        return tb_refuse_rail_jacobian(TB_OUT_OF_DOMAIN, jacobian);
    }
    const real_t t0 = rails[0] - pose[0];
    const real_t t1 = t0 * t0;
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t1 + pose[1] * pose[1]);
    const real_t jacobian_0 = t0 / length_0;
    const real_t t2 = rails[1] - pose[1];
    const real_t t3 = TB_FRAME_X - pose[0];
    const real_t t4 = t2 * t2;
    const real_t length_1 = TB_SQRT(t3 * t3 + t4);
    const real_t jacobian_3 = t2 / length_1;
    const real_t t5 = TB_FRAME_Y - pose[1];
    const real_t length_2 = TB_SQRT(t1 + t5 * t5);
    const real_t jacobian_4 = t0 / length_2;
    const real_t length_3 = TB_SQRT(t4 + pose[0] * pose[0]);
    const real_t jacobian_7 = t2 / length_3;
    const bool t6 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t7 = t6 && TB_C(0.0001) < length_2 && TB_C(0.0001) < length_3;
    const bool t8 = !t7;
    if (t8) {
        return tb_refuse_rail_jacobian(TB_SINGULAR, jacobian);
    }
    jacobian[0] = jacobian_0;
    jacobian[1] = TB_C(0.0);
    jacobian[2] = TB_C(0.0);
    jacobian[3] = jacobian_3;
    jacobian[4] = jacobian_4;
    jacobian[5] = TB_C(0.0);
    jacobian[6] = TB_C(0.0);
    jacobian[7] = jacobian_7;
    return TB_OK;
}

