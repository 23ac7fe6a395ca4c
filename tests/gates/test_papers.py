"""The project's papers: the licence is in what is installed, the workflow runs what users run."""

import shutil
import subprocess
import sys
from email.message import Message
from email.parser import Parser
from pathlib import Path

import pytest

from turnbuckle.codegen.generate import LICENCE

ROOT = Path(__file__).parents[2]
PAPERS = ("LICENSE", "NOTICE")
WORKFLOW = (ROOT / ".github" / "workflows" / "ci.yml").read_text()
#: What pip asks the build backend for before it builds anything.
BUILD_METADATA = """
import sys
from setuptools import build_meta
print(build_meta.prepare_metadata_for_build_wheel(sys.argv[1]))
"""


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """What the project's metadata is made of: the files beside pyproject.toml."""
    for path in ROOT.iterdir():
        if path.is_file() and not path.name.startswith("."):
            shutil.copy(path, tmp_path)
    return tmp_path


def metadata(project: Path) -> tuple[Message, Path]:
    """What an installer reads of the project, and the folder in which the wheel will have it."""
    out = project / "built"
    out.mkdir()
    done = subprocess.run(
        [sys.executable, "-c", BUILD_METADATA, str(out)],
        cwd=project,
        capture_output=True,
        text=True,
        check=True,
    )
    folder = out / done.stdout.splitlines()[-1]
    return Parser().parsestr((folder / "METADATA").read_text()), folder


def missing_papers(project: Path) -> set[str]:
    """Licence files whose text an installed package lacks."""
    _, folder = metadata(project)
    held = {path.name: path.read_bytes() for path in folder.glob("licenses/*")}
    return {name for name in PAPERS if held.get(name) != (ROOT / name).read_bytes()}


def runs_all_tests(workflow: str) -> bool:
    """Whether a step is `.ci/run`, and its failure fails the job."""
    steps = [line.strip() for line in workflow.splitlines()]
    return "run: .ci/run" in steps and "continue-on-error" not in workflow


def test_an_installed_package_holds_the_licence(project: Path) -> None:
    assert missing_papers(project) == set()


def test_a_package_without_a_licence_file_is_noticed(project: Path) -> None:
    settings = project / "pyproject.toml"
    text = settings.read_text()
    assert '["LICENSE", "NOTICE"]' in text
    settings.write_text(text.replace('["LICENSE", "NOTICE"]', '["LICENSE"]'))
    assert missing_papers(project) == {"NOTICE"}


def test_a_licence_with_another_text_is_noticed(project: Path) -> None:
    with (project / "LICENSE").open("a") as stream:
        stream.write("for friends only\n")
    assert missing_papers(project) == {"LICENSE"}


def test_the_metadata_says_what_turnbuckle_is_and_under_which_licence(project: Path) -> None:
    fields, _ = metadata(project)
    assert fields["License-Expression"] == "Apache-2.0"
    assert fields["Description-Content-Type"] == "text/markdown"
    assert str(fields.get_payload()).startswith("# Turnbuckle")
    assert "Operating System :: POSIX :: Linux" in fields.get_all("Classifier", [])


def test_the_licence_is_the_apache_licence_whole() -> None:
    text = (ROOT / "LICENSE").read_text()
    assert "Apache License" in text.splitlines()[1]
    assert "END OF TERMS AND CONDITIONS" in text


def unlicensed(folder: Path) -> set[str]:
    """C files of a generated folder that do not say whose they are."""
    line = f"SPDX-License-Identifier: {LICENCE} */"
    return {path.name for path in folder.glob("*.[ch]") if line not in path.read_text()}


def test_generated_c_says_whose_it_is_as_the_notice_does(stock_folder: Path) -> None:
    assert f"SPDX identifier {LICENCE}" in (ROOT / "NOTICE").read_text()
    assert unlicensed(stock_folder) == set()


def test_generated_c_that_does_not_say_so_is_noticed(stock_folder: Path, tmp_path: Path) -> None:
    folder = Path(shutil.copytree(stock_folder, tmp_path / "generated"))
    types = folder / "tb_types.h"
    types.write_text(types.read_text().replace(LICENCE, "Apache-2.0"))
    assert unlicensed(folder) == {"tb_types.h"}


def test_the_workflow_runs_what_a_newcomer_runs() -> None:
    assert runs_all_tests(WORKFLOW)
    command = ROOT / ".ci" / "run"
    assert command.stat().st_mode & 0o111
    assert command.read_text().splitlines()[-1] == "make test"


@pytest.mark.parametrize(
    "other",
    ["run: .ci/run || true", "run: .ci/lint_c", "run: .ci/run\n        continue-on-error: true"],
)
def test_a_workflow_that_lets_failures_pass_is_noticed(other: str) -> None:
    assert not runs_all_tests(WORKFLOW.replace("run: .ci/run", other))
