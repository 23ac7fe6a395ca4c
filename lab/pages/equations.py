"""The equations of a machine: the model's own formulas, run on SymPy's symbols.

What would swell is named: rotation, arms, lengths, directions. Every equation is written in what
those before it define, and in pose, rail coordinates and tensions.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp

from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic import kinematics, scalar
from turnbuckle.model.symbolic.angle import half_angle, planar_rotation, spatial_rotation
from turnbuckle.model.symbolic.kinematics import Cables
from turnbuckle.model.symbolic.linear import dot, multiply
from turnbuckle.model.symbolic.scalar import Matrix, Vector
from turnbuckle.model.symbolic.span import Span, span

scalar.sqrt.register(sp.Basic, sp.sqrt)

AXES = "xyz"


@dataclass(frozen=True)
class Equation:
    """`name` (LaTeX) is `value`; its entries are `symbols`, where later equations use them."""

    key: str
    name: str
    value: sp.Matrix
    unit: str
    words: str
    symbols: tuple[sp.Symbol, ...] = ()

    def __post_init__(self) -> None:
        if self.symbols and len(self.symbols) != len(self.value):
            raise ValueError(f"{self.key}: a symbol for every entry")


@dataclass(frozen=True)
class Names:
    """The symbols of a machine: what its equations begin from, and what they name."""

    machine: Machine

    @property
    def position(self) -> Vector:
        """Centre of the platform [m]."""
        return [sp.Symbol(axis, real=True) for axis in AXES[: self.machine.space]]

    @property
    def turn(self) -> Vector:
        """Angle or rotation vector of a rigid platform [rad]; none of a point."""
        count = self.machine.dof - self.machine.space
        names = [r"\varphi"] if count == 1 else [rf"\varphi_{{{axis}}}" for axis in AXES[:count]]
        return [sp.Symbol(name, real=True) for name in names]

    @property
    def rails(self) -> Vector:
        """Rail coordinates [m]."""
        return [sp.Symbol(f"s_{k + 1}", real=True) for k in range(len(self.machine.rails))]

    @property
    def tensions(self) -> Vector:
        """Tensions [N]."""
        return [sp.Symbol(f"T_{i + 1}", real=True) for i in range(len(self.machine.cables))]

    @property
    def lengths(self) -> Vector:
        """Cable lengths [m], of which none is 0."""
        count = len(self.machine.cables)
        return [sp.Symbol(rf"\ell_{{{i + 1}}}", positive=True) for i in range(count)]

    def rows(self, letter: str) -> Matrix:
        """A vector in space for every cable."""
        axes = AXES[: self.machine.space]
        return [
            [sp.Symbol(f"{letter}_{{{i + 1}{axis}}}", real=True) for axis in axes]
            for i in range(len(self.machine.cables))
        ]

    @property
    def rotation(self) -> Matrix:
        """Entries of the rotation matrix."""
        size = range(1, self.machine.space + 1)
        return [[sp.Symbol(f"R_{{{i}{j}}}", real=True) for j in size] for i in size]


def equations(machine: Machine) -> list[Equation]:
    """All equations of a machine, in the order in which they can be evaluated."""
    names = Names(machine)
    held = platform(machine, names)
    bases = exact(kinematics.base_points(machine, names.rails))
    spans = [span(*ends, sp.atan2) for ends in zip(machine.pulleys, held, bases, strict=True)]
    points = sp.Matrix(bases)
    return [
        Equation("bases", r"\mathbf{B}", points, "m", "Row i is the base point of cable i."),
        *rotations(machine, names),
        *lengths(names, spans),
        *directions(machine, names, spans),
        structure(machine, names, spans),
        *jacobians(machine, names, spans),
        *statics(machine, names, spans),
    ]


def exact(rows: Matrix) -> Matrix:
    """The entries with decimal fractions in place of floating-point numbers."""
    return [[decimal(entry) for entry in row] for row in rows]


def decimal(value: Any) -> sp.Expr:
    """An expression with decimal fractions in place of floating-point numbers."""
    found = sp.sympify(value)
    return found.xreplace({number: sp.Rational(str(number)) for number in found.atoms(sp.Float)})


def platform(machine: Machine, names: Names) -> Matrix:
    """Anchors in the fixed frame [m], one row a cable."""
    arms = names.rows("r") if machine.is_rigid else []
    return kinematics.anchor_points(machine, names.position, arms)


def rotations(machine: Machine, names: Names) -> list[Equation]:
    """How a rigid platform is turned, and where that takes its anchors."""
    if not machine.is_rigid:
        return []
    w, sigma = sp.symbols(r"w \sigma", real=True)
    square = dot(names.turn, names.turn)
    angle = sp.sqrt(square)
    turned = planar_rotation(names.turn[0]) if machine.space == 2 else spatial_rotation(names.turn)
    cosine, ratio = half_angle(square)  # polynomials in the C
    matrix = sp.Matrix(turned).xreplace({cosine: w, ratio: sigma, 2 * cosine: 2 * w})
    arms = [multiply(names.rotation, anchor) for anchor in exact(list(map(list, machine.anchors)))]
    halves = sp.Matrix([sp.cos(angle / 2), sp.sin(angle / 2) / angle])
    return [
        Equation("half_angle", "", halves, "", HALVES, (w, sigma)),
        Equation("rotation", r"\mathbf{R}", matrix, "1", "The rotation.", flat(names.rotation)),
        Equation("arms", "", sp.Matrix(arms), "m", ARMS, flat(names.rows("r"))),
    ]


HALVES = "Cosine of half the angle, and its sine over the angle."
ARMS = "Arms, from the platform's centre to its anchors: the rotation times the upright ones."


def flat(rows: Matrix) -> tuple[sp.Symbol, ...]:
    """The entries row by row."""
    return tuple(entry for row in rows for entry in row)


def lengths(names: Names, spans: Sequence[Span]) -> list[Equation]:
    """The inverse kinematics."""
    values = sp.Matrix([each.length for each in spans])
    return [Equation("lengths", "", values, "m", "Cable lengths.", tuple(names.lengths))]


def directions(machine: Machine, names: Names, spans: Sequence[Span]) -> list[Equation]:
    """Unit vectors from anchors to bases, where the equations of a rigid platform name them."""
    if not machine.is_rigid:
        return []
    rows = sp.Matrix([by_length(each.ray, names, spans) for each in spans])
    words = "Unit vectors along the cables, from anchor to base."
    return [Equation("directions", "", rows, "1", words, flat(names.rows("u")))]


def by_length(values: Vector, names: Names, spans: Sequence[Span]) -> Vector:
    """Expressions in which lengths have their names."""
    known = {each.free**2: name**2 for each, name in zip(spans, names.lengths, strict=True)}
    return [sp.sympify(value).xreplace(known) for value in values]


def rays(machine: Machine, names: Names, spans: Sequence[Span]) -> Matrix:
    """Unit vectors: by their names for a rigid platform, else by lengths."""
    if machine.is_rigid:
        return names.rows("u")
    return [by_length(each.ray, names, spans) for each in spans]


def structure(machine: Machine, names: Names, spans: Sequence[Span]) -> Equation:
    """The structure matrix of named directions and arms."""
    named = [
        replace(each, ray=ray) for each, ray in zip(spans, rays(machine, names, spans), strict=True)
    ]
    arms = names.rows("r") if machine.is_rigid else []
    matrix = sp.Matrix(Cables(machine, named, arms).structure)
    words = "Column i is the wrench of a unit tension in cable i."
    return Equation("structure", r"\mathbf{S}", matrix, "1, m" * machine.is_rigid or "1", words)


def jacobians(machine: Machine, names: Names, spans: Sequence[Span]) -> list[Equation]:
    """Derivatives of the lengths by the platform's twist and by the rail coordinates."""
    turning = [sp.Symbol(f"omega_{k}", real=True) for k in range(machine.dof - machine.space)]
    moved = [each.length for each in spans]
    if machine.is_rigid:
        moved = [
            length.subs(dict(zip(arm, kinematics.turned(arm, turning), strict=True)))
            for length, arm in zip(moved, names.rows("r"), strict=True)
        ]
    twist = [*names.position, *turning]
    by_twist = sp.Matrix(moved).jacobian(twist).subs(dict.fromkeys(turning, 0))
    words = "Derivative of the lengths by the pose" + ", by its twist" * machine.is_rigid
    words += ": the transpose of the structure matrix, negative."
    unit = "1, m" * machine.is_rigid or "1"
    named = readable(machine, names, spans, by_twist)
    result = [Equation("jacobian", r"\mathbf{J}", named, unit, words)]
    if names.rails:
        slopes = sp.Matrix([each.length for each in spans]).jacobian(names.rails)
        slopes = readable(machine, names, spans, slopes)
        told = "Derivative of the lengths by the rail coordinates."
        result.append(Equation("rail_jacobian", r"\mathbf{J}_s", slopes, "1", told))
    return result


