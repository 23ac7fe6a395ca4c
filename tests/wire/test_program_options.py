"""The executable's command line: every mistake is one message that names the option."""

import os
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest
from running import BUSES, Lines, running

from turnbuckle.lab.live.program import compile_machine
from turnbuckle.model.words import LONGEST_IDENTIFIER
from turnbuckle.version import VERSION

NOBODY = 65534


def run(program: Path, *options: str) -> "subprocess.CompletedProcess[str]":
    """Run it to its end."""
    return subprocess.run([program, *options], capture_output=True, text=True, timeout=60)


def assert_refused(done: "subprocess.CompletedProcess[str]", *words: str) -> None:
    """Exit status 2, nothing on stdout, one message with the words."""
    assert done.returncode == 2, done
    assert done.stdout == ""
    assert done.stderr.startswith("turnbuckle-yoon2023: ")
    assert done.stderr.count("\n") == 1
    for word in words:
        assert word in done.stderr


def buses(**devices: str) -> list[str]:
    """Options for all buses, to devices that are not there unless given."""
    return [f"--bus={name}={devices.get(name, f'slcan:/dev/no_{name}')}" for name in BUSES]


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ([], ["the bus cable1 is missing", "--bus cable1=slcan:/dev/ttyACM0"]),
        (["--bus", "cable1=slcan:a"], ["the bus cable2 is missing"]),
        (["--bus", "third=slcan:a"], ['"third"', "allowed: one of cable1, cable2, base"]),
        (["--bus", "cable1"], ["--bus cable1", "cable1=slcan:/dev/ttyACM0"]),
        (["--bus", "cable1="], ["--bus cable1=", "cable1=slcan:/dev/ttyACM0"]),
        (["--bus", "cable1=slcan:"], ["--bus cable1=slcan:", "cable1=slcan:/dev/ttyACM0"]),
        (["--bus", "cable1=usb:a"], ["--bus cable1=usb:a", "socketcan:can0"]),
        (["--bus=cable1=slcan:a", "--bus=cable1=slcan:b"], ["the bus cable1 was given before"]),
        (buses(cable2="slcan:/dev/no_cable1"), ["cable1 and cable2 are both on /dev/no_cable1"]),
        (
            ["--bus", f"cable1=slcan:/dev/{'y' * 400}"],
            ["--bus cable1=: found a device of 412 characters; allowed: 300"],
        ),
        (["--cycles", "0"], ["--cycles", '"0"', "a whole number from 1"]),
        (["--cycles", "-1"], ["--cycles", '"-1"', "a whole number from 1"]),
        (["--cycles", "1e3"], ["--cycles", '"1e3"']),
        (["--cycles", "99999999999999999999"], ["--cycles", '"99999999999999999999"']),
        (["--priority", "100"], ["--priority", '"100"', "0 to 99"]),
        (["--cpu", "x"], ["--cpu", '"x"']),
        (["--cpu"], ["--cpu", "a value is missing"]),
        (["--armed"], ["--armed", "no such option"]),
        (["-x"], ["-x", "no such option"]),
        (["machine.toml"], ["machine.toml", "not an option"]),
    ],
)
def test_a_mistake_is_named_with_what_is_allowed(
    program: Path, options: list[str], words: list[str]
) -> None:
    assert_refused(run(program, *options), *words)


def test_version_tells_machine_and_hash(program: Path, stock_folder: Path) -> None:
    done = run(program, "--version")
    banner = (stock_folder / "tb_machine.h").read_text()
    build, precision, version, _ = done.stdout.strip().split(", ")
    name, identity = build.split()
    assert (done.returncode, name, precision) == (0, "yoon2023", "double")
    assert f'TB_MACHINE_HASH "{identity}"' in banner
    assert version == f"Turnbuckle {VERSION}"


def test_help_names_every_option(program: Path) -> None:
    done = run(program, "--help")
    assert done.returncode == 0
    for option in ("bus", "arm", "cycles", "record", "telemetry", "priority", "cpu", "clock"):
        assert f"--{option}" in done.stdout
    for option in ("seal", "version", "help"):
        assert f"--{option}" in done.stdout
    assert done.stdout.endswith("2 could not start.\n")  # not cut


def test_a_device_that_is_not_there_is_named(program: Path, tmp_path: Path) -> None:
    done = run(program, *buses(), f"--telemetry={tmp_path / 'shared'}")
    assert_refused(done, "--bus cable1=slcan:/dev/no_cable1", "no such interface or device")


def test_the_second_bus_that_fails_is_named(program: Path, tmp_path: Path, lines: Lines) -> None:
    first = f"slcan:{lines.adapters[0].path}"
    done = run(program, *buses(cable1=first), f"--telemetry={tmp_path / 'shared'}")
    assert_refused(done, "--bus cable2=slcan:/dev/no_cable2", "no such interface or device")


def test_a_file_that_is_no_serial_line_is_named(program: Path, tmp_path: Path) -> None:
    done = run(program, *buses(cable1="slcan:/dev/null"), f"--telemetry={tmp_path / 'shared'}")
    assert_refused(done, "--bus cable1=slcan:/dev/null", "no serial line")


