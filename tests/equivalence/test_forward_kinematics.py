"""Poses from lengths of every kind of machine: found, to rounding, or not answered."""

import math
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from unmeasured import EVERY_KIND, geometry, machine_named

from turnbuckle.codegen.bind import REALS, Generated
from turnbuckle.codegen.judges import motion
from turnbuckle.codegen.judges.problem import Problem
from turnbuckle.model.machine import Machine
from turnbuckle.model.reference.arrays import norm
from turnbuckle.model.reference.kinematics import cable_lengths
from turnbuckle.model.reference.linear import least_squares
from turnbuckle.model.symbolic.forward_kinematics import needs_guess
from turnbuckle.model.symbolic.function import Status

Reals = NDArray[np.floating[Any]]
POINTS = 10000
#: So many where the reference is asked as well.
FEW = 500
#: A guess may be off by this share of the diagonal along every axis, and by this angle [rad].
OFF, TURNED = 0.05, 0.2
EPSILON = {"double": 2.0**-52, "float": 2.0**-23}
#: Roundings of a length, over the smallest singular value of the directions.
ROUNDINGS = 64.0

#: Pose, guess, rails, and what the C answers: a step that a turn more leads into a pulley,
#: and small steps to and fro beside a wrap's end, one of which crosses it, to the pose.
ACROSS_A_WRAP = [
    (
        [0.418947908, 0.6, 0.100002103],
        [0.423112421, 0.6, 0.022032514],
        [0.014357623, 0.300665928, 0.0],
        Status.SINGULAR,
    ),
    (
        [0.8, 0.478542936, 1.047197551],
        [0.821777084, 0.470713113, 1.118513023],
        [0.140978552, 0.027715267, 0.0],
        Status.OK,
    ),
]

SEARCHED = [name for name in EVERY_KIND if needs_guess(machine_named(name))]


def diagonal(machine: Machine) -> float:
    return math.hypot(*machine.frame.size)


def in_the_target(machine: Machine, random: np.random.Generator) -> Reals:
    """Poses of the target, turned as far as it asks for."""
    spread = np.asarray(machine.target.size) * random.uniform(-0.5, 0.5, (POINTS, machine.space))
    angles = random.uniform(-1, 1, (POINTS, machine.dof - machine.space))
    angles *= machine.target.rotation / math.sqrt(max(1, angles.shape[1]))
    return np.hstack([machine.target.centre + spread, angles])


def rail_coordinates(machine: Machine, random: np.random.Generator) -> Reals:
    return random.random((POINTS, len(machine.rails))) * [rail.length for rail in machine.rails]


def near(machine: Machine, pose: Reals, random: np.random.Generator) -> Reals:
    """Guesses of poses."""
    off = np.full(machine.dof, OFF * diagonal(machine))
    off[machine.space :] = TURNED
    return pose + off * random.uniform(-1, 1, pose.shape)


def at_the_start(machine: Machine) -> Reals:
    """The target's centre, upright."""
    upright = [0.0] * (machine.dof - machine.space)
    return np.tile([*machine.target.centre, *upright], (POINTS, 1))


def located(generated: Generated, guess: Reals, lengths: Reals, rails: Reals) -> Any:
    """forward_kinematics with the guess that it may want."""
    known = {"lengths": lengths, "rails": rails}
    if needs_guess(generated.machine):
        known["guess"] = guess
    return generated.forward_kinematics(**known)


def least_singular_value(generated: Generated, pose: Reals, rails: Reals) -> Reals:
    """Of the structure matrix, moments over the lever (k)."""
    machine = generated.machine
    structure = np.array(generated.structure_matrix(pose, rails), dtype=float)
    structure[:, machine.space :] /= machine.lever
    return np.asarray(np.linalg.svd(structure, compute_uv=False)[:, -1])


def misses(generated: Generated, from_near: bool) -> tuple[Any, NDArray[np.bool_]]:
    """Answers for poses of the target, and where they are off by more than rounding."""
    machine, random = generated.machine, np.random.default_rng(81)
    real, epsilon = REALS[generated.precision], EPSILON[generated.precision]
    pose = in_the_target(machine, random).astype(real)
    rails = rail_coordinates(machine, random).astype(real)
    guess = near(machine, pose, random) if from_near else at_the_start(machine)
    found = located(generated, guess, np.asarray(generated.cable_lengths(pose, rails)), rails)
    rounding = ROUNDINGS * epsilon * diagonal(machine) / min(1.0, machine.lever)
    slack = rounding / least_singular_value(generated, pose, rails)
    return found, np.max(np.abs(found.pose - pose), axis=1) > slack


@pytest.mark.parametrize("precision", REALS)
@pytest.mark.parametrize("name", EVERY_KIND)
def test_every_pose_of_the_target_is_found_from_a_near_guess(name: str, precision: str) -> None:
    generated = geometry(name, precision)
    found, missed = misses(generated, from_near=True)
    assert np.all(found.status == Status.OK) and not missed.any()
    exact = ROUNDINGS * EPSILON[precision] * diagonal(generated.machine)
    assert np.all(found.residual <= exact)


