"""The tables of docs/safety.md, as data."""

import math
import re
from dataclasses import dataclass
from pathlib import Path

from turnbuckle.lab.lockstep import State

DOCUMENT = Path(__file__).parents[1] / "docs" / "safety.md"
STATES = [state.name for state in State]


@dataclass(frozen=True)
class Row:
    """What the document promises for one cause."""

    cause: str
    culprit: str
    """drive, cable, bus or nothing"""
    hard: bool
    states: tuple[str, ...]
    found: str
    """Cycles, an expression of the constants of tb_drives.h and `divider`."""

    def cycles(self, constants: dict[str, float], divider: int = 1) -> int:
        """Cycles in which it is found, at the latest."""
        names = {**constants, "divider": divider, "ceil": math.ceil}
        return int(eval(self.found, {"__builtins__": {}}, names))


def between(text: str) -> tuple[str, ...]:
    """ "HOME..RUN" as the states from one to the other."""
    first, _, last = text.partition("..")
    return tuple(STATES[STATES.index(first) : STATES.index(last or first) + 1])


def rows() -> list[Row]:
    """Every row of the table of causes."""
    found = []
    for cause, culprit, reaction, states, cycles, *_ in table("## The causes"):
        found.append(Row(cause, culprit, "hard" in reaction, between(states), cycles))
    return found


def bounds(constants: dict[str, float]) -> dict[str, float]:
    """What the machine does at most, by name; SI units."""
    names = {**constants, "ceil": math.ceil}
    lines = table("## What the machine does at most")
    return {name: eval(most, {"__builtins__": {}}, names) for name, most, *_ in lines}


def table(heading: str) -> list[list[str]]:
    """The cells of every line of the table under a heading, without what is above the lines."""
    section = DOCUMENT.read_text().partition(heading)[2].partition("\n## ")[0]
    lines = [line for line in section.splitlines() if re.match(r"\| [A-Z_]+ \|", line)]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]


def constants(folder: Path) -> dict[str, float]:
    """Every number of a machine's tb_machine.h and tb_drives.h."""
    text = "".join((folder / name).read_text() for name in ("tb_machine.h", "tb_drives.h"))
    pattern = r"^#define (TB_\w+) (?:TB_C\()?(-?[\d.e+-]+)\)?(?: |$)"
    return {name: float(value) for name, value in re.findall(pattern, text, re.M)}
