"""Kinematics of a point platform with movable bases (Yoon section II-A, eqs 1 to 6, 18 to 20).

pose (..., 2) [m], rails (..., m) [m along each rail from its start]. A machine without rails does
not read `rails`. n cables, m rails. Rail coordinate k moves the cables
`machine.rails[k].cables`.
"""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from model.base import RailBase
from model.machine import Machine
from model.reference.planar import Array, as_floating, in_chunks, least_squares, norm

MOST_ITERATIONS = 100
MOST_HALVINGS = 40


class ForwardKinematics(NamedTuple):
    """pose (..., 2) [m]; residual (...) [m], the norm of l_i - |b_i - c|."""

    pose: Array
    residual: Array


def base_points(machine: Machine, rails: npt.ArrayLike) -> Array:
    """Pulley points b_i (..., n, 2) [m] for the rail coordinates."""
    (coordinates,) = as_floating(rails)
    batch = coordinates.shape[:-1]
    points = np.empty((*batch, len(machine.cables), 2), coordinates.dtype)
    for i, cable in enumerate(machine.cables):
        if isinstance(cable.base, RailBase):
            start, along, _ = rail_line(cable.base, coordinates.dtype)
            coordinate = coordinates[..., machine.base_motions[i].travel[0][0]]
            points[..., i, :] = start + coordinate[..., None] * along
        else:
            points[..., i, :] = machine.base_motions[i].start
    return points


def cable_vectors(machine: Machine, pose: npt.ArrayLike, rails: npt.ArrayLike) -> Array:
    """Cable vectors l_i = b_i - c (..., n, 2) [m], from the platform to its base (Yoon eq. 1)."""
    pose, rails = as_floating(pose, rails)
    return np.asarray(base_points(machine, rails) - pose[..., None, :])


def cable_lengths(machine: Machine, pose: npt.ArrayLike, rails: npt.ArrayLike) -> Array:
    """Cable lengths |l_i| (..., n) [m] (Yoon eq. 18)."""
    return norm(cable_vectors(machine, pose, rails))


def structure_matrix(machine: Machine, pose: npt.ArrayLike, rails: npt.ArrayLike) -> Array:
    """Structure matrix S (..., 2, n): column i is the unit vector of l_i (Yoon eqs 7, 21).

    Column i is NaN where the platform touches pulley i.
    """
    return np.swapaxes(_directions(cable_vectors(machine, pose, rails)), -1, -2)


def length_jacobian(machine: Machine, pose: npt.ArrayLike, rails: npt.ArrayLike) -> Array:
    """d length / d pose (..., n, 2) = -S^T (Yoon eq. 3)."""
    return np.asarray(-np.swapaxes(structure_matrix(machine, pose, rails), -1, -2))


def rail_jacobian(machine: Machine, pose: npt.ArrayLike, rails: npt.ArrayLike) -> Array:
    """d length / d rails (..., n, m): unit cable vector times rail direction (Yoon eq. 3)."""
    directions = _directions(cable_vectors(machine, pose, rails))
    jacobian = np.zeros((*directions.shape[:-1], len(machine.rails)), directions.dtype)
    for k, (i, rail) in enumerate(rails_of(machine)):
        _, along, _ = rail_line(rail, directions.dtype)
        jacobian[..., i, k] = np.sum(directions[..., i, :] * along, axis=-1)
    return jacobian


def task_velocity(
    machine: Machine,
    pose: npt.ArrayLike,
    rails: npt.ArrayLike,
    length_rates: npt.ArrayLike,
    rail_rates: npt.ArrayLike,
) -> Array:
    """Velocity of the platform (..., 2) [m/s] from length rates (..., n) and rail rates (..., m).

    The least-squares solution of Yoon eq. 3 with every row divided by its cable length: Yoon's
    B^+ A (eqs 6, 20) weights the rows by length and agrees only where the rates are consistent.
    """
    pose, rails, length_rates, rail_rates = as_floating(pose, rails, length_rates, rail_rates)
    reel = length_rates
    if machine.rails:
        along = rail_jacobian(machine, pose, rails)
        reel = reel - np.sum(along * rail_rates[..., None, :], axis=-1)
    return least_squares(length_jacobian(machine, pose, rails), reel)


