"""Forces between cables, platform and bases: Yoon section II-B."""

from model.machine import Machine
from model.symbolic import arguments, kinematics
from model.symbolic.function import ModelFunction, vector_output
from model.symbolic.linear import multiply
from model.symbolic.scalar import Vector


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


def functions(machine: Machine) -> list[ModelFunction]:
    """Everything this topic generates."""
    result = [wrench_function(machine)]
    if machine.rails:
        result.append(rail_forces_function(machine))
    return result
