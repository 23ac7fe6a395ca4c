"""SDO: what a simulated drive lets a master read and write, with python `canopen` as the master."""

from struct import pack

import pytest
from canopen.sdo.exceptions import SdoAbortedError
from peer import (
    OBJECTS,
    Bench,
    abort_code,
    booted,
    enable,
    map_torque,
    read,
    remote,
    running,
    write,
)


def test_every_object_can_be_read_and_has_the_length_of_its_type() -> None:
    node = remote(booted())
    for (index, subindex), entry in OBJECTS.entries.items():
        data = node.sdo.upload(index, subindex)
        assert len(data) == (entry.size or len(entry.encode(entry.default)))


def test_a_string_comes_in_segments() -> None:
    assert remote(booted()).sdo[0x1008].raw == "Turnbuckle simulated drive"


def test_rated_torque_follows_from_current_and_torque_constant() -> None:
    node = remote(booted())
    assert read(node, 0x6076) == 2000 * 30
    write(node, 0x3001, 5, 20_000)
    assert read(node, 0x6076) == 2000 * 20


def test_what_is_written_is_read_back() -> None:
    node = remote(booted())
    for index, subindex, value in [(0x6007, 0, 2), (0x605A, 0, 5), (0x1016, 1, 0x7F0028)]:
        write(node, index, subindex, value)
        assert read(node, index, subindex) == value


@pytest.mark.parametrize(
    ("index", "subindex", "data", "code"),
    [
        (0x1018, 1, pack("<I", 1), 0x06010002),
        (0x6076, 0, pack("<I", 1), 0x06010002),
        (0x5FFF, 0, b"\0", 0x06020000),
        (0x6072, 0, b"\0\0", 0x06020000),
        (0x1018, 9, pack("<I", 1), 0x06090011),
        (0x6040, 0, b"\0", 0x06070013),
        (0x6060, 0, b"\0\0", 0x06070012),
        (0x6007, 0, pack("<h", 4), 0x06090031),
        (0x6007, 0, pack("<h", -1), 0x06090032),
        (0x6060, 0, b"\x05", 0x06090030),
        (0x6098, 0, b"\x01", 0x06090030),
        (0x1003, 0, b"\x01", 0x06090030),
        (0x1010, 1, b"SAVE", 0x08000020),
        (0x6066, 0, pack("<H", 1), 0x06090031),
    ],
)
def test_a_write_that_is_not_allowed_is_aborted_with_its_code(
    index: int, subindex: int, data: bytes, code: int
) -> None:
    node = remote(booted())
    before = node.sdo.upload(index, subindex) if (index, subindex) in OBJECTS.entries else None
    assert abort_code(lambda: node.sdo.download(index, subindex, data)) == code
    if before is not None:
        assert node.sdo.upload(index, subindex) == before


def test_motor_data_is_written_only_while_the_power_stage_is_off() -> None:
    bench = booted()
    node = running(bench)
    write(node, 0x3001, 2, 3000)
    enable(bench)
    assert abort_code(lambda: write(node, 0x3001, 2, 1000)) == 0x08000022
    assert read(node, 0x3001, 2) == 3000


@pytest.mark.parametrize(
    ("mapping", "code"),
    [
        ([0x60400010, 0x60720010], 0x06020000),
        ([0x60400010, 0x30010910], 0x06090011),
        ([0x60410010], 0x06040041),
        ([0x60400020], 0x06040041),
        ([0x60400010, 0x607A0020, 0x60600008, 0x60B20010], 0x06040042),
    ],
)
def test_a_mapping_that_cannot_be_is_refused_when_it_is_switched_on(
    mapping: list[int], code: int
) -> None:
    node = remote(booted())
    write(node, 0x1400, 1, 0x80000201)
    write(node, 0x1600, 0, 0)
    for slot, entry in enumerate(mapping, start=1):
        write(node, 0x1600, slot, entry)
    assert abort_code(lambda: write(node, 0x1600, 0, len(mapping))) == code
    assert read(node, 0x1600, 0) == 0


def test_the_rules_of_changing_a_pdo() -> None:
    bench = booted()
    node = remote(bench)
    assert abort_code(lambda: write(node, 0x1400, 1, 0x205)) == 0x06090030  # while it is valid
    assert abort_code(lambda: write(node, 0x1600, 0, 0)) == 0x06010000
    assert abort_code(lambda: write(node, 0x1800, 3, 0)) == 0x06010000
    assert abort_code(lambda: write(node, 0x1800, 1, 0x80000181)) == 0x06090030  # answers remote
    write(node, 0x1400, 1, 0x80000201)
    assert abort_code(lambda: write(node, 0x1600, 1, 0x60710010)) == 0x06010003  # count is not 0
    assert abort_code(lambda: write(node, 0x1400, 2, 245)) == 0x06090030
    assert abort_code(lambda: write(node, 0x1400, 1, 0x601)) == 0x06090030  # restricted
    map_torque(node)
    bench.nmt(1)
    assert abort_code(lambda: write(node, 0x1400, 1, 0x80000201)) == 0x0F00FFC0


def test_a_stopped_drive_answers_no_sdo() -> None:
    bench = booted()
    bench.nmt(2)
    assert bench.send(0x601, pack("<BHBI", 0x40, 0x6041, 0, 0)) == []


@pytest.mark.parametrize(
    "request_", [b"\x60" + bytes(7), b"\x00" + bytes(7), b"\xe0" + bytes(7), b"\xa0" + bytes(7)]
)
def test_a_request_out_of_order_is_aborted(request_: bytes) -> None:
    (answer,) = booted().send(0x601, request_)
    assert answer.cob == 0x581 and answer.data[0] in (0x80, 0x40)


def test_an_expedited_write_without_a_size_has_that_of_the_object() -> None:
    bench = booted()
    (answer,) = bench.send(0x601, pack("<BHBI", 0x22, 0x6007, 0, 2))
    assert answer.data[0] == 0x60 and bench.drive.read(0x6007) == 2


def test_an_object_can_be_made_to_refuse() -> None:
    bench = booted()
    bench.drive.refuse((0x1018, 1), 0x08000000)
    assert abort_code(lambda: read(remote(bench), 0x1018, 1)) == 0x08000000


def test_a_wrong_peer_would_be_noticed() -> None:
    # The negative control of abort_code: a write that works raises nothing.
    with pytest.raises(pytest.fail.Exception):
        abort_code(lambda: write(remote(booted()), 0x6007, 0, 1))
    assert issubclass(SdoAbortedError, Exception) and isinstance(booted(), Bench)
