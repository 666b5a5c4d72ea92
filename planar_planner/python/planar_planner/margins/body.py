"""Bodies that represent a grown or shrunk robot, each with the range of sizes that it bounds.

A family of bodies A(m) grows with m: A(m) is a subset of A(m') for m <= m'. A `Body` P states
A(inner) subset of P subset of A(outer). So a path for P is a path for the robot at `inner`, and a
proof that P has no path is a proof for the robot at `outer`: both verdicts of a query are useful.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from pdg import polygon_defect
from planar_planner.problem.make import Polygons

Floats = NDArray[np.float64]
Rings = Sequence[Floats]

UNIT_ROUNDOFF = 2.0**-53
"""u: the relative error of a rounded operation."""


class ClaimError(Exception):
    """The inclusions that a body claims could not be established."""


@dataclass(frozen=True, eq=False)
class Body:
    """A polygonal body between two members of a family.

    Attributes
    ----------
    polygons : Polygons or None
        Polygons in the robot's frame, which may overlap; the body is their union. None if no area
        is left.
    inner, outer : float
        A(inner) is inside the body up to a set without area, and the body is inside A(outer).
    """

    polygons: Polygons | None
    inner: float
    outer: float


class Family(Protocol):
    """Bodies that grow with a parameter, the margin."""

    @property
    def neutral(self) -> float:
        """The parameter of the robot at its own size."""

    @property
    def vanishing(self) -> float:
        """A parameter at which the robot has no area, so that everything is free."""

    @property
    def monotone(self) -> bool:
        """Whether the bodies grow; if not, ``inner == outer`` is the parameter itself."""

    def between(self, low: float, high: float) -> Body:
        """Return a body with low < inner <= outer < high, about in the middle."""

    def raised(self, body: Body, clearance: float) -> float:
        """Return the parameter up to which a path holds that has this clearance for `body`."""


def polygons_of(shapes: Sequence[Rings]) -> Polygons:
    """Return polygons, each its outer ring and then its holes, in the core's form.

    Raises
    ------
    ClaimError
        If a polygon is not simple for the exact doubles; rounding can cause this for bodies that
        are small or hardly differ from the robot.
    """
    rings = [ring for shape in shapes for ring in shape]
    polygons = Polygons(
        np.ascontiguousarray(np.concatenate(rings)),
        np.cumsum([0, *map(len, rings)], dtype=np.uint32),
        np.cumsum([0, *map(len, shapes)], dtype=np.uint32),
    )
    defect = polygon_defect(*polygons.arrays)
    if defect is not None:
        raise ClaimError(f"the width of the bracket is below what rounding allows: {defect}")
    return polygons


def shapes_of(polygons: Polygons) -> list[list[Floats]]:
    """Return each polygon's rings."""
    rings = polygons.ring_starts
    return [
        [polygons.coords[rings[r] : rings[r + 1]] for r in range(int(first), int(last))]
        for first, last in zip(
            polygons.polygon_starts[:-1], polygons.polygon_starts[1:], strict=True
        )
    ]


def geometry_of(polygons: Polygons | None) -> dict[str, Any]:
    """Return a body as a GeoJSON MultiPolygon with exactly the same doubles."""
    shapes = [] if polygons is None else shapes_of(polygons)
    coordinates = [[[*ring.tolist(), ring[0].tolist()] for ring in shape] for shape in shapes]
    return {"type": "MultiPolygon", "coordinates": coordinates}
