"""A kind of platform is one entry: what the model needs of it follows from its dimensions."""

import re
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from turnbuckle.codegen.identity import machine_hash
from turnbuckle.codegen.model import build_model
from turnbuckle.command_line import app
from turnbuckle.lab.analysis import plots, slices
from turnbuckle.lab.design import target
from turnbuckle.lab.plants import plant_model
from turnbuckle.model.kind import KINDS, Kind
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine
from turnbuckle.model.reference.kinematics import rotation_jacobian
from turnbuckle.model.workspace.summary import fine_grid

ROOT = Path(__file__).parents[2]
README = ROOT / "README.md"
TWINS = {
    "plate": ("yoon_fixed_diagonal", "planar-point"),
    "lid": ("planar_rigid", "planar-rigid"),
    "kite": ("brau_tetrahedron", "spatial-point"),
    "cross": ("spidar_g", "spatial-rigid"),
}
"""A kind that only this test knows: a machine, and the kind whose dimensions it shares."""


@pytest.fixture(params=TWINS)
def twins(
    request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> tuple[Machine, Machine]:
    """A stock machine, and the same of a kind that is new."""
    name, (stock, known) = request.param, TWINS[request.param]
    dimensions = KINDS[known]
    monkeypatch.setitem(KINDS, name, Kind(dimensions.dof, dimensions.space, "one more kind"))
    source = ROOT / "machines" / f"{stock}.toml"
    path = tmp_path / f"{stock}.toml"
    text = source.read_text()
    assert f'kind = "{known}"' in text
    path.write_text(text.replace(f'kind = "{known}"', f'kind = "{name}"'))
    return load_machine(source), load_machine(path)


def test_a_new_kind_is_analysed_searched_and_simulated_as_its_dimensions_are(
    twins: tuple[Machine, Machine],
) -> None:
    known, new = twins
    assert new.kind != known.kind and new.describe() != known.describe()
    assert fine_grid(new).shape == fine_grid(known).shape
    assert [plane.x.size for plane in slices.slices(new)] == [
        plane.x.size for plane in slices.slices(known)
    ]
    assert (target.isotropic_force(new) == target.isotropic_force(known)).all()
    pose = np.array([[*new.target.centre, *[0.1, 0.2, 0.3][: new.dof - new.space]]])
    assert (rotation_jacobian(new, pose) == rotation_jacobian(known, pose)).all()
    assert plant_model(new) is plant_model(known)


def test_a_new_kind_gets_the_code_of_its_dimensions(twins: tuple[Machine, Machine]) -> None:
    known, new = twins
    assert machine_hash(build_model(new)) == machine_hash(build_model(known))


def test_commands_take_a_new_kind(
    twins: tuple[Machine, Machine], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(plots, "DPI", 40)
    monkeypatch.setattr(slices, "CELLS", dict.fromkeys(slices.CELLS, 4))
    new = twins[1]
    checked = CliRunner().invoke(app, ["check", str(new.path)], env={"COLUMNS": "100"})
    assert checked.exit_code == 0 and f"{new.kind}: one more kind" in checked.stdout
    if new.is_rigid:  # a report of what turns takes half a minute
        return
    out = tmp_path / "analysis"
    analysed = CliRunner().invoke(app, ["analyze", str(new.path), "--out", str(out)])
    assert analysed.exit_code in (0, 1) and (out / "report.md").exists(), analysed.stderr


def test_the_readme_names_every_kind() -> None:
    """A kind that its list of keys does not name is one that nobody finds."""
    (row,) = [line for line in README.read_text().splitlines() if "| `machine.kind` |" in line]
    assert set(re.findall(r"`([a-z]+-[a-z]+)`", row)) == set(KINDS), "README.md, `machine.kind`"


@pytest.mark.parametrize(("dof", "space"), [(1, 1), (2, 3), (4, 3), (4, 2)])
def test_dimensions_that_the_model_does_not_know_are_refused(dof: int, space: int) -> None:
    words = f"found {dof} degrees of freedom in a space of dimension {space}; allowed: a space of"
    with pytest.raises(ValueError, match=words):
        Kind(dof, space, "nothing yet")
