"""Set-up of a drive: the contract in its order, every difference found and named."""

from collections.abc import Callable, Mapping
from ctypes import byref
from types import MappingProxyType
from typing import Any

import pytest
from canopen import SdoAbortedError
from canopen_c import Frame, canopen_c, read
from canopen_drive import Drive, Entry, Row, rows
from canopen_peer import Wire
from hypothesis import given, settings
from hypothesis import strategies as st

C = canopen_c()
ROWS = rows(C)
CABLE, BASE = ROWS[0], ROWS[-1]
TIMEOUT = 5000
ANSWER_TIMEOUT, STATE_TIMEOUT, SETTLE = 500, 2000, 50
"""Cycles: TB_ANSWER_TIMEOUT, TB_STATE_TIMEOUT of the stock machine, SETTLE_CYCLES of setup.c."""


class Bench:
    """One drive and its set-up."""

    def __init__(self, row: Row) -> None:
        self.wire, self.row = Wire(), row
        self.drive = Drive(self.wire, row)
        self.setup, self.heartbeat = C.new("tb_setup"), C.new("tb_heartbeat")
        self.requests: list[Frame] = []
        self.answers = 1
        self.answered = True
        C.tb_heartbeat_start(byref(self.heartbeat))
        table = C.variable("tb_drives")[row.number]
        C.tb_setup_start(byref(self.setup), byref(table))

    def alter_answers(self, change: Callable[[bytes, int], bytes]) -> None:
        """Change the frame of every answer to a read, told the size of the object."""
        give, sizes = self.wire.take, self.drive.sizes

        def changed() -> list[Frame]:
            frames = give()
            for number, frame in enumerate(frames):
                if frame.id == 0x580 + self.row.node and frame.data[0] & 0xE2 == 0x42:
                    key = (int.from_bytes(frame.data[1:3], "little"), frame.data[3])
                    frames[number] = Frame(frame.id, change(frame.data, sizes[key]))
            return frames

        self.wire.take = changed  # type: ignore[method-assign]

    def order(self, task: str, mode: str = "NONE") -> None:
        """Order a task."""
        C.tb_setup_order(
            byref(self.setup), getattr(C, f"TB_TASK_{task}"), getattr(C, f"TB_MODE_{mode}")
        )

    def run(self, task: str, mode: str = "NONE", most: int = TIMEOUT) -> str:
        """Let a task come to its end: the name of its progress."""
        self.order(task, mode)
        for _ in range(most):
            self.cycle()
            if self.progress != "BUSY":
                break
        return self.progress

    def cycle(self) -> None:
        """A frame out, its answers in."""
        frame = C.new("tb_can_frame")
        if C.tb_setup_frame(byref(self.setup), byref(self.heartbeat), byref(frame)):
            self.requests.append(read(frame))
            self.wire.give(self.requests[-1])
        self.wire.tick()
        for answer in self.wire.take():
            for _ in range(self.answers):
                self.take(answer)
        C.tb_heartbeat_tick(byref(self.heartbeat))
        C.tb_setup_advance(byref(self.setup), byref(self.heartbeat), self.answered)

    def take(self, frame: Frame) -> None:
        """A frame of the drive."""
        if frame.id >= 0x700:
            C.tb_heartbeat_take(byref(self.heartbeat), byref(C.frame(frame)))
        else:
            C.tb_sdo_take(byref(self.setup.sdo), byref(C.frame(frame)))

    @property
    def progress(self) -> str:
        """Name of the progress."""
        names = ["IDLE", "BUSY", "DONE", "FAILED"]
        return names[int(self.setup.progress)]

    @property
    def failure(self) -> tuple[str, int, int, int]:
        """Failure, index, subindex, detail."""
        names = ["NONE", "SILENT", "ABORT", "DIFFERENT", "TWICE", "SIZE", "RESTARTED"]
        setup = self.setup
        return names[setup.failure], setup.index, setup.subindex, setup.detail

    def alter(self, entry: int, value: int, entries: list[Entry]) -> None:
        """The drive answers something else for one entry of a table: at the time that it is read,
        for an object may have several."""
        reads = -1

        def answer(key: tuple[int, int], held: int) -> int:
            nonlocal reads
            reads += 1
            return value if reads == entry else held

        assert all(one.writes for one in entries) or not any(one.writes for one in entries)
        self.drive.read = answer


