"""The kinds of drives, by their names in machine files.

A new kind is a file beside epos4.py and a word in the line below: docs/adding-a-drive.md.
"""

from turnbuckle.model.bus.drive_kinds import epos4
from turnbuckle.model.bus.drive_kinds.kind import DriveKind


def by_name(*kinds: DriveKind) -> dict[str, DriveKind]:
    """Kinds by their names; ValueError where two have the same."""
    named = {kind.name: kind for kind in kinds}
    if len(named) < len(kinds):
        raise ValueError(f"two kinds of drives share a name: {', '.join(k.name for k in kinds)}")
    return named


DRIVE_KINDS: dict[str, DriveKind] = by_name(epos4.KIND)
DEFAULT = epos4.KIND.name
