"""The shared file of a program: layout, and what a reader sees while it is being written."""

import os
import subprocess
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from turnbuckle.codegen.compile import compile_program
from turnbuckle.codegen.struct_layout import ROW, STRUCT
from turnbuckle.command_line import app
from turnbuckle.lab.live import LiveError, NothingYetError
from turnbuckle.lab.live.program import FOLDERS
from turnbuckle.lab.live.telemetry import BEGINNING, MAGIC, Record, Telemetry, rates
from turnbuckle.places import RUNTIME

WRITER = Path(__file__).with_name("telemetry_writer.c")
PORT = RUNTIME / "port" / "linux"
ENDLESS = 10**12
READINGS = 8_000


def compile_writer(folder: Path, port: Path) -> Path:
    """The writer, with the telemetry of a folder like runtime/port/linux."""
    names = ("telemetry.c", "telemetry_layout.c", "histogram.c", "say.c")
    sources = [port / name if (port / name).exists() else PORT / name for name in names]
    return compile_program([WRITER, *sources, folder / "tb_drives.c"], [folder, port, *FOLDERS])


@pytest.fixture(scope="module")
def writer(stock_folder: Path) -> Path:
    """A program that writes telemetry as fast as it can."""
    return compile_writer(stock_folder, PORT)


@pytest.fixture
def path() -> Iterator[Path]:
    """A place for a shared file, in memory as in operation."""
    path = Path(f"/dev/shm/turnbuckle-test-{os.getpid()}")
    path.unlink(missing_ok=True)  # of a test before, whose program has ended
    yield path
    path.unlink(missing_ok=True)


@pytest.fixture
def written(writer: Path, path: Path) -> Iterator[Telemetry]:
    """The file of a writer that has ended after 10 000 cycles."""
    subprocess.run([writer, path, "10000"], check=True)
    telemetry = Telemetry(path)
    yield telemetry
    telemetry.close()


def torn_readings(program: Path, path: Path) -> int:
    """How many of many readings of a file that is being written are a mixture of two."""
    with subprocess.Popen([program, path, str(ENDLESS)]) as process:
        try:
            while not path.exists():
                assert process.poll() is None
            telemetry = opened(path)
            torn = sum(
                is_torn(telemetry.status()) + is_torn(telemetry.latest()) for _ in range(READINGS)
            )
            assert not telemetry.ended
        finally:
            process.kill()
    telemetry.close()
    return torn


def opened(path: Path) -> Telemetry:
    """The file, as soon as it is ready."""
    while True:
        try:
            return Telemetry(path)
        except LiveError:
            continue


def is_torn(record: Record | None) -> bool:
    """Whether words behind the sequence come from different writings."""
    if record is None:
        return False
    words = np.frombuffer(record.tobytes(), np.uint64)[1:]
    return bool((words != words[0]).any())


def test_what_is_read_while_it_is_written_is_never_a_mixture(writer: Path, path: Path) -> None:
    assert torn_readings(writer, path) == 0


def test_a_writer_that_does_not_mark_its_writing_is_caught(
    stock_folder: Path, path: Path, tmp_path: Path
) -> None:
    source = (PORT / "telemetry.c").read_text()
    seeded = source.replace("even - 1u, memory_order_relaxed", "even, memory_order_relaxed")
    assert seeded != source
    (tmp_path / "telemetry.c").write_text(seeded)
    assert torn_readings(compile_writer(stock_folder, tmp_path), path) > 0


def test_the_ring_holds_the_last_cycles_and_no_others(written: Telemetry) -> None:
    slots = int(written.counts["slots"])
    kept = [number for number in range(10_000) if written.cycle(number) is not None]
    assert kept == list(range(10_000 - slots, 10_000))
    latest = written.latest()
    assert latest is not None and latest["number"] == 9_999


def test_a_reader_knows_that_the_program_has_ended(written: Telemetry) -> None:
    assert written.ended


