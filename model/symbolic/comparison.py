"""Tension methods to compare with: Brau et al., corrected where they are wrong as printed.

Kernel method (eqs 3-5), reduced matrices (eqs 6, 7), and how much tension a force of some size asks
for in its worst direction (eqs 12, 14, 17-19, and exactly). None of them knows T_max.
"""

from itertools import combinations

import casadi as ca

from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic import arguments
from turnbuckle.model.symbolic.active_set import Answer, Optimum
from turnbuckle.model.symbolic.composition import Composite
from turnbuckle.model.symbolic.facets import WEIGHED, Facet, FacetSweep
from turnbuckle.model.symbolic.function import (
    EPSILON,
    Input,
    ModelFunction,
    Output,
    Repeat,
    Status,
    Verdict,
    matrix_output,
    not_all_above,
    scalar_output,
    vector_output,
)
from turnbuckle.model.symbolic.linear import (
    cross,
    dot,
    factorise,
    moment,
    none_between,
    subtract,
    transpose,
)
from turnbuckle.model.symbolic.null_space import factored
from turnbuckle.model.symbolic.polytope import Line, knock_out
from turnbuckle.model.symbolic.rank import least_pivot
from turnbuckle.model.symbolic.scalar import (
    Matrix,
    Scalar,
    Vector,
    all_of,
    any_of,
    largest,
    smallest,
    total,
    where,
)
from turnbuckle.model.symbolic.sweep import Ports, Scheme, Subset, Sweep, make_sweep
from turnbuckle.model.symbolic.tension import (
    KKT_TOLERANCE,
    LARGEST_MISS,
    PLANE,
    active_set,
    is_unrolled,
    least_norm_tension,
    rank_lost,
    rounding,
)
from turnbuckle.model.symbolic.wrench_norm import weighed, weighed_rows
from turnbuckle.model.symbolic.wrench_set import FAR

KERNEL = "Brau eqs 3-5"
PROGRAM_SUMMARY = (
    "Tensions of least norm above T_min, as the kernel of S allows; T_max is not looked at"
)
PROGRAM_SOURCE = f"{KERNEL}, a quadratic program for more than one redundant cable"
REDUCED = "Brau eqs 6, 7"
#: A tension may be below T_min by rounding: this many EPSILON of the sum of all tensions.
BELOW = 16.0
#: Kernel entries are positive above this many EPSILON of a unit vector.
COOPERATIVE = 64.0
#: Cables pull along a direction above so many EPSILON of their directions.
PARALLEL = 64.0
#: Pairs of so many planar cables are written out; more are visited.
WRITTEN_OUT = 6


def kernel_line(machine: Machine) -> ModelFunction:
    """T = S+ W + alpha K for one redundant cable: alpha brings the least tension to T_min."""
    structure, wrench = arguments.structure(machine), arguments.wrench(machine)
    matrix, wanted = weighed_rows(machine, structure.rows()), weighed(machine, wrench.scalars())
    low, space = machine.tension.min, factored(matrix, wanted)
    assert isinstance(space.space, Line)
    # either sign of a kernel will do, but eq. 5 wants positive entries
    up = ca.copysign(1, space.space.direction[0])
    kernel = [up * entry for entry in space.space.direction]
    cooperative = all_of([entry > COOPERATIVE * EPSILON for entry in kernel])
    alpha = largest([(low - x) / k for x, k in zip(space.start, kernel, strict=True)])
    tension = [
        where(cooperative, ca.fmax(x + alpha * k, low), low)
        for x, k in zip(space.start, kernel, strict=True)
    ]
    return ModelFunction(
        "kernel_tension",
        "Tensions by the kernel of S: the least of them is T_min; T_max is not looked at",
        KERNEL,
        (structure, wrench),
        (vector_output("tension", "N", tension, fallback=low),),
        (
            rank_lost(space),
            Verdict(
                ca.logic_not(cooperative),
                Status.INFEASIBLE,
                "the kernel has entries of both signs, or zero, and every cable holds T_min",
            ),
        ),
    )


def kernel_program(machine: Machine) -> ModelFunction:
    """The same with more redundant cables, where the paper calls for a quadratic program."""
    structure, wrench = arguments.structure(machine), arguments.wrench(machine)
    matrix, wanted = weighed_rows(machine, structure.rows()), weighed(machine, wrench.scalars())
    space = factored(matrix, wanted)
    low = machine.tension.min
    solution = least_norm_tension(matrix, wanted, space, low, None)
    limit = rounding(KKT_TOLERANCE, largest(solution.tension), space)
    most = LARGEST_MISS * machine.tension.max
    unsolved = ca.logic_not(solution.kkt_residual <= ca.fmin(limit, most))
    outputs, verdicts = program_results(solution.tension, unsolved, low)
    verdicts = (rank_lost(space), *verdicts)
    inputs = (structure, wrench)
    return ModelFunction(
        "kernel_tension", PROGRAM_SUMMARY, PROGRAM_SOURCE, inputs, outputs, verdicts
    )


