"""Raw scene → problem: the only gate. Nothing behind it checks the input again.

What a `Problem` guarantees: finite numbers of sane magnitude; simple rings of positive area without
repeated vertices; boxes of positive size; a robot that is not empty; a workspace, bounds for the
reference point, or both. Whether start and goal are free is asked of the core
(`planar_planner.placement`), since it is the only judge of contact.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from planar_planner import fields
from planar_planner.errors import SceneError, shown
from planar_planner.fields import Box, Configuration
from planar_planner.limits import MAX_ROBOT_VERTICES
from planar_planner.raw_polygons import read_polygons
from planar_planner.scene import Scene
from planar_planner.validity import Judge, clean_polygons, judged_exactly


@dataclass(frozen=True, eq=False)
class Polygons:
    """Valid polygons as flat, read-only, contiguous arrays; the form the core takes.

    Attributes
    ----------
    coords : NDArray of float64, shape (N, 2)
        Vertices; rings are closed without a repeated last vertex, of any orientation.
    ring_starts : NDArray of uint32, shape (R + 1,)
        Ring r is ``coords[ring_starts[r]:ring_starts[r + 1]]``.
    polygon_starts : NDArray of uint32, shape (P + 1,)
        Polygon p has the rings ``polygon_starts[p]:polygon_starts[p + 1]``: outer one, then holes.
    """

    coords: NDArray[np.float64]
    ring_starts: NDArray[np.uint32]
    polygon_starts: NDArray[np.uint32]

    def __post_init__(self) -> None:
        for array in self.arrays:
            array.setflags(write=False)

    @property
    def arrays(self) -> tuple[NDArray[np.float64], NDArray[np.uint32], NDArray[np.uint32]]:
        """The three arrays, as the core takes them."""
        return self.coords, self.ring_starts, self.polygon_starts

    def __len__(self) -> int:
        return len(self.polygon_starts) - 1


@dataclass(frozen=True, eq=False)
class Problem:
    """A valid planning problem; lengths in the scene's unit, angles in radians.

    Attributes
    ----------
    name, source : str
        Of the scene, for results and messages.
    robot : Polygons
        In the robot's frame, whose origin is the reference point.
    obstacles : Polygons
        In the world frame.
    obstacle_paths : tuple of str
        Field path in the scene of each polygon of `obstacles`.
    obstacle_indices : NDArray, shape (P,)
        Index in the scene's list of obstacles of each polygon of `obstacles`.
    workspace_box : (xmin, ymin, xmax, ymax) or None
        The whole robot stays inside. At most one of this and `workspace` is given.
    workspace : Polygons or None
        One polygon; the whole robot stays inside.
    reference_bounds : (xmin, ymin, xmax, ymax) or None
        The reference point stays inside.
    rotation : bool
        Whether the robot may turn. If not, start and goal have the same theta.
    start, goal : (x, y, theta)
        Configurations of the robot's frame in the world.
    """

    name: str
    source: str
    robot: Polygons
    obstacles: Polygons
    obstacle_paths: tuple[str, ...]
    obstacle_indices: NDArray[np.uint32]
    workspace_box: Box | None
    workspace: Polygons | None
    reference_bounds: Box | None
    rotation: bool
    start: Configuration
    goal: Configuration


def make_problem(scene: Scene, judge: Judge = judged_exactly) -> Problem:
    """Check a raw scene and turn it into a problem.

    Parameters
    ----------
    scene : Scene
        As read.
    judge : callable, optional
        Who decides whether a polygon is simple: by default exact arithmetic.

    Raises
    ------
    SceneError
        On the first thing that is wrong, with file, field path and value.
    """
    try:
        workspace_box, workspace = _workspace(scene.workspace, judge)
        reference_bounds = _reference_bounds(scene)
        robot = clean_polygons(read_polygons([("robot", scene.robot)]), judge)
        _check_size(len(robot.coords))
        obstacles = clean_polygons(read_polygons(_listed(scene.obstacles, "obstacles")), judge)
        rotation = fields.truth(scene.rotation, "rotation")
        start = fields.configuration(scene.start, "start")
        goal = _reachable_goal(rotation, start, fields.configuration(scene.goal, "goal"))
    except SceneError as error:
        raise error.in_source(scene.source) from None
    return Problem(
        name=scene.name,
        source=scene.source,
        robot=Polygons(robot.coords, robot.ring_starts, robot.polygon_starts),
        obstacles=Polygons(obstacles.coords, obstacles.ring_starts, obstacles.polygon_starts),
        obstacle_paths=obstacles.paths,
        obstacle_indices=obstacles.owners,
        workspace_box=workspace_box,
        workspace=workspace,
        reference_bounds=reference_bounds,
        rotation=rotation,
        start=start,
        goal=goal,
    )


def _check_size(robot_vertices: int) -> None:
    if robot_vertices > MAX_ROBOT_VERTICES:
        raise SceneError(
            f"a robot may have at most {MAX_ROBOT_VERTICES} vertices", "robot", str(robot_vertices)
        )


def with_query(problem: Problem, start: Any = None, goal: Any = None) -> Problem:
    """Return the problem with another start, goal or both; None keeps the present one.

    Raises
    ------
    SceneError
        If a value is not three finite numbers, or the theta differ where turning is forbidden.
    """
    if start is None and goal is None:
        return problem
    try:
        new_start = problem.start if start is None else _given(start, "start")
        new_goal = problem.goal if goal is None else _given(goal, "goal")
        new_goal = _reachable_goal(problem.rotation, new_start, new_goal)
    except SceneError as error:
        raise error.in_source(problem.source) from None
    return replace(problem, start=new_start, goal=new_goal)


def _given(value: Any, field: str) -> Configuration:
    """Check a configuration that a caller passed as any sequence, numpy arrays included."""
    plain = value.tolist() if hasattr(value, "tolist") else value
    if isinstance(plain, (list, tuple)):
        plain = [item.tolist() if hasattr(item, "tolist") else item for item in plain]
    return fields.configuration(plain, field)


def _workspace(value: Any, judge: Judge) -> tuple[Box | None, Polygons | None]:
    if value is None:
        return None, None
    members = fields.mapping(value, "workspace")
    if "box" in members:
        fields.only_known(members, ["box"], "workspace")
        return fields.box(members["box"], "workspace.box"), None
    if "type" not in members:
        fields.only_known(members, ["box", "type", "coordinates"], "workspace")
        raise SceneError('must be {"box": [xmin, ymin, xmax, ymax]} or a Polygon', "workspace")
    shape = clean_polygons(read_polygons([("workspace", value)]), judge)
    if len(shape.paths) != 1:
        raise SceneError("must be one polygon", "workspace", f"{len(shape.paths)} polygons")
    polygon = Polygons(shape.coords, shape.ring_starts, shape.polygon_starts)
    rectangle = _as_box(polygon)
    return (rectangle, None) if rectangle else (None, polygon)


def _reference_bounds(scene: Scene) -> Box | None:
    if scene.reference_bounds is not None:
        return fields.box(scene.reference_bounds, "reference_bounds")
    if scene.workspace is None:
        raise SceneError("a scene needs a workspace, reference_bounds or both", "workspace")
    return None


def _as_box(polygon: Polygons) -> Box | None:
    """Return the box that a polygon of four axis-parallel edges is: four constraints, no pieces."""
    if polygon.coords.shape[0] != 4 or len(polygon.ring_starts) != 2:
        return None
    xmin, ymin = map(float, polygon.coords.min(axis=0))
    xmax, ymax = map(float, polygon.coords.max(axis=0))
    corners = {(xmin, ymin), (xmax, ymin), (xmax, ymax), (xmin, ymax)}
    return (xmin, ymin, xmax, ymax) if set(map(tuple, polygon.coords.tolist())) == corners else None


def _listed(value: Any, field: str) -> Iterable[tuple[str, object]]:
    if not isinstance(value, list):
        raise SceneError("must be a list of geometries", field, shown(value))
    return ((f"{field}[{i}]", geometry) for i, geometry in enumerate(value))


def _reachable_goal(rotation: bool, start: Configuration, goal: Configuration) -> Configuration:
    """Without rotation, demand start's theta up to whole turns, and return the goal with just that.

    No double but 0 is a multiple of 2π, so "whole turns" is up to rounding: the double nearest to
    θ + 2πk is within half a unit in its last place, the double of 2π is off by half a unit, k times
    over; two units of the larger angle cover both ends.
    """
    if rotation:
        return goal
    difference = math.remainder(goal[2] - start[2], math.tau)
    largest = max(abs(start[2]), abs(goal[2]))
    if abs(difference) > 2 * sys.float_info.epsilon * largest:
        raise SceneError(
            f"theta must equal that of start ({start[2]!r}), since rotation is false",
            "goal[2]",
            repr(goal[2]),
        )
    return goal[0], goal[1], start[2]
