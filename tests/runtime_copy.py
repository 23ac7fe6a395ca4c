"""Copies of the runtime's C in the build folder, for what is changed in them."""

from collections.abc import Mapping
from pathlib import Path

from turnbuckle.model.files import write_whole


def write_copy(build: Path, files: Mapping[str, str]) -> None:
    """Write C files by their names below a folder; those of an earlier copy go."""
    for name, text in files.items():
        write_whole(build / name, text)
    for path in {*build.rglob("*.[ch]")} - {build / name for name in files}:
        path.unlink(missing_ok=True)
