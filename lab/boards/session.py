"""One session of OpenOCD with a chip: Debian's unmodified program and its own files of targets."""

import re
import shutil
import signal
import subprocess
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from turnbuckle.codegen.processes import hear_of_death
from turnbuckle.lab.boards import BoardError
from turnbuckle.lab.boards.chip import Chip
from turnbuckle.lab.boards.probe import probe_options

PROCEDURES = Path(__file__).with_name("session.tcl")
PATIENCE = 180.0
"""Seconds for a session: a slow probe takes half a minute for the whole flash."""
#: Nobody else may talk to the chip meanwhile, so that nothing holds a port of the computer.
NO_PORTS = "gdb_port disabled; tcl_port disabled; telnet_port disabled"


@dataclass(frozen=True)
class Outcome:
    """How a session has ended."""

    done: bool
    step: str
    """The last one that was begun; empty where the chip was not reached."""
    refused: str
    """What the chip is that it must not be; empty where it is as it must be."""
    said: str
    """All that OpenOCD said."""


class Session:
    """Sessions with one kind of chip by one probe; nothing is asked of a person."""

    def __init__(self, chip: Chip, probe: str) -> None:
        """BoardError for an unknown probe, and without OpenOCD."""
        self._options = probe_options(probe)
        if shutil.which("openocd") is None:
            raise BoardError(
                "openocd, which writes into the flash, is not installed here; nothing was changed;"
                " sudo apt-get install openocd"
            )
        self.chip = chip

    def look(self, length: int) -> tuple[Outcome, bytes]:
        """What is in the flash now, from its begin; the chip is started anew."""
        with tempfile.TemporaryDirectory(prefix="turnbuckle-") as folder:
            outcome = self._run([self._dump(Path(folder), length), "turnbuckle_start"])
            return outcome, _content(Path(folder))

    def program(self, content: bytes, head: int) -> tuple[Outcome, bytes]:
        """Erase, write, verify, start; and the first `head` bytes of what was there before."""
        chip = self.chip
        with tempfile.TemporaryDirectory(prefix="turnbuckle-") as name:
            folder = Path(name)
            (folder / "image").write_bytes(content)
            (folder / "first").write_bytes(content[: chip.page])
            (folder / "rest").write_bytes(content[chip.page :])
            files = " ".join(f"{{{folder / part}}}" for part in ("image", "first", "rest"))
            written = f"turnbuckle_program {files} {chip.flash:#x} {len(content)} {chip.page}"
            outcome = self._run([self._dump(folder, head), written, "turnbuckle_start"])
            return outcome, _content(folder)

    def _dump(self, folder: Path, length: int) -> str:
        return f"turnbuckle_look {{{folder / 'found'}}} {self.chip.flash:#x} {length}"

    def _run(self, commands: Sequence[str]) -> Outcome:
        chip = self.chip
        connect = (
            f"turnbuckle_connect {chip.identity_register:#x} {chip.identity:#x}"
            f" {chip.size_register:#x} {chip.size} {chip.option_register:#x}"
        )
        # The target's file would set a speed at every reset, which some probes do not have.
        speed = "[target current] configure -event reset-start {}"
        words = ["openocd", *self._options, "-c", NO_PORTS, "-f", chip.target]
        for each in (speed, f"source {{{PROCEDURES}}}", "init", connect, *commands, "shutdown"):
            words += ["-c", each]
        return _outcome(*_said(words))


def _said(words: Sequence[str]) -> tuple[int, str]:
    try:
        done = subprocess.run(
            words,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            errors="replace",
            timeout=PATIENCE,
            preexec_fn=partial(hear_of_death, signal.SIGTERM),
        )
    except subprocess.TimeoutExpired as late:
        said = late.stderr or b""
        text = said if isinstance(said, str) else said.decode(errors="replace")
        return -1, f"{text}\nError: no answer within {PATIENCE:.0f} s\n"
    return done.returncode, done.stderr


def _outcome(status: int, said: str) -> Outcome:
    steps = re.findall(r"^turnbuckle step (\w+)", said, re.MULTILINE)
    refused = re.search(r"^turnbuckle refused (.+)$", said, re.MULTILINE)
    done = status == 0 and bool(re.search(r"^turnbuckle done$", said, re.MULTILINE))
    return Outcome(done, steps[-1] if steps else "", refused[1] if refused else "", said)


def _content(folder: Path) -> bytes:
    found = folder / "found"
    return found.read_bytes() if found.exists() else b""
