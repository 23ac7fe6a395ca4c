"""Object code of a file of the runtime: a change that changes none of it is no mutant."""

import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).parents[3]
GENERATED = ROOT / "generated"
STOCK = "yoon2023"
#: Machines with rails and without, of two and six dimensions, with a force sensor and without.
MACHINES = (STOCK, "yoon_fixed_diagonal", "yoon_synchronised", "spidar_g")
SINGLE = "yoon_synchronised"
"""With one rail as well: some files ask how many there are."""


class Originals:
    """Object code of the runtime as it is, and of changes of it, by gcc -O1 for some machines.

    A machine that has no table of drives takes the stock machine's.
    """

    def __init__(self, folder: Path) -> None:
        """folder: for what is made."""
        self._folder = folder
        self._machines = [*(GENERATED / name for name in MACHINES), _with_one_rail(folder / SINGLE)]
        self._kept: dict[tuple[str, Path], bytes | None] = {}

    def differ(self, file: str, source: str, changed: str) -> bool:
        """Whether a change of a file of runtime/ compiles, and makes other code for a machine."""
        for machine in self._machines:
            key = file, machine
            if key not in self._kept:
                self._kept[key] = self._compiled(file, source, machine)
            original = self._kept[key]
            if original is not None:
                product = self._compiled(file, changed, machine)
                if product != original:
                    return product is not None
        return False

    def _compiled(self, file: str, source: str, machine: Path) -> bytes | None:
        place = self._folder / Path(file).name
        place.write_text(source)
        return _object_code(place, ROOT / "runtime" / Path(file).parent, machine)


def _with_one_rail(folder: Path) -> Path:
    """The headers of a machine, changed to have one rail."""
    if not folder.exists():
        folder.mkdir()
        for path in (GENERATED / SINGLE).glob("*.h"):
            text = re.sub(r"(#define TB_RAIL(?:S|_SLOTS)) \d+", r"\1 1", path.read_text())
            (folder / path.name).write_text(text)
    return folder


def _object_code(place: Path, own: Path, machine: Path) -> bytes | None:
    product = place.with_suffix(".o")
    product.unlink(missing_ok=True)
    runtime = [own, *(ROOT / "runtime" / name for name in ("core", "canopen", "can"))]
    includes = [f"-I{folder}" for folder in (*runtime, machine, GENERATED / STOCK)]
    command = ["gcc", "-std=c11", "-O1", "-w", *includes, "-c", place.name, "-o", product.name]
    subprocess.run(command, cwd=place.parent, capture_output=True, check=False)
    return product.read_bytes() if product.exists() else None
