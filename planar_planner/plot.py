"""Pictures of scenes and results, by matplotlib. They decide nothing.

The public side of `planar_planner.pictures`, where each picture has a file of its own.
"""

from __future__ import annotations

from planar_planner.pictures.shapes import placed, polygon_paths
from planar_planner.pictures.style import INK, MIDWAY, TRACE, fade, save_picture
from planar_planner.pictures.swept import draw_scene
from planar_planner.pictures.world import draw_ends, draw_world, frame_axes, title_of, view_box

__all__ = [
    "INK",
    "MIDWAY",
    "TRACE",
    "draw_ends",
    "draw_scene",
    "draw_world",
    "fade",
    "frame_axes",
    "placed",
    "polygon_paths",
    "save_picture",
    "title_of",
    "view_box",
]
