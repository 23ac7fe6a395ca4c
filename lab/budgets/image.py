"""The image of a board: a machine's whole runtime and the loop of port/bare, and its call graph.

The functions of the board itself are left open: a board's own code and memory come on top.
"""

from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from elftools.elf.elffile import ELFFile

from turnbuckle.codegen.compile import run
from turnbuckle.lab.emulated.image import RECORDER
from turnbuckle.lab.emulated.processor import COMPILER, FIRMWARE, LINK, M4F
from turnbuckle.lab.lockstep import CAN, FOLDERS, PORTABLE_CAN
from turnbuckle.places import RUNTIME

BARE = RUNTIME / "port" / "bare"
OPEN = ("-Wl,--unresolved-symbols=ignore-all", "-Wl,-emain", f"-T{FIRMWARE / 'mps2.ld'}", "-lm")
IN_FLASH, IN_MEMORY = (".text", ".data"), (".data", ".bss")


@dataclass(frozen=True)
class Image:
    """What is built for the Cortex-M4F."""

    program: bytes
    """ELF."""
    graphs: tuple[str, ...]
    """Call graph of every source, as gcc writes it, with the stack of each function."""
    sections: dict[str, int]
    """Sizes [B]."""
    symbols: frozenset[str]
    """Names that are in the program, those of the board among them."""

    @property
    def flash(self) -> int:
        """Code, constants, and the values that variables begin with [B]."""
        return sum(self.sections.get(name, 0) for name in IN_FLASH)

    @property
    def memory(self) -> int:
        """Variables [B]."""
        return sum(self.sections.get(name, 0) for name in IN_MEMORY)


def bare_image(generated: Path, *flags: str) -> Image:
    """The image of a machine; flags: more of the compiler's. CompileError where there is none."""
    folders = [generated, *FOLDERS, BARE]
    sources = [path for folder in folders for path in sorted(folder.glob("*.c"))]
    options = [*M4F.flags, *RECORDER, "-fcallgraph-info=su", *flags]
    include = [f"-I{folder}" for folder in (*folders, CAN)]
    with TemporaryDirectory(prefix="turnbuckle-budget-") as folder:
        product = Path(folder) / "bare.elf"
        files = map(str, [*sources, *PORTABLE_CAN])
        dumps = ("-dumpdir", f"{folder}/")
        run(COMPILER, [*options, *dumps, *include, *files, *LINK, *OPEN], product)
        graphs = tuple(path.read_text() for path in sorted(Path(folder).glob("*.ci")))
        with product.open("rb") as stream:
            elf = ELFFile(stream)
            sections = {each.name: each["sh_size"] for each in elf.iter_sections()}
            table: Any = elf.get_section_by_name(".symtab")
            symbols = frozenset(each.name for each in table.iter_symbols())
        return Image(product.read_bytes(), graphs, sections, symbols)
