"""The schema of a machine file: what a cable-driven machine is, as frozen data in SI units."""

import json
import math
from functools import cached_property
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, ConfigDict, Field, PrivateAttr

from turnbuckle.model.base import (
    Base,
    BaseMotion,
    Coordinates,
    FixedBase,
    PlaneBase,
    RailBase,
    RailCoordinate,
    motions,
)
from turnbuckle.model.bus.tables import (
    Bus,
    Calibration,
    Drive,
    OtherNode,
    RailHoming,
    Rating,
    Supervision,
)
from turnbuckle.model.kind import KINDS
from turnbuckle.model.pulley import SENSE, Pulley, PulleyTable
from turnbuckle.model.quantity import (
    Angle,
    AngleOrZero,
    Damping,
    Force,
    ForceOrZero,
    Frequency,
    Inertia,
    IntegralGain,
    Length,
    Mass,
    Point,
    RotaryDamping,
    Size,
    Stiffness,
    StiffnessOrZero,
    Torque,
    TorqueOrZero,
    TorqueRate,
    UnitVector,
)
from turnbuckle.model.rounding import ROUNDING
from turnbuckle.model.table import Table
from turnbuckle.model.words import CommentLine, Identifier, KindName

# A double pole 1/(tau s + 1)^2 has fallen by 3 dB where w tau is this.
DOUBLE_POLE_3DB = math.sqrt(math.sqrt(2) - 1)


class Identity(Table):
    """Who the machine is."""

    name: Identifier = Field(description="the machine's name in C and in file names")
    kind: KindName = Field(description=f"the kind of platform: {', '.join(KINDS)}")
    source: CommentLine = Field(description="where the numbers come from, one line of text")


class Frame(Table):
    """The rectangle or box that holds the bases; its corner with the least coordinates is zero."""

    size: Size = Field(description="extent of the frame along every axis [m]")

    @property
    def centre(self) -> Coordinates:
        """The middle of the frame [m]."""
        return tuple(side / 2 for side in self.size)


class Platform(Table):
    """The body that the cables hold; due for the rigid kinds."""

    rotation: Angle = Field(description="largest rotation either way from upright [rad]")


class Cable(Table):
    """A cable: its anchor, its base (fixed, on a rail or in a plane), its pulley and its drive."""

    model_config = ConfigDict(
        json_schema_extra={"oneOf": [{"required": [key]} for key in ("base", "rail", "plane")]}
    )

    anchor: Point | None = Field(
        None, description="where a rigid platform holds the cable, from its centre [m]"
    )
    fixed: Point | None = Field(None, alias="base", description="where a fixed base stays [m]")
    rail: RailBase | None = Field(None, description="the rail a movable base slides on")
    plane: PlaneBase | None = Field(None, description="the plane a movable base moves in")
    pulley: PulleyTable | None = Field(
        None, description="this cable's pulley; the table [pulley] by default"
    )
    drive: Identifier = Field("", description="name of the drive; cable_<number> by default")

    @cached_property
    def base(self) -> Base:
        """Where the cable's pulley is; load_machine has seen to it that there is one."""
        base = self.rail or self.plane
        if base is not None:
            return base
        assert self.fixed is not None
        return FixedBase(self.fixed)


class Tension(Table):
    """Bounds of every cable's tension (Yoon eq. 11) and what to do with a wrench beyond them."""

    min: ForceOrZero = Field(description="smallest tension T_min [N]")
    max: Force = Field(description="largest tension T_max [N]")
    when_infeasible: Literal["scale", "closest", "paper"] = Field(
        description="scale (same direction, smaller), closest (nearest feasible wrench)"
        " or paper (Yoon eqs 22, 23)"
    )


class Drum(Table):
    """The drum that winds a cable."""

    radius: Length = Field(description="radius r_p [m]")


class CableMotor(Table):
    """The motor on a drum; inertia and damping are the observer's nominal J_n and B_n."""

    inertia: Inertia = Field(description="nominal inertia J_n [kg m^2]")
    damping: RotaryDamping = Field(description="nominal damping B_n [N m s/rad]")
    torque_limit: Torque = Field(description="largest torque the gate lets through [N m]")
    torque_rate_limit: TorqueRate = Field(
        description="largest change of torque the gate lets through [N m/s]"
    )
    rating: Rating | None = Field(None, description="motor and encoder; due with [[bus]]")


