"""Closed outlines made of loose lines and arcs.

Ends that are near each other meet in a node. An end that meets no other end, but the middle of a
straight line, cuts that line there. Lines that are drawn twice count once. What hangs together then
bounds one area: its outer boundary is the outline, and the lines inside divide it without a hole.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass

from planar_planner.errors import SceneError
from planar_planner.formats.outlines.curves import (
    Outline,
    Piece,
    first_point,
    last_point,
    reversed_piece,
    straight,
)
from planar_planner.formats.outlines.junctions import Graph, Walk, boundaries, cut_where_ends_meet
from planar_planner.formats.outlines.strands import Ends, Strand, Traced, is_closed, span
from planar_planner.formats.parts import Notes, Point
from planar_planner.tolerances import WRITTEN_SHARE


@dataclass(frozen=True)
class Joining:
    """How far apart ends may be that meet, in the drawing's unit.

    Attributes
    ----------
    reach : float
        Ends no farther apart are one place.
    join : float or None
        The user's: ends that meet nothing else are joined up to this distance, the nearest first.
    place : str
        The layer, for messages.
    """

    reach: float
    join: float | None
    place: str


def closed_outlines(strands: Sequence[Strand], how: Joining, notes: Notes) -> list[Traced]:
    """Join strands end to end, in either direction, to closed outlines.

    A straight line joins ends that do not quite meet.

    Raises
    ------
    SceneError
        If an end meets nothing; the message states the gap to the nearest loose end.
    """
    loose = [strand for strand in strands if not is_closed(strand)]
    whole = [strand for strand in strands if is_closed(strand)]
    kept = [strand for strand in loose if span(strand) > how.reach]
    notes.count("loose pieces shorter than the reach of joining dropped", len(loose) - len(kept))
    graph, whole = _graph(kept, whole, how, notes) if kept else (None, whole)
    outlines = [Traced(Outline(tuple(strand.pieces)), (strand.name,)) for strand in whole]
    if graph is None:
        return outlines
    _refuse_open(graph, how)
    widest, bounding = 0.0, 0
    for walk in boundaries(graph, how.place):
        outline, gap = _outline(walk, graph.strands)
        outlines.append(outline)
        widest, bounding = max(widest, gap), bounding + len(walk)
    inner = len(graph.strands) - bounding
    notes.count("lines that only divide what an outline bounds ignored", inner)
    if widest > 0:
        how_far = "" if how.join is None else f", --join is {how.join!r}"
        notes.say(
            f"{how.place}: ends that do not meet were joined; the widest gap is {widest!r}{how_far}"
        )
    return outlines


def _graph(
    loose: list[Strand], whole: list[Strand], how: Joining, notes: Notes
) -> tuple[Graph, list[Strand]]:
    """Return the loose strands and where they meet, and the strands that are closed alone."""
    loose, whole = cut_where_ends_meet(loose, whole, how.reach)
    loose = _once_each(loose, how.reach, notes)
    ends = Ends(loose, how.reach)
    if how.join is not None:
        ends.pair_free(loose, how.join * (1 + WRITTEN_SHARE))
    return Graph(loose, ends), whole


def _outline(walk: Walk, strands: Sequence[Strand]) -> tuple[Traced, float]:
    """Return the outline of a walk, and the widest gap in it."""
    widest = 0.0
    pieces: list[Piece] = []
    for index, backwards in walk:
        own = strands[index].pieces
        own = [reversed_piece(piece) for piece in reversed(own)] if backwards else own
        if pieces:
            widest = max(widest, _bridge(pieces, first_point(own[0])))
        pieces += own
    widest = max(widest, _bridge(pieces, first_point(pieces[0])))
    names = tuple(dict.fromkeys(strands[index].name for index, _ in walk))
    return Traced(Outline(tuple(pieces)), names), widest


def _bridge(pieces: list[Piece], to: Point) -> float:
    """Add a straight line to a point if there is a gap; return the gap."""
    end = last_point(pieces[-1])
    gap = math.dist(end, to)
    if gap > 0:
        pieces.append(straight(end, to))
    return gap


def _once_each(strands: Sequence[Strand], reach: float, notes: Notes) -> list[Strand]:
    """Leave out strands that run where another does, in either direction."""
    ends = Ends(strands, reach)
    groups: dict[tuple[int, int, int], list[Strand]] = defaultdict(list)
    for k, strand in enumerate(strands):
        a, b = ends.node(k, end=False), ends.node(k, end=True)
        own = groups[min(a, b), max(a, b), len(strand.pieces)]
        if not any(_same(strand, other, reach) for other in own):
            own.append(strand)
    kept = [strand for own in groups.values() for strand in own]
    notes.count("lines that are drawn twice taken once", len(strands) - len(kept))
    return kept


def _same(a: Strand, b: Strand, reach: float) -> bool:
    """Return whether the control points of two strands are the same within the reach."""
    other = [[*piece] for piece in b.pieces]
    backwards = [[*reversed(piece)] for piece in reversed(b.pieces)]
    return any(
        all(
            len(p) == len(q) and all(math.dist(s, t) <= reach for s, t in zip(p, q, strict=True))
            for p, q in zip(a.pieces, pieces, strict=True)
        )
        for pieces in (other, backwards)
    )


def _refuse_open(graph: Graph, how: Joining) -> None:
    """Raise an error if an end meets nothing."""
    open_ends = [
        (graph.strands[index], point)
        for node in graph.leaving.values()
        if len(node) == 1
        for index, backwards in node
        for point in (graph.begin(index, backwards),)
    ]
    if not open_ends:
        return
    (strand, point), *others = min(
        (_by_distance(open_ends, k) for k in range(min(len(open_ends), _COMPARED))),
        key=lambda found: math.dist(found[0][1], found[1][1]) if len(found) > 1 else math.inf,
    )
    hint = ""
    for other, q in others[:1]:
        gap = math.dist(point, q)
        hint = (
            f"; the nearest loose end, of {other.name} at {q!r}, is {gap:.9g} away"
            f" (--join {gap:.9g} joins ends so far apart)"
        )
    raise SceneError(f"outline is open{hint}", f"{how.place}, {strand.name}", f"at {point!r}")


_COMPARED = 1000
"""Number of loose ends of which the narrowest gap is looked for; bounds the time of a refusal."""


def _by_distance(ends: Sequence[tuple[Strand, Point]], k: int) -> list[tuple[Strand, Point]]:
    """Return an end and the nearest end of another strand, if there is any."""
    strand, point = ends[k]
    others = [end for end in ends if end[0] is not strand]
    if len(strand.pieces) > 1:  # a line's own ends enclose nothing
        others += [end for end in ends if end[0] is strand and end[1] != point]
    nearest = min(others, key=lambda end: math.dist(end[1], point), default=None)
    return [ends[k], *([nearest] if nearest else [])]
