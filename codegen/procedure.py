"""Attempts in turn, lowered."""

from collections.abc import Sequence
from dataclasses import dataclass

from turnbuckle.codegen.item import Item
from turnbuckle.model.symbolic.function import ModelFunction, Retry


@dataclass(frozen=True)
class Procedure(Item):
    """A function made of items that are tried in turn: see Retry."""

    retry: Retry
    attempts: tuple[Item, ...]
    substitute: Item

    @property
    def function(self) -> ModelFunction:
        """Arguments, results and verdicts, as if it were one routine."""
        last, second = self.attempts[-1].function, self.substitute.function
        return ModelFunction(
            self.retry.name,
            self.retry.summary,
            self.retry.source,
            last.inputs,
            last.outputs,
            (*last.verdicts, *second.verdicts),
        )

    @property
    def replaced(self) -> int:
        """Which argument the substitute replaces."""
        names = [argument.name for argument in self.attempts[0].function.inputs]
        return names.index(self.retry.argument)

    def calls(self) -> Sequence[tuple[Item, int]]:
        """Items in the longest sequence they are called in."""
        served = len(self.substitute.function.outputs)
        parts = (self.attempts[0], self.substitute, *self.attempts * served)
        return [(part, 1) for part in parts]

    def text(self) -> str:
        """Its name, and how its parts are called."""
        return repr(self.retry)
