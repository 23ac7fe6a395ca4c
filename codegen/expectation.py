"""What the independent reference expects of every generated function, and how nearly.

The reference computes in long double from the very numbers the C was given, so its own rounding is
a two-thousandth of a unit in the last place of a double and does not count. What remains is the
rounding of the C, which is told in one of two ways:

- Functions of position: the bound that the header states, plus what the condition of the problem
  makes of `ROUNDINGS` units in the last place where the header's search does not go.
- Tensions: `TENSION_ROUNDINGS` units in the last place of T_max, times the condition of the cables
  that are free, plus what moving the bounds by as much does to the result. The latter is the whole
  truth at vertices, at verdicts and for policies: rounding may choose either side of a border, and
  a problem whose bounds are a hair off shows how much that matters.
"""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from model.machine import Machine
from model.reference import control, kinematics, quality, statics, tension
from model.reference.planar import Array as Wide
from model.reference.planar import minors, norm
from model.reference.wrench_set import slabs
from model.symbolic import tension as solver
from model.symbolic.function import Status
from model.symbolic.kinematics import CONTACT_DISTANCE, PIVOT_ROUNDINGS, SMALLEST_PIVOT
from model.symbolic.tension import INWARDS, KKT_TOLERANCE, LARGEST_MISS

Bools = NDArray[np.bool_]

#: Units in the last place that a short chain of operations may lose, before conditioning.
ROUNDINGS = 64.0
#: The same for tensions: 5.7e-14 of T_max in double precision, 3.1e-5 in single.
TENSION_ROUNDINGS = 256.0
#: How far from the limit of singularity a pivot must be to be decided whatever the rounding.
RANK_FACTOR = 4.0


@dataclass(frozen=True)
class Problem:
    """Arguments by name (count, *shape), wide, and the spacing of the precision that is judged."""

    machine: Machine
    epsilon: float
    arguments: dict[str, Wide]
    solved: dict[str, Any] = field(default_factory=dict)

    def __getitem__(self, name: str) -> Wide:
        return self.arguments[name]

    @property
    def count(self) -> int:
        """Number of points."""
        return len(next(iter(self.arguments.values())))


@dataclass(frozen=True)
class Expected:
    """Values by output; tolerance of each at every point; which statuses are right (count, 5).

    `beside_header`: whether the header's bound is added to the tolerance.
    """

    values: dict[str, Wide]
    tolerance: dict[str, Wide]
    allowed: Bools
    beside_header: bool = True


Judge = Callable[[Problem], Expected]


def statuses(
    count: int, normal: dict[Status, Bools], faults: dict[Status, tuple[Bools, Bools]]
) -> Bools:
    """Right answers from where normal ones are possible and faults (must, may) be reported."""
    allowed = np.zeros((count, len(Status)), dtype=bool)
    forced = np.zeros(count, dtype=bool)
    for status, (must, may) in faults.items():
        allowed[:, status] |= may
        forced |= must
    for status, possible in normal.items():
        allowed[:, status] |= possible & ~forced
    return allowed


def always(count: int) -> Bools:
    """True everywhere."""
    return np.ones(count, dtype=bool)


def below(value: Wide, limit: float, slack: Wide | float) -> tuple[Bools, Bools]:
    """Where a value must, and where it may, be found below a limit; zero must in any case."""
    return value < limit - np.minimum(slack, limit * 3 / 4), value < limit + slack


def union(*pairs: tuple[Bools, Bools]) -> tuple[Bools, Bools]:
    """Where one of several faults must, and may, be reported."""
    return (
        np.logical_or.reduce([must for must, _ in pairs]),
        np.logical_or.reduce([may for _, may in pairs]),
    )


def extent(machine: Machine) -> float:
    """Largest coordinate [m]."""
    return float(max(machine.frame.size))


def nearest_pulley(p: Problem) -> Wide:
    """Distance (count) [m] from the platform to the nearest pulley."""
    return np.asarray(
        np.min(norm(kinematics.cable_vectors(p.machine, p["pose"], p["rails"])), axis=-1)
    )


def touching(p: Problem) -> tuple[Bools, Bools]:
    """Where the platform touches a pulley."""
    slack = ROUNDINGS * p.epsilon * extent(p.machine)
    return below(nearest_pulley(p), CONTACT_DISTANCE, slack)


