"""Generated DXF drawings, one feature each; what a viewer shows on layer ``obstacle`` counts.

A closed outline stands for its inside, an outline inside another for a hole. Drawings are written
by ezdxf.
"""

from __future__ import annotations

import io
import math
import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any

import ezdxf
from ezdxf.document import Drawing as Document
from ezdxf.math import closed_uniform_bspline

from ..model import Drawing

SEEN = (
    r"hidden|not shown|invisible|not drawn|frozen|switched off|off layer|left out|skipped|ignored"
)
LAYER = {"layer": "obstacle"}


@dataclass
class Sheet:
    """A document under work.

    Attributes
    ----------
    hints : dict
        ``told``: no area is right without a note. ``inside``: corners of a closed outline that a
        viewer shows as a wide line; its inside may be taken as well if a note says so.
    """

    document: Document
    rng: random.Random
    must_say: str = ""
    hints: dict[str, Any] = field(default_factory=dict)

    @property
    def space(self) -> Any:
        """The model space."""
        return self.document.modelspace()


Maker = Callable[[Sheet], None]
MAKERS: dict[str, Maker] = {}


def feature(make: Maker) -> Maker:
    """Register a maker under its name."""
    MAKERS[make.__name__] = make
    return make


def drawings(rng: random.Random, count: int, only: str = "") -> Iterator[Drawing]:
    """Yield drawings, each feature in turn."""
    names = [name for name in MAKERS if only in name]
    for k in range(count):
        name = names[k % len(names)]
        document = ezdxf.new(rng.choice(["R2000", "R2010", "R2018"]))
        document.layers.add("obstacle")
        sheet = Sheet(document, rng)
        MAKERS[name](sheet)
        stream = io.StringIO()
        document.write(stream)
        data = stream.getvalue().encode()
        options = {"tolerance": 0.02, "flatten": rng.choice(["outwards", "outwards", "inwards"])}
        yield Drawing(name, "d.dxf", {"d.dxf": data}, options, sheet.must_say, "", sheet.hints)


def square(x: float, y: float, w: float, h: float | None = None) -> list[tuple[float, float]]:
    """Return the corners of a rectangle."""
    h = w if h is None else h
    return [(x, y), (x + w, y), (x + w, y + h), (x, y + h)]


def place(rng: random.Random) -> tuple[float, float, float]:
    """Return a random lower left corner and width."""
    return rng.randint(5, 40), rng.randint(5, 40), rng.randint(20, 40)


def outline(sheet: Sheet, points: list[tuple[float, float]], **more: Any) -> Any:
    """Add a closed polyline."""
    return sheet.space.add_lwpolyline(points, close=True, dxfattribs={**LAYER, **more})


def seen(sheet: Sheet) -> None:
    """Add something that is always seen."""
    sheet.space.add_circle((85, 85), 8, dxfattribs=LAYER)


# ---- loose lines ------------------------------------------------------------------------------


def _lines(sheet: Sheet, points: list[tuple[float, float]], gap: float = 0.0) -> None:
    edges = list(zip(points, points[1:] + points[:1], strict=True))
    sheet.rng.shuffle(edges)
    for k, (a, b) in enumerate(edges):
        start, end = (a, b) if sheet.rng.random() < 0.5 else (b, a)
        if k == 0 and gap:
            start = (start[0] + gap, start[1])
        sheet.space.add_line(start, end, dxfattribs=LAYER)


@feature
def lines(sheet: Sheet) -> None:
    x, y, w = place(sheet.rng)
    _lines(sheet, square(x, y, w))


@feature
def lines_and_arcs(sheet: Sheet) -> None:
    x, y, w = place(sheet.rng)
    sheet.space.add_line((x, y), (x + w, y), dxfattribs=LAYER)
    sheet.space.add_line((x, y), (x, y + w), dxfattribs=LAYER)
    sheet.space.add_arc((x, y), w, 0, 90, dxfattribs=LAYER)


@feature
def gaps(sheet: Sheet) -> None:
    x, y, w = place(sheet.rng)
    _lines(sheet, square(x, y, w), sheet.rng.choice([1e-9, 1e-7, 1e-4, 1e-2]))


