"""Watches a running program in the terminal, and sends it requests."""

import os
import select
import sys
import termios
import time
import tty
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

from rich.console import Console, Group, RenderableType
from rich.live import Live
from rich.text import Text

from turnbuckle.lab.live import LiveError
from turnbuckle.lab.live.identity import hash_of
from turnbuckle.lab.live.telemetry import Request, Telemetry, default_path, running
from turnbuckle.lab.live.view import Reading, show
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine

REFRESH = 0.2
"""Seconds between two pictures."""
KEYS: dict[str, Request] = {"a": "arm", "s": "stop", "r": "reset"}
QUIT = {"q", "\x03", "\x04"}
HELP = "a arm   s stop   r reset   q leave"


class Subject(NamedTuple):
    """What is watched."""

    path: Path
    """Of its telemetry."""
    machine: Machine | None
    """Known where its file was given."""

    def open(self) -> Telemetry:
        """Its telemetry.

        Raises LiveError where no program has written any, or one of another machine.
        """
        telemetry = Telemetry(self.path)
        self._refuse_other(telemetry)
        return telemetry

    def wait(self, console: Console) -> Telemetry:
        """Its telemetry, as soon as a program runs that writes it; says for what it waits."""
        telemetry = running(self.path)
        if telemetry is None:
            console.print(
                f"{self.path}: no program runs that writes here; waiting for `turnbuckle run`,"
                " Ctrl-C leaves",
                soft_wrap=True,
            )
        while telemetry is None:
            time.sleep(REFRESH)
            telemetry = running(self.path)
        self._refuse_other(telemetry)
        return telemetry

    def _refuse_other(self, telemetry: Telemetry) -> None:
        if self.machine is None:
            return
        wanted = hash_of(self.machine)
        if telemetry.hash != wanted:
            raise LiveError(
                f"{telemetry.path}: found the program of {telemetry.machine} {telemetry.hash};"
                f" allowed: {self.machine.name} {wanted}, the hash of {self.machine.path}"
            )


def subject_of(words: str, telemetry: Path | None) -> Subject:
    """What a machine file, or a machine's name, means."""
    if words.endswith(".toml") or "/" in words:
        machine = load_machine(words)
        return Subject(telemetry or default_path(machine.name), machine)
    return Subject(telemetry or default_path(words), None)


def request(telemetry: Telemetry, what: Request) -> None:
    """Ask a program that still runs."""
    if telemetry.ended:
        raise LiveError(f"{telemetry.path}: its program has ended: nobody is there to {what}")
    telemetry.ask(what)


def read(telemetry: Telemetry, earlier: Reading | None) -> Reading:
    """What there is to see now; rates since an earlier reading."""
    ended = telemetry.ended  # before the rest: what is read after the end does not change
    status = telemetry.status()
    before = status if earlier is None else earlier.status
    return Reading(ended, telemetry.latest(), status, before)


def print_once(telemetry: Telemetry, machine: Machine | None, console: Console) -> None:
    """One picture, for scripts and people who only want a look."""
    first = read(telemetry, None)
    time.sleep(REFRESH)
    console.print(show(telemetry, read(telemetry, first), machine))


def watch(telemetry: Telemetry, machine: Machine | None, console: Console) -> None:
    """A living picture until the user leaves or the program ends."""
    reading = read(telemetry, None)
    with typed_keys() as keys, Live(console=console, auto_refresh=False, screen=False) as live:
        while True:
            reading = read(telemetry, reading)
            live.update(picture(telemetry, reading, machine), refresh=True)
            if reading.ended:
                return
            for key in keys(REFRESH):
                if key in QUIT:
                    return
                if key in KEYS:
                    telemetry.ask(KEYS[key])


def picture(telemetry: Telemetry, reading: Reading, machine: Machine | None) -> RenderableType:
    """The keys, and below them the view, of which a small terminal shows the beginning."""
    return Group(Text(HELP, style="dim"), show(telemetry, reading, machine))


class Keys:
    """Keys as they are typed; none where there is no keyboard."""

    def __init__(self, keyboard: int | None) -> None:
        self._keyboard = keyboard

    def __call__(self, seconds: float) -> Sequence[str]:
        """The keys typed within a time; waits no longer than for the first."""
        if self._keyboard is None:
            time.sleep(seconds)
            return ""
        if not select.select([self._keyboard], [], [], seconds)[0]:
            return ""
        typed = os.read(self._keyboard, 64)
        return typed.decode(errors="replace") if typed else "q"


@contextmanager
def typed_keys() -> Iterator[Keys]:
    """Keys without the return key, while the context lasts."""
    if not sys.stdin.isatty():
        yield Keys(None)
        return
    keyboard = sys.stdin.fileno()
    before = termios.tcgetattr(keyboard)
    try:
        tty.setcbreak(keyboard)
        yield Keys(keyboard)
    finally:
        termios.tcsetattr(keyboard, termios.TCSADRAIN, before)
