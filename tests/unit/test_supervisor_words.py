"""States, phases and causes in words."""

import ctypes
from pathlib import Path
from typing import Any

import pytest
import supervised
from safety_table import DOCUMENT, rows

from turnbuckle.lab.causes import TABLE, causes, written

WORDS = {"state": supervised.State, "phase": supervised.Phase, "cause": supervised.Cause}


def text(name: str, number: int) -> str:
    """tb_<name>_text."""
    function = supervised.stock_library()[f"tb_{name}_text"]
    function.restype = ctypes.c_char_p
    return bytes(function(number)).decode()


@pytest.mark.parametrize("name", WORDS)
def test_every_number_has_words_of_its_own(name: str) -> None:
    numbers: Any = WORDS[name]
    texts = [text(name, number) for number in numbers]
    assert all(text for text in texts[1:])
    assert len(set(texts)) == len(texts)


@pytest.mark.parametrize("name", [*WORDS, "culprit", "advice"])
def test_a_number_that_is_none_is_unknown(name: str) -> None:
    assert text(name, 99) == "unknown"


def test_the_document_has_the_words_of_the_table() -> None:
    document = DOCUMENT.read_text()
    assert written(document) == document, "run: python -m turnbuckle.lab.causes"
    assert len(rows()) == len(causes()) - 1


def test_a_word_that_changes_in_one_of_them_is_found(tmp_path: Path) -> None:
    document, table = DOCUMENT.read_text(), tmp_path / "causes.h"
    table.write_text(TABLE.read_text().replace('"replace it"', '"replace that"'))
    assert written(document, table) != document


def test_the_c_has_the_words_of_the_table() -> None:
    for number, cause in enumerate(causes()):
        told = [text(name, number) for name in ("culprit", "cause", "advice")]
        assert told == [cause.culprit, cause.words, cause.advice]


def test_a_cause_is_hard_where_the_document_says_so() -> None:
    is_hard = supervised.stock_library().tb_is_hard
    is_hard.restype = ctypes.c_bool
    found = {cause.name for cause in supervised.Cause if is_hard(cause)}
    assert found == {row.cause for row in rows() if row.hard}
    assert not is_hard(len(supervised.Cause))


def test_there_is_advice_for_every_cause_but_a_stop_that_was_asked_for() -> None:
    silent = {cause.name for cause in supervised.Cause if not text("advice", cause)}
    assert silent == {"NONE", "REQUESTED"}
