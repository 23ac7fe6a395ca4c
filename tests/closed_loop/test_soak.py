"""Ten seconds of `make soak`, and what it would find."""

import ctypes
import os
from collections.abc import Callable
from pathlib import Path

import pytest
import variants
from seeded import runtime_with

from turnbuckle.lab.demo import plan_task, plant_of
from turnbuckle.lab.drives.bus import Disturbance, Mishap
from turnbuckle.lab.soak.__main__ import judge, summary
from turnbuckle.lab.soak.pair import SoakError, soak_twice
from turnbuckle.lab.soak.run import Finding, SoakRun

ROOT = Path(__file__).parents[2]
CYCLES = 10_000
LOST, TWICE, LATE = 1, 2, 3
DEFECTS = (
    (
        "static const tb_bus fresh_bus;",
        "static const tb_bus fresh_bus;\nint seeded;\nstatic tb_orders before;",
    ),
    ("&orders->drives[i], &frame)) {", "(seeded == 3 ? &before : orders)->drives + i, &frame)) {"),
    (
        "if (is_synced(network, index)) {\n        send_setpoints(network, index, orders);",
        "int const now = network->cycle % 64 == 0 ? seeded : 0;\n"
        "    for (int k = now == 1; is_synced(network, index) && k < 1 + (now == 2); k++) {\n"
        "        send_setpoints(network, index, orders);",
    ),
    ("    network->cycle++;\n", "    before = *orders;\n    network->cycle++;\n"),
)
"""Of network.c: setpoints that it loses, doubles, or keeps for a cycle, as `seeded` says."""


@pytest.fixture(scope="module")
def working() -> SoakRun:
    """The stock machine at work."""
    generated = variants.committed()
    run = SoakRun(generated, plant_of(generated.machine), plan_task(generated))
    run.bring_up()
    run.work(500)  # the hand moves
    return run


@pytest.fixture(scope="module")
def defective() -> ctypes.CDLL:
    """The runtime with all defects; `seeded` says which one acts, 0 is none."""
    return runtime_with("soak", *(("canopen/network.c", *defect) for defect in DEFECTS))


def findings_in_a_copy(act: Callable[[], Finding]) -> str:
    """What a run finds, in words; run in a fork, so that the machine is as before."""
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        os.write(writer, "\n".join(act().wrong)[:60_000].encode())
        os._exit(0)
    os.close(writer)
    with os.fdopen(reader) as stream:
        words = stream.read()
    assert os.waitpid(child, 0)[1] == 0
    return words


def test_ten_seconds_are_without_fault_and_twice_the_same_to_the_bit(stock_file: Path) -> None:
    told: list[int] = []
    folder = ROOT / "generated" / stock_file.stem
    findings = soak_twice(stock_file, folder, CYCLES, told.append)
    assert judge(findings) == "", findings
    for finding in findings:
        assert finding.cycles == CYCLES and finding.setpoints > 6 * CYCLES
    assert told == sorted(told) and told[-1] > CYCLES
    assert summary(findings).row_count == 7


@pytest.mark.parametrize(
    ("mishap", "words"),
    [
        (Disturbance(Mishap.DROP), "0 setpoints before a SYNC"),
        (Disturbance(Mishap.DUPLICATE), "2 setpoints before a SYNC"),
        (Disturbance(Mishap.DELAY, cycles=2), "no setpoint arrived"),
        (Disturbance(Mishap.CORRUPT, flips=b"\0\0\2"), "was ordered"),
    ],
    ids=lambda value: value.mishap.name if isinstance(value, Disturbance) else "",
)
def test_a_setpoint_that_goes_wrong_on_the_bus_is_found(
    working: SoakRun, mishap: Disturbance, words: str
) -> None:
    def act() -> Finding:
        working.lockstep.machine.buses[0].disturb(0x201, mishap)
        working.work(10)
        return working.conclude()

    assert words in findings_in_a_copy(act)


@pytest.mark.parametrize(
    ("defect", "words"),
    [
        (0, ""),
        (LOST, "0 setpoints before a SYNC"),
        (TWICE, "2 setpoints before a SYNC"),
        (LATE, "was ordered"),
    ],
    ids=["none", "lost", "twice", "late"],
)
def test_a_defect_of_the_runtime_is_found(
    working: SoakRun, defective: ctypes.CDLL, defect: int, words: str
) -> None:
    def act() -> Finding:
        working.lockstep.exchange_runtime(defective)
        ctypes.c_int.in_dll(defective, "seeded").value = defect
        working.work(200)
        return working.conclude()

    found = findings_in_a_copy(act)
    assert words in found and bool(words) == bool(found)


def test_a_run_that_dies_is_told(tmp_path: Path) -> None:
    nowhere = tmp_path / "nowhere.toml"
    with pytest.raises(SoakError, match="exit code 1"):
        soak_twice(nowhere, tmp_path, 1, lambda done: None)


def test_runs_that_differ_or_have_stopped_are_told() -> None:
    assert judge([Finding(fingerprint="a"), Finding(fingerprint="a")]) == ""
    assert judge([Finding(fingerprint="a"), Finding(fingerprint="b")]) == "The two runs differ."
    assert judge([Finding(count=1), Finding()]) != ""


def test_a_machine_that_has_stopped_and_answers_without_room_are_found(working: SoakRun) -> None:
    def act() -> Finding:
        working.lockstep.machine.drives[0].shut_down()
        working.lockstep.lost = 1
        working.work(30)
        return working.conclude()

    found = findings_in_a_copy(act)
    assert "HARD_STOP at the end" in found and "1 answers of drives" in found
