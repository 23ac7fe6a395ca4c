"""The watch over the cables: every cable slack and broken, on machines of several kinds."""

from typing import NamedTuple

import numpy as np
import pytest
from bare_core import CLOSURE, Kinematics, Part, in_slots, kinematics_of, slots, source
from numpy.typing import NDArray

from turnbuckle.codegen.bind import REALS
from turnbuckle.lab.causes import causes
from turnbuckle.model.machine import Machine
from turnbuckle.model.reference import kinematics

Doubles = NDArray[np.float64]
BRIDGED = 5
"""TB_CLOSURE_CYCLES of the stand-in."""
LAG_BRIDGED = 200
"""TB_RAIL_LAG_CYCLES of the stand-in."""
DELTA = 0.01
"""How much longer or shorter a faulty cable is than its drive says [m]."""
COUNT = 7.67e-6
"""One count of a cable's encoder [m]."""
FACTS = [cause.name for cause in causes()]
NONE, SLACK, BREAK, RUNAWAY, CLOSED, BASE_LOST = (
    FACTS.index(name)
    for name in ("NONE", "CABLE_SLACK", "CABLE_BREAK", "RUNAWAY", "CLOSURE", "BASE_LOST")
)
REDUNDANT = ["yoon2023", "brau_five", "planar_rigid", "spidar_g", "kinematics_planar_pulleys"]
SINGLE = ["brau_triangle", "three_base_equilateral", "brau_tetrahedron"]

SHIM = """
#include "watch.h"
int32_t shim_watch(tb_watch *watch, const real_t *lengths, const real_t *length_rates,
                   const real_t *rails, const real_t *rail_targets, const real_t *pose,
                   const real_t *residual, real_t *slack);
int32_t shim_watch(tb_watch *watch, const real_t *lengths, const real_t *length_rates,
                   const real_t *rails, const real_t *rail_targets, const real_t *pose,
                   const real_t *residual, real_t *slack)
{
    tb_watched const seen = {lengths, length_rates, rails, rail_targets, pose, *residual};
    tb_verdict const verdict = tb_watch_cables(watch, &seen, slack);
    return ((int32_t)verdict.culprit * 256) + (int32_t)verdict.cause;
}
"""


class Verdict(NamedTuple):
    """What the watch says of a cycle."""

    cause: int
    culprit: int
    slack: Doubles  # m


