"""How the checker rejects a certificate, and how it stops when its time is up.

A certificate is rejected by a demand that does not hold, or by a name of nothing.
"""

from __future__ import annotations

import time
from typing import Any

from planar_planner.errors import CertificateRejected, VerificationTimeoutError


class Deadline:
    """A time that a verification must not pass; infinity is none.

    Parameters
    ----------
    seconds : float
        From now on.
    """

    def __init__(self, seconds: float) -> None:
        self._end = time.monotonic() + seconds

    def check(self) -> None:
        """Raise an error once the time has passed; the work between two calls is short."""
        if time.monotonic() > self._end:
            raise VerificationTimeoutError("the time limit of the verification is reached")


NO_DEADLINE = Deadline(float("inf"))


def demand(holds: bool, place: str, problem: str) -> None:
    """Reject the certificate unless a claim holds."""
    if not holds:
        raise CertificateRejected(place, problem)


def find(place: str, things: Any, *names: Any) -> Any:
    """Return what a certificate names, one name a level."""
    try:
        for name in names:
            things = things[name]
    except LookupError:
        raise CertificateRejected(place, f"names what is not there: {names}") from None
    return things