def expected(entry: Entry, found: int) -> tuple[str, int, int, int]:
    """The failure of an entry that holds something else."""
    return "DIFFERENT", entry.index, entry.subindex, found


@pytest.mark.parametrize("row", ROWS, ids=lambda row: str(row.number))
def test_the_contract_is_written_in_its_order_each_entry_read_back_before_the_next(
    row: Row,
) -> None:
    bench = Bench(row)
    assert bench.run("CONFIGURE") == "DONE"
    wanted = [((entry.index, entry.subindex), entry.value) for entry in row.contract]
    assert bench.drive.written == wanted
    objects = [(int.from_bytes(f.data[1:3], "little"), f.data[3]) for f in bench.requests]
    assert objects == [key for key, _ in wanted for _ in ("write", "read")]
    assert [frame.data[0] & 0xE0 for frame in bench.requests] == [0x20, 0x40] * len(wanted)


@pytest.mark.parametrize("row", ROWS, ids=lambda row: str(row.number))
def test_the_drive_that_was_configured_answers_sync_as_the_contract_maps(row: Row) -> None:
    bench = Bench(row)
    for task in ("RESET", "IDENTIFY", "CONFIGURE", "START"):
        assert bench.run(task) == "DONE"
    bench.wire.take()
    bench.drive.position, bench.drive.torque = -123456, -321
    bench.wire.give(Frame(0x080, b""))
    (frame,) = bench.wire.take()
    status = C.new("tb_pdo_status")
    assert C.tb_pdo_take(byref(status), byref(C.frame(frame)))
    assert frame.id == 0x180 + row.node
    assert (status.position, status.torque, status.statusword) == (-123456, -321, 0x0240)


def every_entry(kind: str) -> list[tuple[Row, int]]:
    """All entries of all drives."""
    return [(row, entry) for row in ROWS for entry in range(len(getattr(row, kind)))]


@pytest.mark.parametrize(("task", "kind"), [("IDENTIFY", "identity"), ("CONFIGURE", "contract")])
def test_every_single_altered_object_is_named_with_what_it_holds(task: str, kind: str) -> None:
    for row, number in every_entry(kind):
        entries: list[Entry] = getattr(row, kind)
        found = entries[number].value ^ 1
        bench = Bench(row)
        bench.alter(number, found, entries)
        assert bench.run(task) == "FAILED"
        assert bench.failure == expected(entries[number], found)
        assert len(bench.drive.written) == (number + 1 if kind == "contract" else 0)


@settings(max_examples=60)
@given(st.data())
def test_any_altered_value_of_any_object_is_found(data: Any) -> None:
    row = data.draw(st.sampled_from(ROWS))
    number = data.draw(st.integers(0, len(row.contract) - 1))
    entry = row.contract[number]
    bits = data.draw(st.integers(1, 2 ** (8 * entry.size) - 1))
    bench = Bench(row)
    bench.alter(number, entry.value ^ bits, row.contract)
    assert bench.run("CONFIGURE") == "FAILED"
    assert bench.failure == expected(entry, entry.value ^ bits)


def test_an_object_of_another_length_is_different_whatever_it_holds() -> None:
    bench = Bench(CABLE)
    frame = bytes([0x4F, 0x18, 0x10, 1, CABLE.identity[0].value & 0xFF, 0, 0, 0])
    bench.order("IDENTIFY")
    bench.wire.give = lambda request: None  # type: ignore[method-assign, assignment]
    bench.cycle()
    bench.take(Frame(0x580 + CABLE.node, frame))
    bench.cycle()
    assert bench.failure == ("SIZE", 0x1018, 1, 1)


