"""The program before adapters and drives by another hand: every dialect of the adapters' text."""

import signal
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from peer_drives import Acknowledgement, Bus, BusVariation, Variation
from peer_line import PeerLine
from peer_machine import NANO, PeerMachine, proof
from running import BUSES, Running, running
from test_master_and_peer import COUNTS, DEPTH, WALL, into_the_wall

from turnbuckle.lab.drives.simulated_clock import SimulatedClock
from turnbuckle.lab.live.program import compile_machine
from turnbuckle.lab.live.telemetry import Telemetry
from turnbuckle.lab.lockstep import State
from turnbuckle.model.machine import Machine

RUN, FAULT = State.RUN, State.FAULT
PIECE = round(20e-6 / NANO)
PRESSED = 1300
"""Cycles in which the hand has gone into the wall."""
DIALECTS = {
    "first": (
        BusVariation(lower_case=True, line_feed=True),
        BusVariation(pieces=True, piece_delay=PIECE, acknowledgement=Acknowledgement.NONE),
        BusVariation(stale=True, acknowledgement=Acknowledgement.CR, timestamps=True),
    ),
    "second": (
        BusVariation(acknowledgement=Acknowledgement.NONE, timestamps=True, line_feed=True),
        BusVariation(stale=True, lower_case=True, echo_frames=True),
        BusVariation(pieces=True, piece_delay=PIECE, line_feed=True, latency=round(30e-6 / NANO)),
    ),
}


class World(PeerMachine):
    """What lies behind the lines; the hand begins when the machine works."""

    def __init__(self, machine: Machine, dialects: tuple[BusVariation, ...]) -> None:
        buses = [
            Bus(bit_rate=round(bus.bit_rate), adapter=True, variation=dialect)
            for bus, dialect in zip(machine.buses, dialects, strict=True)
        ]
        timing = proof(machine, worst=False)  # which knows nothing of what an adapter adds
        super().__init__(machine, into_the_wall(machine), buses=buses, timing=timing, counts=COUNTS)
        self.lines = [PeerLine(self.peer, number) for number in range(len(buses))]
        self.buses = self.lines  # type: ignore[assignment]
        self.deepest = 0.0
        self.telemetry: Telemetry | None = None

    def run_until(self, time: float) -> None:
        """Let time pass; look at what the program does."""
        super().run_until(time)
        cycle = self.telemetry.latest() if self.telemetry else None
        if cycle is not None and cycle["state"] == RUN:
            self.begin_task()
            self.deepest = max(self.deepest, self.world.position[0] - WALL)


@contextmanager
def behind_lines(world: World) -> Iterator[list[str]]:
    """The options of a program; the simulation runs while the context lasts."""
    clock = SimulatedClock(world, world.lines)  # type: ignore[arg-type]
    over = threading.Event()
    keeper = threading.Thread(target=lambda: clock.run(over.is_set))
    keeper.start()
    names = zip(BUSES, world.lines, strict=True)
    try:
        buses = [f"--bus={name}=slcan:{line.path}" for name, line in names]
        yield [*buses, f"--clock={clock.path}"]
    finally:
        over.set()
        keeper.join()
        clock.close()
        for line in world.lines:
            line.shutdown()


@pytest.fixture(scope="module")
def program(stock_folder: Path) -> Path:
    """The executable of the stock machine."""
    return compile_machine(stock_folder)


def await_work(run: Running) -> None:
    """Wait until the machine works; one that has stopped never will."""
    while (state := int(run.latest()["state"])) != RUN:
        assert state != FAULT and run.process.poll() is None, run.telemetry.status()["doing"]
        time.sleep(0.005)


@pytest.mark.parametrize("dialect", DIALECTS)
def test_adapters_of_every_dialect_carry_a_machine_to_work_and_back(
    stock: Machine, program: Path, dialect: str
) -> None:
    world = World(stock, DIALECTS[dialect])
    with behind_lines(world) as options, running(program, [*options, "--arm"]) as run:
        world.telemetry = run.telemetry
        await_work(run)
        run.await_cycles(PRESSED)
        status, out, err = run.end(signal.SIGTERM)
    assert status == 0, err
    assert world.deepest > 0.2e-3 and world.deepest < DEPTH / 2
    assert out.count(" 0 malformed,") == len(BUSES), out
    assert all(world.peer.torque(number) == 0.0 for number in range(8))


def test_a_program_names_the_drive_that_is_not_under_remote_control(
    stock: Machine, program: Path
) -> None:
    world = World(stock, DIALECTS["first"])
    world.peer.vary(6, Variation(remote_clear=True))
    with behind_lines(world) as options, running(program, [*options, "--arm"]) as run:
        run.await_state(FAULT)
        status, _, err = run.end(signal.SIGTERM)
    assert status == 1
    assert "base_3 (bus base, node 3): is not under remote control" in err
