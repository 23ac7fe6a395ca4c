"""Cable zeros: against an independent least squares on all unknowns, on machines of every kind."""

import numpy as np
import pytest
from bare_core import CLOSURE, SAMPLES, Kinematics, Part, in_slots, kinematics_of, slots, source
from numpy.typing import NDArray
from scipy.optimize import least_squares

from turnbuckle.codegen.bind import REALS
from turnbuckle.model.machine import Machine
from turnbuckle.model.reference import kinematics

Doubles = NDArray[np.float64]
BUSY, DONE, UNOBSERVABLE, OPEN = range(4)
COUNT = 7.67e-6
"""One count of a cable's encoder [m]."""
NOISE = COUNT / np.sqrt(12)
"""Standard deviation of a length in whole counts [m]."""
LONGEST_STEP, MOST_STEPS = 0.1, 50
"""Of the fit [m, rad]."""
MACHINES = [
    "yoon2023",
    "yoon_synchronised",
    "three_base_equilateral",
    "brau_five",
    "brau_tetrahedron",
    "planar_rigid",
    "spidar_g",
    "kinematics_planar_pulleys",
]
FILES = ["calibration.c", "pose_space.c"]


class Calibration(Part):
    """calibration.c for one machine."""

    def __init__(self, generated: Kinematics, change: tuple[str, str] = ("", "")) -> None:
        """`change`: words of the C to be replaced by others."""
        self.generated, machine = generated, generated.machine
        real = REALS[generated.precision]
        n = len(machine.cables)
        layout = np.dtype(
            [
                ("wound", real, (SAMPLES, n)),
                ("rails", real, (SAMPLES, slots(generated))),
                ("poses", real, (SAMPLES, machine.dof)),
                ("zeros", real, n),
                ("residual", real),
                ("spread", real),
                ("count", np.uint32),
                ("steps", np.uint32),
            ],
            align=True,
        )
        sources = {name: source(name) for name in FILES}
        if change[0]:
            assert change[0] in sources["calibration.c"]
            sources["calibration.c"] = sources["calibration.c"].replace(*change)
        super().__init__(generated, sources, layout)

    def solve(self, wound: Doubles, rails: Doubles) -> int:
        """Measure wound cable (k, n) [m] with rails (k, m) [m], then step to the end."""
        self.call("tb_calibration_start")
        for one, slides in zip(wound, in_slots(self.generated, rails), strict=True):
            self.call("tb_calibration_add", one.astype(slides.dtype), slides)
        while (progress := self.call("tb_calibration_solve")) == BUSY:
            assert self.is_finite()
        assert self.is_finite()
        return progress

    def is_finite(self) -> bool:
        """Whether there is no NaN or infinity anywhere."""
        names = self.memory.dtype.names or ()
        return all(bool(np.isfinite(self.memory[name]).all()) for name in names)

    @property
    def zeros(self) -> Doubles:
        return np.asarray(self.memory["zeros"][0], float)


def zero(machine: Machine) -> Doubles:
    """Zeros (n) [m], nowhere near the lengths."""
    return np.random.default_rng(7).uniform(-5, 5, len(machine.cables))


def whole_counts(machine: Machine, poses: Doubles, rails: Doubles) -> Doubles:
    """What the drives count (k, n) [m] in these poses."""
    wound = zero(machine) - kinematics.cable_lengths(machine, poses, rails)
    return np.asarray(np.round(wound / COUNT) * COUNT)


def somewhere(machine: Machine, count: int, random: np.random.Generator) -> Doubles:
    """Poses in the target (count, d), turned by up to 0.3 rad."""
    pose = np.zeros((count, machine.dof))
    size = np.array(machine.target.size)
    place = np.array(machine.target.centre) + size * random.uniform(-0.5, 0.5, (count, len(size)))
    pose[:, : machine.space] = place[:, : machine.space]
    turn = pose[:, machine.space :]
    turn[...] = random.uniform(-1, 1, turn.shape) * 0.3 / np.sqrt(max(1, turn.shape[1]))
    return pose


def middle(machine: Machine) -> Doubles:
    """Rails (m) in the middle [m]."""
    return np.array([rail.length / 2 for rail in machine.rails])


def sweep(machine: Machine, count: int = SAMPLES) -> Doubles:
    """Rails (count, m) [m]: 0.1 m about the middle, 1, 2, 1, 3 periods."""
    periods = np.resize([1.0, 2.0, 1.0, 3.0], len(machine.rails))
    share = (np.arange(count)[:, None] + 0.5) / count
    return np.asarray(middle(machine) + 0.1 * np.sin(2 * np.pi * periods * share))


def measurements(machine: Machine, seed: int, count: int = SAMPLES) -> tuple[Doubles, Doubles]:
    """Poses (count, d) and rails (count, m): swept bases under a still platform, or it is moved."""
    random = np.random.default_rng(seed)
    if len(machine.rails) == len(machine.cables) and machine.dof == 2:
        return np.repeat(somewhere(machine, 1, random), count, axis=0), sweep(machine, count)
    return somewhere(machine, count, random), np.repeat(middle(machine)[None], count, axis=0)


