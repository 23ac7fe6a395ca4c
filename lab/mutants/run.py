"""Tries many mutants, some at a time."""

import os
from collections.abc import Callable, Sequence

from turnbuckle.lab.mutants.draw import sources
from turnbuckle.lab.mutants.kept import Verdicts
from turnbuckle.lab.mutants.mutation import Mutation
from turnbuckle.lab.mutants.suites import suite_of
from turnbuckle.lab.mutants.trial import Trial, Verdict

Told = Callable[[Mutation, Verdict], None]


class UnchangedFails(Exception):
    """The tests fail without any mutant; the text says which one."""


def unchanged_passes(tests: Sequence[str]) -> None:
    """Run tests once on the runtime as it is.

    Raises UnchangedFails: what these tests say of mutants would mean nothing.
    """
    file, text = next(iter(sources().items()))
    trial = Trial(file, text, tests)
    verdict = trial.verdict(os.waitpid(trial.process, 0)[1])
    if verdict.killer:
        raise UnchangedFails(f"{verdict.killer} {verdict.how} on the unchanged runtime")


def verdicts(
    mutants: Sequence[Mutation],
    kept: Verdicts,
    processes: int,
    told: Told,
    suite: Callable[[str], Sequence[str]] = suite_of,
) -> None:
    """Try the mutants of which nothing is kept; tells each verdict when it is there."""
    waiting, running = list(mutants), dict[int, tuple[Mutation, Trial]]()
    while waiting or running:
        while waiting and len(running) < processes:
            mutant = waiting.pop(0)
            if known := kept.find(mutant):
                told(mutant, known)
                continue
            tests = (*kept.last_killer(mutant), *suite(mutant.file))
            trial = Trial(mutant.file, mutant.of(kept.sources[mutant.file]), tests)
            running[trial.process] = mutant, trial
        if running:
            process, status = os.wait()
            mutant, trial = running.pop(process)
            verdict = trial.verdict(status)
            kept.keep(mutant, verdict)
            told(mutant, verdict)
