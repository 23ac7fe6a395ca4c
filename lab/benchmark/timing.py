"""Timing of several programs in turn, so that a busy moment of the machine hits all of them.

Processor time, not wall time: else a slow program, which seldom gets through a run without being
interrupted, would look slower still on a busy machine, and the ratios would flatter the fast one.
"""

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from statistics import median


@dataclass(frozen=True)
class Timing:
    """Processor time of one call, over all repetitions [ns]."""

    least: float
    median: float


def time_in_turn(
    runs: Mapping[str, Callable[[], object]], calls: int, repetitions: int
) -> dict[str, Timing]:
    """Time each run, which makes `calls` calls, `repetitions` times, one after the other."""
    spent: dict[str, list[float]] = {name: [] for name in runs}
    for run in runs.values():
        run()
    for _ in range(repetitions):
        for name, run in runs.items():
            begin = time.thread_time_ns()
            run()
            spent[name].append((time.thread_time_ns() - begin) / calls)
    return {name: Timing(min(values), median(values)) for name, values in spent.items()}
