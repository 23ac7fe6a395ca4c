"""Whether a program was made for a machine: both know the machine's hash."""

import subprocess
from pathlib import Path

from turnbuckle.codegen.identity import machine_hash
from turnbuckle.codegen.model import build_model
from turnbuckle.lab.live import LiveError
from turnbuckle.model.machine import Machine


def hash_of(machine: Machine) -> str:
    """The hash of a machine, as its generated C and its program report it."""
    return machine_hash(build_model(machine))


def refuse_other(program: Path, machine: Machine) -> None:
    """Raise LiveError for what is no program of this machine."""
    found = identity_of(program)
    wanted = f"{machine.name} {hash_of(machine)}"
    if found != wanted:
        raise LiveError(
            f"{program}: compiled for {found}; allowed: {wanted}, the hash of {machine.path}:"
            " compile it anew"
        )


def identity_of(program: Path) -> str:
    """Name and hash that a program reports."""
    try:
        answer = subprocess.run(
            [program.resolve(), "--version"], capture_output=True, text=True, timeout=10
        )
    except (OSError, subprocess.TimeoutExpired, UnicodeDecodeError):
        raise LiveError(f"{program}: not a program that can be run here") from None
    identity, comma, _precision = answer.stdout.strip().partition(", ")
    if answer.returncode or not comma or len(identity.split()) != 2:
        raise LiveError(f"{program}: not a turnbuckle program: --version is not answered")
    return identity