# ---- Answers of other drives ----


def untold(data: bytes, size: int) -> bytes:
    """Without a size; what is beyond the object is undefined."""
    return b"\x42" + data[1 : 4 + size] + b"\xa5\x5a\xa5"[: 4 - size]


def always_four(data: bytes, size: int) -> bytes:
    """Four bytes for any object, the rest zero."""
    return b"\x43" + data[1 : 4 + size] + bytes(4 - size)


def extended(data: bytes, size: int) -> bytes:
    """Four bytes for any object, extended by its sign."""
    rest = b"\xff" if data[3 + size] & 0x80 else b"\0"
    return b"\x43" + data[1 : 4 + size] + rest * (4 - size)


ANSWERS = (untold, always_four, extended)


@pytest.mark.parametrize("change", ANSWERS)
@pytest.mark.parametrize("row", [CABLE, BASE], ids=["cable", "base"])
def test_a_drive_that_tells_no_size_or_always_four_bytes_is_set_up(
    row: Row, change: Callable[[bytes, int], bytes]
) -> None:
    bench = Bench(row)
    bench.alter_answers(change)
    for task in ("RESET", "IDENTIFY", "CONFIGURE", "START"):
        assert bench.run(task) == "DONE", bench.failure
    assert bench.run("MODE", "HOMING") == "DONE"


@pytest.mark.parametrize("change", ANSWERS)
def test_what_such_a_drive_holds_is_compared_still(
    change: Callable[[bytes, int], bytes],
) -> None:
    for number, entry in enumerate(BASE.contract):
        bench = Bench(BASE)
        bench.alter_answers(change)
        bench.alter(number, entry.value ^ 0x01, BASE.contract)
        assert bench.run("CONFIGURE") == "FAILED"
        assert bench.failure == expected(entry, entry.value ^ 0x01)


@pytest.mark.parametrize("rest", [b"\1\0", b"\0\1", b"\xff\xff", b"\0\xff"])
def test_bytes_beyond_an_object_that_are_neither_zero_nor_its_sign_are_a_difference(
    rest: bytes,
) -> None:
    bench = Bench(CABLE)
    bench.alter_answers(lambda data, size: b"\x43" + (data[1:6] + rest) if size == 2 else data)
    entry = next(entry for entry in CABLE.contract if entry.size == 2)
    assert bench.run("CONFIGURE") == "FAILED"
    found = entry.value | int.from_bytes(rest, "little") << 16
    assert bench.failure == expected(entry, found)
    assert found != entry.value


@pytest.mark.parametrize(
    ("size", "extra", "kind"),
    [(2, 1, "DIFFERENT"), (2, 2, "DIFFERENT"), (2, 3, "SIZE"), (4, 1, "SIZE"), (4, 3, "SIZE")],
)
def test_a_longer_object_is_told_by_its_value_where_that_fits_else_by_its_size(
    size: int, extra: int, kind: str
) -> None:
    bench, rest = Bench(CABLE), b"\x11" * extra
    in_segments(bench, True, True, {size: rest})
    entry = next(entry for entry in CABLE.contract if entry.size == size)
    assert bench.run("CONFIGURE") == "FAILED"
    held = entry.value.to_bytes(entry.size, "little") + rest
    found = int.from_bytes(held, "little") if kind == "DIFFERENT" else len(held)
    assert bench.failure == (kind, entry.index, entry.subindex, found)


