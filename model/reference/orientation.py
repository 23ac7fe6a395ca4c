"""Rotations of the platform: an angle in the plane, a rotation vector in space [rad]."""

import numpy as np

from turnbuckle.model.machine import Machine
from turnbuckle.model.reference.arrays import Array, norm

SMALL_ANGLE = 1e-4  # below, theta - sin theta has lost the digits that its own cube is worth


def rotation(machine: Machine, pose: Array) -> Array:
    """R (..., space, space) of a pose (..., d): what turns the platform's frame upright to it."""
    space = machine.space
    angles = pose[..., space:]
    if not machine.is_rigid:
        return np.broadcast_to(np.eye(space, dtype=pose.dtype), (*pose.shape[:-1], space, space))
    return planar_rotation(angles[..., 0]) if space == 2 else spatial_rotation(angles)


def planar_rotation(angle: Array) -> Array:
    """R (..., 2, 2) counter-clockwise by an angle (...) [rad]."""
    cosine, sine = np.cos(angle), np.sin(angle)
    return np.stack([np.stack([cosine, -sine], -1), np.stack([sine, cosine], -1)], axis=-2)


def spatial_rotation(vector: Array) -> Array:
    """R (..., 3, 3) = exp([v]x) of rotation vectors v (..., 3) [rad] (Rodrigues)."""
    turn, angle = skew(vector), norm(vector)
    sine, versine = _sine_quotient(angle), _sine_quotient(angle / 2) ** 2 / 2
    identity = np.eye(3, dtype=vector.dtype)
    return np.asarray(
        identity + sine[..., None, None] * turn + versine[..., None, None] * turn @ turn
    )


def twist_of_vector(vector: Array) -> Array:
    """(..., 3, 3): angular velocity, in the fixed frame, over the rate of the rotation vector.

    The left Jacobian of SO(3): I + (1 - cos t)/t^2 [v]x + (t - sin t)/t^3 [v]x^2, t = |v|.
    """
    turn, angle = skew(vector), norm(vector)
    versine = _sine_quotient(angle / 2) ** 2 / 2
    cube = angle**3
    large = angle > SMALL_ANGLE
    third = np.divide(angle - np.sin(angle), cube, out=np.ones_like(cube) / 6, where=large)
    identity = np.eye(3, dtype=vector.dtype)
    return np.asarray(
        identity + versine[..., None, None] * turn + third[..., None, None] * turn @ turn
    )


def skew(vector: Array) -> Array:
    """[v]x (..., 3, 3), with [v]x w = v x w."""
    x, y, z = np.moveaxis(vector, -1, 0)
    zero = np.zeros_like(x)
    rows = ([zero, -z, y], [z, zero, -x], [-y, x, zero])
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def moment(arm: Array, force: Array) -> Array:
    """arm x force (..., 1 in the plane, 3 in space) of vectors (..., space)."""
    if arm.shape[-1] == 3:
        return np.asarray(np.cross(arm, force))
    return np.asarray(arm[..., 0] * force[..., 1] - arm[..., 1] * force[..., 0])[..., None]


def _sine_quotient(angle: Array) -> Array:
    """sin(angle) / angle, 1 at zero."""
    return np.divide(np.sin(angle), angle, out=np.ones_like(angle), where=angle != 0)
