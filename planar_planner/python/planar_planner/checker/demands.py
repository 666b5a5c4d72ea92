"""How the checker rejects a certificate: by a demand that does not hold, or a name of nothing."""

from __future__ import annotations

from typing import Any

from planar_planner.errors import CertificateRejected


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
