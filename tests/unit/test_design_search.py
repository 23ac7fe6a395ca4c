"""Searches whose best machine is known: the orthogonal rig, and the motor it needs."""

import itertools
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from turnbuckle.lab.design import DesignError
from turnbuckle.lab.design.design import Design
from turnbuckle.lab.design.improve import Improvement, NoImprovement, improvement
from turnbuckle.lab.design.search import TRUST, Trials, merit, polish, search, slopes
from turnbuckle.lab.design.target import isotropic_force, needed_tension, target_poses
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine
from turnbuckle.model.reference import quality
from turnbuckle.model.reference.control import base_targets
from turnbuckle.model.workspace.maximin import climb

ROOT = Path(__file__).parents[2]
STOCK = ROOT / "machines" / "yoon2023.toml"
DIAGONAL = ROOT / "tests" / "machines" / "fixed_diagonal.toml"
MIRRORED = [
    "cable[1].base[1],cable[4].base[1]=0 mm..250 mm",
    "cable[2].base[1],cable[3].base[1]=256 mm..506 mm",
]
SHORT_RAILS = [
    f"cable[{i}].rail.{end}[1]={bounds}"
    for i, (end, bounds) in itertools.product(
        (1, 3), [("from", "0 mm..300 mm"), ("to", "400 mm..711.8 mm")]
    )
]


def edited(source: Path, folder: Path, *edits: tuple[str, str]) -> Path:
    """A copy of a machine file with text replaced."""
    text = source.read_text()
    for old, new in edits:
        assert old in text
        text = text.replace(old, new)
    path = folder / "machine.toml"
    path.write_text(text)
    return path


@pytest.fixture
def short_rails(tmp_path: Path) -> Path:
    """The stock machine with rails that end inside the target."""
    return edited(
        STOCK,
        tmp_path,
        (
            'from = ["0 mm", "0 mm"], to = ["711.8 mm", "0 mm"]',
            'from = ["250 mm", "0 mm"], to = ["450 mm", "0 mm"]',
        ),
        ('from = ["0 mm", "461.8 mm"]', 'from = ["300 mm", "461.8 mm"]'),
    )


@pytest.fixture
def one_point(tmp_path: Path) -> Path:
    """Bases at the corners, and a target that is next to nothing."""
    return edited(DIAGONAL, tmp_path, ('size = ["200 mm", "120 mm"]', 'size = ["1 um", "1 um"]'))


def silent(what: str, share: float) -> None:
    """Tell nobody."""


def found(
    path: Path,
    vary: list[str],
    goal: str = "isotropic_force",
    method: str = "global",
    seed: int = 0,
) -> Improvement:
    """The better machine."""
    design = Design.read(path, vary, goal)
    return improvement(design, search(design, method, seed, silent).best)


def read_back(better: Improvement, folder: Path) -> Machine:
    """The machine of the new file."""
    path = folder / "new.toml"
    path.write_text(better.text)
    return load_machine(path)


def least_force(machine: Machine) -> float:
    """Least I_F in the target, by the reference alone."""
    poses = target_poses(machine)
    return float(quality.isotropic_force(machine, poses, base_targets(machine, poses)).min())


def test_the_poses_span_the_target_with_its_border() -> None:
    machine = load_machine(STOCK)
    poses = target_poses(machine)
    assert poses.min(axis=0) == pytest.approx([0.1029, 0.0889], rel=1e-12)
    assert poses.max(axis=0) == pytest.approx([0.6089, 0.3729], rel=1e-12)
    assert len(np.unique(poses, axis=0)) == len(poses)


@pytest.mark.parametrize("path", [STOCK, *sorted((ROOT / "tests" / "machines").glob("*.toml"))])
def test_the_force_over_the_target_is_the_reference_s(path: Path) -> None:
    machine = load_machine(path)
    poses = target_poses(machine)
    force = quality.isotropic_force(machine, poses, base_targets(machine, poses))
    assert np.maximum(isotropic_force(machine), 0) == pytest.approx(
        np.nan_to_num(force), rel=1e-12, abs=1e-12
    )


def test_the_needed_tension_gives_just_the_wanted_force_at_every_pose() -> None:
    machine = load_machine(DIAGONAL)
    poses = target_poses(machine)
    rails = base_targets(machine, poses)
    for k, needed in enumerate(needed_tension(machine)):
        bounds = machine.tension.model_copy(update={"max": needed})
        other = machine.model_copy(update={"tension": bounds})
        force = quality.isotropic_force(other, poses[k], rails[k])
        assert float(force) == pytest.approx(machine.target.force, rel=1e-10)


def test_rails_are_drawn_out_until_they_are_orthogonal_everywhere(
    short_rails: Path, tmp_path: Path
) -> None:
    better = found(short_rails, SHORT_RAILS, method="local")
    assert better.before.figures[0] < 5
    assert least_force(read_back(better, tmp_path)) == pytest.approx(7, rel=1e-12)


@pytest.mark.parametrize("method", ["local", "global"])
def test_fixed_bases_move_to_where_their_cables_are_orthogonal(
    one_point: Path, tmp_path: Path, method: str
) -> None:
    better = found(one_point, MIRRORED, method=method)
    machine = read_back(better, tmp_path)
    # Bases on the upper and lower sides: cables are orthogonal at 142 mm from the middle.
    offsets = [abs(motion.start[0] - 0.253) for motion in machine.base_motions]
    assert offsets == pytest.approx([0.142] * 4, rel=1e-4)
    assert least_force(machine) == pytest.approx(7, rel=1e-4)
    assert least_force(machine) <= 7