def least_pivot(rows: Wide) -> Wide:
    """Smaller pivot (count) of rows' rows, rows (count, n, 2), by the Cauchy-Binet formula."""
    first = np.sum(rows[..., 0] ** 2, axis=-1)
    determinant = np.sum(minors(rows) ** 2, axis=(-2, -1)) / 2
    second = np.divide(determinant, first, out=np.zeros_like(first), where=first > 0)
    return np.asarray(np.minimum(first, second))


def smallest_singular_value(columns: Wide) -> Wide:
    """Of S (count), whose columns are given (count, n, 2); weights 0 leave columns out."""
    trace = np.sum(columns**2, axis=(-2, -1))
    determinant = np.sum(minors(columns) ** 2, axis=(-2, -1)) / 2
    largest = (trace + np.sqrt(np.maximum(trace**2 - 4 * determinant, 0))) / 2
    square = np.divide(determinant, largest, out=np.zeros_like(trace), where=largest > 0)
    return np.asarray(np.sqrt(square))


def broadcast(value: Wide | float, like: Wide) -> Wide:
    """A tolerance per point, or for all, in the shape of a result."""
    per_point = np.asarray(value, dtype=np.longdouble)
    shape = per_point.shape + (1,) * (like.ndim - per_point.ndim if per_point.ndim else 0)
    return np.broadcast_to(per_point.reshape(shape), like.shape)


def expected(
    p: Problem, values: dict[str, Wide], slack: dict[str, Wide | float], allowed: Bools
) -> Expected:
    """Values with the given tolerances beside the header's, 0 where none is given."""
    tolerance = {name: broadcast(slack.get(name, 0.0), value) for name, value in values.items()}
    return Expected(values, tolerance, allowed)


def everywhere(p: Problem, **values: Wide) -> Expected:
    """A function that never refuses; constants that the generator folds are rounded once more."""
    slack = {
        name: 4 * p.epsilon * float(np.max(np.abs(v), initial=0)) for name, v in values.items()
    }
    ok = {Status.OK: always(p.count)}
    return expected(p, values, {**slack}, statuses(p.count, ok, {}))


def away_from_pulleys(p: Problem, sensitive: bool, **values: Wide) -> Expected:
    """A function that refuses at a pulley; `sensitive`: directions lose what the distance does."""
    distance = np.maximum(nearest_pulley(p), CONTACT_DISTANCE / 2)
    gain = extent(p.machine) / distance if sensitive else np.ones_like(distance)
    slack: dict[str, Wide | float] = {
        name: 8 * p.epsilon * gain * float(np.nanmax(np.abs(value), initial=0))
        for name, value in values.items()
    }
    faults = {Status.SINGULAR: touching(p)}
    return expected(p, values, slack, statuses(p.count, {Status.OK: always(p.count)}, faults))


def base_points(p: Problem) -> Expected:
    return everywhere(p, points=kinematics.base_points(p.machine, p["rails"]))


def cable_vectors(p: Problem) -> Expected:
    return everywhere(p, vectors=kinematics.cable_vectors(p.machine, p["pose"], p["rails"]))


def cable_lengths(p: Problem) -> Expected:
    length = kinematics.cable_lengths(p.machine, p["pose"], p["rails"])
    return away_from_pulleys(p, False, length=length)


def structure_matrix(p: Problem) -> Expected:
    structure = kinematics.structure_matrix(p.machine, p["pose"], p["rails"])
    return away_from_pulleys(p, True, structure=structure)


def length_jacobian(p: Problem) -> Expected:
    jacobian = kinematics.length_jacobian(p.machine, p["pose"], p["rails"])
    return away_from_pulleys(p, True, jacobian=jacobian)


def rail_jacobian(p: Problem) -> Expected:
    jacobian = kinematics.rail_jacobian(p.machine, p["pose"], p["rails"])
    return away_from_pulleys(p, True, jacobian=jacobian)


def rail_forces(p: Problem) -> Expected:
    force = statics.rail_forces(p.machine, p["pose"], p["rails"], p["tension"])
    return away_from_pulleys(p, True, force=force)


def smallest_pivot(p: Problem) -> float:
    """Below this a pivot of S S' counts as zero."""
    return max(SMALLEST_PIVOT, PIVOT_ROUNDINGS * p.epsilon)


