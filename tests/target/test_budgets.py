"""What the stock machines cost a Cortex-M4F stays within the budgets that are committed."""

import re
from functools import cache

import pytest
from runtime_copy import seeded_copy

from turnbuckle.lab.budgets.__main__ import main
from turnbuckle.lab.budgets.budget import (
    TOLERANCE,
    UNITS,
    Budget,
    committed,
    of_counts,
    of_image,
)
from turnbuckle.lab.budgets.cycle import COUNTED, GROUPS, Counts
from turnbuckle.lab.budgets.image import Image, bare_image
from turnbuckle.lab.budgets.measure import GENERATED, counts_of, machines
from turnbuckle.lab.budgets.stack import (
    BY_MEMBER,
    Graph,
    StackError,
    add_library,
    deepest,
    graph_of,
    pushed,
)
from turnbuckle.lab.budgets.table import PAGE, with_table

BROUGHT_UP = ["yoon2023", "yoon_fixed_diagonal"]
"""Machines that come to RUN in seconds; `make soak` counts the cycles of the others too."""
LOOP = (
    "core/master.c",
    "master->fieldbus->protocol->sync(master->fieldbus);",
    """for (volatile int i = 0; i < 60; i++) { /* about 400 instructions */
    }
    master->fieldbus->protocol->sync(master->fieldbus);""",
)
LOCKSTEP = 128
"""Bytes of stack that the lockstep's own functions take, at most."""


def budget_of(machine: str) -> Budget:
    """The committed budget of a machine."""
    (found,) = (each for each in committed() if each.machine == machine)
    return found


@cache
def counts(machine: str) -> Counts:
    """Instructions of a machine's cycles, counted once."""
    return counts_of(machine)


@cache
def image(machine: str) -> Image:
    """A machine's image, linked once."""
    return bare_image(GENERATED / machine)


@pytest.mark.parametrize("machine", machines())
def test_flash_memory_and_stack_are_within_their_budgets(machine: str) -> None:
    assert budget_of(machine).complaints(of_image(image(machine))) == []


@pytest.mark.parametrize("machine", BROUGHT_UP)
def test_instructions_of_a_cycle_and_of_its_step_are_within_their_budgets(machine: str) -> None:
    counted = counts(machine)
    assert len(counted.cycles) == GROUPS * COUNTED
    assert budget_of(machine).complaints(of_counts(counted)) == []
    assert sum(counted.by_function.values()) == sum(counted.cycles)
    assert all(step < cycle / 2 for step, cycle in zip(counted.steps, counted.cycles, strict=True))


def test_no_cycle_has_taken_more_stack_than_the_call_graph_allows() -> None:
    graph = graph_of(image("yoon2023").graphs)
    add_library(graph, image("yoon2023"))
    depth, way = deepest(graph, "tb_master_run")
    assert depth <= counts("yoon2023").stack <= depth + LOCKSTEP, way


def test_every_machine_with_buses_has_a_budget_with_every_figure() -> None:
    assert [each.machine for each in committed()] == machines()
    for each in committed():
        assert list(each.figures) == list(UNITS)
        assert each.path.read_text() == each.text()


@pytest.mark.parametrize("name", UNITS)
@pytest.mark.parametrize("change", [1 + TOLERANCE, 1 - TOLERANCE])
def test_a_figure_that_is_off_either_way_is_told(name: str, change: float) -> None:
    budget = budget_of("yoon2023")
    right = budget.figures[name]
    outward = 1 if change > 1 else -1
    assert budget.complaints(dict(budget.figures)) == []
    assert budget.complaints({name: round(right * change) - outward}) == []
    (told,) = budget.complaints({name: round(right * change) + outward})
    assert re.match(rf"docs/budgets/yoon2023.json: {name}: found \d+ \w+; allowed: {right} ", told)


def test_a_cycle_with_a_loop_more_is_off_its_budget() -> None:
    folders = seeded_copy(GENERATED.parent / "build" / "seeded" / "loop_in_sync", LOOP)
    figures = of_counts(counts_of("yoon_fixed_diagonal", folders))
    told = budget_of("yoon_fixed_diagonal").complaints(figures)
    assert [each.split(": ")[1] for each in told] == ["cycle_mean", "cycle_most"]


def test_a_machine_that_is_none_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit, match="2"):
        main(["nobody"])
    assert "found nobody; allowed: spidar_g, yoon2023" in capsys.readouterr().err


def test_more_code_and_a_larger_frame_are_off_their_budgets() -> None:
    """The compiler is told to go without some of its optimisations."""
    figures = of_image(bare_image(GENERATED / "yoon_fixed_diagonal", "-fno-inline", "-O1"))
    told = budget_of("yoon_fixed_diagonal").complaints(figures)
    assert any(" flash: " in each for each in told)
    assert any(" stack: " in each for each in told)


def test_the_readme_has_the_table_of_the_budgets() -> None:
    page = PAGE.read_text()
    assert page == with_table(page, committed())
    for each in committed():
        assert f"| `{each.machine}` |" in page


def without(member: str) -> dict[str, list[str]]:
    """The table of calls through pointers without a member."""
    return {name: list(names) for name, names in BY_MEMBER.items() if name != member}


def refused(graphs: tuple[str, ...], by_member: dict[str, list[str]], said: str) -> None:
    """What the table lacks, or has too much, is told."""
    with pytest.raises(StackError, match=said):
        graph_of(graphs, by_member)


def test_a_call_through_a_pointer_that_the_table_lacks_is_refused() -> None:
    graphs = image("yoon2023").graphs
    refused(graphs, without("dispatch"), r"master.c:\d+: a call through a pointer is not in the t")
    refused(graphs, without("close"), "called through pointers, not in the table: .*close_port")
    more = {**without(""), "send": [*BY_MEMBER["send"], "slcan.c:send_frame"]}
    refused(graphs, more, "no function: slcan.c:send_frame")


def test_a_recursion_is_refused() -> None:
    graph = Graph({"a": 8, "b": 16, "c": 0}, {"a": {"b"}, "b": {"c"}})
    assert deepest(graph, "a") == (24, ["a", "b", "c"])
    graph.calls["c"] = {"a"}
    with pytest.raises(StackError, match="a calls itself, by way of a, b, c"):
        deepest(graph, "a")


def test_a_stack_whose_size_is_known_at_run_time_only_is_refused() -> None:
    node = 'node: {{ title: "f" label: "f\\nx.c:1:1\\n32 bytes ({})" }}'
    assert graph_of([node.format("static")], {}).own == {"f": 32}
    with pytest.raises(StackError, match="f has a stack whose size is dynamic"):
        graph_of([node.format("dynamic")], {})


@pytest.mark.parametrize(
    ("instruction", "size"),
    [
        ("push\t{r4, r5, lr}", 12),
        ("stmdb\tsp!, {r4, r5, r6, r7, r8, r9, sl, lr}", 32),
        ("strd\tip, lr, [sp, #-16]!", 16),
        ("sub\tsp, #24", 24),
        ("sub.w\tsp, sp, #520\t@ 0x208", 520),
        ("vpush\t{d8-d15}", 64),
        ("sub.w\tip, sp, #8", 0),
        ("ldmia.w\tsp!, {r4, pc}", 0),
    ],
)
def test_what_an_instruction_takes_of_the_stack_is_known(instruction: str, size: int) -> None:
    assert pushed(f"   10be0:\te92d 47f0 \t{instruction}") == size
