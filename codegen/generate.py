"""Machine -> a folder of C files and a manifest, the same bytes on any machine and day."""

import hashlib
import json
import os
import shutil
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import casadi
import jinja2

from codegen.accuracy import Accuracy
from codegen.accuracy_cache import measured_accuracy
from codegen.composite import Item, Procedure, fingerprint, loop
from codegen.constants import constants
from codegen.emit import CFunction, emit, emit_alias
from codegen.lower import lower
from codegen.simplify import simplify
from model.machine import Machine
from model.symbolic.function import Input, Output, Repeat, Retry, Status
from model.symbolic.topics import TOPICS, model_composites, model_functions

GENERATOR_VERSION = "0.1.0"
CASADI_VERSION: str = casadi.CasadiMeta.version()
MANIFEST = "manifest.json"
TEMPLATES = Path(__file__).parent / "templates"


class GenerateError(Exception):
    """The C cannot be written; the text says what stands in the way."""


@dataclass(frozen=True)
class Model:
    """A machine with its functions ready to print, by topic."""

    machine: Machine
    topics: dict[str, list[Item]]

    def items(self) -> list[Item]:
        """All functions in order."""
        return [item for items in self.topics.values() for item in items]

    def aliases(self) -> dict[str, str]:
        """Functions that are another one under a second name."""
        return {"distribute_tension": f"distribute_tension_{self.machine.tension.when_infeasible}"}


def build_model(machine: Machine) -> Model:
    """Lower and simplify every function of the machine."""
    routines = {
        topic: [simplify(lower(function)) for function in functions]
        for topic, functions in model_functions(machine).items()
    }
    topics: dict[str, list[Item]] = {topic: [*group] for topic, group in routines.items()}
    known = {item.function.name: item for group in topics.values() for item in group}
    for topic, composites in model_composites(machine).items():
        for composite in composites:
            item = composed(composite, known)
            known[composite.name] = item
            topics[topic].append(item)
    return Model(machine, topics)


def composed(composite: Retry | Repeat, known: dict[str, Item]) -> Item:
    """A function made of others: of those that are known, or of its own parts."""
    if isinstance(composite, Repeat):
        return loop(composite, lambda part: simplify(lower(part)))
    attempts = tuple(known[name] for name in composite.attempts)
    return Procedure(composite, attempts, known[composite.substitute])


def machine_hash(model: Model) -> str:
    """Identifies machine, model, generator and versions: what a running controller reports."""
    digest = hashlib.sha256()
    digest.update(f"{GENERATOR_VERSION} {CASADI_VERSION}\n".encode())
    digest.update(canonical(model.machine).encode())
    for routine in model.items():
        digest.update(fingerprint(routine).encode())
    return digest.hexdigest()[:16]


def canonical(machine: Machine) -> str:
    """The machine's numbers as text; comments and spelling of units do not count."""
    content = machine.model_dump(mode="json", by_alias=True, exclude={"path"})
    return json.dumps(content, sort_keys=True)


def render(model: Model, accuracies: dict[str, Accuracy]) -> dict[str, str]:
    """Contents of every generated file, by name."""
    machine, identity = model.machine, machine_hash(model)
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(TEMPLATES),
        undefined=jinja2.StrictUndefined,
        keep_trailing_newline=True,
        autoescape=False,
    )
    common = {"banner": banner(machine, identity)}
    files = {
        "tb_types.h": environment.get_template("tb_types.h.jinja").render(
            common, statuses=list(Status)
        ),
        "tb_machine.h": environment.get_template("tb_machine.h.jinja").render(
            common, name=machine.name, hash=identity, groups=constants(machine)
        ),
    }
    for topic, routines in model.topics.items():
        fields = {
            **common,
            "guard": f"TB_{topic.upper()}_H",
            "header": f"tb_{topic}.h",
            "subject": f"{TOPICS[topic][0].capitalize()} of {machine.name}.",
            "functions": c_functions(model, routines, accuracies),
        }
        for kind in ("h", "c"):
            template = environment.get_template(f"topic.{kind}.jinja")
            files[f"tb_{topic}.{kind}"] = template.render(fields)
    files[MANIFEST] = manifest(model, identity, files)
    return files


