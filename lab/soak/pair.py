"""The same run twice, in two processes side by side."""

import multiprocessing
from collections.abc import Callable
from multiprocessing.connection import Connection, wait
from pathlib import Path

from codegen.bind import Generated
from lab.demo import plan_task, plant_of
from lab.soak.run import Finding, SoakRun
from model.machine import load_machine

Progress = Callable[[int], None]
"""Told how many cycles of work both runs together have done."""


def soak_twice(machine: Path, folder: Path, cycles: int, progress: Progress) -> list[Finding]:
    """Run a machine, with its generated C in a folder, twice for so many cycles of work.

    Raises EOFError when one of the two dies.
    """
    context = multiprocessing.get_context("spawn")
    lines: list[Connection] = []
    for _ in range(2):
        ours, theirs = context.Pipe(duplex=False)
        words = machine, folder, cycles, theirs
        context.Process(target=soak, args=words, daemon=True).start()
        theirs.close()
        lines.append(ours)
    return listen(lines, progress)


def listen(lines: list[Connection], progress: Progress) -> list[Finding]:
    """Tell how far the runs are, until each has told what it found."""
    done: dict[Connection, int] = dict.fromkeys(lines, 0)
    findings: dict[Connection, Finding] = {}
    while len(findings) < len(lines):
        for line in wait([line for line in lines if line not in findings]):
            assert isinstance(line, Connection)
            told: int | Finding = line.recv()
            if isinstance(told, Finding):
                findings[line] = told
            else:
                done[line] = told
        progress(sum(done.values()))
    return [findings[line] for line in lines]


def soak(machine: Path, folder: Path, cycles: int, line: Connection) -> None:
    """One run; tells how far it is, and at the end what it found."""
    generated = Generated(load_machine(machine), folder, "double")
    run = SoakRun(generated, plant_of(generated.machine), plan_task(generated))
    line.send(run.run(cycles, line.send))
