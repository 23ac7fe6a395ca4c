"""The tables of a machine file about buses, drives, their motors, and supervision; SI units.

Object numbers in the text are those of CiA 301 and CiA 402; those of a kind of drive are in
drive_kinds.
"""

from typing import Annotated, Literal

from pydantic import Field

from turnbuckle.model.bus.drive_kinds import DEFAULT
from turnbuckle.model.quantity import (
    Acceleration,
    BitRate,
    Current,
    Delay,
    Duration,
    Frequency,
    Length,
    LengthOrZero,
    Speed,
    TorqueConstant,
    TorqueRate,
    Whole,
)
from turnbuckle.model.table import Table
from turnbuckle.model.words import DriveKindName, Identifier

#: Bit rates of CiA 301 [bit/s].
BIT_RATES = (10e3, 20e3, 50e3, 125e3, 250e3, 500e3, 800e3, 1e6)
MASTER = "master"
#: CiA 301 table 34: boot-up message and heartbeat; a node adds its number.
ERROR_CONTROL = 0x700
MOST_NODE = 126
MASTER_NODE = 127
#: Sweep of bases where the file does not say [m].
LONGEST_SWEEP = 0.1
Node = Annotated[int, Whole("a node number", 1, MOST_NODE)]
Unsigned32 = Annotated[int, Whole("an unsigned number of 32 bits", 0, 0xFFFF_FFFF)]
Counts = Annotated[int, Whole("counts of an encoder", 4, 4_000_000)]
Samples = Annotated[int, Whole("a number of measurements", 4, 200)]
Identifier11 = Annotated[int, Whole("an identifier of 11 bits", 1, 0x7FF)]
Bytes = Annotated[int, Whole("the bytes of a CAN frame", 0, 8)]
Cycles = Annotated[int, Whole("a number of cycles", 0, 250)]


class Bus(Table):
    """A CAN bus."""

    name: Identifier = Field(description="name of the bus")
    bit_rate: BitRate = Field(description="bit rate, one of CiA 301 [bit/s]")
    rate: Frequency = Field(
        description="SYNC messages per second, a whole fraction of control.rate [Hz]"
    )


class Drive(Table):
    """A drive on a bus; `base_<n>` moves rail coordinate n, counted from 1."""

    name: Identifier = Field(description="a cable's drive, or base_1, base_2 ... of the rails")
    bus: Identifier = Field(description="name of the bus it is on")
    node: Node = Field(description=f"its number on the bus; the master is {MASTER_NODE}")
    kind: DriveKindName = Field(DEFAULT, description="the kind of drive that it is")
    product: Unsigned32 | None = Field(
        None, description="product code (1018:2) that it must have; any without this key"
    )
    revision: Unsigned32 | None = Field(
        None, description="revision (1018:3) that it must have; any without this key"
    )
    direction: Literal["forward", "reverse"] = Field(
        "forward",
        description="forward where a positive turn winds cable in or raises the rail coordinate",
    )
    mode: Literal["torque", "position"] = Field(
        "torque",
        description="torque (CST), or for bases position (CSP): what it follows at work",
    )


class NodeFrame(Table):
    """A frame that a node other than a drive sends."""

    id: Identifier11 = Field(description="its identifier (COB-ID)")
    length: Bytes = Field(description="bytes of data, at most")
    period: Duration = Field(description="least time between two of them [s]")


class OtherNode(Table):
    """A node that is on a bus beside the drives. The machine does not listen to it.

    Beside its frames it may send a boot-up message and heartbeats.
    """

    name: Identifier = Field(description="name of the node, for the DBC")
    bus: Identifier = Field(description="name of the bus it is on")
    node: Node = Field(description="its number on the bus")
    heartbeat: Duration | None = Field(
        None, description="between its heartbeats (1017); none without this key [s]"
    )
    frames: tuple[NodeFrame, ...] = Field(
        (), description="what else it sends, emergencies included"
    )

    @property
    def error_control(self) -> int:
        """Identifier of its boot-up message and heartbeats."""
        return ERROR_CONTROL + self.node

    @property
    def identifiers(self) -> tuple[int, ...]:
        """Of all that it may send."""
        return self.error_control, *(frame.id for frame in self.frames)


