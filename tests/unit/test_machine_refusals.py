"""Every mistake in a machine file gets one message: file, key, what was found, what is allowed."""

import errno
import os
import re
from pathlib import Path

import pytest
from machine_text import without_buses

from turnbuckle.model.problem import MachineError
from turnbuckle.model.reading import load_machine
from turnbuckle.places import MACHINES

STOCK = Path(__file__).parents[2] / "machines" / "yoon2023.toml"
TEXT = STOCK.read_text(encoding="utf-8")
RAIL_1 = 'rail = { from = ["0 mm", "0 mm"], to = ["711.8 mm", "0 mm"] }'
RAIL_2 = 'rail = { from = ["711.8 mm", "0 mm"], to = ["711.8 mm", "461.8 mm"] }'
RAIL_3 = 'rail = { from = ["0 mm", "461.8 mm"], to = ["711.8 mm", "461.8 mm"] }'
RAIL_4 = 'rail = { from = ["0 mm", "0 mm"], to = ["0 mm", "461.8 mm"] }'
CARRIAGE_MASS = 'carriage_mass = "1 kg"'
RADIUS = 'radius = "5 mm"'
FRAME = 'from the origin to frame.size = ["711.8 mm", "461.8 mm"]'
CABLE = '\n[[cable]]\nbase = ["0 mm", "0 mm"]\n'
WALL = """
[[wall]]
name = "w{}"
point = ["1 mm", "1 mm"]
normal = [1, 0]
stiffness = "1 N/m"
damping = "0 N*s/m"
"""
CORNER = 'corner = "5 Hz"'
ALL_IN_ONE_CORNER = [(rail, 'base = ["0 mm", "0 mm"]') for rail in (RAIL_1, RAIL_2, RAIL_3, RAIL_4)]
NAME = "a name of 1 to 31 characters: a lower case letter"
POSITIVE = "greater than zero"
NO_UNIT = ", a number without a unit"
UNKNOWN = ", whose unit is unknown"
UNCLEAR = ", whose unit is unclear"
DIVIDED = ", in which it is unclear what is divided by"


def refusal(tmp_path: Path, text: str) -> str:
    """The message that a machine file of this text gets, less the file's name."""
    path = tmp_path / "bad.toml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(MachineError) as caught:
        load_machine(path)
    message = str(caught.value)
    assert message.startswith(f"{path}: ")
    assert "\n" not in message
    return message.removeprefix(f"{path}: ")


def without(header: str, text: str = TEXT) -> str:
    """The file less the first table of this header and the tables within it."""
    start = text.index(f"\n{header}") + 1
    name = re.escape(header.strip("[]"))
    following = re.compile(rf"^\[(?!{name}\.)", re.MULTILINE).search(text, start + 1)
    return text[:start] + (text[following.start() :] if following else "")


def changed(*edits: tuple[str, str], text: str = TEXT) -> str:
    """The file with the first occurrence of each text replaced."""
    for old, new in edits:
        assert old in text
        text = text.replace(old, new, 1)
    return text


def with_value(key: str, value: str) -> str:
    """The stock file with another TOML value at `table.key` or `table[number].key`."""
    match = re.fullmatch(r"(\w+)(?:\[(\d+)\])?\.(\w+)", key)
    assert match is not None
    table, number, name = match.groups()
    header = f"[[{table}]]" if number else f"[{table}]"
    start = -1
    for _ in range(int(number or 1)):
        start = TEXT.index(header, start + 1)
    line = re.compile(rf"^{name} = .*$", re.MULTILINE).search(TEXT, start)
    assert line is not None
    return TEXT[: line.start()] + f"{name} = {value}" + TEXT[line.end() :]


