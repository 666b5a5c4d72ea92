"""From drawings to parts: figures with roles, whose curves are flattened to the requested side.

Flattening ``outwards`` grows the obstacles and the robot and shrinks the workspace, so a path holds
for the curves too. Flattening ``inwards`` does the opposite, so a proof of no path does.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass, field

from planar_planner.errors import SceneError
from planar_planner.formats.outlines.curves import (
    SLACK,
    Outline,
    Piece,
    control_points,
    first_point,
    flattened,
    last_point,
)
from planar_planner.formats.outlines.exact import contains, is_anticlockwise, orientation
from planar_planner.formats.outlines.figure import EVENODD, Figure
from planar_planner.formats.outlines.rings import (
    MIN_RING,
    convex_ring,
    polygons_of,
    without_repeats,
)
from planar_planner.formats.parts import (
    INWARDS,
    OUTWARDS,
    ImportOptions,
    Notes,
    Parts,
    Point,
    Ring,
    Shape,
)
from planar_planner.scene.fields import Box, Configuration

DEFAULT_TOLERANCE = 1e-3
"""Default tolerance as a share of the drawing's larger extent; curves then take few edges."""


@dataclass
class Drawing:
    """A file's figures and marks by their roles."""

    figures: dict[str, list[Figure]] = field(default_factory=dict)
    marks: dict[str, Configuration] = field(default_factory=dict)
    rotation: bool = True

    def add(self, role: str, figure: Figure) -> None:
        """Add a figure."""
        self.figures.setdefault(role, []).append(figure)

    def mark(self, role: str, q: Configuration, place: str) -> None:
        """Set the start, the goal or the robot's origin."""
        if role in self.marks:
            raise SceneError(f"is a second mark for {role}", place)
        self.marks[role] = q


def parts_of(drawing: Drawing, options: ImportOptions, notes: Notes) -> Parts:
    """Return the parts of a drawing.

    Raises
    ------
    SceneError
        If outlines cross, come closer than the tolerance, or there are two workspaces.
    """
    flattener = _Flattener(drawing, options, notes)
    parts = Parts(rotation=drawing.rotation)
    for figure in drawing.figures.get("obstacle", []):
        parts.add_obstacles(flattener.shapes_of(figure, grow=True), figure.place)
    robot = flattener.shapes("robot", grow=True)
    if robot:
        parts.robot = _about_origin(robot, drawing.marks.get("origin"), notes)
    workspace = flattener.shapes("workspace", grow=False)
    if len(workspace) > 1:
        raise SceneError("the workspace must be one outline", "workspace", f"{len(workspace)}")
    if workspace:
        parts.workspace = workspace[0]
    bounds = flattener.shapes("reference_bounds", grow=False)
    if bounds:
        parts.reference_bounds = _rectangle(bounds)
    parts.start, parts.goal = drawing.marks.get("start"), drawing.marks.get("goal")
    if not (parts.obstacles or parts.robot or parts.workspace):
        raise SceneError(
            "nothing has a role; ids, classes, labels or layers must have the names robot, "
            "obstacle, workspace, start, goal, or --role must state their roles" + notes.names_met()
        )
    if flattener.met_curves:
        parts.holds_for = "path" if options.flatten == OUTWARDS else "no_path"
        moved = "grown" if options.flatten == OUTWARDS else "shrunk"
        other = "shrunk" if options.flatten == OUTWARDS else "grown"
        notes.say(
            f"curves are flattened {options.flatten} within {flattener.tolerance!r}: obstacles and "
            f"robot {moved}, workspace {other}"
        )
    return parts


