"""Measures the budget of a stock machine."""

from pathlib import Path

from turnbuckle.codegen.bind import Generated
from turnbuckle.lab.budgets.cycle import Counts, count_cycles
from turnbuckle.lab.live.run import bench_of
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine

ROOT = Path(__file__).parents[3]
GENERATED = ROOT / "generated"
AT_STOPS = 0.01
"""Rail coordinate [m] in which every base was left: homing is short."""


def machines() -> list[str]:
    """The stock machines with buses: those that the runtime brings up."""
    return sorted(path.parent.name for path in GENERATED.glob("*/tb_drives.c"))


def counts_of(name: str) -> Counts:
    """Instructions of cycles in RUN."""
    machine = stock(name)
    bench = bench_of(machine)
    if machine.rails:
        bench = bench._replace(rails=[AT_STOPS] * len(machine.rails))
    return count_cycles(Generated(machine, GENERATED / name, "float"), bench.power_on())


def stock(name: str) -> Machine:
    """A stock machine."""
    return load_machine(ROOT / "machines" / f"{name}.toml")