def task_velocity(p: Problem) -> Expected:
    """Least squares by the normal equations: loses what the pivot does, once for the answer and
    once for the rates; rounding in directions is as for the structure matrix."""
    arguments = (p["pose"], p["rails"], p["length_rates"], p["rail_rates"])
    velocity = kinematics.task_velocity(p.machine, *arguments)
    rows = kinematics.length_jacobian(p.machine, p["pose"], p["rails"])
    pivot = least_pivot(rows)
    lost = below(pivot, smallest_pivot(p), ROUNDINGS * p.epsilon)
    rates = norm(p["length_rates"]) + norm(p["rail_rates"]) + norm(velocity)
    gain = 1 + extent(p.machine) / np.maximum(nearest_pulley(p), CONTACT_DISTANCE / 2)
    slack = ROUNDINGS * p.epsilon * gain * rates / np.maximum(pivot, smallest_pivot(p) / 2)
    faults = {Status.SINGULAR: union(touching(p), lost)}
    allowed = statuses(p.count, {Status.OK: always(p.count)}, faults)
    return expected(p, {"velocity": velocity}, {"velocity": slack}, allowed)


@dataclass(frozen=True)
class Fixed:
    """Where the reference finds the platform from lengths, and how nearly the C can."""

    found: kinematics.ForwardKinematics
    slack: Wide
    nearest: Wide
    pivot: Wide
    lost: tuple[Bools, Bools]


def fixed(p: Problem) -> Fixed:
    """The closed form loses what the spread of the bases does; the step returns all but a square of
    that, and loses what the pivot of the directions does."""
    found = kinematics.forward_kinematics(p.machine, p["lengths"], p["rails"])
    points = kinematics.base_points(p.machine, p["rails"])
    arms = points - np.mean(points, axis=-2, keepdims=True)
    size, spread = np.sum(arms**2, axis=(-2, -1)), least_pivot(arms)
    limit = (1e-4 * extent(p.machine)) ** 2
    collinear = below(spread, limit, ROUNDINGS * p.epsilon * size)
    vectors = points - found.pose[:, None, :]
    distance = np.maximum(norm(vectors), CONTACT_DISTANCE / 2)
    exact_pivot = least_pivot(vectors / distance[..., None])
    pivot = np.maximum(exact_pivot, smallest_pivot(p) / 2)
    reach = np.sqrt(size) + np.max(p["lengths"], axis=-1)
    closed_form = ROUNDINGS * p.epsilon * reach * size / np.maximum(spread, limit / 2)
    at_pulley = below(np.min(norm(vectors), axis=-1), CONTACT_DISTANCE, closed_form)
    nearest = np.min(distance, axis=-1)
    second_order = closed_form**2 / np.minimum(nearest, 1) / pivot
    slack = np.minimum(closed_form, second_order + ROUNDINGS * p.epsilon * reach / pivot)
    return Fixed(found, np.asarray(slack), nearest, exact_pivot, union(collinear, at_pulley))


def forward_kinematics(p: Problem) -> Expected:
    """Judges tb_forward_kinematics."""
    at = fixed(p)
    allowed = statuses(p.count, {Status.OK: always(p.count)}, {Status.SINGULAR: at.lost})
    values = {"pose": at.found.pose, "residual": at.found.residual}
    return expected(p, values, {"pose": at.slack, "residual": 2 * at.slack}, allowed)


def locate(p: Problem) -> Expected:
    """As forward_kinematics; a pose that is off turns the directions, the more the nearer."""
    at = fixed(p)
    pose = at.found.pose
    velocity = kinematics.task_velocity(
        p.machine, pose, p["rails"], p["length_rates"], p["rail_rates"]
    )
    turn = (at.slack + ROUNDINGS * p.epsilon * extent(p.machine)) / at.nearest
    flat = below(at.pivot, smallest_pivot(p), ROUNDINGS * p.epsilon + turn)
    rates = norm(p["length_rates"]) + norm(p["rail_rates"]) + norm(velocity)
    drift = (ROUNDINGS * p.epsilon + turn) * rates / np.maximum(at.pivot, smallest_pivot(p) / 2)
    values = {
        "pose": pose,
        "residual": at.found.residual,
        "structure": kinematics.structure_matrix(p.machine, pose, p["rails"]),
        "velocity": velocity,
    }
    slack: dict[str, Wide | float] = {
        "pose": at.slack,
        "residual": 2 * at.slack,
        "structure": turn,
        "velocity": drift,
    }
    faults = {Status.SINGULAR: union(at.lost, flat)}
    allowed = statuses(p.count, {Status.OK: always(p.count)}, faults)
    return replace(expected(p, values, slack, allowed), beside_header=False)


