"""Calling the generated C from Python: shapes, batches, statuses and what is refused."""

import numpy as np
import pytest

from turnbuckle.codegen.bind import Generated
from turnbuckle.model.symbolic.function import Status

POSE, RAILS = [0.3, 0.2], [0.3, 0.2, 0.3, 0.2]


def test_one_point_gives_one_answer_with_its_status(double: Generated) -> None:
    lengths = double.cable_lengths(POSE, RAILS)
    assert lengths.shape == (4,) and lengths.status is Status.OK


def test_a_batch_is_the_points_one_by_one(double: Generated) -> None:
    poses = np.linspace([0.1, 0.1], [0.6, 0.4], 6).reshape(2, 3, 2)
    together = double.cable_lengths(poses, RAILS)
    assert together.shape == (2, 3, 4) and together.status.shape == (2, 3)
    for place in np.ndindex(2, 3):
        assert np.array_equal(together[place], double.cable_lengths(poses[place], RAILS))


def test_several_outputs_come_with_their_names(double: Generated) -> None:
    structure = double.structure_matrix(POSE, RAILS)
    answer = double.distribute_tension(structure, wrench=[1.0, 2.0])
    assert answer._fields == ("tension", "delivered", "kkt_residual", "status")
    assert answer.status is Status.OK


def test_single_precision_answers_in_single_precision(single: Generated) -> None:
    assert single.cable_lengths(POSE, RAILS).dtype == np.float32


def test_a_wrong_shape_is_refused_with_the_right_one(double: Generated) -> None:
    with pytest.raises(ValueError, match=r"cable_lengths: pose has shape \(3,\); it takes \(2,\)"):
        double.cable_lengths([1.0, 2.0, 3.0], RAILS)


def test_a_missing_and_an_unknown_argument_are_refused(double: Generated) -> None:
    with pytest.raises(TypeError, match="rails is missing"):
        double.cable_lengths(POSE)
    with pytest.raises(TypeError, match="cable_lengths"):
        double.cable_lengths(POSE, RAILS, speed=1.0)


def test_an_unknown_function_is_refused_with_those_there_are(double: Generated) -> None:
    with pytest.raises(AttributeError, match="'lengths' is not generated; there are base_points"):
        _ = double.lengths
