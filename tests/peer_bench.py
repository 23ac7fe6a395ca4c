"""A small master that speaks to the drives by another hand, message by message, for their tests."""

from __future__ import annotations

import struct
from collections.abc import Sequence
from typing import Any

from peer_drives import (
    MILLISECOND,
    Bus,
    Drive,
    Frame,
    Library,
    Nmt,
    PeerDrives,
    Power,
    Timing,
    Variation,
)

START, STOP, PRE_OPERATIONAL, RESET_NODE, RESET_COMMUNICATION = 0x01, 0x02, 0x80, 0x81, 0x82
SHUTDOWN, SWITCH_ON, ENABLE, DISABLE_VOLTAGE, QUICK_STOP, FAULT_RESET = 6, 7, 15, 0, 2, 0x80
CST, CSP, HOMING = 10, 8, 6
FORMATS = {1: "<b", 2: "<h", 4: "<i"}
BYTES = {
    **dict.fromkeys((0x1029, 0x6060, 0x6061, 0x6098), 1),
    **dict.fromkeys((0x1017, 0x30B2, 0x6007, 0x6040, 0x6041, 0x605A, 0x605B, 0x605C), 2),
    **dict.fromkeys((0x605E, 0x6071, 0x6077, 0x603F, 0x60B2), 2),
}


class Refused(Exception):
    """An SDO transfer was aborted by the drive."""

    def __init__(self, code: int) -> None:
        super().__init__(f"{code:08X}")
        self.code = code


def drive(node: int = 1, bus: int = 0, **settings: Any) -> Drive:
    """A drive of 2000 counts, 3 A, 30 mN m/A; `settings` are fields of Drive."""
    plain: dict[str, Any] = {
        "counts_per_turn": 2000,
        "nominal_current": 3000,
        "current_limit": 6000,
        "torque_constant": 30_000,
        "vendor": 0xFB,
        "product": 0x61500000,
        "revision": 0x01700000,
        "rotor_inertia": 1.4e-5,
        "friction": 1e-5,
        "boot_delay": 10 * MILLISECOND,
    }
    return Drive(bus=bus, node=node, **{**plain, **settings})


def bytes_of(index: int, sub: int) -> int:
    if 0x1400 <= index < 0x1C00:
        mapping = index & 0x200
        return 4 if sub == 1 or (mapping and sub) else {2: 1, 3: 2, 0: 1}[sub]
    return BYTES.get(index, 1 if sub == 0 and index in (0x1003, 0x1016, 0x1018) else 4)


