"""Results of many rows have the fields of the single result, and are sequences of them."""

from __future__ import annotations

import dataclasses
from typing import Any, get_args

import numpy as np
import pytest

import pdg

SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
ELL = [(0, 0), (4, 0), (4, 1), (1, 1), (1, 3), (0, 3)]
POSES = np.array([(0.5, 0.5, 0.3), (9.0, 9.0, 0.0), (0.2, 0.1, 1.0), (0.0, 0.0, 0.0)])
CELLS = np.column_stack([POSES, np.full((4, 3), 0.01)])
BATCHES: list[pdg.Batch[Any]] = [
    pdg.translational_depth(ELL, SQUARE, POSES),
    pdg.generalized_depth_lower_bound(ELL, SQUARE, POSES),
    pdg.generalized_depth_upper_bound(ELL, SQUARE, POSES),
    pdg.generalized_depth_upper_bound(ELL, SQUARE, POSES).placement,
    pdg.generalized_depth_bracket(ELL, SQUARE, POSES),
    pdg.generalized_distance_bracket(ELL, (0, 0, 0), POSES),
    pdg.c_obstacle_query(ELL, SQUARE, CELLS),
]


def name(batch: pdg.Batch[Any]) -> str:
    return type(batch).__name__


def names(one: Any) -> list[str]:
    return [field.name for field in dataclasses.fields(one)]


def test_every_batch_is_tried() -> None:
    public = [getattr(pdg, name) for name in pdg.__all__]
    batches = {one for one in public if isinstance(one, type) and issubclass(one, pdg.Batch)}
    assert {type(batch) for batch in BATCHES} == batches - {pdg.Batch}


@pytest.mark.parametrize("batch", BATCHES, ids=name)
def test_fields_are_those_of_the_single_result(batch: pdg.Batch[Any]) -> None:
    (single,) = get_args(type(batch).__orig_bases__[0])
    assert names(batch) == names(single)
    for row, one in enumerate(batch):
        assert type(one) is single
        for field in names(single):
            many, value = getattr(batch, field)[row], getattr(one, field)
            if value is not None:  # where an index says that there is none
                assert np.array_equal(np.asarray(many), np.asarray(value)) or many == value


@pytest.mark.parametrize("batch", BATCHES, ids=name)
def test_a_batch_is_a_sequence(batch: pdg.Batch[Any]) -> None:
    assert len(batch) == len(list(batch)) == 4
    assert batch[-1] == batch[3]
    assert list(reversed(batch)) == list(batch)[::-1]
    with pytest.raises(IndexError):
        batch[4]
    some = batch[1:3]
    assert type(some) is type(batch)
    assert list(some) == [batch[1], batch[2]]


@pytest.mark.parametrize("batch", BATCHES, ids=name)
def test_single_results_hold_plain_python_values(batch: pdg.Batch[Any]) -> None:
    for one in batch:
        for field in names(one):
            value = getattr(one, field)
            assert not isinstance(value, np.generic | np.ndarray), field
            if isinstance(value, tuple):
                assert not any(isinstance(part, np.generic) for part in value), field
