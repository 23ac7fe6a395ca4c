"""The best machine within the ranges: from the file's own values, and from anywhere.

The merit of a machine is that of its worst pose, so it has kinks where another pose becomes the
worst, and a search by its slope alone gets stuck there. Linear programming in a trust region looks
at all poses at once instead. Differential evolution looks elsewhere.
"""

from collections.abc import Callable
from functools import partial

import numpy as np
import numpy.typing as npt
from scipy.optimize import Bounds, OptimizeResult, differential_evolution, minimize

from turnbuckle.lab.design import DesignError
from turnbuckle.lab.design.design import Design, Outcome, Values
from turnbuckle.model.problem import MachineError
from turnbuckle.model.workspace.maximin import climb
from turnbuckle.model.workspace.rows import Array

Shares = npt.NDArray[np.float64]
"""A place in the search: for every range the share of it, from 0 to 1."""
Tell = Callable[[str, float], None]
"""Told what is being done and the share that is done."""

REFUSED = -1e12
"""Merit of a machine that there is not; below that of all that there are."""
DIFFERENCE = 1e-6
"""Step of a one-sided difference, a share of the range: half the digits of a double are right."""
TRUST = 0.1
"""Length of the first steps, as a share of every range."""
POPULATION, GENERATIONS = 10, 40
POLISH_PER_RANGE = 100
POLISH_SIZE = 0.02


class Trials:
    """The machines tried, each once, and the best of them."""

    def __init__(self, design: Design) -> None:
        self.design = design
        self.outcomes: dict[Values, Outcome] = {}
        self.models = 0

    @property
    def count(self) -> int:
        """How many machines were looked at."""
        return len(self.outcomes) + self.models

    @property
    def best(self) -> Outcome:
        """The best machine; the first of equals."""
        return max(self.outcomes.values(), key=merit)

    @property
    def best_place(self) -> Shares:
        """Where the best machine is."""
        return self.place(self.best.values)

    def place(self, values: Values) -> Shares:
        """The place of these values, or the nearest in the ranges."""
        pairs = zip(self.design.ranges, values, strict=True)
        return np.clip([one.share(value) for one, value in pairs], 0.0, 1.0)

    def merit(self, place: Shares) -> float:
        """Merit of the machine whose values, in few digits, are nearest."""
        pairs = zip(self.design.ranges, self._values(place), strict=True)
        values = tuple(one.rounded(value) for one, value in pairs)
        if values not in self.outcomes:
            self.outcomes[values] = self.design.outcome(values)
        return merit(self.outcomes[values])

    def merits(self, place: Shares) -> Array:
        """Merit at every pose, exactly here; REFUSED alone where there is no such machine."""
        self.models += 1
        try:
            return self.design.merits(self._values(np.clip(place, 0.0, 1.0)))
        except MachineError:
            return np.array([REFUSED])

    def cost(self, place: Shares) -> float:
        """What minimisers minimise."""
        return -self.merit(place)

    def _values(self, place: Shares) -> Values:
        pairs = zip(self.design.ranges, place.tolist(), strict=True)
        return tuple(one.value(share) for one, share in pairs)


def merit(outcome: Outcome) -> float:
    """Merit of an outcome, whatever became of it."""
    return outcome.score.merit if outcome.score else REFUSED


def search(design: Design, method: str, seed: int, tell: Tell) -> Trials:
    """Try machines; DesignError where there is none at all in the ranges.

    The same design, method and seed try the same machines.
    """
    trials = Trials(design)
    tell("searching near the file's values", 0.0)
    present = tuple(design.document.quantity(one.location).number for one in design.ranges)
    local_search(trials, trials.place(present))
    if method == "global" and design.ranges:
        global_search(trials, seed, tell)
        tell("searching near the best", 1.0)
        local_search(trials, trials.best_place)
    if trials.best.score is None:
        raise DesignError(
            f"{design.document.path}: none of the {trials.count} machines tried in the ranges can"
            f" be: {trials.best.refusal}"
        )
    return trials


def global_search(trials: Trials, seed: int, tell: Tell) -> None:
    """Differential evolution from the best so far and a population spread over the ranges."""
    generation = 0

    def count(intermediate_result: OptimizeResult) -> None:
        nonlocal generation
        generation += 1
        tell("searching everywhere", generation / GENERATIONS)

    differential_evolution(
        trials.cost,
        Bounds(np.zeros(len(trials.design.ranges)), 1.0),
        x0=trials.best_place,
        popsize=POPULATION,
        maxiter=GENERATIONS,
        init="sobol",
        rng=seed,
        polish=False,
        callback=count,
    )


def local_search(trials: Trials, start: Shares) -> None:
    """Uphill from a place: by linear models first, then around what they end at."""
    trials.merit(start)
    if not start.size:
        return
    poses = trials.merits(start).size
    if poses > 1:
        place, _ = climb(trials.merits, partial(slopes, trials), start, TRUST, 0.0, 1.0)
        trials.merit(place)
    polish(trials)


def slopes(trials: Trials, place: Shares, merits: Array) -> Array:
    """Slopes (k, ranges) of the merits (k); 0 along a range with no machine next to this one."""
    found = np.zeros((merits.size, place.size))
    for i in range(place.size):
        step = DIFFERENCE if place[i] + DIFFERENCE <= 1 else -DIFFERENCE
        beside = trials.merits(place + step * np.eye(place.size)[i])
        if beside.size == merits.size:
            found[:, i] = (beside - merits) / step
    return found


def polish(trials: Trials) -> None:
    """Nelder and Mead's simplex, small, around the best so far: past kinks and refused machines."""
    place = trials.best_place
    inwards = np.where(place > 0.5, -POLISH_SIZE, POLISH_SIZE)
    minimize(
        trials.cost,
        place,
        method="Nelder-Mead",
        bounds=Bounds(np.zeros(place.size), 1.0),
        options={
            "initial_simplex": np.vstack([place, place + np.diag(inwards)]),
            "maxfev": POLISH_PER_RANGE * place.size,
            "adaptive": True,
            "xatol": 1e-6,
            "fatol": 1e-9 * abs(trials.merit(place)),
        },
    )
