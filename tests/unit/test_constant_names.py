"""Numbers of the machine file stand in the generated C under their names, told by meaning."""

import re
from collections.abc import Iterator
from functools import cache

import pytest
from unmeasured import machine_named

from turnbuckle.codegen.accuracy import Accuracy
from turnbuckle.codegen.constant_names import ConstantNames, every, every_group
from turnbuckle.codegen.generate import render
from turnbuckle.codegen.ir import Routine
from turnbuckle.codegen.model import build_model
from turnbuckle.codegen.print_c import Printer
from turnbuckle.codegen.varied import varied
from turnbuckle.model.machine import Machine

MACHINES = ["yoon2023", "planar_rigid", "brau_triangle"]


def printed(machine: Machine) -> dict[str, str]:
    """The generated files of a machine, unmeasured."""
    model = build_model(machine)
    return render(model, {item.function.name: Accuracy() for item in model.items()})


def with_tensions(machine: Machine, low: float, high: float) -> Machine:
    """The machine with other bounds of the tensions [N]."""
    tension = machine.tension.model_copy(update={"min": low, "max": high})
    return machine.model_copy(update={"tension": tension}).read_from(machine.path)


@cache
def stock() -> dict[str, str]:
    """The generated files of a stock machine."""
    return printed(machine_named("yoon2023"))


def lines(printer: Printer) -> Iterator[str]:
    """All that is printed of a routine."""
    yield from printer.body()
    yield from (value for group in printer.results() for value in group)


@pytest.mark.parametrize("name", MACHINES)
def test_with_numbers_for_the_names_the_c_is_the_same(name: str) -> None:
    machine = machine_named(name)
    model = build_model(machine)
    names = ConstantNames(model)
    numbers = {each.name: each.text for group in every_group(machine) for each in group}
    routines = [item for item in every(model.items()) if isinstance(item, Routine)]
    for routine in routines:
        plain = "\n".join(lines(Printer(routine, {})))
        named = "\n".join(lines(Printer(routine, names.of_places(routine))))
        back = re.sub(r"\bTB_\w+", lambda found: numbers.get(found[0], found[0]), named)
        back = re.sub(r"-\(-(TB_C\([^)]+\))\)", r"\1", back)
        back = re.sub(r"\((-TB_C\([^)]+\))\)", r"\1", back)
        assert re.sub(r"\s", "", back) == re.sub(r"\s", "", plain), routine.function.name


def test_a_number_that_only_equals_a_tension_keeps_its_digits() -> None:
    """Three times a rounding error is no tension of 3 N."""
    left = re.findall(r".*TB_C\((?:3|10)\.0\).*", stock()["tb_tension.c"])
    assert left
    assert all("TB_EPSILON" in line for line in left)
    other = printed(with_tensions(machine_named("yoon2023"), 2.5, 11.0))
    assert re.findall(r".*TB_C\((?:3|10)\.0\).*", other["tb_tension.c"]) == left


@pytest.mark.parametrize("low", [1.0, 5.0])
def test_the_least_tension_has_its_name_whatever_it_equals(low: float) -> None:
    """One is a factor that vanishes, five is what the walls damp with."""
    machine = with_tensions(machine_named("yoon2023"), low, 10.0)
    text = printed(machine)["tb_tension.c"]
    assert "tension_0 = tb_min(tb_max(t61 - t22, TB_TENSION_MIN), TB_TENSION_MAX)" in text


def test_equal_keys_keep_their_own_names() -> None:
    """Both walls damp with 5 N s/m; the drum has 5 mm."""
    text = " ".join(stock()["tb_control.c"].split())
    assert "TB_WALL_1_DAMPING * velocity[0]" in text
    assert "TB_WALL_2_DAMPING * velocity[1]" in text


def test_no_number_of_the_machine_file_is_left_in_the_control_laws() -> None:
    text = stock()["tb_control.c"]
    bodies = re.sub(r"if \(!\((?:[^{])*\{", "", text)
    assert set(re.findall(r"TB_C\(([^)]+)\)", bodies)) <= {"0.0", "1.0", "1e-06", "4096.0"} | {
        "1000000000.0"
    }


@pytest.mark.parametrize("name", MACHINES)
def test_a_varied_machine_differs_in_every_number_and_by_little(name: str) -> None:
    machine = machine_named(name)
    before, after = (list(numbers(each.model_dump())) for each in (machine, varied(machine)))
    assert len(before) == len(after)
    for old, new in zip(before, after, strict=True):
        assert new == pytest.approx(old, rel=1e-6)
        assert new != old or old in (0.0, 1.0, -1.0)


def numbers(value: object) -> Iterator[float]:
    """All floats within."""
    if isinstance(value, float):
        yield value
    elif isinstance(value, dict):
        for entry in value.values():
            yield from numbers(entry)
    elif isinstance(value, tuple | list):
        for entry in value:
            yield from numbers(entry)
