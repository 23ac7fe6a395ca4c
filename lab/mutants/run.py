"""Tries many mutants, some at a time."""

import os
from collections.abc import Callable, Sequence

from lab.mutants.draw import sources
from lab.mutants.kept import Verdicts
from lab.mutants.mutation import Mutation
from lab.mutants.suites import suite_of
from lab.mutants.trial import Trial, Verdict, prepare

Told = Callable[[Mutation, Verdict], None]


class UnchangedFails(Exception):
    """The tests fail without any mutant; the text says which one."""


def unchanged_passes(files: Sequence[str]) -> None:
    """Run the tests of some files once on the runtime as it is.

    Raises UnchangedFails: what these tests say of mutants would mean nothing.
    """
    prepare()
    tests = list(dict.fromkeys(test for file in files for test in suite_of(file)))
    trial = Trial(files[0], sources()[files[0]], tests)
    verdict = trial.verdict(os.waitpid(trial.process, 0)[1])
    if verdict.killer:
        raise UnchangedFails(f"{verdict.killer} {verdict.how} on the unchanged runtime")


def verdicts(mutants: Sequence[Mutation], kept: Verdicts, processes: int, told: Told) -> None:
    """Try the mutants of which nothing is kept; tells each verdict when it is there."""
    prepare()
    texts = sources()
    waiting, running = list(mutants), dict[int, tuple[Mutation, Trial]]()
    while waiting or running:
        while waiting and len(running) < processes:
            mutant = waiting.pop(0)
            text = texts[mutant.file]
            if known := kept.find(mutant, text):
                told(mutant, known)
                continue
            tests = (*kept.last_killer(mutant, text), *suite_of(mutant.file))
            trial = Trial(mutant.file, mutant.of(text), tests)
            running[trial.process] = mutant, trial
        if running:
            process, status = os.wait()
            mutant, trial = running.pop(process)
            verdict = trial.verdict(status)
            kept.keep(mutant, texts[mutant.file], verdict)
            told(mutant, verdict)
