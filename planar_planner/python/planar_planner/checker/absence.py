"""Claims that a disc inside the robot has no path, and that an end is not free.

docs/certificate.md, "disc" and "end".
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from planar_planner import certificate_keys as keys
from planar_planner.checker.arithmetic import Ring, dot
from planar_planner.checker.case import Case
from planar_planner.checker.collisions import check_full
from planar_planner.checker.demands import demand, find
from planar_planner.checker.extents import Extent
from planar_planner.checker.goal_area import GoalArea
from planar_planner.checker.pieces import Piece, convex_piece
from planar_planner.checker.records import DiscProof, EndProof
from planar_planner.checker.separation import check_separation
from planar_planner.errors import CertificateRejected


def check_disc(case: Case, proof: DiscProof) -> int:
    """Check that a disc inside the robot, in place of it, has no path."""
    polygon, number = proof.inside
    holder: Piece = find(keys.INSIDE, case.pieces.robot, str(polygon), number)
    demand(is_inside(proof.disc, holder), keys.DISC, "is not inside that piece")
    disc = convex_piece(keys.DISC, proof.disc, of_obstacle=False)
    goal = case.goal
    smaller = replace(
        case,
        robot={"0": [proof.disc]},
        pieces=case.pieces._replace(robot={"0": [disc]}),
        turning=False,
        start=case.start._replace(theta=0.0),
        goal=(
            GoalArea(goal.polygons, None)
            if isinstance(goal, GoalArea)
            else goal._replace(theta=0.0)
        ),
    )
    return check_separation(smaller, proof.separation)


def is_inside(disc: Ring, holder: Piece) -> bool:
    """Whether a piece holds the origin, and no vertex is farther from it than its boundary."""
    farthest = max((dot(vertex, vertex) for vertex in disc), default=0)  # squared
    for edge in holder.edges:
        distance = dot(edge.normal, edge.base)  # of the edge's line, times the normal's length
        if distance < 0 or distance**2 < farthest * dot(edge.normal, edge.normal):
            return False
    return True


def check_end(case: Case, proof: EndProof) -> int:
    """Check that the start or the goal is not free."""
    end = case.start if proof.end == keys.START else case.goal
    if isinstance(end, GoalArea):
        raise CertificateRejected(keys.END, "is a region, not a configuration")
    if proof.collision is None:
        outside = not case.in_bounds(end.translation)
        demand(outside, keys.REFERENCE_BOUNDS, "the reference point is not outside")
    else:
        extent = Extent([end.translation], Fraction(), Fraction(), Fraction(end.theta))
        check_full(case, proof.end, proof.collision, extent)
    return 1
