"""Functions that go through a fixed table of subsets of the cables."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from itertools import combinations

import casadi as ca

from turnbuckle.model.symbolic.function import (
    Input,
    ModelFunction,
    Output,
    Verdict,
    carried,
    judged_by_results,
    make_input,
)
from turnbuckle.model.symbolic.scalar import Scalar, Vector, any_of

#: What a visit may read of its subset: those columns of the matrix, and their numbers from 0.
CHOSEN, NUMBERS = "chosen", "numbers"


@dataclass(frozen=True)
class Sweep:
    """`begin`, then `visit` for every subset of the columns of a matrix, then `finish`.

    The outputs of `begin` are the sweep's state. A visit takes arguments and state entries by name
    (`carried` makes the inputs), and of its subset `CHOSEN` and `NUMBERS`, or one of them; its
    outputs replace the state entries of the same name, and it cannot fail. `finish` takes arguments
    and state entries by name, and makes the results. `subsets` are rows of column numbers of the
    argument or state entry `matrix`. `make_sweep` makes all that from formulas.
    """

    name: str
    summary: str
    source: str
    begin: ModelFunction
    visit: ModelFunction
    finish: ModelFunction
    matrix: str
    subsets: tuple[tuple[int, ...], ...]


@dataclass(frozen=True)
class Subset:
    """What a visit reads of its subset of k cables: their columns (rows x k) and numbers (k)."""

    columns: Input
    numbers: Input

    def holds(self, cable: int) -> Scalar:
        """Whether a cable is in the subset."""
        return any_of([number == cable for number in self.numbers.scalars()])


Ports = Mapping[str, Input]


@dataclass(frozen=True)
class Scheme:
    """What a sweep does, in formulas.

    `state` holds its entries before the first visit. `visit` is given a subset, arguments and state
    by name, and returns the entries that change; `finish` is given the same but for the subset, and
    returns results and verdicts. `matrix` names an argument or a state entry, and `size` says how
    many of its columns are chosen. `refusals` are faults that are known before the first subset.
    """

    inputs: tuple[Input, ...]
    matrix: str
    size: int
    state: tuple[Output, ...]
    visit: Callable[[Subset, Ports], Mapping[str, Vector]]
    finish: Callable[[Ports], tuple[tuple[Output, ...], tuple[Verdict, ...]]]
    refusals: tuple[Verdict, ...] = ()


def make_sweep(name: str, summary: str, source: str, scheme: Scheme) -> Sweep:
    """The sweep over all subsets of one size."""
    begin = ModelFunction(
        f"{name}_begin",
        "Before the first subset",
        source,
        scheme.inputs,
        scheme.state,
        scheme.refusals,
    )
    known = {port.name: port for port in (*scheme.inputs, *carried(scheme.state))}
    rows, columns = known[scheme.matrix].shape
    return Sweep(
        name,
        summary,
        source,
        begin,
        visit_of(name, source, scheme, known, rows),
        finish_of(name, source, scheme, known),
        scheme.matrix,
        tuple(combinations(range(columns), scheme.size)),
    )


def visit_of(name: str, source: str, scheme: Scheme, known: Ports, rows: int) -> ModelFunction:
    """What is done for one subset."""
    columns = make_input(CHOSEN, (rows, scheme.size), "1", [0.0], [0.0])
    numbers = make_input(NUMBERS, (scheme.size,), "1", [0.0], [0.0])
    subset = Subset(judged_by_results(columns), judged_by_results(numbers))
    changed = scheme.visit(subset, known)
    outputs = tuple(
        replace(entry, values=changed[entry.name])
        for entry in scheme.state
        if entry.name in changed
    )
    values = [value for entry in outputs for value in entry.values]
    inputs = needed((subset.columns, subset.numbers, *known.values()), values)
    return ModelFunction(f"{name}_visit", "One subset", source, inputs, outputs)


def finish_of(name: str, source: str, scheme: Scheme, known: Ports) -> ModelFunction:
    """What is made of the last state."""
    outputs, verdicts = scheme.finish(known)
    values = [value for entry in outputs for value in entry.values]
    inputs = needed(tuple(known.values()), [*values, *(v.condition for v in verdicts)])
    return ModelFunction(
        f"{name}_finish", "After the last subset", source, inputs, outputs, verdicts
    )


def needed(ports: tuple[Input, ...], values: Vector) -> tuple[Input, ...]:
    """The ports that some values are computed from."""
    expression = ca.vertcat(*values)
    return tuple(port for port in ports if ca.depends_on(expression, port.symbols))
