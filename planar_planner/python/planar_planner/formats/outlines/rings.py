"""The repair of rings: valid polygons of exactly the same region, or the place of a defect.

Repeated vertices and zero-length edges are dropped. Rings that touch themselves or each other, and
edges that occur twice in opposite directions (a bridge from a hole to its outer ring), are cut into
simple rings at points that the file itself states. Rings that cross are refused, because they need
a computed point, and in general no double is that point.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from planar_planner.errors import SceneError
from planar_planner.formats.outlines.exact import convex_turn, is_anticlockwise
from planar_planner.formats.outlines.faces import region_of
from planar_planner.formats.parts import Notes, Ring, Shape
from planar_planner.problem.rings import judged_exactly
from planar_planner.scene.input_limits import MAX_COORDINATE, MIN_COORDINATE
from planar_planner.scene.raw_polygons import RawPolygons

MIN_RING = 3
_SMALL = 64
"""Vertices of a ring up to which convexity is looked at first: most drawings have many such."""


def without_repeats(ring: Ring) -> Ring:
    """Return the ring without vertices that equal their cyclic successor."""
    return [p for p, q in zip(ring, ring[1:] + ring[:1], strict=True) if p != q]


def convex_ring(ring: Ring) -> int:
    """Return 1 or −1 if a ring plainly is valid, being small, strictly convex and in range.

    The sign is that of its turn: 1 for an anticlockwise ring. Other rings, valid or not, give 0.
    """
    if not MIN_RING <= len(ring) <= _SMALL:
        return 0
    in_range = all(v == 0 or MIN_COORDINATE <= abs(v) <= MAX_COORDINATE for p in ring for v in p)
    return convex_turn(ring) if in_range else 0


def polygons_of(
    rings: Sequence[Ring], place: str, notes: Notes, rule: str | None = None
) -> list[Shape]:
    """Return the polygons that a figure's rings bound, of any orientation.

    Parameters
    ----------
    rings : sequence of Ring
        Rings of one figure: an outer ring and holes, or the subpaths of a drawing.
    place : str
        Place of the figure in its file, for messages.
    notes : Notes
        Receives a note on every change.
    rule : {"evenodd", "nonzero"}, optional
        The fill rule where rings go round a point more than once. Without a rule both must agree.

    Raises
    ------
    SceneError
        If rings cross, or the two rules disagree and none is given; without a source.
    """
    clean: list[Ring] = []
    for ring in rings:
        kept = without_repeats(ring)
        dropped = len(ring) - len(kept)
        if ring and ring[0] == ring[-1]:
            dropped -= 1  # the repeated last vertex closes the ring and is not a defect
        notes.count("repeated vertices dropped", max(dropped, 0))
        if len(set(kept)) < MIN_RING:
            notes.count("rings without area dropped")
        else:
            clean.append(kept)
    if not clean:
        notes.passed_over += 1
        return []
    if _reads_as_written(clean, rule) and _is_valid(clean):
        return [clean]
    try:
        shapes = region_of(clean, rule)
    except SceneError as error:
        raise SceneError(error.problem, place, error.value) from None
    if not shapes:
        notes.passed_over += 1
        notes.count("rings without area dropped", len(clean))
    elif len(clean) > 1 or len(shapes) > 1 or sum(map(len, shapes)) > 1:
        notes.count("figures cut into simple rings where they touch themselves, region unchanged")
    else:
        notes.count("spikes without area cut off", 1)
    return shapes


def _reads_as_written(rings: list[Ring], rule: str | None) -> bool:
    """Return whether the rings mean an outer ring with holes, as a polygon is written.

    They do by the even–odd rule; by the other rule they do if the holes have the opposite
    orientation to the outer ring.
    """
    if len(rings) == 1 or rule == "evenodd":
        return True
    outer = is_anticlockwise(rings[0])
    return all(is_anticlockwise(ring) != outer for ring in rings[1:])


def _is_valid(shape: Shape) -> bool:
    """Return whether the rings, the outer one first, are a valid polygon; exact."""
    if len(shape) == 1 and convex_ring(shape[0]):
        return True
    coords = np.array([p for ring in shape for p in ring], dtype=np.float64)
    starts = np.cumsum([0, *map(len, shape)]).astype(np.uint32)
    polygons = RawPolygons(
        coords,
        starts,
        np.array([0, len(shape)], dtype=np.uint32),
        ("",),
        np.zeros(1, dtype=np.uint32),
    )
    return judged_exactly(polygons) is None
