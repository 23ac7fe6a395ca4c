"""What all CAN ports share: what a frame is, lengths and codes, counters, words for people."""

import ctypes
import os
from enum import IntEnum
from pathlib import Path

import can
import pytest
from c_structs import Declarations, declarations
from can.util import CAN_FD_DLC, dlc2len, len2dlc
from can_ports import (
    BIT_RATE_SWITCH,
    CAN,
    EXTENDED,
    FD,
    REMOTE,
    Frame,
    PortHead,
    Result,
    State,
    Statistics,
    frame_of,
    library,
)
from frames import any_frames
from hypothesis import given
from hypothesis import strategies as st

from turnbuckle.codegen.compile import compile_library
from turnbuckle.codegen.purity import impurities

NO_OPERATING_SYSTEM = [CAN / name for name in ("can.c", "loopback.c", "slcan_text.c")]


@pytest.fixture(scope="module")
def declared() -> Declarations:
    """What the ports declare, from their debug information."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("CC", f"{os.environ.get('CC') or 'gcc'} -g")
        room = ["TB_CAN_MOST_DATA=64u"]
        return declarations(compile_library(NO_OPERATING_SYSTEM, [CAN], defines=room))


def is_frame(frame: Frame) -> bool:
    return bool(library().tb_can_is_frame(ctypes.byref(frame)))


@given(any_frames())
def test_every_frame_that_python_can_makes_is_a_frame(message: can.Message) -> None:
    assert is_frame(frame_of(message))


@pytest.mark.parametrize(
    "frame",
    [
        Frame(0x800, 0, 0),
        Frame(0x20000000, EXTENDED, 0),
        Frame(1, 0, 9),
        Frame(1, REMOTE, 9),
        Frame(1, FD | REMOTE, 0),
        Frame(1, BIT_RATE_SWITCH, 0),
        Frame(1, FD, 9),
        Frame(1, FD, 65),
        Frame(1, 16, 0),
    ],
)
def test_what_cannot_be_on_a_bus_is_no_frame(frame: Frame) -> None:
    assert not is_frame(frame)


def test_a_frame_with_more_data_than_there_is_room_for_is_none() -> None:
    fits, does_not_fit = Frame(1, FD, 8), Frame(1, FD, 12)
    assert is_frame(fits) and is_frame(does_not_fit)
    assert library(8).tb_can_is_frame(ctypes.byref(fits))
    assert not library(8).tb_can_is_frame(ctypes.byref(does_not_fit))


def test_length_codes_are_those_of_the_standard_and_of_python_can() -> None:
    assert [library().tb_can_length_of_code(code) for code in range(16)] == CAN_FD_DLC
    for length in range(65):
        code = library().tb_can_code_of_length(length)
        assert code == len2dlc(length)
        assert dlc2len(code) >= length


@given(st.integers(0, 2**32 - 1), st.integers(0, 2**32 - 1))
def test_a_counter_stops_at_its_largest_value(before: int, more: int) -> None:
    counter = ctypes.c_uint32(before)
    library().count(ctypes.byref(counter), more)
    assert counter.value == min(before + more, 2**32 - 1)


def test_every_result_has_words_of_its_own() -> None:
    texts = [library().tb_can_result_text(result).decode() for result in Result]
    assert len(set(texts)) == len(Result)
    for result in (-1, len(Result), 1000):
        assert library().tb_can_result_text(result) == b"unknown result"


def test_what_needs_no_operating_system_uses_none() -> None:
    assert impurities(NO_OPERATING_SYSTEM, [CAN], "c11") == []


def test_an_operating_system_where_none_may_be_is_found(tmp_path: Path) -> None:
    seeded = tmp_path / "loopback.c"
    code = (
        "#include <stdlib.h>\nvoid *tb_seeded(void); void *tb_seeded(void) { return malloc(8); }\n"
    )
    seeded.write_text((CAN / "loopback.c").read_text() + code)
    assert "malloc" in {finding.symbol for finding in impurities([seeded], [CAN], "c11")}


@pytest.mark.parametrize(
    ("python", "c"),
    [
        (Frame, "tb_can_frame"),
        (Statistics, "tb_can_statistics"),
        (PortHead, "tb_can_port"),
    ],
)
def test_python_has_the_structs_that_c_has(
    python: type[ctypes.Structure], c: str, declared: Declarations
) -> None:
    fields = [name for name, *_ in python._fields_]
    assert fields == [name for name, _ in declared.types[c]._fields_]
    for name in fields:
        here, there = getattr(python, name), getattr(declared.types[c], name)
        assert (here.offset, here.size) == (there.offset, there.size)


@pytest.mark.parametrize("enumeration", [Result, State])
def test_python_has_the_answers_that_c_has(
    enumeration: type[IntEnum], declared: Declarations
) -> None:
    for member in enumeration:
        assert declared.constants[f"TB_CAN_{member.name}"] == member
    assert declared.constants["TB_CAN_RESULTS"] == len(Result)
