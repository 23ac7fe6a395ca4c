"""The reference pose quality and control laws of every kind, by brute force and by hand."""

from itertools import product

import numpy as np
import pytest
from reference_poses import NAMES, WIDE_EPS, Wide, machine_of, random_poses

from turnbuckle.model.machine import Machine, Wall
from turnbuckle.model.reference.arrays import norm
from turnbuckle.model.reference.control import base_targets, load_tension, wall_force
from turnbuckle.model.reference.kinematics import (
    anchor_points,
    base_points,
    cable_vectors,
    moment_lever,
    structure_matrix,
)
from turnbuckle.model.reference.minors import none_yet, normal, with_vector
from turnbuckle.model.reference.quality import (
    isotropic_force,
    isotropic_force_eq17,
    tension_factor,
    zero_wrench_tension,
)
from turnbuckle.model.reference.statics import rail_forces, wrench, wrench_share_eq10
from turnbuckle.model.reference.tension import wrench_feasible
from turnbuckle.model.reference.wrench_set import margin, slabs

MACHINES = [machine_of(name) for name in NAMES]
IN_SPACE = [machine for machine in MACHINES if machine.kind != "planar-point"]
every_machine = pytest.mark.parametrize("machine", MACHINES, ids=lambda m: m.name)
beyond_points_in_the_plane = pytest.mark.parametrize("machine", IN_SPACE, ids=lambda m: m.name)


@beyond_points_in_the_plane
def test_the_isotropic_force_is_met_in_every_direction_and_no_more(machine: Machine) -> None:
    """Tried along the forces of all facets' normals, of which one is the worst there is."""
    pose, rails = random_poses(machine, 200)
    force = isotropic_force(machine, pose, rails)
    reached = np.flatnonzero(force > 0)[:5]
    assert len(reached) == 5
    structure = structure_matrix(machine, pose, rails)[reached]
    normals, _, _ = slabs(machine, structure)
    around = np.zeros((5, 2 * normals.shape[1], machine.dof), np.longdouble)
    forces = np.concatenate([normals, -normals], axis=1)[..., : machine.space]
    size = np.sqrt(np.sum(forces**2, axis=-1, keepdims=True))
    around[..., : machine.space] = np.divide(
        forces, size, out=np.zeros_like(forces), where=size > 1e-9
    )
    for s, ring, most in zip(structure, around, force[reached], strict=True):
        assert np.all(wrench_feasible(machine, s, (most * (1 - 1e-12)) * ring))
        assert not np.all(wrench_feasible(machine, s, (most * (1 + 1e-9)) * ring))


@beyond_points_in_the_plane
def test_the_set_of_wrenches_touches_the_plane_of_each_facet_at_its_best_corner(
    machine: Machine,
) -> None:
    pose, rails = random_poses(machine, 5)
    structure = structure_matrix(machine, pose, rails)
    normals, middle, half_width = slabs(machine, structure)
    bounds = machine.tension
    for sign in (1, -1):
        sides = sign * np.sum(normals[..., None] * structure[:, None], axis=-2)
        tension = np.where(sides > 0, bounds.max, bounds.min)
        furthest = np.sum(sides * tension, axis=-1)
        assert np.allclose(furthest, half_width + sign * middle, rtol=0, atol=1e4 * WIDE_EPS)


def test_a_set_that_has_shrunk_still_tells_its_wrenches_from_others() -> None:
    """All cables in one plane, along one line, or opposite one another in threes."""
    machine = machine_of("spatial_point_straight")
    rng = np.random.default_rng(1)
    flat = rng.normal(size=(3, 5))
    flat[2] = 0
    line = rng.normal(size=(3, 1)) * np.array([1.0, 2, -1, 1, -3])
    for structure in (flat, line):
        tension = rng.uniform(machine.tension.min, machine.tension.max, (200, 5))
        inside = tension @ structure.T
        assert np.all(wrench_feasible(machine, structure, inside))
        across = np.linalg.svd(structure)[0][:, 2]
        assert not np.any(wrench_feasible(machine, structure, inside + 1e-9 * across))
        along = np.linalg.svd(structure)[0][:, 0]
        assert not np.any(wrench_feasible(machine, structure, inside + 2e3 * along))


