"""Forces and control laws of every kind of machine, from what they must do."""

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation
from unmeasured import EVERY_KIND, geometry, machine_named

from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic.function import Status

Reals = NDArray[np.floating[Any]]
POINTS = 2000
PLANAR = [name for name in EVERY_KIND if machine_named(name).space == 2]


def poses(machine: Machine, random: np.random.Generator) -> Reals:
    """Poses anywhere in the frame."""
    position = random.random((POINTS, machine.space)) * machine.frame.size
    angles = random.uniform(-1, 1, (POINTS, machine.dof - machine.space)) * machine.rotation
    return np.hstack([position, angles / np.sqrt(max(1, angles.shape[1]))])


def rail_coordinates(machine: Machine, random: np.random.Generator) -> Reals:
    return random.random((POINTS, len(machine.rails))) * [rail.length for rail in machine.rails]


@pytest.mark.parametrize("name", EVERY_KIND)
def test_walls_push_the_centre_and_make_no_moment(name: str) -> None:
    generated = geometry(name)
    machine, random = generated.machine, np.random.default_rng(91)
    pose = poses(machine, random)
    velocity = random.uniform(-1, 1, pose.shape)
    force = np.asarray(generated.wall_force(pose, velocity))
    wanted = np.zeros_like(force)
    for wall in machine.walls:
        normal = np.asarray(wall.normal)
        depth = (np.asarray(wall.point) - pose[:, : machine.space]) @ normal
        push = wall.stiffness * depth - wall.damping * velocity[:, : machine.space] @ normal
        pushed = np.where((depth > 0) & (push > 0), push, 0.0)
        wanted[:, : machine.space] += pushed[:, None] * normal
    assert np.count_nonzero(wanted.any(axis=1)) > POINTS / 10
    assert np.allclose(force, wanted, rtol=1e-12, atol=1e-9)


@pytest.mark.parametrize("name", EVERY_KIND)
def test_the_load_balances_the_hand_and_is_nearest_in_newtons(name: str) -> None:
    generated = geometry(name)
    machine, random = generated.machine, np.random.default_rng(92)
    pose, rails = poses(machine, random), rail_coordinates(machine, random)
    structure = np.asarray(generated.structure_matrix(pose, rails))
    tension = random.uniform(3, 30, (POINTS, len(machine.cables)))
    hand = random.uniform(-5, 5, (POINTS, machine.dof))
    load = generated.load_tension(structure, tension, hand)
    fine = load.status == Status.OK
    assert fine.mean() > 0.9
    for k in np.flatnonzero(fine)[:200]:
        matrix = structure[k]
        wanted = tension[k] + np.linalg.pinv(matrix) @ (-hand[k] - matrix @ tension[k])
        assert np.allclose(load[k], wanted, rtol=1e-7, atol=1e-7)


@pytest.mark.parametrize("name", EVERY_KIND)
def test_bases_at_their_targets_are_nearest_to_their_anchors(name: str) -> None:
    """Coordinates that move one base: no allowed step beside the target brings it nearer."""
    generated = geometry(name)
    machine, random = generated.machine, np.random.default_rng(93)
    pose = poses(machine, random)
    target = np.asarray(generated.base_targets(pose))
    anchors = placed(generated, pose)

    def distances(rails: Reals) -> Reals:
        points = np.asarray(generated.base_points(rails))
        return np.asarray(np.sum((points - anchors) ** 2, axis=2))

    inside = np.array([rail.length for rail in machine.rails])
    for k, rail in enumerate(machine.rails):
        if machine.space == 2 and len(machine.base_motions[rail.cables[0]].travel) == 2:
            continue
        free = unclamped(machine, target, k)
        for step in (-1e-3, 1e-3):
            moved = target.copy()
            moved[:, k] = np.clip(moved[:, k] + step, 0, inside[k])
            change = distances(moved)[:, rail.cables] - distances(target)[:, rail.cables]
            assert np.all(np.sum(change, axis=1)[free] >= -1e-15)


def unclamped(machine: Machine, target: Reals, number: int) -> NDArray[np.bool_]:
    """Where the other coordinate of a plane is at no end: there the nearest point is known."""
    motion = machine.base_motions[machine.rails[number].cables[0]]
    free = np.ones(len(target), dtype=bool)
    for k, _ in motion.travel:
        if k != number:
            free &= (target[:, k] > 0) & (target[:, k] < machine.rails[k].length)
    return free


def placed(generated: Any, pose: Reals) -> Reals:
    """Anchors in the fixed frame (k, n, space)."""
    machine = generated.machine
    if not machine.is_rigid:
        return np.repeat(pose[:, None, :], len(machine.cables), axis=1)
    vectors = pose[:, machine.space :]
    if machine.space == 2:
        vectors = np.pad(vectors, ((0, 0), (2, 0)))
    matrices = Rotation.from_rotvec(vectors).as_matrix()[:, : machine.space, : machine.space]
    arms = np.einsum("kij,nj->kni", matrices, machine.anchors)
    return np.asarray(pose[:, None, : machine.space] + arms)


def test_a_base_in_a_planar_plane_rests_on_its_first_side() -> None:
    generated = geometry("kinematics_planar_rigid")
    pose = poses(generated.machine, np.random.default_rng(94))
    second = generated.machine.base_motions[3].travel[1][0]
    assert not np.asarray(generated.base_targets(pose))[:, second].any()


HEADED = "kinematics_headings"


def test_a_base_with_a_heading_stands_where_its_cable_takes_it() -> None:
    """Seen along the heading, no step of the base brings it nearer to the platform."""
    generated = geometry(HEADED)
    machine, random = generated.machine, np.random.default_rng(95)
    pose = poses(machine, random)
    target = np.asarray(generated.base_targets(pose))
    points = np.asarray(generated.base_points(target))
    checked = 0
    for i, motion in enumerate(machine.base_motions):
        shared = any(len(machine.rails[k].cables) > 1 for k, _ in motion.travel)
        if not motion.heading or shared:
            continue
        ends = np.array([machine.rails[k].length for k, _ in motion.travel])
        here = target[:, [k for k, _ in motion.travel]]
        free = np.all((here > 0) & (here < ends), axis=1)
        ray = points[free, i] - pose[free, : machine.space]
        seen = ray - (ray @ motion.heading)[:, None] * np.asarray(motion.heading)
        for _, direction in motion.travel:
            assert np.max(np.abs(seen @ direction)) < 1e-14
        checked += int(free.sum())
    assert checked > POINTS / 4


@pytest.mark.parametrize("name", PLANAR)
def test_equation_10_solves_the_statics_but_gives_no_tensions(name: str) -> None:
    generated = geometry(name)
    machine, random = generated.machine, np.random.default_rng(96)
    pose, rails = poses(machine, random), rail_coordinates(machine, random)
    wrench = random.uniform(-5, 5, (POINTS, machine.dof))
    share = generated.wrench_share_eq10(pose, rails, wrench)
    fine = share.status == Status.OK
    structure = np.asarray(generated.structure_matrix(pose, rails))
    free = np.linalg.norm(np.asarray(generated.cable_vectors(pose, rails)), axis=2)
    for k in np.flatnonzero(fine)[:200]:
        weighted = structure[k] * free[k]
        wanted = free[k] * (np.linalg.pinv(weighted) @ wrench[k])
        assert np.allclose(share[k], wanted, rtol=1e-6, atol=1e-6)
    assert np.any(np.asarray(share)[fine] < 0)
    nothing = generated.wrench_share_eq10(pose, rails, 0 * wrench)
    assert not np.asarray(nothing).any()
