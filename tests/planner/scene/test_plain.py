"""Objects of Python become what a file would hold, without a detour through text."""

from __future__ import annotations

import enum
import json
import math
from typing import Any

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

from planar_planner.errors import SceneError
from planar_planner.scene.plain import plain

JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | st.text(),
    lambda inner: st.lists(inner) | st.dictionaries(st.text(), inner),
)


class Size(enum.IntEnum):
    LARGE = 3


class Colour(enum.StrEnum):
    RED = "red"


def types_of(value: Any) -> Any:
    """The types of a value and of all that is in it."""
    if isinstance(value, dict):
        return dict, [(type(name), types_of(item)) for name, item in value.items()]
    return (list, [types_of(item) for item in value]) if type(value) is list else type(value)


@given(JSON)
def test_json_values_are_what_text_would_bring(value: Any) -> None:
    read = json.loads(json.dumps(value))
    assert plain(value) == read
    assert types_of(plain(value)) == types_of(read)


def test_no_list_is_shared_with_the_original() -> None:
    value = {"a": [[1.0, 2.0]]}
    copy = plain(value)
    value["a"][0][0] = 9.0
    assert copy == {"a": [[1.0, 2.0]]}


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        ((1, (2, 3.5)), [1, [2, 3.5]]),
        (np.array([[1, 2]], dtype=np.float32), [[1.0, 2.0]]),
        ([np.float64(0.1), np.int32(2), np.bool_(True)], [0.1, 2, True]),
        (np.array(shapely.box(0, 0, 1, 1)), plain(shapely.box(0, 0, 1, 1))),
        ([Size.LARGE, Colour.RED], [3, "red"]),
        (
            shapely.Polygon([(0, 0), (1, 0), (0, 1)]).exterior.coords,
            [[0, 0], [1, 0], [0, 1], [0, 0]],
        ),
    ],
)
def test_objects_of_the_field(value: Any, expected: Any) -> None:
    assert plain(value) == expected
    assert types_of(plain(value)) == types_of(json.loads(json.dumps(plain(value))))


def test_geometry_is_geojson() -> None:
    assert plain({"robot": shapely.Polygon([(0, 0), (1, 0), (0, 1)])}) == {
        "robot": {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [0, 1], [0, 0]]]}
    }


def test_what_is_no_number_stays_for_the_gate_to_refuse() -> None:
    assert math.isnan(plain([math.nan])[0])
    assert plain(10**5000) == 10**5000


@pytest.mark.parametrize(
    ("value", "message"),
    [
        ({"a": [0, {"b": {1, 2}}]}, "a[1].b: a set has no JSON form (got {1, 2})"),
        ({"a": {3: 0}}, "a: names of fields must be strings (got 3)"),
        ({"a": (1, np.ndarray)}, "a[1]: a type has no JSON form (got <class 'numpy.ndarray'>)"),
        ({"a": 1j, "b": 2j}, "a: a complex has no JSON form (got 1j)"),
    ],
)
def test_what_has_no_form_is_named_with_its_place(value: Any, message: str) -> None:
    with pytest.raises(SceneError) as caught:
        plain(value)
    assert str(caught.value) == message


def test_cycles_and_depth_are_errors() -> None:
    cycle: list[Any] = []
    cycle.append(cycle)
    with pytest.raises(SceneError, match="goal: is nested too deeply"):
        plain(cycle, "goal")
