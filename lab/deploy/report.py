"""What a deploy tells: which program was there, which is there now, what to do next."""

from collections.abc import Iterator

from turnbuckle.lab.deploy.deploy import Installed, Switched
from turnbuckle.lab.deploy.host import Answer, Host
from turnbuckle.model.machine import Machine

SHORT = 12
"""Digits of a sha256 that tell programs apart."""


def changes(switched: Switched) -> Iterator[str]:
    """What is there, and what was."""
    yield f"before    {described(switched.before)}"
    yield f"now       {described(switched.now)}"
    yield f"previous  {described(switched.previous)}"
    if switched.before is not None and switched.before.sha256 == switched.now.sha256:
        yield "the same program was there already"


def described(program: Installed | None) -> str:
    """A program in a line."""
    if program is None:
        return "none"
    return f"{program.text or 'no program of Turnbuckle'} (sha256 {program.sha256[:SHORT]}...)"


def stranger(machine: Machine, host: Host, switched: Switched) -> str | None:
    """A warning where the folder held what is no program of this machine; None where not."""
    before = switched.before
    if before is None or (before.identity and before.identity.machine == machine.name):
        return None
    found = f"a program of {before.identity.machine}" if before.identity else "something else"
    return (
        f"warning: {host.name}: {switched.place} was {found}, not of {machine.name};"
        " it is kept as the previous one"
    )


def next_steps(machine: Machine, host: Host, switched: Switched, unit: Answer | None) -> list[str]:
    """How the new program comes to run."""
    buses = " ".join(f"--bus={bus.name}=ADAPTER:DEVICE" for bus in machine.buses)
    kept = "a program that runs there goes on as it is, and the new one comes with the next start"
    if unit is None:
        words = f"{switched.place} {buses}"
        return [kept, f"start: {host.command(words, terminal=True)}"]
    service = f"turnbuckle@{machine.name}"
    steps = [kept, f"unit turnbuckle@.service: {UNIT_WORDS[unit['unit']]}"]
    if "conf" in unit:
        conf = f"/etc/turnbuckle/{machine.name}.conf"
        steps.append(f'missing there: {conf}, with the line BUSES="{buses}"')
    if "systemd" in unit:
        steps.append("missing there: systemd does not run; the unit waits for it")
    start = host.command(f"sudo systemctl restart {service}", terminal=True)
    return [*steps, f"start, or start again: {start}"]


UNIT_WORDS = {
    "installed": "installed",
    "same": "was installed already",
    "replaced": "installed; the one that was there is kept as turnbuckle@.service.before",
}
