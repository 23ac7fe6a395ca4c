"""The reference kinematics of every kind: geometry by hand, differences, virtual work, inverses."""

import numpy as np
import pytest
from reference_poses import NAMES, WIDE_EPS, Wide, machine_of, random_poses

from turnbuckle.model.machine import Machine
from turnbuckle.model.pulley import Pulley
from turnbuckle.model.reference.cable_path import cable_path
from turnbuckle.model.reference.kinematics import (
    anchor_points,
    base_points,
    cable_lengths,
    cable_vectors,
    forward_kinematics,
    length_jacobian,
    rail_jacobian,
    rotation_jacobian,
    structure_matrix,
    task_velocity,
)
from turnbuckle.model.reference.orientation import rotation, skew
from turnbuckle.model.reference.statics import rail_forces, wrench

STEP = np.longdouble(1e-5)
# The error of a central difference: the square of the step over the shortest length there is.
SHORTEST = 0.005
DIFFERENCE = float((STEP / SHORTEST) ** 2)

MACHINES = [machine_of(name) for name in NAMES]
RIGID = [machine for machine in MACHINES if machine.is_rigid]
every_machine = pytest.mark.parametrize("machine", MACHINES, ids=lambda m: m.name)
turning = pytest.mark.parametrize("machine", RIGID, ids=lambda m: m.name)


def test_a_cable_leaves_a_planar_pulley_along_the_tangent_it_is_wound_to() -> None:
    """A wheel of radius 1; the cable comes down on its left side and goes round below it."""
    left = Pulley(1.0, winds=1, contact=(-1.0, 0.0))
    anchors = np.array([[-1.0, -3.0], [2.0, -1.0], [1.0, 2.0], [0.0, 1.0]])
    path = cable_path(anchors, left)
    assert np.allclose(path.length[:3], [3, 2 + np.pi / 2, 2 + np.pi], rtol=1e-15, atol=0)
    assert np.allclose(path.vector[:3], [[0, 3], [-2, 0], [0, -2]], rtol=0, atol=1e-15)
    assert np.isnan(path.length[3]) and np.all(np.isnan(path.vector[3]))


def test_a_pulley_wound_to_the_right_is_the_mirror_image_of_one_wound_to_the_left() -> None:
    rng = np.random.default_rng(0)
    anchors = rng.normal(0, 5, (500, 2))
    left = cable_path(anchors, Pulley(1.0, winds=1, contact=(-0.6, 0.8)))
    right = cable_path(anchors * [1, -1], Pulley(1.0, winds=-1, contact=(-0.6, -0.8)))
    assert np.allclose(left.length, right.length, rtol=1e-14, atol=0, equal_nan=True)
    assert np.allclose(left.vector, right.vector * [1, -1], rtol=0, atol=1e-14, equal_nan=True)


def test_a_swivelling_pulley_turns_to_the_anchor() -> None:
    """Radius 1, the cable comes down: it leaves level, upwards again, and at the swivel axis."""
    pulley = Pulley(1.0, axis=(0.0, 0.0, -1.0))
    anchors = np.array([[0.0, 5.0, -1.0], [-2.0, 0.0, 3.0], [1.2, -1.6, 7.0], [0.0, 0.0, -5.0]])
    path = cable_path(anchors, pulley)
    wanted = [4 + np.pi / 2, 3 + np.pi, 7 + np.pi]
    assert np.allclose(path.length[:3], wanted, rtol=1e-15, atol=0)
    level, up, aslant = path.vector[:3]
    assert np.allclose(level, [0, -4, 0], rtol=0, atol=1e-14)
    assert np.allclose([up, aslant], [[0, 0, -3], [0, 0, -7]], rtol=0, atol=1e-14)
    assert np.isnan(path.length[3])


def test_the_straight_part_is_tangent_and_the_rest_is_the_arc_that_was_wound() -> None:
    rng = np.random.default_rng(1)
    anchors = rng.normal(0, 0.3, (500, 2)).astype(np.longdouble)
    anchors = anchors[np.sum(anchors**2, axis=-1) > 0.01]
    contact = np.array([0.28, 0.96])
    path = cable_path(anchors, Pulley(0.05, winds=1, contact=tuple(contact)))
    rim = anchors + path.vector
    assert np.allclose(np.sum(rim**2, axis=-1), 0.05**2, rtol=1e-15, atol=0)
    assert np.allclose(np.sum(rim * path.vector, axis=-1), 0, rtol=0, atol=1e-18)
    arc = path.length - np.sqrt(np.sum(path.vector**2, axis=-1))
    turned = np.arctan2(rim[:, 1], rim[:, 0]) - np.arctan2(contact[1], contact[0])
    around = (turned + np.pi / 2) % (2 * np.pi) - np.pi / 2
    assert np.allclose(arc, 0.05 * around, rtol=0, atol=1e-15)


