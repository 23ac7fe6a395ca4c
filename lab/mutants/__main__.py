"""Tries mutants of the runtime and writes docs/mutants.md; exit status 0 if few survive."""

import argparse
import sys

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from turnbuckle.lab.mutants.draw import drawn
from turnbuckle.lab.mutants.kept import Verdicts
from turnbuckle.lab.mutants.mutation import Mutation
from turnbuckle.lab.mutants.report import REPORT, judge, report
from turnbuckle.lab.mutants.run import UnchangedFails, unchanged_passes, verdicts
from turnbuckle.lab.mutants.suites import every_test
from turnbuckle.lab.mutants.trial import Verdict, prepare
from turnbuckle.model.files import write_whole

COUNT, SEED, PROCESSES = 220, 2026, 2


def main() -> int:
    """Draw, try, write, judge."""
    parser = argparse.ArgumentParser(prog="python -m turnbuckle.lab.mutants", description=__doc__)
    parser.add_argument("--count", type=int, default=COUNT, help=f"of mutants [{COUNT}]")
    count = parser.parse_args().count
    console = Console(stderr=True)
    prepare()
    try:
        unchanged_passes(every_test())
    except UnchangedFails as error:
        console.print(f"{error}: mend that first.")
        return 1
    results = tried(count, console)
    write_whole(REPORT, report(results))
    complaints = judge(results)
    for complaint in complaints:
        console.print(complaint, markup=False, highlight=False)
    return 1 if complaints else 0


def tried(count: int, console: Console) -> list[tuple[Mutation, Verdict]]:
    """Draw so many mutants and try them, with bars on a terminal."""
    columns = (
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        TimeRemainingColumn(),
    )
    results: list[tuple[Mutation, Verdict]] = []
    with Progress(*columns, console=console, disable=not console.is_terminal) as bars:
        drawing = bars.add_task("drawn", total=count)
        mutants = drawn(count, SEED, lambda done: bars.update(drawing, completed=done))
        trying = bars.add_task("tried", total=count)

        def told(mutant: Mutation, verdict: Verdict) -> None:
            results.append((mutant, verdict))
            bars.advance(trying)
            if not verdict.killer:
                console.print(f"survives: {mutant.file}:{mutant.line} {mutant.words}")

        verdicts(mutants, Verdicts(), PROCESSES, told)
    return sorted(results)


if __name__ == "__main__":
    sys.exit(main())
