"""The certificate of an answer, and what the checker says about it."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

from planar_planner.checker.verify import verify_certificate
from planar_planner.errors import CertificateError
from planar_planner.planning.result import Result


def certificate_failure(
    scene: Mapping[str, Any], result: Result, contact_tolerance: float
) -> str | None:
    """Return what is wrong with the certificate of an answer; None if nothing is.

    A decided answer has one that proves it, an undecided one has none. It is read back from JSON,
    as from a file.
    """
    if result.verdict == "undecided":
        return None if result.certificate is None else "an undecided answer has one"
    if result.certificate is None:
        return "there is none"
    content = json.loads(json.dumps(result.certificate, allow_nan=False))
    try:
        report = verify_certificate(scene, content, contact_tolerance)
    except CertificateError as error:
        return f"{type(error).__name__}: {error}"
    if report.verdict != result.verdict:
        return f"it proves {report.verdict}"
    return None
