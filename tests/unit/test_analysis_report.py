"""Findings in words, as JSON and in Markdown; two machines side by side."""

import json
from pathlib import Path

import pytest

from turnbuckle.lab.analysis.analyze import find
from turnbuckle.lab.analysis.compare import changed_keys, compare
from turnbuckle.lab.analysis.figures import Figure, Findings, figures
from turnbuckle.lab.analysis.quantities import lag_quantity, quantities
from turnbuckle.lab.analysis.report import as_json, as_markdown, rows, verdict
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine
from turnbuckle.model.workspace.words import percent

ROOT = Path(__file__).parents[2]
LAG = 0.02


def stock(name: str) -> Machine:
    """A machine of the repository."""
    return load_machine(ROOT / "machines" / f"{name}.toml")


def edited(folder: Path, name: str, *changes: tuple[str, str]) -> Machine:
    """A machine of the repository with some of its text changed."""
    text = (ROOT / "machines" / f"{name}.toml").read_text()
    for before, after in changes:
        assert before in text
        text = text.replace(before, after)
    path = folder / f"{name}.toml"
    path.write_text(text)
    return load_machine(path)


@pytest.fixture(scope="module")
def square() -> Findings:
    """A machine that serves its target, with a tension capable workspace in closed form."""
    return find(stock("brau_square"), LAG)


@pytest.fixture(scope="module")
def diagonal() -> Findings:
    """A machine that does not."""
    return find(stock("yoon_fixed_diagonal"), LAG)


def test_the_verdict_of_a_good_machine(square: Findings) -> None:
    words = verdict(square)
    assert words.startswith("Yes: 5 N in every direction in all of the target (101 x 101 poses")
    assert "31.25 mN m" in words
    assert "55 mN m are enough" in words
    assert "63.77%" in words


def test_the_verdict_of_a_bad_machine(diagonal: Findings) -> None:
    words = verdict(diagonal)
    assert words.startswith("No: 2 N in every direction in 39.7 % of the target")
    assert "nothing is possible" in words
    assert "no motor is strong enough" in words.lower()


def test_a_weak_motor_is_told_from_a_bad_geometry(tmp_path: Path) -> None:
    machine = edited(tmp_path, "brau_square", ('max = "10 N"', 'max = "6 N"'))
    words = verdict(find(machine, LAG))
    assert words.startswith("No: 5 N in every direction in ")
    assert "It takes a tension of 6.25 N" in words
    assert "tension.max = 6 N is too low" in words


def test_the_numbers_are_the_same_bytes_twice(diagonal: Findings) -> None:
    again = find(stock("yoon_fixed_diagonal"), LAG)
    assert as_json(again, ["a.png"]) == as_json(diagonal, ["a.png"])
    maps = quantities(diagonal.machine)
    assert as_markdown(again, maps) == as_markdown(diagonal, maps)


def test_the_json_holds_no_number_that_json_has_not(diagonal: Findings) -> None:
    def refuse(constant: str) -> None:
        raise AssertionError(constant)

    content = json.loads(as_json(diagonal, []), parse_constant=refuse)
    assert content["numbers"]["torque_needed"] is None
    assert content["numbers"]["target_share_zero_wrench"] == 3425 / 5757
    assert content["passed"] is False


def test_every_machine_has_the_same_numbers(square: Findings, diagonal: Findings) -> None:
    keys = [[figure.key for figure in figures(f.machine)] for f in (square, diagonal)]
    assert keys[0] == keys[1]
    assert len(set(keys[0])) == len(keys[0])


def test_the_report_shows_every_map_once_and_every_number(square: Findings) -> None:
    maps = [*quantities(square.machine), lag_quantity(square.machine, LAG)]
    text = as_markdown(square, maps)
    for quantity in maps:
        assert text.count(f"({quantity.name}.png)") == 1
    for label, value in rows(square):
        assert f"| {label} | {value} |" in text


def test_an_undefined_tension_factor_is_told_with_its_reason(square: Findings) -> None:
    assert ("least tension factor", "not defined: T_min = 0") in rows(square)


@pytest.mark.parametrize(
    ("share", "words"),
    [
        (0.0, "0 %"),
        (1e-5, "less than 0.1 %"),
        (0.59493, "59.5 %"),
        (0.99999, "more than 99.9 %"),
        (1.0, "100 %"),
    ],
)
def test_all_and_nothing_are_said_only_where_it_is_so(share: float, words: str) -> None:
    assert percent(share) == words


@pytest.mark.parametrize(
    ("before", "after", "words"),
    [
        (1.0, 1.5, "+0.5 N"),
        (1.5, 1.0, "-0.5 N"),
        (1.0, 1.0 + 1e-12, "="),
        (1.0, float("inf"), "changed"),
        (float("inf"), float("inf"), ""),
        (float("nan"), 1.0, "changed"),
    ],
)
def test_a_change_has_its_sign(before: float, after: float, words: str) -> None:
    assert Figure("key", "words", lambda _: 0.0, "N").change(before, after) == words


def test_a_changed_key_is_shown_as_both_files_write_it(tmp_path: Path) -> None:
    other = edited(tmp_path, "brau_square", ('max = "10 N"', 'max = "9000 mN"'))
    assert changed_keys(stock("brau_square"), other) == [("tension.max", '"10 N"', '"9000 mN"')]


def test_other_words_for_the_same_machine_are_no_change(tmp_path: Path) -> None:
    other = edited(
        tmp_path,
        "brau_square",
        ('name = "brau_square"', 'name = "mine"'),
        ('max = "10 N"', 'max = "10000 mN"'),
        ('base = ["0 m", "0 m"]', 'base = ["0 mm", "0 mm"]\ndrive = "cable_1"'),
    )
    assert changed_keys(stock("brau_square"), other) == []


def test_a_key_that_only_one_file_has_is_a_change(tmp_path: Path) -> None:
    table = '[pulley]\nradius = "2 mm"\nwinds = "left"\n\n[target]'
    other = edited(tmp_path, "brau_square", ("[target]", table))
    changes = changed_keys(stock("brau_square"), other)
    assert ("pulley.radius", "—", '"2 mm"') in changes
    cables = changed_keys(stock("brau_square"), stock("brau_five"))
    assert ("cable[5].base", "—", '["0.5 m", "1 m"]') in cables


def test_what_a_change_did_is_told_with_its_sign(tmp_path: Path) -> None:
    other = edited(tmp_path, "brau_square", ('max = "10 N"', 'max = "8 N"'))
    found = compare((stock("brau_square"), other), None, LAG)
    assert found.names == (str(ROOT / "machines" / "brau_square.toml"), str(other.path))
    by_label = {row[0]: row[1:] for row in found.rows}
    assert by_label["least isotropic force"] == ("8 N", "6.4 N", "-1.6 N")
    assert by_label["target with 5 N"] == ("100 %", "100 %", "=")
