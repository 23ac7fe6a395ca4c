#!/usr/bin/env bash
# Encoder counts in a float64[] field are written as 5e-324 and 1e-323.
#
# Package   rosbags 0.11.9, serialisation of ROS 2 (CDR) and ROS 1 messages, with numpy 2.4.6.
# Input     JointState.position given as an array of int64, what numpy makes of whole numbers.
# Expected  1.0 and 2.0, as rosbags converts a single int into a float64 field; or an error, as
#           for an array of int32 or of float32.
# Seen      No error: the array's bytes are taken as they are, since the sizes of the items agree.
#           Counts become subnormal numbers, so a recorded robot stands still at zero.
# Documents Array fields are described as numpy arrays; what another dtype does is not said.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python3 -m venv "$work/venv"
"$work/venv/bin/pip" install --quiet --disable-pip-version-check rosbags==0.11.9 numpy==2.4.6

cd "$work"
venv/bin/python - <<'PYTHON'
from importlib.metadata import version

import numpy as np
from rosbags.typesys import Stores, get_typestore

COUNTS = [1, 2]


def position(store, protocol, counts):
    """JointState.position after serialisation and back, or the name of the error."""
    types = get_typestore(store)
    kinds = types.types
    stamp = kinds["builtin_interfaces/msg/Time"](sec=0, nanosec=0)
    sequence = {"seq": 0} if protocol == "ros1" else {}
    header = kinds["std_msgs/msg/Header"](stamp=stamp, frame_id="", **sequence)
    message = kinds["sensor_msgs/msg/JointState"](
        header=header, name=["a", "b"], position=counts, velocity=np.zeros(0), effort=np.zeros(0)
    )
    try:
        raw = getattr(types, "serialize_" + protocol)(message, message.__msgtype__)
    except ValueError as error:
        return type(error).__name__
    return getattr(types, "deserialize_" + protocol)(raw, message.__msgtype__).position.tolist()


print("rosbags", version("rosbags"))
for store, protocol in ((Stores.ROS2_JAZZY, "cdr"), (Stores.ROS1_NOETIC, "ros1")):
    arrays = {dtype: np.array(COUNTS, dtype) for dtype in ("f8", "f4", "i4", "i8")}
    read = {dtype: position(store, protocol, counts) for dtype, counts in arrays.items()}
    print(protocol, read)
    if read["f8"] != COUNTS or [read["f4"], read["i4"]] != ["ValueError"] * 2:
        raise SystemExit("The other arrays are not handled as they were.")
    if read["i8"] != np.array(COUNTS, "i8").view("f8").tolist():
        raise SystemExit("The behaviour has changed.")

types = get_typestore(Stores.ROS2_JAZZY)
point = types.types["geometry_msgs/msg/Point"](x=1, y=2, z=3)
raw = types.serialize_cdr(point, point.__msgtype__)
print("single ints:", types.deserialize_cdr(raw, point.__msgtype__))
PYTHON
