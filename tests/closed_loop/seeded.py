"""The runtime with defects put in, for negative controls."""

import ctypes

import variants

from turnbuckle.lab.lockstep import FOLDERS, load
from turnbuckle.model.files import write_whole

Defect = tuple[str, str, str]
"""A file of the runtime, what stands in it once, and what takes its place."""


def runtime_with(name: str, *defects: Defect) -> ctypes.CDLL:
    """The runtime of the stock machine with these defects; `name` keeps its files apart."""
    build = variants.ROOT / "build" / "seeded" / name
    texts = {path: path.read_text() for folder in FOLDERS for path in folder.glob("*.[ch]")}
    for path, text in texts.items():
        place = f"{path.parent.name}/{path.name}"
        for file, right, wrong in defects:
            if file == place:
                assert text.count(right) == 1, right
                text = text.replace(right, wrong)
        write_whole(build / place, text)
    for path in {*build.rglob("*.[ch]")} - {build / path.parent.name / path.name for path in texts}:
        path.unlink(missing_ok=True)  # of a runtime that had other files
    return load(variants.committed(), [build / folder.name for folder in FOLDERS])
