"""The controller step: safe whatever it reads, and back without a jump when it can read again."""

import math
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
from motion import committed, recorded, with_defect
from numpy.typing import NDArray

from turnbuckle.codegen.bind import Generated
from turnbuckle.codegen.controller import RUNTIME_CORE, UNCOMPENSATED, Controller, Outputs
from turnbuckle.codegen.struct_layout import LayoutError
from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic.function import Status

CYCLES = 400


@pytest.fixture(scope="module", params=["double", "float"])
def generated(request: pytest.FixtureRequest) -> Generated:
    """The stock machine in both precisions."""
    return committed("yoon2023", request.param)


@pytest.fixture
def machine(generated: Generated) -> Machine:
    """The stock machine."""
    return generated.machine


@pytest.fixture
def controller(generated: Generated) -> Controller:
    """A controller that was not started yet."""
    return Controller(generated)


def run(controller: Controller, inputs: NDArray[np.void]) -> Outputs:
    """Start at the first of the recorded inputs and run them all."""
    controller.start(inputs["lengths"][0], inputs["rails"][0])
    return controller.run_recorded(inputs)[0]


def eps(outputs: Outputs) -> float:
    """Rounding of the controller's numbers."""
    return float(np.finfo(outputs.pose.dtype).eps)


def all_finite(outputs: Outputs) -> bool:
    """Whether no output of any cycle is NaN or infinite."""
    return all(bool(np.isfinite(column).all()) for column in outputs)


def breaks_of_the_gate(machine: Machine, outputs: Outputs) -> list[str]:
    """What a motor must never see, in words."""
    limit = machine.cable_motor.torque_limit
    step = machine.cable_motor.torque_rate_limit / machine.control.rate
    torque = np.vstack([np.zeros_like(outputs.motor_torque[:1]), outputs.motor_torque])
    slack = 4 * eps(outputs) * limit
    found = []
    if not all_finite(outputs):
        found.append("an output is not finite")
    if (torque < 0).any() or (torque > limit + slack).any():
        found.append("a torque is out of bounds")
    if (np.abs(np.diff(torque.astype(float), axis=0)) > step + slack).any():
        found.append("a torque jumps")
    return found


def is_good(status: NDArray[np.int32]) -> NDArray[np.bool_]:
    """TB_OK or TB_INFEASIBLE."""
    return np.asarray(status <= Status.INFEASIBLE)


def damages(layout: np.dtype[np.void]) -> Iterator[tuple[str, int, float]]:
    """(field, entry, value) of everything that can go wrong in one reading."""
    for field in ("lengths", "rails", "force", "hand_force"):
        for entry in range(layout[field].shape[0]):
            for value in (math.nan, math.inf, -math.inf):
                yield field, entry, value


def test_a_healthy_recording_runs_without_a_failed_cycle(
    machine: Machine, controller: Controller
) -> None:
    outputs = run(controller, recorded(machine, controller, CYCLES, seed=1))
    assert is_good(outputs.status).all()
    assert breaks_of_the_gate(machine, outputs) == []


