#!/usr/bin/env bash
# A smooth table of a drum's radius that is nought one micrometre beyond its last point.
#
# Package   CasADi 3.8.2, interpolant() with the plugins "linear" and "bspline".
# Input     A straight line through five points from x = 0 to x = 2.
# Expected  Outside of the table the line goes on (as "linear" does), or its end is held, or the
#           result is not a number: a spline's last piece is a polynomial and needs no other rule.
# Seen      "linear" goes on. "bspline" returns exactly 0, and a derivative of exactly 0, from the
#           first representable step outside: 6.6 becomes 0.0. The generated C does the same. An
#           optimiser or a controller sees a jump, and a flat slope that leads nowhere back.
# Documents The help of interpolant() has no word on points outside of the grid; interp1d() says
#           that it clamps, interpn_linear() that it extrapolates.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python3 -m venv "$work/venv"
"$work/venv/bin/pip" install --quiet --disable-pip-version-check casadi==3.8.2 numpy==2.4.6

cd "$work"
venv/bin/python - <<'PYTHON'
import ctypes
import subprocess

import casadi

grid = [0.0, 0.5, 1.0, 1.5, 2.0]
table = [5.0 + 0.8 * x for x in grid]
points = (-1e-6, 0.0, 1.0, 2.0, 2.000001, 2.5)


def generated(function, x):
    """The value of the function's generated C at one point."""
    function.generate("table.c")
    subprocess.run(
        ["cc", "-O1", "-shared", "-fPIC", "table.c", "-o", "./table.so", "-lm"], check=True
    )
    pointers = ctypes.POINTER(ctypes.c_double)
    inputs, result = (ctypes.c_double * 1)(x), (ctypes.c_double * 1)()
    work, integers = (ctypes.c_double * 1000)(), (ctypes.c_longlong * 1000)()
    arguments = (pointers * 100)(ctypes.cast(inputs, pointers))
    results = (pointers * 100)(ctypes.cast(result, pointers))
    ctypes.CDLL("./table.so").bspline(arguments, results, integers, work, 0)
    return result[0]


print("CasADi", casadi.__version__)
values = {}
for plugin in ("linear", "bspline"):
    function = casadi.interpolant(plugin, plugin, [grid], table)
    x = casadi.MX.sym("x")
    slope = casadi.Function("slope", [x], [casadi.jacobian(function(x), x)])
    values[plugin] = [float(function(point)) for point in points]
    slopes = [round(float(slope(point)), 6) for point in points]
    print(f"{plugin}: at {points}\n  values {values[plugin]}\n  slopes {slopes}")
last = generated(function, points[-1])
print("generated C of bspline at", points[-1], "->", last)

if not (values["linear"][-1] > 6.9 and values["bspline"][3] > 6.5):
    raise SystemExit("The table itself is not what it was.")
if not (values["bspline"][0] == values["bspline"][4] == slopes[-1] == last == 0.0):
    raise SystemExit("The behaviour has changed.")
PYTHON
