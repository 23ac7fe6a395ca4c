"""Python canopen judges the drives by another hand: as their master, and as a drive beside them."""

from __future__ import annotations

import random
import struct
from collections.abc import Callable
from typing import Any

import can
import canopen
import pytest
from canopen import objectdictionary as od
from canopen.profiles.p402 import BaseNode402
from canopen.sdo.exceptions import SdoAbortedError
from peer_bench import CST, Bench, drive, varied
from peer_drives import (
    MILLISECOND,
    Acknowledgement,
    Bus,
    BusVariation,
    Frame,
    Library,
    PeerDrives,
    Power,
    Upload,
)

VARIABLES: dict[int, tuple[str, int]] = {
    0x1000: ("device type", od.UNSIGNED32),
    0x1001: ("error register", od.UNSIGNED8),
    0x1008: ("name", od.VISIBLE_STRING),
    0x1017: ("producer heartbeat time", od.UNSIGNED16),
    0x6040: ("controlword", od.UNSIGNED16),
    0x6041: ("statusword", od.UNSIGNED16),
    0x6060: ("mode", od.INTEGER8),
    0x6061: ("mode display", od.INTEGER8),
    0x6064: ("position", od.INTEGER32),
    0x6071: ("target torque", od.INTEGER16),
    0x6077: ("torque", od.INTEGER16),
    0x607A: ("target position", od.INTEGER32),
    0x6098: ("homing method", od.INTEGER8),
    0x6502: ("supported modes", od.UNSIGNED32),
}
READ_ONLY = (0x1000, 0x1001, 0x1008, 0x6041, 0x6061, 0x6064, 0x6077, 0x6502)
ENTRIES = [od.UNSIGNED8, *[od.UNSIGNED32] * 12]
RECORDS: dict[int, list[int]] = {
    0x1016: [od.UNSIGNED8, od.UNSIGNED32, od.UNSIGNED32],
    0x1018: [od.UNSIGNED8, *[od.UNSIGNED32] * 4],
    **{0x1400 + n: [od.UNSIGNED8, od.UNSIGNED32, od.UNSIGNED8] for n in range(4)},
    **{0x1600 + n: ENTRIES for n in range(4)},
    **{0x1800 + n: [od.UNSIGNED8, od.UNSIGNED32, od.UNSIGNED8, od.UNSIGNED16] for n in range(4)},
    **{0x1A00 + n: ENTRIES for n in range(4)},
}


def dictionary() -> Any:
    """Objects of a drive as canopen knows them."""
    objects = od.ObjectDictionary()
    for index, (name, kind) in VARIABLES.items():
        variable = od.ODVariable(name, index)
        variable.data_type = kind
        variable.access_type = "ro" if index in READ_ONLY else "rw"
        objects.add_object(variable)
    for index, kinds in RECORDS.items():
        record = od.ODRecord(f"record {index:04X}", index)
        for sub, kind in enumerate(kinds):
            member = od.ODVariable(f"part {sub}", index, sub)
            member.data_type = kind
            member.access_type = "rw" if index >= 0x1400 or (index == 0x1016 and sub) else "ro"
            record.add_member(member)
        objects.add_object(record)
    return objects


class PeerNetwork(canopen.Network):
    """A network of canopen in the time of the drives: with each message 2 ms pass."""

    def __init__(self, bench: Bench) -> None:
        super().__init__()
        self.bench = bench

    def send_message(self, can_id: int, data: bytes, remote: bool = False) -> None:
        self.bench.peer.send(0, Frame(can_id, bytes(data), remote=remote))
        self.pass_time(2)

    def pass_time(self, milliseconds: float) -> None:
        for time, frame in self.bench.wait(milliseconds):
            self.notify(frame.id, bytearray(frame.data), time * 1e-9)


@pytest.fixture(scope="module")
def library() -> Library:
    return Library()


Connect = Callable[..., tuple[PeerNetwork, Any, Bench]]


@pytest.fixture
def connect(library: Library) -> Connect:
    def connected(*drives: Any) -> tuple[PeerNetwork, Any, Bench]:
        bench = Bench(library, drives or [drive()], boot=False)
        network = PeerNetwork(bench)
        node = BaseNode402(1, dictionary())
        network.add_node(node)
        network.pass_time(20)
        return network, node, bench

    return connected


