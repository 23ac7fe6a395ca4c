"""The layout of our C is held by `make lint`, and made by `make format`."""

import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
SOURCES = {
    "runtime/core/supervisor.c",
    "lab/lockstep_shim.c",
    "codegen/pose_map_shim.c",
    "tests/wire/peer_drives/adapter.c",
}


LOOK = (".ci/format_c", "--dry-run", "-Werror")


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """A file of every folder that holds C, with the layout and what looks at it."""
    for name in (".clang-format", "tests/.clang-format", ".ci/format_c", *SOURCES):
        target = tmp_path / name
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, target)
    return tmp_path


def run(folder: Path, *command: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)


def test_lint_looks_at_the_layout_of_c() -> None:
    assert " ".join(LOOK) in run(ROOT, "make", "--dry-run", "lint_c").stdout.splitlines()


def test_lint_passes_c_that_has_its_layout(project: Path) -> None:
    done = run(project, *LOOK)
    assert done.returncode == 0, done.stderr
    assert f"{len(SOURCES)} files" in done.stdout


@pytest.mark.parametrize("name", sorted(SOURCES))
@pytest.mark.parametrize("seeded", ["int  f(void);\n", "void g(void) {\n  f();\n}\n"])
def test_lint_names_the_file_and_line_that_has_another_layout(
    name: str, seeded: str, project: Path
) -> None:
    file = project / name
    line = len(file.read_text().splitlines()) + 1
    with file.open("a") as stream:
        stream.write(seeded)
    done = run(project, *LOOK)
    assert done.returncode != 0
    assert f"{name}:{line}:" in done.stderr


def test_format_gives_the_layout_that_lint_wants(project: Path) -> None:
    file = project / "runtime" / "core" / "supervisor.c"
    text = file.read_text()
    file.write_text(text.replace("    ", "  "))
    assert run(project, *LOOK).returncode != 0
    assert run(project, ".ci/format_c", "-i").returncode == 0
    assert file.read_text() == text


def test_all_c_that_is_written_by_hand_is_looked_at() -> None:
    done = run(ROOT, *LOOK)
    assert done.returncode == 0, done.stderr
    ours = [
        path
        for folder in ("runtime", "lab", "codegen", "tests")
        for path in (ROOT / folder).rglob("*.[ch]")
    ]
    assert done.stdout == f"C: {len(ours)} files through clang-format\n"
