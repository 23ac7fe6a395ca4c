"""Machines of every kind with many cables, and tension problems for them whose answer is known."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from turnbuckle.codegen.item import Item
from turnbuckle.codegen.lower import lower
from turnbuckle.codegen.model import composed
from turnbuckle.codegen.simplify import simplify
from turnbuckle.model.kind import KINDS
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine
from turnbuckle.model.symbolic import tension
from turnbuckle.model.symbolic.wrench_norm import weights

Doubles = NDArray[np.float64]

TEXT = """
[machine]
name = "many"
kind = "{kind}"
source = "a test"

[frame]
size = [{size}]
{platform}
{cables}
[tension]
min = "{low} N"
max = "10 N"
when_infeasible = "closest"

[drum]
radius = "5 mm"

[cable_motor]
inertia = "21 g*cm^2"
damping = "0.05 g*m^2/s"
torque_limit = "55 mN*m"
torque_rate_limit = "20 N*m/s"

[control]
rate = "1 kHz"
velocity_corner = "100 Hz"

[target]
size = [{target}]
centre = [{centre}]
force = "1 N"
"""
TURNING = '[platform]\nrotation = "30 deg"\n'


def point(place: Doubles) -> str:
    """A TOML array of lengths."""
    return ", ".join(f'"{x:.4f} m"' for x in place)


def many_cables(folder: Path, kind: str, count: int, low: float) -> Machine:
    """A machine of a kind with fixed bases anywhere around a frame of one metre."""
    random = np.random.default_rng(count)
    space, rigid = KINDS[kind].space, KINDS[kind].is_rigid
    tables = ""
    for _ in range(count):
        base = random.uniform(0, 1, space)
        base[random.integers(space)] = random.integers(2)
        anchor = random.uniform(-0.1, 0.1, space)
        tables += f"[[cable]]\nbase = [{point(base)}]\n"
        tables += f"anchor = [{point(anchor)}]\n\n" if rigid else "\n"
    ones = np.ones(space)
    text = TEXT.format(
        kind=kind,
        size=point(ones),
        platform=TURNING if rigid else "",
        cables=tables,
        low=low,
        target=point(0.1 * ones),
        centre=point(0.5 * ones),
    )
    path = folder / "many.toml"
    path.write_text(text)
    return load_machine(path)


def tension_items(machine: Machine) -> list[Item]:
    """The topic of tensions, lowered."""
    known: dict[str, Item] = {f.name: simplify(lower(f)) for f in tension.functions(machine)}
    for composite in tension.composites(machine):
        known[composite.name] = composed(composite, known)
    return list(known.values())


@dataclass(frozen=True)
class Problems:
    """structure (k, d, n), wrench (k, d) [N, N m]; its optimal tension (k, n) [N]."""

    structure: Doubles
    wrench: Doubles
    tension: Doubles


def structures(machine: Machine, count: int, random: np.random.Generator) -> Doubles:
    """Directions of force of length 1, moments of the lever; in a third two pairs are parallel."""
    moments = machine.dof - machine.space if machine.is_rigid else 0
    structure = random.standard_normal((count, machine.dof, len(machine.cables)))
    forces = structure[:, : machine.dof - moments]
    forces /= np.linalg.norm(forces, axis=1, keepdims=True)
    structure[:, machine.dof - moments :] *= machine.lever
    third = count // 3
    structure[:third, :, 1] = structure[:third, :, 0]
    structure[:third, :, 3] = -structure[:third, :, 2]
    # Single precision holds them too, so that both precisions are asked the same.
    return structure.astype(np.float32).astype(np.float64)


def known_problems(machine: Machine, count: int, seed: int) -> Problems:
    """T = clip(S' y) is optimal for W = S T: inside, on edges and in corners of the feasible."""
    random = np.random.default_rng(seed)
    structure = structures(machine, count, random)
    low, high = machine.tension.min, machine.tension.max
    size = high * random.choice([0.3, 1.0, 2.0, 20.0], (count, 1))
    multiplier = random.standard_normal((count, machine.dof)) * size
    alike = structure * np.array(weights(machine))[:, None]
    tension = np.clip(np.einsum("kdn,kd->kn", alike, multiplier), low, high)
    return Problems(structure, np.einsum("kdn,kn->kd", structure, tension), tension)


def middle(machine: Machine, structure: Doubles) -> Doubles:
    """The wrench of the mean tension on every cable."""
    mean = (machine.tension.min + machine.tension.max) / 2
    return np.asarray(mean * np.sum(structure, axis=2))


def about(machine: Machine, known: Problems, factors: Doubles) -> Doubles:
    """Wrenches of problems moved towards the middle of the feasible ones, or away from it."""
    centre = middle(machine, known.structure)
    return np.asarray(centre + (known.wrench - centre) * factors[:, None])
