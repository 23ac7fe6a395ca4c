"""The tokens of a C file that are code: no comments, inclusions, conditions of the
preprocessor or static assertions."""

import re
from typing import NamedTuple

_KINDS = re.compile(
    r"""(?P<aside>/\*.*?\*/|//[^\n]*|\#\s*(?:include|if|el|endif)[^\n]*|_Static_assert\b[^;]*;|\s+)
      | (?P<text>"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*')
      | (?P<directive>\#\s*\w+)
      | (?P<number>(?:0[xX][0-9a-fA-F]+|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)[uUlLfF]*)
      | (?P<word>[A-Za-z_]\w*)
      | (?P<mark><<=|>>=|->|\+\+|--|<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|.)""",
    re.DOTALL | re.VERBOSE,
)
_PAIRS = {"(": ")", "[": "]", "{": "}"}


class Token(NamedTuple):
    """A piece of code, and where it begins."""

    kind: str
    """text, directive, number, word or mark."""
    text: str
    start: int

    @property
    def end(self) -> int:
        """Where what follows begins."""
        return self.start + len(self.text)


def tokens_of(source: str) -> list[Token]:
    """The tokens of a C file, in order."""
    found = ((match.lastgroup or "", match) for match in _KINDS.finditer(source))
    return [Token(kind, match.group(), match.start()) for kind, match in found if kind != "aside"]


def closing(tokens: list[Token], opening: int) -> int:
    """Number of the bracket that closes the one with number `opening`."""
    left, right = tokens[opening].text, _PAIRS[tokens[opening].text]
    depth = 0
    for number in range(opening, len(tokens)):
        depth += (tokens[number].text == left) - (tokens[number].text == right)
        if depth == 0:
            return number
    raise ValueError(f"{left!r} at {tokens[opening].start} is never closed")


def arguments(tokens: list[Token], opening: int) -> list[tuple[int, int]]:
    """What is between the commas within a pair of brackets: (start, end) in the source each."""
    last, depth = closing(tokens, opening), 0
    edges = [tokens[opening].end]
    for token in tokens[opening + 1 : last]:
        depth += (token.text in _PAIRS) - (token.text in _PAIRS.values())
        if token.text == "," and depth == 0:
            edges += [token.start, token.end]
    edges.append(tokens[last].start)
    return list(zip(edges[::2], edges[1::2], strict=True))
