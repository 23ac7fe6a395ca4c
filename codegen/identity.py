"""The hash of a machine: all that decides what its controller does, and nothing else.

The plant of the bench, where a number is from, comments, the spelling of a unit leave the hash as
it is; the contract of a drive and every limit of the supervisor do not.
"""

import hashlib
from collections.abc import Iterator

import casadi

from turnbuckle.codegen.bus.drives import drive_fields, groups
from turnbuckle.codegen.constants import Constant, constants
from turnbuckle.codegen.item import fingerprint
from turnbuckle.codegen.model import Model
from turnbuckle.model.machine import Machine
from turnbuckle.version import VERSION

#: Those of tb_drives.c; the repr of a row leaves its comment out.
TABLES = ("buses", "kinds", "objects", "drives", "node_frames")
CASADI_VERSION: str = casadi.CasadiMeta.version()


def machine_hash(model: Model) -> str:
    """Identifies machine, model, generator and versions: what a running controller reports."""
    digest = hashlib.sha256()
    digest.update(f"{VERSION} {CASADI_VERSION}\n".encode())
    for fact in facts(model):
        digest.update(f"{fact}\n".encode())
    for routine in model.items():
        digest.update(fingerprint(routine).encode())
    return digest.hexdigest()[:16]


def facts(model: Model) -> Iterator[str]:
    """Constants and tables of the generated C, without their comments."""
    machine = model.machine
    yield machine.name
    yield from (f"{alias} is {target}" for alias, target in model.aliases().items())
    yield from (f"{constant.name} {constant.text}" for constant in every_constant(machine))
    if machine.buses:
        tables = drive_fields(machine)
        yield from (repr(tables[name]) for name in TABLES)


def every_constant(machine: Machine) -> Iterator[Constant]:
    """Those of tb_machine.h, then those of tb_drives.h."""
    for group in constants(machine):
        yield from group
    if machine.buses:
        for _, group in groups(machine):
            yield from group
