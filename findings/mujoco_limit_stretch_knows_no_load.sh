#!/usr/bin/env bash
# A cable of 10 kN/m that stretches by the same 0.108 mm under 1, 2 and 10 kg.
#
# Package   MuJoCo 4.0.0, a tendon with range="0 1", the usual model of an inextensible cable.
# Input     A load hangs on the tendon's upper limit, with solreflimit="-10000 -100": the form
#           with negative numbers, which is given as (-stiffness, -damping).
# Expected  m g / k: 0.981 mm, 1.962 mm and 9.81 mm, as of a tendon with stiffness="10000".
# Seen      0.108 mm for every load, a ninth of the least; the force is right each time. The
#           numbers are accelerations per metre, and per metre a second, whatever hangs there. The
#           stretch is g (1 - d) D^2 / (d^2 k), with d the impedance and D its largest value
#           (solimplimit). A cable's stiffness cannot be entered here, and a heavier payload does
#           not sag.
# Documents The modelling chapter calls the two numbers stiffness and damping, which "can be set
#           directly", and gives them no units; that they make an acceleration, not a force,
#           stands in the text on solver parameters.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python3 -m venv "$work/venv"
"$work/venv/bin/pip" install --quiet --disable-pip-version-check mujoco==4.0.0 numpy==2.4.6

cd "$work"
venv/bin/python - <<'PYTHON'
import mujoco

STIFFNESS = 10_000.0
GRAVITY = 9.81
MODEL = """<mujoco><option timestep="0.001" gravity="0 0 -{gravity}"/><worldbody>
<site name="anchor" pos="0 0 2"/>
<body pos="0 0 1"><joint type="slide" axis="0 0 1"/><site name="load"/>
<geom size=".02" mass="{mass}" contype="0" conaffinity="0"/></body></worldbody>
<tendon><spatial name="cable" {cable}><site site="anchor"/><site site="load"/></spatial></tendon>
{sensor}</mujoco>"""
FORCE = '<sensor><tendonlimitfrc tendon="cable"/></sensor>'
CABLES = {
    "spring": f'stiffness="{STIFFNESS}" damping="100" springlength="0 1"',
    "limit": f'range="0 1" solreflimit="-{STIFFNESS} -100"',
}


def hang(mass, cable, sensor=""):
    """The stretch [mm] after 6 s, and what the sensors read."""
    text = MODEL.format(mass=mass, cable=cable, sensor=sensor, gravity=GRAVITY)
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    for _ in range(6000):
        mujoco.mj_step(model, data)
    mujoco.mj_forward(model, data)
    return 1000 * (data.ten_length[0] - 1), data.sensordata


print("MuJoCo", mujoco.__version__)
for mass in (1, 2, 10):
    expected = 1000 * mass * GRAVITY / STIFFNESS
    spring, _ = hang(mass, CABLES["spring"])
    limit, (force,) = hang(mass, CABLES["limit"], FORCE)
    print(
        f"{mass} kg: expected {expected:.3f} mm, tendon with a stiffness {spring:.3f} mm,"
        f" limit with that stiffness {limit:.5f} mm at {force:.2f} N"
    )
    if abs(spring - expected) > 0.001 or abs(force - mass * GRAVITY) > 0.01:
        raise SystemExit("The spring, or the force, is not what it was.")
    if abs(limit - 0.10776) > 0.0001:
        raise SystemExit("The behaviour has changed.")
PYTHON
