"""What the runtime's numbers mean: the enumerations of runtime/core, in words."""

STATES = (
    "INIT",
    "IDENTIFY",
    "CONFIGURE",
    "HOME",
    "TENSION",
    "RUN",
    "SOFT_STOP",
    "HARD_STOP",
    "FAULT",
)
"""tb_state, runtime/core/cycle.h"""

POWERS = (
    "unknown",
    "not ready",
    "off",
    "ready",
    "on",
    "enabled",
    "quick stop",
    "fault reaction",
    "fault",
)
"""tb_power, runtime/core/drive.h"""

MODES = ("none", "torque", "position", "homing")
"""tb_mode, runtime/core/drive.h"""

TASKS = ("", "reset", "identify", "configure", "start", "switch mode")
"""tb_task, runtime/core/drive.h"""

SILENCES = ("", "silent", "under local control")
"""tb_silence, runtime/core/drive.h"""

BUS_STATES = ("active", "warning", "passive", "off", "not open")
"""tb_can_state, runtime/can/can.h"""


def word(words: tuple[str, ...], number: int) -> str:
    """The word of a number; the number itself where there is none."""
    return words[number] if number < len(words) else str(number)
