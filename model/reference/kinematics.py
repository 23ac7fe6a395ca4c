"""Kinematics with movable bases (Yoon section II-A, eqs 1 to 6, 18 to 20), for every kind.

pose (..., d): position [m], then for rigid platforms the angle or the rotation vector [rad].
rails (..., m): rail coordinates s [m]; a machine without rails does not read them. n cables.
Rates of a platform in space are twists: velocity of its centre [m/s], then angular velocity [rad/s]
in the fixed frame.
"""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from turnbuckle.model.machine import Machine
from turnbuckle.model.reference.arrays import Array, as_floating, in_chunks, unit
from turnbuckle.model.reference.bases import travels
from turnbuckle.model.reference.cable_path import Path, cable_path
from turnbuckle.model.reference.linear import least_squares
from turnbuckle.model.reference.orientation import moment, rotation, twist_of_vector
from turnbuckle.model.reference.pose_fit import Misfit, fit_pose, pose_from_points


class ForwardKinematics(NamedTuple):
    """pose (..., d) [m, rad]; residual (...) [m], the norm of the lengths the pose misses."""

    pose: Array
    residual: Array


def base_points(machine: Machine, rails: npt.ArrayLike) -> Array:
    """Base points b_i (..., n, space) [m] for the rail coordinates."""
    (rails,) = as_floating(rails)
    points = np.empty((*rails.shape[:-1], len(machine.cables), machine.space), rails.dtype)
    for i, travel in enumerate(travels(machine, rails.dtype)):
        points[..., i, :] = travel.start
        for k, direction in travel.directions:
            points[..., i, :] += rails[..., k, None] * direction
    return points


def anchor_points(machine: Machine, pose: npt.ArrayLike) -> Array:
    """Anchor points c + R p_i (..., n, space) [m]: where the platform holds the cables."""
    (pose,) = as_floating(pose)
    return pose[..., None, : machine.space] + _arms(machine, pose)


def cable_vectors(machine: Machine, pose: npt.ArrayLike, rails: npt.ArrayLike) -> Array:
    """Cable vectors l_i (..., n, space) [m], from the anchor to the base (Yoon eq. 1).

    Over a pulley of some radius: to the point where the cable leaves it; NaN inside the pulley.
    """
    pose, rails = as_floating(pose, rails)
    return _paths(machine, pose, rails)[0]


def cable_lengths(machine: Machine, pose: npt.ArrayLike, rails: npt.ArrayLike) -> Array:
    """Cable lengths (..., n) [m] (Yoon eq. 18), with the part that lies on the pulley."""
    pose, rails = as_floating(pose, rails)
    return _paths(machine, pose, rails)[1]


def structure_matrix(machine: Machine, pose: npt.ArrayLike, rails: npt.ArrayLike) -> Array:
    """Structure matrix S (..., d, n) (Yoon eqs 7, 21): column i is u_i, then (R p_i) x u_i [m].

    u_i is the unit vector of l_i. Column i is NaN where the anchor touches pulley i.
    """
    pose, rails = as_floating(pose, rails)
    directions = unit(cable_vectors(machine, pose, rails))
    if machine.is_rigid:
        moments = moment(_arms(machine, pose), directions)
        directions = np.concatenate([directions, moments], axis=-1)
    return np.swapaxes(directions, -1, -2)


def length_jacobian(machine: Machine, pose: npt.ArrayLike, rails: npt.ArrayLike) -> Array:
    """d length / d pose (..., n, d) = -S^T (Yoon eq. 3); in space per twist of the platform."""
    return np.asarray(-np.swapaxes(structure_matrix(machine, pose, rails), -1, -2))


def rail_jacobian(machine: Machine, pose: npt.ArrayLike, rails: npt.ArrayLike) -> Array:
    """d length / d rails (..., n, m): unit cable vector times rail direction (Yoon eq. 3)."""
    pose, rails = as_floating(pose, rails)
    directions = unit(cable_vectors(machine, pose, rails))
    jacobian = np.zeros((*directions.shape[:-1], len(machine.rails)), directions.dtype)
    for i, travel in enumerate(travels(machine, directions.dtype)):
        for k, direction in travel.directions:
            jacobian[..., i, k] = np.sum(directions[..., i, :] * direction, axis=-1)
    return jacobian