def readable(machine: Machine, names: Names, spans: Sequence[Span], matrix: sp.Matrix) -> sp.Matrix:
    """Derivatives, one row a cable, by lengths, and for a rigid platform by directions."""
    rows = [by_length(list(matrix.row(i)), names, spans) for i in range(matrix.rows)]
    if not machine.is_rigid:
        return sp.Matrix(rows)
    return sp.Matrix(
        [[by_direction(entry, names, each, i) for entry in rows[i]] for i, each in enumerate(spans)]
    )


def by_direction(entry: sp.Expr, names: Names, cable: Span, number: int) -> sp.Expr:
    """An entry of cable `number` with its unit vector in place of the platform's position."""
    length, direction = names.lengths[number], names.rows("u")[number]
    place = {
        centre: centre + vector - length * along
        for centre, vector, along in zip(names.position, cable.vector, direction, strict=True)
    }
    return sp.expand(sp.expand(entry).subs(place, simultaneous=True))


def statics(machine: Machine, names: Names, spans: Sequence[Span]) -> list[Equation]:
    """Forces of the cables on their bases, along the rails."""
    if not machine.rails:
        return []
    forces: Vector = [sp.Integer(0)] * len(machine.rails)
    for cable, number, slope in kinematics.rail_slopes(machine, rays(machine, names, spans)):
        forces[number] -= names.tensions[cable] * decimal(slope)
    words = "Force of the cables on every carriage along its rail; its drive holds it."
    return [Equation("rail_forces", r"\mathbf{f}", sp.Matrix(forces), "N", words)]