def wrench(p: Problem) -> Expected:
    return everywhere(p, wrench=statics.wrench(p.machine, p["structure"], p["tension"]))


def motor_torques(p: Problem) -> Expected:
    return everywhere(p, torque=control.motor_torques(p.machine, p["tension"]))


def wall_force(p: Problem) -> Expected:
    """The damper sets in at once at the surface: within rounding of it, either side is right."""
    force = control.wall_force(p.machine, p["pose"], p["velocity"])
    slack = np.full(p.count, 4 * p.epsilon * float(np.max(np.abs(force), initial=0)), np.longdouble)
    for wall in p.machine.walls:
        normal = np.asarray(wall.normal, np.longdouble)
        depth = np.sum((np.asarray(wall.point, np.longdouble) - p["pose"]) * normal, axis=-1)
        at_surface = np.abs(depth) <= 8 * p.epsilon * extent(p.machine)
        slack += np.where(at_surface, wall.damping * norm(p["velocity"]), 0)
    allowed = statuses(p.count, {Status.OK: always(p.count)}, {})
    return expected(p, {"force": force}, {"force": slack}, allowed)


def base_targets(p: Problem) -> Expected:
    return everywhere(p, target=control.base_targets(p.machine, p["pose"]))


def base_pid(p: Problem) -> Expected:
    """Whether the integral grows is decided at the force limit: there, either is right."""
    answer = control.base_pid(p.machine, p["memory"], p["target"], p["measured"])
    drive = p.machine.rail_drive
    assert drive is not None
    error = np.abs(p["target"] - p["measured"])
    # the derivative adds the most: a difference of positions, over one period
    moved = norm(p["memory"][..., 1] - p["measured"]) + extent(p.machine)
    rounding = 8 * p.epsilon * moved * p.machine.control.rate * drive.damping
    at_limit = np.abs(np.abs(answer.force) - drive.force_limit) <= rounding[:, None]
    step = drive.integral / p.machine.control.rate * error
    slack = np.zeros_like(answer.memory)
    slack[..., 0] = np.where(at_limit, step, 0)
    allowed = statuses(p.count, {Status.OK: always(p.count)}, {})
    values = {"next_memory": answer.memory, "force": answer.force}
    return expected(p, values, {"next_memory": slack}, allowed)


def load_tension(p: Problem) -> Expected:
    load = control.load_tension(p.machine, p["structure"], p["tension"], p["hand_force"])
    columns = np.swapaxes(p["structure"], -1, -2)
    pivot = least_pivot(columns)
    lost = below(pivot, smallest_pivot(p), ROUNDINGS * p.epsilon)
    forces = norm(p["hand_force"]) + np.sum(np.abs(p["tension"]), axis=-1) + norm(load)
    slack = ROUNDINGS * p.epsilon * forces / np.maximum(pivot, smallest_pivot(p) / 2)
    faults = {Status.SINGULAR: lost}
    allowed = statuses(p.count, {Status.OK: always(p.count)}, faults)
    return expected(p, {"load": load}, {"load": slack}, allowed)


@dataclass(frozen=True)
class Bounded:
    """Tensions with the machine's bounds; how much they, and what they deliver, may differ."""

    tension: Wide
    delivered: Wide
    tension_slack: Wide
    delivered_slack: Wide
    feasible: Bools
    infeasible: Bools
    gain: Wide


def with_bounds(machine: Machine, relative: float) -> Machine:
    """The machine with its range of tensions wider by a fraction of T_max at either end."""
    shift = relative * machine.tension.max
    low, high = machine.tension.min - shift, machine.tension.max + shift
    bounds = machine.tension.model_copy(update={"min": low, "max": high})
    return machine.model_copy(update={"tension": bounds})


def amplification(structure: Wide, tension: Wide, low: float, high: float) -> Wide:
    """How much a rounding of the wrench moves the tensions (count).

    The free cables take it up: one over the smallest singular value of their part of S. On an edge
    or at a vertex fewer than two are free, and a rounding inwards frees another one: one over the
    sine of the least angle that a pair of cables, with the free one where there is one, makes.
    """
    off = 1e-9 * max(low, 1e-9)
    free = (tension > low + off) & (tension < high - off)
    count = np.sum(free, axis=-1)
    columns = np.swapaxes(structure, -1, -2)
    least = smallest_singular_value(columns * free[..., None])
    sine = np.abs(minors(columns))
    first = free | (count == 0)[:, None]
    counts = first[:, :, None] & (sine > np.finfo(sine.dtype).eps * ROUNDINGS)
    narrowest = np.min(np.where(counts, sine, 1), axis=(-2, -1))
    return np.asarray(1 / np.where((count >= 2) & (least > 0), least, narrowest))


