"""The benchmark of the control cycle times the cycles that were recorded, and no others."""

from dataclasses import replace
from pathlib import Path

import pytest

from turnbuckle.codegen.bind import Generated
from turnbuckle.lab.benchmark.cycle.cost import CycleRow, Replay, time_work
from turnbuckle.lab.benchmark.cycle.recording import Cycles, Recorder
from turnbuckle.lab.benchmark.targets import cycle_target
from turnbuckle.lab.benchmark.timing import Timing
from turnbuckle.model.reading import load_machine

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def generated() -> Generated:
    machine = load_machine(ROOT / "machines" / "yoon2023.toml")
    return Generated(machine, ROOT / "generated" / "yoon2023", "double")


@pytest.fixture(scope="module")
def recorded(generated: Generated) -> tuple[Cycles, Cycles]:
    """From power-on to work, and some work."""
    recorder = Recorder(generated)
    return recorder.bring_up(), recorder.work(200)


def test_a_cycle_is_timed_with_all_its_frames(
    generated: Generated, recorded: tuple[Cycles, Cycles]
) -> None:
    row = time_work(Replay(generated), *recorded, repetitions=2)
    assert 0 < row.timing.least <= row.timing.median
    assert row.frames > 2.5 + 6 + 6  # SYNC, answers, setpoints; one bus is half as fast


def test_cycles_that_end_otherwise_are_not_timed(
    generated: Generated, recorded: tuple[Cycles, Cycles]
) -> None:
    before, work = recorded
    frames = bytearray(work.frames)
    for frame in range(1, 21):  # what drives told in the last cycles
        frames[-6 - 12 * (frame - 1)] ^= 0x01
    with pytest.raises(RuntimeError, match="not the one that was recorded"):
        time_work(Replay(generated), before, replace(work, frames=bytes(frames)), repetitions=1)


def test_a_slow_cycle_misses_its_target() -> None:
    rows = [CycleRow("double", Timing(1.0, each), 15.0) for each in (100.0, 20_001.0)]
    assert not cycle_target(rows).is_met
    assert cycle_target(rows[:1]).is_met
