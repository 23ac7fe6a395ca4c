"""The power state machine of the drives by another hand, against CiA 402-2."""

from __future__ import annotations

import itertools

import pytest
from peer_bench import (
    CSP,
    CST,
    DISABLE_VOLTAGE,
    ENABLE,
    FAULT_RESET,
    HOMING,
    QUICK_STOP,
    SHUTDOWN,
    SWITCH_ON,
    Bench,
    varied,
)
from peer_drives import MILLISECOND, Library, Power, Variation

NOT_READY, DISABLED, READY, ON, ENABLED, STOPPING, REACTION, FAULT = Power

# The table of CiA 402: from, command, to, transitions.
TRANSITIONS = [
    (DISABLED, SHUTDOWN, READY, (2,)),
    (DISABLED, SWITCH_ON, DISABLED, ()),
    (DISABLED, ENABLE, DISABLED, ()),
    (DISABLED, DISABLE_VOLTAGE, DISABLED, ()),
    (DISABLED, QUICK_STOP, DISABLED, ()),
    (READY, SHUTDOWN, READY, ()),
    (READY, SWITCH_ON, ON, (3,)),
    (READY, ENABLE, ENABLED, (3, 4)),
    (READY, DISABLE_VOLTAGE, DISABLED, (7,)),
    (READY, QUICK_STOP, DISABLED, (7,)),
    (ON, SHUTDOWN, READY, (6,)),
    (ON, SWITCH_ON, ON, ()),
    (ON, ENABLE, ENABLED, (4,)),
    (ON, DISABLE_VOLTAGE, DISABLED, (10,)),
    (ON, QUICK_STOP, DISABLED, (10,)),
    (ENABLED, SHUTDOWN, READY, (8,)),
    (ENABLED, SWITCH_ON, ON, (5,)),
    (ENABLED, ENABLE, ENABLED, ()),
    (ENABLED, DISABLE_VOLTAGE, DISABLED, (9,)),
    (ENABLED, QUICK_STOP, STOPPING, (11,)),
    (STOPPING, SHUTDOWN, STOPPING, ()),
    (STOPPING, SWITCH_ON, STOPPING, ()),
    (STOPPING, ENABLE, ENABLED, (16,)),
    (STOPPING, DISABLE_VOLTAGE, DISABLED, (12,)),
    (STOPPING, QUICK_STOP, STOPPING, ()),
    (FAULT, SHUTDOWN, FAULT, ()),
    (FAULT, ENABLE, FAULT, ()),
    (FAULT, DISABLE_VOLTAGE, FAULT, ()),
    (FAULT, FAULT_RESET, DISABLED, (15,)),
]
WAY = {
    DISABLED: (),
    READY: (SHUTDOWN,),
    ON: (SHUTDOWN, SWITCH_ON),
    ENABLED: (SHUTDOWN, SWITCH_ON, ENABLE),
    STOPPING: (SHUTDOWN, SWITCH_ON, ENABLE, QUICK_STOP),
    FAULT: (),
}
# Statusword patterns: mask, value.
PATTERNS = {
    DISABLED: (0x4F, 0x40),
    READY: (0x6F, 0x21),
    ON: (0x6F, 0x23),
    ENABLED: (0x6F, 0x27),
    STOPPING: (0x6F, 0x07),
    REACTION: (0x4F, 0x0F),
    FAULT: (0x4F, 0x08),
}


@pytest.fixture(scope="module")
def library() -> Library:
    return Library()


def taken(bench: Bench, before: int = 0) -> set[int]:
    return {n for n in range(17) if (bench.peer.counted(0).transitions & ~before) >> n & 1}


def brought_to(library: Library, state: Power, **settings: int) -> Bench:
    bench = Bench(library, [varied(**settings)]).ready()
    for word in (0, *WAY[state]):
        bench.command(word)
    if state == FAULT:
        bench.peer.fail(0, 0x2310)
        bench.command(0)
    assert bench.peer.power(0) == state
    return bench


@pytest.mark.parametrize(("state", "word", "after", "transitions"), TRANSITIONS)
def test_each_command_does_in_each_state_what_the_table_says(
    library: Library, state: Power, word: int, after: Power, transitions: tuple[int, ...]
) -> None:
    bench = brought_to(library, state)
    before = bench.peer.counted(0).transitions
    status = bench.command(word)
    assert bench.peer.power(0) == after
    mask, value = PATTERNS[after]
    assert status & mask == value
    new = taken(bench, before)
    assert new == set(transitions) - {n for n in range(17) if before >> n & 1}


