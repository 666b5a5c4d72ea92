"""`planar-planner show`: describe and draw a scene without solving it."""

from __future__ import annotations

import argparse
import sys
from typing import Any

from planar_planner.builtin import manifest
from planar_planner.commands.scene_input import scene_of
from planar_planner.errors import one_line
from planar_planner.fields import Configuration
from planar_planner.goal import Goal, GoalRegion
from planar_planner.json_output import json_output
from planar_planner.output import check_writable, emit, written_aside
from planar_planner.problem import Problem, make_problem
from planar_planner.progress import Progress
from planar_planner.scene import Scene
from planar_planner.size import scene_size, size_json

FORMAT = "planar-planner/description"
VERSION = 1


def run(arguments: argparse.Namespace) -> int:
    """Check the scene's shapes, print its facts, draw it if asked."""
    output = json_output(arguments.json)
    if arguments.plot is not None:
        check_writable(arguments.plot)
    scene = scene_of(arguments, arguments.scene)
    with Progress(sys.stderr, "checking the shapes"):
        problem = make_problem(scene)
    if not output.to_stdout:
        emit(description(scene, problem))
    output.write(facts(scene))
    if arguments.plot is not None:
        from planar_planner.plot import draw_scene, save_picture

        figure = draw_scene(scene, None)
        with written_aside(arguments.plot) as aside:
            save_picture(figure, aside, arguments.plot.suffix)
    return 0


def facts(scene: Scene) -> dict[str, Any]:
    """Return the facts of a scene that the gate has accepted as a JSON object."""
    entry = manifest().get(scene.source, {})
    return {
        "format": FORMAT,
        "version": VERSION,
        "scene": scene.name,
        "description": scene.description,
        **size_json(scene_size(scene)),
        "workspace": scene.workspace,
        "reference_bounds": scene.reference_bounds,
        "start": scene.start,
        "goal": scene.goal,
        "rotation": scene.rotation,
        "notes": list(scene.notes),
        "expected": entry.get("expected"),
        "origin": entry.get("origin"),
    }


def description(scene: Scene, problem: Problem) -> str:
    """Return the facts of a scene, one a line."""
    size = scene_size(scene)
    lines = [one_line(f"{scene.name}: {scene.description}" if scene.description else scene.name)]
    lines.append(f"  robot: {size.robot_polygons} polygon(s), {size.robot_vertices} vertices")
    lines.append(
        f"  obstacles: {size.obstacle_polygons} polygon(s), {size.obstacle_vertices} vertices"
    )
    if problem.workspace_box is not None:
        lines.append(f"  workspace: box {list(problem.workspace_box)}")
    if problem.workspace is not None:
        lines.append(f"  workspace: polygon, {len(problem.workspace.coords)} vertices")
    if problem.reference_bounds is not None:
        lines.append(f"  reference point in: {list(problem.reference_bounds)}")
    lines.append(f"  start: {_text(problem.start)}, goal: {_goal_text(problem.goal)}")
    if not problem.rotation:
        lines.append("  the robot may not turn")
    entry = manifest().get(scene.source)
    if entry is not None:
        lines.append(
            f"  expected: {entry['expected'].replace('_', ' ')}; origin: {entry['origin']}"
        )
    return "\n".join(lines)


def _goal_text(goal: Goal) -> str:
    if not isinstance(goal, GoalRegion):
        return _text(goal)
    if goal.left is not None:
        return f"outside a polygon of {len(goal.left.coords)} vertices"
    angles = "" if goal.angles is None else f", theta in [{goal.angles[0]:g}, {goal.angles[1]:g}]"
    return f"a region of {len(goal.polygons)} polygon(s){angles}"


def _text(q: Configuration) -> str:
    return f"({q[0]:g}, {q[1]:g}, {q[2]:g})"
