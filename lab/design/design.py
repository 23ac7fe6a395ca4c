"""A design search as a question: a machine file, what varies of it, and what is wanted."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from decimal import Decimal
from pathlib import Path
from typing import NamedTuple

from turnbuckle.lab.design.document import Changes, Document
from turnbuckle.lab.design.goal import Goal, IsotropicForce, Score
from turnbuckle.lab.design.motor import motor_goal
from turnbuckle.lab.design.vary import Range, parse_ranges
from turnbuckle.model.machine import Machine
from turnbuckle.model.problem import MachineError
from turnbuckle.model.workspace.rows import Array

Values = tuple[Decimal, ...]
"""A value for every range, in the file's unit."""


class Outcome(NamedTuple):
    """What became of a candidate."""

    values: Values
    score: Score | None
    """None where there is no such machine."""
    refusal: str
    """Why there is no such machine; "" where there is."""


@dataclass(frozen=True)
class Design:
    """The question. It reads no file any more, so any computer can answer it."""

    document: Document
    ranges: tuple[Range, ...]
    goal: Goal

    @classmethod
    def read(cls, path: Path, vary: Sequence[str], goal: str) -> Design:
        """The question of a command line; MachineError or DesignError where it is none."""
        document = Document.read(path)
        ranges = parse_ranges(vary, document)
        if goal == "motor":
            wanted, left = motor_goal(document, ranges)
            return cls(document, left, wanted)
        return cls(document, ranges, IsotropicForce())

    def present(self) -> Score:
        """The score of the file as it is."""
        return self.goal.present(self.document.machine({}))

    def outcome(self, values: Values) -> Outcome:
        """The score of the machine with these values, or why there is none."""
        try:
            return Outcome(values, self.goal.score(self._candidate(values)), "")
        except MachineError as error:
            return Outcome(values, None, str(error.problems[0]))

    def merits(self, values: Values) -> Array:
        """Merit (k) at every pose of the target; MachineError where there is no such machine."""
        return self.goal.merits(self._candidate(values))

    def changes(self, outcome: Outcome) -> Changes:
        """All that the file says differently for a candidate that there is."""
        assert outcome.score is not None
        machine = self._candidate(outcome.values)
        return {**self._varied(outcome.values), **self.goal.settlement(machine, outcome.score)}

    def _candidate(self, values: Values) -> Machine:
        return self.document.candidate({**self.goal.allowance(), **self._varied(values)})

    def _varied(self, values: Values) -> Changes:
        pairs = zip(self.ranges, values, strict=True)
        return {place: text for one, value in pairs for place, text in one.changes(value).items()}
