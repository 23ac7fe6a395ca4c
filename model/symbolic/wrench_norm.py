"""Moments made comparable with forces: norms of wrenches are those of [F; M / lever]."""

from collections.abc import Sequence

from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic.scalar import Matrix, Scalar, Vector


def weights(machine: Machine) -> list[float]:
    """Factor of every entry of a wrench: 1 for forces [1], 1 / lever for moments [1/m]."""
    moments = machine.dof - machine.space if machine.is_rigid else 0
    return [1.0] * (machine.dof - moments) + [1 / machine.lever] * moments


def weighed(machine: Machine, wrench: Sequence[Scalar]) -> Vector:
    """The wrench [N] with moments over the lever."""
    return [w * x for w, x in zip(weights(machine), wrench, strict=True)]


def weighed_rows(machine: Machine, matrix: Matrix) -> Matrix:
    """The structure matrix with the rows of moments over the lever."""
    return [[w * x for x in row] for w, row in zip(weights(machine), matrix, strict=True)]
