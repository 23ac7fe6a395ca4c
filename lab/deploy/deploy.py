"""Brings a machine's program to a host, and back to the one before."""

import hashlib
import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from turnbuckle.lab.deploy import DeployError
from turnbuckle.lab.deploy.build import build_for
from turnbuckle.lab.deploy.host import Answer, Host
from turnbuckle.lab.deploy.identity import Identity, carried_identity, identity_from
from turnbuckle.lab.deploy.processor import Processor, processor_of
from turnbuckle.model.machine import Machine
from turnbuckle.places import RUNTIME

HOME_FOLDER = "turnbuckle"
"""In the user's home folder there: needs no root."""
UNIT_FOLDER = "/opt/turnbuckle"
"""Where the unit looks."""
UNIT = RUNTIME / "port" / "linux" / "turnbuckle@.service"
FOLDER = re.compile(r"(~/)?[\w./+-]+")
SPARE = 1 << 20
"""Bytes that shall be left over there."""
Say = Callable[[str], None]


@dataclass(frozen=True)
class Installed:
    """A program on a host."""

    sha256: str
    text: str
    """Its identity as the file has it; empty for a file of somebody else."""

    @property
    def identity(self) -> Identity | None:
        """What it is, None for a file of somebody else."""
        return identity_from(self.text)


@dataclass(frozen=True)
class Switched:
    """What a machine's folder on a host holds now."""

    place: str
    """Path of the program there."""
    before: Installed | None
    now: Installed
    previous: Installed | None


def deploy(
    machine: Machine, host: Host, folder: str, arch: str | None, precision: str, say: Say
) -> Switched:
    """Build the machine's program for a host, bring it there and switch to it.

    arch: what the host has to be, None for anything. say: told what has been done so far. Raises
    DeployError, with the host's program as it was; LiveError, CompileError like build_for.
    """
    place = place_of(machine, folder)
    answer = host.do(["ask", place])
    processor = processor_of(host.name, answer["machine"], arch)
    say(f"{host.name}: {processor.name}, {in_words(room_of(answer))} free")
    program = build_for(machine, processor, precision)
    identity = identity_of(program, machine, processor)
    sha256 = hashlib.sha256(program.read_bytes()).hexdigest()
    size = program.stat().st_size
    say(f"built: {identity}, {in_words(size)}, sha256 {sha256}")
    now = installed(answer, "now")
    if now is None or now.sha256 != sha256:
        refuse_without_room(host.name, place, room_of(answer), size)
    return switched(place, host.do(["receive", place, sha256, str(identity)], program))


def roll_back(machine: Machine, host: Host, folder: str) -> Switched:
    """Switch a host to the program before the one in use, which becomes the one before.

    Raises DeployError where there is none, with the host's program as it was.
    """
    place = place_of(machine, folder)
    return switched(place, host.do(["rollback", place]))


def install_unit(machine: Machine, host: Host) -> Answer:
    """Install the systemd unit on a host, once the program is in UNIT_FOLDER; what is missing."""
    return host.do(["unit", place_of(machine, UNIT_FOLDER), machine.name], UNIT)


def place_of(machine: Machine, folder: str) -> str:
    """The machine's folder on a host."""
    if not FOLDER.fullmatch(folder):
        raise DeployError(
            f'--folder: found "{folder}"; allowed: a path of letters, digits and _ . / + -, such as'
            f" {UNIT_FOLDER}; without a / in front it is below your home folder there"
        )
    return f"{folder.removeprefix('~/').rstrip('/')}/{machine.name}"


def identity_of(program: Path, machine: Machine, processor: Processor) -> Identity:
    """What the program that was built carries, which is what was asked for."""
    identity = carried_identity(program)
    if (identity.machine, identity.processor) != (machine.name, processor.name):
        raise DeployError(
            f"{program}: found {identity}; allowed: {machine.name} for {processor.name}, which"
            f" {processor.compiler} was asked for: see what that compiles for"
        )
    return identity


def refuse_without_room(host: str, place: str, room: int, size: int) -> None:
    """DeployError where a program of so many bytes does not fit."""
    if room < size + SPARE:
        raise DeployError(
            f"{host}: {place}: found {in_words(room)} free; allowed: {in_words(size + SPARE)} for"
            " the program and a little more; nothing was changed there; make room, or name another"
            " folder with --folder"
        )


def room_of(answer: Answer) -> int:
    """Free bytes."""
    return int(answer["free"]) * 1024


def in_words(size: int) -> str:
    """A size in words."""
    return f"{size / 1e6:.1f} MB" if size < 1e9 else f"{size / 1e9:.1f} GB"


def installed(answer: Answer, key: str) -> Installed | None:
    """A program that the host tells of."""
    if key not in answer:
        return None
    sha256, _, text = answer[key].partition(" ")
    return Installed(sha256, text)


def switched(place: str, answer: Answer) -> Switched:
    """What the host tells of its folder."""
    now = installed(answer, "now")
    assert now is not None
    return Switched(
        f"{place}/turnbuckle", installed(answer, "before"), now, installed(answer, "previous")
    )
