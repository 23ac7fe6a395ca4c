"""The intermediate representation: scalar operations in single-assignment form."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from enum import Enum
from functools import cached_property

from turnbuckle.model.symbolic.function import ModelFunction


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

    @cached_property
    def order(self) -> list[int]:
        """The nodes that are needed, every one after those it reads."""
        return sorted(self.needed())

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
