"""The writer of DXF, with layers as `planar_planner.formats.readers.dxf` reads them."""

from __future__ import annotations

import io
import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from planar_planner.errors import SceneError
from planar_planner.formats.parts import Parts, Point, Ring, Shape
from planar_planner.formats.reading import require
from planar_planner.scene.fields import Box


def write(parts: Parts, path: Path) -> Mapping[Path, bytes]:
    """Return a drawing of closed polylines; the robot's origin is at the drawing's origin.

    Start and goal are lines from the reference point along θ, so reading gives a rounded θ. Each
    obstacle has a layer of its own, since outlines inside each other on one layer are holes.

    Raises
    ------
    SceneError
        If the scene forbids turning, which DXF cannot state.
    """
    if not parts.rotation:
        raise SceneError("a drawing cannot forbid turning", "rotation")
    ezdxf: Any = require("ezdxf", "writing DXF", "dxf")
    document = ezdxf.new("R2000", setup=False)
    document.header["$INSUNITS"] = 0  # a scene's unit has no name
    space = document.modelspace()

    def draw(layer: str, ring: Ring) -> None:
        space.add_lwpolyline(ring, close=True, dxfattribs={"layer": layer})

    shapes: list[tuple[str, Shape]] = [
        (f"robot{k}", shape) for k, shape in enumerate(parts.robot or [])
    ]
    shapes += [(f"obstacle{k}", shape) for k, shape in enumerate(parts.obstacles)]
    if parts.workspace is not None:
        shapes.append(("workspace", parts.workspace))
    for role, box in (
        ("workspace", parts.workspace_box),
        ("reference_bounds", parts.reference_bounds),
    ):
        if box is not None:
            shapes.append((role, [_corners(box)]))
    for layer, shape in shapes:
        for ring in shape:
            draw(layer, ring)
    space.add_point((0, 0), dxfattribs={"layer": "origin"})
    reach = max(math.hypot(*p) for shape in parts.robot or [] for p in shape[0])
    for layer, q in (("start", parts.start), ("goal", parts.goal)):
        if q is not None:
            tip = (q[0] + reach * math.cos(q[2]), q[1] + reach * math.sin(q[2]))
            space.add_line(q[:2], tip, dxfattribs={"layer": layer})
    stream = io.StringIO()
    document.write(stream)
    return {path: stream.getvalue().encode()}


def _corners(box: Box) -> list[Point]:
    return [(box[0], box[1]), (box[2], box[1]), (box[2], box[3]), (box[0], box[3])]
