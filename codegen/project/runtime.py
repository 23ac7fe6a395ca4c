"""A copy of the C runtime, for a folder that is built without Python: the same in every one that
this version makes."""

import hashlib
import json
from importlib.metadata import version
from pathlib import Path

from turnbuckle.codegen.folder import write_folder
from turnbuckle.codegen.generate import MANIFEST
from turnbuckle.places import RUNTIME


def runtime_files() -> dict[str, bytes]:
    """Content of every file of the runtime by its name, and a manifest with version and hashes."""
    paths = sorted(path for path in RUNTIME.rglob("*") if path.is_file())
    files = {path.relative_to(RUNTIME).as_posix(): path.read_bytes() for path in paths}
    content = {
        "turnbuckle": version("turnbuckle"),
        "files": {name: hashlib.sha256(text).hexdigest() for name, text in files.items()},
    }
    return {**files, MANIFEST: (json.dumps(content, indent=2) + "\n").encode()}


def write_runtime(folder: Path) -> int:
    """Replace a folder by the runtime; the number of its files. FolderError where it cannot be."""
    files = runtime_files()
    write_folder(files, folder, MANIFEST)
    return len(files)
