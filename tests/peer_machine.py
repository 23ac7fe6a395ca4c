"""The stock machine with drives by another hand: their buses, their time, our physics and a hand.

It stands where lab's SimulatedMachine does in a Lockstep, or behind the program's adapters.
"""

from collections.abc import Sequence
from functools import cache

from peer_drives import Bus, Drive, Library, PeerDrives, Timing, Variation
from peer_drives import Frame as PeerFrame

from turnbuckle.lab.drives.node import Frame
from turnbuckle.lab.hand import Cue, Hand
from turnbuckle.lab.hand import Path as HandPath
from turnbuckle.lab.planar_plant import PlanarPlant
from turnbuckle.model.base import Coordinates
from turnbuckle.model.bus.axis import Axis, axes
from turnbuckle.model.machine import Machine

NANO = 1e-9
NEAR_THEIR_STOPS = (0.012, 0.010, 0.011, 0.009)
"""Rail coordinates [m] in which the bases were left: their homing is short."""
REVISION = 0x01700000
PRODUCT = 0x61500000


@cache
def library() -> Library:
    """The drives by another hand, compiled."""
    return Library()


def drives(
    machine: Machine, variations: dict[int, Variation], counts: Sequence[int]
) -> list[Drive]:
    """The drives of a machine, numbered as its axes; counts: of their encoders at power-on."""
    return [
        peer_drive(axis, machine, variations.get(number, Variation()), counts[number % len(counts)])
        for number, axis in enumerate(axes(machine))
    ]


def peer_drive(axis: Axis, machine: Machine, variation: Variation, count: int) -> Drive:
    """A drive as it is delivered for its motor."""
    assert machine.plant is not None
    rating, plant = axis.rating, machine.plant
    mass = plant.handle_mass if axis.rail is None else plant.carriage_mass or 0.0
    rotor = machine.cable_motor.inertia if axis.rail is None else 0.0
    return Drive(
        bus=axis.bus,
        node=axis.drive.node,
        counts_per_turn=rating.encoder_counts,
        nominal_current=round(rating.nominal_current * 1e3),
        current_limit=round(rating.current_limit * 1e3),
        torque_constant=round(rating.torque_constant * 1e6),
        vendor=0xFB,
        product=PRODUCT,
        revision=REVISION,
        serial=1,
        initial_count=count,
        rotor_inertia=rotor + mass * axis.radius**2,
        boot_delay=round(0.1 / NANO),
        variation=variation,
    )


class PeerBus:
    """One bus of the peer, as a master's controller sees it."""

    def __init__(self, peer: PeerDrives, number: int) -> None:
        self._peer, self._number = peer, number

    def send(self, frame: Frame, after: float = 0.0) -> None:
        """Hand a frame to the controller, so long [s] from now; without room for it, as while no
        drive has booted that could acknowledge one, it is gone."""
        at = self._peer.now + round(after / NANO)
        self._peer.send(self._number, PeerFrame(frame.cob, frame.data), at)

    def take(self) -> list[Frame]:
        """What has reached the master since the last call."""
        return [Frame(frame.id, frame.data) for _, frame in self._peer.received(self._number)]


class PeerMachine:
    """Drives, plant and hand in simulated time.

    `peer` has the drives, with all that they counted; `path` is what the hand follows from
    begin_task on.
    """

    def __init__(
        self,
        machine: Machine,
        path: HandPath,
        variations: dict[int, Variation] | None = None,
        buses: Sequence[Bus] | None = None,
        timing: Timing | None = None,
        counts: Sequence[int] = (0,),
    ) -> None:
        assert machine.plant is not None
        self.period = 1.0 / machine.control.rate
        self.compute_time = machine.supervision.compute_time
        self._axes = axes(machine)
        self._cables = len(machine.cables)
        self._pinion = machine.rail_drive.pinion_radius if machine.rail_drive else 1.0
        plain = [Bus(bit_rate=round(bus.bit_rate)) for bus in machine.buses]
        made = drives(machine, variations or {}, counts)
        self.peer = PeerDrives(library(), list(buses or plain), made, timing or proof(machine))
        self.buses = [PeerBus(self.peer, number) for number in range(len(machine.buses))]
        self._cue = Cue(path)
        hand = Hand(machine.plant, self._cue)
        start = path.at(0.0)[0]
        self.world = PlanarPlant(machine, machine.plant, hand, start, NEAR_THEIR_STOPS)
        self._wound = list(self.world.lengths)
        self._cycles = 0
        self._look()

    @property
    def time(self) -> float:
        """Until when time has passed [s]."""
        return self.peer.now * NANO

    @property
    def task_force(self) -> Coordinates:
        """The application wants none."""
        return 0.0, 0.0

    @property
    def hand_goal(self) -> Coordinates:
        """Where the hand wants the handle now [m]."""
        return self._cue.at(self.world.time)[0]

    def begin_task(self) -> None:
        """The hand follows its path."""
        self._cue.begin(self.world.time)

    def wander(self) -> None:
        """Bases move by themselves."""

    def run_until(self, time: float) -> None:
        """Let time pass until then [s]."""
        while (end := (self._cycles + 1) * self.period) <= time + NANO:
            self.peer.run(round(end / NANO))
            self._end_cycle()
        self.peer.run(round(time / NANO))

    def advance(self) -> None:
        """Let time pass until the end of the control cycle."""
        self.run_until((self._cycles + 1) * self.period)

    def _end_cycle(self) -> None:
        self._cycles += 1
        torques = [self.peer.torque(number) * axis.sense for number, axis in enumerate(self._axes)]
        cables = self._cables
        self.world.advance(torques[:cables], [torque / self._pinion for torque in torques[cables:]])
        self._look()

    def _look(self) -> None:
        """Let every drive see its shaft."""
        lengths = zip(self._wound, self.world.lengths, strict=True)
        positions = [start - length for start, length in lengths] + self.world.rails
        for number, (axis, position) in enumerate(zip(self._axes, positions, strict=True)):
            self.peer.turn(number, self.peer.now, position * axis.sense / axis.radius)


def proof(machine: Machine, worst: bool = True) -> Timing:
    """Times at the limits of the bus proof."""
    limits = machine.supervision
    return Timing(
        answer_delay=round(limits.answer_delay / NANO),
        sdo_delay=round(2e-3 / NANO),
        seed=1,
        worst=worst,
    )
