"""Files that commands write: whole or not at all, named, and never over what is a user's own."""

import resource
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from flown import Flight
from matplotlib.figure import Figure
from typer.testing import CliRunner

from turnbuckle.codegen.folder import FolderError, write_folder
from turnbuckle.command_line import app
from turnbuckle.lab.pictures import write_picture
from turnbuckle.model.files import FileError, refuse_foreign_file, write_whole

ROOT = Path(__file__).parents[2]
MACHINE = ROOT / "machines" / "yoon2023.toml"
MARK = b"made by us"


@contextmanager
def files_no_longer_than(size: int) -> Iterator[None]:
    """As on a disk on which a file has room for so many bytes."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


@pytest.fixture(scope="module")
def dump(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A short flight recording."""
    flight = Flight()
    flight.machine.run(300)
    path = tmp_path_factory.mktemp("flight") / "flight.dump"
    path.write_bytes(flight.read_out())
    return path


def test_a_file_is_written_whole_or_not_at_all(tmp_path: Path) -> None:
    path = tmp_path / "new" / "machine.toml"
    write_whole(path, "old\n")
    with (
        files_no_longer_than(100),
        pytest.raises(FileError, match=f"{path}: cannot be written: File too large"),
    ):
        write_whole(path, "new\n" * 100)
    assert path.read_text() == "old\n"
    assert list(path.parent.iterdir()) == [path]


@pytest.mark.parametrize("begin", [b"", bytes(1 << 20)])
@pytest.mark.parametrize("end", [b"", bytes(1 << 20)])
def test_our_mark_is_found_at_either_end(tmp_path: Path, begin: bytes, end: bytes) -> None:
    path = tmp_path / "file"
    for content in (b"", MARK + end, begin + MARK):
        path.write_bytes(content)
        refuse_foreign_file(path, MARK)
    path.write_bytes(b"precious" + end)
    with pytest.raises(FileError, match=f"{path}: was not written by this command"):
        refuse_foreign_file(path, MARK)
    with pytest.raises(FileError, match="would be lost"):
        refuse_foreign_file(tmp_path, MARK)


def log(dump: Path, table: Path, picture: Path) -> tuple[int, str]:
    """Exit status and complaints of `log`."""
    words = ["log", str(dump), str(MACHINE), "--out", str(table), "--plot", str(picture)]
    result = CliRunner().invoke(app, words)
    return result.exit_code, result.stderr


@pytest.mark.parametrize("kind", ["csv", "parquet"])
def test_log_replaces_its_own_files_and_no_others(dump: Path, tmp_path: Path, kind: str) -> None:
    table, picture = tmp_path / f"log.{kind}", tmp_path / "log.png"
    for _ in range(2):
        assert log(dump, table, picture) == (0, "")
    made = table.read_bytes(), picture.read_bytes()
    for path in (table, picture):
        path.write_bytes(b"precious")
        status, said = log(dump, table, picture)
        assert status == 2
        assert said == (
            f"turnbuckle: {path}: was not written by this command, and would be lost; move it"
            " away, or name another file\n"
        )
        assert path.read_bytes() == b"precious"
        table.write_bytes(made[0])
        picture.write_bytes(made[1])


@pytest.mark.parametrize("kind", ["csv", "parquet"])
def test_on_a_full_disk_log_leaves_nothing_and_names_the_file(
    dump: Path, tmp_path: Path, kind: str
) -> None:
    table = tmp_path / f"log.{kind}"
    with files_no_longer_than(20_000):
        status, said = log(dump, table, tmp_path / "log.png")
    assert (status, said) == (2, f"turnbuckle: {table}: cannot be written: File too large\n")
    assert list(tmp_path.iterdir()) == []


def small_files() -> None:
    """For a process that may write no file beyond 30 kB."""
    resource.setrlimit(resource.RLIMIT_FSIZE, (30_000, 30_000))
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)


def test_on_a_full_disk_generate_leaves_nothing_and_names_its_folder(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "turnbuckle", "generate", str(MACHINE), "--out", "out"],
        cwd=tmp_path,
        preexec_fn=small_files,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 2, done
    assert "turnbuckle: out: cannot be written: File too large" in done.stderr
    assert "Traceback" not in done.stderr
    assert list(tmp_path.iterdir()) == []


def test_on_a_full_disk_a_picture_leaves_nothing(tmp_path: Path) -> None:
    path = tmp_path / "picture.png"
    with files_no_longer_than(100), pytest.raises(FileError, match=f"{path}: cannot be written"):
        write_picture(Figure(), path)
    assert list(tmp_path.iterdir()) == []


def test_demo_does_not_replace_a_picture_that_is_not_its_own(tmp_path: Path) -> None:
    picture = tmp_path / "yoon2023.png"
    picture.write_bytes(b"precious")
    result = CliRunner().invoke(app, ["demo", str(MACHINE), "--out", str(tmp_path)])
    assert result.exit_code == 2
    assert f"{picture}: was not written by this command" in result.stderr
    assert picture.read_bytes() == b"precious"


@pytest.mark.parametrize("before", ['"machine": "other"', '"machines": ["other", "third"]'])
def test_the_files_of_another_machine_are_replaced_by_force_alone(
    tmp_path: Path, before: str
) -> None:
    folder, manifest = tmp_path / "out", "manifest.json"
    theirs = f'{{{before}, "files": ["a"]}}'
    write_folder({"a": "theirs", manifest: theirs}, folder, manifest)
    mine = {"a": "mine", manifest: '{"machine": "mine", "files": ["a"]}'}
    with pytest.raises(FolderError, match=r"holds the files of other.*, not of mine; .* --force"):
        write_folder(mine, folder, manifest)
    assert (folder / "a").read_text() == "theirs"
    write_folder(mine, folder, manifest, force=True)
    write_folder(mine | {"a": "again"}, folder, manifest)
    assert (folder / "a").read_text() == "again"


@pytest.mark.parametrize("command", ["generate", "analyze", "compare"])
def test_a_command_refuses_the_folder_of_another_machine_before_its_work(
    tmp_path: Path, command: str
) -> None:
    manifests = {"generate": "manifest", "analyze": "analysis", "compare": "comparison"}
    manifest = f"{manifests[command]}.json"
    write_folder({manifest: '{"machine": "tripod", "files": []}'}, tmp_path / "mine", manifest)
    others = [str(ROOT / "machines" / "brau_five.toml")] if command == "compare" else []
    words = [command, str(MACHINE), *others, "--out", str(tmp_path / "mine")]
    result = CliRunner().invoke(app, words)
    assert result.exit_code == 2
    assert f"{tmp_path / 'mine'}: holds the files of tripod, not of yoon2023" in result.stderr
    assert result.stderr.count("\n") == 1


@pytest.mark.parametrize("words", [["check", str(MACHINE)], ["--version"], ["log", "--help"]])
def test_a_standard_output_without_room_is_named(words: list[str]) -> None:
    with Path("/dev/full").open("w") as full:
        command = [sys.executable, "-m", "turnbuckle", *words]
        done = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, text=True)
    assert done.returncode == 2
    assert done.stderr == "turnbuckle: standard output: No space left on device\n"
