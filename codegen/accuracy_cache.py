"""Keeps measured accuracies, because the search takes longer than everything else together."""

import hashlib
import inspect
import json
import os
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from turnbuckle.codegen import (
    accuracy,
    chain,
    double_double,
    enumeration,
    evaluate,
    ir,
    item,
    loop,
    procedure,
    samples,
)
from turnbuckle.codegen.accuracy import Accuracy, WorstCase, measure
from turnbuckle.codegen.item import Item, fingerprint
from turnbuckle.codegen.processes import forked_workers
from turnbuckle.model.files import FileError, write_whole
from turnbuckle.model.machine import Machine
from turnbuckle.places import cache_folder

#: Where measurements are kept between runs; safe to delete.
CACHE = cache_folder() / "accuracy"
#: The file beside the C that tells what was measured: unchanged functions are not measured again.
ACCURACY = "accuracy.json"
#: Digits of what is kept: more than a header shows.
DIGITS = 6
#: What reading a damaged or another file raises.
_DAMAGE = (OSError, ValueError, KeyError, TypeError, AttributeError)
_METHOD = (
    *(accuracy, chain, double_double, enumeration, evaluate),
    *(ir, item, loop, procedure, samples),
)


def measured_accuracy(
    machine: Machine, routines: list[Item], before: Path | None = None
) -> dict[str, Accuracy]:
    """Accuracy of every routine by name, measured where that was not done before.

    before: a folder of generated C, which tells what was measured for the same operations.
    """
    method = method_hash()
    keys = [key(machine, routine, method) for routine in routines]
    found = {each: kept for each in keys if (kept := read(each))}
    if before and len(found) < len(keys):
        told = accuracies_in(before / ACCURACY)
        found |= keep({each: told[each] for each in keys if each in told and each not in found})
    missing = [number for number, each in enumerate(keys) if each not in found]
    measured = measure_all(machine, routines, missing)
    found |= keep({keys[k]: each for k, each in zip(missing, measured, strict=True)})
    return {
        routine.function.name: found[each] for routine, each in zip(routines, keys, strict=True)
    }


#: What the processes of a measurement work on; they are forked with it, as CasADi's symbols cannot
#: be sent to another process.
_work: tuple[Machine, list[Item]] | None = None


def measure_all(machine: Machine, routines: list[Item], numbers: list[int]) -> list[Accuracy]:
    """Measure some of the routines, on all cores; the result does not depend on how many."""
    global _work
    _work = machine, routines
    if len(numbers) < 2:
        return [measure_one(number) for number in numbers]
    order = sorted(numbers, key=lambda number: -len(fingerprint(routines[number])))
    with forked_workers(os.cpu_count()) as pool:
        measured = dict(zip(order, pool.map(measure_one, order), strict=True))
    return [measured[number] for number in numbers]


def measure_one(number: int) -> Accuracy:
    """Measure one routine of the work at hand."""
    assert _work is not None
    machine, routines = _work
    return measure(machine, routines[number])


def method_hash() -> str:
    """Changes whenever the way of measuring does."""
    sources = "".join(inspect.getsource(module) for module in _METHOD)
    return hashlib.sha256((sources + np.__version__).encode()).hexdigest()


def key(machine: Machine, routine: Item, method: str) -> str:
    """Identifies one measurement."""
    content = machine.model_dump_json(exclude={"path"})
    text = "\n".join((method, content, fingerprint(routine)))
    return hashlib.sha256(text.encode()).hexdigest()[:32]


def accuracies_in(path: Path) -> dict[str, Accuracy]:
    """The measurements in a file beside the C, by their keys; none where it is damaged."""
    try:
        entries = json.loads(path.read_text()).values()
        return {entry["key"]: accuracy_of(entry["worst"]) for entry in entries}
    except _DAMAGE:
        return {}


def as_json(accuracies: dict[str, Accuracy]) -> str:
    """The file beside the C: key and results of every function that was measured, a line each."""
    lines = [
        f"{json.dumps(name)}: {json.dumps({'key': found.key, 'worst': plain(found)})}"
        for name, found in accuracies.items()
        if found.key
    ]
    return "{\n" + ",\n".join(lines) + "\n}\n"


def read(named: str) -> Accuracy | None:
    """The measurement that is kept under a key; None where there is none, or it is damaged."""
    try:
        return replace(accuracy_of(json.loads(path_of(named).read_text())), key=named)
    except _DAMAGE:
        return None


def keep(found: dict[str, Accuracy]) -> dict[str, Accuracy]:
    """Write measurements, each whole or not at all; not being able to is no error.

    Returns them as they will be read, with the keys that they are given under.
    """
    kept = {
        named: replace(accuracy_of(plain(measured)), key=named) for named, measured in found.items()
    }
    for named, measured in kept.items():
        with suppress(FileError):
            write_whole(path_of(named), json.dumps(plain(measured)))
    return kept


def path_of(named: str) -> Path:
    """Where the measurement with a key is kept."""
    return CACHE / f"{named}.json"


def plain(accuracy: Accuracy) -> dict[str, Any]:
    """An accuracy as plain data, without its key."""
    return {
        output: {precision: case.__dict__ for precision, case in cases.items()}
        for output, cases in accuracy.results.items()
    }


def accuracy_of(content: dict[str, Any]) -> Accuracy:
    """The accuracy in plain data, with the digits that are the same on every computer.

    Raises one of _DAMAGE where there is none.
    """
    return Accuracy(
        {
            output: {precision: case_of(case) for precision, case in cases.items()}
            for output, cases in content.items()
        }
    )


def case_of(case: dict[str, Any]) -> WorstCase:
    """The worst case in plain data."""
    place = tuple((name, tuple(map(rounded, values))) for name, values in case["place"])
    return WorstCase(rounded(case["error"]), case["unit"], place)


def rounded(value: float) -> float:
    """A number with as many digits as are kept."""
    return float(f"{value:.{DIGITS}g}")