def c_functions(
    model: Model, routines: list[Item], accuracies: dict[str, Accuracy]
) -> list[CFunction]:
    """The C of one topic, with its aliases last."""
    functions = [emit(routine, accuracies[routine.function.name]) for routine in routines]
    by_name = {routine.function.name: routine for routine in routines}
    for alias, target in model.aliases().items():
        if target in by_name:
            functions.append(emit_alias(alias, by_name[target]))
    return functions


def banner(machine: Machine, identity: str) -> str:
    """First lines of every file: how to make it again, and from what it was made."""
    return (
        f"/* Regenerate: turnbuckle generate machines/{machine.path.name}"
        f" --out generated/{machine.name}\n"
        f" * Machine {identity}, generator {GENERATOR_VERSION}, casadi {CASADI_VERSION}."
        " Do not edit. */"
    )


def manifest(model: Model, identity: str, files: dict[str, str]) -> str:
    """What was generated, from what: the hash of every file, the shape of every function."""
    functions: dict[str, Any] = {}
    for routine in model.items():
        function = routine.function
        functions[function.name] = {
            "inputs": [port(entry) for entry in function.inputs],
            "outputs": [port(entry) for entry in function.outputs],
        }
    content = {
        "machine": model.machine.name,
        "hash": identity,
        "generator": GENERATOR_VERSION,
        "casadi": CASADI_VERSION,
        "aliases": model.aliases(),
        "functions": functions,
        "files": {name: hashlib.sha256(text.encode()).hexdigest() for name, text in files.items()},
    }
    return json.dumps(content, indent=2) + "\n"


def port(entry: Input | Output) -> dict[str, Any]:
    """Name, shape and unit of an argument or result."""
    return {"name": entry.name, "shape": list(entry.shape), "unit": entry.unit}


def generate(machine: Machine) -> dict[str, str]:
    """Contents of every generated file of a machine, by name."""
    model = build_model(machine)
    return render(model, measured_accuracy(model.machine, model.items()))


def write(files: dict[str, str], folder: Path) -> None:
    """Replace the folder by the files, as a whole or not at all.

    Raises GenerateError where the folder holds something that was not generated, or cannot be
    written.
    """
    refuse_foreign(folder)
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        fresh = Path(tempfile.mkdtemp(prefix=f".{folder.name}-", dir=folder.parent))
        try:
            fill(fresh, files)
            exchange(fresh, folder)
        finally:
            shutil.rmtree(fresh, ignore_errors=True)
    except OSError as error:
        raise GenerateError(
            f"{folder}: cannot be written: {error.strerror}; name a folder you may write with --out"
        ) from None


def refuse_foreign(folder: Path) -> None:
    """A folder with other content than ours is left alone."""
    if folder.is_symlink() or (folder.exists() and not folder.is_dir()):
        raise GenerateError(f"{folder}: is not a folder; --out takes a new or a generated folder")
    if not folder.exists():
        return
    entries = sorted(entry.name for entry in folder.iterdir())
    if entries and MANIFEST not in entries:
        raise GenerateError(
            f"{folder}: holds {entries[0]!r} and no {MANIFEST}, so it was not generated; "
            "--out takes a new, an empty or a generated folder"
        )
    if MANIFEST in entries:
        strangers = set(entries) - set(generated_names(folder / MANIFEST)) - {MANIFEST}
        if strangers:
            raise GenerateError(
                f"{folder}: holds {min(strangers)!r}, which was not generated and would be lost; "
                "move it away, or name another folder with --out"
            )


def generated_names(path: Path) -> list[str]:
    """Files that a manifest lists."""
    try:
        return list(json.loads(path.read_text())["files"])
    except (OSError, ValueError, KeyError, TypeError):
        raise GenerateError(
            f"{path}: is not a manifest of generated files; name another folder with --out"
        ) from None


def fill(folder: Path, files: dict[str, str]) -> None:
    """Write the files; readable by everyone, as the rest of a checkout is."""
    folder.chmod(0o755)
    for name, text in files.items():
        with (folder / name).open("w", encoding="utf-8", newline="\n") as stream:
            stream.write(text)
            stream.flush()
            os.fsync(stream.fileno())


def exchange(fresh: Path, folder: Path) -> None:
    """Put the fresh folder where the old one is; the old one comes back if that fails."""
    if not folder.exists():
        fresh.rename(folder)
        return
    old = folder.with_name(f".{folder.name}-old-{os.getpid()}")
    folder.rename(old)
    try:
        fresh.rename(folder)
    except OSError:
        old.rename(folder)
        raise
    shutil.rmtree(old)
