"""Many machines judged on many cores by Dask; results are kept as they arrive.

Work that a lost worker had is done again by another: Dask sees to that, and results count once.
"""

from __future__ import annotations

import logging
import math
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from importlib.metadata import PackageNotFoundError, version
from typing import Any

import numpy as np
from distributed import Client, Future, KilledWorker, LocalCluster, as_completed
from distributed.client import FutureCancelledError
from distributed.comm import CommClosedError
from distributed.utils import silence_logging_cmgr
from scipy.stats import qmc

from turnbuckle.lab.design import DesignError
from turnbuckle.lab.design.design import Design, Values
from turnbuckle.lab.design.results import Kept, Results
from turnbuckle.lab.design.search import Shares, Tell
from turnbuckle.lab.design.vary import Range
from turnbuckle.model.problem import Problem

MOST_POINTS = 1_000_000
"""A study of more machines is a slip of the pen."""
PATIENCE = 5.0
"""Time [s] in which a scheduler and its first worker must answer."""
LARGEST_BATCH = 32
BATCHES_PER_CORE = 8
"""A batch is so small that every core gets so many, if it can: progress shows, little is lost."""
IN_FLIGHT = 512
"""Batches known to the scheduler at a time."""
IGNORE_INTERRUPTS = "import signal; signal.signal(signal.SIGINT, signal.SIG_IGN)"
"""The terminal sends its interrupt to the workers too; it is the study that stops them."""


class Points:
    """The machines of a study by number: all values of a grid, or samples spread over the ranges.

    A study with more samples begins with the same ones.
    """

    def __init__(self, ranges: Sequence[Range], shares: Shares) -> None:
        self._ranges = ranges
        self._shares = shares

    @classmethod
    def grid(cls, ranges: Sequence[Range]) -> Points:
        """Every combination of the values of all ranges, each divided by its count."""
        axes = [np.linspace(0.0, 1.0, one.count or 1) for one in ranges]
        mesh = np.meshgrid(*axes, indexing="ij")
        return cls(ranges, np.stack([axis.ravel() for axis in mesh], axis=-1))

    @classmethod
    def samples(cls, ranges: Sequence[Range], count: int, seed: int) -> Points:
        """Points of a scrambled Halton sequence."""
        return cls(ranges, qmc.Halton(len(ranges), rng=seed).random(count))

    def __len__(self) -> int:
        return len(self._shares)

    def values(self, point: int) -> Values:
        """The values of a point."""
        pairs = zip(self._ranges, self._shares[point].tolist(), strict=True)
        return tuple(one.rounded(one.value(share)) for one, share in pairs)


def plan_study(design: Design, samples: int | None, seed: int) -> tuple[Points, dict[str, Any]]:
    """The points of a study, and what they depend on beside the design.

    Samples where a number is given, else a grid; DesignError where it is not clear which.
    """
    path, ranges = design.document.path, design.ranges
    counts = [one.count for one in ranges]
    if not ranges:
        raise DesignError(f"{path}: --vary leaves nothing to study: tension.max follows")
    if samples is not None and any(counts):
        raise DesignError(f"{path}: --samples with a COUNT; allowed: one or the other")
    if samples is None and not all(counts):
        missing = ranges[counts.index(None)].key
        problem = Problem(f"--vary {missing}", "no COUNT", "KEY=LOW..HIGH:COUNT, or --samples N")
        raise DesignError(f"{path}: {problem}")
    total = samples or math.prod(count for count in counts if count)
    if total > MOST_POINTS:
        raise DesignError(f"{path}: --vary asks for {total} machines; allowed: {MOST_POINTS}")
    if samples is None:
        return Points.grid(ranges), {"grid": counts}
    return Points.samples(ranges, samples, seed), {"seed": seed}


