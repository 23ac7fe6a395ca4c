"""The executable of a machine: generated C, runtime and Linux port, compiled together."""

from pathlib import Path

from turnbuckle.codegen.bind import generate_into_cache
from turnbuckle.codegen.compile import compile_program
from turnbuckle.lab.live import LiveError
from turnbuckle.model.machine import Machine
from turnbuckle.places import RUNTIME

FOLDERS = tuple(RUNTIME / name for name in ("core", "canopen", "can", "port/linux"))


def build_program(machine: Machine, precision: str = "double") -> Path:
    """The machine's executable, in the cache of compiled C.

    Raises LiveError for a machine without buses, CompileError without a working C compiler.
    """
    refuse_without_buses(machine)
    return compile_machine(generate_into_cache(machine), precision)


def compile_machine(folder: Path, precision: str = "double") -> Path:
    """The executable around a machine's generated folder."""
    sources = [path for each in (folder, *FOLDERS) for path in sorted(each.glob("*.c"))]
    return compile_program(sources, [folder, *FOLDERS], precision)


def refuse_without_buses(machine: Machine) -> None:
    """LiveError for a machine that no program can run."""
    if not machine.buses:
        raise LiveError(
            f"{machine.path}: bus: found none; allowed: at least one [[bus]] and a [[drive]] for"
            " every cable and rail, to run the machine"
        )
