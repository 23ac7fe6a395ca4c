"""The causes of a stop that show on the wire, with their reactions as the table has them."""

from enum import Enum


class Cause(Enum):
    """A row of the table of causes; the value is its reaction where cables may pull."""

    def __init__(self, reaction: str, number: int) -> None:
        self.is_hard = reaction == "hard"
        self.reaction = reaction

    @property
    def may_be_hard(self) -> bool:
        """Whether it looks on the wire like a cause of hard stops: a bus is off, or full."""
        return self is Cause.BUS_FULL

    DRIVE_DIFFERENT = "refuse", 0
    DRIVE_SETUP = "soft", 1
    DRIVE_TWICE = "soft", 2
    STRANGER = "soft", 3
    DRIVE_SILENT = "hard", 4
    DRIVE_LATE = "soft", 5
    DRIVE_FAULT = "hard", 6
    DRIVE_STATE = "hard", 7
    DRIVE_STUCK = "soft", 8
    DRIVE_DEAF = "hard", 9
    BUS_FULL = "soft", 10
    CYCLES_MISSED = "soft", 12
    HOMING = "soft", 13
    ENCODER_JUMP = "hard", 14
    RUNAWAY = "hard", 15
    BASE_RUNAWAY = "hard", 16
    BASE_BLOCKED = "hard", 17
    WRONG_WAY = "hard", 18


DEAF_CYCLES = 100
"""That a drive may tell another torque than it was told."""
HEARTBEAT_LOST = 0x8130
"""Emergency code of a drive that misses the master."""
WARNINGS = (0x0000, 0xFF01)
"""Emergency codes that are none, or a warning."""
