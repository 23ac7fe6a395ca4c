"""A Linux guest with real CAN: runs a command of this host on a kernel that has SocketCAN.

The kernel is Debian's, in QEMU without hardware acceleration; virtual CAN interfaces are up. The
host's root is the guest's, read-only: the same programs and paths, the virtual environment, what
was compiled before. /run is empty and writable, and is the home folder; there is no network. It
takes about four seconds more than its command, fifteen when nothing is prepared.

    python tests/guest.py [--interfaces vcan0,vcan1] COMMAND ...
"""

import argparse
import contextlib
import fcntl
import hashlib
import lzma
import os
import re
import shlex
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import threading
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parents[1]
#: The kernel as downloaded and what is made of it; safe to delete.
CACHE = ROOT / "build" / "guest"
#: Kernel modules, with all that they need: raw CAN, its virtual interfaces, the host's files.
MODULES = ("can_raw", "vcan", "vxcan", "slcan", "virtio_pci", "9pnet_virtio", "9p")
#: The last line of the output, before the exit status of the command.
STATUS = "guest: exit status "

INIT = f"""#!/bin/busybox sh
/bin/busybox --install -s /bin
export PATH=/bin
mount -t devtmpfs dev /dev && mkdir -p /dev/pts /dev/shm
mount -t devpts pts /dev/pts
mount -t tmpfs shm /dev/shm
stty -F /dev/console -opost
while read -r module; do insmod /modules/$module; done </modules/order
mount -t 9p -o ro,trans=virtio,version=9p2000.L,msize=512000,cache=loose host /host
mount -t proc proc /host/proc
mount -t sysfs sys /host/sys
mount -t tmpfs run /host/run
mount --rbind /dev /host/dev
ip link set lo up
for name in $(echo $interfaces | tr , ' '); do
  ip link add $name type vcan && ip link set $name mtu 72 up
done
chroot /host /bin/sh "$job" </dev/null 2>&1
echo "{STATUS}$?"
stty -F /dev/console sane # not before all is written
poweroff -f
"""


class GuestError(Exception):
    """The guest could not be started, or did not end as it should; the text holds its output."""


@dataclass(frozen=True)
class Finished:
    """How a command in the guest ended: its exit status; its output and errors, as they came."""

    status: int
    output: str


@dataclass(frozen=True)
class Boot:
    """What QEMU boots."""

    kernel: Path
    initrd: Path


def run_in_guest(
    command: Sequence[str | Path],
    *,
    interfaces: Sequence[str] = ("vcan0",),
    environment: Mapping[str, str] | None = None,
    folder: Path = ROOT,
    seconds: float = 1800.0,
    on_line: Callable[[str], object] = lambda line: None,
) -> Finished:
    """Run a command of the host in the guest, from a folder of the host, with vcan interfaces up.

    `environment` is added to a bare one in which Python finds this repository. Every line of output
    goes to `on_line` when it comes. Raises GuestError when the guest has not ended by itself after
    some seconds, or has ended before the command.
    """
    with tempfile.TemporaryDirectory(prefix="guest-") as scratch:
        job = Path(scratch) / "job.sh"
        job.write_text(job_script(command, environment or {}, folder))
        lines = guest_lines(qemu_command(boot_files(), job, interfaces), seconds, on_line)
    output = "".join(f"{line}\n" for line in lines)
    found = re.search(f"^(.*?)^{STATUS}(\\d+)$", output, re.DOTALL | re.MULTILINE)
    if not found:
        raise GuestError(f"the guest ended before its command did:\n{output}")
    return Finished(int(found[2]), found[1])


def job_script(command: Sequence[str | Path], environment: Mapping[str, str], folder: Path) -> str:
    """The shell script that the guest runs."""
    bare = {
        "PATH": os.environ.get("PATH", os.defpath),
        "HOME": "/run",
        "TMPDIR": "/run",
        "PYTHONPATH": str(ROOT),
        "PYTHONDONTWRITEBYTECODE": "1",
        "PYTHONUNBUFFERED": "1",
    }
    exports = [f"export {n}={shlex.quote(v)}" for n, v in {**bare, **environment}.items()]
    return "\n".join(
        [*exports, f"cd {shlex.quote(str(folder))}", f"exec {shlex.join(map(str, command))}", ""]
    )


def guest_lines(
    command: Sequence[str], seconds: float, on_line: Callable[[str], object]
) -> list[str]:
    """What a guest prints until it ends."""
    guest = subprocess.Popen(
        command,
        env={**os.environ, "QEMU_AUDIO_DRV": "none"},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
    )
    watchdog = threading.Timer(seconds, guest.kill)
    watchdog.start()
    lines: list[str] = []
    try:
        assert guest.stdout is not None
        for line in guest.stdout:
            lines.append(line.rstrip("\r\n"))
            on_line(lines[-1])
    finally:
        watchdog.cancel()
        guest.kill()
        status = guest.wait()
    if status == -signal.SIGKILL:
        raise GuestError(f"the guest took longer than {seconds:g} s:\n" + "\n".join(lines))
    return lines


def qemu_command(boot: Boot, job: Path, interfaces: Sequence[str]) -> list[str]:
    """QEMU with the guest's console on its standard output, and a serial line to nowhere."""
    parameters = f"console=ttyS0 loglevel=1 panic=-1 nokaslr mitigations=off job={job}"
    return [
        *("qemu-system-x86_64", "-accel", "tcg", "-cpu", "max", "-M", "pc", "-m", "1G"),
        *("-nodefaults", "-no-user-config", "-display", "none", "-monitor", "none"),
        *("-serial", "stdio", "-serial", "null", "-no-reboot", "-kernel", str(boot.kernel)),
        *("-initrd", str(boot.initrd)),
        *("-append", f"{parameters} interfaces={','.join(interfaces)}"),
        *("-virtfs", "local,path=/,mount_tag=host,security_model=none,readonly=on,multidevs=remap"),
    ]


