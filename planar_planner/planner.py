"""The pipeline: scene → problem → core → verdict."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from planar_planner._core import Core
from planar_planner.certificate import make_certificate
from planar_planner.options import Options
from planar_planner.placement import check_placements
from planar_planner.problem import Problem, make_problem, with_query
from planar_planner.result import Result, make_result
from planar_planner.scene import Scene, load_scene

Listener = Callable[[dict[str, Any]], bool]
"""Called about ten times a second with running counts; returning False stops the search."""

SceneLike = Scene | str | os.PathLike[str] | Mapping[str, Any]


def solve(
    scene: SceneLike,
    options: Options | None = None,
    *,
    listener: Listener | None = None,
    certificate: bool = False,
) -> Result:
    """Decide whether the robot can get from start to goal.

    Parameters
    ----------
    scene : Scene, str, path or mapping
        A loaded scene, or anything that `load_scene` takes.
    options : Options, optional
        Limits of the search.
    listener : callable, optional
        Called about ten times a second with running counts; returning False stops the search.
    certificate : bool, optional
        Also make the certificate of a path or of its absence (docs/certificate.md).

    Returns
    -------
    PathFound, NoPath or Undecided
        A path certified free, a proof that there is none, or neither within the limits.

    Raises
    ------
    SceneError
        If the scene is not valid, or start or goal collide or are out of bounds.
    """
    return Planner(scene).solve(options=options, listener=listener, certificate=certificate)


class Planner:
    """A scene with its subdivision: each query starts from the cells of those before.

    Parameters
    ----------
    scene : Scene, str, path or mapping
        A loaded scene, or anything that `load_scene` takes.

    Raises
    ------
    SceneError
        If the scene is not valid.
    """

    def __init__(self, scene: SceneLike) -> None:
        self.scene = scene if isinstance(scene, Scene) else load_scene(scene)
        self.problem = make_problem(self.scene)
        self._core = _make_core(self.problem)

    def solve(
        self,
        start: Sequence[float] | None = None,
        goal: Sequence[float] | None = None,
        options: Options | None = None,
        *,
        listener: Listener | None = None,
        certificate: bool = False,
    ) -> Result:
        """Decide whether the robot can get from start to goal.

        Parameters
        ----------
        start, goal : (x, y, theta), optional
            Configurations instead of the scene's own; theta in radians.
        options, listener, certificate
            As for `planar_planner.solve`.

        Raises
        ------
        SceneError
            If start or goal is no configuration, collides or is out of bounds.
        """
        limits = options or Options()
        query = with_query(self.problem, start, goal)
        check_placements(self._core, query, limits.contact_tolerance)
        answer = self._core.solve(
            query.start,
            query.goal,
            limits.resolution,
            limits.max_cells,
            limits.timeout,
            limits.max_memory,
            limits.contact_tolerance,
            listener,
        )
        if not certificate:
            return make_result(query.name, answer)
        evidence = self._core.evidence()
        return make_result(
            query.name, answer, make_certificate(query, evidence, limits.contact_tolerance)
        )


def _make_core(problem: Problem) -> Core:
    workspace = problem.workspace
    return Core(
        problem.robot.arrays,
        problem.obstacles.arrays,
        problem.workspace_box,
        None if workspace is None else workspace.arrays,
        problem.reference_bounds,
        problem.rotation,
    )
