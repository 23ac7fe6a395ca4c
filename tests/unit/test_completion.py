"""The shell completes machine files and the names of stock machines."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

TURNBUCKLE = Path(sys.executable).with_name("turnbuckle")


def offered(words: str, folder: Path) -> list[str]:
    """What bash is told when the last word is to be completed."""
    asked = {
        "_TURNBUCKLE_COMPLETE": "complete_bash",
        "COMP_WORDS": f"turnbuckle {words}",
        "COMP_CWORD": str(len(words.split(" "))),
    }
    done = subprocess.run(
        [TURNBUCKLE], cwd=folder, env=os.environ | asked, capture_output=True, text=True, check=True
    )
    return done.stdout.split()


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "yours").mkdir()
    (tmp_path / "yours" / "arm.toml").touch()
    for name in ("yacht.toml", "yacht.txt"):
        (tmp_path / name).touch()
    return tmp_path


@pytest.mark.parametrize(
    ("words", "wanted"),
    [
        ("check y", {"yacht.toml", "yours/", "yoon2023"}),
        ("check yours/", {"yours/arm.toml"}),
        ("compare yacht.toml spi", {"spidar_g"}),
        ("new arm --from brau_te", {"brau_tetrahedron"}),
        ("replay flight.dump ya", {"yacht.toml"}),
        ("monitor yach", {"yacht.toml"}),
    ],
)
def test_files_folders_and_stock_machines_are_offered(
    words: str, wanted: set[str], folder: Path
) -> None:
    found = offered(words, folder)
    assert wanted <= set(found)
    assert "yacht.txt" not in found
    assert all(each.startswith(words.split(" ")[-1]) for each in found)


def test_nothing_is_offered_for_what_is_nowhere(folder: Path) -> None:
    assert offered("check zebra", folder) == []
