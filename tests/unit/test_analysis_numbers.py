"""The numbers of a target, against the papers, closed forms and what they must agree on."""

import math
from itertools import product
from pathlib import Path

import numpy as np
import pytest

from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine
from turnbuckle.model.reference.control import base_targets
from turnbuckle.model.workspace.extent import least_margin, tension_capable, theoretical_share
from turnbuckle.model.workspace.feasible import ball_margin
from turnbuckle.model.workspace.quality import pose_quality, possible_share, wanted_margin
from turnbuckle.model.workspace.structures import structures, target_demand
from turnbuckle.model.workspace.summary import (
    COARSE_FACETS,
    TargetSummary,
    coarse_grid,
    coverage,
    fine_grid,
    summarise_lag,
    summarise_target,
)

ROOT = Path(__file__).parents[2]
STOCK = sorted((ROOT / "machines").glob("*.toml"))
EPS = float(np.finfo(float).eps)
LAG = 0.02


def stock(name: str) -> Machine:
    """A machine of the repository."""
    return load_machine(ROOT / "machines" / f"{name}.toml")


def edited(folder: Path, name: str, *changes: tuple[str, str]) -> Machine:
    """A machine of the repository with some of its text changed."""
    text = (ROOT / "machines" / f"{name}.toml").read_text()
    for before, after in changes:
        assert before in text
        text = text.replace(before, after)
    path = folder / f"{name}.toml"
    path.write_text(text)
    return load_machine(path)


def summary(machine: Machine) -> TargetSummary:
    """The target on the grid of the report."""
    return summarise_target(machine, fine_grid(machine), LAG)


def nearly(value: float, roundings: int = 64) -> object:
    """Equal but for rounding."""
    return pytest.approx(value, rel=roundings * EPS)


def test_the_published_force_at_the_centre_of_the_diagonal_rig() -> None:
    machine = stock("yoon_fixed_diagonal")
    assert float(pose_quality(machine, (0.253, 0.142)).force) == nearly(5.975360269920283)


@pytest.mark.parametrize(
    ("name", "held"), [("yoon_fixed_diagonal", 3425), ("yoon_fixed_orthogonal", 1605)]
)
def test_the_published_share_of_the_screen_that_is_held(name: str, held: int) -> None:
    found = summary(stock(name))
    assert found.coverage.counts == (101, 57)
    assert found.zero_share == held / (101 * 57)
    assert not found.passed


@pytest.mark.parametrize(
    ("name", "force"),
    [
        ("yoon2023", 7.0),
        ("yoon_synchronised", 7.0),
        ("three_base_equilateral", 7 * math.sqrt(3) / 2),
    ],
)
def test_movable_bases_give_the_published_force_everywhere(name: str, force: float) -> None:
    found = summary(stock(name))
    assert (found.least_force, found.mean_force) == (nearly(force), nearly(force))
    assert found.least_tension_factor == nearly(1.0)
    assert found.passed


def test_the_motor_of_the_movable_rig_is_just_strong_enough() -> None:
    found = summary(stock("yoon2023")).actuators
    assert (found.tension, found.torque) == (nearly(10.0), nearly(0.05))


def test_a_motor_that_is_just_strong_enough_is_enough(tmp_path: Path) -> None:
    tension = ('max = "10 N"', 'max = "6.25 N"')
    torque = ('torque_limit = "55 mN*m"', 'torque_limit = "31.25 mN*m"')
    assert summary(edited(tmp_path, "brau_square", tension, torque)).passed


def test_the_tension_capable_share_of_the_square() -> None:
    region = tension_capable(stock("brau_square"))
    assert region is not None
    assert region.share == nearly(1 - 2 * (math.pi / 3 - math.sqrt(3) / 2))


def test_the_share_of_the_square_by_poses_is_near_that_by_area() -> None:
    machine = stock("brau_square")
    middles = (np.arange(400) + 0.5) / 400
    poses = np.stack(np.meshgrid(middles, middles), axis=-1)
    share = float(np.mean(wanted_margin(machine, poses) >= 0))
    region = tension_capable(machine)
    assert region is not None
    # a cell on the border counts whole or not at all: the border is shorter than four diameters
    assert abs(share - region.share) < 8 / 400


def test_no_machine_with_a_least_tension_has_a_boundary_in_closed_form() -> None:
    for name in ("yoon_fixed_diagonal", "yoon2023", "brau_five", "brau_tetrahedron"):
        assert tension_capable(stock(name)) is None


