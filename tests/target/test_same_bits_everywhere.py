"""Committed vectors of every stock machine: each processor and compiler gives their bits."""

from concurrent.futures import ThreadPoolExecutor
from functools import cache
from itertools import product
from pathlib import Path

import pytest

from turnbuckle.codegen.bind import Generated
from turnbuckle.lab.vectors.__main__ import FOLDER, computed
from turnbuckle.lab.vectors.platforms import PLATFORMS, Platform
from turnbuckle.lab.vectors.vectors import FUNCTIONS, Vector, Vectors, VectorsError, read, write

ROOT = Path(__file__).parents[2]
MACHINES = sorted(path.stem for path in (ROOT / "machines").glob("*.toml"))
LARGEST = 100_000
"""Bytes of a file of vectors, at most."""
FUSED = ("-O2", "-ffp-contract=fast")
"""Multiplication and addition in one operation, where the processor has it."""
FUSING = [each for each in PLATFORMS if each.name in ("AArch64", "RISC-V 64")] + [
    each for each in PLATFORMS if each.name.startswith("Cortex")
]


@cache
def vectors_of(machine: str) -> dict[str, Vectors]:
    """The committed vectors of a machine, by precision."""
    return read((FOLDER / f"{machine}.txt").read_text())


def differences(machine: str, platform: Platform, *flags: str) -> list[str]:
    """What a platform gives otherwise than the vectors say."""
    vectors = vectors_of(machine)[platform.precision]
    given = platform.answer(ROOT / "generated" / machine, vectors.stream(), flags)
    return vectors.differences(given)


def title(platform: Platform) -> str:
    """A column's."""
    return f"{platform.name}, {platform.precision}"


def table(found: dict[tuple[str, Platform], list[str]]) -> str:
    """Results of every machine on every platform, and how many of them differ."""
    lines = ["".join(f"{each:>22}" for each in ("", *map(title, PLATFORMS)))]
    for machine in MACHINES:
        counts = (
            f"{len(found[machine, each])} of {vectors_of(machine)[each.precision].count}"
            for each in PLATFORMS
        )
        lines.append("".join(f"{each:>22}" for each in (machine, *counts)))
    return "\n".join(lines)


def test_every_stock_machine_has_the_same_bits_on_every_processor() -> None:
    pairs = list(product(MACHINES, PLATFORMS))
    with ThreadPoolExecutor(2) as pool:
        answers = pool.map(lambda pair: differences(*pair), pairs)
        found = dict(zip(pairs, answers, strict=True))
    print(f"results that differ:\n{table(found)}")
    wrong = [
        f"{machine}, {title(each)}: {found[machine, each][0]}"
        for machine, each in pairs
        if found[machine, each]
    ]
    assert not wrong, "if that is wanted: python -m turnbuckle.lab.vectors\n" + "\n".join(wrong)


@pytest.mark.parametrize("platform", FUSING, ids=title)
def test_fused_operations_would_be_noticed(platform: Platform) -> None:
    assert differences("yoon2023", platform, *FUSED)


def test_every_machine_has_vectors_that_are_small_and_many() -> None:
    assert sorted(path.stem for path in FOLDER.glob("*.txt")) == MACHINES
    for machine in MACHINES:
        assert (FOLDER / f"{machine}.txt").stat().st_size < LARGEST
        assert all(vectors.count > 500 for vectors in vectors_of(machine).values())


@pytest.mark.parametrize("machine", MACHINES)
def test_the_vectors_have_good_cycles_and_bad_ones(machine: str) -> None:
    """TB_OK, TB_INFEASIBLE and TB_OUT_OF_DOMAIN, and a controller that goes on after them."""
    for vectors in vectors_of(machine).values():
        status = {
            function: [int(vector.results[-1], 16) for vector in each]
            for function, each in vectors.by_function.items()
        }
        assert {0, 1} <= set(status["distribute_tension"])
        assert status["controller_start"] == [0]
        assert {0, 1, 3} <= set(status["controller_step"])
        assert status["controller_step"][-1] == 0


def test_the_command_writes_what_is_committed(single: Generated, double: Generated) -> None:
    vectors = {each.precision: computed(each) for each in (double, single)}
    assert write("yoon2023", vectors) == (FOLDER / "yoon2023.txt").read_text()


def test_a_bit_that_differs_is_named() -> None:
    vectors = vectors_of("yoon2023")["float"]
    results = b"".join(
        bytes.fromhex(word)[::-1] for _, vector in vectors.each() for word in vector.results
    )
    assert vectors.differences(results) == []
    changed = bytes([results[0] ^ 1]) + results[1:]
    first = vectors.by_function["distribute_tension"][0].results[0]
    other = f"{int(first, 16) ^ 1:08x}"
    assert vectors.differences(changed) == [
        f"distribute_tension 0, result 0: {other} in place of {first}"
    ]
    assert len(vectors.differences(results[:-4])) == 2


def test_a_file_of_another_version_is_refused() -> None:
    text = write("one", {"float": Vectors({name: [Vector(("00",))] for name in FUNCTIONS})})
    assert read(text)["float"].by_function["controller_start"] == [Vector(("00",))]
    with pytest.raises(
        VectorsError, match="'turnbuckle vectors 2'; allowed: 'turnbuckle vectors 1'"
    ):
        read(text.replace("vectors 1", "vectors 2"))
