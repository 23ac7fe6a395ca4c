"""No undefined behaviour and no access beyond an array, on ordinary, hard and broken arguments."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
SANITIZERS = {
    "undefined": "-fsanitize=undefined,float-cast-overflow -fno-sanitize-recover=all",
    "address": "-fsanitize=address",
}
OVERFLOW = "    volatile int most = 2147483647;\n    most = most + 1;\n    return TB_OK;"
#: Runs in a process of its own, because a finding ends it.
CALL_EVERYTHING = """
import sys
from pathlib import Path
import numpy as np
from turnbuckle.codegen.bind import Generated
from turnbuckle.codegen.hard_cases import HardSampler
from turnbuckle.model.reading import load_machine

machine = load_machine(sys.argv[1])
for precision in ("double", "float"):
    generated = Generated(machine, Path(sys.argv[2]), precision)
    for name, function in generated.functions.items():
        sampler = HardSampler(machine, 3, 500)
        given = [
            sampler.argument(name, p.name, p.size).reshape(-1, *p.shape) for p in function.inputs
        ]
        function(*given)
        for bad in (np.nan, np.inf, -np.inf, 1e38, 1e-45, 0.0, -1.0):
            function(*(np.full_like(values, bad) for values in given))
print("finished")
"""


def run_everything(
    sanitizer: str, machine: Path, folder: Path, scratch: Path
) -> subprocess.CompletedProcess[str]:
    compiler = scratch / f"gcc-{sanitizer}"
    compiler.write_text(f'#!/bin/sh\nexec gcc {SANITIZERS[sanitizer]} "$@"\n')
    compiler.chmod(0o755)
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "CC": str(compiler)}
    if sanitizer == "address":
        library = subprocess.run(
            ["gcc", "-print-file-name=libasan.so"], capture_output=True, text=True, check=True
        ).stdout.strip()
        environment |= {"LD_PRELOAD": library, "ASAN_OPTIONS": "detect_leaks=0"}
    return subprocess.run(
        [sys.executable, "-c", CALL_EVERYTHING, str(machine), str(folder)],
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.mark.parametrize("sanitizer", SANITIZERS)
def test_nothing_is_found_in_the_generated_c(
    sanitizer: str, stock_file: Path, stock_folder: Path, tmp_path: Path
) -> None:
    done = run_everything(sanitizer, stock_file, stock_folder, tmp_path)
    assert done.stdout == "finished\n" and done.returncode == 0, done.stderr


@pytest.mark.parametrize(
    ("sanitizer", "old", "new", "finding"),
    [
        ("undefined", "    return TB_OK;", OVERFLOW, "signed integer overflow"),
        (
            "address",
            "TB_DRUM_RADIUS * tension[3]",
            "TB_DRUM_RADIUS * tension[4]",
            "heap-buffer-over",
        ),
    ],
)
def test_a_seeded_fault_is_found(
    sanitizer: str,
    old: str,
    new: str,
    finding: str,
    stock_file: Path,
    stock_folder: Path,
    tmp_path: Path,
) -> None:
    folder = Path(shutil.copytree(stock_folder, tmp_path / "seeded"))
    source = folder / "tb_control.c"
    assert old in source.read_text()
    source.write_text(source.read_text().replace(old, new, 1))
    done = run_everything(sanitizer, stock_file, folder, tmp_path)
    assert finding in done.stderr and done.stdout == ""
