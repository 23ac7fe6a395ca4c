"""Brings an image into a board's flash, after it was seen to be the right one."""

from dataclasses import dataclass

from turnbuckle.lab.boards import BoardError
from turnbuckle.lab.boards.record import HEAD, Record, record_in
from turnbuckle.lab.boards.session import Session
from turnbuckle.lab.boards.trouble import why


@dataclass(frozen=True)
class Flashed:
    """What is in the chip now, and what was."""

    before: str
    now: Record


def flash(content: bytes, record: Record, session: Session, probe: str, again: str) -> Flashed:
    """Write an image, verify it, start it.

    again: the command that does it once more. Raises BoardError, which tells what the chip holds.
    """
    outcome, found = session.program(content, HEAD)
    if not outcome.done:
        old = record_in(found)
        length = max(len(content), old.length if old and old.length <= session.chip.size else 0)
        raise BoardError(why(session, probe, outcome, length, again))
    return Flashed(_before(found), record)


def _before(found: bytes) -> str:
    if not found.strip(b"\xff"):
        return "nothing that starts: its begin is erased"
    record = record_in(found)
    return f"{record.identity}, {record.board}" if record else "no program of Turnbuckle"
