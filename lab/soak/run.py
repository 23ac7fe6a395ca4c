"""One run of the machine: from power-on to work, and then the demo's task over and over."""

import hashlib
import time
from collections.abc import Callable
from dataclasses import dataclass, field

from turnbuckle.codegen.bind import Generated
from turnbuckle.lab.bus_tap import Fingerprint, SetpointWatch
from turnbuckle.lab.lockstep import Lockstep, State
from turnbuckle.lab.machine_sim import SimulatedMachine
from turnbuckle.lab.soak.order_watch import OrderWatch
from turnbuckle.lab.task import Task
from turnbuckle.model.machine import Plant
from turnbuckle.model.reference.control import base_targets

LONGEST_BRING_UP = 60_000
"""Cycles."""
STRETCH = 1000
"""Cycles between two reports of progress."""
Progress = Callable[[int], None]
"""Told how many cycles of work are done."""


@dataclass
class Finding:
    """What a run was like."""

    bring_up: int = 0  # cycles from power-on to work
    cycles: int = 0  # of work
    setpoints: int = 0
    frames: int = 0
    wrong: list[str] = field(default_factory=list)
    """Setpoints that were lost, doubled, late or other than ordered, and whatever else."""
    count: int = 0
    """How often something was wrong."""
    fingerprint: str = ""
    """Of all frames on the buses and of all that the supervisor told and ordered."""
    cpu: float = 0.0  # s of processor time


class SoakRun:
    """A machine that starts with its bases about the handle, and works until it is told to end."""

    def __init__(self, generated: Generated, plant: Plant, task: Task) -> None:
        self._machine = machine = generated.machine
        rails = base_targets(machine, task.path.at(0.0)[0]).tolist()
        self.lockstep = Lockstep(generated, SimulatedMachine(machine, plant, task, rails))
        self.finding = Finding()
        self._buses = self.lockstep.machine.buses
        self._frames = Fingerprint(self._buses)
        self._orders = hashlib.blake2b(digest_size=16)
        self._setpoints = SetpointWatch(machine)
        self._setpoints.listen(self._buses)

    def run(self, cycles: int, progress: Progress = lambda done: None) -> Finding:
        """Bring the machine up and let it work for so many cycles."""
        begin = time.process_time()
        self.bring_up()
        for done in range(0, cycles, STRETCH):
            self.work(min(STRETCH, cycles - done))
            progress(done)
        finding = self.conclude()
        finding.cpu = time.process_time() - begin
        return finding

    def bring_up(self) -> None:
        """From power-on to work."""
        self.lockstep.bring_up(LONGEST_BRING_UP)
        self.lockstep.machine.begin_task(repeat=True)
        self.finding.bring_up = self.lockstep.cycles
        self._order_watch = OrderWatch(self._machine, self._buses)

    def work(self, cycles: int) -> None:
        """Let it work for so many cycles."""
        lockstep, watch, orders = self.lockstep, self._order_watch, self._orders
        for _ in range(cycles):
            lockstep.cycle()
            view = lockstep.view
            watch(lockstep.cycles, view["ordered"].tolist())
            orders.update(view.tobytes())
        self.finding.cycles += cycles

    def conclude(self) -> Finding:
        """What has been found."""
        finding, lockstep = self.finding, self.lockstep
        watches = self._setpoints, self._order_watch
        finding.wrong = [words for watch in watches for words in watch.findings]
        finding.count = sum(watch.count for watch in watches)
        if lockstep.lost:
            self._complain(f"{lockstep.lost} answers of drives had no room")
        if lockstep.state is not State.RUN or lockstep.view["cause"]:
            self._complain(f"{lockstep.state.name} at the end: cause {int(lockstep.view['cause'])}")
        finding.setpoints = self._setpoints.seen
        finding.frames = self._frames.frames
        finding.fingerprint = self._frames.hexdigest() + self._orders.hexdigest()
        return finding

    def _complain(self, words: str) -> None:
        self.finding.wrong.append(words)
        self.finding.count += 1
