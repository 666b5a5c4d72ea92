"""What a certificate says, as records: read, but not checked.

docs/certificate.md has the meaning of each. Lengths are in units of `arithmetic.LENGTH_BITS`.
"""

from __future__ import annotations

from typing import NamedTuple

from planar_planner.checker.arithmetic import Angle, Rectangle, Ring, Vector, angle_of

Span = tuple[int, int]
"""Level l and index k: from k/2^l to (k + 1)/2^l; normal to a face the plane k/2^l."""
Box = tuple[Span, Span, Span]
PairName = tuple[int, int, int, int]
"""p, i, q, j: piece i of robot polygon p and piece j of obstacle polygon q."""
EdgeName = tuple[str, int]
"""The owner, robot or obstacle, and the number of an edge of one of a pair's pieces."""
Pieces = dict[str, list[Ring]]
"""The convex pieces of polygons, by the polygons' numbers."""


class PairEdges(NamedTuple):
    """The edges that may separate a pair somewhere in a box."""

    pair: PairName
    edges: list[EdgeName]


class PairTerm(NamedTuple):
    """A separating-axis function of a pair for one vertex of the other piece, with its weight."""

    pair: PairName
    edge: EdgeName
    vertex: int
    weight: float


class WallTerm(NamedTuple):
    """The same of a wall, for a vertex of the robot."""

    wall: str
    vertex: Vector
    weight: float


class Joint(NamedTuple):
    """Sums of terms that leave no choice of separating edges."""

    axes: list[PairEdges]
    sums: list[list[PairTerm | WallTerm]]


class Collision(NamedTuple):
    """What collides everywhere in a box: one of a pair, a wall, several together."""

    pair: PairName | None
    wall: str | None
    joint: Joint | None


class FullClaim(NamedTuple):
    """The claim that every configuration of a box, or of a face, is in C-obstacle."""

    box: Box
    axis: int | None  # the normal of a face
    collision: Collision


class Waypoint(NamedTuple):
    """The configuration (x, y, theta + 2π turns)."""

    x: int
    y: int
    theta: float
    turns: int

    @property
    def angle(self) -> Angle:
        """Its angle, exactly."""
        radians, turns = angle_of(self.theta)
        return Angle(radians, turns + self.turns)


class Separator(NamedTuple):
    """An edge that separates a pair."""

    pair: PairName
    edge: EdgeName


class SeparatingLine(NamedTuple):
    """A pair whose obstacle piece, less the robot's piece, is on one side of a segment's line."""

    pair: PairName
    side: str  # of the line, where the obstacle is


class Interval(NamedTuple):
    """Part of a segment, from 0 to `ONE`, and an edge or the line for each pair that needs one."""

    begin: int
    end: int
    apart: list[Separator]
    along: list[SeparatingLine]


class PathProof(NamedTuple):
    """A free path."""

    contact_tolerance: float
    waypoints: list[Waypoint]
    segments: list[list[Interval]]


class Separation(NamedTuple):
    """FULL boxes and faces around the start's side, in a domain of translations."""

    low: Vector
    size: Vector
    start_side: list[Box]
    full: list[FullClaim]
    full_faces: list[FullClaim]


class DiscProof(NamedTuple):
    """A separation for a disc inside one of the robot's pieces."""

    disc: Ring
    inside: tuple[int, int]  # polygon and piece
    separation: Separation


class ChainLink(NamedTuple):
    """An open set of translations that are not free: of a pair, or beyond a side of the bounds."""

    pair: PairName | None
    side: str | None


class ChainProof(NamedTuple):
    """A closed chain of open sets, each of which overlaps the next."""

    chain: list[ChainLink]


class EndProof(NamedTuple):
    """The start or the goal is not free."""

    end: str
    collision: Collision | None  # None: it is out of the reference bounds


Proof = PathProof | Separation | DiscProof | ChainProof | EndProof


class Certificate(NamedTuple):
    """A whole certificate."""

    scene: str
    robot_pieces: Pieces
    obstacle_pieces: Pieces
    outside: Rectangle | None
    reference: Vector | None  # the point of the robot that the proof is about; None: the origin
    proof: Proof
    decimal_places: int | None  # of the scene's lengths, in whose last one lengths are given here
