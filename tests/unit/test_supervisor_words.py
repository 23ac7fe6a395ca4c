"""States, phases and causes in words."""

import ctypes
from typing import Any

import pytest
import supervised
from safety_table import rows

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


def test_the_culprit_is_named_as_in_the_document() -> None:
    named = {row.cause: row.culprit for row in rows()}
    for cause in supervised.Cause:
        assert text("culprit", cause) == named.get(cause.name, "")


def test_a_cause_is_hard_where_the_document_says_so() -> None:
    is_hard = supervised.stock_library().tb_is_hard
    is_hard.restype = ctypes.c_bool
    found = {cause.name for cause in supervised.Cause if is_hard(cause)}
    assert found == {row.cause for row in rows() if row.hard}


def test_there_is_advice_for_every_cause_but_a_stop_that_was_asked_for() -> None:
    silent = {cause.name for cause in supervised.Cause if not text("advice", cause)}
    assert silent == {"NONE", "REQUESTED"}
