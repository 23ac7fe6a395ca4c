"""Tension problems whose solution is known without a solver, and the scale of rounding in them.

For any multiplier lambda the tensions T = clip(S' lambda) satisfy the Karush-Kuhn-Tucker conditions
of min |T|, S T = W, T_min <= T <= T_max for the wrench W = S T: T is the solution, by construction.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from turnbuckle.codegen.judges.conditioning import smallest_singular_value
from turnbuckle.codegen.judges.tensions import amplification
from turnbuckle.model.machine import Machine

Array = NDArray[Any]
EPSILON = float(np.finfo(np.float64).eps)


@dataclass(frozen=True)
class KnownProblems:
    """structure (k, 2, n), wrench (k, 2) [N] and its optimal tension (k, n) [N]."""

    structure: Array
    wrench: Array
    tension: Array


def known_problems(machine: Machine, structure: Array, seed: int) -> KnownProblems:
    """One problem a structure; half of them with cables at their bounds, some at a vertex."""
    random = np.random.default_rng(seed)
    low, high = machine.tension.min, machine.tension.max
    size = high * random.choice([0.5, 1.0, 2.0, 20.0], (len(structure), 1))
    multiplier = random.standard_normal((len(structure), 2)) * size
    tension = np.clip(np.einsum("kdn,kd->kn", structure, multiplier), low, high)
    wrench = np.einsum("kdn,kn->kd", structure.astype(np.longdouble), tension)
    return KnownProblems(structure, wrench.astype(np.float64), tension)


def rounding(wrench: Array, tension: Array) -> Array:
    """What one unit in the last place of everything that adds up to the wrench makes (k) [N]."""
    size = np.hypot(wrench[:, 0], wrench[:, 1]) + np.sum(tension, axis=1)
    return np.asarray(EPSILON * size)


def conditioned(machine: Machine, structure: Array, wrench: Array, tension: Array) -> Array:
    """The same for the tensions: times the condition of the cables that are free (k) [N]."""
    bounds = machine.tension
    gain = amplification(structure, tension, bounds.min, bounds.max)
    return np.asarray(rounding(wrench, tension) * gain)


def wrench_rounding(machine: Machine, structure: Array, wrench: Array) -> Array:
    """What tensions off by one unit in the last place of T_max, all of them, exert (k) [N].

    The solver lets bounds be missed by roundings over the smallest pivot of S.
    """
    least = smallest_singular_value(np.swapaxes(structure, 1, 2))
    most = structure.shape[2] * machine.tension.max + np.hypot(wrench[:, 0], wrench[:, 1])
    return np.asarray(EPSILON * most / np.minimum(least, 1))
