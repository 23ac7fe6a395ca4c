"""Flight recordings: recorded before ideal drives, run again to the bit, refused when damaged."""

import csv
import ctypes
import shutil
import struct
import zlib
from pathlib import Path

import numpy as np
import pytest
from flown import SEGMENT_CYCLES, SEGMENTS, Flight, Follower, library, library_file
from numpy.typing import NDArray
from pyarrow import parquet
from supervised import CORE, RESET, STOCK, Cause, Observation, Power, State
from typer.testing import CliRunner

from turnbuckle.codegen.compile import compile_library
from turnbuckle.codegen.struct_layout import ROW, STRUCT
from turnbuckle.command_line import app
from turnbuckle.lab.flight import FlightError
from turnbuckle.lab.flight.recording import (
    HEADER,
    Places,
    Recording,
    checksum_of,
    header_of,
    layouts_of,
    places_of,
    read_recording,
)
from turnbuckle.lab.flight.replay import (
    Supervisor,
    compile_supervisor,
    places_in,
    run_again,
    supervisor_sources,
)
from turnbuckle.lab.flight.table import times

MACHINE = STOCK.parents[1] / "machines" / "yoon2023.toml"


def drive_fails(seen: Observation) -> None:
    """Drive 2 has an over-current."""
    seen.drives[2].power = Power.FAULT
    seen.drives[2].error_code, seen.drives[2].error_class = 0x2310, 2


def flown() -> Flight:
    """From power-on to RUN, under a force, until a drive fails."""
    flight = Flight()
    flight.machine.arm()
    flight.machine.run(30000, lambda orders: orders.state == State.RUN)
    flight.machine.seen.force[0] = 2.0
    flight.machine.run(200)
    flight.machine.run(1, spoil=drive_fails)
    flight.machine.drives[2].power = Power.FAULT
    flight.machine.run(1000)
    return flight


@pytest.fixture(scope="module")
def content() -> bytes:
    """A recording from power-on to FAULT."""
    return flown().read_out()