@every_machine
def test_jacobians_are_the_differences_of_the_lengths(machine: Machine) -> None:
    pose, rails = random_poses(machine, 100)

    def slope(of_pose: Wide, of_rails: Wide) -> Wide:
        ahead = cable_lengths(machine, pose + STEP * of_pose, rails + STEP * of_rails)
        behind = cable_lengths(machine, pose - STEP * of_pose, rails - STEP * of_rails)
        return np.asarray((ahead - behind) / (2 * STEP))

    d, m = machine.dof, len(machine.rails)
    by_pose = np.stack([slope(axis, np.zeros(m)) for axis in np.eye(d)], axis=-1)
    turned = length_jacobian(machine, pose, rails) @ rotation_jacobian(machine, pose)
    assert np.max(np.abs(turned - by_pose)) < DIFFERENCE
    for k, axis in enumerate(np.eye(m)):
        by_rail = slope(np.zeros(d), axis)
        assert np.max(np.abs(rail_jacobian(machine, pose, rails)[..., k] - by_rail)) < DIFFERENCE


@turning
def test_a_pose_turns_with_the_angular_velocity_of_its_twist(machine: Machine) -> None:
    pose, _ = random_poses(machine, 50)
    pose[0, machine.space :] = 0
    pose[1, machine.space :] = 1e-6
    upright = rotation(machine, pose)
    twist = rotation_jacobian(machine, pose)[:, machine.space :, machine.space :]
    for k, axis in enumerate(np.eye(machine.dof)[machine.space :]):
        turned = rotation(machine, pose + STEP * axis) - rotation(machine, pose - STEP * axis)
        spin = turned / (2 * STEP) @ np.swapaxes(upright, -1, -2)
        expected = skew(twist[..., k]) if machine.space == 3 else np.array([[0, -1], [1, 0]])
        assert np.max(np.abs(spin - expected)) < float(STEP) ** 2


@turning
def test_rotations_keep_lengths_and_turn_right_handed(machine: Machine) -> None:
    pose, _ = random_poses(machine, 50)
    turned = rotation(machine, pose)
    kept = turned @ np.swapaxes(turned, -1, -2)
    assert np.max(np.abs(kept - np.eye(machine.space))) < 10 * WIDE_EPS
    pose[:, machine.space :] = 0
    pose[:, -1] = np.arccos(np.longdouble(0))
    assert np.allclose(rotation(machine, pose)[0, :2, :2], [[0, -1], [1, 0]], rtol=0, atol=1e-18)


@every_machine
def test_the_work_of_the_tensions_is_that_of_wrench_and_rail_forces(machine: Machine) -> None:
    """Virtual work (Yoon eq. 8): -T . dl = W . dx + F_rail . ds, to rounding."""
    pose, rails = random_poses(machine, 300)
    rng = np.random.default_rng(2)
    tension = rng.uniform(3, 30, (300, len(machine.cables))).astype(np.longdouble)
    twist, rates = rng.normal(size=pose.shape), rng.normal(size=rails.shape)
    lengths = np.sum(length_jacobian(machine, pose, rails) * twist[:, None, :], axis=-1)
    lengths += np.sum(rail_jacobian(machine, pose, rails) * rates[:, None, :], axis=-1)
    force = wrench(machine, structure_matrix(machine, pose, rails), tension)
    on_rails = rail_forces(machine, pose, rails, tension)
    work = np.sum(force * twist, axis=-1) + np.sum(on_rails * rates, axis=-1)
    assert np.max(np.abs(work + np.sum(tension * lengths, axis=-1))) < 1e4 * WIDE_EPS


