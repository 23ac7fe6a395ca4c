"""NMT, heartbeat and PDO messages are what the standard says, byte by byte."""

import ctypes
import struct
from ctypes import byref
from typing import Any

import pytest
from canopen_c import Frame, canopen_c, read
from hypothesis import given
from hypothesis import strategies as st

C = canopen_c()
NODES = st.integers(1, 127)
WORDS = st.integers(0, 0xFFFF)
INT16 = st.integers(-(2**15), 2**15 - 1)
INT32 = st.integers(-(2**31), 2**31 - 1)


def made(name: str, *arguments: Any) -> Frame:
    """What a function that makes a frame gives."""
    return read(getattr(C, name)(*arguments))


def heard(*data: bytes) -> Any:
    """What is known of a node after some messages of error control."""
    heartbeat = C.new("tb_heartbeat")
    C.tb_heartbeat_start(byref(heartbeat))
    for one in data:
        C.tb_heartbeat_take(byref(heartbeat), byref(C.frame(Frame(0x705, one))))
    return heartbeat


def test_a_drive_is_started_by_the_frame_of_cia_301() -> None:
    assert made("tb_nmt_frame", C.TB_NMT_START, 5) == Frame(0x000, bytes([0x01, 5]))


def test_the_communication_of_a_drive_is_reset_by_the_frame_of_cia_301() -> None:
    wanted = Frame(0x000, bytes([0x82, 5]))
    assert made("tb_nmt_frame", C.TB_NMT_RESET_COMMUNICATION, 5) == wanted


def test_the_heartbeat_of_the_master_says_operational() -> None:
    assert made("tb_heartbeat_frame", 127, C.TB_NMT_OPERATIONAL) == Frame(0x77F, b"\x05")


def test_heartbeats_tell_the_state_and_boot_up_messages_are_counted() -> None:
    assert heard().state == C.TB_NMT_UNHEARD
    assert heard(b"\x00").boots == 1
    assert heard(b"\x00", b"\x7f", b"\x05").state == C.TB_NMT_OPERATIONAL
    assert heard(b"\x00", b"\x05", b"\x00").boots == 2
    assert heard(*[b"\x00"] * 300).boots == 255
    assert heard(b"\x85").state == C.TB_NMT_OPERATIONAL  # the bit of node guarding is not read


@pytest.mark.parametrize("data", [b"", b"\x05\x05", b"\x01", b"\x06", b"\x7e"])
def test_a_malformed_heartbeat_changes_nothing(data: bytes) -> None:
    heartbeat = heard(b"\x7f")
    C.tb_heartbeat_tick(byref(heartbeat))
    assert not C.tb_heartbeat_take(byref(heartbeat), byref(C.frame(Frame(0x705, data))))
    assert (heartbeat.state, heartbeat.age) == (C.TB_NMT_PRE_OPERATIONAL, 1)


def test_the_age_of_a_heartbeat_is_counted_in_cycles() -> None:
    heartbeat = heard(b"\x05")
    for _ in range(7):
        C.tb_heartbeat_tick(byref(heartbeat))
    assert heartbeat.age == 7
    heartbeat.age = 2**32 - 1
    C.tb_heartbeat_tick(byref(heartbeat))
    assert heartbeat.age == 2**32 - 1


@given(NODES, WORDS, INT16)
def test_a_torque_setpoint_is_packed_little_endian(node: int, word: int, permille: int) -> None:
    wanted = Frame(0x200 + node, struct.pack("<Hh", word, permille))
    assert made("tb_pdo_torque_frame", node, word, permille) == wanted


@given(NODES, WORDS, INT32)
def test_a_position_setpoint_is_packed_little_endian(node: int, word: int, position: int) -> None:
    wanted = Frame(0x200 + node, struct.pack("<Hi", word, position))
    assert made("tb_pdo_position_frame", node, word, position) == wanted


@given(WORDS, INT32, INT16)
def test_a_status_message_is_unpacked(word: int, position: int, torque: int) -> None:
    status = C.new("tb_pdo_status")
    frame = C.frame(Frame(0x181, struct.pack("<Hih", word, position, torque)))
    assert C.tb_pdo_take(byref(status), byref(frame))
    assert (status.statusword, status.position, status.torque) == (word, position, torque)


@given(st.binary(min_size=8, max_size=8), st.integers(0, 64).filter(lambda length: length != 8))
def test_a_status_message_of_another_length_changes_nothing(data: bytes, length: int) -> None:
    status = C.new("tb_pdo_status")
    ctypes.memset(byref(status), 0x5A, ctypes.sizeof(status))
    before = bytes(status)
    frame = C.frame(Frame(0x181, data))
    frame.length = length
    assert not C.tb_pdo_take(byref(status), byref(frame))
    assert bytes(status) == before
