"""Files that grow by whole lines."""

import fcntl
import os
from contextlib import suppress
from pathlib import Path

from turnbuckle.lab.design import DesignError


class Lines:
    """A text file that grows by whole lines, by one process at a time.

    A line that a full disk or a killed process cut short is taken away again.
    """

    def __init__(self, path: Path) -> None:
        """Open or begin the file; DesignError where that cannot be done."""
        self.path = path
        try:
            # Held until `close`; unbuffered, so that every line is with the system at once.
            self._file = path.open("a+b", buffering=0)
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise DesignError(f"{path}: another study is writing to it") from None
        except OSError as error:
            raise DesignError(f"{path}: cannot be written: {error.strerror}") from None

    def read(self) -> list[str]:
        """The whole lines; what follows the last of them is taken away."""
        self._file.seek(0)
        content = self._file.readall()
        whole = content[: content.rfind(b"\n") + 1]
        if whole != content:
            self._file.truncate(len(whole))
        return whole.decode("utf-8").splitlines(keepends=True)

    def append(self, text: str) -> None:
        """Add lines, all or none; DesignError where the disk is full."""
        end = self._file.seek(0, os.SEEK_END)
        rest = text.encode("utf-8")
        try:
            while rest:
                rest = rest[self._file.write(rest) :]
        except OSError as error:
            with suppress(OSError):  # if not now, then when it is read again
                self._file.truncate(end)
            raise DesignError(f"{self.path}: cannot be written: {error.strerror}") from None

    def close(self) -> None:
        """Let go of the file, its content safe on the disk."""
        with self._file:
            os.fsync(self._file.fileno())
