"""The generated Jacobians are derivatives, and virtual work vanishes."""

import numpy as np
from dual import Dual, constant, variables
from numpy.typing import NDArray

from codegen.bind import Generated
from codegen.samples import Sampler
from model.base import FixedBase, RailBase
from model.machine import Machine

Doubles = NDArray[np.float64]
POINTS = 5000
EPSILON = float(np.finfo(np.float64).eps)


def lengths(machine: Machine, pose: list[Dual], rails: list[Dual]) -> list[Dual]:
    """|b_i - c| of dual numbers, written from Yoon eq. 18."""
    result = []
    for number, cable in enumerate(machine.cables):
        square = constant(0.0)
        for axis, coordinate in enumerate(pose):
            if isinstance(cable.base, FixedBase):
                point = constant(cable.base.position[axis])
            else:
                assert isinstance(cable.base, RailBase)
                slide = rails[machine.base_motions[number].travel[0][0]]
                slope = constant(cable.base.direction[axis])
                point = constant(cable.base.start[axis]) + slope * slide
            side = point - coordinate
            square = square + side * side
        result.append(square.sqrt())
    return result


def drawn(machine: Machine) -> Sampler:
    """Poses of operation that do not touch a pulley."""
    sampler = Sampler(machine, 71, POINTS)
    clear = np.min(sampler.lengths, axis=1) > 1e-3
    sampler.pose, sampler.rails, sampler.lengths = (
        a[clear] for a in (sampler.pose, sampler.rails, sampler.lengths)
    )
    return sampler


def nearness(sampler: Sampler) -> Doubles:
    """Rounding of a direction: that of a coordinate over the distance (k, 1)."""
    return np.asarray(8 * EPSILON / np.min(sampler.lengths, axis=1, keepdims=True))


def test_the_length_jacobian_is_the_derivative_by_dual_numbers(
    stock: Machine, double: Generated
) -> None:
    s = drawn(stock)
    jacobian = np.asarray(double.length_jacobian(s.pose, s.rails))
    for axis in range(stock.dof):
        moved = lengths(stock, variables(s.pose, axis), variables(s.rails, -1))
        rates = np.stack([length.rate for length in moved], axis=1)
        assert np.all(np.abs(jacobian[:, :, axis] - rates) <= nearness(s))


def test_the_rail_jacobian_is_the_derivative_by_dual_numbers(
    stock: Machine, double: Generated
) -> None:
    s = drawn(stock)
    jacobian = np.asarray(double.rail_jacobian(s.pose, s.rails))
    for rail in range(len(stock.rails)):
        moved = lengths(stock, variables(s.pose, -1), variables(s.rails, rail))
        rates = np.stack([length.rate + 0 * s.pose[:, 0] for length in moved], axis=1)
        assert np.all(np.abs(jacobian[:, :, rail] - rates) <= nearness(s))


def test_virtual_work_vanishes(stock: Machine, double: Generated) -> None:
    s = drawn(stock)
    random = np.random.default_rng(72)
    tension = random.uniform(stock.tension.min, stock.tension.max, s.lengths.shape)
    shift, slide = random.standard_normal(s.pose.shape), random.standard_normal(s.rails.shape)
    dl_dx = np.asarray(double.length_jacobian(s.pose, s.rails))
    dl_ds = np.asarray(double.rail_jacobian(s.pose, s.rails))
    structure = np.asarray(double.structure_matrix(s.pose, s.rails))
    wrench = np.asarray(double.wrench(structure, tension))
    force = np.asarray(double.rail_forces(s.pose, s.rails, tension))
    reeled = np.einsum("kni,ki->kn", dl_dx, shift) + np.einsum("knm,km->kn", dl_ds, slide)
    work = np.sum(tension * reeled, axis=1) + np.sum(wrench * shift, axis=1)
    work += np.sum(force * slide, axis=1)
    size = stock.tension.max * (np.sum(np.abs(shift), axis=1) + np.sum(np.abs(slide), axis=1))
    assert np.all(np.abs(work) <= 4 * size * nearness(s)[:, 0])
    assert np.max(np.abs(np.sum(tension * reeled, axis=1))) > 1
