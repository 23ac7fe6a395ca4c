"""Routines -> functions of C: prototypes, comments, guards and bodies."""

import textwrap
from dataclasses import dataclass
from itertools import groupby
from operator import itemgetter

from turnbuckle.codegen.accuracy import Accuracy, WorstCase
from turnbuckle.codegen.chain import Chain, Link
from turnbuckle.codegen.constant_names import ConstantNames
from turnbuckle.codegen.enumeration import Enumeration
from turnbuckle.codegen.ir import Op, Routine
from turnbuckle.codegen.item import Item, cost, most_steps, most_visits
from turnbuckle.codegen.loop import Loop
from turnbuckle.codegen.print_c import LINE_WIDTH, Printer, Text, literal, wrap
from turnbuckle.codegen.procedure import Procedure
from turnbuckle.model.symbolic.function import Input, ModelFunction, Output, Status
from turnbuckle.model.symbolic.sweep import CHOSEN, NUMBERS

#: Arguments with more entries than this are not listed where an error is worst.
LONGEST_PLACE = 8


@dataclass(frozen=True)
class CFunction:
    """One function as the templates need it."""

    name: str
    comment: str
    prototype: str
    body: str
    parts: tuple["CFunction", ...] = ()


def emit(item: Item, accuracy: Accuracy, names: ConstantNames) -> CFunction:
    """The C of one function."""
    function = item.function
    lines, refused = one_fallback(item_body(item, names), function, names)
    parts = [found for called in private(item) for found in part(called, names)]
    return CFunction(
        f"tb_{function.name}",
        comment(item, accuracy),
        prototype(f"tb_{function.name}", function),
        "\n".join(lines),
        (*parts, *refused),
    )


def item_body(item: Item, names: ConstantNames) -> list[str]:
    """The statements of a function."""
    match item:
        case Procedure():
            return retry_body(item)
        case Enumeration():
            return sweep_body(item)
        case Chain():
            return chain_body(item)
        case Loop():
            return loop_body(item)
        case Routine():
            return body(item, names)
    raise TypeError(f"{item.function.name}: no C is known for a {type(item).__name__}")


def private(item: Item) -> list[Item]:
    """The functions that only this one calls, and what only they call before them."""
    return [part for called in item.own() for part in (*private(called), called)]


def part(item: Item, names: ConstantNames) -> list[CFunction]:
    """An item that only the functions of its file call, after what it alone calls."""
    function = item.function
    lines, refused = one_fallback(item_body(item, names), function, names)
    own = CFunction(
        f"tb_{function.name}",
        "\n * ".join(fill(f"{function.summary}.", "")),
        f"static {prototype(f'tb_{function.name}', function)}",
        "\n".join(lines),
    )
    return [*refused, own]


def one_fallback(
    lines: list[str], function: ModelFunction, names: ConstantNames
) -> tuple[list[str], list[CFunction]]:
    """A body that gives its results their fallback in one place: there, or in a function of its own
    where there are several ways out."""
    name = f"tb_refuse_{function.name}"
    ways_out = [line for line in lines if f"return {name}(" in line]
    if len(ways_out) == 1:
        place = lines.index(ways_out[0])
        status = ways_out[0].partition("(")[2].partition(",")[0]
        answer = [*fallback(function, names), f"        return {status};"]
        return [*lines[:place], *answer, *lines[place + 1 :]], []
    if not ways_out:
        return lines, []
    results = "; ".join(fallback_text(output) for output in function.outputs)
    body = [*(line[4:] for line in fallback(function, names)), "    return status;"]
    outputs = [f"real_t {output.name}[{output.size}]" for output in function.outputs]
    head = "\n".join(parameters(f"static tb_status {name}", ["tb_status status", *outputs]))
    comment = "\n * ".join(fill(f"Refuses with a status: {results}.", ""))
    return lines, [CFunction(name, comment, head, "\n".join(body))]


def fallback_text(output: Output) -> str:
    """What a refusal makes of a result, in words."""
    unit = "" if output.unit == "1" else f" {output.unit}"
    return f"{output.name} is {output.fallback:g}{unit}"


