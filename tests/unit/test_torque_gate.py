"""The torque gate: what it does, for every input; full coverage; and mutants that must die."""

import math
import re
import struct
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import product
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

ROOT = Path(__file__).parents[2]
GATE = ROOT / "runtime" / "core" / "torque_gate.c"
MACHINE = ROOT / "generated" / "yoon2023"
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"]
PRECISIONS: dict[str, type[np.float64 | np.float32]] = {"double": np.float64, "float": np.float32}

PASSED, NOT_FINITE, BELOW_LIMIT, ABOVE_LIMIT, RATE, BAD_PREVIOUS = 0, 1, 2, 4, 8, 16
NOT_PERMITTED = 32
COMMAND, REST, NOTHING = range(3)
CABLE, CABLE_BY_LIMITS, BASE, POSITION = range(4)

DRIVER = r"""
#include <stdio.h>
#include "tb_machine.h"
#include "torque_gate.h"
/* Prints the limits of every kind of motor, then gates every case of doubles on standard input:
 * kind, permission, previous, command. The cable's torque is computed here once more. */
static tb_gate_limits const kinds[] = {
    {TB_C(0.0), TB_TORQUE_LIMIT, TB_TORQUE_STEP, TB_DRUM_RADIUS * TB_TENSION_MIN, TB_C(0.0)},
    {TB_C(0.0), TB_TORQUE_LIMIT, TB_TORQUE_STEP, TB_DRUM_RADIUS * TB_TENSION_MIN, TB_C(0.0)},
    {TB_C(-0.9), TB_C(0.9), TB_C(0.2), TB_C(0.125), TB_C(-0.25)},
    {TB_C(0.125), TB_C(0.7), TB_C(0.003), TB_C(0.375), TB_C(0.25)}};

static uint32_t gate(const double given[4], real_t *setpoint)
{
    int const kind = (int)given[0];
    tb_permission const permission = (tb_permission)(int)given[1];
    real_t const previous = (real_t)given[2], command = (real_t)given[3];
    if (kind == 0) {
        return tb_torque_gate(previous, command, setpoint);
    }
    return tb_gate((kind == 1) ? &tb_cable_limits : &kinds[kind], permission, previous, command,
                   setpoint);
}

int main(void)
{
    double given[4];
    for (int kind = 0; kind < 4; kind++) {
        tb_gate_limits const *const k = &kinds[kind];
        printf("%a %a %a %a %a\n", (double)k->low, (double)k->high, (double)k->step,
               (double)k->safe, (double)k->rest);
    }
    while (fread(given, sizeof(double), 4, stdin) == 4) {
        real_t setpoint = (real_t)-1;
        uint32_t const flags = gate(given, &setpoint);
        printf("%a %u\n", (double)setpoint, (unsigned)flags);
    }
    return 0;
}
"""


Pairs = list[tuple[float, float]]


class Limits(NamedTuple):
    """What a kind of motor may be asked for."""

    low: float
    high: float
    step: float
    safe: float
    rest: float


class Case(NamedTuple):
    """One call of the gate."""

    kind: int
    permission: int
    previous: float
    command: float


@dataclass(frozen=True)
class Gate:
    """A compiled gate; numbers in N m or m, rounded to its precision."""

    program: Path
    precision: str

    @cached_property
    def limits(self) -> list[Limits]:
        """Of every kind of motor."""
        return [Limits(*map(float.fromhex, texts)) for texts in self._run([])]

    def __call__(self, previous: float, command: float) -> tuple[float, int]:
        """Torque and flags for a cable motor."""
        return self.all([Case(CABLE, COMMAND, previous, command)])[0]

    def all(self, cases: list[Case]) -> list[tuple[float, int]]:
        """Setpoint and flags for every case."""
        return [(float.fromhex(value), int(flags)) for value, flags in self._run(cases)[4:]]

    def round(self, value: float) -> float:
        """The value in the gate's precision."""
        with np.errstate(over="ignore"):
            return float(PRECISIONS[self.precision](value))

    def _run(self, cases: list[Case]) -> list[list[str]]:
        data = b"".join(struct.pack("4d", *case) for case in cases)
        run = subprocess.run([self.program], input=data, capture_output=True, check=True)
        return [line.split() for line in run.stdout.decode().splitlines()]


def build(folder: Path, source: Path, precision: str, *flags: str) -> Gate:
    """Compile a gate with a driver program around it."""
    driver, program = folder / "driver.c", folder / f"gate_{precision}"
    real = ["-DTB_REAL_FLOAT"] if precision == "float" else []
    includes = ["-I", str(GATE.parent), "-I", str(MACHINE)]
    compiler = ["gcc", "-std=c11", *real, *flags, *includes]
    compiled_driver = folder / f"driver_{precision}_{'_'.join(flags)}.o".replace("-", "")
    if not compiled_driver.exists():
        driver.write_text(DRIVER)
        subprocess.run([*compiler, "-c", str(driver), "-o", str(compiled_driver)], check=True)
    files = [str(source), str(compiled_driver), "-o", str(program)]
    subprocess.run([*compiler, *files], check=True, cwd=folder)
    return Gate(program, precision)


