"""Brau's methods as corrected, against the exact ones, the audit's numbers and a linear program."""

import numpy as np
import numpy.typing as npt
import pytest
from reference_poses import WIDE_EPS, Wide, machine_of, random_poses
from scipy.optimize import linprog

from turnbuckle.model.machine import Cable, Machine
from turnbuckle.model.reference.brau import (
    force_ratio_eq21,
    force_ratio_eq23,
    kernel_tension,
    largest_tension,
    largest_tensions_eq12,
    largest_tensions_eq17,
    largest_tensions_eq18,
    reduced_matrix_tension,
)
from turnbuckle.model.reference.kinematics import structure_matrix
from turnbuckle.model.reference.tension import minimum_norm_tension

Doubles = npt.NDArray[np.float64]
NO_RAILS = np.zeros(0)
PLANAR, SPATIAL = machine_of("fixed_diagonal"), machine_of("spatial_point_straight")
EIGHT = machine_of("spatial_rigid_eight")


def with_bases(machine: Machine, points: npt.ArrayLike, least: float = 0.0) -> Machine:
    """The machine with straight cables to fixed bases (n, space) [m] and another T_min [N]."""
    places = [[f"{x!r} m" for x in point] for point in np.asarray(points, float).tolist()]
    cables = tuple(Cable.model_validate({"base": place}) for place in places)
    tension = machine.tension.model_copy(update={"min": least})
    return machine.model_copy(update={"cables": cables, "tension": tension})


def ring(cables: int, least: float = 0.0) -> Machine:
    angle = 2 * np.pi * np.arange(cables) / cables + 0.1
    return with_bases(PLANAR, np.stack([np.cos(angle), np.sin(angle)], axis=-1), least)


SQUARE = with_bases(PLANAR, [(-1, -1), (1, -1), (1, 1), (-1, 1)])
CORNERS = [(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)]
TETRAHEDRON = with_bases(SPATIAL, CORNERS)


def structure_of(machine: Machine, pose: npt.ArrayLike) -> Wide:
    return structure_matrix(machine, np.asarray(pose, np.longdouble), NO_RAILS)


def lowest_sum(s: Doubles, w: Doubles, least: float) -> Doubles | None:
    found = linprog(np.ones(s.shape[1]), A_eq=s, b_eq=w, bounds=(least, None), method="highs")
    return None if found.x is None else np.asarray(found.x)


def around(space: int, count: int) -> Wide:
    """Random unit vectors."""
    vectors = np.random.default_rng(space).normal(size=(count, space)).astype(np.longdouble)
    return np.asarray(vectors / np.sqrt(np.sum(vectors**2, axis=-1, keepdims=True)))


@pytest.mark.parametrize("machine", [ring(4, 1.0), ring(5, 1.0), EIGHT], ids=["4", "5", "rigid"])
def test_the_reduced_matrices_give_the_lowest_sum_of_tensions(machine: Machine) -> None:
    poses, rails = random_poses(machine, 60) if machine is EIGHT else (0.4 * around(2, 60), 0)
    structure = structure_matrix(machine, poses, NO_RAILS if machine is EIGHT else rails)
    rng = np.random.default_rng(0)
    lever = np.where(np.arange(machine.dof) < machine.space, 1, machine.lever)
    wrench = 5 * lever * rng.normal(size=poses.shape)
    found = reduced_matrix_tension(machine, structure, wrench)
    served = 0
    for s, w, tension in zip(structure.astype(float), wrench, found, strict=True):
        best = lowest_sum(s, w, machine.tension.min)
        assert (best is None) == bool(np.isnan(tension[0]))
        if best is not None:
            served += 1
            assert np.sum(tension) == pytest.approx(np.sum(best), rel=1e-9)
            assert np.allclose(s @ tension.astype(float), w, rtol=0, atol=1e-9)
            assert np.min(tension) >= machine.tension.min
            assert np.sum(tension > machine.tension.min * (1 + 1e-12)) <= machine.dof
    assert served > 20


def test_sets_with_tensions_below_the_least_are_passed_over_although_their_sum_is_lower() -> None:
    """Positive alone is not enough with T_min = 1 N: the paper's rule would take 0.84 and 0.82."""
    machine = with_bases(PLANAR, [(0, 0), (1, 0), (1, 1), (0, 1)], 1.0)
    structure = structure_of(machine, [0.5, 0.5])
    found = reduced_matrix_tension(machine, structure, [0.1, 0.05])
    assert np.all(found >= 1) and np.sum(found > 1) <= 2