def bounded(p: Problem, structure: Wide, wrench: Wide, policy: str) -> Bounded:
    """The reference's distribution, and those with bounds a hair wider and tighter.

    Moved bounds show what rounding does at borders; twice that is allowed.
    """
    machine, relative = p.machine, TENSION_ROUNDINGS * p.epsilon
    bounds = machine.tension
    answer = tension.distribute_tension(machine, structure, wrench, policy)
    wide, tight = (
        tension.distribute_tension(with_bounds(machine, sign * relative), structure, wrench, policy)
        for sign in (1, -1)
    )
    judge = paper_verdicts if policy == "paper" else verdicts
    feasible, infeasible = judge(machine, p.epsilon, structure, wrench)
    gain = amplification(structure, answer.tension, bounds.min, bounds.max)
    moved = [np.maximum(np.abs(a - b), np.abs(c - b)) for a, b, c in _pairs(wide, answer, tight)]
    size = norm(wrench) + np.sum(answer.tension, axis=-1)
    served = ROUNDINGS * p.epsilon * size
    if policy == "closest":
        served = served + infeasible * corner_slack(p, wrench, answer)
    if policy == "scale":
        # the ray meets the border of a flat set at a small angle
        served = served + 2 * infeasible * tolerated(machine, p.epsilon, structure)
    own = relative * bounds.max * gain
    lost = np.zeros(p.count, dtype=bool)
    if policy != "paper":
        # in a corner of nearly parallel cables the C serves a wrench a little further in
        lost = infeasible & nearly_parallel(p, structure)
        middle = (bounds.min + bounds.max) / 2 * np.sum(structure, axis=-1)
        served = served + np.where(lost, INWARDS * norm(answer.delivered - middle), 0)
    if policy != "paper":
        served = served + (feasible & infeasible) * tolerated(machine, p.epsilon, structure)
    return Bounded(
        answer.tension,
        answer.delivered,
        np.where(lost[:, None], np.inf, (own + served * gain)[:, None] + 2 * moved[0]),
        served[:, None] + np.where(infeasible[:, None], 2 * moved[1], 0),
        feasible,
        infeasible,
        gain,
    )


def nearly_parallel(p: Problem, structure: Wide) -> Bools:
    """Where two cables, not quite parallel, are so near it that a corner of them may close."""
    sine = np.abs(minors(np.swapaxes(structure, -1, -2)))
    apart = np.where(sine > np.finfo(sine.dtype).eps * ROUNDINGS, sine, 1)
    return np.asarray(np.min(apart, axis=(-2, -1)) < 8 * p.epsilon**0.25)


def corner_slack(p: Problem, wrench: Wide, answer: Any) -> Wide:
    """How far beside the nearest point of a polygon rounding may find it, near a corner.

    Two points of it that are sqrt(epsilon) of the distance apart are equally near up to rounding.
    """
    bounds, away = p.machine.tension, norm(answer.delivered - wrench)
    reach = 8 * np.sqrt(p.epsilon) * away
    room = np.minimum(answer.tension - bounds.min, bounds.max - answer.tension)
    moving = np.max(room, axis=-1)
    return np.asarray(np.where(moving <= reach, reach, 0))


def tolerated(machine: Machine, epsilon: float, structure: Wide) -> Wide:
    """How far outside the set a wrench (count) [N] may be that the C's own check lets pass."""
    least = smallest_singular_value(np.swapaxes(structure, -1, -2))
    most = RANK_FACTOR * KKT_TOLERANCE * epsilon * machine.tension.max
    return np.asarray(most / np.maximum(np.minimum(least, 1), rank_limit(epsilon)))


def _pairs(wide: Any, answer: Any, tight: Any) -> list[tuple[Wide, Wide, Wide]]:
    return [
        (wide.tension, answer.tension, tight.tension),
        (wide.delivered, answer.delivered, tight.delivered),
    ]


