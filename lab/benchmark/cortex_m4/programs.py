"""The programs that are counted: each answers a function of the model in its own C."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import casadi as ca
import numpy as np
from sympy.printing.c import C99CodePrinter

from turnbuckle.lab.benchmark.cortex_m4.build import program
from turnbuckle.lab.benchmark.cortex_m4.emulator import Emulator, Floats
from turnbuckle.lab.benchmark.cortex_m4.sympy_c import product_printer, stock_printer, sympy_c
from turnbuckle.lab.benchmark.native import BUILD, ROOT
from turnbuckle.lab.benchmark.solvers.qrqp import generate_c, work_sizes
from turnbuckle.lab.benchmark.step.comparison import layout
from turnbuckle.lab.benchmark.step.model_step import ModelStep
from turnbuckle.model.symbolic.function import ModelFunction

FOLDER = Path(__file__).parent
CORE = ROOT / "runtime" / "core"
STEP = ROOT / "lab" / "benchmark" / "step"

#: Inputs, one array an argument -> outputs one after the other, and the instructions it took.
Counted = Callable[[Sequence[Floats]], tuple[Floats, float]]

OUR_FLAGS = ("-std=c11", "-DTB_REAL_FLOAT")
#: The second: CasADi's smallest double is zero in single precision, and qrqp then never ends.
CASADI_FLAGS = ("-std=gnu11", "-Dcasadi_real=float", "-Dcasadi_real_min=1.17549435e-38F")
#: CasADi as documented, and with the names of the mathematics remapped by hand.
CASADI_VARIANTS = {
    "CasADi as documented": (),
    "CasADi remapped": (
        "-fsingle-precision-constant",
        "-include",
        str(FOLDER / "float_math.h"),
    ),
}


@dataclass(frozen=True)
class Program:
    """One generator's C for one function."""

    generator: str
    run: Counted


@cache
def our_emulator(generated: Path) -> Emulator:
    """One program with all our functions."""
    flags = (*OUR_FLAGS, f"-I{generated}")
    return Emulator(program("turnbuckle", sorted(generated.glob("*.c")), flags))


def our_program(name: str, sizes: Sequence[int], generated: Path) -> Program:
    """Ours in single precision, as shipped; `sizes` of the function's outputs."""
    emulator = our_emulator(generated)

    def run(inputs: Sequence[Floats]) -> tuple[Floats, float]:
        emulator.free_all()
        given = [emulator.place_floats(values) for values in inputs]
        results = [emulator.place_floats(np.zeros(size)) for size in sizes]
        instructions = emulator.call(f"tb_{name}", *given, *results)
        return read_all(emulator, results, sizes), instructions

    return Program("turnbuckle", run)


def read_all(emulator: Emulator, addresses: Sequence[int], sizes: Sequence[int]) -> Floats:
    """Arrays from RAM, one after the other."""
    return np.concatenate(
        [emulator.read_floats(*part) for part in zip(addresses, sizes, strict=True)]
    )


def casadi_program(function: ca.Function, generator: str, flags: Sequence[str]) -> Program:
    """CasADi's C with casadi_real=float; `flags` may say more."""
    name = function.name()
    source = generate_c(function)
    options = (*CASADI_FLAGS, *flags)
    emulator = Emulator(program(f"{name}_{len(flags)}", [source], options))
    sizes = [function.numel_out(k) for k in range(function.n_out())]

    def run(inputs: Sequence[Floats]) -> tuple[Floats, float]:
        emulator.free_all()
        given = [emulator.place_floats(values) for values in inputs]
        results = [emulator.place_floats(np.zeros(size)) for size in sizes]
        arguments = emulator.place_words(given + [0] * (function.sz_arg() - len(given)))
        places = emulator.place_words(results + [0] * (function.sz_res() - len(results)))
        integers = emulator.place(bytes(8 * (function.sz_iw() + 1)))
        work = emulator.place(bytes(8 * (function.sz_w() + 1)))
        instructions = emulator.call(name, arguments, places, integers, work, 0)
        return read_all(emulator, results, sizes), instructions

    return Program(generator, run)


def casadi_programs(function: ca.Function) -> Iterator[Program]:
    """CasADi as documented, and with the names of the mathematics remapped to float."""
    for generator, flags in CASADI_VARIANTS.items():
        yield casadi_program(function, generator, flags)


def sympy_program(function: ModelFunction, generator: str, printer: C99CodePrinter) -> Program:
    """SymPy's C."""
    name = f"sympy_{function.name}_{type(printer).__name__}"
    source = BUILD / f"{name}.c"
    source.write_text(sympy_c(function, printer))
    emulator = Emulator(program(name, [source], ("-std=c11",)))
    size = sum(output.size for output in function.outputs)

    def run(inputs: Sequence[Floats]) -> tuple[Floats, float]:
        emulator.free_all()
        given = emulator.place_floats(np.concatenate(inputs))
        results = emulator.place_floats(np.zeros(size))
        instructions = emulator.call(function.name, given, results)
        return emulator.read_floats(results, size), instructions

    return Program(generator, run)


def sympy_programs(function: ModelFunction) -> Iterator[Program]:
    """SymPy as it is, and with powers printed as products."""
    yield sympy_program(function, "SymPy", stock_printer())
    yield sympy_program(function, "SymPy own Pow", product_printer())


def our_step_program(generated: Path, cycles: int) -> Program:
    """The runtime's step, through the adapter that is also timed on the host."""
    sources = [
        *sorted(generated.glob("*.c")),
        *sorted(CORE.glob("*.c")),
        STEP / "turnbuckle_step.c",
    ]
    flags = (*OUR_FLAGS, "-DSTEP_REAL=float", f"-I{generated}", f"-I{CORE}")
    return Program("turnbuckle", per_cycle(program("turnbuckle_step", sources, flags), cycles))


def casadi_step_programs(model: ModelStep, cycles: int) -> Iterator[Program]:
    """CasADi's step, through the same adapter."""
    function = model.function("casadi_step_model")
    sources = [generate_c(function), STEP / "casadi_step.c"]
    sizes = [*work_sizes(function), *layout(model)]
    for generator, more in CASADI_VARIANTS.items():
        flags = (*CASADI_FLAGS, "-DSTEP_REAL=float", f"-I{BUILD}", *sizes, *more)
        name = f"casadi_step_{len(more)}"
        yield Program(generator, per_cycle(program(name, sources, flags), cycles))


def per_cycle(path: Path, cycles: int) -> Counted:
    """Run a motion from rest; instructions per cycle, the start included."""
    emulator = Emulator(path)

    def run(inputs: Sequence[Floats]) -> tuple[Floats, float]:
        emulator.free_all()
        given = emulator.place_floats(inputs[0])
        results = emulator.place_floats(np.zeros(8 * cycles))
        instructions = emulator.call("run_steps", cycles, given, results)
        return emulator.read_floats(results, 8 * cycles), instructions / cycles

    return run
