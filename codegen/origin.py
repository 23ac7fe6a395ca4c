"""How generated files say which machine file they are from."""

import re
import shlex

from turnbuckle.model.machine import Machine
from turnbuckle.places import MACHINES

#: What neither a comment of C nor a text of a DBC can hold.
UNPRINTABLE = re.compile(r'\*/|/\*|["\\]|[^ -~\xa1-\U0010ffff]')


def command(machine: Machine) -> str:
    """The command that generates the machine's C again: with the path that the user gave.

    A stock machine is in machines/ wherever that is. Of another absolute path only the file's name
    is told, and of one that cannot be printed the machine's: the C depends on no user's folders.
    """
    path = machine.path
    if path.is_absolute():
        stock = path.parent.resolve() == MACHINES.resolve()
        text = f"machines/{path.name}" if stock else path.name
    else:
        text = path.as_posix()
    if UNPRINTABLE.search(text):
        text = f"{machine.name}.toml"
    return f"turnbuckle generate {shlex.quote(text)}"
