"""One version: package, command, changelog, runtime and generated C; others do not go together."""

import json
import re
import shutil
import subprocess
import tomllib
from pathlib import Path

import pytest

from turnbuckle.version import VERSION, version_number

ROOT = Path(__file__).parents[2]
CORE = ROOT / "runtime" / "core"
HOME = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["version"]
HEADING = re.compile(r"^## \[(.+)\] - (?:Unreleased|\d{4}-\d\d-\d\d)$", re.MULTILINE)
#: What every program that uses the runtime includes: the step alone, or drives too.
ENTRIES = ("controller.h", "supervisor.h")


def compiled(folder: Path, header: str, compiler: str) -> str:
    """What a compiler says of C of a folder with the runtime; empty when it is fine."""
    command = [compiler, "-std=c11", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-x", "c"]
    done = subprocess.run(
        [*command, f"-I{folder}", f"-I{CORE}", "-"],
        input=f'#include "{header}"\n',
        capture_output=True,
        text=True,
        check=False,
    )
    return done.stderr if done.returncode else ""


def of_version(stock_folder: Path, line: str, folder: Path) -> Path:
    """The stock machine's C with another line in place of its version."""
    copy = Path(shutil.copytree(stock_folder, folder / "generated"))
    types = copy / "tb_types.h"
    text, count = re.subn(r"^#define TB_VERSION .*$", line, types.read_text(), flags=re.MULTILINE)
    assert count == 1
    types.write_text(text)
    return copy


def test_the_installed_version_is_that_of_pyproject() -> None:
    assert VERSION == HOME


def test_the_changelog_begins_with_the_current_version() -> None:
    versions = HEADING.findall((ROOT / "CHANGELOG.md").read_text())
    assert versions[0] == HOME
    numbers = [version_number(version) for version in versions]
    assert numbers == sorted(set(numbers), reverse=True)


def test_the_runtime_names_the_current_version() -> None:
    header = (CORE / "runtime_version.h").read_text()
    assert f"#define TB_RUNTIME_VERSION {version_number(HOME)} " in header
    assert set(re.findall(r"\d+\.\d+\.\d+", header)) == {HOME}


@pytest.mark.parametrize("folder", sorted((ROOT / "generated").iterdir()), ids=lambda f: f.name)
def test_all_committed_c_is_of_the_current_version(folder: Path) -> None:
    assert json.loads((folder / "manifest.json").read_text())["turnbuckle"] == HOME
    types = (folder / "tb_types.h").read_text()
    assert f"#define TB_VERSION {version_number(HOME)} /* Turnbuckle {HOME};" in types


@pytest.mark.parametrize("compiler", ["gcc", "clang", "arm-none-eabi-gcc"])
@pytest.mark.parametrize("header", ENTRIES)
def test_c_of_the_same_version_compiles(header: str, compiler: str, stock_folder: Path) -> None:
    assert compiled(stock_folder, header, compiler) == ""


@pytest.mark.parametrize("compiler", ["gcc", "clang", "arm-none-eabi-gcc"])
@pytest.mark.parametrize("header", ENTRIES)
@pytest.mark.parametrize("line", ["#define TB_VERSION 199", "#define TB_VERSION 10000", ""])
def test_c_of_another_version_or_of_none_does_not_compile_and_says_what_to_do(
    line: str, header: str, compiler: str, stock_folder: Path, tmp_path: Path
) -> None:
    said = compiled(of_version(stock_folder, line, tmp_path), header, compiler)
    assert f"Generated C is not of Turnbuckle {HOME}" in said
    assert "run turnbuckle generate again" in said


def test_versions_compare_as_numbers() -> None:
    order = ["0.0.1", "0.1.99", "0.2.0", "0.10.0", "1.0.0", "1.0.10"]
    numbers = [version_number(text) for text in order]
    assert numbers == sorted(set(numbers))


@pytest.mark.parametrize("text", ["0.2", "0.2.0.dev1", "0.2.x", "0.2.0-rc1", "0.1.100"])
def test_a_version_that_c_could_not_compare_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match=re.escape(text)):
        version_number(text)