@feature
def doubled_line(sheet: Sheet) -> None:
    x, y, w = place(sheet.rng)
    points = square(x, y, w)
    _lines(sheet, points)
    sheet.space.add_line(points[0], points[1], dxfattribs=LAYER)


@feature
def doubled_outline(sheet: Sheet) -> None:
    x, y, w = place(sheet.rng)
    outline(sheet, square(x, y, w))
    outline(sheet, square(x, y, w))


@feature
def doubled_in_parts(sheet: Sheet) -> None:
    x, y, w = place(sheet.rng)
    outline(sheet, square(x, y, w))
    _lines(sheet, square(x, y, w))


@feature
def t_junction(sheet: Sheet) -> None:
    x, y, w = place(sheet.rng)
    _lines(sheet, square(x, y, w))
    sheet.space.add_line((x + w / 2, y), (x + w / 2, y + w), dxfattribs=LAYER)


@feature
def shared_corners(sheet: Sheet) -> None:
    x, y, w = place(sheet.rng)
    _lines(sheet, square(x, y, w / 2))
    _lines(sheet, square(x + w / 2, y + w / 2, w / 2))


@feature
def shared_edge(sheet: Sheet) -> None:
    x, y, w = place(sheet.rng)
    outline(sheet, square(x, y, w / 2))
    outline(sheet, square(x + w / 2, y, w / 2, w))


@feature
def overlap(sheet: Sheet) -> None:
    x, y, w = place(sheet.rng)
    outline(sheet, square(x, y, w))
    sheet.space.add_circle((x + w, y + w / 2), w / 3, dxfattribs=LAYER)


@feature
def crossing_lines(sheet: Sheet) -> None:
    """Four walls that cross each other like a # enclose the middle; refused, or the middle."""
    for k in (20, 60):
        sheet.space.add_line((k, 0), (k, 80), dxfattribs=LAYER)
        sheet.space.add_line((0, k), (80, k), dxfattribs=LAYER)


@feature
def stray_line(sheet: Sheet) -> None:
    x, y, w = place(sheet.rng)
    outline(sheet, square(x, y, w))
    sheet.space.add_line((90, 0), (90, 50), dxfattribs=LAYER)


# ---- holes ------------------------------------------------------------------------------------


@feature
def hole(sheet: Sheet) -> None:
    draw = sheet.rng.choice([outline, _lines])
    draw(sheet, square(5, 5, 60))
    if sheet.rng.random() < 0.5:
        outline(sheet, square(20, 20, 25)[:: sheet.rng.choice([1, -1])])
    else:
        _lines(sheet, square(20, 20, 25))


@feature
def island_in_hole(sheet: Sheet) -> None:
    outline(sheet, square(5, 5, 80))
    sheet.space.add_circle((45, 45), 30, dxfattribs=LAYER)
    outline(sheet, square(35, 35, 15))


@feature
def hole_touches_edge(sheet: Sheet) -> None:
    _touching(sheet, 0.0)


@feature
def hole_touches_turned_edge(sheet: Sheet) -> None:
    _touching(sheet, math.radians(30))


def _touching(sheet: Sheet, turn: float) -> None:
    """Draw a triangular hole whose corner lies on the outline."""
    cos, sin = math.cos(turn), math.sin(turn)
    x = sheet.rng.randint(10, 40)
    for ring in (square(0, 0, 60), [(0.0, 30.0), (x, 20.0), (x, 40.0)]):
        outline(sheet, [(px * cos - py * sin, px * sin + py * cos) for px, py in ring])


@feature
def hole_touches_box(sheet: Sheet) -> None:
    """A hole that reaches the bounding box of its outline without touching the outline."""
    outline(sheet, [(0, 0), (30, 10), (60, 0), (60, 60), (0, 60)])
    outline(sheet, [(20, 20), (60, 30), (20, 40)])


@feature
def hole_shares_edge(sheet: Sheet) -> None:
    outline(sheet, square(5, 5, 60))
    outline(sheet, square(5, 20, 20, 25))


