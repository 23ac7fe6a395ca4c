"""The kinds of drives, by their names in machine files.

A new kind is a file beside epos4.py and a word in the line below: docs/adding-a-drive.md.
"""

from turnbuckle.model.bus.drive_kinds import epos4
from turnbuckle.model.bus.drive_kinds.kind import DriveKind

DRIVE_KINDS: dict[str, DriveKind] = {kind.name: kind for kind in (epos4.KIND,)}
DEFAULT = epos4.KIND.name
