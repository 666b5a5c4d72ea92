"""The pipeline: scene → problem → core → verdict."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
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
from planar_planner.planning.decimal_core import (
    DecimalCore,
    answer_of_decimals,
    bottleneck_of_decimals,
    cells_of_decimals,
    rests_on_contact,
    small_limits,
)
from planar_planner.planning.engine import Listener, ask, make_core
from planar_planner.planning.options import Options
from planar_planner.planning.outcome import STOPS, StopReason
from planar_planner.planning.placement import check_placements, find_placements, is_contact
from planar_planner.planning.result import Result, Undecided, make_result
from planar_planner.problem.decimals import decimal_places, in_small_units, rounding_of_decimals
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
        self._decimal: DecimalCore | None = None  # for what touches as it is written
        self._by_decimals = False  # the last query was answered by it
        self._rounding: float | None = None  # of the scene's decimals
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
        problem = with_query(self.problem, start, goal)
        query = _Query(problem, limits, listener, certificate)
        with self._idle():
            try:
                return self._answer(query)
            except MemoryError:
                stop = StopReason.OUT_OF_MEMORY
                return Undecided(
                    problem.name,
                    STOPS[stop],
                    np.empty((0, 3)),
                    Statistics(),
                    stop_reason=stop,
                    imported=problem.imported,
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
            if self._by_decimals and self._decimal is not None:
                places = self._decimal.places
                return cells_of_decimals(make_cells(self._decimal.core.cells()), places)
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
            if self._by_decimals and self._decimal is not None:
                found = make_bottleneck(self._decimal.core.thinnest_wall())
                return found and bottleneck_of_decimals(found, self._decimal.places)
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
            decimal = self._decimal if self._by_decimals else None
            core = self._core if decimal is None else decimal.core
            table = None if core is None else core.wall(self._asked.start[2])
            if table is None:
                return None
            cells = make_cells(table)
            return cells if decimal is None else cells_of_decimals(cells, decimal.places)

    @contextmanager
    def _idle(self) -> Iterator[None]:
        """Keep others from asking meanwhile; refuse if a query is being answered."""
        if not self._busy.acquire(blocking=False):
            raise RuntimeError("a planner answers one query at a time")
        try:
            yield
        finally:
            self._busy.release()

    def _answer(self, query: _Query) -> Result:
        """Ask the core, and the one in decimals where an answer rests on what touches.

        A core is kept for the next query only if it has answered this one: an exception, of a
        listener or for want of memory, may have left cells half divided.
        """
        problem = query.problem
        self._asked, self._by_decimals = problem, False
        core, self._core = self._core or make_core(self.problem, self._without), None
        found = find_placements(core, problem)
        decided: Result | None = None
        if problem.decimals and (is_contact(found) or self._rounding_tells(core)):
            self._core = core
            decided = self._in_decimals(query)
        if decided is not None:
            return decided
        try:
            check_placements(found, problem, query.limits.contact_tolerance)
        except SceneError:
            self._core = core
            raise
        self._core = None
        answer, certificate = _ask(core, query)
        self._core = core
        if problem.decimals and rests_on_contact(answer):
            decided = self._in_decimals(query)
        if decided is not None:
            return decided
        return make_result(problem.name, answer, certificate, problem.imported)

    def _rounding_tells(self, core: Core) -> bool:
        """Whether the rounding of decimals is too large beside the scene to be tolerated."""
        if self._rounding is None:
            self._rounding = rounding_of_decimals(self.problem)
        return self._rounding > core.tolerated_error()

    def _in_decimals(self, query: _Query) -> Result | None:
        """Ask about the decimals that the scene's lengths mean; None if they are no short ones."""
        problem = query.problem
        places = decimal_places(problem)
        if places is None:
            return None
        decimal, self._decimal = self._decimal, None
        small = in_small_units(problem, places)
        if decimal is None or decimal.places != places:
            decimal = DecimalCore(places, make_core(small, self._without))
        self._by_decimals = True
        try:
            found = find_placements(decimal.core, small)
            check_placements(found, problem, query.limits.contact_tolerance, 10.0**-places)
        except SceneError:
            self._decimal = decimal
            raise
        answer, certificate = _ask(decimal.core, query, places)
        self._decimal = decimal
        answer = answer_of_decimals(answer, places)
        return make_result(problem.name, answer, certificate, problem.imported, places)


@dataclass(frozen=True)
class _Query:
    """A problem with its own start and goal, and how it is to be answered."""

    problem: Problem
    limits: Options
    listener: Listener | None
    certificate: bool


def _ask(
    core: Core, query: _Query, places: int | None = None
) -> tuple[dict[str, Any], Certificate | None]:
    """Return a core's answer, and its certificate if one is asked for.

    The core is for the problem, or for its lengths as decimals of so many places.
    """
    problem, limits = query.problem, query.limits
    if places is None:
        answer = ask(core, problem, limits, query.listener)
    else:
        small = in_small_units(problem, places)
        answer = ask(core, small, small_limits(limits, places), query.listener)
    answer["stats"] = answer["stats"].replace(least_clearance=core.least_clearance())
    close = answer["to_be_checked"]
    if not query.certificate and not close:
        return answer, None
    tolerance = limits.contact_tolerance
    written = make_certificate(problem, core.evidence(), tolerance, places)
    missing = written is None and answer["verdict"] != "undecided"
    if missing or (close and not _holds(problem, written, tolerance)):
        return _without_evidence(answer), None
    return answer, written if query.certificate else None


def _holds(query: Problem, certificate: Certificate | None, contact_tolerance: float) -> bool:
    """Whether the checker accepts a certificate whose room is within the bound of rounding."""
    try:
        verify_problem(query, certificate or {}, contact_tolerance)
    except CertificateError:
        return False
    return True


def _without_evidence(answer: Mapping[str, Any]) -> dict[str, Any]:
    """Return an answer whose evidence the core could not write as undecided."""
    undecided = {"verdict": "undecided", "stop_reason": StopReason.NO_EVIDENCE}
    stats = answer["stats"].replace(decided_by=None)
    return {
        **answer,
        **undecided,
        "stats": stats,
        "path": [],
        "ends_moved": False,
        "exact_legs": False,
    }
