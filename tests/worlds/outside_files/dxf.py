"""DXF drawings made with ezdxf."""

from __future__ import annotations

import io
from collections.abc import Callable
from typing import Any

from ezdxf.document import Drawing

Draw = Callable[[Any], object]


def dxf(*draw: Draw, ends: bool = True) -> str:
    document = Drawing.new("R2000")
    space = document.modelspace()
    if ends:
        box(space, "robot", -1, -1, 1, 1)
        space.add_point((10, 5), dxfattribs={"layer": "start"})
        space.add_line((30, 5), (30, 9), dxfattribs={"layer": "goal"})
    for step in draw:
        step(space)
    stream = io.StringIO()
    document.write(stream)
    return stream.getvalue()


def box(space: Any, layer: str, *corners: float) -> None:
    x0, y0, x1, y1 = corners
    points = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
    space.add_lwpolyline(points, close=True, dxfattribs={"layer": layer})
