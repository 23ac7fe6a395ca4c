"""Emergencies of an EPOS4: class and words of every error code; what stands, and what clears it."""

import struct
from ctypes import byref, c_void_p

import pytest
from canopen_c import Frame, canopen_c
from hypothesis import given
from hypothesis import strategies as st

C = canopen_c()
EPOS4 = c_void_p(C.variable("tb_drives")[0].kind)

FAULTS = [
    0x1000,
    *range(0x1080, 0x1089),
    *(0x1090, 0x2310, 0x2320, 0x3210, 0x3220, 0x4210, 0x4380, 0x5113, 0x5280, 0x5281, 0x5282),
    *range(0x5480, 0x5484),
    *(0x6080, 0x6081, *range(0x6180, 0x61F1), 0x6320, 0x6380, 0x7320, 0x7380, 0x7381, 0x7382),
    *(0x7388, 0x7389, 0x738A, 0x738C, 0x738D, 0x7390, 0x7391, 0x7392, 0x8210, 0x8250),
    *(0x8280, 0x8281, 0x8611, 0x8A80, 0x8A81, 0x8A82, 0x8A88, 0xFF02, 0xFF0B, 0xFF10),
    *range(0xFF11, 0xFF25),
]
COMMUNICATION = [
    *(0x8110, 0x8111, 0x8120, 0x8130, 0x8150, 0x81FD, 0x81FE, 0x81FF),
    *range(0x8180, 0x8185),
]
CLASSES = {
    0x0000: "NONE",
    0xFF01: "WARNING",
    **dict.fromkeys(FAULTS, "FAULT"),
    **dict.fromkeys(COMMUNICATION, "COMMUNICATION"),
}
GROUPS = {
    "generic error",
    "current error",
    "voltage error",
    "temperature error",
    "hardware error",
    "software error",
    "error of an additional module",
    "monitoring error",
    "communication error",
    "protocol error",
    "external error",
    "error of the device",
    "unknown error",
}


def class_of(name: str) -> int:
    """The number of a class."""
    return int(getattr(C, f"TB_ERROR_{name}"))


def message(code: int) -> Frame:
    """An emergency message of node 1."""
    return Frame(0x081, struct.pack("<HB5s", code, 1, b"maker"))


def standing(*codes: int) -> tuple[int, int]:
    """Code and class that stand after some messages."""
    emergency = C.new("tb_emcy")
    for code in codes:
        assert C.tb_emcy_take(byref(emergency), EPOS4, byref(C.frame(message(code))))
    return emergency.code, emergency.error_class


@pytest.mark.parametrize("code", CLASSES, ids=hex)
def test_every_known_code_has_its_class(code: int) -> None:
    assert C.tb_drive_kind_error_class(EPOS4, code) == class_of(CLASSES[code])


@pytest.mark.parametrize("code", [code for code in CLASSES if code != 0x1000], ids=hex)
def test_every_known_code_has_words_of_its_own(code: int) -> None:
    assert C.text("tb_drive_kind_error_text", EPOS4, code) not in GROUPS


def group_of(code: int) -> str:
    """What CiA 301 and CiA 402 call the codes around one."""
    narrow = {0x81: "communication error", 0x82: "protocol error", 0x90: "external error"}
    wide = ["generic", "current", "voltage", "temperature", "hardware", "software"]
    groups = dict(enumerate((f"{kind} error" for kind in wide), 1))
    groups |= {7: "error of an additional module", 8: "monitoring error"}
    narrow |= {0xFF: "error of the device"}
    return narrow.get(code >> 8) or groups.get(code >> 12, "unknown error")


def test_every_other_code_is_named_after_its_group() -> None:
    known = {*CLASSES, 0x8140}  # recovered from bus-off: nothing that stands
    others = [code for code in range(0x10000) if code not in known]
    wrong = [
        hex(code)
        for code in others
        if C.text("tb_drive_kind_error_text", EPOS4, code) != group_of(code)
    ]
    assert wrong == []


def test_a_code_nobody_described_is_a_fault_and_named_after_its_group() -> None:
    assert C.text("tb_drive_kind_error_text", EPOS4, 0x2345) == "current error"
    assert C.text("tb_drive_kind_error_text", EPOS4, 0x81AB) == "communication error"
    assert C.text("tb_drive_kind_error_text", EPOS4, 0xFFAB) == "error of the device"
    assert C.text("tb_drive_kind_error_text", EPOS4, 0xA000) == "unknown error"
    assert {C.tb_drive_kind_error_class(EPOS4, code) for code in (0x2345, 0xA000, 0xFFAB)} == {
        class_of("FAULT")
    }


@given(st.integers(0, 0xFFFF))
def test_every_code_has_words_and_a_class(code: int) -> None:
    assert C.text("tb_drive_kind_error_text", EPOS4, code)
    assert (C.tb_drive_kind_error_class(EPOS4, code) == class_of("NONE")) == (code == 0)


def test_the_first_of_the_worst_class_stands() -> None:
    assert standing(0xFF01) == (0xFF01, class_of("WARNING"))
    assert standing(0xFF01, 0x2310, 0x3220) == (0x2310, class_of("FAULT"))
    assert standing(0x2310, 0xFF01) == (0x2310, class_of("FAULT"))
    assert standing(0x2310, 0x8130, 0x8120) == (0x8130, class_of("COMMUNICATION"))


def test_the_all_clear_clears_what_stands() -> None:
    assert standing(0x2310, 0x0000) == (0, class_of("NONE"))
    assert standing(0x8130, 0x0000, 0xFF01) == (0xFF01, class_of("WARNING"))


@pytest.mark.parametrize("length", [0, 1, 2, 7])
def test_a_message_of_another_length_is_malformed_and_changes_nothing(length: int) -> None:
    emergency = C.new("tb_emcy")
    frame = Frame(0x081, message(0x2310).data[:length])
    assert not C.tb_emcy_take(byref(emergency), EPOS4, byref(C.frame(frame)))
    assert emergency.code == 0
