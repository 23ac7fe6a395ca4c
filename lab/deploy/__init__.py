"""The machine's program on another computer: built for it, copied there, switched to at once."""

from turnbuckle.model.refusal import Refusal


class DeployError(Refusal):
    """The program cannot be brought to the host; the text says why, and what mends it."""
