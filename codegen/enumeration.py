"""Sweeps over subsets of the cables, lowered."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from turnbuckle.codegen.fitting import refuse_strangers, shapes
from turnbuckle.codegen.ir import Routine
from turnbuckle.codegen.item import Item
from turnbuckle.model.symbolic.function import ModelFunction, Output, judged_by_results
from turnbuckle.model.symbolic.sweep import CHOSEN, NUMBERS, Sweep


@dataclass(frozen=True)
class Enumeration(Item):
    """A function that visits subsets: see Sweep."""

    sweep: Sweep
    begin: Routine
    visit: Routine
    finish: Routine

    @property
    def function(self) -> ModelFunction:
        """Arguments, results and verdicts, as if it were one routine."""
        begin, finish = self.begin.function, self.finish.function
        return ModelFunction(
            self.sweep.name,
            self.sweep.summary,
            self.sweep.source,
            begin.inputs,
            finish.outputs,
            (*begin.verdicts, *finish.verdicts),
        )

    @property
    def state(self) -> tuple[Output, ...]:
        """What is carried from visit to visit."""
        return self.begin.function.outputs

    @property
    def matrix_shape(self) -> tuple[int, int]:
        """Rows and columns of the matrix whose columns are chosen."""
        shape = shapes(self.begin.function.ports)[self.sweep.matrix]
        return shape[0], shape[1]

    @property
    def visits(self) -> int:
        """Subsets of the cables that it visits itself."""
        return len(self.sweep.subsets)

    def calls(self) -> Sequence[tuple[Item, int]]:
        """Begin once, one visit of every subset, the finish once."""
        return [(self.begin, 1), (self.visit, self.visits), (self.finish, 1)]

    def own(self) -> Sequence[Item]:
        """What it alone calls."""
        return [self.begin, self.visit, self.finish]

    def text(self) -> str:
        """Its name, and how its parts are called."""
        parts = (self.begin, self.visit, self.finish)
        names = [[port.name for port in part.function.ports] for part in parts]
        return f"{self.sweep.name} {self.sweep.matrix} {self.sweep.subsets} {names}"


def enumeration(sweep: Sweep, lowered: Callable[[ModelFunction], Routine]) -> Enumeration:
    """The sweep of lowered parts; only `begin` guards the arguments.

    Raises ValueError where the parts do not fit together.
    """
    refuse_misfits(sweep)
    visit, finish = (
        replace(part, inputs=tuple(map(judged_by_results, part.inputs)))
        for part in (sweep.visit, sweep.finish)
    )
    return Enumeration(sweep, lowered(sweep.begin), lowered(visit), lowered(finish))


def refuse_misfits(sweep: Sweep) -> None:
    """Visits read what there is and write what is carried; subsets are of one size, in bounds."""
    begin, visit, finish = sweep.begin, sweep.visit, sweep.finish
    known = shapes(begin.ports)
    rows, columns = known[sweep.matrix]
    size = len(sweep.subsets[0])
    names = shapes((*begin.ports, *finish.outputs))
    if taken := {CHOSEN, NUMBERS} & names.keys() | known.keys() & shapes(finish.outputs).keys():
        raise ValueError(f"{sweep.name}: another port has the name {min(taken)}")
    refuse_strangers(visit.name, visit.inputs, known | {CHOSEN: (rows, size), NUMBERS: (size,)})
    refuse_strangers(visit.name, visit.outputs, shapes(begin.outputs))
    refuse_strangers(finish.name, finish.inputs, known)
    if visit.verdicts or not all(verdict.is_fault for verdict in begin.verdicts):
        raise ValueError(f"{sweep.name}: only {finish.name} may find the problem infeasible")
    for subset in sweep.subsets:
        if len(subset) != size or not all(0 <= number < columns for number in subset):
            raise ValueError(f"{sweep.name}: {subset} are not {size} of {columns} columns")