# key, what is written there, what the message says is allowed, what it adds to the found value
BAD_VALUES = [
    # numbers and units
    ("drum.radius", "5", 'a length with its unit, greater than zero, such as "5 mm"', NO_UNIT),
    ("drum.radius", '"5"', "a length with its unit", NO_UNIT),
    ("drum.radius", "nan", "a length with its unit", NO_UNIT),
    ("drum.radius", "-inf", "a length with its unit", NO_UNIT),
    ("drum.radius", "true", "a length with its unit", ""),
    ("drum.radius", '""', "a length with its unit", ""),
    ("drum.radius", '"wide"', "a length with its unit", ""),
    (
        "drum.radius",
        '"5,000 mm"',
        '; write "5.000 mm" or "5000 mm"',
        ", whose comma may mean two things",
    ),
    ("drum.radius", '"5,000,0 mm"', "; write digits and a decimal point only", ""),
    ("drum.radius", '"5.000,1 mm"', "; write digits and a decimal point only", ""),
    ("drum.radius", '"5 000 mm"', "; write digits and a decimal point only", ""),
    ("drum.radius", '"0x10 mm"', "a length with its unit", UNKNOWN),
    ("drum.radius", '"5 mm; 6 mm"', "a length with its unit", ""),
    ("drum.radius", '"9**9**9**9 mm"', "a length with its unit", ""),
    ("drum.radius", '"1 mm^9**9**9"', "a length with its unit", ""),
    ("drum.radius", '"1 m/0"', "a length with its unit", ""),
    ("drum.radius", '["5 mm"]', "a length with its unit", ""),
    ("drum.radius", "1979-05-27", "a length with its unit", ""),
    ("drum.radius", '"5 furlongg"', "a length with its unit", UNKNOWN),
    ("drum.radius", '"5 kg"', "a length with its unit", ", a mass"),
    ("drum.radius", '"5 percent"', "a length with its unit", UNKNOWN),
    ("drum.radius", '"5 MM"', "; did you mean Mm or mm?", UNKNOWN),
    ("drum.radius", '"5 mil"', "; a mil is 1/6400 of a turn", UNCLEAR),
    ("drum.radius", '"5 degC*m"', "a length with its unit", UNKNOWN),
    ("drum.radius", '"5 dBm*m"', "a length with its unit", UNKNOWN),
    ("drum.radius", "0x" + "f" * 5000, "a length with its unit", NO_UNIT),
    ("cable_motor.torque_rate_limit", '"20 dBm"', "a torque per time", UNKNOWN),
    ("drum.radius", '"nan mm"', "a finite number: a length with its unit", ""),
    ("drum.radius", '"-inf mm"', "a finite number: a length with its unit", ""),
    ("drum.radius", '"1e400 mm"', "a finite number: a length with its unit", ""),
    ("drum.radius", '"1e300 mm"', "of a size from 1e-06 to 10000 m", ""),
    ("drum.radius", '"1e-300 mm"', "of a size from 1e-06 to 10000 m", ""),
    ("drum.radius", '"1e-999999999 mm"', POSITIVE, ""),
    ("control.rate", '"6283 rad/s"', "cycles, not angle, per second", ", a speed of rotation"),
    ("control.rate", '"60000 rpm"', "cycles, not angle, per second", ", a speed of rotation"),
    ("control.rate", '"1 s"', "a frequency with its unit", ", a time"),
    ("cable_motor.inertia", '"21 g*cm"', "a moment of inertia", ", a quantity in kg*m"),
    ("cable_motor.inertia", '"21 gm2"', "; write g, or g*m", UNCLEAR),
    ("cable_motor.torque_limit", '"55 mN-m"', "; write mN*m", ""),
    ("cable_motor.torque_limit", '"8 oz-in"', "; write ozf*in", UNCLEAR),
    ("cable_motor.torque_limit", '"8 kg*cm"', "a torque with its unit", ", a quantity in kg*m"),
    ("rail_drive.integral", '"3 N/m"', "an integral gain", ", a stiffness"),
    ("rail_drive.integral", '"3 N/m s"', "; put all that is divided by in parentheses", DIVIDED),
    ("rail_drive.integral", '"3 N/m*s"', "; put all that is divided by in parentheses", DIVIDED),
    # signs
    ("drum.radius", '"-5 mm"', POSITIVE, ""),
    ("drum.radius", '"0 mm"', POSITIVE, ""),
    ("tension.min", '"-3 N"', "not negative", ""),
    ("tension.max", '"0 N"', POSITIVE, ""),
    ("cable_motor.inertia", '"0 g*cm^2"', POSITIVE, ""),
    ("cable_motor.damping", '"-0.05 g*m^2/s"', "not negative", ""),
    ("cable_motor.torque_limit", '"-55 mN*m"', POSITIVE, ""),
    ("cable_motor.torque_rate_limit", '"0 N*m/s"', POSITIVE, ""),
    ("control.rate", '"0 Hz"', POSITIVE, ""),
    ("control.velocity_corner", '"-1 Hz"', POSITIVE, ""),
    ("disturbance_observer.corner", '"0 Hz"', POSITIVE, ""),
    ("rail_drive.pinion_radius", '"0 mm"', POSITIVE, ""),
    ("rail_drive.force_limit", '"-1 N"', POSITIVE, ""),
    ("rail_drive.stiffness", '"0 N/m"', POSITIVE, ""),
    ("rail_drive.integral", '"-1 N/(m*s)"', "not negative", ""),
    ("rail_drive.damping", '"-1 N*s/m"', "not negative", ""),
    ("rail_drive.derivative_corner", '"0 Hz"', POSITIVE, ""),
    ("wall[2].stiffness", '"0 N/m"', POSITIVE, ""),
    ("wall[1].damping", '"-5 N*s/m"', "not negative", ""),
    ("target.force", '"0 N"', POSITIVE, ""),
    ("plant.handle_mass", '"0 kg"', POSITIVE, ""),
    ("plant.motor_coulomb_friction", '"-1 mN*m"', "not negative", ""),
    ("plant.carriage_mass", '"-1 kg"', POSITIVE, ""),
    ("plant.hand_stiffness", '"-1 N/m"', "not negative", ""),
    # words
    ("machine.name", '"Yoon2023"', NAME, ""),
    ("machine.name", '"2023"', NAME, ""),
    ("machine.name", '"a-b"', NAME, ""),
    ("machine.name", '""', NAME, ""),
    ("machine.name", '"../x"', NAME, ""),
    ("machine.name", '"é"', NAME, ""),
    ("machine.name", '"a2345678901234567890123456789012"', NAME, ""),
    ("machine.name", '"while"', "a name that is no keyword of C", ""),
    ("machine.name", "7", "text in quotes", ""),
    ("machine.kind", '"planar-pint"', "spatial-rigid; did you mean planar-point?", ""),
    ("machine.kind", '"x"', "the kinds planar-point", ""),
    ("machine.source", '"x */ y"', "one printable line", ""),
    ("machine.source", '"a\\nb"', "one printable line", ""),
    ("machine.source", '"a\\\\"', "one printable line", ""),
    ("machine.source", '"a\\u2028b"', "one printable line", ""),
    ("machine.source", '""', "one printable line", ""),
    ("cable[2].drive", '"int"', "a name that is no keyword of C", ""),
    ("cable[2].drive", '"Right"', NAME, ""),
    ("wall[1].name", '"do"', "a name that is no keyword of C", ""),
    ("tension.when_infeasible", '"clip"', '"scale", "closest" or "paper"', ""),
    ("disturbance_observer.hand_force", '"guessed"', '"measured" or "unmeasured"', ""),
    # arrays
    ("cable[1].rail", '"x"', "a table", ""),
    ("frame.size", '"711.8 mm"', "an array of two or three lengths, such as", ""),
    ("frame.size", '["711.8 mm"]', "an array of two or three lengths, such as", ""),
    ("target.centre", '["1 mm", "1 mm", "1 mm"]', "an array of two, one entry an axis", ""),
    ("wall[1].point", "[]", "an array of two or three lengths", ""),
    ("wall[1].normal", "[0, 0]", "finite and not all zero, such as [-1, 0]", ""),
    ("wall[1].normal", "[1, 0, 0]", "an array of two, one entry an axis", ""),
    ("wall[1].normal", '["1 mm", "0"]', "two or three plain numbers", ""),
    ("wall[1].normal", '["nan", "0"]', "two or three plain numbers, finite", ""),
    ("wall[1].normal", "1", "two or three plain numbers", ""),
    ("wall[1].normal", "[true, 0]", "two or three plain numbers", ""),
    # between keys
    ("tension.min", '"10 N"', 'a force below tension.max = "10 N"', ""),
    ("tension.min", '"12 N"', 'a force below tension.max = "10 N"', ""),
    ("cable_motor.torque_limit", '"49.9 mN*m"', "tension.max times drum.radius = 50 mN*m", ""),
    ("cable[2].drive", '"cable_1"', "a name that differs from cable[1].drive", ""),
    ("wall[2].name", '"right"', "a name that differs from wall[1].name", ""),
    (
        "control.velocity_corner",
        '"500 Hz"',
        "a frequency below 500 Hz, so that the corner is below half",
        "",
    ),
    (
        "rail_drive.derivative_corner",
        '"0.6 kHz"',
        "a frequency below 500 Hz, so that the corner is below half",
        "",
    ),
    (
        "disturbance_observer.corner",
        '"500 Hz"',
        "a frequency below 500 Hz, so that the corner is below half",
        "",
    ),
]


