"""The master, supervisor and all, with python canopen's drives: up to its wait for the arming."""

import re
from ctypes import byref
from typing import Any

import pytest
from canopen_bench import Bench
from canopen_c import MACHINE, RUNTIME, Canopen, Frame

SOURCES = [
    *sorted(MACHINE.glob("*.c")),
    *sorted((RUNTIME / "core").glob("*.c")),
    *sorted((RUNTIME / "canopen").glob("*.c")),
    RUNTIME / "can" / "can.c",
    RUNTIME / "can" / "loopback.c",
]
C = Canopen(SOURCES)
PATIENCE = 20
"""TB_ANSWER_TIMEOUT of a machine that is in a hurry."""


class MasterBench(Bench):
    """A bench whose cycles the master runs."""

    def __init__(self, library: Canopen = C) -> None:
        self.master = library.new("tb_master")
        super().__init__(library)
        self.seen = self.master.seen
        self.orders, self.wishes = self.master.orders, self.c.new("tb_wishes")
        self.skipped = 0

    def start(self, ports: Any) -> None:
        """Take over the ports."""
        super().start(ports)
        self.c.tb_master_start(byref(self.master), byref(self.network.fieldbus))

    def cycle(self, count: int = 1) -> None:
        """Run some cycles."""
        for _ in range(count):
            self.tick()
            self.c.tb_master_sync(byref(self.master))
            self.synced = self.carry()
            self.c.tb_master_run(byref(self.master), byref(self.wishes), self.skipped)
            self.dispatched = self.carry()

    def run_until(self, state: str, phase: str | None = None, most: int = 8000) -> None:
        """Run until the supervisor is in a state, or in a fault."""
        for _ in range(most):
            self.cycle()
            if self.orders.state == getattr(self.c, f"TB_STATE_{state}") and (
                phase is None or self.orders.phase == getattr(self.c, f"TB_PHASE_{phase}")
            ):
                return
            assert state == "FAULT" or self.orders.state != self.c.TB_STATE_FAULT, self.blame()
        raise AssertionError(f"{state} is not reached in {most} cycles: {self.orders.state}")

    def blame(self) -> tuple[str, int, int, int, int]:
        """Cause, culprit, index, subindex, detail."""
        names = {v: n for n, v in self.c.constants("TB_CAUSE_").items()}
        orders = self.orders
        cause = names[orders.cause].removeprefix("TB_CAUSE_")
        return cause, orders.culprit, orders.index, orders.subindex, orders.detail


@pytest.fixture
def bench() -> MasterBench:
    """A machine that was just switched on."""
    return MasterBench()


def test_the_machine_comes_up_to_where_it_waits_to_be_armed(bench: MasterBench) -> None:
    bench.run_until("CONFIGURE", "READY")
    assert all(drive.is_operational for drive in bench.drives)
    assert {drive.machine.power for drive in bench.drives} == {"OFF"}
    bench.cycle(200)
    assert (bench.orders.state, bench.orders.cause) == (C.TB_STATE_CONFIGURE, C.TB_CAUSE_NONE)
    assert {target for drive in bench.drives for _, target in drive.setpoints} == {0}


def test_a_drive_in_fault_at_power_on_is_reset(bench: MasterBench) -> None:
    bench.drives[3].power_at_boot = "FAULT"
    bench.run_until("CONFIGURE", "READY")
    assert {drive.machine.power for drive in bench.drives} == {"OFF"}


def test_every_cycle_is_recorded(bench: MasterBench) -> None:
    bench.cycle(100)
    assert bench.master.recorder.number == 100


def test_the_heartbeat_of_a_healthy_machine_goes_out_every_ten_cycles(bench: MasterBench) -> None:
    beats = 0
    for _ in range(100):
        bench.cycle()
        beats += all(Frame(0x77F, b"\5") in sent for sent in bench.dispatched)
    assert beats == 10


def test_wishes_and_skipped_cycles_reach_the_supervisor(bench: MasterBench) -> None:
    bench.wishes.force[0], bench.wishes.hand_force[1] = 1.5, -2.5
    bench.wishes.hand_force_fresh, bench.wishes.requests, bench.skipped = 1, 2, 7
    bench.cycle()
    seen = bench.seen
    assert (seen.force[0], seen.hand_force[1]) == (1.5, -2.5)
    assert (seen.hand_force_fresh, seen.requests, seen.missed) == (1, 2, 7)


def test_a_missing_drive_is_named(bench: MasterBench) -> None:
    bench.answers = lambda bus, frame: [] if (bus, frame.id & 0x7F) == (1, 2) else [frame]
    bench.run_until("FAULT")
    assert bench.blame()[:2] == ("DRIVE_MISSING", 3)


