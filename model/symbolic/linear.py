"""Small dense linear algebra on lists of scalars, unrolled for the sizes of a machine."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import casadi as ca

from turnbuckle.model.symbolic.scalar import Matrix, Scalar, Vector, any_of, sqrt, total


def dot(a: Sequence[Scalar], b: Sequence[Scalar]) -> Scalar:
    """Scalar product."""
    return total([x * y for x, y in zip(a, b, strict=True)])


def norm(vector: Sequence[Scalar]) -> Scalar:
    """Euclidean length."""
    return sqrt(dot(vector, vector))


def cross(a: Sequence[Scalar], b: Sequence[Scalar]) -> Scalar:
    """z component of the vector product of two planar vectors."""
    return a[0] * b[1] - a[1] * b[0]


def cross_matrix(a: Sequence[Scalar]) -> Matrix:
    """[a]x, which makes the vector product a x b of a spatial vector b."""
    x, y, z = a
    return [[0, -z, y], [z, 0, -x], [-y, x, 0]]


def moment(arm: Sequence[Scalar], force: Sequence[Scalar]) -> Vector:
    """Moment arm x force: one entry in the plane, three in space."""
    if len(arm) == 2:
        return [cross(arm, force)]
    return multiply(cross_matrix(arm), force)


def none_between(i: int, j: int, count: int, ahead: Callable[[int, int], Scalar]) -> Scalar:
    """Whether none of the other vectors in the plane lies in the turn from vector i to vector j.

    ahead(first, second): the second is counter-clockwise from the first, less than pi away.
    """
    others = [k for k in range(count) if k not in (i, j)]
    return ca.logic_not(any_of([ca.logic_and(ahead(i, k), ahead(k, j)) for k in others]))


def subtract(a: Sequence[Scalar], b: Sequence[Scalar]) -> Vector:
    """a - b."""
    return [x - y for x, y in zip(a, b, strict=True)]


def add_scaled(a: Sequence[Scalar], factor: Scalar, b: Sequence[Scalar]) -> Vector:
    """a + factor b."""
    return [x + factor * y for x, y in zip(a, b, strict=True)]


def multiply(matrix: Matrix, vector: Sequence[Scalar]) -> Vector:
    """Matrix times vector."""
    return [dot(row, vector) for row in matrix]


def transpose(matrix: Matrix) -> Matrix:
    """Rows become columns."""
    return [list(column) for column in zip(*matrix, strict=True)]


def gram(matrix: Matrix) -> Matrix:
    """matrix times its transpose."""
    return [[dot(a, b) for b in matrix] for a in matrix]


def solve_positive(matrix: Matrix, right: Sequence[Scalar]) -> tuple[Vector, Vector]:
    """Solve a symmetric positive definite system by L D L'; returns (solution, pivots)."""
    size = len(right)
    lower: Matrix = [[ca.SX(0)] * size for _ in range(size)]
    pivots: Vector = []
    for j in range(size):
        pivot = matrix[j][j]
        for k in range(j):
            pivot = pivot - lower[j][k] * lower[j][k] * pivots[k]
        pivots.append(pivot)
        for i in range(j + 1, size):
            entry = matrix[i][j]
            for k in range(j):
                entry = entry - lower[i][k] * lower[j][k] * pivots[k]
            lower[i][j] = entry / pivot
    solution = list(right)
    for i in range(size):
        for k in range(i):
            solution[i] = solution[i] - lower[i][k] * solution[k]
    solution = [value / pivot for value, pivot in zip(solution, pivots, strict=True)]
    for i in reversed(range(size)):
        for k in range(i + 1, size):
            solution[i] = solution[i] - lower[k][i] * solution[k]
    return solution, pivots


@dataclass(frozen=True)
class Factorisation:
    """Householder QR of the transpose of a d x n matrix S with d <= n.

    `reflectors` are pairs (vector, 2 / |vector|^2); `triangle` is R (d x d, upper).
    """

    size: int
    reflectors: list[tuple[Vector, Scalar]]
    triangle: Matrix

    def apply(self, vector: Vector) -> Vector:
        """Q times a vector of n entries; structural zeros cost nothing."""
        for offset in reversed(range(len(self.reflectors))):
            direction, factor = self.reflectors[offset]
            tail = vector[offset:]
            projection = factor * dot(direction, tail)
            vector = vector[:offset] + add_scaled(tail, -projection, direction)
        return vector

    def null_space(self) -> Matrix:
        """Orthonormal basis of the null space of S, one basis vector a column (n x (n - d))."""
        rank = len(self.reflectors)
        columns = []
        for k in range(rank, self.size):
            unit = [ca.SX(0)] * self.size
            unit[k] = ca.SX(1)
            columns.append(self.apply(unit))
        return transpose(columns)

    def forward(self, right: Sequence[Scalar]) -> Vector:
        """Solves R' z = right."""
        solution: Vector = []
        for i, value in enumerate(right):
            for k in range(i):
                value = value - self.triangle[k][i] * solution[k]
            solution.append(value / self.triangle[i][i])
        return solution

    def least_norm(self, right: Sequence[Scalar]) -> Vector:
        """The vector T of least norm with S T = right."""
        return self.apply(self.forward(right) + [ca.SX(0)] * (self.size - len(self.reflectors)))

    def solve_gram(self, right: Sequence[Scalar]) -> Vector:
        """Solves S S' y = R' R y = right; S' y is as near the least-norm vector as by Q (Paige)."""
        solution = self.forward(right)
        for i in reversed(range(len(solution))):
            for k in range(i + 1, len(solution)):
                solution[i] = solution[i] - self.triangle[i][k] * solution[k]
            solution[i] = solution[i] / self.triangle[i][i]
        return solution

    def pivots(self) -> Vector:
        """Magnitudes on the diagonal of R: one of them is zero where S loses rank."""
        return [ca.fabs(self.triangle[i][i]) for i in range(len(self.reflectors))]


def factorise(matrix: Matrix) -> Factorisation:
    """Householder QR of the transpose of `matrix` (d x n, d <= n)."""
    columns = [list(row) for row in matrix]
    rank, size = len(columns), len(columns[0])
    reflectors: list[tuple[Vector, Scalar]] = []
    triangle: Matrix = [[ca.SX(0)] * rank for _ in range(rank)]
    for k in range(rank):
        tail = columns[k][k:]
        length = norm(tail)
        reach = ca.copysign(length, tail[0])
        direction = [tail[0] + reach, *tail[1:]]
        factor = 1 / (length * (length + ca.fabs(tail[0])))
        reflectors.append((direction, factor))
        triangle[k][k] = -reach
        for j in range(k + 1, rank):
            projection = factor * dot(direction, columns[j][k:])
            columns[j][k:] = add_scaled(columns[j][k:], -projection, direction)
            triangle[k][j] = columns[j][k]
    return Factorisation(size, reflectors, triangle)
