"""Passes over the intermediate representation.

Every rewrite either keeps the result to the bit or replaces a division by the product with a
reciprocal (at most 1.5 units in the last place instead of 0.5).
"""

import math
from collections import Counter
from collections.abc import Callable
from dataclasses import replace

from turnbuckle.codegen.ir import COMMUTATIVE, Node, Op, Routine

_FOLD: dict[Op, Callable[..., float]] = {
    Op.ADD: lambda a, b: a + b,
    Op.SUB: lambda a, b: a - b,
    Op.MUL: lambda a, b: a * b,
    Op.DIV: lambda a, b: a / b,
    Op.NEG: lambda a: -a,
    Op.SQRT: math.sqrt,
    Op.ABS: abs,
    Op.COPYSIGN: math.copysign,
    Op.MIN: min,
    Op.MAX: max,
    Op.LT: lambda a, b: float(a < b),
    Op.LE: lambda a, b: float(a <= b),
    Op.EQ: lambda a, b: float(a == b),
    Op.NE: lambda a, b: float(a != b),
    Op.NOT: lambda a: float(not a),
    Op.AND: lambda a, b: float(bool(a) and bool(b)),
    Op.OR: lambda a, b: float(bool(a) or bool(b)),
}


class Builder:
    """Builds nodes that are shared when equal and simplified where that is exact."""

    def __init__(self) -> None:
        self.nodes: list[Node] = []
        self.known: dict[Node, int] = {}

    def intern(self, node: Node) -> int:
        """The number of this node, new or already there."""
        if node not in self.known:
            self.known[node] = len(self.nodes)
            self.nodes.append(node)
        return self.known[node]

    def constant(self, value: float) -> int:
        """A constant; minus zero is folded into zero."""
        return self.intern(Node(Op.CONSTANT, value=value + 0.0))

    def value(self, number: int) -> float | None:
        """Value of a constant node, else None."""
        node = self.nodes[number]
        return node.value if node.op is Op.CONSTANT else None

    def make(self, op: Op, *args: int) -> int:
        """The simplest node equal to `op` applied to `args`."""
        values = [self.value(arg) for arg in args]
        if op in _FOLD and all(value is not None for value in values):
            folded = self.fold(op, values)
            if folded is not None:
                return folded
        rule = _RULES.get(op)
        simpler = rule(self, *args) if rule else None
        if simpler is not None:
            return simpler
        if op in COMMUTATIVE and args[0] > args[1]:
            args = (args[1], args[0])
        return self.intern(Node(op, args))

    def fold(self, op: Op, values: list[float | None]) -> int | None:
        """The operation on constants, unless it has no finite result."""
        try:
            result = _FOLD[op](*values)
        except (ZeroDivisionError, ValueError, OverflowError):
            return None
        return self.constant(result) if math.isfinite(result) else None

    def negated(self, number: int) -> int | None:
        """x where the node is -x, else None."""
        node = self.nodes[number]
        return node.args[0] if node.op is Op.NEG else None


def _add(b: Builder, x: int, y: int) -> int | None:
    if b.value(x) == 0:
        return y
    if b.value(y) == 0:
        return x
    merged = _merge_selects(b, x, y)
    if merged is not None:
        return merged
    if (inner := b.negated(y)) is not None:
        return b.make(Op.SUB, x, inner)
    if (inner := b.negated(x)) is not None:
        return b.make(Op.SUB, y, inner)
    return None


def _merge_selects(b: Builder, x: int, y: int) -> int | None:
    """CasADi writes a choice as (c ? p : 0) + (!c ? q : 0): back to c ? p : q."""
    first, second = b.nodes[x], b.nodes[y]
    if first.op is not Op.SELECT or second.op is not Op.SELECT or first.args[0] != second.args[0]:
        return None
    condition, p, zero = first.args
    _, other_zero, q = second.args
    if b.value(zero) == 0 and b.value(other_zero) == 0:
        return b.make(Op.SELECT, condition, p, q)
    if b.value(p) == 0 and b.value(q) == 0:
        return b.make(Op.SELECT, condition, other_zero, zero)
    return None


def _sub(b: Builder, x: int, y: int) -> int | None:
    if b.value(y) == 0:
        return x
    if b.value(x) == 0:
        return b.make(Op.NEG, y)
    if (inner := b.negated(y)) is not None:
        return b.make(Op.ADD, x, inner)
    return None


def _mul(b: Builder, x: int, y: int) -> int | None:
    for factor, other in ((x, y), (y, x)):
        if b.value(factor) == 0:
            return b.constant(0.0)
        if b.value(factor) == 1:
            return other
        if b.value(factor) == -1:
            return b.make(Op.NEG, other)
        if (inner := b.negated(factor)) is not None:
            return b.make(Op.NEG, b.make(Op.MUL, inner, other))
    return None


def _div(b: Builder, x: int, y: int) -> int | None:
    divisor = b.value(y)
    if b.value(x) == 0:
        return b.constant(0.0)
    if divisor is not None and divisor != 0:
        return b.make(Op.MUL, x, b.constant(1.0 / divisor))
    if (inner := b.negated(x)) is not None:
        return b.make(Op.NEG, b.make(Op.DIV, inner, y))
    return None


