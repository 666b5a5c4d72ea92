"""Polygons that lie on one side of curved outlines.

Every piece of an outline is a rational Bézier curve with positive weights, which lies in the convex
hull of its control points (Farin, Curves and Surfaces for CAGD, section 13.2): lines, Bézier curves
and splines are such curves, and so are arcs of circles and ellipses up to a half turn. A piece is
halved until its hull is thin; then the left boundary of the hull, from the piece's beginning to its
end, lies to the left of the curve or on it, and the right one to the right.

Control points are homogeneous, (x·w, y·w, w), so that transforms and halving are linear.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass

from planar_planner.errors import SceneError
from planar_planner.formats.parts import Point, Ring

Homogeneous = tuple[float, float, float]
Piece = tuple[Homogeneous, ...]
"""Control points of one curve; two for a straight line."""
Affine = tuple[float, float, float, float, float, float]
"""(a, b, c, d, e, f): x ↦ a·x + c·y + e, y ↦ b·x + d·y + f, as in SVG's ``matrix``."""

SLACK = 2.0**-40
"""Length by which computed vertices are pushed to their side, relative to the largest coordinate.
Halving a curve of degree n by k levels makes n·k averages, each with at most 2 roundings of 2^-53;
with n ≤ 8 and k ≤ `MAX_HALVINGS` the error is below `SLACK`/8. Joints within `SLACK`/4 of the line
past them are left out. A push by `SLACK` covers both where the polygon turns by less than 130°.
Vertices that the file states are not moved."""


MAX_HALVINGS = 48
"""Levels of halving after which a piece is shorter than `SLACK` unless it has a defect."""


@dataclass(frozen=True)
class Outline:
    """A closed curve: a sequence of pieces, the last of which ends where the first begins."""

    pieces: tuple[Piece, ...]

    @property
    def curved(self) -> bool:
        """Whether any piece is not a straight line."""
        return any(len(piece) > 2 for piece in self.pieces)


def straight(a: Point, b: Point) -> Piece:
    """Return the line from a to b."""
    return (*a, 1.0), (*b, 1.0)


def bezier(points: Sequence[Point]) -> Piece:
    """Return the Bézier curve of control points."""
    return tuple((x, y, 1.0) for x, y in points)


@dataclass(frozen=True)
class Ellipse:
    """The points centre + u·cos t + v·sin t."""

    centre: Point
    u: Point
    v: Point

    def at(self, t: float) -> Point:
        """Return the point of an angle in radians."""
        cos, sin = math.cos(t), math.sin(t)
        (x, y), u, v = self.centre, self.u, self.v
        return x + u[0] * cos + v[0] * sin, y + u[1] * cos + v[1] * sin


def arc(
    ellipse: Ellipse, begin: float, end: float, ends: tuple[Point, Point] | None
) -> list[Piece]:
    """Return the arc between two angles, in quarter turns.

    For a part with chord c = α·u + β·v and half angle h, the middle control point is the point
    where the tangents at its ends cross: the chord's middle + (β·u − α·v)·tan(h)/2, with weight
    cos h. This formula does not use the centre, which is ill-conditioned for large radii.

    Parameters
    ----------
    ellipse : Ellipse
        An ellipse with u × v other than 0.
    begin, end : float
        Angles in radians.
    ends : (Point, Point), optional
        The arc's first and last point, if the file states them.
    """
    parts = max(1, math.ceil(abs(end - begin) / (math.pi / 2) - 2.0**-40))
    joints = [ellipse.at(begin + (end - begin) * k / parts) for k in range(parts + 1)]
    if ends is not None:
        joints[0], joints[-1] = ends
    half = (end - begin) / parts / 2
    weight, lift = math.cos(half), math.tan(half) / 2
    u, v = ellipse.u, ellipse.v
    area = u[0] * v[1] - u[1] * v[0]
    pieces: list[Piece] = []
    for a, b in itertools.pairwise(joints):
        cx, cy = b[0] - a[0], b[1] - a[1]
        alpha, beta = (cx * v[1] - cy * v[0]) / area, (u[0] * cy - u[1] * cx) / area
        x = (a[0] + b[0]) / 2 + (beta * u[0] - alpha * v[0]) * lift
        y = (a[1] + b[1]) / 2 + (beta * u[1] - alpha * v[1]) * lift
        pieces.append(((*a, 1.0), (x * weight, y * weight, weight), (*b, 1.0)))
    return pieces


