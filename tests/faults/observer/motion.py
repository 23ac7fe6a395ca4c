"""How one drive moves and pulls, as it tells: the causes that show in position and torque.

A symptom counts only where every reading of the document agrees: speeds are those of single SYNCs,
and what is called a speed or a gain there is twice as much here.
"""

from collections.abc import Callable

from observer.causes import DEAF_CYCLES, Cause
from observer.limits import Bounds, Times

CERTAIN = 10
"""Answers in a row that are too fast however speed is measured."""
MOST_PUSH = 0.95
"""Share of the torque limit with which a carriage counts as pushed."""
GAIN = 1 / 20
"""Of the speed limit, that a carriage gains against its force."""

Accuse = Callable[[Cause, int, float], None]
"""Told of a cause, the cycle in which the reaction must begin, and the time [s]."""


class Motion:
    """Of one drive, answer by answer."""

    def __init__(self, is_cable: bool, bounds: Bounds, times: Times, accuse: Accuse) -> None:
        self._is_cable, self._bounds, self._times, self._accuse = is_cable, bounds, times, accuse
        self.reset()

    def reset(self) -> None:
        """Nothing is known."""
        self.position = self._moved = self._moved_before = self._fast = 0
        self.is_known = False
        """The last SYNC was answered: the next move is one of a single SYNC."""
        self._deaf_since = self._pushed_since = self._against_since = -1
        self._pushed_at = self._against = 0

    def is_fast(self, position: int) -> bool:
        """An answer tells where it is; whether it got there too fast, or lately did."""
        moved = position - self.position
        self.position, self._moved, self._moved_before = position, moved, self._moved
        is_known, self.is_known = self.is_known, True
        return is_known and (self._fast > 0 or abs(moved) > self._bounds.move)

    def judge_move(self, is_referenced: bool, time: float) -> None:
        """A move that is too far for one SYNC: at once, or bit by bit."""
        most, seen = self._bounds.move, self._times.seen(time)
        self._fast = self._fast + 1 if abs(self._moved) > most else 0
        if self._fast >= CERTAIN:
            cause = Cause.RUNAWAY if self._is_cable else Cause.BASE_RUNAWAY
            self._accuse(cause, seen, time)
        before = self._moved_before
        if is_referenced and abs(self._moved - before) > 2 * most and abs(before) < most:
            self._accuse(Cause.ENCODER_JUMP, seen, time)

    def forget_torque(self) -> None:
        """It does not follow a torque now."""
        self._deaf_since = self._pushed_since = self._against_since = -1

    def compare(self, told: int, torque: int, time: float) -> None:
        """An answer tells the torque, of a drive that was told one."""
        if abs(torque - told) <= self._bounds.deaf:
            self._deaf_since = -1
            return
        seen = self._times.seen(time)
        if self._deaf_since < 0:
            self._deaf_since = seen
        elif seen - self._deaf_since >= DEAF_CYCLES:
            self._accuse(Cause.DRIVE_DEAF, self._deaf_since + DEAF_CYCLES, time)

    def push(self, told: int, torque: int, time: float) -> None:
        """A carriage's motor was told, and tells, a force."""
        pushed = min(abs(torque), abs(told)) if torque * told > 0 else 0
        if 2 * pushed < self._bounds.highest:
            self._pushed_since = self._against_since = -1
            return
        seen = self._times.seen(time)
        self._stand(pushed, seen, time)
        self._go_against(-self._moved if torque > 0 else self._moved, seen, time)

    def _stand(self, pushed: int, seen: int, time: float) -> None:
        """Pushed as much as may be, it stays where it is."""
        is_pushed = pushed >= MOST_PUSH * self._bounds.highest
        if not is_pushed or abs(self.position - self._pushed_at) > self._bounds.travel:
            self._pushed_since = -1
        if is_pushed and self._pushed_since < 0:
            self._pushed_since, self._pushed_at = seen, self.position
        elif is_pushed and seen - self._pushed_since > self._times.blocked:
            self._accuse(Cause.BASE_BLOCKED, seen, time)

    def _go_against(self, against: int, seen: int, time: float) -> None:
        """Its move of one SYNC against its force."""
        if against <= 0:
            self._against_since = -1
        elif self._against_since < 0:
            self._against_since, self._against = seen, against
            return
        is_long = seen - self._against_since >= self._times.blocked
        if is_long and against - self._against > 2 * GAIN * self._bounds.move:
            self._accuse(Cause.WRONG_WAY, seen, time)
