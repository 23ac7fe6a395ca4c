"""Where the cables are and how they move: Yoon section II-A and III-D."""

import casadi as ca

from model.base import BaseMotion
from model.machine import Machine
from model.symbolic import arguments
from model.symbolic.function import (
    EPSILON,
    Label,
    ModelFunction,
    Output,
    Verdict,
    matrix_output,
    not_all_above,
    scalar_output,
    vector_output,
)
from model.symbolic.linear import (
    add_scaled,
    dot,
    gram,
    multiply,
    norm,
    solve_positive,
    subtract,
    transpose,
)
from model.symbolic.scalar import Matrix, Scalar, Vector, total

#: A platform nearer than this to a pulley touches it [m]: the direction of the cable is lost.
CONTACT_DISTANCE = 1e-4
#: Directions count as spanning the plane when the smallest pivot of S S' exceeds this.
SMALLEST_PIVOT = 1e-6
#: ... and this many EPSILON, below which a pivot is rounding.
PIVOT_ROUNDINGS = 4096.0


def base_points(machine: Machine, rails: Vector) -> Matrix:
    """Pulley points b_i [m], one row a cable: fixed, or `from` + s_i along the rail."""
    return [base_point(motion, rails) for motion in machine.base_motions]


def base_point(motion: BaseMotion, rails: Vector) -> Vector:
    """Pulley point of one cable [m]."""
    point: Vector = list(motion.start)
    for number, direction in motion.travel:
        slides = zip(point, direction, strict=True)
        point = [x + slope * rails[number] if slope else x for x, slope in slides]
    return point


def cable_vectors(machine: Machine, pose: Vector, rails: Vector) -> Matrix:
    """Cable vectors l_i = b_i - c [m], one row a cable (Yoon eq. 1 with p_i = 0)."""
    return [subtract(point, pose) for point in base_points(machine, rails)]


def cable_lengths(machine: Machine, pose: Vector, rails: Vector) -> Vector:
    """Cable lengths l_i = |b_i - c| [m] (Yoon eq. 18)."""
    return [norm(vector) for vector in cable_vectors(machine, pose, rails)]


def directions(vectors: Matrix, lengths: Vector) -> Matrix:
    """Unit vectors from the platform to the pulleys, one row a cable."""
    return [
        [entry / length for entry in vector]
        for vector, length in zip(vectors, lengths, strict=True)
    ]


def structure_matrix(machine: Machine, pose: Vector, rails: Vector) -> Matrix:
    """Structure matrix S, d x n: column i is the unit vector along cable i (Yoon eq. 7, 21)."""
    vectors = cable_vectors(machine, pose, rails)
    return transpose(directions(vectors, [norm(vector) for vector in vectors]))


def jacobian(values: Vector, symbols: ca.SX) -> Matrix:
    """Derivative of every value by every symbol, by CasADi's automatic differentiation."""
    derivative = ca.jacobian(ca.vertcat(*values), symbols)
    return [[derivative[i, j] for j in range(symbols.numel())] for i in range(len(values))]


def length_label(lengths: Vector) -> Label:
    """Names the cable lengths in the generated C."""
    return Label("length", lengths, "l_i = |b_i - c|, Yoon eq. 18")


def touches_a_pulley(lengths: Vector) -> Verdict:
    """The platform is so near a pulley that the cable has no direction."""
    meaning = f"the platform is nearer than {CONTACT_DISTANCE * 1e3:g} mm to a pulley"
    return not_all_above(lengths, CONTACT_DISTANCE, meaning)


def loses_rank(pivots: Vector) -> Verdict:
    """All cables pull along (nearly) one line."""
    least = ca.fmax(SMALLEST_PIVOT, PIVOT_ROUNDINGS * EPSILON)
    return not_all_above(pivots, least, "the cables are parallel")


def base_points_function(machine: Machine) -> ModelFunction:
    """Pulley points as a function of the rail coordinates."""
    rails = arguments.rails(machine)
    points = base_points(machine, rails.scalars())
    return ModelFunction(
        "base_points",
        "Pulley points b_i",
        "Yoon Fig. 9",
        (rails,),
        (matrix_output("points", "m", points),),
    )


def cable_vectors_function(machine: Machine) -> ModelFunction:
    """Cable vectors as a function of pose and rail coordinates."""
    pose, rails = arguments.pose(machine), arguments.rails(machine)
    vectors = cable_vectors(machine, pose.scalars(), rails.scalars())
    return ModelFunction(
        "cable_vectors",
        "Cable vectors l_i = b_i - c, from the platform to the pulley",
        "Yoon eq. 1",
        (pose, rails),
        (matrix_output("vectors", "m", vectors),),
    )