def verdicts(
    machine: Machine, epsilon: float, structure: Wide, wrench: Wide
) -> tuple[Bools, Bools]:
    """Where a wrench may count as feasible, and where as infeasible."""
    normals, middle, half_width = slabs(machine, structure)
    along = np.sum(normals * wrench[:, None, :], axis=-1)
    inside = np.min(half_width - np.abs(along - middle), axis=-1)
    slack = tolerated(machine, epsilon, structure)
    return inside >= -slack, inside <= ROUNDINGS * epsilon * machine.tension.max


def paper_verdicts(
    machine: Machine, epsilon: float, structure: Wide, wrench: Wide
) -> tuple[Bools, Bools]:
    """The same for Yoon eqs 22 and 23: it has no solution, or one that is clipped."""
    high, relative = machine.tension.max, TENSION_ROUNDINGS * epsilon
    beside = wrench[:, ::-1] * [1, -1] * relative
    solved = [
        tension.minimum_norm_tension(
            structure, wrench + turn * beside, machine.tension.min - shift * high, np.inf
        )
        for shift, turn in ((0.0, 0), (relative, 0), (-relative, 0), (0.0, 1), (0.0, -1))
    ]
    gain = amplification(structure, solved[0].tension, machine.tension.min, np.inf)
    slack = (relative * (high + norm(wrench)) * gain)[:, None]
    fits = [s.solved & np.all(s.tension <= high + slack, axis=-1) for s in solved]
    exceeds = np.any(solved[0].tension >= high - slack, axis=-1)
    always_solved = np.logical_and.reduce([s.solved for s in solved])
    return np.logical_or.reduce(fits), ~always_solved | exceeds


def rank_limit(epsilon: float) -> float:
    """Below this a pivot of S counts as zero."""
    return max(solver.SMALLEST_PIVOT, solver.RANK_TOLERANCE * epsilon)


def rank(p: Problem, structure: Wide) -> tuple[Wide, tuple[Bools, Bools]]:
    """Smallest singular value of S, and where S must, and may, count as singular.

    The C looks at the pivots of a factorisation without exchanges, which are never smaller than
    the smallest singular value, but may be larger.
    """
    columns = np.swapaxes(structure, -1, -2)
    least = smallest_singular_value(columns)
    limit = rank_limit(p.epsilon)
    pivot = np.sqrt(least_pivot(columns))
    return least, (pivot < limit / RANK_FACTOR, least < limit * RANK_FACTOR)


def distribution(policy: str) -> Judge:
    """Judges tb_distribute_tension_<policy>."""

    def judge(p: Problem) -> Expected:
        found = solved(p, policy)
        least, singular = rank(p, p["structure"])
        normal = {Status.OK: found.feasible, Status.INFEASIBLE: found.infeasible}
        # where S is nearly singular its own check may fail as well
        doubtful = singular[1] | too_near_singular(p, least, found)
        faults = {
            Status.SINGULAR: singular,
            Status.INACCURATE: (np.zeros(p.count, dtype=bool), doubtful),
        }
        if policy == "paper":
            # no answer within rounding is told as no answer at all
            doubtful = doubtful | nearly_parallel(p, p["structure"])
            normal[Status.INFEASIBLE] = found.infeasible | doubtful
            normal[Status.OK] = found.feasible | doubtful
        allowed = statuses(p.count, normal, faults)
        answer = tension_expected(p, found, least, allowed)
        if policy == "paper":
            forget_doubtful(p, answer, doubtful)
        return answer

    return judge


def forget_doubtful(p: Problem, answer: Expected, doubtful: Bools) -> None:
    """Without an upper bound tensions may be huge, and what they miss the wrench by as well."""
    answer.tolerance["kkt_residual"] += LARGEST_MISS * p.machine.tension.max
    for name in ("tension", "delivered"):
        answer.tolerance[name][doubtful] = np.inf


def too_near_singular(p: Problem, least: Wide, found: Bounded) -> Bools:
    """Where rounding alone may miss the wrench by more than the C lets pass."""
    high = p.machine.tension.max
    largest = np.maximum(np.max(found.tension, axis=-1), high) * np.maximum(1, found.gain)
    rounding = RANK_FACTOR * KKT_TOLERANCE * p.epsilon * largest
    return np.asarray(rounding > LARGEST_MISS * high * least)


