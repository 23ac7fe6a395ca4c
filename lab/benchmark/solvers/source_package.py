"""Sources of peers, as their authors packed them for the version that the lock pins."""

import re
import sys
import tarfile
from pathlib import Path

from turnbuckle.lab.benchmark.native import ROOT, run_tool

PEERS = ROOT / "build" / "peers"


def locked_source(package: str) -> tuple[str, str]:
    """Version and hashes of a package in the lock, as a requirement that pip reads."""
    lock = (ROOT / "requirements-dev.lock").read_text()
    match = re.search(rf"^{package}==(\S+) \\\n(?:    --hash=\S+(?: \\)?\n)+", lock, re.MULTILINE)
    if match is None:
        raise RuntimeError(f"requirements-dev.lock does not pin {package}")
    return match[1], match[0]


def fetch_source(package: str) -> Path:
    """The unpacked source package of the pinned version, fetched once to build/peers."""
    version, requirement = locked_source(package)
    folder = PEERS / f"{package}-{version}"
    if not folder.exists():
        PEERS.mkdir(parents=True, exist_ok=True)
        pinned = PEERS / f"{package}.txt"
        pinned.write_text(requirement)
        run_tool([sys.executable, "-m", "pip", "download", "--quiet", "--no-deps",
                  "--no-binary", package, "--no-build-isolation", "--require-hashes",
                  "--requirement", str(pinned), "--dest", str(PEERS)])  # fmt: skip
        with tarfile.open(PEERS / f"{package}-{version}.tar.gz") as archive:
            archive.extractall(PEERS, filter="data")
    return folder
