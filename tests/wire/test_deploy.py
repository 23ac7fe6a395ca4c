"""`turnbuckle deploy` and `rollback` over a real ssh, to a host on loopback."""

import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from running import PATIENCE, Lines, running
from ssh_host import SshHost, ssh_host
from typer.testing import CliRunner, Result

from turnbuckle.command_line import app
from turnbuckle.lab.deploy import host as host_module
from turnbuckle.lab.deploy.deploy import deploy
from turnbuckle.lab.deploy.host import Host
from turnbuckle.model.reading import load_machine

FLIPPED = """{real} | {python} -c '
import sys
content = bytearray(sys.stdin.buffer.read())
content[len(content) // 2] ^= 1
sys.stdout.buffer.write(content)'
"""
HELD = "head -c 100000; echo >{here}; read _ <{pipe}; exec {real}\n"


class Journey:
    """A host, and the commands of a user who deploys to it."""

    def __init__(self, host: SshHost, folder: Path, file: Path) -> None:
        self.host, self.folder, self.file = host, folder, file
        self.link = folder / "yoon2023" / "turnbuckle"

    def words(self, command: str, *more: str) -> list[str]:
        """The command line."""
        where = [f"--ssh={self.host.ssh()}", f"--folder={self.folder}"]
        return [command, str(self.file), self.host.name, *where, *more]

    def run(self, command: str, *more: str) -> Result:
        """Do a command that is expected to succeed."""
        result = self.attempt(command, *more)
        assert result.exit_code == 0, result.stderr
        return result

    def attempt(self, command: str, *more: str) -> Result:
        """Do a command."""
        return CliRunner().invoke(app, self.words(command, *more))

    def version(self) -> str:
        """What the program there tells of itself."""
        done = subprocess.run([self.link, "--version"], capture_output=True, text=True, check=True)
        return done.stdout.strip()

    def assert_refused(self, result: Result, *words: str) -> None:
        """One message that holds the words, and the program there is that of before."""
        assert result.exit_code == 2
        assert result.stderr.count("\n") == 1 and "Traceback" not in result.stderr
        for each in words:
            assert each in result.stderr
        assert self.version().endswith("double, Turnbuckle 0.2.0, x86-64")
        assert not list(self.folder.rglob(".copy.*"))


@pytest.fixture(scope="module")
def host(tmp_path_factory: pytest.TempPathFactory) -> Iterator[SshHost]:
    with ssh_host(tmp_path_factory.mktemp("host")) as host:
        yield host


@pytest.fixture
def journey(host: SshHost, tmp_path: Path, stock_file: Path) -> Iterator[Journey]:
    """A host on which nothing has been deployed."""
    yield Journey(host, tmp_path / "there", stock_file)
    shutil.rmtree(host.tools)
    host.tools.mkdir()
    host.know("host")
    host.configure()


@pytest.fixture
def deployed(journey: Journey) -> Journey:
    """A host with the program in double precision, and none before it."""
    journey.run("deploy")
    return journey


def now_of(result: Result) -> str:
    """What a command says is there now."""
    (now,) = re.findall(r"^now +(.*) \(sha256", result.stdout, re.MULTILINE)
    return str(now)


def test_the_program_is_brought_there_updated_and_taken_back(journey: Journey) -> None:
    first = journey.run("deploy", "--arch=x86-64")
    assert "before    none" in first.stdout and "previous  none" in first.stdout
    assert "yoon2023/turnbuckle --bus=cable1=ADAPTER:DEVICE" in first.stdout
    assert journey.version() == now_of(first)
    assert "double, Turnbuckle 0.2.0, x86-64" in journey.version()
    assert "the same program was there already" in journey.run("deploy").stdout
    second = journey.run("deploy", "--precision=float")
    assert journey.version() == now_of(second)
    assert "float" in journey.version()
    assert f"previous  {now_of(first)}" in second.stdout
    back = journey.run("rollback")
    assert journey.version() == now_of(back) == now_of(first)
    assert f"previous  {now_of(second)}" in back.stdout


def test_info_tells_what_a_file_is_without_running_it(deployed: Journey, tmp_path: Path) -> None:
    copy = tmp_path / "copy"
    copy.write_bytes(deployed.link.read_bytes()[0x1000:])  # no program any more
    told = CliRunner().invoke(app, ["info", str(copy)])
    rows = dict(line.split(maxsplit=1) for line in told.stdout.splitlines())
    said = f"{rows['machine']} {rows['hash']}, {rows['precision']}"
    assert deployed.version() == f"{said}, Turnbuckle {rows['version']}, {rows['processor']}"
    refused = CliRunner().invoke(app, ["info", "/bin/sh"])
    assert (refused.exit_code, refused.stderr.count("\n")) == (2, 1)
    assert "/bin/sh: found a file that carries no identity" in refused.stderr


