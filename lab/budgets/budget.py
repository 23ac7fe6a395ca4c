"""The budget of a machine: what is committed in docs/budgets, and how far off a measurement is."""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from turnbuckle.lab.budgets.cycle import Counts
from turnbuckle.lab.budgets.image import Image
from turnbuckle.lab.budgets.stack import stack_of

FOLDER = Path(__file__).parents[3] / "docs" / "budgets"
TOLERANCE = 0.03
"""By which a figure may be off, either way."""
COMMAND = "python -m turnbuckle.lab.budgets"

Figures = Mapping[str, int]
"""By name: instructions and bytes."""
UNITS = {
    "cycle_mean": "instructions",
    "cycle_most": "instructions",
    "step_mean": "instructions",
    "step_most": "instructions",
    "flash": "bytes",
    "memory": "bytes",
    "stack": "bytes",
}
"""Of every figure. A cycle in RUN, the controller step in it; the image of a board; the stack of a
cycle on that."""


def of_counts(counts: Counts) -> dict[str, int]:
    """Figures of cycles in RUN."""
    return {
        "cycle_mean": round(sum(counts.cycles) / len(counts.cycles)),
        "cycle_most": max(counts.cycles),
        "step_mean": round(sum(counts.steps) / len(counts.steps)),
        "step_most": max(counts.steps),
    }


def of_image(image: Image) -> dict[str, int]:
    """Figures of an image."""
    depth, _ = stack_of(image)
    return {"flash": image.flash, "memory": image.memory, "stack": depth}


@dataclass(frozen=True)
class Budget:
    """The figures of a machine on a Cortex-M4F."""

    machine: str
    figures: Figures

    @property
    def path(self) -> Path:
        """Where it is committed."""
        return FOLDER / f"{self.machine}.json"

    def text(self) -> str:
        """What its file holds."""
        figures = {name: {"value": self.figures[name], "unit": UNITS[name]} for name in UNITS}
        content = {"machine": self.machine, "processor": "Cortex-M4F", "figures": figures}
        return json.dumps(content, indent=2) + "\n"

    def complaints(self, measured: Figures) -> list[str]:
        """A sentence for every figure that is off by more than the tolerance."""
        return [
            f"docs/budgets/{self.machine}.json: {name}: found {value} {UNITS[name]}; allowed: "
            f"{self.figures[name]} within {TOLERANCE:.0%}; where that is wanted: {COMMAND}"
            for name, value in measured.items()
            if abs(value - self.figures[name]) > TOLERANCE * self.figures[name]
        ]


def read(path: Path) -> Budget:
    """A committed budget."""
    content = json.loads(path.read_text())
    figures = {name: int(each["value"]) for name, each in content["figures"].items()}
    return Budget(content["machine"], figures)


def committed() -> list[Budget]:
    """All that are committed, by name."""
    return [read(path) for path in sorted(FOLDER.glob("*.json"))]