def test_canopen_sees_the_drives_boot(connect: Connect) -> None:
    network, node, _ = connect(drive(), drive(node=5))
    assert node.nmt.state == "PRE-OPERATIONAL"
    assert network.scanner.nodes == [1, 5]


def test_canopen_moves_the_network_states_and_hears_them(connect: Connect) -> None:
    network, node, bench = connect()
    node.sdo[0x1017].raw = 10
    for command, state in (
        ("OPERATIONAL", 5),
        ("STOPPED", 4),
        ("PRE-OPERATIONAL", 0x7F),
        ("OPERATIONAL", 5),
    ):
        node.nmt.state = command
        network.pass_time(15)
        assert bench.peer.nmt(0) == state
        assert node.nmt.state == command, "by heartbeat"


@pytest.mark.parametrize("form", list(Upload))
def test_canopen_reads_and_writes_whatever_the_form_of_the_answers(
    connect: Connect, form: Upload
) -> None:
    _, node, _ = connect(varied(upload=form, segment_bytes=3))
    assert node.sdo[0x1008].raw == "Servo drive of the other hand"
    assert node.sdo[0x1018][1].raw == 0xFB
    node.sdo[0x607A].raw = -123456
    node.sdo[0x6071].raw = 321
    node.sdo[0x6098].raw = 34
    assert node.sdo[0x607A].raw == -123456
    assert (node.sdo[0x6071].raw, node.sdo[0x6098].raw) == (321, 34)


def test_canopen_downloads_in_segments(connect: Connect) -> None:
    _, node, bench = connect()
    with node.sdo.open(0x607A, 0, "wb", size=4, force_segment=True) as stream:
        stream.write(struct.pack("<i", -98765))
    assert bench.peer.object(0, 0x607A) == -98765


@pytest.mark.parametrize(
    ("index", "sub", "data", "code"),
    [
        (0x2345, 0, b"\0", 0x06020000),
        (0x1018, 9, b"\0", 0x06090011),
        (0x1018, 1, bytes(4), 0x06010002),
        (0x6071, 0, bytes(4), 0x06070012),
        (0x607A, 0, bytes(2), 0x06070013),
        (0x6060, 0, b"\x07", 0x06090030),
    ],
)
def test_canopen_understands_each_refusal(
    connect: Connect, index: int, sub: int, data: bytes, code: int
) -> None:
    _, node, _ = connect()
    with pytest.raises(SdoAbortedError) as refused:
        node.sdo.download(index, sub, data)
    assert refused.value.code == code


def test_canopen_hears_emergencies(connect: Connect) -> None:
    network, node, bench = connect()
    bench.peer.fail(0, 0x3210)
    network.pass_time(2)
    (error,) = node.emcy.active
    assert (error.code, error.register) == (0x3210, 0x05)
    node.sdo[0x6040].raw = 0x80
    network.pass_time(2)
    assert node.emcy.active == []


def mapped(node: Any) -> None:
    """RPDO1 and TPDO1 as canopen sets them."""
    node.rpdo.read()
    node.tpdo.read()
    node.rpdo[1].clear()
    node.rpdo[1].add_variable(0x6040)
    node.rpdo[1].add_variable(0x6071)
    node.rpdo[1].trans_type = 1
    node.rpdo[1].enabled = True
    for n in (2, 3, 4):
        node.rpdo[n].enabled = False
    node.tpdo[1].clear()
    node.tpdo[1].add_variable(0x6041)
    node.tpdo[1].add_variable(0x6064)
    node.tpdo[1].trans_type = 1
    node.tpdo[1].enabled = True
    node.pdo.save()