def loop_body(item: Loop) -> list[str]:
    """Begin, step until a step is the last one or fails, finish."""
    function, done = item.function, item.done.name
    begin, step, finish = (call(routine.function, {}) for routine in item.own())
    return [
        *(f"    real_t {entry.name}[{entry.size}];" for entry in item.state),
        f"    real_t {done}[1] = {{{literal(0.0)}}};",
        *wrap(f"    tb_status status = {begin};", "    "),
        f"    for (int steps = 0; steps < {item.repeat.most} && status == TB_OK"
        f" && !({done}[0] > {literal(0.0)}); steps++) {{",
        *wrap(f"        status = {step};", "        "),
        "    }",
        f"    if (status == TB_OK && !({done}[0] > {literal(0.0)})) {{",
        "        status = TB_INACCURATE;",
        "    }",
        "    if (status != TB_OK) {",
        way_out("status", function),
        "    }",
        *wrap(f"    return {finish};", "    "),
    ]


def sweep_body(item: Enumeration) -> list[str]:
    """Begin, visit every subset in the table, finish."""
    subsets, function = item.sweep.subsets, item.function
    begin, visit, finish = (call(routine.function, {}) for routine in item.own())
    rows = ", ".join(f"{{{','.join(map(str, subset))}}}" for subset in subsets)
    table = f"subsets[{len(subsets)}][{len(subsets[0])}]"
    lines = wrap(f"    static const unsigned char {table} = {{{rows}}};", "    ")
    lines += [f"    real_t {entry.name}[{entry.size}];" for entry in item.state]
    lines += wrap(f"    const tb_status status = {begin};", "    ")
    lines += ["    if (status != TB_OK) {", way_out("status", function), "    }"]
    lines += [f"    for (int k = 0; k < {len(subsets)}; k++) {{", *gather(item)]
    lines += wrap(f"        (void){visit};", "        ")
    return [*lines, "    }", *wrap(f"    return {finish};", "    ")]


def gather(item: Enumeration) -> list[str]:
    """Copies what a visit reads of its subset."""
    size = len(item.sweep.subsets[0])
    rows, columns = item.matrix_shape
    read = [port for port in item.visit.function.inputs if port.name in (CHOSEN, NUMBERS)]
    lines = [f"        real_t {port.name}[{port.size}];" for port in read]
    lines += [
        f"        for (int j = 0; j < {size}; j++) {{",
        "            const int number = subsets[k][j];",
    ]
    for port in read:
        if port.name == NUMBERS:
            lines.append(f"            {NUMBERS}[j] = (real_t)number;")
        else:
            lines += [
                f"            for (int i = 0; i < {rows}; i++) {{",
                f"                {CHOSEN}[{size} * i + j] = "
                f"{item.sweep.matrix}[{columns} * i + number];",
                "            }",
            ]
    return [*lines, "        }"]


def chain_body(item: Chain) -> list[str]:
    """Calls in sequence; the first fault ends it, and one infeasible answer is the answer."""
    *earlier, last = item.links
    unsure = [link for link in earlier if may_be_infeasible(link)]
    lines = [
        declaration(link, name, port) for link in earlier for name, port in link.gives().items()
    ]
    lines += ["    bool infeasible = false;"] if unsure else []
    lines += ["    tb_status status;"] if unsure or any(map(may_fail, earlier)) else []
    for link in earlier:
        lines += link_lines(link, item.function, link in unsure)
    answer = link_call(last)
    if not unsure:
        return [*lines, *wrap(f"    return {answer};", "    ")]
    lines += wrap(f"    status = {answer};", "    ")
    return [*lines, "    return status == TB_OK && infeasible ? TB_INFEASIBLE : status;"]


def declaration(link: Link, name: str, port: Output) -> str:
    """A result that later calls read; zero where the call may not be made."""
    start = f" = {{{literal(0.0)}}}" if link.call.given else ""
    return f"    real_t {name}[{port.size}]{start};"


