"""The platform kinds a machine file may name; a new kind is one new entry here."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Kind:
    """A kind of platform: its degrees of freedom d and what it is, in words."""

    dof: int
    meaning: str


KINDS: dict[str, Kind] = {
    "planar-point": Kind(dof=2, meaning="all cables meet in one point that moves in a plane"),
}
