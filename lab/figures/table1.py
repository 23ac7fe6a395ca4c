"""Brau, Lallemand and Gosselin, Table 1: time of both methods and ours, published and measured."""

from turnbuckle.lab.benchmark.solvers.kernel import DAQP, QUADPROG
from turnbuckle.lab.benchmark.solvers.reduced import REDUCED
from turnbuckle.lab.benchmark.solvers.turnbuckle import OURS
from turnbuckle.lab.benchmark.table1 import Table1, compare_table1
from turnbuckle.lab.figures.drawing import picture
from turnbuckle.lab.figures.findings import Drawn, Finding
from turnbuckle.model.machine import Machine

#: ns a problem. The paper does not say whether it counts all 3600 problems together; they would
#: then take 3.6 us and 0.16 us each, which no program of its time did.
PUBLISHED = {"kernel + QP": 13.1e6, REDUCED: 0.569e6}
PRINTED, MEASURED, OWN = "#9AA0A8", "#0072B2", "#E69F00"
Bar = tuple[str, float, str]


def table1(square: Machine) -> Drawn:
    """Time both methods and ours in C, on the paper's problems."""
    result = compare_table1(square)
    times = {row.name: row.timing.least for row in result.table.rows}
    draw(bars(times))
    return Drawn(
        "brau_table1.png",
        "Time for the tensions of one pose and force: published (grey), measured in C in one run"
        " of `make figures` (blue; ours orange).",
        findings(result, times),
    )


def bars(times: dict[str, float]) -> list[Bar]:
    """Label, time [ns] and colour, from top to bottom."""
    labels = {
        QUADPROG: f"{QUADPROG}\nexact, bounded",
        DAQP: f"{DAQP}\nexact, bounded",
        OURS: "ours\nexact, bounded",
        REDUCED: f"{REDUCED}\nnot optimal, no upper bound",
    }
    colours = {OURS: OWN}
    return [
        *((f"{name}\npublished", time, PRINTED) for name, time in PUBLISHED.items()),
        *((text, times[name], colours.get(name, MEASURED)) for name, text in labels.items()),
    ]


def draw(entries: list[Bar]) -> None:
    """Bars on a logarithmic axis, each with its time."""
    labels, times, colours = zip(*entries, strict=True)
    with picture("brau_table1.png", 8.4, 4.8) as figure:
        axes = figure.subplots()
        drawn = axes.barh(range(len(entries)), times, color=colours, height=0.68, log=True)
        axes.bar_label(drawn, [written(time) for time in times], padding=5)
        axes.set_yticks(range(len(entries)), labels)
        axes.invert_yaxis()
        axes.set_xlim(1e1, 1e8)
        axes.set_xticks([10.0**k for k in range(1, 9)])
        axes.set_xticklabels(
            ["10 ns", "100 ns", "1 µs", "10 µs", "100 µs", "1 ms", "10 ms", "0.1 s"]
        )
        axes.minorticks_off()
        axes.grid(axis="y", visible=False)
        axes.set_axisbelow(True)
        axes.set_xlabel("time a problem")


def written(time: float) -> str:
    """A time [ns] with a unit that suits it."""
    return f"{time:.0f} ns" if time < 1e3 else f"{time / 1e6:.3g} ms"


def findings(result: Table1, times: dict[str, float]) -> tuple[Finding, ...]:
    """Table 1 beside this run, and what the quicker method gives away."""
    excess, published = result.excess, PUBLISHED["kernel + QP"] / PUBLISHED[REDUCED]
    return (
        Finding("Table 1", "kernel and quadratic program, time a problem",
                written(PUBLISHED["kernel + QP"]),
                f"{times[DAQP]:.0f} ns with DAQP, {times[QUADPROG]:.0f} ns with quadprog",
                "C, and twenty years; taken as the time of one problem, which the paper does not"
                " say"),
        Finding("Table 1", "reduced matrices, time a problem", written(PUBLISHED[REDUCED]),
                f"{times[REDUCED]:.0f} ns", "the same"),
        Finding("Table 1", "kernel and quadratic program, by reduced matrices",
                f"{published:.1f}", f"{result.published_ratio:.1f}",
                "23 is a property of their quadratic program, not of the method"),
        Finding("Table 1", "exact bounded tensions of least norm", "not in the paper",
                f"{times[OURS]:.0f} ns, {result.ratio:.1f} times faster than kernel and quadratic"
                " program",
                f"the faster of the two; the same tensions to {worst(result):.0e} N"),
        Finding("Table 1", "tensions of reduced matrices", '"the good solution"',
                f"optimal in {excess.optimal:.1%}; their norm is up to {excess.norm[1]:.0%} higher,"
                f" the largest tension up to {excess.tension[1]:.0%}",
                "all but two cables hold t_min: the lowest sum, not the least norm"),
    )  # fmt: skip


def worst(result: Table1) -> float:
    """Largest error [N] of the exact methods against the reference."""
    return max(row.agreement.error for row in result.table.rows if row.name != REDUCED)
