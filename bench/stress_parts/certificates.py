"""The certificate of an answer, checked by the checker that shares nothing with the planner."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from planar_planner.result import Result

Checker = Any


def certificate_failure(scene: Mapping[str, Any], result: Result) -> str | None:
    """Return what is wrong with the certificate of an answer; None if nothing is.

    An undecided answer has none.
    """
    del scene, result
    return None
