"""What the project promises about its speed, as rates and against what one would use instead."""

from collections.abc import Sequence
from dataclasses import dataclass
from statistics import geometric_mean

from turnbuckle.lab.benchmark.cycle.cost import CycleRow
from turnbuckle.lab.benchmark.map.comparison import LARGE, LOOP, NUMPY, MapTable
from turnbuckle.lab.benchmark.step.comparison import StepRow
from turnbuckle.lab.benchmark.table1 import Table1
from turnbuckle.lab.benchmark.tension import TensionTable


@dataclass(frozen=True)
class Target:
    """A promised ratio or rate and the one that was measured."""

    what: str
    wanted: float
    measured: float

    @property
    def is_met(self) -> bool:
        """Whether the promise holds in this run."""
        return self.measured >= self.wanted


def targets(
    tension: Sequence[TensionTable],
    table1: Table1,
    step: Sequence[StepRow],
    cycles: Sequence[CycleRow],
    maps: Sequence[MapTable],
) -> list[Target]:
    """All promises."""
    return [
        *solver_targets(tension, step),
        cycle_target(cycles),
        table1_target(table1),
        *map_targets(maps),
    ]


def cycle_target(cycles: Sequence[CycleRow]) -> Target:
    """The promise about a control cycle, buses aside: in both precisions, as most runs had it."""
    slowest = max(row.timing.median for row in cycles)
    return Target("control cycles in 20 us", 1.0, 20e3 / slowest)


def table1_target(table1: Table1) -> Target:
    """The promise about Brau's comparison: against the faster quadratic program."""
    return Target("Brau Table 1, kernel + QP", 6.0, table1.ratio)


def map_targets(maps: Sequence[MapTable]) -> list[Target]:
    """The promises about maps: the rate in the slowest scene, ratios as geometric means of all."""

    def against(name: str) -> float:
        return geometric_mean([table.ratio(name) for table in maps])

    slowest = min(table.rows[0].poses_per_second for table in maps)
    return [
        Target("map, million poses a second", 3.0, slowest / 1e6),
        Target("map, vectorised NumPy", 10.0, against(NUMPY)),
        Target("map, loop over quadprog, SciPy", 1000.0, against(LOOP)),
        Target("map, linear over 16 times the poses", 0.9, 1 / against(LARGE)),
    ]


def solver_targets(tension: Sequence[TensionTable], step: Sequence[StepRow]) -> list[Target]:
    """The promises about the controller.

    For the tension solve the geometric mean over the sets of feasible problems. Infeasible ones
    are no comparison: ours answers with the policy's tensions, peers with nothing.
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
