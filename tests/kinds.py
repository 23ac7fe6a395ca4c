"""Machines of every kind with any number of cables, for functions that take a structure matrix."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine

Array = NDArray[np.float64]

FILE = """
[machine]
name = "trial"
kind = "{kind}"
source = "any machine of its kind"

[frame]
size = {size}
{platform}
{cables}
[tension]
min = "{low} N"
max = "10 N"
when_infeasible = "scale"

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
size = {target}
centre = {centre}
force = "1 N"
"""


def machine_of(kind: str, count: int, folder: Path, low: float = 1.0) -> Machine:
    """A machine with fixed bases anywhere in its frame, 600 mm wide; anchors up to 50 mm off."""
    random = np.random.default_rng(count)
    space = 2 if kind.startswith("planar") else 3
    rigid = kind.endswith("rigid")
    cables = ""
    for base in random.uniform(0, 600, (count, space)):
        anchor = f"anchor = {lengths(random.uniform(-50, 50, space))}\n" if rigid else ""
        base[random.integers(space)] = 600 * random.integers(2)
        cables += f"\n[[cable]]\n{anchor}base = {lengths(base)}\n"
    text = FILE.format(
        kind=kind,
        size=lengths(np.full(space, 600.0)),
        platform='\n[platform]\nrotation = "20 deg"\n' if rigid else "",
        cables=cables,
        low=low,
        target=lengths(np.full(space, 100.0)),
        centre=lengths(np.full(space, 300.0)),
    )
    path = folder / f"{kind}_{count}_{low}.toml"
    path.write_text(text)
    return load_machine(path)


def lengths(values: Array) -> str:
    """A point of a machine file."""
    return "[" + ", ".join(f'"{value:.3f} mm"' for value in values) + "]"


def structures(machine: Machine, points: int, seed: int = 1) -> Array:
    """Structure matrices (points, d, n) of cables in any directions, moments at the lever."""
    random = np.random.default_rng(seed)
    shape = (points, len(machine.cables), machine.space)
    rays = random.standard_normal(shape)
    rays /= np.linalg.norm(rays, axis=-1, keepdims=True)
    columns = [rays]
    if machine.is_rigid:
        arms = random.uniform(-1.5, 1.5, shape) * machine.lever
        columns.append(moments(arms, rays))
    return np.swapaxes(np.concatenate(columns, axis=-1), 1, 2)


def moments(arms: Array, forces: Array) -> Array:
    """Moments (..., 1 or 3) of forces in the plane or in space."""
    if arms.shape[-1] == 3:
        return np.cross(arms, forces)
    turned = arms[..., 0] * forces[..., 1] - arms[..., 1] * forces[..., 0]
    return np.asarray(turned[..., None])


def weighed(machine: Machine, rows: Array) -> Array:
    """Rows of wrenches (..., d, k) with moments over the lever."""
    weights = np.ones(machine.dof)
    weights[machine.space if machine.is_rigid else machine.dof :] = 1 / machine.lever
    return np.asarray(weights[:, None] * rows)
