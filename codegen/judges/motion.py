"""What is expected of functions of position: kinematics, and forces between the parts."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from turnbuckle.codegen.judges.conditioning import least_pivot, smallest_singular_value
from turnbuckle.codegen.judges.problem import (
    GIVES_UP,
    ROUNDINGS,
    Bools,
    Expected,
    Problem,
    Wide,
    always,
    below,
    everywhere,
    expected,
    extent,
    levers,
    statuses,
    union,
)
from turnbuckle.model.reference import kinematics, statics
from turnbuckle.model.reference.arrays import norm
from turnbuckle.model.symbolic.forward_kinematics import (
    FITTED_ROUNDINGS,
    FITTED_SHARE,
    FLATTEST,
    FLATTEST_ROUNDINGS,
    MOST_STEPS,
    needs_guess,
)
from turnbuckle.model.symbolic.function import Status
from turnbuckle.model.symbolic.kinematics import CONTACT_DISTANCE, PIVOT_ROUNDINGS, SMALLEST_PIVOT

#: A search from a guess may give up where the lengths change little with the pose.
SEARCH_DOUBT = 0.05
#: Where steps keep more than this of an error, the search may reach its last one before its end.
SLOWEST = FITTED_SHARE ** (1 / MOST_STEPS)
#: By how much the pose is moved to see how a Jacobian changes [m].
NUDGE = CONTACT_DISTANCE / 100


def clearance(p: Problem, pose: Wide) -> Wide:
    """The least distance (count) [m] without which a cable has no direction; 0 inside a pulley."""
    machine, rails = p.machine, p["rails"]
    free = norm(kinematics.cable_vectors(machine, pose, rails))
    arms = kinematics.anchor_points(machine, pose) - kinematics.base_points(machine, rails)
    for i, pulley in enumerate(machine.pulleys):
        if pulley is not None and pulley.axis:
            axis = np.asarray(pulley.axis, np.longdouble)
            aside = arms[:, i] - np.sum(arms[:, i] * axis, axis=-1)[:, None] * axis
            free[:, i] = np.minimum(free[:, i], norm(aside))
    return np.asarray(np.min(np.where(np.isnan(free), 0, free), axis=-1))


def nearest_pulley(p: Problem) -> Wide:
    """Clearance (count) [m] at the pose that is asked about."""
    return clearance(p, p["pose"])


def rim_gain(p: Problem) -> float:
    """How much the clearance of a pulley's rim loses: the root of what is left of a square."""
    radii = [pulley.radius for pulley in p.machine.pulleys if pulley is not None]
    return 1 + max(radii, default=0.0) / CONTACT_DISTANCE


def touching(p: Problem) -> tuple[Bools, Bools]:
    """Where the platform touches a pulley."""
    slack = ROUNDINGS * p.epsilon * extent(p.machine) * rim_gain(p)
    return below(nearest_pulley(p), CONTACT_DISTANCE, slack)


def direction_gain(p: Problem) -> Wide:
    """Rounding of S over that of a coordinate: one over the distance to the pulley."""
    return 1 + extent(p.machine) / np.maximum(nearest_pulley(p), CONTACT_DISTANCE / 2)


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
    """A pulley of some radius has a rim, inside of which there is no cable."""
    vectors = kinematics.cable_vectors(p.machine, p["pose"], p["rails"])
    if any(p.machine.pulleys):
        return away_from_pulleys(p, True, vectors=vectors)
    return everywhere(p, vectors=vectors)


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


def comparable(p: Problem, rows: Wide) -> Wide:
    """Rows of a length Jacobian (count, n, d) per (v, lever w), so that norms make sense."""
    return np.asarray(rows / levers(p.machine))


def task_velocity(p: Problem) -> Expected:
    """Least squares by the normal equations: loses what the pivot does, once for the answer and
    once for the rates; rounding in directions is as for the structure matrix."""
    arguments = (p["pose"], p["rails"], p["length_rates"], p["rail_rates"])
    velocity = kinematics.task_velocity(p.machine, *arguments)
    rows = comparable(p, kinematics.length_jacobian(p.machine, p["pose"], p["rails"]))
    gain = direction_gain(p)
    slack = ROUNDINGS * p.epsilon * gain * rates(p, velocity) / squared_least(p, rows)
    faults = {Status.SINGULAR: union(touching(p), flat(p, rows, ROUNDINGS * p.epsilon * gain))}
    allowed = statuses(p.count, {Status.OK: always(p.count)}, faults)
    return expected(p, {"velocity": velocity}, {"velocity": per_twist(p, slack)}, allowed)


