"""What is expected of the control laws."""

import numpy as np

from turnbuckle.codegen.judges.conditioning import least_pivot, smallest_singular_value
from turnbuckle.codegen.judges.motion import smallest_pivot
from turnbuckle.codegen.judges.problem import (
    ROUNDINGS,
    Expected,
    Judge,
    Problem,
    always,
    below,
    everywhere,
    expected,
    extent,
    levers,
    statuses,
)
from turnbuckle.model.reference import control
from turnbuckle.model.reference.arrays import norm
from turnbuckle.model.symbolic.function import Status


def motor_torques(p: Problem) -> Expected:
    return everywhere(p, torque=control.motor_torques(p.machine, p["tension"]))


def wall_force(p: Problem) -> Expected:
    """The damper sets in at once at the surface: within rounding of it, either side is right."""
    force = control.wall_force(p.machine, p["pose"], p["velocity"])
    slack = np.full(p.count, 4 * p.epsilon * float(np.max(np.abs(force), initial=0)), np.longdouble)
    for wall in p.machine.walls:
        normal = np.asarray(wall.normal, np.longdouble)
        position = p["pose"][:, : p.machine.space]
        depth = np.sum((np.asarray(wall.point, np.longdouble) - position) * normal, axis=-1)
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
    rows = np.swapaxes(p["structure"] / levers(p.machine)[:, None], -1, -2)
    least = smallest_singular_value(rows) ** 2
    lost = below(least_pivot(rows), smallest_pivot(p), ROUNDINGS * p.epsilon)
    hand = norm(p["hand_force"] / levers(p.machine))
    forces = hand + np.sum(np.abs(p["tension"]), axis=-1) + norm(load)
    slack = ROUNDINGS * p.epsilon * forces / np.maximum(least, smallest_pivot(p) / 4)
    allowed = statuses(p.count, {Status.OK: always(p.count)}, {Status.SINGULAR: lost})
    return expected(p, {"load": load}, {"load": slack}, allowed)


JUDGES: dict[str, Judge] = {
    judge.__name__: judge
    for judge in (motor_torques, wall_force, load_tension, base_targets, base_pid)
}
