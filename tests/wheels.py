"""Turnbuckle as a user installs it: a wheel, built by way of the source package, in an environment
of its own; what it depends on is that of the environment that runs the tests."""

import os
import shutil
import subprocess
import sys
import sysconfig
import zipfile
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parents[1]
BUILT_FROM = ("turnbuckle", "model", "codegen", "lab", "runtime", "machines")
OF_THE_REPOSITORY = {
    f"turnbuckle/lab/{name}"
    for name in (
        "benchmark",
        "budgets",
        "emulated",
        "figures",
        "mutants",
        "pages",
        "soak",
        "vectors",
    )
}


def run(*command: str | Path, folder: Path, **environment: str) -> subprocess.CompletedProcess[str]:
    """Run a command in a folder, its output piped."""
    return subprocess.run(
        command,
        cwd=folder,
        env=os.environ | {"COLUMNS": "80"} | environment,
        capture_output=True,
        text=True,
        check=False,
    )


def source_tree(folder: Path) -> Path:
    """A copy of what the package is built from, as a clone has it."""
    nothing_made = shutil.ignore_patterns("__pycache__")
    for name in BUILT_FROM:
        shutil.copytree(ROOT / name, folder / name, symlinks=True, ignore=nothing_made)
    for name in ("pyproject.toml", "README.md"):
        shutil.copy(ROOT / name, folder)
    return folder


def built(source: Path, *options: str) -> Path:
    """The wheel of a source tree: by default of the source package that is made of it first."""
    command = (sys.executable, "-m", "build", "--no-isolation", *options)
    done = run(*command, "--outdir", source / "out", source, folder=source)
    assert done.returncode == 0, done.stderr
    (wheel,) = (source / "out").glob("*.whl")
    return wheel


def files_in(wheel: Path) -> set[str]:
    """What a wheel puts into the package."""
    with zipfile.ZipFile(wheel) as archive:
        return {name for name in archive.namelist() if name.startswith("turnbuckle/")}


def files_of(source: Path) -> Iterator[str]:
    """What the package of a source tree consists of: all but what only the repository has."""
    for base, folders, names in os.walk(source / "turnbuckle", followlinks=True):
        inside = Path(base).relative_to(source).as_posix()
        folders[:] = [name for name in folders if f"{inside}/{name}" not in OF_THE_REPOSITORY]
        yield from (f"{inside}/{name}" for name in names)


def installed(wheel: Path, folder: Path) -> Path:
    """An environment with the wheel and what it depends on; the command `turnbuckle` in it."""
    make = run(sys.executable, "-m", "venv", "--without-pip", folder, folder=folder.parent)
    assert make.returncode == 0, make.stderr
    pip = (sys.executable, "-m", "pip", "--python", folder, "install", "--no-index", "--no-deps")
    done = run(*pip, "--quiet", wheel, folder=folder.parent)
    assert done.returncode == 0, done.stderr
    (packages,) = folder.glob("lib/python*/site-packages")
    (packages / "dependencies.pth").write_text(sysconfig.get_path("purelib") + "\n")
    return folder / "bin" / "turnbuckle"