@feature
def hole_touches_hole(sheet: Sheet) -> None:
    outline(sheet, square(0, 0, 90))
    outline(sheet, square(10, 10, 30))
    outline(sheet, square(40, 40, 30))


@feature
def hole_crosses(sheet: Sheet) -> None:
    outline(sheet, square(5, 5, 60))
    outline(sheet, square(50, 20, 40, 25))


@feature
def hole_on_other_layer(sheet: Sheet) -> None:
    """Layers are taken one by one: what is on another layer of the role is added."""
    outline(sheet, square(5, 5, 60))
    sheet.document.layers.add("obstacle_2")
    outline(sheet, square(20, 20, 25), layer="obstacle_2")


# ---- curves -----------------------------------------------------------------------------------


@feature
def circle(sheet: Sheet) -> None:
    x, y, w = place(sheet.rng)
    sheet.space.add_circle((x, y), w / 2, dxfattribs=LAYER)


@feature
def ellipse(sheet: Sheet) -> None:
    x, y, w = place(sheet.rng)
    ratio = sheet.rng.choice([0.3, 0.7, 1.0])
    sheet.space.add_ellipse((x, y), (w, w / 3), ratio, dxfattribs=LAYER)


@feature
def ellipse_arc(sheet: Sheet) -> None:
    x, y, w = place(sheet.rng)
    begin, end = sheet.rng.choice([(0.3, 2.5), (4.0, 1.0), (0.0, math.pi)])
    arc = sheet.space.add_ellipse((x, y), (w, 5), 0.5, begin, end, dxfattribs=LAYER)
    sheet.space.add_line(arc.start_point, arc.end_point, dxfattribs=LAYER)


@feature
def arc_and_chord(sheet: Sheet) -> None:
    x, y, w = place(sheet.rng)
    begin, end = sheet.rng.choice([(10, 200), (300, 100), (-90, 90), (350, 710)])
    arc = sheet.space.add_arc((x, y), w, begin, end, dxfattribs=LAYER)
    if abs(end - begin) != 360:
        sheet.space.add_line(arc.start_point, arc.end_point, dxfattribs=LAYER)


@feature
def spline_control(sheet: Sheet) -> None:
    points = [(10, 10), (50, -5), (80, 30), (60, 70), (10, 60), (10, 10)]
    degree = sheet.rng.choice([2, 3, 4])
    sheet.space.add_open_spline(points, degree=degree, dxfattribs=LAYER)


@feature
def spline_rational(sheet: Sheet) -> None:
    points = [(10, 10), (50, -5), (80, 30), (60, 70), (10, 60), (10, 10)]
    weights = [1, sheet.rng.choice([0.5, 3]), 1, 2, 1, 1]
    sheet.space.add_rational_spline(points, weights, degree=3, dxfattribs=LAYER)


@feature
def spline_closed(sheet: Sheet) -> None:
    points = [(10, 10), (50, -5), (80, 30), (60, 70), (10, 60)]
    if sheet.rng.random() < 0.5:
        spline = sheet.space.add_spline(dxfattribs=LAYER)
        spline.apply_construction_tool(closed_uniform_bspline(points, order=4))
    else:
        spline = sheet.space.add_open_spline([*points, points[0]], dxfattribs=LAYER)
        spline.closed = True


@feature
def spline_fit(sheet: Sheet) -> None:
    points = [(10, 10), (50, 5), (80, 30), (60, 70), (10, 60), (10, 10)]
    if sheet.rng.random() < 0.5:
        sheet.space.add_spline(points, dxfattribs=LAYER)
    else:
        sheet.space.add_spline_control_frame(points, dxfattribs=LAYER)


@feature
def helix(sheet: Sheet) -> None:
    sheet.space.add_helix(20, 10, 1, dxfattribs=LAYER)
    seen(sheet)
    sheet.hints["told"] = True


# ---- polylines --------------------------------------------------------------------------------