def test_a_program_that_runs_goes_on_until_it_is_started_again(
    deployed: Journey, lines: Lines
) -> None:
    options = [*lines.options, "--priority=0"]
    with running(deployed.link, options) as run:
        deployed.run("deploy", "--precision=float")
        run.await_cycles(100)
        assert "float" in deployed.version()
        image = Path(f"/proc/{run.process.pid}/exe").read_bytes()
        assert b", double, Turnbuckle" in image
    with running(deployed.link, options) as run:
        image = Path(f"/proc/{run.process.pid}/exe").read_bytes()
        assert b", float, Turnbuckle" in image


@pytest.mark.parametrize(
    ("was", "said"),
    [
        (b"@(#)turnbuckle yoon2024 ", "a program of yoon2024, not of yoon2023"),
        (b"@(#)something yoon2023", "something else, not of yoon2023"),
    ],
)
def test_another_program_under_this_name_is_said_and_kept(
    deployed: Journey, was: bytes, said: str
) -> None:
    content = re.sub(rb"@\(#\)turnbuckle yoon2023 ?", was, deployed.link.read_bytes())
    deployed.link.unlink()
    deployed.link.write_bytes(content)
    result = deployed.run("deploy", "--precision=float")
    assert said in result.stderr and result.stderr.count("\n") == 1
    deployed.run("rollback")
    assert deployed.link.read_bytes() == content


def without_key(journey: Journey) -> list[str]:
    return [f"--ssh={journey.host.ssh('stranger')}"]


def unknown(journey: Journey) -> list[str]:
    journey.host.know(None)
    return []


def changed(journey: Journey) -> list[str]:
    journey.host.know("stranger")
    return []


def mips(journey: Journey) -> list[str]:
    journey.host.tool("uname", "echo mips64")
    return []


def another_arch(_: Journey) -> list[str]:
    return ["--arch=riscv64"]


def no_sha256sum(journey: Journey) -> list[str]:
    tools = journey.host.folder / "few"
    tools.mkdir(exist_ok=True)
    if not (tools / "sh").exists():
        (tools / "sh").symlink_to("/bin/sh")
    journey.host.configure(str(tools))
    return []


def not_a_folder(_: Journey) -> list[str]:
    return ["--folder=/dev/null/turnbuckle"]


def odd_folder(_: Journey) -> list[str]:
    return ["--folder=my folder"]


def flipping_line(journey: Journey) -> list[str]:
    journey.host.tool("cat", FLIPPED.replace("{python}", sys.executable))
    return []


def no_room(journey: Journey) -> list[str]:
    journey.host.tool("df", "echo Filesystem; echo none 100000 99000 1000 99% /")
    return []


def file_too_large(journey: Journey) -> list[str]:
    journey.host.tool("cat", "trap '' XFSZ; ulimit -f 64; exec {real}")
    return []


def silent(journey: Journey) -> list[str]:
    journey.host.tool("uname", "exec sleep 60")
    return []


def gone(journey: Journey) -> list[str]:
    journey.host.tool("uname", "kill -KILL $PPID")
    return []


SEEDED: dict[Callable[[Journey], list[str]], tuple[str, ...]] = {
    without_key: ("does not let you in by a key", "ssh-copy-id ssh://"),
    unknown: ("its host key is not known here", " true"),
    changed: ("its host key is another than it was", "ssh-keygen -R '[127.0.0.1]:"),
    mips: ("found the processor mips64", "x86_64, aarch64, armv7l, armv8l, riscv64"),
    another_arch: ("--arch: found riscv64; allowed: x86-64", "uname -m says x86_64"),
    no_sha256sum: ("found no sha256sum there", "sudo apt-get install coreutils"),
    not_a_folder: ("you may not write to", "/dev/null", "sudo install -d -o"),
    odd_folder: ('--folder: found "my folder"', "allowed: a path of letters"),
    flipping_line: ("what arrived is not what was sent", "deploy again"),
    no_room: ("found 1.0 MB free; allowed: 2.", "make room"),
    file_too_large: ("the program could not be written there", "File too large", "df -h"),
    silent: ("did not answer within 3 s",),
    gone: ("cannot be reached: the connection was lost", "see whether this works: ssh"),
}


@pytest.mark.parametrize("seed", SEEDED, ids=lambda seed: seed.__name__)
def test_what_stands_in_the_way_is_one_message_and_the_old_program_stays(
    seed: Callable[[Journey], list[str]], deployed: Journey, monkeypatch: pytest.MonkeyPatch
) -> None:
    more = seed(deployed)
    if seed is silent:
        monkeypatch.setattr(host_module, "PATIENCE", 3.0)
    result = deployed.attempt("deploy", "--precision=float", *more)
    deployed.host.know("host")
    deployed.assert_refused(result, *SEEDED[seed])


