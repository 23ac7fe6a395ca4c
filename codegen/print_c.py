"""Arranged nodes -> lines of C99."""

import math
import re
from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from itertools import count

from turnbuckle.codegen.arrange import Block, Branch, arrange
from turnbuckle.codegen.counterpart import Place
from turnbuckle.codegen.ir import LEAVES, LOGICAL, Node, Op, Routine

#: Longest line of code that is printed.
LINE_WIDTH = 96

_INFIX = {
    Op.ADD: ("+", 4),
    Op.SUB: ("-", 4),
    Op.MUL: ("*", 5),
    Op.DIV: ("/", 5),
    Op.LT: ("<", 3),
    Op.LE: ("<=", 3),
    Op.EQ: ("==", 2),
    Op.NE: ("!=", 2),
    Op.AND: ("&&", 1),
    Op.OR: ("||", 0),
}
_ATOM, _UNARY, _TERNARY = 9, 7, -1


@dataclass(frozen=True)
class Text:
    """C of an expression and how tightly its outermost operator binds."""

    code: str
    binding: int

    def within(self, binding: int) -> str:
        """The code, in parentheses unless it binds tighter than its surroundings."""
        return self.code if self.binding > binding else f"({self.code})"


def literal(value: float) -> str:
    """A constant that reads back to the same number in either precision."""
    if not math.isfinite(value):
        raise ValueError("a constant of the generated C is not finite: the machine is degenerate")
    digits = repr(float(value))
    return f"TB_C({digits})" if value >= 0 else f"-TB_C({digits[1:]})"


