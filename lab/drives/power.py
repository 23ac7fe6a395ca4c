"""Power stage of a drive: the state machine of CiA 402, transitions 0 to 16.

Pure: states and commands in, states out. Transitions 0 and 1 belong to power-on, 13 and 14 to
errors; drive.py makes them.
"""

from enum import Enum


class Power(Enum):
    """States; the value is the pattern in the statusword."""

    NOT_READY = 0x00
    OFF = 0x40  # switch on disabled
    READY = 0x21  # ready to switch on
    ON = 0x23  # switched on
    ENABLED = 0x27  # operation enabled
    QUICK_STOP = 0x07  # quick stop active
    FAULT_REACTION = 0x0F
    FAULT = 0x08


class Command(Enum):
    """What a controlword asks for."""

    NONE = 0
    SHUTDOWN = 1
    SWITCH_ON = 2  # also: disable operation
    ENABLE = 3
    DISABLE_VOLTAGE = 4
    QUICK_STOP = 5


MOVING = (Power.ENABLED, Power.QUICK_STOP, Power.FAULT_REACTION)
"""States in which the motor may carry current."""
STAY_IN_QUICK_STOP = (5, 6)
"""Values of 605A after which the drive stands still with its motor energised."""
FAULT_RESET = 0x80


def command(controlword: int) -> Command:
    """Read a controlword; while the fault reset bit is set it holds no other command."""
    if not controlword & 0x02:
        return Command.DISABLE_VOLTAGE
    if not controlword & 0x04:
        return Command.QUICK_STOP
    pattern = controlword & 0x8F
    if pattern & 0x87 == 0x06:
        return Command.SHUTDOWN
    return {0x07: Command.SWITCH_ON, 0x0F: Command.ENABLE}.get(pattern, Command.NONE)


TRANSITIONS = {
    (Power.OFF, Command.SHUTDOWN): Power.READY,  # 2
    (Power.READY, Command.SWITCH_ON): Power.ON,  # 3
    (Power.READY, Command.ENABLE): Power.ENABLED,  # 3 and 4
    (Power.READY, Command.DISABLE_VOLTAGE): Power.OFF,  # 7
    (Power.READY, Command.QUICK_STOP): Power.OFF,  # 7
    (Power.ON, Command.ENABLE): Power.ENABLED,  # 4
    (Power.ON, Command.SHUTDOWN): Power.READY,  # 6
    (Power.ON, Command.DISABLE_VOLTAGE): Power.OFF,  # 10
    (Power.ON, Command.QUICK_STOP): Power.OFF,  # 10
    (Power.ENABLED, Command.SWITCH_ON): Power.ON,  # 5
    (Power.ENABLED, Command.SHUTDOWN): Power.READY,  # 8
    (Power.ENABLED, Command.DISABLE_VOLTAGE): Power.OFF,  # 9
    (Power.ENABLED, Command.QUICK_STOP): Power.QUICK_STOP,  # 11
    (Power.QUICK_STOP, Command.DISABLE_VOLTAGE): Power.OFF,  # 12
    (Power.QUICK_STOP, Command.ENABLE): Power.ENABLED,  # 16, where 605A lets the drive stay
}


def follow(state: Power, asked: Command, quick_stop_option: int) -> Power:
    """The state that a command leads to; the same state where it leads nowhere."""
    if (state, asked) == (Power.QUICK_STOP, Command.ENABLE):
        return Power.ENABLED if quick_stop_option in STAY_IN_QUICK_STOP else state
    return TRANSITIONS.get((state, asked), state)
