"""The platform kinds a machine file may name; a new kind is one new entry here."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Kind:
    """A kind of platform: degrees of freedom d, dimension of its space, what it is, in words."""

    dof: int
    space: int
    meaning: str

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
