"""The results of a study: a folder that fills as results arrive, and is taken up again.

`study.json` holds the question, `results.csv` one line a machine. Nothing is ever lost but the
line that was being written.
"""

import csv
import hashlib
import io
import json
from collections.abc import Iterable
from decimal import Decimal
from importlib.metadata import version
from pathlib import Path
from typing import Any, NamedTuple

from turnbuckle.lab.design import DesignError
from turnbuckle.lab.design.design import Design, Outcome
from turnbuckle.lab.design.files import Lines
from turnbuckle.lab.design.goal import Score
from turnbuckle.model.files import write_whole
from turnbuckle.model.problem import key_path

QUESTION, RESULTS = "study.json", "results.csv"


class Kept(NamedTuple):
    """A result and the number of its point."""

    point: int
    outcome: Outcome


class Results:
    """The results kept in a folder."""

    def __init__(self, folder: Path, design: Design, plan: dict[str, Any]) -> None:
        """Take up what the folder holds; DesignError where that is anything but this study."""
        self.folder = folder
        self.kept: dict[int, Kept] = {}
        self._design = design
        self._question = _question(design, plan)
        self._lines: Lines | None = None
        _refuse_other(folder, self._question)
        if (folder / RESULTS).exists():
            self.begin()

    @property
    def best(self) -> Kept | None:
        """The best machine, the first of equals; None where there is none yet."""
        machines = [kept for kept in self.kept.values() if kept.outcome.score]
        return max(machines, key=_order, default=None)

    def begin(self) -> None:
        """Make the folder ready for results."""
        if self._lines:
            return
        if not (self.folder / QUESTION).exists():
            write_whole(self.folder / QUESTION, json.dumps(self._question, indent=2) + "\n")
        self._lines = Lines(self.folder / RESULTS)
        rows = list(csv.reader(self._lines.read()))
        if not rows:
            self._lines.append(_as_csv([self._header()]))
        self.kept = {kept.point: kept for kept in self._read(rows)}

    def add(self, results: Iterable[Kept]) -> None:
        """Keep results; those of points already kept are not taken again."""
        assert self._lines, "begin first"
        fresh = {kept.point: kept for kept in results if kept.point not in self.kept}
        try:
            self._lines.append(_as_csv(self._row(kept) for kept in fresh.values()))
        except DesignError as error:
            raise DesignError(f"{error}; {self.go_on()}") from None
        self.kept |= fresh

    def go_on(self) -> str:
        """What to do when a study was stopped."""
        return f"{len(self.kept)} results are kept: run the same command again to go on"

    def close(self) -> None:
        """Let go of the folder."""
        if self._lines:
            self._lines.close()

    def _read(self, rows: list[list[str]]) -> list[Kept]:
        try:
            if rows and rows[0] != self._header():
                raise ValueError
            return [self._result(row) for row in rows[1:]]
        except (ValueError, IndexError, ArithmeticError):
            path = self.folder / RESULTS
            raise DesignError(f"{path}: is damaged; name another folder with --out") from None

    def _header(self) -> list[str]:
        varied = [f"{one.key} [{one.unit}]" for one in self._design.ranges]
        return ["point", *varied, *self._design.goal.figures, "merit", "attained", "refusal"]

    def _row(self, kept: Kept) -> list[str]:
        values, score, refusal = kept.outcome
        numbers = [str(kept.point), *(f"{value.normalize():f}" for value in values)]
        if score is None:
            return [*numbers, *[""] * (len(self._design.goal.figures) + 2), refusal]
        figures = [repr(figure) for figure in score.figures]
        return [*numbers, *figures, repr(score.merit), "yes" if score.attained else "no", ""]

    def _result(self, row: list[str]) -> Kept:
        end = len(self._design.ranges) + 1
        values = tuple(Decimal(text) for text in row[1:end])
        *figures, merit, attained, refusal = row[end:]
        score = None
        if merit:
            score = Score(float(merit), attained == "yes", tuple(map(float, figures)))
        return Kept(int(row[0]), Outcome(values, score, refusal))


def _order(kept: Kept) -> tuple[float, int]:
    assert kept.outcome.score is not None
    return kept.outcome.score.merit, -kept.point


def _question(design: Design, plan: dict[str, Any]) -> dict[str, Any]:
    """What the results depend on."""
    ranges = [
        f"{', '.join(map(key_path, one.locations))} = {one.low} to {one.high} {one.unit}"
        for one in design.ranges
    ]
    return {
        "turnbuckle": version("turnbuckle"),
        "machine file (SHA-256)": hashlib.sha256(design.document.text.encode()).hexdigest(),
        "goal": repr(design.goal),
        "ranges": ranges,
        **plan,
    }


def _refuse_other(folder: Path, question: dict[str, Any]) -> None:
    """DesignError where the folder holds anything but answers to this question."""
    path = folder / QUESTION
    try:
        before = json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        if folder.is_dir() and any(folder.iterdir()):
            raise DesignError(
                f"{folder}: holds files and no {QUESTION}, so it is no study; name another folder"
                " with --out"
            ) from None
        return
    except (ValueError, OSError):
        raise DesignError(f"{path}: cannot be read; name another folder with --out") from None
    for key, value in question.items():
        if not isinstance(before, dict) or before.get(key) != value:
            raise DesignError(
                f"{folder}: holds a study with another {key}; name another folder with --out"
            )


def _as_csv(rows: Iterable[list[str]]) -> str:
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return text.getvalue()