class Rating(Table):
    """A motor with its encoder; its rated torque is nominal current x torque constant."""

    nominal_current: Current = Field(description="continuous current of the motor [A]")
    current_limit: Current = Field(description="most that the drive gives it [A]")
    torque_constant: TorqueConstant = Field(description="torque a current makes [N m/A]")
    encoder_counts: Counts = Field(
        description="counts a turn, as the drive counts: of a quadrature encoder four a pulse"
    )


class RailHoming(Table):
    """How a base finds its zero: slowly against a mechanical stop (Yoon III-E)."""

    end: Literal["start", "end"] = Field(
        "start", description="end of the rail with the stop: start (rail coordinate 0) or end"
    )
    beyond: LengthOrZero = Field(
        0.0, description="how far beyond that end the carriage meets the stop [m]"
    )
    speed: Speed = Field(description="towards the stop (6099) [m/s]")
    acceleration: Acceleration = Field(description="towards the stop (609A) [m/s^2]")
    current: Current = Field(description="current that tells the stop [A]")


class Calibration(Table):
    """How the cables' zeros are found: bases sweep, cables hold the platform at T_min."""

    samples: Samples = Field(24, description="poses that are measured")
    interval: Duration = Field(0.1, description="time between two of them [s]")
    travel: Length | None = Field(
        None,
        description="sweep of each base to either side of the middle of its rail [m];"
        " 100 mm by default, or half of the shortest rail if that is less; without rails a fifth of"
        " it makes another pose",
    )

    def travel_on(self, shortest: float) -> float:
        """The sweep on rails of which the shortest has this length [m]."""
        return self.travel if self.travel is not None else min(LONGEST_SWEEP, shortest / 2)


class Supervision(Table):
    """Limits beyond which the machine is stopped, and the times that things may take."""

    heartbeat: Duration = Field(0.01, description="between heartbeats of the master [s]")
    heartbeat_timeout: Duration = Field(
        0.04, description="without one until a drive gives up its torque (1016) [s]"
    )
    drive_heartbeat: Duration = Field(0.02, description="between heartbeats of a drive (1017) [s]")
    drive_timeout: Duration = Field(0.1, description="without one until a drive is silent [s]")
    connection_loss: Literal["disable", "quick_stop"] = Field(
        "disable",
        description="without the master a drive does: disable (no torque) or quick_stop",
    )
    quick_stop: Literal["off", "hold"] = Field(
        "off", description="where a drive's quick stop (605A) ends: off, or hold with torque"
    )
    answer_delay: Delay = Field(
        40e-6, description="most from SYNC until a drive's answer is ready to be sent [s]"
    )
    compute_time: Delay = Field(100e-6, description="set aside for computing one control cycle [s]")
    answer_timeout: Duration = Field(0.5, description="until an SDO request has failed [s]")
    missed_syncs: Cycles = Field(2, description="unanswered SYNCs in a row that are bridged")
    skipped_cycles: Cycles = Field(2, description="control cycles skipped at once that are bridged")
    failed_steps: Cycles = Field(20, description="failed controller steps in a row, bridged")
    closure_limit: Length = Field(
        2e-3, description="largest disagreement of the measured cable lengths [m]"
    )
    closure_time: Duration = Field(5e-3, description="time beyond it that is bridged [s]")
    cable_speed: Speed = Field(5.0, description="largest speed of a cable [m/s]")
    rail_speed: Speed = Field(3.0, description="largest speed of a carriage [m/s]")
    rail_lag: Length = Field(0.05, description="largest distance of a base from its target [m]")
    rail_lag_time: Duration = Field(0.2, description="time beyond it that is bridged [s]")
    blocked_time: Duration = Field(
        0.02,
        description="that a carriage may stand still while it is pushed at its force limit [s]",
    )
    blocked_travel: Length = Field(
        0.2e-3, description="motion within that time that is none yet [m]"
    )
    rail_torque_rate: TorqueRate = Field(
        200.0, description="largest change of a base motor's torque [N m/s]"
    )
    state_timeout: Duration = Field(
        2.0, description="for a drive to reach an ordered power state or mode [s]"
    )
    homing_timeout: Duration = Field(20.0, description="for one base to find its stop [s]")
    stop_time: Duration = Field(0.3, description="of a soft stop, from work to no torque [s]")
