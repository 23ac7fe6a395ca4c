"""The single-precision C needs no double, no library, no heap and no memory of its own."""

from pathlib import Path

import pytest

from turnbuckle.codegen.purity import PurityError, impurities

CORE = Path(__file__).parents[2] / "runtime" / "core"
SEEDED = {
    "double": ("float tb_seeded(float x) { return x * 1.1; }", "__aeabi_dmul"),
    "library": (
        "#include <math.h>\nfloat tb_seeded(float x) { return sinf(x); }",
        "sinf",
    ),
    "heap": (
        "#include <stdlib.h>\nvoid *tb_seeded(unsigned n) { return malloc(n); }",
        "malloc",
    ),
    "name": ("float seeded(float x) { return x; }", "seeded"),
    "variable": (
        "float tb_seeded(float x) { static float last; last += x; return last; }",
        "last",
    ),
}


def test_generated_c_is_pure(stock_folder: Path) -> None:
    sources = sorted(stock_folder.glob("*.c"))
    assert len(sources) >= 5
    assert impurities(sources, [stock_folder]) == []


def test_the_core_of_the_runtime_is_pure(stock_folder: Path) -> None:
    sources = sorted(CORE.glob("*.c"))
    assert sources
    assert impurities(sources, [stock_folder, CORE], "c11") == []


@pytest.mark.parametrize("defect", SEEDED)
def test_a_seeded_impurity_is_found(defect: str, tmp_path: Path, stock_folder: Path) -> None:
    code, symbol = SEEDED[defect]
    original = stock_folder / "tb_statics.c"
    seeded = tmp_path / "seeded.c"
    seeded.write_text(f"{original.read_text()}\n{code}\n")
    found = impurities([seeded], [stock_folder])
    assert symbol in {finding.symbol.split(".")[0] for finding in found}


def test_c_that_does_not_compile_is_no_pure_c(tmp_path: Path) -> None:
    broken = tmp_path / "broken.c"
    broken.write_text("float tb_broken(float x) { return y; }\n")
    with pytest.raises(PurityError, match=r"broken\.c does not compile"):
        impurities([broken], [])
