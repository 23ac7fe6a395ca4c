"""Error codes of a drive, and what it does about them."""

from enum import Enum

from turnbuckle.model.bus.drive_kinds.kind import DriveKind, Severity


class Reaction(Enum):
    """What a drive does when an error occurs."""

    POWER_OFF = "power stage off at once"
    FAULT_OPTION = "as the fault reaction option code 605E says"
    ABORT_OPTION = "as the option of a lost connection says"
    WARNING = "nothing: a warning"


HEARTBEAT_LOST = 0x8130
RECEIVE_LENGTH = 0x8210
FOLLOWING_ERROR = 0x8611
NO_ERROR = 0x0000

GENERIC, MANUFACTURER = 0x01, 0x80
_REGISTER = {0x2: 0x02, 0x3: 0x04, 0x4: 0x08, 0x8: 0x10}
"""Bit of the error register 1001 by the first digit of a code."""


def reaction(kind: DriveKind, code: int) -> Reaction:
    """What a drive does about an error."""
    error = kind.error_of(code)
    if error is not None and error.severity is Severity.WARNING:
        return Reaction.WARNING
    if code in kind.simulated.fault_option:
        return Reaction.FAULT_OPTION
    is_lost = code in kind.simulated.abort_option
    return Reaction.ABORT_OPTION if is_lost else Reaction.POWER_OFF


def register_bits(code: int) -> int:
    """Bits of the error register that an error sets."""
    if code == FOLLOWING_ERROR:
        return GENERIC | 0x20
    if code >> 8 == 0x73:
        return GENERIC | MANUFACTURER
    return GENERIC | _REGISTER.get(code >> 12, 0)
