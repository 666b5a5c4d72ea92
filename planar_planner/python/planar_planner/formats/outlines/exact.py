"""Exact predicates on doubles, for the few doubtful cases in the repair of rings."""

from __future__ import annotations

from fractions import Fraction

from planar_planner.formats.parts import Point

ORIENTATION_ERROR = (3 + 16 * 2.0**-53) * 2.0**-53
"""Relative error of the orientation determinant in doubles (Shewchuk 1997, ``ccwerrboundA``), as a
multiple of the sum of its two products' magnitudes. The gate's least magnitude of a coordinate
(`planar_planner.scene.input_limits.MIN_COORDINATE`) keeps the products clear of underflow."""


def orientation(a: Point, b: Point, c: Point) -> int:
    """Return 1 if c is to the left of a → b, −1 if to the right, 0 if on its line; exact."""
    left = (b[0] - a[0]) * (c[1] - a[1])
    right = (b[1] - a[1]) * (c[0] - a[0])
    determinant = left - right
    if abs(determinant) > ORIENTATION_ERROR * (abs(left) + abs(right)):
        return 1 if determinant > 0 else -1
    ax, ay = Fraction(a[0]), Fraction(a[1])
    exact = (Fraction(b[0]) - ax) * (Fraction(c[1]) - ay)
    exact -= (Fraction(b[1]) - ay) * (Fraction(c[0]) - ax)
    return (exact > 0) - (exact < 0)


def strictly_between(a: Point, b: Point, p: Point) -> bool:
    """Return whether p, on the line through a and b, lies between them and is neither."""
    if a[0] != b[0]:
        return min(a[0], b[0]) < p[0] < max(a[0], b[0])
    return min(a[1], b[1]) < p[1] < max(a[1], b[1])


def is_anticlockwise(ring: list[Point]) -> bool:
    """Return whether a simple ring is anticlockwise, from its turn at the leftmost corner; exact.

    The neighbours of the lowest leftmost vertex are not on one ray from it, because the ring would
    then overlap itself.
    """
    corner = min(range(len(ring)), key=ring.__getitem__)
    return orientation(ring[corner - 1], ring[corner], ring[(corner + 1) % len(ring)]) > 0


def convex_turn(ring: list[Point]) -> int:
    """Return 1 for a strictly convex anticlockwise ring, −1 for a clockwise one, 0 for any other.

    A ring that turns strictly to one side at every vertex goes round once if the lexicographic
    order of its vertices changes direction twice, and is then simple. Exact.
    """
    turn = orientation(ring[-2], ring[-1], ring[0])
    if turn == 0:
        return 0
    changes = 0
    before, b = ring[-1], ring[0]
    rising = before < b
    for c in (*ring[1:], ring[0]):
        if orientation(before, b, c) != turn:
            return 0
        changes += (b < c) != rising
        before, b, rising = b, c, b < c
    return turn if changes == 2 else 0


def contains(ring: list[Point], p: Point) -> bool:
    """Return whether p, not on the ring, is inside it; exact."""
    inside = False
    for a, b in zip(ring, ring[1:] + ring[:1], strict=True):
        if (a[1] > p[1]) != (b[1] > p[1]):
            low, high = (a, b) if a[1] < b[1] else (b, a)
            inside ^= orientation(low, high, p) > 0
    return inside
