"""The whole runtime on an emulated Cortex-M, from power-on to a fault: every bit is the host's."""

import re
from contextlib import AbstractContextManager
from pathlib import Path

import pytest
from runtime_copy import seeded_copy

from turnbuckle.codegen.bind import Generated
from turnbuckle.lab.demo import plan_task, plant_of
from turnbuckle.lab.emulated.image import lockstep_image
from turnbuckle.lab.emulated.processor import M4F, M7, Processor
from turnbuckle.lab.emulated.target import Target, TargetError
from turnbuckle.lab.emulated.twin import Difference, Twin, twins
from turnbuckle.lab.lockstep import BusState, Lockstep, State, layouts_of, load
from turnbuckle.lab.machine_sim import SimulatedMachine

ROOT = Path(__file__).parents[2]
NEAR_THEIR_STOPS = [0.012, 0.010, 0.011, 0.009]
"""Rail coordinates [m] in which the bases were left: their homing is short."""
LONGEST = 30_000
"""Cycles from power-on to RUN, at most."""
STACK = 16 * 1024
"""Bytes that the image has for its stack."""
FAULTED = "status 113"
"""What start.c ends with after a fault of the processor."""
CYCLES_TO_ARITHMETIC = 10
"""In so many the program computes with real numbers."""
ONE_BIT = """order->torque = drive->sent;
        static uint32_t orders;
        uint32_t bits;
        __builtin_memcpy(&bits, &order->torque, sizeof bits);
        bits ^= (++orders == 4000u) ? 1u : 0u;
        __builtin_memcpy(&order->torque, &bits, sizeof bits);"""
DEFECT = ("core/setpoints.c", "order->torque = drive->sent;", ONE_BIT)
SEEDED = ROOT / "build" / "seeded" / "one_bit_of_an_order"

Machine = AbstractContextManager[tuple[Lockstep, Twin]]


def power_on(generated: Generated, processor: Processor, image: Path) -> Machine:
    """The stock machine when its supply has just come, its master here and on the processor."""
    machine = generated.machine
    task = plan_task(generated)
    simulated = SimulatedMachine(machine, plant_of(machine), task, NEAR_THEIR_STOPS)
    return twins(generated, simulated, processor, image, Twin)


def bring_up(lockstep: Lockstep) -> None:
    """From power-on to RUN, homing and calibration on the way."""
    assert lockstep.bring_up(LONGEST) is State.RUN, lockstep.view


@pytest.fixture
def on(request: pytest.FixtureRequest) -> Processor:
    """The processor of a test."""
    processor: Processor = request.param
    return processor


@pytest.fixture
def generated(on: Processor, request: pytest.FixtureRequest) -> Generated:
    """The stock machine in the processor's precision."""
    fixture = "double" if on.precision == "double" else "single"
    return request.getfixturevalue(fixture)  # type: ignore[no-any-return]


both = pytest.mark.parametrize("on", [M4F, M7], ids=lambda each: each.name, indirect=True)
on_m4f = pytest.mark.parametrize("on", [M4F], ids=["Cortex-M4F"], indirect=True)


@both
def test_a_machine_is_brought_up_works_and_fails_with_the_bits_of_the_host(
    on: Processor, generated: Generated
) -> None:
    image = lockstep_image(on, generated.folder)
    with power_on(generated, on, image) as (lockstep, twin):
        assert twin.target.facts().part == on.part
        bring_up(lockstep)
        lockstep.machine.begin_task(repeat=True)
        lockstep.run(300)
        assert lockstep.state is State.RUN
        lockstep.set_bus(0, BusState.BUS_OFF)
        assert lockstep.run_until([State.FAULT], 1000) is State.FAULT
        lockstep.run(20)
        twin.compare_last()
        assert twin.cycles == lockstep.cycles > 10_000
        assert twin.frames > 50_000
        assert 0 < twin.target.facts().stack < STACK


@on_m4f
def test_a_contraction_to_fused_operations_is_noticed(on: Processor, generated: Generated) -> None:
    image = lockstep_image(on, generated.folder, ["-ffp-contract=fast"])
    with (
        power_on(generated, on, image) as (lockstep, _),
        pytest.raises(Difference, match=r"cycle \d+: ordered\[\d\]"),
    ):
        bring_up(lockstep)


@on_m4f
def test_one_bit_of_one_order_is_noticed(on: Processor, generated: Generated) -> None:
    image = lockstep_image(on, generated.folder, folders=seeded_copy(SEEDED, DEFECT))
    with (
        power_on(generated, on, image) as (lockstep, _),
        pytest.raises(Difference, match=r"cycle \d+: ordered\[\d\]") as found,
    ):
        bring_up(lockstep)
    here, there = (int(word, 16) for word in re.findall(r"\b[0-9a-f]{8}\b", str(found.value)))
    assert here ^ there == 1


def test_a_program_for_a_cortex_m7_faults_on_a_cortex_m4(double: Generated) -> None:
    """Its arithmetic in double precision ends it: what is emulated is a Cortex-M4."""
    image = lockstep_image(M7, double.folder)
    layouts = layouts_of(load(double))
    wishes, view = (layouts.struct(name).itemsize for name in ("wishes", "view"))
    with Target(M4F, image, view) as target:
        assert target.facts().part == M4F.part
        with pytest.raises(TargetError, match=FAULTED):
            for _ in range(CYCLES_TO_ARITHMETIC):
                target.ask_run(bytes(wishes), 0)
                target.read_view()
                target.read_sent()
