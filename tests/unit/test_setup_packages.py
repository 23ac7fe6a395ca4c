"""`.ci/install_packages` against a fake Debian: stub commands that record what they are asked."""

import subprocess
from dataclasses import dataclass
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[2] / ".ci" / "install_packages"
HOST_COMMANDS = ("bash", "env", "grep")


@dataclass(frozen=True)
class FakeDebian:
    """A folder that is the whole PATH; `journal` gets one line for each privileged command."""

    folder: Path

    @property
    def journal(self) -> list[str]:
        path = self.folder / "journal"
        return path.read_text().splitlines() if path.exists() else []

    def command(self, name: str, body: str) -> None:
        path = self.folder / name
        path.write_text(f"#!/bin/bash\n{body}\n")
        path.chmod(0o755)

    def install(self, packages: str) -> subprocess.CompletedProcess[str]:
        wanted = self.folder / "packages"
        wanted.write_text(packages)
        return subprocess.run(
            ["/bin/bash", str(SCRIPT), str(wanted)],
            env={"PATH": str(self.folder)},
            capture_output=True,
            text=True,
            check=False,
        )


@pytest.fixture
def debian(tmp_path: Path) -> FakeDebian:
    """A machine of an ordinary user without sudo; only the package `present` is installed."""
    fake = FakeDebian(tmp_path)
    for name in HOST_COMMANDS:
        (tmp_path / name).symlink_to(f"/usr/bin/{name}")
    fake.command("dpkg-query", '[ "${@: -1}" = present ] && printf installed')
    fake.command("id", "echo 1000")
    fake.command("apt-get", f'echo "apt-get $*" >> {tmp_path}/journal')
    return fake


def become_root(debian: FakeDebian) -> None:
    debian.command("id", "echo 0")


def allow_sudo(debian: FakeDebian) -> None:
    journal = debian.folder / "journal"
    debian.command("sudo", f'[ "$2" = true ] || {{ echo sudo >> {journal}; "${{@:2}}"; }}')


def test_nothing_is_asked_for_when_nothing_is_missing(debian: FakeDebian) -> None:
    result = debian.install("present\n")
    assert (result.returncode, result.stdout, result.stderr) == (0, "", "")
    assert debian.journal == []


def test_root_installs_only_what_is_missing(debian: FakeDebian) -> None:
    become_root(debian)
    assert debian.install("# a comment\npresent\nabsent-one\nabsent-two\n").returncode == 0
    update, install = debian.journal
    assert update.endswith("update")
    assert install.endswith("install --yes --no-install-recommends absent-one absent-two")


def test_sudo_without_a_password_is_used(debian: FakeDebian) -> None:
    allow_sudo(debian)
    assert debian.install("absent\n").returncode == 0
    assert [line.split()[0] for line in debian.journal] == ["sudo", "apt-get", "sudo", "apt-get"]


def test_an_ordinary_user_is_given_the_line_to_run(debian: FakeDebian) -> None:
    result = debian.install("present\nabsent\n")
    assert result.returncode == 1
    assert "install --no-install-recommends absent\n" in result.stderr
    assert debian.journal == []


def test_a_failing_install_fails_the_set_up(debian: FakeDebian) -> None:
    become_root(debian)
    debian.command("apt-get", "exit 100")
    assert debian.install("absent\n").returncode != 0
