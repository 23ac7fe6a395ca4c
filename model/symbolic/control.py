"""Control laws around the tension distribution: Yoon section III-E and IV-D."""

import math

import casadi as ca

from turnbuckle.model.machine import Machine, Wall
from turnbuckle.model.symbolic import arguments, kinematics
from turnbuckle.model.symbolic.base_targets import base_targets_function
from turnbuckle.model.symbolic.function import (
    Label,
    ModelFunction,
    Output,
    finite_results,
    judged_by_results,
    vector_output,
)
from turnbuckle.model.symbolic.linear import (
    dot,
    gram,
    multiply,
    solve_positive,
    subtract,
    transpose,
)
from turnbuckle.model.symbolic.scalar import Scalar, Vector, clamp, where

#: Largest result that control laws answer, in its own unit: far beyond any machine.
LARGEST = 1e9


def motor_torques_function(machine: Machine) -> ModelFunction:
    """Torque that holds a tension on the drum."""
    tension = arguments.tension(machine)
    torque = [machine.drum.radius * value for value in tension.scalars()]
    return ModelFunction(
        "motor_torques",
        "Motor torque tau = r_p T",
        "Yoon section III-E",
        (tension,),
        (vector_output("torque", "N m", torque),),
    )


def wall_force_function(machine: Machine) -> ModelFunction:
    """Force of the virtual walls on the hand, at the centre of a rigid platform: no moment."""
    pose, velocity = arguments.pose(machine), arguments.velocity(machine)
    position, motion = (entry.scalars()[: machine.space] for entry in (pose, velocity))
    force: Vector = [ca.SX(0)] * machine.space
    pushes: Vector = []
    for wall in machine.walls:
        pushes.append(wall_push(wall, position, motion))
        force = [f + pushes[-1] * n for f, n in zip(force, wall.normal, strict=True)]
    moment = [ca.SX(0)] * (machine.dof - machine.space)
    return ModelFunction(
        "wall_force",
        "Force of the virtual walls, max(0, k penetration - b v_n) along each normal",
        "Yoon eq. 26, 27, never attractive",
        (pose, velocity),
        (vector_output("force", arguments.wrench_unit(machine), force + moment),),
        (),
        (Label("push", pushes, "spring and damper of each wall"),) if pushes else (),
    )


def wall_push(wall: Wall, position: Vector, velocity: Vector) -> Scalar:
    """Magnitude of the force of one wall along its outward normal [N]."""
    penetration = -dot(subtract(position, list(wall.point)), list(wall.normal))
    leaving = dot(velocity, list(wall.normal))
    push = ca.fmax(0, wall.stiffness * penetration - wall.damping * leaving)
    return where(penetration > 0, push, 0)


def base_pid_function(machine: Machine) -> ModelFunction:
    """Position control of the bases."""
    drive = machine.rail_drive
    assert drive is not None
    count = len(machine.rails)
    period = 1 / machine.control.rate
    memory = judged_by_results(arguments.memory((count, 3), "N, m, m/s"))
    target = judged_by_results(arguments.rails(machine, "target"))
    measured = judged_by_results(arguments.rails(machine, "measured"))
    weight = 1 - math.exp(-2 * math.pi * drive.derivative_corner * period)
    next_memory: Vector = []
    forces: Vector = []
    demands: Vector = []
    for (integral, previous, speed), wish, now in zip(
        memory.rows(), target.scalars(), measured.scalars(), strict=True
    ):
        error = wish - now
        speed = speed + weight * ((now - previous) / period - speed)
        wanted = drive.stiffness * error + integral - drive.damping * speed
        demands.append(wanted)
        force = clamp(wanted, -drive.force_limit, drive.force_limit)
        winding_up = ca.logic_or(
            ca.logic_and(wanted > drive.force_limit, error > 0),
            ca.logic_and(wanted < -drive.force_limit, error < 0),
        )
        grown = integral + drive.integral * period * error
        next_memory += [where(winding_up, integral, grown), now, speed]
        forces.append(force)
    return ModelFunction(
        "base_pid",
        "Force on each base: PID on its rail coordinate, the integral held while saturated",
        "Yoon section III-E, Fig. 13",
        (memory, target, measured),
        (
            Output("next_memory", (count, 3), "N, m, m/s", next_memory),
            vector_output("force", "N", forces),
        ),
        (finite_results(demands, LARGEST),),
    )


