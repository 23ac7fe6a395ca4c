"""The trial of directions: a cable or carriage whose encoder counts the wrong way is named."""

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
import pytest
import supervised
from safety_table import constants
from supervised import CABLES, RAILS, Cause, Machine, Moments, Observation, Phase, State

NUMBERS = constants(supervised.STOCK)
PERIOD, DRUM = supervised.PERIOD, supervised.DRUM
LOOSE, HEAVY = 0.25, 4.0
"""Mass [kg] of a handle that nobody holds, and of one with an arm behind it."""


@dataclass
class Reaction:
    """How a cable answers a pull beyond T_min, and what its encoder makes of that."""

    machine: Machine
    mass: float
    counts: dict[int, float] = field(default_factory=dict)
    """By cable: what its encoder makes of a motion; 1 for those that are not named."""
    shaken: float = 0.0
    """Acceleration [m/s^2] with which a hand leads the handle to and fro."""
    speed: np.ndarray = field(default_factory=lambda: np.zeros(CABLES))
    moved: np.ndarray = field(default_factory=lambda: np.zeros(CABLES))
    cycle: int = 0

    def __call__(self, seen: Observation) -> None:
        tension = NUMBERS["TB_TENSION_MIN"]
        self.cycle += 1
        for cable in range(CABLES):
            pull = self.machine.orders.drives[cable].torque / DRUM - tension
            sway = self.shaken * np.sin(0.009 * self.cycle + cable)
            self.speed[cable] += (pull / self.mass - 8.0 * self.speed[cable] + sway) * PERIOD
            self.moved[cable] += self.speed[cable] * PERIOD
            seen.drives[cable].position += self.counts.get(cable, 1.0) * self.moved[cable]


@pytest.fixture
def moments() -> tuple[Machine, Moments]:
    """The stock machine."""
    return supervised.moments("torque")


def tried(machine: Machine, spoil: Callable[[Observation], None]) -> tuple[str, str, int]:
    """Phase, cause and culprit when the trial is over."""
    machine.seen.requests = 0

    def over(orders: supervised.Orders) -> bool:
        return bool(orders.state != State.HOME or orders.phase >= Phase.BASE_MODE)

    orders = machine.run(5000, over, spoil)
    return Phase(orders.phase).name, Cause(orders.cause).name, orders.culprit


@pytest.mark.parametrize("mass", [LOOSE, HEAVY])
@pytest.mark.parametrize("wrong", range(CABLES))
def test_a_cable_whose_encoder_counts_backwards_is_named(
    moments: tuple[Machine, Moments], wrong: int, mass: float
) -> None:
    machine, saved = moments
    machine.restore(saved["HOME TRY_CABLES"])
    counts = {wrong: -1.0}
    assert tried(machine, Reaction(machine, mass, counts))[1:] == ("WRONG_WAY", wrong)


@pytest.mark.parametrize("mass", [LOOSE, HEAVY, 1e9])
def test_cables_that_count_the_right_way_or_are_held_fast_pass(
    moments: tuple[Machine, Moments], mass: float
) -> None:
    machine, saved = moments
    machine.restore(saved["HOME TRY_CABLES"])
    assert tried(machine, Reaction(machine, mass))[:2] == ("BASE_MODE", "NONE")


def test_a_hand_that_moves_the_handle_meanwhile_misleads_nobody(
    moments: tuple[Machine, Moments],
) -> None:
    machine, saved = moments
    for wrong in (None, 2):
        machine.restore(saved["HOME TRY_CABLES"])
        counts = {} if wrong is None else {wrong: -1.0}
        cause = tried(machine, Reaction(machine, 0.8, counts, shaken=1.0))[1:]
        assert cause == (("WRONG_WAY", wrong) if wrong is not None else ("NONE", 0))


def test_no_cable_is_pulled_much_harder_than_the_others(moments: tuple[Machine, Moments]) -> None:
    machine, saved = moments
    machine.restore(saved["HOME TRY_CABLES"])
    low, high = NUMBERS["TB_TENSION_MIN"], NUMBERS["TB_TENSION_MAX"]
    most = DRUM * (low + 0.31 * (high - low))
    while machine.orders.phase == Phase.TRY_CABLES:
        torques = sorted(machine.step().drives[cable].torque for cable in range(CABLES))
        assert torques[-1] <= most and torques[-2] <= 1.001 * DRUM * low + (torques[-1] == 0.0)


def mirrored(machine: Machine, rail: int) -> Callable[[Observation], None]:
    """A base whose encoder counts backwards."""
    here = machine.position(CABLES + rail)

    def spoil(seen: Observation) -> None:
        seen.drives[CABLES + rail].position = 2 * here - machine.position(CABLES + rail)

    return spoil


def drifting(machine: Machine, rail: int, force: float) -> Callable[[Observation], None]:
    """A carriage of 1 kg that a cable pulls along its rail, with a force [N]."""

    def spoil(_: Observation) -> None:
        machine.rates[rail] += force * PERIOD

    return spoil


def both(*spoils: Callable[[Observation], None]) -> Callable[[Observation], None]:
    """One after the other."""

    def spoil(seen: Observation) -> None:
        for each in spoils:
            each(seen)

    return spoil