@pytest.mark.parametrize(("key", "value", "allowed", "remark"), BAD_VALUES)
def test_a_bad_value_is_refused_with_key_found_and_allowed(
    tmp_path: Path, key: str, value: str, allowed: str, remark: str
) -> None:
    message = refusal(tmp_path, with_value(key, value))
    shown = "a huge number" if value.startswith("0x") else value
    assert message.startswith(f"{key}: found {shown}{remark}; allowed: ")
    assert allowed in message


# name of the case: text of the file, then key, found and allowed of the message
BAD_FILES = {
    "an unknown key and the one that was meant": (
        changed((RADIUS, 'radios = "5 mm"')),
        ("drum.radios", "an unknown key", "the keys radius; did you mean radius? (and 1 more"),
    ),
    "an unknown key like no other": (
        changed((RADIUS, RADIUS + "\nzz = 1")),
        ("drum.zz", "an unknown key", "the keys radius"),
    ),
    "an unknown key in a rail": (
        changed((RAIL_2, RAIL_2.replace("to =", "too ="))),
        (
            "cable[2].rail.too",
            "an unknown key",
            "follows, heading; did you mean to?",
        ),
    ),
    "an unknown table": (
        changed(("[drum]", "[drumm]")),
        ("drumm", "an unknown key", "did you mean drum?"),
    ),
    "an unknown key that is no bare word": (
        changed((RADIUS, RADIUS + '\n"a\\nb c" = 1')),
        ('drum."a\\nb c"', "an unknown key", "the keys radius"),
    ),
    "a missing quantity": (
        changed((RADIUS, "")),
        ("drum.radius", "nothing", "radius r_p [m], a length with its unit, greater than zero"),
    ),
    "a missing choice": (
        changed(('when_infeasible = "scale"', "")),
        ("tension.when_infeasible", "nothing", "scale (same direction, smaller), closest"),
    ),
    "a missing end of a rail": (
        changed((RAIL_3, 'rail = { from = ["0 mm", "461.8 mm"] }')),
        ("cable[3].rail.to", "nothing", "where the rail ends, one length an axis"),
    ),
    "a missing table": (
        without("[drum]"),
        ("drum", "nothing", "the table [drum]"),
    ),
    "a value for a table": (
        "drum = 5\n" + without("[drum]"),
        ("drum", "5", "a table"),
    ),
    "one table for an array of tables": (
        changed(("[[wall]]", "[wall]"), text=without("[[wall]]")),
        ("wall", "a table", "an array of tables, each begun by [[wall]]"),
    ),
    "a wrong entry of a pair": (
        changed((RAIL_2, RAIL_2.replace('"461.8 mm"', '"461.8 s"'))),
        ("cable[2].rail.to[2]", '"461.8 s", a time', "a length with its unit"),
    ),
    "a frame without height": (
        changed(('"461.8 mm"]', '"0 mm"]')),
        ("frame.size[2]", '"0 mm"', "greater than zero"),
    ),
    "a target of negative width": (
        changed(('size = ["506 mm"', 'size = ["-506 mm"')),
        ("target.size[1]", '"-506 mm"', "greater than zero"),
    ),
    "too few cables": (
        without("[[cable]]", without("[[cable]]")),
        ("cable", "2 cables", "3 to 16 cables for the kind planar-point"),
    ),
    "too many cables": (
        changed(("\n[tension]", CABLE * 13 + "\n[tension]")),
        ("cable", "17 cables", "3 to 16 cables for the kind planar-point"),
    ),
    "too many walls": (
        changed(("\n[target]", "".join(map(WALL.format, range(15))) + "\n[target]")),
        ("wall", "17 walls", "0 to 16 walls"),
    ),
    "neither base nor rail": (
        changed((RAIL_2, "")),
        ("cable[2]", "neither base nor rail nor plane", "one of base, rail and plane"),
    ),
    "both base and rail": (
        changed((RAIL_2, RAIL_2 + '\nbase = ["0 mm", "0 mm"]')),
        ("cable[2]", "both base and rail", "one of base, rail and plane"),
    ),
    "a base outside the frame": (
        changed((RAIL_2, 'base = ["711.9 mm", "0 mm"]')),
        ("cable[2].base", '["711.9 mm", "0 mm"]', f"a point inside the frame, {FRAME}"),
    ),
    "a rail that leaves the frame": (
        changed((RAIL_4, RAIL_4.replace('"461.8 mm"', '"461.9 mm"'))),
        ("cable[4].rail.to", '["0 mm", "461.9 mm"]', f"a point inside the frame, {FRAME}"),
    ),
    "a rail that begins outside the frame": (
        changed((RAIL_4, RAIL_4.replace('["0 mm", "0 mm"]', '["-1 mm", "0 mm"]'))),
        ("cable[4].rail.from", '["-1 mm", "0 mm"]', f"a point inside the frame, {FRAME}"),
    ),
    "a rail without length": (
        changed((RAIL_4, RAIL_4.replace('"461.8 mm"', '"0 m"'))),
        ("cable[4].rail.to", '["0 mm", "0 m"]', "an end other than the rail's from"),
    ),
    "a default drive name that is taken": (
        changed((f'{RAIL_3}\ndrive = "cable_3"', RAIL_3), ('"cable_1"', '"cable_3"')),
        ("cable[3].drive", '"cable_3"', "a name that differs from cable[1].drive"),
    ),
    "all bases at one point": (
        changed(*ALL_IN_ONE_CORNER, text=without("[rail_drive]")),
        (
            "cable",
            "4 cables, parallel wherever in the target the platform is",
            "bases whose cables pull in 2 independent directions",
        ),
    ),
    "rails without a drive": (
        without("[rail_drive]"),
        ("rail_drive", "nothing", "a table, because of cable[1].rail"),
    ),
    "a rail drive without rails": (
        changed(*ALL_IN_ONE_CORNER),
        ("rail_drive", "a table", "no such table, because no cable has a rail"),
    ),
    "rails at the top and bottom only": (
        changed((RAIL_2, RAIL_1), (RAIL_4, RAIL_3)),
        (
            "cable",
            "4 cables, parallel wherever in the target the platform is",
            "bases whose cables pull in 2 independent directions",
        ),
    ),
    "a target that sticks out": (
        changed(('centre = ["355.9 mm"', 'centre = ["252.9 mm"')),
        (
            "target.centre",
            '["252.9 mm", "230.9 mm"] of size ["506 mm", "284 mm"]',
            f"a target inside the frame, {FRAME}",
        ),
    ),
    "no torque left for the observer": (
        with_value("cable_motor.torque_limit", '"50 mN*m"'),
        ("cable_motor.torque_limit", '"50 mN*m"', "more than tension.max times drum.radius"),
    ),
    "a carriage without a mass": (
        changed((CARRIAGE_MASS, "")),
        ("plant.carriage_mass", "nothing", "because of cable[1].rail"),
    ),
    "both readings of the observer's cut-off": (
        changed((CORNER, CORNER + '\nminus_3db = "5 Hz"')),
        ("disturbance_observer", "both corner and minus_3db", "either corner or minus_3db"),
    ),
    "no reading of the observer's cut-off": (
        changed((CORNER, "")),
        ("disturbance_observer", "neither corner nor minus_3db", "either corner or minus_3db"),
    ),
    "a -3 dB frequency whose poles are too fast": (
        changed((CORNER, 'minus_3db = "322 Hz"')),
        ("disturbance_observer.minus_3db", '"322 Hz"', "a frequency below 321.8 Hz, so that"),
    ),
}


