"""python canopen's nodes as peers of the runtime: no thread, no clock, frame in, frame out."""

from collections.abc import Callable
from typing import Any

import canopen
from canopen.objectdictionary import ODArray, ODRecord, ODVariable, datatypes
from canopen_c import Frame

SIGNED = {1: datatypes.INTEGER8, 2: datatypes.INTEGER16, 4: datatypes.INTEGER32}
UNSIGNED = {1: datatypes.UNSIGNED8, 2: datatypes.UNSIGNED16, 4: datatypes.UNSIGNED32}

# python canopen leaves some of its functions without types.
empty_dictionary: Any = canopen.ObjectDictionary

Change = Callable[[Frame], Frame | None]


class Wire(canopen.Network):
    """A bus of python canopen's: what its nodes send is kept until it is taken."""

    def __init__(self) -> None:
        super().__init__()
        self.sent: list[Frame] = []
        self.periodic: list[Periodic] = []

    def send_message(self, can_id: int, data: Any, remote: bool = False) -> None:
        """A node sends."""
        self.sent.append(Frame(can_id, bytes(data)))

    def send_periodic(self, can_id: int, data: Any, period: float, remote: bool = False) -> Any:
        """A node begins to send again and again; see tick."""
        task = Periodic(self, can_id, bytes(data), max(round(period * 1000), 1))
        self.periodic.append(task)
        return task

    def tick(self) -> None:
        """A millisecond has passed."""
        for task in list(self.periodic):
            task.tick()

    def give(self, frame: Frame) -> None:
        """A frame reaches the nodes."""
        self.notify(frame.id, bytearray(frame.data), 0.0)

    def take(self) -> list[Frame]:
        """What the nodes sent since."""
        taken, self.sent = self.sent, []
        return taken


class Periodic:
    """A message sent every so many milliseconds."""

    def __init__(self, wire: Wire, can_id: int, data: bytes, period: int) -> None:
        self._wire, self._id, self._data, self._period, self._left = wire, can_id, data, period, 0

    def tick(self) -> None:
        """A millisecond has passed."""
        self._left = (self._left or self._period) - 1
        if self._left == 0:
            self._wire.send_message(self._id, self._data)

    def update(self, data: Any) -> None:
        """Send something else from now on."""
        self._data = bytes(data)

    def stop(self) -> None:
        """Send it no more."""
        self._wire.periodic.remove(self)


def variable(index: int, subindex: int, data_type: int, access: str = "rw") -> ODVariable:
    """An object."""
    made = ODVariable(f"{index:04X}:{subindex}", index, subindex)
    made.data_type, made.access_type = data_type, access
    return made


def dictionary(*variables: ODVariable) -> canopen.ObjectDictionary:
    """Objects of a node; those with subindices are records."""
    made: canopen.ObjectDictionary = empty_dictionary()
    with_parts = {one.index for one in variables if one.subindex}
    for one in variables:
        if one.index not in with_parts:
            made.add_object(one)
            continue
        if one.index not in made:
            made.add_object(ODRecord(f"{one.index:04X}", one.index))
        record = made[one.index]
        assert isinstance(record, ODRecord | ODArray)
        record.add_member(one)
    return made
