"""What the project promises about its speed, as ratios against what one would use instead."""

from collections.abc import Sequence
from dataclasses import dataclass
from statistics import geometric_mean

from lab.benchmark.step.comparison import StepRow
from lab.benchmark.tension import TensionTable


@dataclass(frozen=True)
class Target:
    """A promised ratio and the one that was measured."""

    what: str
    wanted: float
    measured: float

    @property
    def is_met(self) -> bool:
        """Whether the promise holds in this run."""
        return self.measured >= self.wanted


def targets(tension: Sequence[TensionTable], step: Sequence[StepRow]) -> list[Target]:
    """The promises; for the tension solve the geometric mean over the sets of feasible problems.

    Infeasible ones are no comparison: ours answers with the policy's tensions, peers with nothing.
    """
    solvable = [table for table in tension if table.feasible == table.count]

    def against(solver: str) -> float:
        return geometric_mean([table.ratio(solver) for table in solvable])

    ours, casadi = (row.timing.least for row in step)
    return [
        Target("feasible tension solve, DAQP", 5.0, against("DAQP")),
        Target("feasible tension solve, CasADi qrqp", 50.0, against("CasADi qrqp")),
        Target("controller step, CasADi", 15.0, casadi / ours),
    ]
