"""Where simulated drives are reached: serial lines of their own, or interfaces of the kernel."""

import pytest

from turnbuckle.lab.live import LiveError
from turnbuckle.lab.live.simulated import interfaces, open_port, way_to

NAMES = ("cable1", "cable2", "base")


def test_buses_have_the_interfaces_they_are_given() -> None:
    given = ["base=socketcan:vcan2", "cable1=socketcan:vcan0"]
    assert interfaces(given, NAMES) == {"base": "vcan2", "cable1": "vcan0"}


def test_a_bus_that_is_not_the_machine_s_is_refused() -> None:
    with pytest.raises(LiveError, match="found the bus 'rail'; allowed: one of cable1, cable2"):
        interfaces(["rail=socketcan:vcan0"], NAMES)


def test_an_interface_that_cannot_be_opened_is_named_with_what_to_do() -> None:
    with pytest.raises(LiveError, match=r"no-such-can: .*; allowed: a CAN interface that is up"):
        open_port("no-such-can")


def test_a_bus_without_an_interface_is_a_serial_line() -> None:
    port = open_port(None)
    assert way_to(port).startswith("slcan:/dev/pts/")
    port.shutdown()
