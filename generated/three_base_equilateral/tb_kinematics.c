/* Regenerate: turnbuckle generate machines/three_base_equilateral.toml --out <this folder>
 * Machine bf852767ce09ae7f, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_kinematics.h"
#include "tb_machine.h"

tb_status tb_base_points(const real_t rails[6], real_t points[6])
{
    if (!(TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) +
              TB_ABS(rails[4]) + TB_ABS(rails[5]) <= TB_C(8.541599999999999))) {
        points[0] = TB_C(0.0);
        points[1] = TB_C(0.0);
        points[2] = TB_C(0.0);
        points[3] = TB_C(0.0);
        points[4] = TB_C(0.0);
        points[5] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t points_1 = TB_FRAME - rails[1];
    const real_t points_4 = TB_FRAME - rails[5];
    points[0] = rails[0];
    points[1] = points_1;
    points[2] = rails[3];
    points[3] = rails[2];
    points[4] = points_4;
    points[5] = rails[4];
    return TB_OK;
}

tb_status tb_cable_vectors(const real_t pose[2], const real_t rails[6], real_t vectors[6])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) +
              TB_ABS(rails[4]) + TB_ABS(rails[5]) <= TB_C(8.541599999999999))) {
        vectors[0] = TB_C(0.0);
        vectors[1] = TB_C(0.0);
        vectors[2] = TB_C(0.0);
        vectors[3] = TB_C(0.0);
        vectors[4] = TB_C(0.0);
        vectors[5] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    const real_t vectors_0 = rails[0] - pose[0];
    const real_t vectors_1 = TB_FRAME - rails[1] - pose[1];
    const real_t vectors_2 = rails[3] - pose[0];
    const real_t vectors_3 = rails[2] - pose[1];
    const real_t vectors_4 = TB_FRAME - rails[5] - pose[0];
    const real_t vectors_5 = rails[4] - pose[1];
    vectors[0] = vectors_0;
    vectors[1] = vectors_1;
    vectors[2] = vectors_2;
    vectors[3] = vectors_3;
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

tb_status tb_cable_lengths(const real_t pose[2], const real_t rails[6], real_t length[3])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) +
              TB_ABS(rails[4]) + TB_ABS(rails[5]) <= TB_C(8.541599999999999))) {
        return tb_refuse_cable_lengths(TB_OUT_OF_DOMAIN, length);
    }
    const real_t t0 = rails[0] - pose[0];
    const real_t t1 = TB_FRAME - rails[1] - pose[1];
    const real_t length_0 = TB_SQRT(t0 * t0 + t1 * t1);
    const real_t t2 = rails[3] - pose[0];
    const real_t t3 = rails[2] - pose[1];
    const real_t length_1 = TB_SQRT(t2 * t2 + t3 * t3);
    const real_t t4 = TB_FRAME - rails[5] - pose[0];
    const real_t t5 = rails[4] - pose[1];
    const real_t length_2 = TB_SQRT(t4 * t4 + t5 * t5);
    const bool t6 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t7 = !(t6 && TB_C(0.0001) < length_2);
    if (t7) {
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

tb_status tb_structure_matrix(const real_t pose[2], const real_t rails[6], real_t structure[6])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) +
              TB_ABS(rails[4]) + TB_ABS(rails[5]) <= TB_C(8.541599999999999))) {
        return tb_refuse_structure_matrix(TB_OUT_OF_DOMAIN, structure);
    }
    const real_t t0 = rails[0] - pose[0];
    const real_t t1 = TB_FRAME - rails[1] - pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 * t0 + t1 * t1);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t structure_0 = t0 * t2;
    const real_t t3 = rails[3] - pose[0];
    const real_t t4 = rails[2] - pose[1];
    const real_t length_1 = TB_SQRT(t3 * t3 + t4 * t4);
    const real_t t5 = TB_C(1.0) / length_1;
    const real_t structure_1 = t3 * t5;
    const real_t t6 = TB_FRAME - rails[5] - pose[0];
    const real_t t7 = rails[4] - pose[1];
    const real_t length_2 = TB_SQRT(t6 * t6 + t7 * t7);
    const real_t t8 = TB_C(1.0) / length_2;
    const real_t structure_2 = t6 * t8;
    const real_t structure_3 = t1 * t2;
    const real_t structure_4 = t4 * t5;
    const real_t structure_5 = t7 * t8;
    const bool t9 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t10 = !(t9 && TB_C(0.0001) < length_2);
    if (t10) {
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

tb_status tb_length_jacobian(const real_t pose[2], const real_t rails[6], real_t jacobian[6])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) +
              TB_ABS(rails[4]) + TB_ABS(rails[5]) <= TB_C(8.541599999999999))) {
        return tb_refuse_length_jacobian(TB_OUT_OF_DOMAIN, jacobian);
    }
    const real_t t0 = rails[0] - pose[0];
    const real_t t1 = TB_FRAME - rails[1] - pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 * t0 + t1 * t1);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t jacobian_0 = -(t0 * t2);
    const real_t jacobian_1 = -(t1 * t2);
    const real_t t3 = rails[3] - pose[0];
    const real_t t4 = rails[2] - pose[1];
    const real_t length_1 = TB_SQRT(t3 * t3 + t4 * t4);
    const real_t t5 = TB_C(1.0) / length_1;
    const real_t jacobian_2 = -(t3 * t5);
    const real_t jacobian_3 = -(t4 * t5);
    const real_t t6 = TB_FRAME - rails[5] - pose[0];
    const real_t t7 = rails[4] - pose[1];
    const real_t length_2 = TB_SQRT(t6 * t6 + t7 * t7);
    const real_t t8 = TB_C(1.0) / length_2;
    const real_t jacobian_4 = -(t6 * t8);
    const real_t jacobian_5 = -(t7 * t8);
    const bool t9 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t10 = !(t9 && TB_C(0.0001) < length_2);
    if (t10) {
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

tb_status tb_task_velocity(const real_t pose[2], const real_t rails[6],
    const real_t length_rates[3], const real_t rail_rates[6], real_t velocity[2])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) +
              TB_ABS(rails[4]) + TB_ABS(rails[5]) <= TB_C(8.541599999999999)
          && TB_ABS(length_rates[0]) + TB_ABS(length_rates[1]) + TB_ABS(length_rates[2]) <=
              TB_C(300.0)
          && TB_ABS(rail_rates[0]) + TB_ABS(rail_rates[1]) + TB_ABS(rail_rates[2]) +
              TB_ABS(rail_rates[3]) + TB_ABS(rail_rates[4]) + TB_ABS(rail_rates[5]) <=
              TB_C(600.0))) {
        return tb_refuse_task_velocity(TB_OUT_OF_DOMAIN, velocity);
    }
    const real_t t0 = rails[0] - pose[0];
    const real_t t1 = TB_FRAME - rails[1] - pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 * t0 + t1 * t1);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t t3 = t0 * t2;
    const real_t t4 = t1 * t2;
    const real_t t5 = length_rates[0] - t3 * rail_rates[0] + t4 * rail_rates[1];
    const real_t t6 = rails[3] - pose[0];
    const real_t t7 = rails[2] - pose[1];
    const real_t length_1 = TB_SQRT(t6 * t6 + t7 * t7);
    const real_t t8 = TB_C(1.0) / length_1;
    const real_t t9 = t6 * t8;
    const real_t t10 = t7 * t8;
    const real_t t11 = length_rates[1] - t10 * rail_rates[2] - t9 * rail_rates[3];
    const real_t t12 = TB_FRAME - rails[5] - pose[0];
    const real_t t13 = rails[4] - pose[1];
    const real_t length_2 = TB_SQRT(t12 * t12 + t13 * t13);
    const real_t t14 = TB_C(1.0) / length_2;
    const real_t t15 = t12 * t14;
    const real_t t16 = t13 * t14;
    const real_t t17 = length_rates[2] - t16 * rail_rates[4] + t15 * rail_rates[5];
    const real_t t18 = t3 * t5 + t9 * t11 + t15 * t17;
    const real_t t19 = t3 * t3 + t9 * t9 + t15 * t15;
    const real_t t20 = TB_C(1.0) / t19;
    const real_t t21 = t20 * (t3 * t4 + t9 * t10 + t15 * t16);
    const real_t t22 = t4 * t4 + t10 * t10 + t16 * t16 - t19 * (t21 * t21);
    const real_t velocity_1 = (t18 * t21 - (t4 * t5 + t10 * t11 + t16 * t17)) / t22;
    const real_t velocity_0 = -(t18 * t20 + t21 * velocity_1);
    const bool t23 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t24 = !(t23 && TB_C(0.0001) < length_2);
    const real_t t25 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const bool t26 = !(t25 < t19 && t25 < t22);
    if (t24 || t26) {
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

tb_status tb_forward_kinematics(const real_t lengths[3], const real_t rails[6], real_t pose[2],
    real_t residual[1])
{
    if (!(lengths[0] >= TB_C(0.0) && lengths[0] <= TB_C(5.6944)
          && lengths[1] >= TB_C(0.0) && lengths[1] <= TB_C(5.6944)
          && lengths[2] >= TB_C(0.0) && lengths[2] <= TB_C(5.6944)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) +
              TB_ABS(rails[4]) + TB_ABS(rails[5]) <= TB_C(8.541599999999999))) {
        return tb_refuse_forward_kinematics(TB_OUT_OF_DOMAIN, pose, residual);
    }
    const real_t t0 = TB_FRAME - rails[5];
    const real_t t1 = (rails[0] + rails[3] + t0) * TB_C(0.3333333333333333);
    const real_t t2 = rails[0] - t1;
    const real_t t3 = t2 * t2;
    const real_t t4 = TB_FRAME - rails[1];
    const real_t t5 = TB_C(0.3333333333333333) * (t4 + rails[2] + rails[4]);
    const real_t t6 = t4 - t5;
    const real_t t7 = t6 * t6;
    const real_t t8 = t3 + t7 - lengths[0] * lengths[0];
    const real_t t9 = rails[3] - t1;
    const real_t t10 = t9 * t9;
    const real_t t11 = rails[2] - t5;
    const real_t t12 = t11 * t11;
    const real_t t13 = t10 + t12 - lengths[1] * lengths[1];
    const real_t t14 = t0 - t1;
    const real_t t15 = t14 * t14;
    const real_t t16 = rails[4] - t5;
    const real_t t17 = t16 * t16;
    const real_t t18 = t15 + t17 - lengths[2] * lengths[2];
    const real_t t19 = TB_C(0.3333333333333333) * (t8 + t13 + t18);
    const real_t t20 = t8 - t19;
    const real_t t21 = t13 - t19;
    const real_t t22 = t18 - t19;
    const real_t t23 = (t2 * t20 + t9 * t21 + t14 * t22) * TB_C(0.5);
    const real_t t24 = t15 + (t3 + t10);
    const real_t t25 = TB_C(1.0) / t24;
    const real_t t26 = t25 * (t2 * t6 + t9 * t11 + t14 * t16);
    const real_t t27 = TB_C(0.5) * (t6 * t20 + t11 * t21 + t16 * t22) - t23 * t26;
    const real_t t28 = t17 + (t7 + t12) - t24 * (t26 * t26);
    const real_t t29 = t27 * (TB_C(1.0) / t28);
    /* differences of squared lengths are linear in the pose */
    const real_t start_0 = t1 + (t23 * t25 - t26 * t29);
    const real_t t30 = rails[0] - start_0;
    const real_t start_1 = t5 + t29;
    const real_t t31 = t4 - start_1;
    /* one Gauss-Newton step */
    const real_t distance_0 = TB_SQRT(t30 * t30 + t31 * t31);
    const real_t t32 = TB_C(1.0) / distance_0;
    const real_t t33 = t30 * t32;
    const real_t t34 = distance_0 - lengths[0];
    const real_t t35 = rails[3] - start_0;
    const real_t t36 = rails[2] - start_1;
    const real_t distance_1 = TB_SQRT(t35 * t35 + t36 * t36);
    const real_t t37 = TB_C(1.0) / distance_1;
    const real_t t38 = t35 * t37;
    const real_t t39 = distance_1 - lengths[1];
    const real_t t40 = t0 - start_0;
    const real_t t41 = rails[4] - start_1;
    const real_t distance_2 = TB_SQRT(t40 * t40 + t41 * t41);
    const real_t t42 = TB_C(1.0) / distance_2;
    const real_t t43 = t40 * t42;
    const real_t t44 = distance_2 - lengths[2];
    const real_t t45 = t33 * t34 + t38 * t39 + t43 * t44;
    const real_t t46 = t33 * t33 + t38 * t38 + t43 * t43;
    const real_t t47 = TB_C(1.0) / t46;
    const real_t t48 = t31 * t32;
    const real_t t49 = t36 * t37;
    const real_t t50 = t41 * t42;
    const real_t t51 = t47 * (t33 * t48 + t38 * t49 + t43 * t50);
    const real_t t52 = t48 * t48 + t49 * t49 + t50 * t50 - t46 * (t51 * t51);
    const real_t t53 = (t34 * t48 + t39 * t49 + t44 * t50 - t45 * t51) / t52;
    const real_t pose_0 = start_0 + (t45 * t47 - t51 * t53);
    const real_t pose_1 = start_1 + t53;
    const real_t t54 = rails[0] - pose_0;
    const real_t t55 = t4 - pose_1;
    const real_t t56 = TB_SQRT(t54 * t54 + t55 * t55);
    /* what the lengths disagree by: slack, an encoder fault */
    const real_t misfit_0 = lengths[0] - t56;
    const real_t t57 = rails[3] - pose_0;
    const real_t t58 = rails[2] - pose_1;
    const real_t t59 = TB_SQRT(t57 * t57 + t58 * t58);
    const real_t misfit_1 = lengths[1] - t59;
    const real_t t60 = t0 - pose_0;
    const real_t t61 = rails[4] - pose_1;
    const real_t t62 = TB_SQRT(t60 * t60 + t61 * t61);
    const real_t misfit_2 = lengths[2] - t62;
    const real_t t63 = misfit_0 * misfit_0 + misfit_1 * misfit_1 + misfit_2 * misfit_2;
    const real_t residual_0 = TB_SQRT(t63);
    const real_t t64 = TB_C(0.50665924) * tb_max(TB_C(1e-08), TB_C(64.0) * TB_EPSILON);
    const bool t65 = !(t64 < t24 && t64 < t28);
    const bool t66 = TB_C(0.0001) < distance_0 && TB_C(0.0001) < distance_1;
    const bool t67 = t66 && TB_C(0.0001) < distance_2 && TB_C(0.0001) < t56;
    const bool t68 = !(t67 && TB_C(0.0001) < t59 && TB_C(0.0001) < t62);
    if (t65 || t68) {
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

tb_status tb_locate(const real_t lengths[3], const real_t rails[6],
    const real_t length_rates[3], const real_t rail_rates[6], real_t pose[2],
    real_t residual[1], real_t structure[6], real_t velocity[2])
{
    if (!(lengths[0] >= TB_C(0.0) && lengths[0] <= TB_C(5.6944)
          && lengths[1] >= TB_C(0.0) && lengths[1] <= TB_C(5.6944)
          && lengths[2] >= TB_C(0.0) && lengths[2] <= TB_C(5.6944)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) +
              TB_ABS(rails[4]) + TB_ABS(rails[5]) <= TB_C(8.541599999999999)
          && TB_ABS(length_rates[0]) + TB_ABS(length_rates[1]) + TB_ABS(length_rates[2]) <=
              TB_C(300.0)
          && TB_ABS(rail_rates[0]) + TB_ABS(rail_rates[1]) + TB_ABS(rail_rates[2]) +
              TB_ABS(rail_rates[3]) + TB_ABS(rail_rates[4]) + TB_ABS(rail_rates[5]) <=
              TB_C(600.0))) {
        return tb_refuse_locate(TB_OUT_OF_DOMAIN, pose, residual, structure, velocity);
    }
    const real_t t0 = TB_FRAME - rails[5];
    const real_t t1 = (rails[0] + rails[3] + t0) * TB_C(0.3333333333333333);
    const real_t t2 = rails[0] - t1;
    const real_t t3 = t2 * t2;
    const real_t t4 = TB_FRAME - rails[1];
    const real_t t5 = TB_C(0.3333333333333333) * (t4 + rails[2] + rails[4]);
    const real_t t6 = t4 - t5;
    const real_t t7 = t6 * t6;
    const real_t t8 = t3 + t7 - lengths[0] * lengths[0];
    const real_t t9 = rails[3] - t1;
    const real_t t10 = t9 * t9;
    const real_t t11 = rails[2] - t5;
    const real_t t12 = t11 * t11;
    const real_t t13 = t10 + t12 - lengths[1] * lengths[1];
    const real_t t14 = t0 - t1;
    const real_t t15 = t14 * t14;
    const real_t t16 = rails[4] - t5;
    const real_t t17 = t16 * t16;
    const real_t t18 = t15 + t17 - lengths[2] * lengths[2];
    const real_t t19 = TB_C(0.3333333333333333) * (t8 + t13 + t18);
    const real_t t20 = t8 - t19;
    const real_t t21 = t13 - t19;
    const real_t t22 = t18 - t19;
    const real_t t23 = (t2 * t20 + t9 * t21 + t14 * t22) * TB_C(0.5);
    const real_t t24 = t15 + (t3 + t10);
    const real_t t25 = TB_C(1.0) / t24;
    const real_t t26 = t25 * (t2 * t6 + t9 * t11 + t14 * t16);
    const real_t t27 = TB_C(0.5) * (t6 * t20 + t11 * t21 + t16 * t22) - t23 * t26;
    const real_t t28 = t17 + (t7 + t12) - t24 * (t26 * t26);
    const real_t t29 = t27 * (TB_C(1.0) / t28);
    /* differences of squared lengths are linear in the pose */
    const real_t start_0 = t1 + (t23 * t25 - t26 * t29);
    const real_t t30 = rails[0] - start_0;
    const real_t start_1 = t5 + t29;
    const real_t t31 = t4 - start_1;
    /* one Gauss-Newton step */
    const real_t distance_0 = TB_SQRT(t30 * t30 + t31 * t31);
    const real_t t32 = TB_C(1.0) / distance_0;
    const real_t t33 = t30 * t32;
    const real_t t34 = distance_0 - lengths[0];
    const real_t t35 = rails[3] - start_0;
    const real_t t36 = rails[2] - start_1;
    const real_t distance_1 = TB_SQRT(t35 * t35 + t36 * t36);
    const real_t t37 = TB_C(1.0) / distance_1;
    const real_t t38 = t35 * t37;
    const real_t t39 = distance_1 - lengths[1];
    const real_t t40 = t0 - start_0;
    const real_t t41 = rails[4] - start_1;
    const real_t distance_2 = TB_SQRT(t40 * t40 + t41 * t41);
    const real_t t42 = TB_C(1.0) / distance_2;
    const real_t t43 = t40 * t42;
    const real_t t44 = distance_2 - lengths[2];
    const real_t t45 = t33 * t34 + t38 * t39 + t43 * t44;
    const real_t t46 = t33 * t33 + t38 * t38 + t43 * t43;
    const real_t t47 = TB_C(1.0) / t46;
    const real_t t48 = t31 * t32;
    const real_t t49 = t36 * t37;
    const real_t t50 = t41 * t42;
    const real_t t51 = t47 * (t33 * t48 + t38 * t49 + t43 * t50);
    const real_t t52 = t48 * t48 + t49 * t49 + t50 * t50 - t46 * (t51 * t51);
    const real_t t53 = (t34 * t48 + t39 * t49 + t44 * t50 - t45 * t51) / t52;
    const real_t pose_0 = start_0 + (t45 * t47 - t51 * t53);
    const real_t pose_1 = start_1 + t53;
    const real_t t54 = rails[0] - pose_0;
    const real_t t55 = t4 - pose_1;
    const real_t t56 = TB_SQRT(t54 * t54 + t55 * t55);
    /* what the lengths disagree by: slack, an encoder fault */
    const real_t misfit_0 = lengths[0] - t56;
    const real_t t57 = rails[3] - pose_0;
    const real_t t58 = rails[2] - pose_1;
    const real_t t59 = TB_SQRT(t57 * t57 + t58 * t58);
    const real_t misfit_1 = lengths[1] - t59;
    const real_t t60 = t0 - pose_0;
    const real_t t61 = rails[4] - pose_1;
    const real_t t62 = TB_SQRT(t60 * t60 + t61 * t61);
    const real_t misfit_2 = lengths[2] - t62;
    const real_t t63 = misfit_0 * misfit_0 + misfit_1 * misfit_1 + misfit_2 * misfit_2;
    const real_t residual_0 = TB_SQRT(t63);
    const real_t t64 = TB_C(1.0) / t56;
    const real_t structure_0 = t54 * t64;
    const real_t t65 = TB_C(1.0) / t59;
    const real_t structure_1 = t57 * t65;
    const real_t t66 = TB_C(1.0) / t62;
    const real_t structure_2 = t60 * t66;
    const real_t structure_3 = t55 * t64;
    const real_t structure_4 = t58 * t65;
    const real_t structure_5 = t61 * t66;
    const real_t t67 = length_rates[0] - structure_0 * rail_rates[0] + structure_3 *
        rail_rates[1];
    const real_t t68 = length_rates[1] - structure_4 * rail_rates[2] - structure_1 *
        rail_rates[3];
    const real_t t69 = length_rates[2] - structure_5 * rail_rates[4] + structure_2 *
        rail_rates[5];
    const real_t t70 = structure_0 * t67 + structure_1 * t68 + structure_2 * t69;
    const real_t t71 = structure_0 * structure_0 + structure_1 * structure_1;
    const real_t t72 = t71 + structure_2 * structure_2;
    const real_t t73 = TB_C(1.0) / t72;
    const real_t t74 = structure_0 * structure_3 + structure_1 * structure_4;
    const real_t t75 = t73 * (t74 + structure_2 * structure_5);
    const real_t t76 = structure_3 * t67 + structure_4 * t68 + structure_5 * t69;
    const real_t t77 = structure_3 * structure_3 + structure_4 * structure_4;
    const real_t t78 = t77 + structure_5 * structure_5 - t72 * (t75 * t75);
    const real_t velocity_1 = (t70 * t75 - t76) / t78;
    const real_t velocity_0 = -(t70 * t73 + t75 * velocity_1);
    const real_t t79 = TB_C(0.50665924) * tb_max(TB_C(1e-08), TB_C(64.0) * TB_EPSILON);
    const bool t80 = !(t79 < t24 && t79 < t28);
    const bool t81 = TB_C(0.0001) < distance_0 && TB_C(0.0001) < distance_1;
    const bool t82 = t81 && TB_C(0.0001) < distance_2 && TB_C(0.0001) < t56;
    const bool t83 = !(t82 && TB_C(0.0001) < t59 && TB_C(0.0001) < t62);
    const real_t t84 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t85 = !(t84 < t72 && t84 < t78);
    if (t80 || t83 || t85) {
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

/* Refuses with a status: jacobian is 0. */
static tb_status tb_refuse_rail_jacobian(tb_status status, real_t jacobian[18])
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
    jacobian[12] = TB_C(0.0);
    jacobian[13] = TB_C(0.0);
    jacobian[14] = TB_C(0.0);
    jacobian[15] = TB_C(0.0);
    jacobian[16] = TB_C(0.0);
    jacobian[17] = TB_C(0.0);
    return status;
}

tb_status tb_rail_jacobian(const real_t pose[2], const real_t rails[6], real_t jacobian[18])
{
    if (!(TB_ABS(pose[0]) + TB_ABS(pose[1]) <= TB_C(2.8472)
          && TB_ABS(rails[0]) + TB_ABS(rails[1]) + TB_ABS(rails[2]) + TB_ABS(rails[3]) +
              TB_ABS(rails[4]) + TB_ABS(rails[5]) <= TB_C(8.541599999999999))) {
        return tb_refuse_rail_jacobian(TB_OUT_OF_DOMAIN, jacobian);
    }
    const real_t t0 = rails[0] - pose[0];
    const real_t t1 = TB_FRAME - rails[1] - pose[1];
    /* l_i = |b_i - c|, Yoon eq. 18 */
    const real_t length_0 = TB_SQRT(t0 * t0 + t1 * t1);
    const real_t t2 = TB_C(1.0) / length_0;
    const real_t jacobian_0 = t0 * t2;
    const real_t jacobian_1 = -(t1 * t2);
    const real_t t3 = rails[2] - pose[1];
    const real_t t4 = rails[3] - pose[0];
    const real_t length_1 = TB_SQRT(t4 * t4 + t3 * t3);
    const real_t t5 = TB_C(1.0) / length_1;
    const real_t jacobian_8 = t3 * t5;
    const real_t jacobian_9 = t4 * t5;
    const real_t t6 = rails[4] - pose[1];
    const real_t t7 = TB_FRAME - rails[5] - pose[0];
    const real_t length_2 = TB_SQRT(t7 * t7 + t6 * t6);
    const real_t t8 = TB_C(1.0) / length_2;
    const real_t jacobian_16 = t6 * t8;
    const real_t jacobian_17 = -(t7 * t8);
    const bool t9 = TB_C(0.0001) < length_0 && TB_C(0.0001) < length_1;
    const bool t10 = !(t9 && TB_C(0.0001) < length_2);
    if (t10) {
        return tb_refuse_rail_jacobian(TB_SINGULAR, jacobian);
    }
    jacobian[0] = jacobian_0;
    jacobian[1] = jacobian_1;
    jacobian[2] = TB_C(0.0);
    jacobian[3] = TB_C(0.0);
    jacobian[4] = TB_C(0.0);
    jacobian[5] = TB_C(0.0);
    jacobian[6] = TB_C(0.0);
    jacobian[7] = TB_C(0.0);
    jacobian[8] = jacobian_8;
    jacobian[9] = jacobian_9;
    jacobian[10] = TB_C(0.0);
    jacobian[11] = TB_C(0.0);
    jacobian[12] = TB_C(0.0);
    jacobian[13] = TB_C(0.0);
    jacobian[14] = TB_C(0.0);
    jacobian[15] = TB_C(0.0);
    jacobian[16] = jacobian_16;
    jacobian[17] = jacobian_17;
    return TB_OK;
}

