"""Numbers in the C read back as the numbers they were."""

import re

import numpy as np
import pytest

from turnbuckle.codegen.print_c import literal

NUMBERS = [0.0, 1.0, 0.1, 1 / 3, 1e-300, 5e-324, 1.7976931348623157e308, 123456789.12345679, 1e22]


@pytest.mark.parametrize("number", [*NUMBERS, *(-x for x in NUMBERS[1:])])
def test_a_literal_reads_back_to_the_bit(number: float) -> None:
    text = literal(number)
    match = re.fullmatch(r"(-?)TB_C\(([0-9.e+-]+)\)", text)
    assert match
    sign, digits = match.groups()
    assert float(sign + digits) == number
    with np.errstate(over="ignore"):
        assert np.float32(sign + digits) == np.float32(number)


@pytest.mark.parametrize("number", NUMBERS)
def test_a_literal_is_of_floating_type_in_c(number: float) -> None:
    assert re.search(r"[.e]", literal(number))