def program_results(tension: Vector, unsolved: Scalar, low: float) -> Answer:
    """Tensions of the program; T_min in every cable where there are none."""
    values = [where(unsolved, low, value) for value in tension]
    meaning = "there is no solution, and every cable holds T_min"
    return (
        (vector_output("tension", "N", values, fallback=low),),
        (Verdict(unsolved, Status.INFEASIBLE, meaning),),
    )


def kernel_loop(machine: Machine) -> Repeat:
    """The same by a loop, for any number of cables."""
    loop, _ = active_set(machine, None)
    low, most = machine.tension.min, LARGEST_MISS * machine.tension.max

    def answer(best: Optimum, pivot: Scalar) -> Answer:
        limit = KKT_TOLERANCE * EPSILON * largest(best.tension) / pivot
        unsolved = ca.logic_not(best.residual <= ca.fmin(limit, most))
        return program_results(best.tension, unsolved, low)

    return loop.repeat("kernel_tension", PROGRAM_SUMMARY, PROGRAM_SOURCE, answer)


def beyond_least(machine: Machine, structure: Input, wrench: Input) -> Vector:
    """What is left of a wrench when every cable holds T_min; reduced systems exert it on top."""
    held = [machine.tension.min * total(row) for row in structure.rows()]
    return subtract(wrench.scalars(), held)


def none_qualifies(least: Scalar) -> Verdict:
    """No reduced system has tensions of T_min and above."""
    return Verdict(
        ca.logic_not(least < FAR),
        Status.INFEASIBLE,
        "no set of d cables exerts the wrench with T_min and above, and every cable holds T_min",
    )


REDUCED_SUMMARY = (
    "Tensions of d cables that exert a wrench, T_min in the others: of all sets with tensions of"
    " T_min and above the one of lowest sum; T_max is not looked at"
)


def reduced_pairs(machine: Machine) -> ModelFunction:
    """Reduced matrices for a few planar cables: heights and cross products serve all pairs.

    A pair exerts R = W - T_min sum s_k on top of T_min by (s_i x R) / D in j, -(s_j x R) / D in i,
    with D = s_i x s_j; the sign rule of eqs 8, 9 counts within the set.
    """
    structure, wrench = arguments.structure(machine), arguments.wrench(machine)
    columns, low = transpose(structure.rows()), machine.tension.min
    rest = beyond_least(machine, structure, wrench)
    heights = [cross(column, rest) for column in columns]
    sums, tried = [], []
    for i, j in combinations(range(len(columns)), 2):
        determinant = cross(columns[i], columns[j])
        above = {i: -heights[j] / determinant, j: heights[i] / determinant}
        sums.append(sum_if_qualified([*above.values()], [determinant], low * len(columns)))
        tried.append([above.get(k, ca.SX(0)) for k in range(len(columns))])
    least = smallest(sums)
    best = knock_out([-value for value in sums], tried)
    tension = [where(least < FAR, low + ca.fmax(value, 0), low) for value in best]
    return ModelFunction(
        "reduced_matrix_tension",
        REDUCED_SUMMARY,
        REDUCED,
        (structure, wrench),
        (vector_output("tension", "N", tension, fallback=low),),
        (none_qualifies(least),),
    )


def sum_if_qualified(above: Vector, pivots: Vector, held: float) -> Scalar:
    """Sum of what the tensions of a reduced system have above T_min; `FAR` unless it qualifies.

    It must be regular, and no tension below T_min by more than rounding. `held` is T_min of all
    cables. One number decides: the least of what must not be negative.
    """
    whole = total(above)
    slack = BELOW * EPSILON * (ca.fabs(whole) + held)
    regular = smallest([ca.fabs(pivot) for pivot in pivots]) - least_pivot()
    return where(ca.fmin(smallest(above) + slack, regular) >= 0, whole, FAR)


