"""Fuzzing: any bytes into what parses, by libFuzzer, under the address and undefined sanitizers.

A target is a C file `tests/fuzz/fuzz_NAME.c` with `LLVMFuzzerTestOneInput`; a few inputs to begin
with are in `tests/fuzz/corpus/NAME`. It traps where what it checks does not hold.
"""

import os
import subprocess
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parents[1]
FUZZ = Path(__file__).parent / "fuzz"
FLAGS = (
    "-std=c11",
    "-g",
    "-O1",
    "-Wall",
    "-Wextra",
    "-Werror",
    "-fno-omit-frame-pointer",
    "-fsanitize=fuzzer,address,undefined",
    "-fno-sanitize-recover=all",
)
#: Inputs among which a seeded defect is found, however busy the computer is.
ENOUGH = 20_000_000
#: Of random input for each target; `make fuzz` gives more.
SECONDS = int(os.environ.get("FUZZ_SECONDS", "15"))
#: Kept small: a target reads a few lines or frames, not a file.
LONGEST_INPUT = 512


@dataclass(frozen=True)
class Target:
    """What is fuzzed: `tests/fuzz/fuzz_NAME.c` with the runtime's C that it calls."""

    name: str
    sources: tuple[Path, ...]
    include: tuple[Path, ...]
    defines: tuple[str, ...] = ()

    def build(self, folder: Path) -> "Fuzzer":
        """The target, compiled into a folder."""
        program = folder / f"fuzz_{self.name}"
        own = FUZZ / f"fuzz_{self.name}.c"
        include = [f"-I{path}" for path in self.include]
        arguments = [*FLAGS, *self.defines, *include, own, *self.sources, "-o", program]
        subprocess.run(["clang", *map(str, arguments)], check=True)
        return Fuzzer(program, FUZZ / "corpus" / self.name, folder)

    def with_defect(self, source: Path, old: str, new: str, folder: Path) -> "Target":
        """The same with one of its sources changed, once: what fuzzing is to find."""
        text = source.read_text()
        assert text.count(old) == 1, f"{source.name} holds {text.count(old)} times: {old}"
        changed = folder / source.name
        changed.write_text(text.replace(old, new))
        sources = tuple(changed if path == source else path for path in self.sources)
        assert changed in sources, f"{source} is no source of the target {self.name}"
        return Target(self.name, sources, (source.parent, *self.include), self.defines)


@dataclass(frozen=True)
class Fuzzer:
    """A compiled target."""

    program: Path
    corpus: Path
    folder: Path

    def finding(self, seconds: int = 0, inputs: int = -1) -> str | None:
        """Run for some seconds, or so many inputs, always in the same order: the first input that
        fails, and how.

        Other tests go before: they need so much work, this so much time.
        """
        grown = self.folder / "grown"
        grown.mkdir(exist_ok=True)
        options = {
            "seed": 1,
            "max_total_time": seconds,
            "runs": inputs,
            "max_len": LONGEST_INPUT,
            "timeout": 10,
            "artifact_prefix": f"{self.folder}/found-",
        }
        arguments = [f"-{name}={value}" for name, value in options.items()]
        done = subprocess.run(
            ["nice", "-n", "5", self.program, *arguments, grown, self.corpus],
            capture_output=True,
            text=True,
            errors="replace",
            check=False,
        )
        if done.returncode == 0:
            return None
        found = "\n".join(repr(path.read_bytes()) for path in self.folder.glob("found-*"))
        return f"input:\n{found or 'none was written'}\n{done.stderr[-4000:]}"
