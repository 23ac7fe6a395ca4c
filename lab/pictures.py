"""Pictures as files: PNG with a mark that tells them from a user's own."""

from __future__ import annotations

from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

from turnbuckle.model.files import refuse_foreign_file, write_whole

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SOFTWARE = "turnbuckle"
MARK = b"Software\0turnbuckle"
"""The same in the file."""


def refuse_foreign_picture(path: Path) -> None:
    """Leave a picture alone that is not ours: FileError."""
    refuse_foreign_file(path, MARK)


def write_picture(figure: Figure, path: Path) -> None:
    """Write a figure as PNG, over nothing but our own; FileError where it cannot be written."""
    refuse_foreign_picture(path)
    write_whole(path, png_of(figure, metadata={"Software": SOFTWARE}))


def png_of(figure: Figure, **how: Any) -> bytes:
    """A figure as PNG; how: further arguments of its savefig."""
    stream = BytesIO()
    figure.savefig(stream, format="png", **how)
    return stream.getvalue()
