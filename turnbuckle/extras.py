"""Extras of the package: what only some commands need, installed as turnbuckle[NAME]."""

import re
from importlib.metadata import requires

#: Packages whose import has another name than their distribution.
DISTRIBUTIONS = {"can": "python-can"}


def extra_of(module: str) -> str | None:
    """The extra that a module comes with; None for one of the base, or of nobody."""
    package = module.partition(".")[0]
    wanted = DISTRIBUTIONS.get(package, package)
    for requirement in requires("turnbuckle") or ():
        found = re.fullmatch(r"([\w.-]+).*extra == ['\"](\w+)['\"]", requirement)
        if found and found[1] == wanted:
            return found[2]
    return None
