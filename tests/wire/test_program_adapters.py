"""The executable and its adapters: what they deliver, their plugs, how they are left at the end."""

import os
import signal
import subprocess
import threading
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest
from running import BUSES, PATIENCE, Running, running
from serial_line import Adapter, BootingDrives, FarEnd, SerialLine

from turnbuckle.codegen.compile import compile_program
from turnbuckle.lab.live.program import FOLDERS, compile_machine
from turnbuckle.lab.live.telemetry import Record
from turnbuckle.lab.lockstep import State
from turnbuckle.places import RUNTIME

FAULT = State.FAULT
UNPLUGGED = "cable2"
ERROR_ACTIVE, NOT_OPEN = 0, 4


@pytest.fixture(scope="module")
def program(stock_folder: Path) -> Path:
    """The executable of the stock machine."""
    return compile_machine(stock_folder)


class Socket:
    """Where an adapter is plugged in: a name that leads to its line while it is there."""

    def __init__(self, name: Path) -> None:
        self.name = name
        self.line: SerialLine
        self.adapter: Adapter
        self._plugged = ExitStack()

    def plug_in(self, adapter: Callable[[SerialLine], Adapter]) -> None:
        """A new adapter under the old name."""
        self.line = self._plugged.enter_context(SerialLine())
        self.adapter = adapter(self.line)
        self._plugged.enter_context(FarEnd({self.line: self.adapter}))
        self.name.symlink_to(self.line.path)
        self._plugged.callback(self.name.unlink)

    def pull_out(self) -> None:
        """Nothing answers to the name any more."""
        self._plugged.close()


@pytest.fixture
def sockets(tmp_path: Path) -> Iterator[dict[str, Socket]]:
    """A socket a bus, with nothing plugged in."""
    made = {bus: Socket(tmp_path / bus) for bus in BUSES}
    yield made
    for socket in made.values():
        socket.pull_out()


def options(sockets: dict[str, Socket]) -> list[str]:
    """The buses, as the program takes them."""
    return [f"--bus={bus}=slcan:{socket.name}" for bus, socket in sockets.items()]


def cause(run: Running) -> str:
    """Why the machine stopped."""
    text: str = run.telemetry.status()["cause"].decode()
    return text


def bus_state(run: Running, bus: str) -> int:
    """tb_can_state."""
    return int(run.telemetry.status()["buses"][BUSES.index(bus)]["state"])


def await_that(run: Running, holds: Callable[[], bool]) -> None:
    """Wait until something is so."""
    pause, waited = threading.Event(), 0.0
    while not holds():
        assert run.process.poll() is None, run.process.communicate()
        assert waited < PATIENCE, cause(run)
        pause.wait(0.005)
        waited += 0.005


# ---- What adapters deliver ----


def stopped_by(program: Path, sockets: dict[str, Socket]) -> str:
    """The cause that the program stops by."""
    with running(program, options(sockets)) as run:
        run.await_state(FAULT)
        return cause(run)


def silent(line: SerialLine) -> Adapter:
    """An adapter that never says anything."""
    return Adapter(line, {}, b"")


def crippled(text: bytes) -> bytes:
    """A line without its last digit."""
    return text[:-1]


def test_drives_behind_an_adapter_that_ends_lines_with_a_line_feed_too_boot(
    program: Path, sockets: dict[str, Socket]
) -> None:
    for socket in sockets.values():
        socket.plug_in(lambda line: BootingDrives(line, b"\r\n"))
    with running(program, options(sockets)) as run:
        run.await_state(FAULT)
        states = {int(cycle["state"]) for cycle in cycles(run)}
        assert State.IDENTIFY in states
        assert "did not boot, or does not answer" in cause(run)
        assert not run.telemetry.status()["buses"]["malformed"].any()


def cycles(run: Running) -> Iterator[Record]:
    """All cycles that are still there."""
    published = int(run.telemetry.status()["published"])
    for number in range(max(0, published - 4000), published):
        if (cycle := run.telemetry.cycle(number)) is not None:
            yield cycle


@pytest.mark.parametrize("spoken", [crippled, lambda text: b"\xf0" * 150])
def test_a_bus_whose_lines_are_malformed_is_named_not_the_drive_that_was_not_heard(
    program: Path, sockets: dict[str, Socket], spoken: Callable[[bytes], bytes]
) -> None:
    for bus, socket in sockets.items():
        if bus == UNPLUGGED:
            socket.plug_in(lambda line: BootingDrives(line, spoken=spoken))
        else:
            socket.plug_in(BootingDrives)
    assert stopped_by(program, sockets) == (
        "bus cable2: delivers malformed lines or frames; check its adapter and bit rate, look for"
        " another program on it"
    )


