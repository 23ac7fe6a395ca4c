"""What the master must do once a cause has shown: a soft stop or a hard one, cycle by cycle."""

from collections.abc import Sequence
from dataclasses import dataclass, field

from observer.causes import Cause
from observer.drive import Find, WatchedDrive
from observer.limits import Times
from observer.promises import Promise

SAME = 2
"""Pulls that differ by so much are the same: each is rounded [per mille]."""


@dataclass
class Stop:
    """A stop that must have begun in a cycle, and what everything was told before it."""

    cause: Cause
    culprit: str
    begin: int
    drives: Sequence[WatchedDrive]
    times: Times
    find: Find
    start: dict[str, int] = field(init=False)

    def __post_init__(self) -> None:
        self.start = {drive.name: drive.pull(self.begin - 1) for drive in self.drives}
        self._cables = [drive for drive in self.drives if drive.is_cable]
        self._bases = [drive for drive in self.drives if not drive.is_cable]

    @property
    def is_hard(self) -> bool:
        """Whether it is a hard stop."""
        return self.cause.is_hard

    def yields_to(self, cause: Cause, cycle: int) -> bool:
        """Whether another cause asks for more: a hard stop, or the same sooner."""
        if self.is_hard is not cause.is_hard:
            return cause.is_hard
        return cycle < self.begin

    @property
    def name(self) -> str:
        """The cause, in words."""
        return f"{self.cause.name} of {self.culprit} in cycle {self.begin}"

    @property
    def ramp(self) -> int:
        """Cycles until no cable may pull."""
        return self.times.slacken if self.is_hard else self.times.stop

    @property
    def off_by(self) -> int:
        """The cycle in which every drive must be off."""
        return self.begin + self.ramp + self.times.drive_timeout + 1

    def judge(self, cycle: int) -> None:
        """What was ordered in one cycle of the stop."""
        if cycle < self.begin:
            return
        if self.is_hard:
            self.hard_ramp(cycle)
            self.hard_without_power(cycle)
            self.hard_bases(cycle)
        else:
            self.soft_to_none(cycle)
            self.soft_together(cycle)
            self.soft_bases(cycle)
        if cycle == self.off_by:
            self.off_in_time(cycle)

    # -- a hard stop --------------------------------------------------------------------------

    def hard_ramp(self, cycle: int) -> None:
        """All cables go to no torque at the gate's rate."""
        steps = cycle - self.begin + 1
        for drive in self._hearing(self._cables, cycle):
            most = max(0, self.start[drive.name] - steps * (drive.bounds.step - 1)) + 1
            pull = drive.pull(cycle)
            if pull > most:
                self._found(cycle, drive, Promise.HARD_RAMP, f"pulls {pull}, at most {most}")

    def hard_without_power(self, cycle: int) -> None:
        """A cable whose drive has no power goes there at once."""
        for drive in self._hearing(self._cables, cycle):
            pull = drive.pull(cycle)
            since = drive.powerless_since
            if since is not None and since <= cycle and pull > 0:
                self._found(cycle, drive, Promise.HARD_WITHOUT_POWER, f"is told to pull {pull}")

    def hard_bases(self, cycle: int) -> None:
        """Base drives are switched off at once."""
        for drive in self._hearing(self._bases, cycle):
            if drive.last_enabling >= self.begin:
                self._found(cycle, drive, Promise.HARD_BASES, "is told to have torque")

    # -- a soft stop --------------------------------------------------------------------------

    def soft_to_none(self, cycle: int) -> None:
        """Cables come down to none in time, never up again, and in a ramp."""
        is_over = cycle >= self.begin + self.times.stop
        for drive in self._hearing(self._cables, cycle):
            pull, bounds = drive.pull(cycle), drive.bounds
            most = max(self.start[drive.name], bounds.weakest) + 1
            if pull > (0 if is_over else most):
                what = f"pulls {pull}, at most {0 if is_over else most}"
                self._found(cycle, drive, Promise.SOFT_TO_NONE, what)
            fell = drive.pull(cycle - 1) - pull
            if fell > bounds.soft_step and not self.cause.may_be_hard:
                self._found(cycle, drive, Promise.SOFT_TO_NONE, f"let go by {fell} at once")

    def soft_together(self, cycle: int) -> None:
        """In the second half all cables keep the same share of the torque of tension.min, or of
        what they pulled where that was less."""
        if cycle <= self.begin + self.times.half_stop:
            return
        cables = self._hearing(self._cables, cycle)
        shares = [(drive.pull(cycle), self._rest(drive), drive) for drive in cables]
        for pull, rest, drive in shares:
            for other_pull, other_rest, other in shares:
                # Cross-multiplied: pull / rest > other_pull / other_rest, beyond rounding.
                if pull * other_rest - other_pull * rest > SAME * max(rest, other_rest):
                    what = f"pulls {pull} of {rest} while {other.name} pulls"
                    what = f"{what} {other_pull} of {other_rest}"
                    self._found(cycle, drive, Promise.SOFT_TO_NONE, what)

    def _rest(self, drive: WatchedDrive) -> int:
        return min(self.start[drive.name], drive.bounds.weakest)

    def soft_bases(self, cycle: int) -> None:
        """Forces of the bases fall to none, at the gate's rate, either way they push.

        What the master hears after it has computed acts one cycle later: what is told in the
        stop's first cycle may still be from before.
        """
        for drive in self._hearing(self._bases, cycle):
            if cycle == self.begin:
                self.start[drive.name] = max(self.start[drive.name], drive.pull(cycle), key=abs)
            steps = (cycle - self.begin) // drive.wire.divider
            most = max(0, abs(self.start[drive.name]) - steps * (drive.bounds.step - 1)) + 1
            force = drive.pull(cycle)
            if abs(force) > most and drive.follows_torque:
                what = f"is told a force of {force}, at most {most}"
                self._found(cycle, drive, Promise.SOFT_BASES, what)

    # -- the end ------------------------------------------------------------------------------

    def off_in_time(self, cycle: int) -> None:
        """Every drive is switched off."""
        for drive in self._hearing(self.drives, cycle):
            if drive.last_enabling >= cycle - drive.wire.divider:
                self._found(cycle, drive, Promise.OFF_IN_TIME, "is still told to have torque")

    def _hearing(self, drives: Sequence[WatchedDrive], cycle: int) -> list[WatchedDrive]:
        return [drive for drive in drives if drive.wire.cycle >= cycle - drive.wire.divider]

    def _found(self, cycle: int, drive: WatchedDrive, promise: Promise, what: str) -> None:
        what = f"cycle {cycle}: {what}, after {self.name}"
        self.find(cycle * self.times.period, drive.name, promise, what)
