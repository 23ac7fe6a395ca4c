"""The network of drives against python canopen's nodes: routes, freshness, setpoints, faults."""

import math
import struct
import tomllib
from collections.abc import Callable
from ctypes import addressof, byref, c_void_p
from functools import cache
from pathlib import Path
from random import Random
from typing import Any

import jinja2
import numpy as np
import pytest
from canopen_bench import Bench
from canopen_c import ROOT, SOURCES, Canopen, Frame, canopen_c
from hypothesis import given, settings
from hypothesis import strategies as st

from turnbuckle.codegen.bus.drives import drive_fields
from turnbuckle.codegen.generate import TEMPLATES
from turnbuckle.model.reading import machine_from

C = canopen_c()
CABLE, BASE = 0, 4
"""Drives: the first of its bus, at 1 kHz and at 500 Hz."""
SLOW_BUS = 2
STOCK = ROOT / "machines" / "yoon2023.toml"
HEARTBEAT_CYCLES, HEARTBEAT_TIMEOUT = 10, 100


@pytest.fixture
def bench() -> Bench:
    """Eight drives that nobody has spoken to."""
    return Bench()


@pytest.fixture
def running() -> Bench:
    """Eight drives under torque, all calm, at a cycle in which every bus has a SYNC next."""
    bench = Bench()
    bench.enable()
    bench.cycle(bench.network.cycle % 2)
    return bench


def fields(bench: Bench, name: str) -> list[Any]:
    """A field of all drives' reports."""
    return [getattr(drive, name) for drive in bench.seen.drives]


def status(node: int, statusword: int = 0x0237, position: int = 0, torque: int = 0) -> Frame:
    """A TPDO1."""
    return Frame(0x180 + node, struct.pack("<Hih", statusword, position, torque))


def silence(bench: Bench, drive: int, function: int = 0x180) -> None:
    """A drive's messages of one function get lost."""
    row = bench.rows[drive]
    lost = (row.bus, function + row.node)
    bench.answers = lambda bus, frame: [] if (bus, frame.id) == lost else [frame]


# ---- A cycle ----


def test_all_drives_are_brought_under_torque(bench: Bench) -> None:
    bench.enable()
    assert {drive.machine.power for drive in bench.drives} == {"ENABLED"}
    assert set(fields(bench, "silent")) == {0}
    assert set(fields(bench, "missed")) == {0}
    assert [(bus.state, bus.malformed, bus.stranger, bus.refused) for bus in bench.seen.buses] == [
        (0, 0, 0, 0)
    ] * 3


def test_a_sync_goes_out_on_every_bus_that_is_due(bench: Bench) -> None:
    for cycle in range(6):
        bench.sync()
        sync = [Frame(0x080, b"")]
        assert bench.synced == [sync, sync, sync if cycle % 2 == 0 else []]
        bench.collect()
        bench.dispatch()


def test_before_a_drive_is_operational_it_gets_no_setpoint(bench: Bench) -> None:
    bench.order(goal=C.TB_GOAL_ENABLED, torque=0.01)
    for name in ("RESET", "IDENTIFY", "CONFIGURE", "START"):
        bench.order(task=getattr(C, f"TB_TASK_{name}"))
        while True:
            bench.cycle()
            if all(done == C.TB_TASK_DONE for done in fields(bench, "progress")):
                break
            in_service = [link.setup.operational for link in bench.network.links]
            got = [bool(drive.setpoints) for drive in bench.drives]
            assert not any(g and not s for g, s in zip(got, in_service, strict=True))
    assert {target for drive in bench.drives for _, target in drive.setpoints} <= {0}


def test_a_command_acts_at_the_next_sync_and_shows_at_the_one_after(running: Bench) -> None:
    running.order(goal=C.TB_GOAL_OFF)
    seen = []
    for _ in range(4):
        running.cycle()
        seen.append((running.seen.drives[CABLE].power, running.drives[CABLE].machine.power))
    enabled, off = C.TB_POWER_ENABLED, C.TB_POWER_OFF
    assert seen == [(enabled, "ENABLED"), (enabled, "OFF"), (off, "OFF"), (off, "OFF")]


def test_each_drive_gets_one_setpoint_a_sync(running: Bench) -> None:
    before = [len(drive.setpoints) for drive in running.drives]
    running.cycle(20)
    more = [len(drive.setpoints) - n for drive, n in zip(running.drives, before, strict=True)]
    assert more == [20] * 4 + [10] * 4


