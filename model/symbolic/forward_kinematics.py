"""Where the platform is, from the lengths of its cables: Yoon eq. 19.

A point held by cables through points has a closed form. A platform that turns, or cables over
pulleys of some radius, have none: there Gauss-Newton starts from a guess of the pose.
"""

import math

import casadi as ca

from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic import arguments, kinematics
from turnbuckle.model.symbolic.angle import rotation_vector_rate
from turnbuckle.model.symbolic.function import (
    EPSILON,
    Input,
    Label,
    ModelFunction,
    Output,
    Repeat,
    Verdict,
    carried,
    matrix_output,
    not_all_above,
    scalar_output,
    vector_output,
)
from turnbuckle.model.symbolic.kinematics import (
    CONTACT_DISTANCE,
    Cables,
    loses_rank,
    touches_a_pulley,
)
from turnbuckle.model.symbolic.linear import (
    add_scaled,
    dot,
    gram,
    multiply,
    norm,
    solve_positive,
    subtract,
    transpose,
)
from turnbuckle.model.symbolic.scalar import Matrix, Scalar, Vector, clamp, smallest, total, where

#: A step moves the platform by at most this share of the frame's diagonal ...
LONGEST_STEP = 0.25
#: ... and turns it by at most this [rad]: beyond, directions of cables say little of the next pose.
WIDEST_TURN = 0.5
#: Twice what any of 120 000 poses of targets took, from the target's centre or from a guess off by
#: 5 % of the diagonal along every axis and 0.2 rad: 8; 12 where lengths disagree by 1 mm.
MOST_STEPS = 16
#: The fit is found when a step changes the lengths by less than this many roundings of the frame.
FITTED_ROUNDINGS = 16.0
#: ... or by less than this share of what the lengths disagree by: steps shrink slowly there, and
#: where the lengths are 10 mm off, rounding would not be reached in time at one pose in ten.
FITTED_SHARE = 1e-9
#: Bases count as on one line, or plane, when they are off it by less than this share of the frame,
FLATTEST = 1e-4
#: ... or, as squares tell, by the root of so many EPSILON of it, which is rounding.
FLATTEST_ROUNDINGS = 64.0


def needs_guess(machine: Machine) -> bool:
    """Whether the pose has no closed form, so that its search starts from a guess."""
    return machine.is_rigid or any(machine.pulleys)


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
    columns = transpose(kinematics.directions(vectors, distances))
    step, _ = solve_positive(gram(columns), multiply(columns, subtract(distances, lengths)))
    return add_scaled(pose, 1, step), distances


class ClosedForm:
    """The pose that fits cable lengths best, and what the lengths disagree by (Yoon eq. 19)."""

    def __init__(self, machine: Machine, lengths: Vector, rails: Vector) -> None:
        points = kinematics.base_points(machine, rails)
        self.machine = machine
        self.start, self.pivots = multilateration(points, lengths)
        self.pose, self.distances = gauss_newton_step(points, lengths, self.start)
        self.at = kinematics.cables(machine, self.pose, rails)
        self.misfit = subtract(lengths, self.at.lengths)

    def verdicts(self) -> tuple[Verdict, ...]:
        """Where the lengths tell no pose."""
        flattest = ca.fmax(FLATTEST**2, FLATTEST_ROUNDINGS * EPSILON)
        least = max(self.machine.frame.size) ** 2 * flattest
        where_bases_are = "line" if self.machine.space == 2 else "plane"
        free = [*self.distances, *self.at.clearances]
        return (
            not_all_above(self.pivots, least, f"the bases lie on one {where_bases_are}"),
            not_all_above(free, CONTACT_DISTANCE, "the platform is at a pulley"),
        )

    def outputs(self) -> tuple[Output, ...]:
        """Pose and residual."""
        return vector_output("pose", "m", self.pose), scalar_output(
            "residual", "m", norm(self.misfit)
        )

    def labels(self) -> tuple[Label, ...]:
        """Names for what is computed on the way."""
        return (
            Label(
                "start",
                self.start,
                "differences of squared lengths are linear in the pose",
            ),
            Label("distance", self.distances, "one Gauss-Newton step"),
            Label("misfit", self.misfit, "what the lengths disagree by: slack, an encoder fault"),
        )


