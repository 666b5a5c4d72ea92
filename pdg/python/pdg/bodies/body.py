"""What a caller may give as a body."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Protocol

from pdg.aliases import RealArray, Rows
from pdg.bodies.piece_set import ConvexPieces


class GeoInterface(Protocol):
    """A geometry of any package that describes itself as GeoJSON, as those of shapely do."""

    @property
    def __geo_interface__(self) -> Mapping[str, object]:
        """The geometry as a GeoJSON object."""


Shape = ConvexPieces | GeoInterface | Mapping[str, object] | str | bytes | RealArray | Rows
"""Convex pieces, a geometry, GeoJSON as a mapping or as text, WKT, WKB, or the coordinates of one
ring, of shape (n, 2)."""

Body = Shape | Sequence[Shape]
"""A body: a shape, or a sequence of shapes, whose union it is. See `pdg.convex_pieces`."""
