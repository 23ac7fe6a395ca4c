"""The demo as a user runs it: any machine, numbers, a picture, and clear words when it cannot."""

import io
import shutil
import struct
import subprocess
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import variants
from rich.console import Console

from turnbuckle.codegen.bind import Generated, load
from turnbuckle.codegen.controller import RUNTIME_CORE, STEP, Controller
from turnbuckle.lab.bench import run_task
from turnbuckle.lab.demo import DemoResult, plan_task, plant_of, run_demo, summary_table
from turnbuckle.lab.hand import Path as Way
from turnbuckle.lab.plots import draw
from turnbuckle.lab.summary import summarise
from turnbuckle.lab.task import TENSIONING, TURN, Phase, Task
from turnbuckle.model.problem import MachineError
from turnbuckle.model.reading import load_machine


def demo(tables: dict[str, Any], folder: Path) -> DemoResult:
    """Run the demo of a machine file with these tables."""
    return run_demo(variants.write(tables, folder), folder / "pictures")


def png_size(path: Path) -> tuple[int, int]:
    """Width and height of a PNG file [pixels]."""
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    width, height = struct.unpack(">II", data[16:24])
    return width, height


def as_text(result: DemoResult) -> str:
    """The table as a terminal shows it."""
    console = Console(width=120, file=io.StringIO(), record=True)
    console.print(summary_table(result))
    return console.export_text()


@pytest.fixture(scope="module")
def stock(tmp_path_factory: pytest.TempPathFactory) -> tuple[DemoResult, list[str]]:
    """The demo of the stock machine, and the stages it went through."""
    stages: list[str] = []
    result = run_demo(
        variants.STOCK,
        tmp_path_factory.mktemp("demo"),
        lambda stage, share: stages.append(stage) if 0.0 <= share <= 1.0 else None,
    )
    return result, list(dict.fromkeys(stages))


def test_the_demo_leaves_a_picture_and_tells_how_far_it_is(
    stock: tuple[DemoResult, list[str]],
) -> None:
    result, stages = stock
    assert png_size(result.picture) == (1600, 1000)
    assert result.picture.stat().st_size > 50_000
    assert stages == [
        "generating the controller",
        "running the machine",
        "without compensation",
        "drawing",
    ]


def test_the_table_shows_what_the_observer_is_good_for(
    stock: tuple[DemoResult, list[str]],
) -> None:
    text = as_text(stock[0])
    for words in ("yoon2023 in closed loop", "with observer", "without", "lowest tension", "µs"):
        assert words in text
    assert "nan" not in text.lower()


@pytest.mark.parametrize(
    ("name", "bases"), [("corners", variants.CORNERS), ("triangle", variants.TRIANGLE)]
)
def test_a_machine_of_fixed_bases_runs_where_its_cables_can_hold_it(
    name: str, bases: list[tuple[str, str]], tmp_path: Path
) -> None:
    result = demo(variants.fixed(name, bases), tmp_path)
    assert result.summary.failed == 0 and result.uncompensated is None
    assert result.summary.lowest_tension > 0.0
    assert result.summary.wall_error is None and result.summary.base_lag is None
    assert png_size(result.picture) == (1600, 1000)
    text = as_text(result)
    assert "of the target about its centre" in text
    assert "wall" not in text and "base" not in text and "observer" not in text


STOCK = sorted((variants.ROOT / "machines").glob("*.toml"))


@pytest.mark.parametrize("path", STOCK, ids=lambda path: path.stem)
def test_every_stock_machine_has_a_plant_but_those_of_a_paper_without_hardware(path: Path) -> None:
    machine = load_machine(path)
    if not path.stem.startswith("brau"):
        assert plant_of(machine) is machine.plant
        return
    with pytest.raises(MachineError, match=r"plant: found nothing; allowed: a table \[plant\]"):
        plant_of(machine)


def shortened(task: Task, turns: int) -> Task:
    """A task like it that lasts two seconds: a way through the target, then a moment."""
    start, corner = task.path.at(0.0)[0], task.path.at(2.5)[0]
    path = Way(start, rest=TENSIONING)
    for target in ((*corner[:3], 0.1, -0.1, 0.05), start):
        path.move(target, 0.6)
    tour = Phase("tour", TENSIONING, path.end)
    begin = path.end - TURN * turns  # so that the last turn begins where the tour ends
    path.rest(0.5)
    return replace(task, path=path, phases=(tour, Phase("turn", begin, begin + TURN * (turns + 1))))


