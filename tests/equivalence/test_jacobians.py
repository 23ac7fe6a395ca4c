"""The generated Jacobians are derivatives, and virtual work vanishes: every kind of machine."""

import math
from dataclasses import dataclass, replace

import numpy as np
import pytest
from dual import Dual, arctan2, constant, dot, vector
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation
from unmeasured import EVERY_KIND, geometry, machine_named

from turnbuckle.codegen.bind import Generated
from turnbuckle.model.machine import Machine
from turnbuckle.model.pulley import Pulley
from turnbuckle.model.symbolic.function import Status

Doubles = NDArray[np.float64]
MACHINES = ["yoon2023", *EVERY_KIND]
POINTS = 5000
EPSILON = float(np.finfo(np.float64).eps)
#: Anchors nearer to a pulley than this [m] are left out.
CLEAR = 1e-3


@dataclass(frozen=True)
class Drawn:
    """Poses (k, d), the arms R p of the anchors (k, n, space) and rail coordinates (k, m)."""

    machine: Machine
    pose: Doubles
    arms: Doubles
    rails: Doubles


def drawn(machine: Machine, seed: int = 71) -> Drawn:
    """Poses anywhere in the frame, turned as far as the machine file allows."""
    random = np.random.default_rng(seed)
    position = random.random((POINTS, machine.space)) * machine.frame.size
    rails = random.random((POINTS, len(machine.rails))) * [rail.length for rail in machine.rails]
    arms = np.zeros((POINTS, len(machine.cables), machine.space))
    turn = np.zeros((POINTS, 0))
    if machine.is_rigid:
        turn = random.uniform(-1, 1, (POINTS, machine.dof - machine.space))
        turn *= machine.rotation / np.sqrt(turn.shape[1])
        arms = turned(machine, turn)
    return Drawn(machine, np.hstack([position, turn]), arms, rails)


def turned(machine: Machine, turn: Doubles) -> Doubles:
    """R p of every anchor; in the plane a rotation about z."""
    planar = machine.space == 2
    vectors = np.pad(turn, ((0, 0), (2, 0))) if planar else turn
    matrices = Rotation.from_rotvec(vectors).as_matrix()[:, : machine.space, : machine.space]
    return np.asarray(np.einsum("kij,nj->kni", matrices, machine.anchors))


@np.errstate(invalid="ignore")
def lengths(d: Drawn, twist: int, rail: int) -> tuple[list[Dual], Doubles]:
    """Lengths as one entry of the twist or one rail coordinate moves; distances to spare (k)."""
    machine = d.machine
    spare = np.full(POINTS, np.inf)
    result = []
    for i, (motion, pulley) in enumerate(zip(machine.base_motions, machine.pulleys, strict=True)):
        reach = anchor(d, i, twist)
        for axis in range(machine.space):
            reach[axis] = reach[axis] - constant(motion.start[axis])
            for k, direction in motion.travel:
                slide = Dual(d.rails[:, k], np.full(POINTS, float(k == rail)))
                reach[axis] = reach[axis] - constant(direction[axis]) * slide
        length, distance = reeled(pulley, reach)
        result.append(length)
        spare = np.fmin(spare, np.nan_to_num(distance, nan=-1.0))
    return result, spare


def anchor(d: Drawn, i: int, twist: int) -> list[Dual]:
    """The anchor of cable i, moved by one entry of (dc, dw)."""
    space = d.machine.space
    rate = np.zeros((POINTS, space))
    if 0 <= twist < space:
        rate[:, twist] = 1.0
    elif twist >= space:
        spin = np.eye(3)[2 if space == 2 else twist - space]
        padded = np.pad(d.arms[:, i], ((0, 0), (0, 3 - space)))
        rate = np.cross(spin, padded)[:, :space]
    value = d.pose[:, :space] + d.arms[:, i]
    return [Dual(value[:, axis], rate[:, axis]) for axis in range(space)]


def reeled(pulley: Pulley | None, reach: list[Dual]) -> tuple[Dual, Doubles]:
    """Length of a cable whose anchor is at `reach` from its base, and the distance to spare."""
    if pulley is None:
        length = dot(reach, reach).sqrt()
        return length, length.value
    radius = constant(pulley.radius)
    if len(reach) == 2:
        free = (dot(reach, reach) - radius * radius).sqrt()
        return free + radius * planar_wrap(pulley, reach, free), free.value
    along = dot(reach, vector(pulley.axis))
    arm = [x - along * constant(k) for x, k in zip(reach, pulley.axis, strict=True)]
    swivel = dot(arm, arm).sqrt()
    across = swivel - radius
    free = (across * across + along * along - radius * radius).sqrt()
    # t = (sin a, cos a) and n = (-cos a, sin a) with (across, along) = r n + free t
    wrap = quarter_before(free * across + radius * along, free * along - radius * across)
    return free + radius * wrap, np.fmin(free.value, swivel.value)


def planar_wrap(pulley: Pulley, reach: list[Dual], free: Dual) -> Dual:
    """Angle from the first contact to where the cable leaves, in the sense it winds."""
    sense, radius = constant(pulley.winds), constant(pulley.radius)
    x, y = reach
    normal = [x * radius + y * free * sense, y * radius - x * free * sense]
    begin = vector(pulley.contact)
    sine = sense * (begin[0] * normal[1] - begin[1] * normal[0])
    return quarter_before(sine, dot(begin, normal))


