"""Bounded tensions of least error and of least norm, by primal active sets, for any d and n.

Least error: bounded-variable least squares (Stark and Parker 1995). Least norm: from there along
the kernel of S, within the bounds, as in Nocedal and Wright 2006, algorithm 16.3: the free cables
span what all cables span at every step, so the multipliers are unique.

Everything is done in long double, for all rows of the batch at once: structure (rows, d, n),
wrench (rows, d), tension (rows, n). `upper` may be infinite.
"""

from typing import NamedTuple, Protocol

import numpy as np
import numpy.typing as npt

from turnbuckle.model.reference.arrays import Array, norm
from turnbuckle.model.reference.linear import factorise, pseudo_solution

ROUNDINGS = 32  # what a sum over the cables may be off by, in units in its last place
# A search that takes longer than this a cable releases the first of several candidates, which
# cannot cycle; twice that is the end.
STEPS_PER_CABLE = 8

Mask = npt.NDArray[np.bool_]


def closest_tension(structure: Array, wrench: Array, lower: float, upper: float) -> Array:
    """Bounded tensions whose wrench S T is nearest to the wanted one; NaN for NaN input."""
    search = _Search(structure, wrench, lower, upper)
    search.run(_Error())
    return search.tension.astype(wrench.dtype)


def least_norm(
    structure: Array, wrench: Array, lower: float, upper: float
) -> tuple[Array, npt.NDArray[np.bool_]]:
    """Tensions (rows, n) of least norm and whether they give the wrench, up to its own rounding.

    Where none do: those of the least error, and of least norm among these.
    """
    search = _Search(structure, wrench, lower, upper)
    search.run(_Error())
    search.free[...] = True
    search.run(_Size())
    missed = norm(wrench - np.sum(structure * search.tension[:, None, :], axis=-1))
    size = np.sum(search.tension, axis=-1) + np.sum(np.abs(wrench), axis=-1)
    solved = missed <= ROUNDINGS * np.finfo(wrench.dtype).eps * size
    return search.tension.astype(wrench.dtype), np.asarray(solved)


class _State(NamedTuple):
    """Of some rows: structure (rows, d, n), wrench (rows, d), tension and free (rows, n)."""

    structure: Array
    wrench: Array
    tension: Array
    free: Mask

    @property
    def free_structure(self) -> Array:
        """S without the cables that are held at a bound."""
        return self.structure * self.free[:, None, :]


class _Objective(Protocol):
    """What a search makes least."""

    def step(self, at: _State) -> Array:
        """From the tensions to the best ones (rows, n), if the held cables stay and none is hit."""

    def slope(self, at: _State) -> tuple[Array, Array]:
        """How fast it falls as a tension grows (rows, n), and what of that may be rounding."""


class _Error:
    """Half the square of |S T - W|."""

    def step(self, at: _State) -> Array:
        return pseudo_solution(at.free_structure, _missing(at))

    def slope(self, at: _State) -> tuple[Array, Array]:
        """With the part of a cable that the free ones do not span: the rest of the error is noise.

        Nearly parallel cables would drown in it.
        """
        columns = norm(np.swapaxes(at.structure, -1, -2))
        size = norm(at.wrench) + np.sum(columns * np.abs(at.tension), axis=-1)
        q = factorise(at.free_structure).q
        beside = at.structure - q @ (np.swapaxes(q, -1, -2) @ at.structure)
        missing = _missing(at)
        slope = np.sum(beside * missing[..., None], axis=-2)
        noise = norm(np.swapaxes(beside, -1, -2)) * size[:, None]
        return slope, _roundings(noise + columns * norm(missing)[:, None])


class _Size:
    """Half the square of |T|, while S T stays what it is."""

    def step(self, at: _State) -> Array:
        q = factorise(np.swapaxes(at.free_structure, -1, -2)).q
        tension = at.tension * at.free
        along = np.sum(q * tension[..., None], axis=-2)
        return np.asarray(np.sum(q * along[:, None, :], axis=-1) - tension)

    def slope(self, at: _State) -> tuple[Array, Array]:
        """s_i . multiplier - T_i, which is zero for the free cables but for rounding."""
        rows = np.swapaxes(at.free_structure, -1, -2)
        multiplier = pseudo_solution(rows, at.tension * at.free)
        shares = at.structure * multiplier[..., None]
        slope = np.sum(shares, axis=-2) - at.tension
        size = np.sum(np.abs(shares), axis=-2) + np.abs(at.tension)
        left = np.max(np.abs(slope) * at.free, axis=-1, keepdims=True)
        return slope, _roundings(size) + ROUNDINGS * left


