"""Pictures of scenes and results, by matplotlib; they decide nothing.

The module exports the public functions of this folder, in which each picture has a file of its own.
"""

from __future__ import annotations

from planar_planner.pictures.filmstrip import draw_filmstrip
from planar_planner.pictures.margin import draw_margin
from planar_planner.pictures.pinch import draw_wall
from planar_planner.pictures.shapes import placed, polygon_paths
from planar_planner.pictures.slices import draw_slices
from planar_planner.pictures.space import draw_space
from planar_planner.pictures.style import (
    BOUNDS,
    GOAL,
    INK,
    MIDWAY,
    OBSTACLE,
    OUTSIDE,
    START,
    TRACE,
    fade,
    save_picture,
)
from planar_planner.pictures.swept import draw_scene
from planar_planner.pictures.world import draw_ends, draw_world, frame_axes, title_of, view_box

__all__ = [
    "BOUNDS",
    "GOAL",
    "INK",
    "MIDWAY",
    "OBSTACLE",
    "OUTSIDE",
    "START",
    "TRACE",
    "draw_ends",
    "draw_filmstrip",
    "draw_margin",
    "draw_scene",
    "draw_slices",
    "draw_space",
    "draw_wall",
    "draw_world",
    "fade",
    "frame_axes",
    "placed",
    "polygon_paths",
    "save_picture",
    "title_of",
    "view_box",
]
