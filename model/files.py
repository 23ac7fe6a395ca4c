"""Files of results: written as a whole or not at all, and never over what is not ours."""

import os
from itertools import count
from pathlib import Path

from turnbuckle.model.refusal import Refusal

ENDS = 1 << 16
"""Bytes at either end of a file in which our mark would be."""
_numbers = count()


class FileError(Refusal):
    """A file cannot be written; the text names it and says what stands in the way."""


def write_whole(path: Path, content: str | bytes) -> None:
    """Write a file as a whole or not at all; FileError where it cannot be written."""
    data = content.encode() if isinstance(content, str) else content
    fresh = path.with_name(f".{path.name}-{os.getpid()}-{next(_numbers)}")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        try:
            with fresh.open("xb") as stream:
                stream.write(data)
                stream.flush()
                os.fsync(stream.fileno())
            fresh.replace(path)
        finally:
            fresh.unlink(missing_ok=True)
    except OSError as error:
        raise FileError(f"{path}: cannot be written: {error.strerror}") from None


def refuse_foreign_file(path: Path, mark: bytes) -> None:
    """Leave alone what is there and does not hold our mark, or is empty: FileError."""
    try:
        if path.exists() and not (path.is_file() and is_marked(path, mark)):
            raise FileError(
                f"{path}: was not written by this command, and would be lost; move it away, or name"
                " another file"
            )
    except OSError as error:
        raise FileError(f"{path}: cannot be read: {error.strerror}") from None


def is_marked(path: Path, mark: bytes) -> bool:
    """Whether a file is empty, or holds a mark near its beginning or its end."""
    with path.open("rb") as stream:
        begin = stream.read(ENDS)
        stream.seek(max(0, path.stat().st_size - ENDS))
        return not begin or mark in begin or mark in stream.read()
