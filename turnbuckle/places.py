"""Where the package has its C and its machines, and where it may keep what it makes."""

import atexit
import os
import shutil
import tempfile
from functools import cache
from pathlib import Path

from platformdirs import user_cache_path

PACKAGE = Path(__file__).parent
#: The C runtime.
RUNTIME = (PACKAGE / "runtime").resolve()
#: The stock machines.
MACHINES = (PACKAGE / "machines").resolve()


@cache
def cache_folder() -> Path:
    """The user's cache folder for Turnbuckle, which exists; safe to delete at any time.

    Where that cannot be written to, a folder of this process alone, which goes with the process:
    a shared one could hold libraries of somebody else.
    """
    folder = user_cache_path("turnbuckle")
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError:
        return _of_this_process()
    return folder if os.access(folder, os.W_OK | os.X_OK) else _of_this_process()


def _of_this_process() -> Path:
    folder = tempfile.mkdtemp(prefix="turnbuckle-")
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return Path(folder)
