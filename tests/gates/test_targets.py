"""Linux on other processors: everything compiles, links and runs there, and gives the same bits."""

import json
import re
import signal
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from running import running, silent_lines

from turnbuckle.codegen.bind import REALS, Generated, Port, batch_source, signatures
from turnbuckle.codegen.compile import FLAGS, PRECISIONS
from turnbuckle.codegen.generate import MANIFEST
from turnbuckle.codegen.hard_cases import HardSampler
from turnbuckle.codegen.verify import call
from turnbuckle.lab.lockstep import State
from turnbuckle.model.machine import Machine

RUNTIME = Path(__file__).parents[2] / "runtime"
PARTS = ("core", "canopen", "can", "port/linux")
SEAL = RUNTIME / "port" / "linux" / "seal.c"
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wdouble-promotion", "-Werror"]
FAULT = State.FAULT
POINTS = 400


@dataclass(frozen=True)
class Target:
    """A processor: how to compile for it, how to run what was compiled."""

    triple: str
    emulator: str
    macro: str
    """What tells the processor in seal.c."""

    @property
    def compiler(self) -> str:
        """The cross compiler."""
        return f"{self.triple}-gcc"

    @property
    def run(self) -> list[str]:
        """What a program is started with."""
        return [self.emulator, "-L", f"/usr/{self.triple}"]


TARGETS = {
    "AArch64": Target("aarch64-linux-gnu", "qemu-aarch64", "__aarch64__"),
    "ARMv7": Target("arm-linux-gnueabihf", "qemu-arm", "__arm__"),
    "RISC-V 64": Target("riscv64-linux-gnu", "qemu-riscv64", "__riscv"),
}


