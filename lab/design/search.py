"""The best machine within the ranges: from the file's own values, and from anywhere.

The merit of a machine is that of its worst pose, so it has kinks where another pose becomes the
worst, and there a search by its slope alone gets stuck. Sequential linear programming (Madsen
1975, J. Inst. Maths Applics 16) looks at all poses at once instead: within a trust region it
makes the worst of their linear models as good as possible. Differential evolution looks elsewhere.
"""

from collections.abc import Callable

import numpy as np
import numpy.typing as npt
from scipy.optimize import Bounds, OptimizeResult, differential_evolution, linprog, minimize

from lab.design import DesignError
from lab.design.design import Design, Outcome, Values
from lab.design.target import Reals
from model.machine import MachineError

Shares = npt.NDArray[np.float64]
"""A place in the search: for every range the share of it, from 0 to 1."""
Tell = Callable[[str, float], None]
"""Told what is being done and the share that is done."""

METHODS = ("global", "local")
REFUSED = -1e12
"""Merit of a machine that there is not; below that of all that there are."""
DIFFERENCE = 1e-6
"""Step of a one-sided difference, a share of the range: half the digits of a double are right."""
FIRST_RADIUS, LAST_RADIUS = 0.1, 1e-7
MOST_STEPS = 60
ENOUGH = 1e-9
"""A predicted gain below this share of the merit is rounding."""
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

    def merits(self, place: Shares) -> Reals | None:
        """Merit at every pose, exactly here; None where there is no such machine."""
        self.models += 1
        try:
            return self.design.merits(self._values(place))
        except MachineError:
            return None

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
    if start.size:
        trials.merit(climb(trials, start))
        polish(trials)


def climb(trials: Trials, place: Shares) -> Shares:
    """Sequential linear programming for the largest least merit; where it ends."""
    merits, radius = trials.merits(place), FIRST_RADIUS
    for _ in range(MOST_STEPS):
        if merits is None:
            break
        slopes = differences(trials, place, merits)
        while radius > LAST_RADIUS:
            ahead, predicted = best_of_model(place, merits, slopes, radius)
            expected = predicted - merits.min()
            if expected <= ENOUGH * abs(predicted):
                return place
            there = trials.merits(ahead)
            gain = -np.inf if there is None else (there.min() - merits.min()) / expected
            radius = radius * 2 if gain > 0.75 else radius if gain > 0.25 else radius / 4
            if gain > 0:
                place, merits = ahead, there
                break
        else:
            return place
    return place


def differences(trials: Trials, place: Shares, merits: Reals) -> Reals:
    """Slopes (k, ranges) of the merits; 0 along a range where there is no machine next to this."""
    slopes = np.zeros((merits.size, place.size))
    for i in range(place.size):
        step = DIFFERENCE if place[i] + DIFFERENCE <= 1 else -DIFFERENCE
        beside = trials.merits(place + step * np.eye(place.size)[i])
        if beside is not None:
            slopes[:, i] = (beside - merits) / step
    return slopes


def best_of_model(
    place: Shares, merits: Reals, slopes: Reals, radius: float
) -> tuple[Shares, float]:
    """Where within the radius the least of merits + slopes . step is largest, and how large."""
    low, high = np.maximum(-radius, -place), np.minimum(radius, 1 - place)
    scale = max(float(np.abs(merits).max()), 1e-300)
    found = linprog(
        np.append(np.zeros(place.size), -1.0),
        A_ub=np.column_stack([-slopes / scale, np.ones(merits.size)]),
        b_ub=merits / scale,
        bounds=[*zip(low, high, strict=True), (None, None)],
    )
    if found.x is None:
        return place, float(merits.min())
    return np.clip(place + found.x[:-1], 0, 1), float(found.x[-1] * scale)


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