class Control(Table):
    """The control cycle."""

    rate: Frequency = Field(description="control cycles per second [Hz]")
    velocity_corner: Frequency = Field(
        description="corner of the low-pass on differentiated lengths [Hz]"
    )


class DisturbanceObserver(Table):
    """The observer's filter Q = 1/(tau s + 1)^2 (Yoon eq. 24) and how the hand enters it."""

    model_config = ConfigDict(
        json_schema_extra={"oneOf": [{"required": ["corner"]}, {"required": ["minus_3db"]}]}
    )

    corner: Frequency | None = Field(None, description="corner of each of the two poles [Hz]")
    minus_3db: Frequency | None = Field(
        None, description="where both poles together have fallen by 3 dB [Hz]"
    )
    hand_force: Literal["measured", "unmeasured"] = Field(
        description="measured or unmeasured: whether a sensor tells the hand's force"
    )

    @property
    def time_constant(self) -> float:
        """tau [s] of each pole: 1/(2 pi corner), or sqrt(sqrt 2 - 1)/(2 pi minus_3db)."""
        if self.corner is not None:
            return 1 / (2 * math.pi * self.corner)
        assert self.minus_3db is not None  # load_machine has seen to it
        return DOUBLE_POLE_3DB / (2 * math.pi * self.minus_3db)

    @property
    def pole_corner(self) -> float:
        """Corner frequency of each pole [Hz]."""
        return 1 / (2 * math.pi * self.time_constant)

    @property
    def cut_off(self) -> float:
        """Frequency at which Q has fallen by 3 dB [Hz]: 0.644 of the corner."""
        return DOUBLE_POLE_3DB * self.pole_corner


class RailDrive(Table):
    """The drive of every rail: timing pulley, force limit and position PID."""

    pinion_radius: Length = Field(description="radius of the timing pulley [m]")
    force_limit: Force = Field(description="largest force on a carriage [N]")
    stiffness: Stiffness = Field(description="proportional gain [N/m]")
    integral: IntegralGain = Field(description="integral gain [N/(m s)]")
    damping: Damping = Field(description="derivative gain [N s/m]")
    derivative_corner: Frequency = Field(description="corner of the speed's low-pass [Hz]")
    rating: Rating | None = Field(None, description="motor and encoder; due with [[bus]]")
    homing: RailHoming | None = Field(None, description="how zero is found; due with [[bus]]")


class Wall(Table):
    """A virtual wall (Yoon eqs 26, 27): spring and damper behind a line."""

    name: Identifier = Field(description="name of the wall")
    point: Point = Field(description="a point on the surface, one length an axis")
    normal: UnitVector = Field(
        description="plain numbers, one an axis: the direction out of the wall, to the free side"
    )
    stiffness: Stiffness = Field(description="stiffness of the wall [N/m]")
    damping: Damping = Field(description="damping of the wall [N s/m]")


class Target(Table):
    """What the user needs to reach: a rectangle or box, and a force in every direction in it."""

    size: Size = Field(description="extent of the target along every axis [m]")
    centre: Point = Field(description="centre of the target, one length an axis")
    force: Force = Field(description="wanted force in every direction [N]")
    moment: TorqueOrZero = Field(
        0.0, description="rigid kinds: wanted moment in every direction, at the same time [N m]"
    )
    rotation: AngleOrZero = Field(
        0.0, description="rigid kinds: wanted rotation either way about every axis [rad]"
    )


class Plant(Table):
    """What only the virtual test bench reads: the machine's physics beyond its controller."""

    handle_mass: Mass = Field(description="mass of the handle [kg]")
    motor_coulomb_friction: TorqueOrZero = Field(description="dry friction of a motor [N m]")
    motor_viscous_friction: RotaryDamping = Field(description="damping of a motor [N m s/rad]")
    carriage_mass: Mass | None = Field(
        None, description="mass of a carriage, rotor included [kg]; needed where there are rails"
    )
    carriage_coulomb_friction: ForceOrZero | None = Field(
        None, description="dry friction of a carriage [N]; needed where there are rails"
    )
    carriage_viscous_friction: Damping | None = Field(
        None, description="damping of a carriage [N s/m]; needed where there are rails"
    )
    hand_stiffness: StiffnessOrZero = Field(description="stiffness of the user's hand [N/m]")
    hand_damping: Damping = Field(description="damping of the user's hand [N s/m]")
    hand_mass: Mass = Field(description="mass of the user's hand [kg]")


