"""What would fit in place of a bus that does not: tried, not guessed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from turnbuckle.model.bus.plan import Load, Timing, plans
from turnbuckle.model.bus.tables import BIT_RATES, Drive

SLOWEST_DIVIDER = 20


def alternatives(bus: Load, others: Sequence[Load], common: Timing) -> list[str]:
    """Ways out in words; `others` are the machine's buses that fit as they are."""
    return [
        *_fewer_drives(bus, others, common),
        *_slower_sync(bus, others, common),
        *_faster_bits(bus, others, common),
    ]


def _fits(buses: Sequence[Load], others: Sequence[Load], common: Timing) -> bool:
    return all(plan.fits for plan in plans([*buses, *others], common))


def _fewer_drives(bus: Load, others: Sequence[Load], common: Timing) -> Iterator[str]:
    rate = 1 / (common.cycle * bus.divider)
    for most in range(len(bus.drives) - 1, 0, -1):
        parts = [
            replace(bus, drives=bus.drives[first : first + most], nodes=() if first else bus.nodes)
            for first in range(0, len(bus.drives), most)
        ]
        if _fits(parts, others, common):
            yield f"{len(parts)} buses at {rate:g} Hz with at most {counted(parts[0].drives)} each"
            return


def _slower_sync(bus: Load, others: Sequence[Load], common: Timing) -> Iterator[str]:
    for divider in range(bus.divider + 1, SLOWEST_DIVIDER + 1):
        if _fits([replace(bus, divider=divider)], others, common):
            yield f"a rate of {1 / (common.cycle * divider):.6g} Hz"
            return


def _faster_bits(bus: Load, others: Sequence[Load], common: Timing) -> Iterator[str]:
    for bit_rate in BIT_RATES:
        if bit_rate > bus.bit_rate and _fits([replace(bus, bit_rate=bit_rate)], others, common):
            yield f"a bit_rate of {bit_rate / 1e3:g} kbit/s"
            return


def counted(drives: Sequence[Drive]) -> str:
    """So many drives, in words."""
    return "1 drive" if len(drives) == 1 else f"{len(drives)} drives"
