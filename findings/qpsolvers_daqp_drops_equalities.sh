#!/usr/bin/env bash
# A wrench that no tension can balance, found by one solver and refused by the other.
#
# Package   qpsolvers 4.13.0 with DAQP 0.11.0, against the same call with quadprog 0.1.14.
# Input     Parallel cables (both rows of the equality A t = w are equal), and a wrench outside of
#           what they can give: w = (1, 2). The problem is infeasible.
# Expected  found is False, as with quadprog; an exact active-set solver cannot miss it.
# Seen      found is True, and A t - w = (0, -1): the second equality is simply not held. The rows
#           go to DAQP as upper bounds with a mark "equality"; where they depend on each other
#           only "A t <= w" is held. With w = (2, 1) the same problem is refused: whether an
#           impossible wrench is noticed depends on the order of the rows.
# Documents Solution.found: False if the solver found no solution or detected an infeasible
#           problem.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python3 -m venv "$work/venv"
"$work/venv/bin/pip" install --quiet --disable-pip-version-check \
    qpsolvers==4.13.0 daqp==0.11.0 quadprog==0.1.14 numpy==2.4.6 scipy==1.17.1

cd "$work"
venv/bin/python - <<'PYTHON'
from importlib.metadata import version

import numpy as np
import qpsolvers

parallel = np.array([[1.0, 1.0], [1.0, 1.0]])
found = {}
for solver in ("daqp", "quadprog"):
    print(solver, version(solver))
    for wrench in ([1.0, 1.0], [1.0, 2.0], [2.0, 1.0]):
        problem = qpsolvers.Problem(np.eye(2), np.zeros(2), A=parallel, b=np.array(wrench))
        solution = qpsolvers.solve_problem(problem, solver)
        left = None if solution.x is None else parallel @ solution.x - wrench
        print(f"  wrench {wrench}: found {solution.found}, t {solution.x}, A t - w {left}")
        found[solver, *wrench] = solution.found

possible, below, above = (1.0, 1.0), (1.0, 2.0), (2.0, 1.0)
if [found["quadprog", *wrench] for wrench in (below, above)] != [False, False]:
    raise SystemExit("quadprog finds a solution where none is.")
if not (found["daqp", *below] and not found["daqp", *above]):
    raise SystemExit("The behaviour has changed.")
PYTHON
