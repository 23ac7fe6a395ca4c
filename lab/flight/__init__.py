"""The flight recorder's files: read them, run them again, turn them into tables and pictures."""


class FlightError(Exception):
    """A recording cannot be used; str() is the whole message, for the user to read."""
