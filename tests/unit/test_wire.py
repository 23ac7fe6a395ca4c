"""Time on the simulated wire: lengths of frames, turns, delays, repetitions, foreign frames."""

from itertools import pairwise
from random import Random

import pytest

from turnbuckle.lab.drives.bus import SimulatedBus
from turnbuckle.lab.drives.node import Frame
from turnbuckle.lab.drives.setup import Setup
from turnbuckle.lab.drives.wire import Conditions, Wire, exact_bits, wires
from turnbuckle.model.bus.frames import RPDO, SYNC, TPDO
from turnbuckle.model.bus.plan import bus_plans
from turnbuckle.model.bus.response import frame_bits
from turnbuckle.model.machine import Machine

BIT = 1e-6
PERIOD = 1e-3


def crc15(bits: str) -> str:
    """By long division with x^15 + x^14 + x^10 + x^8 + x^7 + x^4 + x^3 + 1 (ISO 11898-1)."""
    rest = int(bits + "0" * 15, 2)
    for place in range(len(bits) - 1, -1, -1):
        if rest >> (place + 15) & 1:
            rest ^= 0b1100010110011001 << place
    return f"{rest:015b}"


def stuffed(bits: str) -> str:
    """A complement after every five equal bits, the complements counted in."""
    sent = ""
    for bit in bits:
        sent += bit
        if len(sent) >= 5 and len(set(sent[-5:])) == 1:
            sent += "1" if bit == "0" else "0"
    return sent


def spelled_out(frame: Frame) -> int:
    """Bits of a frame, one by one: the slow way."""
    data = "".join(f"{byte:08b}" for byte in frame.data)
    begin = f"0{frame.cob:011b}000{len(frame.data):04b}{data}"
    return len(stuffed(begin + crc15(begin))) + len("1" + "11" + "1111111" + "111")


def test_a_frame_is_as_long_as_its_bits_spelled_out() -> None:
    chance = Random(3)
    for _ in range(2000):
        choices = (0, 255, chance.randrange(256))
        data = bytes(chance.choice(choices) for _ in range(chance.randrange(9)))
        frame = Frame(chance.choice((0, 0x7FF, chance.randrange(2048))), data)
        assert exact_bits(frame) == spelled_out(frame)


def test_no_frame_is_longer_than_the_bus_proof_takes_it_to_be() -> None:
    chance = Random(4)
    extra = []
    for size in range(9):
        frames = [Frame(chance.randrange(2048), bytes(size))]
        frames += [Frame(0x078, bytes([0x3C] * size)), Frame(0x0F8, bytes([0xC3] * size))]
        frames += [Frame(chance.randrange(2048), chance.randbytes(size)) for _ in range(500)]
        lengths = [exact_bits(frame) for frame in frames]
        assert 47 + 8 * size <= min(lengths) and max(lengths) <= frame_bits(size)
        extra.append(max(lengths) - (47 + 8 * size))
    assert max(extra) >= 15  # stuff bits were among them


class Ear:
    """When which frame had arrived."""

    def __init__(self, bus: SimulatedBus) -> None:
        self.heard: list[tuple[float, int]] = []
        bus.listeners.append(lambda frame, _: self.heard.append((bus.time, frame.cob)))


def bus_with(*nodes: int, delay: float = 0.0, **conditions: object) -> SimulatedBus:
    """Drives on a wire of 1 Mbit/s."""
    wire = Wire(1e6, delay, PERIOD, Conditions(**conditions))  # type: ignore[arg-type]
    return SimulatedBus("bus", [Setup(node) for node in nodes], wire)


def test_frames_go_out_one_after_the_other_the_most_urgent_first() -> None:
    bus = bus_with(worst=True)
    ear = Ear(bus)
    for cob in (0x703, 0x081, 0x301, 0x701):
        bus.intrude(Frame(cob, b""))
    bus.run_until(2 * PERIOD)
    assert [cob for _, cob in ear.heard] == sorted(cob for _, cob in ear.heard)
    gaps = [b - a for (a, _), (b, _) in pairwise(ear.heard)]
    assert min(gaps) >= 55 * BIT - 1e-12


