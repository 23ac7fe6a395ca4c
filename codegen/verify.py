"""Runs every generated function against the independent reference, in double and single precision.

The arguments are those of operation (codegen.samples), hard ones (codegen.hard_cases) and broken
ones: NaN, infinities and huge numbers, which must be refused with the function's fallback. The
reference gets the very numbers the C got, in long double; codegen.judges says what it expects
and how nearly.
"""

import json
import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from turnbuckle.codegen.accuracy import Accuracy
from turnbuckle.codegen.accuracy_cache import measured_accuracy
from turnbuckle.codegen.bind import REALS, Generated, GeneratedFunction, folder_of
from turnbuckle.codegen.folder import FolderError
from turnbuckle.codegen.generate import MANIFEST, render
from turnbuckle.codegen.hard_cases import HardSampler
from turnbuckle.codegen.identity import machine_hash
from turnbuckle.codegen.judges import JUDGES
from turnbuckle.codegen.judges.problem import Bools, Expected, Problem
from turnbuckle.codegen.model import Model, build_model
from turnbuckle.codegen.prefix import PLAIN
from turnbuckle.codegen.processes import forked_workers
from turnbuckle.codegen.samples import Sampler
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine
from turnbuckle.model.reference.control import disturbance_sequence
from turnbuckle.model.reference.planar import Array as Wide
from turnbuckle.model.symbolic.function import Input, ModelFunction, Status

Progress = Callable[[str, int, int], None]

#: The static library of a precision, in a folder of what was built.
ARCHIVE = "{}/libturnbuckle.a"
#: Points of each kind that every function is tried at, unless told otherwise.
POINTS = 1000
#: Points of each kind that are judged together; more are judged in blocks, on all cores.
BLOCK = 2500
#: What draws the points of each kind.
SAMPLERS: tuple[type[Sampler], ...] = (Sampler, HardSampler)
#: One broken argument in so many points, and the fewest of them.
BROKEN_SHARE, FEWEST_BROKEN = 16, 64
#: Fewer points than this that are given up say nothing about how many would be.
FEW_GIVEN_UP = 4
#: Cycles and motions of the recordings that the disturbance observer is judged by.
CYCLES, MOTIONS = 300, 8
#: Beyond this many times its bound an argument must be refused.
CLEARLY_BEYOND = 1.01


@dataclass(frozen=True)
class Row:
    """What was found for one output of one function in one precision.

    `tolerance` is the one at the point where the error is the largest part of its tolerance, and
    `share` is that part: more than 1 is a failure. `worst_ulp` counts units in the last place of
    the largest entry of the reference's result there; results smaller than the rounding of the
    largest result anywhere count as that large. `disagreements` counts wrong statuses.
    """

    function: str
    output: str
    precision: str
    points: int
    worst_absolute: float
    worst_ulp: float
    tolerance: float
    share: float
    disagreements: int
    first_disagreement: str = ""

    @property
    def ok(self) -> bool:
        """Whether errors and statuses are as they should be."""
        return self.share <= 1 and self.disagreements == 0

    def joined(self, other: "Row") -> "Row":
        """The worst of both, which are of one output at different points."""
        worse = other if other.share > self.share else self
        return replace(
            worse,
            points=self.points + other.points,
            worst_absolute=max(self.worst_absolute, other.worst_absolute),
            worst_ulp=max(self.worst_ulp, other.worst_ulp),
            disagreements=self.disagreements + other.disagreements,
            first_disagreement=self.first_disagreement or other.first_disagreement,
        )


@dataclass(frozen=True)
class Report:
    """All rows of a machine."""

    machine: str
    hash: str
    seed: int
    rows: list[Row]

    @property
    def passed(self) -> bool:
        """Whether every function agrees with the reference."""
        return bool(self.rows) and all(row.ok for row in self.rows)

    def failures(self) -> list[Row]:
        """The rows that disagree."""
        return [row for row in self.rows if not row.ok]

    def to_json(self) -> dict[str, Any]:
        """Everything as plain data."""
        rows = [asdict(row) | {"ok": row.ok} for row in self.rows]
        return {
            "machine": self.machine,
            "hash": self.hash,
            "seed": self.seed,
            "passed": self.passed,
            "rows": rows,
        }


