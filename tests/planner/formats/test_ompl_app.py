"""OMPL.app problems with meshes written here: plates, prisms, turned and scaled nodes."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import shapely

from planar_planner import Scene, SceneError, load_scene, solve
from planar_planner.cli.main import main
from support.format_help import read
from worlds.outside_files.ompl_app import IDENTITY, WALLS, Box, dae


def cfg(start: str, goal: str, bounds: str = "-10 -10 10 10") -> str:
    lines = ["[problem]", "name = ours", "robot = robot.dae", "world = world.dae"]
    for name, value in (("start", start), ("goal", goal)):
        lines += [
            f"{name}.{k} = {v}" for k, v in zip(("x", "y", "theta"), value.split(), strict=True)
        ]
    keys = ("min.x", "min.y", "max.x", "max.y")
    lines += [f"volume.{k} = {v}" for k, v in zip(keys, bounds.split(), strict=True)]
    return "\n".join([*lines, "[planner]", "rrt=", "rrt=range=5", "prm="]) + "\n"


def problem(folder: Path, world: list[Box], robot: list[Box], text: str, **kind: str) -> Scene:
    (folder / "world.dae").write_text(dae(world, **kind))
    (folder / "robot.dae").write_text(dae(robot, **kind))
    return read(folder / "ours.cfg", text)


ROBOT: list[Box] = [(2.0, 3.0, 5.0, 4.0)]
TRAP: list[Box] = [
    (-4, -4, 4, -3),
    (-4, 3, 4, 4),
    (-4, -4, -3, 4),
    (3, -4, 4, -0.7),
    (3, 0.7, 4, 4),
]


@pytest.mark.parametrize(
    ("world", "start", "goal", "verdict"),
    [
        (WALLS, "-5 0 0", "5 0 1.5", "path"),
        ([*WALLS, (-0.1, -1.0, 0.1, -0.2)], "-5 0 0", "5 0 1.5", "no_path"),
        (TRAP, "0 0 0", "7 0 0", "path"),
    ],
)
def test_problems_are_decided(
    world: list[Box], start: str, goal: str, verdict: str, tmp_path: Path
) -> None:
    scene = problem(tmp_path, world, ROBOT, cfg(start, goal))
    assert scene.name == "ours"
    assert solve(scene).verdict == verdict


@pytest.mark.parametrize("axis", ["Z_UP", "Y_UP"])
def test_the_plane_and_the_robots_origin(axis: str, tmp_path: Path) -> None:
    scene = problem(tmp_path, WALLS, ROBOT, cfg("-5 0 0", "5 0 0"), axis=axis)
    (ring,) = scene.robot["coordinates"]
    assert {tuple(p) for p in ring} == {(-1.5, -0.5), (1.5, -0.5), (1.5, 0.5), (-1.5, 0.5)}
    areas = [shapely.Polygon(o["coordinates"][0]).bounds for o in scene.obstacles]
    assert sorted(areas) == sorted(WALLS)
    assert scene.bounds == [-10, -10, 10, 10]


def test_nodes_move_turn_and_scale(tmp_path: Path) -> None:
    node = "<translate>1 2 3</translate><rotate>0 0 1 90</rotate><scale>2 2 2</scale>"
    (tmp_path / "world.dae").write_text(dae([(0, 0, 3, 1)], "Y_UP", node))
    (tmp_path / "robot.dae").write_text(dae(ROBOT, "Y_UP"))
    scene = read(tmp_path / "ours.cfg", cfg("-5 0 0", "5 0 0"))
    bounds = np.array(shapely.Polygon(scene.obstacles[0]["coordinates"][0]).bounds)
    assert bounds == pytest.approx([-1.0, 2.0, 1.0, 8.0])


def test_the_unit_scales(tmp_path: Path) -> None:
    text = dae(ROBOT).replace("<asset>", '<asset><unit meter="0.5"/>')
    (tmp_path / "world.dae").write_text(text)
    (tmp_path / "robot.dae").write_text(dae(ROBOT))
    scene = read(tmp_path / "ours.cfg", cfg("-5 0 0", "5 0 0"))
    assert shapely.Polygon(scene.obstacles[0]["coordinates"][0]).bounds == (1.0, 1.5, 2.5, 2.0)


def test_the_mean_counts_a_vertex_once_for_each_of_its_normals(tmp_path: Path) -> None:
    """Two normals at one corner weigh it twice, as in the importer behind OMPL.app."""
    text = dae([(0, 0, 3, 3)], "Y_UP", thick=0.0)
    normals = (
        '<source id="ns"><float_array id="na" count="6">0 0 1 1 0 0</float_array>'
        '<technique_common><accessor count="2" source="#na" stride="3"/></technique_common>'
        "</source>"
    )
    text = text.replace('<vertices id="v">', normals + '<vertices id="v">')
    start, end = text.index("<triangles"), text.index("</triangles>")
    group = (
        '<triangles count="2"><input offset="0" semantic="VERTEX" source="#v"/>'
        '<input offset="1" semantic="NORMAL" source="#ns"/><p>0 0 1 0 2 0 0 1 2 0 3 0</p>'
    )
    (tmp_path / "robot.dae").write_text(text[:start] + group + text[end:])
    (tmp_path / "world.dae").write_text(dae(WALLS))
    scene = read(tmp_path / "ours.cfg", cfg("-5 0 0", "5 0 0"))
    xs, ys = zip(*scene.robot["coordinates"][0], strict=True)
    assert min(xs) == pytest.approx(-6 / 5)  # mean of 0, 3, 3, 0 and 0 again
    assert min(ys) == pytest.approx(-6 / 5)


def test_triangulations_are_united_exactly(tmp_path: Path) -> None:
    """A plate of many triangles becomes one polygon without a point that the file does not have."""
    boxes = [(float(k), 0.0, k + 1.0, 1.0) for k in range(8)] + [(0.0, 1.0, 1.0, 5.0)]
    scene = problem(tmp_path, boxes, ROBOT, cfg("-5 -5 0", "5 -5 0"))
    (obstacle,) = scene.obstacles
    assert shapely.Polygon(obstacle["coordinates"][0]).area == 12.0
    assert any("united" in note for note in scene.notes)


def test_overlaps_that_need_computed_points_stay_apart(tmp_path: Path) -> None:
    boxes = [(0.0, 0.1, 3.0, 1.0), (1.1, -1.0, 1.7, 5.3)]
    scene = problem(tmp_path, boxes, ROBOT, cfg("-5 -5 0", "5 -5 0"))
    corners = {
        (x, y) for xmin, ymin, xmax, ymax in boxes for x in (xmin, xmax) for y in (ymin, ymax)
    }
    rings = [shapely.Polygon(o["coordinates"][0]) for o in scene.obstacles]
    assert {p for ring in rings for p in ring.exterior.coords} <= corners
    assert shapely.union_all(rings).area == pytest.approx(
        shapely.union_all([shapely.box(*b) for b in boxes]).area
    )
    assert any("kept apart" in note for note in scene.notes)


def test_a_mesh_is_a_robot_for_any_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "robot.dae").write_text(dae(ROBOT))
    (tmp_path / "walls.wkt").write_text("POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n")
    arguments = ["check", str(tmp_path / "walls.wkt"), "--robot", str(tmp_path / "robot.dae")]
    assert main([*arguments, "--start", "-5,0,0", "--goal", "5,0,0"]) == 0
    assert "path" in capsys.readouterr().out


def test_groups_other_than_triangles(tmp_path: Path) -> None:
    text = dae([(0, 0, 3, 3)], "Y_UP", thick=0.0)
    start, end = text.index("<triangles"), text.index("</triangles>") + len("</triangles>")
    vertex = '<input offset="0" semantic="VERTEX" source="#v"/>'
    groups = {
        "polylist": f"<polylist count='1'>{vertex}<vcount>4</vcount><p>0 1 2 3</p></polylist>",
        "polygons": f"<polygons count='1'>{vertex}<p>0 1 2 3</p></polygons>",
        "trifans": f"<trifans count='1'>{vertex}<p>0 1 2 3</p></trifans>",
        "tristrips": f"<tristrips count='1'>{vertex}<p>0 1 3 2</p></tristrips>",
    }
    (tmp_path / "robot.dae").write_text(dae(ROBOT))
    for name, group in groups.items():
        (tmp_path / "world.dae").write_text(text[:start] + group + text[end:])
        scene = read(tmp_path / "ours.cfg", cfg("-5 0 0", "5 0 0"))
        (obstacle,) = scene.obstacles
        assert shapely.Polygon(obstacle["coordinates"][0]).area == 9.0, name


GOOD = dae(WALLS)


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ("", "is not XML"),
        ("<COLLADA><asset></COLLADA>", "line 1"),
        ("<svg/>", "must be a COLLADA file"),
        ("<COLLADA/>", "visual_scene"),
        ('<!DOCTYPE x [<!ENTITY a "b">]><COLLADA/>', "entities"),
        (GOOD.replace('url="#g"', 'url="#nothing"'), "names nothing"),
        (GOOD.replace("Z_UP", "W_UP"), "up_axis"),
        (GOOD.replace("<p>0 1 2", "<p>0 1 999"), "names one of"),
        (GOOD.replace("<p>0 1 2", "<p>0 1"), "corners"),
        (GOOD.replace("<p>0 1 2", "<p>0 1 -2"), "count or an index"),
        (GOOD.replace('stride="3"', 'stride="400"'), "shorter than its accessor"),
        (GOOD.replace("-10.5", "ten"), "finite number"),
        (GOOD.replace(IDENTITY, "1 2 3"), "must have 16 numbers"),
        (
            GOOD.replace("<instance_geometry", '<instance_node url="#n"/><instance_geometry'),
            "itself",
        ),
    ],
)
def test_broken_meshes_say_where(text: str, place: str, tmp_path: Path) -> None:
    (tmp_path / "world.dae").write_text(text)
    (tmp_path / "robot.dae").write_text(dae(ROBOT))
    with pytest.raises(SceneError) as raised:
        read(tmp_path / "ours.cfg", cfg("-5 0 0", "5 0 0"))
    assert place in str(raised.value)
    assert str(raised.value).startswith(str(tmp_path / "world.dae"))


@pytest.mark.parametrize(
    ("change", "place"),
    [
        (("[problem]", "[other]"), "[problem]: section is missing"),
        (("[problem]", "problem"), "is no INI file"),
        (("robot = robot.dae", ""), "[problem] robot: is missing"),
        (("world.dae", "none.dae"), "none.dae: cannot read"),
        (("start.x = -5", "start.x = left"), "[problem] start.x: must be a number"),
        (("start.y = 0\n", ""), "[problem] start.y: is missing"),
        (("volume.max.y = 10\n", ""), "[problem] volume.max.y: is missing"),
        (("start.x", "start.z = 1\nstart.x"), "start.z: belongs to a problem in space"),
    ],
)
def test_wrong_fields_say_which(change: tuple[str, str], place: str, tmp_path: Path) -> None:
    with pytest.raises(SceneError) as raised:
        problem(tmp_path, WALLS, ROBOT, cfg("-5 0 0", "5 0 0").replace(*change))
    assert place in str(raised.value)


def test_ends_may_come_from_the_command_line(tmp_path: Path) -> None:
    text = "\n".join(line for line in cfg("0 0 0", "5 0 0").splitlines() if "start" not in line)
    with pytest.raises(SceneError, match=r"missing start: give it with --start"):
        problem(tmp_path, WALLS, ROBOT, text)
    scene = load_scene(tmp_path / "ours.cfg", _options(start=[-5, 0, 0]))
    assert scene.start == [-5, 0, 0]


def _options(**given: list[float]) -> object:
    from planar_planner.formats.parts import ImportOptions

    return ImportOptions(**given)
