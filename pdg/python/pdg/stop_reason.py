"""Why a search for a bracket ended."""

from __future__ import annotations

from enum import StrEnum


class StopReason(StrEnum):
    """Why a search ended. Whatever the reason, the bracket that it returns holds.

    A limit that ends a search has the name of the argument that sets it. A member equals its
    string: ``found.stop_reason == "converged"``.
    """

    CONVERGED = "converged"
    """The bracket is as narrow as asked for."""
    TIMEOUT = "timeout"
    MAX_NODES = "max_nodes"
    MAX_ITERATIONS = "max_iterations"
    MAX_FACETS = "max_facets"
    ROUNDING = "rounding"
    """Rounding does not allow a narrower bracket."""
