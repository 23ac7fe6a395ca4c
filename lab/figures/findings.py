"""What a figure or table of a paper says, what comes out here, and why they differ."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Finding:
    """One row of the table in docs/figures.md; plain text."""

    figure: str
    quantity: str
    published: str
    reproduced: str
    why: str = "they agree"


@dataclass(frozen=True)
class Drawn:
    """A picture in docs/figures: file name, caption, and what was read off it."""

    file: str
    caption: str
    findings: tuple[Finding, ...]
