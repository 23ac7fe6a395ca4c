"""Runs the benchmark: prints the ratios, writes build/bench.json."""

from rich.console import Console

from lab.benchmark.cortex_m4.comparison import count_instructions
from lab.benchmark.map.comparison import compare_maps
from lab.benchmark.native import ROOT
from lab.benchmark.report import Results, show, write_json
from lab.benchmark.step.comparison import compare_steps
from lab.benchmark.targets import targets
from lab.benchmark.tension import all_solvers, compare
from lab.benchmark.tension_problems import tension_problems
from model.machine import load_machine

MACHINE = "yoon2023"
SEED = 20231
#: Many problems: of a few the branch predictor would learn every one.
PROBLEMS, REPETITIONS = 10_000, 15
#: Calls that are counted on the emulated microcontroller.
CALLS = 32


def main() -> None:
    """Measure, print, write."""
    machine = load_machine(ROOT / "machines" / f"{MACHINE}.toml")
    generated = ROOT / "generated" / MACHINE
    console = Console()
    with console.status("timing the tension solve"):
        solvers = all_solvers(machine, generated)
        problems = tension_problems(machine, PROBLEMS, SEED)
        tension = [compare(solvers, each, REPETITIONS) for each in problems]
    with console.status("timing the controller step"):
        step = compare_steps(machine, generated, PROBLEMS, REPETITIONS)
    with console.status("counting instructions on a Cortex-M4F"):
        counts = count_instructions(machine, generated, CALLS, SEED)
    with console.status("timing the map"):
        maps = compare_maps(machine, generated, REPETITIONS)
    results = Results(MACHINE, tension, step, counts, maps, targets=targets(tension, step, maps))
    show(results, console)
    write_json(results, ROOT / "build" / "bench.json")


if __name__ == "__main__":
    main()
