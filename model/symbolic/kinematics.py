"""Where the cables are and how they move: Yoon section II-A and III-D."""

from dataclasses import dataclass
from functools import cached_property

import casadi as ca

from turnbuckle.model.base import BaseMotion
from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic.angle import arc_tangent, planar_rotation, spatial_rotation
from turnbuckle.model.symbolic.function import EPSILON, Label, Verdict, not_all_above
from turnbuckle.model.symbolic.linear import (
    add_scaled,
    dot,
    gram,
    moment,
    multiply,
    solve_positive,
    transpose,
)
from turnbuckle.model.symbolic.scalar import Matrix, Scalar, Vector
from turnbuckle.model.symbolic.span import ArcTangent, Span, span

#: A platform nearer than this to a pulley touches it [m]: the direction of the cable is lost.
CONTACT_DISTANCE = 1e-4
#: Directions count as spanning the space of wrenches when the smallest pivot of S S' exceeds this.
SMALLEST_PIVOT = 1e-6
#: ... and this many EPSILON, below which a pivot is rounding.
PIVOT_ROUNDINGS = 4096.0


def base_points(machine: Machine, rails: Vector) -> Matrix:
    """Base points b_i [m], one row a cable: `start` and s_k along every direction of travel."""
    return [base_point(motion, rails) for motion in machine.base_motions]


def base_point(motion: BaseMotion, rails: Vector) -> Vector:
    """Base point of one cable [m]."""
    point: Vector = list(motion.start)
    for number, direction in motion.travel:
        slides = zip(point, direction, strict=True)
        point = [x + slope * rails[number] if slope else x for x, slope in slides]
    return point


def arms(machine: Machine, pose: Vector) -> Matrix:
    """R p_i [m], from the centre of a rigid platform to its anchors, one row a cable; else none."""
    if not machine.is_rigid:
        return []
    turned = pose[machine.space :]
    rotation = planar_rotation(turned[0]) if machine.space == 2 else spatial_rotation(turned)
    return [multiply(rotation, anchor) for anchor in machine.anchors]


@dataclass(frozen=True)
class Cables:
    """All cables at one pose: `spans`, and for a rigid platform their `arms` R p_i [m]."""

    machine: Machine
    spans: list[Span]
    arms: Matrix

    @cached_property
    def vectors(self) -> Matrix:
        """From the anchors to where the cables meet the pulleys [m] (Yoon eq. 1)."""
        return [each.vector for each in self.spans]

    @cached_property
    def rays(self) -> Matrix:
        """Unit vectors of these, one row a cable."""
        return [each.ray for each in self.spans]

    @cached_property
    def lengths(self) -> Vector:
        """Cable lengths l_i [m], with what lies on the pulleys."""
        return [each.length for each in self.spans]

    @cached_property
    def clearances(self) -> Vector:
        """Distances [m] without which a cable has no direction."""
        return [distance for each in self.spans for distance in each.clearances]

    @cached_property
    def structure(self) -> Matrix:
        """S, d x n: column i is the wrench of a unit tension, [u_i; R p_i x u_i] (Yoon eq. 7)."""
        if not self.arms:
            return transpose(self.rays)
        pairs = zip(self.arms, self.rays, strict=True)
        return transpose([[*ray, *moment(arm, ray)] for arm, ray in pairs])


def cables(machine: Machine, pose: Vector, rails: Vector) -> Cables:
    """The cables at a pose and rail coordinates."""
    platform_arms = arms(machine, pose)
    held = anchor_points(machine, pose[: machine.space], platform_arms)
    return spanned(machine, held, platform_arms, rails)


def anchor_points(machine: Machine, centre: Vector, platform_arms: Matrix) -> Matrix:
    """Anchors a_i = c + R p_i in the fixed frame [m], one row a cable."""
    if not platform_arms:
        return [centre for _ in machine.cables]
    return [add_scaled(centre, 1, arm) for arm in platform_arms]


def anchors(machine: Machine, pose: Vector) -> Matrix:
    """Anchors in the fixed frame at a pose [m], one row a cable."""
    return anchor_points(machine, pose[: machine.space], arms(machine, pose))


def spanned(
    machine: Machine,
    held: Matrix,
    platform_arms: Matrix,
    rails: Vector,
    angle_of: ArcTangent = arc_tangent,
) -> Cables:
    """The cables between the anchors that hold them and their bases."""
    bases = base_points(machine, rails)
    ends = zip(machine.pulleys, held, bases, strict=True)
    return Cables(machine, [span(*each, angle_of) for each in ends], platform_arms)


def cable_vectors(machine: Machine, pose: Vector, rails: Vector) -> Matrix:
    """Cable vectors l_i [m], one row a cable: b_i - c - R p_i (Yoon eq. 1), to the pulley's rim."""
    return cables(machine, pose, rails).vectors


def cable_lengths(machine: Machine, pose: Vector, rails: Vector) -> Vector:
    """Cable lengths l_i [m] (Yoon eq. 18), with what lies on the pulleys."""
    return cables(machine, pose, rails).lengths


