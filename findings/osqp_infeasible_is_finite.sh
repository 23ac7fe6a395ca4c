#!/usr/bin/env bash
# An infeasible tension distribution that every finiteness test accepts.
#
# Package   OSQP 1.1.3 (Python).
# Input     Two cables must pull 1 N together, and each of them at least 2 N: no solution.
# Expected  Status "primal infeasible", and x and y that are not a number: the solver fills them
#           with its constant OSQP_NAN, which the Python module gives as nan.
# Seen      The status is right. Every entry of x and of y is 2143289344.0, a finite number: the
#           bit pattern of the single-precision NaN (0x7fc00000), converted as an integer to a
#           double. A test by isfinite() passes, and a saturation behind it pulls each cable at
#           its largest force.
# Documents No page was found that names the value of x at this status.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python3 -m venv "$work/venv"
"$work/venv/bin/pip" install --quiet --disable-pip-version-check \
    osqp==1.1.3 numpy==2.4.6 scipy==1.17.1

cd "$work"
venv/bin/python - <<'PYTHON'
import numpy as np
import osqp
import scipy.sparse as sparse


def solve(smallest):
    """The two tensions that pull 1 N together, with a smallest tension of each [N]."""
    solver = osqp.OSQP()
    rows = sparse.csc_matrix([[1.0, 1.0], [1.0, 0.0], [0.0, 1.0]])
    low, high = np.array([1.0, smallest, smallest]), np.array([1.0, 9.0, 9.0])
    solver.setup(sparse.eye(2, format="csc"), np.zeros(2), rows, low, high, verbose=False)
    return solver.solve()


print("OSQP", osqp.__version__)
for smallest in (0.1, 2.0):
    result = solve(smallest)
    finite = bool(np.isfinite(result.x).all() and np.isfinite(result.y).all())
    print(f"each at least {smallest} N: {result.info.status}, finite {finite}")
    print(f"  x {result.x}, y {result.y}")

print("OSQP_NAN by the module:", osqp.OSQP().constant("OSQP_NAN"))
pattern = float(np.float32(np.nan).view(np.int32))
print("bit pattern of a single-precision NaN, as a number:", pattern)
if not (result.info.status == "primal infeasible" and finite and (result.x == pattern).all()):
    raise SystemExit("The behaviour has changed.")
PYTHON
