"""The compiled runtime brings eight simulated drives up, works, and stops: in lockstep."""

import io
import os
from collections.abc import Callable
from dataclasses import replace
from math import dist, hypot
from pathlib import Path
from struct import pack
from typing import NamedTuple

import numpy as np
import pytest
import variants

from turnbuckle.codegen.bind import Generated
from turnbuckle.lab.bus_tap import CandumpLog, Fingerprint, SetpointWatch
from turnbuckle.lab.demo import plan_task, plant_of
from turnbuckle.lab.drives.bus import SimulatedBus
from turnbuckle.lab.drives.node import Frame
from turnbuckle.lab.drives.power import Power
from turnbuckle.lab.drives.setup import Identity, Setup
from turnbuckle.lab.lockstep import Lockstep, Request, State
from turnbuckle.lab.machine_sim import SimulatedMachine
from turnbuckle.lab.task import Task
from turnbuckle.model.bus.axis import axes
from turnbuckle.model.problem import MachineError
from turnbuckle.model.reading import load_machine

SOMEWHERE = [0.15, 0.11, 0.13, 0.09]
"""Rail coordinates [m] in which the bases were left."""
READY = 4
"""TB_PHASE_READY."""


class Running(NamedTuple):
    """A machine in RUN."""

    lockstep: Lockstep
    watch: SetpointWatch
    cycles: int
    """That the bring-up took."""
    fingerprint: str
    """Of all frames until then."""


@pytest.fixture(scope="module")
def generated() -> Generated:
    """The stock machine."""
    return variants.committed()


@pytest.fixture(scope="module")
def task(generated: Generated) -> Task:
    """What is done with it."""
    return plan_task(generated)


Build = Callable[..., Lockstep]


@pytest.fixture(scope="module")
def build(generated: Generated, task: Task) -> Build:
    """Makes the machine at power-on."""

    def made(rails: list[float]) -> Lockstep:
        machine = generated.machine
        simulated = SimulatedMachine(machine, plant_of(machine), task, rails)
        return Lockstep(generated, simulated)

    return made


def arm(lockstep: Lockstep) -> None:
    """Ask for HOME once everything is ready for it."""
    for _ in range(3000):
        lockstep.cycle()
        ready = lockstep.state is State.CONFIGURE and lockstep.view["phase"] == READY
        lockstep.requests = Request.ARM if ready and lockstep.cycles % 2 else Request(0)
        if lockstep.state is State.HOME:
            break
    lockstep.requests = Request(0)
    assert lockstep.state is State.HOME, words(lockstep)


def bring_up(lockstep: Lockstep) -> None:
    """From power-on to RUN."""
    arm(lockstep)
    assert lockstep.run_until([State.RUN, State.FAULT], 60_000) is State.RUN, words(lockstep)


def words(lockstep: Lockstep) -> str:
    """What the supervisor says."""
    view = lockstep.view
    names = ("state", "phase", "cause", "culprit", "index", "subindex", "failure", "detail")
    return ", ".join(f"{name} {int(view[name]):#x}" for name in names)


@pytest.fixture(scope="module")
def run(generated: Generated, build: Build) -> Running:
    """A machine in RUN, brought up from power-on."""
    lockstep = build(SOMEWHERE)
    watch = SetpointWatch(generated.machine)
    lockstep.taps.append(watch)
    fingerprint = Fingerprint(lockstep.machine.buses)
    bring_up(lockstep)
    return Running(lockstep, watch, lockstep.cycles, fingerprint.hexdigest())


def in_a_copy(act: Callable[[], None]) -> None:
    """Run it in a fork, so that what it does to the machine is not there afterwards."""
    child = os.fork()
    if child == 0:
        try:
            act()
        except BaseException as error:
            os.write(2, f"{error!r}\n".encode())
            os._exit(1)
        os._exit(0)
    assert os.waitpid(child, 0)[1] == 0


def test_eight_drives_are_brought_from_power_on_to_work(
    run: Running,
) -> None:
    lockstep, watch = run.lockstep, run.watch
    assert {drive.servo.power for drive in lockstep.machine.drives} == {Power.ENABLED}
    assert watch.findings == [] and watch.seen > 5 * run.cycles
    assert min(lockstep.machine.world.tensions) > 2.0


def test_the_zeros_of_cables_and_rails_are_right_to_some_counts(
    run: Running,
) -> None:
    lockstep = run.lockstep
    simulated = lockstep.machine
    cable, *_, base = axes(variants.committed().machine)
    view = lockstep.view
    np.testing.assert_allclose(view["zeros"], simulated.zeros, atol=4 * cable.metres_per_increment)
    np.testing.assert_allclose(view["pose"], simulated.world.position, atol=30e-6)
    measured = view["position"][len(simulated.zeros) :]
    atol = 2 * base.metres_per_increment + 1e-3  # they are on their way
    np.testing.assert_allclose(measured, simulated.world.rails, atol=atol)


