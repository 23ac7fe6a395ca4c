"""A CAN bus simulated frame by frame: arbitration by identifier, no interruption, longest frames.

Written without a look at the analysis that it judges: it knows frames and turns, and no formula.
"""

from collections.abc import Sequence
from heapq import heappop, heappush
from random import Random

from turnbuckle.model.bus.response import Message


def longest_responses(
    messages: Sequence[Message], duration: int, random: Random, phases: Sequence[int] | None = None
) -> list[int]:
    """The longest from a frame's turn until it has arrived, for every message [bit times].

    Turns come every period from a phase on, random without `phases`; a frame is ready by up to its
    jitter later, at random.
    """
    starts = phases or [random.randrange(message.period) for message in messages]
    ready = _ready_frames(messages, duration, starts, random)
    longest = [0] * len(messages)
    waiting: list[tuple[int, int, int]] = []
    now = index = 0
    while index < len(ready) or waiting:
        if not waiting:
            now = max(now, ready[index][0])
        while index < len(ready) and ready[index][0] <= now:
            _, turn, number = ready[index]
            heappush(waiting, (messages[number].identifier, turn, number))
            index += 1
        _, turn, number = heappop(waiting)
        now += 55 + 10 * messages[number].size
        longest[number] = max(longest[number], now - turn)
    return longest


def _ready_frames(
    messages: Sequence[Message], duration: int, starts: Sequence[int], random: Random
) -> list[tuple[int, int, int]]:
    """(when ready, its turn, number of the message) of all frames, in order of time."""
    return sorted(
        (turn + random.randint(0, message.jitter), turn, number)
        for number, (message, start) in enumerate(zip(messages, starts, strict=True))
        for turn in range(start, duration, message.period)
    )
