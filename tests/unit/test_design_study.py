"""A study on Dask: every result once, whatever happens to the workers."""

import csv
import logging
import os
import signal
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import pytest
from distributed import Client, LocalCluster

import turnbuckle.lab.design.study
from turnbuckle.lab.design import DesignError
from turnbuckle.lab.design.design import Design
from turnbuckle.lab.design.results import Results
from turnbuckle.lab.design.study import Points, judge, plan_study, run_study

ROOT = Path(__file__).parents[2]
DIAGONAL = ROOT / "tests" / "machines" / "fixed_diagonal.toml"
VARY = ["cable[2].base[1]=400 mm..520 mm:20", "tension.min=1 N..3 N:8"]


@pytest.fixture(scope="module")
def cluster() -> Iterator[LocalCluster]:
    """Two workers, each a process."""
    with LocalCluster(
        n_workers=2,
        threads_per_worker=1,
        processes=True,
        dashboard_address="127.0.0.1:0",
        silence_logs=logging.CRITICAL,
    ) as cluster:
        yield cluster


@pytest.fixture(scope="module")
def design() -> Design:
    """A question with machines that cannot be among the answers."""
    return Design.read(DIAGONAL, VARY, "isotropic_force")


def silent(what: str, share: float) -> None:
    """Tell nobody."""


def points_in(path: Path) -> Counter[int]:
    """How often every point is in the table."""
    return Counter(int(row["point"]) for row in csv.DictReader(path.read_text().splitlines()))


class Assassin:
    """Kills a worker, without warning, once a share of the results is there."""

    def __init__(self, pid: int) -> None:
        self.pid = pid
        self.share: float | None = None

    def __call__(self, what: str, share: float) -> None:
        if self.share is None and share >= 0.2:
            os.kill(self.pid, signal.SIGKILL)
            self.share = share


def test_a_killed_worker_loses_no_result(
    tmp_path: Path, design: Design, cluster: LocalCluster
) -> None:
    points, plan = plan_study(design, None, 0)
    with Client(cluster) as client:
        pids = sorted(client.run(os.getpid).values())
    assert len(pids) == 2
    kill = Assassin(pids[0])
    results = Results(tmp_path, design, plan)
    run_study(design, points, results, cluster.scheduler_address, kill)
    results.close()
    assert kill.share is not None and kill.share < 0.8, "not killed mid-way"
    with pytest.raises(ProcessLookupError):
        os.kill(pids[0], 0)
    assert points_in(tmp_path / "results.csv") == Counter(range(160))
    expected = judge(design, [(point, points.values(point)) for point in range(160)])
    assert [results.kept[point] for point in range(160)] == expected
    assert 0 < sum(kept.outcome.score is None for kept in expected) < 160


def test_a_lost_or_repeated_result_would_be_seen(tmp_path: Path) -> None:
    path = tmp_path / "results.csv"
    path.write_text("point\n0\n2\n2\n")
    assert points_in(path) != Counter(range(3))
    assert points_in(path) == Counter({0: 1, 2: 2})


def test_an_interrupted_study_goes_on_where_it_was(
    tmp_path: Path, design: Design, cluster: LocalCluster
) -> None:
    def interrupt(what: str, share: float) -> None:
        if share > 0.3:
            raise KeyboardInterrupt

    points, plan = plan_study(design, None, 0)
    results = Results(tmp_path, design, plan)
    with pytest.raises(KeyboardInterrupt):
        run_study(design, points, results, cluster.scheduler_address, interrupt)
    results.close()
    before = (tmp_path / "results.csv").read_bytes()
    kept = len(results.kept)
    assert 0 < kept < 160
    again = Results(tmp_path, design, plan)
    assert len(again.kept) == kept
    run_study(design, points, again, cluster.scheduler_address, silent)
    again.close()
    assert (tmp_path / "results.csv").read_bytes().startswith(before)
    assert points_in(tmp_path / "results.csv") == Counter(range(160))


def test_a_finished_study_asks_nobody(tmp_path: Path, design: Design) -> None:
    points, plan = plan_study(design, None, 0)
    results = Results(tmp_path, design, plan)
    results.begin()
    results.add(judge(design, [(point, points.values(point)) for point in range(160)]))
    run_study(design, points, results, "tcp://127.0.0.1:1", silent)
    results.close()


