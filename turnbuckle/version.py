"""The version of Turnbuckle; its home is pyproject.toml."""

import re
from importlib.metadata import version

VERSION = version("turnbuckle")


def version_number(text: str) -> int:
    """A version as one number that C can compare: 10000 major + 100 minor + patch.

    Raises ValueError for what is not three numbers, the last two below 100.
    """
    if not re.fullmatch(r"\d+(\.\d{1,2}){2}", text):
        raise ValueError(f"{text} is not major.minor.patch")
    major, minor, patch = map(int, text.split("."))
    return (major * 100 + minor) * 100 + patch
