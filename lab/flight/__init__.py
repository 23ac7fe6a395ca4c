"""The flight recorder's files: read them, run them again, turn them into tables and pictures."""

from turnbuckle.model.refusal import Refusal


class FlightError(Refusal):
    """A recording cannot be used."""
