"""The master before drives by another hand, on wires that take their time.

What CiA 301 and CiA 402 allow is lived with, from power-on into a wall and back; what must be
refused is, by the right name.
"""

import os
from collections.abc import Callable
from math import dist
from typing import Any

import pytest
from peer_drives import Bus, BusVariation, EncoderFault, Timing, TorqueFault, Upload, Variation
from peer_machine import NANO, PeerMachine, proof
from supervised import Cause

from turnbuckle.codegen.bind import Generated
from turnbuckle.lab.hand import Path
from turnbuckle.lab.lockstep import Lockstep, Request, State
from turnbuckle.model.machine import Machine

DRIVES, CABLES = 8, 4
LONGEST = 30_000
WALL, DEPTH = 0.56, 0.012
"""Where the right wall stands, and how far beyond it the hand goes [m]."""
COUNTS = (2**31 - 2000, -(2**31), 16_777_216, 5, -(2**24), 0, 2**31 - 1, -1)
"""Of the encoders at power-on."""
Kinds = tuple[dict[str, Any], ...]
BURST = round(0.4 / NANO)
ANSWERS: Kinds = (
    {"upload": Upload.NO_SIZE, "fill": 0xA5},
    {"upload": Upload.PADDED},
    {"upload": Upload.SEGMENTED, "segment_bytes": 3},
    {"upload": Upload.SEGMENTED_NO_SIZE, "segment_bytes": 1},
)
HABITS: Kinds = (
    {"restarts": 1, "restart_after": round(0.03 / NANO), "heartbeat_percent": 50},
    {"heartbeat_percent": 200, "any_order": True, "inhibit_jitter": round(1e-3 / NANO)},
    {"status_set": 0x4810, "status_toggle": 0x0180, "transition_delay": round(4e-3 / NANO)},
    {"burst_period": BURST, "burst_count": 3, "reaction_is_command": True},
)


def spread(kinds: Kinds, first: int) -> dict[int, Variation]:
    """A variation for every drive, the first for drive `first`."""
    return {
        (first + number) % DRIVES: Variation(**kinds[number % len(kinds)])
        for number in range(DRIVES)
    }


SLOW = Timing(sdo_delay=round(17e-3 / NANO), seed=2, worst=True)
PLANS: dict[str, tuple[dict[int, Variation], Timing | None]] = {
    "plain": ({}, None),
    "answers": (spread(ANSWERS, 0), None),
    "habits": (spread(HABITS, 2), Timing(sdo_delay=round(2e-3 / NANO), seed=3)),
    "slow answers": (spread((*HABITS, *ANSWERS), 1), SLOW),
}


def into_the_wall(machine: Machine) -> Path:
    """From the middle of the target to the right wall and beyond; there the hand rests."""
    x, y = machine.target.centre
    path = Path((x, y), rest=0.05)
    path.move((WALL + DEPTH, y), 0.8)
    path.rest(0.5)
    return path


@pytest.fixture(scope="module")
def generated(stock: Machine, stock_folder: "os.PathLike[str]") -> Generated:
    """The stock machine, as it is committed."""
    from pathlib import Path as FilePath

    return Generated(stock, FilePath(stock_folder), "double")


def machine_of(generated: Generated, **options: object) -> Lockstep:
    """The master and the drives at power-on."""
    path = into_the_wall(generated.machine)
    made = PeerMachine(generated.machine, path, counts=COUNTS, **options)  # type: ignore[arg-type]
    return Lockstep(generated, made)  # type: ignore[arg-type]


def told(lockstep: Lockstep) -> tuple[str, int]:
    """Cause and culprit."""
    return Cause(int(lockstep.view["cause"])).name, int(lockstep.view["culprit"])


@pytest.mark.parametrize("plan", PLANS)
def test_a_legal_drive_comes_from_power_on_to_work_into_a_wall_and_back(
    generated: Generated, plan: str
) -> None:
    variations, timing = PLANS[plan]
    lockstep = machine_of(generated, variations=variations, timing=timing)
    assert lockstep.bring_up(LONGEST) is State.RUN, told(lockstep)
    press(lockstep)
    lockstep.requests = Request.STOP
    assert lockstep.run_until([State.CONFIGURE, State.FAULT], 2000) is State.CONFIGURE
    simulated: object = lockstep.machine
    assert isinstance(simulated, PeerMachine)
    for number in range(DRIVES):
        counted = simulated.peer.counted(number)
        assert (counted.doubled, counted.short_pdos, counted.dropped) == (0, 0, 0)
        assert counted.lost == 0, f"drive {number}: {counted.lost} of {counted.syncs}"
        assert simulated.peer.torque(number) == 0.0


def press(lockstep: Lockstep) -> None:
    """The hand goes into the wall, which gives it its force back."""
    lockstep.force = (0.0, 0.0)
    lockstep.machine.begin_task()
    lockstep.run(1200)
    world, wall = lockstep.machine.world, 3560.0
    depth = world.position[0] - WALL
    assert lockstep.state is State.RUN, told(lockstep)
    assert depth > 0.2e-3 and dist(world.position, lockstep.machine.hand_goal) > 5e-3
    assert -world.cable_force[0] == pytest.approx(wall * depth, abs=0.7)


def refused(lockstep: Lockstep, most: int = 9000) -> tuple[str, int]:
    """What the machine says instead of arming."""
    assert lockstep.bring_up(most) is State.FAULT
    return told(lockstep)