def least_norm(p: Problem) -> Expected:
    """Judges the exact solver: it reports, by its own check, a wrench that is infeasible."""
    found = solved(p, "closest")
    least, singular = rank(p, p["structure"])
    nowhere = np.zeros(p.count, dtype=bool)
    doubtful = found.infeasible | too_near_singular(p, least, found)
    faults = {Status.SINGULAR: singular, Status.INACCURATE: (nowhere, doubtful)}
    allowed = statuses(p.count, {Status.OK: found.feasible}, faults)
    return tension_expected(p, found, least, allowed)


def least_norm_quick(p: Problem) -> Expected:
    """Judges the quick solver: it may give up anywhere, but must not answer wrongly."""
    answer = least_norm(p)
    answer.allowed[:, Status.INACCURATE] = True
    return answer


def tension_expected(p: Problem, found: Bounded, least: Wide, allowed: Bools) -> Expected:
    """Tensions, what they deliver, and no more than the stated residual."""
    scale = p.machine.tension.max + np.sum(np.abs(p["wrench"]), axis=-1)
    limit = RANK_FACTOR * KKT_TOLERANCE * p.epsilon * scale
    residual = np.divide(limit, least, out=np.full(p.count, np.inf, limit.dtype), where=least > 0)
    values = {
        "tension": found.tension,
        "delivered": found.delivered,
        "kkt_residual": np.zeros(p.count, np.longdouble),
    }
    tolerance = {
        "tension": found.tension_slack,
        "delivered": np.maximum(found.delivered_slack, residual[:, None]),
        "kkt_residual": residual,
    }
    return Expected(values, tolerance, allowed, beside_header=False)


def solved(p: Problem, policy: str) -> Bounded:
    """The distribution of this problem, computed once for all functions that need it."""
    if policy not in p.solved:
        p.solved[policy] = bounded(p, p["structure"], p["wrench"], policy)
    found: Bounded = p.solved[policy]
    return found


def served_wrench(policy: str) -> Judge:
    """Judges tb_served_wrench_<policy>."""

    def judge(p: Problem) -> Expected:
        found = solved(p, policy)
        normal = {Status.OK: found.feasible, Status.INFEASIBLE: found.infeasible}
        allowed = statuses(p.count, normal, {})
        # parallel cables are refused by the distribution before a wrench is served
        _, (_, singular) = rank(p, p["structure"])
        allowed |= singular[:, None]
        limits = p.machine.tension
        least = ROUNDINGS * p.epsilon * limits.max
        slack = found.delivered_slack + least
        slack = np.where(singular[:, None], np.longdouble(np.inf), slack)
        middle = (limits.min + limits.max) / 2 * np.sum(p["structure"], axis=-1)
        inner = found.delivered
        inner = inner + INWARDS * (middle - inner)
        values = {"served": found.delivered, "inner": inner}
        return Expected(values, dict.fromkeys(values, slack), allowed, beside_header=False)

    return judge


def zero_wrench(p: Problem) -> Bounded:
    """The zero-wrench distribution at the pose, computed once for all functions that need it."""
    if "zero" not in p.solved:
        structure = kinematics.structure_matrix(p.machine, p["pose"], p["rails"])
        structure = np.where(np.isnan(structure), 0, structure)
        nothing = np.zeros((p.count, 2), np.longdouble)
        p.solved["zero"] = bounded(p, structure, nothing, "closest")
    found: Bounded = p.solved["zero"]
    return found


def of_quality(
    p: Problem, name: str, value: Wide, outside: float, slack: Wide, ranked: bool
) -> Expected:
    """A measure of a pose: `outside` where the zero wrench is infeasible."""
    found = zero_wrench(p)
    values = {name: np.where(np.isnan(value), np.longdouble(outside), value)}
    structure = kinematics.structure_matrix(p.machine, p["pose"], p["rails"])
    lost = rank(p, structure)[1] if ranked else (always(p.count) & False,) * 2
    faults = {Status.SINGULAR: union(touching(p), lost)}
    normal = {Status.OK: found.feasible, Status.INFEASIBLE: found.infeasible}
    allowed = statuses(p.count, normal, faults)
    return Expected(values, {name: broadcast(slack, value)}, allowed)


def direction_gain(p: Problem) -> Wide:
    """Rounding of S over that of a coordinate: one over the distance to the pulley."""
    return 1 + extent(p.machine) / np.maximum(nearest_pulley(p), CONTACT_DISTANCE / 2)


def on_the_border(p: Problem) -> Bools:
    """Poses that rounding may put outside the zero-wrench workspace."""
    found = zero_wrench(p)
    border: Bools = found.feasible & found.infeasible
    return border