def test_all_transitions_of_the_standard_can_be_taken(library: Library) -> None:
    bench = Bench(library).ready()
    way = [6, 7, 6, 0, 6, 7, 0, 6, 7, 15, 7, 15, 6, 7, 15, 0, 6, 7, 15, 2, 15, 2, 0]
    for word in way:
        bench.command(word)
    bench.peer.fail(0, 0x3210)
    bench.command(0)
    bench.command(FAULT_RESET)
    assert taken(bench) == set(range(17))


@pytest.mark.parametrize("ignored", [0x0000, 0x0010, 0x0070, 0x0100, 0xFE00])
def test_bits_a_command_does_not_have_do_not_matter(library: Library, ignored: int) -> None:
    bench = brought_to(library, DISABLED)
    for word, state in ((SHUTDOWN, READY), (SWITCH_ON, ON), (ENABLE, ENABLED)):
        bench.command(word | ignored)
        assert bench.peer.power(0) == state
    bench.command(DISABLE_VOLTAGE | ignored | 0x0D)
    assert bench.peer.power(0) == DISABLED


def test_a_fault_is_reset_by_a_rising_edge_only(library: Library) -> None:
    bench = brought_to(library, DISABLED)
    bench.command(FAULT_RESET)
    bench.peer.fail(0, 0x2310)
    bench.command(FAULT_RESET)
    assert bench.peer.power(0) == FAULT
    bench.command(0)
    bench.command(FAULT_RESET)
    assert bench.peer.power(0) == DISABLED
    bench.command(0)
    for word in WAY[ENABLED]:
        bench.command(word)
    assert bench.peer.power(0) == ENABLED


def test_a_command_of_before_the_reset_does_not_come_back(library: Library) -> None:
    bench = brought_to(library, FAULT)
    bench.write(0x6040, 0, SHUTDOWN)
    bench.write(0x6040, 0, SHUTDOWN | FAULT_RESET)
    bench.wait(5)
    assert bench.peer.power(0) == DISABLED


@pytest.mark.parametrize("code", [0x2310, 0x8611])
@pytest.mark.parametrize("state", list(WAY))
def test_an_error_leads_from_every_state_to_fault(
    library: Library, state: Power, code: int
) -> None:
    bench = brought_to(library, state)
    bench.peer.fail(0, code)
    assert bench.peer.power(0) == (FAULT if state == FAULT else REACTION)
    assert bench.command(0) & 0x4F == 0x08
    assert {13, 14} <= taken(bench)


@pytest.mark.parametrize(
    ("option", "stays", "ramps"),
    [(0, False, False), (1, False, True), (2, False, True), (5, True, True), (6, True, True)],
)
@pytest.mark.parametrize("mode", [CST, CSP])
def test_a_quick_stop_is_as_605a_says(
    library: Library, mode: int, option: int, stays: bool, ramps: bool
) -> None:
    bench = Bench(library)
    bench.write(0x605A, 0, option)
    bench.write(0x6085, 0, 5000)
    bench.write(0x6084, 0, 5000)
    bench.enabled(mode)
    spin(bench, mode)
    assert bench.peer.object(0, 0x606C) > 500
    bench.command(QUICK_STOP, 0, cycles=2)
    assert bench.peer.power(0) == (STOPPING if ramps else DISABLED)
    bench.wait(1000)
    assert bench.peer.power(0) == (STOPPING if stays else DISABLED)
    assert ramps == (abs(bench.peer.object(0, 0x606C)) <= 20)
    if stays:
        bench.command(ENABLE, bench.peer.object(0, 0x6064))
        assert bench.peer.power(0) == ENABLED


def spin(bench: Bench, mode: int) -> None:
    """The motor turns at some 1000 rpm."""
    target = bench.peer.object(0, 0x6064)
    for _ in range(150):
        target += 33
        bench.command(ENABLE, target if mode == CSP else 100, cycles=1)


@pytest.mark.parametrize("option", [0, 1])
@pytest.mark.parametrize(
    ("index", "word", "after"), [(0x605C, SWITCH_ON, ON), (0x605B, SHUTDOWN, READY)]
)
def test_leaving_operation_is_at_once_or_by_a_ramp(
    library: Library, index: int, word: int, after: Power, option: int
) -> None:
    bench = Bench(library)
    bench.write(index, 0, option)
    bench.write(0x6084, 0, 5000)
    bench.enabled()
    spin(bench, CST)
    bench.command(word, cycles=3)
    assert bench.peer.power(0) == (ENABLED if option else after)
    bench.wait(1000)
    assert bench.peer.power(0) == after
    assert bool(option) == (abs(bench.peer.object(0, 0x606C)) <= 20)


