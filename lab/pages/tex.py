"""LaTeX of equations: decimal numbers, a line for every named quantity, brackets round matrices."""

from collections.abc import Iterable, Sequence

import sympy as sp

from turnbuckle.lab.pages.equations import Equation

#: Digits of a number on a page.
DIGITS = 10


def display(tex: str) -> str:
    """A formula in a paragraph of its own."""
    return f"$$\n{tex}\n$$"


def tex_of(equation: Equation) -> str:
    """One equation: a matrix by its name, or what its symbols stand for line by line."""
    rows = [[number(entry) for entry in row] for row in equation.value.tolist()]
    if equation.name:
        return rf"{equation.name} = {matrix(rows)}"
    names = [sp.latex(symbol) for symbol in equation.symbols]
    width = equation.value.cols
    lines = [
        rf"{group(names[i * width : (i + 1) * width])} & = & {group(row)}"
        for i, row in enumerate(rows)
    ]
    return "\n".join([r"\begin{array}{rcl}", " \\\\\n".join(lines), r"\end{array}"])


def matrix(rows: Iterable[Sequence[str]]) -> str:
    """Entries in square brackets."""
    body = " \\\\\n".join(" & ".join(row) for row in rows)
    return "\n".join([r"\begin{bmatrix}", body, r"\end{bmatrix}"])


def group(entries: Sequence[str]) -> str:
    """Several entries in parentheses, one as it is."""
    return entries[0] if len(entries) == 1 else rf"\left({', '.join(entries)}\right)"


def number(expression: sp.Expr) -> str:
    """An expression with its fractions as decimal numbers; halves stay."""
    return str(sp.latex(rounded(expression), full_prec=False))


def rounded(expression: sp.Expr) -> sp.Expr:
    """The expression with decimal numbers in place of fractions, but for exponents and halves."""
    if expression.is_Rational:
        return expression if expression.q <= 2 else sp.Float(expression, DIGITS)
    if not expression.args:
        return expression
    if expression.is_Pow:
        return sp.Pow(rounded(expression.base), expression.exp)
    return expression.func(*map(rounded, expression.args))