def fitted(machine: Machine, wound: Doubles, rails: Doubles, near: Doubles) -> Doubles:
    """Zeros (n) of scipy's least squares on zeros and poses, started near the true poses."""
    n, d, count = len(machine.cables), machine.dof, len(wound)

    def errors(unknowns: Doubles) -> Doubles:
        poses = unknowns[n:].reshape(count, d)
        lengths = kinematics.cable_lengths(machine, poses, rails)
        return np.asarray(unknowns[:n] - wound - lengths).ravel()

    def slopes(unknowns: Doubles) -> Doubles:
        """Central differences, of all poses at once: none touches another's lengths."""
        jacobian = np.zeros((count, n, n + count * d))
        jacobian[:, :, :n] = np.eye(n)
        for j in range(d):
            step = np.zeros_like(unknowns)
            step[n + j :: d] = 1e-6
            change = (errors(unknowns + step) - errors(unknowns - step)) / 2e-6
            for k, column in enumerate(change.reshape(count, n)):
                jacobian[k, :, n + k * d + j] = column
        return jacobian.reshape(count * n, -1)

    begin = np.concatenate([zero(machine), near.ravel()])
    found = least_squares(errors, begin, slopes, method="lm", xtol=1e-14, ftol=1e-14, gtol=1e-14)
    return np.asarray(found.x[:n])


def spread_of(machine: Machine, poses: Doubles, rails: Doubles) -> float:
    """The worst zero's standard deviation over that of a length, by NumPy."""
    n = len(machine.cables)
    normal = np.zeros((n, n))
    for jacobian in kinematics.length_jacobian(machine, poses, rails):
        normal += np.eye(n) - jacobian @ np.linalg.pinv(jacobian)
    return float(np.sqrt(np.max(np.diag(np.linalg.inv(normal)))))


@pytest.mark.parametrize("precision", REALS)
@pytest.mark.parametrize("name", MACHINES)
def test_zeros_are_those_of_a_least_squares_on_all_unknowns(name: str, precision: str) -> None:
    generated = kinematics_of(name, precision)
    machine, calibration = generated.machine, Calibration(generated)
    poses, rails = measurements(machine, 1)
    wound = whole_counts(machine, poses, rails)
    assert calibration.solve(wound, rails) == DONE
    judged = wound.astype(REALS[precision]).astype(float)
    tolerance = 1e-5 if precision == "float" else 1e-7
    assert np.max(np.abs(calibration.zeros - fitted(machine, judged, rails, poses))) < tolerance
    assert calibration.memory["spread"][0] == pytest.approx(
        spread_of(machine, poses, rails), rel=0.02
    )


@pytest.mark.parametrize("name", MACHINES)
def test_zeros_are_found_from_anywhere_in_the_target(name: str) -> None:
    generated = kinematics_of(name, "double")
    machine, calibration = generated.machine, Calibration(generated)
    for seed in range(20):
        poses, rails = measurements(machine, 100 + seed)
        assert calibration.solve(whole_counts(machine, poses, rails), rails) == DONE
        bound = 6 * NOISE * float(calibration.memory["spread"][0])
        assert np.max(np.abs(calibration.zeros - zero(machine))) < bound


def test_the_spread_is_what_random_errors_make_of_the_zeros() -> None:
    generated = kinematics_of("yoon2023", "double")
    machine, calibration = generated.machine, Calibration(generated)
    poses, rails = measurements(machine, 3)
    exact = zero(machine) - kinematics.cable_lengths(machine, poses, rails)
    random = np.random.default_rng(4)
    errors = []
    for _ in range(400):
        noise = random.normal(0, NOISE, exact.shape)
        assert calibration.solve(exact + noise, rails) == DONE
        errors.append(calibration.zeros - zero(machine))
    worst = np.max(np.std(errors, axis=0)) / NOISE
    assert worst == pytest.approx(float(calibration.memory["spread"][0]), rel=0.1)


@pytest.mark.parametrize("lag", [0.0, 0.005])
@pytest.mark.parametrize("precision", REALS)
def test_bases_that_follow_the_hand_do_not_tell_the_zeros(precision: str, lag: float) -> None:
    generated = kinematics_of("yoon2023", precision)
    random = np.random.default_rng(5)
    poses = somewhere(generated.machine, SAMPLES, random)
    rails = poses[:, [0, 1, 0, 1]] + random.uniform(-lag, lag, (SAMPLES, 4))
    wound = whole_counts(generated.machine, poses, rails)
    assert Calibration(generated).solve(wound, rails) == UNOBSERVABLE


