"""The torque gate: what it does, for every input; full coverage; and mutants that must die."""

import math
import re
import struct
import subprocess
from dataclasses import dataclass
from itertools import product
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).parents[2]
GATE = ROOT / "runtime" / "core" / "torque_gate.c"
MACHINE = ROOT / "generated" / "yoon2023"
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"]
PRECISIONS: dict[str, type[np.float64 | np.float32]] = {"double": np.float64, "float": np.float32}

PASSED, NOT_FINITE, BELOW_ZERO, ABOVE_LIMIT, RATE, BAD_PREVIOUS = 0, 1, 2, 4, 8, 16

DRIVER = r"""
#include <stdio.h>
#include "tb_machine.h"
#include "torque_gate.h"
/* Prints the limits, then gates every pair (previous, command) of doubles on standard input. */
int main(void)
{
    double pair[2];
    printf("%a %a %a\n", (double)(TB_DRUM_RADIUS * TB_TENSION_MIN), (double)TB_TORQUE_LIMIT,
           (double)TB_TORQUE_STEP);
    while (fread(pair, sizeof(double), 2, stdin) == 2) {
        real_t torque = (real_t)-1;
        uint32_t const flags = tb_torque_gate((real_t)pair[0], (real_t)pair[1], &torque);
        printf("%a %u\n", (double)torque, (unsigned)flags);
    }
    return 0;
}
"""

Pairs = list[tuple[float, float]]


@dataclass(frozen=True)
class Gate:
    """A compiled gate; numbers in N m, rounded to its precision."""

    program: Path
    precision: str

    @property
    def limits(self) -> tuple[float, float, float]:
        """Minimum-tension torque, largest torque, largest step."""
        minimum, limit, step = (float.fromhex(text) for text in self._run([])[0])
        return minimum, limit, step

    def __call__(self, previous: float, command: float) -> tuple[float, int]:
        """Torque and flags for one pair."""
        return self.all([(previous, command)])[0]

    def all(self, pairs: Pairs) -> list[tuple[float, int]]:
        """Torque and flags for every pair (previous, command)."""
        return [(float.fromhex(torque), int(flags)) for torque, flags in self._run(pairs)[1:]]

    def round(self, value: float) -> float:
        """The value in the gate's precision."""
        with np.errstate(over="ignore"):
            return float(PRECISIONS[self.precision](value))

    def _run(self, pairs: Pairs) -> list[list[str]]:
        data = b"".join(struct.pack("dd", *pair) for pair in pairs)
        run = subprocess.run([self.program], input=data, capture_output=True, check=True)
        return [line.split() for line in run.stdout.decode().splitlines()]


def build(folder: Path, source: Path, precision: str, *flags: str) -> Gate:
    """Compile a gate with a driver program around it."""
    driver, program = folder / "driver.c", folder / f"gate_{precision}"
    driver.write_text(DRIVER)
    real = ["-DTB_REAL_FLOAT"] if precision == "float" else []
    includes = ["-I", str(GATE.parent), "-I", str(MACHINE)]
    files = [str(source), str(driver), "-o", str(program)]
    command = ["gcc", "-std=c11", *real, *flags, *includes, *files]
    subprocess.run(command, check=True, cwd=folder)
    return Gate(program, precision)