class Printer:
    """Prints the body of one routine."""

    def __init__(self, routine: Routine, named: Mapping[Place, str]) -> None:
        self.routine, self.named = routine, named
        self.nodes = routine.nodes
        self.block = arrange(routine)
        self.names: dict[int, str] = {}
        self.notes: dict[int, str] = {}
        self.home: dict[int, int] = {}
        self.uses: Counter[int] = Counter()
        self.texts: dict[int, Text] = {}
        self.numbers: dict[str, str] = {}
        self.temporaries = 0
        self.arms: dict[int, list[int]] = {}
        self.find_homes(self.block)
        self.count_uses()
        self.take_labels()

    def find_homes(self, block: Block) -> None:
        """Remember which block computes each node."""
        for item in block:
            if isinstance(item, Branch):
                self.home.update(dict.fromkeys(item.selects, id(block)))
                self.arms[id(item.yes)] = self.arms[id(item.no)] = item.selects
                self.find_homes(item.yes)
                self.find_homes(item.no)
            else:
                self.home[item] = id(block)

    def count_uses(self) -> None:
        """How often each node is read."""
        needed = self.routine.needed()
        for number in needed:
            self.uses.update(self.nodes[number].args)
        self.uses.update(self.routine.roots())

    def take_labels(self) -> None:
        """Names and notes that the model gives to intermediate results."""
        for label, numbers in zip(self.routine.function.labels, self.routine.labels, strict=True):
            present = [n for n in numbers if n in self.home and n not in self.names]
            for entry, number in enumerate(numbers):
                if number in present:
                    suffix = f"_{entry}" if len(numbers) > 1 else ""
                    self.names[number] = f"{label.name}{suffix}"
            if present and label.note:
                self.notes[min(present)] = label.note
        for output, numbers in zip(
            self.routine.function.outputs, self.routine.outputs, strict=True
        ):
            for entry, number in enumerate(numbers):
                if number in self.home:
                    self.names.setdefault(number, f"{output.name}_{entry}")

    def body(self) -> list[str]:
        """Lines that compute everything the function returns."""
        return self.statements(self.block, "    ")

    def statements(self, block: Block, indent: str) -> list[str]:
        """Lines of one block."""
        lines: list[str] = []
        near = self.read_near(block)
        for item in block:
            if isinstance(item, Branch):
                lines += self.branch(item, indent)
            elif not self.inlined(item, near):
                lines += self.definition(item, indent)
        return lines

    def inlined(self, number: int, near: set[int]) -> bool:
        """Whether the node is written where it is used instead of getting a name."""
        text = self.expression(number)
        single = self.uses[number] == 1 and number not in self.names
        if single and number in near and self.length(text) <= LINE_WIDTH // 2:
            self.texts[number] = text
            return True
        return False

    def length(self, text: Text) -> int:
        """Length of an expression with numbers for names, so that names move no statement."""
        return len(
            re.sub(r"\bTB_\w+", lambda found: self.numbers.get(found[0], found[0]), text.code)
        )

    def read_near(self, block: Block) -> set[int]:
        """What is read by the nodes of a block, and by the choices that it gives values to."""
        level = list(self.arms.get(id(block), []))
        for item in block:
            level += item.selects if isinstance(item, Branch) else [item]
        return {read for user in level for read in self.nodes[user].args}

    def definition(self, number: int, indent: str) -> list[str]:
        """A named intermediate result."""
        lines = [f"{indent}/* {self.notes[number]} */"] if number in self.notes else []
        kind = "bool" if self.nodes[number].op in LOGICAL else "real_t"
        text = self.expression(number)
        name = self.name(number)
        return lines + wrap(f"{indent}const {kind} {name} = {text.code};", indent)

    def branch(self, branch: Branch, indent: str) -> list[str]:
        """An if that gives values to its choices."""
        names = [self.name(select) for select in branch.selects]
        condition = self.operand(branch.condition, (branch.selects[0], 0))
        lines = [f"{indent}/* {self.notes[s]} */" for s in branch.selects if s in self.notes]
        lines += wrap(f"{indent}real_t {', '.join(names)};", indent)
        for arm, block in ((1, branch.yes), (2, branch.no)):
            head = f"if ({condition.code})" if arm == 1 else "} else"
            lines += wrap(f"{indent}{head} {{", indent)
            lines += self.statements(block, indent + "    ")
            for select, name in zip(branch.selects, names, strict=True):
                value = self.operand(self.nodes[select].args[arm], (select, arm))
                lines += wrap(f"{indent}    {name} = {value.code};", indent + "    ")
        for select, name in zip(branch.selects, names, strict=True):
            self.texts[select] = Text(name, _ATOM)
        return [*lines, f"{indent}}}"]

    def name(self, number: int) -> str:
        """The C name of a node; made up where the model gives none."""
        if number not in self.names:
            self.names[number] = f"t{self.temporaries}"
            self.temporaries += 1
        self.texts[number] = Text(self.names[number], _ATOM)
        return self.names[number]

    def operand(self, number: int, place: Place) -> Text:
        """A node as it is read at a place."""
        node = self.nodes[number]
        if place in self.named:
            named = self.named[place]
            self.numbers[named.lstrip("-")] = literal(abs(node.value))
            return Text(named, _UNARY if named.startswith("-") else _ATOM)
        if node.op in LEAVES:
            return self.leaf(node)
        return self.texts[number]

    def leaf(self, node: Node) -> Text:
        """A constant, an input entry or the machine epsilon."""
        if node.op is Op.CONSTANT:
            return Text(literal(node.value), _ATOM if node.value >= 0 else _UNARY)
        if node.op is Op.EPSILON:
            return Text("TB_EPSILON", _ATOM)
        argument, entry = node.entry
        return Text(f"{self.routine.function.inputs[argument].name}[{entry}]", _ATOM)

    def expression(self, number: int) -> Text:
        """The operation of a node on its operands."""
        node = self.nodes[number]
        args = [self.operand(arg, (number, operand)) for operand, arg in enumerate(node.args)]
        if node.op in _INFIX:
            return self.infix(node.op, *args)
        return _PREFIX[node.op](*args)

    def infix(self, op: Op, left: Text, right: Text) -> Text:
        """Two operands around an operator, grouped exactly as the nodes are."""
        symbol, binding = _INFIX[op]
        if op in (Op.AND, Op.OR):
            same = left.within(2) if left.binding != binding else left.code
            return Text(f"{same} {symbol} {right.within(2)}", binding)
        return Text(f"{left.within(binding - 1)} {symbol} {right.within(binding)}", binding)

    def results(self) -> list[list[str]]:
        """The outputs, each entry as the right-hand side of an assignment."""
        places = count()
        return [
            [self.operand(number, (-1, next(places))).code for number in group]
            for group in self.routine.outputs
        ]

    def verdict(self, number: int) -> Text:
        """The condition of a verdict."""
        return self.operand(number, (number, -1))


def _choice(condition: Text, yes: Text, no: Text) -> Text:
    code = f"{condition.within(_TERNARY)} ? {yes.within(_TERNARY)} : {no.within(_TERNARY)}"
    return Text(code, _TERNARY)


_PREFIX: dict[Op, Callable[..., Text]] = {
    Op.NEG: lambda a: Text(f"-{a.within(_UNARY)}", _UNARY),
    Op.NOT: lambda a: Text(f"!{a.within(_UNARY)}", _UNARY),
    Op.SQRT: lambda a: Text(f"TB_SQRT({a.code})", _ATOM),
    Op.ABS: lambda a: Text(f"TB_ABS({a.code})", _ATOM),
    Op.COPYSIGN: lambda a, b: Text(f"TB_COPYSIGN({a.code}, {b.code})", _ATOM),
    Op.MIN: lambda a, b: Text(f"tb_min({a.code}, {b.code})", _ATOM),
    Op.MAX: lambda a, b: Text(f"tb_max({a.code}, {b.code})", _ATOM),
    Op.SELECT: _choice,
}


def wrap(line: str, indent: str) -> list[str]:
    """Break a long line at its outermost spaces."""
    lines: list[str] = []
    while len(line) > LINE_WIDTH:
        cut = line.rfind(" ", len(indent) + 8, LINE_WIDTH)
        if cut < 0:
            break
        lines.append(line[:cut])
        line = f"{indent}    {line[cut + 1 :]}"
    return [*lines, line]
