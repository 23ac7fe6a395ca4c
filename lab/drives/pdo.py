"""Process data of a simulated drive: mapping rules (CiA 301, 9.5), and what a SYNC does.

What an RPDO brought is held and applied at the next SYNC, after that SYNC's TPDOs were sampled: a
command of cycle k acts at SYNC k+1 and is seen in the TPDO of SYNC k+2.
"""

from collections.abc import Callable, Iterator
from operator import attrgetter
from struct import Struct

from canopen.sdo.exceptions import SdoAbortedError

from turnbuckle.lab.drives.node import NO_OBJECT, NO_SUBINDEX, NOT_ALLOWED, Frame, Objects
from turnbuckle.lab.drives.objects import MAPPED
from turnbuckle.model.bus.drive_kinds.entry import Entry, Key

INVALID = 1 << 31
NO_RTR = 1 << 30
EXTENDED = 1 << 29
SYNCHRONOUS = range(0, 241)

NOT_MAPPABLE = 0x06040041
TOO_MUCH_MAPPED = 0x06040042
UNSUPPORTED = 0x06010000

RPDO, TPDO = 0x1400, 0x1800
DEFAULT_PDOS = 4
"""PDOs each way that have identifiers and maps as delivered."""
MAP_BIT = 0x0200
"""Distance from a PDO's parameters to its mapping."""
DEFAULT_MAPS = {
    RPDO: (
        (0x60400010,),
        (0x60400010, 0x60600008),
        (0x60400010, 0x607A0020),
        (0x60400010, 0x60710010),
    ),
    TPDO: (
        (0x60410010,),
        (0x60410010, 0x60610008),
        (0x60410010, 0x60640020),
        (0x60410010, 0x606C0020),
    ),
}


def is_pdo_object(index: int) -> bool:
    """Whether an index configures PDOs."""
    return 0x1400 <= index < 0x1C00


def set_defaults(objects: Objects, node: int) -> None:
    """As delivered: every RPDO takes frames, which is why a master has to switch off the rest."""
    for number in range(objects.kind.pdos):
        has_default = number < DEFAULT_PDOS
        cob = 0x100 * number + node
        objects.put((RPDO + number, 1), 0x200 + cob if has_default else INVALID)
        valid = 0 if number == 0 else INVALID
        objects.put((TPDO + number, 1), NO_RTR | valid | (0x180 + cob if has_default else 0))
        for first, maps in DEFAULT_MAPS.items():
            _set_map(objects, (first | MAP_BIT) + number, maps[number] if has_default else ())


def _set_map(objects: Objects, index: int, mapping: tuple[int, ...]) -> None:
    for sub in range(1, MAPPED + 1):
        objects.put((index, sub), mapping[sub - 1] if sub <= len(mapping) else 0)
    objects.put((index, 0), len(mapping))


def check_write(objects: Objects, entry: Entry, value: int, pre_operational: bool) -> None:
    """Refuse, with SdoAbortedError, what the mapping rules forbid."""
    if not pre_operational:
        raise SdoAbortedError(objects.kind.simulated.wrong_state)
    index, sub = entry.key
    sends = index >= TPDO
    valid = not objects[index & ~MAP_BIT, 1] & INVALID
    if index & MAP_BIT:
        _check_map(objects, entry.key, value, valid, sends)
    elif sub == 1:
        _check_cob(objects[entry.key], value, sends)
    elif sub == 2:
        _check_type(value, sends)
    elif valid:  # inhibit time
        raise SdoAbortedError(UNSUPPORTED)


def _check_cob(before: int, value: int, sends: bool) -> None:
    """A valid PDO keeps its COB-ID; a new one is not a restricted one; nobody may ask for it."""
    cob = value & 0x7FF
    is_free = not is_restricted(cob) or value & ~NO_RTR == INVALID
    kept = before & INVALID or value & INVALID or (before ^ value) & 0x3FFFFFFF == 0
    answers_remote = sends and not value & NO_RTR
    if not kept or value & EXTENDED or answers_remote or not is_free:
        raise SdoAbortedError(NOT_ALLOWED)


def is_restricted(cob: int) -> bool:
    """Whether a COB-ID may not be a PDO's (CiA 301, table 35)."""
    return (
        cob <= 0x001
        or 0x101 <= cob <= 0x180
        or 0x581 <= cob <= 0x5FF
        or 0x601 <= cob <= 0x67F
        or cob in (0x080, 0x6E0)
        or cob >= 0x701
    )


def _check_type(value: int, sends: bool) -> None:
    if value not in SYNCHRONOUS and value not in ((252, 253, 254, 255) if sends else (254, 255)):
        raise SdoAbortedError(NOT_ALLOWED)


def _check_map(objects: Objects, key: Key, value: int, valid: bool, sends: bool) -> None:
    index, sub = key
    if valid:
        raise SdoAbortedError(UNSUPPORTED)
    if sub > 0:
        if objects[index, 0] != 0:
            raise SdoAbortedError(objects.kind.simulated.map_in_use)
        return
    if value > MAPPED:
        raise SdoAbortedError(NOT_ALLOWED)
    bits = 0
    for slot in range(1, value + 1):
        mapped = objects[index, slot]
        _check_mapped(objects, mapped, sends)
        bits += mapped & 0xFF
    if bits > 64:
        raise SdoAbortedError(TOO_MUCH_MAPPED)


