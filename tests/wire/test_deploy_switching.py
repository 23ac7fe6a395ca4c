"""host.sh, which does the host's part of a deploy: it switches at once, or not at all."""

import hashlib
import os
import shutil
import subprocess
import threading
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

import pytest

from turnbuckle.lab.deploy.host import SCRIPT
from turnbuckle.lab.deploy.identity import carried_identity

STEPS = ("chmod", "ln", "mktemp", "mv", "rm", "sync")
"""Programs that host.sh changes the folder with."""
KILLER = """#!/bin/sh
echo . >>{count}
if [ "$(wc -l <{count})" = "$FATAL" ]; then kill -KILL "$PPID"; exit 1; fi
exec {real} "$@"
"""


class There:
    """A machine's folder, and what host.sh does in it."""

    def __init__(self, folder: Path, program: Path) -> None:
        self.folder, self.work = folder / "there", folder
        self.script = SCRIPT.read_text()
        content = program.read_bytes()
        # What follows the end of an ELF file is not read when it runs: one program, other bytes.
        self.versions = [folder / f"version{number}" for number in range(4)]
        for number, path in enumerate(self.versions):
            path.write_bytes(content + b"\n" * number)
        self.identity = str(carried_identity(program))

    def run(
        self, task: Sequence[str], given: Path | None = None, **environment: str
    ) -> "subprocess.CompletedProcess[str]":
        """Let host.sh do something."""
        with open(given or "/dev/null", "rb") as source:
            return subprocess.run(
                ["sh", "-c", self.script, SCRIPT.name, *task],
                stdin=source,
                capture_output=True,
                text=True,
                env=os.environ | environment,
                check=False,
            )

    def receive(self, number: int, **environment: str) -> "subprocess.CompletedProcess[str]":
        """Bring a version there."""
        task = ["receive", str(self.folder), sha256(self.versions[number]), self.identity]
        return self.run(task, self.versions[number], **environment)

    def rollback(self, **environment: str) -> "subprocess.CompletedProcess[str]":
        """Switch back."""
        return self.run(["rollback", str(self.folder)], None, **environment)

    def state(self) -> tuple[int | None, int | None]:
        """Versions in use and before; None for none. Each is whole."""
        numbers = {sha256(path): number for number, path in enumerate(self.versions)}
        links = (self.folder / "turnbuckle", self.folder / "current" / "previous")
        now, previous = (numbers[sha256(link)] if link.exists() else None for link in links)
        return now, previous

    def entries(self) -> int:
        """How many things there are in the folder."""
        return len(list(self.folder.iterdir()))

    def killing_tools(self) -> Path:
        """Programs that kill host.sh in place of the call whose number is FATAL."""
        tools = self.work / "tools"
        tools.mkdir(exist_ok=True)
        for name in STEPS:
            script = KILLER.format(count=self.work / "count", real=shutil.which(name))
            (tools / name).write_text(script)
            (tools / name).chmod(0o755)
        return tools

    def dies_at(self, step: int) -> dict[str, str]:
        """The environment in which it is killed at a step."""
        (self.work / "count").unlink(missing_ok=True)
        return {"PATH": f"{self.killing_tools()}:{os.environ['PATH']}", "FATAL": str(step)}


