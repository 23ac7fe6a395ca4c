"""CiA 402: every transition of a simulated drive's power stage, its options, and its timing."""

from struct import pack

import pytest
from peer import RATINGS, Bench, booted, command, enable, read, running, status, write

from turnbuckle.lab.drives.power import TRANSITIONS, Command, Power, follow
from turnbuckle.lab.drives.power import command as asked

OFF, READY, ON, ENABLED = 0x40, 0x21, 0x23, 0x27
SHUTDOWN, SWITCH_ON, ENABLE, NO_VOLTAGE, QUICK_STOP, RESET = 0x06, 0x07, 0x0F, 0x00, 0x02, 0x80


def state(word: int) -> int:
    """The pattern of a statusword."""
    return word & (0x4F if word & 0x4F in (0x40, 0x08, 0x0F, 0x00) else 0x6F)


@pytest.mark.parametrize(
    ("number", "commands", "reached"),
    [
        ("2", [SHUTDOWN], READY),
        ("3", [SHUTDOWN, SWITCH_ON], ON),
        ("3 and 4", [SHUTDOWN, ENABLE], ENABLED),
        ("4", [SHUTDOWN, SWITCH_ON, ENABLE], ENABLED),
        ("5", [SHUTDOWN, ENABLE, SWITCH_ON], ON),
        ("6", [SHUTDOWN, SWITCH_ON, SHUTDOWN], READY),
        ("7", [SHUTDOWN, NO_VOLTAGE], OFF),
        ("7 by quick stop", [SHUTDOWN, QUICK_STOP], OFF),
        ("8", [SHUTDOWN, ENABLE, SHUTDOWN], READY),
        ("9", [SHUTDOWN, ENABLE, NO_VOLTAGE], OFF),
        ("10", [SHUTDOWN, SWITCH_ON, NO_VOLTAGE], OFF),
        ("10 by quick stop", [SHUTDOWN, SWITCH_ON, QUICK_STOP], OFF),
        ("11", [SHUTDOWN, ENABLE, QUICK_STOP], 0x07),
        ("12", [SHUTDOWN, ENABLE, QUICK_STOP, NO_VOLTAGE], OFF),
        ("16", [SHUTDOWN, ENABLE, QUICK_STOP, ENABLE], ENABLED),
        ("none: enable from off", [ENABLE], OFF),
        ("none: fault reset without a fault", [SHUTDOWN, RESET | SHUTDOWN], READY),
    ],
)
def test_a_command_makes_its_transition(number: str, commands: list[int], reached: int) -> None:
    bench = booted()
    node = running(bench)
    write(node, 0x605C, 0, 0)
    for word in commands:
        last = command(bench, word)
    assert state(last) == reached


def test_the_table_has_the_transitions_of_cia_402_and_no_other() -> None:
    assert len(TRANSITIONS) == 15
    for power in (Power.NOT_READY, Power.FAULT, Power.FAULT_REACTION):
        assert all(follow(power, each, 6) is power for each in Command)


def test_a_controlword_holds_one_command_as_the_masks_say() -> None:
    masks = [
        (Command.SHUTDOWN, 0x87, 0x06),
        (Command.SWITCH_ON, 0x8F, 0x07),
        (Command.ENABLE, 0x8F, 0x0F),
        (Command.DISABLE_VOLTAGE, 0x02, 0x00),
        (Command.QUICK_STOP, 0x06, 0x02),
    ]
    for word in range(256):
        found = [name for name, mask, value in masks if word & mask == value]
        assert (found or [Command.NONE]) == [asked(word)], word


def test_a_command_acts_at_the_next_sync_and_shows_at_the_one_after() -> None:
    bench = booted()
    running(bench)
    enable(bench)
    for cycle in range(6):
        word, _, torque = status(bench.sync())
        assert torque == (100 * (cycle - 1) if cycle >= 2 else 0), cycle
        bench.send(0x201, pack("<Hh", ENABLE, 100 * (cycle + 1)))
        bench.advance()
        assert word & 0x6F == ENABLED


def test_without_a_sync_nothing_acts() -> None:
    bench = booted()
    running(bench)
    bench.send(0x201, pack("<Hh", SHUTDOWN, 0))
    bench.wait(0.05)
    assert bench.drive.servo.power is Power.OFF


