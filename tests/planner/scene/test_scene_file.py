"""Reading scenes: names, paths, dicts, and every way in which a file can be no scene."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely

from planar_planner.errors import SceneError
from planar_planner.load import load_scene
from planar_planner.scene import builtin
from planar_planner.scene import input_limits as limits


def write(folder: Path, text: str | bytes) -> Path:
    file = folder / "scene.json"
    file.write_bytes(text if isinstance(text, bytes) else text.encode())
    return file


def message(file: Any) -> str:
    with pytest.raises(SceneError) as caught:
        load_scene(file)
    text = str(caught.value)
    assert "\n" not in text
    assert len(text) < 400
    return text


def test_file_dict_and_path_give_the_same_scene(tmp_path: Path, scene_dict: dict[str, Any]) -> None:
    file = write(tmp_path, json.dumps(scene_dict))
    for given in (file, str(file), scene_dict):
        scene = load_scene(given)
        assert scene.to_dict() == scene_dict
        assert scene.rotation is True
    assert load_scene(str(file)).source == str(file)


def test_dict_is_copied(scene_dict: dict[str, Any]) -> None:
    scene = load_scene(scene_dict)
    scene_dict["robot"]["coordinates"][0][0][0] = 99.0
    assert scene.robot["coordinates"][0][0][0] != 99.0


def test_dict_takes_shapely_and_numpy(scene_dict: dict[str, Any]) -> None:
    scene_dict["robot"] = shapely.box(-0.5, -0.5, 0.5, 0.5)
    scene_dict["start"] = np.array([1.0, 1.0, 0.0])
    scene_dict["obstacles"] = (shapely.box(4, 4, 6, 6),)
    scene = load_scene(scene_dict)
    assert scene.robot["type"] == "Polygon"
    assert scene.start == [1.0, 1.0, 0.0]
    assert scene.obstacles[0]["type"] == "Polygon"


def test_name_defaults_to_that_of_the_file(tmp_path: Path, scene_dict: dict[str, Any]) -> None:
    del scene_dict["name"]
    assert load_scene(write(tmp_path, json.dumps(scene_dict))).name == "scene"


def test_byte_order_mark_and_utf16_are_json(tmp_path: Path, scene_dict: dict[str, Any]) -> None:
    for encoding in ("utf-8-sig", "utf-16"):
        file = write(tmp_path, json.dumps(scene_dict).encode(encoding))
        assert load_scene(file).name == "small"


def test_every_builtin_scene_loads_under_its_name() -> None:
    names = builtin.builtin_scenes()
    assert "gear" in names
    assert "manifest" not in names
    for name in names:
        assert load_scene(name).name == name
    assert set(builtin.manifest()) == set(names)


def test_misspelt_name_suggests() -> None:
    assert "did you mean 'gear'" in message("geer")
    assert "no built-in scene" in message("x\0y")
    assert "no built-in scene" in message("y" * 300)
    assert "no built-in scene" in message("")


def test_local_file_does_not_hide_a_builtin(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, scene_dict: dict[str, Any]
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "gear").write_text(json.dumps(scene_dict))
    assert load_scene("gear").name == "gear"
    assert load_scene("./gear").name == "small"


def test_missing_file_directory_and_device(tmp_path: Path) -> None:
    assert "No such file" in message(tmp_path / "absent.json")
    assert "directory" in message(tmp_path).lower()
    assert "cannot read" in message("a\0b/c.json")
    assert "cannot read" in message("z" * 300 + ".json")


def test_endless_file_is_cut_off(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr("planar_planner.scene.json_file.MAX_FILE_BYTES", 100)
    assert "larger than 100 bytes" in message(write(tmp_path, b" " * 101))
    assert "not JSON" in message(write(tmp_path, b" " * 100))
    assert limits.MAX_FILE_BYTES > 2**26


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("", "line 1, column 1"),
        ('{\n  "format": nope}', "line 2, column 13"),
        ("hello", "not JSON"),
        (b"\xff\xfe\xfa", "is not"),
        (b'{"name": "\xe9"}', "not UTF-8"),
        ("[" * 100_000, "nested too deeply"),
        ('{"a":' * 100_000, "nested too deeply"),
        ("[1, 2]", "must be a JSON object"),
        ("null", "must be a JSON object"),
        ("1" * 5000, "not usable JSON"),
        ('{"start": 1, "start": 2}', "start: field appears more than once"),
    ],
)
def test_what_is_no_scene_object(tmp_path: Path, text: str | bytes, expected: str) -> None:
    found = message(write(tmp_path, text))
    assert expected in found
    assert "scene.json" in found


def test_many_fields_of_which_one_stands_twice(tmp_path: Path) -> None:
    """Not a benchmark: looking for the name by counting each would take hours."""
    fields = ",".join(f'"a{i}": 1' for i in range(300_000))
    text = "{" + fields + ', "a299999": 2}'
    assert "a299999: field appears" in message(write(tmp_path, text))


@pytest.mark.parametrize("depth", [500, 900, 950, 985])
def test_nesting_that_json_still_reads(
    tmp_path: Path, scene_dict: dict[str, Any], depth: int
) -> None:
    from planar_planner.problem.make import make_problem

    text = json.dumps(scene_dict | {"robot": "DEEP"}).replace('"DEEP"', "[" * depth + "]" * depth)
    with pytest.raises(SceneError):
        make_problem(load_scene(write(tmp_path, text)))


def test_deep_and_cyclic_dicts(scene_dict: dict[str, Any]) -> None:
    deep: Any = []
    for _ in range(100_000):
        deep = [deep]
    with pytest.raises(SceneError, match="nested too deeply"):
        load_scene(scene_dict | {"robot": deep})
    while deep:  # taken apart from outside: freeing it in one go may exhaust the C stack
        deep = deep[0]
    cycle: dict[str, Any] = dict(scene_dict)
    cycle["robot"] = cycle
    with pytest.raises(SceneError):
        load_scene(cycle)
    with pytest.raises(SceneError, match="no JSON form"):
        load_scene(scene_dict | {"robot": {1, 2}})


@pytest.mark.parametrize("field", ["format", "version", "robot", "obstacles", "start", "goal"])
def test_missing_field(scene_dict: dict[str, Any], field: str) -> None:
    del scene_dict[field]
    found = message(scene_dict)
    assert f": {field}: field is missing" in found


def test_unknown_fields_and_versions(scene_dict: dict[str, Any]) -> None:
    assert "obstacle: unknown field; did you mean 'obstacles'?" in message(
        scene_dict | {"obstacle": []}
    )
    assert "zzz: unknown field; expected one of" in message(scene_dict | {"zzz": 1})
    for version in (2, 0, "1", True, None, 1.5, [1]):
        assert "version: unknown version" in message(scene_dict | {"version": version})
    for wrong in ("planar-planner/result", "", None, 3):
        assert "format: unknown format" in message(scene_dict | {"format": wrong})
    assert "name: must be a string (got 3)" in message(scene_dict | {"name": 3})
    assert "description: must be a string" in message(scene_dict | {"description": None})


def test_message_stays_on_one_line(tmp_path: Path, scene_dict: dict[str, Any]) -> None:
    message(scene_dict | {"a\nb\x1b[31m": 1})
    message(scene_dict | {"a" * 10**6: 1})
    message(scene_dict | {"version": "2" * 10**6})
    message(scene_dict | {"version": "line\nbreak"})
    folder = tmp_path / "with\nbreak"
    folder.mkdir()
    message(folder / "absent.json")


def test_wrong_kind_of_argument() -> None:
    with pytest.raises(TypeError, match="name, path or mapping"):
        load_scene(3)
