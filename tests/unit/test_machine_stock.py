"""The stock machine is the one of Yoon et al. 2023, section III."""

import cmath
import math
from pathlib import Path

import pytest
from machine_text import without_buses

from turnbuckle.model.base import FixedBase, RailBase, RailCoordinate
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine

STOCK = Path(__file__).parents[2] / "machines" / "yoon2023.toml"
WIDTH, HEIGHT = 0.7118, 0.4618
ROUNDING = 1e-15


@pytest.fixture(scope="module")
def machine() -> Machine:
    return load_machine(STOCK)


def variant(tmp_path: Path, old: str, new: str) -> Machine:
    text = without_buses(STOCK.read_text(encoding="utf-8"))
    assert old in text
    path = tmp_path / "variant.toml"
    path.write_text(text.replace(old, new, 1), encoding="utf-8")
    return load_machine(path)


def test_it_is_who_the_paper_says(machine: Machine) -> None:
    assert (machine.name, machine.kind) == ("yoon2023", "planar-point")
    assert machine.source == "Yoon et al. 2023, section III"
    assert machine.path == STOCK
    assert (machine.dof, len(machine.cables), machine.redundancy) == (2, 4, 2)


def test_numbers_are_those_of_the_paper_in_si_and_to_the_last_bit(machine: Machine) -> None:
    assert machine.frame.size == (WIDTH, HEIGHT)
    assert (machine.tension.min, machine.tension.max) == (3.0, 10.0)
    assert machine.drum.radius == 5e-3
    assert (machine.cable_motor.inertia, machine.cable_motor.damping) == (21e-7, 5e-5)
    assert machine.control.rate == 1000.0
    assert (machine.target.size, machine.target.force) == ((0.506, 0.284), 7.0)
    assert machine.target.centre == (0.3559, 0.2309)
    assert [(wall.name, wall.normal) for wall in machine.walls] == [
        ("right", (-1.0, 0.0)),
        ("top", (0.0, -1.0)),
    ]
    assert [(wall.stiffness, wall.damping) for wall in machine.walls] == [
        (3560.0, 5.0),
        (3575.0, 5.0),
    ]


def test_the_bases_slide_along_the_sides_of_the_frame(machine: Machine) -> None:
    sides = [
        ((0.0, 0.0), (WIDTH, 0.0)),
        ((WIDTH, 0.0), (WIDTH, HEIGHT)),
        ((0.0, HEIGHT), (WIDTH, HEIGHT)),
        ((0.0, 0.0), (0.0, HEIGHT)),
    ]
    rails = [cable.base for cable in machine.cables]
    assert all(isinstance(rail, RailBase) for rail in rails)
    assert [(r.start, r.end) for r in rails if isinstance(r, RailBase)] == sides
    assert [rail.cables for rail in machine.rails] == [(0,), (1,), (2,), (3,)]
    assert [cable.drive for cable in machine.cables] == [f"cable_{i}" for i in range(1, 5)]


def test_a_rail_knows_its_length_direction_and_points(machine: Machine) -> None:
    rail = machine.cables[1].rail
    assert rail is not None
    assert (rail.length, rail.direction) == (HEIGHT, (0.0, 1.0))
    assert machine.rails[1] == RailCoordinate(HEIGHT, (1,))
    assert machine.base_motions[1].point([0.2, 0.1, 0.2, 0.2]) == (WIDTH, 0.1)


def test_the_walls_stand_inside_the_screen(machine: Machine) -> None:
    (x, y), (width, height) = machine.target.centre, machine.target.size
    right, top = machine.walls
    assert x < right.point[0] < x + width / 2
    assert y < top.point[1] < y + height / 2


def test_the_motors_have_torque_to_spare_for_the_largest_tension(machine: Machine) -> None:
    assert machine.cable_motor.torque_limit > machine.tension.max * machine.drum.radius


def test_the_coulomb_friction_explains_the_force_missing_in_yoon_fig_12(machine: Machine) -> None:
    assert machine.plant is not None
    assert 0.27 < machine.plant.motor_coulomb_friction / machine.drum.radius < 0.42


