"""CasADi's instruction list -> the intermediate representation."""

from collections.abc import Callable

import casadi as ca

from turnbuckle.codegen.ir import Node, Op, Routine
from turnbuckle.model.symbolic.function import EPSILON, ModelFunction

_BINARY = {
    ca.OP_ADD: Op.ADD,
    ca.OP_SUB: Op.SUB,
    ca.OP_MUL: Op.MUL,
    ca.OP_DIV: Op.DIV,
    ca.OP_COPYSIGN: Op.COPYSIGN,
    ca.OP_FMIN: Op.MIN,
    ca.OP_FMAX: Op.MAX,
    ca.OP_LT: Op.LT,
    ca.OP_LE: Op.LE,
    ca.OP_EQ: Op.EQ,
    ca.OP_NE: Op.NE,
    ca.OP_AND: Op.AND,
    ca.OP_OR: Op.OR,
}
_UNARY = {ca.OP_NEG: Op.NEG, ca.OP_SQRT: Op.SQRT, ca.OP_FABS: Op.ABS, ca.OP_NOT: Op.NOT}


class LoweringError(Exception):
    """The model uses an operation that has no exact C counterpart."""


class Lowering:
    """Walks one CasADi function and rebuilds it in single-assignment form."""

    def __init__(self, function: ModelFunction) -> None:
        self.function = function
        self.nodes: list[Node] = []
        self.work: dict[int, int] = {}
        self.results: dict[tuple[int, int], int] = {}

    def append(self, op: Op, *args: int) -> int:
        """A new node."""
        self.nodes.append(Node(op, args))
        return len(self.nodes) - 1

    def constant(self, value: float) -> int:
        """A new constant."""
        self.nodes.append(Node(Op.CONSTANT, value=value))
        return len(self.nodes) - 1

    def run(self, program: ca.Function) -> None:
        """Translate every instruction in order."""
        for k in range(program.n_instructions()):
            op, inputs, outputs = (
                program.instruction_id(k),
                program.instruction_input(k),
                program.instruction_output(k),
            )
            if op == ca.OP_INPUT:
                self.work[outputs[0]] = self.read(inputs[0], inputs[1])
            elif op == ca.OP_OUTPUT:
                self.results[outputs[0], outputs[1]] = self.work[inputs[0]]
            elif op == ca.OP_CONST:
                self.work[outputs[0]] = self.constant(program.instruction_constant(k))
            else:
                operands = [self.work[i] for i in inputs]
                self.work[outputs[0]] = self.operation(op, operands)

    def read(self, argument: int, entry: int) -> int:
        """A node that reads an argument of the function, or the machine epsilon."""
        if argument == len(self.function.inputs):
            self.nodes.append(Node(Op.EPSILON))
        else:
            self.nodes.append(Node(Op.INPUT, entry=(argument, entry)))
        return len(self.nodes) - 1

    def operation(self, op: int, operands: list[int]) -> int:
        """One arithmetic instruction."""
        if op in _BINARY:
            return self.append(_BINARY[op], *operands)
        if op in _UNARY:
            return self.append(_UNARY[op], operands[0])
        if op in _COMPOSED:
            return _COMPOSED[op](self, operands)
        raise LoweringError(
            f"{self.function.name}: CasADi operation {op} has no C counterpart; "
            "the model may use + - * / sqrt abs min max, comparisons and selection"
        )


_COMPOSED: dict[int, Callable[[Lowering, list[int]], int]] = {
    ca.OP_ASSIGN: lambda self, x: x[0],
    ca.OP_SQ: lambda self, x: self.append(Op.MUL, x[0], x[0]),
    ca.OP_TWICE: lambda self, x: self.append(Op.MUL, self.constant(2.0), x[0]),
    ca.OP_INV: lambda self, x: self.append(Op.DIV, self.constant(1.0), x[0]),
    ca.OP_IF_ELSE_ZERO: lambda self, x: self.append(Op.SELECT, x[0], x[1], self.constant(0.0)),
}


def lower(function: ModelFunction) -> Routine:
    """Outputs, verdicts and labels of a model function as nodes."""
    groups = [output.values for output in function.outputs]
    groups.append([verdict.condition for verdict in function.verdicts])
    groups += [label.values for label in function.labels]
    expressions = [
        ca.densify(ca.vertcat(*group)) if group else ca.SX.zeros(0, 1) for group in groups
    ]
    arguments = [argument.symbols for argument in function.inputs]
    program = ca.Function(function.name, [*arguments, EPSILON], expressions)
    lowering = Lowering(function)
    lowering.run(program)
    results = [
        [lowering.results[group, entry] for entry in range(len(groups[group]))]
        for group in range(len(groups))
    ]
    count = len(function.outputs)
    return Routine(function, lowering.nodes, results[:count], results[count], results[count + 1 :])
