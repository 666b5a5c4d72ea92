"""DXF drawings are read as a viewer shows them: fills, widths, arrays, and what is hidden."""

from __future__ import annotations

import io
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import shapely
from ezdxf.document import Drawing as Document
from ezdxf.math import closed_uniform_bspline

from planar_planner import Scene, SceneError
from support.format_help import read

POINT = "[[-0.01,-0.01],[0.01,-0.01],[0.01,0.01],[-0.01,0.01]]"
ON = {"layer": "obstacle"}
SQUARE = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)]


def drawn(path: Path, draw: Callable[[Document], object], **options: Any) -> Scene:
    document = Document.new("R2010")
    draw(document)
    stream = io.StringIO()
    document.write(stream)
    far = {"footprint": POINT, "start": [900.0, 900.0, 0.0], "goal": [901.0, 900.0, 0.0]}
    return read(path / "d.dxf", stream.getvalue(), **{**far, "tolerance": 0.001, **options})


def region(scene: Scene) -> Any:
    polygons = [shapely.Polygon(r[0], r[1:]) for r in (o["coordinates"] for o in scene.obstacles)]
    return shapely.union_all(polygons)


def hatch(document: Document) -> Any:
    return document.modelspace().add_hatch(dxfattribs=ON)


# ---- fills ------------------------------------------------------------------------------------


def test_hatches_are_areas_with_arcs_and_holes(tmp_path: Path) -> None:
    def draw(document: Document) -> None:
        paths = hatch(document).paths
        edges = paths.add_edge_path()
        edges.add_line((0, 0), (10, 0))
        edges.add_arc((10, 5), 5, -90, 90)
        edges.add_line((10, 10), (0, 10))
        edges.add_ellipse((0, 5), (0, 5), 0.5, 0, 180)
        paths.add_polyline_path([(2, 2), (4, 2), (4, 4), (2, 4)], flags=16)

    scene = drawn(tmp_path, draw)
    expected = 100 + 25 * math.pi / 2 + 5 * 2.5 * math.pi / 2 - 4
    assert region(scene).area == pytest.approx(expected, abs=0.05)
    assert region(scene).bounds == pytest.approx((-2.5, 0, 15, 10), abs=0.002)
    assert "hatches read as filled areas: 1" in scene.notes


@pytest.mark.parametrize(("style", "area"), [(0, 6400 - 3600 + 900), (1, 2800), (2, 6400)])
def test_a_hatch_style_chooses_the_islands(style: int, area: float, tmp_path: Path) -> None:
    def draw(document: Document) -> None:
        own = hatch(document)
        own.dxf.hatch_style = style
        for half, flags in ((40, 1), (30, 16), (15, 0)):
            ring = [(-half, -half), (half, -half), (half, half), (-half, half)]
            own.paths.add_polyline_path(ring, flags=flags)

    assert region(drawn(tmp_path, draw)).area == area


def test_solids_are_areas_and_points_are_not(tmp_path: Path) -> None:
    def draw(document: Document) -> None:
        space = document.modelspace()
        space.add_solid([SQUARE[0], SQUARE[1], SQUARE[3], SQUARE[2]], dxfattribs=ON)
        space.add_trace([(20, 0), (30, 0), (20, 10), (30, 10)], dxfattribs=ON)
        space.add_point((50, 50), dxfattribs=ON)

    scene = drawn(tmp_path, draw)
    assert region(scene).area == 200
    assert {"solids read as areas: 2", "points ignored: 1"} <= set(scene.notes)


def test_a_width_is_drawn_with_mitres(tmp_path: Path) -> None:
    def draw(document: Document) -> None:
        document.modelspace().add_lwpolyline(
            [(0, 0), (10, 0), (10, 10)], dxfattribs={**ON, "const_width": 2}
        )

    expected = shapely.Polygon([(0, -1), (11, -1), (11, 10), (9, 10), (9, 1), (0, 1)])
    scene = drawn(tmp_path, draw)
    assert region(scene).symmetric_difference(expected).area < 1e-12
    assert "polylines with a width read as the bands that a viewer shows: 1" in scene.notes