@pytest.mark.parametrize("precision", REALS)
@pytest.mark.parametrize("name", EVERY_KIND)
def test_from_the_target_centre_a_wrong_pose_is_rare_and_its_residual_tells(
    name: str, precision: str
) -> None:
    found, missed = misses(geometry(name, precision), from_near=False)
    assert np.all(found.status == Status.OK) and missed.mean() <= 1e-3
    assert np.all(found.residual[missed] > 1e-3)


@pytest.mark.parametrize("name", SEARCHED)
def test_lengths_that_disagree_give_the_pose_of_least_squares(name: str) -> None:
    generated = geometry(name)
    machine, random = generated.machine, np.random.default_rng(82)
    pose, rails = in_the_target(machine, random), rail_coordinates(machine, random)
    exact = np.asarray(generated.cable_lengths(pose, rails))
    lengths = exact + 1e-4 * random.standard_normal(exact.shape)
    found = located(generated, at_the_start(machine), lengths, rails)
    fine = found.status == Status.OK
    assert fine.mean() > 0.999
    misfit = lengths - np.asarray(generated.cable_lengths(found.pose, rails))
    assert np.allclose(found.residual, np.linalg.norm(misfit, axis=1), rtol=1e-9)
    structure = np.asarray(generated.structure_matrix(found.pose, rails))
    slope = np.einsum("kdn,kn->kd", structure, misfit)
    assert np.max(np.abs(slope[fine])) < 1e-6 * 1e-4


def disagreeing(name: str) -> tuple[Problem, Any]:
    """Poses of the target whose lengths are 3 mm off, and what the C finds for them."""
    generated = geometry(name)
    machine, random = generated.machine, np.random.default_rng(86)
    pose, rails = in_the_target(machine, random)[:FEW], rail_coordinates(machine, random)[:FEW]
    exact = np.asarray(generated.cable_lengths(pose, rails))
    lengths = exact + 3e-3 * random.standard_normal(exact.shape)
    known = {"guess": pose, "lengths": lengths, "rails": rails}
    wide = {key: np.asarray(given, np.longdouble) for key, given in known.items()}
    found = located(generated, pose, lengths, rails)
    return Problem(machine, EPSILON["double"], wide), found


@pytest.mark.parametrize("name", SEARCHED)
def test_where_lengths_disagree_the_last_step_leaves_what_the_judge_says(name: str) -> None:
    problem, found = disagreeing(name)
    wanted = motion.forward_kinematics(problem)
    answered = found.status == Status.OK
    assert np.all(wanted.allowed[np.arange(FEW), found.status]) and answered.mean() > 0.9
    judged = answered & np.all(np.isfinite(wanted.tolerance["pose"]), axis=1)
    assert judged.mean() > 0.9
    off = np.abs(found.pose - wanted.values["pose"])[judged]
    rounding = motion.search_slack(problem, *np.array([[0.0], [1.0], [0.0]]))
    assert np.all(off <= wanted.tolerance["pose"][judged])
    assert np.max(off / wanted.tolerance["pose"][judged]) > 0.1 and np.max(off) > rounding[0]


@pytest.mark.parametrize("name", SEARCHED)
def test_a_step_keeps_the_share_of_an_error_that_the_judge_says(name: str) -> None:
    problem, _ = disagreeing(name)
    best = motion.fixed(problem).found.pose
    kept, off = motion.contraction(problem, best), np.full_like(best, 1e-7)
    for _ in range(40):
        size = norm(off)
        at = best + off * (1e-7 / size)[:, None]
        misfit = problem["lengths"] - cable_lengths(problem.machine, at, problem["rails"])
        off = at + least_squares(motion.pose_jacobian(problem, at), misfit) - best
    assert np.median(np.abs(norm(off) / 1e-7 / kept - 1)) < 1e-3


@pytest.mark.parametrize(("pose", "guess", "rails", "status"), ACROSS_A_WRAP)
def test_a_search_across_the_end_of_a_wrap_may_fail_or_find_better_and_only_there(
    pose: list[float], guess: list[float], rails: list[float], status: Status
) -> None:
    generated = geometry("kinematics_planar_rigid")
    lengths = np.asarray(generated.cable_lengths(pose, rails))
    for start, doubted in ((guess, True), (pose, False)):
        known = {"guess": start, "lengths": lengths, "rails": rails}
        wide = {key: np.asarray([given], np.longdouble) for key, given in known.items()}
        problem = Problem(generated.machine, EPSILON["double"], wide)
        found = located(generated, np.asarray(start), lengths, np.asarray(rails))
        assert found.status == (status if doubted else Status.OK)
        assert motion.forward_kinematics(problem).allowed[0, found.status]
        assert motion.fixed(problem).doubtful[0] == doubted