@feature
def lwpolyline(sheet: Sheet) -> None:
    x, y, w = place(sheet.rng)
    points = square(x, y, w)
    if sheet.rng.random() < 0.5:
        outline(sheet, points)
    else:
        sheet.space.add_lwpolyline([*points, points[0]], dxfattribs=LAYER)


@feature
def lwpolyline_bulges(sheet: Sheet) -> None:
    x, y, w = place(sheet.rng)
    bulge = sheet.rng.choice([1.0, -0.5, 0.4142135623730951, 0.1])
    points = [(x, y, bulge), (x + w, y, 0), (x + w, y + w, -0.2), (x, y + w, 0)]
    sheet.space.add_lwpolyline(points, format="xyb", close=True, dxfattribs=LAYER)


@feature
def lwpolyline_circle(sheet: Sheet) -> None:
    points = [(20, 40, 1), (60, 40, 1)]
    sheet.space.add_lwpolyline(points, format="xyb", close=True, dxfattribs=LAYER)


@feature
def lwpolyline_width(sheet: Sheet) -> None:
    """A wall as an open polyline of constant width."""
    width = sheet.rng.choice([4, 10])
    points = sheet.rng.choice([[(10, 10), (80, 10)], [(10, 10), (80, 10), (80, 70)]])
    more = {**LAYER, "const_width": width}
    sheet.space.add_lwpolyline(points, dxfattribs=more)


@feature
def lwpolyline_width_closed(sheet: Sheet) -> None:
    outline(sheet, square(20, 20, 40), const_width=sheet.rng.choice([4, 10]))
    sheet.hints["inside"] = square(20, 20, 40)


@feature
def lwpolyline_width_taper(sheet: Sheet) -> None:
    points = [(10, 10, 2, 12), (80, 20, 12, 12), (70, 80, 0, 0)]
    sheet.space.add_lwpolyline(points, format="xyse", dxfattribs=LAYER)


@feature
def donut(sheet: Sheet) -> None:
    """AutoCAD's DONUT: two half circles of a width."""
    points = [(30, 50, 12, 12, 1), (70, 50, 12, 12, 1)]
    sheet.space.add_lwpolyline(points, format="xyseb", close=True, dxfattribs=LAYER)
    turns = [math.tau * k / 720 for k in range(720)]
    sheet.hints["inside"] = [(50 + 20 * math.cos(t), 50 + 20 * math.sin(t)) for t in turns]


@feature
def polyline_2d(sheet: Sheet) -> None:
    x, y, w = place(sheet.rng)
    points = [(x, y, 0.3), (x + w, y, 0), (x + w, y + w, -0.2), (x, y + w, 0)]
    sheet.space.add_polyline2d(points, format="xyb", close=True, dxfattribs=LAYER)


@feature
def polyline_2d_width(sheet: Sheet) -> None:
    more = {**LAYER, "default_start_width": 8, "default_end_width": 8}
    sheet.space.add_polyline2d([(10, 10), (80, 10), (80, 70)], dxfattribs=more)


@feature
def polyline_3d(sheet: Sheet) -> None:
    x, y, w = place(sheet.rng)
    points = [(px, py, sheet.rng.choice([0, 7])) for px, py in square(x, y, w)]
    sheet.space.add_polyline3d(points, close=True, dxfattribs=LAYER)


@feature
def polyline_curve_fit(sheet: Sheet) -> None:
    """Fitted vertices lie between those of the frame."""
    line = sheet.space.add_polyline2d([], close=True, dxfattribs={**LAYER, "flags": 3})
    for x, y, flags in [(10, 10, 0), (50, 0, 1), (80, 20, 0), (70, 60, 1), (20, 70, 0)]:
        line.append_vertex((x, y), dxfattribs={"flags": flags, "bulge": 0.2})


