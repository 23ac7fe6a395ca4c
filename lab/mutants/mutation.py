"""Every small defect that can be made of a C file."""

import re
from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

from turnbuckle.lab.mutants.tokens import Token, arguments, closing, tokens_of

Tokens = list[Token]

#: Operators and what is written in their place.
OPERATORS = {
    "<": ("<=", ">"),
    "<=": ("<", ">="),
    ">": (">=", "<"),
    ">=": (">", "<="),
    "==": ("!=",),
    "!=": ("==",),
    "+": ("-",),
    "-": ("+",),
    "*": ("/",),
    "/": ("*",),
    "%": ("/",),
    "+=": ("-=",),
    "-=": ("+=",),
    "*=": ("/=",),
    "&&": ("||",),
    "||": ("&&",),
    "&": ("|",),
    "|": ("&",),
    "|=": ("=", "&="),
    "&=": ("=",),
    "<<": (">>",),
    ">>": ("<<",),
    "true": ("false",),
    "false": ("true",),
}
#: An enumerator gives way to another one of its family that the file names.
FAMILY = re.compile(r"TB_(?:STATE|PHASE|CAUSE|POWER|GOAL|MODE|HOMING|TASK|FAILURE|PERMIT)_")
#: Words that begin no statement which could be left out.
KEYWORDS = frozenset(
    [
        *("if", "else", "for", "while", "do", "switch", "case", "default", "return", "break"),
        *("continue", "goto", "typedef", "enum", "static", "const", "struct", "extern"),
    ]
)
#: A definition begins at the beginning of a line.
FUNCTION = re.compile(r"^[A-Za-z][\w *]*?(\w+)\(", re.MULTILINE)
#: What follows the first word of a statement that does something.
ACTS = frozenset(["=", "+=", "-=", "*=", "|=", "&=", "++", "--", "(", "[", "->", "."])
#: Functions for which the order of their arguments is none.
COMMUTATIVE = frozenset(["tb_min", "tb_max"])


class Mutation(NamedTuple):
    """One change of a C file."""

    file: str
    """Within runtime/."""
    line: int
    start: int
    old: str
    new: str

    def of(self, source: str) -> str:
        """The source with the change."""
        return source[: self.start] + self.new + source[self.start + len(self.old) :]

    def place_in(self, source: str) -> str:
        """The function and the line that is changed, whatever lines come before."""
        functions = FUNCTION.findall(source[: self.start])
        line = source.splitlines()[self.line - 1].strip()
        return f"{functions[-1]}: {line}" if functions else line

    @property
    def words(self) -> str:
        """What was changed into what."""
        old, new = (" ".join(text.split()) for text in (self.old, self.new))
        return f"`{old}` → `{new}`" if new else f"without `{old}`"


def mutations(file: str, source: str) -> list[Mutation]:
    """All changes of a file that we make, in the order of their places."""
    tokens = tokens_of(source)
    found = {
        Mutation(file, source.count("\n", 0, start) + 1, start, source[start:end], new)
        for changes in (replaced, negated, left_out, swapped, exchanged)
        for start, end, new in changes(source, tokens)
        if source[start:end] != new
    }
    return sorted(found, key=lambda change: (change.start, change.old, change.new))


Changes = Iterator[tuple[int, int, str]]


def replaced(source: str, tokens: Tokens) -> Changes:
    """Other operators, constants one more and one less, other enumerators."""
    named = sorted({token.text for token in tokens if FAMILY.match(token.text)})
    for token in tokens:
        for new in alternatives(token, named):
            yield token.start, token.end, new


def alternatives(token: Token, named: list[str]) -> list[str]:
    """What can stand in the place of one token."""
    if token.kind == "number":
        return neighbours(token.text)
    if family := FAMILY.match(token.text):
        kin = [name for name in named if name.startswith(family.group())]
        return [kin[(kin.index(token.text) + 1) % len(kin)]]
    return list(OPERATORS.get(token.text, ()))


def neighbours(number: str) -> list[str]:
    """A constant one more and one less, not below zero."""
    digits = number.rstrip("uUlL")
    suffix = number[len(digits) :]
    if digits.lower().startswith("0x"):
        value, width = int(digits, 16), len(digits) - 2
        return [f"0x{near:0{width}X}{suffix}" for near in (value + 1, value - 1) if near >= 0]
    if digits.isdigit():
        return [f"{near}{suffix}" for near in (int(digits) + 1, int(digits) - 1) if near >= 0]
    return [repr(near) for near in (float(digits) + 1, float(digits) - 1) if near >= 0]


def negated(source: str, tokens: Tokens) -> Changes:
    """Conditions turned round."""
    for number, token in enumerate(tokens[:-1]):
        if token.text in ("if", "while"):
            start, end = tokens[number + 1].start, tokens[closing(tokens, number + 1)].end
            yield start, end, f"(!{source[start:end]})"
        elif token.text == "!":
            yield token.start, token.end, ""


def left_out(source: str, tokens: Tokens) -> Changes:
    """Without a statement: an assignment or a call."""
    for number in range(1, len(tokens) - 2):
        first, second = tokens[number : number + 2]
        begins = tokens[number - 1].text in "{};" and first.text not in KEYWORDS
        acts = first.text == "*" or second.text in ACTS
        if begins and first.kind != "directive" and acts:
            end = next(token.end for token in tokens[number:] if token.text == ";")
            if "{" not in source[first.start : end]:
                yield first.start, end, ""


def swapped(source: str, tokens: Tokens) -> Changes:
    """Two neighbouring arguments of a call in each other's place."""
    for number in range(2, len(tokens)):
        before, name, opening = tokens[number - 2 : number + 1]
        declares = before.kind == "word" and before.text not in KEYWORDS
        matters = name.kind == "word" and name.text not in COMMUTATIVE
        if opening.text == "(" and matters and not declares:
            given = arguments(tokens, number)
            for (start, middle), (again, end) in pairwise(given):
                first, second = source[start:middle].strip(), source[again:end].strip()
                yield start, end, f"{second}, {first}"


def exchanged(source: str, tokens: Tokens) -> Changes:
    """The two answers of a choice in each other's place, where they are simple."""
    simple = re.compile(r"\? ([^?:;{}]+?) : ((?:[^?:;{}(),]|\([^()]*\))+)")
    code = {token.start for token in tokens if token.text == "?"}
    for match in simple.finditer(source):
        if match.start() in code:
            yield match.start(), match.end(), f"? {match[2]} : {match[1]}"
