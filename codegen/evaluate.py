"""Runs a function in Python: in single or double precision as the C will, or with 106 bits."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from turnbuckle.codegen.chain import Chain
from turnbuckle.codegen.double_double import DoubleDouble, choose
from turnbuckle.codegen.enumeration import Enumeration
from turnbuckle.codegen.ir import Node, Op, Routine
from turnbuckle.codegen.item import Item
from turnbuckle.codegen.loop import Loop
from turnbuckle.codegen.procedure import Procedure
from turnbuckle.model.symbolic.function import Port, Status
from turnbuckle.model.symbolic.sweep import CHOSEN, NUMBERS


@dataclass(frozen=True)
class Arithmetic:
    """How numbers are made, chosen and rooted; the operators come with the numbers."""

    name: str
    number: Callable[[Any], Any]
    select: Callable[..., Any]
    root: Callable[[Any], Any]
    epsilon: float


FLOAT = Arithmetic("float", np.float32, np.where, np.sqrt, float(np.finfo(np.float32).eps))
DOUBLE = Arithmetic("double", np.float64, np.where, np.sqrt, float(np.finfo(np.float64).eps))


def extended(epsilon: float) -> Arithmetic:
    """106 bits, with the tolerances of the precision that is judged."""
    return Arithmetic("extended", DoubleDouble, choose, DoubleDouble.sqrt, epsilon)


def double_for(epsilon: float) -> Arithmetic:
    """Double precision with the tolerances of the precision that is judged."""
    return Arithmetic("double", np.float64, np.where, np.sqrt, epsilon)


@dataclass(frozen=True)
class Result:
    """Outputs (one list of entries each) and whether every verdict holds, over a batch."""

    outputs: list[list[Any]]
    verdicts: list[NDArray[np.bool_]]


Arguments = list[list[Any]]


def evaluate(item: Item, inputs: list[NDArray[Any]], arithmetic: Arithmetic) -> Result:
    """Evaluate a batch; `inputs` are (count, size) arrays in the order of the arguments."""
    count = len(inputs[0])
    numbers = [[arithmetic.number(column) for column in argument.T] for argument in inputs]
    with np.errstate(all="ignore"):
        return _evaluate(item, [_spread(entries, count) for entries in numbers], count, arithmetic)


def _evaluate(item: Item, inputs: Arguments, count: int, arithmetic: Arithmetic) -> Result:
    match item:
        case Procedure():
            return _retry(item, inputs, count, arithmetic)
        case Loop():
            return _repeat(item, inputs, count, arithmetic)
        case Enumeration():
            return _sweep(item, inputs, count, arithmetic)
        case Chain():
            return _compose(item, inputs, count, arithmetic)
        case Routine():
            return _run(item, inputs, count, arithmetic)
    raise TypeError(f"{item.function.name}: nothing evaluates a {type(item).__name__}")


def _retry(item: Procedure, inputs: Arguments, count: int, arithmetic: Arithmetic) -> Result:
    answer = _evaluate(item.attempts[0], inputs, count, arithmetic)
    again = failed(item.attempts[0], answer)
    wanted = inputs[item.replaced]
    asked = Result([wanted] * len(item.substitute.function.outputs), _none(item.substitute, count))
    second = _evaluate_where(again, item.substitute, inputs, asked, arithmetic)
    again = again & (statuses(item.substitute, second) <= Status.INFEASIBLE)
    on_border = np.zeros(count, dtype=bool)
    for number, replacement in enumerate(second.outputs):
        if number:
            on_border |= again
        served = list(inputs)
        served[item.replaced] = _select(again, replacement, wanted, arithmetic)
        for attempt in item.attempts:
            answer = _evaluate_where(again, attempt, served, answer, arithmetic)
            again = again & failed(attempt, answer)
    verdicts = [
        holds | (on_border & (verdict.status is Status.INFEASIBLE))
        for verdict, holds in zip(item.substitute.function.verdicts, second.verdicts, strict=True)
    ]
    return Result(answer.outputs, [*answer.verdicts, *verdicts])


def _repeat(item: Loop, inputs: Arguments, count: int, arithmetic: Arithmetic) -> Result:
    begun = _run(item.begin, inputs, count, arithmetic)
    known = _named(item.function.inputs, inputs) | _named(item.state, begun.outputs)
    known[item.done.name] = _spread([arithmetic.number(0.0)], count)
    faults = _none(item.step, count)
    going = np.ones(count, dtype=bool) & (statuses(item.begin, begun) == Status.OK)
    for _ in range(item.repeat.most):
        outputs = [known[port.name] for port in item.step.function.outputs]
        arguments = [known[port.name] for port in item.step.function.inputs]
        stepped = _evaluate_where(going, item.step, arguments, Result(outputs, faults), arithmetic)
        known |= _named(item.step.function.outputs, stepped.outputs)
        faults = stepped.verdicts
        done = arithmetic.number(0.0) < known[item.done.name][0]
        going = going & ~done & (statuses(item.step, stepped) == Status.OK)
    arguments = [known[port.name] for port in item.finish.function.inputs]
    finished = _run(item.finish, arguments, count, arithmetic)
    return Result(finished.outputs, [*begun.verdicts, *faults, going, *finished.verdicts])


def _sweep(item: Enumeration, inputs: Arguments, count: int, arithmetic: Arithmetic) -> Result:
    begun = _run(item.begin, inputs, count, arithmetic)
    known = _named(item.function.inputs, inputs) | _named(item.state, begun.outputs)
    rows, columns = item.matrix_shape
    matrix = known[item.sweep.matrix]
    for subset in item.sweep.subsets:
        known[CHOSEN] = [matrix[columns * row + number] for row in range(rows) for number in subset]
        known[NUMBERS] = _spread([arithmetic.number(float(number)) for number in subset], count)
        arguments = [known[port.name] for port in item.visit.function.inputs]
        visited = _run(item.visit, arguments, count, arithmetic)
        known |= _named(item.visit.function.outputs, visited.outputs)
    arguments = [known[port.name] for port in item.finish.function.inputs]
    finished = _run(item.finish, arguments, count, arithmetic)
    return Result(finished.outputs, [*begun.verdicts, *finished.verdicts])


def _compose(item: Chain, inputs: Arguments, count: int, arithmetic: Arithmetic) -> Result:
    known = _named(item.function.inputs, inputs)
    verdicts: list[NDArray[np.bool_]] = []
    for link in item.links:
        function = link.item.function
        arguments = [known[link.local(port)] for port in function.inputs]
        if link.call.given:
            made = arithmetic.number(0.0) < known[link.call.given][0]
            zero = arithmetic.number(0.0)
            nothing = [_spread([zero] * port.size, count) for port in function.outputs]
            skipped = Result(nothing, _none(link.item, count))
            result = _evaluate_where(made, link.item, arguments, skipped, arithmetic)
        else:
            result = _evaluate(link.item, arguments, count, arithmetic)
        known |= dict(zip(link.gives(), result.outputs, strict=True))
        verdicts += result.verdicts
    return Result(result.outputs, verdicts)


def _named(ports: Sequence[Port], values: Arguments) -> dict[str, list[Any]]:
    return dict(zip((port.name for port in ports), values, strict=True))


def _none(item: Item, count: int) -> list[NDArray[np.bool_]]:
    """No verdict of the item holds anywhere."""
    return [np.zeros(count, dtype=bool) for _ in item.function.verdicts]


def _evaluate_where(
    chosen: NDArray[np.bool_],
    item: Item,
    inputs: Arguments,
    otherwise: Result,
    arithmetic: Arithmetic,
) -> Result:
    """The item's result where `chosen`, elsewhere the other; other points cost nothing."""
    places = np.flatnonzero(chosen)
    if not len(places):
        return otherwise
    picked = [[entry[places] for entry in entries] for entries in inputs]
    result = _evaluate(item, picked, len(places), arithmetic)
    # Where each chosen point is in the result; the others take any.
    back = np.maximum(np.cumsum(chosen) - 1, 0)
    outputs = [
        _select(chosen, [entry[back] for entry in new], old, arithmetic)
        for new, old in zip(result.outputs, otherwise.outputs, strict=True)
    ]
    pairs = zip(result.verdicts, otherwise.verdicts, strict=True)
    return Result(outputs, [np.where(chosen, new[back], old) for new, old in pairs])


