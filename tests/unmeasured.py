"""The C of some topics of a machine, without the search for its worst errors."""

from functools import cache
from pathlib import Path

from built import optimised

from turnbuckle.codegen.accuracy import Accuracy
from turnbuckle.codegen.bind import Generated, folder_of
from turnbuckle.codegen.generate import render
from turnbuckle.codegen.item import Item
from turnbuckle.codegen.lower import lower
from turnbuckle.codegen.model import Model, composed
from turnbuckle.codegen.simplify import simplify
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine
from turnbuckle.model.symbolic.topics import TOPICS, model_composites

FOLDERS = (Path(__file__).parent / "machines", Path(__file__).parents[1] / "machines")
#: One machine of every kind, with every sort of base, and pulleys on three of them.
EVERY_KIND = [
    "kinematics_planar_pulleys",
    "kinematics_planar_rigid",
    "kinematics_spatial_point",
    "kinematics_spatial_rigid",
]
GEOMETRY = ("kinematics", "statics", "control")
#: What the controller step calls.
STEP = ("kinematics", "statics", "tension", "control")


class Unmeasured(Model):
    """Some topics of a machine; a function whose target is not among them has no second name."""

    def aliases(self) -> dict[str, str]:
        known = {item.function.name for item in self.items()}
        return {name: target for name, target in super().aliases().items() if target in known}


@cache
def machine_named(name: str) -> Machine:
    """A machine of the tests, or a stock machine."""
    paths = [folder / f"{name}.toml" for folder in FOLDERS]
    return load_machine(next(path for path in paths if path.exists()))


def items(machine: Machine, topics: tuple[str, ...]) -> dict[str, list[Item]]:
    """The functions of some topics, ready to print."""
    found: dict[str, list[Item]] = {}
    for topic in topics:
        found[topic] = [simplify(lower(function)) for function in TOPICS[topic][1](machine)]
        known = {item.function.name: item for item in found[topic]}
        composites = model_composites(machine).get(topic, [])
        found[topic] += [composed(composite, known) for composite in composites]
    return found


def compiled(
    machine: Machine, precision: str = "double", topics: tuple[str, ...] = GEOMETRY
) -> Generated:
    """Some compiled topics of a machine."""
    model = Unmeasured(machine, items(machine, topics))
    files = render(model, {item.function.name: Accuracy() for item in model.items()})
    folder = folder_of(machine, files)
    with optimised("-O1"):
        return Generated(machine, folder, precision)


@cache
def geometry(name: str, precision: str = "double") -> Generated:
    """The compiled kinematics, statics and control of a machine of the tests, or a stock one."""
    return compiled(machine_named(name), precision)
