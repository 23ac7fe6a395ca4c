"""A drive for tests of the network: python canopen's node with the objects that a contract names.

It boots, is configured, maps its PDOs as it was told, beats, follows CiA 402 and answers SYNC: the
setpoint of a SYNC is the one that arrived before it. Its motor stands still.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import canopen
from canopen_c import Canopen
from canopen_peer import SIGNED, UNSIGNED, Wire, dictionary, variable
from cia402_machine import STATUSWORDS, Machine

SIZES = {0x6040: 2, 0x6041: 2, 0x6060: 1, 0x6061: 1, 0x6064: 4, 0x6071: 2, 0x6077: 2, 0x607A: 4}
"""Objects that a contract need not name -> bytes."""
MEASURED = {0x6064, 0x6071, 0x6077, 0x607A}
"""Objects that may be negative."""
MAPPINGS = [*range(0x1600, 0x1604), *range(0x1A00, 0x1A04)]

# python canopen leaves some of its functions without types.
local_node: Any = canopen.LocalNode

Key = tuple[int, int]


@dataclass(frozen=True)
class Entry:
    """An object of a drive's tables."""

    index: int
    subindex: int
    size: int
    writes: bool
    value: int


@dataclass(frozen=True)
class Row:
    """A drive of the machine, as tb_drives.c has it."""

    number: int
    bus: int
    node: int
    identity: list[Entry]
    contract: list[Entry]
    table: Any


def rows(library: Canopen) -> list[Row]:
    """All drives of the machine."""
    tables = library.variable("tb_drives")
    return [
        Row(
            number,
            table.bus,
            table.node,
            entries(library, table, table.identity, table.identity_count),
            entries(library, table, table.contract, table.contract_count),
            table,
        )
        for number, table in enumerate(tables)
    ]


def entries(library: Canopen, drive: Any, address: int, count: int) -> list[Entry]:
    """Objects of one of a drive's tables."""
    objects = (library.tb_object * count).from_address(address)
    node = {library.TB_OBJECT_WRITE_OF_NODE: drive.node}
    return [
        Entry(o.index, o.subindex, o.size, bool(o.action), o.value + node.get(o.action, 0))
        for o in objects
    ]


class Drive:
    """A drive on a wire."""

    def __init__(self, wire: Wire, row: Row) -> None:
        sizes = {(index, 0): size for index, size in SIZES.items()}
        sizes |= {(index, 1): 4 for index in MAPPINGS}
        sizes |= {(e.index, e.subindex): e.size for e in [*row.identity, *row.contract]}
        self.node = local_node(row.node, objects(sizes))
        self.wire, self.row = wire, row
        self.written: list[tuple[Key, int]] = []
        self.read: Callable[[Key, int], int] = lambda key, value: value
        """What the drive answers for an object that holds a value."""
        self.position, self.torque, self.homed = 0, 0, 0
        self.setpoints: list[tuple[int, int]] = []
        """Every controlword and target that arrived."""
        self.applied: list[tuple[int, int]] = []
        """The same of every SYNC."""
        self.power_at_boot = "OFF"
        self._waiting: tuple[int, int] | None = None
        self.sizes = sizes
        self.wire.add_node(self.node)
        self.node.add_read_callback(self._on_read)
        self.node.add_write_callback(self._on_write)
        self.wire.subscribe(0x000, self._on_command)
        self.wire.subscribe(0x080, self._on_sync)
        self.node.rpdo[1].add_callback(self._on_setpoint)
        self.boot()
        self.wire.take()  # it was on before anyone listened

    @property
    def is_operational(self) -> bool:
        """Whether it sends and takes PDOs."""
        return bool(self.node.nmt.state == "OPERATIONAL")

    @property
    def mode(self) -> int:
        """Object 6060h."""
        return int(self.node.data_store[0x6060][0][0])

    @property
    def statusword(self) -> int:
        """What it says of itself."""
        bits = STATUSWORDS[self.machine.power] & ~(0 if self.is_operational else 0x0200)
        return bits | (self.homed if self.machine.controlword & 0x10 else 0)

    def boot(self) -> None:
        """As after power-on or a reset of the communication."""
        self._forget()
        self.node.nmt.stop_heartbeat()
        self.node.nmt.state = "INITIALISING"
        self.node.nmt.state = "PRE-OPERATIONAL"

    def _forget(self) -> None:
        self.machine = Machine(self.power_at_boot)
        self._waiting = None
        self.node.data_store.clear()
        for (index, subindex), size in self.sizes.items():
            self.node.data_store.setdefault(index, {})[subindex] = bytes(size)
        for entry in self.row.identity:
            self._store(entry)

    def _store(self, entry: Entry) -> None:
        data = entry.value.to_bytes(entry.size, "little")
        self.node.data_store[entry.index][entry.subindex] = data

    def _on_read(self, index: int, subindex: int, od: Any) -> int:
        held = self.node.data_store[0x6060 if index == 0x6061 else index][subindex]
        return self.read((index, subindex), int.from_bytes(held, "little"))

    def _on_write(self, index: int, subindex: int, od: Any, data: bytes) -> None:
        self.written.append(((index, subindex), int.from_bytes(data, "little")))

    def _on_command(self, can_id: int, data: bytearray, time: float) -> None:
        command, node = data[0], data[1]
        if node not in (0, self.row.node):
            return
        if command in (0x81, 0x82):
            self.boot()
        elif command == 0x01:
            self.node.tpdo[1].read()
            self.node.rpdo[1].read()

    def _on_setpoint(self, received: Any) -> None:
        if self.is_operational:
            controlword, target = received.map
            self._waiting = (controlword.raw, target.raw)
            self.setpoints.append(self._waiting)

    def _on_sync(self, can_id: int, data: bytearray, time: float) -> None:
        if not self.is_operational:
            return
        values = {0x6041: self.statusword, 0x6064: self.position, 0x6077: self.torque}
        for mapped in self.node.tpdo[1].map:
            mapped.raw = values[mapped.index]
        self.node.tpdo[1].transmit()
        if self._waiting is not None:
            self.machine.take(self._waiting[0])
            self.applied.append(self._waiting)


def objects(sizes: dict[Key, int]) -> canopen.ObjectDictionary:
    """A dictionary of unsigned objects; those of PDOs and heartbeat among them."""
    with_parts = {index for index, subindex in sizes if subindex}
    needed = {(index, 0): 1 for index in with_parts} | sizes
    types = {key: (SIGNED if key[0] in MEASURED else UNSIGNED) for key in needed}
    made = [variable(*key, types[key][size]) for key, size in sorted(needed.items())]
    return dictionary(*made)
