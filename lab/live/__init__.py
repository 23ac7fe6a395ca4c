"""The real machine, live: run its program, watch it, send it requests."""


class LiveError(Exception):
    """The machine cannot be run or watched; str() is the whole message, for the user to read."""
