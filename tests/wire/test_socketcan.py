"""The SocketCAN driver: on this kernel as it is, and on one that has CAN."""

import errno
import socket
import sys
from pathlib import Path

import pytest
from can_ports import Result, Socketcan, library
from guest import GuestError, run_in_guest
from socketcan_in_guest import program, sealed_library

INSIDE = Path(__file__).with_name("socketcan_in_guest.py")
TESTS = INSIDE.parents[1]


def test_the_driver_does_what_it_says_on_a_kernel_with_can() -> None:
    for compiled in (library, program, sealed_library):
        compiled()  # here, where files can be written
    options = ["-q", "-x", "--color=no", "--noconftest", "-p", "no:cacheprovider"]
    options += ["-p", "quick_compiler"]
    done = run_in_guest(
        [sys.executable, "-m", "pytest", *options, INSIDE],
        interfaces=["vcan0", "vcan1", "vcan2"],
        environment={
            "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1",
            "PYTHONPATH": f"{TESTS.parent}:{TESTS}",
        },
    )
    assert done.status == 0 and " passed" in done.output, done.output


def test_output_and_status_of_a_command_come_back_from_the_guest() -> None:
    lines: list[str] = []
    command = ["sh", "-c", "pwd; echo error >&2; exit 7"]
    done = run_in_guest(command, folder=TESTS, on_line=lines.append)
    assert done.status == 7
    assert done.output == f"{TESTS}\nerror\n"
    assert lines[:2] == [str(TESTS), "error"]


def test_a_guest_that_takes_too_long_is_ended() -> None:
    with pytest.raises(GuestError, match="longer than 2 s"):
        run_in_guest(["sleep", "600"], seconds=2)


def why_this_kernel_refuses() -> Result:
    """What opening a missing interface is to answer here."""
    try:
        with socket.socket(socket.PF_CAN, socket.SOCK_RAW, socket.CAN_RAW):
            return Result.NO_DEVICE
    except OSError as error:
        denied = error.errno in (errno.EPERM, errno.EACCES)
        return Result.NO_PERMISSION if denied else Result.UNSUPPORTED


def test_a_kernel_without_can_is_told_from_a_missing_interface() -> None:
    port = Socketcan()
    assert port.open("no-such-can") is why_this_kernel_refuses()
    assert port.receive() is Result.CLOSED
    port.close()
