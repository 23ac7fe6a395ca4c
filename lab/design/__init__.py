"""Design search: which values of a machine file's keys make the best machine."""

from turnbuckle.model.refusal import Refusal


class DesignError(Refusal):
    """A search or study cannot be done."""
