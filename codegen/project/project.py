"""The files of a new project: what is the machine's comes from its file, the rest is the same."""

import re
import tomllib
from importlib.metadata import version
from pathlib import Path
from typing import Any

import jinja2
from pydantic import TypeAdapter, ValidationError

from turnbuckle.codegen.folder import place
from turnbuckle.codegen.project.runtime import runtime_files
from turnbuckle.model.machine import Machine, json_schema_text
from turnbuckle.model.problem import shown
from turnbuckle.model.reading import load_machine
from turnbuckle.model.refusal import Refusal
from turnbuckle.model.words import Identifier

TEMPLATES = Path(__file__).parent / "templates"
#: Templates, each with the file that it becomes; those of LIVE for machines with buses alone.
ALWAYS = {
    "Makefile.jinja": "Makefile",
    "README.md.jinja": "README.md",
    "gitignore": ".gitignore",
    "check.yml.jinja": ".github/workflows/check.yml",
    "wall.c.jinja": "app/wall.c",
    "wall.cpp.jinja": "app/wall.cpp",
    "wall.py.jinja": "app/wall.py",
}
LIVE = {
    "live.c.jinja": "app/live.c",
    "live.cpp.jinja": "app/live.cpp",
    "live.py.jinja": "app/live.py",
    "cycles.c.jinja": "app/cycles.c",
    "cycles.h": "app/cycles.h",
}
SCHEMA = "machine.schema.json"
NAME_LINE = re.compile(r'^(name *= *)"[^"\n]*"', re.MULTILINE)
SCHEMA_LINE = re.compile(r"\A#:schema .*\n")


class ProjectError(Refusal):
    """The project cannot be made; the text says what stands in the way."""


def new_project(name: str, source: str | Path) -> Path:
    """Make the folder `name` around a machine like that of the file, or stock machine, `source`.

    All of it is written or nothing. Raises ProjectError for a name that cannot be the machine's or
    is taken, MachineError for a bad file, FolderError where the folder cannot be written.
    """
    refuse_name(name)
    folder = Path(name)
    refuse_existing(folder)
    machine = load_machine(source)
    text = renamed(machine, name)
    files = {f"{name}.toml": text, SCHEMA: json_schema_text(), **rendered(machine, name)}
    runtime = {f"runtime/{path}": content for path, content in runtime_files().items()}
    refuse_existing(folder)
    place({**files, **runtime}, folder)
    return folder


def refuse_name(name: str) -> None:
    """The name is the machine's too."""
    try:
        TypeAdapter(Identifier).validate_python(name)
    except ValidationError as error:
        allowed = error.errors()[0]["ctx"]["allowed"]
        raise ProjectError(f"NAME: found {shown(name)}; allowed: {allowed}") from None


def refuse_existing(folder: Path) -> None:
    """What is there is the user's."""
    if folder.exists() or folder.is_symlink():
        raise ProjectError(f"{folder}: exists already; name another, or move it away")


def renamed(machine: Machine, name: str) -> str:
    """The text of a machine's file with another name and its schema beside it."""
    text = machine.path.read_text(encoding="utf-8")
    fresh = NAME_LINE.sub(rf'\g<1>"{name}"', SCHEMA_LINE.sub("", text), count=1)
    wanted = tomllib.loads(text)
    wanted["machine"]["name"] = name
    if tomllib.loads(fresh) != wanted:
        raise ProjectError(
            f'{machine.path}: machine.name: found it in a place of its own; allowed: name = "..."'
            " on a line of the table [machine], the first of the file"
        )
    return f"#:schema {SCHEMA}\n{fresh}"


def rendered(machine: Machine, name: str) -> dict[str, str]:
    """What the templates become for a machine."""
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(TEMPLATES),
        undefined=jinja2.StrictUndefined,
        keep_trailing_newline=True,
        trim_blocks=True,
        lstrip_blocks=True,
        autoescape=False,
    )
    templates = {**ALWAYS, **(LIVE if machine.buses else {})}
    words = fields(machine, name)
    return {
        path: environment.get_template(template).render(words)
        for template, path in templates.items()
    }


def fields(machine: Machine, name: str) -> dict[str, Any]:
    """What the templates say of a machine."""
    return {
        "name": name,
        "source": machine.name,
        "version": version("turnbuckle"),
        "live": bool(machine.buses),
        "rails": bool(machine.rails),
        "space": machine.space,
        "pose": [*machine.target.centre, *[0.0] * (machine.dof - machine.space)],
        "push": round(machine.target.force / 4, 3),
        "rate": machine.control.rate,
    }
