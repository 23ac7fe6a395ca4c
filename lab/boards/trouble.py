"""Why a chip could not be programmed, what is in it now, and the command that mends it."""

import re

from turnbuckle.lab.boards.probe import probe_options
from turnbuckle.lab.boards.record import is_whole, record_in
from turnbuckle.lab.boards.session import Outcome, Session

UNTOUCHED = "the program in the chip was not changed"
#: What OpenOCD says where the probe, or the chip at it, does not answer: words, and what it is.
BUSY = r"LIBUSB_ERROR_BUSY|Resource busy|Device or resource busy"
DENIED = r"LIBUSB_ERROR_ACCESS|Permission denied|insufficient permissions"
ABSENT = (
    r"open failed|unable to find a matching CMSIS-DAP|[Nn]o J-Link device found|No device found"
    r"|unable to open|Failed to connect|no device found|Connection refused"
)
OTHER_CHIP = r"UNEXPECTED: +(\w+).*|expected \d+ of \d+: (\w+)"


def why(session: Session, probe: str, outcome: Outcome, length: int, again: str) -> str:
    """The message of a session that was not done.

    length: bytes from the flash's begin that may hold a program. again: the command that does it
    once more.
    """
    chip = session.chip.name
    if outcome.refused:
        return f"{chip}: {_refused(chip, probe, outcome.refused)}"
    if outcome.step in ("", "connect", "look"):
        return _unreached(chip, probe, outcome, again)
    stopped = f"{STEPS[outcome.step]}: {last_error(outcome.said)}; {_now(session, length)}"
    mend = f"see to its power and to the wires of the probe, then do it again: {again}"
    return f"{chip}: {stopped}; {mend}"


STEPS = {
    "erase": "stopped while its flash was being erased",
    "write": "stopped while its flash was being written",
    "verify": "what is in its flash is not what was sent",
    "start": "was written and verified, but not started",
}


def _refused(chip: str, probe: str, words: str) -> str:
    kind, _, value = words.partition(" ")
    by_hand = unlocking(probe)
    return {
        "chip": f"found another chip at the probe, with the number {value}; allowed: {chip};"
        f" {UNTOUCHED}; connect the probe to the board, or name the board with --board",
        "size": f"found {value} KB of flash; allowed: the 512 KB of the board; {UNTOUCHED}",
        "locked": "is locked against reading (RDP level 1), by somebody who did not want its"
        f" program read; {UNTOUCHED}; unlocking erases all of it: {by_hand}; then take its power"
        " away and give it back",
        "sealed": f"is locked for good (RDP level 2): nobody can write to it; {UNTOUCHED}; take"
        " another board",
    }[kind]


def unlocking(probe: str) -> str:
    """What a person types to have a locked chip erased and opened."""
    options = " ".join(f"'{each}'" if " " in each else each for each in probe_options(probe))
    commands = "init; reset halt; stm32l4x unlock 0; shutdown"
    return f"openocd {options} -f target/stm32g4x.cfg -c '{commands}'"


def _unreached(chip: str, probe: str, outcome: Outcome, again: str) -> str:
    said = outcome.said
    if re.search(BUSY, said):
        return (
            f"{probe}: the probe is held by another program, such as another openocd;"
            f" {UNTOUCHED}; see it with ps aux | grep -i openocd, end it, then: {again}"
        )
    if re.search(DENIED, said):
        return (
            f"{probe}: you may not use the probe; {UNTOUCHED}; be of the group plugdev: sudo"
            ' usermod -aG plugdev "$USER", log in again and plug it in again'
        )
    if re.search(ABSENT, said):
        return (
            f"{probe}: found no such probe: {last_error(said)}; {UNTOUCHED}; plug it in, see it"
            " with lsusb, or name another one with --probe"
        )
    if found := re.search(OTHER_CHIP, said):
        number = found[1] or found[2]
        return (
            f"{chip}: found another chip at the probe, whose debug port says {number}; {UNTOUCHED};"
            " connect the probe to the board, or name the board with --board"
        )
    return (
        f"{chip}: does not answer the probe: {last_error(said)}; {UNTOUCHED}; see to its power and"
        f" the wires of the probe, then: {again}"
    )


def _now(session: Session, length: int) -> str:
    outcome, content = session.look(length)
    if not outcome.done or not content:
        return (
            "what is in the chip now cannot be read; an image that is not whole does not start:"
            " its first page is written last, and it checks its CRC before anything else"
        )
    return f"in the chip now: {described(content)}"


def described(content: bytes) -> str:
    """What a flash holds, in a line."""
    if not content.strip(b"\xff"):
        return "nothing: it is erased"
    record = record_in(content)
    if record is None and not content[:8].strip(b"\xff"):
        return "a part of an image without its begin, which does not start"
    if record is None:
        return "no program of Turnbuckle"
    if not is_whole(content):
        return f"a damaged image of {record.identity}, which stops at the check of its CRC"
    return f"{record.identity}, {record.board}, CRC {record.crc:08x}"


def last_error(said: str) -> str:
    """The last error that OpenOCD tells of."""
    errors = re.findall(r"^Error: (.+)$", said, re.MULTILINE)
    lines = [line.strip() for line in said.splitlines() if line.strip()]
    return str((errors or lines or ["OpenOCD said nothing"])[-1]).rstrip(".")
