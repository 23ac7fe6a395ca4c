"""The systemd unit, as systemd reads it."""

import subprocess
from pathlib import Path

import pytest

UNIT = Path(__file__).parents[2] / "runtime" / "port" / "linux" / "turnbuckle@.service"
PROGRAM = "/opt/turnbuckle/%i/turnbuckle"


def verify(text: str, folder: Path) -> "subprocess.CompletedProcess[str]":
    """What systemd says of a unit, whose program is there."""
    path = folder / UNIT.name
    path.write_text(text.replace(PROGRAM, "/bin/true"))
    return subprocess.run(["systemd-analyze", "verify", path], capture_output=True, text=True)


def test_systemd_accepts_the_unit_without_a_word(tmp_path: Path) -> None:
    done = verify(UNIT.read_text(), tmp_path)
    assert (done.returncode, done.stdout + done.stderr) == (0, "")


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ("WatchdogSec=500ms", "WatchdogSec=5oo"),
        ("LimitRTPRIO=", "LimitRTPRI="),
        ("LimitMEMLOCK=infinity", "LimitMEMLOCK=all"),
        ("SystemCallFilter=@system-service", "SystemCallFilter=@systemservice"),
        ("Type=notify", "Type=notified"),
    ],
)
def test_a_mistake_in_the_unit_is_seen(tmp_path: Path, right: str, wrong: str) -> None:
    text = UNIT.read_text()
    assert right in text
    done = verify(text.replace(right, wrong), tmp_path)
    assert done.stdout + done.stderr != ""


def test_every_run_has_a_recording_of_its_own_whose_writer_outlives_a_kill() -> None:
    lines = UNIT.read_text().splitlines()
    assert {"StateDirectory=turnbuckle", "KillMode=process"} <= set(lines)
    (start,) = (line for line in lines if line.startswith("ExecStart="))
    assert " --record /var/lib/turnbuckle " in start


def test_the_watchdog_kills_and_nothing_starts_again_by_itself() -> None:
    lines = UNIT.read_text().splitlines()
    for line in ("WatchdogSignal=SIGKILL", "Restart=no", "KillSignal=SIGTERM", "LimitRTPRIO=90"):
        assert line in lines