def _neg(b: Builder, x: int) -> int | None:
    node = b.nodes[x]
    if node.op is Op.NEG:
        return node.args[0]
    if node.op is Op.SUB:
        return b.make(Op.SUB, node.args[1], node.args[0])
    return None


def _abs(b: Builder, x: int) -> int | None:
    node = b.nodes[x]
    return b.make(Op.ABS, node.args[0]) if node.op is Op.NEG else None


def _not(b: Builder, x: int) -> int | None:
    node = b.nodes[x]
    return node.args[0] if node.op is Op.NOT else None


def _same(b: Builder, x: int, y: int) -> int | None:
    return x if x == y else None


def _and(b: Builder, x: int, y: int) -> int | None:
    for fixed, other in ((x, y), (y, x)):
        value = b.value(fixed)
        if value is not None:
            return other if value else b.constant(0.0)
    return _same(b, x, y)


def _or(b: Builder, x: int, y: int) -> int | None:
    for fixed, other in ((x, y), (y, x)):
        value = b.value(fixed)
        if value is not None:
            return b.constant(1.0) if value else other
    return _same(b, x, y)


def _select(b: Builder, condition: int, yes: int, no: int) -> int | None:
    value = b.value(condition)
    if value is not None:
        return yes if value else no
    if yes == no:
        return yes
    node = b.nodes[condition]
    if node.op is Op.NOT:
        return b.make(Op.SELECT, node.args[0], no, yes)
    return None


_RULES: dict[Op, Callable[..., int | None]] = {
    Op.ADD: _add,
    Op.SUB: _sub,
    Op.MUL: _mul,
    Op.DIV: _div,
    Op.NEG: _neg,
    Op.ABS: _abs,
    Op.NOT: _not,
    Op.MIN: _same,
    Op.MAX: _same,
    Op.AND: _and,
    Op.OR: _or,
    Op.SELECT: _select,
}


#: Rewrites one node: (builder, node, its operands in the builder, its number) -> new number.
Rewrite = Callable[[Builder, Node, tuple[int, ...], int], int]
#: Cycles until the result of an operation can be used, roughly, on today's processors.
_LATENCY = {Op.ADD: 4, Op.SUB: 4, Op.MUL: 4, Op.DIV: 13, Op.SQRT: 18}


def rebuild(routine: Routine, rewrite: Rewrite) -> Routine:
    """A routine whose needed nodes went through `rewrite`, in their order."""
    builder = Builder()
    number: dict[int, int] = {}
    wanted = routine.needed() | {n for label in routine.labels for n in label}
    for old, node in enumerate(routine.nodes):
        if old in wanted and all(arg in number for arg in node.args):
            number[old] = rewrite(builder, node, tuple(number[arg] for arg in node.args), old)
    return replace(
        routine,
        nodes=builder.nodes,
        outputs=[[number[n] for n in group] for group in routine.outputs],
        verdicts=[number[n] for n in routine.verdicts],
        labels=[[number.get(n, -1) for n in label] for label in routine.labels],
    )


def share_and_fold(routine: Routine) -> Routine:
    """Common subexpressions once, constants folded, identities removed."""

    def rewrite(builder: Builder, node: Node, args: tuple[int, ...], _: int) -> int:
        return builder.make(node.op, *args) if args else builder.intern(node)

    return rebuild(routine, rewrite)


def share_divisors(routine: Routine) -> Routine:
    """A divisor that is used more than once becomes one reciprocal."""
    needed = routine.needed()
    uses = Counter(
        node.args[1]
        for number, node in enumerate(routine.nodes)
        if number in needed and node.op is Op.DIV
    )
    divisors = {number: 0 for number, count in uses.items() if count > 1}

    def rewrite(builder: Builder, node: Node, args: tuple[int, ...], _: int) -> int:
        if not args:
            return builder.intern(node)
        if node.op is Op.DIV and node.args[1] in divisors:
            reciprocal = builder.make(Op.DIV, builder.constant(1.0), args[1])
            return builder.make(Op.MUL, args[0], reciprocal)
        return builder.make(node.op, *args)

    return rebuild(routine, rewrite)


def divide_early(routine: Routine) -> Routine:
    """A divisor that is known well before its dividend is inverted while that is awaited."""
    ready: list[int] = []
    early: set[int] = set()
    for number, node in enumerate(routine.nodes):
        wait = max((ready[arg] for arg in node.args), default=0)
        if node.op is Op.DIV and ready[node.args[0]] - ready[node.args[1]] >= _LATENCY[Op.DIV]:
            early.add(number)
            ready.append(wait + _LATENCY[Op.MUL])
        else:
            ready.append(wait + _LATENCY.get(node.op, 2))

    def rewrite(builder: Builder, node: Node, args: tuple[int, ...], number: int) -> int:
        if not args:
            return builder.intern(node)
        if number in early:
            reciprocal = builder.make(Op.DIV, builder.constant(1.0), args[1])
            return builder.make(Op.MUL, args[0], reciprocal)
        return builder.make(node.op, *args)

    return rebuild(routine, rewrite)


def simplify(routine: Routine) -> Routine:
    """All passes, until nothing changes."""
    while True:
        simpler = share_divisors(share_and_fold(routine))
        if len(simpler.nodes) == len(routine.nodes):
            return share_and_fold(divide_early(simpler))
        routine = simpler
