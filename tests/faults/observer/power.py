"""Power states of a drive as CiA 402 has them, in statuswords and controlwords."""

from enum import Enum


class Power(Enum):
    """States, and whether the motor may have torque in them."""

    NOT_READY = False, 0
    OFF = False, 1
    READY = False, 2
    ON = False, 3
    ENABLED = True, 4
    QUICK_STOP = True, 5
    REACTING = True, 6
    FAULT = False, 7

    @property
    def may_pull(self) -> bool:
        """Whether the motor may have torque."""
        return self.value[0]

    @property
    def words(self) -> str:
        """The state in words."""
        return self.name.lower().replace("_", " ")


_FOUR_BITS = {0x00: Power.NOT_READY, 0x40: Power.OFF, 0x0F: Power.REACTING, 0x08: Power.FAULT}
_FIVE_BITS = {0x21: Power.READY, 0x23: Power.ON, 0x27: Power.ENABLED, 0x07: Power.QUICK_STOP}
POWERS = [_FOUR_BITS.get(word & 0x4F) or _FIVE_BITS.get(word & 0x6F) for word in range(0x80)]
"""By the seven lowest bits of a statusword; None where they are none of CiA 402."""

COMMAND, ENABLE, FAULT_RESET = 0x0F, 0x0F, 0x80
ORDERED = {0x06: Power.READY, 0x07: Power.ON, ENABLE: Power.ENABLED}
"""States that the lowest bits of a controlword order, off excepted."""
REFERENCED, HOMING_ERROR, START_HOMING = 1 << 15, 1 << 13, 0x10
