"""The network of the runtime with a python canopen drive for each of its drives, in lockstep."""

from collections.abc import Callable
from ctypes import CFUNCTYPE, addressof, byref, c_void_p, memset, sizeof
from typing import Any

from canopen_c import Canopen, Frame, canopen_c, read
from canopen_drive import Drive, rows
from canopen_peer import Wire

Tamper = Callable[[int, Frame], list[Frame]]


class Fieldbus:
    """The calls of a started network: tb_fieldbus_protocol."""

    def __init__(self, network: Any) -> None:
        self._network = network
        protocol: Any = (c_void_p * 3).from_address(network.fieldbus.protocol)
        self._sync = CFUNCTYPE(None, c_void_p)(protocol[0])
        self._collect, self._dispatch = (
            CFUNCTYPE(None, c_void_p, c_void_p)(call) for call in protocol[1:]
        )

    def sync(self) -> None:
        """The drives measure."""
        self._sync(addressof(self._network))

    def collect(self, seen: Any) -> None:
        """What they report goes to an observation."""
        self._collect(addressof(self._network), addressof(seen))

    def dispatch(self, orders: Any) -> None:
        """What they are ordered goes out."""
        self._dispatch(addressof(self._network), addressof(orders))


class Bench:
    """Three buses of eight drives; one `cycle` is a millisecond."""

    def __init__(self, library: Canopen | None = None) -> None:
        self.c = library or canopen_c()
        self.rows = rows(self.c)
        self.dividers = [bus.divider for bus in self.c.variable("tb_buses")]
        self.wires = [Wire() for _ in self.dividers]
        self.loops = [self.c.new("tb_loopback") for _ in self.dividers]
        for loop in self.loops:
            self.c.tb_loopback_open(byref(loop))
        self.drives = [Drive(self.wires[row.bus], row) for row in self.rows]
        self.network, self.seen = self.c.new("tb_network"), self.c.new("tb_observation")
        memset(addressof(self.network), 0xA5, sizeof(self.network))
        self.orders = self.c.new("tb_orders")
        self.orders.beat = 1
        ports = (c_void_p * len(self.loops))(*map(addressof, self.loops))
        self.start(ports)
        self.fieldbus = Fieldbus(self.network)
        self.answers: Tamper = lambda bus, frame: [frame]
        """What reaches the master of a frame that a drive sent."""
        self.synced: list[list[Frame]] = []
        """Frames of the master at the beginning of the last cycle, by bus."""
        self.dispatched: list[list[Frame]] = []
        """Frames of the master at its end."""

    def start(self, ports: Any) -> None:
        """Take over the ports."""
        self.c.tb_network_start(byref(self.network), ports)

    def tick(self) -> None:
        """A millisecond has passed for the drives."""
        for wire in self.wires:
            wire.tick()

    def cycle(self, count: int = 1) -> None:
        """Run some cycles."""
        for _ in range(count):
            self.sync()
            self.collect()
            self.dispatch()

    def sync(self) -> None:
        """SYNC, and what the drives answer to it."""
        self.tick()
        self.fieldbus.sync()
        self.synced = self.carry()

    def collect(self) -> None:
        """The observation."""
        self.fieldbus.collect(self.seen)

    def dispatch(self) -> None:
        """The orders; what is answered to them waits for the next cycle."""
        self.fieldbus.dispatch(self.orders)
        self.dispatched = self.carry()

    def give(self, bus: int, *frames: Frame) -> None:
        """Frames reach the master."""
        for frame in frames:
            self.c.tb_loopback_give(byref(self.loops[bus]), byref(self.c.frame(frame)))

    def carry(self) -> list[list[Frame]]:
        """What the master sent reaches the drives, and their answers reach it; by bus."""
        return [self._carry(bus) for bus in range(len(self.loops))]

    def _carry(self, bus: int) -> list[Frame]:
        sent, frame = [], self.c.new("tb_can_frame")
        while self.c.tb_loopback_take(byref(self.loops[bus]), byref(frame)) == self.c.TB_CAN_OK:
            sent.append(read(frame))
            self.wires[bus].give(sent[-1])
        for answer in self.wires[bus].take():
            self.give(bus, *self.answers(bus, answer))
        return sent

    def order(self, **fields: Any) -> None:
        """Order the same of all drives."""
        for drive in self.orders.drives:
            for name, value in fields.items():
                setattr(drive, name, value)

    def task(self, name: str, most: int = 3000, **fields: Any) -> int:
        """Let all drives do a task: how many cycles it took until the last one ended."""
        self.order(task=getattr(self.c, f"TB_TASK_{name}"), **fields)
        for count in range(most):
            self.cycle()
            if count and all(one.progress != self.c.TB_TASK_BUSY for one in self.seen.drives):
                return count
        raise AssertionError(f"{name} takes more than {most} cycles")

    def bring_up(self) -> None:
        """All drives operational, in torque mode, without power."""
        for name in ("RESET", "IDENTIFY", "CONFIGURE", "START"):
            self.task(name)
        self.task("MODE", mode=self.c.TB_MODE_TORQUE)
        assert {drive.progress for drive in self.seen.drives} == {self.c.TB_TASK_DONE}

    def enable(self) -> None:
        """All drives under torque."""
        self.bring_up()
        self.order(goal=self.c.TB_GOAL_ENABLED)
        self.cycle(20)
        assert {drive.power for drive in self.seen.drives} == {self.c.TB_POWER_ENABLED}
