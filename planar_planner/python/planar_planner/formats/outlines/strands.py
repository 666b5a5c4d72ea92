"""Strands: what one entity of a drawing draws, and the nodes where the ends of strands meet."""

from __future__ import annotations

import math
from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from planar_planner.formats.outlines.curves import Outline, Piece, first_point, last_point
from planar_planner.formats.parts import Point

Run = list[Piece]


@dataclass(frozen=True)
class Strand:
    """Pieces of which each begins where the one before ends, and the entity that draws them."""

    pieces: Run
    name: str


@dataclass(frozen=True)
class Traced:
    """A closed outline and the entities that draw it."""

    outline: Outline
    names: tuple[str, ...]


def is_closed(strand: Strand) -> bool:
    """Return whether a strand ends where it begins."""
    return first_point(strand.pieces[0]) == last_point(strand.pieces[-1])


def span(strand: Strand) -> float:
    """Return how far a strand's control points are from its beginning at most."""
    begin = first_point(strand.pieces[0])
    return max(math.dist((x / w, y / w), begin) for piece in strand.pieces for x, y, w in piece)


def end_point(strand: Strand, *, end: bool) -> Point:
    """Return where a strand begins or ends."""
    return last_point(strand.pieces[-1]) if end else first_point(strand.pieces[0])


class Ends:
    """Nodes: groups of strands' ends of which each is within the reach of another."""

    def __init__(self, strands: Sequence[Strand], reach: float) -> None:
        self._leader = list(range(2 * len(strands)))
        self._reach = reach
        cells: dict[tuple[int, int], list[tuple[int, Point]]] = defaultdict(list)
        for k, strand in enumerate(strands):
            for end in (False, True):
                p = end_point(strand, end=end)
                own = 2 * k + end
                for other, q in self._near(cells, p):
                    if math.dist(p, q) <= reach:
                        a, b = self._find(own), self._find(other)
                        self._leader[max(a, b)] = min(a, b)
                cells[self._key(p)].append((own, p))

    def free(self, strands: Sequence[Strand]) -> list[tuple[int, bool, Point]]:
        """Return (strand, whether its end, point) of the ends that meet no other."""
        both = [(k, end) for k in range(len(strands)) for end in (False, True)]
        degrees = Counter(self.node(k, end=end) for k, end in both)
        return [
            (k, end, end_point(strands[k], end=end))
            for k, end in both
            if degrees[self.node(k, end=end)] == 1
        ]

    def pair_free(self, strands: Sequence[Strand], farthest: float) -> None:
        """Let free ends meet in pairs, the nearest first, up to a distance."""
        import shapely

        free = self.free(strands)
        if len(free) < 2:
            return
        points = shapely.points([p for _, _, p in free])
        first, second = shapely.STRtree(points).query(
            points, predicate="dwithin", distance=farthest
        )
        pairs = sorted(
            (math.dist(free[i][2], free[j][2]), i, j)
            for i, j in zip(first.tolist(), second.tolist(), strict=True)
            if i < j
        )
        taken: set[int] = set()
        for _, i, j in pairs:
            (k, end, _), (m, other, _) = free[i], free[j]
            if i in taken or j in taken or (k == m and len(strands[k].pieces) == 1):
                continue  # the two ends of one line enclose nothing
            taken |= {i, j}
            a, b = self._find(2 * k + end), self._find(2 * m + other)
            self._leader[max(a, b)] = min(a, b)

    def node(self, strand: int, *, end: bool) -> int:
        """Return the number of the node where a strand begins or ends."""
        return self._find(2 * strand + end)

    def _key(self, p: Point) -> tuple[int, int]:
        return math.floor(p[0] / self._reach), math.floor(p[1] / self._reach)

    def _near(
        self, cells: dict[tuple[int, int], list[tuple[int, Point]]], p: Point
    ) -> Iterator[tuple[int, Point]]:
        i, j = self._key(p)
        for di in (-1, 0, 1):
            for dj in (-1, 0, 1):
                yield from cells.get((i + di, j + dj), ())

    def _find(self, i: int) -> int:
        while self._leader[i] != i:
            self._leader[i] = self._leader[self._leader[i]]
            i = self._leader[i]
        return i
