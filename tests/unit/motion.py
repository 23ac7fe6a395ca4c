"""Recorded inputs for a controller: a smooth random movement of handle, bases and forces."""

import shutil
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from turnbuckle.codegen.bind import Generated
from turnbuckle.codegen.controller import RUNTIME_CORE, Controller
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine

ROOT = Path(__file__).parents[2]


def committed(name: str, precision: str) -> Generated:
    """The generated C of a stock machine, as it is committed."""
    machine = load_machine(ROOT / "machines" / f"{name}.toml")
    return Generated(machine, ROOT / "generated" / name, precision)


def with_defect(folder: Path, old: str, new: str) -> Path:
    """A copy of the runtime's core in which one place of the controller is changed."""
    core = shutil.copytree(RUNTIME_CORE, folder / "core")
    source = core / "controller.c"
    text = source.read_text()
    assert text.count(old) == 1, f"{text.count(old)} places read {old!r}"
    source.write_text(text.replace(old, new))
    return core


def smooth(cycles: int, size: int, seed: int) -> NDArray[np.float64]:
    """Sums of three slow sines (cycles, size), each entry within [-1, 1]."""
    random = np.random.default_rng(seed)
    time = np.arange(cycles)[:, None, None]
    phase, frequency = random.uniform(0, 2 * np.pi, (2, 3, size))
    waves = np.sin(phase + 2e-3 * (1 + frequency) * time)
    return np.asarray(waves.mean(axis=1))


def recorded(machine: Machine, controller: Controller, cycles: int, seed: int) -> NDArray[np.void]:
    """Inputs of a hand that moves all over the target, with bases that lag behind it."""
    inputs = controller.recording(cycles)
    pose = np.array(machine.target.centre) + 0.45 * np.array(machine.target.size) * smooth(
        cycles, machine.dof, seed
    )
    rails = bases_near(machine, pose, 0.02 * smooth(cycles, len(machine.rails), seed + 1))
    inputs["lengths"] = lengths(machine, pose, rails)
    inputs["rails"][:, : rails.shape[1]] = rails
    inputs["force"] = 12.0 * smooth(cycles, machine.dof, seed + 2)
    inputs["hand_force"] = 8.0 * smooth(cycles, machine.dof, seed + 3)
    return inputs


def bases_near(
    machine: Machine, pose: NDArray[np.float64], lag: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Rail coordinates (cycles, m) [m] so far from the feet of the perpendiculars."""
    rails = np.zeros_like(lag)
    for motion in machine.base_motions:
        for column, direction in motion.travel:
            foot = (pose - np.array(motion.start)) @ np.array(direction)
            length = machine.rails[column].length
            rails[:, column] = np.clip(foot + lag[:, column], 0.0, length)
    return rails


def lengths(
    machine: Machine, pose: NDArray[np.float64], rails: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Cable lengths (cycles, n) [m]."""
    columns: list[Any] = []
    for motion in machine.base_motions:
        points = np.array(motion.start)
        for k, direction in motion.travel:
            points = points + rails[:, k, None] * np.array(direction)
        columns.append(np.linalg.norm(points - pose, axis=1))
    return np.stack(columns, axis=1)
