"""The topics of the model: one C file each, in this order."""

from collections.abc import Callable

from model.machine import Machine
from model.symbolic import control, kinematics, quality, statics, tension
from model.symbolic.function import ModelFunction, Repeat, Retry

TOPICS: dict[str, tuple[str, Callable[[Machine], list[ModelFunction]]]] = {
    "kinematics": ("where the cables are and how they move", kinematics.functions),
    "statics": ("forces between cables, platform and bases", statics.functions),
    "tension": ("tension distribution", tension.functions),
    "quality": ("tension factor and isotropic force of a pose", quality.functions),
    "control": ("control laws around the tension distribution", control.functions),
}


def model_functions(machine: Machine) -> dict[str, list[ModelFunction]]:
    """Every function of the machine's model, by topic."""
    return {topic: build(machine) for topic, (_, build) in TOPICS.items()}


def model_composites(machine: Machine) -> dict[str, list[Retry | Repeat]]:
    """Every function that is made of others, by topic; those it is made of come before it."""
    return {
        "tension": tension.composites(machine),
        "quality": [*quality.composites(machine)],
    }
