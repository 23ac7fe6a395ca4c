#!/usr/bin/env bash
# A motor's kinetic energy is forgotten if its joint does not turn about x, y or z.
#
# Package   Pinocchio 4.1.0 (pin).
# Input     A winch: a drum of 0.02 kg m^2 about every axis, a rotor of 0.5 kg m^2
#           (model.armature), turning about the axis given in the URDF.
# Expected  computeKineticEnergy() equals v' M v / 2, with M from crba(), for every axis: the drum
#           is a ball, so the axis cannot matter. (Or the rotor is left out for all of them.)
# Seen      1.04 J about x, y and z. About (1 1 0), and about (1e-3 0 1), 0.04 J: the rotor is
#           gone, though crba() and rnea() hold it. A sliding joint along the same axis, and an
#           unlimited ("continuous") one, keep their rotor. An energy observer on such a robot
#           finds 25 times the reported energy made from nothing.
# Documents The help says that the energy of the system is computed, with no word on types of
#           joints.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python3 -m venv "$work/venv"
"$work/venv/bin/pip" install --quiet --disable-pip-version-check \
    pin==4.1.0 cmeel-urdfdom==6.0.0 cmeel-boost==1.90.0 coal==3.0.3 numpy==2.4.6

cd "$work"
venv/bin/python - <<'PYTHON'
import numpy as np
import pinocchio

URDF = """<robot name="winch"><link name="frame"/>
<link name="drum"><inertial><mass value="0.02"/>
<inertia ixx="0.02" iyy="0.02" izz="0.02" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="winch" type="{}"><parent link="frame"/><child link="drum"/><axis xyz="{}"/>
<limit lower="-1" upper="1" effort="30" velocity="2"/></joint></robot>"""
VELOCITY = np.array([2.0])


def energies(kind, axis):
    """One half of v' M v, the torque for 1 rad/s^2 and the kinetic energy that is reported."""
    model = pinocchio.buildModelFromXML(URDF.format(kind, axis))
    model.armature = np.array([0.5])
    data = model.createData()
    position = pinocchio.neutral(model)
    mass = pinocchio.crba(model, data, position).copy()
    torque = pinocchio.rnea(model, data, position, 0 * VELOCITY, np.ones(1))
    torque -= pinocchio.rnea(model, data, position, 0 * VELOCITY, np.zeros(1))
    reported = pinocchio.computeKineticEnergy(model, data, position, VELOCITY)
    figures = (float(0.5 * VELOCITY @ mass @ VELOCITY), float(torque[0]), reported)
    print(f"{kind} {axis}: v'Mv/2, torque and reported energy", *(f"{x:.3f}" for x in figures))
    return figures


print("Pinocchio", pinocchio.__version__)
right, forgotten = (1.04, 0.52, 1.04), (1.04, 0.52, 0.04)
for kind in ("prismatic", "continuous", "revolute"):
    aligned = [energies(kind, axis) for axis in ("1 0 0", "0 1 0", "0 0 1")]
    oblique = [energies(kind, axis) for axis in ("1 1 0", "1e-3 0 1")]
    if not np.allclose(aligned, right):
        raise SystemExit("Along x, y and z the figures are not what they were.")
    if not np.allclose(oblique, forgotten if kind == "revolute" else right):
        raise SystemExit("The behaviour has changed.")
PYTHON
