"""What a user writes, for mypy --strict against the installed packages (.ci/run checks it).

Types come through only if both packages ship py.typed. The marked mistakes must be found:
an ignored line without an error is an error itself.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any, assert_type

import numpy as np

import pdg
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
    Report,
    Result,
    Scene,
    Undecided,
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
    place = found.bottleneck
    assert_type(place, NarrowPlace | None)
    return [] if place is None else list(place.contacts)


def proven(scene: Scene, file: str) -> Report | None:
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


def depth(body: pdg.ConvexPieces) -> float:
    """Return the width of a bracket."""
    found = pdg.bracket(body, [(0, 0), (1, 0), (0, 1)], pose=(0.1, 0.2, 0.3))
    assert_type(found.lo, float)
    return found.hi - found.lo


solve(3)  # type: ignore[arg-type]
Scene(robot=3, start=(0, 0, 0), goal=(1, 1, 0))  # type: ignore[arg-type]
Scene(robot=[(0, 0), (1, 0), (0, 1)], start=(0, 0, 0))  # type: ignore[call-arg]
GoalRegion(3)  # type: ignore[arg-type]
margin("slot", reuse=False)  # type: ignore[call-arg]
Options(timeout="long")  # type: ignore[arg-type]