REFUSALS: dict[str, tuple[Variation, set[str]]] = {
    "another rated torque": (Variation(rated_torque=12_345), {"DRIVE_DIFFERENT"}),
    "an object that reads back otherwise": (
        Variation(misread_index=0x1016, misread_sub=1, misread_xor=1),
        {"DRIVE_SETUP"},
    ),
    "aborts": (
        Variation(abort_index=0x1A00, abort_sub=1, abort_code=0x06040041),
        {"DRIVE_SETUP"},
    ),
    "a toggle bit that stands": (
        Variation(upload=Upload.SEGMENTED, segment_bytes=1, toggle_error=True),
        {"DRIVE_DIFFERENT"},
    ),
    "no power": (Variation(missing=True), {"DRIVE_MISSING"}),
    "not under remote control": (Variation(remote_clear=True), {"DRIVE_LOCAL"}),
    "a statusword of nowhere": (Variation(status_forced=0x026F), {"DRIVE_STATE"}),
    "another mode than ordered": (Variation(mode_display=3), {"DRIVE_SETUP", "DRIVE_STUCK"}),
}


@pytest.mark.parametrize("number", [2, 6])
@pytest.mark.parametrize("what", REFUSALS)
def test_an_illegal_drive_is_refused_by_its_name(
    generated: Generated, what: str, number: int
) -> None:
    variation, causes = REFUSALS[what]
    cause, culprit = refused(machine_of(generated, variations={number: variation}))
    assert cause in causes and culprit == number


BUSES: dict[str, tuple[BusVariation, str]] = {
    "its own SYNC comes back, and nothing else": (BusVariation(echo_sync=True), "OTHER_MASTER"),
    "TIME messages": (BusVariation(time_period=round(0.05 / NANO)), "OTHER_MASTER"),
    "a foreign node": (
        BusVariation(foreign_period=round(0.05 / NANO), foreign_node=17, foreign_state=5),
        "STRANGER",
    ),
}


@pytest.mark.parametrize("number", [0, 2])
@pytest.mark.parametrize("what", BUSES)
def test_a_bus_with_somebody_else_on_it_is_named(
    generated: Generated, what: str, number: int
) -> None:
    variation, cause = BUSES[what]
    buses = [Bus(bit_rate=1_000_000) for _ in generated.machine.buses]
    buses[number].variation = variation
    assert refused(machine_of(generated, buses=buses)) == (cause, number)


@pytest.fixture(scope="module")
def working(generated: Generated) -> Lockstep:
    """A machine in RUN, whose hand moves."""
    lockstep = machine_of(generated, timing=proof(generated.machine))
    assert lockstep.bring_up(LONGEST) is State.RUN, told(lockstep)
    lockstep.force = (0.0, 0.0)
    lockstep.machine.begin_task()
    lockstep.run(300)
    return lockstep


def in_a_copy(act: Callable[[], None]) -> None:
    """In a fork, so that the machine is as before."""
    child = os.fork()
    if child == 0:
        try:
            act()
        except BaseException as error:
            os.write(2, f"{error!r}\n".encode())
            os._exit(1)
        os._exit(0)
    assert os.waitpid(child, 0)[1] == 0


CABLE, BASE = 1, 4  # the base follows the hand
FAULTS: dict[str, tuple[int, Variation, set[str]]] = {
    "base backwards": (BASE, Variation(encoder=EncoderFault.REVERSED), {"WRONG_WAY"}),
    "base frozen": (BASE, Variation(encoder=EncoderFault.FROZEN), {"BASE_BLOCKED"}),
    "base jumps": (
        BASE,
        Variation(encoder=EncoderFault.JUMP, encoder_value=4096.0),
        {"ENCODER_JUMP"},
    ),
    "base without torque": (
        BASE,
        Variation(torque=TorqueFault.NOT_GIVEN, torque_hidden=True),
        {"BASE_BLOCKED", "WRONG_WAY", "BASE_LOST"},
    ),
    "cable backwards": (
        CABLE,
        Variation(encoder=EncoderFault.REVERSED),
        {"CABLE_SLACK", "CABLE_BREAK", "CLOSURE"},
    ),
    "cable frozen": (
        CABLE,
        Variation(encoder=EncoderFault.FROZEN),
        {"CABLE_SLACK", "CABLE_BREAK", "CLOSURE"},
    ),
    "cable jumps": (
        CABLE,
        Variation(encoder=EncoderFault.JUMP, encoder_value=4096.0),
        {"ENCODER_JUMP"},
    ),
}


@pytest.mark.parametrize("what", FAULTS)
def test_a_drive_that_lies_at_work_stops_the_machine(working: Lockstep, what: str) -> None:
    number, variation, causes = FAULTS[what]

    def act() -> None:
        simulated: object = working.machine
        assert isinstance(simulated, PeerMachine)
        simulated.peer.vary(number, variation)
        assert working.run_until([State.FAULT], 3000) is State.FAULT
        cause, culprit = told(working)
        assert cause in causes, cause
        assert culprit == number or cause.startswith(("CABLE", "CLOSURE")), culprit
        assert all(simulated.peer.torque(each) == 0.0 for each in range(DRIVES))

    in_a_copy(act)


def test_drives_that_never_answer_in_time_are_not_taken_for_legal(generated: Generated) -> None:
    # Negative control of the time on the wire: answers beyond what the bus proof allows.
    late = Timing(answer_delay=round(0.9e-3 / NANO), sdo_delay=round(1e-3 / NANO), worst=True)
    cause, _ = refused(machine_of(generated, timing=late), LONGEST)
    assert cause in {"DRIVE_LATE", "DRIVE_SILENT"}
