#!/usr/bin/env bash
# From URDF, a joint's lowest velocity is the same positive number as its highest.
#
# Package   Pinocchio 4.1.0 (pin).
# Input     A URDF with <limit lower="-1" upper="1" effort="30" velocity="2"/>.
# Expected  lowerVelocityLimit is -2, as lowerEffortLimit is -30 and lowerDryFrictionLimit is the
#           negative of the upper one.
# Seen      lowerVelocityLimit is +2, equal to upperVelocityLimit: the interval is one point. A
#           clamp to it turns every velocity, and rest, into full speed ahead; a QP with these
#           bounds on the joint velocities has only that solution.
# Documents The attributes are described as "Joint min velocity" and "Joint max velocity".
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
<link name="drum"><inertial><mass value="1"/>
<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="winch" type="{}"><parent link="frame"/><child link="drum"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="1" effort="30" velocity="2"/><dynamics damping="0" friction="1.5"/>
</joint></robot>"""

print("Pinocchio", pinocchio.__version__)
for kind in ("revolute", "prismatic", "continuous"):
    model = pinocchio.buildModelFromXML(URDF.format(kind))
    limits = {
        name: tuple(getattr(model, side + name + "Limit").tolist() for side in ("lower", "upper"))
        for name in ("Velocity", "Effort", "DryFriction")
    }
    print(kind, limits)
    print("  rest, clamped to the velocities:", np.clip(0.0, *map(np.array, limits["Velocity"])))
    if limits["Effort"] != ([-30.0], [30.0]) or limits["DryFriction"] != ([-1.5], [1.5]):
        raise SystemExit("The other limits are not what they were.")
    if limits["Velocity"] != ([2.0], [2.0]):
        raise SystemExit("The behaviour has changed.")
PYTHON
