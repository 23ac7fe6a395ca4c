"""An object of a drive's dictionary: its type, who may do what with it, its range and default."""

from collections.abc import Iterator
from dataclasses import dataclass
from struct import Struct

Key = tuple[int, int]
"""Index and subindex."""
WIDEST = {"B": 0xFF, "H": 0xFFFF, "I": 0xFFFFFFFF}
SIGNED = {"b": 7, "h": 15, "i": 31}


@dataclass(frozen=True)
class Entry:
    """One object: `kind` is its type as a letter of `struct`, "s" for a string."""

    index: int
    subindex: int
    name: str
    kind: str
    access: str  # ro, rw, const
    default: int | bytes = 0
    lowest: int | None = None
    highest: int | None = None
    choices: tuple[int, ...] | None = None
    taken: bool = False  # an RPDO may map it, and a TPDO
    sent: bool = False  # a TPDO may map it
    power_off: bool = False  # written only while the power stage is off
    signal: str | None = None  # attribute of the simulated drive's Signals

    @property
    def key(self) -> Key:
        """Index and subindex."""
        return self.index, self.subindex

    @property
    def size(self) -> int:
        """Bytes; 0 for a string."""
        return 0 if self.kind == "s" else Struct("<" + self.kind).size

    def encode(self, value: int | bytes) -> bytes:
        """The value as it goes over the bus."""
        return value if isinstance(value, bytes) else Struct("<" + self.kind).pack(value)

    def decode(self, data: bytes) -> int:
        """The number that came over the bus."""
        return int(Struct("<" + self.kind).unpack(data)[0])

    def bounds(self) -> tuple[int, int]:
        """Smallest and largest value that may be written."""
        bits = SIGNED.get(self.kind)
        low, high = (0, WIDEST[self.kind]) if bits is None else (-(1 << bits), (1 << bits) - 1)
        return (
            low if self.lowest is None else self.lowest,
            high if self.highest is None else self.highest,
        )


def array(
    index: int,
    name: str,
    kind: str,
    access: str,
    defaults: list[int],
    *,
    count_access: str = "const",
    count: int | None = None,
    lowest: int | None = None,
    highest: int | None = None,
    sent: bool = False,
) -> Iterator[Entry]:
    """The number of entries in subindex 0, then entries of one type."""
    size = len(defaults) if count is None else count
    yield Entry(index, 0, "number of entries", "B", count_access, size)
    for sub, default in enumerate(defaults, start=1):
        yield Entry(index, sub, f"{name} {sub}", kind, access, default, lowest, highest, sent=sent)