@pytest.fixture(scope="module", params=PRECISIONS)
def gate(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Gate:
    """The gate as it is, in both precisions."""
    return build(tmp_path_factory.mktemp("gate"), GATE, request.param, "-O2", *WARNINGS)


def corners(gate: Gate) -> Pairs:
    """Every pair of values at, just below and just above what the gate compares with."""
    minimum, limit, step = gate.limits
    real = PRECISIONS[gate.precision]
    around: set[float] = set()
    for value in (0.0, minimum, limit, step, limit - step, minimum + step, minimum - step):
        at = real(value)
        around |= {float(at), float(np.nextafter(at, -np.inf)), float(np.nextafter(at, np.inf))}
    largest = float(np.finfo(real).max)
    strange = [-0.0, math.nan, math.inf, -math.inf, largest, -largest, -limit, 2 * limit]
    values = [*sorted(around), *strange]
    edges = [(p, float(real(p) + sign * real(step))) for p in around for sign in (-1, 1)]
    return [*product(values, values), *edges]


def random_pairs(gate: Gate) -> Pairs:
    """Pairs within and around the limits."""
    _, limit, _ = gate.limits
    draws = np.random.default_rng(20231).uniform(-0.5 * limit, 1.5 * limit, (4000, 2))
    return [(gate.round(previous), gate.round(command)) for previous, command in draws]


def violations(gate: Gate, pairs: Pairs) -> list[str]:
    """Where the gate breaks its contract (torque_gate.h), in words."""
    minimum, limit, step = gate.limits
    found = []
    for (previous, command), (torque, flags) in zip(pairs, gate.all(pairs), strict=True):
        start = previous if 0.0 <= previous <= limit else 0.0
        goal = min(max(command, 0.0), limit) if math.isfinite(command) else minimum
        low, high = gate.round(start - step), gate.round(start + step)
        promised = {
            "finite and within [0, limit]": 0.0 <= torque <= limit,
            "no further than one step": low <= torque <= high,
            "as near to the goal as the step allows": torque == min(max(goal, low), high),
            "NOT_FINITE": bool(flags & NOT_FINITE) == (not math.isfinite(command)),
            "BELOW_ZERO": bool(flags & BELOW_ZERO) == (-math.inf < command < 0.0),
            "ABOVE_LIMIT": bool(flags & ABOVE_LIMIT) == (limit < command < math.inf),
            "RATE": bool(flags & RATE) == (torque != goal),
            "BAD_PREVIOUS": bool(flags & BAD_PREVIOUS) == (not 0.0 <= previous <= limit),
        }
        case = f"previous {previous!r}, command {command!r}: {torque!r}, flags {flags}: not "
        found += [case + promise for promise, kept in promised.items() if not kept]
    return found


def test_a_command_within_the_limits_passes_unchanged(gate: Gate) -> None:
    minimum, _, step = gate.limits
    command = gate.round(minimum + 0.5 * step)
    assert gate(minimum, command) == (command, PASSED)


def test_a_nan_becomes_the_minimum_tension_torque(gate: Gate) -> None:
    minimum, _, _ = gate.limits
    assert gate(minimum, math.nan) == (minimum, NOT_FINITE)


def test_a_nan_far_from_the_minimum_tension_is_still_cut_to_one_step(gate: Gate) -> None:
    _, limit, step = gate.limits
    assert gate(limit, math.nan) == (gate.round(limit - step), NOT_FINITE | RATE)


def test_a_cable_is_never_pushed(gate: Gate) -> None:
    _, _, step = gate.limits
    assert gate(gate.round(0.5 * step), -1.0) == (0.0, BELOW_ZERO)


def test_a_torque_beyond_the_limit_is_cut_to_it(gate: Gate) -> None:
    _, limit, step = gate.limits
    assert gate(gate.round(limit - 0.5 * step), 2 * limit) == (limit, ABOVE_LIMIT)


def test_a_jump_is_cut_to_one_step_in_both_directions(gate: Gate) -> None:
    _, limit, step = gate.limits
    assert gate(0.0, limit) == (step, RATE)
    assert gate(limit, 0.0) == (gate.round(limit - step), RATE)


def test_a_damaged_memory_of_the_last_torque_counts_as_zero(gate: Gate) -> None:
    _, limit, step = gate.limits
    for previous in (math.nan, math.inf, -limit, 2 * limit):
        assert gate(previous, limit) == (step, RATE | BAD_PREVIOUS)


def test_the_contract_holds_for_all_corners_and_random_pairs(gate: Gate) -> None:
    assert violations(gate, corners(gate) + random_pairs(gate)) == []


def covered(folder: Path, pairs_of: str) -> dict[str, float]:
    """Shares of lines, conditions evaluated and condition outcomes seen, in percent (gcov)."""
    gate = build(folder, GATE, "double", "-O0", "--coverage")
    gate.all(corners(gate) if pairs_of == "corners" else [(0.0, 0.0)])
    command = ["gcov", "-b", "-c", *(file.name for file in folder.glob("*torque_gate.gcda"))]
    report = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=True).stdout
    about = report.split("File ")[1:]
    mine = next(text for text in about if text.splitlines()[0].endswith("torque_gate.c'"))
    return {name: float(share) for name, share in re.findall(r"^(.+?):([\d.]+)% of", mine, re.M)}


