"""What stands in the way on a host, in words, each with the command that mends it."""

import re
from typing import Protocol

#: Of Debian, with programs that host.sh needs and coreutils does not have.
PACKAGES = {"flock": "util-linux", "awk": "mawk", "sed": "sed", "find": "findutils"}
KEPT = "the program that was there is still in its place"


class Command(Protocol):
    """What a person types to have something done on the host."""

    def __call__(self, words: str, terminal: bool = False) -> str:
        """terminal: it may ask for a password."""


def unreached(host: str, command: Command, said: str) -> str:
    """Why ssh has failed, by what it said."""
    by_hand = command("true")
    if "IDENTIFICATION HAS CHANGED" in said:
        return (
            f"{host}: its host key is another than it was; if it was set up anew, forget the old"
            f" key with ssh-keygen -R {address(host)}, then accept the new one: {by_hand}"
        )
    if re.search("Host key verification failed|host key is known", said):
        return (
            f"{host}: its host key is not known here; compare it with the host's own, and accept"
            f" it once: {by_hand}"
        )
    if "Permission denied" in said:
        return f"{host}: does not let you in by a key; bring your key there: ssh-copy-id {host}"
    words = last_line(said) or "the connection was lost"
    return f"{host}: cannot be reached: {words}; {KEPT}; see whether this works: {by_hand}"


def refused(host: str, command: Command, reason: str, words: str) -> str:
    """Why host.sh has refused, by its reason."""
    package = PACKAGES.get(words, "coreutils")
    made = command('sudo install -d -o "$USER" /opt/turnbuckle', terminal=True)
    by_root = f"sudo install -m 644 {words} /etc/systemd/system && sudo systemctl daemon-reload"
    known = {
        "tool": f"found no {words} there; install it:"
        f" {command(f'sudo apt-get install {package}', terminal=True)}",
        "permission": f"you may not write to {words}; name a folder of yours with --folder, or"
        f" make one, such as: {made}",
        "write": f"the program could not be written there: {words}; {KEPT}; make room, as"
        f" {command('df -h')} shows",
        "changed": f"what arrived is not what was sent, by its sha256; {KEPT}; deploy again",
        "start": f"the program does not start there: {words or 'killed'}; {KEPT}; see what the"
        f" computer is, and that no noexec is on the folder: {command('uname -a; mount')}",
        "busy": f"another deploy holds the folder for a minute already; {KEPT}; see it with"
        f" {command('ps aux')}",
        "previous": "there is no program before the one in use, so none to go back to; deploy the"
        " one that you want",
        "damaged": f"{words} is not what its name says, by its sha256; {KEPT}; deploy the program"
        " that you want",
        "sudo": "the program is in its place; the unit needs root there, and sudo does not work"
        f" without a password; install the unit yourself: {command(by_root, terminal=True)}",
        "systemd": "found no /etc/systemd/system there; allowed: a host with systemd; leave --unit"
        " out, and start the program yourself",
        "reload": "systemd did not read its units again; do it yourself:"
        f" {command('sudo systemctl daemon-reload', terminal=True)}",
    }
    return f"{host}: " + known.get(reason, f"it failed there: {last_line(words) or reason}; {KEPT}")


def last_line(text: str) -> str:
    """The last line that says something."""
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    return lines[-1] if lines else ""


def address(host: str) -> str:
    """As known_hosts has it: without the user, a port beside the name in brackets."""
    found = re.fullmatch(r"(?:ssh://)?(?:[^@]*@)?\[?([^\]/]+?)\]?(?::(\d+))?/?", host)
    name, port = found.groups() if found else (host, None)
    return f"'[{name}]:{port}'" if port else name