def sha256(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def told(done: "subprocess.CompletedProcess[str]") -> Mapping[str, str]:
    """The answer, by its keys."""
    lines = (line.partition(" ") for line in done.stdout.splitlines())
    return {key: words for key, _, words in lines}


@pytest.fixture
def there(tmp_path: Path, program: Path) -> There:
    return There(tmp_path, program)


def test_every_version_is_switched_to_and_the_one_before_kept(there: There) -> None:
    for number, wanted in ((0, (0, None)), (1, (1, 0)), (1, (1, 0)), (2, (2, 1)), (1, (1, 2))):
        done = there.receive(number)
        assert done.returncode == 0, done.stdout + done.stderr
        assert there.state() == wanted
    assert there.entries() == 6  # two programs, two links, what both are in, the lock
    link = there.folder / "turnbuckle"
    version = subprocess.run([link, "--version"], capture_output=True, text=True, check=True)
    assert version.stdout.strip() == there.identity


def test_rollback_goes_back_and_forth(there: There) -> None:
    there.receive(0)
    assert told(there.rollback())["refused"].strip() == "previous"
    there.receive(1)
    for wanted in ((0, 1), (1, 0)):
        assert there.rollback().returncode == 0
        assert there.state() == wanted


def test_a_rollback_to_a_program_that_was_damaged_is_refused(there: There) -> None:
    there.receive(0)
    there.receive(1)
    kept = there.folder / f"turnbuckle-{sha256(there.versions[0])}"
    flipped = bytearray(kept.read_bytes())
    flipped[len(flipped) // 2] ^= 1
    kept.write_bytes(flipped)
    assert told(there.rollback())["refused"].startswith("damaged")
    assert sha256(there.folder / "turnbuckle") == sha256(there.versions[1])


def outcomes(there: There) -> Iterator[str]:
    """What a deploy that was killed at its first step, its second and so on has left."""
    there.receive(0)
    there.receive(1)
    for step in range(1, 100):
        old, older = there.state()
        new = 3 - (old or 0) - (older or 0)
        is_whole = there.receive(new, **there.dies_at(step)).returncode == 0
        yield {(old, older): "old", (new, old): "new"}.get(there.state(), "neither")
        there.receive(new)
        assert there.state() == (new, old)
        if is_whole:
            return


def test_killed_at_any_step_it_leaves_the_old_or_the_new_and_a_second_run_mends(
    there: There,
) -> None:
    left = list(outcomes(there))
    assert len(left) > len(STEPS)
    assert left == sorted(left, key=["old", "new"].index) and left[0] == "old"
    assert left.count("new") > 1


def test_a_switch_that_is_not_atomic_is_noticed(there: There) -> None:
    there.script = there.script.replace('mv -fT ".link.$1"', 'rm -f "$1" && mv -fT ".link.$1"')
    assert there.script != SCRIPT.read_text()
    assert "neither" in outcomes(there)


def test_a_rollback_killed_at_any_step_keeps_both_programs(there: There) -> None:
    there.receive(0)
    there.receive(1)
    killed = 0
    for step in range(1, 100):
        before = there.state()
        is_whole = there.rollback(**there.dies_at(step)).returncode == 0
        assert there.state() in (before, before[::-1])
        if is_whole:
            break
        killed += 1
    assert killed > len(STEPS)


def test_many_at_once_do_no_harm(there: There) -> None:
    workers = [threading.Thread(target=there.receive, args=(number % 4,)) for number in range(12)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    now, previous = there.state()
    assert now is not None and previous is not None and now != previous
    assert there.entries() == 6


def test_a_copy_with_a_flipped_bit_is_never_switched_to(there: There) -> None:
    there.receive(0)
    wanted = sha256(there.versions[1])
    flipped = bytearray(there.versions[1].read_bytes())
    flipped[1000] ^= 4
    there.versions[1].write_bytes(flipped)
    done = there.run(["receive", str(there.folder), wanted, there.identity], there.versions[1])
    assert told(done)["refused"].strip() == "changed"
    assert (there.state(), there.entries()) == ((0, None), 5)


def test_what_does_not_start_there_is_never_switched_to(there: There, tmp_path: Path) -> None:
    there.receive(0)
    silent = tmp_path / "silent"
    silent.write_bytes(there.versions[1].read_bytes()[:4096])
    done = there.run(["receive", str(there.folder), sha256(silent), there.identity], silent)
    assert told(done)["refused"].startswith("start")
    other = there.identity.replace("yoon2023", "other")
    done = there.run(
        ["receive", str(there.folder), sha256(there.versions[1]), other], there.versions[1]
    )
    assert told(done)["refused"] == f"start {there.identity}"
    assert (there.state(), there.entries()) == ((0, None), 5)


def test_a_program_that_was_put_there_by_hand_becomes_the_previous_one(there: There) -> None:
    there.folder.mkdir()
    shutil.copy(there.versions[3], there.folder / "turnbuckle")
    assert told(there.receive(0))["before"].startswith(sha256(there.versions[3]))
    assert there.state() == (0, 3)
    assert there.rollback().returncode == 0
    assert there.state() == (3, 0)


def test_what_the_user_keeps_in_the_folder_stays(there: There) -> None:
    there.folder.mkdir()
    for name in ("turnbuckle-old", "turnbuckle-cafe", "notes"):
        (there.folder / name).write_text(name)
    for number in range(3):
        there.receive(number)
    for name in ("turnbuckle-old", "turnbuckle-cafe", "notes"):
        assert (there.folder / name).read_text() == name
