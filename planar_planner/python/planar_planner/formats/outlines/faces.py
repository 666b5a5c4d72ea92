"""The region that rings bound, cut exactly into its faces at points of the input only.

The rings' edges are cut where vertices lie on them. Edges that occur equally often in both
directions bound nothing and are dropped. The rest is a planar graph. Its faces are traced by
turning sharply left at every vertex. The winding number of each face follows from its neighbour's:
it is one more to the left of an edge than to its right.
"""

from __future__ import annotations

import itertools
from collections import Counter, defaultdict, deque
from collections.abc import Sequence
from functools import cmp_to_key, partial

from planar_planner.errors import SceneError
from planar_planner.formats.outlines.exact import (
    contains,
    is_anticlockwise,
    orientation,
    strictly_between,
)
from planar_planner.formats.parts import Point, Ring, Shape

Edge = tuple[Point, Point]


def region_of(rings: Sequence[Ring], rule: str | None) -> list[Shape]:
    """Return the faces inside the rings as polygons, whose simple rings touch at most in points.

    Parameters
    ----------
    rings : sequence of Ring
        Rings without successive equal vertices.
    rule : {"evenodd", "nonzero"} or None
        The fill rule, which says what is inside. Without a rule both must agree.

    Raises
    ------
    SceneError
        If two edges cross, or the rules disagree and none is given.
    """
    jumps = _jumps(_cut(rings))
    walks = _walks(jumps)
    loops = [_simple_loops(walk) for walk in walks]
    outer = [next((r for r in parts if is_anticlockwise(r)), None) for parts in loops]
    home = _homes(loops, outer)
    winding = _windings(walks, jumps, home)
    shapes: list[Shape] = []
    for face, ring in enumerate(outer):
        if ring is None or not _inside(winding[face], rule, ring):
            continue
        holes = [r for r in loops[face] if r is not ring]
        for other, owner in enumerate(home):
            if owner == face and other != face:
                holes += loops[other]
        shapes.append([ring, *holes])
    return shapes


def _inside(winding: int, rule: str | None, ring: Ring) -> bool:
    if rule == "evenodd":
        return winding % 2 == 1
    if rule is None and winding != 0 and winding % 2 == 0:
        raise SceneError(
            "rings go round the same place more than once, so it is unclear what is inside",
            value=f"at {ring[0]!r}",
        )
    return winding != 0


def _cut(rings: Sequence[Ring]) -> list[Edge]:
    """Return the rings' directed edges, cut where a vertex lies on one."""
    edges = [edge for ring in rings for edge in zip(ring, ring[1:] + ring[:1], strict=True)]
    cuts: dict[int, set[Point]] = defaultdict(set)
    for i, j in _near_pairs(edges):
        _meet(edges, i, j, cuts)
    pieces: list[Edge] = []
    for i, (a, b) in enumerate(edges):
        inner = sorted(cuts[i], reverse=a > b) if i in cuts else []
        points = [a, *inner, b]
        pieces += itertools.pairwise(points)
    return pieces


def _near_pairs(edges: Sequence[Edge]) -> list[tuple[int, int]]:
    """Return the pairs i < j of edges whose bounding boxes meet."""
    import numpy as np
    import shapely

    ends = np.array(edges, dtype=np.float64)
    boxes = shapely.box(*ends.min(axis=1).T, *ends.max(axis=1).T)
    first, second = shapely.STRtree(boxes).query(boxes)
    return [(int(i), int(j)) for i, j in zip(first, second, strict=True) if i < j]


def _meet(edges: Sequence[Edge], i: int, j: int, cuts: dict[int, set[Point]]) -> None:
    """Record where two edges have to be cut, or raise `SceneError` if they cross."""
    (a, b), (c, d) = edges[i], edges[j]
    c_side, d_side = orientation(a, b, c), orientation(a, b, d)
    if c_side * d_side > 0:
        return
    a_side, b_side = orientation(c, d, a), orientation(c, d, b)
    if c_side * d_side < 0 and a_side * b_side < 0:
        raise SceneError("outline crosses itself", value=_crossing(a, b, c, d))
    for p, side in ((c, c_side), (d, d_side)):
        if side == 0 and strictly_between(a, b, p):
            cuts[i].add(p)
    for p, side in ((a, a_side), (b, b_side)):
        if side == 0 and strictly_between(c, d, p):
            cuts[j].add(p)