@pytest.mark.parametrize("sign", [1, -1])
def test_the_kernel_method_brings_the_least_tension_to_its_minimum(sign: int) -> None:
    machine = ring(3, 3.0)
    structure = structure_of(machine, 0.2 * around(2, 200))[..., ::sign]
    wrench = np.random.default_rng(1).normal(0, 5, (200, 2))
    found = kernel_tension(machine, structure, wrench)
    assert np.allclose(np.min(found, axis=-1), 3, rtol=0, atol=1e-15)
    met = np.sum(structure * found[..., None, :], axis=-1) - wrench
    assert np.max(np.abs(met)) < 1e3 * WIDE_EPS


def test_the_kernel_method_has_no_tension_outside_the_theoretical_workspace() -> None:
    machine = ring(3, 3.0)
    structure = structure_of(machine, [2.0, 0.0])
    assert np.all(np.isnan(kernel_tension(machine, structure, [0.0, 0.0])))
    assert np.isinf(np.max(largest_tensions_eq17(machine, structure, 1.0)))
    assert force_ratio_eq21(machine, structure) == 0


def test_with_more_cables_the_kernel_method_is_the_least_norm_above_the_minimum() -> None:
    poses, _ = random_poses(EIGHT, 50)
    structure = structure_matrix(EIGHT, poses, NO_RAILS)
    wrench = np.random.default_rng(2).normal(size=(50, 6)) * [3, 3, 3, 0.1, 0.1, 0.1]
    found = kernel_tension(EIGHT, structure, wrench)
    exact = minimum_norm_tension(structure, wrench, EIGHT.tension.min, np.inf)
    assert np.array_equal(np.isfinite(found[:, 0]), exact.solved) and np.sum(exact.solved) > 10
    assert np.allclose(found[exact.solved], exact.tension[exact.solved], rtol=0, atol=1e-12)


def test_the_second_maximum_of_the_paper_is_not_the_largest_tension() -> None:
    """The audit's pose in the square: 1.389 by the paper's rule, 2.5769 exactly."""
    structure = structure_of(SQUARE, [0.8, 0.1])
    pairs = [(i, j) for i in range(4) for j in range(i)]
    sines = np.array([np.linalg.det(structure[:, pair].astype(float)) for pair in pairs])
    assert np.sort(1 / np.abs(sines))[-2] == pytest.approx(1.389, abs=5e-4)
    assert float(largest_tension(SQUARE, structure, 1.0)) == pytest.approx(2.5769, abs=5e-5)
    corrected = largest_tensions_eq17(SQUARE, structure, 1.0)
    assert float(np.max(corrected)) == pytest.approx(2.5769, abs=5e-5)


def test_the_square_is_tension_capable_at_half_the_force_on_the_audited_share() -> None:
    side = 2 * np.arange(1, 51) / 51 - 1
    poses = np.stack(np.meshgrid(side, side), axis=-1).reshape(-1, 2)
    structure = structure_of(SQUARE, poses)
    capable = largest_tension(SQUARE, structure, 0.5) <= 1
    assert np.mean(capable) == pytest.approx(0.664, abs=0.0005)
    assert np.array_equal(capable, force_ratio_eq21(SQUARE, structure) >= 0.5)


def test_the_best_ratio_in_an_equilateral_triangle_is_half_the_root_of_three() -> None:
    machine = ring(3)
    ratio = force_ratio_eq21(machine, structure_of(machine, [0.0, 0.0]))
    assert abs(float(ratio) - np.sqrt(3) / 2) < 1e-15


@pytest.mark.parametrize(("cables", "exact"), [(3, True), (4, True), (5, False), (8, False)])
def test_adjacent_cables_tell_the_exact_tension_of_three_and_four_only(
    cables: int, exact: bool
) -> None:
    rng = np.random.default_rng(cables)
    machine = ring(cables)
    angle = rng.uniform(0, 2 * np.pi, (2000, cables)).astype(np.longdouble)
    structure = np.stack([np.cos(angle), np.sin(angle)], axis=-2)
    true, published = largest_tension(machine, structure, 1.0), force_ratio_eq21(machine, structure)
    usable = np.isfinite(true)
    assert np.array_equal(usable, published > 0)
    ratio = published[usable] * true[usable]
    assert np.all(ratio < 1 + 1e-9)
    assert np.all(ratio > 1 - 1e-9) == exact


