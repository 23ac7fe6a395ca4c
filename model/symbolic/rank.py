"""When a structure matrix has lost rank: its cables exert no wrench in some direction."""

import casadi as ca

from turnbuckle.model.symbolic.function import EPSILON, Verdict, not_all_above
from turnbuckle.model.symbolic.scalar import Scalar, Vector

#: The structure matrix has lost rank when a pivot of its factorisation is below this: cables within
#: a millionth of a radian of one line hold nothing across it ...
SMALLEST_PIVOT = 1e-6
#: ... or below this many EPSILON, where a pivot is rounding.
RANK_TOLERANCE = 4096.0


def least_pivot() -> Scalar:
    """No larger, a pivot of the structure matrix counts as zero."""
    return ca.fmax(SMALLEST_PIVOT, RANK_TOLERANCE * EPSILON)


def regular(pivots: Vector) -> Verdict:
    """TB_SINGULAR where a pivot of the structure matrix, one for each dimension, is lost."""
    few = f"the cables pull in fewer than {len(pivots)} directions"
    return not_all_above(
        pivots, least_pivot(), "the cables are parallel" if len(pivots) <= 2 else few
    )
