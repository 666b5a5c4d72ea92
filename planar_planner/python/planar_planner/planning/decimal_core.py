"""A core that plans in a unit in which a scene's decimals are integers, and its answers.

What comes out is divided by 10^places. Each number is then the double nearest to it: exactly the
decimal for waypoints that touch, and for any other as near as a double comes. The certificate has
the numbers of the core itself.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from planar_planner._core import Core, DecidedBy, StopReason
from planar_planner.explain.cells import Cells
from planar_planner.explain.thinnest_place import Bottleneck
from planar_planner.planning.options import Options

_EXACT = frozenset({DecidedBy.TAUT_PATH, DecidedBy.JOINED_LAYERS, DecidedBy.ODD_CHAIN})
_LEFT_BY_CONTACT = frozenset(
    {
        StopReason.RESOLUTION,
        StopReason.TIGHT_TURN,
        StopReason.NO_DOUBLES,
        StopReason.NO_EVIDENCE,
        StopReason.START_TOUCHES_OBSTACLE,
        StopReason.START_TOUCHES_WORKSPACE,
        StopReason.GOAL_TOUCHES_OBSTACLE,
        StopReason.GOAL_TOUCHES_WORKSPACE,
    }
)


@dataclass(frozen=True, eq=False)
class DecimalCore:
    """A core in the unit of the last decimal place.

    Attributes
    ----------
    places : int
        One of its units is 10^-places of the scene's.
    core : Core
        For the problem in that unit.
    """

    places: int
    core: Core


def rests_on_contact(answer: Mapping[str, Any]) -> bool:
    """Whether an answer may be another one if lengths change by their rounding.

    What rounded arithmetic decides holds for all lengths that are rounded to the same doubles.
    """
    return answer["stats"].decided_by in _EXACT or answer["stop_reason"] in _LEFT_BY_CONTACT


def small_limits(limits: Options, places: int) -> Options:
    """Return limits with the contact tolerance in the core's unit, rounded down."""
    tolerance = limits.contact_tolerance
    if tolerance == 0.0:
        return limits
    return replace(limits, contact_tolerance=math.nextafter(tolerance * 10.0**places, 0.0))


def answer_of_decimals(answer: Mapping[str, Any], places: int) -> dict[str, Any]:
    """Return a core's answer in the scene's unit of length; bounds are rounded down."""
    path = np.array(answer["path"], dtype=np.float64).reshape(-1, 3) / _scale(places)
    stats = answer["stats"]
    lengths = {
        "path_length": stats.path_length / 10.0**places,
        "least_clearance": _below(stats.least_clearance, places),
    }
    return {**answer, "path": path.tolist(), "stats": stats.replace(**lengths)}


def cells_of_decimals(cells: Cells, places: int) -> Cells:
    """Return cells in the scene's unit of length."""
    x, y = cells.point
    unit = 10.0**places
    return replace(
        cells,
        lower=cells.lower / _scale(places),
        upper=cells.upper / _scale(places),
        point=(x / unit, y / unit),
    )


def bottleneck_of_decimals(found: Bottleneck, places: int) -> Bottleneck:
    """Return a bottleneck in the scene's unit of length."""
    return replace(found, way=found.way / _scale(places))


def _scale(places: int) -> NDArray[np.float64]:
    return np.array([10.0**places, 10.0**places, 1.0])


def _below(length: float, places: int) -> float:
    return length if length in (0.0, math.inf) else math.nextafter(length / 10.0**places, 0.0)
