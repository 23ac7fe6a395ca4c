#!/usr/bin/env bash
# A position in single precision becomes a count of a thousand million.
#
# Package   canmatrix 1.3.3, a DBC database converted to SYM, to KCD and to DBF, and read again.
# Input     One 32-bit IEEE 754 signal (SIG_VALTYPE_ ... 1), as motor drives send positions.
# Expected  Every one of the three formats has a type for it ("float" in SYM), so 1.5 stays 1.5.
# Seen      KCD and DBF keep it. In SYM the signal is written as "signed", without a warning: the
#           frame of 1.5 is read as 1069547520. The reader knows SYM's float; the writer does not.
# Documents The documentation lists SYM as read and written, with no limit on the types of
#           signals.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python3 -m venv "$work/venv"
"$work/venv/bin/pip" install --quiet --disable-pip-version-check canmatrix==1.3.3 lxml==6.1.3

cd "$work"
venv/bin/python - <<'PYTHON'
import logging
import struct
import warnings
from importlib.metadata import version

warnings.simplefilter("ignore")
import canmatrix.formats as formats  # noqa: E402

logging.disable()
open("drive.dbc", "w").write(
    'VERSION ""\n\nBS_:\n\nBU_: A\n\n'
    'BO_ 385 Drive: 4 A\n SG_ Position : 0|32@1- (1,0) [0|0] "m" A\n\n'
    "SIG_VALTYPE_ 385 Position : 1;\n"
)
FRAME = struct.pack("<f", 1.5)


def position(path):
    """The position in the frame, as the database at the path reads it."""
    (database,) = formats.loadp(path).values()
    return float(database.frame_by_name("Drive").decode(FRAME)["Position"].phys_value)


print("canmatrix", version("canmatrix"))
positions = {"dbc": position("drive.dbc")}
for kind in ("kcd", "dbf", "sym"):
    formats.dumpp({"": formats.loadp_flat("drive.dbc")}, "drive." + kind)
    positions[kind] = position("drive." + kind)
print(positions)
(line,) = [line for line in open("drive.sym") if line.startswith("Var=")]
print("written to SYM:", line.strip())

open("float.sym", "w").write(open("drive.sym").read().replace("Position signed", "Position float"))
print("with the word changed by hand:", position("float.sym"))
if not positions["dbc"] == positions["kcd"] == positions["dbf"] == position("float.sym") == 1.5:
    raise SystemExit("The other formats are not read as they were.")
if positions["sym"] != 1069547520.0:
    raise SystemExit("The behaviour has changed.")
PYTHON
