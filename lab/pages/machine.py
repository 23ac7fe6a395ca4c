"""The page of a machine: what it is, how it looks, its equations."""

from collections.abc import Iterator

from turnbuckle.lab.pages.equations import Equation, equations
from turnbuckle.lab.pages.tex import display, tex_of
from turnbuckle.model.machine import Machine

#: Headings, and the equations below them.
SECTIONS = {
    "Kinematics": ("bases", "half_angle", "rotation", "arms", "lengths", "directions"),
    "Structure matrix": ("structure",),
    "Jacobians": ("jacobian", "rail_jacobian"),
    "Statics": ("rail_forces",),
}
#: The C function that computes an equation, and the header that declares it.
FUNCTIONS = {
    "bases": ("tb_base_points", "tb_kinematics.h"),
    "lengths": ("tb_cable_lengths", "tb_kinematics.h"),
    "structure": ("tb_structure_matrix", "tb_kinematics.h"),
    "jacobian": ("tb_length_jacobian", "tb_kinematics.h"),
    "rail_jacobian": ("tb_rail_jacobian", "tb_kinematics.h"),
    "rail_forces": ("tb_rail_forces", "tb_statics.h"),
}
POLICIES = {
    "scale": (
        "A wrench that no admissible tensions exert keeps its direction and becomes the largest "
        "fraction that they do exert; the nearest one where there is none.",
        r"\mathbf{W}^{\star} = \lambda \mathbf{W}, \quad \lambda = \max \left\{ \mu \le 1 : "
        r"\mu \mathbf{W} \in \mathcal{W} \right\}",
    ),
    "closest": (
        "A wrench that no admissible tensions exert becomes the nearest that they do exert.",
        r"\mathbf{W}^{\star} = \operatorname{argmin}_{\mathbf{V} \in \mathcal{W}} "
        r"\left| \mathbf{V} - \mathbf{W} \right|",
    ),
    "paper": (
        "Yoon eqs 22 and 23: the tensions of least norm above the lower bound, then clipped to the "
        "upper one, which changes the wrench.",
        r"T_i^{\star} = \min \left( T_i, T_{\max} \right)",
    ),
}


def machine_page(machine: Machine) -> str:
    """Markdown of a machine's page; its picture is beside it."""
    head, *rows = [f"| {name} | {value} |" for name, value in machine.describe()]
    parts = [
        f"# {machine.name}",
        "\n".join([head, "|---|---|", *rows]),
        f"![{machine.name}: frame, bases, cables and target]({machine.name}.png)",
        BEGINNING.format(pose=pose_words(machine)),
        *equation_parts(machine),
        *wrench_parts(machine),
        *tension_parts(machine),
    ]
    return "\n\n".join(parts) + "\n"


BEGINNING = """The equations below are the model's own, of which the C is printed, with the numbers
of the machine file in metres and newtons. {pose} $\\ell_i$ are the cables' lengths, $T_i$ their
tensions."""


def pose_words(machine: Machine) -> str:
    """What the symbols of pose and rails are."""
    axes = ", ".join("xyz"[: machine.space])
    words = f"${axes}$ is the centre of the platform"
    if machine.is_rigid:
        turn = r"$\varphi$ its angle" if machine.space == 2 else r"$\varphi$ its rotation vector"
        words += f", {turn}"
    if machine.rails:
        words += "; $s_k$ are the rail coordinates"
    return f"{words}."


def equation_parts(machine: Machine) -> Iterator[str]:
    """The sections of equations that the machine has."""
    known = {equation.key: equation for equation in equations(machine)}
    for title, keys in SECTIONS.items():
        shown = [known[key] for key in keys if key in known]
        if shown:
            yield f"## {title}"
        for equation in shown:
            yield words_of(equation)
            yield display(tex_of(equation))


def words_of(equation: Equation) -> str:
    """What an equation says, its unit, and the C that computes it."""
    unit = f" [{equation.unit}]" if equation.unit else ""
    text = f"{equation.words.removesuffix('.')}{unit}."
    if equation.key in FUNCTIONS:
        function, header = FUNCTIONS[equation.key]
        text += f" In C: `{function}` of `{header}`."
    return text


def wrench_parts(machine: Machine) -> Iterator[str]:
    """What the cables exert, and what the motors must hold."""
    if not machine.rails:
        yield "## Statics"
    yield "Wrench of the cables on the platform. In C: `tb_wrench` of `tb_statics.h`."
    yield display(r"\mathbf{W} = \mathbf{S} \mathbf{T}")
    yield "Torque of the cable motors [N m]. In C: `tb_motor_torques` of `tb_control.h`."
    yield display(rf"\tau_i = {machine.drum.radius:g} \, T_i")


def tension_parts(machine: Machine) -> Iterator[str]:
    """The quadratic program of the tensions, and what is served where it has no solution."""
    low, high = machine.tension.min, machine.tension.max
    words, formula = POLICIES[machine.tension.when_infeasible]
    yield "## Tension distribution"
    yield (
        f"The wanted wrench has {machine.dof} entries, the machine {len(machine.cables)} cables: "
        f"{machine.redundancy} tensions are free, and the least norm decides [N] (Yoon eq. 12). "
        "In C: `tb_distribute_tension` of `tb_tension.h`."
    )
    yield display(
        r"\min_{\mathbf{T}} \frac{1}{2} \mathbf{T}^{\mathsf{T}} \mathbf{T} "
        r"\quad \text{subject to} \quad \mathbf{S} \mathbf{T} = \mathbf{W}, \quad "
        rf"{low:g} \le T_i \le {high:g}"
    )
    yield f"{words} The wrenches that can be had are a zonotope."
    yield display(
        r"\mathcal{W} = \left\{ \mathbf{S} \mathbf{T} : "
        rf"{low:g} \le T_i \le {high:g} \right\}}, \quad {formula}"
    )