def forward_kinematics_function(machine: Machine) -> ModelFunction:
    """Pose from cable lengths and rail coordinates, in closed form."""
    lengths, rails = arguments.lengths(machine), arguments.rails(machine)
    fix = ClosedForm(machine, lengths.scalars(), rails.scalars())
    return ModelFunction(
        "forward_kinematics",
        "Pose from lengths: closed form, then one Gauss-Newton step on the least-squares misfit",
        "Yoon eq. 19",
        (lengths, rails),
        fix.outputs(),
        fix.verdicts(),
        fix.labels(),
    )


SEARCH_SUMMARY = (
    "Pose from lengths: Gauss-Newton on the least-squares misfit, from a guess of the pose, until "
    f"a step changes the lengths by rounding or by {FITTED_SHARE:g} of the residual"
)
LOCATE_SUMMARY = (
    "Pose, residual, structure matrix and velocity at once: forward_kinematics, "
    "structure_matrix and task_velocity without their common work"
)
LOCATE_SOURCE = "Yoon eq. 19, 21, 20 with normalised rows"


def locate_function(machine: Machine) -> ModelFunction:
    """All that a controller needs to know of where the platform is, in one call."""
    lengths, rails = arguments.lengths(machine), arguments.rails(machine)
    length_rates, rail_rates = arguments.rates(machine)
    fix = ClosedForm(machine, lengths.scalars(), rails.scalars())
    velocity, pivots = kinematics.least_squares_velocity(
        fix.at, length_rates.scalars(), rail_rates.scalars()
    )
    return ModelFunction(
        "locate",
        LOCATE_SUMMARY,
        LOCATE_SOURCE,
        (lengths, rails, length_rates, rail_rates),
        (
            *fix.outputs(),
            matrix_output("structure", "1", fix.at.structure),
            vector_output("velocity", "m/s", velocity),
        ),
        (*fix.verdicts(), loses_rank(pivots)),
        fix.labels(),
    )


def diagonal(machine: Machine) -> float:
    """Diagonal of the frame [m]."""
    return math.hypot(*machine.frame.size)


class Search:
    """Gauss-Newton on sum (l_i - l_i(pose))^2 from a guess: the parts of a `Repeat`."""

    def __init__(self, machine: Machine, name: str) -> None:
        self.machine, self.name = machine, name
        self.lengths, self.rails = arguments.lengths(machine), arguments.rails(machine)
        self.guess = arguments.pose(machine, "guess")

    def begin(self, *more: Input) -> ModelFunction:
        """The guess becomes the first estimate; `more` arguments are for the end."""
        unit = self.guess.unit
        return ModelFunction(
            f"{self.name}_begin",
            "The guess is the first estimate",
            "",
            (self.guess, self.lengths, self.rails, *more),
            (vector_output("estimate", unit, self.guess.scalars()),),
        )

    def here(self) -> tuple[Input, Cables, Vector]:
        """The estimate as an argument, the cables there, and what the lengths disagree by [m]."""
        unit = self.guess.unit
        (estimate,) = carried([vector_output("estimate", unit, self.guess.scalars())])
        at = kinematics.cables(self.machine, estimate.scalars(), self.rails.scalars())
        return estimate, at, subtract(self.lengths.scalars(), at.lengths)

    def step(self) -> ModelFunction:
        """One step, shortened where it is long."""
        estimate, at, misfit = self.here()
        rows = kinematics.comparable(self.machine, at.structure)
        slope = multiply(rows, [-x for x in misfit])
        step, pivots = solve_positive(gram(rows), slope)
        better = self.moved(estimate.scalars(), step)
        change = FITTED_ROUNDINGS * EPSILON * diagonal(self.machine)
        noise = FITTED_SHARE * FITTED_SHARE * dot(misfit, misfit)
        done = dot(slope, step) <= change * change + noise
        return ModelFunction(
            f"{self.name}_step",
            "Gauss-Newton step on the misfit of the lengths",
            "",
            (self.lengths, self.rails, estimate),
            (
                vector_output("estimate", estimate.unit, better),
                scalar_output("found", "1", where(done, 1, 0)),
            ),
            (touches_a_pulley(at.clearances), loses_rank(pivots)),
        )

    def moved(self, pose: Vector, step: Vector) -> Vector:
        """The pose after a step (v, lever w), kept where poses are accepted."""
        share = self.shortening(step)
        twist = kinematics.as_twist(self.machine, [share * entry for entry in step])
        position, rotation = pose[: self.machine.space], pose[self.machine.space :]
        spin = twist[self.machine.space :]
        turn = rotation_vector_rate(rotation, spin) if len(spin) == 3 else spin
        moves = zip(position + rotation, twist[: self.machine.space] + turn, strict=True)
        bounds = zip(self.guess.low, self.guess.high, strict=True)
        return [clamp(x + dx, *bound) for (x, dx), bound in zip(moves, bounds, strict=True)]

    def shortening(self, step: Vector) -> Scalar:
        """The share of a step (v, lever w) that is taken."""
        space, machine = self.machine.space, self.machine
        shares = [1 / ca.fmax(1, norm(step[:space]) / (LONGEST_STEP * diagonal(machine)))]
        if machine.is_rigid:
            shares.append(1 / ca.fmax(1, norm(step[space:]) / (WIDEST_TURN * machine.lever)))
        return smallest(shares)

    def fit(self) -> tuple[Input, Cables, tuple[Output, ...], Label]:
        """The last estimate, the cables there, pose and residual."""
        estimate, at, misfit = self.here()
        pose = vector_output("pose", estimate.unit, estimate.scalars())
        label = Label("misfit", misfit, "what the lengths disagree by: slack, an encoder fault")
        return estimate, at, (pose, scalar_output("residual", "m", norm(misfit))), label


