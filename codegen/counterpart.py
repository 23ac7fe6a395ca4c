"""Which constants of a routine correspond to which of another one that computes the same formulas.

The other routine is of a machine that is almost the same: its constants are near those of the first
routine, and a factor of one, which the first routine leaves out, may be almost one there.
"""

from collections.abc import Iterable
from dataclasses import replace
from math import isclose

from turnbuckle.codegen.ir import COMMUTATIVE, Node, Op, Routine
from turnbuckle.codegen.simplify import Builder, rebuild

#: Largest relative difference of two constants that may be the same number of the two machines.
NEAR = 1e-5

#: Where a node is read: the node that reads it and which operand it is; for a root -1 and which.
Place = tuple[int, int]


def counterparts(routine: Routine, other: Routine) -> dict[Place, float]:
    """For the places where `routine` reads a constant, the constant that `other` reads there.

    A place is left out where several constants of `other` correspond to it, or none.
    """
    other = without_ones(other)
    mine, theirs = formulas(routine, other)
    pairs = zip(routine.roots(), other.roots(), strict=True)
    waiting = [((-1, root), *pair) for root, pair in enumerate(pairs)]
    seen: set[tuple[int, int]] = set()
    found: dict[Place, set[float]] = {}
    while waiting:
        place, number, twin = waiting.pop()
        node, image = routine.nodes[number], other.nodes[twin]
        if node.op is not image.op:
            continue
        if node.op is Op.CONSTANT:
            found.setdefault(place, set()).add(image.value)
        elif (number, twin) not in seen:
            seen.add((number, twin))
            formula = [mine[arg] for arg in node.args], [theirs[arg] for arg in image.args]
            twins = in_order(node.op, image.args, *formula)
            operands = enumerate(zip(node.args, twins, strict=False))
            waiting += [((number, operand), *pair) for operand, pair in operands]
    return {place: min(values) for place, values in found.items() if len(values) == 1}


def in_order(op: Op, twins: tuple[int, ...], mine: list[int], theirs: list[int]) -> tuple[int, ...]:
    """The operands of a node's image in the order of the node's own; none where that is not clear.

    mine, theirs: numbers of the formulas of the operands.
    """
    if op not in COMMUTATIVE or any(a == b for a, b in zip(mine, theirs, strict=True)):
        return twins
    swapped = any(a == b for a, b in zip(mine, theirs[::-1], strict=True))
    return twins[::-1] if swapped else ()


def without_ones(routine: Routine) -> Routine:
    """The routine without its factors that are almost one."""

    def rewrite(builder: Builder, node: Node, args: tuple[int, ...], _: int) -> int:
        if node.op is Op.MUL:
            for factor, rest in (args, args[::-1]):
                value = builder.value(factor)
                if value is not None and isclose(value, 1.0, rel_tol=NEAR):
                    return rest
        return builder.intern(replace(node, args=args))

    return rebuild(routine, rewrite)


def formulas(*routines: Routine) -> list[dict[int, int]]:
    """For the needed nodes of each routine a number that nodes of one formula share."""
    near = clusters(routine.nodes[node].value for routine in routines for node in routine.order)
    known: dict[tuple[object, ...], int] = {}
    result = []
    for routine in routines:
        numbers: dict[int, int] = {}
        for number in routine.order:
            node = routine.nodes[number]
            args = [numbers[arg] for arg in node.args]
            args = sorted(args) if node.op in COMMUTATIVE else args
            formula = (node.op, near[node.value], node.entry, *args)
            numbers[number] = known.setdefault(formula, len(known))
        result.append(numbers)
    return result


def clusters(values: Iterable[float]) -> dict[float, int]:
    """For each value a number that values near it share."""
    result: dict[float, int] = {}
    last, cluster = 0.0, 0
    for value in sorted(set(values)):
        cluster += not isclose(value, last, rel_tol=NEAR)
        result[value], last = cluster, value
    return result
