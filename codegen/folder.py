"""Folders of results: written as a whole or not at all, and never over something else.

Among the files is a manifest, JSON whose key "files" names the others. It tells a folder that may
be replaced from one that holds a user's own work.
"""

import json
import os
import shutil
import tempfile
from collections.abc import Mapping
from pathlib import Path

from turnbuckle.model.refusal import Refusal


class FolderError(Refusal):
    """A folder cannot be written; the text says what stands in the way."""


def write_folder(files: Mapping[str, str | bytes], folder: Path, manifest: str) -> None:
    """Replace the folder by the files, as a whole or not at all.

    Raises FolderError where the folder holds something that is not in its manifest, or cannot be
    written.
    """
    refuse_foreign(folder, manifest)
    place(files, folder)


def place(files: Mapping[str, str | bytes], folder: Path) -> None:
    """Put the files where a folder is or will be; FolderError where it cannot be written."""
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        fresh = Path(tempfile.mkdtemp(prefix=f".{folder.name}-", dir=folder.parent))
        try:
            fill(fresh, files)
            exchange(fresh, folder)
        finally:
            shutil.rmtree(fresh, ignore_errors=True)
    except OSError as error:
        raise FolderError(
            f"{folder}: cannot be written: {error.strerror}; name a folder you may write with --out"
        ) from None


def refuse_foreign(folder: Path, manifest: str) -> None:
    """A folder with other content than ours is left alone: FolderError."""
    if folder.is_symlink() or (folder.exists() and not folder.is_dir()):
        raise FolderError(f"{folder}: is not a folder; --out takes a new or a generated folder")
    if not folder.exists():
        return
    entries = sorted(
        entry.relative_to(folder).as_posix()
        for entry in folder.rglob("*")
        if entry.is_symlink() or not entry.is_dir() or not any(entry.iterdir())
    )
    if entries and manifest not in entries:
        raise FolderError(
            f"{folder}: holds {entries[0]!r} and no {manifest}, so it was not generated; "
            "--out takes a new, an empty or a generated folder"
        )
    if manifest in entries:
        strangers = set(entries) - set(names_in(folder / manifest)) - {manifest}
        if strangers:
            raise FolderError(
                f"{folder}: holds {min(strangers)!r}, which was not generated and would be lost; "
                "move it away, or name another folder with --out"
            )


def names_in(manifest: Path) -> list[str]:
    """Files that a manifest lists."""
    try:
        return list(json.loads(manifest.read_text())["files"])
    except (OSError, ValueError, KeyError, TypeError):
        raise FolderError(
            f"{manifest}: is not a manifest of generated files; name another folder with --out"
        ) from None


def fill(folder: Path, files: Mapping[str, str | bytes]) -> None:
    """Write the files, their names relative to the folder; readable by everyone, as the rest of a
    checkout is."""
    folder.chmod(0o755)
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        with path.open("wb") as stream:
            stream.write(content.encode() if isinstance(content, str) else content)
            stream.flush()
            os.fsync(stream.fileno())


def exchange(fresh: Path, folder: Path) -> None:
    """Put the fresh folder where the old one is; the old one comes back if that fails."""
    if not folder.exists():
        fresh.rename(folder)
        return
    old = folder.with_name(f".{folder.name}-old-{os.getpid()}")
    folder.rename(old)
    try:
        fresh.rename(folder)
    except OSError:
        old.rename(folder)
        raise
    shutil.rmtree(old)