def cable_lengths_function(machine: Machine) -> ModelFunction:
    """Cable lengths as a function of pose and rail coordinates."""
    pose, rails = arguments.pose(machine), arguments.rails(machine)
    lengths = cable_lengths(machine, pose.scalars(), rails.scalars())
    return ModelFunction(
        "cable_lengths",
        "Cable lengths l_i = |b_i - c|",
        "Yoon eq. 18",
        (pose, rails),
        (vector_output("length", "m", lengths),),
        (touches_a_pulley(lengths),),
    )


def structure_matrix_function(machine: Machine) -> ModelFunction:
    """Structure matrix as a function of pose and rail coordinates."""
    pose, rails = arguments.pose(machine), arguments.rails(machine)
    vectors = cable_vectors(machine, pose.scalars(), rails.scalars())
    lengths = [norm(vector) for vector in vectors]
    return ModelFunction(
        "structure_matrix",
        "Structure matrix S: column i is the unit vector along cable i, S T = W",
        "Yoon eq. 7, 21",
        (pose, rails),
        (matrix_output("structure", "1", transpose(directions(vectors, lengths))),),
        (touches_a_pulley(lengths),),
        (length_label(lengths),),
    )


def length_jacobian_function(machine: Machine) -> ModelFunction:
    """Derivative of the lengths by the pose."""
    pose, rails = arguments.pose(machine), arguments.rails(machine)
    lengths = cable_lengths(machine, pose.scalars(), rails.scalars())
    return ModelFunction(
        "length_jacobian",
        "Length Jacobian dl/dx = -S'",
        "Yoon eq. 3, 20",
        (pose, rails),
        (matrix_output("jacobian", "1", jacobian(lengths, pose.symbols)),),
        (touches_a_pulley(lengths),),
        (length_label(lengths),),
    )


def rail_jacobian_function(machine: Machine) -> ModelFunction:
    """Derivative of the lengths by the rail coordinates."""
    pose, rails = arguments.pose(machine), arguments.rails(machine)
    lengths = cable_lengths(machine, pose.scalars(), rails.scalars())
    return ModelFunction(
        "rail_jacobian",
        "Rail Jacobian dl/ds",
        "Yoon eq. 3, 20",
        (pose, rails),
        (matrix_output("jacobian", "1", jacobian(lengths, rails.symbols)),),
        (touches_a_pulley(lengths),),
        (length_label(lengths),),
    )


def rail_slopes(machine: Machine, rays: Matrix) -> list[tuple[int, int, Scalar]]:
    """The entries of dl/ds that are not zero: cable i, rail coordinate k, lhat_i . e."""
    return [
        (cable, number, dot(ray, list(direction)))
        for cable, (motion, ray) in enumerate(zip(machine.base_motions, rays, strict=True))
        for number, direction in motion.travel
    ]


def least_squares_velocity(
    machine: Machine, rays: Matrix, length_rates: Vector, rail_rates: Vector
) -> tuple[Vector, Vector]:
    """Velocity that fits S' xdot = dl/ds sdot - ldot best; returns (velocity [m/s], pivots)."""
    closing = list(length_rates)
    for cable, number, slope in rail_slopes(machine, rays):
        closing[cable] = closing[cable] - slope * rail_rates[number]
    columns = transpose(rays)
    return solve_positive(gram(columns), [-x for x in multiply(columns, closing)])


def task_velocity_function(machine: Machine) -> ModelFunction:
    """Platform velocity from the speeds of cables and rails."""
    pose, rails = arguments.pose(machine), arguments.rails(machine)
    length_rates, rail_rates = arguments.rates(machine)
    vectors = cable_vectors(machine, pose.scalars(), rails.scalars())
    lengths = [norm(vector) for vector in vectors]
    velocity, pivots = least_squares_velocity(
        machine, directions(vectors, lengths), length_rates.scalars(), rail_rates.scalars()
    )
    return ModelFunction(
        "task_velocity",
        "Platform velocity: least squares over the unit rows of dl/dx xdot = ldot - dl/ds sdot",
        "Yoon eq. 6, 20 with normalised rows",
        (pose, rails, length_rates, rail_rates),
        (vector_output("velocity", "m/s", velocity),),
        (touches_a_pulley(lengths), loses_rank(pivots)),
        (length_label(lengths),),
    )


