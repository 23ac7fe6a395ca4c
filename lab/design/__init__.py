"""Design search: which values of a machine file's keys make the best machine."""


class DesignError(Exception):
    """A search or study cannot be done; str() is the whole message, for the user to read."""
