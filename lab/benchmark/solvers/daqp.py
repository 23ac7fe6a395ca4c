"""DAQP, a dual active-set solver in C: its own source and flags, a workspace that is kept."""

import re
import sys
import tarfile
from pathlib import Path

from lab.benchmark.native import BUILD, PEER_FLAGS, ROOT, compile_object, run_tool
from lab.benchmark.solvers.solver import Solver, adapter, bound_flags, c_solver
from model.machine import Machine

PEERS = ROOT / "build" / "peers"
#: The flags of DAQP's own Python package, less its timers.
AUTHORS_FLAGS = ("-fassociative-math", "-fno-signed-zeros", "-fno-trapping-math")


def daqp(machine: Machine) -> Solver:
    """DAQP behind the common signature: cold start, problem data updated for every solve."""
    sources = fetch_source() / "csrc"
    flags = (*PEER_FLAGS, *AUTHORS_FLAGS)
    objects = [
        compile_object(
            source, BUILD / "daqp" / f"{source.stem}.o", (*flags, f"-I{sources}/include")
        )
        for source in sorted((sources / "src").glob("*.c"))
    ]
    objects.append(adapter("daqp", (*flags, f"-isystem{sources}/include", *bound_flags(machine))))
    return c_solver("DAQP", "C, kept workspace, update + solve", objects)


def locked_source() -> tuple[str, str]:
    """Version and hashes of DAQP in the lock, as a requirement that pip reads."""
    lock = (ROOT / "requirements.lock").read_text()
    match = re.search(r"^daqp==(\S+) \\\n(?:    --hash=\S+(?: \\)?\n)+", lock, re.MULTILINE)
    if match is None:
        raise RuntimeError("requirements.lock does not pin daqp")
    return match[1], match[0]


def fetch_source() -> Path:
    """The unpacked source package of the pinned version, fetched once to build/peers."""
    version, requirement = locked_source()
    folder = PEERS / f"daqp-{version}"
    if not folder.exists():
        PEERS.mkdir(parents=True, exist_ok=True)
        pinned = PEERS / "daqp.txt"
        pinned.write_text(requirement)
        run_tool([sys.executable, "-m", "pip", "download", "--quiet", "--no-deps",
                  "--no-binary", "daqp", "--no-build-isolation", "--require-hashes",
                  "--requirement", str(pinned), "--dest", str(PEERS)])  # fmt: skip
        with tarfile.open(PEERS / f"daqp-{version}.tar.gz") as archive:
            archive.extractall(PEERS, filter="data")
    return folder