@pytest.mark.parametrize("d", [2, 3, 4, 6])
def test_the_normal_of_all_but_one_vector_completes_a_determinant(d: int) -> None:
    rng = np.random.default_rng(d)
    vectors, other = rng.normal(size=(50, d - 1, d)), rng.normal(size=(50, 1, d))
    expected = np.linalg.det(np.concatenate([other, vectors], axis=-2))
    minors = none_yet(vectors[:, 0, 0])
    for vector in np.moveaxis(vectors, 1, 0):
        minors = with_vector(minors, vector.T)
    found = np.sum(normal(minors) * other[:, 0].T, axis=0)
    assert np.allclose(found, expected, rtol=0, atol=1e-12)


@every_machine
def test_zero_wrench_tensions_balance_within_bounds(machine: Machine) -> None:
    pose, rails = random_poses(machine, 100)
    structure = structure_matrix(machine, pose, rails)
    tension = zero_wrench_tension(machine, pose, rails)
    inside = wrench_feasible(machine, structure, np.zeros_like(pose))
    assert np.array_equal(np.isfinite(tension[:, 0]), inside) and np.any(inside)
    left = wrench(machine, structure, tension)[inside]
    assert np.max(np.abs(left)) < 1e5 * WIDE_EPS
    factor = tension_factor(machine, pose, rails)[inside]
    assert np.all((factor >= machine.tension.min / machine.tension.max) & (factor <= 1))
    assert np.all(isotropic_force(machine, pose, rails)[~inside] == 0)


@every_machine
def test_the_margin_is_how_far_the_wrench_can_grow_towards_the_nearest_facet(
    machine: Machine,
) -> None:
    pose, rails = random_poses(machine, 5)
    structure = structure_matrix(machine, pose, rails)
    middle = (machine.tension.min + machine.tension.max) / 2 * np.sum(structure, axis=-1)
    room = margin(machine, structure, middle)[:, None, None]
    assert np.all(room > 0)
    normals, _, _ = slabs(machine, structure)
    out = normals * moment_lever(machine, normals.dtype) ** 2  # unit vectors of [F; M / lever]
    within = middle[:, None] + room * (1 - 1e-9) * out
    beyond = middle[:, None] + room * (1 + 1e-9) * out
    assert np.all(wrench_feasible(machine, structure[:, None], within))
    assert not np.any(np.all(wrench_feasible(machine, structure[:, None], beyond), axis=-1))


@beyond_points_in_the_plane
def test_equation_17_is_refused_but_for_points_in_the_plane(machine: Machine) -> None:
    with pytest.raises(ValueError, match=r"eq\. 17 is for planar-point; .* is " + machine.kind):
        isotropic_force_eq17(machine, *random_poses(machine, 1))


@pytest.mark.parametrize("name", ["mixed_bases", "planar_rigid_pulleys"])
def test_equation_10_is_minus_the_transposed_jacobian_times_the_wrench(name: str) -> None:
    """Yoon's J = B^+ A with the rows of eq. 5, for the cables' part of the joint rates."""
    machine = machine_of(name)
    pose, rails = random_poses(machine, 20)
    load = np.random.default_rng(2).normal(size=pose.shape)
    lengths = norm(cable_vectors(machine, pose, rails)).astype(float)
    structure = structure_matrix(machine, pose, rails).astype(float)
    found = wrench_share_eq10(machine, pose, rails, load)
    for length, s, w, share in zip(lengths, structure, load, found, strict=True):
        b_rows = -length[:, None] * s.T
        jacobian = np.linalg.pinv(b_rows) @ np.diag(length)
        assert np.allclose(share.astype(float), -jacobian.T @ w, rtol=0, atol=1e-10)
        assert np.allclose(s @ share.astype(float), w, rtol=0, atol=1e-10)
    assert np.min(found) < 0
    assert np.all(wrench_share_eq10(machine, pose, rails, 0 * load) == 0)


def test_equation_10_is_refused_in_space() -> None:
    machine = machine_of("spatial_rigid_eight")
    with pytest.raises(ValueError, match=r"eq\. 10 is for planar machines"):
        wrench_share_eq10(machine, np.zeros(6), np.zeros(0), np.zeros(6))


