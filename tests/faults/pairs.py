"""Two faults in one run, drawn at random: a run is told by its seed alone."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from random import Random

from catalogue import FAULTS, Fault
from forked import in_a_fork
from journey import NAMES, Bench, Moment, moment_of
from trial import AFTERWARDS, Outcome, Trial

from turnbuckle.lab.lockstep import Lockstep, Request

SPANS = {
    "INIT": (1, 100),
    "IDENTIFY": (1, 60),
    "CONFIGURE CONTRACT": (2, 250),
    "CONFIGURE READY": (3, 20),
    "HOME TIGHTEN": (8, 1500),
    "HOME TRY_BASES": (8, 60),
    "HOME BASE_HOMING": (8, 900),
    "HOME SWEEP": (12, 1800),
    "TENSION": (12, 400),
    "RUN": (34, 1500),
    "SOFT_STOP": (8, 200),
    "HARD_STOP": (2, 3),
    "FAULT": (1, 20),
}
"""How many of a hundred runs begin after each moment, and how many cycles after it at the latest:
so phases that come between two moments are met as well."""
LATER = 300
"""Cycles from the first fault to the second, at most."""
WATCHED = 60
"""Cycles for which a machine that goes on is looked at after the second."""
ASKED_OF = 4
"""One of so many machines that go on is asked to stop then."""


@dataclass(frozen=True)
class Pair:
    """Two faults, and when they strike."""

    seed: int
    moment: Moment
    after: int
    """Cycles after the moment at which the first strikes."""
    first: Fault
    second: Fault
    between: int
    """Cycles from the first to the second."""

    def __str__(self) -> str:
        begin = f"{self.moment.name} + {self.after}"
        return f"{self.seed}: {begin}: {self.first.name}; {self.between} later: {self.second.name}"

    @property
    def horizon(self) -> int:
        """Cycles in which a machine that goes on is looked at."""
        return self.between + WATCHED + 1

    @property
    def faults(self) -> tuple[Fault, Fault]:
        """Both."""
        return self.first, self.second

    @property
    def is_asked(self) -> bool:
        """Whether a machine that goes on is asked to stop in the end."""
        return self.seed % ASKED_OF == 0


def pair(seed: int) -> Pair:
    """The pair of a seed: at once in every second run, else soon more often than late."""
    chance = Random(seed)
    name = chance.choices(NAMES, [SPANS[each][0] for each in NAMES])[0]
    first, second = chance.sample(FAULTS, 2)
    between = round((LATER + 1) ** chance.random() - 1) if chance.random() < 0.5 else 0
    return Pair(seed, moment_of(name), chance.randrange(SPANS[name][1]), first, second, between)


def ask_to_stop(lockstep: Lockstep) -> None:
    """What an application does in the end."""
    lockstep.requests = Request.STOP


ASKED = Fault("a stop is asked for", strike=ask_to_stop)


def run(bench: Bench, pair: Pair) -> Outcome:
    """What comes of a pair, from where its first fault strikes."""
    blows = [(0, pair.first), (pair.between, pair.second)]
    if pair.is_asked:
        blows.append((pair.horizon, ASKED))
    horizon = pair.horizon + (1 if pair.is_asked else 0)
    return Trial(bench, *blows).run(horizon, least=pair.between + AFTERWARDS)


def walk(bench: Bench, pairs: Sequence[Pair]) -> Iterator[Outcome]:
    """Pairs of one moment in the order in which they begin, by a machine that goes on from there;
    every pair strikes a copy of it."""
    gone = 0
    for each in pairs:
        bench.lockstep.run(each.after - gone)
        gone = each.after
        yield in_a_fork(lambda each=each: run(bench, each))  # type: ignore[misc]


def outcomes(bench: Bench, pairs: Iterable[Pair]) -> list[tuple[Pair, Outcome]]:
    """What comes of pairs of one moment, at which the machine is and stays."""
    ordered = sorted(pairs, key=lambda pair: pair.after)
    found = in_a_fork(lambda: list(walk(bench, ordered)))
    return list(zip(ordered, found, strict=True))