def rates(p: Problem, velocity: Wide) -> Wide:
    """Size (count) [m/s] of all speeds."""
    moving = norm(velocity * levers(p.machine))
    return np.asarray(norm(p["length_rates"]) + norm(p["rail_rates"]) + moving)


def squared_least(p: Problem, rows: Wide) -> Wide:
    """Smallest eigenvalue (count) of rows' rows, not below what counts as singular."""
    return np.maximum(smallest_singular_value(rows) ** 2, smallest_pivot(p) / 4)


def flat(p: Problem, rows: Wide, slack: Wide) -> tuple[Bools, Bools]:
    """Where the rows (count, n, d), off by `slack`, must and may count as dependent."""
    finite = np.where(np.isfinite(rows), rows, 0)
    must, may = below(least_pivot(finite), smallest_pivot(p), np.minimum(slack, 1.0))
    return must, may | np.any(~np.isfinite(rows), axis=(-2, -1))


def per_twist(p: Problem, slack: Wide) -> Wide:
    """A tolerance for (v, lever w) as one for every entry of a twist or pose (count, d)."""
    return np.asarray(slack[:, None] / levers(p.machine))


@dataclass(frozen=True)
class Fixed:
    """Where the reference finds the platform from lengths, and how nearly the C can.

    `slack` [m] is that of (c, lever rotation); `doubtful`: where a search may end elsewhere;
    `gives_up`: where it may find nothing.
    """

    found: kinematics.ForwardKinematics
    slack: Wide
    nearest: Wide
    rows: Wide
    lost: tuple[Bools, Bools]
    doubtful: Bools
    gives_up: Bools


def fixed(p: Problem) -> Fixed:
    """Where the reference finds the platform."""
    return searched(p) if needs_guess(p.machine) else closed(p)


def closed(p: Problem) -> Fixed:
    """The closed form loses what the spread of the bases does; the step returns all but a square of
    that, and loses what the pivot of the directions does."""
    found = kinematics.forward_kinematics(p.machine, p["lengths"], p["rails"])
    points = kinematics.base_points(p.machine, p["rails"])
    arms = points - np.mean(points, axis=-2, keepdims=True)
    size, spread = np.sum(arms**2, axis=(-2, -1)), least_pivot(arms)
    limit = extent(p.machine) ** 2 * max(FLATTEST**2, FLATTEST_ROUNDINGS * p.epsilon)
    collinear = below(spread, limit, ROUNDINGS * p.epsilon * size)
    vectors = points - found.pose[:, None, :]
    distance = np.maximum(norm(vectors), CONTACT_DISTANCE / 2)
    rows = vectors / distance[..., None]
    pivot = np.maximum(least_pivot(rows), smallest_pivot(p) / 2)
    reach = np.sqrt(size) + np.max(p["lengths"], axis=-1)
    least = np.minimum(spread, smallest_singular_value(arms) ** 2)
    closed_form = ROUNDINGS * p.epsilon * reach * size / np.maximum(least, limit / 2)
    nearest = np.min(distance, axis=-1)
    pivot = np.minimum(pivot, squared_least(p, rows))
    second_order = closed_form**2 / np.minimum(nearest, 1) / pivot
    slack = np.minimum(closed_form, second_order + ROUNDINGS * p.epsilon * reach / pivot)
    at_pulley = at_a_pulley(np.min(norm(vectors), axis=-1), closed_form, slack)
    nowhere = np.any(np.isnan(found.pose), axis=-1)
    lost = union(collinear, at_pulley, (nowhere, nowhere))
    never = ~always(p.count)
    return Fixed(found, np.asarray(slack), nearest, rows, lost, never, never)


def at_a_pulley(distance: Wide, start: Wide, slack: Wide) -> tuple[Bools, Bools]:
    """Where the platform must and may count as at a pulley, by its start or by its pose."""
    return distance < CONTACT_DISTANCE - slack, distance < CONTACT_DISTANCE + start


