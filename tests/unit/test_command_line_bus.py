"""`turnbuckle bus`: the proof on one screen, as JSON, and what it says where there is none."""

import json
from pathlib import Path

from typer.testing import CliRunner

from turnbuckle.command_line import app

ROOT = Path(__file__).parents[2]
STOCK = ROOT / "machines" / "yoon2023.toml"
SCREEN = 40


def test_the_proof_fits_a_screen() -> None:
    result = CliRunner().invoke(app, ["bus", str(STOCK)], env={"COLUMNS": "80"})
    lines = result.stdout.splitlines()
    assert result.exit_code == 0
    assert len(lines) <= SCREEN
    assert max(map(len, lines)) <= 80
    rows = {line[:26].strip(): line[26:].split() for line in lines}
    assert rows["load, SYNC and PDOs"] == ["51.5%", "51.5%", "48.7%"]
    assert rows["every answer there"] == ["500", "500", "770"]


def test_json_has_every_message_with_its_bound() -> None:
    result = CliRunner().invoke(app, ["bus", str(STOCK), "--json"])
    buses = json.loads(result.stdout)["buses"]
    assert [bus["name"] for bus in buses] == ["cable1", "cable2", "base"]
    assert buses[2]["drives"] == {f"base_{node}": node for node in range(1, 5)}
    assert len(buses[0]["messages"]) == 1 + 2 * 4 + 2 + 1  # SYNC, four a drive, SDO, master
    assert all(m["length"] < m["response"] <= m["deadline"] for m in buses[0]["messages"])


def test_a_machine_without_buses_is_told_how_to_have_one() -> None:
    result = CliRunner().invoke(app, ["bus", str(ROOT / "machines" / "brau_five.toml")])
    assert result.exit_code == 0
    assert "[[bus]]" in result.stdout


def test_a_bus_that_is_too_slow_is_refused_with_what_would_fit(tmp_path: Path) -> None:
    path = tmp_path / "slow.toml"
    path.write_text(STOCK.read_text().replace('rate = "500 Hz"', 'rate = "1 kHz"'))
    result = CliRunner().invoke(app, ["bus", str(path)])
    assert result.exit_code == 2
    assert result.stderr.startswith(f'turnbuckle: {path}: bus[3]: found "base" with 4 drives')
    assert "or a rate of 500 Hz" in result.stderr
