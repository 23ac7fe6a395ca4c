"""The control laws around the tension distribution (Yoon sections III-E and IV-D).

Laws that act sample by sample on a memory take and return it. The observer and the velocity
filter are given here as filters over a whole recording instead: an independent form to judge by.
"""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from turnbuckle.model.machine import DisturbanceObserver, Machine, RailDrive
from turnbuckle.model.reference.arrays import Array, as_floating, unit
from turnbuckle.model.reference.bases import travels
from turnbuckle.model.reference.kinematics import anchor_points, moment_lever
from turnbuckle.model.reference.linear import least_norm
from turnbuckle.model.reference.statics import wrench

INTEGRAL, MEASURED, SPEED = range(3)
EDGE_ON = 1e-12  # a plane seen along its own surface: the square of the area of its unit cell


class BasePid(NamedTuple):
    """memory (..., m, 3) [N, m, m/s] for the next cycle; force (..., m) [N] along each rail."""

    memory: Array
    force: Array


class Filter(NamedTuple):
    """Discrete transfer function: numerator and denominator in powers of 1/z, denominator[0] 1."""

    numerator: Array
    denominator: Array


def motor_torques(machine: Machine, tension: npt.ArrayLike) -> Array:
    """Motor torques r_p T (..., n) [N m] for tensions (..., n) [N] (Yoon eq. 22)."""
    (tension,) = as_floating(tension)
    return np.asarray(machine.drum.radius * tension)


def wall_force(machine: Machine, pose: npt.ArrayLike, velocity: npt.ArrayLike) -> Array:
    """Wrench (..., d) [N, N m] of all walls on the platform (Yoon eqs 26, 27).

    A wall pushes on the platform's centre along its normal, with stiffness times depth minus
    damping times normal speed; it exerts no moment. It never pulls: the paper's damper would, when
    the handle leaves quickly.
    """
    pose, velocity = as_floating(pose, velocity)
    force = np.zeros(np.broadcast_shapes(pose.shape, velocity.shape), pose.dtype)
    centre, speed = pose[..., : machine.space], velocity[..., : machine.space]
    for wall in machine.walls:
        normal = np.asarray(wall.normal, pose.dtype)
        depth = np.sum((np.asarray(wall.point, pose.dtype) - centre) * normal, axis=-1)
        push = wall.stiffness * depth - wall.damping * np.sum(speed * normal, axis=-1)
        pushing = np.where(depth > 0, np.maximum(push, 0), 0)
        force[..., : machine.space] += pushing[..., None] * normal
    return force


def base_targets(machine: Machine, pose: npt.ArrayLike) -> Array:
    """Rail coordinates (..., m) [m] that bring the bases nearest to their anchors, clamped.

    On the rails of Yoon's frame this is the orthogonal configuration (section III-B). Nearest is
    meant across the cable's heading where the file names one. A coordinate that moves several bases
    fits them all best. A base on a plane in space goes to the foot of the perpendicular; in the
    plane, where it could reach the anchor itself, it rests on its first side: second coordinate 0.
    """
    anchors = anchor_points(machine, pose)
    asked = [np.zeros(anchors.shape[:-2], anchors.dtype) for _ in machine.rails]
    weights = [np.zeros((), anchors.dtype) for _ in machine.rails]
    paths = zip(travels(machine, anchors.dtype), machine.base_motions, strict=True)
    for i, (travel, motion) in enumerate(paths):
        span = _across(anchors[..., i, :] - travel.start, motion.heading)
        directions = [_across(direction, motion.heading) for _, direction in travel.directions]
        feet = _foot(span, directions, resting=machine.space == 2)
        for (k, _), (foot, weight) in zip(travel.directions, feet, strict=True):
            asked[k], weights[k] = asked[k] + foot, weights[k] + weight
    targets = np.empty((*anchors.shape[:-2], len(machine.rails)), anchors.dtype)
    for k, rail in enumerate(machine.rails):
        targets[..., k] = np.clip(asked[k] / weights[k], 0, rail.length)
    return targets


def _across(vector: Array, heading: tuple[float, ...]) -> Array:
    """What a heading sees of vectors (..., space): the part square to it; all without one."""
    if not heading:
        return vector
    h = unit(np.asarray(heading, vector.dtype))
    return np.asarray(vector - np.sum(vector * h, axis=-1)[..., None] * h)


def _foot(span: Array, directions: list[Array], resting: bool) -> list[tuple[Array, Array]]:
    """Coordinates (...) of the point nearest to start + span as numerators and denominators."""
    along = [np.asarray(np.sum(span * direction, axis=-1)) for direction in directions]
    square = [np.asarray(np.sum(direction * direction)) for direction in directions]
    if len(along) < 2:
        return list(zip(along, square, strict=True))
    mixed = np.sum(directions[0] * directions[1])
    area = square[0] * square[1] - mixed * mixed
    if resting or area < EDGE_ON:
        return [(along[0], square[0]), (np.zeros_like(along[1]), np.ones_like(square[1]))]
    u, v = along
    return [(square[1] * u - mixed * v, area), (square[0] * v - mixed * u, area)]


