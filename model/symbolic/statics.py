"""Forces between cables, platform and bases: Yoon section II-B."""

from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic import arguments, kinematics
from turnbuckle.model.symbolic.function import ModelFunction, vector_output
from turnbuckle.model.symbolic.linear import gram, multiply, solve_positive, transpose
from turnbuckle.model.symbolic.scalar import Vector


def wrench_function(machine: Machine) -> ModelFunction:
    """Wrench that the cables exert on the platform."""
    structure, tension = arguments.structure(machine), arguments.tension(machine)
    wrench = multiply(structure.rows(), tension.scalars())
    return ModelFunction(
        "wrench",
        "Wrench of the cables on the platform W = S T",
        "Yoon eq. 7",
        (structure, tension),
        (vector_output("wrench", arguments.wrench_unit(machine), wrench),),
    )


def rail_forces_function(machine: Machine) -> ModelFunction:
    """Force that every cable exerts on its base along the rail."""
    pose, rails = arguments.pose(machine), arguments.rails(machine)
    tension = arguments.tension(machine)
    at = kinematics.cables(machine, pose.scalars(), rails.scalars())
    tensions = tension.scalars()
    forces: Vector = [0] * len(machine.rails)
    for cable, number, slope in kinematics.rail_slopes(machine, at.rays):
        forces[number] = forces[number] - tensions[cable] * slope
    return ModelFunction(
        "rail_forces",
        "Force of the cable on its base along the rail, -T_i lhat_i . e_i; the drive must hold it",
        "Yoon eq. 8, the joint-space force of virtual work",
        (pose, rails, tension),
        (vector_output("force", "N", forces),),
        (kinematics.touches_a_pulley(at.clearances),),
    )


def wrench_share_function(machine: Machine) -> ModelFunction:
    """What Yoon eq. 10 makes of a wrench; no tension, for it lacks the null space of S.

    Eq. 9 cancels the speeds of cables and bases although they are not free, and what is left is the
    particular solution of S T = W of least norm with every tension weighted by 1 / l_i. It can be
    negative, and nothing keeps the cables taut where the wrench is zero.
    """
    pose, rails = arguments.pose(machine), arguments.rails(machine)
    wrench = arguments.wrench(machine)
    at = kinematics.cables(machine, pose.scalars(), rails.scalars())
    lengths = [span.free for span in at.spans]
    rows = kinematics.comparable(machine, at.structure)
    [right] = transpose(kinematics.comparable(machine, [[x] for x in wrench.scalars()]))
    _, pivots = solve_positive(gram(rows), right)
    weighted = [[x * length for x, length in zip(row, lengths, strict=True)] for row in rows]
    multiplier, _ = solve_positive(gram(weighted), right)
    pulls = multiply(transpose(weighted), multiplier)
    share = [length * pull for length, pull in zip(lengths, pulls, strict=True)]
    return ModelFunction(
        "wrench_share_eq10",
        "L^2 S' (S L^2 S')^-1 W with L = diag(l_i): a solution of S T = W weighted by the lengths, "
        "but no tension: it may be negative, and is zero where W is",
        "Yoon eq. 10, to compare",
        (pose, rails, wrench),
        (vector_output("share", "N", share),),
        (kinematics.touches_a_pulley(at.clearances), kinematics.loses_rank(pivots)),
    )


def functions(machine: Machine) -> list[ModelFunction]:
    """Everything this topic generates."""
    result = [wrench_function(machine)]
    if machine.space == 2:
        result.append(wrench_share_function(machine))
    if machine.rails:
        result.append(rail_forces_function(machine))
    return result