def test_a_scheduler_that_is_not_there_is_named_within_seconds(
    tmp_path: Path, design: Design
) -> None:
    points, plan = plan_study(design, None, 0)
    begin = time.monotonic()
    with pytest.raises(DesignError, match=r"--scheduler tcp://127\.0\.0\.1:1: no Dask scheduler"):
        folder = tmp_path / "study"
        run_study(design, points, Results(folder, design, plan), "tcp://127.0.0.1:1", silent)
    assert time.monotonic() - begin < 30
    assert not list(tmp_path.iterdir())


def test_a_scheduler_without_workers_is_told(tmp_path: Path, design: Design) -> None:
    points, plan = plan_study(design, None, 0)
    with (
        LocalCluster(n_workers=0, processes=False, dashboard_address="127.0.0.1:0") as idle,
        pytest.raises(DesignError, match="has no workers"),
    ):
        run_study(design, points, Results(tmp_path, design, plan), idle.scheduler_address, silent)


def test_a_scheduler_that_is_lost_is_told_and_results_are_kept(
    tmp_path: Path, design: Design, capfd: pytest.CaptureFixture[str]
) -> None:
    points, plan = plan_study(design, None, 0)
    results = Results(tmp_path, design, plan)
    with LocalCluster(n_workers=1, processes=False, dashboard_address="127.0.0.1:0") as lost:

        def lose(what: str, share: float) -> None:
            if share > 0.2:
                lost.close()

        with pytest.raises(DesignError, match=r"connection to it was lost; \d+ results are kept"):
            run_study(design, points, results, lost.scheduler_address, lose)
    results.close()
    assert len(results.kept) > 0
    assert points_in(tmp_path / "results.csv") == Counter(results.kept.keys())
    assert "Traceback" not in capfd.readouterr().err


def test_a_cluster_with_another_turnbuckle_is_refused(
    tmp_path: Path, design: Design, cluster: LocalCluster, monkeypatch: pytest.MonkeyPatch
) -> None:
    points, plan = plan_study(design, None, 0)
    results = Results(tmp_path, design, plan)
    monkeypatch.setattr(
        turnbuckle.lab.design.study, "version", lambda name: f"of process {os.getpid()}"
    )
    with pytest.raises(DesignError, match=f"allowed: of process {os.getpid()}, as here"):
        run_study(design, points, results, cluster.scheduler_address, silent)


def test_a_grid_has_every_combination_with_both_ends(design: Design) -> None:
    points = Points.grid(design.ranges)
    values = {points.values(point) for point in range(len(points))}
    assert len(values) == 160
    assert {str(one) for one, _ in values} >= {"400.0", "520.0"}
    assert {str(other) for _, other in values} >= {"1.0", "3.0"}


def test_more_samples_begin_with_the_same_ones() -> None:
    design = Design.read(DIAGONAL, ["tension.min=1 N..3 N", "tension.max=8 N..9 N"], "motor")
    few, many = (plan_study(design, count, 5)[0] for count in (10, 50))
    assert [few.values(k) for k in range(10)] == [many.values(k) for k in range(10)]
    other = plan_study(design, 10, 6)[0]
    assert [few.values(k) for k in range(10)] != [other.values(k) for k in range(10)]


@pytest.mark.parametrize(
    ("vary", "samples", "goal", "words"),
    [
        (["tension.min=1 N..3 N"], None, "isotropic_force", "--vary tension.min: found no COUNT"),
        (["tension.min=1 N..3 N:4"], 5, "isotropic_force", "--samples with a COUNT"),
        (["tension.min=1 N..3 N:999999999"], None, "isotropic_force", "999999999 machines"),
        (["tension.min=1 N..3 N"], 10**7, "isotropic_force", "10000000 machines"),
        (["tension.max=8 N..9 N"], 5, "motor", "nothing to study"),
    ],
)
def test_a_study_that_is_none_is_refused(
    vary: list[str], samples: int | None, goal: str, words: str
) -> None:
    with pytest.raises(DesignError, match=words):
        plan_study(Design.read(DIAGONAL, vary, goal), samples, 0)