def test_frames_of_a_cycle_go_out_in_their_order(running: Bench) -> None:
    running.cycle(-running.network.cycle % HEARTBEAT_CYCLES)
    running.order(task=C.TB_TASK_IDENTIFY)
    running.cycle()
    identifiers = [[frame.id for frame in sent] for sent in running.dispatched]
    assert [ids[:-1] for ids in identifiers] == [
        [0x201, 0x202, 0x77F],
        [0x201, 0x202, 0x77F],
        [0x201, 0x202, 0x203, 0x204, 0x77F],
    ]
    assert all(0x600 < ids[-1] < 0x680 for ids in identifiers)


def test_one_acyclic_frame_a_bus_and_cycle_from_each_drive_in_turn(bench: Bench) -> None:
    bench.task("RESET")
    bench.order(task=C.TB_TASK_CONFIGURE)
    turns: list[list[int]] = [[], [], []]
    for _ in range(100):
        bench.cycle()
        for bus, sent in enumerate(bench.dispatched):
            acyclic = [frame.id - 0x600 for frame in sent if frame.id != 0x77F]
            assert len(acyclic) <= 1
            turns[bus] += acyclic
    assert all(sorted(turns[bus][n : n + 2]) == [1, 2] for bus in (0, 1) for n in range(0, 90, 2))
    assert turns[SLOW_BUS][:8] == [1, 2, 3, 4, 1, 2, 3, 4]


def test_the_heartbeat_goes_out_with_checked_cycles_only(running: Bench) -> None:
    for beats in (1, 0, 1):
        running.orders.beat = beats
        sent = []
        for _ in range(3 * HEARTBEAT_CYCLES):
            running.cycle()
            sent += [[f for f in bus if f.id == 0x77F] for bus in running.dispatched]
        wanted = [Frame(0x77F, b"\x05")]
        assert sent.count(wanted) == (9 if beats else 0)
        assert sent.count([]) == len(sent) - sent.count(wanted)


# ---- What a status message says ----


@settings(max_examples=50)
@given(st.integers(-(2**31), 2**31 - 1), st.integers(-(2**15), 2**15 - 1))
def test_positions_and_torques_are_reported_in_si_units(position: int, torque: int) -> None:
    bench = FRESH
    for drive in bench.drives:
        drive.position, drive.torque = position, torque
    bench.cycle(2)
    for row, report in zip(bench.rows, bench.seen.drives, strict=True):
        assert report.position == position * row.table.metres_per_increment
        assert report.torque == torque * row.table.torque_per_unit


def test_a_drive_on_a_slower_bus_is_fresh_in_the_cycles_of_its_sync(running: Bench) -> None:
    fresh = []
    for _ in range(4):
        running.cycle()
        fresh.append((running.seen.drives[CABLE].fresh, running.seen.drives[BASE].fresh))
    assert fresh == [(1, 1), (1, 0), (1, 1), (1, 0)]


@pytest.mark.parametrize(("drive", "each"), [(CABLE, 1), (BASE, 2)])
def test_syncs_without_an_answer_are_counted(running: Bench, drive: int, each: int) -> None:
    silence(running, drive)
    missed = []
    for _ in range(6):
        running.cycle()
        missed.append(running.seen.drives[drive].missed)
        assert running.seen.drives[drive].fresh == 0
    assert missed == ([1, 2, 3, 4, 5, 6] if each == 1 else [0, 1, 1, 2, 2, 3])
    running.answers = lambda bus, frame: [frame]
    running.cycle(each)
    assert running.seen.drives[drive].missed == 0


def test_the_count_of_missed_syncs_stops_at_255(running: Bench) -> None:
    silence(running, CABLE)
    running.cycle(300)
    assert running.seen.drives[CABLE].missed == 255


@pytest.mark.parametrize("drive", [CABLE, BASE])
def test_an_answer_after_the_last_collect_is_used_but_is_late_and_not_fresh(
    running: Bench, drive: int
) -> None:
    row = running.rows[drive]
    silence(running, drive)
    period = running.dividers[row.bus]
    for count in range(1, 5):
        running.cycle(period)
        report = running.seen.drives[drive]
        assert (report.fresh, report.late, report.missed) == (0, count - 1, 1)
        assert report.position == 1000 * (count - 1) * row.table.metres_per_increment
        running.give(row.bus, status(row.node, position=1000 * count))
    running.answers = lambda bus, frame: [frame]
    running.cycle(2 * period)
    assert (running.seen.drives[drive].late, running.seen.drives[drive].missed) == (0, 0)


