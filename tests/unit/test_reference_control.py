"""The reference control laws against SciPy's filters, the audit's numbers and hand calculation."""

import numpy as np
import numpy.typing as npt
import pytest
from scipy import signal

from turnbuckle.model.machine import Cable, Machine
from turnbuckle.model.reading import load_machine
from turnbuckle.model.reference.control import (
    BasePid,
    base_pid,
    base_targets,
    disturbance_sequence,
    load_tension,
    motor_torques,
    observer_filters,
    velocity_sequence,
    wall_force,
)
from turnbuckle.model.reference.kinematics import structure_matrix
from turnbuckle.model.reference.statics import wrench

Doubles = npt.NDArray[np.float64]
STOCK = load_machine("machines/yoon2023.toml")
EPS = np.finfo(float).eps
RATE, RADIUS = STOCK.control.rate, STOCK.drum.radius
INERTIA, DAMPING = STOCK.cable_motor.inertia, STOCK.cable_motor.damping
assert STOCK.rail_drive is not None and STOCK.disturbance_observer is not None
DRIVE, TAU = STOCK.rail_drive, STOCK.disturbance_observer.time_constant


def without(part: str) -> Machine:
    return STOCK.model_copy(update={part: None})


def test_motor_torque_is_tension_times_drum_radius() -> None:
    assert np.allclose(motor_torques(STOCK, [3.0, 10.0]), [0.015, 0.05], rtol=2 * EPS, atol=0)


def test_observer_filters_are_those_of_the_audit() -> None:
    low_pass, inverse_motor = observer_filters(STOCK)
    assert np.allclose(
        low_pass.numerator.astype(float), 2.3916743137504e-4 * np.array([1, 2, 1]), rtol=1e-13
    )
    assert np.allclose(
        low_pass.denominator.astype(float), [1, -1.938139843986612, 0.939096513712], rtol=1e-12
    )
    assert np.allclose(
        inverse_motor.numerator.astype(float),
        [2.032923166688e-3, -4.018012847101e-3, 1.985089680413e-3],
        rtol=1e-12,
    )
    assert np.array_equal(inverse_motor.denominator, low_pass.denominator)


def test_observer_filters_are_the_bilinear_transform_of_scipy() -> None:
    low_pass, inverse_motor = observer_filters(STOCK, np.float64)
    square = [TAU**2, 2 * TAU, 1]
    for found, numerator in ((low_pass, [1]), (inverse_motor, [INERTIA, DAMPING, 0])):
        b, a = signal.bilinear(numerator, square, fs=RATE)
        assert np.allclose(found.numerator, b, rtol=1e-10, atol=1e-16)
        assert np.allclose(found.denominator, a, rtol=1e-12, atol=0)


def test_the_papers_corner_of_5_hz_is_3_db_down_at_3_218_hz() -> None:
    low_pass, _ = observer_filters(STOCK, np.float64)
    _, response = signal.freqz(low_pass.numerator, low_pass.denominator, [3.218, 5], fs=RATE)
    assert np.allclose(np.abs(response), [np.sqrt(0.5), 0.5], atol=2e-4)


def random_recording(count: int) -> tuple[Doubles, Doubles, Doubles]:
    rng = np.random.default_rng(count)
    lengths = 0.3 + 1e-3 * np.cumsum(rng.normal(size=(count, 4)), axis=0)
    return lengths, rng.uniform(3, 10, (count, 4)), rng.uniform(0.015, 0.05, (count, 4))


def test_the_disturbance_is_scipys_filter_of_angle_and_torque() -> None:
    lengths, load, applied = random_recording(2000)
    low_pass, inverse_motor = observer_filters(STOCK, np.float64)
    expected = signal.lfilter(
        inverse_motor.numerator,
        inverse_motor.denominator,
        (lengths - lengths[0]) / RADIUS,
        axis=0,
    ) + signal.lfilter(low_pass.numerator, low_pass.denominator, applied - RADIUS * load, axis=0)
    found = disturbance_sequence(STOCK, lengths, load, applied)
    assert np.allclose(found, expected, rtol=0, atol=1e-10 * np.max(np.abs(expected)))


