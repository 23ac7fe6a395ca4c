"""Errors of a simulated drive: emergencies, heartbeats, and what only a reset clears."""

from struct import pack, unpack

import pytest
from peer import Bench, abort_code, booted, command, enable, read, running, write

from turnbuckle.lab.drives.errors import Reaction, reaction
from turnbuckle.lab.drives.node import Frame
from turnbuckle.lab.drives.power import Power
from turnbuckle.model.bus.drive_kinds import epos4

SHUTDOWN, ENABLE, RESET = 0x06, 0x0F, 0x80
MASTER = 0x77F
FAULT, OFF = Power.FAULT, Power.OFF


def emergencies(frames: list[Frame]) -> list[tuple[int, int]]:
    """Code and error register of every emergency message."""
    return [unpack("<HB", frame.data[:3]) for frame in frames if frame.cob == 0x081]


def watching(option: int = 3) -> Bench:
    """An enabled drive that watches the master's heartbeat: 40 ms, first one heard."""
    bench = booted()
    node = running(bench)
    write(node, 0x1016, 1, 0x7F0028)
    write(node, 0x6007, 0, option)
    enable(bench)
    bench.send(MASTER, b"\x05")
    bench.wait(0.0)
    return bench


@pytest.mark.parametrize("code", [0x2310, 0x3210, 0x4210, 0x5113, 0x6320, 0x7380, 0x8611, 0x8210])
def test_an_error_is_told_once_takes_the_torque_and_can_be_reset(code: int) -> None:
    bench = booted()
    node = running(bench)
    write(node, 0x6007, 0, 2)
    write(node, 0x605E, 0, 0)
    enable(bench)
    command(bench, ENABLE, 500)
    bench.drive.raise_error(code)
    frames = bench.wait(0.05)
    ((told, register),) = emergencies(frames)
    assert told == code and register & 1 and register == read(node, 0x1001)
    assert bench.drive.servo.power is FAULT and bench.drive.servo.torque == 0.0
    assert read(node, 0x1003, 1) & 0xFFFF == code == read(node, 0x603F)
    assert command(bench, SHUTDOWN) & 0x4F == 0x08
    assert command(bench, RESET) & 0x4F == 0x40
    assert read(node, 0x1001) == 0 and read(node, 0x603F) == 0


def test_the_end_of_an_error_is_told_too() -> None:
    bench = booted()
    running(bench)
    bench.drive.raise_error(0x2310)
    bench.wait(0.01)
    bench.send(0x201, pack("<Hh", RESET, 0))
    assert emergencies(bench.sync()) == [(0x0000, 0)]


def test_a_fault_reset_is_an_edge() -> None:
    bench = booted()
    running(bench)
    command(bench, RESET)
    bench.drive.raise_error(0x2310)
    bench.wait(0.01)
    assert command(bench, RESET) & 0x4F == 0x08
    command(bench, 0)
    assert command(bench, RESET) & 0x4F == 0x40


def test_a_warning_only_sets_its_bit() -> None:
    bench = booted()
    running(bench)
    enable(bench)
    bench.drive.raise_error(0xFF01)
    assert command(bench, ENABLE) & 0xFF == 0xB7


def test_the_history_keeps_the_newest_first_and_can_be_cleared() -> None:
    bench = booted()
    node = running(bench)
    for code in (0x2310, 0x3210, 0x4210, 0x5113, 0x6320, 0x7320):
        bench.drive.raise_error(code)
    assert [read(node, 0x1003, sub) for sub in range(6)] == [
        5, 0x7320, 0x6320, 0x5113, 0x4210, 0x3210,
    ]  # fmt: skip
    write(node, 0x1003, 0, 0)
    assert [read(node, 0x1003, sub) for sub in range(6)] == [0] * 6


def test_a_reaction_with_a_ramp_stands_still_before_it_is_a_fault() -> None:
    bench = booted()
    running(bench)  # 605E is 2 as delivered: quick stop ramp
    enable(bench)
    bench.rotors[0].speed = 60.0
    bench.wait(0.05)
    bench.drive.raise_error(0x8611)
    assert command(bench, ENABLE) & 0x4F == 0x0F
    bench.wait(0.3)
    assert bench.drive.servo.power is FAULT and abs(bench.rotors[0].speed) < 2.0


def test_without_a_first_heartbeat_none_is_missed() -> None:
    bench = booted()
    node = running(bench)
    write(node, 0x1016, 1, 0x7F0028)
    enable(bench)
    bench.wait(1.0)
    assert bench.drive.servo.power is Power.ENABLED


@pytest.mark.parametrize("option", [1, 2, 3])
def test_a_lost_heartbeat_takes_the_torque_in_time(option: int) -> None:
    bench = watching(option)
    for _ in range(5):
        assert emergencies(bench.wait(0.039)) == []
        bench.send(MASTER, b"\x05")
    frames = bench.wait(0.041)
    assert [code for code, _ in emergencies(frames)] == [0x8130]
    bench.wait(1.0)
    assert bench.drive.servo.power is FAULT and bench.drive.servo.torque == 0.0
    assert bench.send(0x080) == []  # pre-operational: no status messages any more