def test_what_came_before_the_start_is_not_held_against_the_bus(
    program: Path, sockets: dict[str, Socket]
) -> None:
    sockets["cable1"].plug_in(BootingDrives)
    sockets[UNPLUGGED].plug_in(silent)
    sockets["base"].plug_in(lambda line: NoisyStart(line, sockets[UNPLUGGED].line))
    assert stopped_by(program, sockets).startswith("drive cable_3 (bus cable2, node 1): did not")


class NoisyStart(BootingDrives):
    """While this adapter is opened, noise comes from another one, which is open already."""

    def __init__(self, line: SerialLine, other: SerialLine) -> None:
        super().__init__(line)
        self._other = other

    def hear(self, command: bytes) -> None:
        """As drives that boot; but before the bus is open the other line is noisy."""
        if command == b"O":
            self._other.write(b"noise\r" * 100)
        super().hear(command)


# ---- Plugs ----


@pytest.fixture
def plugged(sockets: dict[str, Socket]) -> dict[str, Socket]:
    """Adapters that acknowledge, with nobody behind them."""
    for socket in sockets.values():
        socket.plug_in(acknowledging)
    return sockets


def acknowledging(line: SerialLine) -> Adapter:
    """An adapter that acknowledges every command."""
    return Adapter(line, {}, b"\r")


def pull_out(run: Running, sockets: dict[str, Socket]) -> None:
    """Pull a plug, and see that the bus is named with what to do."""
    run.await_cycles(5)
    sockets[UNPLUGGED].pull_out()
    run.await_state(FAULT)
    await_that(run, lambda: "has gone: bring it back" in cause(run))
    assert cause(run).startswith(f"bus {UNPLUGGED}: off, or its device has gone")
    assert f"slcan:{sockets[UNPLUGGED].name} has gone: bring it back, then" in cause(run)


def assert_working(run: Running, socket: Socket) -> None:
    """The bus is open again, and drives behind it are told to boot."""
    await_that(run, lambda: any(line.startswith(b"t000282") for line in socket.adapter.heard))
    assert socket.adapter.heard[:4] == [b"C", b"C", b"S8", b"O"]
    assert bus_state(run, UNPLUGGED) == ERROR_ACTIVE


@pytest.mark.parametrize("resets", [0, 1, 3])
def test_a_reset_opens_an_adapter_that_came_back_however_often_it_was_tried_before(
    program: Path, plugged: dict[str, Socket], resets: int
) -> None:
    with running(program, options(plugged)) as run:
        pull_out(run, plugged)
        for _ in range(resets):
            reset_in_vain(run)
            assert cause(run).startswith(f"bus {UNPLUGGED}: ")
            assert cause(run).endswith(
                f"{plugged[UNPLUGGED].name} cannot be opened again: there is no such interface or"
                " device: check its name and its plug; then reset once more"
            )
        plugged[UNPLUGGED].plug_in(acknowledging)
        run.telemetry.ask("reset")
        assert_working(run, plugged[UNPLUGGED])
        run.await_state(FAULT)
        assert "did not boot" in cause(run) and "has gone" not in cause(run)
        status, _out, err = run.end(signal.SIGTERM)
        assert status == 1
        assert err.count("is open again") == 1 and err.count("cannot be opened again") == resets


def reset_in_vain(run: Running) -> None:
    """Ask for a reset, and see the machine go to INIT and back."""
    before = last_in(run, "INIT")
    run.telemetry.ask("reset")
    await_that(run, lambda: last_in(run, "INIT") > before)
    run.await_state(FAULT)


def last_in(run: Running, state: str) -> int:
    """Number of the last cycle in a state, of those that are still there; -1 for none."""
    number = State[state]
    return max((int(each["number"]) for each in cycles(run) if each["state"] == number), default=-1)


def test_the_control_loop_goes_on_while_an_adapter_is_opened(
    program: Path, plugged: dict[str, Socket]
) -> None:
    with running(program, options(plugged)) as run:
        pull_out(run, plugged)
        plugged[UNPLUGGED].plug_in(silent)
        run.telemetry.ask("reset")
        await_that(run, lambda: "is being opened again" in cause(run))  # a cycle says so
        assert_working(run, plugged[UNPLUGGED])


def test_an_adapter_that_hangs_up_while_it_is_opened_may_be_tried_again(
    program: Path, plugged: dict[str, Socket]
) -> None:
    with running(program, options(plugged)) as run:
        pull_out(run, plugged)
        plugged[UNPLUGGED].plug_in(silent)
        run.telemetry.ask("reset")
        await_that(run, lambda: plugged[UNPLUGGED].adapter.heard != [])
        plugged[UNPLUGGED].pull_out()
        await_that(run, lambda: cause(run).endswith(("then reset once more", "opens it again")))
        plugged[UNPLUGGED].plug_in(acknowledging)
        run.telemetry.ask("reset")
        assert_working(run, plugged[UNPLUGGED])


