"""What happens to the chip at a certain time."""

from __future__ import annotations

from collections.abc import Callable
from heapq import heappop, heappush
from itertools import count

Action = Callable[[], None]


class Event:
    """Something that will be done, unless it is cancelled before."""

    __slots__ = ("action", "time")

    def __init__(self, time: int, action: Action) -> None:
        self.time = time
        self.action: Action | None = action

    def cancel(self) -> None:
        """It will not be done."""
        self.action = None


class Schedule:
    """Events in order of their time [ns]; those of one time in the order they were added."""

    def __init__(self) -> None:
        self._heap: list[tuple[int, int, Event]] = []
        self._order = count()

    def add(self, time: int, action: Action) -> Event:
        """Do something at a time."""
        event = Event(time, action)
        heappush(self._heap, (time, next(self._order), event))
        return event

    def next(self) -> int | None:
        """Time of the next event; None when there is none."""
        while self._heap and self._heap[0][2].action is None:
            heappop(self._heap)
        return self._heap[0][0] if self._heap else None

    def take(self, time: int) -> tuple[int, Action] | None:
        """The next action that is due and its own time, taken off; None when none is due."""
        due = self.next()
        if due is None or due > time:
            return None
        event = heappop(self._heap)[2]
        action, event.action = event.action, None
        assert action is not None
        return event.time, action
