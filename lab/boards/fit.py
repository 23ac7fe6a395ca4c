"""Whether a machine's image fits a board."""

from turnbuckle.lab.boards import BoardError
from turnbuckle.lab.boards.chip import Chip
from turnbuckle.lab.boards.record import Record
from turnbuckle.model.machine import Machine


def refuse_unfit(machine: Machine, chip: Chip, record: Record) -> None:
    """BoardError, with the numbers, for a machine whose image is too large for a board."""
    rows = (
        ("bus", len(machine.buses), chip.buses, "buses"),
        ("flash", record.length, chip.size, "bytes of flash"),
        ("memory", record.memory, chip.memory, "bytes of memory"),
    )
    for key, found, allowed, unit in rows:
        if found > allowed:
            raise BoardError(
                f"{machine.path}: {key}: found {found} {unit}; allowed: {allowed}, which the board"
                f" {chip.name} has; take a larger board, or make the machine smaller"
            )
