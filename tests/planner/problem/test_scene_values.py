"""The gate names field, index and value of what it rejects, whatever stands there."""

from __future__ import annotations

import copy
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from planar_planner.errors import SceneError
from support.scene_gate import VALID, message, problem_of
from worlds.bad_scene_values import BAD_VALUES
from worlds.small import square


@pytest.mark.parametrize(("place", "value", "expected"), BAD_VALUES)
def test_bad_value(
    scene_dict: dict[str, Any], place: tuple[Any, ...], value: Any, expected: str
) -> None:
    problem_of(scene_dict)  # the only fault is the one put in next
    target: Any = scene_dict
    for step in place[:-1]:
        target = target[step]
    target[place[-1]] = value
    assert expected in message(scene_dict)


def test_index_of_the_bad_polygon(scene_dict: dict[str, Any]) -> None:
    scene_dict["obstacles"] *= 5
    scene_dict["obstacles"].append(
        {"type": "MultiPolygon", "coordinates": [[square(1, 1)], [square(3, 3, 1), [[3, 3]]]]}
    )
    assert "obstacles[5].coordinates[1][1]: ring must have" in message(scene_dict)
    scene_dict["obstacles"][5]["coordinates"][1][1] = [[3, 3], [3, 3.5], [3.5, "a"]]
    assert "obstacles[5].coordinates[1][1][2][1]: must be a number (got 'a')" in message(scene_dict)


JSON_VALUES = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5),
    lambda inner: (
        st.lists(inner, max_size=4)
        | st.dictionaries(
            st.sampled_from(["type", "coordinates", "geometry", "geometries", "box", "x"]), inner
        )
    ),
    max_leaves=10,
)


PLACES = [
    ("workspace",),
    ("workspace", "box"),
    ("robot",),
    ("robot", "type"),
    ("robot", "coordinates"),
    ("robot", "coordinates", 0),
    ("robot", "coordinates", 0, 1),
    ("robot", "coordinates", 0, 1, 0),
    ("obstacles",),
    ("obstacles", 0),
    ("obstacles", 0, "coordinates", 0),
    ("start",),
    ("goal", 2),
    ("rotation",),
    ("name",),
    ("version",),
]


@settings(max_examples=400, deadline=None)
@given(place=st.sampled_from(PLACES), value=JSON_VALUES)
def test_any_value_anywhere_is_accepted_or_a_scene_error(place: Any, value: Any) -> None:
    content: Any = copy.deepcopy(VALID)
    target = content
    for step in place[:-1]:
        target = target[step]
    target[place[-1]] = value
    try:
        problem = problem_of(content)
    except SceneError as error:
        assert error.source == "<dict>"
        assert "\n" not in str(error)
    else:
        assert np.isfinite(problem.robot.coords).all()
        assert np.diff(problem.robot.ring_starts).min() >= 3