@pytest.fixture(scope="module")
def dump(content: bytes, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The same as a file."""
    path = tmp_path_factory.mktemp("flight") / "flight.dump"
    path.write_bytes(content)
    return path


@pytest.fixture(scope="module")
def recording(dump: Path) -> Recording:
    """The same, read."""
    return read_recording(dump, MACHINE)


@pytest.fixture(scope="module")
def supervisor() -> Supervisor:
    """The stock machine's C."""
    return Supervisor(library_file())


def places(content: bytes) -> Places:
    """Where everything is in a recording."""
    header = header_of(Path(), content)
    return places_of(Path(), content, header, layouts_of(Path(), content, header))


def sealed(content: bytes, segment: int) -> bytes:
    """A changed recording with the right checksum of a segment."""
    found = places(content)
    at, end = place_of(found, segment)
    changed = bytearray(content)
    struct.pack_into("<I", changed, at + 12, checksum_of(content, found.segment, at, end))
    return bytes(changed)


def place_of(found: Places, segment: int) -> tuple[int, int]:
    """Where a segment begins, and where its last cycle ends."""
    at = found.begin + segment * found.size
    count = int(np.frombuffer(found.content, found.segment, 1, at)[0]["count"])
    return at, at + found.head + count * found.cycle.itemsize


def test_a_recording_is_read_as_it_was_recorded(recording: Recording) -> None:
    states = recording.cycles["orders"]["state"]
    assert {State(state).name for state in np.unique(states)} >= {
        "INIT",
        "CONFIGURE",
        "HOME",
        "TENSION",
        "RUN",
        "FAULT",
    }
    assert np.array_equal(recording.numbers, np.arange(len(states)))
    last = recording.cycles[-1]["orders"]
    assert (last["cause"], last["culprit"]) == (Cause.DRIVE_FAULT, 2)
    forces = recording.cycles["seen"]["force"][:, 0]
    assert (forces[0], forces[-1]) == (0.0, 2.0)


def test_the_size_of_a_recording_is_known_before_it_is_made(content: bytes) -> None:
    header = np.frombuffer(content, HEADER, 1)[0]
    begin = HEADER.itemsize + int(header["layout_rows"]) * ROW.itemsize
    sizes = [library().tb_recording_size(segments) for segments in (0, 1, SEGMENTS)]
    assert sizes == [begin + count * int(header["segment_size"]) for count in (0, 1, SEGMENTS)]
    assert len(content) <= sizes[-1]


def test_every_order_is_the_same_again_to_the_bit(
    recording: Recording, supervisor: Supervisor
) -> None:
    found = run_again(recording, supervisor)
    assert found.difference is None
    assert found.matched == len(recording.numbers) > 5000


@pytest.mark.parametrize("field", ["torque", "goal"])
def test_a_flipped_bit_in_a_recorded_order_is_found_where_it_is(
    recording: Recording, supervisor: Supervisor, field: str
) -> None:
    spoilt = copied(recording)
    cycle = 3 * SEGMENT_CYCLES + 17
    numbers = spoilt.segments[3].cycles["orders"]["drives"][field]
    numbers[17, 5] = np.nextafter(numbers[17, 5], 1.0) if field == "torque" else numbers[17, 5] ^ 1
    found = run_again(spoilt, supervisor)
    assert found.difference is not None
    assert (found.difference.cycle, found.difference.field) == (cycle, f"drives.{field}[5]")
    assert found.matched == cycle


def test_a_changed_measurement_is_found(recording: Recording, supervisor: Supervisor) -> None:
    spoilt = copied(recording)
    running = int(np.flatnonzero(spoilt.cycles["orders"]["state"] == State.RUN)[0])
    segment = spoilt.segments[running // SEGMENT_CYCLES]
    at = running % SEGMENT_CYCLES
    segment.cycles["seen"]["drives"]["position"][at, 1] += 1e-9
    found = run_again(spoilt, supervisor)
    assert found.difference is not None
    assert found.difference.cycle == running


def test_a_changed_memory_is_found(recording: Recording, supervisor: Supervisor) -> None:
    spoilt = copied(recording)
    spoilt.segments[5].before[0] ^= 1  # the state
    found = run_again(spoilt, supervisor)
    assert found.difference is not None
    assert found.difference.cycle == 5 * SEGMENT_CYCLES


def test_a_changed_constant_in_the_c_is_found(recording: Recording, tmp_path: Path) -> None:
    for path in STOCK.glob("*.[ch]"):
        text = path.read_text()
        if path.name == "tb_machine.h":
            assert "#define TB_TENSION_MIN TB_C(3.0)" in text
            text = text.replace("TB_TENSION_MIN TB_C(3.0)", "TB_TENSION_MIN TB_C(3.0000001)")
        (tmp_path / path.name).write_text(text)
    found = run_again(recording, compile_supervisor(tmp_path, "double"))
    assert found.difference is not None
    assert "torque" in found.difference.field


def copied(recording: Recording) -> Recording:
    """A recording whose arrays can be changed."""
    segments = [
        type(segment)(segment.first, segment.before.copy(), segment.cycles.copy())
        for segment in recording.segments
    ]
    return type(recording)(
        recording.path, recording.machine, recording.hash, recording.layouts, segments
    )


def test_the_ring_keeps_the_last_cycles_and_holds_still_after_a_fault(
    tmp_path: Path, supervisor: Supervisor
) -> None:
    path, ring = tmp_path / "long.dump", SEGMENTS * SEGMENT_CYCLES
    long = Flight()
    long.machine.run(ring + 3 * SEGMENT_CYCLES + 5)
    path.write_bytes(long.read_out())
    before = read_recording(path, MACHINE)
    assert before.numbers[-1] == ring + 3 * SEGMENT_CYCLES + 4
    assert len(before.segments) == SEGMENTS
    assert before.numbers[0] == 4 * SEGMENT_CYCLES

    fault = long.machine.cycle
    long.machine.run(1, spoil=drive_fails)
    long.machine.run(ring)
    path.write_bytes(long.read_out())
    held = read_recording(path, MACHINE)
    assert held.numbers[-1] == fault + ring // 2 - 1
    assert np.flatnonzero(held.cycles["orders"]["cause"])[0] == fault - held.numbers[0]

    long.machine.seen.requests = RESET
    long.machine.run(1)
    long.machine.seen.requests = 0
    long.machine.run(100)
    path.write_bytes(long.read_out())
    after = read_recording(path, MACHINE)
    assert np.max(np.diff(after.numbers)) > ring // 4  # what nobody needs was not recorded
    assert after.numbers[-1] == long.machine.cycle - 1
    for one in (before, held, after):
        assert run_again(one, supervisor).matched == len(one.numbers)


def test_what_is_read_while_it_is_recorded_is_the_same_as_at_the_end(
    tmp_path: Path, supervisor: Supervisor
) -> None:
    flight, path, ring = Flight(), tmp_path / "followed.dump", SEGMENTS * SEGMENT_CYCLES
    follower = Follower(flight)
    assert follower.follow((0, 0)) == follower.follow(flight.mark()) == 0
    for cycles in (1, 1, SEGMENT_CYCLES - 2, 1, 3 * SEGMENT_CYCLES + 7, 2 * ring, 5):
        flight.machine.run(cycles)
        early = flight.mark()
        flight.machine.run(3)  # kept behind the mark, and not to be read yet
        assert 0 < follower.follow(early) <= 4 * (SEGMENTS + 1)  # not what was overtaken
        assert follower.follow(early) == 0
        path.write_bytes(follower.content)
        found = read_recording(path, MACHINE)
        assert found.numbers[-1] == flight.machine.cycle - 4
        assert [flaw for flaw in found.flaws if "segment" in flaw] == []
        assert run_again(found, supervisor).matched == len(found.numbers)
    assert follower.follow(flight.mark()) > 0
    path.write_bytes(follower.content)
    followed = bytes_of(read_recording(path, MACHINE))
    path.write_bytes(flight.read_out())
    assert followed == bytes_of(read_recording(path, MACHINE))


def bytes_of(recording: Recording) -> bytes:
    """The cycles as they are in the file."""
    return b"".join(segment.cycles.tobytes() for segment in recording.segments)


def test_of_a_recording_cut_anywhere_every_whole_cycle_is_read(
    content: bytes, recording: Recording, supervisor: Supervisor, tmp_path: Path
) -> None:
    there = places(content)
    head, size, cycle = there.head, there.size, there.cycle.itemsize
    first = there.begin + head
    path = tmp_path / "cut.dump"
    random = np.random.default_rng(2)
    anywhere = random.integers(first + cycle, len(content), 9)
    for cut in (first + cycle, first + size, len(content) // 2, *anywhere):
        path.write_bytes(content[: int(cut)])
        found = read_recording(path, MACHINE)
        full, rest = divmod(int(cut) - there.begin, size)
        whole = full * SEGMENT_CYCLES + max(0, min(SEGMENT_CYCLES, (rest - head) // cycle))
        whole = min(whole, len(recording.numbers))
        assert np.array_equal(found.numbers, recording.numbers[:whole])
        assert bytes_of(found) == bytes_of(recording)[: whole * cycle]
        assert f"cut off after {cut} bytes: " in found.flaws[0] or whole == len(recording.numbers)
        again = run_again(found, supervisor)
        assert again.difference is None
        assert whole - SEGMENT_CYCLES < again.matched <= whole


@pytest.mark.parametrize("size", [8, 100, HEADER.itemsize, HEADER.itemsize + 20, 23_000])
def test_a_recording_without_a_whole_cycle_is_refused(
    content: bytes, tmp_path: Path, size: int
) -> None:
    path = tmp_path / "cut.dump"
    path.write_bytes(content[:size])
    with pytest.raises(FlightError, match=f"cut off after {size} bytes"):
        read_recording(path, MACHINE)


def test_a_damaged_segment_is_left_out_and_the_others_are_read(
    content: bytes, recording: Recording, tmp_path: Path
) -> None:
    path = tmp_path / "damaged.dump"
    there = places(content)
    for place in (0, 9, 13, 20, there.head + 100_000):
        damaged = bytearray(content)
        damaged[there.begin + 3 * there.size + place] ^= 0x10
        path.write_bytes(damaged)
        found = read_recording(path, MACHINE)
        assert found.flaws == ["damaged: 1 segment is left out"]
        kept = recording.numbers // SEGMENT_CYCLES != 3
        assert np.array_equal(found.numbers, recording.numbers[kept])


def test_a_recording_that_was_not_ended_says_so(content: bytes, tmp_path: Path) -> None:
    header = np.frombuffer(content, HEADER, 1).copy()
    header["ended"] = 0
    path = tmp_path / "live.dump"
    path.write_bytes(header.tobytes() + content[HEADER.itemsize :])
    assert "the program still runs, or was killed" in read_recording(path, MACHINE).flaws[0]


def spoilt_at_random(content: bytes, random: np.random.Generator) -> bytes:
    """A recording with flipped bits, in its header or elsewhere, and cut off perhaps."""
    spoilt = bytearray(content)
    for _ in range(random.integers(1, 4)):
        most = HEADER.itemsize if random.random() < 0.6 else len(spoilt)
        spoilt[random.integers(most)] ^= 1 << int(random.integers(8))
    cut = int(random.integers(len(spoilt))) if random.random() < 0.5 else len(spoilt)
    return bytes(spoilt[:cut])


def test_whatever_is_done_to_a_recording_gives_rows_or_one_sentence(
    content: bytes, supervisor: Supervisor, tmp_path: Path
) -> None:
    path, random = tmp_path / "spoilt.dump", np.random.default_rng(3)
    rows = sentences = 0
    for _ in range(60):
        path.write_bytes(spoilt_at_random(content, random))
        try:
            found = read_recording(path, MACHINE)
            run_again(found, supervisor)
        except FlightError as refusal:
            assert str(refusal).startswith(f"{path}: ") and "\n" not in str(refusal)
            sentences += 1
        else:
            assert len(found.numbers) and len(times(found)) == len(found.numbers)
            rows += 1
    assert rows > 10 and sentences > 10


@pytest.mark.parametrize("seed", range(2))
def test_log_makes_a_table_and_a_picture_of_what_is_left(
    content: bytes, tmp_path: Path, seed: int
) -> None:
    path, random = tmp_path / "spoilt.dump", np.random.default_rng(seed)
    spoilt = bytearray(content[: len(content) * (2 + 3 * seed) // 6])
    for place in random.integers(places(content).begin, len(spoilt), 50):
        spoilt[place] ^= 1 << int(random.integers(8))
    path.write_bytes(spoilt)
    table, picture = tmp_path / "log.csv", tmp_path / "log.png"
    command = ["log", str(path), str(MACHINE), "--out", str(table), "--plot", str(picture)]
    result = CliRunner().invoke(app, command)
    assert result.stderr.count("\n") == 1 and "cut off" in result.stderr, result.stderr
    assert (result.exit_code == 0) == table.exists() == picture.exists()


@pytest.mark.parametrize(
    ("name", "value", "words_of_refusal"),
    [
        ("magic", b"PK", "no flight recording"),
        ("version", 2, "version 2; allowed: 3"),
        ("byte_order", 0x04030201, "other byte order"),
        ("layout_rows", 7, "the description of its structs has another checksum"),
        ("layout_rows", 2**32 - 1, "cut off after"),
        ("layout_checksum", 0, "the description of its structs has another checksum"),
        ("machine", b"brau_five", "of machine 'brau_five'; .* is 'yoon2023'"),
        ("head_size", 8, "behind 8 bytes do not *fit"),
        ("head_size", 2**32 - 1, "do not fit into"),
        ("segment_size", 1000, "do not fit into the 1000 bytes"),
        ("segment_cycles", 0, "0 cycles"),
        ("segment_cycles", 2**32 - 1, "do not fit into"),
        ("machine", b"two\nlines", "of machine 'two"),
    ],
)
def test_a_header_that_is_not_ours_is_refused(
    content: bytes, tmp_path: Path, name: str, value: object, words_of_refusal: str
) -> None:
    header = np.frombuffer(content, HEADER, 1).copy()
    header[name] = value
    path = tmp_path / "other.dump"
    path.write_bytes(header.tobytes() + content[HEADER.itemsize :])
    with pytest.raises(FlightError, match=words_of_refusal) as refusal:
        read_recording(path, MACHINE)
    assert "\n" not in str(refusal.value)


def described(content: bytes, struct: str, member: str, **changes: object) -> bytes:
    """A recording whose description tells something else of a member."""
    header = np.frombuffer(content, HEADER, 1).copy()
    rows = np.frombuffer(content, ROW, int(header["layout_rows"][0]), HEADER.itemsize).copy()
    first = int(np.flatnonzero((rows["name"] == struct.encode()) & (rows["kind"] == STRUCT))[0])
    at = first + 1 + int(np.flatnonzero(rows["name"][first + 1 :] == member.encode())[0])
    for name, value in changes.items():
        rows[name][at] = value
    header["layout_checksum"] = zlib.crc32(rows.tobytes())
    rest = content[HEADER.itemsize + rows.nbytes :]
    return header.tobytes() + rows.tobytes() + rest


@pytest.mark.parametrize(
    ("struct", "member"), [("orders", "cause"), ("drive_report", "power"), ("outputs", "pose")]
)
def test_a_recording_without_a_member_that_is_read_is_refused_by_its_name(
    content: bytes, tmp_path: Path, struct: str, member: str
) -> None:
    path = tmp_path / "other.dump"
    path.write_bytes(described(content, struct, member, name=b"another"))
    wanted = f"{path}: recorded by a program of version .*: tb_{struct} has no member {member}, "
    with pytest.raises(FlightError, match=wanted) as refusal:
        read_recording(path, MACHINE)
    assert "\n" not in str(refusal.value)


@pytest.mark.parametrize(
    ("changes", "words_of_refusal"),
    [
        ({"at": 2**31}, "tb_orders is described wrongly"),
        ({"size": 3}, "member 'cause' is described wrongly"),
        ({"count": 2**31}, "tb_orders is described wrongly"),
        ({"kind": 0}, "member 'cause' is described wrongly"),
    ],
)
def test_a_description_that_contradicts_itself_is_refused(
    content: bytes, tmp_path: Path, changes: dict[str, object], words_of_refusal: str
) -> None:
    path = tmp_path / "other.dump"
    path.write_bytes(described(content, "orders", "cause", **changes))
    with pytest.raises(FlightError, match=words_of_refusal) as refusal:
        read_recording(path, MACHINE)
    assert "\n" not in str(refusal.value)


SWAPPED = (
    "    uint8_t state;           /* tb_state */\n    uint8_t phase;           /* tb_phase */\n",
    "    uint8_t phase;\n    uint8_t state;\n",
)


def test_members_that_the_c_swaps_are_read_by_their_names_and_not_replayed_by_other_c(
    content: bytes, recording: Recording, tmp_path: Path
) -> None:
    core = tmp_path / "core"
    shutil.copytree(CORE, core)
    text = (core / "cycle.h").read_text()
    assert text.count(SWAPPED[0]) == 1
    (core / "cycle.h").write_text(text.replace(*SWAPPED))
    library = compile_library(supervisor_sources(STOCK, core), [STOCK, core])
    swapped = Supervisor(library)
    layout, moved = (
        places_in(one.struct("orders")) for one in (recording.layouts, swapped.layouts)
    )
    assert (layout["state"], layout["phase"]) == (moved["phase"], moved["state"])
    with pytest.raises(
        FlightError, match=r"tb_recorded_cycle\.orders\.state is laid out otherwise"
    ):
        run_again(recording, swapped)
    path = tmp_path / "swapped.dump"
    path.write_bytes(moved_as(content, recording, rows_in(library)))
    again = read_recording(path, MACHINE)
    for name in ("state", "phase"):
        found, wanted = (one.cycles["orders"][name] for one in (again, recording))
        assert np.array_equal(found, wanted)


def rows_in(library: Path) -> NDArray[np.void]:
    """The description in a library."""
    loaded = ctypes.CDLL(str(library))
    count = ctypes.c_uint32.in_dll(loaded, "tb_recording_layout_rows").value
    content = (ctypes.c_char * (count * ROW.itemsize)).in_dll(loaded, "tb_recording_layout")
    return np.frombuffer(bytes(content), ROW)


def moved_as(content: bytes, recording: Recording, rows: NDArray[np.void]) -> bytes:
    """The recording that a program would have written whose C swaps state and phase."""
    header = np.frombuffer(content, HEADER, 1).copy()
    header["layout_checksum"] = zlib.crc32(rows.tobytes())
    begin = HEADER.itemsize + rows.nbytes
    changed = bytearray(header.tobytes() + rows.tobytes() + content[begin:])
    there = places(content)
    cycle, orders = (
        places_in(recording.layouts.struct(name)) for name in ("recorded_cycle", "orders")
    )
    swapped = [cycle["orders"][1] + orders[name][1] for name in ("state", "phase")]
    for segment in range(len(recording.segments)):
        at, end = place_of(there, segment)
        for cycle_at in range(at + there.head, end, there.cycle.itemsize):
            one, two = (cycle_at + place for place in swapped)
            changed[one], changed[two] = changed[two], changed[one]
        struct.pack_into(
            "<I", changed, at + 12, checksum_of(bytes(changed), there.segment, at, end)
        )
    return bytes(changed)


def test_a_header_that_tells_of_more_segments_than_there_are_is_told(
    content: bytes, recording: Recording, tmp_path: Path
) -> None:
    header = np.frombuffer(content, HEADER, 1).copy()
    header["segments"] += 2
    path = tmp_path / "more.dump"
    path.write_bytes(header.tobytes() + content[HEADER.itemsize :])
    found = read_recording(path, MACHINE)
    assert np.array_equal(found.numbers, recording.numbers)
    assert "2 segments are not whole, or not there" in found.flaws[0]


def test_replay_says_that_every_cycle_matched(dump: Path, recording: Recording) -> None:
    result = CliRunner().invoke(app, ["replay", str(dump)])
    assert (result.exit_code, result.stderr) == (0, "")
    assert f"all {len(recording.numbers)} cycles ordered the same again" in result.stdout


def test_replay_names_the_first_difference(content: bytes, tmp_path: Path) -> None:
    number = int(np.frombuffer(content, HEADER, 1)[0]["segments"]) - 1
    there = places(content)
    _, end = place_of(there, number)
    spoilt = bytearray(content)
    spoilt[end - there.cycle["orders"].itemsize + 7] ^= 0x80  # sign of the first drive's torque
    path = tmp_path / "spoilt.dump"
    path.write_bytes(sealed(bytes(spoilt), number))
    result = CliRunner().invoke(app, ["replay", str(path), str(MACHINE)])
    assert result.exit_code == 1
    assert "drives.torque[0] was -0.0 when recorded, now it is 0.0" in result.stdout


@pytest.mark.parametrize("command", [["replay"], ["log", "--out", "log.csv"]])
def test_what_cannot_be_read_is_told_in_one_line(tmp_path: Path, command: list[str]) -> None:
    path = tmp_path / "flight.dump"
    path.write_text("no recording")
    for given in (path, tmp_path / "missing.dump"):
        result = CliRunner().invoke(app, [*command, str(given)])
        assert (result.exit_code, result.stdout) == (2, "")
        assert result.stderr.startswith(f"turnbuckle: {given}: ")
        assert result.stderr.count("\n") == 1


def test_replay_refuses_a_machine_file_that_has_changed(dump: Path, tmp_path: Path) -> None:
    changed = tmp_path / "yoon2023.toml"
    changed.write_text(MACHINE.read_text().replace('min = "3 N"', 'min = "2.9 N"'))
    result = CliRunner().invoke(app, ["replay", str(dump), str(changed)])
    assert (result.exit_code, result.stdout) == (2, "")
    assert f"{changed} has " in result.stderr


def test_the_log_has_units_in_its_columns_and_words_in_its_cells(
    dump: Path, recording: Recording, tmp_path: Path
) -> None:
    tables = [tmp_path / "log.csv", tmp_path / "log.parquet"]
    picture = tmp_path / "log.png"
    for path in tables:
        plot = ["--plot", str(picture)] if path.suffix == ".csv" else []
        result = CliRunner().invoke(app, ["log", str(dump), "--out", str(path), *plot])
        assert (result.exit_code, result.stderr) == (0, "")
    assert picture.read_bytes().startswith(b"\x89PNG")
    with tables[0].open() as stream:
        rows = list(csv.DictReader(stream))
    assert len(rows) == len(recording.numbers)
    last = rows[-1]
    assert (last["state"], last["cause"], last["culprit"]) == ("fault", "drive fault", "2")
    running = next(row for row in rows if row["state"] == "run")
    assert float(running["pose_x_m"]) == pytest.approx(0.39, abs=1e-5)
    assert float(running["cable_1_tension_N"]) >= 3.0 - 1e-9
    assert running["base_4_power"] == "enabled"
    assert running["bus_cable1_state"] == "active"
    assert "arm" in {row["requests"] for row in rows}
    again = parquet.read_table(tables[1])
    assert again.column_names == list(last)
    assert again["time_s"].to_pylist()[-1] == pytest.approx(float(last["time_s"]))


def test_a_log_of_another_kind_is_refused(dump: Path, tmp_path: Path) -> None:
    result = CliRunner().invoke(app, ["log", str(dump), "--out", str(tmp_path / "log.xlsx")])
    assert result.exit_code == 2
    assert "allowed: .csv, .parquet" in result.stderr


def test_the_words_are_those_of_the_description(recording: Recording) -> None:
    assert recording.layouts.word("state", State.SOFT_STOP) == "soft stop"
    assert recording.layouts.word("cause", Cause.CABLE_BREAK) == "cable break"
    assert recording.layouts.word("cause", 250) == "250"
    assert recording.layouts.word("bus_state", 3) == "off"


def test_time_goes_on_over_skipped_cycles(recording: Recording) -> None:
    spoilt = copied(recording)
    spoilt.segments[0].cycles["seen"]["missed"][10] = 2
    passed = np.diff(times(spoilt))
    assert passed[9] == pytest.approx(0.003)
    assert np.allclose(np.delete(passed, 9), 0.001)
