"""Runs the machine twice for ten minutes of its time; exit status 0 if nothing was wrong."""

import argparse
import sys
from pathlib import Path

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn
from rich.table import Table

from turnbuckle.lab.soak.pair import SoakError, soak_twice
from turnbuckle.lab.soak.run import Finding

ROOT = Path(__file__).parents[3]
MACHINE = "yoon2023"
CYCLES = 600_000
SHOWN = 20
"""Defects that are printed."""


def main() -> int:
    """Run, show, judge."""
    parser = argparse.ArgumentParser(prog="python -m turnbuckle.lab.soak", description=__doc__)
    parser.add_argument("--cycles", type=int, default=CYCLES, help=f"of work [{CYCLES}]")
    cycles = parser.parse_args().cycles
    console = Console()
    try:
        findings = run_with_progress(cycles, Console(stderr=True))
    except SoakError as error:
        console.print(f"{error}.")
        return 1
    console.print(summary(findings))
    for words in [words for finding in findings for words in finding.wrong][:SHOWN]:
        console.print(words, markup=False, highlight=False)
    verdict = judge(findings)
    console.print(verdict or f"Twice {cycles} cycles: nothing wrong, and the same to the bit.")
    return 1 if verdict else 0


def run_with_progress(cycles: int, console: Console) -> list[Finding]:
    """Both runs, with a bar on a terminal."""
    columns = (
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        TimeRemainingColumn(),
    )
    with Progress(*columns, console=console, disable=not console.is_terminal) as bars:
        bar = bars.add_task("cycles", total=2 * cycles)
        machine, folder = ROOT / "machines" / f"{MACHINE}.toml", ROOT / "generated" / MACHINE
        return soak_twice(machine, folder, cycles, lambda done: bars.update(bar, completed=done))


def summary(findings: list[Finding]) -> Table:
    """What both runs were like."""
    table = Table(title=f"{MACHINE} in lockstep")
    table.add_column("")
    for number, _ in enumerate(findings, start=1):
        table.add_column(f"run {number}", justify="right")
    rows = {
        "cycles from power-on to work": [str(f.bring_up) for f in findings],
        "cycles of work": [str(f.cycles) for f in findings],
        "frames on the buses": [str(f.frames) for f in findings],
        "setpoints": [str(f.setpoints) for f in findings],
        "wrong": [str(f.count) for f in findings],
        "processor time a cycle": [
            f"{1e6 * f.cpu / (f.bring_up + f.cycles):.0f} µs" for f in findings
        ],
        "fingerprint": [f.fingerprint[:12] for f in findings],
    }
    for name, cells in rows.items():
        table.add_row(name, *cells)
    return table


def judge(findings: list[Finding]) -> str:
    """Why the runs failed; empty if they did not."""
    if any(finding.count for finding in findings):
        return "Setpoints were not as they must be."
    if len({(f.fingerprint, f.frames, f.bring_up, f.cycles) for f in findings}) > 1:
        return "The two runs differ."
    return ""


if __name__ == "__main__":
    sys.exit(main())
