"""Runs a routine in Python: in single or double precision as the C will, or with 106 bits."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from codegen.double_double import DoubleDouble, choose
from codegen.ir import Node, Op, Procedure, Routine
from model.symbolic.function import Status


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


def evaluate(
    item: Routine | Procedure, inputs: list[NDArray[Any]], arithmetic: Arithmetic
) -> Result:
    """Evaluate a batch; `inputs` are (count, size) arrays in the order of the arguments."""
    numbers = [[arithmetic.number(column) for column in argument.T] for argument in inputs]
    with np.errstate(all="ignore"):
        if isinstance(item, Procedure):
            return _retry(item, numbers, arithmetic)
        return _run(item, numbers, arithmetic)


def _retry(item: Procedure, inputs: Arguments, arithmetic: Arithmetic) -> Result:
    answer = _run(item.attempts[0], inputs, arithmetic)
    again = failed(item.attempts[0], answer)
    second = _run(item.substitute, inputs, arithmetic)
    infeasible = again & second.verdicts[-1]
    for number, replacement in enumerate(second.outputs):
        if number:
            again = again & infeasible
        served = list(inputs)
        served[item.replaced] = [
            arithmetic.select(infeasible, new, old)
            for new, old in zip(replacement, inputs[item.replaced], strict=True)
        ]
        for attempt in item.attempts:
            result = _run(attempt, served, arithmetic)
            answer = _blend(again, result, answer, arithmetic)
            again = again & failed(attempt, result)
    return Result(answer.outputs, [*answer.verdicts, infeasible])


def _blend(chosen: Any, yes: Result, no: Result, arithmetic: Arithmetic) -> Result:
    """One result where `chosen`, elsewhere the other."""
    outputs = [
        [arithmetic.select(chosen, a, b) for a, b in zip(new, old, strict=True)]
        for new, old in zip(yes.outputs, no.outputs, strict=True)
    ]
    verdicts = [np.where(chosen, a, b) for a, b in zip(yes.verdicts, no.verdicts, strict=True)]
    return Result(outputs, verdicts)


def failed(routine: Routine, result: Result) -> NDArray[np.bool_]:
    """Where a routine reports that its own check failed."""
    pairs = zip(routine.function.verdicts, result.verdicts, strict=True)
    return next(holds for verdict, holds in pairs if verdict.status is Status.INACCURATE)


def _run(routine: Routine, inputs: Arguments, arithmetic: Arithmetic) -> Result:
    values: dict[int, Any] = {}
    for number in sorted(routine.needed()):
        values[number] = _value(routine.nodes[number], values, inputs, arithmetic)
    return Result(
        [[values[n] for n in group] for group in routine.outputs],
        [np.asarray(values[n], dtype=bool) for n in routine.verdicts],
    )


def _value(node: Node, values: dict[int, Any], inputs: Arguments, arithmetic: Arithmetic) -> Any:
    if node.op is Op.CONSTANT:
        return arithmetic.number(node.value)
    if node.op is Op.EPSILON:
        return arithmetic.number(arithmetic.epsilon)
    if node.op is Op.INPUT:
        argument, entry = node.entry
        return inputs[argument][entry]
    args = [values[arg] for arg in node.args]
    if node.op is Op.SELECT:
        return arithmetic.select(_truth(args[0]), args[1], args[2])
    if node.op is Op.MIN:
        return arithmetic.select(args[0] < args[1], args[0], args[1])
    if node.op is Op.MAX:
        return arithmetic.select(args[1] < args[0], args[0], args[1])
    if node.op is Op.COPYSIGN:
        return arithmetic.select(np.signbit(_leading(args[1])), -abs(args[0]), abs(args[0]))
    if node.op is Op.SQRT:
        return arithmetic.root(args[0])
    return _OPERATIONS[node.op](*args)


def _leading(value: Any) -> Any:
    return value.high if isinstance(value, DoubleDouble) else value


def _truth(value: Any) -> Any:
    return np.asarray(value, dtype=bool)


_OPERATIONS: dict[Op, Callable[..., Any]] = {
    Op.ADD: lambda a, b: a + b,
    Op.SUB: lambda a, b: a - b,
    Op.MUL: lambda a, b: a * b,
    Op.DIV: lambda a, b: a / b,
    Op.NEG: lambda a: -a,
    Op.ABS: abs,
    Op.LT: lambda a, b: a < b,
    Op.LE: lambda a, b: a <= b,
    Op.EQ: lambda a, b: a == b,
    Op.NE: lambda a, b: a != b,
    Op.NOT: lambda a: ~_truth(a),
    Op.AND: lambda a, b: _truth(a) & _truth(b),
    Op.OR: lambda a, b: _truth(a) | _truth(b),
}