def run_study(
    design: Design, points: Points, results: Results, scheduler: str | None, tell: Tell
) -> None:
    """Judge the points of which there is no result yet.

    DesignError where the scheduler is not there, or workers died over a result again and again.
    """
    todo = [point for point in range(len(points)) if point not in results.kept]
    if not todo:
        return
    tell("starting workers", 0.0)
    try:
        with quiet(), workers(scheduler) as client:
            results.begin()
            batches = _batches(todo, sum(client.ncores().values()))
            for kept in _judged(client, design, points, batches):
                results.add(kept)
                tell("judging machines", min(len(results.kept) / len(points), 1.0))
    except (FutureCancelledError, CommClosedError):
        raise DesignError(
            f"--scheduler {scheduler}: the connection to it was lost; {results.go_on()}"
        ) from None
    missing = len(points) - sum(point < len(points) for point in results.kept)
    if missing:
        raise DesignError(
            f"{results.folder}: {missing} results are missing, because workers died over them;"
            f" {results.go_on()}"
        )


@contextmanager
def quiet() -> Iterator[None]:
    """Without what Dask logs about workers that come and go: what matters is said in words."""
    with (
        silence_logging_cmgr(logging.CRITICAL),
        silence_logging_cmgr(logging.CRITICAL, "distributed.client"),
    ):
        yield


@contextmanager
def workers(scheduler: str | None) -> Iterator[Client]:
    """Workers on the cores of this computer, or those of the scheduler at an address."""
    if scheduler is None:
        with (
            LocalCluster(
                threads_per_worker=1,
                dashboard_address="127.0.0.1:0",
                silence_logs=logging.CRITICAL,
                preload=[IGNORE_INTERRUPTS],
            ) as cluster,
            Client(cluster) as client,
        ):
            yield client
    else:
        with _connected(scheduler) as client:
            _refuse_other_versions(client, scheduler)
            yield client


def _connected(scheduler: str) -> Client:
    try:
        client = Client(scheduler, timeout=PATIENCE)
    except (OSError, ValueError, TypeError) as error:
        raise DesignError(
            f"--scheduler {scheduler}: no Dask scheduler answers there; allowed: the address of"
            " one that runs, such as tcp://192.168.0.7:8786"
        ) from error
    try:
        client.wait_for_workers(1, timeout=PATIENCE)
    except TimeoutError:
        client.close()
        raise DesignError(f"--scheduler {scheduler}: it has no workers") from None
    return client


def _refuse_other_versions(client: Client, scheduler: str) -> None:
    """All of a cluster reads what it works on, so all of it must have this Turnbuckle."""
    here = version("turnbuckle")
    try:
        found = {client.run_on_scheduler(version, "turnbuckle")}
        found |= set(client.run(version, "turnbuckle").values())
    except PackageNotFoundError:
        found = {"not there"}
    if found != {here}:
        raise DesignError(
            f"--scheduler {scheduler}: found Turnbuckle {', '.join(sorted(found))}; allowed:"
            f" {here}, as here, on the scheduler and on every worker"
        )


def _batches(todo: Sequence[int], cores: int) -> Iterator[list[int]]:
    size = min(LARGEST_BATCH, math.ceil(len(todo) / (cores * BATCHES_PER_CORE)))
    for begin in range(0, len(todo), size):
        yield list(todo[begin : begin + size])


def _judged(
    client: Client, design: Design, points: Points, batches: Iterator[list[int]]
) -> Iterator[list[Kept]]:
    """Results of batches in the order in which they arrive."""

    def submit() -> Iterator[Future]:
        for batch in batches:
            numbered = [(point, points.values(point)) for point in batch]
            yield client.submit(judge, design, numbered, pure=False)

    submitted = submit()
    arriving = as_completed(
        [future for _, future in zip(range(IN_FLIGHT), submitted, strict=False)]
    )
    for future in arriving:
        following = next(submitted, None)
        if following is not None:
            arriving.add(following)
        with suppress(KilledWorker):  # it will be seen to be missing
            yield future.result()


def judge(design: Design, numbered: Sequence[tuple[int, Values]]) -> list[Kept]:
    """The results of a few points: what a worker does."""
    return [Kept(point, design.outcome(values)) for point, values in numbered]
