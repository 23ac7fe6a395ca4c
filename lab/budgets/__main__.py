"""Measures what the stock machines cost a Cortex-M4F; writes docs/budgets, and README.md's table.

With names of machines, those alone; with --check nothing is written, and a figure that is off its
budget by more than 3 % ends it with status 1.
"""

import argparse
import sys
from collections.abc import Sequence

from turnbuckle.lab.budgets.budget import Budget, committed, of_counts, of_image, read
from turnbuckle.lab.budgets.cycle import Counts
from turnbuckle.lab.budgets.image import bare_image
from turnbuckle.lab.budgets.measure import GENERATED, counts_of, machines
from turnbuckle.lab.budgets.table import PAGE, with_table
from turnbuckle.model.files import write_whole

SHOWN = 10
"""Functions that are shown, those that take most."""


def main(words: Sequence[str] | None = None) -> int:
    """The exit status."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("machine", nargs="*", default=machines())
    parser.add_argument("--check", action="store_true")
    chosen = parser.parse_args(words)
    if unknown := set(chosen.machine) - set(machines()):
        parser.error(f"found {', '.join(unknown)}; allowed: {', '.join(machines())}")
    complaints = []
    for name in chosen.machine:
        budget = measured(name)
        if chosen.check:
            complaints += read(budget.path).complaints(budget.figures)
        else:
            write_whole(budget.path, budget.text())
    if not chosen.check:
        write_whole(PAGE, with_table(PAGE.read_text(), committed()))
    print("\n".join(complaints), end="\n" if complaints else "")
    return 1 if complaints else 0


def measured(name: str) -> Budget:
    """The budget of a machine as it is now, told to whoever looks."""
    counts = counts_of(name)
    figures = of_counts(counts) | of_image(bare_image(GENERATED / name))
    print(f"{name}: {', '.join(f'{each} {value}' for each, value in figures.items())}")
    tell(counts)
    return Budget(name, figures)


def tell(counts: Counts) -> None:
    """What takes most."""
    whole = sum(counts.cycles)
    for function, count in counts.by_function.most_common(SHOWN):
        print(f"  {count / len(counts.cycles):8.0f} {count / whole:5.1%}  {function}")


if __name__ == "__main__":
    sys.exit(main())
