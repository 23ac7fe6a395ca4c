"""Which numbers in the C of a machine are constants of tb_machine.h, told by what they follow.

Two numbers may be equal and mean different things: 3 N of tension, three times a rounding error. So
the model is built once more for a machine whose every number is a little different. A number in the
C is a constant of tb_machine.h if it equals the constant in both.
"""

from collections import defaultdict
from collections.abc import Iterable, Iterator
from functools import cached_property

from turnbuckle.codegen.constants import Constant, constants
from turnbuckle.codegen.counterpart import Place, counterparts
from turnbuckle.codegen.ir import Routine
from turnbuckle.codegen.item import Item
from turnbuckle.codegen.model import Model, build_model
from turnbuckle.codegen.model_constants import model_constants
from turnbuckle.codegen.print_c import literal
from turnbuckle.codegen.varied import varied
from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic.function import ModelFunction

#: A number in the C of a machine and in that of the varied one.
Pair = tuple[str, str]


class ConstantNames:
    """The names of numbers in the C of one machine."""

    def __init__(self, model: Model) -> None:
        self.model = model
        self.known = named_pairs(model.machine, varied(model.machine))

    @cached_property
    def twins(self) -> dict[str, Item]:
        """The items of the varied machine by the names of their functions."""
        items = build_model(varied(self.model.machine)).items()
        return {item.function.name: item for item in every(items)}

    def of_places(self, routine: Routine) -> dict[Place, str]:
        """What stands in a routine where it reads a constant that has a name."""
        twin = self.twins.get(routine.function.name)
        if not isinstance(twin, Routine):
            return {}
        roots = routine.roots()
        result = {}
        for place, other in counterparts(routine, twin).items():
            node, operand = place
            number = roots[operand] if node < 0 else routine.nodes[node].args[operand]
            if name := self.name(routine.nodes[number].value, other):
                result[place] = name
        return result

    def of_fallbacks(self, function: ModelFunction) -> list[str]:
        """What every result becomes that must not be used: a name or a number."""
        twin = self.twins.get(function.name)
        twins = twin.function.outputs if twin else function.outputs
        return [
            self.name(output.fallback, other.fallback) or literal(output.fallback)
            for output, other in zip(function.outputs, twins, strict=True)
        ]

    def name(self, value: float, other: float) -> str | None:
        """The name of a number, with its sign; None where it has none."""
        for sign, factor in (("", 1.0), ("-", -1.0)):
            if name := self.known.get((literal(factor * value), literal(factor * other))):
                return f"{sign}{name}"
        return None


def named_pairs(machine: Machine, other: Machine) -> dict[Pair, str]:
    """The names of numbers that change; none where the constants of one group share a number."""
    known: dict[Pair, str] = {}
    groups = zip(every_group(machine), every_group(other), strict=True)
    for group, others in groups:
        names = defaultdict(list)
        for constant, twin in zip(group, others, strict=True):
            names[bare(constant.text), bare(twin.text)].append(constant.name)
        known |= {
            pair: alike[0]
            for pair, alike in names.items()
            if len(alike) == 1 and pair not in known and pair[0] != pair[1]
        }
    return known


def every_group(machine: Machine) -> Iterator[list[Constant]]:
    """The groups of the runtime's constants, then those of the model's."""
    yield from constants(machine)
    yield from model_constants(machine)


def bare(text: str) -> str:
    """A number without parentheses around it."""
    return text.removeprefix("(").removesuffix(")") if text.startswith("(") else text


def every(items: Iterable[Item]) -> Iterator[Item]:
    """The items and all that they alone call."""
    for item in items:
        yield from every(item.own())
        yield item
