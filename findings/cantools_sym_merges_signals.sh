#!/usr/bin/env bash
# Two drives' signals of one name share one scale after a conversion to SYM.
#
# Package   cantools 45.1.0, a DBC database written as SYM 6.0 and read again.
# Input     Two messages, each with a signal "Velocity": 0.5 rad/s a bit in one, 1 rad/s a bit in
#           the other. In a DBC file a signal belongs to its message, so equal names are everyday.
# Expected  The same scales, since SYM can hold both signals, or an error that the names collide.
# Seen      One definition is written, the first message's; the second message refers to it. After
#           reading, the same four bytes mean half (or twice) the velocity, silently. Converting
#           the messages in the other order keeps the other scale.
# Documents The documentation lists SYM 6.0 as read and written, and names no such limit.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python3 -m venv "$work/venv"
"$work/venv/bin/pip" install --quiet --disable-pip-version-check cantools==45.1.0

cd "$work"
venv/bin/python - <<'PYTHON'
import cantools

MESSAGES = {
    "Left": 'BO_ 385 Left: 4 A\n SG_ Velocity : 0|32@1- (1,0) [0|0] "rad/s" A\n\n',
    "Right": 'BO_ 386 Right: 4 A\n SG_ Velocity : 0|32@1- (0.5,0) [0|0] "rad/s" A\n\n',
}
FRAME = (100).to_bytes(4, "little")


def velocities(order):
    """The velocity in each message's frame, from the DBC database and from its SYM copy."""
    text = 'VERSION ""\n\nBS_:\n\nBU_: A\n\n' + "".join(MESSAGES[name] for name in order)
    database = cantools.database.load_string(text, "dbc")
    copy = cantools.database.load_string(database.as_sym_string(), "sym")
    decoded = [
        {name: source.decode_message(name, FRAME)["Velocity"] for name in sorted(order)}
        for source in (database, copy)
    ]
    print("order", order, "DBC", decoded[0], "SYM", decoded[1])
    return decoded


print("cantools", cantools.__version__)
first = velocities(("Left", "Right"))
second = velocities(("Right", "Left"))
if first[0] != {"Left": 100, "Right": 50.0} or second[0] != first[0]:
    raise SystemExit("The DBC database is not read as it was.")
if not (first[1] == {"Left": 100, "Right": 100} and second[1] == {"Left": 50.0, "Right": 50.0}):
    raise SystemExit("The behaviour has changed.")
PYTHON
