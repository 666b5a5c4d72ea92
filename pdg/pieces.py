"""Exact convex pieces of polygons."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from pdg import _core, _gate
from pdg.errors import PdgError

if TYPE_CHECKING:
    from numpy.typing import NDArray


@dataclass(frozen=True, slots=True)
class ConvexPieces:
    """The convex pieces of a body, ready for repeated queries.

    Iterating gives each piece's vertices, an (n, 2) array, counter-clockwise and strictly convex.
    Every function that takes a body takes one of these too, and then decomposes nothing.
    """

    core: _core.PieceSet = field(repr=False)

    def __len__(self) -> int:
        return len(self.core)

    def __iter__(self) -> Iterator[NDArray[np.float64]]:
        coords, starts = self.core.arrays()
        return (coords[starts[i] : starts[i + 1]] for i in range(len(self)))

    @property
    def radius(self) -> float:
        """Largest distance of the body from its frame origin, rounded up (length)."""
        return self.core.radius

    @property
    def radii(self) -> tuple[float, ...]:
        """The same for each piece."""
        return tuple(self.core.radii())


def convex_pieces(body: Any, *, cover: bool = True, name: str = "body") -> ConvexPieces:
    """Decompose polygons into convex pieces, exactly and without new vertices.

    Parameters
    ----------
    body : array_like of shape (n, 2), shapely geometry, GeoJSON-like mapping or WKT
        One ring, or a Polygon or MultiPolygon with or without holes. Rings may have either
        orientation, collinear and repeated vertices, and may touch in points.
    cover : bool
        True: a cover; each piece is grown as far as convexity allows and pieces may overlap.
        False: a partition; interiors are disjoint.
    name : str
        What errors call the argument.

    Returns
    -------
    ConvexPieces
        Their union is the body exactly; every vertex is an input vertex. A convex polygon is its
        own single piece.

    Raises
    ------
    PdgError
        For rings of fewer than three distinct points, non-finite coordinates, edges that cross,
        holes outside their shell, and bodies without area.
    """
    if isinstance(body, ConvexPieces):
        return body
    polygons = _gate.polygons(body, name)
    rings = [ring for polygon in polygons for ring in polygon]
    try:
        core = _core.PieceSet(
            np.concatenate(rings),
            _starts(len(ring) for ring in rings),
            _starts(len(polygon) for polygon in polygons),
            cover,
        )
    except ValueError as error:
        raise PdgError(str(error), name) from error
    if len(core) == 0:
        raise PdgError("the polygon has no area", name)
    return ConvexPieces(core)


def one_convex_piece(body: Any, name: str) -> ConvexPieces:
    """Return the body, which must be convex, as its single piece."""
    pieces = convex_pieces(body, name=name)
    if len(pieces) != 1:
        problem = "not convex; see generalized_depth_lower_bound"
        raise PdgError(problem, name, value=f"{len(pieces)} convex pieces")
    return pieces


def _starts(counts: Iterator[int]) -> NDArray[np.uint32]:
    return np.cumsum([0, *counts], dtype=np.uint32)
