"""The methods of Brau et al. 2003 for tensions and for the largest tension, as corrected.

structure (..., d, n), wrench (..., d) [N, N m], tension (..., n) [N]. None of these knows T_max;
`largest_tension` is exact, for any kind, and the judge of the published formulas.
"""

from collections.abc import Iterator
from itertools import combinations

import numpy as np
import numpy.typing as npt

from turnbuckle.model.machine import Machine
from turnbuckle.model.reference.arrays import Array, as_floating
from turnbuckle.model.reference.bounded import ROUNDINGS
from turnbuckle.model.reference.kinematics import moment_lever
from turnbuckle.model.reference.linear import inverse, kernel, least_norm, least_squares
from turnbuckle.model.reference.planar import cross
from turnbuckle.model.reference.tension import minimum_norm_tension
from turnbuckle.model.reference.wrench_set import by_slabs, facet_directions


def kernel_tension(machine: Machine, structure: npt.ArrayLike, wrench: npt.ArrayLike) -> Array:
    """Tensions by the pseudo-inverse and the kernel of S (Brau eqs 3 to 5), no T_max.

    r = 1: as much of the kernel as brings the least tension to T_min; the kernel, whose sign is
    arbitrary, has to be positive for one of its signs (eq. 5 presumes it). r >= 2: the paper leaves
    the shares to "a quadratic algorithm", which is the least norm with T >= T_min.
    NaN where there is no such tension.
    """
    structure, wrench = _as_forces(machine, structure, wrench)
    lower = machine.tension.min
    if machine.redundancy > 1:
        found = minimum_norm_tension(structure, wrench, lower, np.inf)
        return _where(found.solved, found.tension)
    null = _upward_kernel(structure)
    cooperative = np.all(null > _rounding(structure.dtype), axis=-1)
    tension = least_norm(np.swapaxes(structure, -1, -2), wrench)
    share = np.divide(lower - tension, null, out=np.zeros_like(tension), where=null > 0)
    tension = tension + np.max(share, axis=-1, keepdims=True) * null
    return _where(cooperative, np.maximum(tension, lower))


def reduced_matrix_tension(
    machine: Machine, structure: npt.ArrayLike, wrench: npt.ArrayLike
) -> Array:
    """Tensions where d cables carry the wrench and all others T_min (Brau eqs 6, 7), no T_max.

    Of all sets of d cables with T >= T_min that of the lowest sum of tensions: the paper's "lowest
    strictly positive tensions" is ambiguous, and below T_min where T_min > 0. It solves with the
    whole columns of S where eq. (6) prints u_k in F*. NaN where no set will do.
    """
    structure, wrench = _as_forces(machine, structure, wrench)
    lower = machine.tension.min
    batch = np.broadcast_shapes(structure.shape[:-2], wrench.shape[:-1])
    best = np.full((*batch, structure.shape[-1]), np.nan, structure.dtype)
    least = np.full(batch, np.inf, structure.dtype)
    for carrying, above in _reduced_tensions(machine, structure, wrench):
        total = np.sum(above, axis=-1)
        better = total < least
        tension = np.full_like(best, lower)
        tension[..., carrying] += np.maximum(above, 0)
        np.copyto(best, tension, where=better[..., None])
        np.copyto(least, total, where=better)
    return best


def reduced_matrix_sums(machine: Machine, structure: npt.ArrayLike, wrench: npt.ArrayLike) -> Array:
    """Sum (..., k) [N] of what the tensions of every set of d cables have above T_min.

    NaN where a set will not do. Where the two least are alike, so are the sets.
    """
    structure, wrench = _as_forces(machine, structure, wrench)
    sums = [np.sum(above, axis=-1) for _, above in _reduced_tensions(machine, structure, wrench)]
    return np.stack(sums, axis=-1)


def _reduced_tensions(
    machine: Machine, structure: Array, wrench: Array
) -> Iterator[tuple[list[int], Array]]:
    """Every set of d cables, and what its tensions have above T_min; NaN where one lacks any."""
    missing = wrench - machine.tension.min * np.sum(structure, axis=-1)
    for carrying in _sets(machine):
        above = least_squares(structure[..., carrying], missing)
        slack = _rounding(above.dtype) * np.sum(np.abs(above), axis=-1)
        yield carrying, _where(np.all(above >= -slack[..., None], axis=-1), above)