def quarter_before(sine: Dual, cosine: Dual) -> Dual:
    """Angle of (cosine, sine) from -pi / 2 to 3 pi / 2."""
    return constant(np.pi / 2) + arctan2(constant(0.0) - cosine, sine)


def check(jacobian: Doubles, rates: Doubles, spare: Doubles, size: float) -> None:
    """Equal but for the rounding of a direction: that of a coordinate over the distance."""
    clear = spare > CLEAR
    assert clear.sum() > POINTS / 2
    slack = 16 * EPSILON * max(1.0, size) / spare[clear, None]
    assert np.all(np.abs(jacobian - rates)[clear] <= slack)


def reach_of(machine: Machine) -> float:
    return math.hypot(*machine.frame.size) + machine.lever


@pytest.mark.parametrize("name", MACHINES)
def test_lengths_are_those_of_the_conventions(name: str) -> None:
    d = drawn(machine_named(name))
    wanted, spare = lengths(d, -1, -1)
    found = geometry(name).cable_lengths(d.pose, d.rails)
    clear = spare > CLEAR
    values = np.stack([length.value for length in wanted], axis=1)
    assert np.all(found.status[clear] == Status.OK)
    slack = 16 * EPSILON * reach_of(d.machine) ** 2 / spare[clear, None]
    assert np.all(np.abs(np.asarray(found) - values)[clear] <= slack)


@pytest.mark.parametrize("name", MACHINES)
def test_the_length_jacobian_is_the_derivative_by_dual_numbers(name: str) -> None:
    d = drawn(machine_named(name))
    jacobian = np.asarray(geometry(name).length_jacobian(d.pose, d.rails))
    for entry in range(d.machine.dof):
        moved, spare = lengths(d, entry, -1)
        rates = np.stack([length.rate for length in moved], axis=1)
        check(jacobian[:, :, entry], rates, spare, reach_of(d.machine))


@pytest.mark.parametrize("name", MACHINES)
def test_the_rail_jacobian_is_the_derivative_by_dual_numbers(name: str) -> None:
    d = drawn(machine_named(name))
    jacobian = np.asarray(geometry(name).rail_jacobian(d.pose, d.rails))
    for rail in range(len(d.machine.rails)):
        moved, spare = lengths(d, -1, rail)
        rates = np.stack([length.rate + np.zeros(POINTS) for length in moved], axis=1)
        check(jacobian[:, :, rail], rates, spare, reach_of(d.machine))


@pytest.mark.parametrize("name", MACHINES)
def test_the_length_jacobian_is_minus_the_structure_matrix_transposed(name: str) -> None:
    d = drawn(machine_named(name))
    generated = geometry(name)
    jacobian = np.asarray(generated.length_jacobian(d.pose, d.rails))
    structure = np.asarray(generated.structure_matrix(d.pose, d.rails))
    _, spare = lengths(d, -1, -1)
    for entry in range(d.machine.dof):
        check(jacobian[:, :, entry], -structure[:, entry], spare, reach_of(d.machine))


def work(d: Drawn, generated: Generated) -> tuple[Doubles, Doubles]:
    """T'.dl + W'.dx + F'.ds of random small motions (k), and T'.dl alone."""
    machine, random = d.machine, np.random.default_rng(72)
    shape = (POINTS, len(machine.cables))
    tension = random.uniform(machine.tension.min, machine.tension.max, shape)
    shift, slide = random.standard_normal(d.pose.shape), random.standard_normal(d.rails.shape)
    dl_dx = np.asarray(generated.length_jacobian(d.pose, d.rails))
    dl_ds = np.asarray(generated.rail_jacobian(d.pose, d.rails))
    structure = np.asarray(generated.structure_matrix(d.pose, d.rails))
    wrench = np.asarray(generated.wrench(structure, tension))
    force = np.asarray(generated.rail_forces(d.pose, d.rails, tension))
    reel = np.einsum("kni,ki->kn", dl_dx, shift) + np.einsum("knm,km->kn", dl_ds, slide)
    pulled = np.sum(tension * reel, axis=1)
    return pulled + np.sum(wrench * shift, axis=1) + np.sum(force * slide, axis=1), pulled


@pytest.mark.parametrize("name", MACHINES)
def test_virtual_work_vanishes(name: str) -> None:
    d = drawn(machine_named(name))
    total, pulled = work(d, geometry(name))
    _, spare = lengths(d, -1, -1)
    clear = spare > CLEAR
    motion = 16 * d.machine.tension.max * len(d.machine.cables)
    slack = 16 * EPSILON * motion * max(1.0, reach_of(d.machine)) / spare[clear]
    assert np.all(np.abs(total[clear]) <= slack)
    assert np.max(np.abs(pulled)) > 1


def test_a_wrong_sense_of_winding_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    name = "kinematics_planar_pulleys"
    d = drawn(machine_named(name))
    jacobian = np.asarray(geometry(name).length_jacobian(d.pose, d.rails))
    other = tuple(pulley and replace(pulley, winds=-pulley.winds) for pulley in d.machine.pulleys)
    monkeypatch.setattr(Machine, "pulleys", other)
    moved, spare = lengths(d, 0, -1)
    rates = np.stack([length.rate for length in moved], axis=1)
    with pytest.raises(AssertionError):
        check(jacobian[:, :, 0], rates, spare, reach_of(d.machine))