def forward_kinematics_search(machine: Machine) -> Repeat:
    """Pose from cable lengths and rail coordinates, by Gauss-Newton from a guess."""
    search = Search(machine, "forward_kinematics")
    estimate, at, outputs, label = search.fit()
    rows = kinematics.comparable(machine, at.structure)
    _, pivots = solve_positive(gram(rows), [0] * machine.dof)
    finish = ModelFunction(
        "forward_kinematics_finish",
        "Pose and residual of the last estimate",
        "",
        (search.lengths, search.rails, estimate),
        outputs,
        (touches_a_pulley(at.clearances), loses_rank(pivots)),
        (label,),
    )
    return Repeat(
        "forward_kinematics",
        SEARCH_SUMMARY,
        "Yoon eq. 19",
        search.begin(),
        search.step(),
        finish,
        MOST_STEPS,
    )


def locate_search(machine: Machine) -> Repeat:
    """All that a controller needs to know of where the platform is, from a guess of its pose."""
    search = Search(machine, "locate")
    length_rates, rail_rates = arguments.rates(machine)
    estimate, at, outputs, label = search.fit()
    velocity, pivots = kinematics.least_squares_velocity(
        at, length_rates.scalars(), rail_rates.scalars()
    )
    finish = ModelFunction(
        "locate_finish",
        "Everything at the last estimate",
        "",
        (search.lengths, search.rails, length_rates, rail_rates, estimate),
        (
            *outputs,
            matrix_output("structure", arguments.structure_unit(machine), at.structure),
            vector_output("velocity", arguments.velocity_unit(machine), velocity),
        ),
        (touches_a_pulley(at.clearances), loses_rank(pivots)),
        (label,),
    )
    begin = search.begin(length_rates, rail_rates)
    return Repeat("locate", LOCATE_SUMMARY, LOCATE_SOURCE, begin, search.step(), finish, MOST_STEPS)


def functions(machine: Machine) -> list[ModelFunction]:
    """What this topic generates where the pose has a closed form."""
    if needs_guess(machine):
        return []
    return [forward_kinematics_function(machine), locate_function(machine)]


def searches(machine: Machine) -> list[Repeat]:
    """What this topic generates where the pose has none."""
    if not needs_guess(machine):
        return []
    return [forward_kinematics_search(machine), locate_search(machine)]
