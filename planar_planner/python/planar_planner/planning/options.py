"""Limits of a query, and the one tolerance. Rounding has no option: it is bounded by the core."""

from __future__ import annotations

import math
from dataclasses import dataclass

from planar_planner.errors import OptionsError

DEFAULT_RESOLUTION = 1e-9
"""A fraction of the configuration space's extent, so without unit. Cells grow with no more than the
logarithm of its inverse, so it is small: a path round the corner is found down to 1e-10 from
critical. Native code that asks the core without Python has the same (native/limits.hpp)."""


@dataclass(frozen=True)
class Options:
    """When to give up, and what counts as touching at start and goal.

    A limit that is reached makes the answer `Undecided`, never `NoPath`.

    Attributes
    ----------
    resolution : float
        Extent of the smallest cell, as a fraction of the extent of the configuration space, per
        axis; in (0, 1].
    max_cells : int
        Cells of the subdivision, counting leaves; at least 1.
    timeout : float
        Seconds of wall-clock time for one query, loading not included; positive, may be infinite.
    max_memory : int
        Bytes that the subdivision may take; at least 1.
    contact_tolerance : float
        Length by which a start or goal that touches an obstacle, or overlaps it by no more than
        this, may be translated to get off it; at least 0. The path then begins or ends with that
        short translation. Touching ends are undecided without it, because rounding cannot tell
        them from overlap.
    """

    resolution: float = DEFAULT_RESOLUTION
    max_cells: int = 5_000_000
    timeout: float = 60.0
    max_memory: int = 4 * 2**30
    contact_tolerance: float = 0.0

    def __post_init__(self) -> None:
        for name in ("resolution", "timeout", "contact_tolerance"):
            object.__setattr__(self, name, _real(name, getattr(self, name)))
        for name in ("max_cells", "max_memory"):
            _require_count(name, getattr(self, name))
        if not 0 < self.resolution <= 1:
            raise OptionsError(f"resolution must be in (0, 1], not {self.resolution!r}")
        if not self.timeout > 0:
            raise OptionsError(f"timeout must be positive, not {self.timeout!r}")
        if not (self.contact_tolerance >= 0 and math.isfinite(self.contact_tolerance)):
            raise OptionsError(
                f"contact_tolerance must be finite and not negative, not {self.contact_tolerance!r}"
            )


def _real(name: str, value: object) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise OptionsError(f"{name} must be a number, not {value!r}")
    try:
        return float(value)
    except OverflowError:
        raise OptionsError(f"{name} is too large") from None


def _require_count(name: str, value: object) -> None:
    if isinstance(value, bool) or not isinstance(value, int):
        raise OptionsError(f"{name} must be a whole number, not {value!r}")
    if not 1 <= value < 2**63:  # the core counts in 64 bits
        raise OptionsError(f"{name} must be between 1 and 2^63 - 1, not {value!r}")
