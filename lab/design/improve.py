"""A better machine as a new machine file, proven to be one by reading it back."""

import tomllib
from dataclasses import dataclass

from turnbuckle.lab.design import DesignError
from turnbuckle.lab.design.design import Design, Outcome
from turnbuckle.lab.design.document import Changes
from turnbuckle.lab.design.goal import Score
from turnbuckle.model.reading import machine_from

BETTER = 1e-6
"""A gain below this share of the merit is none: values have few digits."""


class NoImprovement(DesignError):
    """No machine in the ranges is better than the file's; str() says so to the user."""


@dataclass(frozen=True)
class Improvement:
    """A new machine file and what it gains."""

    text: str
    changes: Changes
    before: Score
    after: Score


def improvement(design: Design, best: Outcome) -> Improvement:
    """The file of the best machine; NoImprovement where it is not better than the present one."""
    before, path = design.present(), design.document.path
    assert best.score is not None
    if not best.score.attained:
        unattained = design.goal.unattained.format(*best.score.figures)
        raise NoImprovement(f"{path}: no machine in the ranges does what is wanted: {unattained}")
    changes = design.changes(best)
    text = design.document.text_with(changes)
    after = design.goal.present(machine_from(tomllib.loads(text), path))
    if before.attained and after.merit <= before.merit + BETTER * abs(before.merit):
        what, value = design.goal.figures[0], before.figures[0]
        raise NoImprovement(
            f"{path}: no machine in the ranges is better than the file's own, {what} {value:.6g}"
        )
    return Improvement(text, changes, before, after)