def test_equation_17_is_what_the_reduced_matrices_need_in_the_worst_direction() -> None:
    machine = ring(5)
    structure = structure_of(machine, [0.3, 0.2])
    angle = np.linspace(0, 2 * np.pi, 36001)
    forces = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    needed = np.max(reduced_matrix_tension(machine, structure, forces), axis=0)
    published = largest_tensions_eq17(machine, structure, 1.0)
    assert np.all(needed <= published * (1 + 1e-12))
    assert np.all(needed > published * (1 - np.diff(angle)[0]))


def test_a_regular_tetrahedron_has_four_fifths_at_its_centre() -> None:
    structure = structure_of(TETRAHEDRON, [0, 0, 0])
    assert float(force_ratio_eq23(TETRAHEDRON, structure)) == pytest.approx(np.sqrt(2 / 3))
    exact = largest_tension(TETRAHEDRON, structure, 1.0)
    assert abs(float(exact * np.sqrt(np.longdouble(2) / 3) - 1)) < 1e-15


def test_equations_18_and_23_are_exact_in_a_tetrahedron_and_equation_12_is_the_same() -> None:
    rng = np.random.default_rng(3)
    shares = rng.dirichlet(np.ones(4), 500)
    poses = shares @ np.array(CORNERS, float)
    structure = structure_of(TETRAHEDRON, poses)
    exact = largest_tension(TETRAHEDRON, structure, 1.0)
    each = largest_tensions_eq18(TETRAHEDRON, structure, 1.0)
    assert np.allclose(np.max(each, axis=-1), exact, rtol=1e-12, atol=0)
    assert np.allclose(each, largest_tensions_eq12(TETRAHEDRON, structure, 1.0), rtol=1e-12)
    assert np.allclose(force_ratio_eq23(TETRAHEDRON, structure) * exact, 1, rtol=1e-12, atol=0)


def test_outside_the_tetrahedron_no_tension_is_enough() -> None:
    structure = structure_of(TETRAHEDRON, [2.0, 2.0, 2.1])
    assert np.all(np.isinf(largest_tensions_eq18(TETRAHEDRON, structure, 1.0)))
    assert np.isinf(largest_tension(TETRAHEDRON, structure, 1.0))
    assert force_ratio_eq23(TETRAHEDRON, structure) == 0


def test_equation_12_bounds_the_reduced_matrices_of_a_rigid_platform() -> None:
    machine = EIGHT.model_copy(update={"tension": EIGHT.tension.model_copy(update={"min": 0.0})})
    poses, _ = random_poses(machine, 3)
    structure = structure_matrix(machine, poses, NO_RAILS)
    bound = largest_tensions_eq12(machine, structure, 1.0)
    forces = np.concatenate([around(3, 100), np.zeros((100, 3))], axis=-1)
    found = reduced_matrix_tension(machine, structure[:, None], forces)
    usable = np.isfinite(found[..., 0])
    assert np.sum(usable) > 50
    assert np.all((found <= bound[:, None] * (1 + 1e-12))[usable])


def test_the_largest_tension_is_just_enough_with_a_least_tension_too() -> None:
    """With it as T_max the force is feasible in all directions, with a hair less it is not."""
    machine = with_bases(SPATIAL, CORNERS, 2.0)
    structure = structure_of(machine, [0.2, -0.1, 0.15])
    needed = float(largest_tension(machine, structure, 5.0))
    forces = 5 * around(3, 3000)
    assert np.all(minimum_norm_tension(structure, forces, 2.0, needed * (1 + 1e-9)).solved)
    assert not np.all(minimum_norm_tension(structure, forces, 2.0, needed * 0.99).solved)


def test_equations_of_one_kind_refuse_the_others() -> None:
    structure = structure_of(TETRAHEDRON, [0, 0, 0])
    with pytest.raises(ValueError, match="eqs 14, 17, 21 are for planar-point"):
        largest_tensions_eq17(TETRAHEDRON, structure, 1.0)
    with pytest.raises(ValueError, match=r"spatial-point with 4 cables; .* with 5"):
        largest_tensions_eq18(SPATIAL, structure, 1.0)