def test_an_interface_that_is_not_there_is_named(program: Path, tmp_path: Path) -> None:
    done = run(program, *buses(cable1="socketcan:nocan0"), f"--telemetry={tmp_path / 'shared'}")
    assert_refused(done, "--bus cable1=socketcan:nocan0")


@pytest.fixture
def open_folder() -> Iterator[Path]:
    """A folder that every user may enter and write to."""
    folder = Path(tempfile.mkdtemp())
    folder.chmod(0o777)
    yield folder
    shutil.rmtree(folder)


def as_nobody(program: Path, folder: Path, *options: str) -> "subprocess.CompletedProcess[str]":
    """Run a copy of the program as a user without any rights, if we are not one ourselves."""
    copy = shutil.copy(program, folder / "turnbuckle")
    drop = ["setpriv", f"--reuid={NOBODY}", f"--regid={NOBODY}", "--clear-groups"]
    return subprocess.run(
        [*(drop if os.getuid() == 0 else []), copy, *options], capture_output=True, text=True
    )


def test_a_line_without_permission_is_named_with_the_group_to_join(
    program: Path, open_folder: Path, lines: Lines
) -> None:
    os.chmod(lines.adapters[0].path, 0)
    done = as_nobody(program, open_folder, *lines.options, f"--telemetry={open_folder / 'shared'}")
    group = Path(lines.adapters[0].path).group()
    assert_refused(done, f"--bus cable1=slcan:{lines.adapters[0].path}", f"the group {group}")


def test_without_real_time_rights_one_notice_says_how_to_get_them(
    program: Path, open_folder: Path, lines: Lines
) -> None:
    for adapter in lines.adapters:
        os.chmod(adapter.path, 0o666)
    options = [*lines.real_time_options, f"--telemetry={open_folder / 'shared'}", "--cycles=20"]
    done = as_nobody(program, open_folder, *options)
    assert done.returncode == 0, done
    assert done.stderr.count("notice:") == 1 and done.stderr.count("\n") == 1
    for word in ("SCHED_FIFO", "rtprio", "turnbuckle@.service"):
        assert word in done.stderr


def test_priority_0_asks_for_no_rights_and_gives_no_notice(
    program: Path, open_folder: Path, lines: Lines
) -> None:
    for adapter in lines.adapters:
        os.chmod(adapter.path, 0o666)
    options = [*lines.real_time_options, f"--telemetry={open_folder / 'shared'}", "--cycles=20"]
    done = as_nobody(program, open_folder, *options, "--priority=0")
    assert (done.returncode, done.stderr) == (0, "")


def test_a_simulation_waits_and_no_notice_asks_for_real_time_rights(
    program: Path, open_folder: Path, lines: Lines
) -> None:
    for adapter in lines.adapters:
        os.chmod(adapter.path, 0o666)
    options = [*lines.options, f"--telemetry={open_folder / 'shared'}", "--cycles=20"]
    done = as_nobody(program, open_folder, *options)
    assert (done.returncode, done.stderr) == (0, "")
    assert "late" not in done.stdout and "computing" not in done.stdout


def test_a_processor_that_does_not_exist_is_named(
    program: Path, tmp_path: Path, lines: Lines
) -> None:
    shared = f"--telemetry={tmp_path / 'shared'}"
    assert_refused(run(program, *lines.options, shared, "--cpu=1023"), "--cpu 1023")


def test_telemetry_that_cannot_be_written_is_named(program: Path, tmp_path: Path) -> None:
    path = tmp_path / "none" / "shared"
    assert_refused(run(program, *buses(), f"--telemetry={path}"), f"--telemetry {path}")


def test_a_record_that_cannot_be_written_is_named_before_anything_moves(
    program: Path, tmp_path: Path
) -> None:
    path = tmp_path / "none" / "dump"
    done = run(program, *buses(), f"--telemetry={tmp_path / 'shared'}", f"--record={path}")
    assert_refused(done, f"--record {path}", "No such file")


def test_two_programs_do_not_control_one_machine(program: Path, lines: Lines) -> None:
    with running(program, lines.options) as first:
        first.await_cycles(1)
        done = run(program, *lines.options, f"--telemetry={first.telemetry.path}")
        assert_refused(done, "another program controls this machine")
        first.await_cycles(10)


def test_a_message_about_the_longest_path_is_whole(program: Path, tmp_path: Path) -> None:
    path = tmp_path / "/".join(["y" * 250] * 15) / "file"
    for option in ("record", "telemetry"):
        done = run(program, *buses(), f"--{option}={path}")
        assert_refused(done, f"--{option} {path}: cannot be ", "No such file or directory")
    assert_refused(run(program, f"--cycles={'x' * 9000}"), "x" * 9000, "allowed: a whole number")


def test_the_list_of_buses_is_whole(stock_folder: Path, tmp_path: Path) -> None:
    folder, name = tmp_path / "long", "w" * LONGEST_IDENTIFIER
    shutil.copytree(stock_folder, folder)
    tables = folder / "tb_drives.c"
    tables.write_text(tables.read_text().replace('"cable1"', f'"{name}"'))
    done = run(compile_machine(folder), "--bus=no=slcan:a")
    assert_refused(done, f"allowed: one of {name}, cable2, base, as in --bus {name}=")
