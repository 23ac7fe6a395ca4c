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
#: What is counted of a cost, and by which name; what is not here costs nothing worth telling.
COST_CLASSES = {
    Op.ADD: "add",
    Op.SUB: "add",
    Op.NEG: "add",
    Op.MUL: "mul",
    Op.DIV: "div",
    Op.SQRT: "sqrt",
    Op.LT: "compare",
    Op.LE: "compare",
    Op.EQ: "compare",
    Op.NE: "compare",
    Op.SELECT: "select",
    Op.MIN: "select",
    Op.MAX: "select",
}


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

    @property
    def steps(self) -> int:
        """No loop."""
        return 0

    @property
    def visits(self) -> int:
        """No subsets."""
        return 0

    def calls(self) -> Sequence[tuple["Routine", int]]:
        """Nothing: it is all there is."""
        return ()

    def own(self) -> Sequence["Routine"]:
        """Nothing."""
        return ()

    def operations(self) -> dict[str, int]:
        """Operations with every branch counted, by class."""
        counts = dict.fromkeys(COST_CLASSES.values(), 0)
        for number in self.needed():
            if name := COST_CLASSES.get(self.nodes[number].op):
                counts[name] += 1
        return {name: count for name, count in counts.items() if count}

    def text(self) -> str:
        """Every node, as text."""
        nodes = [f"{n.op.value} {n.args} {n.value!r} {n.entry}" for n in self.nodes]
        return "\n".join([self.function.name, *nodes, repr(self.outputs), repr(self.verdicts)])
