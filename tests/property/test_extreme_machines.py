"""However large or small its numbers, a machine is refused by key or what follows is finite."""

import re
import tomllib
from collections.abc import Iterator
from copy import deepcopy
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from turnbuckle.codegen.bus.dbc import dbc_files
from turnbuckle.codegen.bus.drives import drive_fields
from turnbuckle.codegen.constants import Constant, constants
from turnbuckle.model.bus.axis import axes
from turnbuckle.model.bus.contract import Object, contract, identity
from turnbuckle.model.machine import Machine
from turnbuckle.model.problem import MachineError, key_path
from turnbuckle.model.reading import load_machine, machine_from
from turnbuckle.model.units import QuantityError, Written, unit, written

MACHINES = Path(__file__).parents[2] / "machines"
NAMES = ["yoon2023", "spidar_g"]
LARGEST_COUNT = 0x7FFF_FFFF
Place = tuple[str | int, ...]
SUPERVISION = {
    "heartbeat": "10 ms",
    "drive_heartbeat": "20 ms",
    "answer_delay": "40 us",
    "compute_time": "100 us",
    "answer_timeout": "0.5 s",
    "homing_timeout": "20 s",
    "closure_limit": "2 mm",
    "rail_torque_rate": "200 N*m/s",
}


@cache
def tables(name: str) -> dict[str, Any]:
    content = tomllib.loads((MACHINES / f"{name}.toml").read_text(encoding="utf-8"))
    return {**content, "supervision": SUPERVISION}


def quantities(value: Any, here: Place = ()) -> Iterator[tuple[Place, Written]]:
    """Every quantity of a file and where it is."""
    if isinstance(value, dict | list):
        for key in value if isinstance(value, dict) else range(len(value)):
            yield from quantities(value[key], (*here, key))
    elif isinstance(value, str):
        try:
            quantity = written(value)
            unit(quantity.unit)
        except QuantityError:
            return
        yield here, quantity


SCALES = st.integers(-14, 14).map(lambda k: f"e{k}") | st.sampled_from(["e-330", "e-310", "e300"])
CHANGES = {
    name: st.dictionaries(
        st.sampled_from([key_path(place) for place, _ in quantities(tables(name))]),
        SCALES | st.just("zero"),
        min_size=1,
        max_size=4,
    )
    for name in NAMES
}


def changed(name: str, changes: dict[str, str]) -> Machine:
    """The machine with quantities scaled by powers of ten, or zero."""
    content = deepcopy(tables(name))
    for place, quantity in quantities(tables(name)):
        scale = changes.get(key_path(place))
        if scale is not None:
            within: Any = content
            for part in place[:-1]:
                within = within[part]
            number = "0" if scale == "zero" else f"{quantity.number:f}{scale}"
            within[place[-1]] = f"{number} {quantity.unit}"
    return machine_from(content, MACHINES / f"{name}.toml")


def reals(printed: Any) -> Iterator[float]:
    """Every number of type real_t in what is printed as C."""
    if isinstance(printed, str):
        yield from (float(digits) for digits in re.findall(r"TB_C\(([^)]*)\)", printed))
    elif isinstance(printed, Constant):
        yield from reals(printed.text)
    elif isinstance(printed, dict | list | tuple):
        for part in printed.values() if isinstance(printed, dict) else printed:
            yield from reals(part)


def counts(groups: Any) -> Iterator[int]:
    """Every whole number among constants."""
    for _, group in groups:
        yield from (int(constant.text) for constant in group if constant.text.isdigit())


def fits(entry: Object) -> bool:
    """Whether an object of a drive can hold its value."""
    span = 1 << 8 * entry.size
    return -span // 2 <= entry.value < span


def assert_finite(machine: Machine) -> None:
    """All that a machine's constants are derived to is finite and no rounding of zero."""
    fields: dict[str, Any] = drive_fields(machine)
    values = [*reals(constants(machine)), *reals(fields["groups"]), *reals(fields["drives"])]
    for value in values:
        assert np.isfinite(np.float32(value)), value
        assert value == 0 or abs(value) > np.finfo(np.float32).tiny, value
    assert max(counts(fields["groups"])) <= LARGEST_COUNT
    for axis in axes(machine):
        assert all(map(fits, [*identity(axis), *contract(machine, axis)]))
    for words in (str(machine.describe()), *dbc_files(machine).values()):
        assert not re.search(r"\b(inf|nan)\b", words)


RATING = "cable_motor.rating"


@pytest.mark.parametrize("name", NAMES)
@settings(max_examples=60, deadline=None)
@given(data=st.data())
def test_a_machine_of_any_size_is_refused_by_key_or_all_its_constants_are_finite(
    name: str, data: st.DataObject
) -> None:
    try:
        machine = changed(name, data.draw(CHANGES[name]))
    except MachineError as error:
        assert all(problem.key for problem in error.problems)
        assert "Traceback" not in str(error)
    else:
        assert_finite(machine)


def test_the_machines_as_they_are_have_finite_constants() -> None:
    for name in NAMES:
        assert_finite(load_machine(MACHINES / f"{name}.toml"))


@pytest.mark.parametrize(
    ("changes", "key"),
    [
        ({f"{RATING}.torque_constant": "e-7"}, f"{RATING}.torque_constant"),
        ({f"{RATING}.nominal_current": "e-3", f"{RATING}.torque_constant": "e-4"}, RATING),
        ({"rail_drive.homing.speed": "e-3"}, "rail_drive.homing.speed"),
        ({"supervision.answer_delay": "e6"}, "supervision.answer_delay"),
        ({"control.rate": "e6"}, "control.rate"),
        ({"control.rate": "e-5"}, "bus[1].rate"),
        ({"cable[1].rail.to[1]": "e-330"}, "cable[1].rail.to[1]"),
        ({"cable[1].rail.to[1]": "e-5"}, "cable[1].rail.to"),
        ({"tension.max": "e300"}, "tension.max"),
    ],
)
def test_a_number_that_leads_to_none_is_refused_by_its_key(
    changes: dict[str, str], key: str
) -> None:
    with pytest.raises(MachineError) as caught:
        changed("yoon2023", changes)
    assert key in [problem.key for problem in caught.value.problems]