def test_linear_models_of_all_poses_get_past_the_kinks_that_stop_a_simplex() -> None:
    vary = [f"cable[{i}].base[1]=0 mm..506 mm" for i in range(1, 5)]
    design = Design.read(DIAGONAL, vary, "isotropic_force")
    climbed, alone = Trials(design), Trials(design)
    corners = np.array([0.0, 1.0, 1.0, 0.0])
    place, _ = climb(climbed.merits, partial(slopes, climbed), corners, TRUST, 0.0, 1.0)
    climbed.merit(place)
    alone.merit(corners)
    polish(alone)
    assert merit(climbed.best) == pytest.approx(3.421991554742478, rel=1e-6)
    assert merit(alone.best) < 3


def test_the_orthogonal_rig_needs_the_wanted_force_and_t_min(
    short_rails: Path, tmp_path: Path
) -> None:
    better = found(short_rails, SHORT_RAILS, goal="motor", method="local")
    machine = read_back(better, tmp_path)
    assert machine.tension.max == 7 + 3
    assert machine.cable_motor.torque_limit == pytest.approx(0.055, rel=1e-12)
    assert least_force(machine) == pytest.approx(7, rel=1e-12)


def test_the_smaller_motor_is_enough_and_no_larger_than_it_has_to_be(tmp_path: Path) -> None:
    better = found(DIAGONAL, MIRRORED, goal="motor")
    machine = read_back(better, tmp_path)
    assert machine.tension.max < 8.3 < 10
    assert least_force(machine) >= machine.target.force * (1 - 1e-12)
    assert least_force(machine) == pytest.approx(machine.target.force, rel=1e-5)
    ratio = machine.cable_motor.torque_limit / (machine.tension.max * machine.drum.radius)
    assert ratio == pytest.approx(55 / 50, rel=1e-5)


def test_bounds_of_the_largest_tension_are_kept_by_the_goal_motor(tmp_path: Path) -> None:
    bounds = "tension.max=9 N..12 N"
    better = found(DIAGONAL, [bounds, "drum.radius=3 mm..5 mm"], goal="motor")
    machine = read_back(better, tmp_path)
    assert machine.tension.max == pytest.approx(9.56533, rel=1e-5)
    assert machine.drum.radius == 0.003
    with pytest.raises(NoImprovement, match="the wanted force is to be had in"):
        found(DIAGONAL, ["tension.max=4 N..9 N"], goal="motor")


@pytest.mark.parametrize(
    "vary", ["tension.max=4 N..9 N:3", "cable_motor.torque_limit=1 N*m..2 N*m"]
)
def test_what_the_goal_motor_sets_cannot_vary(vary: str) -> None:
    with pytest.raises(DesignError, match=r"only tension\.max=LOW\.\.HIGH"):
        Design.read(DIAGONAL, [vary], "motor")


def test_no_motor_is_large_enough_where_nothing_pulls_to_one_side() -> None:
    with pytest.raises(NoImprovement, match="the wanted force is to be had in 0% of the target"):
        found(DIAGONAL, ["cable[2].base[1],cable[3].base[1]=60 mm..100 mm"], goal="motor")


def test_a_file_whose_motors_are_too_weak_gets_stronger_ones(tmp_path: Path) -> None:
    weak = edited(DIAGONAL, tmp_path, ('force = "2 N"', 'force = "4 N"'))
    better = found(weak, MIRRORED, goal="motor", method="local")
    assert not better.before.attained and better.before.figures[:2] == (0.05, 10.0)
    machine = read_back(better, tmp_path)
    assert machine.tension.max > 10
    assert least_force(machine) == pytest.approx(4, rel=1e-5)


def test_the_same_seed_gives_the_same_bytes() -> None:
    first, second = (found(DIAGONAL, MIRRORED, seed=3).text for _ in range(2))
    assert first == second


def test_machines_that_cannot_be_are_no_obstacle(tmp_path: Path) -> None:
    # T_min up to 12 N: most of the range lies above T_max.
    better = found(DIAGONAL, ["tension.min=1 N..12 N"])
    assert read_back(better, tmp_path).tension.min == 1


def test_a_machine_that_is_the_best_already_is_told() -> None:
    with pytest.raises(NoImprovement, match=r"better than the file's own, least isotropic force"):
        found(STOCK, ["cable[1].rail.from[1]=0 mm..90 mm"], method="local")


def test_a_target_that_no_pose_covers_is_told() -> None:
    # All bases on the left of the target: nothing pulls to the right.
    vary = ["cable[2].base[1],cable[3].base[1]=60 mm..100 mm"]
    with pytest.raises(NoImprovement, match=r"hold the platform in 0% of the target"):
        found(DIAGONAL, vary)


def test_ranges_without_any_machine_are_told_with_a_reason() -> None:
    with pytest.raises(DesignError, match=r"none of the \d+ machines .* can be: tension.min"):
        found(DIAGONAL, ["tension.min=20 N..30 N"])


def test_a_target_that_is_not_covered_yet_comes_to_be(tmp_path: Path) -> None:
    path = edited(
        DIAGONAL,
        tmp_path,
        ('base = ["506 mm", "0 mm"]', 'base = ["350 mm", "0 mm"]'),
        ('base = ["506 mm", "284 mm"]', 'base = ["350 mm", "284 mm"]'),
    )
    better = found(path, ["cable[2].base[1],cable[3].base[1]=60 mm..506 mm"], method="local")
    assert better.before.figures[0] == 0 and better.before.figures[2] < 1
    assert better.after.figures[0] > 2.79 and better.after.figures[2] == 1
