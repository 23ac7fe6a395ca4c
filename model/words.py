"""Words of a machine file that reach the generated C: names and the source line."""

import re
from collections.abc import Iterable
from typing import Annotated

from pydantic import AfterValidator, Field

from turnbuckle.model.bus.drive_kinds import DRIVE_KINDS
from turnbuckle.model.kind import KINDS
from turnbuckle.model.problem import nearest, refusal

IDENTIFIER = "[a-z][a-z0-9_]*"
# C11 promises 31 significant characters of a name that other files see.
LONGEST_IDENTIFIER = 31
LONGEST_SOURCE = 200
C_KEYWORD = re.compile(
    "alignas|alignof|asm|auto|bool|break|case|char|const|constexpr|continue|default|do|"
    "double|else|enum|extern|false|float|for|goto|if|inline|int|long|nullptr|"
    "register|restrict|return|short|signed|sizeof|static|static_assert|struct|switch|"
    "thread_local|true|typedef|typeof|typeof_unqual|union|unsigned|void|volatile|while"
)


def _identifier(text: str) -> str:
    if C_KEYWORD.fullmatch(text):
        raise refusal("a name that is no keyword of C")
    if not re.fullmatch(IDENTIFIER, text) or len(text) > LONGEST_IDENTIFIER:
        raise refusal(
            f"a name of 1 to {LONGEST_IDENTIFIER} characters: a lower case letter,"
            " then lower case letters, digits and _"
        )
    return text


def _comment_line(text: str) -> str:
    closes_comment = any(mark in text for mark in ("*/", "/*", "\\", "??"))
    if closes_comment or not text.isprintable() or not 1 <= len(text) <= LONGEST_SOURCE:
        raise refusal(
            f"one printable line of 1 to {LONGEST_SOURCE} characters"
            " without */, /*, ?? and backslash (it goes into a C comment)"
        )
    return text


def _known_kind(text: str) -> str:
    return _one_of(KINDS, text)


def _known_drive_kind(text: str) -> str:
    return _one_of(DRIVE_KINDS, text)


def _one_of(kinds: Iterable[str], text: str) -> str:
    if text not in kinds:
        raise refusal(f"the kinds {', '.join(kinds)}{nearest(text, kinds)}")
    return text


Identifier = Annotated[
    str,
    AfterValidator(_identifier),
    Field(json_schema_extra={"pattern": f"^{IDENTIFIER}$", "maxLength": LONGEST_IDENTIFIER}),
]
CommentLine = Annotated[
    str,
    AfterValidator(_comment_line),
    Field(json_schema_extra={"minLength": 1, "maxLength": LONGEST_SOURCE}),
]
KindName = Annotated[
    str, AfterValidator(_known_kind), Field(json_schema_extra={"enum": sorted(KINDS)})
]
DriveKindName = Annotated[
    str,
    AfterValidator(_known_drive_kind),
    Field(json_schema_extra={"enum": sorted(DRIVE_KINDS)}),
]
