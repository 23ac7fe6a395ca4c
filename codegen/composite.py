"""Functions made of other ones: attempts in turn, loops of bounded length."""

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import casadi as ca

from codegen.ir import Op, Routine
from model.symbolic.function import (
    ModelFunction,
    Output,
    Port,
    Repeat,
    Retry,
    Status,
    Verdict,
    judged_by_results,
)

Shape = tuple[int, ...]


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

    @property
    def done(self) -> Output:
        """The last result of a step: positive after the last one."""
        return self.step.function.outputs[-1]


Item = Routine | Procedure | Loop


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


def refuse_strangers(part: str, ports: Sequence[Port], known: Mapping[str, Shape]) -> None:
    """A part of a loop names what is there, in the shape it has."""
    for port in ports:
        if known.get(port.name) != port.shape:
            raise ValueError(f"{part}: {port.name} {port.shape} is none of {dict(known)}")


def most_steps(item: Item) -> int:
    """How many steps of loops an item takes at most."""
    if isinstance(item, Loop):
        return item.repeat.most
    return sum(map(most_steps, item.parts())) if isinstance(item, Procedure) else 0


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
    """Operations with every branch and every step counted, by class."""
    if isinstance(item, Procedure):
        return added([(cost(part), 1) for part in item.parts()])
    if isinstance(item, Loop):
        most = item.repeat.most
        return added([(cost(item.begin), 1), (cost(item.step), most), (cost(item.finish), 1)])
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
    nodes = [f"{n.op.value} {n.args} {n.value!r} {n.entry}" for n in item.nodes]
    return "\n".join([item.function.name, *nodes, repr(item.outputs), repr(item.verdicts)])