def multilateration(points: Matrix, lengths: Vector) -> tuple[Vector, Vector]:
    """Position from distances, closed form; returns (position [m], pivots [m^2]).

    |b_i|^2 - 2 b_i.c + |c|^2 = l_i^2 minus its mean over the cables is linear in c, for any bases.
    """
    count, dimension = len(points), len(points[0])
    centre = [total([point[k] for point in points]) / count for k in range(dimension)]
    arms = [subtract(point, centre) for point in points]
    squares = [dot(arm, arm) - length * length for arm, length in zip(arms, lengths, strict=True)]
    mean = total(squares) / count
    columns = transpose(arms)
    right = [x / 2 for x in multiply(columns, [square - mean for square in squares])]
    offset, pivots = solve_positive(gram(columns), right)
    return [a + b for a, b in zip(centre, offset, strict=True)], pivots


def gauss_newton_step(points: Matrix, lengths: Vector, pose: Vector) -> tuple[Vector, Vector]:
    """One step on sum (l_i - |b_i - c|)^2 from `pose`; returns (new pose [m], distances there)."""
    vectors = [subtract(point, pose) for point in points]
    distances = [norm(vector) for vector in vectors]
    columns = transpose(directions(vectors, distances))
    step, _ = solve_positive(gram(columns), multiply(columns, subtract(distances, lengths)))
    return add_scaled(pose, 1, step), distances


class Fix:
    """The pose that fits cable lengths best, and what the lengths disagree by (Yoon eq. 19)."""

    def __init__(self, machine: Machine, lengths: Vector, rails: Vector) -> None:
        points = base_points(machine, rails)
        self.machine = machine
        self.start, self.spread = multilateration(points, lengths)
        self.pose, self.distances = gauss_newton_step(points, lengths, self.start)
        self.vectors = [subtract(point, self.pose) for point in points]
        self.reach = [norm(vector) for vector in self.vectors]
        self.misfit = subtract(lengths, self.reach)

    def verdicts(self) -> tuple[Verdict, ...]:
        """Where the lengths tell no pose."""
        least = (1e-4 * max(self.machine.frame.size)) ** 2
        return (
            not_all_above(self.spread, least, "the bases lie on one line"),
            not_all_above(self.distances, CONTACT_DISTANCE, "the platform is at a pulley"),
        )

    def outputs(self) -> tuple[Output, ...]:
        """Pose and residual."""
        return vector_output("pose", "m", self.pose), scalar_output(
            "residual", "m", norm(self.misfit)
        )

    def labels(self) -> tuple[Label, ...]:
        """Names for what is computed on the way."""
        return (
            Label("start", self.start, "differences of squared lengths are linear in the pose"),
            Label("distance", self.distances, "one Gauss-Newton step"),
            Label("misfit", self.misfit, "what the lengths disagree by: slack, an encoder fault"),
        )


def forward_kinematics_function(machine: Machine) -> ModelFunction:
    """Pose from cable lengths and rail coordinates."""
    lengths, rails = arguments.lengths(machine), arguments.rails(machine)
    fix = Fix(machine, lengths.scalars(), rails.scalars())
    return ModelFunction(
        "forward_kinematics",
        "Pose from lengths: closed form, then one Gauss-Newton step on the least-squares misfit",
        "Yoon eq. 19",
        (lengths, rails),
        fix.outputs(),
        fix.verdicts(),
        fix.labels(),
    )


def locate_function(machine: Machine) -> ModelFunction:
    """All that a controller needs to know of where the platform is, in one call."""
    lengths, rails = arguments.lengths(machine), arguments.rails(machine)
    length_rates, rail_rates = arguments.rates(machine)
    fix = Fix(machine, lengths.scalars(), rails.scalars())
    rays = directions(fix.vectors, fix.reach)
    velocity, pivots = least_squares_velocity(
        machine, rays, length_rates.scalars(), rail_rates.scalars()
    )
    return ModelFunction(
        "locate",
        "Pose, residual, structure matrix and velocity at once: forward_kinematics, "
        "structure_matrix and task_velocity without their common work",
        "Yoon eq. 19, 21, 20 with normalised rows",
        (lengths, rails, length_rates, rail_rates),
        (
            *fix.outputs(),
            matrix_output("structure", "1", transpose(rays)),
            vector_output("velocity", "m/s", velocity),
        ),
        (*fix.verdicts(), touches_a_pulley(fix.reach), loses_rank(pivots)),
        fix.labels(),
    )


def functions(machine: Machine) -> list[ModelFunction]:
    """Everything this topic generates."""
    result = [
        base_points_function(machine),
        cable_vectors_function(machine),
        cable_lengths_function(machine),
        structure_matrix_function(machine),
        length_jacobian_function(machine),
        task_velocity_function(machine),
        forward_kinematics_function(machine),
        locate_function(machine),
    ]
    if machine.rails:
        result.append(rail_jacobian_function(machine))
    return result