def verify(
    machine_path: str | Path,
    points: int = POINTS,
    seed: int = 1,
    progress: Progress | None = None,
    folder: Path | None = None,
    built: Path | None = None,
) -> Report:
    """Compile and judge the C of a machine file: that in the folder, or else generate it first.

    built: a folder of static libraries of that C, which are judged as they are: ARCHIVE of each
    precision.

    points: of each kind, every function, each precision. progress(function, done, total) is called
    before every function. Raises MachineError for a bad file, FolderError for a folder with other
    C than the file's, CompileError without a C compiler.
    """
    machine = load_machine(machine_path)
    model = build_model(machine)
    if folder:
        refuse_other_c(folder, model)
    accuracies = measured_accuracy(machine, model.items(), folder)
    folder = folder or folder_of(machine, render(model, accuracies))
    return verify_folder(folder, model, accuracies, points, seed, progress, built)


def refuse_other_c(folder: Path, model: Model) -> None:
    """FolderError where the C in a folder is not what the machine file means today."""
    again = f"run: turnbuckle generate {model.machine.path} --out {folder}"
    try:
        content = dict(json.loads((folder / MANIFEST).read_text()))
        found, prefix = str(content["hash"]), str(content["prefix"])
    except FileNotFoundError:
        raise FolderError(f"{folder}: holds no {MANIFEST}; {again}") from None
    except (OSError, ValueError, KeyError, TypeError):
        raise FolderError(f"{folder / MANIFEST}: is not of generated C; {again}") from None
    wanted = machine_hash(model)
    if found != wanted:
        raise FolderError(
            f"{folder}: holds C of machine hash {found}, {model.machine.path} has {wanted}; {again}"
        )
    if prefix != PLAIN:
        raise FolderError(
            f"{folder}: every name begins with {prefix}, not with {PLAIN}; verify the C without"
            " a prefix, which is the same"
        )


def verify_folder(
    folder: Path,
    model: Model,
    accuracies: dict[str, Accuracy],
    points: int = POINTS,
    seed: int = 1,
    progress: Progress | None = None,
    built: Path | None = None,
) -> Report:
    """Compile and judge the C in a folder, or what was built of it."""

    def library(precision: str) -> Generated:
        archive = built / ARCHIVE.format(precision) if built else None
        if archive and not archive.is_file():
            raise FolderError(f"{archive}: is missing; run: make build")
        return Generated(model.machine, folder, precision, archive)

    with ThreadPoolExecutor() as compiling:
        libraries = list(compiling.map(library, REALS))
    bench = Bench(libraries, model, accuracies)
    parts = blocks(points, seed)
    tell = progress or (lambda *_: None)
    if len(parts) > 1:
        rows = judge_on_all_cores(bench, parts, tell)
    else:
        rows = judge_block(bench, parts[0], tell)
    return Report(model.machine.name, libraries[0].hash, seed, rows)


@dataclass(frozen=True)
class Bench:
    """The C of a machine in every precision, and what it is judged by."""

    libraries: list[Generated]
    model: Model
    accuracies: dict[str, Accuracy]


@dataclass(frozen=True)
class Block:
    """Points of each kind that are judged together, drawn from one seed."""

    seed: int
    points: int


def blocks(points: int, seed: int) -> list[Block]:
    """So many points in blocks that share none."""
    starts = range(0, points, BLOCK)
    return [Block(seed + len(SAMPLERS) * k, min(BLOCK, points - n)) for k, n in enumerate(starts)]


def judge_block(bench: Bench, block: Block, progress: Progress) -> list[Row]:
    """Every function in every precision at the points of a block."""
    rows: list[Row] = []
    total = sum(len(generated.functions) for generated in bench.libraries)
    done = 0
    for generated in bench.libraries:
        trial = Trial(generated, bench.model, bench.accuracies, block.points, block.seed)
        for name in generated.functions:
            progress(name, done, total)
            rows += trial.rows(name)
            done += 1
    return rows


#: What the processes judge; they are forked with it, as a library cannot be sent to another.
_bench: Bench | None = None


def judge_on_all_cores(bench: Bench, parts: list[Block], progress: Progress) -> list[Row]:
    """The rows of all blocks, each the worst of its own."""
    global _bench
    _bench = bench
    worst: list[Row] = []
    with forked_workers(len(os.sched_getaffinity(0))) as pool:
        for done, rows in enumerate(pool.map(judge_forked, parts)):
            worst = [a.joined(b) for a, b in zip(worst, rows, strict=True)] if done else rows
            progress("all functions", done + 1, len(parts))
    return worst


def judge_forked(block: Block) -> list[Row]:
    """The rows of a block of the bench at hand."""
    assert _bench is not None
    return judge_block(_bench, block, lambda *_: None)


