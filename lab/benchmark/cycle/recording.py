"""What a master hears from power-on to work, recorded in lockstep, to be run without drives."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from turnbuckle.codegen.bind import Generated
from turnbuckle.lab.demo import plan_task, plant_of
from turnbuckle.lab.lockstep import Lockstep, State
from turnbuckle.lab.machine_sim import SimulatedMachine
from turnbuckle.model.reference.control import base_targets

LONGEST_BRING_UP = 60_000


@dataclass(frozen=True)
class Cycles:
    """Cycles one after the other: what was wished, and the frames that came."""

    wishes: NDArray[np.void]
    arrived: NDArray[np.uint32]  # (k, 2): when the answers were read, and by the cycle's end
    frames: bytes
    end: bytes
    """What is to be seen of the last of them."""


class Recorder:
    """A machine in lockstep, and all that its master hears."""

    def __init__(self, generated: Generated) -> None:
        task = plan_task(generated)
        rails = base_targets(generated.machine, task.path.at(0.0)[0]).tolist()
        plant = plant_of(generated.machine)
        machine = SimulatedMachine(generated.machine, plant, task, rails)
        self._lockstep = Lockstep(generated, machine)
        self._counts: list[int] = []
        self._forget()
        self._lockstep.arrivals.append(self._keep_frames)

    def bring_up(self) -> Cycles:
        """From power-on to work."""
        while self._lockstep.state is not State.RUN and len(self._wishes) < LONGEST_BRING_UP:
            self._lockstep.bring_up(1)
            self._keep()
        self._lockstep.machine.begin_task(repeat=True)
        return self._kept()

    def work(self, cycles: int) -> Cycles:
        """So many cycles of work."""
        for _ in range(cycles):
            self._lockstep.cycle()
            self._keep()
        return self._kept()

    def _forget(self) -> None:
        self._wishes: list[np.void] = []
        self._arrived: list[tuple[int, int]] = []
        self._frames: list[bytes] = []

    def _keep(self) -> None:
        """A cycle is over."""
        self._wishes.append(self._lockstep.wishes.copy())
        answers, others = self._counts
        self._arrived.append((answers, others))
        self._counts.clear()

    def _kept(self) -> Cycles:
        kept = Cycles(
            np.array(self._wishes),
            np.array(self._arrived, np.uint32),
            b"".join(self._frames),
            self._lockstep.view.tobytes(),
        )
        self._forget()
        return kept

    def _keep_frames(self, packed: Sequence[bytes]) -> None:
        self._counts.append(len(packed))
        self._frames += packed
