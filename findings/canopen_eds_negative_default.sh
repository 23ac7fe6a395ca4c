#!/usr/bin/env bash
# In one EDS entry -1000 is read twice as -1000 and once as 64536.
#
# Package   canopen 2.4.1 (Python), import_od() and LocalNode.
# Input     An EDS with a torque (0x6071, INTEGER16): DefaultValue, LowLimit and HighLimit in
#           hexadecimal two's complement, 0xFC18, 0xFC18 and 0x03E8.
# Expected  -1000, -1000 and 1000: the reader knows the notation, it converts the limits.
# Seen      The default is 64536, above the entry's own highest value. A node built from the file
#           answers a read of the object by an SDO abort (general error), since the default does
#           not fit the type. The same default in decimal, -1000, works.
# Documents The reader's handling of negative limits was mended after reports; the default was
#           not.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python3 -m venv "$work/venv"
"$work/venv/bin/pip" install --quiet --disable-pip-version-check canopen==2.4.1

cd "$work"
venv/bin/python - <<'PYTHON'
import logging
from importlib.metadata import version

import canopen

logging.disable()
EDS = """[FileInfo]
FileName=drive.eds
[DeviceInfo]
VendorName=none
[MandatoryObjects]
SupportedObjects=0
[OptionalObjects]
SupportedObjects=1
1=0x6071
[6071]
ParameterName=Target torque
ObjectType=0x7
DataType=0x0003
AccessType=rw
PDOMapping=1
DefaultValue={}
LowLimit=0xFC18
HighLimit=0x03E8
"""


def read(default):
    """The default and the limits in the dictionary, and what an SDO client reads of a new node."""
    open("drive.eds", "w").write(EDS.format(default))
    entry = canopen.import_od("drive.eds")[0x6071]
    drive, master = canopen.Network(), canopen.Network()
    drive.connect(interface="virtual", channel=default)
    master.connect(interface="virtual", channel=default)
    drive.create_node(5, "drive.eds")
    try:
        answer = master.add_node(5, "drive.eds").sdo[0x6071].raw
    except canopen.SdoAbortedError as error:
        answer = str(error)
    finally:
        drive.disconnect()
        master.disconnect()
    return (entry.default, entry.min, entry.max), answer


print("canopen", version("canopen"))
decimal, hexadecimal = read("-1000"), read("0xFC18")
print("decimal default:    ", decimal)
print("hexadecimal default:", hexadecimal)
if decimal != ((-1000, -1000, 1000), -1000):
    raise SystemExit("The decimal default is not read as it was.")
if hexadecimal[0] != (64536, -1000, 1000) or "0x08000000" not in hexadecimal[1]:
    raise SystemExit("The behaviour has changed.")
PYTHON
