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

from rich.console import Console, Group, RenderableType
from rich.live import Live
from rich.text import Text

from lab.live import LiveError
from lab.live.identity import hash_of
from lab.live.telemetry import Request, Telemetry, default_path
from lab.live.view import Reading, show
from model.machine import Machine, load_machine

REFRESH = 0.2
"""Seconds between two pictures."""
KEYS: dict[str, Request] = {"a": "arm", "s": "stop", "r": "reset"}
QUIT = {"q", "\x03", "\x04"}
HELP = "a arm   s stop   r reset   q leave"


def open_subject(subject: str, telemetry: Path | None) -> tuple[Telemetry, Machine | None]:
    """The telemetry of a machine file or of a machine's name, and the machine of a file.

    Raises LiveError where no program writes, or one of another machine than the file's.
    """
    if subject.endswith(".toml") or "/" in subject:
        machine = load_machine(subject)
        opened = Telemetry(telemetry or default_path(machine.name))
        wanted = hash_of(machine)
        if opened.hash != wanted:
            raise LiveError(
                f"{opened.path}: found the program of {opened.machine} {opened.hash};"
                f" allowed: {machine.name} {wanted}, the hash of {subject}"
            )
        return opened, machine
    return Telemetry(telemetry or default_path(subject)), None


def request(telemetry: Telemetry, what: Request) -> None:
    """Ask a program that still runs."""
    if telemetry.ended:
        raise LiveError(f"{telemetry.path}: its program has ended: nobody is there to {what}")
    telemetry.ask(what)


def read(telemetry: Telemetry, earlier: Reading | None) -> Reading:
    """What there is to see now; rates since an earlier reading."""
    ended = telemetry.ended  # before the rest: what is read after the end does not change
    status = telemetry.status()
    now = time.monotonic()
    before, since = (status, now) if earlier is None else (earlier.status, earlier.at)
    return Reading(ended, telemetry.latest(), status, before, now, max(now - since, 1e-3))


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