def _select(
    chosen: NDArray[np.bool_], yes: list[Any], no: list[Any], arithmetic: Arithmetic
) -> list[Any]:
    return [arithmetic.select(chosen, a, b) for a, b in zip(yes, no, strict=True)]


def statuses(item: Item, result: Result) -> NDArray[np.int_]:
    """What an item answers at every point: its first fault, else whether it is infeasible."""
    status = np.zeros(len(result.verdicts[0]) if result.verdicts else 1, dtype=int)
    pairs = list(zip(item.function.verdicts, result.verdicts, strict=True))
    for verdict, holds in sorted(reversed(pairs), key=lambda pair: pair[0].is_fault):
        status = np.where(holds, int(verdict.status), status)
    return status


def failed(item: Item, result: Result) -> NDArray[np.bool_]:
    """Where an item reports that its own check failed."""
    missed: NDArray[np.bool_] = statuses(item, result) == Status.INACCURATE
    return missed


def _run(routine: Routine, inputs: Arguments, count: int, arithmetic: Arithmetic) -> Result:
    values: dict[int, Any] = {}
    for number in routine.order:
        values[number] = _value(routine.nodes[number], values, inputs, arithmetic)
    return Result(
        [_spread([values[n] for n in group], count) for group in routine.outputs],
        [np.broadcast_to(np.asarray(values[n], dtype=bool), (count,)) for n in routine.verdicts],
    )


