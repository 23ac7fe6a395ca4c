"""The vectors of a machine, and their file: one vector a line, arguments, a colon, results.

Every number is written as its bits, in hexadecimal: 16 digits a double, 8 a float or an integer.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from struct import Struct

from turnbuckle.model.refusal import Refusal

FORMAT = "turnbuckle vectors 1"
FUNCTIONS = ("distribute_tension", "controller_start", "controller_step")
"""In the order in which the program is given them."""
COUNTS = Struct("<II")

Words = tuple[str, ...]
"""Numbers, as their bits in hexadecimal."""


class VectorsError(Refusal):
    """A text is no file of vectors."""


@dataclass(frozen=True)
class Vector:
    """Arguments of a call, and what it gives."""

    arguments: Words
    results: Words = ()


@dataclass(frozen=True)
class Vectors:
    """Of a machine in one precision, by function; the controller's steps are those of one run."""

    by_function: Mapping[str, Sequence[Vector]]

    def each(self) -> Iterator[tuple[str, Vector]]:
        """A name and the vector, as the program reads them."""
        for function in FUNCTIONS:
            for number, vector in enumerate(self.by_function[function]):
                yield f"{function} {number}", vector

    @property
    def count(self) -> int:
        """Number of results."""
        return sum(len(vector.results) for _, vector in self.each())

    def stream(self) -> bytes:
        """All arguments, as the program reads them."""
        counts = [len(self.by_function[name]) for name in (FUNCTIONS[0], FUNCTIONS[2])]
        arguments = (bytes_of(vector.arguments) for _, vector in self.each())
        return COUNTS.pack(*counts) + b"".join(arguments)

    def differences(self, given: bytes) -> list[str]:
        """Where a program has given other results: the vector, the number, both bits."""
        found, at = [], 0
        for name, vector in self.each():
            for place, word in enumerate(vector.results):
                end = at + len(word) // 2
                there, at = given[at:end][::-1].hex(), end
                if there != word:
                    found.append(f"{name}, result {place}: {there or 'nothing'} in place of {word}")
        if len(given) != at:
            found.append(f"{len(given)} bytes in place of {at}")
        return found


def bytes_of(words: Words) -> bytes:
    """Numbers as they stand in memory, the least byte first."""
    return b"".join(bytes.fromhex(word)[::-1] for word in words)


def write(machine: str, by_precision: Mapping[str, Vectors]) -> str:
    """The file of a machine."""
    lines = [FORMAT, f"machine {machine}"]
    for precision, vectors in by_precision.items():
        for function in FUNCTIONS:
            lines.append(f"{precision} {function}")
            lines += [
                " ".join([*vector.arguments, ":", *vector.results])
                for vector in vectors.by_function[function]
            ]
    return "\n".join(lines) + "\n"


def read(text: str) -> dict[str, Vectors]:
    """The vectors of a file, by precision; VectorsError where the text is none of this version."""
    first, _, *lines = text.splitlines() or ["", ""]
    if first != FORMAT:
        raise VectorsError(f"the first line is {first!r}; allowed: {FORMAT!r}")
    found: dict[str, dict[str, list[Vector]]] = {}
    vectors: list[Vector] = []
    for line in lines:
        arguments, colon, results = line.partition(":")
        if colon:
            vectors.append(Vector(tuple(arguments.split()), tuple(results.split())))
        else:
            precision, function = line.split()
            vectors = found.setdefault(precision, {}).setdefault(function, [])
    return {precision: Vectors(by_function) for precision, by_function in found.items()}
