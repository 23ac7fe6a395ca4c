"""What `make` and `.ci/lint_c` promise: a second set-up does nothing; a C warning is an error."""

import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
SET_UP_BY = (
    "pyproject.toml",
    "requirements.lock",
    "requirements-dev.lock",
    ".ci/packages",
    ".ci/packages_of_tests",
)
CLEAN = '#include "tb_types.h"\nreal_t f(real_t x);\nreal_t f(real_t x) { return x * TB_C(0.1); }\n'
TYPES = """
#ifdef TB_REAL_FLOAT
typedef float real_t;
#define TB_C(x) x##f
#else
typedef double real_t;
#define TB_C(x) x
#endif
"""


def run(*command: str, folder: Path = ROOT) -> subprocess.CompletedProcess[str]:
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)


def lint_c(folder: Path, source: str) -> subprocess.CompletedProcess[str]:
    """Lint a project whose only machine has one C file, beside the controller step's two."""
    machine, core = folder / "generated" / "machine", folder / "runtime" / "core"
    machine.mkdir(parents=True)
    core.mkdir(parents=True)
    for name in ("controller", "torque_gate"):
        (core / f"{name}.c").write_text(CLEAN)
    (machine / "tb_types.h").write_text(TYPES)
    (machine / "tb_f.c").write_text(source)
    return run(str(ROOT / ".ci" / "lint_c"), folder=folder)


def test_help_lists_every_target() -> None:
    makefile = (ROOT / "Makefile").read_text()
    match = re.search(r"^\.PHONY: (.*)$", makefile, re.MULTILINE)
    assert match
    listed = re.findall(r"^  make (\w+)", run("make", "help").stdout, re.MULTILINE)
    assert sorted(listed) == sorted(match[1].split())


def test_a_second_set_up_has_nothing_to_do() -> None:
    assert run("make", "--question", "setup").returncode == 0


@pytest.mark.parametrize("changed", SET_UP_BY)
def test_a_changed_list_asks_for_a_new_set_up(changed: str, tmp_path: Path) -> None:
    for name in ("Makefile", *SET_UP_BY):
        target = tmp_path / name
        target.parent.mkdir(exist_ok=True)
        target.write_bytes((ROOT / name).read_bytes())
    (tmp_path / ".venv").symlink_to(ROOT / ".venv")
    assert run("make", "--question", "setup", folder=tmp_path).returncode == 0
    with (tmp_path / changed).open("a") as lock:
        lock.write("\n")
    assert run("make", "--question", "setup", folder=tmp_path).returncode == 1


def test_only_the_tests_ask_for_the_packages_that_tests_need(tmp_path: Path) -> None:
    for name in ("Makefile", *SET_UP_BY):
        target = tmp_path / name
        target.parent.mkdir(exist_ok=True)
        target.write_bytes((ROOT / name).read_bytes())
    (tmp_path / ".venv").symlink_to(ROOT / ".venv")
    with (tmp_path / ".ci/packages_of_tests").open("a") as packages:
        packages.write("another\n")
    install = ".ci/install_packages .ci/packages_of_tests"
    assert install in run("make", "--dry-run", "test", folder=tmp_path).stdout
    others = run("make", "--dry-run", "generate", "verify", "demo", folder=tmp_path)
    assert (others.returncode, install in others.stdout) == (0, False)


def test_clean_c_is_compiled_by_both_compilers_in_both_precisions_and_for_arm(
    tmp_path: Path,
) -> None:
    result = lint_c(tmp_path, CLEAN)
    assert (result.returncode, result.stdout) == (0, "C: 15 compilations without a warning\n")


def test_a_machine_with_a_prefix_is_compiled_without_the_runtime_beside_it(tmp_path: Path) -> None:
    left = tmp_path / "generated" / "left_machine"
    left.mkdir(parents=True)
    (left / "left_f.c").write_text("int left_f(void);\nint left_f(void) { return 0; }\n")
    result = lint_c(tmp_path, CLEAN)
    assert (result.returncode, result.stdout) == (0, "C: 20 compilations without a warning\n")


@pytest.mark.parametrize(
    ("defect", "warning"),
    [
        ("int f(double x); int f(double x) { return x; }", "conversion"),
        ("int f(int x); int f(int x) { return 0; }", "unused-parameter"),
        ("double f(float x); double f(float x) { return x * 0.1; }", "double-promotion"),
        ("int f(void); int f(void) { int x; return x; }", "uninitialized"),
        ("int f(char x); int f(char x) { return x >= 0; }", "type-limits"),
    ],
)
def test_a_defect_in_c_is_caught(tmp_path: Path, defect: str, warning: str) -> None:
    result = lint_c(tmp_path, defect + "\n")
    assert result.returncode != 0
    assert warning in result.stderr
