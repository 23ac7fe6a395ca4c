"""Where what is in a process data object: the offsets that the runtime packs and reads with."""

from collections.abc import Iterator, Sequence

from turnbuckle.codegen.constants import Constant
from turnbuckle.model.bus.frames import COMMANDS, STATUS, Mapped, pdo_bytes


def process_data() -> list[Constant]:
    """Lengths of the frames and offsets of the objects in them."""
    found = list(places("STATUS", STATUS))
    for mode, mapped in COMMANDS.items():
        found += places(f"{mode.upper()}_COMMAND", mapped)
    return found


def places(frame: str, mapped: Sequence[Mapped]) -> Iterator[Constant]:
    """Those of one frame."""
    yield Constant(f"TB_{frame}_LENGTH", str(pdo_bytes(mapped)), "bytes")
    for number, entry in enumerate(mapped):
        meaning = f"byte of {entry.index:04X}h, {entry.size} bits"
        yield Constant(f"TB_{frame}_{entry.name.upper()}", str(pdo_bytes(mapped[:number])), meaning)
