"""A machine's C under names of its own, so that several controllers go into one program.

`tb_` becomes `left_`, `TB_` becomes `LEFT_`, `real_t` becomes `left_real_t`, and file names follow.
The runtime takes its sizes from the generated headers, so a copy of the runtime goes along.
"""

import re
from collections.abc import Iterable
from pathlib import Path

from turnbuckle.model.machine import Machine
from turnbuckle.model.refusal import Refusal
from turnbuckle.places import RUNTIME

PLAIN = "tb"
"""What names begin with where nothing else is asked for."""
LONGEST = 16
#: No underscore inside: what follows it belongs to one prefix alone.
WORD = re.compile(r"[a-z][a-z0-9]+")
_KEYWORDS = """
    alignas alignof and asm auto bitand bitor bool break case catch char class compl complex
    concept const consteval constexpr constinit continue decltype default delete do double else enum
    explicit export extern false final float for friend goto if import inline int long module
    mutable namespace new noexcept not nullptr operator or override private protected public
    register requires restrict return short signed sizeof static struct switch template this throw
    true try typedef typeid typename union unsigned using virtual void volatile while xor
"""
_TAKEN = """
    aio argp atomic cmsg cnd dbl fanotify flt in6addr inet inotify int16 int32 int64 int8 intmax
    ldbl msg mtx posix sem si st svc tm uint16 uint32 uint64 uint8 uintmax
"""
KEYWORDS = frozenset(_KEYWORDS.split())
#: First words of names in the headers of C and POSIX that ours would become: FLT_EPSILON, INT8_C.
TAKEN = frozenset(_TAKEN.split())

#: What a machine without buses takes of the runtime: the controller step.
STEP = (
    *("core/runtime_version.h", "core/controller.h", "core/torque_gate.h"),
    *("core/controller.c", "core/torque_gate.c"),
)
PARTS = ("core", "canopen", "can")
#: What needs an operating system, in a folder of its own.
ON_LINUX = ("serial_line", "slcan", "slcan_lines", "slcan_opening", "socketcan")

TOKEN = re.compile(
    r'#include "(?P<header>[^"]+)"'
    r"|(?P<comment>/\*.*?\*/|//[^\n]*)"
    r'|(?P<text>"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])*\')'
    r"|(?P<word>[A-Za-z_]\w*)",
    re.DOTALL,
)


class PrefixError(Refusal):
    """A prefix cannot be used; the text says what is allowed."""


def refuse_prefix(prefix: str) -> None:
    """PrefixError for a prefix that is no word, or a word that C or we have taken."""
    is_word = WORD.fullmatch(prefix) and len(prefix) <= LONGEST
    if not is_word or prefix in KEYWORDS | TAKEN | {PLAIN}:
        raise PrefixError(
            f'--prefix: found "{prefix}"; allowed: 2 to {LONGEST} lower-case letters and digits,'
            " the first a letter; no keyword of C or C++, no beginning of the C library's names,"
            " not tb"
        )


def prefixed(files: dict[str, str], prefix: str) -> dict[str, str]:
    """The files with C under names that begin with the prefix; others as they are.

    Raises PrefixError where a new name is one that the C has already.
    """
    refuse_clash(files, prefix)
    sources = [name for name in files if is_c(name)]
    return {
        file_name(name, prefix) if is_c(name) else name: renamed(text, prefix, sources)
        if is_c(name)
        else text
        for name, text in files.items()
    }


def is_c(name: str) -> bool:
    """Whether a file holds C."""
    return name.endswith((".c", ".h"))


def runtime_files(machine: Machine, banner: str) -> dict[str, str]:
    """The runtime that the machine takes, by name, each file below the banner.

    A machine with buses takes all but the program for Linux, a machine without them the step.
    """
    if machine.buses:
        paths = [path for part in PARTS for path in sorted((RUNTIME / part).glob("*.[ch]"))]
    else:
        paths = [RUNTIME / name for name in STEP]
    return {place(path): f"{banner}\n{path.read_text()}" for path in paths}


def place(path: Path) -> str:
    """Where a file of the runtime goes."""
    return f"linux/{path.name}" if path.stem in ON_LINUX else path.name


def renamed(text: str, prefix: str, sources: Iterable[str]) -> str:
    """C with its names and those of the source files prefixed, in comments too; texts stay."""
    names = sorted({Path(name).name for name in sources}, key=len, reverse=True)
    mentioned = re.compile(rf"(?<![\w./])({'|'.join(map(re.escape, names))})\b")

    def replaced(token: re.Match[str]) -> str:
        if header := token["header"]:
            return f'#include "{file_name(header, prefix)}"'
        if comment := token["comment"]:
            filed = mentioned.sub(lambda name: file_name(name[1], prefix), comment)
            return re.sub(r"\w+", lambda word: new_name(word[0], prefix), filed)
        return token["text"] or new_name(token["word"], prefix)

    return TOKEN.sub(replaced, text)


def new_name(word: str, prefix: str) -> str:
    """What a name becomes; most stay as they are."""
    if word == "real_t":
        return f"{prefix}_real_t"
    if word.startswith("tb_"):
        return f"{prefix}_{word[3:]}"
    return f"{prefix.upper()}_{word[3:]}" if word.startswith("TB_") else word


def file_name(name: str, prefix: str) -> str:
    """What a file becomes; its folder stays."""
    path = Path(name)
    return str(path.with_name(f"{prefix}_{path.name.removeprefix('tb_')}"))


def refuse_clash(files: dict[str, str], prefix: str) -> None:
    """PrefixError where a name would become one that a file has already."""
    words = {
        token["word"]
        for name, text in files.items()
        if is_c(name)
        for token in TOKEN.finditer(text)
        if token["word"]
    }
    for word in sorted(words):
        if word != new_name(word, prefix) in words:
            raise PrefixError(
                f'--prefix: found "{prefix}"; allowed: a word with which no name becomes'
                f" {new_name(word, prefix)}, which the C has already"
            )
