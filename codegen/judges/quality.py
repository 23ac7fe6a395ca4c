"""What is expected of the measures of a pose."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from turnbuckle.codegen.judges.motion import direction_gain, touching
from turnbuckle.codegen.judges.problem import (
    GIVES_UP,
    ROUNDINGS,
    Bools,
    Expected,
    Problem,
    Wide,
    always,
    broadcast,
    statuses,
    union,
)
from turnbuckle.codegen.judges.tensions import Bounded, bounded, rank
from turnbuckle.model.reference import kinematics, quality
from turnbuckle.model.reference.planar import minors
from turnbuckle.model.symbolic.function import Status
from turnbuckle.model.symbolic.tension import UNROLLED_REDUNDANCY


def zero_wrench(p: Problem) -> Bounded:
    """The zero-wrench distribution at the pose, computed once for all functions that need it."""
    if "zero" not in p.solved:
        structure = kinematics.structure_matrix(p.machine, p["pose"], p["rails"])
        structure = np.where(np.isnan(structure), 0, structure)
        nothing = np.zeros((p.count, p.machine.dof), np.longdouble)
        p.solved["zero"] = bounded(p, structure, nothing, "closest")
    found: Bounded = p.solved["zero"]
    return found


def zero_tension(p: Problem) -> Wide:
    """T0 at the pose, computed once; NaN where there is none."""
    if "zero tension" not in p.solved:
        tension = quality.zero_wrench_tension(p.machine, p["pose"], p["rails"])
        p.solved["zero tension"] = tension
    return np.asarray(p.solved["zero tension"])


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


def on_the_border(p: Problem) -> Bools:
    """Poses that rounding may put outside the zero-wrench workspace."""
    found = zero_wrench(p)
    border: Bools = found.feasible & found.infeasible
    return border


def zero_wrench_tension(p: Problem) -> Expected:
    found = zero_wrench(p)
    value = zero_tension(p)
    slack = found.tension_slack * direction_gain(p)[:, None]
    slack = slack + np.where(on_the_border(p), p.machine.tension.max, 0)[:, None]
    return of_quality(p, "tension", value, p.machine.tension.min, slack, ranked=True)


def tension_factor(p: Problem) -> Expected:
    """min T0 / max T0 moves by at most twice the largest tension error over T_min."""
    value = quality.factor(zero_tension(p))
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
    return of_quality(p, "force", value, 0.0, slack, ranked=p.machine.dof > 2)


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


def pose_quality(p: Problem) -> Expected:
    """The margin is as exact as the isotropic force, and the factor is 0 where all T0 are."""
    parts = tension_factor(p), isotropic_force(p)
    margin = quality.capacity_margin(p.machine, p["pose"], p["rails"])
    answer = of_quality(p, "margin", margin, 0.0, parts[1].tolerance["force"], ranked=True)
    for part in parts:
        answer.values.update(part.values)
        answer.tolerance.update(part.tolerance)
    if p.machine.redundancy > UNROLLED_REDUNDANCY:
        # beyond the guesses there is no exact solve: some pose may be given up
        answer.allowed[:, Status.INACCURATE] = True
        answer = replace(answer, gives_up=GIVES_UP)
    if p.machine.tension.min == 0:
        answer.values["factor"] = np.zeros_like(margin)
    return answer


JUDGES: dict[str, Callable[[Problem], Expected]] = {
    judge.__name__: judge
    for judge in (
        zero_wrench_tension,
        tension_factor,
        isotropic_force,
        isotropic_force_eq17,
        pose_quality,
    )
}