def test_a_boot_up_message_counts_although_a_heartbeat_follows_it_in_the_same_cycle(
    bench: Bench,
) -> None:
    bench.bring_up()
    collect = bench.collect

    def boots() -> None:
        bench.give(0, Frame(0x701, b"\x00"), Frame(0x701, b"\x05"))
        collect()

    bench.collect = boots  # type: ignore[method-assign]
    bench.cycle()
    assert fields(bench, "silent")[0] == 1
    bench.collect = collect  # type: ignore[method-assign]
    bench.cycle()
    assert fields(bench, "silent")[0] == 0


def test_the_last_of_some_late_answers_counts_although_a_punctual_one_follows_at_once(
    bench: Bench,
) -> None:
    bench.bring_up()
    held: list[Frame] = []
    told: list[int] = []

    def late(bus: int, frame: Frame) -> list[Frame]:
        if (bus, frame.id) != (0, 0x181) or len(told) >= 3:
            return [frame]
        held.append(frame)
        return []

    bench.answers = late
    collect = bench.collect

    def collected() -> None:
        collect()
        told.append(bench.seen.drives[0].late)
        bench.give(0, *held)  # before the next SYNC
        held.clear()

    bench.collect = collected  # type: ignore[method-assign]
    bench.cycle(6)
    assert max(told) == 3 and told[-1] == 0


@pytest.mark.parametrize("moment", ["after the collect", "before the next collect"])
def test_on_a_slower_bus_an_answer_in_the_next_cycle_is_in_time(
    running: Bench, moment: str
) -> None:
    row = running.rows[BASE]
    silence(running, BASE)
    for count in range(1, 5):
        running.cycle()
        assert running.seen.drives[BASE].fresh == 0
        if moment == "after the collect":
            running.give(row.bus, status(row.node, position=1000 * count))
        running.sync()
        if moment == "before the next collect":
            running.give(row.bus, status(row.node, position=1000 * count))
        running.collect()
        running.dispatch()
        report = running.seen.drives[BASE]
        assert (report.fresh, report.age, report.late, report.missed) == (1, 1, 0, 0)
        assert report.position == 1000 * count * row.table.metres_per_increment


def test_of_two_status_messages_in_one_sync_the_last_counts_and_they_are_counted(
    running: Bench,
) -> None:
    def twice(bus: int, frame: Frame) -> list[Frame]:
        mine = (bus, frame.id) == (0, 0x181)
        return [frame, status(1, position=777)] if mine else [frame]

    running.answers = twice
    running.cycle(3)
    report, link = running.seen.drives[CABLE], running.network.links[CABLE]
    assert link.duplicates == 3
    assert report.position == 777 * running.rows[CABLE].table.metres_per_increment
    assert (report.fresh, report.late, report.missed) == (1, 0, 0)
    assert running.network.links[CABLE + 1].duplicates == 0


def test_a_statusword_that_cia_402_does_not_know_is_reported_as_unknown(running: Bench) -> None:
    running.answers = lambda bus, frame: [status(1, 0x0201)] if frame.id == 0x181 else [frame]
    running.cycle()
    assert running.seen.drives[CABLE].power == C.TB_POWER_UNKNOWN
    assert running.seen.drives[CABLE].statusword == 0x0201
    assert running.drives[CABLE].setpoints[-1] == (0, 0)


def test_a_drive_whose_heartbeat_stops_is_silent_in_time(running: Bench) -> None:
    silence(running, CABLE, 0x700)
    cycles = 0
    while not running.seen.drives[CABLE].silent:
        running.cycle()
        cycles += 1
        assert cycles <= HEARTBEAT_TIMEOUT + 1
    assert cycles >= HEARTBEAT_TIMEOUT - 20  # its last heartbeat may be one period old
    assert fields(running, "silent") == [1] + [0] * 7


@pytest.mark.parametrize("state", [0x04, 0x7F, 0x00])
def test_a_drive_that_is_no_longer_operational_is_silent(running: Bench, state: int) -> None:
    running.give(0, Frame(0x701, bytes([state])))
    running.cycle()
    assert fields(running, "silent") == [1] + [0] * 7


def test_a_drive_under_local_control_says_so_until_it_says_nothing(running: Bench) -> None:
    mine = (0, 0x181)
    running.answers = lambda *sent: (
        [status(1, 0x0037)] if (sent[0], sent[1].id) == mine else [sent[1]]
    )
    running.cycle()
    assert fields(running, "silent") == [C.TB_SILENCE_LOCAL] + [0] * 7
    silence(running, CABLE, 0x700)
    running.cycle(HEARTBEAT_TIMEOUT + 1)
    assert fields(running, "silent") == [C.TB_SILENCE_UNHEARD] + [0] * 7


