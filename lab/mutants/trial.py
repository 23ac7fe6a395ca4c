"""Tries a mutant: runs tests with it in the place of its original, until the first that fails."""

import os
import resource
import shutil
import signal
import sys
import tempfile
from collections.abc import Sequence
from importlib import import_module
from pathlib import Path
from typing import NamedTuple

import pytest

from turnbuckle.lab.mutants.compiler import GCC, MUTANT, OBJECTS, ORIGINAL
from turnbuckle.lab.mutants.objects import ROOT

KEPT = ROOT / "build" / "mutants"
LONGEST = 25
"""Seconds of the processor that one test may take; a loop without an end takes more."""
WALL = 1800
"""Seconds that all of them may take, however busy the computer is."""
#: What the tests import; a mutant's tests run in a fork of the process that has.
IMPORTED = (
    *("numpy", "scipy.optimize", "casadi", "hypothesis", "elftools.elf.elffile"),
    *(
        "pyarrow.parquet",
        "typer.testing",
        "turnbuckle.codegen.verify",
        "turnbuckle.codegen.generate",
    ),
    *(
        "turnbuckle.lab.lockstep",
        "turnbuckle.lab.machine_sim",
        "turnbuckle.lab.demo",
        "turnbuckle.lab.flight.replay",
        "turnbuckle.lab.flight.table",
    ),
)


class Verdict(NamedTuple):
    """What became of a mutant."""

    killer: str
    """The test that noticed; empty: none did."""
    how: str
    """fails, crashes, or does not end."""


SURVIVES = Verdict("", "survives")


class Trial:
    """The tests of one mutant, running in a process of their own."""

    def __init__(self, file: str, mutant: str, tests: Sequence[str]) -> None:
        """file: in runtime/; mutant: its changed text; tests: as pytest takes them, in order."""
        self._folder = Path(tempfile.mkdtemp(prefix="mutant-", dir=made(KEPT)))
        self._seen = self._folder / "seen"
        self._seen.touch()
        changed = self._folder / "changed" / Path(file).name
        made(changed.parent)
        changed.write_text(mutant)
        sys.stdout.flush()
        self.process = os.fork()
        if self.process == 0:
            _run_in_fork(self._folder, ROOT / "runtime" / file, changed, list(tests))

    def verdict(self, status: int) -> Verdict:
        """What the end of the process says (as os.wait gives it); the trial is over then."""
        last = self._seen.read_text().split("\n")[-1]
        output = (self._folder / "output").read_text(errors="replace")
        shutil.rmtree(self._folder)
        if os.WIFSIGNALED(status):
            endless = os.WTERMSIG(status) in (signal.SIGXCPU, signal.SIGALRM, signal.SIGKILL)
            return Verdict(last, "does not end" if endless else "crashes")
        code = os.WEXITSTATUS(status)
        if code == pytest.ExitCode.OK:
            return SURVIVES
        if code in (pytest.ExitCode.TESTS_FAILED, pytest.ExitCode.INTERRUPTED):
            return Verdict(last, "fails")
        raise RuntimeError(f"pytest ended with {code}:\n{output}")


def made(folder: Path) -> Path:
    """The folder, which exists."""
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def prepare() -> None:
    """Import what the tests import, once for all trials."""
    for name in IMPORTED:
        import_module(name)


class _Witness:
    """Writes down which test is running, and lets none run for ever."""

    def __init__(self, seen: Path) -> None:
        self._seen = seen

    def pytest_collectstart(self, collector: pytest.Collector) -> None:
        self._write(collector.nodeid)

    def pytest_runtest_logstart(self, nodeid: str) -> None:
        self._write(nodeid)
        used = resource.getrusage(resource.RUSAGE_SELF)
        limit = int(used.ru_utime + used.ru_stime) + LONGEST
        resource.setrlimit(resource.RLIMIT_CPU, (limit, resource.RLIM_INFINITY))

    def _write(self, name: str) -> None:
        with self._seen.open("a") as file:
            file.write(f"\n{name}")


def _run_in_fork(folder: Path, original: Path, changed: Path, tests: list[str]) -> None:
    """Run the tests, and end this process with the exit status of pytest."""
    code = 70
    try:
        with (folder / "output").open("w") as output:
            os.dup2(output.fileno(), 1)
            os.dup2(output.fileno(), 2)
        signal.alarm(WALL)
        os.chdir(ROOT)
        _take_the_compiler(folder, original, changed)
        options = ["-q", "-x", "-p", "no:cacheprovider", "-p", "no:xdist", "--tb=short"]
        witness = _Witness(folder / "seen")
        code = int(pytest.main([*options, *tests], plugins=[witness])) if tests else 0
    finally:
        sys.stdout.flush()
        os._exit(code)


def _take_the_compiler(folder: Path, original: Path, changed: Path) -> None:
    """From now on `gcc` compiles the mutant, and no library of another one is found."""
    import turnbuckle.codegen.compile

    turnbuckle.codegen.compile.LIBRARIES = folder / "libraries"
    script = made(folder / "bin") / "gcc"
    program = Path(__file__).with_name("compiler.py")
    script.write_text(f'#!/bin/sh\nexec {sys.executable} -I -S {program} "$@"\n')
    script.chmod(0o755)
    os.environ |= {
        GCC: shutil.which("gcc") or "gcc",
        ORIGINAL: str(original),
        MUTANT: str(changed),
        OBJECTS: str(made(KEPT / "objects")),
        "PATH": f"{script.parent}{os.pathsep}{os.environ['PATH']}",
    }
