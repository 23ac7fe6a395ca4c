"""An independent observer of the wire, written from docs/safety.md; it knows nothing of the
supervisor but what the document promises."""

from observer.observer import Observer
from observer.promises import Promise

__all__ = ["Observer", "Promise"]