def whole_ellipse(ellipse: Ellipse, begin: float) -> list[Piece]:
    """Return an ellipse from an angle on, whose last point is its first."""
    pieces = arc(ellipse, begin, begin + math.tau, None)
    return [*pieces[:-1], (*pieces[-1][:-1], pieces[0][0])]


def circle(centre: Point, radius: float) -> Outline:
    """Return a circle."""
    return Outline(tuple(whole_ellipse(Ellipse(centre, (radius, 0.0), (0.0, radius)), 0.0)))


def polygon(ring: Sequence[Point]) -> Outline:
    """Return a closed polygon."""
    return Outline(tuple(straight(a, b) for a, b in zip(ring, [*ring[1:], ring[0]], strict=True)))


def transformed(piece: Piece, matrix: Affine) -> Piece:
    """Return the image of a piece."""
    a, b, c, d, e, f = matrix
    return tuple((a * x + c * y + e * w, b * x + d * y + f * w, w) for x, y, w in piece)


def first_point(piece: Piece) -> Point:
    """Return where a piece begins."""
    return _point(piece[0])


def last_point(piece: Piece) -> Point:
    """Return where a piece ends."""
    return _point(piece[-1])


def control_points(outline: Outline) -> list[Point]:
    """Return all control points; their hull contains the outline."""
    return [_point(p) for piece in outline.pieces for p in piece]


def reversed_piece(piece: Piece) -> Piece:
    """Return a piece in the reverse direction."""
    return piece[::-1]


def flattened(outline: Outline, side: int, tolerance: float) -> Ring:
    """Return a polygon on one side of an outline.

    Parameters
    ----------
    outline : Outline
        A closed outline.
    side : {1, −1}
        1: no edge is to the right of the curve; −1: none is to its left.
    tolerance : float
        Greatest distance of an edge from the curve.

    Raises
    ------
    SceneError
        If a piece does not become flat, because its control points have a defect.
    """
    size = max((max(abs(x), abs(y)) for x, y in control_points(outline)), default=0.0)
    slack = SLACK * size
    how = _Limits(side, tolerance, slack)
    chains: list[tuple[list[Point], bool]] = []
    for piece in outline.pieces:
        chain: list[Point] = []
        _flatten(piece, how, 0, chain)
        if chain:
            chains.append((chain, len(piece) > 2))
    ring: Ring = []
    stated: list[bool] = []
    for k, (chain, curved) in enumerate(chains):
        ring += chain
        stated += [not (curved and chains[k - 1][1]), *[False] * (len(chain) - 1)]
    return _pushed(*_without_joints(ring, stated, slack / 4), side * slack)


@dataclass(frozen=True)
class _Limits:
    """The side, the greatest thickness of a hull, and the length that counts as zero."""

    side: int
    thickness: float
    slack: float


def _flatten(piece: Piece, how: _Limits, level: int, chain: list[Point]) -> None:
    """Append the boundary of the thin hulls on one side, without the piece's last point."""
    points = [_point(p) for p in piece]
    if len(piece) == 2:
        if points[0] != points[1]:
            chain.append(points[0])
        return
    begin = points[0]
    if math.dist(points[-1], begin) <= how.slack and all(
        math.dist(p, begin) <= how.slack for p in points
    ):
        if points[0] != points[-1]:
            chain.append(points[0])
        return
    if _is_thin(points, how.thickness):
        chain += _hull_chain(points, how.side)
        return
    if level == MAX_HALVINGS:
        raise SceneError("a curve does not become flat", value=f"near {points[0]!r}")
    for part in _halves(piece):
        _flatten(part, how, level + 1, chain)