def test_canopen_configures_pdos_and_they_carry_what_it_put_in(connect: Connect) -> None:
    network, node, bench = connect(drive(initial_count=-4321))
    mapped(node)
    node.sdo[0x6060].raw = CST
    assert bench.peer.object(0, 0x1600) == 2 and bench.peer.object(0, 0x1600, 2) == 0x60710010
    assert bench.peer.object(0, 0x1401, 1) >> 31 & 1
    node.nmt.state = "OPERATIONAL"
    for word in (6, 7, 15, 15, 15):
        node.rpdo[1][0x6040].raw = word
        node.rpdo[1][0x6071].raw = 250
        node.rpdo[1].transmit()
        network.sync.transmit()
    assert node.tpdo[1][0x6041].raw & 0x6F == 0x27
    assert bench.peer.power(0) == Power.OPERATION_ENABLED
    assert bench.peer.object(0, 0x6071) == 250
    assert abs(node.tpdo[1][0x6064].raw + 4321) < 100


def test_canopen_enables_the_drive_by_its_own_profile_and_homes_it(connect: Connect) -> None:
    network, node, bench = connect(drive(stop_low=-1.0, stop_high=1.0))
    node.nmt.state = "OPERATIONAL"
    network.pass_time(5)
    assert node.state == "SWITCH ON DISABLED"
    node.op_mode = "CYCLIC SYNCHRONOUS TORQUE"
    assert node.op_mode == "CYCLIC SYNCHRONOUS TORQUE"
    node.state = "OPERATION ENABLED"
    assert bench.peer.power(0) == Power.OPERATION_ENABLED
    node.sdo[0x6098].raw = -3
    assert node.homing(), "it is told when it is done"
    assert node.sdo[0x6041].raw & 0x9400 == 0x9400
    node.state = "SWITCH ON DISABLED"
    assert bench.peer.power(0) == Power.SWITCH_ON_DISABLED


def test_canopen_brings_a_faulted_drive_back(connect: Connect) -> None:
    network, node, bench = connect()
    node.setup_402_state_machine()
    node.nmt.state = "OPERATIONAL"
    node.state = "OPERATION ENABLED"
    bench.peer.fail(0, 0x2310)
    network.pass_time(5)
    assert node.state == "FAULT"
    node.controlword = 0x0000
    node.controlword = 0x0080
    network.pass_time(5)
    assert node.state == "SWITCH ON DISABLED"
    node.state = "OPERATION ENABLED"
    assert bench.peer.power(0) == Power.OPERATION_ENABLED


class Answers(canopen.Network):
    """Takes down what a local node of canopen sends."""

    def __init__(self) -> None:
        super().__init__()
        self.sent: list[Frame] = []

    def send_message(self, can_id: int, data: bytes, remote: bool = False) -> None:
        self.sent.append(Frame(can_id, bytes(data)))


def requests(count: int) -> list[bytes]:
    """Transfers of all kinds in an order of chance, with wrong toggles now and then."""
    chance = random.Random(301)
    found = []
    for _ in range(count):
        index = chance.choice([0x1000, 0x1008, 0x1017, 0x1018, 0x607A, 0x6071, 0x2345])
        sub = chance.choice([0, 0, 0, 1, 9]) if index == 0x1018 else 0
        name = b"\x40\x08\x10\x00"
        found += chance.choice(
            [
                [b"\x40" + struct.pack("<HB", index, sub)],
                [name, b"\x60", b"\x70", b"\x60", b"\x70", b"\x60"],
                [name, b"\x60", b"\x60"],
                [name, b"\x70"],
                [b"\x23\x7a\x60\x00" + chance.randbytes(4), b"\x40\x7a\x60\x00"],
                [b"\x21\x7a\x60\x00\4\0\0\0", b"\x07" + chance.randbytes(4), b"\x40\x7a\x60\x00"],
                [b"\x21\x7a\x60\x00\4\0\0\0", b"\x08" + chance.randbytes(3), b"\x1d\x55"],
                [b"\x21\x7a\x60\x00\4\0\0\0", b"\x17" + chance.randbytes(4)],
            ]
        )
    return [request.ljust(8, b"\0") for request in found]


