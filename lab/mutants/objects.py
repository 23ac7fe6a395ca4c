"""Object code of a file of the runtime: a change that changes none of it is no mutant."""

import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).parents[2]
GENERATED = ROOT / "generated"
STOCK = "yoon2023"
#: Machines with rails and without, of two and six dimensions, with a force sensor and without.
MACHINES = (STOCK, "yoon_fixed_diagonal", "yoon_synchronised", "spidar_g")
SINGLE = "yoon_synchronised"
"""With one rail as well: some files ask how many there are."""

ObjectCode = tuple[bytes | None, ...]


def object_code(file: str, source: str, folder: Path) -> ObjectCode:
    """What gcc -O1 makes of a file of runtime/ for each of some machines; None where it refuses.

    A machine that has no table of drives takes the stock machine's. folder: for what is made.
    """
    place = folder / Path(file).name
    place.write_text(source)
    own = ROOT / "runtime" / Path(file).parent
    machines = [*(GENERATED / name for name in MACHINES), _with_one_rail(folder / SINGLE)]
    return tuple(_compiled(place, own, machine) for machine in machines)


def _with_one_rail(folder: Path) -> Path:
    """The headers of a machine, changed to have one rail."""
    if not folder.exists():
        folder.mkdir()
        for path in (GENERATED / SINGLE).glob("*.h"):
            text = re.sub(r"(#define TB_RAIL(?:S|_SLOTS)) \d+", r"\1 1", path.read_text())
            (folder / path.name).write_text(text)
    return folder


def _compiled(place: Path, own: Path, machine: Path) -> bytes | None:
    product = place.with_suffix(".o")
    product.unlink(missing_ok=True)
    runtime = [own, *(ROOT / "runtime" / name for name in ("core", "canopen", "can"))]
    includes = [f"-I{folder}" for folder in (*runtime, machine, GENERATED / STOCK)]
    command = ["gcc", "-std=c11", "-O1", "-w", *includes, "-c", place.name, "-o", product.name]
    subprocess.run(command, cwd=place.parent, capture_output=True, check=False)
    return product.read_bytes() if product.exists() else None
