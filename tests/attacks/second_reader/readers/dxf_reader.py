"""DXF a second time: what ezdxf's drawing add-on shows, filled by shapely.

The add-on resolves blocks, layers, visibility, widths, hatches and clips. Closed outlines stand for
their inside; smaller ones inside larger ones alternate between hole and material, and outlines
that cross are united. Loose lines are noded and polygonised.
"""

from __future__ import annotations

import io
from collections import defaultdict
from collections.abc import Iterable, Sequence
from typing import Any

import ezdxf
import shapely
from ezdxf.addons.drawing import Frontend, RenderContext
from ezdxf.addons.drawing.backend import Backend, BkPath2d, BkPoints2d
from ezdxf.addons.drawing.config import (
    Configuration,
    HatchPolicy,
    LineweightPolicy,
    ProxyGraphicPolicy,
    TextPolicy,
)
from ezdxf.addons.drawing.properties import BackendProperties
from ezdxf.math import Vec2

from ..judge import UnreadableError
from ..model import Drawing, Exact, Reading, Region

FLAT = 0.002
"""Farthest that flattened curves are from themselves, in drawing units."""
SNAP = 1e-6
"""Ends this close are one; gaps are wider or are read as joined."""
SLACK = 0.1
"""The importer's tolerance of 0.02, `FLAT`, and the arcs' chords at widths."""

Line = list[tuple[float, float]]


class _Shown(Backend):
    """Collects lines and filled areas by layer."""

    def __init__(self) -> None:
        super().__init__()
        self.lines: dict[str, list[Line]] = defaultdict(list)
        self.areas: dict[str, list[Region]] = defaultdict(list)

    def set_background(self, color: str) -> None:
        pass

    def clear(self) -> None:
        pass

    def finalize(self) -> None:
        pass

    def draw_point(self, pos: Vec2, properties: BackendProperties) -> None:
        pass

    def draw_line(self, start: Vec2, end: Vec2, properties: BackendProperties) -> None:
        self.lines[properties.layer].append([(start.x, start.y), (end.x, end.y)])

    def draw_solid_lines(
        self, lines: Iterable[tuple[Vec2, Vec2]], properties: BackendProperties
    ) -> None:
        for start, end in lines:
            self.draw_line(start, end, properties)

    def draw_path(self, path: BkPath2d, properties: BackendProperties) -> None:
        for points in _flat([path]):
            self.lines[properties.layer].append(points)

    def draw_filled_paths(self, paths: Iterable[BkPath2d], properties: BackendProperties) -> None:
        area = shapely.Polygon()
        for points in _flat(paths):
            if len(set(points)) >= 3:
                area = area.symmetric_difference(shapely.make_valid(shapely.Polygon(points)))
        self.areas[properties.layer].append(area)

    def draw_filled_polygon(self, points: BkPoints2d, properties: BackendProperties) -> None:
        corners = [(p.x, p.y) for p in points.vertices()]
        if len(set(corners)) >= 3:
            self.areas[properties.layer].append(shapely.make_valid(shapely.Polygon(corners)))

    def draw_image(self, image_data: Any, properties: BackendProperties) -> None:
        pass


def _flat(paths: Iterable[BkPath2d]) -> Iterable[Line]:
    for path in paths:
        for part in path.to_path().sub_paths():
            yield [(p.x, p.y) for p in part.flattening(FLAT)]


def read(drawing: Drawing) -> Sequence[Reading]:
    """Return what the drawing shows on the layers of obstacles."""
    try:
        shown = shown_by_layer(drawing.files[drawing.name])
    except ezdxf.DXFError as error:
        raise UnreadableError(f"ezdxf: {error}") from None
    region = shapely.union_all(
        [
            _filled(shown.lines[layer], shown.areas[layer])
            for layer in {*shown.lines, *shown.areas}
            if layer.lower().startswith("obstacle")
        ]
    )
    due = r"not read|left out|ignored|skipped" if drawing.hints.get("told") else ""
    readings = [Reading("as shown", Exact(region, SLACK), due)]
    if "inside" in drawing.hints:
        whole = region.union(shapely.Polygon(drawing.hints["inside"]))
        readings.append(Reading("with its inside", Exact(whole, SLACK), "width|wide"))
    return readings


def shown_by_layer(data: bytes) -> _Shown:
    """Return what a file shows."""
    text = data.decode("utf-8-sig", errors="replace").replace("\r\n", "\n")
    document = ezdxf.read(io.StringIO(text))
    for line in document.entitydb.query("POLYLINE"):  # the add-on draws control frames too
        line.vertices[:] = [v for v in line.vertices if not v.dxf.get("flags", 0) & 16]
    shown = _Shown()
    config = Configuration(
        hatch_policy=HatchPolicy.SHOW_SOLID,
        text_policy=TextPolicy.IGNORE,
        lineweight_policy=LineweightPolicy.ABSOLUTE,
        proxy_graphic_policy=ProxyGraphicPolicy.SHOW,
        max_flattening_distance=FLAT,
        circle_approximation_count=720,
    )
    frontend = Frontend(RenderContext(document), shown, config)
    frontend.draw_layout(document.modelspace())
    return shown


def _filled(lines: Sequence[Line], areas: Sequence[Region]) -> Region:
    rings = [line for line in lines if _closed(line)]
    loose = [line for line in lines if not _closed(line)]
    shapes = [shapely.make_valid(shapely.Polygon(ring)) for ring in rings if len(set(ring)) >= 3]
    shapes += _polygonised(loose)
    return shapely.union_all([_alternating(shapes), *areas])


def _closed(line: Line) -> bool:
    (ax, ay), (bx, by) = line[0], line[-1]
    return len(line) > 2 and abs(ax - bx) <= SNAP and abs(ay - by) <= SNAP


def _polygonised(lines: Sequence[Line]) -> list[Region]:
    """Return what loose lines enclose; lines that hang together make one area without holes."""
    if not lines:
        return []
    snapped = [shapely.set_precision(shapely.LineString(line), SNAP) for line in lines]
    parts = shapely.get_parts(shapely.union_all([line for line in snapped if not line.is_empty]))
    found = []
    for group in _hanging_together(parts):
        faces = shapely.get_parts(shapely.polygonize(group))
        outer = shapely.union_all([shapely.Polygon(face.exterior) for face in faces])
        found += [part for part in shapely.get_parts(outer) if part.geom_type == "Polygon"]
    return found


def _hanging_together(parts: Any) -> list[list[Region]]:
    """Return the lines in groups that share points."""
    first, second = shapely.STRtree(parts).query(parts, predicate="intersects")
    group = list(range(len(parts)))

    def leader(i: int) -> int:
        while group[i] != i:
            i = group[i]
        return i

    for i, j in zip(first.tolist(), second.tolist(), strict=True):
        a, b = leader(i), leader(j)
        group[max(a, b)] = min(a, b)
    groups: dict[int, list[Region]] = defaultdict(list)
    for i, part in enumerate(parts):
        groups[leader(i)].append(part)
    return list(groups.values())


def _alternating(shapes: Sequence[Region]) -> Region:
    """Return the shapes' union, but every second one of those inside each other is a hole."""
    distinct: list[Region] = []
    for shape in sorted(shapes, key=lambda s: -s.area):
        if not any(shape.symmetric_difference(d).area <= SNAP * d.length for d in distinct):
            distinct.append(shape)
    region = shapely.Polygon()
    for k, shape in enumerate(distinct):
        depth = sum(other.buffer(SNAP).covers(shape) for other in distinct[:k])
        region = region.union(shape) if depth % 2 == 0 else region.difference(shape)
    return region