@pytest.mark.parametrize("period", [10, 40])
def test_a_heartbeat_at_half_or_twice_its_period_is_no_silence(running: Bench, period: int) -> None:
    silence(running, CABLE, 0x700)
    for cycle in range(4 * HEARTBEAT_TIMEOUT):
        if cycle % period == 0:
            running.give(0, Frame(0x701, b"\5"))
        running.cycle()
        assert fields(running, "silent") == [0] * 8


def test_an_emergency_stands_until_it_is_cleared(running: Bench) -> None:
    running.give(0, Frame(0x082, struct.pack("<HB5x", 0x2310, 1)))
    running.cycle(5)
    assert fields(running, "error_code") == [0, 0x2310, 0, 0, 0, 0, 0, 0]
    assert fields(running, "error_class") == [0, C.TB_ERROR_FAULT, 0, 0, 0, 0, 0, 0]
    running.give(0, Frame(0x082, bytes(8)))
    running.cycle()
    assert set(fields(running, "error_code")) == {0}


def test_a_reset_of_the_communication_clears_an_emergency(running: Bench) -> None:
    running.give(0, Frame(0x081, struct.pack("<HB5x", 0x8130, 1)))
    running.cycle()
    assert running.seen.drives[CABLE].error_class == C.TB_ERROR_COMMUNICATION
    running.task("RESET")
    assert set(fields(running, "error_code")) == {0}


def test_a_reset_takes_a_drive_out_of_service(running: Bench) -> None:
    running.order(task=C.TB_TASK_RESET, torque=0.01)
    running.cycle(4)
    for drive in running.drives:
        drive.setpoints.clear()
    running.cycle(10)
    assert not any(drive.setpoints for drive in running.drives)
    assert set(fields(running, "power")) == {C.TB_POWER_UNKNOWN}
    assert set(fields(running, "mode")) == {C.TB_MODE_NONE}
    assert set(fields(running, "missed")) == {0}
    assert set(fields(running, "silent")) == {1}


# ---- Setpoints ----

FRESH = Bench()
FRESH.enable()


@given(st.floats(allow_nan=True, allow_infinity=True), st.sampled_from([CABLE, BASE]))
def test_a_torque_is_rounded_towards_zero_and_never_beyond_the_limit(
    torque: float, drive: int
) -> None:
    assert_rounded(FRESH, drive, torque)


@given(st.floats(-0.07, 0.07), st.sampled_from([CABLE, BASE]))
def test_an_ordinary_torque_is_rounded_towards_zero(torque: float, drive: int) -> None:
    assert_rounded(FRESH, drive, torque)


def assert_rounded(bench: Bench, drive: int, torque: float) -> None:
    """What is on the wire is the torque in per mille: no more than it, and no more than allowed."""
    table = bench.rows[drive].table
    bench.order(torque=torque, goal=C.TB_GOAL_ENABLED)
    bench.cycle(2)
    _, sent = bench.drives[drive].setpoints[-1]
    wanted = torque * table.units_per_torque
    if math.isnan(torque):
        assert sent == 0
    elif abs(wanted) >= table.most_torque_units:
        assert sent == math.copysign(table.most_torque_units, torque)
    else:
        assert sent == math.trunc(wanted)


@pytest.mark.parametrize("goal", ["OFF", "READY", "QUICK_STOP", "FAULT_RESET"])
def test_a_drive_that_is_not_to_be_enabled_is_asked_for_no_torque(
    running: Bench, goal: str
) -> None:
    running.order(goal=getattr(C, f"TB_GOAL_{goal}"), torque=0.01)
    running.cycle(2)
    assert {drive.setpoints[-1][1] for drive in running.drives} == {0}


def test_a_drive_that_changes_its_mode_or_homes_is_asked_for_no_torque(running: Bench) -> None:
    running.order(torque=0.01, task=C.TB_TASK_NONE)
    running.cycle(2)
    assert 0 not in {drive.setpoints[-1][1] for drive in running.drives}
    running.order(task=C.TB_TASK_MODE, mode=C.TB_MODE_HOMING)
    for _ in range(60):
        running.cycle()
        sent = [frame for frame in running.dispatched[0] if frame.id == 0x201]
        assert [frame.data[2:] for frame in sent] == [b"\0\0"]
    assert set(fields(running, "mode")) == {C.TB_MODE_HOMING}


