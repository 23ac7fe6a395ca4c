"""A command whose extra is not installed says which; the others do not need it."""

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PACKAGES = {
    "sim": ("matplotlib",),
    "bus": ("can", "canopen", "pyarrow"),
    "design": ("distributed", "tomlkit"),
}
"""What is imported of every extra."""
HIDDEN = """
import sys
for name in sys.argv.pop(1).split(","):
    sys.modules[name] = None
from turnbuckle.command_line import main
main()
"""


def run_without(extras: list[str], words: str, folder: Path) -> subprocess.CompletedProcess[str]:
    """Run a command as if the packages of some extras were not installed."""
    hidden = ",".join(name for extra in extras for name in PACKAGES[extra])
    return subprocess.run(
        [sys.executable, "-c", HIDDEN, hidden, *words.split()],
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.mark.parametrize(
    ("extra", "words"),
    [
        ("sim", "demo yoon2023"),
        ("sim", "analyze yoon2023"),
        ("sim", "compare brau_triangle brau_square"),
        ("sim", "log flight.dump --out flight.csv --plot flight.png"),
        ("bus", "log flight.dump --out flight.csv"),
        ("bus", "run yoon_fixed_diagonal --sim"),
        ("design", "optimise yoon2023 --vary tension.max=9N..10N"),
        ("design", "study yoon2023 --vary tension.max=9N..10N:2 --out study"),
    ],
)
def test_a_command_says_which_extra_it_lacks(extra: str, words: str, tmp_path: Path) -> None:
    done = run_without([extra], words, tmp_path)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith(f"turnbuckle: {words.split()[0]} needs ")
    assert f"pip install 'turnbuckle[{extra}]'" in done.stderr
    assert done.stderr.count("\n") == 1
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("status", "words"),
    [
        (0, "--help"),
        (0, "check yoon2023"),
        (0, "bus yoon2023"),
        (0, "generate brau_triangle"),
        (0, "verify brau_triangle --points 1"),
        (2, "run brau_triangle"),
        (2, "monitor nobody --once"),
        (2, "replay nothing.dump"),
    ],
)
def test_the_base_needs_no_extra(status: int, words: str, tmp_path: Path) -> None:
    done = run_without(list(PACKAGES), words, tmp_path)
    assert done.returncode == status, done.stderr
    assert "needs" not in done.stderr and "Traceback" not in done.stderr


def test_a_package_that_no_extra_brings_is_a_defect(tmp_path: Path) -> None:
    PACKAGES["base"] = ("pydantic",)
    try:
        assert "ModuleNotFoundError" in run_without(["base"], "check yoon2023", tmp_path).stderr
    finally:
        del PACKAGES["base"]