@every_machine
def test_moments_are_those_of_the_cable_forces_about_the_centre(machine: Machine) -> None:
    pose, rails = random_poses(machine, 50)
    vectors = cable_vectors(machine, pose, rails)
    forces = vectors / np.sqrt(np.sum(vectors**2, axis=-1, keepdims=True))
    structure = np.swapaxes(structure_matrix(machine, pose, rails), -1, -2)
    assert np.array_equal(structure[..., : machine.space], forces)
    if machine.is_rigid:
        arms = anchor_points(machine, pose) - pose[:, None, : machine.space]
        flat = [(0, 0)] * 2 + [(0, 3 - machine.space)]
        moments = np.cross(np.pad(arms, flat), np.pad(forces, flat))
        moments = moments if machine.space == 3 else moments[..., 2:]
        assert np.allclose(structure[..., machine.space :], moments, rtol=0, atol=10 * WIDE_EPS)


@every_machine
def test_a_consistent_motion_gives_back_its_velocity(machine: Machine) -> None:
    pose, rails = random_poses(machine, 300)
    rng = np.random.default_rng(1)
    twist, rates = rng.normal(size=pose.shape), rng.normal(size=rails.shape)
    lengths = np.sum(length_jacobian(machine, pose, rails) * twist[:, None, :], axis=-1)
    lengths += np.sum(rail_jacobian(machine, pose, rails) * rates[:, None, :], axis=-1)
    found = task_velocity(machine, pose, rails, lengths, rates)
    assert np.max(np.abs(found - twist)) < 1e5 * WIDE_EPS


@every_machine
def test_forward_kinematics_undoes_the_lengths(machine: Machine) -> None:
    pose, rails = random_poses(machine, 300)
    guess = np.zeros(machine.dof)
    guess[: machine.space] = machine.target.centre
    lengths = cable_lengths(machine, pose, rails)
    found = forward_kinematics(machine, lengths, rails, guess)
    assert found.pose.dtype == found.residual.dtype == np.longdouble
    assert np.max(np.abs(found.pose - pose)) < 1e5 * WIDE_EPS
    assert np.max(found.residual) < 100 * WIDE_EPS


@every_machine
def test_forward_kinematics_of_wrong_lengths_is_a_least_squares_fit(machine: Machine) -> None:
    pose, rails = random_poses(machine, 100)
    noise = np.random.default_rng(3).normal(0, 1e-4, (100, len(machine.cables)))
    lengths = cable_lengths(machine, pose, rails) + noise
    found = forward_kinematics(machine, lengths, rails, pose)
    left = lengths - cable_lengths(machine, found.pose, rails)
    slope = np.sum(structure_matrix(machine, found.pose, rails) * left[:, None, :], axis=-1)
    assert np.max(np.abs(slope)) < 1e-15
    assert np.all(found.residual <= np.sqrt(np.sum(noise**2, axis=-1)))


def test_a_machine_that_needs_a_guess_says_so() -> None:
    machine = machine_of("spatial_rigid_eight")
    with pytest.raises(ValueError, match="spatial_rigid_eight needs a guess of the pose"):
        forward_kinematics(machine, np.ones(8), np.zeros(0))


def test_coupled_bases_move_together_and_a_base_in_a_plane_both_ways() -> None:
    machine = machine_of("planar_rigid_pulleys")
    still, moved = (base_points(machine, rails) for rails in ([0.0, 0, 0], [0.1, 0.06, 0.03]))
    step = moved - still
    assert np.allclose(step[1], [0.1, 0], rtol=0, atol=1e-15)
    follower = np.array([-280, -20]) / np.hypot(280, 20)
    assert np.allclose(step[2], 0.1 * follower, rtol=0, atol=1e-15)
    across = np.array([-20, -180]) / np.hypot(20, 180)
    assert np.allclose(step[3], 0.06 * np.array([1, 0]) + 0.03 * across, rtol=0, atol=1e-15)
    assert np.array_equal(step[[0, 4, 5]], np.zeros((3, 2)))


@every_machine
def test_every_function_broadcasts_poses_against_rails(machine: Machine) -> None:
    pose, rails = random_poses(machine, 4)
    grid = cable_lengths(machine, pose[:, None, :], rails[None, :3, :])
    assert grid.shape == (4, 3, len(machine.cables))
    assert np.array_equal(grid[2, 1], cable_lengths(machine, pose[2], rails[1]))
    back = forward_kinematics(machine, grid, rails[:3], pose[:, None, :])
    assert back.pose.shape == (4, 3, machine.dof)
