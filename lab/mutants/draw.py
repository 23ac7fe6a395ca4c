"""Draws mutants at random, the same for the same seed."""

import random
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path

from lab.mutants.mutation import Mutation, mutations
from lab.mutants.objects import ROOT, ObjectCode, object_code

RUNTIME = ROOT / "runtime"
FOLDERS = ("core", "canopen")

Progress = Callable[[int], None]


def sources() -> dict[str, str]:
    """The C that is changed, by its place in runtime/."""
    paths = [path for folder in FOLDERS for path in sorted((RUNTIME / folder).glob("*.c"))]
    return {path.relative_to(RUNTIME).as_posix(): path.read_text() for path in paths}


def drawn(count: int, seed: int, progress: Progress = lambda done: None) -> list[Mutation]:
    """So many mutants of the runtime, in the order in which they were drawn."""
    found: list[Mutation] = []
    with tempfile.TemporaryDirectory() as folder:
        for mutant in _mutants(seed, Path(folder)):
            found.append(mutant)
            progress(len(found))
            if len(found) == count:
                break
    return found


def _mutants(seed: int, folder: Path) -> Iterator[Mutation]:
    texts = sources()
    every = [change for file, text in texts.items() for change in mutations(file, text)]
    random.Random(seed).shuffle(every)
    originals: dict[str, ObjectCode] = {}
    for change in every:
        text = texts[change.file]
        if change.file not in originals:
            originals[change.file] = object_code(change.file, text, folder)
        if is_mutant(originals[change.file], object_code(change.file, change.of(text), folder)):
            yield change


def is_mutant(original: ObjectCode, changed: ObjectCode) -> bool:
    """Whether a change compiles wherever the original does, to something else somewhere."""
    pairs = [pair for pair in zip(original, changed, strict=True) if pair[0] is not None]
    return all(after is not None for _, after in pairs) and any(a != b for a, b in pairs)
