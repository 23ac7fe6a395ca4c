"""Timing of several programs in turn, so that a busy moment of the machine hits all of them."""

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from statistics import median


@dataclass(frozen=True)
class Timing:
    """Time of one call, over all repetitions [ns]."""

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
            begin = time.perf_counter_ns()
            run()
            spent[name].append((time.perf_counter_ns() - begin) / calls)
    return {name: Timing(min(values), median(values)) for name, values in spent.items()}
