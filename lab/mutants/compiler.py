"""Stands before gcc while a mutant is tried: compiles the mutant wherever its original is given.

So every test finds the runtime as it is, those included that change the text of a copy. A file
that was compiled before, with the same headers and flags, is not compiled again. Needs nothing but
Python, to start quickly.
"""

import hashlib
import os
import subprocess
import sys
from pathlib import Path

GCC = "TURNBUCKLE_GCC"
"""The compiler itself."""
ORIGINAL, MUTANT = "TURNBUCKLE_ORIGINAL", "TURNBUCKLE_MUTANT"
"""Two files."""
OBJECTS = "TURNBUCKLE_OBJECTS"
"""A folder for what was compiled."""


def main() -> int:
    """Compile file by file and link, where that is what is asked for."""
    given = sys.argv[1:]
    sources = [Path(argument) for argument in given if argument.endswith(".c")]
    if not sources or "-o" not in given or {"-c", "-E", "--coverage"} & {*given}:
        return run([own for argument in given for own in one(argument)])
    flags = [argument for argument in given if not argument.endswith(".c")]
    product = flags.index("-o")
    target, flags = flags[product : product + 2], flags[:product] + flags[product + 2 :]
    objects = [object_of(source, flags) for source in sources]
    if None in objects:
        return 1
    return run([*map(str, objects), *flags, *target])


def run(arguments: list[str]) -> int:
    """Run gcc."""
    return subprocess.run([os.environ[GCC], *arguments], check=False).returncode


def one(argument: str) -> list[str]:
    """An argument of gcc, or for the original the mutant, which finds the same headers."""
    path = Path(argument)
    if argument.endswith(".c") and is_original(path):
        return [os.environ[MUTANT], "-iquote", str(path.parent)]
    return [argument]


def is_original(path: Path) -> bool:
    """Whether a file is the original of the mutant, or a copy."""
    original = Path(os.environ[ORIGINAL])
    return path.name == original.name and path.read_bytes() == original.read_bytes()


def object_of(source: Path, flags: list[str]) -> Path | None:
    """The object of a file, named after all that it is made of; None: gcc refused."""
    arguments = one(str(source))
    digest = hashlib.sha256("\0".join(flags).encode() + Path(arguments[0]).read_bytes())
    folders = [source.parent, *(Path(flag[2:]) for flag in flags if flag.startswith("-I"))]
    for header in [header for folder in folders for header in sorted(folder.glob("*.h"))]:
        digest.update(header.name.encode() + header.read_bytes())
    product = Path(os.environ[OBJECTS]) / f"{source.stem}-{digest.hexdigest()[:24]}.o"
    if not product.exists():
        fresh = product.with_suffix(f".{os.getpid()}.o")
        if run([*flags, "-c", *arguments, "-o", str(fresh)]):
            return None
        fresh.replace(product)
    return product


if __name__ == "__main__":
    sys.exit(main())
