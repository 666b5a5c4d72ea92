"""The pipeline: scene → problem → core → verdict."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from functools import partial
from typing import Any

import numpy as np

from planar_planner._core import Core, Statistics
from planar_planner.checker.verify import verify_problem
from planar_planner.errors import CertificateError, SceneError
from planar_planner.explain.cells import Cells, make_cells
from planar_planner.explain.thinnest_place import Bottleneck, make_bottleneck
from planar_planner.load import SceneLike, load_scene
from planar_planner.planning.certificate import Certificate, make_certificate
from planar_planner.planning.engine import Listener, ask, make_core
from planar_planner.planning.options import Options
from planar_planner.planning.outcome import STOPS, StopReason
from planar_planner.planning.placement import check_placements
from planar_planner.planning.result import Result, Undecided, make_result
from planar_planner.problem.make import Problem, make_problem, with_query
from planar_planner.scene.geometry import Numbers
from planar_planner.scene.goal_forms import GoalLike
from planar_planner.scene.model import Scene

_SHORT_CUTS = ("cheap", "probe")  # parts that answer before there is a cell (native/ablation.hpp)


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

    Pickled, copied or sent to another process, it is made anew from its scene: without cells.

    Parameters
    ----------
    scene : Scene, str, path or mapping
        A loaded scene, or anything that `load_scene` takes.
    cells_only : bool, optional
        Answer by cells even where a straight move, a disc or a first try by random trees would do,
        so that there are cells to look at. Slower; answers are proven all the same, but some are
        undecided that are not without it.

    Attributes
    ----------
    setup_seconds : dict of str to float
        Wall-clock times of making the planner: ``reading`` what was given into a scene,
        ``checking`` it at the gate, and ``building`` the core.

    Raises
    ------
    SceneError
        If the scene is not valid.
    """

    def __init__(self, scene: SceneLike, *, cells_only: bool = False) -> None:
        began = time.perf_counter()
        self.scene = load_scene(scene)
        loaded = time.perf_counter()
        self.problem = make_problem(self.scene)
        checked = time.perf_counter()
        self._without = _SHORT_CUTS if cells_only else ()
        self._core: Core | None = make_core(self.problem, self._without)
        self.setup_seconds = {
            "reading": loaded - began,
            "checking": checked - loaded,
            "building": time.perf_counter() - checked,
        }
        self._asked = self.problem  # with the ends of the last query
        self._busy = threading.Lock()

    def __reduce__(self) -> tuple[Callable[..., Planner], tuple[Scene]]:
        """Reduce it to its scene: cells belong to the core, which stays where it is."""
        return partial(Planner, cells_only=bool(self._without)), (self.scene,)

    def solve(
        self,
        start: Numbers | None = None,
        goal: GoalLike | None = None,
        options: Options | None = None,
        *,
        listener: Listener | None = None,
        certificate: bool = False,
    ) -> Result:
        """Decide whether the robot can get from start to goal.

        Parameters
        ----------
        start : (x, y, theta), optional
            Configuration instead of the scene's own; theta in radians.
        goal : (x, y, theta), GoalRegion, Escape, mapping or "escape", optional
            Goal instead of the scene's own; a mapping as in scene files.
        options, listener, certificate : optional
            As for `planar_planner.solve`.

        Returns
        -------
        PathFound, NoPath or Undecided
            As of `planar_planner.solve`.

        Raises
        ------
        SceneError
            If start or goal is of no legal form, or a configuration that collides or is out of
            bounds.
        RuntimeError
            If a query of this planner is being answered, by another thread or around the listener.
        """
        limits = options or Options()
        query = with_query(self.problem, start, goal)
        with self._idle():
            try:
                return self._answer(query, limits, listener, certificate)
            except MemoryError:
                stop = StopReason.OUT_OF_MEMORY
                return Undecided(
                    query.name,
                    STOPS[stop],
                    np.empty((0, 3)),
                    Statistics(),
                    stop_reason=stop,
                    imported=query.imported,
                )

    def cells(self) -> Cells:
        """Return the cells that the queries so far have left.

        There are none if no query has needed any: if a straight move, a disc in the robot's place
        or a first try by random trees has answered. Ask a planner made with ``cells_only=True`` to
        have them in any case.

        Raises
        ------
        RuntimeError
            If a query of this planner is being answered.
        """
        with self._idle():
            core = self._core or make_core(self.problem, self._without)
            return make_cells(core.cells())

    def bottleneck(self) -> Bottleneck | None:
        """Return where the last query's proof of absence is nearest to failing.

        None if it was not answered so, by cells or by a disc in the robot's place.

        Raises
        ------
        RuntimeError
            If a query of this planner is being answered.
        """
        with self._idle():
            return None if self._core is None else make_bottleneck(self._core.thinnest_wall())

    def wall(self) -> Cells | None:
        """Return the FULL cells and faces that separate the last query's start from its goal.

        As few of them as possible; a face is a cell without extent along its normal. Those of a
        disc in the place of a robot that may turn hold for every angle. None if the last query was
        not answered by a separation, of the robot or of such a disc.

        Raises
        ------
        RuntimeError
            If a query of this planner is being answered.
        """
        with self._idle():
            if self._core is None:
                return None
            table = self._core.wall(self._asked.start[2])
            return None if table is None else make_cells(table)

    @contextmanager
    def _idle(self) -> Iterator[None]:
        """Keep others from asking meanwhile; refuse if a query is being answered."""
        if not self._busy.acquire(blocking=False):
            raise RuntimeError("a planner answers one query at a time")
        try:
            yield
        finally:
            self._busy.release()

    def _answer(
        self, query: Problem, limits: Options, listener: Listener | None, certificate: bool
    ) -> Result:
        """Ask the core.

        It is kept for the next query only if it has answered this one: an exception, of a listener
        or for want of memory, may have left cells half divided.
        """
        core = self._core or make_core(self.problem, self._without)
        self._core = None
        self._asked = query
        try:
            check_placements(core, query, limits.contact_tolerance)
        except SceneError:
            self._core = core
            raise
        answer = ask(core, query, limits, listener)
        answer["stats"] = answer["stats"].replace(least_clearance=core.least_clearance())
        close = answer["to_be_checked"]
        evidence = core.evidence() if certificate or close else None
        self._core = core
        if evidence is None:
            return make_result(query.name, answer, imported=query.imported)
        written = make_certificate(query, evidence, limits.contact_tolerance)
        missing = written is None and answer["verdict"] != "undecided"
        if missing or (close and not _holds(query, written, limits.contact_tolerance)):
            return _without_evidence(query, answer)
        return make_result(query.name, answer, written if certificate else None, query.imported)


def _holds(query: Problem, certificate: Certificate | None, contact_tolerance: float) -> bool:
    """Whether the checker accepts a certificate whose room is within the bound of rounding."""
    try:
        verify_problem(query, certificate or {}, contact_tolerance)
    except CertificateError:
        return False
    return True


def _without_evidence(query: Problem, answer: Mapping[str, Any]) -> Result:
    """Return an answer whose evidence the core could not write as undecided."""
    undecided = {"verdict": "undecided", "stop_reason": StopReason.NO_EVIDENCE}
    stats = answer["stats"].replace(decided_by=None)
    changed = {**answer, **undecided, "stats": stats, "path": [], "ends_moved": False}
    return make_result(query.name, changed, imported=query.imported)
