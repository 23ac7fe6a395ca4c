"""What a program carries in its file, and tells by --version: runtime/core/identity.h."""

import re
from dataclasses import dataclass
from pathlib import Path

from turnbuckle.lab.deploy import DeployError

MARKED = re.compile(rb"@\(#\)turnbuckle ([ -~]+)\0")
TEXT = re.compile(r"(\w+) ([0-9a-f]{16}), (double|float), Turnbuckle ([\d.]+), ([\w -]+)")


@dataclass(frozen=True)
class Identity:
    """A program's machine, the hash of that, precision, version of Turnbuckle, processor."""

    machine: str
    hash: str
    precision: str
    version: str
    processor: str

    def __str__(self) -> str:
        """As the program tells it."""
        return (
            f"{self.machine} {self.hash}, {self.precision}, Turnbuckle {self.version},"
            f" {self.processor}"
        )


def identity_from(text: str) -> Identity | None:
    """What a program tells, None for the words of something else."""
    found = TEXT.fullmatch(text.strip())
    return Identity(*found.groups()) if found else None


def carried_identity(program: Path) -> Identity:
    """What a file carries, for any processor: nothing of it is run. DeployError for other files."""
    found = MARKED.search(program.read_bytes())
    identity = identity_from(found[1].decode()) if found else None
    if identity is None:
        raise DeployError(
            f"{program}: found a file that carries no identity; allowed: a program that was built"
            " with this version of Turnbuckle's runtime, or a later one"
        )
    return identity
