"""The pipeline: scene → problem → core → verdict."""

from __future__ import annotations

import os
import threading
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from planar_planner._core import Core
from planar_planner.certificate import make_certificate
from planar_planner.core import Listener, ask, make_core
from planar_planner.errors import SceneError
from planar_planner.options import Options
from planar_planner.placement import check_placements
from planar_planner.problem import Problem, make_problem, with_query
from planar_planner.result import Result, Undecided, make_result
from planar_planner.scene import Scene, load_scene

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
        self._core: Core | None = make_core(self.problem)
        self._busy = threading.Lock()

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
        RuntimeError
            If a query of this planner is being answered, by another thread or around the listener.
        """
        limits = options or Options()
        query = with_query(self.problem, start, goal)
        if not self._busy.acquire(blocking=False):
            raise RuntimeError("a planner answers one query at a time")
        try:
            return self._answer(query, limits, listener, certificate)
        except MemoryError:
            return Undecided(query.name, "out of memory", np.empty((0, 3)), {})
        finally:
            self._busy.release()

    def _answer(
        self, query: Problem, limits: Options, listener: Listener | None, certificate: bool
    ) -> Result:
        """Ask the core.

        It is kept for the next query only if it has answered this one: an exception, of a listener
        or for want of memory, may have left cells half divided.
        """
        core = self._core or make_core(self.problem)
        self._core = None
        try:
            check_placements(core, query, limits.contact_tolerance)
        except SceneError:
            self._core = core
            raise
        answer = ask(core, query, limits, listener)
        answer["stats"]["least_clearance"] = core.least_clearance()
        evidence = core.evidence() if certificate else None
        self._core = core
        if evidence is None:
            return make_result(query.name, answer)
        return make_result(
            query.name, answer, make_certificate(query, evidence, limits.contact_tolerance)
        )
