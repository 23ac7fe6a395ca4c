"""Poses, shares and demands in words, for messages and reports."""

import math
from collections.abc import Sequence

from turnbuckle.model.machine import Machine
from turnbuckle.model.workspace.actuators import ROUNDING, ActuatorChoice
from turnbuckle.model.workspace.summary import Coverage


def percent(share: float) -> str:
    """A share with one digit; all and nothing only where it is so."""
    if share == 0:
        return "0 %"
    if share < 0.0005:
        return "less than 0.1 %"
    if 0.9995 <= share < 1:
        return "more than 99.9 %"
    return f"{100 * share:.1f} %" if share < 1 else "100 %"


def pose_in_words(machine: Machine, pose: Sequence[float]) -> str:
    """A pose [m, rad] in mm and degrees."""
    position = ", ".join(f"{1e3 * x:.4g}" for x in pose[: machine.space])
    turn = ", ".join(f"{math.degrees(angle):.3g}" for angle in pose[machine.space :])
    words = f"({position}) mm"
    if not turn or not machine.target.rotation:
        return words
    return f"{words} turned by {turn if machine.space == 2 else f'({turn})'} deg"


def demand_in_words(machine: Machine, share: float = 1.0) -> str:
    """So much of the wanted force and moment, such as "2 N and 50 mN m"."""
    target = machine.target
    force = f"{share * target.force:.3g} N"
    return f"{force} and {share * target.moment * 1e3:.3g} mN m" if target.moment else force


def coverage_in_words(machine: Machine, coverage: Coverage) -> str:
    """How much of the target is served, and what is possible at the worst pose."""
    wanted = demand_in_words(machine)
    grid = " x ".join(map(str, coverage.counts))
    if coverage.complete:
        return f"{wanted} in every direction in all of the target ({grid} poses tried)"
    some = "in no part" if coverage.share == 0 else f"in {percent(coverage.share)}"
    text = f"{wanted} in every direction {some} of the target ({grid} poses tried)"
    if coverage.undefined == math.prod(coverage.counts):
        return f"{text}, and every pose is on a pulley"
    possible = demand_in_words(machine, coverage.possible) if coverage.possible else "nothing"
    text += f"; at the worst, {pose_in_words(machine, coverage.worst)}, {possible} is possible"
    return f"{text}; {coverage.undefined} poses are on a pulley" if coverage.undefined else text


def motors_in_words(machine: Machine, choice: ActuatorChoice) -> str:
    """Which motors the target needs, and whether the machine's are enough."""
    place = pose_in_words(machine, choice.worst_pose)
    if not math.isfinite(choice.tension):
        return f"no motor is strong enough at {place}: no tension gives what is wanted there"
    verdict = "are enough" if choice.sufficient else "are not enough"
    text = (
        f"it takes a tension of {choice.tension:.4g} N, {choice.torque * 1e3:.4g} mN m of torque,"
        f" at {place}; the motors' {choice.torque_limit * 1e3:.4g} mN m {verdict}"
    )
    if choice.tension > choice.tension_limit * (1 + ROUNDING):
        also = "but" if choice.sufficient else "and"
        text += f", {also} tension.max = {choice.tension_limit:.4g} N is too low"
    return text
