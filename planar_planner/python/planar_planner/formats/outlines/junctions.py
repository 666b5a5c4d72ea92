"""Places where more than two lines of a drawing meet, and outer boundaries of what hangs together.

ezdxf's edgeminer orders edges at a junction by their chords, which misleads where arcs meet, and
does not cut lines where others end on them. Here the order is that of the tangents.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import replace

from planar_planner.errors import SceneError
from planar_planner.formats.outlines.curves import (
    Piece,
    first_point,
    last_point,
    reversed_piece,
    straight,
)
from planar_planner.formats.outlines.strands import Ends, Strand, end_point, is_closed
from planar_planner.formats.parts import Point

Half = tuple[int, bool]
"""A strand's index, and whether it is passed backwards."""
Walk = list[Half]


class Graph:
    """Strands between nodes. `leaving` lists what leaves each node."""

    def __init__(self, strands: Sequence[Strand], ends: Ends) -> None:
        self.strands = strands
        self.ends = ends
        self.leaving: dict[int, list[Half]] = defaultdict(list)
        for k in range(len(strands)):
            self.leaving[ends.node(k, end=False)].append((k, False))
            self.leaving[ends.node(k, end=True)].append((k, True))

    def begin(self, index: int, backwards: bool) -> Point:
        """Return where a strand begins if it is passed in a direction."""
        return end_point(self.strands[index], end=backwards)


# ---- ends on lines ----------------------------------------------------------------------------


def cut_where_ends_meet(
    loose: list[Strand], closed: list[Strand], reach: float
) -> tuple[list[Strand], list[Strand]]:
    """Cut strands where ends lie on their straight lines.

    Ends that meet no other end cut any line; ends that do, only lines that they run along.

    Returns
    -------
    loose, closed : list of Strand
        The same lines; closed strands that are cut are among the loose ones.
    """
    strands = [*loose, *closed]
    ends = Ends(loose, reach)
    free = {(k, end) for k, end, _ in ends.free(loose)}
    both = [(k, end, (k, end) in free) for k in range(len(loose)) for end in (False, True)]
    cuts = _cuts(strands, both, reach)
    if not cuts:
        return loose, closed
    kept_loose: list[Strand] = []
    kept_closed: list[Strand] = []
    for k, strand in enumerate(strands):
        parts = list(_parted(strand, cuts[k], reach)) if k in cuts else [strand]
        whole = k not in cuts and is_closed(strand)
        (kept_closed if whole else kept_loose).extend(parts)
    return kept_loose, kept_closed


def _cuts(
    strands: Sequence[Strand], ends: Sequence[tuple[int, bool, bool]], reach: float
) -> dict[int, list[tuple[int, float, Point]]]:
    """Return for each strand (piece, share of its length, point) of the ends that cut it.

    `ends` lists (strand, whether its end, whether it meets no other end).
    """
    import shapely

    lines = [
        (k, i, piece)
        for k, strand in enumerate(strands)
        for i, piece in enumerate(strand.pieces)
        if len(piece) == 2
    ]
    cuts: dict[int, list[tuple[int, float, Point]]] = defaultdict(list)
    if not lines or not ends:
        return cuts
    tree = shapely.STRtree(
        shapely.linestrings([[first_point(p), last_point(p)] for _, _, p in lines])
    )
    points = [end_point(strands[k], end=end) for k, end, _ in ends]
    which, near = tree.query(shapely.points(points), predicate="dwithin", distance=reach)
    found: dict[int, list[tuple[int, int, Piece]]] = defaultdict(list)
    for n, line in zip(which.tolist(), near.tolist(), strict=True):
        found[n].append(lines[line])
    for n, candidates in found.items():
        own, end, free = ends[n]
        p = points[n]
        others = [line for line in candidates if line[0] != own]
        if free:
            others = sorted(others, key=lambda line: _distance(line[2], p))[:1]
        for k, i, piece in others:
            if free or _runs_along(strands[own], end, piece, reach):
                cuts[k].append((i, _share(piece, p), p))
    return cuts


def _runs_along(strand: Strand, end: bool, line: Piece, reach: float) -> bool:
    """Return whether a strand's straight end piece covers a part of a line on which it ends."""
    piece = strand.pieces[-1] if end else strand.pieces[0]
    if len(piece) > 2:
        return False
    p, q = last_point(piece), first_point(piece)
    p, q = (p, q) if end else (q, p)
    begin, finish = first_point(line), last_point(line)
    if min(math.dist(p, begin), math.dist(p, finish)) <= reach:
        return False
    towards = finish if _share(line, q) > _share(line, p) else begin
    return _distance(line, q) <= reach or _distance(piece, towards) <= reach


def _share(piece: Piece, p: Point) -> float:
    """Return where on a line a point is nearest, 0 at its beginning and 1 at its end."""
    (ax, ay), (bx, by) = first_point(piece), last_point(piece)
    square = (bx - ax) ** 2 + (by - ay) ** 2
    share = ((p[0] - ax) * (bx - ax) + (p[1] - ay) * (by - ay)) / square if square else 0.0
    return min(1.0, max(0.0, share))


