"""Functions made of other ones: attempts in turn, loops, sweeps over subsets, calls in a row."""

from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import casadi as ca

from turnbuckle.codegen.chain import Chain
from turnbuckle.codegen.enumeration import Enumeration
from turnbuckle.codegen.fitting import refuse_strangers
from turnbuckle.codegen.ir import Op, Routine
from turnbuckle.model.symbolic.function import (
    ModelFunction,
    Output,
    Repeat,
    Retry,
    Status,
    Verdict,
    judged_by_results,
)


@dataclass(frozen=True)
class Procedure:
    """A function made of items that are tried in turn: see Retry."""

    retry: Retry
    attempts: tuple["Item", ...]
    substitute: "Item"

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
            (*last.verdicts, *second.verdicts),
        )

    @property
    def replaced(self) -> int:
        """Which argument the substitute replaces."""
        names = [argument.name for argument in self.attempts[0].function.inputs]
        return names.index(self.retry.argument)

    def parts(self) -> list["Item"]:
        """Items in the longest sequence they are called in."""
        served = len(self.substitute.function.outputs)
        return [self.attempts[0], self.substitute, *self.attempts * served]


@dataclass(frozen=True)
class Loop:
    """A function that repeats a routine: see Repeat."""

    repeat: Repeat
    begin: Routine
    step: Routine
    finish: Routine

    @property
    def function(self) -> ModelFunction:
        """Arguments, results and verdicts, as if it were one routine."""
        begin, step, finish = (part.function for part in (self.begin, self.step, self.finish))
        unfinished = Verdict(
            ca.SX.sym("unfinished"),
            Status.INACCURATE,
            f"not done after {self.repeat.most} steps",
        )
        return ModelFunction(
            self.repeat.name,
            self.repeat.summary,
            self.repeat.source,
            begin.inputs,
            finish.outputs,
            (*begin.verdicts, *step.verdicts, unfinished, *finish.verdicts),
        )

    @property
    def state(self) -> tuple[Output, ...]:
        """What is carried from step to step."""
        return self.begin.function.outputs

    def parts(self) -> list[Routine]:
        """What is called, in order."""
        return [self.begin, self.step, self.finish]

    @property
    def done(self) -> Output:
        """The last result of a step: positive after the last one."""
        return self.step.function.outputs[-1]


Item = Routine | Procedure | Loop | Enumeration | Chain


def loop(repeat: Repeat, lowered: Callable[[ModelFunction], Routine]) -> Loop:
    """The loop of lowered parts; only `begin` guards the arguments.

    Raises ValueError where the parts do not fit together.
    """
    refuse_misfits(repeat)
    step, finish = (
        replace(part, inputs=tuple(map(judged_by_results, part.inputs)))
        for part in (repeat.step, repeat.finish)
    )
    return Loop(repeat, lowered(repeat.begin), lowered(step), lowered(finish))


def refuse_misfits(repeat: Repeat) -> None:
    """Steps read what there is, write what is carried, and all but the end may only be fine."""
    begin, step, finish = repeat.begin, repeat.step, repeat.finish
    state = {port.name: port.shape for port in begin.outputs}
    known = {port.name: port.shape for port in begin.ports}
    refuse_strangers(step.name, step.inputs, known)
    refuse_strangers(step.name, step.outputs[:-1], state)
    refuse_strangers(finish.name, finish.inputs, known)
    if step.outputs[-1].size != 1:
        raise ValueError(f"{step.name}: its last output is no flag")
    if not all(verdict.is_fault for verdict in (*begin.verdicts, *step.verdicts)):
        raise ValueError(f"{repeat.name}: only {finish.name} may find the problem infeasible")


def made_of(item: Item) -> list[tuple["Item", int]]:
    """What an item calls, and how often at most."""
    if isinstance(item, Procedure):
        return [(part, 1) for part in item.parts()]
    if isinstance(item, Loop):
        return [(item.begin, 1), (item.step, item.repeat.most), (item.finish, 1)]
    if isinstance(item, Enumeration):
        return [(item.begin, 1), (item.visit, len(item.sweep.subsets)), (item.finish, 1)]
    return [(link.item, 1) for link in item.links] if isinstance(item, Chain) else []


def most_steps(item: Item) -> int:
    """How many steps of loops an item takes at most."""
    if isinstance(item, Loop):
        return item.repeat.most
    return sum(most_steps(part) for part, _ in made_of(item))


def most_visits(item: Item) -> int:
    """How many subsets of the cables an item visits at most."""
    if isinstance(item, Enumeration):
        return len(item.sweep.subsets)
    return sum(most_visits(part) for part, _ in made_of(item))


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


def cost(item: Item) -> dict[str, int]:
    """Operations with every branch, step and visit counted, by class."""
    if not isinstance(item, Routine):
        return added([(cost(part), times) for part, times in made_of(item)])
    counts = dict.fromkeys(COSTED, 0)
    for number in item.needed():
        op = item.nodes[number].op
        op = _COST_CLASS.get(op, op)
        if op in counts:
            counts[op] += 1
    names = {Op.LT: "compare"}
    return {names.get(op, op.value): count for op, count in counts.items() if count}


def added(costs: list[tuple[Mapping[str, int], int]]) -> dict[str, int]:
    """Sum of some costs, each taken so many times."""
    counts = Counter[str]()
    for single, times in costs:
        counts.update({name: times * count for name, count in single.items()})
    return dict(counts)


def fingerprint(item: Item) -> str:
    """All that decides what a function computes, as text."""
    if isinstance(item, Procedure):
        return "\n".join([repr(item.retry), *map(fingerprint, item.parts())])
    if isinstance(item, Loop):
        parts = (item.begin, item.step, item.finish)
        names = [[port.name for port in part.function.ports] for part in parts]
        lines = [f"{item.repeat.name} {item.repeat.most} {names}", *map(fingerprint, parts)]
        return "\n".join(lines)
    if isinstance(item, Enumeration):
        parts = (item.begin, item.visit, item.finish)
        names = [[port.name for port in part.function.ports] for part in parts]
        head = f"{item.sweep.name} {item.sweep.matrix} {item.sweep.subsets} {names}"
        return "\n".join([head, *map(fingerprint, parts)])
    if isinstance(item, Chain):
        calls = [f"{sorted(link.call.renamed.items())} {link.call.given!r}" for link in item.links]
        parts_of = [fingerprint(link.item) for link in item.links]
        return "\n".join([item.composition.name, *calls, *parts_of])
    nodes = [f"{n.op.value} {n.args} {n.value!r} {n.entry}" for n in item.nodes]
    return "\n".join([item.function.name, *nodes, repr(item.outputs), repr(item.verdicts)])
