"""What the generator prints, evaluates and measures: a routine, or a function made of others."""

from abc import abstractmethod
from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Protocol

from turnbuckle.model.symbolic.function import ModelFunction


class Item(Protocol):
    """A function that is lowered."""

    @property
    def function(self) -> ModelFunction:
        """Arguments, results and verdicts, as if it were one routine."""

    @property
    def steps(self) -> int:
        """Most steps of its own loop."""
        return 0

    @property
    def visits(self) -> int:
        """Subsets of the cables that it visits itself."""
        return 0

    def calls(self) -> Sequence[tuple["Item", int]]:
        """What it calls, and how often at most, in the longest sequence."""
        return ()

    def own(self) -> Sequence["Item"]:
        """What it alone calls."""
        return ()

    def operations(self) -> Mapping[str, int]:
        """Its own operations with every branch counted, by class, without what it calls."""
        return {}

    @abstractmethod
    def text(self) -> str:
        """All that decides what it computes, without what it calls, as text."""


def most_steps(item: Item) -> int:
    """How many steps of loops an item takes at most."""
    return item.steps + sum(most_steps(part) for part, _ in item.calls())


def most_visits(item: Item) -> int:
    """How many subsets of the cables an item visits at most."""
    return item.visits + sum(most_visits(part) for part, _ in item.calls())


def cost(item: Item) -> dict[str, int]:
    """Operations with every branch, step and visit counted, by class."""
    return added([(item.operations(), 1), *((cost(part), n) for part, n in item.calls())])


def added(costs: Sequence[tuple[Mapping[str, int], int]]) -> dict[str, int]:
    """Sum of some costs, each taken so many times."""
    counts = Counter[str]()
    for single, times in costs:
        counts.update({name: times * count for name, count in single.items()})
    return dict(counts)


def fingerprint(item: Item) -> str:
    """All that decides what a function computes, as text."""
    return "\n".join([item.text(), *(fingerprint(part) for part, _ in item.calls())])
