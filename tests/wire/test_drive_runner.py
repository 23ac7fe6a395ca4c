"""Simulated drives in real time, with python-can and python `canopen` as they come.

Simulated time runs faster than real time here (pace < 1), so that the tests are short.
"""

import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import can
import canopen
import pytest
from canopen.profiles.p402 import BaseNode402
from peer import OBJECTS, Bench, map_torque, read

from turnbuckle.lab.drives.power import Power
from turnbuckle.lab.drives.runner import Runner
from turnbuckle.lab.drives.slcan_adapter import SlcanAdapter, decode, encode

PATIENCE = 20.0
"""Time after which a test gives up waiting [s]."""


@contextmanager
def in_real_time(bench: Bench, port: can.BusABC, pace: float) -> Iterator[Runner]:
    """The bench runs behind a port, in its own thread."""
    over = threading.Event()
    runner = Runner(bench, [port], pace)
    thread = threading.Thread(target=runner.run, args=[over.is_set])
    thread.start()
    try:
        yield runner
    finally:
        over.set()
        thread.join()
        port.shutdown()


def wait_until(done: Callable[[], bool]) -> None:
    """Wait until something is so."""
    end = time.monotonic() + PATIENCE
    while not done():
        assert time.monotonic() < end
        time.sleep(0.001)


@pytest.fixture
def network() -> Iterator[canopen.Network]:
    """A master on a virtual bus of python-can, with one drive."""
    bench = Bench()
    with in_real_time(bench, can.Bus("drives", interface="virtual"), pace=0.2):
        network = canopen.Network()
        network.NOTIFIER_CYCLE = 0.01
        network.connect(interface="virtual", channel="drives")
        yield network
        network.disconnect()


def set_up(network: canopen.Network) -> BaseNode402:
    """The drive, operational, with SYNC and setpoints coming all the time."""
    node = BaseNode402(1, OBJECTS.canopen)
    network.add_node(node)
    node.nmt.wait_for_bootup(PATIENCE)
    map_torque(node)
    node.nmt.state = "OPERATIONAL"
    node.setup_402_state_machine()
    network.sync.start(0.002)
    node.rpdo[1].start(0.002)
    return node


def test_the_library_for_cia_402_brings_a_drive_up_and_down(network: canopen.Network) -> None:
    node = set_up(network)
    node.sdo[0x6060].raw = 10
    for state in ("READY TO SWITCH ON", "SWITCHED ON", "OPERATION ENABLED"):
        node.state = state
        assert node.state == state
    node.rpdo[1][0x6071].raw = 100
    wait_until(lambda: node.tpdo[1][0x6077].raw == 100)
    node.state = "SWITCH ON DISABLED"
    node.rpdo[1].stop()
    network.sync.stop()


def test_the_library_homes_a_drive(network: canopen.Network) -> None:
    node = set_up(network)
    node.sdo[0x6098].raw = 37
    node.sdo[0x30B0].raw = 4711
    node.sdo[0x6060].raw = 6
    node.state = "OPERATION ENABLED"
    node.controlword = 0x1F
    wait_until(lambda: node.statusword & 0x3400 == 0x1400)
    assert read(node, 0x6064) == pytest.approx(4711, abs=5)
    node.rpdo[1].stop()
    network.sync.stop()


def test_a_drive_answers_over_a_serial_line() -> None:
    # python-can's own slcan driver at one end of a pseudo-terminal, the simulated bus at the other.
    bench, adapter = Bench(), SlcanAdapter()
    with in_real_time(bench, adapter, pace=1.0) as runner:
        network = canopen.Network()
        network.NOTIFIER_CYCLE = 0.01
        network.connect(
            interface="slcan", channel=adapter.path, bitrate=1_000_000, sleep_after_open=0.0
        )
        node = network.add_node(1, OBJECTS.canopen)
        wait_until(lambda: bench.drive.nmt != 0)
        assert read(node, 0x1018, 1) == 0xFB
        assert node.sdo[0x1008].raw == "Turnbuckle simulated drive"
        node.nmt.state = "OPERATIONAL"
        node.sdo[0x6040].raw = 6
        assert bench.drive.servo.power is Power.READY
        network.disconnect()
    assert runner.skipped >= 0


def test_a_simulation_that_falls_behind_gives_cycles_up_and_counts_them() -> None:
    bench = Bench()
    late = iter([False] * 3 + [True])

    def slow() -> bool:
        time.sleep(0.1)
        return next(late)

    port = can.Bus("behind", interface="virtual")
    runner = Runner(bench, [port])
    runner.run(slow)
    port.shutdown()
    assert runner.skipped > 50 and bench.drive.time < 0.1


@pytest.mark.parametrize(
    "line", [b"t1232AABB", b"t0800", b"T1234567881122334455667788", b"r7010", b"R000000012"]
)
def test_a_frame_and_its_line_are_the_same(line: bytes) -> None:
    frame = decode(line)
    assert frame is not None and encode(frame) == line + b"\r"


@pytest.mark.parametrize(
    "line", [b"t", b"t12", b"t123", b"t1239", b"t1232AA", b"t1232AABBCC", b"tXYZ0"]
)
def test_a_line_that_is_no_frame_is_none(line: bytes) -> None:
    assert decode(line) is None


def test_frames_that_are_not_canopen_are_not_for_drives() -> None:
    bench = Bench()
    port = can.Bus("strange", interface="virtual")
    peer = can.Bus("strange", interface="virtual")
    runner = Runner(bench, [port], pace=0.1)
    peer.send(can.Message(arbitration_id=0, data=b"\x81\0", is_extended_id=True))
    peer.send(can.Message(arbitration_id=0x601, is_remote_frame=True, dlc=8, is_extended_id=False))
    wait = iter([False] * 2000)
    runner.run(lambda: bench.drive.nmt != 0 or next(wait))
    for each in (port, peer):
        each.shutdown()
    assert bench.drive.nmt == 0x7F
