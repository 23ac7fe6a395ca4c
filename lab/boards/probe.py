"""Debug probes, and how OpenOCD is told which one."""

from pathlib import Path

from turnbuckle.lab.boards import BoardError

PROBES = {
    "stlink": ("-f", "interface/stlink.cfg"),
    "cmsis-dap": ("-f", "interface/cmsis-dap.cfg"),
    "jlink": ("-f", "interface/jlink.cfg", "-c", "transport select swd"),
}


def probe_options(probe: str) -> tuple[str, ...]:
    """OpenOCD's options for a probe by its name, or by a file of OpenOCD's commands."""
    if probe in PROBES:
        return PROBES[probe]
    if probe.endswith(".cfg") and Path(probe).is_file():
        return "-f", str(Path(probe).resolve())
    raise BoardError(
        f'--probe: found "{probe}"; allowed: {", ".join(PROBES)}, or a file of your own that ends'
        " in .cfg and tells OpenOCD of another one"
    )
