"""The sweeps' own check, and that it can fail."""

from __future__ import annotations

import pytest

from parts.depth_sweep.sweep import ORDER, Prepared, broken, samples
from worlds.bodies.paper_models import models


def test_bounds_along_a_motion_are_in_order() -> None:
    prepared = Prepared.of(models()[0])
    found = list(samples(prepared, 5))
    assert [sample.t for sample in found] == [0.0, 0.25, 0.5, 0.75, 1.0]
    assert not any(broken(sample) for sample in found)
    assert found[2].lb < 0.9 * found[2].lo  # not all the same number
    assert found[2].ub1 < 0.9 * found[2].ub2


@pytest.mark.parametrize("name", ORDER[1:])
def test_a_bound_out_of_order_is_found(name: str) -> None:
    sample = next(iter(samples(Prepared.of(models()[0]), 5)))
    assert name in broken(sample._replace(**{name: 0.5 * sample.lb}))
