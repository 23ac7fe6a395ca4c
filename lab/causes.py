"""The causes of runtime/core/causes.h, and the columns of docs/safety.md that are written from it.

`python -m turnbuckle.lab.causes` writes them anew.
"""

import re
from functools import cache
from pathlib import Path
from typing import NamedTuple

from turnbuckle.places import RUNTIME

TABLE = RUNTIME / "core" / "causes.h"
SAFETY = Path("docs") / "safety.md"
ROW = re.compile(r'ROW\((\w+), (\w+), (\w+), "([^"]*)",[\s\\]*"([^"]*)"\)')


class Cause(NamedTuple):
    """A row of the table."""

    name: str
    culprit: str
    """drive, cable, bus or nothing"""
    is_hard: bool
    words: str
    """What is wrong, to be read after the culprit's name."""
    advice: str


@cache
def causes(table: Path = TABLE) -> tuple[Cause, ...]:
    """In the order of their numbers, from TB_CAUSE_NONE on."""
    rows = ROW.findall(table.read_text())
    return tuple(
        Cause(name, "" if culprit == "NOBODY" else culprit.lower(), reaction == "HARD", *texts)
        for name, culprit, reaction, *texts in rows
    )


def written(document: str, table: Path = TABLE) -> str:
    """docs/safety.md with the columns of culprit and advice as the table of causes has them."""
    for cause in causes(table):
        line = rf"^\| {cause.name} \|[^|]*\|(.*)\|[^|]*\|$"
        culprit, advice = (f" {text} " if text else " " for text in (cause.culprit, cause.advice))
        row = rf"| {cause.name} |{culprit}|\1|{advice}|"
        document = re.sub(line, row, document, flags=re.MULTILINE)
    return document


if __name__ == "__main__":
    SAFETY.write_text(written(SAFETY.read_text()))