def test_a_position_drive_is_asked_for_its_position_and_holds_where_it_is_else(
    running: Bench,
) -> None:
    link, drive = running.network.links[CABLE], running.drives[CABLE]
    table = C.new("tb_drive_table")
    table.node, table.mode, table.metres_per_increment = 1, 1, 0.5
    table.increments_per_metre, table.torque_per_unit = 2.0, 1.0
    link.drive = addressof(table)
    drive.position = 4321
    asked = []
    for mode, position in (
        ("NONE", 7.0),
        ("POSITION", 7.4),
        ("POSITION", math.nan),
        ("POSITION", 1e30),
        ("POSITION", -1e30),
    ):
        link.setup.mode = getattr(C, f"TB_MODE_{mode}")
        running.order(position=position, task=C.TB_TASK_NONE)
        running.cycle()
        (frame,) = [frame for frame in running.dispatched[0] if frame.id == 0x201]
        asked.append(struct.unpack("<Hi", frame.data)[1])
    assert asked == [4321, 14, 4321, 2147483520, -2147483520]


# ---- Homing ----


def test_homing_bits_of_the_run_before_are_not_believed(running: Bench) -> None:
    running.task("MODE", mode=C.TB_MODE_HOMING)
    base = running.drives[BASE]
    base.homed = 0x1400
    running.order(home=1)
    seen = []
    for _ in range(14):
        running.cycle()
        seen.append(running.seen.drives[BASE].homing)
    idle, run, done = C.TB_HOMING_IDLE, C.TB_HOMING_RUNNING, C.TB_HOMING_DONE
    assert [state for n, state in enumerate(seen) if n == 0 or state != seen[n - 1]] == [
        idle,
        run,
        done,
    ]
    assert base.applied[-1][0] == 0x1F
    running.order(home=0)
    running.cycle(4)
    assert base.applied[-1][0] == 0x0F
    assert running.seen.drives[BASE].homing == idle


def test_homing_starts_in_homing_mode_only(running: Bench) -> None:
    running.order(home=1)
    running.cycle(4)
    assert {drive.applied[-1][0] for drive in running.drives} == {0x0F}


# ---- Faults of a bus ----


@pytest.mark.parametrize("function", [0x080, 0x180, 0x280, 0x380, 0x480, 0x580, 0x700])
def test_a_node_that_the_machine_file_does_not_know_is_named(running: Bench, function: int) -> None:
    running.give(1, Frame(function + 9, bytes(1 if function == 0x700 else 8)))
    running.cycle()
    assert [bus.stranger for bus in running.seen.buses] == [0, 9, 0]
    running.cycle()
    assert [bus.stranger for bus in running.seen.buses] == [0, 0, 0]


def test_a_drive_of_another_bus_is_a_stranger_on_this_one(running: Bench) -> None:
    running.give(0, status(3))
    running.cycle()
    assert [bus.stranger for bus in running.seen.buses] == [3, 0, 0]


MASTERS = {
    "NMT": Frame(0x000, b"\x82\1"),
    "SYNC": Frame(0x080, b""),
    "TIME": Frame(0x100, bytes(6)),
    "setpoint": Frame(0x201, bytes(4)),
    "another PDO": Frame(0x304, b"\5"),
    "SDO": Frame(0x601, b"\x40\0\x10\0\0\0\0\0"),
    "heartbeat": Frame(0x77F, b"\5"),
}


@pytest.mark.parametrize("frame", MASTERS.values(), ids=MASTERS)
def test_another_master_is_named_with_what_it_said(running: Bench, frame: Frame) -> None:
    running.give(0, frame)
    running.cycle()
    assert [bus.stranger for bus in running.seen.buses] == [0x80 | frame.id >> 7, 0, 0]
    running.cycle()
    assert running.seen.buses[0].stranger == 0


# ---- Adapters that echo ----


class Echo:
    """An adapter that sends the master's frames back, some cycles later; `loses` says which not."""

    def __init__(self, bench: Bench, late: int = 0, loses: Callable[[int], bool] = bool) -> None:
        self.bench, self.loses, self.sent = bench, loses, 0
        self.waiting: list[list[list[Frame]]] = [[[], [], []] for _ in range(late)]
        carry = bench.carry

        def echoing() -> list[list[Frame]]:
            self.waiting.append(carry())
            for bus, frames in enumerate(self.waiting.pop(0)):
                for frame in frames:
                    self.sent += 1
                    if not self.loses(self.sent):
                        bench.give(bus, frame)
            return self.waiting[-1] if self.waiting else [[], [], []]

        bench.carry = echoing  # type: ignore[method-assign]


def never(number: int) -> bool:
    """No frame is lost."""
    return False