class Bench:
    """Drives, booted, and a master on each of their buses."""

    def __init__(
        self,
        library: Library,
        drives: Sequence[Drive] | None = None,
        timing: Timing | None = None,
        buses: Sequence[Bus] | None = None,
        boot: bool = True,
    ) -> None:
        self.drives = list(drives or [drive()])
        self.peer = PeerDrives(library, buses or [Bus(bit_rate=1_000_000)], self.drives, timing)
        self.heard: list[tuple[int, Frame]] = []
        if boot:
            self.wait(20)

    def wait(self, milliseconds: float) -> list[tuple[int, Frame]]:
        """Lets time pass; what arrived meanwhile."""
        self.peer.wait(round(milliseconds * MILLISECOND))
        return self.fetch()

    def fetch(self) -> list[tuple[int, Frame]]:
        buses = sorted({one.bus for one in self.drives})
        arrived = [item for bus in buses for item in self.peer.received(bus)]
        self.heard += arrived
        return arrived

    def frames(self, identifier: int) -> list[Frame]:
        """Frames of one identifier that ever arrived."""
        return [frame for _, frame in self.heard if frame.id == identifier]

    def send(self, identifier: int, data: bytes = b"", number: int = 0) -> None:
        assert self.peer.send(self.drives[number].bus, Frame(identifier, data))

    def nmt(self, command: int, node: int = 0, number: int = 0) -> None:
        self.send(0, bytes([command, node]), number)
        self.wait(1)

    def request(self, data: bytes, number: int = 0) -> bytes:
        """One SDO request and the drive's answer."""
        node = self.drives[number].node
        before = len(self.frames(0x580 + node))
        self.send(0x600 + node, data.ljust(8, b"\0"), number)
        for _ in range(500):
            self.wait(0.2)
            answers = self.frames(0x580 + node)[before:]
            if answers:
                assert len(answers) == 1
                return answers[0].data
        raise TimeoutError

    def read(self, index: int, sub: int = 0, number: int = 0, signed: bool = True) -> int:
        """An object that goes into one message."""
        answer = self.request(struct.pack("<BHB", 0x40, index, sub), number)
        if answer[0] == 0x80:
            raise Refused(int.from_bytes(answer[4:], "little"))
        assert answer[:4] == bytes([answer[0]]) + struct.pack("<HB", index, sub)
        assert answer[0] in (0x4F, 0x4B, 0x47, 0x43), "neither expedited nor with its size"
        return int.from_bytes(answer[4 : 8 - (answer[0] >> 2 & 3)], "little", signed=signed)

    def write(self, index: int, sub: int, value: int, number: int = 0) -> None:
        size = bytes_of(index, sub)
        data = (value & (1 << 8 * size) - 1).to_bytes(size, "little")
        command = 0x23 | (4 - size) << 2
        answer = self.request(struct.pack("<BHB", command, index, sub) + data, number)
        if answer[0] == 0x80:
            raise Refused(int.from_bytes(answer[4:], "little"))
        assert answer == struct.pack("<BHB", 0x60, index, sub) + bytes(4)

    def map_pdo(
        self, kind: str, n: int, type_: int, entries: Sequence[int], number: int = 0
    ) -> None:
        """The procedure of CiA 301 for the RPDO or TPDO n (1 to 4)."""
        node = self.drives[number].node
        base = {"rpdo": 0x1400, "tpdo": 0x1800}[kind] + n - 1
        identifier = {"rpdo": 0x100, "tpdo": 0x40000080}[kind] + 0x100 * n + node
        self.write(base, 1, identifier | 0x80000000, number)
        self.write(base, 2, type_, number)
        if kind == "tpdo":
            self.write(base, 3, 0, number)
        self.write(base + 0x200, 0, 0, number)
        for sub, entry in enumerate(entries, start=1):
            self.write(base + 0x200, sub, entry, number)
        self.write(base + 0x200, 0, len(entries), number)
        self.write(base, 1, identifier, number)

    def configure(self, mode: int = CST, number: int = 0) -> None:
        """RPDO1: controlword and target; TPDO1: statusword and position, both with every SYNC."""
        target = {CST: 0x60710010, CSP: 0x607A0020, HOMING: 0x60710010}[mode]
        node = self.drives[number].node
        for n in (2, 3, 4):
            self.write(0x1400 + n - 1, 1, 0x80000100 + 0x100 * n + node, number)
        self.map_pdo("rpdo", 1, 1, [0x60400010, target], number)
        self.map_pdo("tpdo", 1, 1, [0x60410010, 0x60640020], number)
        self.write(0x6060, 0, mode, number)

    def cycle(self, *outputs: bytes, period: float = 1.0) -> dict[int, Frame]:
        """One SYNC, then each drive's RPDO1; the frames that came, by identifier."""
        before = len(self.heard)
        self.send(0x80)
        for number, output in enumerate(outputs):
            self.send(0x200 + self.drives[number].node, output, number)
        self.wait(period)
        return {frame.id: frame for _, frame in self.heard[before:]}

    def command(self, controlword: int, target: int = 0, cycles: int = 4) -> int:
        """The same controlword for some cycles, to the first drive; its last statusword."""
        size = "<HI" if self.peer.object(0, 0x1600, 2) == 0x607A0020 else "<HH"
        mask = 0xFFFFFFFF if size == "<HI" else 0xFFFF
        for _ in range(cycles):
            self.cycle(struct.pack(size, controlword, target & mask))
        return self.status()

    def status(self) -> int:
        """The statusword in the newest TPDO1 of the first drive."""
        node = self.drives[0].node
        return int.from_bytes(self.frames(0x180 + node)[-1].data[:2], "little")

    def ready(self, mode: int = CST) -> Bench:
        """Configured and OPERATIONAL."""
        self.configure(mode)
        self.nmt(START)
        assert self.peer.nmt(0) == Nmt.OPERATIONAL
        return self

    def enabled(self, mode: int = CST) -> Bench:
        """In operation enabled with a target of zero, in CSP of the present position."""
        self.ready(mode)
        target = self.peer.object(0, 0x6064) if mode == CSP else 0
        for controlword in (SHUTDOWN, SWITCH_ON, ENABLE):
            self.command(controlword, target)
        assert self.peer.power(0) == Power.OPERATION_ENABLED
        return self


def varied(**settings: Any) -> Drive:
    """A drive with a variation."""
    return drive(variation=Variation(**settings))