def test_the_machine_and_its_names_are_in_the_file(written: Telemetry) -> None:
    assert written.machine == "yoon2023"
    assert len(written.hash) == 16
    assert written.drive_names == [f"{kind}_{i}" for kind in ("cable", "base") for i in range(1, 5)]
    assert written.bus_names == ["cable1", "cable2", "base"]


SWAPPED = {
    "names.c": (
        "char machine[TB_TELEMETRY_NAME];\n    char hash[TB_TELEMETRY_NAME];",
        "char hash[TB_TELEMETRY_NAME];\n    char machine[TB_TELEMETRY_NAME];",
    ),
    "rows.c": (
        "uint64_t published; /* cycles in the ring so far */\n    tb_loop_times times;",
        "tb_loop_times times;\n    uint64_t published;",
    ),
    "cycle.c": (
        "uint64_t number; /* of the cycle, skipped ones are not counted */\n",
        "double another[3];\n    uint64_t number;\n",
    ),
}


@pytest.mark.parametrize("name", SWAPPED)
def test_members_are_read_by_their_names_wherever_the_c_puts_them(
    name: str, stock_folder: Path, path: Path, tmp_path: Path
) -> None:
    port = port_with(tmp_path, "telemetry.h", *SWAPPED[name])
    subprocess.run([compile_writer(stock_folder, port), path, "5000"], check=True)
    telemetry = Telemetry(path)
    assert (telemetry.machine, len(telemetry.hash)) == ("yoon2023", 16)
    assert telemetry.status()["published"] == 5000
    latest = telemetry.latest()
    assert latest is not None and latest["number"] == 4999
    telemetry.ask("stop")
    assert (telemetry.asked("stop"), telemetry.asked("arm")) == (1, 0)
    telemetry.close()


def test_a_member_that_the_c_no_longer_has_is_named(
    stock_folder: Path, path: Path, tmp_path: Path
) -> None:
    gone = "TB_LAYOUT_NUMBERS(telemetry_cycle, tension)"
    port = port_with(tmp_path, "telemetry_layout.c", gone, " " * len(gone))
    subprocess.run([compile_writer(stock_folder, port), path, "5"], check=True)
    words = f"{path}: written by a program of version .*: tb_telemetry_cycle has no member tension"
    with pytest.raises(LiveError, match=words):
        Telemetry(path)


def port_with(folder: Path, name: str, right: str, wrong: str) -> Path:
    """A copy of what the writer takes of the port, with a change in one of its files."""
    for each in PORT.glob("telemetry*.[ch]"):
        text = each.read_text()
        if each.name == name:
            assert text.count(right) == 1
            text = text.replace(right, wrong)
        (folder / each.name).write_text(text)
    return folder


def test_two_programs_do_not_share_a_file(writer: Path, path: Path) -> None:
    with subprocess.Popen([writer, path, str(ENDLESS)]) as first:
        try:
            opened(path).close()
            second = subprocess.run([writer, path, "1"], capture_output=True, text=True)
            assert second.returncode == 2
            assert f"{path}: another program controls this machine" in second.stderr
            assert first.poll() is None
        finally:
            first.kill()


def test_a_file_of_another_version_is_refused(written: Telemetry, path: Path) -> None:
    content = bytearray(path.read_bytes())
    content[8] += 1
    path.write_bytes(content)
    with pytest.raises(LiveError, match=f"{path}: found telemetry of version 5; allowed: 4"):
        Telemetry(path)


@pytest.mark.parametrize("content", [b"TBTELEM\0", b"something else" * 100])
def test_a_file_that_is_no_telemetry_is_refused(path: Path, content: bytes) -> None:
    path.write_bytes(content)
    with pytest.raises(LiveError, match=f"{path}: found .*; allowed: telemetry of a turnbuckle"):
        Telemetry(path)


