"""The phases of a cycle on the stock machine's buses; what is said of a bus that cannot work."""

import re
import tomllib
from collections.abc import Callable
from copy import deepcopy
from pathlib import Path
from typing import Any

import pytest

from turnbuckle.model.bus.plan import BusPlan, bus_plans, compute_phase, loads, timing
from turnbuckle.model.machine import Machine
from turnbuckle.model.problem import MachineError
from turnbuckle.model.reading import load_machine, machine_from

STOCK = Path(__file__).parents[2] / "machines" / "yoon2023.toml"
TABLES = tomllib.loads(STOCK.read_text())
MICROSECOND = 1e-6
Edit = Callable[[dict[str, Any]], object]


@pytest.fixture(scope="module")
def plans() -> dict[str, BusPlan]:
    return {plan.load.name: plan for plan in bus_plans(load_machine(STOCK))}


def edited(*edits: Edit) -> Machine:
    tables = deepcopy(TABLES)
    for edit in edits:
        edit(tables)
    return machine_from(tables, STOCK)


def refusal(*edits: Edit) -> str:
    with pytest.raises(MachineError) as caught:
        edited(*edits)
    return str(caught.value)


def bus(number: int, **keys: object) -> Edit:
    return lambda tables: tables["bus"][number].update(keys)


def supervision(**keys: object) -> Edit:
    return lambda tables: tables.update(supervision=keys)


def test_cables_answer_in_the_cycle_and_are_commanded_before_the_next(
    plans: dict[str, BusPlan],
) -> None:
    phases = plans["cable1"].phases
    # One foreign frame, SYNC, 40 us of the drives, two answers; 100 us; one foreign, two commands.
    assert phases.answers == pytest.approx((135 + 55 + 40 + 2 * 135) * MICROSECOND)
    assert phases.compute == pytest.approx(500 * MICROSECOND)
    assert phases.commands == pytest.approx((500 + 100 + 135 + 2 * 95) * MICROSECOND)
    assert phases.room == pytest.approx(75 * MICROSECOND)


def test_bases_answer_until_the_last_cycle_before_their_next_sync(
    plans: dict[str, BusPlan],
) -> None:
    phases = plans["base"].phases
    assert phases.answers == pytest.approx((135 + 55 + 40 + 4 * 135) * MICROSECOND)
    assert phases.compute < phases.answers < phases.compute + 1000 * MICROSECOND
    assert phases.commands == pytest.approx(phases.answers + (135 + 4 * 95) * MICROSECOND)


def test_every_frame_of_the_stock_machine_is_in_time(plans: dict[str, BusPlan]) -> None:
    assert all(plan.fits for plan in plans.values())
    worst = {row.message.name: row.response for row in plans["cable1"].rows}
    assert worst["cable_2 command"] == pytest.approx(920 * MICROSECOND)
    assert worst["cable_2 answer"] == pytest.approx((730 + 40) * MICROSECOND)


def test_the_compute_phase_is_that_of_the_slowest_answers_due_in_a_cycle() -> None:
    machine = edited(supervision(answer_delay="60 us"))
    assert compute_phase(loads(machine), timing(machine)) == pytest.approx(520 * MICROSECOND)
    only_bases = [load for load in loads(machine) if load.name == "base"]
    assert compute_phase(only_bases, timing(machine)) == 0


def test_four_drives_at_1_khz_are_refused_with_numbers_and_ways_out() -> None:
    message = refusal(bus(2, rate="1 kHz"))
    assert "bus[3]" in message
    assert '"base" with 4 drives, too much for 1000 kbit/s' in message
    assert "97.5% of its time" in message
    assert "2 buses at 1000 Hz with at most 2 drives each, or a rate of 500 Hz" in message
    assert "more problem" not in message


@pytest.mark.parametrize(
    ("edits", "number"),
    [
        ([bus(2, rate="1 kHz")], 2),
        ([bus(0, bit_rate="500 kbit/s")], 0),
        ([bus(2, bit_rate="500 kbit/s")], 2),
        ([supervision(compute_time="300 us")], 0),
    ],
)
def test_the_rate_that_is_offered_fits(edits: list[Edit], number: int) -> None:
    rate = re.search(r"a rate of ([0-9.]+ Hz)", refusal(*edits))
    assert rate is not None
    same = [i for i in (0, 1) if number < 2] or [number]
    edited(*edits, *(bus(i, rate=rate[1]) for i in same))


def test_the_bit_rate_that_is_offered_fits() -> None:
    rate = re.search(r"a bit_rate of ([0-9]+ kbit/s)", refusal(bus(0, bit_rate="500 kbit/s")))
    assert rate is not None
    edited(bus(0, bit_rate=rate[1]))


def split(tables: dict[str, Any]) -> None:
    """Move the last two bases to a bus of their own."""
    tables["bus"].append({**tables["bus"][2], "name": "more"})
    for drive in tables["drive"][-2:]:
        drive["bus"] = "more"


def test_the_number_of_drives_that_is_offered_fits() -> None:
    edited(bus(2, rate="1 kHz"), split)


def test_a_cycle_too_short_to_compute_in_is_refused_though_no_frame_is_lost() -> None:
    message = refusal(supervision(compute_time="300 us"))
    assert "and a cycle 125 us more than there are" in message


def other(*frames: tuple[int, int, str]) -> Edit:
    """A node with frames of an identifier, a length and a period, on the first bus."""
    sent = [{"id": id, "length": length, "period": period} for id, length, period in frames]
    return lambda tables: tables.update(
        node=[{"name": "io", "bus": "cable1", "node": 9, "heartbeat": "50 ms", "frames": sent}]
    )


def test_frames_of_other_nodes_take_their_time() -> None:
    machine = edited(supervision(compute_time="20 us"), other((0x690, 0, "10 ms")))
    phases = bus_plans(machine)[0].phases
    # As above, and one frame of 55 us more in each phase.
    assert phases.answers == pytest.approx((135 + 55 + 55 + 40 + 2 * 135) * MICROSECOND)
    assert compute_phase(loads(machine), timing(machine)) == pytest.approx(555 * MICROSECOND)
    assert phases.commands == pytest.approx((555 + 20 + 135 + 55 + 2 * 95) * MICROSECOND)


def test_a_node_that_only_beats_has_room_on_every_bus() -> None:
    plan = bus_plans(edited(other()))[0]
    assert plan.fits
    assert plan.phases == bus_plans(load_machine(STOCK))[0].phases


def test_what_other_nodes_send_is_in_the_proof() -> None:
    edits = bus(0, rate="500 Hz"), bus(1, rate="500 Hz")
    machine = edited(*edits, other((0x190, 0, "100 ms"), (0x010, 1, "200 ms")))
    rows = {row.message.identifier: row for row in bus_plans(machine)[0].rows}
    sent = (0x190, 0x010, 0x709)
    assert [rows[id].message.size for id in sent] == [0, 1, 1]
    assert [rows[id].period for id in sent] == pytest.approx([0.1, 0.2, 0.05])
    before = {row.message.identifier: row for row in bus_plans(edited(*edits))[0].rows}
    assert all(rows[id].response >= row.response for id, row in before.items())
    assert rows[0x202].response > before[0x202].response


def test_a_frame_in_every_cycle_is_refused_where_there_is_no_time_for_it() -> None:
    assert '"cable1" with 2 drives and io, too much' in refusal(other((0x190, 8, "1 ms")))


def test_a_bus_without_a_way_out_says_so() -> None:
    message = refusal(supervision(answer_delay="30 ms"))
    assert "another way to spread the drives over buses" in message
