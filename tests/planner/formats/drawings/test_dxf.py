"""DXF drawings made with ezdxf here: layers, loose lines, arcs, splines, blocks."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest
import shapely

from planar_planner import Scene, SceneError, load_scene, solve
from support.format_help import convert, read, rings
from worlds.outside_files.dxf import Draw, box, dxf


def shape(scene: Scene, k: int = 0) -> shapely.Polygon:
    found = scene.obstacles[k]["coordinates"]
    return shapely.Polygon(found[0], found[1:])


def on(layer: str) -> dict[str, Any]:
    return {"dxfattribs": {"layer": layer}}


def test_layers_are_roles_and_marks_show_direction(tmp_path: Path) -> None:
    text = dxf(
        lambda m: box(m, "OBSTACLES", 20, 3, 22, 12),
        lambda m: box(m, "dimensions", 0, 0, 1, 1),
        lambda m: m.add_text("wall", **on("obstacles")),
    )
    scene = read(tmp_path / "d.dxf", text)
    assert shape(scene).bounds == (20, 3, 22, 12)
    assert scene.start == [10, 5, 0]
    assert scene.goal == [30, 5, math.pi / 2]
    assert "entities on layers without a role ignored: 1" in scene.notes
    assert solve(scene).verdict == "path"
    other = read(tmp_path / "d.dxf", text, roles=(("dim*", "obstacle"),))
    assert len(other.obstacles) == 2


def test_loose_lines_and_arcs_are_joined(tmp_path: Path) -> None:
    """A slot of two lines, in any order and direction, and two half circles."""

    def slot(space: Any) -> None:
        space.add_line((20, 1), (26, 1), **on("obstacle"))
        space.add_arc((26, 0), 1, -90, 90, **on("obstacle"))
        space.add_arc((20, 0), 1, 90, 270, **on("obstacle"))
        space.add_line((20, -1 - 1e-9), (26, -1), **on("obstacle"))

    area = 12 + math.pi
    for side, sign in (("outwards", 1), ("inwards", -1)):
        scene = read(tmp_path / "d.dxf", dxf(slot), flatten=side, tolerance=0.01)
        (found,) = (shape(scene),)
        assert 0 < sign * (found.area - area) < 0.01 * 2 * math.pi
        assert any("the widest gap is 1" in note for note in scene.notes)


@pytest.mark.parametrize("side", ["outwards", "inwards"])
def test_bulges_circles_ellipses_and_splines(side: str, tmp_path: Path) -> None:
    def draw(space: Any) -> None:
        points = [(20, 0, 0.5), (24, 0, -0.3), (24, 4, 1.5), (20, 4, 0)]
        space.add_lwpolyline(points, format="xyb", close=True, **on("obstacle1"))
        space.add_circle((40, 0), 3, **on("obstacle2"))
        space.add_ellipse((60, 0), (5, 1), 0.5, **on("obstacle3"))

    scene = read(tmp_path / "d.dxf", dxf(draw), flatten=side, tolerance=0.02)
    bulged, circle, ellipse = (shape(scene, k) for k in range(3))

    def segment(chord: float, bulge: float) -> float:
        turn = 4 * math.atan(bulge)
        radius = chord / 2 / math.sin(turn / 2)
        return radius**2 * (turn - math.sin(turn)) / 2

    expected = 16 + segment(4, 0.5) - segment(4, 0.3) + segment(4, 1.5)
    sign = 1 if side == "outwards" else -1
    for found, area in (
        (bulged, expected),
        (circle, 9 * math.pi),
        (ellipse, math.pi * 26 * 0.5),
    ):
        assert 0 < sign * (found.area - area) < 0.02 * found.length
    assert circle.covers(shapely.Point(43, 0)) == (side == "outwards")


@pytest.mark.parametrize("weights", [None, [1, 2, 0.5, 3, 1, 1]])
def test_splines_stay_on_their_side(weights: list[float] | None, tmp_path: Path) -> None:
    controls = [(20, 0), (22, 5), (25, -4), (28, 6), (30, 1), (31, 0)]

    def draw(space: Any) -> None:
        spline = (
            space.add_open_spline(controls, **on("obstacle"))
            if weights is None
            else space.add_rational_spline(controls, weights, **on("obstacle"))
        )
        samples.extend((p.x, p.y) for p in spline.construction_tool().approximate(500))
        space.add_lwpolyline([(31, 0), (31, -9), (20, -9), (20, 0)], **on("obstacle"))

    for side in ("outwards", "inwards"):
        samples: list[tuple[float, float]] = []
        scene = read(tmp_path / "d.dxf", dxf(draw), flatten=side, tolerance=0.02)
        found = shape(scene)
        edge = found.exterior
        for p in samples[1:-1]:
            assert (
                found.covers(shapely.Point(p)) == (side == "outwards")
                or edge.distance(shapely.Point(p)) < 1e-9
            )
            assert edge.distance(shapely.Point(p)) <= 0.02


def test_blocks_are_taken_apart(tmp_path: Path) -> None:
    def draw(space: Any) -> None:
        block = space.doc.blocks.new("pillar")
        box(block, "0", 0, 0, 1, 2)
        block.add_circle((5, 5), 1, **on("obstacles"))
        space.add_blockref("pillar", (50, 0), **on("obstacle-x")).dxf.xscale = 3
        space.add_blockref("pillar", (80, 0), dxfattribs={"layer": "obstacle-y", "rotation": 90})

    scene = read(tmp_path / "d.dxf", dxf(draw), tolerance=0.01)
    bounds = sorted(shape(scene, k).bounds for k in range(4))
    assert bounds[0] == pytest.approx((50, 0, 53, 2))
    assert bounds[1] == pytest.approx((62, 4, 68, 6), abs=0.02)  # the circle, made an ellipse
    assert bounds[3] == pytest.approx((78, 0, 80, 1))


def test_every_second_outline_is_a_hole(tmp_path: Path) -> None:
    def draw(space: Any) -> None:
        for half in (9, 6, 3):
            box(space, "obstacle", 50 - half, -half, 50 + half, half)
        box(space, "obstacle", 55, 5, 70, 20)  # crosses the others: on its own

    scene = read(tmp_path / "d.dxf", dxf(draw))
    areas = sorted(shape(scene, k).area for k in range(len(scene.obstacles)))
    assert areas == [36, 324 - 144, 225]


def test_crossing_outlines_are_united(tmp_path: Path) -> None:
    """One inside two of which one crosses the other; and one that stands there twice."""

    def draw(space: Any) -> None:
        box(space, "obstacle", 40, -10, 60, 10)
        box(space, "obstacle", 42, -8, 58, 8)  # a hole in the first
        box(space, "obstacle", 45, -20, 55, 20)  # crosses both
        box(space, "obstacle", 48, -2, 52, 2)  # inside all three
        space.add_circle((80, 0), 1, **on("obstacle"))
        space.add_circle((80, 0), 1, **on("obstacle"))

    scene = read(tmp_path / "d.dxf", dxf(draw), tolerance=0.01)
    shapes = [shape(scene, k) for k in range(len(scene.obstacles))]
    assert len(shapes) == 4
    found = shapely.union_all([s for s in shapes if s.bounds[0] < 70])
    assert found.area == 400 - 256 + 400 - 40
    assert "outlines that are drawn twice taken once: 1" in scene.notes


def test_an_entity_seen_from_below_is_mirrored(tmp_path: Path) -> None:
    below = {"layer": "obstacle", "extrusion": (0, 0, -1)}
    text = dxf(
        lambda m: m.add_lwpolyline(
            [(-20, 0, 1), (-22, 0, 0), (-22, -3, 0), (-20, -3, 0)],
            format="xyb",
            close=True,
            dxfattribs=below,
        )
    )
    scene = read(tmp_path / "d.dxf", text, tolerance=0.01)
    assert shape(scene).bounds == pytest.approx((20, -3, 22, 1), abs=0.02)


@pytest.mark.parametrize("name", ["corner", "gear", "bug-trap", "slot-jammed"])
def test_shipped_scenes_come_back(name: str, tmp_path: Path) -> None:
    file = tmp_path / "scene.dxf"
    assert convert(name, file) == 0
    before, after = load_scene(name), load_scene(file)
    assert rings(before.robot) == rings(after.robot)
    assert sorted(map(rings, before.obstacles)) == sorted(map(rings, after.obstacles))
    assert after.start == pytest.approx(before.start)
    assert after.goal == pytest.approx(before.goal)
    assert solve(before).verdict == solve(after).verdict


@pytest.mark.parametrize(
    ("draw", "place"),
    [
        (
            lambda m: m.add_line((0, 0), (1, 1), **on("obstacle")),
            "layer 'obstacle', LINE 32: outline is open",
        ),
        (lambda m: m.add_point((0, 0), **on("start")), "second mark for start"),
        (lambda m: m.add_3dface([(0, 0), (1, 0), (0, 1)], **on("robot")), "3DFACE"),
        (
            lambda m: m.add_circle(
                (0, 0), 1, dxfattribs={"layer": "robot", "extrusion": (1, 0, 0)}
            ),
            "does not lie in the x–y plane",
        ),
        (lambda m: m.add_spline([(0, 0), (1, 1), (2, 0)], **on("robot")), "outline is open"),
        (lambda m: m.add_spline([(0, 0)], **on("robot")), "neither control points nor fit points"),
        (lambda m: m.add_circle((0, 0), 1e99, **on("robot")), "magnitude"),
        (
            lambda m: m.add_lwpolyline([(0, 0), (2, 2), (2, 0), (0, 2)], close=True, **on("robot")),
            "outline crosses itself",
        ),
    ],
)
def test_what_cannot_be_read_says_where(draw: Draw, place: str, tmp_path: Path) -> None:
    with pytest.raises(SceneError) as raised:
        read(tmp_path / "d.dxf", dxf(draw))
    assert place in str(raised.value)


@pytest.mark.parametrize(
    "data",
    [b"", b"nonsense", b"AutoCAD Binary DXF\r\n\x1a\x00", b"0\nSECTION\n2\nENTITIES\n0\nLINE"],
)
def test_broken_files_are_named(data: bytes, tmp_path: Path) -> None:
    with pytest.raises(SceneError) as raised:
        read(tmp_path / "d.dxf", data)
    assert str(raised.value).startswith(str(tmp_path / "d.dxf"))