def strangers(bench: Bench, cycles: int) -> set[int]:
    """Who is named in so many cycles."""
    named: set[int] = set()
    for _ in range(cycles):
        bench.cycle()
        named |= {bus.stranger for bus in bench.seen.buses}
    return named - {0}


@pytest.mark.parametrize("late", [0, 1, 8])
def test_an_adapter_that_echoes_is_no_other_master(bench: Bench, late: int) -> None:
    named: set[int] = set()
    Echo(bench, late, never)
    collect = bench.collect

    def watched() -> None:
        collect()
        named.update(bus.stranger for bus in bench.seen.buses)

    bench.collect = watched  # type: ignore[method-assign]
    bench.enable()
    bench.order(goal=C.TB_GOAL_ENABLED, torque=0.01)
    bench.cycle(300)
    assert named == {0}
    assert fields(bench, "missed") == [0] * 8


def test_an_adapter_that_loses_an_echo_now_and_then_is_no_other_master(bench: Bench) -> None:
    chance = Random(1)
    Echo(bench, 0, lambda number: chance.random() < 0.05)
    bench.enable()
    assert strangers(bench, 300) == set()


@pytest.mark.parametrize("heard", [False, True])
def test_what_was_sent_while_no_drive_could_acknowledge_it_is_no_lost_echo(heard: bool) -> None:
    echo, sync = C.new("tb_echo"), C.frame(Frame(0x080, b""))
    beat = C.frame(Frame(0x77F, b"\x05"))
    for cycle in range(300):
        if heard or cycle in (0, 100, 299):
            C.tb_echo_hear(byref(echo))
        C.tb_echo_keep(byref(echo), byref(sync))
        C.tb_echo_keep(byref(echo), byref(beat))
    assert bool(C.tb_echo_take(byref(echo), byref(sync))) is not heard


@pytest.mark.parametrize("frame", MASTERS.values(), ids=MASTERS)
def test_behind_an_adapter_that_echoes_another_master_is_named_still(
    bench: Bench, frame: Frame
) -> None:
    Echo(bench, 0, never)
    bench.enable()
    bench.give(0, frame, frame)
    assert strangers(bench, 1) == {0x80 | frame.id >> 7}


def test_another_sync_at_the_same_rate_is_no_echo(bench: Bench) -> None:
    """Each is like one that the master sent, but nothing else comes back."""
    bench.enable()
    sync = bench.sync

    def doubled() -> None:
        sync()
        bench.give(0, Frame(0x080, b""))

    bench.sync = doubled  # type: ignore[method-assign]
    assert strangers(bench, 1) == {0x81}


def test_another_sync_from_power_on_is_named_before_there_is_torque(bench: Bench) -> None:
    carry = bench.carry
    named: set[int] = set()

    def heard() -> list[list[Frame]]:
        sent = carry()
        for frame in sent[0]:
            if frame.id == 0x080:
                bench.give(0, frame)
        named.update(bus.stranger for bus in bench.seen.buses)
        return sent

    bench.carry = heard  # type: ignore[method-assign]
    bench.bring_up()
    bench.cycle(30)
    assert 0x81 in named


# ---- Nodes that are no drives ----


def test_the_frames_of_other_nodes_in_the_machine_file_are_none_of_our_business(
    tmp_path: Path,
) -> None:
    library = Canopen(sources_of(with_other_nodes(tmp_path)), folders=[tmp_path])
    bench = Bench(library)
    bench.enable()
    known = [Frame(0x194, bytes(8)), Frame(0x210, b"\1"), Frame(0x094, bytes(8))]
    bench.give(2, *known, Frame(0x714, b"\0"), Frame(0x714, b"\5"))
    bench.cycle()
    assert [(bus.stranger, bus.malformed) for bus in bench.seen.buses] == [(0, 0)] * 3
    bench.give(2, Frame(0x294, bytes(8)))
    bench.give(1, known[0])
    bench.cycle()
    assert [bus.stranger for bus in bench.seen.buses] == [0, 20, 20]


def with_other_nodes(folder: Path) -> Path:
    """The stock machine with an I/O node on its third bus: its tb_drives.h and .c."""
    tables = tomllib.loads(STOCK.read_text())
    frames = [{"id": id, "length": 8, "period": "100 ms"} for id in (0x194, 0x210, 0x094)]
    tables["node"] = [{"name": "io", "bus": "base", "node": 20, "frames": frames}]
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(TEMPLATES))
    given = drive_fields(machine_from(tables, STOCK))
    for name in ("tb_drives.h", "tb_drives.c"):
        text = environment.get_template(f"{name}.jinja").render(banner="", **given)
        (folder / name).write_text(text)
    return folder


