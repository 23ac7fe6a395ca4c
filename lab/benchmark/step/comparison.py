"""Time of one controller cycle, and whether both controllers command the same."""

import ctypes
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np

from turnbuckle.lab.benchmark.native import (
    BUILD,
    OUR_FLAGS,
    OUR_WARNINGS,
    PEER_FLAGS,
    ROOT,
    compile_object,
    load_library,
)
from turnbuckle.lab.benchmark.solvers.qrqp import generate_c, work_sizes
from turnbuckle.lab.benchmark.step.model_step import ModelStep
from turnbuckle.lab.benchmark.step.motion import recorded_inputs
from turnbuckle.lab.benchmark.tension_problems import Reals
from turnbuckle.lab.benchmark.timing import Timing, time_in_turn
from turnbuckle.model.machine import Machine

FOLDER = Path(__file__).parent
CORE = ROOT / "runtime" / "core"
TOPICS = ("tb_kinematics", "tb_statics", "tb_tension", "tb_control")

Run = Callable[[Reals], Reals]


@dataclass(frozen=True)
class StepRow:
    """One controller: time of a cycle, and how far its commands are from ours."""

    name: str
    note: str
    timing: Timing
    torque_error: float  # N m
    force_error: float  # N


def compare_steps(
    machine: Machine, generated: Path, cycles: int, repetitions: int
) -> list[StepRow]:
    """Run the same recorded motion through both, in turn."""
    inputs = recorded_inputs(machine, cycles)
    controllers = {
        ("turnbuckle", "status, torque gate and KKT check included"): our_step(machine, generated),
        ("CasADi C", "same model, qrqp, no status"): casadi_step(machine),
    }
    runs = {name: partial(run, inputs) for (name, _), run in controllers.items()}
    timings = time_in_turn(runs, cycles, repetitions)
    answers = {name: run() for name, run in runs.items()}
    ours, cables = answers["turnbuckle"], len(machine.cables)
    return [
        StepRow(
            name,
            note,
            timings[name],
            torque_error=float(np.max(np.abs(answers[name] - ours)[:, :cables])),
            force_error=float(np.max(np.abs(answers[name] - ours)[:, cables:])),
        )
        for name, note in controllers
    ]


def our_step(machine: Machine, generated: Path) -> Run:
    """The runtime's step with one machine's generated code, as shipped."""
    sources = [generated / f"{topic}.c" for topic in TOPICS]
    sources += [CORE / "controller.c", CORE / "torque_gate.c", FOLDER / "turnbuckle_step.c"]
    flags = (*OUR_FLAGS, *OUR_WARNINGS, f"-I{generated}", f"-I{CORE}")
    objects = [built(source, flags) for source in sources]
    return stepper("turnbuckle_step", objects, machine)


def casadi_step(machine: Machine) -> Run:
    """The same step as CasADi's C generator writes it."""
    model = ModelStep(machine)
    function = model.function("casadi_step_model")
    source = generate_c(function)
    flags = (*PEER_FLAGS, f"-isystem{BUILD}", *work_sizes(function), *layout(model))
    objects = [
        built(source, PEER_FLAGS),
        built(FOLDER / "casadi_step.c", (*flags, *OUR_WARNINGS)),
    ]
    return stepper("casadi_step", objects, machine)


def layout(model: ModelStep) -> list[str]:
    """Sizes and offsets of the step's memory, as definitions for the compiler."""
    names = {"LENGTHS": "lengths", "OBSERVER": "observer", "RAIL": "rails", "BASE": "base"}
    offsets: dict[str, int] = {}
    total = 0
    for name, size in model.memory.items():
        offsets[name] = total
        total += size
    values = {macro: offsets[name] for macro, name in names.items()}
    values |= {"CABLES": model.cables, "RAILS": model.rails, "MEMORY": total}
    values["INPUTS"] = sum(model.inputs.values())
    return [f"-D{name}={value}" for name, value in values.items()]


def built(source: Path, flags: Sequence[str]) -> Path:
    """The object of a source, of this run."""
    return compile_object(source, BUILD / "step" / f"{source.stem}.o", flags)


def stepper(name: str, objects: Sequence[Path], machine: Machine) -> Run:
    """A compiled run_steps as a Python function: rows of cable torques, then rail forces."""
    run_steps = load_library(name, objects).run_steps
    run_steps.argtypes = [ctypes.c_size_t, ctypes.c_void_p, ctypes.c_void_p]
    run_steps.restype = None
    outputs = len(machine.cables) + len(machine.rails)

    def run(inputs: Reals) -> Reals:
        result = np.empty((len(inputs), outputs))
        run_steps(len(inputs), inputs.ctypes.data, result.ctypes.data)
        return result

    return run