def test_a_constant_disturbance_torque_is_found_whatever_the_motion() -> None:
    """A motor that obeys J theta'' + B theta' = r_p T - tau + d, recorded exactly."""
    time = np.arange(1000)[:, None] / RATE
    swing, pulse, disturbance = 0.5, 2 * np.pi * 2, 3e-3
    angle = swing * (1 - np.cos(pulse * time))
    torque_of_motion = INERTIA * swing * pulse**2 * np.cos(pulse * time)
    torque_of_motion += DAMPING * swing * pulse * np.sin(pulse * time)
    load = 5 + np.sin(9 * time)
    applied = RADIUS * load + disturbance - torque_of_motion
    found = disturbance_sequence(STOCK, 0.3 + RADIUS * angle, load, applied)
    assert np.allclose(found[-300:], disturbance, rtol=0, atol=1e-3 * disturbance)


def test_a_machine_at_rest_in_balance_has_no_disturbance() -> None:
    load = np.full((50, 4), 5.0)
    assert np.all(disturbance_sequence(STOCK, 0 * load + 0.3, load, RADIUS * load) == 0)


def test_the_velocity_filter_is_the_exponential_average_of_the_differences() -> None:
    lengths, _, _ = random_recording(500)
    gain = 1 - np.exp(-2 * np.pi * STOCK.control.velocity_corner / RATE)
    velocity, before = np.zeros(4), lengths[0]
    found = velocity_sequence(STOCK, lengths)
    for now, length in enumerate(lengths):
        velocity = velocity + gain * ((length - before) * RATE - velocity)
        before = length
        assert np.allclose(found[now], velocity, rtol=0, atol=1e-9)


def test_the_velocity_of_a_steady_motion_is_its_rate() -> None:
    found = velocity_sequence(STOCK, 0.3 + 0.25 * np.arange(200) / RATE)
    assert found[0] == 0 and found[-1] == pytest.approx(0.25, rel=1e-9)


def test_sequences_keep_long_double_and_cables() -> None:
    recording = [part.astype(np.longdouble) for part in random_recording(30)]
    found = disturbance_sequence(STOCK, *recording)
    assert found.dtype == np.longdouble and found.shape == (30, 4)
    assert velocity_sequence(STOCK, recording[0]).dtype == np.longdouble


def test_a_wall_pushes_out_with_stiffness_times_depth_minus_damping_times_speed() -> None:
    right, top = STOCK.walls
    inside = np.array([right.point[0] + 0.001, 0.1])
    still = wall_force(STOCK, inside, [0.0, 3.0])
    assert np.allclose(still, [-0.001 * right.stiffness, 0], rtol=1e-12, atol=0)
    entering = wall_force(STOCK, inside, [0.2, 0.0])
    assert np.allclose(entering, [-0.001 * right.stiffness - 0.2 * right.damping, 0], rtol=1e-12)
    corner = wall_force(STOCK, [right.point[0] + 0.001, top.point[1] + 0.002], [0.0, 0.0])
    assert np.allclose(corner, [-0.001 * right.stiffness, -0.002 * top.stiffness], rtol=1e-12)


def test_a_wall_never_pulls_and_is_not_felt_outside() -> None:
    right, _ = STOCK.walls
    inside = np.array([right.point[0] + 0.001, 0.1])
    assert np.all(wall_force(STOCK, inside, [-5.0, 0.0]) == 0)
    assert np.all(wall_force(STOCK, [right.point[0] - 1e-6, 0.1], [9.0, 0.0]) == 0)


def test_base_targets_are_the_pose_on_its_own_axes_kept_on_the_rails() -> None:
    assert np.allclose(base_targets(STOCK, [0.2, 0.3]), [0.2, 0.3, 0.2, 0.3], rtol=2 * EPS)
    width, height = STOCK.frame.size
    far = base_targets(STOCK, [[-1.0, 9.0], [9.0, -1.0]])
    assert np.allclose(far, [[0, height] * 2, [width, 0] * 2], rtol=2 * EPS)


