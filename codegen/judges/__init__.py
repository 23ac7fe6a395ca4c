"""What the independent reference expects of every generated function, and how nearly.

The reference computes in long double from the very numbers the C was given, so its own rounding is
a two-thousandth of a unit in the last place of a double and does not count. What remains is the
rounding of the C, which is told in one of two ways:

- Functions of position: the bound that the header states, plus what the condition of the problem
  makes of `ROUNDINGS` units in the last place where the header's search does not go.
- Tensions: `TENSION_ROUNDINGS` units in the last place of T_max, times the condition of the cables
  that are free, plus what moving the bounds by as much does to the result. The latter is the whole
  truth at vertices, at verdicts and for policies: rounding may choose either side of a border, and
  a problem whose bounds are a hair off shows how much that matters.
"""

from turnbuckle.codegen.judges import comparison, control, motion, quality, tensions
from turnbuckle.codegen.judges.problem import Judge

JUDGES: dict[str, Judge] = {
    **motion.JUDGES,
    **tensions.JUDGES,
    **comparison.JUDGES,
    **quality.JUDGES,
    **control.JUDGES,
}
