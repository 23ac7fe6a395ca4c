"""Keeps what became of mutants, as long as nothing that decided it has changed."""

import hashlib
import json
from collections.abc import Iterable
from pathlib import Path

from turnbuckle.lab.mutants.draw import sources
from turnbuckle.lab.mutants.mutation import Mutation
from turnbuckle.lab.mutants.objects import ROOT
from turnbuckle.lab.mutants.suites import suite_of
from turnbuckle.lab.mutants.trial import KEPT, Verdict, made

#: What a test can read beside itself and the modules next to it.
READ = ("runtime", "generated", "machines", "model", "codegen", "lab")
SUFFIXES = frozenset([".c", ".h", ".py", ".toml", ".jinja"])


class Verdicts:
    """The verdicts of earlier runs, in a file."""

    def __init__(self, file: Path = KEPT / "verdicts.json") -> None:
        self.sources = sources()
        """The C that is changed, by its place in runtime/."""
        self._file = file
        self._kept = json.loads(file.read_text()) if file.exists() else {}
        own = Path(__file__).parent
        files = [path for name in READ for path in _files(ROOT / name) if own not in path.parents]
        self._rest = _digest([*files, *(ROOT / "tests").glob("*.py")])

    def find(self, mutant: Mutation) -> Verdict | None:
        """The verdict on this very mutant by these very tests."""
        key, *verdict = self._kept.get(self._name(mutant), [""])
        return Verdict(*verdict) if key == self._key(mutant) else None

    def last_killer(self, mutant: Mutation) -> list[str]:
        """The test that noticed such a mutant before, whatever has changed: the first to ask."""
        killer = self._kept.get(self._name(mutant), ["", ""])[1]
        path, _, test = killer.partition("::")
        name = test.split("[")[0]
        file = ROOT / path
        is_there = bool(name) and file.exists() and f"def {name}(" in file.read_text()
        return [f"{path}::{name}"] if is_there else []

    def keep(self, mutant: Mutation, verdict: Verdict) -> None:
        """Keep a verdict."""
        self._kept[self._name(mutant)] = [self._key(mutant), *verdict]
        made(self._file.parent)
        self._file.write_text(json.dumps(self._kept, indent=1))

    def _key(self, mutant: Mutation) -> str:
        tests = [ROOT / name for name in suite_of(mutant.file)]
        beside = {path for test in tests for path in test.parent.glob("*.py")}
        read = {*tests, *(path for path in beside if not path.name.startswith("test_"))}
        text = f"{mutant.of(self.sources[mutant.file])}{self._rest}{_digest(read)}"
        return hashlib.sha256(text.encode()).hexdigest()

    def _name(self, mutant: Mutation) -> str:
        where = mutant.place_in(self.sources[mutant.file])
        return f"{mutant.file}: {where}: {mutant.words}"


def _files(folder: Path) -> list[Path]:
    return [path for path in folder.rglob("*") if path.suffix in SUFFIXES]


def _digest(files: Iterable[Path]) -> str:
    digest = hashlib.sha256()
    for path in sorted(files):
        digest.update(str(path.relative_to(ROOT)).encode() + path.read_bytes())
    return digest.hexdigest()
