"""The master, supervisor and all, with python canopen's drives: up to its wait for the arming."""

from ctypes import byref
from typing import Any

import pytest
from canopen_bench import Bench
from canopen_c import MACHINE, RUNTIME, Canopen, Frame

C = Canopen(
    [
        *sorted(MACHINE.glob("*.c")),
        *sorted((RUNTIME / "core").glob("*.c")),
        *sorted((RUNTIME / "canopen").glob("*.c")),
        RUNTIME / "can" / "can.c",
        RUNTIME / "can" / "loopback.c",
    ]
)


class MasterBench(Bench):
    """A bench whose cycles the master runs."""

    def __init__(self) -> None:
        self.master = C.new("tb_master")
        super().__init__(C)
        self.network, self.seen = self.master.network, self.master.seen
        self.orders, self.wishes = self.master.orders, C.new("tb_wishes")
        self.skipped = 0

    def start(self, ports: Any) -> None:
        """Take over the ports."""
        C.tb_master_start(byref(self.master), ports)

    def cycle(self, count: int = 1) -> None:
        """Run some cycles."""
        for _ in range(count):
            self.tick()
            C.tb_master_sync(byref(self.master))
            self.synced = self.carry()
            C.tb_master_run(byref(self.master), byref(self.wishes), self.skipped)
            self.dispatched = self.carry()

    def run_until(self, state: str, phase: str | None = None, most: int = 8000) -> None:
        """Run until the supervisor is in a state, or in a fault."""
        for _ in range(most):
            self.cycle()
            if self.orders.state == getattr(C, f"TB_STATE_{state}") and (
                phase is None or self.orders.phase == getattr(C, f"TB_PHASE_{phase}")
            ):
                return
            assert state == "FAULT" or self.orders.state != C.TB_STATE_FAULT, self.blame()
        raise AssertionError(f"{state} is not reached in {most} cycles: {self.orders.state}")

    def blame(self) -> tuple[str, int, int, int, int]:
        """Cause, culprit, index, subindex, detail."""
        names = {v: n for n, v in C.constants("TB_CAUSE_").items()}
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


def test_a_reset_brings_a_machine_in_fault_up_again(bench: MasterBench) -> None:
    bench.drives[1].read = lambda key, held: 3 if key == (0x6007, 0) else held
    bench.run_until("FAULT")
    bench.drives[1].read = lambda key, held: held
    bench.wishes.requests = 4
    bench.cycle()
    bench.wishes.requests = 0
    bench.run_until("CONFIGURE", "READY")
