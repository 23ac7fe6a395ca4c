"""Describe a cable-driven haptic machine in one file; get its controller as C.

load compiles the C of a machine and binds it; Refusal is what every function raises that cannot do
what it was asked for. The rest is in turnbuckle.model, turnbuckle.codegen and turnbuckle.lab.
"""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from turnbuckle.codegen.bind import load
    from turnbuckle.model.refusal import Refusal

__all__ = ["Refusal", "load"]
_HOMES = {"load": "turnbuckle.codegen.bind", "Refusal": "turnbuckle.model.refusal"}


def __getattr__(name: str) -> Any:
    """Import what is asked for only then, so that quick commands stay quick."""
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(_HOMES[name]), name)
