"""Functions outside a machine's model, printed, compiled and loaded like the model's own."""

from codegen.accuracy import Accuracy
from codegen.bind import Generated, folder_of
from codegen.composite import Item
from codegen.generate import Model, render
from model.machine import Machine


class OnlyItems(Model):
    """Functions that no other name stands for."""

    def aliases(self) -> dict[str, str]:
        return {}


def built(machine: Machine, items: list[Item], precision: str) -> Generated:
    """The C of some functions, without a measured accuracy."""
    model = OnlyItems(machine, {"tension": items})
    files = render(model, {item.function.name: Accuracy() for item in items})
    return Generated(machine, folder_of(machine, files), precision)
