"""The pipeline of a margin: ends, the robot as it is, bisection, narrow place."""

from __future__ import annotations

import math
import time
from dataclasses import dataclass, replace
from typing import cast

import numpy as np

from planar_planner.errors import OptionsError
from planar_planner.load import SceneLike, load_scene
from planar_planner.margins.body import Body, Family, Floats, geometry_of
from planar_planner.margins.bracket import Bracket, Search
from planar_planner.margins.decimals import margin_of_decimals
from planar_planner.margins.ends import Ends, ends_of, scale_limit
from planar_planner.margins.narrowest import find_narrow_place
from planar_planner.margins.offset import Offsets
from planar_planner.margins.result import Binding, By, Margin, NarrowPlace
from planar_planner.margins.scaling import Centre, Scalings
from planar_planner.margins.surroundings import Surroundings
from planar_planner.planning.engine import Listener, make_core
from planar_planner.planning.options import Options
from planar_planner.planning.placement import find_placements, is_contact
from planar_planner.problem.decimals import decimal_places, in_small_units, rounding_of_decimals
from planar_planner.problem.make import Problem, make_problem
from planar_planner.problem.plane import with_robot

DEFAULT_WIDTH = 1e-3
"""The width of a bracket of factors; that of distances is this part of half the diagonal of the
robot's bounding box."""


def margin(
    scene: SceneLike,
    options: Options | None = None,
    *,
    by: By = "offset",
    about: Centre = "reference",
    width: float | None = None,
    listener: Listener | None = None,
) -> Margin:
    """Bracket the largest robot for which a path from start to goal remains.

    Parameters
    ----------
    scene : Scene, str, path or mapping
        A loaded scene, or anything that `load_scene` takes.
    options : Options, optional
        Limits. The time is for all queries together, the others for each.
    by : {"offset", "scale"}
        Grow the robot by a distance, all round (shrink it, for a negative one), or scale it.
    about : {"reference", "centroid"}
        What scaling leaves in place: the origin of the robot's frame, or the robot's centroid.
    width : float, optional
        Width of the bracket, in the scene's unit (by "offset") or of the factor (by "scale"). By
        default 1/1000 of half the diagonal of the robot's bounding box, and 1/1000.
    listener : callable, optional
        Called about ten times a second during a query with its counts; False stops it all.

    Returns
    -------
    Margin
        A bracket with both ends proven.

    Raises
    ------
    SceneError
        If the scene is not valid or an end is outside the reference bounds. An end that collides is
        no error: shrinking may free it.
    OptionsError
        If the width is not a positive, finite number.
    """
    asked = Asked(by, about, width)
    return bracketed(make_problem(load_scene(scene)), options or Options(), asked, listener)


@dataclass(frozen=True)
class Asked:
    """What `margin` is asked for besides scene and limits.

    Attributes
    ----------
    by, about, width
        As of `margin`.
    reuse : bool
        False: forget every path once it has answered; for measuring what re-use spares.
    """

    by: By = "offset"
    about: Centre = "reference"
    width: float | None = None
    reuse: bool = True


def bracketed(
    problem: Problem, options: Options, asked: Asked, listener: Listener | None = None
) -> Margin:
    """Return the bracket; see `margin`."""
    places = decimal_places(problem)
    if places is not None and _decimals_tell(problem):
        return _in_decimals(problem, places, options, asked, listener)
    began = time.monotonic()
    by, width = asked.by, _width(problem, asked)
    around = Surroundings(problem)
    ends = ends_of(problem, make_core(with_robot(problem, problem.robot)), around)
    family: Family
    if by == "scale":
        scalings = Scalings(problem.robot, asked.about)
        family, (limit, binding) = scalings, scale_limit(problem, scalings, ends, 0.25 * width)
    else:
        family, limit, binding = Offsets(problem.robot), ends.limit, ends.binding
    bracket = Bracket(family.vanishing, limit, binding=binding)
    narrowest = _Narrowest(problem, by, around)
    search = Search(problem, family, options, listener, reuse=asked.reuse, guess=narrowest.guess)
    search.ask(bracket, Body(problem.robot, family.neutral, family.neutral))
    if places is not None and bracket.rests_on_contact:
        return _in_decimals(problem, places, options, asked, listener)
    if bracket.lower >= family.neutral and not math.isfinite(bracket.upper):
        bracket.lower = math.inf
    elif not math.isfinite(bracket.upper):
        bracket.reason = bracket.reason or "the robot as it is is undecided, and nothing is near"
    else:
        search.look_below(bracket, width)
        search.narrow(bracket, width)
    found = _Measured(problem, by, width, family.monotone, ends, bracket)
    return _result(found, narrowest, time.monotonic() - began)