def _about_origin(robot: list[Shape], origin: Configuration | None, notes: Notes) -> list[Shape]:
    """Move a robot so that its reference point is the origin."""
    if origin is not None:
        x0, y0 = origin[:2]
    else:
        xs, ys = zip(*(p for shape in robot for p in shape[0]), strict=True)
        x0, y0 = (min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2
        notes.say(
            "the drawing has no mark for the robot's origin: its reference point is the middle of "
            f"its bounding box, ({x0!r}, {y0!r})"
        )
    return [[[(x - x0, y - y0) for x, y in ring] for ring in shape] for shape in robot]


def _rectangle(shapes: list[Shape]) -> Box:
    points = {p for shape in shapes for ring in shape for p in ring}
    xs, ys = sorted({x for x, _ in points}), sorted({y for _, y in points})
    if len(points) != 4 or len(xs) != 2 or len(ys) != 2:
        raise SceneError("must be one axis-parallel rectangle", "reference_bounds")
    return xs[0], ys[0], xs[1], ys[1]


class _Flattener:
    """Turns figures into polygons, with one tolerance for the whole drawing."""

    def __init__(self, drawing: Drawing, options: ImportOptions, notes: Notes) -> None:
        self._figures = drawing.figures
        self._outwards = options.flatten != INWARDS
        self._notes = notes
        self.met_curves = False
        self.tolerance = options.tolerance or DEFAULT_TOLERANCE * self._extent()

    def _extent(self) -> float:
        points = [
            p
            for figures in self._figures.values()
            for figure in figures
            for outline in figure.outlines
            for p in control_points(outline)
        ]
        if not points:
            return 1.0
        xs, ys = zip(*points, strict=True)
        return max(max(xs) - min(xs), max(ys) - min(ys)) or 1.0

    def shapes(self, role: str, *, grow: bool) -> list[Shape]:
        """Return the polygons of all figures of a role."""
        figures = self._figures.get(role, [])
        return [shape for figure in figures for shape in self.shapes_of(figure, grow=grow)]

    def shapes_of(self, figure: Figure, *, grow: bool) -> list[Shape]:
        """Return the polygons of a figure."""
        try:
            return self._figure(figure, outwards=grow == self._outwards)
        except SceneError as error:
            raise SceneError(error.problem, error.field or figure.place, error.value) from None

    def _figure(self, figure: Figure, *, outwards: bool) -> list[Shape]:
        if not any(outline.curved for outline in figure.outlines):
            rings = [[first_point(p) for p in o.pieces] for o in figure.outlines]
            return polygons_of(rings, figure.place, self._notes, figure.rule)
        self.met_curves = True
        if len(figure.outlines) == 1 and len(figure.outlines[0].pieces) <= _FEW:
            ring = _convex_side(figure.outlines[0], self.tolerance, outwards=outwards)
            if ring is not None:
                return [[ring]]
        both = [_both_sides(outline, self.tolerance) for outline in figure.outlines]
        rings = []
        for k, (left, right) in enumerate(both):
            inside, outside = _material(k, both, figure.rule)
            if inside == outside:
                continue  # a ring with material on both sides, or on neither, bounds nothing
            material_left = inside == is_anticlockwise(left)
            rings.append(right if material_left == outwards else left)
        try:
            return polygons_of(rings, figure.place, self._notes, EVENODD)
        except SceneError as error:
            raise SceneError(
                f"{error.problem} when flattened; a smaller --tolerance may help", value=error.value
            ) from None


def _convex_side(outline: Outline, tolerance: float, *, outwards: bool) -> Ring | None:
    """Return an outline flattened to one side if the polygon plainly is convex, otherwise None.

    Which side is outside is read off the control points, and the polygon confirms it. Each piece
    of the outline lies in the hull of its control points, and so does the part of the polygon that
    stands for it, up to the slack. Let every hull be on one side of some line that passes a place
    at more than the slack. Moving the polygon to the outline piece by piece then never meets the
    place, so both go round it equally often: once, in the polygon's direction, if it is inside the
    convex polygon. Both sides then need not be flattened to see which is which.
    """
    points = control_points(outline)
    turn = 1 if _doubled_area(points) > 0 else -1
    place = _middle([first_point(piece) for piece in outline.pieces])
    far = 2 * SLACK * max(max(abs(x), abs(y)) for x, y in points)
    if not all(_passes(piece, place, turn, far) for piece in outline.pieces):
        return None
    side = -turn if outwards else turn
    ring = without_repeats(flattened(outline, side, tolerance))
    edges = zip(ring, [*ring[1:], *ring[:1]], strict=True)
    if convex_ring(ring) != turn or any(orientation(a, b, place) != turn for a, b in edges):
        return None
    return ring


_FEW = 16
"""Pieces up to which an outline is tried as a convex one."""


def _passes(piece: Piece, place: Point, turn: int, far: float) -> bool:
    """Return whether a line along the piece's chord leaves a place behind it by more than `far`."""
    (x0, y0), (x1, y1) = first_point(piece), last_point(piece)
    nx, ny = turn * (y1 - y0), turn * (x0 - x1)
    behind = far * (abs(nx) + abs(ny))
    x, y = place
    return all((px / w - x) * nx + (py / w - y) * ny > behind for px, py, w in piece)


def _middle(points: Sequence[Point]) -> Point:
    xs, ys = zip(*points, strict=True)
    return sum(xs) / len(xs), sum(ys) / len(ys)


def _doubled_area(ring: Sequence[Point]) -> float:
    """Return about twice the area, positive if anticlockwise."""
    x0, y0 = ring[0]
    offsets = [(x - x0, y - y0) for x, y in ring]
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in itertools.pairwise(offsets))


def _both_sides(outline: Outline, tolerance: float) -> tuple[Ring, Ring]:
    """Return an outline flattened to its left and to its right."""
    left, right = (without_repeats(flattened(outline, side, tolerance)) for side in (1, -1))
    if len(set(left)) < MIN_RING or len(set(right)) < MIN_RING:
        raise SceneError("an outline is as small as the tolerance; use a smaller --tolerance")
    if is_anticlockwise(left) != is_anticlockwise(right):
        raise SceneError("an outline is as thin as the tolerance; use a smaller --tolerance")
    return left, right


def _material(k: int, both: Sequence[tuple[Ring, Ring]], rule: str) -> tuple[bool, bool]:
    """Return whether there is material just inside a ring, and just outside."""
    around = 0
    for other, sides in enumerate(both):
        if other != k and _is_inside(both[k], sides):
            around += 1 if is_anticlockwise(sides[0]) else -1
    own = 1 if is_anticlockwise(both[k][0]) else -1
    return _filled(around + own, rule), _filled(around, rule)


def _filled(winding: int, rule: str) -> bool:
    return winding % 2 == 1 if rule == EVENODD else winding != 0


def _is_inside(inner: tuple[Ring, Ring], outer: tuple[Ring, Ring]) -> bool:
    """Return whether one ring is inside another, by all vertices and both sides of each."""
    answers = {contains(ring, p): p for ring in outer for side in inner for p in side}
    if len(answers) > 1:
        raise SceneError(
            "outlines cross or come closer than the tolerance; use a smaller --tolerance",
            value=" and ".join(f"({x:.9g}, {y:.9g})" for x, y in answers.values())
            + " are on both sides",
        )
    return next(iter(answers))


def mark_of(points: Sequence[Point]) -> Configuration:
    """Return the position and direction that a mark shows: from its first point to its last."""
    (x0, y0), (x1, y1) = points[0], points[-1]
    return x0, y0, math.atan2(y1 - y0, x1 - x0) if (x0, y0) != (x1, y1) else 0.0
