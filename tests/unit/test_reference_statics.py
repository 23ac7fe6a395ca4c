"""The reference statics: equilibrium and the reaction on the bases."""

import numpy as np

from turnbuckle.model.reading import load_machine
from turnbuckle.model.reference.kinematics import cable_lengths, structure_matrix
from turnbuckle.model.reference.statics import rail_forces, wrench

STOCK = load_machine("machines/yoon2023.toml")
EPS = np.finfo(float).eps
POSE, RAILS = np.array([0.25, 0.3]), np.array([0.4, 0.1, 0.2, 0.35])
TENSION = np.array([3.0, 5.0, 7.0, 9.0])


def test_one_pulling_cable_pulls_the_platform_towards_its_base() -> None:
    structure = structure_matrix(STOCK, POSE, [0.25, 0.3, 0.25, 0.3])
    for cable, direction in enumerate([(0, -1), (1, 0), (0, 1), (-1, 0)]):
        tension = np.zeros(4)
        tension[cable] = 5
        assert np.allclose(wrench(STOCK, structure, tension), 5 * np.array(direction), atol=9 * EPS)


def test_what_the_cables_lose_in_length_moves_platform_and_bases() -> None:
    """Virtual work (Yoon eq. 8): -T . dl = W . dc + F_rail . ds."""
    rng = np.random.default_rng(0)
    pose, rails = POSE.astype(np.longdouble), RAILS.astype(np.longdouble)
    force = wrench(STOCK, structure_matrix(STOCK, POSE, RAILS), TENSION)
    on_rails = rail_forces(STOCK, POSE, RAILS, TENSION)
    for _ in range(20):
        by_pose, by_rails = 1e-7 * rng.normal(size=2), 1e-7 * rng.normal(size=4)
        ahead = cable_lengths(STOCK, pose + by_pose, rails + by_rails)
        behind = cable_lengths(STOCK, pose - by_pose, rails - by_rails)
        work = -np.sum(TENSION * (ahead - behind)) / 2
        assert np.isclose(float(work), force @ by_pose + on_rails @ by_rails, rtol=0, atol=1e-16)


def test_a_base_is_pulled_along_its_rail_towards_the_platform() -> None:
    on_rails = rail_forces(STOCK, POSE, RAILS, TENSION)
    towards = np.array([0.25, 0.3, 0.25, 0.3]) - RAILS
    assert np.array_equal(np.sign(on_rails), np.sign(towards))


def test_statics_keep_long_double_and_batch_axes() -> None:
    structure = structure_matrix(STOCK, POSE.astype(np.longdouble), RAILS)
    force = wrench(STOCK, structure, np.ones((6, 5, 4)))
    assert force.dtype == np.longdouble and force.shape == (6, 5, 2)
    assert rail_forces(STOCK, POSE, RAILS, np.ones((6, 5, 4))).shape == (6, 5, 4)