@pytest.mark.parametrize("field", ["bytes", "status_at", "slots", "inbox_at", "drives", "dof"])
def test_a_file_whose_header_contradicts_it_is_refused(
    written: Telemetry, path: Path, field: str
) -> None:
    fields = written.layouts.struct("telemetry_header").fields
    assert fields is not None
    content = bytearray(path.read_bytes())
    content[int(fields[field][1]) + 3 * field.endswith("_at")] ^= 8
    path.write_bytes(content)
    with pytest.raises(LiveError, match="allowed: telemetry of a turnbuckle"):
        Telemetry(path)


@pytest.mark.parametrize("changes", [{"at": 2**31}, {"size": 3}, {"kind": 0}, {"count": 2**31}])
def test_a_description_that_contradicts_itself_is_refused(
    written: Telemetry, path: Path, changes: dict[str, int]
) -> None:
    content = bytearray(path.read_bytes())
    begins = np.frombuffer(bytes(content), BEGINNING, 1)[0]
    at, count = int(begins["layout_at"]), int(begins["layout_rows"])
    rows = np.frombuffer(bytes(content), ROW, count, at).copy()
    place = int(np.flatnonzero((rows["name"] == b"telemetry_cycle") & (rows["kind"] == STRUCT))[0])
    for name, value in changes.items():
        rows[name][place + 1] = value
    content[at : at + rows.nbytes] = rows.tobytes()
    path.write_bytes(content)
    with pytest.raises(LiveError, match=f"{path}: written by .*described wrongly"):
        Telemetry(path)


def spoilt_at_random(content: bytes, random: np.random.Generator) -> bytes:
    """Telemetry with other bytes, most of them in its header and its status, cut off perhaps."""
    spoilt = bytearray(content)
    for _ in range(random.integers(1, 6)):
        most = int(random.choice([8, 1024, 24_000, len(spoilt)]))
        spoilt[random.integers(most)] = random.integers(256)
    cut = int(random.integers(len(spoilt))) if random.random() < 0.2 else len(spoilt)
    return bytes(spoilt[:cut])


def test_whatever_is_done_to_the_file_gives_a_picture_or_one_sentence(
    written: Telemetry, path: Path
) -> None:
    content, random = path.read_bytes(), np.random.default_rng(4)
    pictures = sentences = 0
    spoilt = [spoilt_at_random(content, random) for _ in range(40)]
    noise = [MAGIC + random.bytes(int(size)) for size in random.integers(0, 10_000, 8)]
    noise += [MAGIC + content[8:12] + random.bytes(len(content) - 12) for _ in range(8)]
    for each in (*spoilt, *noise):
        path.write_bytes(each)
        result = CliRunner().invoke(app, ["monitor", "yoon2023", "--once", f"--telemetry={path}"])
        assert result.exit_code in (0, 2), result.exception
        if result.exit_code:
            assert result.stderr.startswith(f"turnbuckle: {path}: "), result.stderr
            assert result.stderr.count("\n") == 1
            sentences += 1
        else:
            pictures += 1
    assert pictures > 5 and sentences > 20


def test_no_file_says_how_to_start_a_program(path: Path) -> None:
    with pytest.raises(NothingYetError, match=f"{path}: no program has written telemetry here"):
        Telemetry(path)


def test_a_file_of_which_only_the_beginning_is_made_is_still_to_come(
    written: Telemetry, path: Path
) -> None:
    content = path.read_bytes()
    for half in (b"", bytes(8), bytes(8) + content[8:]):
        path.write_bytes(half)
        with pytest.raises(NothingYetError):
            Telemetry(path)


def test_rates_on_a_bus_are_in_the_machine_s_own_time(written: Telemetry) -> None:
    before = written.status()
    after = before.copy()
    after["published"] += 90
    after["times"]["missed"] += 10  # time that passed as well
    after["buses"]["sent"] += 200
    after["buses"]["received"] += 300
    after["buses"]["bits"] += 50_000
    after["buses"]["bit_rate"] = before["buses"]["bit_rate"] = 1_000_000
    for rate in rates(before, after, 0.001):
        assert rate == pytest.approx((5000.0, 0.5))
    assert all(rate == (0.0, 0.0) for rate in rates(after, after, 0.001))
