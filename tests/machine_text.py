"""Texts of machine files, changed."""

import re


def without_buses(text: str) -> str:
    """The machine file less its buses and their drives."""
    return re.sub(r"^\[\[(?:bus|drive)\]\].*\n(?:[a-z_]+ = .*\n)*\n?", "", text, flags=re.MULTILINE)
