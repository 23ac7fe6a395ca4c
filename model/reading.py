"""A machine file, read and checked: every problem of it in one refusal."""

import tomllib
from codecs import BOM_UTF8
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from turnbuckle.model.consistency import consistency_problems
from turnbuckle.model.machine import Machine
from turnbuckle.model.partial import partial
from turnbuckle.model.problem import MachineError, Problem, schema_problems
from turnbuckle.model.stock import machine_file, stock_names


def load_machine(path: str | Path) -> Machine:
    """Read and check a machine file, or a stock machine by its name.

    Raises MachineError, whose text names the file, the key, what was found and what is allowed.
    """
    path = machine_file(path)
    return machine_from(_read_toml(path), path)


def machine_from(tables: dict[str, Any], path: Path) -> Machine:
    """The machine that a file's tables describe; MachineError names `path` as the file."""
    problems: list[Problem] = []
    try:
        machine = Machine.model_validate(tables)
    except ValidationError as error:
        problems = schema_problems(error, Machine)
        machine = partial(Machine, tables)
    problems += consistency_problems(machine, tables)
    if problems:
        raise MachineError(path, problems)
    return machine.read_from(path)


def _read_toml(path: Path) -> dict[str, Any]:
    # Editors on Windows put a byte order mark before the text.
    content = _read_bytes(path).removeprefix(BOM_UTF8)
    try:
        return tomllib.loads(content.decode("utf-8"))
    except UnicodeDecodeError as error:
        found = f"a byte that is no UTF-8 at offset {error.start}"
    except tomllib.TOMLDecodeError as error:
        found = f"a mistake in the TOML: {error}"
    except (ValueError, RecursionError):
        found = "a number too long or arrays nested too deep to read"
    raise _unreadable(path, found)


def _read_bytes(path: Path) -> bytes:
    try:
        return path.read_bytes()
    except FileNotFoundError:
        raise _unreadable(
            path, "no such file", f", or a stock machine: {', '.join(stock_names())}"
        ) from None
    except IsADirectoryError:
        found = "a directory"
    except OSError as error:
        found = f"a file that cannot be read ({error.strerror})"
    except ValueError:
        found = "a name that no file can have"
    raise _unreadable(path, found)


def _unreadable(path: Path, found: str, more: str = "") -> MachineError:
    allowed = f"a readable machine file, TOML in UTF-8{more}"
    return MachineError(path, [Problem("", found, allowed)])
