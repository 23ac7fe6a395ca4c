"""`turnbuckle check`: every problem on a line, or all as JSON, with the exit status of the file."""

import json
import re
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from turnbuckle.command_line import app

STOCK = Path(__file__).parents[2] / "machines" / "yoon2023.toml"
TEXT = STOCK.read_text(encoding="utf-8")


def check(path: Path, *options: str) -> Result:
    return CliRunner().invoke(app, ["check", str(path), *options])


@pytest.fixture
def bad(tmp_path: Path) -> Path:
    """A machine file with three mistakes."""
    path = tmp_path / "bad.toml"
    text = TEXT.replace('radius = "5 mm"', 'radius = "5 MM"').replace('min = "3 N"', 'min = "12 N"')
    path.write_text(text.replace("node = 4", "node = 127"), encoding="utf-8")
    return path


KEYS = ["drum.radius", "drive[8].node", "tension.min"]


def test_every_problem_is_a_line(bad: Path) -> None:
    result = check(bad)
    assert (result.exit_code, result.stdout) == (2, "")
    lines = result.stderr.splitlines()
    assert [line.removeprefix(f"turnbuckle: {bad}: ").split(": ")[0] for line in lines] == KEYS
    assert all("found" in line and "; allowed: " in line for line in lines)


def test_problems_are_there_as_json(bad: Path) -> None:
    result = check(bad, "--json")
    assert (result.exit_code, result.stderr) == (2, "")
    told = json.loads(result.stdout)
    assert (told["file"], told["valid"]) == (str(bad), False)
    assert [problem["key"] for problem in told["problems"]] == KEYS
    assert told["problems"][0]["found"] == '"5 MM", whose unit is unknown'
    assert "did you mean Mm or mm?" in told["problems"][0]["allowed"]


def test_what_is_no_toml_is_a_problem_of_the_file_itself(tmp_path: Path) -> None:
    path = tmp_path / "bad.toml"
    path.write_text("[machine\n")
    [problem] = json.loads(check(path, "--json").stdout)["problems"]
    assert problem["key"] == ""
    assert "line 1" in problem["found"]


def test_a_machine_is_there_as_json() -> None:
    result = check(STOCK, "--json")
    told = json.loads(result.stdout)
    assert (result.exit_code, result.stderr) == (0, "")
    digits = told.pop("content_sha256")
    assert re.fullmatch("[0-9a-f]{64}", digits)
    assert told == {
        "file": str(STOCK),
        "valid": True,
        "problems": [],
        "name": "yoon2023",
        "kind": "planar-point",
        "warnings": [],
    }


def test_the_hash_is_that_of_the_content_and_not_of_its_spelling(tmp_path: Path) -> None:
    path = tmp_path / "machine.toml"
    digits = [json.loads(check(STOCK, "--json").stdout)["content_sha256"]]
    for text in (TEXT.replace("55 mN*m", "0,055 Nm"), TEXT.replace("55 mN*m", "56 mN*m")):
        path.write_text(text, encoding="utf-8")
        digits.append(json.loads(check(path, "--json").stdout)["content_sha256"])
    assert digits[0] == digits[1] != digits[2]


def test_a_target_off_the_middle_is_a_warning(tmp_path: Path) -> None:
    path = tmp_path / "machine.toml"
    path.write_text(TEXT.replace('centre = ["355.9 mm"', 'centre = ["350 mm"'), encoding="utf-8")
    told = json.loads(check(path, "--json").stdout)
    assert told["valid"]
    assert [warning["key"] for warning in told["warnings"]] == ["target.centre"]
