"""Meshes of OMPL.app problems: closed prisms over boxes."""

from __future__ import annotations

Box = tuple[float, float, float, float]
IDENTITY = "1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1"


def dae(
    boxes: list[Box],
    axis: str = "Z_UP",
    node: str = f"<matrix>{IDENTITY}</matrix>",
    thick: float = 1.0,
) -> str:
    """Return closed prisms over boxes in the plane of (x, z), as Z_UP files of OMPL.app have it."""
    points: list[tuple[float, float, float]] = []
    triangles: list[tuple[int, int, int]] = []
    for xmin, ymin, xmax, ymax in boxes:
        at = len(points)
        corners = [(xmin, ymin), (xmax, ymin), (xmax, ymax), (xmin, ymax)]
        for side in (0.0, thick):
            points += [(x, side, y) if axis == "Z_UP" else (x, y, side) for x, y in corners]
        triangles += [(at, at + 1, at + 2), (at, at + 2, at + 3)]
        triangles += [(at + 4, at + 5, at + 6), (at + 4, at + 6, at + 7)]
        for k in range(4):
            a, b = at + k, at + (k + 1) % 4
            triangles += [(a, b, b + 4), (a, b + 4, a + 4)]
    numbers = " ".join(repr(v) for p in points for v in p)
    indices = " ".join(str(i) for t in triangles for i in t)
    return f"""<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><up_axis>{axis}</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="s"><float_array id="a" count="{3 * len(points)}">{numbers}</float_array>
<technique_common><accessor count="{len(points)}" source="#a" stride="3"/></technique_common>
</source>
<vertices id="v"><input semantic="POSITION" source="#s"/></vertices>
<triangles count="{len(triangles)}"><input offset="0" semantic="VERTEX" source="#v"/>
<p>{indices}</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="w"><node id="n">{node}
<instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#w"/></scene></COLLADA>
"""


WALLS: list[Box] = [(-1.0, -10.5, 1.0, -0.75), (-1.0, 0.75, 1.0, 10.5)]
