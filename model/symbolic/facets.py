"""The wrenches that cables within their bounds can exert, facet by facet, in any dimension d.

They are a zonotope {S T}. Every d - 1 of the cables are the edges of a pair of its facets, with a
unit normal m; seen along it the set reads |m . W - centre| <= half, where centre is the mean
tension times sum_i m . s_i and half is half the tension range times sum_i |m . s_i|. That holds
for any m: nearly dependent cables, whose normal rounding decides, say too little but nothing wrong.

Moments count by the force at the platform's lever, see wrench_norm. In the plane the
normals are the cables' own, turned by a right angle: see wrench_set.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import casadi as ca

from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic.function import EPSILON, Input, Output, Verdict, matrix_output
from turnbuckle.model.symbolic.linear import add_scaled, dot, factorise, moment, norm, transpose
from turnbuckle.model.symbolic.rank import regular
from turnbuckle.model.symbolic.scalar import Matrix, Scalar, Vector, all_of, any_of, total, where
from turnbuckle.model.symbolic.sweep import Ports, Scheme, Subset, Sweep, make_sweep
from turnbuckle.model.symbolic.wrench_norm import weighed_rows

#: Cables are dependent where they are so within this many EPSILON.
DEPENDENT = 16.0
#: What the state of a sweep calls the structure matrix with its moments over the lever.
WEIGHED = "weighed"


@dataclass(frozen=True)
class Facet:
    """A pair of facets: unit normal, m . s_i of every cable, how independent its edges are.

    `pivots` are the distances of every edge from the span of those before it; where one of them is
    zero the normal may be NaN.
    """

    normal: Vector
    heights: Vector
    pivots: Vector

    def exists(self, least: Scalar = DEPENDENT * EPSILON) -> Scalar:
        """Whether all pivots exceed a limit; with the least one the normal is a unit vector."""
        return all_of([pivot > least for pivot in self.pivots])

    def slab(self, low: float, high: float) -> tuple[Scalar, Scalar]:
        """Centre and half distance of the facets for tensions in [low, high]."""
        mean, half = (low + high) / 2, (high - low) / 2
        return mean * total(self.heights), half * total([ca.fabs(x) for x in self.heights])

    def gap(self, low: float, high: float) -> Scalar:
        """Distance of zero from the nearer facet for tensions in [low, high]; negative outside."""
        centre, half = self.slab(low, high)
        return half - ca.fabs(centre)

    def sides(self) -> tuple[Scalar, Scalar]:
        """Sums of the positive and of the negative m . s_i, both as magnitudes."""
        whole, size = total(self.heights), total([ca.fabs(height) for height in self.heights])
        return (size + whole) / 2, (size - whole) / 2

    def slope(self, space: int) -> Scalar:
        """Length of the normal's part along forces: 1 where there are no moments."""
        return norm(self.normal[:space]) if space < len(self.normal) else ca.SX(1)


def normal_of(edges: Matrix) -> tuple[Vector, Vector]:
    """Unit normal of d - 1 vectors (d x (d - 1)), and their pivots."""
    columns = transpose(edges)
    if len(edges) == 2:
        (edge,) = columns
        length = norm(edge)
        return [-edge[1] / length, edge[0] / length], [length]
    if len(edges) == 3:
        across = moment(*columns)
        # of nearly parallel edges the product is not square to them: once more it is
        edge = columns[0]
        across = add_scaled(across, -dot(across, edge) / dot(edge, edge), edge)
        length = norm(across)
        return [x / length for x in across], [length]
    factors = factorise(columns)
    return [row[0] for row in factors.null_space()], factors.pivots()


def facet(matrix: Matrix, subset: Subset) -> Facet:
    """The facets of a structure matrix (d x n) along d - 1 of its columns, which it does not rise
    above."""
    normal, pivots = normal_of(subset.columns.rows())
    heights = [
        where(any_of([number == i for number in subset.numbers.scalars()]), 0, dot(normal, column))
        for i, column in enumerate(transpose(matrix))
    ]
    return Facet(normal, heights, pivots)


@dataclass(frozen=True)
class FacetSweep:
    """A sweep over the facets of a structure matrix, see Scheme.

    The matrix is an argument; for a platform with moments the state holds it weighed. One that has
    lost rank is refused: its set of wrenches is flat, and no facet says so.
    """

    machine: Machine
    structure: Input
    others: tuple[Input, ...]
    state: tuple[Output, ...]
    visit: Callable[[Facet, Subset, Ports], Mapping[str, Vector]]
    finish: Callable[[Ports], tuple[tuple[Output, ...], tuple[Verdict, ...]]]

    def named(self, name: str, summary: str, source: str) -> Sweep:
        """The sweep under a name."""
        matrix, prepared = self.structure.name, self.state
        rows = weighed_rows(self.machine, self.structure.rows())
        if self.machine.is_rigid:
            matrix, prepared = WEIGHED, (matrix_output(WEIGHED, "1", rows), *prepared)
        singular = regular(factorise(rows).pivots())

        def visit(subset: Subset, known: Ports) -> Mapping[str, Vector]:
            return self.visit(facet(known[matrix].rows(), subset), subset, known)

        inputs = (self.structure, *self.others)
        size = self.machine.dof - 1
        scheme = Scheme(inputs, matrix, size, prepared, visit, self.finish, (singular,))
        return make_sweep(name, summary, source, scheme)