def test_a_base_target_is_the_nearest_point_of_a_slanted_rail() -> None:
    rail = {"from": ["0.1 m", "0.2 m"], "to": ["0.5 m", "0.5 m"]}
    machine = STOCK.model_copy(update={"cables": (Cable.model_validate({"rail": rail}),)})
    pose = np.random.default_rng(0).uniform(-0.5, 1, (50, 2))
    along = np.linspace(0, 0.5, 50001)
    points = np.array([0.1, 0.2]) + along[:, None] * [0.8, 0.6]
    for c, found in zip(pose, base_targets(machine, pose), strict=True):
        nearest = along[np.argmin(np.sum((points - c) ** 2, axis=-1))]
        assert found[0] == pytest.approx(nearest, abs=1e-5)


def test_the_base_controller_sums_spring_integral_and_filtered_damping() -> None:
    memory = np.array([[2.0, 0.3, 0.05]] * 4)
    target, measured = np.full(4, 0.301), np.full(4, 0.3002)
    gain = 1 - np.exp(-2 * np.pi * DRIVE.derivative_corner / RATE)
    speed = 0.05 + gain * (0.0002 * RATE - 0.05)
    after, force = base_pid(STOCK, memory, target, measured)
    expected = DRIVE.stiffness * 0.0008 + 2.0 - DRIVE.damping * speed
    assert np.allclose(force, expected, rtol=1e-11)
    integral = 2.0 + DRIVE.integral * 0.0008 / RATE
    assert np.allclose(after, [integral, 0.3002, speed], rtol=1e-11)


@pytest.mark.parametrize("side", [1, -1])
def test_a_limited_base_force_stops_the_integral_only_in_its_own_direction(side: int) -> None:
    measured = np.full(4, 0.3)
    memory = np.array([[0.0, 0.3, 0.0]] * 4)
    pushing = base_pid(STOCK, memory, measured + side * 0.2, measured)
    assert np.all(pushing.force == side * DRIVE.force_limit)
    assert np.all(pushing.memory[:, 0] == 0)
    memory[:, 0] = side * 2 * DRIVE.force_limit
    easing = base_pid(STOCK, memory, measured - side * 1e-4, measured)
    assert np.all(easing.force == side * DRIVE.force_limit)
    assert np.all(side * easing.memory[:, 0] < side * memory[:, 0])


def test_a_base_comes_to_its_target_and_stays() -> None:
    position, speed, mass, load = np.zeros(4), np.zeros(4), 1.0, 2.0
    now = BasePid(np.zeros((4, 3)), np.zeros(4))
    for _ in range(3000):
        now = base_pid(STOCK, now.memory, np.full(4, 0.02), position)
        speed = speed + (now.force - load) / mass / RATE
        position = position + speed / RATE
    assert np.allclose(position, 0.02, atol=1e-6) and np.allclose(now.force, load, atol=1e-3)


def test_the_load_balances_the_hand_with_the_least_change_of_tension() -> None:
    rng = np.random.default_rng(0)
    pose = rng.uniform(0.1, 0.35, (50, 2))
    structure = structure_matrix(STOCK, pose, rng.uniform(0, 0.46, (50, 4)))
    tension, hand = rng.uniform(3, 10, (50, 4)), rng.normal(0, 4, (50, 2))
    load = load_tension(STOCK, structure, tension, hand)
    assert np.allclose(wrench(STOCK, structure, load), -hand, rtol=0, atol=1e-12)
    for s, t, h, found in zip(structure, tension, hand, load, strict=True):
        least, *_ = np.linalg.lstsq(s, -h - s @ t)
        assert np.allclose(found, t + least, rtol=0, atol=1e-11)


def test_a_hand_that_yields_to_the_cables_leaves_them_their_tension() -> None:
    structure = structure_matrix(STOCK, [0.3, 0.2], [0.1, 0.2, 0.3, 0.4])
    tension = np.array([3.0, 4.0, 5.0, 6.0])
    load = load_tension(STOCK, structure, tension, -wrench(STOCK, structure, tension))
    assert np.array_equal(load, tension)


def test_a_machine_without_the_part_says_so() -> None:
    with pytest.raises(ValueError, match="yoon2023 has no disturbance observer"):
        observer_filters(without("disturbance_observer"))
    with pytest.raises(ValueError, match="yoon2023 has no rail drive"):
        base_pid(without("rail_drive"), np.zeros((4, 3)), np.zeros(4), np.zeros(4))
