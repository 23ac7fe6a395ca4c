"""Machine -> a folder of C files and a manifest, the same bytes on any machine and day."""

import hashlib
import json
import re
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path
from typing import Any

import jinja2

from turnbuckle.codegen.accuracy import Accuracy
from turnbuckle.codegen.accuracy_cache import ACCURACY, as_json, measured_accuracy
from turnbuckle.codegen.bus.dbc import dbc_files
from turnbuckle.codegen.bus.drives import drive_fields
from turnbuckle.codegen.chain import Chain
from turnbuckle.codegen.constant_names import ConstantNames
from turnbuckle.codegen.constants import Constant, constants
from turnbuckle.codegen.emit import CFunction, emit, emit_alias
from turnbuckle.codegen.folder import write_folder
from turnbuckle.codegen.identity import CASADI_VERSION, machine_hash
from turnbuckle.codegen.item import Item
from turnbuckle.codegen.model import Model, build_model
from turnbuckle.codegen.model_constants import model_constants
from turnbuckle.codegen.origin import command
from turnbuckle.codegen.prefix import PLAIN, prefixed, runtime_files
from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic.function import Input, Output, Status
from turnbuckle.model.symbolic.topics import TOPICS
from turnbuckle.version import VERSION, version_number

MANIFEST = "manifest.json"
#: Of the generated C: whoever generates it may do anything with it (NOTICE).
LICENCE = "0BSD"
TEMPLATES = Path(__file__).parent / "templates"


def render(model: Model, accuracies: dict[str, Accuracy], prefix: str = PLAIN) -> dict[str, str]:
    """Contents of every generated file, by name; with a prefix of its own also of the runtime.

    Raises PrefixError where names of the C would clash.
    """
    machine, identity = model.machine, machine_hash(model)
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(TEMPLATES),
        undefined=jinja2.StrictUndefined,
        keep_trailing_newline=True,
        autoescape=False,
    )
    common = {"banner": banner(machine, identity, prefix)}
    files = {
        "tb_types.h": environment.get_template("tb_types.h.jinja").render(
            common, statuses=list(Status), version=VERSION, version_number=version_number(VERSION)
        ),
    }
    if machine.buses:
        drives = {**common, **drive_fields(machine)}
        for name in ("tb_drives.h", "tb_drives.c"):
            files[name] = environment.get_template(f"{name}.jinja").render(drives)
        files |= dbc_files(machine)
    names = ConstantNames(model)
    for topic, routines in model.topics.items():
        fields = {
            **common,
            "guard": f"TB_{topic.upper()}_H",
            "header": f"tb_{topic}.h",
            "subject": f"{TOPICS[topic][0].capitalize()} of {machine.name}.",
            "functions": c_functions(model, routines, accuracies, names),
            "includes": [f"tb_{other}.h" for other in called_topics(model, topic)],
        }
        for kind in ("h", "c"):
            template = environment.get_template(f"topic.{kind}.jinja")
            files[f"tb_{topic}.{kind}"] = template.render(fields)
    groups = [*constants(machine), *read_constants(machine, files.values())]
    files["tb_machine.h"] = environment.get_template("tb_machine.h.jinja").render(
        common, name=machine.name, hash=identity, groups=groups
    )
    if prefix != PLAIN:
        files = prefixed(files | runtime_files(machine, common["banner"]), prefix)
    files[ACCURACY] = as_json(accuracies)
    files[MANIFEST] = manifest(model, identity, files, prefix)
    return files


def read_constants(machine: Machine, files: Iterable[str]) -> list[list[Constant]]:
    """The constants of the model that one of the files reads, in groups."""
    words = {word for text in files for word in re.findall(r"\bTB_\w+", text)}
    groups = [[each for each in group if each.name in words] for group in model_constants(machine)]
    return [group for group in groups if group]


def called_topics(model: Model, topic: str) -> list[str]:
    """The other topics whose functions those of a topic call."""
    homes = {item.function.name: home for home, items in model.topics.items() for item in items}
    chains = [item for item in model.topics[topic] if isinstance(item, Chain)]
    called = {homes[name] for item in chains for name in item.called()}
    return sorted(called - {topic})


def c_functions(
    model: Model, routines: list[Item], accuracies: dict[str, Accuracy], names: ConstantNames
) -> list[CFunction]:
    """The C of one topic, with its aliases last."""
    functions = once(
        [emit(routine, accuracies[routine.function.name], names) for routine in routines]
    )
    by_name = {routine.function.name: routine for routine in routines}
    for alias, target in model.aliases().items():
        if target in by_name:
            functions.append(emit_alias(alias, by_name[target]))
    return functions


def once(functions: list[CFunction]) -> list[CFunction]:
    """The functions of one file; what several of them call alone comes with the first of these."""
    printed: dict[str, CFunction] = {}
    for number, function in enumerate(functions):
        fresh = tuple(part for part in function.parts if printed.get(part.name) != part)
        if clash := printed.keys() & {part.name for part in fresh}:
            raise ValueError(f"{min(clash)} stands for two functions")
        printed |= {part.name: part for part in fresh}
        functions[number] = replace(function, parts=fresh)
    return functions


def banner(machine: Machine, identity: str, prefix: str = PLAIN) -> str:
    """First lines of every file: how to make it again, from what it was made, whose it is."""
    option = "" if prefix == PLAIN else f" --prefix {prefix}"
    return (
        f"/* Regenerate: {command(machine)}{option} --out <this folder>\n"
        f" * Machine {identity}, turnbuckle {VERSION}, casadi {CASADI_VERSION}. Do not edit.\n"
        f" * SPDX-License-Identifier: {LICENCE} */"
    )


def folder_name(machine: Machine, prefix: str) -> str:
    """The folder where the C goes if no other is named."""
    return machine.name if prefix == PLAIN else f"{prefix}_{machine.name}"


def manifest(model: Model, identity: str, files: dict[str, str], prefix: str) -> str:
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
        "prefix": prefix,
        "turnbuckle": VERSION,
        "casadi": CASADI_VERSION,
        "aliases": model.aliases(),
        "functions": functions,
        "files": {name: hashlib.sha256(text.encode()).hexdigest() for name, text in files.items()},
    }
    return json.dumps(content, indent=2) + "\n"


def port(entry: Input | Output) -> dict[str, Any]:
    """Name, shape and unit of an argument or result."""
    return {"name": entry.name, "shape": list(entry.shape), "unit": entry.unit}


def generate(machine: Machine, prefix: str = PLAIN, before: Path | None = None) -> dict[str, str]:
    """Contents of every generated file of a machine, by name; PrefixError as render.

    before: a folder with C of the machine, whose measured accuracies hold where nothing changed.
    """
    model = build_model(machine)
    return render(model, measured_accuracy(model.machine, model.items(), before), prefix)


def write(files: dict[str, str], folder: Path, force: bool = False) -> None:
    """Replace the folder by the files, as a whole or not at all; FolderError where it cannot be.

    force: another machine's files are replaced too.
    """
    write_folder(files, folder, MANIFEST, force)
