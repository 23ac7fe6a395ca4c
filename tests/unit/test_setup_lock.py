"""The lock pins every Python package by version and hash, and names no place to get it from."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PIN = re.compile(r"(?P<name>[a-z0-9-]+)==[0-9][0-9a-z.]*( ; [^\\]+)? \\")
HASH = re.compile(r"    --hash=sha256:[0-9a-f]{64}( \\)?")


def pinned_names(lock: str) -> set[str]:
    """Names that `lock` pins with at least one hash; ValueError at a line that is anything else."""
    names: set[str] = set()
    pin = None
    for line in lock.splitlines():
        if match := PIN.fullmatch(line):
            pin = match["name"]
        elif pin and HASH.fullmatch(line):
            names.add(pin)
        elif line and not line.startswith("# The following packages are considered to be unsafe"):
            raise ValueError(line)
    return names


def wanted_names() -> set[str]:
    lines = (ROOT / "requirements.in").read_text().splitlines()
    return {re.split("[=<>~ ]", line)[0] for line in lines if line and not line.startswith("#")}


def test_the_lock_holds_only_pins_with_hashes() -> None:
    assert len(pinned_names((ROOT / "requirements.lock").read_text())) >= len(wanted_names())


def test_all_that_is_asked_for_is_pinned() -> None:
    assert wanted_names() <= pinned_names((ROOT / "requirements.lock").read_text())


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
        pinned_names(line)


def test_a_pin_without_a_hash_is_caught() -> None:
    assert pinned_names("numpy==2.0 \\\n") == set()
