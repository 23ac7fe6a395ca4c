"""The topics of the model: one C file each, in this order."""

from collections.abc import Callable

from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic import (
    comparison,
    control,
    kinematic_functions,
    quality,
    statics,
    tension,
)
from turnbuckle.model.symbolic.composition import Composite
from turnbuckle.model.symbolic.function import ModelFunction

TOPICS: dict[str, tuple[str, Callable[[Machine], list[ModelFunction]]]] = {
    "kinematics": ("where the cables are and how they move", kinematic_functions.functions),
    "statics": ("forces between cables, platform and bases", statics.functions),
    "tension": ("tension distribution", tension.functions),
    "comparison": ("published tension methods", comparison.functions),
    "quality": ("tension factor and isotropic force of a pose", quality.functions),
    "control": ("control laws around the tension distribution", control.functions),
}


def model_functions(machine: Machine) -> dict[str, list[ModelFunction]]:
    """Every function of the machine's model, by topic."""
    return {topic: build(machine) for topic, (_, build) in TOPICS.items()}


def model_composites(machine: Machine) -> dict[str, list[Composite]]:
    """Every function that is made of others, by topic; those it is made of come before it."""
    return {
        "kinematics": [*kinematic_functions.composites(machine)],
        "tension": tension.composites(machine),
        "comparison": comparison.composites(machine),
        "quality": quality.composites(machine),
    }