def link_lines(link: Link, function: ModelFunction, unsure: bool) -> list[str]:
    """One call, and the way out where it fails."""
    if not may_fail(link) and not unsure:
        lines = wrap(f"    (void){link_call(link)};", "    ")
    else:
        lines = wrap(f"    status = {link_call(link)};", "    ")
    if may_fail(link):
        lines += ["    if (status > TB_INFEASIBLE) {", way_out("status", function), "    }"]
    if unsure:
        lines.append("    infeasible = infeasible || status == TB_INFEASIBLE;")
    if link.call.given:
        condition = f"    if ({link.call.given}[0] > {literal(0.0)}) {{"
        lines = [condition, *(f"    {line}" for line in lines), "    }"]
    return lines


def link_call(link: Link) -> str:
    """The call with the chain's own names."""
    return call(link.item.function, dict(link.call.renamed))


def may_fail(link: Link) -> bool:
    """Whether the function may answer that its results are no use."""
    function = link.item.function
    guards = any(port.guarded and port.size for port in function.inputs)
    return guards or any(verdict.is_fault for verdict in function.verdicts)


def may_be_infeasible(link: Link) -> bool:
    """Whether the function may answer TB_INFEASIBLE."""
    return not all(verdict.is_fault for verdict in link.item.function.verdicts)


def retry_body(item: Procedure) -> list[str]:
    """Attempt; where that fails, substitute an argument and make every attempt with it.

    Where the argument is found feasible and every attempt fails all the same, the argument lies on
    the border of the feasible set up to rounding: the attempts are made with the second substitute,
    and the argument counts as infeasible.
    """
    first, second = item.attempts[0].function, item.substitute.function
    lines = [
        *wrap(f"    tb_status status = {call(first, {})};", "    "),
        "    if (status != TB_INACCURATE) {",
        "        return status;",
        "    }",
        *(f"    real_t {served.name}[{served.size}];" for served in second.outputs),
        *wrap(f"    tb_status verdict = {call(second, {})};", "    "),
    ]
    argument = first.inputs[item.replaced].name
    may_fail = any(verdict.is_fault for verdict in second.verdicts)
    usable = " && verdict <= TB_INFEASIBLE" if may_fail else ""
    for number, served in enumerate(second.outputs):
        for attempt in item.attempts:
            # The first attempt has failed at the wanted argument already.
            failed = not number and attempt is item.attempts[0]
            allowed = " && verdict == TB_INFEASIBLE" if failed else usable
            again = call(attempt.function, {argument: served.name})
            lines += [
                f"    if (status == TB_INACCURATE{allowed}) {{",
                *(["        verdict = TB_INFEASIBLE;"] if number else []),
                *wrap(f"        status = {again};", "        "),
                "    }",
            ]
    return [*lines, "    return status == TB_OK ? verdict : status;"]


def call(function: ModelFunction, replaced: dict[str, str]) -> str:
    """A call with the function's own names as arguments, but for those that are replaced."""
    names = [replaced.get(name, name) for name in argument_names(function)]
    return f"tb_{function.name}({', '.join(names)})"


def emit_alias(name: str, routine: Item) -> CFunction:
    """A function that is another one under a second name."""
    function = routine.function
    line = f"    return {call(function, {})};"
    return CFunction(
        f"tb_{name}",
        f"What the machine file chooses for an infeasible wrench: tb_{function.name}.",
        prototype(f"tb_{name}", function),
        "\n".join(wrap(line, "    ")),
    )


def argument_names(function: ModelFunction) -> list[str]:
    """Names of arguments and results in the order of the C function; what is both comes once."""
    return list(dict.fromkeys(port.name for port in function.ports))


def prototype(name: str, function: ModelFunction) -> str:
    """Declaration without the semicolon."""
    results = {port.name: f"real_t {port.name}[{port.size}]" for port in function.outputs}
    arguments = {
        port.name: results.get(port.name, f"const real_t {port.name}[{max(1, port.size)}]")
        for port in function.inputs
    }
    return "\n".join(parameters(f"tb_status {name}", [*(arguments | results).values()]))


