#!/usr/bin/env bash
# Frames logged late are moved: to the start of the log by BLF, to the year 2077 by ASC.
#
# Package   python-can 4.6.1, the writers and readers of CSV, SQLite, candump, BLF and ASC.
# Input     Two buses recorded by one logger. The slower one's frames arrive last, with time
#           stamps 2 s and 1 s before the first frame of the other (a driver's backlog).
# Expected  The times survive, as they do in CSV and SQLite; or the late frame is refused.
# Seen      BLF and candump give both late frames one time, that of the log's start: the two
#           seconds and the order of the frames are lost. ASC writes their absolute time in the
#           column of the times since the start: read back, they come almost 54 years after the
#           first frame.
# Documents The pages name no demand on the order of the frames given to a logger.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python3 -m venv "$work/venv"
"$work/venv/bin/pip" install --quiet --disable-pip-version-check python-can==4.6.1

cd "$work"
venv/bin/python - <<'PYTHON'
import can

START = 1_700_000_000.1234
YEAR = 365.25 * 86400


def times(suffix, **options):
    """The times [s] from the first frame's, of three frames that a log gives back."""
    path = "log" + suffix
    with can.Logger(path) as log:
        for number, delay in enumerate((0.0, -2.0, -1.0)):
            log(can.Message(timestamp=START + delay, arbitration_id=number, data=[1], channel=0))
    with can.LogReader(path, **options) as log:
        found = {frame.arbitration_id: round(frame.timestamp - START, 3) for frame in log}
    print(suffix, "written 0, -2 and -1 s, read", [found[number] for number in range(3)])
    return found


print("python-can", can.__version__)
for suffix in (".csv", ".db"):
    if times(suffix) != {0: 0.0, 1: -2.0, 2: -1.0}:
        raise SystemExit("The other formats are not read as they were.")

blf, candump, asc = times(".blf"), times(".log"), times(".asc", relative_timestamp=False)
late = {name: (found[1], found[2]) for name, found in (("blf", blf), ("log", candump))}
ahead = [round(asc[number] / YEAR) for number in (1, 2)]
print("years ahead in the ASC log:", ahead)
if any(abs(time) > 0.001 for pair in late.values() for time in pair) or ahead != [54, 54]:
    raise SystemExit("The behaviour has changed.")
PYTHON
