"""The same run twice, in two processes side by side."""

import multiprocessing
from collections.abc import Callable, Mapping
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess
from pathlib import Path

from turnbuckle.codegen.bind import Generated
from turnbuckle.lab.demo import plan_task, plant_of
from turnbuckle.lab.soak.run import Finding, SoakRun
from turnbuckle.model.reading import load_machine

Progress = Callable[[int], None]
"""Told how many cycles of work both runs together have done."""


class SoakError(Exception):
    """A run ended before its time; the text says how."""


def soak_twice(machine: Path, folder: Path, cycles: int, progress: Progress) -> list[Finding]:
    """Run a machine, with its generated C in a folder, twice for so many cycles of work.

    Raises SoakError when one of the two dies.
    """
    context = multiprocessing.get_context("spawn")
    runs: dict[Connection, BaseProcess] = {}
    for _ in range(2):
        ours, theirs = context.Pipe(duplex=False)
        process = context.Process(target=soak, args=(machine, folder, cycles, theirs), daemon=True)
        process.start()
        theirs.close()
        runs[ours] = process
    return listen(runs, progress)


def listen(runs: Mapping[Connection, BaseProcess], progress: Progress) -> list[Finding]:
    """Tell how far the runs are, until each has told what it found."""
    done = dict.fromkeys(runs, 0)
    findings: dict[Connection, Finding] = {}
    while len(findings) < len(runs):
        for line in wait([line for line in runs if line not in findings]):
            assert isinstance(line, Connection)
            told = hear(line, runs[line])
            if isinstance(told, Finding):
                findings[line] = told
            else:
                done[line] = told
        progress(sum(done.values()))
    return [findings[line] for line in runs]


def hear(line: Connection, process: BaseProcess) -> int | Finding:
    """What a run tells next: how far it is, or at its end what it found."""
    try:
        told: int | Finding = line.recv()
    except EOFError:
        process.join()
        raise SoakError(f"a run ended before its time, with exit code {process.exitcode}") from None
    return told


def soak(machine: Path, folder: Path, cycles: int, line: Connection) -> None:
    """One run; tells how far it is, and at the end what it found."""
    generated = Generated(load_machine(machine), folder, "double")
    run = SoakRun(generated, plant_of(generated.machine), plan_task(generated))
    line.send(run.run(cycles, line.send))