@pytest.mark.parametrize(("text", "message"), BAD_FILES.values(), ids=BAD_FILES.keys())
def test_a_bad_file_is_refused_with_key_found_and_allowed(
    tmp_path: Path, text: str, message: tuple[str, str, str]
) -> None:
    key, found, allowed = message
    words = refusal(tmp_path, text)
    assert words.startswith(f"{key}: found {found}")
    assert allowed in words.partition("; allowed: ")[2]


def test_the_first_of_several_problems_is_shown_and_the_rest_counted(tmp_path: Path) -> None:
    text = changed((RADIUS, 'radius = "0 mm"'), ('min = "3 N"', 'min = "-3 N"'))
    assert refusal(tmp_path, text).endswith('such as "3 N" (and 1 more problem)')
    text = changed(('size = ["506 mm"', 'size = ["x"'), text=text)
    assert refusal(tmp_path, text).endswith(
        'such as "3 N" (and 2 more problems; turnbuckle check lists all)'
    )


def test_a_long_key_is_shortened(tmp_path: Path) -> None:
    message = refusal(tmp_path, changed((RADIUS, "a" * 5000 + " = 1")))
    assert message.startswith('drum."' + "a" * 50)
    assert len(message) < 300


def test_a_long_value_is_shortened(tmp_path: Path) -> None:
    message = refusal(tmp_path, with_value("machine.name", '"' + "a" * 5000 + '"'))
    assert '"' + "a" * 50 in message
    assert len(message) < 300