def test_torque_is_that_share_of_the_rated_one_and_never_beyond_the_current_limit() -> None:
    bench = booted()
    running(bench)
    enable(bench)
    command(bench, ENABLE, 500)
    assert bench.drive.servo.torque == pytest.approx(0.5 * RATINGS.rated_torque)
    assert not command(bench, ENABLE, 500) & 1 << 11
    assert command(bench, ENABLE, 3000) & 1 << 11
    assert bench.drive.servo.torque == pytest.approx(4.0 * 0.03)


@pytest.mark.parametrize(
    ("option", "moving", "standing"),
    [(0, OFF, OFF), (1, 7, OFF), (2, 7, OFF), (5, 7, 7), (6, 7, 7)],
)
def test_quick_stop_ends_as_605a_says(option: int, moving: int, standing: int) -> None:
    bench = booted()
    node = running(bench)
    write(node, 0x605A, 0, option)
    enable(bench)
    bench.rotors[0].speed = 60.0
    bench.wait(0.05)
    assert state(command(bench, QUICK_STOP)) == moving
    bench.wait(0.3)
    assert state(command(bench, QUICK_STOP)) == standing
    assert (abs(bench.rotors[0].speed) < 2.0) == (option != 0)


@pytest.mark.parametrize(
    ("index", "word", "reached"), [(0x605C, SWITCH_ON, ON), (0x605B, SHUTDOWN, READY)]
)
def test_operation_is_left_by_a_ramp_where_the_option_says_so(
    index: int, word: int, reached: int
) -> None:
    for option in (0, 1):
        bench = booted()
        node = running(bench)
        write(node, index, 0, option)
        enable(bench)
        bench.rotors[0].speed = 60.0
        bench.wait(0.05)
        assert state(command(bench, word)) == (ENABLED if option else reached)
        bench.wait(0.3)
        assert state(command(bench, word)) == reached
        assert (abs(bench.rotors[0].speed) < 2.0) == bool(option)


def test_the_statusword_tells_voltage_and_remote() -> None:
    bench = booted()
    node = running(bench)
    assert command(bench, NO_VOLTAGE) & 0x0210 == 0x0200
    enable(bench)
    assert command(bench, ENABLE) & 0x1210 == 0x1210
    bench.nmt(0x80)
    assert read(node, 0x6041) & 0x0210 == 0x0010


def test_position_mode_goes_where_it_is_told_and_no_further() -> None:
    bench = booted()
    node = running(bench, mode=8)
    bench.nmt(0x80)
    write(node, 0x1400, 1, 0x80000201)
    write(node, 0x1600, 0, 0)
    write(node, 0x1600, 2, 0x607A0020)
    write(node, 0x1600, 0, 2)
    write(node, 0x1400, 1, 0x201)
    bench.nmt(1)

    def aim(word: int, target: int) -> int:
        bench.send(0x201, pack("<Hi", word, target))
        bench.sync()
        return status(bench.sync())[1]

    for word in (SHUTDOWN, ENABLE):
        aim(word, 0)
    for target in range(0, 4000, 10):
        position = aim(ENABLE, target)
    assert position == pytest.approx(3990, abs=100)
    bench.wait(0.5)
    assert aim(ENABLE, 3990) == pytest.approx(3990, abs=2)
    aim(ENABLE, 10_000)
    assert bench.drive.servo.power in (Power.FAULT_REACTION, Power.FAULT)
    assert read(node, 0x603F) == 0x8611


def test_a_changed_mode_is_shown_once_it_is_active() -> None:
    bench = booted()
    node = running(bench)
    assert read(node, 0x6061) == 10
    write(node, 0x6060, 0, 6)
    assert read(node, 0x6061) == 10
    bench.advance()
    assert read(node, 0x6061) == 6


def test_a_false_statusword_is_reported_whatever_the_state() -> None:
    bench: Bench = booted()
    running(bench)
    bench.drive.servo.false_statusword = 0x0001
    assert command(bench, SHUTDOWN) == 0x0001
    assert bench.drive.servo.power is Power.READY
