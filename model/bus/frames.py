"""The frames on a bus: who sends them, how long they are, how often they come at most."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from model.bus.tables import Drive

if TYPE_CHECKING:
    pass

# CiA 301 tables 33, 34: COB-IDs of node 0.
SYNC, EMCY, TPDO, RPDO, SDO_ANSWER, SDO_REQUEST, HEARTBEAT = (
    0x080,
    0x080,
    0x180,
    0x200,
    0x580,
    0x600,
    0x700,
)


@dataclass(frozen=True)
class Mapped:
    """An object in a PDO; size [bits]."""

    name: str
    index: int
    size: int
    signed: bool

    @property
    def code(self) -> int:
        """The entry of the mapping object (CiA 301 section 9.5)."""
        return self.index << 16 | self.size


CONTROLWORD = Mapped("controlword", 0x6040, 16, False)
STATUSWORD = Mapped("statusword", 0x6041, 16, False)
TARGET_TORQUE = Mapped("target_torque", 0x6071, 16, True)
TARGET_POSITION = Mapped("target_position", 0x607A, 32, True)
POSITION = Mapped("position", 0x6064, 32, True)
TORQUE = Mapped("torque", 0x6077, 16, True)


def rpdo_map(drive: Drive) -> tuple[Mapped, ...]:
    """What the master sends to a drive with every SYNC."""
    target = TARGET_POSITION if drive.mode == "position" else TARGET_TORQUE
    return CONTROLWORD, target


def tpdo_map(drive: Drive) -> tuple[Mapped, ...]:
    """What a drive answers to every SYNC."""
    return STATUSWORD, POSITION, TORQUE
