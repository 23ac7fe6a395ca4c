"""The shared file of a program: layout, and what a reader sees while it is being written."""

import os
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from typer.testing import CliRunner

from turnbuckle.codegen.compile import compile_program
from turnbuckle.command_line import app
from turnbuckle.lab.live import LiveError, NothingYetError
from turnbuckle.lab.live.program import FOLDERS
from turnbuckle.lab.live.telemetry import (
    BUS,
    COUNTS,
    DRIVE,
    MAGIC,
    Record,
    Telemetry,
    layout_of,
    rates,
)
from turnbuckle.places import RUNTIME

WRITER = Path(__file__).with_name("telemetry_writer.c")
PORT = RUNTIME / "port" / "linux"
ENDLESS = 10**12
READINGS = 8_000


def compile_writer(folder: Path, port: Path) -> Path:
    """The writer, with the telemetry of a folder like runtime/port/linux."""
    sources = [WRITER, port / "telemetry.c", PORT / "histogram.c", PORT / "say.c"]
    return compile_program([*sources, folder / "tb_drives.c"], [folder, *FOLDERS])


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


def test_every_field_is_where_the_reader_takes_it_from(
    written: Telemetry, stock_folder: Path, tmp_path: Path
) -> None:
    layout = layout_of(written.counts)
    structs: dict[str, np.dtype[Any]] = {
        "tb_telemetry_header": COUNTS,
        "tb_telemetry_status": layout.status,
        "tb_telemetry_cycle": layout.cycle,
        "tb_telemetry_inbox": layout.inbox,
        "tb_telemetry_drive": DRIVE,
        "tb_telemetry_bus": BUS,
    }
    assert c_offsets(structs, stock_folder, tmp_path) == python_offsets(structs)


LOOP_TIMES = ("missed", "longest_gap", "lateness", "computing")
"""Fields that the C keeps in a struct of their own."""


def python_offsets(structs: dict[str, np.dtype[Any]]) -> dict[str, int]:
    """Offset of every field of the reader's records."""
    offsets = {}
    for struct, dtype in structs.items():
        assert dtype.fields is not None
        for name, (_, offset, *_title) in dtype.fields.items():
            offsets[f"{struct}.{name}"] = int(offset)
    return offsets


def c_offsets(structs: dict[str, np.dtype[Any]], folder: Path, scratch: Path) -> dict[str, int]:
    """The same, as the C compiler sees it."""
    lines = []
    for struct, dtype in structs.items():
        for name in dtype.names or ():
            nested = struct == "tb_telemetry_status" and name in LOOP_TIMES
            field = f"times.{name}" if nested else name
            lines.append(f'printf("{struct}.{name} %zu\\n", offsetof({struct}, {field}));')
    source = scratch / "offsets.c"
    source.write_text(
        '#include <stddef.h>\n#include <stdio.h>\n#include "telemetry.h"\n'
        "int main(void)\n{\n" + "\n".join(lines) + "\nreturn 0;\n}\n"
    )
    program = compile_program([source], [folder, *FOLDERS])
    printed = subprocess.run([program], check=True, capture_output=True, text=True).stdout
    return {name: int(offset) for name, offset in map(str.split, printed.splitlines())}


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
    with pytest.raises(LiveError, match=f"{path}: found telemetry of version 4; allowed: 3"):
        Telemetry(path)


@pytest.mark.parametrize("content", [b"TBTELEM\0", b"something else" * 100])
def test_a_file_that_is_no_telemetry_is_refused(path: Path, content: bytes) -> None:
    path.write_bytes(content)
    with pytest.raises(LiveError, match=f"{path}: found .*; allowed: telemetry of a turnbuckle"):
        Telemetry(path)


@pytest.mark.parametrize("field", ["bytes", "status_at", "cycle_bytes", "slots", "inbox_bytes"])
def test_a_file_whose_layout_is_another_is_refused(
    written: Telemetry, path: Path, field: str
) -> None:
    assert COUNTS.fields is not None
    content = bytearray(path.read_bytes())
    content[int(COUNTS.fields[field][1])] ^= 8
    path.write_bytes(content)
    with pytest.raises(LiveError, match="allowed: telemetry of a turnbuckle"):
        Telemetry(path)


def spoilt_at_random(content: bytes, random: np.random.Generator) -> bytes:
    """Telemetry with other bytes, most of them in its header and its status, cut off perhaps."""
    spoilt = bytearray(content)
    for _ in range(random.integers(1, 6)):
        most = int(random.choice([8, COUNTS.itemsize, 8192, len(spoilt)]))
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
    after["missed"] += 10  # time that passed as well
    after["buses"]["sent"] += 200
    after["buses"]["received"] += 300
    after["buses"]["bits"] += 50_000
    after["buses"]["bit_rate"] = before["buses"]["bit_rate"] = 1_000_000
    for rate in rates(before, after, 0.001):
        assert rate == pytest.approx((5000.0, 0.5))
    assert all(rate == (0.0, 0.0) for rate in rates(after, after, 0.001))