def largest_tensions_eq12(machine: Machine, structure: npt.ArrayLike, force: float) -> Array:
    """Upper bound (..., n) [N] of every tension, for forces up to `force` [N] in any direction.

    Brau eq. 12 with |Delta_n| in place of Delta_n: the largest over all sets of d cables, whether
    or not a wrench is ever shared among them, so it can be far too high, and infinite where two
    cables of a set are opposite. Forces come without a moment. T_min is taken as 0 (as the paper
    does), and the pose as inside the theoretical workspace.
    """
    (structure,) = as_floating(structure)
    largest = np.zeros((*structure.shape[:-2], structure.shape[-1]), structure.dtype)
    lever = moment_lever(machine, structure.dtype)
    for carrying in _sets(machine):
        square = structure[..., carrying] / lever[:, None]
        shares = inverse(square)[..., : machine.space]
        tension = force * np.sqrt(np.sum(shares**2, axis=-1))
        tension = np.where(np.isnan(tension), np.inf, tension)
        largest[..., carrying] = np.maximum(largest[..., carrying], tension)
    return largest


def largest_tensions_eq17(machine: Machine, structure: npt.ArrayLike, force: float) -> Array:
    """Largest tension (..., n) [N] of every cable in the plane, for forces in any direction.

    Brau eqs 14 and 17 with two corrections: j runs over the two cables adjacent to cable i only,
    because no other shares a force with it (the paper's "second maximum" is not that), and where
    they are less than a right angle apart a force along cable i is the worst, t_i = F, not
    F / sin theta_ij. Infinite where the gap is half a turn or more. T_min is taken as 0. It is
    what the reduced matrices give; the least T_max has exactly the largest of it with three or
    four cables, and less with more.

    ValueError for kinds other than planar-point.
    """
    (structure,) = as_floating(structure)
    gap = _gaps(machine, structure)
    neighbours = np.maximum(gap, np.roll(gap, 1, axis=-1))
    order = np.argsort(_angles(structure), axis=-1)
    tension = np.empty_like(gap)
    np.put_along_axis(tension, order, _tension_over_gap(neighbours, force), axis=-1)
    return tension


def largest_tensions_eq18(machine: Machine, structure: npt.ArrayLike, force: float) -> Array:
    """Largest tension (..., 4) [N] of every cable of a point in space (Brau eqs 18, 19).

    The largest |u_j x u_k| F / |(u_i, u_j, u_k)| over the other cables, with the determinant's
    modulus. Infinite outside the theoretical workspace. T_min is taken as 0. ValueError for kinds
    other than spatial-point and for more than four cables.
    """
    (structure,) = as_floating(structure)
    volume, area = _tetrahedra(machine, structure)
    with np.errstate(divide="ignore", invalid="ignore"):
        tension = force * np.max(area / np.abs(volume)[..., None], axis=-2)
    inside = _surrounded(structure)
    return np.where(inside[..., None], tension, np.asarray(np.inf, tension.dtype))


def force_ratio_eq21(machine: Machine, structure: npt.ArrayLike) -> Array:
    """Largest F / T_max (...) of the tension capable workspace in the plane (Brau eq. 21).

    theta_max = pi - asin(F / T_max) is the largest gap between adjacent cables; a gap of at most a
    right angle allows F = T_max, half a turn nothing. Exact with three and four cables, T_min = 0.
    ValueError for kinds other than planar-point.
    """
    (structure,) = as_floating(structure)
    return np.asarray(1 / np.max(_tension_over_gap(_gaps(machine, structure), 1.0), axis=-1))


def force_ratio_eq23(machine: Machine, structure: npt.ArrayLike) -> Array:
    """Largest F / T_max (...) of the tension capable workspace in space (Brau eq. 23).

    |(u_i, u_j, u_k)| / |u_i x u_j|, of which the least counts; the paper prints the largest. 0
    outside the theoretical workspace. T_min is taken as 0. ValueError as for eq. 18.
    """
    return np.asarray(1 / np.max(largest_tensions_eq18(machine, structure, 1.0), axis=-1))


def largest_tension(machine: Machine, structure: npt.ArrayLike, force: float) -> Array:
    """The least T_max (...) [N] with which every force up to `force` [N] is feasible: exact.

    In every direction, without a moment. Every facet's plane has to be as far out:
    T_max P - T_min Q >= F |p_F|, where P and Q sum the positive and the negative parts of p . s_i.
    Infinite where no T_max will do. It replaces Brau eq. 20, which lacks "for all F there is a T".
    """
    (structure,) = as_floating(structure)

    def least(s: Array) -> tuple[Array]:
        normals, sides = facet_directions(machine, s)
        wanted = force * np.sqrt(np.sum(normals[..., : machine.space] ** 2, axis=-1))
        both = [_least_bound(machine, sign * sides, wanted) for sign in (1, -1)]
        return (np.maximum(*both),)

    (result,) = by_slabs(machine, least, structure)
    return np.asarray(result)


