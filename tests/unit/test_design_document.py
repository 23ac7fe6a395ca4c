"""A machine file with other quantities: what describes a machine, and what the new file keeps."""

import difflib
import tomllib
from decimal import Decimal
from pathlib import Path

import pytest

from turnbuckle.lab.design.document import Changes, Document
from turnbuckle.model.problem import MachineError
from turnbuckle.model.reading import load_machine

ROOT = Path(__file__).parents[2]
STOCK = ROOT / "machines" / "yoon2023.toml"
CHANGES: Changes = {
    ("tension", "max"): "9.5 N",
    ("cable", 1, "rail", "to", 1): "400 mm",
    ("frame", "size", 0): "0.8 m",
}


def test_the_new_file_differs_in_the_changed_quantities_only(tmp_path: Path) -> None:
    document = Document.read(STOCK)
    text = document.text_with(CHANGES)
    lines = list(difflib.ndiff(document.text.splitlines(), text.splitlines()))
    changed = [line for line in lines if line.startswith(("- ", "+ "))]
    assert changed == [
        '- size = ["711.8 mm", "461.8 mm"]',
        '+ size = ["0.8 m", "461.8 mm"]',
        '- rail = { from = ["711.8 mm", "0 mm"], to = ["711.8 mm", "461.8 mm"] }',
        '+ rail = { from = ["711.8 mm", "0 mm"], to = ["711.8 mm", "400 mm"] }',
        '- max = "10 N"',
        '+ max = "9.5 N"',
    ]
    path = tmp_path / "new.toml"
    path.write_text(text)
    machine = load_machine(path)
    assert machine.tension.max == 9.5
    assert machine.model_dump() == document.machine(CHANGES).model_dump()


def test_comments_stay_where_they_are_in_any_layout(tmp_path: Path) -> None:
    text = STOCK.read_text().replace(
        'size = ["711.8 mm", "461.8 mm"]\n',
        "size = [ # of the frame\n    '711.8 mm', # width\n    \"461.8 mm\",   # height\n  ]\n",
    )
    path = tmp_path / "machine.toml"
    path.write_bytes(text.replace("\n", "\r\n").encode())
    new = Document.read(path).text_with({("frame", "size", 0): "0.8 m"})
    assert new == path.read_bytes().decode().replace("'711.8 mm'", '"0.8 m"')


def test_spellings_of_data_sheets_and_a_byte_order_mark_are_read(tmp_path: Path) -> None:
    path = tmp_path / "machine.toml"
    text = STOCK.read_text().replace('"21 g*cm^2"', '"2,5 gcm²"')
    path.write_text(text, encoding="utf-8-sig")
    document = Document.read(path)
    assert document.quantity(("cable_motor", "inertia")) == (Decimal("2.5"), "gcm²")
    assert document.text_with({("cable_motor", "inertia"): "3.5 gcm²"}) == text.replace(
        "2,5", "3.5"
    )


def test_comments_keep_their_column() -> None:
    document = Document.read(STOCK)
    text = document.text_with(
        {
            ("drum", "radius"): "123.4567 mm",
            ("target", "centre", 0): "1 m",
            ("plant", "carriage_coulomb_friction"): "a much longer N",
        }
    )
    pairs = zip(document.text.splitlines(), text.splitlines(), strict=True)
    radius, centre, friction = ((old, new) for old, new in pairs if old != new)
    assert radius[0].index("#") == radius[1].index("#")
    assert centre[0].index("#") == centre[1].index("#")
    assert friction[1].endswith(
        '"a much longer N" # chosen: an estimate for a sealed guide and a belt'
    )


@pytest.mark.parametrize(
    "layout",
    [
        'tension.max = "10 N" # a\n[drum]\nradius = "5 mm"\n',
        'tension = { min = "3 N", max = "10 N" }   # a\n',
        '[tension.more]\nx = 1\n[drum]\n[tension]\nmax = "10 N" # a\n',
    ],
)
def test_any_way_to_write_a_table_is_left_as_it_is(layout: str) -> None:
    document = Document(Path("any.toml"), layout, tomllib.loads(layout))
    text = document.text_with({("tension", "max"): "12 N"})
    assert text == layout.replace("10 N", "12 N")


def test_changes_that_make_no_machine_are_told_as_of_that_file() -> None:
    document = Document.read(STOCK)
    with pytest.raises(MachineError) as caught:
        document.machine({("tension", "min"): "12 N"})
    assert str(caught.value).startswith(f'{STOCK}: tension.min: found "12 N"; allowed:')
    assert document.machine({}) == load_machine(STOCK)


def test_the_document_itself_is_never_changed() -> None:
    document = Document.read(STOCK)
    document.machine(CHANGES)
    document.text_with(CHANGES)
    assert document.tables == tomllib.loads(STOCK.read_text())
    assert document.text == STOCK.read_text()


def test_a_bad_file_is_refused_as_everywhere(tmp_path: Path) -> None:
    with pytest.raises(MachineError, match="no such file"):
        Document.read(tmp_path / "none.toml")
