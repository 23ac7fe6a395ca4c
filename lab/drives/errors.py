"""Error codes of a drive, and what it does about them."""

from enum import Enum


class Reaction(Enum):
    """What a drive does when an error occurs."""

    POWER_OFF = "power stage off at once"
    FAULT_OPTION = "as the fault reaction option code 605E says"
    ABORT_OPTION = "as the abort connection option code 6007 says"
    WARNING = "nothing: a warning"


HEARTBEAT_LOST = 0x8130
RECEIVE_LENGTH = 0x8210
FOLLOWING_ERROR = 0x8611
NO_ERROR = 0x0000

_FAULT_OPTION = {0x6320, 0x8611, 0x8A80, 0x8A81, 0x8A82, 0xFF10}
_ABORT_OPTION = {
    0x6081, 0x8110, 0x8111, 0x8120, 0x8130, 0x8150, 0x81FD, 0x81FE, 0x81FF, 0x8210, 0x8250,
}  # fmt: skip
_WARNING = {0xFF01}
LATCHED = {0x8120, 0x8130}
"""Errors whose fault reset is ignored until NMT reset communication."""
HOMING_LOST = {0x7380, 0x7381, 0x7382, 0x7388, 0x7389, 0x738A, 0x7392, 0xFF02}
"""Errors after which the position no longer refers to home."""

GENERIC, MANUFACTURER = 0x01, 0x80
_REGISTER = {0x2: 0x02, 0x3: 0x04, 0x4: 0x08, 0x8: 0x10}
"""Bit of the error register 1001 by the first digit of a code."""


def reaction(code: int) -> Reaction:
    """What a drive does about an error."""
    if code in _WARNING:
        return Reaction.WARNING
    if code in _FAULT_OPTION:
        return Reaction.FAULT_OPTION
    return Reaction.ABORT_OPTION if code in _ABORT_OPTION else Reaction.POWER_OFF


def register_bits(code: int) -> int:
    """Bits of the error register that an error sets."""
    if code == FOLLOWING_ERROR:
        return GENERIC | 0x20
    if code >> 8 == 0x73:
        return GENERIC | MANUFACTURER
    return GENERIC | _REGISTER.get(code >> 12, 0)