def _least_bound(machine: Machine, sides: Array, wanted: Array) -> Array:
    """The least T_max (...) with which all these planes are far enough out."""
    outwards = np.sum(np.maximum(sides, 0), axis=-1)
    inwards = machine.tension.min * np.sum(np.maximum(-sides, 0), axis=-1)
    slack = _rounding(sides.dtype)
    # nothing pulls to this side: no tension helps
    never = np.where(wanted + inwards > slack, np.inf, 0).astype(sides.dtype)
    never = np.where(np.isnan(outwards), outwards, never)
    bound = np.divide(wanted + inwards, outwards, out=never, where=outwards > slack)
    return np.asarray(np.maximum(np.max(bound, axis=-1), machine.tension.min))


def _sets(machine: Machine) -> list[list[int]]:
    """All choices of d cables."""
    return [list(chosen) for chosen in combinations(range(len(machine.cables)), machine.dof)]


def _angles(structure: Array) -> Array:
    return np.asarray(np.arctan2(structure[..., 1, :], structure[..., 0, :]))


def _gaps(machine: Machine, structure: Array) -> Array:
    """Angle (..., n) [rad] from every cable, counter-clockwise in order, to the next one."""
    if machine.is_rigid or machine.space != 2:
        raise ValueError(
            f"Brau eqs 14, 17, 21 are for planar-point; {machine.name} is {machine.kind}"
        )
    order = np.argsort(_angles(structure), axis=-1)
    cables = np.take_along_axis(np.swapaxes(structure, -1, -2), order[..., None], axis=-2)
    following = np.roll(cables, -1, axis=-2)
    gap = np.arctan2(cross(cables, following), np.sum(cables * following, axis=-1))
    pi = np.arccos(np.asarray(-1, gap.dtype))
    return np.asarray(np.where(gap < -_rounding(gap.dtype), gap + 2 * pi, gap))


def _tension_over_gap(gap: Array, force: float) -> Array:
    sine = np.sin(gap)
    pulled = np.divide(
        force, sine, out=np.full_like(gap, np.inf), where=sine > _rounding(gap.dtype)
    )
    right_angle = np.arccos(np.asarray(0, gap.dtype))
    return np.where(gap > right_angle, pulled, np.where(np.isnan(gap), gap, force))


def _tetrahedra(machine: Machine, structure: Array) -> tuple[Array, Array]:
    """(u_i, u_j, u_k) (..., 4) of the faces; |u_j x u_k| (..., 4, 4) of face and cable i, or 0."""
    if machine.is_rigid or machine.space != 3 or len(machine.cables) != 4:
        raise ValueError(
            f"Brau eqs 18, 19, 23 are for spatial-point with 4 cables;"
            f" {machine.name} is {machine.kind} with {len(machine.cables)}"
        )
    u = np.swapaxes(structure, -1, -2)
    area = np.zeros((*u.shape[:-2], 4, 4), u.dtype)
    volume = np.zeros(u.shape[:-1], u.dtype)
    for face, (i, j, k) in enumerate(combinations(range(4), 3)):
        for one, other, third in ((i, j, k), (j, k, i), (k, i, j)):
            normal = np.cross(u[..., other, :], u[..., third, :])
            area[..., face, one] = np.sqrt(np.sum(normal**2, axis=-1))
            volume[..., face] = np.sum(u[..., one, :] * normal, axis=-1)
    return volume, area


def _surrounded(structure: Array) -> npt.NDArray[np.bool_]:
    """Whether the kernel is positive for one of its signs: inside the theoretical workspace."""
    return np.asarray(np.all(_upward_kernel(structure) > _rounding(structure.dtype), axis=-1))


def _upward_kernel(structure: Array) -> Array:
    """The unit vector (..., n) that S of r = 1 sends to zero, with the sign of a positive sum."""
    null = kernel(structure)[..., 0]
    return np.asarray(null * np.sign(np.sum(null, axis=-1, keepdims=True)))


def _as_forces(
    machine: Machine, structure: npt.ArrayLike, wrench: npt.ArrayLike
) -> tuple[Array, Array]:
    """Both with moments over the lever."""
    structure, wrench = as_floating(structure, wrench)
    lever = moment_lever(machine, structure.dtype)
    return structure / lever[:, None], wrench / lever


def _rounding(dtype: np.dtype[np.floating]) -> float:
    return float(ROUNDINGS * np.finfo(dtype).eps)


def _where(usable: npt.NDArray[np.bool_], tension: Array) -> Array:
    return np.where(usable[..., None], tension, np.asarray(np.nan, tension.dtype))
