"""The machine's program on a board without an operating system: written into its flash."""

from turnbuckle.model.refusal import Refusal


class BoardError(Refusal):
    """The program cannot be brought to the board; the text says why, and what mends it."""
