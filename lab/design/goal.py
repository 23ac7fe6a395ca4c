"""What makes one machine better than another."""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import ClassVar, NamedTuple

import numpy as np

from turnbuckle.lab.design.document import Changes
from turnbuckle.lab.design.target import isotropic_force
from turnbuckle.model.machine import Machine
from turnbuckle.model.workspace.rows import Array


class Score(NamedTuple):
    """How good a machine is."""

    merit: float
    """Larger is better, also where the goal is not attained."""
    attained: bool
    """Whether the machine does what the goal asks at every pose of the target."""
    figures: tuple[float, ...]
    """What the goal's `figures` name."""


class Goal(ABC):
    """What is wanted of a machine: that its merit be large at the worst pose of the target."""

    figures: ClassVar[tuple[str, ...]]
    """What a score tells, with units; the first is what the goal is about."""
    unattained: ClassVar[str]
    """What is said of the best machine where none attains the goal; {k} is figure k."""

    @abstractmethod
    def merits(self, machine: Machine) -> Array:
        """Merit (k) at every pose of the target, for a candidate read with `allowance`."""

    @abstractmethod
    def score(self, machine: Machine) -> Score:
        """The score of a candidate read with `allowance` in its file."""

    @abstractmethod
    def present(self, machine: Machine) -> Score:
        """The score of a machine just as its file describes it."""

    def allowance(self) -> Changes:
        """Changes with which every candidate is read, as long as `settlement` is not known."""
        return {}

    def settlement(self, machine: Machine, score: Score) -> Changes:
        """Changes that the goal itself makes to the file of a candidate with this score."""
        return {}


@dataclass(frozen=True)
class IsotropicForce(Goal):
    """The least isotropic force I_F in the target is to be as large as possible [N]."""

    figures = ("least isotropic force [N]", "mean isotropic force [N]", "share of target held")
    unattained = "the cables hold the platform in {2:.0%} of the target"

    def merits(self, machine: Machine) -> Array:
        return isotropic_force(machine)

    def score(self, machine: Machine) -> Score:
        merits = self.merits(machine)
        least, force = float(merits.min()), np.maximum(merits, 0)
        figures = float(force.min()), float(force.mean()), float(np.mean(merits > 0))
        return Score(least, least > 0, figures)

    def present(self, machine: Machine) -> Score:
        return self.score(machine)