@feature
def polyline_spline_fit(sheet: Sheet) -> None:
    """The vertices of the control frame (flag 16) are stored beside those of the curve (8)."""
    closed = sheet.rng.random() < 0.5
    if closed:
        frame = square(5, 5, 80)
        turns = [k / 8 * math.tau for k in range(8)]
        curve = [(45 + 30 * math.cos(t), 45 + 30 * math.sin(t)) for t in turns]
    else:
        frame = [(30, 10), (30, 80), (50, 80), (50, 10)]
        curve = [(30, 10), (34, 45), (40, 50), (46, 45), (50, 10)]
        sheet.space.add_line(frame[0], frame[-1], dxfattribs=LAYER)
    flags = {**LAYER, "flags": 5 if closed else 4}
    line = sheet.space.add_polyline2d([], close=closed, dxfattribs=flags)
    for kind, points in ((16, frame), (8, curve)):
        for p in points:
            line.append_vertex(p, dxfattribs={"flags": kind})


@feature
def polyline_mesh(sheet: Sheet) -> None:
    mesh = sheet.space.add_polymesh((2, 2), dxfattribs=LAYER)
    for i, j in ((0, 0), (0, 1), (1, 0), (1, 1)):
        mesh.set_mesh_vertex((i, j), (10 + 40 * i, 10 + 40 * j, 0))


# ---- filled things ----------------------------------------------------------------------------


@feature
def solid(sheet: Sheet) -> None:
    """The corners of a SOLID go like a bow tie."""
    a, b, c, d = square(*place(sheet.rng))
    corners = sheet.rng.choice([[a, b, d, c], [a, b, c, c], [a, b, c]])
    add = sheet.rng.choice([sheet.space.add_solid, sheet.space.add_trace])
    add(corners, dxfattribs=LAYER)


@feature
def face_3d(sheet: Sheet) -> None:
    sheet.space.add_3dface(square(*place(sheet.rng)), dxfattribs=LAYER)


def _hatch(sheet: Sheet) -> Any:
    hatch = sheet.space.add_hatch(color=7, dxfattribs=LAYER)
    seen(sheet)
    if sheet.rng.random() < 0.3:
        hatch.set_pattern_fill("ANSI31", scale=0.5)
    return hatch


@feature
def hatch_polyline(sheet: Sheet) -> None:
    _hatch(sheet).paths.add_polyline_path(square(*place(sheet.rng)), is_closed=True)


@feature
def hatch_bulge(sheet: Sheet) -> None:
    points = [(20, 20, 1), (60, 20, 0), (60, 60, 0.4), (20, 60, 0)]
    _hatch(sheet).paths.add_polyline_path(points, is_closed=True)


@feature
def hatch_edges(sheet: Sheet) -> None:
    path = _hatch(sheet).paths.add_edge_path()
    path.add_line((20, 20), (70, 20))
    path.add_arc((70, 40), 20, -90, 90)
    path.add_line((70, 60), (20, 60))
    path.add_ellipse((20, 40), (0, 20), 0.5, 0, 180)


@feature
def hatch_spline_edge(sheet: Sheet) -> None:
    path = _hatch(sheet).paths.add_edge_path()
    path.add_line((20, 20), (70, 20))
    knots = [0, 0, 0, 0, 1, 1, 1, 1]
    path.add_spline(control_points=[(70, 20), (90, 80), (10, 90), (20, 20)], knot_values=knots)


@feature
def hatch_hole(sheet: Sheet) -> None:
    hatch = _hatch(sheet)
    hatch.paths.add_polyline_path(square(5, 5, 70), is_closed=True, flags=1)
    hatch.paths.add_polyline_path(square(20, 20, 30), is_closed=True, flags=16)


@feature
def hatch_islands(sheet: Sheet) -> None:
    hatch = _hatch(sheet)
    hatch.dxf.hatch_style = sheet.rng.choice([0, 1, 2])
    hatch.paths.add_polyline_path(square(5, 5, 80), is_closed=True, flags=1)
    hatch.paths.add_polyline_path(square(15, 15, 60), is_closed=True, flags=16)
    hatch.paths.add_polyline_path(square(25, 25, 30), is_closed=True, flags=0)


@feature
def hatch_in_outline(sheet: Sheet) -> None:
    points = square(*place(sheet.rng))
    outline(sheet, points)
    _hatch(sheet).paths.add_polyline_path(points, is_closed=True)


