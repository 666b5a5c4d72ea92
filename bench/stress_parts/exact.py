"""Truths to compare with: rational numbers, and sine and cosine to 50 places."""

from __future__ import annotations

import decimal
from collections.abc import Sequence
from fractions import Fraction

Point = tuple[Fraction, Fraction]
Polygon = list[Point]

PLACES = 50  # a unit in the last place of a double near 1 is 1e-16; ties beyond this are not drawn


def polygon(ring: Sequence[Sequence[float]]) -> Polygon:
    """Return a ring of doubles as the exact numbers that they are."""
    return [(Fraction(p[0]), Fraction(p[1])) for p in ring]


def sine_cosine(angle: float) -> tuple[Fraction, Fraction]:
    """Return sine and cosine of a double, each within 10^-PLACES, for magnitudes up to 10.

    The Taylor series: its terms stay below 10^4, so 20 places more than asked for are enough, and
    the terms left out sum to less than the first of them.
    """
    with decimal.localcontext() as context:
        context.prec = PLACES + 20
        x = decimal.Decimal(angle)
        sums = [decimal.Decimal(0), decimal.Decimal(0)]  # of odd and of even terms
        term, k = decimal.Decimal(1), 0
        while k < abs(x) or abs(term) > decimal.Decimal(10) ** -(PLACES + 5):
            sums[1 - k % 2] += -term if k % 4 >= 2 else term
            k += 1
            term = term * x / k
        return Fraction(sums[0]), Fraction(sums[1])


def turned(ring: Polygon, angle: float) -> Polygon:
    """Return a polygon turned about the origin, exactly at angle 0 and to 50 places otherwise."""
    sine, cosine = sine_cosine(angle) if angle else (Fraction(0), Fraction(1))
    return [(cosine * x - sine * y, sine * x + cosine * y) for x, y in ring]


def squared_width(ring: Polygon) -> Fraction:
    """Return the square of a convex polygon's least width: from an edge to the farthest vertex."""
    widths = []
    for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1], strict=True):
        dx, dy = bx - ax, by - ay
        farthest = max(abs(dx * (y - ay) - dy * (x - ax)) for x, y in ring)
        widths.append(farthest**2 / (dx * dx + dy * dy))
    return min(widths)


def drop(upper: Polygon, lower: Polygon) -> Fraction | None:
    """Return how far `upper`, which lies above `lower`, can fall until the two touch.

    None if it misses. The vertical gap is linear between vertices' abscissas, so it is least over
    some vertex of either.
    """
    gaps = [edge - y for x, y in lower for edge in _heights(upper, x)]
    gaps += [y - edge for x, y in upper for edge in _heights(lower, x)]
    return min(gaps, default=None)


def _heights(ring: Polygon, x: Fraction) -> list[Fraction]:
    """Return the ordinates at which the sides of a ring, but upright ones, meet an abscissa."""
    found = []
    for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1], strict=True):
        if ax != bx and min(ax, bx) <= x <= max(ax, bx):
            found.append(ay + (by - ay) * (x - ax) / (bx - ax))
    return found


def longest_round_corner(a: Fraction, b: Fraction, width: Fraction) -> Fraction:
    """Return the length of the longest rectangle of a width that passes from corridor a to b.

    With its outer side on the two outer walls, at angle φ, the inner corner (a, b) leaves it
    a sin φ + b cos φ − l sin φ cos φ ≥ width; the least l over φ is what passes. In u = tan(φ/2)
    that is a rational function that falls, then rises; an error of 10^-30 in the place of its
    minimum changes the value by about 10^-60.
    """
    with decimal.localcontext() as context:
        context.prec = 2 * PLACES
        da, db, dw = (decimal.Decimal(v.numerator) / v.denominator for v in (a, b, width))

        def length(u: decimal.Decimal) -> decimal.Decimal:
            sine, cosine = 2 * u / (1 + u * u), (1 - u * u) / (1 + u * u)
            return (da * sine + db * cosine - dw) / (sine * cosine)

        low, high = decimal.Decimal("0.01"), decimal.Decimal("0.99")
        third = (high - low) / 3
        while third > decimal.Decimal(10) ** -30:
            if length(low + third) < length(high - third):
                high -= third
            else:
                low += third
            third = (high - low) / 3
        return Fraction(length((low + high) / 2))
