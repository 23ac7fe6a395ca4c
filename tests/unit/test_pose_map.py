"""A map holds, pose by pose, what pose_quality says; a tally is what the whole map amounts to."""

import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from turnbuckle.codegen.bind import Generated, generate_into_cache
from turnbuckle.codegen.map_tally import tally
from turnbuckle.codegen.pose_map import SHIM, Grid, PoseMap, Reals, target_grid
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine
from turnbuckle.model.refusal import Refusal
from turnbuckle.model.symbolic.function import Status

MACHINES = Path(__file__).parents[1] / "machines"
STOCK = Path(__file__).parents[2] / "machines"
Bases = dict[str, tuple[float, ...]]
BASES: dict[str, Bases] = {
    "following": {},
    "lagging": {"lag": (0.03, -0.02)},
    "staying": {"rails": (0.2, 0.3, 0.5, 0.1)},
}
#: A grid over the whole frame, at whose corners there are pulleys.
FRAME_ROWS, FRAME_COLUMNS = 24, 37


@pytest.fixture(scope="module")
def pose_map(double: Generated) -> PoseMap:
    return PoseMap(double)


@pytest.fixture(scope="module")
def fixed() -> Generated:
    machine = load_machine(MACHINES / "fixed_diagonal.toml")
    return Generated(machine, generate_into_cache(machine), "double")


def frame_grid(machine: Machine) -> Grid:
    """The whole frame, its corners included."""
    width, height = machine.frame.size
    return Grid(
        (0.0, 0.0),
        (width / (FRAME_COLUMNS - 1), 0.0),
        (0.0, height / (FRAME_ROWS - 1)),
        FRAME_COLUMNS,
        FRAME_ROWS,
    )


def whole(
    pose_map: PoseMap, grid: Grid, tile_rows: int | None, bases: Bases
) -> tuple[Reals, Reals]:
    """Margin and factor of all rows, each of which comes once."""
    tiles = list(pose_map.tiles(grid, tile_rows, **bases))
    rows = [row for tile in tiles for row in tile.rows]
    assert rows == list(range(grid.rows))
    return np.concatenate([t.margin for t in tiles]), np.concatenate([t.factor for t in tiles])


@pytest.mark.parametrize("bases", BASES)
@pytest.mark.parametrize("precision", ["double", "single"])
def test_a_map_is_what_pose_quality_says_to_the_bit(
    precision: str, bases: str, request: pytest.FixtureRequest
) -> None:
    generated: Generated = request.getfixturevalue(precision)
    grid, given = frame_grid(generated.machine), BASES[bases]
    margin, factor = whole(PoseMap(generated), grid, 5, given)
    poses = grid.poses(range(grid.rows))
    follow = generated.base_targets(poses - np.asarray(given.get("lag", (0.0, 0.0))))
    answer = generated.pose_quality(poses, given.get("rails", follow))
    known = answer.status <= Status.INFEASIBLE
    assert 0 < np.sum(~known) < grid.count / 4 or bases == "staying"
    assert np.array_equal(margin, np.where(known, answer.margin, np.nan), equal_nan=True)
    assert np.array_equal(factor, np.where(known, answer.factor, np.nan), equal_nan=True)


@pytest.mark.parametrize("name", ["brau_tetrahedron", "planar_rigid", "spidar_g"])
def test_a_machine_whose_c_has_no_pose_quality_is_refused_by_its_kind(name: str) -> None:
    machine = load_machine(STOCK / f"{name}.toml")
    generated = Generated(machine, generate_into_cache(machine), "double")
    with pytest.raises(Refusal) as refusal:
        PoseMap(generated)
    assert str(refusal.value) == (
        f"{machine.path}: machine.kind: found {machine.kind};"
        " allowed: planar-point, for a map of pose quality"
    )


def test_the_height_of_tiles_changes_nothing(pose_map: PoseMap) -> None:
    grid = frame_grid(pose_map.machine)
    wanted = whole(pose_map, grid, None, {})
    for tile_rows in (1, 7, 1000):
        for a, b in zip(whole(pose_map, grid, tile_rows, {}), wanted, strict=True):
            assert np.array_equal(a, b, equal_nan=True)


def test_a_machine_without_rails_has_a_map(fixed: Generated) -> None:
    grid = frame_grid(fixed.machine)
    margin, _ = whole(PoseMap(fixed), grid, None, {})
    answer = fixed.pose_quality(grid.poses(range(grid.rows)))
    known = answer.status <= Status.INFEASIBLE
    assert np.array_equal(margin[known], answer.margin[known])
    assert np.all(np.isnan(margin[~known])) and np.isnan(margin[0, 0])


