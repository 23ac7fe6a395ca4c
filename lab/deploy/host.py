"""Another computer, reached by ssh: asks nothing of a person, and waits for nothing without end."""

import shlex
import signal
import subprocess
from collections.abc import Sequence
from functools import partial
from pathlib import Path

from turnbuckle.codegen.processes import hear_of_death
from turnbuckle.lab.deploy import DeployError
from turnbuckle.lab.deploy.trouble import refused, unreached

SCRIPT = Path(__file__).with_name("host.sh")
#: No question that nobody sees; a host that does not answer is given up.
OPTIONS = (
    "-oBatchMode=yes",
    "-oConnectTimeout=10",
    "-oServerAliveInterval=5",
    "-oServerAliveCountMax=4",
)
PATIENCE = 240.0
"""Seconds for one thing done there; more than the waits of host.sh and of OPTIONS together."""
COPYING = 900.0
"""Seconds for one that copies a program."""
BEGIN = "turnbuckle answers\n"
OF_SSH = 255
"""Exit status of ssh where it is ssh that has failed."""
Answer = dict[str, str]
"""Lines of host.sh by their first word."""


class Host:
    """A computer, by the name that ssh takes."""

    def __init__(self, name: str, ssh: str = "ssh") -> None:
        """ssh: the command with its options. Raises DeployError for what can be neither."""
        if not name or name.startswith("-") or any(letter.isspace() for letter in name):
            raise DeployError(
                f'HOST: found "{name}"; allowed: what ssh takes, such as pi@192.168.0.7'
            )
        self.name, self._ssh = name, shlex.split(ssh) or ["ssh"]

    def command(self, words: str, terminal: bool = False) -> str:
        """What a person types here to have something done there."""
        return shlex.join([*self._ssh, *(["-t"] if terminal else []), self.name, words])

    def do(self, task: Sequence[str], given: Path | None = None) -> Answer:
        """Let host.sh do a task there; given: the file that it reads.

        Raises DeployError where the host is not reached, or host.sh refuses.
        """
        words = shlex.join(["sh", "-c", SCRIPT.read_text(), SCRIPT.name, *task])
        done = self._run([*self._ssh, *OPTIONS, "--", self.name, words], given)
        if done.returncode == OF_SSH:
            raise DeployError(unreached(self.name, self.command, done.stderr))
        _, _, told = done.stdout.partition(BEGIN)
        answer = dict(_pair(line) for line in told.splitlines())
        if done.returncode or "refused" in answer:
            reason = answer.get("refused") or f"else {done.stderr}"
            raise DeployError(refused(self.name, self.command, *_pair(reason)))
        return answer

    def _run(
        self, command: Sequence[str], given: Path | None
    ) -> "subprocess.CompletedProcess[str]":
        limit = PATIENCE if given is None else COPYING
        try:
            with open(given or "/dev/null", "rb") as source:
                return subprocess.run(
                    command,
                    stdin=source,
                    capture_output=True,
                    text=True,
                    errors="replace",
                    timeout=limit,
                    preexec_fn=partial(hear_of_death, signal.SIGTERM),
                )
        except subprocess.TimeoutExpired:
            raise DeployError(
                f"{self.name}: did not answer within {limit:.0f} s; nothing was switched that was"
                " not told; try again"
            ) from None
        except FileNotFoundError:
            raise DeployError(
                f"{command[0]} is not installed here; sudo apt-get install openssh-client"
            ) from None


def _pair(line: str) -> tuple[str, str]:
    key, _, words = line.strip().partition(" ")
    return key, words.strip()
