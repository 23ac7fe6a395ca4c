"""Loops, lowered."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import casadi as ca

from turnbuckle.codegen.fitting import refuse_strangers
from turnbuckle.codegen.ir import Routine
from turnbuckle.codegen.item import Item
from turnbuckle.model.symbolic.function import (
    ModelFunction,
    Output,
    Repeat,
    Status,
    Verdict,
    judged_by_results,
)


@dataclass(frozen=True)
class Loop(Item):
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
    def steps(self) -> int:
        """Most steps of its own loop."""
        return self.repeat.most

    def calls(self) -> Sequence[tuple[Item, int]]:
        """Begin once, the step at most so often, the finish once."""
        return [(self.begin, 1), (self.step, self.repeat.most), (self.finish, 1)]

    def own(self) -> Sequence[Item]:
        """What it alone calls."""
        return [self.begin, self.step, self.finish]

    def text(self) -> str:
        """Its name, and how its parts are called."""
        parts = (self.begin, self.step, self.finish)
        names = [[port.name for port in part.function.ports] for part in parts]
        return f"{self.repeat.name} {self.repeat.most} {names}"

    @property
    def done(self) -> Output:
        """The last result of a step: positive after the last one."""
        return self.step.function.outputs[-1]


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