def searched(p: Problem) -> Fixed:
    """A search ends when a step changes the lengths by rounding, or by a share of the residual; a
    step keeps a share of the error, `kept`, which grows with the residual."""
    found = kinematics.forward_kinematics(p.machine, p["lengths"], p["rails"], p["guess"])
    rows = comparable(p, kinematics.length_jacobian(p.machine, found.pose, p["rails"]))
    finite = np.where(np.isfinite(rows), rows, 0)
    nearest = clearance(p, found.pose)
    touched = below(nearest, CONTACT_DISTANCE, ROUNDINGS * p.epsilon * extent(p.machine))
    least, kept = np.sqrt(squared_least(p, finite)), contraction(p, found.pose)
    # from a guess on another side of a pulley, or where cables hardly tell the pose, it may fail
    off = norm((p["guess"] - found.pose) * levers(p.machine))
    elsewhere = (nearest < 2 * off) | wound_otherwise(p, found.pose)
    hardly = (least < SEARCH_DOUBT) | (kept > SLOWEST) | ~np.isfinite(norm(found.pose))
    doubtful = elsewhere | hardly
    lost = union(touched, (np.zeros(p.count, bool), doubtful))
    gives_up = doubtful | outside_target(p, found.pose)
    room = np.maximum(nearest, CONTACT_DISTANCE / 2)
    slack = search_slack(p, found.residual, least, kept)
    return Fixed(found, slack, room, rows, lost, doubtful, gives_up)


def wound_otherwise(p: Problem, pose: Wide) -> Bools:
    """Where a cable lies on its pulley half a turn more at the guess than at the pose, or less.

    Its length jumps by a whole turn where the angle of wrap ends, which no step foresees.
    """
    radii = np.array([pulley.radius if pulley else 0.0 for pulley in p.machine.pulleys])
    change = np.abs(wraps(p, p["guess"]) - wraps(p, pose))
    return np.asarray(~np.all((change <= np.pi * radii) | (radii == 0), axis=-1))


def wraps(p: Problem, pose: Wide) -> Wide:
    """What lies on the pulleys (count, n) [m]."""
    free = norm(kinematics.cable_vectors(p.machine, pose, p["rails"]))
    return np.asarray(kinematics.cable_lengths(p.machine, pose, p["rails"]) - free)


def search_slack(p: Problem, residual: Wide, least: Wide, kept: Wide) -> Wide:
    """What rounding and the last step leave of (c, lever rotation) (count) [m].

    As e becomes M e, a step of (1 - M) e leaves at most kept / (1 - kept) of itself. Beyond SLOWEST
    the judge expects nothing.
    """
    kept = np.minimum(kept, SLOWEST)
    rounding = (FITTED_ROUNDINGS + ROUNDINGS) * p.epsilon * np.sum(p.machine.frame.size) / least**2
    last = FITTED_SHARE * residual / least
    return np.asarray((rounding + kept * last) / (1 - kept))


def contraction(p: Problem, pose: Wide) -> Wide:
    """The share (count) of a small error of the pose that a Gauss-Newton step keeps.

    It leaves out how the Jacobian J turns: error e becomes (J'J)^-1 (sum of misfit_i l_i'') e.
    """
    rows, bent = pose_jacobian(p, pose), curvature(p, pose)
    known = np.isfinite(norm(norm(bent)) + norm(norm(rows)))[:, None, None]
    inverse = np.linalg.pinv(np.where(known, rows, 0).astype(float))
    kept = inverse @ np.swapaxes(inverse, -1, -2) @ np.where(known, bent, 0).astype(float)
    return np.asarray(np.max(np.abs(np.linalg.eigvals(kept)), axis=-1), np.longdouble)


def curvature(p: Problem, pose: Wide) -> Wide:
    """Sum of misfit_i l_i'' (count, d, d): J' misfit at the pose moved both ways, misfit kept."""
    misfit = p["lengths"] - kinematics.cable_lengths(p.machine, pose, p["rails"])
    columns = []
    for nudge in NUDGE * np.diag(1 / levers(p.machine)):
        turned = pose_jacobian(p, pose + nudge) - pose_jacobian(p, pose - nudge)
        columns.append(np.sum(turned * misfit[..., None], axis=-2) / (2 * np.max(nudge)))
    return np.stack(columns, axis=-1)


def pose_jacobian(p: Problem, pose: Wide) -> Wide:
    """How lengths change with the entries of the pose (count, n, d)."""
    rows = kinematics.length_jacobian(p.machine, pose, p["rails"])
    return np.asarray(rows @ kinematics.rotation_jacobian(p.machine, pose))


def outside_target(p: Problem, pose: Wide) -> Bools:
    """Where the platform is beyond what the machine is made for (count)."""
    target, space = p.machine.target, p.machine.space
    off = np.abs(pose[:, :space] - np.asarray(target.centre))
    away = np.any(off > np.asarray(target.size) / 2, axis=-1)
    turned = norm(pose[:, space:]) > target.rotation
    return np.asarray(away | turned)


def fix_faults(
    p: Problem, at: Fixed, lost: tuple[Bools, Bools]
) -> dict[Status, tuple[Bools, Bools]]:
    """Faults of functions that find the platform; none must be where a search may end elsewhere."""
    must, may = lost
    faults = {Status.SINGULAR: (must & ~at.doubtful, may)}
    if needs_guess(p.machine):
        faults[Status.INACCURATE] = (~always(p.count), at.gives_up)
    return faults


