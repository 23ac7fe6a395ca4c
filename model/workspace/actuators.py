"""Which motors a machine needs: tension and torque for a wanted force over a set of poses."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from turnbuckle.model.machine import Machine
from turnbuckle.model.workspace.max_tension import needed_tension
from turnbuckle.model.workspace.structures import Demand, structures, target_demand

ROUNDING = 1e-12  # a limit that is missed by less, relative to it, is met


@dataclass(frozen=True)
class ActuatorChoice:
    """The least T_max [N] with which every pose gives what is wanted, and what it means for motors.

    tension [N] and torque [N m] are inf where no motor is strong enough: the geometry is at fault.
    worst_pose needs the most; tension_limit [N] and torque_limit [N m] are the machine's own.
    """

    tension: float
    torque: float
    worst_pose: tuple[float, ...]
    tension_limit: float
    torque_limit: float

    @property
    def sufficient(self) -> bool:
        """Whether the machine's own motors give the torque."""
        return self.torque <= self.torque_limit * (1 + ROUNDING)

    def __str__(self) -> str:
        place = "(" + ", ".join(f"{x:.4g}" for x in self.worst_pose) + ")"
        if not np.isfinite(self.tension):
            return f"no motor is strong enough: at {place} the cables cannot give it at any tension"
        verdict = "are enough" if self.sufficient else "are not enough"
        text = (
            f"{self.tension:.4g} N of tension and {self.torque * 1e3:.4g} mN m of torque are needed"
            f" at {place}; the motors' {self.torque_limit * 1e3:.4g} mN m {verdict}"
        )
        if self.tension > self.tension_limit * (1 + ROUNDING):
            text += f", and tension.max = {self.tension_limit:.4g} N is too low"
        return text


def choose_actuators(
    machine: Machine,
    poses: npt.ArrayLike,
    rails: npt.ArrayLike,
    demand: Demand | None = None,
) -> ActuatorChoice:
    """Motors for poses (rows, dim) with rail coordinates (rows, m) [m]: by default for the target.

    Exact: for the machine's T_min the facets give the least T_max of every pose in closed form.
    A pose on a pulley is out of reach for any motor.
    """
    places = np.atleast_2d(np.asarray(poses, np.float64))
    wanted = target_demand(machine) if demand is None else demand
    needed = needed_tension(structures(machine, places, rails), machine.tension.min, *wanted)
    needed = np.where(np.isnan(needed), np.inf, needed)
    worst = int(np.argmax(needed))
    tension = float(needed[worst])
    return ActuatorChoice(
        tension=tension,
        torque=tension * machine.drum.radius,
        worst_pose=tuple(places[worst].tolist()),
        tension_limit=machine.tension.max,
        torque_limit=machine.cable_motor.torque_limit,
    )
