"""A recorded motion: what the controller reads, cycle by cycle."""

import numpy as np

from turnbuckle.lab.benchmark.tension_problems import Reals
from turnbuckle.model.machine import Machine
from turnbuckle.model.reference import control, kinematics

#: The handle goes round the target in these times [s]; they share no period.
PERIODS = (5.1, 3.7)
#: Share of the target that the motion covers: it stays clear of the walls.
REACH = 0.6
#: The application's force turns in this time [s] and has this share of the wanted force.
FORCE_PERIOD, FORCE_SHARE = 0.9, 0.6


def recorded_inputs(machine: Machine, cycles: int) -> Reals:
    """Rows of lengths [m] (n), rails [m] (m), force [N] (d), hand force [N] (d)."""
    time = np.arange(cycles) / machine.control.rate
    turns = 2 * np.pi * time[:, None] / np.array(PERIODS)
    pose = machine.target.centre + REACH / 2 * np.array(machine.target.size) * np.sin(turns)
    rails = control.base_targets(machine, pose)
    lengths = kinematics.cable_lengths(machine, pose, rails)
    angle = 2 * np.pi * time / FORCE_PERIOD
    direction = np.stack([np.cos(angle), np.sin(angle)], 1)
    force = FORCE_SHARE * machine.target.force * direction
    return np.ascontiguousarray(np.hstack([lengths, rails, force, -force]), np.float64)