def test_a_donut_is_a_ring(tmp_path: Path) -> None:
    def draw(document: Document) -> None:
        document.modelspace().add_lwpolyline(
            [(-10, 0, 4, 4, 1), (10, 0, 4, 4, 1)], format="xyseb", close=True, dxfattribs=ON
        )

    scene = drawn(tmp_path, draw)
    assert region(scene).area == pytest.approx(math.pi * (144 - 64), abs=0.2)
    assert not region(scene).contains(shapely.Point(0, 0))
    assert any(note.endswith("shows, their insides free: 1") for note in scene.notes)


@pytest.mark.parametrize("kind", ["fit", "periodic"])
def test_fitted_and_periodic_splines_are_closed_curves(kind: str, tmp_path: Path) -> None:
    corners = [(10, 0), (0, 10), (-10, 0), (0, -10)]

    def draw(document: Document) -> None:
        space = document.modelspace()
        if kind == "fit":
            space.add_spline([*corners, corners[0]], dxfattribs=ON)
        else:
            spline = space.add_spline(dxfattribs=ON)
            spline.apply_construction_tool(closed_uniform_bspline(corners, order=4))
        curves.append(space[0].construction_tool().approximate(2000))

    curves: list[Any] = []
    scene = drawn(tmp_path, draw)
    ring = shapely.Polygon([(p.x, p.y) for p in curves[0]])
    assert region(scene).area == pytest.approx(ring.area, abs=0.1)
    assert region(scene).buffer(1e-6).covers(ring)


# ---- blocks -----------------------------------------------------------------------------------


def _block(document: Document, layer: str = "0") -> Any:
    block = document.blocks.new("B")
    block.add_lwpolyline(SQUARE, close=True, dxfattribs={"layer": layer})
    return block


def test_arrays_are_repeated_also_in_blocks(tmp_path: Path) -> None:
    def draw(document: Document) -> None:
        _block(document)
        outer = document.blocks.new("C")
        outer.add_blockref("B", (0, 0), {"column_count": 3, "column_spacing": 15})
        grid = {"row_count": 2, "row_spacing": 100, "rotation": 90, **ON}
        document.modelspace().add_blockref("C", (0, 0), grid)

    found = region(drawn(tmp_path, draw))
    assert found.area == pytest.approx(600)
    assert found.bounds == pytest.approx((-110, 0, 0, 40))


def test_a_turned_block_in_a_stretched_one_is_skewed(tmp_path: Path) -> None:
    def draw(document: Document) -> None:
        _block(document)
        document.blocks.new("C").add_blockref("B", (0, 0), {"rotation": 45})
        document.modelspace().add_blockref("C", (5, 7), {**ON, "xscale": 2, "yscale": 1})

    side = 10 / math.sqrt(2)
    expected = [(5, 7), (5 + 2 * side, 7 + side), (5, 7 + 2 * side), (5 - 2 * side, 7 + side)]
    found = region(drawn(tmp_path, draw))
    assert found.symmetric_difference(shapely.Polygon(expected)).area < 1e-9


def test_a_clipped_block_is_refused(tmp_path: Path) -> None:
    from ezdxf.xclip import XClip

    def draw(document: Document) -> None:
        _block(document)
        XClip(document.modelspace().add_blockref("B", (0, 0), ON)).set_wcs_clipping_path(
            [(1, 1), (5, 5)]
        )

    with pytest.raises(SceneError, match=r"INSERT .*shows only a part of its block"):
        drawn(tmp_path, draw)