@pytest.fixture(scope="module")
def programs(stock_folder: Path, tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """The executable of the stock machine for every processor."""
    folder = tmp_path_factory.mktemp("targets")
    include = [stock_folder, *(RUNTIME / part for part in PARTS)]
    sources = [str(source) for each in include for source in sorted(each.glob("*.c"))]
    built = {}
    for name, target in TARGETS.items():
        built[name] = folder / target.triple
        command = [target.compiler, *FLAGS, *WARNINGS, *(f"-I{each}" for each in include)]
        done = subprocess.run(
            [*command, *sources, "-o", str(built[name]), "-lm"],
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.stderr == "", name
    return built


@pytest.mark.parametrize("name", TARGETS)
def test_the_executable_is_built_and_starts(name: str, programs: dict[str, Path]) -> None:
    done = subprocess.run(
        [*TARGETS[name].run, programs[name], "--version"],
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout.startswith("yoon2023 ")


def allowed(target: Target) -> set[str]:
    """System calls that the seal lets through on a processor."""
    command = [target.compiler, "-E", "-P", "-D_GNU_SOURCE", "-"]
    text = re.sub(r"#define ALLOW_CALL.*", "", SEAL.read_text())
    text = re.sub(r"#include.*", "", text)
    done = subprocess.run(command, input=text, capture_output=True, text=True, check=True)
    return set(re.findall(r"ALLOW_CALL\((\w+)\)", done.stdout))


def cyclic_calls(target: Target, program: Path, clock: str, folder: Path) -> set[str]:
    """System calls from where the program would be sealed until its end, in the emulator."""
    trace = folder / "trace"
    emulated = [*target.run, "-strace", "-D", str(trace)]
    with silent_lines() as lines:
        chosen = lines.options if clock == "simulated" else lines.real_time_options
        options = [*chosen, "--priority=0", "--cpu=0", f"--record={folder / 'dump'}"]
        with running(program, options, emulated) as run:
            run.await_state(FAULT)  # bring-up, a fault and its words included
            status, _, err = run.end(signal.SIGTERM)
            assert status == 1, err
    traced = re.findall(r"^(\d+) (\w+)\(", trace.read_text(), re.MULTILINE)
    process = next(number for number, call in traced if call == "sched_setaffinity")
    calls = [call for number, call in traced if number == process]  # the writer is not sealed
    return set(calls[calls.index("sched_setaffinity") + 1 :])


@pytest.mark.parametrize(
    ("name", "clock"),
    [*((name, "simulated") for name in TARGETS), ("ARMv7", "real")],
)
def test_the_seal_allows_what_the_cyclic_path_calls(
    name: str, clock: str, programs: dict[str, Path], tmp_path: Path
) -> None:
    target = TARGETS[name]
    calls = cyclic_calls(target, programs[name], clock, tmp_path)
    assert {"read", "write", "close", "exit_group"} <= calls
    assert calls <= allowed(target)
    if name == "ARMv7":  # the calls of 64 bits alone would not do
        assert not calls <= allowed(TARGETS["AArch64"])


#: Reads the arguments of every function from a pipe, and writes what the functions give.
MAIN = """
#include <stddef.h>
#include <stdio.h>
#include "tb_types.h"
{prototypes}
static real_t room[{room}][{most}];
static int status[{count}];
static int take(real_t *to, size_t size) {{ return fread(to, sizeof *to, size, stdin) == size; }}
static void give(const real_t *from, size_t size) {{ fwrite(from, sizeof *from, size, stdout); }}
int main(void)
{{
{calls}
    return 0;
}}
"""


def written(functions: list[tuple[str, list[Port], list[Port]]]) -> str:
    """The program for some functions."""
    prototypes, calls = [], []
    for name, inputs, outputs in functions:
        ins = ", ".join(["const real_t *, size_t"] * len(inputs))
        outs = ", ".join(["real_t *"] * len(outputs))
        prototypes.append(f"void batch_{name}(size_t, {ins}, {outs}, int *);")
        taken = [f"take(room[{i}], {POINTS * port.size})" for i, port in enumerate(inputs)]
        passed = [f"room[{i}], {port.size}" for i, port in enumerate(inputs)]
        results = [f"room[{len(inputs) + i}]" for i in range(len(outputs))]
        calls.append(f"    if (!({' && '.join(taken)})) {{ return 1; }}")
        calls.append(f"    batch_{name}({POINTS}, {', '.join(passed + results)}, status);")
        calls += [
            f"    give({room}, {POINTS * port.size});"
            for room, port in zip(results, outputs, strict=True)
        ]
        calls.append(f"    fwrite(status, sizeof *status, {POINTS}, stdout);")
    ports = [port for _, inputs, outputs in functions for port in (*inputs, *outputs)]
    return MAIN.format(
        prototypes="\n".join(prototypes),
        calls="\n".join(calls),
        room=max(len(inputs) + len(outputs) for _, inputs, outputs in functions),
        most=POINTS * max(port.size for port in ports),
        count=POINTS,
    )


@dataclass(frozen=True)
class Recorded:
    """Arguments of all functions, and what they give on this computer."""

    arguments: bytes
    results: bytes


def recorded(machine: Machine, generated: Generated) -> Recorded:
    """Every function at many points, the difficult ones among them."""
    sampler, real = HardSampler(machine, 81, POINTS), REALS[generated.precision]
    arguments: list[NDArray[Any]] = []
    results: list[NDArray[Any]] = []
    for name, function in generated.functions.items():
        given = [
            sampler.argument(name, p.name, p.size).reshape(POINTS, *p.shape).astype(real)
            for p in function.inputs
        ]
        answer = call(function, given)
        arguments += given
        results += [answer[port.name] for port in function.outputs]
        results.append(answer["status"].astype(np.intc))
    joined = (b"".join(array.tobytes() for array in arrays) for arrays in (arguments, results))
    return Recorded(*joined)


def computed(target: Target, generated: Generated, given: bytes, folder: Path, *more: str) -> bytes:
    """What a processor gives for these arguments."""
    content = json.loads((generated.folder / MANIFEST).read_text())
    main = folder / "main.c"
    main.write_text(written(list(signatures(content))))
    sources = [*sorted(generated.folder.glob("*.c")), batch_source(generated.folder, content), main]
    flags = [*FLAGS, *PRECISIONS[generated.precision], *more, f"-I{generated.folder}"]
    command = [target.compiler, *flags, *map(str, sources), "-o", str(folder / "main"), "-lm"]
    subprocess.run(command, check=True)
    done = subprocess.run(
        [*target.run, str(folder / "main")], input=given, capture_output=True, check=True
    )
    return done.stdout


@pytest.mark.parametrize("name", TARGETS)
@pytest.mark.parametrize("precision", PRECISIONS)
def test_every_processor_gives_the_same_bits(
    name: str, precision: str, stock: Machine, request: pytest.FixtureRequest, tmp_path: Path
) -> None:
    generated: Generated = request.getfixturevalue("double" if precision == "double" else "single")
    known = recorded(stock, generated)
    assert len(known.results) > 100_000
    assert computed(TARGETS[name], generated, known.arguments, tmp_path) == known.results


def test_fused_multiplications_would_be_noticed(
    stock: Machine, double: Generated, tmp_path: Path
) -> None:
    known = recorded(stock, double)
    fused = computed(
        TARGETS["AArch64"], double, known.arguments, tmp_path, "-O2", "-ffp-contract=fast"
    )
    assert len(fused) == len(known.results)
    assert fused != known.results
