"""SymPy's C for a function of the model: float32, common subexpressions, its stock printer."""

from collections.abc import Callable
from typing import Any

import casadi as ca
import sympy
from sympy.codegen.ast import float32, real
from sympy.printing.c import C99CodePrinter

from turnbuckle.model.symbolic.function import ModelFunction

#: CasADi's operations in SymPy; a model function that needs another is refused by KeyError.
OPERATIONS: dict[int, Callable[..., Any]] = {
    ca.OP_ADD: lambda a, b: a + b,
    ca.OP_SUB: lambda a, b: a - b,
    ca.OP_MUL: lambda a, b: a * b,
    ca.OP_DIV: lambda a, b: a / b,
    ca.OP_NEG: lambda a: -a,
    ca.OP_SQ: lambda a: a**2,
    ca.OP_TWICE: lambda a: 2 * a,
    ca.OP_INV: lambda a: 1 / a,
    ca.OP_SQRT: sympy.sqrt,
}


class ProductPrinter(C99CodePrinter):  # type: ignore[misc]
    """The stock printer with the override that its users end up with: no powf for squares."""

    def _print_Pow(self, expr: Any) -> str:
        base, exponent = expr.as_base_exp()
        text = self.parenthesize(base, sympy.printing.precedence.PRECEDENCE["Atom"])
        if exponent.is_Integer and 0 < abs(exponent) <= 4:
            product = "*".join([text] * abs(int(exponent)))
            return f"({product})" if exponent > 0 else f"(1.0F/({product}))"
        if exponent == -sympy.Rational(1, 2):
            return f"(1.0F/sqrtf({self._print(base)}))"
        return str(super()._print_Pow(expr))


def stock_printer() -> C99CodePrinter:
    """SymPy's C99 printer for single precision."""
    return C99CodePrinter({"type_aliases": {real: float32}})


def product_printer() -> C99CodePrinter:
    """The same with powers as products."""
    return ProductPrinter({"type_aliases": {real: float32}})


def sympy_c(function: ModelFunction, printer: C99CodePrinter) -> str:
    """C of void <name>(const float in[], float out[])."""
    results = expressions(function)
    shared, reduced = sympy.cse(results, sympy.numbered_symbols("t"), order="none")
    lines = [f"  const float {name} = {printer.doprint(value)};" for name, value in shared]
    lines += [f"  out[{k}] = {printer.doprint(value)};" for k, value in enumerate(reduced)]
    body = "\n".join(lines)
    head = f"void {function.name}(const float in[], float out[])"
    return f"#include <math.h>\n{head};\n{head} {{\n{body}\n}}\n"


def expressions(function: ModelFunction) -> list[Any]:
    """The outputs of a function, one after the other, as SymPy expressions of in[0], in[1]..."""
    inputs = ca.vertcat(*(argument.symbols for argument in function.inputs))
    outputs = ca.vertcat(*(ca.vertcat(*output.values) for output in function.outputs))
    program = ca.Function(function.name, [inputs], [outputs])
    work: dict[int, Any] = {}
    results: list[Any] = [sympy.Integer(0)] * outputs.numel()
    for k in range(program.n_instructions()):
        operation = program.instruction_id(k)
        source, target = program.instruction_input(k), program.instruction_output(k)
        if operation == ca.OP_INPUT:
            work[target[0]] = sympy.Symbol(f"in[{source[1]}]", real=True)
        elif operation == ca.OP_OUTPUT:
            results[target[1]] = work[source[0]]
        elif operation == ca.OP_CONST:
            work[target[0]] = sympy.Float(program.instruction_constant(k), 17)
        else:
            work[target[0]] = OPERATIONS[operation](*(work[i] for i in source))
    return results
