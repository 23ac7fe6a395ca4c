"""The arguments of a machine's vectors, and what this computer gives for them.

Tension distributions are those of the difficult points; the controller goes a short way from rest,
with a force that the cables do not have and a measurement that is none on the way.
"""

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from turnbuckle.codegen.bind import REALS, Generated
from turnbuckle.codegen.hard_cases import HardSampler
from turnbuckle.lab.vectors.vectors import Vector, Vectors, Words
from turnbuckle.model.machine import Machine

POINTS, SEED = 24, 92
CYCLES = 14
BEYOND, BROKEN = 6, 9
"""Cycles in which more force is wanted than there is, and in which a length is NaN."""
EXCESS = 50.0
"""By which that force is larger than in the other cycles."""
SWING = 0.3
"""Part of the target that the handle moves away from its centre."""
TURN = 0.1
"""Rotation of a platform that turns, part of what it may."""
STEPS = 400.0
"""Cycles of a whole swing."""

Reals = NDArray[np.float64]


def arguments(generated: Generated) -> Vectors:
    """Vectors that have no results yet."""
    machine, real = generated.machine, REALS[generated.precision]
    path = [[each.astype(real) for each in cycle] for cycle in cycles(generated)]
    steps = [Vector((*words(cycle), word(np.uint32(0)))) for cycle in path]
    return Vectors(
        {
            "distribute_tension": [Vector(each) for each in distributions(machine, real)],
            "controller_start": [Vector(words(path[0][:2]))],
            "controller_step": steps,
        }
    )


def distributions(machine: Machine, real: Any) -> Iterator[Words]:
    """Structure and wrench."""
    sampler = HardSampler(machine, SEED, POINTS)
    dof, cables = machine.dof, len(machine.cables)
    structure = sampler.argument("distribute_tension", "structure", dof * cables).astype(real)
    wrench = sampler.argument("distribute_tension", "wrench", dof).astype(real)
    return (words(pair) for pair in zip(structure, wrench, strict=True))


def cycles(generated: Generated) -> Iterator[list[Reals]]:
    """Lengths, rails, force and hand force of every cycle, in SI units."""
    machine = generated.machine
    for cycle in range(CYCLES):
        pose = pose_of(machine, cycle)
        rails = generated.base_targets(pose) if machine.rails else np.zeros(0)
        lengths = np.array(generated.cable_lengths(pose, rails), float)
        force = force_of(machine, cycle)
        wanted = EXCESS * force if cycle == BEYOND else force
        if cycle == BROKEN:
            lengths[0] = np.nan
        slots = rails if machine.rails else np.zeros(1)
        yield [lengths, np.array(slots, float), wanted, -force / 2.0]


def pose_of(machine: Machine, cycle: int) -> Reals:
    """Pose (d) [m, rad] of the handle, somewhat beside the middle of the target."""
    space, turns = machine.space, machine.dof - machine.space
    phase = 2.0 * np.pi * (0.1 + cycle / STEPS + np.arange(machine.dof) / 7.0)
    centre = np.concatenate([machine.target.centre, np.zeros(turns)])
    reach = np.concatenate([SWING / 2 * np.array(machine.target.size), np.zeros(turns)])
    if machine.is_rigid:
        reach[space:] = TURN * machine.rotation
    pose: Reals = centre + reach * np.sin(phase)
    return pose


def force_of(machine: Machine, cycle: int) -> Reals:
    """Force (d) [N, N m] that the application wants, half of what the target asks for."""
    phase = 2.0 * np.pi * (cycle / CYCLES + np.arange(machine.dof) / 5.0)
    moments = np.arange(machine.dof) >= machine.space
    lever = machine.lever if machine.is_rigid else 1.0
    force: Reals = 0.5 * machine.target.force * np.where(moments, lever, 1.0) * np.cos(phase)
    return force


def words(arrays: Sequence[NDArray[Any]]) -> Words:
    """The bits of every number."""
    return tuple(word(number) for array in arrays for number in np.ravel(array))


def word(number: Any) -> str:
    """The bits of a number."""
    return bytes(number.tobytes())[::-1].hex()


def with_results(asked: Vectors, generated: Generated, given: bytes) -> Vectors:
    """The vectors with what a program of the machine has given for them."""
    shape = result_sizes(generated)
    found: dict[str, list[Vector]] = {}
    at = 0
    for name, vector in asked.each():
        function = name.split()[0]
        results = []
        for size in shape[function]:
            results.append(given[at : at + size][::-1].hex())
            at += size
        found.setdefault(function, []).append(Vector(vector.arguments, tuple(results)))
    assert at == len(given)
    return Vectors(found)


def result_sizes(generated: Generated) -> dict[str, list[int]]:
    """Bytes of every number that a function gives: reals, then flags and the status."""
    machine = generated.machine
    real = np.dtype(REALS[generated.precision]).itemsize
    dof, cables, rails = machine.dof, len(machine.cables), max(1, len(machine.rails))
    return {
        "distribute_tension": [real] * (cables + dof + 1) + [4],
        "controller_start": [4],
        "controller_step": [real] * (4 * dof + 1 + 3 * cables + 3 * rails) + [4] * (cables + 1),
    }