def reduced_sweep(machine: Machine) -> Sweep:
    """Reduced matrices for any cables: every set of d is visited."""
    structure, wrench = arguments.structure(machine), arguments.wrench(machine)
    dof, count, low = machine.dof, len(machine.cables), machine.tension.min
    rest = weighed(machine, beyond_least(machine, structure, wrench))
    rows = weighed_rows(machine, structure.rows())
    state = (
        *((matrix_output(WEIGHED, "1", rows),) if machine.is_rigid else ()),
        vector_output("rest", "N", rest),
        scalar_output("least", "N", ca.SX(FAR)),
        vector_output("best", "N", [ca.SX(0)] * dof),
        vector_output("cables", "1", [ca.SX(-1)] * dof),
    )

    def visit(subset: Subset, known: Ports) -> dict[str, Vector]:
        above, pivots = solved(subset.columns.rows(), known["rest"].scalars())
        least = known["least"].scalars()[0]
        found = sum_if_qualified(above, pivots, low * count)
        qualifies = found < least
        taken = {"best": above, "cables": subset.numbers.scalars(), "least": [found]}
        return {
            name: [
                where(qualifies, new, old)
                for new, old in zip(values, known[name].scalars(), strict=True)
            ]
            for name, values in taken.items()
        }

    def finish(known: Ports) -> tuple[tuple[Output, ...], tuple[Verdict, ...]]:
        best, cables = known["best"].scalars(), known["cables"].scalars()
        tension = [
            low
            + total([where(k == i, ca.fmax(x, 0), 0) for k, x in zip(cables, best, strict=True)])
            for i in range(count)
        ]
        outputs = (vector_output("tension", "N", tension, fallback=low),)
        return outputs, (none_qualifies(known["least"].scalars()[0]),)

    matrix = WEIGHED if machine.is_rigid else structure.name
    scheme = Scheme((structure, wrench), matrix, dof, state, visit, finish)
    return make_sweep("reduced_matrix_tension", REDUCED_SUMMARY, REDUCED, scheme)


def solved(matrix: Matrix, right: Vector) -> tuple[Vector, Vector]:
    """Solution of a square system, and its pivots: the determinant alone for d = 2 and 3."""
    columns = transpose(matrix)
    if len(columns) == 2:
        determinant = cross(*columns)
        return [cross(right, columns[1]) / determinant, cross(columns[0], right) / determinant], [
            determinant
        ]
    if len(columns) == 3:
        across = [moment(columns[i - 2], columns[i - 1]) for i in range(3)]
        determinant = dot(columns[0], across[0])
        return [dot(right, normal) / determinant for normal in across], [determinant]
    factors = factorise(matrix)
    return factors.least_norm(right), factors.pivots()


def largest_tensions_eq12(machine: Machine) -> Sweep:
    """Eq. 12: in set S_k cable i bears at most F |Delta_i| / |Delta|, largest over the sets.

    With the unit normal m of the d - 1 other cables of a set that is F / |m . s_i|, or F |m_F| over
    it for the part m_F along forces: a facet tells it for all cables that complete it to a set.
    """
    structure, force = arguments.structure(machine), arguments.force(machine)
    size = force.scalars()[0]
    state = (
        vector_output("most", "1", [ca.SX(0)] * len(machine.cables)),
        scalar_output("least", "1", ca.SX(FAR)),
        scalar_output("size", "N", size),
    )

    def visit(facet: Facet, subset: Subset, known: Ports) -> dict[str, Vector]:
        slope, regular = facet.slope(machine.space), facet.exists(least_pivot())
        heights = [
            where(subset.holds(cable), FAR, ca.fabs(height))
            for cable, height in enumerate(facet.heights)
        ]
        pairs = zip(known["most"].scalars(), heights, strict=True)
        lowest = where(regular, smallest(heights), 0)
        return {
            "most": [ca.fmax(old, slope / height) for old, height in pairs],
            "least": [ca.fmin(known["least"].scalars()[0], lowest)],
        }

    def finish(known: Ports) -> tuple[tuple[Output, ...], tuple[Verdict, ...]]:
        tension = [known["size"].scalars()[0] * ratio for ratio in known["most"].scalars()]
        meaning = "d of the cables are dependent, and the bound has no limit"
        singular = not_all_above([known["least"].scalars()[0]], least_pivot(), meaning)
        return (vector_output("tension", "N", tension),), (singular,)

    sweep = FacetSweep(machine, structure, (force,), state, visit, finish)
    return sweep.named(
        "largest_tensions_eq12",
        f"Upper bound of every tension over all directions of a force{without_moment(machine)} and"
        " all sets of d cables, T_min = 0: tight for d + 1 cables all around, else far too high",
        "Brau eq. 12 with |Delta|; 14 for 3 planar cables, 18 and 19 for 4 in space",
    )


def without_moment(machine: Machine) -> str:
    """What a force comes without, in words."""
    return " without a moment" if machine.is_rigid else ""


