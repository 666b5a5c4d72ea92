"""The writer of SVG, with y downwards; `planar_planner.formats.readers.svg` reads it exactly."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from pathlib import Path
from xml.sax.saxutils import escape, quoteattr

from planar_planner.formats.parts import Parts, Point, Shape
from planar_planner.scene.fields import Box

_STYLE = {  # colours that readers distinguish without red and green (Wong 2011)
    "workspace": "fill:none;stroke:#000000",
    "reference_bounds": "fill:none;stroke:#999999",
    "obstacle": "fill:#999999;fill-rule:evenodd",
    "robot": "fill:#0072b2;fill-opacity:0.5;fill-rule:evenodd",
    "start": "stroke:#009e73",
    "goal": "stroke:#d55e00",
}


def write(parts: Parts, path: Path) -> Mapping[Path, bytes]:
    """Return a drawing; the origin of the robot's frame is at the drawing's origin."""
    lines = list(_elements(parts))
    xmin, ymin, xmax, ymax = _frame(parts)
    width = max(xmax - xmin, ymax - ymin) / 500
    rotation = "" if parts.rotation else ' data-rotation="false"'
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{xmin!r} {-ymax!r} '
        f'{xmax - xmin!r} {ymax - ymin!r}" stroke-width="{width!r}"{rotation}>'
    )
    texts = [
        f"<{tag}>{escape(text)}</{tag}>"
        for tag, text in (("title", parts.name), ("desc", parts.description))
        if text
    ]
    return {path: "\n".join([head, *texts, *lines, "</svg>\n"]).encode()}


def _elements(parts: Parts) -> Iterator[str]:
    for role, box in (
        ("workspace", parts.workspace_box),
        ("reference_bounds", parts.reference_bounds),
    ):
        if box is not None:
            yield _path(role, role, [_corners(box)])
    if parts.workspace is not None:
        yield _path("workspace", "workspace", parts.workspace)
    for k, shape in enumerate(parts.obstacles):
        yield _path(f"obstacle{k}", "obstacle", shape)
    for k, shape in enumerate(parts.robot or []):
        yield _path(f"robot{k}", "robot", shape)
    yield '<circle id="origin" cx="0" cy="0" r="0"/>'
    reach = max(math.hypot(*p) for shape in parts.robot or [] for p in shape[0])
    for role, q in (("start", parts.start), ("goal", parts.goal)):
        if q is not None:
            tip = (q[0] + reach * math.cos(q[2]), q[1] + reach * math.sin(q[2]))
            yield (
                f'<line id="{role}" style="{_STYLE[role]}" data-theta="{q[2]!r}" '
                f'x1="{q[0]!r}" y1="{-q[1]!r}" x2="{tip[0]!r}" y2="{-tip[1]!r}"/>'
            )


def _path(name: str, role: str, shape: Shape) -> str:
    data = " ".join("M " + " L ".join(f"{x!r} {-y!r}" for x, y in ring) + " Z" for ring in shape)
    return f'<path id={quoteattr(name)} style="{_STYLE[role]}" d="{data}"/>'


def _corners(box: Box) -> list[Point]:
    return [(box[0], box[1]), (box[2], box[1]), (box[2], box[3]), (box[0], box[3])]


def _frame(parts: Parts) -> Box:
    """Return a box round everything."""
    points: list[Point] = [(0.0, 0.0)]
    for shape in [*parts.obstacles, *(parts.robot or []), *filter(None, [parts.workspace])]:
        points += shape[0]
    for box in (parts.workspace_box, parts.reference_bounds):
        points += _corners(box) if box is not None else []
    points += [q[:2] for q in (parts.start, parts.goal) if q is not None]
    xs, ys = zip(*points, strict=True)
    return min(xs), min(ys), max(xs), max(ys)