def test_a_frame_on_the_wire_is_not_interrupted() -> None:
    bus = bus_with()
    ear = Ear(bus)
    bus.send(Frame(0x7E5, bytes(8)))
    bus.run_until(10 * BIT)
    bus.send(Frame(0x000, b"\x01\x00"))
    bus.run_until(PERIOD)
    assert [cob for _, cob in ear.heard] == [0x7E5, 0x000]
    assert ear.heard[0][0] == pytest.approx(exact_bits(Frame(0x7E5, bytes(8))) * BIT)


def test_frames_of_the_master_keep_their_order() -> None:
    bus = bus_with()
    ear = Ear(bus)
    for cob in (0x77F, 0x601, 0x201):
        bus.send(Frame(cob, b"\x05"))
    bus.run_until(PERIOD)
    assert [cob for _, cob in ear.heard] == [0x77F, 0x601, 0x201]


def test_a_frame_that_is_destroyed_is_sent_again() -> None:
    ordinary, disturbed = bus_with(), bus_with(errors=1.0)
    arrivals = []
    for bus in (ordinary, disturbed):
        ear = Ear(bus)
        bus.send(Frame(0x201, bytes(4)))
        bus.run_until(PERIOD)
        arrivals.append(ear.heard[0][0])
    bits = exact_bits(Frame(0x201, bytes(4)))
    assert arrivals == pytest.approx([bits * BIT, (2 * bits + 31) * BIT])


def test_frames_wait_for_the_time_when_they_are_ready() -> None:
    bus = bus_with()
    bus.send(Frame(0x080, b""), after=300 * BIT)
    bus.run_until(300 * BIT)
    ear = Ear(bus)
    bus.run_until(PERIOD)
    assert ear.heard[0][0] == pytest.approx(300 * BIT + exact_bits(Frame(0x080, b"")) * BIT)


def test_without_a_wire_frames_take_no_time() -> None:
    bus = SimulatedBus("bus", [Setup(1)])
    bus.drives[0].step(0.3)
    assert [frame.cob for frame in bus.take()] == [0x701]


def test_drives_answer_after_their_delay_and_at_the_worst_as_late_as_the_proof_says(
    stock: Machine,
) -> None:
    for wire, plan in zip(wires(stock, Conditions(worst=True)), bus_plans(stock), strict=True):
        bus = SimulatedBus("bus", [], wire)
        ear = Ear(bus)
        drives = plan.load.drives
        bus.send(Frame(SYNC, b""))
        for drive in drives:
            bus.intrude(Frame(TPDO + drive.node, bytes(8)))
        bus.run_until(5 * PERIOD)
        assert ear.heard[-1][0] <= plan.phases.answers + 1e-9
        assert ear.heard[-1][0] >= plan.phases.answers - wire.answer_delay - 1e-9


def test_a_foreign_frame_comes_first_only_when_no_other_is_there() -> None:
    first = []
    for heartbeat in (False, True):
        bus = bus_with(worst=True)
        ear = Ear(bus)
        if heartbeat:
            bus.intrude(Frame(0x701, b"\x05"))
        bus.send(Frame(SYNC, b""))
        bus.run_until(5 * PERIOD)
        first.append(next(time for time, cob in ear.heard if cob == SYNC))
    assert first == pytest.approx([(frame_bits(8) + frame_bits(0)) * BIT, frame_bits(0) * BIT])


def test_delays_differ_from_seed_to_seed_and_are_the_same_for_the_same() -> None:
    def arrival(seed: int) -> float:
        bus = bus_with(delay=40e-6, seed=seed)
        ear = Ear(bus)
        bus.intrude(Frame(TPDO + 1, bytes(8)))
        bus.run_until(PERIOD)
        return ear.heard[0][0]

    assert arrival(1) == arrival(1) != arrival(2)


def test_commands_of_the_master_are_through_before_the_next_sync(stock: Machine) -> None:
    for wire, plan in zip(wires(stock, Conditions(worst=True)), bus_plans(stock), strict=True):
        bus = SimulatedBus("bus", [], wire)
        ear = Ear(bus)
        bus.run_until(plan.phases.computed)
        for drive in plan.load.drives:
            bus.send(Frame(RPDO + drive.node, bytes(4)))
        bus.run_until(plan.load.divider / stock.control.rate)
        assert len(ear.heard) == len(plan.load.drives)
