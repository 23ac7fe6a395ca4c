"""The runtime with defects put in, for negative controls."""

import ctypes

import variants
from runtime_copy import write_copy

from turnbuckle.lab.lockstep import FOLDERS, load

Defect = tuple[str, str, str]
"""A file of the runtime, what stands in it once, and what takes its place."""


def runtime_with(name: str, *defects: Defect) -> ctypes.CDLL:
    """The runtime of the stock machine with these defects; `name` keeps its files apart."""
    build = variants.ROOT / "build" / "seeded" / name
    files = {
        f"{folder.name}/{path.name}": path.read_text()
        for folder in FOLDERS
        for path in folder.glob("*.[ch]")
    }
    for file, right, wrong in defects:
        assert files[file].count(right) == 1, right
        files[file] = files[file].replace(right, wrong)
    write_copy(build, files)
    return load(variants.committed(), [build / folder.name for folder in FOLDERS])
