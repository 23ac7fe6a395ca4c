"""What tests of the generated C share: the stock machine and its C as committed."""

from __future__ import annotations

import gc
import signal
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
import quick_compiler  # noqa: F401
from hypothesis import HealthCheck, settings

from turnbuckle.codegen.accuracy import Accuracy
from turnbuckle.codegen.accuracy_cache import measured_accuracy
from turnbuckle.codegen.bind import Generated
from turnbuckle.codegen.model import Model, build_model
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine

if TYPE_CHECKING:
    from collections.abc import Iterator

    from journey import Journey
    from running import Lines

ROOT = Path(__file__).parents[1]
STOCK_FILE = ROOT / "machines" / "yoon2023.toml"
STOCK_FOLDER = ROOT / "generated" / "yoon2023"

# A shell that starts the tests in the background lets them, and all they start, ignore interrupts.
signal.signal(signal.SIGINT, signal.default_int_handler)

# What is imported and collected stays to the end: looking it through for garbage only takes time.
gc.disable()


#: Tests that take a minute or more whatever the computer does.
LONG = ("for_a_minute", "test_every_command_of_the_readme")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Long tests come first of the last third, one worker's share: at the end others would wait."""
    long = [item for item in items if any(words in item.name for words in LONG)]
    others = [item for item in items if item not in long]
    place = 2 * len(items) // 3 + 1
    items[:] = [*others[:place], *long, *others[place:]]


def pytest_collection_finish() -> None:
    """From here on what tests leave behind is cleared away."""
    gc.freeze()
    gc.enable()


# The same examples everywhere, and no time limits: a busy machine fails no test.
settings.register_profile(
    "reproducible",
    deadline=None,
    derandomize=True,
    suppress_health_check=[HealthCheck.too_slow],
)
settings.load_profile("reproducible")


@pytest.fixture(scope="session")
def stock_file() -> Path:
    """The stock machine file."""
    return STOCK_FILE


@pytest.fixture(scope="session")
def stock_folder() -> Path:
    """The committed C of the stock machine."""
    return STOCK_FOLDER


@pytest.fixture(scope="session")
def stock() -> Machine:
    """The stock machine."""
    return load_machine(STOCK_FILE)


@pytest.fixture(scope="session")
def stock_model(stock: Machine) -> Model:
    """The symbolic functions of the stock machine, lowered."""
    return build_model(stock)


@pytest.fixture(scope="session")
def stock_accuracies(stock_model: Model) -> dict[str, Accuracy]:
    """The measured errors that the headers of the stock machine state."""
    return measured_accuracy(stock_model.machine, stock_model.items())


@pytest.fixture(scope="session")
def double(stock: Machine, stock_folder: Path) -> Generated:
    """The committed C in double precision."""
    return Generated(stock, stock_folder, "double")


@pytest.fixture(scope="session")
def single(stock: Machine, stock_folder: Path) -> Generated:
    """The committed C in single precision."""
    return Generated(stock, stock_folder, "float")


@pytest.fixture(scope="session")
def journey() -> Journey:
    """The stock machine on its way from power-on to FAULT; brought up once a worker."""
    from journey import Journey, stock

    return Journey(stock())


@pytest.fixture(scope="session")
def program(stock_folder: Path) -> Path:
    """The executable of the stock machine."""
    from turnbuckle.lab.live.program import compile_machine

    return compile_machine(stock_folder)


@pytest.fixture
def lines() -> Iterator[Lines]:
    """A serial line a bus, without drives."""
    from running import silent_lines

    with silent_lines() as lines:
        yield lines
