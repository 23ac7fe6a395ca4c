"""Whatever the drives report, no order is beyond its limits or changes faster than it may."""

import ctypes
import math
from collections.abc import Callable

import pytest
import supervised
from hypothesis import given, settings
from hypothesis import strategies as st
from safety_table import constants
from supervised import CABLES, DRIVES, Goal, Machine, Moments, Observation, Orders, Power

NUMBERS = constants(supervised.STOCK)
NOT_NUMBERS = [math.nan, math.inf, -math.inf, 1e300, -1e300, 1e9, -5.0, 0.0, 0.7]

REALS = st.sampled_from(NOT_NUMBERS) | st.floats()
BYTES = st.integers(0, 6) | st.integers(0, 255)
SPOILED = st.fixed_dictionaries(
    {},
    optional={
        "position": REALS,
        "torque": REALS,
        "power": BYTES,
        "mode": BYTES,
        "homing": BYTES,
        "fresh": st.integers(0, 1),
        "age": st.integers(0, 3),
        "missed": BYTES,
        "late": st.integers(0, 4),
        "silent": st.integers(0, 1),
        "task": BYTES,
        "progress": BYTES,
        "failure": BYTES,
        "error_class": BYTES,
    },
)
CYCLE = st.fixed_dictionaries(
    {"drive": st.integers(0, DRIVES - 1), "report": SPOILED},
    optional={
        "force": REALS,
        "hand_force": REALS,
        "requests": st.integers(0, 7),
        "missed": st.integers(0, 4) | st.integers(0, 2**32 - 1),
        "bus": BYTES,
    },
)
CYCLES = st.lists(CYCLE, min_size=1, max_size=12)


@pytest.fixture(scope="module", params=supervised.LIBRARIES)
def moments(request: pytest.FixtureRequest) -> tuple[Machine, Moments]:
    return supervised.moments(request.param)


def spoil_with(cycle: dict[str, object]) -> Callable[[Observation], None]:
    """What a generated cycle does to an observation."""

    def spoil(seen: Observation) -> None:
        index: int = cycle["drive"]  # type: ignore[assignment]
        for name, value in cycle["report"].items():  # type: ignore[attr-defined]
            setattr(seen.drives[index], name, value)
        for name in ("force", "hand_force"):
            if name in cycle:
                getattr(seen, name)[0] = cycle[name]
        seen.requests = cycle.get("requests", 0)
        seen.missed = cycle.get("missed", 0)
        seen.buses[index % supervised.BUSES].state = cycle.get("bus", 0)

    return spoil


def setpoints(orders: Orders) -> list[tuple[float, float]]:
    """Torque and position of every drive."""
    return [(order.torque, order.position) for order in orders.drives]


def beyond(machine: Machine, before: list[tuple[float, float]], seen: Observation) -> list[str]:
    """What is wrong with the orders."""
    found = []
    for index, order in enumerate(machine.orders.drives):
        is_cable = index < CABLES
        low, high = (0.0, NUMBERS["TB_TORQUE_LIMIT"]) if is_cable else base_limits()
        step = NUMBERS["TB_TORQUE_STEP" if is_cable else "TB_RAIL_TORQUE_STEP"]
        enabled = seen.drives[index].power == Power.ENABLED
        length = 0.0 if is_cable else float(supervised.LENGTHS[index - CABLES])
        move = NUMBERS["TB_RAIL_SPEED_LIMIT"] * supervised.PERIOD
        promises = {
            "torque within limits": low <= order.torque <= high,
            "torque within rate": abs(order.torque - before[index][0]) <= step * (1 + 1e-9)
            or (order.torque == 0.0 and not enabled),
            "no torque without power": enabled or order.torque == 0.0,
            "position on the rail": 0.0 <= order.position <= length,
            "position within rate": abs(order.position - before[index][1]) <= move * (1 + 1e-9)
            or not enabled,
            "a goal": order.goal in list(Goal),
        }
        found += [f"drive {index}: {name}" for name, kept in promises.items() if not kept]
    return found


def base_limits() -> tuple[float, float]:
    """Of a base's torque [N m]."""
    limit = NUMBERS["TB_RAIL_TORQUE_LIMIT"]
    return -limit, limit


@settings(max_examples=100)
@given(data=st.data())
def test_no_order_is_ever_beyond_its_limits(
    moments: tuple[Machine, Moments], data: st.DataObject
) -> None:
    machine, saved = moments
    moment = data.draw(st.sampled_from(sorted(saved)))
    machine.restore(saved[moment])
    for cycle in data.draw(CYCLES):
        before = setpoints(machine.orders)
        machine.step(spoil_with(cycle))
        assert beyond(machine, before, machine.seen) == []
        controller = machine.orders.controller
        numbers = [*controller.pose, *controller.motor_torque, *machine.orders.slack]
        assert all(map(math.isfinite, numbers))


def test_an_order_beyond_its_limits_would_be_noticed(moments: tuple[Machine, Moments]) -> None:
    machine, saved = moments
    machine.restore(saved["RUN NONE"])
    machine.step()
    before = setpoints(machine.orders)
    machine.orders.drives[0].torque = 0.06
    machine.orders.drives[5].position = math.nan
    found = beyond(machine, before, machine.seen)
    assert "drive 0: torque within limits" in found
    assert "drive 5: position on the rail" in found


@pytest.mark.parametrize(
    ("command", "torque", "flags"), [(math.nan, 0.015, 1), (-1.0, 0.0, 2), (0.06, 0.055, 4)]
)
def test_the_gate_of_the_supervisor_refuses_what_no_state_asks_for(
    moments: tuple[Machine, Moments], command: float, torque: float, flags: int
) -> None:
    gate = moments[0].library.tb_torque_gate
    gate.argtypes = [ctypes.c_double, ctypes.c_double, ctypes.POINTER(ctypes.c_double)]
    let_through = ctypes.c_double()
    previous = 0.01 if torque < 0.02 else 0.05
    assert gate(previous, command, ctypes.byref(let_through)) == flags
    assert let_through.value == pytest.approx(torque)


def test_the_same_observations_give_the_same_orders_to_the_bit(
    moments: tuple[Machine, Moments],
) -> None:
    machine, saved = moments
    told = []
    for _ in range(2):
        machine.restore(saved["HOME SWEEP"])
        told.append([bytes(machine.step()) for _ in range(3500)])
    assert told[0] == told[1]
