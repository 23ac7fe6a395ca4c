"""SDO server of a simulated drive: python `canopen`'s LocalNode over the objects of objects.py."""

from collections.abc import Callable
from typing import NamedTuple

import canopen
from canopen.sdo.exceptions import SdoAbortedError
from canopen.sdo.server import SdoServer

from turnbuckle.lab.drives.objects import Dictionary, Signals
from turnbuckle.model.bus.drive_kinds.entry import Entry, Key
from turnbuckle.model.bus.drive_kinds.kind import Motor, Place


class Frame(NamedTuple):
    """A classic CAN frame with 11 bits of identifier."""

    cob: int
    data: bytes


Send = Callable[[Frame], None]

READ_ONLY = 0x06010002
NO_OBJECT = 0x06020000
NO_SUBINDEX = 0x06090011
TOO_LONG, TOO_SHORT = 0x06070012, 0x06070013
NOT_ALLOWED, TOO_HIGH, TOO_LOW = 0x06090030, 0x06090031, 0x06090032
WRONG_STATE = 0x08000022
BAD_COMMAND = 0x05040001


class Objects:
    """The values of a drive's objects."""

    def __init__(self, dictionary: Dictionary) -> None:
        self.dictionary = dictionary
        self.kind = dictionary.kind
        self.entries = dictionary.entries
        self.signals = Signals()
        self.values: dict[Key, int | bytes] = {}
        self.restore(lambda index: True)

    def restore(self, chosen: Callable[[int], bool]) -> None:
        """Give the objects of the chosen indices their defaults."""
        for key, entry in self.entries.items():
            if chosen(entry.index):
                self.put(key, entry.default)

    def __getitem__(self, key: Key) -> int:
        """A number of the dictionary."""
        value = self.value(self.entries[key])
        assert isinstance(value, int)
        return value

    def held(self, place: Place, motor: Motor) -> float:
        """The quantity that an object holds, in its unit for a motor."""
        return self[place.key] * place.unit(motor)

    def option(self, index: int) -> int:
        """The number in an object that the drive need not have; 0 without it."""
        return self[index, 0] if (index, 0) in self.entries else 0

    def value(self, entry: Entry) -> int | bytes:
        """The value of an object."""
        if entry.signal is None:
            return self.values[entry.key]
        return int(getattr(self.signals, entry.signal))

    def put(self, key: Key, value: int | bytes) -> None:
        """Set an object, whatever a master may do."""
        signal = self.entries[key].signal
        if signal is None:
            self.values[key] = value
        else:
            setattr(self.signals, signal, value)


class _Wire(canopen.Network):
    """Hands the SDO server's answers on."""

    def __init__(self, send: Send) -> None:
        super().__init__()
        self._send = send

    def send_message(self, can_id: int, data: bytes, remote: bool = False) -> None:
        self._send(Frame(can_id, bytes(data)))


class _Server(SdoServer):
    """Answers what the library's server leaves open: requests out of order or without a size."""

    def __init__(self, rx_cobid: int, tx_cobid: int, node: "SdoNode") -> None:
        super().__init__(rx_cobid, tx_cobid, node)
        self._objects = node.objects
        self._index = self._subindex = 0

    def on_request(self, can_id: int, data: bytearray, timestamp: float) -> None:
        if data[0] & 0xE0 in (0x00, 0x60) and self._buffer is None:
            self.abort(BAD_COMMAND)
        else:
            super().on_request(can_id, data, timestamp)

    def init_download(self, request: bytearray) -> None:
        """An expedited download that does not tell its size has that of the object."""
        index, subindex = int.from_bytes(request[1:3], "little"), request[3]
        entry = self._objects.entries.get((index, subindex))
        if request[0] & 0x03 == 0x02 and entry is not None:
            request = bytearray(request)
            request[0] |= 0x01 | (4 - entry.size) << 2
        super().init_download(request)


class SdoNode(canopen.LocalNode):
    """A drive's SDO server.

    check(entry, value) may refuse a write with SdoAbortedError; written(entry, value) is told of
    every write that was done; refresh() is called before a read.
    """

    def __init__(
        self,
        node_id: int,
        objects: Objects,
        send: Send,
        *,
        check: Callable[[Entry, int], None],
        written: Callable[[Entry, int], None],
        refresh: Callable[[], None],
    ) -> None:
        super().__init__(node_id, objects.dictionary.canopen)
        self.objects = objects
        self.refusals: dict[Key, int] = {}
        """Objects whose access is refused, and with which abort code."""
        self._check, self._written, self._refresh = check, written, refresh
        self.sdo = _Server(0x600 + node_id, 0x580 + node_id, self)
        self.sdo.network = _Wire(send)

    def request(self, data: bytes) -> None:
        """An SDO request arrived; one that is not 8 bytes long is none."""
        if len(data) == 8:
            self.sdo.on_request(self.sdo.rx_cobid, bytearray(data), 0.0)

    def get_data(self, index: int, subindex: int, check_readable: bool = False) -> bytes:
        entry = self._entry(index, subindex)
        self._refresh()
        return entry.encode(self.objects.value(entry))

    def set_data(
        self, index: int, subindex: int, data: bytes, check_writable: bool = False
    ) -> None:
        entry = self._entry(index, subindex)
        if entry.access != "rw":
            raise SdoAbortedError(READ_ONLY)
        if len(data) != entry.size:
            raise SdoAbortedError(TOO_LONG if len(data) > entry.size else TOO_SHORT)
        value = entry.decode(bytes(data))
        check_range(entry, value)
        self._check(entry, value)
        self.objects.put(entry.key, value)
        self._written(entry, value)

    def _entry(self, index: int, subindex: int) -> Entry:
        entry = self.objects.entries.get((index, subindex))
        if entry is None:
            known = index in self.objects.dictionary.indices
            raise SdoAbortedError(NO_SUBINDEX if known else NO_OBJECT)
        if entry.key in self.refusals:
            raise SdoAbortedError(self.refusals[entry.key])
        return entry


def check_range(entry: Entry, value: int) -> None:
    """Refuse a value that an object cannot hold."""
    if entry.choices is not None and value not in entry.choices:
        raise SdoAbortedError(NOT_ALLOWED)
    lowest, highest = entry.bounds()
    if not lowest <= value <= highest:
        raise SdoAbortedError(TOO_HIGH if value > highest else TOO_LOW)
