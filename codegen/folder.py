"""Folders of results: written as a whole or not at all, and never over something else.

Among the files is a manifest, JSON whose key "files" names the others. It tells a folder that may
be replaced from one that holds a user's own work. Its key "machine", or "machines", tells whose
files they are: those of another machine are replaced only by force.
"""

import json
import os
import shutil
import tempfile
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path, PurePosixPath
from typing import NamedTuple

from turnbuckle.model.refusal import Refusal


class FolderError(Refusal):
    """A folder cannot be written; the text says what stands in the way."""


def write_folder(
    files: Mapping[str, str | bytes], folder: Path, manifest: str, force: bool = False
) -> None:
    """Replace the folder by the files, as a whole or not at all.

    Raises FolderError where the folder holds something that is not in its manifest, or without
    force the files of another machine, or cannot be written.
    """
    refuse_foreign(folder, manifest, manifest_of(files[manifest]).machines, force)
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


def refuse_foreign(
    folder: Path, manifest: str, machines: Sequence[str], force: bool = False
) -> None:
    """A folder with other content than ours is left alone: FolderError.

    machines: names of those whose files shall be there. force: there may be those of others.
    """
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
        found = read_manifest(folder / manifest)
        present = {path.relative_to(folder).as_posix() for path in folder.rglob("*")}
        strangers = present - with_folders(found.files) - {manifest}
        if strangers:
            raise FolderError(
                f"{folder}: holds {min(strangers)!r}, which was not generated and would be lost; "
                "move it away, or name another folder with --out"
            )
        if not force:
            refuse_other_machines(folder, found.machines, machines)


def with_folders(names: Iterable[str]) -> set[str]:
    """The names, and the folders that they are in."""
    return {
        str(path) for name in names for path in (PurePosixPath(name), *PurePosixPath(name).parents)
    }


def refuse_other_machines(folder: Path, found: Sequence[str], machines: Sequence[str]) -> None:
    """Refuse to replace what was made for other machines: FolderError."""
    if sorted(found) != sorted(machines):
        here, wanted = (" and ".join(names) or "no machine" for names in (found, machines))
        raise FolderError(
            f"{folder}: holds the files of {here}, not of {wanted}; name another folder with"
            " --out, or replace them with --force"
        )


class Manifest(NamedTuple):
    """What a manifest tells: names of files, and of the machines that they are made for."""

    files: set[str]
    machines: list[str]


def manifest_of(text: str | bytes) -> Manifest:
    """The manifest in a text; ValueError, KeyError, TypeError where there is none."""
    content = dict(json.loads(text))
    names = content.get("machines") or [content.get("machine")]
    return Manifest(set(content["files"]), [str(name) for name in names if name])


def read_manifest(path: Path) -> Manifest:
    """The manifest of a folder; FolderError for a file that is none."""
    try:
        return manifest_of(path.read_text())
    except (OSError, ValueError, KeyError, TypeError):
        raise FolderError(
            f"{path}: is not a manifest of generated files; name another folder with --out"
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