@feature
def hatch_beside_outline(sheet: Sheet) -> None:
    outline(sheet, square(5, 5, 20))
    _hatch(sheet).paths.add_polyline_path(square(50, 50, 30), is_closed=True)


@feature
def mpolygon(sheet: Sheet) -> None:
    polygon = sheet.space.add_mpolygon(color=7, fill_color=1, dxfattribs=LAYER)
    polygon.paths.add_polyline_path(square(*place(sheet.rng)), is_closed=True)


# ---- blocks -----------------------------------------------------------------------------------


def _block(sheet: Sheet, name: str = "B", layer: str = "0") -> Any:
    block = sheet.document.blocks.new(name)
    more = {"layer": layer}
    block.add_lwpolyline([(0, 0), (12, 0), (12, 6), (0, 9)], close=True, dxfattribs=more)
    return block


@feature
def insert(sheet: Sheet) -> None:
    _block(sheet, layer=sheet.rng.choice(["0", "obstacle"]))
    sheet.space.add_blockref("B", (sheet.rng.randint(0, 50), 20), dxfattribs=LAYER)


@feature
def insert_transformed(sheet: Sheet) -> None:
    _block(sheet)
    sx, sy = sheet.rng.choice([(2, 2), (-2, 2), (2, -1), (3, 1), (-1, -1)])
    turn = sheet.rng.choice([0, 30, 90, 200])
    more = {**LAYER, "xscale": sx, "yscale": sy, "rotation": turn}
    sheet.space.add_blockref("B", (50, 50), dxfattribs=more)


@feature
def insert_curves(sheet: Sheet) -> None:
    block = sheet.document.blocks.new("B")
    block.add_circle((5, 5), 5)
    block.add_lwpolyline([(20, 0, 1), (30, 0, 0.3)], format="xyb", close=True)
    sx, sy = sheet.rng.choice([(2, 2), (-2, 2), (2, 1), (-1, 2)])
    more = {**LAYER, "xscale": sx, "yscale": sy, "rotation": 25}
    sheet.space.add_blockref("B", (50, 50), dxfattribs=more)


@feature
def insert_array(sheet: Sheet) -> None:
    _block(sheet)
    more = {
        **LAYER,
        "row_count": sheet.rng.randint(1, 3),
        "column_count": sheet.rng.randint(2, 4),
        "row_spacing": sheet.rng.choice([12, 20, -15]),
        "column_spacing": sheet.rng.choice([16, 20, -18]),
        "rotation": sheet.rng.choice([0, 0, 30]),
        "xscale": sheet.rng.choice([1, 1, 0.5]),
    }
    sheet.space.add_blockref("B", (40, 40), dxfattribs=more)


@feature
def insert_nested(sheet: Sheet) -> None:
    """ezdxf cannot skew a turned block in a stretched one; test_dxf.py has that case."""
    _block(sheet)
    outer = sheet.document.blocks.new("C")
    outer.add_blockref("B", (0, 0))
    turn, stretch = sheet.rng.choice([(45, 2), (0, 1.5)])
    outer.add_blockref("B", (20, 0), dxfattribs={"rotation": turn, "yscale": -1})
    sheet.space.add_blockref("C", (40, 40), dxfattribs={**LAYER, "xscale": 2, "yscale": stretch})


@feature
def insert_nested_array(sheet: Sheet) -> None:
    _block(sheet)
    outer = sheet.document.blocks.new("C")
    outer.add_blockref("B", (0, 0), dxfattribs={"column_count": 3, "column_spacing": 15})
    sheet.space.add_blockref("C", (30, 40), dxfattribs={**LAYER, "rotation": 20})


@feature
def insert_base_point(sheet: Sheet) -> None:
    block = sheet.document.blocks.new("B", base_point=(10, 5))
    block.add_lwpolyline([(10, 5), (30, 5), (30, 25)], close=True)
    sheet.space.add_blockref("B", (40, 40), dxfattribs={**LAYER, "rotation": 30, "xscale": 2})


@feature
def insert_from_below(sheet: Sheet) -> None:
    _block(sheet)
    sheet.space.add_blockref("B", (-40, 40), dxfattribs={**LAYER, "extrusion": (0, 0, -1)})