# ---- what is not shown ------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("state", "own", "insertion", "seen"),
    [
        ("off", "0", "hidden", False),
        ("off", "obstacle", "hidden", True),  # of its insertion only layer 0 is off
        ("frozen", "0", "hidden", False),
        ("frozen", "obstacle", "hidden", False),
        ("frozen", "hidden", "obstacle", False),
        ("invisible", "0", "obstacle", False),
    ],
)
def test_hidden_insertions(
    state: str, own: str, insertion: str, *, seen: bool, tmp_path: Path
) -> None:
    def draw(document: Document) -> None:
        layer = document.layers.add("hidden")
        if state == "off":
            layer.off()
        elif state == "frozen":
            layer.freeze()
        _block(document, own)
        more = {"layer": insertion, "invisible": int(state == "invisible")}
        document.modelspace().add_blockref("B", (0, 0), more)
        document.modelspace().add_lwpolyline([(90, 0), (91, 0), (91, 1)], close=True, dxfattribs=ON)

    scene = drawn(tmp_path, draw, roles=(("hidden", "obstacle"),))
    assert region(scene).area == (100.5 if seen else 0.5)
    assert any(note.startswith("entities not shown ignored") for note in scene.notes) != seen


def test_paper_space_and_missing_blocks_are_counted(tmp_path: Path) -> None:
    def draw(document: Document) -> None:
        document.modelspace().add_lwpolyline(SQUARE, close=True, dxfattribs=ON)
        document.modelspace().add_blockref("NONE", (0, 0), ON)
        document.layout("Layout1").add_circle((50, 50), 9, dxfattribs=ON)

    scene = drawn(tmp_path, draw)
    assert region(scene).area == 100
    assert "entities in paper space ignored: 1" in scene.notes
    assert "insertions of missing or external blocks ignored: 1" in scene.notes


# ---- outlines that touch ----------------------------------------------------------------------


@pytest.mark.parametrize("turn", [0.0, 0.3, 1.1])
def test_a_hole_may_share_an_edge_or_reach_the_box(turn: float, tmp_path: Path) -> None:
    cos, sin = math.cos(turn), math.sin(turn)

    def draw(document: Document) -> None:
        for ring in (
            [(0, 0), (30, 10), (60, 0), (60, 60), (0, 60)],
            [(0, 20), (10, 20), (10, 40), (0, 40)],
            [(20, 20), (60, 30), (20, 40)],
        ):
            turned = [(x * cos - y * sin, x * sin + y * cos) for x, y in ring]
            document.modelspace().add_lwpolyline(turned, close=True, dxfattribs=ON)

    assert region(drawn(tmp_path, draw)).area == pytest.approx(3300 - 200 - 400)


def test_arcs_that_meet_at_a_junction_bound_one_area(tmp_path: Path) -> None:
    """Two half circles bulge to both sides of a line on which both end."""

    def draw(document: Document) -> None:
        space = document.modelspace()
        space.add_line((0, -10), (0, 10), dxfattribs=ON)
        space.add_arc((0, 0), 10, -90, 90, dxfattribs=ON)
        space.add_arc((0, 0), 10, 90, 270, dxfattribs=ON)

    scene = drawn(tmp_path, draw)
    assert region(scene).area == pytest.approx(100 * math.pi, abs=0.1)
    assert "lines that only divide what an outline bounds ignored: 1" in scene.notes


def test_a_line_between_outlines_is_named(tmp_path: Path) -> None:
    def draw(document: Document) -> None:
        space = document.modelspace()
        for x in (0, 50):
            space.add_lwpolyline([(x + p, q) for p, q in SQUARE], close=True, dxfattribs=ON)
        space.add_line((10, 5), (50, 5), dxfattribs=ON)

    with pytest.raises(SceneError, match=r"LINE .*bounds nothing"):
        drawn(tmp_path, draw)


def test_a_blocks_entities_are_read_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from planar_planner.formats.readers.dxf import reading

    def draw(document: Document) -> None:
        _block(document)
        for k in range(7):
            document.modelspace().add_blockref("B", (30 * k, 0), {"rotation": 10 * k, **ON})
        grid = {"column_count": 5, "column_spacing": 30, "rotation": 30, **ON}
        document.modelspace().add_blockref("B", (0, 200), grid)

    read_entities = []

    def run_of(entity: Any, place: str) -> Any:
        read_entities.append(entity)
        return run(entity, place)

    run = reading.run_of
    monkeypatch.setattr(reading, "run_of", run_of)
    assert region(drawn(tmp_path, draw)).area == pytest.approx(1200)
    assert 0 < len(read_entities) == len(set(map(id, read_entities)))
