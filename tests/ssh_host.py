"""A host that ssh reaches: a real sshd on loopback, with keys of its own, for this user."""

import getpass
import os
import shlex
import socket
import subprocess
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

SSHD = "/usr/sbin/sshd"
PRIVILEGE_SEPARATION = Path("/run/sshd")
"""Debian's init script makes it; the superuser's sshd does not start without."""


class SshHost:
    """Takes connections until it is closed, each by an sshd that reads its configuration anew."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.tools = folder / "tools"
        """Programs that the host finds before all others."""
        self.tools.mkdir(parents=True)
        for name in ("host", "key", "stranger"):
            words = ["ssh-keygen", "-q", "-t", "ed25519", "-N", "", "-f", str(folder / name)]
            subprocess.run(words, check=True)
        if os.geteuid() == 0:
            PRIVILEGE_SEPARATION.mkdir(exist_ok=True)
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.port = int(self._listener.getsockname()[1])
        self.known = folder / "known_hosts"
        self.know("host")
        self.configure()
        self._connections: list[subprocess.Popen[bytes]] = []
        self._thread = threading.Thread(target=self._serve)
        self._thread.start()

    @property
    def name(self) -> str:
        """As ssh takes it."""
        return f"ssh://{getpass.getuser()}@127.0.0.1:{self.port}"

    def ssh(self, key: str = "key") -> str:
        """The command ssh with this host's keys, and nothing of the user's own configuration."""
        options = {
            "UserKnownHostsFile": self.known,
            "GlobalKnownHostsFile": "/dev/null",
            "IdentityFile": self.folder / key,
            "IdentitiesOnly": "yes",
        }
        return shlex.join(["ssh", "-F/dev/null", *(f"-o{k}={v}" for k, v in options.items())])

    def know(self, key: str | None) -> None:
        """Let this be the key by which the host is known; None for none."""
        line = f"[127.0.0.1]:{self.port} {(self.folder / f'{key}.pub').read_text()}" if key else ""
        self.known.write_text(line)

    def configure(self, path: str | None = None) -> None:
        """Let programs be found in the host's tools, then in `path`."""
        path = path or os.environ["PATH"]
        (self.folder / "sshd_config").write_text(
            f"HostKey {self.folder}/host\n"
            f"AuthorizedKeysFile {self.folder}/key.pub\n"
            "AuthenticationMethods publickey\n"
            "PermitRootLogin prohibit-password\n"
            "StrictModes no\n"
            # With a shell level bash reads no start files of the user's: they may change the path.
            f"SetEnv PATH={self.tools}:{path} SHLVL=1\n"
        )

    def tool(self, name: str, script: str) -> None:
        """Let the host find this shell script under a name; {real} in it is the real program."""
        found = subprocess.run(["which", name], capture_output=True, text=True, check=False)
        path = self.tools / name
        path.write_text("#!/bin/sh\n" + script.replace("{real}", found.stdout.strip()))
        path.chmod(0o755)

    def close(self) -> None:
        """Take no connection any more, and end those that are there."""
        self._listener.shutdown(socket.SHUT_RDWR)
        self._thread.join()
        self._listener.close()
        for connection in self._connections:
            connection.terminate()
            connection.wait()

    def _serve(self) -> None:
        words = [SSHD, "-i", "-f", str(self.folder / "sshd_config"), "-E", str(self.folder / "log")]
        while True:
            try:
                connection, _ = self._listener.accept()
            except OSError:
                return
            with connection:
                self._connections.append(
                    subprocess.Popen(words, stdin=connection.fileno(), stdout=connection.fileno())
                )


@contextmanager
def ssh_host(folder: Path) -> Iterator[SshHost]:
    """A host while the context lasts."""
    host = SshHost(folder)
    try:
        yield host
    finally:
        host.close()
