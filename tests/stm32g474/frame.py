"""Classic CAN frames, and how many bits they are on the wire."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

#: Bits after the checksum: its delimiter, acknowledgement, its delimiter, end of frame.
TAIL = 10
#: Bits between frames.
GAP = 3
#: Bits from the acknowledgement's slot to the end of the frame.
AFTER_ACKNOWLEDGE = 8
POLYNOMIAL = 0x4599


@dataclass(frozen=True)
class Frame:
    """A data frame, or a remote frame that asks for `length` bytes."""

    identifier: int
    data: bytes = b""
    extended: bool = False
    remote: bool = False
    #: Length code of a remote frame; of a data frame the number of its bytes.
    length: int = -1

    def __post_init__(self) -> None:
        if not 0 <= self.identifier < 1 << (29 if self.extended else 11):
            raise ValueError(f"{self.identifier:#x} is no identifier")
        if len(self.data) > 8 or (self.remote and self.data):
            raise ValueError("a frame has at most 8 bytes, and a remote frame none")
        if self.length < 0:
            object.__setattr__(self, "length", len(self.data))
        if not 0 <= self.length <= 8 or (not self.remote and self.length != len(self.data)):
            raise ValueError(f"length {self.length} of {len(self.data)} bytes")

    @property
    def priority(self) -> tuple[int, int, int, int]:
        """The smaller one wins the bus: the bits of arbitration in order."""
        if self.extended:
            return self.identifier >> 18, 1, self.identifier & 0x3FFFF, int(self.remote)
        return self.identifier, 0, int(self.remote), 0


def _head(frame: Frame) -> str:
    """Bits from the start of the frame up to its data."""
    if frame.extended:
        base, rest = frame.identifier >> 18, frame.identifier & 0x3FFFF
        return f"0{base:011b}11{rest:018b}{frame.remote:b}00{frame.length:04b}"
    return f"0{frame.identifier:011b}{frame.remote:b}00{frame.length:04b}"


def checksum(bits: str) -> int:
    """CRC of 15 bits."""
    value = 0
    for bit in bits:
        value = (value << 1) ^ (POLYNOMIAL if (value >> 14 & 1) != (bit == "1") else 0)
        value &= 0x7FFF
    return value


def stuffed(bits: str) -> int:
    """Number of bits with a contrary one added after each five alike."""
    count, run, last = 0, 0, ""
    for bit in bits:
        run = run + 1 if bit == last else 1
        last = bit
        count += 1
        if run == 5:
            count += 1
            last = "1" if bit == "0" else "0"
            run = 1
    return count


@lru_cache(maxsize=4096)
def bits_of(frame: Frame) -> int:
    """Bits of this very frame from its start to its end."""
    bits = _head(frame) + "".join(f"{byte:08b}" for byte in frame.data)
    return stuffed(f"{bits}{checksum(bits):015b}") + TAIL


def worst_bits_of(frame: Frame) -> int:
    """Bits of the longest frame of this format and length."""
    plain = (54 if frame.extended else 34) + 8 * len(frame.data)
    return plain + (plain - 1) // 4 + TAIL