def test_a_free_handle_under_equal_tensions_does_not_tell_the_zeros() -> None:
    """It rests where the lines of opposite cables cross, wherever the bases are."""
    generated = kinematics_of("yoon2023", "double")
    rails = sweep(generated.machine)
    points = kinematics.base_points(generated.machine, rails)
    one, other = points[:, 2] - points[:, 0], points[:, 3] - points[:, 1]
    between = np.stack([one, -other], axis=-1)
    shares = np.linalg.solve(between, (points[:, 1] - points[:, 0])[..., None])
    poses = points[:, 0] + shares[:, 0] * one
    wound = whole_counts(generated.machine, poses, rails)
    assert Calibration(generated).solve(wound, rails) == UNOBSERVABLE


@pytest.mark.parametrize("count", [0, 1, SAMPLES])
def test_poses_that_do_not_differ_do_not_tell_the_zeros(count: int) -> None:
    generated = kinematics_of("brau_five", "double")
    machine = generated.machine
    poses = np.repeat(somewhere(machine, 1, np.random.default_rng(6)), count, axis=0)
    rails = np.zeros((count, 0))
    wound = whole_counts(machine, poses, rails)
    assert Calibration(generated).solve(wound, rails) == UNOBSERVABLE


def test_a_cable_that_slips_meanwhile_does_not_close() -> None:
    generated = kinematics_of("yoon2023", "double")
    poses, rails = measurements(generated.machine, 8)
    wound = whole_counts(generated.machine, poses, rails)
    wound[SAMPLES // 2 :, 1] += 4 * CLOSURE
    calibration = Calibration(generated)
    assert calibration.solve(wound, rails) == OPEN
    assert calibration.memory["residual"][0] > CLOSURE


@pytest.mark.parametrize("precision", REALS)
def test_measurements_that_no_machine_gives_end_in_a_refusal(precision: str) -> None:
    generated = kinematics_of("yoon2023", precision)
    calibration, random = Calibration(generated), np.random.default_rng(9)
    for size in (0.0, 1.0, 1e3, 1e6):
        for slides in (0.0, 1.0, 1e3, 1e6):
            wound = random.uniform(-size, size, (SAMPLES, 4))
            rails = random.uniform(-slides, slides, (SAMPLES, 4))
            assert calibration.solve(wound, rails) in (UNOBSERVABLE, OPEN)


@pytest.mark.parametrize("seed", [0, 1])
def test_the_fit_of_turned_poses_is_quadratic_at_its_end(seed: int) -> None:
    generated = kinematics_of("spidar_g", "double")
    poses, rails = measurements(generated.machine, seed)
    calibration = Calibration(generated)
    assert calibration.solve(whole_counts(generated.machine, poses, rails), rails) == DONE
    assert calibration.memory["steps"][0] <= 6


def test_a_fit_moves_by_a_bounded_step_and_is_given_up_after_fifty() -> None:
    generated = kinematics_of("yoon2023", "double")
    calibration, random = Calibration(generated), np.random.default_rng(9)
    calibration.call("tb_calibration_start")
    for _ in range(SAMPLES):
        calibration.call("tb_calibration_add", random.uniform(-1, 1, 4), random.uniform(-1, 1, 4))
    before, longest = None, 0.0
    while calibration.call("tb_calibration_solve") == BUSY:
        if before is not None:
            moved = (calibration.memory[name] - before[name] for name in ("zeros", "poses"))
            longest = max(longest, *(float(np.abs(each).max()) for each in moved))
        before = calibration.memory.copy()
    assert longest == pytest.approx(LONGEST_STEP, rel=1e-9)
    assert calibration.memory["steps"][0] == MOST_STEPS


def test_a_measurement_that_is_not_finite_is_left_out() -> None:
    generated = kinematics_of("yoon2023", "double")
    poses, rails = measurements(generated.machine, 10)
    wound = whole_counts(generated.machine, poses, rails)
    wound[3, 1], wound[5, 2], rails[7, 0] = np.nan, np.inf, -np.inf
    calibration = Calibration(generated)
    assert calibration.solve(wound, rails) == DONE
    assert calibration.memory["count"][0] == SAMPLES - 3


@pytest.mark.parametrize(
    "change",
    [
        ("right[i] -= misfit[i]", "right[i] += misfit[i]"),
        ("(TB_C(1.0) / TB_CABLES)", "TB_C(3.0)"),
        ("matrix[(i * TB_CABLES) + j] += left[j]", "matrix[(i * TB_CABLES) + j] += left[i]"),
    ],
)
def test_a_seeded_defect_is_caught(change: tuple[str, str]) -> None:
    generated = kinematics_of("yoon2023", "double")
    machine = generated.machine
    poses, rails = measurements(machine, 1)
    calibration = Calibration(generated, change)
    wound = whole_counts(machine, poses, rails)
    answer = calibration.solve(wound, rails)
    wanted = fitted(machine, wound, rails, poses)
    assert answer != DONE or np.max(np.abs(calibration.zeros - wanted)) > 1e-7