def _crossing(a: Point, b: Point, c: Point, d: Point) -> str:
    """Return the place where two segments cross, as text for people."""
    rx, ry, sx, sy = b[0] - a[0], b[1] - a[1], d[0] - c[0], d[1] - c[1]
    across = rx * sy - ry * sx
    t = ((c[0] - a[0]) * sy - (c[1] - a[1]) * sx) / across if across else 0.5
    return f"near ({a[0] + t * rx:.9g}, {a[1] + t * ry:.9g})"


def _jumps(edges: Sequence[Edge]) -> dict[Edge, int]:
    """Return for each edge how much larger the winding number is on its left than on its right.

    The result lists both directions of an edge, and no edges without a difference.
    """
    runs = Counter(edges)
    jumps: dict[Edge, int] = {}
    for (a, b), times in runs.items():
        jump = times - runs.get((b, a), 0)
        if jump:
            jumps[a, b] = jump
            jumps[b, a] = -jump
    return jumps


def _walks(jumps: dict[Edge, int]) -> list[list[Point]]:
    """Return the walks round all faces, each face to the left."""
    neighbours: dict[Point, list[Point]] = defaultdict(list)
    for a, b in jumps:
        neighbours[a].append(b)
    following: dict[Edge, Edge] = {}
    for centre, ends in neighbours.items():
        ordered = sorted(ends, key=cmp_to_key(partial(_by_angle, centre)))
        for k, end in enumerate(ordered):  # the edge after `end` → centre is the next clockwise
            following[end, centre] = (centre, ordered[k - 1])
    walks = []
    left = dict.fromkeys(jumps)
    while left:
        edge = first = next(iter(left))
        walk = []
        while True:
            del left[edge]
            walk.append(edge[0])
            edge = following[edge]
            if edge == first:
                break
        walks.append(walk)
    return walks


def _by_angle(centre: Point, p: Point, q: Point) -> int:
    """Compare two directions from a centre by their angle in [0, 2π); exact."""
    p_lower, q_lower = _is_lower(centre, p), _is_lower(centre, q)
    if p_lower != q_lower:
        return 1 if p_lower else -1
    return -orientation(centre, p, q)


def _is_lower(centre: Point, p: Point) -> bool:
    return p[1] < centre[1] or (p[1] == centre[1] and p[0] < centre[0])


def _simple_loops(walk: list[Point]) -> list[Ring]:
    """Cut a walk into loops that pass through no point twice."""
    loops: list[Ring] = []
    stack: list[Point] = []
    seen: set[Point] = set()
    for p in walk:
        if p in seen:
            start = stack.index(p)
            loops.append(stack[start:])
            seen.difference_update(stack[start + 1 :])
            del stack[start + 1 :]
        else:
            stack.append(p)
            seen.add(p)
    loops.append(stack)
    return loops


def _homes(loops: Sequence[list[Ring]], outer: Sequence[Ring | None]) -> list[int]:
    """Return the face that each walk bounds: its own, or the one that surrounds it; −1 outside."""
    boxes = [_bounds(ring) if ring is not None else None for ring in outer]
    homes = []
    for walk, ring in enumerate(outer):
        if ring is not None:
            homes.append(walk)
            continue
        points = {p for loop in loops[walk] for p in loop}
        p = min(points)
        best, best_box = -1, 0.0
        for face, candidate in enumerate(outer):
            box = boxes[face]
            if candidate is None or box is None:
                continue
            if not (box[0] < p[0] < box[2] and box[1] < p[1] < box[3]):
                continue
            if not points.isdisjoint(candidate) or not contains(candidate, p):
                continue
            extent = (box[2] - box[0]) * (box[3] - box[1])  # nested faces have nested boxes
            if best < 0 or extent < best_box:
                best, best_box = face, extent
        homes.append(best)
    return homes


def _bounds(ring: Ring) -> tuple[float, float, float, float]:
    xs, ys = zip(*ring, strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def _windings(
    walks: Sequence[list[Point]], jumps: dict[Edge, int], home: Sequence[int]
) -> dict[int, int]:
    """Return the winding number of each face, from outside inwards."""
    face_of: dict[Edge, int] = {}
    sides: dict[int, list[Edge]] = defaultdict(list)
    for walk, points in enumerate(walks):
        for edge in zip(points, points[1:] + points[:1], strict=True):
            face_of[edge] = home[walk]
            sides[home[walk]].append(edge)
    winding = {-1: 0}
    queue = deque([-1])
    while queue:
        face = queue.popleft()
        for a, b in sides[face]:
            beyond = face_of[b, a]
            if beyond not in winding:
                winding[beyond] = winding[face] - jumps[a, b]
                queue.append(beyond)
    return winding
