#!/usr/bin/env bash
# An empty CAN FD frame comes back from an ASC log as a remote frame, which CAN FD has not.
#
# Package   python-can 4.6.1, ASCWriter and ASCReader.
# Input     A CAN FD frame without data: valid, and the shape of many requests and heartbeats.
# Expected  The same frame; an FD frame of one byte, and a classic frame without data, do come
#           back.
# Seen      is_remote_frame is True and is_fd is True, a combination that no bus can carry and
#           that Message itself refuses when its check is on. A log played again raises, or sends
#           another frame than the one recorded. BLF keeps the same frame.
# Documents ASC is listed as a format that holds CAN FD; no limit on the length is named.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python3 -m venv "$work/venv"
"$work/venv/bin/pip" install --quiet --disable-pip-version-check python-can==4.6.1

cd "$work"
venv/bin/python - <<'PYTHON'
import can


def copy(suffix, **fields):
    """The frame that a log of the suffix's format gives back."""
    path = "log" + suffix
    with can.Logger(path) as log:
        log(
            can.Message(
                timestamp=1.0, channel=0, arbitration_id=0x181, is_extended_id=False, **fields
            )
        )
    with can.LogReader(path) as log:
        (frame,) = log
    print(suffix, fields)
    print(f"  -> remote {frame.is_remote_frame}, FD {frame.is_fd}, {frame.dlc} byte")
    return frame


print("python-can", can.__version__)
same = [
    copy(".asc", is_fd=True, data=[7]),
    copy(".asc", is_fd=False, data=[]),
    copy(".blf", is_fd=True, data=[]),
]
frame = copy(".asc", is_fd=True, data=[])
try:
    can.Message(is_fd=frame.is_fd, is_remote_frame=frame.is_remote_frame, check=True)
    refusal = None
except ValueError as error:
    refusal = str(error)
print("Message, with its check on, says of the last:", refusal)

if any(other.is_remote_frame for other in same):
    raise SystemExit("The other frames are not read as they were.")
if not (frame.is_remote_frame and frame.is_fd and refusal):
    raise SystemExit("The behaviour has changed.")
PYTHON
