"""`turnbuckle analyze`, `compare`, the warning of `generate`: what they write, say, refuse."""

import errno
import json
import os
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

import turnbuckle.codegen.folder
import turnbuckle.codegen.generate
from turnbuckle.command_line import app
from turnbuckle.lab.analysis import plots, slices
from turnbuckle.model.machine import Machine

ROOT = Path(__file__).parents[2]
GOOD, BAD = (ROOT / "machines" / f"{name}.toml" for name in ("brau_square", "yoon_fixed_diagonal"))
MOVABLE = ROOT / "machines" / "yoon2023.toml"
MAPS = ["conditioning", "force", "margin", "tension_factor", "torque", "zero_wrench"]


@pytest.fixture(autouse=True)
def coarse(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Small maps, and an empty folder to work in."""
    monkeypatch.setattr(plots, "DPI", 40)
    monkeypatch.setattr(slices, "CELLS", dict.fromkeys(slices.CELLS, 12))
    monkeypatch.chdir(tmp_path)


def run(*arguments: str | Path) -> Result:
    """Run a command in this process."""
    return CliRunner().invoke(app, list(map(str, arguments)), env={"COLUMNS": "100"})


def assert_refused(result: Result, *words: str) -> None:
    """Exit status 2 and one message on stderr that holds the words."""
    assert result.exit_code == 2
    assert result.stdout == ""
    assert result.stderr.startswith("turnbuckle: ")
    assert result.stderr.count("\n") == 1
    for word in words:
        assert word in result.stderr


def test_a_good_machine_is_analyzed_with_status_zero(tmp_path: Path) -> None:
    result = run("analyze", GOOD, "--out", "here")
    assert (result.exit_code, result.stderr) == (0, "")
    assert "Yes: 5 N in every direction in all of the target" in result.stdout
    names = sorted(path.name for path in (tmp_path / "here").iterdir())
    assert names == sorted(["analysis.json", "report.md", *(f"{name}.png" for name in MAPS)])
    for name in MAPS:
        assert (tmp_path / "here" / f"{name}.png").read_bytes().startswith(b"\x89PNG")
    content = json.loads((tmp_path / "here" / "analysis.json").read_text())
    assert content["passed"] is True
    assert sorted([*content["files"], "analysis.json"]) == names


def test_a_bad_machine_is_analyzed_with_status_one(tmp_path: Path) -> None:
    result = run("analyze", BAD)
    assert result.exit_code == 1
    assert "No: 2 N in every direction in 39.7 % of the target" in result.stdout
    assert (tmp_path / "build" / "analysis" / "yoon_fixed_diagonal" / "report.md").exists()


def test_movable_bases_get_a_map_of_late_bases_and_the_lag_is_told(tmp_path: Path) -> None:
    result = run("analyze", MOVABLE, "--out", "here", "--lag", "5")
    assert result.exit_code == 0
    assert (tmp_path / "here" / "lag.png").exists()
    content = json.loads((tmp_path / "here" / "analysis.json").read_text())
    assert content["lag"] == 0.005
    assert "5 mm away" in (tmp_path / "here" / "report.md").read_text()


def test_the_same_machine_gives_the_same_bytes_again(tmp_path: Path) -> None:
    contents = []
    for _ in range(2):
        run("analyze", GOOD, "--out", "here")
        contents.append({p.name: p.read_bytes() for p in (tmp_path / "here").iterdir()})
    assert contents[0] == contents[1]


@pytest.mark.parametrize("lag", ["-1", "nan", "inf", "much"])
def test_a_lag_that_is_no_length_is_refused(lag: str, tmp_path: Path) -> None:
    result = run("analyze", MOVABLE, "--lag", lag)
    assert result.exit_code == 2
    assert "--lag" in result.stderr
    assert not list(tmp_path.iterdir())


def test_a_file_in_place_of_the_folder_is_refused(tmp_path: Path) -> None:
    (tmp_path / "out").write_text("mine")
    assert_refused(run("analyze", GOOD, "--out", "out"), "out", "is not a folder")
    assert (tmp_path / "out").read_text() == "mine"


@pytest.mark.parametrize("command", [["analyze", GOOD], ["compare", GOOD, BAD]])
def test_a_folder_with_other_content_is_left_alone(
    command: list[str | Path], tmp_path: Path
) -> None:
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "thesis.tex").write_text("mine")
    assert_refused(run(*command, "--out", "out"), "thesis.tex", "--out")
    assert (tmp_path / "out" / "thesis.tex").read_text() == "mine"


def test_generated_c_is_not_replaced_by_a_report(tmp_path: Path) -> None:
    turnbuckle.codegen.generate.write(
        {turnbuckle.codegen.generate.MANIFEST: '{"files": {}}'}, tmp_path / "out"
    )
    assert_refused(run("analyze", GOOD, "--out", "out"), "manifest.json", "analysis.json")


@pytest.mark.parametrize("command", [["analyze", GOOD], ["compare", GOOD, GOOD]])
def test_a_full_disk_leaves_nothing_half_written(
    command: list[str | Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(folder: Path, _: object) -> None:
        (folder / "report.md").write_text("half a rep")
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(turnbuckle.codegen.folder, "fill", full)
    assert_refused(run(*command, "--out", "out"), "No space left on device", "--out")
    assert not list(tmp_path.iterdir())


def test_a_folder_that_may_not_be_written_is_told(tmp_path: Path) -> None:
    result = run("analyze", GOOD, "--out", "/proc/turnbuckle")
    assert_refused(result, "/proc/turnbuckle: cannot be written")


def test_an_empty_tension_capable_workspace_is_a_result(tmp_path: Path) -> None:
    path = tmp_path / "weak.toml"
    path.write_text(
        GOOD.read_text().replace('max = "10 N"', 'max = "4 N"').replace("brau_square", "weak")
    )
    result = run("analyze", path)
    assert result.exit_code == 1
    assert "5 N in every direction in no part of the target" in result.stdout
    assert "tension capable workspace is empty" in " ".join(result.stdout.split())


def test_compare_shows_what_changed_and_what_it_did(tmp_path: Path) -> None:
    result = run("compare", GOOD, BAD, "--out", "out")
    assert (result.exit_code, result.stderr) == (0, "")
    assert "cable[2].base" in result.stdout
    assert "least isotropic force" in result.stdout
    content = json.loads((tmp_path / "out" / "comparison.json").read_text())
    assert content["machines"] == ["brau_square", "yoon_fixed_diagonal"]
    assert content["passed"] == [True, False]
    assert ["tension.min", '"0 N"', '"3 N"'] in content["changes"]
    report = (tmp_path / "out" / "report.md").read_text()
    for name in content["files"]:
        assert (tmp_path / "out" / name).exists()
        assert name == "report.md" or f"({name})" in report


def test_compare_writes_nothing_without_a_folder(tmp_path: Path) -> None:
    result = run("compare", GOOD, GOOD)
    assert result.exit_code == 0
    assert "nothing" in result.stdout
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("which", [0, 1])
def test_compare_refuses_a_bad_machine_file_with_its_key(which: int, tmp_path: Path) -> None:
    path = tmp_path / "bad.toml"
    path.write_text(GOOD.read_text().replace('radius = "5 mm"', 'radius = "-5 mm"'))
    files = [GOOD, GOOD]
    files[which] = path
    assert_refused(run("compare", *files), "bad.toml", "drum.radius", '"-5 mm"')


@pytest.fixture
def quick_c(monkeypatch: pytest.MonkeyPatch) -> None:
    """Generation takes no time."""

    def manifest(machine: Machine, prefix: str, before: Path) -> dict[str, str]:
        parts: dict[str, object] = {name: {} for name in ("functions", "aliases", "files")}
        content = {"machine": machine.name, "hash": "0", **parts}
        return {turnbuckle.codegen.generate.MANIFEST: json.dumps(content)}

    monkeypatch.setattr(turnbuckle.codegen.generate, "generate", manifest)


@pytest.mark.usefixtures("quick_c")
def test_generate_warns_of_a_target_that_is_not_served(tmp_path: Path) -> None:
    result = run("generate", BAD)
    assert result.exit_code == 0
    assert result.stderr.count("\n") == 1
    for words in ("warning", str(BAD), "2 N", "36.1 % of the target", "21 x 21", "(0, 142) mm"):
        assert words in result.stderr
    assert (tmp_path / "generated" / "yoon_fixed_diagonal").exists()


@pytest.mark.usefixtures("quick_c")
def test_generate_strict_refuses_a_target_that_is_not_served(tmp_path: Path) -> None:
    result = run("generate", BAD, "--strict")
    assert (result.exit_code, result.stdout) == (1, "")
    assert result.stderr.count("\n") == 1
    assert "36.1 % of the target" in result.stderr
    assert not list(tmp_path.iterdir())


@pytest.mark.usefixtures("quick_c")
@pytest.mark.parametrize("file", [GOOD, MOVABLE])
def test_generate_strict_lets_a_good_machine_pass(file: Path) -> None:
    result = run("generate", file, "--strict")
    assert (result.exit_code, result.stderr) == (0, "")
