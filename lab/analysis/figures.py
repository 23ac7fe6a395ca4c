"""The numbers of an analysis: what they are called, in which unit, and how they are shown."""

from collections.abc import Callable
from dataclasses import dataclass
from math import isfinite, nan

from turnbuckle.model.machine import Machine
from turnbuckle.model.workspace.extent import Extent
from turnbuckle.model.workspace.summary import TargetSummary
from turnbuckle.model.workspace.words import demand_in_words, percent


@dataclass(frozen=True)
class Findings:
    """A machine in numbers."""

    machine: Machine
    target: TargetSummary
    extent: Extent


@dataclass(frozen=True)
class Figure:
    """One number: its key in the JSON (SI units), its words, where it is, its unit and scale.

    absent: what is said where it is NaN; endless: where it is infinite.
    """

    key: str
    words: str
    value: Callable[[Findings], float]
    unit: str = ""
    scale: float = 1.0
    absent: str = "not defined"
    endless: str = "none is enough"

    def shown(self, findings: Findings) -> str:
        """The number with its unit, as a reader wants it."""
        return self.in_words(self.value(findings))

    def in_words(self, value: float) -> str:
        """A value with its unit."""
        if value != value:
            return self.absent
        if not isfinite(value):
            return self.endless
        if self.unit == "%":
            return percent(value)
        return f"{value * self.scale:.4g} {self.unit}".rstrip()

    def change(self, before: float, after: float) -> str:
        """From one value to another, with its sign; "" where one of them is no number."""
        if not (isfinite(before) and isfinite(after)):
            return "" if self.in_words(before) == self.in_words(after) else "changed"
        difference = after - before
        if abs(difference) <= 1e-9 * max(abs(before), abs(after)):
            return "="
        if self.unit == "%":
            return f"{100 * difference:+.1f} points"
        return f"{difference * self.scale:+.4g} {self.unit}".rstrip()


def figures(machine: Machine) -> list[Figure]:
    """The numbers of a machine, in the order of the report; always the same keys."""
    wanted = demand_in_words(machine)
    shape = "not sought in space" if machine.space == 3 else "none"
    late = "no base moves"
    return [
        Figure("target_share", f"target with {wanted}", _share, "%"),
        Figure("target_share_zero_wrench", "target held at rest", _zero, "%"),
        Figure("target_share_theoretical", "target in theoretical workspace", _closure, "%"),
        Figure("frame_share_theoretical", "frame in theoretical workspace", _theory, "%"),
        Figure("least_isotropic_force", "least isotropic force", _least, "N"),
        Figure("mean_isotropic_force", "mean isotropic force", _mean, "N"),
        Figure("least_tension_factor", "least tension factor", _factor, absent=_no_factor(machine)),
        Figure("tension_needed", "tension needed", _tension, "N"),
        Figure("torque_needed", "motor torque needed", _torque, "mN m", 1e3),
        Figure("torque_limit", "motor torque limit", _limit, "mN m", 1e3),
        Figure("circle_diameter", f"largest circle with {wanted}", _circle, "mm", 1e3, shape),
        Figure("screen_width", f"largest screen with {wanted}", _width, "mm", 1e3, shape),
        Figure("screen_height", "its height", _height, "mm", 1e3, shape),
        Figure("target_share_lag", "target with the force, late", _late_share, "%", absent=late),
        Figure("least_isotropic_force_lag", "least isotropic force, late", _late_least, "N",
               absent=late),
    ]  # fmt: skip


def _no_factor(machine: Machine) -> str:
    if machine.tension.min == 0:
        return "not defined: T_min = 0"
    return "not defined: nothing held"


def _share(f: Findings) -> float:
    return f.target.coverage.share


def _zero(f: Findings) -> float:
    return f.target.zero_share


def _closure(f: Findings) -> float:
    return f.target.closure_share


def _theory(f: Findings) -> float:
    return f.extent.theoretical


def _least(f: Findings) -> float:
    return f.target.least_force


def _mean(f: Findings) -> float:
    return f.target.mean_force


def _factor(f: Findings) -> float:
    return f.target.least_tension_factor


def _tension(f: Findings) -> float:
    return f.target.actuators.tension


def _torque(f: Findings) -> float:
    return f.target.actuators.torque


def _limit(f: Findings) -> float:
    return f.target.actuators.torque_limit


def _circle(f: Findings) -> float:
    return 2 * f.extent.circle.half_size[0] if f.extent.circle else nan


def _width(f: Findings) -> float:
    return 2 * f.extent.screen.half_size[0] if f.extent.screen else nan


def _height(f: Findings) -> float:
    return 2 * f.extent.screen.half_size[1] if f.extent.screen else nan


def _late_share(f: Findings) -> float:
    return f.target.lagging.share if f.target.lagging else nan


def _late_least(f: Findings) -> float:
    return f.target.lagging.least_force if f.target.lagging else nan