def test_there_is_nothing_to_go_back_to_before_the_second_deploy(deployed: Journey) -> None:
    deployed.assert_refused(deployed.attempt("rollback"), "there is no program before the one")


def test_a_rollback_of_what_was_never_deployed_is_refused(journey: Journey) -> None:
    result = journey.attempt("rollback")
    assert result.exit_code == 2 and "there is no program before the one" in result.stderr
    assert not journey.folder.exists()


@pytest.mark.parametrize("name", ["-oProxyCommand=touch", "my host", ""])
def test_what_is_no_host_is_refused_before_ssh_sees_it(stock_file: Path, name: str) -> None:
    result = CliRunner().invoke(app, ["deploy", str(stock_file), "--", name])
    assert result.exit_code == 2
    assert f'HOST: found "{name}"; allowed: what ssh takes' in result.stderr


def test_a_host_that_is_not_there_is_told_of(stock_file: Path) -> None:
    with socket.socket() as closed:
        closed.bind(("127.0.0.1", 0))
        name = f"ssh://127.0.0.1:{closed.getsockname()[1]}"
        result = CliRunner().invoke(app, ["deploy", str(stock_file), name])
    assert result.exit_code == 2 and result.stderr.count("\n") == 1
    assert "Connection refused" in result.stderr
    assert f"see whether this works: ssh {name} true" in result.stderr


def test_a_host_that_takes_the_call_and_says_nothing_is_given_up(stock_file: Path) -> None:
    with socket.create_server(("127.0.0.1", 0)) as mute:
        name = f"ssh://127.0.0.1:{mute.getsockname()[1]}"
        words = ["deploy", str(stock_file), name, "--ssh=ssh -oConnectTimeout=1"]
        result = CliRunner().invoke(app, words)
    assert result.exit_code == 2 and result.stderr.count("\n") == 1
    assert "timed out" in result.stderr


def test_a_compiler_that_is_not_here_is_told_with_its_package(
    deployed: Journey, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    deployed.host.tool("uname", "echo riscv64")
    (tmp_path / "ssh").symlink_to(shutil.which("ssh") or "ssh")
    monkeypatch.setenv("PATH", str(tmp_path))
    result = deployed.attempt("deploy")
    monkeypatch.undo()
    install = "sudo apt-get install --no-install-recommends gcc-riscv64-linux-gnu"
    deployed.assert_refused(result, "riscv64-linux-gnu-gcc", install, "libc6-dev-riscv64-cross")


def test_a_computer_without_ssh_is_told_with_its_package(deployed: Journey, tmp_path: Path) -> None:
    result = deployed.attempt("deploy", f"--ssh={tmp_path}/ssh")
    deployed.assert_refused(result, "is not installed here", "openssh-client")


def test_a_machine_without_buses_is_refused(deployed: Journey) -> None:
    deployed.file = deployed.file.with_name("brau_square.toml")
    deployed.assert_refused(deployed.attempt("deploy"), "bus: found none")


def await_gone(path: Path) -> None:
    """The shell there may end later than the connection to it."""
    begin = time.monotonic()
    while path.exists():
        assert time.monotonic() - begin < PATIENCE, "the copy stays"
        time.sleep(0.005)


def test_a_deploy_killed_in_the_middle_of_its_copy_changes_nothing_and_a_second_mends(
    deployed: Journey, tmp_path: Path
) -> None:
    here, pipe = tmp_path / "here", tmp_path / "pipe"
    os.mkfifo(here)
    os.mkfifo(pipe)
    deployed.host.tool("cat", HELD.format(here=here, pipe=pipe, real="{real}"))
    child = os.fork()
    if child == 0:
        deployed.attempt("deploy", "--precision=float")
        os._exit(0)
    here.read_text()
    (copy,) = deployed.folder.rglob(".copy.*")
    os.kill(child, signal.SIGKILL)
    os.waitpid(child, 0)
    pipe.write_text("\n")
    await_gone(copy)
    assert "double" in deployed.version()
    (deployed.host.tools / "cat").unlink()
    assert "float" in now_of(deployed.run("deploy", "--precision=float"))


def test_two_deploys_at_once_leave_both_programs(deployed: Journey) -> None:
    deployed.run("deploy", "--precision=float")  # both are compiled: what follows is the copying
    machine = load_machine(deployed.file)
    host = Host(deployed.host.name, deployed.host.ssh())
    with ThreadPoolExecutor(4) as pool:
        done = [
            pool.submit(deploy, machine, host, str(deployed.folder), None, precision, print)
            for precision in 2 * ("double", "float")
        ]
    assert len({each.result().now.sha256 for each in done}) == 2
    assert "x86-64" in deployed.version()
    assert len(list((deployed.folder / "yoon2023").glob("turnbuckle-*"))) == 2
