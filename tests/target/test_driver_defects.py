"""The list of driver defects names what is there."""

import test_simulated_chip
import test_simulated_chip_can
import test_simulated_chip_refuses
from driver_defects import DEFECTS

TESTS = (test_simulated_chip, test_simulated_chip_can, test_simulated_chip_refuses)


def test_each_defect_is_one_that_the_chip_shows() -> None:
    shown = {name for module in TESTS for name in vars(module) if name.startswith("test_")}
    shown |= set(test_simulated_chip_refuses.WRONG)
    assert {defect.shown_by for defect in DEFECTS} <= shown


def test_each_defect_is_another_one() -> None:
    assert len({defect.wrong for defect in DEFECTS}) == len(DEFECTS) >= 20