def _distance(piece: Piece, p: Point) -> float:
    (ax, ay), (bx, by) = first_point(piece), last_point(piece)
    t = _share(piece, p)
    return math.dist(p, (ax + t * (bx - ax), ay + t * (by - ay)))


def _parted(strand: Strand, cuts: list[tuple[int, float, Point]], reach: float) -> Iterator[Strand]:
    """Yield a strand's parts between cuts; the first and last part of a closed one are one."""
    parts: list[list[Piece]] = [[]]
    for i, piece in enumerate(strand.pieces):
        begin, end = first_point(piece), last_point(piece)
        for _, share, p in sorted(cut for cut in cuts if cut[0] == i):
            if share < 1 and math.dist(p, begin) > reach and math.dist(p, end) > reach:
                parts[-1].append(straight(begin, p))
                begin = p
                parts.append([])
            elif math.dist(p, begin) <= math.dist(p, end):
                parts.append([])
        parts[-1].append(straight(begin, end) if len(piece) == 2 else piece)
        if any(cut[0] == i and math.dist(cut[2], end) <= reach for cut in cuts):
            parts.append([])
    if is_closed(strand) and len(parts) > 1:
        parts[0] = [*parts.pop(), *parts[0]]
    for part in parts:
        if part:
            yield replace(strand, pieces=part)


# ---- outer boundaries -------------------------------------------------------------------------


def boundaries(graph: Graph, place: str) -> Iterator[Walk]:
    """Yield the outer boundary of each connected part of a graph.

    Raises
    ------
    SceneError
        If a line has nothing but the outside on both sides, or lines leave a junction in one
        direction.
    """
    walks = _walks(_following(graph, place))
    side = {half: k for k, walk in enumerate(walks) for half in walk}
    for group in _hanging_together(walks, side):
        # the walk round the outside is clockwise; a simple loop is the same from both sides
        outer = group[0] if len(group) <= 2 else min(group, key=lambda k: _area(walks[k], graph))
        for index, backwards in walks[outer]:
            if side[index, not backwards] == outer:
                raise SceneError(
                    "joins outlines, or is one, but bounds nothing",
                    f"{place}, {graph.strands[index].name}",
                    f"at {graph.begin(index, backwards)!r}",
                )
        yield walks[outer]


def _hanging_together(walks: list[Walk], side: dict[Half, int]) -> Iterator[list[int]]:
    """Yield the walks in groups that share strands."""
    left = dict.fromkeys(range(len(walks)))
    while left:
        group = [next(iter(left))]
        del left[group[0]]
        for k in group:  # grows while it is passed
            for index, backwards in walks[k]:
                beyond = side[index, not backwards]
                if beyond in left:
                    del left[beyond]
                    group.append(beyond)
        yield group


def _area(walk: Walk, graph: Graph) -> float:
    """Return twice the area that a walk goes round anticlockwise, by its control points."""
    points = [
        (x / w, y / w)
        for index, back in walk
        for piece in _passed(graph.strands[index], back)
        for x, y, w in piece
    ]
    x0, y0 = points[0]
    return sum(
        (a[0] - x0) * (b[1] - y0) - (b[0] - x0) * (a[1] - y0)
        for a, b in zip(points, points[1:] + points[:1], strict=True)
    )


def _passed(strand: Strand, backwards: bool) -> list[Piece]:
    if not backwards:
        return strand.pieces
    return [reversed_piece(piece) for piece in reversed(strand.pieces)]


def _following(graph: Graph, place: str) -> dict[Half, Half]:
    """Return what follows each strand on the boundary of the face to its left."""
    following: dict[Half, Half] = {}
    for halves in graph.leaving.values():
        ordered = halves
        if len(halves) > 2:
            angles = {half: _direction(graph, half) for half in halves}
            ordered = sorted(halves, key=angles.__getitem__)
            if len(set(angles.values())) < len(halves):
                where = graph.begin(*ordered[0])
                raise SceneError("has lines that leave a junction side by side", place, f"{where}")
        for k, (index, backwards) in enumerate(ordered):
            following[index, not backwards] = ordered[k - 1]
    return following


def _direction(graph: Graph, half: Half) -> float:
    """Return the angle in which a strand leaves its beginning."""
    pieces = _passed(graph.strands[half[0]], half[1])
    x0, y0 = first_point(pieces[0])
    for x, y, w in pieces[0][1:]:
        if (x / w, y / w) != (x0, y0):
            return math.atan2(y / w - y0, x / w - x0)
    return 0.0


def _walks(following: dict[Half, Half]) -> list[Walk]:
    walks: list[Walk] = []
    left = dict.fromkeys(following)
    while left:
        half = next(iter(left))
        walk: Walk = []
        while half in left:
            del left[half]
            walk.append(half)
            half = following[half]
        walks.append(walk)
    return walks