def largest_tensions_eq17(machine: Machine) -> ModelFunction:
    """Eqs 14 and 17 corrected: a force between two adjacent cables is borne by these.

    Where they are less than a right angle apart, a force along one of them is its worst.
    """
    structure, force = arguments.structure(machine), arguments.force(machine)
    columns = transpose(structure.rows())
    ratios, enclosed = [ca.SX(0)] * len(columns), []
    for i in range(len(columns)):
        others = [j for j in range(len(columns)) if j != i]
        following = {j: adjacent(columns, i, j) for j in others}
        for j, next_to in following.items():
            obtuse = dot(columns[i], columns[j]) < 0
            ratio = where(next_to, where(obtuse, 1 / cross(columns[i], columns[j]), 1), 0)
            ratios[i], ratios[j] = ca.fmax(ratios[i], ratio), ca.fmax(ratios[j], ratio)
        enclosed.append(any_of([*following.values()]))
    inside, size = all_of(enclosed), force.scalars()[0]
    return ModelFunction(
        "largest_tensions_eq17",
        "Largest tension of every cable over all directions of a force that the two adjacent cables"
        " bear, T_min = 0",
        "Brau eqs 14, 17 with adjacent cables only",
        (structure, force),
        (vector_output("tension", "N", [where(inside, size * ratio, 0) for ratio in ratios]),),
        (Verdict(ca.logic_not(inside), Status.INFEASIBLE, "half the plane has no cable; 0"),),
    )


def adjacent(columns: Matrix, i: int, j: int) -> Scalar:
    """Whether cable j is the next one counter-clockwise from cable i, less than pi away."""

    def ahead(first: int, second: int) -> Scalar:
        return cross(columns[first], columns[second]) > PARALLEL * EPSILON

    return ca.logic_and(ahead(i, j), none_between(i, j, len(columns), ahead))


def largest_tension(machine: Machine) -> Sweep:
    """The exact one: all facets must be as far out as the force reaches along their normals.

    With P and Q the sums of the positive and the negative m . s_i, T_max P - T_min Q >= F |m_F|.
    """
    structure, force = arguments.structure(machine), arguments.force(machine)
    low = machine.tension.min
    state = (
        scalar_output("most", "N", ca.SX(low)),
        scalar_output("size", "N", force.scalars()[0]),
    )

    def visit(facet: Facet, _: Subset, known: Ports) -> dict[str, Vector]:
        upwards, downwards = facet.sides()
        wanted = known["size"].scalars()[0] * facet.slope(machine.space)
        bound = ca.fmax(
            bound_of(upwards, wanted + low * downwards), bound_of(downwards, wanted + low * upwards)
        )
        most = known["most"].scalars()[0]
        return {"most": [where(facet.exists(), ca.fmax(most, bound), most)]}

    def finish(known: Ports) -> tuple[tuple[Output, ...], tuple[Verdict, ...]]:
        most = known["most"].scalars()[0]
        never = ca.logic_not(most < FAR)
        meaning = "no tension is enough for every direction; 0"
        verdict = Verdict(never, Status.INFEASIBLE, meaning)
        return (scalar_output("tension", "N", where(never, 0, most)),), (verdict,)

    sweep = FacetSweep(machine, structure, (force,), state, visit, finish)
    return sweep.named(
        "largest_tension",
        f"Least T_max with which every force of a size{without_moment(machine)} is feasible; exact"
        " for any number of cables",
        "facets of {S T}, in place of Brau eq. 20",
    )


def bound_of(outwards: Scalar, wanted: Scalar) -> Scalar:
    """Tension with which cables that pull a sum outwards reach what is wanted; `FAR` if none."""
    nothing = PARALLEL * EPSILON
    return where(outwards > nothing, wanted / outwards, where(wanted > nothing, FAR, 0))


def functions(machine: Machine) -> list[ModelFunction]:
    """Everything this topic computes in one pass."""
    result: list[ModelFunction] = []
    if machine.redundancy == 1:
        result.append(kernel_line(machine))
    elif is_unrolled(machine):
        result.append(kernel_program(machine))
    if machine.dof == PLANE:
        result.append(largest_tensions_eq17(machine))
        if len(machine.cables) <= WRITTEN_OUT:
            result.append(reduced_pairs(machine))
    return result


def composites(machine: Machine) -> list[Composite]:
    """Everything that visits subsets of the cables, or takes a loop."""
    by_loop = machine.redundancy > 1 and not is_unrolled(machine)
    result: list[Composite] = [kernel_loop(machine)] if by_loop else []
    if machine.dof > PLANE or len(machine.cables) > WRITTEN_OUT:
        result.append(reduced_sweep(machine))
    return [*result, largest_tensions_eq12(machine), largest_tension(machine)]
