"""The runtime with defects put in, for negative controls."""

import ctypes

import variants
from runtime_copy import Defect, seeded_copy

from turnbuckle.lab.lockstep import load


def runtime_with(name: str, *defects: Defect) -> ctypes.CDLL:
    """The runtime of the stock machine with these defects; `name` keeps its files apart."""
    build = variants.ROOT / "build" / "seeded" / name
    return load(variants.committed(), seeded_copy(build, *defects))
