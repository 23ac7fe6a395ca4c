"""Compares what has arrived at the drives by a SYNC with what was ordered since the one before."""

from collections.abc import Sequence

from turnbuckle.lab.bus_tap import (
    MOST_KEPT,
    POSITION_SETPOINT,
    RPDO,
    SYNC,
    TORQUE_SETPOINT,
    heard_from_master,
)
from turnbuckle.lab.drives.bus import SimulatedBus
from turnbuckle.lab.drives.node import Frame
from turnbuckle.model.bus.axis import Axis, axes
from turnbuckle.model.machine import Machine


class _Told:
    """What one drive was told since its last SYNC."""

    def __init__(self, axis: Axis) -> None:
        self.name, self.bus = axis.drive.name, axis.bus
        position = axis.drive.mode == "position"
        self.layout = POSITION_SETPOINT if position else TORQUE_SETPOINT
        self.unit = axis.metres_per_increment if position else axis.torque_per_unit
        self.value: int | None = None
        self.ordered: tuple[int, float] | None = None
        """Cycle and order that must have arrived by the next SYNC."""


class OrderWatch:
    """Of a machine at work: every order must arrive as it was given, by the next SYNC of its bus.

    Call it after every cycle. findings: what was wrong, in words; count: how often.
    """

    def __init__(self, machine: Machine, buses: list[SimulatedBus]) -> None:
        self.findings: list[str] = []
        self.count = 0
        self._told = [_Told(axis) for axis in axes(machine)]
        self._of_cob = {
            (axis.bus, RPDO + axis.drive.node): told
            for axis, told in zip(axes(machine), self._told, strict=True)
        }
        self._synced = [False] * len(buses)
        for number, bus in enumerate(buses):
            bus.listeners.append(heard_from_master(number, self._hear))

    def __call__(self, cycle: int, ordered: Sequence[float]) -> None:
        """A cycle is over, in which this was ordered [N m], or [m] of a drive in position mode."""
        for told, order in zip(self._told, ordered, strict=True):
            if self._synced[told.bus]:
                told.ordered = cycle, order
        self._synced = [False] * len(self._synced)

    def _compare(self, told: _Told, cycle: int, order: float) -> None:
        if told.value is None:
            self._find(f"cycle {cycle}: {told.name}: no setpoint arrived")
        elif not 0.0 <= abs(order) - abs(told.value * told.unit) < abs(told.unit):
            arrived = told.value * told.unit
            self._find(
                f"cycle {cycle}: {told.name}: {arrived:.6g} arrived, {order:.6g} was ordered"
            )

    def _hear(self, bus: int, frame: Frame) -> None:
        cob, data = frame
        if cob == SYNC:
            self._end_interval(bus)
            return
        told = self._of_cob.get((bus, cob))
        if told is not None and len(data) == told.layout.size:
            told.value = told.layout.unpack(data)[1]

    def _end_interval(self, bus: int) -> None:
        """A SYNC takes over what has arrived since the one before."""
        self._synced[bus] = True
        for told in self._told:
            if told.bus == bus:
                if told.ordered is not None:
                    self._compare(told, *told.ordered)
                told.value = None

    def _find(self, what: str) -> None:
        self.count += 1
        if len(self.findings) < MOST_KEPT:
            self.findings.append(what)
