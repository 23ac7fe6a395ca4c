"""The functions of the topic kinematics: points, vectors, lengths, Jacobians, speeds."""

from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic import arguments, forward_kinematics, kinematics
from turnbuckle.model.symbolic.function import (
    Label,
    ModelFunction,
    Repeat,
    Verdict,
    matrix_output,
    vector_output,
)
from turnbuckle.model.symbolic.kinematics import Cables


class Words:
    """How a kind's cable vectors are written, and where they come from."""

    def __init__(self, machine: Machine) -> None:
        self.rigid, self.wraps = machine.is_rigid, any(machine.pulleys)

    @property
    def vector(self) -> str:
        """The vector from an anchor to a base."""
        return "b_i - c - R p_i" if self.rigid else "b_i - c"

    @property
    def vectors(self) -> str:
        """What a cable vector is."""
        if self.wraps:
            return f"Cable vectors l_i, along {self.vector} but to the rim of the pulley"
        start = "anchor" if self.rigid else "platform"
        return f"Cable vectors l_i = {self.vector}, from the {start} to the pulley"

    @property
    def lengths(self) -> str:
        """What a cable length is."""
        if self.wraps:
            return "Cable lengths l_i = |l_i| + r alpha_i, alpha the angle of wrap on the pulley"
        return f"Cable lengths l_i = |{self.vector}|"

    @property
    def structure(self) -> str:
        """What a column of S is."""
        if self.rigid:
            return "column i is the unit vector u_i along cable i and its moment R p_i x u_i"
        return "column i is the unit vector along cable i"

    @property
    def lengths_source(self) -> str:
        """Equation of the length."""
        return "Yoon eq. 1" if self.rigid or self.wraps else "Yoon eq. 18"


class Place:
    """The cables at a pose and rail coordinates that are arguments."""

    def __init__(self, machine: Machine) -> None:
        self.machine, self.words = machine, Words(machine)
        self.pose, self.rails = arguments.pose(machine), arguments.rails(machine)
        self.cables: Cables = kinematics.cables(machine, self.pose.scalars(), self.rails.scalars())

    def verdicts(self) -> tuple[Verdict, ...]:
        """Where a cable has no direction."""
        return (kinematics.touches_a_pulley(self.cables.clearances),)

    def parts(self) -> tuple[Label, ...]:
        """Names what a length is made of."""
        arms = [entry for arm in self.cables.arms for entry in arm]
        free = [span.free for span in self.cables.spans]
        named = [Label("arm", arms, "R p_i, from the platform's centre to its anchors")]
        named += [Label("free", free, "length of the straight part")] if self.words.wraps else []
        return tuple(label for label in named if label.values)

    def labels(self) -> tuple[Label, ...]:
        """Names the straight lengths too."""
        if self.words.wraps:
            return self.parts()
        source = f"l_i = |{self.words.vector}|, {self.words.lengths_source}"
        return (*self.parts(), kinematics.length_label(self.cables.lengths, source))


def base_points_function(machine: Machine) -> ModelFunction:
    """Base points as a function of the rail coordinates."""
    rails = arguments.rails(machine)
    points = kinematics.base_points(machine, rails.scalars())
    return ModelFunction(
        "base_points",
        "Pulley points b_i",
        "Yoon Fig. 9",
        (rails,),
        (matrix_output("points", "m", points),),
    )


def cable_vectors_function(machine: Machine) -> ModelFunction:
    """Cable vectors as a function of pose and rail coordinates."""
    at = Place(machine)
    return ModelFunction(
        "cable_vectors",
        at.words.vectors,
        "Yoon eq. 1",
        (at.pose, at.rails),
        (matrix_output("vectors", "m", at.cables.vectors),),
        at.verdicts() if at.words.wraps else (),
        at.parts(),
    )


def cable_lengths_function(machine: Machine) -> ModelFunction:
    """Cable lengths as a function of pose and rail coordinates."""
    at = Place(machine)
    return ModelFunction(
        "cable_lengths",
        at.words.lengths,
        at.words.lengths_source,
        (at.pose, at.rails),
        (vector_output("length", "m", at.cables.lengths),),
        at.verdicts(),
        at.parts(),
    )


def structure_matrix_function(machine: Machine) -> ModelFunction:
    """Structure matrix as a function of pose and rail coordinates."""
    at = Place(machine)
    unit = arguments.structure_unit(machine)
    return ModelFunction(
        "structure_matrix",
        f"Structure matrix S: {at.words.structure}, S T = W",
        "Yoon eq. 7, 21",
        (at.pose, at.rails),
        (matrix_output("structure", unit, at.cables.structure),),
        at.verdicts(),
        at.labels(),
    )


def length_jacobian_function(machine: Machine) -> ModelFunction:
    """Derivative of the lengths by the pose, for a rigid platform by its twist."""
    at = Place(machine)
    centre = at.pose.scalars()[: machine.space]
    rows = kinematics.length_jacobian(machine, centre, at.cables.arms, at.rails.scalars())
    turning = ", x by the twist (dc, dw) in the fixed frame" if machine.is_rigid else ""
    return ModelFunction(
        "length_jacobian",
        f"Length Jacobian dl/dx = -S'{turning}",
        "Yoon eq. 3, 20",
        (at.pose, at.rails),
        (matrix_output("jacobian", arguments.structure_unit(machine), rows),),
        at.verdicts(),
        at.labels(),
    )


def rail_jacobian_function(machine: Machine) -> ModelFunction:
    """Derivative of the lengths by the rail coordinates."""
    at = Place(machine)
    held = kinematics.anchors(machine, at.pose.scalars())
    rows = kinematics.rail_jacobian(machine, held, at.rails.symbols)
    return ModelFunction(
        "rail_jacobian",
        "Rail Jacobian dl/ds",
        "Yoon eq. 3, 20",
        (at.pose, at.rails),
        (matrix_output("jacobian", "1", rows),),
        at.verdicts(),
        at.labels(),
    )


def task_velocity_function(machine: Machine) -> ModelFunction:
    """Platform velocity from the speeds of cables and rails."""
    at = Place(machine)
    length_rates, rail_rates = arguments.rates(machine)
    velocity, pivots = kinematics.least_squares_velocity(
        at.cables, length_rates.scalars(), rail_rates.scalars()
    )
    return ModelFunction(
        "task_velocity",
        "Platform velocity: least squares over the unit rows of dl/dx xdot = ldot - dl/ds sdot",
        "Yoon eq. 6, 20 with normalised rows",
        (at.pose, at.rails, length_rates, rail_rates),
        (vector_output("velocity", arguments.velocity_unit(machine), velocity),),
        (*at.verdicts(), kinematics.loses_rank(pivots)),
        at.labels(),
    )


def functions(machine: Machine) -> list[ModelFunction]:
    """Everything this topic generates, but for what is made of several functions."""
    result = [
        base_points_function(machine),
        cable_vectors_function(machine),
        cable_lengths_function(machine),
        structure_matrix_function(machine),
        length_jacobian_function(machine),
        task_velocity_function(machine),
        *forward_kinematics.functions(machine),
    ]
    if machine.rails:
        result.append(rail_jacobian_function(machine))
    return result


def composites(machine: Machine) -> list[Repeat]:
    """Everything that is made of several functions."""
    return forward_kinematics.searches(machine)
