"""The page about plants is run as it stands: its plant is registered by one line, and used."""

import re
import textwrap
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from turnbuckle.lab import plants
from turnbuckle.lab.plants import plant_model

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "adding-a-plant.md").read_text()
REGISTER = "PLANTS.insert(0, PlantModel(planar_plant.refusal, LaggingMotors))"


@pytest.fixture(autouse=True)
def as_it_was(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """In the repository; its list of plants is the same afterwards."""
    monkeypatch.chdir(ROOT)
    listed = list(plants.PLANTS)
    yield
    plants.PLANTS[:] = listed


def blocks(page: str) -> list[str]:
    """The page's Python, in order."""
    found = re.findall(r"^( *)```python\n(.*?)^ *```$", page, re.MULTILINE | re.DOTALL)
    return [textwrap.dedent(block) for _, block in found]


def run(page: str) -> dict[str, Any]:
    """What the blocks leave behind, run one after the other."""
    names: dict[str, Any] = {"__name__": "page"}
    for block in blocks(page):
        exec(compile(block, "adding-a-plant.md", "exec"), names)
    return names


def test_the_plant_of_the_page_is_run_by_the_bench_once_it_is_listed() -> None:
    assert PAGE.count(REGISTER) == 1 and len(blocks(PAGE)) == 3
    plain = run(PAGE.replace(REGISTER, ""))  # negative control: not listed, not used
    assert plant_model(plain["machine"]).make is not plain["LaggingMotors"]
    page = run(PAGE)
    assert plant_model(page["machine"]).make is page["LaggingMotors"]
    first = slice(0, 3)
    assert (page["recording"].position[first] == plain["recording"].position[first]).all()
    behind = plain["recording"].tensions[1:100] - page["recording"].tensions[1:100]
    assert behind.max() > 0.1 and np.isfinite(behind).all()
    assert page["summary"].wall_error > plain["summary"].wall_error


def test_every_file_of_a_plant_is_listed() -> None:
    listed = {model.make.__module__.rpartition(".")[2] for model in plants.PLANTS}
    assert {path.stem for path in (ROOT / "lab").glob("*_plant.py")} == listed, "lab/plants.py"


def test_the_page_names_every_plant_there_is() -> None:
    for model in plants.PLANTS:
        name, module = model.make.__name__, model.make.__module__.rpartition(".")[2]
        row = f"| `{name}` | `lab/{module}.py` |"
        assert row in PAGE, f"docs/adding-a-plant.md: its table has no row that begins {row}"
