"""The power state machine of a CiA 402 drive, as the standard's table of transitions has it."""

RESET = 0x80
"""Bit of the controlword whose rising edge resets a fault."""

# The transitions of CiA 402 that a controlword asks for: (from, command) -> to.
TRANSITIONS = {
    ("OFF", "shutdown"): "READY",
    ("READY", "switch on"): "ON",
    ("READY", "enable"): "ENABLED",
    ("READY", "disable voltage"): "OFF",
    ("READY", "quick stop"): "OFF",
    ("ON", "enable"): "ENABLED",
    ("ON", "shutdown"): "READY",
    ("ON", "disable voltage"): "OFF",
    ("ON", "quick stop"): "OFF",
    ("ENABLED", "switch on"): "ON",
    ("ENABLED", "shutdown"): "READY",
    ("ENABLED", "disable voltage"): "OFF",
    ("ENABLED", "quick stop"): "QUICK_STOP",
    ("QUICK_STOP", "disable voltage"): "OFF",
    ("QUICK_STOP", "enable"): "ENABLED",
}
AUTOMATIC = {"NOT_READY": "OFF", "FAULT_REACTION": "FAULT"}
STATUSWORDS = {
    "NOT_READY": 0x0200,
    "OFF": 0x0240,
    "READY": 0x0231,
    "ON": 0x0233,
    "ENABLED": 0x0237,
    "QUICK_STOP": 0x0217,
    "FAULT_REACTION": 0x021F,
    "FAULT": 0x0218,
}


def command_of(controlword: int) -> str:
    """The command that the bits of a controlword give."""
    if not controlword & 0x02:
        return "disable voltage"
    if not controlword & 0x04:
        return "quick stop"
    return {0x0: "shutdown", 0x1: "switch on", 0x9: "enable"}[controlword & 0x09]


class Machine:
    """The state machine of a drive."""

    def __init__(self, power: str) -> None:
        self.power = power
        self.controlword = 0

    def take(self, controlword: int) -> None:
        """Act on a controlword."""
        risen = controlword & ~self.controlword & RESET
        self.controlword = controlword
        if self.power == "FAULT":
            self.power = "OFF" if risen else "FAULT"
        elif self.power in AUTOMATIC:
            self.power = AUTOMATIC[self.power]
        else:
            step = (self.power, command_of(controlword))
            self.power = TRANSITIONS.get(step, self.power)