def _name_drives(cables: object) -> object:
    """Give each cable that names no drive the name cable_<number>."""
    if not isinstance(cables, list):
        return cables
    return tuple(
        {"drive": f"cable_{number}", **cable} if isinstance(cable, dict) else cable
        for number, cable in enumerate(cables, start=1)
    )


class Machine(Table):
    """A cable-driven machine, as its file describes it; SI units."""

    model_config = ConfigDict(title="Turnbuckle machine file")

    identity: Identity = Field(alias="machine", description="the table [machine]")
    frame: Frame = Field(description="the table [frame]")
    platform: Platform | None = Field(None, description="due for the rigid kinds")
    pulley: PulleyTable | None = Field(
        None, description="the pulleys of all cables that name none; radius zero without it"
    )
    cables: Annotated[tuple[Cable, ...], BeforeValidator(_name_drives)] = Field(
        alias="cable", description="one table [[cable]] for each cable"
    )
    tension: Tension = Field(description="the table [tension]")
    drum: Drum = Field(description="the table [drum]")
    cable_motor: CableMotor = Field(description="the table [cable_motor]")
    control: Control = Field(description="the table [control]")
    disturbance_observer: DisturbanceObserver | None = Field(
        None, description="the disturbance observer; without it there is none"
    )
    rail_drive: RailDrive | None = Field(None, description="due when a cable has a rail")
    walls: tuple[Wall, ...] = Field((), alias="wall", description="any number of [[wall]]")
    target: Target = Field(description="the table [target]")
    buses: tuple[Bus, ...] = Field((), alias="bus", description="any number of [[bus]]")
    drives: tuple[Drive, ...] = Field(
        (), alias="drive", description="with buses: one [[drive]] for each cable and rail"
    )
    nodes: tuple[OtherNode, ...] = Field(
        (), alias="node", description="any number of [[node]]: who else may be on a bus"
    )
    supervision: Supervision = Field(
        default_factory=lambda: Supervision.model_validate({}),
        description="limits and times of a machine with buses",
    )
    calibration: Calibration = Field(
        default_factory=lambda: Calibration.model_validate({}),
        description="of the cables' zeros, of a machine with buses",
    )
    plant: Plant | None = Field(None, description="read by the virtual test bench only")

    _path: Path = PrivateAttr(default=Path())

    @property
    def path(self) -> Path:
        """The file this machine was read from."""
        return self._path

    @property
    def name(self) -> str:
        """The machine's name, `[a-z][a-z0-9_]*`."""
        return self.identity.name

    @property
    def kind(self) -> str:
        """The kind of platform, a key of `model.kind.KINDS`."""
        return self.identity.kind

    @property
    def source(self) -> str:
        """Where the numbers come from."""
        return self.identity.source

    @property
    def dof(self) -> int:
        """Degrees of freedom d."""
        return KINDS[self.kind].dof

    @property
    def space(self) -> int:
        """Dimension of the space the platform moves in, 2 or 3."""
        return KINDS[self.kind].space

    @property
    def is_rigid(self) -> bool:
        """Whether the platform turns."""
        return KINDS[self.kind].is_rigid

    @property
    def redundancy(self) -> int:
        """r = n - d."""
        return len(self.cables) - self.dof

    @property
    def anchors(self) -> tuple[Coordinates, ...]:
        """p_i [m] of every cable, in the platform's own frame."""
        return tuple(cable.anchor or (0.0,) * self.space for cable in self.cables)

    @property
    def lever(self) -> float:
        """Root mean square of |p_i| [m], which makes moments comparable with forces; 1 for points.

        Norms of wrenches are those of [F; M / lever].
        """
        squares = sum(x * x for anchor in self.anchors for x in anchor)
        return math.sqrt(squares / len(self.anchors)) if self.is_rigid else 1.0

    @property
    def rotation(self) -> float:
        """Largest rotation of the platform either way [rad]; 0 for points."""
        return self.platform.rotation if self.platform else 0.0

    @property
    def _motions(self) -> tuple[tuple[BaseMotion, ...], tuple[RailCoordinate, ...]]:
        bases = tuple(cable.base for cable in self.cables)
        return motions(bases, tuple(cable.drive for cable in self.cables))

    @property
    def base_motions(self) -> tuple[BaseMotion, ...]:
        """How the pulley point of every cable follows the rail coordinates."""
        return self._motions[0]

    @property
    def rails(self) -> tuple[RailCoordinate, ...]:
        """The rail coordinates s_k: one an actuator, two for a base in a plane."""
        return self._motions[1]

    @property
    def pulleys(self) -> tuple[Pulley | None, ...]:
        """The pulley of every cable; None where its radius is zero."""
        tables = [cable.pulley or self.pulley for cable in self.cables]
        return tuple(
            self._pulley(table, motion) if table else None
            for table, motion in zip(tables, self.base_motions, strict=True)
        )

    def _pulley(self, table: PulleyTable, motion: BaseMotion) -> Pulley:
        if self.space == 3:
            assert table.axis is not None  # load_machine has seen to it
            return Pulley(table.radius, axis=table.axis)
        base = motion.point([rail.length / 2 for rail in self.rails])
        away = tuple(b - c for b, c in zip(base, self.frame.centre, strict=True))
        contact = table.contact or tuple(x / math.hypot(*away) for x in away)
        return Pulley(table.radius, SENSE[table.winds], contact)

    def describe(self) -> list[tuple[str, str]]:
        """The machine at a glance: rows of (label, value), in words and common units."""
        return [
            ("machine", f"{self.name} ({self.source})"),
            ("kind", f"{self.kind}: {KINDS[self.kind].meaning}"),
            ("degrees of freedom", str(self.dof)),
            ("cables", f"{len(self.cables)} ({', '.join(c.drive for c in self.cables)})"),
            ("redundancy", str(self.redundancy)),
            ("rails", self._rails_in_words()),
            ("tension", f"{self.tension.min:g} to {self.tension.max:g} N"),
            ("when infeasible", self.tension.when_infeasible),
            ("pulley radius", self._pulleys_in_words()),
            ("drum radius", _in_mm(self.drum.radius)),
            ("control rate", f"{self.control.rate:g} Hz"),
            ("disturbance observer", self._observer_in_words()),
            ("walls", ", ".join(wall.name for wall in self.walls) or "none"),
            ("target", self._target_in_words()),
        ]

    def warnings(self) -> list[tuple[str, str]]:
        """What is allowed, and may be an oversight: rows of (key, text)."""
        off = self._off_centre()
        if not any(off):
            return []
        return [("target.centre", f"{_in_mm(*off)} off the middle of the frame")]

    def _off_centre(self) -> Coordinates:
        """How far the target's centre is from the frame's [m], less rounding."""
        sides = zip(self.target.centre, self.frame.centre, self.frame.size, strict=True)
        return tuple(a - b if abs(a - b) > ROUNDING * size else 0.0 for a, b, size in sides)

    def _rails_in_words(self) -> str:
        return ", ".join(_in_mm(rail.length) for rail in self.rails) or "none"

    def _pulleys_in_words(self) -> str:
        radii = [pulley.radius if pulley else 0.0 for pulley in self.pulleys]
        return ", ".join(map(_in_mm, radii if len(set(radii)) > 1 else radii[:1]))

    def _target_in_words(self) -> str:
        target = self.target
        text = f"{_in_mm(*target.size)}, {target.force:g} N in every direction"
        text += "".join(f", {words}" for _, words in self.warnings())
        if target.moment:
            text += f", {target.moment * 1e3:g} mN m about every axis"
        if target.rotation:
            text += f", turned by up to {math.degrees(target.rotation):g} deg"
        return text

    def read_from(self, path: Path) -> "Machine":
        """The machine, which remembers its file."""
        self._path = path
        return self

    def _observer_in_words(self) -> str:
        observer = self.disturbance_observer
        if observer is None:
            return "none"
        return (
            f"two poles at {observer.pole_corner:.4g} Hz, -3 dB at {observer.cut_off:.4g} Hz,"
            f" tau {observer.time_constant * 1e3:.4g} ms, hand force {observer.hand_force}"
        )


def _in_mm(*lengths: float) -> str:
    return " x ".join(f"{length * 1e3:g}" for length in lengths) + " mm"


def json_schema() -> dict[str, Any]:
    """The JSON Schema of a machine file, for editors (docs/machine.schema.json)."""
    dialect = "https://json-schema.org/draft/2020-12/schema"
    return {"$schema": dialect, **Machine.model_json_schema(by_alias=True)}


def json_schema_text() -> str:
    """The same as text."""
    return json.dumps(json_schema(), indent=2) + "\n"


if __name__ == "__main__":
    print(json_schema_text(), end="")