def boot_files() -> Boot:
    """Kernel and first files, made once: later calls, and calls meanwhile, take what is there."""
    key = hashlib.sha256(f"{INIT}{MODULES}".encode()).hexdigest()[:16]
    folder = CACHE / key
    boot = Boot(folder / "vmlinux", folder / "initrd.gz")
    CACHE.mkdir(parents=True, exist_ok=True)
    with (CACHE / "lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not folder.exists():
            with tempfile.TemporaryDirectory(dir=CACHE) as scratch:
                make_boot_files(kernel_package(), Path(scratch))
                os.replace(Path(scratch) / "boot", folder)
    return boot


def make_boot_files(package: Path, scratch: Path) -> None:
    """Write vmlinux and initrd.gz to `scratch/boot`."""
    subprocess.run(["dpkg-deb", "--extract", package, scratch / "package"], check=True)
    (image,) = (scratch / "package" / "boot").glob("vmlinuz-*")
    boot = scratch / "boot"
    boot.mkdir()
    (boot / "vmlinux").write_bytes(uncompressed(image.read_bytes()))
    first_files(scratch / "package" / "lib" / "modules", scratch / "root")
    archive = "find . | busybox cpio -o -H newc 2>/dev/null | gzip -1"
    content = subprocess.check_output(archive, shell=True, cwd=scratch / "root")
    (boot / "initrd.gz").write_bytes(content)


def first_files(modules: Path, root: Path) -> None:
    """Fill the folder that the guest starts from: busybox, the script it runs, kernel modules."""
    for name in ("bin", "dev", "host", "modules"):
        (root / name).mkdir(parents=True)
    busybox = shutil.which("busybox")
    if busybox is None:
        raise GuestError("busybox is not installed: make setup")
    shutil.copy(busybox, root / "bin" / "busybox")
    (root / "init").write_text(INIT)
    (root / "init").chmod(0o755)
    order = in_load_order({path.stem.replace("-", "_"): path for path in modules.rglob("*.ko")})
    for path in order:
        shutil.copy(path, root / "modules")
    names = "".join(f"{path.name}\n" for path in order)
    (root / "modules" / "order").write_text(names)


def in_load_order(files: Mapping[str, Path]) -> list[Path]:
    """The modules, each after those that it needs; what is no file is part of the kernel."""
    order: list[Path] = []

    def add(name: str) -> None:
        path = files[name]
        needed = re.search(rb"\0depends=([^\0]*)\0", path.read_bytes())
        for other in needed[1].decode().replace("-", "_").split(",") if needed else []:
            if other in files:
                add(other)
        if path not in order:
            order.append(path)

    for name in MODULES:
        add(name)
    return order


def uncompressed(image: bytes) -> bytes:
    """The kernel inside a bzImage: QEMU starts it in less than half the time.

    Offsets as in Documentation/arch/x86/boot.rst of the kernel: setup_sects, payload_offset,
    payload_length. Debian compresses by XZ.
    """
    start = ((image[0x1F1] or 4) + 1) * 512
    offset, length = struct.unpack_from("<II", image, 0x248)
    return lzma.LZMADecompressor().decompress(image[start + offset : start + offset + length])


def kernel_package() -> Path:
    """Debian's kernel for a PC, downloaded when it is not there."""
    found = sorted(CACHE.glob("linux-image-*.deb"))
    if not found:
        download_kernel()
        found = sorted(CACHE.glob("linux-image-*.deb"))
    return found[-1]


def download_kernel() -> None:
    """Download the package that Debian's linux-image-amd64 stands for today."""
    if apt_download().returncode:
        as_root = [] if os.geteuid() == 0 else ["sudo", "--non-interactive"]
        with contextlib.suppress(FileNotFoundError):
            subprocess.run([*as_root, "apt-get", "--quiet", "update"], check=False)
        done = apt_download()
        if done.returncode:
            raise GuestError(
                "Debian's kernel, which tests run in a guest, cannot be downloaded: "
                f"see whether `sudo apt-get update` helps\n{done.stderr}"
            )


def apt_download() -> subprocess.CompletedProcess[str]:
    """Download the kernel's package into the cache, from the package lists as they are."""
    told = subprocess.run(
        ["apt-cache", "depends", "linux-image-amd64"], capture_output=True, text=True, check=False
    )
    name = re.search(r"Depends: (linux-image-\S+)", told.stdout)
    if not name:
        return subprocess.CompletedProcess([], 1, "", "apt knows no package linux-image-amd64")
    return subprocess.run(
        ["apt-get", "--quiet", "download", name[1]],
        cwd=CACHE,
        capture_output=True,
        text=True,
        check=False,
    )


def main() -> int:
    """Run a command in the guest from the command line."""
    parser = argparse.ArgumentParser(description="run a command in a Linux guest with CAN")
    parser.add_argument("--interfaces", default="vcan0", help="names, with commas between")
    parser.add_argument("--seconds", type=float, default=1800.0, help="the longest it may take")
    parser.add_argument("command", nargs=argparse.REMAINDER)
    given = parser.parse_args()
    try:
        done = run_in_guest(
            given.command,
            interfaces=given.interfaces.split(","),
            folder=Path.cwd(),
            seconds=given.seconds,
            on_line=lambda line: print(line, flush=True),
        )
    except GuestError as error:
        print(error, file=sys.stderr)
        return 1
    return done.status


if __name__ == "__main__":
    sys.exit(main())