def test_the_forces_of_the_task_are_delivered(run: Running) -> None:
    def act() -> None:
        lockstep, watch = run.lockstep, run.watch
        simulated = lockstep.machine
        simulated.begin_task()
        assert simulated.task is not None
        turn = simulated.task.phase("turn")
        errors, wanted = [], []
        begin = lockstep.cycles
        while lockstep.cycles - begin < turn.end * 1000:
            lockstep.cycle()
            if simulated.task_force != (0.0, 0.0):
                wanted.append(simulated.task_force)
                errors.append(dist(simulated.world.cable_force, simulated.task_force))
        assert lockstep.state is State.RUN, words(lockstep)
        assert watch.findings == []
        assert max(hypot(*force) for force in wanted) > 4.0
        # The bare controller step on the bench, without buses and encoders, leaves 0.49 N (rms).
        assert np.sqrt(np.mean(np.square(errors))) < 0.6

    in_a_copy(act)


def test_a_soft_stop_ends_without_torque_and_can_be_armed_again(
    run: Running,
) -> None:
    def act() -> None:
        lockstep, watch = run.lockstep, run.watch
        lockstep.requests = Request.STOP
        lockstep.cycle()
        assert lockstep.state is State.SOFT_STOP
        assert lockstep.run_until([State.CONFIGURE, State.FAULT], 1500) is State.CONFIGURE
        lockstep.requests = Request(0)
        lockstep.run(100)
        assert all(drive.servo.torque == 0.0 for drive in lockstep.machine.drives)
        assert watch.findings == []
        arm(lockstep)

    in_a_copy(act)


def test_two_machines_that_are_treated_the_same_say_the_same_to_the_bit(
    run: Running, build: Build
) -> None:
    again = build(SOMEWHERE)
    fingerprint = Fingerprint(again.machine.buses)
    bring_up(again)
    assert (again.cycles, fingerprint.hexdigest()) == (run.cycles, run.fingerprint)
    again.cycle()
    assert fingerprint.hexdigest() != run.fingerprint  # negative control: one cycle more


@pytest.mark.parametrize("fault", ["identity", "twice", "missing"])
def test_a_machine_with_the_wrong_drives_is_not_armed(fault: str, build: Build) -> None:
    lockstep = build(SOMEWHERE)
    bus = lockstep.machine.buses[2]
    drive = bus.drive(3)
    if fault == "identity":
        drive.setup = replace(drive.setup, identity=Identity(vendor=1))
        drive.switch_on()
    elif fault == "twice":
        lockstep.machine.add_stranger(2, Setup(3))
    else:
        drive.shut_down()
    assert lockstep.run_until([State.HOME, State.FAULT], 4000) is State.FAULT
    view = lockstep.view
    assert int(view["culprit"]) == 6
    assert all(each.servo.torque == 0.0 for each in lockstep.machine.drives)


def test_the_watch_finds_setpoints_that_must_not_be(generated: Generated) -> None:
    # Negative control: each of these is one defect.
    def findings(*frames: tuple[int, bytes]) -> str:
        watch = SetpointWatch(generated.machine)
        for cob, data in frames:
            watch(0, Frame(cob, data))
        return " ".join(watch.findings)

    def torque(permille: int, word: int = 0x0F) -> tuple[int, bytes]:
        return 0x201, pack("<Hh", word, permille)

    sync = (0x080, b"")
    assert findings(sync, torque(0), sync, torque(10), sync) == ""
    assert "outside" in findings(torque(-1))
    assert "outside" in findings(torque(1200, word=0x06))
    assert "at once" in findings(torque(0), sync, torque(900))
    assert "0 setpoints" in findings(torque(0), sync, sync)
    assert "2 setpoints" in findings(torque(0), torque(0), sync)
    assert "3 bytes" in findings((0x201, b"\x0f\x00\x00"))
    assert findings(torque(0), sync, (0x000, b"\x82\x01"), sync) == ""


def test_a_log_reads_as_candump_writes_it() -> None:
    bus, file = SimulatedBus("cable1", []), io.StringIO()
    log = CandumpLog([bus], file)
    log.time = 1.25
    bus.send(Frame(0x201, b"\x0f\x00\xf4\x01"))
    assert file.getvalue() == "(0000000001.250000) cable1 201#0F00F401\n"


def test_a_machine_without_buses_is_refused_in_one_line(tmp_path: Path) -> None:
    machine = load_machine(variants.write(variants.fixed("busless", variants.CORNERS), tmp_path))
    with pytest.raises(MachineError) as refused:
        SimulatedMachine(machine, plant_of(machine), plan_task(variants.committed()))
    assert "bus: found nothing" in str(refused.value) and "\n" not in str(refused.value)