def zero_wrench_tension(p: Problem) -> Expected:
    found = zero_wrench(p)
    value = quality.zero_wrench_tension(p.machine, p["pose"], p["rails"])
    slack = found.tension_slack * direction_gain(p)[:, None]
    slack = slack + np.where(on_the_border(p), p.machine.tension.max, 0)[:, None]
    return of_quality(p, "tension", value, p.machine.tension.min, slack, ranked=True)


def tension_factor(p: Problem) -> Expected:
    """min T0 / max T0 moves by at most twice the largest tension error over T_min."""
    value = quality.tension_factor(p.machine, p["pose"], p["rails"])
    moved = np.max(zero_wrench(p).tension_slack, axis=-1) * direction_gain(p)
    low = p.machine.tension.min
    slack = (2 * moved / low if low else 0 * moved) + on_the_border(p)
    answer = of_quality(p, "factor", value, 0.0, slack, ranked=True)
    if low == 0:
        # every zero-wrench tension is 0, and they have no ratio
        answer.allowed[:, Status.SINGULAR] = True
    return answer


def isotropic_force(p: Problem) -> Expected:
    value = quality.isotropic_force(p.machine, p["pose"], p["rails"])
    scale = len(p.machine.cables) * p.machine.tension.max
    slack = ROUNDINGS * p.epsilon * scale * direction_gain(p)
    return of_quality(p, "force", value, 0.0, slack, ranked=False)


def pose_quality(p: Problem) -> Expected:
    """The margin is as exact as the isotropic force, and the factor is 0 where all T0 are."""
    parts = tension_factor(p), isotropic_force(p)
    margin = quality.capacity_margin(p.machine, p["pose"], p["rails"])
    answer = of_quality(p, "margin", margin, 0.0, parts[1].tolerance["force"], ranked=True)
    for part in parts:
        answer.values.update(part.values)
        answer.tolerance.update(part.tolerance)
    if p.machine.tension.min == 0:
        answer.values["factor"] = np.zeros_like(margin)
    return answer


def isotropic_force_eq17(p: Problem) -> Expected:
    """Which cables are adjacent is decided by the side they lie on: where two have one direction,
    or opposite ones, up to rounding, either order is right."""
    value = quality.isotropic_force_eq17(p.machine, p["pose"], p["rails"])
    moved = np.max(zero_wrench(p).tension_slack, axis=-1)
    slack = (moved + ROUNDINGS * p.epsilon * p.machine.tension.max) * direction_gain(p)
    rays = np.swapaxes(kinematics.structure_matrix(p.machine, p["pose"], p["rails"]), -1, -2)
    aligned = np.abs(minors(rays)) <= ROUNDINGS * p.epsilon * direction_gain(p)[:, None, None]
    aligned[:, np.arange(rays.shape[1]), np.arange(rays.shape[1])] = False
    ambiguous = np.any(aligned, axis=(-2, -1)) | on_the_border(p)
    slack = slack + np.where(ambiguous, p.machine.tension.max, 0)
    return of_quality(p, "force", value, 0.0, slack, ranked=True)


JUDGES: dict[str, Judge] = {
    "base_points": base_points,
    "cable_vectors": cable_vectors,
    "cable_lengths": cable_lengths,
    "structure_matrix": structure_matrix,
    "length_jacobian": length_jacobian,
    "rail_jacobian": rail_jacobian,
    "task_velocity": task_velocity,
    "forward_kinematics": forward_kinematics,
    "locate": locate,
    "wrench": wrench,
    "rail_forces": rail_forces,
    "least_norm_tension": least_norm,
    "least_norm_tension_quick": least_norm_quick,
    "served_wrench_scale": served_wrench("scale"),
    "served_wrench_closest": served_wrench("closest"),
    "distribute_tension_scale": distribution("scale"),
    "distribute_tension_closest": distribution("closest"),
    "distribute_tension_paper": distribution("paper"),
    "zero_wrench_tension": zero_wrench_tension,
    "tension_factor": tension_factor,
    "isotropic_force": isotropic_force,
    "pose_quality": pose_quality,
    "isotropic_force_eq17": isotropic_force_eq17,
    "motor_torques": motor_torques,
    "wall_force": wall_force,
    "load_tension": load_tension,
    "base_targets": base_targets,
    "base_pid": base_pid,
}