def in_segments(
    bench: Bench, told: bool, segment_told: bool, beyond: Mapping[int, bytes] = MappingProxyType({})
) -> None:
    """Let the drive answer every read in segments; beyond: what follows objects of a size."""
    take, give, kept = bench.wire.take, bench.wire.give, [b"", b""]

    def segmented() -> list[Frame]:
        frames = take()
        for number, frame in enumerate(frames):
            if frame.id == 0x580 + bench.row.node and frame.data[0] & 0xE2 == 0x42:
                size = 4 - (frame.data[0] >> 2 & 3)
                kept[0] = frame.data[4 : 4 + size] + beyond.get(size, b"")
                head = bytes([0x41, *frame.data[1:4], len(kept[0]), 0, 0, 0])
                frames[number] = Frame(frame.id, head if told else b"\x40" + head[1:4] + bytes(4))
        frames += [Frame(0x580 + bench.row.node, kept[1])] if kept[1] else []
        kept[1] = b""
        return frames

    def asked(frame: Frame) -> None:
        if frame.id == 0x600 + bench.row.node and frame.data[0] & 0xE0 == 0x60:
            unused = (7 - len(kept[0])) << 1 if segment_told else 0
            kept[1] = bytes([unused | 1]) + kept[0].ljust(7, b"\x77" if told else b"\0")
        else:
            give(frame)

    bench.wire.take, bench.wire.give = segmented, asked  # type: ignore[method-assign]


@pytest.mark.parametrize(
    ("told", "last"), [(True, True), (True, False), (False, True), (False, False)]
)
def test_a_drive_that_answers_in_segments_is_set_up(told: bool, last: bool) -> None:
    bench = Bench(BASE)
    in_segments(bench, told, last)
    for task in ("IDENTIFY", "CONFIGURE"):
        assert bench.run(task) == "DONE", bench.failure


# ---- Answers that are late or lost ----


def answer_late(bench: Bench, cycles: int) -> None:
    """Every SDO answer takes so many cycles."""
    take, under_way = bench.wire.take, [[] for _ in range(cycles)]  # type: ignore[var-annotated]

    def late() -> list[Frame]:
        frames = take()
        is_sdo = 0x580 + bench.row.node
        under_way.append([frame for frame in frames if frame.id == is_sdo])
        return [frame for frame in frames if frame.id != is_sdo] + under_way.pop(0)

    bench.wire.take = late  # type: ignore[method-assign]


