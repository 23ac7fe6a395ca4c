"""Formulas of the site as MathML, which browsers show by themselves: no script, nothing fetched."""

import html
import re
from typing import Any

from latex2mathml.converter import convert
from mkdocs.exceptions import PluginError

MARKED = re.compile(
    r'<(?P<tag>span|div) class="arithmatex">\\[(\[](?P<tex>.*?)\\[)\]]</(?P=tag)>', re.DOTALL
)

#: What the conversion leaves of a command that it does not know.
UNKNOWN = re.compile(r"<m\w+>(?P<word>&|&#x00026;|\\\w*)</m")


def on_page_content(content: str, **_: Any) -> str:
    """What mkdocs calls for every page: its HTML with each formula converted."""
    return MARKED.sub(formula, content)


def formula(match: re.Match[str]) -> str:
    """One formula, in the line or in a paragraph of its own that scrolls where it is too wide."""
    tex = html.unescape(match["tex"]).strip()
    display = match["tag"] == "div"
    shown = str(convert(tex, display="block" if display else "inline"))
    if unknown := UNKNOWN.search(shown):
        raise PluginError(f"{unknown['word']} has no MathML here: {tex}")
    shown = re.sub(r'columnalign="(\w+)"', r'style="text-align: \1"', shown)  # what browsers obey
    return f'<div class="formula">{shown}</div>' if display else shown