def _missing(at: _State) -> Array:
    return np.asarray(at.wrench - np.sum(at.structure * at.tension[:, None, :], axis=-1))


def _roundings(size: Array) -> Array:
    return np.asarray(ROUNDINGS * np.finfo(size.dtype).eps * size)


class _Search:
    """A search for the best tensions of every row, among those within bounds."""

    def __init__(self, structure: Array, wrench: Array, lower: float, upper: float) -> None:
        self.structure = structure.astype(np.longdouble)
        self.wrench = wrench.astype(np.longdouble)
        self.lower, self.upper = np.longdouble(lower), np.longdouble(upper)
        start = (lower + upper) / 2 if np.isfinite(upper) else lower
        self.tension = np.full((len(wrench), structure.shape[-1]), start, np.longdouble)
        self.free = np.ones(self.tension.shape, bool)
        self.refused = np.zeros(self.tension.shape, bool)
        self.released = np.full(len(wrench), -1)
        self.finite = np.isfinite(np.sum(structure, axis=(-2, -1)) + np.sum(wrench, axis=-1))
        self.tension[~self.finite] = np.nan

    def run(self, objective: _Objective) -> None:
        """Go on until no cable can move, nor be released from a bound, to any advantage.

        ArithmeticError where that does not come to an end.
        """
        rows = np.flatnonzero(self.finite)
        self.refused[...] = False
        usual = STEPS_PER_CABLE * self.tension.shape[-1]
        for count in range(2 * usual):
            through = self._move(rows, objective.step(self._state(rows)))
            arrived = rows[through]
            slope, rounding = objective.slope(self._state(arrived))
            wanted = self._to_release(arrived, slope, rounding)
            pick = np.argmax(wanted * np.abs(slope) if count < usual else wanted, axis=-1)
            waiting = np.any(wanted, axis=-1)
            self.free[arrived[waiting], pick[waiting]] = True
            self.released[arrived[waiting]] = pick[waiting]
            rows = np.concatenate([rows[~through], arrived[waiting]])
            if not rows.size:
                return
        raise ArithmeticError(f"no end of the active-set search for {rows.size} tensions")

    def _state(self, rows: npt.NDArray[np.intp]) -> _State:
        return _State(self.structure[rows], self.wrench[rows], self.tension[rows], self.free[rows])

    def _move(self, rows: npt.NDArray[np.intp], step: Array) -> Mask:
        """Take the step up to the first bound and hold that cable there; whether it got through."""
        tension = self.tension[rows]
        noise = ROUNDINGS * np.finfo(tension.dtype).eps * np.max(np.abs(tension), axis=-1)
        step = np.where(np.abs(step) > noise[:, None], step, 0)
        bound = np.where(step > 0, self.upper, self.lower)
        share = np.divide(bound - tension, step, out=np.full_like(step, np.inf), where=step != 0)
        first = np.argmin(share, axis=-1)
        fraction = np.take_along_axis(share, first[:, None], axis=-1)
        blocked = np.flatnonzero(fraction[:, 0] < 1)
        self.tension[rows] = tension + np.minimum(fraction, 1) * step
        self.tension[rows[blocked], first[blocked]] = bound[blocked, first[blocked]]
        self.free[rows[blocked], first[blocked]] = False
        self.tension[rows] = np.clip(self.tension[rows], self.lower, self.upper)
        stays = np.all(np.abs(self.tension[rows] - tension) <= noise[:, None], axis=-1)
        self._refuse(rows, stays, first)
        return np.asarray(fraction[:, 0] >= 1)

    def _refuse(self, rows: npt.NDArray[np.intp], stays: Mask, held: npt.NDArray[np.intp]) -> None:
        """A cable that is held again before anything has moved was released by rounding alone.

        It is not released again until something moves (Lawson and Hanson 1974, chapter 23).
        """
        back = stays & (held == self.released[rows]) & ~self.free[rows, held]
        self.refused[rows[~stays]] = False
        self.refused[rows[back], held[back]] = True

    def _to_release(self, rows: npt.NDArray[np.intp], slope: Array, rounding: Array) -> Mask:
        tension, held = self.tension[rows], ~self.free[rows]
        rise = (tension <= self.lower) & (slope > rounding)
        fall = (tension >= self.upper) & (slope < -rounding)
        return np.asarray(held & ~self.refused[rows] & (rise | fall))