@pytest.mark.parametrize("cycles", [1, ANSWER_TIMEOUT // 2, ANSWER_TIMEOUT - 1])
def test_answers_that_are_in_time_take_as_long_as_they_take(cycles: int) -> None:
    bench = Bench(BASE)
    answer_late(bench, cycles)
    assert bench.run("CONFIGURE", most=10**6) == "DONE"
    assert bench.setup.repeats == 0


def test_answers_that_are_always_too_late_are_silence_at_the_object_that_was_asked_for() -> None:
    bench = Bench(BASE)
    answer_late(bench, ANSWER_TIMEOUT + 1)
    assert bench.run("CONFIGURE", most=10**6) == "FAILED"
    failure, index, subindex, _ = bench.failure
    assert failure == "SILENT"
    assert (index, subindex) == (BASE.contract[0].index, BASE.contract[0].subindex)


@pytest.mark.parametrize("lost", ["request", "answer"])
@pytest.mark.parametrize("numbers", [{0}, {1}, {0, 1}, {7, 30}, {40, 41}])
def test_a_frame_that_gets_lost_is_asked_for_again(lost: str, numbers: set[int]) -> None:
    bench = Bench(BASE)
    lose(bench, lost, numbers)
    assert bench.run("CONFIGURE", most=10**5) == "DONE"
    assert (bench.setup.repeats, bench.setup.sdo.extra) == (len(numbers), 0)
    wanted = [((entry.index, entry.subindex), entry.value) for entry in BASE.contract]
    assert [
        one for n, one in enumerate(bench.drive.written) if one != bench.drive.written[n - 1]
    ] == wanted


def test_a_third_frame_that_gets_lost_in_one_task_is_silence() -> None:
    bench = Bench(BASE)
    lose(bench, "answer", {3, 20, 50})
    assert bench.run("CONFIGURE", most=10**5) == "FAILED"
    assert bench.failure[0] == "SILENT"
    lose(bench, "answer", set())
    bench.order("NONE")
    assert bench.run("CONFIGURE", most=10**5) == "DONE"


def lose(bench: Bench, what: str, numbers: set[int]) -> None:
    """Requests or answers of these numbers, counted from 0, get lost."""
    count, give, take = iter(range(10**6)), bench.wire.give, bench.wire.take
    request, answer = 0x600 + bench.row.node, 0x580 + bench.row.node

    def is_lost(frame: Frame, identifier: int) -> bool:
        is_abort = frame.data[:1] == b"\x80"
        return frame.id == identifier and not is_abort and next(count) in numbers

    if what == "request":
        bench.wire.give = (  # type: ignore[method-assign]
            lambda frame: None if is_lost(frame, request) else give(frame)
        )
    else:
        bench.wire.take = lambda: [  # type: ignore[method-assign]
            frame for frame in take() if not is_lost(frame, answer)
        ]


@pytest.mark.parametrize("code", [0x06020000, 0x06090030, 0x08000022, 0x0F00FFC0])
@pytest.mark.parametrize("number", [0, 7, len(BASE.contract) - 1])
def test_an_abort_is_reported_with_its_code_and_object(number: int, code: int) -> None:
    bench, entry, count = Bench(BASE), BASE.contract[number], 0

    def refuse(**fields: Any) -> None:
        nonlocal count
        count += 1
        if count == number + 1:
            raise SdoAbortedError(code)

    bench.drive.node.add_write_callback(refuse)
    assert bench.run("CONFIGURE") == "FAILED"
    assert bench.failure == ("ABORT", entry.index, entry.subindex, code)


def test_a_drive_that_does_not_answer_is_silent_at_the_object_it_was_asked_for() -> None:
    bench = Bench(CABLE)
    bench.answers = 0
    assert bench.run("CONFIGURE") == "FAILED"
    assert bench.failure == ("SILENT", CABLE.contract[0].index, CABLE.contract[0].subindex, 0)


@pytest.mark.parametrize("task", ["IDENTIFY", "CONFIGURE", "MODE"])
def test_two_drives_with_one_number_are_found_out(task: str) -> None:
    bench = Bench(CABLE)
    bench.answers = 2
    assert bench.run(task, "TORQUE") == "FAILED"
    assert bench.failure[0] == "TWICE"


def test_a_drive_that_does_not_boot_is_silent() -> None:
    bench = Bench(CABLE)
    bench.answers = 0
    assert bench.run("RESET") == "FAILED"
    assert bench.failure == ("SILENT", 0, 0, 0)


def test_a_boot_up_message_from_before_the_reset_is_no_second_drive() -> None:
    bench = Bench(CABLE)
    for _ in range(3):
        bench.take(Frame(0x700 + CABLE.node, b"\0"))
    assert bench.run("RESET") == "DONE"


@pytest.mark.parametrize("after", [0, 1, 49, 200, 1900])
def test_a_drive_that_boots_twice_is_waited_for(after: int) -> None:
    bench = Bench(CABLE)
    bench.order("RESET")
    bench.cycle()
    assert (bench.heartbeat.boots, bench.progress) == (1, "BUSY")
    for _ in range(min(after, SETTLE)):
        bench.cycle()
    bench.take(Frame(0x700 + CABLE.node, b"\0"))
    for _ in range(SETTLE if after < SETTLE else 0):
        bench.cycle()
        assert bench.progress == "BUSY"
    for task in ("RESET", "IDENTIFY", "CONFIGURE", "START"):
        assert bench.run(task) == "DONE", bench.failure


def boots_late(bench: Bench, cycles: int) -> None:
    """Every boot-up message of the drive comes so many cycles later."""
    take, under_way = bench.wire.take, [[] for _ in range(cycles)]  # type: ignore[var-annotated]

    def late() -> list[Frame]:
        frames = take()
        boots = [frame for frame in frames if frame == Frame(0x700 + bench.row.node, b"\0")]
        under_way.append(boots)
        return [frame for frame in frames if frame not in boots] + under_way.pop(0)

    bench.wire.take = late  # type: ignore[method-assign]


@pytest.mark.parametrize(
    ("cycles", "result"),
    [(STATE_TIMEOUT // 2, "DONE"), (STATE_TIMEOUT - 1, "DONE"), (STATE_TIMEOUT + 2, "FAILED")],
)
def test_a_boot_up_message_may_come_late_within_the_time_for_it(cycles: int, result: str) -> None:
    bench = Bench(CABLE)
    boots_late(bench, cycles)
    assert bench.run("RESET") == result
    assert bench.failure[0] == ("NONE" if result == "DONE" else "SILENT")


def test_a_drive_that_boots_again_and_again_is_given_up() -> None:
    bench = Bench(CABLE)
    bench.order("RESET")
    for cycle in range(3 * STATE_TIMEOUT):
        if cycle % SETTLE == SETTLE // 2:
            bench.take(Frame(0x700 + CABLE.node, b"\0"))
        bench.cycle()
    assert (bench.progress, bench.failure[0]) == ("FAILED", "RESTARTED")


def test_a_second_boot_up_message_that_is_late_does_not_keep_it_from_being_identified() -> None:
    bench = Bench(CABLE)
    assert bench.run("RESET") == "DONE"
    bench.order("IDENTIFY")
    bench.cycle()
    bench.take(Frame(0x700 + CABLE.node, b"\0"))
    assert bench.run("IDENTIFY") == "DONE"
    bench.take(Frame(0x700 + CABLE.node, b"\0"))
    bench.cycle()
    assert bench.run("CONFIGURE") == "DONE"


@pytest.mark.parametrize("task", ["CONFIGURE", "START"])
def test_a_drive_that_restarts_once_its_configuration_has_begun_is_found_out(task: str) -> None:
    bench = Bench(CABLE)
    assert bench.run("RESET") == "DONE"
    if task == "START":
        assert bench.run("CONFIGURE") == "DONE"
    bench.answered = False
    bench.order(task)
    for _ in range(20):
        bench.cycle()
    bench.drive.boot()
    for _ in range(3):
        bench.cycle()
    assert (bench.progress, bench.failure[0]) == ("FAILED", "RESTARTED")


def test_a_drive_is_started_once_its_heartbeat_says_so_and_it_answered() -> None:
    bench = Bench(CABLE)
    for task in ("RESET", "CONFIGURE"):
        assert bench.run(task) == "DONE"
    bench.answered = False
    bench.order("START")
    for _ in range(100):
        bench.cycle()
    assert (bench.progress, bench.setup.operational) == ("BUSY", 0)
    bench.answered = True
    bench.cycle()
    assert (bench.progress, bench.setup.operational) == ("DONE", 1)


def test_a_drive_that_is_never_operational_is_silent() -> None:
    bench = Bench(CABLE)
    assert bench.run("CONFIGURE") == "DONE"
    bench.answered = False
    assert bench.run("START") == "FAILED"
    assert bench.failure == ("SILENT", 0, 0, 0)


@pytest.mark.parametrize(("mode", "number"), [("TORQUE", 10), ("POSITION", 8), ("HOMING", 6)])
def test_a_mode_is_confirmed_by_the_drive(mode: str, number: int) -> None:
    bench = Bench(BASE)
    assert bench.run("MODE", mode) == "DONE"
    assert bench.drive.mode == number
    assert bench.setup.mode == getattr(C, f"TB_MODE_{mode}")


def test_a_mode_that_shows_late_is_waited_for() -> None:
    bench, asked = Bench(BASE), 0

    def shows_late(key: tuple[int, int], held: int) -> int:
        nonlocal asked
        asked += key == (0x6061, 0)
        return 0 if key == (0x6061, 0) and asked < 30 else held

    bench.drive.read = shows_late
    assert bench.run("MODE", "HOMING") == "DONE"
    assert asked == 30


def test_a_mode_that_never_shows_is_different() -> None:
    bench = Bench(BASE)
    bench.drive.read = lambda key, held: 3 if key == (0x6061, 0) else held
    assert bench.run("MODE", "HOMING") == "FAILED"
    assert bench.failure == ("DIFFERENT", 0x6061, 0, 3)
    assert bench.setup.mode == C.TB_MODE_NONE


def test_an_ordered_mode_that_reads_back_otherwise_is_different_at_once() -> None:
    bench, asked = Bench(BASE), 0

    def reads_back(key: tuple[int, int], held: int) -> int:
        nonlocal asked
        asked += key == (0x6060, 0)
        return 3 if key == (0x6060, 0) else held

    bench.drive.read = reads_back
    assert bench.run("MODE", "HOMING") == "FAILED"
    assert bench.failure == ("DIFFERENT", 0x6060, 0, 3)
    assert asked == 1


def test_a_mode_may_show_until_its_time_is_over_to_the_cycle() -> None:
    bench, cycles = Bench(BASE), 0
    bench.drive.read = lambda key, held: 3 if key == (0x6061, 0) else held
    bench.order("MODE", "HOMING")
    while bench.progress == "BUSY":
        bench.cycle()
        cycles += 1
    assert cycles == STATE_TIMEOUT + 1


def test_every_mode_has_its_own_time_to_show() -> None:
    bench, asked = Bench(BASE), 0
    bench.drive.read = lambda key, held: 3 if key == (0x6061, 0) else held
    assert bench.run("MODE", "HOMING") == "FAILED"

    def shows_late(key: tuple[int, int], held: int) -> int:
        nonlocal asked
        asked += key == (0x6061, 0)
        return 0 if key == (0x6061, 0) and asked < 30 else held

    bench.drive.read = shows_late
    assert bench.run("MODE", "TORQUE") == "DONE"


def test_a_drive_has_its_time_from_the_command_on_however_late_its_bus_takes_it() -> None:
    bench = Bench(CABLE)
    bench.answers = 0
    bench.order("RESET")
    for _ in range(300):
        C.tb_setup_advance(byref(bench.setup), byref(bench.heartbeat), bench.answered)
    for _ in range(STATE_TIMEOUT):
        bench.cycle()
        assert bench.progress == "BUSY"
    bench.cycle()
    assert bench.progress == "FAILED"


def test_no_mode_is_confirmed_while_it_changes() -> None:
    bench = Bench(BASE)
    assert bench.run("MODE", "HOMING") == "DONE"
    bench.order("MODE", "TORQUE")
    assert bench.setup.mode == C.TB_MODE_NONE
    assert bench.run("MODE", "TORQUE") == "DONE"
    assert bench.drive.mode == 10


def test_a_task_is_done_once_and_again_after_another() -> None:
    bench = Bench(CABLE)
    assert bench.run("IDENTIFY") == "DONE"
    sent = len(bench.requests)
    assert bench.run("IDENTIFY") == "DONE"
    assert len(bench.requests) == sent
    bench.order("NONE")
    assert bench.progress == "IDLE"
    assert bench.run("IDENTIFY") == "DONE"
    assert len(bench.requests) == 2 * sent


def test_a_task_that_another_one_interrupts_leaves_no_second_drive_behind() -> None:
    bench = Bench(CABLE)
    bench.order("CONFIGURE")
    for _ in range(10):
        bench.cycle()
    frame = C.new("tb_can_frame")
    C.tb_setup_frame(byref(bench.setup), byref(bench.heartbeat), byref(frame))
    bench.order("IDENTIFY")  # while an answer is under way
    bench.wire.give(read(frame))
    assert bench.run("IDENTIFY") == "DONE"
    assert bench.setup.sdo.extra == 0
