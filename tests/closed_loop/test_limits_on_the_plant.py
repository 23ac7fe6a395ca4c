"""What the plant reaches before the stop stays within what docs/safety.md promises."""

import os
import re
from collections.abc import Callable, Iterator
from math import dist
from typing import NamedTuple

import pytest
import variants
from seeded import runtime_with

from turnbuckle.lab.demo import plan_task, plant_of
from turnbuckle.lab.drives.power import MOVING
from turnbuckle.lab.drives.wire import Conditions
from turnbuckle.lab.lockstep import Lockstep, Request, State
from turnbuckle.lab.machine_sim import SimulatedMachine

DOCUMENT = variants.ROOT / "docs" / "safety.md"
CABLES = BASES = range(4)
SWEEP, LONGEST = 20, 2500
"""TB_PHASE_SWEEP; cycles until every drive is off, at most."""
NO_WATCH = (
    "core/faults.c",
    "return tb_carriage_look(&supervisor->carriages[rail], &motion);",
    "(void)motion;\n    return TB_CAUSE_NONE;",
)
Strike = Callable[[Lockstep], None]


class Reached(NamedTuple):
    """Largest speed [m/s] and travel [m] of a carriage, tension [N], distance [m] of the handle
    from where the hand wants it."""

    speed: float
    travel: float
    tension: float
    astray: float


def promised() -> dict[str, Reached]:
    """The table of the document."""
    text = DOCUMENT.read_text().partition("## What can be reached")[2]
    pattern = r"^\| ([^|]+) \| ([\d.]+) m/s \| (\d+) mm \| ([\d.]+) N \| (\d+) mm \|$"
    return {
        name: Reached(float(v), float(s) * 1e-3, float(t), float(a) * 1e-3)
        for name, v, s, t, a in re.findall(pattern, text, re.M)
    }


def distort(drive: int, scale: float) -> Strike:
    """An encoder counts otherwise."""
    return lambda lockstep: lockstep.machine.drives[drive].servo.encoder.distort(scale)


def give(drive: int, share: float) -> Strike:
    """A motor gives another torque than it tells."""
    return lambda lockstep: setattr(lockstep.machine.drives[drive].servo, "given", share)


def cut(cable: int) -> Strike:
    """A cable breaks."""
    return lambda lockstep: lockstep.machine.plant.break_cable(cable)


def faults() -> Iterator[tuple[str, str, Strike]]:
    """As the table calls them, the drive, and how it is done."""
    for base in BASES:
        drive, name = len(CABLES) + base, f"base_{base + 1}"
        yield "encoder of a base counts backwards", name, distort(drive, -1.0)
        yield "encoder of a base stands still", name, distort(drive, 0.0)
        yield "motor of a base pulls the wrong way", name, give(drive, -1.0)
        yield "motor of a base gives nothing", name, give(drive, 0.0)
    for cable in CABLES:
        name = f"cable_{cable + 1}"
        yield "encoder of a cable counts backwards", name, distort(cable, -1.0)
        yield "encoder of a cable stands still", name, distort(cable, 0.0)
        yield "motor of a cable pulls the wrong way", name, give(cable, -1.0)
        yield "a cable breaks", name, cut(cable)


FAULTS = tuple(faults())


@pytest.fixture(scope="module")
def machines() -> dict[str, Lockstep]:
    """The stock machine while its bases sweep, and at work with a hand that moves."""
    return {"SWEEP": sweeping(power_on()), "RUN": working(power_on())}


def power_on() -> Lockstep:
    """Wires at their worst."""
    generated = variants.committed()
    plant, task = plant_of(generated.machine), plan_task(generated)
    rails = [0.15, 0.11, 0.13, 0.09]
    conditions = Conditions(worst=True)
    simulated = SimulatedMachine(generated.machine, plant, task, rails, conditions)
    return Lockstep(generated, simulated)


def sweeping(lockstep: Lockstep) -> Lockstep:
    """In the middle of the sweep."""
    while lockstep.view["phase"] != SWEEP:
        ready = lockstep.state is State.CONFIGURE and lockstep.cycles % 2
        lockstep.requests = Request.ARM if ready else Request(0)
        lockstep.cycle()
        assert lockstep.cycles < 20_000 and lockstep.state is not State.FAULT
    lockstep.run(700)
    return lockstep


def working(lockstep: Lockstep) -> Lockstep:
    """The hand moves over the target."""
    assert lockstep.bring_up(20_000) is State.RUN
    lockstep.machine.begin_task(repeat=True)
    lockstep.run(900)
    return lockstep


def reach(lockstep: Lockstep, strike: Strike) -> Reached:
    """From the fault until every drive is off."""
    simulated, world = lockstep.machine, lockstep.machine.plant
    start = before = list(world.rails)
    speed = travel = tension = astray = 0.0
    strike(lockstep)
    for _ in range(LONGEST):
        lockstep.cycle()
        rails = list(world.rails)
        speed = max(speed, furthest(rails, before) / simulated.period)
        travel = max(travel, furthest(rails, start))
        tension = max(tension, world.highest_tension)
        astray = max(astray, dist(world.position, simulated.hand_goal))
        before = rails
        if all(drive.servo.power not in MOVING for drive in simulated.drives):
            return Reached(speed, travel, tension, astray)
    raise AssertionError(f"still {lockstep.state.name}")


def furthest(one: list[float], other: list[float]) -> float:
    """Largest difference."""
    return max(abs(a - b) for a, b in zip(one, other, strict=True))


def forked(act: Callable[[], Reached]) -> Reached:
    """What it answers in a fork, which leaves the machine as it was."""
    read, write = os.pipe()
    if os.fork() == 0:
        try:
            words = " ".join(map(repr, act()))
        except BaseException as error:
            words = f"! {error!r}"
        os.write(write, words.encode())
        os._exit(0)
    os.close(write)
    with os.fdopen(read) as pipe:
        words = pipe.read()
    os.wait()
    assert not words.startswith("!"), words
    return Reached(*map(float, words.split()))


@pytest.mark.parametrize("moment", ["SWEEP", "RUN"])
@pytest.mark.parametrize("name", dict.fromkeys(name for name, _, _ in FAULTS))
def test_a_fault_reaches_no_more_than_is_promised(
    machines: dict[str, Lockstep], name: str, moment: str
) -> None:
    limits = promised()[name]
    for _, drive, strike in (fault for fault in FAULTS if fault[0] == name):
        found = forked(lambda strike=strike: reach(machines[moment], strike))  # type: ignore[misc]
        assert all(a <= b for a, b in zip(found, limits, strict=True)), f"{drive}: {found}"


def test_the_document_promises_something_of_every_fault_tried() -> None:
    assert set(promised()) == {name for name, _, _ in FAULTS}


def test_without_the_watch_on_carriages_more_is_reached(machines: dict[str, Lockstep]) -> None:
    # Negative control: a base whose encoder counts backwards, were there only the old limits.
    limits = promised()["encoder of a base counts backwards"]

    def act() -> Reached:
        lockstep = machines["RUN"]
        lockstep.exchange_runtime(runtime_with("inattentive", NO_WATCH))
        return reach(lockstep, distort(5, -1.0))

    found = forked(act)
    assert found.speed > 2 * limits.speed and found.travel > limits.travel
