"""Raw scene → problem: the only gate. Nothing behind it checks the input again.

What a `Problem` guarantees: finite numbers of sane magnitude; simple rings of positive area without
repeated vertices; boxes of positive size; a robot that is not empty; a workspace, bounds for the
reference point, or both. Whether start and goal are free is asked of the core
(`planar_planner.planning.placement`), since it is the only judge of contact.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from planar_planner.errors import SceneError, shown
from planar_planner.problem.goal import (
    Goal,
    GoalSet,
    Surroundings,
    allows_angle,
    is_region,
    read_region,
)
from planar_planner.problem.polygons import Polygons
from planar_planner.problem.rings import Judge, clean_polygons, judged_exactly
from planar_planner.scene import fields
from planar_planner.scene.fields import Box, Configuration
from planar_planner.scene.geojson import name_of, title_of_obstacle
from planar_planner.scene.goal_forms import goal_json
from planar_planner.scene.import_report import ImportReport
from planar_planner.scene.input_limits import MAX_ROBOT_VERTICES
from planar_planner.scene.model import DECIMALS, DOUBLES, Scene
from planar_planner.scene.plain import plain
from planar_planner.scene.plane import stands_for_plane
from planar_planner.scene.raw_polygons import read_polygons

__all__ = [
    "Polygons",
    "Problem",
    "at_end_of",
    "ends",
    "make_problem",
    "obstacle_title",
    "point_goal",
    "with_query",
]


@dataclass(frozen=True, eq=False)
class Problem:
    """A valid planning problem; lengths in the scene's unit, angles in radians.

    Attributes
    ----------
    name, source : str
        Name and origin of the scene, for results and messages.
    robot : Polygons
        In the robot's frame, whose origin is the reference point.
    obstacles : Polygons
        In the world frame.
    obstacle_paths : tuple of str
        Field path in the scene of each polygon of `obstacles`.
    obstacle_indices : NDArray, shape (P,)
        Index in the scene's list of obstacles of each polygon of `obstacles`.
    obstacle_names : tuple of str
        Name of each obstacle in the scene's list; empty for those without one.
    workspace_box : (xmin, ymin, xmax, ymax) or None
        The whole robot stays inside. At most one of this and `workspace` is given.
    workspace : Polygons or None
        One polygon; the whole robot stays inside.
    reference_bounds : (xmin, ymin, xmax, ymax) or None
        The reference point stays inside.
    bounds_are_chosen : bool
        Whether `reference_bounds` stand for the unbounded plane (`planar_planner.scene.plane`).
    rotation : bool
        Whether the robot may turn. If not, start and goal have the same theta.
    start : (x, y, theta)
        Configuration of the robot's frame in the world.
    goal : (x, y, theta) or GoalSet
        A configuration, or a set of them.
    imported : ImportReport
        What an importer did to the scene's geometry.
    decimals : bool
        Whether the lengths mean the decimals that name these doubles (`problem.decimals`).
    """

    name: str
    source: str
    robot: Polygons
    obstacles: Polygons
    obstacle_paths: tuple[str, ...]
    obstacle_indices: NDArray[np.uint32]
    obstacle_names: tuple[str, ...]
    workspace_box: Box | None
    workspace: Polygons | None
    reference_bounds: Box | None
    bounds_are_chosen: bool
    rotation: bool
    start: Configuration
    goal: Goal
    imported: ImportReport
    decimals: bool


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
        names = tuple(name_of(o) for _, o in _listed(scene.obstacles, "obstacles"))
        rotation = fields.truth(scene.rotation, "rotation")
        decimals = _means_decimals(scene.numbers)
        start = fields.configuration(scene.start, "start")
        robot_arrays = Polygons(robot.coords, robot.ring_starts, robot.polygon_starts)
        obstacle_arrays = Polygons(
            obstacles.coords, obstacles.ring_starts, obstacles.polygon_starts
        )
        chosen = fields.truth(scene.bounds_are_chosen, "bounds_are_chosen")
        if chosen:
            _check_chosen(reference_bounds, scene.workspace, robot_arrays, obstacle_arrays)
            reference_bounds = _around_ends(reference_bounds, start, scene.goal)
        around = Surroundings(
            robot_arrays, obstacle_arrays, workspace_box, workspace, reference_bounds, judge
        )
        goal: Goal
        if is_region(scene.goal):
            goal = read_region(scene.goal, around)
        else:
            goal = fields.configuration(scene.goal, "goal")
        goal = _reachable_goal(rotation, start, goal)
    except SceneError as error:
        raise error.in_source(scene.source) from None
    return Problem(
        name=scene.name,
        source=scene.source,
        robot=robot_arrays,
        obstacles=obstacle_arrays,
        obstacle_paths=obstacles.paths,
        obstacle_indices=obstacles.owners,
        obstacle_names=names,
        workspace_box=workspace_box,
        workspace=workspace,
        reference_bounds=reference_bounds,
        bounds_are_chosen=chosen,
        rotation=rotation,
        start=start,
        goal=goal,
        imported=scene.imported,
        decimals=decimals,
    )


def _means_decimals(numbers: object) -> bool:
    if numbers not in (DECIMALS, DOUBLES):
        raise SceneError(f'must be "{DECIMALS}" or "{DOUBLES}"', "numbers", shown(numbers))
    return numbers == DECIMALS


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
        If a start is not three finite numbers, a goal is none either and no region, or the theta
        differ where turning is forbidden.
    """
    if start is None and goal is None:
        return problem
    try:
        new_start = problem.start
        if start is not None:
            new_start = fields.configuration(plain(start, "start"), "start")
        new_goal: Goal = problem.goal
        if isinstance(goal, GoalSet):
            new_goal = goal
        elif goal is not None:
            raw = goal_json(goal)
            region = is_region(raw)
            around = _surroundings(problem)
            new_goal = read_region(raw, around) if region else fields.configuration(raw, "goal")
        new_goal = _reachable_goal(problem.rotation, new_start, new_goal)
    except SceneError as error:
        raise error.in_source(problem.source) from None
    return replace(problem, start=new_start, goal=new_goal)


