"""Configurations along a path at constant arc length: frames, ghosts, drives.

Arc length is measured as *travel*: ``|Δ(x, y)| + radius·|Δθ|`` along each straight segment. With
the robot's reach as radius this bounds from above what any point of the body travels: a point at
distance r <= radius from the reference point moves by at most ``|Δ(x, y)| + r·|Δθ|``. Robot that
only slides: the plain length of its path. So equal travel between frames is a bound on how far
anything in the picture jumps.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from planar_planner.problem.make import Polygons

Floats = NDArray[np.float64]


def reach(robot: Polygons) -> float:
    """Return the greatest distance of a robot vertex from the reference point, in scene units."""
    return float(np.hypot(robot.coords[:, 0], robot.coords[:, 1]).max())


def travel(path: ArrayLike, radius: float) -> Floats:
    """Return the travel from a path's start to each of its waypoints.

    Parameters
    ----------
    path : (N, 3)
        Waypoints (x, y, theta), N >= 1, in scene units and radians, theta unwrapped.
    radius : float
        Length in scene units that a turn by one radian counts as; `reach` of the robot, so that
        travel bounds the way of every point of the body.

    Returns
    -------
    (N,)
        From 0, not decreasing, in scene units.

    Raises
    ------
    ValueError
        If the path is not of shape (N, 3) with N >= 1, if it is not finite, or if the radius is
        negative or not finite.
    """
    waypoints = _waypoints(path)
    if not (np.isfinite(radius) and radius >= 0.0):
        raise ValueError(f"radius must be finite and at least 0, is {radius}")
    motion = np.diff(waypoints, axis=0)
    lengths = np.hypot(motion[:, 0], motion[:, 1]) + radius * np.abs(motion[:, 2])
    return np.concatenate([[0.0], np.cumsum(lengths)])


def configurations_at(path: ArrayLike, radius: float, where: ArrayLike) -> Floats:
    """Return the configurations at given travels from the start of a path.

    Parameters
    ----------
    path, radius
        As for `travel`.
    where : (M,)
        Travels from the start, in scene units; before the start and behind the goal they stop.

    Returns
    -------
    (M, 3)
        Configurations (x, y, theta) on the path's segments, up to rounding; its ends exactly.

    Raises
    ------
    ValueError
        As for `travel`, and if a travel is not a number.
    """
    waypoints = _waypoints(path)
    along = travel(waypoints, radius)
    wanted = np.asarray(where, dtype=np.float64)
    if np.isnan(wanted).any():
        raise ValueError("a travel is not a number")
    kept = np.concatenate([[True], np.diff(along) > 0.0])  # waits add nothing, and confuse interp
    placed = _interpolated(wanted, along[kept], waypoints[kept])
    placed[wanted <= 0.0] = waypoints[0]
    placed[wanted >= along[-1]] = waypoints[-1]
    return placed


def _interpolated(wanted: Floats, along: Floats, waypoints: Floats) -> Floats:
    """Return the points at `wanted` of a polyline whose parameters increase strictly.

    The fraction of a step is at most 1 however short the step is. A slope, which `numpy.interp`
    computes, overflows on steps near the smallest double.
    """
    if len(along) == 1:
        return np.repeat(waypoints, len(wanted), axis=0)
    step = np.clip(np.searchsorted(along, wanted, side="right") - 1, 0, len(along) - 2)
    fraction = np.clip((wanted - along[step]) / (along[step + 1] - along[step]), 0.0, 1.0)
    first = waypoints[step]
    return np.asarray(first + fraction[:, None] * (waypoints[step + 1] - first))


def equal_steps(path: ArrayLike, radius: float, step: float) -> Floats:
    """Return configurations along a path, equally spaced in travel, at most `step` apart.

    Parameters
    ----------
    path, radius
        As for `travel`.
    step : float
        Greatest spacing in scene units, > 0; rounded down so that the steps come out even.

    Returns
    -------
    (M, 3)
        M >= 2; first and last are exactly the ends of the path.

    Raises
    ------
    ValueError
        As for `travel`, and if the step is not greater than 0.
    """
    if not step > 0.0:
        raise ValueError(f"step must be greater than 0, is {step}")
    total = float(travel(path, radius)[-1])
    return equal_parts(path, radius, max(1, int(np.ceil(total / step))) + 1)


def equal_parts(path: ArrayLike, radius: float, count: int) -> Floats:
    """Return a given number of configurations along a path, equally spaced in travel.

    Parameters
    ----------
    path, radius
        As for `travel`.
    count : int
        Configurations, >= 2.

    Returns
    -------
    (count, 3)
        First and last are exactly the ends of the path.

    Raises
    ------
    ValueError
        As for `travel`, and if the count is less than 2.
    """
    if count < 2:
        raise ValueError(f"count must be at least 2, is {count}")
    total = float(travel(path, radius)[-1])
    placed = configurations_at(path, radius, np.linspace(0.0, total, count))
    placed[0], placed[-1] = _waypoints(path)[[0, -1]]  # also where the path has no length
    return placed


def _waypoints(path: ArrayLike) -> Floats:
    waypoints = np.asarray(path, dtype=np.float64)
    if waypoints.ndim != 2 or waypoints.shape[1] != 3 or len(waypoints) == 0:
        raise ValueError(f"a path has the shape (N, 3) with N >= 1, not {waypoints.shape}")
    if not np.isfinite(waypoints).all():
        raise ValueError("a waypoint is not finite")
    return waypoints
