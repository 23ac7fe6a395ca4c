"""Every stock machine with buses comes up on wires that take time, at the proof's worst too."""

from pathlib import Path

import pytest
import variants
from seeded import runtime_with

from turnbuckle.codegen.bind import Generated
from turnbuckle.lab.demo import plan_task, plant_of
from turnbuckle.lab.drives.wire import WIRES, Conditions
from turnbuckle.lab.lockstep import Lockstep, State
from turnbuckle.lab.machine_sim import SimulatedMachine
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine

ROOT = variants.ROOT
MACHINES = [
    path.stem
    for path in sorted((ROOT / "machines").glob("*.toml"))
    if (ROOT / "generated" / path.stem / "tb_drives.h").exists()
]
IMPATIENT = (
    "core/measurement.c",
    "return measurement->tracks[drive].age < tb_buses[tb_drives[drive].bus].divider;",
    "return measurement->tracks[drive].age == 0;",
)
SWEEP = 20
"""TB_PHASE_SWEEP."""
LONGEST = 40_000
SHORTEST_SWEEP = 24_000
"""Cycles in which a machine that can be calibrated is calibrated."""


def simulated(machine: Machine, generated: Generated, conditions: Conditions) -> SimulatedMachine:
    """The machine at power-on; what turns is led by hand, which takes a tenth of the time."""
    if machine.is_rigid:
        return SimulatedMachine(machine, None, None, conditions=conditions)
    plant, task = plant_of(machine), plan_task(generated)
    return SimulatedMachine(machine, plant, task, conditions=conditions)


def lockstep(name: str, conditions: Conditions, precision: str = "double") -> Lockstep:
    """A stock machine, switched on."""
    machine = load_machine(ROOT / "machines" / f"{name}.toml")
    generated = Generated(machine, ROOT / "generated" / name, precision)
    return Lockstep(generated, simulated(machine, generated, conditions))


@pytest.mark.parametrize("wire", WIRES)
@pytest.mark.parametrize("name", MACHINES)
def test_a_stock_machine_comes_from_power_on_to_work(name: str, wire: str) -> None:
    machine = lockstep(name, WIRES[wire], "float" if wire == "disturbed" else "double")
    assert machine.bring_up(LONGEST) is State.RUN, machine.view
    error = abs(machine.view["zeros"] - machine.machine.zeros).max()
    assert error < 100e-6, f"zeros are off by {1e6 * error:.0f} um"
    machine.run(500)
    assert machine.state is State.RUN and machine.lost == 0


def test_a_calibration_that_waits_for_all_drives_in_one_cycle_never_ends() -> None:
    # Negative control: what the wire found. The last of four base drives answers after the
    # compute phase, so that its answer never comes in the cycle of the others'.
    machine = lockstep("yoon2023", Conditions(worst=True))
    machine.exchange_runtime(runtime_with("impatient", IMPATIENT))
    assert machine.bring_up(SHORTEST_SWEEP) is not State.RUN
    assert machine.view["state"] == State.FAULT or machine.view["phase"] == SWEEP


def test_the_machines_with_buses_are_tried() -> None:
    assert {"yoon2023", "yoon_fixed_diagonal", "spidar_g"} <= set(MACHINES)
    assert all(Path(ROOT / "generated" / name).is_dir() for name in MACHINES)