def base_pid(
    machine: Machine, memory: npt.ArrayLike, target: npt.ArrayLike, measured: npt.ArrayLike
) -> BasePid:
    """One cycle of the position control of the bases (Yoon sections III-E, IV-B).

    memory (..., m, 3): integral [N], previous measured coordinate [m], filtered speed [m/s];
    target and measured (..., m) [m]. The force uses the integral of the previous cycle; the
    integral then grows unless the force is already limited and the error pushes it further.
    """
    memory, target, measured = as_floating(memory, target, measured)
    drive = _rail_drive(machine)
    period = 1 / np.asarray(machine.control.rate, memory.dtype)
    gain = _smoothing_gain(drive.derivative_corner, period)
    moved = (measured - memory[..., MEASURED]) / period
    speed = memory[..., SPEED] + gain * (moved - memory[..., SPEED])
    error = target - measured
    wanted = drive.stiffness * error + memory[..., INTEGRAL] - drive.damping * speed
    held = (np.abs(wanted) > drive.force_limit) & (wanted * error > 0)
    integral = memory[..., INTEGRAL] + np.where(held, 0, drive.integral * period * error)
    measured = np.broadcast_to(measured, speed.shape)
    following = np.stack(np.broadcast_arrays(integral, measured, speed), axis=-1)
    return BasePid(following, np.clip(wanted, -drive.force_limit, drive.force_limit))


def load_tension(
    machine: Machine,
    structure: npt.ArrayLike,
    tension: npt.ArrayLike,
    hand_force: npt.ArrayLike,
) -> Array:
    """What the cables carry (..., n) [N] when the hand exerts a wrench (..., d) [N, N m].

    The tensions nearest to the commanded ones that balance the hand, S T = -hand_force. They may
    leave the bounds: they are a load, not a command. NaN where the cables do not span.
    """
    structure, tension, hand_force = as_floating(structure, tension, hand_force)
    missing = -hand_force - wrench(machine, structure, tension)
    # in units of the lever moments and forces count alike for the rank
    lever = moment_lever(machine, structure.dtype)
    columns = np.swapaxes(structure, -1, -2) / lever
    return np.asarray(tension + least_norm(columns, missing / lever))


def observer_filters(
    machine: Machine, dtype: npt.DTypeLike = np.longdouble
) -> tuple[Filter, Filter]:
    """Q and Q / P_n (Yoon eq. 24) by the bilinear transform s = 2/h (z - 1)/(z + 1).

    Q = 1 / (tau s + 1)^2; P_n = 1 / (J s^2 + B s), from motor torque [N m] to motor angle [rad].
    """
    observer, motor = _observer(machine), machine.cable_motor
    double_rate = 2 * np.asarray(machine.control.rate, dtype)
    tau = observer.time_constant * double_rate
    falling, rising = np.asarray([1, -1], dtype), np.asarray([1, 1], dtype)
    lag = tau * falling + rising
    inertia = motor.inertia * double_rate**2 * np.polymul(falling, falling)
    damping = motor.damping * double_rate * np.polymul(falling, rising)
    denominator = np.polymul(lag, lag)
    lead = denominator[0]
    low_pass = Filter(np.polymul(rising, rising) / lead, denominator / lead)
    return low_pass, Filter((inertia + damping) / lead, denominator / lead)


def disturbance_sequence(
    machine: Machine, lengths: npt.ArrayLike, load: npt.ArrayLike, applied: npt.ArrayLike
) -> Array:
    """Estimated disturbance torques (t, ..., n) [N m] over a recording, one row per cycle.

    lengths (t, ..., n) [m]; load (t, ..., n) [N], what the cables carry; applied (t, ..., n)
    [N m], the torque that acted. d = Q P_n^-1 theta + Q (applied - r_p load), theta = length/r_p.
    Before the recording: at rest at lengths[0], applied balances load.
    """
    lengths, load, applied = as_floating(lengths, load, applied)
    low_pass, inverse_motor = observer_filters(machine, lengths.dtype)
    angle = (lengths - lengths[:1]) / machine.drum.radius
    imbalance = applied - machine.drum.radius * load
    return _run(inverse_motor, angle) + _run(low_pass, imbalance)


def velocity_sequence(machine: Machine, positions: npt.ArrayLike) -> Array:
    """Low-passed rates (t, ...) [m/s] of recorded positions (t, ...) [m], at rest before.

    The backward difference through v += a (difference - v), a = 1 - exp(-2 pi corner h).
    """
    (positions,) = as_floating(positions)
    rate = np.asarray(machine.control.rate, positions.dtype)
    gain = _smoothing_gain(machine.control.velocity_corner, 1 / rate)
    numerator = np.stack([gain * rate, -gain * rate])
    denominator = np.stack([np.ones_like(gain), gain - 1])
    return _run(Filter(numerator, denominator), positions - positions[:1])


def _run(filter_: Filter, inputs: Array) -> Array:
    """The difference equation itself, from rest, along the first axis."""
    outputs = np.zeros_like(inputs)
    for now in range(len(inputs)):
        past = range(min(now + 1, len(filter_.numerator)))
        outputs[now] = sum(filter_.numerator[k] * inputs[now - k] for k in past)
        past = range(1, min(now + 1, len(filter_.denominator)))
        outputs[now] -= sum(filter_.denominator[k] * outputs[now - k] for k in past)
    return outputs


def _smoothing_gain(corner: float, period: Array) -> Array:
    pi = np.arccos(np.asarray(-1, period.dtype))
    return np.asarray(-np.expm1(-2 * pi * corner * period))


def _observer(machine: Machine) -> DisturbanceObserver:
    if machine.disturbance_observer is None:
        raise ValueError(f"machine {machine.name} has no disturbance observer")
    return machine.disturbance_observer


def _rail_drive(machine: Machine) -> RailDrive:
    if machine.rail_drive is None:
        raise ValueError(f"machine {machine.name} has no rail drive")
    return machine.rail_drive
