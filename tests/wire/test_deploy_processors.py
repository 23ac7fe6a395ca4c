"""A deployed program takes the machine from power-on to RUN on a host of any processor."""

import signal
from collections.abc import Iterator
from pathlib import Path

import pytest
from running import running, shared_file
from ssh_host import SshHost, ssh_host
from typer.testing import CliRunner

from turnbuckle.command_line import app
from turnbuckle.lab.live.run import bench_of
from turnbuckle.lab.live.simulated import simulated_drives
from turnbuckle.lab.lockstep import State
from turnbuckle.model.reading import load_machine

#: What `uname -m` says, and what runs such programs here.
HOSTS = {
    "x86-64": ("x86_64", []),
    "AArch64": ("aarch64", ["qemu-aarch64"]),
    "ARMv7": ("armv7l", ["qemu-arm"]),
    "RISC-V 64": ("riscv64", ["qemu-riscv64"]),
}
#: Such a host starts its programs itself; here the emulator does.
STARTING = """case "$2" in ./.copy*) limit=$1; shift; exec {real} "$limit" EMULATOR "$@" ;; esac
exec {real} "$@"
"""


@pytest.fixture(scope="module")
def host(tmp_path_factory: pytest.TempPathFactory) -> Iterator[SshHost]:
    with ssh_host(tmp_path_factory.mktemp("host")) as host:
        yield host


def deployed(host: SshHost, folder: Path, file: Path, name: str) -> Path:
    """The program on a host of a processor, brought there by the command."""
    machine, emulator = HOSTS[name]
    host.tool("uname", f"echo {machine}")
    host.tool("timeout", STARTING.replace("EMULATOR", " ".join(emulator)))
    where = [f"--ssh={host.ssh()}", f"--folder={folder}"]
    result = CliRunner().invoke(app, ["deploy", str(file), host.name, *where])
    assert result.exit_code == 0, result.stderr
    assert f", {name} (sha256 " in result.stdout
    return folder / "yoon2023" / "turnbuckle"


@pytest.mark.parametrize("name", HOSTS)
def test_the_deployed_program_takes_the_machine_from_power_on_to_run(
    name: str, host: SshHost, tmp_path: Path, stock_file: Path
) -> None:
    program = deployed(host, tmp_path, stock_file, name)
    with (
        simulated_drives(bench_of(load_machine(stock_file)), shared_file()) as options,
        running(program, ["--arm", "--priority=0", *options], HOSTS[name][1]) as run,
    ):
        run.await_state(State.RUN)
        status, _, err = run.end(signal.SIGTERM)
    assert status == 0, err