def test_the_sdo_server_answers_as_the_one_of_canopen_does(library: Library) -> None:
    """Byte by byte; of aborts only that there is one where canopen knows no better code."""
    bench = Bench(library)
    judge: Any = canopen.LocalNode(1, dictionary())
    network = Answers()
    network[1] = judge
    judge.sdo[0x1000].raw = 0x00020192
    judge.sdo[0x1008].raw = "Servo drive of the other hand"
    judge.sdo[0x1017].raw = 0
    judge.sdo[0x1018][0].raw = 4
    judge.sdo[0x1018][1].raw = 0xFB
    judge.sdo[0x6071].raw = 0
    judge.sdo[0x607A].raw = 0
    network.sent.clear()
    kinds = set()
    for request in requests(300):
        judge.sdo.on_request(0x601, request, 0.0)
        (expected,) = network.sent
        network.sent.clear()
        answer = bench.request(request)
        if expected.data[0] == 0x80:
            assert answer[0] == 0x80, request.hex()
            code = int.from_bytes(expected.data[4:], "little")
            if code in (0x05030000, 0x06020000, 0x06090011):
                assert answer[4:] == expected.data[4:], request.hex()
        else:
            assert answer == expected.data, request.hex()
        kinds.add(answer[0] & 0xE0)
    assert kinds == {0x00, 0x20, 0x40, 0x60, 0x80}


def test_the_network_states_are_those_of_a_local_node_of_canopen(library: Library) -> None:
    names = {4: "STOPPED", 5: "OPERATIONAL", 0x7F: "PRE-OPERATIONAL"}
    bench = Bench(library)
    judge: Any = canopen.LocalNode(1, dictionary())
    network = Answers()
    network[1] = judge
    judge.sdo[0x1017].raw = 0
    judge.nmt.state = "PRE-OPERATIONAL"
    chance = random.Random(7)
    seen = set()
    for _ in range(100):
        data = bytes([chance.choice([0x01, 0x02, 0x80]), chance.choice([0, 1, 2])])
        judge.nmt.on_command(0, data, 0.0)
        bench.send(0, data)
        bench.wait(1)
        assert names[bench.peer.nmt(0)] == judge.nmt.state
        seen.add(judge.nmt.state)
    assert seen == set(names.values())


class Port:
    """What python-can takes for its serial port: the adapter, in the time of the drives."""

    def __init__(self, peer: PeerDrives) -> None:
        self.peer = peer
        self.unread = b""
        self.write_timeout: float | None = None

    def write(self, text: bytes) -> None:
        self.peer.write(0, text)

    @property
    def in_waiting(self) -> int:
        self.peer.wait(MILLISECOND)
        self.unread += self.peer.read_all(0)
        return len(self.unread)

    def read(self, count: int) -> bytes:
        taken, self.unread = self.unread[:count], self.unread[count:]
        return taken

    def flush(self) -> None: ...

    def close(self) -> None: ...


@pytest.mark.parametrize(
    "dialect",
    [
        {},
        {"acknowledgement": Acknowledgement.CR},
        {"acknowledgement": Acknowledgement.NONE},
        {"lower_case": True, "timestamps": True},
        {"pieces": True, "piece_delay": MILLISECOND},
    ],
)
def test_python_can_speaks_to_the_drives_through_the_adapter(
    library: Library, monkeypatch: pytest.MonkeyPatch, dialect: dict[str, Any]
) -> None:
    bus = Bus(bit_rate=500_000, adapter=True, variation=BusVariation(**dialect))
    peer = PeerDrives(library, [bus], [drive()])
    monkeypatch.setattr("serial.serial_for_url", lambda *_, **__: Port(peer))
    with can.Bus("port", interface="slcan", bitrate=500_000, sleep_after_open=0) as master:
        ask = bytes([0x40, 0x18, 0x10, 1, 0, 0, 0, 0])
        heard: list[can.Message] = []
        for _ in range(100):
            if len(heard) == 1:
                master.send(can.Message(arbitration_id=0x601, data=ask, is_extended_id=False))
            message = master.recv(0)
            heard += [] if message is None else [message]
            if len(heard) == 2:
                break
        boot, answer = heard
    assert (boot.arbitration_id, bytes(boot.data)) == (0x701, b"\0")
    assert (answer.arbitration_id, bytes(answer.data)) == (0x581, b"\x43\x18\x10\1\xfb\0\0\0")
