"""The closed loop: the compiled controller step against the plant, at the control rate.

The order of a cycle is that of a machine on a bus: measure, compute, send; what is sent acts from
the next cycle on, when the drives take it over together.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import ceil
from typing import Any

import numpy as np
from numpy.typing import NDArray

from turnbuckle.codegen.controller import Controller, Outputs
from turnbuckle.lab.hand import hand_of
from turnbuckle.lab.plant import SimulatedPlant
from turnbuckle.lab.plants import simulated_plant
from turnbuckle.lab.task import Phase, Task
from turnbuckle.model.machine import Machine, Plant
from turnbuckle.model.reference.control import base_targets

Reals = NDArray[np.float64]
Progress = Callable[[float], None]


@dataclass(frozen=True)
class Recording:
    """One run: a row per cycle, as things were when the cycle measured. SI units."""

    task: Task
    time: Reals  # (k)
    path: Reals  # (k, d) where the hand wants to be
    position: Reals  # (k, d) where the handle is
    tensions: Reals  # (k, n) what the cables carry
    lowest_tension: Reals  # (k) of all cables since the cycle before
    highest_tension: Reals  # (k)
    cable_force: Reals  # (k, d) of the cables on the handle
    hand_force: Reals  # (k, d) of the hand on the handle
    rails: Reals  # (k, m)
    inputs: NDArray[np.void]  # what the controller read, ready for Controller.run_recorded
    outputs: Outputs  # what it gave

    def during(self, phase: Phase) -> NDArray[np.bool_]:
        """Which cycles belong to a phase of the task."""
        return (self.time >= phase.begin) & (self.time < phase.end)


def run_task(
    machine: Machine,
    plant: Plant,
    controller: Controller,
    task: Task,
    options: int = 0,
    progress: Progress = lambda share: None,
) -> Recording:
    """Run a task from standstill; `progress` is told the share that is done."""
    start, _, _ = task.path.at(0.0)
    rails = base_targets(machine, start).tolist()
    world = simulated_plant(machine, plant, hand_of(machine, plant, task.path), start, rails)
    inputs = controller.recording(ceil(task.path.end * machine.control.rate))
    inputs["options"] = options
    controller.start(world.lengths, world.rails)
    torques, rail_forces = [0.0] * len(machine.cables), [0.0] * len(machine.rails)
    rows: list[dict[str, Any]] = []
    outputs: list[Outputs] = []
    for cycle in range(len(inputs)):
        rows.append(_look(world, task))
        _measure(world, task, inputs[cycle])
        sent, _ = controller.run_recorded(inputs[cycle : cycle + 1])
        outputs.append(sent)
        world.advance(torques, rail_forces)
        torques, rail_forces = sent.motor_torque[0].tolist(), sent.rail_force[0].tolist()
        progress(cycle / len(inputs))
    columns = {name: np.array([row[name] for row in rows]) for name in rows[0]}
    joined = Outputs(*(np.concatenate(column) for column in zip(*outputs, strict=True)))
    return Recording(task=task, inputs=inputs, outputs=joined, **columns)


def _look(world: SimulatedPlant, task: Task) -> dict[str, Any]:
    return {
        "time": world.time,
        "path": task.path.at(world.time)[0],
        "position": world.position,
        "tensions": world.tensions,
        "lowest_tension": world.lowest_tension,
        "highest_tension": world.highest_tension,
        "cable_force": world.cable_force,
        "hand_force": world.hand_force,
        "rails": world.rails,
    }


def _measure(world: SimulatedPlant, task: Task, measured: np.void) -> None:
    """What the sensors and the application tell the controller."""
    rails = world.rails
    measured["lengths"] = world.lengths
    measured["rails"][: len(rails)] = rails
    measured["force"] = task.force(world.time)
    measured["hand_force"] = world.hand_force
