"""The intermediate representation: scalar operations in single-assignment form."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from enum import Enum

from model.symbolic.function import ModelFunction, Retry


class Op(Enum):
    """Operations a node can perform; the value is how messages and costs name it."""

    CONSTANT = "constant"
    INPUT = "input"
    EPSILON = "epsilon"
    ADD = "add"
    SUB = "sub"
    MUL = "mul"
    DIV = "div"
    NEG = "neg"
    SQRT = "sqrt"
    ABS = "abs"
    COPYSIGN = "copy sign"
    MIN = "min"
    MAX = "max"
    LT = "less"
    LE = "less or equal"
    EQ = "equal"
    NE = "not equal"
    NOT = "not"
    AND = "and"
    OR = "or"
    SELECT = "select"


#: Operations whose result is a truth value.
LOGICAL = frozenset({Op.LT, Op.LE, Op.EQ, Op.NE, Op.NOT, Op.AND, Op.OR})
#: Operations without operands.
LEAVES = frozenset({Op.CONSTANT, Op.INPUT, Op.EPSILON})
COMMUTATIVE = frozenset({Op.ADD, Op.MUL, Op.EQ, Op.NE, Op.AND, Op.OR})


@dataclass(frozen=True, slots=True)
class Node:
    """One operation on earlier nodes; a constant has a `value`, an input the entry it reads."""

    op: Op
    args: tuple[int, ...] = ()
    value: float = 0.0
    entry: tuple[int, int] = (0, 0)


@dataclass(frozen=True)
class Routine:
    """A model function as nodes; every list of results holds node numbers."""

    function: ModelFunction
    nodes: Sequence[Node]
    outputs: list[list[int]]
    verdicts: list[int]
    labels: list[list[int]] = field(default_factory=list)

    def roots(self) -> list[int]:
        """Nodes that the function needs: outputs and verdicts (labels only name what is there)."""
        return [node for group in self.outputs for node in group] + self.verdicts

    def needed(self) -> set[int]:
        """The roots and everything they are computed from."""
        seen: set[int] = set()
        stack = self.roots()
        while stack:
            number = stack.pop()
            if number not in seen:
                seen.add(number)
                stack.extend(self.nodes[number].args)
        return seen


@dataclass(frozen=True)
class Procedure:
    """A function made of routines that are tried in turn: see Retry."""

    retry: Retry
    attempts: tuple[Routine, ...]
    substitute: Routine

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
            (*last.verdicts, *(v for v in second.verdicts if not v.is_fault)),
        )

    @property
    def replaced(self) -> int:
        """Which argument the substitute replaces."""
        names = [argument.name for argument in self.attempts[0].function.inputs]
        return names.index(self.retry.argument)

    def parts(self) -> list[Routine]:
        """Routines in the longest sequence they are called in."""
        served = len(self.substitute.outputs)
        return [self.attempts[0], self.substitute, *self.attempts * served]


COSTED = (Op.ADD, Op.MUL, Op.DIV, Op.SQRT, Op.LT, Op.SELECT)
_COST_CLASS = {
    Op.SUB: Op.ADD,
    Op.NEG: Op.ADD,
    Op.LE: Op.LT,
    Op.EQ: Op.LT,
    Op.NE: Op.LT,
    Op.MIN: Op.SELECT,
    Op.MAX: Op.SELECT,
}


def cost(item: Routine | Procedure) -> dict[str, int]:
    """Operations with every branch counted, by class."""
    if isinstance(item, Procedure):
        return dict(sum((Counter(cost(part)) for part in item.parts()), Counter[str]()))
    counts = dict.fromkeys(COSTED, 0)
    for number in item.needed():
        op = item.nodes[number].op
        op = _COST_CLASS.get(op, op)
        if op in counts:
            counts[op] += 1
    names = {Op.LT: "compare"}
    return {names.get(op, op.value): count for op, count in counts.items() if count}


def fingerprint(item: Routine | Procedure) -> str:
    """All that decides what a function computes, as text."""
    if isinstance(item, Procedure):
        return "\n".join([repr(item.retry), *map(fingerprint, item.parts())])
    nodes = [f"{n.op.value} {n.args} {n.value!r} {n.entry}" for n in item.nodes]
    return "\n".join([item.function.name, *nodes, repr(item.outputs), repr(item.verdicts)])