def _spread(values: list[Any], count: int) -> list[Any]:
    """Every value as `count` numbers, constants too."""
    return [
        value.spread(count) if isinstance(value, DoubleDouble) else np.broadcast_to(value, (count,))
        for value in values
    ]


def _value(node: Node, values: dict[int, Any], inputs: Arguments, arithmetic: Arithmetic) -> Any:
    operation = _OPERATIONS.get(node.op)
    if operation:
        return operation(arithmetic, *[values[arg] for arg in node.args])
    if node.op is Op.INPUT:
        argument, entry = node.entry
        return inputs[argument][entry]
    return arithmetic.number(arithmetic.epsilon if node.op is Op.EPSILON else node.value)


def _leading(value: Any) -> Any:
    return value.high if isinstance(value, DoubleDouble) else value


def _truth(value: Any) -> Any:
    return np.asarray(value, dtype=bool)


def _copysign(arithmetic: Arithmetic, size: Any, sign: Any) -> Any:
    return arithmetic.select(np.signbit(_leading(sign)), -abs(size), abs(size))


_OPERATIONS: dict[Op, Callable[..., Any]] = {
    Op.ADD: lambda _, a, b: a + b,
    Op.SUB: lambda _, a, b: a - b,
    Op.MUL: lambda _, a, b: a * b,
    Op.DIV: lambda _, a, b: a / b,
    Op.NEG: lambda _, a: -a,
    Op.ABS: lambda _, a: abs(a),
    Op.SQRT: lambda arithmetic, a: arithmetic.root(a),
    Op.COPYSIGN: _copysign,
    Op.MIN: lambda arithmetic, a, b: arithmetic.select(a < b, a, b),
    Op.MAX: lambda arithmetic, a, b: arithmetic.select(b < a, a, b),
    Op.LT: lambda _, a, b: a < b,
    Op.LE: lambda _, a, b: a <= b,
    Op.EQ: lambda _, a, b: a == b,
    Op.NE: lambda _, a, b: a != b,
    Op.NOT: lambda _, a: ~_truth(a),
    Op.AND: lambda _, a, b: _truth(a) & _truth(b),
    Op.OR: lambda _, a, b: _truth(a) | _truth(b),
    Op.SELECT: lambda arithmetic, a, b, c: arithmetic.select(_truth(a), b, c),
}
