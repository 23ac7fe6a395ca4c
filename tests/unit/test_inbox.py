"""What other programs wish, as the control loop reads it: runtime/port/linux/inbox.h."""

import ctypes
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from turnbuckle.codegen.compile import compile_library
from turnbuckle.lab.live.program import FOLDERS
from turnbuckle.places import RUNTIME

ARM, STOP, RESET = 1, 2, 4
FORCE_CYCLES = 20
"""TB_FORCE_CYCLES"""

FORCE = np.dtype([("sequence", "u8"), ("age", "u4"), ("value", "f8", 2)], align=True)
MEMORY = np.dtype(
    [("arm", "u4"), ("stop", "u4"), ("reset", "u4"), ("force", FORCE), ("hand", FORCE)], align=True
)
WISHES = np.dtype(
    [("requests", "u4"), ("hand_force_fresh", "u4"), ("force", "f8", 2), ("hand_force", "f8", 2)],
    align=True,
)
SHARED = np.dtype(
    [
        *((name, "u4") for name in ("arm", "stop", "reset", "reserved")),
        ("force_sequence", "u8"),
        ("force", "f8", 2),
        ("hand_sequence", "u8"),
        ("hand_force", "f8", 2),
    ],
    align=True,
)


class Inbox:
    """The C, with the memory it reads from and the memory it keeps."""

    def __init__(self, folder: Path) -> None:
        sources = [RUNTIME / "port" / "linux" / "inbox.c"]
        self._library = ctypes.CDLL(str(compile_library(sources, [folder, *FOLDERS])))
        self._memory = np.zeros(1, MEMORY)
        self.shared = np.zeros(1, SHARED)[0]

    def read(self) -> Any:
        """The wishes of the next cycle."""
        wishes = np.full(1, 0xAA, "u1").repeat(WISHES.itemsize).view(WISHES)
        shared = self.shared.reshape(1)
        arguments = [ctypes.c_void_p(each.ctypes.data) for each in (self._memory, shared, wishes)]
        self._library.tb_inbox_read(*arguments)
        return wishes[0]

    def push(self, which: str, force: list[float]) -> None:
        """Write a force as another program does."""
        self.shared[f"{which}_sequence"] += 1
        self.shared["force" if which == "force" else "hand_force"] = force
        self.shared[f"{which}_sequence"] += 1


@pytest.fixture
def inbox(stock_folder: Path) -> Inbox:
    """An inbox that nobody has written to."""
    return Inbox(stock_folder)


def test_an_untouched_inbox_wishes_nothing(inbox: Inbox) -> None:
    for _ in range(2 * FORCE_CYCLES):
        wishes = inbox.read()
        assert wishes["requests"] == 0
        assert wishes["hand_force_fresh"] == 0
        assert not wishes["force"].any() and not wishes["hand_force"].any()


@pytest.mark.parametrize(("name", "bit"), [("arm", ARM), ("stop", STOP), ("reset", RESET)])
def test_a_request_is_seen_in_one_cycle_and_no_more(inbox: Inbox, name: str, bit: int) -> None:
    inbox.read()
    inbox.shared[name] += 1
    assert [inbox.read()["requests"] for _ in range(3)] == [bit, 0, 0]
    inbox.shared[name] -= 1  # any change asks: counters wrap
    assert inbox.read()["requests"] == bit


def test_requests_of_one_cycle_come_together(inbox: Inbox) -> None:
    for name in ("arm", "stop", "reset"):
        inbox.shared[name] += 1
    assert inbox.read()["requests"] == ARM | STOP | RESET


def test_a_force_counts_for_its_cycles_and_then_no_more(inbox: Inbox) -> None:
    inbox.push("force", [2.0, -1.0])
    seen = [inbox.read()["force"].tolist() for _ in range(FORCE_CYCLES + 2)]
    assert seen == [[2.0, -1.0]] * FORCE_CYCLES + [[0.0, 0.0]] * 2


def test_a_force_that_is_written_again_stays(inbox: Inbox) -> None:
    for _ in range(3 * FORCE_CYCLES):
        inbox.push("hand", [0.5, 0.25])
        wishes = inbox.read()
        assert wishes["hand_force_fresh"] == 1
        assert wishes["hand_force"].tolist() == [0.5, 0.25]
        assert not wishes["force"].any()


def test_the_hand_is_unknown_when_its_sensor_is_silent(inbox: Inbox) -> None:
    inbox.push("hand", [0.5, 0.25])
    fresh = [int(inbox.read()["hand_force_fresh"]) for _ in range(FORCE_CYCLES + 2)]
    assert fresh == [1] * FORCE_CYCLES + [0, 0]


def test_a_force_that_is_being_written_leaves_the_one_before(inbox: Inbox) -> None:
    inbox.push("force", [1.0, 1.0])
    inbox.read()
    inbox.shared["force_sequence"] += 1
    inbox.shared["force"] = [9.0, 1.0]
    assert inbox.read()["force"].tolist() == [1.0, 1.0]
    inbox.shared["force"] = [9.0, 9.0]
    inbox.shared["force_sequence"] += 1
    assert inbox.read()["force"].tolist() == [9.0, 9.0]


def test_a_writer_that_dies_while_writing_leaves_no_force_behind(inbox: Inbox) -> None:
    inbox.push("force", [1.0, 1.0])
    inbox.shared["force_sequence"] += 1
    for _ in range(FORCE_CYCLES + 1):
        wishes = inbox.read()
    assert not wishes["force"].any()