def test_a_lost_heartbeat_may_change_nothing_but_the_nmt_state() -> None:
    bench = watching(0)
    bench.wait(0.1)
    assert bench.drive.servo.power is Power.ENABLED and bench.send(0x080) == []


def test_after_a_lost_heartbeat_only_a_reset_of_communication_lets_the_fault_go() -> None:
    bench = watching()
    bench.wait(1.0)
    bench.nmt(1)
    for word in (0, RESET, 0, RESET):
        assert command(bench, word) & 0x4F == 0x08
    bench.nmt(0x82)
    assert [frame.data for frame in bench.wait(0.1)] == [b"\0"]
    node = running(bench)
    command(bench, 0)
    assert command(bench, RESET) & 0x4F == 0x40
    assert read(node, 0x603F) == 0


def test_the_errors_that_latch_are_those_of_the_connection() -> None:
    latched = epos4.KIND.simulated.latched
    assert all(reaction(epos4.KIND, code) is Reaction.ABORT_OPTION for code in latched)


def test_a_drive_tells_its_nmt_state_at_the_interval_it_was_told() -> None:
    bench = booted()
    node = running(bench)
    write(node, 0x1017, 0, 20)
    assert [frame.data for frame in bench.wait(0.1) if frame.cob == 0x701] == [b"\x05"] * 5
    bench.nmt(2)
    assert [frame.data for frame in bench.wait(0.04) if frame.cob == 0x701] == [b"\x04"] * 2
    bench.nmt(0x80)
    assert [frame.data for frame in bench.wait(0.04) if frame.cob == 0x701] == [b"\x7f"] * 2


def test_a_reset_brings_back_what_was_delivered_and_a_boot_up_message() -> None:
    bench = booted()
    node = running(bench)
    write(node, 0x6007, 0, 2)
    bench.nmt(0x82)
    assert bench.send(0x601, pack("<BHBI", 0x40, 0x6041, 0, 0)) == []  # it boots
    assert bench.wait(0.1) == [Frame(0x701, b"\0")]
    assert read(node, 0x1600, 0) == 1 and read(node, 0x6007) == 2
    bench.nmt(0x81)
    bench.wait(0.5)
    assert read(node, 0x6007) == 3


def test_a_reset_takes_the_torque() -> None:
    for reset in (0x81, 0x82, 0x02):
        bench = booted()
        write(running(bench), 0x6007, 0, 2)
        enable(bench)
        command(bench, ENABLE, 500)
        bench.nmt(reset)
        bench.wait(0.5)
        assert bench.drive.servo.torque == 0.0, reset


def test_a_message_that_is_too_short_is_an_error() -> None:
    bench = booted()
    running(bench)
    assert [code for code, _ in emergencies(bench.send(0x201, b"\x06"))] == [0x8210]


def test_a_frame_on_a_default_message_moves_a_drive_that_was_not_told_to_ignore_it() -> None:
    # As delivered every RPDO listens: this is why the runtime makes the others invalid.
    bench = booted()
    bench.nmt(1)
    bench.send(0x501, pack("<Hh", SHUTDOWN, 0))
    assert bench.drive.servo.power is Power.READY
    configured = booted()
    running(configured)
    configured.send(0x501, pack("<Hh", SHUTDOWN, 0))
    configured.sync()
    assert configured.drive.servo.power is OFF


def test_a_drive_without_supply_is_silent_and_boots_when_it_is_back() -> None:
    bench = booted()
    running(bench)
    enable(bench)
    bench.drive.shut_down()
    assert bench.wait(0.5) == [] and bench.drive.servo.torque == 0.0
    bench.drive.switch_on()
    assert bench.wait(0.5) == [Frame(0x701, b"\0")]


def test_a_muted_drive_still_hears() -> None:
    bench = booted()
    running(bench)
    bench.drive.silent = True
    bench.send(0x201, pack("<Hh", SHUTDOWN, 0))
    assert bench.sync() == [] and bench.drive.servo.power is Power.READY


def test_transmission_types() -> None:
    bench = booted()
    node = running(bench)
    bench.nmt(0x80)
    assert abort_code(lambda: write(node, 0x1800, 1, 0x40000182)) == 0x06090030
    write(node, 0x1800, 2, 3)
    bench.nmt(1)
    assert [len(bench.sync()) for _ in range(6)] == [0, 0, 1, 0, 0, 1]
    bench.nmt(0x80)
    write(node, 0x1800, 2, 0)
    bench.nmt(1)
    assert [len(bench.sync()) for _ in range(3)] == [1, 0, 0]
    bench.nmt(0x80)
    write(node, 0x1800, 2, 255)
    bench.nmt(1)
    assert len(bench.wait(0.05)) == 1  # an event: the first value
    assert bench.sync() == []