@pytest.mark.parametrize(
    ("content", "found"),
    [
        (b"[machine\n", "a mistake in the TOML: "),
        (b"[machine]\nname = yoon", "(at line 2, column 8)"),
        (b"[drum]\nx = 1\nx = 2\n", "(at line 3, column 6)"),
        (b"name = '\xff'", "a byte that is no UTF-8 at offset 8"),
        (b"x = " + b"9" * 5000, "a number too long"),
        (b"x = " + b"[" * 5000, "arrays nested too deep"),
    ],
)
def test_a_file_that_is_no_toml_is_refused(tmp_path: Path, content: bytes, found: str) -> None:
    path = tmp_path / "bad.toml"
    path.write_bytes(content)
    with pytest.raises(MachineError) as caught:
        load_machine(path)
    message = str(caught.value)
    assert message.startswith(f"{path}: found ")
    assert found in message
    assert message.endswith("; allowed: a readable machine file, TOML in UTF-8")


def test_an_empty_file_is_refused_with_the_first_missing_table(tmp_path: Path) -> None:
    assert refusal(tmp_path, "").startswith("machine: found nothing, it is missing; allowed: ")


OR_STOCK = f", or a stock machine: {', '.join(sorted(p.stem for p in MACHINES.glob('*.toml')))}"


