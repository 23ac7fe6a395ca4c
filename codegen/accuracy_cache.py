"""Keeps measured accuracies, because the search takes longer than everything else together."""

import hashlib
import inspect
import json
import os
from contextlib import suppress
from pathlib import Path

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
_METHOD = (
    *(accuracy, chain, double_double, enumeration, evaluate),
    *(ir, item, loop, procedure, samples),
)


def measured_accuracy(machine: Machine, routines: list[Item]) -> dict[str, Accuracy]:
    """Accuracy of every routine by name, from the cache where it was measured before."""
    method = method_hash()
    paths = [CACHE / f"{key(machine, routine, method)}.json" for routine in routines]
    kept = [read(path) for path in paths]
    missing = [k for k, found in enumerate(kept) if found is None]
    for k, found in zip(missing, measure_all(machine, routines, missing), strict=True):
        keep(paths[k], found)
        kept[k] = found
    pairs = zip(routines, kept, strict=True)
    return {routine.function.name: found for routine, found in pairs if found}


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


def read(path: Path) -> Accuracy | None:
    """A kept measurement; None where there is none, or it is damaged."""
    try:
        content = json.loads(path.read_text())
        return Accuracy(
            {
                output: {
                    precision: WorstCase(
                        case["error"],
                        case["unit"],
                        tuple((name, tuple(values)) for name, values in case["place"]),
                    )
                    for precision, case in cases.items()
                }
                for output, cases in content.items()
            }
        )
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return None


def keep(path: Path, found: Accuracy) -> None:
    """Write a measurement whole or not at all; not being able to is no error."""
    content = {
        output: {precision: case.__dict__ for precision, case in cases.items()}
        for output, cases in found.results.items()
    }
    with suppress(FileError):
        write_whole(path, json.dumps(content))
