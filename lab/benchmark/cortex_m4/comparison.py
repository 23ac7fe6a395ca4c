"""Instructions per call: every program on the same random inputs, its answers checked."""

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from turnbuckle.lab.benchmark.cortex_m4.emulator import Floats
from turnbuckle.lab.benchmark.cortex_m4.programs import (
    Program,
    casadi_programs,
    casadi_step_programs,
    our_program,
    our_step_program,
    sympy_programs,
)
from turnbuckle.lab.benchmark.solvers.qrqp import SINGLE, tension_function
from turnbuckle.lab.benchmark.step.model_step import ModelStep, casadi_function
from turnbuckle.lab.benchmark.step.motion import recorded_inputs
from turnbuckle.lab.benchmark.tension_problems import feasible, random_poses, random_rails
from turnbuckle.model.machine import Machine
from turnbuckle.model.reference import kinematics
from turnbuckle.model.reference.tension import minimum_norm_tension
from turnbuckle.model.symbolic import topics
from turnbuckle.model.symbolic.function import ModelFunction

Reals = NDArray[np.float64]
#: Functions that all generators can write.
COMMON = ("cable_lengths", "structure_matrix", "length_jacobian", "forward_kinematics")
#: Cycles of the motion that are counted, from standstill.
CYCLES = 8


@dataclass(frozen=True)
class CountRow:
    """One generator's C for one function."""

    function: str
    generator: str
    mean: float
    most: float
    error: float  # largest difference from double precision, in the unit of the output


@dataclass(frozen=True)
class Case:
    """One call: its inputs, and the outputs that are right (the first ones of the program's)."""

    inputs: list[Floats]
    expected: Reals


def count_instructions(machine: Machine, generated: Path, count: int, seed: int) -> list[CountRow]:
    """All functions, all generators."""
    random = np.random.default_rng(seed)
    functions = {
        function.name: function
        for topic in ("kinematics", "tension")
        for function in topics.model_functions(machine)[topic]
    }
    rows: list[CountRow] = []
    for name in COMMON:
        function = functions[name]
        cases = kinematic_cases(machine, function, count, random)
        rows += measure(name, kinematic_programs(function, generated), cases)
    cases = tension_cases(machine, count, random)
    rows += measure("distribute_tension", tension_programs(machine, generated), cases)
    rows += measure("controller step", step_programs(machine, generated), [step_case(machine)])
    return rows


def kinematic_programs(function: ModelFunction, generated: Path) -> Iterable[Program]:
    """Every generator's C for a function of the kinematics."""
    yield our_program(function.name, [output.size for output in function.outputs], generated)
    yield from casadi_programs(casadi_function(function))
    yield from sympy_programs(function)


def tension_programs(machine: Machine, generated: Path) -> Iterable[Program]:
    """Ours and CasADi's qrqp; SymPy cannot solve."""
    cables, dof = len(machine.cables), machine.dof
    yield our_program("distribute_tension", [cables, dof, 1], generated)
    rows, wrench = ca.MX.sym("rows", dof * cables), ca.MX.sym("wrench", dof)
    solve = tension_function(machine, "solve", SINGLE)
    tension = solve(ca.reshape(rows, cables, dof).T, wrench)
    yield from casadi_programs(ca.Function("qrqp_tension_m4", [rows, wrench], [tension]))


def step_programs(machine: Machine, generated: Path) -> Iterable[Program]:
    """The whole controller step, per cycle; our adapter's copies are counted too."""
    yield our_step_program(generated, CYCLES)
    yield from casadi_step_programs(ModelStep(machine, SINGLE), CYCLES)


def kinematic_cases(
    machine: Machine, function: ModelFunction, count: int, random: np.random.Generator
) -> list[Case]:
    """Random poses and rail coordinates; the expected outputs from the same model in double."""
    rails = random_rails(machine, count, random)
    first = random_poses(machine, count, random)
    if function.name == "forward_kinematics":
        first = np.asarray(kinematics.cable_lengths(machine, first, rails), float)
    evaluate = casadi_function(function)
    inputs = [
        [a.astype(np.float32), b.astype(np.float32)] for a, b in zip(first, rails, strict=True)
    ]
    return [Case(given, evaluated(evaluate, given)) for given in inputs]


def evaluated(function: ca.Function, inputs: Iterable[Floats]) -> Reals:
    """All outputs of a CasADi function in double precision, one after the other."""
    results = function.call([ca.DM(values.astype(float)) for values in inputs])
    return np.concatenate([np.array(result).ravel() for result in results])


def tension_cases(machine: Machine, count: int, random: np.random.Generator) -> list[Case]:
    """Random feasible problems; the expected tensions from the independent reference."""
    poses = random_poses(machine, count, random)
    rails = random_rails(machine, count, random)
    matrices = np.asarray(kinematics.structure_matrix(machine, poses, rails), float)
    structure, wrench = feasible(machine, matrices, random)
    single = structure.astype(np.float32), wrench.astype(np.float32)
    bounds = machine.tension
    exact = [values.astype(float) for values in single]
    best = minimum_norm_tension(exact[0], exact[1], bounds.min, bounds.max).tension
    return [
        Case([matrix.ravel(), force], expected)
        for matrix, force, expected in zip(*single, best, strict=True)
    ]


def step_case(machine: Machine) -> Case:
    """The first cycles of the recorded motion; the expected commands from CasADi in double."""
    inputs = recorded_inputs(machine, CYCLES).astype(np.float32)
    return Case([inputs.ravel()], run_model(ModelStep(machine), inputs.astype(float)))


def run_model(model: ModelStep, inputs: Reals) -> Reals:
    """Commands of the model's step over the rows of inputs, from rest."""
    step = model.function("expected_step")
    memory = model.start(inputs[0])
    commands = []
    for row in inputs:
        outputs, memory = step(row, memory)
        commands.append(np.array(outputs).ravel())
    return np.concatenate(commands)


def measure(function: str, programs: Iterable[Program], cases: list[Case]) -> list[CountRow]:
    """Count each program on all cases."""
    return [row(function, program, cases) for program in programs]


def row(function: str, program: Program, cases: list[Case]) -> CountRow:
    """Mean and largest count, and the largest error."""
    counts, errors = [], []
    for case in cases:
        outputs, instructions = program.run(case.inputs)
        counts.append(instructions)
        errors.append(np.max(np.abs(outputs[: len(case.expected)] - case.expected)))
    return CountRow(
        function, program.generator, float(np.mean(counts)), max(counts), float(max(errors))
    )