def test_a_platform_that_turns_in_space_feels_the_moment_that_is_wanted(tmp_path: Path) -> None:
    machine = load_machine(variants.ROOT / "machines" / "spidar_g.toml")
    generated = Generated(machine, variants.ROOT / "generated" / "spidar_g", "double")
    whole = plan_task(generated)
    assert whole.phase("turn").end - whole.phase("turn").begin == pytest.approx(6 * TURN)
    task = shortened(whole, 3)
    found = run_task(machine, plant_of(machine), Controller(generated), task)
    summary = summarise(machine, found)
    assert (summary.failed, summary.infeasible, summary.slack) == (0, 0, 0)
    assert summary.rotation_error is not None and summary.rotation_error < 1e-9
    assert summary.tour_turn is not None and 1e-3 < summary.tour_turn < 0.05
    assert np.ptp(found.position[:, 3]) > 0.08
    last = found.time > task.path.end - 0.1
    wanted, felt = found.outputs.wanted_force[last, 3], found.cable_force[last, 3]
    assert wanted.mean() == pytest.approx(task.turning_moment, rel=0.05)
    assert felt.mean() == pytest.approx(wanted.mean(), rel=0.35)
    assert np.abs(found.cable_force[last][:, 4:]).max() < 0.3 * wanted.mean()
    picture = tmp_path / "picture.png"
    shown = replace(task, phases=(task.phase("tour"), Phase("turn", 0.0, 6 * TURN)))
    draw(machine, replace(found, task=shown), picture)
    assert png_size(picture) == (1600, 1000)


def test_fixed_bases_and_walls_and_an_observer_go_together(tmp_path: Path) -> None:
    tables = variants.fixed("walled", variants.CORNERS)
    tables |= {key: variants.stock()[key] for key in ("wall", "disturbance_observer")}
    result = demo(tables, tmp_path)
    assert result.summary.failed == 0 and result.summary.wall_error is not None
    assert result.uncompensated is not None and result.uncompensated.wall_error is not None
    assert result.summary.wall_error < 0.5 * result.uncompensated.wall_error


def test_an_observer_that_does_not_know_the_hand_fights_it_but_slackens_no_cable(
    tmp_path: Path,
) -> None:
    # What audits of Yoon's observer predict: it takes the hand for a disturbance.
    result = demo(variants.unmeasured("unmeasured"), tmp_path)
    assert result.uncompensated is not None
    assert result.summary.tour_force > 1.5 * result.uncompensated.tour_force
    assert result.summary.lowest_tension > 0.0


def test_an_observer_that_takes_the_command_for_the_load_would_drift(tmp_path: Path) -> None:
    core = shutil.copytree(RUNTIME_CORE, tmp_path / "core")
    source, applied = core / "controller.c", "controller->torque[i] * (TB_C(1.0) / TB_DRUM_RADIUS)"
    assert source.read_text().count(applied) == 1
    source.write_text(source.read_text().replace(applied, "outputs->tension[i]"))
    generated = variants.committed()
    plant, task = plant_of(generated.machine), plan_task(generated)
    found = run_task(generated.machine, plant, Controller(generated, core), task)
    last = found.during(task.phase("wall top"))
    drift = found.tensions[last].mean(axis=0) - found.outputs.tension[last].mean(axis=0)
    assert np.abs(drift).max() > 0.2 * generated.machine.tension.min


@pytest.mark.parametrize("compiler", ["gcc", "clang"])
@pytest.mark.parametrize("precision", [(), ("-DTB_REAL_FLOAT",)], ids=["double", "float"])
def test_the_core_compiles_without_a_warning_for_a_machine_that_has_little(
    compiler: str, precision: tuple[str, ...], tmp_path: Path
) -> None:
    generated = load(variants.write(variants.fixed("triangle", variants.TRIANGLE), tmp_path))
    warnings = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"]
    includes = [f"-I{RUNTIME_CORE}", f"-I{generated.folder}"]
    for source in (RUNTIME_CORE / name for name in STEP):
        command = [compiler, "-std=c11", "-O2", "-fno-math-errno", *warnings, *precision, *includes]
        target = ["-c", str(source), "-o", str(tmp_path / "object.o")]
        done = subprocess.run([*command, *target], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr


@pytest.mark.parametrize(
    ("key", "value", "message"),
    [
        ("plant", None, "plant: found nothing; allowed: a table"),
        ("hand_stiffness", "0 N/m", "plant.hand_stiffness: found 0 N/m; allowed: more than 0"),
        ("centre", ["20 mm", "440 mm"], "target.centre: found (0.02 m, 0.44 m)"),
    ],
)
def test_a_machine_that_is_not_fit_for_the_bench_is_refused_in_one_line(
    key: str, value: Any, message: str, tmp_path: Path
) -> None:
    tables = variants.fixed("unfit", variants.TRIANGLE)
    tables["target"] |= {"size": ["20 mm", "20 mm"]}
    if value is None:
        del tables[key]
    else:
        tables["target" if key == "centre" else "plant"] |= {key: value}
    with pytest.raises(MachineError) as refused:
        demo(tables, tmp_path)
    assert message in str(refused.value) and "\n" not in str(refused.value)
    assert not (tmp_path / "pictures").exists()