def test_rows_may_lie_in_any_direction(pose_map: PoseMap) -> None:
    stays: Bases = {"rails": (0.3, 0.2, 0.3, 0.2)}
    grid = Grid((0.3, 0.2), (0.001, 0.002), (-0.002, 0.001), 30, 20)
    pose = grid.poses(range(20))[3, 5]
    assert np.allclose(pose, [0.3 + 5 * 0.001 - 3 * 0.002, 0.2 + 5 * 0.002 + 3 * 0.001])
    alone = Grid((pose[0], pose[1]), (0.0, 0.0), (0.0, 0.0), 1, 1)
    many, one = (whole(pose_map, each, None, stays)[0] for each in (grid, alone))
    assert one[0, 0] == many[3, 5]


def test_a_target_grid_ends_on_the_borders_of_the_target(stock: Machine) -> None:
    poses = target_grid(stock, 11, 5).poses(range(5))
    centre, size = np.array(stock.target.centre), np.array(stock.target.size)
    assert np.allclose(poses[0, 0], centre - size / 2) and np.allclose(
        poses[-1, -1], centre + size / 2
    )
    assert target_grid(stock, 1, 1).count == 1


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"rails": (0.1, 0.2)}, r"rails: found shape \(2,\); it takes \(4,\)"),
        ({"lag": (0.1,)}, r"lag: found shape \(1,\); it takes \(2,\)"),
        ({"rails": (0.1,) * 4, "lag": (0.0, 0.0)}, "bases that stay have no lag"),
        ({"tile_rows": 0}, "tile_rows: found 0"),
    ],
)
def test_arguments_that_do_not_fit_are_refused(
    arguments: dict[str, Any], message: str, pose_map: PoseMap
) -> None:
    with pytest.raises(ValueError, match=message):
        next(pose_map.tiles(target_grid(pose_map.machine, 3, 3), **arguments))


def test_a_grid_of_another_dimension_or_of_nothing_is_refused(pose_map: PoseMap) -> None:
    with pytest.raises(ValueError, match=r"origin: found shape \(3,\)"):
        next(pose_map.tiles(Grid((0.0,) * 3, (0.0,) * 3, (0.0,) * 3, 2, 2)))
    with pytest.raises(ValueError, match="found 0 x 2 poses"):
        Grid((0.0, 0.0), (0.0, 0.0), (0.0, 0.0), 0, 2)


def test_a_tally_is_what_the_whole_map_amounts_to(fixed: Generated) -> None:
    grid = frame_grid(fixed.machine)
    drawn = PoseMap(fixed)
    margin, factor = whole(drawn, grid, None, {})
    force = 2.0
    total = tally(fixed.machine, drawn.tiles(grid, 3), force)
    known = margin[np.isfinite(margin)]
    assert (total.poses, total.refused) == (grid.count, grid.count - known.size)
    assert 0 < total.refused < total.poses
    assert total.feasible == np.sum(known >= 0) > total.covered == np.sum(known >= force) > 0
    assert total.coverage == np.sum(known >= force) / grid.count
    assert total.mean_force == pytest.approx(np.mean(np.maximum(known, 0)), rel=1e-13)
    assert total.mean_factor == pytest.approx(np.mean(factor[margin >= 0]), rel=1e-13)
    assert total.least_margin == np.min(known)
    assert total.worst is not None and margin[total.worst] == np.min(known)
    edges = total.histogram.edges
    assert np.array_equal(total.histogram.counts, np.histogram(known, edges)[0])


def test_a_tally_of_refused_poses_alone_says_nothing(fixed: Generated) -> None:
    corner = Grid((0.0, 0.0), (0.0, 0.0), (0.0, 0.0), 4, 4)
    total = tally(fixed.machine, PoseMap(fixed).tiles(corner))
    assert (total.poses, total.refused, total.coverage, total.worst) == (16, 16, 0.0, None)
    assert np.isnan(total.mean_force) and np.isnan(total.mean_factor)


@pytest.mark.parametrize("compiler", ["gcc", "clang"])
@pytest.mark.parametrize("precision", ["-UTB_REAL_FLOAT", "-DTB_REAL_FLOAT"])
def test_the_loop_compiles_without_a_warning(
    compiler: str, precision: str, fixed: Generated, stock_folder: Path
) -> None:
    warnings = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wdouble-promotion", "-Werror"]
    for folder in (fixed.folder, stock_folder):
        command = [compiler, "-std=c11", *warnings, precision, f"-I{folder}", "-fsyntax-only"]
        subprocess.run([*command, str(SHIM)], check=True)
