"""Limits of a query, and the one tolerance. Rounding has no option: it is bounded by the core."""

from __future__ import annotations

import math
from dataclasses import dataclass

from planar_planner._core import Limits
from planar_planner.errors import OptionsError

_DEFAULTS = Limits()


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

    resolution: float = _DEFAULTS.resolution
    max_cells: int = _DEFAULTS.max_cells
    timeout: float = _DEFAULTS.timeout
    max_memory: int = _DEFAULTS.max_memory
    contact_tolerance: float = _DEFAULTS.contact_tolerance

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
