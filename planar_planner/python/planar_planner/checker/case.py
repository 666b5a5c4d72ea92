"""The case that a certificate is about: the scene in integers, and the certificate's pieces of it.

docs/certificate.md, "Common part", says how polygons are numbered and what the walls are.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

from planar_planner import certificate_keys as keys
from planar_planner.checker.arithmetic import (
    ONE,
    ROTATION_BITS,
    Angle,
    Polygon,
    Rectangle,
    Ring,
    Vector,
    angle_of,
    bounding_box,
    cross,
    cyclic_pairs,
    decimal_units,
    minus,
    quarter_turned,
    rotation,
    units,
)
from planar_planner.checker.demands import NO_DEADLINE, Deadline, demand
from planar_planner.checker.goal_area import GoalArea
from planar_planner.checker.pieces import Edge, Pieces, checked_pieces
from planar_planner.checker.records import Certificate
from planar_planner.errors import CertificateRejected
from planar_planner.problem.goal import Goal, GoalSet
from planar_planner.problem.make import Polygons, Problem
from planar_planner.scene.fields import Configuration

WALL_NORMALS: dict[str, Vector] = {
    keys.X_MIN: (ONE, 0),
    keys.X_MAX: (-ONE, 0),
    keys.Y_MIN: (0, ONE),
    keys.Y_MAX: (0, -ONE),
}
"""Outward normals of the walls, which are half-planes: they point into the workspace."""


Length = Callable[[float], int]
"""Turns a double of the scene into units."""


class Pose(NamedTuple):
    """A configuration: translation and angle.

    The translation is off by at most `spread` along x and y; the scene's own is exact.
    """

    translation: Vector
    angle: Angle
    spread: int = 0


@dataclass(frozen=True, eq=False)
class Case:
    """The scene in integers, and the certificate's pieces.

    Attributes
    ----------
    robot, obstacles : dict of Polygon
        By number.
    walls : dict of Edge
        Edges of the workspace, by name; empty if there is none.
    bounds : dict of Edge
        The same of the reference point's bounds.
    turning : bool
        Whether the robot may turn.
    start, goal : Pose
        The goal may be an area instead.
    pieces : Pieces
        Convex, and a partition of their polygons.
    reference : Vector
        The point of the scene's robot at which robot, pieces and poses have their origin. An area
        and bounds are for the scene's own origin: if that is another point, there are no bounds.
    decimal_places : int
        Lengths of the scene are decimals of so many places, and one here is in the last of them.
        0: they are the scene's.
    deadline : Deadline
        Of the verification.
    """

    robot: dict[str, Polygon]
    obstacles: dict[str, Polygon]
    walls: dict[str, Edge]
    bounds: dict[str, Edge]
    turning: bool
    start: Pose
    goal: Pose | GoalArea
    pieces: Pieces
    reference: Vector = (0, 0)
    deadline: Deadline = NO_DEADLINE
    decimal_places: int = 0

    def in_bounds(self, translation: Vector) -> bool:
        """Whether the reference point is within its bounds."""
        return all(edge.height(translation) >= 0 for edge in self.bounds.values())

    @cached_property
    def outline(self) -> Ring:
        """The vertices of the robot's outer rings."""
        return [v for polygon in self.robot.values() for v in polygon[0]]


def make_case(problem: Problem, certificate: Certificate, deadline: Deadline = NO_DEADLINE) -> Case:
    """Turn the scene's doubles into integers, and check the certificate's pieces against it."""
    length = _reading(problem, certificate)
    walls, beyond = _workspace(problem, certificate, length)
    reference = certificate.reference or (0, 0)
    own = _polygons(problem.robot, length)
    robot = _numbered([_about(reference, polygon) for polygon in own])
    obstacles = _numbered([*_polygons(problem.obstacles, length), *beyond])
    pieces = Pieces(
        checked_pieces(keys.ROBOT_PIECES, robot, certificate.robot_pieces, of_obstacle=False),
        checked_pieces(
            keys.OBSTACLE_PIECES, obstacles, certificate.obstacle_pieces, of_obstacle=True
        ),
    )
    # Without bounds more is free, so an absence still follows.
    bounds = problem.reference_bounds if certificate.reference is None else None
    return Case(
        robot=robot,
        obstacles=obstacles,
        walls=_box_edges(walls),
        bounds=_box_edges(bounds and _rectangle(bounds, length)),
        turning=problem.rotation,
        start=_pose(problem.start, reference, length),
        goal=_goal(problem.goal, problem.rotation, reference, length),
        pieces=pieces,
        reference=reference,
        deadline=deadline,
        decimal_places=certificate.decimal_places or 0,
    )


