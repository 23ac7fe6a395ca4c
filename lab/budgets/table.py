"""The table of the budgets in README.md, between two marks."""

from collections.abc import Sequence
from pathlib import Path

from turnbuckle.lab.budgets.budget import Budget

PAGE = Path(__file__).parents[3] / "README.md"
BEGIN, END = "<!-- budgets: begin -->\n", "<!-- budgets: end -->\n"
COLUMNS = ("", "cycle in RUN", "controller step in it", "flash", "RAM", "stack of a cycle")
COUNTS, SIZES = ("cycle", "step"), ("flash", "memory", "stack")


def table(budgets: Sequence[Budget]) -> str:
    """A row a machine."""
    rows = [COLUMNS, ("---",) * len(COLUMNS), *map(cells, budgets)]
    return "".join(f"| {' | '.join(row)} |\n" for row in rows)


def cells(budget: Budget) -> Sequence[str]:
    """Of a row."""
    figures = {name: f"{value:,}".replace(",", " ") for name, value in budget.figures.items()}
    counts = (f"{figures[f'{each}_mean']}, at most {figures[f'{each}_most']}" for each in COUNTS)
    return [f"`{budget.machine}`", *counts, *(f"{figures[each]} B" for each in SIZES)]


def with_table(page: str, budgets: Sequence[Budget]) -> str:
    """A page with the table between its marks; ValueError where it has not both, once."""
    if page.count(BEGIN) != 1 or page.count(END) != 1:
        raise ValueError(f"{PAGE.name} has not one {BEGIN.strip()} and one {END.strip()}")
    before, rest = page.split(BEGIN)
    _, after = rest.split(END)
    return before + BEGIN + table(budgets) + END + after
