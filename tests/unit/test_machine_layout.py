"""Refusals of what a machine file says of places: kinds, anchors, bases, rails and pulleys."""

from pathlib import Path

import pytest

from turnbuckle.model.problem import MachineError
from turnbuckle.model.reading import load_machine

HEAD = """
[machine]
name = "tried"
kind = "{kind}"
source = "a test"

[frame]
size = [{size}]
{platform}
"""
TAIL = """
[tension]
min = "1 N"
max = "10 N"
when_infeasible = "closest"

[drum]
radius = "5 mm"

[cable_motor]
inertia = "21 g*cm^2"
damping = "0.05 g*m^2/s"
torque_limit = "55 mN*m"
torque_rate_limit = "20 N*m/s"

[control]
rate = "1 kHz"
velocity_corner = "100 Hz"

[target]
size = [{target}]
centre = [{centre}]
force = "1 N"
"""
RAIL_DRIVE = """
[rail_drive]
pinion_radius = "15 mm"
force_limit = "60 N"
stiffness = "11000 N/m"
integral = "30000 N/(m*s)"
damping = "140 N*s/m"
derivative_corner = "200 Hz"
"""
TURNING = '[platform]\nrotation = "30 deg"\n'
CORNERS = (("0 m", "0 m"), ("1 m", "0 m"), ("1 m", "1 m"), ("0 m", "1 m"))
ANCHORS = (("-5 cm", "-4 cm"), ("5 cm", "-4 cm"), ("5 cm", "4 cm"), ("-5 cm", "4 cm"))


def array(entries: tuple[str, ...]) -> str:
    """A TOML array of texts."""
    return ", ".join(f'"{entry}"' for entry in entries)


def planar(
    cables: list[str], kind: str = "planar-point", platform: str = "", more: str = ""
) -> str:
    """A machine in a square metre with these [[cable]] tables."""
    size = array(("1 m", "1 m"))
    tail = TAIL.format(target=array(("10 cm", "10 cm")), centre=array(("50 cm", "50 cm")))
    tables = "".join(f"\n[[cable]]\n{cable}\n" for cable in cables)
    return HEAD.format(kind=kind, size=size, platform=platform) + tables + tail + more


def spatial(cables: list[str], more: str = "") -> str:
    """A spatial-point machine in a cubic metre."""
    tail = TAIL.format(target=array(("10 cm",) * 3), centre=array(("50 cm",) * 3))
    head = HEAD.format(kind="spatial-point", size=array(("1 m",) * 3), platform=more)
    return head + "".join(f"\n[[cable]]\n{cable}\n" for cable in cables) + tail


FIXED = [f"base = [{array(corner)}]" for corner in CORNERS]
RIGID = [f"{b}\nanchor = [{array(a)}]" for b, a in zip(FIXED, ANCHORS, strict=True)]
TETRAHEDRON = [
    f"base = [{array(point)}]"
    for point in (("0 m", "0 m", "0 m"), ("1 m", "1 m", "0 m"), ("1 m", "0 m", "1 m"),
                  ("0 m", "1 m", "1 m"))
]  # fmt: skip


def rail(start: tuple[str, str], end: tuple[str, str], more: str = "") -> str:
    """A rail as a line of a [[cable]] table."""
    return f"rail = {{ from = [{array(start)}], to = [{array(end)}]{more} }}"


BOTTOM, RIGHT, TOP, LEFT = (
    rail(CORNERS[0], CORNERS[1]),
    rail(CORNERS[1], CORNERS[2]),
    rail(CORNERS[3], CORNERS[2]),
    rail(CORNERS[0], CORNERS[3]),
)


def follows(line: str, drive: str) -> str:
    """The rail coupled to another cable's."""
    return line.replace(" }", f', follows = "{drive}" }}')


PLANE = 'plane = {{ corner = ["0 m", "0 m"], along = ["{}", "0 m"], across = [{}] }}'

