"""Whether the start's side is closed off (docs/certificate.md, "separation", step 3, Cover).

Here x and y are measured in 2^-DEEPEST_LEVEL of the domain's size, angles in 2^-DEEPEST_LEVEL of a
turn, so that every box is of whole numbers.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator
from itertools import chain
from typing import NamedTuple

from planar_planner import certificate_keys as keys
from planar_planner.checker.arithmetic import Rectangle, bounding_box, interiors_apart
from planar_planner.checker.demands import NO_DEADLINE, Deadline, demand
from planar_planner.checker.extents import THETA
from planar_planner.checker.form import DEEPEST_LEVEL
from planar_planner.checker.records import Box, Separation

WHOLE = 1 << DEEPEST_LEVEL
"""The domain's size, and a turn."""
AXIS_NAMES = ("x", "y", "theta")

LOW_END, HIGH_END = 0, 1


class Side(NamedTuple):
    """The plane of a face, and at which end of their box the faces there lie."""

    axis: int
    plane: int
    end: int

    def other(self) -> Side:
        """Return where the faces from beyond lie."""
        return self._replace(end=HIGH_END - self.end)


class Face(NamedTuple):
    """A face of a box: where it lies, and what it covers of its plane."""

    side: Side
    rectangle: Rectangle  # in the two other axes, in their order


def check_cover(separation: Separation, deadline: Deadline = NO_DEADLINE) -> None:
    """Check that every face of the start's side bounds the domain or is covered from beyond."""
    needs: dict[Side, set[Rectangle]] = defaultdict(set)
    covers: dict[Side, set[Rectangle]] = defaultdict(set)
    for side, rectangle in chain.from_iterable(map(faces_of, separation.start_side)):
        deadline.check()
        needs[side].add(rectangle)
        covers[side.other()].add(rectangle)
    for claim in separation.full:
        deadline.check()
        for side, rectangle in faces_of(claim.box):
            covers[side.other()].add(rectangle)
    for claim in separation.full_faces:
        deadline.check()
        for side, rectangle in faces_of(claim.box):
            if side.axis == claim.axis and side.end == LOW_END:  # its plane
                covers[side].add(rectangle)
                covers[side.other()].add(rectangle)
    for side, rectangles in needs.items():
        if side.axis != THETA and side.plane in (0, WHOLE):
            continue  # the domain's boundary
        known = covers[side]
        closed = covered(rectangles - known, known, (0, 0, WHOLE, WHOLE), deadline)
        place = f"{keys.START_SIDE}, {AXIS_NAMES[side.axis]} = {side.plane / WHOLE!r}"
        demand(closed, place, "has a face that is neither shared nor FULL")


def faces_of(box: Box) -> Iterator[Face]:
    """Yield the six faces of a box; turn 1 is turn 0."""
    spans = [(k << (DEEPEST_LEVEL - level), (k + 1) << (DEEPEST_LEVEL - level)) for level, k in box]
    for axis in range(3):
        (u0, u1), (v0, v1) = spans[:axis] + spans[axis + 1 :]
        for end, plane in zip((LOW_END, HIGH_END), spans[axis], strict=True):
            own = plane % WHOLE if axis == THETA else plane
            yield Face(Side(axis, own, end), (u0, v0, u1, v1))


def covered(
    needs: Iterable[Rectangle],
    covers: Iterable[Rectangle],
    cell: Rectangle,
    deadline: Deadline = NO_DEADLINE,
) -> bool:
    """Whether rectangles, as far as they are in a cell, lie in the union of others."""
    deadline.check()
    needs = [each for each in needs if not interiors_apart(each, cell)]
    covers = [each for each in covers if not interiors_apart(each, cell)]
    if not needs or any(holds(cover, cell) for cover in covers):
        return True
    if not covers:
        return False
    return all(covered(needs, covers, half, deadline) for half in halves(cell, needs + covers))


def holds(outer: Rectangle, inner: Rectangle) -> bool:
    """Whether a rectangle holds another."""
    return bounding_box((outer[:2], outer[2:], inner[:2], inner[2:])) == outer


def halves(cell: Rectangle, rectangles: list[Rectangle]) -> tuple[Rectangle, Rectangle]:
    """Cut a cell at the middle one of the sides of rectangles that cross it.

    There are such sides: one of the rectangles meets the cell and does not hold it.
    """
    xmin, ymin, xmax, ymax = cell
    xs = sorted({x for each in rectangles for x in each[0::2] if xmin < x < xmax})
    ys = sorted({y for each in rectangles for y in each[1::2] if ymin < y < ymax})
    if len(xs) > len(ys):
        x = xs[len(xs) // 2]
        return (xmin, ymin, x, ymax), (x, ymin, xmax, ymax)
    y = ys[len(ys) // 2]
    return (xmin, ymin, xmax, y), (xmin, y, xmax, ymax)
