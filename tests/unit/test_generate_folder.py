"""Writing a generated folder: whole or not at all, and never over something else."""

from pathlib import Path

import pytest

from turnbuckle.codegen.folder import FolderError
from turnbuckle.codegen.generate import MANIFEST, write

FILES = {"tb_a.c": "int a;\n", MANIFEST: '{"files": {"tb_a.c": ""}}\n'}


def test_a_new_folder_holds_the_files(tmp_path: Path) -> None:
    write(FILES, tmp_path / "new")
    assert {p.name: p.read_text() for p in (tmp_path / "new").iterdir()} == FILES


def test_a_generated_folder_is_replaced_as_a_whole(tmp_path: Path) -> None:
    write(FILES, tmp_path / "out")
    write({MANIFEST: '{"files": {}}\n'}, tmp_path / "out")
    assert [p.name for p in (tmp_path / "out").iterdir()] == [MANIFEST]
    assert [p.name for p in tmp_path.iterdir()] == ["out"]


@pytest.mark.parametrize("manifest", [False, True])
def test_a_foreign_file_is_never_lost(manifest: bool, tmp_path: Path) -> None:
    folder = tmp_path / "out"
    if manifest:
        write(FILES, folder)
    folder.mkdir(exist_ok=True)
    (folder / "thesis.txt").write_text("mine")
    with pytest.raises(FolderError, match=r"holds 'thesis.txt'"):
        write(FILES, folder)
    assert (folder / "thesis.txt").read_text() == "mine"


def test_a_damaged_manifest_is_refused(tmp_path: Path) -> None:
    (tmp_path / MANIFEST).write_text("not json")
    with pytest.raises(FolderError, match="is not a manifest"):
        write(FILES, tmp_path)