def forward_kinematics(
    machine: Machine, lengths: npt.ArrayLike, rails: npt.ArrayLike
) -> ForwardKinematics:
    """The pose whose cable lengths fit best: least sum of (l_i - |b_i - c|)^2 (Yoon eq. 19).

    The differences of the squared lengths are linear in the pose and give the start; damped
    Gauss-Newton in long double goes to convergence. NaN where all bases lie on one line, because
    two mirrored poses then have the same lengths.
    """
    lengths, rails = as_floating(lengths, rails)
    wide = lengths.astype(np.longdouble)
    points = base_points(machine, rails.astype(np.longdouble))
    pose, residual = in_chunks(_fit_pose, (points, 2), (wide, 1))
    return ForwardKinematics(pose.astype(lengths.dtype), residual.astype(lengths.dtype))


def rails_of(machine: Machine) -> list[tuple[int, RailBase]]:
    """Index of the cable and rail, in the order of the rail coordinates."""
    bases = ((i, cable.base) for i, cable in enumerate(machine.cables))
    return [(i, base) for i, base in bases if isinstance(base, RailBase)]


def rail_line(base: RailBase, dtype: np.dtype[np.floating]) -> tuple[Array, Array, Array]:
    """Start point (2) [m], unit direction (2) and length () [m] of a rail, in the given type."""
    start = np.asarray(base.start, dtype)
    span = np.asarray(base.end, dtype) - start
    length = norm(span)
    return start, np.asarray(span / length), length


def _directions(vectors: Array) -> Array:
    with np.errstate(invalid="ignore"):
        return np.asarray(vectors / norm(vectors)[..., None])


def _fit_pose(points: Array, lengths: Array) -> tuple[Array, Array]:
    pose = _intersect_circles(points, lengths)
    rounding = 64 * np.finfo(pose.dtype).eps * np.max(np.abs(lengths), axis=-1)
    moving = np.flatnonzero(np.isfinite(pose[:, 0]))
    for _ in range(MOST_ITERATIONS):
        step = _gauss_newton_step(points[moving], lengths[moving], pose[moving])
        step = _damped(points[moving], lengths[moving], pose[moving], step, rounding[moving])
        pose[moving] += step
        moving = moving[norm(step) > rounding[moving]]
        if not moving.size:
            break
    return pose, norm(_length_errors(points, lengths, pose))


def _intersect_circles(points: Array, lengths: Array) -> Array:
    """2 (b_i - mean b) . c = (|b_i|^2 - l_i^2) - its mean, taken about the mean base."""
    centre = np.mean(points, axis=-2, keepdims=True)
    about = points - centre
    power = (np.sum(about**2, axis=-1) - lengths**2) / 2
    offset = least_squares(about, power - np.mean(power, axis=-1, keepdims=True))
    return np.asarray(centre[..., 0, :] + offset)


def _length_errors(points: Array, lengths: Array, pose: Array) -> Array:
    return np.asarray(lengths - norm(points - pose[..., None, :]))


def _gauss_newton_step(points: Array, lengths: Array, pose: Array) -> Array:
    vectors = points - pose[..., None, :]
    distance = norm(vectors)[..., None]
    rows = np.divide(vectors, distance, out=np.zeros_like(vectors), where=distance > 0)
    return least_squares(rows, -_length_errors(points, lengths, pose))


def _damped(points: Array, lengths: Array, pose: Array, step: Array, rounding: Array) -> Array:
    """The step, halved until it does not worsen the fit by more than rounding."""
    acceptable = norm(_length_errors(points, lengths, pose)) + rounding
    for _ in range(MOST_HALVINGS):
        worse = norm(_length_errors(points, lengths, pose + step)) > acceptable
        if not np.any(worse):
            break
        step = np.where(worse[:, None], step / 2, step)
    return step
