"""A margin found in a unit in which the scene's decimals are integers → one in the scene's unit."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np

from planar_planner.margins.result import Margin, NarrowPlace
from planar_planner.margins.surroundings import NearestPoints


def margin_of_decimals(found: Margin, places: int) -> Margin:
    """Return the margin with lengths divided by 10^places, its bounds rounded outwards."""
    unit = 10.0**places
    ends: dict[str, Any] = {}
    if found.by == "offset":
        ends = {
            "lower": _outwards(found.lower / unit, -math.inf),
            "upper": _outwards(found.upper / unit, math.inf),
            "width": found.width / unit,
        }
    path = found.path / np.array([unit, unit, 1.0])
    path.setflags(write=False)
    return replace(
        found,
        **ends,
        start_clearance=found.start_clearance / unit,
        goal_clearance=found.goal_clearance / unit,
        narrow_place=None if found.narrow_place is None else _place(found.narrow_place, unit),
        path=path,
        robot_lower=_geometry(found.robot_lower, unit),
        robot_upper=_geometry(found.robot_upper, unit),
        decimal_places=places,
    )


def _outwards(length: float, towards: float) -> float:
    return length if length == 0.0 else math.nextafter(length, towards)


def _place(place: NarrowPlace, unit: float) -> NarrowPlace:
    x, y, theta = place.configuration
    contacts = tuple(_contact(each, unit) for each in place.contacts)
    return NarrowPlace((x / unit, y / unit, theta), place.clearance / unit, contacts)


def _contact(contact: NearestPoints, unit: float) -> NearestPoints:
    (a, b), (c, d) = contact.robot_point, contact.obstacle_point
    return replace(
        contact,
        robot_point=(a / unit, b / unit),
        obstacle_point=(c / unit, d / unit),
        distance=contact.distance / unit,
    )


def _geometry(geometry: dict[str, Any] | None, unit: float) -> dict[str, Any] | None:
    if geometry is None:
        return None
    return {**geometry, "coordinates": _divided(geometry["coordinates"], unit)}


def _divided(value: Any, unit: float) -> Any:
    if isinstance(value, (list, tuple)):
        return [_divided(each, unit) for each in value]
    return value / unit
