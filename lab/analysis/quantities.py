"""What the maps of a machine show."""

import numpy as np

from turnbuckle.lab.analysis.plots import Quantity
from turnbuckle.lab.analysis.slices import LagPanel, Panel
from turnbuckle.model.machine import Machine
from turnbuckle.model.workspace.rows import Array

NOTHING = 1e-9  # of T_max: a force below this is rounding
MOST_TORQUE = 2.0  # of the motor's limit: more is shown as this much


def wanted_words(machine: Machine) -> str:
    """What the target asks for, "7 N" or "2 N and 50 mN m"."""
    target = machine.target
    moment = f" and {target.moment * 1e3:.4g} mN m" if target.moment else ""
    return f"{target.force:.4g} N{moment}"


def quantities(machine: Machine) -> tuple[Quantity, ...]:
    """The maps of a machine, the most useful first."""
    wanted, name = wanted_words(machine), machine.name
    force, limit = machine.target.force, machine.cable_motor.torque_limit * 1e3
    return (
        Quantity(
            "force",
            f"{name}: force to be had in every direction",
            "isotropic force $I_F$ [N]",
            _force,
            "none in some direction",
            limit=force,
            limit_words=f"{force:.4g} N, wanted",
            low=0.0,
        ),
        Quantity(
            "margin",
            f"{name}: margin of the wanted {wanted} in every direction",
            "margin [N]; below 0 it is not feasible",
            lambda panel: panel.quality.margin,
            "not feasible",
            limit=0.0,
            limit_words=f"border of the workspace with {wanted}",
            least=0.0,
        ),
        Quantity(
            "torque",
            f"{name}: motor torque for the wanted {wanted}",
            "motor torque needed [mN m]",
            lambda panel: _torque(machine, panel),
            "no torque is enough",
            limit=limit,
            limit_words=f"{limit:.4g} mN m, the motors' limit",
            low_is_good=True,
            low=0.0,
            high=MOST_TORQUE * limit,
        ),
        Quantity(
            "zero_wrench",
            f"{name}: margin of holding still, without a force",
            "margin of the zero wrench [N]",
            lambda panel: panel.quality.zero_margin,
            "not feasible: the platform is not held",
            limit=0.0,
            limit_words="border of the workspace without a force",
            least=0.0,
        ),
        Quantity(
            "tension_factor",
            f"{name}: evenness of the tensions that hold the platform still",
            "tension factor TF",
            lambda panel: panel.quality.tension_factor,
            "not defined: the platform is not held",
            low=0.0,
            high=1.0,
        ),
        Quantity(
            "conditioning",
            f"{name}: distance from singular poses",
            r"smallest singular value $\sigma_\mathrm{min}$ of S; 0 is singular",
            _closed_conditioning,
            "outside the theoretical workspace",
            low=0.0,
        ),
    )


def lag_quantity(machine: Machine, lag: float) -> Quantity:
    """I_F with late bases."""
    force = machine.target.force
    return Quantity(
        "lag",
        f"{machine.name}: force in every direction, bases {lag * 1e3:.4g} mm behind",
        "isotropic force $I_F$ [N], worst direction of the lag",
        _late_force,
        "none in some direction",
        limit=force,
        limit_words=f"{force:.4g} N, wanted",
        low=0.0,
    )


def _force(panel: Panel) -> Array:
    return _some(panel.machine, panel.quality.force)


def _late_force(panel: LagPanel) -> Array:
    return _some(panel.machine, panel.force)


def _some(machine: Machine, force: Array) -> Array:
    """NaN where there is nothing but rounding."""
    return np.where(force > NOTHING * machine.tension.max, force, np.nan)


def _torque(machine: Machine, panel: Panel) -> Array:
    return np.asarray(panel.quality.needed_tension * machine.drum.radius * 1e3)


def _closed_conditioning(panel: Panel) -> Array:
    return np.where(panel.quality.closure, panel.quality.conditioning, np.nan)
