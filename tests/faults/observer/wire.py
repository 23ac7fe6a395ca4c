"""One bus: what is common to the drives on it."""

from observer.limits import ROUNDING, Times


class Wire:
    """The cycle of the last SYNC, and when the answers to it are due [s]."""

    def __init__(self, name: str, divider: int, times: Times) -> None:
        self.name, self.divider = name, divider
        self.cycle = -1
        self.due = 0.0
        self.beat = 0
        """Cycle of the master's last heartbeat."""
        self._times = times

    def synchronise(self, cycle: int) -> None:
        """A SYNC came in a cycle."""
        self.cycle = cycle
        last = cycle + self.divider - 1
        self.due = last * self._times.period + self._times.phase + ROUNDING

    @property
    def lost_in(self) -> int:
        """The cycle in which more SYNCs are missing than may be."""
        return self.cycle + (self._times.missed + 1) * self.divider

    def is_served(self, cycle: int) -> bool:
        """Whether the master's SYNC comes about a cycle."""
        return cycle < self.lost_in