def test_the_force_on_a_coupled_rail_is_the_sum_over_its_cables() -> None:
    machine = machine_of("planar_rigid_pulleys")
    pose, rails = random_poses(machine, 10)
    all_cables = np.full(6, 5.0)
    leader, follower = all_cables * (np.arange(6) == 1), all_cables * (np.arange(6) == 2)
    parts = [rail_forces(machine, pose, rails, part)[:, 0] for part in (leader, follower)]
    assert np.all(np.abs(parts) > 0)
    whole = rail_forces(machine, pose, rails, all_cables)[:, 0]
    assert np.allclose(whole, parts[0] + parts[1], rtol=0, atol=1e-17)


@every_machine
def test_the_load_balances_the_hand_with_the_least_change_of_tension(machine: Machine) -> None:
    pose, rails = random_poses(machine, 50)
    structure = structure_matrix(machine, pose, rails)
    rng = np.random.default_rng(3)
    tension = rng.uniform(3, 30, (50, len(machine.cables)))
    hand = rng.normal(size=pose.shape)
    load = load_tension(machine, structure, tension, hand)
    assert np.max(np.abs(wrench(machine, structure, load) + hand)) < 1e5 * WIDE_EPS
    for s, t, h, found in zip(structure.astype(float), tension, hand, load, strict=True):
        least, *_ = np.linalg.lstsq(s, -h - s @ t, rcond=None)
        assert np.allclose(found.astype(float), t + least, rtol=0, atol=1e-8)


def test_base_targets_bring_bases_that_are_not_at_an_end_nearest_to_their_anchors() -> None:
    machine = machine_of("spatial_point_planes")
    pose, _ = random_poses(machine, 200)
    targets = base_targets(machine, pose)
    lengths = [rail.length for rail in machine.rails]
    inside = np.array(lengths) * (1 - 1e-12) > targets
    inside &= targets > 0
    nearest = distances(machine, pose, targets)
    for i, motion in enumerate(machine.base_motions[:3]):
        free = np.all(inside[:, [k for k, _ in motion.travel]], axis=-1)
        assert np.sum(free) > 10
        for shares in product((0.0, 0.25, 0.5, 0.75, 1.0), repeat=2):
            other = distances(machine, pose, np.resize(shares, len(lengths)) * lengths)
            assert np.all(nearest[free, i] <= other[free, i])


def distances(machine: Machine, pose: Wide, rails: Wide) -> Wide:
    """From every anchor to its base (..., n) [m]."""
    span = anchor_points(machine, pose) - base_points(machine, rails)
    return np.asarray(np.sqrt(np.sum(span**2, axis=-1)))


def test_a_coupled_rail_goes_to_the_mean_and_a_plane_in_the_plane_rests_on_its_side() -> None:
    machine = machine_of("planar_rigid_pulleys")
    pose, _ = random_poses(machine, 10)
    targets = base_targets(machine, pose)
    anchors = anchor_points(machine, pose)
    follower = np.array([-280, -20]) / np.hypot(280, 20)
    asked = anchors[:, 1, 0] - 0.5, (anchors[:, 2] - [0.78, 0.58]) @ follower
    wanted = np.clip((asked[0] + asked[1]) / 2, 0, 0.28)
    assert np.allclose(targets[:, 0].astype(float), wanted.astype(float), rtol=0, atol=1e-15)
    along = np.clip(anchors[:, 3, 0] - 0.06, 0, 0.24)
    assert np.allclose(targets[:, 1].astype(float), along.astype(float), rtol=0, atol=1e-15)
    assert np.all(targets[:, 2] == 0)


@pytest.mark.parametrize("name", ["spatial_rigid_eight", "spatial_point_straight"])
def test_a_wall_in_space_pushes_at_the_centre_without_a_moment(name: str) -> None:
    point, normal = ["0 mm", "0 mm", "260 mm"], [0, 0, -1]
    wall = Wall.model_validate(
        {"name": "top", "point": point, "normal": normal, "stiffness": "1000 N/m"}
        | {"damping": "5 N*s/m"}
    )
    machine = machine_of(name).model_copy(update={"walls": (wall,)})
    pose, velocity = np.zeros(machine.dof), np.zeros(machine.dof)
    pose[:3], velocity[2] = [0.2, 0.2, 0.262], 0.1
    pushed = np.zeros(machine.dof)
    pushed[2] = -1000 * 0.002 - 5 * 0.1
    assert np.allclose(wall_force(machine, pose, velocity), pushed, rtol=1e-12, atol=0)
