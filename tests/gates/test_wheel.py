"""The installed wheel is whole: every command works in an empty folder, and writes nowhere else."""

import os
import shutil
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

import wheels

from turnbuckle import command_line

ALL_BUT_WRITING = 0o555
UNWRITABLE = "/dev/null"
"""As a home nobody can write to it, the superuser neither."""
COMMANDS: Sequence[tuple[int, str]] = (
    (0, "check yoon2023"),
    (0, "bus yoon2023"),
    (0, "new arm --from spidar_g"),
    (0, "runtime --out runtime"),
    (0, "generate brau_triangle"),
    (0, "verify brau_triangle --points 5"),
    (0, "analyze yoon2023"),
    (0, "compare yoon_fixed_orthogonal yoon_fixed_diagonal"),
    (0, "demo yoon_fixed_diagonal"),
    (0, "run yoon_fixed_diagonal --sim --arm --seconds 0.5 --record flight.dump --telemetry t"),
    (0, "monitor yoon_fixed_diagonal --once --telemetry t"),
    (0, "log flight.dump --out flight.parquet --plot flight.png"),
    (0, "replay flight.dump"),
    (2, "deploy yoon2023 ssh://nobody@127.0.0.1:1"),  # nobody is there
    (2, "rollback yoon2023 ssh://nobody@127.0.0.1:1"),
    (2, "image yoon2023 --program no_such_file.elf"),
    (2, "flash yoon2023 --image no_such_file.elf"),
    (2, "info flight.dump"),
    (3, "optimise brau_triangle --search local --vary tension.max=9N..10N"),
    (0, "study brau_triangle --vary tension.max=9N..10N:2 --out study"),
)
"""Each with its exit status: 2 refuses, 3 says that nothing better was found."""


@contextmanager
def read_only(folder: Path) -> Iterator[None]:
    """Nobody may write into a folder, and nobody has, who may write anywhere."""
    inside = [folder, *(path for path in folder.rglob("*") if path.is_dir())]
    before = [(path, path.stat().st_mtime_ns) for path in inside]
    for path in inside:
        path.chmod(ALL_BUT_WRITING)
    try:
        yield
        assert before == [(path, path.stat().st_mtime_ns) for path in inside]
    finally:
        for path in inside:
            path.chmod(0o755)


def mistakes(turnbuckle: Path, folder: Path, **environment: str) -> list[str]:
    """Commands that end in another way than they should."""
    wrong = []
    for status, words in COMMANDS:
        done = wheels.run(turnbuckle, *words.split(), folder=folder, **environment)
        if done.returncode != status or "Traceback" in done.stderr:
            wrong.append(f"$ {words}\nstatus {done.returncode}\n{done.stderr}")
    return wrong


def test_every_command_of_the_installed_wheel_works_in_an_empty_folder(tmp_path: Path) -> None:
    wheel = wheels.built(wheels.source_tree(tmp_path / "source"))
    turnbuckle = wheels.installed(wheel, tmp_path / "environment")
    shutil.rmtree(tmp_path / "source")
    (tmp_path / "empty").mkdir()
    (packages,) = tmp_path.glob("environment/lib/python*/site-packages")
    caches = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")
    with read_only(packages):
        wrong = mistakes(turnbuckle, tmp_path / "empty", XDG_CACHE_HOME=str(caches))
        assert not wrong, "\n".join(wrong)
        homeless = {"HOME": UNWRITABLE, "XDG_CACHE_HOME": ""}
        command = (turnbuckle, "verify", "brau_triangle", "--points", "1")
        done = wheels.run(*command, folder=tmp_path / "empty", **homeless)
        assert (done.returncode, done.stderr) == (0, "")


def test_every_command_is_tried() -> None:
    tried = {words.split()[0] for _, words in COMMANDS}
    assert tried == {command.__name__ for command in command_line.COMMANDS}


def test_source_package_and_clone_make_the_same_wheel_with_every_file(tmp_path: Path) -> None:
    source = wheels.source_tree(tmp_path / "source")
    wanted = set(wheels.files_of(source))
    assert len([name for name in wanted if name.endswith((".c", ".h"))]) > 100
    assert wheels.files_in(wheels.built(source)) == wanted
    shutil.rmtree(source / "out")
    assert wheels.files_in(wheels.built(source, "--wheel")) == wanted


def test_a_wheel_without_the_runtime_is_caught(tmp_path: Path) -> None:
    source = wheels.source_tree(tmp_path / "source")
    project = source / "pyproject.toml"
    text = project.read_text()
    assert '  "runtime/**/*.[ch]",\n' in text
    project.write_text(text.replace('  "runtime/**/*.[ch]",\n', ""))
    wheel = wheels.built(source, "--wheel")
    missing = set(wheels.files_of(source)) - wheels.files_in(wheel)
    assert missing and all(name.startswith("turnbuckle/runtime/") for name in missing)
    turnbuckle = wheels.installed(wheel, tmp_path / "environment")
    refused = wheels.run(turnbuckle, "demo", "yoon_fixed_diagonal", folder=tmp_path)
    assert refused.returncode != 0
