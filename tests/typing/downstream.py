"""What a user writes, for mypy --strict against the installed packages (.ci/run checks it).

Types come through only if both packages ship py.typed. The marked mistakes must be found:
an ignored line without an error is an error itself.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any, assert_type

import numpy as np
from numpy.typing import NDArray

import pdg
import pdg.grasp
from planar_planner import (
    Bottleneck,
    Cells,
    CertificateError,
    CertificateRejected,
    Escape,
    GoalRegion,
    ImportOptions,
    Listener,
    Margin,
    NarrowPlace,
    NearestPoints,
    NoPath,
    Options,
    PathFound,
    Planner,
    PlannerError,
    Result,
    Scene,
    Undecided,
    Verification,
    load_scene,
    margin,
    solve,
    verify_certificate,
)
from planar_planner.typing import Geometry, GoalLike


def waypoints(file: Path) -> list[tuple[float, float, float]]:
    """Return the path of a scene, or nothing."""
    scene = load_scene(file)
    assert_type(scene, Scene)
    result = solve(scene, Options(timeout=1.0), certificate=True)
    assert_type(result, PathFound | NoPath | Undecided)
    match result:
        case PathFound():
            return [(float(x), float(y), float(theta)) for x, y, theta in result.path]
        case NoPath():
            assert_type(result.certificate, dict[str, Any] | None)
            verify_certificate(scene, result.certificate or {})
        case Undecided():
            assert_type(result.reason, str)
    return []


def room(robot: Geometry, goal: GoalLike) -> Scene:
    """Make a scene from the objects at hand: arrays, sequences, GeoJSON; shapely has no types."""
    obstacles: list[Geometry] = [
        np.array([[4.0, 0.0], [5.0, 0.0], [5.0, 4.0]]),
        [(4, 6), (5, 6), (5, 10)],
        {"type": "Polygon", "coordinates": [[[7, 7], [8, 7], [8, 8]]]},
    ]
    bounded = Scene(
        robot=robot, obstacles=obstacles, start=(2, 2, 0), goal=goal, bounds=(0, 0, 9, 9)
    )
    assert_type(bounded, Scene)
    start = np.array([2.0, 2.0, 0.0])
    return Scene(robot=robot, start=start, goal=goal, workspace=(0, 0, 9, 9), rotation=False)


def goals() -> list[GoalLike]:
    """Every kind of goal."""
    area = [(7, 1), (9, 1), (9, 3)]
    return [(8, 2, 0), GoalRegion(area, theta=(0, 1)), Escape(area), "escape", {"region": area}]


def figures(planner: Planner, stop: Listener) -> tuple[float, float]:
    """Ask a planner, and look at what it has."""
    result: Result = planner.solve(goal=GoalRegion([(7, 1), (9, 1), (9, 3)]), listener=stop)
    assert_type(planner.cells(), Cells)
    assert_type(planner.wall(), Cells | None)
    assert_type(planner.bottleneck(), Bottleneck | None)
    assert_type(result.path_length, float)
    return result.path_length, result.least_clearance


def room_to_spare(scene: str) -> list[NearestPoints]:
    """Return what is nearest where the robot has least room."""
    found = margin(scene, by="offset", width=0.01)
    assert_type(found, Margin)
    place = found.narrow_place
    assert_type(place, NarrowPlace | None)
    return [] if place is None else list(place.contacts)


def proven(scene: Scene, file: str) -> Verification | None:
    """Tell a certificate that is refused from one that cannot be read."""
    try:
        return verify_certificate(scene, file)
    except CertificateRejected as error:
        assert_type(error.place, str)
    except CertificateError as error:
        assert_type(error.problem, str)
    except PlannerError:
        pass
    return None


def imported(file: Path) -> Scene:
    """Read a drawing."""
    return load_scene(file, ImportOptions(start=[0.0, 0.0, 0.0]))


Floats = NDArray[np.float64]


def one_or_many(body: pdg.ConvexPieces, rows: list[tuple[float, float, float]]) -> float:
    """One configuration gives one result, a sequence of rows gives a batch."""
    ring = [(0, 0), (1, 0), (0, 1)]
    found = pdg.generalized_depth_bracket(body, ring, pose=(0.1, 0.2, 0.3))
    assert_type(found, pdg.DepthBracket)
    assert_type(found.stop_reason, pdg.StopReason)
    many = pdg.generalized_depth_bracket(body, ring, rows, timeout=1.0, max_nodes=10)
    assert_type(many, pdg.DepthBrackets)
    assert_type(many.lower, Floats)
    assert_type(many[0], pdg.DepthBracket)
    assert_type(many[1:], pdg.DepthBrackets)
    assert_type(next(iter(many)).pose, pdg.Pose)
    assert_type(pdg.translational_depth(ring, body), pdg.TranslationalDepth)
    assert_type(pdg.translational_depth(ring, body, rows), pdg.TranslationalDepths)
    assert_type(pdg.generalized_depth_lower_bound(ring, body, (0, 0, 0)).lower, float)
    assert_type(pdg.generalized_depth_lower_bound(ring, body, rows), pdg.DepthLowerBounds)
    upper = pdg.generalized_depth_upper_bound(ring, pdg.convex_separators(body), rows)
    assert_type(upper.placement.pose, Floats)
    assert_type(pdg.c_obstacle_query(ring, body, [0.0] * 6).full, bool)
    assert_type(pdg.c_obstacle_query(ring, body, [[0.0] * 6]).full, NDArray[np.bool_])
    assert_type(pdg.displacement(ring, (0, 0, 0), (0, 0, 1)), float)
    assert_type(pdg.displacement(ring, (0, 0, 0), rows), Floats)
    assert_type(pdg.displacement(ring, rows, (0, 0, 0)), Floats)
    assert_type(pdg.generalized_distance_bracket(ring, rows, rows), pdg.DistanceBrackets)
    return found.upper - found.lower


def array_of_either_shape(pose: Floats) -> Floats:
    """The type of an array does not tell (3,) from (n, 3), so the result may be either."""
    depth = pdg.translational_depth([(0, 0), (1, 0), (0, 1)], "POLYGON((0 0,1 0,0 1,0 0))", pose)
    assert_type(depth, pdg.TranslationalDepth | pdg.TranslationalDepths)
    return depth.depth if isinstance(depth, pdg.TranslationalDepths) else np.array([depth.depth])


class Drawn:
    """A geometry of some other package."""

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        return {"type": "Polygon", "coordinates": []}


def bodies(array: Floats, wkb: bytes, outline: pdg.GeoInterface) -> list[pdg.ConvexPieces]:
    """Everything that is a body, and lists of such."""
    all_of_them: list[pdg.Body] = [
        array,
        wkb,
        outline,
        Drawn(),
        {"type": "Polygon", "coordinates": []},
        [array, array],
        [[(0, 0), (1, 0), (0, 1)], [(5, 5), (6, 5), (5, 6)]],
        ["POLYGON EMPTY"],
    ]
    return [pdg.convex_pieces(body) for body in all_of_them]


def grasp(contacts: list[pdg.grasp.Contact]) -> float:
    """Sets of wrenches are convex sets, and so are a user's own with a support function."""
    wrenches = pdg.grasp.grasp_wrench_set(contacts, norm="l1")
    efficiency = pdg.grasp.force_efficiency(wrenches, pdg.sets.Ball(6), relative_tolerance=0.1)
    assert_type(efficiency.distance, pdg.PenetrationDistance)
    assert_type(wrenches.support(np.ones(6)), tuple[float, Floats])
    assert_type(pdg.grasp.active_wrench_set([]), pdg.grasp.WrenchSet | None)
    found = pdg.penetration_distance(wrenches, pdg.sets.Ball(6), timeout=1.0)
    assert_type(found.stop_reason, pdg.StopReason)
    return efficiency.upper


pdg.translational_depth(3, 4)  # type: ignore[call-overload]
pdg.convex_pieces([1, 2, 3])  # type: ignore[arg-type]
pdg.c_obstacle_query("", "", [0.0] * 6, "guess")  # type: ignore[call-overload]
pdg.grasp.force_closure(pdg.sets.Ball(3))  # type: ignore[arg-type]
_ = pdg.no_such_name  # type: ignore[attr-defined]
solve(3)  # type: ignore[arg-type]
Scene(robot=3, start=(0, 0, 0), goal=(1, 1, 0))  # type: ignore[arg-type]
Scene(robot=[(0, 0), (1, 0), (0, 1)], start=(0, 0, 0))  # type: ignore[call-arg]
GoalRegion(3)  # type: ignore[arg-type]
margin("slot", reuse=False)  # type: ignore[call-arg]
Options(timeout="long")  # type: ignore[arg-type]
