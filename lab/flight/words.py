"""The enumerations of the runtime's headers in words: the headers alone say which there are."""

import re
from functools import cache
from itertools import takewhile

from turnbuckle.lab.causes import causes
from turnbuckle.places import RUNTIME


@cache
def words(enumeration: str, header: str) -> tuple[str, ...]:
    """The words of an enumeration that counts from 0, as `soft stop` for TB_STATE_SOFT_STOP.

    header: its file under runtime/.
    """
    source = re.sub(r"/\*.*?\*/", "", (RUNTIME / header).read_text(), flags=re.DOTALL)
    found = re.search(rf"typedef enum \{{([^}}]*)\}} {enumeration};", source)
    if found is None:
        raise ValueError(f"{header}: no enumeration {enumeration}")
    names = [name.split("_") for name in re.findall(r"^\s*(\w+)", found[1], re.MULTILINE)]
    columns = zip(*names, strict=False)
    shared = sum(1 for _ in takewhile(lambda parts: len(set(parts)) == 1, columns))
    return tuple(" ".join(parts[shared:]).lower() for parts in names)


def cause_names() -> tuple[str, ...]:
    """The causes, as `cable break` for TB_CAUSE_CABLE_BREAK."""
    return tuple(cause.name.replace("_", " ").lower() for cause in causes())