class Trial:
    """Judges the functions of one machine in one precision."""

    def __init__(
        self,
        generated: Generated,
        model: Model,
        accuracies: dict[str, Accuracy],
        points: int,
        seed: int,
    ) -> None:
        self.generated, self.machine = generated, model.machine
        self.real = REALS[generated.precision]
        self.epsilon = float(np.finfo(self.real).eps)
        self.accuracies = accuracies
        self.targets = {item.function.name: item.function for item in model.items()}
        self.aliases = model.aliases()
        self.samplers: list[Sampler] = [
            kind(self.machine, seed + k, points) for k, kind in enumerate(SAMPLERS)
        ]
        self.seed = seed
        fewer = max(FEWEST_BROKEN, points // BROKEN_SHARE)
        self.sound = Sampler(self.machine, seed + len(SAMPLERS), fewer)
        self.drawn: dict[tuple[str, ...], list[NDArray[Any]]] = {}
        self.solved: dict[tuple[str, ...], dict[str, Any]] = {}

    def rows(self, name: str) -> list[Row]:
        """One row for each output of a function."""
        target = self.aliases.get(name, name)
        function = self.targets[target]
        called = self.generated.functions[name]
        rows = self.broken_rows(called, function)
        if target == "observe_disturbance":
            return rows + self.observer_rows(called)
        return rows + self.judged_rows(called, function)

    def judged_rows(self, called: GeneratedFunction, function: ModelFunction) -> list[Row]:
        """Arguments of operation and hard ones, judged by the reference."""
        signature = tuple(port.name for port in function.inputs)
        arguments = self.arguments(function)
        wide = {
            port.name: given.astype(np.longdouble)
            for port, given in zip(called.inputs, arguments, strict=True)
        }
        shared = self.solved.setdefault(signature, {})
        problem = Problem(self.machine, self.epsilon, wide, shared)
        answer = call(called, arguments)
        with np.errstate(all="ignore"):
            wanted = self.expected(function, problem, answer)
            return self.compare(called, function, answer, wanted)

    def expected(
        self, function: ModelFunction, problem: Problem, answer: dict[str, NDArray[Any]]
    ) -> Expected:
        """What the judge expects; a closer look where the C says something else."""
        judge = JUDGES[function.name]
        wanted = judge(problem.at_first())
        doubtful = np.flatnonzero(~self.agrees(function, answer, wanted))
        return (
            wanted.corrected(doubtful, judge(problem.among(doubtful))) if doubtful.size else wanted
        )

    def agrees(
        self, function: ModelFunction, answer: dict[str, NDArray[Any]], wanted: Expected
    ) -> Bools:
        """Where (count) the status is right and every usable value is near enough."""
        status = answer["status"]
        fine = wanted.allowed[np.arange(len(status)), status]
        for name, reference in wanted.values.items():
            _, share = _errors(answer[name], reference, self.tolerance(function, name, wanted))
            fine = fine & (np.all(_flat(share) <= 1, axis=1) | (status > Status.INFEASIBLE))
        return np.asarray(fine)

    def tolerance(self, function: ModelFunction, output: str, wanted: Expected) -> Wide:
        """The judge's, and the header's where it counts."""
        bound = self.bound(function.name, output) if wanted.beside_header else 0.0
        return np.asarray(wanted.tolerance[output] + np.longdouble(bound))

    def arguments(self, function: ModelFunction) -> list[NDArray[Any]]:
        """Arguments as the precision holds them; the same for functions that take the same."""
        special = function.name if function.name == "base_pid" else ""
        key = (special, *(port.name for port in function.inputs))
        if key not in self.drawn:
            self.drawn[key] = [
                np.concatenate([drawn(s, function.name, p) for s in self.samplers])
                .reshape(sum(s.count for s in self.samplers), *p.shape)
                .astype(self.real)
                for p in function.inputs
            ]
        return self.drawn[key]

    def compare(
        self,
        called: GeneratedFunction,
        function: ModelFunction,
        answer: dict[str, NDArray[Any]],
        wanted: Expected,
    ) -> list[Row]:
        """Errors against tolerances where the answer is usable; statuses everywhere."""
        status = answer["status"]
        right = wanted.allowed[np.arange(len(status)), status]
        usable = right & (status <= Status.INFEASIBLE)
        wrong = np.flatnonzero(~right)
        first = _told(status, wanted.allowed, wrong)
        given_up = int(np.sum(right & (status == Status.INACCURATE)))
        too_many = given_up > max(FEW_GIVEN_UP, wanted.gives_up * len(status))
        first = first or (f"{given_up} points of {len(status)} are given up" if too_many else "")
        rows = []
        for port in called.outputs:
            value, reference = answer[port.name], wanted.values[port.name]
            tolerance = self.tolerance(function, port.name, wanted)
            row = self.row(called.name, port.name, value, reference, tolerance, usable)
            fallback = next(o.fallback for o in function.outputs if o.name == port.name)
            stray = np.any(_flat(value)[status > Status.INFEASIBLE] != self.real(fallback), axis=1)
            disagreements = len(wrong) + int(np.sum(stray)) + given_up * too_many
            rows.append(
                Row(*row, disagreements, first or ("stray fallback" if stray.any() else ""))
            )
        return rows

    def bound(self, function: str, output: str) -> float:
        """What the header promises."""
        return self.accuracies[function].results[output][self.generated.precision].bound

    def row(
        self,
        function: str,
        output: str,
        value: NDArray[Any],
        reference: Wide,
        tolerance: Wide,
        usable: Bools,
    ) -> tuple[str, str, str, int, float, float, float, float]:
        """The errors of one output."""
        got, ref, allowed = (_flat(x)[usable] for x in (value, reference, tolerance))
        head = (function, output, self.generated.precision, len(usable))
        if not got.size:
            return (*head, 0.0, 0.0, 0.0, 0.0)
        error, share = _errors(got, ref, allowed)
        size = np.max(np.abs(ref), axis=1)
        counted = np.maximum(size, self.epsilon * np.max(size, initial=1e-30))
        ulp = np.spacing(counted.astype(self.real)).astype(np.longdouble)
        place = np.unravel_index(int(np.argmax(share)), share.shape)
        worst_ulp = float(np.max(np.max(error, axis=1) / ulp))
        return (
            *head,
            float(np.max(error)),
            worst_ulp,
            float(allowed[place]),
            float(share[place]),
        )

    def broken_rows(self, called: GeneratedFunction, function: ModelFunction) -> list[Row]:
        """Arguments out of their domain: refused, with the fallback in every output."""
        if not any(port.size for port in function.inputs):
            return []
        arguments = [
            self.sound.argument(function.name, port.name, port.size).astype(self.real)
            for port in function.inputs
        ]
        self.break_arguments(arguments, function)
        answer = call(called, arguments)
        refused = answer["status"] == Status.OUT_OF_DOMAIN
        rows = []
        for port, output in zip(called.outputs, function.outputs, strict=True):
            fine = np.all(_flat(answer[port.name]) == self.real(output.fallback), axis=1)
            wrong = int(np.sum(~(fine & refused)))
            text = "an argument out of its domain was taken" if wrong else ""
            head = (called.name, f"{port.name} (refused)", self.generated.precision, len(refused))
            rows.append(Row(*head, 0.0, 0.0, 0.0, 0.0, wrong, text))
        return rows

    def break_arguments(self, arguments: list[NDArray[Any]], function: ModelFunction) -> None:
        """One entry of every point goes out of its domain; every entry gets its turn."""
        entries = [(k, e) for k, port in enumerate(function.inputs) for e in range(port.size)]
        for point in range(len(arguments[0])):
            which, entry = entries[point % len(entries)]
            choices = outside(function.inputs[which], entry)
            bad = choices[(point // len(entries)) % len(choices)]
            arguments[which][point, entry] = self.real(bad)
        for k, port in enumerate(function.inputs):
            arguments[k] = arguments[k].reshape(len(arguments[k]), *port.shape)

    def observer_rows(self, called: GeneratedFunction) -> list[Row]:
        """The observer over recordings, judged by its transfer functions."""
        lengths, load, applied = (x.astype(self.real) for x in recording(self.machine, self.seed))
        memory = np.zeros((MOTIONS, lengths.shape[-1], 5), self.real)
        memory[:, :, 0] = lengths[0]
        found = np.empty_like(lengths)
        disagreements = 0
        for cycle in range(CYCLES):
            answer = call(called, [memory, lengths[cycle], load[cycle], applied[cycle]])
            memory, found[cycle] = answer["next_memory"], answer["disturbance"]
            disagreements += int(np.sum(answer["status"] != Status.OK))
        wide = [x.astype(np.longdouble) for x in (lengths, load, applied)]
        wanted = disturbance_sequence(self.machine, *wide)
        slack = np.full(wanted.shape, self.observer_slack(*wide), np.longdouble)
        usable = np.ones(CYCLES, dtype=bool)
        row = self.row(called.name, "disturbance", found, wanted, slack, usable)
        text = "a recording was refused" if disagreements else ""
        kept = (memory[:, :, 0] == lengths[-1]) & (memory[:, :, 4] == found[-1])
        row = (*row[:3], CYCLES * MOTIONS, *row[4:])
        return [Row(*row, disagreements + int(np.sum(~kept)), text)]

    def observer_slack(self, lengths: Wide, load: Wide, applied: Wide) -> float:
        """Each cycle rounds speed and torques; a pole sums up 1 / (1 - pole) of that."""
        observer, motor = self.machine.disturbance_observer, self.machine.cable_motor
        assert observer is not None
        ratio = 2 * observer.time_constant * self.machine.control.rate
        rate = 2 * self.machine.control.rate / (ratio + 1)
        speed = np.max(np.abs(np.diff(lengths, axis=0))) * self.machine.control.rate
        speed /= self.machine.drum.radius
        torque = np.max(np.abs(applied)) + self.machine.drum.radius * np.max(np.abs(load))
        inertial = rate * motor.inertia * speed
        return float(8 * self.epsilon * (torque + inertial * (ratio + 1)) * (ratio + 1) / 2)


def drawn(sampler: Sampler, function: str, port: Input) -> NDArray[Any]:
    """Arguments of one name; a platform exactly on a pulley has no direction there: any will do."""
    values = sampler.argument(function, port.name, port.size)
    if port.name == "structure":
        columns = values.reshape(len(values), *port.shape)
        columns[:, 0] = np.where(np.any(columns != 0, axis=1), columns[:, 0], 1.0)
    return values


def call(function: GeneratedFunction, arguments: list[NDArray[Any]]) -> dict[str, NDArray[Any]]:
    """Outputs by name, and "status"."""
    answer = function(*arguments)
    if len(function.outputs) == 1:
        return {function.outputs[0].name: np.asarray(answer), "status": answer.status}
    return dict(answer._asdict())


def outside(port: Input, entry: int) -> list[float]:
    """Values of one entry that must be refused."""
    broken = [float("nan"), float("inf"), float("-inf"), 1e30, -1e30]
    if not port.guarded:
        return broken
    margin = CLEARLY_BEYOND - 1
    low, high = port.low[entry], port.high[entry]
    reach = 2 * high if port.bounds_sum else high
    span = high - low
    beyond = [reach + margin * span, (low if not port.bounds_sum else -reach) - margin * span]
    return [*broken, *beyond]


def recording(machine: Machine, seed: int) -> tuple[NDArray[Any], ...]:
    """Smooth lengths [m], loads [N] and applied torques [N m], (cycles, motions, n) each."""
    random = np.random.default_rng(seed)
    time = np.arange(CYCLES)[:, None, None] / machine.control.rate
    shape = (1, MOTIONS, len(machine.cables))
    frequency = random.uniform(1, 20, (3, *shape))
    phase = random.uniform(0, 2 * np.pi, (3, *shape))
    length, load, torque = np.sin(2 * np.pi * frequency * time[None] + phase)
    bounds = machine.tension
    middle, half = (bounds.max + bounds.min) / 2, (bounds.max - bounds.min) / 2
    size = min(machine.frame.size)
    pull = middle + half * load
    return 0.5 * size + 0.02 * size * length, pull, machine.drum.radius * (pull + half * torque)


def _flat(values: NDArray[Any]) -> NDArray[Any]:
    return values.reshape(len(values), int(np.prod(values.shape[1:], dtype=int)))


def _errors(got: NDArray[Any], reference: Wide, tolerance: Wide) -> tuple[Wide, Wide]:
    """How far each value is off, and the share of its tolerance; infinite is any finite value's."""
    error = np.abs(got.astype(np.longdouble) - reference)
    error = np.where(np.isnan(error), np.inf, error)
    share = np.where(error > 0, error / np.maximum(tolerance, np.finfo(np.longdouble).tiny), 0)
    return error, np.where(np.isinf(tolerance) & np.isfinite(got), 0, share)


def _told(status: NDArray[Any], allowed: Bools, wrong: NDArray[Any]) -> str:
    """The first wrong status and what was allowed instead."""
    if not wrong.size:
        return ""
    k = int(wrong[0])
    fine = " or ".join(s.name for s in Status if allowed[k, s]) or "nothing"
    return f"point {k}: {Status(int(status[k])).name} where {fine} is right"
