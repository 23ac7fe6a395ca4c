"""The README is true: its tour runs and prints what it says, its tables are complete."""

import doctest
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

from turnbuckle.command_line import app
from turnbuckle.model.machine import json_schema
from turnbuckle.model.symbolic.function import Status

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text()
# Where the keys of a machine file are explained.
KEYS = README + (ROOT / "docs" / "buses.md").read_text()
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
FILE_NAME = re.compile(r"(?:#|/\*) (\w+\.\w+)")
LARGEST_PICTURE = 300_000


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """What the tour needs of the repository, free to be written to."""
    shutil.copytree(ROOT / "machines", tmp_path / "machines")
    shutil.copytree(ROOT / "runtime", tmp_path / "runtime")
    (tmp_path / ".venv").symlink_to(ROOT / ".venv")
    return tmp_path


def run(command: str, folder: Path) -> str:
    """What a user sees of a command."""
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    done = subprocess.run(
        ["bash", "-c", command],
        cwd=folder,
        env=os.environ | {"PATH": path},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )
    return done.stdout


def sessions(block: str) -> Iterator[tuple[str, str]]:
    """Commands of a console block, and what the README says they print."""
    for part in re.split(r"^\$ ", block, flags=re.MULTILINE)[1:]:
        command, _, expected = part.partition("\n")
        yield command, expected


def mistakes(text: str, folder: Path) -> list[str]:
    """Save every file a text shows, run every command, compare what is printed."""
    wrong = []
    flags = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
    for language, block in BLOCK.findall(text):
        if named := FILE_NAME.match(block):
            (folder / named[1]).write_text(block)
        if language == "console":
            for command, expected in sessions(block):
                got = run(command, folder)
                if not doctest.OutputChecker().check_output(expected, got, flags):
                    wrong.append(f"$ {command}\nexpected:\n{expected}\ngot:\n{got}")
    return wrong


def keys(schema: dict[str, Any]) -> Iterator[str]:
    """Every key of a machine file, as `table.key`."""
    for table, entry in schema["properties"].items():
        found = re.search(r"#/\$defs/(\w+)", str(entry))
        assert found, table
        yield from (f"{table}.{key}" for key in schema["$defs"][found[1]]["properties"])


def test_every_command_of_the_readme_prints_what_it_says(folder: Path) -> None:
    assert len([block for block in BLOCK.findall(README) if block[0] == "console"]) > 5
    assert not mistakes(README, folder)


def test_a_command_that_prints_something_else_is_noticed(folder: Path) -> None:
    text = "```console\n$ echo one\none\n$ echo two\nthree\n```\n"
    (mistake,) = mistakes(text, folder)
    assert mistake.startswith("$ echo two")


def test_the_tables_name_every_key_of_a_machine_file() -> None:
    missing = [key for key in keys(json_schema()) if f"`{key}`" not in KEYS]
    assert not missing


def test_the_tables_name_no_key_that_there_is_not() -> None:
    tables = json_schema()["properties"]
    rows = re.findall(r"^\| (`.*?`) \|", KEYS, re.MULTILINE)
    named = {key for row in rows for key in re.findall(r"`([a-z_]+\.\w+)`", row)}
    assert named
    assert {key for key in named if key.split(".")[0] in tables} <= set(keys(json_schema()))


def test_every_status_is_explained_with_its_number() -> None:
    for status in Status:
        assert f"| `TB_{status.name}` {int(status)} |" in README


def test_every_command_is_shown() -> None:
    commands = re.findall(r"^  (\w+)  ", CliRunner().invoke(app, ["--help"]).stdout, re.MULTILINE)
    assert len(commands) >= 4
    for command in commands:
        assert f"turnbuckle {command} " in README


def test_every_file_and_folder_the_documents_name_is_there() -> None:
    texts = [README, *(path.read_text() for path in (ROOT / "docs").glob("*.md"))]
    named = set(re.findall(r"`((?:[\w.-]+/)+[\w.-]*\w)`", "\n".join(texts)))
    named |= set(re.findall(r"\]\((?!http)([^)#]+)\)", README))
    assert named
    missing = {name for name in named if not (ROOT / name).exists()}
    assert not {name for name in missing if not name.startswith(("generated/", "build/"))}


@pytest.mark.parametrize("name", ["demo.png", "analysis.png"])
def test_the_pictures_are_small_enough_for_a_page(name: str) -> None:
    picture = ROOT / "docs" / name
    assert picture.read_bytes().startswith(b"\x89PNG")
    assert picture.stat().st_size < LARGEST_PICTURE
