"""The real machine, live: run its program, watch it, send it requests."""

from turnbuckle.model.refusal import Refusal


class LiveError(Refusal):
    """The machine cannot be run or watched."""


class NothingYetError(LiveError):
    """No program has written telemetry where it is looked for."""