@pytest.mark.parametrize(
    ("name", "found"),
    [
        ("absent.toml", "no such file"),
        (".", "a directory"),
        ("file/x.toml", "a file that cannot be read (Not a directory)"),
        ("x" * 300, "a file that cannot be read (File name too long)"),
        ("a\0b", "a name that no file can have"),
    ],
)
def test_a_path_that_leads_to_no_file_is_refused(tmp_path: Path, name: str, found: str) -> None:
    (tmp_path / "file").write_text("")
    path = tmp_path / name
    with pytest.raises(MachineError) as caught:
        load_machine(path)
    allowed = "allowed: a readable machine file, TOML in UTF-8"
    assert str(caught.value).removesuffix(OR_STOCK) == f"{path}: found {found}; {allowed}"


def test_a_file_without_permission_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(self: Path) -> bytes:
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))

    monkeypatch.setattr(Path, "read_bytes", refuse)
    with pytest.raises(MachineError, match=r"cannot be read \(Permission denied\); allowed: "):
        load_machine(tmp_path / "secret.toml")


# what a machine file may well say: edits of the stock file that are accepted
GOOD_FILES = {
    "no smallest tension": with_value("tension.min", '"0 N"'),
    "the exact torque that is needed": without(
        "[disturbance_observer]", with_value("cable_motor.torque_limit", '"50 mN*m"')
    ),
    "a frictionless nominal motor": with_value("cable_motor.damping", '"0 g*m^2/s"'),
    "a target as large as the frame": changed(
        ('size = ["506 mm", "284 mm"]', 'size = ["711.8 mm", "461.8 mm"]')
    ),
    "no walls, observer or plant": without(
        "[plant]",
        without("[disturbance_observer]", without("[[wall]]", without("[[wall]]"))),
    ),
    "three cables": without("[[cable]]", without_buses(TEXT)),
    "sixteen cables": changed(
        ("\n[tension]", CABLE * 12 + "\n[tension]"), text=without_buses(TEXT)
    ),
    "sixteen walls": changed(("\n[target]", "".join(map(WALL.format, range(14))) + "\n[target]")),
    "a corner just below half the rate": with_value("control.velocity_corner", '"499 Hz"'),
    "the longest name": with_value("machine.name", '"a234567890123456789012345678901"'),
}


@pytest.mark.parametrize("text", GOOD_FILES.values(), ids=GOOD_FILES.keys())
def test_what_is_just_allowed_is_accepted(tmp_path: Path, text: str) -> None:
    path = tmp_path / "good.toml"
    path.write_text(text, encoding="utf-8")
    assert load_machine(path).path == path


AS_IN_DATA_SHEETS = changed(
    ("55 mN*m", "55 mNm"),
    ("21 g*cm^2", "21 gcm2"),
    ("0.05 g*m^2/s", "0,05 g·m²·s⁻¹"),
    ("28 mN*m/A", "28 mNm/A"),
    ("711.8 mm", "711,8 mm"),
)


@pytest.mark.parametrize(
    "content",
    [AS_IN_DATA_SHEETS.encode(), TEXT.encode("utf-8-sig"), TEXT.replace("\n", "\r\n").encode()],
    ids=["spellings of data sheets", "a byte order mark", "lines of Windows"],
)
def test_other_spellings_describe_the_same_machine(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "machine.toml"
    path.write_bytes(content)
    assert load_machine(path).model_dump() == load_machine(STOCK).model_dump()
