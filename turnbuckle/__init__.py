"""Describe a cable-driven haptic machine in one file; get its controller as C.

load compiles the C of a machine and binds it, load_machine only reads the file; PoseMap,
target_grid and tally map its workspace. Refusal is what every function raises that cannot do what
it was asked for. The rest is in turnbuckle.model, turnbuckle.codegen and turnbuckle.lab.
"""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from turnbuckle.codegen.bind import load
    from turnbuckle.codegen.map_tally import tally
    from turnbuckle.codegen.pose_map import PoseMap, target_grid
    from turnbuckle.model.reading import load_machine
    from turnbuckle.model.refusal import Refusal

__all__ = ["PoseMap", "Refusal", "load", "load_machine", "tally", "target_grid"]
_HOMES = {
    "PoseMap": "turnbuckle.codegen.pose_map",
    "Refusal": "turnbuckle.model.refusal",
    "load": "turnbuckle.codegen.bind",
    "load_machine": "turnbuckle.model.reading",
    "tally": "turnbuckle.codegen.map_tally",
    "target_grid": "turnbuckle.codegen.pose_map",
}


def __getattr__(name: str) -> Any:
    """Import what is asked for only then, so that quick commands stay quick."""
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(_HOMES[name]), name)
