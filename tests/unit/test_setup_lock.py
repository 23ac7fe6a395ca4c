"""The locks pin every Python package by version and hash, and name no place to get it from."""

import ast
import re
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path

import pytest
from wheels import OF_THE_REPOSITORY

from turnbuckle.extras import DISTRIBUTIONS, extra_of
from turnbuckle.places import PACKAGE

ROOT = Path(__file__).parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
LOCK, DEV_LOCK = ((ROOT / f"requirements{which}.lock").read_text() for which in ("", "-dev"))
PIN = re.compile(r"(?P<name>[a-z0-9-]+)==(?P<version>[0-9][0-9a-z.]*)( ; [^\\]+)? \\")
HASH = re.compile(r"    --hash=sha256:[0-9a-f]{64}( \\)?")


def pins(lock: str) -> dict[str, str]:
    """Versions of what `lock` pins with at least one hash; ValueError at a line of another kind."""
    versions: dict[str, str] = {}
    pin = None
    for line in lock.splitlines():
        if match := PIN.fullmatch(line):
            pin = match
        elif pin and HASH.fullmatch(line):
            versions[pin["name"]] = pin["version"]
        elif line and not line.startswith("# The following packages are considered to be unsafe"):
            raise ValueError(line)
    return versions


def names(requirements: list[str]) -> set[str]:
    return {re.split("[=<>~ ]", requirement)[0] for requirement in requirements}


def wanted(*extras: str) -> set[str]:
    """What the package requires with some extras."""
    optional = PROJECT["optional-dependencies"]
    return names(PROJECT["dependencies"]).union(*(names(optional[extra]) for extra in extras))


def imported(folder: Path) -> Iterator[tuple[str, str]]:
    """Modules that the package's files import, each with the file; not those of Python or ours."""
    for path in [*folder.glob("*.py"), *folder.glob("*/**/*.py")]:
        inside = path.relative_to(folder.parent).parents
        if not {str(parent) for parent in inside} & OF_THE_REPOSITORY:
            for node in ast.walk(ast.parse(path.read_text())):
                modules = (
                    [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
                )
                if isinstance(node, ast.ImportFrom):
                    modules = [node.module or ""]
                for module in {module.partition(".")[0] for module in modules}:
                    if module not in {*sys.stdlib_module_names, "turnbuckle"}:
                        yield module, path.name


def test_the_locks_hold_only_pins_with_hashes() -> None:
    assert len(pins(LOCK)) >= len(wanted("sim", "bus", "design"))
    assert len(pins(DEV_LOCK)) >= len(wanted("dev"))


def test_all_that_is_asked_for_is_pinned() -> None:
    assert wanted("sim", "bus", "design") <= pins(LOCK).keys()
    assert wanted("dev") <= pins(DEV_LOCK).keys()


def test_what_only_tests_need_is_not_installed_by_make() -> None:
    only = wanted("dev") - wanted()
    assert {"pytest", "mypy", "mujoco"} <= only
    assert not only & pins(LOCK).keys()


def test_both_locks_pin_the_same_versions() -> None:
    both = pins(LOCK).keys() & pins(DEV_LOCK).keys()
    assert both
    assert {name: pins(LOCK)[name] for name in both} == {
        name: pins(DEV_LOCK)[name] for name in both
    }


def test_every_package_is_asked_for_once() -> None:
    lists = [PROJECT["dependencies"], *PROJECT["optional-dependencies"].values()]
    said = [name for requirements in lists for name in names(requirements)]
    assert len(said) == len(set(said))


def test_the_package_imports_only_what_it_requires() -> None:
    seen = list(imported(PACKAGE))
    assert {module for module, _ in seen} >= {"numpy", "can", "matplotlib"}
    base = wanted() | {"pydantic_core"}
    strangers = [
        (module, file)
        for module, file in seen
        if DISTRIBUTIONS.get(module, module) not in base
        and extra_of(module) not in {"sim", "bus", "design"}
    ]
    assert not strangers


def test_an_import_of_what_only_tests_have_is_caught(tmp_path: Path) -> None:
    (tmp_path / "module.py").write_text("import os\nfrom pytest import fixture\nimport sympy\n")
    found = {module for module, _ in imported(tmp_path)}
    assert found == {"pytest", "sympy"}
    assert {extra_of(module) for module in found} == {"dev"}


@pytest.mark.parametrize(
    "line",
    [
        "--index-url somewhere",
        "--find-links somewhere",
        "numpy>=2 \\",
        "numpy @ https://example.org/numpy.whl \\",
        "    --hash=md5:00 \\",
        "numpy==2.0",
    ],
)
def test_a_line_that_is_no_pin_is_caught(line: str) -> None:
    with pytest.raises(ValueError, match=re.escape(line)):
        pins(line)


def test_a_pin_without_a_hash_is_caught() -> None:
    assert pins("numpy==2.0 \\\n") == {}