def directions(vectors: Matrix, lengths: Vector) -> Matrix:
    """Unit vectors from the platform to the pulleys, one row a cable."""
    return [
        [entry / length for entry in vector]
        for vector, length in zip(vectors, lengths, strict=True)
    ]


def structure_matrix(machine: Machine, pose: Vector, rails: Vector) -> Matrix:
    """Structure matrix S, d x n: column i is the wrench of a unit tension (Yoon eq. 7, 21)."""
    return cables(machine, pose, rails).structure


def length_jacobian(
    machine: Machine, centre: Vector, platform_arms: Matrix, rails: Vector
) -> Matrix:
    """dl/dx by automatic differentiation, one row a cable, one column an entry of the twist.

    The twist (dc, dw) moves the anchors from a = c + R p to a + dc + dw x R p; it is differentiated
    at zero, where that is exact.
    """
    twist = ca.SX.sym("twist", machine.dof)
    entries = [twist[i] for i in range(machine.dof)]
    moved_arms = [turned(arm, entries[machine.space :]) for arm in platform_arms]
    held = anchor_points(machine, add_scaled(centre, 1, entries[: machine.space]), moved_arms)
    lengths = spanned(machine, held, moved_arms, rails, ca.atan2).lengths
    return as_rows(ca.substitute(derivative(lengths, twist), twist, ca.DM.zeros(machine.dof)))


def turned(arm: Vector, spin: Vector) -> Vector:
    """An arm after a small turn: p + w x p."""
    if len(arm) == 2:
        return [arm[0] - spin[0] * arm[1], arm[1] + spin[0] * arm[0]]
    return add_scaled(arm, 1, moment(spin, arm))


def rail_jacobian(machine: Machine, held: Matrix, rails: ca.SX) -> Matrix:
    """dl/ds by automatic differentiation, one row a cable, one column a rail coordinate.

    held: the anchors in the fixed frame [m].
    """
    entries = [rails[i] for i in range(rails.numel())]
    lengths = spanned(machine, held, [], entries, ca.atan2).lengths
    return as_rows(derivative(lengths, rails))


def derivative(values: Vector, symbols: ca.SX) -> ca.SX:
    """Derivative of every value by every symbol."""
    return ca.jacobian(ca.vertcat(*values), symbols)


def as_rows(matrix: ca.SX) -> Matrix:
    """The entries of a CasADi matrix."""
    return [[matrix[i, j] for j in range(matrix.size2())] for i in range(matrix.size1())]


def length_label(lengths: Vector, source: str = "l_i = |b_i - c|, Yoon eq. 18") -> Label:
    """Names the cable lengths in the generated C."""
    return Label("length", lengths, source)


def touches_a_pulley(lengths: Vector) -> Verdict:
    """The platform is so near a pulley that the cable has no direction."""
    meaning = f"the platform is nearer than {CONTACT_DISTANCE * 1e3:g} mm to a pulley"
    return not_all_above(lengths, CONTACT_DISTANCE, meaning)


def loses_rank(pivots: Vector) -> Verdict:
    """The cables do not pull in all directions."""
    least = ca.fmax(SMALLEST_PIVOT, PIVOT_ROUNDINGS * EPSILON)
    few = f"the cables pull in fewer than {len(pivots)} directions"
    return not_all_above(pivots, least, "the cables are parallel" if len(pivots) == 2 else few)


def rail_slopes(machine: Machine, rays: Matrix) -> list[tuple[int, int, Scalar]]:
    """The entries of dl/ds that are not zero: cable i, rail coordinate k, lhat_i . e."""
    return [
        (cable, number, dot(ray, list(direction)))
        for cable, (motion, ray) in enumerate(zip(machine.base_motions, rays, strict=True))
        for number, direction in motion.travel
    ]


def comparable(machine: Machine, rows: Matrix) -> Matrix:
    """Rows of wrench entries with moments over the platform's lever, so that norms make sense [N].

    The transpose serves twists: it takes (v, lever w).
    """
    moments = [[entry / machine.lever for entry in row] for row in rows[machine.space :]]
    return [*rows[: machine.space], *moments]


def as_twist(machine: Machine, velocity: Vector) -> Vector:
    """(v, lever w) -> (v, w)."""
    return [
        *velocity[: machine.space],
        *(entry / machine.lever for entry in velocity[machine.space :]),
    ]


def least_squares_velocity(
    at: Cables, length_rates: Vector, rail_rates: Vector
) -> tuple[Vector, Vector]:
    """Velocity that fits S' xdot = dl/ds sdot - ldot best; returns (velocity [m/s, rad/s], pivots).

    A rigid platform's velocity is a twist in the fixed frame.
    """
    closing = list(length_rates)
    for cable, number, slope in rail_slopes(at.machine, at.rays):
        closing[cable] = closing[cable] - slope * rail_rates[number]
    rows = comparable(at.machine, at.structure)
    velocity, pivots = solve_positive(gram(rows), [-x for x in multiply(rows, closing)])
    return as_twist(at.machine, velocity), pivots
