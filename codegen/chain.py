"""Compositions, lowered."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

from turnbuckle.codegen.enumeration import Enumeration, enumeration
from turnbuckle.codegen.fitting import Shape, refuse_strangers, shapes
from turnbuckle.codegen.ir import Routine
from turnbuckle.codegen.item import Item
from turnbuckle.model.symbolic.composition import Call, Composition
from turnbuckle.model.symbolic.function import Input, ModelFunction, Output, Port, judged_by_results
from turnbuckle.model.symbolic.sweep import Sweep


@dataclass(frozen=True)
class Link:
    """One call of a chain; `own` where only the chain has the function."""

    item: Item
    call: Call
    own: bool

    def local(self, port: Port) -> str:
        """What the chain calls an argument or a result of the function."""
        return self.call.renamed.get(port.name, port.name)

    def takes(self) -> dict[str, Shape]:
        """Arguments by the chain's names."""
        return {self.local(port): port.shape for port in self.item.function.inputs}

    def gives(self) -> dict[str, Output]:
        """Results by the chain's names."""
        return {self.local(port): port for port in self.item.function.outputs}


@dataclass(frozen=True)
class Chain(Item):
    """A function made of calls in sequence: see Composition."""

    composition: Composition
    links: tuple[Link, ...]

    @property
    def function(self) -> ModelFunction:
        """Arguments, results and verdicts, as if it were one routine."""
        return ModelFunction(
            self.composition.name,
            self.composition.summary,
            self.composition.source,
            self.composition.inputs,
            self.links[-1].item.function.outputs,
            tuple(v for link in self.links for v in link.item.function.verdicts),
        )

    def calls(self) -> Sequence[tuple[Item, int]]:
        """Every link once."""
        return [(link.item, 1) for link in self.links]

    def own(self) -> Sequence[Item]:
        """What it alone calls."""
        return [link.item for link in self.links if link.own]

    def text(self) -> str:
        """Its name, and how its parts are called."""
        calls = [f"{sorted(link.call.renamed.items())} {link.call.given!r}" for link in self.links]
        return "\n".join([self.composition.name, *calls])

    def called(self) -> list[str]:
        """Names of the functions that others may call too."""
        return [link.item.function.name for link in self.links if not link.own]


def chain(
    composition: Composition,
    known: Mapping[str, Item],
    lowered: Callable[[ModelFunction], Routine],
) -> Chain:
    """The calls of a composition on functions that are known or its own.

    Of its own functions the first that takes an argument guards it; results are taken as they are.
    Raises ValueError where the calls do not fit together.
    """
    links: list[Link] = []
    there = shapes(composition.inputs)
    guarded: set[str] = set()
    for call in composition.calls:
        if isinstance(call.function, str):
            link = Link(known[call.function], call, False)
        else:
            link = Link(own_item(call, guarded, lowered), call, True)
        refuse_misfits(link, there)
        guarded |= link.takes().keys() | link.gives().keys()
        there |= {name: port.shape for name, port in link.gives().items()}
        links.append(link)
    return Chain(composition, tuple(links))


def own_item(
    call: Call, guarded: set[str], lowered: Callable[[ModelFunction], Routine]
) -> Routine | Enumeration:
    """A lowered part that guards what is not guarded yet."""

    def left(port: Input) -> Input:
        return (
            judged_by_results(port) if call.renamed.get(port.name, port.name) in guarded else port
        )

    part = call.function
    if isinstance(part, Sweep):
        begin = replace(part.begin, inputs=tuple(map(left, part.begin.inputs)))
        return enumeration(replace(part, begin=begin), lowered)
    assert isinstance(part, ModelFunction)
    return lowered(replace(part, inputs=tuple(map(left, part.inputs))))


def refuse_misfits(link: Link, there: Mapping[str, Shape]) -> None:
    """A call takes what there is, gives new results, and is made for one number or always."""
    name = link.item.function.name
    ports = [replace(port, name=link.local(port)) for port in link.item.function.inputs]
    refuse_strangers(name, ports, there)
    if again := link.gives().keys() & there.keys():
        raise ValueError(f"{name}: there is a {min(again)} already")
    if link.call.given and there.get(link.call.given) != ():
        raise ValueError(f"{name}: {link.call.given} is no number")
