"""Options of a compiler that drop the guards against NaN, or change bits, are refused."""

import re
import subprocess
from pathlib import Path

import pytest

from turnbuckle.codegen.compile import FLAGS, GCC_FLAGS
from turnbuckle.model.symbolic.function import Status

RUNTIME = Path(__file__).parents[2] / "runtime"
DOCUMENT = Path(__file__).parents[2] / "docs" / "targets.md"
PARTS = ("core", "canopen", "can", "port/linux")
COMPILERS = {"gcc": "c99", "g++": "c++11", "clang": "c99", "clang++": "c++11"}
#: A guard as the generated C has them: a NaN is never inside.
GUARDED = """
#include "tb_types.h"
tb_status tb_seeded(const real_t x);
tb_status tb_seeded(const real_t x) { return !(x <= TB_C(1.0)) ? TB_OUT_OF_DOMAIN : TB_OK; }
"""
NAN_IS_LOST = "NaN would pass every guard"
OTHER_BITS = "other bits"
REFUSED = {
    "-ffast-math": NAN_IS_LOST,
    "-Ofast": NAN_IS_LOST,
    "-ffinite-math-only": NAN_IS_LOST,
}
REFUSED_BY_GCC = {
    "-ffast-math -fno-finite-math-only": OTHER_BITS,
    "-funsafe-math-optimizations": OTHER_BITS,
    "-fassociative-math -fno-signed-zeros -fno-trapping-math": OTHER_BITS,
    "-freciprocal-math": OTHER_BITS,
    "-fno-signed-zeros": OTHER_BITS,
    "-mfpmath=387": OTHER_BITS,
    "-fsingle-precision-constant": "tb_constants_are_double",
}
ACCEPTED = ["", " ".join(FLAGS[1:]), "-O3 -fno-math-errno"]
ACCEPTED_BY_GCC = [" ".join(GCC_FLAGS), "-frounding-math -O3", "-ffast-math -fno-fast-math"]


def said(compiler: str, options: str, source: str, folder: Path) -> str:
    """What a compiler says about a source; empty where it takes it."""
    language = "c++" if compiler.endswith("++") else "c"
    command = [
        compiler,
        f"-x{language}",
        f"-std={COMPILERS[compiler]}",
        "-Werror",
        *options.split(),
    ]
    command += [f"-I{folder}", "-fsyntax-only", "-"]
    done = subprocess.run(command, input=source, capture_output=True, text=True, check=False)
    return done.stderr if done.returncode else ""


def cases(everywhere: list[str], with_gcc: list[str]) -> list[tuple[str, str]]:
    """A compiler and the options it is tried with."""
    return [
        (compiler, options)
        for compiler in COMPILERS
        for options in [*everywhere, *(with_gcc if compiler.startswith("g") else [])]
    ]


@pytest.mark.parametrize(("compiler", "options"), cases([*REFUSED], [*REFUSED_BY_GCC]))
@pytest.mark.parametrize("precision", ["-UTB_REAL_FLOAT", "-DTB_REAL_FLOAT"])
def test_an_option_that_drops_guards_or_bits_is_refused(
    compiler: str, options: str, precision: str, stock_folder: Path
) -> None:
    message = (REFUSED | REFUSED_BY_GCC)[options]
    assert message in said(compiler, f"{precision} {options}", GUARDED, stock_folder)


@pytest.mark.parametrize(("compiler", "options"), cases(ACCEPTED, ACCEPTED_BY_GCC))
@pytest.mark.parametrize("precision", ["-UTB_REAL_FLOAT", "-DTB_REAL_FLOAT"])
def test_other_options_pass(
    compiler: str, options: str, precision: str, stock_folder: Path
) -> None:
    assert said(compiler, f"{precision} {options}", GUARDED, stock_folder) == ""


def test_the_document_names_every_option_that_is_refused() -> None:
    flags = {flag for options in REFUSED | REFUSED_BY_GCC for flag in options.split()}
    named = set(re.findall(r"`(-[\w=-]+)`", DOCUMENT.read_text()))
    assert flags - named == {"-fno-finite-math-only", "-fno-trapping-math"}  # not by themselves


def test_without_the_refusal_a_nan_passes_the_guard(stock_folder: Path, tmp_path: Path) -> None:
    text = (stock_folder / "tb_types.h").read_text()
    (tmp_path / "tb_types.h").write_text(re.sub(r"^#error.*$", "", text, flags=re.MULTILINE))
    (tmp_path / "main.c").write_text(
        f"{GUARDED}\nint main(void) {{ volatile real_t x = NAN; return (int)tb_seeded(x); }}\n"
    )
    statuses = []
    for options in (["-O2"], ["-O2", "-ffast-math"]):
        command = ["gcc", *options, "-w", "main.c", "-o", "main"]
        subprocess.run(command, cwd=tmp_path, check=True)
        statuses.append(subprocess.run([tmp_path / "main"], check=False).returncode)
    assert statuses == [Status.OUT_OF_DOMAIN, Status.OK]


def dependencies(folder: Path) -> dict[Path, str]:
    """The headers that each file of the runtime and of the generated C includes."""
    include = [folder, *(RUNTIME / part for part in PARTS)]
    sources = [source for each in include for source in sorted(each.glob("*.c"))]
    options = [f"-I{each}" for each in include]
    command = ["gcc", "-MM", *options, *map(str, sources)]
    rules = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    listed = re.split(r"\n(?=\S)", rules.replace("\\\n", "").strip())
    assert len(listed) == len(sources)
    return dict(zip(sources, listed, strict=True))


def uses_real_numbers(source: Path | str, folder: Path) -> bool:
    """Whether the compiler needs a register for real numbers."""
    options = [f"-I{each}" for each in (folder, *(RUNTIME / part for part in PARTS))]
    command = ["gcc", "-std=c11", "-O1", "-mgeneral-regs-only", *options, "-c", "-o", "/dev/null"]
    given = ["-xc", "-"] if isinstance(source, str) else [str(source)]
    done = subprocess.run(
        [*command, *given],
        input=source if isinstance(source, str) else None,
        capture_output=True,
        text=True,
        check=False,
    )
    return done.returncode != 0


def test_every_file_refuses_them_or_has_no_real_numbers(stock_folder: Path) -> None:
    included = dependencies(stock_folder)
    without = [source for source, headers in included.items() if "tb_types.h" not in headers]
    assert len(included) > len(without) > 10
    assert not [source for source in without if uses_real_numbers(source, stock_folder)]


def test_a_file_with_real_numbers_is_noticed(stock_folder: Path) -> None:
    assert uses_real_numbers("double seeded(double x) { return x + 1.0; }", stock_folder)
