"""Exact convex pieces of polygons."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from pdg import _gate
from pdg.aliases import RealArray, Rows
from pdg.bodies import shapes
from pdg.bodies.body import Body
from pdg.bodies.defects import polygon_defect
from pdg.bodies.piece_set import ConvexPieces, decompose
from pdg.errors import BodyError, PdgError


def convex_pieces(body: Body, *, cover: bool = True, name: str = "body") -> ConvexPieces:
    """Decompose polygons into convex pieces, exactly and without new vertices.

    Parameters
    ----------
    body : Body
        Coordinates of shape (n, 2), anything shapely reads, ConvexPieces, or a list of these.
        One ring as coordinates; a shapely Polygon, MultiPolygon, LinearRing or GeometryCollection
        of polygons; WKT; WKB (bytes or hexadecimal); GeoJSON as text, mapping or by
        ``__geo_interface__``. A list (or an array of shape (k, n, 2)) is the union of its items.
        Rings may have either orientation, collinear and repeated vertices, and may touch in
        points. A ring that runs back along edges of its own is taken by the even-odd rule: what it
        runs along twice bounds nothing. Polygons of one body may overlap; ConvexPieces in a list
        are taken piece by piece.
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
    BodyError
        For rings of fewer than three distinct points, coordinates that are not finite or out of
        range, edges that cross, holes outside their shell, z coordinates, and bodies without area.
    PdgError
        For a `cover` that is not a bool.
    """
    whole = _gate.flag(cover, "cover")
    if isinstance(body, ConvexPieces):
        return body
    polygons = shapes.polygons(body, name)
    _check_holes(polygons, name)
    return _decomposed(polygons, whole, name)


def even_odd_pieces(
    rings: Sequence[RealArray | Rows], *, cover: bool = True, name: str = "rings"
) -> ConvexPieces:
    """Decompose what an odd number of rings surrounds into convex pieces, exactly.

    Rings may lie in any order and in each other, an island in a hole included; `convex_pieces`
    takes a polygon's outer ring first and refuses such holes.

    Parameters
    ----------
    rings : sequence of array_like of shape (n, 2)
        At least one. Rings may have either orientation, collinear and repeated vertices, and may
        touch in points; edges must not cross.
    cover, name : optional
        As for `convex_pieces`.

    Returns
    -------
    ConvexPieces
        Their union is the region exactly; every vertex is an input vertex.

    Raises
    ------
    BodyError
        For rings of fewer than three distinct points, coordinates that are not finite or out of
        range, edges that cross, and a region without area.
    PdgError
        For no rings, and a `cover` that is not a bool.
    """
    whole = _gate.flag(cover, "cover")
    checked = [_gate.ring(ring, f"{name}[{i}]") for i, ring in enumerate(_gate.items(rings, name))]
    if not checked:
        raise PdgError("at least one ring is needed", name)
    return _decomposed([checked], whole, name)


def _decomposed(polygons: list[shapes.Rings], cover: bool, name: str) -> ConvexPieces:
    try:
        pieces = decompose(*_flat(polygons), cover)
    except ValueError as error:
        raise BodyError(str(error), name) from error
    if len(pieces) == 0:
        raise BodyError("the polygon has no area", name)
    return pieces


def _check_holes(polygons: list[shapes.Rings], name: str) -> None:
    """Refuse what the core, which takes the even-odd interior, would misread: stray holes."""
    with_holes = [polygon for polygon in polygons if len(polygon) > 1]
    if with_holes and (defect := polygon_defect(*_flat(with_holes))) is not None:
        raise BodyError(f"invalid polygon: {defect}", name)


def _flat(
    polygons: list[shapes.Rings],
) -> tuple[NDArray[np.float64], NDArray[np.uint32], NDArray[np.uint32]]:
    """Return all coordinates, where each ring starts, and with which ring each polygon starts."""
    rings = [ring for polygon in polygons for ring in polygon]
    return (
        np.concatenate(rings),
        _starts(len(ring) for ring in rings),
        _starts(len(polygon) for polygon in polygons),
    )


def _starts(counts: Iterator[int]) -> NDArray[np.uint32]:
    return np.cumsum([0, *counts], dtype=np.uint32)