@pytest.mark.parametrize("cycle", [0, 1, CYCLES // 2])
def test_nan_or_infinity_in_any_input_fails_that_cycle_only(
    machine: Machine, controller: Controller, cycle: int
) -> None:
    healthy = recorded(machine, controller, CYCLES, seed=2)
    for field, entry, value in damages(controller.inputs_layout):
        inputs = healthy.copy()
        inputs[field][cycle, entry] = value
        controller.start(healthy["lengths"][0], healthy["rails"][0])
        outputs, _ = controller.run_recorded(inputs)
        assert breaks_of_the_gate(machine, outputs) == [], (field, entry, value)
        assert np.flatnonzero(~is_good(outputs.status)).tolist() == [cycle], (field, entry, value)


@pytest.mark.parametrize("field", ["lengths", "rails", "force", "hand_force"])
def test_absurd_but_finite_readings_never_reach_a_motor(
    machine: Machine, controller: Controller, field: str
) -> None:
    healthy = recorded(machine, controller, CYCLES, seed=3)
    largest = float(np.finfo(controller.inputs_layout[field].base).max)
    for value in (largest, -largest, 1e20, -1e20, 1e4, -1e4, 0.0):
        inputs = healthy.copy()
        inputs[field][CYCLES // 2] = value
        outputs = run(controller, inputs)
        assert breaks_of_the_gate(machine, outputs) == [], value
        assert is_good(outputs.status[CYCLES // 2 + 1 :]).all(), value


def test_nothing_is_remembered_of_a_failed_cycle(machine: Machine, controller: Controller) -> None:
    inputs = recorded(machine, controller, 2, seed=12)
    inputs["hand_force"][1] = math.nan
    run(controller, inputs[:1])
    before = controller.memory.copy()
    controller.run_recorded(inputs[1:])
    after = controller.memory
    changed = [name for name in before.dtype.names or () if (before[name] != after[name]).any()]
    assert set(changed) <= {"torque", "interrupted"}
    assert after["interrupted"] == 1


def test_a_failed_cycle_keeps_the_cables_just_taut_and_the_carriages_free(
    machine: Machine, controller: Controller
) -> None:
    inputs = recorded(machine, controller, CYCLES, seed=4)
    inputs["lengths"][CYCLES // 2 :, 0] = math.nan
    outputs = run(controller, inputs)
    taut = machine.drum.radius * machine.tension.min
    failed = ~is_good(outputs.status)
    assert failed.sum() == CYCLES // 2
    np.testing.assert_allclose(outputs.motor_torque[-1], taut, rtol=4 * eps(outputs))
    assert (outputs.rail_force[failed] == 0).all() and (outputs.rail_torque[failed] == 0).all()
    assert (outputs.velocity[failed] == 0).all() and (outputs.wanted_force[failed] == 0).all()
    for name in ("pose", "rail_target"):
        kept = getattr(outputs, name)[failed]
        assert (kept == kept[0]).all(), name
    assert (outputs.pose[failed] == outputs.pose[CYCLES // 2 - 1]).all()
    assert (outputs.rail_target[failed] == inputs["rails"][CYCLES // 2 - 1]).all()


def test_torques_go_to_the_minimum_tension_at_the_rate_of_the_gate(
    machine: Machine, controller: Controller
) -> None:
    inputs = recorded(machine, controller, CYCLES, seed=5)
    inputs["force"] = [machine.tension.max - machine.tension.min, 0.0]
    inputs["rails"][CYCLES // 2 :] = math.nan
    torque = run(controller, inputs).motor_torque.astype(float)
    step = machine.cable_motor.torque_rate_limit / machine.control.rate
    before, after = torque[CYCLES // 2 - 1], torque[CYCLES // 2]
    taut = machine.drum.radius * machine.tension.min
    expected = before + np.clip(taut - before, -step, step)
    assert before.max() > taut + step
    np.testing.assert_allclose(after, expected, rtol=1e-5)


def speeds(machine: Machine, controller: Controller) -> NDArray[np.float64]:
    """Every speed the controller remembers, at the cables and along the rails [m/s]."""
    memory = controller.memory[0]
    observer = memory["observer"].reshape(-1, 5)  # TB_OBSERVER_MEMORY
    base = memory["base"].reshape(-1, 3)  # TB_BASE_MEMORY
    at_cables = [memory["length_rates"], machine.drum.radius * observer[:, 1]]
    return np.concatenate([*at_cables, memory["rail_rates"], base[:, 2]]).astype(float)


def test_a_reading_lost_in_a_steady_movement_changes_no_speed(
    machine: Machine, controller: Controller
) -> None:
    steady = recorded(machine, controller, 1000, seed=6)
    pace = np.array([0.05, -0.04, 0.03, -0.02])  # m/s
    moved = pace * np.arange(len(steady))[:, None] / machine.control.rate
    for field in ("lengths", "rails"):
        steady[field] = steady[field][0] + moved
    lost = steady.copy()
    lost["lengths"][-2] = math.nan
    assert is_good(run(controller, steady).status).all()
    expected = speeds(machine, controller)
    outputs = run(controller, lost)
    assert is_good(outputs.status).sum() == len(lost) - 1
    rounding = 4 * eps(outputs) * machine.control.rate
    np.testing.assert_allclose(expected, np.tile(pace, 4), atol=rounding)
    np.testing.assert_allclose(speeds(machine, controller), expected, atol=rounding)


def test_a_reading_lost_in_any_movement_makes_nothing_jump(
    machine: Machine, controller: Controller
) -> None:
    healthy, cycle = recorded(machine, controller, CYCLES, seed=6), CYCLES // 2
    lost = healthy.copy()
    lost["lengths"][cycle] = math.nan
    expected, found = run(controller, healthy), run(controller, lost)
    after = slice(cycle + 1, None)
    for name in ("velocity", "disturbance", "rail_force"):
        difference = getattr(found, name)[after] - getattr(expected, name)[after]
        assert np.abs(difference).max() < 0.05 * np.abs(getattr(expected, name)).max(), name


def test_a_controller_started_on_a_bad_reading_waits_safely_for_a_good_one(
    machine: Machine, controller: Controller
) -> None:
    inputs = recorded(machine, controller, CYCLES, seed=7)
    inputs["lengths"][:10] = math.nan
    assert controller.start(inputs["lengths"][0], inputs["rails"][0]) == Status.OUT_OF_DOMAIN
    outputs, _ = controller.run_recorded(inputs)
    assert breaks_of_the_gate(machine, outputs) == []
    assert is_good(outputs.status).tolist() == [False] * 10 + [True] * (CYCLES - 10)
    # The first good cycle knows no rate yet, so the platform is at rest for it.
    assert np.abs(outputs.velocity[10]).max() <= eps(outputs) * machine.control.rate


def test_a_controller_that_searches_its_pose_is_started_where_the_platform_is() -> None:
    generated = committed("planar_rigid", "double")
    machine = generated.machine
    pose = np.add([*machine.target.centre, 0.0], [0.02, -0.015, 0.1])
    rails = np.array([0.4 * rail.length for rail in machine.rails])
    lengths = generated.cable_lengths(pose, rails)
    controller = Controller(generated)
    assert controller.start(lengths, rails) == Status.OK
    assert np.allclose(controller.memory["pose"][0], pose, rtol=0, atol=1e-9)
    outputs = controller.step(lengths, rails, np.zeros(machine.dof), np.zeros(machine.dof))
    assert outputs.status == Status.OK
    assert np.allclose(outputs.pose, pose, rtol=0, atol=1e-9)
    assert controller.start(10.0 * lengths, rails) != Status.OK
    assert np.array_equal(controller.memory["pose"][0, :2], machine.target.centre)


def test_torques_and_the_memory_of_bases_are_taken_over(controller: Controller) -> None:
    torque, base = (np.arange(controller.memory[name].size) + 0.5 for name in ("torque", "base"))
    before = controller.memory.copy()
    controller.take_over(torque, base)
    for name in {*(before.dtype.names or ())} - {"torque", "base"}:
        assert controller.memory[name].tobytes() == before[name].tobytes()
    assert controller.memory["torque"].ravel().tolist() == torque.tolist()
    assert controller.memory["base"].ravel().tolist() == base.tolist()


def test_a_force_no_hand_can_have_is_a_broken_sensor(
    machine: Machine, controller: Controller
) -> None:
    bound = len(machine.cables) * machine.tension.max
    for entry in range(machine.dof):
        for sign in (-1, 1):
            inputs = recorded(machine, controller, 2, seed=8)
            inputs["hand_force"][0, entry] = sign * bound
            inputs["hand_force"][1, entry] = np.nextafter(
                inputs["hand_force"][0, entry], sign * np.inf
            )
            status = run(controller, inputs).status
            assert is_good(status[:1]).all() and status[1] == Status.OUT_OF_DOMAIN


def test_more_force_than_there_is_gives_as_much_as_there_is_and_says_so(
    machine: Machine, controller: Controller
) -> None:
    inputs = recorded(machine, controller, 50, seed=9)
    inputs["force"] = [1e3, 0.0]
    outputs = run(controller, inputs)
    assert (outputs.status == Status.INFEASIBLE).all()
    assert (outputs.delivered_force[:, 0] > 0.5 * machine.target.force).all()
    assert outputs.tension.max() <= machine.tension.max * (1 + 4 * eps(outputs))


def pull_back(machine: Machine, controller: Controller, options: int) -> Outputs:
    """A hand at rest that pulls with 5 N, which the observer takes for a disturbance to fight."""
    inputs = recorded(machine, controller, CYCLES, seed=10)
    inputs["lengths"], inputs["rails"] = inputs["lengths"][0], inputs["rails"][0]
    inputs["force"], inputs["hand_force"] = 0.0, [5.0, 0.0]
    inputs["options"] = options
    return run(controller, inputs)


def compensation(machine: Machine, outputs: Outputs) -> NDArray[np.float64]:
    """What the last cycle adds to the torque of the tension [N m]."""
    torque = outputs.motor_torque[-1].astype(float)
    return np.asarray(torque - machine.drum.radius * outputs.tension[-1])


def test_the_compensation_stays_within_the_share_that_is_kept_for_it(
    machine: Machine, controller: Controller
) -> None:
    outputs = pull_back(machine, controller, options=0)
    share = machine.cable_motor.torque_limit - machine.drum.radius * machine.tension.max
    assert np.abs(outputs.disturbance[-1]).max() > 1.5 * share
    np.testing.assert_allclose(
        np.abs(compensation(machine, outputs)).max(), share, rtol=100 * eps(outputs)
    )


def test_without_compensation_the_disturbance_is_told_but_not_acted_on(
    machine: Machine, controller: Controller
) -> None:
    outputs = pull_back(machine, controller, UNCOMPENSATED)
    assert np.abs(outputs.disturbance[-1]).max() > 0.001
    assert np.abs(compensation(machine, outputs)).max() < 10 * eps(outputs)


def test_a_recording_gives_the_same_bits_cycle_by_cycle(
    machine: Machine, controller: Controller
) -> None:
    inputs = recorded(machine, controller, 50, seed=11)
    together = run(controller, inputs)
    controller.start(inputs["lengths"][0], inputs["rails"][0])
    for cycle, row in enumerate(inputs):
        alone = controller.step(*(row[name] for name in inputs.dtype.names or ()))
        for name, value in alone._asdict().items():
            assert (value == getattr(together, name)[cycle]).all(), (name, cycle)


SWAPPED = {
    "two forces": (
        "real_t wanted_force[TB_DOF];       /* N, walls + application */\n"
        "    real_t delivered_force[TB_DOF];    /* N, what the commanded tensions give */",
        "real_t delivered_force[TB_DOF]; real_t wanted_force[TB_DOF];",
    ),
    "tension and disturbance": (
        "real_t tension[TB_CABLES];         /* N, commanded */\n"
        "    real_t disturbance[TB_CABLES];     /* N m,",
        "real_t disturbance[TB_CABLES]; real_t tension[TB_CABLES]; /*",
    ),
    "two inputs": (
        "real_t force[TB_DOF];        /* N, force on the platform that the application wants */",
        "uint32_t another; real_t force[TB_DOF];",
    ),
}


@pytest.mark.parametrize("name", SWAPPED)
def test_members_are_read_by_their_names_wherever_the_c_puts_them(
    name: str, generated: Generated, controller: Controller, tmp_path: Path
) -> None:
    core = core_with(tmp_path, *SWAPPED[name])
    inputs = recorded(generated.machine, controller, 40, seed=3)
    wanted = run(controller, inputs)
    other = Controller(generated, core)
    moved = other.recording(len(inputs))
    for member in inputs.dtype.names or ():
        moved[member] = inputs[member]
    assert (other.inputs_layout, other.outputs_layout) != (
        controller.inputs_layout,
        controller.outputs_layout,
    )
    assert np.any(wanted.wanted_force != wanted.delivered_force)
    for one, two in zip(wanted, run(other, moved), strict=True):
        assert np.array_equal(one, two)


def test_a_member_that_the_c_no_longer_has_is_named(generated: Generated, tmp_path: Path) -> None:
    core = core_with(tmp_path, "TB_LAYOUT_NUMBERS(outputs, tension)", "")
    with pytest.raises(LayoutError, match=r"^tb_outputs has no member tension$"):
        Controller(generated, core)


def core_with(folder: Path, right: str, wrong: str) -> Path:
    """A copy of the runtime's core with a change in one of its headers."""
    core = folder / "core"
    shutil.copytree(RUNTIME_CORE, core)
    changed = 0
    for path in core.glob("*.h"):
        text = path.read_text()
        changed += text.count(right)
        path.write_text(text.replace(right, wrong))
    assert changed == 1
    return core


Check = Callable[[Machine, Controller], None]

SEEDED: list[tuple[str, str, Check]] = [
    (
        "resume_observer(controller, inputs->lengths);",
        "",
        test_a_reading_lost_in_a_steady_movement_changes_no_speed,
    ),
    (
        "controller->interrupted = 1;\n        hold_safe",
        "hold_safe",
        test_a_reading_lost_in_a_steady_movement_changes_no_speed,
    ),
    (
        "lengths[i] - (winding_rate * TB_PERIOD)",
        "lengths[i]",
        test_a_reading_lost_in_a_steady_movement_changes_no_speed,
    ),
    (
        "rails[i] - (base[BASE_SPEED] * TB_PERIOD)",
        "rails[i]",
        test_a_reading_lost_in_a_steady_movement_changes_no_speed,
    ),
    (
        "(controller->interrupted != 0) {\n        copy(TB_CABLES",
        "(false) {\n        copy(TB_CABLES",
        test_a_reading_lost_in_a_steady_movement_changes_no_speed,
    ),
    (
        "resume_bases(controller, inputs->rails);",
        "",
        test_a_reading_lost_in_a_steady_movement_changes_no_speed,
    ),
    (
        "if (is_good(status)) {\n        remember",
        "if (true) {\n        remember",
        test_nothing_is_remembered_of_a_failed_cycle,
    ),
    (
        "hold_safe(controller, outputs);",
        "",
        test_a_failed_cycle_keeps_the_cables_just_taut_and_the_carriages_free,
    ),
    (
        "pass_gate(controller, outputs);\n    outputs->status",
        "outputs->status",
        test_torques_go_to_the_minimum_tension_at_the_rate_of_the_gate,
    ),
    (
        "copy(TB_CABLES, outputs->motor_torque, controller->torque);",
        "",
        test_torques_go_to_the_minimum_tension_at_the_rate_of_the_gate,
    ),
    (
        "limit_compensation(outputs->disturbance[i])",
        "outputs->disturbance[i]",
        test_the_compensation_stays_within_the_share_that_is_kept_for_it,
    ),
    (
        "is_believable(hand_force) ? TB_OK : TB_OUT_OF_DOMAIN",
        "is_believable(hand_force) ? TB_OK : TB_OK",
        test_a_force_no_hand_can_have_is_a_broken_sensor,
    ),
]


@pytest.mark.parametrize(("old", "new", "check"), SEEDED)
def test_a_seeded_defect_of_the_step_is_found(
    tmp_path: Path, old: str, new: str, check: Check
) -> None:
    generated = committed("yoon2023", "double")
    core = with_defect(tmp_path, old, new)
    with pytest.raises(AssertionError):
        check(generated.machine, Controller(generated, core))