@pytest.mark.parametrize("name", EVERY_KIND)
def test_locate_says_what_the_single_functions_say(name: str) -> None:
    generated = geometry(name)
    machine, random = generated.machine, np.random.default_rng(83)
    pose, rails = in_the_target(machine, random), rail_coordinates(machine, random)
    lengths = np.asarray(generated.cable_lengths(pose, rails))
    rates = random.uniform(-1, 1, lengths.shape), random.uniform(-1, 1, rails.shape)
    known = {"lengths": lengths, "rails": rails, "length_rates": rates[0], "rail_rates": rates[1]}
    if needs_guess(machine):
        known["guess"] = near(machine, pose, random)
    at = generated.locate(**known)
    found = located(generated, known.get("guess", pose), lengths, rails)
    assert np.array_equal(at.pose, found.pose) and np.array_equal(at.residual, found.residual)
    structure = np.asarray(generated.structure_matrix(at.pose, rails))
    velocity = np.asarray(generated.task_velocity(at.pose, rails, *rates))
    assert np.allclose(at.structure, structure, rtol=0, atol=1e-12)
    assert np.allclose(at.velocity, velocity, rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("name", EVERY_KIND)
def test_the_velocity_is_that_of_a_platform_that_moves(name: str) -> None:
    generated = geometry(name)
    machine, random = generated.machine, np.random.default_rng(84)
    pose, rails = in_the_target(machine, random), rail_coordinates(machine, random)
    twist, slide = random.uniform(-1, 1, pose.shape), random.uniform(-1, 1, rails.shape)
    reeled = np.einsum("kni,ki->kn", generated.length_jacobian(pose, rails), twist)
    reeled += np.einsum("knm,km->kn", generated.rail_jacobian(pose, rails), slide)
    velocity = generated.task_velocity(pose, rails, reeled, slide)
    slack = 1e-12 / least_singular_value(generated, pose, rails)[:, None] ** 2 / machine.lever
    assert np.all(np.abs(np.asarray(velocity) - twist) <= slack)


@pytest.mark.parametrize("precision", REALS)
@pytest.mark.parametrize("name", SEARCHED)
def test_a_search_from_anywhere_answers_a_fit_or_a_fault(name: str, precision: str) -> None:
    generated = geometry(name, precision)
    machine, random = generated.machine, np.random.default_rng(85)
    guess = random.uniform(-1, 1, (POINTS, machine.dof)) * [
        *machine.frame.size,
        *[machine.rotation] * (machine.dof - machine.space),
    ]
    lengths = random.uniform(0, 2 * diagonal(machine), (POINTS, len(machine.cables)))
    found = located(generated, guess, lengths, rail_coordinates(machine, random))
    assert np.all(np.isfinite(found.pose)) and np.all(np.isfinite(found.residual))
    assert set(np.unique(found.status)) <= {Status.OK, Status.SINGULAR, Status.INACCURATE}
    faults = found.status != Status.OK
    assert np.any(found.status == Status.INACCURATE)
    assert np.all(found.pose[faults] == 0)


@pytest.mark.parametrize("name", SEARCHED)
def test_a_guess_at_a_pulley_is_singular(name: str) -> None:
    generated = geometry(name)
    machine = generated.machine
    cable = next(i for i, pulley in enumerate(machine.pulleys) if pulley)
    rails = [rail.length / 2 for rail in machine.rails]
    base = np.asarray(machine.base_motions[cable].point(rails))
    guess = np.zeros(machine.dof)
    guess[: machine.space] = base - machine.anchors[cable]
    lengths = np.full(len(machine.cables), 0.3)
    assert located(generated, guess, lengths, np.asarray(rails)).status == Status.SINGULAR


@pytest.mark.parametrize("name", SEARCHED)
def test_a_guess_beyond_the_domain_is_refused(name: str) -> None:
    generated = geometry(name)
    machine = generated.machine
    lengths, rails = np.full(len(machine.cables), 0.3), np.zeros(len(machine.rails))
    for wrong in (math.nan, 1e6):
        for entry in range(machine.dof):
            guess = at_the_start(machine)[0]
            guess[entry] = wrong
            assert located(generated, guess, lengths, rails).status == Status.OUT_OF_DOMAIN


@pytest.mark.parametrize("precision", REALS)
def test_bases_on_one_line_tell_no_pose_in_either_precision(precision: str) -> None:
    """They are on it but for rounding, which in single precision is more than 1e-4 of the frame."""
    generated = geometry("three_base_equilateral", precision)
    random, depth = np.random.default_rng(82), generated.machine.frame.size[1]
    above, right = random.uniform(0.05, 0.65, (2, POINTS, 2))
    left = above + random.random((POINTS, 1)) * (right - above)
    pairs = (
        above[:, 0],
        depth - above[:, 1],
        left[:, 1],
        left[:, 0],
        right[:, 1],
        depth - right[:, 0],
    )
    rails = np.stack(pairs, axis=-1).astype(REALS[precision])
    lengths = random.uniform(0.05, 0.8, (POINTS, 3)).astype(REALS[precision])
    found = generated.forward_kinematics(lengths=lengths, rails=rails)
    assert np.all(found.status == Status.SINGULAR)
    bases = np.asarray(generated.base_points(rails), dtype=float)
    assert np.allclose(bases[:, 0], above) and np.allclose(bases[:, 2], right)
