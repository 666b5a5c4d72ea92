"""The gears' critical gap: bracketed by our own planner, with certificates checked independently.

No formula is known. Both ends of the bracket come with a certificate that `planar_planner.checker`
accepts; it shares nothing with the planner but the reader of scenes.
"""

from __future__ import annotations

from fractions import Fraction

from lib.bisection import bisect
from planar_planner import Options, Planner, verify_certificate
from scenarios import gear
from worlds.critical import Family
from worlds.scene import plain

NAME = "gears"
# Coordinates of the gears are rounded to 12 places, so scenes nearer than this may be the same.
NARROWEST = 1e-11
FINE = Options(resolution=1e-15, timeout=60.0)


def gears(width: float = NARROWEST) -> Family:
    """Bisect the gap to a bracket of a width and check both ends' certificates.

    Raises
    ------
    RuntimeError
        If the planner is undecided before the bracket is that narrow.
    CertificateRejected
        If the checker does not accept a certificate.
    """
    found = bisect(gear.gear, gear.JAMMED_GAP, gear.PATH_GAP, width, repetitions=1, options=FINE)
    blocked, passing = found.blocked, found.passing
    for gap, expected in ((blocked, "no_path"), (passing, "path")):
        scene = plain(gear.gear(gap))
        result = Planner(scene).solve(options=FINE, certificate=True)
        if result.verdict != expected or result.certificate is None:
            raise RuntimeError(f"gear at {gap!r}: {result.verdict}, found {expected} before")
        verify_certificate(scene, result.certificate)
    blocked_at, path_at = Fraction(blocked), Fraction(passing)

    def has_path(gap: float | Fraction) -> bool:
        if blocked_at < gap < path_at:
            raise ValueError(f"gears: {gap!r} lies inside the bracket")
        return gap >= path_at

    return Family(
        NAME, lambda gap: plain(gear.gear(gap)), blocked_at, path_at, 1, has_path, finest=1e-10
    )
