"""Processors that the Linux program is built for, and what a host says of its own."""

from dataclasses import dataclass

from turnbuckle.lab.deploy import DeployError


@dataclass(frozen=True)
class Processor:
    """One that can be built for."""

    arch: str
    """As users write it."""
    name: str
    """As programs tell it: runtime/core/identity.c."""
    machines: tuple[str, ...]
    """What `uname -m` says."""
    triple: str
    """What the names of its compiler and linker begin with."""
    packages: tuple[str, ...]
    """Of Debian, with compiler and C library."""

    @property
    def compiler(self) -> str:
        """The command that compiles for it."""
        return f"{self.triple}-gcc"


#: A kernel of 64 bits may be told to call itself armv8l; the program is ARMv7's then.
PROCESSORS = (
    Processor("x86-64", "x86-64", ("x86_64",), "x86_64-linux-gnu", ("gcc", "libc6-dev")),
    Processor(
        "aarch64",
        "AArch64",
        ("aarch64",),
        "aarch64-linux-gnu",
        ("gcc-aarch64-linux-gnu", "libc6-dev-arm64-cross"),
    ),
    Processor(
        "armv7",
        "ARMv7",
        ("armv7l", "armv8l"),
        "arm-linux-gnueabihf",
        ("gcc-arm-linux-gnueabihf", "libc6-dev-armhf-cross"),
    ),
    Processor(
        "riscv64",
        "RISC-V 64",
        ("riscv64",),
        "riscv64-linux-gnu",
        ("gcc-riscv64-linux-gnu", "libc6-dev-riscv64-cross"),
    ),
)


def processor_of(host: str, machine: str, wanted: str | None) -> Processor:
    """The host's, by its `uname -m`; wanted: the arch that the user named.

    Raises DeployError for one that is not built for, or is another than the user's.
    """
    found = next((each for each in PROCESSORS if machine in each.machines), None)
    if found is None:
        known = ", ".join(name for each in PROCESSORS for name in each.machines)
        raise DeployError(
            f"{host}: found the processor {machine} (uname -m); allowed: {known}; for another one"
            " compile the program yourself: docs/targets.md"
        )
    if wanted not in (None, found.arch):
        raise DeployError(
            f"{host}: --arch: found {wanted}; allowed: {found.arch}, because its uname -m says"
            f" {machine}; leave --arch out, or name another host"
        )
    return found
