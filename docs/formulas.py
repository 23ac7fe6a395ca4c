"""Formulas of the site as MathML, which browsers show by themselves: no script, nothing fetched."""

import html
import re
from typing import Any

from latex2mathml.converter import convert

MARKED = re.compile(
    r'<(?P<tag>span|div) class="arithmatex">\\[(\[](?P<tex>.*?)\\[)\]]</(?P=tag)>', re.DOTALL
)


def on_page_content(content: str, **_: Any) -> str:
    """What mkdocs calls for every page: its HTML with each formula converted."""
    return MARKED.sub(formula, content)


def formula(match: re.Match[str]) -> str:
    """One formula, in the line or in a paragraph of its own that scrolls where it is too wide."""
    tex = html.unescape(match["tex"]).strip()
    if match["tag"] == "span":
        return str(convert(tex))
    return f'<div style="overflow-x: auto">{convert(tex, display="block")}</div>'