def sources_of(folder: Path) -> list[Path]:
    """Of the network, with the tables of a folder."""
    return [folder / "tb_drives.c", *(file for file in SOURCES if file.name != "tb_drives.c")]


# ---- Counts ----

STARTS = [0, 1, 16_777_216, 2**31 - 2000, 2**31 - 1, -(2**31), -1_234_567_890]


def wrapped(count: int) -> int:
    """As 32 bits hold it."""
    return (count + 2**31) % 2**32 - 2**31


@pytest.mark.parametrize("precision", ["double", "float"])
@pytest.mark.parametrize("start", STARTS)
def test_a_cable_is_measured_from_where_its_drive_was_first_seen(
    precision: str, start: int
) -> None:
    bench = Bench(network_in(precision))
    for drive in bench.drives:
        drive.position = wrapped(start)
    bench.enable()
    cable, row = bench.drives[CABLE], bench.rows[CABLE]
    turned = 0
    for step in (0, 1, 4095, -70_000, 2**31 - 1 - 66_000, 40_000, -(2**31) + 2):
        turned = wrapped(turned + step)
        cable.position = wrapped(start + turned)
        bench.cycle(2)
        unit = row.table.metres_per_increment
        expected = in_precision(precision, in_precision(precision, turned) * unit)
        assert bench.seen.drives[CABLE].position == expected


@pytest.mark.parametrize("precision", ["double", "float"])
@pytest.mark.parametrize("start", STARTS)
def test_a_base_is_measured_by_its_own_count_from_its_homing_on(precision: str, start: int) -> None:
    bench = Bench(network_in(precision))
    base, row = bench.drives[BASE], bench.rows[BASE]
    base.position = wrapped(start)
    bench.bring_up()
    assert bench.seen.drives[BASE].position == 0
    base.position = wrapped(start + 100)
    bench.cycle(4)
    unit = row.table.metres_per_increment
    assert bench.seen.drives[BASE].position == in_precision(precision, 100 * unit)
    bench.task("MODE", mode=C.TB_MODE_HOMING)
    base.position = -321  # where homing put it
    bench.task("MODE", mode=C.TB_MODE_TORQUE)
    bench.cycle(4)
    assert bench.seen.drives[BASE].position == in_precision(precision, -321 * unit)
    bench.task("RESET")
    for name in ("CONFIGURE", "START"):
        bench.task(name)
    bench.cycle(4)
    assert bench.seen.drives[BASE].position == 0


@pytest.mark.parametrize("start", STARTS)
def test_a_position_is_asked_for_in_the_drives_own_counts(running: Bench, start: int) -> None:
    link, drive = running.network.links[CABLE], running.drives[CABLE]
    table = C.new("tb_drive_table")
    table.node, table.mode, table.metres_per_increment = 1, 1, 0.5
    table.increments_per_metre, table.torque_per_unit = 2.0, 1.0
    link.drive, link.has_origin = addressof(table), 0
    drive.position = wrapped(start)
    running.cycle(2)
    link.setup.mode = C.TB_MODE_POSITION
    for wanted in (0.0, 1000.0, -1000.0):
        running.order(position=wanted, task=C.TB_TASK_NONE)
        running.cycle()
        (frame,) = [frame for frame in running.dispatched[0] if frame.id == 0x201]
        assert struct.unpack("<Hi", frame.data)[1] == wrapped(start + int(2 * wanted))


@cache
def network_in(precision: str) -> Canopen:
    """The network in a precision."""
    return C if precision == "double" else Canopen(precision=precision)


def in_precision(precision: str, value: float) -> float:
    """The nearest number of a precision."""
    return float(np.float32(value)) if precision == "float" else float(value)


@pytest.mark.parametrize(
    "frame",
    [
        Frame(0x181, bytes(7)),
        Frame(0x181, b""),
        Frame(0x281, bytes(8)),
        Frame(0x581, bytes(4)),
        Frame(0x081, bytes(7)),
        Frame(0x701, b"\5\5"),
        Frame(0x701, b"\x33"),
        Frame(0x180, bytes(8)),
        Frame(0x101, bytes(8)),
        Frame(0x681, bytes(8)),
        Frame(0x7E4, bytes(8)),
    ],
    ids=lambda frame: f"{frame.id:03X}-{len(frame.data)}",
)
def test_what_no_drive_says_is_counted_as_malformed(running: Bench, frame: Frame) -> None:
    before = [bytes(report) for report in running.seen.drives]
    running.give(0, frame, frame)
    running.cycle()
    assert [bus.malformed for bus in running.seen.buses] == [2, 0, 0]
    assert [bus.stranger for bus in running.seen.buses] == [0, 0, 0]
    after = [bytes(report) for report in running.seen.drives]
    assert before[:BASE] == after[:BASE]
    running.cycle()
    assert running.seen.buses[0].malformed == 0