@pytest.fixture(scope="module", params=PRECISIONS)
def gate(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Gate:
    """The gate as it is, in both precisions."""
    return build(tmp_path_factory.mktemp("gate"), GATE, request.param, "-O2", *WARNINGS)


def pairs(gate: Gate, limits: Limits) -> Pairs:
    """Every pair of values at, just below and just above what the gate compares with."""
    low, high, step, safe, rest = limits
    real = PRECISIONS[gate.precision]
    around: set[float] = set()
    for value in (low, high, safe, rest, high - step, low + step, safe + step, rest - step, step):
        at = real(value)
        around |= {float(at), float(np.nextafter(at, -np.inf)), float(np.nextafter(at, np.inf))}
    largest = float(np.finfo(real).max)
    strange = [-0.0, math.nan, math.inf, -math.inf, largest, -largest, -high, 2 * high]
    values = [*sorted(around), *strange]
    edges = [(p, float(real(p) + sign * real(step))) for p in around for sign in (-1, 1)]
    return [*product(values, values), *edges]


def corners(gate: Gate) -> list[Case]:
    """Every kind of motor with every permission in every corner."""
    cases = [Case(CABLE, COMMAND, *pair) for pair in pairs(gate, gate.limits[CABLE])]
    for kind, permission in product((CABLE_BY_LIMITS, BASE, POSITION), (COMMAND, REST, NOTHING)):
        cases += [Case(kind, permission, *pair) for pair in pairs(gate, gate.limits[kind])]
    return cases


def random_cases(gate: Gate) -> list[Case]:
    """Within and around the limits."""
    random = np.random.default_rng(20231)
    cases = []
    for kind, permission in product(range(4), (COMMAND, REST, NOTHING)):
        low, high, *_ = gate.limits[kind]
        draws = random.uniform(low - 0.5 * high, 1.5 * high, (500, 2))
        used = COMMAND if kind == CABLE else permission
        cases += [Case(kind, used, gate.round(a), gate.round(b)) for a, b in draws]
    return cases


def promises(gate: Gate, case: Case, setpoint: float, flags: int) -> dict[str, bool]:
    """What the gate promises (torque_gate.h), and whether it keeps it."""
    low, high, step, safe, rest = gate.limits[case.kind]
    follows = case.permission == COMMAND
    command = case.command if follows else rest
    start = case.previous if low <= case.previous <= high else rest
    start = rest if case.permission == NOTHING else start
    goal = min(max(command, low), high) if math.isfinite(command) else safe
    lowest, highest = gate.round(start - step), gate.round(start + step)
    return {
        "finite and within the limits": low <= setpoint <= high,
        "no further than one step": lowest <= setpoint <= highest,
        "as near to the goal as the step allows": setpoint == min(max(goal, lowest), highest),
        "NOT_FINITE": bool(flags & NOT_FINITE) == (not math.isfinite(command)),
        "BELOW_LIMIT": bool(flags & BELOW_LIMIT) == (-math.inf < command < low),
        "ABOVE_LIMIT": bool(flags & ABOVE_LIMIT) == (high < command < math.inf),
        "RATE": bool(flags & RATE) == (setpoint != goal),
        "BAD_PREVIOUS": bool(flags & BAD_PREVIOUS) == (not low <= case.previous <= high),
        "NOT_PERMITTED": bool(flags & NOT_PERMITTED) == (not follows),
    }


def violations(gate: Gate, cases: list[Case]) -> Iterator[str]:
    """Where the gate breaks its contract, in words."""
    for case, (setpoint, flags) in zip(cases, gate.all(cases), strict=True):
        for promise, kept in promises(gate, case, setpoint, flags).items():
            if not kept:
                yield f"{case}: {setpoint!r}, flags {flags}: not {promise}"


def cable(gate: Gate) -> tuple[float, float, float]:
    """Minimum-tension torque, largest torque, largest step."""
    limits = gate.limits[CABLE]
    return limits.safe, limits.high, limits.step


def test_a_command_within_the_limits_passes_unchanged(gate: Gate) -> None:
    minimum, _, step = cable(gate)
    command = gate.round(minimum + 0.5 * step)
    assert gate(minimum, command) == (command, PASSED)


def test_a_nan_becomes_the_minimum_tension_torque(gate: Gate) -> None:
    minimum, _, _ = cable(gate)
    assert gate(minimum, math.nan) == (minimum, NOT_FINITE)


def test_a_nan_far_from_the_minimum_tension_is_still_cut_to_one_step(gate: Gate) -> None:
    _, limit, step = cable(gate)
    assert gate(limit, math.nan) == (gate.round(limit - step), NOT_FINITE | RATE)


def test_a_cable_is_never_pushed(gate: Gate) -> None:
    _, _, step = cable(gate)
    assert gate(gate.round(0.5 * step), -1.0) == (0.0, BELOW_LIMIT)


def test_a_torque_beyond_the_limit_is_cut_to_it(gate: Gate) -> None:
    _, limit, step = cable(gate)
    assert gate(gate.round(limit - 0.5 * step), 2 * limit) == (limit, ABOVE_LIMIT)


def test_a_jump_is_cut_to_one_step_in_both_directions(gate: Gate) -> None:
    _, limit, step = cable(gate)
    assert gate(0.0, limit) == (step, RATE)
    assert gate(limit, 0.0) == (gate.round(limit - step), RATE)


def test_a_damaged_memory_of_the_last_torque_counts_as_zero(gate: Gate) -> None:
    _, limit, step = cable(gate)
    for previous in (math.nan, math.inf, -limit, 2 * limit):
        assert gate(previous, limit) == (step, RATE | BAD_PREVIOUS)


def test_a_motor_that_may_not_follow_goes_to_rest_at_the_rate_of_the_gate(gate: Gate) -> None:
    _, limit, step = cable(gate)
    answer = gate.all([Case(CABLE_BY_LIMITS, REST, limit, limit)])
    assert answer == [(gate.round(limit - step), RATE | NOT_PERMITTED)]


def test_a_motor_without_power_rests_at_once(gate: Gate) -> None:
    _, limit, _ = cable(gate)
    assert gate.all([Case(CABLE_BY_LIMITS, NOTHING, limit, limit)]) == [(0.0, NOT_PERMITTED)]


def test_a_base_may_push_as_it_may_pull(gate: Gate) -> None:
    low = gate.limits[BASE].low
    assert gate.all([Case(BASE, COMMAND, low, low), Case(BASE, COMMAND, low, -1.0)]) == [
        (low, PASSED),
        (low, BELOW_LIMIT),
    ]


def test_the_contract_holds_for_all_corners_and_random_cases(gate: Gate) -> None:
    assert [*violations(gate, corners(gate) + random_cases(gate))] == []


def covered(folder: Path, cases_of: str) -> dict[str, float]:
    """Shares of lines, conditions evaluated and condition outcomes seen, in percent (gcov)."""
    gate = build(folder, GATE, "double", "-O0", "--coverage")
    gate.all(corners(gate) if cases_of == "corners" else [Case(CABLE, COMMAND, 0.0, 0.0)])
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
    (" != ", " == "),
    (" == ", " != "),
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
    ("TB_C(0.0)", "TB_TORQUE_STEP"),
    ("= TB_TORQUE_LIMIT", "= TB_TORQUE_STEP"),
    ("= TB_TORQUE_STEP", "= TB_TORQUE_LIMIT"),
    ("TB_DRUM_RADIUS * TB_TENSION_MIN", "TB_C(0.0)"),
    ("limits->low", "limits->high"),
    ("limits->high", "limits->low"),
    ("limits->low", "TB_C(0.0)"),
    ("limits->high", "TB_TORQUE_LIMIT"),
    ("limits->step", "TB_TORQUE_STEP"),
    ("limits->safe", "limits->rest"),
    ("limits->rest", "limits->safe"),
    ("limits->rest", "TB_C(0.0)"),
    ("limits->safe", "TB_C(0.0)"),
    ("return limits->low;", "return command;"),
    ("return limits->high;", "return command;"),
    ("return limits->safe;", "return command;"),
    ("return previous + step;", "return previous;"),
    ("return previous - step;", "return previous;"),
    ("return command;", "return TB_C(0.01);"),
    ("return flags;", "return TB_GATE_PASSED;"),
    ("= TB_GATE_PASSED", "= TB_GATE_RATE"),
    ("TB_PERMIT_COMMAND", "TB_PERMIT_REST"),
    ("TB_PERMIT_COMMAND", "TB_PERMIT_NOTHING"),
    ("TB_PERMIT_NOTHING", "TB_PERMIT_REST"),
    ("TB_PERMIT_NOTHING", "TB_PERMIT_COMMAND"),
]
#: Statements that change something; each is deleted once.
STATEMENT = re.compile(r"^ +(?!return|real_t|const|uint32_t)[\w*>-]+ (?:=|\|=) .*;$", re.M)


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
    places += [(match.start(), match.group(), "") for match in STATEMENT.finditer(source)]
    return [
        (
            f"line {source[:at].count(chr(10)) + 1}: {old!r} -> {new!r}",
            source[:at] + new + source[at + len(old) :],
        )
        for at, old, new in places
    ]


def survives(folder: Path, mutated: str, cases: dict[str, list[Case]]) -> bool:
    """Whether a mutant keeps the contract in both precisions."""
    source = folder / "torque_gate.c"
    source.write_text(mutated)
    for precision in PRECISIONS:
        gate = build(folder, source, precision, "-O0", "-w")
        if any(violations(gate, cases[precision])):
            return False
    return True


def test_every_mutant_of_the_gate_is_found_out(tmp_path: Path) -> None:
    seeded = mutants()
    assert len(seeded) >= 90
    assert sum("-> ''" in change for change, _ in seeded) >= 7
    cases = {p: corners(build(tmp_path, GATE, p, "-O0", "-w")) for p in PRECISIONS}
    assert survives(tmp_path, GATE.read_text(), cases), "the gate itself must keep the contract"
    assert [change for change, mutated in seeded if survives(tmp_path, mutated, cases)] == []