@feature
def insert_layers(sheet: Sheet) -> None:
    """Entities of a block on layers of their own keep them."""
    sheet.document.layers.add("other")
    block = _block(sheet)
    block.add_circle((30, 5), 5, dxfattribs={"layer": "other"})
    block.add_circle((45, 5), 5, dxfattribs=LAYER)
    sheet.space.add_blockref(
        "B", (10, 10), dxfattribs={"layer": sheet.rng.choice(["obstacle", "other"])}
    )
    seen(sheet)


@feature
def insert_clipped(sheet: Sheet) -> None:
    """XCLIP shows part of a block."""
    _block(sheet)
    reference = sheet.space.add_blockref(
        "B", (20, 20), dxfattribs={**LAYER, "xscale": 4, "yscale": 4}
    )
    from ezdxf.xclip import XClip

    XClip(reference).set_wcs_clipping_path([(25, 22), (45, 30)])
    seen(sheet)


@feature
def insert_missing(sheet: Sheet) -> None:
    sheet.space.add_blockref("NONE", (20, 20), dxfattribs=LAYER)
    seen(sheet)


@feature
def insert_hatch(sheet: Sheet) -> None:
    block = sheet.document.blocks.new("B")
    block.add_hatch(color=7).paths.add_polyline_path(square(0, 0, 20), is_closed=True)
    sheet.space.add_blockref("B", (20, 20), dxfattribs={**LAYER, "rotation": 30})
    seen(sheet)


# ---- what is not seen -------------------------------------------------------------------------


def _unseen(sheet: Sheet, **more: Any) -> None:
    x, y, w = place(sheet.rng)
    outline(sheet, square(x, y, w / 2), **more)
    seen(sheet)
    sheet.must_say = SEEN


def _layer(sheet: Sheet) -> Any:
    return sheet.document.layers.add("obstacle_2")


@feature
def layer_off(sheet: Sheet) -> None:
    _layer(sheet).off()
    _unseen(sheet, layer="obstacle_2")


@feature
def layer_frozen(sheet: Sheet) -> None:
    _layer(sheet).freeze()
    _unseen(sheet, layer="obstacle_2")


@feature
def layer_not_plotted(sheet: Sheet) -> None:
    """A viewer shows what is not plotted; so it counts."""
    _layer(sheet).dxf.plot = 0
    x, y, w = place(sheet.rng)
    outline(sheet, square(x, y, w / 2), layer="obstacle_2")


@feature
def invisible(sheet: Sheet) -> None:
    _unseen(sheet, invisible=1)


@feature
def paper_space(sheet: Sheet) -> None:
    sheet.document.layout("Layout1").add_lwpolyline(square(5, 5, 40), close=True, dxfattribs=LAYER)
    seen(sheet)


@feature
def insert_on_frozen_layer(sheet: Sheet) -> None:
    """All of an insertion on a frozen layer is hidden, whatever its entities' layers."""
    _layer(sheet).freeze()
    _block(sheet, layer="obstacle")
    sheet.space.add_blockref("B", (10, 10), dxfattribs={"layer": "obstacle_2", "xscale": 2})
    seen(sheet)
    sheet.must_say = SEEN


@feature
def insert_of_frozen_entities(sheet: Sheet) -> None:
    _layer(sheet).freeze()
    _block(sheet, layer="obstacle_2")
    sheet.space.add_blockref("B", (10, 10), dxfattribs={**LAYER, "xscale": 2})
    seen(sheet)
    sheet.must_say = SEEN


@feature
def insert_invisible(sheet: Sheet) -> None:
    _block(sheet)
    sheet.space.add_blockref("B", (10, 10), dxfattribs={**LAYER, "xscale": 2, "invisible": 1})
    seen(sheet)
    sheet.must_say = SEEN


# ---- coordinate systems, units, the rest ------------------------------------------------------