def test_a_device_that_has_gone_is_given_back_so_that_its_name_is_free(
    program: Path, plugged: dict[str, Socket]
) -> None:
    device = plugged[UNPLUGGED].line.path
    with running(program, options(plugged)) as run:
        files = Path(f"/proc/{run.process.pid}/fd")
        run.await_cycles(5)
        assert device in {os.readlink(file) for file in files.iterdir()}
        pull_out(run, plugged)
        assert not any(device == os.readlink(file).split()[0] for file in files.iterdir())


def test_a_stop_ends_the_program_while_an_adapter_is_opened(
    program: Path, plugged: dict[str, Socket]
) -> None:
    with running(program, options(plugged)) as run:
        pull_out(run, plugged)
        plugged[UNPLUGGED].plug_in(silent)
        run.telemetry.ask("reset")
        await_that(run, lambda: plugged[UNPLUGGED].adapter.heard != [])
        status, _out, err = run.end(signal.SIGTERM)
        assert status == 1 and f"bus {UNPLUGGED}: " in err


def test_a_sealed_program_says_that_it_must_be_started_again(
    program: Path, plugged: dict[str, Socket]
) -> None:
    with running(program, [*options(plugged), "--seal"]) as run:
        pull_out(run, plugged)
        plugged[UNPLUGGED].plug_in(acknowledging)
        for _ in range(3):
            reset_in_vain(run)
            assert cause(run).endswith("then start the program again: sealed, it opens nothing")
        assert bus_state(run, UNPLUGGED) == NOT_OPEN and plugged[UNPLUGGED].adapter.heard == []
        status, _out, err = run.end(signal.SIGTERM)
        assert status == 1 and "then start the program again" in err
    with running(program, [*options(plugged), "--seal"]) as run:
        run.await_cycles(5)
        assert bus_state(run, UNPLUGGED) == ERROR_ACTIVE


# ---- The end ----


HELD = """
#define _GNU_SOURCE
#include <stdarg.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>

static int questions;

int ioctl(int file, unsigned long request, ...)
{
    va_list rest;
    va_start(rest, request);
    void *const argument = va_arg(rest, void *);
    va_end(rest);
    int const answer = (int)syscall(SYS_ioctl, file, request, argument);
    if ((answer == 0) && (request == TIOCOUTQ)) {
        *(int *)argument = (questions < HELD_FOR) ? 14 : 0;
        questions++;
    }
    return answer;
}
"""
"""A device that holds what is written to it, as cdc_acm does, until it was asked so many times."""


@pytest.fixture(scope="module", params=[5, 1_000_000])
def held(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> str:
    """What is loaded before the program, so that its lines hold bytes at the end."""
    folder = tmp_path_factory.mktemp("held")
    (folder / "held.c").write_text(HELD)
    flags = ["-shared", "-fPIC", f"-DHELD_FOR={request.param}"]
    subprocess.run(["gcc", *flags, "held.c", "-o", "held.so"], cwd=folder, check=True)
    return str(folder / "held.so")


def end_of_sealed(program: Path, sockets: dict[str, Socket], loaded: str) -> int:
    """Exit status of a sealed program that is stopped while its lines hold bytes."""
    with running(program, [*options(sockets), "--seal"], ["env", f"LD_PRELOAD={loaded}"]) as run:
        run.await_cycles(5)
        return run.end(signal.SIGTERM)[0]


def test_a_sealed_program_ends_although_its_adapters_hold_bytes(
    program: Path, plugged: dict[str, Socket], held: str
) -> None:
    assert end_of_sealed(program, plugged, held) == 0


def test_a_wait_that_the_seal_forbids_is_noticed(
    stock_folder: Path, plugged: dict[str, Socket], held: str, tmp_path: Path
) -> None:
    text = (RUNTIME / "can" / "serial_line.c").read_text()
    sleep = "(void)clock_nanosleep(CLOCK_MONOTONIC, 0, &pause, NULL);"
    assert text.count(sleep) == 1
    source = tmp_path / "serial_line.c"
    source.write_text(text.replace(sleep, "(void)pause; (void)poll(NULL, 0, 1);"))
    others = [path for folder in (stock_folder, *FOLDERS) for path in sorted(folder.glob("*.c"))]
    sources = [source, *(path for path in others if path.name != source.name)]
    polling = compile_program(sources, [stock_folder, *FOLDERS])
    assert end_of_sealed(polling, plugged, held) == -signal.SIGSYS
