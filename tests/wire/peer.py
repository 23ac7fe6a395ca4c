"""Python `canopen` as master of simulated drives, and motors on a bench for them to turn."""

from collections.abc import Callable
from struct import pack, unpack

import canopen
import pytest
from canopen.sdo.exceptions import SdoAbortedError

from turnbuckle.lab.drives.bus import SimulatedBus
from turnbuckle.lab.drives.drive import Drive
from turnbuckle.lab.drives.node import Frame
from turnbuckle.lab.drives.objects import dictionary
from turnbuckle.lab.drives.setup import Ratings, Setup
from turnbuckle.model.bus.drive_kinds import epos4

PERIOD = 0.001
RATINGS = Ratings()
OBJECTS = dictionary(epos4.KIND)
MAP_TORQUE = [
    (0x1400, 1, 0x80000200), (0x1400, 2, 1), (0x1600, 0, 0), (0x1600, 1, 0x60400010),
    (0x1600, 2, 0x60710010), (0x1600, 0, 2), (0x1400, 1, 0x200),
    (0x1401, 1, 0x80000300), (0x1402, 1, 0x80000400), (0x1403, 1, 0x80000500),
    (0x1800, 1, 0xC0000180), (0x1800, 2, 1), (0x1A00, 0, 0), (0x1A00, 1, 0x60410010),
    (0x1A00, 2, 0x60640020), (0x1A00, 3, 0x60770010), (0x1A00, 0, 3), (0x1800, 1, 0x40000180),
]  # fmt: skip
"""Set-up of the PDOs that the runtime uses; COB-IDs of node 0."""
COB_IDS = (0x1400, 0x1401, 0x1402, 0x1403, 0x1800)


class Rotor:
    """A motor's rotor on the bench, with friction and, if wanted, a mechanical stop."""

    def __init__(self, stop: float | None = None) -> None:
        self.angle = self.speed = 0.0
        self.stop = stop

    def turn(self, torque: float, seconds: float) -> None:
        """Let a torque [N m] act."""
        acceleration = (torque - 2e-5 * self.speed) / RATINGS.inertia
        self.speed += acceleration * seconds
        self.angle += self.speed * seconds
        if self.stop is not None and (self.angle - self.stop) * self.stop > 0.0:
            self.angle, self.speed = self.stop, 0.0


class Bench:
    """Drives with rotors on one bus; a Simulation for the runner."""

    def __init__(self, *nodes: int, stop: float | None = None) -> None:
        self.period = PERIOD
        self.bus = SimulatedBus("bench", [Setup(node) for node in nodes or (1,)])
        self.buses = [self.bus]
        self.rotors = [Rotor(stop) for _ in self.bus.drives]

    @property
    def drive(self) -> Drive:
        """The first drive."""
        return self.bus.drives[0]

    def advance(self) -> None:
        """One cycle."""
        for drive, rotor in zip(self.bus.drives, self.rotors, strict=True):
            rotor.turn(drive.step(PERIOD), PERIOD)
            drive.turn(rotor.angle, PERIOD)
        self.bus.next_cycle()

    def wait(self, seconds: float) -> list[Frame]:
        """Let time pass; what the drives sent meanwhile."""
        frames = self.bus.take()
        for _ in range(round(seconds / PERIOD)):
            self.advance()
            frames += self.bus.take()
        return frames

    def wait_for(self, done: Callable[[], bool], seconds: float) -> None:
        """Let time pass until something is so."""
        for _ in range(round(seconds / PERIOD)):
            if done():
                return
            self.advance()
        raise AssertionError(f"not within {seconds} s")

    def send(self, cob: int, data: bytes = b"") -> list[Frame]:
        """Send a frame; what it is answered with."""
        self.bus.send(Frame(cob, data))
        return self.bus.take()

    def sync(self) -> list[Frame]:
        """One SYNC and the cycle that follows; what it is answered with."""
        answers = self.send(0x080)
        self.advance()
        return answers

    def nmt(self, command: int, node: int = 0) -> list[Frame]:
        """An NMT command."""
        return self.send(0x000, bytes([command, node]))


class DirectNetwork(canopen.Network):
    """Python `canopen` on the simulated bus itself: no thread, no time."""

    def __init__(self, bus: SimulatedBus) -> None:
        super().__init__()
        self._simulated = bus

    def send_message(self, can_id: int, data: bytes, remote: bool = False) -> None:
        self._simulated.send(Frame(can_id, bytes(data)))
        for answer in self._simulated.take():
            self.notify(answer.cob, bytearray(answer.data), 0.0)


def booted(*nodes: int, stop: float | None = None) -> Bench:
    """Drives that have just booted."""
    bench = Bench(*nodes, stop=stop)
    bench.wait(0.3)
    return bench


def remote(bench: Bench, node: int = 1) -> canopen.RemoteNode:
    """A drive as python `canopen` sees it."""
    return DirectNetwork(bench.bus).add_node(node, OBJECTS.canopen)


def write(node: canopen.RemoteNode, index: int, subindex: int, value: int) -> None:
    """Write an object by SDO."""
    variable = node.sdo[index][subindex] if _is_record(index) else node.sdo[index]
    variable.raw = value


def read(node: canopen.RemoteNode, index: int, subindex: int = 0) -> int:
    """Read an object by SDO."""
    variable = node.sdo[index][subindex] if _is_record(index) else node.sdo[index]
    return int(variable.raw)


def abort_code(action: Callable[[], object]) -> int:
    """The code with which an SDO transfer is aborted."""
    with pytest.raises(SdoAbortedError) as aborted:
        action()
    return int(aborted.value.code)


def map_torque(node: canopen.RemoteNode) -> None:
    """Set the PDOs up as the runtime does."""
    for index, subindex, value in MAP_TORQUE:
        is_cob_id = index in COB_IDS and subindex == 1
        write(node, index, subindex, value + (node.id or 0 if is_cob_id else 0))


def running(bench: Bench, mode: int = 10) -> canopen.RemoteNode:
    """A drive with PDOs set up, operational, in a mode."""
    node = remote(bench, bench.drive.node)
    map_torque(node)
    write(node, 0x6060, 0, mode)
    bench.nmt(1)
    bench.wait(0.002)
    return node


def command(bench: Bench, controlword: int, torque: int = 0) -> int:
    """Send controlword and torque; the statusword once it shows what they did."""
    bench.send(0x200 + bench.drive.node, pack("<Hh", controlword, torque))
    bench.sync()
    return status(bench.sync())[0]


def status(frames: list[Frame]) -> tuple[int, int, int]:
    """Statusword, position and torque of the one status message among the frames."""
    (frame,) = (frame for frame in frames if 0x181 <= frame.cob <= 0x1FF)
    word, position, torque = unpack("<HiH", frame.data)
    return word, position, torque


def enable(bench: Bench) -> None:
    """From switch on disabled to operation enabled."""
    for word in (0x06, 0x07, 0x0F):
        last = command(bench, word)
    assert last & 0x6F == 0x27


def _is_record(index: int) -> bool:
    return isinstance(OBJECTS.canopen[index], canopen.objectdictionary.ODRecord)
