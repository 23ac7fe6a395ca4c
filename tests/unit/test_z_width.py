"""Table I of Yoon et al.: its dB do not follow from its own stiffness, damping and mass."""

import numpy as np
import pytest

from turnbuckle.lab.figures.z_width import STATED, TABLE, rendered_stiffness, z_width
from turnbuckle.model.machine import Machine, Wall


def wall_of(machine: Machine, name: str) -> Wall:
    return next(wall for wall in machine.walls if wall.name == name)


@pytest.mark.parametrize(("name", "wanted"), [("x", (51.86, 31.25)), ("y", (52.48, 33.83))])
def test_the_tables_own_numbers_give_another_z_width(
    stock: Machine, name: str, wanted: tuple[float, float]
) -> None:
    free = TABLE[name]
    found = z_width(wall_of(stock, free.wall), free)
    assert np.round(found, 2).tolist() == list(wanted)
    excess = found - np.array(free.z_width)
    assert np.all((excess > 2) & (excess < 4.1))


@pytest.mark.parametrize("name", TABLE)
def test_a_wall_of_the_rendered_stiffness_has_the_printed_z_width(
    stock: Machine, name: str
) -> None:
    free = TABLE[name]
    wall = wall_of(stock, free.wall)
    softer = rendered_stiffness(wall, free)
    for k in range(len(STATED)):
        found = z_width(wall.model_copy(update={"stiffness": softer[k]}), free)
        assert found[k] == pytest.approx(free.z_width[k], abs=1e-9)