@pytest.mark.parametrize(("option", "ramps"), [(0, False), (1, True), (2, True)])
def test_a_fault_reaction_is_as_605e_says(library: Library, option: int, ramps: bool) -> None:
    bench = Bench(library)
    bench.write(0x605E, 0, option)
    bench.enabled()
    spin(bench, CST)
    bench.peer.fail(0, 0x8A82)
    bench.command(ENABLE, 100, cycles=2)
    assert bench.peer.power(0) == (REACTION if ramps else FAULT)
    bench.wait(1000)
    assert bench.peer.power(0) == FAULT
    assert ramps == (abs(bench.peer.object(0, 0x606C)) <= 20)


def test_a_ramp_decelerates_as_set(library: Library) -> None:
    bench = Bench(library)
    bench.write(0x6085, 0, 2000)  # rpm/s
    bench.enabled()
    spin(bench, CST)
    speed = bench.peer.object(0, 0x606C)
    bench.write(0x6040, 0, QUICK_STOP)
    bench.wait(100)
    assert bench.peer.object(0, 0x606C) == pytest.approx(speed - 200, abs=30)


def test_commands_are_acted_on_after_their_delay(library: Library) -> None:
    bench = Bench(library, [varied(transition_delay=20 * MILLISECOND)]).ready()
    bench.command(SHUTDOWN, cycles=18)
    assert bench.peer.power(0) == DISABLED, "writing it again does not put it off"
    bench.command(SHUTDOWN, cycles=6)
    assert bench.peer.power(0) == READY
    bench.command(ENABLE, cycles=30)
    assert bench.peer.power(0) == ON
    bench.command(ENABLE, cycles=20)
    assert bench.peer.power(0) == ENABLED
    bench.write(0x6060, 0, CSP)
    assert bench.read(0x6061) == CST
    bench.wait(25)
    assert bench.read(0x6061) == CSP


@pytest.mark.parametrize("mode", [1, 3, 6, 8, 9, 10])
def test_the_mode_is_displayed_once_it_is_taken(library: Library, mode: int) -> None:
    bench = Bench(library)
    bench.write(0x6060, 0, mode)
    bench.wait(1)
    assert bench.read(0x6061) == mode
    assert bench.read(0x6502) >> mode - 1 & 1


def test_statusword_bits_by_state_and_mode(library: Library) -> None:
    bench = brought_to(library, DISABLED)
    assert bench.status() == 0x0240
    assert bench.command(SHUTDOWN) == 0x0221
    assert bench.command(SWITCH_ON) == 0x0233
    assert bench.command(ENABLE) == 0x1237, "bit 12: the drive follows"
    assert bench.command(ENABLE, 3000) & 0x0800, "bit 11: more than the current limit"
    assert not bench.command(ENABLE, 0) & 0x0800
    bench.write(0x6060, 0, HOMING)
    assert bench.command(ENABLE) & 0x3400 == 0x0400
    bench.write(0x6060, 0, 1)
    assert bench.command(ENABLE) & 0x3400 == 0


EXTRA = (4, 7, 8, 10, 11, 14, 15)


@pytest.mark.parametrize("bit", EXTRA)
@pytest.mark.parametrize("state", list(WAY))
def test_extra_bits_leave_the_state_as_it_is(library: Library, state: Power, bit: int) -> None:
    mask, value = PATTERNS[state]
    bench = brought_to(library, state, status_set=1 << bit)
    assert bench.status() & mask == value and bench.status() >> bit & 1
    bench.peer.vary(0, Variation(status_toggle=1 << bit))
    word = (*WAY[state], 0)[len(WAY[state]) - 1] if WAY[state] else 0
    seen = [bench.command(word, cycles=1) for _ in range(4)]
    assert all(status & mask == value for status in seen)
    assert [a ^ b for a, b in itertools.pairwise(seen)][1:] == [1 << bit] * 2


def test_the_quick_stop_bit_is_varied_only_where_it_means_nothing(library: Library) -> None:
    for state in WAY:
        mask, value = PATTERNS[state]
        status = brought_to(library, state, status_set=0x20).status()
        assert status & mask == value
        assert bool(status & 0x20) == (state in (DISABLED, READY, ON, ENABLED, FAULT))


def test_the_remote_bit_can_stay_clear(library: Library) -> None:
    assert not brought_to(library, ENABLED, remote_clear=1).status() & 0x0200
