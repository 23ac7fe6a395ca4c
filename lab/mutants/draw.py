"""Draws mutants at random, the same for the same seed."""

import hashlib
import tempfile
from collections.abc import Callable
from pathlib import Path

from turnbuckle.lab.mutants.mutation import Mutation, mutations
from turnbuckle.lab.mutants.objects import ROOT, Originals

RUNTIME = ROOT / "runtime"
FOLDERS = ("core", "canopen")

Progress = Callable[[int], None]


def sources() -> dict[str, str]:
    """The C that is changed, by its place in runtime/."""
    paths = [path for folder in FOLDERS for path in sorted((RUNTIME / folder).glob("*.c"))]
    return {path.relative_to(RUNTIME).as_posix(): path.read_text() for path in paths}


def drawn(count: int, seed: int, progress: Progress = lambda done: None) -> list[Mutation]:
    """So many mutants of the runtime. Where it changes, those of other lines stay the same."""
    texts = sources()
    found: list[Mutation] = []
    with tempfile.TemporaryDirectory() as folder:
        originals = Originals(Path(folder))
        for change in _in_drawn_order(texts, seed):
            text = texts[change.file]
            if originals.differ(change.file, text, change.of(text)):
                found.append(change)
                progress(len(found))
            if len(found) == count:
                break
    return found


def _in_drawn_order(texts: dict[str, str], seed: int) -> list[Mutation]:
    """All changes, in an order that each one's own words tell."""

    def place(change: Mutation) -> bytes:
        where = change.place_in(texts[change.file])
        words = f"{seed} {change.file} {where} {change.words}"
        return hashlib.sha256(words.encode()).digest()

    every = [change for file, text in texts.items() for change in mutations(file, text)]
    return sorted(every, key=place)
