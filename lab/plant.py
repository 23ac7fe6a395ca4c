"""What the bench asks of a plant: a machine's physics, whatever its kind.

`plants.py` lists the plants there are. The table [plant] of a machine file, which tells them masses
and friction, is `model.machine.Plant`.
"""

from collections.abc import Sequence
from typing import Protocol

from turnbuckle.model.base import Coordinates

LOWEST_RATE = 8000.0
"""Integration steps per second, at least [Hz]."""


class Holder(Protocol):
    """Whoever holds the handle."""

    mass: float
    """Mass that moves with the handle [kg]."""

    def push(self, time: float, pose: Coordinates, twist: Coordinates) -> Coordinates:
        """Wrench (d) [N, N m] that moves hand and handle together, at a pose (d) [m, rad] and a
        twist (d) [m/s, rad/s]."""


class SimulatedPlant(Protocol):
    """The physics of a machine, advanced one control cycle at a time. d degrees of freedom, n
    cables, m rails."""

    @property
    def time(self) -> float:
        """Until when time has passed [s]."""

    @property
    def position(self) -> Coordinates:
        """Pose (d) of the handle [m], then for rigid platforms its angle or rotation vector
        [rad]."""

    @property
    def velocity(self) -> Coordinates:
        """Twist (d) of the handle [m/s, rad/s], in the fixed frame."""

    @property
    def cable_force(self) -> Coordinates:
        """Wrench (d) of the cables on the handle [N, N m]."""

    @property
    def hand_force(self) -> Coordinates:
        """Wrench (d) of the hand on the handle [N, N m]."""

    @property
    def lengths(self) -> list[float]:
        """Cable lengths [m] (n) as the motors measure them; a slack cable is longer than the
        distance it spans."""

    @property
    def slack(self) -> list[float]:
        """Cable [m] (n) that is paid out and not needed; of a broken one any value."""

    @property
    def rails(self) -> list[float]:
        """Rail coordinates [m] (m)."""

    @property
    def tensions(self) -> list[float]:
        """True cable tensions [N] (n)."""

    @property
    def lowest_tension(self) -> float:
        """The least of any cable within the last cycle [N]."""

    @property
    def highest_tension(self) -> float:
        """The largest of any cable within the last cycle [N]."""

    def advance(self, torques: Sequence[float], rail_forces: Sequence[float]) -> None:
        """Run one control cycle; torques [N m] (n) of the motors, rail_forces [N] (m)."""

    def break_cable(self, cable: int) -> None:
        """Cut a cable, counted from 0: its motor has nothing to pull from here on."""

    def hook_cable(self, cable: int, detour: float) -> None:
        """Let something catch a cable, counted from 0, and hold it aside: so much of it [m] is
        pulled off its drum, which is held, and the handle feels none of its tension."""
