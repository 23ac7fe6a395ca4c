"""Results of a study on the disk: complete lines only, nothing lost, nothing twice."""

import csv
import resource
from collections.abc import Iterator
from contextlib import contextmanager
from decimal import Decimal
from pathlib import Path

import pytest

from turnbuckle.lab.design import DesignError
from turnbuckle.lab.design.design import Design, Outcome
from turnbuckle.lab.design.files import Lines
from turnbuckle.lab.design.goal import Score
from turnbuckle.lab.design.results import Kept, Results

ROOT = Path(__file__).parents[2]
STOCK = ROOT / "machines" / "yoon2023.toml"
GOOD = Kept(3, Outcome((Decimal("8.5"),), Score(5.1, True, (5.1, 5.2, 1.0)), ""))
BAD = Kept(4, Outcome((Decimal("20"),), None, "tension.max: found \"20 N\", 'x'; allowed: less"))


@pytest.fixture(scope="module")
def design() -> Design:
    """A question."""
    return Design.read(STOCK, ["tension.max=8 N..20 N"], "isotropic_force")


def opened(folder: Path, design: Design, seed: int = 0) -> Results:
    """The results in a folder, ready for more."""
    results = Results(folder, design, {"seed": seed})
    results.begin()
    return results


@contextmanager
def files_no_longer_than(size: int) -> Iterator[None]:
    """As on a disk on which a file has room for so many bytes."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


def test_results_come_back_as_they_were(tmp_path: Path, design: Design) -> None:
    results = opened(tmp_path / "study", design)
    results.add([GOOD, BAD])
    results.close()
    again = Results(tmp_path / "study", design, {"seed": 0})
    assert again.kept == {3: GOOD, 4: BAD}
    assert again.best == GOOD
    again.close()


def test_the_table_has_a_heading_with_units(tmp_path: Path, design: Design) -> None:
    results = opened(tmp_path, design)
    results.add([GOOD])
    results.close()
    (row,) = csv.DictReader((tmp_path / "results.csv").read_text().splitlines())
    assert row["tension.max [N]"] == "8.5"
    assert row["least isotropic force [N]"] == "5.1"


def test_a_result_counts_once(tmp_path: Path, design: Design) -> None:
    results = opened(tmp_path, design)
    results.add([GOOD])
    results.add([GOOD, BAD])
    results.close()
    assert (tmp_path / "results.csv").read_text().count("\n3,") == 1


def test_of_equal_machines_the_first_is_the_best(tmp_path: Path, design: Design) -> None:
    results = opened(tmp_path, design)
    results.add([GOOD._replace(point=9), GOOD, GOOD._replace(point=7)])
    assert results.best == GOOD
    results.close()


def test_a_line_cut_short_is_taken_away(tmp_path: Path, design: Design) -> None:
    results = opened(tmp_path, design)
    results.add([GOOD, BAD])
    results.close()
    path = tmp_path / "results.csv"
    path.write_bytes(path.read_bytes()[:-7])
    again = opened(tmp_path, design)
    assert again.kept == {3: GOOD}
    again.add([BAD])
    again.close()
    assert Results(tmp_path, design, {"seed": 0}).kept == {3: GOOD, 4: BAD}


def test_a_full_disk_keeps_what_there_is_and_says_so(tmp_path: Path, design: Design) -> None:
    results = opened(tmp_path, design)
    results.add([GOOD])
    path = tmp_path / "results.csv"
    before = path.read_bytes()
    with files_no_longer_than(len(before) + 9), pytest.raises(DesignError) as caught:
        results.add([BAD])
    results.close()
    assert str(caught.value) == (
        f"{path}: cannot be written: File too large; 1 results are kept: run the same command"
        " again to go on"
    )
    assert path.read_bytes() == before
    again = opened(tmp_path, design)
    again.add([BAD])
    assert again.kept == {3: GOOD, 4: BAD}
    again.close()


def test_two_studies_do_not_write_to_one_folder(tmp_path: Path, design: Design) -> None:
    results = opened(tmp_path, design)
    with pytest.raises(DesignError, match="another study is writing"):
        opened(tmp_path, design)
    results.close()
    opened(tmp_path, design).close()


def test_a_folder_with_another_study_is_refused(tmp_path: Path, design: Design) -> None:
    opened(tmp_path, design).close()
    with pytest.raises(DesignError, match=f"{tmp_path}: holds a study with another seed"):
        Results(tmp_path, design, {"seed": 1})
    other = Design.read(STOCK, ["tension.max=8 N..19 N"], "isotropic_force")
    with pytest.raises(DesignError, match="another ranges"):
        Results(tmp_path, other, {"seed": 0})


def test_a_changed_machine_file_is_another_study(tmp_path: Path, design: Design) -> None:
    opened(tmp_path / "study", design).close()
    path = tmp_path / "changed.toml"
    path.write_text(STOCK.read_text().replace('min = "3 N"', 'min = "2 N"'))
    changed = Design.read(path, ["tension.max=8 N..20 N"], "isotropic_force")
    with pytest.raises(DesignError, match="another machine file"):
        Results(tmp_path / "study", changed, {"seed": 0})


def test_a_folder_with_other_content_is_left_alone(tmp_path: Path, design: Design) -> None:
    (tmp_path / "thesis.tex").write_text("mine")
    with pytest.raises(DesignError, match=r"no study.json"):
        Results(tmp_path, design, {"seed": 0})
    assert [path.name for path in tmp_path.iterdir()] == ["thesis.tex"]


@pytest.mark.parametrize("damage", ["nonsense\n", "point,x\n1,2\n"])
def test_damaged_results_are_refused_and_left_alone(
    tmp_path: Path, design: Design, damage: str
) -> None:
    opened(tmp_path, design).close()
    (tmp_path / "results.csv").write_text(damage)
    with pytest.raises(DesignError, match="is damaged"):
        Results(tmp_path, design, {"seed": 0})
    assert (tmp_path / "results.csv").read_text() == damage


def test_lines_are_with_the_system_at_once(tmp_path: Path) -> None:
    lines = Lines(tmp_path / "lines")
    lines.append("one\n")
    assert (tmp_path / "lines").read_text() == "one\n"
    lines.close()
