"""What the commands print: complete, plain when nobody looks, the same from every folder."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from typer.testing import CliRunner

from turnbuckle.command_line import app
from turnbuckle.model.reading import load_machine

ROOT = Path(__file__).parents[2]
STOCK = ROOT / "machines" / "yoon2023.toml"
TURNBUCKLE = Path(sys.executable).with_name("turnbuckle")
COMMANDS = ["bus", "check", "analyze", "compare", "generate", "verify", "demo", "optimise", "study"]
AWKWARD = "my [bold]machine – Δx.toml"


def execute(
    *arguments: str | Path, folder: Path = ROOT, **environment: str
) -> subprocess.CompletedProcess[str]:
    """Run the installed command, its output piped."""
    return subprocess.run(
        [TURNBUCKLE, *arguments],
        cwd=folder,
        env=os.environ | environment,
        capture_output=True,
        text=True,
        check=False,
    )


def words(text: str) -> str:
    """Text with every run of white space as one blank."""
    return " ".join(text.split())


def test_check_prints_every_row_of_the_description() -> None:
    result = CliRunner().invoke(app, ["check", str(STOCK)], env={"COLUMNS": "200"})
    assert result.exit_code == 0
    for label, value in load_machine(STOCK).describe():
        assert f"{label} {value}" in words(result.stdout)


def test_check_loses_no_word_in_a_narrow_terminal() -> None:
    result = execute("check", STOCK, COLUMNS="40")
    shown = words(result.stdout)
    for _, value in load_machine(STOCK).describe():
        assert all(word in shown for word in value.split())
    assert max(map(len, result.stdout.splitlines())) <= 40


def test_brackets_of_the_user_are_no_markup(tmp_path: Path) -> None:
    path = tmp_path / "machine.toml"
    path.write_text(STOCK.read_text().replace('source = "Yoon', 'source = "[red]Yoon[/red]'))
    assert "[red]Yoon[/red]" in CliRunner().invoke(app, ["check", str(path)]).stdout


def test_the_version_is_printed() -> None:
    assert re.fullmatch(r"turnbuckle \d+\.\d+\.\d+\n", execute("--version").stdout)


@pytest.mark.parametrize("command", COMMANDS)
def test_the_help_of_every_command_has_an_example_and_fits_eighty_columns(command: str) -> None:
    result = execute(command, "--help", COLUMNS="80")
    assert result.returncode == 0
    assert f"\n    turnbuckle {command} " in result.stdout
    assert max(map(len, result.stdout.splitlines())) <= 80


def test_help_lists_every_command_in_whole_sentences() -> None:
    result = execute("--help", COLUMNS="80")
    for command in COMMANDS:
        assert re.search(rf"^  {command} .*\.$", result.stdout, re.MULTILINE)
    assert "..." not in result.stdout.partition("Commands:")[2]


#: What takes longer to load than all that quick commands need.
SLOW = {"casadi", "dask", "matplotlib", "numpy", "pint", "scipy", "sympy"}


@pytest.mark.parametrize("command", ["--help", "check"])
def test_quick_commands_load_nothing_slow(command: str) -> None:
    arguments = [command] if command == "--help" else [command, str(STOCK)]
    script = (
        "import sys, turnbuckle.command_line\n"
        f"sys.argv = ['turnbuckle', *{arguments!r}]\n"
        "try: turnbuckle.command_line.main()\n"
        "except SystemExit as end: assert not end.code\n"
        "print(*sys.modules)\n"
    )
    result = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    loaded = set(result.stdout.splitlines()[-1].split())
    assert "turnbuckle.model.terminal" in loaded
    assert not SLOW & loaded


def test_output_to_a_pipe_has_no_escape_and_no_progress() -> None:
    for term in ("xterm-256color", "dumb"):
        result = execute("check", STOCK, TERM=term)
        assert result.returncode == 0
        assert "\x1b" not in result.stdout
        assert result.stderr == ""


def test_an_encoding_without_greek_does_not_stop_a_command(tmp_path: Path) -> None:
    path = tmp_path / AWKWARD
    path.write_text(STOCK.read_text().replace('source = "Yoon', 'source = "Δx of Yoon'))
    result = execute("check", path, PYTHONIOENCODING="ascii")
    assert (result.returncode, result.stderr) == (0, "")
    assert "\\u0394x of Yoon" in result.stdout


def test_a_file_name_that_is_no_text_can_be_told(tmp_path: Path) -> None:
    result = execute("check", os.fsdecode(bytes(tmp_path) + b"/none \xff.toml"))
    assert result.returncode == 2
    assert "none \\udcff.toml: found no such file" in result.stderr


def test_a_reader_that_stops_reading_is_no_error() -> None:
    command = f"'{TURNBUCKLE}' check '{STOCK}' | true"
    result = subprocess.run(["bash", "-c", command], capture_output=True, text=True, check=False)
    assert "Traceback" not in result.stderr