#: What is wrong, the file, the key, what was found, what is allowed.
REFUSALS = {
    "a point of the plane in space": (
        spatial([TETRAHEDRON[0].replace(', "0 m"]', "]"), *TETRAHEDRON[1:]]),
        ("cable[1].base", '["0 m", "0 m"]', "an array of three, one entry an axis"),
    ),
    "a point of space in the plane": (
        planar(['base = ["0 m", "0 m", "0 m"]', *FIXED[1:]]),
        ("cable[1].base", '["0 m", "0 m", "0 m"]', "an array of two, one entry an axis"),
    ),
    "an anchor on a point": (
        planar([*FIXED[:3], RIGID[3]]),
        ("cable[4].anchor", '["-5 cm", "4 cm"]', "no anchor: the platform of planar-point"),
    ),
    "no anchor on a body": (
        planar([*RIGID[:3], FIXED[3]], "planar-rigid", TURNING),
        ("cable[4].anchor", "nothing", "where the platform holds the cable"),
    ),
    "a body whose anchors are all in its centre": (
        planar([f'{b}\nanchor = ["0 m", "0 m"]' for b in FIXED], "planar-rigid", TURNING),
        ("cable", "every anchor at the platform's centre", "anchors off the centre"),
    ),
    "a body without a range of rotation": (
        planar(RIGID, "planar-rigid"),
        ("platform", "nothing", "a table, because of the kind planar-rigid"),
    ),
    "a point with a range of rotation": (
        planar(FIXED, platform=TURNING),
        ("platform", "a table", "no such table"),
    ),
    "a rotation of an unknown unit": (
        planar(RIGID, "planar-rigid", '[platform]\nrotation = "30 percent"\n'),
        ("platform.rotation", '"30 percent", whose unit is unknown', "an angle with its unit"),
    ),
    "a rotation in mils": (
        planar(RIGID, "planar-rigid", '[platform]\nrotation = "800 mil"\n'),
        ("platform.rotation", '"800 mil", whose unit is unclear', "write deg, mrad or mm"),
    ),
    "a solid angle": (
        planar(RIGID, "planar-rigid", '[platform]\nrotation = "0.17 sr"\n'),
        ("platform.rotation", '"0.17 sr", a solid angle', "an angle with its unit"),
    ),
    "a squared angle": (
        planar(RIGID, "planar-rigid", '[platform]\nrotation = "500 deg^2"\n'),
        ("platform.rotation", '"500 deg^2", a solid angle', "an angle with its unit"),
    ),
    "more than half a turn": (
        planar(RIGID, "planar-rigid", '[platform]\nrotation = "181 deg"\n'),
        ("platform.rotation", '"181 deg"', "an angle of at most 180 deg"),
    ),
    "a moment on a point": (
        planar(FIXED).replace('force = "1 N"', 'force = "1 N"\nmoment = "1 N*m"'),
        ("target.moment", '"1 N*m"', "no such key"),
    ),
    "a target that turns farther than the platform": (
        planar(RIGID, "planar-rigid", TURNING).replace(
            'force = "1 N"', 'force = "1 N"\nrotation = "31 deg"'
        ),
        ("target.rotation", '"31 deg"', 'at most platform.rotation = "30 deg"'),
    ),
    "fewer cables than a body takes": (
        planar(RIGID[:3], "planar-rigid", TURNING),
        ("cable", "3 cables", "4 to 16 cables for the kind planar-rigid"),
    ),
    "a rail of zero length": (
        planar([rail(CORNERS[0], CORNERS[0]), RIGHT, TOP, LEFT], more=RAIL_DRIVE),
        ("cable[1].rail.to", '["0 m", "0 m"]', "an end other than the rail's from"),
    ),
    "a plane of zero width": (
        planar([PLANE.format("1 m", '"2 m", "0 m"'), RIGHT, TOP, LEFT], more=RAIL_DRIVE).replace(
            '"2 m"', '"0.5 m"'
        ),
        ("cable[1].plane.across", '["0.5 m", "0 m"]', "a point off the line"),
    ),
    "a plane and a rail": (
        planar([PLANE.format("1 m", '"0 m", "1 m"') + "\n" + RIGHT, RIGHT, TOP, LEFT]),
        ("cable[1]", "both rail and plane", "one of base, rail and plane"),
    ),
    "a cable that heads along its rail": (
        planar([BOTTOM.replace(" }", ", heading = [-1, 0] }"), RIGHT, TOP, LEFT], more=RAIL_DRIVE),
        ("cable[1].rail.heading", "[-1, 0]", "a direction that is not along the rail"),
    ),
    "rails coupled in a cycle": (
        planar(
            [follows(BOTTOM, "cable_3"), RIGHT, follows(TOP, "cable_1"), LEFT], more=RAIL_DRIVE
        ),
        ("cable[1].rail.follows", '"cable_3"', "no cycle"),
    ),
    "a rail that follows itself": (
        planar([follows(BOTTOM, "cable_1"), RIGHT, TOP, LEFT], more=RAIL_DRIVE),
        ("cable[1].rail.follows", '"cable_1"', "cable_2, cable_3, cable_4"),
    ),
    "a rail that follows a fixed base": (
        planar([follows(BOTTOM, "cable_2"), FIXED[1], TOP, LEFT], more=RAIL_DRIVE),
        ("cable[1].rail.follows", '"cable_2"', "cable_3, cable_4"),
    ),
    "a rail that is shorter than the one it follows": (
        planar(
            [follows(rail(CORNERS[0], ("0.5 m", "0 m")), "cable_3"), RIGHT, TOP, LEFT],
            more=RAIL_DRIVE,
        ),
        ("cable[1].rail.follows", '"cable_3", led by a rail of 1000 mm', "at most this one's 500"),
    ),
    "an axis of a planar pulley": (
        planar(FIXED, platform='[pulley]\nradius = "5 mm"\naxis = [0, 1]\n'),
        ("pulley.axis", "[0, 1]", "no such key for the kind planar-point"),
    ),
    "a spatial pulley without an axis": (
        spatial(TETRAHEDRON, '[pulley]\nradius = "5 mm"\n'),
        ("pulley.axis", "nothing", "the direction in which the cable runs into the pulley"),
    ),
    "a spatial pulley that winds": (
        spatial(TETRAHEDRON, '[pulley]\nradius = "5 mm"\nwinds = "left"\naxis = [0, 0, 1]\n'),
        ("pulley.winds", '"left"', "no such key for the kind spatial-point"),
    ),
    "a pulley in the middle of the frame": (
        planar([*FIXED, 'base = ["50 cm", "50 cm"]\npulley = { radius = "5 mm" }']),
        ("cable[5].pulley.contact", "nothing", "from the pulley's centre"),
    ),
    "a pulley without a radius": (
        planar(FIXED, platform='[pulley]\nradius = "0 mm"\n'),
        ("pulley.radius", '"0 mm"', "greater than zero"),
    ),
    "bases in one plane": (
        spatial(
            [f"base = [{array((*corner, '0.5 m'))}]" for corner in CORNERS]
        ),
        ("cable", "4 bases on one plane", "bases off one plane"),
    ),
    "bodies whose cables exert no moment": (
        planar(
            [
                f'base = ["0 m", "0.5 m"]\nanchor = ["{x} cm", "{y} cm"]'
                for x, y in ((0, -5), (1, 5), (0, -6), (1, 6))
            ],
            "planar-rigid",
            TURNING,
        ),
        ("cable", "4 cables, pulling in fewer than 3 directions", "3 independent directions"),
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", REFUSALS)
def test_a_machine_that_cannot_be_is_refused(tmp_path: Path, case: str) -> None:
    text, (key, found, allowed) = REFUSALS[case]
    path = tmp_path / "bad.toml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(MachineError) as caught:
        load_machine(path)
    message = str(caught.value)
    assert message.startswith(f"{path}: {key}: found {found}"), message
    assert allowed in message
    assert "\n" not in message


def loaded(tmp_path: Path, text: str) -> object:
    """The machine of a file's text."""
    path = tmp_path / "good.toml"
    path.write_text(text, encoding="utf-8")
    return load_machine(path)


@pytest.mark.parametrize(
    "text",
    [
        planar(FIXED),
        planar(RIGID, "planar-rigid", TURNING),
        planar([BOTTOM, RIGHT, follows(TOP, "cable_1"), follows(LEFT, "cable_2")], more=RAIL_DRIVE),
        planar([PLANE.format("1 m", '"0 m", "0.2 m"'), RIGHT, TOP, LEFT], more=RAIL_DRIVE),
        planar(FIXED, platform='[pulley]\nradius = "5 mm"\nwinds = "right"\n'),
        spatial(TETRAHEDRON),
        spatial(TETRAHEDRON, '[pulley]\nradius = "5 mm"\naxis = [0, 0, 1]\n'),
    ],
)
def test_the_machines_that_the_refusals_spoil_are_fine(tmp_path: Path, text: str) -> None:
    assert loaded(tmp_path, text)
