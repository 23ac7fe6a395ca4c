"""Writes the vectors of the stock machines: tests/target/vectors/<machine>.txt."""

from pathlib import Path

from turnbuckle.codegen.bind import Generated
from turnbuckle.codegen.compile import PRECISIONS
from turnbuckle.lab.vectors.platforms import HOST
from turnbuckle.lab.vectors.sample import arguments, with_results
from turnbuckle.lab.vectors.vectors import Vectors, write
from turnbuckle.model.files import write_whole
from turnbuckle.model.reading import load_machine

ROOT = Path(__file__).parents[3]
FOLDER = ROOT / "tests" / "target" / "vectors"


def computed(generated: Generated) -> Vectors:
    """Vectors of a machine in one precision, as this computer computes them."""
    asked = arguments(generated)
    given = HOST[generated.precision].answer(generated.folder, asked.stream())
    return with_results(asked, generated, given)


def main() -> None:
    """Write all."""
    for file in sorted((ROOT / "machines").glob("*.toml")):
        machine = load_machine(file)
        folder = ROOT / "generated" / machine.name
        vectors = {each: computed(Generated(machine, folder, each)) for each in PRECISIONS}
        path = FOLDER / f"{machine.name}.txt"
        write_whole(path, write(machine.name, vectors))
        print(f"{path.relative_to(ROOT)}: {sum(each.count for each in vectors.values())} results")


if __name__ == "__main__":
    main()
