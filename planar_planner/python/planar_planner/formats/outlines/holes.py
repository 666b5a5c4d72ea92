"""Whether holes are holes: each in its shell, and no two with common area. Exact.

Let |·| be the area, S the shell, H₁, H₂, … the holes, and E what the even–odd rule makes of all
rings. E contains S without the holes, up to lines, and |S| − Σ|Hᵢ| is at most the area of that. So
|E| = |S| − Σ|Hᵢ| holds if and only if the holes lie in the shell and share no area.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from fractions import Fraction

from planar_planner.errors import SceneError
from planar_planner.formats.outlines.rings import polygons_of
from planar_planner.formats.parts import Notes, Ring, Shape


def check_holes(rings: Sequence[Ring], region: Sequence[Shape], place: str) -> None:
    """Refuse a polygon whose rings, a shell and its holes, do not mean shell minus holes.

    Parameters
    ----------
    rings : sequence of Ring
        The shell, then the holes, as in the file.
    region : sequence of Shape
        The polygons that the even–odd rule makes of them.
    place : str
        Place of the polygon in its file.

    Raises
    ------
    SceneError
        If a hole is outside its shell, leaves nothing of it, or shares area with another hole.
    """
    own = [_even_odd_area([ring], place) for ring in rings]
    rest = own[0] - sum(own[1:])
    if _area(region) == rest and (rest > 0 or own[0] == 0):
        return
    for k, ring in enumerate(rings[1:], start=1):
        difference = _even_odd_area([rings[0], ring], place)
        if own[k] and difference == 0:
            raise SceneError("the hole is the whole of its shell", f"{place}[{k}]")
        if difference != own[0] - own[k]:
            raise SceneError("the hole does not lie in its shell", f"{place}[{k}]")
    for (j, first), (k, second) in itertools.combinations(enumerate(rings[1:], start=1), 2):
        if _even_odd_area([first, second], place) != own[j] + own[k]:
            raise SceneError(f"the hole shares area with hole {j}", f"{place}[{k}]")
    raise SceneError("the holes leave nothing of their shell", place)


def _even_odd_area(rings: list[Ring], place: str) -> Fraction:
    return _area(polygons_of(rings, place, Notes(), "evenodd"))


def _area(shapes: Sequence[Shape]) -> Fraction:
    """Return the exact area of valid polygons."""
    total = Fraction(0)
    for outer, *holes in shapes:
        total += _enclosed(outer) - sum(map(_enclosed, holes))
    return total


def _enclosed(ring: Ring) -> Fraction:
    """Return the exact area in a simple ring (shoelace formula)."""
    points = [(Fraction(x), Fraction(y)) for x, y in ring]
    twice = sum(
        (a[0] * b[1] - b[0] * a[1] for a, b in zip(points, points[1:] + points[:1], strict=True)),
        Fraction(0),
    )
    return abs(twice) / 2
