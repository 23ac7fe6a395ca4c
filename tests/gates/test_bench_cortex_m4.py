"""Instructions per call on an emulated Cortex-M4F: the counter counts, and ours stays ahead."""

from pathlib import Path

import numpy as np
import pytest
from unicorn import UcError

from turnbuckle.lab.benchmark.cortex_m4.build import program
from turnbuckle.lab.benchmark.cortex_m4.comparison import COMMON, CountRow, count_instructions
from turnbuckle.lab.benchmark.cortex_m4.emulator import DATA, Emulator
from turnbuckle.model.reading import load_machine

ROOT = Path(__file__).parents[2]
C = """
__attribute__((naked)) void three(void) { __asm volatile("nop\\n nop\\n bx lr"); }
__attribute__((naked)) void wide(void) { __asm volatile("vadd.f32 s0, s0, s0\\n nop.w\\n bx lr"); }
__attribute__((naked)) void skipped(void)
{
    __asm volatile("cmp r0, #0\\n ittt eq\\n addeq r1, #1\\n addeq r1, #1\\n"
                   " addeq r1, #1\\n bx lr");
}
__attribute__((naked)) void loop(void)
{
    __asm volatile("1: subs r0, #1\\n bne 1b\\n bx lr");
}
__attribute__((naked)) void acquire(void) { __asm volatile(".inst.w 0xE8D10FAF\\n bx lr"); }
__attribute__((naked)) void maximum(void) { __asm volatile(".inst.w 0xFE800A20\\n bx lr"); }
__attribute__((naked)) void twice(void) { __asm volatile(".inst.w 0xEE300B00\\n bx lr"); }
void spin(void) { for (;;) { __asm volatile("nop"); } }
void sum(const float a[], const float b[], int n, float *total, const float *scale)
{
    float result = 0.0F;
    for (int i = 0; i < n; i++) { result += a[i] * b[i]; }
    *total = result / *scale;
}
"""


@pytest.fixture(scope="module")
def emulator(tmp_path_factory: pytest.TempPathFactory) -> Emulator:
    source = tmp_path_factory.mktemp("cortex") / "small.c"
    source.write_text(C)
    return Emulator(program("small", [source], ()))


@pytest.fixture(scope="module")
def counts() -> list[CountRow]:
    machine = load_machine(ROOT / "machines" / "yoon2023.toml")
    return count_instructions(machine, ROOT / "generated" / "yoon2023", count=3, seed=5)


def mean(counts: list[CountRow], function: str, generator: str) -> float:
    (row,) = (r for r in counts if (r.function, r.generator) == (function, generator))
    return row.mean


@pytest.mark.parametrize(
    ("function", "argument", "instructions"),
    [("three", 0, 3), ("wide", 0, 3), ("skipped", 0, 6), ("skipped", 1, 6), ("loop", 50, 101)],
)
def test_instructions_are_counted_as_they_run(
    emulator: Emulator, function: str, argument: int, instructions: int
) -> None:
    assert emulator.call(function, argument) == instructions


@pytest.mark.parametrize("function", ["acquire", "maximum", "twice"])
def test_an_instruction_that_a_cortex_m4_lacks_is_refused(
    emulator: Emulator, function: str
) -> None:
    """LDA r0, [r1] and VMAXNM.F32 of a Cortex-M33, VADD.F64 of a Cortex-M7."""
    with pytest.raises(UcError, match="Invalid instruction"):
        emulator.call(function, 0, DATA)


def test_single_precision_is_that_of_the_host(emulator: Emulator) -> None:
    emulator.free_all()
    a = np.array([0.1, 0.2, 0.3], np.float32)
    b = np.array([0.7, 0.5, 0.9], np.float32)
    total = emulator.place_floats([0.0])
    scale = emulator.place_floats([3.0])
    emulator.call("sum", emulator.place_floats(a), emulator.place_floats(b), 3, total, scale)
    expected = np.float32(0)
    for x, y in zip(a, b, strict=True):
        expected = np.float32(expected + np.float32(x * y))
    assert emulator.read_floats(total, 1)[0] == np.float32(expected / np.float32(3))


def test_a_function_that_hangs_is_caught(
    emulator: Emulator, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("turnbuckle.lab.benchmark.cortex_m4.emulator.MOST_INSTRUCTIONS", 10_000)
    with pytest.raises(RuntimeError, match="spin did not return"):
        emulator.call("spin")


def test_counts_repeat_exactly(emulator: Emulator) -> None:
    emulator.free_all()
    values = emulator.place_floats(np.ones(64))
    counted = {emulator.call("sum", values, values, 64, values, values) for _ in range(3)}
    assert len(counted) == 1


@pytest.mark.parametrize("function", COMMON)
def test_a_kinematic_function_costs_a_tenth_of_casadis_documented_c(
    counts: list[CountRow], function: str
) -> None:
    peer = mean(counts, function, "CasADi as documented")
    assert mean(counts, function, "turnbuckle") <= peer / 10


def test_the_tension_solve_costs_a_fiftieth_of_casadis_best(counts: list[CountRow]) -> None:
    peer = mean(counts, "distribute_tension", "CasADi remapped")
    assert mean(counts, "distribute_tension", "turnbuckle") <= peer / 50


def test_the_controller_step_costs_a_tenth_of_casadis_best(counts: list[CountRow]) -> None:
    peer = mean(counts, "controller step", "CasADi remapped")
    assert mean(counts, "controller step", "turnbuckle") <= peer / 10


@pytest.mark.parametrize("generator", ["turnbuckle", "CasADi remapped", "SymPy", "SymPy own Pow"])
def test_what_is_counted_answers_right(counts: list[CountRow], generator: str) -> None:
    errors = [r.error for r in counts if r.function in COMMON and r.generator == generator]
    assert len(errors) == len(COMMON)
    assert max(errors) <= 8 * np.finfo(np.float32).eps


def test_our_tensions_answer_right_in_single_precision(counts: list[CountRow]) -> None:
    (error,) = (
        r.error for r in counts if (r.function, r.generator) == ("distribute_tension", "turnbuckle")
    )
    assert error <= 2**10 * np.finfo(np.float32).eps * 10.0