def forward_kinematics(p: Problem) -> Expected:
    """Judges tb_forward_kinematics."""
    at = fixed(p)
    lost = union(at.lost, flat(p, at.rows, at.slack)) if needs_guess(p.machine) else at.lost
    faults = fix_faults(p, at, lost)
    allowed = statuses(p.count, {Status.OK: always(p.count)}, faults)
    slack = np.where(at.doubtful, np.inf, at.slack)
    values = {"pose": at.found.pose, "residual": at.found.residual}
    tolerance: dict[str, Wide | float] = {"pose": per_twist(p, slack), "residual": 2 * slack}
    return replace(expected(p, values, tolerance, allowed), gives_up=GIVES_UP)


def locate(p: Problem) -> Expected:
    """As forward_kinematics; a pose that is off turns the directions, the more the nearer."""
    at = fixed(p)
    pose = at.found.pose
    velocity = kinematics.task_velocity(
        p.machine, pose, p["rails"], p["length_rates"], p["rail_rates"]
    )
    turn = (at.slack + ROUNDINGS * p.epsilon * extent(p.machine)) * arm_share(p) / at.nearest
    off = np.where(at.doubtful, np.inf, ROUNDINGS * p.epsilon + turn)
    drift = off * rates(p, velocity) / squared_least(p, np.where(np.isfinite(at.rows), at.rows, 0))
    drift = np.where(at.doubtful, np.inf, drift)
    slack = np.where(at.doubtful, np.inf, at.slack)
    values = {
        "pose": pose,
        "residual": at.found.residual,
        "structure": kinematics.structure_matrix(p.machine, pose, p["rails"]),
        "velocity": velocity,
    }
    tolerance: dict[str, Wide | float] = {
        "pose": per_twist(p, slack),
        "residual": 2 * slack,
        "structure": np.where(at.doubtful, np.inf, turn + slack * arm_share(p)),
        "velocity": per_twist(p, drift),
    }
    faults = fix_faults(p, at, union(at.lost, flat(p, at.rows, off)))
    allowed = statuses(p.count, {Status.OK: always(p.count)}, faults)
    answer = expected(p, values, tolerance, allowed)
    return replace(answer, beside_header=False, gives_up=GIVES_UP)


def arm_share(p: Problem) -> float:
    """How much farther an anchor moves than (c, lever rotation)."""
    if not p.machine.is_rigid:
        return 1.0
    longest = max(float(np.linalg.norm(anchor)) for anchor in p.machine.anchors)
    return 1 + longest / p.machine.lever


def wrench(p: Problem) -> Expected:
    return everywhere(p, wrench=statics.wrench(p.machine, p["structure"], p["tension"]))


def wrench_share_eq10(p: Problem) -> Expected:
    """Weighted by the lengths, the normal equations lose the square of what the lengths differ."""
    share = statics.wrench_share_eq10(p.machine, p["pose"], p["rails"], p["wrench"])
    rows = comparable(p, kinematics.length_jacobian(p.machine, p["pose"], p["rails"]))
    finite = np.where(np.isfinite(rows), rows, 0)
    free = norm(kinematics.cable_vectors(p.machine, p["pose"], p["rails"]))
    free = np.where(np.isnan(free), 0, free)
    weighted = smallest_singular_value(finite * free[..., None])
    longest = np.max(free, axis=-1)
    floor = np.sqrt(squared_least(p, finite)) * np.min(free, axis=-1)
    condition = (longest / np.maximum(np.maximum(weighted, floor), 1e-30)) ** 2
    size = norm(p["wrench"] / levers(p.machine)) + norm(np.where(np.isnan(share), 0, share))
    gain = direction_gain(p)
    slack = ROUNDINGS * p.epsilon * gain * condition * size
    faults = {Status.SINGULAR: union(touching(p), flat(p, rows, ROUNDINGS * p.epsilon * gain))}
    allowed = statuses(p.count, {Status.OK: always(p.count)}, faults)
    return expected(p, {"share": share}, {"share": slack}, allowed)


JUDGES: dict[str, Callable[[Problem], Expected]] = {
    judge.__name__: judge
    for judge in (
        base_points,
        cable_vectors,
        cable_lengths,
        structure_matrix,
        length_jacobian,
        rail_jacobian,
        task_velocity,
        forward_kinematics,
        locate,
        wrench,
        wrench_share_eq10,
        rail_forces,
    )
}
