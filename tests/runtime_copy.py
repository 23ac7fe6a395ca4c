"""Copies of the runtime's C in the build folder, for what is changed in them."""

from collections.abc import Mapping, Sequence
from pathlib import Path

from turnbuckle.lab.lockstep import FOLDERS
from turnbuckle.model.files import write_whole

Defect = tuple[str, str, str]
"""A file of the runtime, what stands in it once, and what takes its place."""


def seeded_copy(build: Path, *defects: Defect) -> Sequence[Path]:
    """Folders of a copy of the runtime's core and canopen with these defects."""
    files = {
        f"{folder.name}/{path.name}": path.read_text()
        for folder in FOLDERS
        for path in folder.glob("*.[ch]")
    }
    for file, right, wrong in defects:
        assert files[file].count(right) == 1, right
        files[file] = files[file].replace(right, wrong)
    write_copy(build, files)
    return [build / folder.name for folder in FOLDERS]


def write_copy(build: Path, files: Mapping[str, str]) -> None:
    """Write C files by their names below a folder; those of an earlier copy go."""
    for name, text in files.items():
        write_whole(build / name, text)
    for path in {*build.rglob("*.[ch]")} - {build / name for name in files}:
        path.unlink(missing_ok=True)