def _check_mapped(objects: Objects, mapped: int, sends: bool) -> None:
    """A mapping entry is index, subindex and bits of an object that may be mapped that way."""
    entry = objects.entries.get(_key(mapped))
    if entry is None:
        known = mapped >> 16 in objects.dictionary.indices
        raise SdoAbortedError(NO_SUBINDEX if known else NO_OBJECT)
    mappable = entry.taken or (sends and entry.sent)
    if not mappable or 8 * entry.size != mapped & 0xFF:
        raise SdoAbortedError(NOT_MAPPABLE)


def _key(mapped: int) -> Key:
    return mapped >> 16, mapped >> 8 & 0xFF


class _Pdo:
    """One valid PDO, ready to run."""

    def __init__(self, objects: Objects, parameters: int) -> None:
        self.cob = objects[parameters, 1] & 0x7FF
        self.type = objects[parameters, 2]
        index = parameters | MAP_BIT
        self.mapped = [
            objects.entries[_key(objects[index, slot])] for slot in range(1, objects[index, 0] + 1)
        ]
        self.layout = Struct("<" + "".join(entry.kind for entry in self.mapped))


class ReceivePdo(_Pdo):
    """Takes values from a frame."""

    def __init__(self, objects: Objects, parameters: int) -> None:
        super().__init__(objects, parameters)
        self._objects = objects
        self._names = [entry.signal for entry in self.mapped]
        self._pending: bytes | None = None

    def take(self, data: bytes) -> bool:
        """Keep a frame until the next SYNC; False when it is too short."""
        if len(data) < self.layout.size:
            return False
        self._pending = data
        return True

    def apply(self) -> bool:
        """Set the objects; False when no frame came."""
        if self._pending is None:
            return False
        values = self.layout.unpack_from(self._pending)
        self._pending = None
        signals = self._objects.signals
        for name, entry, value in zip(self._names, self.mapped, values, strict=True):
            if name is None:
                self._objects.put(entry.key, value)
            else:
                setattr(signals, name, value)
        return True


class TransmitPdo(_Pdo):
    """Makes a frame of values."""

    def __init__(self, objects: Objects, parameters: int) -> None:
        super().__init__(objects, parameters)
        self.inhibit = objects[parameters, 3] * 1e-4  # s
        self._objects = objects
        self._syncs = 0
        self._sent_at = float("-inf")
        self._last = b""
        self._fetch = self._fetcher()

    def _fetcher(self) -> Callable[[], tuple[int, ...]]:
        names = [entry.signal for entry in self.mapped if entry.signal is not None]
        if len(names) < len(self.mapped) or len(names) < 2:
            mapped, objects = self.mapped, self._objects
            return lambda: tuple(objects[entry.key] for entry in mapped)
        get, signals = attrgetter(*names), self._objects.signals
        return lambda: get(signals)

    def sample(self) -> Frame:
        """The values of this moment."""
        return Frame(self.cob, self.layout.pack(*self._fetch()))

    def is_due(self) -> bool:
        """Whether a SYNC makes this PDO go out; call it once a SYNC."""
        if self.type == 0:
            return self._changed(self.sample().data)
        if self.type > 240:
            return False
        self._syncs += 1
        if self._syncs < self.type:
            return False
        self._syncs = 0
        return True

    def event(self, now: float) -> Frame | None:
        """The frame of an event-driven PDO when its values changed, not more often than allowed."""
        if now - self._sent_at < self.inhibit:
            return None
        frame = self.sample()
        if not self._changed(frame.data):
            return None
        self._sent_at = now
        return frame

    def _changed(self, data: bytes) -> bool:
        changed = data != self._last
        self._last = data
        return changed


class ProcessData:
    """All PDOs of a drive that are valid."""

    def __init__(self, objects: Objects) -> None:
        self._objects = objects
        self.receive: dict[int, ReceivePdo] = {}
        self._synchronous: list[ReceivePdo] = []
        self._transmit: list[TransmitPdo] = []
        self.events: list[TransmitPdo] = []

    def compile(self) -> None:
        """Take over what is configured; counters begin anew."""
        objects = self._objects
        receive = [ReceivePdo(objects, at) for at in _valid(objects, RPDO)]
        transmit = [TransmitPdo(objects, at) for at in _valid(objects, TPDO)]
        self.receive = {pdo.cob: pdo for pdo in receive}
        self._synchronous = [pdo for pdo in receive if pdo.type in SYNCHRONOUS]
        self._transmit = [pdo for pdo in transmit if pdo.type in SYNCHRONOUS]
        self.events = [pdo for pdo in transmit if pdo.type >= 254]

    def sample(self) -> list[Frame]:
        """What the drive sends at a SYNC."""
        return [pdo.sample() for pdo in self._transmit if pdo.is_due()]

    def apply(self) -> bool:
        """Apply what came since the last SYNC; whether there was anything."""
        applied = False
        for pdo in self._synchronous:
            applied = pdo.apply() or applied
        return applied


def _valid(objects: Objects, first: int) -> Iterator[int]:
    for index in range(first, first + objects.kind.pdos):
        if not objects[index, 1] & INVALID and objects[index | MAP_BIT, 0]:
            yield index