def _decimals_tell(problem: Problem) -> bool:
    """Whether the rounding of decimals to doubles is not far below that of the planner."""
    core = make_core(problem)
    contact = is_contact(find_placements(core, problem))
    return contact or rounding_of_decimals(problem) > core.tolerated_error()


def _in_decimals(
    problem: Problem,
    places: int,
    options: Options,
    asked: Asked,
    listener: Listener | None,
) -> Margin:
    """Return the bracket for lengths as decimals: of a problem whose numbers are integers."""
    if asked.by == "offset" and asked.width is not None:
        asked = replace(asked, width=asked.width * 10.0**places)
    small = in_small_units(problem, places)
    return margin_of_decimals(bracketed(small, options, asked, listener), places)


def _width(problem: Problem, asked: Asked) -> float:
    if asked.width is not None:
        if not (asked.width > 0.0 and math.isfinite(asked.width)):
            raise OptionsError(f"width must be positive and finite, not {asked.width!r}")
        return float(asked.width)
    if asked.by == "scale":
        return DEFAULT_WIDTH
    extent = np.ptp(problem.robot.coords, axis=0)
    return DEFAULT_WIDTH * 0.5 * math.hypot(*extent.tolist())


class _Narrowest:
    """Where a bracket's path, or the end that binds, has least room; looked for once a path."""

    def __init__(self, problem: Problem, by: By, around: Surroundings) -> None:
        self._problem = problem
        self._by = by
        self._around = around
        self._last: tuple[Floats, NarrowPlace | None] | None = None

    def of(self, bracket: Bracket) -> NarrowPlace | None:
        """Return the narrowest place at the lower end, if there is a body with a path."""
        if not len(bracket.path):
            return None
        ends = {"start": bracket.path[:1], "goal": bracket.path[-1:]}
        if bracket.binding in ends:
            return self._look(ends[bracket.binding], bracket)
        if self._last is None or self._last[0] is not bracket.path:
            self._last = bracket.path, self._look(bracket.path, bracket)
        return self._last[1]

    def guess(self, bracket: Bracket) -> float | None:
        """Guess the margin: at the narrow place a robot grown by the clearance just passes."""
        place, body = self.of(bracket), bracket.lower_body
        if place is None or body is None or self._by != "offset":
            return None
        return place.clearance + min(body.inner, 0.0)

    def _look(self, path: Floats, bracket: Bracket) -> NarrowPlace | None:
        body, problem = bracket.lower_body, self._problem
        if body is None or body.polygons is None:
            return None
        robot = problem.robot if self._by == "offset" and body.inner >= 0.0 else body.polygons
        found = find_narrow_place(path, robot, self._around, problem)
        if found is None:
            return None
        (x, y, theta), clearance, contacts = found
        return NarrowPlace((float(x), float(y), float(theta)), clearance, contacts)


@dataclass(frozen=True, eq=False)
class _Measured:
    """What the bisection has established, and of what."""

    problem: Problem
    by: By
    width: float
    monotone: bool
    ends: Ends
    bracket: Bracket


def _result(found: _Measured, narrowest: _Narrowest, seconds: float) -> Margin:
    bracket = found.bracket
    lower, upper = bracket.lower_body, bracket.upper_body
    vanishes = not len(bracket.path) and not bracket.reason
    return Margin(
        scene=found.problem.name,
        by=found.by,
        lower=bracket.lower + 0.0,  # a 0 without a sign
        upper=bracket.upper + 0.0,
        width=found.width,
        monotone=found.monotone,
        reason=bracket.reason,
        binding="size" if vanishes else cast(Binding, bracket.binding),
        start_clearance=found.ends.start,
        goal_clearance=found.ends.goal,
        narrow_place=narrowest.of(bracket),
        path=_frozen(bracket.path),
        robot_lower=None if lower is None else geometry_of(lower.polygons),
        robot_upper=None if upper is None else geometry_of(upper.polygons),
        counts=bracket.counts,
        seconds=seconds,
        imported=found.problem.imported,
    )


def _frozen(path: Floats) -> Floats:
    path.setflags(write=False)
    return path
