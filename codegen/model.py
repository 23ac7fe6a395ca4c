"""A machine with its functions lowered and simplified, ready to print."""

from dataclasses import dataclass

from turnbuckle.codegen.chain import chain
from turnbuckle.codegen.composite import Item, Procedure, loop
from turnbuckle.codegen.enumeration import enumeration
from turnbuckle.codegen.ir import Routine
from turnbuckle.codegen.lower import lower
from turnbuckle.codegen.simplify import simplify
from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic.composition import Composite, Composition
from turnbuckle.model.symbolic.function import ModelFunction, Repeat
from turnbuckle.model.symbolic.sweep import Sweep
from turnbuckle.model.symbolic.topics import model_composites, model_functions


@dataclass(frozen=True)
class Model:
    """A machine with its functions ready to print, by topic."""

    machine: Machine
    topics: dict[str, list[Item]]

    def items(self) -> list[Item]:
        """All functions in order."""
        return [item for items in self.topics.values() for item in items]

    def aliases(self) -> dict[str, str]:
        """Functions that are another one under a second name."""
        return {"distribute_tension": f"distribute_tension_{self.machine.tension.when_infeasible}"}


def build_model(machine: Machine) -> Model:
    """Lower and simplify every function of the machine."""
    routines = {
        topic: [lowered(function) for function in functions]
        for topic, functions in model_functions(machine).items()
    }
    topics: dict[str, list[Item]] = {topic: [*group] for topic, group in routines.items()}
    known = {item.function.name: item for group in topics.values() for item in group}
    for topic, composites in model_composites(machine).items():
        for composite in composites:
            item = composed(composite, known)
            known[composite.name] = item
            topics[topic].append(item)
    return Model(machine, topics)


def composed(composite: Composite, known: dict[str, Item]) -> Item:
    """A function made of others: of those that are known, or of its own parts."""
    if isinstance(composite, Repeat):
        return loop(composite, lowered)
    if isinstance(composite, Sweep):
        return enumeration(composite, lowered)
    if isinstance(composite, Composition):
        return chain(composite, known, lowered)
    attempts = tuple(known[name] for name in composite.attempts)
    return Procedure(composite, attempts, known[composite.substitute])


def lowered(function: ModelFunction) -> Routine:
    """A model function ready to print."""
    return simplify(lower(function))
