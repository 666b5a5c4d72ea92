r"""A polygon shrunk by a distance, between an inner and an outer body.

A - s is the set of the points of the polygon A whose distance from the complement of A is at least
s. The candidate P is A minus a circumscribed polygon round every edge (`rounded_hull`), computed by
GEOS. No claim relies on GEOS; two claims about the candidate's doubles are established.

- *P is inside A - s for s up to `shallow`.* No edge of P crosses one of A (exact, by the
  decomposition of the region between them), P has a vertex of each ring inside A and no ring of A
  is inside P (exact), so P is inside A; and no point of P's boundary is nearer to A's boundary than
  `shallow`. Two boundaries that do not cross are nearest at a vertex of one of them. If a point of
  P were nearer to the complement of A, a point of P's boundary on the way there would be too.
- *A - s is inside P for s above `deep`.* The region A \ P is cut into triangles, exactly, and
  these until for each one edge of A has all three corners within `deep`. The distance from an edge,
  a convex set, is a convex function, greatest at a corner; so every point of A \ P is within `deep`
  of A's boundary. Halving a triangle at a rounded midpoint loses at most a sliver of that
  rounding, u M at each of at most `DEPTH` levels, which `deep` includes.

P may be empty: the second claim then says that no disc of radius above `deep` fits.
"""

from __future__ import annotations

import numpy as np
import shapely
from numpy.typing import NDArray

import pdg
from planar_planner.margins.body import UNIT_ROUNDOFF, ClaimError, Floats, Rings
from planar_planner.margins.rounded_hull import circumscribed
from planar_planner.margins.segments import distances, edges_of, inside_ring, rounding_of

DEPTH = 60
"""Most halvings of a triangle: twice as many as shrink any triangle to a rounding error of its own
size; beyond this the claim fails."""

MOST_TRIANGLES = 2**16
"""Most triangles of one level; with more the test takes too long, and the claim fails."""

BLOCKS = 16
"""Number of blocks in which the triangles of a level are tested, which bounds memory."""

Shapes = list[list[Floats]]


def eroded(shape: Rings, depth: float, excess: float) -> Shapes:
    """Return a candidate for the polygon shrunk by `depth` to ``depth + excess``.

    Parameters
    ----------
    shape : sequence of (n, 2)
        Outer ring and holes, of any orientation.
    depth, excess : float
        Positive lengths.
    """
    start, end = edges_of(shape)
    rims = [
        shapely.Polygon(circumscribed(np.array([a, b]), depth, excess))
        for a, b in zip(start, end, strict=True)
    ]
    body = shapely.Polygon(shape[0], shape[1:])
    left = body.difference(shapely.union_all(rims))
    parts = [part for part in shapely.get_parts(left) if isinstance(part, shapely.Polygon)]
    return [
        [
            np.array(ring.coords)[:-1]
            for ring in (part.exterior, *part.interiors)
            if shapely.Polygon(ring).area > 0.0
        ]
        for part in parts
        if part.area > 0.0
    ]


def depths(shape: Rings, parts: Shapes, deep: float) -> tuple[float, float]:
    """Return (shallow, deep) of a candidate: A - deep' is inside it for deep' > deep, rounded up.

    Raises
    ------
    ClaimError
        If the candidate is not inside the polygon, or leaves out more than `deep` accounts for.
    """
    rings = [ring for part in parts for ring in part]
    shallow = _shallow(shape, rings) if rings else 0.0
    start, end = edges_of(shape)
    slack = rounding_of(start) + DEPTH * UNIT_ROUNDOFF * float(np.abs(start).max())
    _check_near(_triangles([*shape, *rings]), start, end, deep)
    return shallow, deep + slack


def _shallow(shape: Rings, rings: list[Floats]) -> float:
    """Return the distance of P's boundary from A's, rounded down, after a check that P is in A."""
    for ring in rings:
        if sum(inside_ring(ring[0], outline) for outline in shape) % 2 == 0:
            raise ClaimError("the shrunk body is not inside the robot")
    for outline in shape:
        if sum(inside_ring(outline[0], ring) for ring in rings) % 2 == 1:
            raise ClaimError("the shrunk body fills a hole of the robot")
    a, b = edges_of(shape)
    p, q = edges_of(rings)
    least = min(
        *(float(block.min()) for block in distances(p, a, b)),
        *(float(block.min()) for block in distances(a, p, q)),
    )
    shallow = least - rounding_of(a, p)
    if not shallow > 0.0:
        raise ClaimError("the shrunk body touches the robot's outline")
    return shallow


def _triangles(rings: list[Floats]) -> Floats:
    """Return triangles (n, 3, 2) that cover the even-odd interior of rings that do not cross."""
    try:
        pieces = pdg.even_odd_pieces(rings, cover=False)
    except pdg.BodyError as error:
        raise ClaimError(f"the shrunk body crosses the robot's outline: {error.problem}") from None
    fans = [
        np.stack([np.repeat(piece[:1], len(piece) - 2, axis=0), piece[1:-1], piece[2:]], axis=1)
        for piece in pieces
    ]
    return np.concatenate(fans)


def _check_near(triangles: Floats, start: Floats, end: Floats, deep: float) -> None:
    """Check that each triangle can be cut into triangles that each have an edge within `deep`."""
    for _ in range(DEPTH):
        far = [_far(some, start, end, deep) for some in np.array_split(triangles, BLOCKS)]
        triangles = _halved(triangles[np.concatenate(far)])
        if len(triangles) == 0:
            return
        if len(triangles) > MOST_TRIANGLES:
            break
    raise ClaimError("it is undecided whether the shrunk body leaves out more than its depth")


def _far(triangles: Floats, start: Floats, end: Floats, deep: float) -> NDArray[np.bool_]:
    """Return which triangles have no edge within `deep` of all three corners."""
    rows = list(distances(triangles.reshape(-1, 2), start, end))
    if not rows:
        return np.empty(0, dtype=np.bool_)
    corners = np.concatenate(rows)
    if (corners.min(axis=1) > deep).any():
        raise ClaimError("the shrunk body leaves out more than its depth")
    far: NDArray[np.bool_] = corners.reshape(-1, 3, len(start)).max(axis=1).min(axis=1) > deep
    return far


def _halved(triangles: Floats) -> Floats:
    """Halve each triangle at its longest side."""
    sides = np.roll(triangles, -1, axis=1) - triangles
    longest = np.hypot(sides[..., 0], sides[..., 1]).argmax(axis=1)
    rows = np.arange(len(triangles))
    a, b, c = (triangles[rows, (longest + k) % 3] for k in range(3))
    m = 0.5 * (a + b)
    return np.concatenate([np.stack([a, m, c], axis=1), np.stack([m, b, c], axis=1)])