@feature
def from_below(sheet: Sheet) -> None:
    more = {**LAYER, "extrusion": (0, 0, -1)}
    kind = sheet.rng.randint(0, 5)
    space = sheet.space
    if kind == 0:
        space.add_lwpolyline(
            [(-50, 10, 0.5), (-20, 10, 0), (-20, 40, 0)], format="xyb", close=True, dxfattribs=more
        )
    elif kind == 1:
        space.add_circle((-50, 50), 20, dxfattribs=more)
    elif kind == 2:
        arc = space.add_arc((-50, 50), 30, 20, 150, dxfattribs=more)
        space.add_line(arc.start_point, arc.end_point, dxfattribs=LAYER)
    elif kind == 3:
        arc = space.add_ellipse((50, 50), (30, 10), 0.5, 0.5, 3, dxfattribs=more)
        space.add_line(arc.start_point, arc.end_point, dxfattribs=LAYER)
    elif kind == 4:
        space.add_polyline2d(
            [(-50, 10, 0.5), (-20, 10, 0), (-20, 40, 0)], format="xyb", close=True, dxfattribs=more
        )
    else:
        space.add_solid([(-50, 10), (-20, 10), (-50, 40), (-20, 40)], dxfattribs=more)


@feature
def tilted(sheet: Sheet) -> None:
    more = {**LAYER, "extrusion": sheet.rng.choice([(0, 1, 1), (1, 0, 0), (0.3, 0, 1)])}
    sheet.space.add_lwpolyline(square(10, 10, 40), close=True, dxfattribs=more)


@feature
def elevation(sheet: Sheet) -> None:
    outline(sheet, square(*place(sheet.rng)), elevation=sheet.rng.choice([5, -100]))


@feature
def thickness(sheet: Sheet) -> None:
    outline(sheet, square(*place(sheet.rng)), thickness=10)


@feature
def insunits(sheet: Sheet) -> None:
    sheet.document.header["$INSUNITS"] = sheet.rng.choice([1, 4, 6])
    outline(sheet, square(*place(sheet.rng)))
    sheet.must_say = r"unit|INSUNITS|inch|mm|millimet|metre|meter"


@feature
def text_and_points(sheet: Sheet) -> None:
    """Text and dimensions are no walls."""
    outline(sheet, square(*place(sheet.rng)))
    sheet.space.add_text("A", height=5, dxfattribs={**LAYER, "insert": (90, 90)})
    sheet.space.add_mtext("B", dxfattribs={**LAYER, "insert": (90, 80)})
    sheet.space.add_point((95, 95), dxfattribs=LAYER)


@feature
def points_only(sheet: Sheet) -> None:
    sheet.space.add_point((95, 95), dxfattribs=LAYER)
    seen(sheet)


@feature
def mline(sheet: Sheet) -> None:
    """A multiline: the usual wall of a floor plan, two parallel lines."""
    sheet.space.add_mline([(10, 10), (80, 10)], dxfattribs={**LAYER, "scale_factor": 8})
    seen(sheet)
    sheet.hints["told"] = True


@feature
def endless_lines(sheet: Sheet) -> None:
    add = sheet.rng.choice([sheet.space.add_xline, sheet.space.add_ray])
    add((10, 10), (1, 0), dxfattribs=LAYER)
    seen(sheet)
    sheet.hints["told"] = True


@feature
def wipeout(sheet: Sheet) -> None:
    sheet.space.add_wipeout([(10, 10), (60, 60)]).dxf.layer = "obstacle"
    seen(sheet)
    sheet.hints["told"] = True


@feature
def mesh(sheet: Sheet) -> None:
    entity = sheet.space.add_mesh(dxfattribs=LAYER)
    with entity.edit_data() as data:
        data.vertices = [(x, y, 0) for x, y in square(10, 10, 40)]
        data.faces = [[0, 1, 2, 3]]
    seen(sheet)


@feature
def upper_case_layer(sheet: Sheet) -> None:
    sheet.document.layers.add("OBSTACLES-1")
    outline(sheet, square(*place(sheet.rng)), layer="OBSTACLES-1")


@feature
def other_layers(sheet: Sheet) -> None:
    sheet.document.layers.add("walls")
    outline(sheet, square(5, 5, 20), layer="walls")
    seen(sheet)