def parameters(head: str, entries: list[str]) -> list[str]:
    """The head of a function, broken between parameters alone."""
    lines = [f"{head}({entries[0]}"]
    for entry in entries[1:]:
        if len(f"{lines[-1]}, {entry},") > LINE_WIDTH:
            lines[-1] += ","
            lines.append(f"    {entry}")
        else:
            lines[-1] += f", {entry}"
    lines[-1] += ")"
    return lines


def comment(routine: Item, accuracy: Accuracy) -> str:
    """What a user of the function must know: meaning, units, domain, accuracy, cost."""
    function = routine.function
    lines = fill(f"{function.summary}  ({function.source}).", "")
    lines += fill(ports(function.inputs) + "  ->  " + ports(function.outputs), "")
    lines += domain(function)
    lines += worst(accuracy)
    counts = ", ".join(f"{count} {name}" for name, count in cost(routine).items())
    steps, visits = most_steps(routine), most_visits(routine)
    if steps:
        lines += fill(f"At most {steps} steps.", "")
    if visits:
        lines += fill(f"Visits {visits} subsets of the cables.", "")
    scope = "all branches and steps" if steps or visits else "all branches"
    lines += fill(f"Cost, {scope}: {counts or 'none'}.", "")
    return "\n *  ".join(lines)


def ports(entries: tuple[Input, ...] | tuple[Output, ...]) -> str:
    """Names, units and shapes."""
    return ", ".join(
        f"{port.name} [{port.unit if port.unit != '1' else '-'}]"
        f" ({' x '.join(map(str, port.shape)) or 'scalar'})"
        for port in entries
    )


def domain(function: ModelFunction) -> list[str]:
    """When the function refuses, and what it then returns."""
    lines: list[str] = []
    for port in function.inputs:
        if port.size and port.guarded:
            lines += fill(f"Domain: {port.name} {span(port)}, else TB_OUT_OF_DOMAIN.", "")
    # the parts of a loop may refuse for the same reason
    for text in dict.fromkeys(f"TB_{v.status.name}: {v.meaning}." for v in function.verdicts):
        lines += fill(text, "")
    return lines


def span(port: Input) -> str:
    """Bounds of an argument, entry by entry where they differ."""
    unit = "" if port.unit == "1" else f" {port.unit}"
    if port.bounds_sum:
        return f"with a sum of magnitudes of at most {port.high[0]:.6g}{unit}"
    bounds = [f"[{low:.6g}, {high:.6g}]" for low, high in zip(port.low, port.high, strict=True)]
    distinct = list(dict.fromkeys(bounds))
    return f"in {distinct[0] if len(distinct) == 1 else ' x '.join(bounds)}{unit}"


def worst(accuracy: Accuracy) -> list[str]:
    """Measured error of every result in both precisions."""
    lines: list[str] = []
    for name, cases in accuracy.results.items():
        text = "; ".join(case_text(precision, case) for precision, case in cases.items())
        lines += fill(f"Error of {name}: {text}.", "")
    return lines


def case_text(precision: str, case: WorstCase) -> str:
    """The error of one result in one precision, and where it is worst."""
    unit = "" if case.unit == "1" else f" {case.unit}"
    bound = f"{precision} at most {case.bound:.1e}{unit}"
    count = sum(len(values) for _, values in case.place)
    if not 0 < count <= LONGEST_PLACE:
        return bound
    place = ", ".join(
        f"{name} ({', '.join(f'{value:.4g}' for value in values)})"
        for name, values in case.place
        if values
    )
    return f"{bound} (worst found {case.error:.1e} at {place})"


def fill(text: str, indent: str) -> list[str]:
    """Wrap the text of a comment."""
    return textwrap.wrap(
        text, LINE_WIDTH - 4, subsequent_indent=indent + "  ", break_on_hyphens=False
    )


