"""The controller step as one CasADi function, composed from the same symbolic model."""

import math
from collections.abc import Callable, Mapping

import casadi as ca
import numpy as np

from turnbuckle.lab.benchmark.solvers.qrqp import EXACT, tension_function
from turnbuckle.lab.benchmark.tension_problems import Reals
from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic.function import ModelFunction
from turnbuckle.model.symbolic.topics import model_functions

#: The names of what a cycle remembers, with the numbers it takes for each cable or rail.
CABLE_MEMORY = {"lengths": 1, "length_rates": 1, "observer": 5, "torque": 1}
RAIL_MEMORY = {"rails": 1, "rail_rates": 1, "base": 3}

Values = dict[str, ca.MX]


class ModelStep:
    """(inputs, memory) -> (outputs, next memory), for `machine` with rails and an observer.

    inputs: lengths (n), rails (m), force (d), hand force (d); outputs: motor torque (n) [N m],
    rail force (m) [N]. As the runtime's step, but without its status and its safe fallbacks.
    """

    def __init__(self, machine: Machine, tolerances: Mapping[str, float] = EXACT) -> None:
        self.machine = machine
        self.cables, self.rails, self.dof = (
            len(machine.cables),
            len(machine.rails),
            machine.dof,
        )
        self.functions = {
            function.name: casadi_function(function)
            for topic in ("kinematics", "control")
            for function in model_functions(machine)[topic]
        }
        self.distribute = tension_function(machine, "distribute", tolerances)

    @property
    def inputs(self) -> dict[str, int]:
        """Sizes of the inputs, in order."""
        return {
            "lengths": self.cables,
            "rails": self.rails,
            "force": self.dof,
            "hand_force": self.dof,
        }

    @property
    def memory(self) -> dict[str, int]:
        """Sizes of what is remembered, in order."""
        cable = {name: size * self.cables for name, size in CABLE_MEMORY.items()}
        return cable | {name: size * self.rails for name, size in RAIL_MEMORY.items()}

    def function(self, name: str) -> ca.Function:
        """The step as a CasADi function."""
        given, memory = symbols("inputs", self.inputs), symbols("memory", self.memory)
        values, kept = split(given, self.inputs), split(memory, self.memory)
        outputs, following = self.step(values, kept)
        ordered = ca.vertcat(*(following[key] for key in self.memory))
        return ca.Function(name, [given, memory], [outputs, ordered])

    def start(self, given: Reals) -> Reals:
        """Memory of a machine at rest whose first measurements are `given`."""
        lengths, rails = given[: self.cables], given[self.cables : self.cables + self.rails]
        observer, base = np.zeros((self.cables, 5)), np.zeros((self.rails, 3))
        observer[:, 0], base[:, 1] = lengths, rails
        known = {"lengths": lengths, "rails": rails, "observer": observer, "base": base}
        parts = [known.get(name, np.zeros(size)) for name, size in self.memory.items()]
        return np.concatenate([part.ravel() for part in parts])

    def step(self, given: Values, kept: Values) -> tuple[ca.MX, Values]:
        """One cycle, in the order of the runtime."""
        call: Callable[..., tuple[ca.MX, ...]] = self.call
        pose, _ = call("forward_kinematics", given["lengths"], given["rails"])
        length_rates = self.filtered(given["lengths"], kept["lengths"], kept["length_rates"])
        rail_rates = self.filtered(given["rails"], kept["rails"], kept["rail_rates"])
        (velocity,) = call("task_velocity", pose, given["rails"], length_rates, rail_rates)
        (target,) = call("base_targets", pose)
        base, rail_force = call("base_pid", kept["base"], target, given["rails"])
        (wall,) = call("wall_force", pose, velocity)
        (rows,) = call("structure_matrix", pose, given["rails"])
        structure = ca.reshape(rows, self.cables, self.dof).T
        tension = self.distribute(structure, wall + given["force"])
        applied = kept["torque"] / self.machine.drum.radius
        (load,) = call("load_tension", rows, applied, given["hand_force"])
        observer, disturbance = call(
            "observe_disturbance", kept["observer"], given["lengths"], load, kept["torque"]
        )
        (wanted,) = call("motor_torques", tension)
        torque = self.gated(kept["torque"], wanted + self.compensation(disturbance))
        following = {
            "lengths": given["lengths"],
            "length_rates": length_rates,
            "observer": observer,
            "torque": torque,
            "rails": given["rails"],
            "rail_rates": rail_rates,
            "base": base,
        }
        return ca.vertcat(torque, rail_force), following

    def call(self, name: str, *arguments: ca.MX) -> tuple[ca.MX, ...]:
        """A function of the model, always as a tuple."""
        result = self.functions[name](*arguments)
        return result if isinstance(result, tuple) else (result,)

    def filtered(self, now: ca.MX, before: ca.MX, rates: ca.MX) -> ca.MX:
        """First-order low-pass on the backward difference."""
        control = self.machine.control
        gain = 1 - math.exp(-2 * math.pi * control.velocity_corner / control.rate)
        return rates + gain * ((now - before) * control.rate - rates)

    def compensation(self, disturbance: ca.MX) -> ca.MX:
        """As much of the estimated disturbance as the largest tension leaves room for."""
        machine = self.machine
        room = machine.cable_motor.torque_limit - machine.drum.radius * machine.tension.max
        return ca.fmin(ca.fmax(disturbance, -room), room)

    def gated(self, before: ca.MX, wanted: ca.MX) -> ca.MX:
        """The torque gate: within the limit, then within the rate."""
        motor = self.machine.cable_motor
        step = motor.torque_rate_limit / self.machine.control.rate
        within = ca.fmin(ca.fmax(wanted, 0), motor.torque_limit)
        return ca.fmin(ca.fmax(within, before - step), before + step)


def casadi_function(function: ModelFunction) -> ca.Function:
    """A function of the model as CasADi has it: no bounds checked, no status."""
    return ca.Function(
        function.name,
        [argument.symbols for argument in function.inputs],
        [ca.vertcat(*output.values) for output in function.outputs],
    )


def symbols(name: str, sizes: dict[str, int]) -> ca.MX:
    """One vector for all the parts."""
    return ca.MX.sym(name, sum(sizes.values()))


def split(vector: ca.MX, sizes: dict[str, int]) -> Values:
    """The parts of a vector, by name."""
    offsets = [0]
    for size in sizes.values():
        offsets.append(offsets[-1] + size)
    return dict(zip(sizes, ca.vertsplit(vector, offsets), strict=True))
