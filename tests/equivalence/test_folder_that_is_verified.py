"""`turnbuckle verify --in` judges the C that is in a folder, and no other machine's."""

import json
import shutil
import subprocess
from pathlib import Path

import pytest

from turnbuckle.codegen.compile import FLAGS, PRECISIONS
from turnbuckle.codegen.folder import FolderError
from turnbuckle.codegen.generate import MANIFEST
from turnbuckle.codegen.verify import verify

ROOT = Path(__file__).parents[2]
MACHINE = ROOT / "machines" / "brau_triangle.toml"
POINTS = 40


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A copy of the committed C of a small machine."""
    return Path(shutil.copytree(ROOT / "generated" / MACHINE.stem, tmp_path / "c"))


def test_the_committed_c_agrees_and_a_wrong_sign_in_it_is_found(folder: Path) -> None:
    assert verify(MACHINE, POINTS, folder=folder).passed
    source = folder / "tb_kinematics.c"
    text = source.read_text()
    wrong = text.replace("length[0] = length_0;", "length[0] = -length_0;")
    assert wrong != text
    source.write_text(wrong)
    failures = verify(MACHINE, POINTS, folder=folder).failures()
    assert {row.function for row in failures} >= {"cable_lengths"}


def build(folder: Path, place: Path) -> None:
    """The C of a folder as static libraries, as `make build` has them."""
    for precision, options in PRECISIONS.items():
        there = place / precision
        there.mkdir(parents=True)
        sources = sorted(folder.glob("*.c"))
        flags = ["-O0", "-fPIC", *FLAGS[:1], *FLAGS[2:], *options]
        subprocess.run(["gcc", *flags, "-c", *sources], cwd=there, check=True)
        objects = sorted(there.glob("*.o"))
        subprocess.run(["ar", "rcs", there / "libturnbuckle.a", *objects], check=True)


def test_static_libraries_are_judged_as_they_are(folder: Path, tmp_path: Path) -> None:
    sound, broken = tmp_path / "sound", tmp_path / "broken"
    build(folder, sound)
    source = folder / "tb_kinematics.c"
    right = source.read_text()
    source.write_text(right.replace("length[0] = length_0;", "length[0] = -length_0;"))
    build(folder, broken)
    source.write_text(right)
    assert verify(MACHINE, POINTS, folder=folder, built=sound).passed
    failures = verify(MACHINE, POINTS, folder=folder, built=broken).failures()
    assert {row.function for row in failures} >= {"cable_lengths"}
    with pytest.raises(FolderError, match=r"libturnbuckle\.a: is missing"):
        verify(MACHINE, POINTS, folder=folder, built=tmp_path / "nowhere")


@pytest.mark.parametrize(
    ("key", "value", "words"),
    [
        ("hash", "0123456789abcdef", "holds C of machine hash 0123456789abcdef"),
        ("prefix", "left", "every name begins with left"),
    ],
)
def test_c_of_another_machine_or_with_a_prefix_is_refused(
    folder: Path, key: str, value: str, words: str
) -> None:
    content = json.loads((folder / MANIFEST).read_text())
    (folder / MANIFEST).write_text(json.dumps(content | {key: value}))
    with pytest.raises(FolderError, match=words):
        verify(MACHINE, POINTS, folder=folder)


@pytest.mark.parametrize("text", [None, "", "[]", "{}", '{"hash": 1}', "\0"])
def test_a_folder_without_a_sound_manifest_is_refused_with_the_command_that_mends_it(
    folder: Path, text: str | None
) -> None:
    (folder / MANIFEST).unlink()
    if text is not None:
        (folder / MANIFEST).write_text(text)
    with pytest.raises(FolderError, match=f"turnbuckle generate .* --out {folder}"):
        verify(MACHINE, POINTS, folder=folder)
