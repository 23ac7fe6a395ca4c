"""Negative controls: defects that are seeded into the runtime are found by the campaign.

All of them are in one build, where a number says which one acts.
"""

import ctypes
from pathlib import Path
from typing import NamedTuple

import pytest
from catalogue import FAULTS
from forked import in_a_fork
from journey import NAMES, Bench, Journey, moment_of, stock
from pair_verdict import complaints as complaints_of_pair
from pairs import Pair, run
from runtime_copy import write_copy
from trial import Trial
from verdict import complaints, expected

from turnbuckle.lab.lockstep import FOLDERS, load
from turnbuckle.places import RUNTIME

BUILD = Path(__file__).parents[2] / "build" / "defects"
HEADER = "extern int seeded;\n"


class Defect(NamedTuple):
    """A defect, and a pair of fault and moment that shows it."""

    what: str
    file: str
    right: str
    wrong: str
    """With SEEDED where it asks whether it acts."""
    fault: str
    moment: str


DEFECTS = (
    Defect(
        "a hard stop forgets a cable",
        "core/supervisor.c",
        "drive->wanted.torque = 0;",
        "drive->wanted.torque = (SEEDED && (i == 2)) ? drive->sent : 0;",
        "cable_2: error 2310, overcurrent",
        "RUN",
    ),
    Defect(
        "a soft stop forgets a cable",
        "core/stopping.c",
        "cable->released - (done * excess);",
        "cable->released - ((SEEDED && (i == 0)) ? 0 : (done * excess));",
        "3 cycles left out",
        "RUN",
    ),
    Defect(
        "nobody counts unanswered SYNCs",
        "core/faults.c",
        "(report->missed > TB_MISSED_LIMIT)",
        "(report->missed > (SEEDED ? 250 : TB_MISSED_LIMIT))",
        "cable_2: silent",
        "RUN",
    ),
    Defect(
        "late answers pass for fresh ones",
        "canopen/network.c",
        "drain(network, i, !is_due);",
        "drain(network, i, SEEDED || !is_due);",
        "cable_2: status message a SYNC late always",
        "RUN",
    ),
    Defect(
        "the gate lets every step down through",
        "core/torque_gate.c",
        "(command < previous - step)",
        "(command < previous - (SEEDED ? 50 * step : step))",
        "cable_2: silent",
        "RUN",
    ),
    Defect(
        "the heartbeat goes on whatever a drive does",
        "core/supervisor.c",
        "(!is_over || obeyed)",
        "(!is_over || obeyed || SEEDED)",
        "cable_2: falls to pre-operational",
        "RUN",
    ),
    Defect(
        "the last cause takes the place of the first",
        "core/supervisor.c",
        "(first->cause == TB_CAUSE_NONE)",
        "(SEEDED || (first->cause == TB_CAUSE_NONE))",
        "bus cable1: full",
        "RUN",
    ),
    Defect(
        "a stop that was asked for hides a fault",
        "core/supervisor.c",
        "(first->cause == TB_CAUSE_REQUESTED)",
        "(!SEEDED && (first->cause == TB_CAUSE_REQUESTED))",
        "cable_2: error 2310, overcurrent",
        "SOFT_STOP",
    ),
    Defect(
        "a request to arm that stands arms",
        "core/bring_up.c",
        "~supervisor->requests & TB_REQUEST_ARM",
        "(SEEDED ? ~0u : ~supervisor->requests) & TB_REQUEST_ARM",
        "hand force is not fresh",
        "CONFIGURE CONTRACT",
    ),
    Defect(
        "nobody watches the cables",
        "core/watch.c",
        "(watch->open > TB_CLOSURE_CYCLES)",
        "(!SEEDED && (watch->open > TB_CLOSURE_CYCLES))",
        "cable_2: breaks",
        "RUN",
    ),
    Defect(
        "no carriage that goes the wrong way is told",
        "core/carriage.c",
        "(gained < -GAINED)",
        "(gained < -GAINED) && !SEEDED",
        "base_2: encoder reversed",
        "HOME SWEEP",
    ),
    Defect(
        "no carriage that stands is told",
        "core/carriage.c",
        "carriage->cycles > TB_BLOCKED_CYCLES",
        "!SEEDED && (carriage->cycles > TB_BLOCKED_CYCLES)",
        "base_2: motor gives no torque",
        "HOME SWEEP",
    ),
    Defect(
        "the speed limit of rails is ignored",
        "core/faults.c",
        "(speed > TB_RAIL_SPEED_LIMIT)",
        "(!SEEDED && (speed > TB_RAIL_SPEED_LIMIT))",
        "base_2: encoder reversed",
        "HOME BASE_HOMING",
    ),
    Defect(
        "speeds are lost when a homing sets another zero",
        "core/supervisor.c",
        "supervisor->guide.guided[i - TB_CABLES] == 0",
        "!SEEDED && (supervisor->guide.guided[i - TB_CABLES] == 0)",
        "base_2: motor gives its torque reversed",
        "HOME BASE_HOMING",
    ),
    Defect(
        "a soft stop keeps the bases' forces",
        "core/stopping.c",
        "real_t const done = share_done(supervisor);",
        "real_t const done = share_done(supervisor);"
        " for (size_t k = TB_CABLES; SEEDED && (k < TB_DRIVES); k++) {"
        " supervisor->drives[k].wanted.torque = supervisor->drives[k].sent; }",
        "3 cycles left out",
        "HOME SWEEP",
    ),
    Defect(
        "what drives are is not compared",
        "canopen/setup.c",
        "(*detail == wanted)",
        "(SEEDED || (*detail == wanted))",
        "cable_2: another vendor",
        "INIT",
    ),
)