def test_a_corner_of_5_hz_is_3_db_down_at_3218_mhz(machine: Machine) -> None:
    observer = machine.disturbance_observer
    assert observer is not None
    assert observer.hand_force == "measured"
    assert observer.time_constant == pytest.approx(1 / (2 * math.pi * 5), rel=ROUNDING)
    assert observer.time_constant == pytest.approx(31.83e-3, abs=0.005e-3)
    assert observer.cut_off == pytest.approx(3.218, abs=0.0005)


def test_minus_3_db_at_5_hz_takes_a_time_constant_of_20486_us(tmp_path: Path) -> None:
    machine = variant(tmp_path, 'corner = "5 Hz"', 'minus_3db = "5 Hz"')
    observer = machine.disturbance_observer
    assert observer is not None
    assert observer.time_constant == pytest.approx(20.486e-3, abs=0.0005e-3)
    assert observer.cut_off == pytest.approx(5.0, rel=ROUNDING)
    gain = 1 / (1 + (2 * math.pi * 5 * observer.time_constant) ** 2)
    assert gain == pytest.approx(math.sqrt(0.5), rel=ROUNDING)


def test_a_fixed_base_stays_where_it_is(tmp_path: Path) -> None:
    rail = 'rail = { from = ["0 mm", "0 mm"], to = ["711.8 mm", "0 mm"] }\ndrive = "cable_1"'
    machine = variant(tmp_path, rail, 'base = ["35.59 cm", "0 mm"]')
    assert machine.cables[0].base == FixedBase((0.3559, 0.0))
    assert machine.cables[0].drive == "cable_1"
    assert [rail.cables for rail in machine.rails] == [(1,), (2,), (3,)]


def test_the_description_names_what_a_user_looks_for(machine: Machine) -> None:
    rows = dict(machine.describe())
    assert rows["cables"] == "4 (cable_1, cable_2, cable_3, cable_4)"
    assert rows["tension"] == "3 to 10 N"
    assert "5 Hz" in rows["disturbance observer"]
    assert "3.218 Hz" in rows["disturbance observer"]
    assert rows["target"] == "506 x 284 mm, 7 N in every direction"


def test_a_machine_cannot_be_changed(machine: Machine) -> None:
    with pytest.raises(ValueError, match="frozen"):
        machine.drum.radius = 1.0


@pytest.mark.parametrize("late", [0, 1])
def test_the_rail_drive_follows_as_fast_as_yoon_fig_14(machine: Machine, late: int) -> None:
    bandwidth = closed_loop_bandwidth(machine, late)
    assert 16 < bandwidth < 23


def closed_loop_bandwidth(machine: Machine, late: int) -> float:
    """-3 dB frequency [Hz] of the carriage on its PID, the force `late` cycles late."""
    drive, plant = machine.rail_drive, machine.plant
    assert drive is not None
    assert plant is not None
    period = 1 / machine.control.rate
    smoothing = -math.expm1(-2 * math.pi * drive.derivative_corner * period)
    mass, damping = plant.carriage_mass, plant.carriage_viscous_friction
    assert mass is not None and damping is not None
    decay = math.exp(-period * damping / mass)
    reach = (1 - decay) * mass / damping
    for frequency in (0.1 * step for step in range(1, 1000)):
        z = cmath.exp(2j * math.pi * frequency * period)
        # Carriage under a force held for a cycle, per newton: speed, then position.
        speed = (1 - decay) / damping / (z - decay)
        position = (reach * speed + (period - reach) / damping) / (z - 1) / z**late
        slope = (1 - 1 / z) / period * smoothing / (1 - (1 - smoothing) / z)
        pull = drive.stiffness + drive.integral * period / (1 - 1 / z)
        gain = abs(pull * position / (1 + (pull + drive.damping * slope) * position))
        if gain < math.sqrt(0.5):
            return frequency
    return math.inf
