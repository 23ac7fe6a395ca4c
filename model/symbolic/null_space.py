"""Least-norm tensions and the null space of a structure matrix, in two ways.

`factored` takes any matrix, by an orthogonal factorisation. `crossed` takes four planar cables,
from the cross products of their directions alone, and looks for the tensions where they nearly
always are: no square root stands in its way and no search, so it takes a third of the time.
"""

from dataclasses import dataclass

import casadi as ca

from turnbuckle.model.symbolic.function import Label
from turnbuckle.model.symbolic.linear import cross, dot, factorise, transpose
from turnbuckle.model.symbolic.polytope import QuickPlane, Space, space_of
from turnbuckle.model.symbolic.scalar import Matrix, Scalar, Vector, sqrt


@dataclass(frozen=True)
class NullSpace:
    """T0 (the least-norm solution of S T = W), the null space of S, its distance from singular."""

    start: Vector
    space: Space
    pivots: Vector
    labels: tuple[Label, ...] = ()


def factored(matrix: Matrix, wrench: Vector) -> NullSpace:
    """By Householder QR of S': any d and n; the pivots are on the diagonal of R."""
    factors = factorise(matrix)
    rows = factors.null_space()
    return NullSpace(factors.least_norm(wrench), space_of(rows), factors.pivots())


#: Cables (i, k) and the two others (l, m), ordered so that n_i x n_k = s_l x s_m / sqrt(det S S').
_COMPLEMENTS = {
    (0, 1): (2, 3),
    (0, 2): (3, 1),
    (0, 3): (1, 2),
    (1, 2): (0, 3),
    (1, 3): (2, 0),
    (2, 3): (0, 1),
}


def crossed(matrix: Matrix, wrench: Vector) -> NullSpace:
    """For 2 x 4, by the duality of S and its null space: n_i x n_k is s_l x s_m of the others.

    With D = det S S' = sum of the squared cross products (Cauchy-Binet),
    T0_i = sum_j (s_j x s_i)(s_j x W) / D and D n_i . n_k = -sum_j (s_i x s_j)(s_k x s_j).
    """
    columns = transpose(matrix)
    crosses: Matrix = [[ca.SX(0)] * 4 for _ in range(4)]
    for i, k in _COMPLEMENTS:
        crosses[i][k] = cross(columns[i], columns[k])
        crosses[k][i] = -crosses[i][k]
    squares = {pair: crosses[pair[0]][pair[1]] ** 2 for pair in _COMPLEMENTS}
    halves = [squares[0, 1] + squares[2, 3], squares[0, 2] + squares[1, 3]]
    determinant = (halves[0] + halves[1]) + (squares[0, 3] + squares[1, 2])
    heights = [cross(column, wrench) for column in columns]
    start = [dot([row[i] for row in crosses], heights) / determinant for i in range(4)]
    plane = QuickPlane(crossed_shares(crosses, squares), crossed_slopes(crosses), determinant)
    pairs = [Label(f"cross_{i}{k}", [crosses[i][k]]) for i, k in _COMPLEMENTS]
    height = Label("height", heights, "s_i x W")
    whole = Label("determinant", [determinant], "det S S', Cauchy-Binet")
    return NullSpace(start, plane, [sqrt(determinant / 2)], (*pairs, height, whole))


def crossed_shares(crosses: Matrix, squares: dict[tuple[int, int], Scalar]) -> Matrix:
    """D n_i . n_k; on the diagonal the squares of the pairs without i, which never cancel."""
    shares: Matrix = [[ca.SX(0)] * 4 for _ in range(4)]
    for i in range(4):
        a, b, c = (square for pair, square in squares.items() if i not in pair)
        shares[i][i] = a + (b + c)
    for (i, k), (first, second) in _COMPLEMENTS.items():
        shares[i][k] = -sum(crosses[i][j] * crosses[k][j] for j in sorted((first, second)))
        shares[k][i] = shares[i][k]
    return shares


def crossed_slopes(crosses: Matrix) -> Matrix:
    """sqrt(D) n_i x n_k, the cross product of the two other cables."""
    slopes: Matrix = [[ca.SX(0)] * 4 for _ in range(4)]
    for (i, k), (first, second) in _COMPLEMENTS.items():
        slopes[i][k] = crosses[first][second]
        slopes[k][i] = -slopes[i][k]
    return slopes
