"""The pulleys that guide the cables; a radius above zero turns on wrap-angle kinematics."""

from dataclasses import dataclass
from typing import Literal

from pydantic import Field

from turnbuckle.model.base import Coordinates
from turnbuckle.model.quantity import Length, UnitVector
from turnbuckle.model.table import Table

#: Sense in which a cable is wound, seen along its way to the platform: +1 is counter-clockwise.
SENSE = {"left": 1, "right": -1}


class PulleyTable(Table):
    """A pulley of some radius: in the plane its centre is the base, in space it swivels."""

    radius: Length = Field(description="radius of the pulley, to the middle of the cable [m]")
    winds: Literal["left", "right"] = Field(
        "left", description="planar: left (counter-clockwise) or right, on the way to the platform"
    )
    contact: UnitVector | None = Field(
        None,
        description="planar: two plain numbers [x, y], from the centre to where the cable first"
        " touches; away from the frame's centre by default",
    )
    axis: UnitVector | None = Field(
        None,
        description="spatial: three plain numbers [x, y, z], the direction in which the cable runs"
        " along the swivel axis into the base point",
    )


@dataclass(frozen=True)
class Pulley:
    """A pulley of `radius` [m]: planar with sense `winds` and first `contact`, spatial with `axis`.

    contact: unit vector from the pulley's centre; axis: unit vector of the cable's way in.
    """

    radius: float
    winds: int = 1
    contact: Coordinates = ()
    axis: Coordinates = ()
