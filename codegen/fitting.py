"""Whether the parts of a function that is made of others fit together."""

from collections.abc import Mapping, Sequence

from turnbuckle.model.symbolic.function import Port

Shape = tuple[int, ...]


def refuse_strangers(part: str, ports: Sequence[Port], known: Mapping[str, Shape]) -> None:
    """A part names what is there, in the shape it has; else ValueError."""
    for port in ports:
        if known.get(port.name) != port.shape:
            raise ValueError(f"{part}: {port.name} {port.shape} is none of {dict(known)}")


def shapes(ports: Sequence[Port]) -> dict[str, Shape]:
    """Shapes of some ports by name."""
    return {port.name: port.shape for port in ports}
