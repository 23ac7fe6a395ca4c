"""Everything that can go wrong on the command line is one message on stderr, never a traceback."""

import errno
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

import turnbuckle.codegen.generate
from turnbuckle.codegen.compile import CompileError
from turnbuckle.command_line import app

ROOT = Path(__file__).parents[2]
STOCK = ROOT / "machines" / "yoon2023.toml"
TURNBUCKLE = Path(sys.executable).with_name("turnbuckle")
INTERRUPTED = 130


def run(*arguments: str | Path) -> Result:
    """Run a command in this process."""
    return CliRunner().invoke(app, [str(argument) for argument in arguments])


def assert_refused(result: Result, *words: str) -> None:
    """Exit status 2, nothing on stdout, one message on stderr that holds the words."""
    assert result.exit_code == 2
    assert result.stdout == ""
    assert result.stderr.count("\n") == 1
    assert result.stderr.startswith("turnbuckle: ")
    assert "Traceback" not in result.stderr
    for word in words:
        assert word in result.stderr


@pytest.fixture
def bad(tmp_path: Path) -> Path:
    """A machine file with a mistake in it."""
    path = tmp_path / "bad.toml"
    path.write_text(STOCK.read_text().replace('radius = "5 mm"', 'radius = "-5 mm"'))
    return path


@pytest.mark.parametrize("command", ["check", "analyze", "generate", "verify", "demo"])
def test_every_command_refuses_a_bad_machine_file_with_its_key(command: str, bad: Path) -> None:
    assert_refused(run(command, bad), str(bad), "drum.radius", '"-5 mm"')


@pytest.mark.parametrize("command", ["check", "analyze", "generate", "verify", "demo"])
def test_every_command_refuses_a_file_that_is_not_there(command: str, tmp_path: Path) -> None:
    assert_refused(run(command, tmp_path / "none.toml"), "none.toml", "no such file")


def test_brackets_in_a_file_name_are_shown_as_they_are(tmp_path: Path) -> None:
    assert_refused(run("check", tmp_path / "[red]none[/].toml"), "[red]none[/].toml")


def test_a_folder_with_other_content_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "thesis.tex").write_text("mine")
    assert_refused(run("generate", STOCK, "--out", tmp_path), "thesis.tex", "--out")
    assert [path.name for path in tmp_path.iterdir()] == ["thesis.tex"]


def test_a_file_in_place_of_the_folder_is_refused(tmp_path: Path) -> None:
    (tmp_path / "out").write_text("mine")
    assert_refused(run("generate", STOCK, "--out", tmp_path / "out"), "is not a folder")
    assert (tmp_path / "out").read_text() == "mine"


def test_a_full_disk_is_told_in_words(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(tmp_path / "out"))

    monkeypatch.setattr(turnbuckle.codegen.generate, "write", full)
    result = run("generate", STOCK, "--out", tmp_path / "out")
    assert_refused(result, f"{tmp_path / 'out'}: No space left on device")


def test_a_missing_compiler_is_named(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("CC", "no-such-compiler")
    assert_refused(run("demo", STOCK, "--out", tmp_path), "'no-such-compiler' is not installed")


def test_what_the_compiler_says_reaches_the_user(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    def refuse(*_: object) -> None:
        raise CompileError("gcc failed: tb_types.h:1: error [-Werror]")

    monkeypatch.setattr("turnbuckle.lab.demo.run_demo", refuse)
    assert_refused(run("demo", STOCK, "--out", tmp_path), "gcc failed", "[-Werror]")


def test_an_interrupt_ends_with_the_status_of_an_interrupt(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def interrupt(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(turnbuckle.codegen.generate, "generate", interrupt)
    result = run("generate", STOCK)
    assert result.exit_code == INTERRUPTED
    assert result.stderr == "turnbuckle: interrupted\n"


def test_a_signal_ends_the_real_command_without_a_traceback(tmp_path: Path) -> None:
    fifo = tmp_path / "machine.toml"
    os.mkfifo(fifo)
    command: list[str | Path] = [TURNBUCKLE, "check", fifo]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    with process, fifo.open("w"):  # opens once the command reads, and keeps it waiting
        process.send_signal(signal.SIGINT)
        output, errors = process.communicate(timeout=60)
    assert process.returncode == INTERRUPTED
    assert (output, errors) == ("", "turnbuckle: interrupted\n")


def test_a_mistake_of_ours_is_not_hidden(monkeypatch: pytest.MonkeyPatch) -> None:
    def stumble(*_: object) -> None:
        raise ZeroDivisionError

    monkeypatch.setattr(turnbuckle.codegen.generate, "generate", stumble)
    assert isinstance(run("generate", STOCK).exception, ZeroDivisionError)


@pytest.mark.parametrize(
    "arguments", [["frobnicate"], ["check"], ["check", "a", "b"], ["verify", "a", "--points", "0"]]
)
def test_a_wrong_command_line_is_told_with_its_usage(arguments: list[str]) -> None:
    result = run(*arguments)
    assert result.exit_code == 2
    assert result.stdout == ""
    assert "Usage: turnbuckle" in result.stderr or "Usage: root" in result.stderr
    assert "Error: " in result.stderr
