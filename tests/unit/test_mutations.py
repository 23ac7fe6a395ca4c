"""Changes of C for `make mutants`: in code only, and of every kind."""

import pytest

from turnbuckle.lab.mutants.draw import sources
from turnbuckle.lab.mutants.mutation import FUNCTION, mutations
from turnbuckle.lab.mutants.tokens import tokens_of

SOURCE = """
#include "x1.h" /* 1 < 2 */
#if defined(A) && (B == 2)
#define HALF (TB_C(0.5) * 2)
#elif C < 3
#endif
_Static_assert(sizeof(int) == 4, "a + b");
// 3 != 4
static int find(int a, int b)
{
    char const *const text = "1 + 1";
    if ((a < b) && !is_done(a, text)) {
        a += 0x0Fu;
        order(&a, TB_MODE_TORQUE);
        b = tb_max(a, b);
    }
    return a ? TB_MODE_POSITION : b;
}
"""
EXPECTED = {
    ("0.5", "1.5"),
    ("2", "1"),
    ("2", "3"),
    ("*", "/"),
    ("<", "<="),
    ("<", ">"),
    ("&&", "||"),
    ("!", ""),
    ("((a < b) && !is_done(a, text))", "(!((a < b) && !is_done(a, text)))"),
    ("a, text", "text, a"),
    ("+=", "-="),
    ("0x0Fu", "0x10u"),
    ("0x0Fu", "0x0Eu"),
    ("a += 0x0Fu;", ""),
    ("order(&a, TB_MODE_TORQUE);", ""),
    ("&a, TB_MODE_TORQUE", "TB_MODE_TORQUE, &a"),
    ("&", "|"),
    ("TB_MODE_TORQUE", "TB_MODE_POSITION"),
    ("TB_MODE_POSITION", "TB_MODE_TORQUE"),
    ("b = tb_max(a, b);", ""),
    ("? TB_MODE_POSITION : b", "? b : TB_MODE_POSITION"),
}


def test_every_change_of_a_small_file_is_made_and_no_other() -> None:
    made = {(change.old, change.new) for change in mutations("core/x.c", SOURCE)}
    assert made - {("*", "/")} == EXPECTED - {("*", "/")}
    assert ("*", "/") in made


def test_a_change_is_where_it_says_and_changes_nothing_else() -> None:
    for change in mutations("core/x.c", SOURCE):
        before, after = SOURCE[: change.start], SOURCE[change.start + len(change.old) :]
        assert before + change.old + after == SOURCE
        assert change.of(SOURCE) == before + change.new + after
        assert before.count("\n") + 1 == change.line


@pytest.mark.parametrize("file", sources())
def test_the_tokens_of_the_runtime_are_all_that_is_not_aside(file: str) -> None:
    source = sources()[file]
    texts = "".join(token.text for token in tokens_of(source))
    assert all(source[token.start : token.end] == token.text for token in tokens_of(source))
    assert "/*" not in texts and "_Static_assert" not in texts and "#include" not in texts
    if FUNCTION.search(source):
        assert len(mutations(file, source)) >= source.count("\n") / 2