def task_velocity(
    machine: Machine,
    pose: npt.ArrayLike,
    rails: npt.ArrayLike,
    length_rates: npt.ArrayLike,
    rail_rates: npt.ArrayLike,
) -> Array:
    """Velocity of the platform (..., d) [m/s, rad/s] from the rates of lengths and rails [m/s].

    The least-squares solution of Yoon eq. 3 with every row divided by its cable length: Yoon's
    B^+ A (eqs 6, 20) weights the rows by length and agrees only where the rates are consistent.
    NaN where the lengths do not tell the velocity. length_rates (..., n), rail_rates (..., m).
    """
    pose, rails, length_rates, rail_rates = as_floating(pose, rails, length_rates, rail_rates)
    reel = length_rates
    if machine.rails:
        along = rail_jacobian(machine, pose, rails)
        reel = reel - np.sum(along * rail_rates[..., None, :], axis=-1)
    # in units of the lever rotations and translations count alike for the rank
    lever = moment_lever(machine, pose.dtype)
    return least_squares(length_jacobian(machine, pose, rails) / lever, reel) / lever


def forward_kinematics(
    machine: Machine,
    lengths: npt.ArrayLike,
    rails: npt.ArrayLike,
    guess: npt.ArrayLike | None = None,
) -> ForwardKinematics:
    """The pose whose cable lengths fit best: least sum of squared errors (Yoon eq. 19).

    Point platforms without pulleys of some radius need no guess: the differences of the squared
    lengths are linear in the pose and give the start. NaN where all bases lie on one line (in
    space: in one plane), because two mirrored poses then have the same lengths. All others start
    from `guess` (..., d) and find the pose next to it; ValueError without one. Damped Gauss-Newton
    in long double goes to convergence. lengths (..., n) [m].
    """
    closed_form = not machine.is_rigid and not any(machine.pulleys)
    if not closed_form and guess is None:
        raise ValueError(f"machine {machine.name} needs a guess of the pose to find it")
    start = np.zeros(machine.dof) if closed_form or guess is None else guess
    lengths, rails, start = as_floating(lengths, rails, start)

    def fit(wanted: Array, coordinates: Array, pose: Array) -> tuple[Array, Array]:
        misfit = Misfit(
            lambda x, rows: wanted[rows] - cable_lengths(machine, x, coordinates[rows]),
            lambda x, rows: _pose_jacobian(machine, x, coordinates[rows]),
        )
        if closed_form:
            pose = pose_from_points(base_points(machine, coordinates), wanted)
        size = np.max(np.abs(wanted), axis=-1)
        return fit_pose(misfit, pose, moment_lever(machine, pose.dtype), size)

    inputs = [(part.astype(np.longdouble), 1) for part in (lengths, rails, start)]
    pose, residual = in_chunks(fit, *inputs)
    return ForwardKinematics(pose.astype(lengths.dtype), residual.astype(lengths.dtype))


def rotation_jacobian(machine: Machine, pose: Array) -> Array:
    """Twist of the platform (..., d, d) over the rate of its pose (..., d)."""
    jacobian = np.zeros((*pose.shape, machine.dof), pose.dtype)
    jacobian[...] = np.eye(machine.dof, dtype=pose.dtype)
    if machine.is_rigid and machine.space == 3:
        jacobian[..., 3:, 3:] = twist_of_vector(pose[..., 3:])
    return jacobian


def moment_lever(machine: Machine, dtype: np.dtype[np.floating]) -> Array:
    """(d): 1 for every translation, the platform's lever [m] for every rotation."""
    lever = np.ones(machine.dof, dtype)
    lever[machine.space :] = machine.lever
    return lever


def _pose_jacobian(machine: Machine, pose: Array, rails: Array) -> Array:
    """d length / d pose (..., n, d); zero for a cable without a direction: its length is least."""
    rows = length_jacobian(machine, pose, rails)
    rows = np.where(np.isnan(rows), np.zeros_like(rows), rows)
    return np.asarray(rows @ rotation_jacobian(machine, pose))


def _arms(machine: Machine, pose: Array) -> Array:
    """R p_i (..., n, space) [m]."""
    anchors = np.asarray(machine.anchors, pose.dtype)
    turned = rotation(machine, pose)[..., None, :, :] * anchors[:, None, :]
    return np.asarray(np.sum(turned, axis=-1))


def _paths(machine: Machine, pose: Array, rails: Array) -> Path:
    """Vectors (..., n, space) and lengths (..., n) [m] of all cables."""
    spans = anchor_points(machine, pose) - base_points(machine, rails)
    paths = [cable_path(spans[..., i, :], pulley) for i, pulley in enumerate(machine.pulleys)]
    vectors = np.stack([path.vector for path in paths], axis=-2)
    return Path(vectors, np.stack([path.length for path in paths], axis=-1))