@pytest.fixture(scope="session")
def defective() -> ctypes.CDLL:
    """The runtime with all defects; `seeded` says which one acts, 0 is none."""
    folders = [BUILD / folder.name for folder in FOLDERS]
    paths = {
        path.relative_to(RUNTIME).as_posix(): path
        for folder in FOLDERS
        for path in folder.glob("*.[ch]")
    }
    files = {name: with_defects(name, path.read_text()) for name, path in paths.items()}
    write_copy(BUILD, {**files, "core/seeded.c": f"{HEADER}int seeded;\n"})
    return load(stock(), folders)


def with_defects(name: str, source: str) -> str:
    """A file with its defects, each of which acts when it is seeded."""
    for number, defect in enumerate(DEFECTS, 1):
        if defect.file == name:
            assert source.count(defect.right) == 1, defect.what
            source = source.replace(
                defect.right, defect.wrong.replace("SEEDED", f"(seeded == {number})")
            )
    return HEADER + source


def found(bench: Bench, library: ctypes.CDLL, number: int, defect: Defect) -> list[str]:
    """What the campaign says of the pair that shows a defect."""
    moment = moment_of(defect.moment)
    fault = next(each for each in FAULTS if each.name == defect.fault)
    wanted = expected(fault, moment)
    bench.lockstep.exchange_runtime(library)
    ctypes.c_int.in_dll(library, "seeded").value = number
    return complaints(wanted, Trial(bench, (0, fault)).run(wanted.horizon, wanted.until_ready))


IN_ORDER: list[tuple[int, Defect]] = sorted(
    enumerate(DEFECTS, 1), key=lambda each: NAMES.index(each[1].moment)
)
"""As the machine comes to them."""


@pytest.mark.parametrize(
    ("number", "defect"),
    IN_ORDER,
    ids=lambda value: value.what if isinstance(value, Defect) else "",
)
def test_a_defect_is_found(
    journey: Journey, defective: ctypes.CDLL, number: int, defect: Defect
) -> None:
    bench = journey.at(moment_of(defect.moment))
    assert in_a_fork(lambda: found(bench, defective, number, defect)) != []
    assert in_a_fork(lambda: found(bench, defective, 0, defect)) == []


IN_PAIRS = [
    each
    for each in IN_ORDER
    if each[1].what
    in (
        "a hard stop forgets a cable",
        "the heartbeat goes on whatever a drive does",
        "the last cause takes the place of the first",
        "a request to arm that stands arms",
        "a soft stop keeps the bases' forces",
    )
]
"""Those that the judges of pairs must find as well."""


def found_in_a_pair(bench: Bench, library: ctypes.CDLL, number: int, defect: Defect) -> list[str]:
    """What they say of the same fault with a second one, which changes nothing."""
    first, second = (
        next(each for each in FAULTS if each.name == name)
        for name in (defect.fault, "bus base: a frame of nobody")
    )
    until_ready = 300 if defect.moment == "CONFIGURE CONTRACT" else 0
    both = Pair(1, moment_of(defect.moment), 0, first, second, until_ready)
    bench.lockstep.exchange_runtime(library)
    ctypes.c_int.in_dll(library, "seeded").value = number
    return complaints_of_pair(both, run(bench, both))


@pytest.mark.parametrize(
    ("number", "defect"),
    IN_PAIRS,
    ids=lambda value: value.what if isinstance(value, Defect) else "",
)
def test_a_defect_is_found_in_a_pair(
    journey: Journey, defective: ctypes.CDLL, number: int, defect: Defect
) -> None:
    bench = journey.at(moment_of(defect.moment))
    assert in_a_fork(lambda: found_in_a_pair(bench, defective, number, defect)) != []
    assert in_a_fork(lambda: found_in_a_pair(bench, defective, 0, defect)) == []