@pytest.mark.parametrize("rail", range(RAILS))
@pytest.mark.parametrize("force", [0.0, 2.5, -2.5])
def test_a_base_whose_encoder_counts_backwards_is_named_whatever_pulls_at_it(
    moments: tuple[Machine, Moments], rail: int, force: float
) -> None:
    machine, saved = moments
    machine.restore(saved["HOME TRY_BASES"])
    start = machine.rails[rail]
    spoil = both(drifting(machine, rail, force), mirrored(machine, rail))
    assert tried(machine, spoil)[1:] == ("WRONG_WAY", CABLES + rail)
    assert abs(machine.rails[rail] - start) < 0.02
    assert abs(machine.rates[rail]) < 0.2 * NUMBERS["TB_RAIL_SPEED_LIMIT"]


@pytest.mark.parametrize("force", [2.5, -2.5])
def test_a_base_that_a_cable_pulls_away_passes(
    moments: tuple[Machine, Moments], force: float
) -> None:
    machine, saved = moments
    machine.restore(saved["HOME TRY_BASES"])
    assert tried(machine, drifting(machine, 1, force))[:2] == ("BASE_MODE", "NONE")


def test_a_base_that_no_push_moves_is_blocked(moments: tuple[Machine, Moments]) -> None:
    machine, saved = moments
    machine.restore(saved["HOME TRY_BASES"])
    held = machine.rails[3]
    strongest: list[float] = []

    def hold(_: Observation) -> None:
        machine.rails[3], machine.rates[3] = held, 0.0
        strongest.append(abs(machine.orders.drives[CABLES + 3].torque))

    assert tried(machine, hold)[1:] == ("BASE_BLOCKED", CABLES + 3)
    assert max(strongest) <= 0.51 * NUMBERS["TB_RAIL_TORQUE_LIMIT"]


@pytest.mark.parametrize("share", [0.03, 0.1, 0.2, 0.4])
def test_a_base_that_sticks_is_pushed_twice_as_hard_until_it_moves(
    moments: tuple[Machine, Moments], share: float
) -> None:
    machine, saved = moments
    machine.restore(saved["HOME TRY_BASES"])
    stiction = share * NUMBERS["TB_RAIL_TORQUE_LIMIT"]
    here, pushes = machine.rails[2], {0.0}

    def stick(_: Observation) -> None:
        nonlocal here
        push = abs(machine.orders.drives[CABLES + 2].torque)
        pushes.add(push)
        if push <= stiction:
            machine.rails[2], machine.rates[2] = here, 0.0
        here = machine.rails[2]

    assert tried(machine, stick)[:2] == ("BASE_MODE", "NONE")
    wanted = [NUMBERS["TB_RAIL_TORQUE_LIMIT"] / 16 * 2**k for k in range(4)]
    enough = next(push for push in wanted if push > stiction)
    assert np.isclose(max(pushes), enough, rtol=1e-9)


def test_a_base_at_either_end_of_its_rail_is_pushed_away_from_there(
    moments: tuple[Machine, Moments],
) -> None:
    machine, saved = moments
    for sign in (1.0, -1.0):
        machine.restore(saved["HOME TRY_BASES"])
        end = machine.rails[0]

        def stop(_: Observation, end: float = end, sign: float = sign) -> None:
            if sign * (machine.rails[0] - end) < 0.0:
                machine.rails[0], machine.rates[0] = end, 0.0

        assert tried(machine, stop)[:2] == ("BASE_MODE", "NONE")


def test_a_motor_that_lets_its_cable_out_while_slack_is_wound_in_is_named(
    moments: tuple[Machine, Moments],
) -> None:
    machine, saved = moments
    machine.restore(saved["HOME TIGHTEN"])
    out = [0.0, 0.0]

    def unwind(seen: Observation) -> None:
        torque = machine.orders.drives[2].torque
        out[1] += (60.0 * torque - 2.0 * out[1]) * PERIOD
        out[0] += out[1] * PERIOD
        seen.drives[2].position -= out[0]

    assert tried(machine, unwind)[1:] == ("WRONG_WAY", 2)
    assert out[1] < 0.11 * NUMBERS["TB_CABLE_SPEED_LIMIT"]


@pytest.mark.parametrize("drives", ["torque", "position"])
def test_a_mode_or_power_that_never_comes_ends_the_trial(drives: str) -> None:
    machine, saved = supervised.moments(drives)
    tried_at = [name for name in saved if name.startswith("HOME TRY_") and "CABLES" not in name]
    assert bool(tried_at) is (drives == "torque")  # bases that follow positions are not pushed
    for name in tried_at:
        if name == "HOME TRY_BASES":
            continue
        machine.restore(saved[name])

        def stuck(seen: Observation, name: str = name) -> None:
            report = seen.drives[CABLES + 1]
            if name.endswith("MODE"):
                report.progress = supervised.BUSY
            elif name.endswith("POWER"):
                report.power = supervised.Power.READY
            else:
                report.power = supervised.Power.ENABLED

        assert tried(machine, stuck)[1:] == ("DRIVE_STUCK", CABLES + 1)