class Watch(Part):
    """watch.c for one machine."""

    def __init__(self, generated: Kinematics, change: tuple[str, str] = ("", "")) -> None:
        """`change`: words of the C to be replaced by others."""
        self.generated = generated
        layout = np.dtype([("open", np.uint16), ("lagging", np.uint16, slots(generated))])
        sources = {name: source(name) for name in ("watch.c", "pose_space.c")}
        if change[0]:
            assert change[0] in sources["watch.c"]
            sources["watch.c"] = sources["watch.c"].replace(*change)
        super().__init__(generated, sources | {"shim.c": SHIM}, layout)
        self.call("tb_watch_start")

    def look(
        self,
        lengths: Doubles,
        rails: Doubles,
        pose: Doubles,
        residual: float,
        rates: Doubles | None = None,
        targets: Doubles | None = None,
    ) -> Verdict:
        """One cycle; rates are 0 and targets the rails where they are not given."""
        real = REALS[self.generated.precision]
        slack = np.full(len(lengths), np.nan, real)
        answer = self.call(
            "shim_watch",
            lengths.astype(real),
            (np.zeros_like(lengths) if rates is None else rates).astype(real),
            in_slots(self.generated, rails),
            in_slots(self.generated, rails if targets is None else targets),
            pose.astype(real),
            np.array([residual], real),
            slack,
        )
        assert np.isfinite(slack).all()
        return Verdict(answer % 256, answer // 256, slack.astype(float))

    def look_on(
        self,
        lengths: Doubles,
        rails: Doubles,
        pose: Doubles,
        residual: float,
        rates: Doubles | None = None,
    ) -> Verdict:
        """One cycle more than the closure may be open; the ones before must bridge it."""
        for _ in range(BRIDGED):
            assert self.look(lengths, rails, pose, residual, rates).cause == NONE
        return self.look(lengths, rails, pose, residual, rates)


def scene(machine: Machine, random: np.random.Generator) -> tuple[Doubles, Doubles]:
    """A pose (d) in the target, turned by up to 0.1 rad, and rails (m) anywhere."""
    pose = np.zeros(machine.dof)
    size = np.array(machine.target.size)
    place = np.array(machine.target.centre) + size * random.uniform(-0.5, 0.5, len(size))
    pose[: machine.space] = place[: machine.space]
    pose[machine.space :] = random.uniform(-0.1, 0.1, machine.dof - machine.space)
    return pose, np.array([rail.length for rail in machine.rails]) * random.uniform(
        0.2, 0.8, len(machine.rails)
    )


def measured(
    machine: Machine, pose: Doubles, rails: Doubles, fault: Doubles
) -> tuple[Doubles, Doubles, float]:
    """Lengths with a fault (n) [m], in whole counts; the pose they give and its residual."""
    lengths = kinematics.cable_lengths(machine, pose, rails) + fault
    lengths = np.round(lengths / COUNT) * COUNT
    fitted = pose.copy()
    for _ in range(20):
        jacobian = kinematics.length_jacobian(machine, fitted, rails)
        error = lengths - kinematics.cable_lengths(machine, fitted, rails)
        step = np.linalg.lstsq(jacobian, error)[0]
        fitted += step  # a turn is small: its vector is near enough to its twist
        if np.max(np.abs(step)) < 1e-9:
            break
    return lengths, fitted, float(np.linalg.norm(error))


def alikeness(machine: Machine, pose: Doubles, rails: Doubles) -> Doubles:
    """|N_ij| / sqrt(N_ii N_jj) of every cable's most similar one (n): 1 where none can be told."""
    jacobian = kinematics.length_jacobian(machine, pose, rails)
    rest = np.eye(len(jacobian)) - jacobian @ np.linalg.pinv(jacobian)
    scale = np.sqrt(np.diag(rest))
    alike = np.abs(rest) / np.outer(scale, scale)
    np.fill_diagonal(alike, 0)
    return np.asarray(alike.max(axis=1))


@pytest.mark.parametrize("precision", REALS)
@pytest.mark.parametrize("name", REDUNDANT)
def test_the_faulty_cable_is_named_and_never_another(name: str, precision: str) -> None:
    generated = kinematics_of(name, precision)
    machine, watch = generated.machine, Watch(generated)
    random, named = np.random.default_rng(1), 0
    for _ in range(8):
        pose, rails = scene(machine, random)
        alike = alikeness(machine, pose, rails)
        for cable in range(len(machine.cables)):
            for delta in (DELTA, -DELTA):
                fault = np.where(np.arange(len(machine.cables)) == cable, delta, 0.0)
                lengths, fitted, residual = measured(machine, pose, rails, fault)
                if residual <= CLOSURE:
                    continue  # cables that carry little redundancy hide their faults
                watch.call("tb_watch_start")
                verdict = watch.look_on(lengths, rails, fitted, residual, 10 * fault)
                right = (SLACK if delta > 0 else BREAK, cable)
                assert verdict[:2] == right or verdict.cause == CLOSED
                if alike[cable] < 0.8:  # to half it would leave 0.866 (watch.h)
                    assert verdict[:2] == right
                    assert verdict.slack[cable] == pytest.approx(delta, rel=0.25)
                    named += 1
    # the cables of spidar_g lie so symmetrically that every one has others much alike
    assert (named >= 10) == (name != "spidar_g")


@pytest.mark.parametrize("name", SINGLE)
def test_one_redundant_cable_shows_the_fault_and_motion_shows_the_cable(name: str) -> None:
    generated = kinematics_of(name, "double")
    machine, watch = generated.machine, Watch(generated)
    random, shown = np.random.default_rng(2), 0
    for _ in range(5):
        pose, rails = scene(machine, random)
        for cable in range(len(machine.cables)):
            for delta in (DELTA, -DELTA):
                fault = np.where(np.arange(len(machine.cables)) == cable, delta, 0.0)
                lengths, fitted, residual = measured(machine, pose, rails, fault)
                if residual <= CLOSURE:
                    continue
                right = SLACK if delta > 0 else BREAK
                watch.call("tb_watch_start")
                verdict = watch.look_on(lengths, rails, fitted, residual)
                if verdict.slack.min() < 0 < verdict.slack.max():  # not all pull against each other
                    assert verdict.cause == CLOSED
                    continue
                assert verdict.cause == right
                watch.call("tb_watch_start")
                verdict = watch.look_on(lengths, rails, fitted, residual, 10 * fault)
                assert verdict[:2] == (right, cable)
                assert verdict.slack[cable] == pytest.approx(delta, rel=0.5)
                shown += 1
    assert shown > 10


@pytest.mark.parametrize("cable", [0, 2])
def test_of_opposite_cables_in_line_the_one_that_moves_is_named(cable: int) -> None:
    """As in Yoon's operation, with every base beside the hand."""
    generated = kinematics_of("yoon2023", "double")
    machine = generated.machine
    pose = np.array([0.3, 0.2])
    rails = pose[[0, 1, 0, 1]]
    fault = np.where(np.arange(4) == cable, -DELTA, 0.0)
    lengths, fitted, residual = measured(machine, pose, rails, fault)
    verdict = Watch(generated).look_on(lengths, rails, fitted, residual)
    assert verdict.cause == BREAK
    assert verdict.culprit in (0, 2)
    verdict = Watch(generated).look_on(lengths, rails, fitted, residual, 10 * fault)
    assert verdict[:2] == (BREAK, cable)
    assert verdict.slack[[0, 2]] == pytest.approx([-DELTA, -DELTA], rel=1e-2)
    assert np.max(np.abs(verdict.slack[[1, 3]])) < 0.01 * DELTA


def test_two_faults_at_once_are_no_single_cable() -> None:
    generated = kinematics_of("brau_five", "double")
    pose, rails = scene(generated.machine, np.random.default_rng(4))
    fault = np.array([DELTA, 0, -DELTA, 0, 0])
    lengths, fitted, residual = measured(generated.machine, pose, rails, fault)
    assert Watch(generated).look_on(lengths, rails, fitted, residual).cause == CLOSED


@pytest.mark.parametrize("precision", REALS)
def test_encoder_noise_and_short_openings_are_no_fault(precision: str) -> None:
    generated = kinematics_of("yoon2023", precision)
    machine, watch = generated.machine, Watch(generated)
    pose, rails = scene(machine, np.random.default_rng(5))
    good = measured(machine, pose, rails, np.zeros(4))
    torn = measured(machine, pose, rails, np.array([DELTA, 0, 0, 0]))
    for cycle in range(100):
        lengths, fitted, residual = good if cycle % (BRIDGED + 1) == 0 else torn
        verdict = watch.look(lengths, rails, fitted, residual)
        assert verdict.cause == NONE
        assert verdict.slack.any() == (residual > CLOSURE)


@pytest.mark.parametrize("speed", [5.1, -5.1, np.nan, np.inf])
def test_a_cable_beyond_its_speed_limit_has_run_away(speed: float) -> None:
    generated = kinematics_of("yoon2023", "double")
    machine, watch = generated.machine, Watch(generated)
    pose, rails = scene(machine, np.random.default_rng(6))
    lengths, fitted, residual = measured(machine, pose, rails, np.zeros(4))
    rates = np.array([4.9, -4.9, speed, 0])
    assert watch.look(lengths, rails, fitted, residual, rates=rates)[:2] == (RUNAWAY, 2)


@pytest.mark.parametrize("lag", [0.06, -0.06, np.nan])
def test_a_base_far_from_its_target_for_long_is_lost(lag: float) -> None:
    generated = kinematics_of("yoon2023", "double")
    machine, watch = generated.machine, Watch(generated)
    pose, rails = scene(machine, np.random.default_rng(7))
    lengths, fitted, residual = measured(machine, pose, rails, np.zeros(4))
    off = np.array([0.04, -0.04, 0, lag])
    for targets in [*[rails + off] * LAG_BRIDGED, rails, *[rails + off] * LAG_BRIDGED]:
        verdict = watch.look(lengths, rails, fitted, residual, targets=targets)
        assert verdict.cause == NONE
    verdict = watch.look(lengths, rails, fitted, residual, targets=rails + off)
    assert verdict[:2] == (BASE_LOST, len(machine.cables) + 3)


@pytest.mark.parametrize("bad", [np.nan, np.inf, 1e300])
def test_what_is_no_number_opens_the_closure_without_a_culprit(bad: float) -> None:
    generated = kinematics_of("yoon2023", "double")
    pose, rails = scene(generated.machine, np.random.default_rng(8))
    lengths, fitted, _ = measured(generated.machine, pose, rails, np.zeros(4))
    lengths[1] = bad
    verdict = Watch(generated).look_on(lengths, rails, fitted, bad)
    assert verdict.cause == CLOSED
    assert not verdict.slack.any()


@pytest.mark.parametrize(
    "change",
    [
        ("(possible && (slack[i] > 0))", "(possible && (slack[i] < 0))"),
        ("slack[i] * error[i]", "error[i] * error[i]"),
        ("(left[i] > LEAST", "(left[0] > LEAST"),
        ("(error[i] / left[i])", "error[i]"),
        ("rest <= (EXPLAINS", "rest >= (EXPLAINS"),
        ("suspicion->culprit = cable;", "suspicion->culprit = 0;"),
    ],
)
def test_a_seeded_defect_is_caught(change: tuple[str, str]) -> None:
    generated = kinematics_of("brau_five", "double")
    machine, watch = generated.machine, Watch(generated, change)
    random, wrong = np.random.default_rng(1), 0
    for _ in range(8):
        pose, rails = scene(machine, random)
        alike = alikeness(machine, pose, rails)
        for cable in range(5):
            fault = np.where(np.arange(5) == cable, DELTA, 0.0)
            lengths, fitted, residual = measured(machine, pose, rails, fault)
            watch.call("tb_watch_start")
            verdict = watch.look_on(lengths, rails, fitted, residual)
            named = verdict[:2] == (SLACK, cable) and abs(verdict.slack[cable] - DELTA) < 1e-3
            wrong += alike[cable] < 0.8 and not named
    assert wrong
