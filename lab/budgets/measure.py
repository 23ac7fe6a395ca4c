"""Measures the budget of a stock machine."""

from collections.abc import Sequence
from pathlib import Path

from turnbuckle.codegen.bind import Generated
from turnbuckle.lab.budgets.cycle import Counts, count_cycles
from turnbuckle.lab.emulated.image import lockstep_image
from turnbuckle.lab.emulated.processor import M4F
from turnbuckle.lab.live.run import bench_of
from turnbuckle.lab.lockstep import FOLDERS
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine

ROOT = Path(__file__).parents[3]
GENERATED = ROOT / "generated"
AT_STOPS = 0.01
"""Rail coordinate [m] in which every base was left: homing is short."""


def machines() -> list[str]:
    """The stock machines with buses: those that the runtime brings up."""
    return sorted(path.parent.name for path in GENERATED.glob("*/tb_drives.c"))


def counts_of(name: str, folders: Sequence[Path] = FOLDERS) -> Counts:
    """Instructions of cycles in RUN. folders: of the runtime's core and canopen."""
    machine = stock(name)
    bench = bench_of(machine)
    if machine.rails:
        bench = bench._replace(rails=[AT_STOPS] * len(machine.rails))
    generated = Generated(machine, GENERATED / name, M4F.precision)
    image = lockstep_image(M4F, generated.folder, folders=folders)
    return count_cycles(generated, bench.power_on(), image)


def stock(name: str) -> Machine:
    """A stock machine."""
    return load_machine(ROOT / "machines" / f"{name}.toml")
