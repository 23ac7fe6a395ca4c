"""Laws of mechanics and geometry that the reference obeys for any machine, pose and wrench."""

from typing import Any

import numpy as np
import numpy.typing as npt
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from turnbuckle.model.machine import Cable, Machine
from turnbuckle.model.reading import load_machine
from turnbuckle.model.reference.kinematics import (
    cable_lengths,
    forward_kinematics,
    length_jacobian,
    structure_matrix,
)
from turnbuckle.model.reference.optimality import optimality_gap
from turnbuckle.model.reference.planar import minors, norm
from turnbuckle.model.reference.quality import isotropic_force, isotropic_force_eq17, tension_factor
from turnbuckle.model.reference.statics import wrench
from turnbuckle.model.reference.tension import distribute_tension, wrench_feasible

Doubles = npt.NDArray[np.floating[Any]]
STOCK = load_machine("machines/yoon2023.toml")
LOWER, UPPER = STOCK.tension.min, STOCK.tension.max
NO_RAILS = np.zeros(0)
MIRROR = np.array([-1.0, 1.0])
NEWTON = 1e-10  # of 10 N: six digits are left to poses where cables are nearly parallel

unhurried = settings(deadline=None, max_examples=60)
millimetres = st.integers(-400, 400)
points = st.tuples(millimetres, millimetres)
newtons = st.integers(-3000, 3000).map(lambda hundredths: hundredths / 100)
wrenches = st.tuples(newtons, newtons).map(np.array)


@st.composite
def machines(draw: st.DrawFn) -> Machine:
    """Three to five cables, whose fixed bases do not all lie in one line nor near the origin."""
    bases = draw(st.lists(points, min_size=3, max_size=5, unique=True))
    places = np.array(bases) / 1000
    assume(np.min(np.linalg.norm(places, axis=-1)) > 0.02)
    assume(np.max(np.abs(minors(places - places[0]))) > 1e-3)
    return with_bases(places)


def with_bases(places: Doubles) -> Machine:
    texts = [[f"{x!r} m", f"{y!r} m"] for x, y in places.tolist()]
    cables = tuple(Cable.model_validate({"base": text}) for text in texts)
    return STOCK.model_copy(update={"cables": cables})


def bases(machine: Machine) -> Doubles:
    return np.array([cable.fixed for cable in machine.cables])


def structure_at_origin(machine: Machine) -> Doubles:
    structure = structure_matrix(machine, np.zeros(2), NO_RAILS)
    sines = np.abs(minors(structure.T))
    assume(np.max(sines) > 0.02 and np.all((sines > 1e-3) | (sines < 1e-12)))
    return structure


def with_tension(machine: Machine, lower: float, upper: float) -> Machine:
    bounds = machine.tension.model_copy(update={"min": lower, "max": upper})
    return machine.model_copy(update={"tension": bounds})


@unhurried
@given(machines(), points)
def test_the_pose_comes_back_from_its_lengths(machine: Machine, point: tuple[int, int]) -> None:
    pose = np.array(point) / 1000
    found = forward_kinematics(machine, cable_lengths(machine, pose, NO_RAILS), NO_RAILS)
    assert np.allclose(found.pose, pose, rtol=0, atol=1e-10)
    assert found.residual < 1e-12


@unhurried
@given(machines(), wrenches, st.tuples(newtons, newtons))
def test_the_cables_do_the_work_they_lose(
    machine: Machine, wanted: Doubles, velocity: tuple[float, float]
) -> None:
    structure = structure_at_origin(machine)
    tension = distribute_tension(machine, structure, wanted).tension
    rates = length_jacobian(machine, np.zeros(2), NO_RAILS) @ velocity
    power = wrench(machine, structure, tension) @ velocity
    assert np.isclose(power, -tension @ rates, rtol=0, atol=NEWTON)


@unhurried
@given(machines(), wrenches, st.sampled_from(["scale", "closest"]))
def test_tensions_are_bounded_optimal_and_true_to_what_they_deliver(
    machine: Machine, wanted: Doubles, policy: str
) -> None:
    structure = structure_at_origin(machine)
    found = distribute_tension(machine, structure, wanted, policy)
    assert np.all((found.tension >= LOWER) & (found.tension <= UPPER))
    assert optimality_gap(structure, found.tension, LOWER, UPPER) < NEWTON
    assert wrench_feasible(machine, structure, found.delivered)
    again = distribute_tension(machine, structure, found.delivered, policy)
    assert np.allclose(again.tension, found.tension, rtol=0, atol=NEWTON)
    if found.feasible:
        assert np.allclose(found.delivered, wanted, rtol=0, atol=NEWTON)