def body(routine: Routine, names: ConstantNames) -> list[str]:
    """Guards, then the computation, then the verdicts."""
    printer = Printer(routine, names.of_places(routine))
    function = routine.function
    lines = [f"    (void){port.name};" for port in ignored(routine)]
    lines += guard(function)
    lines += printer.body()
    pairs = zip(function.verdicts, routine.verdicts, strict=True)
    faults = [(verdict.status, number) for verdict, number in pairs if verdict.is_fault]
    for status, alike in groupby(faults, key=itemgetter(0)):
        operands = [printer.verdict(number) for _, number in alike]
        lines += refusal(joined(operands), status, function)
    return [*lines, *results(routine, printer), *answer(routine, printer)]


def ignored(routine: Routine) -> list[Input]:
    """Arguments that nothing reads."""
    entries = {
        routine.nodes[number].entry[0]
        for number in routine.needed()
        if routine.nodes[number].op is Op.INPUT
    }
    return [
        port
        for place, port in enumerate(routine.function.inputs)
        if not port.size or (place not in entries and not port.guarded)
    ]


def joined(flags: list[Text]) -> str:
    """One of them holds."""
    return flags[0].code if len(flags) == 1 else " || ".join(flag.within(0) for flag in flags)


def results(routine: Routine, printer: Printer) -> list[str]:
    """Gives every output its value; what an output overwrites and another one needs is kept."""
    targets = [
        (f"{output.name}[{entry}]", value)
        for output, values in zip(routine.function.outputs, printer.results(), strict=True)
        for entry, value in enumerate(values)
    ]
    moved = [(target, value) for target, value in targets if target != value]
    overwritten = {target for target, _ in moved}
    kept = {
        value: f"old_{value[:-1].replace('[', '_')}" for _, value in moved if value in overwritten
    }
    lines = [f"    const real_t {name} = {value};" for value, name in kept.items()]
    for target, value in moved:
        lines += wrap(f"    {target} = {kept.get(value, value)};", "    ")
    return lines


def answer(routine: Routine, printer: Printer) -> list[str]:
    """The last line: fine, or valid but infeasible."""
    pairs = zip(routine.function.verdicts, routine.verdicts, strict=True)
    flags = [printer.verdict(number) for verdict, number in pairs if not verdict.is_fault]
    if not flags:
        return ["    return TB_OK;"]
    condition = joined(flags) if len(flags) == 1 else f"({joined(flags)})"
    return [f"    return {condition} ? TB_{Status.INFEASIBLE.name} : TB_OK;"]


def guard(function: ModelFunction) -> list[str]:
    """Refuses arguments outside their bounds; a NaN is never inside."""
    tests = [test for port in function.inputs for test in domain_tests(port)]
    if not tests:
        return []
    lines: list[str] = []
    for test in tests:
        lines += wrap(f"          && {test}" if lines else f"    if (!({test}", "          ")
    lines[-1] += ")) {"
    return [*lines, way_out("TB_OUT_OF_DOMAIN", function), "    }"]


def domain_tests(port: Input) -> list[str]:
    """Tests that hold inside the domain of an argument; they fail for a NaN."""
    names = [f"{port.name}[{entry}]" for entry in range(port.size)]
    if not port.guarded:
        return []
    if port.bounds_sum and names:
        magnitudes = " + ".join(f"TB_ABS({name})" for name in names)
        return [f"{magnitudes} <= {literal(port.high[0])}"]
    return [
        f"{name} >= {literal(low)} && {name} <= {literal(high)}"
        for name, low, high in zip(names, port.low, port.high, strict=True)
    ]


def refusal(condition: str, status: Status, function: ModelFunction) -> list[str]:
    """Returns the fallback where a condition holds."""
    answered = way_out(f"TB_{status.name}", function)
    return [*wrap(f"    if ({condition}) {{", "    "), answered, "    }"]


def way_out(status: str, function: ModelFunction) -> str:
    """Leaves a function with its fallback."""
    results = ", ".join(output.name for output in function.outputs)
    return f"        return tb_refuse_{function.name}({status}, {results});"


def fallback(function: ModelFunction, names: ConstantNames) -> list[str]:
    """Statements that give every output its fallback."""
    return [
        f"        {output.name}[{entry}] = {value};"
        for output, value in zip(function.outputs, names.of_fallbacks(function), strict=True)
        for entry in range(output.size)
    ]
