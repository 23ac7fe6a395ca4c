"""The tests of CANopen again, under the address and undefined-behaviour sanitizers."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]
SANITIZED = "gcc -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer"
TESTS = [
    "unit/test_canopen_messages.py",
    "unit/test_emcy.py",
    "wire/test_sdo.py",
    "wire/test_drive_setup.py",
    "wire/test_network.py",
]
# Fewer examples than else: the sanitizers slow Python down more than they do the C.
PROFILE = """
from hypothesis import HealthCheck, settings
settings.register_profile("sanitized", deadline=None, derandomize=True, max_examples=5,
                          suppress_health_check=list(HealthCheck))
settings.load_profile("sanitized")
"""


def run(runtime: Path, folder: Path, *tests: str) -> subprocess.CompletedProcess[str]:
    """Some tests with sanitized C; Python's memory comes from malloc, which they watch."""
    (folder / "sanitized_profile.py").write_text(PROFILE)
    named = ["gcc", "-print-file-name=libasan.so"]
    asan = subprocess.run(named, capture_output=True, text=True, check=True)
    environment = {
        **os.environ,
        "CC": SANITIZED,
        "LD_PRELOAD": asan.stdout.strip(),
        "ASAN_OPTIONS": "detect_leaks=0",  # Python keeps what it needs until its end
        "PYTHONMALLOC": "malloc",
        "PYTHONPATH": os.pathsep.join(map(str, (folder, ROOT, ROOT / "tests"))),
        "TURNBUCKLE_RUNTIME": str(runtime),
    }
    files = [str(ROOT / "tests" / name) for name in tests]
    options = ["-q", "-x", "-s", "--noconftest", "-p", "sanitized_profile"]
    command = [sys.executable, "-m", "pytest", *options, *files]
    return subprocess.run(
        command, cwd=ROOT, env=environment, capture_output=True, text=True, check=False
    )


def test_no_test_of_canopen_leaves_its_memory_or_the_language(tmp_path: Path) -> None:
    done = run(ROOT / "runtime", tmp_path, *TESTS)
    assert done.returncode == 0, done.stdout + done.stderr


def test_a_byte_beyond_the_room_is_found(tmp_path: Path) -> None:
    runtime = tmp_path / "runtime"
    shutil.copytree(ROOT / "runtime", runtime)
    source = runtime / "canopen" / "sdo.c"
    text = source.read_text()
    old, new = "memcpy(client->target, &data[4], count);", "memcpy(client->target, &data[4], 40u);"
    assert text.count(old) == 1
    source.write_text(text.replace(old, new))
    done = run(runtime, tmp_path, "wire/test_sdo.py")
    assert done.returncode != 0
    assert "AddressSanitizer" in done.stdout + done.stderr