def ends(problem: Problem) -> dict[str, Configuration]:
    """Return the start, and the goal if it is a configuration, by name."""
    if isinstance(problem.goal, GoalSet):
        return {"start": problem.start}
    return {"start": problem.start, "goal": problem.goal}


def obstacle_title(problem: Problem, polygon: int) -> str:
    """Return how texts refer to the obstacle that has a polygon of `Problem.obstacles`."""
    index = int(problem.obstacle_indices[polygon])
    return title_of_obstacle(problem.obstacle_names[index], index)


def point_goal(problem: Problem, user: str) -> Configuration:
    """Return the goal for a user who can do with a configuration only.

    Raises
    ------
    SceneError
        If the goal is a region.
    """
    if isinstance(problem.goal, GoalSet):
        raise SceneError(
            f"is a region; {user} needs a configuration [x, y, theta]", "goal", "", problem.source
        )
    return problem.goal


def at_end_of(problem: Problem, path: Any) -> Problem:
    """Return the problem with the end of a path as its goal, if its goal is a region."""
    return with_query(problem, goal=path[-1]) if isinstance(problem.goal, GoalSet) else problem


def _surroundings(problem: Problem) -> Surroundings:
    return Surroundings(
        problem.robot,
        problem.obstacles,
        problem.workspace_box,
        problem.workspace,
        problem.reference_bounds,
        judged_exactly,
    )


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
    if scene.bounds is not None:
        return fields.box(scene.bounds, "reference_bounds")
    if scene.workspace is None:
        raise SceneError("a scene needs a workspace, reference_bounds or both", "workspace")
    return None


def _check_chosen(
    bounds: Box | None, workspace: object, robot: Polygons, obstacles: Polygons
) -> None:
    """Refuse bounds that are said to stand for the unbounded plane, but do not."""
    place = "bounds_are_chosen"
    if bounds is None or workspace is not None:
        raise SceneError("needs reference_bounds, and no workspace", place, "true")
    if not len(obstacles):
        return
    coords = obstacles.coords
    (xmin, ymin), (xmax, ymax) = coords.min(axis=0).tolist(), coords.max(axis=0).tolist()
    reach = float(np.hypot(*robot.coords.T).max())
    if not stands_for_plane(bounds, (xmin, ymin, xmax, ymax), reach):
        raise SceneError(
            "reference_bounds that stand for the unbounded plane must contain the box of all "
            f"obstacles grown by the robot's reach, {reach:.6g}, on every side",
            place,
            "true",
        )


def _around_ends(bounds: Box | None, start: Configuration, goal: Any) -> Box | None:
    """Return bounds of the unbounded plane that also contain a start and goal stated later."""
    if bounds is None:
        return None
    ends = [start] if is_region(goal) else [start, fields.configuration(goal, "goal")]
    xs, ys = [q[0] for q in ends], [q[1] for q in ends]
    xmin, ymin, xmax, ymax = bounds
    return min(xmin, *xs), min(ymin, *ys), max(xmax, *xs), max(ymax, *ys)


def _as_box(polygon: Polygons) -> Box | None:
    """Return the box that a polygon of four axis-parallel edges is: four constraints, no pieces."""
    if polygon.coords.shape[0] != 4 or len(polygon.ring_starts) != 2:
        return None
    xmin, ymin = map(float, polygon.coords.min(axis=0))
    xmax, ymax = map(float, polygon.coords.max(axis=0))
    corners = {(xmin, ymin), (xmax, ymin), (xmax, ymax), (xmin, ymax)}
    return (xmin, ymin, xmax, ymax) if set(map(tuple, polygon.coords.tolist())) == corners else None


def _listed(value: Any, field: str) -> Iterable[tuple[str, Any]]:
    if not isinstance(value, list):
        raise SceneError("must be a list of geometries", field, shown(value))
    return ((f"{field}[{i}]", geometry) for i, geometry in enumerate(value))


def _reachable_goal(rotation: bool, start: Configuration, goal: Goal) -> Goal:
    """Without rotation, demand start's theta up to whole turns, and return the goal with just that.

    No double but 0 is a multiple of 2π, so "whole turns" is up to rounding: the double nearest to
    θ + 2πk is within half a unit in its last place, the double of 2π is off by half a unit, k times
    over; two units of the larger angle cover both ends.
    """
    if rotation:
        return goal
    unit = 2 * sys.float_info.epsilon
    if isinstance(goal, GoalSet):
        largest = max(map(abs, (start[2], *(goal.angles or ()))))
        if not allows_angle(goal.angles, start[2], unit * largest):
            raise SceneError(
                f"must hold theta of start ({start[2]!r}), since rotation is false",
                "goal.theta",
                str(list(goal.angles or ())),
            )
        return goal
    largest = max(abs(start[2]), abs(goal[2]))
    if not allows_angle((goal[2], goal[2]), start[2], unit * largest):
        raise SceneError(
            f"theta must equal that of start ({start[2]!r}), since rotation is false",
            "goal[2]",
            repr(goal[2]),
        )
    return goal[0], goal[1], start[2]