def load_tension_function(machine: Machine) -> ModelFunction:
    """What the cables really carry, from the measured force of the hand."""
    structure, tension = arguments.structure(machine), arguments.tension(machine)
    hand = arguments.wrench(machine, "hand_force")
    rows, carried = structure.rows(), tension.scalars()
    surplus = [-h - w for h, w in zip(hand.scalars(), multiply(rows, carried), strict=True)]
    matrix = kinematics.comparable(machine, rows)
    [right] = transpose(kinematics.comparable(machine, [[x] for x in surplus]))
    share, pivots = solve_positive(gram(matrix), right)
    load = [value + dot([row[i] for row in matrix], share) for i, value in enumerate(carried)]
    return ModelFunction(
        "load_tension",
        "Tensions nearest the commanded ones that balance the measured force of the hand",
        "the F_h path of Yoon Fig. 11",
        (structure, tension, hand),
        (vector_output("load", "N", load, fallback=machine.tension.min),),
        (kinematics.loses_rank(pivots),),
    )


def observe_disturbance_function(machine: Machine) -> ModelFunction:
    """Disturbance observer of every cable motor.

    With the pole p and gains of Tustin's 1/(tau s + 1) and s/(tau s + 1) the estimate
    Q Pn^-1 theta + Q u = (J D + B L) (D theta) + L (L u), D = s/(tau s + 1), L = 1/(tau s + 1),
    is a chain of first-order filters: each remembered number is a physical quantity, and single
    precision keeps its accuracy, which a direct second-order form with a double pole does not.
    """
    observer = machine.disturbance_observer
    assert observer is not None
    count = len(machine.cables)
    ratio = 2 * observer.time_constant * machine.control.rate
    pole, passing, rate = (
        (ratio - 1) / (ratio + 1),
        1 / (ratio + 1),
        2 * machine.control.rate / (ratio + 1),
    )
    memory = judged_by_results(arguments.memory((count, 5), "m, rad/s, N m, N m, N m"))
    length = judged_by_results(arguments.lengths(machine, "length"))
    load = judged_by_results(arguments.tension(machine, "load"))
    applied = judged_by_results(arguments.torque(machine, "applied"))
    motor, radius = machine.cable_motor, machine.drum.radius
    next_memory: Vector = []
    disturbances: Vector = []
    for (
        last_length,
        last_speed,
        last_excess,
        last_filtered,
        last_estimate,
    ), now, pull, torque in zip(
        memory.rows(), length.scalars(), load.scalars(), applied.scalars(), strict=True
    ):
        speed = pole * last_speed + (rate / radius) * (now - last_length)
        excess = torque - radius * pull
        filtered = pole * last_filtered + passing * (excess + last_excess)
        estimate = (
            pole * last_estimate
            + rate * motor.inertia * (speed - last_speed)
            + passing * (motor.damping * (speed + last_speed) + (filtered + last_filtered))
        )
        next_memory += [now, speed, excess, filtered, estimate]
        disturbances.append(estimate)
    return ModelFunction(
        "observe_disturbance",
        "Disturbance torque of every cable motor, to be added to its command",
        "Yoon eq. 24, Fig. 11, discretised by Tustin's rule",
        (memory, length, load, applied),
        (
            Output("next_memory", (count, 5), "m, rad/s, N m, N m, N m", next_memory),
            vector_output("disturbance", "N m", disturbances),
        ),
        (finite_results(disturbances, LARGEST),),
    )


def functions(machine: Machine) -> list[ModelFunction]:
    """Everything this topic generates."""
    result = [
        motor_torques_function(machine),
        wall_force_function(machine),
        load_tension_function(machine),
    ]
    if machine.rails:
        result += [base_targets_function(machine), base_pid_function(machine)]
    if machine.disturbance_observer is not None:
        result.append(observe_disturbance_function(machine))
    return result
