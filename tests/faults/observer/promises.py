"""What the documents promise and the wire can show, and the record of what broke it."""

from enum import Enum

MOST_KEPT = 100
"""Findings that are kept."""


class Promise(Enum):
    """A promise; the value is its sentence, or the part of a sentence, as the documents have it."""

    SET_UP_FIRST = "writes every object of the contract and reads it back; waits for you to arm"
    IDENTITY_FIRST = "The identity is vendor, product and revision where given, rated torque"
    NO_TORQUE_BEFORE = "nothing has torque yet: the machine stays without"
    NONE_ALONE = "No cable pulls while another one that should pull cannot"
    WITHIN_LIMITS = "Every setpoint passes the torque gate"
    WITHIN_RATE = "all cables go to no torque at the gate's rate, `TB_TORQUE_STEP` a cycle"
    ONE_A_SYNC = "one PDO either way with every SYNC"
    TOGETHER = "what stops one drive stops all"
    SOFT_TO_NONE = (
        "in `TB_STOP_CYCLES` cycles all cables go together to the torque of `tension.min`, then"
        " together to none"
    )
    SOFT_BASES = "the bases' forces go to none at once, by `TB_RAIL_TORQUE_STEP` a cycle"
    HARD_RAMP = "`ceil(TB_TORQUE_LIMIT / TB_TORQUE_STEP)` cycles"
    HARD_WITHOUT_POWER = "a cable whose drive has no power at once"
    HARD_BASES = "base drives are switched off at once, cable drives when no cable pulls"
    OFF_IN_TIME = "off, at most `TB_HEARTBEAT_TIMEOUT` cycles"
    FAULTS_RESET = "While CONFIGURE resets faults: when it stands after `TB_STATE_TIMEOUT`"
    STAYS_IN_FAULT = "There it stays until `TB_REQUEST_RESET` begins from power-on"
    BEATS_AT_WORK = "The master's heartbeat leaves in completed and checked cycles only"
    BEATS_WITHHELD = "In HARD_STOP and FAULT it leaves only while every drive is off"
    LETS_GO_ALONE = "every drive switches off by itself (object 6007) within the time in its object"


class Findings(list[str]):
    """What was found, in words; each promise is told once of a drive until the next stop."""

    def __init__(self) -> None:
        super().__init__()
        self._told: set[tuple[Promise, str]] = set()

    def add(self, time: float, culprit: str, promise: Promise, what: str) -> None:
        """A promise was broken at a time [s] by, or concerning, a drive or bus."""
        if (promise, culprit) not in self._told and len(self) < MOST_KEPT:
            self._told.add((promise, culprit))
            self.append(f"{time:.6f} s: {culprit}: {promise.name}: {what} ({promise.value})")

    def forget(self) -> None:
        """Another stop: what is broken again is told again."""
        self._told.clear()