def _reading(problem: Problem, certificate: Certificate) -> Length:
    """Return how a length of the scene is read: as the double, or as a decimal."""
    places = certificate.decimal_places
    if places is None:
        return units
    demand(problem.decimals, keys.DECIMAL_PLACES, "the scene's numbers mean doubles")

    def decimal(number: float) -> int:
        value = decimal_units(number, places)
        if value is None:
            raise CertificateRejected(keys.DECIMAL_PLACES, f"{number!r} is no such decimal")
        return value

    return decimal


def _workspace(
    problem: Problem, certificate: Certificate, length: Length
) -> tuple[Rectangle | None, list[Polygon]]:
    """Return the box of the walls, and the polygons that a polygonal workspace leaves outside."""
    if problem.workspace is None:
        return problem.workspace_box and _rectangle(problem.workspace_box, length), []
    ((outer, *holes),) = _polygons(problem.workspace, length)
    walls = bounding_box(outer)
    xmin, ymin, xmax, ymax = certificate.outside or walls
    larger = xmin < walls[0] and ymin < walls[1] and walls[2] < xmax and walls[3] < ymax
    demand(larger, keys.OUTSIDE, "does not hold the workspace in its interior")
    frame = [(xmin, ymin), (xmax, ymin), (xmax, ymax), (xmin, ymax)]
    return walls, [[frame, outer[::-1]], *([hole[::-1]] for hole in holes)]


def _polygons(polygons: Polygons, length: Length) -> Iterator[Polygon]:
    """Yield polygons with outer rings counter-clockwise and holes clockwise."""
    points = [(length(x), length(y)) for x, y in polygons.coords.tolist()]
    rings = [points[a:b] for a, b in pairwise(polygons.ring_starts.tolist())]
    for first, end in pairwise(polygons.polygon_starts.tolist()):
        outer, *holes = rings[first:end]
        yield [_turned(outer, left=True), *(_turned(hole, left=False) for hole in holes)]


def _turned(ring: Ring, *, left: bool) -> Ring:
    turns_left = sum(cross(a, b) for a, b in cyclic_pairs(ring)) > 0
    return ring if turns_left == left else ring[::-1]


def _numbered(polygons: Iterator[Polygon] | list[Polygon]) -> dict[str, Polygon]:
    return {str(number): polygon for number, polygon in enumerate(polygons)}


def _rectangle(box: tuple[float, float, float, float], length: Length) -> Rectangle:
    xmin, ymin, xmax, ymax = map(length, box)
    return xmin, ymin, xmax, ymax


def _box_edges(box: Rectangle | None) -> dict[str, Edge]:
    """Return the sides of a box as edges of what lies outside it."""
    if box is None:
        return {}
    low, high = box[:2], box[2:]
    bases = {keys.X_MIN: low, keys.X_MAX: high, keys.Y_MIN: low, keys.Y_MAX: high}
    return {
        wall: Edge(bases[wall], normal, of_obstacle=True) for wall, normal in WALL_NORMALS.items()
    }


def _about(reference: Vector, polygon: Polygon) -> Polygon:
    return [[minus(vertex, reference) for vertex in ring] for ring in polygon]


def _pose(configuration: Configuration, reference: Vector, length: Length) -> Pose:
    """Return where a point of the robot is: x + R(theta) reference."""
    x, y, theta = configuration
    angle = angle_of(theta)
    if angle.quarters is not None:
        u, v = quarter_turned(reference, angle.quarters)
        return Pose((length(x) + u, length(y) + v), angle)
    u, v = reference
    c, s = rotation(angle.radians, angle.turns)
    turned = (u * c - v * s) >> ROTATION_BITS, (u * s + v * c) >> ROTATION_BITS
    spread = ((abs(u) + abs(v)) >> ROTATION_BITS) + 2 if u or v else 0
    return Pose((length(x) + turned[0], length(y) + turned[1]), angle, spread)


def _goal(goal: Goal, turning: bool, reference: Vector, length: Length) -> Pose | GoalArea:
    if isinstance(goal, GoalSet):
        return GoalArea(list(_polygons(goal.polygons, length)), goal.angles if turning else None)
    return _pose(goal, reference, length)
