"""Fig. 5 of Yoon et al., drawn from the generated C: its circles fit into what is drawn around."""

from pathlib import Path

import numpy as np
import pytest

from turnbuckle.lab.figures.force_diagram import Diagram, Reals
from turnbuckle.model.reading import load_machine

MACHINES = Path(__file__).parents[2] / "machines"


def nearest_side(corners: Reals) -> float:
    """Distance from the origin to the nearest side of a polygon around it, counter-clockwise."""
    sides = np.roll(corners, -1, axis=0) - corners
    moments = corners[:, 0] * sides[:, 1] - corners[:, 1] * sides[:, 0]
    return float(np.min(moments / np.hypot(*sides.T)))


@pytest.mark.parametrize("name", ["yoon_fixed_diagonal", "yoon2023"])
def test_the_exact_circle_touches_the_polygon_of_all_forces(name: str) -> None:
    diagram = Diagram(load_machine(MACHINES / f"{name}.toml"))
    assert nearest_side(diagram.polygon) == pytest.approx(diagram.exact, rel=1e-9)


@pytest.mark.parametrize("name", ["yoon_fixed_diagonal", "yoon2023"])
def test_the_circle_of_eq_17_touches_a_parallelogram_from_within(name: str) -> None:
    diagram = Diagram(load_machine(MACHINES / f"{name}.toml"))
    reach = []
    for _, a, across, b in diagram.parallelograms():
        height = float(a[0] * b[1] - a[1] * b[0]) / np.array([np.hypot(*b), np.hypot(*a)])
        is_wide = a @ b < -1e-9 * np.hypot(*a) * np.hypot(*b)
        reach.append(min(height) if is_wide else min(np.hypot(*a), np.hypot(*b)))
        np.testing.assert_allclose(across, a + b)
    assert min(reach) == pytest.approx(diagram.eq17, rel=1e-9)
    assert diagram.eq17 <= diagram.exact * (1 + 1e-9)
