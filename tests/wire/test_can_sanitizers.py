"""The CAN ports under the sanitizers: all that their tests do, and nothing found."""

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]
TESTS = ROOT / "tests"
CHECKS = [
    TESTS / "unit" / "test_loopback.py",
    TESTS / "unit" / "test_slcan_text.py",
    TESTS / "wire" / "test_slcan.py",
]
TOO_SHORT_A_LINE = """
import ctypes
from can_ports import Frame, library

library().tb_slcan_write(ctypes.byref(Frame(1, 0, 8)), ctypes.create_string_buffer(20))
"""


def run_sanitized(*arguments: str | Path) -> subprocess.CompletedProcess[str]:
    """Run Python with every library of ours compiled for the address and undefined sanitizers."""
    runtime = subprocess.check_output(["gcc", "-print-file-name=libasan.so"], text=True).strip()
    environment = {
        **os.environ,
        "CC": "gcc -g -fsanitize=address,undefined -fno-sanitize-recover=all",
        "LD_PRELOAD": runtime,
        "ASAN_OPTIONS": "detect_leaks=0",
        "PYTHONMALLOC": "malloc",
        "PYTHONPATH": f"{ROOT}:{TESTS}",
    }
    return subprocess.run(
        [sys.executable, *arguments],
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )


def test_nothing_is_found_in_the_ports_and_the_codec() -> None:
    done = run_sanitized("-m", "pytest", "-q", "-x", "-p", "no:cacheprovider", *CHECKS)
    assert done.returncode == 0, done.stdout + done.stderr


def test_a_caller_s_seeded_fault_is_found() -> None:
    done = run_sanitized("-c", TOO_SHORT_A_LINE)
    assert done.returncode != 0
    assert "heap-buffer-overflow" in done.stderr
