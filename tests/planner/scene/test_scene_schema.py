"""The published JSON Schema: accepts what the reader accepts, rejects what it can see is wrong."""

from __future__ import annotations

import copy
import json
from pathlib import Path
from typing import Any

import jsonschema
import pytest

import planar_planner
from planar_planner.scene.builtin import builtin_scenes
from planar_planner.scene.input_limits import MAX_ANGLE, MAX_COORDINATE, MIN_COORDINATE
from worlds.bad_scene_values import BAD_VALUES

SCHEMA = json.loads(
    (Path(planar_planner.__file__).parent / "scene" / "scene.schema.json").read_text(
        encoding="utf-8"
    )
)
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)

BEYOND_A_SCHEMA = (  # order, geometry and exactness: the gate's own work
    "must be less than",
    "must be one polygon",
    "zero area",
    "not valid",
    "self-intersection",
    "hole lies outside",
    "nested",
    "distinct point",
    "obstacles[0].coordinates",  # the spike: listed only with its path
    "must be a finite number",  # NaN and infinity are no JSON
    "must be a finite",
)


def test_schema_is_a_schema() -> None:
    jsonschema.Draft202012Validator.check_schema(SCHEMA)


@pytest.mark.parametrize("name", list(builtin_scenes()))
def test_builtin_scenes_follow_the_schema(name: str) -> None:
    VALIDATOR.validate(json.loads(builtin_scenes()[name].read_text(encoding="utf-8")))


def test_limits_agree() -> None:
    assert SCHEMA["$defs"]["coordinate"]["anyOf"][1] == {
        "minimum": MIN_COORDINATE,
        "maximum": MAX_COORDINATE,
    }
    assert SCHEMA["$defs"]["coordinate"]["anyOf"][2] == {
        "minimum": -MAX_COORDINATE,
        "maximum": -MIN_COORDINATE,
    }
    angle = SCHEMA["$defs"]["angle"]["oneOf"][0]
    assert (angle["minimum"], angle["maximum"]) == (-MAX_ANGLE, MAX_ANGLE)


@pytest.mark.parametrize(
    ("place", "value"),
    [
        (place, value)
        for place, value, expected in BAD_VALUES
        if not any(part in expected for part in BEYOND_A_SCHEMA)
    ],
)
def test_schema_rejects_what_the_reader_rejects(
    scene_dict: dict[str, Any], place: tuple[Any, ...], value: Any
) -> None:
    content: Any = copy.deepcopy(scene_dict)
    VALIDATOR.validate(content)
    target = content
    for step in place[:-1]:
        target = target[step]
    target[place[-1]] = value
    assert not VALIDATOR.is_valid(content)


def test_schema_rejects_missing_and_unknown_fields(scene_dict: dict[str, Any]) -> None:
    for field in ("format", "version", "robot", "obstacles", "start", "goal", "workspace"):
        assert not VALIDATOR.is_valid({k: v for k, v in scene_dict.items() if k != field})
    assert not VALIDATOR.is_valid(scene_dict | {"obstacle": []})
    assert not VALIDATOR.is_valid(scene_dict | {"version": 2})
    assert not VALIDATOR.is_valid(scene_dict | {"workspace": None})
