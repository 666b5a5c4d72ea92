"""`planar-planner show`: describes and draws a scene without solving it."""

from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING, Any

from planar_planner.cli.arguments.importing import add_importing, scene_of
from planar_planner.cli.arguments.shared import DONE, add_command, add_json, add_plot, add_scene
from planar_planner.cli.json_output import json_output
from planar_planner.cli.progress import Progress
from planar_planner.errors import one_line
from planar_planner.output_files import check_writable, emit, written_aside
from planar_planner.scene.builtin import manifest
from planar_planner.scene.fields import Configuration
from planar_planner.scene.model import Scene
from planar_planner.scene.size import scene_size, size_json

if TYPE_CHECKING:
    from planar_planner.problem.goal import Goal
    from planar_planner.problem.make import Problem

FORMAT = "planar-planner/description"
VERSION = 1


def add(commands: Any) -> None:
    """Add the command."""
    show = add_command(
        commands,
        "show",
        "describe a scene, and draw it, without solving it",
        examples=("show gear", "show maze --plot maze.png", "show gear --json -"),
        status=DONE,
    )
    add_scene(show)
    add_importing(show)
    add_json(show, "the description")
    add_plot(show, "draw the scene")
    show.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Check the scene's shapes, print its facts, and draw it on request."""
    output = json_output(arguments.json)
    if arguments.plot is not None:
        check_writable(arguments.plot)
    scene = scene_of(arguments, arguments.scene)
    from planar_planner.problem.make import make_problem  # takes numpy

    with Progress(sys.stderr, "checking the shapes"):
        problem = make_problem(scene)
    if not output.to_stdout:
        emit(description(scene, problem))
    output.write(facts(scene))
    if arguments.plot is not None:
        from planar_planner.pictures.style import save_picture
        from planar_planner.pictures.swept import draw_scene

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
        "reference_bounds": scene.bounds,
        "bounds_are_chosen": scene.bounds_are_chosen,
        "start": scene.start,
        "goal": scene.goal,
        "rotation": scene.rotation,
        **scene.imported.to_json(),
        "expected": entry.get("expected"),
        "origin": entry.get("origin"),
    }


def description(scene: Scene, problem: Problem) -> str:
    """Return the facts of a scene, one per line."""
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
        chosen = ", chosen: the file states none" if problem.bounds_are_chosen else ""
        lines.append(f"  bounds of the reference point: {list(problem.reference_bounds)}{chosen}")
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
    from planar_planner.problem.goal import GoalSet  # takes numpy

    if not isinstance(goal, GoalSet):
        return _text(goal)
    if goal.left is not None:
        return f"outside a polygon of {len(goal.left.coords)} vertices"
    angles = "" if goal.angles is None else f", theta in [{goal.angles[0]:g}, {goal.angles[1]:g}]"
    return f"a region of {len(goal.polygons)} polygon(s){angles}"


def _text(q: Configuration) -> str:
    return f"({q[0]:.12g}, {q[1]:.12g}, {q[2]:.6g})"  # a place far off keeps its last metres
