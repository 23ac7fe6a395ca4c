"""The smallest motors that give the wanted force in the whole target."""

from collections.abc import Sequence
from dataclasses import dataclass
from decimal import ROUND_CEILING, Context, Decimal

import numpy as np

from turnbuckle.lab.design import DesignError
from turnbuckle.lab.design.document import Changes, Document, Location
from turnbuckle.lab.design.goal import Goal, Score
from turnbuckle.lab.design.target import needed_tension
from turnbuckle.lab.design.vary import Range, in_words
from turnbuckle.model.machine import Machine
from turnbuckle.model.problem import Problem
from turnbuckle.model.quantity import LARGEST, Quantity
from turnbuckle.model.workspace.rows import Array

TENSION: Location = ("tension", "max")
TORQUE: Location = ("cable_motor", "torque_limit")
ALLOWANCE: Changes = {TENSION: "1e6 N", TORQUE: "1e6 N*m"}
"""More than any motor has, so that no candidate is refused for its present motors."""
ROUNDING = 64 * float(np.finfo(float).eps)
"""Relative error that rounding may leave in a tension that just gives the wanted force."""
DIGITS = 6
"""Significant digits of the tension and the torque that are written to the file."""


@dataclass(frozen=True)
class Motor(Goal):
    """The torque T_max r_p that a motor needs for the wanted force is to be as small as possible.

    T_max follows from the rest of the machine, and the torque limit keeps its proportion to
    T_max r_p, as the file has it.
    """

    figures = ("motor torque [N*m]", "largest tension [N]", "share of target served")
    unattained = "the wanted force is to be had in {2:.0%} of the target"

    lowest: float
    """T_max is not less [N]."""
    highest: float
    """T_max is not more [N]."""
    reserve: float
    """Torque limit over T_max r_p."""
    tension_unit: str
    torque_unit: str

    def merits(self, machine: Machine) -> Array:
        torque = np.maximum(needed_tension(machine), self.lowest) * machine.drum.radius
        return np.asarray(-np.minimum(torque, LARGEST))

    def score(self, machine: Machine) -> Score:
        needed = needed_tension(machine)
        tension = max(self.lowest, float(needed.max()))
        return _score(machine, needed, tension, self.highest)

    def present(self, machine: Machine) -> Score:
        return _score(machine, needed_tension(machine), machine.tension.max, machine.tension.max)

    def allowance(self) -> Changes:
        return ALLOWANCE

    def settlement(self, machine: Machine, score: Score) -> Changes:
        newton, newton_metre = _in_si(self.tension_unit, "N"), _in_si(self.torque_unit, "N*m")
        tension = _rounded_up(score.figures[1] / newton)
        torque = float(tension) * newton * machine.drum.radius
        limit = _rounded_up(self.reserve * torque / newton_metre)
        return {
            TENSION: in_words(tension, self.tension_unit),
            TORQUE: in_words(limit, self.torque_unit),
        }


def motor_goal(document: Document, ranges: Sequence[Range]) -> tuple[Motor, tuple[Range, ...]]:
    """The goal, and the ranges left to search; one of tension.max alone becomes its bounds."""
    machine = document.machine({})
    unit, torque_unit = document.quantity(TENSION).unit, document.quantity(TORQUE).unit
    lowest, highest = 0.0, np.inf
    rest = []
    for range_ in ranges:
        if not {TENSION, TORQUE} & set(range_.locations):
            rest.append(range_)
        elif range_.locations != (TENSION,) or range_.count:
            allowed = "with the goal motor only tension.max=LOW..HIGH, the rest follows from it"
            problem = Problem(f"--vary {range_.key}", "a motor's limit that varies", allowed)
            raise DesignError(f"{document.path}: {problem}")
        else:
            lowest, highest = (float(end) * _in_si(unit, "N") for end in (range_.low, range_.high))
    reserve = machine.cable_motor.torque_limit / (machine.tension.max * machine.drum.radius)
    return Motor(lowest, highest, reserve, unit, torque_unit), tuple(rest)


def _score(machine: Machine, needed: Array, tension: float, highest: float) -> Score:
    """With this T_max [N] where poses need so much (k) [N], and no more than `highest` is there."""
    possible = np.isfinite(needed)
    served = possible & (needed <= min(tension, highest) * (1 + ROUNDING))
    radius = machine.drum.radius
    torque = min(max(tension, float(needed.max())) * radius, LARGEST)
    # A pose that no tension serves counts more than any torque.
    merit = -torque - LARGEST * float(np.mean(~possible))
    return Score(merit, bool(served.all()), (tension * radius, tension, float(served.mean())))


def _rounded_up(value: float) -> Decimal:
    """The value in few digits, not below it by more than rounding."""
    context = Context(prec=DIGITS, rounding=ROUND_CEILING)
    return context.create_decimal_from_float(value * (1 - ROUNDING))


def _in_si(unit: str, si: str) -> float:
    """How many of the SI unit one unit is."""
    return Quantity("a quantity", si, f"1 {si}").parse(f"1 {unit}")