def _is_thin(points: Sequence[Point], thickness: float) -> bool:
    """Return whether the hull is thin and the control points lie along the chord.

    The curve then passes every place along its chord. There both the curve and the hull's boundary
    are in the hull, so their distance is at most the hull's thickness.
    """
    (x0, y0), (x1, y1) = points[0], points[-1]
    length = math.hypot(x1 - x0, y1 - y0)
    if length == 0:
        return False
    dx, dy = (x1 - x0) / length, (y1 - y0) / length
    if len(points) == 3:
        x, y = points[1]
        beside, on = (y - y0) * dx - (x - x0) * dy, (x - x0) * dx + (y - y0) * dy
        return 0 <= on <= length and abs(beside) <= thickness
    across = [(y - y0) * dx - (x - x0) * dy for x, y in points[1:-1]]
    along = [(x - x0) * dx + (y - y0) * dy for x, y in points[1:-1]]
    if min(along) < 0 or max(along) > length:
        return False
    return max(0.0, *across) - min(0.0, *across) <= thickness


def _hull_chain(points: Sequence[Point], side: int) -> list[Point]:
    """Return the hull's boundary on one side of the chord without the last point (Andrew 1979)."""
    (x0, y0), last = points[0], points[-1]
    dx, dy = last[0] - x0, last[1] - y0
    if len(points) == 3:
        x, y = points[1]
        outside = side * ((y - y0) * dx - (x - x0) * dy) > 0
        turns = outside and side * _turn(points[0], points[1], last) < 0
        return [points[0], points[1]] if turns else [points[0]]
    kept = [p for p in points[1:-1] if side * ((p[1] - y0) * dx - (p[0] - x0) * dy) > 0]
    kept.sort(key=lambda p: (p[0] - x0) * dx + (p[1] - y0) * dy)
    chain: list[Point] = [points[0]]
    for p in [*kept, last]:
        while len(chain) > 1 and side * _turn(chain[-2], chain[-1], p) >= 0:
            chain.pop()
        chain.append(p)
    return chain[:-1]


def _turn(a: Point, b: Point, c: Point) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _halves(piece: Piece) -> tuple[Piece, Piece]:
    """Return the two halves of a curve (de Casteljau)."""
    left, right = [piece[0]], [piece[-1]]
    row: Sequence[Homogeneous] = piece
    while len(row) > 1:
        row = [
            ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2)
            for a, b in itertools.pairwise(row)
        ]
        left.append(row[0])
        right.append(row[-1])
    return tuple(left), tuple(right[::-1])


def _point(p: Homogeneous) -> Point:
    return (p[0], p[1]) if p[2] == 1.0 else (p[0] / p[2], p[1] / p[2])


def _without_joints(ring: Ring, stated: list[bool], near: float) -> tuple[Ring, list[bool]]:
    """Leave out computed vertices on the line from their predecessor to their successor.

    Where the pieces of a smooth curve meet, the polygon of control points is straight.
    """
    kept: Ring = []
    kept_stated: list[bool] = []
    for k, p in enumerate(ring):
        a, b = (kept or ring)[-1], ring[(k + 1) % len(ring)]
        length = math.dist(a, b)
        if stated[k] or length == 0 or abs(_turn(a, b, p)) > near * length or not _past(a, b, p):
            kept.append(p)
            kept_stated.append(stated[k])
    return kept, kept_stated


def _past(a: Point, b: Point, p: Point) -> bool:
    """Return whether p, which is near the line, lies between a and b along it."""
    return (p[0] - a[0]) * (b[0] - p[0]) + (p[1] - a[1]) * (b[1] - p[1]) >= 0


def _pushed(ring: Ring, stated: Sequence[bool], by: float) -> Ring:
    """Move every computed vertex to the left by the length `by`, or to the right if negative."""
    result: Ring = []
    for k, p in enumerate(ring):
        a, b = ring[k - 1], ring[(k + 1) % len(ring)]
        length = math.hypot(b[0] - a[0], b[1] - a[1])
        if stated[k] or length == 0:
            result.append(p)
        else:
            result.append((p[0] - by * (b[1] - a[1]) / length, p[1] + by * (b[0] - a[0]) / length))
    return result
