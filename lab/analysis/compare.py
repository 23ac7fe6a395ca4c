"""Two machines side by side: what changed in their files, and what it did."""

import json
import tomllib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from turnbuckle.codegen.folder import refuse_foreign, write_folder
from turnbuckle.lab.analysis.analyze import find
from turnbuckle.lab.analysis.figures import Figure, Findings, figures
from turnbuckle.lab.analysis.plots import draw, span_of
from turnbuckle.lab.analysis.quantities import quantities
from turnbuckle.lab.analysis.report import REPORT, or_null, rows, table, verdict
from turnbuckle.lab.analysis.slices import panels
from turnbuckle.model.machine import Machine
from turnbuckle.model.problem import key_path, shown

MANIFEST = "comparison.json"
MAPS = 3  # the most useful ones
NOT_COMPARED = ("machine.name", "machine.source")  # say who a machine is, not what
ABSENT = "—"

Leaves = dict[str, Any]
Progress = Callable[[str, float], None]
Pair = tuple[Findings, Findings]


@dataclass(frozen=True)
class Comparison:
    """Rows of words: changed keys (key, before, after); numbers (label, before, after, change)."""

    names: tuple[str, str]
    changes: list[tuple[str, str, str]]
    rows: list[tuple[str, str, str, str]]


def compare(
    machines: tuple[Machine, Machine],
    folder: Path | None,
    lag: float,
    progress: Progress = lambda stage, share: None,
    force: bool = False,
) -> Comparison:
    """Look at two machines; with a folder, write report, numbers and maps into it.

    lag [m]: of late bases. Raises FolderError when the folder holds something else, or without
    force what is of other machines, or cannot be written.
    """
    if folder is not None:
        refuse_foreign(folder, MANIFEST, _names(machines), force)
    first, second = machines
    pair = find(first, lag, progress), find(second, lag, progress)
    result = Comparison(_names(machines), changed_keys(first, second), compared_rows(pair))
    if folder is not None:
        write_folder(_files(result, pair, progress), folder, MANIFEST, force)
    return result


def changed_keys(first: Machine, second: Machine) -> list[tuple[str, str, str]]:
    """Keys whose values differ, with what the two files say there, in the files' own units.

    "0.5 m" and "500 mm" do not differ, nor does a key that is left out and its default.
    """
    machines = first, second
    before, after = (_leaves(m.model_dump(by_alias=True, mode="json")) for m in machines)
    texts = [_leaves(tomllib.loads(m.path.read_text("utf-8"))) for m in machines]
    return [
        (key, _text(key, texts[0], before), _text(key, texts[1], after))
        for key in {**before, **after}
        if key not in NOT_COMPARED and before.get(key) != after.get(key)
    ]


def compared_rows(pair: Pair) -> list[tuple[str, str, str, str]]:
    """The numbers of both machines, and by how much they differ."""
    first, second = pair
    words = [(one, other) for one, other in zip(rows(first), rows(second), strict=True)]
    numbers = list(zip(figures(first.machine), figures(second.machine), strict=True))
    return [
        (_label(one[0], other[0]), one[1], other[1], _change(pair, numbers[k : k + 1]))
        for k, (one, other) in enumerate(words)
    ]


def _names(machines: tuple[Machine, Machine]) -> tuple[str, str]:
    """Their names; their files where the names are the same."""
    first, second = machines
    if first.name == second.name:
        return str(first.path), str(second.path)
    return first.name, second.name


def _leaves(tables: Any) -> Leaves:
    """Values of tables by key path, without what is not there; an array of values is one value."""
    return {key_path(place): value for place, value in _walk(tables, ()) if value is not None}


def _walk(value: Any, place: tuple[str | int, ...]) -> Iterator[tuple[tuple[str | int, ...], Any]]:
    if isinstance(value, dict):
        for key, item in value.items():
            yield from _walk(item, (*place, key))
    elif isinstance(value, list) and any(isinstance(item, dict) for item in value):
        for number, item in enumerate(value):
            yield from _walk(item, (*place, number))
    else:
        yield place, value


def _text(key: str, texts: Leaves, values: Leaves) -> str:
    """What a file says of a key; a default, or that there is no such thing."""
    if key in texts:
        return shown(texts[key])
    return f"{shown(values[key])} (default)" if key in values else ABSENT


def _label(one: str, other: str) -> str:
    """The label of both; with both demands where they differ."""
    return one if one == other else f"{one} | {other}"


def _change(pair: Pair, numbers: Sequence[tuple[Figure, Figure]]) -> str:
    """By how much a number differs; "" for rows that are no number."""
    first, second = pair
    return "".join(one.change(one.value(first), two.value(second)) for one, two in numbers)


def _files(result: Comparison, pair: Pair, progress: Progress) -> dict[str, str | bytes]:
    """Report, numbers and maps of a comparison, by name."""
    fields = [panels(findings.machine, progress) for findings in pair]
    maps: dict[str, str | bytes] = {}
    titles = []
    for number in range(MAPS):
        progress("drawing", number / MAPS)
        kinds = [quantities(findings.machine)[number] for findings in pair]
        ends = [span_of(kind, some) for kind, some in zip(kinds, fields, strict=True)]
        low, high = min(end[0] for end in ends), max(end[1] for end in ends)
        for which, (kind, some) in enumerate(zip(kinds, fields, strict=True), start=1):
            maps[f"{kind.name}_{which}.png"] = draw(replace(kind, low=low, high=high), some)
        titles += [kind.title for kind in kinds]
    names = [REPORT, *maps]
    return {
        MANIFEST: _as_json(result, pair, names),
        REPORT: _as_markdown(result, pair, dict(zip(maps, titles, strict=True))),
        **maps,
    }


def _as_json(result: Comparison, pair: Pair, names: Sequence[str]) -> str:
    content = {
        "machines": list(result.names),
        "passed": [findings.target.passed for findings in pair],
        "changes": [list(change) for change in result.changes],
        "numbers": {
            figure.key: [or_null(figure.value(findings)) for findings in pair]
            for figure in figures(pair[0].machine)
        },
        "files": list(names),
    }
    return json.dumps(content, indent=2) + "\n"


def _as_markdown(result: Comparison, pair: Pair, pictures: dict[str, str]) -> str:
    """The report; pictures: titles by file."""
    names = result.names
    lines = [f"# {names[0]} and {names[1]}", ""]
    for name, findings in zip(names, pair, strict=True):
        lines += [f"**{name}**: {verdict(findings)}", ""]
    lines += [*table(["changed key", *names], result.changes or [("nothing", "", "")]), ""]
    lines += [*table(["", *names, "change"], result.rows), ""]
    lines += ["Both maps of a quantity have the same colours.", ""]
    lines += [line for file, title in pictures.items() for line in (f"![{title}]({file})", "")]
    return "\n".join(lines)