def test_an_empty_tension_capable_workspace_says_so(tmp_path: Path) -> None:
    machine = edited(tmp_path, "brau_triangle", ('force = "10 N"', 'force = "19 N"'))
    region = tension_capable(machine)
    assert region is not None
    assert "is empty" in str(region)
    assert summary(machine).coverage.share == 0


def test_a_little_more_force_than_there_is_is_noticed(tmp_path: Path) -> None:
    machine = edited(tmp_path, "yoon2023", ('force = "7 N"', 'force = "7.000001 N"'))
    found = coverage(machine, coarse_grid(machine))
    assert found.share == 0
    assert found.possible == nearly(7 / 7.000001)


def test_late_bases_cost_force() -> None:
    machine = stock("yoon2023")
    grid = fine_grid(machine)
    late, very_late, in_time = (summarise_lag(machine, grid, lag) for lag in (LAG, 2 * LAG, 0.0))
    assert very_late.least_force < late.least_force < 7
    assert (late.share, in_time.share) == (0, 1)
    assert in_time.least_force == nearly(7.0)


def test_fixed_bases_are_never_late() -> None:
    assert summary(stock("brau_square")).lagging is None


def test_the_tension_factor_is_not_defined_without_a_least_tension() -> None:
    assert math.isnan(summary(stock("brau_square")).least_tension_factor)


@pytest.mark.parametrize("name", ["planar_rigid", "spidar_g", "yoon_fixed_diagonal"])
def test_what_is_possible_is_on_the_border_of_the_feasible(name: str) -> None:
    machine = stock(name)
    poses = coarse_grid(machine).poses()[::97]
    share = possible_share(machine, poses)
    share = np.where(np.isnan(share), 0, share)
    demand = target_demand(machine)
    lower, upper = machine.tension.min, machine.tension.max
    matrices = structures(machine, poses, base_targets(machine, poses))
    for s, k in zip(matrices[share > 0], share[share > 0], strict=True):
        margin = ball_margin(s, lower, upper, k * demand.force, k * demand.moment, demand.space)
        assert abs(float(margin)) < 1e4 * EPS * upper


def test_the_worst_pose_is_the_worst_of_all_rotations() -> None:
    machine = stock("planar_rigid")
    found = coverage(machine, coarse_grid(machine))
    corners = [
        (x, y, turn) for x, y, turn in product((0.1029, 0.6089), (0.0889, 0.3729), (-1, 0, 1))
    ]
    limit = machine.target.rotation
    margins = [float(wanted_margin(machine, (x, y, turn * limit))) for x, y, turn in corners]
    assert float(wanted_margin(machine, found.worst)) <= min(margins) + 1e-9
    centre = np.array([machine.target.centre])
    turned = [float(wanted_margin(machine, (*centre[0], turn * limit))) for turn in (-1, 0, 1)]
    assert float(least_margin(machine, centre)[0]) <= min(turned)


def test_the_worst_pose_is_one_that_is_not_on_a_pulley() -> None:
    machine = stock("yoon_fixed_diagonal")
    found = coverage(machine, coarse_grid(machine))
    assert found.undefined == 4
    assert np.isfinite(wanted_margin(machine, found.worst))


@pytest.mark.parametrize("path", STOCK, ids=lambda path: path.stem)
def test_the_coarse_grid_has_the_corners_and_the_middle_and_is_small(path: Path) -> None:
    machine = load_machine(path)
    grid = coarse_grid(machine)
    facets = math.comb(len(machine.cables), machine.dof - 1)
    assert grid.size * facets <= COARSE_FACETS
    ends = zip(machine.target.centre, machine.target.size, strict=True)
    for axis, (centre, size) in zip(grid.axes, ends, strict=False):
        assert (axis[0], axis[-1]) == (centre - size / 2, centre + size / 2)
        assert axis[len(axis) // 2] == nearly(centre)


def test_the_coarse_verdict_is_the_fine_one_for_every_stock_machine() -> None:
    for path in STOCK:
        machine = load_machine(path)
        if machine.kind != "spatial-rigid":  # whose fine grid takes long
            assert coverage(machine, coarse_grid(machine)).complete == summary(machine).passed


def test_the_theoretical_workspace_is_the_polygon_of_the_pulleys() -> None:
    assert theoretical_share(stock("brau_square")) == 1
    # the triangle is half of its frame; a cell on its border counts whole or not at all
    assert abs(theoretical_share(stock("brau_triangle")) - 0.5) < 0.01