@unhurried
@given(machines(), wrenches)
def test_no_policy_comes_closer_than_closest(machine: Machine, wanted: Doubles) -> None:
    structure = structure_at_origin(machine)
    closest, scale, paper = (
        float(norm(distribute_tension(machine, structure, wanted, policy).delivered - wanted))
        for policy in ("closest", "scale", "paper")
    )
    assert closest <= min(scale, paper) + NEWTON


@unhurried
@given(machines(), wrenches)
def test_scaling_keeps_the_direction_where_the_zero_wrench_is_feasible(
    machine: Machine, wanted: Doubles
) -> None:
    structure = structure_at_origin(machine)
    assume(wrench_feasible(machine, structure, np.zeros(2)))
    delivered = distribute_tension(machine, structure, wanted, "scale").delivered
    turned = wanted[0] * delivered[1] - wanted[1] * delivered[0]
    assert abs(turned) < NEWTON * max(1, float(norm(wanted)))
    assert wanted @ delivered >= -NEWTON
    assert norm(delivered) <= norm(wanted) + NEWTON


@unhurried
@given(machines(), wrenches, st.floats(0.1, 10), st.sampled_from(["scale", "closest", "paper"]))
def test_forces_and_bounds_scale_together(
    machine: Machine, wanted: Doubles, factor: float, policy: str
) -> None:
    structure = structure_at_origin(machine)
    small = distribute_tension(machine, structure, wanted, policy)
    stronger = with_tension(machine, factor * LOWER, factor * UPPER)
    large = distribute_tension(stronger, structure, factor * wanted, policy)
    assert np.allclose(large.tension, factor * small.tension, rtol=0, atol=factor * NEWTON)


@unhurried
@given(machines(), wrenches)
def test_a_mirrored_machine_has_the_same_tensions_and_quality(
    machine: Machine, wanted: Doubles
) -> None:
    structure = structure_at_origin(machine)
    mirrored = with_bases(MIRROR * bases(machine))
    there = distribute_tension(mirrored, MIRROR[:, None] * structure, MIRROR * wanted)
    here = distribute_tension(machine, structure, wanted)
    assert np.allclose(there.tension, here.tension, rtol=0, atol=NEWTON)
    for quality in (isotropic_force, isotropic_force_eq17, tension_factor):
        one, other = (quality(m, np.zeros(2), NO_RAILS) for m in (machine, mirrored))
        assert np.allclose(one, other, rtol=0, atol=NEWTON, equal_nan=True)


@unhurried
@given(machines(), st.integers(2, 10))
def test_quality_does_not_depend_on_the_size_of_the_machine(machine: Machine, factor: int) -> None:
    structure_at_origin(machine)
    larger = with_bases(factor * bases(machine))
    for quality in (isotropic_force, isotropic_force_eq17, tension_factor):
        one, other = (quality(m, np.zeros(2), NO_RAILS) for m in (machine, larger))
        assert np.allclose(one, other, rtol=0, atol=NEWTON, equal_nan=True)


@unhurried
@given(machines())
def test_the_isotropic_force_is_at_least_that_of_equation_17(machine: Machine) -> None:
    structure_at_origin(machine)
    # Outside the workspace eq. 17 is not defined, and the true force is 0.
    paper = np.nan_to_num(isotropic_force_eq17(machine, np.zeros(2), NO_RAILS))
    assert paper <= isotropic_force(machine, np.zeros(2), NO_RAILS) + NEWTON


@unhurried
@given(machines(), wrenches, st.floats(0, 1))
def test_a_smaller_wrench_of_a_feasible_pair_is_feasible(
    machine: Machine, wanted: Doubles, share: float
) -> None:
    structure = structure_at_origin(machine)
    reached = distribute_tension(machine, structure, wanted, "closest").delivered
    other = distribute_tension(machine, structure, -wanted, "closest").delivered
    assert wrench_feasible(machine, structure, share * reached + (1 - share) * other)
