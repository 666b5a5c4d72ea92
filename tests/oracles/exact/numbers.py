"""Sines, cosines and square roots to 50 places and more."""

from __future__ import annotations

import decimal
from fractions import Fraction

PLACES = 50  # a unit in the last place of a double near 1 is 1e-16; ties beyond this are not drawn


def number(value: Fraction) -> decimal.Decimal:
    """Return a fraction to the context's precision."""
    return decimal.Decimal(value.numerator) / value.denominator


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


def root(square: Fraction) -> Fraction:
    """Return a square root to 70 places."""
    with decimal.localcontext() as context:
        context.prec = PLACES + 20
        return Fraction(number(square).sqrt())
