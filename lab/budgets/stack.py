"""The deepest stack of a cycle, from the call graph that gcc writes.

Calls through pointers are resolved by the name of the member that is called. Functions of the C
library are judged by their instructions. The board's own functions are not counted.
"""

import re
import subprocess
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory

from turnbuckle.lab.budgets.image import Image

ROOT = "tb_cycles_run"
"""A cycle on a board without an operating system."""
BOARD = "tb_board_"
INDIRECT = "__indirect_call"
BY_MEMBER: Mapping[str, Sequence[str]] = {
    "sync": ["network.c:sync"],
    "collect": ["network.c:collect"],
    "dispatch": ["network.c:dispatch"],
    "send": ["loopback.c:send_frame"],
    "receive": ["loopback.c:receive_frame"],
    "state": ["loopback.c:bus_state"],
    "close": ["loopback.c:close_port"],
}
"""What is called through a pointer: CANopen, on buses in memory."""

NODE = re.compile(r'node: \{ title: "(.+?)" label: "(.+?)"')
EDGE = re.compile(r'edge: \{ sourcename: "(.+?)" targetname: "(.+?)"(?: label: "(.+?)")?')
OWN_STACK = re.compile(r"(\d+) bytes \((.+?)\)")
MEMBER = re.compile(r"(?:->|\.)(\w+)\(")
CALL = re.compile(r"\tb[lx]?(?:\.[nw])?\t[0-9a-f]+ <(\w+)>")
BY_NUMBER = re.compile(r"\tsub(?:\.w)?\tsp, (?:sp, )?#(\d+)|\[sp, #-(\d+)\]!")
REGISTERS = re.compile(r"\t(?:push|vpush|stmdb\tsp!,|stmdb\.w\tsp!,)\t? ?\{(.+)\}")
DOUBLE, WORD = 8, 4
"""Bytes of a register."""


class StackError(ValueError):
    """The depth of the stack cannot be told; the text says why."""


@dataclass
class Graph:
    """Functions by name: that of its file before a static one's."""

    own: dict[str, int] = field(default_factory=dict)
    """Stack of the function itself [B]."""
    calls: dict[str, set[str]] = field(default_factory=dict)


def graph_of(texts: Sequence[str], by_member: Mapping[str, Sequence[str]] = BY_MEMBER) -> Graph:
    """The graph of a program; StackError where a call through a pointer is not resolved."""
    graph = Graph()
    for text in texts:
        for title, label in NODE.findall(text):
            if stack := OWN_STACK.search(label):
                graph.own[short(title)] = static_size(title, *stack.groups())
        for caller, called, place in EDGE.findall(text):
            targets = by_member_at(place, by_member) if called == INDIRECT else [short(called)]
            graph.calls.setdefault(short(caller), set()).update(targets)
    refuse_unknown(graph, by_member)
    return graph


def short(title: str) -> str:
    """A function's name, after that of its file where it is static."""
    return title.rsplit("/", 1)[-1]


def static_size(title: str, size: str, kind: str) -> int:
    """Bytes; StackError where their number is known at run time only."""
    if kind != "static":
        raise StackError(f"{short(title)} has a stack whose size is {kind}")
    return int(size)


def by_member_at(place: str, by_member: Mapping[str, Sequence[str]]) -> Sequence[str]:
    """What a call through a pointer reaches, by where it stands in the source."""
    file, line, column = place.rsplit(":", 2)
    text = Path(file).read_text().splitlines()[int(line) - 1]
    found = [match for match in MEMBER.finditer(text) if match.end() >= int(column)]
    if not found or found[0].group(1) not in by_member:
        raise StackError(f"{Path(file).name}:{line}: a call through a pointer is not in the table")
    return by_member[found[0].group(1)]


def refuse_unknown(graph: Graph, by_member: Mapping[str, Sequence[str]]) -> None:
    """StackError where the table names no function of the program, or leaves one out: a static
    function that no call names is reached through a pointer."""
    listed = {name for names in by_member.values() for name in names}
    called = {name for names in graph.calls.values() for name in names}
    if unknown := listed - graph.own.keys():
        raise StackError(f"the table has what is no function: {', '.join(sorted(unknown))}")
    pointed = {name for name in graph.own if ":" in name and name not in called}
    if missing := pointed - listed:
        raise StackError(f"called through pointers, not in the table: {', '.join(sorted(missing))}")


def add_library(graph: Graph, image: Image, root: str = ROOT) -> None:
    """Add the functions of the C library, by their instructions in the linked program.

    gcc also writes down calls that it has only weighed: those are of what is not in the program.
    """
    while unknown := reached(graph, root) - graph.own.keys():
        for name in unknown:
            code = instructions(image.program, name) if name in image.symbols else []
            graph.own[name] = sum(pushed(line) for line in code)
            calls = (CALL.search(line) for line in code)
            graph.calls[name] = {call.group(1) for call in calls if call} - {name}


def reached(graph: Graph, root: str) -> set[str]:
    """All functions that a call of the root may call, the board's own left out."""
    found: set[str] = set()
    waiting = {root}
    while waiting:
        found |= waiting
        called = {each for name in waiting for each in graph.calls.get(name, ())}
        waiting = {name for name in called - found if not name.startswith(BOARD)}
    return found


def instructions(program: bytes, name: str) -> list[str]:
    """The lines of a function's disassembly; StackError where the program has no such function."""
    with TemporaryDirectory(prefix="turnbuckle-budget-") as folder:
        path = Path(folder) / "program.elf"
        path.write_bytes(program)
        command = ["arm-none-eabi-objdump", "-d", f"--disassemble={name}", str(path)]
        text = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    lines = [line for line in text.splitlines() if line.startswith("   ")]
    if not lines:
        raise StackError(f"the program calls {name}, which is not in it")
    return lines


def pushed(line: str) -> int:
    """Bytes by which an instruction makes the stack deeper."""
    if number := BY_NUMBER.search(line):
        return int(number.group(1) or number.group(2))
    if registers := REGISTERS.search(line):
        return sum(size_of(each.strip()) for each in registers.group(1).split(","))
    return 0


def size_of(registers: str) -> int:
    """Bytes of a register, or of some: d8-d15."""
    first, _, last = registers.partition("-")
    count = int(last[1:]) - int(first[1:]) + 1 if last else 1
    return count * (DOUBLE if first.startswith("d") else WORD)


def deepest(graph: Graph, root: str = ROOT) -> tuple[int, list[str]]:
    """The deepest stack from a function on [B], and the way there; StackError for a recursion."""
    known: dict[str, tuple[int, list[str]]] = {}

    def below(name: str, above: tuple[str, ...]) -> tuple[int, list[str]]:
        if name in above:
            raise StackError(f"{name} calls itself, by way of {', '.join(above)}")
        if name not in known:
            called = (each for each in graph.calls.get(name, ()) if each in graph.own)
            ways = [below(each, (*above, name)) for each in sorted(called)]
            depth, way = max(ways, default=(0, []))
            known[name] = graph.own[name] + depth, [name, *way]
        return known[name]

    return below(root, ())


def stack_of(image: Image) -> tuple[int, list[str]]:
    """The deepest stack of a cycle [B], and the way there; StackError where it cannot be told."""
    graph = graph_of(image.graphs)
    add_library(graph, image)
    return deepest(graph)