@pytest.mark.parametrize("flags", [1, 2])
def test_extended_and_remote_frames_are_malformed(running: Bench, flags: int) -> None:
    frame = running.c.frame(status(1, 0x0208))
    frame.flags = flags
    C.tb_loopback_give(byref(running.loops[0]), byref(frame))
    running.cycle()
    assert running.seen.buses[0].malformed == 1
    assert running.seen.drives[CABLE].power == C.TB_POWER_ENABLED


@pytest.mark.parametrize(("more", "reported"), [(0, 0), (1, 1), (255, 255), (1000, 255)])
def test_what_a_port_could_not_read_is_malformed(running: Bench, more: int, reported: int) -> None:
    running.loops[1].port.statistics.malformed += more
    running.cycle()
    assert [bus.malformed for bus in running.seen.buses] == [0, reported, 0]
    running.cycle()
    assert [bus.malformed for bus in running.seen.buses] == [0, 0, 0]


def test_what_came_before_the_start_is_an_older_story(running: Bench) -> None:
    running.loops[0].port.statistics.malformed = 7
    running.give(0, Frame(0x7E4, bytes(8)), Frame(0x711, b"\5"))
    running.start((c_void_p * len(running.loops))(*map(addressof, running.loops)))
    running.cycle()
    assert [(bus.malformed, bus.stranger) for bus in running.seen.buses] == [(0, 0)] * 3


def test_drives_of_a_bus_that_was_opened_again_are_brought_under_torque_again(
    running: Bench,
) -> None:
    C.tb_loopback_set_state(byref(running.loops[1]), C.TB_CAN_NOT_OPEN)
    running.cycle(HEARTBEAT_TIMEOUT + 20)
    assert set(fields(running, "silent")[2:4]) == {1}
    C.tb_loopback_open(byref(running.loops[1]))
    running.order(task=C.TB_TASK_NONE, goal=C.TB_GOAL_FAULT_RESET)
    running.enable()
    assert set(fields(running, "silent")) == set(fields(running, "missed")) == {0}


@pytest.mark.parametrize("state", ["BUS_OFF", "NOT_OPEN"])
def test_nothing_is_sent_to_a_bus_that_is_off(running: Bench, state: str) -> None:
    number = getattr(C, f"TB_CAN_{state}")
    C.tb_loopback_set_state(byref(running.loops[1]), number)
    for _ in range(20):
        running.cycle()
        assert running.synced[1] == running.dispatched[1] == []
        assert running.dispatched[0]
    assert [bus.state for bus in running.seen.buses] == [0, number, 0]
    assert [bus.refused for bus in running.seen.buses] == [0, 0, 0]


def test_refused_frames_are_counted_by_cycle(running: Bench) -> None:
    C.tb_loopback_set_full(byref(running.loops[0]), True)
    running.cycle(-running.network.cycle % HEARTBEAT_CYCLES + 3)
    assert running.seen.buses[0].refused == 3  # two setpoints and the SYNC
    C.tb_loopback_set_full(byref(running.loops[0]), False)
    running.cycle(2)
    assert running.seen.buses[0].refused == 0


@settings(max_examples=20)
@given(
    st.lists(
        st.tuples(st.integers(0, 2), st.integers(0, 0x7FF), st.binary(max_size=8)), max_size=60
    )
)
def test_no_frames_whatever_get_a_torque_beyond_the_orders_on_the_wire(
    frames: list[tuple[int, int, bytes]],
) -> None:
    bench = Bench()
    bench.enable()
    bench.order(goal=C.TB_GOAL_ENABLED, torque=0.01)
    limits = [math.trunc(0.01 * row.table.units_per_torque) for row in bench.rows]
    for bus, identifier, data in frames:
        bench.give(bus, Frame(identifier, data))
    bench.cycle(4)
    for drive, limit in zip(bench.drives, limits, strict=True):
        assert {target for _, target in drive.applied[-3:]} <= {0, limit}
        assert not any(word & 0x80 for word, _ in drive.setpoints)


def test_a_flood_does_not_hold_the_loop(running: Bench) -> None:
    running.give(0, *[Frame(0x7E4, bytes(8))] * 64)
    running.cycle()
    assert running.seen.buses[0].malformed >= 60