def test_a_drive_with_another_rating_is_named_with_the_object(bench: MasterBench) -> None:
    entry = next(e for e in bench.rows[6].identity if e.index == 0x6076)
    bench.drives[6].read = lambda key, held: held + 1 if key == (0x6076, 0) else held
    bench.run_until("FAULT")
    assert bench.blame() == ("DRIVE_DIFFERENT", 6, 0x6076, 0, entry.value + 1)


def test_a_drive_that_changes_its_contract_is_named_with_the_object(bench: MasterBench) -> None:
    bench.drives[1].read = lambda key, held: 3 if key == (0x6007, 0) else held
    bench.run_until("FAULT")
    assert bench.blame() == ("DRIVE_SETUP", 1, 0x6007, 0, 3)


def test_two_drives_with_one_number_are_named(bench: MasterBench) -> None:
    bench.answers = lambda bus, frame: [frame] * (2 if (bus, frame.id & 0x7F) == (2, 4) else 1)
    bench.run_until("FAULT")
    assert bench.blame()[:2] == ("DRIVE_TWICE", 7)


def test_a_drive_that_boots_twice_comes_up(bench: MasterBench) -> None:
    bench.answers = lambda bus, frame: [frame] * (2 if frame == Frame(0x704, b"\0") else 1)
    bench.run_until("CONFIGURE", "READY")
    assert bench.orders.cause == C.TB_CAUSE_NONE


@pytest.fixture(scope="module")
def hurried(tmp_path_factory: pytest.TempPathFactory) -> Canopen:
    """The master of a machine with a short supervision.answer_timeout."""
    folder = tmp_path_factory.mktemp("hurried")
    for name in ("tb_drives.h", "tb_drives.c"):
        text = (MACHINE / name).read_text()
        changed = re.sub(r"(define TB_ANSWER_TIMEOUT) \d+", rf"\1 {PATIENCE}", text)
        (folder / name).write_text(changed)
    others = [source for source in SOURCES if source.name != "tb_drives.c"]
    return Canopen([folder / "tb_drives.c", *others], folders=[folder])


class SlowDrives(MasterBench):
    """The base drives' SDO answers take some cycles."""

    def __init__(self, library: Canopen, cycles: dict[int, int]) -> None:
        super().__init__(library)
        self.under_way: list[tuple[int, int, Frame]] = []
        self.answers = self.delay
        self.late = {(self.rows[n].bus, 0x580 + self.rows[n].node): c for n, c in cycles.items()}

    def delay(self, bus: int, frame: Frame) -> list[Frame]:
        """Keep an answer for a while."""
        cycles = self.late.get((bus, frame.id), 0)
        if cycles == 0:
            return [frame]
        self.under_way.append((self.network.cycle + cycles, bus, frame))
        return []

    def tick(self) -> None:
        super().tick()
        for due, bus, frame in [one for one in self.under_way if one[0] <= self.network.cycle]:
            self.under_way.remove((due, bus, frame))
            self.give(bus, frame)


def test_a_machine_comes_up_while_every_answer_is_in_time_however_long_it_takes(
    hurried: Canopen,
) -> None:
    bench = SlowDrives(hurried, dict.fromkeys(range(4, 8), PATIENCE - 3))
    bench.run_until("CONFIGURE", "READY")
    assert bench.network.cycle > 64 * PATIENCE


@pytest.mark.parametrize(("drive", "cause"), [(4, "DRIVE_MISSING"), (6, "DRIVE_MISSING")])
def test_a_drive_that_answers_too_late_is_named_with_the_object(
    hurried: Canopen, drive: int, cause: str
) -> None:
    slow = dict.fromkeys(range(4, 8), PATIENCE - 3) | {drive: PATIENCE + 2}
    bench = SlowDrives(hurried, slow)
    bench.run_until("FAULT")
    found, culprit, index, subindex, _ = bench.blame()
    assert (found, culprit) == (cause, drive)
    assert (index, subindex) in [(e.index, e.subindex) for e in bench.rows[drive].identity]


def test_a_reset_brings_a_machine_in_fault_up_again(bench: MasterBench) -> None:
    bench.drives[1].read = lambda key, held: 3 if key == (0x6007, 0) else held
    bench.run_until("FAULT")
    bench.drives[1].read = lambda key, held: held
    bench.wishes.requests = 4
    bench.cycle()
    bench.wishes.requests = 0
    bench.run_until("CONFIGURE", "READY")
