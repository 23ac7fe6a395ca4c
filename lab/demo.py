"""One closed-loop run of a machine on the bench, for a person to look at: numbers and a picture."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from rich.table import Table

from turnbuckle.codegen.bind import Generated, load
from turnbuckle.codegen.controller import UNCOMPENSATED, Controller
from turnbuckle.lab.bench import Reals, Recording, run_task
from turnbuckle.lab.pictures import refuse_foreign_picture
from turnbuckle.lab.plants import plant_model
from turnbuckle.lab.summary import Summary, summarise
from turnbuckle.lab.task import Planner, Task
from turnbuckle.model.machine import Machine, Plant
from turnbuckle.model.problem import MachineError, Problem
from turnbuckle.model.reading import load_machine
from turnbuckle.model.reference.control import base_targets

Progress = Callable[[str, float], None]
"""Told what is being done, and the share of it that is done."""


@dataclass(frozen=True)
class DemoResult:
    """What a demo found."""

    machine: Machine
    recording: Recording
    summary: Summary
    uncompensated: Summary | None
    """The same run with the observer only watching; None for a machine without one."""
    nanoseconds: NDArray[np.int64]
    """Time that every controller step of the run took, repeated on its own in C."""
    picture: Path


def run_demo(
    machine_path: str | Path, out_dir: str | Path, progress: Progress = lambda stage, share: None
) -> DemoResult:
    """Generate, compile and run a machine's controller on the bench; draw a picture into out_dir.

    Raises MachineError for a file that is wrong or not fit for the bench, CompileError without a
    working C compiler, FileError when the picture cannot be written.
    """
    from turnbuckle.lab.plots import draw  # here: others plan tasks without any pictures

    progress("generating the controller", 0.0)
    machine = load_machine(machine_path)
    plant = plant_of(machine)
    picture = Path(out_dir) / f"{machine.name}.png"
    refuse_foreign_picture(picture)  # before the long work
    generated = load(machine_path)
    task = plan_task(generated)
    controller = Controller(generated)

    def run(stage: str, options: int = 0) -> Recording:
        return run_task(machine, plant, controller, task, options, partial(progress, stage))

    recording = run("running the machine")
    uncompensated = None
    if machine.disturbance_observer is not None:
        uncompensated = summarise(machine, run("without compensation", UNCOMPENSATED))
    nanoseconds = time_steps(controller, recording)
    progress("drawing", 0.0)
    draw(machine, recording, picture)
    summary = summarise(machine, recording)
    return DemoResult(machine, recording, summary, uncompensated, nanoseconds, picture)


def plant_of(machine: Machine) -> Plant:
    """The physics of a machine; MachineError when its file does not tell enough of it, and for a
    machine that no plant simulates."""
    plant_model(machine)
    plant = machine.plant
    if plant is None:
        raise MachineError(
            machine.path, [Problem("plant", "nothing", "a table [plant], which the bench needs")]
        )
    if plant.hand_stiffness <= 0.0:
        found, allowed = f"{plant.hand_stiffness:g} N/m", "more than 0, so that the hand can lead"
        raise MachineError(machine.path, [Problem("plant.hand_stiffness", found, allowed)])
    return plant


def plan_task(generated: Generated) -> Task:
    """What the machine is asked to do on the bench."""
    plant = plant_of(generated.machine)
    return Planner(generated.machine, plant, partial(capability, generated)).plan()


def capability(generated: Generated, poses: Reals) -> Reals:
    """Force [N] (k) in every direction at poses (k, d) [m, rad], bases where they belong."""
    machine = generated.machine
    rails = base_targets(machine, poses)
    forces = generated.isotropic_force(poses, rails)
    return np.where(forces.status == 0, np.asarray(forces), 0.0)


def time_steps(controller: Controller, recording: Recording) -> NDArray[np.int64]:
    """Run the recorded inputs once more, on their own; nanoseconds (k) of every step."""
    first = recording.inputs[0]
    controller.start(first["lengths"], first["rails"][: recording.rails.shape[1]])
    _, nanoseconds = controller.run_recorded(recording.inputs)
    return nanoseconds


def summary_table(result: DemoResult) -> Table:
    """The demo's numbers, for a terminal."""
    summaries = [result.summary]
    table = Table(title=f"{result.machine.name} in closed loop", caption_justify="left")
    table.add_column("")
    table.add_column("", justify="right")
    if result.uncompensated is not None:
        summaries.append(result.uncompensated)
        table.columns[1].header = "with observer"
        table.add_column("without", justify="right")
    for label, unit, scale, name in ROWS:
        values = [getattr(summary, name) for summary in summaries]
        if values[0] is not None:
            table.add_row(label, *(f"{value * scale:.3g} {unit}" for value in values))
    table.add_section()
    for label, value in timing(result.nanoseconds).items():
        table.add_row(label, f"{value:.2f} µs")
    table.caption = "\n".join(result.recording.task.notes)
    return table


def timing(nanoseconds: NDArray[np.int64]) -> dict[str, float]:
    """Time per controller step [µs]; not its mean, which other programs on the machine lengthen."""
    half, most = np.percentile(nanoseconds * 1e-3, [50.0, 99.9])
    return {"time per step, half of them within": half, "99.9 % of them within": most}


ROWS = [
    ("moving freely: handle off the hand's path, rms", "mm", 1e3, "tour_error"),
    ("moving freely: force felt by the hand, rms", "N", 1.0, "tour_force"),
    ("moving freely: handle turned off the hand's path, rms", "mrad", 1e3, "tour_turn"),
    ("moving freely: moment felt by the hand, rms", "mN m", 1e3, "tour_moment"),
    ("turning force: delivered minus wanted, rms", "N", 1.0, "turn_error"),
    ("turning moment: delivered minus wanted, rms", "mN m", 1e3, "moment_error"),
    ("at the walls: delivered minus wanted, rms", "N", 1.0, "wall_error"),
    ("deepest in a wall", "mm", 1e3, "penetration"),
    ("lowest tension", "N", 1.0, "lowest_tension"),
    ("highest tension", "N", 1.0, "highest_tension"),
    ("base furthest from its target", "mm", 1e3, "base_lag"),
    ("largest error of the computed position", "µm", 1e6, "pose_error"),
    ("largest error of the computed rotation", "µrad", 1e6, "rotation_error"),
    ("cycles with a slack cable", "", 1.0, "slack"),
    ("cycles that wanted more force than there is", "", 1.0, "infeasible"),
    ("failed cycles", "", 1.0, "failed"),
]
"""Label, unit, scale from SI, and name in Summary."""
