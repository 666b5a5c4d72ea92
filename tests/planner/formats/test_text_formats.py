"""Well-known text, GeoJSON and Yap-style files: what they say, and where they are wrong."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
import shapely

from planar_planner import SceneError, load_scene, solve
from planar_planner.formats.parts import ImportOptions
from support.format_help import convert, read
from worlds.outside_files.texts import (
    BODY,
    FULL,
    ROB,
    ROBOT,
    WALL,
    WKT_SCENE,
    YAP,
    collection,
    feature,
    polygon,
)

ENDS: dict[str, Any] = {"start": [-5.0, 0.0, 0.0], "goal": [5.0, 0.0, 0.0]}


def test_well_known_text(tmp_path: Path) -> None:
    scene = read(tmp_path / "s.wkt", WKT_SCENE)
    assert len(scene.obstacles) == 2
    assert len(scene.obstacles[1]["coordinates"]) == 2
    assert (scene.start, scene.goal) == ([-5.0, 0.0, 0.0], [5.0, 0.0, 1.5])
    assert solve(scene).verdict == "path"


def test_plain_well_known_text_is_obstacles(tmp_path: Path) -> None:
    text = (
        "SRID=4326;POLYGON Z ((0 0 1, 1 0 1, 1 1 1, 0 0 1))\n"
        "GEOMETRYCOLLECTION (POLYGON ((3 3, 4 3, 4 4, 3 3)), POLYGON EMPTY)\n"
    )
    (tmp_path / "r.rob").write_text(ROB)
    scene = read(tmp_path / "s.wkt", text, robot=tmp_path / "r.rob", **ENDS)
    assert len(scene.obstacles) == 2
    assert any("states no bounds" in note for note in scene.notes)


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ("robot", "line 1: expected a role"),
        ("POLYGON ((0 0, 1 0, 1 1)", "line 1: a bracket is not closed"),
        ("\n\nPOLYGON ((0 0, 1 zero, 1 1))", "line 3: must be a number"),
        ("POLYGON ((0 0, 1, 1 1))", "line 1: a position must be x y"),
        ("POLYGON (0 0, 1 0, 1 1)", "line 1"),
        ("POLYGON )(", "line 1"),
        ("CURVEPOLYGON (COMPOUNDCURVE (1 1))", "line 1: expected POINT"),
        ("robot POINT (1 2)", "line 1"),
        ("workspace LINESTRING (1 2, 3 4)", "line 1: expected POINT"),
        ("start POINT M (1 2 3)", "line 1: a POINT has"),
        ("start POINT (1)", "line 1: a POINT has"),
        ("robt POLYGON ((0 0, 1 0, 1 1))", "did you mean 'robot'"),
        ("POLYGON ((0 0, 2 2, 2 0, 0 2))", "line 1: outline crosses itself"),
        ("POLYGON ((0 0, 1e300 0, 1 1))", "line 1: magnitude"),
        ("start POINT Z (1 2 3)\nstart POINT Z (1 2 3)", "line 2: a second start"),
        ("POLYGON " + "(" * 600, "line 1"),
    ],
)
def test_broken_well_known_text_says_where(text: str, place: str, tmp_path: Path) -> None:
    with pytest.raises(SceneError) as raised:
        read(tmp_path / "s.wkt", text, **ENDS)
    assert str(raised.value).startswith(str(tmp_path / "s.wkt"))
    assert place in str(raised.value)


@pytest.mark.parametrize("ending", ["geojson", "json", "txt.json"])
def test_geojson_by_name_or_content(ending: str, tmp_path: Path) -> None:
    scene = read(tmp_path / f"s.{ending}", FULL)
    assert scene.name == "ours"
    assert scene.goal == [5.0, 0.0, 1.5]
    assert scene.obstacles[0]["coordinates"][0][0] == [-1.0, -9.0]
    assert solve(scene).verdict == "path"


def test_holes_count_whichever_way_they_run(tmp_path: Path) -> None:
    hole = [[2.0, 2.0], [4.0, 2.0], [4.0, 4.0], [2.0, 4.0], [2.0, 2.0]]
    outer = [[0.0, 0.0], [6.0, 0.0], [6.0, 6.0], [0.0, 6.0], [0.0, 0.0]]
    for ring in (hole, hole[::-1]):
        text = collection(feature(None, polygon(outer, ring)), feature("robot", BODY))
        scene = read(tmp_path / "s.geojson", text, **ENDS)
        assert len(scene.obstacles[0]["coordinates"]) == 2


def test_touching_rings_are_repaired_and_told(tmp_path: Path) -> None:
    bow = polygon([[0, 0], [0, 0], [2, 2], [4, 0], [4, 4], [2, 2], [0, 4], [0, 0]])
    text = collection(feature(None, bow), feature("robot", BODY))
    scene = read(tmp_path / "s.geojson", text, **ENDS)
    assert len(scene.obstacles) == 2
    assert any("touch themselves" in note for note in scene.notes)
    assert any("repeated vertices" in note for note in scene.notes)


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ("[]", "must be a JSON object"),
        ('{"type": "FeatureCollection"}', "features: must be a list"),
        ('{"type": "FeatureCollection", "features": [3]}', "features[0]: must be a JSON object"),
        (collection(feature("robt", BODY)), "did you mean 'robot'"),
        (collection(feature(3, BODY)), "properties.role"),
        (collection(feature("start", BODY)), "must be Points"),
        (collection(feature("robot", {"type": "LineString", "coordinates": []})), "geometry.type"),
        (collection(feature("workspace", None)), "features[0].geometry"),
        (collection(feature(None, polygon([[0, 0], [1, "x"], [1, 1]]))), "coordinates[0][1][1]"),
        (collection(feature(None, polygon([[0, 0], [1], [1, 1]]))), "coordinates[0][1]"),
        (collection(feature(None, {"type": "Polygon"})), "coordinates"),
        (collection(feature("workspace", WALL), feature("workspace", WALL)), "features[1]"),
        (collection(feature("reference_bounds", BODY), feature("robot", BODY)), "missing start"),
    ],
)
def test_broken_geojson_says_where(text: str, place: str, tmp_path: Path) -> None:
    with pytest.raises(SceneError) as raised:
        read(tmp_path / "s.geojson", text)
    assert str(raised.value).startswith(str(tmp_path / "s.geojson"))
    assert place in str(raised.value)


def test_yap_style_environment(tmp_path: Path) -> None:
    (tmp_path / "r.rob").write_text(ROB)
    scene = read(tmp_path / "s.txt", YAP, robot=tmp_path / "r.rob", **ENDS)
    assert len(scene.obstacles) == 2
    assert len(scene.obstacles[0]["coordinates"]) == 2
    assert scene.workspace is not None
    assert solve(scene).verdict == "path"


@pytest.mark.parametrize(
    ("change", "place"),
    [
        (("16 ", "99 "), "ends before the last of 99 vertices"),
        (("16 ", "15 "), "where"),
        (("5 6 7 8 5", "5 6 7 88 5"), "line 10: must be between 1 and 16"),
        (("5 6 7 8 5", "5 6 seven 8 5"), "line 10: must be a number"),
        (("5 6 7 8 5", "5 6 8 7 5"), "line 10: outline crosses itself"),
        (("-9 -9", "-9 nan"), "line 3, vertex 1, y"),
        (("4  # polygons", "5"), "4 lines of polygons where 5 were announced"),
        (("13 14 15 16", "16 15 14 13"), "one outer boundary"),
        ((YAP, ""), "is empty"),
        ((YAP, "4\n0 0 1 0 1 1 0 1\n"), "ends before the number of polygons"),
    ],
)
def test_broken_environments_say_where(change: tuple[str, str], place: str, tmp_path: Path) -> None:
    (tmp_path / "r.rob").write_text(ROB)
    with pytest.raises(SceneError) as raised:
        read(tmp_path / "s.txt", YAP.replace(*change), robot=tmp_path / "r.rob", **ENDS)
    assert str(raised.value).startswith(str(tmp_path / "s.txt"))
    assert place in str(raised.value)


@pytest.mark.parametrize("text", ["", "4 0 0 1 0", "3 0 0 1 1 2 2", "3 0 0 1 0 1 1 7", "x"])
def test_broken_robots_are_named(text: str, tmp_path: Path) -> None:
    (tmp_path / "r.rob").write_text(text)
    with pytest.raises(SceneError) as raised:
        read(tmp_path / "s.wkt", "POLYGON ((0 0, 1 0, 1 1))", robot=tmp_path / "r.rob", **ENDS)
    assert str(raised.value).startswith(str(tmp_path / "r.rob"))


def test_robots_come_from_any_file(tmp_path: Path) -> None:
    files = {
        "r.wkt": ROBOT,
        "r1.wkt": ROBOT.removeprefix("robot "),  # the only shape
        "r.geojson": json.dumps(BODY),
        "r.json": FULL,
        "r.rob": ROB,
        "scene.json": json.dumps({"robot": BODY}),
    }
    for name, text in files.items():
        (tmp_path / name).write_text(text)
        scene = read(tmp_path / "s.wkt", "POLYGON ((0 0, 1 0, 1 1))", robot=tmp_path / name, **ENDS)
        assert {tuple(p) for p in scene.robot["coordinates"][0]} == {
            (-1.0, -0.5),
            (1.0, -0.5),
            (1.0, 0.5),
            (-1.0, 0.5),
        }, name


@pytest.mark.parametrize(
    ("name", "ending", "problem"),
    [
        ("gear", ".csv", "the competition's car"),
        ("gear", ".rob", "the name must end in"),
        ("comb", ".txt", "one polygon without holes"),
        ("window-fixed", ".dxf", "forbid turning"),
        ("gear", ".xyz", "the name must end in .json, "),
    ],
)
def test_what_a_format_cannot_hold_is_said(
    name: str, ending: str, problem: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert convert(name, tmp_path / f"out{ending}") == 2
    assert problem in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


def test_a_robot_that_is_not_star_shaped_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    hook = "robot POLYGON ((0 0, 4 0, 4 4, 3 4, 3 1, 0 1, 0 0))"
    text = WKT_SCENE.replace(ROBOT, f"{hook}\n")
    (tmp_path / "s.wkt").write_text(text)
    assert convert(tmp_path / "s.wkt", tmp_path / "out.txt") == 2
    assert "star-shaped" in capsys.readouterr().err


FAULTS = Path(__file__).parents[2] / "worlds" / "faults"
SQUARE = "0 0, 9 0, 9 9, 0 9, 0 0"
SMALL = "2 2, 4 2, 4 4, 2 4, 2 2"


@pytest.mark.parametrize(
    ("rings", "problem"),
    [
        ([SQUARE, "10 0, 12 0, 12 1, 10 0"], "[1]: the hole does not lie in its shell"),
        ([SMALL, SQUARE], "[1]: the hole does not lie in its shell"),
        ([SQUARE, SQUARE], "[1]: the hole is the whole of its shell"),
        ([SQUARE, SMALL, SMALL], "[2]: the hole shares area with hole 1"),
        ([SQUARE, "1 1, 5 1, 5 5, 1 5, 1 1", SMALL], "[2]: the hole shares area with hole 1"),
    ],
)
def test_holes_that_are_none_are_refused(rings: list[str], problem: str, tmp_path: Path) -> None:
    for turn in (slice(None), slice(None, None, -1)):
        text = ", ".join(f"({', '.join(ring.split(', ')[turn])})" for ring in rings)
        with pytest.raises(SceneError) as raised:
            read(tmp_path / "s.wkt", f"POLYGON ({text})", **ENDS)
        assert problem in str(raised.value)


@pytest.mark.parametrize("touch", ["0 0, 4 2, 2 4, 0 0", "0 2, 4 2, 4 4, 0 4, 0 2"])
def test_holes_that_touch_their_shell_stay(touch: str, tmp_path: Path) -> None:
    text = f"robot {ROBOT_TEXT}\nPOLYGON (({SQUARE}), ({touch}))"
    scene = read(tmp_path / "s.wkt", text, **ENDS)
    area = sum(map(shapely.area, map(shapely.geometry.shape, scene.obstacles)))
    hole = shapely.from_wkt(f"POLYGON (({touch}))").area
    assert area == 81 - hole


ROBOT_TEXT = "POLYGON ((0 0, 1 0, 0 1, 0 0))"


@pytest.mark.parametrize(
    "text",
    [
        f"polygon (({SQUARE}))",
        f"obstacle: Polygon(({SQUARE}))",
        f"srid=4326;MultiPolygon((({SQUARE})))",
        "POLYGONZ ((0 0 1, 9 0 1, 9 9 1, 0 9 1, 0 0 1))",
        "polygonzm((0 0 1 2, 9 0 1 2, 9 9 1 2, 0 9 1 2, 0 0 1 2))",
        f"MULTIPOLYGON (EMPTY, (({SQUARE})))",
        "GEOMETRYCOLLECTION (POLYGON EMPTY, LineString (0 0, 1 1), POINT (3 3), "
        f"POLYGON (({SQUARE})))",
    ],
)
def test_spellings_of_well_known_text(text: str, tmp_path: Path) -> None:
    for name in ("s.wkt", "s.text"):
        scene = read(tmp_path / name, f"robot {ROBOT_TEXT}\n{text}", **ENDS)
        (obstacle,) = scene.obstacles
        assert shapely.geometry.shape(obstacle).area == 81.0


def test_what_has_no_area_is_left_out_and_counted() -> None:
    given = ImportOptions(
        footprint="[[-0.3,-0.1],[0.3,-0.1],[0.3,0.1],[-0.3,0.1]]",
        start=[1.0, 1.0, 0.0],
        goal=[3.0, 1.0, 0.0],
    )
    for name in ("g_null.geojson", "g_line.geojson"):
        scene = load_scene(FAULTS / name, given)
        assert any("left out" in note for note in scene.notes)
        assert any("1 of the file's things became nothing" in note for note in scene.notes)
        assert solve(scene).verdict == "no_path"


def test_a_hole_outside_its_shell_is_refused_with_its_ring() -> None:
    with pytest.raises(SceneError, match=r"line 3, \[1\]: the hole does not lie in its shell"):
        load_scene(FAULTS / "hole_outside.wkt")
