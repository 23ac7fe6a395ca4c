"""The bus in memory: order, room, faults; a copy of it is a second bus."""

import ctypes

import can
from can_ports import Frame, Loopback, Result, State, frame_of, same
from frames import any_frames
from hypothesis import given
from hypothesis import strategies as st

DEPTH = 64


def frame(number: int) -> can.Message:
    return can.Message(arbitration_id=number, data=[number % 256], is_extended_id=False)


@given(st.lists(any_frames(), max_size=DEPTH))
def test_frames_cross_unchanged_and_in_order(messages: list[can.Message]) -> None:
    bus = Loopback()
    for message in messages:
        assert bus.send(message) is Result.OK
        assert bus.give(message) is Result.OK
    arrived = list(bus.waiting())
    taken = [bus.take() for _ in messages]
    assert len(arrived) == len(messages)
    for sent, here, there in zip(messages, arrived, taken, strict=True):
        assert isinstance(there, can.Message)
        assert same(sent, here) and same(sent, there)
    assert bus.receive() is Result.EMPTY and bus.take() is Result.EMPTY
    assert bus.statistics.sent == bus.statistics.received == len(messages)


@given(st.lists(st.sampled_from(["send", "take", "give", "receive"]), max_size=400))
def test_any_order_of_calls_is_a_pair_of_queues(calls: list[str]) -> None:
    bus = Loopback()
    queues: dict[str, list[int]] = {"sent": [], "arrived": []}
    for number, call in enumerate(calls):
        queue = queues["sent" if call in ("send", "take") else "arrived"]
        if call in ("send", "give"):
            room = len(queue) < DEPTH
            answer = bus.send(frame(number)) if call == "send" else bus.give(frame(number))
            assert answer is (Result.OK if room else Result.FULL)
            queue += [number] * room
        else:
            found = bus.take() if call == "take" else bus.receive()
            if queue:
                assert isinstance(found, can.Message) and found.arbitration_id == queue.pop(0)
            else:
                assert found is Result.EMPTY


def test_what_has_no_room_is_refused_or_lost_and_counted() -> None:
    bus = Loopback()
    for number in range(DEPTH + 3):
        bus.send(frame(number))
        bus.give(frame(number))
    assert bus.statistics.sent == DEPTH
    assert bus.statistics.refused == bus.statistics.lost == 3


def test_a_full_bus_refuses_until_it_is_full_no_longer() -> None:
    bus = Loopback()
    bus.set_full(True)
    assert bus.send(frame(1)) is Result.FULL
    assert bus.take() is Result.EMPTY
    bus.set_full(False)
    assert bus.send(frame(2)) is Result.OK
    assert bus.statistics.refused == 1


def test_a_bus_that_is_off_carries_nothing_and_can_come_back() -> None:
    bus = Loopback()
    for state in (State.ERROR_WARNING, State.ERROR_PASSIVE):
        bus.set_state(state)
        assert bus.state is state and bus.send(frame(1)) is Result.OK
    bus.set_state(State.BUS_OFF)
    bus.set_state(State.BUS_OFF)
    assert bus.send(frame(2)) is Result.FULL and bus.give(frame(2)) is Result.CLOSED
    bus.set_state(State.ERROR_ACTIVE)
    assert bus.send(frame(3)) is Result.OK
    assert bus.statistics.bus_off == 1 and bus.statistics.refused == 1


def test_a_closed_bus_stays_closed_and_holds_nothing() -> None:
    bus = Loopback()
    bus.send(frame(1))
    bus.give(frame(1))
    bus.close()
    bus.close()
    bus.set_state(State.ERROR_ACTIVE)
    assert bus.state is State.NOT_OPEN
    assert bus.send(frame(2)) is bus.receive() is bus.give(frame(2)) is Result.CLOSED
    assert bus.take() is Result.EMPTY


def test_what_is_no_frame_is_refused() -> None:
    bus = Loopback()
    assert bus.send_frame(Frame(0x800, 0, 0)) is Result.REFUSED
    assert bus.take() is Result.EMPTY


def test_statistics_stop_at_their_largest_value() -> None:
    bus = Loopback()
    bus.statistics.sent = bus.statistics.refused = 2**32 - 1
    bus.send(frame(1))
    bus.set_full(True)
    bus.send(frame(2))
    assert bus.statistics.sent == bus.statistics.refused == 2**32 - 1


def test_bits_are_those_that_frames_take_on_the_bus() -> None:
    bus = Loopback()
    for message, bits in (
        (can.Message(arbitration_id=1, is_extended_id=False), 47),
        (can.Message(arbitration_id=1, is_extended_id=False, data=range(8)), 111),
        (can.Message(arbitration_id=1, is_extended_id=False, is_remote_frame=True, dlc=8), 47),
        (can.Message(arbitration_id=1, data=range(8)), 131),
    ):
        before = bus.statistics.bits
        bus.send(message)
        assert bus.statistics.bits == before + bits
        bus.give(message)
        bus.receive()
        assert bus.statistics.bits == before + 2 * bits
    bus.set_full(True)
    bus.send(frame(1))
    assert bus.statistics.bits == 2 * (47 + 111 + 47 + 131)


def test_a_copy_is_a_second_bus_in_the_same_state() -> None:
    bus, fork = Loopback(), Loopback()
    bus.send(frame(1))
    bus.give(frame(2))
    ctypes.memmove(fork.memory, bus.memory, ctypes.sizeof(bus.memory))
    bus.send(frame(3))
    arrived, taken = fork.receive(), fork.take()
    assert isinstance(arrived, can.Message) and same(arrived, frame(2))
    assert isinstance(taken, can.Message) and same(taken, frame(1))
    assert fork.take() is Result.EMPTY
    assert fork.statistics.sent == 1 and bus.statistics.sent == 2


def test_a_frame_as_the_runtime_has_it_is_72_bytes() -> None:
    assert ctypes.sizeof(frame_of(frame(1))) == 72
