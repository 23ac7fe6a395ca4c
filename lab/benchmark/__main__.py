"""Runs the benchmark: prints the ratios, writes build/bench.json."""

from rich.console import Console

from turnbuckle.lab.benchmark.cortex_m4.comparison import count_instructions
from turnbuckle.lab.benchmark.cycle.cost import cycle_costs
from turnbuckle.lab.benchmark.map.comparison import compare_maps
from turnbuckle.lab.benchmark.native import ROOT
from turnbuckle.lab.benchmark.report import Results, show, write_json
from turnbuckle.lab.benchmark.step.comparison import compare_steps
from turnbuckle.lab.benchmark.table1 import compare_table1
from turnbuckle.lab.benchmark.targets import targets
from turnbuckle.lab.benchmark.tension import all_solvers, compare
from turnbuckle.lab.benchmark.tension_problems import tension_problems
from turnbuckle.model.reading import load_machine

MACHINE, SQUARE = "yoon2023", "brau_square"
SEED = 20231
#: Many problems: of a few the branch predictor would learn every one.
PROBLEMS, REPETITIONS = 10_000, 15
#: Calls that are counted on the emulated microcontroller.
CALLS = 32


def main() -> None:
    """Measure, print, write."""
    machine, square = (load_machine(ROOT / "machines" / f"{m}.toml") for m in (MACHINE, SQUARE))
    generated = ROOT / "generated" / MACHINE
    console = Console()
    with console.status("timing the tension solve"):
        solvers = all_solvers(machine, generated)
        problems = tension_problems(machine, PROBLEMS, SEED)
        tension = [compare(solvers, each, REPETITIONS) for each in problems]
    with console.status("timing Brau Table 1"):
        table1 = compare_table1(square)
    with console.status("timing the controller step"):
        step = compare_steps(machine, generated, PROBLEMS, REPETITIONS)
    with console.status("timing the control cycle"):
        cycles = cycle_costs(machine, generated, PROBLEMS, REPETITIONS)
    with console.status("counting instructions on a Cortex-M4F"):
        counts = count_instructions(machine, generated, CALLS, SEED)
    with console.status("timing the map"):
        maps = compare_maps(machine, generated, REPETITIONS)
    promised = targets(tension, table1, step, cycles, maps)
    results = Results(MACHINE, tension, table1, step, cycles, counts, maps, promised)
    show(results, console)
    write_json(results, ROOT / "build" / "bench.json")


if __name__ == "__main__":
    main()
