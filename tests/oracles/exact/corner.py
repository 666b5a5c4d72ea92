"""The longest rectangle that passes from one corridor into another."""

from __future__ import annotations

import decimal
from fractions import Fraction

from oracles.exact.numbers import PLACES, number


def longest_round_corner(a: Fraction, b: Fraction, width: Fraction) -> Fraction:
    """Return the length of the longest rectangle of a width that passes from corridor a to b.

    With its outer side on the two outer walls, at angle φ, the inner corner (a, b) leaves it
    a sin φ + b cos φ − l sin φ cos φ ≥ width; the least l over φ is what passes. In u = tan(φ/2)
    that is a rational function that falls, then rises; an error of 10^-30 in the place of its
    minimum changes the value by about 10^-60.
    """
    with decimal.localcontext() as context:
        context.prec = 2 * PLACES
        da, db, dw = (number(v) for v in (a, b, width))

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