def test_every_line_and_every_outcome_of_every_condition_is_tested(tmp_path: Path) -> None:
    # Each condition is one comparison or one of the two of is_within, whose three outcomes
    # (first false, second false, both true) are what MC/DC asks of an "and".
    shares = covered(tmp_path, "corners")
    assert set(shares) >= {"Lines executed", "Branches executed", "Taken at least once"}
    assert set(shares.values()) == {100.0}


def test_a_single_ordinary_command_does_not_cover_the_gate(tmp_path: Path) -> None:
    assert covered(tmp_path, "one")["Taken at least once"] < 60.0


MUTATIONS = [
    (" >= ", " > "),
    (" <= ", " < "),
    (" < ", " <= "),
    (" > ", " >= "),
    (" < ", " > "),
    (" > ", " < "),
    (" && ", " || "),
    (" + ", " - "),
    (" - ", " + "),
    (" * ", " + "),
    (" |= ", " = "),
    (" |= ", " &= "),
    ("if (!", "if ("),
    ("(-REAL_MAX", "(REAL_MAX"),
    ("-REAL_MAX", "TB_C(0.0)"),
    (" REAL_MAX)", " TB_TORQUE_LIMIT)"),
    (" FLT_MAX", " 1e30f"),
    (" DBL_MAX", " 1e30"),
    ("TB_C(0.0)", "TB_C(1.0)"),
    ("TB_TORQUE_LIMIT", "TB_TORQUE_STEP"),
    ("TB_TORQUE_STEP", "TB_TORQUE_LIMIT"),
    ("return TB_TORQUE_LIMIT;", "return command;"),
    ("return TB_C(0.0);", "return command;"),
    ("return minimum_tension_torque;", "return command;"),
    ("return minimum_tension_torque;", "return TB_C(0.0);"),
    ("previous = TB_C(0.0);", ""),
    ("= TB_GATE_PASSED", "= TB_GATE_RATE"),
]


def in_comment(source: str, at: int) -> bool:
    """Whether a place lies in a line with a comment."""
    return "/*" in source[source.rindex("\n", 0, at) : source.index("\n", at)]


def mutants() -> list[tuple[str, str]]:
    """(what was changed, mutated source) for every place where a mutation applies."""
    source = GATE.read_text()
    places = [
        (match.start(), old, new)
        for old, new in MUTATIONS
        for match in re.finditer(re.escape(old), source)
        if match.start() > source.index("#ifdef") and not in_comment(source, match.start())
    ]
    return [
        (
            f"line {source[:at].count(chr(10)) + 1}: {old!r} -> {new!r}",
            source[:at] + new + source[at + len(old) :],
        )
        for at, old, new in places
    ]


def survives(folder: Path, mutated: str) -> bool:
    """Whether a mutant keeps the contract in both precisions."""
    source = folder / "torque_gate.c"
    source.write_text(mutated)
    for precision in PRECISIONS:
        gate = build(folder, source, precision, "-O0", "-w")
        if violations(gate, corners(gate)):
            return False
    return True


def test_every_mutant_of_the_gate_is_found_out(tmp_path: Path) -> None:
    seeded = mutants()
    assert len(seeded) >= 40
    assert survives(tmp_path, GATE.read_text()), "the gate itself must keep the contract"
    assert [change for change, mutated in seeded if survives(tmp_path, mutated)] == []
