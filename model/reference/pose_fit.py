"""The pose whose cable lengths fit best, by damped Gauss-Newton from a start."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from turnbuckle.model.reference.arrays import Array, norm
from turnbuckle.model.reference.linear import least_squares

MOST_ITERATIONS = 100
MOST_HALVINGS = 40


#: Of poses (rows, d), for the rows of the batch with these numbers.
At = Callable[[Array, npt.NDArray[np.intp]], Array]


class Misfit(NamedTuple):
    """errors (rows, n) [m], wanted minus found length; jacobian (rows, n, d), d length / d pose."""

    errors: At
    jacobian: At


def pose_from_points(points: Array, lengths: Array) -> Array:
    """Where circles (spheres) about points (rows, n, d) [m] with radii (rows, n) [m] meet.

    2 (b_i - mean b) . c = (|b_i|^2 - l_i^2) - its mean, taken about the mean point.
    """
    centre = np.mean(points, axis=-2, keepdims=True)
    about = points - centre
    power = (np.sum(about**2, axis=-1) - lengths**2) / 2
    offset = least_squares(about, power - np.mean(power, axis=-1, keepdims=True))
    return np.asarray(centre[..., 0, :] + offset)


def fit_pose(misfit: Misfit, start: Array, lever: Array, size: Array) -> tuple[Array, Array]:
    """Pose (rows, d) and residual (rows) [m] from a start (rows, d).

    lever (d) [1, m]: makes a step of the pose a length; size (rows) [m]: what rounding counts by.
    """
    pose: Array = start.copy()
    rounding = 64 * np.finfo(pose.dtype).eps * size
    moving = np.flatnonzero(np.all(np.isfinite(pose), axis=-1))
    for _ in range(MOST_ITERATIONS):
        at = pose[moving]
        errors, jacobian = misfit.errors(at, moving), misfit.jacobian(at, moving)
        step: Array = least_squares(jacobian / lever, errors) / lever
        _damp(misfit, moving, at, step, norm(errors) + rounding[moving])
        pose[moving] += step
        moving = moving[norm(step * lever) > rounding[moving]]
        if not moving.size:
            break
    return pose, norm(misfit.errors(pose, np.arange(len(pose))))


def _damp(
    misfit: Misfit, rows: npt.NDArray[np.intp], pose: Array, step: Array, acceptable: Array
) -> None:
    """Halve steps until they do not worsen the fit by more than rounding."""
    left = np.arange(len(rows))
    for _ in range(MOST_HALVINGS):
        errors = misfit.errors(pose[left] + step[left], rows[left])
        left = left[~(norm(errors) <= acceptable[left])]
        if not left.size:
            break
        step[left] /= 2
