"""The plants there are: one line each, asked from the first to the last."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

from turnbuckle.lab import planar_plant, platform_plant
from turnbuckle.lab.plant import Holder, SimulatedPlant
from turnbuckle.model.machine import Machine, Plant
from turnbuckle.model.problem import MachineError, Problem


class PlantModel(NamedTuple):
    """A plant, and the machines that it does not simulate."""

    refusal: Callable[[Machine], Problem | None]
    """What of a machine it cannot simulate; None for a machine that it simulates."""
    make: Callable[[Machine, Plant, Holder, Sequence[float], Sequence[float]], SimulatedPlant]
    """From machine, its table [plant], who holds the handle, pose (d) [m, rad], rails (m) [m]."""


PLANTS: list[PlantModel] = [
    PlantModel(planar_plant.refusal, planar_plant.PlanarPlant),
    PlantModel(platform_plant.refusal, platform_plant.PlatformPlant),
]
"""The fastest first: the first that does not refuse a machine simulates it."""


def plant_model(machine: Machine) -> PlantModel:
    """The plant for a machine; MachineError with what the last one refuses where there is none."""
    problems = []
    for model in PLANTS:
        problem = model.refusal(machine)
        if problem is None:
            return model
        problems.append(problem)
    raise MachineError(machine.path, problems[-1:])


def simulated_plant(
    machine: Machine,
    plant: Plant,
    holder: Holder,
    pose: Sequence[float],
    rails: Sequence[float],
) -> SimulatedPlant:
    """A machine's physics, at rest at a pose (d) [m, rad] with its bases at `rails` [m] (m)."""
    return plant_model(machine).make(machine, plant, holder, pose, rails)
