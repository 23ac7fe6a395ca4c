"""The committed C is what the generator writes today, whatever the surroundings."""

import difflib
import hashlib
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from turnbuckle.codegen.accuracy import Accuracy
from turnbuckle.codegen.generate import render
from turnbuckle.codegen.model import Model

ROOT = Path(__file__).parents[2]
REGENERATE = """
import hashlib, sys
from pathlib import Path
import turnbuckle.codegen.accuracy_cache as cache
from turnbuckle.codegen.model import build_model
from turnbuckle.codegen.generate import render
from turnbuckle.model.reading import load_machine
machine = load_machine(sys.argv[1])
model = build_model(machine)
cache.CACHE = Path(sys.argv[2])
files = render(model, cache.measured_accuracy(machine, model.items()))
for name, text in sorted(files.items()):
    print(hashlib.sha256(text.encode()).hexdigest(), name)
"""


def differences(files: dict[str, str], folder: Path) -> str:
    """Unified diff from the committed files to fresh ones; empty where they are the same bytes."""
    committed = {path.name: path.read_bytes() for path in folder.iterdir()}
    names: list[str] = []
    lines: list[str] = []
    for name in sorted(committed.keys() | files.keys()):
        old, new = committed.get(name, b""), files.get(name, "").encode()
        if old != new:
            before, after = (text.decode(errors="replace").splitlines() for text in (old, new))
            lines += difflib.unified_diff(
                before, after, f"committed/{name}", f"generated/{name}", lineterm="", n=1
            )
            names.append(f"{name} differs")
    return "\n".join([*names, *lines[:200]])


def test_the_committed_c_is_what_the_generator_writes(
    stock_model: Model, stock_accuracies: dict[str, Accuracy], stock_folder: Path
) -> None:
    drift = differences(render(stock_model, stock_accuracies), stock_folder)
    assert not drift, f"run `make generate` and commit the result:\n{drift}"


@pytest.mark.parametrize(
    ("name", "old", "new"),
    [
        ("tb_machine.h", b"TB_TENSION_MAX TB_C(10.0)", b"TB_TENSION_MAX TB_C(10.5)"),
        ("tb_kinematics.c", b" + ", b" - "),
        ("tb_tension.h", b"\n", b"\r\n"),
        ("manifest.json", b"4", b"5"),
    ],
)
def test_a_changed_byte_is_drift(
    name: str,
    old: bytes,
    new: bytes,
    stock_model: Model,
    stock_accuracies: dict[str, Accuracy],
    stock_folder: Path,
    tmp_path: Path,
) -> None:
    folder = Path(shutil.copytree(stock_folder, tmp_path / "generated"))
    content = (folder / name).read_bytes()
    assert old in content
    (folder / name).write_bytes(content.replace(old, new, 1))
    drift = differences(render(stock_model, stock_accuracies), folder)
    assert f"{name} differs" in drift


def test_a_missing_and_a_foreign_file_are_drift(
    stock_model: Model, stock_accuracies: dict[str, Accuracy], stock_folder: Path, tmp_path: Path
) -> None:
    folder = Path(shutil.copytree(stock_folder, tmp_path / "generated"))
    (folder / "tb_statics.c").rename(folder / "tb_foreign.c")
    drift = differences(render(stock_model, stock_accuracies), folder)
    assert "tb_statics.c differs" in drift and "tb_foreign.c differs" in drift


def test_hash_seed_folder_language_and_a_cold_cache_change_nothing(
    stock_file: Path, stock_model: Model, stock_accuracies: dict[str, Accuracy], tmp_path: Path
) -> None:
    here = render(stock_model, stock_accuracies)
    wanted = {f"{hashlib.sha256(text.encode()).hexdigest()} {name}" for name, text in here.items()}
    cache = tmp_path / "cache"  # cold in the first round, warm in the second
    for seed, language in (("1", "C"), ("4242", "C.utf8")):
        surroundings = {"PYTHONHASHSEED": seed, "LC_ALL": language, "TZ": "Asia/Tokyo"}
        done = subprocess.run(
            [sys.executable, "-c", REGENERATE, str(stock_file), str(cache)],
            cwd=tmp_path,
            env={**os.environ, "PYTHONPATH": str(ROOT), **surroundings},
            capture_output=True,
            text=True,
            check=True,
        )
        assert set(done.stdout.splitlines()) == wanted
        assert any(cache.iterdir())
