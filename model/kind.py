"""The platform kinds a machine file may name; a new kind is one new entry here.

What the model needs to know of a kind follows from its dimensions: it asks for `space` and
`is_rigid`, never for a name.
"""

from dataclasses import dataclass

TURNS = {2: 1, 3: 3}
"""Axes about which a body turns, by the dimension of its space."""


@dataclass(frozen=True)
class Kind:
    """A kind of platform: degrees of freedom d, dimension of its space, what it is, in words."""

    dof: int
    space: int
    meaning: str

    def __post_init__(self) -> None:
        """Raises ValueError for dimensions that the model has no rotations for."""
        rotations = TURNS.get(self.space, 0)
        if self.space not in TURNS or self.dof not in (self.space, self.space + rotations):
            raise ValueError(
                f"found {self.dof} degrees of freedom in a space of dimension {self.space};"
                " allowed: a space of 2 or 3, with no rotation or with all that there are"
            )

    @property
    def is_rigid(self) -> bool:
        """Whether the platform turns, so that cables hold it at anchors and exert moments."""
        return self.dof > self.space


KINDS: dict[str, Kind] = {
    "planar-point": Kind(2, 2, "all cables meet in one point that moves in a plane"),
    "planar-rigid": Kind(3, 2, "cables hold a body that moves and turns in a plane"),
    "spatial-point": Kind(3, 3, "all cables meet in one point that moves in space"),
    "spatial-rigid": Kind(6, 3, "cables hold a body that moves and turns in space"),
}
